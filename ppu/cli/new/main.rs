//! A ball that jumps on a mirror.

use cellray::prelude::*;

#[derive(Default)]
struct Ball(ObjectId);

impl Game for Ball {
    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        world.look_from([0.0, 3.0, 12.0], [0.0, 2.0, 0.0])?;
        world.set_background([0.4, 0.6, 0.9])?;

        let red = world.add_material(Material::shiny(0.9, 0.2, 0.1))?;
        self.0 = world.add_sphere(DVec3::Y, 1.0, red)?;

        let floor = world.add_material(Material {
            specular: 0.3,
            ..Material::matte(0.5, 0.5, 0.45)
        })?;
        let corners = [(-9.0, 9.0), (9.0, 9.0), (9.0, -9.0), (-9.0, -9.0)];
        world.add_polygon(&corners.map(|(x, z)| [x, 0.0, z]), floor)?;
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let part = frame.time % 1.0;
        world.move_to(self.0, DVec3::Y * (1.0 + 16.0 * part * (1.0 - part)))
    }
}

fn main() -> std::process::ExitCode {
    cellray_play::main_of::<Ball>()
}
