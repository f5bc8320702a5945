//! Random programs: straight-line code, drivers and loops, plain against scheduled.
//!
//! Provenance: `model`. The interpreter defines what the plain source does.

use std::fmt::Write as _;

use super::support::{DATA, Input, Workshop, compare};
use randomness::Random;

const FUNCTIONS: usize = 40;
/// The pointers: $3 to $5 to separate areas, $6 to that of $3, $7 to a list of records.
const POINTERS: [(&str, u8, u32); 5] = [
    ("p", 3, DATA + 0x1000),
    ("q", 4, DATA + 0x5000),
    ("r", 5, DATA + 0x9000),
    ("p_again", 6, DATA + 0x1020),
    ("list", 7, DATA + 0xd000),
];
const RECORDS: u32 = DATA + 0x1_1000;
const STACK: u32 = DATA + 0x1_f000;
/// The values in $10 and up that operations read and write. They are set before the function.
const VALUES: u8 = 12;
const FIRST_VALUE: u8 = 10;
const COUNT: u8 = 8;
const INDEX: u8 = 9;

const BINARY: [&str; 14] = [
    "a", "sf", "and", "xor", "cgt", "fa", "fs", "fm", "fcgt", "mpy", "fi", "rot", "absdb", "shlqby",
];
const UNARY: [&str; 5] = ["clz", "frest", "frsqest", "xsbh", "fsm"];
const TERNARY: [&str; 6] = ["fma", "fnms", "fms", "selb", "shufb", "mpya"];

fn value(random: &mut Random) -> String {
    format!("$v+{}", random.below(u64::from(VALUES)))
}

fn pick<'a>(random: &mut Random, from: &[&'a str]) -> &'a str {
    from[random.below(from.len() as u64) as usize]
}

/// The properties of a random function.
struct Shape {
    in_loop: bool,
    /// Every store is marked, and two pointers point to one area.
    aliases: bool,
    records: bool,
    doubles: bool,
}

/// One instruction of a body.
fn operation(random: &mut Random, shape: &Shape) -> String {
    let to = value(random);
    let (a, b, c) = (value(random), value(random), value(random));
    let offset = 16 * random.below(6);
    let pointer = match random.below(if shape.aliases { 4 } else { 3 }) {
        3 => "p_again",
        number => ["p", "q", "r"][number as usize],
    };
    let mark = if shape.aliases { " # may alias" } else { "" };
    match random.below(24) {
        0..=4 => format!("{} {to},{a},{b}", pick(random, &BINARY)),
        5 | 6 => format!("{} {to},{a}", pick(random, &UNARY)),
        7..=10 => format!("{} {to},{a},{b},{c}", pick(random, &TERNARY)),
        11 => format!("ai {to},{a},{}", random.below(200) as i64 - 100),
        12 => format!("rotqbyi {to},{a},{}", random.below(16)),
        13 => format!("csflt {to},{a},{}", random.below(20)),
        14 => format!("il {to},{}", random.below(1000)),
        15 if shape.records => format!("lqd {to},{}($record)", offset & 63),
        16 if shape.records => format!("stqd {to},{}($record)", offset & 63),
        15..=18 => format!("lqd {to},{offset}(${pointer})"),
        19 | 20 => format!("stqd {a},{offset}(${pointer}){mark}"),
        21 => format!("lqx {to},${pointer},$index"),
        22 => format!("stqx {a},${pointer},$index{mark}"),
        _ if shape.doubles => format!("dfa {to},{a},{b}"),
        _ if shape.in_loop => format!("ai ${pointer},${pointer},{}", 16 * random.below(4)),
        _ => match random.below(5) {
            0 => format!("iohl {to},{}", random.below(65536)),
            1 => format!("addx {to},{a},{b}"),
            2 => format!("mpyhha {to},{a},{b}"),
            3 => format!("wrch $ch28,{a}"),
            _ => format!("ai ${pointer},${pointer},16"),
        },
    }
}

fn header(random: &mut Random, source: &mut String, name: &str) -> Vec<u8> {
    let everything = random.below(4) == 0;
    let mut live: Vec<u8> = (FIRST_VALUE..FIRST_VALUE + VALUES).collect();
    if !everything {
        live.retain(|_| random.below(4) == 0);
    }
    let names: Vec<_> = live.iter().map(|register| format!("${register}")).collect();
    let _ = write!(source, "\n#   Out     {}\nfunction {name}\n", names.join(" "));
    live
}

/// The start of a source: the header and the names of its registers.
fn start() -> String {
    let mut source = String::from("# Random functions.\n        .include \"kernel.inc\"\n");
    for (name, number, _) in POINTERS {
        let _ = writeln!(source, "        .set {name},{number}");
    }
    let _ = writeln!(
        source,
        "        .set count,{COUNT}\n        .set index,{INDEX}\n        .set v,{FIRST_VALUE}\n        .set record,30"
    );
    source
}

fn lines(source: &mut String, body: &[String]) {
    for line in body {
        let _ = writeln!(source, "        {line}");
    }
}

fn straight(random: &mut Random, source: &mut String, name: &str) -> Vec<u8> {
    let live = header(random, source, name);
    let shape = Shape {
        in_loop: false,
        aliases: random.below(3) == 0,
        records: false,
        doubles: random.below(4) == 0,
    };
    for part in 0..=random.below(3) {
        let body: Vec<_> = (0..random.below(50)).map(|_| operation(random, &shape)).collect();
        lines(source, &body);
        let tested = value(random);
        match random.below(3) {
            0 => {
                let _ = writeln!(source, "        brz {tested},{name}_{part}");
                let body: Vec<_> =
                    (0..random.below(10)).map(|_| operation(random, &shape)).collect();
                lines(source, &body);
                let _ = writeln!(source, "{name}_{part}:");
            }
            1 => {
                let _ = writeln!(source, "        biz {tested},$lr");
            }
            _ => {}
        }
    }
    let _ = writeln!(source, "        bi $lr\nendfunction {name}");
    live
}

fn counted(random: &mut Random, source: &mut String, name: &str) -> Vec<u8> {
    let live = header(random, source, name);
    let shape = Shape {
        in_loop: true,
        aliases: random.below(4) == 0,
        records: random.below(3) == 0,
        doubles: random.below(8) == 0,
    };
    let before: Vec<_> = (0..random.below(10)).map(|_| operation(random, &shape)).collect();
    // The longest are beyond the reach of a hint before them.
    let longest = [25, 25, 25, 25, 25, 25, 90, 90, 330][random.below(9) as usize];
    let length = 2 + random.below(longest);
    let mut body: Vec<_> = (0..length).map(|_| operation(random, &shape)).collect();
    let mut insert = |random: &mut Random, line: &str| {
        let at = random.below(body.len() as u64) as usize;
        body.insert(at, line.to_owned());
    };
    if random.below(2) == 0 {
        insert(random, "ai $index,$index,16");
    }
    insert(random, "ai $count,$count,-1");
    if random.below(3) == 0 {
        insert(random, "a $v+3,$v+3,$count");
    }
    if shape.records {
        // A pass starts with its record, and may access another one.
        body.insert(0, "lqd $record,0($list)".into());
        body.insert(1, "ai $list,$list,16".into());
    }
    let after: Vec<_> = (0..random.below(12)).map(|_| operation(random, &shape)).collect();
    lines(source, &["lqd $record,0($list)".to_owned()]);
    lines(source, &before);
    let _ = writeln!(source, "{name}_pass:");
    lines(source, &body);
    let _ = writeln!(source, "        brnz $count,{name}_pass");
    lines(source, &after);
    let _ = writeln!(source, "        bi $lr\nendfunction {name}");
    live
}

/// A loop with long chains and few instructions, so that many passes overlap.
fn stream(random: &mut Random, source: &mut String, name: &str) -> Vec<u8> {
    let live = header(random, source, name);
    let mut body = vec!["ai $count,$count,-1".to_owned()];
    let step = 16 * (1 + random.below(3));
    for row in 0..1 + random.below(3) {
        body.push(format!("lqd $record,{}($p)", 16 * row));
        let first = body.len();
        for _ in 0..2 + random.below(9) {
            let constant = value(random);
            body.push(match random.below(5) {
                0 => format!("fma $record,$record,{constant},$record"),
                1 => format!("a $record,$record,{constant}"),
                2 => "rotqbyi $record,$record,5".into(),
                3 => format!("mpy $record,$record,{constant}"),
                _ => format!("fnms $record,{constant},$record,{constant}"),
            });
        }
        if random.below(3) == 0 {
            let sum = value(random);
            body.push(format!("xor {sum},{sum},$record"));
        }
        if random.below(2) == 0 {
            // The loaded value is needed once more at the end.
            body.insert(first, "ori $count+22,$record,0".into());
            body.push("xor $record,$record,$count+22".into());
        }
        let to = pick(random, &["p", "q"]);
        body.push(format!("stqd $record,{}(${to})", 16 * row));
    }
    body.push(format!("ai $p,$p,{step}"));
    body.push(format!("ai $q,$q,{}", step));
    let _ = writeln!(source, "{name}_pass:");
    lines(source, &body);
    let _ = writeln!(source, "        brnz $count,{name}_pass");
    lines(source, &["stqd $p,0($r)".to_owned(), "bi $lr".to_owned()]);
    let _ = writeln!(source, "endfunction {name}");
    live
}

/// A function that calls `leaf`, with pointers that overlap, the stack, objects with names, and
/// hints.
fn driver(random: &mut Random, source: &mut String, name: &str) {
    let shape = Shape { in_loop: false, aliases: true, records: false, doubles: false };
    let _ = writeln!(source, "\nfunction {name}\n        stqd $lr,16($sp)\n        ai $sp,$sp,-64");
    for part in 0..=random.below(3) {
        let (call, skipped) = (format!("{name}_call_{part}"), format!("{name}_skip_{part}"));
        let mut body: Vec<String> = (0..random.below(40))
            .map(|_| match random.below(8) {
                0 => format!("lqd {},{}($sp)", value(random), 16 * random.below(4)),
                1 => format!("stqd {},{}($sp)", value(random), 16 * random.below(4)),
                2 => format!("lqa {},object_{}", value(random), random.below(2)),
                3 => format!("stqa {},object_{}", value(random), random.below(2)),
                4 => "nop $2".to_owned(),
                _ => operation(random, &shape).replace(" # may alias", ""),
            })
            .collect();
        let hint = random.below(1 + body.len() as u64) as usize;
        body.insert(hint, format!("hbrr {call},leaf"));
        lines(source, &body);
        let _ = writeln!(source, "        brz {},{skipped}", value(random));
        let _ = writeln!(source, "{call}: brsl $lr,leaf\n{skipped}:");
    }
    let end = "hbr {name}_end,$lr\n        ai $sp,$sp,64\n{name}_end: bi $lr\nendfunction {name}\n";
    let _ = write!(source, "        lqd $lr,80($sp)\n        {}", end.replace("{name}", name));
}

fn word(random: &mut Random) -> u32 {
    match random.below(6) {
        0 => 0,
        1 => random.below(16) as u32,
        // Single-precision values near 1.
        2..=4 => 0x3f00_0000 + random.below(0x0180_0000) as u32,
        _ => random.bits() as u32,
    }
}

fn input(random: &mut Random, count: u32) -> Input {
    let mut input = Input::default();
    let quadword = |random: &mut Random| [0; 4].map(|_: u32| word(random));
    for register in FIRST_VALUE..FIRST_VALUE + VALUES {
        let value = quadword(random);
        input.registers.push((register, value));
    }
    for (_, register, address) in POINTERS {
        input.registers.push((register, [address; 4]));
    }
    input.registers.push((COUNT, [count; 4]));
    input.registers.push((INDEX, [16 * random.below(8) as u32; 4]));
    for address in (DATA..DATA + 0x1_4000).step_by(16) {
        let value = quadword(random);
        input.memory.push((address, value));
    }
    // Few records, so that passes access the same one.
    for place in 0..64 {
        let record = RECORDS + 64 * random.below(4) as u32;
        input.memory.push((POINTERS[4].2 + 16 * place, [record; 4]));
    }
    input
}

#[test]
fn random_straight_code_does_the_same() {
    let mut random = Random::new("straight code");
    for round in 0..3 {
        let mut source = start();
        let names: Vec<String> = (0..FUNCTIONS).map(|at| format!("f{at}")).collect();
        let live: Vec<_> =
            names.iter().map(|name| straight(&mut random, &mut source, name)).collect();
        let shop = Workshop::new(&source);
        shop.schedule();
        let plain = shop.link("plain.s", &names);
        let scheduled = shop.link("scheduled.s", &names);
        for (name, live) in names.iter().zip(&live) {
            for _ in 0..3 {
                let input = input(&mut random, 1);
                let what = format!("{name} of round {round}");
                let (one, other) = (plain.call(name, &input), scheduled.call(name, &input));
                compare(&one, &other, live, &what);
            }
        }
    }
}

#[test]
fn random_drivers_do_the_same() {
    let mut random = Random::new("drivers");
    for round in 0..3 {
        let mut source = start();
        source += "        .data\n        .align 4\nobject_0: .skip 16\nobject_1: .skip 16\n";
        source += "\nfunction leaf\n        a $v,$v+1,$v+2\n        ai $sp,$sp,-16\n";
        source +=
            "        stqd $v,0($sp)\n        ai $sp,$sp,16\n        bi $lr\nendfunction leaf\n";
        let names: Vec<String> = (0..FUNCTIONS).map(|at| format!("f{at}")).collect();
        names.iter().for_each(|name| driver(&mut random, &mut source, name));
        let shop = Workshop::new(&source);
        let lines = shop.schedule_driver();
        assert!(lines.windows(2).any(|pair| pair[0] > pair[1]), "nothing has moved");
        let plain = shop.link("plain.s", &names);
        let scheduled = shop.link("scheduled.s", &names);
        let live: Vec<u8> = (0..80).collect();
        for name in &names {
            for _ in 0..3 {
                let mut input = input(&mut random, 1);
                input.registers.push((1, [STACK; 4]));
                let what = format!("{name} of round {round}");
                compare(&plain.call(name, &input), &scheduled.call(name, &input), &live, &what);
            }
        }
    }
}

#[test]
fn random_loops_do_the_same_for_every_trip_count() {
    let mut random = Random::new("loops");
    let (mut pipelined, mut deep, mut several) = (0, 0, 0);
    for round in 0..2 {
        let mut source = start();
        let names: Vec<String> = (0..FUNCTIONS).map(|at| format!("f{at}")).collect();
        let live: Vec<_> = names
            .iter()
            .map(|name| match random.below(3) {
                0 => stream(&mut random, &mut source, name),
                _ => counted(&mut random, &mut source, name),
            })
            .collect();
        let shop = Workshop::new(&source);
        let messages = shop.schedule();
        pipelined += messages.matches("interval").count();
        let passes = messages.matches("passes ").count();
        several += passes - messages.matches("passes 1\n").count();
        let overlapping =
            |line: &&str| !["stages 1,", "stages 2,"].iter().any(|few| line.contains(few));
        deep += messages.lines().filter(|line| line.contains("stages")).filter(overlapping).count();
        let plain = shop.link("plain.s", &names);
        let scheduled = shop.link("scheduled.s", &names);
        for (name, live) in names.iter().zip(&live) {
            for count in [1, 2, 3, 4, 5, 6, 9, 17, 40] {
                let input = input(&mut random, count);
                let what = format!("{name} of round {round}, {count} passes");
                let (one, other) = (plain.call(name, &input), scheduled.call(name, &input));
                compare(&one, &other, live, &what);
            }
        }
    }
    assert!(deep > FUNCTIONS / 4, "only {deep} loops overlap three passes");
    assert!(several > 2, "only {several} kernels contain several passes");
    assert!(pipelined > FUNCTIONS, "only {pipelined} loops were pipelined");
}
