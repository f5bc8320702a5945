//! `mesh_eye_bounds_r16`, `filter_triangles_r16` and `isect_mesh_rows_r4` compared with their
//! twins, and together with the test of every triangle with every ray.

use std::ops::Range;

use kernels::bench::{Bench, random};
use kernels::cases::whitted::isect;
use kernels::cases::whitted::mesh::call::{self, Rows};
use kernels::description::any_bits;
use kernels::vector::unit;
use protocol::layout::{MESH_FACES, MESH_RUN, RayPacket, Shear};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::mesh::mesh_bound;
use twins::mesh_pairs::MeshBlock;
use twins::mesh_rows::{MeshWindow, mesh_eye_bound, mesh_window};
use twins::primary_rays;
use twins::sphere_ray::Ray;
use twins::{FARTHEST, ZERO};
use zerocopy::IntoBytes as _;

use super::COUNTS;

/// The distance of an absent ray.
const ABSENT: u32 = 0xbf80_0000;

type Packet = [Ray; 16];
type Runs = Vec<(Range<usize>, usize)>;

fn junk_block(random: &mut ChaCha8Rng) -> MeshBlock {
    MeshBlock {
        number: random.random_range(0..1 << 24),
        both: random.random(),
        vertices: (0..40).map(|_| random.random()).collect(),
        faces: (0..MESH_FACES).map(|_| [(); 3].map(|()| random.random_range(0..40))).collect(),
    }
}

/// Random triangles around a point at the distance of one of the scales, and packets of rays
/// from the eye that go to points on them and on their edges, to their vertices, and beside them.
/// The rays of a packet are as far apart as the triangles are wide.
fn aimed(random: &mut ChaCha8Rng) -> (MeshBlock, Vec<Packet>) {
    let distance = libm::pow(10.0, random.random_range(-3.0..4.0));
    let width = distance * libm::pow(10.0, random.random_range(-4.5..0.2));
    let towards = unit([(); 3].map(|()| random.random_range(-1.0..1.0)));
    let near = |random: &mut ChaCha8Rng, width: f64| {
        towards.map(|axis| axis * distance + random.random_range(-width..width))
    };
    let corners: Vec<[f64; 3]> =
        (0..24).map(|_| near(random, width).map(|axis| to_f64(from_f64(axis)))).collect();
    let faces: Vec<[u8; 3]> =
        (0..28).map(|_| [(); 3].map(|()| random.random_range(0..24))).collect();
    let packets = (0..8)
        .map(|_| {
            std::array::from_fn(|_| {
                let face = faces[random.random_range(0..faces.len())];
                let weights = match random.random_range(0..4) {
                    0 => [1.0, 0.0, 0.0],
                    1 => {
                        let along = random.random_range(0.0..1.0);
                        [along, 1.0 - along, 0.0]
                    }
                    2 => {
                        let [u, v] = [(); 2].map(|()| random.random_range(0.0..0.5));
                        [u, v, 1.0 - u - v]
                    }
                    _ => {
                        let [u, v] = [(); 2].map(|()| random.random_range(-1.0..2.0));
                        [u, v, 1.0 - u - v]
                    }
                };
                let target = std::array::from_fn(|axis| {
                    (0..3)
                        .map(|corner| weights[corner] * corners[usize::from(face[corner])][axis])
                        .sum()
                });
                Ray {
                    origin: [ZERO; 3],
                    direction: unit(target).map(from_f64),
                    t: if random.random_ratio(1, 12) { ABSENT } else { FARTHEST },
                    object: 0,
                }
            })
        })
        .collect();
    let block = MeshBlock {
        number: random.random_range(0..1 << 24),
        both: random.random(),
        vertices: corners.iter().map(|corner| corner.map(from_f64)).collect(),
        faces,
    };
    (block, packets)
}

fn runs(count: usize, packets: usize, faces: usize, random: &mut ChaCha8Rng) -> Runs {
    let run = |_| {
        let first = random.random_range(0..faces);
        let length = random.random_range(1..=MESH_RUN as usize);
        (first..(first + length).min(faces), random.random_range(0..packets))
    };
    (0..count).map(run).collect()
}

/// The list that the filter's twin makes.
fn expected(windows: &[MeshWindow], block: &MeshBlock, runs: &Runs) -> Vec<Rows> {
    let pairs =
        runs.iter().flat_map(|(run, packet)| run.clone().map(|triangle| (triangle, *packet)));
    pairs
        .map(|(triangle, packet)| Rows {
            triangle,
            rows: windows[packet].may_hit(&block.triangle(triangle).vertices),
            packet,
        })
        .filter(|rows| rows.rows.contains(&true))
        .collect()
}

/// Checks the filter's list and counts.
fn check_filter(
    bench: &mut Bench,
    windows: &[MeshWindow],
    block: &MeshBlock,
    runs: &Runs,
    anything: u32,
) -> Vec<Rows> {
    let (found, rows, triangles) = call::filtered(bench, windows, block, runs, anything);
    let expected = expected(windows, block, runs);
    assert_eq!(found, expected, "{windows:x?} {block:x?} {runs:?}");
    let count: usize = expected.iter().flat_map(|of| of.rows).map(usize::from).sum();
    assert_eq!(rows as usize, count);
    let tested: usize = runs.iter().map(|(run, _)| run.len()).sum();
    assert_eq!(triangles as usize, tested);
    expected
}

/// Checks the packets after the rows' test, all their bytes.
fn check_rows(
    bench: &mut Bench,
    packets: &[Packet],
    block: &MeshBlock,
    rows: &[Rows],
    anything: u32,
) -> Vec<Packet> {
    let found = call::isect_rows(bench, packets, block, rows, anything);
    let mut expected = packets.to_vec();
    for of in rows {
        for (rays, is_in) in expected[of.packet].chunks_mut(4).zip(of.rows) {
            if is_in {
                block.isect_row(rays, of.triangle);
            }
        }
    }
    let records: Vec<RayPacket> =
        expected.iter().map(|rays| isect::call::packet(rays, anything)).collect();
    assert_eq!(found.as_bytes(), records.as_bytes(), "{rows:?} {block:x?}");
    expected
}

#[test]
fn bounds_and_windows_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut wide = 0;
    for at in 0..400 {
        let packets: Vec<Packet> = match at % 4 {
            0 => (0..at % 9).map(|_| any_bits(&mut random)).collect(),
            _ => aimed(&mut random).1[..at % 9].to_vec(),
        };
        let (bounds, windows) = call::eye_bounds(&mut bench, &packets, 0x3_0000);
        for (at, rays) in packets.iter().enumerate() {
            let shears = 0x3_0000 + (at * size_of::<Shear>()) as u32;
            let expected = call::bound_record(&mesh_eye_bound(rays), shears);
            assert_eq!(bounds[at].as_bytes(), expected.as_bytes(), "{rays:x?}");
            let expected = mesh_window(rays);
            wide += usize::from(expected.rows[0].low[0] == u32::MAX);
            let record = call::window_record(&expected);
            assert_eq!(windows[at].as_bytes(), record.as_bytes(), "{rays:x?}");
        }
    }
    assert!(wide > 100 && wide < 1000, "{wide}");
}

/// What `mesh_bounds_r16` makes of all rays of a packet from the eye, `mesh_eye_bounds_r16` makes.
#[test]
fn bounds_are_those_of_rays_from_anywhere() {
    let mut random = random();
    for _ in 0..400 {
        for rays in aimed(&mut random).1 {
            let there = rays.map(|ray| Ray { t: FARTHEST, ..ray });
            let from_anywhere = there.map(|ray| primary_rays::Ray {
                origin: ray.origin,
                direction: ray.direction,
                t: ray.t,
                object: 0,
                weight: ZERO,
                pixel: 0,
            });
            assert_eq!(mesh_eye_bound(&there), mesh_bound(&from_anywhere));
        }
    }
}

#[test]
fn the_filter_equals_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut tested, mut kept) = (0, 0);
    for _ in 0..20 {
        for count in COUNTS {
            let (block, packets) = aimed(&mut random);
            let windows: Vec<_> = packets.iter().map(mesh_window).collect();
            let runs = runs(count, packets.len(), block.faces.len(), &mut random);
            let rows = check_filter(&mut bench, &windows, &block, &runs, random.random());
            tested += runs.iter().map(|(run, _)| run.len()).sum::<usize>();
            kept += rows.len();
        }
    }
    assert!(kept > tested / 4 && kept < tested, "{kept} of {tested}");
}

#[test]
fn rows_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut rays, mut hits) = (0, 0);
    for _ in 0..20 {
        for count in COUNTS {
            let (block, packets) = aimed(&mut random);
            let rows: Vec<_> = (0..count)
                .map(|_| {
                    let bits = random.random_range(1..16);
                    Rows {
                        triangle: random.random_range(0..block.faces.len()),
                        rows: std::array::from_fn(|row| bits & 8 >> row != 0),
                        packet: random.random_range(0..packets.len()),
                    }
                })
                .collect();
            let after = check_rows(&mut bench, &packets, &block, &rows, random.random());
            rays += 16 * after.len();
            hits += after.iter().flatten().filter(|ray| ray.object != 0).count();
        }
    }
    assert!(hits > rays / 50, "{hits} of {rays}");
}

#[test]
fn any_bits_at_all_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..300 {
        let block = junk_block(&mut random);
        let packets: Vec<Packet> = (0..4).map(|_| any_bits(&mut random)).collect();
        let windows: Vec<_> = (0..4).map(|_| mesh_window(&aimed(&mut random).1[0])).collect();
        let runs = runs(7, packets.len(), block.faces.len(), &mut random);
        let rows = check_filter(&mut bench, &windows, &block, &runs, random.random());
        let from_the_eye: Vec<Packet> =
            packets.iter().map(|rays| rays.map(|ray| Ray { origin: [ZERO; 3], ..ray })).collect();
        check_rows(&mut bench, &from_the_eye, &block, &rows, random.random());
    }
}

/// The hits are those of `isect_mesh_pairs_r16`, whose watertightness therefore is these kernels',
/// too: no ray to an edge or a vertex is left out.
#[test]
fn all_three_find_the_hits_of_every_ray_with_every_triangle() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut rays, mut hits, mut tested, mut rows_tested) = (0, 0, 0, 0);
    for _ in 0..1500 {
        let (block, packets) = aimed(&mut random);
        let windows: Vec<_> = packets.iter().map(mesh_window).collect();
        let runs: Runs = (0..packets.len())
            .flat_map(|packet| {
                (0..block.faces.len()).step_by(7).map(move |first| (first..first + 7, packet))
            })
            .collect();
        let rows = check_filter(&mut bench, &windows, &block, &runs, 0);
        let found = check_rows(&mut bench, &packets, &block, &rows, 0);
        let mut every = packets.clone();
        for (run, packet) in &runs {
            for ray in &mut every[*packet] {
                *ray = block.isect_run(*ray, run.clone());
            }
        }
        assert_eq!(found, every, "{block:x?}");
        rays += 16 * every.len();
        hits += every.iter().flatten().filter(|ray| ray.object != 0).count();
        tested += 4 * packets.len() * block.faces.len();
        rows_tested += rows.iter().flat_map(|of| of.rows).map(usize::from).sum::<usize>();
    }
    assert!(hits > rays / 3, "{hits} of {rays}");
    assert!(rows_tested < tested * 19 / 20, "{rows_tested} of {tested}");
}
