//! A ball that jumps.

use cellray::prelude::*;

#[derive(Default)]
struct Ball(ObjectId);

impl Game for Ball {
    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
        self.0 = world.add_sphere([0.0, 0.0, 0.0], 1.0, red)?;
        Ok(())
    }
    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let part = frame.time % 1.0;
        world.move_to(self.0, [0.0, 16.0 * part * (1.0 - part) - 2.0, 0.0])
    }
}

fn main() -> std::process::ExitCode {
    cellray_play::main_of::<Ball>()
}
