//! A framebuffer whose contents tests can read, and frames rendered to it.

use std::sync::Mutex;

use crate::prelude::*;
use cellray::framebuffer::{FramebufferError, Target};

/// A memory framebuffer whose presented frames can be read from outside.
pub struct Recorder {
    memory: Memory,
    shown: Arc<Mutex<Option<RgbImage>>>,
}

/// The frame that a [`Recorder`] last presented.
pub type Snapshot = Arc<Mutex<Option<RgbImage>>>;

impl Recorder {
    /// A framebuffer for an engine, and the frame that it last presented.
    pub fn pair(width: u32, height: u32) -> (Box<dyn Framebuffer>, Snapshot) {
        let memory = Memory::new(Geometry { width, height }).unwrap();
        let shown = Snapshot::default();
        (Box::new(Self { memory, shown: Arc::clone(&shown) }), shown)
    }
}

impl Framebuffer for Recorder {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        *self.shown.lock().unwrap() = Some(self.memory.rgb());
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        self.memory.describe()
    }
}

/// Reads one of the scenes that come with the program.
pub fn nff_scene(name: &str) -> scenes::Scene {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    scenes::load(&path).unwrap()
}

/// Renders a frame of a scene.
pub fn render(scene: &scenes::Scene, width: u32, height: u32, settings: Settings) -> RgbImage {
    let (framebuffer, shown) = Recorder::pair(width, height);
    let mut engine = Engine::start(settings, framebuffer).unwrap();
    engine.render(&Scene::from_nff(scene).unwrap(), &mut |_| ()).unwrap();
    let picture = shown.lock().unwrap().take();
    picture.expect("the frame was presented")
}
