//! Counts of rays: those published for the Standard Procedural Databases, and sums that must hold.

use std::path::Path;

use oracle::Pixels;
use oracle::whitted::{Counts, Options, trace};

const SPD: Options = Options {
    depth: 5,
    fresnel: false,
    spd_rays: true,
    shadows: true,
    pixels: Pixels { corners: true, ..Pixels::PLAIN },
    rounding: oracle::whitted::Rounding::Double,
};

fn counts(scene: &scenes::Scene, options: &Options) -> Counts {
    let counts = trace(scene, 512, 512, options).expect("a picture").1;
    assert_eq!(counts.eye + counts.reflected + counts.refracted, counts.hit + counts.background);
    counts
}

/// Traces a scene with SPD's rays. All counts are within 0.1 % of the published ones.
fn check(name: &str, primitives: usize, published: [u64; 4]) {
    let scene = scenes::load(Path::new(name)).expect("a scene");
    let triangles = scene.mesh.as_ref().map_or(0, |mesh| mesh.triangles.len());
    assert_eq!(scene.objects.len() + triangles, primitives);
    let found = counts(&scene, &SPD);
    assert_eq!(found.eye, 513 * 513);
    let found = [
        ("eye_hit", found.eye_hit),
        ("reflected", found.reflected),
        ("refracted", found.refracted + found.totally_reflected),
        ("shadow", found.shadow + found.shadow_behind),
    ];
    for ((kind, found), published) in found.into_iter().zip(published) {
        let off = found.abs_diff(published);
        assert!(1000 * off <= published, "{name}: {kind} {found}, published {published}");
    }
}

macro_rules! published {
    ($($test:ident $name:literal $primitives:literal $counts:expr;)*) => {$(
        #[test]
        fn $test() {
            check($name, $primitives, $counts);
        }
    )*};
}

// A scene's primitives at its default size, and its rays: eye rays that hit, reflected, refracted
// with total reflections among them, and to lights. The teapot has SPD's 9264 primitives, with two
// triangles for each of its 144 squares.
published! {
    the_published_counts_of_balls "sphereflake:4" 7382 [263_169, 175_095, 0, 954_368];
    the_published_counts_of_gears "gears" 9345 [245_086, 304_643, 207_564, 2_246_955];
    the_published_counts_of_mount "mount" 8196 [173_125, 354_769, 354_769, 412_922];
    the_published_counts_of_rings "rings" 8401 [263_169, 315_236, 0, 1_085_002];
    the_published_counts_of_teapot "teapot" 9408 [161_120, 225_248, 0, 407_656];
    the_published_counts_of_tetra "tetra:5" 4096 [49_788, 0, 0, 46_112];
    the_published_counts_of_tree "tree" 8191 [169_836, 0, 0, 1_097_419];
}

#[test]
fn primary_rays_go_through_centres_or_corners() {
    let scene = scenes::sphereflake::generate(1).expect("a scene");
    let centres = Options { pixels: Pixels::PLAIN, ..SPD };
    assert_eq!(counts(&scene, &centres).eye, 512 * 512);
    assert_eq!(counts(&scene, &SPD).eye, 513 * 513);
    // An edge through the middle of the middle column: two of a pixel's corners are white.
    let edge = "v\nfrom 0 0 10\nat 0 0 0\nup 0 1 0\nangle 10\nhither 0\nresolution 3 3\nb 1 1 1\n\
        f 1 1 1 1 0 1 0 1\np 4\n0 -9 0\n9 -9 0\n9 9 0\n0 9 0\n";
    let edge = scenes::parse(edge.as_bytes(), "edge", &scenes::Limits::default()).expect("a scene");
    let (smooth, _) = trace(&edge, 3, 3, &SPD).expect("a picture");
    let row = [[255; 3], [128; 3], [0; 3]];
    assert_eq!(smooth.picture.pixels(), row.repeat(3));
}

#[test]
fn larger_depth_adds_rays_reproducibly() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let scene = scenes::read(&folder.join("glass.nff")).expect("a scene");
    let at = |depth| {
        let options = Options { depth, ..Options::default() };
        trace(&scene, 160, 90, &options).expect("a picture")
    };
    let mut rays = 0;
    for depth in 1..=6 {
        let (_, counts) = at(depth);
        let sum = counts.eye + counts.reflected + counts.refracted;
        assert!(sum > rays, "depth {depth}: {sum}");
        rays = sum;
    }
    assert_eq!(at(5), at(5));
}

#[test]
fn without_shadows_lights_reach_everything() {
    let text = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 20\nhither 0\nresolution 1 1\nl 0 -9 0 1 1 1\n\
        f 1 1 1 1 0 0 0 1\ns 0 1 0 1\ns 0 -8 0 0.1\nf 0 0 0 0 0 0 1 1\n";
    let mut scene =
        scenes::parse(text.as_bytes(), "shadow", &scenes::Limits::default()).expect("a scene");
    // The eye is beyond the light, and the small sphere between the light and the large one.
    scene.view.from.x = 0.3;
    let look = |shadows| {
        let options = Options { shadows, ..Options::default() };
        let (reference, counts) = trace(&scene, 1, 1, &options).expect("a picture");
        (reference.picture.pixels()[0], counts.shadow)
    };
    assert_eq!(look(true), ([0; 3], 1));
    let (lit, rays) = look(false);
    assert!(lit[0] > 200 && rays == 0, "{lit:?}, {rays}");
}

#[test]
fn spd_rule_counts_invisible_glass_rays() {
    // Of glass of Ks 0, of which one ball is lit and the other is not.
    let text = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 20\nhither 0\nresolution 60 40\nb 0.2 0.3 0.5\n\
        l 5 -9 3\nf 1 1 1 0.2 0 0 0.8 1.1\ns -1.2 0 0 1\nf 1 1 1 0 0 0 1 1.3\ns 1.2 0 0 1\n\
        f 1 0 0 1 0 0 0 1\n#cellray shader flat\ns 0 0 1.3 0.4\n";
    let scene =
        scenes::parse(text.as_bytes(), "glass", &scenes::Limits::default()).expect("a scene");
    let [seen, all] = [false, true].map(|spd_rays| {
        let options = Options { spd_rays, depth: 2, ..Options::default() };
        trace(&scene, 60, 40, &options).expect("a picture")
    });
    // Silhouettes too.
    assert_eq!(seen.0, all.0);
    let ((_, seen), (_, all)) = (seen, all);
    assert_eq!((seen.eye, seen.eye_hit, seen.refracted), (all.eye, all.eye_hit, all.refracted));
    // Every primary ray that meets glass is refracted, and now reflected as well.
    assert_eq!((seen.reflected, all.reflected), (0, seen.refracted));
    assert!(seen.eye_hit > all.reflected && all.shadow > seen.shadow);
    assert_eq!(all.eye + all.reflected + all.refracted, all.hit + all.background);
}
