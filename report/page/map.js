// The map: ground, α or risk, walls, paths with their blind stretches, and the cross of the reader.

const canvas = document.getElementById("map");
const tip = document.getElementById("tip");
const extent = { x: report.occupancy.origin[0], y: report.occupancy.origin[1],
  width: report.occupancy.width * report.occupancy.resolution, height: report.occupancy.height * report.occupancy.resolution };
const look = { x: extent.x + extent.width / 2, y: extent.y + extent.height / 2, zoom: 1 };
const kMostZoom = 40;
const kReach = 14; // of the pointer, for a path [px]

let size = { width: 1, height: 1 };
const scaleNow = () => look.zoom * Math.min(size.width / extent.width, size.height / extent.height);
const toPage = (x, y) => [(x - look.x) * scaleNow() + size.width / 2, size.height / 2 - (y - look.y) * scaleNow()];
const toMap = (px, py) => [look.x + (px - size.width / 2) / scaleNow(), look.y + (size.height / 2 - py) / scaleNow()];

function picture(cells, colourOfCell) {
  const image = new ImageData(cells.width, cells.height);
  for (let row = 0; row < cells.height; ++row) {
    for (let column = 0; column < cells.width; ++column) {
      const colour = colourOfCell(row * cells.width + column);
      if (colour === null) continue;
      const at = 4 * ((cells.height - 1 - row) * cells.width + column);
      image.data.set([colour >> 16, (colour >> 8) & 255, colour & 255, 255], at);
    }
  }
  const sheet = new OffscreenCanvas(cells.width, cells.height);
  sheet.getContext("2d").putImageData(image, 0, 0);
  return sheet;
}

const hexNumber = (colour) => parseInt(colour.slice(1), 16);

let heat = null;
let walls = null;

function paintHeat() {
  const now = thresholds();
  const colours = report.scales[state.scale].colours.map(hexNumber);
  heat = picture(report.alpha, (cell) => {
    if (!isEvaluated(cell)) return null;
    const alpha = alphaOfCell(cell, state.heading);
    const share = state.view === "alpha" ? alpha : 1 - riskOf(alpha, now);
    return Number.isNaN(share) ? null : colours[Math.round(share * (colours.length - 1))];
  });
}

function paintWalls() {
  const wall = hexNumber(variable("--wall"));
  const unknown = hexNumber(variable("--unknown"));
  walls = picture(report.occupancy, (cell) => {
    const cellState = stateOfCell(cell);
    return cellState === kOccupied ? wall : cellState === kUnknown ? unknown : null;
  });
}

function drawSheet(context, sheet, cells) {
  const [left, bottom] = toPage(cells.origin[0], cells.origin[1]);
  const side = cells.resolution * scaleNow();
  context.drawImage(sheet, left, bottom - cells.height * side, cells.width * side, cells.height * side);
}

function trace(context, samples) {
  context.beginPath();
  for (const at of samples) context.lineTo(...toPage(at.x, at.y));
}

function stroke(context, colour, width, dash = []) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.stroke();
}

// The stretches between blind samples.
function blindStretches(path, now) {
  const stretches = [];
  let open = null;
  for (const at of path.samples) {
    if (!isBlind(at.alpha, now)) open = null;
    else if (open) open.push(at);
    else stretches.push((open = [at]));
  }
  return stretches.filter((stretch) => stretch.length > 1);
}

function drawPaths(context) {
  const now = thresholds();
  const shown = shownPaths();
  for (const path of shown) {
    for (const stretch of blindStretches(path, now)) {
      trace(context, stretch);
      stroke(context, variable("--casing"), 12);
      stroke(context, variable("--blind"), 9);
    }
  }
  // The first ones uppermost; what is dashed last of all, so that what lies beneath shows through its gaps.
  for (const path of [...shown].reverse().sort((a, b) => a.dashed - b.dashed)) {
    trace(context, path.samples);
    if (!path.dashed) stroke(context, variable("--casing"), 5.5);
    stroke(context, colourOf(path), 3, path.dashed ? [9, 6] : []);
  }
}

function drawPose(context, [x, y, yaw], text) {
  const [px, py] = toPage(x, y);
  context.setLineDash([]);
  context.fillStyle = variable("--card");
  context.strokeStyle = variable("--ink");
  context.lineWidth = 2;
  context.beginPath();
  context.arc(px, py, 8, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.beginPath();
  context.moveTo(px + 8 * Math.cos(yaw), py - 8 * Math.sin(yaw));
  context.lineTo(px + 15 * Math.cos(yaw), py - 15 * Math.sin(yaw));
  context.stroke();
  context.fillStyle = variable("--ink");
  context.font = "600 11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, px, py + 0.5);
}

function drawCross(context, x, y, colour) {
  const [px, py] = toPage(x, y);
  context.setLineDash([]);
  for (const [line, width] of [[variable("--casing"), 5], [colour, 2]]) {
    context.strokeStyle = line;
    context.lineWidth = width;
    context.beginPath();
    context.arc(px, py, 6, 0, 2 * Math.PI);
    context.moveTo(px - 12, py);
    context.lineTo(px + 12, py);
    context.moveTo(px, py - 12);
    context.lineTo(px, py + 12);
    context.stroke();
  }
}

function drawCursor(context) {
  const cursor = state.cursor;
  if (!cursor) return;
  if (cursor.x !== undefined) drawCross(context, cursor.x, cursor.y, variable("--ink"));
  if (cursor.s === undefined) return;
  for (const path of cursor.path ? [cursor.path] : shownPaths()) {
    const at = sampleAt(path, cursor.s);
    if (at) drawCross(context, at.x, at.y, colourOf(path));
  }
}

function drawMap() {
  const density = window.devicePixelRatio || 1;
  size = { width: canvas.clientWidth, height: Math.max(180, Math.min(canvas.clientWidth * 1.1, canvas.clientWidth * (extent.height / extent.width), 0.85 * window.innerHeight)) };
  canvas.style.height = `${size.height}px`;
  canvas.width = Math.round(size.width * density);
  canvas.height = Math.round(size.height * density);
  const context = canvas.getContext("2d");
  context.scale(density, density);
  context.imageSmoothingEnabled = false;
  context.lineJoin = "round";
  context.lineCap = "butt";
  context.fillStyle = variable("--unknown");
  context.fillRect(0, 0, size.width, size.height);
  const [left, top] = toPage(extent.x, extent.y + extent.height);
  context.fillStyle = variable("--free");
  context.fillRect(left, top, extent.width * scaleNow(), extent.height * scaleNow());
  drawSheet(context, heat, report.alpha);
  drawSheet(context, walls, report.occupancy);
  drawPaths(context);
  if (paths.length > 0) {
    drawPose(context, report.start, "S");
    drawPose(context, report.goal, "G");
  }
  drawCursor(context);
  canvas.classList.toggle("closer", look.zoom > 1);
}

// The sample of a shown path nearest to a point of the page, within reach.
function nearPath(px, py) {
  let best = null;
  let least = kReach;
  for (const path of shownPaths()) {
    for (const at of path.samples) {
      const [x, y] = toPage(at.x, at.y);
      const distance = Math.hypot(x - px, y - py);
      if (distance < least) [best, least] = [{ path, s: at.s }, distance];
    }
  }
  return best;
}

function describe(cursor) {
  const parts = [];
  if (cursor.x !== undefined) {
    const { x, y } = cursor;
    const column = Math.floor((x - report.alpha.origin[0]) / report.alpha.resolution);
    const row = Math.floor((y - report.alpha.origin[1]) / report.alpha.resolution);
    const inside = column >= 0 && row >= 0 && column < report.alpha.width && row < report.alpha.height;
    const alpha = inside ? alphaAt(x, y, state.heading) : NaN;
    parts.push(`x ${fixed(x, 2)} m, y ${fixed(y, 2)} m`);
    if (Number.isNaN(alpha)) parts.push("not evaluated");
    else parts.push(`α ${fixed(alpha, 3)}`, `risk ${fixed(riskOf(alpha, thresholds()), 2)}${isBlind(alpha, thresholds()) ? ", blind" : ""}`);
  }
  if (cursor.path) {
    const at = sampleAt(cursor.path, cursor.s);
    parts.push(`${cursor.path.name} at ${fixed(cursor.s, 1)} m: α ${fixed(at.alpha, 3)}`);
  }
  return parts;
}

function pointAt(px, py) {
  const [x, y] = toMap(px, py);
  update({ cursor: { x, y, ...nearPath(px, py) } });
}

function showTip(px, py) {
  tip.hidden = false;
  tip.textContent = describe(state.cursor).join("\n");
  const room = size.width - tip.offsetWidth - 6;
  tip.style.left = `${Math.max(6, Math.min(px + 14, room))}px`;
  tip.style.top = `${py + 18 + tip.offsetHeight < size.height ? py + 18 : Math.max(4, py - 12 - tip.offsetHeight)}px`;
}

function keepInside() {
  look.zoom = Math.min(Math.max(look.zoom, 1), kMostZoom);
  const halfWidth = Math.min(size.width / scaleNow(), extent.width) / 2;
  const halfHeight = Math.min(size.height / scaleNow(), extent.height) / 2;
  look.x = Math.min(Math.max(look.x, extent.x + halfWidth), extent.x + extent.width - halfWidth);
  look.y = Math.min(Math.max(look.y, extent.y + halfHeight), extent.y + extent.height - halfHeight);
}

function zoom(factor, px = size.width / 2, py = size.height / 2) {
  const [x, y] = toMap(px, py);
  look.zoom = Math.min(Math.max(look.zoom * factor, 1), kMostZoom);
  const [nowX, nowY] = toMap(px, py);
  look.x += x - nowX;
  look.y += y - nowY;
  keepInside();
  drawMap();
}

function moveByKey(event) {
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  if (event.key === "+") zoom(1.5);
  if (event.key === "-") zoom(1 / 1.5);
  if (event.key === "Escape") update({ cursor: null });
  if (!steps) return;
  event.preventDefault();
  const step = report.alpha.resolution * (event.shiftKey ? 5 : 1);
  const from = state.cursor && state.cursor.x !== undefined ? state.cursor : look;
  const x = Math.min(Math.max(from.x + steps[0] * step, extent.x), extent.x + extent.width);
  const y = Math.min(Math.max(from.y + steps[1] * step, extent.y), extent.y + extent.height);
  const [px, py] = toPage(x, y);
  if (px < 0 || py < 0 || px > size.width || py > size.height) {
    [look.x, look.y] = [x, y];
    keepInside();
  }
  pointAt(...toPage(x, y));
}

function follow(event) {
  if (event.buttons === 1 && look.zoom > 1 && event.type === "pointermove") {
    look.x -= event.movementX / scaleNow();
    look.y += event.movementY / scaleNow();
    keepInside();
    tip.hidden = true;
    drawMap();
    return;
  }
  pointAt(event.offsetX, event.offsetY);
  if (event.pointerType === "mouse") showTip(event.offsetX, event.offsetY);
}

function startMap() {
  canvas.setAttribute("aria-label", `Map of ${report.title}`);
  canvas.addEventListener("pointermove", follow);
  canvas.addEventListener("pointerdown", follow);
  canvas.addEventListener("pointerleave", () => {
    tip.hidden = true;
    if (document.activeElement !== canvas) update({ cursor: null });
  });
  canvas.addEventListener("keydown", moveByKey);
  canvas.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 200), event.offsetX, event.offsetY);
  }, { passive: false });
  document.getElementById("zoom-in").addEventListener("click", () => zoom(1.6));
  document.getElementById("zoom-out").addEventListener("click", () => zoom(1 / 1.6));
  document.getElementById("zoom-all").addEventListener("click", () => zoom(1 / kMostZoom));
  repaintMap();
}

function repaintMap() {
  paintHeat();
  paintWalls();
  drawMap();
}

function changeMap(change) {
  if (["critical", "safe", "view", "scale", "heading"].some((key) => key in change)) paintHeat();
  drawMap();
}
