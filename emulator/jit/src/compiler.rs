//! Compiles traces to units, and owns the code cache.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};

use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, InstBuilder, MemFlagsData, Signature, types};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{ArenaMemoryProvider, JITBuilder, JITModule};
use cranelift_module::{Module, ModuleError, default_libcall_names};

use crate::cpu::{Cpu, Storage};
use crate::emit::{self, Emitter, field};
use crate::exit::Exit;
use crate::float_mode::FloatMode;
use crate::host;
use crate::trace::Trace;
use crate::unit::{Estimates, MAX_UNITS, Tier, Unit, UnitOptions};

/// The error is boxed because it is large and rare.
type BuildResult<T> = Result<T, Box<ModuleError>>;

/// The size of each tier's part of the code cache in bytes. Together with the traces and the tables
/// of six SPEs both take less than 32 MiB.
const MAX_CODE_BYTES: [usize; 2] = [9 << 20, 5 << 20];

/// The code of all units, with the trampoline that enters it and the stub that leaves it.
pub struct CodeCache {
    /// By tiers.
    modules: [Mutex<Option<JITModule>>; 2],
    estimates: Estimates,
    options: UnitOptions,
    /// The number of the next unit.
    next_unit: AtomicU32,
    trampoline: *const u8,
    exit_stub: *const u8,
}

// SAFETY: the pointers lead to code, which never changes after it was written.
unsafe impl Send for CodeCache {}
// SAFETY: as above.
unsafe impl Sync for CodeCache {}

impl CodeCache {
    /// Creates an empty cache. Returns `None` if the host lacks AVX2 or FMA, or provides no memory
    /// for code.
    #[must_use]
    pub fn new(estimates: Estimates, options: UnitOptions) -> Option<Arc<Self>> {
        if !host::supported() {
            return None;
        }
        Self::build(estimates, options).ok().map(Arc::new)
    }

    fn build(estimates: Estimates, options: UnitOptions) -> BuildResult<Self> {
        let mut baseline = module(Tier::Baseline)?;
        let optimized = module(Tier::Optimized)?;
        let mut context = baseline.make_context();
        let mut functions = FunctionBuilderContext::new();
        let trampoline = build_trampoline(&mut baseline, &mut context, &mut functions)?;
        let exit_stub = build_exit_stub(&mut baseline, &mut context, &mut functions)?;
        let modules = [baseline, optimized].map(|module| Mutex::new(Some(module)));
        let next_unit = AtomicU32::new(0);
        Ok(Self { modules, estimates, options, next_unit, trampoline, exit_stub })
    }

    /// Creates an SPU that can run units of this cache.
    #[must_use]
    pub fn new_cpu(self: &Arc<Self>) -> Cpu {
        Cpu::new(Arc::clone(self), MAX_UNITS, self.options.logs)
    }

    /// Runs the code at `target`, and returns the reason for its exit.
    ///
    /// # Safety
    ///
    /// As that of [`host::call`], for code of this cache.
    pub(crate) unsafe fn call(
        &self,
        storage: Storage,
        context: &mut host::Context,
        target: *const u8,
    ) -> u32 {
        context.watched = storage.watched;
        let Storage { registers, local_store, .. } = storage;
        // SAFETY: the trampoline is this compiler's, and the caller guarantees the rest.
        unsafe { host::call(self.trampoline, registers, local_store, context, target) }
    }

    /// The code that leaves compiled code. Tables hold it for every address without a unit.
    pub(crate) fn exit_stub(&self) -> *const u8 {
        self.exit_stub
    }
}

impl Drop for CodeCache {
    fn drop(&mut self) {
        for module in &mut self.modules {
            let module = module.get_mut().unwrap_or_else(PoisonError::into_inner);
            if let Some(module) = module.take() {
                // SAFETY: every `Unit` and `Cpu` with a pointer to code also has a reference to
                // this value, and the last reference is gone.
                unsafe { module.free_memory() };
            }
        }
    }
}

/// Compiles traces to units of one tier. Compilers of both tiers can work at the same time.
pub struct Compiler {
    code: Arc<CodeCache>,
    tier: Tier,
    /// Whether the code cache was too full for a unit. Then no other is tried.
    full: bool,
    context: Context,
    builder: FunctionBuilderContext,
}

impl Compiler {
    /// Creates a compiler that adds units to this cache.
    #[must_use]
    pub fn new(code: &Arc<CodeCache>, tier: Tier) -> Self {
        let (context, builder) = (Context::new(), FunctionBuilderContext::new());
        Self { code: Arc::clone(code), tier, full: false, context, builder }
    }

    /// Compiles a trace. Returns `None` if the code cache is full.
    pub fn compile(&mut self, trace: Trace, mode: FloatMode) -> Option<Unit> {
        if self.full {
            return None;
        }
        let code = Arc::clone(&self.code);
        let unit = self.define(&code, trace, mode);
        self.full = unit.is_none();
        unit
    }

    fn define(&mut self, code: &Arc<CodeCache>, trace: Trace, mode: FloatMode) -> Option<Unit> {
        let next = |number| Some(number + 1).filter(|&count| count as usize <= MAX_UNITS);
        let number = code.next_unit.fetch_update(Relaxed, Relaxed, next).ok()?;
        let tier = self.tier;
        let mut module = code.modules[tier as usize].lock().unwrap_or_else(PoisonError::into_inner);
        let module = module.as_mut()?;
        self.context.func.signature = emit::unit_signature();
        let function = FunctionBuilder::new(&mut self.context.func, &mut self.builder);
        let way = (mode, tier);
        let has_fallback =
            Emitter::new(function, &trace, way, code.estimates, number, code.options)
                .emit(&trace, module.target_config());
        let entry = define(module, &mut self.context).ok()?;
        Some(Unit { number, trace, mode, tier, has_fallback, entry, code: Arc::clone(code) })
    }
}

/// An empty module for code of this tier.
fn module(tier: Tier) -> BuildResult<JITModule> {
    let flags = [
        // No optimisation: the optimiser might move float operations past the reads of their
        // exception flags.
        ("opt_level", "none"),
        (
            "regalloc_algorithm",
            match tier {
                Tier::Baseline => "single_pass",
                Tier::Optimized => "backtracking",
            },
        ),
        ("enable_probestack", "false"),
        // Tail calls require frame pointers.
        ("preserve_frame_pointers", "true"),
        ("unwind_info", "false"),
        ("enable_verifier", "false"),
    ];
    let mut builder = JITBuilder::with_flags(&flags, default_libcall_names())?;
    let arena = ArenaMemoryProvider::new_with_size(MAX_CODE_BYTES[tier as usize])
        .map_err(|error| ModuleError::Backend(error.into()))?;
    builder.memory_provider(Box::new(arena));
    Ok(JITModule::new(builder))
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
