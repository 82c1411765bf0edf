/* The time that is shown: playing, pausing, seeking. One listener list hears of each change. */

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16];

class Player {
  constructor(horizon) {
    this.horizon = horizon;
    this.time = 0;
    this.playing = false;
    this.loop = false;
    this.speed = 1; // steps a second
    this.smooth = true;
    this.listeners = [];
    this.former = 0;
    this.frame = this.frame.bind(this);
  }

  /* Whole steps only where the reader asks for little motion. */
  get shown() {
    return this.smooth || !this.playing ? this.time : Math.floor(this.time + 1e-9);
  }

  tell() {
    for (const listener of this.listeners) listener(this);
  }

  seek(time) {
    this.time = Math.min(this.horizon, Math.max(0, time));
    this.tell();
  }

  /* To a neighbouring whole step; from between two steps, to the next one in that direction. */
  step(steps) {
    this.pause();
    const whole = steps > 0 ? Math.floor(this.time + 1e-9) : Math.ceil(this.time - 1e-9);
    this.seek(whole + steps);
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.horizon) this.time = 0;
    this.playing = true;
    this.former = 0;
    this.tell();
    requestAnimationFrame(this.frame);
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.tell();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  faster(places) {
    const place = SPEEDS.indexOf(this.speed) + places;
    this.speed = SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, place))];
    this.tell();
  }

  frame(now) {
    if (!this.playing) return;
    const seconds = this.former ? Math.min(0.1, (now - this.former) / 1000) : 0;
    this.former = now;
    this.time += seconds * this.speed;
    if (this.time >= this.horizon) {
      if (this.loop && this.horizon > 0) {
        this.time %= this.horizon;
      } else {
        this.time = this.horizon;
        this.playing = false;
      }
    }
    this.tell();
    if (this.playing) requestAnimationFrame(this.frame);
  }
}
