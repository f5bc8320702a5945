//! A signal-notification register.

/// The effect of a write on bits that have not been read yet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SignalMode {
    /// The new word replaces them.
    #[default]
    Overwrite,
    /// The new word is ORed into them, so that each of many senders can have a bit.
    Or,
}

/// Selects one of an SPE's two signal-notification registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalRegister {
    /// Channel 3.
    One,
    /// Channel 4.
    Two,
}

#[derive(Debug)]
pub(crate) struct Signal {
    mode: SignalMode,
    word: Option<u32>,
}

impl Signal {
    pub(crate) fn new(mode: SignalMode) -> Self {
        Self { mode, word: None }
    }

    /// Writes a word. Returns whether the register was empty before.
    pub(crate) fn write(&mut self, word: u32) -> bool {
        let before = self.word;
        self.word = Some(match (self.mode, before) {
            (SignalMode::Or, Some(old)) => old | word,
            _ => word,
        });
        before.is_none()
    }

    /// Returns the word and clears the register.
    pub(crate) fn read(&mut self) -> Option<u32> {
        self.word.take()
    }

    pub(crate) fn waiting(&self) -> bool {
        self.word.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_differ_only_for_unread_bits() {
        for (mode, both) in [(SignalMode::Overwrite, 4), (SignalMode::Or, 5)] {
            let mut signal = Signal::new(mode);
            assert!(signal.write(1));
            assert!(!signal.write(4));
            assert_eq!(signal.read(), Some(both));
            assert_eq!(signal.read(), None);
            assert!(signal.write(0));
            assert!(signal.waiting());
            assert_eq!(signal.read(), Some(0));
        }
    }
}
