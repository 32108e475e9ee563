// Numbers and elements of the page.

// A number with `digits` significant ones, without zeros at the end.
export function rounded(value, digits = 6) {
  if (!Number.isFinite(value)) return "not known";
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return String(value);
  const short = Number(value.toPrecision(digits));
  return (Math.abs(short) < 1e-4 ? short.toExponential() : String(short)).replaceAll("-", "\u2212");
}

// A value with its error bar: as many digits as the bar leaves, and two of the bar.
export function withBar(value, bar) {
  if (!Number.isFinite(value)) return "not known";
  if (!(bar > 0)) return String(value).replace("-", "\u2212");
  const size = Math.abs(value) > 0 ? Math.floor(Math.log10(Math.abs(value))) : 0;
  const digits = Math.min(17, Math.max(1, size - Math.floor(Math.log10(bar)) + 2));
  return `${rounded(value, digits)} \u00b1 ${bar.toPrecision(2).replace("-", "\u2212")}`;
}

// A text without the characters that turn those behind it round.
export function upright(text) {
  return text.replace(/[\u202a-\u202e\u2066-\u2069]/g, "");
}

// An element with properties and children; texts are texts, never markup.
export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

export function byId(id) {
  return document.getElementById(id);
}

// Offers a text as a file.
export function download(name, type, text) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = element("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
