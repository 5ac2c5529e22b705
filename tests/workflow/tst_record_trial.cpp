// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/record_trial.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestRecordTrial : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(
            *Project::create(m_folder->filePath(QStringLiteral("p.odo")).toStdString(), "Recording"));
    }
    void cleanup() { m_project.reset(); }

    /// Half a second, and what the camera saw in the second before; the files' hashes are there at once.
    void thePreRollIsRecordedToo()
    {
        const RecordSettings settings{
            .trial = "run", .cameras = {{"A", "sim:A"}}, .seconds = 0.5, .preRollS = 1, .robots = {}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        const auto trial = m_project->trials().find("run");
        QVERIFY(trial && !trial->unfinished);
        QVERIFY2(trial->durationS > 1.2,
                 qPrintable(QString::number(trial->durationS))); // a picture or two at each end
        QVERIFY(!m_project->trials().recordings(trial->id)->front().sha256.empty());
        QVERIFY(m_project->check(true)->empty());
    }

    void whatCannotBeDoneIsRefused_data()
    {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<double>("preRollS");
        QTest::addColumn<QByteArray>("why");
        QTest::newRow("no time") << 0.0 << 0.0 << QByteArray("it would take no time, or more than a day");
        QTest::newRow("more than is kept")
            << 1.0 << 60.0 << QByteArray("what is kept from before is no time, or more than 10 s");
        QTest::newRow("no number") << 1.0 << std::nan("")
                                   << QByteArray("what is kept from before is no time, or more than 10 s");
    }
    void whatCannotBeDoneIsRefused()
    {
        QFETCH(double, seconds);
        QFETCH(double, preRollS);
        QFETCH(QByteArray, why);
        const RecordSettings settings{.trial = "run",
                                      .cameras = {{"A", "sim:A"}},
                                      .seconds = seconds,
                                      .preRollS = preRollS,
                                      .robots = {}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY(!recorded);
        QCOMPARE(recorded.error().why, why.toStdString());
        QVERIFY(m_project->trials().all()->empty());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

QTEST_GUILESS_MAIN(TestRecordTrial)
#include "tst_record_trial.moc"
