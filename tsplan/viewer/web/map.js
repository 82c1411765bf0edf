/* What does not move: shapes, states, edges, durations and names, painted once for each view. */

const ROOM_FOR_NAMES = 56; // dots between neighbouring states
const ROOM_FOR_LABELS = 84;
const MOST_REGIONS = 300;

class Ground {
  constructor(data) {
    this.states = data.states;
    this.edges = data.edges;
    this.colours = this.states.map((state) => state.color);
    this.bounds = this.extent();
    this.gap = this.spacing();
    this.regions = this.gather();
    this.canvas = document.createElement("canvas");
    this.written = []; // words on the map, with the rectangles they take
  }

  extent() {
    const xs = [];
    const ys = [];
    for (const state of this.states) {
      for (const [x, y] of [[state.x, state.y], ...(state.shape || [])]) {
        xs.push(x);
        ys.push(y);
      }
    }
    const least = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);
    const most = (values) => values.reduce((a, b) => Math.max(a, b), -Infinity);
    return { left: least(xs), right: most(xs), bottom: least(ys), top: most(ys) };
  }

  /* How far apart neighbouring states are: the length that three quarters of the edges exceed. */
  spacing() {
    const lengths = this.edges
      .map(({ from, to }) => this.distance(from, to))
      .filter((length) => length > 0)
      .sort((a, b) => a - b);
    const { left, right, bottom, top } = this.bounds;
    const span = Math.max(right - left, top - bottom) || 120; // a single state, at a scale of 1
    return lengths.length ? lengths[Math.floor(lengths.length / 4)] : span / Math.sqrt(this.states.length);
  }

  /* Neighbouring states that share a label, as regions: the label and where its middle is. */
  gather() {
    const root = new Map(); // "label state" to what stands for its region
    const find = (key) => {
      while (root.get(key) !== key) key = root.get(key);
      return key;
    };
    this.states.forEach((state, s) => state.labels.forEach((_, l) => root.set(`${l} ${s}`, `${l} ${s}`)));
    for (const { from, to } of this.edges) {
      this.states[from].labels.forEach((label, l) => {
        const other = this.states[to].labels.indexOf(label);
        if (other >= 0) root.set(find(`${l} ${from}`), find(`${other} ${to}`));
      });
    }
    const regions = new Map();
    for (const key of root.keys()) {
      const [l, s] = key.split(" ").map(Number);
      const state = this.states[s];
      const region = regions.get(find(key)) || { label: state.labels[l], x: 0, y: 0, size: 0 };
      region.x += state.x;
      region.y += state.y;
      region.size += 1;
      regions.set(find(key), region);
    }
    return [...regions.values()]
      .sort((a, b) => a.size - b.size) // a small region is harder to guess than a large one
      .map(({ label, x, y, size }) => ({ label, x: x / size, y: y / size }));
  }

  distance(a, b) {
    return Math.hypot(this.states[a].x - this.states[b].x, this.states[a].y - this.states[b].y);
  }

  /* Dots of the screen that a state's circle and its agents' marks take at a scale. */
  sizes(camera) {
    const room = this.gap * camera.scale;
    const mark = Math.min(8, Math.max(2.4, room * 0.09));
    return { room, mark, circle: Math.min(46, Math.max(3, room * 0.3)) };
  }

  paint(camera, lit) {
    const { context } = sizeCanvas(this.canvas, camera.width, camera.height);
    context.clearRect(0, 0, camera.width, camera.height);
    const sizes = this.sizes(camera);
    this.paintShapes(context, camera, lit);
    this.paintEdges(context, camera, sizes);
    this.paintStates(context, camera, sizes, lit);
    this.written = [];
    this.paintNames(context, camera, sizes);
    this.paintDurations(context, camera);
  }

  /* Write words around a point where they hide no others; the baseline is their top or middle. */
  write(context, words, x, y, colour, tall = 13) {
    if (!words) return;
    const box = this.boxOf(context, words, x, y, tall);
    if (!this.free(box)) return;
    this.written.push(box);
    haloText(context, words, x, y, colour);
  }

  /* The rectangle that words take around a point. */
  boxOf(context, words, x, y, tall = 13) {
    const half = context.measureText(words).width / 2 + 2;
    const top = context.textBaseline === "top" ? y : y - tall / 2;
    return { words, left: x - half, right: x + half, top, bottom: top + tall };
  }

  /* Whether no words are in a rectangle: those of the map, or other ones. */
  free(box, written = this.written) {
    return written.every((other) =>
      other.left >= box.right || box.left >= other.right || other.top >= box.bottom || box.top >= other.bottom);
  }

  /* How long an edge takes, where that is not as on most of them. */
  paintDurations(context, camera) {
    context.font = `11px ${theme.font}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const edge of this.edges) {
      if (!edge.words) continue;
      const [ax, ay, bx, by] = this.ends(edge, camera);
      if (Math.hypot(bx - ax, by - ay) > 44) this.write(context, edge.words, (ax + bx) / 2, (ay + by) / 2, theme.soft);
    }
  }

  paintShapes(context, camera, lit) {
    this.states.forEach((state, s) => {
      if (!state.shape) return;
      context.beginPath();
      for (const [x, y] of state.shape) context.lineTo(camera.x(x), camera.y(y));
      context.closePath();
      this.tintArea(context, s, lit, Number(theme.tint));
    });
    // once more on top, where a neighbour's border would hide it
    context.lineWidth = 3;
    context.strokeStyle = theme.accent;
    for (const s of lit) {
      if (!this.states[s].shape) continue;
      context.beginPath();
      for (const [x, y] of this.states[s].shape) context.lineTo(camera.x(x), camera.y(y));
      context.closePath();
      context.stroke();
    }
  }

  /* Fill the present path in a state's colour, and draw its border. */
  tintArea(context, s, lit, share) {
    context.globalAlpha = share;
    context.fillStyle = this.colours[s] || theme.state;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = lit.has(s) ? 3 : 1;
    context.strokeStyle = lit.has(s) ? theme.accent : theme.edge;
    context.stroke();
  }

  paintEdges(context, camera, sizes) {
    context.strokeStyle = theme.edge;
    context.fillStyle = theme.edge;
    context.lineWidth = Math.min(1.4, Math.max(0.5, sizes.room / 60));
    context.beginPath();
    for (const edge of this.edges) {
      const [ax, ay, bx, by] = this.ends(edge, camera);
      context.moveTo(ax, ay);
      context.lineTo(bx, by);
    }
    context.stroke();
    for (const edge of this.edges) this.paintEdgeParts(context, camera, sizes, edge);
  }

  ends({ from, to }, camera) {
    const a = this.states[from];
    const b = this.states[to];
    return [camera.x(a.x), camera.y(a.y), camera.x(b.x), camera.y(b.y)];
  }

  paintEdgeParts(context, camera, sizes, edge) {
    const [ax, ay, bx, by] = this.ends(edge, camera);
    const length = Math.hypot(bx - ax, by - ay);
    if (edge.oneWay && length > 16) {
      const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
      const size = Math.min(8, length / 6);
      const [x, y] = [bx - ux * (sizes.circle + 2), by - uy * (sizes.circle + 2)];
      context.fillStyle = theme.edge;
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(x - ux * size - (uy * size) / 2, y - uy * size + (ux * size) / 2);
      context.lineTo(x - ux * size + (uy * size) / 2, y - uy * size - (ux * size) / 2);
      context.fill();
    }
  }

  paintStates(context, camera, sizes, lit) {
    this.states.forEach((state, s) => {
      if (state.shape) return;
      context.beginPath();
      context.arc(camera.x(state.x), camera.y(state.y), sizes.circle, 0, 2 * Math.PI);
      context.fillStyle = theme.ground;
      context.fill();
      this.tintArea(context, s, lit, Math.min(1, 2 * Number(theme.tint)));
    });
  }

  /* Names where there is room: in the top of a shape, above a circle. Else only regions. */
  paintNames(context, camera, sizes) {
    context.textAlign = "center";
    if (sizes.room < ROOM_FOR_NAMES) {
      this.paintRegions(context, camera);
      return;
    }
    const words = (state) => state.labels.filter((label) => label !== state.name).join(", ");
    for (const state of this.states) {
      const x = camera.x(state.x);
      if (x < -200 || x > camera.width + 200) continue;
      const box = state.shape ? this.box(state.shape, camera) : null;
      const both = words(state) !== "" && (box ? box.height >= 58 : sizes.room >= ROOM_FOR_LABELS);
      const width = box ? box.width - 8 : sizes.room * 0.92;
      if (width < 26 || (box && box.height < 24)) continue;
      const middle = box ? box.middle : x;
      const y = box ? box.top + 5 : camera.y(state.y) - sizes.circle - (both ? 30 : 17);
      context.textBaseline = "top";
      context.font = `600 12px ${theme.font}`;
      this.write(context, fitted(context, state.name, width), middle, y, theme.ink);
      if (!both) continue;
      context.font = `11px ${theme.font}`;
      this.write(context, fitted(context, words(state), width), middle, y + 14, theme.soft);
    }
  }

  /* The labels of regions, none on top of another. */
  paintRegions(context, camera) {
    context.font = `600 11.5px ${theme.font}`;
    context.textBaseline = "middle";
    for (const { label, x, y } of this.regions.slice(0, MOST_REGIONS)) {
      const [px, py] = [camera.x(x), camera.y(y) - Math.min(16, 0.5 * this.gap * camera.scale)];
      this.write(context, label, px, py, theme.ink, 14);
    }
  }

  box(shape, camera) {
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const [x, y] of shape) {
      left = Math.min(left, camera.x(x));
      right = Math.max(right, camera.x(x));
      top = Math.min(top, camera.y(y));
      bottom = Math.max(bottom, camera.y(y));
    }
    return { top, width: right - left, height: bottom - top, middle: (left + right) / 2 };
  }

  /* The state at a point of the screen, -1 for none. */
  stateAt(px, py, camera) {
    const reach = Math.max(touched() ? TARGET / 2 : 9, this.sizes(camera).circle);
    let best = -1;
    let nearest = reach;
    this.states.forEach((state, s) => {
      const distance = Math.hypot(camera.x(state.x) - px, camera.y(state.y) - py);
      if (distance < nearest) [best, nearest] = [s, distance];
    });
    if (best >= 0) return best;
    const x = (px - camera.width / 2) / camera.scale + camera.middleX;
    const y = camera.middleY - (py - camera.height / 2) / camera.scale;
    return this.states.findIndex((state) => state.shape && inside(state.shape, x, y));
  }
}

/* Whether a polygon holds a point: a ray from it crosses the border an odd number of times. */
function inside(shape, x, y) {
  let odd = false;
  for (let i = 0, j = shape.length - 1; i < shape.length; j = i, i += 1) {
    const [ax, ay] = shape[i];
    const [bx, by] = shape[j];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) odd = !odd;
  }
  return odd;
}
