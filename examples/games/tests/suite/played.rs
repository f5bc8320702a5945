//! Replays a recorded game of eight-ball, recorded walks, waves and a flight to their ends.
//! `MAKE_REF=1` plays and records others.

mod player;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::time::Duration;

use cellray::Settings;
use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{FixedSteps, Game, InputEvent, Key, NoInput, Recording, Session};
use games::billiards::Billiards;
use games::flight::Flight;
use games::station::Station;
use games::waves::Waves;

use crate::station::freedoom;
use crate::walker::Walker;
use player::Player;

/// The maximum length of a game in frames.
const LONGEST: u64 = 20_000;
/// The time between frames of a game that is being recorded.
const STEP: Duration = Duration::from_millis(250);
/// The same in a walk.
const STRIDE: Duration = Duration::from_millis(50);

pub fn kept(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/played").join(name)
}

pub fn session<G: Game>(game: G) -> Session<G> {
    let settings = Settings { spus: 1, ..Settings::default() };
    let picture = Memory::new(Geometry::new(16, 8).unwrap()).unwrap();
    Session::start(game, settings, Box::new(picture)).unwrap()
}

/// The exact positions of all balls, and the winner.
fn end(game: &Billiards) -> String {
    let mut text = String::new();
    for ball in game.balls() {
        let place = ball.body.centre.to_array().map(f64::to_bits);
        writeln!(text, "{} {place:016x?} {:?}", ball.number, ball.place).unwrap();
    }
    writeln!(text, "won by {:?}", game.rules().winner()).unwrap();
    text
}

/// Plays a game with the mouse and records it.
fn make(recording: &Path, ended: &Path) {
    fs::create_dir_all(kept("")).unwrap();
    let file = BufWriter::new(File::create(recording).unwrap());
    let mut player = Player::default();
    let mut session = session(Billiards::default())
        // Balls of both groups were pocketed, and one is left when the eight falls.
        .with_seed(6)
        .record_to(Box::new(file));
    for _ in 0..LONGEST {
        let flow = session.step(STEP, &mut player.next(), &mut |_| ());
        assert!(flow.unwrap().is_continue());
        if session.game().rules().winner().is_some() {
            break;
        }
        player.look(session.game());
    }
    fs::write(ended, end(session.game())).unwrap();
}

#[test]
fn replayed_game_has_same_end() {
    let (recording, ended) = (kept("billiards.jsonl"), kept("billiards.txt"));
    if std::env::var_os("MAKE_REF").is_some() {
        make(&recording, &ended);
    }
    let mut session =
        session(Billiards::default()).replaying(Recording::open(&recording).unwrap()).unwrap();
    let mut clock = FixedSteps(Duration::ZERO);
    session.run(Some(LONGEST), &mut clock, &mut NoInput).unwrap();
    let game = session.game();
    assert_eq!(end(game), fs::read_to_string(&ended).unwrap());
    assert!(game.rules().winner().is_some(), "nobody has won");
}

/// The exact place of the walker, and what it has found.
fn end_of_walk(game: &Station) -> String {
    let place = [game.place().x, game.place().y, game.feet(), game.turn()].map(f64::to_bits);
    format!("{place:016x?} {}, at the exit: {}\n", game.status(), game.has_ended())
}

/// Walks towards what is to be found and to the exit, or to whatever lies in a map.
fn make_walk(game: Station, longest: u64, recording: &Path, ended: &Path) {
    let file = BufWriter::new(File::create(recording).unwrap());
    let mut session = session(game).with_seed(0).record_to(Box::new(file));
    let mut walker = None;
    // The first frame sets the game up.
    let mut events = Vec::new();
    for _ in 0..longest {
        if session.step(STRIDE, &mut events, &mut |_| ()).unwrap().is_break() {
            break;
        }
        let game = session.game();
        let has_all = longest == LONGEST;
        let walker = walker
            .get_or_insert_with(|| if has_all { Walker::default() } else { Walker::tour(game) });
        events = walker.next(game);
    }
    fs::write(ended, end_of_walk(session.game())).unwrap();
}

/// The recording of E1M1 is one of the maps of Freedoom 0.12.1, the version of Debian 12.
#[test]
fn replayed_walks_have_same_end() {
    let e1m1 = || Station::open(&freedoom("freedoom1.wad"), Some("E1M1")).unwrap();
    let own: (&str, fn() -> Station, u64) = ("station", Station::default, LONGEST);
    for (name, game, longest) in [own, ("e1m1", e1m1, 620)] {
        let [recording, ended] = ["jsonl", "txt"].map(|it| kept(name).with_extension(it));
        if std::env::var_os("MAKE_REF").is_some() {
            make_walk(game(), longest, &recording, &ended);
        }
        let recording = Recording::open(&recording).unwrap();
        let mut session = session(game()).replaying(recording).unwrap();
        let mut clock = FixedSteps(Duration::ZERO);
        session.run(Some(LONGEST), &mut clock, &mut NoInput).unwrap();
        assert_eq!(end_of_walk(session.game()), fs::read_to_string(&ended).unwrap());
        assert_eq!(session.game().has_ended(), longest == LONGEST, "{name}");
    }
}

/// Frames of waves, and the time between them.
const FRAMES: u64 = 100;
const WAVE: Duration = Duration::from_millis(40);
/// The keys that the player of waves presses and releases, by the frame.
const KEYS: &[(u64, Key, bool)] = &[
    (2, Key::Right, true),
    (14, Key::Up, true),
    (25, Key::Right, false),
    (30, Key::Space, true),
    (31, Key::Space, false),
    (40, Key::Up, false),
    (45, Key::Digit1, true),
    (46, Key::Digit1, false),
    (47, Key::Left, true),
];

/// The exact places of the balls, and the water's height at each.
fn end_of_waves(game: &Waves) -> String {
    let mut text = String::new();
    for body in game.bodies() {
        let height = game.height(body.centre.x, body.centre.z).to_bits();
        let place = body.centre.to_array().map(f64::to_bits);
        writeln!(text, "{place:016x?} {height:016x}").unwrap();
    }
    text
}

/// Plays for some frames with keys and records it.
fn make_keys<G: Game>(
    name: &str,
    game: G,
    (frames, step): (u64, Duration),
    keys: &[(u64, Key, bool)],
    end: fn(&G) -> String,
) {
    let file = BufWriter::new(File::create(kept(name).with_extension("jsonl")).unwrap());
    let mut session = session(game).with_seed(3).record_to(Box::new(file));
    for frame in 0..frames {
        let pressed = keys.iter().filter(|(number, ..)| *number == frame);
        let mut events = pressed.map(|&(_, key, down)| InputEvent::Key { key, down }).collect();
        let flow = session.step(step, &mut events, &mut |_| ());
        assert!(flow.unwrap().is_continue());
    }
    fs::write(kept(name).with_extension("txt"), end(session.game())).unwrap();
}

/// Replays a game that [`make_keys`] has recorded, and compares its end.
fn replayed<G: Game>(name: &str, game: G, end: fn(&G) -> String) -> Session<G> {
    let recording = Recording::open(&kept(name).with_extension("jsonl")).unwrap();
    let mut session = session(game).replaying(recording).unwrap();
    let mut clock = FixedSteps(Duration::ZERO);
    session.run(Some(LONGEST), &mut clock, &mut NoInput).unwrap();
    let expected = fs::read_to_string(kept(name).with_extension("txt")).unwrap();
    assert_eq!(end(session.game()), expected);
    session
}

/// The checksums in the recording are those of worlds whose mesh has other vertices in each frame.
#[test]
fn replayed_waves_have_same_end() {
    if std::env::var_os("MAKE_REF").is_some() {
        make_keys("waves", Waves::default(), (FRAMES, WAVE), KEYS, end_of_waves);
    }
    let mut session = replayed("waves", Waves::default(), end_of_waves);
    assert!(session.engine().made_blocks().is_some(), "no SPU has refitted the water");
}

/// The keys of a minute's flight: a rock, a turn over the lake, a dive, and back to the rings.
const FLIGHT: &[(u64, Key, bool)] = &[
    (20, Key::B, true),
    (21, Key::B, false),
    (95, Key::Left, true),
    (100, Key::Left, false),
    (101, Key::Up, true),
    (110, Key::Up, false),
    (110, Key::Down, true),
    (112, Key::Right, true),
    (118, Key::Down, false),
    (120, Key::Right, false),
    (121, Key::PageUp, true),
    (125, Key::PageUp, false),
    (130, Key::Space, true),
    (131, Key::Space, false),
];

/// The exact place of the plane, and the status.
fn end_of_flight(game: &Flight) -> String {
    format!("{:016x?} {}\n", game.place().to_array().map(f64::to_bits), game.status())
}

#[test]
fn replayed_minute_of_flight_has_same_end() {
    if std::env::var_os("MAKE_REF").is_some() {
        let minute = (300, Duration::from_millis(200));
        make_keys("flight", Flight::default(), minute, FLIGHT, end_of_flight);
    }
    let session = replayed("flight", Flight::default(), end_of_flight);
    assert!(session.game().met() > 3, "{} rings", session.game().met());
}
