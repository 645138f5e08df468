// Orders to a vehicle: each ends with the vehicle's own answer, or with the reason why there is none.

const ANSWER_WITHIN_MS = 5000;
const REPEAT_WITHIN_MS = 30000;
const NO_ANSWER = 'no answer from the vehicle within 5 s: this user may lack the role operator, or nobody there handles it';

export class Orders {
  constructor(link) {
    this.link = link;
    this.pending = new Map(); // request ID -> resolve
    this.operator = 'web';
    this.stop = null; // {vehicle, id, phase: waiting | sent, at}
  }

  /** Takes a message that may answer a request. */
  answered(fields) {
    const resolve = this.pending.get(fields.requestId);
    if (resolve) resolve(fields);
  }

  async ask(vehicle, channel, type, fields) {
    const requestId = randomId();
    const answer = new Promise((resolve, reject) => {
      this.pending.set(requestId, resolve);
      setTimeout(() => reject(new Error(NO_ANSWER)), ANSWER_WITHIN_MS);
    });
    answer.catch(() => undefined); // awaited below unless publishing fails
    try {
      await Promise.race([this.link.publish(vehicle.id, channel, type, {requestId, ...fields}), answer]);
      return await answer;
    } finally {
      this.pending.delete(requestId);
    }
  }

  report(vehicle) {
    return this.ask(vehicle, 'mission', 'MissionRequest', {});
  }

  /** One mission order; resolves with what was done, rejects with why it was not. */
  async mission(vehicle, action, fields = {}) {
    const result = await this.ask(vehicle, 'mission', 'MissionOrder', {action, now: false, operator: this.operator, ...fields});
    if (!result.accepted) throw new Error(result.outcome);
    return result.outcome;
  }

  async arm(vehicle, arm) {
    const state = await this.ask(vehicle, 'arming', 'ArmCommand', {arm, operator: this.operator});
    if (state.armed !== arm) throw new Error(arm ? 'cannot arm: ' + (state.reasons || []).join('; ') : 'still armed');
    return arm ? 'armed' : 'disarmed';
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
    await this.link.publish(vehicle.id, 'emergency-stop', 'EmergencyStop', {active: false, operator: this.operator, reason: 'cleared on the web page', lifts}, true);
    const end = performance.now() + ANSWER_WITHIN_MS;
    while (performance.now() < end) {
      if (!vehicle.stops().inForce.some(id => lifts.includes(id))) return 'emergency stop cleared';
      await new Promise(resolve => setTimeout(resolve, 100));
    }
    throw new Error('the stop is still in force: ' + NO_ANSWER);
  }
}

function randomId() {
  return Array.from(crypto.getRandomValues(new Uint8Array(16)), byte => byte.toString(16).padStart(2, '0')).join('');
}
