//! What `#cellray` adds to a scene: the sun, light that is everywhere, shaders.

use oracle::whitted::{Options, trace};

use super::{colour, look, scene};

const EYE: [f64; 3] = [0.0, 0.0, 10.0];

/// A ground in the plane z = 0 of a material and its shader, seen from above at `place`.
fn ground(before: &str, material: &str, shader: &str, place: [f64; 2]) -> scenes::Scene {
    let [x, y] = place;
    let rest = format!(
        "{before}f {material}\n#cellray shader {shader}\n\
         p 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n"
    );
    scene([x, y, EYE[2]], [x, y, 0.0], &rest)
}

fn byte(value: f64) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5).floor() as u8
}

#[test]
fn the_sun_is_in_the_same_direction_from_everywhere() {
    // At 60 degrees, and of any length: N.L is 1/2.
    let tall = 3f64.sqrt();
    for length in [1e-3, 1.0, 1e6] {
        let sun = format!("#cellray sun {} 0 {length} 1 0.5 0\n", tall * length);
        for place in [[0.0, 0.0], [40.0, -30.0]] {
            let scene = ground(&sun, "1 1 1 0.8 0 1 0 1", "phong", place);
            assert_eq!(colour(&scene), [byte(0.4), byte(0.2), 0]);
        }
    }
    // Without a colour it is one of the lights that share the brightness.
    let scene = ground("l 0 0 -1\n#cellray sun 0 0 1\n", "1 1 1 1 0 1 0 1", "phong", [0.0; 2]);
    assert_eq!(colour(&scene), [byte(2f64.sqrt() / 4.0); 3]);
}

#[test]
fn sun_is_beyond_all_objects() {
    let sun = "#cellray sun 1 0 1 1 1 1\n";
    let ball = |x: f64| format!("{sun}f 1 1 1 1 0 1 0 1\ns {x} 0 {x} 0.5\n");
    let (light, counts) =
        look(&ground(sun, "1 1 1 1 0 1 0 1", "lambert", [0.0; 2]), &Options::default());
    assert_eq!((light, counts.shadow), ([byte(0.5f64.sqrt()); 3], 1));
    for far in [3.0, 1e6] {
        let shadowed = ground(&ball(far), "1 1 1 1 0 1 0 1", "lambert", [0.0; 2]);
        assert_eq!(colour(&shadowed), [0; 3], "{far}");
    }
    // From below the ground it is not asked for.
    let scene = ground("#cellray sun 1 0 -1\n", "1 1 1 1 0 1 0 1", "phong", [0.0; 2]);
    assert_eq!(look(&scene, &Options::default()).1.shadow, 0);
}

#[test]
fn ambient_light_is_everywhere_but_of_the_diffuse_share() {
    let ambient = "#cellray ambient 0.5 0.25 1\n";
    let seen = |material: &str, shader: &str| colour(&ground(ambient, material, shader, [0.0; 2]));
    let expected = [byte(0.2), byte(0.05), byte(0.1)];
    assert_eq!(seen("1 0.5 0.25 0.4 0.3 1 0 1", "phong"), expected);
    assert_eq!(seen("1 0.5 0.25 0.4 0.3 1 0 1", "lambert"), expected);
    assert_eq!(seen("1 0.5 0.25 0 0.3 1 0 1", "phong"), [0; 3]);
    // Also in the shadow, and added to the lights' sum.
    let lit = ground(
        "#cellray ambient 0.5 0.25 1\nl 0 0 5 0.25 0.25 0.25\n",
        "1 1 1 0.4 0 1 0 1",
        "phong",
        [0.0; 2],
    );
    assert_eq!(colour(&lit), [byte(0.3), byte(0.2), byte(0.5)]);
}

#[test]
fn flat_shader_ignores_lights() {
    let before = "b 1 1 1\n#cellray ambient 1 1 1\nl 0 0 5 1 1 1\n";
    let scene = ground(before, "0.5 0.25 0.75 1 1 1 1 1.5", "flat", [0.0; 2]);
    let (found, counts) = look(&scene, &Options::default());
    assert_eq!(found, [byte(0.5), byte(0.25), byte(0.75)]);
    assert_eq!((counts.shadow, counts.reflected, counts.refracted), (0, 0, 0));
}

#[test]
fn lambert_has_no_highlight_and_still_mirrors() {
    let light = "b 0 0 1\nl 0 0 5 1 1 1\n";
    let seen = |shader: &str| colour(&ground(light, "1 0 0 0.5 0.25 4 0 1", shader, [0.0; 2]));
    assert_eq!(seen("phong"), [byte(0.75), byte(0.25), byte(0.5)]);
    assert_eq!(seen("lambert"), [byte(0.5), 0, byte(0.25)]);
}

#[test]
fn checkers_change_colour_at_the_faces_of_cubes() {
    let sun = "#cellray sun 0 0 1 1 1 1\n";
    let seen = |place: [f64; 2]| colour(&ground(sun, "1 0 0 1 0 1 0 1", "checker 0 1 0 2", place));
    let (own, other) = ([255, 0, 0], [0, 255, 0]);
    assert_eq!(seen([1.0, 1.0]), own);
    assert_eq!(seen([3.0, 1.0]), other);
    assert_eq!(seen([3.0, 3.0]), own);
    assert_eq!(seen([-1.0, 1.0]), other);
    assert_eq!(seen([-1.0, -1.0]), own);
    assert_eq!(seen([-13.0, 1.0]), other);
    // A little before the face, by 1/1024 of a cube: the ground lies in a face and is of one cube.
    assert_eq!(seen([2.0 - 3.0 / 1024.0, 1.0]), own);
    assert_eq!(seen([2.0 - 1.0 / 1024.0, 1.0]), other);
    // Where the colour changes is a silhouette: rounding decides there.
    let wide = |shader: &str| {
        let rest = format!(
            "{sun}f 1 0 0 1 0 1 0 1\n#cellray shader {shader}\n\
             p 4\n50 -50 0\n50 50 0\n-50 50 0\n-50 -50 0\n"
        );
        let scene = super::wide([0.5, 0.5, 10.0], [0.5, 0.5, 0.0], 20.0, &rest);
        let (reference, _) = trace(&scene, 32, 32, &Options::default()).expect("a picture");
        reference.silhouette.iter().filter(|edge| **edge).count()
    };
    assert_eq!(wide("phong"), 0);
    let edges = wide("checker 0 1 0 2");
    assert!((100..600).contains(&edges), "{edges}");
}

#[test]
fn depth_fades_with_the_rays_own_length() {
    let seen = |shader: &str| {
        let before = "b 1 1 1\nl 0 0 5 1 1 1\n";
        colour(&ground(before, "1 0.5 0.25 1 1 1 1 1.5", shader, [0.0; 2]))
    };
    // The ground is 10 away.
    assert_eq!(seen("depth 20 0"), [byte(0.5), byte(0.25), byte(0.125)]);
    assert_eq!(seen("depth 14 6"), [byte(0.5), byte(0.25), byte(0.125)]);
    assert_eq!(seen("depth 30 20"), [255, byte(0.5), byte(0.25)]);
    assert_eq!(seen("depth 5 1"), [0; 3]);
    // In a mirror 10 away, 12 below a ceiling: what counts is the way from there.
    let mirror = "f 0 0 0 0 1 1 0 1\np 4\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";
    let rest = format!(
        "{mirror}f 1 1 1 1 0 1 0 1\n#cellray shader depth 16 0\n\
         p 4\n50 -50 12\n-50 -50 12\n-50 50 12\n50 50 12\n"
    );
    let scene = scene(EYE, [0.0; 3], &rest);
    assert_eq!(colour(&scene), [byte(0.25); 3]);
}
