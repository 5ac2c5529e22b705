// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the speed of decoding and tracking beside libavcodec's and OpenCV's, and the accuracy beside it.
#include "tests/acceptance/scenes/scene_report.h"
#include "tests/benchmark/lens_rounds.h"
#include "tests/benchmark/look_rounds.h"
#include "tests/benchmark/speed_rounds.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <cstdio>

using namespace odo;
using namespace odo::test;

namespace {

struct Order
{
    QString folder, json, scenes, program;
    int rounds = 5;
    double durationS = 10;
    bool calibrationOnly = false;
};

Order orderFrom(const QCoreApplication &app)
{
    QCommandLineParser parser;
    parser.addHelpOption();
    const auto option = [&](const char *name, const char *text, const QString &standard) {
        parser.addOption(
            {QString::fromLatin1(name), QString::fromLatin1(text), QStringLiteral("VALUE"), standard});
    };
    option("folder", "Where the clips are kept and used again; otherwise they are rendered anew.", QString());
    option("json", "A file for the figures.", QString());
    option("rounds", "How often everything is run.", QStringLiteral("5"));
    option("seconds", "Length of the clips.", QStringLiteral("10"));
    option("scenes", "Measures the accuracy on the scenes of odograph_scenes as well; their media's folder.",
           QString());
    option("program", "The odograph to measure there.",
           qEnvironmentVariable("ODOGRAPH_PROGRAM", QStringLiteral("odograph")));
    parser.addOption({QStringLiteral("calibration"), QStringLiteral("Measures the calibration alone.")});
    parser.process(app);
    const auto value = [&](const char *name) { return parser.value(QString::fromLatin1(name)); };
    return {value("folder"),
            value("json"),
            value("scenes"),
            value("program"),
            std::max(1, value("rounds").toInt()),
            std::max(2.0, value("seconds").toDouble()),
            parser.isSet(QStringLiteral("calibration"))};
}

void print(const QString &text)
{
    std::fputs(qPrintable(text + u'\n'), stdout);
    std::fflush(stdout);
}

int fail(const QString &why)
{
    std::fprintf(stderr, "odograph_benchmark: %s\n", qPrintable(why));
    return 1;
}

/// Every scene of odograph_scenes with its three seeds; media that are there are used again.
Result<std::vector<MeasuredScene>> measureScenes(const Order &order)
{
    std::vector<MeasuredScene> measured;
    print(tableHead());
    for (const std::string &name : allSceneNames()) {
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const AccuracyScene scene = makeScene(name, seed);
            const std::filesystem::path folder = order.scenes.toStdString();
            const std::string own = name + "-" + std::to_string(seed);
            const auto media = provideMedia(scene, folder / own);
            if (!media)
                return tl::unexpected(media.error());
            measured.push_back(measureScene(scene, *media, {order.program, folder / "answers" / own}));
            print(tableLine(measured.back()));
        }
    }
    return measured;
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication app(argc, argv);
    const Order order = orderFrom(app);
    const std::vector<Measurement> calibration = measureCalibration(order.rounds);
    if (calibration.empty())
        return fail(QStringLiteral("the boards cannot be calibrated from"));
    if (order.calibrationOnly) {
        print(metricsTable(calibration));
        return std::ranges::all_of(calibration, &Measurement::isMet) ? 0 : 1;
    }
    const QTemporaryDir scratch;
    const QString folder = order.folder.isEmpty() ? scratch.path() : order.folder;
    std::filesystem::create_directories(folder.toStdString());
    const auto clips = provideClips(folder.toStdString(), order.durationS);
    if (!clips)
        return fail(QString::fromStdString(clips.error().message()));

    std::vector<Measurement> metrics = measureSpeed(*clips, order.rounds);
    if (metrics.empty())
        return fail(QStringLiteral("the clips in %1 cannot be read; remove them").arg(folder));
    const auto looks = measureLooks(folder.toStdString(), order.durationS, order.rounds);
    if (!looks)
        return fail(QString::fromStdString(looks.error().message()));
    metrics.insert(metrics.end(), looks->begin(), looks->end());
    metrics.push_back(measureColdSearch(clips->h264));
    metrics.insert(metrics.end(), calibration.begin(), calibration.end());
    const std::vector<Measurement> centres = measureCentres(*clips);
    metrics.insert(metrics.end(), centres.begin(), centres.end());
    print(metricsTable(metrics));
    QJsonObject json{{QStringLiteral("figures"), metricsJson(metrics)}};
    bool met =
        std::all_of(metrics.begin(), metrics.end(), [](const Measurement &metric) { return metric.isMet(); });

    if (!order.scenes.isEmpty()) {
        const auto measured = measureScenes(order);
        if (!measured)
            return fail(QString::fromStdString(measured.error().message()));
        const std::vector<BarResult> bars = judge(*measured);
        print(u'\n' + barsTable(bars));
        json.insert(QStringLiteral("accuracy"), reportJson(*measured, bars));
        met &= std::all_of(bars.begin(), bars.end(), [](const BarResult &bar) { return bar.isMet(); });
    }
    if (!order.json.isEmpty()) {
        QFile file(order.json);
        if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(json).toJson()) < 0)
            return fail(order.json + QStringLiteral(": ") + file.errorString());
    }
    return met ? 0 : 1;
}
