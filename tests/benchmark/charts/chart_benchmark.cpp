// SPDX-License-Identifier: GPL-3.0-or-later
// How fast Review's charts of an hour are repainted at every zoom, on the raster.
#include "tests/benchmark/cpu_clock.h"
#include "tests/benchmark/metrics.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QFile>
#include <QJsonDocument>
#include <QTextStream>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int samples = 216'000, steps = 40; // an hour at 60 frames/s
constexpr QSize chartSize(1100, 240);

/// CPU time of repainting both charts with so much of the hour visible, a little further on at each step, in
/// ms: the median of many.
double panMs(ChartSpan &span, ProfileChart &speed, ProfileChart &acceleration, double share)
{
    const double whole = span.wholeHigh() - span.wholeLow();
    // The whole cannot be moved: there the last thousandth comes and goes.
    const double width = std::min(share, 0.999) * whole,
                 step = std::min(0.05 * width, (whole - width) / steps);
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        const double begin = threadCpuS();
        if (share < 1)
            span.show(span.wholeLow() + i * step, span.wholeLow() + i * step + width);
        else
            span.show(span.wholeLow(), span.wholeLow() + (i % 2 ? whole : width));
        speed.grab();
        acceleration.grab();
        times.push_back(1e3 * workS(begin, threadCpuS()));
    }
    return median(times);
}

/// CPU time of the longest turn of the event loop from when a scene is given to both charts until both have
/// painted it, in ms.
double longestTurnMs(ProfileChart &speed, ProfileChart &acceleration, const TrialScenePtr &scene)
{
    double longest = 0;
    const auto turn = [&longest](const auto &work) {
        const double begin = threadCpuS();
        work();
        longest = std::max(longest, 1e3 * workS(begin, threadCpuS()));
    };
    turn([&] {
        speed.setScene(scene);
        acceleration.setScene(scene);
    });
    while (!speed.isSettled() || !acceleration.isSettled())
        turn([] { QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents); });
    turn([] { QCoreApplication::processEvents(); });
    return longest;
}

/// Charts of so many robots, with so many samples each.
void measure(const TrialScenePtr &scene, int robots, std::vector<Measurement> &metrics)
{
    Timeline timeline;
    ChartSpan span(timeline);
    timeline.setFrameTimes(scene->frameTimes());
    ProfileChart speed(timeline, span, {Quantity::Speed}),
        acceleration(timeline, span, {Quantity::Acceleration});
    for (ProfileChart *chart : {&speed, &acceleration}) {
        chart->resize(chartSize);
        chart->show();
    }
    QCoreApplication::processEvents();
    const double shownMs = longestTurnMs(speed, acceleration, scene);
    constexpr double frameMs = 1000.0 / 30;
    const QString whose = robots == 1 ? QStringLiteral("one robot") : QStringLiteral("%1 robots").arg(robots);
    metrics.push_back({QStringLiteral("%1: an hour shown, longest work on the window's thread").arg(whose),
                       shownMs,
                       std::nullopt,
                       50.0,
                       QStringLiteral("ms"),
                       {}});
    for (const double share : {1.0, 0.5, 0.2, 0.05, 0.02, 0.01, 0.005, 0.001}) {
        const double ms = panMs(span, speed, acceleration, share);
        metrics.push_back({QStringLiteral("%1: two charts, %2 of an hour visible").arg(whose).arg(share), ms,
                           std::nullopt, frameMs, QStringLiteral("ms"),
                           QStringLiteral("%1 frames/s").arg(1000 / ms, 0, 'f', 0)});
    }
}

} // namespace

int main(int argc, char **argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication::setPalette(lightPalette());
    std::vector<Measurement> metrics;
    for (const int robots : {1, 2})
        measure(exampleScene({.frames = samples, .robots = robots}), robots, metrics);
    QTextStream(stdout) << metricsTable(metrics);
    return std::all_of(metrics.begin(), metrics.end(),
                       [](const Measurement &metric) { return metric.isMet(); })
               ? 0
               : 1;
}
