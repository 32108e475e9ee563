// Axes: as many digits as the view needs. Deep in, labels are counted from a rounded number that is written once.

const SPACING = 110; // pixels between labels, about

// Ticks of one axis: { at: offset from the centre, text }, and `origin`, the number that they are counted from, if any.
export function ticks(centre, offset, span, pixels) {
  const rough = span * SPACING / pixels;
  const decade = Math.floor(Math.log10(rough)), power = 10 ** decade;
  const step = [1, 2, 5, 10].find((one) => one * power >= rough) * power;
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const far = Math.abs(centre) > 2e3 * step;
  // A number with so few decimals that ticks beside it have one or two digits.
  const places = -decade - 2;
  const origin = !far ? 0 : places >= 0 ? Number(centre.toFixed(Math.min(100, places))) : Math.round(centre * 10 ** places) / 10 ** places;
  const shift = origin - centre - offset;
  const list = [];
  for (let k = Math.ceil((-span / 2 - shift) / step); k * step + shift <= span / 2; ++k) {
    const value = k * step;
    const text = far ? `${k < 0 ? "\u2212" : "+"}${Math.abs(Math.round(value / power))}` : plain(value, decimals);
    list.push({ at: value + shift, text: far && k === 0 ? "0" : text });
  }
  const name = !far ? "" : `${places >= 0 ? origin.toFixed(Math.min(100, places)) : origin} + n\u00b7${exponent(decade)}`;
  return { list, origin: name.replace("-", "\u2212"), decimals };
}

function plain(value, decimals) {
  const size = Math.abs(value);
  const text = size !== 0 && (size >= 1e7 || size < 1e-4) ? String(Number(value.toPrecision(6))) : value.toFixed(decimals);
  return text.replace("-", "\u2212");
}

function exponent(decade) {
  return decade === 0 ? "1" : `1e${decade}`;
}

// Draws both axes along the lower and left edge; returns the texts for SVG.
export function axes(view) {
  const across = ticks(view.x, view.dx, view.width / view.scale, view.width);
  const up = ticks(view.y, view.dy, view.height / view.scale, view.height);
  return {
    x: across.list.map(({ at, text }) => ({ px: view.width / 2 + at * view.scale, text })),
    y: up.list.map(({ at, text }) => ({ px: view.height / 2 - at * view.scale, text })),
    originX: across.origin && `x = ${across.origin}`,
    originY: up.origin && `y = ${up.origin}`,
  };
}

export function paintAxes(context, view, theme) {
  const { x, y, originX, originY } = axes(view);
  context.font = "12px system-ui, sans-serif";
  context.lineWidth = 1;
  context.strokeStyle = theme.grid;
  context.beginPath();
  for (const { px } of x) {
    context.moveTo(Math.round(px) + 0.5, 0);
    context.lineTo(Math.round(px) + 0.5, view.height);
  }
  for (const { px } of y) {
    context.moveTo(0, Math.round(px) + 0.5);
    context.lineTo(view.width, Math.round(px) + 0.5);
  }
  context.stroke();
  const label = (text, px, py, align) => {
    context.textAlign = align;
    context.strokeStyle = theme.ground;
    context.lineWidth = 3;
    context.strokeText(text, px, py);
    context.fillStyle = theme.ink;
    context.fillText(text, px, py);
  };
  return () => {
    for (const { px, text } of x) if (px > 46 && px < view.width - 14) label(text, px, view.height - 6, "center");
    for (const { px, text } of y) if (px > 20 && px < view.height - 22) label(text, 5, px + 4, "left");
    if (originX) label(originX, view.width - 8, view.height - 24, "right");
    if (originY) label(originY, 5, 14, "left");
  };
}
