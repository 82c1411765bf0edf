/* Which part of the map is seen: moving and zooming by pointer and by buttons. */

class Camera {
  constructor(canvas, bounds, changed) {
    this.canvas = canvas;
    this.bounds = bounds;
    this.changed = changed;
    this.whole = true; // follows the size of the canvas until the reader moves it
    this.pointers = new Map();
    this.dragged = 0;
    this.measure();
    this.fit();
    canvas.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener("pointerdown", (event) => this.onDown(event));
    canvas.addEventListener("pointermove", (event) => this.onMove(event));
    for (const name of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(name, (event) => this.onUp(event));
    }
  }

  x(x) { return (x - this.middleX) * this.scale + this.width / 2; }
  y(y) { return (this.middleY - y) * this.scale + this.height / 2; }

  /* The canvas's size; asked for only when it changes, because asking makes the browser lay out. */
  measure() {
    this.width = Math.max(1, this.canvas.clientWidth);
    this.height = Math.max(1, this.canvas.clientHeight);
  }

  fit() {
    const { left, right, bottom, top } = this.bounds;
    const margin = Math.min(60, 0.08 * Math.min(this.width, this.height) + 14);
    const fitting = (have, need) => (need > 0 ? (have - 2 * margin) / need : Infinity);
    const scale = Math.min(fitting(this.width, right - left), fitting(this.height, top - bottom));
    this.scale = Number.isFinite(scale) && scale > 0 ? scale : 1;
    this.least = this.scale / 3;
    this.most = this.scale * 60;
    this.middleX = (left + right) / 2;
    this.middleY = (bottom + top) / 2;
    this.whole = true;
    this.changed();
  }

  resized() {
    this.measure();
    if (this.whole) this.fit();
    else this.changed();
  }

  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const scale = Math.min(this.most, Math.max(this.least, this.scale * factor));
    const gain = 1 / this.scale - 1 / scale; // the map's point under (x, y) stays there
    this.middleX += (x - this.width / 2) * gain;
    this.middleY -= (y - this.height / 2) * gain;
    this.scale = scale;
    this.whole = false;
    this.changed();
  }

  pan(dx, dy) {
    this.middleX -= dx / this.scale;
    this.middleY += dy / this.scale;
    this.whole = false;
    this.changed();
  }

  onWheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    this.zoom(Math.exp(-event.deltaY * lines * 0.0018), event.offsetX, event.offsetY);
  }

  onDown(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    if (this.pointers.size === 1) this.dragged = 0;
  }

  onMove(event) {
    const former = this.pointers.get(event.pointerId);
    if (!former) return;
    const here = [event.offsetX, event.offsetY];
    if (this.pointers.size === 1) {
      this.dragged += Math.hypot(here[0] - former[0], here[1] - former[1]);
      if (this.dragged > 4) {
        this.canvas.classList.add("moving");
        this.pan(here[0] - former[0], here[1] - former[1]);
      }
    } else {
      this.pinch(event.pointerId, former, here);
    }
    this.pointers.set(event.pointerId, here);
  }

  pinch(moved, former, here) {
    const other = [...this.pointers].find(([id]) => id !== moved)[1];
    const before = Math.hypot(former[0] - other[0], former[1] - other[1]);
    const after = Math.hypot(here[0] - other[0], here[1] - other[1]);
    this.dragged = Infinity;
    if (before > 0 && after > 0) {
      this.zoom(after / before, (here[0] + other[0]) / 2, (here[1] + other[1]) / 2);
    }
  }

  onUp(event) {
    this.pointers.delete(event.pointerId);
    this.canvas.classList.remove("moving");
  }

  /* Whether the pointer that just went up was a click and not a drag. */
  get clicked() { return this.dragged <= 4; }
}
