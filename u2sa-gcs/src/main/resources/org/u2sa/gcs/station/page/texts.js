// Texts of the page that depend on what happens; the others are in index.html. Both for translators.

export const texts = {
  layers: {
    coast: 'Coastline', cells: 'Occupancy', objects: 'Objects', traffic: 'Traffic and separation', areas: 'Search areas', plan: 'Plan', route: 'Mission', trail: 'Trail', uncertainty: 'Uncertainty',
  },
  measured: (length, bearing, sum) => `${distance(length)}, ${bearing.toFixed(0)}°${sum === undefined ? '' : ', total ' + distance(sum)}`,
  add: 'Add',
  adding: 'Tap the map',
  drawing: 'End of area',
  states: {refused: 'refused', removed: 'to be removed', changed: 'changed', current: 'current', aside: 'not on the way'},
  name: 'name',
  required: 'required',
  ifAbsent: value => `${value} if empty`,
  kinds: {texts: 'names, separated by commas', points: 'corners “x y”, separated by semicolons; or drag them on the map', point: '“x y” or “x y z”', int: 'a whole number'},
  chooseGoal: 'choose a goal first',
  noPlace: 'there is no goal on that side',
  skipInstead: 'the vehicle is on its way there: skip it instead',
  branching: 'goals have conditions, repetitions or several followers: edit their field “next”, or the file',
  askReplace: (vehicle, file) => `Replace the mission of ${vehicle} by ${file}? It holds until you press Continue, and begins with the first goal.`,
  wholeDraft: file => `${file}: a mission of its own. Upload replaces the vehicle's.`,
  opened: file => `${file} opened`,
  saved: file => `${file} saved on this device`,
  tooLong: file => `${file} is longer than 60 kB`,
  unknownClass: 'the vehicle has not named the fields of all classes of goals',
  inFailsafe: 'a failsafe’s goals are pursued: save the mission when it continues',
  noAnswer: 'no answer from the vehicle within 5 s: this user may lack the role operator, or nobody there handles it',
  nothingChanged: 'no value was changed',
  anotherChannel: 'another channel…',
  remove: name => `Remove ${name}`,
  noPicture: reason => `a picture cannot be shown: ${reason}`,
  asking: 'asking the service…',
  on: ' on ',
  otherPackages: 'made for other vehicles or tasks',
  revision: number => `revision ${number}`,
  silent: time => `silent ${time}`,
  stopped: name => `${name} has stopped`,
  ordered: (name, action) => `${name}: ${{START: 'started', RESTART: 'restarted', SWAP: 'swapped'}[action]}`,
  askRestart: name => `Restart ${name}? The vehicle does without it meanwhile.`,
  askStop: name => `Stop ${name}? The vehicle may enter a failsafe.`,
  askSwap: (name, className) => `Run ${name} as ${className}? It takes over in motion.`,
};

export function distance(metres) {
  return metres < 1000 ? metres.toFixed(1) + ' m' : (metres / 1000).toFixed(2) + ' km';
}
