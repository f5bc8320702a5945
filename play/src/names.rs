//! Finds the name that somebody has probably meant.

/// The known name that is most like a wrong one, if one is: a letter in three may be wrong, missing
/// or too many, and a beginning of at least three letters is enough.
pub fn nearest<'a>(wrong: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wrong = wrong.to_lowercase();
    let is_beginning = |name: &str| wrong.len() >= 3 && name.starts_with(&wrong);
    let distances = known.into_iter().filter_map(|name| {
        let letters = wrong.chars().count().max(name.chars().count());
        let lower = name.to_lowercase();
        let distance = match is_beginning(&lower) {
            true => 0,
            false => strsim::levenshtein(&wrong, &lower),
        };
        (3 * distance <= letters).then_some((distance, name))
    });
    let (_, name) = distances.min_by_key(|(distance, _)| *distance)?;
    Some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn similar_name_is_suggested() {
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
