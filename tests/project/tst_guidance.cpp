// SPDX-License-Identifier: GPL-3.0-or-later
// What guides the tracker is kept with its recording, is undone like anything else, and goes with its trial.
#include "core/project/guidance_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/same_records.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;
using Kind = GuidanceItem::Kind;

class TestGuidance : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_project = std::make_unique<StoredProject>();
        m_filled = fill(**m_project, m_source).value();
    }

    void itemsRoundTrip()
    {
        GuidanceItem ignored = area(Kind::Ignore), searched = area(Kind::Search);
        searched.recording = m_filled.recordings[1];
        GuidanceItem point{0,  m_filled.recordings[0], m_filled.robot, Kind::Point, 7, 7, {{1.0 / 3, 719}},
                           1.5};
        GuidanceItem hidden{0, m_filled.recordings[0], m_filled.robot, Kind::Hidden, 3, 9, {}, 0};
        for (GuidanceItem *item : {&ignored, &searched, &point, &hidden}) {
            const auto stored = guidance().add(*item);
            QVERIFY2(stored, stored ? "" : stored.error().message().c_str());
            item->id = stored->id;
        }
        m_project->reopen();
        QVERIFY((all() == std::vector<GuidanceItem>{ignored, searched, point, hidden}));
        QVERIFY(guidance().remove(searched.id));
        QVERIFY((all() == std::vector<GuidanceItem>{ignored, point, hidden}));
        QCOMPARE(guidance().remove(searched.id).error().code, ErrorCode::NotFound);
        QVERIFY(guidance().of(m_filled.trial + 99)->empty());
    }

    void whatCannotBeMeantIsRefused_data()
    {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("why");
        QTest::newRow("two corners") << 0 << "an area needs at least 3 corners";
        QTest::newRow("many corners") << 1 << "an area has at most 100 corners";
        QTest::newRow("no number") << 2 << "a position is not in the frame";
        QTest::newRow("point without a sigma") << 3 << "it needs one position and a σ above 0 px";
        QTest::newRow("ends first") << 4 << "it ends before it starts";
    }
    void whatCannotBeMeantIsRefused()
    {
        QFETCH(int, which);
        QFETCH(QString, why);
        GuidanceItem item = area(Kind::Ignore);
        if (which == 0)
            item.pointsPx.resize(2);
        if (which == 1)
            item.pointsPx.resize(101, {1, 1});
        if (which == 2)
            item.pointsPx[1].x() = std::nan("");
        if (which == 3)
            item = {0, item.recording, m_filled.robot, Kind::Point, 7, 7, {{1, 1}}, 0};
        if (which == 4)
            item = {0, item.recording, m_filled.robot, Kind::Hidden, 7, 6, {}, 0};
        const auto stored = guidance().add(item);
        QVERIFY(!stored);
        QCOMPARE(stored.error().code, ErrorCode::InvalidInput);
        QVERIFY2(stored.error().message().find(why.toStdString()) != std::string::npos,
                 stored.error().message().c_str());
        QVERIFY(all().empty());
    }

    void itIsUndoneAndRedone()
    {
        Project &project = **m_project;
        QVERIFY(project.change(foreignWords("add"), [&]() -> Result<void> {
            return guidance().add(area(Kind::Ignore)).map([](const GuidanceItem &) {});
        }));
        const std::vector<GuidanceItem> added = all();
        QVERIFY(project.change(foreignWords("remove"), [&] { return guidance().remove(added.front().id); }));
        QVERIFY(all().empty());
        QVERIFY(project.undo());
        QVERIFY(all() == added);
        QVERIFY(project.undo());
        QVERIFY(all().empty());
        QVERIFY(project.redo());
        QVERIFY(all() == added);
    }

    void itGoesWithItsTrial()
    {
        QVERIFY(guidance().add(area(Kind::Ignore)));
        QVERIFY((*m_project)->trials().setBinned(m_filled.trial, true));
        const auto gone = (*m_project)->trials().removeForGood(m_filled.trial);
        QVERIFY2(gone, gone ? "" : gone.error().message().c_str());
        QVERIFY(all().empty());
    }

    /// Another program's row, which means nothing, is left out.
    void oddRowsAreLeftOut()
    {
        QVERIFY(guidance().add(area(Kind::Ignore)));
        QVERIFY(guidance().add(area(Kind::Search)));
        const std::string file = (*m_project)->file().string();
        {
            QSqlDatabase database =
                QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("odd rows"));
            database.setDatabaseName(QString::fromStdString(file));
            QVERIFY(database.open());
            QSqlQuery query(database);
            QVERIFY(query.exec(QStringLiteral("UPDATE guidance SET from_frame=-4 WHERE kind='search'")));
        }
        QSqlDatabase::removeDatabase(QStringLiteral("odd rows"));
        QCOMPARE(all().size(), std::size_t(1));
        QCOMPARE(all().front().kind, Kind::Ignore);
    }

private:
    GuidanceRepository &guidance() { return (*m_project)->guidance(); }
    std::vector<GuidanceItem> all() { return guidance().of(m_filled.trial).value(); }
    GuidanceItem area(Kind kind) const
    {
        return {0, m_filled.recordings[0], 0, kind, 0, 0, {{0, 0}, {100.5, 0}, {1.0 / 3, 80}}, 0};
    }

    RecordSource m_source{7};
    std::unique_ptr<StoredProject> m_project;
    FilledProject m_filled;
};

ODOGRAPH_TEST(TestGuidance, QCoreApplication)
#include "tst_guidance.moc"
