// MQTT 3.1.1 over WebSocket, as much as the page needs: QoS 0 and 1, no sessions.

const CONNECT = 1, CONNACK = 2, PUBLISH = 3, PUBACK = 4, SUBSCRIBE = 8, SUBACK = 9, UNSUBSCRIBE = 10;
const PINGREQ = 12, PINGRESP = 13, DISCONNECT = 14;
const LONGEST_FRAME = 16 * 1024; // the broker's limit; a packet may span several frames
const LONGEST_PACKET = 4 << 20;

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** One connection. `events` has connected(code), message(topic, payload, retained), alive(roundTripMs), closed(). */
export class MqttConnection {
  constructor(url, login, keepAliveS, events) {
    this.events = events;
    this.waiting = new Map(); // packet ID -> resolve
    this.lastId = 0;
    this.received = new Uint8Array(0);
    this.parts = []; // of a packet that spans several frames
    this.missing = 0; // bytes until it is complete
    this.pingSent = 0;
    this.heardAt = performance.now();
    this.socket = new WebSocket(url, 'mqtt');
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => this.connect(login, keepAliveS);
    this.socket.onmessage = event => this.receive(new Uint8Array(event.data));
    this.socket.onclose = () => events.closed();
  }

  connect({user, password}, keepAliveS) {
    const id = 'web-' + Array.from(crypto.getRandomValues(new Uint8Array(16)), b => b.toString(16).padStart(2, '0')).join('');
    const flags = 0x02 | (user ? 0x80 : 0) | (user ? 0x40 : 0);
    const body = [...text('MQTT'), 4, flags, keepAliveS >> 8, keepAliveS & 0xff, ...text(id)];
    if (user) body.push(...text(user), ...text(password));
    this.send(CONNECT << 4, body);
  }

  subscribe(filters) {
    const body = [...this.nextId()];
    for (const [filter, qos] of filters) body.push(...text(filter), qos);
    this.send(SUBSCRIBE << 4 | 2, body);
  }

  unsubscribe(filter) {
    this.send(UNSUBSCRIBE << 4 | 2, [...this.nextId(), ...text(filter)]);
  }

  /** Resolves when the broker has the message. */
  publish(topic, payload, retain) {
    return new Promise(resolve => {
      const id = this.nextId();
      this.waiting.set(id[0] << 8 | id[1], resolve);
      this.send(PUBLISH << 4 | 2 | (retain ? 1 : 0), [...text(topic), ...id, ...payload]);
    });
  }

  ping() {
    if (this.pingSent || this.socket.readyState !== WebSocket.OPEN) return;
    this.pingSent = performance.now();
    this.send(PINGREQ << 4, []);
  }

  /** Time since anything was heard [ms]. */
  silenceMs() {
    return performance.now() - this.heardAt;
  }

  end() {
    if (this.socket.readyState === WebSocket.OPEN) this.send(DISCONNECT << 4, []);
    this.abandon();
  }

  /** Closes without waiting for a peer that may be gone. */
  abandon() {
    this.socket.onclose = null;
    this.socket.onmessage = null;
    this.socket.onopen = null;
    this.socket.close();
    this.events.closed();
  }

  nextId() {
    do this.lastId = this.lastId % 0xffff + 1; while (this.waiting.has(this.lastId));
    return [this.lastId >> 8, this.lastId & 0xff];
  }

  send(first, body) {
    if (this.socket.readyState !== WebSocket.OPEN) return;
    const head = [first];
    let rest = body.length;
    do {
      head.push(rest % 128 | (rest > 127 ? 0x80 : 0));
      rest = Math.floor(rest / 128);
    } while (rest > 0);
    const packet = Uint8Array.from([...head, ...body]);
    for (let at = 0; at < packet.length; at += LONGEST_FRAME) {
      this.socket.send(packet.subarray(at, at + LONGEST_FRAME));
    }
  }

  receive(bytes) {
    this.heardAt = performance.now();
    this.parts.push(bytes);
    this.missing -= bytes.length;
    if (this.missing > 0) return;
    const data = joined([this.received, ...this.parts]);
    this.parts = [];
    this.missing = 0;
    let at = 0;
    for (;;) {
      let length = 0;
      let digits = 0;
      let digit = 0x80;
      while (digit & 0x80 && digits < 4 && at + 1 + digits < data.length) {
        digit = data[at + 1 + digits];
        length += (digit & 0x7f) * 128 ** digits++;
      }
      if (length > LONGEST_PACKET) return this.abandon();
      const start = at + 1 + digits;
      if (digit & 0x80) break;
      if (start + length > data.length) {
        this.missing = start + length - data.length;
        break;
      }
      this.packet(data[at], data.subarray(start, start + length));
      at = start + length;
    }
    this.received = data.slice(at);
  }

  packet(first, body) {
    switch (first >> 4) {
      case CONNACK: return this.events.connected(body[1]);
      case PUBLISH: return this.published(first, body);
      case PUBACK: return this.acknowledged(body[0] << 8 | body[1]);
      case PINGRESP: {
        const sent = this.pingSent;
        this.pingSent = 0;
        return this.events.alive(performance.now() - sent);
      }
      case SUBACK:
        if (body.subarray(2).some(code => code === 0x80)) this.events.refusedFilter();
        return undefined;
      default: return undefined;
    }
  }

  published(first, body) {
    const length = body[0] << 8 | body[1];
    const topic = decoder.decode(body.subarray(2, 2 + length));
    let at = 2 + length;
    if (first >> 1 & 3) {
      this.send(PUBACK << 4, [body[at], body[at + 1]]);
      at += 2;
    }
    this.events.message(topic, body.slice(at), (first & 1) === 1);
  }

  acknowledged(id) {
    const resolve = this.waiting.get(id);
    this.waiting.delete(id);
    if (resolve) resolve();
  }
}

function joined(parts) {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

function text(value) {
  const bytes = encoder.encode(value);
  return [bytes.length >> 8, bytes.length & 0xff, ...bytes];
}
