//! Walks in levels without a display: anywhere by chance, and to the exit by a plan.

use std::path::{Path, PathBuf};

use cellray::game::{Frame, Game, Input, InputEvent, Key, Random, Start, World};
use games::station::Station;
use glam::DVec2;
use randomness::rounds;

use crate::walker::Walker;

/// Frames a second.
const RATE: u32 = 30;
/// Maps of different kinds: small and large, indoors and outdoors.
const MAPS: [(&str, &str); 10] = [
    ("freedoom1.wad", "E1M1"),
    ("freedoom1.wad", "E1M2"),
    ("freedoom1.wad", "E1M5"),
    ("freedoom1.wad", "E2M3"),
    ("freedoom1.wad", "E3M1"),
    ("freedoom1.wad", "E4M7"),
    ("freedoom2.wad", "MAP01"),
    ("freedoom2.wad", "MAP07"),
    ("freedoom2.wad", "MAP12"),
    ("freedoom2.wad", "MAP27"),
];

/// The path of a file of Freedoom, which `ci/setup` installs.
pub fn freedoom(file: &str) -> PathBuf {
    let path = Path::new("/usr/share/games/doom").join(file);
    assert!(path.exists(), "no {}: run ci/setup", path.display());
    path
}

/// A game, and its frames.
struct Play {
    game: Station,
    world: World,
    input: Input,
    frame: u64,
}

impl Play {
    fn new(game: Station, seed: u64) -> Self {
        let mut play = Self { game, world: World::new(), input: Input::default(), frame: 0 };
        let start = Start { seed, size: (320, 180) };
        play.game.set_up(&mut play.world, &start).unwrap();
        play
    }

    fn frame(&mut self, events: &[InputEvent]) {
        self.input.begin_frame();
        events.iter().for_each(|event| self.input.apply(event));
        let delta = 1.0 / f64::from(RATE);
        let time = self.frame as f64 * delta;
        let number = self.frame;
        let size = (320, 180);
        let frame = Frame { number, time, delta, input: &self.input, size, last: None };
        self.game.update(&mut self.world, &frame).unwrap();
        self.frame += 1;
    }
}

/// Walks and runs anywhere, turns, and uses everything. Checks after each frame that the walker is
/// where it fits, and that it never stays within a few units for a third of a minute. Returns how
/// many sectors it has been in.
fn wander(name: &str, game: Station, minutes: u32) -> usize {
    let mut play = Play::new(game, 1);
    let mut chance = Random::new(7);
    let mut seen = vec![false; play.game.ground().map.sectors.len()];
    let window = 20 * RATE;
    let mut since = play.game.place();
    let mut farthest = 0.0_f64;
    play.frame(&[InputEvent::Key { key: Key::W, down: true }]);
    for frame in 1..minutes * 60 * RATE {
        let key = |key, down| InputEvent::Key { key, down };
        let mut events = Vec::new();
        match chance.below(60) {
            0..3 => events.push(key(Key::Left, true)),
            3..6 => events.push(key(Key::Right, true)),
            6..10 => events.extend([key(Key::Left, false), key(Key::Right, false)]),
            10..14 => events.push(key(Key::Space, true)),
            14..20 => events.push(key(Key::Space, false)),
            30 => events.push(key(Key::Shift, chance.below(2) == 0)),
            31 => events.push(key(Key::S, true)),
            32..36 => events.push(key(Key::S, false)),
            _ => {}
        }
        play.frame(&events);
        let (place, feet) = (play.game.place(), play.game.feet());
        let at = format!("{name}, frame {frame}, {place}, {feet}");
        let sector = play.game.ground().sector(place);
        seen[sector.unwrap_or_else(|| panic!("outside of the level: {at}")) as usize] = true;
        let floor = play.game.ground().stand(place, feet);
        assert_eq!(floor, Ok(feet), "{at}");
        farthest = farthest.max(place.distance(since));
        if frame % window == 0 {
            assert!(farthest > 4.0, "stuck: {at}");
            (since, farthest) = (place, 0.0);
        }
        if play.game.has_ended() {
            break;
        }
    }
    seen.iter().filter(|seen| **seen).count()
}

#[test]
fn random_walks_stay_in_level_and_go_on() {
    let minutes = rounds(1);
    println!("station: {} sectors seen", wander("station", Station::default(), minutes));
    for (file, map) in MAPS {
        let game = Station::open(&freedoom(file), Some(map)).unwrap();
        let sectors = wander(map, game, minutes);
        println!("{map}: {sectors} sectors seen");
        assert!(sectors > 1, "{map}");
    }
}

/// With any seed the crystals lie where one comes to, and the exit opens for whoever has them.
#[test]
fn exit_is_reached_with_any_seed() {
    for seed in 0..4 {
        let mut play = Play::new(Station::default(), seed);
        let mut walker = Walker::default();
        assert_eq!(play.game.status(), "0 of 3 found");
        while !play.game.has_ended() {
            assert!(play.frame < u64::from(4 * 60 * RATE), "{seed}: {}", play.game.place());
            let events = walker.next(&play.game);
            play.frame(&events);
        }
        assert_eq!(play.game.status(), "all found; go to the exit");
    }
}

/// The map has what the walker can see, and more after it has turned a corner.
#[test]
fn map_shows_what_was_seen() {
    let mut play = Play::new(Station::default(), 1);
    assert_eq!(play.game.automap().seen(), 0);
    let lines = play.game.ground().map.lines.len();
    // Each line is looked for at least once.
    (0..lines).for_each(|_| play.frame(&[]));
    let first = play.game.automap().seen();
    assert!(first > 3 && 2 * first < lines, "{first} of {lines}");
    let without = play.game.status();
    play.frame(&[InputEvent::Key { key: Key::Tab, down: true }]);
    let status = play.game.status();
    let map = status.strip_prefix(&without).unwrap();
    let rows: Vec<&str> = map.trim_start().lines().collect();
    assert_eq!(rows.len(), 22);
    let arrow = rows[11].chars().nth(22).unwrap();
    assert!("↑↗→↘↓↙←↖".contains(arrow), "{arrow}");
    let is_drawn = |letter: &char| ('\u{2801}'..='\u{28ff}').contains(letter);
    assert!(map.chars().filter(is_drawn).count() > 20, "{map}");
    let mut walker = Walker::default();
    for _ in 0..60 * RATE {
        let events = walker.next(&play.game);
        play.frame(&events);
    }
    assert!(play.game.automap().seen() > first, "{first}");
}

#[test]
fn exit_stays_closed_without_crystals() {
    let mut play = Play::new(Station::default(), 0);
    let mut walker = Walker::to(vec![DVec2::new(1590.0, 192.0)]);
    for _ in 0..90 * RATE {
        let events = walker.next(&play.game);
        play.frame(&events);
    }
    assert!(play.game.place().x > 1560.0, "{}", play.game.place());
    let press = |down| InputEvent::Key { key: Key::Space, down };
    play.frame(&[press(true)]);
    play.frame(&[press(false)]);
    assert!(!play.game.has_ended());
}

#[test]
fn wrong_levels_are_named() {
    let error = |path: &Path, map| match Station::open(path, map) {
        Ok(_) => "none".to_owned(),
        Err(error) => error.to_string(),
    };
    let text = error(Path::new("no-such.wad"), None);
    assert!(text.starts_with("no-such.wad: "), "{text}");
    let path = freedoom("freedoom1.wad");
    let text = error(&path, Some("E9M9"));
    assert!(text.contains("there is no map E9M9; the file has E1M1, E1M2"), "{text}");
}

/// Whoever walks into a portal comes out of the other one, as high above the floor, and goes on in
/// its direction there.
#[test]
fn portals_lead_from_niche_to_niche() {
    let mut play = Play::new(Station::default(), 3);
    let walked = |play: &mut Play, keys: [(Key, bool); 1]| {
        let events = keys.map(|(key, down)| InputEvent::Key { key, down });
        let before = play.game.place();
        play.frame(&events);
        play.game.place().distance(before)
    };
    // It turns to the south, and goes to the east until the niche is ahead.
    play.frame(&[]);
    while libm::sin(play.game.turn()).abs() > 0.02 || libm::cos(play.game.turn()) > 0.0 {
        play.frame(&[InputEvent::Key { key: Key::Right, down: true }]);
    }
    play.frame(&[InputEvent::Key { key: Key::Right, down: false }]);
    let begin = play.game.place();
    while play.game.place().x < 192.0 {
        walked(&mut play, [(Key::A, true)]);
    }
    walked(&mut play, [(Key::A, false)]);
    let mut longest = 0.0_f64;
    let mut frames = 0;
    while play.game.place().x < 900.0 {
        longest = longest.max(walked(&mut play, [(Key::W, true)]));
        frames += 1;
        assert!(frames < 300, "{begin} {}", play.game.place());
    }
    assert!(longest > 700.0, "{longest}");
    assert!((libm::cos(play.game.turn()) - 1.0).abs() < 1e-3, "{}", play.game.turn());
    let there = play.game.place();
    for _ in 0..30 {
        walked(&mut play, [(Key::W, true)]);
    }
    assert!(play.game.place().y > there.y + 50.0, "it goes on to the north");
    // Back again, backwards.
    walked(&mut play, [(Key::W, false)]);
    frames = 0;
    while play.game.place().x > 900.0 {
        walked(&mut play, [(Key::S, true)]);
        frames += 1;
        assert!(frames < 300, "{}", play.game.place());
    }
    assert!(play.game.place().y > -24.0);
}
