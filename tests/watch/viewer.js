"use strict";

// Text comes from the student's program and compiler too: it is only ever set as text.
const at = (id) => document.getElementById(id);
const fill = (text, ...values) => text.replace(/\{(\d)\}/g, (_, i) => values[i]);
const lensScale = 9; // 15 pixels in each direction, as large as this
const kinds = ["yours", "expected", "difference"];

let view = null; // the newest check
let shown = null; // the newest that has pictures
let panels = []; // a canvas, its lens and its mark for each kind
let values = new Map(); // by a pixel's index: six channels before rounding
let parts = new Set(); // those that have been asked for
let chosen = { column: 0, row: 0 };

// --- loading: from the file system a page may load scripts, and nothing else ---------------------

function load(file) {
  const script = document.createElement("script");
  script.src = file;
  script.onload = script.onerror = () => script.remove();
  document.head.append(script);
}

// The newest check by its id, from a tiny file; the large one is loaded when it is another.
window.fosNow = (id, stage) => {
  if (view === null || view.id !== id) load(`${stage}-view.js?${id}`);
};

window.fosView = (next) => {
  if (view !== null && view.id === next.id) return;
  const other = view === null || view.stage !== next.stage;
  view = next;
  if (next.outcome === "no_build" && shown !== null && !other) {
    showWords();
  } else {
    showPictures(other);
  }
};

window.fosValues = ({ id, data }) => {
  if (shown === null || shown.id !== id) return;
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  const numbers = new DataView(bytes.buffer);
  for (let i = 0; i < bytes.length; i += 28) {
    const channels = [0, 1, 2, 3, 4, 5].map((c) => numbers.getFloat32(i + 4 + 4 * c, true));
    values.set(numbers.getUint32(i, true), channels);
  }
  showPixel();
};

setInterval(() => load(`view-now.js?${Date.now()}`), 400);
load("view-now.js");

// --- words -----------------------------------------------------------------------------------------

function showWords() {
  const { texts } = view;
  document.documentElement.lang = view.language;
  document.title = `${texts[view.outcome]} · ${view.stage}`;
  at("title").textContent = `${view.stage} · ${view.name}`;
  at("verdict").textContent = texts[view.outcome] + (view.summary ? ` · ${view.summary}` : "");
  at("verdict").className = view.outcome;
  at("main").hidden = false;
  at("older").hidden = shown === view;
  at("older").textContent = shown === null ? (view.outcome === "no_build" ? "" : texts.no_frame) : texts.older;
  at("first").textContent = view.first;
  at("advice").textContent = view.advice;
  at("list").replaceChildren(
    ...view.list.map(({ mark, words }) => {
      const line = document.createElement("li");
      const sign = document.createElement("span");
      sign.className = mark === "✓" ? "good" : mark === "✗" ? "bad" : "";
      sign.textContent = mark;
      line.append(sign, words);
      return line;
    }),
  );
  for (const [id, text] of [["help", "help"], ["head-bytes", "bytes"], ["head-linear", "linear"],
    ["row-yours", "yours"], ["row-expected", "expected"], ["explain-words", "explain"],
    ["copy", "copy"]]) at(id).textContent = texts[text];
}

// --- pictures --------------------------------------------------------------------------------------

async function showPictures(other) {
  const mine = view;
  if (mine.pictures === null) {
    shown = null;
    at("pictures").hidden = true;
    showWords();
    return;
  }
  const images = await Promise.all(mine.pictures.urls.map(decoded));
  if (view !== mine) return; // a newer one has come
  shown = mine;
  values = new Map();
  parts = new Set();
  const { width, height, scene, difference } = mine.pictures;
  const sameSize = panels.length > 0 && panels[0].canvas.width === width && panels[0].canvas.height === height;
  if (!sameSize) makePanels(width, height);
  panels.forEach(({ canvas, caption }, i) => {
    canvas.getContext("2d").drawImage(images[i], 0, 0);
    const words = [`${mine.texts.yours} · ${scene}`, mine.texts.expected, difference];
    caption.textContent = words[i];
    canvas.setAttribute("aria-label", words[i]);
  });
  at("pictures").hidden = false;
  showWords();
  // Where one looks stays, as long as it is the same picture.
  if (other || !sameSize || !at("panels").dataset.moved) choose(mine.pictures.column, mine.pictures.row);
  else showPixel();
}

async function decoded(url) {
  const image = new Image();
  image.src = url;
  await image.decode();
  return image;
}

function makePanels(width, height) {
  delete at("panels").dataset.moved;
  panels = kinds.map((kind) => {
    const make = (name, parent, className) => {
      const element = document.createElement(name);
      if (className) element.className = className;
      parent.append(element);
      return element;
    };
    const figure = document.createElement("figure");
    const caption = make("figcaption", figure);
    const picture = make("div", figure, "picture");
    const canvas = make("canvas", picture);
    const mark = make("div", picture, "mark");
    const lens = make("canvas", figure, "lens");
    canvas.width = width;
    canvas.height = height;
    canvas.id = kind;
    lens.width = lens.height = 15 * lensScale;
    canvas.getContext("2d", { willReadFrequently: true });
    canvas.addEventListener("click", (event) => {
      const box = canvas.getBoundingClientRect();
      moved(Math.floor(((event.clientX - box.left) / box.width) * width),
        Math.floor(((event.clientY - box.top) / box.height) * height));
    });
    return { figure, caption, canvas, mark, lens };
  });
  at("panels").replaceChildren(...panels.map(({ figure }) => figure));
}

// --- a pixel ---------------------------------------------------------------------------------------

function moved(column, row) {
  at("panels").dataset.moved = "yes";
  choose(column, row);
}

function choose(column, row) {
  const { width, height } = shown.pictures;
  const within = (number, size) => Math.min(size - 1, Math.max(0, number));
  chosen = { column: within(column, width), row: within(row, height) };
  showPixel();
}

function showPixel() {
  const { width, height, rowsOfPart, parts: there, explain } = shown.pictures;
  const { column, row } = chosen;
  const bytes = panels.map(({ canvas, mark, lens }) => {
    mark.style.left = `${((column + 0.5) / width) * 100}%`;
    mark.style.top = `${((row + 0.5) / height) * 100}%`;
    const glass = lens.getContext("2d");
    glass.imageSmoothingEnabled = false;
    glass.clearRect(0, 0, lens.width, lens.height);
    glass.drawImage(canvas, column - 7, row - 7, 15, 15, 0, 0, lens.width, lens.height);
    for (const [color, out] of [["#000", 0.5], ["#fff", 1.5]]) {
      glass.strokeStyle = color;
      glass.strokeRect(7 * lensScale - out, 7 * lensScale - out, lensScale + 2 * out, lensScale + 2 * out);
    }
    return [...canvas.getContext("2d").getImageData(column, row, 1, 1).data.slice(0, 3)];
  });
  const part = Math.floor(row / rowsOfPart);
  if (there.includes(part) && !parts.has(part)) {
    parts.add(part);
    load(`${shown.stage}-view-${part}.js?${shown.id}`);
  }
  const linear = values.get(row * width + column);
  const isRight = !linear && bytes[2].every((channel) => channel === 255);
  const { texts } = view;
  at("place").textContent = fill(texts.pixel, column, row);
  at("judged").textContent = isRight ? texts.right : texts.wrong;
  at("judged").className = isRight ? "right" : "wrong";
  at("yours-bytes").textContent = bytes[0].join(" ");
  at("expected-bytes").textContent = bytes[1].join(" ");
  const inWords = (channels) => channels.map((c) => String(Number(c.toPrecision(7)))).join(", ");
  at("yours-linear").textContent = linear ? inWords(linear.slice(0, 3)) : "";
  at("expected-linear").textContent = linear ? inWords(linear.slice(3)) : "";
  at("head-linear").hidden = !linear;
  at("explain").textContent = fill(explain, column, row);
}

at("panels").addEventListener("keydown", (event) => {
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const step = steps[event.key];
  if (event.altKey || event.ctrlKey || event.metaKey || shown === null) return;
  if (step) moved(chosen.column + step[0] * (event.shiftKey ? 10 : 1), chosen.row + step[1] * (event.shiftKey ? 10 : 1));
  else if (event.key === "Home") moved(shown.pictures.column, shown.pictures.row);
  else return;
  event.preventDefault();
});

at("copy").addEventListener("click", async () => {
  const line = at("explain");
  try {
    await navigator.clipboard.writeText(line.textContent);
  } catch {
    getSelection().selectAllChildren(line); // where a page may not use the clipboard
    document.execCommand("copy");
  }
  at("copy").textContent = view.texts.copied;
  setTimeout(() => (at("copy").textContent = view.texts.copy), 1500);
});
