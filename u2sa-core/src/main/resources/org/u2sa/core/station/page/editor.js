// Edits of a mission: a draft on the map until the vehicle has accepted it.

import {MissionXml, numberText, pointsOf, textOf} from './goals.js';
import {isPlain, relinked, wholeMission} from './missionlinks.js';
import {texts} from './texts.js';

const UNDO_STEPS = 50;

// changed: texts by UID and field; added: goals with `after`; order: UIDs if goals were moved; whole: a mission of its own.
const emptyDraft = () => ({changed: {}, added: [], removed: [], order: null, whole: null});

/** Draft of one vehicle's mission: changes of the running one, or a whole new one. */
export class MissionEditor {
  constructor(orders) {
    this.orders = orders;
    this.isAdding = false;
    this.selected = null;
    this.corner = null; // index in the chosen goal's outline
    this.discard();
  }

  discard() {
    this.draft = emptyDraft();
    this.history = [];
    this.refusal = null; // {uid, field, text}: what the vehicle said of the last upload
  }

  get isChanged() {
    return this.history.length > 0;
  }

  /** @param what changes of the same are undone in one step */
  change(edit, what = null) {
    if (what === null || what !== this.lastChange) this.history.push(structuredClone(this.draft));
    this.lastChange = what;
    if (this.history.length > UNDO_STEPS) this.history.splice(1, 1); // the first is the vehicle's
    if (this.draft.whole) this.draft.whole.text = null;
    edit(this.draft);
  }

  undo() {
    this.lastChange = null;
    if (this.isChanged) this.draft = this.history.pop();
  }

  /** Begins with a mission of its own, which replaces the vehicle's when it is uploaded. */
  open(mission) {
    this.change(draft => Object.assign(draft, emptyDraft(), {whole: mission}));
    this.selected = null;
  }

  /** The goals with their followers as they will be once the draft is uploaded. */
  route(vehicle) {
    const {draft} = this;
    const {report} = vehicle;
    if (!draft.whole && !report) return [];
    const known = new Map(draft.whole ? [] : report.goals.map(goal => [goal.uid, goal]));
    const own = new Map((draft.whole ? draft.whole.goals : draft.added).map(goal => [goal.uid, goal]));
    const order = draft.whole ? [...own.keys()] : this.order(report, known);
    const items = new Map();
    for (const uid of new Set([...order, ...known.keys()])) {
      items.set(uid, this.item(vehicle, uid, known.get(uid), own.get(uid)));
    }
    for (const item of items.values()) {
      item.followers = this.followers(item, items, order).map(uid => items.get(uid)).filter(Boolean);
    }
    return onTheWay([...items.values()]);
  }

  item(vehicle, uid, base, own) {
    const fields = own ? own.fields : this.draft.changed[uid] || {};
    const type = own ? own.type : base.type ? base.type[base.type.length - 1] : 'Waypoint';
    const known = vehicle.goalClasses.get(type);
    const text = name => (fields[name] !== undefined ? fields[name] : base ? textOf(base[name]) : '');
    const number = name => (fields[name] !== undefined ? parseFloat(fields[name]) : base ? base[name] : undefined);
    const frame = text('referenceFrame') || 'GLOBAL';
    const [x, y] = [number('x'), number('y')];
    const outlineField = ((known ? known.variables : []).find(each => each.variableType === 'points') || {}).name;
    const points = outlineField ? pointsOf(text(outlineField)) : [];
    const isRemoved = this.draft.removed.includes(uid);
    const at = Number.isFinite(x) && Number.isFinite(y) ? vehicle.place.of(frame, x, y) || null : null;
    const outline = points.map(([px, py]) => vehicle.place.of(frame, px, py)).filter(Boolean);
    return {
      uid, type, known, base, own, text, frame, outlineField, points, isRemoved, at, outline,
      anchor: at || middle(outline), // ends of links
      radius: number('horizontalThreshold') || 0,
      isCurrent: Boolean(base && vehicle.report.current.includes(uid)),
      isDone: Boolean(base && base.result),
      isChanged: !base || isRemoved || uid in this.draft.changed,
      isSelected: uid === this.selected,
      followers: [],
    };
  }

  /** UIDs in the mission's order: goals that were inserted stand behind the goal that leads to them. */
  order(report, known) {
    const order = report.sequence.filter(uid => known.has(uid));
    let left = [...known.keys()].filter(uid => !order.includes(uid));
    for (let before = Infinity; left.length < before;) {
      before = left.length;
      left = left.filter(uid => {
        const leader = order.findIndex(each => known.get(each).next.includes(uid));
        if (leader >= 0) order.splice(leader + 1, 0, uid);
        return leader < 0;
      });
    }
    for (const goal of this.draft.added) order.splice(order.indexOf(goal.after) + 1, 0, goal.uid);
    return order;
  }

  /** What follows a goal, past goals that are to be removed. */
  followers({uid, base, own, isRemoved, text}, items, order) {
    if (isRemoved) return [];
    const wanted = this.draft.order || [];
    const isLoose = wanted.includes(uid) || !this.draft.whole && this.draft.added.some(each => each.after === uid || each.uid === uid);
    const named = isLoose ? [] : text('next').split(',').map(each => each.trim()).filter(Boolean);
    const ended = !isLoose && base && Array.isArray(base.nextIfDone) ? base.nextIfDone : null;
    const isLinked = this.draft.whole && this.draft.whole.goals.some(goal => goal.fields.next);
    const places = wanted.includes(uid) ? wanted : order;
    const inOrder = places.includes(uid) && !(own && isLinked) ? [places[places.indexOf(uid) + 1]] : [];
    const next = ended || (named.length > 0 ? named : inOrder);
    return next.filter(each => items.has(each)).flatMap(each => {
      const item = items.get(each);
      return item.isRemoved ? this.followers({...item, isRemoved: false}, items, order) : each;
    });
  }

  /** Sets a field of a goal; empty leaves it out. */
  set(item, field, text) {
    this.refusal = null;
    this.change(draft => {
      const own = (draft.whole ? draft.whole.goals : draft.added).find(each => each.uid === item.uid);
      const fields = own ? own.fields : draft.changed[item.uid] = draft.changed[item.uid] || {};
      if (own && !text.trim()) delete fields[field];
      else fields[field] = text;
    }, `${item.uid} ${field}`);
  }

  /** Another name for a goal that the vehicle does not have. */
  rename(item, name) {
    this.change(draft => {
      const goals = draft.whole ? draft.whole.goals : draft.added;
      goals.find(each => each.uid === item.uid).uid = name;
      for (const goal of goals) if (goal.after === item.uid) goal.after = name;
      if (draft.order) draft.order = draft.order.map(uid => (uid === item.uid ? name : uid));
    });
    this.selected = name;
  }

  /** Adds a goal of a class behind the chosen one; `at`: a place of the map, or null. */
  add(vehicle, type, at) {
    const route = this.route(vehicle).filter(item => item.uid !== 'home' && !item.isRemoved);
    const after = route.find(item => item.uid === this.selected) || route.find(item => item.isCurrent) || route[route.length - 1];
    const names = new Set(this.route(vehicle).map(item => item.uid));
    let number = 1;
    while (names.has(type.charAt(0).toLowerCase() + number)) number++;
    const added = {uid: type.charAt(0).toLowerCase() + number, type, fields: {}, links: [], after: after ? after.uid : ''};
    const variables = (vehicle.goalClasses.get(type) || {variables: []}).variables.map(each => each.name);
    const alike = after && after.known ? ['referenceFrame', 'z', 'verticalThreshold', 'horizontalThreshold', 'speed'] : [];
    for (const name of alike) if (variables.includes(name) && after.text(name)) added.fields[name] = after.text(name);
    if (variables.includes('horizontalThreshold') && !added.fields.horizontalThreshold) added.fields.horizontalThreshold = '2';
    if (at) Object.assign(added.fields, this.placed(vehicle, at));
    this.change(draft => {
      if (draft.whole) draft.whole.goals.splice(draft.whole.goals.findIndex(each => each.uid === added.after) + 1, 0, added);
      else draft.added.push(added);
      if (draft.order) draft.order.splice(draft.order.indexOf(added.after) + 1, 0, added.uid);
    });
    this.selected = added.uid;
  }

  placed(vehicle, at) {
    const {frame, x, y} = vehicle.place.inFrame(at);
    return {referenceFrame: frame, x: numberText(x), y: numberText(y)};
  }

  /** Moves a goal to a place of the map; its other fields stay. */
  move(vehicle, item, at) {
    const {x, y} = this.placed(vehicle, at);
    this.lastChange = null;
    this.set(item, 'x', x);
    const before = this.history.length;
    this.set(item, 'y', y);
    this.history.length = before; // one step
  }

  /** Sets the corners of a goal's outline, given on the map. */
  outline(vehicle, item, corners) {
    const heights = item.points.map(point => point[2]);
    const text = corners.map((corner, i) => {
      const {x, y} = vehicle.place.inFrame(corner);
      return [x, y, ...(heights[i] === undefined ? [] : [heights[i]])].map(numberText).join(' ');
    }).join('; ');
    if (!item.text('referenceFrame')) this.set(item, 'referenceFrame', vehicle.place.origin.frame);
    this.set(item, item.outlineField, text);
    this.lastChange = null;
  }

  /** Exchanges the chosen goal with the one before (-1) or after (1); returns why it cannot. */
  reorder(vehicle, step) {
    const route = this.route(vehicle).filter(item => item.isOnTheWay);
    const from = route.findIndex(item => item.uid === this.selected);
    if (from < 0) return texts.chooseGoal;
    if (!route[from + step]) return texts.noPlace;
    const isChain = route.every((item, i) => !item.base || isPlain(item.base) && item.followers.length <= 1 && (i + 1 === route.length ? item.followers.length === 0 : item.followers[0] === route[i + 1]));
    if (!isChain || this.draft.whole && route.some(item => item.text('next'))) return texts.branching;
    const order = route.map(item => item.uid);
    [order[from], order[from + step]] = [order[from + step], order[from]];
    this.change(draft => {
      if (draft.whole) draft.whole.goals.sort((a, b) => order.indexOf(a.uid) - order.indexOf(b.uid));
      else draft.order = order;
    });
    return '';
  }

  /** Why the selected goal cannot leave the route; empty if it can. */
  refusalToRemove(vehicle) {
    const item = this.route(vehicle).find(each => each.uid === this.selected);
    if (!item) return texts.chooseGoal;
    if (item.isCurrent) return texts.skipInstead;
    return !item.base || isPlain(item.base) ? '' : texts.branching;
  }

  remove() {
    const uid = this.selected;
    this.change(draft => {
      const goals = draft.whole ? draft.whole.goals : draft.added;
      const own = goals.find(each => each.uid === uid);
      if (!own) return draft.removed.push(uid);
      goals.filter(each => each.after === uid).forEach(each => { each.after = own.after; });
      return goals.splice(goals.indexOf(own), 1);
    });
    this.selected = null;
  }

  /** Orders the changes one by one; what was accepted leaves the draft, so a retry repeats nothing. */
  async upload(vehicle) {
    const outcomes = [];
    this.refusal = null;
    const order = async (action, xml, fields, accepted) => {
      try {
        outcomes.push(await this.orders.mission(vehicle, action, {file: 'web page', goals: xml.text, ...fields}));
      } catch (error) {
        this.refused(xml, error.message);
        throw error;
      }
      await this.orders.report(vehicle).catch(() => undefined); // or what leaves the draft would vanish for a moment
      accepted();
      this.history = [emptyDraft()]; // what was accepted cannot be undone here
    };
    const {whole} = this.draft;
    if (whole) {
      await order('REPLACE', wholeMission(this, vehicle), {file: whole.file, ...(whole.text ? {goals: whole.text} : {})}, () => undefined);
    } else {
      const changes = new MissionXml();
      for (const item of this.route(vehicle)) if (this.draft.changed[item.uid] && !item.isRemoved) changes.goal({uid: item.uid, type: item.type, fields: this.draft.changed[item.uid]}, item.known);
      if (changes.lines.length > 1) await order('UPDATE', changes, {}, () => { this.draft.changed = {}; });
      for (const goal of [...this.draft.added]) {
        await order('INSERT', new MissionXml().goal(goal, vehicle.goalClasses.get(goal.type)), goal.after ? {uid: goal.after} : {}, () => {
          this.draft.added.splice(this.draft.added.indexOf(goal), 1);
        });
      }
      const links = relinked(this, vehicle, new MissionEditor(this.orders).route(vehicle));
      if (links.lines.length > 1) await order('UPDATE', links, {}, () => Object.assign(this.draft, {removed: [], order: null}));
    }
    this.discard();
    return outcomes.join('; ');
  }

  /** Finds the goal and field of a refusal. */
  refused(xml, text) {
    const line = /, line (\d+), /.exec(text);
    const place = line && xml.place(Number(line[1]));
    if (!place || !place.uid) return;
    const missing = /: lacks <([\w.-]+)>/.exec(text);
    const what = text.slice(line.index + line[0].length);
    this.refusal = {uid: place.uid, field: place.field || (missing ? missing[1] : ''), text: what};
    this.selected = place.uid;
  }
}

/** The goals in the order in which they are come to from the first and the current ones, and the others. */
function onTheWay(items) {
  const way = new Set();
  const visit = item => {
    if (way.has(item)) return;
    way.add(item);
    item.followers.forEach(visit);
  };
  [items[0], ...items.filter(item => item.isCurrent)].filter(item => item && !item.isRemoved).forEach(visit);
  for (const item of items) item.isOnTheWay = way.has(item);
  return [...way, ...items.filter(item => !way.has(item))];
}

function middle(points) {
  if (points.length === 0) return null;
  const sum = points.reduce((a, b) => ({x: a.x + b.x, y: a.y + b.y}));
  return {x: sum.x / points.length, y: sum.y / points.length};
}
