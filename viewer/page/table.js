// The table of a layer's areas or dots: sorted, filtered, and only as many rows in the page as are seen.
import { fillHeads, filterOf } from "./columns.js";
import { boxOfThing, nameOf } from "./scene.js";
import { byId, element, rounded, withBar } from "./text.js";
import { apart } from "./tree.js";

const ROW = 28; // pixels, as in page.css

export class Table {
  // `choose(layer, index)` is called for a click on a row, `zoom(layer, index)` for a double one.
  constructor({ choose, zoom, inView }) {
    Object.assign(this, { choose, zoom, inView });
    this.layer = null;
    this.rows = [];
    this.sort = { column: 0, down: false };
    this.scroller = byId("rows");
    this.scroller.addEventListener("scroll", () => this.fill());
    byId("filter").addEventListener("input", () => this.update());
    byId("in-view").addEventListener("change", () => this.update());
  }

  show(layer) {
    this.layer = layer;
    this.sort = { column: 0, down: false };
    this.head();
    this.update();
  }

  // Names come in the order of the layer, and numbers begin with the largest.
  head() {
    fillHeads(["name", ...this.layer.columns.map(({ name }) => name)], this.sort, (column) => {
      this.sort = { column, down: this.sort.column === column ? !this.sort.down : column > 0 };
      this.head();
      this.update();
    });
  }

  accepts() {
    const { layer } = this, box = byId("in-view").checked ? this.inView() : null;
    const matches = filterOf(layer.columns.map(({ name }) => name), (k, column) => layer.columns[column].values[k],
      (k, text) => nameOf(layer, k).toLowerCase().includes(text));
    return (k) => matches(k) && (!box || !apart(boxOfThing(layer, k), 0, box));
  }

  update() {
    const { layer } = this;
    if (!layer) return;
    const accepts = this.accepts(), { column, down } = this.sort, rows = [];
    for (let k = 0; k < layer.n; ++k) if (accepts(k)) rows.push(k);
    if (column > 0) {
      const { name, values } = layer.columns[column - 1], sign = down ? -1 : 1;
      const size = name === "area" ? Math.abs : (value) => value;
      rows.sort((a, b) => {
        const unknown = Number.isNaN(values[a]) - Number.isNaN(values[b]);
        return unknown || sign * (size(values[a]) - size(values[b])) || a - b;
      });
    } else if (down) {
      rows.reverse();
    }
    this.rows = rows;
    byId("count").textContent = rows.length === layer.n ? `${layer.n}` : `${rows.length} of ${layer.n}`;
    this.fill();
  }

  fill() {
    const { layer, rows, scroller } = this;
    if (!layer) return;
    const first = Math.max(0, Math.floor(scroller.scrollTop / ROW) - 10);
    const last = Math.min(rows.length, first + Math.ceil(Math.max(scroller.clientHeight, 300) / ROW) + 20);
    const space = (height) => {
      const cell = element("td", { colSpan: layer.columns.length + 1 });
      cell.style.height = `${height}px`;
      cell.style.padding = "0";
      return element("tr", { "aria-hidden": "true" }, cell);
    };
    const body = [space(first * ROW)];
    for (let r = first; r < last; ++r) body.push(this.row(rows[r]));
    body.push(space((rows.length - last) * ROW));
    const focused = document.activeElement?.dataset.thing;
    byId("body").replaceChildren(...body);
    if (focused !== undefined) this.focus(focused);
  }

  // Moves the focus to the row of a thing, if it is in the page.
  focus(k) {
    this.scroller.querySelector(`[data-thing="${k}"]`)?.focus({ preventScroll: true });
  }

  row(k) {
    const { layer } = this;
    const name = element("button", { type: "button", title: "Choose; twice: look at it" }, nameOf(layer, k));
    name.dataset.thing = k;
    name.addEventListener("click", () => this.choose(layer, k));
    const textOf = ({ values, bars }) => (bars ? withBar(values[k], bars[k]) : rounded(values[k], 8));
    const cells = layer.columns.map((column) => element("td", {}, textOf(column)));
    const row = element("tr", {}, element("th", { scope: "row" }, name), ...cells);
    if (this.chosen && this.chosen.layer === layer && this.chosen.index === k) row.className = "chosen";
    row.addEventListener("dblclick", () => this.zoom(layer, k));
    row.addEventListener("click", (event) => {
      if (event.target !== name) this.choose(layer, k);
    });
    name.addEventListener("keydown", (event) => {
      const other = this.rows[this.rows.indexOf(k) + { ArrowDown: 1, ArrowUp: -1 }[event.key]];
      if (event.key !== "Enter" && other === undefined) return;
      event.preventDefault();
      if (other === undefined) return this.zoom(layer, k);
      this.choose(layer, other);
      this.focus(other);
    });
    return row;
  }

  // Marks a row, and scrolls to it.
  mark(chosen) {
    this.chosen = chosen;
    const at = chosen && chosen.layer === this.layer ? this.rows.indexOf(chosen.index) : -1;
    if (at >= 0) {
      const { scrollTop, clientHeight } = this.scroller, top = at * ROW;
      const hidden = top < scrollTop || top > scrollTop + clientHeight - 2 * ROW;
      if (hidden) this.scroller.scrollTop = Math.max(0, top - clientHeight / 2);
    }
    this.fill();
  }
}
