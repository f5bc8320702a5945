//! Triangles of which it is known which lights reach them.

use protocol::layout::FEATURE_VISIBILITY;
use scenes::{LightKind, Object, Visibility};

use crate::frames::fixture::{Fixture, is_the_same_with_spus};
use crate::prelude::*;

const SIDE: u32 = 24;
const SIZE: (u32, u32) = (96, 64);
/// More lights than a mask has bits.
const LIGHTS: usize = 18;

/// A floor of more than 1,000 triangles under a sphere and some lamps.
fn scene(known: impl Fn(usize) -> Visibility) -> scenes::Scene {
    let text = "v\nfrom 0 -6 5\nat 0 0 0\nup 0 0 1\nangle 50\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nf 1 1 1 0.8 0.2 30 0 1\nf 0.2 0.6 0.3 1 0 0 0 1\n";
    let mut scene = scenes::parse(text.as_bytes(), "floor", &scenes::Limits::default()).unwrap();
    for number in 0..LIGHTS {
        let (sine, cosine) = libm::sincos(number as f64);
        let position = DVec3::new(3.0 * cosine, 3.0 * sine, 2.0 + 0.1 * number as f64);
        let kind = LightKind::Point { position, range: 8.0 };
        scene.lights.push(scenes::Light { line: 0, kind, colour: Some(DVec3::splat(0.1)) });
    }
    let shape = Shape::Sphere { centre: DVec3::new(0.0, 0.0, 1.0), radius: 0.6 };
    scene.objects.push(Object { line: 0, material: 1, shape });
    let mut mesh = scenes::Mesh::default();
    for (row, column) in (0..=SIDE).flat_map(|row| (0..=SIDE).map(move |column| (row, column))) {
        let place = |step: u32| 8.0 * (step as f32 / SIDE as f32) - 4.0;
        mesh.positions.push([place(column), place(row), 0.0]);
        mesh.colours.push([1.0, 0.5, row as f32 / SIDE as f32]);
    }
    for (row, column) in (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (row, column))) {
        let corner = |across, down| (row + down) * (SIDE + 1) + column + across;
        let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
        mesh.materials.extend([0, 0]);
    }
    mesh.visibility = (0..mesh.triangles.len()).map(known).collect();
    scene.mesh = Some(Arc::new(mesh));
    scene
}

/// A picture, and how many rays went to lights.
fn traced(scene: &scenes::Scene, options: RenderOptions) -> (RgbImage, u64) {
    let settings = Settings { spus: 2, ..Settings::default() };
    let picture = Memory::new(Geometry::new(SIZE.0, SIZE.1).unwrap()).unwrap();
    let mut engine = Engine::start(settings, Box::new(picture)).unwrap();
    let scene = Scene::new(scene, options, &Program::tracer()).unwrap();
    let statistics = engine.render(&scene, &mut |_| ()).unwrap();
    let rays = statistics.spus.iter().map(|spu| spu.rays.shadow).sum();
    (engine.picture().unwrap(), rays)
}

fn lit(lit: u16) -> Visibility {
    Visibility { lit, dark: 0 }
}

#[test]
fn picture_is_same_with_any_number_of_spus() {
    let known = |triangle| Visibility { lit: (triangle * 40_503) as u16, dark: triangle as u16 };
    is_the_same_with_spus(&scene(known), [2, 5], 200);
}

/// Without a bit nothing changes, and with all of them the floor has no shadows, or only shadows.
#[test]
fn visibility_replaces_shadow_rays() {
    let options = RenderOptions { ray_depth: 1, ..RenderOptions::default() };
    let mut plain = scene(|_| lit(0));
    let (without_bits, rays) = traced(&plain, options);
    Arc::get_mut(plain.mesh.as_mut().unwrap()).unwrap().visibility.clear();
    assert_eq!(traced(&plain, options), (without_bits.clone(), rays));
    let (found, few) = traced(&scene(|_| lit(u16::MAX)), options);
    assert!(few * 4 < rays, "{few} of {rays}: those of the sphere are left");
    assert_ne!(found, without_bits);
    // The sphere has no shadow on itself.
    assert_eq!(found, traced(&plain, RenderOptions { shadows: false, ..options }).0);
    let dark = scene(|_| Visibility { lit: 0, dark: u16::MAX });
    let (found, same) = traced(&dark, options);
    assert_eq!(same, few);
    for light in &mut plain.lights {
        light.colour = Some(DVec3::ZERO);
    }
    let (black, _) = traced(&plain, options);
    let corner = |picture: &RgbImage| *picture.get_pixel(2, SIZE.1 - 2);
    assert_eq!(corner(&found), corner(&black));
}

/// The light n has the bit n modulo 16.
#[test]
fn lights_have_their_own_bits() {
    let options = RenderOptions { ray_depth: 1, ..RenderOptions::default() };
    let (all, rays) = traced(&scene(|_| lit(0)), options);
    for bits in [1 << 1, 1 << 3, 1 << 15] {
        let (found, few) = traced(&scene(|_| lit(bits)), options);
        let lights = (0..LIGHTS).filter(|light| bits >> (light % 16) & 1 != 0).count() as u64;
        assert!(few < rays && found != all);
        let of_one = rays / LIGHTS as u64;
        assert!((rays - few).abs_diff(lights * of_one) < of_one / 2, "{rays} {few}");
    }
}

/// The bit of the feature alone does nothing.
#[test]
fn visibility_is_for_frames_with_colours() {
    let mut plain = scene(|_| lit(0));
    let mesh = Arc::get_mut(plain.mesh.as_mut().unwrap()).unwrap();
    mesh.colours.clear();
    let mut fixture = Fixture::of(&plain, 1);
    assert_eq!(fixture.frame.features.get() & FEATURE_VISIBILITY, 0);
    let expected = fixture.traced();
    fixture.frame.features |= FEATURE_VISIBILITY;
    assert_eq!(fixture.traced(), expected);
}
