/* The map on the page: ground, the chosen agent's path, agents, pointing and clicking. */

class MapView {
  constructor(model, choice, canvas) {
    this.model = model;
    this.choice = choice;
    this.canvas = canvas;
    this.tip = document.getElementById("tip");
    this.ground = new Ground(model);
    this.markers = new Markers(model, this.ground);
    this.supplies = new Supplies(model, this.ground);
    this.stale = true;
    this.asked = false;
    this.camera = new Camera(this.canvas, this.ground.bounds, () => this.refresh());
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.canvas.addEventListener("pointerleave", () => { this.tip.hidden = true; });
    this.canvas.addEventListener("pointerup", (event) => this.click(event));
    new ResizeObserver(() => this.camera.resized()).observe(this.canvas);
  }

  /* Paint the ground again with the next frame. */
  refresh() {
    this.stale = true;
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => this.paint());
  }

  paint() {
    if (!this.camera) return;
    this.asked = false;
    const { width, height } = this.camera;
    const { context } = sizeCanvas(this.canvas, width, height);
    if (this.stale) {
      this.stale = false;
      this.ground.paint(this.camera, this.choice.states);
    }
    context.clearRect(0, 0, width, height);
    context.drawImage(this.ground.canvas, 0, 0, width, height);
    if (this.choice.track >= 0) this.paintPath(context, this.choice.track);
    this.markers.paint(context, this.camera, this.choice.track);
    this.supplies.paint(context, this.camera);
  }

  /* The path of the chosen agent: what is behind it solid, what is ahead of it dashed. */
  paintPath(context, track) {
    const { model, camera } = this;
    const place = (stop) => {
      const state = model.states[model.state[stop]];
      return [camera.x(state.x), camera.y(state.y)];
    };
    this.markers.locate(camera, track);
    const here = [this.markers.px, this.markers.py];
    const now = model.source[track];
    const behind = [];
    const ahead = [here];
    for (let i = model.begin[track]; i < model.begin[track + 1]; i += 1) {
      (i <= now ? behind : ahead).push(place(i));
    }
    behind.push(here);
    context.lineJoin = "round";
    context.lineCap = "round";
    const line = (points, dashes, colour, wide) => {
      context.setLineDash(dashes);
      context.beginPath();
      for (const [x, y] of points) context.lineTo(x, y);
      context.lineWidth = wide;
      context.strokeStyle = colour;
      context.stroke();
    };
    const colour = model.classes[model.kind[track]].color;
    for (const [points, dashes] of [[ahead, [1, 7]], [behind, []]]) {
      line(points, dashes, theme.halo, 7);
      line(points, dashes, colour, 4);
    }
    context.setLineDash([]);
    this.paintTimes(context, track, place);
  }

  /* At each state of the path the steps of the stays there. */
  paintTimes(context, track, place) {
    const { model } = this;
    const words = new Map();
    for (let i = model.begin[track]; i < model.begin[track + 1]; i += 1) {
      if (model.first[i] > model.horizon) continue;
      const stay = model.first[i] === model.last[i] ? `${model.first[i]}` : `${model.first[i]}\u2013${model.last[i]}`;
      const state = model.state[i];
      words.set(state, { at: i, text: words.has(state) ? `${words.get(state).text}, ${stay}` : stay });
    }
    context.font = `600 11px ${theme.font}`;
    context.textAlign = "center";
    context.textBaseline = "top";
    const below = Math.max(12, this.ground.sizes(this.camera).circle + 3);
    const taken = [];
    for (const { at, text } of words.values()) {
      const [x, y] = place(at);
      const top = this.supplies.below(model.state[at], this.camera, y + below);
      const shown = fitted(context, text, 120);
      const half = context.measureText(shown).width / 2 + 4;
      const places = [top, top + 15, y - below - 13].flatMap((above) => [[x, above], [x - half, above], [x + half, above]]);
      const box = ([middle, above]) => this.ground.boxOf(context, shown, middle, above);
      const free = (one) => this.ground.free(box(one)) && this.ground.free(box(one), taken);
      const found = places.find(free) || places[0];
      taken.push(box(found));
      haloText(context, shown, ...found, theme.accent);
    }
  }

  point(event) {
    if (event.buttons) {
      this.tip.hidden = true;
      return;
    }
    const track = this.markers.trackAt(event.offsetX, event.offsetY);
    const state = track >= 0 ? -1 : this.under(event);
    this.canvas.classList.toggle("over", track >= 0 || state >= 0);
    this.tip.hidden = track < 0 && state < 0;
    if (this.tip.hidden) return;
    this.tip.textContent = track >= 0 ? this.aboutTrack(track) : this.aboutState(state);
    const left = Math.min(event.offsetX + 14, this.camera.width - this.tip.offsetWidth - 6);
    const top = Math.min(event.offsetY + 14, this.camera.height - this.tip.offsetHeight - 6);
    const [right, down] = [this.canvas.offsetLeft, this.canvas.offsetTop];
    this.tip.style.transform = `translate(${right + Math.max(4, left)}px, ${down + Math.max(4, top)}px)`;
  }

  under(event) {
    const blob = this.markers.blobAt(event.offsetX, event.offsetY);
    return blob >= 0 ? blob : this.ground.stateAt(event.offsetX, event.offsetY, this.camera);
  }

  aboutTrack(track) {
    const kind = this.model.classes[this.model.kind[track]];
    const able = kind.capabilities.length ? `\n${kind.capabilities.join(", ")}` : "";
    return `${this.model.tracks[track].name}\n${this.model.whereabouts(track)}${able}`;
  }

  aboutState(state) {
    const { name, labels, capacity } = this.model.states[state];
    const lines = [name, ...(labels.length ? [labels.join(", ")] : [])];
    for (const [kind, agents] of this.model.staffing(state)) {
      lines.push(`${agents} ${this.model.classes[kind].name}`);
    }
    lines.push(...this.model.lying(state));
    if (capacity !== null) lines.push(`room for ${capacity}`);
    return lines.join("\n");
  }

  /* The point of a state on the page. */
  placeOf(name) {
    const state = this.model.states.find((one) => one.name === name);
    return state ? [this.camera.x(state.x), this.camera.y(state.y)] : null;
  }

  click(event) {
    if (!this.camera.clicked) return;
    const track = this.markers.trackAt(event.offsetX, event.offsetY);
    if (track >= 0) {
      this.choice.chooseTrack(track);
      return;
    }
    const state = this.under(event);
    if (state >= 0) this.choice.chooseState(state);
    else this.choice.nothing();
  }
}
