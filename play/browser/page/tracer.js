// The tracer's page: it draws the pictures that the program in WebAssembly traces.

import { program } from "../../../emulator/playground/page/exchange.js";
import { units } from "./units.js";

const $ = (id) => document.getElementById(id);
const SIZES = ["160x90", "320x180", "640x360", "1280x720"];
// The largest size that the page chooses by itself, and the time that a frame of it may take.
const LARGEST = 2;
const LONGEST = 400;
// Radians for a pixel of movement, and for an arrow key.
const PIXEL = 0.006;
const KEY = 0.1;
// Milliseconds without a movement after which the frame is timed.
const REST = 300;
// Frames of which the speed is the mean.
const FRAMES = 8;

const { ask, bytes } = await program("tracer.wasm", units);
// The pixels come from memory, so a canvas in memory takes them fastest.
const context = $("picture").getContext("2d", { willReadFrequently: true });
let orbit;
let opened;
let waiting = false;
let rest;
let times = [];

function say(text, failed = false) {
  $("status").textContent = text;
  $("status").classList.toggle("failed", failed);
}

function row(...cells) {
  const made = document.createElement("tr");
  cells.forEach((text, at) => {
    const cell = document.createElement(at ? "td" : "th");
    cell.textContent = text;
    if (at) cell.className = "n";
    made.append(cell);
  });
  return made;
}

function draw() {
  const { width, height } = $("picture");
  context.putImageData(new ImageData(bytes("pixels", 4 * width * height), width, height), 0, 0);
}

const pixels = (size) => size.split("x").reduce((width, height) => width * height);

/** Opens a scene, or the text of a file, in a size that this browser traces fast enough. */
function fit(name, text) {
  $("size").value = SIZES[0];
  const took = open(name, text);
  if (!took) return;
  const takes = (size) => (took * pixels(size)) / pixels(SIZES[0]);
  const size = SIZES.slice(1, LARGEST + 1).findLast((size) => takes(size) <= LONGEST);
  if (!size) return;
  $("size").value = size;
  open(name, text);
}

/** Opens a scene in the chosen size. Returns the milliseconds that a frame takes. */
function open(name, text) {
  const [width, height] = $("size").value.split("x").map(Number);
  opened = { name, text };
  orbit = { turn: 0, rise: 0, distance: 1 };
  times = [];
  $("inspected").hidden = true;
  const smooth = $("smooth").checked;
  const reply = ask({ open: { name, text, width, height, smooth } });
  if (reply.fault) return void say(reply.fault, true);
  Object.assign($("picture"), { width, height });
  const { notes } = reply.opened;
  const took = frame();
  if (notes.length) say(`${name} is drawn without some of its parts: ${notes.join(", ")}`);
  return took;
}

function frame() {
  waiting = false;
  const began = performance.now();
  const reply = ask({ frame: orbit });
  if (reply.fault) return void say(reply.fault, true);
  draw();
  const took = performance.now() - began;
  const { tiles, instructions } = reply.traced;
  if (tiles) {
    times = [...times, took].slice(-FRAMES);
    const mean = times.reduce((sum, time) => sum + time) / times.length;
    $("here").textContent = (1000 / mean).toPrecision(3);
    const millions = (count) => (count / 1e6).toFixed(1);
    say(
      `${tiles} tiles, ${millions(instructions)} million SPU instructions, ` +
        `${millions((instructions / took) * 1000)} million a second`,
    );
  }
  $("console").textContent = "…";
  clearTimeout(rest);
  rest = setTimeout(time, REST);
  return took;
}

/** Traces the view at rest in simulated time. */
function time() {
  const reply = ask({ time: orbit });
  if (reply.fault) return say(reply.fault, true);
  draw();
  const { rate, spus } = reply.timed;
  $("console").textContent = rate.toFixed(1);
  const percent = (part) => `${(100 * part).toFixed(0)} %`;
  $("spus").replaceChildren(
    row("SPU", "tiles", "at work", "waits for memory"),
    ...spus.map(([tiles, busy, waits], number) =>
      row(number, tiles, percent(busy), percent(waits)),
    ),
  );
}

function inspect() {
  const reply = ask({ inspect: orbit });
  if (reply.fault) return say(reply.fault, true);
  draw();
  $("inspected").hidden = false;
  $("inspected").firstElementChild.srcdoc = reply.inspected.page;
  $("inspected").scrollIntoView();
}

function move(turn, rise, zoom = 0) {
  orbit.turn -= turn;
  orbit.rise += rise;
  orbit.distance = Math.min(Math.max(orbit.distance * Math.exp(zoom), 0.1), 10);
  // One frame at a time, whatever the number of movements.
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(frame);
}

const fingers = new Map();
const spread = () => {
  const [one, other] = [...fingers.values()];
  return Math.hypot(one.x - other.x, one.y - other.y);
};
$("picture").addEventListener("pointerdown", (event) => {
  $("picture").setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
});
$("picture").addEventListener("pointermove", (event) => {
  const last = fingers.get(event.pointerId);
  if (!last) return;
  const before = fingers.size === 2 && spread();
  const now = { x: event.clientX, y: event.clientY };
  fingers.set(event.pointerId, now);
  if (before) move(0, 0, Math.log(before / Math.max(spread(), 1)));
  else if (fingers.size === 1) move((now.x - last.x) * PIXEL, (now.y - last.y) * PIXEL);
});
for (const end of ["pointerup", "pointercancel"])
  $("picture").addEventListener(end, (event) => fingers.delete(event.pointerId));
$("picture").addEventListener("wheel", (event) => {
  event.preventDefault();
  move(0, 0, Math.sign(event.deltaY) * KEY);
});
const keys = {
  ArrowLeft: [KEY, 0],
  ArrowRight: [-KEY, 0],
  ArrowUp: [0, KEY],
  ArrowDown: [0, -KEY],
  "+": [0, 0, -KEY],
  "-": [0, 0, KEY],
};
$("picture").addEventListener("keydown", (event) => {
  if (!keys[event.key]) return;
  event.preventDefault();
  move(...keys[event.key]);
});

const again = () => open(opened.name, opened.text);
$("scenes").addEventListener("change", () => fit($("scenes").value));
for (const id of ["size", "smooth"]) $(id).addEventListener("change", again);
$("start").addEventListener("click", again);
$("inspect").addEventListener("click", inspect);
$("file").addEventListener("change", async () => {
  const [file] = $("file").files;
  if (!file) return;
  const text = await file.text();
  $("scenes").selectedIndex = -1;
  fit(file.name, text);
});
$("size").append(...SIZES.map((size) => new Option(size, size)));
const { scenes, fault } = ask("scenes");
if (fault) say(fault, true);
else {
  $("scenes").append(...scenes.map((name) => new Option(name.replace(/\.nff$/, ""), name)));
  fit(scenes[0]);
}
document.body.dataset.ready = "yes";
