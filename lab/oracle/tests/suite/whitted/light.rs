//! The formulas of light: brightness, highlights, shares of mirror and glass.

use oracle::whitted::Options;
use oracle::{Colour, Pixels};

use super::{colour, look, scene};

const EYE: [f64; 3] = [0.0, 0.0, 10.0];

/// A ground in the plane z = 0 of a material, seen from above.
fn ground(before: &str, material: &str) -> scenes::Scene {
    let rest = format!("{before}f {material}\np 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n");
    scene(EYE, [0.0; 3], &rest)
}

fn byte(value: f64) -> u8 {
    (value * 255.0 + 0.5).floor() as u8
}

#[test]
fn lights_without_a_colour_share_by_the_databases_rule() {
    let matt = "1 0.5 0.25 0.8 0 1 0 1";
    for count in [1, 2, 3, 9] {
        let sum = f64::from(count).sqrt() / 2.0;
        let found = colour(&ground(&"l 0 0 5\n".repeat(count as usize), matt));
        let expected = [1.0, 0.5, 0.25].map(|channel: f64| byte((0.8 * sum * channel).min(1.0)));
        assert_eq!(found, expected, "{count} lights");
    }
    // A colour counts as it stands; the other light is still one of two.
    let mixed = colour(&ground("l 0 0 5\nl 0 0 5 0 0.5 0.25\n", "1 1 1 0.5 0 1 0 1"));
    let grey = 0.5 * 2f64.sqrt() / 4.0;
    assert_eq!(mixed, [byte(grey), byte(grey + 0.25), byte(grey + 0.125)]);
}

#[test]
fn a_sky_by_hand() {
    let sky = "b 1 0.5 0\n#cellray sky 0 0.5 1 0 0 2\n";
    for (height, share) in [(-1.0, 0.0), (0.0, 0.0), (3.0, 0.6), (1e9, 1.0)] {
        let above = scene([0.0; 3], [4.0, 0.0, height], sky);
        let [red, green, blue] = [1.0 - share, 0.5, share].map(byte);
        assert_eq!(colour(&above), [red, green, blue], "{height}");
    }
}

#[test]
fn colours_in_srgb_by_hand() {
    let srgb =
        Options { pixels: Pixels { colour: Colour::Srgb, ..Pixels::PLAIN }, ..Options::default() };
    // An emitter has the colour of the file, and half of white in a mirror is
    // half as bright.
    let own = scene(EYE, [0.0; 3], "b 0.2 0.5 1\n");
    assert_eq!(look(&own, &srgb).0, [0.2, 0.5, 1.0].map(byte));
    let mirror = ground("b 1 1 1\n", "0 0 0 0 0.5 1 0 1");
    assert_eq!(look(&mirror, &srgb).0, [byte(0.5); 3]);
    // Of white's light, half is 0.735 of its value.
    let lit = ground("l 0 0 20 0.5 0.5 0.5\n", "1 1 1 1 0 1 0 1");
    assert_eq!(look(&lit, &srgb).0, [188; 3]);
}

#[test]
fn lambert_and_blinn_by_hand() {
    // The light at 60 degrees: N.L is 1/2, and the halfway vector is at 30 degrees.
    let light = format!("l {} 0 5 1 0.5 1\n", 5.0 * 3f64.sqrt());
    let found = colour(&ground(&light, "1 1 0 0.6 0.3 2 0 1"));
    let highlight = 0.3 * libm::pow(libm::cos(30f64.to_radians()), 8.0);
    assert_eq!(found, [byte(0.3 + highlight), byte(0.5 * (0.3 + highlight)), byte(highlight)]);
    // From below the ground a light is not asked for.
    let (dark, counts) = look(&ground("l 0 0 -5\n", "1 1 1 1 0 1 0 1"), &Options::default());
    assert_eq!((dark, counts.shadow), ([0; 3], 0));
}

#[test]
fn highlights_are_as_wide_as_phongs() {
    // Where Phong's highlight has fallen to a half, so has Blinn's with four times the exponent,
    // to 4 %.
    for shine in [5.0f64, 20.0, 100.0] {
        let phong = libm::acos(libm::pow(0.5f64, 1.0 / shine));
        let light = format!("l {} 0 {} 1 1 1\n", 9.0 * libm::sin(phong), 9.0 * libm::cos(phong));
        let found = colour(&ground(&light, &format!("1 1 1 0 1 {shine} 0 1")));
        let share = f64::from(found[0]) / 255.0;
        assert!((share - 0.5).abs() < 0.02, "{shine}: {share}");
    }
}

#[test]
fn energy_is_conserved_in_white_surroundings() {
    let ball = |material: &str| {
        let rest = format!("b 1 1 1\nf 1 1 1 {material}\ns 0 0 0 2\n");
        scene([1.1, 0.0, 10.0], [1.1, 0.0, 0.0], &rest)
    };
    let deep = Options { depth: 16, ..Options::default() };
    let by_schlick = Options { fresnel: true, ..deep };
    assert_eq!(look(&ball("0 0.25 1 0.75 1.5"), &deep).0, [255; 3]);
    assert_eq!(look(&ball("0 0 1 1 1.5"), &by_schlick).0, [255; 3]);
    assert_eq!(look(&ball("0 0.2 1 0.8 2.4"), &by_schlick).0, [255; 3]);
    // The same without depth: of the primary ray's mirror alone a quarter comes.
    let shallow = Options { depth: 2, ..Options::default() };
    let (seen, counts) = look(&ball("0 0.25 1 0.75 1.5"), &shallow);
    assert_eq!(seen, [byte(0.25); 3]);
    assert_eq!((counts.reflected, counts.refracted), (1, 1));
    let alone = Options { depth: 1, ..Options::default() };
    assert_eq!(look(&ball("0 0.25 1 0.75 1.5"), &alone).0, [0; 3]);
}

#[test]
fn schlicks_share_at_a_surface_seen_straight_and_flat() {
    let by_schlick = Options { fresnel: true, ..Options::default() };
    // White sky on this side, below the surface a black ground that takes all.
    let rest = "b 1 1 1\nf 1 1 1 0 0 1 1 1.5\np 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n\
        f 0 0 0 0 0 1 0 1\np 4\n900 -900 -1\n900 900 -1\n-900 900 -1\n-900 -900 -1\n";
    let reflected = |angle: f64| {
        let (x, z) = (10.0 * libm::sin(angle), 10.0 * libm::cos(angle));
        look(&scene([x, 0.0, z], [0.0; 3], rest), &by_schlick).0
    };
    for degrees in [0.0f64, 45.0, 60.0, 80.0, 89.0] {
        let angle = degrees.to_radians();
        let share = 0.04 + 0.96 * (1.0 - libm::cos(angle)).powi(5);
        assert_eq!(reflected(angle), [byte(share); 3], "{degrees} degrees");
    }
    // From within: the cosine in air counts, so that it joins total reflection without a step.
    let under = "b 1 1 1\nf 1 1 1 0 0 1 1 1.5\np 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n\
        f 0 0 0 0 0 1 0 1\np 4\n900 -900 1\n-900 -900 1\n-900 900 1\n900 900 1\n";
    let from_below = |angle: f64| {
        let (x, z) = (libm::sin(angle), -libm::cos(angle));
        look(&scene([x, 0.0, z], [0.0; 3], under), &by_schlick).0
    };
    let inner = 30f64.to_radians();
    let outer = libm::asin(1.5 * libm::sin(inner));
    let share = 0.04 + 0.96 * (1.0 - libm::cos(outer)).powi(5);
    assert_eq!(from_below(inner), [byte(share); 3]);
    let critical = libm::asin(1.0 / 1.5f64);
    assert!(from_below(critical - 1e-7)[0] >= 254);
    assert_eq!(from_below(critical + 1e-7), [255; 3]);
}

#[test]
fn patches_shade_by_interpolated_normals() {
    // A square whose normals lean outwards: in the middle of the fan's first edge, on the
    // diagonal, the two that lean oppositely meet.
    let patch = |lean: f64| {
        let corner = |x: f64, y: f64| format!("{x} {y} 0 {} {} 1\n", lean * x, lean * y);
        let rest = format!(
            "l 0 0 1000 1 1 1\nf 1 1 1 1 0 1 0 1\npp 4\n{}{}{}{}",
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0)
        );
        move |x: f64, y: f64| colour(&scene([x, y, 10.0], [x, y, 0.0], &rest))
    };
    assert_eq!(patch(0.0)(0.3, 0.2), [255; 3]);
    let leaning = patch(1.0);
    assert_eq!(leaning(0.0, 0.0), [255; 3]);
    // Normals of length 1 at the corners: (x, y, 1) / sqrt 3, interpolated linearly and brought to
    // 1.
    for (x, y) in [(0.5, 0.0), (0.25, -0.5), (-0.7, 0.6)] {
        let expected = 1.0 / libm::hypot(libm::hypot(x, y), 1.0);
        let found = f64::from(leaning(x, y)[0]) / 255.0;
        assert!((found - expected).abs() < 0.003, "{found}, not {expected}");
    }
}
