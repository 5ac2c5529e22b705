// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/certificate/certificate.h"

#include "core/base/platform/user_folders.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/workflow/known_truth.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/support/simulated_set_up.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

/// The demo's testbed with small images, certified through the core alone.
class TestCertificate : public QObject
{
    Q_OBJECT

    SimulatedScene m_scene = smallTestbed();
    QTemporaryDir m_temporary;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;

    static SimulatedScene smallTestbed()
    {
        SimulatedScene scene = demoTestbed(1);
        scene.cameras[0].view = simulatedView({-0.9, -1.55, 2.0}, {1.4, 0.75, 0.0}, 640, 360, 480);
        scene.cameras[1].view = simulatedView({3.9, -1.55, 2.0}, {1.6, 0.75, 0.0}, 640, 360, 470);
        return scene;
    }
    void registerCameras()
    {
        const RecordId layout = m_project->layouts().add(m_scene.floor.markers)->id;
        for (const SimulatedCamera &camera : m_scene.cameras)
            QVERIFY(registerSimulatedCamera(*m_project, camera, m_scene.floor.markers, layout));
    }
    void addRobot()
    {
        QVERIFY(addSimulatedRobot(*m_project, demoRobot("Blue 1", {.colour = demoBlue}, nullptr)));
    }
    std::string refusal(const CertificateSettings &settings)
    {
        const auto setUp = readCertificateSetUp(*m_project, settings);
        if (!setUp)
            return setUp.error().message();
        const auto made = makeCertificate(*setUp, {});
        return made ? "made" : made.error().message();
    }
    static QStringList temporaryFolders()
    {
        return QDir(QString::fromStdString(temporaryFolder().string()))
            .entryList({QStringLiteral(".odograph-*")}, QDir::Dirs | QDir::Hidden);
    }

private Q_SLOTS:
    /// So other programs' temporary folders are not counted.
    void initTestCase() { qputenv("TMPDIR", m_temporary.path().toLocal8Bit()); }
    void init()
    {
        m_scene = smallTestbed();
        m_folder = std::make_unique<QTemporaryDir>();
        m_project =
            Project::create(m_folder->filePath(QStringLiteral("p.odo")).toStdString(), "set-up").value();
    }
    void cleanup() { m_project.reset(); }

    /// Half the demo's resolution: ten times the errors of the demo would still be small.
    void theErrorsAreThoseOfTheSimulation()
    {
        registerCameras();
        addRobot();
        const QByteArray before = fileHash(QString::fromStdString(m_project->file().string()));
        const QStringList folders = temporaryFolders();
        const auto setUp = readCertificateSetUp(*m_project, {});
        QVERIFY2(setUp.has_value(), setUp ? "" : setUp.error().message().c_str());
        QCOMPARE(setUp->cameras.size(), std::size_t(2));
        QVERIFY(setUp->isRobotInProject);
        QCOMPARE(setUp->cameras[0].framesPerSecond, 30.0);
        QCOMPARE(setUp->remarks.size(), std::size_t(1)); // no recording shows the frame rate
        double reported = 0;
        const auto outcome =
            makeCertificate(*setUp, {{}, [&](double fraction, const Message &) { reported = fraction; }}, 3);
        QVERIFY2(outcome.has_value(), outcome ? "" : outcome.error().message().c_str());
        QVERIFY(reported > 0.9 && reported <= 1);
        QCOMPARE(outcome->runs.size(), std::size_t(3));
        QVERIFY(outcome->compared > 9 * outcome->frames / 10);
        const CertificateErrors &position = outcome->position;
        qInfo("position %.2f mm, 95 %% below %.2f mm, stated %.2f mm, covered %.2f; velocity %.1f mm/s; "
              "acceleration %.0f mm/s²; %.1f s, %.1f m",
              1000 * position.rms, 1000 * position.p95, 1000 * *position.sigma, *position.covered,
              1000 * outcome->velocity.rms, 1000 * outcome->acceleration.rms, outcome->durationS,
              outcome->lengthM);
        QVERIFY(position.rms > 1e-5 && position.rms < 0.006);
        QVERIFY(position.p95 > position.rms / 2 && position.p95 < 4 * position.rms);
        QVERIFY(*position.covered > 0.8); // three draws of the cameras leave it coarse
        QVERIFY(*position.sigma > position.rms / 3 && *position.sigma < 3 * position.rms);
        QVERIFY(outcome->velocity.rms < 0.03 && outcome->velocity.rms > outcome->speed.rms / 2);
        QVERIFY(outcome->acceleration.rms < 0.5);
        QVERIFY(outcome->largestSyncErrorS < 0.004);
        QCOMPARE(fileHash(QString::fromStdString(m_project->file().string())), before);
        QCOMPARE(temporaryFolders(), folders);
        // The figures are those of compareWithTruth, run by run.
        double squares = 0;
        std::int64_t count = 0;
        for (const CertificateRun &run : outcome->runs) {
            const TruthAccuracy accuracy = compareWithTruth(run.profile, run.truth);
            squares += double(accuracy.compared) * accuracy.positionRmsM * accuracy.positionRmsM;
            count += accuracy.compared;
        }
        QCOMPARE(count, outcome->compared);
        QVERIFY(std::abs(std::sqrt(squares / double(count)) - position.rms) < 1e-9);
    }

    /// What a registration is uncertain by is in the errors: with a covariance of 30 mm and more they are as
    /// large, and without one they are those of the views alone.
    void theRegistrationsUncertaintyCounts_data()
    {
        QTest::addColumn<double>("factor");
        QTest::addColumn<double>("lowM");
        QTest::addColumn<double>("highM");
        QTest::newRow("exact") << 0.0 << 0.0 << 0.004;
        QTest::newRow("uncertain") << 100.0 << 0.01 << 0.3;
    }
    void theRegistrationsUncertaintyCounts()
    {
        QFETCH(double, factor);
        QFETCH(double, lowM);
        QFETCH(double, highM);
        m_scene.cameras.pop_back();
        registerCameras();
        addRobot();
        auto setUp = readCertificateSetUp(*m_project, {});
        QVERIFY(setUp.has_value());
        CertificateCamera &camera = setUp->cameras.front();
        camera.registration.registration.poseCovariance *= factor * factor;
        camera.isUncertaintyKnown = factor > 0;
        const auto outcome = makeCertificate(*setUp, {}, 2);
        QVERIFY2(outcome.has_value(), outcome ? "" : outcome.error().message().c_str());
        QVERIFY(!outcome->runs.front().largestSyncErrorS); // a single view
        const double rms = outcome->position.rms;
        QVERIFY2(rms >= lowM && rms < highM, qPrintable(QString::number(rms)));
    }

    void aTasksCourseIsFollowed()
    {
        registerCameras();
        Task task;
        task.path.points = {{0.5, 0.5}, {2.4, 0.6}, {2.3, 1.6}};
        QVERIFY(m_project->tasks().add({0, "corner", task}));
        const auto setUp = readCertificateSetUp(*m_project, {.task = "corner"});
        QVERIFY(setUp.has_value() && setUp->task);
        QVERIFY(!setUp->isRobotInProject); // and a remark says that a box is simulated in its stead
        QCOMPARE(setUp->remarks.size(), std::size_t(2));
        QVERIFY(setUp->remarks.back().english().find("blue box") != std::string::npos);
        const auto outcome = makeCertificate(*setUp, {}, 1);
        QVERIFY2(outcome.has_value(), outcome ? "" : outcome.error().message().c_str());
        QVERIFY(std::abs(outcome->lengthM - (std::hypot(1.9, 0.1) + std::hypot(0.1, 1.0))) < 1e-6);
        const std::vector<Vector2d> &truth = outcome->runs.front().truth.positions;
        QVERIFY((truth.front() - Vector2d(0.5, 0.5)).norm() < 1e-6);
        QVERIFY((truth.back() - Vector2d(2.3, 1.6)).norm() < 0.01);
        QVERIFY(outcome->position.rms < 0.01);
    }

    /// The reference point beside the centre turns with the robot: what is measured is compared with it.
    void theReferencePointIsWhatCounts()
    {
        registerCameras();
        RobotRecord robot;
        robot.name = "Blue 1";
        robot.colour = demoBlue;
        robot.heightMode = RobotRecord::Height::Given;
        robot.heightM = 0.06;
        robot.lengthM = 0.26;
        robot.widthM = 0.19;
        robot.referenceM = {0.08, 0};
        QVERIFY(m_project->robots().add(robot));
        Task task;
        task.path = {{{0.6, 0.8}, {2.3, 0.9}}, false};
        QVERIFY(m_project->tasks().add({0, "line", task}));
        const auto outcome = makeCertificate(*readCertificateSetUp(*m_project, {.task = "line"}), {}, 1);
        QVERIFY2(outcome.has_value(), outcome ? "" : outcome.error().message().c_str());
        const Vector2d along = Vector2d(1.7, 0.1).normalized();
        QVERIFY((outcome->runs.front().truth.positions.front() - Vector2d(0.6, 0.8) - 0.08 * along).norm() <
                1e-6);
        QVERIFY2(outcome->position.rms < 0.015, qPrintable(QString::number(outcome->position.rms)));
    }

    void refusalsInWords()
    {
        QCOMPARE(refusal({}), std::string("certificate: no camera is registered to the floor; register the "
                                          "cameras first"));
        registerCameras();
        addRobot();
        QVERIFY(refusal({.task = "Circle"}).find("Circle") != std::string::npos);
        QVERIFY(refusal({.task = {}, .robot = "Nobody"}).find("Nobody") != std::string::npos);
        QVERIFY(m_project->tasks().add({0, "empty", {}}));
        QCOMPARE(refusal({.task = "empty"}),
                 std::string("certificate: task 'empty' has neither a path nor gates to drive along; choose "
                             "a task that has, or leave the task out"));
        Task away;
        away.path.points = {{20, 20}, {22, 20}};
        QVERIFY(m_project->tasks().add({0, "away", away}));
        QCOMPARE(refusal({.task = "away"}),
                 std::string("certificate: the cameras see only 0 % of the course of task 'away'; choose a "
                             "task on the floor that they see, or leave the task out"));
    }

    void camerasThatShareNoFloor()
    {
        m_scene.floor.markers = {"hall",
                                 {{"a", {0, 0}},
                                  {"b", {1, 0}},
                                  {"c", {1, 1}},
                                  {"d", {0, 1}},
                                  {"e", {30, 0}},
                                  {"f", {31, 0}},
                                  {"g", {31, 1}},
                                  {"h", {30, 1}}}};
        const RecordId layout = m_project->layouts().add(m_scene.floor.markers)->id;
        for (int number : {0, 1}) {
            SimulatedCamera camera = m_scene.cameras[std::size_t(number)];
            const double x = 30.0 * number;
            camera.view = simulatedView({x + 0.4, -1.2, 1.6}, {x + 0.5, 0.5, 0}, 640, 360, 480);
            MarkerLayout seen = m_scene.floor.markers;
            std::erase_if(seen.markers,
                          [&](const Marker &marker) { return std::abs(marker.pointInWorld.x() - x) > 2; });
            QVERIFY(registerSimulatedCamera(*m_project, camera, seen, layout));
        }
        QVERIFY(refusal({}).starts_with("certificate: no two cameras share enough of the floor"));
    }

    void cancelledItLeavesNothing()
    {
        registerCameras();
        addRobot();
        const QStringList folders = temporaryFolders();
        JobControl control;
        control.progress = [&](double, const Message &) { control.cancel.cancel(); };
        const auto outcome = makeCertificate(*readCertificateSetUp(*m_project, {}), control);
        QVERIFY(!outcome.has_value());
        QCOMPARE(outcome.error().code, ErrorCode::Cancelled);
        QCOMPARE(temporaryFolders(), folders);
    }
};

ODOGRAPH_TEST(TestCertificate, QCoreApplication)
#include "tst_certificate.moc"
