//! How much local store each part of a scene takes, and how much of the scene would fit.
//!
//! Smaller batches that leave memory for 16 blocks of a mesh instead of 8 find 25 % of them in the
//! cache instead of 9 % in `sphereflake:4`, but make it slower: 4.8 frames a second, not 5.5.

use scenes::{Scene, Shape};

use super::bvh::{self, Volumes};
use super::primitive::{PATCH_SIZE, PrimitiveKind};
use protocol::layout::{
    self, MAX_OBJECTS, QueuedRay, RayPacket, SCENE_CAPACITY, SMALL_BATCH, Shear,
};

/// The number of rays in a packet.
const PACKET: usize = 16;

/// Bytes of the records that every scene has.
const FIXED: usize = size_of::<layout::Object>() + size_of::<layout::Material>();

/// Records of one sort.
struct Consumer {
    what: &'static str,
    count: usize,
    bytes: usize,
}

/// The sorts of records in a scene, the largest first.
pub(super) struct MemoryUse(Vec<Consumer>);

impl MemoryUse {
    /// `objects` has for each kind the number of primitives, and the bytes of them and their tree.
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
        let others =
            others.map(|(what, count, size)| Consumer { what, count, bytes: count * size });
        let mut consumers: Vec<Consumer> = objects.into_iter().chain(others).collect();
        consumers.retain(|consumer| consumer.count > 0);
        consumers.sort_by_key(|consumer| std::cmp::Reverse(consumer.bytes));
        Self(consumers)
    }

    /// An estimate for a scene with `counts` primitives of each kind.
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
            (count, count * sizes[kind as usize] + bvh::size(count, Volumes::Spheres))
        });
        let materials = is_used.iter().filter(|&&is_used| is_used).count();
        Self::new(objects, materials, scene.lights.len())
    }

    /// A text that lists the sorts with their bytes.
    pub fn consumers(&self) -> String {
        let consumer = |&Consumer { what, count, bytes }: &Consumer| match count {
            1 => format!("1 {} {bytes}", what.trim_end_matches('s')),
            _ => format!("{count} {what} {bytes}"),
        };
        self.0.iter().map(consumer).collect::<Vec<_>>().join(", ")
    }

    /// A text that estimates how much fits into `capacity` bytes: how many records of the largest
    /// sort, if all others are kept, or what part of the scene, if the others don't fit alone.
    pub fn fits(&self, capacity: usize) -> String {
        let needed = FIXED + self.0.iter().map(|consumer| consumer.bytes).sum::<usize>();
        match self.0.first() {
            Some(most) if needed - most.bytes < capacity => {
                let Consumer { what, count, bytes } = *most;
                let fit = (capacity - (needed - bytes)) * count / bytes;
                // A tree holds no more, and more materials take more than there is.
                let fit = fit.min(count).min(MAX_OBJECTS as usize);
                format!("about {fit} of its {count} {what} fit")
            }
            _ => format!("about {} % of the scene fits", capacity * 100 / needed),
        }
    }
}

/// The bytes that the queue of rays leaves for a scene.
pub(super) fn capacity(batch: u32, ray_depth: u32) -> usize {
    (SCENE_CAPACITY as usize).saturating_sub(queue_bytes(batch, ray_depth))
}

/// The bytes of the queue of rays in local store: three batches, if chains have more than one ray.
pub(super) fn queue_bytes(batch: u32, ray_depth: u32) -> usize {
    let batches = if ray_depth > 1 { 3 } else { 0 };
    PACKET * size_of::<QueuedRay>() * (batch * batches) as usize
}

/// The bytes of a batch's buffers that are not in the arena: the rays and, if there are triangles,
/// the shears of its packets.
pub(super) fn large_batch_bytes(batch: u32, has_triangles: bool) -> usize {
    if batch <= SMALL_BATCH {
        return 0;
    }
    let shears = if has_triangles { size_of::<Shear>() } else { 0 };
    (2 * size_of::<RayPacket>() + shears) * batch as usize
}
