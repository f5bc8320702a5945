//! The disassembly, with labels and source lines.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use spu_emulator::elf::Image;
use spu_emulator::local_store::SIZE;
use spu_isa::LIMIT_MASK;
use spu_isa::{Instruction, Operand};
use spu_scheduler::code::{Code, CodeError};

use spu_debugger::console::instruction_text;

/// Column of the instruction's text.
const TEXT: usize = 32;

/// The words to list, and their source lines where they are known.
struct Words {
    words: Vec<(u32, u32)>,
    sources: BTreeMap<u32, String>,
}

/// Writes the code. The error describes the fault of the file.
pub fn write(bytes: &[u8], image: &Image<'_>, text: &mut String) -> Result<(), String> {
    let Words { words, sources } = match Code::parse(bytes) {
        Ok(code) => of_sections(&code),
        // Without sections it is unknown what is code, so everything that is loaded is listed.
        Err(CodeError::Empty) => of_segments(image),
        Err(error) => return Err(error.to_string()),
    };
    text.push_str("\ndisassembly\n");
    let mut line_before = None;
    let mut next = None;
    for (address, word) in words {
        if next.is_some_and(|next| next != address) {
            text.push('\n');
        }
        next = Some(address + 4);
        if let Some((name, 0)) = image.nearest_symbol(address) {
            let _ = writeln!(text, "\n{name}:");
        }
        let line = sources.get(&address);
        if line != line_before {
            if let Some(line) = line {
                let _ = writeln!(text, "; {line}");
            }
            line_before = line;
        }
        let code = instruction_text(word, address);
        let target = target(word, address).map_or_else(String::new, |target| {
            format!(
                "{:width$} {}",
                "",
                image.place(target),
                width = TEXT.saturating_sub(code.len())
            )
        });
        let _ = writeln!(text, "  {address:05x}  {word:08x}  {code}{target}");
    }
    Ok(())
}

fn of_sections(code: &Code) -> Words {
    let sources = code.sources().into_iter().map(|(address, source)| {
        let file = source.file.file_name().map_or(source.file.as_path(), Path::new);
        (address, format!("{}:{}", file.display(), source.line))
    });
    Words { words: code.words(0, SIZE), sources: sources.collect() }
}

fn of_segments(image: &Image<'_>) -> Words {
    let words = image.segments().iter().flat_map(|segment| {
        let (words, _) = segment.bytes.as_chunks();
        let addresses = (segment.address..).step_by(4);
        addresses.zip(words.iter().map(|&word| u32::from_be_bytes(word)))
    });
    Words { words: words.collect(), sources: BTreeMap::new() }
}

/// The address that an instruction's operand refers to.
fn target(word: u32, pc: u32) -> Option<u32> {
    let instruction = Instruction::decode(word)?;
    instruction.op.row().operands.iter().find_map(|operand| match operand {
        Operand::Relative => Some(pc.wrapping_add_signed(instruction.immediate) & LIMIT_MASK),
        Operand::Absolute => Some(instruction.immediate as u32 & LIMIT_MASK),
        _ => None,
    })
}
