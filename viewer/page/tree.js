// The box tree of a curve, of the engine's kind: boxes of runs of consecutive segments, in one pass over the points, and
// boxes of four of these, and so on. A closed curve has its first point once more at the end.

const LEAF = 16; // segments of a leaf
const FOUR = 4;

export class Curve {
  constructor(x, y) {
    this.x = x;
    this.y = y;
    this.points = x.length;
    this.levels = []; // of each level, from the leaves up, the boxes: min x, min y, max x, max y
    this.build();
  }

  build() {
    const { x, y, points } = this;
    if (points === 0) return;
    const leaves = Math.max(1, Math.ceil((points - 1) / LEAF));
    let boxes = new Float64Array(4 * leaves);
    for (let leaf = 0; leaf < leaves; ++leaf) {
      let minX = Infinity, minY = Infinity, maxX = -Infinity, maxY = -Infinity;
      const end = Math.min(points - 1, (leaf + 1) * LEAF);
      for (let k = leaf * LEAF; k <= end; ++k) {
        const px = x[k], py = y[k];
        if (px < minX) minX = px;
        if (px > maxX) maxX = px;
        if (py < minY) minY = py;
        if (py > maxY) maxY = py;
      }
      boxes[4 * leaf] = minX;
      boxes[4 * leaf + 1] = minY;
      boxes[4 * leaf + 2] = maxX;
      boxes[4 * leaf + 3] = maxY;
    }
    this.levels.push(boxes);
    for (let count = leaves; count > 1; count = boxes.length / 4) {
      const parents = Math.ceil(count / FOUR), above = new Float64Array(4 * parents);
      for (let p = 0; p < parents; ++p) {
        const box = unionOf(boxes, p * FOUR, Math.min(count, (p + 1) * FOUR));
        above.set(box, 4 * p);
      }
      boxes = above;
      this.levels.push(boxes);
    }
  }

  get top() {
    return this.levels.length - 1;
  }

  // Numbers of the first and last point of a node.
  begin(level, node) {
    return node * LEAF * FOUR ** level;
  }
  end(level, node) {
    return Math.min(this.points - 1, (node + 1) * LEAF * FOUR ** level);
  }
  nodes(level) {
    return this.levels[level].length / 4;
  }

  // Calls visit(level, node, boxes) from the top down for nodes with segments between points first and last; children
  // follow, in order, where it returns true. leaf(begin, end) is called for leaves of which that is true.
  walk(first, last, visit, leaf) {
    if (this.points > 0) this.walkFrom(this.top, 0, first, last, visit, leaf);
  }
  walkFrom(level, node, first, last, visit, leaf) {
    const begin = this.begin(level, node), end = this.end(level, node);
    if (end < first || begin > last || (end === first && first < last) || (begin === last && first < last)) return;
    if (!visit(level, node, this.levels[level])) return;
    if (level === 0) {
      leaf(Math.max(begin, first), Math.min(end, last));
      return;
    }
    const stop = Math.min((node + 1) * FOUR, this.nodes(level - 1));
    for (let child = node * FOUR; child < stop; ++child) this.walkFrom(level - 1, child, first, last, visit, leaf);
  }

  // The box of the points first to last. O(log N).
  box(first = 0, last = this.points - 1) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    this.walk(first, last, (level, node, boxes) => {
      if (this.begin(level, node) < first || this.end(level, node) > last) return true;
      grow(box, boxes[4 * node], boxes[4 * node + 1]);
      grow(box, boxes[4 * node + 2], boxes[4 * node + 3]);
      return false;
    }, (begin, end) => {
      for (let k = begin; k <= end; ++k) grow(box, this.x[k], this.y[k]);
    });
    return box;
  }
}

export function grow(box, x, y) {
  if (x < box[0]) box[0] = x;
  if (y < box[1]) box[1] = y;
  if (x > box[2]) box[2] = x;
  if (y > box[3]) box[3] = y;
}

function unionOf(boxes, first, end) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = first; k < end; ++k) {
    grow(box, boxes[4 * k], boxes[4 * k + 1]);
    grow(box, boxes[4 * k + 2], boxes[4 * k + 3]);
  }
  return box;
}
