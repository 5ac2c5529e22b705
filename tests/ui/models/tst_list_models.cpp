// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/camera_lists.h"
#include "ui/models/internal/row_table_model.h"
#include "ui/models/project_changes.h"
#include "ui/models/results.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_model.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QItemSelection>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

using namespace odo;

namespace {

constexpr auto strict = QAbstractItemModelTester::FailureReportingMode::QtTest;

TrialRow trialRow(const char *name, std::int64_t minute, std::optional<double> topSpeed)
{
    TrialRow row;
    row.trial.name = name;
    row.trial.teamName = "Falcon";
    row.trial.date = Instant(std::chrono::minutes(minute));
    row.trial.robotNames = {"Red 2", "Blue 1"};
    row.trial.durationS = 9.84;
    row.trial.notes = "New wheels";
    row.trial.id = minute;
    if (topSpeed)
        row.topSpeed = Metric{"max_speed", "m/s", *topSpeed, 0.02};
    row.searchText = searchTextOf(row.trial);
    return row;
}

/// Whether a dataChanged named this cell.
bool isTold(const QSignalSpy &changed, const QModelIndex &cell)
{
    return std::ranges::any_of(changed, [&](const QList<QVariant> &one) {
        return QItemSelectionRange(one.value(0).toModelIndex(), one.value(1).toModelIndex()).contains(cell);
    });
}

QString shownNames(const TrialModel &model)
{
    QString names;
    for (int row = 0; row < model.rowCount(); ++row)
        names += model.index(row, TrialModel::NameColumn).data().toString();
    return names;
}

CameraRow cameraRow(const char *name, std::optional<double> rmsM)
{
    CameraRow row;
    row.camera.name = name;
    if (rmsM) {
        row.registration.emplace();
        row.registration->registration.rmsM = *rmsM;
        row.registration->registration.verdict = foreignWords("Good <b>");
    }
    return row;
}

} // namespace

class TestListModels : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Of the whole tree, wherever its test lies.
    void everyModelIsTested()
    {
        const QDir tree(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"));
        const auto contents = [&tree](const QString &folder, const QStringList &names) {
            QStringList texts;
            QDirIterator files(tree.filePath(folder), names, QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext())
                if (QFile file(files.next()); file.open(QIODevice::ReadOnly))
                    texts << QString::fromUtf8(file.readAll());
            return texts;
        };
        const QStringList tests = contents(QStringLiteral("tests"), {QStringLiteral("tst_*.cpp")})
                                      .filter(QStringLiteral("QAbstractItemModelTester"));
        static const QRegularExpression definition(QStringLiteral(
            "class (\\w+)(?: final)? : public "
            "(?:QAbstract\\w*Model|RowTableModel|Q\\w*ProxyModel|QStandardItemModel|QStringListModel)\\b"));
        QStringList models;
        for (const QString &text :
             contents(QStringLiteral("ui"), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}))
            for (auto found = definition.globalMatch(text); found.hasNext();)
                models << found.next().captured(1);
        models.removeAll(QStringLiteral("RowTableModel")); // is the base of others
        QVERIFY2(models.size() >= 8, qPrintable(models.join(u' ')));
        for (const QString &model : std::as_const(models))
            QVERIFY2(!tests.filter(QRegularExpression(QStringLiteral("\\b%1 \\w+[;(]").arg(model))).isEmpty(),
                     qPrintable(model + QStringLiteral(" has no QAbstractItemModelTester")));
    }
    void spikes()
    {
        SpikeModel model;
        QAbstractItemModelTester tester(&model, strict);
        QCOMPARE(model.summary(), QStringLiteral("none"));
        model.setScene(exampleScene({.frames = 300}));
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.summary(), QStringLiteral("2 flagged · 1 restored"));
        const QModelIndex first = model.index(0, SpikeModel::TimeColumn);
        QCOMPARE(first.data().toString(), QStringLiteral("3.30\u00a0s"));
        QCOMPARE(first.data(SpikeModel::SampleIndexRole).toLongLong(), 99);
        QVERIFY(model.index(2, SpikeModel::ReasonColumn)
                    .data()
                    .toString()
                    .contains(QStringLiteral("restored by hand")));
        QVERIFY(model.index(2, 0).data(SpikeModel::RestoredRole).toBool());
        model.setScene(nullptr);
        QCOMPARE(model.rowCount(), 0);
        // Taken off the list of spikes by a person, it is listed as such all the same.
        auto used = std::make_shared<TrialScene>(*exampleScene({}));
        used->robots[0].analysis->profile.samples[7].flags = flagBit(SampleFlag::ByHand);
        model.setScene(used);
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.index(0, SpikeModel::ReasonColumn).data().toString(), QStringLiteral("used, by hand"));
        QVERIFY(model.index(0, 0).data(SpikeModel::RestoredRole).toBool());
    }
    void spikesAndDoubts()
    {
        using namespace std::chrono_literals;
        SpikeModel model;
        QAbstractItemModelTester tester(&model, strict);
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 300}));
        scene->robots[0].analysis->ambiguousNames = {{3405ms, 4200ms, {7}, {"Blue 1"}}};
        model.setScene(scene);
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.summary(), QStringLiteral("2 flagged · 1 restored · 1 ambiguous"));
        const QModelIndex doubt = model.index(1, SpikeModel::ReasonColumn);
        QCOMPARE(doubt.data().toString(), QStringLiteral("Which robot? Until 4.20\u00a0s"));
        QCOMPARE(doubt.data(Qt::ToolTipRole).toString(),
                 QStringLiteral("Red 2: from 3.41 s to 4.20 s this may be Red 2 or Blue 1"));
        // the nearest frame
        QCOMPARE(doubt.data(SpikeModel::TimeRole).toLongLong(), scene->frameTimes()[102].count());
        QCOMPARE(doubt.data(SpikeModel::SampleIndexRole).toLongLong(), -1);
        QCOMPARE(model.index(1, SpikeModel::TimeColumn).data().toString(), QStringLiteral("3.40\u00a0s"));
    }
    void spikesAndGaps()
    {
        using namespace std::chrono_literals;
        SpikeModel model;
        QAbstractItemModelTester tester(&model, strict);
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 300}));
        scene->robots[0].analysis->profile.gaps = {{3405ms, 6200ms}};
        model.setScene(scene);
        QCOMPARE(model.summary(), QStringLiteral("2 flagged · 1 restored · 1 not measured"));
        const QModelIndex gap = model.index(1, SpikeModel::ReasonColumn);
        QCOMPARE(gap.data().toString(), QStringLiteral("Not measured until 6.20\u00a0s"));
        QCOMPARE(gap.data(Qt::ToolTipRole).toString(),
                 QStringLiteral("Red 2: not measured (3.41\u00a0s to 6.20\u00a0s)"));
    }
    void spikesAndHiddenRobots()
    {
        using namespace std::chrono_literals;
        SpikeModel model;
        QAbstractItemModelTester tester(&model, strict);
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 300}));
        scene->robots[0].occlusions = {{{3405ms, 4200ms}, OcclusionCause::HiddenBehind, "A", "Blue 1"}};
        scene->robots[0].analysis->profile.spikes[1].time = 3500ms;
        model.setScene(scene);
        QCOMPARE(model.summary(), QStringLiteral("2 flagged · 1 restored · 1 hidden"));
        const QModelIndex hidden = model.index(1, SpikeModel::ReasonColumn);
        QCOMPARE(hidden.data().toString(), QStringLiteral("hidden behind Blue 1 in view A"));
        QCOMPARE(hidden.data(Qt::ToolTipRole).toString(),
                 QStringLiteral("Red 2: hidden behind Blue 1 in view A (3.41\u00a0s to 4.20\u00a0s)"));
        QCOMPARE(hidden.data(SpikeModel::SampleIndexRole).toLongLong(), -1);
        QVERIFY(
            !model.index(0, SpikeModel::ReasonColumn).data().toString().contains(QStringLiteral("hidden")));
        QVERIFY(model.index(2, SpikeModel::ReasonColumn)
                    .data()
                    .toString()
                    .endsWith(QStringLiteral("; hidden behind Blue 1 in view A")));
    }
    void names()
    {
        NameListModel model({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")},
                            {QStringLiteral("Trial 1 · Falcon"), QStringLiteral("Trial 2")});
        QAbstractItemModelTester tester(&model, strict);
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0).data().toString(), QStringLiteral("Trial 1 · Falcon"));
        QCOMPARE(model.index(0).data(NameListModel::NameRole).toString(), QStringLiteral("Trial 1"));
        QCOMPARE(model.indexOf(QStringLiteral("Trial 2")), 1);
        QCOMPARE(model.indexOf(QStringLiteral("Trial 3")), -1);
        NameListModel none({}, {});
        QAbstractItemModelTester second(&none, strict);
        QCOMPARE(none.rowCount(), 0);
    }
    void metrics()
    {
        MetricModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setMetrics({{"max_speed", "m/s", 2.0612, 0.02}, {"stops", "1", 2, std::nullopt}});
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0, MetricModel::NameColumn).data().toString(), QStringLiteral("Top speed"));
        QCOMPARE(model.index(0, 0).data(MetricModel::SmallPrintRole).toString(), QStringLiteral("m/s ±0.02"));
        QCOMPARE(model.index(1, 0).data(MetricModel::ValueTextRole).toString(), QStringLiteral("2"));
    }
    void trialsSortByWhatTheyMean()
    {
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows({trialRow("b", 30, 10.5), trialRow("a", 10, 9.5), trialRow("c", 20, std::nullopt)});
        const auto order = [&](int column) {
            model.sort(column);
            return shownNames(model);
        };
        QCOMPARE(order(TrialModel::NameColumn), QStringLiteral("abc"));
        QCOMPARE(order(TrialModel::DateColumn), QStringLiteral("acb"));
        QCOMPARE(order(TrialModel::TopSpeedColumn), QStringLiteral("cab")); // 9.5 before 10.5, not by letters
        const QPersistentModelIndex b = model.index(2, 0);
        model.sort(TrialModel::TopSpeedColumn, Qt::DescendingOrder);
        QCOMPARE(b.row(), 0); // who is selected stays selected
        QCOMPARE(model.index(0, TrialModel::RobotsColumn).data().toString(), QStringLiteral("Red 2, Blue 1"));
        QCOMPARE(model.index(2, TrialModel::TopSpeedColumn).data().toString(), QStringLiteral("not tracked"));
        model.setRows({trialRow("Trial 10", 1, {}), trialRow("Trial 9", 2, {})});
        QCOMPARE(order(TrialModel::NameColumn), QStringLiteral("Trial 9Trial 10"));
    }
    void trialsAreFiltered_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        QTest::addRow("nothing typed") << ""
                                       << "abc";
        QTest::addRow("a name of a team, small letters") << "falcon"
                                                         << "abc";
        QTest::addRow("notes and a robot, in any order") << "blue WHEELS"
                                                         << "abc";
        QTest::addRow("a tag") << "wet"
                               << "b";
        QTest::addRow("a pseudonym") << "team four"
                                     << "a";
        QTest::addRow("one word that is not there") << "falcon nobody"
                                                    << "";
        QTest::addRow("blanks") << "   "
                                << "abc";
        QTest::addRow("not across two fields") << "cFalcon"
                                               << "";
    }
    void trialsAreFiltered()
    {
        QFETCH(const QString, text);
        TrialRow a = trialRow("a", 1, {}), b = trialRow("b", 2, {}), c = trialRow("c", 3, {});
        b.trial.tags = {"wet floor"};
        a.trial.teamPseudonym = "Team Four";
        for (TrialRow *row : {&a, &b})
            row->searchText = searchTextOf(row->trial);
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows({a, b, c});
        model.sort(TrialModel::NameColumn);
        TrialFilter filter;
        filter.text = text;
        model.setFilter(filter);
        QTEST(shownNames(model), "shown");
        QCOMPARE(model.allCount(), 3);
    }
    void everyConditionOfAFilterHolds()
    {
        TrialRow a = trialRow("a", 1, {}), b = trialRow("b", 2, {}), c = trialRow("c", 3, {}),
                 d = trialRow("d", 4, {});
        a.trial.className = b.trial.className = "9B";
        b.trial.starred = c.trial.starred = true;
        b.trial.task = "Slalom";
        c.trial.archived = c.trial.date;
        d.trial.archived = d.trial.binned = d.trial.date;
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows({a, b, c, d});
        model.sort(TrialModel::NameColumn);
        const auto shown = [&](const auto &set) {
            TrialFilter filter;
            set(filter);
            model.setFilter(filter);
            return shownNames(model);
        };
        QCOMPARE(shown([](TrialFilter &) {}), QStringLiteral("ab"));
        QCOMPARE(shown([](TrialFilter &f) { f.listSection = TrialFilter::ListSection::Archived; }),
                 QStringLiteral("c"));
        QCOMPARE(shown([](TrialFilter &f) { f.listSection = TrialFilter::ListSection::Bin; }),
                 QStringLiteral("d"));
        QCOMPARE(shown([](TrialFilter &f) { f.starred = true; }), QStringLiteral("b"));
        QCOMPARE(shown([](TrialFilter &f) { f.className = "9B"; }), QStringLiteral("ab"));
        QCOMPARE(shown([](TrialFilter &f) { f.task = "Slalom"; }), QStringLiteral("b"));
        QCOMPARE(shown([](TrialFilter &f) { f.team = "Heron"; }), QString());
        QCOMPARE(shown([](TrialFilter &f) { f.robot = "Blue 1"; }), QStringLiteral("ab"));
        QCOMPARE(shown([](TrialFilter &f) { f.robot = "Blue"; }), QString());
        QCOMPARE(shown([](TrialFilter &f) { f.from = Instant(std::chrono::minutes(2)); }),
                 QStringLiteral("b"));
        QCOMPARE(shown([](TrialFilter &f) { f.to = Instant(std::chrono::minutes(2)); }), QStringLiteral("a"));
    }
    void cellsOfATrialAreChanged()
    {
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows({trialRow("a", 1, {}), trialRow("b", 2, {})});
        model.sort(TrialModel::NameColumn);
        const QModelIndex star = model.index(1, TrialModel::StarColumn),
                          tags = model.index(1, TrialModel::TagsColumn);
        QVERIFY(!model.setData(star, Qt::Checked, Qt::CheckStateRole)); // the project may be read only
        model.setEditable(true);
        QSignalSpy starred(&model, &TrialModel::starWanted);
        std::vector<TrialEdit> edits;
        connect(&model, &TrialModel::editWanted, this, [&edits](qint64 trial, const TrialEdit &edit) {
            QCOMPARE(trial, qint64(2));
            edits.push_back(edit);
        });
        QVERIFY(model.setData(star, Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(starred.value(0), QVariantList({qint64(2), true}));
        QVERIFY(model.setData(tags, QStringLiteral(" wet , , final ")));
        QCOMPARE(edits.back().tags.value(), (std::vector<std::string>{"wet", "final"}));
        TrialRow b = trialRow("b", 2, {});
        b.trial.starred = true;
        QSignalSpy changed(&model, &TrialModel::dataChanged);
        model.updateRow(b);
        QVERIFY(isTold(changed, star) && !isTold(changed, tags)); // which may be being written
        QVERIFY(!isTold(changed, model.index(1, TrialModel::NameColumn)));
        QCOMPARE(star.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        b.trial.binned = b.trial.date;
        model.updateRow(b); // the filter does not let it through any more
        QCOMPARE(shownNames(model), QStringLiteral("a"));
    }
    void whatIsWrittenIntoACellBecomesAnEdit()
    {
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        TrialRow row = trialRow("a", 1, {});
        row.trial.variables = {{"battery", "7.4"}, {"surface", "carpet"}};
        model.setRows({row});
        model.setEditable(true);
        std::vector<TrialEdit> edits;
        connect(&model, &TrialModel::editWanted, this,
                [&edits](qint64, const TrialEdit &edit) { edits.push_back(edit); });
        const auto write = [&model](int column, const QVariant &value) {
            return model.setData(model.index(0, column), value);
        };
        QVERIFY(write(TrialModel::NameColumn, QStringLiteral(" Final ")));
        QCOMPARE(edits.back().name.value(), std::string("Final"));
        QVERIFY(write(TrialModel::TeamColumn, QStringLiteral("Heron")));
        QCOMPARE(edits.back().team.value(), std::string("Heron"));
        QVERIFY(write(TrialModel::ClassColumn, QStringLiteral("9C")));
        QCOMPARE(edits.back().className.value(), std::string("9C"));
        QVERIFY(write(TrialModel::TaskColumn, QStringLiteral("Slalom")));
        QCOMPARE(edits.back().task.value(), std::string("Slalom"));
        QVERIFY(write(TrialModel::DateColumn, QDateTime::fromMSecsSinceEpoch(120'000)));
        QVERIFY(edits.back().date.value() == Instant(std::chrono::minutes(2)));
        QVERIFY(write(TrialModel::NotesColumn, QStringLiteral("slipped")));
        QCOMPARE(edits.back().notes.value(), std::string("slipped"));
        QCOMPARE(model.variables(), (QStringList{QStringLiteral("battery"), QStringLiteral("surface")}));
        QVERIFY(write(TrialModel::ColumnCount, QStringLiteral("7,2")));
        QCOMPARE(edits.back().variables, (std::map<std::string, std::string>{{"battery", "7.2"}}));
        QVERIFY(write(TrialModel::ColumnCount + 1, QString()));
        QCOMPARE(edits.back().variables, (std::map<std::string, std::string>{{"surface", ""}}));
        // What stays as it is, and what cannot be written in a cell, is no edit.
        const std::size_t count = edits.size();
        QVERIFY(!write(TrialModel::NameColumn, QStringLiteral("a")));
        QVERIFY(!write(TrialModel::DateColumn, QDateTime::fromMSecsSinceEpoch(60'000)));
        QVERIFY(!write(TrialModel::RobotsColumn, QStringLiteral("Blue 1")));
        row.trial.notes = "two\nlines";
        row.trial.variables["attempt"] = "3"; // a column more
        model.updateRow(row);
        QCOMPARE(model.columnCount(), int(TrialModel::ColumnCount) + 3);
        QCOMPARE(model.index(0, TrialModel::ColumnCount + 2).data().toString(), QStringLiteral("3"));
        QVERIFY(!write(TrialModel::NotesColumn, QStringLiteral("one line")));
        QCOMPARE(edits.size(), count);
    }
    void variablesSortAsNumbers()
    {
        TrialModel model;
        std::vector<TrialRow> rows;
        for (const char *value : {"10", "7.15", "carpet", "7.4", ""}) {
            rows.push_back(trialRow(value, std::ssize(rows) + 1, {}));
            if (*value)
                rows.back().trial.variables["v"] = value;
        }
        model.setRows(std::move(rows));
        model.sort(TrialModel::ColumnCount);
        QCOMPARE(shownNames(model), QStringLiteral("7.157.410carpet"));
    }
    void teamsAreShownByPseudonym()
    {
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        TrialRow named = trialRow("a", 1, {}), hidden = trialRow("b", 2, {});
        hidden.trial.teamPseudonym = "Team Four";
        model.setRows({named, hidden});
        model.sort(TrialModel::NameColumn);
        showPseudonyms(true);
        model.updateTeams();
        QCOMPARE(model.index(0, TrialModel::TeamColumn).data().toString(), QStringLiteral("Falcon"));
        QCOMPARE(model.index(1, TrialModel::TeamColumn).data().toString(), QStringLiteral("Team Four"));
        const TeamRecord team{.name = "Falcon", .pseudonym = "Team Four"};
        knowPseudonyms({&team, 1});
        QCOMPARE(teamShownBy(QStringLiteral(" Team Four ")), std::string("Falcon"));
        QCOMPARE(teamShownBy(QStringLiteral("Owl")), std::string("Owl"));
        showPseudonyms(false);
        QCOMPARE(teamShownBy(QStringLiteral("Team Four")), std::string("Team Four"));
        knowPseudonyms({});
    }
    void scoresAreSortedAndExplained()
    {
        TrialModel model;
        QAbstractItemModelTester tester(&model, strict);
        const auto scored = [](const char *name, std::int64_t minute, double seconds) {
            TrialRow row = trialRow(name, minute, {});
            row.isScored = true;
            row.score = scoreOf({{"gate_time", 4, 10, 30}}, {{"gate_time", "s", seconds, {}}});
            return row;
        };
        TrialRow otherwise = trialRow("c", 3, {});
        otherwise.isScored = true;
        model.setRows({scored("a", 1, 7), otherwise, scored("b", 2, 5), trialRow("d", 4, {})});
        model.sort(TrialModel::ScoreColumn, Qt::DescendingOrder);
        QVERIFY(shownNames(model).startsWith(QLatin1String("ba")));
        const QModelIndex best = model.index(0, TrialModel::ScoreColumn);
        QCOMPARE(best.data().toString(), QStringLiteral("25 of 30"));
        QVERIFY(best.data(Qt::ToolTipRole).toString().contains(QLatin1String("Start to finish")));
        model.sort(TrialModel::NameColumn, Qt::AscendingOrder);
        QCOMPARE(model.index(2, TrialModel::ScoreColumn).data().toString(), QStringLiteral("reanalyse"));
        QVERIFY(model.index(3, TrialModel::ScoreColumn).data().toString().isEmpty());
        QCOMPARE(model.headerData(TrialModel::StarColumn, Qt::Horizontal, Qt::AccessibleTextRole).toString(),
                 QStringLiteral("Star"));
    }
    void changesAreLookedThrough()
    {
        ChangeModel model({{Instant(), ChangeEntry::Kind::Undone, foreignWords("star Trial 2")},
                           {Instant(), ChangeEntry::Kind::Made, foreignWords("add robot Red")}});
        QAbstractItemModelTester tester(&model, strict);
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0, ChangeModel::KindColumn).data().toString(), QStringLiteral("undone"));
        model.setText(QStringLiteral("ROBOT"));
        QCOMPARE(model.rowCount(), 1);
        QCOMPARE(model.index(0, ChangeModel::WordsColumn).data().toString(), QStringLiteral("add robot Red"));
    }
    void standingsAreTold()
    {
        std::vector<TrialRecord> trials;
        std::vector<TrialMetric> trialMetrics;
        for (const double seconds : {12.0, 11.1, 9.9, 9.0}) {
            TrialRecord trial;
            trial.id = static_cast<RecordId>(trials.size()) + 1;
            trial.team = 1;
            trial.teamName = "Falcon";
            trial.teamPseudonym = "Team 4";
            trial.task = "Slalom";
            trial.date = Instant(std::chrono::hours(24 * trial.id));
            trialMetrics.push_back({trial.id, 1, {"gate_time", "s", seconds, 0.01}});
            trials.push_back(trial);
        }
        std::vector<const TrialRecord *> pointers;
        for (const TrialRecord &trial : trials)
            pointers.push_back(&trial);
        StandingsModel model;
        QAbstractItemModelTester tester(&model, strict);
        showPseudonyms(true);
        model.setStandings(standingsOf(pointers, trialMetrics, {"", "Slalom", "gate_time"}));
        QCOMPARE(model.rowCount(), 1);
        const auto cell = [&](int column) { return model.index(0, column).data().toString(); };
        QCOMPARE(cell(StandingsModel::TeamColumn), QStringLiteral("Team 4"));
        QCOMPARE(cell(StandingsModel::RunsColumn), QStringLiteral("4"));
        QCOMPARE(cell(StandingsModel::BestColumn), QStringLiteral("9.00\u00a0s"));
        QVERIFY(cell(StandingsModel::ProgressColumn).startsWith(QLatin1String("better: -3.0")) ||
                cell(StandingsModel::ProgressColumn).startsWith(QString::fromUtf8("better: −3.0")));
        showPseudonyms(false);
        // the same figures, where more is better
        model.setStandings(standingsOf(pointers, trialMetrics, {"", "Slalom", "max_speed"}));
        QCOMPARE(cell(StandingsModel::TeamColumn), QStringLiteral("Falcon"));
        QVERIFY(cell(StandingsModel::ProgressColumn).startsWith(QLatin1String("worse: ")));
    }
    void camerasTellTheirState()
    {
        CameraListModel model;
        QAbstractItemModelTester tester(&model, strict);
        model.setRows(
            {cameraRow("A", 0.0016), cameraRow("B", 0.012), cameraRow("C", 0.05), cameraRow("D", {})});
        const auto state = [&](int row) {
            return BadgeState(model.index(row, 0).data(CameraListModel::BadgeStateRole).toInt());
        };
        QCOMPARE(model.index(0, 0).data(CameraListModel::BadgeTextRole).toString(),
                 QStringLiteral("±1.6\u00a0mm"));
        QCOMPARE(state(0), BadgeState::Good);
        QCOMPARE(state(1), BadgeState::Warning);
        QCOMPARE(state(2), BadgeState::Bad);
        QCOMPARE(model.index(3, 0).data(CameraListModel::BadgeTextRole).toString(),
                 QStringLiteral("not registered"));
        // A tool tip guesses at rich text; what a file says must stay text.
        QCOMPARE(model.index(0, 0).data(Qt::ToolTipRole).toString(), QStringLiteral("Good &lt;b&gt;"));
    }
    void sceneFindsFramesAndObservations()
    {
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 30}));
        scene->views[1].startOffset = std::chrono::milliseconds(100); // three frames later
        QCOMPARE(scene->frameAt(0, scene->frameTimes()[7]).value(), std::int64_t(7));
        QCOMPARE(scene->frameAt(1, scene->frameTimes()[7]).value(), std::int64_t(4));
        QVERIFY(!scene->frameAt(1, scene->frameTimes()[0]));         // it did not run yet
        scene->views[1].startOffset = std::chrono::milliseconds(20); // more than half a frame, less than one
        QCOMPARE(scene->frameAt(1, scene->frameTimes()[0]).value(), std::int64_t(0));
        QVERIFY(scene->observationAt(0, 0, 7));
        QVERIFY(!scene->observationAt(0, 0, 99));
        QVERIFY(scene->floorBounds().contains(Eigen::Vector2d(3.0, 2.2)));
        QVERIFY(TrialScene().floorBounds().sizes().minCoeff() > 0);
        QVERIFY(TrialScene().frameTimes().empty());
    }
};

ODOGRAPH_TEST(TestListModels, QApplication)
#include "tst_list_models.moc"
