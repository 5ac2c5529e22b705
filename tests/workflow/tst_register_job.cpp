// SPDX-License-Identifier: GPL-3.0-or-later
// A registration and the picture that it is kept with.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestRegisterJob : public QObject
{
    Q_OBJECT

    SimulatedScene m_scene = demoTestbed(1);
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path path(const char *name) const
    {
        return m_folder->filePath(QString::fromLatin1(name)).toStdString();
    }

    RegisterSettings byImage() const
    {
        RegisterSettings settings;
        settings.camera = "A/1";
        settings.layout = m_scene.floor.markers.name;
        settings.imageFile = path("floor.png");
        return settings;
    }

    std::vector<MarkerPixel> truePixels() const
    {
        std::vector<MarkerPixel> pixels;
        for (const Marker &marker : m_scene.floor.markers.markers)
            pixels.push_back({marker.label, *m_scene.cameras[0].view.pixelFromWorld(
                                                {marker.pointInWorld.x(), marker.pointInWorld.y(), 0})});
        return pixels;
    }

    RegistrationRecord inForce()
    {
        return *m_project->cameras().currentRegistration(m_project->cameras().find("A/1")->id).value();
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(*Project::create(path("run.odo"), "run"));
        QVERIFY(m_project->layouts().add(m_scene.floor.markers));
        QVERIFY(writeImage(SceneRenderer(m_scene, 0).render(0), path("floor.png")));
    }
    void cleanup() { m_project.reset(); }

    void keepsThePictureInWhichTheMarkersWereSeen()
    {
        RegisterJob job(byImage());
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        m_project.reset();
        m_project = std::move(*Project::open(path("run.odo"), Project::Access::ReadWrite));
        const StoredImage image = inForce().image;
        QCOMPARE(image.path, std::string("run.media/calibration/A-1_floor.png"));
        QVERIFY(m_project->check(true)->empty());
        const auto revisions = revisionsOf(*m_project, "A/1");
        QCOMPARE(revisions->front().image,
                 std::filesystem::absolute(path("run.media/calibration/A-1_floor.png")));
        QCOMPARE(revisions->front().markers.size(), std::size_t(4));
        // The markers are found in it again, where they were.
        RegisterSettings again = byImage();
        again.imageFile = revisions->front().image;
        RegisterJob second(again);
        QVERIFY(runToEnd(second, *m_project, {}).has_value());
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY((second.record().pixels[i].pixel - job.record().pixels[i].pixel).norm() < 0.02);
    }

    void tellsOfAPictureThatIsLostOrChanged()
    {
        RegisterJob job(byImage());
        QVERIFY(runToEnd(job, *m_project, {}).has_value());
        const std::filesystem::path kept = path("run.media/calibration/A-1_floor.png");
        const auto bytes = std::filesystem::file_size(kept);
        QFile file(QString::fromStdString(kept.string()));
        QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(qint64(bytes) / 2) &&
                file.write("changed") == 7);
        file.close();
        QCOMPARE(m_project->check(true)->front().what.english(),
                 std::string("the image of registration 1 of camera 'A/1' has changed since it was created"));
        std::filesystem::remove(kept);
        const ProjectProblem problem = m_project->check(false)->front();
        QCOMPARE(problem.what.english(),
                 std::string("the image of registration 1 of camera 'A/1' is missing"));
        QCOMPARE(problem.advice.english(),
                 std::string("move the file back to its folder; the registration remains valid without it"));
    }

    void whatFailsLeavesNothing()
    {
        RegisterSettings unnamed = byImage();
        unnamed.camera = std::string(300, 'x'); // its row cannot be stored, after its picture was written
        RegisterJob job(unnamed);
        QVERIFY(!runToEnd(job, *m_project, {}).has_value());
        QVERIFY(!std::filesystem::exists(m_project->mediaFolder()));
        QVERIFY(m_project->cameras().all()->empty());
    }

    void pixelsAloneHaveNoPicture()
    {
        RegisterSettings settings = byImage();
        settings.pixels = truePixels();
        RegisterJob withImage(settings); // which only tells its size
        QVERIFY(runToEnd(withImage, *m_project, {}).has_value());
        QVERIFY(!inForce().image.path.empty());
        IntrinsicsRecord lens;
        lens.camera = m_project->cameras().find("A/1")->id;
        lens.calibration.intrinsics = m_scene.cameras[0].view.camera().intrinsics();
        QVERIFY(m_project->cameras().addIntrinsics(lens));
        // Anew with the lens: the same markers in the same picture.
        const auto again = registerWithCurrentIntrinsics(*m_project, "A/1");
        QVERIFY2(again.has_value(), again ? "" : again.error().message().c_str());
        QCOMPARE(again->image.path, std::string("run.media/calibration/A-1_floor.png"));
        QVERIFY(m_project->check(true)->empty());
        settings.imageFile.clear();
        RegisterJob without(settings);
        QVERIFY(runToEnd(without, *m_project, {}).has_value());
        QVERIFY(inForce().image.path.empty());
    }

    /// A lens of 4:3 stills of the same sensor, for an image in 16:9.
    void theLensIsFittedToTheImage()
    {
        const Intrinsics truth = m_scene.cameras[0].view.camera().intrinsics();
        IntrinsicsRecord stills;
        stills.camera = m_project->cameras().add({0, "A/1", {}})->id;
        stills.made = Instant(std::chrono::hours(1));
        Intrinsics &lens = stills.calibration.intrinsics = truth;
        lens.widthPx = 2 * truth.widthPx;
        lens.heightPx = lens.widthPx * 3 / 4;
        lens.fxPx *= 2;
        lens.fyPx *= 2;
        lens.cxPx = 2 * (truth.cxPx + 0.5) - 0.5;
        lens.cyPx = 2 * (truth.cyPx + 0.5) - 0.5 + (lens.heightPx - 2 * truth.heightPx) / 2;
        lens.covariance.resize(0, 0);
        QVERIFY(m_project->cameras().addIntrinsics(stills));

        RegisterJob job(byImage());
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        const auto inForceLens = m_project->cameras().currentIntrinsics(stills.camera)->value();
        QCOMPARE(inForceLens.calibration.intrinsics.widthPx, truth.widthPx);
        QCOMPARE(inForceLens.calibration.intrinsics.heightPx, truth.heightPx);
        QVERIFY(std::abs(inForceLens.calibration.intrinsics.fxPx / truth.fxPx - 1) < 0.003);
        QVERIFY(std::abs(inForceLens.calibration.intrinsics.cyPx - truth.cyPx) < 1e-9);
        QVERIFY(inForceLens.made == stills.made); // it is as old as those images
        QCOMPARE(inForce().intrinsics, inForceLens.id);
        const std::string verdict = inForce().registration.verdict.english();
        QVERIFY2(
            verdict.ends_with("The lens calibration at 2560×1920 was cropped above and below to 1280×720, as "
                              "the markers confirm."),
            verdict.c_str());
        const auto &position = inForce().registration.worldFromCamera.translation;
        QVERIFY((position - m_scene.cameras[0].view.cameraInWorld()).norm() < 0.02);

        // a better calibration of the stills serves as well, from the same markers
        QVERIFY(m_project->cameras().addIntrinsics(stills));
        const auto again = registerWithCurrentIntrinsics(*m_project, "A/1");
        QVERIFY2(again.has_value(), again ? "" : again.error().message().c_str());
        QCOMPARE(m_project->cameras().currentIntrinsics(stills.camera)->value().id, again->intrinsics);
        QCOMPARE(m_project->cameras().currentIntrinsics(stills.camera)->value().calibration.intrinsics.fxPx,
                 inForceLens.calibration.intrinsics.fxPx);
    }

    void aScaledLensIsConverted()
    {
        IntrinsicsRecord half;
        half.camera = m_project->cameras().add({0, "A/1", {}})->id;
        Intrinsics &lens = half.calibration.intrinsics = m_scene.cameras[0].view.camera().intrinsics();
        lens.widthPx *= 2;
        lens.heightPx *= 2;
        lens.fxPx *= 2;
        lens.fyPx *= 2;
        lens.cxPx = 2 * (lens.cxPx + 0.5) - 0.5;
        lens.cyPx = 2 * (lens.cyPx + 0.5) - 0.5;
        lens.covariance.resize(0, 0);
        QVERIFY(m_project->cameras().addIntrinsics(half));
        RegisterJob job(byImage());
        QVERIFY(runToEnd(job, *m_project, {}).has_value());
        const std::string verdict = inForce().registration.verdict.english();
        QVERIFY2(verdict.ends_with("The lens calibration at 2560×1440 was converted to 1280×720."),
                 verdict.c_str());
        const auto &position = inForce().registration.worldFromCamera.translation;
        QVERIFY((position - m_scene.cameras[0].view.cameraInWorld()).norm() < 0.02);
    }
};

ODOGRAPH_TEST(TestRegisterJob, QCoreApplication)
#include "tst_register_job.moc"
