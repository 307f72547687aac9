// SPDX-License-Identifier: MIT
// Tables of the report sort and filter once scripts run.
"use strict";

// An error's text as a number, to sort by; text that is no number comes last.
function numberOf(text) {
  const plain = text.replace(/[,✗\s]/g, "");
  if (plain === "inf") return Infinity;
  return plain === "" || Number.isNaN(Number(plain)) ? null : Number(plain);
}

function compareCells(a, b) {
  const x = numberOf(a), y = numberOf(b);
  if (x !== null && y !== null) return x - y;
  if (x !== null || y !== null) return x !== null ? -1 : 1;
  return a.localeCompare(b, "en", {numeric: true});
}

function sortable(table) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const falling = head.getAttribute("aria-sort") === "ascending";
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", falling ? "descending" : "ascending");
      const body = table.tBodies[0];
      const rows = [...body.rows].map((row, place) => [row.cells[column].textContent.trim(), place, row]);
      rows.sort((a, b) => (falling ? compareCells(b[0], a[0]) : compareCells(a[0], b[0])) || a[1] - b[1]);
      body.append(...rows.map((row) => row[2]));
    });
  });
}

function addChoices(select, names) {
  for (const name of [...new Set(names)]) {
    if (name === "") continue;
    const option = document.createElement("option");
    option.value = option.textContent = name;
    select.append(option);
  }
}

// Keeps what a form's selects ask for in the address, so that a filtered view can be linked and comes back on reload.
function rememberFilters(form, change) {
  const key = form.dataset.filters;
  const stored = new URLSearchParams(location.search);
  for (const select of form.querySelectorAll("select")) {
    const value = stored.get(key + "." + select.name);
    if (value !== null && [...select.options].some((option) => option.value === value)) select.value = value;
    select.addEventListener("change", () => {
      const now = new URLSearchParams(location.search);
      if (select.value === "") now.delete(key + "." + select.name);
      else now.set(key + "." + select.name, select.value);
      const query = now.toString();
      try {
        history.replaceState(null, "", location.pathname + (query ? "?" + query : "") + location.hash);
      } catch (error) {
        // Some browsers keep pages that are files from changing their address.
      }
      change();
    });
  }
  form.hidden = false;
  change();
}

for (const table of document.querySelectorAll("table[data-sortable]")) sortable(table);
