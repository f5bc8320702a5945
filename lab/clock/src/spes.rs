//! Runs orders on SPEs, through libspe2.

use std::time::{Duration, Instant};
use std::{hint, thread};

use cellray::SharedMemory;
use cellray::spe::{Context, Outcome, Program, ProgramError, SpeError};

use crate::order::{BYTES, Measured, Order};

const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/clock.elf"));

/// Bytes of main memory for each SPE's transfers.
pub const OWN_BYTES: u32 = 1 << 18;
/// The offset in a local store of the buffers that other SPEs read.
const BUFFERS: u64 = 0x8000;
/// How long a benchmark may take.
const LIMIT: Duration = Duration::from_secs(60);

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
pub enum ClockError {
    /// libspe2 refused a call.
    #[error(transparent)]
    Spe(#[from] SpeError),
    /// The SPU program is damaged.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// An SPU ended otherwise than it should.
    #[error("SPU {number}: {ended}")]
    Ended {
        /// The SPU's number.
        number: usize,
        /// How it ended.
        ended: String,
    },
    /// libspe2 doesn't map what other SPEs should reach.
    #[error("libspe2 doesn't map the {what} of SPE {number}")]
    NotMapped {
        /// What it should map.
        what: &'static str,
        /// The SPE's number.
        number: usize,
    },
    /// An SPU does not reply.
    #[error("SPU {0} has not replied for a minute")]
    Silent(usize),
    /// There is no such row.
    #[error("there is no row {name}; the rows are {known}")]
    Row {
        /// The name.
        name: String,
        /// The names of the rows.
        known: String,
    },
}

/// What the PPE does while the SPUs run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ppe {
    /// It waits for them.
    Waits,
    /// It replies to each word of SPU 0 by mail.
    Mails,
    /// It replies to each word of SPU 0 with a signal.
    Signals,
}

/// Addresses that orders need.
pub struct Place {
    memory: u64,
    /// What [`Mapped`] asks for, of each SPE.
    mapped: Vec<u64>,
}

impl Place {
    /// The memory of SPE `number`, [`OWN_BYTES`] long.
    pub fn memory(&self, number: usize) -> u64 {
        self.memory + number as u64 * u64::from(OWN_BYTES)
    }

    /// The buffers in the local store of SPE `number`.
    pub fn store(&self, number: usize) -> u64 {
        self.mapped[number] + BUFFERS
    }

    /// The signal register of SPE `number`.
    pub fn signal(&self, number: usize) -> u64 {
        self.mapped[number]
    }
}

/// What orders use of other SPEs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mapped {
    Nothing,
    Stores,
    Signals,
}

/// Runs one order on each of `count` SPEs, at the same time. `order` gets the SPE's number.
pub fn run(
    count: usize,
    mapped: Mapped,
    ppe: Ppe,
    order: impl Fn(&Place, usize) -> Order,
) -> Result<Vec<Measured>, ClockError> {
    let program = Program::from_image(IMAGE)?;
    let contexts = (0..count).map(|_| match mapped {
        Mapped::Signals => Context::create_mapped(),
        Mapped::Nothing | Mapped::Stores => Context::create(),
    });
    let contexts = contexts.collect::<Result<Vec<_>, _>>()?;
    let area = SharedMemory::new(count * OWN_BYTES as usize);
    let address = |(number, context): (usize, &Context)| {
        let (what, address) = match mapped {
            Mapped::Nothing => return Ok(0),
            Mapped::Stores => ("local store", context.local_store_address()),
            Mapped::Signals => ("signal register", context.signal_address()),
        };
        address.ok_or(ClockError::NotMapped { what, number })
    };
    let place = Place {
        memory: area.address(),
        mapped: contexts.iter().enumerate().map(address).collect::<Result<_, _>>()?,
    };
    let mut orders = SharedMemory::new(count * 2 * BYTES);
    let all: Vec<Order> = (0..count).map(|number| order(&place, number)).collect();
    for (number, order) in all.iter().enumerate() {
        orders.write(number * 2 * BYTES, &order.bytes());
    }
    for context in &contexts {
        context.load(&program)?;
    }
    let first = orders.address() as usize;
    thread::scope(|scope| {
        let run = |(number, context): (usize, &Context)| context.run(first + number * 2 * BYTES);
        let threads: Vec<_> =
            contexts.iter().enumerate().map(|spe| scope.spawn(move || run(spe))).collect();
        let served = begin(&contexts).and_then(|()| serve(&contexts, ppe, all[0].passes));
        if served.is_err() {
            for context in &contexts {
                context.halt(&program);
            }
        }
        for (number, thread) in threads.into_iter().enumerate() {
            let Ok(ended) = thread.join() else {
                unreachable!("running a context does not panic");
            };
            if ended.outcome != Outcome::Exit(0) && served.is_ok() {
                let ended = ended.to_string();
                return Err(ClockError::Ended { number, ended });
            }
        }
        served
    })?;
    Ok((0..count)
        .map(|number| {
            let mut result = [0; BYTES];
            orders.read((2 * number + 1) * BYTES, &mut result);
            Measured::parse(&result)
        })
        .collect())
}

/// Lets all SPUs begin.
fn begin(contexts: &[Context]) -> Result<(), ClockError> {
    for context in contexts {
        context.mail([1])?;
    }
    Ok(())
}

/// Replies to the words of SPU 0.
fn serve(contexts: &[Context], ppe: Ppe, words: u32) -> Result<(), ClockError> {
    if ppe == Ppe::Waits {
        return Ok(());
    }
    let spe = &contexts[0];
    for _ in 0..words {
        let since = Instant::now();
        let word = loop {
            if let Some(word) = spe.reply()? {
                break word;
            }
            if since.elapsed() > LIMIT {
                return Err(ClockError::Silent(0));
            }
            hint::spin_loop();
        };
        match ppe {
            Ppe::Signals => spe.signal(word)?,
            Ppe::Mails | Ppe::Waits => spe.mail([word])?,
        }
    }
    Ok(())
}
