package daphnis.analysis.report

/**
 * The style of a report: light or dark as the reader's system is, readable on a narrow screen, printable in black and
 * white. Charts are drawn dark on white; on a dark page they are inverted and their hues turned back. Pictures of
 * spheres are dark on both.
 */
internal object PageStyle {
    const val CSS: String = """
:root{color-scheme:light dark;--ink:#1c2430;--quiet:#4a5564;--page:#fff;
--line:#d9dee5;--faint:#eceff3;--code:#f4f6f8;--link:#1f4e79;--shade:#0005}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0 auto;max-width:62rem;padding:1.5rem 1.25rem 4rem;color:var(--ink);background:var(--page);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif;counter-reset:section}
h1{font-size:1.9rem;line-height:1.2;margin:.2rem 0 .3rem;overflow-wrap:anywhere}
h2{font-size:1.25rem;margin:2.4rem 0 .4rem;padding-top:.8rem;border-top:1px solid var(--line);
scroll-margin-top:.5rem;counter-increment:section}
h2::before{content:counter(section) ". "}
.lead,.over,figcaption,small{color:var(--quiet)}
.lead{margin:0 0 1rem}
.over{margin:.2rem 0 .8rem}
nav ol{display:flex;flex-wrap:wrap;gap:.1rem 1.1rem;margin:0;padding:0;list-style:none;counter-reset:entry}
nav li{counter-increment:entry;padding:.25rem 0}
nav li::before{content:counter(entry) ". ";color:var(--quiet)}
a{color:var(--link)}
figure{margin:1.1rem 0}
figure img{display:block;max-width:100%;height:auto;margin:0 auto}
.picture img{max-height:46rem}
figcaption{font-size:.92rem;margin-top:.4rem}
.scroll{overflow-x:auto;background:
linear-gradient(to left,var(--page) 40%,transparent) right/2.5rem 100% no-repeat local,
linear-gradient(to right,var(--page) 40%,transparent) left/2.5rem 100% no-repeat local,
linear-gradient(to left,var(--shade),transparent) right/1rem 100% no-repeat scroll,
linear-gradient(to right,var(--shade),transparent) left/1rem 100% no-repeat scroll}
.hint{display:none;margin:0;font-size:.85rem;color:var(--quiet)}
table{border-collapse:collapse;font-size:.94rem}
th,td{text-align:left;padding:.28rem .9rem .28rem 0;vertical-align:top;border-bottom:1px solid var(--faint)}
thead th{border-bottom:1px solid var(--line);font-weight:600;white-space:nowrap}
.numbers td:first-child{min-width:11rem}
.parameters th{font-weight:500;color:var(--quiet);white-space:nowrap}
.parameters td{overflow-wrap:anywhere}
.n,.u{white-space:nowrap}
.n{font-variant-numeric:tabular-nums}
small{font-size:.9em}
pre{background:var(--code);padding:.8rem 1rem;overflow-x:auto;font-size:.92rem;border-radius:4px}
@media(max-width:46rem){
body{padding:1rem .8rem 3rem}
h1{font-size:1.5rem}
.chart img{max-width:none;width:36rem}
.parameters th{white-space:normal;min-width:6rem}
}
@media(max-width:38rem){
.numbers:not(.compared) tr{display:grid;grid-template-columns:minmax(0,1fr) 9.2rem;border-bottom:1px solid var(--faint)}
.numbers:not(.compared) td,.numbers:not(.compared) th{border:0}
.numbers:not(.compared) thead th:nth-child(3){display:none}
.numbers:not(.compared) .u{grid-column:2;padding-top:0;color:var(--quiet);font-size:.9em}
.numbers:not(.compared) .u:empty{display:none}
.hint{display:block}
}
@media screen and (prefers-color-scheme:dark){
:root{--ink:#e4e7ec;--quiet:#a9b2bf;--page:#1a1a1a;--line:#3d4148;--faint:#2b2e33;--code:#26282c;--link:#8fbfe8;--shade:#000c}
.chart img{filter:invert(.9) hue-rotate(180deg)}
}
@media print{
body{max-width:none;padding:0;font-size:11pt}
nav{display:none}
h2{break-after:avoid}
figure,tr{break-inside:avoid}
.scroll{overflow:visible;background:none}
.hint{display:none}
.chart img{width:auto;max-width:100%}
pre{white-space:pre-wrap}
}
"""
}
