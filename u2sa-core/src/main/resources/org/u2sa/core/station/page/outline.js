// Handles of a closed line on the map: its corners, and the middles of its sides, which become corners.

/** Handles near a place: {index, isNew, at}; null if there is none. `isNear`: of two places. */
export function handleAt(corners, at, isNear) {
  const corner = corners.findIndex(each => isNear(each, at));
  if (corner >= 0) return {index: corner, isNew: false, at: corners[corner]};
  const middles = middlesOf(corners);
  const middle = middles.findIndex(each => isNear(each, at));
  return middle >= 0 ? {index: middle + 1, isNew: true, at: middles[middle]} : null;
}

/** The corners with one moved, or inserted. */
export function withHandle(corners, {index, isNew}, at) {
  return [...corners.slice(0, index), at, ...corners.slice(isNew ? index : index + 1)];
}

export function drawHandles(map, corners, colour, chosen) {
  for (const middle of middlesOf(corners)) map.ellipse(middle, 0, 0, colour, {minPx: 3});
  corners.forEach((corner, i) => map.ellipse(corner, 0, 0, colour, {minPx: i === chosen ? 10 : 6, isFilled: true}));
}

function middlesOf(corners) {
  if (corners.length < 2) return [];
  return corners.map((a, i) => {
    const b = corners[(i + 1) % corners.length];
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2};
  });
}
