//! Output of programs: messages on standard error, data on standard output, and with the feature
//! `manual` their manual pages and completions.
//!
//! Invariants:
//! - A message that can't be printed is lost, and nothing else: the work that it is about goes on.
//!   Rust's own `eprintln!` panics where standard error is a closed pipe, a full disk or a terminal
//!   that has hung up.
//! - Data that nobody reads any more, as after `| head`, is no error: the reader has what it wants.
//!   Every other error of standard output is one, and its message names standard output.

use std::fmt;
use std::io::{self, BufWriter, Write};

#[cfg(feature = "manual")]
pub mod manual;

/// Prints a line on standard error, as `eprintln!` does, but never panics.
#[macro_export]
macro_rules! print {
    ($($line:tt)*) => {
        $crate::line(::std::format_args!($($line)*))
    };
}

/// Prints a line on standard error; see [`print!`].
pub fn line(line: fmt::Arguments<'_>) {
    // One write, so that the lines of several threads and programs stay whole. There is nowhere
    // else to report an error.
    let _ = io::stderr().write_all(format!("{line}\n").as_bytes());
}

/// Prints text on standard error that ends no line, such as progress.
pub fn progress(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Writes data to standard output.
///
/// # Errors
///
/// Data can't be written, for another reason than that its reader has closed the pipe.
pub fn write_data(data: impl AsRef<[u8]>) -> io::Result<()> {
    write_data_with(|out| out.write_all(data.as_ref()))
}

/// Writes data to standard output in parts. `write` gets an error after the reader has closed the
/// pipe, and need do nothing but return it.
///
/// # Errors
///
/// As for [`write_data()`].
pub fn write_data_with(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    print_to(&mut io::stdout().lock(), write)
}

/// The result of writing to a pipe, where a reader that has closed it is no error.
///
/// # Errors
///
/// The given one, if it is another.
pub fn unless_closed(written: io::Result<()>) -> io::Result<()> {
    match written {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}

/// Standard output for work that is also done if nobody reads about it, such as a check. After the
/// reader has closed the pipe, the rest is dropped.
#[derive(Clone, Copy, Debug)]
pub struct Output;

impl Write for Output {
    fn write(&mut self, data: &[u8]) -> io::Result<usize> {
        write_data(data)?;
        Ok(data.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn print_to(
    out: &mut dyn Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut buffered = BufWriter::new(out);
    let written = write(&mut buffered).and_then(|()| buffered.flush());
    // Dropping the buffer would write the rest again.
    let (out, _) = buffered.into_parts();
    unless_closed(written.and_then(|()| out.flush()))
        .map_err(|error| io::Error::new(error.kind(), format!("standard output: {error}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::ErrorKind;

    /// An output that fails with this error after it has accepted this number of bytes.
    struct Fails(ErrorKind, usize);

    impl Write for Fails {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let Self(kind, left) = self;
            if *left == 0 {
                return Err((*kind).into());
            }
            let taken = bytes.len().min(*left);
            *left -= taken;
            Ok(taken)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn closed_pipe_is_no_error() {
        for accepted in [0, 3] {
            print_to(&mut Fails(ErrorKind::BrokenPipe, accepted), |out| out.write_all(b"data"))
                .unwrap();
        }
    }

    #[test]
    fn writer_gets_an_error_after_the_pipe_is_closed() {
        let mut parts = 0;
        print_to(&mut Fails(ErrorKind::BrokenPipe, 0), |out| {
            loop {
                out.write_all(&[0; 1000])?;
                parts += 1;
            }
        })
        .unwrap();
        assert!(parts < 1000, "{parts}");
    }

    #[test]
    fn full_disk_is_an_error_that_names_the_output() {
        let error = print_to(&mut Fails(ErrorKind::StorageFull, 3), |out| out.write_all(b"data"))
            .unwrap_err();
        assert_eq!(error.kind(), ErrorKind::StorageFull);
        assert!(error.to_string().starts_with("standard output: "));
    }

    #[test]
    fn large_output_is_written_whole() {
        let mut out = Vec::new();
        print_to(&mut out, |out| (0..10_000).try_for_each(|number| writeln!(out, "{number}")))
            .unwrap();
        assert_eq!(out.iter().filter(|&&byte| byte == b'\n').count(), 10_000);
    }
}
