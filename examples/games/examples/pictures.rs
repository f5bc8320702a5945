//! The pictures of `docs/play.md`.
//!
//!     cargo run --release --example pictures -- FOLDER WIDTHxHEIGHT [NAME ...]

use std::error::Error;
use std::path::PathBuf;

use cellray::framebuffer::{Geometry, PictureFile};
use cellray::scene::Look;
use cellray::{Engine, Settings};
use games::demo::{DEMOS, Demo, demo};

fn main() -> Result<(), Box<dyn Error>> {
    let usage = "usage: pictures FOLDER WIDTHxHEIGHT [NAME ...]";
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or(usage)?);
    let size = arguments.next().ok_or(usage)?;
    let (width, height) = size.split_once('x').ok_or(usage)?;
    let (width, height) = (width.parse()?, height.parse()?);
    std::fs::create_dir_all(&folder)?;
    let named: Vec<_> = arguments
        .map(|name| demo(&name).ok_or(format!("no demonstration is called {name}")))
        .collect::<Result<_, _>>()?;
    let wanted: Vec<&Demo> = if named.is_empty() { DEMOS.iter().collect() } else { named };
    for demo in wanted {
        let path = folder.join(demo.name).with_extension("png");
        demo.play((width, height), 1, |world| -> Result<(), Box<dyn Error>> {
            let settings = Settings::default();
            let picture = PictureFile::new(&path, Geometry::new(width, height)?)?;
            let mut engine = Engine::start(settings, Box::new(picture))?;
            world.set_look(Some(Look::default()));
            engine.render(world.scene(&settings.program)?, &mut |_| {})?;
            Ok(())
        })?;
        messages::print!("{}", path.display());
    }
    Ok(())
}
