// The things of layers, each with a size and boxes: areas, whose boundaries are runs of points of curves, dots, and lines.
import { Curve, apart, emptyBox, growByBox, smaller } from "./tree.js";

// Areas of a layer: area k has the rings ringBegin[k] to ringBegin[k + 1], ring r the runs runBegin[r] to runBegin[r + 1],
// and a run goes from point first to point last of a curve, up or down.
export class Areas {
  constructor(curves, { rings, runs, curve, first, last }) {
    this.curves = curves;
    this.size = rings.length;
    this.ringBegin = sums(rings);
    this.runBegin = sums(runs);
    this.curve = Int32Array.from(curve);
    this.first = Int32Array.from(first);
    this.last = Int32Array.from(last);
    this.boxes = new Float64Array(4 * this.size);
    for (let area = 0; area < this.size; ++area) this.boxes.set(this.boxOf(area), 4 * area);
  }

  boxOf(area) {
    const box = emptyBox();
    for (let run = this.runBegin[this.ringBegin[area]]; run < this.runBegin[this.ringBegin[area + 1]]; ++run) {
      const first = this.first[run], last = this.last[run];
      growByBox(box, this.curves[this.curve[run]].box(Math.min(first, last), Math.max(first, last)));
    }
    return box;
  }
  box(area) {
    return this.boxes.subarray(4 * area, 4 * area + 4);
  }

  // Draws the rings of an area. Runs outside of the frame and those smaller than a step are drawn as their chords: the
  // area within the frame stays the same.
  draw(area, view, frame, pen) {
    for (let ring = this.ringBegin[area]; ring < this.ringBegin[area + 1]; ++ring) {
      for (let run = this.runBegin[ring]; run < this.runBegin[ring + 1]; ++run) this.drawRun(run, view, frame, pen);
      pen.close();
    }
  }
  drawRun(run, view, frame, pen) {
    const curve = this.curves[this.curve[run]], { x, y } = curve;
    const first = Math.min(this.first[run], this.last[run]), last = Math.max(this.first[run], this.last[run]);
    const points = [];
    const small = pen.step / view.scale;
    curve.walk(first, last, (boxes, at, from, to) => {
      if (!apart(boxes, at, frame) && !smaller(boxes, at, small)) return true;
      points.push(from, to);
      return false;
    }, (begin, end) => {
      for (let k = begin; k <= end; ++k) points.push(k);
    });
    if (this.first[run] > this.last[run]) points.reverse();
    for (const k of points) pen.to(view.px(x[k]), view.py(y[k]));
  }

  // How often the boundary of an area winds about a point; `place(x, y)` gives coordinates relative to it.
  winding(area, place) {
    let winding = 0;
    for (let ring = this.ringBegin[area]; ring < this.ringBegin[area + 1]; ++ring) {
      const begin = this.runBegin[ring], end = this.runBegin[ring + 1];
      for (let run = begin; run < end; ++run) {
        const next = run + 1 < end ? run + 1 : begin;
        const curve = this.curves[this.curve[run]], other = this.curves[this.curve[next]];
        winding += crossing(placeOf(curve, this.last[run], place), placeOf(other, this.first[next], place));
        const first = this.first[run], last = this.last[run];
        winding += first <= last ? windingOf(curve, first, last, place) : -windingOf(curve, last, first, place);
      }
    }
    return winding;
  }
}

const placeOf = (curve, k, place) => place(curve.x[k], curve.y[k]);

// The part of the points first to last, upwards. Boxes to the right of the point count by their ends.
function windingOf(curve, first, last, place) {
  let winding = 0;
  curve.walk(first, last, (boxes, at, from, to) => {
    const [left, low] = place(boxes[at], boxes[at + 1]), [right, high] = place(boxes[at + 2], boxes[at + 3]);
    if (low > 0 || high <= 0 || right < 0) return false;
    if (left <= 0) return true;
    winding += crossing([1, placeOf(curve, from, place)[1]], [1, placeOf(curve, to, place)[1]]);
    return false;
  }, (from, to) => {
    for (let k = from; k < to; ++k) winding += crossing(placeOf(curve, k, place), placeOf(curve, k + 1, place));
  });
  return winding;
}

// Dots of a layer, in the order of a curve.
export class Dots extends Curve {
  get size() {
    return this.points;
  }
  box(dot) {
    return [this.x[dot], this.y[dot], this.x[dot], this.y[dot]];
  }
}

export class Lines {
  constructor(curves) {
    this.curves = curves;
    this.size = curves.length;
  }
  box(line) {
    return this.curves[line].curve.box();
  }
}

function sums(counts) {
  const begins = new Int32Array(counts.length + 1);
  for (let k = 0; k < counts.length; ++k) begins[k + 1] = begins[k] + counts[k];
  return begins;
}

// +1 or -1 where the segment crosses the ray from 0 to the right, upwards or downwards.
function crossing([u0, v0], [u1, v1]) {
  if ((v0 <= 0) === (v1 <= 0)) return 0;
  const side = u0 * (v1 - v0) - v0 * (u1 - u0);
  return v0 <= 0 ? (side > 0 ? 1 : 0) : side < 0 ? -1 : 0;
}
