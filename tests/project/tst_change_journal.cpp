// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/change_journal.h"
#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

namespace {

/// Every value of every row of every table but the list of changes, which only grows. Tables are sets: their
/// rows have no order.
QStringList rowsOf(const ProjectConnection &connection)
{
    QStringList rows;
    const QStringList tables = connection.database().tables();
    for (const QString &table : tables) {
        if (table == QStringLiteral("change_entry"))
            continue;
        QSqlQuery query(connection.database());
        query.exec(QStringLiteral("SELECT * FROM \"%1\"").arg(table));
        while (query.next()) {
            QString row = table;
            for (int i = 0; i < query.record().count(); ++i)
                row += u'|' + QString::fromLatin1(query.value(i).toByteArray().toHex()) +
                       (query.isNull(i) ? u'-' : u'+');
            rows << row;
        }
    }
    rows.sort();
    return rows;
}

Result<void> failing()
{
    return fail(ErrorCode::Io, foreignWords("disk"), foreignWords("the disk is full"),
                foreignWords("make room"));
}

} // namespace

class TestChangeJournal : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        const std::filesystem::path file = m_folder->filePath(QStringLiteral("year.odo")).toStdString();
        m_project = std::move(*Project::create(file, "Year"));
        RecordSource source(7);
        const auto filled = fill(*m_project, source);
        m_trial = filled->trial;
        m_robot = filled->robot;
        m_second = std::move(*ProjectConnection::open(file, DatabaseAccess::ReadOnly));
    }
    void cleanup()
    {
        m_second.reset();
        m_project.reset();
    }
    void aChangeIsTakenBackAndMadeAgain();
    void randomSequencesRestoreEveryRow();
    void whatFailsLeavesNoTrace();
    void whatChangesNothingLeavesNoTrace();
    void aChangeInsideAnotherIsAPartOfIt();
    void aNewChangeForgetsWhatWasUndone();
    void aLaterChangeOutsideOfTheJournalIsKept();
    void whatIsInUseStays();
    void theOldestAreForgotten();
    void everyChangeIsTold();
    void whatIsNotedIsToldAndStays();
    void whatIsAddedBeforeStays();
    void observationsStayOutOfForce();

private:
    QStringList rows() const { return rowsOf(*m_second); }
    Result<void> star(bool starred)
    {
        return m_project->change(foreignWords(starred ? "star" : "take the star off"),
                                 [&] { return m_project->trials().setStarred(m_trial, starred); });
    }
    Result<void> randomChange(std::mt19937 &random);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<ProjectConnection> m_second; ///< looks on
    RecordId m_trial = 0, m_robot = 0;
};

void TestChangeJournal::aChangeIsTakenBackAndMadeAgain()
{
    const QStringList before = rows();
    QVERIFY(star(true));
    const QStringList after = rows();
    QVERIFY(after != before);
    QCOMPARE(m_project->undoWords().english(), std::string("star"));
    QCOMPARE(m_project->redoWords().english(), std::string());
    QCOMPARE(m_project->undo().value().english(), std::string("star"));
    QCOMPARE(rows(), before);
    QVERIFY(!m_project->trials().get(m_trial)->starred);
    QCOMPARE(m_project->redoWords().english(), std::string("star"));
    QCOMPARE(m_project->redo().value().english(), std::string("star"));
    QCOMPARE(rows(), after);
    QVERIFY(m_project->trials().get(m_trial)->starred);

    QVERIFY(m_project->undo());
    QCOMPARE(
        m_project->undo().error().message(),
        std::string("undo: nothing has been changed since the project was opened; change something first"));
    QVERIFY(m_project->redo());
    QCOMPARE(m_project->redo().error().message(),
             std::string("redo: nothing has been undone; undo something first"));
}

/// Something else each time, of every table that people change.
Result<void> TestChangeJournal::randomChange(std::mt19937 &random)
{
    const int number = std::uniform_int_distribution(0, 1'000'000)(random);
    const std::string name = 'n' + std::to_string(number);
    TrialRepository &trials = m_project->trials();
    const auto make = [&]() -> Result<void> {
        switch (number % 9) {
        case 0:
            return trials.setStarred(m_trial, number % 2 == 0);
        case 1:
            return trials.setTags(m_trial, {name, "x", "été"});
        case 2:
            return trials.setTags(m_trial, {});
        case 3:
            return trials.setArchived(m_trial, number % 2 == 0);
        case 4:
            return trials.setBinned(m_trial, number % 2 == 0);
        case 5:
            return trials.setNotes(m_trial, name + "\n=1+1");
        case 6:
            return m_project->teams()
                .add({0, name, "class " + std::to_string(number % 3), "P" + name, {name, "Zoë"}, {m_robot}})
                .map([](auto &&) {});
        case 7:
            return trials.setTask(m_trial, "task " + std::to_string(number % 4));
        default:
            return m_project->setTitle(name);
        }
    };
    return m_project->change(foreignWords("change " + name), make);
}

/// Back and forth at random, every state is the one that was there before to the last bit.
void TestChangeJournal::randomSequencesRestoreEveryRow()
{
    std::mt19937 random(4);
    std::vector<QStringList> states{rows()};
    std::size_t at = 0;
    for (int i = 0; i < 300; ++i) {
        const int choice = std::uniform_int_distribution(0, 9)(random);
        if (choice < 4 && at > 0) {
            const auto undone = m_project->undo();
            QVERIFY2(undone, undone ? "" : undone.error().message().c_str());
            --at;
        } else if (choice < 6 && at + 1 < states.size()) {
            QVERIFY(m_project->redo());
            ++at;
        } else {
            const auto made = randomChange(random);
            QVERIFY2(made, made ? "" : made.error().message().c_str());
            const QStringList now = rows();
            if (now != states[at]) { // the same again is no change
                states.resize(++at);
                states.push_back(now);
            }
        }
        QCOMPARE(rows(), states[at]);
    }
    QVERIFY(states.size() > 20);
}

void TestChangeJournal::whatFailsLeavesNoTrace()
{
    QVERIFY(star(true));
    const QStringList before = rows();
    const auto failed = m_project->change(foreignWords("tag"), [&]() -> Result<void> {
        if (auto tagged = m_project->trials().setTags(m_trial, {"late"}); !tagged)
            return tagged;
        return failing();
    });
    QCOMPARE(failed.error().message(), std::string("disk: the disk is full; make room"));
    QCOMPARE(rows(), before);
    QCOMPARE(m_project->undoWords().english(), std::string("star"));
    QCOMPARE(m_project->changes()->size(), std::size_t(1));
    QVERIFY(star(false)); // and the next is one of its own
    QCOMPARE(m_project->undoWords().english(), std::string("take the star off"));
}

void TestChangeJournal::whatChangesNothingLeavesNoTrace()
{
    QVERIFY(star(false));
    QCOMPARE(m_project->undoWords().english(), std::string());
    QVERIFY(m_project->changes()->empty());
}

void TestChangeJournal::aChangeInsideAnotherIsAPartOfIt()
{
    const QStringList before = rows();
    QVERIFY(m_project->change(foreignWords("star and tag"), [&]() -> Result<void> {
        if (auto starred = star(true); !starred)
            return starred;
        return m_project->trials().setTags(m_trial, {"final"});
    }));
    QCOMPARE(m_project->undo().value().english(), std::string("star and tag"));
    QCOMPARE(rows(), before);
    QCOMPARE(m_project->undoWords().english(), std::string());
}

void TestChangeJournal::aNewChangeForgetsWhatWasUndone()
{
    QVERIFY(star(true));
    QVERIFY(m_project->undo());
    QVERIFY(m_project->setTitle("another")); // no change of the journal
    QCOMPARE(m_project->redoWords().english(), std::string("star"));
    QVERIFY(
        m_project->change(foreignWords("tag"), [&] { return m_project->trials().setTags(m_trial, {"a"}); }));
    QCOMPARE(m_project->redoWords().english(), std::string());
}

void TestChangeJournal::aLaterChangeOutsideOfTheJournalIsKept()
{
    QVERIFY(star(true));
    QVERIFY(m_project->trials().setStarred(m_trial, false));
    const QStringList before = rows();
    QCOMPARE(m_project->undo().error().message(),
             std::string("undo 'star': something it concerns has been changed or used since; undo the later "
                         "change first, or leave this one"));
    QCOMPARE(rows(), before);
    QCOMPARE(m_project->undoWords().english(), std::string("star")); // as it was
}

/// A team that a trial was given since cannot go.
void TestChangeJournal::whatIsInUseStays()
{
    RecordId team = 0;
    QVERIFY(m_project->change(foreignWords("add team Otter"), [&]() -> Result<void> {
        const auto added = m_project->teams().add({0, "Otter", "9C"});
        if (!added)
            return tl::unexpected(added.error());
        team = added->id;
        return {};
    }));
    TrialRecord trial;
    trial.name = "Otter 1";
    trial.team = team;
    QVERIFY(m_project->trials().add(trial, {}));
    const QStringList before = rows();
    const auto refused = m_project->undo();
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
    QCOMPARE(rows(), before);
}

void TestChangeJournal::theOldestAreForgotten()
{
    m_second.reset();
    m_project.reset();
    const std::filesystem::path file = m_folder->filePath(QStringLiteral("year.odo")).toStdString();
    const auto connection = ProjectConnection::open(file, DatabaseAccess::ReadWrite);
    TrialRepository trials(**connection);
    ChangeJournal journal(**connection, 50'000);
    const auto note = [&](char letter) {
        return journal.make(foreignWords(std::string("note ") + letter),
                            [&] { return trials.setNotes(m_trial, std::string(15'000, letter)); });
    };
    for (char letter = 'a'; letter <= 'f'; ++letter)
        QVERIFY(note(letter));
    // A change holds the notes before and after.
    QCOMPARE(journal.undo().value().english(), std::string("note f"));
    QCOMPARE(trials.get(m_trial)->notes, std::string(15'000, 'e'));
    QCOMPARE(journal.undoWords().english(), std::string());
}

void TestChangeJournal::everyChangeIsTold()
{
    QVERIFY(star(true));
    QVERIFY(m_project->undo());
    QVERIFY(m_project->redo());
    const auto changes = m_project->changes().value();
    QCOMPARE(changes.size(), std::size_t(3));
    QVERIFY(changes[0].kind == ChangeEntry::Kind::Redone && changes[1].kind == ChangeEntry::Kind::Undone &&
            changes[2].kind == ChangeEntry::Kind::Made);
    QCOMPARE(changes[2].words.english(), std::string("star"));
    const auto age = std::chrono::system_clock::now() - changes[0].made;
    QVERIFY(age >= 0ms && age < 10min);
}

void TestChangeJournal::whatIsNotedIsToldAndStays()
{
    QVERIFY(star(true));
    const auto tag = [&] { return m_project->trials().setTags(m_trial, {"measured"}); };
    QVERIFY(m_project->note(foreignWords("track it"), tag));
    QCOMPARE(m_project->changes()->front().words.english(), std::string("track it"));
    QCOMPARE(m_project->undoWords().english(), std::string("star")); // what was noted is passed over
    QVERIFY(m_project->undo());
    QCOMPARE(m_project->trials().get(m_trial)->tags.size(), std::size_t(1));
    QVERIFY(!m_project->trials().get(m_trial)->starred);

    const std::size_t told = m_project->changes()->size();
    const QStringList before = rows();
    QVERIFY(m_project->note(foreignWords("look"), [&]() -> Result<void> { return {}; })); // changes nothing
    QVERIFY(!m_project->note(foreignWords("fail"), [&]() -> Result<void> {
        if (auto done = m_project->trials().setTags(m_trial, {"half"}); !done)
            return done;
        return failing();
    }));
    QVERIFY(m_project->change(foreignWords("both"), [&] {
        return m_project->note(foreignWords("inner"),
                               [&] { return m_project->trials().setTags(m_trial, {"a"}); });
    }));
    QCOMPARE(m_project->changes()->size(), told + 1); // the inner one is a part
    QVERIFY(m_project->undo());
    QCOMPARE(rows(), before);
}

void TestChangeJournal::whatIsAddedBeforeStays()
{
    const auto tag = [&] { return m_project->trials().setTags(m_trial, {"raw"}); };
    const auto starIt = [&] { return m_project->trials().setStarred(m_trial, true); };
    QVERIFY(m_project->change(foreignWords("import"), starIt, tag));
    QCOMPARE(m_project->undo().value().english(), std::string("import"));
    QVERIFY(!m_project->trials().get(m_trial)->starred);
    QCOMPARE(m_project->trials().get(m_trial)->tags.size(), std::size_t(1));
    QVERIFY(m_project->redo());
    QVERIFY(m_project->trials().get(m_trial)->starred);

    const QStringList before = rows();
    QVERIFY(!m_project->change(foreignWords("fail"), failing,
                               [&] { return m_project->trials().setTags(m_trial, {"half"}); }));
    QCOMPARE(rows(), before);
}

/// Undoing a tracking brings the observations of before into use again, and loses none.
void TestChangeJournal::observationsStayOutOfForce()
{
    const RecordId recording = m_project->trials().recordings(m_trial)->front().id;
    const auto algorithm = [&] {
        return m_project->trials()
            .currentObservations(recording, m_robot)
            ->value_or(ObservationSeries())
            .algorithm;
    };
    const auto count = [&] {
        return m_second->number(QStringLiteral("SELECT COUNT(*) FROM observation_series")).value();
    };
    const std::string first = algorithm();
    const auto stored = count();
    QVERIFY(m_project->change(foreignWords("track"), [&] {
        return m_project->trials().addObservations({recording, m_robot, "later", {Observation()}});
    }));
    QCOMPARE(algorithm(), std::string("later"));
    QVERIFY(m_project->undo());
    QCOMPARE(algorithm(), first);
    QCOMPARE(count(), stored + 1);
    QVERIFY(m_project->redo());
    QCOMPARE(algorithm(), std::string("later"));
    QCOMPARE(count(), stored + 1);
}

ODOGRAPH_TEST(TestChangeJournal, QCoreApplication)
#include "tst_change_journal.moc"
