// SPDX-License-Identifier: MIT
// The script of a page of cells: it answers clicks on cells, lists every figure, and draws curves and times by D3.
// One function, because it waits: modules may wait by themselves, but browsers load none from a folder on disk.
"use strict";
(async () => {

// Cells are kept packed: a fifth of their text.
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
}
const page = JSON.parse(await unpacked(document.getElementById("cells-data").textContent));
const byId = new Map(page.rows.map((row) => [row.id, row]));
const orderNames = ["value", "gradient", "Hessian"];
const answer = document.getElementById("answer");

function element(name, text, attributes = {}) {
  const made = document.createElement(name);
  if (text !== undefined && text !== null) made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

function whereOf(row) {
  const place = row.place ? `, ${row.place}` : "";
  return location.pathname.includes("/formulas/") ? row.regime + place : `${row.subject}${place}`;
}

// Lines that a terminal takes: the program's answer at the worst input, and the measurement again.
function commandsOf(row) {
  const lines = [];
  const worst = row.worst;
  if (worst.element) {
    const input = {element: worst.element, point: worst.point};
    if (worst.parameters) input.parameters = worst.parameters;
    // As many derivatives as the measurement asked for, of those that the evaluation has.
    const order = Math.min(worst.order, Math.max(...page.rows.filter((other) => other.evaluation === row.evaluation).map((other) => other.order)));
    lines.push(`echo '${JSON.stringify(input)}' | cageproof eval --formula ${row.subject} --evaluation ${row.evaluation} --order ${order} --scalar ${row.scalar}${row.subject.startsWith("quad.") ? " --allow-invalid-quads" : ""}`);
  }
  lines.push(`cageproof replay ${row.file} --line ${row.line}`);
  return lines;
}

function meaningOf(row) {
  if (row.ill_posed) return `ill-posed here: a result without a right digit would score at most ${row.total_loss}, which the bound of ${row.bound} allows`;
  if (row.verdict === "not promised") return "not promised";
  if (row.verdict === "undecided") return "undecided: more samples would decide";
  return row.verdict === "kept" ? "promise kept" : "promise broken";
}

function answerOf(row) {
  const list = element("dl");
  const say = (what, text) => {
    if (text === undefined || text === null || text === "") return;
    list.append(element("dt", what), element("dd", text));
  };
  const word = row.certified ? "certified" : "largest found";
  say("error", `${row.text} ${row.unit === "conditioned" ? "conditioned units" : row.unit}, ${word}${row.bound ? `; bound ${row.bound}` : ""}`);
  say("compared", page.checks?.[row.check]);
  say("verdict", meaningOf(row));
  say("reason", page.reasons[row.reason]);
  const samples = [`${row.samples.toLocaleString("en")} measured`];
  for (const [key, text] of [["nonfinite", "not finite"], ["without_truth", "without a truth"], ["unreached", "whose truth was not reached"], ["declined", "declined"]])
    if (row[key]) samples.push(`${row[key].toLocaleString("en")} ${text}`);
  say("samples", samples.join(", "));
  if (row.p999) say("sampled", `99.9 % up to ${row.p999}, half up to ${row.median}`);
  const worst = row.worst;
  if (worst) {
    say("worst input", `sample ${worst.sample}${worst.parameter && worst.parameter !== "0" ? `, parameter ${worst.parameter}` : ""}: error ${worst.error}`);
    if (worst.truth) {
      say("furthest entry", worst.entry);
      say("found", worst.found);
      say("truth", worst.truth);
      say("digits right", `${worst.digits}, of the ${orderNames[row.order]} as a whole: its relative error is ${worst.relative}, norm-wise, whatever the conditioning`);
    }
  }
  const parts = [element("h2", `${row.subject}, ${row.evaluation ? row.evaluation + ", " : ""}${row.scalar}: ${row.check}, ${page.cage ?? row.regime}${row.place ? ", " + row.place : ""}, ${orderNames[row.order]}`), list];
  if (worst) {
    const input = [...(worst.element || []).map((corner, k) => `corner ${k}  ${corner.join(" ")}`), `point     ${worst.point.join(" ")}`];
    for (const [name, value] of Object.entries(worst.parameters || {})) input.push(`${name}  ${value}`);
    parts.push(element("pre", input.join("\n")));
    for (const line of commandsOf(row)) {
      const copy = element("div", null, {class: "copy"});
      const button = element("button", "Copy", {type: "button"});
      button.addEventListener("click", () => copyText(line, button));
      copy.append(element("pre", line), button);
      parts.push(copy);
    }
  }
  return parts;
}

// Pages that are files have no clipboard in some browsers: the line is then selected, to be copied by hand.
function copyText(line, button) {
  const select = () => getSelection().selectAllChildren(button.previousSibling);
  if (!navigator.clipboard) return select();
  navigator.clipboard.writeText(line).then(() => (button.textContent = "Copied"), select);
}

function show(id) {
  const row = byId.get(id);
  if (!row) return;
  for (const cell of document.querySelectorAll("td.chosen")) cell.classList.remove("chosen");
  for (const link of document.querySelectorAll(`a[href="#${CSS.escape(id)}"]`)) link.parentElement.classList.add("chosen");
  const close = element("button", "Close", {type: "button", class: "close"});
  close.addEventListener("click", hide);
  answer.replaceChildren(close, ...answerOf(row));
  answer.hidden = false;
  answer.dataset.id = id;
  document.body.classList.add("answering");
}

function hide() {
  answer.hidden = true;
  document.body.classList.remove("answering");
}

const idOf = (link) => decodeURIComponent(link.hash.slice(1));
const cellLink = (target) => target.closest?.('td > a[href^="#"]');

document.addEventListener("focusin", (event) => {
  const link = cellLink(event.target);
  if (link) show(idOf(link));
});
addEventListener("hashchange", () => show(decodeURIComponent(location.hash.slice(1))));

// Arrows move to the next cell with a figure.
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") return hide();
  const step = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0]}[event.key];
  const link = cellLink(event.target);
  if (!step || !link) return;
  const cell = link.parentElement, rows = [...cell.closest("tbody").rows];
  let r = rows.indexOf(cell.parentElement), c = cell.cellIndex;
  for (;;) {
    (r += step[0]), (c += step[1]);
    const next = rows[r]?.cells[c];
    if (!next) return;
    if (next.firstElementChild?.matches("a") && !rows[r].hidden) {
      next.firstElementChild.focus();
      event.preventDefault();
      return;
    }
  }
});

// Every figure.
const all = document.querySelector('[data-table="all"]');
const lines = page.rows.map((row) => {
  const line = element("tr");
  line.append(element("th", row.check, {scope: "row"}), element("td", whereOf(row)), element("td", `${row.evaluation ? row.evaluation + ", " : ""}${row.scalar}`), element("td", orderNames[row.order]));
  const figure = element("td", null, {class: `n ${row.css}`});
  figure.append(element("a", row.text, {href: `#${row.id}`}));
  line.append(figure, element("td", row.unit), element("td", row.bound, {class: "n"}), element("td", row.ill_posed ? "ill-posed here" : row.verdict));
  for (const text of [row.max_relative, row.total_loss, row.p999, row.median, row.asked, row.samples, row.nonfinite, row.without_truth, row.unreached, row.declined]) line.append(element("td", text?.toLocaleString("en") ?? "", {class: "n"}));
  line.append(element("td", page.reasons[row.reason], {class: "reason"}));
  return {line, row, verdict: row.ill_posed ? "ill-posed here" : row.verdict, where: whereOf(row), evaluation: line.cells[2].textContent};
});
const filters = document.querySelector('[data-filters="all"]');
addChoices(filters.elements.check, lines.map((line) => line.row.check));
addChoices(filters.elements.where, lines.map((line) => line.where));
addChoices(filters.elements.evaluation, lines.map((line) => line.evaluation));
addChoices(filters.elements.verdict, lines.map((line) => line.verdict));
// As many as are read; the rest are there when asked for, so that the page opens at once.
const most = 200;
rememberFilters(filters, () => {
  const {check, where, evaluation, order, verdict} = filters.elements;
  const chosen = lines.filter((line) => (check.value === "" || check.value === line.row.check) && (where.value === "" || where.value === line.where) &&
    (evaluation.value === "" || evaluation.value === line.evaluation) && (order.value === "" || Number(order.value) === line.row.order) &&
    (verdict.value === "" || verdict.value === line.verdict));
  const output = filters.querySelector("output");
  const fill = (count) => {
    all.tBodies[0].replaceChildren(...chosen.slice(0, count).map((line) => line.line));
    output.textContent = `${Math.min(count, chosen.length)} of ${lines.length} rows `;
    if (count >= chosen.length) return;
    const more = element("button", `show all ${chosen.length}`, {type: "button"});
    more.addEventListener("click", () => fill(chosen.length));
    output.append(more);
  };
  fill(most);
});
all.hidden = false;

// Curves. How each looks is the program's choice, the same as in pictures for print.
// Pages of cages have no curves, and no D3.
const shapes = [["symbolCircle", 0], ["symbolSquare", 0], ["symbolTriangle", 0], ["symbolTriangle", 180], ["symbolDiamond", 0]];
const markPath = (style, size) => d3.symbol(d3[shapes[style.shape][0]], size)();
const turnOf = (style) => `rotate(${shapes[style.shape][1]})`;

const tip = element("div", null, {class: "tip", role: "status", hidden: ""});
document.body.append(tip);
function tipOn(selection, textOf) {
  const at = (event, datum) => {
    tip.textContent = textOf(datum);
    tip.hidden = false;
    const box = event.currentTarget.getBoundingClientRect();
    tip.style.left = `${Math.min(scrollX + box.right + 8, scrollX + document.documentElement.clientWidth - tip.offsetWidth - 8)}px`;
    tip.style.top = `${scrollY + box.top - tip.offsetHeight - 4}px`;
  };
  selection.on("pointerenter", at).on("focus", at).on("pointerleave blur", () => (tip.hidden = true));
}

// A short line with the looks of a series, for the legend.
function keyLine(colour, dash) {
  const key = d3.create("svg").attr("width", 30).attr("height", 12).attr("viewBox", "0 0 30 12").attr("aria-hidden", "true");
  key.append("line").attr("x1", 0).attr("x2", 30).attr("y1", 6).attr("y2", 6).attr("stroke", colour).attr("stroke-width", 2).attr("stroke-dasharray", dash || null);
  return key;
}

// Shows only one of the names, or all again. \param styles by name
function legend(parent, styles, svg) {
  const box = element("div", null, {class: "legend"});
  for (const [name, style] of styles) {
    const button = element("button", null, {type: "button", "aria-pressed": "false"});
    const key = keyLine(style.colour, style.dash);
    key.append("path").attr("d", markPath(style, 36)).attr("transform", `translate(15,6) ${turnOf(style)}`).attr("fill", style.filled ? style.colour : "var(--paper)").attr("stroke", style.colour);
    button.append(key.node(), document.createTextNode(name));
    button.addEventListener("click", () => {
      const alone = button.getAttribute("aria-pressed") === "true" ? null : name;
      for (const other of box.querySelectorAll("button")) other.setAttribute("aria-pressed", String(other === button && alone !== null));
      svg.selectAll("[data-series]").classed("dim", function () {
        return alone !== null && this.dataset.series !== alone;
      });
    });
    box.append(button);
  }
  parent.append(box);
  return box;
}

const powers = (scale, count) => {
  const [low, high] = scale.domain().map(Math.log10).sort((a, b) => a - b);
  const step = Math.max(1, Math.ceil((high - low) / count));
  return d3.range(Math.ceil(low / step) * step, high + 1e-9, step).map((e) => 10 ** e);
};
const powerText = (x) => `1e${Math.round(Math.log10(x))}`;
const low = 0.1, leftOfPanels = 62;
const heightOf = (y) => (y === "inf" || y === null ? Infinity : Number(y));

// \param infinite whether something that is not finite is drawn, at the upper edge
function axes(panel, x, y, width, height, title, labels, infinite) {
  const top = y.domain()[1], ticks = powers(y, 8).filter((tick) => !infinite || tick < 0.9 * top);
  if (infinite) ticks.push(top);
  const errorText = (tick) => (infinite && tick === top ? "inf" : powerText(tick));
  panel.append("g").attr("class", "grid").selectAll("line").data(ticks).join("line").attr("x2", width).attr("y1", y).attr("y2", y);
  panel.append("g").attr("class", "axis").attr("transform", `translate(0,${height})`).call(d3.axisBottom(x).tickValues(powers(x, 6)).tickFormat(powerText));
  panel.append("g").attr("class", "axis").call(d3.axisLeft(y).tickValues(ticks).tickFormat(labels ? errorText : () => ""));
  panel.append("text").attr("x", width / 2).attr("y", -8).attr("text-anchor", "middle").text(title);
}

function drawCurves(details) {
  const box = details.querySelector(".curves");
  if (box.childElementCount) return;
  const curves = (page.curves || []).filter((curve) => curve.regime === details.dataset.regime && curve.check === details.dataset.check);
  if (!curves.length) return;
  const xs = curves.flatMap((curve) => curve.x), ys = curves.flatMap((curve) => curve.y.map(heightOf)).filter(Number.isFinite);
  const top = 10 ** (Math.ceil(Math.log10(Math.max(100, ...ys))) + 1), width = 300, height = 230, left = leftOfPanels, gap = 22;
  const x = d3.scaleLog(d3.extent(xs), [0, width]), y = d3.scaleLog([low, top], [height, 0]);
  const svg = d3.create("svg").attr("viewBox", `0 0 ${left + 3 * (width + gap)} ${height + 66}`).attr("width", left + 3 * (width + gap)).attr("role", "img")
    .attr("aria-label", `Largest error against ${details.dataset.axis} in regime ${details.dataset.regime}`);
  const anyInfinite = curves.some((curve) => curve.y.some((error) => !Number.isFinite(heightOf(error))));
  let anyBound = false;
  orderNames.forEach((title, order) => {
    const panel = svg.append("g").attr("transform", `translate(${left + order * (width + gap)},24)`);
    axes(panel, x, y, width, height, title, order === 0, anyInfinite);
    const bounds = new Set(page.rows.filter((row) => row.regime === details.dataset.regime && row.check === "digits" && row.order === order && row.bound).map((row) => Number(row.bound)));
    for (const bound of bounds)
      if (bound > low && bound < top) {
        anyBound = true;
        tipOn(panel.append("line").attr("x2", width).attr("y1", y(bound)).attr("y2", y(bound)).attr("stroke", "#888888").attr("stroke-dasharray", "2 3").attr("stroke-width", 1.5), () => `promised digits: ${bound} units`);
      }
    for (const curve of curves.filter((one) => one.order === order)) {
      const name = `${curve.evaluation}, ${curve.scalar}`, style = curve.style;
      const points = curve.x.map((at, i) => ({at, error: heightOf(curve.y[i])}));
      const place = (point) => y(Number.isFinite(point.error) ? Math.min(Math.max(point.error, low), top) : top);
      const group = panel.append("g").attr("data-series", name);
      group.append("path").attr("fill", "none").attr("stroke", style.colour).attr("stroke-width", 1.4).attr("stroke-dasharray", style.dash || null)
        .attr("d", d3.line().defined((point) => Number.isFinite(point.error)).x((point) => x(point.at)).y(place)(points));
      const marks = group.selectAll("a").data(points).join("a").attr("href", `#${curve.cell}`).attr("tabindex", -1);
      marks.append("path").attr("d", (point) => (Number.isFinite(point.error) ? markPath(style, 30) : d3.symbol(d3.symbolTriangle, 30)()))
        .attr("transform", (point) => `translate(${x(point.at)},${place(point)})` + (Number.isFinite(point.error) ? ` ${turnOf(style)}` : ""))
        .attr("fill", (point) => (!Number.isFinite(point.error) ? "#d62728" : style.filled ? style.colour : "var(--paper)")).attr("stroke", (point) => (Number.isFinite(point.error) ? style.colour : "#d62728")).append("title").text((point) => `${name}: ${point.error === Infinity ? "not finite" : point.error} at ${point.at}`);
      tipOn(marks, (point) => `${name}, ${title}: ${point.error === Infinity ? "not finite" : point.error} at ${details.dataset.axis} ${point.at}`);
    }
  });
  svg.append("text").attr("x", left + 1.5 * width).attr("y", height + 60).attr("text-anchor", "middle").text(details.dataset.axis);
  svg.append("text").attr("transform", `translate(10,${height / 2 + 24}) rotate(-90)`).attr("text-anchor", "middle").text("relative error, units of u");
  box.append(svg.node());
  const key = legend(box, new Map(curves.map((curve) => [`${curve.evaluation}, ${curve.scalar}`, curve.style])), svg);
  const sign = (node, text) => {
    const part = element("span");
    part.append(node, document.createTextNode(text));
    key.append(part);
  };
  if (anyBound) sign(keyLine("#888888", "2 3").node(), "promised digits");
  if (anyInfinite) {
    const mark = d3.create("svg").attr("width", 12).attr("height", 12).attr("aria-hidden", "true");
    mark.append("path").attr("d", d3.symbol(d3.symbolTriangle, 36)()).attr("transform", "translate(6,7)").attr("fill", "#d62728");
    sign(mark.node(), "not finite, at the upper edge");
  }
}

for (const details of document.querySelectorAll("details.picture")) {
  if (details.open) drawCurves(details);
  details.addEventListener("toggle", () => details.open && drawCurves(details));
}

// Errors against times: an evaluation's mark at generic distance, joined to where it comes next to the element.
function drawTimes(box) {
  const times = JSON.parse(document.getElementById("times-data").textContent).filter((time) => time.generic !== null);
  if (!times.length) return;
  const errors = times.flatMap((time) => [time.generic, time.near ?? time.generic]).map(heightOf).filter(Number.isFinite);
  const anyInfinite = times.some((time) => [time.generic, time.near ?? time.generic].some((error) => !Number.isFinite(heightOf(error))));
  const top = 10 ** (Math.ceil(Math.log10(Math.max(100, ...errors))) + 1), width = 300, height = 230, left = leftOfPanels, gap = 22;
  const spread = d3.extent(times, (time) => time.nanoseconds);
  const x = d3.scaleLog([spread[0] / 1.5, spread[1] * 1.5], [0, width]), y = d3.scaleLog([low, top], [height, 0]);
  const svg = d3.create("svg").attr("viewBox", `0 0 ${left + 3 * (width + gap)} ${height + 66}`).attr("width", left + 3 * (width + gap)).attr("role", "img").attr("aria-label", "Largest error against time of each evaluation");
  const place = (error) => y(Number.isFinite(error) ? Math.min(Math.max(error, low), top) : top);
  orderNames.forEach((title, order) => {
    const panel = svg.append("g").attr("transform", `translate(${left + order * (width + gap)},24)`);
    axes(panel, x, y, width, height, title, order === 0, anyInfinite);
    for (const time of times.filter((one) => one.order === order)) {
      const name = `${time.evaluation}, double`, style = time.style, at = x(time.nanoseconds);
      const generic = heightOf(time.generic), near = heightOf(time.near ?? time.generic);
      const written = (error) => (Number.isFinite(error) ? error.toPrecision(2) : "not finite");
      const group = panel.append("g").attr("data-series", name);
      group.append("line").attr("x1", at).attr("x2", at).attr("y1", place(generic)).attr("y2", place(near)).attr("stroke", style.colour).attr("stroke-dasharray", "1 3");
      const text = `${name}, ${title}: ${time.nanoseconds} ns; at generic distance ${written(generic)}${time.near === null ? "" : `, next to the element ${written(near)}`}`;
      for (const [error, fill] of [[near, "none"], [generic, style.colour]])
        tipOn(group.append("path").attr("d", markPath(style, 50)).attr("transform", `translate(${at},${place(error)}) ${turnOf(style)}`).attr("fill", fill).attr("stroke", style.colour).attr("pointer-events", "all").attr("tabindex", fill === "none" ? null : 0), () => text);
    }
  });
  svg.append("text").attr("x", left + 1.5 * width).attr("y", height + 60).attr("text-anchor", "middle").text("nanoseconds a pair");
  svg.append("text").attr("transform", `translate(10,${height / 2 + 24}) rotate(-90)`).attr("text-anchor", "middle").text("relative error, units of u");
  box.append(svg.node());
  legend(box, new Map(times.map((time) => [`${time.evaluation}, double`, time.style])), svg);
}
const timesBox = document.querySelector("[data-times]");
if (timesBox) drawTimes(timesBox);

if (location.hash) show(decodeURIComponent(location.hash.slice(1)));

})();
