// Chromium without a screen, driven through a pipe by its DevTools protocol, and the web server of
// one folder.

import { spawn } from "node:child_process";
import { createReadStream } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

/** Serves a folder on a free port of this machine; `asked` gets the paths that were asked for. */
export function serve(folder, asked) {
  const server = createServer((request, response) => {
    const path = request.url === "/" ? "/index.html" : request.url.split(/[?#]/)[0];
    asked.push(path);
    const file = createReadStream(join(folder, path));
    file.once("error", () => response.writeHead(404).end());
    file.once("open", () => {
      response.writeHead(200, {
        "content-type": TYPES[extname(path)] ?? "application/octet-stream",
      });
      file.pipe(response);
    });
  });
  return new Promise((done) => server.listen(0, "127.0.0.1", () => done(server)));
}

/** A browser with one page. Every message of the page's console is a failure. */
export async function browser(profile) {
  const child = spawn(
    "chromium",
    [
      "--headless=new",
      "--no-sandbox",
      "--disable-gpu",
      "--hide-scrollbars",
      "--remote-debugging-pipe",
      `--user-data-dir=${profile}`,
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "about:blank",
    ],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
  );
  process.once("exit", () => child.kill());
  const [, , , to, from] = child.stdio;
  const waiting = new Map();
  const listeners = new Set();
  const failures = [];
  let last = 0;
  let text = "";
  const end = new Promise((_, failed) =>
    child.once("exit", (status) => {
      const error = new Error(`the browser has ended with status ${status}`);
      for (const { failed: tell } of waiting.values()) tell(error);
      failed(error);
    }),
  );
  end.catch(() => {});
  from.setEncoding("utf8");
  from.on("data", (chunk) => {
    text += chunk;
    const messages = text.split("\0");
    text = messages.pop();
    for (const message of messages.map((each) => JSON.parse(each))) {
      if (message.id) {
        const { done, failed } = waiting.get(message.id);
        waiting.delete(message.id);
        message.error ? failed(new Error(JSON.stringify(message.error))) : done(message.result);
      } else {
        if (
          message.method === "Runtime.exceptionThrown" ||
          message.method === "Runtime.consoleAPICalled" ||
          message.method === "Log.entryAdded"
        )
          failures.push(JSON.stringify(message.params));
        for (const listener of listeners) listener(message);
      }
    }
  });
  let sessionId;
  const send = (method, params = {}) =>
    new Promise((done, failed) => {
      waiting.set(++last, { done, failed });
      to.write(`${JSON.stringify({ id: last, method, params, sessionId })}\0`);
    });
  const event = (method) =>
    new Promise((done) => {
      const listener = (message) => {
        if (message.method !== method) return;
        listeners.delete(listener);
        done(message.params);
      };
      listeners.add(listener);
    });
  const {
    targetInfos: [target],
  } = await send("Target.getTargets", { filter: [{ type: "page" }] });
  ({ sessionId } = await send("Target.attachToTarget", {
    targetId: target.targetId,
    flatten: true,
  }));
  for (const domain of ["Page", "Runtime", "Log"]) await send(`${domain}.enable`);

  /** The value of an expression on the page, awaited. */
  async function value(expression) {
    const { result, exceptionDetails } = await send("Runtime.evaluate", {
      expression,
      awaitPromise: true,
      returnByValue: true,
      userGesture: true,
    });
    if (exceptionDetails) throw new Error(`${expression}: ${JSON.stringify(exceptionDetails)}`);
    return result.value;
  }
  return {
    failures,
    send,
    value,
    async open(address) {
      const loaded = event("Page.loadEventFired");
      await send("Page.navigate", { url: address });
      await Promise.race([loaded, end]);
      // The page's program is compiled after the page has loaded.
      await value(`new Promise((done) => {
        const ready = () => document.body.dataset.ready && done();
        new MutationObserver(ready).observe(document.body, { attributes: true });
        ready();
      })`);
    },
    /** Gives the window a size. */
    size: (width, height, mobile = false) =>
      send("Emulation.setDeviceMetricsOverride", { width, height, mobile, deviceScaleFactor: 1 }),
    async picture() {
      const { data } = await send("Page.captureScreenshot", {
        format: "png",
        captureBeyondViewport: true,
      });
      return Buffer.from(data, "base64");
    },
    /** Clicks what a selector finds, with the mouse. */
    async click(selector) {
      const { x, y } = await value(`(() => {
        const found = document.querySelector(${JSON.stringify(selector)});
        found.scrollIntoView({ block: "center" });
        const { left, top, width, height } = found.getBoundingClientRect();
        return { x: left + width / 2, y: top + height / 2 };
      })()`);
      const at = { x, y, button: "left", clickCount: 1 };
      await send("Input.dispatchMouseEvent", { type: "mousePressed", ...at });
      await send("Input.dispatchMouseEvent", { type: "mouseReleased", ...at });
    },
    type: (typed) => send("Input.insertText", { text: typed }),
    async key(key, code, modifiers = 0) {
      const event = { key, windowsVirtualKeyCode: code, modifiers };
      await send("Input.dispatchKeyEvent", { type: "keyDown", ...event });
      await send("Input.dispatchKeyEvent", { type: "keyUp", ...event });
    },
    async close() {
      const ended = new Promise((done) => child.once("exit", done));
      sessionId = undefined;
      send("Browser.close").catch(() => {});
      await ended;
    },
  };
}
