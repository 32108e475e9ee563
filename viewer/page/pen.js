// Lines and polygons in pixels: what leaves the frame is cut off in double before the canvas, which computes in float,
// sees it.

export const MARGIN = 64; // pixels beyond the frame that are still drawn

// `path` is a Path2D, or TextPath; points nearer than `step` pixels to the last one are left out.
class Pen {
  constructor(path, width, height, step) {
    this.path = path;
    this.step = step;
    this.right = width + MARGIN;
    this.bottom = height + MARGIN;
  }
  sees(x, y) {
    return x >= -MARGIN && x <= this.right && y >= -MARGIN && y <= this.bottom;
  }
}

// Draws lines.
export class LinePen extends Pen {
  segments = 0; // that were drawn
  down = false;

  up() {
    this.down = false;
  }
  to(x, y) {
    if (!this.down) {
      this.down = true;
      this.open = false; // whether the path has this.x, this.y as its last point
      this.x = x;
      this.y = y;
      return;
    }
    if (Math.abs(x - this.x) < this.step && Math.abs(y - this.y) < this.step) return;
    const x0 = this.x, y0 = this.y, within = this.sees(x0, y0) && this.sees(x, y);
    const part = within ? [x0, y0, x, y] : cut(x0, y0, x, y, this.right, this.bottom);
    this.x = x;
    this.y = y;
    if (part) {
      if (!within || !this.open) this.path.moveTo(part[0], part[1]);
      this.path.lineTo(part[2], part[3]);
      ++this.segments;
    }
    this.open = within;
  }
}

// The part of a segment in the frame (Liang & Barsky 1984); null if there is none.
function cut(x0, y0, x1, y1, right, bottom) {
  let from = 0, to = 1;
  const dx = x1 - x0, dy = y1 - y0;
  for (const [p, q] of [[-dx, x0 + MARGIN], [dx, right - x0], [-dy, y0 + MARGIN], [dy, bottom - y0]]) {
    if (p === 0) {
      if (q < 0) return null;
    } else if (p < 0) {
      from = Math.max(from, q / p);
    } else {
      to = Math.min(to, q / p);
    }
  }
  return from > to ? null : [x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy];
}

// Collects the corners of a ring and puts it into a path, cut to the frame.
export class RingPen extends Pen {
  x = [];
  y = [];
  outside = false;

  to(x, y) {
    const n = this.x.length;
    if (n > 0 && Math.abs(x - this.x[n - 1]) < this.step && Math.abs(y - this.y[n - 1]) < this.step) return;
    if (!this.sees(x, y)) this.outside = true;
    this.x.push(x);
    this.y.push(y);
  }
  close() {
    let { x, y } = this;
    // Side by side (Sutherland & Hodgman 1974): edges along the frame join parts that lie apart, and enclose nothing.
    if (this.outside) {
      [x, y] = half(x, y, -MARGIN, 1);
      [x, y] = half(x, y, this.right, -1);
      [y, x] = half(y, x, -MARGIN, 1);
      [y, x] = half(y, x, this.bottom, -1);
    }
    if (x.length > 1) {
      this.path.moveTo(x[0], y[0]);
      for (let k = 1; k < x.length; ++k) this.path.lineTo(x[k], y[k]);
      this.path.closePath();
    }
    this.x = [];
    this.y = [];
    this.outside = false;
  }
}

// The part of a polygon where sign * u >= sign * bound.
function half(u, v, bound, sign) {
  const outU = [], outV = [], n = u.length;
  for (let k = 0; k < n; ++k) {
    const j = k === 0 ? n - 1 : k - 1;
    const before = sign * (u[j] - bound) >= 0, here = sign * (u[k] - bound) >= 0;
    if (before !== here) {
      outU.push(bound);
      outV.push(v[j] + (v[k] - v[j]) * ((bound - u[j]) / (u[k] - u[j])));
    }
    if (here) {
      outU.push(u[k]);
      outV.push(v[k]);
    }
  }
  return [outU, outV];
}

// A path as the text of SVG.
export class TextPath {
  constructor() {
    this.text = "";
  }
  moveTo(x, y) {
    this.text += `M${+x.toFixed(2)} ${+y.toFixed(2)}`;
  }
  lineTo(x, y) {
    this.text += `L${+x.toFixed(2)} ${+y.toFixed(2)}`;
  }
  closePath() {
    this.text += "Z";
  }
  rect(x, y, width, height) {
    this.moveTo(x, y);
    this.lineTo(x + width, y);
    this.lineTo(x + width, y + height);
    this.lineTo(x, y + height);
    this.closePath();
  }
  arc(x, y, radius) {
    this.text += `M${+(x - radius).toFixed(2)} ${+y.toFixed(2)}a${radius} ${radius} 0 1 0 ${2 * radius} 0` +
      `a${radius} ${radius} 0 1 0 ${-2 * radius} 0`;
  }
}
