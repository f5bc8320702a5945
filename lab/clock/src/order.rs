//! The order that an SPU gets, and the result that it stores after it: a line each.

/// The benchmarks, in the order of the table in `spu/main.s`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Benchmark {
    Stream,
    StreamWithoutCommand,
    Putlluc,
    Increments,
    PingPong,
    List,
    Mail,
    Signals,
    SignalsOfSpes,
    HintedLoop,
    TakenBranches,
    DoublePairs,
}

/// MFC commands.
pub const GET: u32 = 0x40;
pub const PUT: u32 = 0x20;

/// The bytes of an order, and of a result.
pub const BYTES: usize = 128;

/// The task of one SPU.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    pub benchmark: Benchmark,
    /// How often.
    pub passes: u32,
    /// The MFC command.
    pub opcode: u32,
    /// Bytes of a command or of a list's element.
    pub size: u32,
    /// Commands in flight, or elements of a list.
    pub depth: u32,
    /// Where commands begin.
    pub ea: u64,
    /// Commands go to successive addresses from `ea`; offsets wrap by this mask.
    pub mask: u32,
    /// The SPU's number.
    pub number: u32,
}

impl Order {
    /// An order without commands.
    pub fn new(benchmark: Benchmark, passes: u32) -> Self {
        Self { benchmark, passes, opcode: GET, size: 0, depth: 1, ea: 0, mask: 0, number: 0 }
    }

    /// The order as the SPU reads it.
    pub fn bytes(&self) -> [u8; BYTES] {
        let words = [
            self.benchmark as u32,
            self.passes,
            self.opcode,
            self.size,
            self.depth,
            (self.ea >> 32) as u32,
            self.ea as u32,
            self.mask,
            self.number,
        ];
        let mut bytes = [0; BYTES];
        for (at, word) in bytes.chunks_exact_mut(4).zip(words) {
            at.copy_from_slice(&word.to_be_bytes());
        }
        bytes
    }
}

/// The measurement of one SPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measured {
    /// Ticks of the decrementer from the first pass to the end of the last.
    pub ticks: u32,
    /// The SPU's count.
    pub done: u32,
}

impl Measured {
    /// The result that an SPU stored.
    pub fn parse(bytes: &[u8; BYTES]) -> Self {
        let word = |at: usize| {
            let bytes = [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]];
            u32::from_be_bytes(bytes)
        };
        Self { ticks: word(0), done: word(16) }
    }
}
