// The part of the plane that is seen. Its centre is the sum of two doubles, x + dx, so that it moves smoothly where
// neighbouring doubles are pixels apart; differences to it are computed in double, and only these small numbers are drawn.

const DEEPEST = 1e-13; // of the whole: beyond, neighbouring doubles are further apart than pixels
const LARGEST = 1e305; // scale, so that pixels are finite
const FARTHEST = 1e307; // coordinate of the whole, and
const WIDEST = 1e308; // width of a view, so that it is a double

const finite = (pixels) => Math.min(Math.max(pixels, -1e300), 1e300); // differences of the largest doubles are not

export class View {
  constructor(box) {
    this.setBox(box);
    this.width = this.height = 1;
  }

  setBox(box) {
    const [minX, minY, maxX, maxY] = box[0] <= box[2]
      ? box.map((value) => Math.min(Math.max(value, -FARTHEST), FARTHEST)) : [-1, -1, 1, 1];
    this.whole = { x: minX / 2 + maxX / 2, y: minY / 2 + maxY / 2, width: maxX - minX, height: maxY - minY };
    const size = Math.max(this.whole.width, this.whole.height);
    this.size = size > 0 ? size : Math.max(Math.abs(this.whole.x), Math.abs(this.whole.y), 1);
  }

  resize(width, height) {
    const depth = this.scale === undefined ? undefined : this.depth;
    this.width = Math.max(width, 1);
    this.height = Math.max(height, 1);
    if (depth === undefined) this.reset();
    else this.scale = Math.min(depth * this.wholeScale, this.maxScale);
  }

  get wholeScale() {
    const { width, height } = this.whole, margin = 0.94;
    const across = width > 0 ? this.width / width : Infinity, up = height > 0 ? this.height / height : Infinity;
    const scale = Math.min(across, up);
    return margin * Math.min(scale === Infinity ? Math.min(this.width, this.height) / this.size : scale, LARGEST);
  }
  // A double has 2^-53 of its size; a view far from the origin ends earlier than one about it.
  get maxScale() {
    const far = Math.max(Math.abs(this.whole.x), Math.abs(this.whole.y), this.size);
    return Math.min(Math.min(this.width, this.height) / (DEEPEST * far), LARGEST);
  }
  limited(scale) {
    return Math.min(Math.max(scale, 0.2 * this.wholeScale, Math.max(this.width, this.height) / WIDEST), this.maxScale);
  }
  get depth() {
    return this.scale / this.wholeScale;
  }
  get atEnd() {
    return this.scale >= 0.999 * this.maxScale;
  }

  reset() {
    this.x = this.whole.x;
    this.y = this.whole.y;
    this.dx = this.dy = 0;
    this.scale = this.wholeScale;
  }

  // Pixels of a point, and the point at a pixel.
  px(x) {
    return finite((x - this.x - this.dx) * this.scale) + this.width / 2;
  }
  py(y) {
    return this.height / 2 - finite((y - this.y - this.dy) * this.scale);
  }
  at(px, py) {
    return [this.x + (this.dx + (px - this.width / 2) / this.scale),
            this.y + (this.dy + (this.height / 2 - py) / this.scale)];
  }
  // The box that is seen, and `margin` pixels round it.
  box(margin = 0) {
    const [minX, minY] = this.at(-margin, this.height + margin), [maxX, maxY] = this.at(this.width + margin, -margin);
    return [minX, minY, maxX, maxY];
  }

  pan(px, py) {
    this.dx -= px / this.scale;
    this.dy += py / this.scale;
    this.normalise();
  }
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const scale = this.limited(this.scale * factor);
    this.dx += (px - this.width / 2) * (1 / this.scale - 1 / scale);
    this.dy -= (py - this.height / 2) * (1 / this.scale - 1 / scale);
    this.scale = scale;
    this.normalise();
  }
  // Shows a box with some room about it.
  show([minX, minY, maxX, maxY], room = 0.7) {
    this.x = minX / 2 + maxX / 2;
    this.y = minY / 2 + maxY / 2;
    this.dx = this.dy = 0;
    const across = maxX - minX, up = maxY - minY;
    const scale = room * Math.min(across > 0 ? this.width / across : Infinity, up > 0 ? this.height / up : Infinity);
    this.scale = Number.isFinite(scale) ? Math.min(scale, this.maxScale) : this.scale;
  }
  // What dx has of x goes there; differences of doubles that are near each other are exact.
  normalise() {
    const x = this.x + this.dx, y = this.y + this.dy;
    this.dx -= x - this.x;
    this.dy -= y - this.y;
    this.x = x;
    this.y = y;
  }

  // "#x,y,scale" and back.
  toLink() {
    return `${this.x},${this.y},${this.scale / this.wholeScale}`;
  }
  fromLink(x, y, depth) {
    if (![x, y, depth].every(Number.isFinite) || !(depth > 0)) return false;
    this.x = x;
    this.y = y;
    this.dx = this.dy = 0;
    this.scale = this.limited(depth * this.wholeScale);
    return true;
  }
}
