//! Scenes that are refused, and the messages.

use super::*;

/// A light, and a material that reflects everything, so that chains have the full length.
const MIRROR: &str = "l 0 9 0\nf 1 1 1 1 1 0 0 1\n";

fn refusal(rest: &str) -> String {
    refusal_at(rest, 5)
}

fn refusal_at(rest: &str, ray_depth: u32) -> String {
    let options = RenderOptions { ray_depth, ..Default::default() };
    match in_local_store(&scene(rest), options) {
        Ok(_) => panic!("accepted"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn out_of_range_numbers_are_refused() {
    let cases = [
        ("s 5e18 0 0 1", "9: centre 5e18 is out of range: its magnitude must be at most 2^62"),
        (
            "s 0 0 0 -1e-20",
            "9: radius -1e-20 is out of range: its magnitude must be at most 2^62 and at least 2^-62",
        ),
        ("p 3\n0 0 0\n1 0 0\n0 -1e30 0", "9: vertex -1e30 is out"),
        ("pp 3\n0 0 0 0 0 1\n1 0 1e30 0 0 1\n0 1 0 0 0 1", "9: vertex 1e30 is out"),
        ("c\n1e30 0 0 1\n0 0 0 1", "9: base 1e30 is out"),
        ("c\n0 0 0 1\n0 1e30 0 1", "9: apex 1e30 is out"),
        ("c\n0 0 0 1e30\n0 1 0 1", "9: base radius 1e30 is out"),
        ("c\n0 0 0 1\n0 1e-30 0 1", "9: height 1e-30 is out"),
        ("c\n0 0 0 1\n0 1e-10 0 1e10", "9: growth of the radius"),
        ("l 0 1e30 0", "9: light 1e30 is out"),
        ("l 0 0 0 1 1e30 1", "9: brightness 1e30 is out"),
        ("#cellray sun 0 0 1 1 1e30 1", "9: brightness 1e30 is out"),
        ("#cellray ambient 0 0 1e30", ": ambient light 1e30 is out"),
        ("#cellray shader depth 1e30 0\ns 0 0 0 1", "8: parameter of the shader 1e30 is out"),
        ("#cellray shader checker 1 1 1 1e-30\ns 0 0 0 1", "8: parameter of the shader "),
        ("#cellray shader wood\ns 0 0 0 1", "8: the SPU program has no shader `wood`"),
        ("b 0 0 1e30", ": background 1e30 is out"),
        ("f 1 1e30 1 1 0 0 0 1\ns 0 0 0 1", "9: colour 1e30 is out"),
        ("f 1 1 1 1 1e30 0 0 1\ns 0 0 0 1", "9: Ks 1e30 is out"),
        ("f 1 1 1 1 0 1e30 0 1\ns 0 0 0 1", "9: shine 1e30 is out"),
        ("f 1 1 1 1 0 0 1 1e-30\ns 0 0 0 1", "9: index of refraction 1e-30 is out"),
        (
            "f 1 1 1 1 0 0 1 0\ns 0 0 0 1",
            "9: an index of refraction of 0 refracts nothing (T is above 0)",
        ),
    ];
    for (rest, message) in cases {
        let found = refusal(rest);
        let wanted = match message.strip_prefix(':') {
            Some(rest) => format!("t.nff:{rest}"),
            None => format!("t.nff:{message}"),
        };
        assert!(found.starts_with(&wanted), "{rest}: {found}");
    }
    let mut block = block("s 0 0 0 1\n");
    let before = block.bytes().to_vec();
    for eye in [DVec3::NAN, DVec3::INFINITY, DVec3::splat(1e30)] {
        let error = block.write_for(eye).expect_err("no eye").to_string();
        assert!(error.starts_with("t.nff: eye "), "{error}");
    }
    assert_eq!(block.bytes(), before);
    // A parallelogram that is too small for its duals to be in range becomes two triangles.
    let small = self::block("p 4\n0 0 0\n1e-19 0 0\n1e-19 1e-19 0\n0 1e-19 0\n");
    assert_eq!(small.leaves(PrimitiveKind::Rectangle).len(), 0);
}

#[test]
fn scenes_over_capacity_are_refused() {
    let spheres = |count: usize| "s 0 0 0 1\n".repeat(count);
    for (count, fit) in [(1025, 1024), (3000, 1024)] {
        let message = format!(
            "t.nff:1033: more than 1024 spheres: the scene has about {count}; about {fit} of its {count} \
             spheres fit"
        );
        assert_eq!(refusal(&spheres(count)), message);
    }
    let fan = |count: usize| {
        let corner = |index: usize| {
            let angle = index as f64 / count as f64 * std::f64::consts::TAU;
            format!("{} {} 0\n", libm::cos(angle), libm::sin(angle))
        };
        let corners: String = (0..count).map(corner).collect();
        format!("p {count}\n{corners}")
    };
    for (text, line, count, fit) in [
        (fan(1027), 9, 1025, 664),
        (fan(100_000), 9, 99_998, 665),
        // The last polygon is a parallelogram.
        (format!("{}{}{}", fan(802), fan(502), fan(4)), 812, 1300, 663),
    ] {
        let found = refusal(&text);
        let message = format!(
            "t.nff:{line}: more than 1024 triangles: the scene has about {count}; about {fit}"
        );
        assert!(found.starts_with(&message), "{found}");
        assert!(found.ends_with(&format!(" of its {count} triangles fit")), "{found}");
    }
    let star: String = (0..101)
        .map(|index| {
            let angle = f64::from(index * 50 % 101) / 101.0 * std::f64::consts::TAU;
            format!("{} {} 0\n", libm::cos(angle), libm::sin(angle))
        })
        .collect();
    assert_eq!(
        refusal(&format!("p 101\n{star}")),
        "t.nff:9: a polygon of 101 vertices takes more than 1024 triangles"
    );
    assert_eq!(refusal(&"l 0 0 0\n".repeat(65)), "t.nff:73: more than 64 lights");
    assert_eq!(block(&"l 0 0 0\n".repeat(64)).light_count(), 64);
    for depth in [0, 17, u32::MAX] {
        let message = format!("ray depth {depth}: must be 1 to 16");
        assert_eq!(refusal_at("s 0 0 0 1\n", depth), message);
    }
}

#[test]
fn too_large_scene_error_has_capacity() {
    let triangles = |count: usize| {
        let each = |index: usize| format!("p 3\n{index} 0 0\n{index} 1 0\n{index} 0 1\n");
        MIRROR.to_owned() + &(0..count).map(each).collect::<String>()
    };
    let message = refusal(&triangles(1000));
    let [needed, capacity, fit] = numbers_of(&message);
    assert!(needed > capacity);
    assert!(
        message
            .contains("for rays of depth 5): 1000 triangles 122640, 1 material 96, 1 light 32; "),
        "{message}"
    );
    assert_eq!(capacity, SCENE_CAPACITY as usize - 16 * 32 * 3);
    // "About" means within some per cent.
    let fewer = fit - fit / 50;
    assert_eq!(block(&triangles(fewer)).leaves(PrimitiveKind::Triangle).len(), fewer);
    let more = refusal(&triangles(fit + fit / 50));
    assert!(more.contains(" triangles fit"), "{more}");
}

#[test]
fn largest_consumers_of_memory_are_named() {
    let each_its_own = |count: usize, object: &str| {
        let material = |index: usize| format!("f 0 0 {index} 1 0 0 0 1\n{object}");
        (0..count).map(material).collect::<String>()
    };
    // The spheres alone would fit, but not their materials.
    let message = refusal(&each_its_own(900, "s 0 0 0 1\n"));
    let (before, fit) = message.rsplit_once("; about ").expect("an estimate");
    assert!(before.contains("): 900 materials 86400, 900 spheres "), "{message}");
    let fit = fit.strip_suffix(" of its 900 materials fit").expect("of what");
    let fit: usize = fit.parse().expect("a number");
    let with_materials = |count: usize| {
        let shared = "s 0 0 0 1\n".repeat(900 - count);
        format!("{}{shared}", each_its_own(count, "s 0 0 0 1\n"))
    };
    block(&with_materials(fit - fit / 50 - 1));
    assert!(refusal(&with_materials(fit + fit / 50 + 2)).contains("spheres fit"));
    // Neither sort alone would fit.
    let cone = "c\n0 0 0 1\n0 1 0 1\n";
    let message = refusal(&each_its_own(1000, cone));
    let (before, part) = message.rsplit_once("; about ").expect("an estimate");
    assert!(before.contains("): 1000 materials 96000, 1000 cones "), "{message}");
    let part = part.strip_suffix(" % of the scene fits").expect("of what");
    let part: usize = part.parse().expect("a number");
    block(&each_its_own(10 * (part - 1), cone));
    refusal(&each_its_own(10 * (part + 2), cone));
}

/// The needed bytes, the free bytes and the number of objects that fit, from a message about 1000
/// objects.
fn numbers_of(message: &str) -> [usize; 3] {
    let words = message.split(|c: char| !c.is_ascii_digit());
    let numbers: Vec<usize> = words.filter_map(|digits| digits.parse().ok()).collect();
    let [needed, capacity, .., fit, 1000] = numbers[..] else {
        panic!("{message}");
    };
    [needed, capacity, fit]
}

#[test]
fn batch_is_largest_that_fits() {
    let waiting = 16 * 32;
    for ray_depth in 1..=16 {
        for spheres in [0, 200, 400, 500, 600] {
            let scene = scene(&(MIRROR.to_owned() + &"s 0 0 -5 1\n".repeat(spheres)));
            let options = RenderOptions { ray_depth, ..Default::default() };
            let block = of(&scene, options);
            let deepest = if spheres == 0 { 1 } else { ray_depth };
            assert_eq!(block.ray_depth(), deepest);
            let batches = if deepest > 1 { 3 } else { 0 };
            // Two packets of rays each.
            let buffers = |batch: u32| match batch {
                ..=8 => 0,
                _ => batch as usize * 2 * 640,
            };
            let taken = |batch: u32| {
                block.bytes().len() + waiting * (batch * batches) as usize + buffers(batch)
            };
            let batch = block.batch();
            assert!((1..=MAX_BATCH).contains(&batch));
            assert!(taken(batch) <= SCENE_CAPACITY as usize);
            let larger = if batch < 8 { batch + 1 } else { MAX_BATCH };
            assert!(batch == MAX_BATCH || spheres > 512 || taken(larger) > SCENE_CAPACITY as usize);
        }
    }
}
