//! Mirrors, glass and shadows whose colours follow from geometry alone.

use oracle::whitted::{Options, trace};

use super::{colour, look, scene, wide};

#[test]
fn mirror_image_equals_mirrored_scene() {
    let view = |rest: &str| wide([0.0, -10.0, 5.0], [0.0, 2.0, -4.0], 20.0, rest);
    let matt = "f 0.9 0.5 0.2 0.9 0 1 0 1\n";
    let floor = "f 1 1 1 0 1 1e6 0 1\np 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n";
    let mirrored = view(&format!(
        "b 0.2 0.4 0.6\nl 3 -5 20 1 1 1\n{floor}{matt}s 0 2 4 1.5\ns -1.5 0.5 4.5 0.5\n"
    ));
    let plain = view(&format!(
        "b 0.2 0.4 0.6\nl 3 -5 -20 1 1 1\n{matt}s 0 2 -4 1.5\ns -1.5 0.5 -4.5 0.5\n"
    ));
    let options = |depth| Options { depth, ..Options::default() };
    let (mirrored, _) = trace(&mirrored, 60, 60, &options(3)).expect("a picture");
    let (plain, _) = trace(&plain, 60, 60, &options(2)).expect("a picture");
    let pairs = mirrored.picture.pixels().iter().zip(plain.picture.pixels());
    let mut seen = 0;
    for (index, (mirrored, expected)) in pairs.enumerate() {
        let off = (0..3).map(|channel| mirrored[channel].abs_diff(expected[channel])).max();
        assert!(
            off <= Some(1) || plain.silhouette[index],
            "pixel {index}: {mirrored:?}, not {expected:?}"
        );
        seen += usize::from(*expected != [51, 102, 153]);
    }
    assert!((500..3000).contains(&seen), "{seen}");
}

#[test]
fn slab_shifts_image_by_snells_law() {
    // A ray at 40 degrees to a slab 2 thick leaves it parallel, shifted by
    // t sin(a) (1 - cos(a) / sqrt(n² - sin²(a))).
    let (angle, thickness, index) = (40f64.to_radians(), 2.0, 1.5f64);
    let (sine, cosine) = libm::sincos(angle);
    let shift = thickness * sine * (1.0 - cosine / (index * index - sine * sine).sqrt());
    let slab = "f 1 1 1 0 0 1 1 1.5\n\
        p 4\n-50 0 -50\n50 0 -50\n50 0 50\n-50 0 50\np 4\n-50 2 50\n50 2 50\n50 2 -50\n-50 2 -50\n";
    // At the far end of the line of sight, 10 from where it meets the slab, a small sphere.
    let probe = |shift: f64| {
        let (x, y) = (10.0 * sine - shift * cosine, 10.0 * cosine + shift * sine);
        let rest = format!("b 0 0 1\n{slab}f 1 0 0 0 0 1 0 1\ns {x} {y} 0 1e-7\n");
        let eye = [-10.0 * sine, -10.0 * cosine, 0.0];
        look(&scene(eye, [0.0; 3], &rest), &Options::default())
    };
    let (seen, counts) = probe(shift);
    assert_eq!(seen, [0, 0, 0], "the sphere, unlit");
    assert_eq!((counts.refracted, counts.hit), (2, 3));
    for wrong in [0.0, shift + 2e-7, shift - 2e-7] {
        assert_eq!(probe(wrong).0, [0, 0, 255], "{wrong}");
    }
}

#[test]
fn all_is_reflected_beyond_the_critical_angle() {
    let critical = libm::asin(1.0 / 1.5f64);
    let surface = "b 1 1 1\nf 1 1 1 0 0 1 1 1.5\np 4\n9 9 0\n-9 9 0\n-9 -9 0\n9 -9 0\n";
    let from_below = |angle: f64| {
        let eye = [-libm::tan(angle), 0.0, -1.0];
        look(&scene(eye, [0.0; 3], surface), &Options::default()).1
    };
    let (through, back) = (from_below(critical - 1e-9), from_below(critical + 1e-9));
    assert_eq!((through.refracted, through.reflected), (1, 0));
    assert_eq!((back.refracted, back.reflected), (0, 1));
    // From above nothing is ever reflected totally.
    let flat = look(&scene([-1.0, 0.0, 1e-6], [0.0; 3], surface), &Options::default());
    assert_eq!((flat.1.refracted, flat.1.reflected), (1, 0));
}

#[test]
fn a_shadow_ends_where_the_tangent_cone_does() {
    // The light is 8 above the ground, the sphere of radius 1 is 3 above it.
    let tangent = libm::tan(libm::asin(1.0f64 / 5.0));
    let edge = 8.0 * tangent;
    let rest = "l 0 0 8 1 1 1\nf 1 1 1 1 0 1 0 1\n\
        p 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\nf 1 0 0 1 0 1 0 1\ns 0 0 3 1\n";
    for turn in 0..12 {
        let (y, x) = libm::sincos(f64::from(turn) * 0.5 + 0.1);
        let at = |radius: f64| [radius * x, radius * y, 0.0];
        let eye = [20.0 * x, 20.0 * y, 1.0];
        assert_eq!(colour(&scene(eye, at(edge * (1.0 - 1e-9)), rest)), [0; 3]);
        let lit = colour(&scene(eye, at(edge * (1.0 + 1e-9)), rest));
        // N.L at the edge.
        let expected = (255.0 / libm::hypot(tangent, 1.0) + 0.5).floor() as u8;
        assert_eq!(lit, [expected; 3]);
    }
}

#[test]
fn glass_throws_an_opaque_shadow_and_bubbles_are_air() {
    let ground = "f 1 1 1 1 0 1 0 1\np 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n";
    let glass = "f 1 1 1 0 0 1 1 1.5\ns 0 0 3 1\n";
    let rest = format!("l 0 0 8 1 1 1\n{ground}{glass}");
    assert_eq!(colour(&scene([9.0, 0.0, 1.0], [0.1, 0.0, 0.0], &rest)), [0; 3]);
    // A bubble as large as its glass leaves nothing of it: rays go straight on. One ray sees four
    // surfaces and then the sphere.
    let hollow = "b 0 0 1\nf 1 1 1 0 0 1 1 1.5\ns 0 0 0 1\ns 0 0 0 -0.9999999999\n\
        f 1 0 0 0 0 1 0 1\ns 5 3 0 1e-3\n";
    let straight = scene([-5.0, -2.2, 0.0], [5.0, 3.0, 0.0], hollow);
    let (seen, counts) = look(&straight, &Options::default());
    assert_eq!(seen, [0, 0, 0]);
    assert_eq!((counts.hit, counts.refracted), (5, 4));
}

#[test]
fn hollow_sphere_is_open_to_the_eye_and_lit_only_from_inside() {
    let hollow_sphere = |light: &str| {
        let rest = format!("l {light} 1 1 1\nf 1 1 1 1 0 1 0 1\ns 0 0 0 -2\n");
        colour(&scene([0.0, -9.0, 0.0], [0.0; 3], &rest))
    };
    assert_eq!(hollow_sphere("0 0 0"), [255; 3]);
    assert_eq!(hollow_sphere("0 -4 0"), [0; 3]);
    // An opaque sphere is not there from inside.
    let inside = "b 0 1 0\nf 1 1 1 1 0 1 0 1\ns 0 0 0 2\n";
    assert_eq!(colour(&scene([0.0; 3], [0.0, 1.0, 0.0], inside)), [0, 255, 0]);
}
