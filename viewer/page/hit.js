// What is at a pixel: the nearest dot, the nearest line, and the areas that contain it.
import { layerShows } from "./scene.js";
import { apart } from "./tree.js";

const REACH = 8; // pixels

// The nearest point of a curve within REACH of a pixel: its number and distance, or null. `place(x, y)` gives pixels
// relative to that one.
function nearest(curve, place, segments = true) {
  let best = REACH, point = -1;
  curve.walk(0, curve.points - 1, (boxes, at) => {
    const [left, low] = place(boxes[at], boxes[at + 1]), [right, high] = place(boxes[at + 2], boxes[at + 3]);
    return left <= best && right >= -best && low <= best && high >= -best;
  }, (begin, end) => {
    const nearer = (x, y, k) => {
      const distance = Math.hypot(x, y);
      if (distance >= best) return;
      best = distance;
      point = k;
    };
    for (let k = begin; k <= end; ++k) {
      const [x, y] = place(curve.x[k], curve.y[k]);
      nearer(x, y, k);
      if (!segments || k === end) continue;
      const [nextX, nextY] = place(curve.x[k + 1], curve.y[k + 1]), dx = nextX - x, dy = nextY - y;
      const t = Math.min(1, Math.max(0, -(x * dx + y * dy) / (dx * dx + dy * dy || 1)));
      nearer(x + t * dx, y + t * dy, t < 0.5 ? k : k + 1);
    }
  });
  return point < 0 ? null : { point, distance: best };
}

// All that is found, dots first: { layer, kind, index, curve }.
export function hits(scene, view, iterate, px, py) {
  const dots = [], lines = [], areas = [], place = (x, y) => [view.px(x) - px, py - view.py(y)];
  const [x, y] = view.at(px, py), slack = 2 / view.scale;
  for (const layer of scene.layers) {
    if (!layer.shown) continue;
    if (layer.kind === "dots") {
      const found = nearest(layer.things, place, false);
      if (found && layerShows(layer, found.point, iterate)) dots.push({ layer, index: found.point, ...found });
    } else if (layer.kind === "lines") {
      layer.curves.forEach((one, index) => {
        if (!layerShows(layer, index, iterate)) return;
        const found = nearest(one.curve, place);
        if (found) lines.push({ layer, index, ...found, point: found.point % Math.max(one.n, 1) });
      });
    } else if (layer.kind === "areas") {
      const box = [x - slack, y - slack, x + slack, y + slack];
      for (let k = 0; k < layer.things.size; ++k) {
        if (apart(layer.things.boxes, 4 * k, box) || !layerShows(layer, k, iterate)) continue;
        if (layer.things.winding(k, place) !== 0) areas.push({ layer, index: k });
      }
    }
  }
  const nearer = (a, b) => a.distance - b.distance;
  return [...dots.sort(nearer), ...lines.sort(nearer), ...areas.reverse()];
}
