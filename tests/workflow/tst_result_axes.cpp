// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/result_axes.h"
#include "tests/support/registered_test.h"
#include "tests/support/simulated_set_up.h"

#include <QTemporaryDir>
#include <QTest>
#include <memory>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

class TestResultAxes : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    SimulatedScene m_scene = demoTestbed(3);
    RecordId m_layout = 0;

    RegistrationRecord inForce(const std::string &camera)
    {
        return registeredCamera(*m_project, camera)->registration;
    }
    /// A turn and a new origin, as "layout transform --origin-at 1000,500 --turn 90".
    LayoutAxesOutcome change()
    {
        AxesChange change;
        change.originM = Vector2d(1, 0.5);
        change.turnDegrees = 90;
        return changeLayoutAxes(*m_project, m_scene.floor.markers.name, change).value();
    }
    AnalysisRecord resultOf(RecordId registration, RecordId task)
    {
        AnalysisRecord analysis;
        analysis.registrations = {registration};
        analysis.task = task;
        Sample sample;
        sample.position = Vector2d(1.2, 0.7);
        sample.covariance << 4e-6, 1e-6, 1e-6, 1e-6;
        ProfilePoint point;
        point.position = *sample.position;
        point.velocity = {0.5, 0};
        point.acceleration = {0, 0.2};
        point.sigmaXM = 0.002;
        point.sigmaYM = 0.001;
        analysis.profile.samples = {sample};
        analysis.profile.points = {point};
        return analysis;
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project =
            Project::create(m_folder->filePath(QStringLiteral("p.odo")).toStdString(), "axes").value();
        m_layout = m_project->layouts().add(m_scene.floor.markers)->id;
        for (const SimulatedCamera &camera : m_scene.cameras)
            QVERIFY(registerSimulatedCamera(*m_project, camera, m_scene.floor.markers, m_layout));
    }
    void cleanup() { m_project.reset(); }

    void unchangedAxesAreTheirOwn()
    {
        const auto axes = presentAxesOf(*m_project, inForce("A"));
        QVERIFY(axes && *axes);
        QCOMPARE((*axes)->turnRad, 0.0);
        QVERIFY((*axes)->shiftM.isZero(0));
    }
    void olderResultsMoveIntoThePresentAxes()
    {
        const RegistrationRecord before = inForce("A");
        Task line;
        line.path.points = {{0, 0}, {1, 0}};
        const RecordId task = m_project->tasks().add({0, "line", line})->id;
        const LayoutAxesOutcome first = change(), second = change();
        QCOMPARE(second.movedTasks, std::vector<std::string>{"line"});
        QVERIFY(second.tasks.empty());
        const auto axes = presentAxesOf(*m_project, before);
        QVERIFY(axes && *axes);
        const Vector2d point(1.2, 0.7), expected = second.newFromOld * (first.newFromOld * point);
        QVERIFY(((**axes * point) - expected).norm() < 1e-9);

        AnalysisRecord analysis = resultOf(before.id, task);
        TrialRecord trial;
        QCOMPARE(*bringToPresentAxes(*m_project, trial, analysis), true);
        const ProfilePoint &moved = analysis.profile.points.front();
        QVERIFY((moved.position - expected).norm() < 1e-9);
        QVERIFY((*analysis.profile.samples.front().position - expected).norm() < 1e-9);
        QVERIFY((moved.velocity - Vector2d(-0.5, 0)).norm() < 1e-9); // two quarter turns
        QVERIFY(std::abs(moved.sigmaXM - 0.002) < 1e-9);
        QCOMPARE(*haveSameRegistrations(*m_project, analysis, resultOf(inForce("A").id, 0)), true);
        // What is in the present axes already stays.
        AnalysisRecord present = resultOf(inForce("A").id, 0);
        QCOMPARE(*bringToPresentAxes(*m_project, trial, present), true);
        QCOMPARE(present.profile.points.front().position, Vector2d(1.2, 0.7));
    }
    void aCameraThatWasRegisteredAnewAsWell()
    {
        // Its older registration was not carried along, but another camera's of that time was.
        const RegistrationRecord old = inForce("A");
        SimulatedCamera moved = m_scene.cameras[0];
        RigidTransform pose = moved.view.worldFromCamera();
        pose.translation.z() += 0.1;
        moved.view = FloorView(moved.view.camera(), pose, Eigen::Matrix<double, 6, 6>::Zero());
        QVERIFY(registerSimulatedCamera(*m_project, moved, m_scene.floor.markers, m_layout));
        const LayoutAxesOutcome outcome = change();
        const auto axes = presentAxesOf(*m_project, old);
        QVERIFY(axes && *axes);
        const Vector2d point(1.2, 0.7);
        QVERIFY(((**axes * point) - outcome.newFromOld * point).norm() < 1e-9);
        // Put in force again, it is in the present axes, too.
        QVERIFY(chooseRevision(*m_project, "A", Revision::Kind::Registration, old.id));
        const auto chosen = presentAxesOf(*m_project, inForce("A"));
        QVERIFY(chosen && *chosen && (*chosen)->shiftM.isZero(0));
        QVERIFY(inForce("A").id != old.id);
    }
    void anotherUnitIsAnotherResult()
    {
        AnalysisRecord analysis = resultOf(inForce("A").id, 0);
        AxesChange unit;
        unit.lengthFactor = 10;
        QVERIFY(changeLayoutAxes(*m_project, m_scene.floor.markers.name, unit));
        QCOMPARE(*bringToPresentAxes(*m_project, {}, analysis), false);
        QCOMPARE(analysis.profile.points.front().position, Vector2d(1.2, 0.7));
    }
    void floorsThatAreNotKnownToEachOther()
    {
        const auto other = m_project->layouts().add(
            {"hall", {{"P", {0, 0}}, {"Q", {3, 0}}, {"R", {0, 2}}, {"S", {3, 2.1}}}});
        RegistrationRecord record = inForce("B");
        const AnalysisRecord here = resultOf(inForce("A").id, 0);
        record.layout = other->id;
        const auto there = storeRegistration(*m_project, "C", record);
        QVERIFY(there);
        QCOMPARE(*haveCommonAxes(*m_project, here, resultOf(there->id, 0)), false);
        QCOMPARE(*haveCommonAxes(*m_project, here, here), true);
    }
};

ODOGRAPH_TEST(TestResultAxes, QCoreApplication)
#include "tst_result_axes.moc"
