#include "lutlib/plot/heat_map.h"
#include "lutlib/plot/page_parts.h"
#include "lutlib/plot/palette.h"

#include <fmt/core.h>

namespace plot {
namespace {

// Sorting by a click on a heading, filters, and a row's panels by a click on it or on its mark.
constexpr const char* script = R"(
const table = document.querySelector('table.all'), body = table.tBodies[0];
const heads = [...table.tHead.rows[0].cells];
const key = (row, i) => { const c = row.cells[i]; return c.dataset.v === undefined ? c.textContent : +c.dataset.v; };
let sorted = -1, down = false;
heads.forEach((th, i) => {
  th.setAttribute('role', 'button'); th.tabIndex = 0; th.title = 'sort';
  const sort = () => {
    down = sorted === i && !down; sorted = i;
    const rows = [...body.rows].sort((a, b) => { const x = key(a, i), y = key(b, i); return x < y ? -1 : x > y ? 1 : 0; });
    if (down) rows.reverse();
    body.append(...rows);
  };
  th.addEventListener('click', sort);
  th.addEventListener('keydown', e => { if (e.key === 'Enter') sort(); });
});

const rowOf = n => document.getElementById('row-' + n);
const marks = [...document.querySelectorAll('.mark')];
const naming = JSON.parse(table.dataset.naming || '[]');
const nameOf = n => naming.map(i => rowOf(n).cells[i].textContent).join(', ');
marks.forEach(mark => mark.addEventListener('mouseenter', () => {
  if (mark.querySelector('title')) return;
  const figures = [...rowOf(mark.dataset.row).cells].map((c, i) => [heads[i].textContent, c.textContent])
    .filter((_, i) => !naming.includes(i)).map(f => f.join(' ')).join('; ');
  const title = document.createElementNS(mark.namespaceURI, 'title');
  title.textContent = nameOf(mark.dataset.row) + ': ' + figures;
  mark.append(title);
}));

const filters = document.querySelector('.filters');
if (filters) {
  filters.hidden = false;
  const chosen = [...filters.querySelectorAll('select')];
  const filter = () => {
    for (const row of body.rows)
      row.classList.toggle('out', chosen.some(s => s.value && row.cells[s.dataset.column].textContent !== s.value));
    for (const mark of marks) mark.classList.toggle('out', rowOf(mark.dataset.row).classList.contains('out'));
  };
  chosen.forEach(select => {
    const i = +select.dataset.column;
    const values = new Map([...body.rows].map(r => [r.cells[i].textContent, key(r, i)]));
    [...values].sort((a, b) => a[1] < b[1] ? -1 : 1).forEach(v => select.add(new Option(v[0])));
    select.addEventListener('change', filter);
  });
}

const panels = document.getElementById('panels');
const data = panels ? JSON.parse(panels.textContent) : null;
const fill = c => letters.indexOf(c) < 0 ? 'none' : heat[letters.indexOf(c)];
const code = c => Math.floor((255 * Math.max(0, letters.indexOf(c)) + 32) / 63);
const set = {
  cells: (e, v) => e.querySelectorAll('.cells path').forEach((p, i) => p.setAttribute('fill', fill(v[i]))),
  bands: (e, v) => e.querySelectorAll('.cells path').forEach((p, i) =>
    p.setAttribute('fill', 'rgb(' + [0, 1, 2].map(k => code(v[3 * i + k])).join() + ')')),
  path: (e, v) => e.setAttribute('d', v),
  text: (e, v) => { e.textContent = v; },
};
const pick = n => {
  document.querySelectorAll('.picked').forEach(e => e.classList.remove('picked'));
  rowOf(n).classList.add('picked');
  marks.filter(m => m.dataset.row == n).forEach(m => m.classList.add('picked'));
  if (data) data.values.forEach((value, i) => set[value[1]](document.getElementById('d-' + value[0]), data.rows[n][i]));
};
marks.forEach(mark => mark.addEventListener('click', () => {
  pick(mark.dataset.row);
  if (!data) rowOf(mark.dataset.row).scrollIntoView({block: 'center'});
}));
[...body.rows].forEach(row => row.addEventListener('click', () => {
  pick(row.id.slice(4));
  const shown = document.getElementById('chosen');
  if (shown) shown.scrollIntoView();
}));
)";

} // namespace

std::string page_script() {
    std::string heat;
    for (std::size_t i = 0; i < heat_levels; ++i) {
        heat += (i ? "," : "") + ("'" + heat_color(i) + "'");
    }
    return fmt::format("const letters = '{}', heat = [{}];{}", level_letters(), heat, script);
}

} // namespace plot
