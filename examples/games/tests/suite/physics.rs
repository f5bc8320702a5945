//! The physics of the games.

use cellray::game::{DVec3, Frame, Game, Input, InputEvent, Key, Start, World};
use games::billiards::balls::{Balls, Place};
use games::billiards::rules::Shot;
use games::billiards::table::{CUSHION, HALF, HEAD, POCKETS, RADIUS};
use games::bodies::Body;
use games::marbles::Marbles;
use games::screensaver::Screensaver;
use games::waves::Waves;
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;

/// The maximum number of steps in a shot.
const LONGEST: usize = 60 * 480;

fn level(turn: f64) -> DVec3 {
    let (sine, cosine) = libm::sincos(turn);
    DVec3::new(cosine, 0.0, sine)
}

/// Whether a ball on the bed may be at this place.
fn is_on_the_table(centre: DVec3) -> bool {
    centre.y == RADIUS && centre.x.abs() < HALF.0 + CUSHION && centre.z.abs() < HALF.1 + CUSHION
}

#[test]
fn energy_does_not_grow_and_balls_stop_on_table_or_in_pocket() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(5);
    let (mut pocketed, mut gone) = (0, 0);
    for _ in 0..24 {
        let mut balls = Balls::rack(&mut rng);
        for _ in 0..8 {
            if !balls.on_bed(0) {
                balls.bring_back();
            }
            let direction = level(rng.random_range(-3.2..3.2));
            let speed = rng.random_range(0.5..7.5);
            balls.strike(direction, speed, rng.random_range(-1.0..1.0));
            let mut shot = Shot::default();
            let mut energy = balls.energy();
            let mut steps = 0;
            while !balls.are_at_rest() {
                balls.step(&mut shot);
                let left = balls.energy();
                assert!(left <= energy * (1.0 + 1e-12), "{energy} became {left}");
                energy = left;
                for ball in balls.0.iter().filter(|ball| ball.place == Place::Bed) {
                    let centre = ball.body.centre;
                    assert!(is_on_the_table(centre), "{centre}");
                    assert!((ball.axis.length() - 1.0).abs() < 1e-12);
                }
                steps += 1;
                assert!(steps < LONGEST, "they still move");
            }
            let on_bed: Vec<_> = balls.0.iter().filter(|ball| ball.place == Place::Bed).collect();
            for (number, a) in on_bed.iter().enumerate() {
                for b in &on_bed[number + 1..] {
                    let apart = a.body.centre.distance(b.body.centre);
                    assert!(apart > 2.0 * RADIUS - 1e-6, "{apart}");
                }
            }
            pocketed += usize::from(shot != Shot::default());
            gone = gone.max(balls.0.iter().filter(|ball| ball.place == Place::Gone).count());
        }
    }
    // The shots were a real game: most shots touch a ball, and in some racks several balls are
    // pocketed.
    assert!(pocketed > 96, "{pocketed} shots touched a ball");
    assert!(gone >= 3, "at most {gone} balls were pocketed");
}

/// Only the cue ball, on the bed.
fn alone() -> Balls {
    let mut balls = Balls::rack(&mut Xoshiro256PlusPlus::seed_from_u64(0));
    for ball in &mut balls.0[1..] {
        ball.place = Place::Gone;
    }
    balls
}

#[test]
fn ball_aimed_at_pocket_falls_into_it() {
    for pocket in POCKETS {
        let mut balls = alone();
        if pocket.centre.x == 0.0 {
            // The jaws of a side pocket do not catch a ball that runs along the cushion.
            balls.0[0].body.centre = DVec3::new(0.2, RADIUS, 0.0);
        }
        let from = balls.0[0].body.centre;
        let to = DVec3::new(pocket.centre.x, from.y, pocket.centre.z) - from;
        balls.strike(to.normalize(), 3.0, 0.4);
        let mut shot = Shot::default();
        for _ in 0..LONGEST {
            balls.step(&mut shot);
        }
        let ball = balls.0[0];
        assert_eq!(ball.place, Place::Gone, "{pocket:?}");
        assert!(ball.body.centre.distance(pocket.centre) < 3.0 * RADIUS);
    }
}

#[test]
fn tip_height_gives_follow_or_draw() {
    let after = |height: f64| {
        let mut balls = alone();
        balls.0[1].place = Place::Bed;
        balls.0[1].body.centre = HEAD + DVec3::X * 0.3;
        balls.strike(DVec3::X, 2.0, height);
        let mut shot = Shot::default();
        // After the other has passed it, and before that one returns.
        for _ in 0..300 {
            balls.step(&mut shot);
        }
        balls.0[0].body.velocity.x
    };
    assert!(after(0.8) > 0.2, "follow: {}", after(0.8));
    assert!(after(-1.0) < -0.2, "draw: {}", after(-1.0));
    assert!(after(0.0).abs() < 0.35, "stun: {}", after(0.0));
}

/// Plays frames of a game with the keys that are held in each.
fn play<G: Game>(
    game: &mut G,
    frames: u64,
    seed: u64,
    mut keys: impl FnMut(u64) -> Vec<(Key, bool)>,
    mut each: impl FnMut(&G),
) {
    let mut world = World::new();
    let mut input = Input::default();
    let size = (64, 36);
    game.set_up(&mut world, &Start { seed, size }).unwrap();
    for frame in 0..frames {
        input.begin_frame();
        for (key, down) in keys(frame) {
            input.apply(&InputEvent::Key { key, down });
        }
        let frame = Frame {
            number: frame,
            time: frame as f64 / 30.0,
            delta: 1.0 / 30.0,
            input: &input,
            size,
            last: None,
        };
        game.update(&mut world, &frame).unwrap();
        each(game);
    }
}

fn overlap(bodies: &[Body]) -> f64 {
    let mut most = 0.0_f64;
    for (number, a) in bodies.iter().enumerate() {
        for b in &bodies[number + 1..] {
            most = most.max(a.radius + b.radius - a.centre.distance(b.centre));
        }
    }
    most
}

#[test]
fn screensaver_never_stops_moving() {
    let mut game = Screensaver::default();
    let energy = |game: &Screensaver| game.bodies().iter().map(Body::energy).sum::<f64>();
    let mut first = None;
    // Ten minutes.
    play(
        &mut game,
        18_000,
        3,
        |_| Vec::new(),
        |game| {
            let energy = energy(game);
            let first = *first.get_or_insert(energy);
            assert!((energy / first - 1.0).abs() < 1e-9, "{first} became {energy}");
            for body in game.bodies() {
                let half_size = game.half_size() - DVec3::splat(body.radius - 1e-12);
                assert!(body.centre.abs().cmple(half_size).all(), "{body:?}");
            }
            assert!(overlap(game.bodies()) < 0.05);
        },
    );
}

#[test]
fn marbles_stay_in_tray_and_stop() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(9);
    let arrows = [Key::Left, Key::Right, Key::Up, Key::Down];
    let mut game = Marbles::default();
    let (mut fastest, mut frame) = (0.0_f64, 0);
    let keys = |frame: u64| match frame {
        1800 => arrows.map(|key| (key, false)).to_vec(),
        0..1800 if frame.is_multiple_of(10) => vec![(arrows[rng.random_range(0..4)], rng.random())],
        _ => Vec::new(),
    };
    play(&mut game, 4200, 1, keys, |game| {
        frame += 1;
        let (x, z) = game.tray();
        for body in game.bodies() {
            assert!(body.centre.x.abs() <= x - body.radius + 1e-12);
            assert!(body.centre.z.abs() <= z - body.radius + 1e-12);
            assert_eq!(body.centre.y, body.radius);
            fastest = fastest.max(body.velocity.length());
        }
        if frame == 4200 {
            let speeds = game.bodies().iter().map(|body| body.velocity.length());
            assert_eq!(speeds.fold(0.0, f64::max), 0.0);
            assert!(overlap(game.bodies()) < 1e-3, "{}", overlap(game.bodies()));
        }
    });
    assert!(fastest > 1.0, "{fastest}");
    assert!(game.won() > 0);
}

/// The golden ball is pushed to and fro for ten seconds, and drops fall.
#[test]
fn waves_and_balls_stay_in_pool() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(4);
    let keys = [Key::Left, Key::Right, Key::Up, Key::Down, Key::Space];
    let mut game = Waves::default();
    let pressed = |frame: u64| match frame {
        frame if frame.is_multiple_of(5) => vec![(keys[rng.random_range(0..5)], rng.random())],
        _ => Vec::new(),
    };
    let mut highest = 0.0_f64;
    play(&mut game, 300, 1, pressed, |game| {
        for body in game.bodies() {
            let DVec3 { x, y, z } = body.centre;
            let wall = game.wall() - body.radius + 1e-12;
            assert!(x.abs() <= wall && z.abs() <= wall && (-1.0..3.0).contains(&y), "{body:?}");
            highest = highest.max(game.height(x, z).abs());
        }
    });
    assert!((0.02..0.6).contains(&highest), "{highest}");
}
