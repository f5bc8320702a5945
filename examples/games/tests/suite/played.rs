//! Replays a recorded game of eight-ball to its end. `MAKE_REF=1` plays and records another.

mod player;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::time::Duration;

use cellray::Settings;
use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{FixedSteps, NoInput, Recording, Session};
use games::billiards::Billiards;

use player::Player;

/// The maximum length of a game in frames.
const LONGEST: u64 = 20_000;
/// The time between frames of a game that is being recorded.
const STEP: Duration = Duration::from_millis(250);

fn kept(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/played").join(name)
}

fn session() -> Session<Billiards> {
    let settings = Settings { spus: 1, ..Settings::default() };
    let picture = Memory::new(Geometry::new(16, 8).unwrap()).unwrap();
    Session::start(Billiards::default(), settings, Box::new(picture)).unwrap()
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
    let mut session = session()
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
    let mut session = session().replaying(Recording::open(&recording).unwrap()).unwrap();
    let mut clock = FixedSteps(Duration::ZERO);
    session.run(Some(LONGEST), &mut clock, &mut NoInput).unwrap();
    let game = session.game();
    assert_eq!(end(game), fs::read_to_string(&ended).unwrap());
    assert!(game.rules().winner().is_some(), "nobody has won");
}
