//! The set of characters of `scanf`'s `%[..]`.

use super::directive::Format;
use super::wide;

/// Ranges of characters, or all characters but these.
pub(super) struct Set {
    inverted: bool,
    ranges: Vec<(u32, u32)>,
}

impl Set {
    /// The set whose text follows the `[`. The text of a wide set is UTF-8. `None` if it is not, or
    /// if the format ends within the set.
    pub fn parse(format: &mut Format<'_>, is_wide: bool) -> Option<Self> {
        let inverted = format.take(b'^');
        let mut ranges: Vec<(u32, u32)> = Vec::new();
        let mut first = true;
        // Whether the last range is a single character, with which a range can begin.
        let mut single = false;
        loop {
            let character = next(format, is_wide)?;
            if character == u32::from(b']') && !first {
                return Some(Self { inverted, ranges });
            }
            first = false;
            match ranges.last_mut() {
                Some((_, last))
                    if single
                        && character == u32::from(b'-')
                        && format.peek().is_some_and(|byte| byte != b']') =>
                {
                    *last = next(format, is_wide)?;
                    single = false;
                }
                _ => {
                    ranges.push((character, character));
                    single = true;
                }
            }
        }
    }

    pub fn contains(&self, character: u32) -> bool {
        let listed = |&(first, last): &(u32, u32)| (first..=last).contains(&character);
        self.ranges.iter().any(listed) != self.inverted
    }
}

fn next(format: &mut Format<'_>, is_wide: bool) -> Option<u32> {
    let mut bytes = vec![format.next()?];
    if !is_wide {
        return Some(bytes[0].into());
    }
    loop {
        if let Some(character) = wide::decode(&bytes).ok()? {
            return Some(character.into());
        }
        bytes.push(format.next()?);
    }
}
