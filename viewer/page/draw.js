// What is seen of a scene, as paths with their styles: for the canvas and, the same, for SVG.
import { LinePen, MARGIN, RingPen } from "./pen.js";
import { layerShows } from "./scene.js";
import { apart, smaller } from "./tree.js";

const CHUNK = 1024; // segments of a path: longer ones take a canvas more time than they save
const DOT_CELL = 4; // pixels between dots that are drawn

// Gives { path, layer }, to be filled, or stroked if `stroke` is true, or both if `selected` is; `newPath`
// makes an empty path, `step` is the smallest distance of points in pixels.
export function* drawings(scene, view, { iterate, selected }, newPath, step) {
  const frame = view.box(MARGIN);
  for (const layer of scene.layers) {
    if (!layer.shown) continue;
    if (layer.kind === "lines") yield* lines(layer, view, frame, iterate, newPath, step);
    else if (layer.kind === "dots") yield* dots(layer, view, frame, iterate, newPath);
    else yield* areas(layer, view, frame, iterate, newPath, step);
  }
  if (selected?.layer.things.draw) {
    const path = newPath();
    selected.layer.things.draw(selected.index, view, frame, new RingPen(path, view.width, view.height, step));
    yield { path, layer: selected.layer, selected: true };
  }
}

function* lines(layer, view, frame, iterate, newPath, step) {
  const small = step / view.scale;
  for (let index = 0; index < layer.curves.length; ++index) {
    if (!layerShows(layer, index, iterate)) continue;
    const { curve } = layer.curves[index], { x, y } = curve;
    if (curve.points === 0) continue;
    const finished = [];
    const pen = new LinePen(newPath(), view.width, view.height, step);
    const next = () => {
      finished.push(pen.path);
      pen.path = newPath();
      pen.open = false;
      pen.segments = 0;
    };
    curve.walk(0, curve.points - 1, (boxes, at, begin, end) => {
      if (apart(boxes, at, frame)) {
        pen.up();
        return false;
      }
      if (!smaller(boxes, at, small)) return true;
      pen.to(view.px(x[begin]), view.py(y[begin]));
      pen.to(view.px(x[end]), view.py(y[end]));
      return false;
    }, (begin, end) => {
      for (let k = begin; k <= end; ++k) pen.to(view.px(x[k]), view.py(y[k]));
      if (pen.segments > CHUNK) next();
    });
    const whole = curve.levels[curve.top];
    if (smaller(whole, 0, small) && !apart(whole, 0, frame)) { // a point, at this scale
      pen.path.rect(view.px(x[0]) - layer.width, view.py(y[0]) - layer.width, 2 * layer.width, 2 * layer.width);
    }
    finished.push(pen.path);
    for (const path of finished) yield { path, layer, stroke: true };
  }
}

function* areas(layer, view, frame, iterate, newPath, step) {
  const stroke = layer.kind === "outlines";
  const { things: all } = layer, { boxes } = all;
  let path = newPath(), drawn = 0;
  const tiny = Math.max(1, step), cells = new Set(); // squares of this size, and those with areas smaller than that
  for (let k = 0; k < all.size; ++k) {
    if (apart(boxes, 4 * k, frame) || !layerShows(layer, k, iterate)) continue;
    if (smaller(boxes, 4 * k, tiny / view.scale)) {
      const x = Math.floor(view.px(boxes[4 * k]) / tiny), y = Math.floor(view.py(boxes[4 * k + 3]) / tiny), cell = x * 65536 + y;
      if (cells.has(cell)) continue;
      cells.add(cell);
      path.rect(x * tiny, y * tiny, tiny, tiny);
    } else {
      all.draw(k, view, frame, new RingPen(path, view.width, view.height, step));
    }
    if (++drawn % 256 === 0) {
      yield { path, layer, stroke };
      path = newPath();
    }
  }
  yield { path, layer, stroke };
}

function* dots(layer, view, frame, iterate, newPath) {
  const { things: dots } = layer, cells = new Set(), path = newPath();
  const small = DOT_CELL / 2 / view.scale;
  const add = (k) => {
    if (!layerShows(layer, k, iterate)) return;
    const x = view.px(dots.x[k]), y = view.py(dots.y[k]);
    if (!(x > -MARGIN && y > -MARGIN && x < view.width + MARGIN && y < view.height + MARGIN)) return;
    const cell = Math.floor(x / DOT_CELL + 64) * 65536 + Math.floor(y / DOT_CELL + 64);
    if (cells.has(cell)) return;
    cells.add(cell);
    path.moveTo(x + layer.width, y);
    path.arc(x, y, layer.width, 0, 2 * Math.PI);
  };
  dots.walk(0, dots.points - 1, (boxes, at, begin) => {
    if (apart(boxes, at, frame)) return false;
    if (iterate !== null || !smaller(boxes, at, small)) return true;
    add(begin);
    return false;
  }, (begin, end) => {
    for (let k = begin; k <= end; ++k) add(k);
  });
  yield { path, layer };
}

export const OPACITY = { lines: 1, areas: 0.35, outlines: 0.8, dots: 1 };

// Draws on a canvas. `dark`: dots without a meaning of their own are light there.
export function paint(context, scene, view, state, step, theme) {
  context.lineJoin = "round";
  const thin = step > 0.5; // lines of one pixel take a third of the time
  for (const { path, layer, stroke, selected } of drawings(scene, view, state, () => new Path2D(), step)) {
    context.fillStyle = context.strokeStyle = colourOf(layer, theme);
    context.lineWidth = selected ? 3 : thin && layer.kind === "lines" ? 1 : layer.width;
    context.globalAlpha = selected ? 1 : OPACITY[layer.kind];
    if (stroke || selected) context.stroke(path);
    if (selected) context.globalAlpha = OPACITY.areas;
    if (!stroke) context.fill(path);
  }
  context.globalAlpha = 1;
}

// Black dots and dark colours are seen on a dark ground when they are mixed with white.
export function colourOf(layer, theme) {
  if (!theme.dark) return layer.colour;
  const part = (at) => parseInt(layer.colour.slice(at, at + 2), 16);
  const [red, green, blue] = [part(1), part(3), part(5)];
  const light = (0.3 * red + 0.59 * green + 0.11 * blue) / 255, white = Math.max(0, 0.62 - light) / (1 - light);
  const mixed = [red, green, blue].map((value) => Math.round(value + (255 - value) * white).toString(16).padStart(2, "0"));
  return `#${mixed.join("")}`;
}
