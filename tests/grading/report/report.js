// Sorting and filtering of the class's table. Without it the page shows the same.
(() => {
  "use strict";
  const table = document.getElementById("class");
  if (!table) return;
  const body = table.tBodies[0];
  const rows = [...body.rows];
  const collator = new Intl.Collator(document.documentElement.lang, { numeric: true });
  const value = (row, column) => row.cells[column].dataset.sort;

  // Where there is nothing to compare, at the end, whichever the direction; ties stay as they were.
  const compare = (a, b, numeric, direction) => {
    if (a === "" || b === "") return (a === "") - (b === "");
    return direction * (numeric ? a - b : collator.compare(a, b));
  };
  const sort = (heading) => {
    const column = heading.cellIndex;
    const numeric = heading.classList.contains("number");
    // Names begin at A, marks with the best.
    const was = heading.getAttribute("aria-sort");
    const up = was ? was === "descending" : !numeric;
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", up ? "ascending" : "descending");
    rows.sort((a, b) => compare(value(a, column), value(b, column), numeric, up ? 1 : -1));
    body.append(...rows);
  };
  for (const button of table.tHead.querySelectorAll("button")) {
    button.addEventListener("click", () => sort(button.closest("th")));
  }

  // Accents do not count, nor does upper case.
  const plain = (words) =>
    words.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase().replace(/ς/g, "σ");
  const words = new Map(rows.map((row) => [row, plain(row.dataset.words)]));
  const box = document.getElementById("filter");
  const shown = document.getElementById("shown");
  const filter = () => {
    const wanted = plain(box.value).split(/\s+/).filter(Boolean);
    let count = 0;
    for (const row of rows) {
      row.hidden = !wanted.every((word) => words.get(row).includes(word));
      if (!row.hidden) ++count;
    }
    shown.textContent = shown.dataset.pattern.replace("{0}", count).replace("{1}", rows.length);
  };
  box.addEventListener("input", filter);
  for (const button of document.querySelectorAll("button[data-filter]")) {
    button.addEventListener("click", () => {
      box.value = button.dataset.filter;
      filter();
      box.scrollIntoView({ block: "nearest" });
      box.focus();
    });
  }
  document.getElementById("filter-box").hidden = false;
  filter();
})();
