//! Finds the pixels that a sphere's shadow may fall on.
//!
//! The shadow is covered by a row of spheres beyond the first one. Their centres are on the ray
//! from the light through the sphere's centre, and they all touch the cone from the light around
//! the sphere. Invariant: the result has every pixel in the shadow, with a wide margin for the
//! rounding of the SPU's shadow rays.

use glam::DVec3;
use scenes::{LightKind, unit};

use super::projection::{Projection, Rectangle};
use crate::scene::block::BoundingSphere;

/// By how much a sphere that casts a shadow is widened, relative to the sum of all distances that
/// determine its shadow rays. The error of these rays is about 2^-20 of that sum.
const SLACK: f64 = 1.0 / (1 << 15) as f64;

/// The number of pieces that the row of spheres on an object is cut into. With pieces, a shadow
/// that runs diagonally across the picture doesn't need the whole rectangle around it.
const PIECES: u32 = 8;

/// The row of spheres: sphere k has the radius `growth` k + `radius` and the centre `from` + k
/// `way`, for k from `first` on.
pub(super) struct Shadow {
    from: DVec3,
    way: DVec3,
    growth: f64,
    radius: f64,
    first: f64,
    /// The sum of the distances that the slack is relative to, without those of the object that
    /// the shadow falls on.
    reach: f64,
}

impl Shadow {
    /// The shadow of an object inside a sphere. `None` if the light is inside the sphere or close
    /// to it, because the shadow may then fall anywhere.
    pub fn of(sphere: BoundingSphere, light: LightKind, projection: &Projection) -> Option<Self> {
        let BoundingSphere { centre, radius } = sphere;
        let reach = projection.to(centre).length() + radius;
        match light {
            LightKind::Point { position } => {
                let way = centre - position;
                let reach = reach + way.length();
                let growth = radius + SLACK * reach;
                (way.length() > 2.0 * growth).then_some(Self {
                    from: position,
                    way,
                    growth,
                    radius: 0.0,
                    first: 1.0,
                    reach,
                })
            }
            LightKind::Directional { to_light } => Some(Self {
                from: centre,
                way: -unit(to_light)?,
                growth: 0.0,
                radius,
                first: 0.0,
                reach,
            }),
        }
    }

    /// Calls `found` with the pixels on which the shadow may fall on an object inside `sphere`. If
    /// the object is flat, `plane` is its plane: a point and a normal.
    pub fn on(
        &self,
        sphere: BoundingSphere,
        plane: Option<(DVec3, DVec3)>,
        projection: &Projection,
        found: &mut impl FnMut(&Rectangle),
    ) {
        let distances = self.reach + self.from.distance(sphere.centre) + sphere.radius;
        let wider = Self {
            radius: self.radius + SLACK * (distances + projection.to(sphere.centre).length()),
            ..*self
        };
        let Some((first, last)) = wider.touching(sphere, plane) else {
            return;
        };
        let at = |piece: u32| {
            let k = first + (last - first) * f64::from(piece) / f64::from(PIECES);
            (wider.from + k * wider.way, wider.growth * k + wider.radius)
        };
        for piece in 0..PIECES {
            found(&projection.hull([at(piece), at(piece + 1)]));
        }
    }

    /// The first and the last sphere of the row that may touch an object.
    fn touching(
        &self,
        sphere: BoundingSphere,
        plane: Option<(DVec3, DVec3)>,
    ) -> Option<(f64, f64)> {
        // Solves |to - k way| <= growth k + radius + the object's radius, squared, for k.
        let to = sphere.centre - self.from;
        let sum = self.radius + sphere.radius;
        let square = self.way.length_squared() - self.growth * self.growth;
        let half = to.dot(self.way) + self.growth * sum;
        let rest = to.length_squared() - sum * sum;
        let under = half * half - square * rest;
        if under < 0.0 {
            return None;
        }
        let root = under.sqrt();
        let mut first = ((half - root) / square).max(self.first);
        let mut last = (half + root) / square;
        if let Some((point, normal)) = plane {
            // |height + k rise| <= growth k + radius, on both sides of the plane.
            let height = (self.from - point).dot(normal);
            let rise = self.way.dot(normal);
            for side in [1.0, -1.0] {
                let (slope, constant) = (side * rise - self.growth, side * height - self.radius);
                if slope < 0.0 {
                    first = first.max(-constant / slope);
                } else if slope > 0.0 {
                    last = last.min(-constant / slope);
                } else if constant > 0.0 {
                    return None;
                }
            }
        }
        (first <= last).then_some((first, last))
    }
}

#[cfg(test)]
mod tests {
    use rand::{Rng as _, SeedableRng as _};
    use rand_chacha::ChaCha8Rng;
    use scenes::Camera;

    use super::*;
    use crate::framebuffer::Geometry;
    use crate::scene::random::{magnitude, unit};
    use crate::work::arithmetic::camera;

    const SIZE: Geometry = Geometry { width: 80, height: 50 };

    /// The pixel in which a point is visible.
    fn pixel(camera: &Camera, point: DVec3) -> Option<[u32; 2]> {
        let ahead = camera.right.cross(camera.down);
        let to = point - camera.eye;
        let part = camera.corner.dot(ahead) / to.dot(ahead);
        let from_corner = to * part - camera.corner;
        let place =
            [camera.right, camera.down].map(|step| from_corner.dot(step) / step.length_squared());
        let inside = |place: f64, side: u32| place > -0.5 && place < f64::from(side) - 0.5;
        (part > 0.0 && inside(place[0], SIZE.width) && inside(place[1], SIZE.height))
            .then(|| place.map(|place| place.round() as u32))
    }

    /// Whether a sphere is between a point and a light.
    fn is_shadowed(sphere: BoundingSphere, point: DVec3, light: LightKind) -> bool {
        let (way, most) = match light {
            LightKind::Point { position } => (position - point, 1.0),
            LightKind::Directional { to_light } => (to_light, f64::INFINITY),
        };
        let nearest = (sphere.centre - point).dot(way) / way.length_squared();
        let nearest = nearest.clamp(0.0, most);
        (point + nearest * way).distance(sphere.centre) < sphere.radius
    }

    #[test]
    fn every_point_in_the_shadow_is_found() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let (mut shadowed, mut small, mut all) = (0, 0, 0);
        for _ in 0..20_000 {
            let camera = camera(&mut random, SIZE.width, SIZE.height);
            let projection = Projection::new(&camera, SIZE);
            let place = random.random_range(0.0..80.0);
            let sight = camera.corner + camera.right * place + camera.down * place * 0.6;
            let middle = camera.eye + sight.normalize() * magnitude(&mut random, 1.0, 5.0);
            let mut sphere = |spread: f64| BoundingSphere {
                centre: middle + unit(&mut random) * spread,
                radius: spread * random.random_range(0.01..0.9),
            };
            let (caster, on) = (sphere(3.0), sphere(4.0));
            let towards = unit(&mut random);
            let light = if random.random() {
                LightKind::Directional { to_light: towards }
            } else {
                let position = caster.centre + towards * magnitude(&mut random, 0.0, 6.0);
                LightKind::Point { position }
            };
            let normal = unit(&mut random);
            let plane = random.random::<bool>().then_some((on.centre, normal));
            let Some(shadow) = Shadow::of(caster, light, &projection) else {
                continue;
            };
            let mut pixels = Vec::new();
            shadow.on(on, plane, &projection, &mut |found: &Rectangle| pixels.push(found.clone()));
            all += 1;
            small += u32::from(pixels.iter().all(|found| found.x.len() < SIZE.width as usize));
            for _ in 0..20 {
                let mut away = unit(&mut random) * on.radius * random.random_range(0.0..1.0);
                if plane.is_some() {
                    away = away.reject_from_normalized(normal);
                }
                let point = on.centre + away;
                if !is_shadowed(caster, point, light) {
                    continue;
                }
                let Some([x, y]) = pixel(&camera, point) else {
                    continue;
                };
                shadowed += 1;
                let is_there = |found: &Rectangle| found.x.contains(&x) && found.y.contains(&y);
                assert!(pixels.iter().any(is_there), "{x} {y} {pixels:?}");
            }
        }
        assert!(shadowed > 2000, "{shadowed}");
        assert!(small > all / 4, "{small} of {all}");
    }
}
