//! A mailbox: a short queue of words. It neither puts threads to sleep nor wakes them; the problem
//! state does that.

use std::collections::VecDeque;

/// Words that the inbound mailbox holds.
pub const INBOUND_DEPTH: usize = 4;
/// Words that each outbound mailbox holds.
pub const OUTBOUND_DEPTH: usize = 1;

#[derive(Debug)]
pub(crate) struct Mailbox {
    words: VecDeque<u32>,
    depth: usize,
}

impl Mailbox {
    pub(crate) fn new(depth: usize) -> Self {
        Self { words: VecDeque::with_capacity(depth), depth }
    }

    /// Appends a word unless the mailbox is full. Returns whether it was appended.
    pub(crate) fn write(&mut self, word: u32) -> bool {
        let is_free = self.free() > 0;
        if is_free {
            self.words.push_back(word);
        }
        is_free
    }

    pub(crate) fn read(&mut self) -> Option<u32> {
        self.words.pop_front()
    }

    pub(crate) fn waiting(&self) -> usize {
        self.words.len()
    }

    pub(crate) fn free(&self) -> usize {
        self.depth - self.words.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_come_out_in_order_and_no_more_than_fit() {
        let mut mailbox = Mailbox::new(2);
        assert!(mailbox.write(1));
        assert!(mailbox.write(2));
        assert!(!mailbox.write(3));
        assert_eq!(mailbox.read(), Some(1));
        assert_eq!((mailbox.waiting(), mailbox.free()), (1, 1));
        assert_eq!(mailbox.read(), Some(2));
        assert_eq!(mailbox.read(), None);
    }
}
