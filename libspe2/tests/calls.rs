//! Calls that the library itself serves: C99 streams, POSIX.1, memory in effective address space,
//! system calls. This is a separate program without the test harness, because it replaces standard
//! output by a file.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]

use std::ffi::CString;
use std::fs::{self, File};
use std::os::fd::AsRawFd as _;
use std::os::unix::ffi::OsStrExt as _;
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;
use std::ptr;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering::SeqCst};

use spe2::callback::{Handler, spe_callback_handler_query, spe_callback_handler_register};
use spe2::context::{spe_context_create, spe_context_destroy, spe_ls_area_get};
use spe2::image::{spe_image_close, spe_image_open, spe_program_load};
use spe2::run::spe_context_run;
use spe2::types::{
    SPE_CALLBACK_ERROR, SPE_CALLBACK_UPDATE, SPE_DEFAULT_ENTRY, SPE_EXIT, SpeStopInfo,
    SpeStopResult,
};

/// Makes two system calls as newlib does: getpid, and a write of its text from local store. $6
/// holds the effective address of local store.
const SYSTEM_CALLS: &str = "
        stop    0x2104
        .long   getpid
        ila     $10,text
        rotqbyi $11,$6,4
        a       $11,$11,$10
        lqa     $12,write_ea
        cwd     $13,0($1)
        shufb   $12,$6,$12,$13
        cwd     $13,4($1)
        shufb   $12,$11,$12,$13
        stqa    $12,write_ea
        stop    0x2104
        .long   write
        stop    0x2104
        .long   unknown
        stop    0x2000
        .data
        .align  4
        .quad   0
getpid: .quad   20, 0, 0, 0, 0, 0, 0
        .quad   0, 0
write:  .quad   4, 1
write_ea: .quad 0, 8, 0, 0
        .quad   0
unknown: .quad  2, 0, 0, 0, 0, 0, 0
text:   .ascii  \"by call\\n\"
";

struct Outcome {
    reason: u32,
    code: i32,
    store: Vec<u8>,
}

fn image(source: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let sources = folder.path().join("sources");
    fs::create_dir(&sources).unwrap();
    fs::write(sources.join("program.s"), source).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = folder.path().join("program");
    let tools = spu_build::Tools::find().unwrap();
    let programs = root.join("../emulator/spu-tool/tests/programs");
    spu_build::Image::from_folder(&sources, &programs.join("program.ld"))
        .unwrap()
        .include(&programs)
        .build(&tools, &folder.path().join("objects"), &path)
        .unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    (folder, path)
}

fn run(source: &str) -> Outcome {
    let (_folder, path) = image(source);
    let name = CString::new(path.as_os_str().as_bytes()).unwrap();
    let mut info =
        SpeStopInfo { stop_reason: 0, result: SpeStopResult { reserved: 0 }, spu_status: 0 };
    let mut store = vec![0; 0x40000];
    // SAFETY: the context lives to the end of the block, and everything else longer.
    unsafe {
        let program = spe_image_open(name.as_ptr());
        let context = spe_context_create(0, ptr::null_mut());
        assert!(!program.is_null() && !context.is_null());
        assert_eq!(spe_program_load(context, program), 0);
        assert_eq!(spe_image_close(program), 0);
        let mut entry = SPE_DEFAULT_ENTRY;
        let (none, info) = (ptr::null_mut(), &raw mut info);
        spe_context_run(context, &raw mut entry, 0, none, none, info);
        let area = spe_ls_area_get(context).cast::<u8>();
        ptr::copy_nonoverlapping(area, store.as_mut_ptr(), store.len());
        assert_eq!(spe_context_destroy(context), 0);
    }
    Outcome {
        reason: info.stop_reason,
        // SAFETY: every stop reason sets the int.
        code: unsafe { info.result.code },
        store,
    }
}

/// The output of `body` to standard output, through C's streams.
fn printed(body: impl FnOnce()) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("output");
    let file = File::create(&path).unwrap();
    // SAFETY: these calls take numbers, and NULL for all streams.
    let saved = unsafe {
        libc::fflush(ptr::null_mut());
        let saved = libc::dup(1);
        libc::dup2(file.as_raw_fd(), 1);
        saved
    };
    body();
    // SAFETY: as above.
    unsafe {
        libc::fflush(ptr::null_mut());
        libc::dup2(saved, 1);
        libc::close(saved);
    }
    fs::read_to_string(path).unwrap()
}

fn print(text: &std::ffi::CStr) {
    // SAFETY: the format prints one string.
    unsafe { libc::printf(c"%s".as_ptr(), text.as_ptr()) };
}

/// The library's own handler, which the test's calls.
static OWN: AtomicUsize = AtomicUsize::new(0);
static CALLS: AtomicU32 = AtomicU32::new(0);

unsafe extern "C" fn counting(ls_base: *mut libc::c_void, ls_address: u32) -> i32 {
    CALLS.fetch_add(1, SeqCst);
    // SAFETY: the address is that of the library's handler, which gets what this one got.
    unsafe {
        let own: *const () = ptr::with_exposed_provenance(OWN.load(SeqCst));
        std::mem::transmute::<*const (), Handler>(own)(ls_base, ls_address)
    }
}

/// C programs print by the process's own streams, in the order of both sides' calls.
fn hello_world() {
    let hello = include_str!("../../emulator/spu-tool/tests/programs/hello.s");
    let output = printed(|| {
        print(c"before\n");
        let outcome = run(hello);
        // main returns what printf returned.
        assert_eq!((outcome.reason, outcome.code), (SPE_EXIT, 42));
        print(c"after\n");
    });
    let expected = "before\nhello, moon: -42, 3.142, 123456789012345!\nafter\n";
    assert_eq!(output, expected);
}

fn handlers_can_be_wrapped() {
    // SAFETY: the handler has the right type.
    unsafe {
        let own = spe_callback_handler_query(0);
        OWN.store(own.expose_provenance(), SeqCst);
        let handler = counting as *mut libc::c_void;
        let registered = spe_callback_handler_register(handler, 0, SPE_CALLBACK_UPDATE);
        assert_eq!(registered, 0);
        hello_world();
        assert_eq!(CALLS.load(SeqCst), 1);
        let registered = spe_callback_handler_register(own, 0, SPE_CALLBACK_UPDATE);
        assert_eq!(registered, 0);
    }
}

fn files_and_memory() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    let source = format!(
        "
        .include \"runtime.inc\"
        .type   main,@function
main:   enter
        ila     $3,path
        il      $4,0x241
        il      $5,0x180
        brsl    $lr,open
        stqd    $3,32($sp)
        ila     $4,path
        il      $5,4
        brsl    $lr,write
        lqd     $3,32($sp)
        brsl    $lr,close
        lqa     $3,size
        brsl    $lr,malloc_ea
        stqa    $3,result
        il      $3,0
        leave
        .data
        .align  4
size:   .quad   0x1000, 0
result: .quad   0, 0
        .long   0x0dec0ded
path:   .asciz  \"{}\"
",
        path.display()
    );
    let outcome = run(&source);
    assert_eq!((outcome.reason, outcome.code), (SPE_EXIT, 0));
    let text = path.to_str().unwrap().as_bytes();
    assert_eq!(fs::read(&path).unwrap(), text[..4]);
    let marker = 0x0dec_0ded_u32.to_be_bytes();
    let at = outcome.store.windows(4).position(|word| word == marker);
    let at = at.unwrap() - 16;
    let ea = u64::from_be_bytes(outcome.store[at..at + 8].try_into().unwrap());
    assert_ne!(ea, 0);
    let memory: *mut u8 = ptr::with_exposed_provenance_mut(ea as usize);
    // SAFETY: the program allocated 0x1000 bytes with malloc_ea and leaves them to this side.
    unsafe {
        assert_eq!((memory.read(), memory.add(0xfff).read()), (0, 0));
        libc::free(memory.cast());
    }
}

fn system_calls() {
    let source = format!(".global _start\n_start:\n{SYSTEM_CALLS}");
    let mut store = Vec::new();
    let output = printed(|| {
        let outcome = run(&source);
        assert_eq!((outcome.reason, outcome.code), (SPE_EXIT, 0));
        store = outcome.store;
    });
    assert_eq!(output, "by call\n");
    let text = b"by call\n";
    let end = store.windows(8).position(|bytes| bytes == text).unwrap();
    let result = |words: usize| {
        let at = end - 8 * words;
        i64::from_be_bytes(store[at..at + 8].try_into().unwrap())
    };
    assert_eq!(result(7), -i64::from(libc::ENOSYS));
    assert_eq!(result(14), 8, "bytes written");
    assert_eq!(result(23), i64::from(std::process::id()));
}

fn undefined_calls_end_the_run_with_an_error() {
    for (stop, block, code) in
        [(0x2100, 42 << 24, 1), (0x2101, 0, 1), (0x2102, 1 << 24, -1), (0x2104, 0x3fff8, -1)]
    {
        let outcome =
            run(&format!(".global _start\n_start: stop {stop}\n .long {block}\n stop 0x2000\n"));
        assert_eq!((outcome.reason, outcome.code), (SPE_CALLBACK_ERROR, code), "{stop:#x}");
    }
}

fn main() {
    hello_world();
    handlers_can_be_wrapped();
    files_and_memory();
    system_calls();
    undefined_calls_end_the_run_with_an_error();
    println!("calls: ok");
}
