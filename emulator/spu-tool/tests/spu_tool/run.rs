use super::support::Bench;

#[test]
fn printf_as_newlib_calls_it() {
    let bench = Bench::new();
    let text = "hello, moon: -42, 3.142, 123456789012345!\n";
    let outcome = bench.run(&[], &bench.program("hello"), text.len() as i32);
    assert_eq!((outcome.output.as_str(), outcome.error.as_str()), (text, ""));
}

#[test]
fn files_by_streams_and_descriptors() {
    let bench = Bench::new();
    let outcome = bench.run(&[], &bench.program("files"), libc::ENOENT);
    assert_eq!(outcome.output, "through a file\n");
    assert_eq!(bench.read("written.txt"), "through a file\n");
}

/// The interface of GCC's `-pg` for the SPU, and of newlib's run time for it.
#[test]
fn a_program_that_profiles_itself() {
    const TICKS_PER_SECOND: &str = "79800000";
    for options in [&[][..], &["--timing=figures"]] {
        let bench = Bench::new();
        let outcome = bench.run(options, &bench.program("profiled"), 0);
        let numbers: Vec<&str> = outcome.output.split_whitespace().collect();
        assert_eq!(numbers[0], TICKS_PER_SECOND);
        let [process, calls] = [1, 2].map(|n: usize| numbers[n].parse::<u32>().unwrap());
        assert!(process > 0 && calls > 0, "{}", outcome.output);
        let file = std::fs::read(bench.path("gmon.out")).unwrap();
        let samples = file.chunks(2).map(|count| u32::from(count[0]) << 8 | u32::from(count[1]));
        assert_eq!(file.len(), 0x1000);
        assert!(samples.sum::<u32>() >= 5);
    }
}

#[test]
fn scanf_from_standard_input() {
    let bench = Bench::new();
    let program = bench.program("sum");
    let arguments = ["run".as_ref(), program.as_os_str()];
    let outcome = bench.spu_with_input(&arguments, " 40\n-2 ");
    assert_eq!((outcome.status, outcome.output.as_str()), (2, "38\n"));
}

#[test]
fn arguments_for_a_standard_main() {
    let bench = Bench::new();
    let program = bench.program("arguments");
    let mut arguments = vec!["run", "--start", "elfspe", program.to_str().unwrap()];
    arguments.extend(["--one", "two words", ""]);
    let outcome = bench.spu(&arguments);
    let expected = format!("{}\n--one\ntwo words\n\n", program.display());
    assert_eq!((outcome.status, outcome.output), (4, expected));
    let long = "x".repeat(20_000);
    arguments.push(&long);
    let outcome = bench.spu(&arguments);
    assert_eq!(outcome.status, 127);
    assert!(outcome.error.contains("don't fit into local store"), "{}", outcome.error);
}

#[test]
fn the_exit_status_is_the_programs() {
    let bench = Bench::new();
    for code in [0, 1, 77, 119, 255] {
        let program = bench.instructions(&format!(" stop 0x2000+{code}"));
        assert_eq!(bench.run(&[], &program, code).error, "");
    }
}

#[test]
fn registers_at_the_entry() {
    let bench = Bench::new();
    let program = bench.instructions(" stop 0x2000");
    let registers = |options: &[&str]| {
        let options = [options, &["--dump-regs=regs"]].concat();
        bench.run(&options, &program, 0);
        let text = bench.read("regs");
        let lines = text.lines().map(str::to_owned);
        lines.collect::<Vec<_>>()
    };
    let plain = registers(&[]);
    assert_eq!(plain.len(), 129);
    assert_eq!(plain[0], "pc    0x00004");
    assert_eq!(plain[2], "$1    0003fff0 00000000 00000000 00000000");
    assert_eq!(plain[4], "$3    00000000 00000001 00000000 00000000");
    assert_eq!(plain[5], "$4    00000000 18000000 00000000 00000000");
    assert_eq!(plain[7], "$6    00000000 40000000 00000000 00000000");
    let own = registers(&["--arg", "7", "--arg", "0x123456789:64", "--arg", "0xffffffff"]);
    assert_eq!(own[4], "$3    00000007 00000000 00000000 00000000");
    assert_eq!(own[5], "$4    00000001 23456789 00000000 00000000");
    assert_eq!(own[6], "$5    ffffffff 00000000 00000000 00000000");
}

/// The exit status is the number of paths that the program could open.
#[test]
fn a_program_opens_only_what_it_was_given() {
    let bench = Bench::new();
    let root = bench.path("root");
    std::fs::create_dir(&root).unwrap();
    std::fs::write(root.join("given"), "").unwrap();
    let secret = bench.write("secret", "");
    std::os::unix::fs::symlink(&secret, root.join("absolute")).unwrap();
    std::os::unix::fs::symlink("../secret", root.join("relative")).unwrap();
    let secret = secret.to_str().unwrap();
    let paths = ["/given", "given", secret, "../secret", "/absolute", "/relative"];
    let mut source = "
        .include \"runtime.inc\"
        library mknod, 0x2101, 36
        .type   main,@function
main:   enter
        il      $80,0
        # Nor may it make a device, with which it could read a disk.
        ila     $3,device
        ila     $4,0x2180
        il      $5,0x103
        brsl    $lr,mknod
        cgti    $3,$3,-1
        sf      $80,$3,$80
"
    .to_owned();
    let mut texts = String::new();
    for (n, path) in paths.iter().enumerate() {
        source += &format!(
            "
        ila     $3,path{n}
        il      $4,0
        il      $5,0
        brsl    $lr,open
        cgti    $3,$3,-1
        sf      $80,$3,$80
"
        );
        texts += &format!("path{n}: .asciz \"{path}\"\n");
    }
    source += &format!(
        "        ori     $3,$80,0\n        leave\n        .data\n{texts}device: .asciz \"null\"\n"
    );
    let program = bench.assemble("opens", &source);
    bench.run(&["--root", "root", "--dump-ls", "outside"], &program, 2);
    assert!(bench.path("outside").exists());
    let outcome = bench.run(&["--root", "nowhere"], &program, 127);
    assert!(outcome.error.contains("--root nowhere"), "{}", outcome.error);
}

#[test]
fn mailboxes_are_files() {
    let bench = Bench::new();
    let program = bench.program("mailboxes");
    bench.write("in", "1 2 3 # few\n0x10 0x7fffffff\n100\n0\n");
    let options = ["--in-mbox", "in", "--out-mbox", "out", "--out-intr-mbox", "intr"];
    bench.run(&options, &program, 0);
    let doubled = [2, 4, 6, 0x20, 0xffff_fffe_u32, 200].map(|word| format!("{word:#010x}\n"));
    assert_eq!(bench.read("out"), doubled.concat());
    assert_eq!(bench.read("intr"), "0x00000006\n");
}

#[test]
fn main_memory_is_loaded_changed_and_written() {
    let bench = Bench::new();
    let program = bench.program("dma");
    let words =
        |add: u32| -> Vec<u8> { (0..32_u32).flat_map(|n| (n + add).to_be_bytes()).collect() };
    bench.write("in", words(0));
    let options = [
        "--main-memory",
        "4K@0x600000000",
        "--load-mem",
        "in@0x600000080",
        "--arg",
        "0x600000080:64",
        "--arg",
        "1000",
        "--dump-mem",
        "out@0x600000100:128",
        "--dump-ls",
        "ls",
    ];
    bench.run(&options, &program, 0);
    assert_eq!(std::fs::read(bench.path("out")).unwrap(), words(1000));
    let store = std::fs::read(bench.path("ls")).unwrap();
    assert_eq!(store.len(), 256 * 1024);
    assert!(store.windows(128).any(|window| window == words(1000)));
}

#[test]
fn files_go_into_local_store_before_the_start() {
    let bench = Bench::new();
    let program = bench.instructions(" lqa $3,0x100\n stqa $3,0x3ff00\n stop 0x2000");
    bench.write("data", "sixteen bytes ok");
    bench.run(&["--load-ls", "data@0x100", "--dump-ls", "ls"], &program, 0);
    let store = std::fs::read(bench.path("ls")).unwrap();
    assert_eq!(&store[0x3ff00..0x3ff10], b"sixteen bytes ok");
}

#[test]
fn memory_in_effective_address_space_can_be_transferred() {
    let bench = Bench::new();
    let source = "
        ila     $sp,0x3ffd0
        il      $3,0
        lqr     $4,size
        stqd    $4,32($sp)
        br      call
        .align  4
size:   .long   0, 4096, 0, 0
call:   ila     $3,0x3fff0
        lqr     $4,block
        stqd    $4,0($3)
        stop    0x2105
        .long   0x0303fff0
        lqd     $5,0($3)
        ila     $6,0x8000
        wrch    $ch16,$6
        wrch    $ch17,$5
        rotqbyi $7,$5,4
        wrch    $ch18,$7
        il      $7,128
        wrch    $ch19,$7
        wrch    $ch20,$8
        il      $7,0x20
        wrch    $ch21,$7
        stop    0x2000
        .align  4
block:  .long   0, 4096, 0, 0";
    bench.run(&[], &bench.instructions(source), 0);
}

#[test]
fn help_names_every_status() {
    let bench = Bench::new();
    let outcome = bench.spu(&["run", "--help"]);
    assert_eq!(outcome.status, 0);
    for status in 120..=127 {
        assert!(outcome.output.contains(&format!("  {status}    ")), "{status}");
    }
    for option in ["--max-instructions", "--main-memory", "--in-mbox", "Examples:"] {
        assert!(outcome.output.contains(option), "{option}");
    }
}
