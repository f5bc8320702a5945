//! Makes units of traces, and keeps their code.

use std::sync::{Arc, Mutex, PoisonError};

use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, InstBuilder, MemFlagsData, Signature, types};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{ArenaMemoryProvider, JITBuilder, JITModule};
use cranelift_module::{Module, ModuleError, default_libcall_names};

use crate::cpu::{Cpu, Exit};
use crate::emit::{self, Emitter, field};
use crate::host;
use crate::tables::Estimates;
use crate::trace::Trace;
use crate::way::Way;

/// The error is large, and rare.
type Made<T> = Result<T, Box<ModuleError>>;

/// Bytes of code at most. With the traces, and with the tables of six SPEs, that is less than
/// 32 MiB.
const CODE_BYTES: usize = 14 << 20;
/// Units at most; beside its code each takes some 6 KiB.
const UNITS: usize = 2048;

/// The code of all units, and what stands around it.
pub(crate) struct Code {
    module: Mutex<Option<JITModule>>,
    trampoline: *const u8,
    leave: *const u8,
}

// SAFETY: the pointers lead to code, which is never changed once it is there.
unsafe impl Send for Code {}
// SAFETY: as above.
unsafe impl Sync for Code {}

impl Code {
    /// What takes the System V arguments registers, local store, context, target.
    pub fn trampoline(&self) -> *const u8 {
        self.trampoline
    }

    /// What stands in a table where there is no unit.
    pub fn leave(&self) -> *const u8 {
        self.leave
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        let module = self
            .module
            .get_mut()
            .unwrap_or_else(PoisonError::into_inner);
        if let Some(module) = module.take() {
            // SAFETY: whoever has a pointer to code, a `Unit` or a `Cpu`, has a reference to this
            // value as well, and there is none any more.
            unsafe { module.free_memory() };
        }
    }
}

/// A compiled trace.
pub struct Unit {
    number: u32,
    trace: Trace,
    way: Way,
    /// Whether it has arithmetic that may fail in singles.
    floats: bool,
    entry: *const u8,
    code: Arc<Code>,
}

// SAFETY: the pointer leads to code, which is never changed.
unsafe impl Send for Unit {}
// SAFETY: as above.
unsafe impl Sync for Unit {}

impl Unit {
    /// Its number: units are counted from 0.
    #[must_use]
    pub fn number(&self) -> u32 {
        self.number
    }

    /// What it was made of.
    #[must_use]
    pub fn trace(&self) -> &Trace {
        &self.trace
    }

    /// Where it starts.
    #[must_use]
    pub fn start(&self) -> u32 {
        self.trace.start()
    }

    /// How it does arithmetic.
    #[must_use]
    pub fn way(&self) -> Way {
        self.way
    }

    /// Whether the [`Way`] makes a difference.
    #[must_use]
    pub fn floats(&self) -> bool {
        self.floats
    }

    pub(crate) fn entry(&self) -> *const u8 {
        self.entry
    }

    pub(crate) fn code_owner(&self) -> &Arc<Code> {
        &self.code
    }
}

/// Makes units.
pub struct Compiler {
    code: Arc<Code>,
    estimates: Estimates,
    /// Whether units write down each passage through them.
    logs: bool,
    units: u32,
    /// There was no room for a unit: there won't be for others.
    full: bool,
    context: Context,
    builder: FunctionBuilderContext,
}

impl Compiler {
    /// A compiler for this host; `None` if it lacks AVX2 or FMA, or gives no memory for code. With
    /// `logs`, [`Cpu::log`] tells which instructions have run.
    #[must_use]
    pub fn new(estimates: Estimates, logs: bool) -> Option<Self> {
        if !host::supported() {
            return None;
        }
        Self::build(estimates, logs).ok()
    }

    fn build(estimates: Estimates, logs: bool) -> Made<Self> {
        // The order of float operations and of looks at their flags is that of the code given: the
        // optimiser might move one behind the other.
        let flags = [
            ("opt_level", "none"),
            ("enable_probestack", "false"),
            // Tail calls want them.
            ("preserve_frame_pointers", "true"),
            ("unwind_info", "false"),
            ("enable_verifier", "false"),
        ];
        let mut builder = JITBuilder::with_flags(&flags, default_libcall_names())?;
        let arena = ArenaMemoryProvider::new_with_size(CODE_BYTES)
            .map_err(|error| ModuleError::Backend(error.into()))?;
        builder.memory_provider(Box::new(arena));
        let mut module = JITModule::new(builder);
        let mut context = module.make_context();
        let mut functions = FunctionBuilderContext::new();
        let trampoline = build_trampoline(&mut module, &mut context, &mut functions)?;
        let leave = build_leave(&mut module, &mut context, &mut functions)?;
        let code = Code {
            module: Mutex::new(Some(module)),
            trampoline,
            leave,
        };
        Ok(Self {
            code: Arc::new(code),
            estimates,
            logs,
            units: 0,
            full: false,
            context,
            builder: functions,
        })
    }

    /// An SPU that can run units of this compiler.
    #[must_use]
    pub fn new_cpu(&self) -> Cpu {
        Cpu::new(Arc::clone(&self.code), UNITS, self.logs)
    }

    /// Makes a unit; `None` if there is no room for it.
    pub fn compile(&mut self, trace: Trace, way: Way) -> Option<Unit> {
        if self.full || self.units as usize == UNITS {
            return None;
        }
        let mut module = self
            .code
            .module
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let module = module.as_mut()?;
        self.context.func.signature = emit::unit_signature();
        let function = FunctionBuilder::new(&mut self.context.func, &mut self.builder);
        let floats = Emitter::new(function, &trace, way, self.estimates, self.units, self.logs)
            .emit(&trace, module.target_config());
        let entry = define(module, &mut self.context);
        self.full = entry.is_err();
        let entry = entry.ok()?;
        let number = self.units;
        self.units += 1;
        Some(Unit {
            number,
            trace,
            way,
            floats,
            entry,
            code: Arc::clone(&self.code),
        })
    }
}

/// The function in `context` as code. Leaves the context empty.
fn define(module: &mut JITModule, context: &mut Context) -> Made<*const u8> {
    let id = module.declare_anonymous_function(&context.func.signature)?;
    let defined = module.define_function(id, context);
    module.clear_context(context);
    defined?;
    module.finalize_definitions()?;
    Ok(module.get_finalized_function(id))
}

fn build_trampoline(
    module: &mut JITModule,
    context: &mut Context,
    functions: &mut FunctionBuilderContext,
) -> Made<*const u8> {
    let mut signature = Signature::new(CallConv::SystemV);
    signature.params.extend([AbiParam::new(types::I64); 4]);
    signature.returns.push(AbiParam::new(types::I64));
    context.func.signature = signature;
    let mut b = FunctionBuilder::new(&mut context.func, functions);
    let block = b.create_block();
    b.append_block_params_for_function_params(block);
    b.switch_to_block(block);
    b.seal_all_blocks();
    let &[registers, local_store, shared, target] = b.block_params(block) else {
        unreachable!("the signature has four parameters");
    };
    let flags = MemFlagsData::trusted();
    let budget = b.ins().load(types::I64, flags, shared, field::BUDGET);
    let pc = b.ins().load(types::I32, flags, shared, field::PC);
    let signature = b.import_signature(emit::unit_signature());
    let arguments = [registers, local_store, shared, budget, pc];
    let call = b.ins().call_indirect(signature, target, &arguments);
    let status = b.inst_results(call)[0];
    b.ins().return_(&[status]);
    b.finalize(module.target_config());
    define(module, context)
}

fn build_leave(
    module: &mut JITModule,
    context: &mut Context,
    functions: &mut FunctionBuilderContext,
) -> Made<*const u8> {
    context.func.signature = emit::unit_signature();
    let mut b = FunctionBuilder::new(&mut context.func, functions);
    let block = b.create_block();
    b.append_block_params_for_function_params(block);
    b.switch_to_block(block);
    b.seal_all_blocks();
    let &[_, _, shared, budget, pc] = b.block_params(block) else {
        unreachable!("the signature has five parameters");
    };
    let flags = MemFlagsData::trusted();
    b.ins().store(flags, budget, shared, field::BUDGET);
    b.ins().store(flags, pc, shared, field::PC);
    let status = b.ins().iconst(types::I64, i64::from(Exit::LEFT));
    b.ins().return_(&[status]);
    b.finalize(module.target_config());
    define(module, context)
}
