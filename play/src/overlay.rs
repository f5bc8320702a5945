//! What is said over the picture: speed, each SPU's load, work that was saved.

/// What is said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    /// Lines of text.
    pub lines: Vec<String>,
    /// Part of the frame's time that each SPU was at work in, 0 to 1.
    pub loads: Vec<f32>,
}

impl Overlay {
    /// All of it in one line, for where there are letters alone.
    #[must_use]
    pub fn line(&self) -> String {
        let loads: Vec<_> = self
            .loads
            .iter()
            .map(|load| format!("{:.0}", 100.0 * load))
            .collect();
        format!("{}  SPUs {} %", self.lines.join("  "), loads.join(" "))
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
        };
        assert_eq!(overlay.line(), "12 frames/s  64x48  SPUs 25 100 %");
    }
}
