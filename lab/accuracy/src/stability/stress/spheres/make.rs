//! Spheres and rays that are difficult to intersect.

use crate::families::Shot;
use crate::stability::prelude::*;
use crate::stability::random::either_side;

/// The number of packets for a sphere.
const PACKETS: usize = 2;
/// The direction used if the target is at the origin of the ray.
pub const ANYWHERE: Vector = [0.0, 0.0, -1.0];

/// A sphere at a position that is rounded to singles, and the rays that `make` creates from origin
/// and centre.
fn shot(
    centre: Vector,
    radius: f64,
    random: &mut Generator,
    make: impl Fn(&mut Generator) -> (Vector, Vector),
) -> Shot {
    let mut ray = || {
        let (origin, way) = make(random);
        fresh(origin.map(from_f64), way.map(from_f64))
    };
    Shot {
        centre: centre.map(from_f64),
        radius: from_f64(radius),
        packets: (0..PACKETS).map(|_| [(); 16].map(|()| ray())).collect(),
    }
}

/// Radii from 1e-6 to 1e6, origins from the surface to 1e6 radii away, and rays to all parts of
/// the sphere and past it.
pub fn scales(random: &mut Generator, form: Form) -> Shot {
    let radius = magnitude(-20, 20, random);
    // The eye is outside, and at least at the smallest distance of its header's domain.
    let distance = radius * if form == Form::Eye { 1.5 } else { 1.001 } * magnitude(0, 20, random);
    let centre = match form {
        Form::Eye => rounded(direction(random).map(|x| distance * x)),
        // As far from the world's origin as possible with the rays' origins on singles.
        Form::General => rounded(direction(random).map(|x| magnitude(-20, 20, random) * x)),
    };
    shot(centre, radius, random, |random| {
        let origin = match form {
            Form::Eye => [0.0; 3],
            Form::General => {
                let inside = random.random_ratio(1, 4);
                let away = if inside { radius * random.random_range(0.0..0.999) } else { distance };
                rounded(add_scaled(centre, away, direction(random)))
            }
        };
        let [first, _] = across(towards(origin, centre, ANYWHERE), random);
        let reach = radius * random.random_range(0.0..1.2);
        let target = add_scaled(centre, reach, first);
        (origin, towards(origin, target, ANYWHERE))
    })
}

/// Rays within 64 ulps of the distance from a tangent.
pub fn grazing(random: &mut Generator, form: Form) -> Shot {
    let radius = magnitude(-20, 20, random);
    let distance = 1.5 * radius * magnitude(0, 16, random);
    let way = direction(random);
    let [out, _] = across(way, random);
    let before = (distance * distance - radius * radius).sqrt();
    let centre = match form {
        // The point where the ray from 0 along the direction passes the sphere at the distance of
        // its radius.
        Form::Eye => add_scaled(way.map(|x| before * x), radius, out),
        Form::General => direction(random).map(|x| distance * x),
    };
    let centre = rounded(centre);
    shot(centre, radius, random, |random| {
        let most = if random.random() { 64.0 } else { 2.0 };
        let off = random.random_range(-most..most) * spacing(distance);
        let (origin, way) = match form {
            Form::Eye => ([0.0; 3], add_scaled(way.map(|x| before * x), -off, out)),
            Form::General => {
                let way = direction(random);
                let [out, _] = across(way, random);
                (add_scaled(add_scaled(centre, radius + off, out), -before, way), way)
            }
        };
        (rounded(origin), unit(way))
    })
}

/// Origins on the surface, some ulps to either side of it, and farther away by powers of two.
pub fn surface(random: &mut Generator, _: Form) -> Shot {
    let radius = to_f64(from_f64(magnitude(-20, 20, random)));
    let centre = rounded(direction(random).map(|x| radius * random.random_range(0.0..4.0) * x));
    shot(centre, radius, random, |random| {
        let out = direction(random);
        let off = match random.random_range(0..3) {
            0 => 0.0,
            1 => random.random_range(0.0..64.0) * spacing(radius),
            _ => radius * magnitude(-20, -2, random),
        };
        let height = radius + either_side(off, random);
        let origin = add_scaled(centre, height, out);
        let way = if random.random() {
            direction(random)
        } else {
            let rise = magnitude(-20, -2, random);
            let rise = either_side(rise, random);
            let [level, _] = across(out, random);
            add_scaled(level, rise, out)
        };
        (rounded(origin), unit(way))
    })
}
