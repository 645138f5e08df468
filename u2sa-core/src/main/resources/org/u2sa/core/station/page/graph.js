// Data flow: services that publish, channels, services that subscribe. Choosing a service shows its share only.

import {byId} from './dom.js';

const ROW = 26;
const WIDTH = 470;
const COLUMNS = [0, 180, 340]; // left ends of the columns
const LENGTHS = [18, 15, 18];
const EVERYWHERE = ['health', 'discovery', 'functionality', 'configuration', 'stop'];

/** Draws the answers to a FunctionalityRequest. */
export function drawGraph(vehicle, chosen, choose) {
  const flows = [...vehicle.functions.values()].flatMap(({serviceName, publishes, subscribes}) => [
    ...names(publishes).map(channel => ({serviceName, channel, isOut: true})),
    ...names(subscribes).map(channel => ({serviceName, channel, isOut: false})),
  ]).filter(flow => !chosen || flow.serviceName === chosen || isJoined(vehicle, flow.channel, chosen));
  const key = JSON.stringify([flows, chosen]);
  const graph = byId('graph');
  if (graph.dataset.key === key) return;
  graph.dataset.key = key;
  const columns = [unique(flows.filter(flow => flow.isOut), 'serviceName'), unique(flows, 'channel'), unique(flows.filter(flow => !flow.isOut), 'serviceName')];
  const height = ROW * Math.max(1, ...columns.map(column => column.length));
  const y = (column, name) => (columns[column].indexOf(name) + 0.5) * height / columns[column].length;
  graph.setAttribute('viewBox', `0 0 ${WIDTH} ${height}`);
  graph.replaceChildren(
    ...flows.map(({serviceName, channel, isOut}) => {
      const [from, to] = isOut ? [[0, serviceName], [1, channel]] : [[1, channel], [2, serviceName]];
      const [x1, x2] = [COLUMNS[from[0]] + 7 * LENGTHS[from[0]], COLUMNS[to[0]] - 3];
      const [y1, y2] = [y(...from), y(...to)];
      return shape('path', {d: `M${x1} ${y1}C${x1 + 25} ${y1} ${x2 - 25} ${y2} ${x2} ${y2}`, class: serviceName === chosen ? 'chosen' : ''});
    }),
    ...columns.flatMap((column, i) => column.map(name => label(name, COLUMNS[i], y(i, name), LENGTHS[i], i === 1 ? null : () => choose(name), name === chosen))),
  );
}

function isJoined(vehicle, channel, service) {
  const own = vehicle.functions.get(service);
  return own !== undefined && [...names(own.publishes), ...names(own.subscribes)].includes(channel);
}

function names(lines) {
  return [...new Set(lines.map(line => line.split('/')[0]))].filter(name => !EVERYWHERE.includes(name));
}

function unique(flows, field) {
  return [...new Set(flows.map(flow => flow[field]))].sort();
}

function label(name, x, y, length, action, isChosen) {
  const text = shape('text', {x, y: y + 4, class: [action ? 'service' : 'channel', isChosen ? 'chosen' : ''].join(' ')});
  text.textContent = name.length > length ? name.slice(0, length - 1) + '…' : name;
  const title = shape('title', {});
  title.textContent = name;
  text.append(title);
  if (action) {
    text.setAttribute('tabindex', 0);
    text.setAttribute('role', 'button');
    text.onclick = action;
    text.onkeydown = event => { if (event.key === 'Enter') action(); };
  }
  return text;
}

function shape(name, attributes) {
  const made = document.createElementNS(byId('graph').namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}
