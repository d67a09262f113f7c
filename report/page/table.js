// The figures of the paths; those that thresholds change are worked out anew when they move.

const table = document.getElementById("figures");

const plain = (key, digits) => (path) => ({ text: fixed(path[key], digits), has: path[key] !== null });
function moving(key) {
  return (path) => {
    if (isAsPlanned()) return { text: fixed(path[key], 2), has: true };
    return { text: `≈ ${fixed(figuresAt(path, thresholds())[key], 2)}`, has: true, moved: true };
  };
}
function ofErrors(localizer, key, factor, digits) {
  return (path) => {
    const errors = path.errors.find((by) => by.localizer === localizer);
    return { text: errors ? fixed(errors[key] * factor, digits) : "–", has: Boolean(errors) };
  };
}

const rows = [
  ["length", "m", plain("length", 2)],
  ["blind", "m", moving("blind")],
  ["longest blind", "m", moving("longest_blind")],
  ["risk integral", "m", moving("risk")],
  ...(paths[0]?.sources ?? []).map(([name], i) => [`risk, ${name}`, "m", (path) => ({ text: fixed(path.sources[i][1], 2), has: true })]),
  ["α, mean", "", plain("alpha_mean", 3)],
  ["α, least", "", plain("alpha_min", 3)],
  ["cost", "m", plain("cost", 2)],
  ["no path costs less than", "m", plain("bound", 2)],
  ["planning", "s", plain("seconds", 2)],
  ...localizers.flatMap((localizer) => {
    const runs = paths.flatMap((path) => path.errors).find((errors) => errors.localizer === localizer).runs;
    return [
      [`${localizer}, driven ${runs} times`],
      ["error, mean", "m", ofErrors(localizer, "mean", 1, 3)],
      ["error, 95 %", "m", ofErrors(localizer, "p95", 1, 3)],
      ["error, most", "m", ofErrors(localizer, "max", 1, 3)],
      ["error at the goal", "m", ofErrors(localizer, "goal", 1, 3)],
      ["runs lost", "%", ofErrors(localizer, "lost", 100, 0)],
    ];
  }),
];

function toggle(index) {
  const shown = new Set(state.shown);
  shown.has(index) ? shown.delete(index) : shown.add(index);
  update({ shown });
}

function head() {
  const cells = paths.map((path, index) => {
    const box = html("input", { type: "checkbox", checked: state.shown.has(index) });
    box.addEventListener("change", () => toggle(index));
    return html("th", { scope: "col" }, html("label", {}, box, lineKey(path), html("span", { className: "name", textContent: path.name })));
  });
  return html("thead", {}, html("tr", {}, html("td", {}, html("span", { className: "hidden-text", textContent: "figure" })), ...cells));
}

function body() {
  const lines = [];
  for (const [name, unit, value] of rows) {
    if (!value) {
      lines.push(html("tr", { className: "group" }, html("th", { scope: "rowgroup", colSpan: paths.length + 1, textContent: name })));
      continue;
    }
    const values = paths.map(value);
    if (!values.some((cell) => cell.has)) continue;
    const label = html("th", { scope: "row" }, name, " ", html("span", { className: "unit", textContent: unit && `[${unit}]` }));
    lines.push(html("tr", {}, label, ...values.map((cell) => html("td", { textContent: cell.text, className: cell.moved ? "moved" : "" }))));
  }
  return html("tbody", {}, ...lines);
}

function startTable() {
  if (paths.length === 0) {
    document.getElementById("table-panel").hidden = true;
    return;
  }
  table.append(head(), body());
}

function changeTable(change) {
  if ("critical" in change || "safe" in change) table.tBodies[0]?.replaceWith(body());
}

const recolourTable = () => paths.length > 0 && table.tHead.replaceWith(head());
