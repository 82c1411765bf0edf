/* Colours, marks and canvases that all pictures of the page share. */

/* Values of the style sheet's variables, read again when the theme changes. */
const theme = {};

function readTheme() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["ground", "paper", "ink", "soft", "line", "edge", "state", "accent", "on-accent", "good", "bad", "halo", "hatch", "shade", "witness", "tint"]) {
    theme[name] = style.getPropertyValue(`--${name}`).trim();
  }
  theme.font = getComputedStyle(document.body).fontFamily;
}

/* Dots that a finger needs, and whether it is fingers that point here. */
const TARGET = 44;

function touched() { return matchMedia("(pointer: coarse)").matches; }

/* Make a canvas as large as its place on the page, in the screen's own dots. */
function fitCanvas(canvas) {
  return sizeCanvas(canvas, Math.max(1, canvas.clientWidth), Math.max(1, canvas.clientHeight));
}

function sizeCanvas(canvas, width, height) {
  const ratio = Math.min(3, window.devicePixelRatio || 1);
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, width, height };
}

/* A colour between two, `share` of the way to the second. */
function mixed(one, other, share) {
  const part = (colour, i) => parseInt(colour.slice(i, i + 2), 16);
  const between = [1, 3, 5].map((i) => Math.round(part(one, i) * (1 - share) + part(other, i) * share));
  return `#${between.map((value) => value.toString(16).padStart(2, "0")).join("")}`;
}

/* How light a colour is, from 0 to 1 (the relative luminance of WCAG 2). */
function lightness(colour) {
  const parts = [1, 3, 5].map((i) => {
    const value = parseInt(colour.slice(i, i + 2), 16) / 255;
    return value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
}

/* Black or white, whichever is easier to read on a colour. */
function inkOn(colour) { return lightness(colour) > 0.196 ? "#10161e" : "#ffffff"; }

/* A class's colour on the present ground: dark ones are lifted from a dark ground. */
function lifted(colour) {
  const dark = lightness(theme.ground) < 0.2;
  return dark && lightness(colour) < 0.22 ? mixed(colour, "#ffffff", 0.35) : colour;
}

/* Add a class's mark to a path: classes differ by shape as well as by colour. */
const MARKS = [
  (c, x, y, r) => { c.moveTo(x + r, y); c.arc(x, y, r, 0, 2 * Math.PI); },
  (c, x, y, r) => { const a = r * 0.88; c.rect(x - a, y - a, 2 * a, 2 * a); },
  (c, x, y, r) => polygon(c, x, y, r * 1.22, 3, -Math.PI / 2),
  (c, x, y, r) => polygon(c, x, y, r * 1.2, 4, 0),
  (c, x, y, r) => polygon(c, x, y, r * 1.22, 3, Math.PI / 2),
  (c, x, y, r) => polygon(c, x, y, r * 1.1, 6, 0),
];

function polygon(context, x, y, radius, corners, turn) {
  for (let i = 0; i < corners; i += 1) {
    const angle = turn + (2 * Math.PI * i) / corners;
    const px = x + radius * Math.cos(angle);
    const py = y + radius * Math.sin(angle);
    if (i) context.lineTo(px, py);
    else context.moveTo(px, py);
  }
  context.closePath();
}

/* A canvas with the mark of a class, for lists. */
function swatch(kind) {
  const canvas = document.createElement("canvas");
  canvas.className = "swatch";
  canvas.width = 30;
  canvas.height = 30;
  canvas.setAttribute("aria-hidden", "true");
  const context = canvas.getContext("2d");
  context.beginPath();
  MARKS[kind.mark % MARKS.length](context, 15, 15, 11);
  context.fillStyle = kind.color;
  context.fill();
  return canvas;
}

/* Text with a halo, so that it can be read on anything. */
function haloText(context, words, x, y, colour) {
  context.lineWidth = 3;
  context.lineJoin = "round";
  context.strokeStyle = theme.halo;
  context.strokeText(words, x, y);
  context.fillStyle = colour;
  context.fillText(words, x, y);
}

/* Words cut to a width, with dots where something is missing; "" if hardly anything fits. */
function fitted(context, words, width) {
  if (context.measureText(words).width <= width) return words;
  let low = 0;
  let high = words.length;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (context.measureText(`${words.slice(0, middle)}\u2026`).width <= width) low = middle;
    else high = middle - 1;
  }
  return low < 2 ? "" : `${words.slice(0, low)}\u2026`;
}

/* Round distances for marks on an axis: 1, 2, 5, 10, ... so that about `most` fit. */
function tickStep(length, most, least = 1) {
  const rough = Math.max(least, length / Math.max(1, most));
  const power = 10 ** Math.floor(Math.log10(rough));
  const factor = [1, 2, 5, 10].find((f) => f * power >= rough);
  return Math.max(least, factor * power);
}

/* A number with as many digits as are worth reading. */
function numberWords(value) { return String(Number(value.toPrecision(5))); }

/* An element with a class and text; text is never read as markup. */
function element(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}
