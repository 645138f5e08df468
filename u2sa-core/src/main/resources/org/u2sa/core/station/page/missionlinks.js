// XML of a draft as a whole: the order of its goals, and links where they changed.

import {goalOf, MissionXml, numberText} from './goals.js';
import {escapeXml} from './xml.js';

const ENDS = {nextIfDone: 'done', nextIfFailed: 'failed'};
const uids = items => items.map(item => item.uid).join(', ');

/** Whether nothing but the end and one list of followers depends on a goal's result. */
export function isPlain(goal) {
  const isEnd = list => list === undefined || list === null || list.length === 0;
  return !goal.repeatFrom && isEnd(goal.nextIfDone) && isEnd(goal.nextIfFailed) && goal.nextIfTimedOut === undefined && goal.choose === undefined;
}

/** The goals that will have other followers than the vehicle has. `route`: as the vehicle has it. */
export function relinked(editor, vehicle, route) {
  const before = new Map(route.map(item => [item.uid, uids(item.followers)]));
  const xml = new MissionXml();
  for (const item of editor.route(vehicle)) {
    const next = uids(item.followers);
    if (item.base && !item.isRemoved && item.uid !== 'home' && next !== before.get(item.uid)) xml.goal({uid: item.uid, type: item.type, fields: {}, links: linksTo(item.base, next)}, item.known);
  }
  return xml;
}

/** The whole mission as a file. */
export function wholeMission(editor, vehicle) {
  const {whole, added, removed, order, changed} = editor.draft;
  const route = editor.route(vehicle).filter(item => !item.isRemoved);
  const home = route.find(item => item.uid === 'home' && item.base);
  const xml = new MissionXml(whole ? whole.head : headOf(vehicle, home));
  const goals = route.filter(each => each !== home);
  const isEdited = added.length > 0 || removed.length > 0 || order !== null;
  const isMixed = !whole && vehicle.report.sequence.length > 0 && goals.some(each => each.text('next')); // links in an ordered mission
  const isChain = goals.every((item, i) => (!item.base || isPlain(item.base)) && uids(item.followers) === uids(goals.slice(i + 1, i + 2)));
  for (const item of goals) {
    const {fields, links} = item.base ? goalOf(item.base, item.known) : item.own;
    const goal = {uid: item.uid, type: item.type, fields: {...fields, ...(item.own ? {} : changed[item.uid])}, links};
    if (!whole && (isEdited || isMixed)) relink(goal, item, isChain);
    xml.goal(goal, item.known);
  }
  return xml;
}

/** In a chain the order of the file says what follows; else every goal has to. */
function relink(goal, item, isChain) {
  const next = uids(item.followers);
  if (item.base && !isPlain(item.base)) goal.fields.next = goal.fields.next || next || undefined;
  else {
    delete goal.fields.next;
    goal.links = isChain ? [] : linksTo({}, next);
  }
}

function headOf({report}, home) {
  const limit = report.timeLimit === undefined ? [] : [`  <timeLimit unit="s">${numberText(report.timeLimit)}</timeLimit>`];
  if (!home) return limit;
  const fields = ['x', 'y'].map(name => `    <${name}>${home.text(name)}</${name}>`);
  return [['  <home>', ...fields, `    <reference>${escapeXml(home.text('referenceFrame') || 'GLOBAL')}</reference>`, '  </home>'].join('\n'), ...limit];
}

/** Links to other followers, also where the goal ended the mission until then. */
function linksTo(goal, next) {
  if (!next) return Object.values(ENDS).map(result => `<end if="${result}"/>`);
  const lines = [`<next>${escapeXml(next)}</next>`];
  for (const [field, result] of Object.entries(ENDS)) if (Array.isArray(goal[field])) lines.push(`<next if="${result}">${escapeXml(next)}</next>`);
  return lines;
}
