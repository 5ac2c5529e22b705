// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/models/shown_names.h"
#include "ui/school/internal/conflict_dialog.h"
#include "ui/school/internal/conflict_rows.h"

#include <QApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QListWidget>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTest>

using namespace odo;

class TestConflictRows : public QObject
{
    Q_OBJECT
    static SchoolConflict conflictOf(const QJsonObject &ours, const QJsonObject &theirs,
                                     SchoolKind kind = SchoolKind::Trial)
    {
        return {kind, "uuid", "Run 1", ours, theirs, true};
    }
    /// "what: here | there" of each.
    static QStringList lines(const SchoolConflict &conflict)
    {
        QStringList lines;
        for (const ConflictRow &row : conflictRows(conflict))
            lines << QStringLiteral("%1: %2 | %3").arg(row.what, row.here, row.there);
        return lines;
    }
    static QJsonObject notes(const char *words)
    {
        return {{QStringLiteral("notes"), QString::fromLatin1(words)}};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        showPseudonyms(false);
    }

    void onlyWhatDiffersIsShown()
    {
        const QJsonObject ours{
            {QStringLiteral("name"), QStringLiteral("Run 1")},
            {QStringLiteral("starred"), true},
            {QStringLiteral("tags"), QJsonArray{QStringLiteral("a"), QStringLiteral("b")}}};
        const QJsonObject theirs{{QStringLiteral("name"), QStringLiteral("Run 1")},
                                 {QStringLiteral("starred"), false},
                                 {QStringLiteral("tags"), QJsonArray{QStringLiteral("a")}}};
        QCOMPARE(lines(conflictOf(ours, theirs)),
                 QStringList({QStringLiteral("Starred: yes | no"), QStringLiteral("Tags 2: b | ")}));
    }

    /// Below the key that holds it.
    void aPartOfAPartIsNamed()
    {
        const auto trial = [](const char *team) {
            return QJsonObject{
                {QStringLiteral("team"), QJsonObject{{QStringLiteral("name"), QString::fromLatin1(team)}}}};
        };
        QCOMPARE(lines(conflictOf(trial("Falcon"), trial("Heron"))),
                 QStringList(QStringLiteral("Team › Name: Falcon | Heron")));
        QCOMPARE(lines(conflictOf(trial("Falcon"), {})),
                 QStringList(QStringLiteral("Team › Name: Falcon | ")));
    }

    /// The samples of a run are not among what is compared.
    void versionsThatLookAlikeSaySo()
    {
        QCOMPARE(lines(conflictOf(notes("same"), notes("same"))),
                 QStringList(QStringLiteral("Measured values: this version | another version")));
    }

    void pupilsAreHiddenWherePseudonymsAreShown()
    {
        const auto team = [](const char *member) {
            return QJsonObject{
                {QStringLiteral("members"),
                 QJsonArray{QJsonObject{{QStringLiteral("name"), QString::fromLatin1(member)}}}}};
        };
        const SchoolConflict conflict = conflictOf(team("Ada"), team("Ben"), SchoolKind::Team);
        QCOMPARE(lines(conflict), QStringList(QStringLiteral("Members 1 › Name: Ada | Ben")));
        showPseudonyms(true);
        QCOMPARE(lines(conflict), QStringList(QStringLiteral("Members 1 › Name: (hidden) | (hidden)")));
        showPseudonyms(false);
    }

    void hugeValuesStayWithinBounds()
    {
        QJsonArray many;
        for (int i = 0; i < 5000; ++i)
            many.append(i);
        const std::vector<ConflictRow> rows = conflictRows(
            conflictOf({{QStringLiteral("tags"), many}, {QStringLiteral("notes"), QString(100'000, u'x')}},
                       {{QStringLiteral("notes"), QStringLiteral("short")}}));
        QCOMPARE(rows.size(), std::size_t(300));
        QVERIFY(rows.front().here.size() <= 300);
    }

    void theDialogShowsBothValues()
    {
        ConflictDialog dialog({conflictOf(notes("ours"), notes("theirs")),
                               {SchoolKind::Task, "other", "Slalom", notes("1"), notes("2"), false}});
        const auto *values = dialog.findChild<QTableWidget *>();
        QCOMPARE(values->rowCount(), 1);
        QCOMPARE(values->item(0, 1)->text(), QStringLiteral("ours"));
        QCOMPARE(values->item(0, 2)->text(), QStringLiteral("theirs"));
        dialog.findChild<QListWidget *>()->setCurrentRow(1);
        QCOMPARE(values->item(0, 2)->text(), QStringLiteral("2"));
    }
};

ODOGRAPH_TEST(TestConflictRows, QApplication)
#include "tst_conflict_rows.moc"
