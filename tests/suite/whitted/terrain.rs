//! Height fields, compared with the reference and with themselves from other eyes.

use std::f64::consts::FRAC_PI_2;

use scenes::{HeightField, HeightRegion, HeightSample, LightKind, Material, Scene};

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, compared};

const SRGB: RenderOptions = RenderOptions { colour: Colour::Srgb, ..WHITTED };

/// A height field of hills, in units of which a hundred are a step, with colours in stripes.
fn hills([columns, rows]: [u32; 2], height: f64) -> HeightField {
    let place = |at: u32| (at % columns, at / columns);
    let heights = (0..columns * rows).map(place).map(|(column, row)| {
        let (x, z) = (f64::from(column), f64::from(row));
        let wave = libm::sin(0.31 * x + 0.12 * z) + libm::sin(0.07 * x - 0.23 * z);
        (100.0 * height * (2.0 + wave)) as u16
    });
    let colours = (0..columns * rows).map(place);
    let colours = colours.map(|(column, row)| match (column / 5 + row / 7) % 3 {
        0 => [247, 239, 231],
        1 => [66, 130, 99],
        _ => [132, 101, 33],
    });
    let (heights, colours) = (heights.collect(), colours.collect());
    HeightField::new([columns, rows], heights, colours, 1.0, 0.01).unwrap()
}

fn scene(field: HeightField, from: DVec3, at: DVec3) -> Scene {
    let text = "v\nfrom 0 1 0\nat 0 0 1\nup 0 1 0\nangle 45\nhither 0\nresolution 8 8\n\
        b 1 0 1\nl 40 80 30 0.9 0.9 0.9\n#cellray ambient 0.3 0.3 0.3\n";
    let mut scene = scenes::parse(text.as_bytes(), "hills", &scenes::Limits::default()).unwrap();
    scene.view.from = from;
    scene.view.at = at;
    scene.materials = vec![Material::matte(DVec3::ONE)];
    scene.heights = Some(Arc::new(field));
    scene
}

/// Fields whose sides are no multiples of blocks, seen from where only the first level is traced:
/// with shadows, a mirror, and the edge of the field.
#[test]
fn near_ground_is_as_the_reference_has_it() {
    // Colours of five bits are exact where they are light.
    for (size, colour, most) in [([40, 33], WHITTED, 2), ([65, 65], SRGB, 6), ([2, 9], WHITTED, 2)]
    {
        let [columns, rows] = size.map(f64::from);
        let from = DVec3::new(-0.6 * columns, 9.0, 0.7 * rows);
        let mut scene = scene(hills(size, 1.0), from, DVec3::new(0.0, 1.0, 0.0));
        scene.materials.push(Material {
            diffuse: 0.3,
            specular: 0.6,
            ..Material::matte(DVec3::new(0.2, 0.3, 0.5))
        });
        scene.objects.push(scenes::Object {
            line: 0,
            material: 1,
            shape: scenes::Shape::Sphere { centre: DVec3::new(0.0, 5.0, 0.0), radius: 2.0 },
        });
        let off = compared(&scene, colour, (160, 120));
        println!("{size:?}: {off:?}");
        assert!(off.max_error_off_silhouette <= most, "{size:?}: {off:?}");
        // It is no other picture than one without ground.
        let bare = compared(&Scene { heights: None, ..scene.clone() }, colour, (160, 120));
        assert!(bare.max_error_off_silhouette <= 2, "{bare:?}");
    }
}

/// From above, where the picture has three levels and all of their seams, each ray hits.
#[test]
fn levels_meet_without_cracks() {
    let field = hills([1025, 1025], 4.0);
    for from in [DVec3::new(0.3, 60.0, 0.7), DVec3::new(-111.0, 30.0, 90.3)] {
        let scene = scene(field.clone(), from, from + DVec3::new(0.2, -1.0, 0.1));
        let wide = Scene { view: scenes::View { angle: 130.0, ..scene.view.clone() }, ..scene };
        let options = RenderOptions { shadows: false, ..WHITTED };
        let rays = Frame::of(&wide, options, (480, 480), Settings::default()).rays();
        assert_eq!((rays.eye, rays.eye_hit), (480 * 480, 480 * 480), "{from}");
    }
}

/// The pixels in which two pictures differ by more than 2/255.
fn different(one: &image::RgbImage, other: &image::RgbImage) -> usize {
    let pairs = one.pixels().zip(other.pixels());
    let far = |(a, b): &(&image::Rgb<u8>, &image::Rgb<u8>)| {
        a.0.iter().zip(&b.0).any(|(a, b)| a.abs_diff(*b) > 2)
    };
    pairs.filter(far).count()
}

/// Where the eye's way crosses the places at which levels change, a step of a thousandth of a
/// sample changes hardly more pixels of a rough ground than elsewhere: those on silhouettes.
#[test]
fn levels_do_not_pop() {
    const ABOVE: f64 = 20.0;
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut field = hills([1025, 1025], 3.0);
    let all = HeightRegion { columns: 0..1025, rows: 0..1025 };
    field.shape(&all, |_, was| HeightSample {
        height: was.height + random.random_range(0..=200),
        ..was
    });
    let look = |x: f64, cuts: bool| {
        let from = DVec3::new(x, 0.0, 3.3);
        let from = from.with_y(field.ground(from) + ABOVE);
        let scene = scene(field.clone(), from, from + DVec3::new(1.0, -0.1, 0.2));
        let options = RenderOptions { shadows: false, cuts, ..SRGB };
        Frame::of(&scene, options, (240, 160), Settings::default()).picture
    };
    let moved = |x: f64, cuts: bool| {
        let [one, other] = [-0.0005, 0.0005].map(|away| look(x + away, cuts));
        different(&one, &other)
    };
    // Squares of a level begin at multiples of 8 of its samples. They change when the eye is 160 of
    // these away, its height included.
    let places = [160.0, 320.0, 640.0].map(|away: f64| away - (away * away - ABOVE * ABOVE).sqrt());
    for cuts in [true, false] {
        let [at, elsewhere] = [0.0, 4.0].map(|by| places.map(|x| moved(x + by, cuts)));
        println!("cuts {cuts}: {at:?} {elsewhere:?}");
        let [at, elsewhere] = [at, elsewhere].map(|counts| counts.iter().sum::<usize>());
        assert!(at <= 2 * elsewhere + 10, "{at} pixels change, and {elsewhere} elsewhere");
    }
}

/// Where the eye moves by a tenth of a sample, levels change no more pixels than the mesh of the
/// first level alone does, which has more silhouettes far away. Silhouettes are at other places in
/// the two, so pixels can't be compared one by one.
#[test]
fn levels_are_calmer_than_one_level() {
    let field = hills([513, 513], 3.0);
    let options = RenderOptions { shadows: false, ..SRGB };
    let changed = |has_levels: bool| {
        let look = |x: f64| {
            let from = DVec3::new(x, 25.0, 3.3);
            let mut scene = scene(field.clone(), from, from + DVec3::new(1.0, -0.2, 0.2));
            if !has_levels {
                scene.mesh = Some(Arc::new(field.mesh()));
                scene.heights = None;
            }
            Frame::of(&scene, options, (240, 160), Settings::default()).picture
        };
        different(&look(-200.0), &look(-199.9))
    };
    let [levels, one] = [changed(true), changed(false)];
    println!("{levels} pixels change, and {one} with one level");
    assert!(one > 100 && levels <= one, "{levels} pixels change, and {one} with one level");
}

/// Rays from the eye that find ground by cuts see what packets see, but for silhouettes, whichever
/// way the camera looks: level, down, banked, beside the edge of the field. And no block of
/// triangles is needed for them, also with a sphere in the ground.
#[test]
fn cuts_see_what_packets_see() {
    let field = hills([257, 257], 3.0);
    let options = RenderOptions { shadows: false, ..SRGB };
    let from = DVec3::new(-60.3, 22.0, 40.7);
    let views = [
        ([1.0, -0.1, 0.3], [0.0, 1.0, 0.0]),
        ([-0.8, -0.4, 1.0], [0.0, 1.0, 0.0]),
        ([0.2, -0.2, -1.0], [0.5, 1.0, 0.1]),
        ([1.0, -0.3, 0.0], [0.0, 1.0, -0.35]),
        ([0.0, 0.1, 1.0], [0.0, 1.0, 0.0]),
    ];
    for (way, up) in views {
        let mut scene = scene(field.clone(), from, from + DVec3::from(way));
        scene.view.up = up.into();
        scene.objects.push(scenes::Object {
            line: 0,
            material: 0,
            shape: scenes::Shape::Sphere { centre: from + 20.0 * DVec3::from(way), radius: 4.0 },
        });
        let [cuts, packets] = [true, false].map(|cuts| {
            let options = RenderOptions { cuts, ..options };
            Frame::of(&scene, options, (320, 200), Settings::default())
        });
        let blocks = [&cuts, &packets].map(|it| it.generations()[0].blocks);
        assert!(blocks[0].used == 0 && blocks[1].used > 0, "{way:?}: {blocks:?}");
        let [hits, others] = [&cuts, &packets].map(|it| it.rays().eye_hit);
        assert!(hits.abs_diff(others) < 400, "{way:?}: {hits} and {others} hits");
        let pairs = cuts.picture.as_raw().iter().zip(packets.picture.as_raw());
        let squares: f64 = pairs.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum();
        let off = (squares / (3.0 * 320.0 * 200.0)).sqrt();
        println!("{way:?}: {off}, {hits} and {others} hits");
        assert!(off < 12.0, "{way:?}: {off}");
    }
}

/// Where rays go straight down, cuts would meet in the picture. There, packets are traced.
#[test]
fn meeting_cuts_are_not_used() {
    let from = DVec3::new(3.0, 30.0, -5.0);
    let scene = scene(hills([129, 129], 2.0), from, from + DVec3::new(0.3, -1.0, 0.0));
    let frame = Frame::of(&scene, WHITTED, (200, 120), Settings::default());
    assert!(frame.generations()[0].blocks.used > 0);
}

/// Where it is known whether the ground hides the sun, pictures are those with all shadow rays, but
/// for a few pixels of crests, which are darker. The sun is in any direction and near the horizon,
/// and a mirror throws a shadow, too. Fewer blocks are needed for such pictures.
#[test]
fn known_shadows_are_those_of_rays() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut used = [0, 0];
    for round in 0..12 {
        let mut field = hills([161, 129], random.random_range(0.5..3.0));
        let rough = random.random_range(0..2) * 40;
        let all = HeightRegion { columns: 0..161, rows: 0..129 };
        field.shape(&all, |_, was| HeightSample {
            height: was.height + random.random_range(0..=rough),
            ..was
        });
        let turn = [0.0, 1.0, random.random_range(0.0..4.0)][round % 3] * FRAC_PI_2;
        let high = [0.03, 0.3, 1.0][round / 4] * random.random_range(0.8..1.2);
        let from = DVec3::new(-8.3, 19.0, 4.7);
        let mut scene = scene(field, from, from + DVec3::new(1.0, -0.2, 0.3));
        let to_light = DVec3::new(libm::cos(turn), high, libm::sin(turn));
        scene.lights[0].kind = LightKind::Directional { to_light };
        scene.materials.push(Material { specular: 0.6, ..Material::matte(DVec3::splat(0.2)) });
        let at = from + DVec3::new(20.0, -6.0, 5.0);
        let shape = scenes::Shape::Sphere { centre: at, radius: 3.0 };
        scene.objects.push(scenes::Object { line: 0, material: 1, shape });
        let [known, rays] = [true, false].map(|shades| {
            let options = RenderOptions { shades, ..SRGB };
            Frame::of(&scene, options, (320, 200), Settings::default())
        });
        let other = different(&known.picture, &rays.picture);
        println!("round {round}: {other} pixels differ");
        let brighter = known.picture.as_raw().iter().zip(rays.picture.as_raw());
        assert!(brighter.filter(|(one, other)| one > other).count() == 0, "round {round}");
        assert!(other < 64, "round {round}: {other} pixels differ");
        for (sum, frame) in used.iter_mut().zip([&known, &rays]) {
            *sum += frame.generations()[1].blocks.used;
        }
    }
    println!("{used:?} blocks");
    assert!(2 * used[0] < used[1], "{used:?} blocks");
}
