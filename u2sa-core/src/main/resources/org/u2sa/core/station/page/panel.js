// The texts, tables and chips around the map. Everything from a vehicle is set as text, never as markup.

import {age, byId, element, fill, row, setText} from './dom.js';
import {STALE_MS} from './model.js';

const SLOW_MS = 500;
const READY = matchMedia('(any-pointer: fine)').matches ? 'Esc Esc' : 'tap'; // a telephone has no Escape key
const DEG = 180 / Math.PI;
const LINK_NAMES = {off: 'not connected', connecting: 'connecting', up: 'link', lost: 'LINK LOST', refused: 'log-in refused'};

/** `parts`: link, orders, editor, model, mission, services, insight, selected(), select(id). */
export class Panel {
  constructor(parts) {
    Object.assign(this, parts);
    byId('vehicle').onchange = event => this.select(event.target.value);
    this.tabs = [...document.querySelectorAll('[role=tab]')];
    this.tabs.forEach((tab, i) => {
      tab.onclick = () => this.open(tab);
      tab.onkeydown = event => {
        const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
        if (step) this.open(this.tabs[(i + step + this.tabs.length) % this.tabs.length]).focus();
      };
    });
  }

  open(tab) {
    for (const each of this.tabs) {
      each.setAttribute('aria-selected', each === tab);
      each.tabIndex = each === tab ? 0 : -1;
      byId(each.getAttribute('aria-controls')).hidden = each !== tab;
    }
    this.show(this.selected());
    return tab;
  }

  tell(text, isBad = false) {
    setText(byId('outcome'), text);
    byId('outcome').className = isBad ? 'bad' : '';
  }

  /** Resolves with whether the operator says yes. */
  confirm(question) {
    const dialog = byId('confirm');
    setText(byId('question'), question);
    dialog.returnValue = 'no';
    dialog.show(); // not modal: the emergency stop stays in reach
    dialog.querySelector('button').focus();
    return new Promise(resolve => dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes'), {once: true}));
  }

  showLink() {
    const {link} = this;
    const trip = link.roundTripMs === undefined ? '' : ` ${Math.round(link.roundTripMs)} ms`;
    const lostS = link.state === 'lost' ? ` ${Math.round((performance.now() - link.since) / 1000)} s` : '';
    chip('link', LINK_NAMES[link.state] + trip + lostS, {up: link.roundTripMs > SLOW_MS ? 'warn' : 'good', connecting: 'warn', lost: 'bad', refused: 'bad'}[link.state]);
    if (link.state === 'refused' && !byId('login').open) byId('login').showModal();
    setText(byId('login-reason'), link.state === 'refused' ? link.reason : '');
    document.body.classList.toggle('lost', link.state !== 'up');
  }

  show(vehicle) {
    this.showLink();
    this.showAlert(vehicle);
    this.showVehicles();
    if (!vehicle) return;
    const {arming, failsafe, report} = vehicle;
    chip('armed', arming ? (arming.armed ? 'ARMED' : 'not armed') : '', arming && arming.armed ? 'warn' : '');
    chip('failsafe', failsafe && failsafe.action !== 'CONTINUE' ? 'failsafe ' + failsafe.action : '', 'bad');
    chip('doing', report ? doing(report) : '');
    if (!byId('operate').hidden) this.showOperate(vehicle);
    if (!byId('mission').hidden) this.mission.show(vehicle);
    if (!byId('services').hidden) this.services.show(vehicle);
    if (!byId('insight').hidden) this.insight.show(vehicle);
    if (!byId('log').hidden) showLog(vehicle);
  }

  showVehicles() {
    const ids = [...this.model.vehicles.keys()].sort();
    const list = byId('vehicle');
    if (list.options.length !== ids.length) {
      list.replaceChildren(...ids.map(id => Object.assign(element('option', id), {value: id})));
      const vehicle = this.selected();
      if (vehicle) list.value = vehicle.id;
    }
  }

  /** The emergency stop's fate, a lost link, or old data: the one that matters most. */
  showAlert(vehicle) {
    const {link, orders} = this;
    let text = '';
    let stopState = vehicle ? READY : 'no vehicle';
    const inForce = vehicle ? vehicle.stops().inForce : [];
    if (link.state === 'lost') text = `Link lost: ${link.reason}. What you see is old. Reconnecting…`;
    else if (link.isUp && vehicle && vehicle.isStale() && !(vehicle.playback && vehicle.playback.isPaused)) text = `No position from ${vehicle.id} for ${age(vehicle.stateAt)}.`;
    if (link.budget.skipped > 0) text = text || `${link.budget.skipped} messages are too large or too many to show.`;
    if (link.unreadable > 0) text = text || `${link.unreadable} messages cannot be read.`;
    if (inForce.length > 0) {
      text = `Emergency stop in force on ${vehicle.id}.`;
      stopState = 'IN FORCE';
    }
    if (orders.stop && orders.stop.vehicle === vehicle) {
      const outcome = orders.stopOutcome();
      const count = `${outcome.holding} of ${outcome.movers} services`;
      if (outcome.isConfirmed) text = `Emergency stop confirmed by ${count} of ${vehicle.id}.`;
      else if (!outcome.isSent) text = 'Emergency stop NOT SENT: no link. It is sent as soon as there is one.';
      else text = outcome.isLate ? `Emergency stop NOT CONFIRMED: ${count}. This user may lack the role operator.` : `Emergency stop sent, confirmed by ${count}…`;
      stopState = outcome.isConfirmed ? 'CONFIRMED' : 'NOT CONFIRMED';
      if (outcome.isConfirmed && inForce.length === 0) orders.stop = null;
    }
    setText(byId('alert'), text);
    byId('alert').hidden = !text;
    setText(byId('estop-state'), stopState);
    byId('clear').hidden = inForce.length === 0;
  }

  showOperate(vehicle) {
    const {arming, failsafe, report} = vehicle;
    const canOrder = this.link.isUp;
    byId('arm').disabled = !canOrder || !arming || arming.armed;
    byId('disarm').disabled = !canOrder || !arming || !arming.armed;
    byId('hold').disabled = !canOrder || !report || Boolean(report.paused);
    byId('resume').disabled = !canOrder || !report || !(report.paused || report.resumable);
    byId('return').disabled = byId('land').disabled = !canOrder || !report;
    byId('land').hidden = !vehicle.flies && !(report && report.goals.some(goal => goal.landingStart || [].concat(goal.type).includes('Landing')));
    byId('skip').disabled = !canOrder || !report || report.current.length === 0;
    const reasons = arming && !arming.armed ? (arming.reasons || []).map(reason => 'Not ready: ' + reason) : [];
    const causes = failsafe && failsafe.action !== 'CONTINUE' ? (failsafe.causes || []).map(cause => `${failsafe.action}: ${cause}`) : [];
    const plans = [...vehicle.plans.values()].filter(plan => plan.reason).map(plan => `Planner ${(plan.status || '').toLowerCase()}: ${plan.reason}`);
    fill(byId('reasons'), [...reasons, ...causes, ...plans], text => element('li', text));
    fill(byId('instruments').tBodies[0], instruments(vehicle, this.editor.route(vehicle)), row);
  }
}

function doing(report) {
  const goals = report.goals.filter(goal => String(goal.uid) !== 'home');
  const done = goals.filter(goal => goal.completed).length;
  const now = report.current.length === 0 ? 'over' : (report.paused ? 'held at ' : 'to ') + report.current.join(', ');
  return `${done}/${goals.length}, ${now}`;
}

/** Rows of name, value with unit, and age. */
function instruments(vehicle, route) {
  const s = vehicle.state || {};
  const rows = [];
  const add = (name, value, digits, unit, at) => {
    if (Number.isFinite(value)) rows.push({cells: [name, `${value.toFixed(digits).replace(/^-(0(\.0+)?)$/, '$1')} ${unit}`, age(at)], state: performance.now() - at > STALE_MS ? 'stale' : ''});
  };
  const {pose} = vehicle.place;
  const heading = pose && pose.heading;
  add('Speed', s.xDot === undefined || s.yDot === undefined ? undefined : Math.hypot(s.xDot, s.yDot), 1, 'm/s', vehicle.stateAt);
  add('Heading', heading === undefined ? undefined : Math.round(heading * DEG % 360 + 360) % 360, 0, '°', vehicle.stateAt);
  add('Altitude', s.z, 1, 'm', vehicle.stateAt);
  add('Climb', s.zDot, 1, 'm/s', vehicle.stateAt);
  add('Roll', s.phi === undefined ? undefined : s.phi * DEG, 0, '°', vehicle.stateAt);
  add('Pitch', s.theta === undefined ? undefined : s.theta * DEG, 0, '°', vehicle.stateAt);
  add('Position uncertainty, 2σ', s.xSigma === undefined || s.ySigma === undefined ? undefined : 2 * Math.hypot(s.xSigma, s.ySigma), 2, 'm', vehicle.stateAt);
  const goal = route.find(item => item.isCurrent && item.at);
  if (goal && pose) add('To goal ' + goal.uid, Math.hypot(goal.at.x - pose.x, goal.at.y - pose.y), 1, 'm', vehicle.stateAt);
  for (const [name, power] of vehicle.power) {
    const title = vehicle.power.size > 1 ? name + ' ' : '';
    add(title + 'Battery', power.remaining, 0, '%', power.at);
    add(title + 'Voltage', power.voltage, 1, 'V', power.at);
    add(title + 'Current', power.current, 1, 'A', power.at);
  }
  if (vehicle.report) rows.push({cells: ['Mission time', `${Math.floor(vehicle.report.elapsed / 60)}:${String(Math.floor(vehicle.report.elapsed % 60)).padStart(2, '0')}`, ''], state: ''});
  return rows;
}

function showLog(vehicle) {
  const wanted = byId('search').value.toLowerCase();
  const events = vehicle.events.filter(event => event.text.toLowerCase().includes(wanted)).slice(-200).reverse();
  fill(byId('events'), events, event => {
    const item = element('li', `${event.at.toLocaleTimeString('en-GB')} ${event.text}`);
    item.className = event.level;
    return item;
  });
}

function chip(id, text, state = '') {
  const item = byId(id);
  setText(item, text);
  item.className = state;
  item.hidden = !text;
}
