// Orders to a vehicle: each ends with the vehicle's own answer, or with the reason why there is none.

import {texts} from './texts.js';

const ANSWER_WITHIN_MS = 4500; // 5 s, less what a busy browser needs to say so
const LIFTS_BYTES = 12000;
const REPEAT_WITHIN_MS = 30000;
const SWAP_WITHIN_MS = 15000; // a restart first tries the service out

export class Orders {
  constructor(link) {
    this.link = link;
    this.pending = new Map(); // request ID -> {resolve, serviceName: whose answer counts; undefined: anyone's}
    this.operator = 'web';
    this.stop = null; // {vehicle, id, phase: waiting | sent, at}
  }

  /** Takes a message that may answer a request. */
  answered(fields) {
    const asked = this.pending.get(fields.requestId);
    if (asked && (!asked.serviceName || asked.serviceName === fields.serviceName)) asked.resolve(fields);
  }

  async ask(vehicle, channel, type, fields, withinMs = ANSWER_WITHIN_MS, serviceName = undefined) {
    const requestId = randomId();
    const answer = new Promise((resolve, reject) => {
      this.pending.set(requestId, {resolve, serviceName});
      setTimeout(() => reject(new Error(texts.noAnswer)), withinMs);
    });
    answer.catch(() => undefined); // awaited below unless publishing fails
    try {
      await Promise.race([this.link.publish(vehicle.id, channel, type, {requestId, timestamp: vehicle.now(), ...fields}), answer]);
      return await answer;
    } finally {
      this.pending.delete(requestId);
    }
  }

  /** Asks how the mission stands, and if so said, which classes of goals there are. */
  report(vehicle, classes = false) {
    return this.ask(vehicle, 'mission', 'MissionRequest', classes ? {classes} : {});
  }

  /** One mission order; resolves with what was done, rejects with why it was not. */
  async mission(vehicle, action, fields = {}) {
    const result = await this.ask(vehicle, 'mission', 'MissionOrder', {action, now: false, operator: this.operator, ...fields});
    if (!result.accepted) throw new Error(result.outcome);
    return result.outcome;
  }

  async arm(vehicle, arm) {
    const state = await this.ask(vehicle, 'arming', 'ArmCommand', {arm, operator: this.operator});
    const reasons = arm ? state.reasons || [] : []; // of a vehicle that was armed before, too
    if (state.armed !== arm || reasons.length > 0) throw new Error(arm ? 'cannot arm: ' + reasons.join('; ') : 'still armed');
    return arm ? 'armed' : 'disarmed';
  }

  /** Orders a service's launcher to start, restart or swap it. */
  async service(vehicle, serviceName, action, fields = {}) {
    const result = await this.ask(vehicle, 'service-orders', 'ServiceOrder', {serviceName, action, operator: this.operator, ...fields}, SWAP_WITHIN_MS);
    if (!result.accepted) throw new Error(result.reason);
    await this.askDirectory(vehicle).catch(() => undefined); // its class may be another
    return texts.ordered(serviceName, action);
  }

  /** Ends a service; resolves when it reports so. */
  async stopService(vehicle, serviceName) {
    await this.link.publish(vehicle.id, 'stop', 'StopCommand', {timestamp: vehicle.now(), serviceName, stopAll: false});
    await this.until(() => ['STOPPED', 'FAILED'].includes((vehicle.services.get(serviceName) || {report: {}}).report.status));
    return texts.stopped(serviceName);
  }

  /** Asks what a service's variables are; the answer goes into the model. */
  async askConfiguration(vehicle, serviceName) {
    const before = vehicle.configurations.get(serviceName);
    await this.link.publish(vehicle.id, 'configuration', 'ConfigurationRequest', {serviceName});
    await this.until(() => vehicle.configurations.get(serviceName) !== before);
  }

  async askDirectory(vehicle) {
    await this.link.publish(vehicle.id, 'discovery', 'DiscoveryRequest', {});
    await this.link.publish(vehicle.id, 'functionality', 'FunctionalityRequest', {serviceName: ''});
  }

  configure(vehicle, serviceName, assignments, revision) {
    return this.changed(vehicle, 'ConfigurationTransaction', {serviceName, author: this.operator, assignments, revision: revision === undefined ? undefined : BigInt(revision)});
  }

  undoConfiguration(vehicle, serviceName) {
    return this.changed(vehicle, 'ConfigurationUndo', {serviceName, author: this.operator});
  }

  async changed(vehicle, type, fields) {
    const result = await this.ask(vehicle, 'configuration', type, fields, ANSWER_WITHIN_MS, fields.serviceName);
    await this.askConfiguration(vehicle, fields.serviceName).catch(() => undefined); // shows the values in force
    if (!result.accepted) throw new Error(result.reason);
    return result;
  }

  /** Waits for what only the model shows. */
  async until(condition) {
    const end = performance.now() + ANSWER_WITHIN_MS;
    while (!condition()) {
      if (performance.now() > end) throw new Error(texts.noAnswer);
      await new Promise(resolve => setTimeout(resolve, 50));
    }
  }

  /** Stops the vehicle at once; without a link, as soon as there is one. */
  emergencyStop(vehicle) {
    this.stop = {vehicle, id: `${this.operator} ${randomId()}`, phase: 'waiting', at: performance.now()};
    vehicle.log('emergency stop pressed', 'important');
    this.sendStop();
  }

  sendStop() {
    const {stop} = this;
    if (!stop || stop.phase !== 'waiting' || !this.link.isUp) return;
    stop.phase = 'sent';
    stop.at = performance.now();
    const lost = () => { if (stop.phase === 'sent' && !this.stopOutcome().isConfirmed) stop.phase = 'waiting'; };
    const fields = {active: true, operator: this.operator, reason: 'pressed on the web page', stopId: stop.id};
    this.link.publish(stop.vehicle.id, 'emergency-stop', 'EmergencyStop', fields, true).catch(lost);
  }

  /** A stop that was sent shortly before the link broke, and is not confirmed, is sent again. */
  linkUp() {
    const {stop} = this;
    if (stop && performance.now() - stop.at < REPEAT_WITHIN_MS && !this.stopOutcome().isConfirmed) stop.phase = 'waiting';
    this.sendStop();
  }

  /** How far the last stop has come: the services that hold it, of those that obey stops. */
  stopOutcome() {
    const {movers} = this.stop.vehicle.stops();
    const holding = movers.filter(each => each.emergencyStops.includes(this.stop.id)).length;
    return {
      isSent: this.stop.phase === 'sent',
      isConfirmed: movers.length > 0 && holding === movers.length,
      isLate: performance.now() - this.stop.at > 2000,
      holding,
      movers: movers.length,
    };
  }

  /** Clears all stops in force; resolves when no service reports one any more. */
  async clearStops(vehicle) {
    const lifts = vehicle.stops().inForce;
    this.stop = null;
    let timestamp = vehicle.now();
    for (const part of parts(lifts)) {
      await this.link.publish(vehicle.id, 'emergency-stop', 'EmergencyStop', {active: false, timestamp, operator: this.operator, reason: 'cleared on the web page', lifts: part}, true);
      if (timestamp !== undefined) timestamp++; // two of the same time would be one that arrives twice
    }
    await this.until(() => !vehicle.stops().inForce.some(id => lifts.includes(id)));
    return 'emergency stop cleared';
  }
}

/** IDs in lists that each fit into a message, of 16 KiB at most. */
function parts(ids) {
  const lists = [[]];
  let left = LIFTS_BYTES;
  for (const id of ids) {
    const bytes = new TextEncoder().encode(id).length;
    if (bytes > left && lists[lists.length - 1].length > 0) {
      lists.push([]);
      left = LIFTS_BYTES;
    }
    lists[lists.length - 1].push(id);
    left -= bytes;
  }
  return lists;
}

function randomId() {
  return Array.from(crypto.getRandomValues(new Uint8Array(16)), byte => byte.toString(16).padStart(2, '0')).join('');
}
