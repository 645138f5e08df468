// A canvas in metres: converts between map and screen, and draws lines, areas and symbols at places of the map.

const GRID_PX = 70; // least distance of grid lines

/** Map coordinates: metres east and north of the vehicle's first position. */
export class MapCanvas {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.scale = 8; // pixels per metre
    this.centre = {x: 0, y: 0};
    this.rotation = 0; // direction that is up [rad, clockwise from north]
  }

  resize() {
    const ratio = devicePixelRatio || 1;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.canvas.width = this.width * ratio;
    this.canvas.height = this.height * ratio;
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const style = getComputedStyle(this.canvas);
    this.colours = Object.fromEntries(['line', 'land', 'text', 'dim', 'accent', 'good', 'warn', 'bad', 'goal', 'plan', 'object', 'map'].map(name => [name, style.getPropertyValue('--' + name)]));
    this.isDirty = true;
  }

  toScreen({x, y}) {
    const [right, up] = turned(x - this.centre.x, y - this.centre.y, this.rotation);
    return {x: this.width / 2 + right * this.scale, y: this.height / 2 - up * this.scale};
  }

  toMap(px, py) {
    const [east, north] = turned((px - this.width / 2) / this.scale, (this.height / 2 - py) / this.scale, -this.rotation);
    return {x: this.centre.x + east, y: this.centre.y + north};
  }

  /** Least box of map coordinates around what is seen: left, right, bottom, top. */
  seen() {
    const corners = [[0, 0], [this.width, 0], [0, this.height], [this.width, this.height]].map(([px, py]) => this.toMap(px, py));
    const xs = corners.map(corner => corner.x);
    const ys = corners.map(corner => corner.y);
    return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  }

  clear() {
    this.context.fillStyle = this.colours.map;
    this.context.fillRect(0, 0, this.width, this.height);
  }

  /** Metric grid with a scale bar. */
  drawGrid() {
    const {context: c} = this;
    const step = roundLength(GRID_PX / this.scale);
    const [left, right, bottom, top] = this.seen();
    c.lineWidth = 1;
    c.strokeStyle = this.colours.line;
    c.beginPath();
    const sharp = pixel => (this.rotation === 0 ? Math.round(pixel) + 0.5 : pixel);
    const line = (from, to) => {
      const [a, b] = [this.toScreen(from), this.toScreen(to)];
      c.moveTo(sharp(a.x), sharp(a.y));
      c.lineTo(sharp(b.x), sharp(b.y));
    };
    for (let x = Math.ceil(left / step) * step; x <= right; x += step) line({x, y: bottom}, {x, y: top});
    for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) line({x: left, y}, {x: right, y});
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
    c.ellipse(x, y, Math.max(east * this.scale, minPx), Math.max(north * this.scale, minPx), -this.rotation, 0, 2 * Math.PI);
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
    const {context: c} = this;
    const corner = this.toScreen({x: at.x, y: at.y + height});
    c.save();
    c.translate(corner.x, corner.y);
    c.rotate(-this.rotation);
    c.imageSmoothingEnabled = false;
    c.drawImage(picture, 0, 0, width * this.scale, height * this.scale);
    c.restore();
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
      c.rotate(heading - this.rotation);
      [[0, -15], [10, 11], [0, 6], [-10, 11]].forEach(([px, py], i) => (i ? c.lineTo(px, py) : c.moveTo(px, py)));
      c.closePath();
    }
    c.fill();
    c.stroke();
    c.restore();
  }

  /** Draws a path in metres of the map. */
  shape(path, fill, stroke) {
    const {context: c} = this;
    c.save();
    c.translate(this.width / 2, this.height / 2);
    c.rotate(-this.rotation);
    c.scale(this.scale, -this.scale);
    c.translate(-this.centre.x, -this.centre.y);
    c.fillStyle = fill;
    c.fill(path, 'evenodd');
    c.strokeStyle = stroke;
    c.lineWidth = 1 / this.scale;
    c.stroke(path);
    c.restore();
  }
}

/** Components of a direction on axes turned clockwise by an angle [rad]. */
function turned(x, y, angle) {
  const sin = Math.sin(angle);
  const cos = Math.cos(angle);
  return [x * cos - y * sin, x * sin + y * cos];
}

/** The least of 1, 2 or 5 times a power of ten that is not less. */
function roundLength(metres) {
  const power = 10 ** Math.floor(Math.log10(metres));
  return [1, 2, 5, 10].map(each => each * power).find(each => each >= metres * 0.999);
}
