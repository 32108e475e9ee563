// The scene of the page: its layers, decoded.
import { Curve, emptyBox, growByBox } from "./tree.js";
import { Areas, Dots, Lines } from "./shapes.js";
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
    if (layer.kind === "lines") {
      layer.things = new Lines(layer.curves);
      layer.names = layer.curves.map(({ name }) => name);
    } else if (layer.kind === "dots") {
      layer.things = new Dots(...await points(layer.points, false));
    } else {
      const parts = {};
      for (const name of ["rings", "runs", "curve", "first", "last"]) parts[name] = await numbers(layer[name]);
      layer.things = new Areas(curves, parts);
    }
    if (layer.iterate >= 0) layer.iterates = layer.columns[layer.iterate].values;
  }
  scene.box = boxOf(scene);
  scene.iterates = iteratesOf(scene);
  scene.points = scene.pool.n + lines.reduce((sum, one) => sum + one.n, 0);
  return scene;
}

function boxOf(scene) {
  const box = emptyBox();
  for (const layer of scene.layers) {
    for (let k = 0; k < layer.things.size; ++k) growByBox(box, layer.things.box(k));
  }
  return box;
}

// All numbers of iterates that occur, ascending.
function iteratesOf(scene) {
  const all = scene.layers.flatMap(({ iterates }) => [...iterates ?? []].filter(Number.isFinite));
  return [...new Set(all)].sort((a, b) => a - b);
}

export function nameOf(layer, index) {
  return layer.names[index] ?? `${layer.one} ${index}`;
}

// Whether a thing belongs to the iterate that is shown; null: all are.
export function layerShows(layer, index, iterate) {
  return iterate === null || !layer.iterates || layer.iterates[index] === iterate;
}
