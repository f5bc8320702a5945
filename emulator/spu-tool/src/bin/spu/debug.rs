//! `spu debug`: runs a program, and obeys commands.

use std::fs::File;
use std::io::{self, BufRead, BufReader, IsTerminal as _};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use spu_debugger::console::Console;

use crate::failure::Failure;
use crate::run;

/// Debug an SPU program: breakpoints, steps, registers, local store, DMA
///
/// Reads commands from standard input, and prints a prompt if that is a terminal; `help` lists
/// them. The program halts before its first instruction. All options of `spu run` that make sense
/// here are accepted. The exit status is the program's, and 0 if the commands end before it does.
#[derive(Args)]
#[command(after_help = "Examples:
  spu debug hello.elf
  printf 'break main\\ncontinue\\nbacktrace\\nregisters $3\\n' | spu debug hello.elf
  spu debug --timing --commands look.txt tracer.elf   (standard input is the program's)
")]
pub struct Arguments {
    /// Read the commands from this file. Standard input is the program's then
    #[arg(long, value_name = "FILE")]
    commands: Option<PathBuf>,
    #[command(flatten)]
    run: run::Options,
}

/// Runs the subcommand.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    refuse(&arguments.run)?;
    let (input, is_terminal): (Box<dyn BufRead + Send>, bool) = match &arguments.commands {
        Some(path) => {
            let file = File::open(path).map_err(Failure::file(path))?;
            (Box::new(BufReader::new(file)), false)
        }
        None => (Box::new(BufReader::new(io::stdin())), io::stdin().is_terminal()),
    };
    run::with_program(&arguments.run, |machine, image| {
        let mut console = Console::new(image, input, io::stdout(), is_terminal);
        if is_terminal {
            interrupt::listen();
            console = console.interrupted_by(interrupt::has_come);
        }
        let end = machine.run_in_console(&arguments.run, image, &mut console)?;
        messages::unless_closed(console.finish())?;
        machine.dump(&arguments.run)?;
        Ok(end.status())
    })
}

/// Options of `spu run` that contradict a console.
fn refuse(options: &run::Options) -> Result<(), Failure> {
    let given = [
        ("--gdb", options.gdb.is_some()),
        ("--check", options.check),
        ("--max-instructions", options.max_instructions.is_some()),
    ];
    match given.into_iter().find(|(_, is_given)| *is_given) {
        Some((name, _)) => {
            Err(Failure::new(format!("{name} does not go with spu debug; use spu run")))
        }
        None => Ok(()),
    }
}

/// Ctrl-C at a terminal halts the program. If that does not help, because it sleeps in a channel,
/// the second one ends everything.
mod interrupt {
    use std::mem::MaybeUninit;
    use std::ptr;
    use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

    static CAME: AtomicBool = AtomicBool::new(false);

    extern "C" fn comes(_: libc::c_int) {
        CAME.store(true, Relaxed);
    }

    /// From now on the next Ctrl-C is noted.
    pub fn listen() {
        let mut action = MaybeUninit::<libc::sigaction>::zeroed();
        // SAFETY: all fields of the structure may be zero.
        let action = unsafe { action.assume_init_mut() };
        action.sa_sigaction = comes as *const () as libc::sighandler_t;
        action.sa_flags = libc::SA_RESETHAND | libc::SA_RESTART;
        // SAFETY: the handler only stores to an atomic, and the structure is complete. A failure
        // leaves the default, which ends the process.
        unsafe { libc::sigaction(libc::SIGINT, action, ptr::null_mut()) };
    }

    /// Whether one has come since this was last asked.
    pub fn has_come() -> bool {
        let came = CAME.load(Relaxed) && CAME.swap(false, Relaxed);
        if came {
            listen();
        }
        came
    }
}
