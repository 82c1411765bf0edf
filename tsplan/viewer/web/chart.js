/* Counts against needs of the chosen part of the formula, in step with the time. */

class Charts {
  constructor(horizon, player) {
    this.horizon = horizon;
    this.player = player;
    this.place = document.getElementById("charts");
    this.plots = [];
    this.node = null;
    new ResizeObserver(() => this.paint()).observe(this.place);
  }

  show(node) {
    this.node = node;
    this.plots = [];
    this.place.hidden = !node || node.charts.length === 0;
    this.place.replaceChildren();
    if (this.place.hidden) return;
    for (const chart of node.charts) this.add(chart);
    if (node.hidden) this.place.append(element("p", "key", `and ${node.hidden} more counts`));
    this.place.append(element("p", "key", "blue: the window \u00b7 green: the steps chosen \u00b7 dashed: the need"));
    if (this.plots.some((plot) => plot.chart.planned)) this.place.append(element("p", "key", "pale: as it was planned"));
    this.paint();
    this.move(this.player.shown);
  }

  add(chart) {
    const figure = element("figure");
    const caption = element("figcaption");
    const now = element("span", "now");
    caption.append(element("span", "", chart.text), now);
    const plot = element("div", "plot");
    const canvas = element("canvas");
    const line = element("div", "line");
    plot.append(canvas, line);
    figure.append(caption, plot);
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${chart.text}: ${chart.smooth ? "value" : "count"} over time`);
    plot.addEventListener("pointerdown", (event) => {
      this.player.pause();
      this.player.seek(Math.round(this.step(event.offsetX)));
    });
    this.place.append(figure);
    this.plots.push({ chart, canvas, line, now });
  }

  x(step) { return this.left + (step * (this.width - this.left - 8)) / Math.max(1, this.horizon); }
  step(x) { return ((x - this.left) * Math.max(1, this.horizon)) / (this.width - this.left - 8); }

  paint() {
    this.width = this.plots.length ? this.plots[0].canvas.clientWidth : 1;
    const widest = this.plots.reduce((most, { chart }) => Math.max(most, ...rangeOf(chart).map((end) => String(Math.floor(end)).length)), 1);
    this.left = 14 + 6.5 * widest; // for the numbers beside the charts
    for (const plot of this.plots) this.paintPlot(plot);
    if (this.plots.length) this.move(this.player.shown);
  }

  paintPlot({ chart, canvas }) {
    const { context, width, height } = fitCanvas(canvas);
    context.clearRect(0, 0, width, height);
    const [least, most] = rangeOf(chart);
    const [top, bottom] = [6, height - 16];
    const y = (count) => bottom - ((count - least) * (bottom - top)) / (most - least);
    this.paintSpans(context, chart.possible, theme.shade, [top, bottom]);
    this.paintSpans(context, chart.needed, theme.witness, [top, bottom]);
    this.paintAxes(context, [least, most], [y, bottom], chart.smooth);
    if (chart.planned) this.paintCounts(context, chart.planned, y, true);
    this.paintCounts(context, chart.counts, y);
    context.strokeStyle = theme.good;
    context.lineWidth = 1.6;
    context.setLineDash([5, 4]);
    context.beginPath();
    context.moveTo(this.x(0), y(chart.bound));
    context.lineTo(this.x(this.horizon), y(chart.bound));
    context.stroke();
    context.setLineDash([]);
  }

  paintSpans(context, spans, colour, [top, bottom]) {
    context.fillStyle = colour;
    for (const [first, last] of spans) {
      const left = this.x(Math.max(0, first - 0.5));
      context.fillRect(left, top, this.x(Math.min(this.horizon, last + 0.5)) - left, bottom - top);
    }
  }

  paintAxes(context, [least, most], [y, bottom], smooth) {
    context.font = `10.5px ${theme.font}`;
    context.fillStyle = theme.soft;
    context.strokeStyle = theme.line;
    context.lineWidth = 1;
    context.textBaseline = "middle";
    context.textAlign = "right";
    const apart = tickStep(most - least, 3, smooth ? 0 : 1);
    for (let count = Math.ceil(least / apart) * apart; count <= most; count += apart) {
      context.fillText(numberWords(count), this.left - 5, y(count));
      context.beginPath();
      context.moveTo(this.left, y(count));
      context.lineTo(this.width - 8, y(count));
      context.stroke();
    }
    context.textAlign = "center";
    context.textBaseline = "top";
    for (let step = 0, every = tickStep(this.horizon, 7); step <= this.horizon; step += every) {
      context.fillText(String(step), this.x(step), bottom + 4);
    }
  }

  /* `counts` are [step, count] from each change on. Between two steps the line goes from the one
     to the other: who moves is on the way then. */
  paintCounts(context, counts, y, planned = false) {
    context.strokeStyle = theme.accent;
    context.globalAlpha = planned ? 0.5 : 1;
    context.setLineDash(planned ? [4, 3] : []);
    context.lineWidth = planned ? 1.4 : 1.8;
    context.lineJoin = "round";
    context.beginPath();
    counts.forEach(([step, count], i) => {
      if (i) context.lineTo(this.x(step - 1), y(counts[i - 1][1]));
      context.lineTo(this.x(step), y(count));
    });
    context.lineTo(this.x(this.horizon), y(counts[counts.length - 1][1]));
    context.stroke();
    context.globalAlpha = 1;
    context.setLineDash([]);
  }

  move(time) {
    for (const plot of this.plots) {
      plot.line.style.transform = `translateX(${this.x(time)}px)`;
      const words = countWords(plot.chart, time);
      if (plot.now.textContent !== words) plot.now.textContent = words;
    }
  }
}

/* How many there are now, and between two steps before and after them. */
function countWords({ counts, planned, smooth }, time) {
  const [before, after] = [Math.floor(time), Math.ceil(time)];
  const [from, to] = [countAt(counts, before), countAt(counts, after)];
  if (smooth) {
    const value = from + (to - from) * (time - before);
    return `${numberWords(value)} at step ${Number(time.toFixed(1))}`;
  }
  const meant = planned && before === after ? ` (planned: ${numberWords(countAt(planned, before))})` : "";
  if (before === after) return `${numberWords(from)} at step ${before}${meant}`;
  const words = from === to ? numberWords(from) : `${numberWords(from)} \u2192 ${numberWords(to)}`;
  return `${words} from step ${before} to ${after}`;
}

/* The least and the largest number that a chart shows; counts begin at 0. */
function rangeOf(chart) {
  const values = [...chart.counts, ...(chart.planned || [])].map(([, count]) => count).concat(chart.bound);
  if (!chart.smooth) return [0, values.reduce((a, b) => Math.max(a, b), 1)];
  const [least, most] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
  const air = 0.06 * (most - least) || 0.5;
  return [least - air, most + air];
}

function countAt(counts, step) {
  let found = 0;
  for (const [from, count] of counts) {
    if (from > step) break;
    found = count;
  }
  return found;
}
