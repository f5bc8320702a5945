//! `shade_depth_r16`.

use cellray::work::layout::{Colours, Depth, Packet};
use oracle::twin::isect_spheres::Hit;
use oracle::twin::shade_depth::{self, shade_depth};
use oracle::twin::{FARTHEST, Single};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use zerocopy::big_endian::F32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::harness::{self, Bench, bits, single};

const SOURCE: &str = include_str!("../../spu/shade/shade_depth_r16.s");

fn check(
    bench: &mut Bench,
    hits: &[Hit; 16],
    table: &[[Single; 3]],
    depth: shade_depth::Depth,
) -> [[Single; 3]; 16] {
    bench.reset();
    let mut packet = Packet::new_zeroed();
    for (lane, hit) in hits.iter().enumerate() {
        packet.t[lane] = single(hit.t);
        packet.object[lane] = hit.object.into();
    }
    let packet = bench.place(packet.as_bytes());
    let entries: Vec<[F32; 4]> = table
        .iter()
        .map(|[r, g, b]| [single(*r), single(*g), single(*b), single(0x7fff_ffff)])
        .collect();
    let entries = bench.place(entries.as_bytes());
    let record = Depth {
        far: [single(depth.far); 4],
        scale: [single(depth.scale); 4],
    };
    let record = bench.place(record.as_bytes());
    let colours = bench.junk::<Colours>();
    let arguments = [
        packet.address,
        entries.address,
        record.address,
        colours.address,
    ];
    bench.call("shade_depth_r16", &arguments);
    let colours: Colours = bench.read(colours);
    std::array::from_fn(|lane| {
        let found = [colours.red, colours.green, colours.blue].map(|channel| bits(channel[lane]));
        let expected = shade_depth(hits[lane], table, depth);
        assert_eq!(found, expected, "{:x?}, {depth:x?}", hits[lane]);
        found
    })
}

fn random_table(random: &mut ChaCha8Rng) -> Vec<[Single; 3]> {
    (0..20)
        .map(|_| std::array::from_fn(|_| from_f64(random.random_range(0.0..1.0))))
        .collect()
}

#[test]
fn equals_its_twin_and_keeps_its_error_bound() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        let table = random_table(&mut random);
        let near: f64 = random.random_range(0.0..50.0);
        let range: f64 = random.random_range(1.0..50.0);
        let far = near + range;
        let depth = shade_depth::Depth {
            far: from_f64(far),
            scale: from_f64(1.0 / range),
        };
        let hits = std::array::from_fn(|_| {
            let object = random.random_range(0..table.len() as u32);
            let t = from_f64(random.random_range(near * 0.9..far * 1.1));
            Hit {
                t: if object == 0 { FARTHEST } else { t },
                object,
            }
        });
        for (hit, found) in hits.iter().zip(check(&mut bench, &hits, &table, depth)) {
            let bright = match hit.object {
                0 => 1.0,
                _ => ((to_f64(depth.far) - to_f64(hit.t)) * to_f64(depth.scale)).clamp(0.0, 1.0),
            };
            for (found, colour) in found.iter().zip(table[hit.object as usize]) {
                worst =
                    worst.max((to_f64(*found) - to_f64(colour) * bright).abs() * 2_f64.powi(23));
            }
        }
    }
    harness::keeps_stated_error(SOURCE, worst);
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let table: Vec<[Single; 3]> = (0..20)
            .map(|_| std::array::from_fn(|_| random.random()))
            .collect();
        let depth = shade_depth::Depth {
            far: random.random(),
            scale: random.random(),
        };
        let hits = std::array::from_fn(|_| Hit {
            t: random.random(),
            object: random.random_range(0..20),
        });
        check(&mut bench, &hits, &table, depth);
    }
}
