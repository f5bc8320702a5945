//! Compiles traces to units, and owns the code cache.

use std::sync::{Arc, Mutex, PoisonError};

use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, InstBuilder, MemFlagsData, Signature, types};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{ArenaMemoryProvider, JITBuilder, JITModule};
use cranelift_module::{Module, ModuleError, default_libcall_names};

use crate::cpu::{Cpu, Exit};
use crate::emit::{self, Emitter, field};
use crate::float_mode::FloatMode;
use crate::host;
use crate::tables::Estimates;
use crate::trace::Trace;

/// The error is boxed because it is large and rare.
type BuildResult<T> = Result<T, Box<ModuleError>>;

/// The size of the code cache in bytes. Together with the traces and the tables of six SPEs it
/// takes less than 32 MiB.
const MAX_CODE_BYTES: usize = 14 << 20;
/// The most units. Each takes some 6 KiB in addition to its code.
const MAX_UNITS: usize = 2048;

/// The code of all units, with the trampoline that enters it and the stub that leaves it.
pub(crate) struct CodeCache {
    module: Mutex<Option<JITModule>>,
    trampoline: *const u8,
    exit_stub: *const u8,
}

// SAFETY: the pointers lead to code, which never changes after it was written.
unsafe impl Send for CodeCache {}
// SAFETY: as above.
unsafe impl Sync for CodeCache {}

impl CodeCache {
    /// A System V function that calls a unit. Its arguments are registers, local store, context,
    /// target.
    pub fn trampoline(&self) -> *const u8 {
        self.trampoline
    }

    /// The code that leaves compiled code. Tables hold it for every address without a unit.
    pub fn exit_stub(&self) -> *const u8 {
        self.exit_stub
    }
}

impl Drop for CodeCache {
    fn drop(&mut self) {
        let module = self.module.get_mut().unwrap_or_else(PoisonError::into_inner);
        if let Some(module) = module.take() {
            // SAFETY: every `Unit` and `Cpu` with a pointer to code also has a reference to this
            // value, and the last reference is gone.
            unsafe { module.free_memory() };
        }
    }
}

/// A compiled trace.
pub struct Unit {
    number: u32,
    trace: Trace,
    mode: FloatMode,
    /// Whether it contains arithmetic that may fail in singles.
    has_floats: bool,
    entry: *const u8,
    code: Arc<CodeCache>,
}

// SAFETY: the pointer leads to code, which is never changed.
unsafe impl Send for Unit {}
// SAFETY: as above.
unsafe impl Sync for Unit {}

impl Unit {
    /// The unit's number, counted from 0.
    #[must_use]
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The trace that it was compiled from.
    #[must_use]
    pub fn trace(&self) -> &Trace {
        &self.trace
    }

    /// The address of its first instruction.
    #[must_use]
    pub fn start(&self) -> u32 {
        self.trace.start()
    }

    /// How it computes floating-point arithmetic.
    #[must_use]
    pub fn mode(&self) -> FloatMode {
        self.mode
    }

    /// Whether it contains arithmetic to which the [`FloatMode`] makes a difference.
    #[must_use]
    pub fn has_floats(&self) -> bool {
        self.has_floats
    }

    pub(crate) fn entry(&self) -> *const u8 {
        self.entry
    }

    pub(crate) fn code_owner(&self) -> &Arc<CodeCache> {
        &self.code
    }
}

/// What units do besides the work of their instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitOptions {
    /// Whether [`Cpu::log`] records which instructions have run.
    pub logs: bool,
    /// Whether units leave accesses to [watched](crate::Storage::watched) quadwords to the
    /// interpreter.
    pub watches: bool,
}

/// Compiles traces to units.
pub struct Compiler {
    code: Arc<CodeCache>,
    estimates: Estimates,
    options: UnitOptions,
    units: u32,
    /// Whether the code cache was too full for a unit. Then no other is tried.
    full: bool,
    context: Context,
    builder: FunctionBuilderContext,
}

impl Compiler {
    /// Creates a compiler for this host. Returns `None` if the host lacks AVX2 or FMA, or provides
    /// no memory for code.
    #[must_use]
    pub fn new(estimates: Estimates, options: UnitOptions) -> Option<Self> {
        if !host::supported() {
            return None;
        }
        Self::build(estimates, options).ok()
    }

    fn build(estimates: Estimates, options: UnitOptions) -> BuildResult<Self> {
        // No optimisation: the optimiser might move float operations past the reads of their
        // exception flags.
        let flags = [
            ("opt_level", "none"),
            ("enable_probestack", "false"),
            // Tail calls require frame pointers.
            ("preserve_frame_pointers", "true"),
            ("unwind_info", "false"),
            ("enable_verifier", "false"),
        ];
        let mut builder = JITBuilder::with_flags(&flags, default_libcall_names())?;
        let arena = ArenaMemoryProvider::new_with_size(MAX_CODE_BYTES)
            .map_err(|error| ModuleError::Backend(error.into()))?;
        builder.memory_provider(Box::new(arena));
        let mut module = JITModule::new(builder);
        let mut context = module.make_context();
        let mut functions = FunctionBuilderContext::new();
        let trampoline = build_trampoline(&mut module, &mut context, &mut functions)?;
        let exit_stub = build_exit_stub(&mut module, &mut context, &mut functions)?;
        let code = CodeCache { module: Mutex::new(Some(module)), trampoline, exit_stub };
        Ok(Self {
            code: Arc::new(code),
            estimates,
            options,
            units: 0,
            full: false,
            context,
            builder: functions,
        })
    }

    /// Creates an SPU that can run units of this compiler.
    #[must_use]
    pub fn new_cpu(&self) -> Cpu {
        Cpu::new(Arc::clone(&self.code), MAX_UNITS, self.options.logs)
    }

    /// Compiles a trace. Returns `None` if the code cache is full.
    pub fn compile(&mut self, trace: Trace, mode: FloatMode) -> Option<Unit> {
        if self.full || self.units as usize == MAX_UNITS {
            return None;
        }
        let mut module = self.code.module.lock().unwrap_or_else(PoisonError::into_inner);
        let module = module.as_mut()?;
        self.context.func.signature = emit::unit_signature();
        let function = FunctionBuilder::new(&mut self.context.func, &mut self.builder);
        let has_floats =
            Emitter::new(function, &trace, mode, self.estimates, self.units, self.options)
                .emit(&trace, module.target_config());
        let entry = define(module, &mut self.context);
        self.full = entry.is_err();
        let entry = entry.ok()?;
        let number = self.units;
        self.units += 1;
        Some(Unit { number, trace, mode, has_floats, entry, code: Arc::clone(&self.code) })
    }
}

/// Compiles the function in `context`, and returns its code's address. Clears the context.
fn define(module: &mut JITModule, context: &mut Context) -> BuildResult<*const u8> {
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
) -> BuildResult<*const u8> {
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

fn build_exit_stub(
    module: &mut JITModule,
    context: &mut Context,
    functions: &mut FunctionBuilderContext,
) -> BuildResult<*const u8> {
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
