//! cellray: an interactive ray tracer for the Cell Broadband Engine under PS3 Linux.
//!
//! A game is a type that implements [`Game`](game::Game), and `cellray_play::main_of::<MyGame>()`
//! of the crate `cellray-play` is its whole `main`: windows, terminals, framebuffers, pads and
//! recordings. `cellray new mygame` makes a folder that has both. The [`prelude`] has what a game
//! uses; [`World`](game::World) is where it puts things.
//!
//! This is the PPU's part. Frame by frame, an [`Engine`] receives a [`Scene`]; its SPUs trace the
//! scene and write finished rows directly into a [`framebuffer`]. Whether the libspe2 calls in
//! [`spe`] reach a console's SPEs or emulated ones is decided at link time; this crate is
//! independent of it.
//!
//! Without `cellray-play`, a [`Session`](game::Session) runs a game. This example renders a
//! bouncing ball as numbered pictures:
//!
//! ```
//! use std::time::Duration;
//!
//! use cellray::framebuffer::{Geometry, Memory, NumberedPath};
//! use cellray::game::{
//!     DVec3, FixedSteps, Frame, FrameRange, Game, Material, NoInput, ObjectId, Pictures, Session,
//!     Start, World, WorldError,
//! };
//!
//! struct Ball(ObjectId);
//!
//! impl Game for Ball {
//!     fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
//!         let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
//!         self.0 = world.add_sphere(DVec3::ZERO, 1.0, red)?;
//!         Ok(())
//!     }
//!     fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
//!         let part = frame.time % 1.0;
//!         world.move_to(self.0, DVec3::Y * 8.0 * part * (1.0 - part))
//!     }
//! }
//!
//! # let folder = tempfile::tempdir()?;
//! # std::env::set_current_dir(folder.path())?;
//! let pictures = Pictures::new(NumberedPath::new("ball-%03d.png")?);
//! let (ball, picture) = (Ball(ObjectId::default()), Memory::new(Geometry::new(64, 36)?)?);
//! let mut session = Session::start(ball, Default::default(), Box::new(picture))?;
//! let mut clock = FixedSteps(Duration::from_millis(40));
//! pictures.write(&mut session, FrameRange { first: 0, end: 3 }, &mut clock, &mut NoInput)?;
//! # assert!(std::path::Path::new("ball-002.png").is_file());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// Without worlds that change and without files, nothing uses what the scene and the framebuffer
// offer them.
#![cfg_attr(not(unix), allow(dead_code, unused_imports))]

#[cfg(feature = "choices")]
pub mod choices;
#[cfg(feature = "cli")]
pub mod cli;
pub mod engine;
pub mod framebuffer;
#[cfg(unix)]
pub mod game;
#[cfg(unix)]
pub mod prelude;
pub mod quality;
#[cfg(unix)]
mod report;
pub mod scene;
mod shared;
pub mod spe;
pub mod statistics;
#[cfg(unix)]
pub mod watch;
pub mod work;

pub use engine::{Engine, EngineError, Settings};
pub use quality::Quality;
#[cfg(unix)]
pub use report::{LoopTime, Report};
pub use scene::{Scene, SceneError};
pub use shared::SharedMemory;
