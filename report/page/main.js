// The page put together: controls, legend, how it was made.

const element = (id) => document.getElementById(id);

function drawLegend() {
  const width = 240;
  const scale = (share) => 6 + share * (width - 12);
  const isAlpha = state.view === "alpha";
  const bar = svg("svg", { width, height: 50, role: "img", "aria-label": isAlpha ? "colours of alignability from 0 to 1" : "colours of risk from 1 to 0" });
  const steps = report.scales[state.scale].colours.length;
  for (let i = 0; i < steps; ++i) {
    bar.append(svg("rect", { x: scale(i / steps), y: 18, width: (width - 12) / steps + 0.6, height: 13, fill: colourAt(i / (steps - 1)) }));
  }
  const label = (share, text, anchor) => bar.append(svg("text", { x: scale(share), y: 46, "text-anchor": anchor }, text));
  label(0, isAlpha ? "α 0" : "risk 1", "start");
  label(1, isAlpha ? "1" : "0", "end");
  if (isAlpha) {
    for (const value of [state.critical, state.safe]) {
      bar.append(svg("line", { x1: scale(value), x2: scale(value), y1: 14, y2: 34, stroke: variable("--ink"), "stroke-width": 2 }));
    }
    bar.append(svg("text", { x: scale(state.critical), y: 11, "text-anchor": state.critical < 0.1 ? "start" : "middle" }, "blind"),
      svg("text", { x: scale(state.safe), y: 11, "text-anchor": state.safe > 0.9 ? "end" : "middle" }, "safe"));
  }
  const swatch = (name, text) => html("span", { className: "key" }, html("span", { className: "swatch", style: `background: var(${name})` }), text);
  const keys = paths.map((path) => html("span", { className: "key" }, lineKey(path), path.name));
  if (paths.length > 0) keys.push(swatch("--blind", "driven blind"));
  element("legend").replaceChildren(bar, swatch("--free", "not evaluated"), swatch("--wall", "wall"), swatch("--unknown", "unknown"), ...keys);
}

function showThresholds() {
  for (const key of ["critical", "safe"]) {
    element(key).value = state[key];
    element(`${key}-value`).textContent = fixed(state[key], 2);
  }
  element("reset").disabled = isAsPlanned();
  element("threshold-note").textContent = isAsPlanned() ? "as the paths were planned" : "figures with ≈ are for these; the paths stay";
}

// How the map's cells fall to either side of the thresholds.
function showShares() {
  const count = { all: 0, blind: 0, safe: 0 };
  for (let cell = 0; cell < report.alpha.width * report.alpha.height; ++cell) {
    if (!isEvaluated(cell)) continue;
    const alpha = alphaOfCell(cell, state.heading);
    ++count.all;
    if (isBlind(alpha, thresholds())) ++count.blind;
    else if (alpha >= state.safe) ++count.safe;
  }
  const share = (part) => `${Math.round((100 * part) / count.all)} %`;
  element("shares").textContent = count.all === 0 ? "No cell was evaluated." :
    `Of ${count.all} evaluated cells ${share(count.blind)} are blind, ${share(count.all - count.blind - count.safe)} between, ${share(count.safe)} safe.`;
}

function startThresholds() {
  const least = 0.01; // between the two
  element("critical").addEventListener("input", (event) => {
    const critical = Math.min(Number(event.target.value), 1 - least);
    update({ critical, safe: Math.max(state.safe, Number((critical + least).toFixed(2))) });
  });
  element("safe").addEventListener("input", (event) => {
    const safe = Math.max(Number(event.target.value), least);
    update({ safe, critical: Math.min(state.critical, Number((safe - least).toFixed(2))) });
  });
  element("reset").addEventListener("click", () => update({ ...planned }));
  showThresholds();
  showShares();
}

function startChoices() {
  report.scales.forEach((scale, index) => element("scale").append(html("option", { value: index, textContent: scale.name })));
  element("scale").addEventListener("change", (event) => update({ scale: Number(event.target.value) }));
  element("view").addEventListener("change", (event) => update({ view: event.target.value }));
  if (!headings) return;
  element("heading-choice").hidden = false;
  element("heading").append(html("option", { value: "worst", textContent: "worst" }), html("option", { value: "best", textContent: "best" }));
  for (let k = 0; k < headings; ++k) element("heading").append(html("option", { value: String(k), textContent: `${(360 * k) / headings}°` }));
  element("heading").addEventListener("change", (event) => update({ heading: event.target.value }));
}

function startTheme() {
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const set = (theme) => {
    document.documentElement.dataset.theme = theme;
    element("theme").textContent = theme === "dark" ? "Light" : "Dark";
  };
  set(system.matches ? "dark" : "light");
  const repaint = () => {
    repaintMap();
    drawProfiles();
    recolourTable();
    drawLegend();
  };
  system.addEventListener("change", () => (set(system.matches ? "dark" : "light"), repaint()));
  element("theme").addEventListener("click", () => (set(document.documentElement.dataset.theme === "dark" ? "light" : "dark"), repaint()));
}

function startOrigin() {
  element("command").textContent = report.command;
  for (const { title, text } of report.options) {
    element("options").append(html("details", {}, html("summary", { textContent: title }), html("pre", { textContent: text })));
  }
  const cells = (grid) => (grid.cell === grid.resolution ? "" : `; drawn by blocks of ${fixed(grid.resolution, 2)} m`);
  const sizes = `Map cells of ${report.occupancy.cell} m${cells(report.occupancy)}; alignability cells of ${report.alpha.cell} m${cells(report.alpha)}.`;
  element("options").append(html("p", { textContent: sizes }));
}

element("title").textContent = report.title;
element("summary").textContent = report.summary;
startTheme();
startChoices();
startThresholds();
startMap();
startProfiles();
startTable();
drawLegend();
startOrigin();

function tellReadout() {
  const told = state.cursor ? describe(state.cursor).join(" · ") : "";
  element("readout").textContent = told || "Point at the map to read it, or move over it with the arrow keys.";
}
tellReadout();

onChange((change) => {
  const moved = "critical" in change || "safe" in change;
  changeMap(change);
  changeTable(change);
  tellReadout();
  if (moved) showThresholds();
  if (moved || "heading" in change) showShares();
  if (moved || "view" in change || "scale" in change) drawLegend();
  if (paths.length > 0) drawProfiles();
});

// Also when a scroll bar comes or goes.
let width = 0;
new ResizeObserver(([frame]) => {
  if (frame.contentRect.width === width) return;
  width = frame.contentRect.width;
  drawMap();
  if (paths.length > 0) drawProfiles();
}).observe(element("map-frame"));
