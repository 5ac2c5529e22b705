// SPDX-License-Identifier: GPL-3.0-or-later
// Records, tracks and maps two live cameras as Record mode does, and tells what it cost and what was lost.
#include "core/base/percentile.h"
#include "tests/benchmark/live/gige_servers.h"
#include "tests/benchmark/live/jpeg_camera.h"
#include "tests/benchmark/live/live_project.h"
#include "tests/benchmark/live/live_rig.h"
#include "tests/benchmark/live/live_scene_setup.h"
#include "tests/support/said_error.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <cstdio>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int hdWidthPx = 1280, fullHdWidthPx = 1920;
constexpr double gigeRate = 60, webcamRate = 30;
constexpr double mostLatencyMs = 100, mostCoresOfWebcams = 0.25, mostCoresOfAnyLook = 0.3;
/// What is kept of each picture until the run ends (its observation, its times, its place in the file's
/// index) makes 2 MB of it at 120 pictures a second.
constexpr double mostGrowthMbPerMinute = 4;

void print(const QString &text)
{
    std::fputs(qPrintable(text + u'\n'), stdout);
    std::fflush(stdout);
}

/// How a measurement is set up.
struct Setup
{
    QString name;
    RunningCameras::Open open = openCamera;
    std::array<std::string, 2> uris;
    double seconds = 0;
    LiveWindow window = LiveWindow::Shown;
    LiveRobot robot = LiveRobot::Coloured;
};

Result<LiveMeasurement> measure(const Setup &setup, const SimulatedScene &scene, const QString &folder,
                                GigeServers *servers)
{
    const QTemporaryDir scratch(folder + QStringLiteral("/live-XXXXXX"));
    const auto project = makeLiveProject(scratch.filePath(QStringLiteral("live.odo")).toStdString(), scene,
                                         setup.robot == LiveRobot::Coloured);
    if (!project)
        return tl::unexpected(project.error());
    LiveRig rig(**project, setup.open, setup.uris, setup.window);
    if (const auto ready = rig.waitForCameras(); !ready)
        return tl::unexpected(ready.error());
    std::size_t turn = 0;
    auto measured = rig.record(setup.seconds, [&] {
        if (servers)
            servers->skip(turn++ % 2);
    });
    for (std::size_t v = 0; measured && servers && v < measured->views.size(); ++v)
        measured->views[v].skipped = servers->skipped(v);
    return measured;
}

Result<LiveMeasurement> measureGige(int widthPx, double framesPerSecond, double seconds,
                                    const QString &folder)
{
    GigeServers servers(widthPx, framesPerSecond);
    if (!servers.isReady())
        return test::saidFailure(ErrorCode::Unavailable, "the simulated cameras", "they do not start",
                                 "see whether another program has their addresses");
    Setup setup;
    for (std::size_t i = 0; i < setup.uris.size(); ++i)
        setup.uris[i] =
            std::string("aravis:") + gigeAddresses[i] + "?rate=" + std::to_string(framesPerSecond);
    setup.seconds = seconds;
    return measure(setup, liveScene(widthPx, framesPerSecond).scene, folder, &servers);
}

Result<LiveMeasurement> measureWebcams(LiveWindow window, LiveRobot robot, double seconds,
                                       const QString &folder)
{
    const LiveScene live = liveScene(hdWidthPx, webcamRate, robot);
    std::map<std::string, JpegFrames> frames;
    Setup setup;
    setup.uris = {"webcam A", "webcam B"};
    for (std::size_t i = 0; i < setup.uris.size(); ++i) {
        auto coded = codeFrames(live.scene, static_cast<int>(i), live.firstFrame);
        if (!coded)
            return tl::unexpected(coded.error());
        frames[setup.uris[i]] = std::move(*coded);
    }
    setup.open = [&frames](const std::string &uri) -> Result<std::unique_ptr<CameraSource>> {
        return openJpegCamera(uri, frames.at(uri), webcamRate);
    };
    setup.seconds = seconds;
    setup.window = window;
    setup.robot = robot;
    return measure(setup, live.scene, folder, nullptr);
}

/// Every figure of a run; demands: what is asked of this one.
struct Demands
{
    bool complete = false, latency = false, memory = false;
    std::optional<double> cores;
};

std::vector<Measurement> metricsOf(const QString &name, const LiveMeasurement &measured,
                                   const Demands &demands)
{
    std::vector<Measurement> metrics;
    const auto add = [&](const QString &what, double value, const QString &unit, const QString &detail) {
        metrics.push_back({name + QStringLiteral(": ") + what, value, {}, {}, unit, detail});
        return &metrics.back();
    };
    std::uint64_t recorded = 0, byUs = 0, uncounted = 0;
    QStringList wire;
    for (const LiveViewStatistics &view : measured.views) {
        recorded += view.recorded;
        byUs += view.lostByUs + (view.recorded - std::min(view.recorded, view.played));
        const auto apart = static_cast<std::int64_t>(view.spanned) -
                           static_cast<std::int64_t>(view.recorded + view.lostOnWire + view.lostByUs);
        uncounted += static_cast<std::uint64_t>(std::abs(apart));
        wire << QStringLiteral("%1 of %2 made to be lost").arg(view.lostOnWire).arg(view.skipped);
    }
    Measurement *metric = add(QStringLiteral("frames lost by us"), double(byUs), {},
                              QStringLiteral("%1 recorded in %2 s, %3 MB")
                                  .arg(recorded)
                                  .arg(measured.seconds, 0, 'f', 0)
                                  .arg(double(measured.bytes) / 1e6, 0, 'f', 0));
    if (demands.complete)
        metric->atMost = 0;
    metric = add(QStringLiteral("frames lost and not counted"), double(uncounted), {},
                 QStringLiteral("on the wire ") + wire.join(QStringLiteral(", ")));
    if (demands.complete)
        metric->atMost = 0;
    metric = add(QStringLiteral("exposure to map, 99 %"), percentile(measured.latenciesMs, 99),
                 QStringLiteral(" ms"),
                 QStringLiteral("median %1 ms, longest %2 ms, %3 positions, %4 pictures not tracked")
                     .arg(percentile(measured.latenciesMs, 50), 0, 'f', 1)
                     .arg(percentile(measured.latenciesMs, 100), 0, 'f', 1)
                     .arg(measured.positions)
                     .arg(measured.notTracked));
    if (demands.latency)
        metric->atMost = mostLatencyMs;
    metric =
        add(QStringLiteral("processor"), measured.cores, QStringLiteral(" cores"),
            QStringLiteral("longest in the window's thread %1 ms").arg(measured.longestBusyMs, 0, 'f', 1));
    metric->atMost = demands.cores;
    if (measured.memoryPerMinuteMb() != 0) {
        metric = add(QStringLiteral("memory grows in a minute"), measured.memoryPerMinuteMb(),
                     QStringLiteral(" MB"),
                     QStringLiteral("%1 MB at first, %2 MB at last")
                         .arg(measured.memory.front().second, 0, 'f', 0)
                         .arg(measured.memory.back().second, 0, 'f', 0));
        if (demands.memory)
            metric->atMost = mostGrowthMbPerMinute;
    }
    return metrics;
}

struct Order
{
    QString folder, json;
    double seconds = 600, shortS = 30;
    QStringList parts;
};

Order orderFrom(const QApplication &app)
{
    QCommandLineParser parser;
    parser.addHelpOption();
    const auto option = [&](const char *name, const char *text, const QString &standard) {
        parser.addOption(
            {QString::fromLatin1(name), QString::fromLatin1(text), QStringLiteral("VALUE"), standard});
    };
    option("folder", "Where is recorded; otherwise in the folder for temporary files.", QDir::tempPath());
    option("json", "A file for the figures.", QString());
    option("seconds", "How long the two cameras of 60 frames/s are recorded.", QStringLiteral("600"));
    option("short", "How long each of the others is.", QStringLiteral("30"));
    option("parts", "Which are measured, of gige, webcams, any-look, full-hd.",
           QStringLiteral("gige,webcams,any-look,full-hd"));
    parser.process(app);
    const auto value = [&](const char *name) { return parser.value(QString::fromLatin1(name)); };
    return {value("folder"), value("json"), std::max(5.0, value("seconds").toDouble()),
            std::max(5.0, value("short").toDouble()), value("parts").split(u',')};
}

/// The parts in their order; printed as they come. False where one could not be measured.
bool measureAll(const Order &order, std::vector<Measurement> &metrics)
{
    const auto take = [&](const QString &name, const Result<LiveMeasurement> &measured,
                          const Demands &demands) {
        if (!measured) {
            std::fprintf(stderr, "odograph_live_benchmark: %s\n", measured.error().message().c_str());
            return false;
        }
        const std::vector<Measurement> own = metricsOf(name, *measured, demands);
        print(metricsTable(own));
        metrics.insert(metrics.end(), own.begin(), own.end());
        return true;
    };
    if (order.parts.contains(QStringLiteral("gige")) &&
        !take(QStringLiteral("GigE, 1280x720, 60/s"),
              measureGige(hdWidthPx, gigeRate, order.seconds, order.folder), {true, true, true, {}}))
        return false;
    for (const LiveWindow window : {LiveWindow::Hidden, LiveWindow::Shown}) {
        const bool isShown = window == LiveWindow::Shown;
        const QString name =
            isShown ? QStringLiteral("MJPEG, 1280x720, 30/s") : QStringLiteral("MJPEG, no window");
        if (order.parts.contains(QStringLiteral("webcams")) &&
            !take(name, measureWebcams(window, LiveRobot::Coloured, order.shortS, order.folder),
                  {true, true, false, isShown ? std::nullopt : std::optional(mostCoresOfWebcams)}))
            return false;
    }
    if (order.parts.contains(QStringLiteral("any-look")) &&
        !take(QStringLiteral("MJPEG, no window, a robot of any look"),
              measureWebcams(LiveWindow::Hidden, LiveRobot::AnyLook, order.shortS, order.folder),
              {true, true, false, mostCoresOfAnyLook}))
        return false;
    constexpr std::array rates{30.0, 40.0, 50.0, 60.0};
    return !order.parts.contains(QStringLiteral("full-hd")) || std::ranges::all_of(rates, [&](double rate) {
        return take(QStringLiteral("GigE, 1920x1080, %1/s").arg(rate),
                    measureGige(fullHdWidthPx, rate, order.shortS, order.folder), {});
    });
}

} // namespace

int main(int argc, char *argv[])
{
    if (argc == 4 && std::string_view(argv[1]) == "--serve")
        return serveGigeCameras(std::atoi(argv[2]), std::atof(argv[3]));
    qputenv("QT_QPA_PLATFORM", "offscreen"); // the raster paints the same, with a display or without
    const WatchedApplication app(argc, argv);
    const Order order = orderFrom(app);
    std::vector<Measurement> metrics;
    if (!measureAll(order, metrics))
        return 1;
    if (!order.json.isEmpty()) {
        QFile file(order.json);
        const QJsonObject json{{QStringLiteral("figures"), metricsJson(metrics)}};
        if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(json).toJson()) < 0) {
            std::fprintf(stderr, "odograph_live_benchmark: %s: %s\n", qPrintable(order.json),
                         qPrintable(file.errorString()));
            return 1;
        }
    }
    return std::ranges::all_of(metrics, &Measurement::isMet) ? 0 : 1;
}
