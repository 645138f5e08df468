// Goals as mission files have them: texts of fields by name, and links. Converts messages, XML and drawn places.

import {escapeXml, readXml, XmlError} from './xml.js';

const RESULTS = {nextIfDone: 'done', nextIfFailed: 'failed', nextIfTimedOut: 'timed out'};
const NUMBER = /^[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$/;
const POINT_SEPARATOR = /[\s,]+/;
const ALIASES = {name: 'uid', reference: 'referenceFrame'};
const WHOLE_MISSION = ['home', 'timeLimit'];

/** A number as text, to 0.1 mm in degrees, without an exponent. */
export function numberText(value) {
  return value.toFixed(9).replace(/\.?0+$/, '').replace(/^-0$/, '0');
}

/** The value of a message's field as a mission file has it; empty if there is none. */
export function textOf(value) {
  if (value === undefined || value === null) return '';
  if (typeof value === 'number') return numberText(value);
  if (!Array.isArray(value)) return String(value);
  if (value.every(each => typeof each === 'string')) return value.join(', ');
  return value.map(each => (Array.isArray(each) ? each.map(numberText).join(' ') : textOf(each))).join(value.every(Array.isArray) ? '; ' : ' ');
}

/** The points of a text such as "1 2; 3 4"; empty if it is none. */
export function pointsOf(text) {
  const points = text.split(';').map(each => each.trim()).filter(Boolean).map(each => each.split(POINT_SEPARATOR).map(Number));
  return points.every(point => point.length >= 2 && point.every(Number.isFinite)) ? points : [];
}

/** A goal of a report as {uid, type, fields, links}. `known`: its GoalClass, or undefined. */
export function goalOf(message, known) {
  const type = message.type ? message.type[message.type.length - 1] : 'Waypoint';
  const fields = {};
  for (const {name} of known ? known.variables : []) if (name !== 'uid' && textOf(message[name])) fields[name] = textOf(message[name]);
  return {uid: message.uid, type, fields, links: links(message)};
}

function links(message) {
  const lines = [];
  for (const [field, result] of Object.entries(RESULTS)) {
    const next = message[field];
    if (Array.isArray(next)) lines.push(next.length > 0 ? `<next if="${result}">${escapeXml(next.join(', '))}</next>` : `<end if="${result}"/>`);
  }
  if (message.repeatFrom) lines.push(`<repeat from="${escapeXml(message.repeatFrom)}" times="${Number(message.repeatTimes || 1)}"/>`);
  return lines;
}

/** Lines of XML of goals, and which goal and field each line has. */
export class MissionXml {
  constructor(head = []) {
    this.lines = ['<mission>'];
    this.places = [undefined];
    head.forEach(text => text.split('\n').forEach(line => this.push(line)));
  }

  push(line, uid, field) {
    this.lines.push(line);
    this.places.push({uid, field});
  }

  /** A text such as "900 ft" becomes a number with a unit. */
  goal({uid, type, fields, links: own = []}, known) {
    this.push(`  <${type}>`, uid);
    this.push(`    <name>${escapeXml(uid)}</name>`, uid, 'uid');
    for (const [name, text] of Object.entries(fields).filter(each => each[1] !== undefined)) {
      const [number, unit, ...rest] = text.trim().split(/\s+/);
      const isNumber = !known || known.variables.some(each => each.name === name && each.variableType === 'double');
      const hasUnit = isNumber && unit && rest.length === 0 && NUMBER.test(number) && !NUMBER.test(unit);
      if (text.trim()) this.push(hasUnit ? `    <${name} unit="${escapeXml(unit)}">${number}</${name}>` : `    <${name}>${escapeXml(text.replace(/\s*\n\s*/g, ' '))}</${name}>`, uid, name);
    }
    for (const line of own) this.push('    ' + line, uid, line.slice(1).split(/[ />]/)[0]);
    this.push(`  </${type}>`, uid);
    return this;
  }

  get text() {
    return [...this.lines, '</mission>', ''].join('\n');
  }

  /** Goal and field of a line that the vehicle names. */
  place(line) {
    return this.places[line - 1];
  }
}

/** Reads a mission file: {goals, head}. `classes`: GoalClass by name. Throws with file, line, element. */
export function readMission(file, text, classes) {
  const refuse = (element, what) => new Error(`${file}, line ${element.line}, <${element.name}>: ${what}`);
  let root;
  try {
    root = readXml(text);
  } catch (error) {
    throw error instanceof XmlError ? new Error(`${file}, line ${error.line}: ${error.message}`) : error;
  }
  if (root.name !== 'mission') throw refuse(root, 'expected <mission>');
  const goals = [];
  const head = [];
  for (const child of root.children) {
    if (WHOLE_MISSION.includes(child.name)) head.push('  ' + child.source);
    else goals.push(readGoal(child, classes, refuse));
  }
  if (goals.length === 0) throw refuse(root, 'contains no goals');
  nameAll(goals, refuse);
  return {goals: goals.map(({element, ...goal}) => goal), head};
}

function readGoal(element, classes, refuse) {
  const type = element.name.charAt(0).toUpperCase() + element.name.slice(1);
  const known = classes.get(type);
  if (!known) throw refuse(element, `is no class of goals; expected one of ${[...classes.keys()].join(', ')}`);
  const goal = {uid: '', type, fields: {}, links: [], element};
  for (const child of element.children) {
    const field = ALIASES[child.name] || child.name;
    if (['end', 'repeat'].includes(child.name) || child.name === 'next' && child.attributes.if !== undefined) goal.links.push(child.source);
    else if (field === 'uid') goal.uid = child.text;
    else if (!known.variables.some(each => each.name === field)) throw refuse(child, `is not a field of ${type}; expected one of ${known.variables.map(each => each.name).join(', ')}`);
    else if (!child.text) throw refuse(child, 'is empty');
    else if (field === 'next' && goal.fields.next) goal.fields.next += ', ' + child.text;
    else if (field in goal.fields) throw refuse(child, 'appears twice');
    else goal.fields[field] = child.attributes.unit === undefined ? child.text : `${child.text} ${child.attributes.unit}`;
  }
  return goal;
}

/** Goals without a name have their number in the file, or the next that is free. */
function nameAll(goals, refuse) {
  const taken = new Set();
  for (const goal of goals.filter(each => each.uid)) {
    if (taken.has(goal.uid)) throw refuse(goal.element, `the name "${goal.uid}" is taken`);
    taken.add(goal.uid);
  }
  goals.forEach((goal, i) => {
    let number = i + 1;
    while (!goal.uid && taken.has(String(number))) number++;
    if (!goal.uid) goal.uid = String(number);
    taken.add(goal.uid);
  });
}
