//! A debugger's server with arbitrary input: bytes as they are, or packets of the protocol with
//! arbitrary parameters.

use std::io::{self, Cursor, Write};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use spu_debugger::{Debugger, signal_of};
use spu_emulator::machine::Machine;
use spu_emulator::memory::RegisteredMemory;
use spu_emulator::spe::{Config, Spe};

/// What the two SPEs run. The first stores and loads for ever: `ai $3,$3,1`, `stqa $3,0x100`,
/// `lqa $4,0x100`, `br 0`. The second waits for a mail: `nop`, `rdch $3,$ch29`.
const PROGRAMS: [&[u32]; 2] =
    [&[0x1c00_4183, 0x2080_2003, 0x3080_2004, 0x327f_fe80], &[0x4020_0000, 0x01a0_0e83]];

/// Parameters are the bytes of a packet after its first.
fn packet(bytes: &[u8]) -> String {
    let at = |n: usize| bytes.get(n).copied().unwrap_or(0);
    // Small addresses, of which some lie at the end of local store or beyond it.
    let address = u32::from(at(1)) << (at(2) % 4 * 4) | u32::from(at(3) % 8);
    let thread = at(4) % 4;
    let length = u32::from(at(5));
    let kind = at(6) % 5;
    match at(0) % 24 {
        0 => "?".into(),
        1 => "g".into(),
        2 => format!("G{}", "0123456789abcdef".repeat(usize::from(at(5)) * 2)),
        3 => format!("m{address:x},{length:x}"),
        4 => format!("M{address:x},{:x}:{}", length % 16, "5a".repeat(length as usize % 18)),
        5 => format!("Z{kind},{address:x},{length:x}"),
        6 => format!("z{kind},{address:x},{length:x}"),
        7 => "c".into(),
        8 => "s".into(),
        9 => "vCont;c".into(),
        10 => format!("vCont;s:{thread:x};c"),
        11 => format!("vCont;s:{thread:x}"),
        12 => format!("Hg{thread:x}"),
        13 => format!("Hc{thread:x}"),
        14 => format!("T{thread:x}"),
        15 => "qfThreadInfo".into(),
        16 => format!("qThreadExtraInfo,{thread:x}"),
        17 => format!("qXfer:features:read:target.xml:{address:x},{length:x}"),
        18 => "qRcmd,6379636c6573".into(),
        19 => "qSupported:multiprocess+;swbreak+;vContSupported+".into(),
        20 => format!("X{address:x},{:x}:{}", length % 8, "a".repeat(length as usize % 8)),
        21 => String::from_utf8_lossy(bytes).into_owned(),
        22 if at(1) < 16 => "D".into(),
        23 if at(1) < 16 => "k".into(),
        _ => "vCont?".into(),
    }
}

/// A stream that begins with an even byte is sent as it is. Of another, each 8 bytes are a packet.
fn stream(input: &[u8]) -> Vec<u8> {
    const PACKET: usize = 8;
    const CTRL_C: u8 = 3;
    match input.split_first() {
        Some((first, packets)) if first % 2 == 1 => {
            let mut stream = Vec::new();
            for bytes in packets.chunks(PACKET) {
                let text = packet(bytes);
                let sum = text.bytes().fold(0_u8, u8::wrapping_add);
                stream.extend(format!("${text}#{sum:02x}+").into_bytes());
                if text.starts_with(['c', 's', 'v']) {
                    stream.push(CTRL_C);
                }
            }
            stream
        }
        _ => input.to_vec(),
    }
}

/// What the server has sent.
#[derive(Clone, Default)]
struct Sent(Arc<Mutex<Vec<u8>>>);

impl Write for Sent {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut sent = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        sent.extend(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Asserts that these are acknowledgements and packets with their sums.
fn check(sent: &[u8]) {
    let mut rest = sent;
    while let Some((&first, after)) = rest.split_first() {
        rest = after;
        if first != b'$' {
            assert!(matches!(first, b'+' | b'-'), "{first:#x}");
            continue;
        }
        let end = rest.iter().position(|&byte| byte == b'#');
        // The last packet may have been cut off by the end of the session.
        let Some((body, sum)) =
            end.and_then(|end| Some((&rest[..end], rest.get(end + 1..end + 3)?)))
        else {
            return;
        };
        let expected = body.iter().fold(0_u8, |sum, &byte| sum.wrapping_add(byte));
        assert_eq!(sum, format!("{expected:02x}").as_bytes());
        rest = &rest[body.len() + 3..];
    }
}

/// Serves a debugger that sends the input to two running SPEs. Neither the server nor an SPE may
/// panic or hang, and both SPEs stop when they are asked to.
pub fn gdb(input: &[u8]) {
    let machine = Machine::new(Arc::new(RegisteredMemory::new()));
    let debugger = Debugger::new(|| ());
    let sent = Sent::default();
    thread::scope(|scope| {
        let runs = PROGRAMS.map(|program| {
            let spe = Spe::new(&machine, Config::default());
            for (at, word) in (0..).step_by(4).zip(program) {
                spe.local_store().write(at, &word.to_be_bytes());
            }
            let attached = debugger.attach(&spe);
            let running = Arc::clone(&spe);
            let run = scope.spawn(move || {
                let look = |spu: &mut _, cycles| attached.before_instruction(spu, cycles);
                if let Some(stopped) = running.run_stepwise(0, look, |_| ()) {
                    attached.stopped(&running, &stopped, signal_of(&stopped.reason));
                }
            });
            (spe, run)
        });
        debugger.serve(Cursor::new(stream(input)), sent.clone());
        for (spe, run) in runs {
            spe.request_stop();
            if let Err(panic) = run.join() {
                std::panic::resume_unwind(panic);
            }
        }
    });
    check(&sent.0.lock().unwrap_or_else(PoisonError::into_inner));
}
