//! Conversion specifications of `printf` and `scanf` formats: `%-08.3lld`.

/// The size of an argument by its length modifier. The types are the SPU's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Length {
    /// `hh`
    Char,
    /// `h`
    Short,
    /// No modifier, `l`, `z` or `t`: 32 bits.
    Word,
    /// `ll`, `j`
    Long,
    /// `L`: a `long double` is a `double`.
    LongDouble,
}

impl Length {
    /// Size in bytes of an integer of this length.
    pub fn bytes(self) -> usize {
        match self {
            Self::Char => 1,
            Self::Short => 2,
            Self::Word => 4,
            // glibc treats `L` before an integer conversion as `ll`.
            Self::Long | Self::LongDouble => 8,
        }
    }
}

/// A width or precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Count {
    /// The next argument holds the number.
    Argument,
    Number(usize),
}

/// The text of a format, read from the left.
pub(super) struct Format<'a> {
    rest: &'a [u8],
}

impl<'a> Format<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        Self { rest: text }
    }

    pub fn rest(&self) -> &'a [u8] {
        self.rest
    }

    pub fn next(&mut self) -> Option<u8> {
        let (&first, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(first)
    }

    pub fn peek(&self) -> Option<u8> {
        self.rest.first().copied()
    }

    pub fn take(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        if found {
            self.next();
        }
        found
    }

    /// A number. If it is too large, the largest possible value.
    pub fn number(&mut self) -> Option<usize> {
        let mut number = None;
        while let Some(digit @ b'0'..=b'9') = self.peek() {
            self.next();
            let before: usize = number.unwrap_or(0);
            number = Some(before.saturating_mul(10).saturating_add(usize::from(digit - b'0')));
        }
        number
    }

    pub fn count(&mut self) -> Option<Count> {
        if self.take(b'*') {
            return Some(Count::Argument);
        }
        self.number().map(Count::Number)
    }

    /// The length modifier, and whether it was an `l`, which selects wide characters.
    pub fn length(&mut self) -> (Length, bool) {
        match self.peek() {
            Some(b'h') => {
                self.next();
                let length = if self.take(b'h') { Length::Char } else { Length::Short };
                (length, false)
            }
            Some(b'l') => {
                self.next();
                if self.take(b'l') { (Length::Long, false) } else { (Length::Word, true) }
            }
            Some(b'j' | b'q') => {
                self.next();
                (Length::Long, false)
            }
            Some(b'L') => {
                self.next();
                (Length::LongDouble, false)
            }
            Some(b'z' | b't') => {
                self.next();
                (Length::Word, false)
            }
            _ => (Length::Word, false),
        }
    }
}
