// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/track/track_warnings.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;

/// A told colour that the floor has too, from the picture to the sentence.
class TestTrackWarnings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    static constexpr RgbColour wood{176, 148, 112}, red{215, 35, 40};

private Q_SLOTS:
    void colourOfTheFloor_data()
    {
        QTest::addColumn<bool>("woodenFloor");
        QTest::addColumn<bool>("toldWood");
        QTest::newRow("another colour") << true << false;
        QTest::newRow("a grey floor") << false << true;
        QTest::newRow("the floor's colour") << true << true;
    }
    void colourOfTheFloor()
    {
        QFETCH(bool, woodenFloor);
        QFETCH(bool, toldWood);
        SimulatedScene scene = demoTestbed(8);
        scene.durationS = 0.4;
        if (woodenFloor)
            scene.floor.colour = wood;
        SimulatedRobot body;
        body.name = std::string("r");
        body.colour = toldWood ? wood : red;
        body.motion = makeLineMotion({1.2, 0.8}, {1.8, 1.2}, 0, 2);
        scene.robots.push_back(body);
        RegisteredView view;
        view.recording.cameraName = std::string("A");
        view.file = m_folder.filePath(QStringLiteral("a.mkv")).toStdString();
        VideoWriterOptions options;
        options.codec = VideoCodec::Mjpeg;
        QVERIFY(renderVideo(scene, 0, view.file, options, {}));

        RobotRecord robot;
        robot.name = std::string("r");
        robot.colour = body.colour;
        const auto tracked = trackViews({view}, {robot}, {});
        QVERIFY(tracked.has_value());
        QCOMPARE(tracked->front().sharesAlike.size(), std::size_t(1));
        const double share = tracked->front().sharesAlike.front();
        qInfo("%.1f %% of the picture", 100 * share);
        const auto said = floorColourOf(robot, "t", {view}, *tracked, 0);
        QCOMPARE(said.has_value(), woodenFloor && toldWood);
        if (!said) {
            QVERIFY(share < 0.05);
            return;
        }
        QCOMPARE(said->error.code, ErrorCode::Undetermined);
        QCOMPARE(
            said->error.message(),
            "robot 'r' in trial 't': its colour #b09470 is also the floor's (" +
                std::to_string(std::lround(100 * share)) +
                " % of the frame in view A); put a plate of another colour on it, or set its true colour");
    }

    void howViewsAreInStep_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("sigmaS");
        QTest::addColumn<QString>("said");
        const QString unknown =
            QStringLiteral("view 'B' in trial 't': it is not synchronised: the same start time as the first "
                           "view was assumed, and positions of a moving robot are wrong; synchronise it "
                           "again with odograph trial set --sync auto, or enter the time offset");
        QTest::newRow("none") << "none" << 0.0 << unknown;
        QTest::newRow("sought and not found") << "open" << 0.0 << unknown;
        QTest::newRow("a word of a later program") << "" << 0.0 << unknown;
        QTest::newRow("by hand") << "told" << 0.0 << "";
        QTest::newRow("motion") << "auto" << 0.0004 << "";
        QTest::newRow("flash") << "flash" << 0.003 << "";
        QTest::newRow("motion that hardly tells")
            << "auto" << 0.0123
            << "view 'B' in trial 't': it is synchronised only to 12 ms, which is 12 mm at 1 m/s; turn the "
               "robot, or flash the room light, in view of both cameras";
    }
    void howViewsAreInStep()
    {
        QFETCH(QString, method);
        QFETCH(double, sigmaS);
        QFETCH(QString, said);
        std::vector<RegisteredView> views(3);
        const auto registered = [](RegisteredView &view) { view.floorView = demoTestbed(1).cameras[0].view; };
        registered(views[0]);
        views[1].recording.position = 1;
        views[1].recording.cameraName = std::string("B");
        views[1].recording.syncMethod = method.toStdString();
        views[1].recording.startOffsetSigmaS = sigmaS;
        views[2].recording.position = 2;
        views[2].recording.syncMethod = std::string("none");
        QVERIFY(stepWarnings("t", views).empty()); // only one view is measured with
        registered(views[1]);
        const auto sentences = stepWarnings("t", views);
        QCOMPARE(sentences.size(), std::size_t(said.isEmpty() ? 0 : 1));
        if (!said.isEmpty())
            QCOMPARE(QString::fromStdString(sentences.front().english()), said);
    }

    void whoItMayBeIsSaid_data()
    {
        using Doubts = std::vector<AmbiguousName>;
        using namespace std::chrono_literals;
        QTest::addColumn<Doubts>("ambiguities");
        QTest::addColumn<QString>("said");
        const QString subject = QStringLiteral("robot 'Blue 1' in trial 't': "),
                      advice = QStringLiteral("; give each its own colour");
        QTest::newRow("none") << Doubts{} << QString();
        QTest::newRow("one") << Doubts{{3204ms, 3898ms, {2}, {"Blue 2"}}}
                             << subject +
                                    QStringLiteral("from 3.20 s to 3.90 s this may be Blue 1 or Blue 2") +
                                    advice;
        QTest::newRow("three robots")
            << Doubts{{1s, 2s, {2, 3}, {"Blue 2", "Blue 3"}}}
            << subject + QStringLiteral("from 1.00 s to 2.00 s this may be Blue 1, Blue 2 or Blue 3") +
                   advice;
        QTest::newRow("not known who")
            << Doubts{{1s, 2s, {}, {}}}
            << subject +
                   QStringLiteral(
                       "from 1.00 s to 2.00 s this may be Blue 1 or another robot that looks the same") +
                   advice;
        QTest::newRow("twice")
            << Doubts{{1s, 2s, {3}, {"Blue 3"}}, {5s, 6s, {2}, {"Blue 2"}}}
            << subject +
                   QStringLiteral(
                       "from 1.00 s to 2.00 s (the first of 2 times) this may be Blue 1, Blue 2 or Blue 3") +
                   advice;
    }
    void whoItMayBeIsSaid()
    {
        QFETCH(std::vector<AmbiguousName>, ambiguities);
        QFETCH(QString, said);
        AnalysisRecord analysis;
        analysis.robotName = std::string("Blue 1");
        analysis.ambiguousNames = ambiguities;
        const auto sentences = analysisWarnings(analysis, "t");
        QCOMPARE(sentences.size(), std::size_t(said.isEmpty() ? 0 : 1));
        if (!said.isEmpty())
            QCOMPARE(QString::fromStdString(sentences.front().english()), said);
    }

    void viewsThatSeeDifferentThingsAreSaid()
    {
        AnalysisRecord analysis;
        analysis.robotName = std::string("Blue 1");
        analysis.views = {"A", "B"};
        analysis.profile.samples.resize(120);
        for (int i = 0; i < 100; ++i) { // one view alone saw the last twenty
            analysis.profile.samples[std::size_t(i)].viewDisagreementM = i < 11 ? 1.7 : 0.003;
            // more than their σ allow
            analysis.profile.samples[std::size_t(i)].flags = i < 10 ? flagBit(SampleFlag::ViewsDisagree) : 0;
        }
        QVERIFY(analysisWarnings(analysis, "t").empty());
        analysis.profile.samples[10].flags = flagBit(SampleFlag::ViewsDisagree);
        const auto sentences = analysisWarnings(analysis, "t");
        QCOMPARE(sentences.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(sentences.front().english()),
                 QStringLiteral(
                     "robot 'Blue 1' in trial 't': in 11 of 100 frames the views show it at positions far "
                     "apart: one of them tracks another object, or has moved since its registration; check "
                     "the outlines, and set the robot's colour or keep other objects out of view"));
    }

    void viewsThatContradictOneAnotherAreSaid()
    {
        AnalysisRecord analysis;
        analysis.robotName = std::string("Blue 1");
        analysis.views = {"A", "B"};
        analysis.profile.samples.resize(100);
        for (int i = 0; i < 100; ++i) {
            analysis.profile.samples[std::size_t(i)].viewDisagreementM = 0.02 + 1e-5 * i;
            analysis.profile.samples[std::size_t(i)].flags = i % 2 ? flagBit(SampleFlag::ViewsDisagree) : 0;
        }
        const auto sentences = analysisWarnings(analysis, "t");
        QCOMPARE(sentences.size(), std::size_t(1));
        QCOMPARE(
            QString::fromStdString(sentences.front().english()),
            QStringLiteral(
                "robot 'Blue 1' in trial 't': in 50 of 100 frames the views contradict each other: their "
                "floor positions differ by 20.5 mm; a camera has moved since its registration, the views are "
                "not synchronised, or the robot's height is wrong; register the cameras again"));
    }

    void whyTheViewsContradictIsSaid()
    {
        using Kind = ContradictionCause::Kind;
        AnalysisRecord analysis;
        analysis.robotName = "Blue 1";
        analysis.views = {"A", "B"};
        const auto said = [&](std::vector<ContradictionCause> causes) {
            analysis.profile.contradiction = ViewsContradiction{std::move(causes), 0.0219};
            const auto sentences = analysisWarnings(analysis, "t");
            return sentences.size() == 1 ? QString::fromStdString(sentences.front().english()) : QString();
        };
        const QString start =
            QStringLiteral("robot 'Blue 1' in trial 't': the views contradict each other by 21.9 mm: ");
        QCOMPARE(said({{Kind::CameraMoved, 1, 0, 2.83, {}}}),
                 start + QStringLiteral("camera B seems to have moved by 2.8 px since its registration; "
                                        "register it again and reanalyse"));
        QCOMPARE(said({{Kind::CameraMoved, 0, 0, 5, std::chrono::seconds(4)}}),
                 start +
                     QStringLiteral("camera A seems to have moved by 5.0 px at 4.0 s; use the time before "
                                    "that only"));
        QCOMPARE(said({{Kind::Offset, 1, 0, -0.04, {}}, {Kind::CamerasMoved, 0, 1, 3, {}}}),
                 start + QStringLiteral("the time offset of view B seems wrong by 40 ms, or cameras A and B "
                                        "seem to have moved since their registration; synchronise the views "
                                        "again and reanalyse"));
        QCOMPARE(said({{Kind::Height, 0, 0, -0.03, {}}}),
                 start +
                     QStringLiteral("the height given for the robot seems wrong by about 30 mm; measure its "
                                    "height, enter it and reanalyse"));
        QCOMPARE(said({{Kind::ClockRate, 1, 0, 0.0005, {}}}),
                 start +
                     QStringLiteral("the time offset of view B seems to change by 0.50 ms in each second; "
                                    "synchronise the views again and reanalyse"));
    }

    void aCameraThatMovedDuringTheRunIsNamed()
    {
        ObservationSeries series;
        series.algorithm = "silhouette 1";
        QVERIFY(!storedMove(series));
        series.algorithm += "; camera moved 2.83 px after 3733333333 ns";
        const auto move = storedMove(series);
        QVERIFY(move);
        RecordingRecord view;
        view.cameraName = "B";
        view.startOffsetS = 0.5;
        QCOMPARE(QString::fromStdString(movedSentence("t", view, *move).english()),
                 QStringLiteral("view 'B' in trial 't': the camera moved by 2.8 px after 4.2 s; what it saw "
                                "from then on was not measured; fix the camera, register it again and repeat "
                                "the run"));
    }

    void hardlyEverFoundIsAnError()
    {
        RobotRecord robot;
        robot.colour = wood;
        std::vector<TrackedView> tracked(1);
        tracked[0].sharesAlike = {0.31};
        tracked[0].series.resize(1);
        tracked[0].series[0].observations.resize(100);
        QVERIFY(floorColourOf(robot, "t", std::vector<RegisteredView>(1), tracked, 0)->hardlyEverFound);
        for (Observation &observation : tracked[0].series[0].observations)
            observation.found = true;
        QVERIFY(!floorColourOf(robot, "t", std::vector<RegisteredView>(1), tracked, 0)->hardlyEverFound);
        tracked[0].sharesAlike.clear(); // stored observations
        QVERIFY(!floorColourOf(robot, "t", std::vector<RegisteredView>(1), tracked, 0));
    }
};

ODOGRAPH_TEST(TestTrackWarnings, QCoreApplication)
#include "tst_track_warnings.moc"
