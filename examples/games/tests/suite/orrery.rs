//! What is visible of the orrery.

use std::collections::BTreeSet;

use cellray::game::{Anchor, DVec3, Game as _, Key, ObjectId, Shape};
use games::orrery::Orrery;
use rand::seq::IndexedRandom as _;
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;

use crate::driven::{self, SIZE};

/// Bodies nearer than this are not stars.
const HERE: f64 = 100.0;

type Played = driven::Played<Orrery>;

impl Played {
    fn sphere(&self, object: ObjectId) -> (DVec3, f64) {
        match *self.world.shape(object).unwrap() {
            Shape::Sphere { centre, radius } => (centre, radius.abs()),
            ref other => panic!("everything is made of spheres except {other:?}"),
        }
    }

    /// Whether a sphere is wholly in the picture, with a margin of `part` of half the picture at
    /// each edge.
    fn is_in_the_picture(&self, (centre, radius): (DVec3, f64)) -> bool {
        let view = self.world.view();
        let ahead = (view.at - view.from).normalize();
        let right = ahead.cross(view.up).normalize();
        let up = right.cross(ahead);
        let high = libm::tan((view.angle / 2.0).to_radians());
        let wide = high * f64::from(SIZE.0) / f64::from(SIZE.1);
        let to = centre - view.from;
        // The four planes that bound the view go through the eye.
        [(right, wide), (-right, wide), (up, high), (-up, high)].into_iter().all(|(aside, half)| {
            let inwards = (ahead * half - aside).normalize();
            to.dot(inwards) > radius
        })
    }
}

#[test]
fn all_planets_are_in_picture_at_any_time() {
    let mut played = Played::new();
    for _ in 0..10 {
        played.press(Key::Up);
    }
    let objects: Vec<_> = played.world.objects().collect();
    let mut farthest = 0.0_f64;
    // The time in which Neptune orbits once.
    while played.game.days() < 61_000.0 {
        played.frame(0.1, &[]);
        for &object in &objects {
            let sphere = played.sphere(object);
            if sphere.0.length() < HERE {
                farthest = farthest.max(sphere.0.length());
                assert!(played.is_in_the_picture(sphere), "day {}: {sphere:?}", played.game.days());
            }
        }
    }
    assert!(farthest > 21.0, "{farthest}");
    assert!(farthest < HERE / 2.0, "{farthest}");
}

#[test]
fn eye_stays_outside_sun_and_planets() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(4);
    let mut played = Played::new();
    let objects: Vec<_> = played.world.objects().collect();
    let follow = [Key::Digit0, Key::Digit1, Key::Digit2, Key::Digit4, Key::Digit5, Key::Right];
    let held = [Key::PageUp, Key::PageDown, Key::A, Key::W, Key::S];
    let mut near = 0;
    for _ in 0..6000 {
        if rng.random_ratio(1, 60) {
            played.press(*follow.choose(&mut rng).unwrap());
        }
        if rng.random_ratio(1, 60) {
            played.press(*[Key::Up, Key::Down].choose(&mut rng).unwrap());
        }
        let key = *held.choose(&mut rng).unwrap();
        // The eye is nearer most of the time.
        let down = rng.random_ratio(if key == Key::PageUp { 9 } else { 1 }, 10);
        played.frame(0.04, &[(key, down)]);
        let eye = played.world.view().from;
        let bodies = [DVec3::ZERO].into_iter().chain(played.game.places().to_vec());
        for centre in bodies {
            let radius = objects
                .iter()
                .map(|&object| played.sphere(object))
                .filter(|sphere| sphere.0 == centre)
                .map(|sphere| sphere.1)
                .fold(0.0, f64::max);
            assert!(radius > 0.2, "a body at {centre}");
            let off = eye.distance(centre) - radius;
            assert!(off > 0.0, "{off} off what is at {centre}");
            near += u32::from(off < 0.1);
        }
    }
    assert!(near > 10, "it was near a body {near} times");
}

#[test]
fn eye_keeps_its_distance_from_sun() {
    let mut played = Played::new();
    played.frame(0.0, &[(Key::PageUp, true)]);
    for _ in 0..300 {
        played.frame(0.04, &[]);
    }
    assert_eq!(played.game.followed(), 0);
    assert!((played.world.view().from.length() - 2.0).abs() < 1e-9);
    // The eye is nearer to a planet.
    played.press(Key::Digit1);
    for _ in 0..300 {
        played.frame(0.04, &[]);
    }
    assert_eq!(played.game.followed(), 1);
    let view = played.world.view();
    assert!(view.from.distance(view.at) < 1.3);
}

/// Where the eye is and looks, which changes the whole picture.
fn view(played: &Played) -> (DVec3, DVec3) {
    let view = played.world.view();
    (view.from, view.at)
}

#[test]
fn eye_stops_within_three_seconds() {
    for key in [Key::Digit1, Key::Digit6, Key::Digit8, Key::Digit0] {
        let mut played = Played::new();
        played.press(Key::Digit3);
        (0..50).for_each(|_| played.frame(0.04, &[]));
        played.press(Key::Space);
        played.press(key);
        (0..75).for_each(|_| played.frame(0.04, &[]));
        let rest = view(&played);
        for step in [0.04, 0.1, 0.013] {
            played.frame(step, &[]);
            assert_eq!(view(&played), rest, "{key:?}");
        }
    }
}

#[test]
fn planets_are_labelled_unless_labels_are_off() {
    let mut played = Played::new();
    played.frame(0.04, &[]);
    let names = |played: &Played| {
        let labels = played.game.labels().into_iter();
        labels.map(|label| label.text).collect::<Vec<_>>()
    };
    let planets = ["Mercury", "Venus", "Earth", "Mars", "Jupiter", "Saturn", "Uranus", "Neptune"];
    assert_eq!(names(&played), planets);
    // The name is just below its planet.
    for (label, place) in played.game.labels().iter().zip(played.game.places()) {
        let Anchor::Point(point) = label.anchor else {
            panic!("{label:?}");
        };
        let [below, planet] = [point, *place].map(|it| played.world.project(it, SIZE).unwrap());
        assert!((below[0] - planet[0]).abs() < 2.0, "{}", label.text);
        assert!((3.0..30.0).contains(&(below[1] - planet[1])), "{}", label.text);
    }
    played.press(Key::N);
    assert!(names(&played).is_empty());
    played.press(Key::N);
    // Whoever follows a planet sees the names of its moons, after its own, unless it hides them.
    played.press(Key::Digit5);
    let mut seen = BTreeSet::new();
    for _ in 0..100 {
        played.frame(0.04, &[]);
        let names = names(&played);
        assert_eq!(names[0], "Jupiter");
        seen.extend(names.into_iter().filter(|name| !planets.contains(&name.as_str())));
    }
    let moons = ["Callisto", "Europa", "Ganymede", "Io"];
    assert!(seen.iter().eq(moons), "{seen:?}");
}

#[test]
fn body_hidden_by_the_sun_has_no_label() {
    let mut played = Played::new();
    played.press(Key::Space);
    let shown = |played: &Played, name| {
        let labels = played.game.labels();
        labels.iter().any(|label| label.text == name)
    };
    // The eye comes down to the planets, and turns about the sun, so that the sun hides each of
    // them once.
    let mut hidden = false;
    played.frame(0.0, &[(Key::S, true)]);
    (0..6).for_each(|_| played.frame(0.04, &[]));
    played.frame(0.0, &[(Key::S, false), (Key::D, true)]);
    for _ in 0..300 {
        played.frame(0.04, &[]);
        let (from, _) = view(&played);
        let to_sun = -from.normalize();
        let earth = played.game.places()[2] - from;
        let is_behind = earth.length() > from.length() && earth.normalize().dot(to_sun) > 0.9999;
        hidden |= is_behind;
        assert!(!is_behind || !shown(&played, "Earth"));
        assert!(shown(&played, "Neptune") || played.game.places()[7].dot(from) < 0.0);
    }
    assert!(hidden);
}

#[test]
fn days_are_independent_of_frame_times() {
    let days = |frames: u32, step: f64| {
        let mut played = Played::new();
        (0..frames).for_each(|_| played.frame(step, &[]));
        played.game.days()
    };
    // The times are exact multiples of a step.
    assert_eq!(days(16, 1.0 / 32.0), days(32, 1.0 / 64.0));
    assert_eq!(days(16, 1.0 / 32.0), days(4, 1.0 / 8.0));
    assert!((days(30, 1.0 / 30.0) - 6.0).abs() < 0.02);
    // A long frame slows down time.
    assert_eq!(days(1, 0.25), days(1, 100.0));

    let mut played = Played::new();
    played.press(Key::Space);
    played.frame(0.2, &[]);
    assert_eq!(played.game.days(), 0.0);
}
