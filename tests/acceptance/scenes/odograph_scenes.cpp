// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the accuracy of the program on simulated scenes with known truth, through the command line.
#include "tests/acceptance/scenes/scene_report.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <cstdio>

using namespace odo::test;

namespace {

void print(const QString &text)
{
    std::fputs(qPrintable(text + u'\n'), stdout);
    std::fflush(stdout);
}

struct Order
{
    QStringList scenes, seeds;
    QString folder, work, program, json;
    double markerErrorPx = 0;
    bool renderOnly = false;
};

Order orderFrom(const QCoreApplication &app)
{
    QStringList known;
    for (const std::string &name : allSceneNames())
        known << QString::fromStdString(name);
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Scenes: ") + known.join(u' '));
    parser.addHelpOption();
    const auto option = [&](const char *name, const char *text, const QString &standard) {
        const QString itsName = QString::fromLatin1(name);
        parser.addOption({itsName, QString::fromLatin1(text), QStringLiteral("VALUE"), standard});
    };
    option("scenes", "Scenes by name, with commas; all of them.", known.join(u','));
    option("seeds", "Seeds, with commas.", QStringLiteral("1,2,3"));
    option("folder", "Where the media are kept; those of an earlier run are used again.",
           QStringLiteral("scenes"));
    option("work", "Where the projects and answers go; by default answers/ in the media's folder.",
           QString());
    option("program", "The odograph to measure.",
           qEnvironmentVariable("ODOGRAPH_PROGRAM", QStringLiteral("odograph")));
    option("marker-error", "Sigma of a picked marker's coordinate, in pixels.", QStringLiteral("0.3"));
    option("json", "A file for the figures.", QString());
    parser.addOption(
        {QStringLiteral("render-only"), QStringLiteral("Provide the media and measure nothing.")});
    parser.process(app);
    const auto list = [&](const char *name) {
        return parser.value(QString::fromLatin1(name)).split(u',', Qt::SkipEmptyParts);
    };
    Order order{list("scenes"),
                list("seeds"),
                parser.value(QStringLiteral("folder")),
                parser.value(QStringLiteral("work")),
                parser.value(QStringLiteral("program")),
                parser.value(QStringLiteral("json")),
                parser.value(QStringLiteral("marker-error")).toDouble(),
                parser.isSet(QStringLiteral("render-only"))};
    if (order.work.isEmpty())
        order.work = order.folder + QStringLiteral("/answers");
    for (const QString &scene : order.scenes) {
        if (!known.contains(scene)) {
            std::fprintf(stderr, "'%s' is no scene; choose from: %s\n", qPrintable(scene),
                         qPrintable(known.join(u' ')));
            parser.showHelp(2);
        }
    }
    return order;
}

/// The bars' table, and the file where one is asked for. The exit status.
int report(const Order &order, const std::vector<MeasuredScene> &measured)
{
    const std::vector<BarResult> bars = judge(measured);
    print(u'\n' + barsTable(bars));
    if (!order.json.isEmpty()) {
        QFile file(order.json);
        if (!file.open(QIODevice::WriteOnly) ||
            file.write(QJsonDocument(reportJson(measured, bars)).toJson()) < 0) {
            std::fprintf(stderr, "%s: %s\n", qPrintable(order.json), qPrintable(file.errorString()));
            return 1;
        }
    }
    return std::all_of(bars.begin(), bars.end(), [](const BarResult &bar) { return bar.isMet(); }) ? 0 : 1;
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication app(argc, argv);
    const Order order = orderFrom(app);
    std::vector<MeasuredScene> measured;
    if (!order.renderOnly)
        print(tableHead());
    for (const QString &name : order.scenes) {
        for (const QString &seed : order.seeds) {
            const AccuracyScene scene = makeScene(name.toStdString(), seed.toUInt());
            const std::string own = scene.name + "-" + std::to_string(scene.seed);
            const auto media = provideMedia(scene, std::filesystem::path(order.folder.toStdString()) / own);
            if (!media) {
                std::fprintf(stderr, "%s\n", media.error().message().c_str());
                return 1;
            }
            if (order.renderOnly)
                continue;
            measured.push_back(measureScene(
                scene, *media,
                {order.program, std::filesystem::path(order.work.toStdString()) / own, order.markerErrorPx}));
            print(tableLine(measured.back()));
        }
    }
    return order.renderOnly ? 0 : report(order, measured);
}
