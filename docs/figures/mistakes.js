"use strict";
// A mistake switched on: its picture beside the right one.

const catalogue = JSON.parse(document.getElementById("mistakes").textContent);
const scene = slides();
const size = 400; // the tracer that makes mistakes takes twice the time of a solution
const [light] = scene.points;

// Of the last stage that it can be made in: there is all the light there can be.
const termsOf = { F: 0, A: 1, P: 3, D: 5, C: 7 };
const numberOf = (name) => catalogue.findIndex(({ id }) => id === name);
let chosen = numberOf(query.get("mistake"));
if (chosen < 0) chosen = numberOf("L_not_normalised");

const views = comparison(
  [say("figures_mistakes_right"), say("figures_mistakes_wrong")],
  () => {
    const terms = termsOf[catalogue[chosen].stages.at(-1)];
    return [0, chosen + 1].map((mistake) =>
      ["mistakes", numbersOf(scene, { size, mistake, terms })]);
  }, size);
const handle = lightHandle(views.a, light, update);
const question = element("p");
const options = (in_lecture_3) => catalogue.flatMap(({ id, stages }, i) =>
  (stages === "F") === in_lecture_3 ? [option(i, say(`mistake_${id}`))] : []);
const select = choice(say("figures_mistake"), [
  element("optgroup", { label: say("figures_mistakes_hits") }, ...options(true)),
  element("optgroup", { label: say("figures_mistakes_light") }, ...options(false)),
], (i) => { chosen = Number(i); update(); });
select.querySelector("select").value = chosen;

function update() {
  question.textContent = say(`mistake_${catalogue[chosen].id}_question`);
  handle.show();
  views.update();
}

start("mistakes", [
  element("div", { class: "wide" }, select, views.verdict, question), views.whole], update);
