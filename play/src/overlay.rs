//! What is said over the picture: speed, each SPU's load, work that was saved.

/// What is said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    /// Lines of text.
    pub lines: Vec<String>,
    /// Part of the frame's time that each SPU was at work in, 0 to 1.
    pub loads: Vec<f32>,
    /// News, for a while.
    pub message: Option<String>,
}

impl Overlay {
    /// All of it in one line, for where there are letters alone; what matters most first, as the
    /// line may be cut.
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
