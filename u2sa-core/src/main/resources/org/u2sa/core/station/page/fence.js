// The fence: drawn on the map, edited as a draft, uploaded to the Safety Manager, which checks it.

import {byId, element, setText} from './dom.js';
import {numberText, pointsOf} from './goals.js';
import {drawHandles, handleAt, withHandle} from './outline.js';
import {texts} from './texts.js';
import {escapeXml, readXml} from './xml.js';

const LIMITS = ['floor', 'ceiling'];
const KINDS = ['keepIn', 'keepOut'];
const UNDO_STEPS = 50;
const MAX_AREAS = 64;
const MAX_RALLY_POINTS = 100; // as the vehicle's
const MAX_CORNERS = 1000;

/** A fence's XML as {frame, floor, ceiling, areas: [{kind, corners} or {kind, circle, source}], rally: [{at, source}]}. */
export function readFence(text) {
  const fence = {frame: 'GLOBAL', floor: '', ceiling: '', areas: [], rally: []};
  for (const child of readXml(text).children) {
    if (child.name === 'reference') fence.frame = child.text.toUpperCase().replace(/[\s-]+/g, '_');
    else if (LIMITS.includes(child.name)) fence[child.name] = [child.text, child.attributes.unit].filter(Boolean).join(' ');
    else if (KINDS.includes(child.name) && fence.areas.length < MAX_AREAS) fence.areas.push(areaOf(child));
    else if (child.name === 'rally' && fence.rally.length < MAX_RALLY_POINTS) fence.rally.push({at: pointOf(child), source: child.source});
  }
  return fence;
}

const numberOf = (parent, name) => Number((parent.children.find(each => each.name === name) || {text: 'NaN'}).text);
const pointOf = parent => [numberOf(parent, 'x'), numberOf(parent, 'y')];

function areaOf(element) {
  const centre = element.children.find(each => each.name === 'centre');
  if (centre) return {kind: element.name, corners: '', circle: {at: pointOf(centre), radius: numberOf(element, 'radius')}, source: element.source};
  const corners = element.children.filter(each => each.name === 'corner').slice(0, MAX_CORNERS).map(pointOf);
  return {kind: element.name, corners: corners.map(each => each.map(numberText).join(' ')).join('; ')};
}

function fenceXml({frame, areas, rally, ...limits}) {
  const lines = [`  <reference>${escapeXml(frame)}</reference>`];
  for (const name of LIMITS.filter(each => limits[each].trim())) {
    const [number, ...unit] = limits[name].trim().split(/\s+/);
    lines.push(`  <${name}${unit.length > 0 ? ` unit="${escapeXml(unit.join(' '))}"` : ''}>${escapeXml(number)}</${name}>`);
  }
  for (const {kind, corners, source} of areas) {
    if (source) lines.push('  ' + source);
    else lines.push(`  <${kind}>`, ...pointsOf(corners).map(([x, y]) => `    <corner><x>${numberText(x)}</x><y>${numberText(y)}</y></corner>`), `  </${kind}>`);
  }
  return ['<fence>', ...lines, ...rally.map(each => '  ' + each.source), '</fence>', ''].join('\n');
}

/** `parts`: link, orders, selected(), order(promise), confirm(question), isNear(a, b). */
export class FenceEditor {
  constructor(parts) {
    Object.assign(this, parts);
    this.discard();
    this.built = '';
    const on = (id, action) => { byId(id).onclick = () => this.selected() && action(this.selected()); };
    for (const kind of KINDS) on('fence-' + kind, vehicle => this.edit(vehicle, fence => { this.area = fence.areas.push({kind, corners: ''}) - 1; }));
    on('fence-undo', vehicle => { this.draft = this.history.pop() || null; this.show(vehicle); });
    on('fence-discard', vehicle => { this.discard(); this.show(vehicle); });
    on('fence-upload', vehicle => this.order(this.upload(vehicle)));
    on('fence-remove', async vehicle => {
      if (await this.confirm(texts.askNoFence(vehicle.id))) this.order(this.ask(vehicle, 'REMOVE', {}));
    });
  }

  discard() {
    this.draft = null;
    this.history = [];
    this.area = null; // index of the one that is drawn
  }

  get isOpen() {
    return byId('fence').open && !byId('mission').hidden;
  }

  /** The fence as edited, or else as the vehicle has it; null without one. */
  fence(vehicle) {
    return this.draft || vehicle.fence;
  }

  edit(vehicle, change) {
    const fence = this.fence(vehicle) || {frame: vehicle.place.origin ? vehicle.place.origin.frame : 'GLOBAL', floor: '', ceiling: '', areas: [], rally: []};
    this.history.push(this.draft);
    if (this.history.length > UNDO_STEPS) this.history.splice(1, 1);
    this.draft = structuredClone(fence);
    change(this.draft);
    this.show(vehicle);
  }

  async ask(vehicle, action, fields) {
    const result = await this.orders.ask(vehicle, 'fence-orders', 'FenceOrder', {action, operator: this.orders.operator, ...fields});
    if (!result.accepted) throw new Error(result.outcome);
    this.discard();
    return result.outcome;
  }

  upload(vehicle) {
    return this.ask(vehicle, 'REPLACE', {fence: fenceXml(this.draft), file: 'web page'});
  }

  /** Corners of an area on the map. */
  outline(vehicle, {corners}) {
    const {frame} = this.fence(vehicle);
    return pointsOf(corners).map(([x, y]) => vehicle.place.of(frame, x, y)).filter(Boolean);
  }

  setOutline(vehicle, index, points) {
    const text = points.map(point => vehicle.place.inFrame(point)).map(({x, y}) => `${numberText(x)} ${numberText(y)}`).join('; ');
    this.edit(vehicle, fence => { fence.areas[index].corners = text; });
  }

  canDraw(vehicle) {
    return this.isOpen && vehicle.place.origin && this.fence(vehicle) && this.fence(vehicle).frame === vehicle.place.origin.frame;
  }

  /** Whether a tap was a corner of the area that is drawn. */
  tapped(vehicle, at) {
    if (this.area === null || !this.canDraw(vehicle) || !this.draft) return false;
    this.setOutline(vehicle, this.area, [...this.outline(vehicle, this.draft.areas[this.area]), at]);
    return true;
  }

  grabbed(vehicle, at) {
    if (!this.canDraw(vehicle)) return null;
    for (const [index, area] of this.fence(vehicle).areas.entries()) {
      const handle = handleAt(this.outline(vehicle, area), at, this.isNear);
      if (handle) return {...handle, area: index, isFence: true};
    }
    return null;
  }

  dropped(vehicle, handle, at) {
    this.setOutline(vehicle, handle.area, withHandle(this.outline(vehicle, this.fence(vehicle).areas[handle.area]), handle, at));
  }

  draw(map, vehicle, dragging) {
    const fence = this.fence(vehicle);
    if (!fence) return;
    fence.areas.forEach((area, index) => {
      const colour = this.draft ? map.colours.warn : area.kind === 'keepIn' ? map.colours.good : map.colours.bad;
      const isDragged = dragging && dragging.isFence && dragging.area === index;
      const outline = isDragged ? withHandle(this.outline(vehicle, area), dragging, dragging.now) : this.outline(vehicle, area);
      if (area.circle) drawCircle(map, vehicle.place, fence.frame, area.circle, colour);
      else if (area.kind === 'keepIn') map.line([...outline, ...outline.slice(0, 1)], colour, 2, [10, 5]);
      else map.area(outline, colour);
      if (this.canDraw(vehicle)) drawHandles(map, outline, colour, null);
    });
    const points = fence.rally.map(({at: [x, y]}) => vehicle.place.of(fence.frame, x, y)).filter(Boolean);
    for (const point of points) map.ellipse(point, 0, 0, map.colours.good, {minPx: 8});
  }

  show(vehicle) {
    const fence = this.fence(vehicle);
    byId('fence-undo').disabled = byId('fence-discard').disabled = !this.draft;
    byId('fence-upload').disabled = !this.draft || !this.link.isUp;
    byId('fence-remove').disabled = !vehicle.fence || !this.link.isUp;
    setText(byId('fence-state'), this.draft ? texts.fenceDraft : vehicle.fence ? texts.fenceOf(vehicle.fence.file, vehicle.fence.margin) : texts.noFence);
    const built = JSON.stringify(fence);
    if (built === this.built || byId('fence-areas').contains(document.activeElement) && document.activeElement.tagName !== 'BUTTON') return;
    this.built = built;
    byId('fence-areas').replaceChildren(...(fence ? this.rows(vehicle, fence) : []));
  }

  rows(vehicle, fence) {
    const limits = LIMITS.map(name => this.row(name, texts.fence[name], element('input', '', {value: fence[name], autocomplete: 'off'}), vehicle, value => draft => { draft[name] = value; }));
    const areas = fence.areas.map((area, index) => {
      const name = `${texts.fence[area.kind]} ${index + 1}`;
      const input = element('textarea', '', {rows: 2, spellcheck: false, value: area.circle ? texts.circle(area.circle.radius) : area.corners, disabled: Boolean(area.circle)});
      const line = this.row('area-' + index, name, input, vehicle, value => draft => { draft.areas[index].corners = value; });
      line.classList.add('long');
      line.append(element('button', texts.remove(name), {type: 'button', onclick: () => { this.area = null; this.edit(vehicle, draft => draft.areas.splice(index, 1)); }}));
      return line;
    });
    return [...limits, ...areas];
  }

  row(id, name, input, vehicle, edit) {
    const line = element('div', '', {className: 'variable'});
    input.id = 'fence-field-' + id;
    input.onchange = () => this.edit(vehicle, edit(input.value));
    line.append(element('label', name, {htmlFor: input.id}), input);
    return line;
  }
}

function drawCircle(map, place, frame, {at, radius}, colour) {
  const centre = place.of(frame, at[0], at[1]);
  if (centre && Number.isFinite(radius)) map.ellipse(centre, radius, radius, colour, {isFilled: true});
}
