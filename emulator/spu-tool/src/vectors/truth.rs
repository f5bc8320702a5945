//! Where the figures of a vector come from. `docs/emulator.md` and `docs/timing.md` of the
//! repository have the reasons.

use spu_emulator::float::estimate;
use spu_emulator::float::single::to_f64;
use spu_emulator::interp::Quad;
use spu_isa::{Class, Instruction, Machine, Op, Target, feature};

use super::{State, Truth};

const EXPONENT: u32 = 0x7f80_0000;
const FRACTION: u32 = 0x007f_ffff;
const SIGN: u32 = 0x8000_0000;

/// The source of the state after the instruction, from the state before it.
pub fn of_result(i: Instruction, state: &State) -> Truth {
    let [a, b, c] = [i.ra, i.rb, i.rc].map(|n| state.register(n).unwrap_or(Quad::ZERO).0);
    let denormal = |word: u32| word & EXPONENT == 0 && word & FRACTION != 0;
    let certain = |is_certain, otherwise| if is_certain { Truth::Architecture } else { otherwise };
    let both = feature::DISABLE | feature::ENABLE;
    match i.op {
        Op::Bi | Op::Bisl | Op::Iret | Op::Bisled | Op::Biz | Op::Binz | Op::Bihz | Op::Bihnz => {
            certain(i.immediate & both != both, Truth::Open)
        }
        Op::Frest | Op::Frsqest => Truth::Fair,
        Op::Fi => match b == a.map(estimate::frest) || b == a.map(estimate::frsqest) {
            // Its flags are not certain.
            true => Truth::Fair,
            false => Truth::Open,
        },
        Op::Fesd => {
            let open = |word: u32| denormal(word) && word & SIGN != 0;
            certain(!open(a[0]) && !open(a[2]), Truth::Open)
        }
        Op::Frds => {
            let doubles = Quad(a).doublewords();
            let denormal = |double: u64| {
                let magnitude = double & !(1 << 63);
                (1..1 << 52).contains(&magnitude)
            };
            certain(!doubles.into_iter().any(denormal), Truth::Fair)
        }
        Op::Cflts | Op::Cfltu => certain(!a.into_iter().any(denormal), Truth::Fair),
        Op::Fa | Op::Fs | Op::Fma | Op::Fms | Op::Fnms => {
            let cancels = |n: usize| {
                let [a, b, c] = [a[n], b[n], c[n]].map(to_f64);
                let (left, right) = match i.op {
                    Op::Fa => (a, b),
                    Op::Fs => (a, -b),
                    Op::Fma => (a * b, c),
                    _ => (a * b, -c),
                };
                distant_of_unlike_sign(left, right)
            };
            certain(!(0..4).any(cancels), Truth::Fair)
        }
        _ => Truth::Architecture,
    }
}

/// Whether the smaller term only decides how the larger one is truncated.
fn distant_of_unlike_sign(left: f64, right: f64) -> bool {
    let (small, large) = (left.abs().min(right.abs()), left.abs().max(right.abs()));
    let unlike = left.is_sign_negative() != right.is_sign_negative();
    unlike && small != 0.0 && small < large * f64::from(f32::EPSILON)
}

/// The source of the cycles.
pub fn of_cycles(i: Instruction, taken: bool) -> Truth {
    let row = i.op.row();
    match row.class {
        _ if row.machine == Machine::DoubleExtension => Truth::Fair,
        Class::Br if taken => Truth::Console,
        Class::Br if matches!(i.op, Op::Sync | Op::Dsync | Op::Stop | Op::Stopd) => Truth::Open,
        Class::Br if row.target == Target::Rt => Truth::Fair,
        Class::Spr => Truth::Fair,
        _ if i.op == Op::Orx => Truth::Open,
        _ => Truth::Architecture,
    }
}
