//! The settings of a picture in its file, as text chunks of PNG.
//!
//! Invariant: the same settings give the same bytes. There is no date among them, and nothing that
//! leaves the pixels as they are, such as the number of SPUs.

use std::fs::File;
use std::io::{BufReader, Write};
use std::path::Path;

use glam::DVec3;
use png::EncodingError;
use scenes::View;

/// The keyword of the program that made a picture, which PNG defines.
const SOFTWARE: &str = "Software";
/// What that program's name begins with.
const PROGRAM: &str = "cellray ";
/// What the keyword of a setting begins with, before the name of its option.
const PREFIX: &str = "cellray:";

/// Texts with keywords for a picture's file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Labels {
    texts: Vec<(String, String)>,
}

impl Default for Labels {
    /// The program and its version alone.
    fn default() -> Self {
        let program = format!("{PROGRAM}{}", env!("CARGO_PKG_VERSION"));
        Self { texts: vec![(SOFTWARE.to_owned(), program)] }
    }
}

impl Labels {
    /// Sets what an option of `cellray render` has as its value, by its name without hyphens.
    pub fn set(&mut self, option: &str, value: impl ToString) {
        let keyword = format!("{PREFIX}{option}");
        // PNG's texts have no zero bytes.
        let value = value.to_string().replace('\0', " ");
        match self.texts.iter_mut().find(|text| text.0 == keyword) {
            Some(text) => text.1 = value,
            None => self.texts.push((keyword, value)),
        }
    }

    /// Sets the options by which a view differs from the scene's own, and no others of a view.
    pub fn set_view(&mut self, view: &View, own: &View) {
        let triple = |vector: DVec3| vector.to_array().map(|number| number.to_string()).join(",");
        for (option, now, before) in
            [("from", view.from, own.from), ("look-at", view.at, own.at), ("up", view.up, own.up)]
        {
            self.set_if(now != before, option, triple(now));
        }
        self.set_if(view.angle != own.angle, "angle", view.angle.to_string());
    }

    fn set_if(&mut self, is_set: bool, option: &str, value: String) {
        if is_set {
            self.set(option, value);
        } else {
            let keyword = format!("{PREFIX}{option}");
            self.texts.retain(|text| text.0 != keyword);
        }
    }

    /// Whether a file is a PNG with the labels of a picture by cellray.
    #[must_use]
    pub fn are_in(path: &Path) -> bool {
        let Ok(file) = File::open(path) else {
            return false;
        };
        let Ok(reader) = png::Decoder::new(BufReader::new(file)).read_info() else {
            return false;
        };
        let mut texts = reader.info().uncompressed_latin1_text.iter();
        texts.any(|text| text.keyword == SOFTWARE && text.text.starts_with(PROGRAM))
    }

    /// Adds these texts to a PNG file that is to be written.
    pub(super) fn add_to<W: Write>(
        &self,
        encoder: &mut png::Encoder<'_, W>,
    ) -> Result<(), EncodingError> {
        for (keyword, text) in self.texts.iter().cloned() {
            // Text in other characters than Latin-1's has a kind of its own.
            if text.is_ascii() {
                encoder.add_text_chunk(keyword, text)?;
            } else {
                encoder.add_itxt_chunk(keyword, text)?;
            }
        }
        Ok(())
    }
}
