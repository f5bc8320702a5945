//! Meshes of a world at their places, and more spheres or cones than fit in local store:
//! every picture is that of a new scene with the same content, byte for byte.

use std::f64::consts::{PI, TAU};

use cellray::game::{DVec3, Mesh, MeshId, RenderOptions, Texture, Wrap};

use super::kind;
use crate::prelude::*;

const SIZE: (u32, u32) = (132, 66);

/// A pear with smooth normals, of 2 `rows` `columns` triangles.
pub fn pear(rows: u32, columns: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        for column in 0..columns {
            let down = PI * f64::from(row) / f64::from(rows);
            let around = TAU * f64::from(column) / f64::from(columns);
            let (ring, height) = (libm::sin(down), libm::cos(down));
            let point = DVec3::new(ring * libm::cos(around), height, -ring * libm::sin(around));
            let stretched = point * DVec3::new(0.7, 1.0 + 0.4 * point.y, 0.5);
            mesh.positions.push(stretched.as_vec3().to_array());
            mesh.normals.push(point.as_vec3().to_array());
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let at = |row: u32, column: u32| row * columns + column % columns;
            let (a, b) = (at(row, column), at(row, column + 1));
            let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
            mesh.triangles.extend([[a, c, d], [a, d, b]]);
            mesh.materials.extend([0, 0]);
        }
    }
    mesh
}

fn world() -> (World, MaterialId) {
    let mut world = World::new();
    world.set_background([0.3, 0.4, 0.6]).unwrap();
    world.look_from([1.0, 2.5, 7.0], DVec3::ZERO).unwrap();
    world.add_light(Light::at(DVec3::new(4.0, 6.0, 3.0))).unwrap();
    let grey = world.add_material(Material::matte(0.7, 0.7, 0.7)).unwrap();
    let floor = [[-9, -1, 9], [9, -1, 9], [9, -1, -9], [-9, -1, -9]];
    let floor = floor.map(|corner| DVec3::from_array(corner.map(f64::from)));
    world.add_polygon(&floor, grey).unwrap();
    let red = world.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
    (world, red)
}

/// An engine, and the picture that it made last.
struct Screen {
    engine: Engine,
    shown: Snapshot,
}

impl Screen {
    fn new() -> Self {
        let (framebuffer, shown) = Recorder::pair(SIZE.0, SIZE.1);
        let settings = Settings { spus: 2, ..Settings::default() };
        let engine = Engine::start(settings, framebuffer).unwrap();
        Self { engine, shown }
    }

    fn picture(&mut self, scene: &Scene) -> image::RgbImage {
        self.engine.render(scene, &mut |_| ()).unwrap();
        self.shown.lock().unwrap().take().unwrap()
    }
}

/// Compares a world's pictures with those of new scenes.
struct Compared {
    changed: Screen,
    fresh: Screen,
    program: Program,
}

impl Compared {
    fn new() -> Self {
        Self { changed: Screen::new(), fresh: Screen::new(), program: Program::tracer() }
    }

    fn picture(&mut self, world: &mut World) -> image::RgbImage {
        let picture = self.changed.picture(world.scene(&self.program).unwrap());
        let scene = Scene::new(&world.to_nff(), RenderOptions::default(), &self.program).unwrap();
        assert!(picture == self.fresh.picture(&scene));
        picture
    }

    /// Compares the picture after each step, which must differ from the one before.
    fn changes(
        &mut self,
        world: &mut World,
        steps: std::ops::Range<u32>,
        mut change: impl FnMut(&mut World, u32),
    ) {
        let mut last = self.picture(world);
        for step in steps {
            change(world, step);
            let picture = self.picture(world);
            assert!(picture != last, "{step}");
            last = picture;
        }
    }
}

fn at(x: f64, y: f64, z: f64) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(x, y, z))
}

/// A texture of four texels, of which two have this colour.
pub fn chequered(colour: [u8; 3]) -> Option<Arc<Texture>> {
    let texels = vec![colour, [255; 3], [255; 3], colour];
    Texture::new(2, texels, [Wrap::Repeat; 2]).map(Arc::new)
}

/// A mesh with a texture beside one without texture coordinates, of the same material: the texture
/// is changed, taken away and put back, and the mesh moves.
#[test]
fn textures_of_meshes() {
    let (mut world, red) = world();
    let plain = Arc::new(pear(8, 12));
    let mut mesh = pear(8, 12);
    let places = mesh.positions.iter().map(|[x, y, _]| [2.0 * x, 3.0 * y]);
    mesh.texture_coordinates = places.collect();
    let first = world.add_mesh(Arc::new(mesh.clone()), &[red], at(-1.0, 0.0, 0.0)).unwrap();
    world.add_mesh(plain, &[red], at(1.5, 0.2, -0.5)).unwrap();
    let mut compared = Compared::new();
    let mut last = compared.picture(&mut world);
    let mut sum = world.checksum();
    for step in 0..6 {
        let material = Material {
            texture: match step {
                0 | 4 => chequered([20, 40, 90]),
                1 | 5 => chequered([90, 200, 40]),
                _ => None,
            },
            ..world.material(red).unwrap()
        };
        match step {
            3 => world.place_mesh(first, at(-1.2, 0.1, 0.0)).unwrap(),
            _ => world.set_material(red, material).unwrap(),
        }
        let picture = compared.picture(&mut world);
        assert!(picture != last, "{step}");
        assert_ne!(world.checksum(), sum, "{step}");
        (last, sum) = (picture, world.checksum());
    }
    world.place_mesh(first, at(-1.0, 0.3, 0.0)).unwrap();
    assert!(compared.picture(&mut world) != last);

    mesh.texture_coordinates.pop();
    let refused = world.add_mesh(Arc::new(mesh.clone()), &[red], DAffine3::IDENTITY);
    let message = refused.unwrap_err().to_string();
    assert!(message.contains("as many texture coordinates, or none"), "{message}");
    mesh.texture_coordinates.push([0.0, f32::NAN]);
    let refused = world.add_mesh(Arc::new(mesh), &[red], DAffine3::IDENTITY);
    let message = refused.unwrap_err().to_string();
    assert!(message.contains("texture coordinate NaN"), "{message}");
}

/// Two places of a mesh: one turns and grows, the other is mirrored, hidden, shown and removed.
fn play(mesh: Mesh) {
    let (mut world, red) = world();
    let mesh = Arc::new(mesh);
    let left = world.add_mesh(mesh.clone(), &[red], at(-1.0, 0.0, 0.0)).unwrap();
    let right = at(1.0, 0.2, -0.5);
    let other = world.add_mesh(mesh, &[red], right).unwrap();
    let mut compared = Compared::new();
    let mut last = compared.picture(&mut world);
    for frame in 1..=7 {
        let angle = 0.3 * f64::from(frame);
        let turned = at(-1.0, 0.1 * angle, 0.0) * DAffine3::from_rotation_y(angle);
        let grown = DAffine3::from_scale(DVec3::new(1.0, 1.0 + 0.3 * angle, 0.8));
        world.place_mesh(left, turned * DAffine3::from_rotation_x(angle) * grown).unwrap();
        match frame {
            2 => {
                let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
                world.place_mesh(other, right * mirror).unwrap();
            }
            3 => world.show_mesh(other, false).unwrap(),
            4 => world.place_mesh(other, right).unwrap(),
            5 => world.show_mesh(other, true).unwrap(),
            6 => world.remove_mesh(other).unwrap(),
            _ => {}
        }
        let picture = compared.picture(&mut world);
        assert!(picture != last, "frame {frame}");
        last = picture;
    }
}

/// More materials than fit in local store: each is changed in place, the mesh moves, and a
/// sphere in local store has one of them, too.
#[test]
fn materials_over_local_store_capacity() {
    let (mut world, _) = world();
    let mut mesh = pear(16, 20);
    let count = mesh.triangles.len() as u32;
    mesh.materials = (0..count).collect();
    // All different, so that none can share a record.
    let shade = |number: u32| f64::from(number * 37 % count) / f64::from(count);
    let materials: Vec<MaterialId> = (0..count)
        .map(|number| {
            let material = Material::matte(shade(number), shade(number + 7), 0.5);
            world.add_material(material).unwrap()
        })
        .collect();
    let place = at(0.0, 0.3, 0.0);
    let id = world.add_mesh(Arc::new(mesh), &materials, place).unwrap();
    let ball = world.add_sphere(DVec3::new(-1.5, -0.5, 1.0), 0.4, materials[5]).unwrap();
    let scene = world.scene(&Program::tracer()).unwrap();
    let mesh = scene.block().and_then(|block| block.mesh()).unwrap();
    assert!(mesh.table.is_some());
    Compared::new().changes(&mut world, 0..6, |world, step| {
        match step {
            // No object in local store has it.
            5 => {
                for material in &materials[100..200] {
                    world.recolour(*material, DVec3::new(0.1, 0.9, 0.2)).unwrap();
                }
            }
            0 => world.set_material(materials[5], Material::mirror()).unwrap(),
            1 => {
                for (number, material) in (0..).zip(&materials) {
                    let colour = DVec3::new(0.9, shade(number), 0.1);
                    world.recolour(*material, colour).unwrap();
                }
            }
            2 => world.place_mesh(id, at(0.4, 0.2, -0.5)).unwrap(),
            3 => world.remove(ball).unwrap(),
            _ => {
                for material in &materials[200..400] {
                    world.set_material(*material, Material::glass()).unwrap();
                }
            }
        }
    });
}

/// A mesh with colours beside one without: it moves, and the other is removed.
#[test]
fn colours_of_meshes() {
    let (mut world, red) = world();
    let white = world.add_material(Material::matte(0.9, 0.9, 0.9)).unwrap();
    let plain = Arc::new(pear(8, 12));
    let mut mesh = pear(8, 12);
    let sum = |mesh: &Mesh| {
        let (mut world, red) = self::world();
        let mesh = Arc::new(mesh.clone());
        world.add_mesh(mesh, &[red], at(0.0, 0.0, 0.0)).unwrap();
        world.checksum()
    };
    let before = sum(&mesh);
    let colours = mesh.positions.iter();
    let colours = colours.map(|position| position.map(|axis| (0.5 + 0.4 * axis).clamp(0.0, 1.0)));
    mesh.colours = colours.collect();
    assert!(sum(&mesh) != before);
    let id = world.add_mesh(Arc::new(mesh), &[white], at(-1.0, 0.0, 0.0)).unwrap();
    let other = world.add_mesh(plain, &[red], at(1.5, 0.2, -0.5)).unwrap();
    Compared::new().changes(&mut world, 0..3, |world, step| match step {
        0 => world.place_mesh(id, at(-0.8, 0.3, 0.2)).unwrap(),
        1 => world.remove_mesh(other).unwrap(),
        _ => world.set_material(white, Material::matte(0.3, 0.9, 0.4)).unwrap(),
    });
}

#[test]
fn meshes_move_in_main_memory() {
    play(pear(30, 30));
}

#[test]
fn meshes_move_in_local_store() {
    play(pear(8, 8));
}

/// The tree is refitted until rays have wasted as many tests as they make in two pictures, and so
/// is one that has stopped moving while the eye moves.
#[test]
fn degraded_tree_is_rebuilt() {
    for refit_pictures in [0, 2, u32::MAX] {
        let (mut world, red) = world();
        world.set_render_options(RenderOptions { refit_pictures, ..RenderOptions::default() });
        let mesh = Arc::new(pear(30, 30));
        let other = world.add_mesh(mesh.clone(), &[red], DAffine3::IDENTITY);
        let other = other.unwrap();
        // Both pears fill the same space, so blocks have triangles of both.
        world.add_mesh(mesh, &[red], DAffine3::IDENTITY).unwrap();
        let program = Program::tracer();
        let wear = |world: &mut World| {
            let scene = world.scene(&program).unwrap();
            scene.block().unwrap().mesh().unwrap().blocks.wear()
        };
        assert!((wear(&mut world) - 1.0).abs() < 1e-9);
        let (mut wasted, mut replaced) = (0.0, 0);
        for frame in 1..=30 {
            match frame {
                ..=9 => world.place_mesh(other, at(0.03 * f64::from(frame), 0.0, 0.0)),
                _ => world.look_from([-0.1 * f64::from(frame), 2.5, 7.0], DVec3::ZERO),
            }
            .unwrap();
            match wear(&mut world) {
                wear if wear > 1.001 => {
                    wasted += wear - 1.0;
                    assert!(wasted < f64::from(refit_pictures), "frame {frame}: {wasted}");
                }
                _ if refit_pictures == 0 => replaced += 1,
                _ => {
                    // It was nearly used up.
                    assert!(replaced == 1 || wasted > 1.0, "frame {frame}: {wasted}");
                    replaced = 1;
                    wasted = 0.0;
                }
            }
        }
        assert_eq!(replaced > 0, refit_pictures < u32::MAX, "{refit_pictures}");
    }
}

/// A quarter turn is exact, so the vertices can be turned here without the world's own arithmetic.
#[test]
fn placed_mesh_equals_mesh_with_moved_vertices() {
    let mesh = pear(30, 30);
    let turned = |vectors: &[[f32; 3]], by: f32| -> Vec<[f32; 3]> {
        vectors.iter().map(|&[x, y, z]| [-y + by, x, z]).collect()
    };
    let there = Mesh {
        positions: turned(&mesh.positions, 0.5),
        normals: turned(&mesh.normals, 0.0),
        ..mesh.clone()
    };
    let place = DAffine3 {
        matrix3: glam::DMat3::from_cols(DVec3::Y, DVec3::NEG_X, DVec3::Z),
        translation: DVec3::new(0.5, 0.0, 0.0),
    };
    let mut compared = Compared::new();
    let (mut expected, red) = world();
    expected.add_mesh(Arc::new(there), &[red], DAffine3::IDENTITY).unwrap();
    let expected = compared.picture(&mut expected);
    let (mut moved, red) = world();
    let id = moved.add_mesh(Arc::new(mesh), &[red], DAffine3::IDENTITY).unwrap();
    assert!(compared.picture(&mut moved) != expected);
    moved.place_mesh(id, place).unwrap();
    assert!(compared.picture(&mut moved) == expected);
}

#[test]
fn checksum_includes_mesh_positions() {
    let (mut world, red) = world();
    let before = world.checksum();
    let mesh = world.add_mesh(Arc::new(pear(4, 4)), &[red], at(1.0, 0.0, 0.0)).unwrap();
    let first = world.checksum();
    world.place_mesh(mesh, at(2.0, 0.0, 0.0)).unwrap();
    let second = world.checksum();
    assert!(before != first && first != second);
    world.place_mesh(mesh, at(1.0, 0.0, 0.0)).unwrap();
    assert_eq!(world.checksum(), first);
}

#[test]
fn spheres_over_local_store_capacity() {
    let (mut world, red) = world();
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut spheres = Vec::new();
    for _ in 0..1500 {
        let place: [f64; 3] = std::array::from_fn(|_| random.random_range(-2.0..2.0));
        spheres.push(world.add_sphere(place, 0.1, red).unwrap());
    }
    Compared::new().changes(&mut world, 0..5, |world, frame| {
        match frame {
            0 => world.move_to(spheres[0], [0.0, 1.0, 3.0]).unwrap(),
            1 => spheres[..400].iter().for_each(|&id| world.show(id, false).unwrap()),
            2 => world.look_from([0.0, 2.0, 8.0], DVec3::ZERO).unwrap(),
            3 => spheres[..400].iter().for_each(|&id| world.show(id, true).unwrap()),
            // The remaining ones all fit.
            _ => spheres[..900].iter().for_each(|&id| world.remove(id).unwrap()),
        }
    });
}

fn cone(base: DVec3, apex: DVec3, apex_radius: f64) -> scenes::Shape {
    scenes::Shape::Cone { base, base_radius: 0.08, apex, apex_radius }
}

#[test]
fn cones_over_local_store_capacity() {
    let (mut world, red) = world();
    let mut random = ChaCha8Rng::seed_from_u64(8);
    let mut cones = Vec::new();
    for _ in 0..1100 {
        let [base, way] = [2.0, 0.3]
            .map(|most| DVec3::from_array([0; 3].map(|_| random.random_range(-most..most))));
        let shape = cone(base, base + way, random.random_range(0.0..0.1));
        cones.push(world.add(shape, red).unwrap());
    }
    Compared::new().changes(&mut world, 0..5, |world, frame| {
        match frame {
            0 => world.move_to(cones[0], [0.0, 1.0, 3.0]).unwrap(),
            1 => cones[..200].iter().for_each(|&id| world.show(id, false).unwrap()),
            2 => world.look_from([0.0, 2.0, 8.0], DVec3::ZERO).unwrap(),
            3 => cones[..200].iter().for_each(|&id| world.show(id, true).unwrap()),
            // The remaining ones all fit.
            _ => cones[..700].iter().for_each(|&id| world.remove(id).unwrap()),
        }
    });
}

/// Polygons that would fit beside them, but for the code and the cache of meshes.
#[test]
fn polygons_beside_cones_in_main_memory() {
    let (mut world, red) = world();
    let mut random = ChaCha8Rng::seed_from_u64(9);
    let mut polygons = Vec::new();
    for number in 0..1500 {
        let base = DVec3::from_array([0; 3].map(|_| random.random_range(-2.0..2.0)));
        let shape = cone(base, base + DVec3::new(0.0, 0.1, 0.05), 0.02);
        world.add(shape, red).unwrap();
        if number % 5 == 0 {
            let [to, other] =
                [0; 2].map(|_| DVec3::from_array([0; 3].map(|_| random.random_range(-0.2..0.2))));
            let corners = [base, base + to, base + other];
            polygons.push(world.add_polygon(&corners, red).unwrap());
        }
    }
    let mut compared = Compared::new();
    let first = compared.picture(&mut world);
    world.show(polygons[7], false).unwrap();
    compared.picture(&mut world);
    world.show(polygons[7], true).unwrap();
    assert!(compared.picture(&mut world) == first);
}

#[test]
fn triangles_over_local_store_capacity() {
    let scene = scenes::load("tetra:5".as_ref()).unwrap();
    let mut world = World::from_nff(&scene, RenderOptions::default()).unwrap();
    assert_eq!((world.object_count(), world.meshes().count()), (0, 1));
    Compared::new().picture(&mut world);
}

/// Polygons join the meshes when there are too many of them, and leave them when there are few.
#[test]
fn polygons_over_local_store_capacity() {
    for count in [513, 2000] {
        let (mut world, red) = world();
        let ball = world.add_sphere([0.0, 1.0, 2.0], 0.4, red).unwrap();
        let mesh = world.add_mesh(Arc::new(pear(4, 6)), &[red], at(-1.0, 0.5, 1.0)).unwrap();
        let mut random = ChaCha8Rng::seed_from_u64(11);
        let mut triangle = |world: &mut World| {
            let mut point = |around: f64| {
                DVec3::from_array([0; 3].map(|_| random.random_range(-around..around)))
            };
            let middle = point(2.0);
            let corners = [0; 3].map(|_| middle + point(0.2));
            world.add_polygon(&corners, red).unwrap()
        };
        let mut polygons: Vec<_> = (0..count).map(|_| triangle(&mut world)).collect();
        let mut compared = Compared::new();
        let mut last = compared.picture(&mut world);
        for frame in 0..10 {
            match frame {
                0 => world.move_to(ball, [1.0, 1.0, 2.0]).unwrap(),
                1 => (0..20).for_each(|at| {
                    let place = [0.1 * at as f64 - 1.0, 0.5, 3.0];
                    world.move_to(polygons[at], place).unwrap();
                }),
                2 => world.place_mesh(mesh, at(1.0, 0.0, 1.5)).unwrap(),
                3 => world.recolour(red, [0.2, 0.8, 0.1]).unwrap(),
                4 => polygons.push(triangle(&mut world)),
                5 => world.show(ball, false).unwrap(),
                // So few are left that they are in local store.
                6 => polygons[20..].iter().for_each(|&id| world.show(id, false).unwrap()),
                7 => world.show(ball, true).unwrap(),
                8 => polygons[20..].iter().for_each(|&id| world.show(id, true).unwrap()),
                _ => world.remove(polygons[3]).unwrap(),
            }
            let picture = compared.picture(&mut world);
            // One triangle more or less may be hidden by others.
            assert!(picture != last || [4, 9].contains(&frame), "{count}, frame {frame}");
            last = picture;
        }
    }
}

#[test]
fn invalid_meshes_are_refused() {
    let (mut world, red) = world();
    let good = pear(3, 3);
    let spoilt = |spoil: &dyn Fn(&mut Mesh)| {
        let mut mesh = good.clone();
        spoil(&mut mesh);
        Arc::new(mesh)
    };
    let message = |world: &mut World, mesh: Arc<Mesh>| {
        let refused = world.add_mesh(mesh, &[red], DAffine3::IDENTITY);
        refused.expect_err("a spoilt mesh").to_string()
    };
    for (spoil, expected) in [
        (&(|mesh: &mut Mesh| mesh.triangles.clear()) as &dyn Fn(&mut Mesh), "no triangles"),
        (&|mesh| mesh.triangles[4][1] = 12, "triangle 4 has vertex 12 of 12"),
        (&|mesh| mesh.materials[2] = 1, "triangle 2 has material 1 of 1"),
        (&|mesh| mesh.materials.truncate(17), "18 triangles need as many materials, not 17"),
        (&|mesh| mesh.normals.truncate(11), "12 vertices need as many normals, or none, not 11"),
        (
            &|mesh| mesh.colours = vec![[1.0; 3]; 11],
            "12 vertices need as many colours, or none, not 11",
        ),
        (
            &|mesh| {
                mesh.colours = vec![[1.0; 3]; 12];
                mesh.colours[7][1] = 1.5;
            },
            "vertex 7 has 1.5 in its colour: channels must be from 0 to 1",
        ),
        (&|mesh| mesh.colours = vec![[0.0, 0.0, f32::NAN]; 12], "vertex 0 has NaN in its colour"),
        (&|mesh| mesh.positions[1][2] = f32::NAN, "vertex NaN is out of range"),
        (&|mesh| mesh.positions[1][2] = 1e19, "vertex 9.999999980506448e18 is out of range"),
    ] {
        let message = message(&mut world, spoilt(spoil));
        assert!(message.contains(expected), "{message}");
    }

    let good = Arc::new(good);
    let flat = DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0));
    let mesh = world.add_mesh(good.clone(), &[red], DAffine3::IDENTITY).unwrap();
    for place in [flat, at(f64::NAN, 0.0, 0.0), at(1e19, 0.0, 0.0)] {
        assert!(world.add_mesh(good.clone(), &[red], place).is_err());
        assert!(world.place_mesh(mesh, place).is_err());
        assert_eq!(world.mesh_place(mesh).unwrap(), DAffine3::IDENTITY);
    }
    let unknown = world.add_mesh(good, &[MaterialId::default()], DAffine3::IDENTITY);
    assert!(matches!(kind(&unknown), Some(WorldErrorKind::NoMaterial)));
    let in_use = world.remove_material(red);
    assert!(matches!(kind(&in_use), Some(WorldErrorKind::MaterialInUse { users: 1 })));

    world.remove_mesh(mesh).unwrap();
    world.remove_material(red).unwrap();
    for mesh in [mesh, MeshId::default()] {
        for refused in [
            world.place_mesh(mesh, DAffine3::IDENTITY),
            world.mesh_place(mesh).map(drop),
            world.show_mesh(mesh, true),
            world.remove_mesh(mesh),
        ] {
            assert!(matches!(kind(&refused), Some(WorldErrorKind::NoMesh)));
        }
    }
    assert_eq!(world.meshes().count(), 0);
}
