/* The plan as flat arrays: where every mover is at any time.

   A mover is one or more agents on one path. Its stops are in time order; between two stops it is
   on the way. All stops of all movers stand in the same arrays, those of mover m from begin[m] to
   begin[m + 1]. `seek` fills `source`, `target` (stops) and `share` for every mover. */

class Model {
  constructor(data) {
    this.horizon = data.horizon;
    this.states = data.map.states;
    this.edges = data.map.edges;
    this.classes = data.classes;
    this.movers = data.movers;
    const movers = data.movers.length;
    const stops = data.movers.reduce((sum, mover) => sum + mover.stops.length / 4, 0);
    this.begin = new Int32Array(movers + 1);
    this.first = new Int32Array(stops);
    this.last = new Int32Array(stops);
    this.state = new Int32Array(stops);
    this.slot = new Int32Array(stops);
    this.kind = new Int32Array(movers);
    this.count = new Int32Array(movers);
    this.end = new Int32Array(movers);
    this.source = new Int32Array(movers);
    this.target = new Int32Array(movers);
    this.share = new Float64Array(movers);
    this.present = new Uint8Array(movers);
    this.agents = 0;
    this.fill(data.movers);
    this.gatherConvoys(stops);
    this.seek(0);
  }

  fill(movers) {
    let next = 0;
    movers.forEach((mover, m) => {
      this.begin[m] = next;
      this.kind[m] = mover.class;
      this.count[m] = mover.count;
      this.end[m] = mover.end;
      this.agents += mover.count;
      for (let i = 0; i < mover.stops.length; i += 4) {
        this.first[next] = mover.stops[i];
        this.last[next] = mover.stops[i + 1];
        this.state[next] = mover.stops[i + 2];
        this.slot[next] = mover.stops[i + 3];
        next += 1;
      }
    });
    this.begin[movers.length] = next;
  }

  /* Agents of one class that enter one edge together form a convoy. For the way that begins at a
     stop: how many are in its convoy, and which stop stands for the convoy. */
  gatherConvoys(stops) {
    this.convoy = new Int32Array(stops);
    this.leader = new Int32Array(stops);
    const leaders = new Map();
    for (let m = 0; m < this.movers.length; m += 1) {
      for (let i = this.begin[m]; i + 1 < this.begin[m + 1]; i += 1) {
        const key = [this.kind[m], this.state[i], this.state[i + 1], this.last[i], this.first[i + 1]].join();
        if (!leaders.has(key)) leaders.set(key, i);
        this.leader[i] = leaders.get(key);
        this.convoy[this.leader[i]] += this.count[m];
      }
    }
    for (let i = 0; i < stops; i += 1) this.convoy[i] = this.convoy[this.leader[i]];
  }

  /* The last stop of a mover that has begun at a time. */
  stopAt(mover, time) {
    let low = this.begin[mover];
    let high = this.begin[mover + 1] - 1;
    const here = this.source[mover];
    if (here >= low && here <= high && this.first[here] <= time) {
      if (here === high || this.first[here + 1] > time) return here; // as a moment ago
      low = here;
    }
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.first[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  seek(time) {
    this.time = time;
    for (let m = 0; m < this.movers.length; m += 1) {
      this.present[m] = this.first[this.begin[m]] <= time && time < this.end[m] ? 1 : 0;
      const i = this.stopAt(m, time);
      this.source[m] = i;
      if (time <= this.last[i] || i + 1 === this.begin[m + 1]) {
        this.target[m] = i;
        this.share[m] = 0;
      } else {
        this.target[m] = i + 1;
        this.share[m] = (time - this.last[i]) / (this.first[i + 1] - this.last[i]);
      }
    }
  }

  /* The state of a mover at the time last sought, -1 while it travels or is not there. */
  stateOf(mover) {
    return this.present[mover] && this.share[mover] === 0 ? this.state[this.source[mover]] : -1;
  }

  /* Where a mover is, in words. */
  whereabouts(mover) {
    if (!this.present[mover]) {
      const born = this.first[this.begin[mover]];
      return this.time < born ? `from step ${born}` : `until step ${this.end[mover]}`;
    }
    const from = this.states[this.state[this.source[mover]]].name;
    if (this.share[mover] === 0) return from;
    return `${from} \u2192 ${this.states[this.state[this.target[mover]]].name}`;
  }

  /* Agents of each class at a state now, as [class, agents] pairs. */
  staffing(state) {
    const counts = new Map();
    for (let m = 0; m < this.movers.length; m += 1) {
      if (this.stateOf(m) !== state) continue;
      counts.set(this.kind[m], (counts.get(this.kind[m]) || 0) + this.count[m]);
    }
    return [...counts];
  }
}

/* The places of slots around a state's middle, in units of their distance: a spiral of hexagonal
   rings, the same for every state. */
const SLOTS = 127;
const SLOT_X = new Float64Array(SLOTS);
const SLOT_Y = new Float64Array(SLOTS);
(() => {
  const turns = [[-0.5, Math.sqrt(0.75)], [-1, 0], [-0.5, -Math.sqrt(0.75)], [0.5, -Math.sqrt(0.75)], [1, 0], [0.5, Math.sqrt(0.75)]];
  let slot = 1;
  for (let ring = 1; slot < SLOTS; ring += 1) {
    let x = ring;
    let y = 0;
    for (const [dx, dy] of turns) {
      for (let i = 0; i < ring && slot < SLOTS; i += 1) {
        SLOT_X[slot] = x;
        SLOT_Y[slot] = y;
        slot += 1;
        x += dx;
        y += dy;
      }
    }
  }
})();

/* How many slots the rings up to a radius (in slot distances) hold. */
function slotsWithin(radius) {
  const rings = Math.max(0, Math.floor(radius));
  return Math.min(SLOTS, 1 + 3 * rings * (rings + 1));
}
