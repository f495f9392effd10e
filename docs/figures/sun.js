"use strict";
// A point light that moves away, beside the directional light that it becomes.

const toward = [1, 4, 4];
const length = Math.hypot(...toward);
let exponent = 1; // of 10, its distance
let suffix = "";

const lit = (lights) => numbersOf({ ...slides(), points: [], directionals: [], ...lights });
const views = comparison([say("figures_point"), say("figures_directional")], () => {
  const position = toward.map((x) => (x / length) * 10 ** exponent);
  return [
    [`combined${suffix}`, lit({ points: [{ intensity: 0.7, position }] })],
    [`combined${suffix}`, lit({ directionals: [{ intensity: 0.7, direction: toward }] })],
  ];
});
const digits = (number) => [...String(number)].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).join("");
const scientific = (number) => {
  const [mantissa, power] = number.toExponential(1).split("e");
  return number < 1000 ? decimals(number, 1) : `${mantissa} · 10${digits(Number(power))}`;
};
const distance = slider(say("figures_sun_distance"),
  { min: 0.5, max: 20, step: 0.1, value: exponent, show: (x) => scientific(10 ** x) },
  (x) => { exponent = x; views.update(); });
const precision = choice(say("figures_sun_precision"), [
  option("", say("figures_double")), option("_float", say("figures_float")),
], (value) => { suffix = value; views.update(); });

start("sun", [
  element("div", { class: "wide" }, distance.row, precision, views.verdict), views.whole],
views.update);
