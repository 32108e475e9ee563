// A table that is sorted and filtered, and only as many of whose rows are in the page as are seen.
import { byId, element } from "./text.js";

const ROW = 28; // pixels, as in page.css
const SIGNS = {
  "<": (a, b) => a < b, "<=": (a, b) => a <= b, ">": (a, b) => a > b, ">=": (a, b) => a >= b, "=": (a, b) => a === b,
};

export class Table {
  // `choose(k)` is called for a click on row k, `zoom(k)` for a double one; `accepts()` gives what says whether row k is
  // wanted at all; `changed()` is called for other rows, or another order of them.
  constructor({ choose, zoom = choose, accepts = () => () => true, changed = () => {} }) {
    Object.assign(this, { choose, zoom, accepts, changed, source: null, chosen: null, rows: [] });
    this.scroller = byId("rows");
    this.scroller.addEventListener("scroll", () => this.fill());
    byId("filter").addEventListener("input", () => this.update());
  }

  // Shows `n` rows of a source. Columns are { name, value(k), text(k) }, the first one being the rows' names; values are
  // numbers, texts or undefined, and are sorted by `rank(k)` where that is given.
  show(source, n, columns) {
    Object.assign(this, { source, n, columns, chosen: null });
    this.sortBy(0, false);
  }
  sortBy(column, down) {
    this.sort = { column, down };
    byId("heads").replaceChildren(...this.columns.map(({ name }, k) => this.headOf(name, k)));
    this.update();
  }
  // Numbers begin with the largest.
  headOf(name, k) {
    const { column, down } = this.sort, sorted = column === k;
    const button = element("button", { type: "button" }, name + (sorted ? (down ? " \u25be" : " \u25b4") : ""));
    button.addEventListener("click", () => {
      const isText = k === 0 || this.rows.some((row) => typeof this.columns[k].value(row) === "string");
      this.sortBy(k, sorted ? !down : !isText);
      byId("heads").children[k].firstChild.focus();
    });
    return element("th", { scope: "col", "aria-sort": sorted ? (down ? "descending" : "ascending") : "none" }, button);
  }

  // Terms of the filter: "area>0.1" compares a column, anything else is part of a text of the row.
  filter() {
    const { columns } = this;
    const tests = byId("filter").value.trim().split(/\s+/).filter(Boolean).map((term) => {
      const [, name, sign, number] = /^(.+?)(<=|>=|<|>|=)([-+.\deE]+)$/.exec(term) ?? [];
      const column = columns.find((one) => one.name.replaceAll(" ", "") === name), part = term.toLowerCase();
      if (column && !Number.isNaN(Number(number))) return (k) => SIGNS[sign](column.value(k), Number(number));
      return (k) => columns.some(({ value }) => typeof value(k) === "string" && value(k).toLowerCase().includes(part));
    });
    return (k) => tests.every((test) => test(k));
  }
  update() {
    if (!this.source) return;
    const accepts = this.accepts(), matches = this.filter(), rows = [];
    for (let k = 0; k < this.n; ++k) if (accepts(k) && matches(k)) rows.push(k);
    const { value, rank = value } = this.columns[this.sort.column], sign = this.sort.down ? -1 : 1;
    const ranks = new Map(rows.map((k) => [k, rank(k)]));
    rows.sort((a, b) => {
      const [u, v] = [ranks.get(a), ranks.get(b)], unknown = (u !== u || u === undefined) - (v !== v || v === undefined);
      return unknown || sign * (u < v ? -1 : u > v ? 1 : 0) || a - b;
    });
    this.rows = rows;
    const part = rows.length === this.n ? "" : `${rows.length} of `;
    byId("count").textContent = `${part}${this.n} ${this.n === 1 ? "row" : "rows"}`;
    this.fill();
    this.changed();
  }

  fill() {
    const { rows, scroller } = this;
    if (!this.source) return;
    const first = Math.max(0, Math.floor(scroller.scrollTop / ROW) - 10);
    const last = Math.min(rows.length, first + Math.ceil(Math.max(scroller.clientHeight, 300) / ROW) + 20);
    const space = (count) => {
      const row = element("tr", { "aria-hidden": "true" });
      row.style.height = `${count * ROW}px`;
      return count > 0 ? [row] : [];
    };
    const focused = document.activeElement?.dataset.thing;
    const body = rows.slice(first, last).map((k) => this.row(k));
    byId("body").replaceChildren(...space(first), ...body, ...space(rows.length - Math.max(first, last)));
    if (focused !== undefined) this.focus(focused);
  }
  // Moves the focus to the row of a thing, if it is in the page.
  focus(k) {
    this.scroller.querySelector(`[data-thing="${k}"]`)?.focus({ preventScroll: true });
  }
  row(k) {
    const [name, ...cells] = this.columns.map(({ text }) => text(k));
    const button = element("button", { type: "button", title: name }, name);
    button.dataset.thing = k;
    button.addEventListener("keydown", (event) => {
      const other = this.rows[this.rows.indexOf(k) + { ArrowDown: 1, ArrowUp: -1 }[event.key]];
      if (event.key !== "Enter" && other === undefined) return;
      event.preventDefault();
      if (other === undefined) return this.zoom(k);
      this.choose(other);
      this.focus(other);
    });
    const row = element("tr", { className: k === this.chosen ? "chosen" : "" },
      element("th", { scope: "row" }, button), ...cells.map((text) => element("td", { title: text }, text)));
    row.addEventListener("click", () => this.choose(k));
    row.addEventListener("dblclick", () => this.zoom(k));
    return row;
  }

  // Marks a row, or none for null, and scrolls to it.
  mark(k) {
    this.chosen = k;
    const { scrollTop, clientHeight } = this.scroller, top = this.rows.indexOf(k) * ROW;
    const hidden = top < scrollTop || top > scrollTop + clientHeight - 2 * ROW;
    if (top >= 0 && hidden) this.scroller.scrollTop = Math.max(0, top - clientHeight / 2);
    this.fill();
  }
}
