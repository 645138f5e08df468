// The link to the vehicle's broker: log-in, loss and recovery, measured round trip.

import {Budget} from './budget.js';
import {decode, encode} from './cbor.js';
import {MqttConnection} from './mqtt.js';
import {texts} from './texts.js';

const KEEP_ALIVE_S = 60; // a hidden page may be woken once a minute only
const PING_EVERY_MS = 1000;
const LOST_AFTER_MS = 3000; // three pings
const RETRY_MS = [500, 1000, 2000, 5000];
const QOS_1 = ['mission', 'service-orders', 'arming-state', 'failsafe', 'emergency-stop', 'goals', 'conditions', 'configuration', 'discovery', 'functionality', 'fence', 'fence-orders'];
const QOS_0 = ['state', 'objects', 'grid', 'plans', 'navigation', 'power', 'health', 'goal-reports'];
const REFUSALS = {
  1: 'the broker wants another version of MQTT',
  2: 'the broker refuses the client ID',
  3: 'the broker is busy, or this name must wait after a wrong password',
  4: 'wrong user name or password',
  5: 'the broker wants a user name, or this user may not log in',
};

/** `events` has changed() and message(system, channel, chain, fields). */
export class Link {
  constructor(events) {
    this.events = events;
    this.state = 'off'; // off, connecting, up, lost, refused
    this.reason = '';
    this.roundTripMs = undefined;
    this.since = performance.now();
    this.unreadable = 0;
    this.budget = new Budget();
    this.connection = null;
    this.login = null;
    this.attempts = 0;
    this.isReadOnly = false; // a recording is shown
    this.extra = new Set(); // channels heard on demand
    setInterval(() => this.watch(), PING_EVERY_MS);
  }

  get isUp() {
    return this.state === 'up';
  }

  /** Connects, and again after each loss, until logged out. The password stays in memory only. */
  open(login) {
    this.login = login;
    this.attempts = 0;
    this.connect();
  }

  close() {
    this.login = null;
    this.set('off', '');
    if (this.connection) this.connection.end();
  }

  connect() {
    if (!this.login) return;
    this.set(this.state === 'lost' ? 'lost' : 'connecting', this.reason);
    const url = (location.protocol === 'https:' ? 'wss://' : 'ws://') + location.host + '/mqtt';
    const connection = new MqttConnection(url, this.login, KEEP_ALIVE_S, {
      connected: code => this.answered(code),
      message: (topic, payload, retained) => this.received(topic, payload, retained),
      alive: ms => {
        this.roundTripMs = ms;
        this.events.changed();
      },
      refusedFilter: () => this.set(this.state, 'the broker refuses to send a channel'),
      closed: () => this.closed(connection),
    });
    this.connection = connection;
  }

  answered(code) {
    if (code !== 0) {
      if (code !== 3) {
        this.login = null; // final: another attempt would count as guessing
        this.set('refused', REFUSALS[code] || 'refused with code ' + code);
      } else {
        this.set(this.state, REFUSALS[code]);
      }
      return;
    }
    this.attempts = 0;
    this.set('up', '');
    this.connection.subscribe([
      ...QOS_1.map(channel => [`u2sa/+/${channel}/#`, 1]),
      ...[...QOS_0, ...this.extra].map(channel => [`u2sa/+/${channel}/#`, 0]),
    ]);
    this.connection.ping();
    if (this.events.up) this.events.up();
  }

  /** Receives one more channel from now on. */
  hear(channel) {
    if (QOS_1.includes(channel) || QOS_0.includes(channel) || this.extra.has(channel)) return;
    this.extra.add(channel);
    if (this.isUp) this.connection.subscribe([[`u2sa/+/${channel}/#`, 0]]);
  }

  unhear(channel) {
    if (this.extra.delete(channel) && this.isUp) this.connection.unsubscribe(`u2sa/+/${channel}/#`);
  }

  closed(connection) {
    if (connection !== this.connection) return;
    this.connection = null;
    this.roundTripMs = undefined;
    if (!this.login) return this.events.changed();
    if (this.state === 'up') this.set('lost', 'the connection broke');
    const wait = RETRY_MS[Math.min(this.attempts++, RETRY_MS.length - 1)];
    setTimeout(() => this.connect(), wait);
    this.events.changed();
  }

  watch() {
    if (!this.connection) return;
    if (this.isUp) this.connection.ping();
    if (this.connection.silenceMs() > LOST_AFTER_MS * (this.isUp ? 1 : 5)) {
      if (this.isUp) this.set('lost', 'no answer for ' + LOST_AFTER_MS / 1000 + ' s');
      this.connection.abandon();
    }
  }

  set(state, reason) {
    if (this.state !== state) this.since = performance.now();
    this.state = state;
    this.reason = reason;
    this.events.changed();
  }

  received(topic, payload, retained) {
    const [root, system, channel, ...rest] = topic.split('/');
    if (root !== 'u2sa' || payload.length === 0) return;
    if (!this.budget.allows(channel, payload.length, performance.now())) return;
    const chain = rest.filter(level => !level.startsWith('='));
    try {
      this.events.message(system, channel, chain[chain.length - 1], decode(payload), retained);
    } catch (e) {
      this.unreadable++; // shown; a service that writes nonsense does not stop the page
    }
  }

  /** Publishes a message; rejects if there is no link. Resolves when the broker has it. */
  publish(system, channel, type, fields, retain = false) {
    if (!this.isUp) return Promise.reject(new Error('no link'));
    if (this.isReadOnly && channel !== 'configuration') return Promise.reject(new Error(texts.recording));
    const payload = encode({systemId: system, ...fields});
    return this.connection.publish(`u2sa/${system}/${channel}/${type}`, payload, retain);
  }
}
