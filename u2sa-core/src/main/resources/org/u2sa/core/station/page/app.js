// Joins the parts: messages go into the model, the model onto the screen, buttons become orders.

import {land} from './coast.js';
import {byId} from './dom.js';
import {FenceEditor} from './fence.js';
import {MissionEditor} from './editor.js';
import {drawVehicle, extent} from './layers.js';
import {InsightTab} from './insight.js';
import {Link} from './link.js';
import {MapView} from './map.js';
import {MapTools} from './maptools.js';
import {MissionTab} from './missiontab.js';
import {Model} from './model.js';
import {Orders} from './orders.js';
import {Panel} from './panel.js';
import {Timeline} from './playback.js';
import {SeriesBook} from './series.js';
import {ServicesTab} from './services.js';
import {texts} from './texts.js';
import {drawTiles} from './tiles.js';

const PANEL_EVERY_MS = 250;
const DRAW_EVERY_MS = 40; // spares the battery of a phone
const TWICE_MS = 1000; // between two presses of Escape
const REPORT_EVERY_MS = 2000;
const LOCAL_USER = 'local';

const link = new Link({changed: () => panel.showLink(), up: linkUp, message: received});
const orders = new Orders(link);
const model = new Model({answered: fields => orders.answered(fields), missionChanged: askMission});
const editor = new MissionEditor(orders);
const fence = new FenceEditor({link, orders, selected, order, confirm: question => panel.confirm(question), isNear: (a, b) => map.isNear(a, b)});
const services = new ServicesTab({link, orders, selected, order, tell: (...said) => panel.tell(...said), confirm: question => panel.confirm(question)});
const book = new SeriesBook();
const insight = new InsightTab({link, book, selected});
const mission = new MissionTab({link, orders, editor, selected, order, askMission, tell: (...said) => panel.tell(...said), confirm: question => panel.confirm(question), isNear: (a, b) => map.isNear(a, b), fitted: () => { wasFitted = false; }});
const timeline = new Timeline({orders, selected, tell: (...said) => panel.tell(...said), jumped});
const panel = new Panel({services, insight, mission, link, orders, editor, model, selected, select});
const map = new MapView(byId('map'), {tapped, grabbed, dragged, dropped});
const tools = new MapTools({map, extent: () => (selected() ? extent(selected(), editor.route(selected())) : [])});

let selectedId = '';
let wasFitted = false;
let escapeAt = -Infinity;

function selected() {
  return model.vehicles.get(selectedId);
}

function select(id) {
  if (id === selectedId) return;
  selectedId = id;
  wasFitted = false;
  fence.discard();
  editor.discard();
  editor.selected = null;
}

function jumped(vehicle) {
  vehicle.jumped();
  book.clear();
}

function received(system, channel, type, fields) {
  model.message(system, channel, type, fields);
  if (system === selectedId) book.message(system, channel, fields);
  if (type === 'CameraImage') insight.picture(model.vehicles.get(system), fields).catch(error => panel.tell(texts.noPicture(error.message), true));
  if (!selectedId && model.vehicles.has(system)) select(system);
  map.touch();
}

function linkUp() {
  orders.linkUp();
  for (const vehicle of model.vehicles.values()) askMission(vehicle);
}

/** Asks for the mission soon, once for several changes; who may not ask gets no answer. */
function askMission(vehicle) {
  clearTimeout(vehicle.asking);
  vehicle.asking = setTimeout(() => {
    vehicle.askedAt = performance.now();
    orders.report(vehicle, vehicle.goalClasses.size === 0).catch(() => {
      if (!vehicle.isMissionMissed) vehicle.log('no Mission Manager answers', 'warn');
      vehicle.isMissionMissed = true;
    });
  }, 200);
}

function order(promise) {
  panel.tell('…');
  promise.then(text => panel.tell(text), error => panel.tell(error.message, true));
}

function onClick(id, action) {
  byId(id).addEventListener('click', () => {
    const vehicle = selected();
    if (vehicle) action(vehicle);
  });
}

onClick('estop', vehicle => orders.emergencyStop(vehicle));
onClick('arm', vehicle => order(orders.arm(vehicle, true)));
onClick('disarm', async vehicle => {
  if (await panel.confirm(`Disarm ${vehicle.id}? Its actuators go neutral, even in mid-air.`)) order(orders.arm(vehicle, false));
});
onClick('hold', vehicle => order(orders.mission(vehicle, 'PAUSE')));
onClick('resume', vehicle => order(orders.mission(vehicle, 'RESUME')));
onClick('return', vehicle => order(orders.mission(vehicle, 'RETURN')));
onClick('land', vehicle => order(orders.mission(vehicle, 'LAND')));
onClick('skip', vehicle => order(orders.mission(vehicle, 'SKIP', editor.route(vehicle).some(goal => goal.isSelected && goal.isCurrent) ? {uid: editor.selected} : {})));
onClick('clear', async vehicle => {
  if (await panel.confirm(`Clear the emergency stop of ${vehicle.id}? It may move again once armed.`)) order(orders.clearStops(vehicle));
});

document.addEventListener('keydown', event => {
  if (event.key !== 'Escape' || event.repeat) return;
  const now = performance.now();
  if (now - escapeAt < TWICE_MS && selected() && !selected().playback && link.state !== 'off') orders.emergencyStop(selected());
  escapeAt = now;
});

function tapped(at) {
  const vehicle = selected();
  if (!vehicle || tools.tapped(at) || fence.tapped(vehicle, at)) return;
  if (editor.isAdding && vehicle.place.origin) mission.tapped(vehicle, at);
  else mission.choose(vehicle, at);
  panel.show(vehicle);
}

/** Goals can be dragged while the mission is open, so that nobody moves one by accident. */
function grabbed(at) {
  const vehicle = selected();
  if (!vehicle || !mission.isOpen || editor.isAdding) return null;
  return fence.isOpen ? fence.grabbed(vehicle, at) : mission.grabbed(vehicle, at);
}

function dragged(handle, at) {
  handle.now = at;
  dragging = handle;
}

function dropped(handle, at) {
  dragging = null;
  (handle.isFence ? fence : mission).dropped(selected(), handle, at);
  panel.show(selected());
}

let dragging = null;
let drawnAt = -Infinity;

function frame() {
  requestAnimationFrame(frame);
  const now = performance.now();
  if (!map.isDirty || now - drawnAt < DRAW_EVERY_MS && !dragging) return;
  map.isDirty = false;
  drawnAt = now;
  const vehicle = selected();
  if (vehicle && vehicle.place.pose) tools.follow(vehicle.place.pose);
  map.clear();
  const coast = vehicle && tools.layers.coast && land(vehicle.place, () => map.touch());
  if (coast) map.shape(coast, map.colours.land, map.colours.dim);
  if (vehicle && tools.layers.tiles) drawTiles(map, vehicle.place, () => map.touch());
  map.drawGrid();
  for (const other of model.vehicles.values()) {
    if (other !== vehicle) drawVehicle(map, seenFrom(vehicle, other), [], false, tools.layers);
  }
  if (!vehicle) return;
  const route = editor.route(vehicle);
  if (tools.layers.fence) fence.draw(map, vehicle, dragging);
  const drawHandles = mission.draw(map, route, dragging && dragging.isFence ? null : dragging);
  drawVehicle(map, vehicle, route, true, tools.layers);
  drawHandles();
  tools.draw();
  if (!wasFitted && (vehicle.report || editor.draft.whole) && vehicle.place.pose) {
    wasFitted = true;
    map.fit(extent(vehicle, route));
  }
}

/** Another vehicle on the chosen one's map; nowhere if their frames differ. */
function seenFrom(vehicle, other) {
  const {state} = other;
  const pose = vehicle && state ? vehicle.place.of(state.referenceFrame, state.x, state.y) : undefined;
  return {id: other.id, state, trail: [], isStale: now => other.isStale(now), place: {pose: pose && {...pose, heading: other.place.pose.heading}}};
}

setInterval(() => {
  const vehicle = selected();
  tools.show();
  panel.show(vehicle);
  if (vehicle) timeline.show(vehicle);
  if (vehicle && fence.isOpen) fence.show(vehicle);
  link.isReadOnly = Boolean(vehicle && vehicle.playback);
  map.touch(); // what is stale turns grey without a message
}, PANEL_EVERY_MS);

setInterval(() => { // on its own: what cannot be shown must not silence the operator
  const vehicle = selected();
  if (vehicle && link.isUp && !vehicle.playback && performance.now() - (vehicle.askedAt || 0) > REPORT_EVERY_MS) askMission(vehicle);
  if (vehicle && link.isUp && !vehicle.playback && byId('supervise').checked && performance.now() - (vehicle.beatAt || -Infinity) >= 1000) {
    vehicle.beatAt = performance.now();
    link.publish(vehicle.id, 'operator', 'OperatorHeartbeat', {timestamp: vehicle.now(), operator: orders.operator, interval: 1.0}).catch(() => undefined);
  }
}, PANEL_EVERY_MS);

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => map.resize());

function enter(user, password) {
  orders.operator = (user || 'observer') + '@web';
  link.open({user, password});
}

byId('enter').addEventListener('click', () => enter(byId('user').value, byId('password').value));
byId('login').addEventListener('cancel', event => event.preventDefault());
byId('logout').onclick = () => {
  byId('password').value = '';
  link.close();
  location.reload(); // forgets everything heard
};

// A link printed on the terminal has the token behind the #, which a browser sends to nobody.
const token = location.hash.slice(1);
history.replaceState(null, '', location.pathname);
if (token) enter(LOCAL_USER, token);
else byId('login').showModal();
frame();
