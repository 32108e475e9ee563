// Mouse, touch and keys on the picture.

const WHEEL = 0.0022; // powers of e a pixel of the wheel
const KEY_STEP = 60; // pixels

// `on` has pan(px, py), zoom(factor, px, py), hover(px, py), leave(), click(px, py), double(px, py), whole(), escape().
export function listen(canvas, on) {
  const pointers = new Map();
  let moved = 0, last = { time: 0, x: 0, y: 0 };
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const middle = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, span: Math.hypot(a.x - b.x, a.y - b.y) };
  };

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pointers.set(event.pointerId, at(event));
    try {
      canvas.setPointerCapture(event.pointerId);
    } catch {
      // A pointer that scripts make cannot be captured.
    }
    if (pointers.size === 1) moved = 0;
    else moved = Infinity;
  });
  canvas.addEventListener("pointermove", (event) => {
    const here = at(event), before = pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType !== "touch") on.hover(here.x, here.y);
      return;
    }
    if (pointers.size === 2) {
      const old = middle();
      pointers.set(event.pointerId, here);
      const now = middle();
      on.pan(now.x - old.x, now.y - old.y);
      if (old.span > 0 && now.span > 0) on.zoom(now.span / old.span, now.x, now.y);
      return;
    }
    moved += Math.abs(here.x - before.x) + Math.abs(here.y - before.y);
    pointers.set(event.pointerId, here);
    if (moved > 4) on.pan(here.x - before.x, here.y - before.y);
  });
  const released = (event) => {
    if (!pointers.delete(event.pointerId) || event.type === "pointercancel" || pointers.size > 0 || moved > 4) return;
    const here = at(event), now = event.timeStamp;
    const twice = now - last.time < 400 && Math.hypot(here.x - last.x, here.y - last.y) < 24;
    last = { time: twice ? 0 : now, ...here };
    if (twice) on.double(here.x, here.y);
    else on.click(here.x, here.y);
  };
  canvas.addEventListener("pointerup", released);
  canvas.addEventListener("pointercancel", released);
  canvas.addEventListener("pointerleave", () => on.leave());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 20 : event.deltaMode === 2 ? 400 : 1;
    const delta = Math.min(Math.max(event.deltaY * lines, -300), 300), { x, y } = at(event);
    on.zoom(Math.exp(-delta * WHEEL * (event.ctrlKey ? 4 : 1)), x, y); // a pinch on a touchpad has ctrlKey
  }, { passive: false });

  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 5 * KEY_STEP : KEY_STEP;
    const keys = {
      ArrowLeft: () => on.pan(step, 0),
      ArrowRight: () => on.pan(-step, 0),
      ArrowUp: () => on.pan(0, step),
      ArrowDown: () => on.pan(0, -step),
      "+": () => on.zoom(1.5),
      "=": () => on.zoom(1.5),
      "-": () => on.zoom(1 / 1.5),
      0: () => on.whole(),
      Home: () => on.whole(),
      Escape: () => on.escape(),
      Enter: () => on.look(),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
}
