// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// Verdicts on the command line: of tracks with a short gap (doubtful), with a long one (bad), and without.
class TestVerdicts : public QObject, CallingTest
{
    Q_OBJECT

    QJsonObject verdict(const char *trial) const
    {
        return run(QStringLiteral("show %P %1 --json").arg(QLatin1String(trial)))
            .json()[u"verdict"_s]
            .toObject();
    }
    QString level(const char *trial) const { return verdict(trial)[u"level"_s].toString(); }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(good("new %P").exitStatus, 0);
        write("whole.csv", gappedTrack(0));
        write("short.csv", gappedTrack(2));
        write("long.csv", gappedTrack(5.5));
        for (const char *name : {"whole", "short", "long"})
            QCOMPARE(run(QStringLiteral("import %P --trial %1 --track red=%/%1.csv").arg(QLatin1String(name)))
                         .exitStatus,
                     0);
    }

    void theyAreListedAndShown()
    {
        QCOMPARE(level("whole"), u"pass"_s);
        QCOMPARE(level("short"), u"doubtful"_s);
        QCOMPARE(level("long"), u"bad"_s);
        QVERIFY(!verdict("short")[u"accepted"_s].toBool());
        QVERIFY(verdict("short")[u"accepted_reason"_s].isNull());
        QStringList listed;
        const QJsonArray trials = good("list %P --json").json()[u"trials"_s].toArray();
        for (const QJsonValue &trial : trials)
            listed << trial[u"name"_s].toString() + u' ' + trial[u"verdict"_s][u"level"_s].toString();
        listed.sort();
        QCOMPARE(listed, (QStringList{u"long bad"_s, u"short doubtful"_s, u"whole pass"_s}));
        const ProgramRun compared = good("compare %P whole short --json");
        QCOMPARE(compared.json()[u"verdicts"_s][1][u"level"_s].toString(), u"doubtful"_s);
    }

    void oneIsAcceptedAndWithdrawn()
    {
        QCOMPARE(run(QStringLiteral("trial accept %P short --reason behind_the_box")).exitStatus, 0);
        QVERIFY(verdict("short")[u"accepted"_s].toBool());
        QCOMPARE(verdict("short")[u"accepted_reason"_s].toString(), u"behind_the_box"_s);
        QVERIFY(good("show %P short").out.contains("Verdict: doubtful, accepted"));
        const QJsonObject exported =
            QJsonDocument::fromJson(good("export %P short -o - --format json").out).object();
        QVERIFY(exported[u"verdict"_s][u"accepted"_s].toBool());
        QCOMPARE(good("trial withdraw %P short --json").json()[u"accepted"_s], QJsonValue(false));
        QVERIFY(!verdict("short")[u"accepted"_s].toBool());
    }

    void badCallsFailInOneLine_data()
    {
        beginBadCalls();
        addBadCall("trial accept %P long --reason x", 1, "bad results cannot be accepted");
        addBadCall("trial accept %P whole --reason x", 1, "all checks were passed");
        addBadCall("trial accept %P short", 2, "reason");
        addBadCall("trial accept %P nobody --reason x", 1, "nobody");
        addBadCall("trial withdraw %P whole", 1, "nobody accepted it");
        addBadCall("trial praise %P short", 2, "accept P.odo TRIAL");
    }
    void badCallsFailInOneLine() { badCallFailsInOneLine(); }
};

ODOGRAPH_TEST(TestVerdicts, QCoreApplication)
#include "tst_verdicts.moc"
