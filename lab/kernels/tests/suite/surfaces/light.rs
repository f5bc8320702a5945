//! `shadow_rays_r16`, `lambert_r16` and `light_r16`.

use kernels::cases::whitted::shade::error::{any_light, any_shining_site, light_up_to};
use kernels::cases::whitted::shade::light::{HIGHLIGHT, LAMBERT, Lit};
use kernels::prelude::*;
use twins::light::highlight;
use twins::shadow_rays::{DIRECTIONAL, NOT_THERE, Place, shadow_ray};
use twins::surfaces::Surface;

/// A surface in front of the eye that faces it.
fn facing() -> Surface {
    Surface {
        point: [0.0, 0.0, -4.0].map(from_f64),
        plane: [0.0, 0.0, 1.0].map(from_f64),
        leave: from_f64(0.001),
        colour: [from_f64(1.0); 3],
        diffuse: from_f64(0.5),
        highlight: from_f64(0.25),
        exponent: from_f64(20.0),
        mirror: 0,
        transmittance: 0,
        ratio: 0,
        schlick: 0,
        grazing: 0,
        lit: [0; 3],
        flags: 0,
    }
}

#[test]
fn shadow_rays_go_only_to_lights_ahead() {
    let surface = facing();
    let normal = surface.plane;
    let at = |position: [f64; 3]| Place { position: position.map(from_f64), falloff: 0 };
    let there = |surface: &Surface, normal, place: &Place| {
        shadow_ray(surface, normal, ONE, place, 0).t != NOT_THERE
    };
    assert!(there(&surface, normal, &at([0.0; 3])));
    assert!(!there(&surface, normal, &at([1.0, 2.0, -4.0])), "beside");
    assert!(!there(&surface, normal, &at([0.0, 0.0, -5.0])), "behind the surface");
    assert!(!there(&surface, normal, &at([0.0, 0.0, -4.0])), "at the point");
    let turned = [-1.0, 0.0, 0.0].map(from_f64);
    let light = at([1.0, 0.0, 0.0]);
    assert!(!there(&surface, turned, &light), "on the other side of the normal");
    let averted = Surface { plane: turned, ..surface };
    assert!(!there(&averted, normal, &light), "behind the plane");
    let dark = Surface { diffuse: 0, highlight: 0, ..surface };
    assert!(!there(&dark, normal, &at([0.0; 3])), "not lit");
    for share in [Surface { diffuse: 0, ..surface }, Surface { highlight: 0, ..surface }] {
        assert!(there(&share, normal, &at([0.0; 3])));
    }
    let lamp = |range: f64| Place { falloff: from_f64(range.powi(-2)), ..at([0.0; 3]) };
    assert!(there(&surface, normal, &lamp(4.001)) && !there(&surface, normal, &lamp(3.999)));
    let sun = Place { position: [0.0, 0.6, 0.8].map(from_f64), falloff: DIRECTIONAL };
    let ray = shadow_ray(&surface, normal, ONE, &sun, 0);
    assert_eq!(ray.t, FARTHEST);
    for (found, exact) in ray.direction.into_iter().zip(sun.position) {
        assert!((to_f64(found) - to_f64(exact)).abs() <= 2.0 / f64::from(1 << 23));
    }
    let leave = to_f64(ray.origin[2]) + 4.0;
    assert!((0.001..0.00104).contains(&leave), "{leave}");
}

/// A light in front of [`facing`] such that N.L is this cosine.
fn light_at(cosine: f64) -> Place {
    Place {
        position: [(1.0 - cosine * cosine).sqrt(), 0.0, cosine].map(from_f64),
        falloff: DIRECTIONAL,
    }
}

#[test]
fn shadow_ray_below_min_share_is_omitted() {
    let surface = Surface { colour: [0.25, 0.5, 0.125].map(from_f64), ..facing() };
    let matt = Surface { highlight: 0, ..surface };
    // The OR of the channels' bits.
    let most = to_f64(surface.colour.into_iter().fold(0, |all, channel| all | channel));
    assert!((0.5..2.0).contains(&most), "{most}");
    let min_share = 1.0 / 4096.0;
    let there = |surface: &Surface, weight: f64, cosine: f64, min_share: f64| {
        let (weight, min_share) = (from_f64(weight), from_f64(min_share));
        let ray = shadow_ray(surface, surface.plane, weight, &light_at(cosine), min_share);
        ray.t != NOT_THERE
    };
    for cosine in [0.01, 0.1, 0.5, 0.9] {
        let lambert = 0.5 * cosine * most;
        for (surface, share) in [(&matt, lambert), (&surface, lambert + 0.25)] {
            let weight = min_share / share;
            assert!(there(surface, 1.01 * weight, cosine, min_share), "{cosine}");
            assert!(!there(surface, 0.99 * weight, cosine, min_share), "{cosine}");
            assert!(there(surface, 0.99 * weight, cosine, 0.9 * min_share));
        }
    }
    // Without a bound only what is not lit at all is left out, whatever the weight and the colour.
    let black = Surface { colour: [0; 3], ..matt };
    for surface in [&surface, &matt, &black] {
        assert!(there(surface, 0.0, 0.5, 0.0));
    }
    assert!(!there(&black, 1.0, 0.5, min_share));
    let dark = Surface { diffuse: 0, ..matt };
    assert!(!there(&dark, 1.0, 0.5, 0.0));
}

#[test]
fn light_kernels_agree_without_highlight() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..100 {
        let light = any_light(&mut random);
        let mut site = any_shining_site(&mut random, &light, 100.0);
        for surface in &mut site.surfaces {
            surface.highlight = 0;
        }
        let brightness = [(); 3].map(|()| from_f64(random.random_range(0.0..2.0)));
        let sites = vec![site];
        let with = Lit::<HIGHLIGHT> { sites: sites.clone(), light, brightness }.call(&mut bench);
        let without = Lit::<LAMBERT> { sites, light, brightness }.call(&mut bench);
        assert_eq!(with, without);
    }
}

#[test]
fn highlights_are_powers_of_the_cosine() {
    let normal = [0.0, 0.0, 1.0].map(from_f64);
    let eye = [0.0, 0.0, -1.0];
    let power = |cosine: f64, exponent: f64| {
        // H bisects the angle between the light and the eye.
        let (sin, cos) = libm::sincos(2.0 * libm::acos(cosine));
        let to = [sin, 0.0, cos].map(from_f64);
        to_f64(highlight(normal, eye.map(from_f64), to, from_f64(exponent)))
    };
    for exponent in [0.25, 1.0, 2.0, 10.0, 100.0, 1000.0, 4096.0] {
        for step in 0..=1000 {
            let cosine = f64::from(step) / 1000.0 * (1.0 - 0.001) + 0.001;
            let error = (power(cosine, exponent) - libm::pow(cosine, exponent)).abs();
            let bound = if exponent > 1000.0 { 0.0015 } else { 0.0006 };
            assert!(error <= bound, "{cosine}^{exponent}: {error}");
        }
    }
    // 0^0 = 1.
    let across = [1.0, 0.0, 0.0].map(from_f64);
    let of = |exponent: f64| {
        let power = highlight(across, eye.map(from_f64), normal, from_f64(exponent));
        to_f64(power)
    };
    assert!((of(0.0) - 1.0).abs() <= 0.001);
    assert!(of(0.25) <= 0.001 && of(1.0) <= 0.001);
}

#[test]
fn the_highest_exponents_keep_their_bound() {
    let mut bench = Bench::new();
    let worst = light_up_to::<HIGHLIGHT>(4096.0, &mut bench, &mut random());
    println!("exponents to 4096: {worst:.5}");
    assert!(worst <= 0.0015, "{worst}");
}
