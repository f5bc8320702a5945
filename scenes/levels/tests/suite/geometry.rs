//! The map of the maker, whose triangles and pictures are known.

use glam::{DVec2, DVec3};
use levels::{Graphics, Level, Map, Name, Pictures as _, Plan, Plane, SKY, Surface, moves};

use crate::maker::wad;

fn level() -> (Map, Plan, Level) {
    let wad = wad();
    let map = Map::read(&wad, Name::new("E1M1")).unwrap();
    let plan = Plan::of(&map);
    let level = Level::build(&map, &plan, &Graphics::read(&wad).unwrap()).unwrap();
    (map, plan, level)
}

#[test]
fn regions_fill_their_sectors() {
    let (_, plan, _) = level();
    let area = |sector| -> f64 {
        let of = plan.regions.iter().filter(|region| region.sector == sector);
        of.map(|region| {
            let [a, b, c] = region.corners;
            (b - a).perp_dot(c - a) / 2.0
        })
        .sum()
    };
    assert_eq!([0, 1, 2].map(area), [256.0 * 128.0, 32.0 * 128.0, 256.0 * 128.0]);
    let inside = plan.regions.iter().find(|region| region.holds(DVec2::new(270.0, 5.0)));
    assert_eq!(inside.map(|region| region.sector), Some(1));
}

/// Without its door, the level is closed: the areas of its triangles as vectors, of which each is
/// at right angles to its triangle, cancel out.
#[test]
fn level_is_closed() {
    let (map, _, level) = level();
    assert_eq!(moves(&map, &map.lines[8]), [((1, Plane::Ceiling), 92.0)]);
    let moving: Vec<_> = level.parts.iter().map(|part| part.moves_with).collect();
    assert_eq!(moving, [None, Some((1, Plane::Ceiling))]);
    let mut sum = DVec3::ZERO;
    for part in &level.parts {
        for triangle in 0..part.mesh.triangles.len() {
            let [a, b, c] = part.mesh.places(triangle);
            sum += (b - a).cross(c - a);
        }
    }
    // The walls beside the door are as high as it opens, and face each other.
    assert_eq!(sum, DVec3::ZERO);
}

#[test]
fn pictures_hang_where_maps_say() {
    let (_, _, level) = level();
    let stone = level.surfaces.iter().position(|it| *it == Surface::Wall(Name::new("STONE")));
    let stone = stone.unwrap() as u32;
    let door = &level.parts[1].mesh;
    // The side of the door towards sector 0 ends at its lower edge with its picture's last row.
    let rows: Vec<f32> = (0..door.triangles.len())
        .filter(|number| door.materials[*number] == stone)
        .flat_map(|number| door.triangles[number])
        .filter(|vertex| door.positions[*vertex as usize][1] == 0.0)
        .map(|vertex| door.texture_coordinates[vertex as usize][1])
        .collect();
    assert!(!rows.is_empty() && rows.iter().all(|row| row.fract() == 0.0), "{rows:?}");
    assert!(level.surfaces.contains(&Surface::Sky));
    assert!(!level.surfaces.contains(&Surface::Flat(Name::new(SKY))));
    assert!(level.notes.is_empty(), "{:?}", level.notes);
}

/// With the door open, a grate of 2 by 4 texels hangs in it. One of its columns has three texels
/// below a hole, and the other has none.
#[test]
fn grate_has_holes() {
    let wad = wad();
    let mut map = Map::read(&wad, Name::new("E1M1")).unwrap();
    map.sectors[1].ceiling = 96.0;
    let level = Level::build(&map, &Plan::of(&map), &Graphics::read(&wad).unwrap()).unwrap();
    let grate = level.surfaces.iter().position(|it| *it == Surface::Wall(Name::new("GRATE")));
    let mesh = &level.parts[0].mesh;
    let parts = (0..mesh.triangles.len())
        .filter(|number| Some(mesh.materials[*number] as usize) == grate)
        .map(|number| mesh.places(number));
    let parts: Vec<[DVec3; 3]> = parts.collect();
    let area: f64 = parts.iter().map(|[a, b, c]| (*b - *a).cross(*c - *a).length() / 2.0).sum();
    assert_eq!((parts.len(), area), (2 * 64, 3.0 * 64.0));
    assert!(parts.as_flattened().iter().all(|place| (92.0..=95.0).contains(&place.y)));
    assert!(parts.as_flattened().iter().all(|place| place.x == 256.0));
    assert!(level.notes.is_empty(), "{:?}", level.notes);
}

/// A lamp's picture of a column of four texels, one of them a hole, is a square of its outline.
#[test]
fn things_stand_on_crossed_planes() {
    let (_, _, level) = level();
    assert!(level.with_sprites.contains(&2028));
    let lamp = level.surfaces.iter().position(|it| *it == Surface::Sprite(Name::new("COLUA0")));
    let mesh = &level.parts[0].mesh;
    let sides: Vec<[DVec3; 3]> = (0..mesh.triangles.len())
        .filter(|number| Some(mesh.materials[*number] as usize) == lamp)
        .map(|number| mesh.places(number))
        .collect();
    let normals = sides.iter().map(|[a, b, c]| (*b - *a).cross(*c - *a) / 4.0);
    let facing = |way: DVec3| normals.clone().filter(|normal| *normal == way).count();
    for way in [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z] {
        assert_eq!(facing(way), 2, "{way}");
    }
    assert_eq!(sides.len(), 8);
    let foot = DVec3::new(128.0, 0.0, -64.0);
    let box_around = |place: &DVec3| (*place - foot).abs().max_element() <= 4.0 && place.y >= 0.0;
    assert!(sides.as_flattened().iter().all(box_around), "{sides:?}");
}

#[test]
fn patches_are_drawn_in_columns() {
    let wad = wad();
    let graphics = Graphics::read(&wad).unwrap();
    let grate = graphics.wall(Name::new("grate")).unwrap().unwrap();
    assert_eq!((grate.width, grate.height()), (2, 4));
    let colour = |index: u8| Some([0, 1, 2].map(|channel| index.wrapping_mul(3) + channel));
    let column: Vec<_> = (0..4).map(|row| grate.texels[2 * row]).collect();
    assert_eq!(column, [None, colour(1), colour(2), colour(3)]);
    assert!(grate.has_holes());
    assert!(!graphics.wall(Name::new("STONE")).unwrap().unwrap().has_holes());
    assert_eq!(graphics.wall(Name::new("OTHER")).unwrap(), None);
}
