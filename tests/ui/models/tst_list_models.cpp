// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/example_scene.h"
#include "ui/models/camera_list_model.h"
#include "ui/models/metric_model.h"
#include "ui/models/spike_model.h"
#include "ui/models/trial_model.h"

#include <QAbstractItemModelTester>
#include <QDateTime>
#include <QSortFilterProxyModel>
#include <QTest>

using namespace odo;

namespace {

constexpr auto strict = QAbstractItemModelTester::FailureReportingMode::QtTest;

TrialRow trialRow(const char *name, std::int64_t minute, std::optional<double> topSpeed)
{
    TrialRow row;
    row.trial.name = name;
    row.trial.teamName = "Falcon";
    row.trial.date = Instant(std::chrono::minutes(minute));
    row.trial.robotNames = {"Red 2", "Blue 1"};
    row.trial.durationS = 9.84;
    row.trial.notes = "New wheels";
    if (topSpeed) {
        row.analyses.emplace_back();
        row.analyses.back().profile.metrics = {{"max_speed", "m/s", *topSpeed, 0.02}};
    }
    return row;
}

CameraRow cameraRow(const char *name, std::optional<double> rmsM)
{
    CameraRow row;
    row.camera.name = name;
    if (rmsM) {
        row.registration.emplace();
        row.registration->registration.rmsM = *rmsM;
        row.registration->registration.verdict = "Good <b>";
    }
    return row;
}

} // namespace

class TestListModels : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void spikes()
    {
        SpikeModel model;
        QAbstractItemModelTester tester(&model, strict);
        QCOMPARE(model.summary(), QStringLiteral("none"));
        model.setScene(exampleScene({.frames = 300}));
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.summary(), QStringLiteral("2 flagged · 1 restored"));
        const QModelIndex first = model.index(0, SpikeModel::TimeColumn);
        QCOMPARE(first.data().toString(), QStringLiteral("3.30\u00a0s"));
        QCOMPARE(first.data(SpikeModel::SampleIndexRole).toLongLong(), 99);
        QVERIFY(model.index(2, SpikeModel::ReasonColumn)
                    .data()
                    .toString()
                    .contains(QStringLiteral("restored by hand")));
        QVERIFY(model.index(2, 0).data(SpikeModel::RestoredRole).toBool());
        model.setScene(nullptr);
        QCOMPARE(model.rowCount(), 0);
    }
    void metrics()
    {
        MetricModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setMetrics({{"max_speed", "m/s", 2.0612, 0.02}, {"stops", "1", 2, std::nullopt}});
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0, MetricModel::NameColumn).data().toString(), QStringLiteral("Top speed"));
        QCOMPARE(model.index(0, 0).data(MetricModel::SmallPrintRole).toString(), QStringLiteral("m/s ±0.02"));
        QCOMPARE(model.index(1, 0).data(MetricModel::ValueTextRole).toString(), QStringLiteral("2"));
    }
    void trialsSortByWhatTheyMean()
    {
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows({trialRow("b", 30, 10.5), trialRow("a", 10, 9.5), trialRow("c", 20, std::nullopt)});
        QSortFilterProxyModel sorted;
        sorted.setSourceModel(&model);
        sorted.setSortRole(TrialModel::SortRole);
        const auto order = [&](int column) {
            sorted.sort(column);
            QString names;
            for (int row = 0; row < sorted.rowCount(); ++row)
                names += sorted.index(row, 0).data().toString();
            return names;
        };
        QCOMPARE(order(TrialModel::NameColumn), QStringLiteral("abc"));
        QCOMPARE(order(TrialModel::DateColumn), QStringLiteral("acb"));
        QCOMPARE(order(TrialModel::TopSpeedColumn), QStringLiteral("cab")); // 9.5 before 10.5, not by letters
        QCOMPARE(model.index(0, TrialModel::RobotsColumn).data().toString(), QStringLiteral("Red 2, Blue 1"));
        QVERIFY(
            model.index(0, 0).data(TrialModel::SearchRole).toString().contains(QStringLiteral("New wheels")));
        QCOMPARE(model.index(2, TrialModel::TopSpeedColumn).data().toString(), QStringLiteral("not tracked"));
    }
    void camerasTellTheirState()
    {
        CameraListModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows(
            {cameraRow("A", 0.0016), cameraRow("B", 0.012), cameraRow("C", 0.05), cameraRow("D", {})});
        const auto state = [&](int row) {
            return BadgeState(model.index(row, 0).data(CameraListModel::BadgeStateRole).toInt());
        };
        QCOMPARE(model.index(0, 0).data(CameraListModel::BadgeTextRole).toString(),
                 QStringLiteral("±1.6\u00a0mm"));
        QCOMPARE(state(0), BadgeState::Good);
        QCOMPARE(state(1), BadgeState::Warning);
        QCOMPARE(state(2), BadgeState::Bad);
        QCOMPARE(model.index(3, 0).data(CameraListModel::BadgeTextRole).toString(),
                 QStringLiteral("not registered"));
        // A tool tip guesses at rich text; what a file says must stay text.
        QCOMPARE(model.index(0, 0).data(Qt::ToolTipRole).toString(), QStringLiteral("Good &lt;b&gt;"));
    }
    void sceneFindsFramesAndObservations()
    {
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 30}));
        scene->views[1].startOffset = std::chrono::milliseconds(100); // three frames later
        QCOMPARE(scene->frameAt(0, scene->frameTimes()[7]).value(), std::int64_t(7));
        QCOMPARE(scene->frameAt(1, scene->frameTimes()[7]).value(), std::int64_t(4));
        QVERIFY(!scene->frameAt(1, scene->frameTimes()[0])); // it did not run yet
        scene->views[1].startOffset = std::chrono::milliseconds(20); // more than half a frame, less than one
        QCOMPARE(scene->frameAt(1, scene->frameTimes()[0]).value(), std::int64_t(0));
        QVERIFY(scene->observationAt(0, 0, 7));
        QVERIFY(!scene->observationAt(0, 0, 99));
        QVERIFY(scene->floorBounds().contains(Eigen::Vector2d(3.0, 2.2)));
        QVERIFY(TrialScene().floorBounds().sizes().minCoeff() > 0);
        QVERIFY(TrialScene().frameTimes().empty());
    }
};

QTEST_MAIN(TestListModels)
#include "tst_list_models.moc"
