// What the reader has chosen, and who is told when it changes.

const state = {
  critical: planned.critical,
  safe: planned.safe,
  view: "alpha",
  scale: 0,
  heading: headings ? "worst" : "0",
  localizer: 0,
  shown: new Set(paths.map((_, index) => index)),
  cursor: null, // { x, y } on the map, with { path, s } near a path; or { s } along all of them
};

const listeners = [];
const onChange = (listener) => listeners.push(listener);

function update(change) {
  Object.assign(state, change);
  for (const listener of listeners) listener(change);
}

const thresholds = () => ({ critical: state.critical, safe: state.safe });
const isAsPlanned = () => state.critical === planned.critical && state.safe === planned.safe;
const shownPaths = () => paths.filter((_, index) => state.shown.has(index));

const dark = () => document.documentElement.dataset.theme === "dark";
const variable = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// A path's colour on the page as it is: on a dark one its lightness turned around.
function colourOf(path) {
  if (!dark()) return path.colour;
  const parts = [1, 3, 5].map((at) => parseInt(path.colour.slice(at, at + 2), 16));
  const toWhite = Math.max(...parts) < 90 ? 0.92 : 0.45;
  return `rgb(${parts.map((part) => Math.round(part + (255 - part) * toWhite)).join(" ")})`;
}

// The colour of a share of α, or of a risk, which is 1 where α is worst.
function colourAt(share) {
  const colours = report.scales[state.scale].colours;
  return colours[Math.round(Math.min(Math.max(share, 0), 1) * (colours.length - 1))];
}

const fixed = (value, digits) => (value === null || Number.isNaN(value) ? "–" : value.toFixed(digits));

const kSvg = "http://www.w3.org/2000/svg";
function svg(name, attributes, ...children) {
  const element = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

function html(name, properties, ...children) {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
}

// A piece of a path's line, as keys show it.
const lineKey = (path) =>
  svg("svg", { width: 26, height: 12, "aria-hidden": "true" },
    svg("line", { x1: 1, y1: 6, x2: 25, y2: 6, stroke: colourOf(path), "stroke-width": 3, "stroke-dasharray": path.dashed ? "6 4" : "none" }));
