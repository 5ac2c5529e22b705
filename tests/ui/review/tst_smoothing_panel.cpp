// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of smoothing: computed only while it is shown, its words, its plot and what the mouse reads.
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/timeline.h"
#include "ui/review/internal/smoothing_panel.h"
#include "ui/review/review_desk.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>
#include <QToolTip>
#include <cmath>

using namespace odo;

namespace {

/// The residuals of noise of 2 mm, and of a motion below 3 Hz.
CutoffAnalysis analysisOfNoise()
{
    CutoffAnalysis analysis;
    for (int i = 0; i < 40; ++i) {
        const double hz = 0.5 + i * 0.5, noise = 0.002 * std::sqrt(1 - hz / 25);
        analysis.residuals.push_back({hz, std::hypot(noise, hz < 3 ? 0.05 * (3 - hz) : 0), 0.0001});
    }
    analysis.framesPerSecond = 50;
    analysis.noiseM = CurveValue{0.002, 0.0001};
    analysis.chosenHz = CurveValue{3.2, 0.3};
    analysis.automaticHz = CurveValue{10, 0.5};
    analysis.automaticResidualM = CurveValue{0.0017, 0.00005};
    analysis.statedNoiseM = 0.0021;
    return analysis;
}

/// But for the blending of edges.
bool isLike(const QColor &a, const QColor &b)
{
    constexpr int most = 60;
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <
           most;
}

} // namespace

class TestSmoothingPanel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        QLocale::setDefault(QLocale::c());
    }

    void theWords()
    {
        const QString words =
            smoothingText({"Robot 1", analysisOfNoise()}).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
        QCOMPARE(words, QStringLiteral(
                            "Robot 1: smoothed automatically like a filter with a cut-off of 10.0 ±0.5 Hz; "
                            "what it takes away is 1.70 ±0.05 mm of each coordinate\n"
                            "Noise of the measurements by their residuals: 2.00 ±0.10 mm; stated: 2.1 mm\n"
                            "Cut-off by residual analysis: 3.2 ±0.3 Hz"));
        QCOMPARE(smoothingText({"Robot 1", {}}), QStringLiteral("Robot 1: measured for less than a second"));
        CutoffAnalysis none = analysisOfNoise();
        none.noiseM = none.chosenHz = none.automaticHz = std::nullopt;
        const QString without = smoothingText({"Robot 1", none});
        QVERIFY2(without.startsWith(QStringLiteral("Robot 1: the smoother states no cut-off\n")),
                 qPrintable(without));
        QVERIFY(without.contains(QStringLiteral("gives no cut-off")));
    }

    void thePlot()
    {
        ResidualPlot plot(analysisOfNoise());
        plot.setPalette(lightPalette());
        plot.resize(600, 140);
        const QImage image = plot.grab().toImage();
        const QColor blue = seriesColour(0, lightPalette());
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                pixels += isLike(image.pixelColor(x, y), blue);
        QVERIFY2(pixels > 300, qPrintable(QString::number(pixels)));
        // 58 px at the left, 10 at the right: 10 Hz of 20 is in the middle
        QHelpEvent help(QEvent::ToolTip, {58 + 266, 60}, plot.mapToGlobal(QPoint(58 + 266, 60)));
        QApplication::sendEvent(&plot, &help);
        QVERIFY2(QToolTip::text()
                     .replace(QChar(QChar::Nbsp), QLatin1Char(' '))
                     .startsWith(QStringLiteral("a filter of 10.0 Hz takes away 1.5")),
                 qPrintable(QToolTip::text()));
        ResidualPlot none({});
        none.resize(100, 60);
        none.grab(); // nothing to paint, and nothing happens
    }

    void computedOnlyWhileShown()
    {
        Timeline timeline;
        ReviewDesk desk(timeline);
        desk.resize(1200, 800);
        desk.show();
        desk.setScene(exampleScene({.frames = 240}));
        auto *panel = desk.findChild<SmoothingPanel *>();
        auto *dock = desk.findChild<QDockWidget *>(QStringLiteral("smoothingDock"));
        QVERIFY(panel && dock && !dock->isVisible());
        QVERIFY(panel->isSettled());
        QVERIFY(panel->findChildren<ResidualPlot *>().isEmpty());
        QSignalSpy settled(panel, &SmoothingPanel::settled);
        dock->toggleViewAction()->trigger();
        QTRY_COMPARE(settled.count(), 1);
        QCOMPARE(panel->findChildren<ResidualPlot *>().size(), 1);
        QVERIFY2(panel->accessibleDescription().contains(QStringLiteral("Noise of the measurements")),
                 qPrintable(panel->accessibleDescription()));
        desk.setScene(nullptr);
        QTRY_VERIFY(test::says(*panel, "No curve yet: track the trial."));
    }
};

ODOGRAPH_TEST(TestSmoothingPanel, QApplication)
#include "tst_smoothing_panel.moc"
