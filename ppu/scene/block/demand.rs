//! What of a scene takes the local store's room, and how much of it would fit.

use nff::{Scene, Shape};

use super::form::{Kind, PATCH_SIZE};
use super::tree;
use protocol::layout;

/// Bytes of what every scene has.
const FIXED: usize = size_of::<layout::Object>() + size_of::<layout::Material>();

/// Things of one sort.
struct Taker {
    what: &'static str,
    count: usize,
    bytes: usize,
}

/// All that takes room, the largest first.
pub(super) struct Demand(Vec<Taker>);

impl Demand {
    /// Of objects of each kind with their trees, each with a count and bytes, and of materials and
    /// lights.
    pub fn new(objects: [(usize, usize); 4], materials: usize, lights: usize) -> Self {
        let objects = Kind::ALL.map(|kind| {
            let (count, bytes) = objects[kind as usize];
            let what = kind.name();
            Taker { what, count, bytes }
        });
        let others = [
            ("materials", materials, size_of::<layout::Material>()),
            ("lights", lights, size_of::<layout::Light>()),
        ];
        let others = others.map(|(what, count, size)| Taker {
            what,
            count,
            bytes: count * size,
        });
        let mut takers: Vec<Taker> = objects.into_iter().chain(others).collect();
        takers.retain(|taker| taker.count > 0);
        takers.sort_by_key(|taker| std::cmp::Reverse(taker.bytes));
        Self(takers)
    }

    /// About that of a scene of so many objects of each kind.
    pub fn of(scene: &Scene, counts: [usize; 4]) -> Self {
        let mut sizes = Kind::ALL.map(Kind::least_size);
        let mut is_used = vec![false; scene.materials.len()];
        for object in &scene.objects {
            if matches!(object.shape, Shape::Patch { .. }) {
                sizes[Kind::Triangle as usize] = PATCH_SIZE;
            }
            if let Some(is_used) = is_used.get_mut(object.material as usize) {
                *is_used = true;
            }
        }
        let objects = Kind::ALL.map(|kind| {
            let count = counts[kind as usize];
            (count, count * sizes[kind as usize] + tree::size(count))
        });
        let materials = is_used.iter().filter(|&&is_used| is_used).count();
        Self::new(objects, materials, scene.lights.len())
    }

    /// What takes how many bytes, in words.
    pub fn takers(&self) -> String {
        let taker = |&Taker { what, count, bytes }: &Taker| match count {
            1 => format!("1 {} {bytes}", what.trim_end_matches('s')),
            _ => format!("{count} {what} {bytes}"),
        };
        self.0.iter().map(taker).collect::<Vec<_>>().join(", ")
    }

    /// About how much fits into so many bytes, in words: of what takes most, if the rest stays; if
    /// the rest does not fit alone, of all.
    pub fn fits(&self, room: usize) -> String {
        let needed = FIXED + self.0.iter().map(|taker| taker.bytes).sum::<usize>();
        match self.0.first() {
            Some(most) if needed - most.bytes < room => {
                let Taker { what, count, bytes } = *most;
                let fit = (room - (needed - bytes)) * count / bytes;
                format!("about {} of its {count} {what} fit", fit.min(count))
            }
            _ => format!("about {} % of all that fits", room * 100 / needed),
        }
    }
}
