//! The keys of the player's program itself, listed once for the command line's help and the
//! screen's.

/// Each key, and what it does.
pub const KEYS: &[(&str, &str)] = &[
    ("Escape, Q, a pad's PS button", "end"),
    ("H", "show or hide the keys"),
    ("P", "pause, go on"),
    ("F1", "statistics too, no text, only the game's text"),
    ("F11", "full screen, in a window"),
    ("F12", "take a picture"),
];

/// The command line's help for the keys.
#[must_use]
pub fn table() -> String {
    let widest = KEYS.iter().map(|(key, _)| key.len()).max().unwrap_or(0);
    let rows = KEYS.iter().map(|(key, what)| format!("\n  {key:widest$}   {what}"));
    format!("Keys:{}", rows.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn key_table_is_aligned() {
        let table = table();
        let places = table.lines().skip(1).zip(KEYS).map(|(line, (key, what))| {
            assert!(line.starts_with(&format!("  {key}")), "{line}");
            line.rfind(what)
        });
        let places: Vec<_> = places.collect();
        assert!(places.len() > 3 && places.iter().all(|place| *place == places[0]));
    }
}
