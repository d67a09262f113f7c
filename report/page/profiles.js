// α and errors by arc length.

const kMargin = { left: 46, right: 12, top: 8, bottom: 30 };
const kHeight = 190;
const longest = Math.max(0.1, ...paths.map((path) => path.length ?? 0));

// About `count` round steps up to a value.
function ticks(most, count) {
  const rough = most / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((part) => part * power).find((candidate) => candidate >= rough);
  const values = [];
  for (let i = 0; i * step <= most * (1 + 1e-9); ++i) values.push(Number((i * step).toPrecision(12)));
  return values;
}

// A frame with axes; gives the scales of both.
function axes(figure, mostY) {
  const width = Math.max(figure.clientWidth, 200);
  const inner = { width: width - kMargin.left - kMargin.right, height: kHeight - kMargin.top - kMargin.bottom };
  const x = (s) => kMargin.left + (s / longest) * inner.width;
  const y = (value) => kMargin.top + inner.height * (1 - value / mostY);
  const drawing = svg("svg", { width, height: kHeight, viewBox: `0 0 ${width} ${kHeight}`, role: "img", "aria-label": figure.querySelector("figcaption").textContent });
  drawing.append(svg("rect", { class: "frame", x: kMargin.left, y: kMargin.top, width: inner.width, height: inner.height }));
  for (const s of ticks(longest, Math.max(3, width / 110))) {
    drawing.append(svg("text", { x: x(s), y: kHeight - 12, "text-anchor": "middle" }, `${s} m`));
  }
  for (const value of ticks(mostY, 4)) {
    drawing.append(svg("line", { class: "tick", x1: kMargin.left, x2: kMargin.left + inner.width, y1: y(value), y2: y(value) }),
      svg("text", { x: kMargin.left - 6, y: y(value) + 4, "text-anchor": "end" }, String(value)));
  }
  return { drawing, x, y, inner };
}

// M where a value comes after a gap, L elsewhere.
function line(points) {
  let text = "";
  let open = false;
  for (const [x, y] of points) {
    if (Number.isNaN(y)) open = false;
    else {
      text += `${open ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
      open = true;
    }
  }
  return text;
}

const strokeOf = (path, width) => ({ fill: "none", stroke: colourOf(path), "stroke-width": width, "stroke-dasharray": path.dashed ? "7 4" : "none" });

function drawRule(drawing, x, inner) {
  const s = state.cursor?.s;
  if (s === undefined) return;
  drawing.append(svg("line", { class: "rule", x1: x(s), x2: x(s), y1: kMargin.top, y2: kMargin.top + inner.height }));
}

function place(figure, { drawing, x, inner }) {
  drawRule(drawing, x, inner);
  drawing.addEventListener("pointermove", (event) => pointAlong(event, drawing));
  drawing.addEventListener("pointerdown", (event) => pointAlong(event, drawing));
  figure.querySelector("svg")?.remove();
  figure.append(drawing);
}

function pointAlong(event, drawing) {
  const box = drawing.getBoundingClientRect();
  const width = box.width - kMargin.left - kMargin.right;
  const s = ((event.clientX - box.left - kMargin.left) / width) * longest;
  update({ cursor: { s: Math.min(Math.max(s, 0), longest) } });
}

function drawAlpha() {
  const figure = document.getElementById("alpha-profile");
  const axis = axes(figure, 1);
  const { drawing, x, y, inner } = axis;
  drawing.append(svg("rect", { class: "blind-band", x: kMargin.left, y: y(state.critical), width: inner.width, height: y(0) - y(state.critical) }));
  for (const [value, text] of [[state.critical, "blind below"], [state.safe, "safe from"]]) {
    drawing.append(svg("line", { class: "threshold", x1: kMargin.left, x2: kMargin.left + inner.width, y1: y(value), y2: y(value) }),
      svg("text", { x: kMargin.left + inner.width - 4, y: y(value) - 4, "text-anchor": "end" }, `${text} ${fixed(value, 2)}`));
  }
  for (const path of shownPaths().reverse()) {
    drawing.append(svg("path", { d: line(path.samples.map((at) => [x(at.s), y(at.alpha)])), "data-path": path.name, ...strokeOf(path, 2) }));
  }
  place(figure, axis);
}

const localizers = [...new Set(paths.flatMap((path) => path.errors.map((errors) => errors.localizer)))];
const errorsOf = (path) => path.errors.find((errors) => errors.localizer === localizers[state.localizer]);

function drawErrors() {
  const figure = document.getElementById("error-profile");
  const most = Math.max(0.01, ...paths.flatMap((path) => (errorsOf(path)?.profile ?? []).map(([, , p95]) => p95 ?? 0)));
  const axis = axes(figure, most * 1.05);
  const { drawing, x, y } = axis;
  for (const path of shownPaths()) {
    const profile = (errorsOf(path)?.profile ?? []).filter(([, mean, p95]) => mean !== null && p95 !== null);
    if (profile.length === 0) continue;
    const upper = profile.map(([s, , p95]) => [x(s), y(p95)]);
    const lower = profile.map(([s, mean]) => [x(s), y(mean)]);
    drawing.append(svg("path", { d: `${line([...upper, ...[...lower].reverse()])}Z`, fill: colourOf(path), opacity: 0.18 }),
      svg("path", { d: line(lower), "data-path": path.name, ...strokeOf(path, 2) }));
  }
  place(figure, axis);
}

const slider = document.getElementById("along");

function tellAlong() {
  const s = state.cursor?.s;
  const readout = document.getElementById("along-readout");
  if (s === undefined) {
    readout.textContent = "Point at a profile, or move the slider, to read the values there.";
    return;
  }
  slider.value = s;
  const lines = shownPaths().map((path) => {
    const at = sampleAt(path, s);
    if (!at) return `${path.name}: ended at ${fixed(path.length, 1)} m`;
    const near = (errorsOf(path)?.profile ?? []).reduce((best, point) => (!best || Math.abs(point[0] - s) < Math.abs(best[0] - s) ? point : best), null);
    const error = near && Math.abs(near[0] - s) < 1 ? `, error ${fixed(near[1], 2)} m (95 %: ${fixed(near[2], 2)} m)` : "";
    const blind = isBlind(at.alpha, thresholds()) ? ", blind" : "";
    return `${path.name} at ${fixed(s, 1)} m: α ${fixed(at.alpha, 3)}${blind}${error}`;
  });
  readout.textContent = lines.join("\n");
}

function drawProfiles() {
  drawAlpha();
  if (localizers.length > 0) drawErrors();
  tellAlong();
}

function startProfiles() {
  if (paths.length === 0) {
    document.getElementById("profiles").hidden = true;
    return;
  }
  slider.max = longest;
  slider.addEventListener("input", () => update({ cursor: { s: Number(slider.value) } }));
  if (localizers.length > 0) {
    document.getElementById("error-profile").hidden = false;
    const choice = document.getElementById("localizer");
    localizers.forEach((name, index) => choice.append(html("option", { value: index, textContent: name })));
    choice.addEventListener("change", () => update({ localizer: Number(choice.value) }));
    document.getElementById("localizer-choice").hidden = localizers.length < 2;
  }
  drawProfiles();
}
