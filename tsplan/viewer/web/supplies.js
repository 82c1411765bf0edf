/* Resources on the map: what lies at each state, and what is carried beside those who carry it. */

const MOST_STOCKS = 3; // resources that are written at one state; pointing at it tells of all
const STOCK_LINE = 13; // dots of one line

class Supplies {
  constructor(model, ground) {
    this.model = model;
    this.ground = ground;
  }

  paint(context, camera) {
    const sizes = this.ground.sizes(camera);
    context.font = `11px ${theme.font}`;
    context.textAlign = "center";
    this.paintStocks(context, camera, sizes);
    this.paintFreights(context, camera, sizes);
  }

  /* The lines that are written at a state now. */
  lines(state) {
    const found = this.model.lying(state);
    return found.length <= MOST_STOCKS ? found : [...found.slice(0, MOST_STOCKS - 1), `and ${found.length - MOST_STOCKS + 1} more`];
  }

  /* Where the lines at a state begin, -1 where nothing is written. */
  top(s, camera, sizes) {
    const state = this.model.states[s];
    const height = STOCK_LINE * this.lines(s).length;
    if (!height || sizes.room < ROOM_FOR_NAMES) return -1;
    if (!state.shape) return camera.y(state.y) + sizes.circle + 3;
    const box = this.ground.box(state.shape, camera);
    return box.height < 30 + height ? -1 : box.top + box.height - 3 - height;
  }

  /* The first place, from one below a state on, where other words hide nothing of them. */
  below(s, camera, from) {
    const top = this.top(s, camera, this.ground.sizes(camera));
    const end = top + STOCK_LINE * this.lines(s).length + 4;
    return top < 0 || from + STOCK_LINE < top ? from : Math.max(from, end);
  }

  /* In the bottom of a shape, below a circle, where names have room too. */
  paintStocks(context, camera, sizes) {
    context.textBaseline = "top";
    this.model.states.forEach((state, s) => {
      const top = this.top(s, camera, sizes);
      if (top < 0) return;
      const box = state.shape ? this.ground.box(state.shape, camera) : null;
      const x = box ? box.middle : camera.x(state.x);
      const width = box ? box.width - 8 : sizes.room * 0.92;
      this.lines(s).forEach((line, n) => haloText(context, fitted(context, line, width), x, top + n * STOCK_LINE, theme.ink));
    });
  }

  /* Further on the right of the way than those who carry it. */
  paintFreights(context, camera, sizes) {
    const { states, time } = this.model;
    context.textBaseline = "middle";
    const said = new Map(); // lines at each state
    for (const { from, to, left, come, words } of this.model.freights) {
      if (time <= left || time >= come) continue;
      const [a, b] = [states[from], states[to]];
      const share = (time - left) / (come - left);
      const dx = (b.x - a.x) * camera.scale;
      const dy = (a.y - b.y) * camera.scale;
      const length = Math.hypot(dx, dy) || 1;
      if (from === to) { // what is rebuilt there
        const line = said.get(from) || 0;
        said.set(from, line + 1);
        const below = camera.y(a.y) + sizes.circle + 12 + STOCK_LINE * line;
        haloText(context, words, camera.x(a.x), below, theme.ink);
        continue;
      }
      const half = context.measureText(words).width / 2;
      const aside = sizes.mark * 3.6 + (Math.abs(dy) / length) * half + (Math.abs(dx) / length) * 6;
      const x = camera.x(a.x + (b.x - a.x) * share) - (dy / length) * aside;
      const y = camera.y(a.y + (b.y - a.y) * share) + (dx / length) * aside;
      haloText(context, words, x, y, theme.ink);
    }
  }
}
