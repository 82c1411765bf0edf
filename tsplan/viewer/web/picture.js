/* The page as a picture: title and step, the map or both, the classes and the timeline, as PNG. */

const EDGE = 14; // dots around it all
const HEADER = 46;

class Picture {
  constructor(page) { this.page = page; }

  /* A canvas with what the page shows now. */
  painted() {
    const { page } = this;
    const maps = page.maps.map((map) => map.canvas).filter((canvas) => canvas.clientWidth);
    const rows = [document.getElementById("axis-canvas"), document.getElementById("rows-canvas")];
    const width = Math.max(rows[0].clientWidth, maps.reduce((sum, map) => sum + map.clientWidth, 0));
    const tall = maps.reduce((most, map) => Math.max(most, map.clientHeight), 0);
    const legend = this.legendLines(width);
    const below = rows.reduce((sum, row) => sum + row.clientHeight, 0);
    const height = HEADER + tall + 20 * legend.length + 8 + below;
    const canvas = document.createElement("canvas");
    const { context } = sizeCanvas(canvas, width + 2 * EDGE, height + 2 * EDGE);
    context.fillStyle = theme.ground;
    context.fillRect(0, 0, width + 2 * EDGE, height + 2 * EDGE);
    context.translate(EDGE, EDGE);
    this.paintHeader(context, width);
    let left = 0;
    for (const map of maps) {
      context.drawImage(map, left, HEADER, map.clientWidth, map.clientHeight);
      if (maps.length > 1) this.paintCaption(context, map, left);
      left += map.clientWidth;
    }
    let top = HEADER + tall + 10;
    for (const line of legend) {
      this.paintLegend(context, line, top + 4);
      top += 20;
    }
    this.paintTimeline(context, rows, top + 8, width);
    return canvas;
  }

  paintHeader(context, width) {
    const { page } = this;
    context.textBaseline = "top";
    context.textAlign = "left";
    context.fillStyle = theme.ink;
    context.font = `600 17px ${theme.font}`;
    context.fillText(fitted(context, page.data.title, width - 140), 0, 0);
    context.textAlign = "right";
    context.fillText(page.clock.textContent, width, 0);
    context.textAlign = "left";
    context.font = `13px ${theme.font}`;
    context.fillStyle = theme.soft;
    context.fillText(fitted(context, page.data.outcome, width), 0, 23);
  }

  /* What each of two maps shows. */
  paintCaption(context, map, left) {
    context.font = `12.5px ${theme.font}`;
    context.textBaseline = "top";
    context.fillStyle = theme.soft;
    context.fillText(map.id === "map-canvas" ? "executed" : "planned", left + 4, HEADER + 4);
  }

  /* The classes in lines that fit. */
  legendLines(width) {
    const context = document.createElement("canvas").getContext("2d");
    context.font = `12.5px ${theme.font}`;
    const lines = [];
    let right = Infinity;
    for (const { kind, words } of this.page.legendEntries()) {
      const wide = context.measureText(words).width + 34;
      if (right + wide > width) {
        lines.push([]);
        right = 0;
      }
      lines[lines.length - 1].push({ kind, words, left: right });
      right += wide;
    }
    return lines;
  }

  paintLegend(context, line, top) {
    context.font = `12.5px ${theme.font}`;
    context.textBaseline = "middle";
    for (const { kind, words, left } of line) {
      if (kind) {
        context.beginPath();
        MARKS[kind.mark % MARKS.length](context, left + 8, top + 6, 6);
        context.fillStyle = kind.color;
        context.fill();
      }
      context.fillStyle = theme.ink;
      context.fillText(words, left + 19, top + 6.5);
    }
  }

  paintTimeline(context, rows, top, width) {
    context.fillStyle = theme.paper;
    context.fillRect(0, top, width, rows[0].clientHeight + rows[1].clientHeight);
    let y = top;
    for (const row of rows) {
      context.drawImage(row, 0, y, row.clientWidth, row.clientHeight);
      y += row.clientHeight;
    }
    const x = this.page.timeline.x(this.page.player.shown);
    context.fillStyle = theme.accent;
    context.fillRect(x - 0.75, top + 16, 1.5, y - top - 16);
  }

  get name() {
    const title = this.page.data.title.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "").slice(0, 40) || "plan";
    return `${title}-step-${Number(this.page.player.shown.toFixed(2))}.png`;
  }

  save() {
    const name = this.name;
    this.painted().toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
  }
}
