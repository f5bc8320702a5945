//! Rays find the same triangle in the blocks as among all triangles, in `f64`.

use glam::{DVec3, Vec3};
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use scenes::Mesh;

use super::super::{MeshBlocks, MeshObjects, tree::Bounds};
use super::meshes::{ball, materials, soup};
use super::valid::Parts;
use crate::scene::random::unit;

struct Ray {
    origin: DVec3,
    direction: DVec3,
}

impl Ray {
    /// The distance to a triangle, from both sides.
    fn meets(&self, corners: [Vec3; 3]) -> Option<f64> {
        let [a, b, c] = corners.map(|corner| corner.as_dvec3() - self.origin);
        let normal = (b - a).cross(c - a);
        let volume = |from: DVec3, to: DVec3| from.cross(to).dot(self.direction);
        let shares = [volume(a, b), volume(b, c), volume(c, a)];
        let inside = shares.iter().all(|&it| it >= 0.0) || shares.iter().all(|&it| it <= 0.0);
        let distance = normal.dot(a) / normal.dot(self.direction);
        (inside && distance > 0.0).then_some(distance)
    }

    fn enters(&self, bounds: Bounds, limit: f64) -> bool {
        let low = (bounds.low.as_dvec3() - self.origin) / self.direction;
        let high = (bounds.high.as_dvec3() - self.origin) / self.direction;
        let near = low.min(high).max_element().max(0.0);
        let far = low.max(high).min_element();
        // The quotients are rounded.
        near <= far * (1.0 + 1e-12) && near <= limit * (1.0 + 1e-12)
    }
}

fn nearest(ray: &Ray, blocks: &MeshBlocks, number: u32) -> f64 {
    let parts = Parts::of(blocks, number);
    let mut nodes = vec![(1, 32)];
    let mut best = f64::INFINITY;
    while let Some((level, offset)) = nodes.pop() {
        for (bounds, word) in parts.children(offset) {
            if !ray.enters(bounds, best) {
                continue;
            }
            if level < parts.header.levels.get() {
                nodes.push((level + 1, word));
            } else if parts.is_leaf() {
                let first = word as usize % 65_536 / 4;
                for face in first..first + (word >> 16) as usize {
                    let distance = ray.meets(parts.corners(face));
                    best = best.min(distance.unwrap_or(f64::INFINITY));
                }
            } else {
                best = best.min(nearest(ray, blocks, word));
            }
        }
    }
    best
}

fn compare(mesh: &Mesh, rays: usize, seed: u64) {
    let blocks = MeshBlocks::new(mesh, &MeshObjects::default(), &materials()).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut hits = 0;
    for _ in 0..rays {
        let origin = 2.0 * unit(&mut random) * random.random_range(0.0..1.0);
        let target = unit(&mut random) * random.random_range(0.0..1.0);
        let direction = (target - origin).normalize();
        let ray = Ray { origin, direction };
        let all = (0..mesh.triangles.len()).filter_map(|it| ray.meets(mesh.corners(it)));
        let wanted = all.fold(f64::INFINITY, f64::min);
        assert_eq!(nearest(&ray, &blocks, 0), wanted, "{origin} {direction}");
        hits += usize::from(wanted.is_finite());
    }
    assert!(hits > rays / 4, "{hits} of {rays}");
}

#[test]
fn rays_hit_nearest_triangle() {
    compare(&soup(40, 0.5, 1), 300, 1);
    compare(&soup(2000, 0.1, 2), 300, 2);
    compare(&ball(40), 300, 3);
}
