//! Which object a ray meets first, computed on the PPU in `f64`: what is under the pointer, or in
//! a shot's way.
//!
//! Invariant: only sums, products, square roots and `libm` are used, so that a recorded session
//! finds the same objects on every machine.

use glam::{DVec2, DVec3};
use nff::{Shape, unit};

use super::content::Object;
use super::{ObjectId, World};

/// The surface that a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The object.
    pub object: ObjectId,
    /// Distance from the ray's origin.
    pub distance: f64,
    /// The point on the surface.
    pub point: DVec3,
    /// The unit normal, on the side that the ray comes from.
    pub normal: DVec3,
}

/// A ray with a unit direction.
struct Ray {
    origin: DVec3,
    direction: DVec3,
}

/// Where a ray crosses a surface: the distance, and the surface's own normal, of any length.
type Crossing = (f64, DVec3);

impl World {
    /// The visible object under a pixel of a picture of this size, such as
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

    /// The visible object that a ray meets first. The direction may have any length but 0.
    ///
    /// Surfaces are met where the picture shows them: an opaque polygon or sphere from its front,
    /// glass from both sides. Patches are met as flat polygons. Each call tests all objects.
    #[must_use]
    pub fn cast_ray(&self, origin: impl Into<DVec3>, direction: impl Into<DVec3>) -> Option<Pick> {
        let ray = Ray {
            origin: origin.into(),
            direction: unit(direction.into())?,
        };
        let visible = self.objects.iter().filter(|(_, object)| object.visible);
        let met = visible.filter_map(|(id, object)| {
            let (distance, normal) = ray.meet(object, self.is_transparent(object))?;
            let normal = unit(normal)?;
            Some(Pick {
                object: id,
                distance,
                point: ray.origin + distance * ray.direction,
                normal: if normal.dot(ray.direction) > 0.0 {
                    -normal
                } else {
                    normal
                },
            })
        });
        met.min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    fn is_transparent(&self, object: &Object) -> bool {
        let entry = self.materials.get(object.material);
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
                self.nearest(
                    crossings.map(|(t, normal)| (t, sign * normal)),
                    is_transparent,
                )
            }
            &Shape::Cone {
                base,
                base_radius,
                apex,
                apex_radius,
            } => {
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
    use nff::Scene;
    use rand::{Rng as _, SeedableRng as _};
    use rand_chacha::ChaCha8Rng;

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
    fn the_nearest_object_under_a_pixel_is_found() {
        let mut world = world();
        let red = world.add_material(Material::matte(1.0, 0.0, 0.0)).unwrap();
        let behind = world.add_sphere([0.0, 0.0, -3.0], 2.0, red).unwrap();
        let middle = [31.5, 23.5];
        let found = world.pick(middle, SIZE).unwrap();
        assert_eq!((found.object, found.distance), (behind, 11.0));
        assert_eq!((found.point, found.normal), (DVec3::NEG_Z, DVec3::Z));
        let before = world.add_sphere([0.0; 3], 1.0, red).unwrap();
        assert_eq!(world.pick(middle, SIZE).unwrap().object, before);
        world.show(before, false).unwrap();
        assert_eq!(world.pick(middle, SIZE).unwrap().object, behind);
        assert_eq!(world.pick([0.0, 0.0], SIZE), None);
        assert_eq!(world.pick(middle, (0, 0)), None);
        assert_eq!(world.cast_ray([0.0; 3], [0.0; 3]), None);
        assert_eq!(world.pick([f32::NAN, 0.0], SIZE), None);
    }

    #[test]
    fn surfaces_are_met_from_the_sides_that_show() {
        let mut world = world();
        let red = world.add_material(Material::matte(1.0, 0.0, 0.0)).unwrap();
        let glass = world.add_material(Material::glass()).unwrap();
        let square = [
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [-1.0, 1.0, 0.0],
        ];
        let wall = world.add_polygon(&square, red).unwrap();
        let ahead = |world: &World| world.cast_ray([0.2, 0.3, 5.0], [0.0, 0.0, -2.0]);
        let back = |world: &World| world.cast_ray([0.2, 0.3, -5.0], [0.0, 0.0, 2.0]);
        assert_eq!(ahead(&world).unwrap().distance, 5.0);
        assert_eq!(back(&world), None);
        world.make_of(wall, glass).unwrap();
        assert_eq!(back(&world).unwrap().normal, DVec3::NEG_Z);
        assert_eq!(world.cast_ray([1.5, 0.0, 5.0], [0.0, 0.0, -1.0]), None);
        world.remove(wall).unwrap();
        let room = world.add_sphere([0.0; 3], -4.0, red).unwrap();
        assert_eq!(
            ahead(&world).unwrap().distance,
            5.0 + (16.0_f64 - 0.13).sqrt()
        );
        assert_eq!(ahead(&world).unwrap().object, room);
    }

    /// The reference tracer shows a flat colour exactly where an object is picked.
    #[test]
    fn what_is_picked_is_what_the_reference_shows() {
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
        let scene = nff::parse(text.as_bytes(), "picked", &nff::Limits::default()).unwrap();
        let (picture, world) = (reference(&scene), world_of(&scene));
        let mut differ = 0;
        for (place, pixel) in (0..).zip(picture.pixels()) {
            let (x, y) = (place % SIZE.0, place / SIZE.0);
            let found = world.pick([x as f32, y as f32], SIZE);
            let colour = found.map_or(0.0, |found| {
                let material = world.material_of(found.object).unwrap();
                world.material(material).unwrap().colour.x
            });
            let shown = (colour * 255.0).round() as i32;
            differ += u32::from((shown - i32::from(pixel[0])).abs() > 1);
        }
        assert!(differ <= 3, "{differ} pixels differ");
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
