// CBOR (RFC 8949) as the wire protocol uses it: maps of field names to values; docs/wire-protocol.md.

const MAX_DEPTH = 16;
const texts = new TextDecoder('utf-8', {fatal: true});

/** Reads one item. Throws if it is malformed or bytes follow. */
export function decode(bytes) {
  const reader = new Reader(bytes);
  const value = reader.item(0);
  if (reader.at !== bytes.length) throw new Error('bytes after the item');
  return value;
}

class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }

  item(depth) {
    if (depth > MAX_DEPTH) throw new Error('nested too deeply');
    const first = this.view.getUint8(this.at++);
    const major = first >> 5;
    const info = first & 31;
    if (major === 7) return this.simple(info);
    if (info === 31) return this.indefinite(major, depth);
    const count = this.length(info);
    switch (major) {
      case 0: return count;
      case 1: return -1 - count;
      case 2: return this.take(count);
      case 3: return texts.decode(this.take(count));
      case 4: return this.list(count, depth);
      case 5: return this.map(count, depth);
      default: return this.item(depth + 1); // a tag says nothing that the page needs
    }
  }

  length(info) {
    if (info < 24) return info;
    const bytes = 1 << (info - 24);
    const at = this.at;
    this.at += bytes;
    switch (bytes) {
      case 1: return this.view.getUint8(at);
      case 2: return this.view.getUint16(at);
      case 4: return this.view.getUint32(at);
      case 8: return Number(this.view.getBigUint64(at));
      default: throw new Error('malformed length');
    }
  }

  take(count) {
    if (count > this.bytes.length - this.at) throw new Error('truncated');
    return this.bytes.subarray(this.at, this.at += count);
  }

  list(count, depth) {
    if (count > this.bytes.length - this.at) throw new Error('truncated');
    const list = [];
    for (let i = 0; i < count; i++) list.push(this.item(depth + 1));
    return list;
  }

  map(count, depth) {
    if (count > this.bytes.length - this.at) throw new Error('truncated');
    const map = Object.create(null); // a field may be named "__proto__"
    for (let i = 0; i < count; i++) this.pair(map, depth);
    return map;
  }

  /** A field whose name is a number is in the compact form. */
  pair(map, depth) {
    const key = this.item(depth + 1);
    map[typeof key === 'number' ? '#' + key : key] = this.item(depth + 1);
  }

  indefinite(major, depth) {
    const list = [];
    const map = Object.create(null);
    while (this.view.getUint8(this.at) !== 0xff) {
      if (major === 5) this.pair(map, depth);
      else list.push(this.item(depth + 1));
    }
    this.at++;
    if (major === 3) return list.join('');
    if (major === 4) return list;
    if (major === 5) return map;
    throw new Error('indefinite length');
  }

  simple(info) {
    const at = this.at;
    switch (info) {
      case 20: return false;
      case 21: return true;
      case 22: case 23: return null;
      case 26: this.at += 4; return this.view.getFloat32(at);
      case 27: this.at += 8; return this.view.getFloat64(at);
      default: throw new Error('simple value ' + info);
    }
  }
}

/** Writes a map of texts, booleans, numbers (as float64), bigints (as integers, not negative), lists and maps. */
export function encode(fields) {
  const out = [];
  map(out, fields);
  return Uint8Array.from(out);
}

function map(out, fields) {
  const names = Object.keys(fields).filter(name => fields[name] !== undefined);
  head(out, 5, names.length);
  for (const name of names) {
    write(out, name);
    write(out, fields[name]);
  }
}

function write(out, value) {
  if (typeof value === 'boolean') {
    out.push(value ? 0xf5 : 0xf4);
  } else if (typeof value === 'number') {
    out.push(0xfb);
    const bytes = new Uint8Array(8);
    new DataView(bytes.buffer).setFloat64(0, value);
    out.push(...bytes);
  } else if (typeof value === 'bigint') {
    head(out, 0, Number(value));
  } else if (Array.isArray(value)) {
    head(out, 4, value.length);
    value.forEach(each => write(out, each));
  } else if (typeof value === 'object') {
    map(out, value);
  } else {
    const bytes = new TextEncoder().encode(value);
    head(out, 3, bytes.length);
    for (const byte of bytes) out.push(byte);
  }
}

function head(out, major, count) {
  const type = major << 5;
  if (count < 24) out.push(type | count);
  else if (count < 0x100) out.push(type | 24, count);
  else if (count < 0x10000) out.push(type | 25, count >> 8, count & 0xff);
  else if (count < 0x100000000) out.push(type | 26, count >>> 24, count >> 16 & 0xff, count >> 8 & 0xff, count & 0xff);
  else {
    const bytes = new Uint8Array(8);
    new DataView(bytes.buffer).setBigUint64(0, BigInt(count));
    out.push(type | 27, ...bytes);
  }
}
