// Tables that can be sorted and filtered.
import { byId, element } from "./text.js";

// Fills the heads of the table, each a button; `sort` has the number of a column and whether it goes down.
export function fillHeads(names, sort, choose) {
  byId("heads").replaceChildren(...names.map((name, k) => {
    const sorted = sort.column === k;
    const button = element("button", { type: "button" }, name + (sorted ? (sort.down ? " \u25be" : " \u25b4") : ""));
    button.addEventListener("click", () => {
      choose(k);
      byId("heads").children[k].firstChild.focus();
    });
    return element("th", { scope: "col", "aria-sort": sorted ? (sort.down ? "descending" : "ascending") : "none" }, button);
  }));
}

const SIGNS = {
  "<": (a, b) => a < b, "<=": (a, b) => a <= b, ">": (a, b) => a > b, ">=": (a, b) => a >= b, "=": (a, b) => a === b,
};

// Terms of the filter: "area>0.1" compares a column, anything else is part of a text of the row.
export function filterOf(names, valueOf, contains) {
  const tests = byId("filter").value.trim().split(/\s+/).filter(Boolean).map((term) => {
    const [, name, sign, number] = /^(.+?)(<=|>=|<|>|=)([-+.\deE]+)$/.exec(term) ?? [];
    const column = names.findIndex((one) => one.replaceAll(" ", "") === name);
    if (column < 0 || Number.isNaN(Number(number))) return (row) => contains(row, term.toLowerCase());
    return (row) => SIGNS[sign](valueOf(row, column), Number(number));
  });
  return (row) => tests.every((test) => test(row));
}
