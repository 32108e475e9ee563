// Series of doubles, as viewer/series.hpp writes them.

const BLOCK = 512; // values of a block
export const PART = 65536; // values of a part

const powers = [1, 2 ** 8, 2 ** 16, 2 ** 24, 2 ** 32, 2 ** 40, 2 ** 48];

// Decodes `count` values into `out` from `offset` on, which lie `stride` apart there.
export function decodeSeries(bytes, count, out, offset = 0) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const blocks = Math.ceil(count / BLOCK);
  let heads = 4 * blocks;
  let planes = heads;
  for (let b = 0; b < blocks; ++b) planes += 8 * bytes[4 * b];
  const word = new DataView(new ArrayBuffer(8));
  for (let b = 0; b < blocks; ++b) {
    const begin = offset + b * BLOCK, size = Math.min(BLOCK, count - b * BLOCK);
    const order = bytes[4 * b], width = bytes[4 * b + 1], exponent = view.getInt16(4 * b + 2, true);
    const numbers = size - order;
    if (order === 0) {
      for (let k = 0; k < size; ++k) {
        for (let j = 0; j < 8; ++j) word.setUint8(j, bytes[planes + j * size + k]);
        out[begin + k] = word.getFloat64(0, true);
      }
    } else {
      const base = view.getFloat64(heads, true);
      out[begin] = 0;
      for (let k = 1; k < order; ++k) out[begin + k] = view.getFloat64(heads + 8 * k, true);
      for (let k = 0; k < numbers; ++k) {
        let low = bytes[planes + k], half;
        const odd = low & 1;
        for (let j = 1; j < width; ++j) low += bytes[planes + j * numbers + k] * powers[j];
        half = (low - odd) / 2;
        out[begin + order + k] = odd ? -half - 1 : half;
      }
      for (let d = order; d >= 1; --d) {
        for (let k = begin + d, end = begin + size; k < end; ++k) out[k] += out[k - 1];
      }
      const low = exponent < -1000 ? 2 ** -1000 : 1, unit = 2 ** (exponent < -1000 ? exponent + 1000 : exponent);
      // Rounded once: products with powers of two are exact.
      for (let k = begin, end = begin + size; k < end; ++k) out[k] = out[k] === 0 ? base : base + out[k] * unit * low;
    }
    heads += 8 * order;
    planes += (order === 0 ? size : numbers) * width;
  }
  return out;
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
