/* In which order tracks are listed: those that move first, and of many agents the others folded. */

const MOST_UNFOLDED = 24; // agents up to which all of them are listed

class Fold {
  constructor(tracks) {
    this.tracks = tracks;
    const places = tracks.map((_, m) => m);
    const idle = places.filter((m) => tracks[m].idle);
    const agents = tracks.reduce((sum, track) => sum + (track.count || 0), 0);
    this.foldable = agents > MOST_UNFOLDED && idle.length > 1 ? idle : [];
    const folded = new Set(this.foldable);
    this.movers = this.foldable.length ? places.filter((m) => !folded.has(m)) : places;
    this.hidden = idle.reduce((sum, m) => sum + (folded.has(m) ? tracks[m].count : 0), 0);
    this.open = false;
    this.listeners = [];
  }

  get folds() { return this.foldable.length > 0; }
  get order() { return this.folds ? [...this.movers, ...this.foldable] : this.movers; }

  /* The tracks of the rows that are seen; -1 is the row that folds and unfolds the others. */
  get rows() {
    if (!this.folds) return this.movers;
    return [...this.movers, -1, ...(this.open ? this.foldable : [])];
  }

  get words() {
    const verb = this.hidden === 1 ? "never moves" : "never move";
    return `${this.hidden} ${verb}`;
  }

  toggle(open = !this.open) {
    if (this.open === open || !this.folds) return;
    this.open = open;
    for (const listener of this.listeners) listener();
  }

  /* Unfold where a track is hidden. */
  show(track) { if (track >= 0 && this.folds && this.tracks[track].idle) this.toggle(true); }
}
