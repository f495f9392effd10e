"use strict";
// The lecture's scene: its lights moved, turned, dimmed.

const scene = slides();
const [light] = scene.points;
const [sunlight] = scene.directionals;

const main = picture(say("figures_lights_picture"));
main.frame.classList.add("still");
const handle = lightHandle(main, light, update);

// From above: x to the right, z upwards.
const map = element("svg", { class: "map", viewBox: "-5 -7.2 10 9", role: "img",
  "aria-label": say("figures_map") });
map.append(element("polygon", { class: "camera", points: "0,0 -3.5,-7 3.5,-7" }),
  ...scene.spheres.slice(0, 3).map(({ center, radius, color }) =>
    element("circle", { cx: center[0], cy: -center[2], r: radius, fill: `rgb(${color})` })));
const arrow = element("g", { class: "arrow grab" },
  element("line", { x1: 0, y1: 0, x2: 1.7, y2: 0 }),
  element("polygon", { points: "2.1,0 1.5,0.25 1.5,-0.25" }),
  element("circle", { cx: 1.8, cy: 0, r: 0.6, fill: "transparent" }));
const mapLight = sun(map);
map.append(arrow);
mapLight.drawn.classList.add("grab");
const arrowAt = [3.2, 0.2]; // out of the spheres' way: it stands for a direction only

const words = element("pre");
const degrees = (radians) => (radians * 180) / Math.PI;

// Angles of the directional light, in degrees, and back.
const azimuth = () => degrees(Math.atan2(sunlight.direction[2], sunlight.direction[0]));
const elevation = () =>
  degrees(Math.atan2(sunlight.direction[1], Math.hypot(sunlight.direction[0], sunlight.direction[2])));
function turn(around, up) {
  const [a, e] = [(around * Math.PI) / 180, (up * Math.PI) / 180];
  sunlight.direction = [Math.cos(e) * Math.cos(a), Math.sin(e), Math.cos(e) * Math.sin(a)].map(round);
}

const angle = (x) => say("figures_degrees", decimals(x, 0));
const brightness = { min: 0, max: 1, step: 0.01, value: 0 };
const place = ([min, max]) => ({ min, max, step: 0.01, value: 0 });
const controls = {
  point: slider(say("figures_intensity"), brightness, (i) => { light.intensity = i; update(); }),
  x: slider(say("figures_x"), place(range.x), (x) => { light.position[0] = x; update(); }),
  y: slider(say("figures_y"), place(range.y), (y) => { light.position[1] = y; update(); }),
  z: slider(say("figures_z"), place(range.z),
    (z) => { light.position[2] = z; update(); }),
  directional: slider(say("figures_intensity"), brightness,
    (i) => { sunlight.intensity = i; update(); }),
  azimuth: slider(say("figures_azimuth"), { min: -180, max: 180, step: 1, value: 0, show: angle },
    (a) => { turn(a, elevation()); update(); }),
  elevation: slider(say("figures_elevation"), { min: -89, max: 89, step: 1, value: 0, show: angle },
    (e) => { turn(azimuth(), e); update(); }),
  ambient: slider(say("figures_intensity"), brightness, (i) => { scene.ambient = i; update(); }),
};
const again = element("button", { type: "button" }, say("figures_reset"));

const redraw = drawing(() => draw(main.canvas, "combined", numbersOf(scene)));

function update() {
  const [x, y, z] = light.position;
  handle.show();
  mapLight.move(x, -z, 0.025);
  arrow.setAttribute("transform",
    `translate(${arrowAt[0]} ${arrowAt[1]}) rotate(${-azimuth()})`);
  const set = { point: light.intensity, x, y, z, directional: sunlight.intensity,
    azimuth: azimuth(), elevation: elevation(), ambient: scene.ambient };
  for (const [name, value] of Object.entries(set)) controls[name].set(value);
  words.textContent =
    `light { type = ambient      intensity = ${scene.ambient} }\n` +
    `light { type = point        intensity = ${light.intensity}  position  = (${light.position.join(", ")}) }\n` +
    `light { type = directional  intensity = ${sunlight.intensity}  direction = (${sunlight.direction.join(", ")}) }`;
  redraw();
}

onDrag(map, mapLight.drawn, (x, y) => handle.move(x, light.position[1], -y));
onDrag(map, arrow, (x, y) => {
  turn(degrees(Math.atan2(arrowAt[1] - y, x - arrowAt[0])), elevation());
  update();
});
again.addEventListener("click", () => {
  const { points, directionals, ambient } = slides();
  Object.assign(light, points[0]);
  Object.assign(sunlight, directionals[0]);
  scene.ambient = ambient;
  update();
});

start("lights", [main.whole,
  element("div", { class: "controls" },
    group(say("figures_point"), ...["point", "x", "y", "z"].map((name) => controls[name].row)),
    group(say("figures_directional"),
      ...["directional", "azimuth", "elevation"].map((name) => controls[name].row)),
    group(say("figures_ambient"), controls.ambient.row),
    element("figure", {}, map, element("figcaption", {}, say("figures_map")))),
  element("div", { class: "wide" }, again,
    element("details", { open: "" }, element("summary", {}, say("figures_scene")), words)),
], update);
