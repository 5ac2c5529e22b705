// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/colour_tracker.h"
#include "core/video/video_reader.h"
#include "tests/support/real_material.h"
#include "tests/support/registered_test.h"

#include <QtTest>

using namespace odo;

/// A person in a teal swim cap, told by its colour only.
class TestCapTwoViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void capIsFound_data();
    void capIsFound();
};

void TestCapTwoViews::capIsFound_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("given");
    QTest::addColumn<double>("firstX");
    QTest::addColumn<double>("firstY");
    QTest::addColumn<double>("lastX");
    QTest::addColumn<double>("lastY");
    // The places were read off the pictures by eye, to 10 px.
    for (const char *given : {"#2c717a", "#1c4a4f", "#3f9faa"}) {
        QTest::addRow("A %s", given) << QStringLiteral("A.mp4") << QString::fromLatin1(given) << 610.0
                                     << 464.0 << 292.0 << 462.0;
        QTest::addRow("B %s", given) << QStringLiteral("B.mp4") << QString::fromLatin1(given) << 252.0
                                     << 530.0 << 481.0 << 418.0;
    }
}

void TestCapTwoViews::capIsFound()
{
    ODOGRAPH_NEED_REAL("cap-two-views");
    QFETCH(QString, file);
    QFETCH(QString, given);
    QFETCH(double, firstX);
    QFETCH(double, firstY);
    QFETCH(double, lastX);
    QFETCH(double, lastY);
    const auto reader = VideoReader::open(realMaterial() / "cap-two-views" / file.toStdString());
    QVERIFY(reader);
    const auto tracker = ColourTracker::create({{"cap", *parseColour(given.toStdString())}});
    QVERIFY(tracker);
    std::vector<Observation> seen;
    while (const auto frame = (*reader)->next().value())
        seen.push_back((*tracker)->track(*frame).front());
    QCOMPARE(seen.size(), std::size_t(100));
    int found = 0;
    double leastScore = 1;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i].found)
            continue;
        ++found;
        leastScore = std::min(leastScore, seen[i].score);
        QVERIFY(!seen[i].touchesBorder);
        // A head at 60 frames/s: never more than 18 px from one frame to the next, 60 to 140 px wide.
        if (i > 0 && seen[i - 1].found)
            QVERIFY((seen[i].ellipse.centrePx - seen[i - 1].ellipse.centrePx).norm() < 18);
        QVERIFY(seen[i].ellipse.semiMajorPx > 30 && seen[i].ellipse.semiMajorPx < 70);
    }
    qInfo("found %d of 100, least score %.2f", found, leastScore);
    QVERIFY(found >= 99);
    QVERIFY((seen.front().ellipse.centrePx - Eigen::Vector2d(firstX, firstY)).norm() < 10);
    QVERIFY((seen.back().ellipse.centrePx - Eigen::Vector2d(lastX, lastY)).norm() < 10);
}

ODOGRAPH_TEST(TestCapTwoViews, QCoreApplication)
#include "tst_cap_two_views.moc"
