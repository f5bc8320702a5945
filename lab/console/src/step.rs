//! A step of the report: a process of its own with a time limit.

use std::fs::File;
use std::io::{self, Read as _, Write as _};
use std::os::fd::{AsRawFd as _, FromRawFd as _};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::Failure;

/// How long a process gets to put back the screen after SIGTERM, and to vanish after SIGKILL.
const FAREWELL: Duration = Duration::from_secs(2);

/// Runs `body` in a child of this process, for at most `limit`. `emit` gets each line that the body
/// or a library writes to standard error, as it comes, and then a line with the outcome.
///
/// The child is a fork that executes no other program, so it also runs where there is nothing to
/// execute. Returns whether the body succeeded.
///
/// # Panics
/// This process has a second thread, of which a fork would lack what it holds.
pub fn run(
    name: &str,
    limit: Duration,
    body: impl FnOnce() -> Result<(), Failure>,
    emit: &mut dyn FnMut(&str),
) -> bool {
    let began = Instant::now();
    let outcome = attempt(limit, began, body, emit);
    let seconds = began.elapsed().as_secs_f64();
    match &outcome {
        Ok(()) => emit(&format!("ok: {name}, {seconds:.1} s")),
        Err(why) => emit(&format!("failed: {name}, {seconds:.1} s: {why}")),
    }
    outcome.is_ok()
}

fn attempt(
    limit: Duration,
    began: Instant,
    body: impl FnOnce() -> Result<(), Failure>,
    emit: &mut dyn FnMut(&str),
) -> Result<(), String> {
    let refused = |what: &str| format!("{what}: {}", io::Error::last_os_error());
    let mut ends = [0; 2];
    // SAFETY: the array holds both descriptors.
    if unsafe { libc::pipe2(ends.as_mut_ptr(), libc::O_CLOEXEC) } != 0 {
        return Err(refused("pipe"));
    }
    // SAFETY: the descriptors were just created, and nothing else owns them.
    let [mut lines, writer] = ends.map(|end| unsafe { File::from_raw_fd(end) });
    // SAFETY: this process has one thread, so the child lacks nothing that another one holds.
    let child = unsafe { libc::fork() };
    if child < 0 {
        return Err(refused("fork"));
    }
    if child == 0 {
        // SAFETY: both descriptors are open.
        unsafe { libc::dup2(writer.as_raw_fd(), libc::STDERR_FILENO) };
        let code = match catch_unwind(AssertUnwindSafe(body)) {
            Ok(Ok(())) => 0,
            Ok(Err(error)) => {
                let _ = writeln!(io::stderr(), "error: {error}");
                1
            }
            Err(_) => 1,
        };
        // SAFETY: it ends the process at once, also with threads that never will.
        unsafe { libc::_exit(code) }
    }
    drop(writer);
    let in_time = read_lines(&mut lines, began + limit, emit);
    if !in_time {
        // SAFETY: the child is this process's own, and has not been waited for.
        unsafe { libc::kill(child, libc::SIGTERM) };
        if !read_lines(&mut lines, Instant::now() + FAREWELL, emit) {
            // SAFETY: as above.
            unsafe { libc::kill(child, libc::SIGKILL) };
            if !read_lines(&mut lines, Instant::now() + FAREWELL, emit) {
                return Err(format!("process {child} can't be ended: the kernel holds it"));
            }
        }
    }
    let mut status = 0;
    // SAFETY: status is valid for writing. The child has closed its end of the pipe, so it ends.
    unsafe { libc::waitpid(child, &raw mut status, 0) };
    if !in_time {
        Err(format!("it hung, and was ended after its limit of {} s", limit.as_secs_f64()))
    } else if libc::WIFSIGNALED(status) {
        Err(format!("it crashed with signal {}", libc::WTERMSIG(status)))
    } else if libc::WEXITSTATUS(status) != 0 {
        Err("see above".to_owned())
    } else {
        Ok(())
    }
}

/// Emits lines until the child closes the pipe; `false` if it has not by `until`.
fn read_lines(from: &mut File, until: Instant, emit: &mut dyn FnMut(&str)) -> bool {
    let mut text = Vec::new();
    let mut buffer = [0; 4096];
    let closed = loop {
        let left = until.saturating_duration_since(Instant::now()).as_millis();
        let mut ready = libc::pollfd { fd: from.as_raw_fd(), events: libc::POLLIN, revents: 0 };
        // SAFETY: ready is one entry.
        let count =
            unsafe { libc::poll(&raw mut ready, 1, i32::try_from(left).unwrap_or(i32::MAX)) };
        if count == 0 {
            break false;
        }
        match from.read(&mut buffer) {
            Ok(0) => break true,
            Ok(size) => text.extend_from_slice(&buffer[..size]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(_) => break true,
        }
        while let Some(end) = text.iter().position(|byte| *byte == b'\n') {
            let line: Vec<u8> = text.drain(..=end).collect();
            emit(String::from_utf8_lossy(&line).trim_end());
        }
    };
    if !text.is_empty() {
        emit(String::from_utf8_lossy(&text).trim_end());
    }
    closed
}
