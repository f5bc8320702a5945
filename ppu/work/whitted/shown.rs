//! What a picture by Whitted's model was made of, and where another differs from it.
//!
//! An eye ray sees what it hits, and whether that is in the shadow of anything. So if an object has changed, the
//! picture has where the object is seen or was, and where its shadow falls or fell. What is seen in mirrors, in
//! glass and by a game's own shaders may be anywhere: where one is, everything that changes shows.
//!
//! Invariant: pixels that are not among the answer are the same in both pictures, unless two surfaces
//! are equally far from the eye to the bit: then either may be hit in either picture.

use glam::DVec3;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::ball::{Ball, Hull};
use super::chains::Chains;
use super::materials::Light;
use super::shadow::Shadow;
use super::tree::widened;
use super::{BlockOptions, SceneBlock};
use crate::work::lens::{Lens, Rectangle};
use crate::work::tiles::TileSet;
use protocol::layout::{self, SCENE_ADDRESS};

/// Most pairs of an object that has changed and one that its shadow may fall on: the whole picture is traced in less
/// time than more are looked at.
const MOST_SHADOWS: usize = 4096;

/// An object of a picture.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// What it is within, widened for the SPU's rounding.
    ball: Ball,
    /// The same closer: it is straight between these.
    hull: Hull,
    /// A point of the plane that it lies in, and the plane's normal.
    plane: Option<(DVec3, DVec3)>,
    /// Address and size of its record, address of its material's.
    record: (u32, usize),
    material: u32,
    /// Whether others may be seen in it.
    sees_others: bool,
    /// Whether it is shaded beside where it is seen.
    is_bent: bool,
}

/// What a picture was made of; its buffers serve for the next.
#[derive(Default)]
pub(crate) struct Shown {
    options: Option<BlockOptions>,
    chains: Option<Chains>,
    ambient: [F32; 4],
    lights: Vec<Light>,
    /// The objects by their plots, kind after kind.
    objects: Vec<Option<Seen>>,
    /// Where the plots are.
    addresses: Vec<u32>,
    bytes: Vec<u8>,
}

/// In which way an object of two pictures differs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Change {
    None,
    /// It looks otherwise.
    Look,
    /// It is elsewhere, of another shape, or not in both.
    Place,
}

impl Seen {
    /// Pixels on which it may be seen.
    fn bounds(&self, lens: &Lens) -> Rectangle {
        let balls = self.hull.balls().iter();
        lens.hull(balls.map(|&ball| {
            let Ball { centre, radius } = widened(lens.eye(), ball);
            (centre, radius)
        }))
    }
}

impl Shown {
    /// Takes down what a block that was written for this eye shows; nothing without one.
    pub fn take(&mut self, block: Option<&SceneBlock>, eye: DVec3) {
        self.options = block.map(|block| block.options);
        self.chains = block.map(|block| block.chains);
        self.ambient = Default::default();
        self.lights.clear();
        self.objects.clear();
        self.addresses.clear();
        self.bytes.clear();
        let Some(block) = block else { return };
        self.ambient = block.ambient;
        self.lights.extend_from_slice(&block.lights);
        self.bytes.extend_from_slice(block.bytes());
        for planted in &block.planted {
            for plot in 0..planted.plot_count() {
                let (address, object) = planted.plot(plot);
                self.addresses.push(address);
                self.objects.push(object.map(|(object, material, ball)| {
                    let surface = block.materials.get(object.material as usize);
                    Seen {
                        ball: widened(eye, ball),
                        hull: object.form.hull(),
                        plane: object.form.plane(),
                        is_bent: object.form.is_bent(),
                        record: (address, object.form.size()),
                        material: material.get(),
                        sees_others: surface
                            .and_then(|surface| *surface)
                            .is_none_or(|surface| surface.sends.goes_on()),
                    }
                }));
            }
        }
    }

    /// Adds the tiles in which `self` differs from `before`, both of them seen through `lens`; all of them where the
    /// two are made of different things altogether.
    pub fn changes(&self, before: &Self, shadows: bool, lens: &Lens, changed: &mut TileSet) {
        if self.options != before.options
            || self.addresses != before.addresses
            || self.ambient.as_bytes() != before.ambient.as_bytes()
            || !self.lights_as(before)
            || !self.same_background(before)
        {
            return changed.add_all();
        }
        let mut pairs = 0;
        // Where chains end otherwise, what goes on looks otherwise.
        let mut any = self.chains != before.chains;
        for (new, old) in self.objects.iter().zip(&before.objects) {
            let change = self.change(new.as_ref(), before, old.as_ref());
            if change == Change::None {
                continue;
            }
            any = true;
            for (seen, all) in [(old, before), (new, self)] {
                let Some(seen) = seen else { continue };
                changed.add(&seen.bounds(lens));
                if change == Change::Place && shadows {
                    pairs += self.lights.len() * self.objects.len();
                    if pairs > MOST_SHADOWS || !all.shadows(seen, lens, changed) {
                        return changed.add_all();
                    }
                }
            }
        }
        if any && self.options.is_some_and(|options| options.ray_depth > 1) {
            for seen in self
                .objects
                .iter()
                .flatten()
                .filter(|seen| seen.sees_others)
            {
                changed.add(&seen.bounds(lens));
            }
        }
    }

    fn lights_as(&self, other: &Self) -> bool {
        let mut pairs = self.lights.iter().zip(&other.lights);
        self.lights.len() == other.lights.len() && pairs.all(|(a, b)| a.lights_as(b))
    }

    fn same_background(&self, other: &Self) -> bool {
        let size = size_of::<layout::Object>() + size_of::<layout::Material>();
        self.record(SCENE_ADDRESS, size) == other.record(SCENE_ADDRESS, size)
    }

    fn record(&self, address: u32, size: usize) -> &[u8] {
        let start = (address - SCENE_ADDRESS) as usize;
        self.bytes.get(start..start + size).unwrap_or_default()
    }

    fn change(&self, new: Option<&Seen>, before: &Self, old: Option<&Seen>) -> Change {
        let (Some(new), Some(old)) = (new, old) else {
            return if new.is_none() && old.is_none() {
                Change::None
            } else {
                Change::Place
            };
        };
        let (address, size) = new.record;
        if new.record != old.record
            || !same_form(self.record(address, size), before.record(address, size))
        {
            return Change::Place;
        }
        let size = size_of::<layout::Material>();
        let same_material = self.record(new.material, size) == before.record(old.material, size);
        if same_material && new.sees_others == old.sees_others {
            Change::None
        } else {
            Change::Look
        }
    }

    /// Adds the tiles that the shadows of an object fall on; `false` if there is no saying which.
    fn shadows(&self, seen: &Seen, lens: &Lens, changed: &mut TileSet) -> bool {
        for light in &self.lights {
            let Some(shadow) = Shadow::of(seen.ball, light.kind(), lens) else {
                return false;
            };
            for on in self.objects.iter().flatten() {
                if on.is_bent {
                    changed.add(&on.bounds(lens));
                    continue;
                }
                // Most objects are out of the shadow's way: theirs are not asked for.
                let mut bounds = None;
                shadow.on(on.ball, on.plane, lens, &mut |pixels: &Rectangle| {
                    let bounds = bounds.get_or_insert_with(|| on.bounds(lens));
                    changed.add(&pixels.intersection(bounds));
                });
            }
        }
        true
    }
}

/// Whether two records are of the same surface, whatever it is made of.
fn same_form(one: &[u8], other: &[u8]) -> bool {
    let material = std::mem::offset_of!(layout::Object, material);
    let behind = material + size_of::<u32>();
    one.len() == other.len()
        && one.len() >= behind
        && one[..material] == other[..material]
        && one[behind..] == other[behind..]
}
