// SPDX-License-Identifier: GPL-3.0-or-later
// What the hub is to have of a project: the outbox that triggers fill, and documents there and back.
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/school_documents.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QCborMap>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

/// What a failure says; nothing of a success.
template <class Value>
static std::string whyNot(const Result<Value> &outcome)
{
    return outcome ? std::string() : outcome.error().message();
}

class TestSchoolDocuments : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_ours = newProject("ours.odo");
        m_theirs = newProject("theirs.odo");
        RecordSource source(7);
        const auto filled = fill(*m_ours, source);
        QVERIFY(filled);
        m_filled = *filled;
    }

    void nothingIsNotedWithoutAHub()
    {
        QCOMPARE(m_ours->school().pending().value(), 0);
        QVERIFY(!m_ours->school().link()->has_value());
    }

    void connectingNotesEverything()
    {
        connect(*m_ours);
        // class 8b, team Los Niños, task line, trial run 1
        QCOMPARE(words(*m_ours), QStringList({QStringLiteral("class"), QStringLiteral("team"),
                                              QStringLiteral("task"), QStringLiteral("trial")}));
        QVERIFY(m_ours->school().disconnect());
        QCOMPARE(m_ours->school().pending().value(), 0);
    }

    void everyChangeOfATrialIsNoted_data()
    {
        using Change = std::function<Result<void>(Project &, RecordId, RecordId)>;
        QTest::addColumn<Change>("change");
        const auto add = [](const char *name, Change change) { QTest::newRow(name) << change; };
        add("name", [](Project &p, RecordId t, RecordId) { return p.trials().setName(t, "run 2"); });
        add("notes", [](Project &p, RecordId t, RecordId) { return p.trials().setNotes(t, "wet floor"); });
        add("tags", [](Project &p, RecordId t, RecordId) { return p.trials().setTags(t, {"final"}); });
        add("variables", [](Project &p, RecordId t, RecordId) {
            return p.trials().setVariables(t, {{"surface", "mat"}});
        });
        add("robots", [](Project &p, RecordId t, RecordId) { return p.trials().setRobots(t, {}); });
        add("bin", [](Project &p, RecordId t, RecordId) { return p.trials().setBinned(t, true); });
        add("override", [](Project &p, RecordId t, RecordId r) {
            return p.trials().setManualOverrides(t, r, {{3, true}});
        });
        add("analysis", [](Project &p, RecordId t, RecordId r) {
            RecordSource source(9);
            return withoutValue(p.analyses().add(source.analysis(t, r, 20)));
        });
        add("robot renamed", [](Project &p, RecordId, RecordId r) {
            RobotRecord robot = *p.robots().get(r);
            robot.name = "rot";
            return p.robots().set(robot);
        });
        add("class renamed", [](Project &p, RecordId, RecordId) {
            return p.classes().rename(p.classes().find("8b")->id, "8c");
        });
        add("pseudonym", [](Project &p, RecordId, RecordId) {
            TeamRecord team = *p.teams().find("Los Niños");
            team.pseudonym = "Fuchs";
            return p.teams().set(team);
        });
    }

    void everyChangeOfATrialIsNoted()
    {
        using Change = std::function<Result<void>(Project &, RecordId, RecordId)>;
        QFETCH(Change, change);
        connect(*m_ours);
        empty(*m_ours);
        QVERIFY(change(*m_ours, m_filled.trial, m_filled.robot));
        QVERIFY(words(*m_ours).contains(QStringLiteral("trial")));
    }

    void whatFailsLeavesNothingToSend()
    {
        connect(*m_ours);
        empty(*m_ours);
        const auto failed = m_ours->inTransaction([&]() -> Result<void> {
            ODO_TRY(m_ours->trials().setNotes(m_filled.trial, "never"));
            return fail(ErrorCode::Internal, {}, {}, {});
        });
        QVERIFY(!failed);
        QCOMPARE(m_ours->school().pending().value(), 0);
    }

    void undoingIsNotedToo()
    {
        connect(*m_ours);
        QVERIFY(m_ours->change(foreignWords("note"),
                               [&] { return m_ours->trials().setNotes(m_filled.trial, "wet floor"); }));
        empty(*m_ours);
        QVERIFY(m_ours->undo());
        QVERIFY(words(*m_ours).contains(QStringLiteral("trial")));
        QVERIFY(m_ours->redo());
    }

    void aChangeWhileSendingStays()
    {
        connect(*m_ours);
        SchoolRepository &school = m_ours->school();
        const auto entries = school.outbox();
        QVERIFY(entries && !entries->empty());
        QVERIFY(m_ours->trials().setNotes(m_filled.trial, "meanwhile"));
        for (const OutboxEntry &entry : *entries)
            QVERIFY(school.settle(entry));
        QCOMPARE(words(*m_ours), QStringList{QStringLiteral("trial")});
    }

    void aRemovedTrialLeavesItsIdentity()
    {
        connect(*m_ours);
        const auto identity = m_ours->school().identity(SchoolKind::Trial, m_filled.trial);
        QVERIFY(identity);
        QVERIFY(m_ours->trials().setBinned(m_filled.trial, true));
        QVERIFY(m_ours->trials().removeForGood(m_filled.trial));
        const auto entries = *m_ours->school().outbox();
        QCOMPARE(entries.back().removed, identity->uuid);
        QCOMPARE(std::ranges::count(entries, SchoolKind::Trial, &OutboxEntry::kind), 1);
    }

    void aTrialArrivesWhole()
    {
        const auto document = makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
        QVERIFY2(document, whyNot(document).c_str());
        const auto row = storeSchoolDocument(*m_theirs, *document, 0, "bench1");
        QVERIFY2(row, whyNot(row).c_str());
        const auto ours = m_ours->trials().get(m_filled.trial), theirs = m_theirs->trials().get(*row);
        QCOMPARE(theirs->name, ours->name);
        QCOMPARE(theirs->teamName, ours->teamName);
        QCOMPARE(theirs->task, ours->task);
        QCOMPARE(theirs->robotNames, ours->robotNames);
        QCOMPARE(theirs->viewCount, 0);
        QVERIFY(m_theirs->school().setIdentity(
            {SchoolKind::Trial, *row, "1", 1, {}, "bench1", viewsOf(*document)}));
        const auto again = makeSchoolDocument(*m_theirs, SchoolKind::Trial, *row);
        QVERIFY(again);
        QCOMPARE(again->body, document->body);
        QVERIFY(again->recordings.isEmpty());
        const auto problems = m_theirs->check(false);
        QVERIFY(problems);
        for (const ProjectProblem &problem : *problems)
            qWarning("%s", problem.what.english().c_str());
        QVERIFY(problems->empty());
    }

    void theSameTrialTwiceIsOne()
    {
        const auto document = makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
        const auto row = storeSchoolDocument(*m_theirs, *document, 0, "bench1");
        const auto again = storeSchoolDocument(*m_theirs, *document, *row, "bench1");
        QVERIFY(again);
        QCOMPARE(*again, *row);
        QCOMPARE(m_theirs->trials().all()->size(), 1u);
        QCOMPARE(m_theirs->analyses().current(*row)->front().id, 1);
    }

    void aNameThatIsTakenGetsTheOwners()
    {
        const auto document = makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
        QVERIFY(storeSchoolDocument(*m_theirs, *document, 0, "bench1"));
        const auto second = storeSchoolDocument(*m_theirs, *document, 0, "bench2");
        QVERIFY(second);
        QCOMPARE(m_theirs->trials().get(*second)->name, "run 1 (bench2)");
    }

    void classListsAndTasksArriveWhole()
    {
        TeamRecord team = *m_ours->teams().find("Los Niños");
        team.members = {"Anna", "Ben"};
        team.pseudonym = "Fuchs";
        QVERIFY(m_ours->teams().set(team));
        const auto task = m_ours->tasks().find("line");
        QVERIFY(m_ours->tasks().setScoring(task->id, {{"max_speed", 2, 1, 10}}));
        for (const auto &[kind, row] :
             {std::pair{SchoolKind::Class, m_ours->classes().find("8b")->id},
              std::pair{SchoolKind::Team, team.id}, std::pair{SchoolKind::Task, task->id}}) {
            const auto document = makeSchoolDocument(*m_ours, kind, row);
            QVERIFY(document);
            const auto stored = storeSchoolDocument(*m_theirs, *document, 0, "teacher");
            QVERIFY2(stored, whyNot(stored).c_str());
            const RecordId there = *m_theirs->school().rowNamed(kind, document->name);
            QCOMPARE(makeSchoolDocument(*m_theirs, kind, there)->body, document->body);
        }
    }

    void hostileDocumentsAreRefusedInOneLine_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QCborValue>("value");
        const auto add = [](const char *name, const char *field, const QCborValue &value) {
            QTest::newRow(name) << QString::fromLatin1(field) << value;
        };
        add("number as name", "name", 7);
        add("ten megabytes of name", "name", QString(10'000'000, u'x'));
        add("name of two lines", "name", QStringLiteral("a\nb"));
        add("ten megabytes of notes", "notes", QString(10'000'000, u'x'));
        add("null in notes", "notes", QString(QChar(u'\0')));
        add("text as date", "date_ms", QStringLiteral("yesterday"));
        add("no number", "duration_s", std::numeric_limits<double>::quiet_NaN());
        add("list as team", "team", QCborArray{1, 2});
        add("no robots", "robots", QStringLiteral("red"));
        add("a thousand tags", "tags", [] {
            QCborArray tags;
            for (int i = 0; i < 1000; ++i)
                tags.append(QString::number(i));
            return tags;
        }());
        add("an analysis of nothing", "analyses", QCborArray{QCborMap()});
        add("missing", "tracks", QCborValue());
        add("backwards range", "range_from_ns", QStringLiteral("x"));
    }

    void hostileDocumentsAreRefusedInOneLine()
    {
        QFETCH(QString, field);
        QFETCH(QCborValue, value);
        SchoolDocument document = *makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
        QCborMap map = QCborValue::fromCbor(document.body).toMap();
        map.insert(field, value);
        document.body = map.toCborValue().toCbor();
        refusesIt(document);
    }

    void brokenPackedSeriesAreRefused()
    {
        for (const char *series : {"samples", "points"}) {
            SchoolDocument document = *makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
            QCborMap map = QCborValue::fromCbor(document.body).toMap();
            QCborMap analysis = map.value(QStringLiteral("analyses")).toArray().at(0).toMap();
            const QByteArray packed = analysis.value(QLatin1String(series)).toArray().at(0).toByteArray();
            for (const QByteArray &broken : {packed.chopped(1), QByteArray(), QByteArray(3, '\xff'),
                                             QByteArray("S\x01\x00\x00\xff\xff\xff\x7f", 8)}) {
                analysis.insert(QLatin1String(series), QCborArray{broken});
                map.insert(QStringLiteral("analyses"), QCborArray{analysis});
                document.body = map.toCborValue().toCbor();
                refusesIt(document);
            }
        }
    }

    void anyDamageOfTheBytesIsRefusedOrHarmless()
    {
        const SchoolDocument good = *makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
        std::mt19937 random(11);
        for (int round = 0; round < 300; ++round) {
            SchoolDocument document = good;
            for (int i = 0; i < 4; ++i)
                document.body[qsizetype(random() % std::size_t(document.body.size()))] = char(random());
            const auto stored = storeSchoolDocument(*m_theirs, document, 0, "bench1");
            if (!stored)
                QVERIFY(!stored.error().message().empty() &&
                        stored.error().message().find('\n') == std::string::npos);
        }
        const auto problems = m_theirs->check(false);
        QVERIFY(problems);
    }

    void whatPeopleCompareHasNoSeries()
    {
        const auto document = makeSchoolDocument(*m_ours, SchoolKind::Trial, m_filled.trial);
        const QJsonObject readable = readableDocument(*document);
        QCOMPARE(readable.value(QStringLiteral("name")).toString(), QStringLiteral("run 1"));
        QVERIFY(!readable.value(QStringLiteral("analyses"))
                     .toArray()
                     .at(0)
                     .toObject()
                     .contains(QStringLiteral("samples")));
    }

private:
    std::unique_ptr<Project> newProject(const char *name)
    {
        return std::move(
            *Project::create(m_folder->filePath(QString::fromLatin1(name)).toStdString(), "Year"));
    }

    static void connect(Project &project)
    {
        QVERIFY(project.school().connect({"postgresql://school/hub", {}, "bench", 1, {}}));
    }

    static void empty(Project &project)
    {
        SchoolRepository &school = project.school();
        const auto entries = *school.outbox();
        for (const OutboxEntry &entry : entries)
            QVERIFY(school.settle(entry));
        QCOMPARE(school.pending().value(), 0);
    }

    static QStringList words(Project &project)
    {
        QStringList kinds;
        const auto entries = *project.school().outbox();
        for (const OutboxEntry &entry : entries)
            kinds << QString::fromStdString(schoolKindWord(entry.kind));
        return kinds;
    }

    void refusesIt(const SchoolDocument &document)
    {
        const auto stored = storeSchoolDocument(*m_theirs, document, 0, "bench1");
        QVERIFY(!stored);
        QCOMPARE(stored.error().code, ErrorCode::InvalidInput);
        const std::string said = stored.error().message();
        QVERIFY2(said.find('\n') == std::string::npos && said.size() < 2000, said.c_str());
        QCOMPARE(m_theirs->trials().all()->size(), 0u);
        QCOMPARE(m_theirs->robots().all()->size(), 0u);
        QCOMPARE(m_theirs->teams().all()->size(), 0u);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_ours, m_theirs;
    FilledProject m_filled;
};

ODOGRAPH_TEST(TestSchoolDocuments, QCoreApplication)
#include "tst_school_documents.moc"
