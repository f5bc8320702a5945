//! Finds the name that somebody has probably meant.

/// The known name that is most like a wrong one, if one is: a letter in three may be wrong, missing
/// or too many, and a beginning of at least three letters is enough.
pub fn nearest<'a>(wrong: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wrong: Vec<char> = wrong.to_lowercase().chars().collect();
    let distances = known.into_iter().filter_map(|name| {
        let letters: Vec<char> = name.to_lowercase().chars().collect();
        let distance = match wrong.len() >= 3 && letters.starts_with(&wrong) {
            true => 0,
            false => distance(&wrong, &letters),
        };
        (3 * distance <= wrong.len().max(letters.len())).then_some((distance, name))
    });
    let (_, name) = distances.min_by_key(|(distance, _)| *distance)?;
    Some(name)
}

/// The number of letters to change, add or remove to make one word of the other (Levenshtein's
/// distance).
fn distance(from: &[char], to: &[char]) -> usize {
    // The distances of the letters so far from each beginning of `to`.
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (number, letter) in from.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = number + 1;
        for (at, other) in to.iter().enumerate() {
            let changed = diagonal + usize::from(letter != other);
            diagonal = row[at + 1];
            row[at + 1] = changed.min(diagonal + 1).min(row[at] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_levenshteins() {
        for (from, to, expected) in [
            ("", "", 0),
            ("abc", "", 3),
            ("kitten", "sitting", 3),
            ("flaw", "lawn", 2),
        ] {
            let [a, b] = [from, to].map(|word| word.chars().collect::<Vec<_>>());
            assert_eq!((distance(&a, &b), distance(&b, &a)), (expected, expected));
        }
    }

    #[test]
    fn a_name_is_meant_if_it_is_like_the_wrong_one() {
        let known = ["billiards", "marbles", "orrery", "screensaver"];
        for (wrong, meant) in [
            ("biliards", Some("billiards")),
            ("BILIARD", Some("billiards")),
            ("marble", Some("marbles")),
            ("ory", None),
            ("orr", Some("orrery")),
            ("screen-saver", Some("screensaver")),
            ("chess", None),
            ("", None),
        ] {
            assert_eq!(nearest(wrong, known), meant, "{wrong}");
        }
    }
}
