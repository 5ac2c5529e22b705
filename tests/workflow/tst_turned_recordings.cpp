// SPDX-License-Identifier: GPL-3.0-or-later
// Clips whose files say that they are to be turned: new ones are measured upright, those of older projects as
// they were, which is told.
#include "core/geometry/camera_model.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/frame_turn.h"
#include "core/video/image.h"
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
    void registerCamera(const std::string &name, bool isUpright, const StoredImage &image)
    {
        CameraRecord camera;
        camera.name = name;
        MarkerLayout layout;
        layout.name = "floor of " + name;
        layout.markers = {{"O", {0, 0}}, {"U", {1, 0}}, {"V", {0, 1}}};
        RegistrationRecord record;
        record.camera = m_project->cameras().add(camera)->id;
        record.layout = m_project->layouts().add(layout)->id;
        record.assumedIntrinsics = CameraModel::assumed(192, 96).intrinsics();
        record.registration.intrinsics = record.assumedIntrinsics;
        record.registration.worldFromCamera.translation = {0, 0, 2};
        record.registration.poseCovariance.setZero();
        record.isUpright = isUpright;
        record.image = image;
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
        QCOMPARE(
            storedFrameWarning("old", old, path("portrait.mov")).english(),
            std::string("view 'A' in trial 'old': an earlier version measured its frames as stored, but "
                        "its file says to turn, mirror or stretch them; import the video again to measure it "
                        "as it is shown"));
        QVERIFY(storedFrameWarning("old plain", plain, path("plain.mkv")).isEmpty());
        const auto problems = turnedRecordings(*m_project, Opened::NeverTurned).value();
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(problems[0].where.english(), std::string("view 'A' in trial 'old'"));
        RegisteredView view;
        view.recording = old;
        view.file = path("portrait.mov");
        QCOMPARE(turnedWarnings("old", {view}).size(), std::size_t(1));
    }

    void anOldRegistrationMayBeOfFramesAsStored_data()
    {
        QTest::addColumn<bool>("isUpright");
        QTest::addColumn<int>("seenIn"); ///< orientation of its image; 0: none is kept
        QTest::addColumn<bool>("isDoubtful");
        QTest::newRow("by this version") << true << 0 << false;
        QTest::newRow("without an image") << false << 0 << true;
        QTest::newRow("by an upright image") << false << 1 << false;
        QTest::newRow("by frames as stored") << false << 3 << true;
    }
    void anOldRegistrationMayBeOfFramesAsStored()
    {
        QFETCH(bool, isUpright);
        QFETCH(int, seenIn);
        QFETCH(bool, isDoubtful);
        QVERIFY(remux(path("plain.mkv"), path("half.mov"), {-1, 0, 0, -1}));
        const Frame upright = (*VideoReader::open(path("half.mov")))->frameAt(0).value();
        const std::string camera = QTest::currentDataTag();
        StoredImage image;
        if (seenIn != 0) {
            image.path = path(camera + ".png").string();
            QVERIFY(writeImage(turned(upright, seenIn), path(camera + ".png")));
        }
        registerCamera(camera, isUpright, image);
        std::vector<std::string> expected;
        if (isDoubtful)
            expected = {"view '" + camera + "' in trial '" + camera +
                        "': its frames are turned or mirrored as its file says, but an earlier version "
                        "registered camera '" +
                        camera + "', perhaps by frames as stored; register the camera again"};
        QCOMPARE(imported(camera, camera, "half.mov"), expected);
        const RecordId id = m_project->cameras().find(camera)->id;
        QCOMPARE(m_project->cameras().currentRegistration(id).value()->isUpright, isUpright);
    }

    /// Told at once, and what to do; the window and the command line show the same.
    void aLensOfAnotherSizeIsTold()
    {
        CameraRecord camera;
        camera.name = "stills";
        IntrinsicsRecord lens;
        lens.camera = m_project->cameras().add(camera)->id;
        lens.calibration.intrinsics = CameraModel::assumed(4032, 3024).intrinsics();
        QVERIFY(m_project->cameras().addIntrinsics(lens));
        QCOMPARE(
            imported("by stills", "stills", "plain.mkv"),
            std::vector<std::string>{
                "view 'stills' in trial 'by stills': its frames are 192×96, but the lens was calibrated at "
                "4032×3024; register the camera in a frame of this video, to which its lens calibration "
                "is then fitted"});
        registerCamera("other", true, {});
        QCOMPARE(
            imported("by other", "other", "portrait.mov").front(),
            std::string("view 'other' in trial 'by other': its frames are 96×192, but the camera was "
                        "registered at 192×96; register the camera in a frame of this video, to which its "
                        "lens calibration is then fitted"));
    }
};

ODOGRAPH_TEST(TestTurnedRecordings, QCoreApplication)
#include "tst_turned_recordings.moc"
