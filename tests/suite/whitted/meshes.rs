//! Meshes in local store and in main memory, compared with the reference.

use cellray::scene::SceneBlock;
use oracle::whitted::trace;
use scenes::Mesh;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, options, picture};

const SIZE: (u32, u32) = (80, 60);

/// Half a sphere that is open at the top, of `4 rows^2` triangles. With normals it is smooth,
/// except for the lowest ring.
fn bowl(rows: u32, normals: bool) -> Mesh {
    let columns = 2 * rows;
    let mut mesh = Mesh { two_sided: true, ..Mesh::default() };
    for row in 0..=rows {
        for column in 0..columns {
            let down = std::f64::consts::FRAC_PI_2 * f64::from(row) / f64::from(rows);
            let around = std::f64::consts::TAU * f64::from(column) / f64::from(columns);
            let (ring, height) = (libm::cos(down), -libm::sin(down));
            let point = DVec3::new(ring * libm::cos(around), height, -ring * libm::sin(around));
            mesh.positions.push(point.as_vec3().to_array());
            let normal = if row + 1 < rows { point } else { DVec3::ZERO };
            mesh.normals.push(normal.as_vec3().to_array());
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let at = |row: u32, column: u32| row * columns + column % columns;
            let (a, b) = (at(row, column), at(row, column + 1));
            let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
            mesh.triangles.extend([[a, c, d], [a, d, b]]);
            mesh.materials.extend([row % 2, row % 2]);
        }
    }
    if !normals {
        mesh.normals.clear();
    }
    mesh
}

fn scene(mesh: Mesh) -> scenes::Scene {
    let text = "v\nfrom 1 2.5 4\nat 0 -0.4 0\nup 0 1 0\nangle 35\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 4 6 3 0.9 0.9 0.9\n\
        f 0.9 0.3 0.2 0.9 0 0 0 1\nf 0.2 0.5 0.9 0.6 0.3 30 0 1\n\
        p 4\n-9 -1 9\n9 -1 9\n9 -1 -9\n-9 -1 -9\ns 0.2 -0.2 0.1 0.3\n";
    let mut scene = scenes::parse(text.as_bytes(), "bowl", &scenes::Limits::default()).unwrap();
    scene.mesh = Some(Arc::new(mesh));
    scene
}

/// From inside a closed mesh, no primary ray finds its way out between two triangles.
#[test]
fn closed_mesh_has_no_cracks() {
    let lower = bowl(24, false);
    let mut mesh = Mesh { two_sided: true, ..lower.clone() };
    let first = mesh.positions.len() as u32;
    let above = |[x, y, z]: &[f32; 3]| [*x, -y, *z];
    mesh.positions.extend(lower.positions.iter().map(above));
    let upper = |triangle: &[u32; 3]| triangle.map(|corner| corner + first);
    mesh.triangles.extend(lower.triangles.iter().map(upper));
    mesh.materials.extend(&lower.materials);
    let mut scene = scene(mesh);
    scene.objects.clear();
    scene.view.from = DVec3::new(0.1, 0.05, -0.2);
    scene.view.angle = 100.0;
    for at in [[1.0, 0.2, 0.1], [-0.3, 1.0, 0.2], [0.1, -0.2, -1.0]] {
        scene.view.at = at.into();
        let found = Frame::of(&scene, WHITTED, (320, 240), Settings::default());
        let rays = found.rays();
        assert_eq!((rays.eye, rays.eye_hit), (320 * 240, 320 * 240), "{at:?}");
    }
}

#[test]
fn spheres_over_the_local_store_limit_are_streamed() {
    let scene = scenes::load(std::path::Path::new("sphereflake:4")).unwrap();
    let found = Frame::of(&scene, WHITTED, SIZE, Settings::default());
    let blocks = found.statistics.spus.iter().map(|spu| spu.blocks.used);
    assert!(blocks.sum::<u64>() > 0);
    let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
    let compared = oracle::compare(&picture(&found.picture), &reference).unwrap();
    assert!(compared.max_error_off_silhouette <= 2, "{compared:?}");
    // Almost every pixel is on a silhouette.
    assert!(compared.wrong_fraction < 0.02, "{compared:?}");
}

/// A scene whose parts and view are all moved. Only a mesh's origin moves, not its positions.
fn moved(scene: &scenes::Scene, by: DVec3) -> scenes::Scene {
    let mut moved = scene.clone();
    moved.view.from += by;
    moved.view.at += by;
    for light in &mut moved.lights {
        if let scenes::LightKind::Point { position, .. } = &mut light.kind {
            *position += by;
        }
    }
    for object in &mut moved.objects {
        match &mut object.shape {
            scenes::Shape::Sphere { centre, .. } => *centre += by,
            scenes::Shape::Cone { base, apex, .. } => {
                *base += by;
                *apex += by;
            }
            scenes::Shape::Polygon { vertices } | scenes::Shape::Patch { vertices, .. } => {
                vertices.iter_mut().for_each(|vertex| *vertex += by);
            }
        }
    }
    if let Some(mesh) = &mut moved.mesh {
        Arc::make_mut(mesh).origin += by;
    }
    moved
}

#[test]
fn far_from_the_origin_pictures_are_the_same() {
    // As far as the coordinates of a map, and exact in the sums.
    let by = DVec3::new(458_752.0, 5_428_000.25, 100.5);
    let mut small = scene(bowl(8, true));
    small.view.at.y = -0.5;
    small.objects.retain(|it| matches!(it.shape, scenes::Shape::Polygon { .. }));
    let large = scenes::Scene { mesh: Some(Arc::new(bowl(24, true))), ..small.clone() };
    // More spheres and polygons than fit in local store, at numbers of few digits.
    let grid = |count: i32, shape: &dyn Fn(DVec3) -> scenes::Shape| {
        let mut many = small.clone();
        many.mesh = None;
        for index in 0..count {
            let place = DVec3::new((index % 32 - 16).into(), 0.0, (index / 32 - 16).into());
            many.objects.push(scenes::Object { line: 0, material: 1, shape: shape(place / 8.0) });
        }
        many
    };
    let spheres = grid(1024, &|centre| scenes::Shape::Sphere { centre, radius: 0.0625 });
    let polygons = grid(1024, &|place| scenes::Shape::Polygon {
        vertices: [DVec3::X, DVec3::Y, DVec3::Z].map(|it| place + it / 16.0).to_vec(),
    });
    for (name, near) in [
        ("in local store", small),
        ("streamed", large),
        ("spheres", spheres),
        ("polygons", polygons),
    ] {
        let draw = |scene: &scenes::Scene| Frame::of(scene, WHITTED, SIZE, Settings::default());
        let (here, there) = (draw(&near), draw(&moved(&near, by)));
        let hits = here.rays().eye_hit;
        assert!(hits > 1000, "{name}: {hits}");
        assert_eq!(here.picture, there.picture, "{name}");
    }
}

/// Cones and spheres of all forms, in a cube, above a floor.
fn crowd(cones: u32, spheres: u32) -> scenes::Scene {
    const FILLS: [&str; 4] = [
        "f 0.8 0.5 0.3 0.7 0.3 30 0 0\n",
        "f 0.4 0.7 0.4 1 0 0 0 0\n",
        "f 0.5 0.6 0.9 0.6 0.4 60 0 0\n",
        "f 1 1 1 0.1 0.2 30 0.7 1.2\n",
    ];
    let mut text = String::from(
        "v\nfrom 0 -9 5\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 8 8\n\
         b 0.3 0.5 0.8\nl 5 -6 9\nl -7 -5 8\n\
         f 0.7 0.7 0.6 1 0 0 0 0\np 4\n-5 -5 -2\n5 -5 -2\n5 5 -2\n-5 5 -2\n",
    );
    let mut random = ChaCha8Rng::seed_from_u64(u64::from(cones));
    let count = cones + spheres;
    let size = 2.2 / libm::cbrt(f64::from(count));
    for number in 0..count {
        if number % (count / 12) == 0 {
            text += FILLS[random.random_range(0..FILLS.len())];
        }
        let mut within = |most: f64| random.random_range(-most..most);
        let [x, y, z] = [2.8, 2.8, 1.5].map(&mut within);
        let [u, v, w] = [0; 3].map(|_| 0.8 * size * within(1.0));
        // So both kinds are mixed.
        let is_cone = u64::from(number + 1) * u64::from(cones) / u64::from(count)
            > u64::from(number) * u64::from(cones) / u64::from(count);
        if is_cone {
            let base = size * random.random_range(0.05..0.35);
            let apex = match number % 5 {
                0 => base,
                1 => 0.0,
                _ => size * random.random_range(0.05..0.25),
            };
            // Some are seen from inside only.
            let sign = if number % 7 == 0 { -1.0 } else { 1.0 };
            let [base, apex] = [base, apex].map(|radius| sign * radius);
            let (x1, y1, z1) = (x + u, y + v, z + w);
            text += &format!("c {x} {y} {z} {base}\n{x1} {y1} {z1} {apex}\n");
        } else {
            let radius = size * random.random_range(0.15..0.4);
            text += &format!("s {x} {y} {z} {radius}\n");
        }
    }
    scenes::parse(text.as_bytes(), "crowd", &scenes::Limits::default()).unwrap()
}

/// How much a picture of a crowd differs from the reference.
fn crowd_compared(
    (cones, spheres): (u32, u32),
    render_options: RenderOptions,
    settings: Settings,
) -> oracle::Comparison {
    let scene = crowd(cones, spheres);
    let made = Scene::new(&scene, render_options, &Program::tracer()).unwrap();
    let mesh = made.block().and_then(SceneBlock::mesh).unwrap();
    assert_eq!(mesh.blocks.statistics().cones, cones as usize);
    let found = Frame::of(&scene, render_options, SIZE, settings);
    let blocks = found.statistics.spus.iter().map(|spu| spu.blocks.used);
    assert!(blocks.sum::<u64>() > 0);
    let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &options(render_options)).unwrap();
    let compared = oracle::compare(&picture(&found.picture), &reference).unwrap();
    println!("{cones} cones, {spheres} spheres: {compared:?}");
    assert!(compared.max_error_off_silhouette <= 2, "{compared:?}");
    compared
}

#[test]
fn cones_over_the_local_store_limit_are_streamed() {
    let compared = crowd_compared((1500, 0), WHITTED, Settings::default());
    assert!(compared.wrong_fraction < 0.01, "{compared:?}");
    let compared = crowd_compared((5000, 5000), WHITTED, Settings::default());
    assert!(compared.wrong_fraction < 0.04, "{compared:?}");
}

/// With SPD's rules for rays, and without leaving out what can't be hit.
#[test]
fn cones_in_main_memory_by_other_options() {
    let spd = RenderOptions { spd_rays: true, ..WHITTED };
    let compared = crowd_compared((1500, 300), spd, Settings::default());
    assert!(compared.wrong_fraction < 0.02, "{compared:?}");
    let settings = Settings { skip: Skip::Nothing, ..Settings::default() };
    let compared = crowd_compared((1500, 300), WHITTED, settings);
    assert!(compared.wrong_fraction < 0.02, "{compared:?}");
}

#[test]
fn mesh_equals_reference() {
    for (rows, normals) in [(8, false), (8, true), (24, false), (24, true)] {
        let scene = scene(bowl(rows, normals));
        let found = Frame::of(&scene, WHITTED, SIZE, Settings::default());
        // Up to 512 triangles may be in local store.
        let blocks: u64 = found.statistics.spus.iter().map(|spu| spu.blocks.used).sum();
        assert_eq!(blocks > 0, rows > 8);
        let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
        let compared = oracle::compare(&picture(&found.picture), &reference).unwrap();
        assert!(compared.max_error_off_silhouette <= 2, "{compared:?}");
        assert!(compared.wrong_fraction < 0.01, "{compared:?}");

        let without = scenes::Scene { mesh: None, ..scene.clone() };
        let (bare, _) = trace(&without, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
        let compared = oracle::compare(&picture(&found.picture), &bare).unwrap();
        assert!(compared.wrong_fraction > 0.1, "the mesh is not in the picture");
    }
}
