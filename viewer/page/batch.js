// The page of a batch: its jobs in a table, and heat maps of their numbers.
import { fillHeads, filterOf } from "./columns.js";
import { gridOf, paintGrid } from "./heat.js";
import { byId, element, rounded } from "./text.js";

const ROWS = 300; // that are shown at once; the filter finds others

const batch = JSON.parse(byId("batch").textContent);
const short = (path) => (typeof path === "string" && path.includes("/") ? path.slice(path.lastIndexOf("/") + 1) : path);
const inputs = ["first", "second"];

// Names of the values of a job, options among them as "options.parameters.K".
function flat(value, name, into) {
  if (Array.isArray(value)) return into;
  if (value === null || typeof value !== "object") {
    into[name] = value;
    return into;
  }
  for (const [key, one] of Object.entries(value)) flat(one, name ? `${name}.${key}` : key, into);
  return into;
}
const jobs = batch.jobs.map((job) => flat(job, "", Object.create(null)));
const names = [...new Set(jobs.flatMap(Object.keys))];
const numeric = (name) => jobs.some((job) => typeof job[name] === "number");
const isGiven = (name) => name.startsWith("options.") || inputs.includes(name);
const differs = (name) => new Set(jobs.map((job) => job[name]).filter((value) => value !== undefined)).size > 1;
const varied = names.filter((name) => isGiven(name) && differs(name));
const results = names.filter((name) => numeric(name) && !name.startsWith("options.") && name !== "job");

// ---------------------------------------------------------------------------------- progress

const all = batch.done + batch.failed + batch.missing;
byId("progress").max = String(Math.max(all, 1));
byId("progress").value = batch.done + batch.failed;
byId("counts").textContent = `${batch.done} done, ${batch.failed} failed, ${batch.missing} to do` +
  (batch.missing > 0 ? "; write the page again and reload it to see more" : "");

// ---------------------------------------------------------------------------------- the table

const known = [...inputs, ...varied, ...results, "message"].filter((name) => names.includes(name));
const columns = [...new Set(["job", "status", ...known])];
const sort = { column: 0, down: false };
let chosen = null;

const label = (name) => name.replace(/^options\.(parameters\.)?/, "");
function textOf(name, value) {
  if (typeof value === "number") return rounded(value, 10);
  return String((inputs.includes(name) ? short(value) : value) ?? "");
}

function heads() {
  fillHeads(columns.map(label), sort, (column) => {
    sort.down = sort.column === column && !sort.down;
    sort.column = column;
    heads();
    rows();
  });
}

function accepted() {
  const contains = (job, text) => columns.some((one) => typeof job[one] === "string" && job[one].toLowerCase().includes(text));
  return jobs.filter(filterOf(columns.map(label), (job, column) => job[columns[column]], contains));
}

function rows() {
  const list = accepted(), column = columns[sort.column], sign = sort.down ? -1 : 1;
  const isKnown = (job) => job[column] !== undefined && job[column] !== null;
  list.sort((a, b) => isKnown(b) - isKnown(a) || sign * (a[column] < b[column] ? -1 : a[column] > b[column] ? 1 : 0));
  byId("body").replaceChildren(...list.slice(0, ROWS).map((job) => {
    const texts = columns.map((name) => textOf(name, job[name]));
    const row = element("tr", { className: job === chosen ? "chosen" : "", tabIndex: 0 },
      ...texts.map((text) => element("td", { title: text }, text)));
    const choose = () => {
      chosen = job;
      rows();
      heat();
    };
    row.addEventListener("click", choose);
    row.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      choose();
      byId("body").querySelector(".chosen").focus();
    });
    return row;
  }));
  byId("count").textContent = `${Math.min(list.length, ROWS)} of ${list.length} rows` +
    (list.length < jobs.length ? ` (of ${jobs.length})` : "");
}

// ---------------------------------------------------------------------------------- the heat map

const options = (list) => list.map((name) => element("option", { value: name }, label(name)));
const overlaps = batch.jobs.some((job) => job.overlap_i?.length > 0);
let cellAt = () => undefined;

function cells() {
  if (byId("kind").value === "lobes") {
    const job = batch.jobs[jobs.indexOf(chosen ?? jobs.find((_, k) => batch.jobs[k].overlap_i?.length > 0))];
    byId("of").textContent = job ? `job ${job.job}: choose another one in the table` : "no overlaps are known";
    if (!job?.overlap_i) return [];
    return job.overlap_i.flatMap((i, k) => {
      const j = job.overlap_j[k], about = { value: job.overlap_areas[k], text: `lobes ${i} and ${j}` };
      return [{ x: i, y: j, ...about }, { x: j, y: i, ...about }];
    });
  }
  const x = byId("x").value, y = byId("y").value, value = byId("value").value;
  byId("of").textContent = `${label(value)} over ${label(x)} (to the right) and ${label(y)} (upwards)`;
  return jobs.filter((job) => job[x] !== undefined && job[y] !== undefined && job[value] !== undefined)
    .map((job) => {
      const text = `${label(x)} ${textOf(x, job[x])}, ${label(y)} ${textOf(y, job[y])}`;
      return { x: job[x], y: job[y], value: job[value], job, text };
    });
}

function heat() {
  const canvas = byId("map"), ratio = devicePixelRatio || 1;
  byId("axes").hidden = byId("kind").value === "lobes";
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  const grid = gridOf(cells()), style = getComputedStyle(document.documentElement);
  const [textX, textY] = ["x", "y"].map((id) => (value) => (byId("axes").hidden ? String(value) : textOf(byId(id).value, value)));
  cellAt = paintGrid(context, grid, canvas, style, textX, textY);
  byId("range").textContent = grid.high >= grid.low ? `${rounded(grid.low)} (dark) to ${rounded(grid.high)} (light)` : "no values";
}

const hover = (event) => {
  const box = byId("map").getBoundingClientRect(), cell = cellAt(event.clientX - box.left, event.clientY - box.top);
  byId("cell").textContent = cell ? `${cell.text}: ${rounded(cell.value, 12)}` : "";
  return cell;
};

byId("filter").addEventListener("input", rows);
byId("map").addEventListener("pointermove", hover);
byId("map").addEventListener("click", (event) => {
  const cell = hover(event);
  if (!cell?.job) return;
  chosen = cell.job;
  rows();
});
const kinds = [];
if (varied.length > 0 && results.length > 0) kinds.push(["jobs", "numbers of jobs"]);
if (overlaps) kinds.push(["lobes", "overlaps of lobes i and j"]);
byId("kind").replaceChildren(...kinds.map(([value, text]) => element("option", { value }, text)));
byId("x").replaceChildren(...options(varied));
byId("y").replaceChildren(...options(varied));
byId("value").replaceChildren(...options(results));
if (varied.length > 1) byId("y").value = varied[1];
if (results.includes("intersection")) byId("value").value = "intersection";
if (overlaps) byId("kind").value = "lobes";
byId("heat-part").hidden = kinds.length === 0;
for (const id of ["kind", "x", "y", "value"]) byId(id).addEventListener("change", heat);
heads();
rows();
if (kinds.length > 0) new ResizeObserver(heat).observe(byId("map"));
document.documentElement.dataset.ready = "yes";
