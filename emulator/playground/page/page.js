// The page: it passes the text to the program in WebAssembly, and shows what that replies.

import { editor } from "./editor.js";
import { examples } from "./examples.js";
import { program } from "./exchange.js";

const $ = (id) => document.getElementById(id);
const { ask } = await program("playground.wasm");
let lines = new Map();
let addresses = new Map();
let state = { step: 0 };
let scheduled;

function say(text, failed = false) {
  $("status").textContent = text;
  $("status").classList.toggle("failed", failed);
}

function element(name, text, properties = {}) {
  return Object.assign(document.createElement(name), { textContent: text }, properties);
}

/** Shows a page of the analyser in a frame. */
function show(frame, html) {
  const inside = frame.contentDocument;
  const scrolled = frame.contentWindow.scrollY;
  inside.open();
  inside.write(html);
  inside.close();
  inside.body.append(...inside.querySelectorAll(".legend"));
  for (const details of inside.querySelectorAll("details")) details.open = true;
  const style = inside.createElement("style");
  style.textContent = `body { margin: .3rem } h1 { display: none } details { border: 0 }
    tr.here td:not(.cycles) { background: var(--mark) }`;
  inside.head.append(style);
  frame.contentWindow.scrollTo(0, scrolled);
  // A frame without an address of its own can't follow links within itself.
  inside.onclick = (event) => {
    const link = event.target.closest?.('a[href^="#"]');
    if (!link) return;
    event.preventDefault();
    inside.getElementById(link.getAttribute("href").slice(1))?.scrollIntoView({ block: "center" });
  };
}

function assemble(text) {
  $("examples").selectedIndex = examples.findIndex((example) => example.text === text);
  const reply = ask({ load: { source: text, mail: mail() ?? [] } });
  scheduled = undefined;
  choose(false);
  $("theirs").disabled = true;
  if (reply.fault) return say(reply.fault, true);
  source.errors(reply.errors ?? []);
  if (reply.errors) {
    lines = new Map();
    source.mark(0);
    const [first] = reply.errors;
    say(`line ${first.line}, column ${first.column}: ${first.message}`, true);
    return;
  }
  lines = new Map(reply.lines);
  addresses = new Map();
  for (const [address, line] of reply.lines) if (!addresses.has(line)) addresses.set(line, address);
  show($("own"), reply.diagram);
  look({ go: { step: 0 } });
}

/** Asks for a change of the state, and shows the new one. */
function look(request) {
  const first = Math.floor((Number($("address").value) || 0) / 16);
  const reply = ask({ ...request, quadwords: [first, first + 64] });
  if (reply.fault) return say(reply.fault, true);
  state = reply;
  const line = lines.get(state.pc) ?? 0;
  source.mark(state.stopped ? 0 : line);
  say(
    state.stopped
      ? `${state.stopped}, after ${state.step} instructions`
      : `${state.step} instructions have run; next, at ${hex(state.pc)}: ${state.next}`,
  );
  for (const row of $("own").contentDocument.querySelectorAll("tr.here"))
    row.classList.remove("here");
  const rows = $("own").contentDocument.querySelectorAll(
    `tr[id$="-${state.pc.toString(16).padStart(5, "0")}"]`,
  );
  if (!state.stopped) for (const row of rows) row.classList.add("here");
  cycles();
  mailboxes();
  registers();
  const quadword = state.written.quadword;
  $("store").replaceChildren(
    ...state.store.map((words, at) => {
      const address = 16 * (first + at);
      return tableRow(address === quadword, element("th", hex(address)), element("td", words));
    }),
  );
}

const hex = (address) => `0x${address.toString(16).padStart(5, "0")}`;

function tableRow(isNew, ...cells) {
  const row = document.createElement("tr");
  if (isNew) row.className = "new";
  row.append(...cells);
  return row;
}

function cycles() {
  const { total, single, dual, stalls } = state.cycles;
  $("cycles").textContent = `${total}`;
  const all = [
    ["one instruction issued", single, "issue"],
    ["two instructions issued", dual, "issue"],
    ...stalls.map(([cause, count]) => [cause, count, ""]),
  ];
  $("causes").replaceChildren(
    ...all.map(([cause, count, kind]) => {
      const bar = element("span", "", { className: `bar ${kind}` });
      bar.style.width = `${total ? (8 * count) / total : 0}rem`;
      const cell = document.createElement("td");
      cell.append(bar);
      return tableRow(
        false,
        element("th", cause),
        element("td", `${count}`, { className: "n" }),
        cell,
      );
    }),
  );
}

/** The words that the PPE sends, or `undefined` after a message that one is no word. */
function mail() {
  const words = $("mail").value.split(/[\s,]+/).filter((word) => word);
  const bad = words.find((word) => !/^(0x[0-9a-f]{1,8}|-?\d{1,10})$/i.test(word));
  if (bad) return void say(`The PPE's words: ${bad} is not a number of 32 bits.`, true);
  return words.map((word) => Number(word) >>> 0);
}

function mailboxes() {
  const { inbound, read, outbound, outbound_interrupt } = state.mail;
  const line = (name, text) => tableRow(false, element("th", name), element("td", text));
  $("mailboxes").replaceChildren(
    line("read", inbound.slice(0, read).join(" ")),
    line("still to read", inbound.slice(read).join(" ")),
    line("sent", outbound.join(" ")),
    line("sent with an interrupt", outbound_interrupt.join(" ")),
    line("decrementer", `${state.decrementer}`),
  );
}

/** A single of the SPU, whose largest exponent is an ordinary one. */
function single(word) {
  const exponent = (word >>> 23) & 255;
  const magnitude = exponent ? (1 + (word & 0x7fffff) / 0x800000) * 2 ** (exponent - 127) : 0;
  return Number((word >>> 31 ? -magnitude : magnitude).toPrecision(7)).toString();
}

const notations = {
  word: (word) => word,
  float: (word) => single(parseInt(word, 16)).padStart(14),
  integer: (word) => (parseInt(word, 16) | 0).toString().padStart(11),
};

function registers() {
  const write = notations[$("format").value];
  $("registers").replaceChildren(
    ...state.registers.map((value, number) => {
      const words = value.split(" ").map(write).join(" ");
      return tableRow(
        state.written.registers.includes(number),
        element("th", `$${number}`),
        element("td", words),
      );
    }),
  );
}

const breakpoints = () =>
  source
    .breakpoints()
    .map((line) => addresses.get(line))
    .filter((at) => at !== undefined);

/** Chooses the scheduler's version or one's own. */
function choose(theirs) {
  $("mine").ariaPressed = String(!theirs);
  $("theirs").ariaPressed = String(theirs);
  $("own").hidden = theirs;
  $("other").hidden = !theirs;
  $("take").hidden = !theirs;
}

function schedule() {
  const reply = ask({ schedule: { source: source.text, mail: mail() ?? [] } });
  if (reply.fault) return say(reply.fault, true);
  if (reply.error) return say(reply.error, true);
  scheduled = reply.text;
  $("theirs").disabled = false;
  choose(true);
  $("scheduled").textContent = reply.text;
  const [before, after] = reply.cycles ?? [];
  const whole =
    after === undefined ? "" : ` The program takes ${after} cycles instead of ${before}.`;
  $("verdict").textContent = reply.loops.join(" ") + whole;
  // The first line that has a note with its cycle.
  const first = reply.text.split("\n").findIndex((line) => /# \d+[eo]/.test(line));
  const height = $("scheduled").scrollHeight / reply.text.split("\n").length;
  $("scheduled").scrollTop = height * Math.max(first - 2, 0);
  show($("scheduled-diagram"), reply.diagram);
}

async function transformed(bytes, stream) {
  return new Uint8Array(
    await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer(),
  );
}

/** A link that carries the program: its text, compressed, in base64 for addresses. */
async function link() {
  const packed = await transformed(
    new TextEncoder().encode(source.text),
    new CompressionStream("deflate-raw"),
  );
  const base64 = btoa(String.fromCharCode(...packed));
  history.replaceState(
    null,
    "",
    `#${base64.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`,
  );
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  say("The page's address now carries this program.");
}

async function linked() {
  try {
    const base64 = location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/");
    const packed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    return new TextDecoder().decode(
      await transformed(packed, new DecompressionStream("deflate-raw")),
    );
  } catch {
    return `# This link's program is damaged.\n${examples[0].text}`;
  }
}

const source = editor($("source"), assemble);
const actions = {
  start: () => look({ go: { step: 0 } }),
  back: () => look({ go: { step: Math.max(state.step - 1, 0) } }),
  step: () => look({ go: { step: state.step + 1 } }),
  run: () => look({ run: { breakpoints: breakpoints() } }),
  schedule,
  link,
  mine: () => choose(false),
  theirs: () => choose(true),
  take: () => {
    source.text = scheduled;
  },
};
for (const [id, action] of Object.entries(actions)) $(id).addEventListener("click", action);
addEventListener("keydown", (event) => {
  const action = { F8: "run", F9: "back", F10: "step" }[event.key];
  if (!action) return;
  event.preventDefault();
  actions[action]();
});
$("mail").addEventListener("change", () => {
  const words = mail();
  if (words) look({ send: { mail: words } });
});
$("format").addEventListener("change", registers);
$("address").addEventListener("change", () => look({ go: { step: state.step } }));
$("examples").append(...examples.map(({ name }, at) => new Option(name, at)));
$("examples").addEventListener("change", () => {
  source.text = examples[$("examples").value].text;
});
addEventListener("hashchange", async () => {
  source.text = await linked();
});
source.text = location.hash.length > 1 ? await linked() : examples[0].text;
document.body.dataset.ready = "yes";
