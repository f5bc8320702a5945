//! Runs every game without a player, with random input, twice, and with a check that frames
//! allocate no memory.

use std::io;
use std::ops::ControlFlow;
use std::time::Duration;

use cellray::Settings;
use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{
    Axis, Button, Clock, FixedSteps, Game, InputEvent, InputSource, Key, MouseButton, NoInput,
    PadId, Sensors, Session,
};
use games::{GAMES, find};
use rand::seq::IndexedRandom as _;
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;
use randomness::rounds;

/// A player who presses anything, switches to other windows, and has a pad that disconnects.
struct Anyone {
    rng: Xoshiro256PlusPlus,
    begun: bool,
}

impl Anyone {
    /// A value that a broken device may send.
    fn number(&mut self) -> f32 {
        let odd = [f32::NAN, f32::INFINITY, 1e30, -1e30, f32::MAX, f32::MIN];
        if self.rng.random_ratio(1, 6) {
            *odd.choose(&mut self.rng).unwrap()
        } else {
            self.rng.random_range(-40.0..40.0)
        }
    }
}

impl InputSource for Anyone {
    fn poll(&mut self, events: &mut Vec<InputEvent>) -> io::Result<ControlFlow<()>> {
        let pad = PadId(0);
        let connected = || InputEvent::PadConnected { pad, name: "a pad".to_owned() };
        if !self.begun {
            self.begun = true;
            events.push(connected());
        }
        for _ in 0..self.rng.random_range(0..4) {
            let by = [self.number(), self.number()];
            let [x, y, z, turn] = std::array::from_fn(|_| self.number());
            let rng = &mut self.rng;
            let down = rng.random();
            events.push(match rng.random_range(0..40) {
                // Some events are rare.
                0 => InputEvent::FocusLost,
                1 => InputEvent::PadDisconnected { pad },
                2..4 => connected(),
                4 => InputEvent::MouseLeft,
                5 => InputEvent::MouseMoved { to: by },
                kind => match kind % 7 {
                    0 => InputEvent::Key { key: *Key::ALL.choose(rng).unwrap(), down },
                    1 => InputEvent::MouseMotion { by },
                    2 => InputEvent::Wheel { by: by.map(|part| part / 20.0) },
                    3 => InputEvent::MouseButton {
                        button: *MouseButton::ALL.choose(rng).unwrap(),
                        down,
                    },
                    4 => InputEvent::PadButton {
                        pad,
                        button: *Button::ALL.choose(rng).unwrap(),
                        down,
                    },
                    5 => InputEvent::PadAxis {
                        pad,
                        axis: *Axis::ALL.choose(rng).unwrap(),
                        value: x / 40.0,
                    },
                    _ => InputEvent::PadSensors {
                        pad,
                        sensors: Sensors { acceleration: [x, y, z], turn },
                    },
                },
            });
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// The time on a machine that is busy with other work.
struct AnyTime(Xoshiro256PlusPlus);

impl Clock for AnyTime {
    fn tick(&mut self) -> Duration {
        let micros = match self.0.random_range(0..20) {
            0 => 0,
            1 => self.0.random_range(1_000_000..20_000_000),
            2 => 86_400_000_000,
            _ => self.0.random_range(1_000..100_000),
        };
        Duration::from_micros(micros)
    }
}

fn session(name: &str, seed: u64, size: (u32, u32)) -> Session<Box<dyn Game>> {
    let settings = Settings { spus: 2, ..Settings::default() };
    let picture = Memory::new(Geometry::new(size.0, size.1).unwrap()).unwrap();
    Session::start((find(name).unwrap().new)(), settings, Box::new(picture))
        .unwrap()
        .with_seed(seed)
}

/// Runs frames without input.
fn run(session: &mut Session<Box<dyn Game>>, frames: u64) {
    let mut clock = FixedSteps(Duration::from_millis(40));
    session.run(Some(frames), &mut clock, &mut NoInput).unwrap();
}

/// Without a player, nothing moves and no tile is traced again, however long the frames take.
#[test]
fn table_at_rest_is_traced_once() {
    let mut clock = AnyTime(Xoshiro256PlusPlus::seed_from_u64(5));
    let mut session = session("billiards", 7, (32, 18));
    let report = session.run(Some(200), &mut clock, &mut NoInput).unwrap();
    assert_eq!((report.frames, report.frames_traced), (200, 1));
}

/// The world's checksum after some frames with this player.
fn played(name: &str, seed: u64, player: u64) -> u64 {
    let mut clock = AnyTime(Xoshiro256PlusPlus::seed_from_u64(player + 1000));
    let mut player = Anyone { rng: Xoshiro256PlusPlus::seed_from_u64(player), begun: false };
    let mut session = session(name, seed, (32, 18));
    let frames = rounds(75);
    let report = session.run(Some(u64::from(frames)), &mut clock, &mut player).unwrap();
    assert_eq!(report.frames, frames);
    session.world().checksum()
}

#[test]
fn every_game_is_deterministic_for_any_input() {
    for game in GAMES {
        let first = played(game.name, 1, 2);
        assert_eq!(played(game.name, 1, 2), first, "{}", game.name);
        assert_ne!(played(game.name, 1, 3), first, "{}", game.name);
    }
}

#[test]
fn different_seeds_give_different_worlds() {
    for game in GAMES {
        let world = |seed| {
            let mut session = session(game.name, seed, (32, 18));
            run(&mut session, 2);
            session.world().checksum()
        };
        assert_ne!(world(1), world(2), "{}", game.name);
    }
}

#[test]
fn frames_allocate_no_memory() {
    for game in GAMES {
        let mut session = session(game.name, 1, (48, 27));
        run(&mut session, 10);
        for frame in 0..40 {
            let asked = allocations::during(|| run(&mut session, 1));
            assert!(asked.is_empty(), "{}, frame {frame}: {}", game.name, asked[0]);
        }
    }
}

#[test]
fn games_are_found_by_name() {
    for game in GAMES {
        assert_eq!((game.new)().name(), game.name);
        assert!(!game.line.is_empty() && !(game.new)().controls().is_empty());
    }
    assert!(find("chess").is_none());
}
