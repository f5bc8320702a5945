//! A scene, and the engine that traces it.

use std::sync::Arc;
use std::time::Duration;

use cellray::engine::TracedUnits;
use cellray::framebuffer::{Geometry, Memory};
use cellray::scene::{Look, RenderOptions};
use cellray::spe::{Program, use_machine};
use cellray::statistics::FrameStatistics;
use cellray::{Engine, Scene, Settings};
use image::RgbImage;
use scenes::Limits;
use spu_emulator::decrementer::TICKS_PER_SECOND;
use spu_emulator::machine::Machine;
use spu_emulator::simulated::SimulationOptions;

use crate::Reply;
use crate::orbit::Orbit;

pub type Failure = Box<dyn std::error::Error>;

/// The number of entries after which code is compiled. Browsers begin with a fast compiler, which
/// takes some hundred times as long as interpreting the code once.
const COMPILE_AFTER: u16 = 32;

/// A scene on its way to the page.
pub struct Tracer {
    source: scenes::Scene,
    scene: Scene,
    geometry: Geometry,
    engine: Engine,
    machine: Arc<Machine>,
    instructions: u64,
    /// The picture as the page's canvas takes it.
    pixels: Vec<u8>,
}

/// A frame that was traced in simulated time.
pub struct Timed {
    pub picture: RgbImage,
    pub machine: Arc<Machine>,
    pub statistics: FrameStatistics,
    pub units: TracedUnits,
}

/// The engine's settings. A shipped SPU program works or waits for work at any time.
fn settings() -> Settings {
    Settings { timeout: Duration::from_secs(10), ..Settings::default() }
}

impl Tracer {
    /// Reads a scene. `name` is that of its file.
    pub fn open(
        name: &str,
        text: &str,
        (width, height): (u32, u32),
        smooth: bool,
    ) -> Result<Self, Failure> {
        let source = scenes::parse(text.as_bytes(), name, &Limits::default())?;
        let geometry = Geometry::new(width, height)?;
        let mut options = RenderOptions::default();
        if smooth {
            options = Look::default().of(options, source.lights.len());
        }
        let scene = Scene::new(&source, options, &Program::tracer())?;
        let machine = use_machine(None);
        machine.compile_after(COMPILE_AFTER);
        let engine = Engine::start(settings(), Box::new(Memory::new(geometry)?))?;
        Ok(Self { source, scene, geometry, engine, machine, instructions: 0, pixels: Vec::new() })
    }

    /// The parts of the scene that can't be drawn.
    pub fn notes(&self) -> Vec<String> {
        self.scene.not_drawn().iter().map(ToString::to_string).collect()
    }

    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    pub fn geometry(&self) -> Geometry {
        self.geometry
    }

    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    fn look(&mut self, orbit: Orbit) -> Result<(), Failure> {
        self.scene.set_view(&orbit.place(&self.source.view));
        Ok(self.scene.write()?)
    }

    fn show(&mut self, picture: &RgbImage) {
        self.pixels.clear();
        self.pixels.extend(picture.pixels().flat_map(|pixel| {
            let [red, green, blue] = pixel.0;
            [red, green, blue, u8::MAX]
        }));
    }

    /// Traces a frame as fast as possible.
    pub fn frame(&mut self, orbit: Orbit) -> Result<Reply, Failure> {
        self.look(orbit)?;
        let statistics = self.engine.render(&self.scene, &mut |_| ())?;
        let tiles = statistics.spus.iter().map(|spu| spu.tiles).sum();
        let picture = self.engine.picture().ok_or("the picture can't be read back")?;
        self.show(&picture);
        let all = self.machine.turns().map_or(0, |turns| turns.executed());
        let instructions = all - std::mem::replace(&mut self.instructions, all);
        Ok(Reply::Traced { tiles, instructions })
    }

    /// Traces a frame from its beginning in simulated time, on SPUs of its own.
    pub fn timed(&mut self, orbit: Orbit, options: SimulationOptions) -> Result<Timed, Failure> {
        self.look(orbit)?;
        let machine = use_machine(Some(options));
        let framebuffer = Box::new(Memory::new(self.geometry)?);
        let mut engine = Engine::start(settings(), framebuffer)?;
        let statistics = engine.render(&self.scene, &mut |_| ())?.clone();
        let picture = engine.picture().ok_or("the picture can't be read back")?;
        let units = engine.traced_units().ok_or("the SPUs were lost")?;
        self.show(&picture);
        Ok(Timed { picture, machine, statistics, units })
    }

    pub fn time(&mut self, orbit: Orbit) -> Result<Reply, Failure> {
        let timed = self.timed(orbit, SimulationOptions::default())?;
        let ticks = timed.statistics.ticks().max(1) as f64;
        let part = |of: u64| of as f64 / ticks;
        let spus = timed.statistics.spus.iter();
        let spus = spus.map(|spu| (spu.tiles, part(spu.busy), part(spu.dma_wait))).collect();
        Ok(Reply::Timed { rate: TICKS_PER_SECOND as f64 / ticks, spus })
    }
}
