//! The program of the tracer's page, for WebAssembly: the PPU's program, and six emulated SPUs that
//! run its SPU programs in turn.
//!
//! The page passes requests and gets replies through the functions of `spu_exchange`, and reads
//! the picture at the address that `pixels` returns.

#![cfg(target_family = "wasm")]

mod inspect;
mod orbit;
mod tracer;

use serde::{Deserialize, Serialize};
use spu_exchange::Program;

use orbit::Orbit;
use tracer::{Failure, Tracer};

/// The scenes that the page offers, by their files' names.
const SCENES: [(&str, &str); 8] = [
    ("paper16.nff", include_str!("../../../scenes/paper16.nff")),
    ("whitted16.nff", include_str!("../../../scenes/whitted16.nff")),
    ("still-life.nff", include_str!("../../../scenes/still-life.nff")),
    ("mirrors.nff", include_str!("../../../scenes/mirrors.nff")),
    ("glass.nff", include_str!("../../../scenes/glass.nff")),
    ("shapes.nff", include_str!("../../../scenes/shapes.nff")),
    ("shadows.nff", include_str!("../../../scenes/shadows.nff")),
    ("spheres64.nff", include_str!("../../../scenes/spheres64.nff")),
];

/// A request of the page.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Request {
    /// The names of the scenes.
    Scenes,
    /// Takes a scene.
    Open(Opening),
    /// Traces a frame. The emulated SPUs run as fast as they can.
    Frame(Orbit),
    /// Traces the frame from its beginning in simulated time.
    Time(Orbit),
    /// The same, and makes the inspector's page of it.
    Inspect(Orbit),
}

/// A scene to be taken, and how.
#[derive(Deserialize)]
pub struct Opening {
    /// One of the page's scenes, or the name of a file.
    name: String,
    /// The text of the file.
    text: Option<String>,
    width: u32,
    height: u32,
    /// Whether edges are antialiased and colours are sRGB, as the command line has it.
    smooth: bool,
}

/// The reply to a request.
#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Reply {
    /// The names of the scenes.
    Scenes(Vec<&'static str>),
    /// A scene is open.
    Opened {
        /// Parts that can't be drawn.
        notes: Vec<String>,
    },
    /// A picture is ready.
    Traced {
        /// Tiles that were traced, those filled with the background among them.
        tiles: u64,
        /// Instructions of the SPUs.
        instructions: u64,
    },
    /// A picture is ready, and its time is known.
    Timed {
        /// Frames a second on a console, in simulated time.
        rate: f64,
        /// For each SPU: the tiles that it traced, and the parts of the frame's time in which it
        /// worked and waited for memory.
        spus: Vec<(u64, f64, f64)>,
    },
    /// A picture is ready, with the inspector's page about it.
    Inspected {
        /// The page.
        page: String,
    },
    /// Why there is no reply.
    Fault(String),
}

/// The scene that the page shows.
#[derive(Default)]
pub struct Page {
    tracer: Option<Tracer>,
}

impl Program for Page {
    type Request = Request;
    type Reply = Reply;

    fn fault(fault: String) -> Reply {
        Reply::Fault(fault)
    }

    fn carry_out(&mut self, request: Request) -> Reply {
        self.try_to(request).unwrap_or_else(|error| Self::fault(error.to_string()))
    }
}

impl Page {
    fn try_to(&mut self, request: Request) -> Result<Reply, Failure> {
        let tracer = self.tracer.as_mut().ok_or("no scene is open");
        Ok(match request {
            Request::Scenes => Reply::Scenes(SCENES.map(|(name, _)| name).to_vec()),
            Request::Open(Opening { name, text, width, height, smooth }) => {
                let text = match &text {
                    Some(text) => text.as_str(),
                    None => named(&name)?,
                };
                let tracer = Tracer::open(&name, text, (width, height), smooth)?;
                let notes = tracer.notes();
                self.tracer = Some(tracer);
                Reply::Opened { notes }
            }
            Request::Frame(orbit) => tracer?.frame(orbit)?,
            Request::Time(orbit) => tracer?.time(orbit)?,
            Request::Inspect(orbit) => tracer?.inspect(orbit)?,
        })
    }
}

fn named(name: &str) -> Result<&'static str, String> {
    let found = SCENES.iter().find(|(known, _)| *known == name);
    found.map(|(_, text)| *text).ok_or_else(|| format!("there is no scene {name}"))
}

spu_exchange::exports!(Page);

/// The address of the last picture: for each pixel red, green, blue and 255.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn pixels() -> *const u8 {
    EXCHANGE.with_borrow(|exchange| {
        let tracer = exchange.program.tracer.as_ref();
        tracer.map_or(std::ptr::null(), |tracer| tracer.pixels().as_ptr())
    })
}
