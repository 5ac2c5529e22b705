// SPDX-License-Identifier: GPL-3.0-or-later
// A project and its media folder by other names than those they were made under.
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;

class TestRenamedProject : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto project = Project::create(path("demo.odo"), "Demo");
        QVERIFY(project);
        std::filesystem::create_directories(path("demo.media/calibration"));
        std::ofstream(path("demo.media/x.mkv")) << "video";
        addTrial(**project, "one", "demo.media/x.mkv");
    }

    void renamedWithItsMediaFolder()
    {
        std::filesystem::rename(path("demo.odo"), path("school.odo"));
        std::filesystem::rename(path("demo.media"), path("school.media"));
        const auto project = Project::open(path("school.odo"), Project::Access::ReadWrite);
        QCOMPARE((*project)->resolve(onlyRecording(**project)), path("school.media/x.mkv"));
        QVERIFY((*project)->check(false)->empty());
        // What comes in now is called by today's name, and one file is one file.
        addTrial(**project, "two", path("school.media/x.mkv").string());
        QCOMPARE((*project)->trials().allRecordings()->back().path, std::string("school.media/x.mkv"));
        QVERIFY((*project)->trials().isFileUsed("school.media/x.mkv").value());
        QVERIFY((*project)->trials().setBinned((*project)->trials().find("two")->id, true));
        QVERIFY((*project)->trials().removeForGood((*project)->trials().find("two")->id));
        // by the first, as demo.media/x.mkv
        QVERIFY((*project)->trials().isFileUsed("school.media/x.mkv").value());
        QVERIFY(!(*project)->trials().isFileUsed("school.media/y.mkv").value());
    }

    /// Only the project was copied: its videos are where they were.
    void aCopyFindsWhatIsThere()
    {
        std::filesystem::copy_file(path("demo.odo"), path("copy.odo"));
        std::filesystem::create_directories(path("copy.media"));
        std::ofstream(path("copy.media/x.mkv")) << "another";
        const auto project = Project::open(path("copy.odo"), Project::Access::ReadOnly);
        QCOMPARE((*project)->resolve(onlyRecording(**project)), path("demo.media/x.mkv"));
    }

    /// Nothing else is looked for elsewhere.
    void whatIsGoneIsNamedAsItWas()
    {
        std::filesystem::rename(path("demo.odo"), path("school.odo"));
        std::filesystem::remove_all(path("demo.media"));
        std::filesystem::create_directories(path("school.media"));
        std::ofstream(path("school.media/other.mkv")) << "video";
        const auto project = Project::open(path("school.odo"), Project::Access::ReadOnly);
        QCOMPARE((*project)->resolve(onlyRecording(**project)), path("demo.media/x.mkv"));
        const auto problems = (*project)->check(false).value();
        QCOMPARE(problems.size(), std::size_t(2));
        QCOMPARE(problems[0].what.english(), std::string("the recording of view 'A' is missing"));
        QVERIFY(problems[0].advice.english().find("--find") != std::string::npos);
        QCOMPARE(problems[1].where, fileSubject(path("school.media/other.mkv")));
        QCOMPARE(absolutePath(path("school.odo"), "demo.media/../../etc/x"), path("x"));
        QCOMPARE(absolutePath(path("school.odo"), "videos/other.mkv"), path("videos/other.mkv"));
    }

    /// The media folder lies beside the file itself, by whatever name it was opened.
    void openedThroughALink()
    {
        std::filesystem::create_directories(path("desk"));
        std::filesystem::create_symlink(path("demo.odo"), path("desk/lesson.odo"));
        const auto project = Project::open(path("desk/lesson.odo"), Project::Access::ReadWrite);
        QVERIFY2(project, project ? "" : project.error().message().c_str());
        QCOMPARE((*project)->mediaFolder(), path("demo.media"));
        QCOMPARE((*project)->resolve(onlyRecording(**project)), path("demo.media/x.mkv"));
        QVERIFY((*project)->check(false)->empty());
        std::ofstream(path("demo.media/y.mkv")) << "video";
        addTrial(**project, "two", ((*project)->mediaFolder() / "y.mkv").string());
        QCOMPARE((*project)->trials().allRecordings()->back().path, std::string("demo.media/y.mkv"));
    }

    /// A folder may have two names too.
    void aFileNamedThroughALinkedFolderIsStoredRelative()
    {
        std::filesystem::create_directories(path("school/demo.media"));
        std::filesystem::create_directory_symlink(path("school"), path("desk"));
        QCOMPARE(storedPath(path("school/demo.odo"), path("desk/demo.media/x.mkv")),
                 std::string("demo.media/x.mkv"));
        QCOMPARE(storedPath(path("desk/demo.odo"), path("school/demo.media/x.mkv")),
                 std::string("demo.media/x.mkv"));
        QCOMPARE(storedPath(path("school/demo.odo"), path("demo.media/x.mkv")),
                 path("demo.media/x.mkv").string());
    }

private:
    std::filesystem::path path(const std::string &name = {}) const
    {
        const std::filesystem::path folder = m_folder->path().toStdString();
        return name.empty() ? folder : folder / name;
    }
    static RecordingRecord onlyRecording(Project &project)
    {
        return project.trials().allRecordings()->front();
    }
    static void addTrial(Project &project, const std::string &name, const std::string &file)
    {
        const auto known = project.cameras().find("A");
        TrialRecord trial;
        trial.name = name;
        RecordingRecord recording;
        recording.camera = known ? known->id : project.cameras().add({0, "A", ""})->id;
        recording.path = file;
        recording.bytes = 5;
        recording.frameTimes = {Nanoseconds{0}};
        QVERIFY(project.trials().add(trial, {recording}));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

ODOGRAPH_TEST(TestRenamedProject, QCoreApplication)
#include "tst_renamed_project.moc"
