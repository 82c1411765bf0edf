/* The step in the page's address: a link such as plan.html#step=12 opens there, and the address
   says the step at which the page stands, so that it can be copied. */

const PATIENCE = 150; // milliseconds without a change until the address is written

class StepLink {
  constructor(player) {
    this.player = player;
    this.waiting = 0;
    this.read();
    window.addEventListener("hashchange", () => this.read());
    player.listeners.push(() => this.write());
  }

  /* Go to the step of the address, if it names one. */
  read() {
    const named = /^#(?:.*&)?step=(\d+(?:\.\d+)?)(?:&.*)?$/.exec(location.hash);
    if (!named) return;
    this.player.pause();
    this.player.seek(Number(named[1]));
  }

  /* While it plays nothing is written. Where a page has no address of its own, nothing ever is. */
  write() {
    clearTimeout(this.waiting);
    if (this.player.playing) return;
    this.waiting = setTimeout(() => {
      const hash = `#step=${Number(this.player.time.toFixed(2))}`;
      if (location.hash === hash || (!location.hash && this.player.time === 0)) return;
      try {
        history.replaceState(null, "", hash);
      } catch {
        this.write = () => {};
      }
    }, PATIENCE);
  }
}
