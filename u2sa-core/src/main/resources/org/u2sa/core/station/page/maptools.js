// What the map shows and how: layers, following, turning, measuring.

import {byId, element} from './dom.js';
import {texts} from './texts.js';

const DEG = 180 / Math.PI;

/** `parts`: map, selected(), extent(). */
export class MapTools {
  constructor(parts) {
    Object.assign(this, parts);
    this.layers = Object.fromEntries(Object.keys(texts.layers).map(name => [name, true]));
    this.measured = null; // places, while measuring
    byId('layers').append(...Object.entries(texts.layers).map(([name, text]) => this.box(name, text)));
    byId('zoom-in').onclick = () => this.map.zoom(1.5);
    byId('zoom-out').onclick = () => this.map.zoom(1 / 1.5);
    byId('fit').onclick = () => this.map.fit(this.extent());
    byId('follow').onclick = () => this.change(() => { this.map.follows = !this.map.follows; });
    byId('heading-up').onclick = () => this.change(() => {
      this.map.isHeadingUp = !this.map.isHeadingUp;
      this.map.rotation = 0;
    });
    byId('measure').onclick = () => this.change(() => { this.measured = this.measured ? null : []; });
  }

  box(name, text) {
    const label = element('label', '', {className: 'check'});
    const box = element('input', '', {type: 'checkbox', checked: true, id: 'layer-' + name});
    box.onchange = () => this.change(() => { this.layers[name] = box.checked; });
    label.append(box, text);
    return label;
  }

  change(edit) {
    edit();
    this.show();
    this.map.touch();
  }

  show() {
    byId('follow').setAttribute('aria-pressed', this.map.follows);
    byId('heading-up').setAttribute('aria-pressed', this.map.isHeadingUp);
    byId('measure').setAttribute('aria-pressed', this.measured !== null);
  }

  /** Whether a tap was meant for the measure. */
  tapped(at) {
    if (this.measured) this.measured.push(at);
    return this.measured !== null;
  }

  /** Keeps the vehicle in the middle, and its heading up, if so chosen. */
  follow(pose) {
    const {map} = this;
    if (map.follows) map.centre = {x: pose.x, y: pose.y};
    if (map.isHeadingUp && pose.heading !== undefined) map.rotation = pose.heading;
  }

  draw() {
    const {map} = this;
    if (map.rotation !== 0) this.drawNorth();
    if (!this.measured) return;
    map.line(this.measured, map.colours.warn, 2, [8, 4]);
    let sum = 0;
    this.measured.forEach((at, i) => {
      const before = this.measured[i - 1];
      map.ellipse(at, 0, 0, map.colours.warn, {minPx: 4, isFilled: true});
      if (!before) return;
      const length = Math.hypot(at.x - before.x, at.y - before.y);
      sum += length;
      const bearing = (Math.atan2(at.x - before.x, at.y - before.y) * DEG + 360) % 360;
      const {x, y} = map.toScreen(at);
      map.label(texts.measured(length, bearing, i > 1 ? sum : undefined), {x: x + 10, y: y - 8}, map.colours.warn);
    });
  }

  drawNorth() {
    const {map} = this;
    const at = map.toMap(map.width - 34, 34);
    map.arrow(at, 0, map.colours.text);
    map.label('N', {x: map.width - 20, y: 28}, map.colours.text);
  }
}
