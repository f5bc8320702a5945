//! The maps of Freedoom, which `ci/setup` installs.

use std::path::Path;

use levels::{Graphics, Level, Map, Plan, Wad};

const FOLDER: &str = "/usr/share/games/doom";

#[test]
fn every_map_of_freedoom_is_read() {
    for (file, count) in [("freedoom1.wad", 36), ("freedoom2.wad", 32)] {
        let path = Path::new(FOLDER).join(file);
        assert!(path.exists(), "no {}: run ci/setup", path.display());
        let wad = Wad::open(&path).unwrap();
        let graphics = Graphics::read(&wad).unwrap();
        assert_eq!(wad.maps().len(), count, "{file}");
        for name in wad.maps() {
            let map = Map::read(&wad, name).unwrap();
            let plan = Plan::of(&map);
            let level = Level::build(&map, &plan, &graphics).unwrap();
            let triangles: usize = level.parts.iter().map(|part| part.mesh.triangles.len()).sum();
            println!(
                "{file} {name}: {triangles} triangles, {} materials, {} parts, {:?}",
                level.materials.len(),
                level.parts.len(),
                level.notes
            );
            assert!(level.with_sprites.len() > 2, "{name}: {:?}", level.with_sprites);
            // Where somebody stands or something lies, there is a floor.
            let outside = map
                .things
                .iter()
                .filter(|thing| !plan.regions.iter().any(|region| region.holds(thing.place)));
            let outside = outside.count();
            assert!(outside * 50 <= map.things.len(), "{name}: {outside} things are outside");
        }
    }
}
