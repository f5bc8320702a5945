//! Errors of the surface kernels against f64, over random inputs from their domains.

use twins::shadow_rays::{DIRECTIONAL, Place, shadow_ray};
use twins::surfaces::{Material, Object, Surface, surface};

use super::display::Values;
use super::gather::{Hit, Hits, RefineHits};
use super::light::{AMBIENT, HIGHLIGHT, LAMBERT, Lit, Shadows, Site};
use super::shapes::Shape;
use super::sums::{Rows, Shares};
use super::{MIN_SHARE, records};
use crate::prelude::*;
use crate::vector::ulps;

/// The number of packets over which an error is measured.
const PACKETS: u32 = 1000;

/// A random material of any kind that a scene may contain.
pub fn any_material(random: &mut ChaCha8Rng) -> Material {
    let mut share = || from_f64(random.random_range(0.0..1.0));
    let colour = [(); 3].map(|()| share());
    let [diffuse, highlight, mirror, transmittance, schlick, grazing] = [(); 6].map(|()| share());
    let emission = [(); 3].map(|()| share());
    let index = random.random_range(0.5..2.0);
    Material {
        colour,
        diffuse,
        highlight,
        exponent: from_f64(random.random_range(0.0..1000.0)),
        mirror,
        transmittance,
        inverse_index: from_f64(1.0 / index),
        index: from_f64(index),
        schlick,
        grazing,
        emission,
        flags: 1 << random.random_range(0..5),
    }
}

/// Sixteen shapes with their objects after the background's, and a packet of rays that hit them.
pub fn any_hits(random: &mut ChaCha8Rng) -> ([Shape; 16], Vec<(Object, usize)>, [Hit; 16]) {
    let shapes: [Shape; 16] = std::array::from_fn(|_| Shape::any(random));
    let background = Shape::plane([0.0; 3], [0.0, 0.0, 1.0]);
    let objects = std::iter::once(&background).chain(&shapes);
    let objects = objects.map(|shape| (shape.object(), 0)).collect();
    let hits =
        std::array::from_fn(|lane| Hit { ray: shapes[lane].any_ray(random), object: lane + 1 });
    (shapes, objects, hits)
}

/// The largest distance of a point that was moved along its ray from its surface, relative to the
/// origin offset that the surface states.
pub fn refine_hits(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (shapes, objects, hits) = any_hits(random);
        let materials = vec![any_material(random)];
        let found = RefineHits(Hits { packets: vec![hits], objects, materials }).call(bench);
        for (lane, shape) in shapes.iter().enumerate() {
            worst = worst.max(off_surface(&found[0].0, lane, shape));
        }
    }
    worst
}

/// The largest distance of a point from its surface, relative to the origin offset that the
/// surface states.
pub fn surfaces(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (shapes, objects, hits) = any_hits(random);
        let materials = vec![any_material(random)];
        let (found, _) = Hits::<false> { packets: vec![hits], objects, materials }.call(bench);
        for (lane, shape) in shapes.iter().enumerate() {
            worst = worst.max(off_surface(&found[0].0, lane, shape));
        }
    }
    worst
}

/// A light that is near, far, or infinitely far, and that may have a range.
pub fn any_light(random: &mut ChaCha8Rng) -> Place {
    let directional = random.random_ratio(1, 4);
    let distance = if directional { 1.0 } else { magnitude(1.0..1000.0, random) };
    let falloff = match random.random_range(0..2) {
        _ if directional => DIRECTIONAL,
        0 => ZERO,
        _ => from_f64(magnitude(0.1..10.0, random) / (distance * distance)),
    };
    Place { position: any_direction(random).map(|x| from_f64(distance * x)), falloff }
}

/// Hits on random shapes, with shading normals that differ from the surfaces' normals, and their
/// shadow rays to a light, half of them blocked. Exponents are below the given one.
pub fn any_site(random: &mut ChaCha8Rng, light: &Place, exponent: f64) -> Site {
    let (_, objects, hits) = any_hits(random);
    let surfaces: [Surface; 16] = std::array::from_fn(|lane| {
        let mut material = any_material(random);
        material.exponent = from_f64(match random.random_range(0..8) {
            0 => 0.0,
            1 => exponent,
            _ => magnitude(0.25..exponent, random),
        });
        surface(&hits[lane].ray, &objects[lane + 1].0, &material)
    });
    let directions = hits.map(|hit| hit.ray.direction);
    let normals = std::array::from_fn(|lane| {
        let plane = surfaces[lane].plane.map(to_f64);
        let off = any_direction(random);
        let normal = unit(std::array::from_fn(|k| plane[k] + 0.3 * off[k]));
        if dot(normal, directions[lane].map(to_f64)) < 0.0 {
            normal.map(from_f64)
        } else {
            surfaces[lane].plane
        }
    });
    let weights = [(); 16].map(|()| from_f64(magnitude(1e-4..1.0, random)));
    let shadow = std::array::from_fn(|lane| {
        let ray = shadow_ray(&surfaces[lane], normals[lane], weights[lane], light, MIN_SHARE);
        (ray, random.random())
    });
    Site { surfaces, normals, directions, weights, shines: random.random(), shadow }
}

/// The same, but half of the highlights are as bright as possible: the light is almost in the
/// direction of reflection.
pub fn any_shining_site(random: &mut ChaCha8Rng, light: &Place, exponent: f64) -> Site {
    let mut site = any_site(random, light, exponent);
    for lane in 0..16 {
        if random.random() {
            let normal = site.normals[lane].map(to_f64);
            let direction = site.directions[lane].map(to_f64);
            let along = dot(normal, direction);
            let off = any_direction(random);
            let spread = magnitude(1e-4..1.0, random);
            let to =
                std::array::from_fn(|k| direction[k] - 2.0 * along * normal[k] + spread * off[k]);
            let to = unit(to);
            if dot(normal, to) > 0.0 {
                let (ray, _) = &mut site.shadow[lane];
                (ray.direction, ray.t) = (to.map(from_f64), from_f64(0.25));
            }
        }
    }
    site
}

/// The largest error of a component of a direction to a light, in ulps of 1. Infinite if the error
/// of t exceeds the header's.
pub fn shadow_rays(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let light = any_light(random);
        let sites = vec![any_site(random, &light, 100.0)];
        let shadows = Shadows { sites, light, min_share: 0 };
        let found = shadows.call(bench);
        let Shadows { sites, light, .. } = shadows;
        for (ray, surface) in found.packets.iter().flatten().zip(&sites[0].surfaces) {
            let point = surface.point.map(to_f64);
            let position = light.position.map(to_f64);
            let to = if light.is_directional() { position } else { sub(position, point) };
            let distance = dot(to, to).sqrt();
            let exact = to.map(|component| component / distance);
            for (found, exact) in ray.direction.iter().zip(exact) {
                worst = worst.max((to_f64(*found) - exact).abs() * 2_f64.powi(23));
            }
            let t = to_f64(ray.t);
            if t >= 0.0
                && !light.is_directional()
                && (t - distance).abs() > distance * 2_f64.powi(-21)
            {
                worst = f64::INFINITY;
            }
        }
    }
    worst
}

/// The light that a surface sends back of a brightness of 1, in f64, from the formula of the
/// shading model.
fn exact_light(site: &Site, lane: usize, light: &Place, shines: bool) -> [f64; 3] {
    let surface = &site.surfaces[lane];
    let (ray, blocked) = &site.shadow[lane];
    let lit = surface.lit.map(to_f64);
    if *blocked || to_f64(ray.t) < 0.0 {
        return lit;
    }
    let normal = site.normals[lane].map(to_f64);
    let to = ray.direction.map(to_f64);
    let half = unit(sub(to, site.directions[lane].map(to_f64)));
    let cosine = dot(normal, half).clamp(0.0, 1.0);
    let shine = if shines {
        to_f64(surface.highlight) * libm::pow(cosine, to_f64(surface.exponent))
    } else {
        0.0
    };
    let diffuse = to_f64(surface.diffuse) * dot(normal, to);
    let falloff = if light.is_directional() { 0.0 } else { to_f64(light.falloff) };
    let fade = (1.0 - falloff * to_f64(ray.t) * to_f64(ray.t)).powi(2);
    std::array::from_fn(|k| lit[k] + fade * (diffuse * to_f64(surface.colour[k]) + shine))
}

/// The largest error of a channel after adding a light of brightness 1, with exponents up to the
/// given one.
pub fn light_up_to<const WAY: usize>(
    exponent: f64,
    bench: &mut Bench,
    random: &mut ChaCha8Rng,
) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let light = any_light(random);
        let sites = vec![any_shining_site(random, &light, exponent)];
        let lit = Lit::<WAY> { sites, light, brightness: [ONE; 3] };
        let Bits(found) = lit.call(bench)[0];
        for (lane, found) in records::lit(&found).into_iter().enumerate() {
            let exact = exact_light(&lit.sites[0], lane, &lit.light, WAY == HIGHLIGHT);
            for (found, exact) in found.into_iter().zip(exact) {
                worst = worst.max((to_f64(found) - exact).abs());
            }
        }
    }
    worst
}

/// The largest error of a channel, in thousandths of a brightness of 1, with exponents up to 1000.
pub fn light(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    1e3 * light_up_to::<HIGHLIGHT>(1000.0, bench, random)
}

/// The largest error of a channel, in ulps of a brightness of 1.
pub fn lambert(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    light_up_to::<LAMBERT>(1.0, bench, random) * 2_f64.powi(23)
}

/// The same for ambient light.
pub fn ambient(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let light = any_light(random);
        let sites = vec![any_site(random, &light, 100.0)];
        let lit = Lit::<AMBIENT> { sites, light, brightness: [ONE; 3] };
        let Bits(found) = lit.call(bench)[0];
        for (found, surface) in records::lit(&found).iter().zip(&lit.sites[0].surfaces) {
            for (k, found) in found.iter().enumerate() {
                let added = to_f64(surface.diffuse) * to_f64(surface.colour[k]);
                let exact = to_f64(surface.lit[k]) + added;
                worst = worst.max((to_f64(*found) - exact).abs() * 2_f64.powi(23));
            }
        }
    }
    worst
}

/// The largest error of a sum for each addition, in ulps of the sum.
pub fn accumulate(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let pixels = random.random_range(4..40);
        let mut shares = Shares::of(pixels, 4, random);
        shares.sums.fill([0; 3]);
        let found = shares.call(bench);
        let mut exact = vec![[0.0; 3]; pixels];
        let mut additions = vec![0_u32; pixels];
        for share in shares.packets.iter().flatten() {
            additions[share.pixel] += 1;
            for (sum, channel) in exact[share.pixel].iter_mut().zip(share.lit) {
                *sum += to_f64(channel) * to_f64(share.weight);
            }
        }
        for ((found, exact), additions) in found.iter().zip(&exact).zip(additions) {
            for (found, exact) in found.iter().zip(exact).filter(|(_, exact)| **exact > 0.0) {
                worst = worst.max(ulps(to_f64(*found), *exact) / f64::from(additions));
            }
        }
    }
    worst
}

/// The largest error of a pixel's channel, of 255.
pub fn pack_sums(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for shifts in [[16_u32, 8, 0], [8, 16, 24]] {
        for _ in 0..100 {
            let mut channel = || from_f64(random.random_range(-0.25..1.25));
            let row: Vec<[Single; 3]> = (0..64).map(|_| [(); 3].map(|()| channel())).collect();
            let rows = Rows { rows: vec![row], shifts };
            for (colour, word) in rows.rows[0].iter().zip(rows.call(bench)) {
                for (channel, shift) in colour.iter().zip(shifts) {
                    let exact = to_f64(*channel).clamp(0.0, 1.0) * 255.0;
                    worst = worst.max((f64::from(word >> shift & 255) - exact).abs());
                }
            }
        }
    }
    worst
}

/// Like [`surfaces`], for packets whose rays have all hit the same object.
pub fn surfaces_same(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let shape = Shape::any(random);
        let hits = std::array::from_fn(|_| Hit { ray: shape.any_ray(random), object: 0 });
        let objects = vec![(shape.object(), 0)];
        let materials = vec![any_material(random)];
        let (found, _) = Hits::<true> { packets: vec![hits], objects, materials }.call(bench);
        for lane in 0..16 {
            worst = worst.max(off_surface(&found[0].0, lane, &shape));
        }
    }
    worst
}

/// The distance of a point from its surface, relative to its `leave`.
fn off_surface(found: &Surfaces, lane: usize, shape: &Shape) -> f64 {
    let point = [found.point_x, found.point_y, found.point_z];
    let (height, _) = shape.at(point.map(|row| to_f64(bits(row[lane]))));
    height.abs() / to_f64(bits(found.leave[lane]))
}

/// The largest error from 0 to `most`, of 1/255.
fn error_of_values<const ROLL_OFF: bool>(
    bench: &mut Bench,
    random: &mut ChaCha8Rng,
    most: f64,
    exact: fn(f64) -> f64,
) -> f64 {
    let values: Vec<[Single; 4]> =
        (0..1000).map(|_| [(); 4].map(|()| from_f64(random.random_range(0.0..most)))).collect();
    let values = Values::<ROLL_OFF> { values };
    let found = values.call(bench);
    let pairs = values.values.as_flattened().iter().zip(found.as_flattened());
    let errors = pairs.map(|(value, found)| 255.0 * (to_f64(*found) - exact(to_f64(*value))).abs());
    errors.fold(0.0, f64::max)
}

/// The largest error of sRGB's values, of 1/255.
pub fn encode_srgb(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    error_of_values::<false>(bench, random, 1.0, |x| {
        if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 }
    })
}

/// The largest error of limited light, of 1/255.
pub fn roll_off(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    error_of_values::<true>(bench, random, 8.0, |x| {
        if x <= 0.75 { x } else { 1.0 - 0.0625 / (x - 0.5) }
    })
}
