// What the report holds, unpacked: grids of α by heading, the occupancy map, the paths.

const report = JSON.parse(document.getElementById("report").textContent);

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const bytes = (text) => Uint8Array.from(atob(text), (character) => character.charCodeAt(0));

// Bilinear between the centres of cells, constant beyond the outermost; a corner without a value takes part only where it counts.
function interpolated(grid, values, x, y) {
  const u = clamp((x - grid.origin[0]) / grid.resolution - 0.5, 0, grid.width - 1);
  const v = clamp((y - grid.origin[1]) / grid.resolution - 0.5, 0, grid.height - 1);
  const i = Math.min(Math.floor(u), Math.max(grid.width - 2, 0));
  const j = Math.min(Math.floor(v), Math.max(grid.height - 2, 0));
  let sum = 0;
  for (const [column, across] of [[i, 1 - (u - i)], [i + 1, u - i]]) {
    for (const [row, up] of [[j, 1 - (v - j)], [j + 1, v - j]]) {
      if (across * up > 0) sum += across * up * values[row * grid.width + column];
    }
  }
  return sum;
}

const grid = report.alpha;
const fields = grid.fields.map((packed) => {
  const view = new DataView(bytes(packed).buffer);
  return Float32Array.from({ length: grid.width * grid.height }, (_, cell) => {
    const share = view.getUint16(2 * cell, true);
    return share === 65535 ? NaN : share / 65534;
  });
});
const evaluatedBits = bytes(grid.evaluated);

const headings = fields.length > 1 ? fields.length : 0;
const isEvaluated = (cell) => ((evaluatedBits[cell >> 3] >> (cell & 7)) & 1) === 1;

// By the number of a heading; "worst" or "best" of them.
function alphaOfCell(cell, heading) {
  if (!headings) return fields[0][cell];
  if (heading === "worst") return fields.reduce((least, field) => Math.min(least, field[cell]), Infinity);
  if (heading === "best") return fields.reduce((most, field) => Math.max(most, field[cell]), -Infinity);
  return fields[Number(heading)][cell];
}

const cells = (heading) => Float32Array.from({ length: grid.width * grid.height }, (_, cell) => alphaOfCell(cell, heading));
const chosen = new Map();
function valuesAt(heading) {
  if (!chosen.has(heading)) chosen.set(heading, headings ? cells(heading) : fields[0]);
  return chosen.get(heading);
}

const alphaAt = (x, y, heading) => interpolated(grid, valuesAt(heading), x, y);

function riskOf(alpha, thresholds) {
  if (Number.isNaN(alpha)) return report.risk.unknown === "neutral" ? 0 : 1;
  return clamp((thresholds.safe - alpha) / (thresholds.safe - thresholds.critical), 0, 1);
}

const isBlind = (alpha, thresholds) =>
  alpha === null || Number.isNaN(alpha) ? report.risk.unknown !== "neutral" : alpha < thresholds.critical;

// The risk of α alone, bilinear between the risks of the nodes, as planners have it.
class RiskOfAlpha {
  constructor(thresholds) {
    this.fields = fields.map((field) => field.map((alpha) => riskOf(alpha, thresholds)));
  }

  at(x, y, yaw) {
    if (!headings) return interpolated(grid, this.fields[0], x, y);
    const position = (yaw * headings) / (2 * Math.PI);
    const low = Math.floor(position);
    const field = (index) => this.fields[((index % headings) + headings) % headings];
    const share = position - low;
    return (1 - share) * interpolated(grid, field(low), x, y) + share * interpolated(grid, field(low + 1), x, y);
  }
}

const states = bytes(report.occupancy.states);
const stateOfCell = (cell) => (states[cell >> 2] >> (2 * (cell & 3))) & 3;
const kUnknown = 1;
const kOccupied = 2;

const planned = { critical: report.risk.critical, safe: report.risk.safe };

// Each with its samples as objects, α NaN where it has no value, and the part of the risk that is not α's.
const plannedRisk = new RiskOfAlpha(planned);
const paths = report.paths.map((path) => ({
  ...path,
  samples: path.samples.map(([s, x, y, yaw, alpha, risk]) => ({
    s, x, y, yaw, alpha: alpha ?? NaN, risk, other: risk - report.risk.alpha_weight * plannedRisk.at(x, y, yaw),
  })),
}));

// Blind metres, the longest blind stretch and the integral of risk at other thresholds, between samples as if α and risk were linear.
function figuresAt(path, thresholds) {
  const field = new RiskOfAlpha(thresholds);
  const figures = { blind: 0, longest_blind: 0, risk: 0 };
  let stretch = 0;
  for (let i = 1; i < path.samples.length; ++i) {
    const [a, b] = [path.samples[i - 1], path.samples[i]];
    const length = b.s - a.s;
    const riskAt = (at) => at.other + report.risk.alpha_weight * field.at(at.x, at.y, at.yaw);
    figures.risk += (length * (riskAt(a) + riskAt(b))) / 2;
    const [first, last] = [isBlind(a.alpha, thresholds), isBlind(b.alpha, thresholds)];
    const known = !Number.isNaN(a.alpha) && !Number.isNaN(b.alpha);
    const crossing = known ? (thresholds.critical - a.alpha) / (b.alpha - a.alpha) : 0.5;
    const blind = first === last ? (first ? length : 0) : length * (first ? crossing : 1 - crossing);
    figures.blind += blind;
    if (!first) stretch = 0;
    stretch += blind;
    figures.longest_blind = Math.max(figures.longest_blind, stretch);
    if (!last) stretch = 0;
  }
  return figures;
}

// Of a path at an arc length; null beyond its end.
function sampleAt(path, s) {
  const samples = path.samples;
  if (samples.length === 0 || s > samples[samples.length - 1].s + 1e-9) return null;
  let [low, high] = [0, samples.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (samples[middle].s <= s) low = middle;
    else high = middle;
  }
  return s - samples[low].s <= samples[high].s - s ? samples[low] : samples[high];
}
