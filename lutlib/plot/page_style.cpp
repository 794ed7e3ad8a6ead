#include "lutlib/plot/page_parts.h"
#include "lutlib/plot/palette.h"

#include <fmt/core.h>

namespace plot {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 1560px; margin: 1.5em auto; padding: 0 1em;
       color: #222; background: #fff; }
h1 { font-size: 1.4em; }
h2 { font-size: 1.15em; margin: 1.6em 0 .4em; border-bottom: 1px solid #ddd; }
h3 { font-size: 1em; margin: .8em 0 .2em; }
p { max-width: 75em; }
.summary { font-size: 1.1em; border-left: 4px solid #009E73; padding: .3em .8em; background: #f3f8f6; }
.plots { display: none; flex-wrap: wrap; gap: 1em; margin-top: .5em; }
.plots svg { flex: 1 1 560px; max-width: 100%; border: 1px solid #ddd; }
svg text { font: 15px system-ui, sans-serif; fill: #222; }
svg .title { font-weight: 600; font-size: 17px; }
svg .name { font-size: 12.5px; }
svg .mark ~ .name { paint-order: stroke; stroke: #fff; stroke-width: 3px; }
svg tspan { font-size: 11px; }
.grid { stroke: #e6e6e6; fill: none; }
.frame { stroke: #777; fill: none; }
.front { stroke: #222; stroke-width: 1.8; fill: none; stroke-dasharray: 6 3; }
.interval { stroke: #222; stroke-width: 1; fill: none; opacity: .7; }
.line { stroke-width: 2; fill: none; }
.dashed { stroke-dasharray: 5 3; }
.mark { opacity: .36; cursor: pointer; }
.mark.top, .mark.best { opacity: 1; stroke: #222; stroke-width: .7; }
.mark.best { stroke-width: 2.5; }
.mark.picked, .mark:hover { opacity: 1; stroke: #000; stroke-width: 2.5; }
.figures { display: flex; flex-wrap: wrap; gap: 1em; margin-top: .5em; }
.figures div { flex: 0 1 492px; border: 1px solid #ddd; break-inside: avoid; }
.figures .wide { flex: 1 1 100%; }
.figures svg { display: block; width: 100%; }
.outline { fill: none; stroke: #333; }
.out { display: none; }
label.view, label.only { margin-right: 1.2em; white-space: nowrap; }
#front-only:checked ~ .plots .mark:not(.top):not(.best),
#front-only:checked ~ table tr.dominated { display: none; }
.filters { display: inline; }
.filters select { max-width: 9em; margin: 0 1em 0 .3em; font: inherit; font-size: 13px; }
.panels { display: flex; flex-wrap: wrap; gap: .8em 1.4em; align-items: flex-start; }
.panels .heat { width: 290px; }
.panels .share { width: 470px; }
.heat .title { font-size: 14px; }
.heat .name, .scale .name { font-size: 11.5px; }
.heat .node { stroke: #fff; stroke-width: 1; opacity: .8; fill: none; }
.heat .cells { shape-rendering: crispEdges; }
.scale { width: 410px; display: block; }
.bands { width: 100%; max-width: 1000px; }
.band { display: flex; align-items: center; gap: .6em; font-size: 12.5px; }
.band span { flex: 0 0 14em; text-align: right; }
.band svg { height: 22px; width: 100%; border: 1px solid #bbb; }
.patches { display: flex; flex-wrap: wrap; gap: 3px; margin: .2em 0 .6em; }
.patch { width: 86px; font-size: 11px; line-height: 1.25; }
.patch i { display: block; height: 26px; border: 1px solid #bbb; print-color-adjust: exact; }
.patch b { float: right; }
table { border-collapse: collapse; font-size: 12px; margin-top: 1em; }
th, td { padding: .15em .4em; text-align: right; border-bottom: 1px solid #eee; white-space: nowrap; }
td:not([data-v]) { text-align: left; }
th.words { text-align: left; }
th { position: sticky; top: 0; background: #f5f5f5; vertical-align: bottom; white-space: normal; }
th[role=button] { cursor: pointer; }
.all tbody tr { cursor: pointer; }
tr.dominated { color: #6b6b6b; }
tr.recommended td { background: #e3f4ec; font-weight: 600; }
tr.picked td { background: #fff3c4; }
.on-paper { display: none; }
@media print {
  body { font-size: 11px; max-width: none; }
  tr.dominated, input.view, label.view, .only, .filters { display: none; }
  .on-paper { display: block; }
  th { position: static; }
  td { white-space: normal; }
  .plots, .panels svg, .band { break-inside: avoid; }
  .mark { opacity: .5; }
}
)";

} // namespace

std::string page_style() {
    std::string out = style;
    for (std::size_t i = 0; i < series_colors.size(); ++i) {
        out += fmt::format(".s{} {{ fill: {}; }}\n", i, series_colors[i]);
    }
    return out;
}

} // namespace plot
