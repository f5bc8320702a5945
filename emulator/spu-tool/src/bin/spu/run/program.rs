//! Reads the program's file. If a file of another kind was named, the error suggests the command
//! for it.

use std::env;
use std::path::Path;

use spu_emulator::elf::Image;

use super::options::Options;
use crate::failure::Failure;
use crate::image;

/// The options whose file, if there is one, follows a `=`.
const WITH_OPTIONAL_FILE: [&str; 5] =
    ["--trace", "--stats", "--timing", "--profile", "--dump-regs"];

/// The program's file, which may be no program yet.
pub fn read(options: &Options) -> Result<Vec<u8>, Failure> {
    let path = &options.program;
    let read = image::read(path);
    let is_program = read.as_ref().is_ok_and(|bytes| Image::parse(bytes).is_ok());
    match file_of_an_option(path).filter(|_| !is_program) {
        Some(option) => Err(Failure::new(said_without_equals(option, options))),
        None => read,
    }
}

/// The option that stands before the program's name and takes no file from there.
fn file_of_an_option(program: &Path) -> Option<&'static str> {
    let typed: Vec<_> = env::args_os().collect();
    let options = WITH_OPTIONAL_FILE.into_iter();
    let mut before = options.filter(|option| {
        typed.windows(2).any(|pair| pair[0] == *option && pair[1] == program.as_os_str())
    });
    before.next()
}

fn said_without_equals(option: &str, options: &Options) -> String {
    let path = options.program.display();
    let command = env::args_os().nth(1).unwrap_or_default();
    let command = command.to_string_lossy();
    let rest: Vec<_> =
        options.arguments.iter().map(|argument| argument.to_string_lossy()).collect();
    let rest = match rest.is_empty() {
        true => "PROGRAM".to_owned(),
        false => rest.join(" "),
    };
    format!(
        "{path} is no SPU program; a file for {option} follows a `=`: spu {command} \
         {option}={path} {rest}"
    )
}
