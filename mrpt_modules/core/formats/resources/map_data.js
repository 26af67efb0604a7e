// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
'use strict';
// Layers of a map in report.html: from the page's text to numbers, words and colours. In the page, map_viewer.js
// follows in the same script.
const STOPS = [[84, 52, 148], [58, 88, 160], [34, 130, 142], [70, 180, 110], [180, 214, 56], [253, 231, 60]];

// ---- data: base64 of deflated byte planes, most significant bytes last ----
async function decode(layer, count) {
  const packed = Uint8Array.from(atob(layer.data), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const planes = bytes.length / count;
  if (layer.type === 'u8') return bytes;
  const whole = new Uint8Array(count * 4);
  for (let p = 0; p < planes; ++p)
    for (let i = 0; i < count; ++i) whole[i * 4 + 4 - planes + p] = bytes[p * count + i];
  return layer.type === 'u32' ? new Uint32Array(whole.buffer) : new Float32Array(whole.buffer);
}

const isFloat = layer => layer.type === 'f24' || layer.type === 'f32';
const unknown = (layer, i) => isFloat(layer) ? Number.isNaN(layer.values[i]) : layer.values[i] === 0;

function shown(layer, i) {
  const value = layer.values[i];
  if (Number.isNaN(value)) return 'unknown';
  const decimals = 6 - Math.floor(Math.log10(Math.abs(value) + 1e-9));  // a float over the base has 7 digits
  const number = layer.type === 'f32' ? (layer.base + value).toFixed(Math.min(Math.max(decimals, 0), 3))
    : layer.type === 'f24' ? String(Number(value.toPrecision(5))) : String(value);
  return layer.unit === '1' || !layer.unit ? number : number + ' ' + layer.unit;
}

// ---- colours ----
function rangeOf(layer) {
  const seen = [];
  const stride = Math.max(1, Math.floor(layer.values.length / 200000));
  for (let i = 0; i < layer.values.length; i += stride)
    if (!unknown(layer, i) && Number.isFinite(layer.values[i])) seen.push(layer.values[i]);
  if (!seen.length) return [0, 1];
  seen.sort((a, b) => a - b);
  const at = share => seen[Math.round(share * (seen.length - 1))];
  return at(0.01) < at(0.99) ? [at(0.01), at(0.99)] : [seen[0], seen[seen.length - 1]];
}

function ramp(share) {
  const at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const low = Math.min(Math.floor(at), STOPS.length - 2);
  return STOPS[low].map((c, k) => Math.round(c + (STOPS[low + 1][k] - c) * (at - low)));
}

// The layer as an image of a pixel per cell, north up.
function paint(map, layer) {
  const image = document.createElement('canvas');
  image.width = map.width;
  image.height = map.height;
  const pixels = new ImageData(map.width, map.height);
  const [low, high] = layer.range ||= rangeOf(layer);
  const colours = layer.name === map.class ? map.colours : null;
  for (let row = 0; row < map.height; ++row)
    for (let column = 0; column < map.width; ++column) {
      const i = row * map.width + column;
      if (colours ? !map.known[i] : unknown(layer, i)) continue;
      const value = layer.values[i];
      const rgb = colours ? colours[value] || [255, 255, 255] : ramp(high > low ? (value - low) / (high - low) : 0.5);
      pixels.data.set([...rgb, 255], ((map.height - 1 - row) * map.width + column) * 4);
    }
  image.getContext('2d').putImageData(pixels, 0, 0);
  return image;
}

// Everything that a viewer needs, from the page's JSON.
async function openMap(json) {
  const map = JSON.parse(json);
  const count = map.width * map.height;
  for (const layer of map.layers) layer.values = await decode(layer, count);
  map.known = Uint8Array.from({length: count}, (_, i) => map.layers.some(l => !unknown(l, i)) ? 1 : 0);
  map.names = {};
  map.colours = {};
  for (const [code, name, colour] of map.legend) {
    map.names[code] = name;
    map.colours[code] = [1, 3, 5].map(k => parseInt(colour.slice(k, k + 2), 16));
  }
  return map;
}
