//! `pack_r16`.

use cellray::work::layout::{Colours, PixelShifts};
use oracle::twin::Single;
use oracle::twin::pack::pack;
use rand::Rng as _;
use spu_emulator::float::single::{from_f64, to_f64};
use zerocopy::big_endian::U32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::harness::{self, Bench, single};

const SOURCE: &str = include_str!("../../spu/shade/pack_r16.s");
/// Four rows of a tile that is 24 pixels wide.
const PITCH: usize = 96;

fn check(bench: &mut Bench, pixels: &[[Single; 3]; 16], shifts: [u32; 3]) -> [u32; 16] {
    bench.reset();
    let mut colours = Colours::new_zeroed();
    for (lane, [red, green, blue]) in pixels.iter().enumerate() {
        colours.red[lane] = single(*red);
        colours.green[lane] = single(*green);
        colours.blue[lane] = single(*blue);
    }
    let colours = bench.place(colours.as_bytes());
    let [red, green, blue] = shifts.map(|shift| [U32::new(shift); 4]);
    let record = bench.place(PixelShifts { red, green, blue }.as_bytes());
    let rows = bench.junk::<[u8; 4 * PITCH]>();
    let before: [u8; 4 * PITCH] = bench.read(rows);
    bench.call(
        "pack_r16",
        &[colours.address, record.address, rows.address, PITCH as u32],
    );
    let after: [u8; 4 * PITCH] = bench.read(rows);
    for (offset, (before, after)) in before.iter().zip(&after).enumerate() {
        assert!(
            offset % PITCH < 16 || before == after,
            "a byte beside the pixels was written"
        );
    }
    std::array::from_fn(|lane| {
        let offset = lane / 4 * PITCH + lane % 4 * 4;
        let word = &after[offset..offset + 4];
        let found = u32::from_be_bytes([word[0], word[1], word[2], word[3]]);
        let expected = pack(pixels[lane], shifts);
        assert_eq!(found, expected, "{:x?}, shifts {shifts:?}", pixels[lane]);
        found
    })
}

#[test]
fn equals_its_twin_and_keeps_its_error_bound() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    let mut worst = 0.0_f64;
    for shifts in [[16, 8, 0], [8, 16, 24]] {
        for _ in 0..1000 {
            let pixels: [[Single; 3]; 16] = std::array::from_fn(|_| {
                std::array::from_fn(|_| from_f64(random.random_range(-0.25..1.25)))
            });
            for (colour, word) in pixels.iter().zip(check(&mut bench, &pixels, shifts)) {
                for (channel, shift) in colour.iter().zip(shifts) {
                    let exact = to_f64(*channel).clamp(0.0, 1.0) * 255.0;
                    worst = worst.max((f64::from(word >> shift & 255) - exact).abs());
                }
            }
        }
    }
    harness::keeps_stated_error(SOURCE, worst);
}

#[test]
fn every_byte_comes_back() {
    let mut bench = Bench::new();
    for byte in 0..=255_u32 {
        let colour = from_f64(f64::from(byte) / 255.0);
        let words = check(&mut bench, &[[colour; 3]; 16], [16, 8, 0]);
        assert!(
            words.iter().all(|word| *word == byte * 0x01_01_01),
            "{byte}: {:x}",
            words[0]
        );
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let pixels = std::array::from_fn(|_| std::array::from_fn(|_| random.random()));
        let shifts = std::array::from_fn(|_| random.random_range(0..25));
        check(&mut bench, &pixels, shifts);
    }
}
