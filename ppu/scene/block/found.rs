//! The primitives of a scene's objects.

use std::ops::Range;

use protocol::layout::{MAX_OBJECTS, SIDES_BOTH};
use scenes::{Scene, Shape};

use super::error::BlockError;
use super::memory_use::{MemoryUse, capacity};
use super::objects::{self, Object, sides_seen_from};
use super::primitive::{Primitive, PrimitiveId, PrimitiveKind};
use super::source_location::SourceLocation;
use super::streamed::Streamed;

/// The most primitives of a kind.
const MAX_OF_KIND: usize = MAX_OBJECTS as usize;

/// The primitives that are in local store.
#[derive(Default)]
pub(super) struct Found {
    /// The primitives of each kind.
    pub found: [Vec<Object>; 4],
    /// For each object the range of its primitives in `parts`. There `slot` is an index in `found`.
    pub objects: Vec<Range<usize>>,
    pub parts: Vec<PrimitiveId>,
}

/// What is counted, even above the limit.
#[derive(Default)]
struct Counts<'a> {
    of_kinds: [usize; 4],
    /// The first object that exceeds the limit, and its kind.
    too_many: Option<(SourceLocation<'a>, PrimitiveKind)>,
}

impl Found {
    /// What is in main memory is left out here.
    pub fn of(
        scene: &Scene,
        ray_depth: u32,
        streamed: Option<&Streamed>,
    ) -> Result<Self, BlockError> {
        let in_main_memory = streamed.map(|it| it.kinds).unwrap_or_default();
        let is_streamed = |shape: &Shape| in_main_memory.holds(shape);
        let mut all = Self::default();
        let mut counts = Counts::default();
        let eye = scene.view.from;
        for object in &scene.objects {
            let first = all.parts.len();
            let material = scene.materials.get(object.material as usize);
            if let Some(material) = material.filter(|_| !is_streamed(&object.shape)) {
                let place = SourceLocation { file: &scene.name, line: Some(object.line) };
                let (kind, about) = objects::about(&object.shape);
                // Above the limit, objects are still counted, but not split into triangles, which
                // takes time.
                let count = &mut counts.of_kinds[kind as usize];
                if about > MAX_OF_KIND || *count > MAX_OF_KIND {
                    *count += about;
                    counts.too_many.get_or_insert((place, kind));
                    continue;
                }
                objects::of_shape(&object.shape, material, place, &mut |primitive, sides| {
                    for sides in sides_seen_from(eye, &primitive, sides) {
                        let primitive = primitive.clone();
                        all.add(primitive, sides, object.material, place, &mut counts);
                    }
                    Ok(())
                })?;
            }
            all.objects.push(first..all.parts.len());
        }
        // A mesh in local store: its triangles are no objects of the scene, and come after them.
        let place = SourceLocation { file: &scene.name, line: None };
        for mesh in scene.mesh.iter().filter(|_| streamed.is_none()) {
            for (triangle, &number) in mesh.materials.iter().enumerate() {
                let Some(material) = scene.materials.get(number as usize) else {
                    continue;
                };
                let both = if mesh.two_sided { SIDES_BOTH } else { 0 };
                let shape = mesh.shape(triangle);
                objects::of_shape(&shape, material, place, &mut |primitive, sides| {
                    all.add(primitive, sides | both, number, place, &mut counts);
                    Ok(())
                })?;
            }
        }
        match counts.too_many {
            None => Ok(all),
            Some((place, kind)) => Err(BlockError::TooManyObjects {
                place: place.to_string(),
                what: kind.name(),
                count: counts.of_kinds[kind as usize],
                fits: MemoryUse::of(scene, counts.of_kinds).fits(capacity(1, ray_depth)),
            }),
        }
    }

    /// Counts a primitive, and adds it unless that exceeds the maximum.
    fn add<'a>(
        &mut self,
        primitive: Primitive,
        sides: u32,
        material: u32,
        place: SourceLocation<'a>,
        counts: &mut Counts<'a>,
    ) {
        let kind = primitive.kind();
        counts.of_kinds[kind as usize] += 1;
        let found = &mut self.found[kind as usize];
        if found.len() == MAX_OF_KIND {
            counts.too_many.get_or_insert((place, kind));
            return;
        }
        self.parts.push(PrimitiveId { kind, slot: found.len() });
        found.push(Object { primitive, sides, material });
    }
}
