//! What does not fit, and how it is said.

use super::*;

/// A light, and a material that reflects all: with it chains are as long as they may be.
const MIRROR: &str = "l 0 9 0\nf 1 1 1 1 1 0 0 1\n";

fn refusal(rest: &str) -> String {
    refusal_at(rest, 5)
}

fn refusal_at(rest: &str, ray_depth: u32) -> String {
    let options = BlockOptions {
        ray_depth,
        ..Default::default()
    };
    match SceneBlock::new(&scene(rest), options, &entry) {
        Ok(_) => panic!("accepted"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn numbers_out_of_range() {
    let cases = [
        (
            "s 5e18 0 0 1",
            "9: centre 5e18 is out of range: its magnitude must be at most 2^62",
        ),
        (
            "s 0 0 0 -1e-20",
            "9: radius -1e-20 is out of range: its magnitude must be at most 2^62 and at least 2^-62",
        ),
        ("p 3\n0 0 0\n1 0 0\n0 -1e30 0", "9: vertex -1e30 is out"),
        (
            "pp 3\n0 0 0 0 0 1\n1 0 1e30 0 0 1\n0 1 0 0 0 1",
            "9: vertex 1e30 is out",
        ),
        ("c\n1e30 0 0 1\n0 0 0 1", "9: base 1e30 is out"),
        ("c\n0 0 0 1\n0 1e30 0 1", "9: apex 1e30 is out"),
        ("c\n0 0 0 1e30\n0 1 0 1", "9: base radius 1e30 is out"),
        ("c\n0 0 0 1\n0 1e-30 0 1", "9: height 1e-30 is out"),
        ("c\n0 0 0 1\n0 1e-10 0 1e10", "9: growth of the radius"),
        ("l 0 1e30 0", "9: light 1e30 is out"),
        ("l 0 0 0 1 1e30 1", "9: brightness 1e30 is out"),
        ("#cellray sun 0 0 1 1 1e30 1", "9: brightness 1e30 is out"),
        ("#cellray ambient 0 0 1e30", ": ambient light 1e30 is out"),
        (
            "#cellray shader depth 1e30 0\ns 0 0 0 1",
            "8: number of the shader 1e30 is out",
        ),
        (
            "#cellray shader checker 1 1 1 1e-30\ns 0 0 0 1",
            "8: number of the shader ",
        ),
        (
            "#cellray shader wood\ns 0 0 0 1",
            "8: the SPU program has no shader `wood`",
        ),
        ("b 0 0 1e30", ": background 1e30 is out"),
        ("f 1 1e30 1 1 0 0 0 1\ns 0 0 0 1", "9: colour 1e30 is out"),
        ("f 1 1 1 1 1e30 0 0 1\ns 0 0 0 1", "9: Ks 1e30 is out"),
        ("f 1 1 1 1 0 1e30 0 1\ns 0 0 0 1", "9: shine 1e30 is out"),
        (
            "f 1 1 1 1 0 0 1 1e-30\ns 0 0 0 1",
            "9: index of refraction 1e-30 is out",
        ),
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
        let error = block.look(eye).expect_err("no eye").to_string();
        assert!(error.starts_with("t.nff: eye "), "{error}");
    }
    assert_eq!(block.bytes(), before);
    // A parallelogram so small that its own numbers would be out of range is two triangles.
    let small = self::block("p 4\n0 0 0\n1e-19 0 0\n1e-19 1e-19 0\n0 1e-19 0\n");
    assert_eq!(small.leaves(Kind::Rectangle).len(), 0);
}

#[test]
fn more_than_there_is_room_for() {
    let spheres = |count: usize| "s 0 0 0 1\n".repeat(count);
    assert_eq!(
        refusal(&spheres(1025)),
        "t.nff:1033: more than 1024 spheres"
    );
    let fan = |count: usize| {
        let corner = |index: usize| {
            let angle = index as f64 / count as f64 * std::f64::consts::TAU;
            format!("{} {} 0\n", libm::cos(angle), libm::sin(angle))
        };
        let corners: String = (0..count).map(corner).collect();
        format!("p {count}\n{corners}")
    };
    assert_eq!(refusal(&fan(1027)), "t.nff:9: more than 1024 triangles");
    assert_eq!(refusal(&fan(100_000)), "t.nff:9: more than 1024 triangles");
    assert_eq!(
        refusal(&"l 0 0 0\n".repeat(65)),
        "t.nff:73: more than 64 lights"
    );
    assert_eq!(block(&"l 0 0 0\n".repeat(64)).light_count(), 64);
    for depth in [0, 17, u32::MAX] {
        let message = format!("ray depth {depth}: must be 1 to 16");
        assert_eq!(refusal_at("s 0 0 0 1\n", depth), message);
    }
}

#[test]
fn a_scene_that_is_too_large_says_how_much_would_fit() {
    let triangles = |count: usize| {
        let each = |index: usize| format!("p 3\n{index} 0 0\n{index} 1 0\n{index} 0 1\n");
        MIRROR.to_owned() + &(0..count).map(each).collect::<String>()
    };
    let [needed, room, fit] = numbers_of(&refusal(&triangles(1000)));
    assert!(needed > room);
    assert_eq!(room, SCENE_ROOM as usize - 3 * 16 * 32 * 4);
    // About: within some per cent.
    let fewer = fit - fit / 50;
    assert_eq!(block(&triangles(fewer)).leaves(Kind::Triangle).len(), fewer);
    let more = refusal(&triangles(fit + fit / 50));
    assert!(more.contains(" triangles fit"), "{more}");
}

/// Bytes needed, bytes there and objects that fit, of a message about 1000 of them.
fn numbers_of(message: &str) -> [usize; 3] {
    let words = message.split(|c: char| !c.is_ascii_digit());
    let numbers: Vec<usize> = words.filter_map(|digits| digits.parse().ok()).collect();
    let [needed, room, _, fit, 1000] = numbers[..] else {
        panic!("{message}");
    };
    [needed, room, fit]
}

#[test]
fn the_batch_is_as_large_as_fits() {
    let waiting = 3 * 16 * 32;
    for ray_depth in 1..=16 {
        for spheres in [0, 200, 400, 500, 600] {
            let scene = scene(&(MIRROR.to_owned() + &"s 0 0 -5 1\n".repeat(spheres)));
            let options = BlockOptions {
                ray_depth,
                ..Default::default()
            };
            let block = of(&scene, options);
            let deepest = if spheres == 0 { 1 } else { ray_depth };
            assert_eq!(block.ray_depth(), deepest);
            let taken =
                |batch: u32| block.bytes().len() + waiting * (batch * (deepest - 1)) as usize;
            let batch = block.batch();
            assert!((1..=MAX_BATCH).contains(&batch));
            assert!(taken(batch) <= SCENE_ROOM as usize);
            assert!(batch == MAX_BATCH || taken(batch + 1) > SCENE_ROOM as usize);
        }
    }
}
