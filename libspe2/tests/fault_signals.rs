//! Faults of contexts without events are signals to the thread that runs them. This is a separate
//! program without the test harness, because signal handlers belong to the whole process, and
//! because it forks, which needs a process without other threads.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]
#![expect(
    clippy::undocumented_unsafe_blocks,
    reason = "each block calls the C library or the C API with pointers that outlive the call"
)]

use std::mem::MaybeUninit;
use std::ptr;
use std::sync::atomic::{AtomicI32, AtomicU64, Ordering::SeqCst};
use std::time::{Duration, Instant};

use spe2::context::{spe_context_create, spe_context_destroy, spe_ls_area_get};
use spe2::run::spe_context_run;
use spe2::types::{SPE_RUNTIME_FATAL, SpeStopInfo, SpeStopResult};

static SIGNAL: AtomicI32 = AtomicI32::new(0);
static CODE: AtomicI32 = AtomicI32::new(0);
static ADDRESS: AtomicU64 = AtomicU64::new(0);

extern "C" fn note(signal: i32, info: *mut libc::siginfo_t, _: *mut libc::c_void) {
    SIGNAL.store(signal, SeqCst);
    unsafe {
        CODE.store((*info).si_code, SeqCst);
        ADDRESS.store((*info).si_addr() as u64, SeqCst);
    }
}

fn handle(signal: i32, flags: i32) {
    unsafe {
        let mut action = MaybeUninit::<libc::sigaction>::zeroed().assume_init();
        action.sa_sigaction = note as *const () as usize;
        action.sa_flags = libc::SA_SIGINFO | flags;
        assert_eq!(libc::sigaction(signal, &raw const action, ptr::null_mut()), 0);
    }
}

/// Runs words from address 0 without events. Returns the return value, stop reason and result.
fn run(words: &[u32]) -> (i32, u32, i32) {
    unsafe {
        let context = spe_context_create(0, ptr::null_mut());
        assert!(!context.is_null());
        let area: *mut [u8; 4] = spe_ls_area_get(context).cast();
        for (n, word) in words.iter().enumerate() {
            area.add(n).write(word.to_be_bytes());
        }
        let mut entry = 0;
        let mut info =
            SpeStopInfo { stop_reason: 0, result: SpeStopResult { reserved: 0 }, spu_status: 0 };
        let none = ptr::null_mut();
        let returned = spe_context_run(context, &raw mut entry, 0, none, none, &raw mut info);
        assert_eq!(spe_context_destroy(context), 0);
        (returned, info.stop_reason, info.result.code)
    }
}

const STOP: u32 = 0x2000;
const INVALID: u32 = 0x0080_0000;
const STOPD: u32 = 0x140 << 21;

/// `il $10,value` and `wrch $channel,$10`
fn set(channel: u32, value: u32) -> [u32; 2] {
    [0x081 << 23 | value << 7 | 10, 0x10d << 21 | channel << 7 | 10]
}

/// A get of `size` bytes from `ea`, then stop 0x2000.
fn get(opcode: u32, ea: u32, size: u32) -> Vec<u32> {
    let parameters = [(18, ea), (19, size), (21, opcode)];
    let writes = parameters.iter().flat_map(|&(c, v)| set(c, v));
    writes.chain([STOP]).collect()
}

/// Returns how a child that runs the words ended: the signal that killed it, or its exit status
/// negated.
fn end_of_child(prepare: impl FnOnce(), words: &[u32]) -> i32 {
    unsafe {
        let child = libc::fork();
        assert!(child >= 0);
        if child == 0 {
            let no_core = libc::rlimit { rlim_cur: 0, rlim_max: 0 };
            libc::setrlimit(libc::RLIMIT_CORE, &raw const no_core);
            prepare();
            run(words);
            libc::_exit(3);
        }
        let begin = Instant::now();
        let mut status = 0;
        while libc::waitpid(child, &raw mut status, libc::WNOHANG) == 0 {
            if begin.elapsed() > Duration::from_secs(600) {
                libc::kill(child, libc::SIGKILL);
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        if libc::WIFSIGNALED(status) { libc::WTERMSIG(status) } else { -libc::WEXITSTATUS(status) }
    }
}

fn main() {
    // (program, signal, si_code, si_addr)
    let cases = [
        (get(0x40, 0x400, 24), libc::SIGBUS, 1, 0),
        (get(0x43, 0x400, 16), libc::SIGBUS, 3, 0),
        (get(0x40, 0x400, 16), libc::SIGSEGV, 2, 0x400),
        (vec![INVALID, STOP], libc::SIGILL, 1, 0),
        (vec![STOPD, STOP], libc::SIGTRAP, 0x80, 0),
    ];
    for (words, signal, ..) in &cases {
        let default = || unsafe {
            libc::signal(*signal, libc::SIG_DFL);
        };
        assert_eq!(end_of_child(default, words), *signal);
        // A fault can't be ignored.
        let ignored = || unsafe {
            libc::signal(*signal, libc::SIG_IGN);
        };
        assert_eq!(end_of_child(ignored, words), *signal);
    }
    // Nor can a fault of the program itself, which the library's handler passes on.
    for action in [libc::SIG_DFL, libc::SIG_IGN] {
        let fault = || unsafe {
            libc::signal(libc::SIGSEGV, action);
            run(&[STOP]);
            ptr::with_exposed_provenance::<u8>(8).read_volatile();
        };
        assert_eq!(end_of_child(fault, &[STOP]), libc::SIGSEGV);
    }
    for (words, signal, code, address) in &cases {
        handle(*signal, 0);
        assert_eq!(run(words), (-1, SPE_RUNTIME_FATAL, libc::EINTR));
        assert_eq!(SIGNAL.swap(0, SeqCst), *signal);
        // QEMU allows no code and address there: see the head of the library's fault_signal.rs.
        if cfg!(not(target_arch = "powerpc64")) {
            assert_eq!(CODE.load(SeqCst), *code);
            assert_eq!(ADDRESS.load(SeqCst), *address);
        }
    }
    // With a handler that has SA_RESTART, the run continues after the fault.
    handle(libc::SIGSEGV, libc::SA_RESTART);
    assert_eq!(run(&get(0x40, 0x400, 16)), (0, 1, 0));
    assert_eq!(SIGNAL.load(SeqCst), libc::SIGSEGV);
    println!("faults are signals: ok");
}
