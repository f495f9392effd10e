"use strict";
// What the figures have in common: words, the makers of frames, pictures with handles, sliders.

// --- words -----------------------------------------------------------------------------------------

const texts = JSON.parse(document.getElementById("words").textContent);
const query = new URLSearchParams(location.search);
const wished = query.get("lang") ?? navigator.language;
const language = wished.startsWith("el") ? "el" : "en";
const say = (key, ...values) =>
  texts[key][language].replace(/\{(\d)\}/g, (_, i) => values[i]);
const decimals = (number, digits = 3) => {
  const text = number.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text; // no -0.000
};
const vector = (v) => `(${v.map((x) => decimals(x)).join(", ")})`;

// --- elements --------------------------------------------------------------------------------------

const svg = new Set(["svg", "g", "line", "circle", "polyline", "polygon", "text", "path"]);

function element(tag, attributes = {}, ...children) {
  const made = svg.has(tag)
    ? document.createElementNS("http://www.w3.org/2000/svg", tag)
    : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// A slider with its label and its value in words; `change` is called with the number.
function slider(label, { min, max, step, value, show = (x) => decimals(x, 2) }, change) {
  const input = element("input", { type: "range", min, max, step });
  const output = element("output");
  const set = (number) => {
    input.value = number;
    output.textContent = show(number);
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.addEventListener("input", () => {
    const number = Number(input.value);
    set(number);
    change(number);
  });
  set(value);
  return { row: element("label", {}, element("span", {}, label), input, output), set };
}

function choice(label, options, change) {
  const select = element("select", {}, ...options);
  select.addEventListener("change", () => change(select.value));
  return element("label", { class: "choice" }, element("span", {}, label), select);
}

const option = (value, label) => element("option", { value }, label);
const group = (legend, ...rows) => element("fieldset", {}, element("legend", {}, legend), ...rows);

// A canvas with its caption, and over it an svg for handles, 600 × 600 whatever the canvas is.
function picture(caption, size = 600) {
  const canvas = element("canvas", { width: size, height: size, role: "img", "aria-label": caption });
  const over = element("svg", { viewBox: "0 0 600 600", "aria-hidden": "true" });
  const frame = element("div", { class: "picture" }, canvas, over);
  const whole = element("figure", {}, frame, element("figcaption", {}, caption));
  return { whole, frame, canvas, over };
}

// Calls `drag(x, y, event)`, in the units of a svg, while the pointer is down on `target`; and
// `hover` where it is not.
function onDrag(over, target, drag, hover = () => {}) {
  const place = (event) => {
    const box = over.getBoundingClientRect();
    const [left, top, width, height] = over.getAttribute("viewBox").split(" ").map(Number);
    return [left + ((event.clientX - box.left) / box.width) * width,
      top + ((event.clientY - box.top) / box.height) * height];
  };
  target.addEventListener("pointerdown", (event) => {
    target.setPointerCapture(event.pointerId);
    drag(...place(event), event);
  });
  target.addEventListener("pointermove", (event) => {
    (target.hasPointerCapture(event.pointerId) ? drag : hover)(...place(event), event);
  });
}

// Arrow keys as steps (x, y), y upwards, Page Up and Page Down as z.
function onKeys(target, step) {
  const steps = {
    ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0],
    PageUp: [0, 0, 1], PageDown: [0, 0, -1],
  };
  target.tabIndex = 0;
  target.setAttribute("role", "application");
  target.setAttribute("aria-label", target.querySelector("canvas").getAttribute("aria-label"));
  target.addEventListener("keydown", (event) => {
    if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    step(...steps[event.key], event.shiftKey);
  });
}

// A point light, drawn.
function sun(over) {
  const rays = [...Array(8).keys()].map((i) => {
    const [x, y] = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)];
    return element("line", { x1: 13 * x, y1: 13 * y, x2: 20 * x, y2: 20 * y });
  });
  const drawn = element("g", { class: "sun" }, element("circle", { r: 9 }), ...rays);
  over.append(drawn);
  return { drawn, move: (x, y, scale = 1) =>
    drawn.setAttribute("transform", `translate(${x} ${y}) scale(${scale})`) };
}

// --- scenes ----------------------------------------------------------------------------------------

const spheres = (floor = 5000) => [
  { center: [0, -1, 3], radius: 1, color: [255, 0, 0] },
  { center: [2, 0, 4], radius: 1, color: [0, 0, 255] },
  { center: [-2, 0, 4], radius: 1, color: [0, 255, 0] },
  { center: [0, -1 - floor, 0], radius: floor, color: [255, 255, 0] },
];
const slides = () => ({
  spheres: spheres(),
  ambient: 0.2,
  points: [{ intensity: 0.6, position: [2, 1, 0] }],
  directionals: [{ intensity: 0.2, direction: [1, 4, 4] }],
});

// As docs/figures/figure.hpp reads them.
function numbersOf(scene, { size = 600, mistake = 0, terms = 0 } = {}) {
  return [mistake, terms, size, size,
    scene.spheres.length, scene.points.length, scene.directionals.length,
    scene.ambient, 255, 255, 255,
    ...scene.spheres.flatMap(({ center, radius, color }) => [...center, radius, ...color]),
    ...scene.points.flatMap(({ intensity, position }) => [intensity, ...position]),
    ...scene.directionals.flatMap(({ intensity, direction }) => [intensity, ...direction])];
}

// --- frames ----------------------------------------------------------------------------------------

const decode = (text) => Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
const modules = Object.fromEntries(
  [...document.querySelectorAll("script[id$='.wasm']")].map((script) =>
    [script.id.replace(".wasm", ""), decode(script.textContent)]));

// Two workers: each makes every other row.
const workers = [0, 1].map(() => new Worker(URL.createObjectURL(
  new Blob([document.getElementById("worker").textContent], { type: "text/javascript" }))));

// A worker answers in the order in which it is asked.
for (const worker of workers) {
  worker.asked = [];
  worker.onmessage = ({ data }) => worker.asked.shift().resolve(data);
  worker.onerror = ({ message }) => worker.asked.shift().reject(new Error(message));
}
function ask(worker, message) {
  return new Promise((resolve, reject) => {
    worker.asked.push({ resolve, reject });
    worker.postMessage(message);
  });
}

async function frameOf(module, numbers) {
  const [width, height] = [numbers[2], numbers[3]];
  const parts = await Promise.all(workers.map((worker, first) =>
    ask(worker, { frame: { module, numbers, first, step: workers.length } })));
  const frame = new ImageData(width, height);
  parts.forEach(({ rows }, first) => {
    for (let row = first, i = 0; row < height; row += workers.length, ++i) {
      frame.data.set(new Uint8Array(rows, 4 * width * i, 4 * width), 4 * width * row);
    }
  });
  return frame;
}

// The same module here, for what is asked of one pixel.
async function moduleHere(name) {
  const { instance } = await WebAssembly.instantiate(modules[name]);
  instance.exports._initialize();
  return instance.exports;
}

// --- the figure ------------------------------------------------------------------------------------

// What is on the screen, for whoever checks it: by its canvas's number, the module and the numbers.
const shown = { count: 0, busy: true, frames: {} };
window.figure = shown;

async function draw(canvas, module, numbers) {
  const frame = await frameOf(module, numbers);
  canvas.getContext("2d").putImageData(frame, 0, 0);
  shown.frames[[...document.querySelectorAll("canvas")].indexOf(canvas)] = { module, numbers };
  return frame;
}

// `make` draws what is wished for now. Wishes that come meanwhile are one more.
function drawing(make) {
  let running = false;
  let again = false;
  return async () => {
    again = shown.busy = true;
    if (running) return;
    running = true;
    try {
      while (again) {
        again = false;
        await make();
        ++shown.count;
      }
      shown.busy = false;
    } catch (error) {
      fail(error);
    }
    running = false;
  };
}

function fail(error) {
  document.body.append(element("p", { role: "alert" }, say("figures_fails", error.message)));
  throw error;
}

// How two frames differ: a picture of it, and a sentence.
function difference(canvas, a, b) {
  const out = new ImageData(a.width, a.height);
  out.data.fill(255);
  let count = 0;
  let most = 0;
  const places = [];
  for (let i = 0; i < a.data.length; i += 4) {
    let by = 0;
    for (let k = i; k < i + 3; ++k) by = Math.max(by, Math.abs(a.data[k] - b.data[k]));
    if (by === 0) continue;
    ++count;
    most = Math.max(most, by);
    if (places.length < 1000) places.push(i / 4);
    out.data.fill(200 - 200 * Math.sqrt(by / 255), i, i + 3);
  }
  const context = canvas.getContext("2d");
  context.putImageData(out, 0, 0);
  if (count <= 1000) { // so few would not be seen
    const side = count <= 200 ? 9 : 3;
    context.fillStyle = "#c0392b";
    for (const place of places) {
      const [x, y] = [place % a.width, Math.floor(place / a.width)].map((at) => at - (side - 1) / 2);
      context.fillRect(x, y, side, side);
    }
  }
  const pixels = a.width * a.height;
  return count === 0 ? say("figures_same", pixels) : say("figures_differ", count, pixels, most);
}

// Two pictures, and what differs between them: `asked` says how each is made, as [module, numbers].
function comparison(captions, asked, size = 600) {
  const [a, b] = captions.map((caption) => picture(caption, size));
  const third = picture(say("figures_difference"), size);
  const verdict = element("p", { class: "verdict", role: "status" });
  const update = drawing(async () => {
    const [one, other] = asked();
    const frames = await Promise.all([draw(a.canvas, ...one), draw(b.canvas, ...other)]);
    verdict.textContent = difference(third.canvas, ...frames);
  });
  const whole = element("div", { class: "row still" }, a.whole, b.whole, third.whole);
  return { a, b, whole, verdict, update };
}

// Moves a point light over the picture in x and y, by pointer and keys; z by keys.
const range = { x: [-3.9, 3.9], y: [-3.9, 3.9], z: [-1, 7] };
const round = (number) => Math.round(number * 100) / 100;
const within = (number, [least, most]) => round(Math.max(least, Math.min(most, number)));
function lightHandle({ over, frame }, light, update) {
  const unit = 75; // of the picture's pixels to one of the scene's
  const handle = sun(over);
  const move = (x, y, z) => {
    light.position = [within(x, range.x), within(y, range.y), within(z, range.z)];
    update();
  };
  frame.classList.add("grab");
  onDrag(over, frame, (x, y) => move((x - 300) / unit, (300 - y) / unit, light.position[2]));
  onKeys(frame, (x, y, z) => {
    const [px, py, pz] = light.position;
    move(px + 0.1 * x, py + 0.1 * y, pz + 0.1 * z);
  });
  return { move, show: () =>
    handle.move(300 + unit * light.position[0], 300 - unit * light.position[1]) };
}

// Puts the page up: the title and lead of a figure, then its parts; and begins.
async function start(name, parts, begin) {
  const other = language === "el" ? "en" : "el";
  query.set("lang", other);
  document.documentElement.lang = language;
  document.title = say(`figures_${name}_title`);
  document.body.append(
    element("header", {},
      element("h1", {}, say(`figures_${name}_title`)),
      element("a", { href: `?${query}`, hreflang: other, lang: other },
        say("figures_other_language"))),
    element("p", {}, say(`figures_${name}_lead`)),
    element("main", { class: name }, ...parts));
  try {
    await Promise.all(workers.map((worker) => ask(worker, { load: modules })));
    await begin();
  } catch (error) {
    fail(error);
  }
}
