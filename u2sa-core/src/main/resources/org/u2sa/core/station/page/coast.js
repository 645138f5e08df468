// The coastline of Natural Earth (world-atlas, land-50m, TopoJSON): accurate to about a kilometre, for orientation only.

const AROUND_M = 1.2e6; // drawn so far from the origin; the map's projection is not meant for more

let rings = null; // land as rings of [longitude, latitude]
let drawn = {origin: null, path: null};

/** The land around an origin as a path in metres of the map; null until it is loaded. */
export function land(place, loaded) {
  const {origin} = place;
  if (!origin || origin.frame !== 'GLOBAL') return null;
  if (rings === null) {
    rings = [];
    fetch('/land.json').then(answer => answer.json()).then(topology => {
      rings = decoded(topology);
      drawn = {origin: null, path: null};
      loaded();
    }).catch(() => { rings = null; }); // asked for again with the next picture, once the link is back
  }
  if (drawn.origin !== origin) drawn = {origin, path: path(origin)};
  return drawn.path;
}

function path({x, y, perX, perY}) {
  const path = new Path2D();
  for (const ring of rings) {
    let [lastX, lastY] = [NaN, NaN];
    let isInside = false;
    const points = [];
    for (const [longitude, latitude] of ring) {
      const east = ((longitude - x + 540) % 360 - 180) * perX;
      const north = (latitude - y) * perY;
      isInside ||= Math.abs(east) < AROUND_M && Math.abs(north) < AROUND_M;
      const [px, py] = [Math.max(-AROUND_M, Math.min(AROUND_M, east)), Math.max(-AROUND_M, Math.min(AROUND_M, north))];
      if (px !== lastX || py !== lastY) points.push([px, py]);
      [lastX, lastY] = [px, py];
    }
    if (!isInside) continue;
    points.forEach(([px, py], i) => (i ? path.lineTo(px, py) : path.moveTo(px, py)));
    path.closePath();
  }
  return path;
}

/** Rings of a topology: quantised arcs, each point relative to the one before (TopoJSON specification, 2.2.6). */
function decoded({arcs, transform, objects}) {
  const lines = arcs.map(arc => {
    let [x, y] = [0, 0];
    return arc.map(([dx, dy]) => [(x += dx) * transform.scale[0] + transform.translate[0], (y += dy) * transform.scale[1] + transform.translate[1]]);
  });
  const line = index => (index < 0 ? [...lines[~index]].reverse() : lines[index]);
  const polygons = objects.land.geometries.flatMap(each => (each.type === 'Polygon' ? [each.arcs] : each.arcs));
  return polygons.flat().map(ring => ring.flatMap((index, i) => (i ? line(index).slice(1) : line(index))));
}
