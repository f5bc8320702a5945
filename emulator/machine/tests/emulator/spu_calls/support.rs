//! A guest program: local store with an argument block, and a library whose streams are captured.

use std::sync::Mutex;

use crate::prelude::*;
use spu_emulator::ppe_call::{Arena, CallError, Class, Errno, Host, Library, Process};

pub const HEAP_EA: u64 = 0x1_0000_0000;
pub const HEAP: usize = 1 << 20;

/// The addresses of the block of cells, of the word after the stop, and of texts.
const BLOCK: u32 = 0x1000;
const OPCODE_WORD: u32 = 0x800;
const TEXTS: u32 = 0x4000;
/// Number of registers that a variadic function saves.
const SAVED: usize = 72;

/// The bytes written to standard output and error, and the rest of standard input.
#[derive(Default)]
pub struct Console {
    pub input: Vec<u8>,
    pub output: Vec<u8>,
    pub error: Vec<u8>,
}

#[derive(Clone, Default)]
struct Captured(Arc<Mutex<Console>>);

impl Host for Captured {
    fn read(&self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        if descriptor != 0 {
            return Process.read(descriptor, into);
        }
        let input = &mut self.0.lock().unwrap().input;
        let n = into.len().min(input.len());
        into[..n].copy_from_slice(&input[..n]);
        input.drain(..n);
        Ok(n)
    }

    fn write(&self, descriptor: i32, from: &[u8]) -> Result<usize, Errno> {
        let mut console = self.0.lock().unwrap();
        match descriptor {
            1 => console.output.extend(from),
            2 => console.error.extend(from),
            _ => return Process.write(descriptor, from),
        }
        Ok(from.len())
    }

    fn is_terminal(&self, _: i32) -> bool {
        false
    }
}

/// A variadic argument.
#[derive(Clone, Debug)]
pub enum Value {
    Word(u32),
    Long(u64),
    Double(f64),
}

/// The result cell of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reply {
    pub value: i32,
    pub low: u32,
    pub errno: i32,
}

impl Reply {
    pub fn ok(value: i32) -> Self {
        Self { value, low: 0, errno: 0 }
    }

    pub fn failed(value: i32, errno: i32) -> Self {
        Self { value, low: 0, errno }
    }

    pub fn doubleword(self) -> u64 {
        u64::from(self.value as u32) << 32 | u64::from(self.low)
    }
}

pub struct GuestProgram {
    pub store: LocalStore,
    pub library: Library,
    captured: Captured,
    next_text: u32,
}

impl GuestProgram {
    pub fn new(input: &str) -> Self {
        let captured = Captured::default();
        captured.0.lock().unwrap().input = input.into();
        let memory = Arc::new(RegisteredMemory::new());
        let heap = Arena::new(&memory, HEAP_EA, HEAP).unwrap();
        Self {
            store: LocalStore::new(),
            library: Library::new(Box::new(captured.clone()), Box::new(heap)),
            captured,
            next_text: TEXTS,
        }
    }

    pub fn console<T>(&self, look: impl FnOnce(&Console) -> T) -> T {
        look(&self.captured.0.lock().unwrap())
    }

    /// Standard output after a flush.
    pub fn output(&mut self) -> String {
        self.library.flush().unwrap();
        self.console(|console| String::from_utf8(console.output.clone()).unwrap())
    }

    /// Writes bytes and a 0 to a free address, and returns the address.
    pub fn text(&mut self, text: impl AsRef<[u8]>) -> u32 {
        let address = self.next_text;
        let bytes = [text.as_ref(), &[0]].concat();
        self.store.write(address, &bytes);
        self.next_text += (bytes.len() as u32).next_multiple_of(16);
        assert!(self.next_text < SIZE);
        address
    }

    pub fn read_text(&self, address: u32) -> String {
        let mut bytes = vec![0; 4096];
        self.store.read(address, &mut bytes);
        let end = bytes.iter().position(|&byte| byte == 0).unwrap();
        String::from_utf8(bytes[..end].to_vec()).unwrap()
    }

    pub fn words<const N: usize>(&self, address: u32) -> [u32; N] {
        std::array::from_fn(|n| self.store.load_word(address + 4 * n as u32))
    }

    /// A call of the function with this name, which determines class and opcode.
    pub fn serve(&mut self, name: &str, cells: &[Value]) -> Reply {
        let functions = [0, 1, 5].into_iter().flat_map(|class| (1..=68).map(move |n| (class, n)));
        let known = |&(class, n): &(u8, u8)| Class::of(class).unwrap().function(n) == Some(name);
        let (class, opcode) = functions.into_iter().find(known).expect(name);
        self.serve_opcode(class, opcode, cells).unwrap()
    }

    pub fn serve_opcode(
        &mut self,
        class: u8,
        opcode: u8,
        cells: &[Value],
    ) -> Result<Reply, CallError> {
        for (n, cell) in (0..).zip(cells) {
            // The other words of a register must not matter.
            self.store.write(BLOCK + 16 * n, &[0xa5; 16]);
            self.put(BLOCK + 16 * n, cell);
        }
        let word = u32::from(opcode) << 24 | BLOCK;
        self.store.write(OPCODE_WORD, &word.to_be_bytes());
        // The lowest bit means that interrupts are enabled.
        self.library.serve(class, &self.store, OPCODE_WORD | 1)?;
        let [value, low, _, errno] = self.words(BLOCK);
        Ok(Reply { value: value as i32, low, errno: errno as i32 })
    }

    fn put(&self, address: u32, value: &Value) {
        match value {
            Value::Word(word) => self.store.write(address, &word.to_be_bytes()),
            Value::Long(value) => self.store.write(address, &value.to_be_bytes()),
            Value::Double(value) => self.store.write(address, &value.to_be_bytes()),
        }
    }

    /// A call with words as arguments.
    pub fn call(&mut self, name: &str, arguments: &[u32]) -> Reply {
        let cells: Vec<Value> = arguments.iter().map(|&word| Value::Word(word)).collect();
        self.serve(name, &cells)
    }

    /// A call with a variadic list, laid out as newlib's functions do it: the fixed arguments, the
    /// list, the saved registers, and the remaining arguments beyond the caller's frame header.
    pub fn variadic(&mut self, name: &str, fixed: &[u32], arguments: &[Value]) -> Reply {
        let list = BLOCK + 16 * fixed.len() as u32;
        let first = list + 32;
        let in_registers = SAVED - fixed.len();
        let caller_stack = first + 16 * in_registers as u32;
        for (n, argument) in (0_u32..).zip(arguments) {
            let beyond = if n as usize >= in_registers { 32 } else { 0 };
            self.put(first + 16 * n + beyond, argument);
        }
        let mut cells: Vec<Value> = fixed.iter().map(|&word| Value::Word(word)).collect();
        cells.extend([Value::Word(first), Value::Word(caller_stack)]);
        self.serve(name, &cells)
    }
}
