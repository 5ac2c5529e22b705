// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/mat_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/register_job.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestMatJob : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void storesItsLayoutOnce();
    void takesThePrintsScale();
    void aSmallMatHasAShortLine();
    void saysWhichFilesShowIt();
    void registersCameras();
    void refusesInWords();

private:
    std::filesystem::path file(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    void paint(const char *name, int camera, const FloorMat &mat, Eigen::Vector2d at) const;
    std::string problemOf(MatSettings settings) const;

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    SimulatedScene m_scene = demoTestbed(5);
};

/// A still of the demo's floor with a mat on it.
void TestMatJob::paint(const char *name, int camera, const FloorMat &mat, Eigen::Vector2d at) const
{
    SimulatedScene scene = m_scene;
    scene.floor.markers = matLayout(mat);
    scene.floor.areTagsByLabel = true;
    scene.floor.markerSideM = mat.scale * matTagM;
    for (Marker &marker : scene.floor.markers.markers)
        marker.pointInWorld += at;
    QVERIFY(writeImage(SceneRenderer(scene, camera).render(0), file(name)));
}

void TestMatJob::initTestCase()
{
    m_project = std::move(*Project::create(file("p.odo"), "Mats"));
    const FloorMat a4{FloorMat::Paper::A4, 4, 3};
    paint("a.png", 0, a4, {1, 0.8});
    paint("b.png", 1, a4, {1, 0.8});
    paint("a3.png", 0, {FloorMat::Paper::A3, 3, 2}, {1, 0.8});
    QVERIFY(writeImage(SceneRenderer(m_scene, 0).render(0), file("none.png")));
    QVERIFY(QFile(QString::fromStdString(file("broken.png").string())).open(QIODevice::WriteOnly));
}

void TestMatJob::storesItsLayoutOnce()
{
    for (int time = 0; time < 2; ++time) {
        FindMatJob job({{file("a.png")}, std::nullopt});
        QVERIFY(runToEnd(job, *m_project, {}));
        QCOMPARE(job.layoutName(), std::string("Mat A4 4x3"));
        QCOMPARE(m_project->layouts().all()->size(), std::size_t(1));
    }
    QCOMPARE(m_project->layouts().find("Mat A4 4x3")->layout.markers.size(), std::size_t(12));
    QCOMPARE(m_project->changes()->size(), std::size_t(1));
}

void TestMatJob::takesThePrintsScale()
{
    FindMatJob job({{file("a.png")}, 0.985});
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(job.layoutName(), std::string("Mat A4 4x3, 98.50 %"));
    const auto layout = m_project->layouts().find(job.layoutName());
    const MarkerLayout whole = matLayout({FloorMat::Paper::A4, 4, 3});
    for (std::size_t i = 0; i < whole.markers.size(); ++i)
        QVERIFY((layout->layout.markers[i].pointInWorld - 0.985 * whole.markers[i].pointInWorld).norm() <
                1e-12);
}

void TestMatJob::aSmallMatHasAShortLine()
{
    paint("small.png", 0, {FloorMat::Paper::A4, 2, 2, 0.97}, {1, 0.8});
    FindMatJob job({{file("small.png")}, 0.97 * 0.2});
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(job.layoutName(), std::string("Mat A4 2x2, 97.00 %"));
    // Of a large one only a part may be seen: it is the owner who sees the line.
    FindMatJob part({{file("small.png")}, 0.97});
    QVERIFY(runToEnd(part, *m_project, {}));
    QCOMPARE(part.layoutName(), std::string("Mat A4 2x2, 97.00 %"));
}

void TestMatJob::saysWhichFilesShowIt()
{
    FindMatJob job({{file("none.png"), file("b.png")}, std::nullopt});
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(job.isSeen(), (std::vector<bool>{false, true}));
}

/// Without a lens calibration: within what the registration states.
void TestMatJob::registersCameras()
{
    FindMatJob job({{file("a.png"), file("b.png")}, 1.0});
    QVERIFY(runToEnd(job, *m_project, {}));
    const char *images[] = {"a.png", "b.png"};
    for (int camera = 0; camera < 2; ++camera) {
        RegisterJob one({std::string(1, char('A' + camera)), job.layoutName(), {}, file(images[camera]), {}});
        const auto registered = runToEnd(one, *m_project, {});
        QVERIFY2(registered, registered ? "" : registered.error().message().c_str());
        const FloorRegistration &registration = one.record().registration;
        QVERIFY2(registration.floorSigmaM < 0.01, std::to_string(registration.floorSigmaM).c_str());
        // The mat's origin lies at (1, 0.8) of the demo's floor.
        const Eigen::Vector3d truth =
            m_scene.cameras[std::size_t(camera)].view.cameraInWorld() - Eigen::Vector3d(1, 0.8, 0);
        const Eigen::Vector3d off = registration.worldFromCamera.translation - truth;
        QVERIFY2(off.norm() < 0.15, std::to_string(off.norm()).c_str()); // of 3 m, with an unknown lens
    }
}

std::string TestMatJob::problemOf(MatSettings settings) const
{
    FindMatJob job(std::move(settings));
    const auto done = runToEnd(job, *m_project, {});
    return done ? "" : done.error().message();
}

void TestMatJob::refusesInWords()
{
    QCOMPARE(problemOf({{file("none.png")}, std::nullopt}),
             std::string("floor mat: no file shows four or more of its tags; print the mat, lay it where the "
                         "cameras see all of it, and record again"));
    QCOMPARE(problemOf({{file("a.png"), file("a3.png")}, std::nullopt}),
             std::string("floor mat: the files show mats of different paper; leave one mat on the floor, and "
                         "use newer files"));
    for (const double line : {0.1, 0.7, 1.3, std::numeric_limits<double>::quiet_NaN()})
        QCOMPARE(problemOf({{file("a.png")}, line}),
                 std::string("floor mat: its check line is 1000 or 200 mm long; no print is off by so much; "
                             "measure the line from end mark to end mark"));
    QVERIFY(problemOf({{file("broken.png")}, std::nullopt}).find("broken.png") != std::string::npos);
    QVERIFY(problemOf({{}, std::nullopt}).starts_with("floor mat: no file shows"));
}

ODOGRAPH_TEST(TestMatJob, QCoreApplication)
#include "tst_mat_job.moc"
