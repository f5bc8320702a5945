//! The flight to the rings, to the edge, and down to ground and water.

use cellray::game::{DVec3, Game as _, Key};
use games::flight::{Flight, RINGS};

use crate::driven::Played;

/// The time between frames, and frames of a minute.
const STEP: f64 = 0.05;
const MINUTE: usize = 1200;

#[test]
fn plane_meets_every_ring_by_itself() {
    let mut played = Played::<Flight>::new();
    let mut since = 0;
    while played.game.met() < RINGS + 1 {
        let before = played.game.met();
        played.frame(STEP, &[]);
        since = if played.game.met() > before { 0 } else { since + 1 };
        assert!(since < MINUTE / 2, "{} rings, and none for half a minute", before);
    }
    assert!(played.game.status().starts_with(&format!("{} rings, ", RINGS + 1)));
}

#[test]
fn plane_stays_above_ground_and_water() {
    let mut played = Played::<Flight>::new();
    let mut lowest = f64::INFINITY;
    for frame in 0..2 * MINUTE {
        let steers = [Key::Left, Key::Right][frame / 97 % 2];
        let keys = [(Key::PageUp, true), (Key::Up, true), (steers, frame % 97 < 60)];
        played.frame(STEP, &keys);
        let place = played.game.place();
        let above = place.y - played.game.below(place);
        assert!(above > 11.9, "frame {frame}: {above} m");
        lowest = lowest.min(above);
        let eye = played.world.view().from;
        assert!(eye.y >= played.game.below(eye) + 11.9, "frame {frame}: the eye at {eye}");
    }
    assert!(lowest < 40.0, "it never came near the ground: {lowest} m");
}

#[test]
fn plane_turns_back_at_the_edge() {
    let mut played = Played::<Flight>::new();
    let mut farthest = 0.0_f64;
    for frame in 0..3 * MINUTE {
        // Straight ahead as soon as somebody steers.
        played.frame(STEP, &[(Key::Left, frame == 0), (Key::PageUp, true)]);
        let DVec3 { x, z, .. } = played.game.place();
        farthest = farthest.max(x.abs()).max(z.abs());
    }
    // It turns from 3,072 m on, and the range ends at 3,840 m.
    assert!((3072.0..3700.0).contains(&farthest), "{farthest}");
}

/// A rock that falls makes one crater, lower and in another colour, and so does the next one.
#[test]
fn dropped_rocks_make_craters() {
    let mut played = Played::<Flight>::new();
    let mut last = played.world.to_nff().heights.unwrap();
    for round in 0..2 {
        let mut hit = None;
        for frame in 0..MINUTE / 2 {
            // A rock that is on its way keeps others from falling.
            played.frame(STEP, &[(Key::B, frame % 2 == 0 && frame < 20)]);
            let ground = played.world.to_nff().heights.unwrap();
            if ground != last {
                hit = Some((frame, ground));
                break;
            }
        }
        let (frame, ground) = hit.expect("no crater in half a minute");
        assert!(frame > 20, "round {round}: a crater after {frame} frames");
        let [columns, rows] = ground.size();
        let samples = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let change = samples.map(|(column, row)| {
            let [new, old] = [&ground, &last].map(|field| field.at(column, row));
            (i32::from(new.height) - i32::from(old.height), new.colour != old.colour)
        });
        let (deepest, highest, coloured) = change.fold((0, 0, 0), |(low, high, count), it| {
            (low.min(it.0), high.max(it.0), count + usize::from(it.1))
        });
        // Heights count 5 cm, and samples are 10 m apart.
        assert!((-800..-600).contains(&deepest), "{deepest}");
        assert!((150..=280).contains(&highest), "{highest}");
        assert!((400..700).contains(&coloured), "{coloured}");
        last = ground;
    }
}
