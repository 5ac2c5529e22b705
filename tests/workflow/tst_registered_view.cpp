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
    void picturesOfAnotherSizeAreRefused()
    {
        const auto trial = m_project->trials().find("Trial 1");
        auto recordings = *m_project->trials().recordings(trial->id);
        for (RecordingRecord &recording : recordings) {
            recording.id = 0;
            recording.widthPx *= 2;
            recording.heightPx *= 2;
        }
        TrialRecord larger;
        larger.name = "larger";
        QVERIFY(m_project->trials().add(larger, recordings));
        TrackJob job("larger", {});
        const auto tracked = runToEnd(job, *m_project, {});
        QVERIFY(!tracked);
        QCOMPARE(
            tracked.error().message(),
            std::string("view 'A' of trial 'larger': its frames are 640×360 but the camera was calibrated at "
                        "320×180; calibrate and register the camera at the size it records"));
    }

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestRegisteredView, QCoreApplication)
#include "tst_registered_view.moc"
