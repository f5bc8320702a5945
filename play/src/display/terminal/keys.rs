//! The keys of a terminal.
//!
//! Terminals with the kitty protocol report releases. Others only repeat a key while it is held,
//! so a key counts as released when it was not repeated for a while. The pause before the first
//! repetition is longer than that, so a held key is released once for a moment.

use std::time::{Duration, Instant};

use cellray::game::{InputEvent, Key};
use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers, ModifierKeyCode};

/// How long a key counts as held if it is not repeated.
const HELD: Duration = Duration::from_millis(150);

#[derive(Debug, Default)]
pub struct Keys {
    held: Vec<(Key, Instant)>,
    /// Whether the terminal has reported a release, which means that it reports all of them.
    reports_releases: bool,
}

impl Keys {
    /// Converts an event that the terminal has reported at `now`, and calls `input` with the
    /// results.
    pub fn take(&mut self, event: KeyEvent, now: Instant, input: &mut impl FnMut(InputEvent)) {
        let is_release = event.kind == KeyEventKind::Release;
        self.reports_releases |= is_release;
        let modifiers = [
            (KeyModifiers::SHIFT, Key::Shift),
            (KeyModifiers::CONTROL, Key::Control),
            (KeyModifiers::ALT, Key::Alt),
        ];
        // Terminals that report releases report these keys themselves.
        if !self.reports_releases {
            for (modifier, key) in modifiers {
                if event.modifiers.contains(modifier) {
                    self.press(key, now, input);
                }
            }
        }
        let Some(key) = key(event.code) else {
            return;
        };
        if is_release {
            self.held.retain(|(held, _)| *held != key);
            input(InputEvent::Key { key, down: false });
        } else {
            self.press(key, now, input);
        }
    }

    /// Releases the keys that were not repeated in time.
    pub fn release_silent(&mut self, now: Instant, input: &mut impl FnMut(InputEvent)) {
        if self.reports_releases {
            return;
        }
        self.held.retain(|&(key, last)| {
            let is_held = now.saturating_duration_since(last) < HELD;
            if !is_held {
                input(InputEvent::Key { key, down: false });
            }
            is_held
        });
    }

    /// Forgets the held keys, because the terminal has lost the focus.
    pub fn forget(&mut self) {
        self.held.clear();
    }

    fn press(&mut self, key: Key, now: Instant, input: &mut impl FnMut(InputEvent)) {
        // Several events come together after a long frame, with silence between them.
        self.release_silent(now, input);
        match self.held.iter_mut().find(|(held, _)| *held == key) {
            Some((_, last)) => *last = now,
            None => {
                self.held.push((key, now));
                input(InputEvent::Key { key, down: true });
            }
        }
    }
}

/// The key, if games have a name for it. Both letters that are printed on a key give that key.
fn key(code: KeyCode) -> Option<Key> {
    Some(match code {
        KeyCode::Char(letter) => return of_letter(letter),
        KeyCode::Enter => Key::Enter,
        KeyCode::Tab | KeyCode::BackTab => Key::Tab,
        KeyCode::Backspace => Key::Backspace,
        KeyCode::Esc => Key::Escape,
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::Left => Key::Left,
        KeyCode::Right => Key::Right,
        KeyCode::Insert => Key::Insert,
        KeyCode::Delete => Key::Delete,
        KeyCode::Home => Key::Home,
        KeyCode::End => Key::End,
        KeyCode::PageUp => Key::PageUp,
        KeyCode::PageDown => Key::PageDown,
        KeyCode::F(number @ 1..=12) => FUNCTION[usize::from(number - 1)],
        KeyCode::Modifier(ModifierKeyCode::LeftShift | ModifierKeyCode::RightShift) => Key::Shift,
        KeyCode::Modifier(ModifierKeyCode::LeftControl | ModifierKeyCode::RightControl) => {
            Key::Control
        }
        KeyCode::Modifier(ModifierKeyCode::LeftAlt | ModifierKeyCode::RightAlt) => Key::Alt,
        _ => return None,
    })
}

const FUNCTION: [Key; 12] = [
    Key::F1,
    Key::F2,
    Key::F3,
    Key::F4,
    Key::F5,
    Key::F6,
    Key::F7,
    Key::F8,
    Key::F9,
    Key::F10,
    Key::F11,
    Key::F12,
];

/// The letters of each key on a US keyboard.
const LETTERS: [(&str, Key); 48] = [
    ("aA", Key::A),
    ("bB", Key::B),
    ("cC", Key::C),
    ("dD", Key::D),
    ("eE", Key::E),
    ("fF", Key::F),
    ("gG", Key::G),
    ("hH", Key::H),
    ("iI", Key::I),
    ("jJ", Key::J),
    ("kK", Key::K),
    ("lL", Key::L),
    ("mM", Key::M),
    ("nN", Key::N),
    ("oO", Key::O),
    ("pP", Key::P),
    ("qQ", Key::Q),
    ("rR", Key::R),
    ("sS", Key::S),
    ("tT", Key::T),
    ("uU", Key::U),
    ("vV", Key::V),
    ("wW", Key::W),
    ("xX", Key::X),
    ("yY", Key::Y),
    ("zZ", Key::Z),
    ("0)", Key::Digit0),
    ("1!", Key::Digit1),
    ("2@", Key::Digit2),
    ("3#", Key::Digit3),
    ("4$", Key::Digit4),
    ("5%", Key::Digit5),
    ("6^", Key::Digit6),
    ("7&", Key::Digit7),
    ("8*", Key::Digit8),
    ("9(", Key::Digit9),
    ("`~", Key::Backquote),
    ("-_", Key::Minus),
    ("=+", Key::Equal),
    ("[{", Key::BracketLeft),
    ("]}", Key::BracketRight),
    ("\\|", Key::Backslash),
    (";:", Key::Semicolon),
    ("'\"", Key::Quote),
    (",<", Key::Comma),
    (".>", Key::Period),
    ("/?", Key::Slash),
    (" ", Key::Space),
];

fn of_letter(letter: char) -> Option<Key> {
    let found = LETTERS.iter().find(|(letters, _)| letters.contains(letter));
    found.map(|&(_, key)| key)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn downs_of(
        keys: &mut Keys,
        code: KeyCode,
        kind: KeyEventKind,
        now: Instant,
    ) -> Vec<(Key, bool)> {
        let mut events = Vec::new();
        let event = KeyEvent::new_with_kind(code, KeyModifiers::NONE, kind);
        keys.take(event, now, &mut |event| events.push(event));
        downs(events)
    }

    fn release_silent(keys: &mut Keys, now: Instant) -> Vec<(Key, bool)> {
        let mut events = Vec::new();
        keys.release_silent(now, &mut |event| events.push(event));
        downs(events)
    }

    fn downs(events: Vec<InputEvent>) -> Vec<(Key, bool)> {
        let down = |event| match event {
            InputEvent::Key { key, down } => (key, down),
            other => panic!("{other:?}"),
        };
        events.into_iter().map(down).collect()
    }

    #[test]
    fn key_without_repeats_is_released() {
        let (mut keys, start) = (Keys::default(), Instant::now());
        let at = |millis| start + Duration::from_millis(millis);
        let press = KeyEventKind::Press;
        assert_eq!(downs_of(&mut keys, KeyCode::Char('a'), press, at(0)), [(Key::A, true)]);
        assert_eq!(downs_of(&mut keys, KeyCode::Char('A'), press, at(100)), []);
        assert_eq!(release_silent(&mut keys, at(200)), []);
        assert_eq!(release_silent(&mut keys, at(250)), [(Key::A, false)]);
        assert_eq!(release_silent(&mut keys, at(900)), []);
        assert_eq!(downs_of(&mut keys, KeyCode::Up, press, at(950)), [(Key::Up, true)]);
    }

    #[test]
    fn key_without_repeats_in_long_frame_is_pressed_again() {
        let (mut keys, start) = (Keys::default(), Instant::now());
        let press = KeyEventKind::Press;
        downs_of(&mut keys, KeyCode::F(12), press, start);
        let later = start + HELD;
        assert_eq!(
            downs_of(&mut keys, KeyCode::F(12), press, later),
            [(Key::F12, false), (Key::F12, true)]
        );
        assert_eq!(release_silent(&mut keys, later), []);
    }

    #[test]
    fn reported_releases_are_used() {
        let (mut keys, start) = (Keys::default(), Instant::now());
        let (press, release) = (KeyEventKind::Press, KeyEventKind::Release);
        downs_of(&mut keys, KeyCode::Left, press, start);
        assert_eq!(downs_of(&mut keys, KeyCode::Left, release, start), [(Key::Left, false)]);
        downs_of(&mut keys, KeyCode::Left, press, start);
        assert_eq!(release_silent(&mut keys, start + Duration::from_secs(9)), []);
        assert_eq!(downs_of(&mut keys, KeyCode::Left, release, start), [(Key::Left, false)]);
    }

    #[test]
    fn key_held_at_focus_loss_is_pressed_again() {
        let (mut keys, now) = (Keys::default(), Instant::now());
        let (press, release) = (KeyEventKind::Press, KeyEventKind::Release);
        downs_of(&mut keys, KeyCode::Up, press, now);
        downs_of(&mut keys, KeyCode::Up, release, now);
        downs_of(&mut keys, KeyCode::Left, press, now);
        keys.forget();
        assert_eq!(downs_of(&mut keys, KeyCode::Left, press, now), [(Key::Left, true)]);
    }

    #[test]
    fn each_letter_has_one_key() {
        let all: String = LETTERS.iter().map(|(letters, _)| *letters).collect();
        assert!((' '..='~').all(|letter| all.matches(letter).count() == 1));
        assert_eq!(of_letter('é'), None);
    }
}
