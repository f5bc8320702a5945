//! MFC commands: opcodes, and the rules that a command must obey to be carried out.
//!
//! This is the only place that turns a broken rule into a [`DmaError`]. The result hint of the
//! `putr` forms has no effect that a program could see.

use super::error::DmaError;
use crate::memory::LINE;

/// The largest size in bytes of one transfer, and of one list.
pub const MAX_TRANSFER: u32 = 16 * 1024;
/// Number of tag groups.
pub const TAGS: u32 = 32;
/// Size of a list element in bytes.
pub(crate) const ELEMENT: u32 = 8;
/// Size in bytes of the word that `sndsig` sends.
const SIGNAL_SIZE: u32 = 4;

/// How a command is ordered after earlier ones of its tag group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Free,
    Fence,
    Barrier,
}

/// What a command does, without its ordering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    Put,
    Get,
    PutList,
    GetList,
    SendSignal,
    /// `putqlluc`
    PutLineQueued,
    GetLine,
    PutLineConditional,
    PutLineUnconditional,
    /// The barrier command 0xC0.
    QueueBarrier,
    /// `mfcsync` and `mfceieio`.
    Sync,
    /// Cache hints. They have no effect, because the emulated machine has no cache.
    CacheHint,
    /// `sdcrz`
    ZeroRange,
}

impl Operation {
    pub(crate) fn is_list(self) -> bool {
        matches!(self, Self::PutList | Self::GetList)
    }

    /// Whether this is an atomic command that bypasses the queue.
    pub(crate) fn is_immediate(self) -> bool {
        matches!(self, Self::GetLine | Self::PutLineConditional | Self::PutLineUnconditional)
    }
}

/// The source of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// The SPU, through its channels.
    Spu,
    /// The PPE, through the proxy queue.
    Proxy,
}

/// The parameters as the program wrote them, unchecked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Parameters {
    pub lsa: u32,
    pub ea: u64,
    pub size: u32,
    pub tag: u32,
}

/// A command that obeys all rules that can be checked before it runs. The elements of a list can
/// be checked only later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Command {
    pub operation: Operation,
    pub order: Order,
    pub opcode: u8,
    pub lsa: u32,
    pub ea: u64,
    pub size: u32,
    pub tag: u8,
}

/// The operation, its order, and whether the start modifier is set.
fn decode(opcode: u8) -> Option<(Operation, Order, bool)> {
    let plain = |operation| Some((operation, Order::Free, false));
    match opcode {
        0xb0 => return plain(Operation::PutLineUnconditional),
        0xb4 => return plain(Operation::PutLineConditional),
        // The command publishes earlier puts, so it implies a fence.
        0xb8 => return Some((Operation::PutLineQueued, Order::Fence, false)),
        0xc0 => return plain(Operation::QueueBarrier),
        0xc8 | 0xcc => return plain(Operation::Sync),
        0xd0 => return plain(Operation::GetLine),
        0x80 | 0x81 | 0x8d | 0x8f => return plain(Operation::CacheHint),
        0x89 => return plain(Operation::ZeroRange),
        _ => {}
    }
    let order = match opcode & 3 {
        0 => Order::Free,
        1 => Order::Barrier,
        2 => Order::Fence,
        _ => return None,
    };
    let (operation, start) = match opcode & !3 {
        0x20 | 0x30 => (Operation::Put, false),
        0x24 | 0x34 => (Operation::PutList, false),
        0x28 => (Operation::Put, true),
        0x40 => (Operation::Get, false),
        0x44 => (Operation::GetList, false),
        0x48 => (Operation::Get, true),
        0xa0 => (Operation::SendSignal, false),
        _ => return None,
    };
    Some((operation, order, start))
}

impl Command {
    /// Checks the command word `word` (opcode in the low 16 bits) with its parameters.
    pub(crate) fn new(word: u32, parameters: Parameters, side: Side) -> Result<Self, DmaError> {
        let invalid = |what| DmaError::InvalidCommand { what, command: word };
        if word & 0xff00 != 0 {
            return Err(invalid("the upper half of the opcode must be 0"));
        }
        let opcode = word as u8;
        let (operation, order, start) =
            decode(opcode).ok_or_else(|| invalid("no command has this opcode"))?;
        match side {
            Side::Spu if start => {
                return Err(invalid("only the proxy queue accepts the start modifier"));
            }
            Side::Proxy if start => {
                return Err(invalid(
                    "the start modifier needs an SPU that runs without a host thread",
                ));
            }
            Side::Proxy if operation.is_list() => {
                return Err(invalid("the proxy queue accepts no list commands"));
            }
            Side::Proxy if operation.is_immediate() || operation == Operation::PutLineQueued => {
                return Err(invalid("the proxy queue accepts no atomic commands"));
            }
            _ => {}
        }
        let Parameters { lsa, ea, size, tag } = parameters;
        if tag >= TAGS && !operation.is_immediate() {
            return Err(invalid("the tag is not in 0 to 31"));
        }
        let mut command = Self { operation, order, opcode, lsa, ea, size, tag: (tag % TAGS) as u8 };
        match operation {
            Operation::Put | Operation::Get => command.check_transfer()?,
            Operation::ZeroRange if size > MAX_TRANSFER => {
                return Err(command.alignment("more than 16 KB"));
            }
            Operation::SendSignal if size != SIGNAL_SIZE => {
                return Err(command.alignment("sndsig sends 4 bytes"));
            }
            Operation::SendSignal => command.check_transfer()?,
            Operation::PutList | Operation::GetList => command.check_list()?,
            Operation::GetLine
            | Operation::PutLineConditional
            | Operation::PutLineUnconditional
            | Operation::PutLineQueued => {
                command.lsa &= !(LINE as u32 - 1);
                command.ea &= !(LINE as u64 - 1);
                command.size = LINE as u32;
            }
            Operation::QueueBarrier
            | Operation::Sync
            | Operation::CacheHint
            | Operation::ZeroRange => {}
        }
        Ok(command)
    }

    pub(crate) fn tag_bit(&self) -> u32 {
        1 << self.tag
    }

    pub(crate) fn alignment(&self, what: &'static str) -> DmaError {
        DmaError::Alignment {
            what,
            command: self.opcode,
            lsa: self.lsa,
            ea: self.ea,
            size: self.size,
        }
    }

    pub(crate) fn storage(&self, ea: u64) -> DmaError {
        DmaError::Storage { command: self.opcode, lsa: self.lsa, ea, size: self.size }
    }

    fn check_transfer(&self) -> Result<(), DmaError> {
        let Self { lsa, ea, size, .. } = *self;
        let ea_low = ea as u32 & 15;
        match size {
            0 => Ok(()),
            1 | 2 | 4 | 8 if !ea_low.is_multiple_of(size) => {
                Err(self.alignment("the effective address is not aligned to the size"))
            }
            1 | 2 | 4 | 8 if lsa & 15 != ea_low => {
                Err(self.alignment("local-store and effective address differ in their low 4 bits"))
            }
            1 | 2 | 4 | 8 => Ok(()),
            _ if size > MAX_TRANSFER => Err(self.alignment("more than 16 KB")),
            _ if !size.is_multiple_of(16) => {
                Err(self.alignment("the size is not 1, 2, 4, 8 or n times 16"))
            }
            _ if lsa & 15 != 0 => {
                Err(self.alignment("the local-store address is not a multiple of 16"))
            }
            _ if ea_low != 0 => {
                Err(self.alignment("the effective address is not a multiple of 16"))
            }
            _ => Ok(()),
        }
    }

    fn check_list(&self) -> Result<(), DmaError> {
        if self.size > MAX_TRANSFER {
            Err(self.alignment("a list has at most 2048 elements"))
        } else if !self.size.is_multiple_of(ELEMENT) {
            Err(self.alignment("the list size is not a multiple of 8"))
        } else if !(self.ea as u32).is_multiple_of(ELEMENT) {
            Err(self.alignment("the list's address is not a multiple of 8"))
        } else {
            Ok(())
        }
    }

    /// The transfer of one element of this list. `lsa` is its local-store address, or an address
    /// in the same quadword. The second value is whether the list stalls after the element.
    pub(crate) fn element(&self, words: [u32; 2], lsa: u32) -> Result<(Self, bool), DmaError> {
        const STALL: u32 = 0x8000_0000;
        const SIZE: u32 = 0x7fff;
        let [first, low] = words;
        let size = first & SIZE;
        let lsa = if size < 16 { lsa & !15 | low & 15 } else { lsa };
        let element = Self {
            operation: match self.operation {
                Operation::PutList => Operation::Put,
                _ => Operation::Get,
            },
            lsa,
            ea: self.ea & !u64::from(u32::MAX) | u64::from(low),
            size,
            ..*self
        };
        element.check_transfer()?;
        if u64::from(low) + u64::from(size) > 1 << 32 {
            return Err(element.alignment("a list element crosses a 4 GB boundary"));
        }
        Ok((element, first & STALL != 0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(lsa: u32, ea: u64, size: u32) -> Parameters {
        Parameters { lsa, ea, size, tag: 0 }
    }

    #[test]
    fn exactly_the_listed_opcodes_exist() {
        let groups: &[&[u8]] = &[
            &[0x20, 0x21, 0x22, 0x24, 0x25, 0x26, 0x28, 0x29, 0x2a],
            &[0x30, 0x31, 0x32, 0x34, 0x35, 0x36],
            &[0x40, 0x41, 0x42, 0x44, 0x45, 0x46, 0x48, 0x49, 0x4a],
            &[0xa0, 0xa1, 0xa2, 0xb0, 0xb4, 0xb8, 0xc0, 0xc8, 0xcc, 0xd0],
            &[0x80, 0x81, 0x89, 0x8d, 0x8f],
        ];
        let listed = groups.concat();
        let known: Vec<u8> = (0..=255).filter(|&o| decode(o).is_some()).collect();
        let mut sorted = listed;
        sorted.sort_unstable();
        assert_eq!(known, sorted);
    }

    #[test]
    fn start_forms_are_refused_on_both_sides() {
        for opcode in [0x28, 0x29, 0x2a, 0x48, 0x49, 0x4a] {
            for side in [Side::Spu, Side::Proxy] {
                assert!(matches!(
                    Command::new(opcode, at(0, 0, 16), side),
                    Err(DmaError::InvalidCommand { .. })
                ));
            }
        }
    }

    #[test]
    fn words_and_tags_outside_their_fields() {
        let refused = |word, tag, side| {
            let parameters = Parameters { size: 16, tag, ..Parameters::default() };
            matches!(Command::new(word, parameters, side), Err(DmaError::InvalidCommand { .. }))
        };
        assert!(refused(0x0140, 0, Side::Spu));
        assert!(refused(0x40, 32, Side::Spu));
        assert!(refused(0x23, 0, Side::Spu));
        assert!(refused(0x44, 0, Side::Proxy));
        assert!(refused(0xd0, 0, Side::Proxy));
        assert!(refused(0xb8, 0, Side::Proxy));
        // Class identifiers are not part of the opcode.
        assert!(!refused(0x0102_0040, 31, Side::Spu));
    }

    #[test]
    fn elements_share_the_high_word_and_align_small_pieces() {
        let list = Command::new(0x44, at(0x100, 0x7_0000_0200, 16), Side::Spu).unwrap();
        let (element, stall) = list.element([0x8000_0004, 0x1004], 0x100).unwrap();
        assert_eq!((element.lsa, element.ea), (0x104, 0x7_0000_1004));
        assert!(stall);
        let (empty, stall) = list.element([0x8000, 0x3], 0x100).unwrap();
        assert_eq!((empty.size, stall), (0, false));
        assert!(list.element([0x7ff0, 0x1000], 0x100).is_err());
        assert!(list.element([0x20, 0xffff_fff0], 0x100).is_err());
        assert!(list.element([0x10, 0xffff_fff0], 0x100).is_ok());
        assert!(list.element([0x10, 0x1000], 0x108).is_err());
    }
}
