/* What moves: agents as marks while there is room for each, as numbers where there is not.

   All lists of a frame live in arrays that are made once and grow when they must. */

const WIDEST = 60; // dots around a state's middle that single agents may take

class Markers {
  constructor(model, ground) {
    this.model = model;
    this.ground = ground;
    this.tally = new Int32Array(model.states.length * model.classes.length);
    this.totals = new Int32Array(model.states.length);
    this.marks = model.classes.map(() => new Float32Array(64)); // x, y of each mark
    this.used = new Int32Array(model.classes.length);
    this.hits = new Float32Array(256); // x, y, track of each mark
    this.hit = 0;
    this.blobs = []; // numbers drawn in this frame: reused records
    this.blobCount = 0;
    this.stampCut = "";
  }

  paint(context, camera, chosen) {
    const sizes = this.ground.sizes(camera);
    this.distance = sizes.mark * 2.35;
    this.radius = sizes.mark;
    this.most = slotsWithin(Math.min(sizes.room * 0.42, WIDEST) / this.distance);
    this.used.fill(0);
    this.hit = 0;
    this.blobCount = 0;
    this.count();
    this.place(camera);
    this.paintMarks(context);
    this.paintBlobs(context);
    if (chosen >= 0) this.paintRing(context, camera, chosen);
  }

  count() {
    const { model, tally, totals } = this;
    tally.fill(0);
    totals.fill(0);
    for (let m = 0; m < model.tracks.length; m += 1) {
      const state = model.stateOf(m);
      if (state < 0) continue;
      tally[state * model.classes.length + model.kind[m]] += model.count[m];
      totals[state] += model.count[m];
    }
  }

  place(camera) {
    const { model, totals } = this;
    for (let m = 0; m < model.tracks.length; m += 1) {
      if (!model.present[m]) continue;
      const from = model.source[m];
      const crowd = model.share[m] === 0 ? totals[model.state[from]] : model.convoy[from];
      if (crowd <= this.most) this.placeEach(camera, m);
      else if (model.share[m] !== 0 && model.leader[from] === from) this.placeConvoy(camera, m);
    }
    for (let s = 0; s < totals.length; s += 1) {
      if (totals[s] > this.most) this.placeStaffing(camera, s);
    }
  }

  /* The middle of a track on the screen, into `this.px` and `this.py`. */
  locate(camera, m) {
    const { model } = this;
    const a = model.states[model.state[model.source[m]]];
    const b = model.states[model.state[model.target[m]]];
    const share = model.share[m];
    this.px = camera.x(a.x + (b.x - a.x) * share);
    this.py = camera.y(a.y + (b.y - a.y) * share);
    if (share === 0) return;
    // on the right of the way, so that opposite directions pass each other
    const dx = (b.x - a.x) * camera.scale;
    const dy = (a.y - b.y) * camera.scale;
    const length = Math.hypot(dx, dy) || 1;
    const aside = this.radius * 1.3 * Math.min(1, 6 * share, 6 * (1 - share));
    this.px -= (dy / length) * aside;
    this.py += (dx / length) * aside;
  }

  placeEach(camera, m) {
    const { model } = this;
    this.locate(camera, m);
    const share = model.share[m];
    for (let i = 0; i < model.count[m]; i += 1) {
      const a = Math.min(SLOTS - 1, model.slot[model.source[m]] + i);
      const b = Math.min(SLOTS - 1, model.slot[model.target[m]] + i);
      const x = this.px + (SLOT_X[a] * (1 - share) + SLOT_X[b] * share) * this.distance;
      const y = this.py + (SLOT_Y[a] * (1 - share) + SLOT_Y[b] * share) * this.distance;
      this.mark(model.kind[m], x, y, m);
    }
  }

  mark(kind, x, y, track) {
    if (2 * this.used[kind] + 2 > this.marks[kind].length) this.marks[kind] = doubled(this.marks[kind]);
    this.marks[kind][2 * this.used[kind]] = x;
    this.marks[kind][2 * this.used[kind] + 1] = y;
    this.used[kind] += 1;
    if (3 * this.hit + 3 > this.hits.length) this.hits = doubled(this.hits);
    this.hits[3 * this.hit] = x;
    this.hits[3 * this.hit + 1] = y;
    this.hits[3 * this.hit + 2] = track;
    this.hit += 1;
  }

  placeConvoy(camera, m) {
    this.locate(camera, m);
    this.blob(this.model.kind[m], this.model.convoy[this.model.source[m]], this.px, this.py, -1);
  }

  /* One number for each class at a crowded state, one below the other around its middle. */
  placeStaffing(camera, s) {
    const kinds = this.model.classes.length;
    const height = this.blobHeight() + 1;
    let lines = 0;
    for (let kind = 0; kind < kinds; kind += 1) lines += this.tally[s * kinds + kind] ? 1 : 0;
    const x = camera.x(this.model.states[s].x);
    let y = camera.y(this.model.states[s].y) - ((lines - 1) * height) / 2;
    for (let kind = 0; kind < kinds; kind += 1) {
      const agents = this.tally[s * kinds + kind];
      if (!agents) continue;
      this.blob(kind, agents, x, y, s);
      y += height;
    }
  }

  blobHeight() { return Math.min(18, Math.max(11, this.radius * 3.6)); }

  blob(kind, agents, x, y, state) {
    if (this.blobCount === this.blobs.length) this.blobs.push({});
    const blob = this.blobs[this.blobCount];
    this.blobCount += 1;
    Object.assign(blob, { kind, agents, x, y, state });
  }

  /* Marks are stamped from a small picture of each class, which is far quicker than shapes. */
  paintMarks(context) {
    this.cutStamps();
    const size = this.stamps[0].width / this.stampRatio;
    for (let k = 0; k < this.stamps.length; k += 1) {
      const places = this.marks[k];
      for (let i = 0; i < this.used[k]; i += 1) {
        context.drawImage(this.stamps[k], places[2 * i] - size / 2, places[2 * i + 1] - size / 2, size, size);
      }
    }
  }

  /* New stamps where the size, the screen or the theme has changed. */
  cutStamps() {
    const ratio = Math.min(3, window.devicePixelRatio || 1);
    const cut = `${this.radius} ${ratio} ${theme.ground}`;
    if (this.stampCut === cut) return;
    this.stampCut = cut;
    this.stampRatio = ratio;
    this.stamps = this.model.classes.map((kind) => this.stamp(kind, ratio));
  }

  stamp(kind, ratio) {
    const side = Math.ceil((2 * this.radius * 1.22 + 4) * ratio);
    const canvas = new OffscreenCanvas(side, side);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    context.beginPath();
    MARKS[kind.mark % MARKS.length](context, side / ratio / 2, side / ratio / 2, this.radius);
    context.fillStyle = kind.color;
    context.fill();
    if (this.radius >= 3) {
      context.lineWidth = this.radius > 5 ? 1.3 : 0.8;
      context.strokeStyle = theme.halo;
      context.stroke();
    }
    return canvas.transferToImageBitmap();
  }

  paintBlobs(context) {
    const height = this.blobHeight();
    context.font = `600 ${Math.round(height * 0.72)}px ${theme.font}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (let i = 0; i < this.blobCount; i += 1) {
      const blob = this.blobs[i];
      const kind = this.model.classes[blob.kind];
      const words = String(blob.agents);
      blob.width = Math.max(height, height * (0.6 + 0.44 * words.length));
      context.beginPath();
      context.roundRect(blob.x - blob.width / 2, blob.y - height / 2, blob.width, height, height / 2);
      context.fillStyle = kind.color;
      context.fill();
      context.lineWidth = 1;
      context.strokeStyle = theme.halo;
      context.stroke();
      context.fillStyle = kind.ink;
      context.fillText(words, blob.x, blob.y + 0.5);
    }
  }

  paintRing(context, camera, chosen) {
    if (!this.model.present[chosen]) return;
    context.lineWidth = 2.5;
    context.strokeStyle = theme.ink;
    context.beginPath();
    let seen = false;
    for (let i = 0; i < this.hit; i += 1) {
      if (this.hits[3 * i + 2] !== chosen) continue;
      const [x, y] = [this.hits[3 * i], this.hits[3 * i + 1]];
      context.moveTo(x + this.radius + 3.5, y);
      context.arc(x, y, this.radius + 3.5, 0, 2 * Math.PI);
      seen = true;
    }
    if (!seen) {
      this.locate(camera, chosen);
      const around = this.blobHeight();
      context.moveTo(this.px + around, this.py);
      context.arc(this.px, this.py, around, 0, 2 * Math.PI);
    }
    context.stroke();
  }

  /* The track whose mark is nearest to a point, -1 if none is close. */
  trackAt(x, y) {
    let best = -1;
    let nearest = Math.max(this.radius + 5, touched() ? TARGET / 2 : 0);
    for (let i = 0; i < this.hit; i += 1) {
      const distance = Math.hypot(this.hits[3 * i] - x, this.hits[3 * i + 1] - y);
      if (distance < nearest) [best, nearest] = [this.hits[3 * i + 2], distance];
    }
    return best;
  }

  /* The state of a number under a point, -1 if there is none. */
  blobAt(x, y) {
    const height = this.blobHeight();
    for (let i = 0; i < this.blobCount; i += 1) {
      const blob = this.blobs[i];
      const close = Math.abs(blob.x - x) <= blob.width / 2 && Math.abs(blob.y - y) <= height / 2;
      if (close && blob.state >= 0) return blob.state;
    }
    return -1;
  }

  /* Where a track is drawn now, for those who ask from outside. */
  positionOf(track) {
    for (let i = 0; i < this.hit; i += 1) {
      if (this.hits[3 * i + 2] === track) return [this.hits[3 * i], this.hits[3 * i + 1]];
    }
    return null;
  }
}

function doubled(array) {
  const larger = new Float32Array(array.length * 2);
  larger.set(array);
  return larger;
}
