// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The maps of report.html: every <figure class="map"> holds its data as JSON and becomes a canvas with layers to
// switch and the values of the cell under the pointer. Follows map_data.js. Texts go in as text, never as HTML.
const NO_CELL = -1;

const make = (tag, parent, text, cls) => {
  const element = document.createElement(tag);
  if (text) element.textContent = text;
  if (cls) element.className = cls;
  parent.append(element);
  return element;
};

class Viewer {
  constructor(figure, map) {
    Object.assign(this, {map, figure, layer: map.layers[0], cell: NO_CELL, pinned: false, fingers: new Map()});
    const bar = make('div', figure, '', 'map-bar');
    const label = make('label', bar, 'Layer ');
    this.select = make('select', label);
    map.layers.forEach((l, k) => { make('option', this.select, l.name).value = k; });
    this.select.onchange = () => this.show(map.layers[this.select.value]);
    for (const [text, title, act] of [['+', 'Zoom in', () => this.zoom(1.5)], ['\u2212', 'Zoom out', () => this.zoom(1 / 1.5)],
      ['Fit', 'Show all', () => this.fit()]]) {
      const button = make('button', bar, text);
      button.type = 'button';
      button.title = title;
      button.onclick = act;
    }
    if (map.path.length) {
      const toggle = make('label', bar);
      this.track = make('input', toggle);
      this.track.type = 'checkbox';
      this.track.checked = true;
      toggle.append(' Trajectory');
      this.track.onchange = () => this.draw();
    }
    const body = make('div', figure, '', 'map-body');
    const stage = make('div', body, '', 'map-stage');
    this.canvas = make('canvas', stage);
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'Map. Arrow keys pan, plus and minus zoom, 0 shows all, shift with arrow keys steps through cells, Escape lets go.');
    this.scale = make('div', stage, '', 'map-scale');
    this.values = make('div', body, '', 'map-values');
    this.values.setAttribute('aria-live', 'polite');
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.show(this.layer);
    this.tell();
  }

  listen() {
    const on = (name, act) => this.canvas.addEventListener(name, act, {passive: false});
    on('wheel', e => { e.preventDefault(); this.zoom(Math.exp(Math.min(Math.max(-e.deltaY * (e.deltaMode ? 30 : 1), -100), 100) / 500), this.at(e)); });
    on('pointerdown', e => { this.canvas.setPointerCapture(e.pointerId); this.fingers.set(e.pointerId, this.at(e)); this.moved = this.fingers.size > 1; });
    on('pointermove', e => this.fingers.has(e.pointerId) ? this.drag(e) : this.point(this.at(e)));
    on('pointerup', e => this.release(e));
    on('pointercancel', e => this.fingers.delete(e.pointerId));
    on('pointerleave', () => { if (!this.pinned) this.pick(NO_CELL); });
    on('keydown', e => this.key(e));
  }

  at(e) {
    const box = this.canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  }

  drag(e) {
    const before = [...this.fingers.values()];
    const old = this.fingers.get(e.pointerId), now = this.at(e);
    if (!this.moved && Math.hypot(now[0] - old[0], now[1] - old[1]) < 4) return;
    this.moved = true;
    this.fingers.set(e.pointerId, now);
    const after = [...this.fingers.values()];
    const middle = points => [0, 1].map(k => points.reduce((sum, p) => sum + p[k], 0) / points.length);
    const [from, to] = [middle(before), middle(after)];
    this.left += to[0] - from[0];
    this.top += to[1] - from[1];
    if (after.length === 2) {
      const reach = points => Math.hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]) || 1;
      this.zoom(reach(after) / reach(before), to);
    }
    this.draw();
  }

  release(e) {
    if (this.fingers.delete(e.pointerId) && !this.moved) {
      this.pinned = false;
      this.point(this.at(e));
      this.pinned = this.cell !== NO_CELL;
      this.draw();
    }
  }

  key(e) {
    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    const acts = {'+': () => this.zoom(1.5), '=': () => this.zoom(1.5), '-': () => this.zoom(1 / 1.5), '0': () => this.fit(),
      Escape: () => { this.pinned = false; this.pick(NO_CELL); }};
    const step = arrows[e.key];
    if (step && e.shiftKey) {
      this.step(step);
    } else if (step) {
      this.left -= step[0] * 60;
      this.top += step[1] * 60;
      this.draw();
    } else if (acts[e.key] && !e.ctrlKey && !e.metaKey) {
      acts[e.key]();
    } else return;
    e.preventDefault();
  }

  // To the next cell; the first step starts in the middle of the view.
  step([dx, dy]) {
    const {width, height} = this.map;
    const here = this.cell !== NO_CELL ? this.cell : this.cellAt([this.canvas.clientWidth / 2, this.canvas.clientHeight / 2], true);
    const column = Math.min(Math.max(here % width + dx, 0), width - 1);
    const row = Math.min(Math.max(Math.floor(here / width) + dy, 0), height - 1);
    this.pinned = true;
    this.pick(row * width + column);
  }

  cellAt([x, y], nearest) {
    const inside = (v, most) => nearest ? Math.min(Math.max(v, 0), most - 1) : v;
    const column = inside(Math.floor((x - this.left) / this.size), this.map.width);
    const row = inside(this.map.height - 1 - Math.floor((y - this.top) / this.size), this.map.height);
    return column >= 0 && column < this.map.width && row >= 0 && row < this.map.height ? row * this.map.width + column : NO_CELL;
  }

  point(place) { if (!this.pinned) this.pick(this.cellAt(place)); }

  pick(cell) {
    if (cell === this.cell) return;
    this.cell = cell;
    this.tell();
    this.draw();
  }

  // What the cell is.
  tell() {
    const {map, cell} = this;
    this.values.replaceChildren();
    if (cell === NO_CELL) {
      make('p', this.values, 'Point at a cell for its values; click to keep them. Wheel, pinch or + and \u2212 zoom, dragging or arrow keys pan, shift with arrow keys steps from cell to cell.');
      return;
    }
    const x = map.x + (cell % map.width) * map.step, y = map.y + Math.floor(cell / map.width) * map.step;
    const metres = (from, k) => ((from + k) * map.cell_mm / 1000).toFixed(2);
    const span = from => map.step === 1 ? from : from + ' to ' + (from + map.step - 1);
    const table = make('table', this.values);
    const row = (name, value) => { const line = make('tr', table); make('th', line, name); make('td', line, value); };
    row('cell', span(x) + ', ' + span(y));
    row('x', metres(x, 0) + ' to ' + metres(x, map.step) + ' m');
    row('y', metres(y, 0) + ' to ' + metres(y, map.step) + ' m');
    if (!map.known[cell]) row('', 'nothing known');
    else for (const layer of map.layers)
      row(layer.name, layer.name === map.class ? map.names[layer.values[cell]] || 'code ' + layer.values[cell] : shown(layer, cell));
  }

  show(layer) {
    this.layer = layer;
    this.image = paint(this.map, layer);
    this.scale.replaceChildren();
    if (layer.name === this.map.class) {
      for (const [code, name, colour] of this.map.legend) {
        make('span', this.scale, '', 'swatch').style.background = colour;
        make('span', this.scale, name);
      }
    } else {
      const text = v => shown({...layer, values: [v]}, 0);
      make('span', this.scale, text(layer.range[0]));
      make('span', this.scale, '', 'ramp').style.background = 'linear-gradient(90deg,' + STOPS.map(c => 'rgb(' + c + ')') + ')';
      make('span', this.scale, text(layer.range[1]));
    }
    this.draw();
  }

  resize() {
    const fresh = !this.size;
    this.canvas.width = this.canvas.clientWidth * devicePixelRatio;
    this.canvas.height = this.canvas.clientHeight * devicePixelRatio;
    fresh ? this.fit() : this.draw();
  }

  fit() {
    this.size = Math.min(this.canvas.clientWidth / this.map.width, this.canvas.clientHeight / this.map.height) || 1;
    [this.least, this.most] = [this.size / 2, Math.max(120, this.size * 4)];
    this.left = (this.canvas.clientWidth - this.map.width * this.size) / 2;
    this.top = (this.canvas.clientHeight - this.map.height * this.size) / 2;
    this.draw();
  }

  zoom(factor, [x, y] = [this.canvas.clientWidth / 2, this.canvas.clientHeight / 2]) {
    const size = Math.min(Math.max(this.size * factor, this.least), this.most);
    this.left = x - (x - this.left) * size / this.size;
    this.top = y - (y - this.top) * size / this.size;
    this.size = size;
    this.draw();
  }

  draw() {
    if (!this.size) return;
    const {map, size, left, top} = this, pen = this.canvas.getContext('2d');
    pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.imageSmoothingEnabled = size < 1;
    pen.drawImage(this.image, left, top, map.width * size, map.height * size);
    const per_m = size * 1000 / (map.cell_mm * map.step), bottom = top + map.height * size;
    const spot = i => [left + (map.path[i] - map.x * map.cell_mm / 1000) * per_m, bottom - (map.path[i + 1] - map.y * map.cell_mm / 1000) * per_m];
    if (this.track?.checked) for (const [colour, width] of [['#fff', 5], ['#000', 2.5]]) {
      pen.beginPath();
      for (let i = 0; i < map.path.length; i += 2) pen.lineTo(...spot(i));
      Object.assign(pen, {strokeStyle: colour, lineWidth: width, lineJoin: 'round', lineCap: 'round'}).stroke();
    }
    if (this.cell !== NO_CELL) {
      const box = [left + (this.cell % map.width) * size, bottom - (Math.floor(this.cell / map.width) + 1) * size, size, size];
      for (const [colour, width] of [['#fff', 4], ['#000', 2]]) {
        Object.assign(pen, {strokeStyle: colour, lineWidth: this.pinned ? width : width / 2}).strokeRect(...box);
      }
    }
    this.ruler(pen, per_m);
    this.canvas.dataset.view = [size, left, top].join(' ');
  }

  ruler(pen, per_m) {
    const power = 10 ** Math.floor(Math.log10(120 / per_m)), metres = power * ([5, 2].find(k => k * power * per_m <= 120) || 1);
    const y = this.canvas.clientHeight - 12, ink = getComputedStyle(this.canvas).color, halo = getComputedStyle(this.canvas).backgroundColor;
    pen.font = '12px sans-serif';
    for (const [colour, width] of [[halo, 5], [ink, 2]]) {
      Object.assign(pen, {strokeStyle: colour, lineWidth: width}).strokeRect(12, y, metres * per_m, 0);
      if (colour === halo) pen.strokeText(metres + ' m', 12, y - 6);
    }
    pen.fillStyle = ink;
    pen.fillText(metres + ' m', 12, y - 6);
  }
}

async function start(figure) {
  const status = make('p', figure, 'Opening the map \u2026');
  try {
    const viewer = new Viewer(figure, await openMap(figure.querySelector('script').textContent));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => viewer.draw());
    status.remove();
    figure.dataset.ready = 'yes';
  } catch (e) {
    status.textContent = 'This browser cannot open the map (it needs one of 2023 or newer); the pictures show it. ' + e;
  }
}

document.querySelectorAll('figure.map').forEach(start);
