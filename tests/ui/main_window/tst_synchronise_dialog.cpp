// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/synchronise_dialog.h"

#include "tests/support/registered_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <cmath>

using namespace odo;

namespace {

/// A second of silence with one loud sample.
SoundTrack clapAt(double timeS, std::int16_t loudness)
{
    SoundTrack track;
    track.samples.resize(std::size_t(SoundTrack::rate));
    track.samples[std::size_t(timeS * SoundTrack::rate)] = loudness;
    return track;
}

RecordingRecord viewOf(const char *camera, int position, const char *method, double offsetS)
{
    RecordingRecord view;
    view.cameraName = camera;
    view.position = position;
    view.syncMethod = method;
    view.startOffsetS = offsetS;
    return view;
}

} // namespace

class TestSynchroniseDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void peaksAreTheLoudestOfEachMillisecond()
    {
        const SoundPeaks sound = peaksOf(clapAt(0.25, -16000));
        QCOMPARE(sound.peaks.size(), std::size_t(1000));
        for (std::size_t ms = 0; ms < 1000; ++ms)
            QCOMPARE(sound.peaks[ms], ms == 250 ? 1.0F : 0.0F); // of whatever loudness
        QVERIFY(peaksOf({}).peaks.empty());
    }

    void draggedByHandTheSecondSoundMoves()
    {
        SoundChart chart;
        chart.resize(640, 200);
        chart.show();
        chart.setSounds({peaksOf(clapAt(0.25, 20000)), peaksOf(clapAt(0.65, 9000))});
        QCOMPARE(chart.span().wholeLow(), 0.0);
        QCOMPARE(chart.span().wholeHigh(), 1.0);
        QSignalSpy dragged(&chart, &SoundChart::offsetDragged);
        const ChartPlot plot = chart.plot();
        const auto xOf = [&](double timeS) { return plot.at(timeS, 0).toPoint(); };
        QTest::mousePress(chart.viewport(), Qt::LeftButton, {}, xOf(0.65));
        QTest::mouseMove(chart.viewport(), xOf(0.4));
        QTest::mouseMove(chart.viewport(), xOf(0.25));
        QTest::mouseRelease(chart.viewport(), Qt::LeftButton, {}, xOf(0.25));
        QVERIFY(!dragged.isEmpty());
        const double pixelS = 1 / plot.rect.width();
        QVERIFY2(std::abs(chart.offsetS() - -0.4) <= 2 * pixelS,
                 qPrintable(QString::number(chart.offsetS())));
    }

    void itProposesToFindTheOffsetAgain()
    {
        SynchroniseDialog dialog(QStringLiteral("run"), {viewOf("A", 0, "", 0), viewOf("B", 1, "told", 0.25)},
                                 {"nowhere.mp4", "nowhere.mp4"});
        const auto words = [&](const char *part) {
            const auto labels = dialog.findChildren<QLabel *>();
            return std::ranges::any_of(
                labels, [&](auto *label) { return label->text().contains(QString::fromUtf8(part)); });
        };
        QVERIFY(words("started 250.0 ms later, set by hand"));
        QCOMPARE(dialog.steps().size(), std::size_t(1));
        QVERIFY(dialog.steps().front().how == SyncBy::Automatic);
        auto *how = dialog.findChild<QComboBox *>();
        QCOMPARE(how->findData(int(SyncBy::Kept)), -1);
        how->setCurrentIndex(how->findData(int(SyncBy::Given)));
        QCOMPARE(dialog.findChild<QDoubleSpinBox *>()->value(), 0.25);
        QCOMPARE(dialog.steps().front().offsetS, 0.25);
        QTRY_VERIFY(words("There is no sound in both views to compare."));
    }

    /// Together they keep the offset; one alone sets it, as the fields say then.
    void framesSideBySideSetTheOffset()
    {
        RecordingRecord first = viewOf("A", 0, "", 0), other = viewOf("B", 1, "told", 0.5);
        for (int i = 0; i < 100; ++i) {
            first.frameTimes.push_back(std::chrono::milliseconds(40 * i));
            other.frameTimes.push_back(std::chrono::milliseconds(20 * i));
        }
        SynchroniseDialog dialog(QStringLiteral("run"), {first, other}, {"nowhere.mp4", "nowhere.mp4"});
        dialog.show();
        const auto sliders = dialog.findChildren<QSlider *>();
        QCOMPARE(sliders.size(), qsizetype(2));
        sliders[0]->setValue(50);          // at 2 s
        QCOMPARE(sliders[1]->value(), 75); // at 1.5 s of its own
        sliders[1]->setValue(50);
        QCOMPARE(sliders[0]->value(), 38); // 1.52 s, the nearest to 1.5 s
        QVERIFY(dialog.steps().front().how == SyncBy::Automatic);
        dialog.findChild<QCheckBox *>()->setChecked(false);
        sliders[1]->setFocus();
        QTest::keyClick(sliders[1], Qt::Key_Right); // 1.02 s
        QCOMPARE(sliders[0]->value(), 38);
        QVERIFY(dialog.steps().front().how == SyncBy::Given);
        QCOMPARE(dialog.steps().front().offsetS, 0.5);
        sliders[0]->setValue(40); // 1.6 s
        QCOMPARE(dialog.steps().front().offsetS, 0.58);
        QCOMPARE(sliders[1]->value(), 51);
        dialog.findChild<QDoubleSpinBox *>()->setValue(1.0); // entered: the other one follows
        QCOMPARE(sliders[1]->value(), 30);
        QVERIFY(dialog.width() <= 1024 && dialog.height() <= 600);
    }

    void ofSeveralViewsSomeMayStay()
    {
        SynchroniseDialog dialog(
            QStringLiteral("run"),
            {viewOf("A", 0, "", 0), viewOf("B", 1, "auto", 0.1), viewOf("C", 2, "open", 0)}, {});
        auto *how = dialog.findChild<QComboBox *>();
        how->setCurrentIndex(how->findData(int(SyncBy::Kept)));
        QVERIFY(dialog.steps()[0].how == SyncBy::Kept && dialog.steps()[1].how == SyncBy::Automatic);
    }
};

ODOGRAPH_TEST(TestSynchroniseDialog, QApplication)
#include "tst_synchronise_dialog.moc"
