// Edits of a running mission: a draft on the map until the vehicle has accepted it.

const MARGIN_DEG = 9; // decimals of degrees, 0.1 mm
const UNDO_STEPS = 50;

const emptyDraft = () => ({moved: {}, added: [], removed: []});

/** Draft of one vehicle's mission. */
export class MissionEditor {
  constructor(orders) {
    this.orders = orders;
    this.discard();
    this.selected = null;
    this.isAdding = false;
  }

  /** Draft: places of moved goals, added goals in order, goals taken off the route. */
  discard() {
    this.draft = emptyDraft();
    this.history = [];
  }

  get isChanged() {
    return this.history.length > 0;
  }

  change(edit) {
    this.history.push(structuredClone(this.draft));
    if (this.history.length > UNDO_STEPS) this.history.splice(1, 1); // the first is the vehicle's
    edit(this.draft);
  }

  undo() {
    if (this.isChanged) this.draft = this.history.pop();
  }

  /** The goals with their followers as they will be once the draft is uploaded. */
  route(vehicle) {
    const {report} = vehicle;
    if (!report) return [];
    const known = new Map(report.goals.map(goal => [goal.uid, goal]));
    const {moved, added, removed} = this.draft;
    const order = this.order(report, known);
    const items = new Map();
    for (const uid of new Set([...order, ...known.keys()])) {
      const goal = moved[uid] || added.find(each => each.uid === uid) || known.get(uid);
      const frame = known.has(uid) ? known.get(uid).referenceFrame : goal.referenceFrame;
      items.set(uid, {
        uid,
        goal: known.get(uid) || goal,
        at: goal.x === undefined ? null : vehicle.place.of(frame, goal.x, goal.y) || null,
        radius: (known.get(uid) || goal).horizontalThreshold || 0,
        isCurrent: report.current.includes(uid),
        isDone: Boolean(known.get(uid) && known.get(uid).result),
        isChanged: uid in moved || !known.has(uid) || removed.includes(uid),
        isSelected: uid === this.selected,
        isRemoved: removed.includes(uid),
        followers: [],
      });
    }
    for (const item of items.values()) {
      item.followers = this.followers(item, items, order).map(uid => items.get(uid)).filter(Boolean);
    }
    return [...items.values()];
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
  followers({uid, goal, isRemoved}, items, order) {
    if (isRemoved) return [];
    const isDraft = this.draft.added.some(each => each.after === uid || each.uid === uid);
    const named = goal.nextIfDone || goal.next || [];
    const next = !isDraft && named.length > 0 ? named : order.includes(uid) ? [order[order.indexOf(uid) + 1]] : [];
    return next.filter(each => items.has(each)).flatMap(each => {
      const item = items.get(each);
      return item.isRemoved ? this.followers({...item, isRemoved: false}, items, order) : each;
    });
  }

  add(vehicle, at) {
    const route = this.route(vehicle);
    const current = route.find(item => item.isCurrent);
    const after = route.find(item => item.uid === this.selected) || current || route[route.length - 1];
    const like = after ? after.goal : {};
    const names = new Set(route.map(item => item.uid));
    let number = 1;
    while (names.has('w' + number)) number++;
    const {frame, x, y} = vehicle.place.inFrame(at);
    const {z, verticalThreshold, speed} = like;
    const added = {uid: 'w' + number, after: after ? after.uid : '', referenceFrame: frame, x, y, z, verticalThreshold, speed, horizontalThreshold: like.horizontalThreshold || 2};
    this.change(draft => draft.added.push(added));
    this.selected = added.uid;
  }

  move(vehicle, uid, at) {
    const {x, y} = vehicle.place.inFrame(at);
    this.change(draft => {
      const added = draft.added.find(each => each.uid === uid);
      if (added) Object.assign(added, {x, y});
      else draft.moved[uid] = {x, y};
    });
  }

  /** Why the selected goal cannot leave the route; empty if it can. */
  refusalToRemove(vehicle) {
    const item = this.route(vehicle).find(each => each.uid === this.selected);
    if (!item) return 'choose a goal first';
    if (item.isCurrent) return 'the vehicle is on its way there: skip it instead';
    const {goal} = item;
    const isPlain = !goal.repeatFrom && goal.nextIfFailed === undefined && goal.nextIfTimedOut === undefined;
    return isPlain ? '' : 'the goal has conditions or repetitions; edit the mission file';
  }

  remove() {
    const uid = this.selected;
    this.change(draft => {
      const added = draft.added.find(each => each.uid === uid);
      if (!added) return draft.removed.push(uid);
      draft.added.filter(each => each.after === uid).forEach(each => { each.after = added.after; });
      return draft.added.splice(draft.added.indexOf(added), 1);
    });
    this.selected = null;
  }

  /** Orders the changes one by one; what was accepted leaves the draft, so a retry repeats nothing. */
  async upload(vehicle) {
    const outcomes = [];
    const goals = new Map(vehicle.report.goals.map(goal => [goal.uid, goal]));
    const order = async (action, fields, accepted) => {
      outcomes.push(await this.orders.mission(vehicle, action, {file: 'web page', ...fields}));
      await this.orders.report(vehicle).catch(() => undefined); // or what leaves the draft would vanish for a moment
      accepted();
      this.history = [emptyDraft()]; // what was accepted cannot be undone here
    };
    const moves = Object.entries(this.draft.moved).map(([uid, place]) => xml(goals.get(uid), uid, place));
    if (moves.length > 0) await order('UPDATE', {goals: mission(moves)}, () => { this.draft.moved = {}; });
    const added = this.draft.added.filter(goal => !this.draft.removed.includes(goal.uid));
    for (const goal of added) {
      const {uid, after, ...fields} = goal;
      await order('INSERT', {goals: mission([xml({}, uid, fields)]), ...(after ? {uid: after} : {})}, () => {
        this.draft.added.splice(this.draft.added.indexOf(goal), 1);
      });
    }
    if (this.draft.removed.length > 0) {
      const before = new MissionEditor(this.orders).route(vehicle);
      const leads = uid => before.find(item => item.uid === uid).followers.some(next => this.draft.removed.includes(next.uid));
      const links = this.route(vehicle).filter(item => !item.isRemoved && item.followers.length > 0 && leads(item.uid))
        .map(item => xml(item.goal, item.uid, {next: item.followers.map(next => next.uid).join(', ')}));
      if (links.length === 0) throw new Error('nothing follows the goal: skip it once it is current');
      await order('UPDATE', {goals: mission(links)}, () => { this.draft.removed = []; });
    }
    this.discard();
    return outcomes.join('; ');
  }
}

function mission(goals) {
  return `<mission>\n${goals.join('\n')}\n</mission>`;
}

/** A goal's element, as in mission files. */
function xml(goal, uid, fields) {
  const type = goal.type ? goal.type[goal.type.length - 1] : 'Waypoint';
  const lines = Object.entries(fields).filter(([, value]) => value !== undefined)
    .map(([name, value]) => `    <${name}>${typeof value === 'number' ? value.toFixed(MARGIN_DEG) : escape(value)}</${name}>`);
  return `  <${type}>\n    <name>${escape(uid)}</name>\n${lines.join('\n')}\n  </${type}>`;
}

function escape(text) {
  return String(text).replace(/[&<>"']/g, letter => `&#${letter.charCodeAt(0)};`);
}
