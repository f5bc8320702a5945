//! Chooses the text on the screen: speeds, the game's status, help, a pause, and a hint at the
//! start.
//!
//! Invariant: the notice of a pause or of the end is always shown, because nothing else shows why
//! the picture stands still.

use std::time::{Duration, Instant};

use cellray::game::{Game, PlacedLabel};

use crate::keys::KEYS;
use crate::overlay::{Line, Overlay};

/// The hint of the first seconds.
const HINT: &str = "H lists the keys, F1 shows statistics";
/// How long the hint is visible, including the time in which it fades.
const HINT_SECONDS: f32 = 6.0;
/// The time in which it fades.
const FADE_SECONDS: f32 = 1.5;
/// How long a message is visible.
const MESSAGE: Duration = Duration::from_secs(5);

/// How much text is shown besides help and notices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Level {
    /// The game's status, and messages.
    Game,
    /// Speeds as well.
    All,
    Nothing,
}

#[derive(Debug)]
pub struct Texts {
    /// When a picture was first shown.
    began: Option<Instant>,
    level: Level,
    has_help: bool,
    message: Option<(String, Instant)>,
}

impl Texts {
    /// The texts of a session: those of the game, or none.
    #[must_use]
    pub fn new(has_text: bool) -> Self {
        Self {
            began: None,
            level: if has_text { Level::Game } else { Level::Nothing },
            has_help: false,
            message: None,
        }
    }

    /// Shows more text, or none after all of it. `has_words` is whether the game has a status; for
    /// one without, there is no level of its status alone.
    pub fn change_level(&mut self, has_words: bool) {
        self.level = match self.level {
            Level::Game => Level::All,
            Level::All => Level::Nothing,
            Level::Nothing if has_words => Level::Game,
            Level::Nothing => Level::All,
        };
    }

    /// Shows the keys, or hides them.
    pub fn change_help(&mut self) {
        self.has_help = !self.has_help;
    }

    /// Shows a message for a while.
    pub fn show_message(&mut self, message: String, now: Instant) {
        self.message = Some((message, now));
    }

    /// The overlay with these speeds and loads, for a picture that is shown now.
    pub fn overlay(
        &mut self,
        (speeds, loads): (&[String], &[f32]),
        game: &dyn Game,
        labels: Vec<PlacedLabel>,
        notice: Option<&str>,
        now: Instant,
    ) -> Overlay {
        self.began.get_or_insert(now);
        let mut overlay = Overlay { notice: notice.map(str::to_owned), ..Overlay::default() };
        if self.has_help {
            overlay.help = help(game);
        }
        if self.level != Level::Nothing {
            overlay.message = self.message(now);
            overlay.status = game.status().lines().map(str::to_owned).collect();
            overlay.labels = labels;
        }
        if self.level == Level::All {
            overlay.speeds = speeds.to_vec();
            overlay.loads = loads.to_vec();
        }
        overlay
    }

    /// The last message while it is new, otherwise the hint at the start.
    fn message(&self, now: Instant) -> Option<(String, f32)> {
        if let Some((message, said)) = &self.message
            && now.saturating_duration_since(*said) < MESSAGE
        {
            return Some((message.clone(), 1.0));
        }
        let began = self.began.unwrap_or(now);
        let passed = now.saturating_duration_since(began).as_secs_f32();
        let opacity = ((HINT_SECONDS - passed) / FADE_SECONDS).min(1.0);
        (opacity > 0.0 && !self.has_help).then(|| (HINT.to_owned(), opacity))
    }
}

/// The keys of a game, and those of the player's program.
fn help(game: &dyn Game) -> Vec<Line> {
    let row = |keys: &str, what: &str| Line {
        text: format!("  {keys}: {what}"),
        emphasised: keys.chars().count() + 3,
    };
    let controls = game.controls().iter();
    let of_game = controls.map(|line| match line.split_once(": ") {
        Some((keys, what)) => row(keys, what),
        None => format!("  {line}").into(),
    });
    let mut lines = Vec::new();
    if !game.controls().is_empty() {
        lines.push(Line::heading(game.name()));
        lines.extend(of_game);
        lines.push(Line::default());
    }
    lines.push(Line::heading("everywhere"));
    lines.extend(KEYS.iter().map(|(keys, what)| row(keys, what)));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::game::{Frame, Side, Start, World, WorldError};

    struct Chess(&'static str);

    impl Game for Chess {
        fn name(&self) -> &str {
            "chess"
        }
        fn controls(&self) -> &[&str] {
            &["mouse: move a piece"]
        }
        fn status(&self) -> String {
            self.0.to_owned()
        }
        fn set_up(&mut self, _: &mut World, _: &Start) -> Result<(), WorldError> {
            Ok(())
        }
        fn update(&mut self, _: &mut World, _: &Frame<'_>) -> Result<(), WorldError> {
            Ok(())
        }
    }

    const WHITE: Chess = Chess("White's turn\n0 : 0");

    fn labels() -> Vec<PlacedLabel> {
        let side = Side::Over;
        let text = "king".to_owned();
        vec![PlacedLabel { text, place: [0.5; 2], side, colour: [255; 3] }]
    }

    fn shown(texts: &mut Texts, now: Instant) -> Overlay {
        let speeds = ["60 frames/s".to_owned()];
        texts.overlay((&speeds, &[0.5]), &WHITE, labels(), None, now)
    }

    #[test]
    fn levels_are_status_then_all_then_empty() {
        let now = Instant::now();
        let mut texts = Texts::new(true);
        let mut parts = || {
            let overlay = shown(&mut texts, now);
            texts.change_level(true);
            assert_eq!(overlay.labels.len(), overlay.status.len() / 2);
            (overlay.speeds.len(), overlay.loads.len(), overlay.status)
        };
        let status = vec!["White's turn".to_owned(), "0 : 0".to_owned()];
        assert_eq!(parts(), (0, 0, status.clone()));
        assert_eq!(parts(), (1, 1, status.clone()));
        assert_eq!(parts(), (0, 0, Vec::new()));
        assert_eq!(parts(), (0, 0, status));

        // A game without a status has no level for it.
        let mut texts = Texts::new(true);
        for speeds in [1, 0, 1, 0] {
            texts.change_level(false);
            assert_eq!(shown(&mut texts, now).speeds.len(), speeds);
        }
        assert_eq!(shown(&mut texts, now), Overlay::default());
    }

    #[test]
    fn first_text_is_one_line_hint() {
        let silent = Chess("");
        let now = Instant::now();
        let speeds = ["60 frames/s".to_owned()];
        let mut texts = Texts::new(true);
        let begun = texts.overlay((&speeds, &[0.5]), &silent, Vec::new(), None, now);
        let only_the_hint = Overlay { message: Some((HINT.to_owned(), 1.0)), ..Overlay::default() };
        assert_eq!(begun, only_the_hint);
        for key in ["H", "F1"] {
            assert!(KEYS.iter().any(|(keys, _)| *keys == key) && HINT.contains(key));
        }
    }

    #[test]
    fn empty_text_level_still_shows_pause_and_help() {
        let now = Instant::now();
        let mut texts = Texts::new(false);
        assert_eq!(shown(&mut texts, now), Overlay::default());
        let paused = texts.overlay((&[], &[]), &WHITE, labels(), Some("Paused"), now);
        assert_eq!(paused.notice.as_deref(), Some("Paused"));
        texts.change_help();
        let help = shown(&mut texts, now).help;
        assert_eq!(help[0], Line::heading("chess"));
        assert_eq!(help[1].text, "  mouse: move a piece");
        assert_eq!(help[1].emphasised, "  mouse:".len());
        assert!(KEYS.iter().all(|(keys, what)| {
            let row = format!("  {keys}: {what}");
            help.iter().any(|line| line.text == row)
        }));
        texts.change_help();
        assert_eq!(shown(&mut texts, now), Overlay::default());
    }

    #[test]
    fn hint_fades_and_messages_precede_it() {
        let began = Instant::now();
        let mut texts = Texts::new(true);
        let after = |seconds| began + Duration::from_secs_f32(seconds);
        let message = |texts: &mut Texts, seconds| shown(texts, after(seconds)).message;
        assert_eq!(message(&mut texts, 0.0), Some((HINT.to_owned(), 1.0)));
        let fading = message(&mut texts, HINT_SECONDS - FADE_SECONDS / 2.0);
        let (_, opacity) = fading.expect("a hint");
        assert!((opacity - 0.5).abs() < 0.01, "{opacity}");
        assert_eq!(message(&mut texts, HINT_SECONDS + 0.1), None);
        texts.show_message("pad 1 is gone".to_owned(), after(1.0));
        let news = Some(("pad 1 is gone".to_owned(), 1.0));
        assert_eq!(message(&mut texts, 5.9), news);
        assert_eq!(message(&mut texts, 6.1), None);
        // Who has the help open needs no hint.
        let mut texts = Texts::new(true);
        texts.change_help();
        assert_eq!(message(&mut texts, 1.0), None);
    }
}
