// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trial_sources.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/track_job.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

/// A recording is measured by the calibration of its camera, or not at all.
class TestRegisteredView : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_project = openStoredExample(m_folder.path().toStdString()); }

    void viewsHaveTheirRegistration()
    {
        const auto views = registeredViews(*m_project, *m_project->trials().find("Trial 1"));
        QVERIFY2(views, views ? "" : views.error().message().c_str());
        QCOMPARE(views->size(), std::size_t(2));
        for (const RegisteredView &view : *views)
            QVERIFY(view.registration && view.floorView);
    }

    /// Its figures would be wrong in silence.
    void framesOfAnotherShapeAreRefused()
    {
        addOfSize("taller", 640, 480);
        TrackJob job("taller", {});
        const auto tracked = runToEnd(job, *m_project, {});
        QVERIFY(!tracked);
        QCOMPARE(tracked.error().message(),
                 std::string(
                     "view 'A' in trial 'taller': its frames are 640×480, but the camera was registered at "
                     "320×180; register the camera in a frame of this video, to which its lens "
                     "calibration is then fitted"));
    }

    /// A pixel of twice the size is where it was.
    void framesOfTheSameShapeAreConverted()
    {
        addOfSize("larger", 640, 360);
        const auto before = registeredViews(*m_project, *m_project->trials().find("Trial 1")),
                   views = registeredViews(*m_project, *m_project->trials().find("larger"));
        QVERIFY2(views, views ? "" : views.error().message().c_str());
        QVERIFY(!before->front().convertedFromPx);
        QVERIFY((views->front().convertedFromPx == std::pair{320, 180}));
        const Eigen::Matrix2d noise = 0.01 * Eigen::Matrix2d::Identity();
        for (const Eigen::Vector2d pixel : {Eigen::Vector2d(100, 80), Eigen::Vector2d(250.3, 170)}) {
            const auto one = before->front().floorView->locate(pixel, noise, 0.05);
            const auto two = views->front().floorView->locate(
                {2 * (pixel.x() + 0.5) - 0.5, 2 * (pixel.y() + 0.5) - 0.5}, 4 * noise, 0.05);
            QVERIFY(one && two);
            QVERIFY((one->pointInWorld - two->pointInWorld).norm() < 1e-9);
            QVERIFY((one->pixelCovariance - two->pixelCovariance).norm() <
                    1e-9 * one->pixelCovariance.norm());
            QVERIFY((one->calibrationCovariance - two->calibrationCovariance).norm() <=
                    1e-6 * one->calibrationCovariance.norm());
        }
        const auto words = convertedViewWarnings("larger", *views);
        QCOMPARE(words.size(), std::size_t(2));
        QCOMPARE(
            words.front().english(),
            std::string("view 'A' in trial 'larger': its frames are 640×360, so the camera's registration "
                        "at 320×180 was converted; if the camera shows another part of the scene at that "
                        "size, register it again in a frame of this video"));
        QVERIFY(convertedViewWarnings("Trial 1", *before).empty());
    }

private:
    void addOfSize(const char *name, int widthPx, int heightPx)
    {
        auto recordings = *m_project->trials().recordings(m_project->trials().find("Trial 1")->id);
        for (RecordingRecord &recording : recordings) {
            recording.id = 0;
            recording.widthPx = widthPx;
            recording.heightPx = heightPx;
        }
        TrialRecord trial;
        trial.name = name;
        QVERIFY(m_project->trials().add(trial, recordings));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestRegisteredView, QCoreApplication)
#include "tst_registered_view.moc"
