#pragma once

#include <string_view>

namespace matrigrate::report {

/// The style sheet of a report. On narrow screens each row of a table of checks becomes a card.
inline constexpr std::string_view page_style = R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 1rem; background: #fff; color: #1f2328;
  font: 1rem/1.5 system-ui, "Segoe UI", Helvetica, Arial, "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 0 0 .25rem; }
p { margin: .4rem 0; max-width: 48rem; }
a { color: #0550ae; }
section { border-top: 1px solid #8c959f; margin-top: 2rem; padding-top: 1rem; }
table { border-collapse: collapse; margin: 1rem 0; width: 100%; font-variant-numeric: tabular-nums; }
th, td { border-bottom: 1px solid #d0d7de; padding: .4rem .7rem .4rem 0; text-align: left; vertical-align: top; }
th { border-bottom-color: #57606a; }
td.verdict, .checks td:nth-child(2), .checks td:nth-child(3), .checks td:nth-child(4) { white-space: nowrap; }
table.claims { font-size: .9rem; }
.claims td:nth-child(2), .claims td:nth-child(3), .claims td:nth-child(4) { white-space: normal; }
.claims td:nth-child(5) { white-space: nowrap; }
.holds, .fails { font-weight: 600; }
.holds { color: #0a5c36; }
.fails { color: #9a1c00; }
.undecided { font-weight: 600; color: #57606a; }
.undecided::before { content: "?\00a0"; }
.caveat { display: inline-block; background: #fff1e5; color: #8a2f00; padding: 0 .4rem; border-radius: .3rem; }
.notice { border-left: 4px solid #d55e00; background: #f6f8fa; padding: .6rem .9rem; }
dl { margin: .6rem 0; }
dt { color: #57606a; margin-top: .5rem; }
dd { margin: 0; }
dd ul { margin: 0; padding-left: 1.2rem; }
.holds::before { content: "\2713\00a0"; }
.fails::before { content: "\2717\00a0"; }
.figures { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); }
figure { margin: 0; max-width: 45rem; }
figure svg { display: block; width: 100%; height: auto; }
figcaption { margin-top: .3rem; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: #f6f8fa; padding: .8rem; font-size: .9rem;
  font-family: ui-monospace, "DejaVu Sans Mono", monospace; }
@media (max-width: 50rem) {
  .overview thead, .checks thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  .overview, .overview tbody { display: block; }
  .overview tr { display: grid; grid-template-columns: 1fr auto; border-bottom: 1px solid #d0d7de; padding: .4rem 0; }
  .overview td { border: 0; padding: 0; }
  .overview td:nth-child(2) { grid-row: 2; grid-column: 1 / 3; }
  .checks, .checks tbody, .checks tr, .checks td { display: block; }
  .checks tr { border: 1px solid #8c959f; border-radius: .4rem; margin-bottom: .8rem; padding: .5rem .7rem; }
  .checks td { display: grid; grid-template-columns: 6.5rem 1fr; gap: .6rem; border: 0; padding: .15rem 0; }
  .checks td::before { content: attr(data-label); color: #57606a; }
  .checks td:first-child { display: block; font-weight: 600; }
  .checks td:first-child::before { content: none; }
  .claims td.nothing { display: none; }
  .claims td:nth-child(5) { white-space: normal; }
  .figures { margin: 0 -.75rem; }
  figcaption { padding: 0 .75rem; }
}
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  a { color: inherit; text-decoration: none; }
  h2 { break-after: avoid; }
  tr, figure { break-inside: avoid; }
  .figures { display: block; }
  figure { max-width: 14cm; margin-bottom: .6cm; }
  pre { border: 1px solid #d0d7de; }
}
)css";

} // namespace matrigrate::report
