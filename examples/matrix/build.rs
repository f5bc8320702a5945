//! Writes the unrolled kernel, and builds the SPU program.
//!
//! The design is Kurzak's: the even pipe has a multiply-add in every cycle, and everything else
//! goes into the odd pipe beside it. A block of four rows and sixteen columns of C stays in 16
//! registers while k runs. A step multiplies four k: 64 multiply-adds. Beside them the odd pipe
//! loads the next step's 16 quadwords of B and 4 of A, and copies each word of A into all slots.
//! That takes 36 of the step's 64 slots. Four more load and store C: the block after this one is
//! loaded into a second set of registers, and the block before is stored from it.
//!
//! A pass of the loop has four blocks, so four whole rows of C, and 16 passes do it all. Apart from
//! the multiply-adds the even pipe has three instructions a pass: two pointers and the counter.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// Quadwords of a row of 64 columns, and quadwords of k.
const ROW: usize = 16;
/// Rows, and quadwords of columns, of a block.
const BLOCK: usize = 4;
/// Steps of a block, and of a pass.
const STEPS: usize = ROW;
const PASS: usize = STEPS * ROW / BLOCK;

/// Bytes of a block's rows.
const ROWS: usize = BLOCK * ROW * 16;

/// The first registers of: both sets of C, both of B, both of A's words, and A's quadwords.
const C: [usize; 2] = [10, 26];
const B: [usize; 2] = [42, 58];
const WORDS: [usize; 2] = [74, 90];
const A: usize = 106;
/// The shuffles that copy word n, and the pointers: A and C at the pass's first row, and the middle
/// of B, from which an immediate offset reaches all of it.
const SPLAT: usize = 110;
const A_ROW: usize = 114;
const C_ROW: usize = 115;
const B_MIDDLE: usize = 116;
const LEFT: usize = 117;
const STRIDE: usize = 118;

fn main() -> ExitCode {
    spu_build::embed("matrix.elf", || {
        let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
        let kernel = out.join("kernel.s");
        let written = fs::write(&kernel, kernel_source());
        let failed = |source| spu_build::Error::File { path: kernel.clone(), source };
        written.map_err(failed)?;
        let image =
            spu_build::Image::from_folder(Path::new("spu"), "../../linker/spu.ld".as_ref())?;
        Ok(image.source(&kernel).without_line_tables())
    })
}

/// The odd pipe's instructions of a step: what the next step, and the blocks around it, need.
fn odd(step: usize) -> Vec<(usize, String)> {
    let next = step + 1;
    let (set, k) = (next % 2, next % STEPS);
    // Beyond the pass's last step comes the first of the next four rows.
    let rows = next / PASS * BLOCK;
    let columns = next % PASS / STEPS * BLOCK;
    // A slot, and what goes there or into the next free one.
    let mut code = Vec::new();
    for row in 0..BLOCK {
        let offset = ((rows + row) * ROW + k) * 16;
        code.push((row, format!("lqd ${},{offset}(${A_ROW})", A + row)));
    }
    for part in 0..4 {
        for column in 0..BLOCK {
            let row = 4 * k + part;
            let offset = ((row * ROW + columns + column) * 16) as isize - 8192;
            let register = B[set] + 4 * part + column;
            code.push((4, format!("lqd ${register},{offset}(${B_MIDDLE})")));
        }
        for row in 0..BLOCK {
            let (to, from) = (WORDS[set] + 4 * part + row, A + row);
            let shuffle = SPLAT + part;
            code.push((12, format!("shufb ${to},${from},${from},${shuffle}")));
        }
    }
    // In the first eight steps of a block, the one before is stored; in the rest, the one after it
    // is loaded to where that was.
    let block = step / STEPS;
    let other = C[(block + 1) % 2];
    let within = step % STEPS;
    for part in 0..2 {
        let index = within % 8 * 2 + part;
        let (row, column) = (index / BLOCK, index % BLOCK);
        // In quadwords from the pass's first row.
        let at = |block: isize| {
            let blocks = ROW as isize / BLOCK as isize;
            let rows = block.div_euclid(blocks) * BLOCK as isize + row as isize;
            rows * ROW as isize + block.rem_euclid(blocks) * BLOCK as isize + column as isize
        };
        let register = other + index;
        code.push(if within < 8 {
            let offset = at(block as isize - 1) * 16;
            (50, format!("stqd ${register},{offset}(${C_ROW})"))
        } else {
            let offset = at(block as isize + 1) * 16;
            (50, format!("lqd ${register},{offset}(${C_ROW})"))
        });
    }
    code
}

fn kernel_source() -> String {
    let mut text =
        "# Written by build.rs: C += A * B, 64x64 singles, from matrix_a, matrix_b and matrix_c.
        .text
        .global multiply
        .balign 8
multiply:
"
        .to_owned();
    let mut line = |code: &str| {
        // Writing to a string can't fail.
        let _ = writeln!(text, "        {code}");
    };
    for part in 0..4 {
        line(&format!("lqa ${},splat+{}", SPLAT + part, 16 * part));
    }
    line(&format!("ila ${A_ROW},matrix_a"));
    line(&format!("ila ${C_ROW},matrix_c"));
    line(&format!("ila ${B_MIDDLE},matrix_b+8192"));
    line(&format!("il ${LEFT},{}", 64 / BLOCK));
    line(&format!("il ${STRIDE},{ROWS}"));
    // The inputs of the first step. The block before the first is stored too, in front of C, where
    // nothing is.
    for index in 0..BLOCK * BLOCK {
        let (row, column) = (index / BLOCK, index % BLOCK);
        let first = (row * ROW + column) * 16;
        line(&format!("lqd ${},{first}(${C_ROW})", C[0] + index));
    }
    for row in 0..BLOCK {
        line(&format!("lqd ${},{}(${A_ROW})", A + row, row * ROW * 16));
    }
    for part in 0..4 {
        for index in 0..BLOCK {
            let offset = ((part * ROW + index) * 16) as isize - 8192;
            let (b, word, a) = (B[0] + 4 * part + index, WORDS[0] + 4 * part + index, A + index);
            line(&format!("lqd ${b},{offset}(${B_MIDDLE})"));
            line(&format!("shufb ${word},${a},${a},${}", SPLAT + part));
        }
    }
    line(".balign 8");
    line("1:");
    for step in 0..PASS {
        let set = step % 2;
        let c = C[step / STEPS % 2];
        let mut odd = odd(step).into_iter().peekable();
        for slot in 0..64 {
            let (part, row, column) = (slot / 16, slot / 4 % 4, slot % 4);
            let (c, a, b) =
                (c + slot % 16, WORDS[set] + 4 * part + row, B[set] + 4 * part + column);
            line(&format!("fma ${c},${a},${b},${c}"));
            let beside = odd.next_if(|(earliest, _)| *earliest <= slot);
            let beside = match beside {
                Some((_, code)) => code,
                None if step == PASS - 1 && slot == 45 => "hbrr 2f,1b".to_owned(),
                None => "lnop".to_owned(),
            };
            line(&beside);
        }
        assert!(odd.next().is_none(), "a step has too many instructions for the odd pipe");
    }
    line(&format!("ai ${LEFT},${LEFT},-1"));
    line("lnop");
    line(&format!("a ${A_ROW},${A_ROW},${STRIDE}"));
    line("lnop");
    line(&format!("a ${C_ROW},${C_ROW},${STRIDE}"));
    line("2:");
    line(&format!("brnz ${LEFT},1b"));
    // The last block, and the way back.
    line("hbr 3f,$0");
    for index in 0..BLOCK * BLOCK {
        let (row, column) = (index / BLOCK, index % BLOCK);
        let offset = (row * ROW + ROW - BLOCK + column) as isize * 16 - ROWS as isize;
        line(&format!("stqd ${},{offset}(${C_ROW})", C[1] + index));
    }
    line("3:");
    line("bi $0");
    text
}
