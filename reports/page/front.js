// SPDX-License-Identifier: MIT
// The first page's heat map and overview: both show any evaluation, from the same data. page.js goes before.
// An evaluation's cells in a line of the overview, by order: [text, class, address]; null where it has none.
function cellsOf(data, line, name) {
  const column = data.evaluations.indexOf(name), orders = line.cells[column];
  if (!orders) return null;
  const ids = data.ids[line.regime][column];
  return orders.map(([text, css], order) => text === undefined ? [] : [text, css, `${line.page}#${ids[order]}`]);
}

// Colours by digits that are right, with the same steps as heat_class of the program.
function heatClass(text, css) {
  if (css === "ill") return css;
  const digits = text.startsWith("all") ? 16 : Number.parseFloat(text) || 0;
  return [digits >= 12 ? "e0" : digits >= 8 ? "e1" : digits >= 4 ? "e2" : digits >= 1 ? "e3" : "e4", ...css.split(" ").slice(1)].join(" ");
}

// Columns and lines of the heat map in which nothing was measured are left out.
function hideEmpty(table, cells) {
  const columns = new Set(), rows = new Set();
  for (const {link} of cells)
    if (link.textContent !== "·") {
      columns.add(link.parentElement.cellIndex);
      rows.add(link.closest("tr"));
    }
  for (const row of table.rows) {
    if (row.parentElement === table.tBodies[0]) row.hidden = !rows.has(row);
    for (const cell of [...row.cells].slice(1)) cell.hidden = !columns.has(cell.cellIndex);
  }
}

// The heat map of another evaluation or order: from the overview's data, since each of its cells leads to one line.
function heatMap(data, lines, filters) {
  const form = document.querySelector('[data-filters="heat"]'), {evaluation, order} = form.elements;
  addChoices(evaluation, data.evaluations);
  const table = document.querySelector('[data-table="heat"]');
  const cells = [...table.querySelectorAll("td > a")].map((link) => ({
    link,
    line: lines[Number(link.getAttribute("href").slice(2))],
    shown: [link.textContent, link.parentElement.className],
  }));
  // A line that is filtered out cannot be led to.
  for (const {link, line} of cells)
    link.addEventListener("click", () => {
      if (!line.row.hidden) return;
      for (const name of ["formula", "regime", "evaluation"]) {
        filters.elements[name].value = "";
        filters.elements[name].dispatchEvent(new Event("change"));
      }
    });
  rememberFilters(form, () => {
    for (const {link, line, shown} of cells) {
      let [text, css] = shown;
      if (evaluation.value !== "" || order.value !== "") {
        const name = evaluation.value === "" ? line.lead : evaluation.value;
        const [figure, looks] = cellsOf(data, line, name)?.[Number(order.value)] ?? [];
        text = figure === undefined ? "·" : figure.split(" ")[0] + (looks.includes("broken") ? " ✗" : "");
        css = figure === undefined ? "" : heatClass(text, looks);
      }
      link.textContent = text;
      link.parentElement.className = css;
    }
    hideEmpty(table, cells);
    const what = ["values", "gradients", "Hessians"][Number(order.value)];
    document.querySelector("[data-heat]").textContent = `of ${what} in ${evaluation.value === "" ? "the recommended evaluation" : evaluation.value}`;
  });
}

const overview = document.querySelector('[data-table="overview"]');
if (overview) {
  const data = JSON.parse(document.getElementById("overview-data").textContent);
  const form = document.querySelector('[data-filters="overview"]');
  const lines = [...overview.tBodies[0].rows].map((row, place) => ({
    row,
    formula: row.cells[0].textContent,
    page: row.cells[0].firstElementChild.getAttribute("href"),
    regime: row.cells[1].textContent,
    lead: row.cells[2].textContent,
    cells: data.cells[place],
    blank: row.hidden,
    shown: null,
  }));
  addChoices(form.elements.formula, lines.map((line) => line.formula));
  addChoices(form.elements.regime, lines.map((line) => line.regime));
  addChoices(form.elements.evaluation, data.evaluations);

  const showEvaluation = (line, name) => {
    // A line's first cells are kept only when they are replaced: keeping all lines would take longer than all else here.
    if (name === "" && line.shown === null) return !line.blank;
    const cells = [...line.row.cells].slice(2);
    if (line.shown === null) line.shown = cells.map((cell) => [cell.className, cell.innerHTML]);
    if (name === "") {
      cells.forEach((cell, i) => ([cell.className, cell.innerHTML] = line.shown[i]));
      return !line.blank;
    }
    const orders = cellsOf(data, line, name);
    if (!orders) return false;
    cells.forEach((cell) => ((cell.textContent = ""), (cell.className = "")));
    cells[0].textContent = name;
    orders.forEach(([text, css, address], order) => {
      if (text === undefined) return;
      const link = document.createElement("a");
      link.textContent = text;
      link.href = address;
      cells[order + 1].className = css;
      cells[order + 1].append(link);
    });
    return true;
  };
  rememberFilters(form, () => {
    const {formula, regime, evaluation, order} = form.elements;
    let count = 0;
    for (const line of lines) {
      const shown = (formula.value === "" || formula.value === line.formula) && (regime.value === "" || regime.value === line.regime) &&
        showEvaluation(line, evaluation.value);
      if (line.row.hidden === shown) line.row.hidden = !shown;
      count += shown;
    }
    for (const row of overview.rows)
      for (const o of [0, 1, 2]) row.cells[3 + o].hidden = order.value !== "" && Number(order.value) !== o;
    document.querySelector("[data-shown]").textContent = evaluation.value === "" ? "of the recommended evaluation" : `of ${evaluation.value}`;
    const all = evaluation.value === "" ? lines.filter((line) => !line.blank).length : lines.length;
    form.querySelector("output").textContent = `${count} of ${all} lines`;
  });
  heatMap(data, lines, form);
}
