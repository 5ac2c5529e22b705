// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/comparison_explanation.h"

#include "ui/models/figure_text.h"

#include <QCoreApplication>
#include <cmath>

namespace odo {

namespace {

class ComparisonExplanationWords
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonExplanation)
};

QString nameOf(const ComparisonScene &scene, std::size_t run)
{
    return QString::fromStdString(scene.name(run));
}

/// Whether a difference can be claimed, with the numbers that say so.
QString significanceText(const Difference &difference)
{
    const QLocale locale;
    if (!(difference.sigma > 0))
        return difference.value == 0
                   ? ComparisonExplanationWords::tr("There is no difference.")
                   : ComparisonExplanationWords::tr("Both are exact, so that any difference is one.");
    const QString ratio = locale.toString(std::abs(difference.value) / difference.sigma, 'f', 1);
    return difference.isSignificant()
               ? ComparisonExplanationWords::tr("It is %1 σ, more than 1.96: were there no difference, "
                                                "chance would give as much in less than 5 of 100 cases.")
                     .arg(ratio)
               : ComparisonExplanationWords::tr("It is %1 σ, not more than 1.96: within the error, so that "
                                                "no difference can be claimed.")
                     .arg(ratio);
}

QString sourceText()
{
    return QStringLiteral("JCGM 100:2008, 5.1.2, G.1");
}

/// What all comparisons rest on: the path, the moment that counts as the same, the calibration, both analyses.
QStringList comparisonInputs(const ComparisonScene &scene, std::size_t run)
{
    const RunComparison &comparison = scene.compared.comparison;
    QStringList lines;
    lines << (comparison.isTasksPath
                  ? ComparisonExplanationWords::tr("along the task's reference path")
                  : ComparisonExplanationWords::tr("along the way of %1").arg(nameOf(scene, 0)));
    switch (comparison.alignedBy) {
    case AlignBy::StartGate:
        lines << ComparisonExplanationWords::tr("time 0: each passes the start gate");
        break;
    case AlignBy::MotionOnset:
        lines << ComparisonExplanationWords::tr("time 0: each begins to move");
        break;
    case AlignBy::Distance:
        lines << ComparisonExplanationWords::tr("time 0: each first comes to the same place of the way");
        break;
    case AlignBy::ByHand:
        lines << ComparisonExplanationWords::tr("time 0: told by hand, to a frame");
        break;
    }
    lines << (comparison.shareCalibration
                  ? ComparisonExplanationWords::tr(
                        "both by the same registrations and for the same solid: what the calibration adds is "
                        "common, and only its difference counts")
                  : ComparisonExplanationWords::tr(
                        "not by the same registrations, or not for the same solid: what the calibration adds "
                        "counts for both in full"));
    for (const std::size_t each : {std::size_t(0), run})
        lines << analysisInputs(*scene.scenes[each], scene.robots[each]);
    lines.removeDuplicates();
    return lines;
}

QString timeWithUnit(const Difference &time)
{
    return figureText(time.value, time.sigma, QStringLiteral("s")).text();
}

} // namespace

Explanation explainDifference(const ComparisonScene &scene, std::size_t run, const MetricDifference &metric)
{
    const auto figure = [&metric](std::optional<double> value, std::optional<double> sigma) {
        return value ? metricFigure({metric.name, metric.unit, *value, sigma}).text()
                     : ComparisonExplanationWords::tr("none");
    };
    Explanation told;
    told.what = ComparisonExplanationWords::tr("%1: %2 less %3")
                    .arg(metricName(metric.name), nameOf(scene, run), nameOf(scene, 0));
    told.inputs << ComparisonExplanationWords::tr("%1: %2").arg(nameOf(scene, 0),
                                                                figure(metric.a, metric.sigmaA));
    told.inputs << ComparisonExplanationWords::tr("%1: %2").arg(nameOf(scene, run),
                                                                figure(metric.b, metric.sigmaB));
    const Explanation each = explainMetric(Metric{metric.name, metric.unit, 0, metric.sigmaA ? metric.sigmaA : metric.sigmaB}, {});
    if (!metric.difference) {
        told.value = ComparisonExplanationWords::tr("only one of the two has it");
        told.formula = each.formula;
    } else {
        told.value = figure(metric.difference->value, metric.difference->sigma);
        told.formula = ComparisonExplanationWords::tr("the figure of %1 less that of %2")
                           .arg(nameOf(scene, run), nameOf(scene, 0)) +
                       u'\n' + significanceText(*metric.difference);
        if (!each.formula.isEmpty())
            told.formula += u'\n' + ComparisonExplanationWords::tr("Each: %1").arg(each.formula);
        told.uncertainty =
            ComparisonExplanationWords::tr("√(σ₁² + σ₂²), both as independent; where the runs share their "
                                           "calibration, its error of scale leaves "
                                           "only its part of the difference");
        told.source = sourceText();
    }
    told.inputs += comparisonInputs(scene, run);
    return told;
}

Explanation explainSector(const ComparisonScene &scene, std::size_t run, const SectorTimes &sector)
{
    const auto time = [](const std::optional<Difference> &of) {
        return of ? timeWithUnit(*of) : ComparisonExplanationWords::tr("not seen at an end");
    };
    Explanation told;
    told.what = ComparisonExplanationWords::tr("Sector %1 to %2: %3 less %4")
                    .arg(sector.from.empty() ? ComparisonExplanationWords::tr("begin")
                                             : QString::fromStdString(sector.from),
                         sector.to.empty() ? ComparisonExplanationWords::tr("end")
                                           : QString::fromStdString(sector.to),
                         nameOf(scene, run), nameOf(scene, 0));
    const auto &difference = sector.differences.at(run);
    told.value = time(difference);
    told.formula =
        ComparisonExplanationWords::tr("The time from the first arrival at the one gate to the first arrival "
                                       "at the next, of each run, by its place along "
                                       "the common path; waiting counts.");
    if (difference)
        told.formula += u'\n' + significanceText(*difference);
    told.uncertainty =
        ComparisonExplanationWords::tr("of each arrival: σ of the place along the path over the speed; "
                                       "displacements at two gates count as independent");
    told.source = sourceText();
    told.inputs << ComparisonExplanationWords::tr("from %1 to %2 of the way")
                       .arg(distanceText(sector.fromM - scene.compared.comparison.originM),
                            distanceText(sector.toM - scene.compared.comparison.originM));
    told.inputs << ComparisonExplanationWords::tr("%1: %2").arg(nameOf(scene, 0), time(sector.times.at(0)));
    told.inputs << ComparisonExplanationWords::tr("%1: %2").arg(nameOf(scene, run),
                                                                time(sector.times.at(run)));
    told.inputs += comparisonInputs(scene, run);
    return told;
}

Explanation explainTimeDifference(const ComparisonScene &scene, std::size_t run, double distanceM, const Difference &difference)
{
    Explanation told;
    told.what = ComparisonExplanationWords::tr("Δt of %1 against %2 at %3")
                    .arg(nameOf(scene, run), nameOf(scene, 0), distanceText(distanceM));
    told.value = timeWithUnit(difference);
    told.formula =
        ComparisonExplanationWords::tr("The time of the first arrival at this place of the common path, each "
                                       "from its own time 0: that of %1 less that of %2. "
                                       "Above 0 it is later.")
            .arg(nameOf(scene, run), nameOf(scene, 0)) +
        u'\n' + significanceText(difference);
    told.uncertainty = ComparisonExplanationWords::tr(
        "of both arrivals: σ of the place along the path over the speed, and of both times 0");
    told.source = sourceText();
    told.inputs = comparisonInputs(scene, run);
    return told;
}

Explanation explainSpeedOnWay(const ComparisonScene &scene, std::size_t run, double distanceM, const QString &value)
{
    Explanation told;
    told.what =
        ComparisonExplanationWords::tr("Speed of %1 at %2").arg(nameOf(scene, run), distanceText(distanceM));
    told.value = value;
    told.formula =
        ComparisonExplanationWords::tr("|v| of the smoothed curve where the run first comes to this place of "
                                       "the common path, between frames interpolated");
    told.uncertainty = ComparisonExplanationWords::tr(
        "σ of the smoothed velocity there, with the calibration's error of scale");
    told.inputs = comparisonInputs(scene, run);
    return told;
}

} // namespace odo
