// SPDX-License-Identifier: GPL-3.0-or-later
// Clips whose files say that they are to be turned: new ones are measured upright, those of older projects as
// they were, which is told.
#include "core/geometry/camera_model.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/turned_recordings.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestTurnedRecordings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    std::vector<std::string> imported(const std::string &trial, const std::string &camera,
                                      const std::string &file)
    {
        ImportSettings settings;
        settings.trial = trial;
        settings.videos = {{camera, path(file)}};
        ImportTrialJob job(settings);
        const auto done = runToEnd(job, *m_project, {});
        if (!done)
            return {done.error().message()};
        std::vector<std::string> warnings;
        for (const Message &warning : job.warnings())
            warnings.push_back(warning.english());
        return warnings;
    }
    RecordingRecord recordingOf(const std::string &trial)
    {
        return m_project->trials().recordings(m_project->trials().find(trial)->id)->front();
    }
    /// A trial as an older version imported it.
    RecordingRecord addOld(const std::string &trial, const std::string &file)
    {
        RecordingRecord old;
        old.camera = m_project->cameras().find("A")->id;
        old.path = path(file).string();
        old.widthPx = 192;
        old.heightPx = 96;
        old.orientation = 0;
        old.frameTimes = evenTimes(12, 25);
        TrialRecord record;
        record.name = trial;
        if (!m_project->trials().add(record, {old}))
            qFatal("not added");
        return recordingOf(trial);
    }
    void registerCamera(const std::string &name, bool isUpright)
    {
        CameraRecord camera;
        camera.name = name;
        MarkerLayout layout;
        layout.name = "floor of " + name;
        layout.markers = {{"O", {0, 0}}, {"U", {1, 0}}, {"V", {0, 1}}};
        RegistrationRecord record;
        record.camera = m_project->cameras().add(camera)->id;
        record.layout = m_project->layouts().add(layout)->id;
        record.assumedIntrinsics = CameraModel::assumed(96, 192).intrinsics();
        record.registration.intrinsics = record.assumedIntrinsics;
        record.registration.worldFromCamera.translation = {0, 0, 2};
        record.registration.poseCovariance.setZero();
        record.isUpright = isUpright;
        if (!m_project->cameras().addRegistration(record))
            qFatal("not registered");
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = std::move(*Project::create(path("class.odo"), "Class"));
        QCOMPARE(writeCoded(path("plain.mkv"), evenTimes(12, 25), {}), QString());
        QVERIFY(remux(path("plain.mkv"), path("portrait.mov"), {0, 1, -1, 0}));
    }

    void aNewClipIsMeasuredUpright()
    {
        QVERIFY(imported("new", "A", "portrait.mov").empty());
        const RecordingRecord recording = recordingOf("new");
        QCOMPARE(recording.orientation, 6);
        QCOMPARE(recording.widthPx, 96);
        QCOMPARE(recording.heightPx, 192);
        const auto reader = VideoReader::open(m_project->resolve(recording), {}, knownRecording(recording));
        QCOMPARE((*reader)->info().format.width, 96);
        QVERIFY(storedFrameWarning("new", recording, m_project->resolve(recording)).isEmpty());
        QVERIFY(imported("plain", "A", "plain.mkv").empty());
        QCOMPARE(recordingOf("plain").orientation, 1);
    }

    void anOldClipStaysAsItWasMeasured()
    {
        const RecordingRecord old = addOld("old", "portrait.mov"), plain = addOld("old plain", "plain.mkv");
        QCOMPARE(old.orientation, 0);
        const auto reader = VideoReader::open(path("portrait.mov"), {}, knownRecording(old));
        QCOMPARE((*reader)->info().format.width, 192);
        QCOMPARE((*reader)->frameAt(0)->y.width, 192);
        QCOMPARE(storedFrameWarning("old", old, path("portrait.mov")).english(),
                 std::string("view 'A' in trial 'old': an earlier version measured its frames as stored, but "
                             "its file says to turn or mirror them; import the video again to measure it "
                             "upright"));
        QVERIFY(storedFrameWarning("old plain", plain, path("plain.mkv")).isEmpty());
        const auto problems = turnedRecordings(*m_project).value();
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(problems[0].where.english(), std::string("view 'A' in trial 'old'"));
        RegisteredView view;
        view.recording = old;
        view.file = path("portrait.mov");
        QCOMPARE(turnedWarnings("old", {view}).size(), std::size_t(1));
    }

    void anOldRegistrationMayBeOfFramesAsStored()
    {
        registerCamera("old", false);
        registerCamera("new", true);
        QCOMPARE(
            imported("by old", "old", "portrait.mov"),
            std::vector<std::string>{
                "view 'old' in trial 'by old': its frames are turned or mirrored as its file says, but an "
                "earlier version registered camera 'old', perhaps by frames as stored; register the "
                "camera again"});
        QVERIFY(imported("by new", "new", "portrait.mov").empty());
        const RecordId camera = m_project->cameras().find("old")->id;
        QVERIFY(!m_project->cameras().currentRegistration(camera).value()->isUpright);
    }
};

ODOGRAPH_TEST(TestTurnedRecordings, QCoreApplication)
#include "tst_turned_recordings.moc"
