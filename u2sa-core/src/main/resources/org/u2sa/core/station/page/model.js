// What the page knows of each vehicle, from the messages it has heard.

import {readFence} from './fence.js';
import {Place} from './place.js';
import {playbackOf} from './playback.js';
import {sound} from './sound.js';

export const STALE_MS = 1000;
const REAL_SINCE_MICROS = 1e15; // 2001
const REAL_UNTIL_MICROS = 4102444800000000; // 2100-01-01
const TIMES_KEPT = 10;
const TIMED_MS = 3000; // Safety Managers speak every second
const MAX_VEHICLES = 64; // names come from messages
const MAX_NAMES = 256; // services, batteries and path planners of one vehicle
const MAX_ELEMENTS = 1000; // of a list in an answer
const MAX_CELLS = 8192; // of a grid along each side, as pictures are limited
const TRAIL_POINTS = 3000;
const EVENTS = 500;

/** One vehicle. Times are of the page's own clock [ms], since vehicles' clocks differ. */
export class Vehicle {
  constructor(id) {
    this.id = id;
    this.place = new Place();
    this.state = null;
    this.stateAt = -Infinity;
    this.flies = false; // known to be an aircraft
    this.trail = [];
    this.goals = [];
    this.goalsPaused = false;
    this.report = null; // MissionReport
    this.fence = null; // {frame, areas, …, file, margin}
    this.heard = null; // the same from the channel goals alone
    this.playback = null; // if it is a recording
    this.goalClasses = new Map(); // name -> GoalClass
    this.objects = [];
    this.objectsAt = -Infinity;
    this.grid = null;
    this.gridNumber = 0;
    this.plans = new Map();
    this.navigation = null;
    this.navigationAt = -Infinity;
    this.power = new Map();
    this.services = new Map(); // name -> {report, at}
    this.conditions = new Map();
    this.directory = new Map(); // name -> DiscoveryResponse
    this.functions = new Map(); // name -> FunctionalityResponse
    this.configurations = new Map(); // name -> ConfigurationResponse
    this.arming = null;
    this.failsafe = null;
    this.lastStop = '';
    this.aheads = []; // lead of the vehicle's clock over performance.now() [µs], less the messages' way; the newest last
    this.timedBy = ''; // channel that told them
    this.timedAt = 0;
    this.events = [];
  }

  /**
   * Takes a timestamp of the vehicle [µs]: its clock, not the browser's, tells the age of an order. Only the newest count, so that a wrong
   * one does no lasting harm, and of them the largest, which was held up least. The Safety Manager judges, so its failsafe states prevail.
   */
  heardAt(timestamp, channel) {
    if (!(timestamp > REAL_SINCE_MICROS && timestamp < REAL_UNTIL_MICROS)) return; // simulated time, which may run faster, or a false one
    const now = performance.now();
    if (channel !== this.timedBy && this.timedBy === 'failsafe' && now - this.timedAt < TIMED_MS) return;
    if (channel !== this.timedBy) this.aheads = [];
    this.timedBy = channel;
    this.timedAt = now;
    this.aheads.push(Number(timestamp) - now * 1000);
    if (this.aheads.length > TIMES_KEPT) this.aheads.shift();
  }

  /** The vehicle's time [µs]; undefined before its first message. */
  now() {
    return this.aheads.length === 0 ? undefined : BigInt(Math.round(Math.max(...this.aheads) + performance.now() * 1000));
  }

  isStale(now = performance.now()) {
    return now - this.stateAt > STALE_MS;
  }

  /** Forgets what was drawn and is over: a recording goes on elsewhere. */
  jumped() {
    this.trail = [];
    this.plans.clear();
    this.objects = [];
  }

  /** Services that obey emergency stops, and the identities of the stops in force. */
  stops() {
    const movers = [...this.services.values()].map(each => each.report).filter(each => each.emergencyStops && each.status === 'RUNNING');
    return {movers, inForce: [...new Set(movers.flatMap(each => each.emergencyStops))]};
  }

  log(text, level = 'info') {
    this.events.push({at: new Date(), text, level});
    if (this.events.length > EVENTS) this.events.shift();
  }
}

/** All vehicles. `answers` receives messages that answer a request. */
export class Model {
  constructor(answers) {
    this.vehicles = new Map();
    this.answers = answers;
    this.version = 0; // counts changes
  }

  vehicle(id) {
    let vehicle = this.vehicles.get(id);
    if (!vehicle && this.vehicles.size < MAX_VEHICLES) {
      vehicle = new Vehicle(id);
      this.vehicles.set(id, vehicle);
    }
    return vehicle;
  }

  message(system, channel, type, fields) {
    const vehicle = this.vehicle(system);
    const handler = HANDLERS[channel];
    if (!vehicle || !handler) return;
    handler(vehicle, sound(fields), type, this.answers);
    this.version++;
  }
}

function put(map, name, value) {
  if (map.has(name) || map.size < MAX_NAMES) map.set(name, value);
}

const NAME = /^[A-Za-z_][\w.-]{0,80}$/; // of a class or field in a mission file

function putClass(vehicle, fields) {
  const variables = variablesOf(fields).filter(each => NAME.test(each.name));
  put(vehicle.goalClasses, fields.className, {variables, required: list(fields.required, isText), number: vehicle.goalClasses.size});
}

function variablesOf(fields) {
  return list(fields.variables, each => each && isText(each.name) && isText(each.value)).map(each => ({...each, choices: list(each.choices, isText)}));
}

/** In a recording nobody answers: the goals heard so far, in their order, and which are current. */
function reportOf(before, current, upcoming, elapsed) {
  const goals = new Map((before ? before.goals : []).map(goal => [goal.uid, goal]));
  const sequence = before ? [...before.sequence] : [];
  for (const goal of [...current, ...upcoming]) {
    if (!goals.has(goal.uid)) sequence.splice(upcoming.includes(goal) ? sequence.indexOf(current[0] && current[0].uid) + 1 || sequence.length : sequence.length, 0, goal.uid);
    put(goals, goal.uid, {...goal, next: list(goal.next, isText)});
  }
  return {current: current.map(goal => goal.uid), goals: [...goals.values()], sequence: sequence.slice(0, MAX_NAMES), elapsed: Number(elapsed) || 0};
}

/** What a report leaves out is empty, as the wire protocol says. */
function missionReport(fields) {
  const goals = list(fields.goals, isGoal).map(each => ({...each, next: list(each.next, isText)}));
  return {...fields, goals, current: list(fields.current, isText), sequence: list(fields.sequence, isText), elapsed: fields.elapsed || 0};
}

const isGoal = value => value && isText(value.uid);
const isText = value => typeof value === 'string';
const text = value => (isText(value) ? value : '');

/** The elements of a list that are as expected; a service may send anything. */
function list(value, isExpected) {
  return Array.isArray(value) ? value.slice(0, MAX_ELEMENTS).filter(isExpected) : [];
}

const HANDLERS = {
  state(vehicle, fields, type) {
    vehicle.state = fields;
    vehicle.flies = vehicle.flies || type === 'AircraftState';
    vehicle.stateAt = performance.now();
    if (fields.timestamp !== undefined) vehicle.heardAt(fields.timestamp, 'state');
    const at = vehicle.place.ofState(fields);
    if (!at) return;
    const last = vehicle.trail[vehicle.trail.length - 1];
    const apart = last ? Math.hypot(at.x - last.x, at.y - last.y) : Infinity;
    if (apart > Math.max(0.2, 0.1 * Math.hypot(fields.xDot || 0, fields.yDot || 0))) {
      vehicle.trail.push(at);
      if (vehicle.trail.length > TRAIL_POINTS) vehicle.trail.splice(0, TRAIL_POINTS / 10);
    }
  },

  goals(vehicle, fields, type, answers) {
    vehicle.goals = fields.goals || [];
    vehicle.goalsPaused = fields.paused === true;
    vehicle.heard = reportOf(vehicle.heard, list(fields.goals, isGoal), list(fields.upcoming, isGoal), fields.elapsed);
    if (vehicle.playback) vehicle.report = vehicle.heard;
    else answers.missionChanged(vehicle);
  },

  mission(vehicle, fields, type, answers) {
    if (type === 'MissionReport') vehicle.report = missionReport(fields);
    if (type === 'GoalClass' && isText(fields.className) && NAME.test(fields.className)) putClass(vehicle, fields);
    if (type === 'MissionReport' || type === 'MissionOrderResult') answers.answered(fields);
  },

  objects(vehicle, fields) {
    vehicle.objects = fields.objects || [];
    vehicle.objectsAt = performance.now();
  },

  grid(vehicle, fields) {
    const number = ++vehicle.gridNumber;
    unpack(fields).then(cells => {
      if (cells && number === vehicle.gridNumber) vehicle.grid = {...fields, cells, image: null};
    }, () => vehicle.log('a grid cannot be unpacked', 'warn'));
  },

  plans: (vehicle, fields) => put(vehicle.plans, fields.subsystem, fields),

  navigation(vehicle, fields) {
    if (!fields.point) return;
    vehicle.navigation = fields;
    vehicle.navigationAt = performance.now();
  },

  power: (vehicle, fields) => put(vehicle.power, fields.sensorName, {...fields, at: performance.now()}),

  health(vehicle, fields, type) {
    if (!fields.serviceName || type !== 'HealthReport' || !isText(fields.status)) return;
    const before = vehicle.services.get(fields.serviceName);
    if (before && before.report.status !== fields.status) vehicle.log(`${fields.serviceName}: ${fields.status.toLowerCase()}`);
    if (fields.lastError && (!before || before.report.lastError !== fields.lastError)) {
      vehicle.log(`${fields.serviceName}: ${fields.lastError}`, 'error');
    }
    put(vehicle.services, fields.serviceName, {report: fields, at: performance.now()});
  },

  conditions(vehicle, fields) {
    if (!fields.condition) return;
    const before = vehicle.conditions.get(fields.serviceName);
    put(vehicle.conditions, fields.serviceName, fields);
    if (before ? before.condition !== fields.condition : fields.condition !== 'ALIVE') {
      const level = ['ALIVE', 'STOPPED', 'UNWATCHED'].includes(fields.condition) ? 'info' : 'error';
      vehicle.log(`${fields.serviceName}: ${[fields.condition.toLowerCase(), fields.reason, fields.action].filter(Boolean).join(', ')}`, level);
    }
  },

  discovery(vehicle, fields, type) {
    if (type === 'DiscoveryResponse') put(vehicle.directory, text(fields.serviceName), {className: text(fields.className), host: text(fields.host), choices: list(fields.choices, isText)});
  },

  functionality(vehicle, fields, type) {
    const {serviceName, publishes, subscribes} = fields;
    if (type === 'FunctionalityResponse') put(vehicle.functions, text(serviceName), {serviceName: text(serviceName), publishes: list(publishes, isText), subscribes: list(subscribes, isText)});
  },

  configuration(vehicle, fields, type, answers) {
    if (type === 'ConfigurationResponse') {
      const variables = variablesOf(fields);
      vehicle.playback = playbackOf({serviceName: fields.serviceName, variables}) || vehicle.playback;
      if (vehicle.playback) vehicle.report = vehicle.report || vehicle.heard;
      put(vehicle.configurations, text(fields.serviceName), {serviceName: text(fields.serviceName), revision: Number(fields.revision || 0), variables});
    }
    if (type !== 'ConfigurationTransactionResult') return;
    const changes = list(fields.assignments, Boolean).map(each => `${each.variableName} = ${each.value}`).join(', ');
    vehicle.log(`${fields.serviceName}: ${changes} by ${fields.author}${fields.accepted ? '' : ' refused: ' + fields.reason}`, fields.accepted ? 'important' : 'warn');
    answers.answered(fields);
  },

  'service-orders'(vehicle, fields, type, answers) {
    if (type === 'ServiceOrder') vehicle.log(`${fields.action} ${fields.serviceName} ordered by ${fields.operator}`, 'important');
    if (type !== 'ServiceOrderResult') return;
    if (!fields.accepted) vehicle.log(`${fields.serviceName}: not done: ${fields.reason}`, 'warn');
    answers.answered(fields);
  },

  'arming-state'(vehicle, fields, type, answers) {
    if (!vehicle.arming || vehicle.arming.armed !== fields.armed) vehicle.log(fields.armed ? 'armed' : 'not armed', 'important');
    vehicle.arming = fields;
    answers.answered(fields);
  },

  fence(vehicle, fields) {
    try {
      vehicle.fence = isText(fields.fence) ? {...readFence(fields.fence), file: text(fields.file), margin: Number(fields.margin) || 0} : null;
    } catch (error) {
      vehicle.fence = null;
      vehicle.log(`the fence cannot be read: ${error.message}`, 'error');
    }
    if (!vehicle.fence && fields.file) vehicle.log(`the fence of ${text(fields.file)} is too long to be shown`, 'warn');
  },

  'fence-orders'(vehicle, fields, type, answers) {
    if (type === 'FenceOrder') vehicle.log(`fence: ${fields.action} ordered by ${fields.operator}`, 'important');
    if (type === 'FenceOrderResult') answers.answered(fields);
  },

  failsafe(vehicle, fields) {
    if (!vehicle.failsafe || vehicle.failsafe.action !== fields.action) {
      vehicle.log(`failsafe ${fields.action}: ${(fields.causes || []).join('; ') || 'no cause'}`, fields.action === 'CONTINUE' ? 'info' : 'error');
    }
    vehicle.failsafe = fields;
    if (fields.timestamp !== undefined) vehicle.heardAt(fields.timestamp, 'failsafe');
  },

  'emergency-stop'(vehicle, fields) {
    const by = [fields.operator, fields.reason].filter(Boolean).join(': ');
    const text = fields.active ? `emergency stop by ${by}` : `emergency stop cleared by ${by}`;
    if (text !== vehicle.lastStop) vehicle.log(text, 'important'); // services repeat what is in force
    vehicle.lastStop = text;
  },

  'goal-reports'(vehicle, fields) {
    if (fields.completed) vehicle.log(`goal ${fields.uid} reached`);
    else if (fields.abandoned) vehicle.log(`goal ${fields.uid} abandoned: ${fields.reason || ''}`, 'warn');
  },
};

/** Cells of an occupancy grid: base64 of zlib (RFC 1950); null if they do not fit the grid. */
async function unpack(grid) {
  const count = grid.columns * grid.rows;
  if (!(count > 0 && count <= 4e6) || [grid.columns, grid.rows].some(each => !Number.isInteger(each) || each > MAX_CELLS)) return null;
  const packed = (grid.cells || []).map(piece => Uint8Array.from(atob(piece), letter => letter.charCodeAt(0)));
  const reader = new Blob(packed).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  const cells = new Int8Array(count);
  let filled = 0;
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return filled === count ? cells : null;
    if (filled + value.length > count) return reader.cancel().then(() => null); // never more than announced
    cells.set(new Int8Array(value.buffer, value.byteOffset, value.length), filled);
    filled += value.length;
  }
}
