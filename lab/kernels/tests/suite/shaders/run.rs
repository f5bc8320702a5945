//! The driver's `shaders_run` in a program of its own: the shader that it calls for each lane, and
//! the faults that its check finds.

use std::fs;
use std::path::Path;

use kernels::prelude::*;
use protocol::layout::{
    FEATURE_CHECK_SHADERS, Frame, MATERIAL_MIRRORS, MATERIAL_SHADED, Material, RULE_KNOWN,
    RULE_LANES, RULE_REGISTER, RULE_STACK, ShaderContext, Status,
};
use spu_build::{Image, Tools};
use spu_emulator::channel::NoChannels;
use spu_emulator::elf;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::LocalStore;
use spu_emulator::stop::Stop;
use zerocopy::Immutable;

const SURFACES: u32 = 0x30000;
const RAYS: u32 = 0x31000;
const MATERIALS: u32 = 0x32000;
const STACK: u32 = 0x3ff00;
const LIMIT: u64 = 100_000;

/// The shaders of `program/shaders.s` and of the example, in the order of the table.
const GOOD: u32 = 0;
const LANES: u32 = 1;
const POINTER: u32 = 2;
const REGISTER: u32 = 3;
const RINGS: u32 = 4;
const STACKED: u32 = 5;

/// The loaded program.
struct Machine {
    elf: Vec<u8>,
    store: LocalStore,
    random: ChaCha8Rng,
    surfaces: Surfaces,
    rays: RayPacket,
}

impl Machine {
    /// All lanes have the first material.
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let file = folder.path().join("shaders.elf");
        Image::new(&root.join("../../linker/spu.ld"))
            .folder(&root.join("tests/suite/shaders/program"))
            .unwrap()
            .source(&root.join("../../spu/main/shaders.s"))
            .source(&root.join("../../examples/shader/shaders/rings.s"))
            .include(&root.join("../../spu/include"))
            .constants()
            .build(&Tools::find().unwrap(), folder.path(), &file)
            .unwrap_or_else(|error| panic!("{error}"));
        let mut machine = Self {
            elf: fs::read(file).unwrap(),
            store: LocalStore::new(),
            random: random(),
            surfaces: Surfaces::new_zeroed(),
            rays: RayPacket::new_zeroed(),
        };
        machine.random.fill(machine.surfaces.as_mut_bytes());
        machine.random.fill(machine.rays.as_mut_bytes());
        machine.surfaces.material = [MATERIALS.into(); 16];
        machine.surfaces.flags = [MATERIAL_SHADED.into(), 0.into(), 0.into(), 0.into()];
        elf::Image::parse(&machine.elf).unwrap().load(&machine.store, 0);
        machine
    }

    fn material(&self, number: u32, flags: u32, shader: u32, parameter: u32) {
        let mut material = Material::new_zeroed();
        material.flags = flags.into();
        material.shader = shader.into();
        material.parameters[0] = single(parameter);
        self.put(address(number), &material);
    }

    fn put(&self, address: u32, record: &(impl IntoBytes + Immutable)) {
        self.store.write(address, record.as_bytes());
    }

    /// Calls `shaders_run`, checks that it preserves the driver's state, and returns its result.
    fn run(&mut self, features: u32) -> u32 {
        let image = elf::Image::parse(&self.elf).unwrap();
        let mut frame = Frame::new_zeroed();
        frame.features = features.into();
        self.put(image.symbol("frame").unwrap(), &frame);
        self.put(SURFACES, &self.surfaces);
        self.put(RAYS, &self.rays);
        let mut spu = Spu::new();
        for register in &mut spu.registers {
            *register = Quad(self.random.random());
        }
        spu.registers[0].0[0] = image.symbol("_start").unwrap();
        spu.registers[1].0[0] = STACK;
        spu.registers[3].0[0] = SURFACES;
        spu.registers[4].0[0] = RAYS;
        let before = spu.registers;
        spu.set_pc(image.symbol("shaders_run").unwrap());
        let stopped =
            spu.run_observed(&self.store, &mut NoChannels, LIMIT, &mut ()).expect("an end");
        assert_eq!(stopped.reason, Stop::Signal(0x1fff), "{stopped}");
        if features != 0 {
            assert_eq!(spu.registers[1], before[1]);
            assert_eq!(spu.registers[80..], before[80..]);
        }
        spu.registers[3].0[0]
    }

    fn found(&self) -> Surfaces {
        let mut found = Surfaces::new_zeroed();
        self.store.read(SURFACES, found.as_mut_bytes());
        found
    }
}

fn address(material: u32) -> u32 {
    MATERIALS + material * size_of::<Material>() as u32
}

fn refused(rule: u32, register: u32, shader: u32) -> u32 {
    Status::Shader as u32 | rule << 8 | register << 16 | shader << 24
}

#[test]
fn materials_are_shaded_by_their_shaders() {
    for features in [0, FEATURE_CHECK_SHADERS] {
        let mut machine = Machine::new();
        for (number, flags) in [(0, MATERIAL_SHADED), (1, 0), (2, MATERIAL_SHADED | 4)] {
            machine.material(number, flags, GOOD, 1000 + number);
        }
        for _ in 0..50 {
            let materials: [u32; 16] = std::array::from_fn(|_| machine.random.random_range(0..3));
            machine.surfaces.material = materials.map(|number| address(number).into());
            let before = machine.surfaces;
            assert_eq!(machine.run(features), Status::Done as u32);
            let mut wanted = before;
            for (lane, material) in materials.into_iter().enumerate() {
                if material != 1 {
                    wanted.lit_red[lane] = single(1000 + material);
                    wanted.lit_green[lane] = machine.rays.t[lane];
                }
            }
            if materials.iter().any(|material| *material != 1) {
                wanted.flags = [MATERIAL_MIRRORS | MATERIAL_SHADED, 2, 2, 2].map(Into::into);
            }
            let found = machine.found();
            assert!(found.as_bytes() == wanted.as_bytes(), "{materials:?}");
        }
    }
}

#[test]
fn packet_without_shader_calls_none() {
    let mut machine = Machine::new();
    machine.material(0, MATERIAL_SHADED, GOOD, 1);
    machine.surfaces.flags[0] = (!MATERIAL_SHADED).into();
    let before = machine.surfaces;
    assert_eq!(machine.run(FEATURE_CHECK_SHADERS), Status::Done as u32);
    assert!(machine.found().as_bytes() == before.as_bytes());
}

#[test]
fn missing_shader_is_rejected() {
    for (shader, expected) in [(6, 6), (254, 254), (1 << 20, 255), (u32::MAX, 255)] {
        let mut machine = Machine::new();
        machine.material(0, MATERIAL_SHADED, shader, 1);
        assert_eq!(machine.run(0), refused(RULE_KNOWN, 0, expected));
    }
}

#[test]
fn check_reports_violated_rule() {
    let bad = [
        (LANES, RULE_LANES, 0),
        (POINTER, RULE_REGISTER, 1),
        (REGISTER, RULE_REGISTER, 90),
        (STACKED, RULE_STACK, 0),
    ];
    for (shader, rule, register) in bad {
        let mut machine = Machine::new();
        machine.material(0, MATERIAL_SHADED, shader, 1);
        machine.material(1, 0, 0, 0);
        // Lane 10 is one that no shader may shade.
        machine.surfaces.material[10] = address(1).into();
        let result = machine.run(FEATURE_CHECK_SHADERS);
        assert_eq!(result, refused(rule, register, shader), "{result:#x}");
        if shader != POINTER {
            assert_eq!(machine.run(0), Status::Done as u32, "unchecked");
        }
    }
}

/// If all lanes belong to the shader that writes to other lanes, it breaks no rule.
#[test]
fn check_skips_shaders_own_lanes() {
    let mut machine = Machine::new();
    machine.material(0, MATERIAL_SHADED, LANES, 1);
    let before = bits(machine.surfaces.leave[8]);
    assert_eq!(machine.run(FEATURE_CHECK_SHADERS), Status::Done as u32);
    assert_eq!(bits(machine.found().leave[8]), before.wrapping_add(1));
}

#[test]
fn the_examples_rings_are_round() {
    let mut machine = Machine::new();
    let mut material = Material::new_zeroed();
    material.flags = MATERIAL_SHADED.into();
    material.shader = RINGS.into();
    material.parameters = [0.25, 0.5, 1.0, 3.0].map(|value| single(from_f64(value)));
    machine.put(MATERIALS, &material);
    let mut shading = ShaderContext::new_zeroed();
    shading.eye = [5.0, -7.0, 2.0, 0.0].map(|value| single(from_f64(value)));
    let address = elf::Image::parse(&machine.elf).unwrap().symbol("shading");
    machine.put(address.unwrap(), &shading);
    for lane in 0..16 {
        let mut value = |from, to| single(from_f64(machine.random.random_range(from..to)));
        machine.surfaces.point_x[lane] = value(-9.0, 9.0);
        machine.surfaces.point_z[lane] = value(-9.0, 9.0);
        machine.surfaces.red[lane] = value(0.0, 1.0);
    }
    let before = machine.surfaces;
    assert_eq!(machine.run(FEATURE_CHECK_SHADERS), Status::Done as u32);
    let found = machine.found();
    for lane in 0..16 {
        let value = |row: &[F32; 16]| to_f64(bits(row[lane]));
        let turns = 3.0 * libm::hypot(value(&before.point_x) + 5.0, value(&before.point_z) + 2.0);
        let part = (2.0 * turns.fract() - 1.0).powi(2);
        let red = value(&before.red) + part * (0.25 - value(&before.red));
        assert!((value(&found.red) - red).abs() < 1e-4, "{lane}: {red}");
    }
}
