/* The agents in words: a list to choose from, and the path of the chosen one. */

const LISTED = 200; // rows of the list; a filter finds the others

class AgentList {
  constructor(model, choice, player, { fold, planned }) {
    this.model = model;
    this.choice = choice;
    this.player = player;
    this.fold = fold;
    this.planned = planned;
    fold.listeners.push(() => this.fill());
    this.list = document.getElementById("agents");
    this.filter = document.getElementById("filter");
    this.chosen = document.getElementById("chosen");
    this.rows = new Map();
    this.step = -1;
    this.texts = model.tracks.map((track) =>
      [track.name, model.classes[track.class].name, ...track.ids].join(" ").toLowerCase());
    this.filter.addEventListener("input", () => {
      this.choice.chooseState(-1);
      this.fill();
    });
    this.fill();
  }

  /* The tracks that the filter and the chosen state leave. */
  matching() {
    const { model } = this;
    const wanted = this.filter.value.trim().toLowerCase();
    const found = [];
    const all = wanted || this.choice.state >= 0 || this.fold.open;
    for (const m of all ? this.fold.order : this.fold.movers) {
      if (this.choice.state >= 0 && model.stateOf(m) !== this.choice.state) continue;
      const held = !wanted || this.texts[m].includes(wanted) || model.whereabouts(m).toLowerCase().includes(wanted);
      if (held) found.push(m);
    }
    return found;
  }

  fill() {
    const found = this.matching();
    this.rows.clear();
    this.list.replaceChildren();
    for (const m of found.slice(0, LISTED)) this.list.append(this.row(m));
    const rest = found.length - LISTED;
    if (rest > 0) this.list.append(element("p", "", `and ${rest} more; type to find them`));
    if (!found.length) this.list.append(element("p", "", this.nobody()));
    if (this.fold.folds && this.choice.state < 0 && !this.filter.value) this.list.append(this.folded());
    this.showChoice();
  }

  /* The button that shows and hides those who never move. */
  folded() {
    const button = element("button", "fold", this.fold.words);
    button.type = "button";
    button.setAttribute("aria-expanded", String(this.fold.open));
    button.addEventListener("click", () => this.fold.toggle());
    return button;
  }

  /* Where a track is, and where it was to be if that is somewhere else. */
  words(m) { return this.model.whereabouts(m) + plannedWords(this.model, this.planned, m); }

  nobody() {
    if (this.choice.state < 0) return "no agent fits";
    return `nobody is at ${this.model.states[this.choice.state].name} at step ${Math.floor(this.model.time)}`;
  }

  row(m) {
    const track = this.model.tracks[m];
    const button = element("button");
    button.type = "button";
    button.setAttribute("aria-pressed", "false");
    const where = element("span", "where", this.words(m));
    button.append(swatch(this.model.classes[track.class]), element("span", "name", track.name), where);
    button.addEventListener("click", () => this.choice.chooseTrack(m));
    this.rows.set(m, { button, where });
    return button;
  }

  /* New places for the rows at each step, and once between two; the list itself where a place
     filters it. */
  update(time) {
    const step = Number.isInteger(time) ? 2 * time : 2 * Math.floor(time) + 1;
    if (step === this.step) return;
    this.step = step;
    if (this.choice.state >= 0 || this.filter.value) {
      const found = this.matching().slice(0, LISTED);
      if (found.join() !== [...this.rows.keys()].join()) {
        this.fill();
        return;
      }
    }
    for (const [m, { where }] of this.rows) {
      const words = this.words(m);
      if (where.textContent !== words) where.textContent = words;
    }
    this.markStay();
  }

  showChoice() {
    for (const [m, { button }] of this.rows) {
      button.setAttribute("aria-pressed", String(m === this.choice.track));
    }
    const row = this.rows.get(this.choice.track);
    if (row) row.button.scrollIntoView({ block: "nearest" });
    this.showPath();
  }

  /* The chosen agent's path as a list; each stay leads to its step. */
  showPath() {
    const m = this.choice.track;
    this.chosen.hidden = m < 0;
    this.chosen.replaceChildren();
    if (m < 0) return;
    const { model } = this;
    const track = model.tracks[m];
    const kind = model.classes[track.class];
    const able = kind.capabilities.length ? `: ${kind.capabilities.join(", ")}` : "";
    const many = track.count > 1 ? `${track.count} agents on one path, ` : "";
    const path = element("ol");
    path.setAttribute("aria-label", "Path");
    for (let i = model.begin[m]; i < model.begin[m + 1]; i += 1) path.append(this.stay(i));
    this.chosen.append(element("h3", "", track.name), element("p", "", `${many}class ${kind.name}${able}`), path);
    this.markStay();
  }

  stay(i) {
    const { model } = this;
    const [first, last] = [model.first[i], model.last[i]];
    const name = model.states[model.state[i]].name;
    const item = element("li");
    const words = first > model.horizon ? `on the way to ${name}` : `${name} ${first === last ? first : `${first}\u2013${last}`}`;
    const load = model.loads[this.choice.track].get(last);
    const button = element("button", "", load ? `${words}, on with ${load}` : words);
    button.type = "button";
    button.dataset.stop = String(i);
    button.addEventListener("click", () => this.player.seek(first));
    item.append(button);
    return item;
  }

  markStay() {
    const m = this.choice.track;
    if (m < 0) return;
    const here = this.model.share[m] === 0 ? this.model.source[m] : -1;
    for (const button of this.chosen.querySelectorAll("button")) {
      if (Number(button.dataset.stop) === here) button.setAttribute("aria-current", "step");
      else button.removeAttribute("aria-current");
    }
  }
}
