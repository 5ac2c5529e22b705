// SPDX-License-Identifier: GPL-3.0-or-later
// Trials in lists of many: all of them, page by page, their names, and one figure of each.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

const Instant newYear{std::chrono::milliseconds(1'767'222'000'000)};

std::vector<std::string> namesOf(const std::vector<TrialRecord> &trials)
{
    std::vector<std::string> names;
    for (const TrialRecord &trial : trials)
        names.push_back(trial.name);
    return names;
}

} // namespace

class TestTrialLists : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project =
            std::move(*Project::create(m_folder->filePath(QStringLiteral("year.odo")).toStdString(), "Year"));
        RobotRecord robot;
        robot.name = "Red";
        m_red = m_project->robots().add(robot).value().id;
        robot.name = "Blue";
        m_blue = m_project->robots().add(robot).value().id;
        m_team = m_project->teams().add({0, "Anna and Ben", "9B", "Team 4"}).value().id;
    }

    /// Robots in the trial's own order, tags in that of the alphabet, each with its own trial.
    void listsComeWithTheirTrials()
    {
        addTrial("first", 0, {m_blue, m_red});
        addTrial("second", 1, {});
        addTrial("third", 2, {m_red});
        QVERIFY(m_project->trials().setTags(m_trials.at("third"), {"wet", "final"}));
        QVERIFY(m_project->trials().setTags(m_trials.at("first"), {"slow"}));
        const auto all = m_project->trials().all().value();
        QCOMPARE(namesOf(all), (std::vector<std::string>{"third", "second", "first"}));
        QCOMPARE(all[2].robotNames, (std::vector<std::string>{"Blue", "Red"}));
        QCOMPARE(all[2].robots, (std::vector<RecordId>{m_blue, m_red}));
        QVERIFY(all[1].robots.empty() && all[1].tags.empty());
        QCOMPARE(all[0].tags, (std::vector<std::string>{"final", "wet"}));
        QCOMPARE(all[2].tags, std::vector<std::string>{"slow"});
        QCOMPARE(all[0].teamPseudonym, std::string("Team 4"));
        QCOMPARE(m_project->trials().find("first")->robotNames, all[2].robotNames);
        QCOMPARE(m_project->trials().get(m_trials.at("third"))->tags, all[0].tags);
    }

    void recordingsOfAllTrialsComeWithoutTimes()
    {
        addRecordings();
        const auto all = m_project->trials().allRecordings().value();
        QCOMPARE(all.size(), std::size_t(3));
        QCOMPARE(all[0].trial, m_trials.at("new"));
        QCOMPARE(all[1].cameraName, std::string("A"));
        QCOMPARE(all[2].cameraName, std::string("B"));
        QVERIFY(all[0].frameTimes.empty());
        QVERIFY(Project::create(m_folder->filePath(QStringLiteral("none.odo")).toStdString(), "None")
                    .value()
                    ->trials()
                    .allRecordings()
                    ->empty());
    }

    void theNewestRecordingOfACameraIsFoundByDate()
    {
        addRecordings();
        const auto ofA = m_project->trials().newestRecording(m_cameraA).value();
        QVERIFY(ofA);
        QCOMPARE(ofA->trial, m_trials.at("new"));
        QCOMPARE(ofA->frameTimes.size(), std::size_t(2));
        QCOMPARE(m_project->trials().newestRecording(m_cameraB).value()->trial, m_trials.at("old"));
        QVERIFY(!m_project->trials().newestRecording(m_project->cameras().add({0, "C", ""})->id).value());
        QVERIFY(m_project->trials().setBinned(m_trials.at("new"), true));
        QCOMPARE(m_project->trials().newestRecording(m_cameraA).value()->trial, m_trials.at("old"));
    }

    /// Pages put together are the whole list, whatever shares a moment.
    void pagesAreTheWhole_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 3, 7, 100})
            QTest::addRow("%d", count) << count;
    }
    void pagesAreTheWhole()
    {
        QFETCH(const int, count);
        for (int i = 0; i < 12; ++i)
            addTrial("trial " + std::to_string(i), i / 3, {m_red}); // three of each moment
        QVERIFY(m_project->trials().setTags(m_trials.at("trial 5"), {"good"}));
        std::vector<TrialRecord> put;
        for (;;) {
            const auto page = m_project->trials().page(put.empty() ? nullptr : &put.back(), count).value();
            if (page.empty())
                break;
            QVERIFY(static_cast<int>(page.size()) >= std::min<int>(count, 12 - static_cast<int>(put.size())));
            QVERIFY(static_cast<int>(page.size()) <= count + 2);
            put.insert(put.end(), page.begin(), page.end());
        }
        const auto all = m_project->trials().all().value();
        QCOMPARE(namesOf(put), namesOf(all));
        for (std::size_t i = 0; i < all.size(); ++i)
            QVERIFY(put[i].robots == all[i].robots && put[i].tags == all[i].tags);
    }

    void anEmptyProjectHasNoPages()
    {
        QVERIFY(m_project->trials().page(nullptr, 10)->empty());
        QVERIFY(m_project->trials().names()->empty());
        QVERIFY(m_project->analyses().metricNames()->empty());
    }

    void namesTellWhatAChoiceNeeds()
    {
        addTrial("old", 0, {});
        addTrial("new", 1, {});
        QVERIFY(m_project->trials().setBinned(m_trials.at("old"), true));
        TrialRecord begun;
        begun.name = "now";
        begun.date = newYear + std::chrono::hours(5);
        QVERIFY(m_project->trials().begin(begun, {}));
        const auto names = m_project->trials().names().value();
        QCOMPARE(names.size(), std::size_t(3));
        QVERIFY(names[0].name == "now" && names[0].unfinished && !names[0].binned &&
                names[0].teamName.empty());
        QVERIFY(names[1].name == "new" && !names[1].unfinished && names[1].teamName == "Anna and Ben");
        QVERIFY(names[2].name == "old" && names[2].binned && names[2].id == m_trials.at("old"));
    }

    /// Of a trial that was analysed again the newest figure counts, each robot by itself.
    void figuresAreOfTheNewestAnalyses()
    {
        addTrial("first", 0, {m_red, m_blue});
        addTrial("second", 1, {m_red});
        addTrial("third", 2, {m_red});
        analyse("first", m_red, 1.5);
        analyse("first", m_blue, 2.5);
        analyse("first", m_red, 1.75);
        analyse("third", m_red, 3);
        const auto read = [&](int from, int to) {
            std::vector<std::tuple<RecordId, RecordId, double>> rows;
            const auto trialMetrics = m_project->analyses().trialMetrics(
                "max_speed", newYear + std::chrono::hours(from), newYear + std::chrono::hours(to));
            for (const TrialMetric &trialMetric : trialMetrics.value())
                rows.emplace_back(trialMetric.trial, trialMetric.robot, trialMetric.metric.value);
            return rows;
        };
        using Rows = std::vector<std::tuple<RecordId, RecordId, double>>;
        const RecordId first = m_trials.at("first"), third = m_trials.at("third");
        QCOMPARE(read(0, 2), (Rows{{first, m_red, 1.75}, {first, m_blue, 2.5}, {third, m_red, 3}}));
        QCOMPARE(read(1, 2), (Rows{{third, m_red, 3}}));
        QCOMPARE(read(1, 1), Rows());
        QCOMPARE(m_project->analyses().metricNames().value(),
                 (std::vector<std::string>{"duration", "max_speed"}));
    }

private:
    /// Two trials, stored the other way round than they were driven.
    void addRecordings()
    {
        m_cameraA = m_project->cameras().add({0, "A", ""}).value().id;
        m_cameraB = m_project->cameras().add({0, "B", ""}).value().id;
        const auto add = [this](const char *name, int hour, const std::vector<RecordId> &cameras) {
            TrialRecord trial;
            trial.name = name;
            trial.date = newYear + std::chrono::hours(hour);
            std::vector<RecordingRecord> recordings;
            for (const RecordId camera : cameras) {
                RecordingRecord recording;
                recording.camera = camera;
                recording.path = "year.media/" + std::string(name) + std::to_string(camera) + ".mkv";
                recording.frameTimes = {Nanoseconds(0), Nanoseconds(33'000'000)};
                recordings.push_back(std::move(recording));
            }
            const auto added = m_project->trials().add(trial, recordings);
            QVERIFY2(added, added ? "" : added.error().message().c_str());
            m_trials[name] = added->id;
        };
        add("new", 5, {m_cameraA});
        add("old", 1, {m_cameraA, m_cameraB});
    }
    void addTrial(const std::string &name, int hour, const std::vector<RecordId> &robots)
    {
        TrialRecord trial;
        trial.name = name;
        trial.team = m_team;
        trial.date = newYear + std::chrono::hours(hour);
        trial.robots = robots;
        m_trials[name] = m_project->trials().add(trial, {}).value().id;
    }
    void analyse(const std::string &trial, RecordId robot, double speed)
    {
        AnalysisRecord analysis;
        analysis.trial = m_trials.at(trial);
        analysis.robot = robot;
        analysis.profile.metrics = {{"duration", "s", 9, {}}, {"max_speed", "m/s", speed, 0.01}};
        QVERIFY(m_project->analyses().add(analysis));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    RecordId m_red = 0, m_blue = 0, m_team = 0, m_cameraA = 0, m_cameraB = 0;
    std::map<std::string, RecordId> m_trials;
};

ODOGRAPH_TEST(TestTrialLists, QCoreApplication)
#include "tst_trial_lists.moc"
