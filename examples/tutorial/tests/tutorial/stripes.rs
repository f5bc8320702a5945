//! The stripes compared with their formula: on a wall, with the check of shaders, and on the
//! planet.

use cellray::framebuffer::{Geometry, PictureFile};
use cellray::game::{DVec3, Material, Model, RenderOptions, Shader, View, World};
use cellray::spe::Program;
use cellray::{Engine, Settings};
use image::RgbImage;

use crate::program::{SIZE, STRIPES, frames, good, path, pictures};

/// A colour after the stripes have darkened it.
fn striped(colour: [f64; 3], scale: f64, strength: f64, y: f64) -> DVec3 {
    let within = (scale * y).fract();
    let part = strength * (within * within - within.powi(4));
    let [red, green, blue] = colour;
    DVec3::new(red * (1.0 - part), green * (1.0 - 2.0 * part), blue * (1.0 - 4.0 * part))
}

/// The directions through the pixels, with length 1.
fn directions(view: &View, size: (u32, u32)) -> impl Iterator<Item = (u32, u32, DVec3)> {
    let camera = view.camera(size.0, size.1).unwrap();
    let pixels = (0..size.1).flat_map(move |y| (0..size.0).map(move |x| (x, y)));
    pixels.map(move |(x, y)| {
        let direction = camera.corner + f64::from(x) * camera.right + f64::from(y) * camera.down;
        (x, y, direction.normalize())
    })
}

/// Checks that a pixel has a colour, limited to the range that can be shown.
fn is(picture: &RgbImage, (x, y): (u32, u32), colour: DVec3) {
    let pixel = picture.get_pixel(x, y).0;
    let expected = colour.clamp(DVec3::ZERO, DVec3::ONE).to_array();
    for (found, expected) in pixel.into_iter().zip(expected) {
        let off = (f64::from(found) / 255.0 - expected).abs();
        assert!(off <= 1.0 / 255.0, "pixel {x}, {y}: {pixel:?}, {colour}");
    }
}

fn own(colour: [f64; 3], parameters: [f64; 4]) -> Material {
    let name = "stripes".into();
    Material {
        shader: Shader::Own { name, parameters },
        ..Material::matte(colour[0], colour[1], colour[2])
    }
}

#[test]
fn shader_passes_rule_check() -> Result<(), Box<dyn std::error::Error>> {
    let program = Program::from_image(include_bytes!(concat!(env!("OUT_DIR"), "/tracer.elf")))?;
    let settings = Settings { program, check_shaders: true, ..Settings::default() };
    let mut world = World::new();
    let model = Model::Whitted;
    world.set_render_options(RenderOptions { model, ..RenderOptions::default() });
    // Only ambient light, so that the picture shows the colour itself.
    world.set_ambient(DVec3::ONE)?;
    let stripes = world.add_material(own([0.9, 0.8, 0.7], [1.6, 0.9, 0.0, 0.0]))?;
    let wall = [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)];
    world.add_polygon(&wall.map(|(x, y)| DVec3::new(x, y, 0.0)), stripes)?;
    // In front of it, so that packets contain rays that do not belong to the shader.
    let green = world.add_material(Material::matte(0.1, 0.6, 0.2))?;
    let ball = (DVec3::new(1.0, 0.5, 2.0), 1.2);
    world.add_sphere(ball.0, ball.1, green)?;

    let folder = tempfile::tempdir()?;
    let file = folder.path().join("wall.png");
    let size = (160, 90);
    let picture = PictureFile::new(&file, Geometry::new(size.0, size.1)?)?;
    let mut engine = Engine::start(settings, Box::new(picture))?;
    for parameters in [[1.6, 0.9], [0.0, 1.0], [7.3, 0.4]] {
        let [scale, strength] = parameters;
        world.set_material(stripes, own([0.9, 0.8, 0.7], [scale, strength, 0.0, 0.0]))?;
        engine.render(world.scene(&program)?, &mut |_| ())?;
        let picture = image::open(&file)?.into_rgb8();
        let view = world.view();
        let mut seen = [0, 0];
        for (x, y, direction) in directions(view, size) {
            let nearest = (ball.0 - view.from).reject_from_normalized(direction).length();
            let point = view.from - direction * (view.from.z / direction.z);
            if nearest < 0.99 * ball.1 {
                is(&picture, (x, y), DVec3::new(0.1, 0.6, 0.2));
                seen[0] += 1;
            } else if nearest > 1.01 * ball.1 {
                is(&picture, (x, y), striped([0.9, 0.8, 0.7], scale, strength, point.y));
                seen[1] += 1;
            }
        }
        assert!(seen[0] > 700 && seen[1] > 9000, "{seen:?}");
    }
    Ok(())
}

const PLANET: f64 = 3.0;
const MOON: f64 = 0.6;
const SUN: DVec3 = DVec3::new(1.0, 0.5, 1.2);

/// Where a ray enters a sphere if it certainly does, or `None` if it certainly does not. An error
/// if it is too close to decide.
fn enters(
    from: DVec3,
    direction: DVec3,
    (centre, radius): (DVec3, f64),
) -> Result<Option<f64>, ()> {
    let to = centre - from;
    let along = to.dot(direction);
    let nearest = to.reject_from_normalized(direction).length();
    if (nearest - radius).abs() < 0.01 * radius {
        return Err(());
    }
    let before = along - (radius * radius - nearest * nearest).max(0.0).sqrt();
    Ok((nearest < radius && before > 1e-9).then_some(before))
}

/// The colour in a direction, or an error on an edge.
fn seen(from: DVec3, direction: DVec3, moon: DVec3) -> Result<DVec3, ()> {
    let spheres = [(DVec3::ZERO, PLANET), (moon, MOON)];
    let [planet, moon] = [0, 1].map(|number| enters(from, direction, spheres[number]));
    let (number, distance) = match (planet?, moon?) {
        (None, None) => return Ok(DVec3::new(0.01, 0.012, 0.03)),
        (Some(near), far) if far.is_none_or(|far| near < far) => (0, near),
        (_, Some(near)) => (1, near),
        (Some(_), None) => unreachable!("the first arm has it"),
    };
    let point = from + direction * distance;
    let (centre, radius) = spheres[number];
    let sun = SUN.normalize();
    let facing = ((point - centre) / radius).dot(sun);
    if facing.abs() < 0.01 {
        return Err(());
    }
    let shadow = enters(point, sun, spheres[1 - number])?;
    let lit = if facing > 0.0 && shadow.is_none() { facing } else { 0.0 };
    let colour = match number {
        0 => striped([1.0, 0.9, 0.78], 1.6, 0.9, point.y),
        _ => striped([0.6, 0.7, 0.8], 9.0, 0.7, point.y),
    };
    Ok(colour * (DVec3::splat(0.06) + DVec3::new(0.95, 0.94, 0.9) * lit))
}

#[test]
fn planet_is_striped_and_lit() {
    let folder = tempfile::tempdir().unwrap();
    pictures(STRIPES, folder.path(), "0..2", &[]);
    let [first, second] = [0, 1].map(|frame| image::open(path(folder.path(), frame)).unwrap());
    assert!(first != second, "the moon stands still");
    let picture = first.into_rgb8();
    let view = View {
        from: DVec3::new(0.0, 3.0, 12.0),
        up: DVec3::new(0.3, 1.0, 0.0),
        ..World::new().view().clone()
    };
    let mut sure = 0;
    for (x, y, direction) in directions(&view, SIZE) {
        if let Ok(colour) = seen(view.from, direction, DVec3::new(3.2, 0.2, 3.2)) {
            is(&picture, (x, y), colour);
            sure += 1;
        }
    }
    assert!(sure > 13_000, "{sure} of {} pixels", SIZE.0 * SIZE.1);
}

#[test]
fn keys_change_the_stripes() {
    let folder = tempfile::tempdir().unwrap();
    let lines = [
        r#"{"format":"cellray recording","version":1,"game":"stripes","seed":0,"size":[160,90]}"#,
        r#"{"step":0}"#,
        r#"{"step":1,"events":[{"key":{"key":"up","down":true}}]}"#,
        r#"{"step":100000000}"#,
        "",
    ];
    std::fs::write(folder.path().join("session"), lines.join("\n")).unwrap();
    let stderr = pictures(STRIPES, folder.path(), "0..3", &["--replay", "session"]);
    assert_eq!(frames(&stderr), 3);
    let pole = |frame| {
        let picture = image::open(path(folder.path(), frame)).unwrap().into_rgb8();
        *picture.get_pixel(SIZE.0 / 2, 20)
    };
    assert_eq!(pole(0), pole(1));
    assert_ne!(pole(1), pole(2));
}

#[test]
fn runs_without_display() {
    let folder = tempfile::tempdir().unwrap();
    let stderr = good(STRIPES, folder.path(), &["--display", "none", "--frames", "3"]);
    assert_eq!(frames(&stderr), 3);
}
