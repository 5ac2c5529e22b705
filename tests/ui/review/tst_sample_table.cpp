// SPDX-License-Identifier: GPL-3.0-or-later
// Every sample of a run as a table: the profile's own numbers, the present time, columns, copies.
#include "ui/review/internal/sample_table.h"

#include "core/analysis/quantity_curve.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/timeline.h"
#include "ui/review/internal/sample_model.h"
#include "ui/review/review_desk.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMenu>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

class TestSampleTable : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        m_scene = exampleScene({.frames = 90, .robots = 2});
    }
    void init()
    {
        QSettings().clear();
        m_timeline = std::make_unique<Timeline>();
        m_timeline->setFrameTimes(m_scene->frameTimes());
        m_card = std::make_unique<SampleTable>(*m_timeline);
        m_card->resize(800, 300);
        m_card->setScene(m_scene);
        m_card->show();
        QVERIFY(QTest::qWaitForWindowActive(m_card.get()));
        m_table = named<QTableView>(*m_card, "Samples of the run");
    }
    void cleanup()
    {
        m_card.reset();
        m_timeline.reset();
    }

    void hasTheNumbersOfTheProfile()
    {
        SampleModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setRun(m_scene, 1);
        const Profile &profile = *model.profile();
        QCOMPARE(model.rowCount(), int(profile.samples.size()));
        const auto headings = headingsOf(profile);
        for (const int row : {10, 40, 70}) {
            const auto i = std::size_t(row);
            const ProfilePoint &point = profile.points[i];
            QVERIFY(point.valid);
            const auto near = [&](SampleColumn column, double value) {
                const double half = 0.5 * std::pow(10, -decimals(text(model, row, column))) + 1e-9;
                return std::abs(number(model, row, column) - value) <= half;
            };
            QVERIFY(near(SampleColumn::Time, toSeconds(profile.samples[i].time)));
            QVERIFY(near(SampleColumn::PositionX, 1000 * point.position.x()));
            QVERIFY(near(SampleColumn::SigmaY, 1000 * point.sigmaYM));
            QVERIFY(near(SampleColumn::VelocityX, point.velocity.x()));
            QVERIFY(near(SampleColumn::SigmaSpeed, point.sigmaSpeedMps));
            QVERIFY(near(SampleColumn::Acceleration, point.accelMps2));
            QVERIFY(near(SampleColumn::Heading, headings[i]->radians * 180 / std::numbers::pi));
            QVERIFY(near(SampleColumn::MeasuredY, 1000 * profile.samples[i].position->y()));
        }
        QCOMPARE(decimals(text(model, 10, SampleColumn::PositionX)), 1);
        QCOMPARE(decimals(text(model, 10, SampleColumn::Speed)), 3);
    }

    /// A spike says why it is one.
    void spikesHaveTheirReason()
    {
        SampleModel model;
        model.setRun(m_scene, 0);
        const Spike &spike = model.profile()->spikes.front();
        QVERIFY(!text(model, int(spike.sampleIndex), SampleColumn::Flags).isEmpty());
        QVERIFY(text(model, int(spike.sampleIndex) + 5, SampleColumn::Flags).isEmpty());
    }

    void followsTheTimeAndGoesThere()
    {
        m_timeline->setCurrentFrame(30);
        QCOMPARE(m_table->currentIndex().row(), 30);
        QTest::keyClick(m_table, Qt::Key_Down);
        QCOMPARE(m_timeline->currentFrame(), qint64(31));
        QCOMPARE(m_table->currentIndex().row(), 31);
        m_table->setFocus();
        m_table->selectRow(10);
        QTest::keyClick(m_table, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(selected(), 2);
        m_timeline->setCurrentFrame(60); // several selected rows stay
        QCOMPARE(selected(), 2);
        QCOMPARE(m_table->currentIndex().row(), 60);
    }

    void copiesSelectedRowsOrAll()
    {
        m_table->setFocus();
        m_table->selectRow(10);
        QTest::keyClick(m_table, Qt::Key_Down, Qt::ShiftModifier);
        QTest::keyClick(m_table, Qt::Key_C, Qt::ControlModifier);
        QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(3));
        QVERIFY2(
            lines.front().startsWith(QStringLiteral("Time (s)\tx (mm)\ty (mm)\tSpeed (m/s)\t± Speed (m/s)")),
            qPrintable(lines.front()));
        const Profile &profile = m_scene->robots[0].analysis->profile;
        const double x = QLocale().toDouble(lines.at(2).split(u'\t').at(1));
        QVERIFY(std::abs(x - 1000 * profile.points[11].position.x()) < 1e-5);
        m_table->clearSelection();
        m_table->selectRow(20);
        QTest::keyClick(m_table, Qt::Key_C, Qt::ControlModifier);
        lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(profile.samples.size() + 1));
    }

    void columnsAndRobotAreChosen()
    {
        const int column = int(SampleColumn::TurnRate);
        QVERIFY(m_table->isColumnHidden(column));
        for (QAction *each : m_card->findChild<QMenu *>()->actions())
            if (each->text() == QStringLiteral("Turn rate (°/s)"))
                each->trigger();
        QVERIFY(!m_table->isColumnHidden(column));
        const SampleTable again(*m_timeline);
        QVERIFY(!named<QTableView>(again, "Samples of the run")->isColumnHidden(column));
        auto *robots = named<QComboBox>(*m_card, "Robot");
        QVERIFY(robots->isVisible());
        const QString before = m_table->model()->index(40, int(SampleColumn::PositionX)).data().toString();
        robots->setCurrentIndex(1);
        QVERIFY(m_table->model()->index(40, int(SampleColumn::PositionX)).data().toString() != before);
    }

    /// It is a dock that is hidden until it is wanted, and computes nothing until then.
    void isADockOfReview()
    {
        ReviewDesk desk(*m_timeline);
        desk.resize(1000, 700);
        desk.setScene(m_scene);
        desk.show();
        const auto *table = named<QTableView>(desk, "Samples of the run");
        QVERIFY(!table->isVisible());
        QCOMPARE(table->model()->rowCount(), 0);
        QAction *shown = nullptr;
        for (QAction *each : desk.dockActions())
            if (each->text() == QLatin1String("Data"))
                shown = each;
        QVERIFY(shown && !shown->isChecked());
        m_timeline->setCurrentFrame(70);
        shown->trigger();
        QTRY_VERIFY(table->isVisible());
        QVERIFY(!table->visibleRegion().isEmpty());
        QCOMPARE(table->model()->rowCount(), 90);
        // the row of the present time can be seen from the beginning, and however high the dock is
        for (const int height : {700, 560, 800}) {
            desk.resize(1000, height);
            QCoreApplication::processEvents();
            QTRY_VERIFY(
                table->viewport()->rect().contains(table->visualRect(table->currentIndex()).center()));
            QCOMPARE(table->currentIndex().row(), 70);
        }
        desk.resetLayout();
        QVERIFY(!table->isVisible());
    }

    /// An hour of samples: beside other tests, six times the 50 ms that it may take.
    void anHour()
    {
        auto scene = std::make_shared<TrialScene>(*m_scene);
        Profile &profile = scene->robots[0].analysis->profile;
        const auto samples = profile.samples;
        const auto points = profile.points;
        profile.samples.clear();
        profile.points.clear();
        for (int i = 0; i < 1200; ++i)
            for (std::size_t j = 0; j < samples.size(); ++j) {
                profile.samples.push_back(samples[j]);
                profile.samples.back().time += i * std::chrono::seconds(3);
                profile.points.push_back(points[j]);
            }
        QElapsedTimer clock;
        clock.start();
        m_card->setScene(scene);
        const double ms = double(clock.nsecsElapsed()) / 1e6;
        qInfo("%d samples: %.1f ms", m_table->model()->rowCount(), ms);
        QCOMPARE(m_table->model()->rowCount(), 108'000);
        QVERIFY(ms < 300 * slowness);
    }

private:
    static QString text(const SampleModel &model, int row, SampleColumn column)
    {
        return model.index(row, int(column)).data().toString();
    }
    static double number(const SampleModel &model, int row, SampleColumn column)
    {
        return QLocale().toDouble(text(model, row, column));
    }
    static int decimals(const QString &text)
    {
        const qsizetype point = text.indexOf(QLocale().decimalPoint());
        return point < 0 ? 0 : int(text.size() - point - 1);
    }
    int selected() const { return int(m_table->selectionModel()->selectedRows(0).size()); }

    TrialScenePtr m_scene;
    std::unique_ptr<Timeline> m_timeline;
    std::unique_ptr<SampleTable> m_card;
    QTableView *m_table = nullptr;
};

ODOGRAPH_TEST(TestSampleTable, QApplication)
#include "tst_sample_table.moc"
