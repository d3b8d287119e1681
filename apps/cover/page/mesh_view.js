// The mesh of a report, to zoom, pan and look at. Data comes from the page itself (view_data.cpp);
// drawn by WebGL, or on a plain canvas where there is none. No library, no network.
(() => {
'use strict';
const data = JSON.parse(document.getElementById('mesh-data').textContent);
const root = document.getElementById('mesh-view');

// ---- the mesh ----

function bytes(text) {
  const raw = atob(text), out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out;
}
function integers(text, width) {  // little-endian, without a sign
  const from = bytes(text), out = new Uint32Array(from.length / width);
  for (let i = 0; i < out.length; ++i)
    for (let k = 0; k < width; ++k) out[i] += from[i * width + k] * 2 ** (8 * k);
  return out;
}
const points = integers(data.points, 4);                 // x, y in steps from data.low
const corners = integers(data.corners, data.indexBytes);  // three of each triangle
const lines = integers(data.lines, data.indexBytes);      // two ends of each; contacts last
const angles = integers(data.angles, 3);                  // largest, smallest of each, of 2^24 - 1
const count = corners.length / 3, full = 2 ** 32 - 1;
const regionOf = new Uint32Array(count);
for (let r = 0, t = 0; r < data.counts.length; ++r)
  for (let k = 0; k < data.counts[r]; ++k) regionOf[t++] = r;
const X = v => points[2 * v], Y = v => points[2 * v + 1];
const degrees = k => angles[k] * 180 / (2 ** 24 - 1);
const largest = t => degrees(2 * t), smallest = t => degrees(2 * t + 1);
const [NAME, MATERIAL, LARGEST, LIMIT, SMALLEST, RHO, WORST] = [0, 1, 2, 3, 4, 5, 6];
const extent = data.extent.map(n => Math.max(n, 1));

/// Couplings of the box method, cot a + cot b for the edges opposite to the three corners; made when
/// they are first wanted.
let couplings = null;
function makeCouplings() {
  couplings = new Float32Array(3 * count);
  const other = new Map();
  for (let t = 0; t < count; ++t) {
    for (let k = 0; k < 3; ++k) {
      const c = corners[3 * t + k], a = corners[3 * t + (k + 1) % 3], b = corners[3 * t + (k + 2) % 3];
      const ux = X(a) - X(c), uy = Y(a) - Y(c), vx = X(b) - X(c), vy = Y(b) - Y(c);
      const cot = (ux * vx + uy * vy) / Math.max(ux * vy - uy * vx, 1e-300);
      couplings[3 * t + k] += cot;
      const key = Math.min(a, b) * (points.length / 2) + Math.max(a, b), at = other.get(key);
      if (at === undefined) {
        other.set(key, 3 * t + k);
      } else if (regionOf[t] === regionOf[(at - at % 3) / 3]) {  // each region is a problem of its own
        const own = couplings[at];
        couplings[at] += cot;
        couplings[3 * t + k] += own;
      }
    }
  }
}
const coupling = t => Math.min(couplings[3 * t], couplings[3 * t + 1], couplings[3 * t + 2]);

/// Which triangle is at a place: triangles by the cells of a grid.
const grid = (() => {
  const n = Math.max(1, Math.min(1024, Math.ceil(Math.sqrt(count / 2))));
  const cell = v => Math.min(n - 1, Math.floor(v / (full + 1) * n));
  const first = new Uint32Array(n * n + 1);
  const each = (t, use) => {
    const [a, b, c] = [corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]];
    const x0 = cell(Math.min(X(a), X(b), X(c))), x1 = cell(Math.max(X(a), X(b), X(c)));
    const y0 = cell(Math.min(Y(a), Y(b), Y(c))), y1 = cell(Math.max(Y(a), Y(b), Y(c)));
    for (let y = y0; y <= y1; ++y) for (let x = x0; x <= x1; ++x) use(y * n + x);
  };
  for (let t = 0; t < count; ++t) each(t, k => ++first[k + 1]);
  for (let k = 0; k < n * n; ++k) first[k + 1] += first[k];
  const next = first.slice(), items = new Uint32Array(first[n * n]);
  for (let t = 0; t < count; ++t) each(t, k => { items[next[k]++] = t; });
  return {
    at(x, y) {
      if (x < 0 || y < 0 || x > full || y > full) return -1;
      const k = cell(y) * n + cell(x);
      for (let i = first[k]; i < first[k + 1]; ++i) {
        const t = items[i], [a, b, c] = [corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]];
        const side = (p, q) => (X(q) - X(p)) * (y - Y(p)) - (Y(q) - Y(p)) * (x - X(p));
        if (side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0) return t;
      }
      return -1;
    }
  };
})();

// ---- colours ----

const dark = matchMedia('(prefers-color-scheme: dark)');
const materials = [...new Set(data.regions.map(r => r[MATERIAL]))];
const PALETTE = [[158, 193, 223], [242, 196, 141], [172, 211, 158], [229, 159, 154], [196, 177, 214], [246, 224, 138],
  [150, 210, 203], [222, 176, 205], [203, 189, 171], [190, 206, 121], [166, 178, 196], [238, 186, 186]];
function materialColour(n) {
  const base = n < PALETTE.length ? PALETTE[n] : [0, 2, 4].map(k =>
    Math.round(200 + 45 * Math.cos(6.2832 * ((n * 0.618034) % 1) + k)));
  return dark.matches ? base.map(c => Math.round(c * 0.62)) : base;
}
function regionColour(r) {
  const colour = materialColour(materials.indexOf(data.regions[r][MATERIAL])), f = [1, 0.93, 1.06, 0.88, 1.1][r % 5];
  return colour.map(c => Math.min(255, Math.round(c * f)));
}
const RAMP = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
function ramp(s) {
  const k = Math.min(3, Math.floor(4 * s)), f = 4 * s - k;
  return RAMP[k].map((c, i) => Math.round(c + f * (RAMP[k + 1][i] - c)));
}
const clamp = s => Math.min(1, Math.max(0, s));
const MODES = {
  regions: { name: 'Regions' },
  largest: { name: 'Largest angle', low: '60°', high: '180°', of: t => ramp(clamp((largest(t) - 60) / 120)) },
  smallest: { name: 'Smallest angle', low: '60°', high: '0°', of: t => ramp(clamp(1 - smallest(t) / 60)) },
  coupling: { name: 'Coupling (box method)', low: '0', high: '3', more: [['negative', [208, 40, 40]]],
    of: t => coupling(t) < 0 ? [208, 40, 40] : ramp(clamp(1 - coupling(t) / 3)), flip: true },
  gap: { name: 'Gap to the limit', low: '0°', high: '30° above what no mesh goes below',
    of: t => ramp(clamp((data.regions[regionOf[t]][LARGEST] - data.regions[regionOf[t]][LIMIT]) / 30)) },
};
let mode = 'regions';
function colours() {
  const out = new Uint8Array(3 * count);
  if (mode === 'coupling' && !couplings) makeCouplings();
  const known = mode === 'regions' ? data.regions.map((_, r) => regionColour(r)) : null;
  for (let t = 0; t < count; ++t) {
    const c = known ? known[regionOf[t]] : MODES[mode].of(t);
    out[3 * t] = c[0]; out[3 * t + 1] = c[1]; out[3 * t + 2] = c[2];
  }
  return out;
}

// ---- the page ----

const make = (tag, attributes = {}, parent = null) => {
  const node = Object.assign(document.createElement(tag), attributes);
  if (parent) parent.append(node);
  return node;
};
const tools = make('div', { className: 'tools' }, root);
const choose = make('select', { ariaLabel: 'Colours', id: 'mesh-mode' }, tools);
for (const [key, value] of Object.entries(MODES)) make('option', { value: key, textContent: value.name }, choose);
const button = (text, title, act) => make('button', { type: 'button', textContent: text, title, onclick: act }, tools);
button('+', 'Zoom in', () => zoomAt(width / 2, height / 2, 1.6));
button('−', 'Zoom out', () => zoomAt(width / 2, height / 2, 1 / 1.6));
button('All', 'Show all of it', () => fly(whole()));
button('Worst', 'Go to the largest angle', () => goTo(worstRegion()));
const edgeLabel = make('label', {}, tools), edgeBox = make('input', { type: 'checkbox', checked: true }, edgeLabel);
edgeLabel.append('edges');
const stage = make('div', { className: 'stage' }, root);
const canvas = make('canvas', {}, stage);
const over = make('canvas', { className: 'over', tabIndex: 0, ariaLabel: 'The mesh; + and - zoom, arrows pan, 0 shows all of it' }, stage);
const tip = make('div', { className: 'tip', hidden: true }, stage);
const key = make('div', { className: 'key' }, root);
if (count < data.all)
  make('div', { className: 'told', textContent: `Of ${data.all.toLocaleString('en')} triangles, this page holds the ` +
    `${count.toLocaleString('en')} nearest to the largest angle, and all lines.` }, root);

const css = colour => `rgb(${colour.join(' ')})`;
function drawKey() {
  key.textContent = '';
  const entry = (text, colour) => {
    const span = make('span', {}, key);
    make('i', {}, span).style.background = css(colour);
    span.append(text);
  };
  if (mode === 'regions') {
    const most = 14, names = new Map();
    for (const r of data.regions) names.set(r[MATERIAL], (names.get(r[MATERIAL]) || 0) + 1);
    materials.slice(0, most).forEach((name, n) =>
      entry(names.get(name) > 1 ? `${name}, ${names.get(name)} regions` : name, materialColour(n)));
    if (materials.length > most) make('span', { textContent: `and ${materials.length - most} more materials` }, key);
  } else {
    const m = MODES[mode];
    make('span', { textContent: m.low }, key);
    const stops = [0, 0.25, 0.5, 0.75, 1].map(s => css(ramp(m.flip ? 1 - s : s)));
    make('span', { className: 'bar' }, key).style.background = `linear-gradient(90deg, ${stops})`;
    make('span', { textContent: m.high }, key);
    for (const [text, colour] of m.more || []) entry(text, colour);
  }
  data.contacts.forEach(([name], k) => { if (k < 12) entry(/^-?\d+$/.test(name) ? `marker ${name}` : name, CONTACTS[k % CONTACTS.length]); });
}
const CONTACTS = [[192, 32, 38], [24, 90, 170], [20, 120, 70], [150, 50, 140], [190, 95, 0], [0, 120, 135]];

// ---- the view: the place in the middle, in steps, and pixels per step ----

let width = 1, height = 1, ratio = 1, view = { x: 0, y: 0, s: 1 }, wanted = false, flight = 0;
const whole = () => ({ x: extent[0] / 2, y: extent[1] / 2, s: 0.94 * Math.min(width / extent[0], height / extent[1]) });
const toX = x => width / 2 + (x - view.x) * view.s, toY = y => height / 2 - (y - view.y) * view.s;
const fromX = px => view.x + (px - width / 2) / view.s, fromY = py => view.y - (py - height / 2) / view.s;
function limited(s) { const all = whole().s; return Math.min(Math.max(s, all / 3), 40); }
function zoomAt(px, py, factor) {
  const x = fromX(px), y = fromY(py);
  flight = 0;
  view.s = limited(view.s * factor);
  view.x = x - (px - width / 2) / view.s;
  view.y = y + (py - height / 2) / view.s;
  redraw();
}
const calm = matchMedia('(prefers-reduced-motion: reduce)');
function fly(to) {
  if (calm.matches) { view = to; return redraw(); }
  const from = { ...view }, start = performance.now(), id = ++flight;
  const step = now => {
    if (flight !== id) return;
    const f = clamp((now - start) / 400), e = f * f * (3 - 2 * f), s = from.s * (to.s / from.s) ** e;
    // Straight on the screen, not in the plane: the place moves as the scale does.
    const g = Math.abs(to.s - from.s) < 1e-12 * to.s ? e : (1 / from.s - 1 / s) / (1 / from.s - 1 / to.s);
    view = { x: from.x + g * (to.x - from.x), y: from.y + g * (to.y - from.y), s };
    redraw();
    if (f < 1) requestAnimationFrame(step); else flight = 0;
  };
  requestAnimationFrame(step);
}

// ---- drawing ----

const gl = canvas.getContext('webgl', { antialias: true, alpha: false });
let paint;
if (gl) {
  // Places are whole numbers of 32 bits, handed on as two halves that floats hold exactly: deep
  // zooms do not tremble.
  const shader = (type, text) => { const s = gl.createShader(type); gl.shaderSource(s, text); gl.compileShader(s); return s; };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `attribute vec4 at; attribute vec4 colour; uniform vec4 middle; uniform vec2 scale;
    uniform vec4 ink; varying vec4 c; void main() { vec2 d = (at.xy - middle.xy) * 65536.0 + (at.zw - middle.zw);
    gl_Position = vec4(d * scale, 0.0, 1.0); c = ink.a > 0.0 ? ink : colour; }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, 'precision mediump float; varying vec4 c; void main() { gl_FragColor = vec4(c.rgb * c.a, c.a); }'));
  gl.bindAttribLocation(program, 0, 'at');
  gl.bindAttribLocation(program, 1, 'colour');
  gl.linkProgram(program);
  gl.useProgram(program);
  const uniform = name => gl.getUniformLocation(program, name);
  const uMiddle = uniform('middle'), uScale = uniform('scale'), uInk = uniform('ink');
  const buffer = values => { const b = gl.createBuffer(); gl.bindBuffer(gl.ARRAY_BUFFER, b); gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW); return b; };
  const places = order => {
    const out = new Float32Array(4 * order.length);
    order.forEach((v, i) => { out[4 * i] = X(v) >>> 16; out[4 * i + 1] = Y(v) >>> 16; out[4 * i + 2] = X(v) & 65535; out[4 * i + 3] = Y(v) & 65535; });
    return buffer(out);
  };
  const ofTriangles = places(corners), ofLines = places(lines);
  // Each side once where two triangles have it: from the lower corner to the higher; the hull is among the lines.
  const sides = new Uint32Array(6 * count);
  let used = 0;
  for (let t = 0; t < count; ++t)
    for (let k = 0; k < 3; ++k) {
      const a = corners[3 * t + k], b = corners[3 * t + (k + 1) % 3];
      if (a < b) { sides[used++] = a; sides[used++] = b; }
    }
  const ofSides = places(sides.subarray(0, used)), ofColours = gl.createBuffer();
  gl.enableVertexAttribArray(0);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  const draw = (kind, from, n, ink) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, from);
    gl.vertexAttribPointer(0, 4, gl.FLOAT, false, 0, 0);
    gl.uniform4fv(uInk, ink);
    gl.drawArrays(kind, 0, n);
  };
  paint = {
    recolour() {
      const flat = colours(), out = new Uint8Array(12 * count);  // four bytes a corner: whole words
      for (let t = 0; t < count; ++t) for (let k = 0; k < 12; ++k) out[12 * t + k] = k % 4 === 3 ? 255 : flat[3 * t + k % 4];
      gl.bindBuffer(gl.ARRAY_BUFFER, ofColours);
      gl.bufferData(gl.ARRAY_BUFFER, out, gl.STATIC_DRAW);
    },
    all(back, edge, edgeShare) {
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(back[0] / 255, back[1] / 255, back[2] / 255, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      const hx = Math.floor(view.x / 65536), hy = Math.floor(view.y / 65536);
      gl.uniform4f(uMiddle, hx, hy, view.x - 65536 * hx, view.y - 65536 * hy);
      gl.uniform2f(uScale, 2 * view.s / width, 2 * view.s / height);
      gl.enableVertexAttribArray(1);
      gl.bindBuffer(gl.ARRAY_BUFFER, ofColours);
      gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
      draw(gl.TRIANGLES, ofTriangles, 3 * count, [0, 0, 0, 0]);
      gl.disableVertexAttribArray(1);
      const ink = share => [...edge.map(c => c / 255), share];
      if (edgeShare > 0) draw(gl.LINES, ofSides, used, ink(edgeShare));
      draw(gl.LINES, ofLines, lines.length, ink(0.9));
    },
  };
} else {
  const plain = canvas.getContext('2d');
  let flat = null;
  paint = {
    recolour() { flat = colours(); },
    all(back, edge, edgeShare) {
      plain.setTransform(ratio, 0, 0, ratio, 0, 0);
      plain.fillStyle = css(back);
      plain.fillRect(0, 0, width, height);
      const x0 = fromX(0), x1 = fromX(width), y0 = fromY(height), y1 = fromY(0);
      plain.lineWidth = 1;
      for (let t = 0; t < count; ++t) {
        const [a, b, c] = [corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]];
        if (Math.max(X(a), X(b), X(c)) < x0 || Math.min(X(a), X(b), X(c)) > x1 ||
            Math.max(Y(a), Y(b), Y(c)) < y0 || Math.min(Y(a), Y(b), Y(c)) > y1) continue;
        plain.beginPath();
        plain.moveTo(toX(X(a)), toY(Y(a)));
        plain.lineTo(toX(X(b)), toY(Y(b)));
        plain.lineTo(toX(X(c)), toY(Y(c)));
        plain.closePath();
        plain.fillStyle = plain.strokeStyle = css([...flat.subarray(3 * t, 3 * t + 3)]);
        plain.fill();
        if (edgeShare > 0) plain.strokeStyle = `rgb(${edge.join(' ')} / ${edgeShare})`;
        plain.stroke();
      }
      plain.strokeStyle = css(edge);
      plain.beginPath();
      for (let l = 0; l < lines.length; l += 2) {
        plain.moveTo(toX(X(lines[l])), toY(Y(lines[l])));
        plain.lineTo(toX(X(lines[l + 1])), toY(Y(lines[l + 1])));
      }
      plain.stroke();
    },
  };
}

let marked = -1, hovered = -1;
function outline(pen, t, colour, wide) {
  pen.beginPath();
  for (let k = 0; k < 3; ++k) pen.lineTo(toX(X(corners[3 * t + k])), toY(Y(corners[3 * t + k])));
  pen.closePath();
  pen.lineWidth = wide;
  pen.strokeStyle = colour;
  pen.stroke();
}
function drawOver() {
  const pen = over.getContext('2d');
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.lineCap = 'round';
  pen.lineJoin = 'round';
  let at = 2 * data.plainLines;
  data.contacts.forEach(([, n], k) => {
    pen.beginPath();
    for (let i = 0; i < n; ++i, at += 2) {
      pen.moveTo(toX(X(lines[at])), toY(Y(lines[at])));
      pen.lineTo(toX(X(lines[at + 1])), toY(Y(lines[at + 1])));
    }
    pen.lineWidth = 3.5;
    pen.strokeStyle = css(CONTACTS[k % CONTACTS.length]);
    pen.stroke();
  });
  if (hovered >= 0) outline(pen, hovered, dark.matches ? '#fff' : '#000', 2);
  if (marked >= 0) {
    outline(pen, marked, '#e11d48', 3);
    const mean = of => (of(corners[3 * marked]) + of(corners[3 * marked + 1]) + of(corners[3 * marked + 2])) / 3;
    pen.beginPath();
    pen.arc(toX(mean(X)), toY(mean(Y)), 22, 0, 7);
    pen.lineWidth = 2;
    pen.stroke();
  }
}

const number = text => getComputedStyle(document.documentElement).getPropertyValue(text).trim()
  .slice(1).match(/../g).map(h => parseInt(h, 16));
/// The picture as it was last painted, and whether that takes so long that moving waits for it: then
/// the picture itself is moved, and painted again once hands rest.
let drawn = null, stale = true, slow = false, measured = 0, idle = 0;
function paintNow() {
  const start = performance.now();
  // Edges fade in once a triangle is worth some pixels; before, they would be all that is seen.
  const pixels = Math.sqrt(extent[0] * extent[1] / Math.max(data.all, 1)) * view.s;
  paint.all(number('--canvas'), number('--edge'), edgeBox.checked ? clamp((pixels - 2) / 12) * 0.45 : 0);
  if (++measured < 4) {
    if (gl) gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));  // waits for it
    slow = performance.now() - start > 30;
  }
  drawn = { ...view };
  stale = false;
  canvas.style.transform = '';
}
function movePicture() {
  const f = view.s / drawn.s;
  canvas.style.transform = `translate(${toX(drawn.x) - f * width / 2}px, ${toY(drawn.y) - f * height / 2}px) scale(${f})`;
  clearTimeout(idle);
  idle = setTimeout(() => { stale = true; redraw(); }, 180);
}
function redraw() {
  if (wanted) return;
  wanted = true;
  requestAnimationFrame(() => {
    wanted = false;
    const moves = drawn && (view.x !== drawn.x || view.y !== drawn.y || view.s !== drawn.s);
    if (stale || (moves && !slow)) paintNow(); else if (moves) movePicture();
    drawOver();
  });
}
function recolour() { paint.recolour(); drawKey(); stale = true; redraw(); }

// ---- hands ----

const angleText = value => (value > 0 && value < 0.005 ? value.toExponential(1) : value.toFixed(2)) + '°';
const digits = value => Number(value.toPrecision(7)).toString();
function show(px, py) {
  const t = grid.at(fromX(px), fromY(py));
  if (t !== hovered) { hovered = t; redraw(); }
  tip.hidden = t < 0;
  if (t < 0) return;
  if (!couplings) makeCouplings();
  const r = data.regions[regionOf[t]], x = data.low[0] + fromX(px) * data.step, y = data.low[1] + fromY(py) * data.step;
  tip.textContent = '';
  make('b', { textContent: r[NAME] }, tip);
  for (const text of [r[MATERIAL] === r[NAME] ? '' : r[MATERIAL],
    `angles ${angleText(smallest(t))} to ${angleText(largest(t))}`,
    `region: ${angleText(r[LARGEST])}, no mesh below ${angleText(r[LIMIT])}, rho ${r[RHO].toFixed(2)}`,
    `couplings ${[0, 1, 2].map(k => couplings[3 * t + k].toFixed(2)).join(', ')}`,
    `at ${digits(x)}, ${digits(y)}${data.unit ? ' ' + data.unit : ''}`])
    if (text) make('div', { textContent: text }, tip);
  const w = tip.offsetWidth, h = tip.offsetHeight;
  tip.style.left = `${Math.max(4, px + 16 + w > width ? px - w - 12 : px + 16)}px`;
  tip.style.top = `${Math.max(4, Math.min(py + 16, height - h - 4))}px`;
}
const hands = new Map();
const place = e => { const box = over.getBoundingClientRect(); return [e.clientX - box.left, e.clientY - box.top]; };
let moved = 0;
over.addEventListener('pointerdown', e => {
  over.setPointerCapture(e.pointerId);
  hands.set(e.pointerId, place(e));
  over.classList.add('held');
  flight = 0;
  moved = 0;
});
over.addEventListener('pointermove', e => {
  const now = place(e), before = hands.get(e.pointerId);
  if (!before) { show(...now); return; }
  moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
  const others = [...hands.entries()].filter(([id]) => id !== e.pointerId);
  if (others.length > 0) {
    const other = others[0][1], span = p => Math.max(8, Math.hypot(p[0] - other[0], p[1] - other[1]));
    const middle = [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2];
    view.x -= (now[0] - before[0]) / 2 / view.s;
    view.y += (now[1] - before[1]) / 2 / view.s;
    zoomAt(middle[0], middle[1], span(now) / span(before));
  } else {
    view.x -= (now[0] - before[0]) / view.s;
    view.y += (now[1] - before[1]) / view.s;
    if (moved > 4) tip.hidden = true;
    redraw();
  }
  hands.set(e.pointerId, now);
});
const release = e => {
  if (hands.delete(e.pointerId) && moved < 5 && e.type === 'pointerup') show(...place(e));
  if (hands.size === 0) over.classList.remove('held');
};
over.addEventListener('pointerup', release);
over.addEventListener('pointercancel', release);
over.addEventListener('pointerleave', e => { if (e.pointerType === 'mouse' && hands.size === 0) { hovered = -1; tip.hidden = true; redraw(); } });
over.addEventListener('wheel', e => {
  e.preventDefault();
  zoomAt(...place(e), Math.exp(-Math.max(-100, Math.min(100, e.deltaY * (e.deltaMode === 1 ? 33 : 1))) * 0.004));
  show(...place(e));
}, { passive: false });
over.addEventListener('dblclick', e => zoomAt(...place(e), 2.5));
over.addEventListener('keydown', e => {
  const step = 60 / view.s;
  const act = { '+': () => zoomAt(width / 2, height / 2, 1.4), '-': () => zoomAt(width / 2, height / 2, 1 / 1.4), 0: () => fly(whole()),
    ArrowLeft: () => { view.x -= step; redraw(); }, ArrowRight: () => { view.x += step; redraw(); },
    ArrowUp: () => { view.y += step; redraw(); }, ArrowDown: () => { view.y -= step; redraw(); } }[e.key];
  if (act) { e.preventDefault(); act(); }
});
choose.onchange = () => { mode = choose.value; recolour(); };
edgeBox.onchange = () => { stale = true; redraw(); };

// ---- rows of the table ----

const worstRegion = () => data.regions.reduce((best, r, k) =>
  r[WORST] >= 0 && (best < 0 || r[LARGEST] > data.regions[best][LARGEST]) ? k : best, -1);
function goTo(region) {
  const t = region < 0 ? -1 : data.regions[region][WORST];
  if (t < 0) return;
  marked = t;
  const xs = [0, 1, 2].map(k => X(corners[3 * t + k])), ys = [0, 1, 2].map(k => Y(corners[3 * t + k]));
  const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 1);
  const mean = all => all.reduce((sum, one) => sum + one / 3, 0);  // inside, whatever its shape
  fly({ x: mean(xs), y: mean(ys), s: limited(Math.min(width, height) / 4 / size) });
}
const table = document.querySelector('table.regions');
if (table) {
  table.classList.add('live');
  table.addEventListener('click', e => {
    const row = e.target.closest('tr[data-region]');
    if (!row) return;
    table.querySelectorAll('tr.chosen').forEach(other => other.classList.remove('chosen'));
    row.classList.add('chosen');
    goTo(Number(row.dataset.region) - 1);
    root.scrollIntoView({ block: 'nearest', behavior: calm.matches ? 'auto' : 'smooth' });
  });
}

// ---- begin ----

function resize() {
  // As high as the drawing needs it, within the window.
  const high = Math.min(0.66 * innerHeight, 640, Math.max(260, root.clientWidth * extent[1] / extent[0] + 24));
  if (Math.abs(stage.clientHeight - high) > 1) stage.style.height = `${high}px`;
  const fits = Math.abs(view.s - whole().s) < 1e-9 * view.s || width === 1;
  width = Math.max(1, stage.clientWidth);
  height = Math.max(1, stage.clientHeight);
  ratio = Math.min(3, window.devicePixelRatio || 1);
  for (const c of [canvas, over]) { c.width = Math.round(width * ratio); c.height = Math.round(height * ratio); }
  if (fits) view = whole();
  stale = true;
  redraw();
}
new ResizeObserver(resize).observe(stage);
dark.addEventListener('change', recolour);
resize();
recolour();
root.dataset.ready = gl ? 'webgl' : 'canvas';
root.meshView = { get view() { return view; }, get hovered() { return hovered; }, get marked() { return marked; }, goTo, toX, toY, largest, count };
})();
