// What a page may spend on messages: decoding and drawing share the thread that sends the emergency stop.

const DRAWN = {largest: 128 * 1024, perS: 256 * 1024}; // bytes: some 600 objects
const PICTURES = {largest: 1024 * 1024, perS: 4 * 1024 * 1024};
const OTHER = {largest: 1024 * 1024, perS: 256 * 1024}; // the longest message that the broker takes
const LIMITS = {objects: DRAWN, grid: DRAWN, plans: DRAWN, images: PICTURES};
const UNLIMITED = ['emergency-stop', 'arming-state', 'failsafe']; // services have no right to write there

/** Limits the bytes of each channel. */
export class Budget {
  constructor() {
    this.left = new Map(); // channel -> {bytes, at}
    this.skipped = 0; // messages that were too much
  }

  /** Whether a message may be decoded. `nowMs` is a monotonic time. */
  allows(channel, bytes, nowMs) {
    if (UNLIMITED.includes(channel)) return true;
    const {largest, perS} = LIMITS[channel] || OTHER;
    const before = this.left.get(channel) || {bytes: largest, at: nowMs};
    const refilled = Math.min(largest, before.bytes + perS * (nowMs - before.at) / 1000);
    const isAllowed = bytes <= refilled;
    this.left.set(channel, {bytes: refilled - (isAllowed ? bytes : 0), at: nowMs});
    if (!isAllowed) this.skipped++;
    return isAllowed;
  }
}
