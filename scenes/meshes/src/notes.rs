//! Notes for the user about how a file was read.

/// Notes in the order in which they came. Several of a kind are one, with the first one's text.
#[derive(Default)]
pub(crate) struct Notes {
    notes: Vec<Note>,
}

struct Note {
    kind: String,
    /// The file and the line of the first one; `None` if it is about the whole file.
    line: Option<String>,
    text: String,
    more: usize,
}

impl Notes {
    /// Adds a note on the whole file, once.
    pub fn add(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !self.notes.iter().any(|note| note.kind == text) {
            self.notes.push(Note { kind: text.clone(), line: None, text, more: 0 });
        }
    }

    /// Adds a note on a line of a file. Of each kind only the first one's text is kept, because a
    /// file may have a fault in each of a million lines.
    pub fn line(&mut self, file: &str, line: usize, kind: &str, text: &str) {
        let kind = format!("{file}: {kind}");
        if let Some(note) = self.notes.iter_mut().find(|note| note.kind == kind) {
            note.more += 1;
            return;
        }
        self.notes.push(Note {
            kind,
            line: Some(format!("{file}:{line}")),
            text: text.to_owned(),
            more: 0,
        });
    }

    /// The notes, each with its line or with this file.
    pub fn finish(self, file: &str) -> Vec<String> {
        let text = |note: Note| {
            let Note { text, more, .. } = note;
            let place = note.line.unwrap_or_else(|| file.to_owned());
            match more {
                0 => format!("{place}: {text}"),
                more => format!("{place}: {text} (and {more} more of this kind)"),
            }
        };
        self.notes.into_iter().map(text).collect()
    }
}
