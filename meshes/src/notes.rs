//! What a user should know about how a file was read.

/// Notes in the order in which they came. Several of a kind are one, with the first one's text.
#[derive(Default)]
pub(crate) struct Notes {
    notes: Vec<Note>,
}

struct Note {
    kind: String,
    text: String,
    more: usize,
}

impl Notes {
    /// Adds a note on the whole file, once.
    pub fn add(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !self.notes.iter().any(|note| note.kind == text) {
            let kind = text.clone();
            self.notes.push(Note {
                kind,
                text,
                more: 0,
            });
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
        let text = format!("{file}:{line}: {text}");
        self.notes.push(Note {
            kind,
            text,
            more: 0,
        });
    }

    /// The notes, a sentence each.
    pub fn finish(self) -> Vec<String> {
        let text = |Note { text, more, .. }: Note| match more {
            0 => text,
            more => format!("{text} (and {more} more of this kind)"),
        };
        self.notes.into_iter().map(text).collect()
    }
}
