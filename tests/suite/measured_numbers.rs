//! Checks that simulated speeds in the documents are those that `ci/measure --write` wrote. A
//! sentence may repeat such a number but contain no other.

use crate::prelude::*;

const WRITTEN: &str = ": written by ci/measure --write -->";
const END: &str = "<!-- end of what is written -->";

/// Numbers before "frames/s" that do not come from those tables, and their origin.
const OTHERS: &[(&str, &str, &str)] = &[
    ("docs/frame.md", "52", "the paper's, on a console"),
    ("docs/ps3.md", "60", "the rate of a display"),
];

fn documents() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let docs = fs::read_dir(root.join("docs")).unwrap();
    let docs = docs.map(|entry| entry.unwrap().path());
    let mut documents: Vec<PathBuf> =
        docs.filter(|path| path.extension().is_some_and(|ending| ending == "md")).collect();
    documents.push(root.join("README.md"));
    documents
}

/// Splits a text into the part that `ci/measure` wrote and the rest.
fn parted(text: &str) -> (String, String) {
    let (mut written, mut rest, mut inside) = (String::new(), String::new(), false);
    for line in text.lines() {
        inside = (inside || line.ends_with(WRITTEN)) && line != END;
        let part = if inside { &mut written } else { &mut rest };
        part.push_str(line);
        part.push('\n');
    }
    (written, rest)
}

/// The numbers before "frames/s" or "frames a second" as text.
fn speeds(text: &str) -> Vec<String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let number = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit());
    let mut found = Vec::new();
    for (place, word) in words.iter().enumerate() {
        let unit = word.starts_with("frames/s")
            || *word == "frames"
                && words.get(place + 1) == Some(&"a")
                && words.get(place + 2).is_some_and(|word| word.starts_with("second"));
        if unit && let Some(before) = place.checked_sub(1).map(|at| words[at]).filter(number) {
            found.push(before.to_owned());
        }
    }
    found
}

/// Whether `number` equals one of these cells, rounded to the same number of decimals.
fn is_among(number: &str, cells: &[f64]) -> bool {
    let decimals = number.split_once('.').map_or(0, |(_, digits)| digits.len());
    cells.iter().any(|cell| format!("{cell:.decimals$}") == number)
}

#[test]
fn every_speed_is_measured() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut cells, mut quoted) = (Vec::new(), Vec::new());
    let mut blocks = 0;
    for path in documents() {
        let name = path.strip_prefix(root).unwrap().display().to_string();
        let (written, rest) = parted(&fs::read_to_string(&path).unwrap());
        blocks += written.matches(WRITTEN).count();
        let numbers = written.split('|').filter_map(|cell| cell.trim().parse::<f64>().ok());
        cells.extend(numbers);
        quoted.extend(speeds(&rest).into_iter().map(|number| (name.clone(), number)));
    }
    assert_eq!(blocks, 18, "the tables of ci/measure");
    for (name, number, why) in OTHERS {
        let is_in_document = quoted.iter().any(|(file, quoted)| file == name && quoted == number);
        assert!(
            is_in_document,
            "{name} no longer has {number} frames/s ({why}): take it off the list"
        );
    }
    let strange: Vec<_> = quoted
        .iter()
        .filter(|(name, number)| {
            let other = |(file, known, _): &(&str, &str, &str)| file == name && known == number;
            !OTHERS.iter().any(other) && !is_among(number, &cells)
        })
        .collect();
    assert!(strange.is_empty(), "not measured by ci/measure: {strange:?}");
}

#[test]
fn unmeasured_number_is_found() {
    let text = "It makes 61 frames/s, and\n99.5 frames a second.\n";
    assert_eq!(speeds(text), ["61", "99.5"]);
    assert!(is_among("61", &[60.6]) && !is_among("60.5", &[60.6]));
    let (written, rest) = parted(&format!("a\n<!-- x{WRITTEN}\n| 1 |\n{END}\nb\n"));
    assert!(written.contains("| 1 |") && !rest.contains('1') && rest.ends_with("b\n"));
}
