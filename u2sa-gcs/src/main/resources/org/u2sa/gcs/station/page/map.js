// The map: a canvas in metres, north up. Draws layers and turns gestures into events.

const MIN_SCALE = 0.002; // pixels per metre
const MAX_SCALE = 400;
const TOUCH_PX = 22; // half of a touch target
const GRID_PX = 70; // least distance of grid lines

/** `events`: tapped(point), grabbed(point) -> handle or null, dragged(handle, point), dropped(handle, point). */
export class MapView {
  constructor(canvas, events) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.events = events;
    this.scale = 8; // pixels per metre
    this.centre = {x: 0, y: 0};
    this.follows = true;
    this.pointers = new Map();
    this.handle = null;
    this.moved = 0;
    canvas.addEventListener('pointerdown', event => this.down(event));
    canvas.addEventListener('pointermove', event => this.move(event));
    for (const type of ['pointerup', 'pointercancel']) canvas.addEventListener(type, event => this.up(event, type === 'pointerup'));
    canvas.addEventListener('wheel', event => this.wheel(event), {passive: false});
    canvas.addEventListener('keydown', event => this.key(event));
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  resize() {
    const ratio = devicePixelRatio || 1;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.canvas.width = this.width * ratio;
    this.canvas.height = this.height * ratio;
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const style = getComputedStyle(this.canvas);
    this.colours = Object.fromEntries(['line', 'text', 'dim', 'accent', 'good', 'warn', 'bad', 'goal', 'plan', 'object', 'map'].map(name => [name, style.getPropertyValue('--' + name)]));
    this.isDirty = true;
  }

  toScreen({x, y}) {
    return {x: this.width / 2 + (x - this.centre.x) * this.scale, y: this.height / 2 - (y - this.centre.y) * this.scale};
  }

  toMap(px, py) {
    return {x: this.centre.x + (px - this.width / 2) / this.scale, y: this.centre.y - (py - this.height / 2) / this.scale};
  }

  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const fixed = this.toMap(px, py);
    this.scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, this.scale * factor));
    if (this.follows) return this.touch();
    const now = this.toMap(px, py);
    this.centre = {x: this.centre.x + fixed.x - now.x, y: this.centre.y + fixed.y - now.y};
    return this.touch();
  }

  /** Shows all points. */
  fit(points) {
    if (points.length === 0) return;
    const xs = points.map(point => point.x);
    const ys = points.map(point => point.y);
    const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.centre = {x: (left + right) / 2, y: (bottom + top) / 2};
    const scale = Math.min(this.width / Math.max(right - left, 4), this.height / Math.max(top - bottom, 4)) * 0.8;
    this.scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, scale));
    this.follows = false;
    this.touch();
  }

  touch() {
    this.isDirty = true;
  }

  /** Whether two points are within a touch target of each other. */
  isNear(a, b) {
    return Math.hypot(a.x - b.x, a.y - b.y) * this.scale < TOUCH_PX;
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    const at = {x: event.offsetX, y: event.offsetY};
    this.pointers.set(event.pointerId, at);
    this.moved = 0;
    this.handle = this.pointers.size === 1 ? this.events.grabbed(this.toMap(at.x, at.y)) : null;
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const at = {x: event.offsetX, y: event.offsetY};
    this.moved += Math.hypot(at.x - before.x, at.y - before.y);
    if (this.handle) {
      if (this.moved > 6) this.events.dragged(this.handle, this.toMap(at.x, at.y));
    } else if (this.pointers.size === 1) {
      this.pan(at.x - before.x, at.y - before.y);
    } else {
      this.pinch(event.pointerId, before, at);
    }
    this.pointers.set(event.pointerId, at);
    this.touch();
  }

  pan(dx, dy) {
    if (this.moved > 6) this.follows = false;
    if (!this.follows) this.centre = {x: this.centre.x - dx / this.scale, y: this.centre.y + dy / this.scale};
    this.touch();
  }

  pinch(id, before, at) {
    const [, other] = [...this.pointers].find(([key]) => key !== id);
    const distance = point => Math.max(1, Math.hypot(point.x - other.x, point.y - other.y));
    this.zoom(distance(at) / distance(before), (at.x + other.x) / 2, (at.y + other.y) / 2);
  }

  up(event, isDone) {
    if (!this.pointers.delete(event.pointerId)) return;
    const at = this.toMap(event.offsetX, event.offsetY);
    if (this.handle && this.moved > 6 && isDone) this.events.dropped(this.handle, at);
    else if (this.moved <= 6 && isDone) this.events.tapped(at);
    this.handle = null;
    this.touch();
  }

  wheel(event) {
    event.preventDefault();
    this.zoom(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
  }

  key(event) {
    const step = 60;
    const moves = {ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]};
    if (event.key === '+' || event.key === '=') this.zoom(1.25);
    else if (event.key === '-') this.zoom(0.8);
    else if (moves[event.key]) {
      this.follows = false;
      this.pan(...moves[event.key]);
    } else return;
    event.preventDefault();
  }

  clear() {
    this.context.fillStyle = this.colours.map;
    this.context.fillRect(0, 0, this.width, this.height);
  }

  /** Metric grid with a scale bar. */
  drawGrid() {
    const {context: c} = this;
    const step = roundLength(GRID_PX / this.scale);
    const from = this.toMap(0, this.height);
    const to = this.toMap(this.width, 0);
    c.lineWidth = 1;
    c.strokeStyle = this.colours.line;
    c.beginPath();
    for (let x = Math.ceil(from.x / step) * step; x <= to.x; x += step) {
      const px = Math.round(this.toScreen({x, y: 0}).x) + 0.5;
      c.moveTo(px, 0);
      c.lineTo(px, this.height);
    }
    for (let y = Math.ceil(from.y / step) * step; y <= to.y; y += step) {
      const py = Math.round(this.toScreen({x: 0, y}).y) + 0.5;
      c.moveTo(0, py);
      c.lineTo(this.width, py);
    }
    c.stroke();
    this.drawScaleBar(step);
  }

  drawScaleBar(step) {
    const {context: c} = this;
    const length = step * this.scale;
    c.strokeStyle = this.colours.text;
    c.lineWidth = 2;
    c.beginPath();
    c.moveTo(12, this.height - 16);
    c.lineTo(12, this.height - 12);
    c.lineTo(12 + length, this.height - 12);
    c.lineTo(12 + length, this.height - 16);
    c.stroke();
    this.label(step >= 1000 ? step / 1000 + ' km' : step + ' m', {x: 18, y: this.height - 18}, this.colours.text);
  }

  label(text, {x, y}, colour) {
    const {context: c} = this;
    c.font = '12px system-ui, sans-serif';
    c.lineWidth = 3;
    c.strokeStyle = this.colours.map;
    c.strokeText(text, x, y);
    c.fillStyle = colour;
    c.fillText(text, x, y);
  }

  line(points, colour, width, dash = []) {
    if (points.length < 2) return;
    const {context: c} = this;
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.lineJoin = 'round';
    c.setLineDash(dash);
    this.path(points);
    c.stroke();
    c.setLineDash([]);
  }

  path(points) {
    const {context: c} = this;
    c.beginPath();
    points.forEach((point, i) => {
      const {x, y} = this.toScreen(point);
      if (i === 0) c.moveTo(x, y);
      else c.lineTo(x, y);
    });
  }

  area(points, colour) {
    const {context: c} = this;
    this.path(points);
    c.closePath();
    c.strokeStyle = colour;
    c.lineWidth = 1.5;
    c.stroke();
    c.globalAlpha = 0.3;
    c.fillStyle = colour;
    c.fill();
    c.globalAlpha = 1;
  }

  /** Ellipse with half axes along east and north [m], at least some pixels. */
  ellipse(at, east, north, colour, {isFilled = false, minPx = 0, dash = []} = {}) {
    const {context: c} = this;
    const {x, y} = this.toScreen(at);
    c.beginPath();
    c.ellipse(x, y, Math.max(east * this.scale, minPx), Math.max(north * this.scale, minPx), 0, 0, 2 * Math.PI);
    c.strokeStyle = colour;
    c.lineWidth = 1.5;
    c.setLineDash(dash);
    c.stroke();
    c.setLineDash([]);
    if (isFilled) {
      c.globalAlpha = 0.3;
      c.fillStyle = colour;
      c.fill();
      c.globalAlpha = 1;
    }
  }

  /** Image whose lower left corner is at a place; `size` in metres. */
  image(picture, at, width, height) {
    const corner = this.toScreen({x: at.x, y: at.y + height});
    this.context.imageSmoothingEnabled = false;
    this.context.drawImage(picture, corner.x, corner.y, width * this.scale, height * this.scale);
  }

  arrow(at, heading, colour) {
    const {context: c} = this;
    const {x, y} = this.toScreen(at);
    c.save();
    c.translate(x, y);
    c.fillStyle = colour;
    c.strokeStyle = this.colours.map;
    c.lineWidth = 2;
    c.beginPath();
    if (heading === undefined) {
      c.arc(0, 0, 7, 0, 2 * Math.PI);
    } else {
      c.rotate(heading);
      [[0, -15], [10, 11], [0, 6], [-10, 11]].forEach(([px, py], i) => (i ? c.lineTo(px, py) : c.moveTo(px, py)));
      c.closePath();
    }
    c.fill();
    c.stroke();
    c.restore();
  }
}

/** The least of 1, 2 or 5 times a power of ten that is not less. */
function roundLength(metres) {
  const power = 10 ** Math.floor(Math.log10(metres));
  return [1, 2, 5, 10].map(each => each * power).find(each => each >= metres * 0.999);
}
