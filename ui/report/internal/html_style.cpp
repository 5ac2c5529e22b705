// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/html_style.h"

#include "ui/report/run_map.h"
#include "ui/views/widgets/theme.h"

#include <QPalette>

namespace odo {

namespace {

constexpr int seriesCount = 6;

/// The colours of a theme as variables.
QString variables(const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    QString css;
    const auto add = [&css](const QString &name, const QColor &colour) {
        css += QStringLiteral("--%1:%2;").arg(name, colour.name());
    };
    add(QStringLiteral("page"), colours.card);
    add(QStringLiteral("text"), colours.text);
    add(QStringLiteral("muted"), colours.muted);
    add(QStringLiteral("border"), colours.border);
    add(QStringLiteral("grid"), colours.grid);
    add(QStringLiteral("spike"), colours.spike);
    add(QStringLiteral("dot"), colours.point);
    add(QStringLiteral("ground"), colours.mapGround);
    for (int i = 0; i < seriesCount; ++i)
        add(QStringLiteral("s%1").arg(i), seriesColour(i, palette));
    return css;
}

} // namespace

QString drawingStyle()
{
    QString css =
        QStringLiteral(":root{color-scheme:light dark;%1}\n@media (prefers-color-scheme:dark){:root{%2}}\n")
            .arg(variables(lightPalette()), variables(darkPalette()));
    css +=
        QStringLiteral(R"(svg{display:block;width:100%;height:auto;background:var(--ground);border-radius:4px}
svg text{font:13px system-ui,sans-serif;fill:var(--muted)}
svg path,svg polyline,svg polygon{fill:none;stroke-linejoin:round}
.grid{stroke:var(--grid);stroke-width:1}.line{stroke-width:2}.ink{stroke:var(--text)}
svg .band{stroke:none;opacity:.25}.columns{opacity:.25;stroke-width:1.2}
svg .dots{stroke:var(--dot);stroke-width:2;stroke-linecap:round}svg .spikes{fill:var(--spike)}
.gap{fill:var(--border);opacity:.4}.rim{stroke:var(--text);stroke-width:5;opacity:.3}
.run{stroke-width:3.2}.bridged{stroke-dasharray:2 3}.course{stroke:var(--text);stroke-dasharray:5 4}
.gate{stroke:var(--text);stroke-width:2.5}.zone{stroke:var(--muted)}.out{stroke:var(--spike)}
.marker{fill:var(--muted)}.start{fill:var(--ground);stroke:var(--text);stroke-width:2}.finish{fill:var(--text)}
)");
    for (int i = 0; i < seriesCount; ++i)
        css += QStringLiteral(
                   ".s%1{stroke:var(--s%1)}.key.s%1{color:var(--s%1)}svg .band.s%1{fill:var(--s%1)}\n")
                   .arg(i);
    return css;
}

QString htmlStyle()
{
    return drawingStyle() + QStringLiteral(R"(*{box-sizing:border-box}
body{margin:0 auto;max-width:66rem;padding:1rem;background:var(--page);color:var(--text);
font:1rem/1.5 system-ui,sans-serif;overflow-wrap:anywhere}
h1{font-size:1.6rem;line-height:1.2;margin:.5rem 0}h2{font-size:1.3rem;margin:2rem 0 .3rem}
h3{font-size:1rem;margin:1.2rem 0 .3rem}
section+section{border-top:1px solid var(--border);margin-top:2rem}
.facts,figcaption,footer{color:var(--muted)}figcaption,footer,li{font-size:.85rem}
figcaption strong{color:var(--text)}ul{padding-left:1.2rem}
.verdict{border-left:4px solid var(--s2);padding:.3rem .8rem;margin:1rem 0;background:var(--ground)}
.verdict p{margin:.2rem 0}.doubtful{border-color:var(--s4)}.bad{border-color:var(--spike)}
.figures{display:grid;gap:1rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,26rem),1fr))}
figure{margin:0}@media (min-width:58rem){.figures figure:first-child{grid-row:span 2}}
.scroll{overflow-x:auto;margin:1rem 0}table{border-collapse:collapse;min-width:50%}
caption{text-align:left;font-weight:600;padding:.3rem 0}
th,td{padding:.25rem .8rem .25rem 0;text-align:right;border-top:1px solid var(--border);
font-weight:400;font-variant-numeric:tabular-nums;overflow-wrap:normal}
th:first-child,td:first-child,th:last-child,td:last-child{text-align:left}
thead th{color:var(--muted);font-size:.85rem;border-top:0}tr.faint{color:var(--muted)}
.key{display:inline-block;width:1.6rem;height:.3rem;margin:0 .4rem .2rem .8rem;background:currentColor}
.faint{stroke:var(--muted)}
@media (max-width:40rem){svg text{font-size:17px}th,td{padding-right:.5rem;font-size:.9rem}}
@media print{body{max-width:none}figure,table{break-inside:avoid}}
)");
}

} // namespace odo
