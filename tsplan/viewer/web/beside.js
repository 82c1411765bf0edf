/* What was planned, beside what really happened: a second map with the same eyes and choices. */

/* The choice as the map of the plan sees it: tracks by their numbers there. */
class PlannedChoice {
  constructor(choice, planned, most) {
    this.choice = choice;
    this.planned = planned; // the tracks of the plan, null for those it does not have
    this.most = most; // those that are in what happened, too
  }

  get track() {
    const track = this.choice.track;
    return track >= 0 && this.planned[track] ? track : -1;
  }

  get states() { return this.choice.states; }
  chooseTrack(track) { if (track < this.most) this.choice.chooseTrack(track); }
  chooseState(state) { this.choice.chooseState(state); }
  nothing() { this.choice.nothing(); }
}

/* A track of the plan that nothing is known of stands still nowhere. */
const NO_TRACK = Object.freeze({ class: 0, count: 0, name: "", ids: [], end: 0, idle: false, stops: [0, 0, 0, 0], loads: [] });

function plannedModel(data) {
  const { tracks, freights, stocks } = data.planned;
  return new Model({ ...data, tracks: tracks.map((track) => track || NO_TRACK), freights, stocks });
}

/* Two cameras that look at the same part of the map. */
function yoke(one, other) {
  const follow = (from, to) => {
    const changed = from.changed;
    from.changed = () => {
      changed();
      if (from.following) return;
      to.following = true;
      to.middleX = from.middleX;
      to.middleY = from.middleY;
      to.scale = from.scale;
      to.whole = from.whole;
      to.changed();
      to.following = false;
    };
  };
  follow(one, other);
  follow(other, one);
}

/* Where an agent was to be, if that is not where it is: words for the list. */
function plannedWords(model, planned, track) {
  if (!planned || track >= planned.tracks.length || !planned.tracks[track].count) return "";
  const words = planned.whereabouts(track);
  return words === model.whereabouts(track) ? "" : ` (planned: ${words})`;
}
