//! The crate `spu-assembler` makes the bytes of the SPU binutils of every kernel's schedule.

#[path = "../../../../emulator/assembler/tests/assembler/binutils.rs"]
mod binutils;

use std::fs;
use std::path::Path;

use binutils::Bench;
use kernels::workshop::Workshop;
use protocol::assembler;

#[test]
fn schedules_are_assembled_to_the_same_bytes() {
    let workshop = Workshop::here().unwrap_or_else(|error| panic!("{error}"));
    let bench = Bench::new();
    fs::write(bench.path(assembler::FILE), assembler::constants()).expect("a file");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = ["spu/include", "lab/spu/include"].map(|folder| root.join(folder));
    let includes = [&folders[..], &[bench.folder.path().to_path_buf()]].concat();
    let sources = workshop.sources().expect("kernels");
    for kernel in &sources {
        let text = workshop.schedule(kernel).expect("a schedule").text;
        let file = bench.path("schedule.s");
        fs::write(&file, text).expect("a file");
        bench.compare(kernel.name, &bench.expand(&file, &includes));
    }
    println!("{} schedules, none different", sources.len());
}
