// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
'use strict';
// The table of an index of runs: a click on a heading sorts by it, a second one the other way round.
// Cells may say in data-value what they sort by; numbers sort as numbers, what has none goes last.
const table = document.querySelector('table.runs');
const headings = [...table.querySelectorAll('th')];

function valueOf(row, column) {
  const cell = row.cells[column];
  const text = cell.dataset.value ?? cell.textContent;
  return text === '' ? null : Number.isNaN(Number(text)) ? text.toLowerCase() : Number(text);
}

function compare(a, b) {
  if (typeof a !== typeof b) return typeof a === 'number' ? -1 : 1;
  return a < b ? -1 : Number(a > b);
}

function sort(column) {
  const down = headings[column].getAttribute('aria-sort') === 'ascending';
  headings.forEach(h => h.removeAttribute('aria-sort'));
  headings[column].setAttribute('aria-sort', down ? 'descending' : 'ascending');
  const rows = [...table.tBodies[0].rows].map(row => ({row, value: valueOf(row, column)}));
  rows.sort((a, b) => a.value === null || b.value === null
    ? (a.value === null) - (b.value === null)
    : (down ? -1 : 1) * compare(a.value, b.value));
  table.tBodies[0].append(...rows.map(r => r.row));
}

headings.forEach((heading, column) => {
  if (!heading.dataset.sort) return;
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = heading.textContent;
  button.onclick = () => sort(column);
  heading.replaceChildren(button);
});
