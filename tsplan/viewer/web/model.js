/* The plan as flat arrays: where every track is at any time.

   A track is one or more agents on one path. Its stops are in time order; between two stops it is
   on the way. All stops of all tracks stand in the same arrays, those of track m from begin[m] to
   begin[m + 1]. `seek` fills `source`, `target` (stops) and `share` for every track. */

class Model {
  constructor(data) {
    this.horizon = data.horizon;
    this.states = data.map.states;
    this.edges = data.map.edges;
    this.classes = data.classes;
    this.tracks = data.tracks;
    this.freights = data.freights.map(([from, to, left, come, words]) => ({ from, to, left, come, words }));
    this.loads = data.tracks.map((track) => new Map(track.loads));
    this.stocks = data.map.states.map(() => []);
    for (const stock of data.stocks) this.stocks[stock.state].push(stock);
    const tracks = data.tracks.length;
    const stops = data.tracks.reduce((sum, track) => sum + track.stops.length / 4, 0);
    this.begin = new Int32Array(tracks + 1);
    this.first = new Int32Array(stops);
    this.last = new Int32Array(stops);
    this.state = new Int32Array(stops);
    this.slot = new Int32Array(stops);
    this.kind = new Int32Array(tracks);
    this.count = new Int32Array(tracks);
    this.end = new Int32Array(tracks);
    this.source = new Int32Array(tracks);
    this.target = new Int32Array(tracks);
    this.share = new Float64Array(tracks);
    this.present = new Uint8Array(tracks);
    this.agents = 0;
    this.fill(data.tracks);
    this.gatherConvoys(stops);
    this.seek(0);
  }

  fill(tracks) {
    let next = 0;
    tracks.forEach((track, m) => {
      this.begin[m] = next;
      this.kind[m] = track.class;
      this.count[m] = track.count;
      this.end[m] = track.end;
      this.agents += track.count;
      for (let i = 0; i < track.stops.length; i += 4) {
        this.first[next] = track.stops[i];
        this.last[next] = track.stops[i + 1];
        this.state[next] = track.stops[i + 2];
        this.slot[next] = track.stops[i + 3];
        next += 1;
      }
    });
    this.begin[tracks.length] = next;
  }

  /* Agents of one class that enter one edge together form a convoy. For the way that begins at a
     stop: how many are in its convoy, and which stop stands for the convoy. */
  gatherConvoys(stops) {
    this.convoy = new Int32Array(stops);
    this.leader = new Int32Array(stops);
    const leaders = new Map();
    for (let m = 0; m < this.tracks.length; m += 1) {
      for (let i = this.begin[m]; i + 1 < this.begin[m + 1]; i += 1) {
        const key = [this.kind[m], this.state[i], this.state[i + 1], this.last[i], this.first[i + 1]].join();
        if (!leaders.has(key)) leaders.set(key, i);
        this.leader[i] = leaders.get(key);
        this.convoy[this.leader[i]] += this.count[m];
      }
    }
    for (let i = 0; i < stops; i += 1) this.convoy[i] = this.convoy[this.leader[i]];
  }

  /* The last stop of a track that has begun at a time. */
  stopAt(track, time) {
    let low = this.begin[track];
    let high = this.begin[track + 1] - 1;
    const here = this.source[track];
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
    for (let m = 0; m < this.tracks.length; m += 1) {
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

  /* The state of a track at the time last sought, -1 while it travels or is not there. */
  stateOf(track) {
    return this.present[track] && this.share[track] === 0 ? this.state[this.source[track]] : -1;
  }

  /* Every track with its agents, its state and its point on a map. */
  places(map) {
    return this.tracks.map(({ name, ids, count }, m) => {
      const state = this.stateOf(m);
      return { name, ids: [...ids], count, state: state < 0 ? null : this.states[state].name, at: map.markers.positionOf(m) };
    });
  }

  /* Where a track is, in words. */
  whereabouts(track) {
    if (!this.present[track]) {
      const born = this.first[this.begin[track]];
      return this.time < born ? `from step ${born}` : `until step ${this.end[track]}`;
    }
    const from = this.states[this.state[this.source[track]]].name;
    if (this.share[track] === 0) return from;
    const load = this.loads[track].get(this.last[this.source[track]]);
    const way = `${from} \u2192 ${this.states[this.state[this.target[track]]].name}`;
    return load ? `${way} with ${load}` : way;
  }

  /* What lies at a state now, as words; between two steps what has stayed after the first. */
  lying(state) {
    const found = [];
    for (const { name, amounts } of this.stocks[state]) {
      const now = amounts.findLast(([step]) => step <= this.time);
      if (!now) continue;
      const amount = now[0] === this.time ? now[1] : now[2];
      if (amount !== "0") found.push(`${amount} ${name}`);
    }
    return found;
  }

  /* Agents of each class at a state now, as [class, agents] pairs. */
  staffing(state) {
    const counts = new Map();
    for (let m = 0; m < this.tracks.length; m += 1) {
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
