//! Which object or mesh a ray meets first, computed on the PPU in `f64`: what is under the pointer,
//! or in a shot's way.
//!
//! Invariant: only sums, products, square roots and `libm` are used, so that a recorded session
//! finds the same objects on every machine.

use glam::{DVec2, DVec3};
use scenes::{Shape, unit};

use super::content::Object;
use super::{MaterialId, MeshId, ObjectId, World};

/// What has the surface that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// An object.
    Object(ObjectId),
    /// A triangle of a mesh, by its index in [`Mesh::triangles`](crate::game::Mesh).
    Mesh(MeshId, usize),
}

impl Target {
    /// The object, unless it is a mesh.
    #[must_use]
    pub fn object(self) -> Option<ObjectId> {
        match self {
            Self::Object(id) => Some(id),
            Self::Mesh(..) => None,
        }
    }
}

/// The surface that a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The object or the mesh.
    pub target: Target,
    /// Distance from the ray's origin.
    pub distance: f64,
    /// The point on the surface.
    pub point: DVec3,
    /// The unit normal, on the side that the ray comes from.
    pub normal: DVec3,
}

/// A ray. Its direction is a unit vector, except in the coordinates of a mesh.
pub(super) struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
}

/// Where a ray crosses a surface: the distance, and the surface's own normal, of any length.
pub(super) type Crossing = (f64, DVec3);

impl World {
    /// The visible object or mesh under a pixel of a picture of this size, such as
    /// [`Frame::size`](crate::game::Frame::size), and where it is met. The pixel's coordinates are
    /// from the top left, as the mouse's position; its centre is at whole numbers.
    ///
    /// `None` if there is only background, or if the pixel or the size is not in range.
    #[must_use]
    pub fn pick(&self, pixel: [f32; 2], size: (u32, u32)) -> Option<Pick> {
        let camera = self.view.camera(size.0, size.1).ok()?;
        let [x, y] = pixel.map(f64::from);
        let direction = camera.corner + x * camera.right + y * camera.down;
        self.cast_ray(camera.eye, direction)
    }

    /// The pixel of a picture of this size at which a point is seen, or would be if nothing hid it.
    /// It may lie outside of the picture. The inverse of [`World::pick`].
    ///
    /// `None` if the point is not before the eye, or if the size is not in range.
    #[must_use]
    pub fn project(&self, point: impl Into<DVec3>, size: (u32, u32)) -> Option<[f32; 2]> {
        let camera = self.view.camera(size.0, size.1).ok()?;
        let to_middle = [size.0, size.1].map(|side| f64::from(side - 1) / 2.0);
        let sight = unit(self.view.at - self.view.from)?;
        let away = point.into() - camera.eye;
        let depth = away.dot(sight);
        let along = |step: DVec3, middle: f64| {
            let steps = away.dot(step) / (step.length_squared() * depth);
            (steps + middle) as f32
        };
        let pixel = [along(camera.right, to_middle[0]), along(camera.down, to_middle[1])];
        (depth > 0.0 && pixel.iter().all(|at| at.is_finite())).then_some(pixel)
    }

    /// The visible object or mesh that a ray meets first. The direction may have any length but 0.
    ///
    /// Surfaces are met where Whitted's model shows them: an opaque polygon or sphere from its
    /// front, glass and meshes with `two_sided` from both sides. Patches are met as flat polygons.
    /// Each call tests all objects, and all triangles of the meshes whose boxes the ray meets.
    #[must_use]
    pub fn cast_ray(&self, origin: impl Into<DVec3>, direction: impl Into<DVec3>) -> Option<Pick> {
        let ray = Ray { origin: origin.into(), direction: unit(direction.into())? };
        let visible = self.objects.iter().filter(|(_, object)| object.visible);
        let objects = visible.filter_map(|(id, object)| {
            let crossing = ray.meet(object, self.is_transparent(object.material))?;
            Some((Target::Object(id), crossing))
        });
        let met = objects.chain(self.meshes_met(&ray));
        let met = met.filter_map(|(target, (distance, normal))| {
            let normal = unit(normal)?;
            Some(Pick {
                target,
                distance,
                point: ray.origin + distance * ray.direction,
                normal: if normal.dot(ray.direction) > 0.0 { -normal } else { normal },
            })
        });
        met.min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// Whether a material transmits light, so that its surfaces are seen from both sides.
    pub(super) fn is_transparent(&self, material: MaterialId) -> bool {
        let entry = self.materials.get(material);
        entry.is_some_and(|entry| entry.material.transmittance > 0.0)
    }
}

impl Ray {
    /// The nearest crossing with an object's surface from a side that is visible.
    fn meet(&self, object: &Object, is_transparent: bool) -> Option<Crossing> {
        match &object.shape {
            &Shape::Sphere { centre, radius } => {
                let crossings = self.sphere(centre, radius.abs())?;
                let sign = radius.signum();
                self.nearest(crossings.map(|(t, normal)| (t, sign * normal)), is_transparent)
            }
            &Shape::Cone { base, base_radius, apex, apex_radius } => {
                let radii = [base_radius, apex_radius].map(f64::abs);
                let crossings = self.cone(base, apex, radii)?;
                let is_hollow = base_radius.max(apex_radius) <= 0.0;
                let sign = if is_hollow { -1.0 } else { 1.0 };
                // Without caps, the inside shows where the outside does.
                self.nearest(
                    crossings.map(|(t, normal)| (t, sign * normal)),
                    is_transparent || !is_hollow,
                )
            }
            Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
                self.nearest([self.polygon(vertices)?], is_transparent)
            }
        }
    }

    /// The nearest of some crossings ahead, with a normal against the ray or `both_sides`.
    fn nearest<const COUNT: usize>(
        &self,
        crossings: [Crossing; COUNT],
        both_sides: bool,
    ) -> Option<Crossing> {
        crossings
            .into_iter()
            .filter(|(t, normal)| *t > 0.0 && (both_sides || normal.dot(self.direction) < 0.0))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Whether the ray meets a box ahead.
    pub fn meets_box(&self, low: DVec3, high: DVec3) -> bool {
        let (mut enters, mut leaves) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            let (origin, direction) = (self.origin[axis], self.direction[axis]);
            if direction == 0.0 {
                if !(low[axis]..=high[axis]).contains(&origin) {
                    return false;
                }
                continue;
            }
            let at = [low[axis], high[axis]].map(|side| (side - origin) / direction);
            enters = enters.max(at[0].min(at[1]));
            leaves = leaves.min(at[0].max(at[1]));
        }
        // The numbers are rounded, and a flat mesh has a box without depth.
        enters <= leaves * (1.0 + 1e-9)
    }

    /// The crossing with a triangle ahead, by Möller and Trumbore, from its front or `both_sides`.
    pub fn triangle(&self, [a, b, c]: [DVec3; 3], both_sides: bool) -> Option<Crossing> {
        let (ab, ac) = (b - a, c - a);
        let across = self.direction.cross(ac);
        let volume = ab.dot(across);
        if volume == 0.0 || (volume < 0.0 && !both_sides) {
            return None;
        }
        let from_a = self.origin - a;
        let u = from_a.dot(across) / volume;
        let around = from_a.cross(ab);
        let v = self.direction.dot(around) / volume;
        let t = ac.dot(around) / volume;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then(|| (t, ab.cross(ac)))
    }

    fn sphere(&self, centre: DVec3, radius: f64) -> Option<[Crossing; 2]> {
        let to_centre = centre - self.origin;
        let along = to_centre.dot(self.direction);
        let beside = (to_centre - along * self.direction).length();
        if beside > radius {
            return None;
        }
        let half = ((radius - beside) * (radius + beside)).sqrt();
        let crossing = |t: f64| (t, t * self.direction - to_centre);
        Some([crossing(along - half), crossing(along + half)])
    }

    /// Both crossings with a cone or cylinder without caps; one beyond its ends is at NaN, which
    /// is not ahead.
    fn cone(&self, base: DVec3, apex: DVec3, radii: [f64; 2]) -> Option<[Crossing; 2]> {
        let axis = unit(apex - base)?;
        let height = (apex - base).dot(axis);
        let growth = (radii[1] - radii[0]) / height;
        let split = |vector: DVec3| {
            let along = vector.dot(axis);
            (along, vector - along * axis)
        };
        let (rise, across) = split(self.direction);
        let (start, beside) = split(self.origin - base);
        let (radius, widening) = (radii[0] + growth * start, growth * rise);
        // |beside + t across|^2 = (radius + t widening)^2
        let a = across.length_squared() - widening * widening;
        let b = across.dot(beside) - widening * radius;
        let c = beside.length_squared() - radius * radius;
        let root = (b * b - a * c).sqrt();
        // The root that doesn't cancel; the other one is the product of both over it.
        let far = -b - root.copysign(b);
        let crossing = |t: f64| {
            let (above, outward) = split(self.origin + t * self.direction - base);
            if (0.0..=height).contains(&above) {
                let normal = outward - growth * outward.length() * axis;
                (t, normal)
            } else {
                (f64::NAN, axis)
            }
        };
        (root >= 0.0).then(|| [crossing(far / a), crossing(c / far)])
    }

    fn polygon(&self, vertices: &[DVec3]) -> Option<Crossing> {
        let next = |number: usize| vertices[(number + 1) % vertices.len()];
        let first = *vertices.first()?;
        // Newell's normal, which is right for concave polygons, too.
        let area = (0..vertices.len())
            .map(|number| (vertices[number] - first).cross(next(number) - first))
            .sum::<DVec3>();
        let normal = unit(area)?;
        let t = (first - self.origin).dot(normal) / self.direction.dot(normal);
        let point = self.origin + t * self.direction;
        // The plane of the two axes that the polygon is widest in.
        let flat = match normal.abs().max_position() {
            0 => |p: DVec3| DVec2::new(p.y, p.z),
            1 => |p: DVec3| DVec2::new(p.z, p.x),
            _ => |p: DVec3| DVec2::new(p.x, p.y),
        };
        let at = flat(point);
        let crosses = |number: &usize| {
            let (a, b) = (flat(vertices[*number]) - at, flat(next(*number)) - at);
            (a.y > 0.0) != (b.y > 0.0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0.0
        };
        let is_inside = (0..vertices.len()).filter(crosses).count() % 2 == 1;
        (t.is_finite() && is_inside).then_some((t, normal))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;
    use std::sync::Arc;

    use glam::{DAffine3, DMat3};
    use rand::{Rng as _, SeedableRng as _};
    use rand_chacha::ChaCha8Rng;
    use scenes::{Mesh, Scene};

    use super::*;
    use crate::game::Material;
    use crate::scene::RenderOptions;

    const SIZE: (u32, u32) = (64, 48);

    fn world() -> World {
        let mut world = World::new();
        world.look_from([0.0, 0.0, 10.0], [0.0; 3]).unwrap();
        world
    }

    #[test]
    fn nearest_object_under_pixel_is_found() {
        let mut world = world();
        let red = world.add_material(Material::matte(1.0, 0.0, 0.0)).unwrap();
        let farther = world.add_sphere([0.0, 0.0, -3.0], 2.0, red).unwrap();
        let middle = [31.5, 23.5];
        let found = world.pick(middle, SIZE).unwrap();
        assert_eq!((found.target, found.distance), (Target::Object(farther), 11.0));
        assert_eq!((found.point, found.normal), (DVec3::NEG_Z, DVec3::Z));
        let before = world.add_sphere([0.0; 3], 1.0, red).unwrap();
        assert_eq!(world.pick(middle, SIZE).unwrap().target, Target::Object(before));
        world.show(before, false).unwrap();
        assert_eq!(world.pick(middle, SIZE).unwrap().target, Target::Object(farther));
        assert_eq!(world.pick([0.0, 0.0], SIZE), None);
        assert_eq!(world.pick(middle, (0, 0)), None);
        assert_eq!(world.cast_ray([0.0; 3], [0.0; 3]), None);
        assert_eq!(world.pick([f32::NAN, 0.0], SIZE), None);
    }

    #[test]
    fn picking_hits_visible_sides_only() {
        let mut world = world();
        let red = world.add_material(Material::matte(1.0, 0.0, 0.0)).unwrap();
        let glass = world.add_material(Material::glass()).unwrap();
        let square = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
        let wall = world.add_polygon(&square, red).unwrap();
        let ahead = |world: &World| world.cast_ray([0.2, 0.3, 5.0], [0.0, 0.0, -2.0]);
        let back = |world: &World| world.cast_ray([0.2, 0.3, -5.0], [0.0, 0.0, 2.0]);
        assert_eq!(ahead(&world).unwrap().distance, 5.0);
        assert_eq!(back(&world), None);
        world.make_of(wall, glass).unwrap();
        assert_eq!(back(&world).unwrap().normal, DVec3::NEG_Z);
        assert_eq!(world.cast_ray([1.5, 0.0, 5.0], [0.0, 0.0, -1.0]), None);
        world.remove(wall).unwrap();
        let enclosing = world.add_sphere([0.0; 3], -4.0, red).unwrap();
        assert_eq!(ahead(&world).unwrap().distance, 5.0 + (16.0_f64 - 0.13).sqrt());
        assert_eq!(ahead(&world).unwrap().target, Target::Object(enclosing));
    }

    /// The reference tracer shows a flat colour exactly where an object is picked.
    #[test]
    fn picked_pixels_equal_the_reference() {
        let mut random = ChaCha8Rng::seed_from_u64(7);
        let mut text = String::from(
            "v\nfrom 0 0 10\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 64 48\nb 0 0 0\n\
             l 0 0 10 1 1 1\n",
        );
        for number in 0..12 {
            let mut n = || random.random_range(-3.0..3.0_f64);
            let (a, b, c) = ([n(), n(), n()], [n(), n(), n()], [n(), n(), n()]);
            let p = |[x, y, z]: [f64; 3]| format!("{x} {y} {z}");
            text += &format!("f {} 0 0 1 0 0 0 1\n", f64::from(number + 1) / 16.0);
            text += "#cellray shader flat\n";
            text += &match number % 4 {
                0 => format!("s {} 0.8\n", p(a)),
                1 => format!("c\n{} 0.7\n{} 0.2\n", p(a), p(b)),
                2 => format!("p 3\n{}\n{}\n{}\n", p(a), p(b), p(c)),
                _ => format!("c\n{} 0.4\n{} 0.4\n", p(a), p(b)),
            };
        }
        let scene = scenes::parse(text.as_bytes(), "picked", &scenes::Limits::default()).unwrap();
        let (picture, world) = (reference(&scene), world_of(&scene));
        let mut differ = 0;
        for (place, pixel) in (0..).zip(picture.pixels()) {
            let (x, y) = (place % SIZE.0, place / SIZE.0);
            let found = world.pick([x as f32, y as f32], SIZE);
            let colour = found.map_or(0.0, |found| {
                let object = found.target.object().unwrap();
                let material = world.material_of(object).unwrap();
                world.material(material).unwrap().colour.x
            });
            let shown = (colour * 255.0).round() as i32;
            differ += u32::from((shown - i32::from(pixel[0])).abs() > 1);
        }
        assert!(differ <= 3, "{differ} pixels differ");
    }

    /// Meshes are met where a game draws them: each triangle alone, as a polygon in the world's
    /// coordinates, is met at the same point.
    #[test]
    fn picking_hits_meshes_at_their_positions() {
        let mut random = ChaCha8Rng::seed_from_u64(8);
        let mut found = [0; 2];
        for turn in 0..40 {
            let mut n = || random.random_range(-1.0..1.0_f64);
            let mesh = Arc::new(Mesh {
                positions: (0..60).map(|_| [n() as f32, n() as f32, n() as f32]).collect(),
                triangles: (0..20).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect(),
                materials: vec![0; 20],
                two_sided: turn % 3 == 0,
                ..Mesh::default()
            });
            let matrix = DMat3::from_cols_array(&std::array::from_fn(|_| n()));
            let place = DAffine3::from_mat3_translation(matrix, DVec3::new(n(), n(), n()));
            let mirrored = matrix.determinant() < 0.0;
            let (mut world, mut flat) = (world(), world());
            let red = Material::matte(1.0, 0.0, 0.0);
            let material = [&mut world, &mut flat].map(|it| it.add_material(red.clone()).unwrap());
            let sphere = world.add_sphere([0.0, 0.0, -4.0], 1.0, material[0]).unwrap();
            let id = world.add_mesh(mesh.clone(), &material[..1], place).unwrap();
            let mut numbers = HashMap::new();
            for number in 0..20 {
                let [a, b, c] =
                    mesh.corners(number).map(|it| place.transform_point3(it.as_dvec3()));
                let sides = [[a, b, c], [a, c, b]];
                for (side, corners) in sides.into_iter().enumerate() {
                    if mesh.two_sided || (side == 1) == mirrored {
                        let polygon = flat.add_polygon(&corners, material[1]).unwrap();
                        numbers.insert(polygon, number);
                    }
                }
            }
            for _ in 0..200 {
                let origin = DVec3::new(3.0 * n(), 3.0 * n(), 3.0);
                let direction = DVec3::new(n(), n(), n()) - origin;
                let expected = flat.cast_ray(origin, direction);
                let met = world.cast_ray(origin, direction);
                let Some(expected) = expected else {
                    let rest = met.map(|met| met.target);
                    assert!(rest.is_none_or(|it| it == Target::Object(sphere)), "{rest:?}");
                    found[0] += 1;
                    continue;
                };
                let met = met.unwrap();
                if met.target == Target::Object(sphere) {
                    assert!(met.distance < expected.distance);
                    continue;
                }
                let number = numbers[&expected.target.object().unwrap()];
                assert_eq!(met.target, Target::Mesh(id, number));
                assert!((met.distance - expected.distance).abs() < 1e-9);
                assert!((met.normal - expected.normal).length() < 1e-6, "{met:?} {expected:?}");
                found[1] += 1;
            }
            world.show_mesh(id, false).unwrap();
            let hidden = world.cast_ray(place.translation + DVec3::Z, DVec3::NEG_Z);
            assert!(hidden.is_none_or(|met| met.target == Target::Object(sphere)));
        }
        assert!(found.iter().all(|&count| count > 500), "{found:?}");
    }

    fn reference(scene: &Scene) -> oracle::Picture {
        let options = oracle::whitted::Options::default();
        let traced = oracle::whitted::trace(scene, SIZE.0, SIZE.1, &options).unwrap();
        traced.0.picture
    }

    fn world_of(scene: &Scene) -> World {
        World::from_nff(scene, RenderOptions::default()).unwrap()
    }
}
