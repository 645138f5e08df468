// The form of the chosen goal, made from the fields that the vehicle names for its class.

import {control, limits} from './configuration.js';
import {element} from './dom.js';
import {texts} from './texts.js';

const COMMON = ['next', 'description', 'timeLimit', 'choose'];

/** `parts`: editor, changed(): what to do after an edit. */
export class GoalForm {
  constructor(parent, parts) {
    Object.assign(this, parts);
    this.parent = parent;
    this.shown = ''; // goal and class
    this.inputs = new Map(); // by field
  }

  /** Shows a goal; what is being typed stays. */
  show(item) {
    const shown = item && item.known ? [item.uid, item.type, Boolean(item.own), item.known.number].join('\n') : '';
    if (shown !== this.shown) this.build(shown, item);
    if (!shown) return;
    this.item = item;
    const {refusal} = this.editor;
    for (const [name, {input, note, hint}] of this.inputs) {
      const text = name === 'uid' ? item.uid : item.text(name);
      if (input !== document.activeElement && input.value !== text) input.value = text;
      const isChanged = name !== 'uid' && Boolean(item.own ? item.own.fields[name] : (this.editor.draft.changed[item.uid] || {})[name] !== undefined);
      const isRefused = Boolean(refusal && refusal.uid === item.uid && refusal.field === name);
      input.parentElement.classList.toggle('warn', isChanged && !isRefused);
      input.parentElement.classList.toggle('bad', isRefused);
      input.setAttribute('aria-invalid', isRefused);
      note.textContent = isRefused ? refusal.text : hint;
    }
  }

  build(shown, item) {
    this.shown = shown;
    this.inputs.clear();
    this.parent.replaceChildren(...(shown ? sorted(item.known).map((variable, i) => this.row(item, variable, i)) : []));
  }

  row(item, variable, i) {
    const {name} = variable;
    const line = element('div', '', {className: 'variable'});
    const isLong = ['points', 'texts'].includes(variable.variableType);
    if (isLong) line.classList.add('long');
    const input = variable.variableType === 'points' ? element('textarea', '', {rows: 3, spellcheck: false}) : control({...variable, value: name === 'uid' ? item.uid : item.text(name), choices: variable.choices.length > 0 ? ['', ...variable.choices] : []});
    const hint = [item.known.required.includes(name) ? texts.required : '', limits(variable), variable.value ? texts.ifAbsent(variable.value) : '', texts.kinds[variable.variableType]].filter(Boolean).join(' · ');
    const note = element('small', hint, {id: `goal-note-${i}`});
    input.id = `goal-field-${i}`;
    input.disabled = name === 'uid' && !item.own;
    input.setAttribute('aria-describedby', note.id);
    if (name === 'uid') input.onchange = () => input.value.trim() && this.changed(() => this.editor.rename(this.item, input.value.trim()));
    else input.oninput = () => this.changed(() => this.editor.set(this.item, name, input.value));
    this.inputs.set(name, {input, note, hint});
    line.append(element('label', name === 'uid' ? texts.name : name, {htmlFor: input.id}), input, element('span', unitIn(variable, item.frame)), note);
    return line;
  }

  /** Moves the focus to the field that the vehicle refuses. */
  focusRefused() {
    const field = this.editor.refusal && this.inputs.get(this.editor.refusal.field);
    if (field) field.input.focus();
  }
}

/** The name first, what a goal must have next, what all goals may have last. */
function sorted({variables, required}) {
  const rank = ({name}) => (name === 'uid' ? 0 : required.includes(name) ? 1 : COMMON.includes(name) ? 3 : 2);
  return [...variables].sort((a, b) => rank(a) - rank(b));
}

/** Units of places depend on the frame; the vehicle names those of x and y in GLOBAL. */
function unitIn({unit, variableType}, frame) {
  if (unit === 'deg' || ['point', 'points'].includes(variableType)) return frame === 'GLOBAL' ? 'deg' : 'm';
  return unit === '1' ? '' : unit || '';
}
