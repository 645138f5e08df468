// Places on the map: metres east and north of a vehicle's first position.

const A = 6378137.0; // WGS-84, semi-major axis [m]
const E2 = 6.69437999014e-3; // first eccentricity squared
const DEG = Math.PI / 180;

/** Converts frames to the map's axes. GLOBAL is projected at the origin: within 0.1 % up to 40 km. */
export class Place {
  constructor() {
    this.origin = null; // {frame, x, y, perX, perY}: metres per unit
    this.pose = null; // the vehicle's {x, y, heading}
  }

  /** The vehicle's place with heading [rad, clockwise from north]; undefined without a position. */
  ofState(state) {
    if (state.x === undefined || state.y === undefined) return undefined;
    const frame = state.referenceFrame || 'GLOBAL';
    if (!this.origin || this.origin.frame !== frame) this.origin = origin(frame, state.x, state.y);
    const at = this.of(frame, state.x, state.y);
    if (!at) return undefined;
    this.pose = {...at, heading: this.heading(frame, state.psi)};
    return this.pose;
  }

  /** Direction on the map [rad, clockwise from north] of an angle as the frame measures psi. */
  heading(frame, psi) {
    if (psi === undefined) return undefined;
    if (frame === 'LOCAL_ENU') return Math.PI / 2 - psi;
    if (frame.startsWith('BODY')) {
      const back = frame === 'BODY_FRD' ? psi : -psi;
      return this.pose && this.pose.heading !== undefined ? this.pose.heading + back : undefined;
    }
    return psi;
  }

  /** A point on the map; undefined if its frame cannot be placed. */
  of(frame = 'GLOBAL', x, y) {
    if (frame.startsWith('BODY')) return this.ofBody(frame, x, y);
    if (!this.origin || this.origin.frame !== frame) return undefined;
    const east = frame === 'LOCAL_NED' ? y : x;
    const north = frame === 'LOCAL_NED' ? x : y;
    const across = frame === 'GLOBAL' ? wrapped(east - this.origin.x) : east - this.origin.x;
    return {x: across * this.origin.perX, y: (north - this.origin.y) * this.origin.perY};
  }

  ofBody(frame, forward, y) {
    const {pose} = this;
    if (!pose || pose.heading === undefined) return undefined;
    const left = frame === 'BODY_FRD' ? -y : y;
    const sin = Math.sin(pose.heading);
    const cos = Math.cos(pose.heading);
    return {x: pose.x + forward * sin - left * cos, y: pose.y + forward * cos + left * sin};
  }

  /** Coordinates in the map's own frame, as messages have them. */
  inFrame({x, y}) {
    const {frame, perX, perY, x: x0, y: y0} = this.origin;
    const east = frame === 'GLOBAL' ? wrapped(x0 + x / perX) : x0 + x / perX;
    const north = y0 + y / perY;
    return frame === 'LOCAL_NED' ? {frame, x: north, y: east} : {frame, x: east, y: north};
  }
}

/** The same longitude within ±180°. */
function wrapped(degrees) {
  return degrees > 180 ? degrees - 360 : degrees < -180 ? degrees + 360 : degrees;
}

function origin(frame, x, y) {
  if (frame !== 'GLOBAL') {
    return frame === 'LOCAL_NED' ? {frame, x: 0, y: 0, perX: 1, perY: 1} : {frame, x: frame.startsWith('UTM') ? x : 0, y: frame.startsWith('UTM') ? y : 0, perX: 1, perY: 1};
  }
  const s = Math.sin(y * DEG);
  const w = Math.sqrt(1 - E2 * s * s);
  const prime = A / w; // radius of curvature in the prime vertical (Snyder 1987, eq. 4-20)
  const meridian = A * (1 - E2) / w ** 3; // in the meridian (eq. 4-19)
  return {frame, x, y, perX: DEG * prime * Math.cos(y * DEG), perY: DEG * meridian};
}
