// The panel beside the picture: layers, the table, iterates, and what is known about the page.
import { nameOf } from "./scene.js";
import { byId, element, rounded, upright, withBar } from "./text.js";

// A name within a line: so short that the rest is seen.
function shortName(name) {
  const plain = upright(name);
  return plain.length > 60 ? `${plain.slice(0, 59)}\u2026` : plain;
}

// One line about a thing: its name, numbers with error bars, and the point of a curve.
export function describe({ layer, index, point }) {
  if (layer.kind === "lines") {
    const one = layer.curves[index];
    return `${shortName(one.name)}: point ${point} of ${one.n} (${one.curve.x[point]}, ${one.curve.y[point]})`;
  }
  const numbers = layer.columns
    .filter(({ values }) => Number.isFinite(values[index]))
    .map(({ name, values, bars }) => `${name} ${bars ? withBar(values[index], bars[index]) : rounded(values[index], 10)}`);
  const at = layer.kind === "dots" ? [`at (${layer.things.x[index]}, ${layer.things.y[index]})`] : [];
  return `${shortName(nameOf(layer, index))}: ${[...numbers, ...at].join(", ")}`;
}

function pointsText(count) {
  return `${count.toLocaleString("en")} ${count === 1 ? "point" : "points"}`;
}

export function fillLayers(scene, changed) {
  byId("layers").replaceChildren(...scene.layers.map((layer) => {
    const box = element("input", { type: "checkbox", checked: layer.shown });
    box.addEventListener("change", () => {
      layer.shown = box.checked;
      changed();
    });
    layer.box = box;
    const swatch = element("span", { className: `swatch ${layer.kind}`, "aria-hidden": "true" });
    layer.swatch = swatch;
    const size = layer.kind === "lines"
      ? pointsText(layer.curves.reduce((sum, one) => sum + one.n, 0))
      : layer.things.size.toLocaleString("en");
    const texts = [["name", layer.name], ["size", size]].map(([className, text]) => element("span", { className }, text));
    return element("li", {}, element("label", {}, box, swatch, ...texts));
  }));
}

export function fillAbout(scene) {
  const notes = [...scene.notes, `${pointsText(scene.points)}, of curves and of corners between them.`];
  notes.push(scene.rounded
    ? "Points near crossings and of short curves are exact; exact ones of all curves would take more than 12 MB, so " +
      "others are rounded to 2^-50 of the size of their curve."
    : "All points are exact, to the last bit.");
  byId("notes").replaceChildren(...notes.map((note) => element("li", {}, upright(note))));
}

function columnsOf(layer) {
  const name = { name: "name", value: (k) => nameOf(layer, k), text: (k) => nameOf(layer, k), rank: (k) => k };
  return [name, ...layer.columns.map(({ name, values, bars }) => ({
    name,
    value: (k) => values[k],
    text: (k) => (bars ? withBar(values[k], bars[k]) : rounded(values[k], 8)),
    rank: (k) => (name === "area" ? Math.abs(values[k]) : values[k]),
  }))];
}

// The choice of the layer of the table; layers of lines have no table. Gives the function that shows a layer.
export function fillTableChoice(scene, table) {
  const layers = scene.layers.filter((layer) => layer.kind !== "lines" && layer.n > 0);
  const choice = byId("table-layer");
  const show = (layer) => {
    if (!layers.includes(layer) || table.source === layer) return;
    choice.value = String(layers.indexOf(layer));
    table.show(layer, layer.n, columnsOf(layer));
  };
  choice.replaceChildren(...layers.map((layer, k) => element("option", { value: String(k) }, layer.name)));
  choice.addEventListener("change", () => show(layers[Number(choice.value)]));
  byId("table-part").hidden = layers.length === 0;
  show(layers.find((layer) => layer.kind === "areas") ?? layers[0]);
  return show;
}

// Iterates one after the other; `show(n)` with null for all of them.
export function fillIterates(scene, show) {
  const { iterates } = scene, slider = byId("iterate"), play = byId("play"), text = byId("iterate-text");
  byId("iterates-part").hidden = iterates.length < 2;
  slider.max = String(iterates.length);
  let timer = null;
  const set = (at) => {
    slider.value = String(at);
    const n = at === 0 ? null : iterates[at - 1];
    text.textContent = n === null ? "all" : `n = ${n}`;
    slider.setAttribute("aria-valuetext", text.textContent);
    show(n);
  };
  const stop = () => {
    clearInterval(timer);
    timer = null;
    play.textContent = "Play";
  };
  slider.addEventListener("input", () => {
    stop();
    set(Number(slider.value));
  });
  play.addEventListener("click", () => {
    if (timer !== null) return stop();
    play.textContent = "Stop";
    let at = Number(slider.value) % iterates.length;
    set(++at);
    timer = setInterval(() => set(at = at % iterates.length + 1), 900);
  });
}
