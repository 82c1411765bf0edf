/* The page: what is chosen, what every part hears of, keys and buttons. */

/* The chosen agent, state and part of the formula; -1 where nothing is chosen. */
class Choice {
  constructor(nodes) {
    this.nodes = nodes;
    this.track = -1;
    this.state = -1;
    this.node = -1;
    this.listeners = [];
  }

  get part() { return this.node < 0 ? null : this.nodes[this.node]; }
  get states() {
    const lit = new Set(this.part ? this.part.states : []);
    if (this.state >= 0) lit.add(this.state);
    return lit;
  }

  set(changes) {
    Object.assign(this, changes);
    for (const listener of this.listeners) listener(Object.keys(changes));
  }

  chooseTrack(track) { this.set({ track: track === this.track ? -1 : track }); }
  chooseNode(node) { this.set({ node: node === this.node ? -1 : node }); }
  chooseState(state) { if (state !== this.state) this.set({ state }); else if (state >= 0) this.set({ state: -1 }); }
  nothing() { this.set({ track: -1, state: -1, node: -1 }); }

  /* The agent or part some places on, from none to the first or last. */
  neighbour(now, steps, length) {
    if (!length) return -1;
    if (now < 0) return steps > 0 ? 0 : length - 1;
    return (now + steps + length) % length;
  }
}

class Page {
  constructor(data) {
    readTheme();
    this.data = data;
    for (const kind of data.classes) kind.given = kind.color;
    this.paintClasses();
    this.choice = new Choice(data.formula);
    this.player = new Player(data.horizon);
    this.fillHeader();
    Object.assign(this, data.signals ? signalViews(data, this) : this.planViews());
    this.picture = new Picture(this);
    this.formula = new FormulaTree(data.formula, this.choice);
    this.charts = new Charts(data.horizon, this.player);
    this.clock = document.getElementById("clock");
    this.scrub = document.getElementById("scrub");
    this.player.listeners.push(() => this.onTime());
    this.choice.listeners.push((changed) => this.onChoice(changed));
    this.bindControls();
    this.followSettings();
    new Keys(this);
    this.onTime();
    new StepLink(this.player);
  }

  planViews() {
    const { choice, player } = this;
    const { data } = this;
    const model = new Model(data);
    const planned = data.planned ? plannedModel(data) : null;
    document.body.classList.toggle("both", planned !== null);
    const map = new MapView(model, choice, document.getElementById("map-canvas"));
    const maps = [map];
    if (planned) {
      const other = new MapView(planned, new PlannedChoice(choice, data.planned.tracks, data.tracks.length), document.getElementById("planned-canvas"));
      yoke(map.camera, other.camera);
      maps.unshift(other);
    }
    const fold = new Fold(model.tracks);
    const timeline = new Timeline(model, map.ground.colours, choice, player, { fold, planned });
    return { model, planned, map, maps, fold, timeline, agents: new AgentList(model, choice, player, { fold, planned }) };
  }

  /* What the marks stand for, and how long edges without a number take. */
  legendEntries() {
    const entries = this.data.classes.filter((kind) => kind.name)
      .map((kind) => ({ kind, words: kind.agents === null ? kind.name : `${kind.agents} ${kind.name}` }));
    const usual = this.data.map ? this.data.map.usual : "";
    return usual ? [...entries, { kind: null, words: usual }] : entries;
  }

  fillHeader() {
    const { data } = this;
    document.title = data.title;
    document.getElementById("title").textContent = data.title;
    document.getElementById("outcome").textContent = data.outcome;
    for (const { text, about } of data.facts) {
      const fact = element("li", "", text);
      fact.title = about;
      document.getElementById("facts").append(fact);
    }
    this.fillLegend();
  }

  /* The classes' colours on the present ground. */
  paintClasses() {
    for (const kind of this.data.classes) {
      kind.color = lifted(kind.given);
      kind.ink = inkOn(kind.color);
    }
  }

  fillLegend() {
    const legend = document.getElementById("legend");
    legend.replaceChildren();
    const entries = this.legendEntries();
    for (const { kind, words } of entries) {
      const entry = element("span");
      if (kind) entry.append(swatch(kind));
      entry.append(document.createTextNode(words));
      legend.append(entry);
    }
    legend.hidden = entries.length === 0;
  }

  bindControls() {
    const { player } = this;
    const on = (id, name, action) => document.getElementById(id).addEventListener(name, action);
    const speed = document.getElementById("speed");
    for (const value of SPEEDS) speed.append(new Option(`${value} steps/s`, String(value)));
    this.speed = speed;
    this.loop = document.getElementById("loop");
    this.scrub.max = String(this.data.horizon);
    on("play", "click", () => player.toggle());
    on("back", "click", () => player.step(-1));
    on("forward", "click", () => player.step(1));
    on("to-start", "click", () => player.seek(0));
    on("to-end", "click", () => player.seek(player.horizon));
    on("scrub", "input", () => player.seek(Number(this.scrub.value)));
    on("scrub", "pointerdown", () => player.pause());
    on("scrub", "change", () => { if (!player.playing) player.seek(Math.round(player.time)); });
    on("speed", "change", () => { player.speed = Number(speed.value); });
    on("loop", "change", () => { player.loop = this.loop.checked; });
    on("zoom-in", "click", () => this.map.camera.zoom(1.4));
    on("zoom-out", "click", () => this.map.camera.zoom(1 / 1.4));
    on("zoom-fit", "click", () => this.map.camera.fit());
    on("theme", "click", () => this.switchTheme());
    on("save", "click", () => this.picture.save());
    on("help-open", "click", () => this.help.showModal());
    on("help-close", "click", () => this.help.close());
    this.help = document.getElementById("help");
  }

  /* The system's wishes: dark or light until the reader switches, and whether things may glide. */
  followSettings() {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    this.switched = false;
    const shade = () => { if (!this.switched) this.setTheme(dark.matches ? "dark" : "light"); };
    const motion = () => { this.player.smooth = !still.matches; };
    dark.addEventListener("change", shade);
    still.addEventListener("change", motion);
    shade();
    motion();
  }

  switchTheme() {
    this.switched = true;
    this.setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
  }

  setTheme(name) {
    document.documentElement.dataset.theme = name;
    readTheme();
    this.paintClasses();
    this.fillLegend();
    this.agents.fill();
    for (const map of this.maps) map.refresh();
    this.timeline.refresh();
    this.charts.paint();
  }

  onTime() {
    const { player, model } = this;
    const time = player.shown;
    model.seek(time);
    if (this.planned) this.planned.seek(time);
    for (const map of this.maps) map.paint();
    this.timeline.move();
    this.formula.update(time);
    this.charts.move(time);
    this.agents.update(time);
    this.showSettings();
    this.scrub.value = String(time);
    const words = `step ${Number.isInteger(time) ? time : time.toFixed(1)} of ${player.horizon}`;
    if (this.clock.textContent === words) return;
    this.clock.textContent = words;
    this.scrub.setAttribute("aria-valuetext", words);
  }

  /* Whether it plays, how fast, and whether it starts again: only when that has changed. */
  showSettings() {
    const { playing, speed, loop } = this.player;
    const now = `${playing} ${speed} ${loop}`;
    if (this.settings === now) return;
    this.settings = now;
    document.body.classList.toggle("playing", playing);
    document.getElementById("play").setAttribute("aria-label", playing ? "Pause" : "Play");
    this.speed.value = String(speed);
    this.loop.checked = loop;
  }

  onChoice(changed) {
    if (changed.includes("node")) {
      this.charts.show(this.choice.part);
      this.formula.showChoice();
    }
    if (changed.includes("state")) this.agents.fill();
    if (changed.includes("track")) {
      if (this.fold) this.fold.show(this.choice.track);
      this.agents.showChoice();
      if (this.choice.track >= 0) this.timeline.reveal(this.choice.track);
    }
    for (const map of this.maps) map.refresh();
    this.timeline.refresh();
  }
}

/* Keys work wherever the focus is, except where they type or press something. */
class Keys {
  constructor(page) {
    const { player, choice, map } = page;
    const order = page.fold ? page.fold.order : page.model.tracks.map((_, m) => m);
    const track = (steps) => {
      const place = choice.neighbour(order.indexOf(choice.track), steps, order.length);
      choice.set({ track: place < 0 ? -1 : order[place] });
    };
    const node = (steps) => choice.set({ node: choice.neighbour(choice.node, steps, choice.nodes.length) });
    this.page = page;
    this.actions = {
      " ": () => player.toggle(),
      ArrowLeft: (event) => player.step(event.shiftKey ? -10 : -1),
      ArrowRight: (event) => player.step(event.shiftKey ? 10 : 1),
      ArrowUp: () => track(-1),
      ArrowDown: () => track(1),
      Home: () => player.seek(0),
      End: () => player.seek(player.horizon),
      "+": () => player.faster(1),
      "=": () => player.faster(1),
      "-": () => player.faster(-1),
      "0": () => map.camera.fit(),
      i: () => map.camera.zoom(1.4),
      o: () => map.camera.zoom(1 / 1.4),
      l: () => { player.loop = !player.loop; player.tell(); },
      n: () => node(1),
      p: () => node(-1),
      t: () => page.switchTheme(),
      s: () => page.picture.save(),
      Escape: () => choice.nothing(),
      "?": () => page.help.showModal(),
    };
    document.addEventListener("keydown", (event) => this.press(event));
  }

  press(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (this.page.help.open) {
      if (event.key === "Escape") this.page.help.close();
      return;
    }
    const action = this.actions[event.key];
    if (!action || this.typing(event)) return;
    event.preventDefault();
    action(event);
  }

  typing({ target, key }) {
    const tag = target.tagName;
    if (tag === "INPUT" && target.type === "search") return key !== "Escape" || target.value !== "";
    if (tag === "SELECT") return true;
    if (tag === "BUTTON" || (tag === "INPUT" && target.type === "checkbox")) return key === " ";
    return false;
  }
}

const page = new Page(JSON.parse(document.getElementById("data").textContent));

/* What is shown now, for tests and for the curious; nothing here can change it. */
window.tsplanViewer = Object.freeze({
  time: () => page.player.time,
  playing: () => page.player.playing,
  speed: () => page.player.speed,
  chosen: () => ({ track: page.choice.track, state: page.choice.state, node: page.choice.node }),
  places: () => page.model.places(page.map),
  planned: () => (page.planned ? page.planned.places(page.maps[0]) : null),
  labels: () => (page.map.ground ? page.map.ground.written : []),
  picture: () => page.picture.painted().toDataURL(),
  stateAt: (name) => page.map.placeOf(name),
  parts: () => page.choice.nodes.map((node, n) => ({ text: node.heading, status: page.formula.status(n, page.player.shown) })),
});
