// What the map shows of a vehicle, from the bottom up.

const OCCUPIED = 0; // log odds above are more likely occupied
const UNKNOWN = -128;
const SIGMAS = 2;
const AHEAD_S = 10; // how far the line ahead of a moving object reaches

/** Draws one vehicle. `route` is the mission as the editor has it. */
export function drawVehicle(map, vehicle, route, isSelected, layers) {
  const {colours} = map;
  if (isSelected) {
    if (layers.cells) drawCells(map, vehicle);
    if (layers.areas) drawAreas(map, route);
    for (const object of vehicle.objects) {
      const isMoving = object.xDot !== undefined || (object.type || []).includes('MovingSphere');
      if (isMoving && layers.traffic) drawTraffic(map, vehicle.place, object);
      else if (!isMoving && layers.objects) drawObject(map, vehicle.place, object);
    }
    for (const plan of layers.plan ? vehicle.plans.values() : []) {
      map.line(placed(vehicle.place, plan.referenceFrame, plan.points || []), plan.status === 'FOLLOWED' ? colours.plan : colours.warn, 2, [6, 4]);
    }
    if (layers.route) drawRoute(map, route);
  }
  const {pose} = vehicle.place;
  if (!pose) return;
  if (layers.trail) map.line([...vehicle.trail, pose], isSelected ? colours.accent : colours.dim, 2);
  if (isSelected) drawNavigation(map, vehicle, pose);
  const {state} = vehicle;
  if (isSelected && layers.uncertainty && state.xSigma !== undefined && state.ySigma !== undefined) {
    const [east, north] = state.referenceFrame === 'LOCAL_NED' ? [state.ySigma, state.xSigma] : [state.xSigma, state.ySigma];
    map.ellipse(pose, SIGMAS * east, SIGMAS * north, colours.accent, {dash: [3, 3]});
  }
  map.arrow(pose, pose.heading, vehicle.isStale() ? colours.dim : isSelected ? colours.accent : colours.text);
  if (!isSelected) map.label(vehicle.id, offset(map.toScreen(pose), 14), colours.text);
}

/** All places of interest of a vehicle. */
export function extent(vehicle, route) {
  const points = route.flatMap(goal => [goal.at, ...goal.outline]).filter(Boolean);
  if (vehicle.place.pose) points.push(vehicle.place.pose);
  return points;
}

function offset({x, y}, dx) {
  return {x: x + dx, y: y + 4};
}

function placed(place, frame, points) {
  return points.map(([x, y]) => place.of(frame, x, y)).filter(Boolean);
}

function drawNavigation(map, vehicle, pose) {
  const {navigation} = vehicle;
  if (!navigation || performance.now() - vehicle.navigationAt > 1000) return;
  const [x, y] = navigation.point;
  const at = vehicle.place.of(navigation.referenceFrame || 'BODY', x, y);
  if (!at) return;
  map.line([pose, at], map.colours.good, 1, [2, 3]);
  map.ellipse(at, 0, 0, map.colours.good, {minPx: 4});
}

function drawRoute(map, route) {
  const {colours} = map;
  const placedGoals = route.filter(goal => goal.at);
  for (const goal of route.filter(each => each.anchor)) {
    goal.followers.filter(next => next.anchor).forEach(next => map.line([goal.anchor, next.anchor], colours.goal, 1.5));
  }
  const open = goal => (goal.isCurrent || goal.isSelected ? 2 : goal.isDone ? 0 : 1);
  const labelled = new Set(); // several goals may be at one place
  const labels = [...placedGoals].sort((a, b) => open(b) - open(a)).filter(goal => {
    const place = `${goal.at.x.toFixed(1)} ${goal.at.y.toFixed(1)}`;
    return !labelled.has(place) && labelled.add(place);
  });
  for (const goal of labels.reverse()) {
    const colour = goal.isChanged ? colours.warn : goal.isCurrent ? colours.good : goal.isDone ? colours.dim : colours.goal;
    map.ellipse(goal.at, goal.radius, goal.radius, colour, {dash: [2, 3]});
    map.ellipse(goal.at, 0, 0, colour, {minPx: goal.isSelected ? 10 : 7, isFilled: true});
    map.label(goal.uid, offset(map.toScreen(goal.at), 12), colour);
  }
}

function drawObject(map, place, object) {
  const at = place.of(object.referenceFrame, object.x, object.y);
  if (!at) return;
  const colour = object.level === 'HINDRANCE' ? map.colours.dim : map.colours.object;
  const points = placed(place, object.referenceFrame, object.points || []);
  const isLine = (object.type || []).includes('PolyLine');
  if (points.length > 1 && isLine) map.line(points, colour, 2);
  else if (points.length > 2) map.area(points, colour);
  else if (object.length !== undefined && object.width !== undefined) map.area(corners(place, at, object), colour);
  else map.ellipse(at, object.radius || 0, object.radius || 0, colour, {isFilled: true, minPx: 3});
  if (map.scale > 4 && object.objectType) map.label(object.objectType, offset(map.toScreen(at), 8), colour);
}

/** A moving object: its separation, its 2σ, and where it will be. */
function drawTraffic(map, place, object) {
  const frame = object.referenceFrame || 'GLOBAL';
  const at = place.of(frame, object.x, object.y);
  if (!at) return;
  const {xDot = 0, yDot = 0, xSigma, ySigma} = object;
  const colour = map.colours.bad;
  if (object.radius) map.ellipse(at, object.radius, object.radius, colour, {dash: [6, 4]});
  if (xSigma !== undefined && ySigma !== undefined) map.ellipse(at, SIGMAS * xSigma, SIGMAS * ySigma, colour, {dash: [2, 3]});
  const speed = Math.hypot(xDot, yDot);
  const isEastFirst = frame === 'GLOBAL' || frame.startsWith('UTM');
  const course = isEastFirst ? Math.atan2(xDot, yDot) : place.heading(frame, Math.atan2(yDot, xDot));
  if (speed > 0 && course !== undefined) {
    const reach = speed * AHEAD_S;
    map.line([at, {x: at.x + reach * Math.sin(course), y: at.y + reach * Math.cos(course)}], colour, 1.5);
  }
  map.arrow(at, speed > 0 ? course : undefined, colour);
  map.label([object.objectType || object.uid, speed > 0 ? speed.toFixed(1) + ' m/s' : ''].filter(Boolean).join(' '), offset(map.toScreen(at), 14), colour);
}

/** Goals of any class with points are areas or lines to be covered. */
function drawAreas(map, route) {
  for (const {outline, isDone, isChanged, isSelected, uid} of route) {
    const colour = isChanged ? map.colours.warn : isDone ? map.colours.dim : map.colours.goal;
    if (outline.length > 2) map.area(outline, colour);
    else map.line(outline, colour, 2);
    if (outline.length > 0) map.label(uid, offset(map.toScreen(outline[0]), 10), isSelected ? map.colours.text : colour);
  }
}

function corners(place, at, {length, width, psi = 0, referenceFrame = 'GLOBAL'}) {
  const heading = place.heading(referenceFrame, psi) || 0;
  const sin = Math.sin(heading);
  const cos = Math.cos(heading);
  return [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([a, b]) => ({
    x: at.x + (a * length * sin + b * width * cos) / 2,
    y: at.y + (a * length * cos - b * width * sin) / 2,
  }));
}

function drawCells(map, vehicle) {
  const {grid} = vehicle;
  if (!grid) return;
  const anchor = vehicle.place.of(grid.referenceFrame, grid.x, grid.y);
  if (!anchor || (grid.referenceFrame || 'GLOBAL').startsWith('BODY') || grid.referenceFrame === 'LOCAL_NED') return;
  if (!grid.image) grid.image = cellsImage(grid, map.colours);
  map.image(grid.image, {x: anchor.x + (grid.left || 0), y: anchor.y + (grid.bottom || 0)}, grid.columns * grid.resolution, grid.rows * grid.resolution);
}

function cellsImage({cells, columns, rows}, colours) {
  const canvas = document.createElement('canvas');
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext('2d');
  const image = context.createImageData(columns, rows);
  const [occupied, free] = [rgb(colours.object), rgb(colours.good)];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const cell = cells[row * columns + column];
      if (cell === UNKNOWN) continue;
      const at = ((rows - 1 - row) * columns + column) * 4;
      image.data.set(cell > OCCUPIED ? occupied : free, at);
      image.data[at + 3] = cell > OCCUPIED ? Math.min(220, 60 + cell * 4) : 24;
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

/** The channels of "#rrggbb", as the style sheet writes colours. */
function rgb(colour) {
  const number = parseInt(colour.trim().slice(1), 16);
  return [number >> 16, number >> 8 & 0xff, number & 0xff];
}
