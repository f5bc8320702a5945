//! The assertions of the fuzz targets, separate from the fuzzer: the tests here replay the saved
//! seeds through the same functions.
//!
//! [`engines`] compares compiled code with the interpreter, and [`calls`] makes library calls with
//! arbitrary arguments. In the other targets a guest runs
//! arbitrary code, and three properties must hold: nothing panics, a stop request ends the run, and
//! the guest changes no memory that it was not given or that is read-only for it.

mod calls;
mod engines;
mod gdb;
#[cfg(test)]
mod seeds;

use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::Duration;

use spu_emulator::elf::{self, Image};
use spu_emulator::local_store::LocalStore;
use spu_emulator::machine::Machine;
use spu_emulator::memory::{Access, MainMemory, RegisteredMemory};
use spu_emulator::mfc::Policy;
use spu_emulator::spe::{Config, Spe};
use spu_isa::{Instruction, disassemble};

pub use calls::calls;
pub use engines::engines;
pub use gdb::gdb;

/// How long a guest may run. Most stop by themselves within microseconds.
const PATIENCE: Duration = Duration::from_millis(5);

/// Main memory that a guest may write. It is in the lowest 4 GB, so that few bits of an input
/// reach it.
const WRITABLE: u64 = 0x1_0000;
/// Memory that a guest may only read, directly after the writable memory.
const READ_ONLY: u64 = 0x2_0000;
const REGION: usize = 0x1_0000;
const READ_ONLY_BYTE: u8 = 0x5a;

/// Ends runs that take too long.
fn watchdog() -> &'static mpsc::SyncSender<(Arc<Spe>, mpsc::Receiver<()>)> {
    static WATCHDOG: OnceLock<mpsc::SyncSender<(Arc<Spe>, mpsc::Receiver<()>)>> = OnceLock::new();
    WATCHDOG.get_or_init(|| {
        let (sender, runs) = mpsc::sync_channel::<(Arc<Spe>, mpsc::Receiver<()>)>(1);
        thread::spawn(move || {
            for (spe, ended) in runs {
                while ended.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                    spe.request_stop();
                }
            }
        });
        sender
    })
}

/// Runs a guest whose local store holds `code` from address 0 and `data` from 32 KB on.
fn run(policy: Policy, code: &[u8], data: &[u8]) {
    let memory = Arc::new(RegisteredMemory::new());
    let register = |ea, byte, access| {
        memory.register(ea, vec![byte; REGION], access).expect("the regions do not overlap");
    };
    register(WRITABLE, 0, Access::ReadWrite);
    register(READ_ONLY, READ_ONLY_BYTE, Access::ReadOnly);
    let machine = Machine::new(memory.clone());
    let spe = Spe::new(&machine, Config { policy, ..Config::default() });
    spe.local_store().write(0, code);
    spe.local_store().write(0x8000, data);
    for word in [1, 2, 3] {
        spe.write_inbound(word, None);
    }

    let (end, ended) = mpsc::channel();
    watchdog().send((Arc::clone(&spe), ended)).expect("the watchdog lives as long as the process");
    let stopped = spe.run(0);
    drop(end);
    assert!(!stopped.to_string().is_empty());

    let mut after = vec![0; REGION];
    memory.read(READ_ONLY, &mut after).expect("the region is there");
    assert!(after.iter().all(|byte| *byte == READ_ONLY_BYTE), "read-only memory was written");
}

/// Runs a random program. The first byte of the input chooses when its MFC commands are carried
/// out.
pub fn program(input: &[u8]) {
    let Some((choice, code)) = input.split_first() else {
        return;
    };
    for word in code.chunks_exact(4).take(256) {
        let word = u32::from_be_bytes([word[0], word[1], word[2], word[3]]);
        let text = disassemble(word, 0x1000).to_string();
        assert!(!text.is_empty());
        if let Some(instruction) = Instruction::decode(word) {
            let again = Instruction::decode(instruction.encode());
            assert_eq!(again, Some(instruction), "{word:#010x} {text}");
        }
    }
    run(policy(*choice), code, code);
}

/// Runs random MFC commands. Each has six parameters in 16 bytes, and then the instructions that
/// wait for it. The rest of the input is in local store, where lists and transfers find it.
pub fn dma(input: &[u8]) {
    let Some((choice, rest)) = input.split_first() else {
        return;
    };
    let (count, rest) = rest.split_first().unwrap_or((&0, rest));
    let commands = usize::from(count % 24).min(rest.len() / 16);
    let (commands, data) = rest.split_at(commands * 16);
    let mut code = Vec::new();
    let mut write = |channel: u32, value: u32| {
        // ilhu, iohl and wrch through register 10.
        code.push(0x082 << 23 | (value >> 16) << 7 | 10);
        code.push(0x0c1 << 23 | (value & 0xffff) << 7 | 10);
        code.push(0x10d << 21 | channel << 7 | 10);
    };
    for command in commands.chunks_exact(16) {
        let half = |at: usize| u32::from(u16::from_be_bytes([command[at], command[at + 1]]));
        let word = |at: usize| half(at) << 16 | half(at + 2);
        write(16, word(0));
        write(17, u32::from(command[4] == 0xff));
        write(18, word(5) & 0x3_ffff);
        write(19, half(9));
        write(20, half(11) & if command[13] == 0xff { 0xffff } else { 31 });
        write(21, u32::from(command[14]) | if command[15] == 0xff { 0x0100_0000 } else { 0 });
    }
    write(22, 0xffff_ffff);
    write(23, 2);
    write(26, 1);
    code.push(0x00d << 21 | 24 << 7 | 10);
    code.push(0x2000);
    let code: Vec<u8> = code.iter().flat_map(|word: &u32| word.to_be_bytes()).collect();
    run(policy(*choice), &code, data);
}

/// Loads a random ELF file.
pub fn elf(input: &[u8]) {
    let fetch = |offset: u64, into: &mut [u8]| {
        let start = usize::try_from(offset).ok();
        let bytes = start.and_then(|start| input.get(start..start.checked_add(into.len())?));
        bytes.is_some_and(|bytes| {
            into.copy_from_slice(bytes);
            true
        })
    };
    if let Ok(length) = elf::file_length(fetch) {
        assert!(length > 0);
    }
    match Image::parse(input) {
        Ok(image) => {
            image.load(&LocalStore::new(), 0x1234_5678);
            for address in [0, image.entry(), u32::MAX] {
                if let Some((name, offset)) = image.nearest_symbol(address) {
                    assert_eq!(image.symbol(name).is_some(), !name.is_empty());
                    assert!(offset <= address);
                }
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

fn policy(choice: u8) -> Policy {
    if choice & 1 == 0 { Policy::AtOnce } else { Policy::AtLast }
}
