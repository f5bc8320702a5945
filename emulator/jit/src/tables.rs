//! Tables that compiled code reads: controls for byte shuffles.
//!
//! A register's image on the host has each word in the host's byte order, so byte `n` of a
//! quadword, counted from the left, is at `n ^ 3`.

/// The bytes of a quadword in the order of the host's memory.
pub(crate) type Bytes = [u8; 16];

/// Controls for the host's byte shuffle, and for `shufb`.
#[repr(C, align(64))]
pub(crate) struct Tables {
    /// Rotate left by the index, in bytes.
    pub rotate: [Bytes; 16],
    /// Shift left by the index, in bytes.
    pub left: [Bytes; 32],
    /// Shift right by the index, in bytes.
    pub right: [Bytes; 32],
    /// Controls of `shufb` that insert a scalar at the address in the index, for scalars of 1, 2,
    /// 4 and 8 bytes.
    pub insertion: [[Bytes; 16]; 4],
}

/// The control byte for which the host's shuffle gives 0.
const ZERO_BYTE: u8 = 0x80;

pub(crate) static TABLES: Tables = Tables {
    rotate: controls::<16>(Kind::Rotate),
    left: controls::<32>(Kind::Left),
    right: controls::<32>(Kind::Right),
    insertion: [insertions(1), insertions(2), insertions(4), insertions(8)],
};

#[derive(Clone, Copy)]
enum Kind {
    Rotate,
    Left,
    Right,
}

const fn controls<const N: usize>(kind: Kind) -> [Bytes; N] {
    let mut table = [[0; 16]; N];
    let mut count = 0;
    while count < N {
        let mut n = 0;
        while n < 16 {
            let from = match kind {
                Kind::Rotate => (n + count) & 15,
                Kind::Left => n + count,
                Kind::Right => n.wrapping_sub(count),
            };
            table[count][n ^ 3] = if from < 16 { (from ^ 3) as u8 } else { ZERO_BYTE };
            n += 1;
        }
        count += 1;
    }
    table
}

const fn insertions(size: usize) -> [Bytes; 16] {
    // A doubleword is in bytes 0 to 7 of its register; a smaller scalar ends at byte 3.
    let scalar = if size == 8 { 0 } else { 4 - size };
    let mut table = [[0; 16]; 16];
    let mut address = 0;
    while address < 16 {
        let first = address & (16 - size);
        let mut n = 0;
        while n < 16 {
            let inside = n >= first && n < first + size;
            table[address][n ^ 3] = if inside { scalar + n - first } else { 16 + n } as u8;
            n += 1;
        }
        address += 1;
    }
    table
}
