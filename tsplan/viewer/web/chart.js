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
    canvas.setAttribute("aria-label", `${chart.text}: count over time`);
    plot.addEventListener("pointerdown", (event) => {
      this.player.pause();
      this.player.seek(Math.round(this.step(event.offsetX, canvas)));
    });
    this.place.append(figure);
    this.plots.push({ chart, canvas, line, now, shown: -1 });
  }

  left() { return 26; }
  x(step, canvas) { return this.left() + (step * (canvas.clientWidth - this.left() - 8)) / Math.max(1, this.horizon); }
  step(x, canvas) { return ((x - this.left()) * Math.max(1, this.horizon)) / (canvas.clientWidth - this.left() - 8); }

  paint() {
    for (const plot of this.plots) this.paintPlot(plot);
    if (this.plots.length) this.move(this.player.shown);
  }

  paintPlot({ chart, canvas }) {
    const { context, width, height } = fitCanvas(canvas);
    context.clearRect(0, 0, width, height);
    const most = Math.max(chart.bound, ...chart.counts.map(([, count]) => count), 1);
    const [top, bottom] = [6, height - 16];
    const y = (count) => bottom - (count * (bottom - top)) / most;
    this.paintSpans(context, canvas, chart.windows, theme.shade, [top, bottom]);
    this.paintSpans(context, canvas, chart.needed, theme.witness, [top, bottom]);
    this.paintAxes(context, canvas, most, [y, bottom]);
    this.paintCounts(context, canvas, chart.counts, y);
    context.strokeStyle = theme.good;
    context.lineWidth = 1.6;
    context.setLineDash([5, 4]);
    context.beginPath();
    context.moveTo(this.x(0, canvas), y(chart.bound));
    context.lineTo(this.x(this.horizon, canvas), y(chart.bound));
    context.stroke();
    context.setLineDash([]);
  }

  paintSpans(context, canvas, spans, colour, [top, bottom]) {
    context.fillStyle = colour;
    for (const [first, last] of spans) {
      const left = this.x(Math.max(0, first - 0.5), canvas);
      context.fillRect(left, top, this.x(Math.min(this.horizon, last + 0.5), canvas) - left, bottom - top);
    }
  }

  paintAxes(context, canvas, most, [y, bottom]) {
    context.font = `10.5px ${theme.font}`;
    context.fillStyle = theme.soft;
    context.strokeStyle = theme.line;
    context.lineWidth = 1;
    context.textBaseline = "middle";
    context.textAlign = "right";
    for (let count = 0, every = tickStep(most, 3); count <= most; count += every) {
      context.fillText(String(count), this.left() - 5, y(count));
      context.beginPath();
      context.moveTo(this.left(), y(count));
      context.lineTo(canvas.clientWidth - 8, y(count));
      context.stroke();
    }
    context.textAlign = "center";
    context.textBaseline = "top";
    for (let step = 0, every = tickStep(this.horizon, 7); step <= this.horizon; step += every) {
      context.fillText(String(step), this.x(step, canvas), bottom + 4);
    }
  }

  /* `counts` are [step, count] from each change on. */
  paintCounts(context, canvas, counts, y) {
    context.strokeStyle = theme.accent;
    context.lineWidth = 1.8;
    context.lineJoin = "round";
    context.beginPath();
    counts.forEach(([step, count], i) => {
      const begin = Math.max(0, step - 0.5);
      const end = i + 1 < counts.length ? counts[i + 1][0] - 0.5 : this.horizon;
      context.lineTo(this.x(begin, canvas), y(count));
      context.lineTo(this.x(end, canvas), y(count));
    });
    context.stroke();
  }

  move(time) {
    const step = Math.round(time);
    for (const plot of this.plots) {
      plot.line.style.transform = `translateX(${this.x(time, plot.canvas)}px)`;
      if (plot.shown === step) continue;
      plot.shown = step;
      plot.now.textContent = `${countAt(plot.chart.counts, step)} at step ${step}`;
    }
  }
}

function countAt(counts, step) {
  let found = 0;
  for (const [from, count] of counts) {
    if (from > step) break;
    found = count;
  }
  return found;
}
