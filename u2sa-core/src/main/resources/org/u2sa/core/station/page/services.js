// Services: their health, and of the chosen one details, orders to its launcher, and its configuration.

import {ConfigurationForm} from './configuration.js';
import {age, buttonRow, byId, element, fill, setText} from './dom.js';
import {drawGraph} from './graph.js';
import {texts} from './texts.js';

const ASK_EVERY_MS = 5000;
const ENDED = ['STOPPED', 'FAILED'];

/** `parts`: link, orders, selected(), order(promise), tell(text, isBad), confirm(question). */
export class ServicesTab {
  constructor(parts) {
    Object.assign(this, parts);
    this.chosen = null; // name of a service
    this.form = new ConfigurationForm(byId('variables'), parts);
    const on = (id, action) => { byId(id).onclick = () => this.selected() && this.chosen && action(this.selected(), this.chosen); };
    on('service-restart', (vehicle, name) => this.asked(texts.askRestart(name), () => this.orders.service(vehicle, name, 'RESTART')));
    on('service-start', (vehicle, name) => this.order(this.orders.service(vehicle, name, 'START')));
    on('service-stop', (vehicle, name) => this.asked(texts.askStop(name), () => this.orders.stopService(vehicle, name)));
    on('service-swap', (vehicle, name) => {
      const className = byId('service-class').value;
      this.asked(texts.askSwap(name, className), () => this.orders.service(vehicle, name, 'SWAP', {className}));
    });
    on('service-back', (vehicle, name) => this.choose(vehicle, name));
    on('configuration-apply', vehicle => this.order(this.form.apply(vehicle)));
    on('configuration-undo', vehicle => this.order(this.form.undo(vehicle)));
    on('configuration-reset', () => this.form.reset());
  }

  async asked(question, action) {
    if (await this.confirm(question)) this.order(action());
  }

  choose(vehicle, name) {
    this.chosen = this.chosen === name ? null : name;
    if (this.chosen) this.orders.askConfiguration(vehicle, name).catch(error => this.tell(error.message, true));
    this.show(vehicle);
    if (this.chosen) byId('service-name').focus();
    byId('services').scrollTop = 0;
  }

  show(vehicle) {
    if (this.vehicle !== vehicle) {
      this.vehicle = vehicle;
      this.chosen = null;
    }
    if (this.link.isUp && !(performance.now() - vehicle.directoryAskedAt < ASK_EVERY_MS)) {
      vehicle.directoryAskedAt = performance.now();
      this.orders.askDirectory(vehicle).catch(() => undefined); // the list stays empty
    }
    fill(byId('service-rows'), [...vehicle.services.keys()].sort(), name => this.row(vehicle, name));
    if (byId('flow').open) drawGraph(vehicle, this.chosen, name => this.choose(vehicle, name));
    byId('service').hidden = !vehicle.services.has(this.chosen);
    byId('service-list').hidden = !byId('service').hidden;
    if (!byId('service').hidden) this.showChosen(vehicle);
  }

  row(vehicle, name) {
    const {report} = vehicle.services.get(name);
    const {text, state} = health(vehicle, name);
    const p99 = report.callbackP99 === undefined ? '' : (report.callbackP99 * 1000).toFixed(1) + ' ms';
    const cells = [name, text, p99, String(report.dropped + (report.missed || 0)), String(report.exceptions)];
    return buttonRow({cells, state}, this.chosen === name, () => this.choose(vehicle, name));
  }

  showChosen(vehicle) {
    const name = this.chosen;
    const {report} = vehicle.services.get(name);
    const known = vehicle.directory.get(name) || {};
    const isEnded = ENDED.includes(report.status);
    setText(byId('service-name'), name);
    const facts = [[known.className, known.host].filter(Boolean).join(texts.on), report.lastError, ...(report.remarks || [])];
    fill(byId('service-facts'), facts.filter(Boolean), fact => element('li', fact));
    byId('service-start').hidden = !isEnded;
    byId('service-stop').hidden = isEnded;
    for (const id of ['service-start', 'service-stop', 'service-restart', 'configuration-apply', 'configuration-undo']) byId(id).disabled = !this.link.isUp;
    this.showClasses(known);
    const configuration = vehicle.configurations.get(name);
    this.form.show(configuration || null);
    setText(byId('configuration-revision'), configuration ? texts.revision(configuration.revision || 0) : texts.asking);
  }

  /** Classes of the service's role: those of its own package first, which suit the same kind of vehicle. */
  showClasses({className = '', choices = []}) {
    const list = byId('service-class');
    const near = choices.filter(each => each !== className && packageOf(each) === packageOf(className));
    const far = choices.filter(each => each !== className && packageOf(each) !== packageOf(className));
    const key = [className, ...near, '', ...far].join(' ');
    if (list.dataset.key !== key) {
      list.dataset.key = key;
      const option = name => element('option', name.slice(name.lastIndexOf('.') + 1), {value: name, title: name});
      const others = element('optgroup', '', {label: texts.otherPackages});
      others.append(...far.map(option));
      list.replaceChildren(...near.map(option), ...(far.length > 0 ? [others] : []));
    }
    byId('service-classes').hidden = near.length + far.length === 0;
    byId('service-swap').disabled = !this.link.isUp;
  }
}

function packageOf(className) {
  return className.slice(0, className.lastIndexOf('.'));
}

/** What the health monitor says of a service, and otherwise the service itself. */
function health(vehicle, name) {
  const {report, at} = vehicle.services.get(name);
  const condition = vehicle.conditions.get(name);
  const isEnded = ENDED.includes(report.status);
  const isLate = !isEnded && performance.now() - at > 3000 * Math.max(0.2, report.interval || 1);
  const isIll = condition && !['ALIVE', 'STOPPED', 'UNWATCHED'].includes(condition.condition);
  if (isIll || report.status === 'FAILED') return {text: (isIll ? condition.condition : report.status).toLowerCase(), state: 'bad'};
  if (isLate) return {text: texts.silent(age(at)), state: 'stale'};
  return {text: report.status.toLowerCase(), state: isEnded ? 'warn' : ''};
}
