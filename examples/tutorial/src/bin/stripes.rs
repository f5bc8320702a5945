//! A planet with clouds in stripes, which a shader of this crate draws, and a moon that orbits it.

use cellray::game::{
    DVec3, Frame, Game, Key, Light, Material, MaterialId, ObjectId, Shader, Start, View, World,
    WorldError,
};
use cellray::spe::{Program, ProgramError};

/// The tracer's SPU program with `shaders/stripes.s` in it, built by `build.rs`.
const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/tracer.elf"));

/// The planet's gravity at a distance of 1.
const ATTRACTION: f64 = 22.0;

struct Stripes {
    clouds: MaterialId,
    /// Stripes for each unit of length.
    scale: f64,
    moon: ObjectId,
    place: DVec3,
    velocity: DVec3,
}

impl Default for Stripes {
    fn default() -> Self {
        Self {
            clouds: MaterialId::default(),
            scale: 1.6,
            moon: ObjectId::default(),
            place: DVec3::new(3.2, 0.2, 3.2),
            velocity: DVec3::new(1.6, 0.0, -1.6),
        }
    }
}

fn striped(colour: [f64; 3], scale: f64, strength: f64) -> Material {
    let [red, green, blue] = colour;
    Material {
        shader: Shader::Own { name: "stripes".into(), parameters: [scale, strength, 0.0, 0.0] },
        ..Material::matte(red, green, blue)
    }
}

impl Stripes {
    fn clouds(&self) -> Material {
        striped([1.0, 0.9, 0.78], self.scale, 0.9)
    }
}

impl Game for Stripes {
    fn name(&self) -> &str {
        "stripes"
    }

    fn program(&self) -> Result<Option<Program>, ProgramError> {
        Program::from_image(IMAGE).map(Some)
    }

    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        world.set_view(View {
            from: DVec3::new(0.0, 3.0, 12.0),
            // The planet's axis is tilted.
            up: DVec3::new(0.3, 1.0, 0.0),
            ..world.view().clone()
        })?;
        world.set_background(DVec3::new(0.01, 0.012, 0.03))?;
        world.set_ambient(DVec3::splat(0.06))?;
        world.add_light(Light::sun(DVec3::new(1.0, 0.5, 1.2)).coloured(0.95, 0.94, 0.9))?;
        self.clouds = world.add_material(self.clouds())?;
        let planet = world.add_sphere(DVec3::ZERO, 3.0, self.clouds)?;
        world.fix(planet)?;
        let rock = world.add_material(striped([0.6, 0.7, 0.8], 9.0, 0.7))?;
        self.moon = world.add_sphere(self.place, 0.6, rock)?;
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let step = frame.delta.min(0.1);
        let distance = self.place.length();
        self.velocity -= self.place * (ATTRACTION / (distance * distance * distance) * step);
        self.place += self.velocity * step;
        world.move_to(self.moon, self.place)?;
        let more = f64::from(frame.input.key_axis(Key::Down, Key::Up));
        if more != 0.0 {
            self.scale = (self.scale + more * step).clamp(0.0, 8.0);
            world.set_material(self.clouds, self.clouds())?;
        }
        Ok(())
    }
}

fn main() -> std::process::ExitCode {
    cellray_play::main_of::<Stripes>()
}
