// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a project of ten thousand trials in the window, searches it and looks at trials, and tells how long a
// person waits.
#include "core/project/project.h"
#include "tests/benchmark/metrics.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/year_project.h"
#include "ui/history/history_page.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double mostOpenMs = 1000, mostSearchMs = 100, mostTrialMs = 300, mostBusyMs = 50;

void print(const QString &text)
{
    std::fputs(qPrintable(text + u'\n'), stdout);
    std::fflush(stdout);
}

double elapsedMs(const QElapsedTimer &timer)
{
    return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

/// Until everything that belongs to what is shown is on screen.
void settle(const MainWindow &window)
{
    QEventLoop loop;
    QObject::connect(&window, &MainWindow::settled, &loop, &QEventLoop::quit);
    if (!window.isSettled())
        loop.exec();
    QApplication::processEvents();
}

/// As a person opens it: looked through in the background.
bool isOpened(MainWindow &window, const std::filesystem::path &file)
{
    QEventLoop loop;
    bool opened = false;
    QObject::connect(&window.workspace(), &Workspace::opened, &loop, [&] {
        opened = true;
        loop.quit();
    });
    QObject::connect(&window.workspace(), &Workspace::jobFailed, &loop, [&](const Error &error) {
        print(QString::fromStdString(error.message()));
        loop.quit();
    });
    window.beginOpening(file);
    loop.exec();
    return opened;
}

std::vector<double> searchMs(const MainWindow &window)
{
    auto *search = window.findChild<QLineEdit *>(QStringLiteral("search"));
    auto *table = window.findChild<QTableView *>(QStringLiteral("trials"));
    std::vector<double> times;
    for (const char *words : {"run 1234", "team 7 wet", "nobody", "class 2 final 99", "battery 50"}) {
        QString typed;
        for (const char letter : std::string_view(words)) {
            typed += QLatin1Char(letter);
            QElapsedTimer timer;
            timer.start();
            search->setText(typed);
            table->viewport()->repaint();
            times.push_back(elapsedMs(timer));
            QApplication::processEvents(); // a person types one letter in a turn
        }
    }
    search->clear();
    return times;
}

std::vector<double> trialMs(MainWindow &window, int trials)
{
    std::vector<double> times;
    for (int i = 0; i < 20; ++i) {
        const std::string name = "Run " + std::to_string(3 + (i * 7919) % (trials - 3));
        QElapsedTimer timer;
        timer.start();
        if (const auto shown = window.showTrial(name); !shown) {
            print(QString::fromStdString(shown.error().message()));
            return {};
        }
        settle(window);
        times.push_back(elapsedMs(timer));
    }
    return times;
}

/// The one in the folder, or a new one.
Result<std::filesystem::path> yearProject(const std::filesystem::path &folder, int trials)
{
    const std::filesystem::path known = folder / yearProjectName;
    if (std::filesystem::exists(known))
        return known;
    print(QStringLiteral("making a project of %1 trials…").arg(trials));
    return makeYearProject(folder, trials);
}

test::Measurement metric(const QString &name, const std::vector<double> &times, double atMost)
{
    return {name,
            *std::max_element(times.begin(), times.end()),
            std::nullopt,
            atMost,
            QStringLiteral(" ms"),
            QStringLiteral("longest of %1, median %2 ms").arg(times.size()).arg(median(times), 0, 'f', 1)};
}

std::vector<test::Measurement> measure(const std::filesystem::path &file, int trials)
{
    std::vector<test::Measurement> metrics;
    QElapsedTimer timer;
    timer.start();
    MainWindow window;
    window.show();
    QApplication::processEvents();
    BusyWatch watch;
    QStringList phases;
    double longest = 0;
    const auto endPhase = [&](const QString &name) {
        QApplication::processEvents(); // so that the watch sees the last turn
        const double busy = watch.takeLongestMs();
        phases << QStringLiteral("%1 %2").arg(name).arg(busy, 0, 'f', 1);
        longest = std::max(longest, busy);
    };
    timer.start();
    if (!isOpened(window, file))
        return {};
    settle(window);
    metrics.push_back(
        metric(QStringLiteral("open, the newest trial on screen"), {elapsedMs(timer)}, mostOpenMs));
    endPhase(QStringLiteral("opening"));
    timer.start();
    window.showMode(MainWindow::Mode::History);
    settle(window);
    metrics.push_back(metric(QStringLiteral("all trials in History"), {elapsedMs(timer)}, mostOpenMs));
    endPhase(QStringLiteral("History"));
    metrics.push_back(metric(QStringLiteral("search, each letter typed"), searchMs(window), mostSearchMs));
    endPhase(QStringLiteral("search"));
    const std::vector<double> shown = trialMs(window, trials);
    if (shown.empty())
        return {};
    metrics.push_back(metric(QStringLiteral("a trial on screen, with its frames"), shown, mostTrialMs));
    endPhase(QStringLiteral("trials"));
    for (const auto &[mode, name] : {std::pair(MainWindow::Mode::Testbed, QStringLiteral("Testbed")),
                                     std::pair(MainWindow::Mode::Compare, QStringLiteral("Compare")),
                                     std::pair(MainWindow::Mode::Record, QStringLiteral("Record"))}) {
        window.showMode(mode);
        settle(window);
        endPhase(name);
    }
    metrics.push_back({QStringLiteral("longest that the window's thread was busy (CPU)"), longest,
                       std::nullopt, mostBusyMs, QStringLiteral(" ms"), phases.join(QStringLiteral(", "))});
    return metrics;
}

} // namespace

int main(int argc, char **argv)
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    applyAppearance(app, Theme::Light); // what is drawn without the style sheet costs less
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({QStringLiteral("trials"), QStringLiteral("How many trials the project has."),
                      QStringLiteral("N"), QStringLiteral("10000")});
    parser.addOption({QStringLiteral("folder"), QStringLiteral("Where the project is made (3.6 GB)."),
                      QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("keep"),
                      QStringLiteral("Leaves the project in the folder, and uses the one that is there.")});
    parser.addOption(
        {QStringLiteral("json"), QStringLiteral("A file for the figures."), QStringLiteral("FILE")});
    parser.process(app);
    const int trials = std::max(10, parser.value(QStringLiteral("trials")).toInt());
    const bool keeps = parser.isSet(QStringLiteral("keep"));
    const QString parent =
        parser.isSet(QStringLiteral("folder")) ? parser.value(QStringLiteral("folder")) : QDir::tempPath();
    const QTemporaryDir once(parent + QStringLiteral("/year-XXXXXX"));
    const auto file = yearProject((keeps ? parent : once.path()).toStdString(), trials);
    if (!file) {
        print(QString::fromStdString(file.error().message()));
        return 1;
    }
    const std::vector<test::Measurement> metrics = measure(*file, trials);
    print(metricsTable(metrics));
    if (parser.isSet(QStringLiteral("json"))) {
        QFile json(parser.value(QStringLiteral("json")));
        const QJsonObject all{{QStringLiteral("trials"), trials},
                              {QStringLiteral("figures"), metricsJson(metrics)}};
        if (!json.open(QIODevice::WriteOnly) || json.write(QJsonDocument(all).toJson()) < 0)
            return 1;
    }
    return !metrics.empty() && std::all_of(metrics.begin(), metrics.end(),
                                           [](const test::Measurement &each) { return each.isMet(); })
               ? 0
               : 1;
}
