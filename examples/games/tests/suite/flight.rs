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
