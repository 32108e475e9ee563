// The box tree of a curve, of the engine's kind: boxes of runs of consecutive segments, in one pass over the points, and
// boxes of four of these, and so on. A closed curve has its first point once more at the end. A box is four numbers from
// some position of an array on: min x, min y, max x, max y.

const LEAF = 16; // segments of a leaf
const FOUR = 4;

export const emptyBox = () => [Infinity, Infinity, -Infinity, -Infinity];

export function grow(box, x, y) {
  if (x < box[0]) box[0] = x;
  if (y < box[1]) box[1] = y;
  if (x > box[2]) box[2] = x;
  if (y > box[3]) box[3] = y;
}
export function growByBox(box, boxes, at = 0) { // which may be empty
  for (const k of [0, 1]) box[k] = Math.min(box[k], boxes[at + k]);
  for (const k of [2, 3]) box[k] = Math.max(box[k], boxes[at + k]);
}
// Whether boxes have no point in common.
export function apart(boxes, at, box) {
  return boxes[at] > box[2] || boxes[at + 2] < box[0] || boxes[at + 1] > box[3] || boxes[at + 3] < box[1];
}
export function smaller(boxes, at, size) {
  return boxes[at + 2] - boxes[at] < size && boxes[at + 3] - boxes[at + 1] < size;
}

export class Curve {
  constructor(x, y) {
    this.x = x;
    this.y = y;
    this.points = x.length;
    this.levels = []; // boxes of each level, from the leaves up
    if (this.points === 0) return;
    const leaves = Math.max(1, Math.ceil((this.points - 1) / LEAF));
    this.addLevel(leaves, (box, leaf) => {
      for (let k = leaf * LEAF, end = this.end(0, leaf); k <= end; ++k) grow(box, x[k], y[k]);
    });
    for (let count = leaves; count > 1; count = Math.ceil(count / FOUR)) {
      const boxes = this.levels[this.top];
      this.addLevel(Math.ceil(count / FOUR), (box, node) => {
        for (let k = node * FOUR, end = Math.min(count, k + FOUR); k < end; ++k) growByBox(box, boxes, 4 * k);
      });
    }
  }
  addLevel(count, fill) {
    const boxes = new Float64Array(4 * count);
    for (let node = 0; node < count; ++node) {
      const box = emptyBox();
      fill(box, node);
      boxes.set(box, 4 * node);
    }
    this.levels.push(boxes);
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

  // Calls visit(boxes, at, from, to, whole) from the top down for nodes with segments between points first and last: where
  // the box is, the first and last of these points in it, and whether it has no others. Children follow, in order, where
  // it returns true; leaf(from, to) is called for leaves of which that is true.
  walk(first, last, visit, leaf, level = this.top, node = 0) {
    if (level < 0) return;
    const begin = this.begin(level, node), end = this.end(level, node);
    if (end < first || begin > last || ((end === first || begin === last) && first < last)) return;
    const from = Math.max(begin, first), to = Math.min(end, last);
    if (!visit(this.levels[level], 4 * node, from, to, begin === from && end === to)) return;
    if (level === 0) {
      leaf(from, to);
      return;
    }
    const stop = Math.min((node + 1) * FOUR, this.levels[level - 1].length / 4);
    for (let child = node * FOUR; child < stop; ++child) this.walk(first, last, visit, leaf, level - 1, child);
  }

  // The box of the points first to last. O(log N).
  box(first = 0, last = this.points - 1) {
    const box = emptyBox();
    this.walk(first, last, (boxes, at, from, to, whole) => {
      if (whole) growByBox(box, boxes, at);
      return !whole;
    }, (from, to) => {
      for (let k = from; k <= to; ++k) grow(box, this.x[k], this.y[k]);
    });
    return box;
  }
}
