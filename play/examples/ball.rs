//! A ball that swings.

use cellray::game::{DVec3, Game, Material, Moment, ObjectId, Start, World, WorldError};

#[derive(Default)]
struct Ball(ObjectId);

impl Game for Ball {
    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
        self.0 = world.add_sphere(DVec3::ZERO, 1.0, red)?;
        Ok(())
    }
    fn frame(&mut self, world: &mut World, moment: &Moment<'_>) -> Result<(), WorldError> {
        world.move_to(self.0, 3.0 * DVec3::X * moment.time.sin())
    }
}

fn main() -> std::process::ExitCode {
    cellray_play::main_of::<Ball>()
}
