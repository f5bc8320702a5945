//! `LIBSPE2_TIMING`, `LIBSPE2_REPORT`, `LIBSPE2_PROFILE` and `LIBSPE2_CHECK`. This is a separate
//! program without the test harness, because it runs itself again as a program on libspe2 with an
//! environment of its own.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]

use std::ffi::{CString, OsStr};
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::process::{Command, Output};
use std::ptr;
use std::sync::{Arc, Barrier};
use std::thread;
use std::time::Duration;

use serde_json::Value;
use spe2::context::{spe_context_create, spe_context_destroy};
use spe2::event::{spe_event_handler_create, spe_event_handler_register, spe_event_wait};
use spe2::image::{spe_image_open, spe_program_load};
use spe2::mailbox::{
    spe_in_mbox_status, spe_in_mbox_write, spe_out_intr_mbox_read, spe_out_mbox_read,
};
use spe2::run::{spe_context_run, spe_stop_info_read};
use spe2::types::{
    SPE_DEFAULT_ENTRY, SPE_EVENT_OUT_INTR_MBOX, SPE_EVENT_SPE_STOPPED, SPE_EVENTS_ENABLE,
    SPE_MBOX_ALL_BLOCKING, SPE_MBOX_ANY_NONBLOCKING, SpeContext, SpeEventData, SpeEventUnit,
    SpeStopInfo, SpeStopResult,
};
use spu_build::for_tests::build_instructions;
use spu_reports::views::View;
use spu_reports::{ProfileFile, TimelineFile};
use spu_scheduler::code::Code;

const SPES: usize = 6;
const FRAMES: u32 = 3;

/// Adds to a shared counter until it is 100 times the frame, and replies with its own share. $4
/// holds the counter's address, which libspe2 passes as argp.
const PROGRAM: &str = "
        lr      $2,$4
        rotqbyi $3,$4,4
        cwd     $14,0($13)
frame:  rdch    $10,$ch29
        brz     $10,over
        mpyi    $10,$10,100
        ila     $5,0
take:   command GETLLAR, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        lqa     $15,0x10000
        clgt    $17,$10,$15
        brz     $17,reply
        ai      $16,$15,1
        shufb   $16,$16,$15,$14
        stqa    $16,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        brnz    $12,take
        ai      $5,$5,1
        ila     $20,100
work:   fa      $21,$21,$22
        ai      $20,$20,-1
        brnz    $20,work
        br      take
reply:  command GET, 0x11000, $3, 128, 4
        wait_tags 1<<4
        wrch    $ch30,$5
        br      frame
over:   wrch    $ch28,$5
        stop    0x2007
";

#[repr(align(128))]
struct Line([u8; 128]);

#[derive(Clone, Copy)]
struct Shared(*mut SpeContext);

// SAFETY: any thread may use a libspe2 context.
unsafe impl Send for Shared {}

fn last_error() -> std::io::Error {
    std::io::Error::last_os_error()
}

fn mail(context: Shared, mut word: u32) {
    // SAFETY: the context is alive, and one word can be read.
    let written = unsafe { spe_in_mbox_write(context.0, &raw mut word, 1, SPE_MBOX_ALL_BLOCKING) };
    assert_eq!(written, 1);
}

fn unit(context: Shared, events: u32) -> SpeEventUnit {
    SpeEventUnit { events, spe: context.0, data: SpeEventData { u64: 0 } }
}

fn run(context: Shared, argument: usize, delay: Duration) -> u32 {
    thread::sleep(delay);
    let mut entry = SPE_DEFAULT_ENTRY;
    let argument = ptr::with_exposed_provenance_mut(argument);
    // SAFETY: the context lives to the end of the process, and `entry` can be written.
    let result = unsafe {
        let (none, info) = (ptr::null_mut(), ptr::null_mut());
        spe_context_run(context.0, &raw mut entry, 0, argument, none, info)
    };
    assert_eq!(result, 0, "{}", last_error());
    entry
}

/// The program on libspe2: frames on six SPEs, for whose replies it sleeps. It destroys all of its
/// contexts except the last.
fn program(image: &OsStr, delay: Duration) {
    let mut counter = Line([0; 128]);
    let address = counter.0.as_mut_ptr().expose_provenance();
    let name = CString::new(image.as_bytes()).unwrap();
    // SAFETY: the name is a C string; everything below receives what was just created.
    unsafe {
        let image = spe_image_open(name.as_ptr());
        assert!(!image.is_null(), "{}", last_error());
        let handler = spe_event_handler_create();
        let mut threads = Vec::new();
        let mut contexts = Vec::new();
        for number in 0..SPES {
            let context = Shared(spe_context_create(SPE_EVENTS_ENABLE, ptr::null_mut()));
            assert!(!context.0.is_null(), "{}", last_error());
            assert_eq!(spe_program_load(context.0, image), 0);
            let mut unit = unit(context, SPE_EVENT_OUT_INTR_MBOX | SPE_EVENT_SPE_STOPPED);
            assert_eq!(spe_event_handler_register(handler, &raw mut unit), 0);
            let delay = delay * ((number * 5) % SPES) as u32;
            threads.push(thread::spawn(move || {
                let context = context;
                run(context, address, delay)
            }));
            contexts.push(context);
        }
        let mut sum = 0;
        for frame in 1..=FRAMES {
            for &context in &contexts {
                thread::sleep(delay);
                mail(context, frame);
            }
            let mut replies = 0;
            while replies < SPES {
                let mut found = unit(contexts[0], 0);
                assert_eq!(spe_event_wait(handler, &raw mut found, 1, 200), 1);
                assert_eq!(found.events, SPE_EVENT_OUT_INTR_MBOX);
                let mut share = 0;
                let read = SPE_MBOX_ANY_NONBLOCKING;
                assert_eq!(spe_out_intr_mbox_read(found.spe, &raw mut share, 1, read), 1);
                thread::sleep(delay);
                sum += share;
                replies += 1;
            }
        }
        assert_eq!(sum, 100 * FRAMES);
        for &context in &contexts {
            mail(context, 0);
        }
        for thread in threads {
            let mut found = unit(contexts[0], 0);
            assert_eq!(spe_event_wait(handler, &raw mut found, 1, -1), 1);
            assert_eq!(found.events, SPE_EVENT_SPE_STOPPED);
            let mut info = SpeStopInfo {
                stop_reason: 0,
                result: SpeStopResult { reserved: 0 },
                spu_status: 0,
            };
            assert_eq!(spe_stop_info_read(found.spe, &raw mut info), 0);
            assert_eq!(info.result.code, 7);
            thread.join().unwrap();
        }
        let mut last = 0;
        assert_eq!(spe_out_mbox_read(contexts[0].0, &raw mut last, 1), 1);
        // An event that does not come: 100 ms of simulated time in which no SPE runs.
        let mut none = unit(contexts[0], 0);
        assert_eq!(spe_event_wait(handler, &raw mut none, 1, 100), 0);
        for context in &contexts[1..] {
            assert_eq!(spe_context_destroy(context.0), 0);
        }
    }
}

/// Two threads that call the library and wait for each other in a barrier. One always sleeps there
/// while the other makes its calls.
fn meet() {
    const ROUNDS: usize = 200;
    // SAFETY: a context needs no gang.
    let context = Shared(unsafe { spe_context_create(0, ptr::null_mut()) });
    assert!(!context.0.is_null(), "{}", last_error());
    let barrier = Arc::new(Barrier::new(2));
    let threads = [1, 3].map(|calls| {
        let barrier = Arc::clone(&barrier);
        thread::spawn(move || {
            let context = context;
            for _ in 0..ROUNDS {
                for _ in 0..calls {
                    // SAFETY: the context lives to the end of the process.
                    assert_eq!(unsafe { spe_in_mbox_status(context.0) }, 4);
                }
                barrier.wait();
            }
        })
    });
    for thread in threads {
        thread.join().unwrap();
    }
}

/// Nobody waits for a thread that certainly sleeps until another one wakes it. So the host's time
/// has no part in that.
fn a_barrier_is_no_time_out(folder: &Path) {
    let path = folder.join("report.json");
    let environment = [("LIBSPE2_TIMING", OsStr::new("1")), ("LIBSPE2_REPORT", path.as_os_str())];
    let output = child(&[OsStr::new("meet")], &environment);
    assert!(output.status.success(), "{output:?}");
    let report: Value = serde_json::from_str(&take(&path)).unwrap();
    // QEMU shows other system calls than the program makes.
    if cfg!(target_arch = "x86_64") {
        assert_eq!(number(&report, "timeouts"), 0);
    }
}

/// A program that uses data before it waits for it: all SPEs together get one warning.
fn a_race_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let wait = "        wait_tags 1<<4\n";
    let source = PROGRAM.replace(wait, &format!("        lqa     $23,0x11000\n{wait}"));
    let image = build_instructions(&source, folder.path());
    let arguments = [OsStr::new("run"), image.as_os_str(), OsStr::new("0")];
    let output = child(&arguments, &[("LIBSPE2_TIMING", OsStr::new("1"))]);
    assert!(output.status.success(), "{output:?}");
    let stderr = String::from_utf8(output.stderr).unwrap();
    let parts = [
        "libspe2: warning: DMA race: at ",
        "<reply+0x",
        "a load reads local store at 0x11000",
        "get still writes (128 bytes, local store 0x11000",
        "tag 4",
    ];
    assert!(parts.iter().all(|part| stderr.contains(part)), "{stderr}");
    assert_eq!(stderr.matches("warning").count(), 1, "{stderr}");
}

fn child(arguments: &[&OsStr], environment: &[(&str, &OsStr)]) -> Output {
    let mut command = Command::new(std::env::current_exe().unwrap());
    command.args(arguments);
    for name in ["TIMING", "REPORT", "PROFILE", "TIMELINE", "CHECK", "MFC"] {
        command.env_remove(format!("LIBSPE2_{name}"));
    }
    command.envs(environment.iter().copied()).output().unwrap()
}

/// Runs the program with its files at these paths.
fn run_program(image: &Path, delay: &str, files: &[(&str, &Path)]) {
    let arguments = [OsStr::new("run"), image.as_os_str(), OsStr::new(delay)];
    let mut environment = vec![("LIBSPE2_TIMING", OsStr::new("1"))];
    environment.extend(files.iter().map(|(name, path)| (*name, path.as_os_str())));
    let output = child(&arguments, &environment);
    assert!(output.status.success(), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
}

fn take(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    fs::remove_file(path).unwrap();
    text
}

/// Runs the program and returns its report.
fn report(image: &Path, folder: &Path, delay: &str) -> String {
    let path = folder.join("report.json");
    run_program(image, delay, &[("LIBSPE2_REPORT", &path)]);
    take(&path)
}

/// Runs the program and returns its report and its profile.
fn profile(image: &Path, folder: &Path, delay: &str) -> [String; 2] {
    let paths = ["report.json", "profile.json"].map(|name| folder.join(name));
    let files = [("LIBSPE2_REPORT", paths[0].as_path()), ("LIBSPE2_PROFILE", &paths[1])];
    run_program(image, delay, &files);
    paths.map(|path| take(&path))
}

/// Compares each SPE's profile with its figures in the report, cause by cause.
fn check_profile(image: &Path, report: &str, text: &str) {
    let report: Value = serde_json::from_str(report).unwrap();
    let profile = ProfileFile::parse(text.as_bytes()).unwrap();
    let spes = report["spes"].as_array().unwrap();
    assert_eq!(profile.cycles().count(), spes.len());
    for (at, (figures, cycles)) in spes.iter().zip(profile.cycles()).enumerate() {
        assert_eq!(cycles, number(figures, "cycles"));
        let tally = profile.tally(at);
        assert_eq!(tally.issued, number(figures, "instructions"));
        assert_eq!(tally.joined, number(figures, "dual_issue"));
        assert_eq!(tally.stalls.total(), sum(&figures["stalls"]));
        for (cause, cycles) in tally.stalls.by_cost() {
            assert_eq!(cycles, number(&figures["stalls"], &cause.to_string()));
        }
    }
    // All entries belong to the program that was loaded.
    let image = fs::read(image).unwrap();
    let code = Code::parse(&image).unwrap();
    let view = View::new(&code, &image, &profile).unwrap();
    assert_eq!(view.total().cycles(), profile.cycles().sum::<u64>());
}

/// Compares each SPE's timeline with its figures in the report: the sleeps by cause, the commands
/// and their bytes.
fn check_timeline(report: &str, text: &str) {
    let report: Value = serde_json::from_str(report).unwrap();
    let timeline: TimelineFile = serde_json::from_str(text).unwrap();
    let spes = report["spes"].as_array().unwrap();
    assert_eq!(timeline.spes.len(), spes.len());
    for (figures, spe) in spes.iter().zip(&timeline.spes) {
        let blocked = &figures["blocked_by"];
        for cause in blocked.as_object().unwrap().keys() {
            let sleeps = spe.sleeps.iter().filter(|sleep| sleep.cause == *cause);
            let cycles: u64 = sleeps.map(|sleep| sleep.end - sleep.start).sum();
            assert_eq!(cycles, number(blocked, cause), "{cause}");
        }
        assert!(spe.sleeps.windows(2).all(|two| two[0].end <= two[1].start));
        let bytes = |kind| {
            let those = spe.transfers.iter().filter(|transfer| transfer.kind == kind);
            those.map(|transfer| transfer.bytes).sum::<u64>()
        };
        assert_eq!(bytes("get"), number(figures, "bytes_in"));
        assert_eq!(bytes("put"), number(figures, "bytes_out"));
        let commands = number(figures, "dma_commands") + number(figures, "atomic_commands");
        assert_eq!(spe.transfers.len() as u64, commands);
    }
}

fn number(value: &Value, name: &str) -> u64 {
    value[name].as_u64().unwrap_or_else(|| panic!("{name}: {}", value[name]))
}

fn sum(value: &Value) -> u64 {
    value.as_object().unwrap().values().map(|part| part.as_u64().unwrap()).sum()
}

fn check_figures(figures: &Value) {
    let of = |name| number(figures, name);
    let stalls = sum(&figures["stalls"]);
    assert_eq!(of("single_issue") + of("dual_issue") + stalls, of("cycles"));
    assert_eq!(of("single_issue") + 2 * of("dual_issue"), of("instructions"));
    assert_eq!(of("busy") + of("blocked"), of("cycles"));
    assert_eq!(sum(&figures["blocked_by"]), of("blocked"));
    let rate = figures["dual_issue_rate"].as_f64().unwrap();
    assert!(rate > 0.0 && rate < 1.0);
}

fn check_report(text: &str) {
    let report: Value = serde_json::from_str(text).unwrap();
    let spes = report["spes"].as_array().unwrap();
    assert_eq!(spes.len(), SPES);
    let total = |name| -> u64 { spes.iter().map(|spe| number(spe, name)).sum() };
    for name in ["cycles", "instructions", "busy", "blocked", "atomic_commands", "bytes_in"] {
        assert_eq!(number(&report["totals"], name), total(name), "{name}");
    }
    check_figures(&report["totals"]);
    for spe in spes {
        check_figures(spe);
        assert_eq!(number(spe, "stopped") + number(spe, "cycles"), number(spe, "clock"));
        assert!(number(spe, "clock") <= number(&report, "cycles"));
        assert_eq!(number(spe, "bytes_in"), u64::from(FRAMES) * 128);
        assert_eq!(number(spe, "dma_commands"), u64::from(FRAMES));
    }
    assert!(total("atomic_commands") > u64::from(FRAMES) * 200);
    let seconds = number(&report, "cycles") as f64 / 3.192e9;
    assert!((report["seconds"].as_f64().unwrap() - seconds).abs() < 1e-12);
    assert!(sum(&report["constants"]) > 0);
}

/// Checks that creating a context with these words in `LIBSPE2_` variables fails with this errno
/// and this message.
fn refused(words: &str, errno: i32, message: &str) {
    let set = words.split(' ').map(|word| word.split_once('=').unwrap());
    let set: Vec<_> = set.map(|(name, value)| (format!("LIBSPE2_{name}"), value)).collect();
    let environment: Vec<_> =
        set.iter().map(|(name, value)| (name.as_str(), OsStr::new(value))).collect();
    let output = child(&[OsStr::new("create")], &environment);
    assert_eq!(output.status.code(), Some(errno), "{words} {output:?}");
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.starts_with("libspe2: ") && stderr.contains(message), "{stderr}");
}

fn main() {
    let arguments: Vec<_> = std::env::args_os().collect();
    match arguments.get(1).and_then(|mode| mode.to_str()) {
        Some("run") => {
            let delay = arguments[3].to_str().unwrap().parse().unwrap();
            return program(&arguments[2], Duration::from_millis(delay));
        }
        Some("meet") => return meet(),
        Some("create") => {
            // SAFETY: a context needs no gang.
            let context = unsafe { spe_context_create(0, ptr::null_mut()) };
            assert!(context.is_null());
            std::process::exit(last_error().raw_os_error().unwrap());
        }
        _ => {}
    }
    let folder = tempfile::tempdir().unwrap();
    let image = build_instructions(PROGRAM, folder.path());
    a_race_is_told();

    let first = report(&image, folder.path(), "0");
    check_report(&first);
    for delay in ["0", "3", "0", "7"] {
        assert_eq!(report(&image, folder.path(), delay), first, "delay {delay}");
    }
    let [with_profile, profiled] = profile(&image, folder.path(), "0");
    assert_eq!(with_profile, first, "a profile must change nothing");
    check_profile(&image, &first, &profiled);
    let path = folder.path().join("report.json");
    let files = [("LIBSPE2_REPORT", path.as_path()), ("LIBSPE2_CHECK", Path::new("1"))];
    run_program(&image, "0", &files);
    assert_eq!(take(&path), first, "the check must find nothing");
    let timeline = folder.path().join("timeline.json");
    let files = [("LIBSPE2_REPORT", path.as_path()), ("LIBSPE2_TIMELINE", &timeline)];
    run_program(&image, "0", &files);
    assert_eq!(take(&path), first, "a timeline must change nothing");
    check_timeline(&first, &take(&timeline));
    let again = profile(&image, folder.path(), "3");
    assert_eq!(again, [with_profile, profiled]);
    // Another machine: farther away, but with the same work.
    let machine = folder.path().join("machine.toml");
    fs::write(&machine, "[memory]\nget_latency = 2280\n").unwrap();
    let files = [("LIBSPE2_REPORT", path.as_path()), ("LIBSPE2_MACHINE", &machine)];
    run_program(&image, "0", &files);
    let far = take(&path);
    check_report(&far);
    let totals =
        |text: &str| -> Value { serde_json::from_str::<Value>(text).unwrap()["totals"].clone() };
    let tag = |text: &str| number(&totals(text)["blocked_by"], "tag");
    let gets = u64::from(FRAMES) * SPES as u64;
    // Lines wait for slots, for which they now come at other times.
    let farther = tag(&far) - tag(&first);
    assert!(farther.abs_diff(2000 * gets) < 35 * gets, "{farther}");
    fs::remove_file(&machine).unwrap();
    a_barrier_is_no_time_out(folder.path());
    // Nothing new is left in the folder of the report.
    let beside = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(beside, 3);

    let needs = |name| format!("{name} is about simulated time: set LIBSPE2_TIMING=1");
    for (words, errno, message) in [
        ("TIMING=yes", libc::EINVAL, "LIBSPE2_TIMING"),
        ("TIMING=", libc::EINVAL, "LIBSPE2_TIMING"),
        ("REPORT=/tmp/x", libc::EINVAL, "LIBSPE2_TIMING=1"),
        ("PROFILE=/tmp/x TIMING=0", libc::EINVAL, &needs("LIBSPE2_PROFILE")),
        ("TIMING=1 CHECK=2", libc::EINVAL, "LIBSPE2_CHECK"),
        ("TIMING=1 MACHINE=/no/where", libc::EINVAL, "LIBSPE2_MACHINE: /no/where: "),
        ("MACHINE=/no/where", libc::EINVAL, &needs("LIBSPE2_MACHINE")),
        ("TIMING=1 PROFILE=/no/where", libc::ENOENT, "LIBSPE2_PROFILE: /no/where"),
        ("TIMING=1 REPORT=", libc::EINVAL, "LIBSPE2_REPORT"),
        ("TIMING=1 REPORT=/", libc::EISDIR, "LIBSPE2_REPORT: /:"),
        ("TIMING=1 REPORT=/no/where", libc::ENOENT, "LIBSPE2_REPORT: /no/where"),
        ("TIMING=1 MFC=at-last", libc::ENOTSUP, "LIBSPE2_MFC=at-last"),
    ] {
        refused(words, errno, message);
    }
    println!("timing: ok");
}
