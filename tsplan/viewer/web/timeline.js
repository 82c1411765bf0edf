/* Who is where when: one row for each track, coloured as the map is, hatched while travelling.
   Only the rows that are seen are painted. */


class Timeline {
  constructor(model, colours, choice, player, { row = touched() ? TARGET : 20, fold = new Fold(model.tracks), planned = null } = {}) {
    this.model = model;
    this.colours = colours;
    this.row = row;
    this.fold = fold;
    this.planned = planned;
    fold.listeners.push(() => this.resize());
    this.choice = choice;
    this.player = player;
    this.rows = document.getElementById("rows");
    this.canvas = document.getElementById("rows-canvas");
    this.axis = document.getElementById("axis-canvas");
    this.playhead = document.getElementById("playhead");
    this.asked = false;
    this.measure();
    this.resize();
    this.rows.addEventListener("scroll", () => this.refresh());
    this.follow(this.rows, true);
    this.follow(this.axis, false);
    new ResizeObserver(() => this.refresh()).observe(this.rows);
  }

  /* As high as the rows that there are, up to a share of the window. */
  resize() {
    const rows = this.fold.rows.length;
    document.getElementById("rows-height").style.height = `${rows * this.row + 4}px`;
    const most = Math.max(172, 0.24 * window.innerHeight);
    this.rows.style.height = `${Math.min(most, Math.max(3, rows) * this.row + 8)}px`;
    this.refresh();
  }

  measure() {
    this.whole = this.canvas.clientWidth;
    this.names = this.whole < 560 ? 84 : 150;
    this.width = Math.max(1, this.whole - this.names - 14);
  }

  x(step) { return this.names + (step * this.width) / Math.max(1, this.model.horizon); }
  step(x) { return ((x - this.names) * Math.max(1, this.model.horizon)) / this.width; }

  /* Press and drag to seek; a press on a row also chooses its track. */
  follow(place, choosing) {
    const seek = (event) => this.player.seek(Math.round(this.step(event.clientX - this.rows.getBoundingClientRect().left)));
    place.addEventListener("pointerdown", (event) => {
      if (event.offsetX > this.whole) return; // the scroll bar
      if (choosing) {
        const row = Math.floor((event.clientY - this.canvas.getBoundingClientRect().top + this.rows.scrollTop) / this.row);
        const track = this.fold.rows[row];
        if (track === -1) this.fold.toggle();
        else if (track !== undefined) this.choice.chooseTrack(track);
      }
      if (event.clientX - this.rows.getBoundingClientRect().left < this.names) return;
      this.player.pause();
      seek(event);
      place.setPointerCapture(event.pointerId);
    });
    place.addEventListener("pointermove", (event) => {
      if (place.hasPointerCapture(event.pointerId)) seek(event);
    });
  }

  refresh() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => this.paint());
  }

  paint() {
    this.asked = false;
    this.measure();
    this.paintAxis();
    const { context, width, height } = fitCanvas(this.canvas);
    context.clearRect(0, 0, width, height);
    this.hatch = context.createPattern(hatching(), "repeat");
    this.paintSpans(context, height);
    const from = Math.floor(this.rows.scrollTop / this.row);
    const { rows } = this.fold;
    const to = Math.min(rows.length, from + Math.ceil(height / this.row) + 1);
    for (let row = from; row < to; row += 1) {
      const top = row * this.row - this.rows.scrollTop;
      if (rows[row] < 0) this.paintFold(context, top);
      else this.paintRow(context, rows[row], top);
    }
    this.move();
  }

  paintAxis() {
    const { context, width, height } = fitCanvas(this.axis);
    context.clearRect(0, 0, width, height);
    context.font = `11px ${theme.font}`;
    context.textAlign = "center";
    context.textBaseline = "top";
    context.fillStyle = theme.soft;
    context.strokeStyle = theme.line;
    const every = tickStep(this.model.horizon, this.width / 44);
    for (let step = 0; step <= this.model.horizon; step += every) {
      context.fillText(String(step), this.x(step), 3);
      context.beginPath();
      context.moveTo(this.x(step), 18);
      context.lineTo(this.x(step), height);
      context.stroke();
    }
  }

  /* The steps at which the chosen part of the formula is needed, behind all rows. */
  paintSpans(context, height) {
    const node = this.choice.part;
    if (!node) return;
    context.fillStyle = theme.witness;
    for (const [first, last] of node.needed) {
      const left = this.x(Math.max(0, first - 0.5));
      context.fillRect(left, 0, this.x(Math.min(this.model.horizon, last + 0.5)) - left, height);
    }
  }

  paintRow(context, m, top) {
    const { model } = this;
    const chosen = m === this.choice.track;
    if (chosen) {
      context.fillStyle = theme.shade;
      context.fillRect(0, top, this.whole, this.row);
    }
    const kind = model.classes[model.kind[m]];
    context.beginPath();
    MARKS[kind.mark % MARKS.length](context, 13, top + this.row / 2, 5);
    context.fillStyle = kind.color;
    context.fill();
    context.font = `${chosen ? 600 : 400} 12px ${theme.font}`;
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.fillStyle = theme.ink;
    context.fillText(fitted(context, model.tracks[m].name, this.names - 30), 24, top + this.row / 2 + 0.5);
    this.paintStops(context, m, top);
  }

  /* What happened with what was planned in a pale strip below it, or what is planned alone. */
  paintStops(context, m, top) {
    const { model, planned } = this;
    const both = planned && planned.tracks[m].count > 0;
    const high = both ? Math.round(0.62 * this.row) : this.row - 6;
    for (let i = model.begin[m]; i < model.begin[m + 1]; i += 1) this.paintStop(context, model, [m, i], [top + (both ? 2 : 3), high]);
    if (!both) return;
    context.globalAlpha = 0.5;
    const below = top + high + 3;
    for (let i = planned.begin[m]; i < planned.begin[m + 1]; i += 1) this.paintStop(context, planned, [m, i], [below, top + this.row - 1 - below], false);
    context.globalAlpha = 1;
  }

  /* The row that stands for those who never move. */
  paintFold(context, top) {
    context.font = `12px ${theme.font}`;
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.fillStyle = theme.soft;
    context.fillText(`${this.fold.open ? "\u25be" : "\u25b8"} ${this.fold.words}`, 8, top + this.row / 2 + 0.5);
  }

  paintStop(context, model, [m, i], [bar, high], named = true) {
    if (i > model.begin[m]) {
      const left = this.x(model.last[i - 1]);
      const right = this.x(Math.min(model.horizon, model.first[i]));
      context.fillStyle = this.hatch;
      const inset = Math.min(3, high / 4);
      context.fillRect(left, bar + inset, right - left, high - 2 * inset);
    }
    if (model.first[i] > model.horizon) return;
    const state = model.state[i];
    const colour = mixed(this.colours[state] || theme.state, theme.paper, 0.42);
    const left = this.x(model.first[i]) - 1.5;
    const wide = Math.max(3, this.x(model.last[i]) + 1.5 - left);
    context.fillStyle = colour;
    context.fillRect(left, bar, wide, high);
    context.lineWidth = 1;
    context.strokeStyle = theme.edge;
    context.strokeRect(left + 0.5, bar + 0.5, wide - 1, high - 1);
    if (wide < 26 || !named) return;
    context.font = `11px ${theme.font}`;
    context.fillStyle = inkOn(colour);
    context.fillText(fitted(context, model.states[state].name, wide - 8), left + 4, bar + high / 2 + 0.5);
  }

  /* The playhead is an element of its own: moving it paints nothing again. */
  move() {
    this.playhead.style.transform = `translateX(${this.x(this.model.time)}px)`;
  }

  /* Scroll a row into sight. */
  reveal(m) {
    const top = this.fold.rows.indexOf(m) * this.row;
    if (top < this.rows.scrollTop) this.rows.scrollTop = top;
    else if (top + this.row > this.rows.scrollTop + this.rows.clientHeight) {
      this.rows.scrollTop = top + this.row - this.rows.clientHeight;
    }
  }
}

/* Slanted lines for time on the way. */
function hatching() {
  const tile = document.createElement("canvas");
  tile.width = 6;
  tile.height = 6;
  const context = tile.getContext("2d");
  context.strokeStyle = theme.hatch;
  context.lineWidth = 1;
  context.beginPath();
  for (const shift of [-6, 0, 6]) {
    context.moveTo(shift, 6);
    context.lineTo(shift + 6, 0);
  }
  context.stroke();
  return tile;
}
