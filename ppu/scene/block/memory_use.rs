//! What of a scene takes the local store's room, and how much of it would fit.

use nff::{Scene, Shape};

use super::bvh;
use super::primitive::{PATCH_SIZE, PrimitiveKind};
use protocol::layout;

/// Bytes of what every scene has.
const FIXED: usize = size_of::<layout::Object>() + size_of::<layout::Material>();

/// Things of one sort.
struct Consumer {
    what: &'static str,
    count: usize,
    bytes: usize,
}

/// All that takes room, the largest first.
pub(super) struct MemoryUse(Vec<Consumer>);

impl MemoryUse {
    /// Of objects of each kind with their trees, each with a count and bytes, and of materials and
    /// lights.
    pub fn new(objects: [(usize, usize); 4], materials: usize, lights: usize) -> Self {
        let objects = PrimitiveKind::ALL.map(|kind| {
            let (count, bytes) = objects[kind as usize];
            let what = kind.name();
            Consumer { what, count, bytes }
        });
        let others = [
            ("materials", materials, size_of::<layout::Material>()),
            ("lights", lights, size_of::<layout::Light>()),
        ];
        let others = others.map(|(what, count, size)| Consumer {
            what,
            count,
            bytes: count * size,
        });
        let mut consumers: Vec<Consumer> = objects.into_iter().chain(others).collect();
        consumers.retain(|consumer| consumer.count > 0);
        consumers.sort_by_key(|consumer| std::cmp::Reverse(consumer.bytes));
        Self(consumers)
    }

    /// About that of a scene of so many objects of each kind.
    pub fn of(scene: &Scene, counts: [usize; 4]) -> Self {
        let mut sizes = PrimitiveKind::ALL.map(PrimitiveKind::least_size);
        let mut is_used = vec![false; scene.materials.len()];
        for object in &scene.objects {
            if matches!(object.shape, Shape::Patch { .. }) {
                sizes[PrimitiveKind::Triangle as usize] = PATCH_SIZE;
            }
            if let Some(is_used) = is_used.get_mut(object.material as usize) {
                *is_used = true;
            }
        }
        let objects = PrimitiveKind::ALL.map(|kind| {
            let count = counts[kind as usize];
            (count, count * sizes[kind as usize] + bvh::size(count))
        });
        let materials = is_used.iter().filter(|&&is_used| is_used).count();
        Self::new(objects, materials, scene.lights.len())
    }

    /// What takes how many bytes, in words.
    pub fn consumers(&self) -> String {
        let consumer = |&Consumer { what, count, bytes }: &Consumer| match count {
            1 => format!("1 {} {bytes}", what.trim_end_matches('s')),
            _ => format!("{count} {what} {bytes}"),
        };
        self.0.iter().map(consumer).collect::<Vec<_>>().join(", ")
    }

    /// About how much fits into so many bytes, in words: of what takes most, if the rest stays; if
    /// the rest does not fit alone, of all.
    pub fn fits(&self, room: usize) -> String {
        let needed = FIXED + self.0.iter().map(|consumer| consumer.bytes).sum::<usize>();
        match self.0.first() {
            Some(most) if needed - most.bytes < room => {
                let Consumer { what, count, bytes } = *most;
                let fit = (room - (needed - bytes)) * count / bytes;
                format!("about {} of its {count} {what} fit", fit.min(count))
            }
            _ => format!("about {} % of all that fits", room * 100 / needed),
        }
    }
}
