//! `cellray-play`: the command line, with the games of this repository.

use std::process::ExitCode;

use cellray_play::Entry;

fn main() -> ExitCode {
    let games = games::GAMES.iter().map(|game| Entry {
        name: game.name,
        line: game.line,
        controls: game.controls,
        new: game.new,
    });
    cellray_play::main(&games.collect::<Vec<_>>())
}
