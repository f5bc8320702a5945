//! Sessions: running, recording and replaying them.

use std::cell::RefCell;
use std::io::{self, Write};
use std::ops::ControlFlow;
use std::rc::Rc;

use crate::prelude::*;
use cellray::game::{
    Axis, Clock, DVec3, FixedSteps, Frame, Game, InputEvent, InputSource, Key, NoInput, PadId,
    RealTime, Recording, RecordingError, Session, SessionError, Start,
};
use cellray::scene::Look;

const FRAMES: u64 = 40;

/// A ball that the player steers and random pushes move.
struct Driven {
    random: ChaCha8Rng,
    ball: ObjectId,
    place: DVec3,
    /// The frame from which on it behaves differently, for a recording that does not match.
    odd_from: u64,
    over_at: u64,
}

impl Driven {
    fn new() -> Self {
        Self {
            random: ChaCha8Rng::seed_from_u64(0),
            ball: ObjectId::default(),
            place: DVec3::ZERO,
            odd_from: u64::MAX,
            over_at: u64::MAX,
        }
    }
}

impl Game for Driven {
    fn name(&self) -> &str {
        "driven"
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        // As games do whose world is in a file.
        *world = World::new();
        self.random = ChaCha8Rng::seed_from_u64(start.seed);
        world.add_light(Light::at(DVec3::new(3.0, 9.0, 9.0)))?;
        let wide = f64::from(start.size.0) / f64::from(start.size.1);
        let red = world.add_material(Material::shiny(0.9, 0.2, wide / 10.0))?;
        self.ball = world.add_sphere(DVec3::ZERO, 0.7, red)?;
        world.add_sphere(DVec3::new(1.0, 1.0, -2.0), 0.7, red)?;
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let input = frame.input;
        let push = f64::from(input.key_axis(Key::Left, Key::Right));
        let lift = input.pad().map_or(0.0, |pad| f64::from(pad.axis(Axis::LeftY)));
        let chance = self.random.random_range(-0.1..0.1);
        self.place += DVec3::new(push, lift, chance) * frame.delta;
        if frame.number >= self.odd_from {
            self.place.x += 1e-9;
        }
        self.over_at =
            self.over_at.min(if input.key_pressed(Key::Escape) { frame.number } else { u64::MAX });
        world.move_to(self.ball, self.place * (1.0 + 0.01 * frame.time))
    }

    fn is_over(&self) -> bool {
        self.over_at < u64::MAX
    }
}

/// Generates random input.
struct Player(ChaCha8Rng);

impl InputSource for Player {
    fn poll(&mut self, events: &mut Vec<InputEvent>) -> io::Result<ControlFlow<()>> {
        let random = &mut self.0;
        let pad = PadId(0);
        match random.random_range(0..5) {
            0 => events.push(InputEvent::Key { key: Key::Right, down: random.random() }),
            1 => events.push(InputEvent::PadAxis {
                pad,
                axis: Axis::LeftY,
                value: random.random_range(-1.0..1.0),
            }),
            2 => events.push(InputEvent::PadConnected { pad, name: "\"pad\"\n".into() }),
            // NaN is ignored and not recorded.
            3 => events.push(InputEvent::PadAxis { pad, axis: Axis::LeftY, value: f32::NAN }),
            _ => {}
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// Steps of random lengths.
struct Unsteady(ChaCha8Rng);

impl Clock for Unsteady {
    fn tick(&mut self) -> Duration {
        Duration::from_nanos(self.0.random_range(0..100_000_000))
    }
}

#[derive(Clone, Default)]
struct Shared(Rc<RefCell<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn start(game: Driven, size: (u32, u32)) -> (Session<Driven>, Snapshot) {
    let (framebuffer, shown) = Recorder::pair(size.0, size.1);
    let settings = Settings { spus: 2, ..Settings::default() };
    (Session::start(game, settings, framebuffer).unwrap(), shown)
}

/// A clock for sessions that get the time from a recording.
const NO_TIME: FixedSteps = FixedSteps(Duration::ZERO);

fn pictures(
    session: &mut Session<Driven>,
    shown: &Snapshot,
    clock: &mut dyn Clock,
    input: &mut dyn InputSource,
) -> Vec<RgbImage> {
    let mut pictures = Vec::new();
    while pictures.len() < FRAMES as usize && session.frame(clock, input).unwrap().is_continue() {
        pictures.extend(shown.lock().unwrap().take());
    }
    pictures
}

/// The pictures of a session that is completely determined by a recording.
fn replayed(session: &mut Session<Driven>, shown: &Snapshot) -> Vec<RgbImage> {
    pictures(session, shown, &mut { NO_TIME }, &mut NoInput)
}

/// A session with random input, and its recording.
fn recorded() -> (Vec<RgbImage>, Vec<u8>) {
    let random = ChaCha8Rng::seed_from_u64;
    let bytes = Shared::default();
    let (session, shown) = start(Driven::new(), (64, 32));
    let mut session = session.with_seed(77).record_to(Box::new(bytes.clone()));
    let (mut clock, mut input) = (Unsteady(random(2)), Player(random(1)));
    let pictures = pictures(&mut session, &shown, &mut clock, &mut input);
    assert_eq!(pictures.len(), FRAMES as usize);
    drop(session);
    (pictures, bytes.0.take())
}

fn open(bytes: &[u8]) -> Result<Recording, RecordingError> {
    Recording::read(io::Cursor::new(bytes.to_vec()))
}

fn replay(game: Driven, bytes: &[u8]) -> (Session<Driven>, Snapshot) {
    let (session, shown) = start(game, (64, 32));
    (session.replaying(open(bytes).unwrap()).unwrap(), shown)
}

#[test]
fn recorded_session_is_replayed_bit_for_bit() {
    let (expected, bytes) = recorded();
    assert!(expected.windows(2).any(|pair| pair[0] != pair[1]));
    let again = Shared::default();
    let (session, shown) = replay(Driven::new(), &bytes);
    let mut session = session.record_to(Box::new(again.clone()));
    assert!(replayed(&mut session, &shown) == expected);
    // The session is over after the last frame.
    let after = session.frame(&mut { NO_TIME }, &mut NoInput);
    assert!(after.unwrap().is_break());
    drop(session);
    assert_eq!(String::from_utf8(again.0.take()), String::from_utf8(bytes));
}

#[test]
fn recording_is_played_back_antialiased_by_any_number_of_spus() {
    let (_, bytes) = recorded();
    let looked_at = |look, spus| {
        let (framebuffer, shown) = Recorder::pair(64, 36);
        let settings = Settings { spus, ..Settings::default() };
        let session = Session::start(Driven::new(), settings, framebuffer).unwrap();
        let mut session = session.replaying(open(&bytes).unwrap()).unwrap();
        session.set_look(look);
        replayed(&mut session, &shown)
    };
    let smooth = Some(Look::default());
    let one = looked_at(smooth, 1);
    assert_eq!(one.len(), FRAMES as usize);
    assert!(looked_at(smooth, 6) == one);
    // The look is not the game's.
    let plain = looked_at(None, 6);
    assert!(one.iter().zip(&plain).all(|(one, plain)| one != plain));
}

#[test]
fn recording_is_played_back_in_another_size() {
    let (_, bytes) = recorded();
    let (session, shown) = start(Driven::new(), (96, 64));
    let mut session = session.replaying(open(&bytes).unwrap()).unwrap();
    // The world equals the recorded one, because the replay compares their checksums.
    let pictures = replayed(&mut session, &shown);
    assert_eq!(pictures.len(), FRAMES as usize);
    assert_eq!(pictures[0].dimensions(), (96, 64));
}

#[test]
fn diverging_game_is_detected() {
    let (_, bytes) = recorded();
    let odd = Driven { odd_from: 20, ..Driven::new() };
    let (mut session, _) = replay(odd, &bytes);
    let error = session.run(None, &mut { NO_TIME }, &mut NoInput).unwrap_err();
    // The world is compared every 16 frames.
    assert!(matches!(error, SessionError::Diverged { frame: 32 }), "{error}");
}

#[test]
fn recording_of_other_game_is_refused() {
    let header =
        r#"{"format":"cellray recording","version":1,"game":"other","seed":0,"size":[4,4]}"#;
    let (session, _) = start(Driven::new(), (64, 32));
    let recording = open(format!("{header}\n").as_bytes()).unwrap();
    let error = session.replaying(recording).err().unwrap();
    assert!(matches!(error, SessionError::OtherGame { .. }), "{error}");
}

#[test]
fn invalid_recording_is_refused() {
    let header = |version: &str| {
        format!(
            "{{\"format\":\"cellray recording\",\"version\":{version},\"game\":\"driven\",\"seed\":0,\"size\":[4,4]}}\n"
        )
    };
    for text in ["", "\n", "{}\n", "[1]\n", "v 1\n", "{\"format\":\"png\"}\n"] {
        let error = open(text.as_bytes()).err().unwrap();
        assert!(matches!(error, RecordingError::Format), "{text:?}: {error}");
    }
    assert!(matches!(open(header("2").as_bytes()), Err(RecordingError::Version(2))));
    assert!(matches!(open(header("\"1\"").as_bytes()), Err(RecordingError::Line { line: 1, .. })));
    assert!(matches!(
        open(header("1").trim_end().as_bytes()),
        Err(RecordingError::CutOff { line: 1 })
    ));
    let endless = "x".repeat(3 << 20);
    for (line, expected) in [
        ("{\"step\":1}", "line 2: it does not end within"),
        ("{\"step\":-1}\n", "line 2"),
        ("{\"step\":1,\"what\":2}\n", "what"),
        ("{\"step\":1,\"events\":[{\"key\":{\"key\":\"no-such\",\"down\":true}}]}\n", "no-such"),
        ("{\"step\":1,\"world\":\"xyz\"}\n", "line 2"),
        (&endless, "does not end"),
    ] {
        let (mut session, _) = replay(Driven::new(), (header("1") + line).as_bytes());
        let error = session.run(None, &mut { NO_TIME }, &mut NoInput);
        let error = error.unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn finished_game_ends_session() {
    struct Quitter(u32);
    impl InputSource for Quitter {
        fn poll(&mut self, events: &mut Vec<InputEvent>) -> io::Result<ControlFlow<()>> {
            self.0 += 1;
            if self.0 == 3 {
                events.push(InputEvent::Key { key: Key::Escape, down: true });
            }
            Ok(ControlFlow::Continue(()))
        }
    }
    let (mut session, _) = start(Driven::new(), (64, 32));
    let mut clock = FixedSteps(Duration::from_millis(10));
    let report = session.run(None, &mut clock, &mut Quitter(0)).unwrap();
    assert_eq!(report.frames, 3);
}

#[test]
fn end_or_failure_of_input_ends_the_session() {
    struct Ends(bool);
    impl InputSource for Ends {
        fn poll(&mut self, _: &mut Vec<InputEvent>) -> io::Result<ControlFlow<()>> {
            if self.0 {
                return Err(io::Error::other("unplugged"));
            }
            Ok(ControlFlow::Break(()))
        }
    }
    let (mut session, _) = start(Driven::new(), (64, 32));
    let mut clock = RealTime::default();
    let report = session.run(None, &mut clock, &mut Ends(false)).unwrap();
    assert_eq!(report.frames, 0);
    let error = session.run(None, &mut clock, &mut Ends(true)).unwrap_err();
    assert!(error.to_string().contains("unplugged"), "{error}");
}

/// The size may change during a game. The game and its replay see the change.
#[test]
fn session_moves_to_another_framebuffer() {
    let bytes = Shared::default();
    let (session, _) = start(Driven::new(), (64, 32));
    let mut clock = FixedSteps(Duration::from_millis(10));
    let mut session = session.record_to(Box::new(bytes.clone()));
    let mut run = |session: &mut Session<Driven>, frames| {
        session.run(Some(frames), &mut clock, &mut NoInput).unwrap();
    };
    run(&mut session, 2);
    let larger = Memory::new(Geometry::new(320, 200).unwrap()).unwrap();
    let before = session.show_on(Box::new(larger)).unwrap();
    assert_eq!(before.geometry(), Geometry::new(64, 32).unwrap());
    // The whole first frame is traced on the new framebuffer.
    run(&mut session, 1);
    assert_eq!(session.engine().statistics().primary_rays(), 320 * 200);
    // The second one keeps what the rays have crossed, so the third traces less.
    run(&mut session, 2);
    assert!(session.engine().statistics().primary_rays() < 320 * 200);
    drop(session);
    let text = String::from_utf8(bytes.0.take()).unwrap();
    let sizes = text.lines().skip(1).map(|line| line.contains("[320,200]"));
    assert_eq!(sizes.collect::<Vec<_>>(), [false, false, true, true, true]);
}
