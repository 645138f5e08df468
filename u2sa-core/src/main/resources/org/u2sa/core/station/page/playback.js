// The timeline of a recording. The program that plays it is a service with the variables POSITION, RATE and PAUSED.

import {byId, setText} from './dom.js';
import {texts} from './texts.js';

export const PLAYBACK = 'Playback';
const STEP_S = 5;

/** Whether the program that serves this page plays a recording: a message must not claim it, because stops would end. */
const isRecording = document.documentElement.dataset.shows === 'recording';

/** What a playback says of itself: {position, length, rate, isPaused}; null if it is none. */
export function playbackOf({serviceName, variables}) {
  if (!isRecording || serviceName !== PLAYBACK) return null;
  const variable = name => variables.find(each => each.name === name) || {value: ''};
  const [position, rate, length] = [Number(variable('POSITION').value), Number(variable('RATE').value), variable('POSITION').max];
  return Number.isFinite(position) && Number.isFinite(rate) && Number.isFinite(length) ? {position, length, rate, isPaused: variable('PAUSED').value === 'true'} : null;
}

/** `parts`: orders, selected(), tell(text, isBad), jumped(vehicle): what was heard no longer belongs to what comes. */
export class Timeline {
  constructor(parts) {
    Object.assign(this, parts);
    this.isSeeking = false;
    byId('play').onclick = () => this.set('PAUSED', String(!this.playback.isPaused));
    byId('rate').onchange = () => this.set('RATE', byId('rate').value);
    byId('back').onclick = () => this.seek(this.playback.position - STEP_S);
    byId('ahead').onclick = () => this.seek(this.playback.position + STEP_S);
    byId('position').oninput = () => { this.isSeeking = true; };
    byId('position').onchange = () => {
      this.isSeeking = false;
      this.seek(Number(byId('position').value));
    };
  }

  seek(position) {
    this.set('POSITION', String(Math.max(0, Math.min(this.playback.length, position))));
    this.jumped(this.selected());
  }

  set(variableName, value) {
    this.orders.configure(this.selected(), PLAYBACK, [{type: ['ConfigurationAssignment'], variableName, value}]).catch(error => this.tell(error.message, true));
  }

  show(vehicle) {
    const {playback} = vehicle;
    document.body.classList.toggle('playback', Boolean(playback));
    byId('timeline').hidden = !playback;
    if (!playback) return;
    this.playback = playback;
    const {position, length, rate, isPaused} = playback;
    setText(byId('play'), isPaused ? texts.play : texts.pause);
    const slider = byId('position');
    slider.max = length;
    if (!this.isSeeking) slider.value = position;
    slider.setAttribute('aria-valuetext', `${clock(position)} ${texts.of} ${clock(length)}`);
    setText(byId('position-text'), `${clock(position)} / ${clock(length)}`);
    const nearest = [...byId('rate').options].find(option => Number(option.value) === rate);
    if (nearest && document.activeElement !== byId('rate')) byId('rate').value = nearest.value;
  }
}

function clock(seconds) {
  const tenths = Math.floor(seconds * 10);
  return `${Math.floor(tenths / 600)}:${String(Math.floor(tenths / 10) % 60).padStart(2, '0')}.${tenths % 10}`;
}
