// Texts of the page that depend on what happens; the others are in index.html. Both for translators.

export const texts = {
  layers: {
    coast: 'Coastline', cells: 'Occupancy', objects: 'Objects', traffic: 'Traffic and separation', areas: 'Search areas', plan: 'Plan', route: 'Mission', trail: 'Trail', uncertainty: 'Uncertainty',
  },
  measured: (length, bearing, sum) => `${distance(length)}, ${bearing.toFixed(0)}°${sum === undefined ? '' : ', total ' + distance(sum)}`,
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
