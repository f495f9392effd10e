"use strict";
// The same solution in float and in double, on a floor that grows.

let radius = 5000;
let stage = "flat_color";

const views = comparison([say("figures_float"), say("figures_double")], () => {
  const numbers = numbersOf({ ...slides(), spheres: spheres(radius) });
  return [[`${stage}_float`, numbers], [stage, numbers]];
});
const stages = choice(say("figures_floor_formula"), [
  option("flat_color", say("figures_floor_slides")),
  option("combined", say("figures_floor_careful")),
], (name) => { stage = name; views.update(); });
const size = slider(say("figures_floor_radius"),
  { min: 1, max: 8, step: 0.1, value: Math.log10(radius),
    show: () => String(radius) },
  (exponent) => {
    radius = Number((10 ** exponent).toPrecision(2));
    size.set(exponent);
    views.update();
  });

start("floor", [
  element("div", { class: "wide" }, size.row, stages, views.verdict), views.whole], views.update);
