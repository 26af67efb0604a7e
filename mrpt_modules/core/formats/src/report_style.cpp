// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

namespace traverse::formats
{
namespace
{
constexpr std::string_view kStyleSheet = R"css(
:root {
  color-scheme: light dark;
  --page: #f6f7f9; --card: #ffffff; --ink: #1c2330; --soft: #5b6576; --line: #dde2ea;
  --accent: #2f6fde; --notice: #fff4d6; --notice-line: #e0a800; --gap: #e08a00; --bad: #b3261e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #12151b; --card: #1a1f28; --ink: #e6eaf1; --soft: #98a3b5; --line: #2c3442;
    --accent: #6ea2ff; --notice: #3a3014; --notice-line: #d9a400; --gap: #ffb43c; --bad: #ff8a80;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;
}
header, main, footer { max-width: 1080px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 44px; padding-bottom: 8px; }
h1 {
  margin: 0; font-size: 30px; line-height: 1.2; font-weight: 650; letter-spacing: -0.01em;
  overflow-wrap: anywhere;
}
.subtitle { margin: 6px 0 0; color: var(--soft); overflow-wrap: anywhere; }
nav { margin-top: 18px; display: flex; flex-wrap: wrap; gap: 6px 18px; font-size: 14px; }
nav a { color: var(--accent); text-decoration: none; }
nav a:hover { text-decoration: underline; }
section {
  background: var(--card); border: 1px solid var(--line); border-radius: 10px;
  padding: 22px 26px 26px; margin: 20px 0;
}
h2 { margin: 0 0 14px; font-size: 19px; font-weight: 620; }
p { margin: 0 0 14px; max-width: 46em; overflow-wrap: anywhere; }
.notice {
  background: var(--notice); border-left: 4px solid var(--notice-line); border-radius: 4px;
  padding: 10px 14px; max-width: none;
}
.figures { display: flex; flex-wrap: wrap; gap: 14px 40px; margin: 0 0 18px; }
.figures div { min-width: 96px; }
.figures dt { color: var(--soft); font-size: 13px; }
.figures dd { margin: 0; font-size: 24px; font-weight: 600; font-variant-numeric: tabular-nums; }
figure { margin: 0 0 18px; }
figure img {
  display: block; max-width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px;
}
figure img.pixelated { image-rendering: pixelated; }
figcaption, caption { color: var(--soft); font-size: 14px; text-align: left; padding: 6px 0; }
.chart figcaption { color: var(--ink); font-weight: 600; padding: 0 0 8px; }
.gallery img { width: 100%; }
section > :last-child, .gallery figure { margin-bottom: 0; }
.gallery { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 18px; }
.legend { list-style: none; display: flex; flex-wrap: wrap; gap: 8px 22px; margin: 0 0 18px; padding: 0; }
.legend li { display: flex; align-items: center; gap: 8px; font-size: 14px; }
.legend span {
  width: 18px; height: 18px; border-radius: 4px; border: 1px solid rgba(127, 127, 127, 0.5);
}
.scroll { overflow-x: auto; margin: 0 0 18px; }
table { border-collapse: collapse; font-size: 14px; min-width: 320px; }
caption { caption-side: top; }
th, td { padding: 6px 22px 6px 0; border-bottom: 1px solid var(--line); text-align: left; }
th { color: var(--soft); font-weight: 600; }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
svg { display: block; width: 100%; max-width: 720px; height: auto; }
svg text { fill: var(--ink); font-size: 13px; font-family: inherit; }
svg .soft { fill: var(--soft); }
svg .bar { fill: var(--accent); }
svg .outlined { stroke: var(--line); stroke-width: 1; }
svg.timeline { max-width: none; }
svg.timeline text { font-size: 11px; }
svg .gap { fill: var(--gap); opacity: 0.4; }
svg .backward { fill: #d4361e; }
svg .repeated { fill: var(--gap); }
svg .axis { stroke: var(--line); stroke-width: 1; }
.map-bar { display: flex; flex-wrap: wrap; align-items: center; gap: 8px 10px; margin: 8px 0; font-size: 14px; }
.map-bar select, .map-bar button {
  font: inherit; color: var(--ink); background: var(--page); border: 1px solid var(--line); border-radius: 6px;
  padding: 4px 10px; min-height: 32px;
}
.map-bar button { min-width: 34px; cursor: pointer; }
.map-body { display: flex; flex-wrap: wrap; gap: 16px; }
.map-stage { flex: 3 1 420px; min-width: 0; }
.map canvas {
  display: block; width: 100%; height: min(66vh, 620px); background: var(--page); color: var(--ink);
  border: 1px solid var(--line); border-radius: 6px; touch-action: none; cursor: crosshair;
}
.map canvas:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.map-scale { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 8px; padding: 8px 0; font-size: 13px; }
.map-scale .swatch { width: 14px; height: 14px; border-radius: 3px; border: 1px solid rgba(127, 127, 127, 0.5); }
.map-scale .ramp { flex: 0 1 200px; min-width: 60px; height: 12px; border-radius: 3px; }
.map-values { flex: 1 1 250px; font-size: 13px; min-height: 330px; }
.map-values p { color: var(--soft); }
.map-values table { width: 100%; min-width: 0; font-size: 13px; }
.map-values th, .map-values td { padding: 3px 8px 3px 0; overflow-wrap: anywhere; }
.map-values td { text-align: right; font-variant-numeric: tabular-nums; }
.wide header, .wide main { max-width: 1500px; }
.runs th button { font: inherit; color: inherit; background: none; border: none; padding: 0; cursor: pointer; }
.runs th button:hover { text-decoration: underline; }
.runs th[aria-sort=ascending] button::after { content: " \25B2"; }
.runs th[aria-sort=descending] button::after { content: " \25BC"; }
.runs td { max-width: 22em; overflow-wrap: anywhere; }
.runs a { color: var(--accent); }
.runs .thumbnail img { display: block; width: 150px; border: 1px solid var(--line); border-radius: 4px; }
.runs .bad { color: var(--bad); }
footer { padding-top: 4px; padding-bottom: 40px; color: var(--soft); font-size: 13px; }
@media print {
  body { background: none; } section { break-inside: avoid; border: none; padding: 0; } nav { display: none; }
  .map { display: none; }
}
)css";
}  // namespace

std::string_view styleSheet()
{
  return kStyleSheet;
}
}  // namespace traverse::formats
