// A base map of raster tiles from a PMTiles file (version 3) that the vehicle serves by ranges. Nothing is fetched from elsewhere.

const FILE = '/tiles.pmtiles';
const HEADER_BYTES = 127;
const GZIP = 2;
const RASTER = [2, 3, 4, 5]; // PNG, JPEG, WebP, AVIF
const MAX_TILES = 200; // kept
const MAX_SHOWN = 80;
const MAX_PENDING = 6;
const MAX_DIRECTORY = 1 << 20; // bytes, also uncompressed
const TILE_PX = 256;
const AGAIN_MS = 5000; // after a failure, such as a busy vehicle
const CIRCUMFERENCE_M = 40075016.69;
const DEG = Math.PI / 180;

let header; // undefined: not asked for; null: no file
const directories = new Map(); // offset -> promise of entries
const tiles = new Map(); // ID -> bitmap, or null while it is fetched or if there is none
let pending = 0;

async function range(offset, length) {
  const response = await fetch(FILE, {headers: {Range: `bytes=${offset}-${offset + length - 1}`}});
  if (response.status !== 206) throw new Error(`${FILE}: status ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

async function open() {
  const bytes = await range(0, HEADER_BYTES);
  const view = new DataView(bytes.buffer);
  const long = at => Number(view.getBigUint64(at, true));
  if (new TextDecoder().decode(bytes.subarray(0, 7)) !== 'PMTiles' || bytes[7] !== 3) throw new Error('no PMTiles file of version 3');
  if (!RASTER.includes(bytes[99])) throw new Error('its tiles are no pictures');
  return {root: [long(8), long(16)], leaves: long(40), data: long(56), compression: bytes[97], minZoom: bytes[100], maxZoom: Math.min(bytes[101], 24)};
}

function directory(offset, length) {
  if (length > MAX_DIRECTORY) throw new Error('a directory is too long');
  if (!directories.has(offset)) {
    directories.set(offset, range(offset, length).then(unzipped).then(entries));
    directories.get(offset).catch(() => directories.delete(offset));
  }
  return directories.get(offset);
}

async function unzipped(bytes) {
  if (header.compression !== GZIP) return bytes;
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')).getReader();
  const parts = [];
  let length = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    length += part.value.length;
    if (length > 8 * MAX_DIRECTORY) throw new Error('a directory is too long');
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** Entries {id, run, length, offset}, ascending by ID. */
function entries(bytes) {
  let at = 0;
  const number = () => {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = bytes[at++];
      if (byte === undefined || factor > 2 ** 49) throw new Error('a directory is malformed');
      value += (byte & 0x7f) * factor;
      if (byte < 0x80) return value;
    }
  };
  const count = number();
  if (count > bytes.length) throw new Error('a directory is malformed');
  const list = Array.from({length: count}, () => ({}));
  let id = 0;
  for (const entry of list) entry.id = id += number();
  for (const entry of list) entry.run = number();
  for (const entry of list) entry.length = number();
  list.forEach((entry, i) => {
    const offset = number();
    entry.offset = offset === 0 && i > 0 ? list[i - 1].offset + list[i - 1].length : offset - 1;
  });
  return list;
}

/** Number of a tile along the Hilbert curve of its zoom, behind all lower zooms. */
function tileId(z, x, y) {
  let id = (4 ** z - 1) / 3;
  let [px, py] = [x, y];
  for (let s = 2 ** (z - 1); s >= 1; s /= 2) {
    const rx = px & s ? 1 : 0;
    const ry = py & s ? 1 : 0;
    id += s * s * ((3 * rx) ^ ry);
    if (ry === 0) {
      if (rx === 1) [px, py] = [s - 1 - px, s - 1 - py];
      [px, py] = [py, px];
    }
  }
  return id;
}

async function load(id) {
  let [offset, length] = header.root;
  for (let depth = 0; depth < 4; depth++) {
    const list = await directory(offset, length);
    const entry = list.filter(each => each.id <= id).pop();
    if (!entry || entry.run > 0 && id >= entry.id + entry.run) return null;
    if (entry.run > 0) return createImageBitmap(new Blob([await range(header.data + entry.offset, entry.length)]));
    [offset, length] = [header.leaves + entry.offset, entry.length];
  }
  return null;
}

function tile(id, changed) {
  if (!tiles.has(id) && pending < MAX_PENDING) {
    if (tiles.size >= MAX_TILES) tiles.delete(tiles.keys().next().value);
    tiles.set(id, null);
    pending++;
    load(id).then(picture => {
      tiles.set(id, picture);
      changed();
    }, () => setTimeout(() => tiles.delete(id), AGAIN_MS)).finally(() => { pending--; });
  }
  return tiles.get(id);
}

const column = (longitude, z) => (longitude / 360 + 0.5) * 2 ** z;
const row = (latitude, z) => (0.5 - Math.asinh(Math.tan(latitude * DEG)) / (2 * Math.PI)) * 2 ** z;
const longitudeOf = (x, z) => (x / 2 ** z - 0.5) * 360;
const latitudeOf = (y, z) => Math.atan(Math.sinh(Math.PI * (1 - 2 * y / 2 ** z))) / DEG;

/** Draws what there is of the base map; fetches the rest. `changed`: called when more has arrived. */
export function drawTiles(map, place, changed) {
  if (!place.origin || place.origin.frame !== 'GLOBAL') return;
  if (header === undefined) {
    header = null;
    open().then(opened => {
      header = opened;
      changed();
    }, () => undefined); // without a file the grid remains
  }
  if (!header) return;
  const [left, right, bottom, top] = map.seen();
  const [low, high] = [place.inFrame({x: left, y: bottom}), place.inFrame({x: right, y: top})];
  if (!(high.x - low.x < 360 && low.y > -85 && high.y < 85)) return;
  const metres = CIRCUMFERENCE_M * Math.cos((low.y + high.y) / 2 * DEG);
  const zoom = Math.round(Math.log2(metres * map.scale / TILE_PX));
  const z = Math.min(header.maxZoom, Math.max(header.minZoom, zoom));
  const [x0, x1, y0, y1] = [column(low.x, z), column(high.x, z), row(high.y, z), row(low.y, z)].map(Math.floor);
  if ((x1 - x0 + 1) * (y1 - y0 + 1) > MAX_SHOWN) return;
  for (let x = x0; x <= x1; x++) {
    for (let y = y0; y <= y1; y++) {
      const picture = tile(tileId(z, (x + 2 ** z) % 2 ** z, y), changed);
      const corner = place.of('GLOBAL', longitudeOf(x, z), latitudeOf(y + 1, z));
      const other = place.of('GLOBAL', longitudeOf(x + 1, z), latitudeOf(y, z));
      if (picture) map.image(picture, corner, other.x - corner.x, other.y - corner.y);
    }
  }
}
