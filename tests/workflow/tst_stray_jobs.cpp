// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary.h"
#include "core/project/project.h"
#include "core/project/project_media.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/media_upkeep.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <fstream>

using namespace odo;
using namespace odo::test;

class TestStrayJobs : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_videos = std::make_unique<QTemporaryDir>();
        QCOMPARE(writeCoded(video(), evenTimes(30, 30), {}), QString());
    }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(*Project::create(path("p.odo"), "Strays"));
    }
    void cleanup() { m_project.reset(); }

    void whatBelongsToTheProjectIsNoStray()
    {
        QVERIFY(strays()->empty()); // without a media folder
        import("run", "A");
        CalibrationMedia media(m_project->mediaFolder());
        RegistrationRecord registration;
        registration.image = *media.write("A_floor", {1, 2, 3});
        QVERIFY(m_project->check(false)->empty()); // whoever made it holds it still
        media.keep();
        QCOMPARE(strays()->size(), std::size_t(1)); // nothing refers to it yet
        std::ofstream(path("p.media/recording.lock"));
        const auto problems = m_project->check(false).value();
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(problems[0].what.english(),
                 std::string("no trial, lens calibration or floor registration uses this file"));
        QCOMPARE(problems[0].where.english(), path("p.media/calibration/A_floor.png").string());
        QVERIFY(problems[0].advice.english().find("--adopt") != std::string::npos);
    }

    /// A copy of a project uses the first one's videos.
    void whatAProjectBesideUsesIsNoStray()
    {
        import("run", "A");
        QVERIFY(m_project->saveCopy(path("copy.odo")));
        const RecordId trial = m_project->trials().find("run")->id;
        QVERIFY(m_project->trials().setBinned(trial, true));
        QVERIFY(m_project->trials().removeForGood(trial));
        QVERIFY(strays()->empty());
        std::filesystem::resize_file(path("copy.odo"), 8192);
        const auto unknown = strays(); // nobody can tell
        QVERIFY(!unknown);
        QVERIFY2(unknown.error().why.english().starts_with(
                     "project 'copy.odo' beside it may use them, and cannot be read"),
                 unknown.error().why.english().c_str());
        std::ofstream(path("copy.odo"), std::ios::binary | std::ios::trunc) << "no project";
        QCOMPARE(strays()->size(), std::size_t(1));
    }

    /// It need not be called .odo.
    void noProjectIsKnownByItsEnding()
    {
        import("run", "A");
        m_project.reset();
        std::filesystem::rename(path("p.odo"), path("p.ODO"));
        m_project = std::move(*Project::create(path("p.odo"), "another"));
        QVERIFY(strays()->empty());
    }

    void aMissingRecordingIsNoStrayFile()
    {
        import("run", "A");
        import("lap", "A");
        std::filesystem::create_directory(path("p.media/old"));
        std::filesystem::rename(path("p.media/run_A.mkv"), path("p.media/old/elsewhere.mkv"));
        QVERIFY(strays()->empty());
        QVERIFY(find()->strays().empty());
        QCOMPARE(find()->others(), std::vector<std::filesystem::path>{path("p.media/old/elsewhere.mkv")});
        const auto problems = m_project->check(false).value();
        QVERIFY(std::ranges::any_of(problems, [](const ProjectProblem &problem) {
            return problem.what.english() == "this is a missing recording" &&
                   problem.advice.english().find("--find") != std::string::npos;
        }));
    }

    /// On a disk that is not there.
    void aLinkOfATrialIsNoStrayFile()
    {
        import("run", "A");
        std::filesystem::rename(path("p.media/run_A.mkv"), path("disk.mkv"));
        std::filesystem::create_symlink(path("disk.mkv"), path("p.media/run_A.mkv"));
        std::filesystem::rename(path("disk.mkv"), path("unplugged"));
        QVERIFY(strays()->empty());
    }

    void whatLiesInALinkedFolderIsNobodysStrayFile()
    {
        import("run", "A");
        m_project.reset();
        std::filesystem::create_directory(path("other"));
        std::filesystem::create_directory_symlink("../p.media", path("other/q.media"));
        m_project = std::move(*Project::create(path("other/q.odo"), "another"));
        QVERIFY(strays()->empty());
    }

    void aProjectInTheFolderIsNamedAndStays()
    {
        import("run", "A");
        {
            const auto inner = Project::create(path("inner.odo"), "inner");
            QVERIFY(inner);
        }
        std::filesystem::rename(path("inner.odo"), path("p.media/inner.odo"));
        std::filesystem::create_directory(path("p.media/inner.media"));
        copyHere("inner.media/x_A.mkv");
        QVERIFY(strays()->empty());
        const auto problems = m_project->check(false).value();
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(problems[0].what.english(), std::string("a project is in the media folder of another one"));
    }

    /// Where it lies, once.
    void aVideoInAFolderBelowBecomesATrial()
    {
        std::filesystem::create_directories(path("p.media/sub"));
        copyHere("sub/lap_A.mkv");
        AdoptStraysJob adopt(find()->videos());
        QVERIFY(runToEnd(adopt, *m_project, {}));
        QCOMPARE(m_project->trials().recordings(m_project->trials().find("recovered: lap")->id)->front().path,
                 std::string("p.media/sub/lap_A.mkv"));
        QVERIFY(find()->videos().empty());
    }

    void videosBecomeTrials()
    {
        QVERIFY(m_project->cameras().add({0, "left_1", ""}));
        import("run", "A");
        for (const char *name : {"lap_A.mkv", "lap_B.mkv", "turn_left_1.mkv", "single.mkv"})
            copyHere(name);
        std::ofstream(path("p.media/.new-abcdef.part"), std::ios::binary)
            << std::ifstream(video(), std::ios::binary).rdbuf();
        std::ofstream(path("p.media/notes.txt")) << "no video";
        std::filesystem::create_symlink(video(), path("p.media/link.mkv"));
        const auto found = find();
        QCOMPARE(found->strays().size(), std::size_t(6));
        QCOMPARE(found->others(), std::vector<std::filesystem::path>{path("p.media/notes.txt")});
        QCOMPARE(found->videos().size(), std::size_t(4)); // a link leads to what is somebody else's
        AdoptStraysJob adopt(found->videos());
        const auto done = runToEnd(adopt, *m_project, {});
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QVERIFY(adopt.failures().empty());
        QCOMPARE(adopt.trials(),
                 (std::vector<std::string>{"recovered: lap", "recovered: single", "recovered: turn"}));
        const auto views =
            m_project->trials().recordings(m_project->trials().find("recovered: lap")->id).value();
        QCOMPARE(views.size(), std::size_t(2));
        QCOMPARE(views[0].path, std::string("p.media/lap_A.mkv")); // where it was
        QCOMPARE(views[1].cameraName, std::string("B"));
        QCOMPARE(m_project->trials()
                     .recordings(m_project->trials().find("recovered: turn")->id)
                     ->front()
                     .cameraName,
                 std::string("left_1"));
        QCOMPARE(find()->strays().size(), std::size_t(2));
        // A name that is taken gets a number.
        copyHere("lap_C.mkv");
        AdoptStraysJob again(find()->videos());
        QVERIFY(runToEnd(again, *m_project, {}));
        QCOMPARE(again.trials(), std::vector<std::string>{"recovered: lap (2)"});
    }

    void onlyStrayFilesAreRemoved()
    {
        import("run", "A");
        for (const char *name : {"lap_A.mkv", "used.mkv", "written.mkv"})
            copyHere(name);
        std::filesystem::create_symlink(video(), path("p.media/link.mkv"));
        const auto found = find();
        QCOMPARE(found->strays().size(), std::size_t(4));
        AdoptStraysJob adopt({path("p.media/used.mkv")}); // meanwhile
        QVERIFY(runToEnd(adopt, *m_project, {}));
        const auto held = ClaimedFile::hold(path("p.media/written.mkv")); // by an import that has not ended
        RemoveStraysJob remove(found->strays());
        const auto done = runToEnd(remove, *m_project, {});
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(remove.removed(),
                 (std::vector<std::filesystem::path>{path("p.media/lap_A.mkv"), path("p.media/link.mkv")}));
        for (const char *name : {"run_A.mkv", "used.mkv", "written.mkv"})
            QVERIFY2(std::filesystem::exists(path("p.media") / name), name);
        QVERIFY(std::filesystem::exists(video()));
    }

    /// What is claimed by a living program is not stray.
    void whatIsBeingWrittenIsNotNamed()
    {
        std::filesystem::create_directories(path("p.media"));
        const auto claimed = ClaimedFile::create(path("p.media"), "run_A", ".mkv"),
                   begun = ClaimedFile::begin(path("p.media"));
        QVERIFY(claimed && begun);
        QVERIFY(strays()->empty());
        QVERIFY(!removeStray(*m_project, claimed->path()).value());
        QVERIFY(std::filesystem::exists(claimed->path()));
    }

    void cancelledItAddsNothing()
    {
        std::filesystem::create_directories(path("p.media"));
        copyHere("lap_A.mkv");
        JobControl control;
        control.cancel.cancel();
        AdoptStraysJob adopt({path("p.media/lap_A.mkv")});
        const auto done = runToEnd(adopt, *m_project, control);
        QVERIFY(!done && done.error().code == ErrorCode::Cancelled);
        QVERIFY(m_project->trials().all()->empty());
        QVERIFY(std::filesystem::exists(path("p.media/lap_A.mkv")));
    }

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }
    std::filesystem::path video() const { return m_videos->filePath(QStringLiteral("v.mkv")).toStdString(); }
    void copyHere(const char *name) const { std::filesystem::copy_file(video(), path("p.media") / name); }
    void import(const std::string &trial, const std::string &camera)
    {
        ImportSettings settings;
        settings.trial = trial;
        settings.videos = {{camera, video()}};
        ImportTrialJob job(std::move(settings));
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done, done ? "" : done.error().message().c_str());
    }
    Result<std::vector<std::filesystem::path>> strays()
    {
        return strayMedia(*m_project).map(&StrayMedia::files);
    }
    std::unique_ptr<FindStraysJob> find()
    {
        auto job = std::make_unique<FindStraysJob>();
        const auto done = runToEnd(*job, *m_project, {});
        if (!done)
            qWarning("%s", done.error().message().c_str());
        return job;
    }

    std::unique_ptr<QTemporaryDir> m_videos, m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestStrayJobs, QCoreApplication)
#include "tst_stray_jobs.moc"
