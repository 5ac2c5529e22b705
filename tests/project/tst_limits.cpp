// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/names.h"

#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using Access = Project::Access;

/// Texts, counts and numbers are bounded when they are entered, and when a file that another program wrote is
/// read.
class TestLimits : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("a.odo")).toStdString();
        m_project = std::move(*Project::create(m_file, "title"));
        QVERIFY(m_project->robots().add(robotNamed("red")));
        QVERIFY(m_project->layouts().add(
            {"floor", {{"O", {0, 0}}, {"U", {1, 0}}, {"V", {0, 1}}, {"W", {1, 1}}}}));
        QVERIFY(m_project->cameras().add({0, "A", ""}));
        TrialRecord trial;
        trial.name = "run";
        QVERIFY(m_project->trials().add(trial, {}));
    }

    void namesAreStoredAndFoundInOneForm()
    {
        const std::string composed = "Zoë", decomposed = "Zoe\u0308";
        QVERIFY(m_project->robots().add(robotNamed(" " + decomposed + "\u00a0")));
        QCOMPARE(m_project->robots().find(decomposed)->name, composed);
        QCOMPARE(m_project->robots().find(" " + composed)->name, composed);
        QCOMPARE(m_project->robots().add(robotNamed(composed)).error().code, ErrorCode::AlreadyExists);
        QCOMPARE(m_project->robots().add(robotNamed(decomposed)).error().code, ErrorCode::AlreadyExists);
        const auto team = m_project->teams().add({0, "Falcon ", decomposed, {}, {decomposed}});
        QCOMPARE(team->name, std::string("Falcon"));
        QCOMPARE(team->members.front(), composed);
        QCOMPARE(m_project->teams().find("Falcon")->className, composed);
        QVERIFY(m_project->trials().setTags(1, {decomposed, composed, "a "}));
        QCOMPARE(m_project->trials().get(1)->tags, (std::vector<std::string>{composed, "a"}));
        QVERIFY(m_project->trials().setTask(1, decomposed) && m_project->trials().setTask(1, composed));
        QCOMPARE(m_project->tasks().all()->size(), std::size_t(1));
    }

    void aTitleIsEnteredAndReadAsAName()
    {
        QVERIFY(m_project->setTitle(" Zoe\u0308 \u00a0"));
        QCOMPARE(m_project->title().value(), std::string("Zoë"));
        const std::pair<std::string, const char *> refused[] = {
            {"", "it is empty"},
            {" \u00a0 ", "it is empty"},
            {"a\nb", "it holds a line break or another control character"},
            {"T\x1b[31m", "it holds a line break or another control character"},
            {"a\u202eb", "it holds an invisible character, U+202E"},
            {std::string(201, 'x'), "it has 201 characters"},
            {"\xff", "it is not valid UTF-8 text"}};
        for (const auto &[title, why] : refused) {
            const auto set = m_project->setTitle(title);
            const auto made =
                Project::create(m_folder->filePath(QStringLiteral("b.odo")).toStdString(), title);
            QVERIFY(!set && !made);
            QCOMPARE(set.error().why.english(), std::string(why));
            QCOMPARE(made.error().message(), set.error().message());
            QCOMPARE(set.error().what.english(), std::string("title of the project"));
            QCOMPARE(m_project->title().value(), std::string("Zoë"));
        }
        QVERIFY(!QFile::exists(m_folder->filePath(QStringLiteral("b.odo"))));
    }

    void aTitleOfAnOlderProjectIsShownAsAName()
    {
        const auto shown = [&](const char *change) {
            run(change);
            return m_project->title().value();
        };
        QCOMPARE(
            shown("UPDATE property SET value='T'||char(27)||'[31m'||char(8238)||'itle'||char(10)||'next'"),
            std::string("T\\x1b[31m‹U+202E›itle\\x0anext"));
        QCOMPARE(shown("UPDATE property SET value=hex(zeroblob(500))"), std::string(199, '0') + "…");
        QCOMPARE(shown("UPDATE property SET value='  '"), std::string("a")); // what the file is called
        QCOMPARE(shown("DELETE FROM property"), std::string("a"));
    }

    void aFilesNameGivesATitle_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("title");
        QTest::newRow("ordinary") << QByteArray("x/Year 9.odo") << QByteArray("Year 9");
        QTest::newRow("hidden") << QByteArray("a\nb\xe2\x80\xae.odo") << QByteArray("a\\x0ab‹U+202E›");
        QTest::newRow("bytes") << QByteArray("a\xff.odo") << QByteArray("a\\xff");
        QTest::newRow("blank") << QByteArray("  .odo") << QByteArray(".odo");
        QTest::newRow("long") << QByteArray(250, 'n') + ".odo" << QByteArray(199, 'n') + "…";
    }
    void aFilesNameGivesATitle()
    {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, title);
        QCOMPARE(titleFromName(file.toStdString()), title.toStdString());
        QVERIFY(checkTitle(titleFromName(file.toStdString())));
    }

    void namesOfOtherProgramsAreShownAndFound()
    {
        run("UPDATE robot SET name='Zoe\u0308'");
        run("UPDATE camera SET name=char(27)||'[2J'||char(8238)||char(10)||'x'");
        run("UPDATE trial SET name=char(8203)");
        QCOMPARE(m_project->robots().find("Zoë")->id, RecordId(1));
        QCOMPARE(m_project->robots().add(robotNamed("Zoë")).error().code, ErrorCode::AlreadyExists);
        const auto cameras = m_project->cameras().all();
        QCOMPARE(cameras->front().name, std::string("\\x1b[2J‹U+202E›\\x0ax"));
        QCOMPARE(m_project->cameras().find(cameras->front().name)->id, RecordId(1));
        QCOMPARE(m_project->trials().find("‹U+200B›")->id, RecordId(1));
        QCOMPARE(m_project->trials().names()->front().name, std::string("‹U+200B›"));
    }

    void longTextsAreCut()
    {
        run("UPDATE robot SET name=hex(zeroblob(2500000))");
        run("UPDATE trial SET notes=hex(zeroblob(500000))");
        const auto robot = m_project->robots().get(1);
        QCOMPARE(robot->name, std::string(maxNameLength - 1, '0') + "…");
        QVERIFY(m_project->robots().set(*robot)); // as it is shown it may stay
        QCOMPARE(m_project->robots().find(robot->name)->id, RecordId(1));
        QCOMPARE(m_project->trials().get(1)->notes, std::string(maxTextLength - 1, '0') + "…");
        const auto refused = m_project->trials().setNotes(1, std::string(maxTextLength + 1, 'n'));
        QCOMPARE(refused.error().message(),
                 std::string("notes of a trial: it has 20001 characters; use at most 20000"));
        std::string emoji;
        for (int i = 0; i < maxTextLength; ++i)
            emoji += "🤖";
        QVERIFY(m_project->trials().setNotes(1, emoji));
        QVERIFY(m_project->trials().get(1)->notes == emoji);
    }

    void numbersAreBounded()
    {
        run("UPDATE marker SET x_m=1e300, y_m=-9e999 WHERE label='O'");
        run("UPDATE robot SET height_m=1e300, length_m=9e999, width_m=-1");
        run("UPDATE trial SET duration_s=9e999, sync_score=-1e300");
        const auto marker = m_project->layouts().find("floor")->layout.markers.front();
        QVERIFY(marker.pointInWorld == Eigen::Vector2d(1000, -1000));
        const auto robot = m_project->robots().get(1);
        QVERIFY(robot->heightM == 10.0 && robot->lengthM == 10.0 && robot->widthM == 0.0);
        QVERIFY(m_project->trials().get(1)->durationS == largestNumber &&
                m_project->trials().get(1)->syncScore == -largestNumber);

        TrialRecord trial = *m_project->trials().get(1);
        for (const double value : {1e13, -1e300, std::nan(""), double(INFINITY)}) {
            trial.syncOffsetS = value;
            QCOMPARE(m_project->trials().setSync(trial, {}).error().why.english(),
                     std::string("a value to store is too large or not a number"));
        }
        RobotRecord large = robotNamed("large");
        large.lengthM = 11;
        QCOMPARE(m_project->robots().add(large).error().message(),
                 std::string("robot 'large': it is larger than 10 m; check the numbers"));
    }

    void markersAreOnAFloor()
    {
        const auto far = m_project->layouts().add({"far", {{"O", {0, 0}}, {"U", {1e300, 0}}}});
        QCOMPARE(far.error().message(),
                 std::string("layout 'far': marker 'U' is not within a floor of 1 km; check the numbers"));
        auto layout = *m_project->layouts().find("floor");
        layout.layout.markers[1].pointInWorld.x() = 1001;
        QCOMPARE(m_project->layouts().setPoints(layout).error().why.english(),
                 std::string("marker 'U' is not within a floor of 1 km"));
        MarkerLayout many{"many", {}};
        for (std::size_t i = 0; i <= mostMarkers; ++i)
            many.markers.push_back({std::to_string(i), {0, 0}});
        QCOMPARE(m_project->layouts().add(many).error().why.english(),
                 std::string("it has more than 1000 markers"));
    }

    void countsAreBounded()
    {
        const std::string count =
            "WITH RECURSIVE n(i) AS (SELECT 100 UNION ALL SELECT i + 1 FROM n WHERE i < 5000) ";
        run(count + "INSERT INTO recording (trial_id, camera_id, position, path, sha256, bytes, width_px, "
                    "height_px, frames_per_second, start_offset_s) "
                    "SELECT 1, 1, i, 'a.mp4', '', 0, 2000000000, -7, 1e300, 0 FROM n");
        run(count + "INSERT INTO marker SELECT 1, i, 'M' || i, 0, 0 FROM n");
        run(count + "INSERT INTO robot (name, colour, height_mode) SELECT 'r' || i, '#ff0000', height_mode "
                    "FROM n, robot WHERE robot.id=1");
        run("INSERT INTO trial_robot SELECT 1, id, id FROM robot");
        run(count + "INSERT INTO trial_tag SELECT 1, 'tag' || i FROM n");
        const auto recordings = m_project->trials().recordings(1);
        QCOMPARE(recordings->size(), mostViews);
        QVERIFY(recordings->front().framesPerSecond == highestFrameRate &&
                recordings->front().widthPx == 32'000 && recordings->front().heightPx == 0);
        const auto trial = m_project->trials().get(1);
        QCOMPARE(trial->viewCount, int(mostViews));
        QCOMPARE(trial->robots.size(), mostRobots);
        QCOMPARE(trial->tags.size(), mostTags);
        QCOMPARE(m_project->layouts().find("floor")->layout.markers.size(), mostMarkers);

        TrialRecord other;
        other.name = "other";
        RecordingRecord view;
        view.path = "a.mp4";
        view.camera = 1;
        QCOMPARE(m_project->trials().add(other, std::vector(17, view)).error().message(),
                 std::string("trial 'other': it has 17 views; use at most 16"));
        QCOMPARE(m_project->trials().setRobots(1, std::vector<RecordId>(33, 1)).error().why.english(),
                 std::string("it has 33 robots"));
    }

    /// One task that cannot be used is one, not all.
    void aTaskThatCannotBeUsedHasNoCourse()
    {
        Task course;
        course.gates = {{"start", GateRole::Start, {0, 0}, {0, 1}}};
        QVERIFY(m_project->tasks().add({0, "good", course}) && m_project->tasks().add({0, "bad", course}));
        run("UPDATE gate SET from_x_m=1e300 WHERE task_id=2");
        const auto tasks = m_project->tasks().all();
        QCOMPARE(tasks->size(), std::size_t(2));
        QCOMPARE((*tasks)[0].task.gates.size(), std::size_t(1));
        QVERIFY((*tasks)[1].task.gates.empty());
        QCOMPARE(m_project->tasks().find("bad")->name, std::string("bad"));
        const auto problems = m_project->check(false);
        QCOMPARE(problems->size(), std::size_t(1));
        QCOMPARE(problems->front().what.english(),
                 std::string("task 'bad': gate 'start': its ends are not both on a floor of 1 km"));
    }

    void checkNamesWhatIsBeyondLimits()
    {
        QVERIFY(m_project->check(false)->empty());
        run("UPDATE robot SET name=hex(zeroblob(2500000)), height_m=-1e300");
        run("UPDATE marker SET x_m=1e300");
        run("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 51) INSERT INTO "
            "trial_tag SELECT 1, 'tag' || i FROM n");
        const auto problems = m_project->check(false);
        std::vector<std::string> found;
        for (const ProjectProblem &problem : *problems)
            found.push_back(problem.what.english());
        QCOMPARE(found, (std::vector<std::string>{"robot.name: texts of more than 200 characters: 1",
                                                  "marker.x_m: numbers beyond 1000: 4",
                                                  "robot.height_m: numbers beyond 10: 1",
                                                  "trial_tag: more than 50 of one trial: 51"}));
    }

private:
    static RobotRecord robotNamed(const std::string &name)
    {
        RobotRecord robot;
        robot.name = name;
        return robot;
    }
    /// As another program would.
    void run(const std::string &sql)
    {
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        const auto done = (*connection)->execute(QString::fromStdString(sql));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestLimits, QCoreApplication)
#include "tst_limits.moc"
