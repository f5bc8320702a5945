//! The program of the playground's page, for WebAssembly: it assembles, schedules and steps through
//! SPU code.
//!
//! The page passes requests as JSON and gets replies as JSON, through three exported functions and
//! the memory of the program: [`buffer`], [`reply`] and [`reply_bytes`]. So no generator of
//! bindings is needed. [`Playground`] is the same without the memory.

mod program;
mod session;

use std::collections::BTreeSet;
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde::{Deserialize, Serialize};
use spu_isa::timing::Rules;
use spu_scheduler::code::Code;
use spu_scheduler::{Outcome, ScheduleError};
use spu_tool::report::Report;

use program::Assembled;
use session::{Session, View};

/// The tasks that the page sets.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Task {
    /// Assembles a source, and begins at its first instruction.
    Load { source: String },
    /// Schedules a source.
    Schedule { source: String },
    /// Goes to the moment when this many instructions have run.
    Go { step: u64 },
    /// Runs to one of these addresses, or to the end.
    Run { breakpoints: BTreeSet<u32> },
}

#[derive(Deserialize)]
struct Request {
    #[serde(flatten)]
    task: Task,
    /// The first quadword of local store to be shown, and the one after the last.
    quadwords: Option<(u32, u32)>,
}

/// An error in a source.
#[derive(Debug, Serialize)]
struct Problem {
    line: u32,
    column: u32,
    message: String,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Reply {
    Errors {
        errors: Vec<Problem>,
    },
    Loaded {
        /// The page of the analyser.
        diagram: String,
        /// Addresses and their source lines.
        lines: Vec<(u32, u32)>,
    },
    Scheduled {
        text: String,
        diagram: String,
        /// The result for each loop.
        loops: Vec<String>,
        /// The cycles of the program, before and after, if both end.
        cycles: Option<(u64, u64)>,
    },
    NotScheduled {
        error: String,
    },
    State(View),
    Fault {
        fault: String,
    },
}

/// The source that the page edits.
#[derive(Default)]
pub struct Playground {
    session: Option<Session>,
}

impl Playground {
    /// The reply to a request.
    pub fn reply(&mut self, request: &[u8]) -> String {
        let reply = match serde_json::from_slice(request) {
            Ok(request) => self.carry_out(request),
            Err(error) => Reply::Fault { fault: format!("not a request: {error}") },
        };
        serde_json::to_string(&reply)
            .unwrap_or_else(|error| format!("{{\"fault\":\"no reply: {error}\"}}"))
    }

    fn carry_out(&mut self, Request { task, quadwords }: Request) -> Reply {
        match task {
            Task::Load { source } => return self.load(&source),
            Task::Schedule { source } => return schedule(&source),
            Task::Go { step } => self.session.iter_mut().for_each(|session| session.go(step)),
            Task::Run { breakpoints } => {
                self.session.iter_mut().for_each(|session| session.run(&breakpoints));
            }
        }
        let (start, end) = quadwords.unwrap_or_default();
        match &self.session {
            Some(session) => Reply::State(session.view(start..end)),
            None => Reply::Fault { fault: "the program has errors, so nothing runs".into() },
        }
    }

    fn load(&mut self, source: &str) -> Reply {
        self.session = None;
        let assembled = match Assembled::new(source) {
            Ok(assembled) => assembled,
            Err(errors) => return Reply::Errors { errors },
        };
        match diagram(&assembled.object) {
            Ok(diagram) => {
                self.session = Some(Session::new(assembled.image, assembled.entry));
                Reply::Loaded { diagram, lines: assembled.lines }
            }
            Err(fault) => Reply::Fault { fault },
        }
    }
}

/// The analyser's page for an object.
fn diagram(object: &[u8]) -> Result<String, String> {
    let code = Code::parse(object).map_err(|error| error.to_string())?;
    let report = Report::new(&code, None, Rules::default());
    Ok(report.map(|report| report.html(program::FILE)).unwrap_or_default())
}

fn schedule(source: &str) -> Reply {
    let assembled = match Assembled::new(source) {
        Ok(assembled) => assembled,
        Err(errors) => return Reply::Errors { errors },
    };
    let mut made = None;
    let scheduled = spu_scheduler::schedule(&assembled.object, program::FILE, source, |text| {
        let assembled = Assembled::new(text).map_err(|errors| {
            let lines = errors.iter().map(|at| format!("{}: {}", at.line, at.message));
            lines.collect::<Vec<_>>().join("\n")
        })?;
        Ok::<_, String>(made.insert(assembled).object.clone())
    });
    let scheduled = match scheduled {
        Ok(scheduled) => scheduled,
        Err(ScheduleError::NoFunction) => {
            return Reply::NotScheduled {
                error:
                    "There is no function to schedule: one needs .type NAME, @function and .size \
                        NAME, .-NAME."
                        .into(),
            };
        }
        Err(error) => return Reply::NotScheduled { error: error.to_string() },
    };
    let describe = |found: &spu_scheduler::LoopReport| match &found.outcome {
        Outcome::Plain(why) => format!("Loop {}: not pipelined: {why}.", found.name),
        Outcome::Pipelined(figures) => {
            let (interval, minimum) = (figures.interval, figures.minimum);
            format!("Loop {}: {interval} cycles a pass, minimum {minimum}.", found.name)
        }
    };
    let before = cycles(&assembled);
    let (diagram, after) = match made {
        Some(made) => (diagram(&made.object), cycles(&made)),
        None => (Err("the scheduler has assembled nothing".into()), None),
    };
    match diagram {
        Ok(diagram) => Reply::Scheduled {
            text: scheduled.text,
            diagram,
            loops: scheduled.loops.iter().map(describe).collect(),
            cycles: before.zip(after),
        },
        Err(error) => Reply::NotScheduled { error },
    }
}

/// The cycles of a whole run, if it ends.
fn cycles(assembled: &Assembled) -> Option<u64> {
    let mut session = Session::new(assembled.image.clone(), assembled.entry);
    session.run(&BTreeSet::new());
    session.cycles()
}

/// The request, the reply, and the state between two requests.
#[derive(Default)]
struct Exchange {
    playground: Playground,
    request: Vec<u8>,
    reply: String,
}

static EXCHANGE: Mutex<Option<Exchange>> = Mutex::new(None);

fn exchange() -> MutexGuard<'static, Option<Exchange>> {
    EXCHANGE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes a buffer for a request of this many bytes, and returns its address.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn buffer(bytes: usize) -> *mut u8 {
    let mut exchange = exchange();
    let request = &mut exchange.get_or_insert_default().request;
    request.clear();
    request.resize(bytes, 0);
    request.as_mut_ptr()
}

/// Carries out the request, and returns the address of the reply, which stays until the next one.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn reply() -> *const u8 {
    let mut exchange = exchange();
    let Exchange { playground, request, reply } = exchange.get_or_insert_default();
    *reply = playground.reply(request);
    reply.as_ptr()
}

/// The length of the reply in bytes.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn reply_bytes() -> usize {
    exchange().as_ref().map_or(0, |exchange| exchange.reply.len())
}
