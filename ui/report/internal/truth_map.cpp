// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/truth_map.h"

#include "core/workflow/known_truth.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/run_painting.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/widgets/theme.h"

#include <QPainter>
#include <algorithm>

namespace odo {

namespace {

/// So many times that the largest errors can be seen at this scale: 1, 2, 5, 10, ...
double enlargementOf(const std::vector<CertificateRun> &runs, double scalePx)
{
    constexpr double strokePx = 14, largest = 1000;
    double worstM = 0;
    for (const CertificateRun &run : runs)
        for (std::size_t i = 0; i < run.profile.points.size(); ++i)
            if (const auto truth = truthAt(run.truth, run.profile.samples[i].time);
                truth && run.profile.points[i].valid)
                worstM =
                    std::max(worstM, (run.profile.points[i].position - run.truth.positions[*truth]).norm());
    double best = 1;
    for (double decade = 1; decade <= largest; decade *= 10)
        for (const double factor : {decade, 2 * decade, 5 * decade})
            if (factor <= largest && factor * worstM * scalePx <= strokePx)
                best = factor;
    return best;
}

} // namespace

double drawTruthMap(QPainter &painter, const QRectF &rect, const Eigen::AlignedBox2d &bounds,
                    const MarkerLayout &layout, const Task *task, const std::vector<CertificateRun> &runs)
{
    const QPalette &palette = reportPalette();
    const double enlarged = enlargementOf(runs, MapPlan{bounds, rect.size()}.scalePx());
    drawFramedMap(painter, rect, bounds, layout, [&](const MapPlan &plan) {
        const auto toPage = [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); };
        if (task) {
            drawZones(painter, literalNames(task->zones), toPage, palette);
            drawGates(painter, literalNames(task->gates), toPage, palette);
        }
        for (std::size_t number = 0; number < runs.size(); ++number) {
            const CertificateRun &run = runs[number];
            painter.setPen(QPen(seriesColour(int(number), palette), 0.8));
            for (std::size_t i = number; i < run.profile.points.size(); i += runs.size()) {
                const auto truth = truthAt(run.truth, run.profile.samples[i].time);
                if (!truth || !run.profile.points[i].valid)
                    continue;
                const Eigen::Vector2d &at = run.truth.positions[*truth];
                const Eigen::Vector2d end = at + enlarged * (run.profile.points[i].position - at);
                painter.drawLine(plan.fromWorld(at), plan.fromWorld(end));
            }
        }
        if (!runs.empty())
            drawReferencePath(painter, {runs.front().truth.positions, false}, toPage, palette);
    });
    return enlarged;
}

} // namespace odo
