// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task_templates.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace odo;

namespace {

constexpr double exactM = 1e-9;

/// Whether going along the path from point to point a gate is passed in its direction, and how often.
int passagesAlong(const Task &task, const Gate &gate)
{
    int count = 0;
    const auto &points = task.path.points;
    const std::size_t pieces = points.size() - (task.path.closed ? 0 : 1);
    const Eigen::Vector2d along = gate.to - gate.from, right(along.y(), -along.x());
    for (std::size_t i = 0; i < pieces; ++i) {
        const Eigen::Vector2d a = points[i], b = points[(i + 1) % points.size()];
        const double before = right.dot(a - gate.from), after = right.dot(b - gate.from);
        if (!(before < 0 && after >= 0))
            continue;
        const Eigen::Vector2d at = a + (b - a) * (-before / (after - before));
        const double share = along.dot(at - gate.from) / along.squaredNorm();
        count += share >= 0 && share <= 1;
    }
    return count;
}

} // namespace

class TestTaskTemplates : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyGateIsPassedOnceOnTheWay_data();
    void everyGateIsPassedOnceOnTheWay();
    void sizesAreThoseThatWereAskedFor();
    void theSizesOfATaskAreSuggested_data() { everyGateIsPassedOnceOnTheWay_data(); }
    void theSizesOfATaskAreSuggested();
    void refusesSizesThatAreNone();
};

void TestTaskTemplates::everyGateIsPassedOnceOnTheWay_data()
{
    QTest::addColumn<TaskTemplate>("kind");
    QTest::newRow("straight line") << TaskTemplate::StraightLine;
    QTest::newRow("circle") << TaskTemplate::Circle;
    QTest::newRow("figure eight") << TaskTemplate::FigureEight;
    QTest::newRow("slalom") << TaskTemplate::Slalom;
}

void TestTaskTemplates::everyGateIsPassedOnceOnTheWay()
{
    QFETCH(TaskTemplate, kind);
    TemplateSizes sizes;
    sizes.directionRad = 0.7;
    Task task = taskFromTemplate(kind, sizes).value();
    QVERIFY(task.kind == kind && task.gates.size() >= 2);
    if (kind ==
        TaskTemplate::Slalom) { // its ends lie on the gates: a robot comes from before and goes on behind
        const Eigen::Vector2d way(std::cos(0.7), std::sin(0.7));
        task.path.points.insert(task.path.points.begin(), task.path.points.front() - 0.1 * way);
        task.path.points.push_back(task.path.points.back() + 0.1 * way);
    }
    for (const Gate &gate : task.gates)
        QCOMPARE(passagesAlong(task, gate), 1);
}

void TestTaskTemplates::sizesAreThoseThatWereAskedFor()
{
    TemplateSizes sizes;
    sizes.centre = {1, 2};
    sizes.lengthM = 1.6;
    sizes.widthM = 0.8;
    const auto extent = [&](TaskTemplate kind) {
        Eigen::AlignedBox2d box;
        const Task task = taskFromTemplate(kind, sizes).value();
        for (const Eigen::Vector2d &point : task.path.points)
            box.extend(point);
        return box;
    };
    QVERIFY((extent(TaskTemplate::StraightLine).sizes() - Eigen::Vector2d(1.6, 0)).norm() < exactM);
    // A chord leaves the curve by 0.05 mm at most.
    QVERIFY((extent(TaskTemplate::Circle).sizes() - Eigen::Vector2d(1.6, 1.6)).norm() < 1e-4);
    QVERIFY((extent(TaskTemplate::FigureEight).sizes() - Eigen::Vector2d(1.6, 0.8)).norm() < 2e-4);
    QVERIFY((extent(TaskTemplate::Slalom).sizes() - Eigen::Vector2d(1.6, 0.8)).norm() < 2e-4);
    for (const TaskTemplate kind :
         {TaskTemplate::StraightLine, TaskTemplate::Circle, TaskTemplate::FigureEight, TaskTemplate::Slalom})
        QVERIFY((extent(kind).center() - sizes.centre).norm() < 1e-4);
    const Task free = taskFromTemplate(TaskTemplate::Free, sizes).value();
    QVERIFY(free.path.points.empty() && free.gates.size() == 2);
    QVERIFY(std::abs((free.gates[1].from - free.gates[0].from).norm() - 1.6) < exactM);
    QVERIFY(std::abs((free.gates[0].to - free.gates[0].from).norm() - sizes.gateM) < exactM);
}

void TestTaskTemplates::theSizesOfATaskAreSuggested()
{
    QFETCH(TaskTemplate, kind);
    TemplateSizes sizes;
    sizes.centre = {0.5, -1};
    sizes.lengthM = 1.4;
    sizes.widthM = 0.5;
    sizes.poles = 3;
    sizes.gateM = 0.3;
    const bool isStraight = kind == TaskTemplate::StraightLine || kind == TaskTemplate::Slalom;
    sizes.directionRad = isStraight ? -2.1 : 0;
    const TemplateSizes found = suggestedSizes(taskFromTemplate(kind, sizes).value(), {9, 9});
    QVERIFY(std::abs(found.lengthM - 1.4) < 2e-3);
    QVERIFY(std::abs(found.gateM - 0.3) < exactM);
    QVERIFY(std::abs(found.directionRad - sizes.directionRad) < 1e-6);
    QVERIFY((found.centre - sizes.centre).norm() < 2e-3);
    if (kind == TaskTemplate::Slalom)
        QCOMPARE(found.poles, 3);
    QCOMPARE(suggestedSizes({}, {9, 8}).centre.y(), 8.0);
}

void TestTaskTemplates::refusesSizesThatAreNone()
{
    TemplateSizes none;
    none.lengthM = 0;
    QCOMPARE(taskFromTemplate(TaskTemplate::Circle, none).error().why.english(),
             std::string("a size is less than 1 mm"));
    TemplateSizes far;
    far.centre.x() = 5000;
    QCOMPARE(taskFromTemplate(TaskTemplate::Circle, far).error().code, ErrorCode::InvalidInput);
    TemplateSizes nowhere;
    nowhere.centre.y() = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!taskFromTemplate(TaskTemplate::Free, nowhere));
    TemplateSizes forest;
    forest.poles = 101;
    QCOMPARE(taskFromTemplate(TaskTemplate::Slalom, forest).error().message(),
             std::string("template of a task: a slalom has 1 to 100 poles, not 101; choose another number"));
}

ODOGRAPH_TEST(TestTaskTemplates, QCoreApplication)
#include "tst_task_templates.moc"
