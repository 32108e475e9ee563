// Axes: as many digits as the view needs. Deep in, labels are counted from a rounded number that is written once.

const SPACING = 110; // pixels between labels, about

// Ticks of one axis: { at: offset from the centre, text }, and `origin`, the number that they are counted from, if any.
export function ticks(centre, offset, span, pixels) {
  const rough = span / pixels * SPACING;
  const decade = Math.floor(Math.log10(rough)), power = 10 ** decade;
  const step = [1, 2, 5, 10].find((one) => one * power >= rough) * power;
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const far = Math.abs(centre) > 2e3 * step;
  // A number with so few digits, up to that of 10^-places, that ticks beside it have one or two.
  const places = -decade - 2, digits = Math.floor(Math.log10(Math.abs(centre))) + places + 1;
  const origin = far ? Number(centre.toPrecision(Math.min(digits, 17))) : 0;
  const shift = origin - centre - offset;
  const list = [];
  for (let k = Math.ceil((-span / 2 - shift) / step); k * step + shift <= span / 2; ++k) {
    const value = k * step;
    const text = far ? `${k < 0 ? "\u2212" : "+"}${Math.abs(Math.round(value / power))}` : plain(value, decimals);
    list.push({ at: value + shift, text: far && k === 0 ? "0" : text });
  }
  const number = places >= 0 && places <= 20 ? origin.toFixed(places) : String(origin);
  const name = `${number} + n\u00b7${decade === 0 ? 1 : `1e${decade}`}`;
  return { list, origin: far ? name.replaceAll("-", "\u2212") : "" };
}

function plain(value, decimals) {
  const size = Math.abs(value), short = size === 0 ? decimals < 8 : size < 1e7 && size >= 1e-4;
  return (short ? value.toFixed(decimals) : String(Number(value.toPrecision(6)))).replaceAll("-", "\u2212");
}

// Pixels of the lines of both axes, and labels along the lower and the left edge: { text, x, y, align }.
export function axes({ x, dx, y, dy, width, height, scale }) {
  const across = ticks(x, dx, width / scale, width), up = ticks(y, dy, height / scale, height);
  const columns = across.list.map(({ at }) => width / 2 + at * scale), rows = up.list.map(({ at }) => height / 2 - at * scale);
  const labels = [];
  across.list.forEach(({ text }, k) => {
    const half = 3.5 * text.length; // pixels, about
    if (columns[k] - half > 40 && columns[k] + half < width) labels.push({ text, x: columns[k], y: height - 6, align: "center" });
  });
  up.list.forEach(({ text }, k) => {
    if (rows[k] > 20 && rows[k] < height - 22) labels.push({ text, x: 5, y: rows[k] + 4, align: "left" });
  });
  if (across.origin) labels.push({ text: `x = ${across.origin}`, x: width - 8, y: height - 24, align: "right" });
  if (up.origin) labels.push({ text: `y = ${up.origin}`, x: 5, y: 14, align: "left" });
  return { columns, rows, labels };
}

// Draws the lines; returns the function that draws the labels, over everything else.
export function paintAxes(context, view, theme) {
  const { columns, rows, labels } = axes(view);
  context.lineWidth = 1;
  context.strokeStyle = theme.grid;
  context.beginPath();
  for (const x of columns) {
    context.moveTo(Math.round(x) + 0.5, 0);
    context.lineTo(Math.round(x) + 0.5, view.height);
  }
  for (const y of rows) {
    context.moveTo(0, Math.round(y) + 0.5);
    context.lineTo(view.width, Math.round(y) + 0.5);
  }
  context.stroke();
  return () => {
    context.font = "12px system-ui, sans-serif";
    context.strokeStyle = theme.ground;
    context.fillStyle = theme.ink;
    context.lineWidth = 3;
    for (const { text, x, y, align } of labels) {
      context.textAlign = align;
      context.strokeText(text, x, y);
      context.fillText(text, x, y);
    }
  };
}
