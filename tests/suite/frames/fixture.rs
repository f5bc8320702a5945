//! A frame descriptor that can be spoilt, and an engine to send it to.

use std::collections::HashSet;
use std::env;

use crate::frames::descriptor::Descriptor;
use crate::prelude::*;
use cellray::work;
use protocol::layout::{SCENE_CAPACITY, Statistics, UnitCounter, WAITING_SIZE};

/// Changes one field of a descriptor to a wrong value.
pub type Spoil = fn(&mut Frame);

/// An engine, and a valid frame descriptor with everything that it points to.
pub struct Fixture {
    pub engine: Engine,
    pub frame: Frame,
    pub units: SharedMemory,
    /// The blocks of the scene's mesh.
    pub mesh: SharedMemory,
    /// The materials in main memory, if there are any.
    pub materials: SharedMemory,
    /// The block of Whitted's model, with zeros after it up to the maximum size.
    pub scene: SharedMemory,
    /// The queued rays that don't fit in local store.
    pub waiting: SharedMemory,
    pub framebuffer: Memory,
    _memory: Vec<SharedMemory>,
    _of_frame: Scene,
}

impl Fixture {
    pub fn of(scene: &scenes::Scene, spus: u32) -> Self {
        let Descriptor {
            mut frame,
            spheres,
            block,
            mesh,
            code,
            materials,
            textures,
            texture_code,
            colour_code,
            cuts_code,
            units,
            scene: of_frame,
            framebuffer,
        } = Descriptor::of(scene, spus);
        let shared = |bytes: &[u8]| {
            let mut memory = SharedMemory::new(bytes.len());
            memory.write(0, bytes);
            memory
        };
        let costs = SharedMemory::new(units.len());
        let [spheres, mesh, code, units] = [spheres, mesh, code, units].map(|bytes| shared(&bytes));
        let mut scene = SharedMemory::new(SCENE_CAPACITY as usize);
        scene.write(0, &block);
        let [textures, texture_code] = [textures, texture_code].map(|bytes| shared(&bytes));
        let unit_counter = SharedMemory::new(size_of::<UnitCounter>());
        let statistics = SharedMemory::new(size_of::<Statistics>() * spus as usize);
        let waiting = SharedMemory::new((spus * WAITING_SIZE) as usize);
        frame.waiting = waiting.address().into();
        frame.spheres = spheres.address().into();
        frame.scene = scene.address().into();
        let materials = shared(&materials);
        if frame.materials.get() != 0 {
            frame.materials = materials.address().into();
        }
        let colour_code = shared(&colour_code);
        frame.colour_code = colour_code.address().into();
        let cuts_code = shared(&cuts_code);
        frame.cut_code = cuts_code.address().into();
        frame.textures = textures.address().into();
        frame.texture_code = texture_code.address().into();
        frame.mesh = mesh.address().into();
        // The descriptor has what is in front of the code that this scene needs.
        frame.code = (code.address() + frame.code.get()).into();
        frame.unit_counter = unit_counter.address().into();
        frame.statistics = statistics.address().into();
        frame.units = units.address().into();
        frame.costs = costs.address().into();
        let settings = Settings { spus, timeout: patience(), ..Settings::default() };
        let (recorder, _) = Recorder::pair(4, 4);
        Self {
            engine: Engine::start(settings, recorder).unwrap(),
            frame,
            units,
            mesh,
            materials,
            scene,
            waiting,
            framebuffer,
            _memory: vec![
                spheres,
                code,
                textures,
                texture_code,
                colour_code,
                cuts_code,
                unit_counter,
                statistics,
                costs,
            ],
            _of_frame: of_frame,
        }
    }

    pub fn submit(&mut self, frame: &Frame) -> Result<(), EngineError> {
        // SAFETY: every address is either in the fixture's memory, which stays alive, or one that
        // the SPUs must refuse without using it. The test checks that they do.
        unsafe { self.engine.submit(frame, &mut |_| ()) }.map(|_| ())
    }

    /// Traces the frame, which is valid.
    pub fn traced(&mut self) -> RgbImage {
        let frame = self.frame;
        self.submit(&frame).unwrap();
        self.picture()
    }

    pub fn picture(&self) -> RgbImage {
        self.framebuffer.picture().unwrap()
    }

    pub fn refused(&mut self, frame: &Frame) -> work::Refusal {
        match self.submit(frame) {
            Err(EngineError::Refused { refusal, .. }) => refusal,
            Ok(()) => panic!("accepted {frame:?}"),
            Err(error) => panic!("{error}"),
        }
    }

    /// Tries each wrong field, and the valid frame after it. A case has the field's name and a
    /// part of the message.
    pub fn refuses(&mut self, cases: &[(&str, &str, Spoil)]) {
        let good = self.frame;
        for (field, part, spoil) in cases {
            let mut frame = good;
            spoil(&mut frame);
            let refusal = self.refused(&frame);
            let text = refusal.to_string();
            assert!(refusal.field.split(", ").any(|name| name == *field), "{field}: {text}");
            assert!(text.contains(part), "{field}: {text}");
            self.submit(&good).unwrap_or_else(|error| panic!("after {field}: {error}"));
        }
    }
}

/// Checks that the picture of a scene has more than this number of colours, and is the same with
/// these numbers of SPUs as with one.
pub fn is_the_same_with_spus(
    scene: &scenes::Scene,
    spus: impl IntoIterator<Item = u32>,
    least_colours: usize,
) {
    let expected = Fixture::of(scene, 1).traced();
    let colours: HashSet<_> = expected.pixels().collect();
    assert!(colours.len() > least_colours, "{} colours", colours.len());
    for spus in spus {
        assert!(Fixture::of(scene, spus).traced() == expected, "{spus}");
    }
}

/// How long an SPU may be silent. Where compiled code is compared with the interpreter, a frame
/// takes many times as long.
fn patience() -> Duration {
    let is_checked = env::var("LIBSPE2_CHECK").is_ok_and(|value| value == "1");
    Duration::from_secs(if is_checked { 3600 } else { 600 })
}
