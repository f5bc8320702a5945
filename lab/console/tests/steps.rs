//! Steps that fail, crash and hang. A step is a fork of its process, which must have one thread, so
//! this test runs without the test harness.

use std::time::Duration;

use console::step::run;

const LONG: Duration = Duration::from_secs(600);

fn main() {
    let step = |limit, body: fn() -> Result<(), console::Failure>| {
        let mut lines = Vec::new();
        let passed = run("it", limit, body, &mut |line| lines.push(line.to_owned()));
        (passed, lines)
    };
    let (passed, lines) = step(LONG, || {
        messages::print!("one\ntwo");
        Ok(())
    });
    assert!(passed && lines.len() == 3, "{lines:?}");
    assert!(lines[..2] == ["one", "two"] && lines[2].starts_with("ok: it, "), "{lines:?}");

    let (passed, lines) = step(LONG, || Err("no such thing".into()));
    assert!(!passed && lines[0] == "error: no such thing", "{lines:?}");
    assert!(lines[1].starts_with("failed: it, "), "{lines:?}");

    let (passed, lines) = step(LONG, || panic!("a fault of the program"));
    assert!(
        !passed && lines.iter().any(|line| line.contains("a fault of the program")),
        "{lines:?}"
    );

    // SAFETY: the signal ends the step's process, as a fault of the hardware would.
    let (passed, lines) = step(LONG, || unsafe {
        libc::raise(libc::SIGKILL);
        Ok(())
    });
    assert!(!passed && lines[0].contains("crashed with signal 9"), "{lines:?}");

    // Said before it hangs, and a step that ignores SIGTERM.
    let (passed, lines) = step(Duration::from_millis(100), || {
        // SAFETY: ignoring a signal needs no handler.
        unsafe { libc::signal(libc::SIGTERM, libc::SIG_IGN) };
        messages::print!("row one");
        loop {
            std::thread::park();
        }
    });
    assert!(!passed && lines[0] == "row one", "{lines:?}");
    assert!(lines[1].contains("it hung, and was ended after its limit of 0.1 s"), "{lines:?}");
}
