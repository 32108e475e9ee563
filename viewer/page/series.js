// Series of doubles and of points, as viewer/series.hpp writes them.
import { Predictor } from "./predictor.js";

const BLOCK = 512; // values of a block
export const PART = 65536; // values of a part
const LONG = 64, BREAK = 129; // symbols, less the bits of the number

const double = new Float64Array(1), words = new Uint32Array(double.buffer);

// The double n doubles after `value`, where the number is 2 n, or -2 n - 1 for n < 0.
function moved(value, low, high) {
  double[0] = value;
  let [l, h] = words;
  if (h >>> 31) {
    l = ~l >>> 0;
    h = ~h;
  } else {
    h |= 0x80000000;
  }
  const sign = -(low & 1), sum = l + (((low >>> 1 | high << 31) ^ sign) >>> 0);
  h = h + ((high >>> 1) ^ sign) + (sum > 0xffffffff ? 1 : 0) | 0;
  words[0] = h < 0 ? sum : ~sum;
  words[1] = h < 0 ? h & 0x7fffffff : ~h;
  return double[0];
}

// Bits of a number, the least significant one first.
class Bits {
  constructor(bytes, at) {
    Object.assign(this, { bytes, at, held: 0, count: 0 });
  }
  take(count) { // at most 24
    while (this.count < count) {
      this.held |= this.bytes[this.at++] << this.count;
      this.count += 8;
    }
    const value = this.held & (1 << count) - 1;
    this.held >>>= count;
    this.count -= count;
    return value;
  }
  word(count) {
    return count <= 24 ? this.take(count) : (this.take(16) | this.take(count - 16) << 16) >>> 0;
  }
}

function gridOf(code) {
  if (code === 0) return { scale: 1, offset: 0, none: true };
  return code > 16 ? { scale: 1, offset: 1.5 * 2 ** (code - 1948) } : { scale: Number(`1e${code - 1}`), offset: 1.5 * 2 ** 52 };
}

// Decodes `count` values, or points, into the arrays `axes` from `offset` on.
export function decodeSeries(bytes, count, axes, offset = 0) {
  const head = 1 + 2 * axes.length, symbols = Math.ceil(count / BLOCK) * head;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const bits = new Bits(bytes, symbols + axes.length * count), predictor = new Predictor(), point = [0, 0];
  let way = 0, grids = [];
  for (let k = 0; k < count; ++k) {
    if (k % BLOCK === 0) {
      const at = k / BLOCK * head;
      way = bytes[at];
      grids = axes.map((_, axis) => gridOf(view.getInt16(at + 1 + 2 * axis, true)));
    }
    const first = axes.length > 1 ? predictor.primary() : 0;
    let steps = 1, along = 1;
    for (let rank = 0; rank < axes.length; ++rank) {
      const axis = rank ^ first, symbol = bytes[symbols + rank * count + k];
      const width = symbol - (symbol < BREAK ? LONG : BREAK);
      let low = width < 0 ? symbol : 0, high = 0;
      if (width > 32) {
        low = bits.word(32);
        high = (bits.word(width - 33) | 1 << width - 33) >>> 0;
      } else if (width > 0) {
        low = (bits.word(width - 1) | 1 << width - 1) >>> 0;
      }
      const { scale, offset: zero, none } = grids[axis], expected = predictor.at(axis, along);
      point[axis] = none ? moved(expected, low, high) : (moved(expected * scale + zero, low, high) - zero) / scale;
      if (rank === 0 && axes.length > 1) {
        along = predictor.stepsTo(axis, point[axis]);
        if (symbol >= BREAK) steps = along;
      }
      axes[axis][offset + k] = point[axis];
    }
    predictor.add(point, steps, way);
  }
}

// The bytes of an element of the page, in base64 and perhaps deflated.
export async function bytesOf(text, deflated) {
  let bytes;
  if (Uint8Array.fromBase64) {
    bytes = Uint8Array.fromBase64(text);
  } else {
    const binary = atob(text);
    bytes = new Uint8Array(binary.length);
    for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  }
  if (!deflated) return bytes;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
