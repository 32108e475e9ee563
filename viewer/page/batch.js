// The page of a batch: its jobs in a table, and heat maps of their numbers.
import { gridOf, paintGrid } from "./heat.js";
import { Table } from "./table.js";
import { byId, element, rounded, upright } from "./text.js";

// As cli/batch/page_columns.hpp has it.
const batch = JSON.parse(byId("batch").textContent);
const short = (path) => path && upright(path.slice(path.lastIndexOf("/") + 1));
const columns = batch.columns.map(({ name, role, values, texts, at }) => {
  const value = values ? (k) => values[k] ?? undefined : (k) => texts[at[k]];
  const text = values ? (k) => (values[k] === null ? "" : rounded(values[k], 10)) : (k) => short(value(k)) ?? "";
  return { name, role, value, text };
});
const jobs = batch.columns[0].values.length;
const numbers = Array.from({ length: jobs }, (_, k) => k);
const isVaried = ({ value }) => numbers.some((k) => value(k) !== value(0));
const varied = columns.filter((one) => one.role === "given" && isVaried(one));
const results = columns.filter(({ role }) => role === "result");
let chosen = null;

// ---------------------------------------------------------------------------------- progress

byId("progress").max = String(Math.max(batch.done + batch.failed + batch.missing, 1));
byId("progress").value = batch.done + batch.failed;
byId("counts").textContent = `${batch.done} done, ${batch.failed} failed, ${batch.missing} to do` +
  (batch.missing > 0 ? "; write the page again and reload it to see more" : "");

// ---------------------------------------------------------------------------------- the heat map

const hasOverlaps = (k) => Boolean(batch.overlaps?.[k]);
const chosenOf = (id) => columns[Number(byId(id).value)];
const oneRow = { name: "", value: () => "", text: () => "" }; // in place of y where jobs differ in one thing only
const showsLobes = () => byId("kind").value === "lobes";
let cellAt = () => undefined;

function cells() {
  if (showsLobes()) {
    const job = chosen ?? numbers.find(hasOverlaps);
    byId("of").textContent = `job ${columns[0].text(job)}: choose another one in the table`;
    if (!hasOverlaps(job)) return [];
    const { overlap_i, overlap_j, overlap_areas } = batch.overlaps[job];
    return overlap_i.flatMap((i, k) => {
      const j = overlap_j[k], about = { value: overlap_areas[k], text: `lobes ${i} and ${j}` };
      return [{ x: i, y: j, ...about }, { x: j, y: i, ...about }];
    });
  }
  const x = chosenOf("x"), y = varied.length > 1 ? chosenOf("y") : oneRow, value = chosenOf("value");
  byId("of").textContent = `${value.name} over ${x.name}` + (y === oneRow ? "" : ` (to the right) and ${y.name} (upwards)`);
  return table.rows.filter((k) => [x, y, value].every((one) => one.value(k) !== undefined)).map((job) => (
    { x: x.value(job), y: y.value(job), value: value.value(job), job,
      text: [x, y].filter(({ name }) => name).map((one) => `${one.name} ${one.text(job)}`).join(", ") }));
}

function heat() {
  const canvas = byId("map"), ratio = devicePixelRatio || 1;
  byId("axes").hidden = showsLobes();
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  const grid = gridOf(cells()), style = getComputedStyle(document.documentElement);
  cellAt = paintGrid(context, grid, canvas, style, (step) => (typeof step === "number" ? rounded(step, 10) : short(step)));
  byId("range").textContent = (grid.high >= grid.low ? `${rounded(grid.low)} (dark) to ${rounded(grid.high)} (light)` : "no values") +
    (grid.hidden > 0 ? `; ${grid.hidden} more jobs lie on the same cells: filter the table` : "");
}

const hover = (event) => {
  const box = byId("map").getBoundingClientRect(), cell = cellAt(event.clientX - box.left, event.clientY - box.top);
  byId("cell").textContent = cell ? `${cell.text}: ${rounded(cell.value, 12)}` : "";
  return cell;
};
byId("map").addEventListener("pointermove", hover);
byId("map").addEventListener("click", (event) => {
  const cell = hover(event);
  if (cell?.job !== undefined) choose(cell.job);
});

// ---------------------------------------------------------------------------------- choices

function choose(job) {
  chosen = job;
  table.mark(job);
  if (showsLobes()) heat();
}
const table = new Table({ choose, changed: () => byId("heat-part").hidden || heat() });

const kinds = [];
if (varied.length > 0 && results.length > 0) kinds.push(["jobs", "numbers of jobs"]);
if (batch.overlaps) kinds.push(["lobes", "overlaps of lobes i and j"]);
const option = ([value, text]) => element("option", { value }, text);
const options = (list) => list.map((one) => option([String(columns.indexOf(one)), one.name]));
byId("kind").replaceChildren(...kinds.map(option));
for (const [id, list] of [["x", varied], ["y", varied], ["value", results]]) byId(id).replaceChildren(...options(list));
byId("y").hidden = varied.length < 2;
if (varied.length > 1) byId("y").selectedIndex = 1;
// The number that is drawn first, as `lober batch picture` chooses it: a usual one, or the first that differs among the jobs
// and does not repeat what is given.
const repeats = (one) => varied.some(({ value }) => numbers.every((k) => value(k) === one.value(k)));
const usual = ["intersection", "lobe_area12", "flux12"].map((wanted) => results.find(({ name }) => name === wanted))
  .concat(results.find((one) => isVaried(one) && !one.name.endsWith("_error") && !repeats(one))).find(Boolean);
if (usual) byId("value").value = String(columns.indexOf(usual));
if (batch.overlaps) byId("kind").value = "lobes";
byId("heat-part").hidden = kinds.length === 0;
table.show(batch, jobs, columns);
for (const id of ["kind", "x", "y", "value"]) byId(id).addEventListener("change", heat);
if (kinds.length > 0) new ResizeObserver(heat).observe(byId("map"));
globalThis.lober = { columns, table }; // for the console, and for tests
document.documentElement.dataset.ready = "yes";
