// The page: the scene, the view, and what happens when.
import { paintAxes } from "./axes.js";
import { colourOf, paint } from "./draw.js";
import { csvOf, svgOf } from "./export.js";
import { listen } from "./gestures.js";
import { hits } from "./hit.js";
import { Measure } from "./measure.js";
import { describe, fillAbout, fillIterates, fillLayers, fillTableChoice } from "./panel.js";
import { loadScene } from "./scene.js";
import { Table } from "./table.js";
import { byId, download } from "./text.js";
import { apart } from "./tree.js";
import { View } from "./view.js";

const SLOW = 40; // milliseconds of a frame after which moving pictures are drawn with coarser steps

class Page {
  constructor(scene) {
    this.scene = scene;
    this.view = new View(scene.box);
    this.state = { iterate: null, selected: null };
    this.measure = new Measure();
    this.canvas = byId("picture");
    this.context = this.canvas.getContext("2d");
    this.dark = matchMedia("(prefers-color-scheme: dark)");
    this.dark.addEventListener("change", () => this.restyle());
    this.step = 0.5; // pixels between points while the picture moves
    this.scriptTime = 0; // milliseconds
    this.table = new Table({
      choose: (index) => this.select({ layer: this.table.source, index }),
      zoom: (index) => this.look(this.table.source, index),
      accepts: () => {
        const { source } = this.table, box = byId("in-view").checked ? this.view.box() : null;
        return (k) => !box || !apart(source.things.box(k), 0, box);
      },
    });
    byId("in-view").addEventListener("change", () => this.table.update());
    fillLayers(scene, () => this.redraw());
    fillAbout(scene);
    this.tableOf = fillTableChoice(scene, this.table);
    fillIterates(scene, (n) => {
      this.state.iterate = n;
      this.redraw();
    });
    this.restyle();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.resize();
    this.fromLink();
    addEventListener("hashchange", () => this.fromLink());
    this.buttons();
    listen(this.canvas, {
      pan: (px, py) => this.moved(() => this.view.pan(px, py)),
      zoom: (factor, px, py) => this.moved(() => this.view.zoom(factor, px, py)),
      whole: () => this.moved(() => this.view.reset()),
      hover: (px, py) => this.hover(px, py),
      leave: () => this.hover(null),
      click: (px, py) => this.click(px, py),
      double: (px, py) => this.double(px, py),
      escape: () => this.escape(),
      look: () => this.state.selected && this.look(this.state.selected.layer, this.state.selected.index),
    });
  }

  buttons() {
    const on = (id, action) => byId(id).addEventListener("click", action);
    on("zoom-in", () => this.moved(() => this.view.zoom(2)));
    on("zoom-out", () => this.moved(() => this.view.zoom(0.5)));
    on("whole", () => this.moved(() => this.view.reset()));
    on("measure", () => {
      this.measure.toggle();
      byId("measure").setAttribute("aria-pressed", String(this.measure.on));
      this.say(this.measure.on ? this.measure.text : "");
      this.redraw();
    });
    on("save-svg", () => download("view.svg", "image/svg+xml", this.svg()));
    on("save-csv", () => download("view.csv", "text/csv", this.csv()));
    on("panel-button", () => {
      const hidden = byId("panel").classList.toggle("folded");
      byId("panel-button").setAttribute("aria-expanded", String(!hidden));
    });
  }

  svg() {
    return svgOf(this.scene, this.view, this.state);
  }
  csv() {
    return csvOf(this.scene, this.view, this.state);
  }

  restyle() {
    const style = getComputedStyle(document.documentElement), read = (name) => style.getPropertyValue(name).trim();
    this.theme = { dark: this.dark.matches, ground: read("--ground"), ink: read("--ink"), grid: read("--grid") };
    for (const layer of this.scene.layers) layer.swatch?.style.setProperty("--colour", colourOf(layer, this.theme));
    this.redraw();
  }
  resize() {
    const { clientWidth, clientHeight } = this.canvas, ratio = devicePixelRatio || 1;
    this.canvas.width = Math.round(clientWidth * ratio);
    this.canvas.height = Math.round(clientHeight * ratio);
    this.ratio = ratio;
    this.view.resize(clientWidth, clientHeight);
    this.redraw();
  }

  moved(change) {
    change();
    this.moving = performance.now();
    this.redraw();
    clearTimeout(this.linkTimer);
    this.linkTimer = setTimeout(() => {
      this.moving = 0;
      if (this.step > 0.5) this.redraw();
      this.writeLink();
      if (byId("in-view").checked) this.table.update();
    }, 250);
  }
  // A canvas draws after the script has ended, so the time between frames tells how long they take; between frames that
  // are far apart nothing may have moved, and that of the script is what is known.
  adapt(now) {
    const between = now - this.lastFrame, took = between < 1000 ? between : this.scriptTime;
    this.lastFrame = now;
    const factor = took > SLOW ? Math.min(3, Math.max(1.3, Math.sqrt(took / SLOW))) : took < SLOW / 2 ? 0.9 : 1;
    this.step = Math.min(8, Math.max(0.5, this.step * factor));
  }
  redraw() {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.paint();
    });
  }
  paint() {
    const { context, view, theme, ratio } = this, begin = performance.now();
    if (this.moving) this.adapt(begin);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = theme.ground;
    context.fillRect(0, 0, view.width, view.height);
    const paintLabels = paintAxes(context, view, theme);
    paint(context, this.scene, view, this.state, this.moving ? this.step : 0.5, theme);
    this.measure.paint(context, view, theme);
    paintLabels();
    byId("zoom").textContent = `zoom ${Number(view.depth.toPrecision(3)).toLocaleString("en")}`;
    byId("end").hidden = !view.atEnd;
    this.scriptTime = performance.now() - begin;
  }

  say(text) {
    byId("status").textContent = text;
  }
  hover(px, py) {
    if (this.measure.on) return;
    if (px === null) return this.say(this.state.selected ? describe(this.state.selected) : "");
    const [x, y] = this.view.at(px, py);
    const found = hits(this.scene, this.view, this.state.iterate, px, py).slice(0, 3).map(describe);
    this.say([...found, `(${x}, ${y})`].join(" \u00b7 "));
  }
  thingAt(px, py) {
    const found = hits(this.scene, this.view, this.state.iterate, px, py);
    return found.find(({ layer }) => layer.kind !== "lines") ?? found[0] ?? null;
  }
  click(px, py) {
    this.canvas.focus({ preventScroll: true });
    if (this.measure.on) {
      const [exact] = hits(this.scene, this.view, this.state.iterate, px, py);
      const source = exact?.layer.curves?.[exact.index].curve ?? (exact?.layer.kind === "dots" ? exact.layer.things : null);
      this.measure.add(...(source ? [source.x[exact.point], source.y[exact.point]] : this.view.at(px, py)));
      this.say(this.measure.text);
      return this.redraw();
    }
    this.select(this.thingAt(px, py));
  }
  double(px, py) {
    if (this.measure.on) return this.click(px, py);
    const found = this.thingAt(px, py);
    if (found && found.layer.kind === "areas") return this.look(found.layer, found.index);
    this.moved(() => this.view.zoom(4, px, py));
  }
  escape() {
    if (this.measure.on) byId("measure").click();
    this.select(null);
  }
  select(thing) {
    this.state.selected = thing;
    if (thing) this.tableOf(thing.layer);
    this.table.mark(thing && thing.layer === this.table.source ? thing.index : null);
    this.say(thing ? describe(thing) : "");
    this.redraw();
  }
  look(layer, index) {
    this.select({ layer, index, point: 0 });
    const box = layer.things.box(index);
    this.moved(() => {
      this.view.show(box);
      if (layer.kind === "dots") this.view.zoom(Math.max(1, 1e4 / this.view.depth));
    });
  }

  // "#x,y,scale,layers": the layers that are shown, by number, with points between.
  writeLink() {
    const shown = this.scene.layers.flatMap((layer, k) => (layer.shown ? [k] : [])).join(".");
    const link = `#${this.view.toLink()},${shown}`;
    try {
      history.replaceState(null, "", link);
    } catch {
      // A page within another one has no address of its own.
    }
  }
  fromLink() {
    const [x, y, scale, layers] = location.hash.slice(1).replaceAll(/%2c/gi, ",").split(",");
    if (!scale || !this.view.fromLink(Number(x), Number(y), Number(scale))) return;
    if (layers !== undefined) {
      const shown = layers.split(".");
      this.scene.layers.forEach((layer, k) => {
        layer.shown = layer.box.checked = shown.includes(String(k));
      });
    }
    this.redraw();
  }
}

loadScene().then((scene) => {
  const page = new Page(scene);
  globalThis.lober = page; // for the console, and for tests
  byId("loading").hidden = true;
  document.documentElement.dataset.ready = "yes";
}, (error) => {
  byId("loading").textContent = `The data of this page cannot be read: ${error.message}. A browser of 2023 or later reads it.`;
});
