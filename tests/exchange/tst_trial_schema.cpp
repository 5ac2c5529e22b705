// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/trial_json.h"
#include "tests/support/json_schema.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <limits>

using namespace odo;
using namespace odo::test;

/// What `export --format json` writes fits docs/trial.schema.json, which other programs may rely on.
class TestTrialSchema : public QObject
{
    Q_OBJECT

    const JsonSchema m_schema{QStringLiteral("docs/trial.schema.json")};

    static AnalysisRecord everyKindOfThing()
    {
        AnalysisRecord analysis;
        analysis.robot = 7;
        analysis.robotName = "red";
        analysis.views = {"A", "B"};
        analysis.registrations = {3, 0};
        analysis.options.overrides = {{0, true}};
        Profile &profile = analysis.profile;
        for (int i = 0; i < 3; ++i) {
            Sample sample;
            sample.time = Nanoseconds(i * 33333333);
            sample.flags = i == 0 ? SampleFlags(0x1ff) : 0; // all there are
            if (i < 2)
                sample.position = Eigen::Vector2d(i, -1);
            profile.samples.push_back(sample);
            profile.points.push_back(
                {{0.25, -1.5}, {0, 2}, {0.5, 0}, 0.001, 0.002, 2, 0.0625, 0.5, 0.25, i < 2});
        }
        profile.points[1].accelMps2 = std::numeric_limits<double>::infinity();
        profile.metrics = {{"max_speed", "m/s", 2, 0.0625}, {"duration", "s", 0.5, std::nullopt}};
        profile.spikes = {{0, Nanoseconds(0), flagBit(SampleFlag::Jump), foreignWords("jump of 8 mm")}};
        for (const GateRole role :
             {GateRole::Start, GateRole::Finish, GateRole::StartFinish, GateRole::Split})
            profile.passages.push_back({"gate", role, Nanoseconds(1), 0.001, 0});
        return analysis;
    }
    static QJsonObject written(const std::vector<AnalysisRecord> &analyses,
                               const std::vector<ImportedTrack> &imported, const TrialVerdict &verdict = {})
    {
        RecordingRecord recording;
        recording.cameraName = "A";
        recording.frameTimes.resize(3);
        return QJsonDocument::fromJson(
                   QByteArray::fromStdString(trialJson({}, {recording}, analyses, imported, verdict)))
            .object();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_schema.isRead()); }
    void fits()
    {
        QCOMPARE(m_schema.problemsOf(written({everyKindOfThing()}, {})), QStringList());
        QCOMPARE(m_schema.problemsOf(written({}, {})), QStringList());
        TrialVerdict verdict{{{"few_spikes", CheckLevel::Doubtful, foreignWords("30 spikes")}}, {}};
        QCOMPARE(m_schema.problemsOf(written({everyKindOfThing()}, {}, verdict)), QStringList());
        verdict.acceptance = {"a cat", {}, {"few_spikes"}};
        const QJsonObject accepted = written({everyKindOfThing()}, {}, verdict);
        QCOMPARE(m_schema.problemsOf(accepted), QStringList());
        QCOMPARE(accepted[QStringLiteral("verdict")][QStringLiteral("accepted_reason")].toString(),
                 QStringLiteral("a cat"));
        ImportedTrack source;
        source.robot = 7;
        source.format = "tum";
        const QJsonObject imported = written({everyKindOfThing()}, {source});
        QCOMPARE(m_schema.problemsOf(imported), QStringList());
        QCOMPARE(imported[QStringLiteral("robots")][0][QStringLiteral("analysis")][QStringLiteral("imported")]
                         [QStringLiteral("format")]
                             .toString(),
                 QStringLiteral("tum"));
    }
    /// The test itself can fail.
    void whatDoesNotFitIsFound()
    {
        QJsonObject document = written({everyKindOfThing()}, {});
        document.insert(QStringLiteral("more"), 1);
        document.insert(QStringLiteral("version"), 2);
        document.remove(QStringLiteral("views"));
        QJsonObject robot = document[QStringLiteral("robots")][0].toObject();
        robot.insert(QStringLiteral("name"), 5);
        document.insert(QStringLiteral("robots"), QJsonArray{robot});
        QStringList problems = m_schema.problemsOf(document);
        problems.sort();
        QCOMPARE(problems, (QStringList{QStringLiteral("/more: is not told"),
                                        QStringLiteral("/robots/0/name: is of another type"),
                                        QStringLiteral("/version: is none of those"),
                                        QStringLiteral("/views: is missing")}));
    }
};

ODOGRAPH_TEST(TestTrialSchema, QCoreApplication)
#include "tst_trial_schema.moc"
