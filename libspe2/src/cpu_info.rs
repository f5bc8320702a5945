//! The machine that the program sees: on the emulator, a PlayStation 3.

use libc::c_int;

use crate::backend::{Choice, chosen};
use crate::error::{self, Errno, set_errno};
use crate::spufs::processor;
use crate::types::{
    SPE_COUNT_PHYSICAL_CPU_NODES, SPE_COUNT_PHYSICAL_SPES, SPE_COUNT_USABLE_SPES,
    SPE_CPU_IS_CELLBE, SPE_CPU_TYPE,
};

const NODES: c_int = 1;
/// The number of SPEs that Linux can use on a PlayStation 3.
const DEFAULT_SPES: c_int = 6;
const MAX_SPES: c_int = 16;
const VARIABLE: &str = "LIBSPE2_SPES";

fn spes() -> Result<c_int, Errno> {
    let Some(text) = std::env::var_os(VARIABLE) else {
        return match chosen()? {
            Choice::Emulator => Ok(DEFAULT_SPES),
            Choice::Spufs => processor::spes(),
        };
    };
    let number = text.to_str().and_then(|text| text.parse().ok());
    number.filter(|number| (1..=MAX_SPES).contains(number)).ok_or_else(|| {
        messages::print!("libspe2: {VARIABLE} must be a number from 1 to {MAX_SPES}, not {text:?}");
        Errno(libc::EINVAL)
    })
}

fn nodes() -> Result<c_int, Errno> {
    match chosen()? {
        Choice::Emulator => Ok(NODES),
        Choice::Spufs => processor::nodes(),
    }
}

fn kind() -> Result<c_int, Errno> {
    match chosen()? {
        Choice::Emulator => Ok(SPE_CPU_IS_CELLBE),
        Choice::Spufs => Ok(processor::kind()),
    }
}

/// The SPEs of one node, or of all.
fn spes_of(node: c_int) -> Result<c_int, Errno> {
    let nodes = nodes()?;
    match node {
        -1 => spes(),
        node if (0..nodes).contains(&node) => Ok(spes()? / nodes),
        _ => Err(Errno(libc::EINVAL)),
    }
}

/// Returns the number of nodes or SPEs, or the kind of Cell.
///
/// # Safety
/// None beyond the C calling convention.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_cpu_info_get(info_requested: c_int, cpu_node: c_int) -> c_int {
    error::int(|| {
        set_errno(0);
        match info_requested {
            SPE_COUNT_PHYSICAL_CPU_NODES if cpu_node == -1 => nodes(),
            SPE_COUNT_PHYSICAL_SPES | SPE_COUNT_USABLE_SPES => spes_of(cpu_node),
            SPE_CPU_TYPE => kind(),
            _ => Err(Errno(libc::EINVAL)),
        }
    })
}
