// The map: turns gestures and keys into moves of the view and into events.

import {MapCanvas} from './canvas.js';

const MIN_SCALE = 0.002; // pixels per metre
const MAX_SCALE = 400;
const LEAST_EXTENT_M = 4;
const TURN_RAD = Math.PI / 12;
const TOUCH_PX = 22; // half of a touch target

/** `events`: tapped(point), grabbed(point) -> handle or null, dragged(handle, point), dropped(handle, point). */
export class MapView extends MapCanvas {
  constructor(canvas, events) {
    super(canvas);
    this.events = events;
    this.follows = true;
    this.isHeadingUp = false;
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

  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const fixed = this.toMap(px, py);
    this.scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, this.scale * factor));
    if (this.follows) return this.touch();
    const now = this.toMap(px, py);
    this.centre = {x: this.centre.x + fixed.x - now.x, y: this.centre.y + fixed.y - now.y};
    return this.touch();
  }

  turn(angle) {
    this.rotation = (this.rotation + angle) % (2 * Math.PI);
    this.touch();
  }

  /** Shows all points. */
  fit(points) {
    if (points.length === 0) return;
    const seen = points.map(point => this.toScreen(point));
    const xs = seen.map(point => point.x);
    const ys = seen.map(point => point.y);
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.centre = this.toMap((left + right) / 2, (top + bottom) / 2);
    const least = LEAST_EXTENT_M * this.scale;
    const factor = Math.min(this.width / Math.max(right - left, least), this.height / Math.max(bottom - top, least)) * 0.8;
    this.scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, this.scale * factor));
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
    if (!this.follows) this.centre = this.toMap(this.width / 2 - dx, this.height / 2 - dy);
    this.touch();
  }

  pinch(id, before, at) {
    const [, other] = [...this.pointers].find(([key]) => key !== id);
    const distance = point => Math.max(1, Math.hypot(point.x - other.x, point.y - other.y));
    const direction = point => Math.atan2(point.y - other.y, point.x - other.x);
    if (!this.isHeadingUp) this.turn(direction(before) - direction(at));
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
    else if (event.key === '<') this.turn(-TURN_RAD);
    else if (event.key === '>') this.turn(TURN_RAD);
    else if (event.key === 'Enter') this.events.tapped(this.toMap(this.width / 2, this.height / 2));
    else if (moves[event.key]) {
      this.follows = false;
      this.pan(...moves[event.key]);
    } else return;
    event.preventDefault();
  }
}
