//! The program of the playground's page, for WebAssembly: it assembles, schedules and steps through
//! SPU code.
//!
//! The page passes requests and gets replies through the functions of [`spu_exchange`].

mod channels;
mod program;
mod session;

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};
use spu_exchange::Program;
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
    /// Assembles a source, and begins at its first instruction, with what the PPE sends.
    Load {
        source: String,
        #[serde(default)]
        mail: Vec<u32>,
    },
    /// Schedules a source.
    Schedule {
        source: String,
        #[serde(default)]
        mail: Vec<u32>,
    },
    /// Replaces what the PPE sends.
    Send { mail: Vec<u32> },
    /// Goes to the moment when this many instructions have run.
    Go { step: u64 },
    /// Runs to one of these addresses, or to the end.
    Run { breakpoints: BTreeSet<u32> },
}

/// A request of the page.
#[derive(Deserialize)]
pub struct Request {
    #[serde(flatten)]
    task: Task,
    /// The first quadword of local store to be shown, and the one after the last.
    quadwords: Option<(u32, u32)>,
}

/// An error in a source.
#[derive(Debug, Serialize)]
pub struct Problem {
    line: u32,
    column: u32,
    message: String,
}

/// The reply to a request.
#[derive(Serialize)]
#[serde(untagged)]
pub enum Reply {
    /// The source has errors.
    Errors {
        /// All of them.
        errors: Vec<Problem>,
    },
    /// The source is assembled.
    Loaded {
        /// The page of the analyser.
        diagram: String,
        /// Addresses and their source lines.
        lines: Vec<(u32, u32)>,
    },
    /// The source is scheduled.
    Scheduled {
        /// The scheduler's version.
        text: String,
        /// Its page of the analyser.
        diagram: String,
        /// The result for each loop.
        loops: Vec<String>,
        /// The cycles of the program, before and after, if both end.
        cycles: Option<(u64, u64)>,
    },
    /// The source can't be scheduled.
    NotScheduled {
        /// The reason.
        error: String,
    },
    /// The state of the program.
    State(View),
    /// Nothing can be done.
    Fault {
        /// The reason.
        fault: String,
    },
}

/// The source that the page edits.
#[derive(Default)]
pub struct Playground {
    session: Option<Session>,
}

impl Program for Playground {
    type Request = Request;
    type Reply = Reply;

    fn fault(fault: String) -> Reply {
        Reply::Fault { fault }
    }

    fn carry_out(&mut self, Request { task, quadwords }: Request) -> Reply {
        match task {
            Task::Load { source, mail } => return self.load(&source, mail),
            Task::Schedule { source, mail } => return schedule(&source, &mail),
            Task::Send { mail } => {
                if let Some(session) = &mut self.session {
                    session.send(mail);
                }
            }
            Task::Go { step } => self.session.iter_mut().for_each(|session| session.go(step)),
            Task::Run { breakpoints } => {
                self.session.iter_mut().for_each(|session| session.run(&breakpoints));
            }
        }
        let (start, end) = quadwords.unwrap_or_default();
        match &self.session {
            Some(session) => Reply::State(session.view(start..end)),
            None => Self::fault("the program has errors, so nothing runs".into()),
        }
    }
}

impl Playground {
    fn load(&mut self, source: &str, mail: Vec<u32>) -> Reply {
        self.session = None;
        let assembled = match Assembled::new(source) {
            Ok(assembled) => assembled,
            Err(errors) => return Reply::Errors { errors },
        };
        match diagram(&assembled.object) {
            Ok(diagram) => {
                self.session = Some(Session::new(assembled.image, assembled.entry, mail));
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

fn schedule(source: &str, mail: &[u32]) -> Reply {
    let assembled = match Assembled::new(source) {
        Ok(assembled) => assembled,
        Err(errors) => return Reply::Errors { errors },
    };
    let mut made = None;
    let kind = spu_scheduler::Kind::Kernel;
    let scheduled =
        spu_scheduler::schedule(&assembled.object, kind, program::FILE, source, |text| {
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
    let before = cycles(&assembled, mail);
    let (diagram, after) = match made {
        Some(made) => (diagram(&made.object), cycles(&made, mail)),
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
fn cycles(assembled: &Assembled, mail: &[u32]) -> Option<u64> {
    let mut session = Session::new(assembled.image.clone(), assembled.entry, mail.to_vec());
    session.run(&BTreeSet::new());
    session.cycles()
}

spu_exchange::exports!(Playground);
