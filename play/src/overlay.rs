//! The overlay over the picture: speed, each SPU's load, and skipped work.

/// The content of the overlay.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    /// Lines of text.
    pub lines: Vec<String>,
    /// For each SPU the part of the frame's time in which it was at work, 0 to 1.
    pub loads: Vec<f32>,
    /// A message that is shown for a while.
    pub message: Option<String>,
}

impl Overlay {
    /// All of it in one line, for displays with only text. The most important part comes first,
    /// because the line may be cut off.
    #[must_use]
    pub fn line(&self) -> String {
        let loads: Vec<_> = self
            .loads
            .iter()
            .map(|load| format!("{:.0}", 100.0 * load))
            .collect();
        let loads = format!("SPUs {} %", loads.join(" "));
        let news = self.message.iter().map(String::as_str);
        let numbers = self.lines.iter().map(String::as_str);
        let all: Vec<_> = news.chain([loads.as_str()]).chain(numbers).collect();
        all.join("  ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_line_has_it_all() {
        let overlay = Overlay {
            lines: vec!["12 frames/s".into(), "64x48".into()],
            loads: vec![0.25, 1.0],
            message: None,
        };
        assert_eq!(overlay.line(), "SPUs 25 100 %  12 frames/s  64x48");
        let overlay = Overlay {
            message: Some("pad 1 is gone".into()),
            ..overlay
        };
        assert_eq!(
            overlay.line(),
            "pad 1 is gone  SPUs 25 100 %  12 frames/s  64x48"
        );
    }
}
