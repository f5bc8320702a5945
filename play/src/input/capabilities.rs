//! A device's capabilities, read from the kernel's sysfs.
//!
//! EVIOCGBIT is not used: it fills an array of the kernel's long words, which crates take for an
//! array of bytes, wrongly on a big-endian machine. Sysfs writes the words as text, the same
//! everywhere.

use std::fs;
use std::io;
use std::path::Path;

/// A set of codes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Codes {
    /// Words of 64 codes, the lowest first.
    words: Vec<u64>,
}

impl Codes {
    /// Parses hexadecimal words of `word_bits` codes each, the highest word first. `None` if the
    /// text is malformed.
    #[must_use]
    pub fn parse(text: &str, word_bits: u32) -> Option<Self> {
        let words: Option<Vec<u64>> =
            text.split_whitespace().rev().map(|word| u64::from_str_radix(word, 16).ok()).collect();
        let words = words?;
        let fits = |word: &u64| word_bits == 64 || word >> word_bits == 0;
        if words.is_empty() || !words.iter().all(fits) {
            return None;
        }
        let mut codes = Self::default();
        for (number, word) in (0_u16..).zip(words) {
            for bit in (0..word_bits).filter(|bit| word >> bit & 1 == 1) {
                codes.insert(number.checked_mul(word_bits as u16)?.checked_add(bit as u16)?);
            }
        }
        Some(codes)
    }

    /// Whether the set has a code.
    #[must_use]
    pub fn has(&self, code: u16) -> bool {
        let word = self.words.get(usize::from(code / 64));
        word.is_some_and(|word| word >> (code % 64) & 1 == 1)
    }

    /// All codes, ascending.
    pub fn iter(&self) -> impl Iterator<Item = u16> {
        let all = (0..).step_by(64).zip(&self.words);
        all.flat_map(|(first, &word)| {
            let bits = (0..64).filter(move |bit| word >> bit & 1 == 1);
            bits.map(move |bit| first + bit)
        })
    }

    /// Adds a code, or removes it.
    pub fn set(&mut self, code: u16, is_in: bool) {
        if is_in {
            self.insert(code);
        } else if let Some(word) = self.words.get_mut(usize::from(code / 64)) {
            *word &= !(1 << (code % 64));
        }
    }

    fn insert(&mut self, code: u16) {
        let word = usize::from(code / 64);
        if self.words.len() <= word {
            self.words.resize(word + 1, 0);
        }
        self.words[word] |= 1 << (code % 64);
    }
}

impl FromIterator<u16> for Codes {
    fn from_iter<I: IntoIterator<Item = u16>>(codes: I) -> Self {
        let mut set = Self::default();
        codes.into_iter().for_each(|code| set.insert(code));
        set
    }
}

/// A device's name, and the codes that it can report.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Capabilities {
    /// The device's name.
    pub name: String,
    /// Keys and buttons.
    pub keys: Codes,
    /// Absolute axes, such as sticks.
    pub absolute: Codes,
    /// Relative axes, such as a mouse's.
    pub relative: Codes,
}

impl Capabilities {
    /// Reads them from a device's folder in sysfs, such as `/sys/class/input/event0/device`.
    ///
    /// # Errors
    /// A file can't be read, or its text is malformed; the message names the file.
    pub fn read(folder: &Path) -> io::Result<Self> {
        // The words are the kernel's. A 64-bit program always runs under a 64-bit kernel.
        let codes = |kind: &str| {
            let path = folder.join("capabilities").join(kind);
            let text = fs::read_to_string(&path)?;
            Codes::parse(&text, usize::BITS).ok_or_else(|| {
                let message =
                    format!("{}: {:?} is not a list of codes", path.display(), text.trim());
                io::Error::new(io::ErrorKind::InvalidData, message)
            })
        };
        Ok(Self {
            name: fs::read_to_string(folder.join("name"))?.trim_end().to_owned(),
            keys: codes("key")?,
            absolute: codes("abs")?,
            relative: codes("rel")?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The keys of a SIXAXIS, from a kernel with the newer numbering.
    const SIXAXIS_KEYS: &str = "f 0 7fdb000000000000 0 0 0 0\n";

    #[test]
    fn words_are_read_from_highest_to_lowest() {
        let codes = Codes::parse(SIXAXIS_KEYS, 64).expect("codes");
        for code in [0x130, 0x131, 0x133, 0x134, 0x136, 0x13c, 0x13e] {
            assert!(codes.has(code), "{code:#x}");
        }
        for code in [0, 0x12f, 0x132, 0x135, 0x13f, 0x17f, 0x184, 0xffff] {
            assert!(!codes.has(code), "{code:#x}");
        }
        assert!((0x180..0x184).all(|code| codes.has(code)));
    }

    #[test]
    fn codes_are_inserted_and_removed() {
        let all = [0, 63, 64, 0x130, 0x2ff];
        let mut codes: Codes = all.into_iter().collect();
        assert!(codes.iter().eq(all));
        codes.set(64, false);
        codes.set(0x2fff, false);
        codes.set(5, true);
        assert!(codes.iter().eq([0, 5, 63, 0x130, 0x2ff]));
    }

    #[test]
    fn words_of_32_bits_give_same_codes() {
        let wide = Codes::parse("8000000000000001 30000", 64);
        let narrow = Codes::parse("80000000 1 0 30000", 32);
        assert!(wide.is_some());
        assert_eq!(wide, narrow);
    }

    #[test]
    fn malformed_codes_are_refused() {
        for text in ["", "\n", "g", "-1", "10000000000000000", "1 x"] {
            assert_eq!(Codes::parse(text, 64), None, "{text:?}");
        }
        assert_eq!(Codes::parse("100000000", 32), None);
    }

    #[test]
    fn folder_is_read_and_invalid_folder_is_named() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path();
        fs::create_dir(path.join("capabilities")).expect("a folder");
        for (file, text) in [
            ("name", "A pad\n"),
            ("capabilities/key", SIXAXIS_KEYS),
            ("capabilities/abs", "3f\n"),
            ("capabilities/rel", "0\n"),
        ] {
            fs::write(path.join(file), text).expect("a file");
        }
        let found = Capabilities::read(path).expect("capabilities");
        assert_eq!(found.name, "A pad");
        assert!(found.absolute.has(5) && !found.absolute.has(6) && found.keys.has(0x130));
        assert_eq!(found.relative, Codes::default());
        fs::write(path.join("capabilities/abs"), "what\n").expect("a file");
        let error = Capabilities::read(path).expect_err("no codes");
        assert!(error.to_string().contains("capabilities/abs"), "{error}");
    }
}
