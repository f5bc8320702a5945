//! With the records that the PPU makes, no kernel culls a sphere that some ray enters, neither by
//! f64 with the scene's sphere nor by the intersector's result.

use cellray::framebuffer::Geometry;
use cellray::scene;
use cellray::work::{EyeSpheres, Projection, Skip};
use glam::DVec3;
use kernels::cases::eye::call::{list_buffer, put_packets, put_places};
use kernels::cases::eye::error::NO_HITS;
use kernels::cases::eye::packets::RaySetup;
use kernels::eye_records;
use kernels::prelude::*;
use protocol::formulation::EyeRecord;
use protocol::layout::{Frustum, Packet, Pair, Sphere, TILE_HEIGHT, TILE_WIDTH};
use scenes::{Camera, View};
use spu_emulator::float::single::{fm, fma};
use twins::isect_pairs::isect_pair;
use twins::ray_setup::Basis;
use twins::sphere::{Axis, Constants, Perpendicular};

const SIZE: Geometry = Geometry { width: 320, height: 200 };
const CAMERAS: usize = 200;
const SPHERES: usize = 32;
/// The width and height of a group in pixels.
const GROUP_SIDE: u32 = 16;

/// A random unit vector, uniformly distributed.
fn unit(random: &mut ChaCha8Rng) -> DVec3 {
    DVec3::from_array(kernels::cases::sphere_ray::any_direction(random))
}

/// A random unit vector that is perpendicular to another.
fn across(random: &mut ChaCha8Rng, along: DVec3) -> DVec3 {
    let across = along.cross(unit(random)).try_normalize();
    across.unwrap_or_else(|| along.any_orthonormal_vector())
}

/// A camera at a random place with a random direction, with a narrow or a wide picture.
fn camera(random: &mut ChaCha8Rng) -> Camera {
    let from = unit(random) * libm::exp2(random.random_range(-6.0..6.0_f64));
    let sight = unit(random);
    let view = View {
        from,
        at: from + sight,
        up: across(random, sight),
        angle: random.random_range(1.0..150.0),
        hither: 0.0,
        resolution: (SIZE.width, SIZE.height),
    };
    view.camera(SIZE.width, SIZE.height).expect("a camera")
}

/// A sphere of any distance and size whose edge touches a ray, or is next to it by a tiny distance
/// or by some pixels.
fn sphere_at(random: &mut ChaCha8Rng, eye: DVec3, ray: DVec3) -> scene::Sphere {
    let distance = libm::exp2(random.random_range(-6.0..12.0_f64));
    let share = match random.random_range(0..3) {
        0 => libm::exp2(random.random_range(-16.0..-1.0_f64)),
        1 => random.random_range(0.01..0.99),
        _ => 1.0 - libm::exp2(random.random_range(-16.0..-1.0_f64)),
    };
    let edge: f64 = libm::asin(share);
    let angle = match random.random_range(0..4) {
        0 => edge * random.random_range(0.0..1.0),
        1 => edge + random.random_range(0.0..0.05),
        _ => {
            edge * (1.0
                + random.random_range(-1.0..1.0) * libm::exp2(random.random_range(-24.0..-8.0_f64)))
        }
    };
    let towards = ray * libm::cos(angle) + across(random, ray) * libm::sin(angle);
    scene::Sphere { centre: eye + towards * distance, radius: distance * share, colour: DVec3::ONE }
}

/// Whether a ray enters a sphere from outside, computed only in f64.
fn enters(sphere: &scene::Sphere, eye: DVec3, ray: DVec3) -> bool {
    let to_centre = sphere.centre - eye;
    let passes_at = to_centre.reject_from(ray).length();
    to_centre.dot(ray) > 0.0 && to_centre.length() > sphere.radius && passes_at < sphere.radius
}

fn nearest(vector: DVec3) -> [Single; 3] {
    vector.to_array().map(|value| (value as f32).to_bits())
}

/// The camera's record as in frames, and that of the packets' middles, computed like the frame
/// does.
fn bases(camera: &Camera) -> (Basis, Basis) {
    let basis = Basis {
        corner: nearest(camera.corner),
        right: nearest(camera.right),
        down: nearest(camera.down),
    };
    let (middle, side) = (from_f64(1.5), from_f64(4.0));
    let corner = std::array::from_fn(|axis| {
        let in_row = fma(basis.right[axis], middle, basis.corner[axis]);
        fma(basis.down[axis], middle, in_row)
    });
    let middles = Basis {
        corner,
        right: basis.right.map(|value| fm(value, side)),
        down: basis.down.map(|value| fm(value, side)),
    };
    (basis, middles)
}

/// A group of the picture: its rays, spheres around them, and the spheres that each packet must
/// test.
struct Group {
    camera: Camera,
    left: u32,
    top: u32,
    packets: Vec<Packet>,
    middles: Packet,
    records: Vec<Sphere>,
    /// A sphere's mask: the packets with a ray that enters it.
    entered: Vec<u32>,
}

impl Group {
    fn any(bench: &mut Bench, random: &mut ChaCha8Rng) -> Self {
        let camera = camera(random);
        let projection = Projection::new(&camera, SIZE);
        let (basis, middles) = bases(&camera);
        let left = random.random_range(0..SIZE.width / GROUP_SIDE) * GROUP_SIDE;
        let top = random.random_range(0..SIZE.height / GROUP_SIDE) * GROUP_SIDE;
        let places: [[u32; 2]; 16] = std::array::from_fn(|packet| {
            [left + packet as u32 % 4 * 4, top + packet as u32 / 4 * 4]
        });
        let mut directions = |basis, pixels: &[[u32; 2]]| -> Vec<Vectors> {
            let packets = RaySetup { basis, pixels: pixels.to_vec(), background: 0 }.call(bench);
            packets.into_iter().map(|(directions, _)| directions).collect()
        };
        let rays = directions(basis, &places);
        let middles = directions(middles, &[[left / 4, top / 4]])[0];
        let packet = |rays: &Vectors| eye_records::packet(rays, &NO_HITS);
        let (packets, middles) = (rays.iter().map(packet).collect(), packet(&middles));

        let (mut records, mut entered) = (Vec::new(), Vec::new());
        let mut eye_spheres = EyeSpheres::default();
        for _ in 0..SPHERES {
            let ray = rays[random.random_range(0..16)][random.random_range(0..16)];
            let sphere = sphere_at(random, camera.eye, wide(ray));
            let form = if random.random() { EyeRecord::Centre } else { EyeRecord::Axis };
            eye_spheres.cull(&[sphere], &projection, Skip::Nothing, form);
            let record = Sphere::read_from_bytes(eye_spheres.bytes()).expect("one record");
            let bare = eye_records::bare_sphere(&record);
            let axis =
                Axis { axis: bare.centre, k: bare.radius_squared, distance: bits(record.distance) };
            let needs_test = |ray: &[Single; 3]| {
                let hit = match form {
                    EyeRecord::Centre => isect_pair::<Perpendicular>(*ray, &bare, 1, NO_HITS[0]),
                    EyeRecord::Axis => isect_pair::<Constants>(*ray, &axis, 1, NO_HITS[0]),
                };
                hit.object == 1 || enters(&sphere, camera.eye, wide(*ray))
            };
            let mask = rays
                .iter()
                .fold(0, |mask, packet| mask << 1 | u32::from(packet.iter().any(needs_test)));
            records.push(record);
            entered.push(mask);
        }
        Self { camera, left, top, packets, middles, records, entered }
    }

    /// Checks that a kernel keeps all necessary tests. Returns how many were necessary and how
    /// many it culled.
    fn check(&self, kernel: &str, tested: impl Fn(usize) -> u32) -> (u32, u32) {
        let (mut needed, mut left_out) = (0, 0);
        for (number, entered) in self.entered.iter().enumerate() {
            let tested = tested(number);
            let (camera, record) = (&self.camera, &self.records[number]);
            assert_eq!(
                entered & !tested,
                0,
                "{kernel}: {camera:?}, {record:?}, {entered:#x} without {tested:#x}"
            );
            needed += entered.count_ones();
            left_out += (0xffff ^ tested).count_ones();
        }
        (needed, left_out)
    }
}

/// A unit vector in f64.
fn wide(ray: [Single; 3]) -> DVec3 {
    DVec3::from_array(ray.map(to_f64)).normalize()
}

/// Adds up the results of [`Group::check`], and checks that there are enough of both.
fn assert_both(kernel: &str, results: impl Iterator<Item = (u32, u32)>) {
    let (needed, left_out) = results.fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    println!("{kernel}: {needed} tests needed, {left_out} left out");
    assert!(needed > 10_000 && left_out > 5000, "{needed} {left_out}");
}

#[test]
fn no_ray_that_enters_a_sphere_is_filtered_out() {
    let mut random = random();
    let mut bench = Bench::new();
    let results = (0..CAMERAS).map(|_| {
        let group = Group::any(&mut bench, &mut random);
        let mut masks = [0_u32; SPHERES];
        // One row of packets at a time, because the lists of all rows do not fit.
        for (row, packets) in group.packets.chunks(4).enumerate() {
            bench.reset();
            let packets = put_packets(&mut bench, packets);
            let places = put_places(&mut bench, &packets, |_| [0; 3]);
            let spheres = put(&mut bench, &group.records);
            let buffer = list_buffer(&mut bench, 4 * SPHERES);
            let fours = SPHERES as u32 / 4;
            let arguments = [places.address, 4, spheres.address, fours, buffer.address];
            let end = bench.call("filter_spheres_r16", &arguments).value;
            for pair in bench.read_list::<Pair>(buffer, end) {
                let sphere = (pair.object.get() - spheres.address) as usize / size_of::<Sphere>();
                let packet = packets.iter().position(|packet| packet.address == pair.packet.get());
                masks[sphere] |= 0x8000 >> (4 * row + packet.expect("one of these"));
            }
        }
        group.check("filter_spheres_r16", |sphere| masks[sphere])
    });
    assert_both("filter_spheres_r16", results);
}

#[test]
fn no_packet_a_ray_of_which_enters_a_sphere_is_culled() {
    let mut random = random();
    let mut bench = Bench::new();
    let results = (0..CAMERAS).map(|_| {
        let group = Group::any(&mut bench, &mut random);
        bench.reset();
        let middles = put(&mut bench, &[group.middles; 4]);
        let spheres = put(&mut bench, &group.records);
        let entries: Vec<Pair> = (0..SPHERES)
            .map(|number| eye_records::pair(address::<Sphere>(spheres, number), 0))
            .collect();
        let entries = put(&mut bench, &entries);
        let masks = bench.junk::<[[U32; 4]; SPHERES]>();
        let count = SPHERES as u32;
        let arguments = [middles.address, entries.address, count, masks.address];
        bench.call("cull_spheres_p64", &arguments);
        let masks: Vec<[U32; 4]> = bench.read_all(masks);
        group.check("cull_spheres_p64", |sphere| {
            let [mask, others @ ..] = masks[sphere];
            assert_eq!(others, [mask; 3], "the same middles");
            mask.get()
        })
    });
    assert_both("cull_spheres_p64", results);
}

/// The planes around the tile of a pixel, at the outer edges of its pixels. Normals point inwards.
fn frustum(camera: &Camera, left: u32, top: u32) -> Frustum {
    let direction = |x: f64, y: f64| camera.corner + x * camera.right + y * camera.down;
    let (left, top) = (
        f64::from(left / TILE_WIDTH * TILE_WIDTH) - 0.5,
        f64::from(top / TILE_HEIGHT * TILE_HEIGHT) - 0.5,
    );
    let (right, bottom) = (left + f64::from(TILE_WIDTH), top + f64::from(TILE_HEIGHT));
    let middle = direction((left + right) / 2.0, (top + bottom) / 2.0);
    let normals = [
        direction(left, 0.0).cross(camera.down),
        direction(right, 0.0).cross(camera.down),
        direction(0.0, top).cross(camera.right),
        direction(0.0, bottom).cross(camera.right),
    ]
    .map(|normal| nearest(normal.normalize() * normal.dot(middle).signum()).map(single));
    let [normal_x, normal_y, normal_z] = [0, 1, 2].map(|axis| normals.map(|normal| normal[axis]));
    Frustum { normal_x, normal_y, normal_z }
}

#[test]
fn no_sphere_that_a_ray_of_a_tile_enters_is_outside_of_its_frustum() {
    let mut random = random();
    let mut bench = Bench::new();
    let results = (0..4 * CAMERAS).map(|_| {
        let group = Group::any(&mut bench, &mut random);
        bench.reset();
        let planes = frustum(&group.camera, group.left, group.top);
        let planes = put(&mut bench, &[planes]);
        let spheres = put(&mut bench, &group.records);
        let buffer = list_buffer(&mut bench, SPHERES);
        let count = SPHERES as u32;
        let arguments = [planes.address, spheres.address, count, buffer.address];
        let end = bench.call("frustum_spheres", &arguments).value;
        let listed: Vec<u32> =
            bench.read_list(buffer, end).iter().map(|entry: &Pair| entry.object.get()).collect();
        group.check("frustum_spheres", |sphere| {
            let is_listed = listed.contains(&address::<Sphere>(spheres, sphere));
            if is_listed { 0xffff } else { 0 }
        })
    });
    assert_both("frustum_spheres", results);
}
