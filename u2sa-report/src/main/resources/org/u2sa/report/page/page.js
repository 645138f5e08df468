"use strict";
(() => {
  const page = JSON.parse(document.getElementById("data").textContent);
  const runs = page.runs;
  const several = runs.length > 1;
  const NS = "http://www.w3.org/2000/svg";
  const colour = i => `var(--c${i % 8})`;
  const longest = Math.max(1e-3, ...runs.map(run => run.durationS));
  const view = { from: 0, to: longest, cursor: null };
  const redraws = []; // called when the span of time changes
  const moves = []; // called when the cursor moves

  const element = (name, attributes, parent, text) => {
    const made = document.createElement(name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.appendChild(made);
    return made;
  };
  const svg = (name, attributes, parent, text) => {
    const made = document.createElementNS(NS, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.appendChild(made);
    return made;
  };
  const time = s => {
    const sign = s < 0 ? "-" : "";
    const whole = Math.abs(s);
    return sign + Math.floor(whole / 60) + ":" + (whole % 60).toFixed(1).padStart(4, "0");
  };
  const number = v => Number.isInteger(v) && Math.abs(v) < 1e9 ? String(v) : Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3 ? v.toExponential(2) : String(+v.toPrecision(5));
  const marks = (from, to, most) => {
    const raw = (to - from) / most;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map(f => f * power).find(s => s >= raw) || raw;
    const all = [];
    for (let i = Math.ceil(from / step); i * step <= to; i++) all.push(i * step);
    return all;
  };
  const timeMarks = (from, to) => {
    const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200].find(s => (to - from) / s <= 9) || (to - from) / 5;
    const all = [];
    for (let i = Math.ceil(from / step); i * step <= to; i++) all.push(i * step);
    return all;
  };
  // The index of the last of ascending numbers that is not above v.
  const before = (ascending, v) => {
    let low = -1;
    let high = ascending.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (ascending[middle] <= v) low = middle; else high = middle;
    }
    return low;
  };
  const setCursor = t => { view.cursor = t; moves.forEach(move => move()); };
  const setSpan = (from, to) => {
    view.from = Math.max(0, from);
    view.to = Math.min(longest, to);
    if (view.to - view.from < longest * 1e-5) { view.from = 0; view.to = longest; }
    redraws.forEach(redraw => redraw());
    moves.forEach(move => move());
  };

  document.getElementById("title").textContent = page.title;
  document.getElementById("subtitle").textContent = several
    ? runs.map(run => run.name).join(", ") : `${runs[0].name}, ${time(runs[0].durationS)} min`;

  // --- table of results
  {
    const table = element("table", {}, document.getElementById("figures"));
    const head = element("tr", {}, table);
    element("th", {}, head, "");
    runs.forEach((run, i) => element("th", { style: several ? `color:${colour(i)}` : "" }, head, several ? run.name : "value"));
    const names = [...new Set(runs.flatMap(run => run.figures.map(f => f.name)))];
    for (const name of names) {
      const row = element("tr", {}, table);
      element("td", {}, row, name);
      for (const run of runs) {
        const figure = run.figures.find(f => f.name === name);
        element("td", { class: "number" }, row, figure ? number(figure.value) + (figure.unit ? " " + figure.unit : "") : "–");
      }
    }
  }

  // --- map
  const drawMap = () => {
    const parent = document.getElementById("map");
    const xs = [];
    const ys = [];
    for (const run of runs) {
      for (const line of [run.map.track, run.map.truth || []]) {
        for (let i = 0; i < line.length; i += 3) { xs.push(line[i + 1]); ys.push(line[i + 2]); }
      }
      run.map.goals.forEach(g => { xs.push(g.x - g.r, g.x + g.r); ys.push(g.y - g.r, g.y + g.r); });
    }
    if (xs.length === 0) { element("p", { class: "note" }, parent, "The recording has no global state."); return; }
    const least = a => a.reduce((m, v) => Math.min(m, v), Infinity);
    const greatest = a => a.reduce((m, v) => Math.max(m, v), -Infinity);
    const width = 1140;
    const spanX = Math.max(1, greatest(xs) - least(xs)) * 1.1;
    const spanY = Math.max(1, greatest(ys) - least(ys)) * 1.1;
    const height = Math.max(320, Math.min(640, width * spanY / spanX));
    const scale = Math.min(width / spanX, height / spanY);
    const middleX = (least(xs) + greatest(xs)) / 2;
    const middleY = (least(ys) + greatest(ys)) / 2;
    const px = x => width / 2 + (x - middleX) * scale;
    const py = y => height / 2 - (y - middleY) * scale;
    const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": "Map" }, parent);
    const grid = svg("g", {}, root);
    marks(middleX - width / 2 / scale, middleX + width / 2 / scale, 12).forEach(m => {
      svg("line", { class: "grid", x1: px(m), x2: px(m), y1: 0, y2: height }, grid);
      svg("text", { class: "soft", x: px(m) + 3, y: height - 5 }, grid, number(m) + " m");
    });
    marks(middleY - height / 2 / scale, middleY + height / 2 / scale, 7).forEach(m => {
      svg("line", { class: "grid", x1: 0, x2: width, y1: py(m), y2: py(m) }, grid);
      svg("text", { class: "soft", x: 4, y: py(m) - 3 }, grid, number(m) + " m");
    });
    const objects = svg("g", { fill: "var(--obstacle)", "fill-opacity": 0.35, stroke: "var(--obstacle)" }, root);
    const { side, squares } = runs[0].map.cells;
    let seen = "";
    for (let i = 0; i < squares.length; i += 2) {
      const w = (side * scale).toFixed(2);
      seen += `M${px(squares[i] * side).toFixed(1)} ${py(squares[i + 1] * side).toFixed(1)}h${w}v-${w}h-${w}z`;
    }
    if (seen) svg("path", { d: seen, fill: "var(--obstacle)", stroke: "none", "fill-opacity": 0.55 }, root);
    runs[0].map.objects.forEach(o => {
      let shape;
      if (o.outline) {
        const points = [];
        for (let i = 0; i < o.outline.length; i += 2) points.push(px(o.outline[i]) + "," + py(o.outline[i + 1]));
        shape = svg("polygon", { points: points.join(" ") }, objects);
      } else {
        shape = svg("circle", { cx: px(o.x), cy: py(o.y), r: Math.max(1.5, o.r * scale) }, objects);
      }
      svg("title", {}, shape, o.name);
    });
    const path = line => {
      let d = "";
      for (let i = 0; i < line.length; i += 3) d += (i ? "L" : "M") + px(line[i + 1]).toFixed(1) + " " + py(line[i + 2]).toFixed(1);
      return d;
    };
    runs.forEach((run, i) => {
      if (run.map.truth && !several) svg("path", { d: path(run.map.truth), fill: "none", stroke: "var(--truth)", "stroke-width": 4, "stroke-opacity": 0.55 }, root);
      svg("path", { d: path(run.map.track), fill: "none", stroke: colour(i), "stroke-width": 1.6 }, root);
    });
    const goals = svg("g", {}, root);
    const named = runs[0].map.goals.length <= 40;
    const taken = [];
    runs[0].map.goals.forEach(g => {
      const circle = svg("circle", { cx: px(g.x), cy: py(g.y), r: Math.max(4, g.r * scale), fill: g.done ? "var(--goal)" : "none", "fill-opacity": 0.25, stroke: g.done ? "var(--goal)" : "var(--bad)", "stroke-width": 1.5 }, goals);
      svg("title", {}, circle, `goal ${g.name}${g.done ? ", done" : ""}`);
      const at = [px(g.x) + 8, py(g.y) - 7];
      if (named && !taken.some(t => Math.abs(t[0] - at[0]) < 34 && Math.abs(t[1] - at[1]) < 14)) {
        taken.push(at);
        svg("text", { x: at[0], y: at[1] }, goals, g.name);
      }
    });
    const here = runs.map((run, i) => svg("circle", { r: 6, fill: colour(i), stroke: "var(--page)", "stroke-width": 2, visibility: "hidden" }, root));
    moves.push(() => runs.forEach((run, i) => {
      const track = run.map.track;
      const times = run.mapTimes || (run.mapTimes = track.filter((v, k) => k % 3 === 0));
      const at = view.cursor === null ? -1 : before(times, view.cursor);
      here[i].setAttribute("visibility", at < 0 ? "hidden" : "visible");
      if (at >= 0) { here[i].setAttribute("cx", px(track[3 * at + 1])); here[i].setAttribute("cy", py(track[3 * at + 2])); }
    }));
    root.addEventListener("click", event => { // the nearest place on the first track
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(root.getScreenCTM().inverse());
      const track = runs[0].map.track;
      let best = -1;
      let distance = Infinity;
      for (let i = 0; i < track.length; i += 3) {
        const d = Math.hypot(px(track[i + 1]) - point.x, py(track[i + 2]) - point.y);
        if (d < distance) { distance = d; best = i; }
      }
      if (best >= 0) setCursor(track[best]);
    });
    // A run without a state has no place; one far from the others has its own origin.
    const placed = runs.filter(run => run.map.track.length > 0);
    const apart = placed.slice(1).filter(run => !run.map.isShared).map(run => run.name);
    document.getElementById("map-note").textContent = `Metres east and north of the first state${several ? " of " + (placed[0] || runs[0]).name : ""}. `
      + (apart.length ? `Elsewhere, and drawn from its own first state: ${apart.join(", ")}. ` : "")
      + `Circles are goals${several ? " of " + runs[0].name : ""} with their threshold: filled, reached; red, not. `
      + (runs[0].map.truth && !several ? "Wide grey: true track. " : "") + (runs[0].map.objects.length || runs[0].map.cells.squares.length ? "Orange: what was seen in the way. " : "") + "Click: move the cursor there.";
  };
  // Omits a section without content in any run.
  const section = (id, isThere, draw) => {
    if (runs.some(isThere)) draw(); else document.getElementById(id).remove();
  };
  section("map-section", run => run.map, drawMap);

  // --- charts
  const WIDTH = 1140;
  const HEIGHT = 210;
  const LEFT = 70;
  const RIGHT = 16;
  const TOP = 30;
  const BOTTOM = 24;
  const x = t => LEFT + (t - view.from) / (view.to - view.from) * (WIDTH - LEFT - RIGHT);
  const atX = px => view.from + (px - LEFT) / (WIDTH - LEFT - RIGHT) * (view.to - view.from);

  const interact = root => {
    let pressed = null;
    const where = event => new DOMPoint(event.clientX, event.clientY).matrixTransform(root.getScreenCTM().inverse()).x;
    const band = svg("rect", { y: TOP, height: 0, fill: "var(--c0)", "fill-opacity": 0.18, visibility: "hidden" }, root);
    root.addEventListener("pointerdown", event => { pressed = where(event); root.setPointerCapture(event.pointerId); });
    root.addEventListener("pointermove", event => {
      const at = where(event);
      if (pressed === null) { setCursor(Math.max(view.from, Math.min(view.to, atX(at)))); return; }
      band.setAttribute("visibility", "visible");
      band.setAttribute("x", Math.min(at, pressed));
      band.setAttribute("width", Math.abs(at - pressed));
      band.setAttribute("height", Math.max(0, root.viewBox.baseVal.height - TOP - BOTTOM));
    });
    root.addEventListener("pointerup", event => {
      const at = where(event);
      band.setAttribute("visibility", "hidden");
      if (pressed !== null && Math.abs(at - pressed) > 8) setSpan(atX(Math.min(at, pressed)), atX(Math.max(at, pressed)));
      pressed = null;
    });
    root.addEventListener("dblclick", () => setSpan(0, longest));
  };

  const timeAxis = (group, height) => timeMarks(view.from, view.to).forEach(m => {
    svg("line", { class: "grid", x1: x(m), x2: x(m), y1: TOP, y2: height - BOTTOM }, group);
    svg("text", { class: "soft", x: x(m), y: height - 7, "text-anchor": "middle" }, group, time(m));
  });

  // In a comparison, colours are runs, and strokes are the lines of a run; the legend has the stroke before each name.
  const STROKES = [{ dash: "", sign: "\u2014" }, { dash: "6 4", sign: "- -" }, { dash: "2 3", sign: "\u00b7\u00b7\u00b7" }, { dash: "8 3 2 3", sign: "-\u00b7-" }];
  const drawChart = title => {
    const lines = [];
    let unit = "";
    let sigma = null;
    runs.forEach((run, r) => {
      const chart = run.charts.find(c => c.title === title);
      if (!chart) return;
      unit = chart.unit;
      if (!several && chart.sigma) sigma = chart.sigma;
      chart.lines.forEach((line, i) => lines.push({
        line, name: several ? (i === 0 ? run.name + (line.name ? ": " : "") : "") + (chart.lines.length > 1 ? STROKES[i % 4].sign + "\u00a0" : "") + line.name : line.name, colour: colour(several ? r : i),
        dash: several ? STROKES[i % 4].dash : line.name === "true" ? "5 3" : "" }));
    });
    if (lines.length === 0 && !sigma) return;
    const crowded = lines.length > 4; // then the legend has a separate line
    const TOP = crowded ? 50 : 30;
    const root = svg("svg", { class: "plot", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": title }, document.getElementById("charts"));
    svg("text", { x: LEFT, y: 19, "font-weight": 600, style: "font-weight:600" }, root, (several ? title.replace(", and 2σ as estimated", "") : title) + (unit ? ` [${unit}]` : ""));
    const clip = "clip" + Math.random().toString(36).slice(2);
    svg("rect", { x: LEFT, y: TOP, width: WIDTH - LEFT - RIGHT, height: HEIGHT - TOP - BOTTOM }, svg("clipPath", { id: clip }, svg("defs", {}, root)));
    const body = svg("g", {}, root);
    const cursor = svg("line", { class: "cursor", y1: TOP, y2: HEIGHT - BOTTOM, visibility: "hidden" }, root);
    const legend = svg("text", crowded ? { x: LEFT, y: 39 } : { x: WIDTH - RIGHT, y: 19, "text-anchor": "end" }, root);
    interact(root);
    const draw = () => {
      body.replaceChildren();
      let low = Infinity;
      let high = -Infinity;
      const include = v => { low = Math.min(low, v); high = Math.max(high, v); };
      const span = line => {
        const from = Math.max(0, before(line.t, view.from));
        return [from, Math.min(line.t.length - 1, before(line.t, view.to) + 1)];
      };
      lines.forEach(({ line }) => { const [a, b] = span(line); for (let i = a; i <= b; i++) include(line.v[i]); });
      if (sigma) { // includes the band, but not its large values before the estimate converges
        const [a, b] = span(sigma);
        const sorted = sigma.v.slice(a, b + 1).sort((p, q) => p - q);
        const usual = 2 * (sorted[Math.floor(sorted.length * 0.95)] || 0);
        include(usual); include(-usual);
      }
      if (low > high) return;
      const room = high > low ? (high - low) * 0.06 : Math.max(1e-3, Math.abs(high) * 0.05);
      low -= room;
      high += room;
      const y = v => TOP + (high - v) / (high - low) * (HEIGHT - TOP - BOTTOM);
      marks(low, high, 5).forEach(m => {
        svg("line", { class: m === 0 ? "zero" : "grid", x1: LEFT, x2: WIDTH - RIGHT, y1: y(m), y2: y(m) }, body);
        svg("text", { class: "soft", x: LEFT - 6, y: y(m) + 4, "text-anchor": "end" }, body, number(+m.toPrecision(12)));
      });
      timeAxis(body, HEIGHT);
      const inside = svg("g", { "clip-path": `url(#${clip})` }, body);
      if (sigma) {
        const [a, b] = span(sigma);
        let upper = "";
        let lower = "";
        for (let i = a; i <= b; i++) {
          const at = x(sigma.t[i]).toFixed(1);
          upper += (upper ? "L" : "M") + at + " " + y(2 * sigma.v[i]).toFixed(1);
          lower = "L" + at + " " + y(-2 * sigma.v[i]).toFixed(1) + lower;
        }
        if (upper) svg("path", { d: upper + lower + "Z", fill: "var(--soft)", "fill-opacity": 0.22 }, inside);
      }
      lines.forEach(({ line, colour: stroke, dash }) => {
        const [a, b] = span(line);
        let d = "";
        for (let i = a; i <= b; i++) d += (d ? "L" : "M") + x(line.t[i]).toFixed(1) + " " + y(line.v[i]).toFixed(1);
        svg("path", { d, fill: "none", stroke, "stroke-width": 1.4, "stroke-dasharray": dash, "stroke-linejoin": "round" }, inside);
      });
    };
    const move = () => {
      const shown = view.cursor !== null && view.cursor >= view.from && view.cursor <= view.to;
      cursor.setAttribute("visibility", shown ? "visible" : "hidden");
      if (shown) { cursor.setAttribute("x1", x(view.cursor)); cursor.setAttribute("x2", x(view.cursor)); }
      legend.replaceChildren();
      lines.slice(0, 8).forEach(({ line, name, colour: fill }) => {
        const at = view.cursor === null ? -1 : before(line.t, view.cursor);
        svg("tspan", { fill, style: `fill:${fill}` }, legend, `${name}${at >= 0 ? " " + number(line.v[at]) : ""}   `);
      });
      if (sigma) {
        const at = view.cursor === null ? -1 : before(sigma.t, view.cursor);
        svg("tspan", { style: "fill:var(--soft)" }, legend, "2σ" + (at >= 0 ? " ±" + number(2 * sigma.v[at]) : ""));
      }
    };
    draw();
    move();
    redraws.push(draw);
    moves.push(move);
  };
  [...new Set(runs.flatMap(run => run.charts.map(chart => chart.title)))].forEach(drawChart);

  // --- condition of services
  section("health-section", run => run.timeline.conditions, () => {
    const parent = document.getElementById("health");
    const rows = runs.flatMap(run => run.timeline.conditions.map(row => ({ ...row, run })));
    const fills = { ALIVE: "var(--c2)", STOPPED: "var(--c7)", STARTING: "var(--c6)", UNWATCHED: "var(--c7)" };
    if (rows.length === 0) {
      element("p", { class: "note" }, parent, "No reports from a health monitor.");
    } else {
      const height = TOP + rows.length * 22 + BOTTOM;
      const names = 170;
      const root = svg("svg", { class: "plot", viewBox: `0 0 ${WIDTH} ${height}`, role: "img", "aria-label": "Condition of services" }, parent);
      const body = svg("g", {}, root);
      const cursor = svg("line", { class: "cursor", y1: TOP, y2: height - BOTTOM, visibility: "hidden" }, root);
      const xs = t => names + (t - view.from) / (view.to - view.from) * (WIDTH - names - RIGHT);
      const draw = () => {
        body.replaceChildren();
        timeMarks(view.from, view.to).forEach(m => svg("text", { class: "soft", x: xs(m), y: height - 7, "text-anchor": "middle" }, body, time(m)));
        svg("text", { class: "soft", x: names, y: 19 }, body, "green: alive; grey: stopped; red: anything else");
        rows.forEach((row, i) => {
          const top = TOP + i * 22;
          svg("text", { x: 8, y: top + 14 }, body, (several ? row.run.name + ": " : "") + row.service);
          row.changes.forEach((change, k) => {
            const end = k + 1 < row.changes.length ? row.changes[k + 1].t : row.run.durationS;
            const from = Math.max(change.t, view.from);
            const to = Math.min(end, view.to);
            if (to < from) return;
            const bar = svg("rect", { x: xs(from), y: top + 3, width: Math.max(1.5, xs(to) - xs(from)), height: 15, fill: fills[change.condition] || "var(--bad)" }, body);
            svg("title", {}, bar, `${row.service} ${change.condition} from ${time(change.t)} to ${time(end)}`);
          });
        });
      };
      draw();
      redraws.push(draw);
      moves.push(() => {
        const shown = view.cursor !== null && view.cursor >= view.from && view.cursor <= view.to;
        cursor.setAttribute("visibility", shown ? "visible" : "hidden");
        if (shown) { cursor.setAttribute("x1", xs(view.cursor)); cursor.setAttribute("x2", xs(view.cursor)); }
      });
    }
  });

  // --- events
  {
    const parent = document.getElementById("events");
    const events = runs.flatMap((run, r) => run.timeline.events.map(event => ({ ...event, r, run }))).sort((a, b) => a.t - b.t);
    if (events.length === 0) element("p", {}, parent, "None.");
    events.forEach(event => {
      const row = element("button", { class: event.bad ? "bad" : "", type: "button" }, parent);
      element("span", {}, row, time(event.t));
      element("span", { class: "kind" }, row, event.kind);
      element("span", { class: "text" }, row, (several ? event.run.name + ": " : "") + event.text);
      row.addEventListener("click", () => {
        parent.querySelectorAll(".chosen").forEach(other => other.classList.remove("chosen"));
        row.classList.add("chosen");
        if (event.t < view.from || event.t > view.to) setSpan(0, longest);
        setCursor(event.t);
      });
    });
    const leftOut = runs.reduce((sum, run) => sum + run.timeline.leftOut, 0);
    if (leftOut) element("p", {}, parent, `${leftOut} more are not shown.`);
  }

  // --- tables
  section("latency-section", run => run.latency, () => {
    const table = element("table", {}, document.getElementById("latency"));
    const head = element("tr", {}, table);
    (several ? ["run"] : []).concat("channel", "messages", "rate", "median", "99 %", "longest").forEach(text => element("th", {}, head, text));
    runs.forEach(run => run.latency.forEach(each => {
      const row = element("tr", {}, table);
      if (several) element("td", {}, row, run.name);
      element("td", {}, row, each.channel);
      const rate = each.messages > 1 ? +each.rateHz.toPrecision(3) : null; // one message has no rate
      [[each.messages, ""], [rate, " Hz"], [each.p50Ms, " ms"], [each.p99Ms, " ms"], [each.maxMs, " ms"]]
        .forEach(([value, unit]) => element("td", { class: "number" }, row, value === null ? "–" : number(value) + unit));
    }));
  });
  {
    const place = document.getElementById("facts");
    const facts = element("table", {}, place);
    const folded = element("details", {}, place);
    element("summary", {}, folded, "Initial inputs of services");
    const executions = element("table", {}, folded);
    runs.forEach(run => run.facts.forEach(fact => {
      const row = element("tr", {}, fact.name.startsWith("execution/") ? executions : facts);
      if (several) element("td", {}, row, run.name);
      element("th", {}, row, fact.name.replace(/^execution\//, ""));
      element("td", {}, row, fact.value);
    }));
    folded.hidden = !executions.hasChildNodes();
  }

  const hash = /^#t=([0-9.]+)$/.exec(location.hash); // report.html#t=125 opens at that second
  if (hash) setCursor(+hash[1]);
})();
