//! The text that console commands print.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use spu_emulator::elf::Image;
use spu_emulator::interp::Spu;
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::simulated::command_name;
use spu_emulator::spe::ChannelState;
use spu_isa::{Instruction, LIMIT_MASK, Op, disassemble};

use super::command::Wanted;

const PLACE: usize = 28;
/// Instructions that are shown before the program counter.
const BEFORE: u32 = 4;

/// An instruction's text. A stop includes its code, which objdump leaves out.
#[must_use]
pub fn instruction_text(word: u32, address: u32) -> String {
    if let Some(Instruction { op: Op::Stop, immediate, .. }) = Instruction::decode(word) {
        return format!("stop {immediate:#06x}");
    }
    let text = disassemble(word, address).to_string();
    // The comment only repeats a constant from the operands.
    let text = text.split("\t#").next().unwrap_or(&text);
    text.replace('\t', " ")
}

/// An instruction with its place.
pub fn line(image: &Image<'_>, store: &LocalStore, pc: u32) -> String {
    let text = instruction_text(store.load_word(pc), pc);
    format!("{:PLACE$} {text}", image.place(pc))
}

/// Where a listing around `pc` begins: not before its function.
pub fn before(image: &Image<'_>, pc: u32) -> u32 {
    let most = 4 * BEFORE;
    let distance = image.nearest_symbol(pc).map_or(0, |(_, distance)| distance);
    pc - distance.min(most)
}

/// A listing of instructions. The one at `pc` and those with breakpoints are marked.
pub fn code(
    image: &Image<'_>,
    store: &LocalStore,
    (start, count): (u32, u32),
    pc: u32,
    breakpoints: &BTreeSet<u32>,
) -> String {
    let start = start & LIMIT_MASK & !3;
    let end = start.saturating_add(4 * count).min(SIZE);
    let mut text = String::new();
    for address in (start..end).step_by(4) {
        let mark = match (address == pc, breakpoints.contains(&address)) {
            (true, _) => '>',
            (false, true) => '*',
            (false, false) => ' ',
        };
        let _ = writeln!(text, "{mark} {}", line(image, store, address));
    }
    text
}

/// Words of local store, four a line.
pub fn memory(store: &LocalStore, address: u32, count: u32) -> String {
    let start = address & !3;
    let end = start.saturating_add(4 * count).min(SIZE);
    let mut text = String::new();
    for line in (start..end).step_by(16) {
        let _ = write!(text, "{line:#07x}:");
        for address in (line..end.min(line + 16)).step_by(4) {
            let _ = write!(text, " {:08x}", store.load_word(address));
        }
        text.push('\n');
    }
    text
}

/// Registers, one a line; all of them with the program counter.
pub fn registers(spu: &Spu, wanted: &Wanted) -> String {
    let mut text = String::new();
    let mut numbers = wanted.numbers.clone();
    if numbers.is_empty() {
        let _ = writeln!(text, "pc    {:#07x}", spu.pc());
        numbers = (0..128).collect();
    }
    for number in numbers {
        let words = spu.register(number).0;
        let words = words.map(|word| match wanted.as_floats {
            true => format!("{:>13}", show_float(word)),
            false => format!("{word:08x}"),
        });
        let name = format!("${number}");
        let _ = writeln!(text, "{name:5} {}", words.join(" "));
    }
    text
}

/// The value of an SPU's single. The largest exponent belongs to numbers, too, and denormals are 0.
fn show_float(word: u32) -> String {
    let sign = if word >> 31 == 1 { -1.0 } else { 1.0 };
    let exponent = (word >> 23 & 0xff) as i32;
    let fraction = f64::from(word & 0x7f_ffff) / f64::from(1 << 23);
    let value = match exponent {
        0 => 0.0,
        _ => (1.0 + fraction) * 2_f64.powi(exponent - 127),
    };
    let value = sign * value;
    let magnitude = value.abs();
    if magnitude == 0.0 || (1e-4..1e7).contains(&magnitude) {
        format!("{:.7}", value).trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.6e}")
    }
}

pub fn frames(image: &Image<'_>, frames: &[u32]) -> String {
    let line = |(number, &address): (usize, &u32)| format!("#{number} {}\n", image.place(address));
    frames.iter().enumerate().map(line).collect()
}

fn tags(mask: u32) -> String {
    let tags = (0..32).filter(|tag| mask >> tag & 1 == 1);
    let tags: Vec<String> = tags.map(|tag| tag.to_string()).collect();
    if tags.is_empty() { "none".into() } else { tags.join(" ") }
}

fn status(status: Option<u32>) -> String {
    status.map_or("none".into(), |status| format!("{status:#x}"))
}

/// The MFC's commands and tags.
pub fn mfc(state: &ChannelState) -> String {
    let mut text = String::new();
    let mut busy = 0;
    for command in &state.commands {
        let name = command_name(command.opcode);
        let is_atomic = matches!(name, "getllar" | "putllc" | "putlluc");
        let tag = if is_atomic {
            "no tag".into()
        } else {
            busy |= 1 << command.tag;
            format!("tag {}", command.tag)
        };
        let _ = writeln!(
            text,
            "{name:9} {:6} bytes, local store {:#07x}, effective address {:#x}, {tag}",
            command.size, command.lsa, command.ea
        );
    }
    if state.commands.is_empty() {
        text += "no command is under way\n";
    }
    let _ = writeln!(text, "busy tags            {}", tags(busy));
    let _ = writeln!(text, "tag mask             {}", tags(state.tag_mask));
    let _ = writeln!(text, "tag status           {}", status(state.tag_status));
    let _ = writeln!(text, "stalled lists        {}", tags(state.stalled_tags));
    let _ = writeln!(text, "atomic status        {}", status(state.atomic_status));
    text
}

/// Mailboxes, signals, events and the decrementer.
pub fn channels(state: &ChannelState) -> String {
    let signal = |at: usize| if state.signals[at] { "waits" } else { "none" };
    let words = |count: usize| match count {
        1 => "1 word".into(),
        count => format!("{count} words"),
    };
    format!(
        "inbound mailbox      {}\n\
         outbound mailbox     {}\n\
         outbound interrupt   {}\n\
         signal 1             {}\n\
         signal 2             {}\n\
         events               {:#06x}, enabled {:#06x}\n\
         decrementer          {:#010x}\n",
        words(state.inbound),
        words(state.outbound),
        words(state.outbound_interrupt),
        signal(0),
        signal(1),
        state.events,
        state.event_mask,
        state.decrementer,
    )
}

#[cfg(test)]
mod tests {
    use super::show_float;

    #[test]
    fn floats_are_the_spus() {
        let cases = [
            (0x3f80_0000, "1"),
            (0xc020_0000, "-2.5"),
            (0x0000_0001, "0"),
            (0x3a83_126f, "0.001"),
            // Beyond IEEE's numbers.
            (0x7f80_0000, "3.402824e38"),
        ];
        for (word, text) in cases {
            assert_eq!(show_float(word), text, "{word:#x}");
        }
    }
}
