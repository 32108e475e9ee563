// Heat maps: a value over two keys, or over the numbers of two lobes.
import { byId } from "./text.js";

const STOPS = JSON.parse(byId("heat").textContent); // those of all pictures (viewer/palette.hpp)

function heatColour(part) {
  const at = Math.min(Math.max(part, 0), 1) * (STOPS.length - 1), k = Math.min(Math.floor(at), STOPS.length - 2);
  return `rgb(${STOPS[k].map((from, c) => Math.round(from + (STOPS[k + 1][c] - from) * (at - k))).join(" ")})`;
}

// Different values in order: numbers by size, texts by the order in which they came.
function steps(values) {
  const all = [...new Set(values)];
  return all.every((value) => typeof value === "number") ? all.sort((a, b) => a - b) : all;
}

// Cells { x, y, value } as a grid: the steps of both axes, the range of values, and the cell of a column and row. Of cells at
// the same column and row the first is seen; `hidden` is the number of others.
export function gridOf(cells) {
  const columns = steps(cells.map(({ x }) => x)), rows = steps(cells.map(({ y }) => y));
  const column = new Map(columns.map((x, k) => [x, k])), row = new Map(rows.map((y, k) => [y, k]));
  const at = new Map();
  let low = Infinity, high = -Infinity;
  for (const cell of cells) {
    const key = column.get(cell.x) + row.get(cell.y) * columns.length;
    if (at.has(key)) continue;
    at.set(key, cell);
    if (!Number.isFinite(cell.value)) continue;
    low = Math.min(low, cell.value);
    high = Math.max(high, cell.value);
  }
  return { columns, rows, low, high, hidden: cells.length - at.size, at: (c, r) => at.get(c + r * columns.length) };
}

const BOTTOM = 20; // pixels of the labels below, and
const GAP = 6; // of what is beside labels

// The end of a text that is not wider: names of files differ there.
function fitting(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  const letters = [...text];
  while (letters.length > 1 && context.measureText(`\u2026${letters.join("")}`).width > width) letters.shift();
  return `\u2026${letters.join("")}`;
}

// Draws the grid, row 0 at the bottom, and the `text` of as many steps as there is room for; returns the
// function that gives the cell at a pixel.
export function paintGrid(context, grid, canvas, style, text) {
  const { columns, rows, low, high } = grid, { clientWidth: width, clientHeight: height } = canvas;
  context.fillStyle = style.getPropertyValue("--panel").trim();
  context.fillRect(0, 0, width, height);
  context.font = "12px system-ui, sans-serif";
  const widest = Math.max(0, ...rows.map((step) => context.measureText(text(step)).width));
  const start = Math.min(Math.max(46, widest), 0.3 * width) + GAP; // of the columns, behind the labels of rows
  const across = (width - start) / columns.length, up = (height - BOTTOM) / rows.length;
  const gap = Math.min(across, up) > 8 ? 1 : 0, left = (c) => start + c * across, top = (r) => height - BOTTOM - (r + 1) * up;
  for (let r = 0; r < rows.length; ++r) {
    for (let c = 0; c < columns.length; ++c) {
      const cell = grid.at(c, r);
      if (!cell || !Number.isFinite(cell.value)) continue;
      context.fillStyle = heatColour(high > low ? (cell.value - low) / (high - low) : 0.5);
      context.fillRect(left(c), top(r), Math.ceil(across) - gap, Math.ceil(up) - gap);
    }
  }
  context.fillStyle = style.getPropertyValue("--ink").trim();
  // Labels `wide` pixels apart or more, of a list of steps `each` pixels apart.
  const label = (list, each, wide, place) => {
    const every = Math.ceil(wide / each);
    for (let k = 0; k < list.length; k += every) {
      const [x, y, room] = place(k, every * each - GAP);
      context.fillText(fitting(context, text(list[k]), room), x, y);
    }
  };
  context.textAlign = "center";
  label(columns, across, 66, (c, room) => [left(c + 0.5), height - 5, room]);
  context.textAlign = "right";
  label(rows, up, 20, (r) => [start - GAP, top(r) + up / 2 + 4, start - GAP]);
  return (px, py) => {
    if (px < start || py > height - BOTTOM) return undefined;
    return grid.at(Math.floor((px - start) / across), Math.floor((height - BOTTOM - py) / up));
  };
}
