// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/printed_text.h"
#include "ui/models/number_text.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/trial_report.h"

#include <QApplication>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

std::shared_ptr<TrialContent> contentOf(const std::shared_ptr<TrialScene> &scene)
{
    auto content = std::make_shared<TrialContent>();
    content->scene = scene;
    content->calibrationRmsPx.resize(scene->views.size());
    content->stillTime = tellingMoment(*scene);
    content->stills = takeStills(*scene, content->stillTime, 200);
    return content;
}

std::shared_ptr<TrialScene> exampleCopy(const ExampleOptions &options = {.frames = 90})
{
    auto scene = std::make_shared<TrialScene>(*exampleScene(options));
    scene->trial.name = "Third attempt";
    scene->trial.className = "9B";
    scene->trial.teamName = "Falcon";
    for (SceneRobot &robot : scene->robots)
        robot.analysis->profile.metrics = {
            {"duration", "s", 9.84, 0.006},     {"path_length", "m", 12.375, 0.005},
            {"max_speed", "m/s", 1.935, 0.005}, {"mean_speed", "m/s", 1.2577, 0.001},
            {"max_accel", "m/s²", 3.76, 0.16},  {"straightness", "1", 0.42, 0.001}};
    return scene;
}

} // namespace

class TestTrialReport : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    /// Where the pages were printed; every word of them must lie within the margins, less what a letter
    /// overhangs.
    QString printed(const ReportPages &pages)
    {
        const QString file = test::printed(pages, m_folder);
        constexpr double pointsPerUnit = 72 / PageFormat::unitsPerInch, overhang = 3;
        const double margin = PageFormat::margin * pointsPerUnit - overhang;
        const PrintedWords words = printedWords(file);
        for (const PrintedWord &word : words.words) {
            const QRectF paper(QPointF(0, 0), words.pageSizes.at(word.page - 1));
            if (!paper.adjusted(margin, margin, -margin, -margin).contains(word.box))
                qFatal("'%s' lies beyond the margin of page %d", qPrintable(word.text), word.page);
        }
        return file;
    }

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aPageTellsTheRun()
    {
        auto content = contentOf(exampleCopy({.frames = 90, .videoFolder = m_folder.path().toStdString()}));
        content->classMedians["max_speed"] = {1.71, 12};
        content->calibrationRmsPx[0] = 0.213;
        ReportOptions options;
        options.letterhead = {QStringLiteral("Lindenschule"), QStringLiteral("Room 12"), {}};
        const QString file = printed(trialPages(content, options));
        QCOMPARE(printedWords(file).pageSizes.size(), 1);
        QCOMPARE(fontsNotEmbedded(file), QStringList());
        const QString text = printedText(file).simplified();
        for (const char *words : {"Lindenschule",
                                  "Room 12",
                                  "Third attempt",
                                  "Class: 9B",
                                  "Team: Falcon",
                                  "Robot: Red 2",
                                  "Top speed",
                                  "1.935",
                                  "m/s ±0.005",
                                  "class median 1.71 m/s",
                                  "The run from above",
                                  "Speed, m/s",
                                  "Acceleration along the path, m/s²",
                                  "What happened",
                                  "Straightness",
                                  "0.4200 ±0.0010",
                                  "Remarks",
                                  "lens calibrated to 0.21 px",
                                  "90 frames at 30.00/s, 0 missing",
                                  "Kalman/RTS, noise from the data"})
            QVERIFY2(text.contains(QString::fromUtf8(words)),
                     qPrintable(QString::fromUtf8(words) + QStringLiteral(" is not in: ") + text));
    }
    void longWordsOfAnEventTakeTwoLines()
    {
        const auto scene = exampleCopy();
        Profile &profile = scene->robots.front().analysis->profile;
        profile.spikes = {
            {.sampleIndex = 40,
             .time = profile.samples[40].time,
             .reason = foreignWords("views disagree by 25 mm, none could be trusted, jump of 112 mm")}};
        const QString text = printedText(printed(trialPages(contentOf(scene), {}))).simplified();
        for (const char *words : {"Spike: views disagree by 25 mm,", "jump of 112 mm", "Remarks"})
            QVERIFY2(text.contains(QString::fromUtf8(words)),
                     qPrintable(QString::fromUtf8(words) + QStringLiteral(" is not in: ") + text));
        QVERIFY2(!text.contains(u'…'), qPrintable(text));
    }
    void remarksSayWhenTheRobotIsDoubtful()
    {
        const auto scene = exampleCopy();
        scene->robots.front().analysis->ambiguousNames = {{1200ms, 1500ms, {7}, {"Blue 1"}},
                                                          {2s, 2500ms, {8}, {"Blue 2"}}};
        for (const char *notes : {"", "Slipped on the line"}) {
            scene->trial.notes = notes;
            const QString text = printedText(printed(trialPages(contentOf(scene), {}))).simplified();
            const QString doubt = QStringLiteral(
                "from 1.20 s to 1.50 s (the first of 2 times) this may be Red 2, Blue 1 or Blue 2.");
            QVERIFY2(text.contains(doubt) && text.contains(QString::fromUtf8(notes)), qPrintable(text));
        }
        scene->robots.front().analysis->ambiguousNames.clear();
        QVERIFY(!printedText(printed(trialPages(contentOf(scene), {}))).contains(QStringLiteral("doubtful")));
    }
    void remarksSayWhenTheRobotWasHidden()
    {
        const auto scene = exampleCopy();
        const auto hidden = [](Nanoseconds from, Nanoseconds to) {
            return Occlusion{{from, to}, OcclusionCause::HiddenBehind, "A", "Blue 1"};
        };
        scene->robots.front().occlusions = {hidden(1200ms, 1500ms), hidden(2s, 2100ms), hidden(3s, 3900ms)};
        const QString text = printedText(printed(trialPages(contentOf(scene), {}))).simplified();
        QVERIFY2(text.contains(QStringLiteral("hidden behind Blue 1 in view A (3.00 s to 3.90 s); hidden "
                                              "behind Blue 1 in view A (1.20 s to 1.50 s); 3 times in all.")),
                 qPrintable(text));
    }
    void aVaryingRateIsPrinted()
    {
        auto scene = exampleCopy();
        std::vector<Nanoseconds> &times = scene->views.front().recording.frameTimes;
        for (std::size_t i = 0; i < times.size(); ++i)
            times[i] = 40ms * static_cast<int>(i) + (i % 5 == 4 ? 25ms : 0ms);
        const QString text = printedText(printed(trialPages(contentOf(scene), {}))).simplified();
        QCOMPARE(text.count(QStringLiteral("15 to 65 ms apart")), 1); // of the two views
        QVERIFY2(text.indexOf(QStringLiteral("15 to 65 ms apart")) <
                     text.indexOf(QStringLiteral("B: 90 frames")),
                 qPrintable(text));
    }
    void paperHasItsSize()
    {
        const auto content = contentOf(exampleCopy());
        ReportOptions options;
        const auto sizeOf = [&] {
            return printedWords(printed(trialPages(content, options))).pageSizes.first();
        };
        QVERIFY(qAbs(sizeOf().width() - 595.3) < 1 && qAbs(sizeOf().height() - 841.9) < 1);
        options.paper = Paper::Letter;
        QVERIFY(qAbs(sizeOf().width() - 612) < 1 && qAbs(sizeOf().height() - 792) < 1);
    }
    void eachRobotHasAPage()
    {
        const auto content = contentOf(exampleCopy({.frames = 60, .robots = 2}));
        ReportOptions options;
        options.withMethod = true;
        const QString file = printed(trialPages(content, options));
        QCOMPARE(printedWords(file).pageSizes.size(), 4);
        QVERIFY(printedText(file, 1).contains(QStringLiteral("Third attempt – Red 2")));
        QVERIFY(printedText(file, 2).contains(QStringLiteral("Red 2: method")));
        QVERIFY(printedText(file, 2).simplified().contains(QStringLiteral("How the metrics were computed")));
        QVERIFY(printedText(file, 3).contains(QStringLiteral("Third attempt – Blue 1")));
    }
    void aTrialWithoutFiguresSaysSo()
    {
        auto scene = exampleCopy();
        scene->robots.front().analysis.reset();
        ReportOptions options;
        options.withMethod = true;
        const QString file = printed(trialPages(contentOf(scene), options));
        QCOMPARE(printedWords(file).pageSizes.size(), 1);
        const QString text = printedText(file);
        QVERIFY(text.contains(QStringLiteral("has not been tracked yet")));
        QVERIFY(text.contains(QStringLiteral("the video is missing")));
    }
    void whyAPictureIsLackingIsSaid()
    {
        auto scene = exampleCopy();
        QVERIFY(scene->views.size() == 2);
        QFile damaged(m_folder.filePath(QStringLiteral("damaged.mkv")));
        QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("no video") > 0 && damaged.flush());
        scene->views.front().file = damaged.fileName().toStdString();
        const QString text = printedText(printed(trialPages(contentOf(scene), {})));
        QCOMPARE(text.count(QStringLiteral("no image: the video cannot be read")), 1);
        QCOMPARE(text.count(QStringLiteral("no image: the video is missing")), 1);
    }
    void viewsCanBeOneOrNone()
    {
        auto scene = exampleCopy();
        scene->views.resize(1);
        QVERIFY(!printedText(printed(trialPages(contentOf(scene), {}))).contains(QStringLiteral("B: ")));
        scene->views.clear();
        const QString text = printedText(printed(trialPages(contentOf(scene), {})));
        QVERIFY(text.contains(QStringLiteral("The run from above")));
        QVERIFY(!text.contains(QStringLiteral("The cameras")));
    }
    void namesComeOutAsTheyAre_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("shown");
        QTest::newRow("markup") << QStringLiteral("<b>A&amp;B</b>") << QStringLiteral("<b>A&amp;B</b>");
        QTest::newRow("formula") << QStringLiteral("=1+1") << QStringLiteral("=1+1");
        QTest::newRow("path") << QStringLiteral("../../etc/x") << QStringLiteral("../../etc/x");
        QTest::newRow("order turned around") << QStringLiteral("ab\u202Ecd") << QStringLiteral("ab\uFFFDcd");
        QTest::newRow("letters that join")
            << QStringLiteral("office fjord flip") << QStringLiteral("office fjord flip");
        QTest::newRow("lines") << QStringLiteral("one\ntwo\tthree")
                               << QStringLiteral("one\uFFFDtwo\uFFFDthree");
        QTest::newRow("placeholder") << QStringLiteral("%1 %2 %n") << QStringLiteral("%1 %2 %n");
    }
    void namesComeOutAsTheyAre()
    {
        QFETCH(QString, name);
        QFETCH(QString, shown);
        auto scene = exampleCopy();
        scene->trial.name = scene->trial.teamName = scene->trial.className = name.toStdString();
        scene->robots.front().robot.name = scene->views.front().camera = scene->trial.notes =
            name.toStdString();
        const QString text = printedText(printed(trialPages(contentOf(scene), {})));
        QVERIFY2(text.contains(shown), qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("Team: ") + shown));
    }
    void zonesStandOnTheMap()
    {
        auto scene = exampleCopy();
        if (!scene->task)
            scene->task.emplace();
        const std::string before = printed(trialPages(contentOf(scene), {})).toStdString();
        QVERIFY(!printedText(QString::fromStdString(before)).contains(QStringLiteral("Pond")));
        // NOLINTNEXTLINE(misc-misleading-bidirectional): such a name is what is printed
        scene->task->zones = {
            rectangularZone("Pond \xE2\x80\xAE", ZoneRule::StayOutside, {0.2, 0.2}, {1.4, 1.2})};
        const QString text = printedText(printed(trialPages(contentOf(scene), {})));
        QVERIFY2(text.contains(QString::fromUtf8("Pond \uFFFD")), qPrintable(text));
    }
    void longNamesAreCut()
    {
        auto scene = exampleCopy();
        const std::string longName(10000, 'W');
        scene->trial.name = scene->trial.teamName = scene->trial.className = scene->trial.task = longName;
        scene->robots.front().robot.name = scene->views.front().camera = longName;
        scene->trial.notes = "many words " + longName + " and more of them";
        for (int i = 0; i < 40; ++i)
            scene->robots.front().analysis->profile.passages.push_back(
                {longName, GateRole::Split, fromSeconds(0.05 * i), 0.01, 0.01});
        ReportOptions options;
        options.withMethod = true;
        options.letterhead = {QString(10000, u'M'), QString(10000, u'M'),
                              QImage(3000, 10, QImage::Format_RGB32)};
        printed(trialPages(contentOf(scene), options)); // every word is looked at there
    }
    void unitsAreThoseThatAreShown()
    {
        setShownUnitSystem(UnitSystem::Inches);
        const QString text = printedText(printed(trialPages(contentOf(exampleCopy()), {})));
        setShownUnitSystem(UnitSystem::Millimetres);
        const QString &speed = unitsOf(UnitSystem::Inches).speed.name;
        QVERIFY2(text.contains(QStringLiteral("Speed, ") + speed), qPrintable(text));
    }
    void anHourIsDrawnInFewLines()
    {
        auto scene = exampleCopy();
        Profile &profile = scene->robots.front().analysis->profile;
        const Profile once = profile;
        while (profile.samples.size() < 100000)
            for (std::size_t i = 0; i < once.samples.size(); ++i) {
                profile.samples.push_back(once.samples[i]);
                profile.samples.back().time =
                    profile.samples[profile.samples.size() - 2].time + fromSeconds(1 / 30.0);
                profile.points.push_back(once.points[i]);
            }
        const QString file = printed(trialPages(contentOf(scene), {}));
        QVERIFY2(QFileInfo(file).size() < 3'000'000, qPrintable(QString::number(QFileInfo(file).size())));
    }
    void theSamePageIsAPictureToo()
    {
        const auto pages = trialPages(contentOf(exampleCopy()), {});
        const QImage image = pageImage(pages.front(), 800);
        QCOMPARE(image.size(), QSize(800, 1131));
        int inked = 0;
        for (int x = 0; x < 800; ++x)
            inked += image.pixelColor(x, 150).lightness() < 250 ? 1 : 0;
        QVERIFY(inked > 10 && inked < 700);
    }
};

ODOGRAPH_TEST(TestTrialReport, QApplication)
#include "tst_trial_report.moc"
