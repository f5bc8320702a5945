// Compiled SPU code: modules that the program in WebAssembly emits, and that work on its memory.

/** The program's imports. `exports` returns its exports. */
export function units(exports) {
  const free = [];
  return {
    spu_jit: {
      /** Returns the place of the module's unit in the program's table, or 0 without one. */
      compile(at, length) {
        const { memory, __indirect_function_table: table } = exports();
        try {
          const code = new Uint8Array(memory.buffer, at, length);
          const imports = { program: { memory, table } };
          const { unit } = new WebAssembly.Instance(new WebAssembly.Module(code), imports).exports;
          const place = free.pop() ?? table.grow(1);
          table.set(place, unit);
          return place;
        } catch {
          // Then the SPUs' code is interpreted.
          return 0;
        }
      },
      release(place) {
        exports().__indirect_function_table.set(place, null);
        free.push(place);
      },
    },
  };
}
