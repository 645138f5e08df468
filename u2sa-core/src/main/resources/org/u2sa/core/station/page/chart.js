// One curve over time on a canvas, with its range and newest value.

const MARGIN_PX = 16;
const GAP_MS = 2000; // silence longer than this is not drawn as a line

/** Draws the last `spanS` seconds of a series. `paint` has the colours text, dim, line and curve. */
export function drawChart(canvas, {times, values}, spanS, now, paint) {
  const ratio = devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const c = canvas.getContext('2d');
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.clearRect(0, 0, width, height);
  const from = now - spanS * 1000;
  let first = times.length;
  while (first > 0 && times[first - 1] >= from) first--;
  const [least, most] = range(values, first);
  const y = value => MARGIN_PX + (height - 2 * MARGIN_PX) * (most === least ? 0.5 : (most - value) / (most - least));
  c.strokeStyle = paint.line;
  c.lineWidth = 1;
  c.beginPath();
  for (const level of [MARGIN_PX, height / 2, height - MARGIN_PX]) {
    c.moveTo(0, Math.round(level) + 0.5);
    c.lineTo(width, Math.round(level) + 0.5);
  }
  c.stroke();
  c.strokeStyle = paint.curve;
  c.lineWidth = 1.5;
  c.beginPath();
  for (let i = first; i < times.length; i++) {
    const x = width * (times[i] - from) / (spanS * 1000);
    if (i > first && times[i] - times[i - 1] < GAP_MS) c.lineTo(x, y(values[i]));
    else c.moveTo(x, y(values[i]));
  }
  c.stroke();
  c.font = '11px system-ui, sans-serif';
  c.fillStyle = paint.dim;
  if (first < times.length) {
    c.fillText(short(most), 2, MARGIN_PX - 4);
    if (most !== least) c.fillText(short(least), 2, height - 4);
  }
}

function range(values, first) {
  let [least, most] = [Infinity, -Infinity];
  for (let i = first; i < values.length; i++) {
    least = Math.min(least, values[i]);
    most = Math.max(most, values[i]);
  }
  return [least, most];
}

export function short(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e7)) return value.toExponential(2);
  return String(Number(value.toFixed(size < 10 ? 4 : size < 1000 ? 2 : 1)));
}
