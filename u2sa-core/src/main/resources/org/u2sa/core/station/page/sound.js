// What the page takes of a message: a service may send anything, and what is left out is as if never sent.

const isText = value => typeof value === 'string';
const isPoint = value => Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
const isMessage = value => value !== null && typeof value === 'object' && !Array.isArray(value) && !ArrayBuffer.isView(value);
const listOf = isElement => value => Array.isArray(value) && value.every(isElement);

/** What the fields that the page reads must be. `current` is a number or a list, by the message. */
const EXPECTED = new Map([
  [Number.isFinite, 'x y z xDot yDot zDot phi theta psi xSigma ySigma radius length width horizontalThreshold timeLimit remaining voltage elapsed callbackP99 interval timestamp dropped missed exceptions left bottom resolution columns rows revision'],
  [isText, 'uid referenceFrame objectType level status condition reason action operator serviceName sensorName subsystem lastError mission failsafe result description repeatFrom'],
  [listOf(isText), 'type next nextIfDone nextIfFailed nextIfTimedOut sequence emergencyStops remarks reasons causes cells'],
  [isPoint, 'point'],
  [listOf(isPoint), 'points'],
  [listOf(isMessage), 'goals upcoming objects'],
].flatMap(([isExpected, names]) => names.split(' ').map(name => [name, isExpected])));

/** The fields of a message without those that are not what they must be; so too in messages within it. */
export function sound(fields) {
  const kept = Object.entries(fields).filter(([name, value]) => !EXPECTED.has(name) || EXPECTED.get(name)(value));
  return Object.fromEntries(kept.map(([name, value]) => [name, listOf(isMessage)(value) ? value.map(sound) : value]));
}
