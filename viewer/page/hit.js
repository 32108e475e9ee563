// What is at a pixel: the nearest dot, the nearest line, and the areas that contain it.
import { layerShows } from "./scene.js";
import { apart } from "./tree.js";

const REACH = 8; // pixels

// The nearest point of a curve within REACH of a pixel: its number and distance, or null.
export function nearest(curve, view, px, py, segments = true) {
  let best = REACH, point = -1;
  const u = (px - view.width / 2) / view.scale, v = (view.height / 2 - py) / view.scale;
  curve.walk(0, curve.points - 1, (boxes, at) => {
    const limit = best / view.scale;
    return boxes[at] - view.x - view.dx - u <= limit && boxes[at + 2] - view.x - view.dx - u >= -limit &&
      boxes[at + 1] - view.y - view.dy - v <= limit && boxes[at + 3] - view.y - view.dy - v >= -limit;
  }, (begin, end) => {
    for (let k = begin; k <= end; ++k) {
      const x = view.px(curve.x[k]) - px, y = view.py(curve.y[k]) - py;
      const alone = Math.hypot(x, y);
      if (alone < best) {
        best = alone;
        point = k;
      }
      if (!segments || k === end) continue;
      const dx = view.px(curve.x[k + 1]) - px - x, dy = view.py(curve.y[k + 1]) - py - y;
      const t = Math.min(1, Math.max(0, -(x * dx + y * dy) / (dx * dx + dy * dy || 1)));
      const distance = Math.hypot(x + t * dx, y + t * dy);
      if (distance < best) {
        best = distance;
        point = t < 0.5 ? k : k + 1;
      }
    }
  });
  return point < 0 ? null : { point, distance: best };
}

// All that is found, dots first: { layer, kind, index, curve }.
export function hits(scene, view, iterate, px, py) {
  const dots = [], lines = [], areas = [];
  const u = (px - view.width / 2) / view.scale, v = (view.height / 2 - py) / view.scale;
  const [x, y] = view.at(px, py), slack = 2 / view.scale;
  for (const layer of scene.layers) {
    if (!layer.shown) continue;
    if (layer.kind === "dots") {
      const found = nearest(layer.dots, view, px, py, false);
      if (found && layerShows(layer, found.point, iterate)) dots.push({ layer, index: found.point, ...found });
    } else if (layer.kind === "lines") {
      layer.curves.forEach((one, index) => {
        if (!layerShows(layer, index, iterate)) return;
        const found = nearest(one.curve, view, px, py);
        if (found) lines.push({ layer, index, ...found, point: found.point % Math.max(one.n, 1) });
      });
    } else if (layer.kind === "areas") {
      const box = [x - slack, y - slack, x + slack, y + slack];
      for (let k = 0; k < layer.areas.size; ++k) {
        if (apart(layer.areas.boxes, 4 * k, box) || !layerShows(layer, k, iterate)) continue;
        if (layer.areas.winding(k, view, u, v) !== 0) areas.push({ layer, index: k });
      }
    }
  }
  const nearer = (a, b) => a.distance - b.distance;
  return [...dots.sort(nearer), ...lines.sort(nearer), ...areas.reverse()];
}
