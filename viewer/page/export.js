// The view as an SVG picture, and what is in it as comma-separated columns.
import { axes } from "./axes.js";
import { OPACITY, drawings } from "./draw.js";
import { TextPath } from "./pen.js";
import { layerShows, nameOf } from "./scene.js";

const SVG_STEP = 0.25; // pixels between points

function escaped(text) {
  const entities = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
  return text.replace(/[&<>"]/g, (c) => entities[c]).replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, "\ufffd");
}

export function svgOf(scene, view, state) {
  const { width, height } = view;
  let svg = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">\n` +
    `<title>${escaped(scene.title)}</title>\n<rect width="100%" height="100%" fill="#ffffff"/>\n`;
  for (const { path, layer, stroke, selected } of drawings(scene, view, state, () => new TextPath(), SVG_STEP)) {
    if (path.text === "" || selected) continue;
    const style = stroke
      ? `fill="none" stroke="${layer.colour}" stroke-width="${layer.width}" stroke-linejoin="round"`
      : `fill="${layer.colour}"`;
    svg += `<path ${style} opacity="${OPACITY[layer.kind]}" d="${path.text}"/>\n`;
  }
  svg += `<g font-family="sans-serif" font-size="12" fill="#222222">\n`;
  const anchors = { left: "start", center: "middle", right: "end" };
  for (const { text, x, y, align } of axes(view).labels) {
    svg += `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchors[align]}">${escaped(text)}</text>\n`;
  }
  return `${svg}</g>\n</svg>\n`;
}

function field(value) {
  if (typeof value === "number") return Number.isFinite(value) ? String(value) : "";
  return /[",\r\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
}

// Areas and dots with their numbers, x and y being the middle of the box of an area, and points of curves by number.
export function csvOf(scene, view, { iterate }) {
  const names = [];
  for (const layer of scene.layers) {
    for (const column of layer.columns ?? []) {
      for (const name of column.bars ? [column.name, `${column.name}_error`] : [column.name]) {
        if (!names.includes(name)) names.push(name);
      }
    }
  }
  const box = view.box(), rows = [["layer", "name", "point", "x", "y", ...names].map(field).join(",")];
  for (const layer of scene.layers) {
    if (!layer.shown) continue;
    for (let k = 0; k < layer.things.size; ++k) {
      if (!layerShows(layer, k, iterate)) continue;
      if (layer.kind === "lines") {
        const one = layer.curves[k], { x, y } = one.curve;
        for (let p = 0; p < one.n; ++p) {
          if (x[p] < box[0] || x[p] > box[2] || y[p] < box[1] || y[p] > box[3]) continue;
          rows.push([layer.name, one.name, p, x[p], y[p]].map(field).join(",") + ",".repeat(names.length));
        }
        continue;
      }
      const [minX, minY, maxX, maxY] = layer.things.box(k);
      if (maxX < box[0] || minX > box[2] || maxY < box[1] || minY > box[3]) continue;
      const values = Object.create(null);
      for (const column of layer.columns) {
        values[column.name] = column.values[k];
        if (column.bars) values[`${column.name}_error`] = column.bars[k];
      }
      const x = minX / 2 + maxX / 2, y = minY / 2 + maxY / 2;
      rows.push([layer.name, nameOf(layer, k), k, x, y, ...names.map((name) => values[name] ?? "")].map(field).join(","));
    }
  }
  return `${rows.join("\n")}\n`;
}
