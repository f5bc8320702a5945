//! Scenes for the tests.

use scenes::{Error, Limits, Scene};

/// A view and a material on eight lines, and `rest` from line 9 on.
pub fn scene_text(rest: &str) -> String {
    format!(
        "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0\nresolution 64 48\n\
         f 1 1 1 1 0 0 0 1\n{rest}"
    )
}

/// `bytes`, parsed as the file `t.nff`.
pub fn try_parse(bytes: &[u8]) -> Result<Scene, Error> {
    scenes::parse(bytes, "t.nff", &Limits::default())
}

/// `text`, which must be right, parsed.
pub fn parsed(text: &str) -> Scene {
    try_parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}
