// Tests the tracer's page in Chromium: its pictures and its simulated time are those of `cellray`.
//
//   node test.js PAGE-FOLDER EXPECTED-FOLDER PICTURES-FOLDER PROFILE-FOLDER
//
// EXPECTED-FOLDER has pictures SCENE-WIDTHxHEIGHT.png, and beside each the statistics of its run in
// simulated time, as JSON.

import assert from "node:assert/strict";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { browser, serve } from "../../../emulator/playground/page/browser.js";
import { units } from "./units.js";

const [page, expected, pictures, profile] = process.argv.slice(2);
const server = await serve(page, []);
const chromium = await browser(profile);
const { value } = chromium;
const text = (selector) =>
  value(`document.querySelector(${JSON.stringify(selector)}).textContent`);
/** Waits until an expression is true. */
const until = (expression) =>
  value(`new Promise((done) => {
    const look = () => (${expression} ? done() : requestAnimationFrame(look));
    look();
  })`);
const timed = () => until("Number(document.querySelector('#console').textContent) > 0");
const choose = (id, chosen) =>
  value(`(() => {
    const select = document.querySelector('#${id}');
    select.value = ${JSON.stringify(chosen)};
    select.dispatchEvent(new Event("change"));
  })()`);
/** The canvas's bytes, as text. */
const shown = () =>
  value(`(() => {
    const { width, height } = document.querySelector("#picture");
    const { data } = document.querySelector("#picture").getContext("2d")
      .getImageData(0, 0, width, height);
    return [...data].join();
  })()`);
/** The same of a PNG file. */
const decoded = (file) =>
  value(`(async () => {
    const bytes = Uint8Array.from(atob("${readFileSync(file).toString("base64")}"), (letter) =>
      letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: "none" });
    const canvas = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    canvas.drawImage(picture, 0, 0);
    return [...canvas.getImageData(0, 0, picture.width, picture.height).data].join();
  })()`);

/**
 * Frames and millions of SPU instructions in a second of processor time. Chromium's engine is
 * Node's, too, and other programs on the machine don't count there.
 */
async function processorSpeed(name, size) {
  const FRAMES = 10;
  const code = readFileSync(join(page, "tracer.wasm"));
  const { exports } = (await WebAssembly.instantiate(code, units(() => exports))).instance;
  const ask = (request) => {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const buffer = exports.buffer(bytes.length);
    new Uint8Array(exports.memory.buffer, buffer, bytes.length).set(bytes);
    const reply = exports.reply();
    return JSON.parse(
      new TextDecoder().decode(
        new Uint8Array(exports.memory.buffer, reply, exports.reply_bytes()),
      ),
    );
  };
  const [width, height] = size.split("x").map(Number);
  ask({ open: { name, width, height, smooth: false } });
  let instructions = 0;
  let began;
  // The first frames run while the code is still being compiled.
  for (let frame = -FRAMES; frame < FRAMES; frame++) {
    if (frame === 0) began = process.cpuUsage();
    const { traced } = ask({ frame: { turn: frame / 100, rise: 0, distance: 1 } });
    if (frame >= 0) instructions += traced.instructions;
  }
  const { user, system } = process.cpuUsage(began);
  const took = (user + system) / 1e6;
  return [(FRAMES / took).toFixed(1), (instructions / took / 1e6).toFixed(0)];
}

async function picture(name, width, height, mobile) {
  await chromium.size(width, height, mobile);
  const wide = await value("document.documentElement.scrollWidth");
  assert.ok(wide <= width, `at ${width} pixels the page is ${wide} wide`);
  writeFileSync(join(pictures, `${name}.png`), await chromium.picture());
}

await chromium.size(1400, 1000);
const begin = performance.now();
await chromium.open(`http://127.0.0.1:${server.address().port}/tracer.html`);
const ready = `${((performance.now() - begin) / 1000).toFixed(1)} s`;
const measured = [];
// From here on there is no network.
server.closeAllConnections();
await new Promise((done) => server.close(done));

for (const file of readdirSync(expected).filter((file) => file.endsWith(".png"))) {
  const [, scene, size] = /^(.*)-(\d+x\d+)\.png$/.exec(file);
  await choose("scenes", `${scene}.nff`);
  await choose("size", size);
  const wanted = await decoded(join(expected, file));
  assert.ok((await shown()) === wanted, `the picture of ${scene} at ${size} differs`);
  await timed();
  assert.ok((await shown()) === wanted, `in simulated time the picture of ${scene} differs`);
  const { frames_per_second } = JSON.parse(
    readFileSync(join(expected, `${scene}-${size}.json`), "utf8"),
  );
  assert.equal(await text("#console"), frames_per_second.toFixed(1), `frames/s of ${scene}`);

  // The mouse turns the scene. Each movement traces a frame.
  const before = await shown();
  const at = await value(`(() => {
    const { left, top } = document.querySelector("#picture").getBoundingClientRect();
    return { x: left + 100, y: top + 100 };
  })()`);
  const mouse = (type, x) =>
    chromium.send("Input.dispatchMouseEvent", { type, ...at, x, button: "left", buttons: 1 });
  await mouse("mousePressed", at.x);
  for (let step = 1; step <= 12; step++) {
    await mouse("mouseMoved", at.x + 8 * step);
    await value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
  }
  await mouse("mouseReleased", at.x + 96);
  assert.ok((await shown()) !== before, `${scene} does not turn`);
  const speed = await processorSpeed(`${scene}.nff`, size);
  measured.push([scene, size, await text("#here"), ...speed, frames_per_second.toFixed(1)]);
  await chromium.click("#start");
  assert.ok((await shown()) === before, `${scene} does not go back to its first view`);
  await timed();
}

// The inspector's page names the SPUs, and says where their time went.
await chromium.click("#inspect");
await until("document.querySelector('#inspected iframe').contentDocument?.querySelector('h2')");
const inside = "document.querySelector('#inspected iframe').contentDocument.body.textContent";
assert.match(await value(inside), /SPU 5/);

// A file of one's own, and one that is none.
const open = (name, contents) =>
  value(`(() => {
    const files = new DataTransfer();
    files.items.add(new File([${JSON.stringify(contents)}], "${name}"));
    const input = document.querySelector("#file");
    input.files = files.files;
    input.dispatchEvent(new Event("change"));
  })()`);
await open("bad.nff", "s 0 0 zero 1\n");
await until("document.querySelector('#status.failed')");
assert.match(await text("#status"), /^bad\.nff:1: /);
await open(
  "own.nff",
  "v\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 64 64\n" +
    "l 0 -5 5\nf 1 0 0 1 0 0 0 1\ns 0 0 0 1\n",
);
await until("!document.querySelector('#status.failed')");
assert.match(await text("#status"), /tiles/);

await choose("scenes", "still-life.nff");
await choose("size", "320x180");
await timed();
await picture("tracer-desktop", 1400, 1000);
await picture("tracer-phone", 390, 844, true);
await chromium.size(1400, 1000);
await chromium.click("#inspect");
await until("document.querySelector('#inspected iframe').contentDocument?.querySelector('h2')");
await picture("tracer-inspected", 1400, 1000);
assert.deepEqual(chromium.failures, []);
await chromium.close();
const table = [
  `The first picture was there after ${ready}.`,
  "",
  "| scene | size | wall time | processor time | million SPU instructions | on a console |",
  "|---|---|---|---|---|---|",
  ...measured.map((row) => `| ${row.join(" | ")} |`),
];
writeFileSync(join(pictures, "tracer.md"), `${table.join("\n")}\n`);
console.log(table.join("\n"));
console.log("the tracer's page passes");
