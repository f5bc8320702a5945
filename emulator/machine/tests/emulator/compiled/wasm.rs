//! Runs the modules that the compiler emits for WebAssembly, on an interpreter of WebAssembly.

use super::units::{ITERATIONS, Outcome, Run, local_store_bytes};
use crate::prelude::*;
use spu_emulator::channel::NoChannels;
use spu_jit::wasm::{IMPORTS, Places, UNIT, field, module};
use spu_jit::{Exit, FloatMode, Trace};
use wasmi::{
    Caller, Engine, Func, Linker, Memory, MemoryType, Module, Nullable, Ref, RefType, Store, Table,
    TableType, TypedFunc,
};

// The program's memory.
const CONTEXT: u32 = 0x100;
const REGISTERS: u32 = 0x1000;
const RECIPROCAL: u32 = 0x2000;
const RECIPROCAL_ROOT: u32 = 0x2100;
const CODE: u32 = 0x3000;
const ENTRIES: u32 = 0x3800;
const TABLE: u32 = 0x4_0000;
const LOCAL_STORE: u32 = 0x8_0000;
const PAGES: u32 = (LOCAL_STORE + SIZE) / 0x1_0000;

/// The places of the program's functions in its table.
const LEAVE: u32 = 1;
const INTERPRET: u32 = 2;

/// The program's own SPU.
type Own = (Spu, LocalStore);

type Arguments = (u32, u32, u32, u32, u32);

/// A program with one unit.
pub struct Emitted {
    store: Store<Own>,
    memory: Memory,
    linker: Linker<Own>,
    unit: Option<TypedFunc<Arguments, u32>>,
    budget: u32,
}

fn words<const COUNT: usize>(bytes: &[u8]) -> [u32; COUNT] {
    std::array::from_fn(|n| u32::from_le_bytes(bytes[4 * n..4 * n + 4].try_into().unwrap()))
}

fn little(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// The function that a page's program has for instructions that are not compiled.
fn interpret(memory: &mut [u8], own: &mut Own, registers: u32, fpscr: u32, word: u32) {
    let i = Instruction::decode(word).unwrap();
    let (spu, local_store) = own;
    spu.set_pc(0);
    for &field in i.op.row().reads {
        let at = (registers + 16 * u32::from(i.register(field))) as usize;
        spu.set_register(i.register(field), Quad(words(&memory[at..])));
    }
    let fpscr = fpscr as usize..fpscr as usize + 16;
    spu.fpscr = Fpscr::from_words(words(&memory[fpscr.clone()]));
    local_store.write(0, &word.to_be_bytes());
    assert_eq!(spu.step(local_store, &mut NoChannels), None);
    memory[fpscr].copy_from_slice(&little(&spu.fpscr.words()));
    let at = (registers + 16 * u32::from(i.rt)) as usize;
    memory[at..at + 16].copy_from_slice(&little(&spu.register(i.rt).0));
}

impl Emitted {
    pub fn new() -> Self {
        let engine = Engine::default();
        let mut store = Store::new(&engine, Own::default());
        let memory = Memory::new(&mut store, MemoryType::new(PAGES, None)).unwrap();
        let leave = Func::wrap(
            &mut store,
            move |mut caller: Caller<'_, Own>, _: u32, _: u32, at: u32, budget: u32, pc: u32| {
                let memory = memory.data_mut(&mut caller);
                write(memory, at + field::PC, &pc.to_le_bytes());
                write(memory, at + field::BUDGET, &u64::from(budget).to_le_bytes());
                LEFT
            },
        );
        let run = Func::wrap(
            &mut store,
            move |mut caller: Caller<'_, Own>, registers: u32, fpscr: u32, word: u32| {
                let (memory, own) = memory.data_and_store_mut(&mut caller);
                interpret(memory, own, registers, fpscr, word);
            },
        );
        let nothing = Ref::Func(Nullable::Null);
        let table =
            Table::new(&mut store, TableType::new(RefType::Func, 3, None), nothing).unwrap();
        for (place, function) in [(LEAVE, leave), (INTERPRET, run)] {
            table.set(&mut store, place.into(), Ref::from(Nullable::from(function))).unwrap();
        }
        let mut linker = Linker::new(&engine);
        linker.define(IMPORTS, "memory", memory).unwrap();
        linker.define(IMPORTS, "table", table).unwrap();
        let bytes = memory.data_mut(&mut store);
        write(bytes, RECIPROCAL, &little(estimate::reciprocal_words()));
        write(bytes, RECIPROCAL_ROOT, &little(estimate::reciprocal_root_words()));
        write(bytes, TABLE, &little(&[LEAVE]).repeat(SIZE as usize / 4));
        write(bytes, CONTEXT + field::TABLE, &TABLE.to_le_bytes());
        write(bytes, CONTEXT + field::ENTRIES, &ENTRIES.to_le_bytes());
        Self { store, memory, linker, unit: None, budget: 0 }
    }

    /// Makes the trace's unit the one that runs.
    pub fn install(&mut self, trace: &Trace, mode: FloatMode) {
        let places = Places {
            reciprocal: RECIPROCAL,
            reciprocal_root: RECIPROCAL_ROOT,
            interpret: INTERPRET,
            code: CODE,
        };
        let code = module(trace, &mode, 0, places);
        let code = Module::new(self.linker.engine(), code).unwrap();
        let instance = self.linker.instantiate_and_start(&mut self.store, &code).unwrap();
        self.unit = Some(instance.get_typed_func(&self.store, UNIT).unwrap());
        self.budget = ITERATIONS * trace.steps().len() as u32;
        let words: Vec<_> = trace.code().flat_map(u32::to_be_bytes).collect();
        write(self.memory.data_mut(&mut self.store), CODE, &words);
    }
}

const LEFT: u32 = 0;

fn write(memory: &mut [u8], at: u32, bytes: &[u8]) {
    memory[at as usize..][..bytes.len()].copy_from_slice(bytes);
}

impl Run for Emitted {
    fn run(&mut self, spu: &Spu, local_store: &LocalStore) -> Outcome {
        let bytes = self.memory.data_mut(&mut self.store);
        let registers: Vec<_> = spu.registers.iter().flat_map(|quad| quad.0).collect();
        write(bytes, REGISTERS, &little(&registers));
        write(bytes, CONTEXT + field::FPSCR, &little(&spu.fpscr.words()));
        write(bytes, LOCAL_STORE, local_store_bytes(local_store));
        let arguments = (REGISTERS, LOCAL_STORE, CONTEXT, self.budget, spu.pc());
        let unit = self.unit.as_ref().unwrap();
        let status = unit.call(&mut self.store, arguments).unwrap();
        let bytes = self.memory.data(&self.store);
        let [pc, unit] = words(&bytes[(CONTEXT + field::PC) as usize..]);
        let [left, zero] = words(&bytes[(CONTEXT + field::BUDGET) as usize..]);
        assert_eq!(zero, 0, "the budget that is left");
        let quads = bytes[REGISTERS as usize..].chunks(16).map(|quad| Quad(words(quad)));
        let registers = quads.take(128).collect::<Vec<_>>().try_into().unwrap();
        let local_store = LocalStore::new();
        local_store.write(0, &bytes[LOCAL_STORE as usize..]);
        Outcome {
            registers,
            fpscr: words(&bytes[(CONTEXT + field::FPSCR) as usize..]),
            local_store,
            exit: Exit::of(status, unit),
            pc,
            executed: self.budget - left,
        }
    }
}
