//! `cellray-play`: the command line, with the games of this repository.

use std::process::ExitCode;

fn main() -> ExitCode {
    cellray_play::main(games::GAMES)
}
