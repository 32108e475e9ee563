// Distances and areas between points that the user puts down.
import { rounded } from "./text.js";

export class Measure {
  constructor() {
    this.on = false;
    this.points = [];
  }
  toggle() {
    this.on = !this.on;
    this.points = [];
  }
  add(x, y) {
    this.points.push([x, y]);
  }

  // Differences to the first point first: they are exact where points are near each other.
  get text() {
    const n = this.points.length;
    if (n === 0) return "Measure: choose points; near a dot or a point of a curve it is taken exactly.";
    if (n === 1) return `From (${this.points[0].join(", ")}): choose the next point.`;
    const [x0, y0] = this.points[0];
    let length = 0, twice = 0;
    for (let k = 1; k < n; ++k) {
      const [x1, y1] = this.points[k - 1], [x2, y2] = this.points[k];
      length += Math.hypot(x2 - x1, y2 - y1);
      twice += (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    }
    const area = n > 2 ? `, signed area ${rounded(twice / 2, 10)}` : "";
    return `${n} points, length ${rounded(length, 10)}${area}`;
  }

  paint(context, view, theme) {
    if (this.points.length === 0) return;
    context.strokeStyle = context.fillStyle = theme.ink;
    context.lineWidth = 1.5;
    context.setLineDash([5, 4]);
    context.beginPath();
    const limit = (value) => Math.min(Math.max(value, -1e5), 1e5);
    this.points.forEach(([x, y], k) => {
      const px = limit(view.px(x)), py = limit(view.py(y));
      if (k === 0) context.moveTo(px, py);
      else context.lineTo(px, py);
    });
    if (this.points.length > 2) context.closePath();
    context.stroke();
    context.setLineDash([]);
    for (const [x, y] of this.points) {
      context.beginPath();
      context.arc(limit(view.px(x)), limit(view.py(y)), 4, 0, 2 * Math.PI);
      context.fill();
    }
  }
}
