"use strict";
// One point of one sphere: its N, its L and their cosine.

const scene = {
  spheres: [{ center: [0, 0, 3], radius: 1, color: [226, 74, 60] }],
  ambient: 0.2,
  points: [{ intensity: 0.8, position: [0.8, 0.85, 2] }],
  directionals: [],
};
const [light] = scene.points;
const reach = { x: [-1.6, 1.6], y: [-1.6, 1.6], z: [1, 6] };
let probe = [355, 195]; // column, row
let here = null; // the module

const main = picture(say("figures_cosine_picture"));
main.frame.classList.add("still", "grab");
main.over.classList.add("overlay");

// The lines over the picture.
const lines = Object.fromEntries(["to-light", "n", "l"].map((name) =>
  [name, element("line", { class: name })]));
const arc = element("polyline", { class: "arc" });
const dot = element("circle", { class: "point", r: 6 });
const letters = Object.fromEntries(["N", "L", "P", "α"].map((letter) =>
  [letter, element("text", { "text-anchor": "middle" }, letter)]));
const drawn = element("g", {}, ...Object.values(lines), arc, dot, ...Object.values(letters));
main.over.append(drawn);
const handle = sun(main.over);
handle.drawn.classList.add("grab");
handle.drawn.style.pointerEvents = "auto";

// --- vectors ---------------------------------------------------------------------------------------

const plus = (a, b, scale = 1) => a.map((x, i) => x + scale * b[i]);
const scaled = (a, scale) => a.map((x) => scale * x);
// Where the camera of fos/render.hpp sees a point: the viewport is 1 × 1, and 1 away.
const project = ([x, y, z]) => [300 + (600 * x) / z, 299 - (600 * y) / z];
const unproject = (column, row, z) => [((column - 300) * z) / 600, ((299 - row) * z) / 600, z];

function setLine(line, from, to) {
  const [x1, y1] = project(from);
  const [x2, y2] = project(to);
  for (const [name, value] of Object.entries({ x1, y1, x2, y2 })) line.setAttribute(name, value);
}
function setLetter(letter, x, y) {
  letters[letter].setAttribute("x", x);
  letters[letter].setAttribute("y", y + 7);
}
// Beside the line from P along a direction, on the side away from another.
function setBeside(letter, P, along, other) {
  const [[px, py], [x, y], [ox, oy]] = [P, plus(P, along, 0.45), plus(P, other, 0.45)].map(project);
  const [dx, dy] = [x - px, y - py];
  const side = dx * (oy - py) > dy * (ox - px) ? 1 : -1;
  const far = 20 / Math.max(1, Math.hypot(dx, dy));
  setLetter(letter, x + side * far * dy, y - side * far * dx);
}

// --- the numbers -----------------------------------------------------------------------------------

const table = element("table");
const cosineWords = element("p", { class: "verdict" });
const sentence = element("p", { role: "status" });

function look() {
  const numbers = numbersOf(scene);
  const at = here.numbers_at(numbers.length);
  new Float64Array(here.memory.buffer, at, numbers.length).set(numbers);
  here.show();
  const place = here.look(...probe);
  if (place === 0) return null;
  const seen = [...new Float64Array(here.memory.buffer, place, 13)];
  return { P: seen.slice(0, 3), N: seen.slice(3, 6), L: seen.slice(6, 9),
    NL: seen[9], lengthN: seen[10], lengthL: seen[11], I: seen[12] };
}

function tell(seen) {
  drawn.style.display = seen ? "" : "none";
  table.hidden = cosineWords.hidden = !seen;
  if (!seen) {
    sentence.textContent = say("figures_cosine_miss");
    return;
  }
  const { P, N, L, NL, lengthN, lengthL, I } = seen;
  const cosine = NL / (lengthN * lengthL);
  const angle = Math.acos(Math.max(-1, Math.min(1, cosine)));
  table.replaceChildren(...[
    ["", "P", vector(P)], ["key-n", "N", vector(N)], ["key-l", "L", vector(L)],
    ["", "⟨N,L⟩", decimals(NL)], ["", "|N|", decimals(lengthN)], ["", "|L|", decimals(lengthL)],
    ["", `${say("figures_angle")} α`, say("figures_degrees", decimals((angle * 180) / Math.PI, 1))],
  ].map(([kind, name, value]) =>
    element("tr", {}, element("th", { class: kind }, name), element("td", {}, value))));
  cosineWords.textContent = `cos α = ⟨N,L⟩ / (|N| |L|) = ${decimals(NL)} / ` +
    `(${decimals(lengthN)} · ${decimals(lengthL)}) = ${decimals(cosine)}`;
  sentence.textContent = NL > 0
    ? say("figures_cosine_lit", decimals(light.intensity, 2), decimals(cosine),
      decimals(light.intensity * cosine), decimals(scene.ambient, 2), decimals(I))
    : say("figures_cosine_behind", decimals(scene.ambient, 2));

  const toLight = scaled(L, 1 / lengthL);
  setLine(lines.n, P, plus(P, N, 0.6));
  setLine(lines.l, P, plus(P, toLight, 0.6));
  setLine(lines["to-light"], P, light.position);
  const between = (share) => { // on the circle from N to L around P
    const [a, b] = [Math.sin((1 - share) * angle), Math.sin(share * angle)];
    const way = angle < 1e-3 ? N : plus(scaled(N, a / Math.sin(angle)), toLight, b / Math.sin(angle));
    return plus(P, way, 0.3);
  };
  arc.setAttribute("points",
    [...Array(25).keys()].map((i) => project(between(i / 24)).join(",")).join(" "));
  const [column, row] = project(P);
  dot.setAttribute("cx", column);
  dot.setAttribute("cy", row);
  setBeside("N", P, N, toLight);
  setBeside("L", P, toLight, N);
  setLetter("P", column - 16, row + 14);
  const [ax, ay] = project(between(0.5));
  const out = 1 + 20 / Math.max(10, Math.hypot(ax - column, ay - row));
  setLetter("α", column + out * (ax - column), row + out * (ay - row));
}

// --- light and point -------------------------------------------------------------------------------

const place = ([min, max]) => ({ min, max, step: 0.01, value: 0 });
const controls = {
  intensity: slider(say("figures_intensity"), { min: 0, max: 1, step: 0.01, value: 0 },
    (i) => { light.intensity = i; update(); }),
  ...Object.fromEntries(["x", "y", "z"].map((axis, i) =>
    [axis, slider(say(`figures_${axis}`), place(reach[axis]), (value) => {
      light.position[i] = value;
      update();
    })])),
};
const redraw = drawing(() => draw(main.canvas, "combined", numbersOf(scene)));

function update() {
  const [x, y, z] = light.position;
  const set = { intensity: light.intensity, x, y, z };
  for (const [name, value] of Object.entries(set)) controls[name].set(value);
  handle.move(...project(light.position));
  tell(look());
  redraw();
}
function moveLight(x, y, z) {
  light.position = [within(x, reach.x), within(y, reach.y), within(z, reach.z)];
  update();
}
function movePoint(column, row) {
  probe = [column, row].map((at) => Math.round(Math.max(0, Math.min(599, at))));
  tell(look());
}

onDrag(main.over, handle.drawn, (x, y, event) => {
  event.stopPropagation(); // P stays
  moveLight(...unproject(x, y, light.position[2]));
}, (x, y, event) => event.stopPropagation());
onDrag(main.over, main.frame, movePoint, movePoint);
onKeys(main.frame, (x, y, z, shift) => {
  const [px, py, pz] = light.position;
  if (shift || z !== 0) moveLight(px + 0.05 * x, py + 0.05 * y, pz + 0.1 * z);
  else movePoint(probe[0] + 4 * x, probe[1] - 4 * y);
});

start("cosine", [main.whole,
  element("div", { class: "controls" }, table, cosineWords, sentence,
    group(say("figures_point"), ...Object.values(controls).map(({ row }) => row))),
], async () => {
  here = await moduleHere("combined");
  update();
});
