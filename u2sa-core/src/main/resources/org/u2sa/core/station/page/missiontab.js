// The tab Mission: the list of goals, the form of the chosen one, and files on the operator's device.

import {buttonRow, byId, element, fill, setText} from './dom.js';
import {GoalForm} from './goalform.js';
import {readMission} from './goals.js';
import {wholeMission} from './missionlinks.js';
import {drawHandles, handleAt, withHandle} from './outline.js';
import {distance, texts} from './texts.js';

const LONGEST_FILE = 60000; // an order's text is 64 KiB at most

/** `parts`: link, orders, editor, selected(), order(promise), tell(text, isBad), confirm(question), isNear(a, b), askMission(vehicle). */
export class MissionTab {
  constructor(parts) {
    Object.assign(this, parts);
    this.form = new GoalForm(byId('goal-fields'), {editor: this.editor, changed: edit => this.edit(edit)});
    const on = (id, action) => { byId(id).onclick = () => this.selected() && action(this.selected()); };
    on('add', vehicle => this.add(vehicle));
    on('remove', vehicle => this.remove(vehicle));
    on('earlier', vehicle => this.reorder(vehicle, -1));
    on('later', vehicle => this.reorder(vehicle, 1));
    on('undo', () => this.edit(() => this.editor.undo()));
    on('discard', () => this.edit(() => this.editor.discard()));
    on('goto', vehicle => this.order(this.orders.mission(vehicle, 'GOTO', {uid: this.editor.selected})));
    on('upload', vehicle => this.upload(vehicle));
    on('open', () => byId('file').click());
    on('save', vehicle => this.save(vehicle));
    byId('file').onchange = event => this.open(event.target);
  }

  edit(change) {
    change();
    if (this.selected()) this.show(this.selected());
  }

  get isOpen() {
    return !byId('mission').hidden;
  }

  chosen(vehicle) {
    return this.editor.route(vehicle).find(item => item.isSelected);
  }

  /** Classes without a place of their own are added at once; the others where the map is tapped. */
  add(vehicle) {
    const type = byId('goal-class').value || 'Waypoint';
    const variables = (vehicle.goalClasses.get(type) || {variables: []}).variables;
    const isPlaced = variables.some(each => each.name === 'x' || each.variableType === 'points') || variables.length === 0;
    if (isPlaced) this.editor.isAdding = !this.editor.isAdding;
    else this.editor.add(vehicle, type, null);
    this.isDrawing = false;
    this.show(vehicle);
  }

  /** A tap on the map while goals are added. */
  tapped(vehicle, at) {
    const item = this.chosen(vehicle);
    if (this.isDrawing && item && item.outlineField) return this.editor.outline(vehicle, item, [...item.outline, at]);
    const type = byId('goal-class').value || 'Waypoint';
    const variables = (vehicle.goalClasses.get(type) || {variables: []}).variables;
    this.isDrawing = variables.some(each => each.variableType === 'points');
    this.editor.add(vehicle, type, this.isDrawing ? null : at);
    if (this.isDrawing) this.editor.outline(vehicle, this.chosen(vehicle), [at]);
    return undefined;
  }

  remove(vehicle) {
    const item = this.chosen(vehicle);
    if (item && this.editor.corner !== null && item.outline.length > 3) {
      this.editor.outline(vehicle, item, item.outline.filter((corner, i) => i !== this.editor.corner));
      this.editor.corner = null;
      return this.show(vehicle);
    }
    const refusal = this.editor.refusalToRemove(vehicle);
    if (refusal) return this.tell(refusal, true);
    return this.edit(() => this.editor.remove());
  }

  reorder(vehicle, step) {
    const refusal = this.editor.reorder(vehicle, step);
    if (refusal) this.tell(refusal, true);
    this.show(vehicle);
  }

  async upload(vehicle) {
    const {whole} = this.editor.draft;
    if (whole && !await this.confirm(texts.askReplace(vehicle.id, whole.file))) return;
    this.order(this.editor.upload(vehicle).finally(() => {
      this.askMission(vehicle);
      this.show(vehicle);
      this.form.focusRefused();
    }));
  }

  async open(input) {
    const [file] = input.files;
    const vehicle = this.selected();
    input.value = ''; // so that the same file can be opened again
    if (!file || !vehicle) return;
    try {
      if (file.size > LONGEST_FILE) throw new Error(texts.tooLong(file.name));
      const text = await file.text();
      this.editor.open({file: file.name, text, ...readMission(file.name, text, vehicle.goalClasses)});
      this.tell(texts.opened(file.name));
      this.fitted();
    } catch (error) {
      this.tell(error.message, true);
    }
    this.show(vehicle);
  }

  save(vehicle) {
    if (!this.editor.draft.whole && this.editor.route(vehicle).some(item => !item.known)) return this.tell(texts.unknownClass, true);
    if (vehicle.report.failsafe && !this.editor.draft.whole) return this.tell(texts.inFailsafe, true);
    const {whole} = this.editor.draft;
    const address = URL.createObjectURL(new Blob([wholeMission(this.editor, vehicle).text], {type: 'application/xml'}));
    const name = whole ? whole.file : (vehicle.report.mission || 'mission').split(/[\\/]/).pop().replace(/[^\w.-]/g, '_').replace(/(\.xml)?$/, '.xml');
    element('a', '', {href: address, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
    return this.tell(texts.saved(name));
  }

  show(vehicle) {
    const {editor} = this;
    const route = editor.route(vehicle);
    const item = route.find(each => each.isSelected);
    for (const id of ['undo', 'discard', 'upload']) byId(id).disabled = !editor.isChanged || (id === 'upload' && !this.link.isUp);
    byId('goto').disabled = !this.link.isUp || !item || !item.base;
    for (const id of ['remove', 'earlier', 'later']) byId(id).disabled = !item;
    byId('save').disabled = route.length === 0;
    byId('add').setAttribute('aria-pressed', editor.isAdding);
    setText(byId('add'), editor.isAdding ? (this.isDrawing ? texts.drawing : texts.adding) : texts.add);
    const classes = [...vehicle.goalClasses.keys()];
    if (byId('goal-class').options.length !== classes.length) {
      fill(byId('goal-class'), classes, name => element('option', name, {value: name}));
      byId('goal-class').value = classes.includes('Waypoint') ? 'Waypoint' : classes[0];
    }
    setText(byId('draft'), editor.draft.whole ? texts.wholeDraft(editor.draft.whole.file) : '');
    fill(byId('goals').tBodies[0], route, each => this.row(vehicle, each));
    byId('goal-list').classList.toggle('short', Boolean(item));
    setText(byId('goal-title'), item ? `${item.uid}: ${item.type}` : '');
    this.form.show(item);
  }

  row(vehicle, item) {
    const {pose} = vehicle.place;
    const apart = item.anchor && pose ? distance(Math.hypot(item.anchor.x - pose.x, item.anchor.y - pose.y)) : '';
    const isRefused = this.editor.refusal && this.editor.refusal.uid === item.uid;
    const result = ((item.base && item.base.result) || 'open').toLowerCase().replace('_', ' ');
    const state = isRefused ? texts.states.refused : item.isRemoved ? texts.states.removed : item.isChanged ? texts.states.changed : item.isCurrent ? texts.states.current : item.isOnTheWay || item.isDone ? result : texts.states.aside;
    const line = {cells: [item.uid, item.type, state, apart], state: isRefused ? 'bad' : item.isChanged ? 'warn' : item.isCurrent ? 'good' : ''};
    return buttonRow(line, item.isSelected, () => this.edit(() => {
      this.editor.selected = item.isSelected ? null : item.uid;
      this.editor.corner = null;
    }));
  }

  /** What can be dragged at a place: a corner of the chosen area, or a goal. */
  grabbed(vehicle, at) {
    const item = this.chosen(vehicle);
    const corner = item && item.outline.length > 0 ? handleAt(item.outline, at, this.isNear) : null;
    if (corner) return {...corner, item, isCorner: true};
    const hit = this.editor.route(vehicle).find(each => each.at && this.isNear(each.at, at));
    return hit ? {item: hit, at: hit.at} : null;
  }

  dropped(vehicle, handle, at) {
    this.editor.selected = handle.item.uid;
    if (handle.isCorner) this.editor.outline(vehicle, handle.item, withHandle(handle.item.outline, handle, at));
    else this.editor.move(vehicle, handle.item, at);
  }

  /** Chooses the goal, corner or area at a place. */
  choose(vehicle, at) {
    const route = this.editor.route(vehicle);
    const item = route.find(each => each.isSelected);
    const corner = item ? item.outline.findIndex(each => this.isNear(each, at)) : -1;
    this.editor.corner = corner >= 0 ? corner : null;
    if (corner >= 0) return;
    const hit = route.find(each => each.at && this.isNear(each.at, at)) || route.find(each => each.outline.some(one => this.isNear(one, at)));
    this.editor.selected = hit ? hit.uid : null;
  }

  /** The route with what is being dragged, and handles of the chosen area. */
  draw(map, route, dragging) {
    const item = route.find(each => each.isSelected);
    if (dragging) {
      const moving = route.find(each => each.uid === dragging.item.uid);
      if (moving && dragging.isCorner) moving.outline = withHandle(moving.outline, dragging, dragging.now);
      else if (moving) moving.at = moving.anchor = dragging.now;
    }
    return () => this.isOpen && item && drawHandles(map, item.outline, item.isChanged ? map.colours.warn : map.colours.goal, this.editor.corner);
  }
}
