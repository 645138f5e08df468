// What a page may spend on drawing: decoding and drawing share the thread that sends the emergency stop.

const DISPLAY_ONLY = ['objects', 'grid', 'plans'];
const LARGEST = 128 * 1024; // bytes of a message: some 600 objects
const BYTES_PER_S = 256 * 1024; // of a channel

/** Limits the bytes of the channels that are only drawn. */
export class Budget {
  constructor() {
    this.left = new Map(); // channel -> {bytes, at}
    this.skipped = 0; // messages that were too much
  }

  /** Whether a message may be decoded. `nowMs` is a monotonic time. */
  allows(channel, bytes, nowMs) {
    if (!DISPLAY_ONLY.includes(channel)) return true;
    const before = this.left.get(channel) || {bytes: LARGEST, at: nowMs};
    const refilled = Math.min(LARGEST, before.bytes + BYTES_PER_S * (nowMs - before.at) / 1000);
    const isAllowed = bytes <= refilled;
    this.left.set(channel, {bytes: refilled - (isAllowed ? bytes : 0), at: nowMs});
    if (!isAllowed) this.skipped++;
    return isAllowed;
  }
}
