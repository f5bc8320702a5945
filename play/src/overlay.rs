//! The text over the picture: speeds and loads, the game's status, help, and short notices.

use cellray::game::PlacedLabel;

/// A line of text. Its beginning may be emphasised.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    pub text: String,
    /// The number of characters at the beginning that are emphasised.
    pub emphasised: usize,
}

impl Line {
    /// A line that is emphasised as a whole.
    pub fn heading(text: impl Into<String>) -> Self {
        let text = text.into();
        Self { emphasised: text.chars().count(), text }
    }

    /// The line without its indentation.
    #[must_use]
    pub fn flush(&self) -> Self {
        let text = self.text.trim_start();
        let indentation = self.text.len() - text.len();
        Self { text: text.to_owned(), emphasised: self.emphasised.saturating_sub(indentation) }
    }
}

impl<T: Into<String>> From<T> for Line {
    fn from(text: T) -> Self {
        Self { text: text.into(), emphasised: 0 }
    }
}

/// The content of the overlay. Empty parts are not shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    /// Speeds and sizes.
    pub speeds: Vec<String>,
    /// For each SPU the part of the frame's time in which it was at work, 0 to 1.
    pub loads: Vec<f32>,
    /// The game's status: the score, and whose turn it is.
    pub status: Vec<String>,
    /// The game's text at places of the picture.
    pub labels: Vec<PlacedLabel>,
    /// The keys.
    pub help: Vec<Line>,
    /// The reason why nothing moves.
    pub notice: Option<String>,
    /// A message that is shown for a while, and its opacity, 0 to 1.
    pub message: Option<(String, f32)>,
}

impl Overlay {
    /// Message, loads and speeds in one line, for displays with only text; `None` without any.
    /// The most important part comes first, because the line may be cut off.
    #[must_use]
    pub fn line(&self) -> Option<String> {
        let loads = self.loads.iter().map(|load| format!("{:.0}", 100.0 * load));
        let loads = loads.collect::<Vec<_>>().join(" ");
        let loads = (!loads.is_empty()).then(|| format!("SPUs {loads} %"));
        let message = self.message.as_ref().map(|(message, _)| message.clone());
        let all = message.into_iter().chain(loads);
        let all: Vec<_> = all.chain(self.speeds.iter().cloned()).collect();
        (!all.is_empty()).then(|| all.join("  "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlay_fits_one_line() {
        let overlay = Overlay {
            speeds: vec!["12 frames/s".into(), "64x48".into()],
            loads: vec![0.25, 1.0],
            ..Overlay::default()
        };
        let numbers = "SPUs 25 100 %  12 frames/s  64x48";
        assert_eq!(overlay.line().as_deref(), Some(numbers));
        let overlay = Overlay { message: Some(("pad 1 is gone".into(), 1.0)), ..overlay };
        let all = format!("pad 1 is gone  {numbers}");
        assert_eq!(overlay.line(), Some(all));
        let status = vec!["Blue's turn".into()];
        let without = Overlay { status, ..Overlay::default() };
        assert_eq!(without.line(), None);
    }
}
