// Histories of numeric fields, for plots.

const KEPT_S = 600;
const EVERY_MS = 50;
const MAX_SERIES = 12;
const MAX_FIELDS = 2000; // offered for choice
const MAX_KEY = 200;
const MAX_DEPTH = 3;

/** Records the chosen fields of a vehicle's messages, and knows which fields there are. Times are the page's [ms]. */
export class SeriesBook {
  constructor() {
    this.fields = new Map(); // key -> latest value
    this.series = new Map(); // key -> {times, values}
  }

  add(key) {
    if (this.series.size < MAX_SERIES && !this.series.has(key)) this.series.set(key, {times: [], values: []});
  }

  /** Forgets what all curves show. */
  clear() {
    for (const key of this.series.keys()) this.series.set(key, {times: [], values: []});
  }

  /** Takes a message. A key names vehicle, channel, source and field. */
  message(system, channel, fields, now = performance.now()) {
    const source = fields.sensorName || fields.serviceName || fields.actuatorName || fields.subsystem || '';
    this.numbers(`${system} ${channel}${source ? ` [${source}]` : ''} `, fields, 0, now);
  }

  numbers(prefix, fields, depth, now) {
    for (const name of Object.keys(fields).filter(each => each !== 'timestamp')) {
      const value = fields[name];
      const key = prefix + name;
      if (key.length > MAX_KEY) continue;
      if (typeof value === 'number' || typeof value === 'boolean') this.number(key, Number(value), now);
      else if (Array.isArray(value) && value.length === 3 && value.every(each => typeof each === 'number')) value.forEach((each, i) => this.number(`${key}.${'xyz'[i]}`, each, now));
      else if (value && typeof value === 'object' && !Array.isArray(value) && !ArrayBuffer.isView(value) && depth < MAX_DEPTH) this.numbers(key + '.', value, depth + 1, now);
    }
  }

  number(key, value, now) {
    if (this.fields.has(key) || this.fields.size < MAX_FIELDS) this.fields.set(key, value);
    const series = this.series.get(key);
    if (!series || now - series.times[series.times.length - 1] < EVERY_MS) return;
    series.times.push(now);
    series.values.push(value);
    if (now - series.times[0] > KEPT_S * 1100) { // a tenth more, so that this is rare
      const first = series.times.findIndex(time => now - time <= KEPT_S * 1000);
      series.times.splice(0, first);
      series.values.splice(0, first);
    }
  }
}
