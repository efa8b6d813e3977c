// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fixed texts of the viewer page: markup, style, shaders and script, in the order in which the page carries them;
// and how the texts and numbers that `write_html_page()` puts between them are encoded.

#ifndef CSCD_IO_INTERNAL_HTML_PAGE_TEMPLATE_H
#define CSCD_IO_INTERNAL_HTML_PAGE_TEMPLATE_H

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace CSCD::internal {

/// The bytes of `numbers`, least significant first: what the typed arrays of a browser hold.
template <class Number>
std::string little_endian_bytes(const std::vector<Number>& numbers)
{
  using Bits = std::conditional_t<sizeof(Number) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  static_assert(sizeof(Number) == sizeof(Bits), "only numbers of four or eight bytes");
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Bits bits;
    std::memcpy(&bits, &numbers[i], sizeof bits);
    boost::endian::native_to_little_inplace(bits);
    std::memcpy(&bytes[i * sizeof bits], &bits, sizeof bits);
  }
  return bytes;
}

/// `bytes` in base 64, padded with `=` to a multiple of four characters.
inline std::string encode_base64(std::string bytes)
{
  namespace iterators = boost::archive::iterators;
  constexpr int bits_of_character = 6;
  constexpr int bits_of_byte = 8;
  using Encoded =
      iterators::base64_from_binary<iterators::transform_width<const char*, bits_of_character, bits_of_byte>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0'); // the iterators read groups of three bytes to their end
  std::string text(Encoded(bytes.data()), Encoded(bytes.data() + bytes.size()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

/// `text` such that a page shows it literally.
inline std::string escape_html(std::string text)
{
  boost::algorithm::replace_all(text, "&", "&amp;");
  boost::algorithm::replace_all(text, "<", "&lt;");
  boost::algorithm::replace_all(text, ">", "&gt;");
  boost::algorithm::replace_all(text, "\"", "&quot;");
  boost::algorithm::replace_all(text, "'", "&#39;");
  return text;
}

/// `source` such that it can stand in a script element: it neither ends the element nor begins a comment in it.
/// In the strings, regular expressions and comments of JavaScript, where alone these can occur, the meaning stays.
inline std::string escape_script(std::string source)
{
  boost::algorithm::ireplace_all(source, "</script", "<\\/script");
  boost::algorithm::replace_all(source, "<!--", "<\\!--");
  return source;
}

/// Up to the title. The content security policy makes the browser refuse every access to the network.
inline constexpr char html_page_head[] = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="CSCD">
<meta http-equiv="Content-Security-Policy"
      content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'">
<script>
window.cscd = {ready: false, errors: []};
window.addEventListener('error', event => window.cscd.errors.push(String(event.message)));
document.addEventListener('securitypolicyviolation', event =>
  window.cscd.errors.push('refused by the content security policy: ' + event.blockedURI));
for (const level of ['error', 'warn']) {
  const print = console[level];
  console[level] = function () {
    window.cscd.errors.push(Array.from(arguments).join(' '));
    print.apply(console, arguments);
  };
}
</script>
<title>)html";

/// From behind the title to the end of the head.
inline constexpr char html_page_style[] = R"html(</title>
<style>
:root {
  --ink: #16202e; --quiet: #5b6879; --line: rgba(22, 32, 46, .10); --accent: #2563eb; --field: #fff;
  font: 14px/1.4 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  color: var(--ink);
}
* { box-sizing: border-box; }
html, body { margin: 0; height: 100%; overflow: hidden; }
body { background: radial-gradient(ellipse at 50% 40%, #ffffff 0%, #f5f7fa 55%, #e4e9f0 100%); }
body[data-background=white] { background: #fff; }
body[data-background=dark] { background: #10151d; color: var(--ink); color-scheme: dark;
  --ink: #e6ebf2; --quiet: #9aa7b8; --line: rgba(255, 255, 255, .16); --accent: #3b82f6; --field: #222b39; }
body[data-background=dark] #panel { background: rgba(26, 33, 45, .85); }
#view { position: fixed; inset: 0; touch-action: none; cursor: grab; }
#view:active { cursor: grabbing; }
#view canvas { display: block; outline: none; }
#panel {
  position: fixed; top: 16px; left: 16px; width: 268px; max-height: calc(100% - 32px); overflow: auto;
  padding: 14px 16px 12px; border-radius: 14px; border: 1px solid var(--line);
  background: rgba(255, 255, 255, .82); backdrop-filter: blur(10px);
  box-shadow: 0 1px 2px rgba(22, 32, 46, .05), 0 10px 30px rgba(22, 32, 46, .09);
}
#panel h1 { margin: 0; cursor: pointer; font-size: 16px; font-weight: 650; letter-spacing: -.01em;
            overflow-wrap: anywhere; }
#panel h1::after { content: "\25be"; float: right; color: var(--quiet); font-weight: 400; }
#panel.folded { padding-bottom: 14px; }
#panel.folded h1::after { content: "\25b8"; }
#panel.folded > :not(h1) { display: none; }
#figures { display: grid; grid-template-columns: repeat(3, 1fr); gap: 7px 8px; margin: 11px 0 12px; }
#figures div { font-size: 11px; color: var(--quiet); }
#figures b { display: block; font-size: 15px; font-weight: 600; color: var(--ink); font-variant-numeric: tabular-nums; }
#figures i { display: inline-block; width: 8px; height: 8px; border-radius: 50%; margin-right: 4px; }
.group { border-top: 1px solid var(--line); padding: 7px 0; }
.switch { display: flex; align-items: center; gap: 9px; padding: 3.5px 0; font-size: 13px; cursor: pointer;
          user-select: none; }
.switch input { position: absolute; opacity: 0; width: 0; height: 0; }
.switch span { flex: none; width: 30px; height: 18px; border-radius: 9px; background: #cbd3dd; position: relative;
               transition: background .15s; }
.switch span::after { content: ""; position: absolute; top: 2px; left: 2px; width: 14px; height: 14px;
                      border-radius: 50%; background: #fff; box-shadow: 0 1px 2px rgba(22, 32, 46, .3);
                      transition: transform .15s; }
.switch input:checked + span { background: var(--accent); }
.switch input:checked + span::after { transform: translateX(12px); }
.switch input:focus-visible + span { outline: 2px solid var(--accent); outline-offset: 2px; }
.switch.absent, .row.absent { opacity: .4; cursor: default; }
kbd { margin-left: auto; flex: none; width: 20px; text-align: center; border: 1px solid var(--line);
      border-radius: 5px; font: 11px/16px inherit; font-family: inherit; color: var(--quiet); }
.row { display: flex; align-items: center; gap: 9px; padding: 4px 0; }
.row input[type=range] { flex: 1; min-width: 0; accent-color: var(--accent); margin: 0; }
.row output { width: 36px; text-align: right; color: var(--quiet); font-variant-numeric: tabular-nums; }
.row button { flex: 1; padding: 3px 0; border: 1px solid var(--line); border-radius: 7px; background: var(--field);
              font: inherit; font-size: 12px; color: var(--ink); cursor: pointer; }
.row button:hover { border-color: var(--accent); }
.row button.chosen { background: var(--accent); border-color: var(--accent); color: #fff; }
.row select, .row input[type=number] { flex: 1; min-width: 0; padding: 2px 4px; border: 1px solid var(--line);
  border-radius: 7px; background: var(--field); font: inherit; font-size: 12px; color: var(--ink); }
#legend { display: none; justify-content: space-between; padding: 1px 6px; border-radius: 5px; font-size: 11px;
          font-variant-numeric: tabular-nums; }
#row { display: none; font-size: 12px; font-variant-numeric: tabular-nums; white-space: pre-line; }
#scale { position: fixed; right: 20px; bottom: 16px; border: 2px solid var(--quiet); border-top: 0; height: 7px;
         color: var(--quiet); font-size: 11px; line-height: 0; text-align: center; pointer-events: none; }
#scale span { position: relative; top: -8px; }
.hint { border-top: 1px solid var(--line); padding-top: 8px; font-size: 11px; color: var(--quiet); }
#tip { position: fixed; pointer-events: none; display: none; padding: 5px 9px; border-radius: 8px; font-size: 12px;
       background: rgba(22, 32, 46, .9); color: #fff; white-space: pre; font-variant-numeric: tabular-nums; }
#message { position: fixed; inset: 0; display: none; align-items: center; justify-content: center; padding: 40px;
           text-align: center; color: var(--quiet); }
#selftest { position: fixed; right: 0; bottom: 0; margin: 0; padding: 12px; font-size: 11px; background: #fff; }
@media (max-width: 560px) { #panel { top: 8px; left: 8px; padding: 10px 12px; } .hint { display: none; } }
</style>
</head>
)html";

/// The visible parts other than the picture.
inline constexpr char html_page_body[] = R"html(<body>
<div id="view"></div>
<div id="message"></div>
<div id="tip"></div>
<div id="scale"><span></span></div>
<div id="panel">
  <h1></h1>
  <div id="figures"></div>
  <div class="group">
    <label class="switch"><input type="checkbox" data-switch="surface" checked>
      <span></span>Surface<kbd>S</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="skeleton" checked>
      <span></span>Skeleton<kbd>K</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="nodes" checked>
      <span></span>Nodes<kbd>N</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="balls">
      <span></span>Balls (radius)<kbd>B</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="separators">
      <span></span>Separators<kbd>P</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="color">
      <span></span>Color the surface<kbd>C</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="points">
      <span></span>Points<kbd>T</kbd></label>
    <label class="switch"><input type="checkbox" data-switch="repairs">
      <span></span>Repairs of the surface<kbd>E</kbd></label>
  </div>
  <div class="group">
    <div class="row"><label for="opacity">Opacity</label>
      <input id="opacity" type="range" min="0" max="100" value="22"><output></output></div>
    <div class="row"><label for="significance">Significance</label>
      <input id="significance" data-detail type="range" min="0" max="10" step="0.1" value="0"><output></output></div>
    <div class="row"><label for="length">Length / radius</label>
      <input id="length" data-detail type="range" min="0" max="20" step="0.1" value="0"><output></output></div>
    <div class="row">Up <button data-up="x">X</button><button data-up="y">Y</button><button data-up="z">Z</button>
      <button id="reset">Reset</button></div>
    <div class="row"><label for="coloring">Color by</label><select id="coloring">
      <option>branch</option><option>region</option><option>radius</option><option>significance</option></select></div>
    <div id="legend"><span></span><span></span></div>
    <div class="row"><label for="clip">Clip</label><select id="clip_axis" aria-label="Clip along">
      <option>x</option><option>y</option><option>z</option></select>
      <input id="clip" type="range" min="0" max="100" value="100"><output></output></div>
    <div class="row"><label for="background">Background</label><select id="background">
      <option>light</option><option>white</option><option>dark</option></select></div>
    <div class="row"><label for="width">Save</label><input id="width" type="number" min="16" value="1600"
      title="width of the PNG in pixels"><button id="png">PNG</button><button id="svg">SVG</button></div>
    <div class="row"><button id="link" title="Put the view into the address">Link to this view</button></div>
  </div>
  <div id="row" class="group"></div>
  <div class="hint">Drag to turn, wheel to zoom, right drag to pan.<br>Click a node or branch to read its measures.<br>
    R resets the view, H hides this panel.</div>
</div>
)html";

/// Reading of the data and what follows from it without drawing: colors and normals.
inline constexpr char html_page_model_script[] = R"js(
'use strict';

const NONE = 0xffffffff;

function read_model(text) {
  const page = JSON.parse(text);
  const model = {counts: page.counts};
  const types = {f: Float32Array, u: Uint32Array, d: Float64Array};
  for (const [name, [type, base64]] of Object.entries(page.arrays)) {
    const characters = atob(base64);
    const bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
    model[name] = new types[type](bytes.buffer);
  }
  return model;
}

let special_colors, shared_color; // the latter for what several branches share

function choose_colors() {
  special_colors = {tip: new THREE.Color('#f59e0b'), junction: new THREE.Color('#111827'),
                    chosen: new THREE.Color('#2563eb')};
  shared_color = new THREE.Color('#c3cad4');
}

// A limb is measured from its tip: lengths and integrals of the radius up to each node.
class Limb {
  constructor(model, tip, number) {
    Object.assign(this, {model, number, nodes: [tip], edges: [], lengths: [0], integrals: [0], least: 0});
  }

  get end() { return this.nodes[this.nodes.length - 1]; }
  get length() { return this.lengths[this.lengths.length - 1]; }

  append(edge) {
    const {node_positions: p, node_radii: r, edges} = this.model, from = this.end;
    const to = edges[2 * edge] === from ? edges[2 * edge + 1] : edges[2 * edge];
    const length = Math.hypot(...[0, 1, 2].map(k => p[3 * to + k] - p[3 * from + k]));
    this.integrals.push(this.integrals[this.integrals.length - 1] + length * (r[from] + r[to]) / 2);
    this.lengths.push(this.length + length);
    this.nodes.push(to);
    this.edges.push(edge);
  }

  // Over the first stretch of this length.
  mean_radius(length) {
    const r = this.model.node_radii;
    if (!(length > 0)) return r[this.nodes[0]];
    let i = 1;
    while (i + 1 < this.lengths.length && this.lengths[i] < length) ++i;
    const rest = length - this.lengths[i - 1], whole = this.lengths[i] - this.lengths[i - 1];
    const part = whole > 0 ? Math.min(rest / whole, 1) : 0;
    const from = r[this.nodes[i - 1]], to = from + part * (r[this.nodes[i]] - from);
    return (this.integrals[i - 1] + rest * (from + to) / 2) / length;
  }

  measure(name) {
    const ratio = (length, radius) => length <= 0 ? 0 : radius > 0 ? length / radius : Infinity;
    if (name === 'length') return ratio(this.length, this.mean_radius(this.length));
    const body = this.model.node_radii[this.end];
    const reach = this.length + this.model.node_radii[this.nodes[0]] - body;
    return ratio(Math.max(reach, 0), this.mean_radius(this.length - body));
  }
}

// Hides limbs that measure less than the threshold, the least first, as simplify_skeleton() prunes: where two branches
// are left at a junction they are one from then on; the last one of a tree, and cycles, stay.
// `levels`, if given, gets for each edge the value by which it goes.
function prune(model, is_shown, name, threshold, levels) {
  if (!(threshold > 0)) return;
  const incident = Array.from({length: model.counts.nodes}, () => []), limb_of_edge = [], limbs = [];
  is_shown.forEach((shown, edge) => {
    if (shown) for (const end of [0, 1]) incident[model.edges[2 * edge + end]].push(edge);
  });
  const degree = incident.map(edges => edges.length);
  const grow = limb => {
    do {
      const edge = incident[limb.end].find(edge => is_shown[edge] && limb_of_edge[edge] !== limb.number);
      limb_of_edge[edge] = limb.number;
      limb.append(edge);
    } while (degree[limb.end] === 2);
    limb.value = degree[limb.end] === 1 ? Infinity : Math.max(limb.measure(name), limb.least);
  };
  degree.forEach((number, node) => {
    if (number !== 1 || limb_of_edge[incident[node][0]] !== undefined) return;
    limbs.push(new Limb(model, node, limbs.length));
    grow(limbs[limbs.length - 1]);
  });
  for (;;) {
    let least = null;
    for (const limb of limbs) if (!least || limb.value < least.value) least = limb;
    if (!least || !(least.value < threshold)) return;
    for (const edge of least.edges) {
      is_shown[edge] = 0;
      if (levels) levels[edge] = least.value;
    }
    const level = least.value, junction = least.end;
    least.value = Infinity;
    if (--degree[junction] !== 2) continue;
    const left = incident[junction].filter(edge => is_shown[edge] && limb_of_edge[edge] !== undefined)
                                   .map(edge => limbs[limb_of_edge[edge]]);
    for (const limb of left) limb.value = Infinity;
    if (left.length > 0) { left[0].least = level; grow(left[0]); }
  }
}

// Which edges and nodes are shown, the degrees that these have then, and counts.
function detail_of(model, thresholds) {
  const is_edge_shown = new Uint8Array(model.counts.edges).fill(1);
  if (model.node_radii)
    for (const name of ['significance', 'length']) prune(model, is_edge_shown, name, thresholds[name]);
  const degree = new Uint32Array(model.counts.nodes), is_node_shown = new Uint8Array(model.counts.nodes).fill(1);
  is_edge_shown.forEach((shown, edge) => {
    for (const end of [0, 1]) {
      if (shown) ++degree[model.edges[2 * edge + end]];
      else is_node_shown[model.edges[2 * edge + end]] = 0;
    }
  });
  degree.forEach((number, node) => { if (number > 0) is_node_shown[node] = 1; });
  const total = list => list.reduce((sum, value) => sum + value, 0);
  const counts = {nodes: total(is_node_shown), edges: total(is_edge_shown), cycles: model.counts.cycles,
                  tips: degree.filter(number => number === 1).length,
                  junctions: degree.filter(number => number > 2).length};
  counts.branches = branch_count(model, is_edge_shown, is_node_shown, degree);
  return {is_edge_shown, is_node_shown, degree, counts};
}

// Branches end at nodes of degree other than 2; isolated nodes and closed cycles are branches too.
function branch_count(model, is_edge_shown, is_node_shown, degree) {
  const parent = Array.from({length: model.counts.nodes}, (_, node) => node);
  const find = node => { while (parent[node] !== node) node = parent[node] = parent[parent[node]]; return node; };
  is_edge_shown.forEach((shown, edge) => {
    if (shown) parent[find(model.edges[2 * edge])] = find(model.edges[2 * edge + 1]);
  });
  const ends = new Map();
  let isolated = 0;
  degree.forEach((number, node) => {
    if (!is_node_shown[node]) return;
    const root = find(node);
    ends.set(root, (ends.get(root) || 0) + (number === 2 ? 0 : number));
    if (number === 0) { ++isolated; ends.delete(root); }
  });
  return [...ends.values()].reduce((sum, number) => sum + (number === 0 ? 1 : number / 2), isolated);
}

// Of every edge: the threshold of the slider from which on it is hidden; infinite where it never is.
function significance_of_edges(model) {
  if (!model.significance) {
    model.significance = new Float64Array(model.counts.edges).fill(Infinity);
    prune(model, new Uint8Array(model.counts.edges).fill(1), 'significance', Infinity, model.significance);
  }
  return model.significance;
}

function length_of_edge(model, edge) {
  const p = model.node_positions, a = 3 * model.edges[2 * edge], b = 3 * model.edges[2 * edge + 1];
  return Math.hypot(p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]);
}

// Number of edges, length, mean radius over the length, and significance, in the scale of the scene.
function measure_branch(model, branch) {
  const row = {edges: 0, length: 0, radius: 0, significance: 0};
  const significance = model.node_radii ? significance_of_edges(model) : [];
  model.branch_of_edge.forEach((other, edge) => {
    if (other !== branch) return;
    const length = length_of_edge(model, edge);
    ++row.edges;
    row.length += length;
    if (!model.node_radii) return;
    const [a, b] = [0, 1].map(end => model.node_radii[model.edges[2 * edge + end]]);
    row.radius += length * (a + b) / 2;
    row.significance = Math.max(row.significance, significance[edge]);
  });
  row.radius = row.length > 0 ? row.radius / row.length : 0;
  return row;
}

// From dark to light, so that order shows in print too.
function ramp(part) {
  const stops = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'].map(text => new THREE.Color(text));
  const place = Math.min(Math.max(part, 0), 1) * (stops.length - 1), first = Math.min(Math.floor(place), stops.length - 2);
  return stops[first].clone().lerp(stops[first + 1], place - first);
}

// Colors by the quantity of this name: of edges, of nodes (undefined where several branches meet), and the range for
// the legend.
function make_coloring(model, name) {
  if (name === 'region') {
    const nodes = Array.from({length: model.counts.nodes},
                             (_, node) => new THREE.Color().setHSL(node * .381966 % 1, .62, .46));
    return {nodes, edges: Array.from(model.branch_of_edge, () => shared_color)};
  }
  if (name === 'branch' || !model.node_radii) {
    const colors = colors_of_branches(model);
    return {nodes: Array.from(model.branch_of_node, branch => colors[branch]),
            edges: Array.from(model.branch_of_edge, branch => colors[branch])};
  }
  let of_nodes = Float64Array.from(model.node_radii), of_edges;
  if (name === 'significance') {
    of_edges = significance_of_edges(model);
    of_nodes = of_nodes.fill(0);
    of_edges.forEach((value, edge) => {
      for (const end of [0, 1]) {
        const node = model.edges[2 * edge + end];
        of_nodes[node] = Math.max(of_nodes[node], value);
      }
    });
  } else {
    of_edges = Float64Array.from(model.branch_of_edge,
                                 (_, edge) => (of_nodes[model.edges[2 * edge]] + of_nodes[model.edges[2 * edge + 1]]) / 2);
  }
  const finite = [...of_nodes].filter(Number.isFinite).sort((a, b) => a - b);
  const least = finite[0] || 0, most = finite[finite.length - 1] || 0;
  const color = value => ramp(most > least ? (value - least) / (most - least) : 0);
  return {nodes: Array.from(of_nodes, color), edges: Array.from(of_edges, color), least, most};
}

// Branches that meet get different colors; among those allowed the one used least so far is taken.
function colors_of_branches(model) {
  const palette = ['#2563eb', '#e11d48', '#059669', '#d97706', '#7c3aed', '#0891b2', '#db2777', '#4d9411',
                   '#ea580c', '#4338ca', '#0d9488', '#a21caf', '#b45309', '#0284c7', '#be123c', '#15803d'];
  const branches_at = new Map();
  model.branch_of_edge.forEach((branch, edge) => {
    for (const node of [model.edges[2 * edge], model.edges[2 * edge + 1]]) {
      if (model.branch_of_node[node] !== NONE) continue;
      if (!branches_at.has(node)) branches_at.set(node, new Set());
      branches_at.get(node).add(branch);
    }
  });
  const neighbors = Array.from({length: model.counts.branches}, () => new Set());
  for (const branches of branches_at.values())
    for (const a of branches) for (const b of branches) if (a !== b) neighbors[a].add(b);
  const chosen = [], uses = palette.map(() => 0);
  for (let branch = 0; branch < neighbors.length; ++branch) {
    const taken = new Set([...neighbors[branch]].map(other => chosen[other]));
    let best = -1;
    for (let c = 0; c < palette.length; ++c)
      if (!taken.has(c) && (best < 0 || uses[c] < uses[best])) best = c;
    if (best < 0) best = branch % palette.length;
    ++uses[best];
    chosen.push(best);
  }
  return chosen.map(c => new THREE.Color(palette[c]));
}

// Area weighted normals of the faces.
function normals_of_faces(positions, triangles) {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
    for (let k = 0; k < 3; ++k) {
      const y = (k + 1) % 3, z = (k + 2) % 3;
      normals[t + k] = (positions[b + y] - positions[a + y]) * (positions[c + z] - positions[a + z])
                     - (positions[b + z] - positions[a + z]) * (positions[c + y] - positions[a + y]);
    }
  }
  return normals;
}

function corners_of_vertices(triangles, number_of_vertices) {
  const first = new Uint32Array(number_of_vertices + 1), corners = new Uint32Array(triangles.length);
  for (const v of triangles) ++first[v + 1];
  for (let v = 0; v < number_of_vertices; ++v) first[v + 1] += first[v];
  const next = first.slice(0, number_of_vertices);
  triangles.forEach((v, corner) => { corners[next[v]++] = corner; });
  return {first, corners};
}

// Smooth normals, but sharp edges stay sharp: at a vertex where faces differ by much, each corner becomes a vertex of
// its own, whose normal is the mean over the faces that lie within the crease angle of the corner's.
function smooth_unless_sharp(positions, triangles) {
  const cos_crease = Math.cos(Math.PI / 4), cos_half_crease = Math.cos(Math.PI / 8);
  const face_normals = normals_of_faces(positions, triangles);
  const number_of_vertices = positions.length / 3;
  const {first, corners} = corners_of_vertices(triangles, number_of_vertices);
  const normals = Array(positions.length).fill(0), source = Array.from({length: number_of_vertices}, (_, v) => v);
  const index = triangles.slice();
  const sum = new THREE.Vector3(), face = new THREE.Vector3(), other = new THREE.Vector3();
  const normal_of_corner = (target, corner) => target.fromArray(face_normals, corner - corner % 3);
  for (let v = 0; v < number_of_vertices; ++v) {
    sum.set(0, 0, 0);
    for (let k = first[v]; k < first[v + 1]; ++k) sum.add(normal_of_corner(face, corners[k]));
    sum.normalize();
    let smooth = true;
    for (let k = first[v]; k < first[v + 1] && smooth; ++k) {
      normal_of_corner(face, corners[k]);
      smooth = face.dot(sum) >= cos_half_crease * face.length();
    }
    sum.toArray(normals, 3 * v);
    if (smooth) continue;
    for (let k = first[v]; k < first[v + 1]; ++k) {
      normal_of_corner(face, corners[k]);
      const length = face.length();
      sum.set(0, 0, 0);
      for (let l = first[v]; l < first[v + 1]; ++l) {
        normal_of_corner(other, corners[l]);
        if (other.dot(face) >= cos_crease * length * other.length()) sum.add(other);
      }
      sum.normalize();
      index[corners[k]] = source.length;
      source.push(v);
      normals.push(sum.x, sum.y, sum.z);
    }
  }
  return {index, source, normals: new Float32Array(normals)};
}
)js";

/// Materials and the objects of the scene.
inline constexpr char html_page_scene_script[] = R"js(
const shading = `
  varying vec3 v_normal, v_to_eye, v_color;
  vec3 lit(vec3 color, vec3 n) {
    float key = .5 + .5 * dot(n, normalize(vec3(-.45, .75, .55)));
    float sky = .5 + .5 * n.y;
    return color * (.60 + .40 * key * key + .14 * sky);
  }
  vec3 normal_to_eye() {
    vec3 n = normalize(v_normal);
    return dot(n, v_to_eye) < 0. ? -n : n;
  }`;

const translucent_fragment = shading + `
  uniform float opacity;
  varying float v_beyond;
  void main() {
    if (v_beyond > 0.) discard;
    vec3 n = normal_to_eye(), e = normalize(v_to_eye);
    float rim = pow(1. - clamp(dot(n, e), 0., 1.), 2.2);
    float glint = pow(clamp(dot(n, normalize(e + normalize(vec3(-.45, .75, .55)))), 0., 1.), 60.);
    vec3 color = mix(lit(v_color, n), v_color * .52, .65 * rim * (1. - .6 * opacity)) + .10 * glint;
    gl_FragColor = vec4(color, mix(opacity, 1., .62 * rim * smoothstep(0., .15, opacity)));
  }`;

const solid_fragment = shading + `
  uniform float paleness;
  void main() {
    vec3 n = normal_to_eye();
    float glint = pow(clamp(dot(n, normalize(vec3(-.3, .5, 1.))), 0., 1.), 40.);
    gl_FragColor = vec4(mix(lit(v_color, n) + .15 * glint, vec3(.93, .945, .965), paleness), 1.);
  }`;

const surface_vertex = `
  attribute vec3 branch_color;
  uniform float colored;
  uniform vec4 clip;
  varying vec3 v_normal, v_to_eye, v_color;
  varying float v_beyond;
  void main() {
    v_beyond = dot(position, clip.xyz) - clip.w;
    vec4 p = modelViewMatrix * vec4(position, 1.);
    v_normal = normalMatrix * normal;
    v_to_eye = -p.xyz;
    v_color = mix(vec3(.56, .64, .74), branch_color, colored);
    gl_Position = projectionMatrix * p;
  }`;

const sphere_vertex = `
  attribute vec3 center, color;
  attribute float radius;
  varying vec3 v_normal, v_to_eye, v_color;
  varying float v_beyond;
  void main() {
    v_beyond = 0.;
    vec4 p = modelViewMatrix * vec4(center + radius * position, 1.);
    v_normal = normalMatrix * position;
    v_to_eye = -p.xyz;
    v_color = color;
    gl_Position = projectionMatrix * p;
  }`;

const tube_vertex = `
  attribute vec3 start, end, color;
  uniform float radius;
  varying vec3 v_normal, v_to_eye, v_color;
  vec3 unit(vec3 v) { return v / max(length(v), 1e-12); }
  void main() {
    vec3 axis = end - start;
    vec3 helper = abs(axis.y) < .9 * length(axis) ? vec3(0., 1., 0.) : vec3(1., 0., 0.);
    vec3 u = unit(cross(axis, helper)), w = unit(cross(axis, u));
    vec3 outward = u * position.x + w * position.z;
    vec4 p = modelViewMatrix * vec4(mix(start, end, position.y + .5) + radius * outward, 1.);
    v_normal = normalMatrix * outward;
    v_to_eye = -p.xyz;
    v_color = color;
    gl_Position = projectionMatrix * p;
  }`;

function instanced(base, attributes) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.index = base.index;
  geometry.setAttribute('position', base.attributes.position);
  for (const [name, [values, size]] of Object.entries(attributes))
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(values), size));
  return geometry;
}

function solid(geometry, vertexShader, uniforms) {
  const material = new THREE.ShaderMaterial({
    vertexShader, fragmentShader: solid_fragment, side: THREE.DoubleSide,
    uniforms: Object.assign({paleness: {value: 0}}, uniforms)});
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

// Only the layer nearest to the eye is blended: a first pass writes depth alone. Everything solid is drawn before, and
// so shines through. Sorting of triangles is not needed, and bodies behind one another do not add up to a fog.
function translucent(geometry, vertexShader, uniforms, order) {
  const group = new THREE.Group();
  for (const pass of ['depth', 'color']) {
    const material = new THREE.ShaderMaterial({
      vertexShader, fragmentShader: translucent_fragment, uniforms, side: THREE.DoubleSide, transparent: true,
      depthWrite: pass === 'depth', colorWrite: pass === 'color'});
    const mesh = new THREE.Mesh(geometry, material);
    mesh.renderOrder = pass === 'depth' ? order : order + 1;
    mesh.frustumCulled = false;
    group.add(mesh);
  }
  return group;
}

function make_surface(model, coloring, uniforms) {
  const {index, source, normals} = smooth_unless_sharp(model.positions, model.triangles);
  const positions = new Float32Array(3 * source.length);
  source.forEach((v, i) => positions.set(model.positions.subarray(3 * v, 3 * v + 3), 3 * i));
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  geometry.setAttribute('branch_color', new THREE.BufferAttribute(new Float32Array(3 * source.length), 3));
  const surface = translucent(geometry, surface_vertex, uniforms, 20);
  surface.userData = {geometry, source};
  color_surface(surface, model, coloring);
  return surface;
}

function color_surface(surface, model, coloring) {
  const {geometry, source} = surface.userData, colors = geometry.attributes.branch_color;
  source.forEach((v, i) => (coloring.nodes[model.node_of_vertex[v]] || shared_color).toArray(colors.array, 3 * i));
  colors.needsUpdate = true;
}

// Thin enough for the thin limbs, thick enough to be seen; the scene is two units wide.
function tube_radius(model) {
  const thinnest = .006, thickest = .0085;
  if (!model.node_radii) return thickest;
  const sorted = model.node_radii.slice().sort();
  const median = sorted[sorted.length >> 1] || 0;
  return Math.min(thickest, Math.max(thinnest, .12 * median));
}

function make_tubes(starts, ends, colors, sides) {
  const base = new THREE.CylinderBufferGeometry(1, 1, 1, sides, 1, true);
  return instanced(base, {start: [starts, 3], end: [ends, 3], color: [colors, 3]});
}

function make_spheres(centers, radii, colors, detail) {
  const base = new THREE.SphereBufferGeometry(1, 2 * detail, detail);
  return instanced(base, {center: [centers, 3], radius: [radii, 1], color: [colors, 3]});
}

function make_skeleton(model, detail, coloring, radius) {
  const starts = [], ends = [], colors = [], joint_centers = [], joint_colors = [];
  for (let e = 0; e < model.counts.edges; ++e) {
    if (!detail.is_edge_shown[e]) continue;
    const a = 3 * model.edges[2 * e], b = 3 * model.edges[2 * e + 1];
    const color = coloring.edges[e].toArray();
    for (const [target, node] of [[starts, a], [ends, b]]) {
      const point = model.node_positions.subarray(node, node + 3);
      target.push(...point);
      joint_centers.push(...point);
      joint_colors.push(...color);
    }
    colors.push(...color);
  }
  const group = new THREE.Group();
  group.add(solid(make_tubes(starts, ends, colors, 12), tube_vertex, {radius: {value: radius}}));
  const joint_radii = Array(joint_centers.length / 3).fill(radius);
  group.add(solid(make_spheres(joint_centers, joint_radii, joint_colors, 8), sphere_vertex));
  return group;
}

function color_of_node(node, degree, coloring) {
  if (degree[node] > 2) return special_colors.junction;
  return degree[node] === 1 ? special_colors.tip : coloring.nodes[node] || shared_color;
}

function make_nodes(model, {is_node_shown, degree}, coloring, radius) {
  const centers = [], radii = [], colors = [];
  for (let n = 0; n < model.counts.nodes; ++n) {
    if (!is_node_shown[n]) continue;
    centers.push(...model.node_positions.subarray(3 * n, 3 * n + 3));
    radii.push(radius * (degree[n] === 2 ? 1.4 : degree[n] === 1 ? 1.9 : 2.2));
    const color = color_of_node(n, degree, coloring).clone();
    if (degree[n] === 2) color.multiplyScalar(.8);
    colors.push(...color.toArray());
  }
  return solid(make_spheres(centers, radii, colors, 10), sphere_vertex);
}

function make_balls(model, {is_node_shown}, coloring) {
  const centers = [], radii = [], colors = [];
  is_node_shown.forEach((is_shown, n) => {
    if (!is_shown) return;
    centers.push(...model.node_positions.subarray(3 * n, 3 * n + 3));
    radii.push(model.node_radii[n]);
    colors.push(...(coloring.nodes[n] || shared_color).toArray());
  });
  return translucent(make_spheres(centers, radii, colors, 16), sphere_vertex, {opacity: {value: .38}}, 10);
}

function nearest_node(model, x, y, z) {
  let best = NONE, least = Infinity;
  const p = model.node_positions;
  for (let n = 0; n < model.counts.nodes; ++n) {
    const d = (p[3 * n] - x) ** 2 + (p[3 * n + 1] - y) ** 2 + (p[3 * n + 2] - z) ** 2;
    if (d < least) { least = d; best = n; }
  }
  return best;
}

// A separator takes the color of the node nearest to its middle.
function color_of_separator(model, first, last, coloring) {
  const middle = [0, 0, 0];
  for (let i = first; i < last; ++i)
    for (let k = 0; k < 3; ++k) middle[k] += model.separator_points[3 * i + k] / (last - first);
  const node = nearest_node(model, ...middle);
  return coloring.nodes[node] || special_colors.junction;
}

// Once pale, and again in full color after the depth of the surface is known: what lies on the far side stays pale.
function twice_drawn(tubes, radius) {
  const far = solid(tubes, tube_vertex, {radius: {value: radius}, paleness: {value: .72}});
  const near = solid(tubes, tube_vertex, {radius: {value: radius}});
  near.material.transparent = true; // drawn in the order of the translucent objects
  near.renderOrder = 30;
  const group = new THREE.Group();
  group.add(far, near);
  return group;
}

function make_separators(model, coloring, radius) {
  const starts = [], ends = [], colors = [];
  const point = i => model.separator_points.subarray(3 * i, 3 * i + 3);
  for (let s = 0; s + 1 < model.separator_offsets.length; ++s) {
    const first = model.separator_offsets[s], last = model.separator_offsets[s + 1];
    if (first === last) continue;
    const color = color_of_separator(model, first, last, coloring).toArray();
    for (let i = first; i < last; ++i) {
      starts.push(...point(i));
      ends.push(...point(i + 1 < last ? i + 1 : first));
      colors.push(...color);
    }
  }
  return twice_drawn(make_tubes(starts, ends, colors, 6), radius);
}

// Thick tubes around these edges.
function make_highlight(model, edges, radius) {
  const ends = [0, 1].map(end => [].concat(...edges.map(edge => {
    const node = 3 * model.edges[2 * edge + end];
    return [...model.node_positions.subarray(node, node + 3)];
  })));
  const colors = [].concat(...edges.map(() => special_colors.chosen.toArray()));
  return solid(make_tubes(...ends, colors, 12), tube_vertex, {radius: {value: 2 * radius}});
}

// Dots of a size in pixels.
function make_dots(positions, color, size, is_in_front) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  const dots = new THREE.Points(geometry, new THREE.PointsMaterial(
    {color: color, size, sizeAttenuation: false, depthTest: !is_in_front, transparent: true}));
  dots.frustumCulled = false;
  dots.renderOrder = is_in_front ? 40 : 5;
  return dots;
}

// Where handles were cut and where gaps were joined.
function make_repairs(model) {
  const group = new THREE.Group();
  group.add(make_dots(model.cut_handles, 0xd01040, 11, true), make_dots(model.joined_gaps, 0xf08000, 9, true));
  return group;
}
)js";

/// The picture: renderer, camera, controls.
inline constexpr char html_page_view_script[] = R"js(
// Most meshes have y up; one that is a long way along z stands upright.
function guess_up(size) {
  return size.z > 1.6 * Math.max(size.x, size.y) ? 'z' : 'y';
}

function box_of(points) {
  const box = new THREE.Box3(), p = new THREE.Vector3();
  for (let i = 0; i < points.length; i += 3) box.expandByPoint(p.fromArray(points, i));
  if (box.isEmpty()) box.expandByPoint(p.set(0, 0, 0));
  return box;
}

// Looks along the narrower of the two level directions, somewhat from the side and from above.
function direction_of_view(up, size) {
  const level = ['x', 'y', 'z'].filter(axis => axis !== up);
  const narrow = size[level[0]] < .8 * size[level[1]] ? level[0] : level[1];
  const wide = level.find(axis => axis !== narrow);
  const direction = new THREE.Vector3();
  direction[narrow] = up === 'z' ? -1 : 1;
  direction[wide] = .42;
  direction[up] = .24;
  return direction.normalize();
}

class View {
  constructor(element, model) {
    this.element = element;
    this.renderer = new THREE.WebGLRenderer({antialias: true, alpha: true});
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setClearColor(0xffffff, 0);
    element.appendChild(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(26, 1, .01, 100);
    this.points = model.positions.length > 0 ? model.positions : model.node_positions;
    this.box = box_of(this.points);
    this.unit = model.frame[3];
    this.projected = new THREE.Vector3();
    this.turn = 0;
    this.margin_left = 0;
    this.stale = true;
    // Scans have z up, and alone have no triangles.
    this.look_from(model.triangles.length === 0 ? 'z' : guess_up(this.box.getSize(new THREE.Vector3())));
    window.addEventListener('resize', () => this.resize());
    this.is_fitted = true;
    this.resize();
  }

  // OrbitControls reads the up direction when it is made, hence a new one for each.
  look_from(up) {
    if (this.controls) this.controls.dispose();
    this.up = up;
    this.camera.up.set(+(up === 'x'), +(up === 'y'), +(up === 'z'));
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    Object.assign(this.controls, {enableDamping: true, dampingFactor: .12, rotateSpeed: .8, screenSpacePanning: true,
                                  minDistance: .05, maxDistance: 30});
    this.controls.addEventListener('change', () => { this.stale = true; });
    this.controls.addEventListener('start', () => { this.is_fitted = false; });
  }

  reset() {
    const size = this.box.getSize(new THREE.Vector3());
    const direction = direction_of_view(this.up, size).applyAxisAngle(this.camera.up, this.turn * Math.PI / 180);
    this.box.getCenter(this.controls.target);
    this.camera.position.copy(this.controls.target).add(direction);
    this.camera.lookAt(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(direction, this.distance_to_fit());
    this.settle();
    this.is_fitted = true;
  }

  // The least distance from which all points are in the picture, with a margin.
  distance_to_fit() {
    const margin = 1.12, p = new THREE.Vector3(), turn = this.camera.quaternion.clone().conjugate();
    const tan_y = Math.tan(this.camera.fov / 2 * Math.PI / 180);
    const tan_x = tan_y * (this.width - this.margin_left) / this.height;
    let distance = .1;
    for (let i = 0; i < this.points.length; i += 3) {
      p.fromArray(this.points, i).sub(this.controls.target).applyQuaternion(turn);
      distance = Math.max(distance, p.z + margin * Math.max(Math.abs(p.x) / tan_x, Math.abs(p.y) / tan_y));
    }
    return distance;
  }

  // Ends what is left of a movement that is dying down.
  settle() {
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
    this.stale = true;
  }

  // The shape is centered in what the panel leaves free, and fitted into it again unless the user has moved it.
  resize() {
    this.width = Math.max(1, this.element.clientWidth);
    this.height = Math.max(1, this.element.clientHeight);
    this.camera.aspect = this.width / this.height;
    this.camera.setViewOffset(this.width, this.height, -this.margin_left / 2, 0, this.width, this.height);
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(this.width, this.height);
    this.stale = true;
    if (this.is_fitted) this.reset();
  }

  draw() {
    this.camera.near = Math.max(.002, this.camera.position.distanceTo(this.controls.target) / 50);
    this.camera.far = this.camera.near * 50 + 10;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    this.stale = false;
    this.draw_scale();
  }

  // A bar of 1, 2 or 5 times a power of ten, in the unit of the input, at the depth of the middle of the view.
  draw_scale() {
    const bar = document.getElementById('scale'), widest = 140; // pixels
    const depth = this.camera.position.distanceTo(this.controls.target);
    const pixel = 2 * depth * Math.tan(this.camera.fov / 2 * Math.PI / 180) / this.height * this.unit;
    const power = 10 ** Math.floor(Math.log10(widest * pixel));
    const length = [5, 2, 1].map(factor => factor * power).find(length => length <= widest * pixel);
    bar.style.width = length / pixel + 'px';
    bar.firstChild.textContent = Number(length.toPrecision(1));
  }

  // What is seen, in a canvas of this width in pixels; smaller where the browser cannot draw as many.
  picture(width, background) {
    this.renderer.setPixelRatio(width / this.width);
    this.draw();
    const drawn = this.renderer.domElement, canvas = document.createElement('canvas');
    canvas.width = drawn.width;
    canvas.height = drawn.height;
    const context = canvas.getContext('2d');
    context.fillStyle = background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(drawn, 0, 0);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.draw();
    return canvas;
  }

  // Where a node is in the window, in pixels, and its depth: nearer is less, in sight is below 1.
  project(model, node) {
    const p = this.projected.fromArray(model.node_positions, 3 * node).project(this.camera);
    return {x: (p.x + 1) / 2 * this.width, y: (1 - p.y) / 2 * this.height, depth: p.z};
  }

  run() {
    requestAnimationFrame(() => this.run());
    this.controls.update();
    if (this.stale) this.draw();
  }
}

// What depends on the detail and on the coloring.
function make_skeleton_objects(model, detail, coloring) {
  const radius = tube_radius(model);
  const objects = {
    skeleton: make_skeleton(model, detail, coloring, radius),
    nodes: make_nodes(model, detail, coloring, radius)
  };
  if (model.node_radii) objects.balls = make_balls(model, detail, coloring);
  if (model.separator_offsets.length > 1) objects.separators = make_separators(model, coloring, .55 * radius);
  return objects;
}

function make_objects(model, detail, coloring, uniforms) {
  const objects = make_skeleton_objects(model, detail, coloring);
  objects.surface = make_surface(model, coloring, uniforms);
  if (model.counts.points > 0) {
    objects.points = make_dots(model.positions.slice(0, 3 * model.counts.points), 0x30405a, 2, false);
    if (model.cut_handles.length + model.joined_gaps.length > 0) objects.repairs = make_repairs(model);
  }
  return objects;
}
)js";

/// The panel, the keyboard, the tip at the pointer, and the self test.
inline constexpr char html_page_panel_script[] = R"js(
class Panel {
  constructor(view, model, detail, coloring, objects, uniforms) {
    Object.assign(this, {view, model, detail, coloring, objects, uniforms, state: {}});
    this.element = document.getElementById('panel');
    const heading = this.element.querySelector('h1'), narrow = 560; // pixels, as in the style
    heading.textContent = document.title;
    heading.addEventListener('click', () => this.element.classList.toggle('folded'));
    if (window.innerWidth <= narrow) this.element.classList.add('folded');
    this.show_figures();
    for (const box of this.element.querySelectorAll('[data-switch]')) this.connect_switch(box);
    const slider = document.getElementById('opacity');
    slider.addEventListener('input', () => this.set_opacity(slider.value));
    this.set_opacity(slider.value);
    for (const input of this.element.querySelectorAll('[data-detail]')) {
      input.disabled = !model.node_radii;
      input.closest('.row').classList.toggle('absent', input.disabled);
      input.nextElementSibling.textContent = input.value;
      input.addEventListener('input', () => this.set_detail(input.id, input.value));
    }
    for (const button of this.element.querySelectorAll('[data-up]'))
      button.addEventListener('click', () => this.choose_up(button.dataset.up));
    document.getElementById('reset').addEventListener('click', () => view.reset());
    this.connect_tools();
    window.addEventListener('keydown', event => this.key(event));
    window.addEventListener('resize', () => this.make_room());
    this.make_room();
    this.mark_up();
  }

  show_figures() {
    const names = ['nodes', 'edges', 'branches', 'tips', 'junctions', 'cycles'];
    const figures = document.getElementById('figures');
    figures.textContent = '';
    for (const name of names) {
      const cell = figures.appendChild(document.createElement('div'));
      cell.appendChild(document.createElement('b')).textContent = this.detail.counts[name].toLocaleString('en');
      const special = {tips: special_colors.tip, junctions: special_colors.junction}[name];
      if (special) cell.appendChild(document.createElement('i')).style.background = special.getStyle();
      cell.appendChild(document.createTextNode(name));
    }
  }

  connect_switch(box) {
    const name = box.dataset.switch;
    if (name !== 'color' && !this.objects[name]) {
      box.disabled = true;
      box.closest('.switch').classList.add('absent');
      return;
    }
    box.addEventListener('change', () => this.set_visible(name, box.checked));
    this.set_visible(name, box.checked);
  }

  set_visible(name, on) {
    const box = this.element.querySelector('[data-switch="' + name + '"]');
    if (!box || box.disabled) return;
    box.checked = this.state[name] = on;
    if (name === 'color') this.uniforms.colored.value = on ? 1 : 0;
    else this.objects[name].visible = on;
    this.view.stale = true;
  }

  set_opacity(percent) {
    const slider = document.getElementById('opacity');
    slider.value = percent;
    slider.nextElementSibling.textContent = slider.value + ' %';
    this.uniforms.opacity.value = slider.value / 100;
    this.view.stale = true;
  }

  // Draws the skeleton without the branches that measure less than the sliders say.
  set_detail(name, value) {
    const input = document.getElementById(name);
    if (input.disabled) return;
    input.value = value;
    input.nextElementSibling.textContent = input.value;
    const of = id => Number(document.getElementById(id).value);
    this.detail = detail_of(this.model, {significance: of('significance'), length: of('length')});
    this.choose(null);
    this.remake_skeleton();
    this.show_figures();
  }

  remake_skeleton() {
    for (const [key, object] of Object.entries(make_skeleton_objects(this.model, this.detail, this.coloring))) {
      object.visible = this.objects[key].visible;
      this.remove(this.objects[key]);
      this.view.scene.add(object);
      this.objects[key] = object;
    }
    this.view.stale = true;
  }

  remove(object) {
    this.view.scene.remove(object);
    object.traverse(part => { if (part.geometry) { part.geometry.dispose(); part.material.dispose(); } });
  }

  connect_tools() {
    const element = name => document.getElementById(name);
    for (const name of ['coloring', 'background', 'clip_axis'])
      element(name).addEventListener('change', () => this.set_choice(name, element(name).value));
    element('clip').addEventListener('input', () => this.set_clip(element('clip').value));
    this.set_clip(element('clip').value);
    element('png').addEventListener('click', () => this.save_png());
    element('svg').addEventListener('click', () => this.save(new Blob([this.svg()], {type: 'image/svg+xml'}), 'svg'));
    element('link').addEventListener('click', () => { location.hash = this.address(); });
    const canvas = this.view.element;
    let pressed = null; // where; a drag is no click
    canvas.addEventListener('pointerdown', event => { pressed = [event.clientX, event.clientY]; });
    canvas.addEventListener('pointerup', event => {
      const shake = 5; // pixels
      if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < shake)
        this.choose(this.node_or_end_at(event.clientX, event.clientY, event.pointerType === 'touch' ? 24 : 9));
      pressed = null;
    });
  }

  // A choice of one of the lists, as by hand.
  set_choice(name, value) {
    const list = document.getElementById(name);
    if (![...list.options].some(option => option.value === value)) return;
    list.value = value;
    if (name === 'background') {
      document.body.dataset.background = value;
      special_colors.junction.set(value === 'dark' ? '#f1f5f9' : '#111827');
      this.remake_skeleton();
      this.show_figures();
    }
    if (name === 'clip_axis') this.set_clip(document.getElementById('clip').value);
    if (name === 'coloring') this.set_coloring(value);
  }

  set_coloring(name) {
    this.coloring = make_coloring(this.model, name);
    color_surface(this.objects.surface, this.model, this.coloring);
    this.remake_skeleton();
    const legend = document.getElementById('legend'), has_range = this.coloring.most !== undefined;
    legend.style.display = has_range ? 'flex' : 'none';
    if (!has_range) return;
    const scale = name === 'radius' ? this.model.frame[3] : 1;
    [this.coloring.least, this.coloring.most].forEach((value, i) => {
      legend.children[i].textContent = figure(scale * value);
      legend.children[i].style.color = ['#fff', '#111'][i];
    });
    legend.style.background = 'linear-gradient(90deg,' + [0, .25, .5, .75, 1].map(part => ramp(part).getStyle()) + ')';
  }

  // Hides the surface beyond this percentage of the box along the axis.
  set_clip(percent) {
    const slider = document.getElementById('clip'), axis = document.getElementById('clip_axis').value;
    slider.value = percent;
    slider.nextElementSibling.textContent = slider.value < 100 ? slider.value + ' %' : 'off';
    const {min, max} = this.view.box, part = slider.value / 100;
    const beyond = slider.value < 100 ? min[axis] + part * (max[axis] - min[axis]) : 1e9;
    this.uniforms.clip.value.set(+(axis === 'x'), +(axis === 'y'), +(axis === 'z'), beyond);
    this.view.stale = true;
  }

  // The shown node nearest to a place of the window, within reach, in pixels; else null.
  node_at(x, y, reach, places = this.places()) {
    if (!this.state.nodes && !this.state.skeleton) return null;
    let best = null, nearest = reach;
    places.forEach((place, node) => {
      const distance = place ? Math.hypot(place.x - x, place.y - y) : Infinity;
      if (distance < nearest) { nearest = distance; best = node; }
    });
    return best;
  }

  // The same; where there is none, the nearer end of the shown edge nearest to the place.
  node_or_end_at(x, y, reach) {
    const places = this.places(), node = this.node_at(x, y, reach, places);
    if (node !== null || !this.state.skeleton) return node;
    let best = null, nearest = reach;
    this.detail.is_edge_shown.forEach((is_shown, edge) => {
      const [a, b] = [0, 1].map(end => places[this.model.edges[2 * edge + end]]);
      if (!is_shown || !a || !b) return;
      const u = [b.x - a.x, b.y - a.y], square = u[0] ** 2 + u[1] ** 2;
      const part = square > 0 ? Math.min(1, Math.max(0, ((x - a.x) * u[0] + (y - a.y) * u[1]) / square)) : 0;
      const distance = Math.hypot(a.x + part * u[0] - x, a.y + part * u[1] - y);
      if (distance < nearest) { nearest = distance; best = this.model.edges[2 * edge + (part < .5 ? 0 : 1)]; }
    });
    return best;
  }

  // Of every shown node in sight.
  places() {
    return Array.from(this.detail.is_node_shown, (is_shown, node) => {
      const place = is_shown ? this.view.project(this.model, node) : null;
      return place && place.depth < 1 ? place : null;
    });
  }

  // Shows the row of a node and of its branch, or of the branches that meet there; nothing for null.
  choose(node) {
    const row = document.getElementById('row');
    if (this.highlight) this.remove(this.highlight);
    this.highlight = null;
    row.style.display = node === null ? 'none' : 'block';
    this.view.stale = true;
    if (node === null) return;
    const {model} = this, at = [];
    model.branch_of_edge.forEach((branch, edge) => {
      const is_end = model.edges[2 * edge] === node || model.edges[2 * edge + 1] === node;
      if (is_end && this.detail.is_edge_shown[edge] && !at.includes(branch)) at.push(branch);
    });
    row.textContent = [describe_node(model, this.detail, node), ...at.map(branch => describe_branch(model, branch))].join('\n');
    const edges = [...model.branch_of_edge.keys()].filter(
      edge => at.includes(model.branch_of_edge[edge]) && this.detail.is_edge_shown[edge]);
    this.highlight = make_highlight(model, edges, tube_radius(model));
    this.view.scene.add(this.highlight);
  }

  save(blob, ending) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = (document.title.replace(/[^\w.-]+/g, '_') || 'skeleton') + '.' + ending;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  save_png() {
    const width = Math.max(16, Number(document.getElementById('width').value) || 1600);
    const color = {light: '#f5f7fa', white: '#ffffff', dark: '#10151d'}[document.getElementById('background').value];
    this.view.picture(width, color).toBlob(blob => this.save(blob, 'png'), 'image/png');
  }

  // What is shown of the skeleton, far parts first, in the pixels of the window.
  svg() {
    const {model, detail, view} = this, places = this.places();
    const width = 2 * tube_radius(model) * view.height / (2 * Math.tan(view.camera.fov / 2 * Math.PI / 180)) /
      view.camera.position.distanceTo(view.controls.target);
    const round = value => Number(value.toFixed(2)), parts = [];
    detail.is_edge_shown.forEach((is_shown, edge) => {
      const [a, b] = [0, 1].map(end => places[model.edges[2 * edge + end]]);
      if (is_shown && a && b)
        parts.push([(a.depth + b.depth) / 2, `<line x1="${round(a.x)}" y1="${round(a.y)}" x2="${round(b.x)}" ` +
          `y2="${round(b.y)}" stroke="${this.coloring.edges[edge].getStyle()}"/>`]);
    });
    places.forEach((place, node) => {
      if (place && detail.degree[node] !== 2)
        parts.push([place.depth, `<circle cx="${round(place.x)}" cy="${round(place.y)}" r="${round(width)}" ` +
          `fill="${color_of_node(node, detail.degree, this.coloring).getStyle()}"/>`]);
    });
    parts.sort((a, b) => b[0] - a[0]);
    const holder = document.createElement('div');
    holder.innerHTML = `<svg width="${view.width}" height="${view.height}" stroke-width="${round(width)}" ` +
      `stroke-linecap="round">\n${parts.map(part => part[1]).join('\n')}\n</svg>`;
    return new XMLSerializer().serializeToString(holder.firstChild) + '\n'; // with the name space
  }

  // What apply_address() reads, of everything that can be chosen.
  address() {
    const {view, model} = this, parameters = new URLSearchParams(), of = name => document.getElementById(name).value;
    for (const [name, on] of Object.entries(this.state)) parameters.set(name, on ? 1 : 0);
    for (const name of ['opacity', 'significance', 'length', 'coloring', 'background', 'clip_axis', 'clip'])
      parameters.set(name, of(name));
    parameters.set('up', view.up);
    for (const [name, point] of [['eye', view.camera.position], ['target', view.controls.target]])
      parameters.set(name, point.toArray().map((value, k) => model.frame[k] + model.frame[3] * value).join());
    return parameters.toString();
  }

  // From `eye` to `target`, both given as x,y,z in the coordinates of the input.
  set_view(name, text) {
    const {view, model} = this, values = text.split(',').map(Number);
    if (values.length !== 3 || !values.every(Number.isFinite)) return;
    const point = name === 'eye' ? view.camera.position : view.controls.target;
    point.fromArray(values.map((value, k) => (value - model.frame[k]) / model.frame[3]));
    view.is_fitted = false;
    view.settle();
  }

  choose_up(axis) {
    this.view.look_from(axis);
    this.view.reset();
    this.mark_up();
  }

  mark_up() {
    for (const button of this.element.querySelectorAll('[data-up]'))
      button.classList.toggle('chosen', button.dataset.up === this.view.up);
  }

  show_panel(on) {
    this.element.style.display = on ? '' : 'none';
    this.make_room();
  }

  make_room() {
    const box = this.element.getBoundingClientRect();
    this.view.margin_left = box.right < .4 * window.innerWidth ? box.right : 0;
    this.view.resize();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const names = {s: 'surface', k: 'skeleton', n: 'nodes', b: 'balls', p: 'separators', c: 'color', t: 'points', e: 'repairs'};
    const key = event.key.toLowerCase();
    if (names[key]) this.set_visible(names[key], !this.state[names[key]]);
    else if (key === 'r') this.view.reset();
    else if (key === 'h') this.show_panel(this.element.style.display === 'none');
  }

  // The part of the address behind # can set switches (separators=1), opacity=60, significance=1, length=2 (over
  // radius), coloring=radius, background=dark, clip_axis=z, clip=60, up=z, turn=180 (degrees around up, from where the
  // view would start), eye=x,y,z, target=x,y,z, panel=0.
  apply_address(address) {
    for (const [name, value] of new URLSearchParams(address)) {
      if (name === 'opacity') this.set_opacity(value);
      else if (name === 'significance' || name === 'length') this.set_detail(name, value);
      else if (name === 'up' && /^[xyz]$/.test(value)) this.choose_up(value);
      else if (name === 'turn') { this.view.turn = Number(value) || 0; this.view.reset(); }
      else if (name === 'eye' || name === 'target') this.set_view(name, value);
      else if (name === 'clip') this.set_clip(value);
      else if (document.getElementById(name) instanceof HTMLSelectElement) this.set_choice(name, value);
      else if (name === 'panel') this.show_panel(value !== '0');
      else this.set_visible(name, value !== '0');
    }
  }
}

function figure(value) { return Number(value.toPrecision(5)).toString(); }

function describe_node(model, detail, node) {
  const frame = model.frame;
  const place = [0, 1, 2].map(k => figure(frame[k] + frame[3] * model.node_positions[3 * node + k]));
  const radius = model.node_radii ? '\nradius ' + figure(frame[3] * model.node_radii[node]) : '';
  return 'node ' + node + ', degree ' + detail.degree[node] + '\nat ' + place.join('  ') + radius;
}

function describe_branch(model, branch) {
  const row = measure_branch(model, branch), scale = model.frame[3];
  const radius = model.node_radii ? ', radius ' + figure(scale * row.radius) : '';
  const significance = Number.isFinite(row.significance) && model.node_radii ? ', significance ' + figure(row.significance) : '';
  return 'branch ' + branch + ': ' + row.edges + ' edges, length ' + figure(scale * row.length) + radius + significance;
}

// Tells about the node under the pointer.
function connect_tip(view, model, panel) {
  const tip = document.getElementById('tip'), reach = 9;
  view.element.addEventListener('mousemove', event => {
    const node = event.buttons === 0 ? panel.node_at(event.clientX, event.clientY, reach) : null;
    tip.style.display = node === null ? 'none' : 'block';
    if (node === null) return;
    tip.textContent = describe_node(model, panel.detail, node);
    tip.style.left = event.clientX + 14 + 'px';
    tip.style.top = event.clientY + 14 + 'px';
  });
}

// Works every switch as a user does, and looks at the pixels. One line a check; "ok" or "failed" at its begin.
class Self_test {
  constructor(view, panel) { Object.assign(this, {view, panel, lines: []}); }

  check(passed, text) { this.lines.push((passed ? 'ok ' : 'failed ') + text); }

  picture() {
    this.view.draw();
    const gl = this.view.renderer.getContext();
    const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  difference(a, b) {
    let count = 0;
    for (let i = 0; i < a.length; i += 4)
      if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2] || a[i + 3] !== b[i + 3]) ++count;
    return count;
  }

  check_change(name, change, undo) {
    const least = 50, before = this.picture();
    change();
    const changed = this.difference(before, this.picture());
    this.check(changed >= least, name + ': ' + changed + ' pixels changed');
    undo();
    const left = this.difference(before, this.picture());
    this.check(left === 0, name + ' undone: ' + left + ' pixels differ');
  }

  check_switches() {
    const empty = new Uint8Array(this.picture().length);
    const drawn = this.difference(empty, this.picture()) / (empty.length / 4);
    this.check(drawn > .01, 'drawn: ' + (100 * drawn).toFixed(1) + ' % of the picture');
    for (const box of document.querySelectorAll('[data-switch]')) {
      const name = box.dataset.switch;
      if (box.disabled) this.lines.push('absent ' + name);
      else this.check_change('switch ' + name, () => box.click(), () => box.click());
    }
    const boxes = [...document.querySelectorAll('[data-switch]')].filter(box => box.checked);
    boxes.forEach(box => box.click());
    const left = this.difference(empty, this.picture());
    this.check(left === 0, 'all switched off: ' + left + ' pixels left');
    boxes.forEach(box => box.click());
    const slider = document.getElementById('opacity'), opacity = slider.value;
    const slide = value => { slider.value = value; slider.dispatchEvent(new Event('input')); };
    this.check_change('slider opacity', () => slide(90), () => slide(opacity));
  }

  check_detail() {
    const slide = (name, value) => {
      const slider = document.getElementById(name);
      slider.value = value;
      slider.dispatchEvent(new Event('input'));
    };
    if (document.getElementById('significance').disabled) { this.lines.push('absent detail'); return; }
    const counts = () => ['nodes', 'edges', 'branches', 'tips', 'junctions', 'cycles'].map(name => {
      const figure = [...document.querySelectorAll('#figures div')].find(cell => cell.textContent.endsWith(name));
      return figure.firstChild.textContent + ' ' + name;
    }).join(', ');
    for (const name of ['significance', 'length']) {
      for (const value of [1, 2, 4, 8]) {
        slide(name, value);
        this.lines.push(name + ' ' + value + ': ' + counts());
      }
      slide(name, 0);
    }
    const whole = counts(), most = document.getElementById('significance').max;
    slide('significance', most);
    const changes = counts() !== whole;
    slide('significance', 0);
    this.check(counts() === whole, 'detail undone: ' + whole);
    if (changes)
      this.check_change('slider significance', () => slide('significance', most), () => slide('significance', 0));
  }

  check_movements() {
    const canvas = this.view.renderer.domElement, view = this.view;
    const mouse = (type, x, button) => (type === 'mousedown' ? canvas : document).dispatchEvent(
      new MouseEvent(type, {clientX: x, clientY: 200, button, bubbles: true, cancelable: true}));
    const drag = button => {
      mouse('mousedown', 300, button);
      mouse('mousemove', 380, button);
      mouse('mouseup', 380, button);
      view.settle();
    };
    const wheel = () => {
      canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, cancelable: true}));
      view.settle();
    };
    const reset = () => document.getElementById('reset').click();
    const up = this.view.up, other = up === 'z' ? 'y' : 'z';
    const choose = axis => document.querySelector('[data-up=' + axis + ']').click();
    this.check_change('turn', () => drag(0), reset);
    this.check_change('pan', () => drag(2), reset);
    this.check_change('zoom', wheel, reset);
    this.check_change('up', () => choose(other), () => choose(up));
    const key = name => window.dispatchEvent(new KeyboardEvent('keydown', {key: name}));
    this.check_change('key s', () => key('s'), () => key('S'));
  }

  check_lists() {
    const element = name => document.getElementById(name);
    const pick = (name, value) => { element(name).value = value; element(name).dispatchEvent(new Event('change')); };
    const has_radius = !element('significance').disabled;
    this.panel.set_visible('color', true);
    for (const name of has_radius ? ['region', 'radius', 'significance'] : ['region'])
      this.check_change('coloring ' + name, () => pick('coloring', name), () => pick('coloring', 'branch'));
    this.panel.set_visible('color', false);
    const slide = value => { element('clip').value = value; element('clip').dispatchEvent(new Event('input')); };
    for (const axis of ['x', 'y', 'z'])
      this.check_change('clip ' + axis, () => { pick('clip_axis', axis); slide(50); }, () => slide(100));
    pick('background', 'dark');
    this.check(getComputedStyle(document.body).backgroundColor === 'rgb(16, 21, 29)', 'background dark');
    pick('background', 'light');
  }

  // A click on a node shows its row, one beside the skeleton shows none.
  check_click() {
    const click = (x, y) => {
      for (const type of ['pointerdown', 'pointerup'])
        this.view.element.dispatchEvent(new PointerEvent(type, {clientX: x, clientY: y}));
    };
    const row = document.getElementById('row'), place = this.view.project(this.panel.model, 0);
    this.check_change('click', () => click(place.x, place.y), () => {
      this.check(/^node \d+, degree/.test(row.textContent), 'row: ' + row.textContent.replace(/\n/g, '; '));
      click(this.view.width - 1, 1);
    });
    this.check(row.style.display === 'none', 'row closed');
  }

  check_files() {
    const picture = this.view.picture(300, '#ffffff'), context = picture.getContext('2d');
    const pixels = context.getImageData(0, 0, picture.width, picture.height).data;
    this.check(picture.width === 300 && pixels.some((value, i) => i % 4 < 3 && value < 128), 'png of 300 pixels');
    const svg = new DOMParser().parseFromString(this.panel.svg(), 'image/svg+xml');
    const lines = svg.getElementsByTagName('line').length, shown = this.panel.detail.counts.edges;
    this.check(lines === shown, 'svg: ' + lines + ' lines of ' + shown + ' edges');
    const saved = [], create = URL.createObjectURL;
    URL.createObjectURL = blob => { saved.push(blob.type); return create.call(URL, blob); };
    document.getElementById('svg').click();
    URL.createObjectURL = create;
    this.check(saved.join() === 'image/svg+xml', 'saved ' + saved);
  }

  // The address of a moved view makes the same picture again.
  check_address() {
    this.view.camera.position.applyAxisAngle(this.view.camera.up, .7);
    this.view.settle();
    this.panel.set_visible('nodes', false);
    this.panel.set_choice('coloring', 'region');
    const address = this.panel.address(), before = this.picture();
    this.panel.set_visible('nodes', true);
    this.panel.set_choice('coloring', 'branch');
    this.view.reset();
    this.panel.apply_address(address);
    const different = this.difference(before, this.picture()) / (before.length / 4);
    this.check(different < .002, 'address: ' + (100 * different).toFixed(2) + ' % of the picture differ');
    this.panel.set_visible('nodes', true);
    this.panel.set_choice('coloring', 'branch');
    this.view.reset();
  }

  check_resize() {
    const element = this.view.element, width = element.clientWidth;
    element.style.width = width / 2 + 'px';
    element.style.right = 'auto';
    window.dispatchEvent(new Event('resize'));
    const ratio = this.view.renderer.domElement.clientWidth / width;
    this.check(Math.abs(ratio - .5) < .01, 'resize: canvas follows its element, ' + ratio.toFixed(2) + ' of the width');
    element.style.width = element.style.right = '';
    window.dispatchEvent(new Event('resize'));
  }

  run() {
    this.check_switches();
    this.check_detail();
    this.check_movements();
    this.check_lists();
    this.check_click();
    this.check_files();
    this.check_address();
    this.check_resize();
    const code = this.view.renderer.getContext().getError();
    this.check(code === 0, 'WebGL error code ' + code);
    for (const error of window.cscd.errors) this.check(false, 'error: ' + error);
    const failures = this.lines.filter(line => line.startsWith('failed')).length;
    this.lines.push(failures === 0 ? 'selftest passed' : 'selftest failed: ' + failures);
  }
}

function write_self_test(lines) {
  const result = document.body.appendChild(document.createElement('pre'));
  result.id = 'selftest';
  result.textContent = lines.join('\n');
}

function start() {
  if (typeof THREE === 'undefined' || !THREE.OrbitControls)
    throw new Error('This page was written without three.js and its OrbitControls.');
  choose_colors();
  const model = read_model(document.getElementById('cscd-data').textContent);
  const uniforms = {opacity: {value: .25}, colored: {value: 0}, clip: {value: new THREE.Vector4(1, 0, 0, 1e9)}};
  const view = new View(document.getElementById('view'), model);
  const detail = detail_of(model, {significance: 0, length: 0}), coloring = make_coloring(model, 'branch');
  const objects = make_objects(model, detail, coloring, uniforms);
  for (const object of Object.values(objects)) view.scene.add(object);
  const panel = new Panel(view, model, detail, coloring, objects, uniforms);
  if (model.triangles.length === 0) panel.set_visible('points', true);
  connect_tip(view, model, panel);
  Object.assign(window.cscd, {counts: model.counts, setVisible: (name, on) => panel.set_visible(name, on)});
  if (location.hash === '#selftest') {
    const test = new Self_test(view, panel);
    test.run();
    write_self_test(test.lines);
  } else {
    panel.apply_address(location.hash.slice(1));
  }
  view.draw();
  view.run();
  window.cscd.ready = true;
}

try {
  start();
} catch (error) {
  const message = document.getElementById('message');
  message.style.display = 'flex';
  message.textContent = 'The picture cannot be shown. ' + error.message;
  window.cscd.errors.push(error.message);
  if (location.hash === '#selftest') write_self_test(['failed error: ' + error.stack, 'selftest failed: 1']);
}
)js";

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_HTML_PAGE_TEMPLATE_H
