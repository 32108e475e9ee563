// Where the next point of a curve is expected, as viewer/predictor.hpp has it, operation by operation.

// Shares of what was unexpected that position and derivatives take.
function gains(degree, m) {
  const c = 1 - m;
  return [
    [c, 0, 0, 0],
    [1 - m * m, c * c, 0, 0],
    [1 - m * m * m, 1.5 * (c * c) * (1 + m), 0.5 * (c * c * c), 0],
    [1 - m * m * m * m, c * c * (11 + 14 * m + 11 * (m * m)) / 6, c * c * c * (1 + m), c * c * c * c / 6],
  ][degree];
}
const FIRST = [0, 1, 2, 3].map((degree) => gains(degree, 0));
const WAYS = [[0, 0.75], [1, 0], [2, 0], [2, 0.5], [3, 0], [3, 0.3], [3, 0.5], [3, 0.7]].map(([degree, m]) => gains(degree, m));

export class Predictor {
  constructor() {
    this.taylor = [new Float64Array(4), new Float64Array(4)];
    this.points = 0;
  }
  at(axis, steps) {
    const c = this.taylor[axis], value = c[0] + steps * (c[1] + steps * (c[2] + steps * c[3]));
    return Number.isNaN(value) ? 0 : value;
  }
  stepsTo(axis, value) {
    const c = this.taylor[axis];
    let steps = 1;
    for (let k = 0; k < 2; ++k) {
      steps += (value - this.at(axis, steps)) / (c[1] + steps * (2 * c[2] + 3 * steps * c[3]));
    }
    return steps > 0.125 && steps < 8 ? steps : 1;
  }
  primary() {
    return Math.abs(this.taylor[1][1]) > Math.abs(this.taylor[0][1]) ? 1 : 0;
  }
  add(point, steps, way) {
    const gain = this.points < 4 ? FIRST[this.points++] : WAYS[way];
    let valid = true;
    for (let axis = 0; axis < 2; ++axis) {
      const c = this.taylor[axis];
      const c1 = c[1] * steps, c2 = c[2] * (steps * steps), c3 = c[3] * (steps * steps * steps);
      const expected = c[0] + c1 + c2 + c3, error = point[axis] - expected;
      c[0] = expected + gain[0] * error;
      c[1] = c1 + 2 * c2 + 3 * c3 + gain[1] * error;
      c[2] = c2 + 3 * c3 + gain[2] * error;
      c[3] = c3 + gain[3] * error;
      valid = valid && Number.isFinite(c[0] + c[1] + c[2] + c[3]);
    }
    if (valid) return;
    this.points = 1;
    for (let axis = 0; axis < 2; ++axis) this.taylor[axis].set([Number.isFinite(point[axis]) ? point[axis] : 0, 0, 0, 0]);
  }
}
