/* A trajectory on the page: the moving points in the plane, and signals over time. */

const TALL = 46; // dots of one signal's row

/* The views of a trajectory, with the names that those of a plan have. */
function signalViews(data, { choice, player }) {
  document.body.classList.toggle("flat", !data.plane);
  document.getElementById("agents-heading").textContent = "Signals";
  document.getElementById("map").setAttribute("aria-label", "Plane");
  const filter = document.getElementById("filter");
  filter.placeholder = "Find a signal";
  filter.setAttribute("aria-label", "Find a signal");
  const model = new SignalModel(data);
  const map = data.plane ? new PlaneView(model, choice) : new NoPlane();
  const timeline = new SignalRows(model, choice, player);
  return { model, map, maps: data.plane ? [map] : [], timeline, agents: new SignalList(model, choice) };
}

/* Values at any time: signals go from step to step, controls stay until the next one. */
class SignalModel {
  constructor(data) {
    this.horizon = data.horizon;
    this.tracks = data.signals;
    this.plane = data.plane;
    this.classes = data.classes;
    this.time = 0;
  }

  seek(time) { this.time = time; }

  value(track) {
    const { values, control } = this.tracks[track];
    const step = Math.min(values.length - 1, Math.floor(this.time));
    const next = values[Math.min(values.length - 1, step + 1)];
    return control ? values[step] : values[step] + (next - values[step]) * (this.time - step);
  }

  /* Where a robot is in the plane. */
  point(path) {
    const points = this.plane.paths[path];
    const step = Math.min(points.length - 1, Math.floor(this.time));
    const next = points[Math.min(points.length - 1, step + 1)];
    const share = this.time - step;
    return points[step].map((value, i) => value + (next[i] - value) * share);
  }

  places(map) {
    const points = this.plane ? this.plane.paths.map((_, p) => ({ at: map.placeOf(p), point: this.point(p) })) : [];
    return { values: this.tracks.map((track, m) => [track.name, this.value(m)]), points };
  }
}

/* Stands for the plane where there is one signal only. */
class NoPlane {
  constructor() { this.camera = { zoom() {}, fit() {} }; }
  paint() {}
  refresh() {}
  placeOf() { return null; }
}

class PlaneView {
  constructor(model, choice) {
    this.model = model;
    this.choice = choice;
    this.canvas = document.getElementById("map-canvas");
    const [left, bottom, right, top] = model.plane.frame;
    this.bounds = { left, bottom, right, top };
    this.asked = false;
    this.camera = new Camera(this.canvas, this.bounds, () => this.refresh());
    this.canvas.addEventListener("pointerup", (event) => this.click(event));
    new ResizeObserver(() => this.camera.resized()).observe(this.canvas);
  }

  refresh() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => this.paint());
  }

  paint() {
    if (!this.camera) return;
    this.asked = false;
    const { width, height } = this.camera;
    const { context } = sizeCanvas(this.canvas, width, height);
    context.clearRect(0, 0, width, height);
    this.model.plane.places.forEach((place, p) => this.paintPlace(context, place, this.choice.states.has(p)));
    this.paintAxes(context);
    this.model.plane.paths.forEach((points, p) => this.paintPath(context, points, p));
    this.model.plane.places.forEach((place) => this.paintName(context, place));
    this.model.plane.paths.forEach((_, p) => this.paintPoint(context, p));
  }

  /* A region's corners on the page; one without an end reaches beyond what is seen. */
  box({ sides: [left, bottom, right, top] }) {
    const { camera } = this;
    const x = [left === null ? -10 : camera.x(left), right === null ? camera.width + 10 : camera.x(right)];
    const y = [top === null ? -10 : camera.y(top), bottom === null ? camera.height + 10 : camera.y(bottom)];
    return { x: x[0], y: y[0], width: x[1] - x[0], height: y[1] - y[0] };
  }

  paintPlace(context, place, lit) {
    const { x, y, width, height } = this.box(place);
    context.globalAlpha = place.wanted ? 0.4 : 1;
    context.fillStyle = place.wanted ? place.color : theme.state;
    context.fillRect(x, y, width, height);
    context.globalAlpha = 1;
    if (place.wanted === false) {
      context.fillStyle = context.createPattern(hatching(), "repeat");
      context.fillRect(x, y, width, height);
    }
    context.lineWidth = lit ? 3 : 1;
    context.strokeStyle = lit ? theme.accent : theme.edge;
    context.strokeRect(x, y, width, height);
  }

  paintName(context, place) {
    const { x, y, width, height } = this.box(place);
    context.font = `600 12px ${theme.font}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    haloText(context, fitted(context, place.name, Math.max(60, width)), x + width / 2, y + height / 2, theme.ink);
  }

  /* Numbers along the lower and the left border, with the names of the signals. */
  paintAxes(context) {
    const { camera, bounds } = this;
    const [across, up] = this.model.plane.axes;
    const apart = tickStep(90 / camera.scale, 1, 0);
    context.font = `11px ${theme.font}`;
    context.fillStyle = theme.soft;
    context.textBaseline = "middle";
    context.textAlign = "center";
    const inner = (low, high) => [Math.ceil(low / apart), Math.floor(high / apart)];
    const [bottom, left] = [Math.min(camera.height - 10, camera.y(bounds.bottom) + 12), Math.max(16, camera.x(bounds.left) - 14)];
    const [firstX, lastX] = inner(bounds.left, bounds.right);
    for (let n = firstX; n <= lastX; n += 1) haloText(context, numberWords(n * apart), camera.x(n * apart), bottom, theme.soft);
    const [firstY, lastY] = inner(bounds.bottom, bounds.top);
    for (let n = firstY; n <= lastY; n += 1) haloText(context, numberWords(n * apart), left, camera.y(n * apart), theme.soft);
    context.strokeStyle = theme.line;
    context.lineWidth = 1;
    context.strokeRect(camera.x(bounds.left), camera.y(bounds.top), (bounds.right - bounds.left) * camera.scale, (bounds.top - bounds.bottom) * camera.scale);
    context.font = `600 12px ${theme.font}`;
    haloText(context, across, camera.x(bounds.right), bottom, theme.ink);
    haloText(context, up, left, camera.y(bounds.top), theme.ink);
  }

  /* What is behind the robot is a solid line, what is ahead of it a thin one; a dot at each step. */
  paintPath(context, points, p) {
    const { camera, model } = this;
    const place = ([x, y]) => [camera.x(x), camera.y(y)];
    const here = place(model.point(p));
    const step = Math.floor(model.time);
    const line = (corners, wide, alpha) => {
      context.globalAlpha = alpha;
      context.beginPath();
      for (const [x, y] of corners) context.lineTo(x, y);
      context.lineWidth = wide;
      context.strokeStyle = model.classes[p].color;
      context.stroke();
      context.globalAlpha = 1;
    };
    context.lineJoin = "round";
    line([here, ...points.slice(step + 1).map(place)], 1.5, 0.55);
    line([...points.slice(0, step + 1).map(place), here], 3.5, 1);
    context.fillStyle = model.classes[p].color;
    points.map(place).forEach(([x, y], n) => {
      context.beginPath();
      context.arc(x, y, n <= model.time ? 3 : 2, 0, 2 * Math.PI);
      context.fill();
    });
  }

  paintPoint(context, p) {
    const [x, y] = this.placeOf(p);
    context.beginPath();
    MARKS[p % MARKS.length](context, x, y, 8);
    context.fillStyle = this.model.classes[p].color;
    context.fill();
    context.lineWidth = 2;
    context.strokeStyle = theme.halo;
    context.stroke();
  }

  placeOf(path) {
    const [x, y] = this.model.point(path);
    return [this.camera.x(x), this.camera.y(y)];
  }

  click() {
    if (this.camera.clicked) this.choice.nothing();
  }
}

/* Every signal in a row: its line between its least and greatest value. */
class SignalRows extends Timeline {
  constructor(model, choice, player) {
    super(model, [], choice, player, { row: TALL });
  }

  paintRow(context, m, top) {
    const { name, values, control } = this.model.tracks[m];
    if (m === this.choice.track) {
      context.fillStyle = theme.shade;
      context.fillRect(0, top, this.whole, TALL);
    }
    const [least, most] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
    const y = (value) => top + TALL - 8 - ((value - least) * (TALL - 16)) / (most - least || 1);
    context.font = `${m === this.choice.track ? 600 : 400} 12px ${theme.font}`;
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.fillStyle = theme.ink;
    context.fillText(fitted(context, name, this.names - 60), 10, top + TALL / 2);
    context.font = `10.5px ${theme.font}`;
    context.textAlign = "right";
    context.fillStyle = theme.soft;
    if (most > least) context.fillText(numberWords(most), this.names - 8, y(most));
    context.fillText(numberWords(least), this.names - 8, y(least));
    context.strokeStyle = control ? theme.soft : theme.accent;
    context.lineWidth = 1.6;
    context.lineJoin = "round";
    context.beginPath();
    values.forEach((value, step) => {
      context.lineTo(this.x(step), y(value));
      if (control) context.lineTo(this.x(step + 1), y(value));
    });
    context.stroke();
  }
}

/* The signals in words: a list with the values of the present time. */
class SignalList {
  constructor(model, choice) {
    this.model = model;
    this.choice = choice;
    this.list = document.getElementById("agents");
    this.filter = document.getElementById("filter");
    this.filter.addEventListener("input", () => this.fill());
    this.fill();
  }

  fill() {
    const wanted = this.filter.value.trim().toLowerCase();
    this.rows = new Map();
    this.list.replaceChildren();
    this.model.tracks.forEach(({ name }, m) => {
      if (!name.toLowerCase().includes(wanted)) return;
      const button = element("button");
      button.type = "button";
      const where = element("span", "where");
      button.append(element("span", "name", name), where);
      button.addEventListener("click", () => this.choice.chooseTrack(m));
      this.rows.set(m, { button, where });
      this.list.append(button);
    });
    if (!this.rows.size) this.list.append(element("p", "", "no signal fits"));
    this.update();
    this.showChoice();
  }

  update() {
    for (const [m, { where }] of this.rows) {
      const words = numberWords(this.model.value(m));
      if (where.textContent !== words) where.textContent = words;
    }
  }

  showChoice() {
    for (const [m, { button }] of this.rows) button.setAttribute("aria-pressed", String(m === this.choice.track));
  }
}
