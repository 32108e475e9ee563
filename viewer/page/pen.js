// Lines and polygons in pixels: what leaves the frame is cut off in double before the canvas, which computes in float,
// sees it.

export const MARGIN = 64; // pixels beyond the frame that are still drawn

// Which cells of the frame a line has been to, so that a tangle that fills them is not drawn a hundred times over.
class Coverage {
  constructor(width, height, cell) {
    this.cell = cell;
    this.columns = Math.ceil((width + 2 * MARGIN) / cell) + 1;
    this.rows = Math.ceil((height + 2 * MARGIN) / cell) + 1;
    this.marks = new Uint8Array(this.columns * this.rows);
  }
  // Marks the cell of a point in the frame; whether it was marked before.
  mark(x, y) {
    const at = Math.floor((y + MARGIN) / this.cell) * this.columns + Math.floor((x + MARGIN) / this.cell);
    const before = this.marks[at];
    this.marks[at] = 1;
    return before === 1;
  }
}

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

// Draws lines. Short segments between cells of the size of a step that the line has been to are left out too.
export class LinePen extends Pen {
  constructor(path, width, height, step) {
    super(path, width, height, step);
    this.coverage = new Coverage(width, height, step);
    this.segments = 0; // that were drawn
    this.up();
  }
  up() {
    this.down = false;
  }
  to(x, y) {
    if (!this.down) {
      this.down = true;
      this.open = false; // whether the path has this.x, this.y as its last point
      this.seen = this.sees(x, y) && this.coverage.mark(x, y);
      this.x = x;
      this.y = y;
      return;
    }
    if (Math.abs(x - this.x) < this.step && Math.abs(y - this.y) < this.step) return;
    const x0 = this.x, y0 = this.y;
    this.x = x;
    this.y = y;
    if (this.sees(x0, y0) && this.sees(x, y)) {
      const before = this.seen;
      this.seen = this.coverage.mark(x, y);
      if (before && this.seen && Math.abs(x - x0) + Math.abs(y - y0) < 4 * this.step) {
        this.open = false;
        return;
      }
      if (!this.open) this.path.moveTo(x0, y0);
      this.path.lineTo(x, y);
      this.open = true;
      ++this.segments;
      return;
    }
    this.open = this.seen = false;
    const part = cut(x0, y0, x, y, this.right, this.bottom);
    if (!part) return;
    this.path.moveTo(part[0], part[1]);
    this.path.lineTo(part[2], part[3]);
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
