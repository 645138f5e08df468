// The tab Insight: curves of any numeric field of any channel, and camera pictures.

import {drawChart, short} from './chart.js';
import {byId, element, fill, setText} from './dom.js';
import {texts} from './texts.js';

const BYTES_MAX = 1 << 20;

/** `parts`: link, book, selected(). */
export class InsightTab {
  constructor(parts) {
    Object.assign(this, parts);
    this.heard = new Set(); // channels asked for by this tab
    this.pictures = new Map(); // camera -> canvas
    byId('channel').onchange = event => this.listen(event.target.value);
    byId('plot').onclick = () => this.plot(byId('field').value);
    byId('field').onkeydown = event => { if (event.key === 'Enter') this.plot(byId('field').value); };
    byId('cameras').onchange = event => (event.target.checked ? this.link.hear('images') : this.link.unhear('images'));
  }

  /** Asks the broker for one more channel, whose fields can be chosen then. */
  listen(channel) {
    if (channel) this.link.hear(channel);
  }

  plot(key) {
    if (!this.book.fields.has(key)) return;
    this.book.add(key);
    byId('field').value = '';
  }

  show(vehicle) {
    const channels = new Set([...vehicle.functions.values()].flatMap(each => each.publishes.map(line => line.split('/')[0])));
    fill(byId('channel'), ['', ...[...channels].sort()], name => element('option', name || texts.anotherChannel, {value: name}));
    if (document.activeElement !== byId('field') || this.offered !== this.book.fields.size) {
      this.offered = this.book.fields.size;
      fill(byId('fields'), [...this.book.fields.keys()].filter(key => key.startsWith(vehicle.id + ' ')).sort(), key => element('option', '', {value: key}));
    }
    this.showCharts();
  }

  showCharts() {
    const list = byId('charts');
    const keys = [...this.book.series.keys()];
    if (list.children.length !== keys.length || keys.some((key, i) => list.children[i].dataset.key !== key)) list.replaceChildren(...keys.map(key => this.chart(key)));
    const style = getComputedStyle(list);
    const paint = {text: style.getPropertyValue('--text'), dim: style.getPropertyValue('--dim'), line: style.getPropertyValue('--line'), curve: style.getPropertyValue('--accent')};
    const now = performance.now();
    for (const item of list.children) {
      const series = this.book.series.get(item.dataset.key);
      const newest = series.values[series.values.length - 1];
      setText(item.querySelector('output'), newest === undefined ? '' : short(newest));
      item.classList.toggle('stale', !(now - series.times[series.times.length - 1] < 1000));
      drawChart(item.querySelector('canvas'), series, Number(byId('span').value), now, paint);
    }
  }

  chart(key) {
    const item = element('li');
    item.dataset.key = key;
    const remove = element('button', '×', {type: 'button', onclick: () => this.book.series.delete(key)});
    remove.setAttribute('aria-label', texts.remove(key));
    const head = element('div', '', {className: 'chart-head'});
    head.append(element('span', key), element('output'), remove);
    item.append(head, element('canvas'));
    return item;
  }

  /** Shows a camera's picture; decoding is the browser's, which trusts no file. */
  async picture(vehicle, fields) {
    const {sensorName, data, format} = fields;
    if (vehicle !== this.selected() || !(data instanceof Uint8Array) || data.length > BYTES_MAX || !['jpeg', 'png', 'webp'].includes(format)) return;
    const bitmap = await createImageBitmap(new Blob([data], {type: 'image/' + format}));
    if (!this.pictures.has(sensorName)) {
      if (this.pictures.size >= 8) return;
      const figure = element('figure');
      const canvas = element('canvas');
      canvas.setAttribute('role', 'img');
      canvas.setAttribute('aria-label', sensorName);
      figure.append(canvas, element('figcaption', sensorName));
      byId('pictures').append(figure);
      this.pictures.set(sensorName, canvas);
    }
    const canvas = this.pictures.get(sensorName);
    canvas.width = bitmap.width;
    canvas.height = bitmap.height;
    canvas.getContext('2d').drawImage(bitmap, 0, 0);
    bitmap.close();
  }
}
