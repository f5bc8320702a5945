//! Three kernels of a ray tracer: their results, and how close their loops come to the bound.
//!
//! Provenance: `model`. The sources in `tests/schedule-kernels` are the tracer's own from before
//! they were scheduled.

use std::fs;
use std::path::Path;

use super::support::{DATA, Input, Program, Workshop, compare};
use randomness::Random;

fn source(kernel: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/schedule-kernels");
    fs::read_to_string(folder.join(format!("{kernel}.s"))).unwrap()
}

/// The plain and the scheduled form of the kernel, and the messages about its loops.
fn forms(kernel: &str) -> (Program, Program, String) {
    let shop = Workshop::new(&source(kernel));
    let messages = shop.schedule();
    let names = [kernel.to_owned()];
    (shop.link("plain.s", &names), shop.link("scheduled.s", &names), messages)
}

/// A single between -4 and 4.
fn single(random: &mut Random) -> u32 {
    let eighths = random.below(65536) as f32 / 8192.0;
    (eighths - 4.0).to_bits()
}

fn singles(random: &mut Random, input: &mut Input, address: u32, count: u32) {
    for at in 0..count {
        let value = [0; 4].map(|_: u32| single(random));
        input.memory.push((address + 16 * at, value));
    }
}

/// The number after a word in the messages.
fn figure(messages: &str, name: &str) -> u64 {
    let after = messages.split(name).nth(1).unwrap_or_else(|| panic!("{messages}"));
    let digits: String = after.trim().chars().take_while(char::is_ascii_digit).collect();
    digits.parse().unwrap()
}

#[test]
fn spheres_are_met_every_95_cycles() {
    let (plain, scheduled, messages) = forms("isect_spheres_r16");
    assert_eq!(figure(&messages, "even "), 95, "{messages}");
    assert!(figure(&messages, "interval ") <= 99, "{messages}");
    let mut random = Random::new("spheres");
    for count in 0..24 {
        let mut input = Input::default();
        let (packet, spheres) = (DATA, DATA + 0x1000);
        singles(&mut random, &mut input, packet, 20);
        singles(&mut random, &mut input, spheres, 4 * 24);
        for (register, value) in [(3, packet), (4, spheres), (5, count), (6, 7)] {
            input.registers.push((register, [value; 4]));
        }
        let call = |program: &Program| program.call("isect_spheres_r16", &input);
        compare(&call(&plain), &call(&scheduled), &[], &format!("{count} spheres"));
    }
}

#[test]
fn the_model_runs_the_kernel_at_its_interval() {
    let shop = Workshop::new(&source("isect_spheres_r16"));
    let messages = shop.schedule();
    let timed = shop.spu(&["time", "scheduled.o"]);
    let listing = String::from_utf8(timed.stdout).unwrap();
    let interval = figure(&messages, "interval ");
    let expected = format!("{interval} cycles a pass");
    assert!(listing.contains(&expected), "{listing}");
}

#[test]
fn rays_are_set_up_alike() {
    let (plain, scheduled, _) = forms("ray_setup_r16");
    let mut random = Random::new("rays");
    for at in 0..20 {
        let mut input = Input::default();
        let (basis, packet) = (DATA, DATA + 0x1000);
        singles(&mut random, &mut input, basis, 9);
        for (register, value) in [(3, basis), (4, 4 * at), (5, 100 - at), (6, packet)] {
            input.registers.push((register, [value; 4]));
        }
        let call = |program: &Program| program.call("ray_setup_r16", &input);
        compare(&call(&plain), &call(&scheduled), &[], &format!("rays {at}"));
    }
}

#[test]
fn depths_are_shaded_alike() {
    let (plain, scheduled, _) = forms("shade_depth_r16");
    let mut random = Random::new("depths");
    for round in 0..20 {
        let mut input = Input::default();
        let (packet, table, depth, colours) = (DATA, DATA + 0x1000, DATA + 0x2000, DATA + 0x3000);
        singles(&mut random, &mut input, packet, 16);
        for row in 0..4 {
            let objects = [0; 4].map(|_: u32| random.below(16) as u32);
            input.memory.push((packet + 256 + 16 * row, objects));
        }
        singles(&mut random, &mut input, table, 16);
        singles(&mut random, &mut input, depth, 2);
        for (register, value) in [(3, packet), (4, table), (5, depth), (6, colours)] {
            input.registers.push((register, [value; 4]));
        }
        let call = |program: &Program| program.call("shade_depth_r16", &input);
        compare(&call(&plain), &call(&scheduled), &[], &format!("round {round}"));
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let text = |()| {
        let shop = Workshop::new(&source("isect_spheres_r16"));
        shop.schedule();
        fs::read_to_string(shop.path("scheduled.s")).unwrap()
    };
    let (one, other) = (text(()), text(()));
    assert_eq!(one, other);
    let header = "# Scheduled by spu schedule from plain.s\n";
    assert_eq!(one.matches(header).count(), 1);
    assert!(one.lines().all(|line| line.len() <= 100));
}
