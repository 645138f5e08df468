// The form of one service's configuration: values are checked by the service, which says why it refuses one.

import {element} from './dom.js';
import {texts} from './texts.js';

/** `parts`: orders, selected(), tell(text, isBad). */
export class ConfigurationForm {
  constructor(parent, parts) {
    Object.assign(this, parts);
    this.parent = parent;
    this.shown = null; // the response that the form shows
    this.inputs = new Map();
  }

  /** Shows a configuration; what is being typed stays if the service reports another value meanwhile. */
  show(configuration) {
    if (configuration === this.shown) return;
    const isSame = this.shown && configuration && this.shown.serviceName === configuration.serviceName && configuration.variables.length === this.inputs.size;
    const typed = new Map(isSame ? [...this.inputs].filter(([name]) => this.isChanged(name)).map(([name, input]) => [name, input.value]) : []);
    const focused = isSame && [...this.inputs].find(([, input]) => input === document.activeElement);
    this.shown = configuration;
    this.inputs.clear();
    this.parent.replaceChildren(...(configuration ? this.rows(configuration.variables) : []));
    for (const [name, value] of typed) if (this.inputs.has(name)) this.inputs.get(name).value = value;
    this.mark();
    if (focused && this.inputs.has(focused[0])) this.inputs.get(focused[0]).focus();
  }

  rows(variables) {
    return [...variables].sort((a, b) => a.name.localeCompare(b.name)).map((variable, i) => {
      const line = element('div');
      line.className = 'variable';
      const input = control(variable);
      input.id = 'variable-' + i;
      input.oninput = () => this.mark();
      this.inputs.set(variable.name, input);
      const hint = [limits(variable), variable.description].filter(Boolean).join(' · ');
      line.append(element('label', variable.name, {htmlFor: input.id}), input, element('span', variable.unit || ''), element('small', hint));
      return line;
    });
  }

  variable(name) {
    return this.shown.variables.find(each => each.name === name);
  }

  isChanged(name) {
    return this.inputs.get(name).value.trim() !== this.variable(name).value;
  }

  mark() {
    for (const [name, input] of this.inputs) input.parentElement.classList.toggle('warn', this.isChanged(name));
  }

  get changes() {
    return [...this.inputs.keys()].filter(name => this.isChanged(name))
      .map(name => ({type: ['ConfigurationAssignment'], variableName: name, value: this.inputs.get(name).value.trim()}));
  }

  /** Back to what the service reported. */
  reset() {
    for (const [name, input] of this.inputs) input.value = this.variable(name).value;
    this.mark();
  }

  /** Sets all changed values at once: the service takes all or none, and none if somebody else was faster. */
  async apply(vehicle) {
    const {changes} = this;
    if (changes.length === 0) throw new Error(texts.nothingChanged);
    return told(await this.orders.configure(vehicle, this.shown.serviceName, changes, this.shown.revision));
  }

  /** Takes the service's newest change back, whoever made it. */
  async undo(vehicle) {
    const outcome = told(await this.orders.undoConfiguration(vehicle, this.shown.serviceName));
    this.reset();
    return outcome;
  }
}

function told(result) {
  const lines = result.assignments.map(each => `${each.variableName}: ${each.previous === undefined ? '' : each.previous + ' → '}${each.value}`);
  return [...lines, texts.revision(result.revision)].join('; ');
}

export function control({variableType, value, choices}) {
  const allowed = choices && choices.length > 0 ? choices : variableType === 'boolean' ? ['true', 'false'] : null;
  if (!allowed) return element('input', '', {value, autocomplete: 'off', spellcheck: false, inputMode: ['double', 'int'].includes(variableType) ? 'text' : ''});
  const list = element('select');
  list.append(...[...new Set([value, ...allowed])].map(each => element('option', each, {value: each})));
  list.value = value;
  return list;
}

export function limits({min, max}) {
  if (min !== undefined && max !== undefined) return `${min} … ${max}`;
  if (min !== undefined) return '≥ ' + min;
  return max === undefined ? '' : '≤ ' + max;
}
