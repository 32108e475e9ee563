// The scene of the page: its layers, decoded.
import { Curve, emptyBox, growByBox } from "./tree.js";
import { Areas, Dots } from "./shapes.js";
import { PART, bytesOf, decodeSeries } from "./series.js";
import { byId } from "./text.js";

export async function loadScene() {
  const scene = JSON.parse(byId("scene").textContent);
  const read = (number) => bytesOf(byId(`s${number}`).textContent, scene.deflated);

  // All parts of a series, into arrays.
  async function decoded({ n, at }, axes) {
    await Promise.all(Array.from({ length: Math.ceil(n / PART) }, async (_, part) => {
      decodeSeries(await read(at + part), Math.min(PART, n - part * PART), axes, part * PART);
    }));
    return axes;
  }
  async function numbers(series) {
    return (await decoded(series, [new Float64Array(series.n)]))[0];
  }
  async function points(series, closed) {
    const size = series.n + (closed && series.n > 0 ? 1 : 0);
    const xy = await decoded(series, [new Float64Array(size), new Float64Array(size)]);
    if (size > series.n) for (const values of xy) values[series.n] = values[0];
    return xy;
  }

  const lines = scene.layers.flatMap((layer) => layer.curves ?? []);
  for (const one of lines) one.curve = new Curve(...await points(one, one.closed));
  const curves = [...lines.map((one) => one.curve), new Curve(...await points(scene.pool, false))];
  for (const layer of scene.layers) {
    for (const column of layer.columns ?? []) {
      column.values = await numbers(column);
      if (column.bar) column.bars = await numbers(column.bar);
    }
    if (layer.kind === "dots") {
      layer.dots = new Dots(...await points(layer.points, false));
    } else if (layer.kind !== "lines") {
      const parts = {};
      for (const name of ["rings", "runs", "curve", "first", "last"]) parts[name] = await numbers(layer[name]);
      layer.areas = new Areas(curves, parts);
    }
  }
  scene.box = boxOf(scene);
  scene.iterates = iteratesOf(scene);
  scene.points = scene.pool.n + lines.reduce((sum, one) => sum + one.n, 0);
  return scene;
}

function boxOf(scene) {
  const box = emptyBox();
  for (const layer of scene.layers) {
    for (let k = 0; k < sizeOf(layer); ++k) growByBox(box, boxOfThing(layer, k));
  }
  return box;
}

// All numbers of iterates that occur, ascending.
function iteratesOf(scene) {
  const all = new Set();
  for (const layer of scene.layers) {
    for (const n of layer.iterates ?? []) all.add(n);
    if (layer.iterate >= 0) for (const n of layer.columns[layer.iterate].values) if (Number.isFinite(n)) all.add(n);
  }
  return [...all].sort((a, b) => a - b);
}

export function sizeOf(layer) {
  return layer.kind === "lines" ? layer.curves.length : layer.n;
}

export function nameOf(layer, index) {
  if (layer.kind === "lines") return layer.curves[index].name;
  return layer.names[index] ?? `${layer.one} ${index}`;
}

// Whether a thing belongs to the iterate that is shown; null: all are.
export function layerShows(layer, index, iterate) {
  if (iterate === null) return true;
  if (layer.iterates) return layer.iterates[index] === iterate;
  return !(layer.iterate >= 0) || layer.columns[layer.iterate].values[index] === iterate;
}

export function boxOfThing(layer, index) {
  if (layer.kind === "lines") return layer.curves[index].curve.box();
  return layer.kind === "dots" ? layer.dots.box(index) : layer.areas.box(index);
}
