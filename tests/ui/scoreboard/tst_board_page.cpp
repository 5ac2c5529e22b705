// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/slalom_lesson.h"
#include "ui/models/shown_names.h"
#include "ui/scoreboard/internal/board_page.h"

#include <QApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace odo;
using namespace odo::test;

namespace {

QJsonObject teamAt(const QJsonObject &state, int index)
{
    return state[QStringLiteral("teams")].toArray().at(index).toObject();
}

QString field(const QJsonObject &object, const char *name)
{
    return object[QLatin1String(name)].toString();
}

} // namespace

class TestBoardPage : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    const BoardLanguages m_languages;

    BoardContent content(const StandingsChoice &choice = {})
    {
        const auto read = BoardReader(*m_project, choice).read();
        return read ? *read : (qWarning("%s", read.error().message().c_str()), BoardContent());
    }
    QJsonObject state(const char *language = "en", const StandingsChoice &choice = {})
    {
        return boardState(content(choice), *m_languages.find(language), Instant());
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = makeSlalomLesson(m_folder->path().toStdString());
    }
    void cleanup()
    {
        showPseudonyms(false);
        m_project.reset();
    }

    void withoutARunItSaysSo()
    {
        const QJsonObject empty = state();
        QCOMPARE(field(empty, "empty"), QStringLiteral("No team has a result yet."));
        QCOMPARE(empty[QStringLiteral("teams")].toArray().size(), 0);
        QVERIFY(!empty.contains(QStringLiteral("map")));
        QVERIFY(boardMap(content(), m_languages.preferred({})).isEmpty());
    }

    /// One run each, ±0.05 s: 0.07 s is not significant (1.96·√2·0.05 = 0.14), 0.8 s is.
    void teamsThatDoNotDifferShareARank()
    {
        addSlalomRun(*m_project, "Falcon", 8.20);
        addSlalomRun(*m_project, "Heron", 9.00);
        addSlalomRun(*m_project, "Otter", 8.27);
        const QJsonObject shown = state();
        QCOMPARE(field(shown, "task"), QStringLiteral("Slalom"));
        QCOMPARE(field(shown, "unit"), QStringLiteral("s"));
        QCOMPARE(field(teamAt(shown, 0), "team"), QStringLiteral("Falcon"));
        QCOMPARE(field(teamAt(shown, 0), "rank"), QStringLiteral("1"));
        QVERIFY(!teamAt(shown, 0).contains(QStringLiteral("behind")));
        QCOMPARE(field(teamAt(shown, 1), "team"), QStringLiteral("Otter"));
        QCOMPARE(field(teamAt(shown, 1), "rank"), QStringLiteral("1"));
        QCOMPARE(field(teamAt(shown, 1), "behind"), QStringLiteral("+0.07"));
        QVERIFY(teamAt(shown, 1)[QStringLiteral("isNear")].toBool());
        QCOMPARE(field(teamAt(shown, 2), "rank"), QStringLiteral("3"));
        QCOMPARE(field(teamAt(shown, 2), "behind"), QStringLiteral("+0.80"));
        QVERIFY(!teamAt(shown, 2)[QStringLiteral("isNear")].toBool());
    }

    void bestAndLastRunOfEachTeam()
    {
        for (const double seconds : {9.0, 8.0, 8.5})
            addSlalomRun(*m_project, "Falcon", seconds);
        const QJsonObject team = teamAt(state(), 0);
        QCOMPARE(field(team, "value"), QStringLiteral("8.5"));
        QCOMPARE(field(team, "best"), QStringLiteral("8.00"));
        QCOMPARE(field(team, "last"), QStringLiteral("8.50"));
        QCOMPARE(field(team, "runs"), QStringLiteral("3"));
        QCOMPARE(field(state(), "mapWords"), QStringLiteral("Falcon · 8.00 ±0.05\u00a0s"));
    }

    /// The map is of the best run, and another one only where that changes.
    void theMapIsOfTheBestRun()
    {
        addSlalomRun(*m_project, "Falcon", 8.20);
        BoardReader reader(*m_project, {});
        const BoardContent first = *reader.read();
        const QByteArray map = boardMap(first, m_languages.preferred({}));
        QXmlStreamReader xml(map);
        int lines = 0;
        while (!xml.atEnd())
            lines +=
                xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("polyline");
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QVERIFY(lines > 0);
        addSlalomRun(*m_project, "Heron", 9.0);
        QCOMPARE((*reader.read()).mapVersion, first.mapVersion);
        addSlalomRun(*m_project, "Heron", 7.0);
        const BoardContent third = *reader.read();
        QCOMPARE(third.mapVersion, first.mapVersion + 1);
        QCOMPARE(third.bestTeam, std::string("Heron"));
        QVERIFY(third.scene->robots.front().observations.empty());
    }

    void everyLanguageHasItsWordsAndNumbers()
    {
        addSlalomRun(*m_project, "Falcon", 8.20);
        addSlalomRun(*m_project, "Heron", 9.00);
        QCOMPARE(field(teamAt(state("de"), 0), "best"), QStringLiteral("8,20"));
        QCOMPARE(field(teamAt(state("zh-CN"), 0), "best"), QStringLiteral("8.20"));
        const QByteArray english = boardPage(*m_languages.find("en"));
        QVERIFY(english.contains("<html lang=\"en\">"));
        QVERIFY(!english.contains("{{"));
        for (const char *tag : {"de", "es", "fr", "ko", "zh-CN"}) {
            const BoardLanguage *language = m_languages.find(tag);
            QVERIFY2(language, tag);
            const QByteArray page = boardPage(*language);
            QVERIFY2(page.contains("<html lang=\"" + QByteArray(tag) + "\">"), tag);
            QVERIFY2(!page.contains("{{") && !page.contains(">Best run<") && !page.contains("share a rank"),
                     tag);
            QVERIFY2(state(tag)[QStringLiteral("facts")] != state()[QStringLiteral("facts")], tag);
        }
    }

    /// As everywhere: tenths of a point at the finest.
    void pointsAreShownToTenths()
    {
        const Metric score{"score", "points", 21.6634, 0.003};
        const NumberText english = m_languages.find("en")->number(score, 21.6634, 0.003);
        QCOMPARE(english.text(), QStringLiteral("21.7\u00a0points"));
        QCOMPARE(m_languages.find("de")->number(score, 71.8, 0.31).text(),
                 QStringLiteral("71,8 ±0,3\u00a0Punkte"));
        QCOMPARE(m_languages.find("de")->metric("score"), QStringLiteral("Punkte"));
    }

    void theBrowserChoosesTheLanguage_data()
    {
        QTest::addColumn<QByteArray>("accepted");
        QTest::addColumn<QByteArray>("tag");
        QTest::newRow("none") << QByteArray() << QByteArray("en");
        QTest::newRow("german") << QByteArray("de-AT,de;q=0.9,en;q=0.5") << QByteArray("de");
        QTest::newRow("by weight") << QByteArray("en;q=0.3, fr;q=0.8") << QByteArray("fr");
        QTest::newRow("unknown first") << QByteArray("pl,ko;q=0.5") << QByteArray("ko");
        QTest::newRow("chinese") << QByteArray("zh-Hans-CN") << QByteArray("zh-CN");
        QTest::newRow("not wanted") << QByteArray("de;q=0") << QByteArray("en");
        QTest::newRow("nonsense") << QByteArray(";;,q=,,=;q=x") << QByteArray("en");
    }
    void theBrowserChoosesTheLanguage()
    {
        QFETCH(QByteArray, accepted);
        QFETCH(QByteArray, tag);
        QCOMPARE(m_languages.preferred(accepted).tag(), tag);
    }

    /// Trials and robots may have the names of pupils.
    void onlyTeamsAreNamed()
    {
        auto team = m_project->teams().find("Falcon");
        team->pseudonym = "Lion";
        QVERIFY(m_project->teams().set(*team));
        addSlalomRun(*m_project, "Falcon", 8.20);
        const auto text = [this] {
            return QJsonDocument(state()).toJson() + boardMap(content(), m_languages.preferred({}));
        };
        QVERIFY(text().contains("Falcon"));
        QVERIFY(!text().contains("Run 1") && !text().contains("Red"));
        showPseudonyms(true);
        QVERIFY(text().contains("Lion") && !text().contains("Falcon"));
    }

    void namesStayOnOneLine()
    {
        auto team = m_project->teams().find("Falcon");
        team->name = "<b>" + std::string(190, 'W');
        QVERIFY(m_project->teams().set(*team));
        addSlalomRun(*m_project, team->name, 8.20);
        const QString shown = field(teamAt(state(), 0), "team");
        QCOMPARE(shown.size(), 80);
        QVERIFY(shown.startsWith(QStringLiteral("<b>W")) && shown.endsWith(u'…'));
    }

    void withoutATaskNobodyIsRanked()
    {
        const BoardContent read = content({"", "", "max_speed"});
        QVERIFY(read.reading.standings.teams.empty());
        addSlalomRun(*m_project, "Falcon", 8.20);
        QVERIFY(m_project->trials().setTask(m_project->trials().find("Run 1")->id, ""));
        const QJsonObject shown = state();
        QCOMPARE(field(teamAt(shown, 0), "rank"), QString());
        QVERIFY(shown[QStringLiteral("notes")].toArray().at(0).toString().startsWith(
            QStringLiteral("No ranks: ")));
    }

    void unknownChoicesAreErrors()
    {
        const auto noClass = BoardReader(*m_project, {"7C", "", ""}).read();
        QCOMPARE(noClass.error().code, ErrorCode::NotFound);
        QVERIFY(noClass.error().message().find("the project has '9B'") != std::string::npos);
        QCOMPARE(BoardReader(*m_project, {"", "Sprint", ""}).read().error().code, ErrorCode::NotFound);
    }
};

ODOGRAPH_TEST(TestBoardPage, QApplication)
#include "tst_board_page.moc"
