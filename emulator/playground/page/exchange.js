// The program in WebAssembly: it gets requests and gives replies, as JSON in its memory.

/**
 * Loads a program. Returns `ask`, which passes a request and returns the reply, and `bytes`.
 * `imports` returns the program's imports, which may use its exports when it runs.
 */
export async function program(address, imports = () => ({})) {
  const code = await WebAssembly.compile(await (await fetch(address)).arrayBuffer());
  let machine;

  function ask(request) {
    try {
      machine ??= new WebAssembly.Instance(code, imports(() => machine)).exports;
      const bytes = new TextEncoder().encode(JSON.stringify(request));
      const buffer = machine.buffer(bytes.length);
      new Uint8Array(machine.memory.buffer, buffer, bytes.length).set(bytes);
      const at = machine.reply();
      return JSON.parse(
        new TextDecoder().decode(new Uint8Array(machine.memory.buffer, at, machine.reply_bytes())),
      );
    } catch (fault) {
      // It starts again with the next request.
      machine = undefined;
      return {
        fault: `The page's own program failed: ${fault.message}. Please report this text.`,
      };
    }
  }

  /** The bytes at an address that one of the program's functions returns. */
  const bytes = (name, length) =>
    new Uint8ClampedArray(machine.memory.buffer, machine[name](), length);
  return { ask, bytes };
}
