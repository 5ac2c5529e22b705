// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curves/simplified_line.h"

#include "tests/support/registered_test.h"

#include <QLineF>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace odo;

namespace {

double distanceTo(const QPointF &point, const QPointF &from, const QPointF &to)
{
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double part =
        square > 0 ? std::clamp(QPointF::dotProduct(point - from, along) / square, 0.0, 1.0) : 0;
    return QLineF(point, from + part * along).length();
}

/// The farthest that any point lies from the line that took its place, piece by piece.
double farthest(const QPolygonF &line, const QPolygonF &kept)
{
    double most = 0;
    qsizetype piece = 0;
    for (const QPointF &point : line) {
        while (piece + 2 < kept.size() && point == kept[piece + 1])
            ++piece;
        double nearest = distanceTo(point, kept[piece], kept[std::min(piece + 1, kept.size() - 1)]);
        if (piece > 0)
            nearest = std::min(nearest, distanceTo(point, kept[piece - 1], kept[piece]));
        most = std::max(most, nearest);
    }
    return most;
}

QPolygonF circle(int points, double radius)
{
    QPolygonF line;
    for (int i = 0; i < points; ++i)
        line << QPointF(radius * std::cos(0.01 * i), radius * std::sin(0.01 * i));
    return line;
}

} // namespace

class TestSimplifiedLine : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsBeyondTheEdgesIsLeftOut()
    {
        QList<QPolygonF> pieces;
        const auto take = [&pieces](const QPolygonF &piece) { pieces << piece; };
        const QPolygonF points{{-50, 50}, {-10, 50},  {10, 50},  {90, 50}, {150, 50},
                               {200, 50}, {200, -50}, {50, -50}, {50, 20}};
        SeenLine line(0.2, QRectF(0, 0, 100, 100), take);
        for (const QPointF &point : points)
            line.add(point);
        line.end();
        QCOMPARE(pieces, (QList<QPolygonF>{{{-10, 50}, {150, 50}}, {{50, -50}, {50, 20}}}));
        pieces.clear();
        line.add({20, 20}); // another line does not go on from the one before
        line.add({30, 20});
        line.cut();
        line.add({30, 40});
        line.end();
        QCOMPARE(pieces, (QList<QPolygonF>{{{20, 20}, {30, 20}}, {{30, 20}, {30, 40}}}));
        pieces.clear();
        SeenLine all(0.2, {}, take);
        for (const QPointF &point : points)
            all.add(point);
        all.end();
        QCOMPARE(pieces, QList<QPolygonF>{simplified(points, 0.2)});
    }
    void shortLinesStay()
    {
        for (const QPolygonF &line :
             {QPolygonF(), QPolygonF({QPointF(1, 2)}), QPolygonF({QPointF(1, 2), QPointF(1, 2)})})
            QCOMPARE(simplified(line, 0.2), line);
    }
    void aStraightLineNeedsItsEnds()
    {
        QPolygonF line;
        for (int i = 0; i < 1000; ++i)
            line << QPointF(i, 0.5 * i);
        QCOMPARE(simplified(line, 0.2), QPolygonF({line.front(), line.back()}));
    }
    void turningPointsStay()
    {
        QPolygonF line; // to 100 and back to 40 on the same way
        for (int i = 0; i <= 100; ++i)
            line << QPointF(i, 0);
        for (int i = 99; i >= 40; --i)
            line << QPointF(i, 0);
        const QPolygonF kept = simplified(line, 0.2);
        QVERIFY(kept.contains(QPointF(100, 0)));
        QCOMPARE(kept.back(), QPointF(40, 0));
        QVERIFY(kept.size() <= 4);
    }
    void aSpikeStays()
    {
        QPolygonF line;
        for (int i = 0; i < 300; ++i)
            line << QPointF(i, i == 150 ? 1.0 : 0.0);
        QVERIFY(simplified(line, 0.2).contains(QPointF(150, 1)));
    }
    void nothingIsFartherThanTheTolerance_data()
    {
        QTest::addColumn<QPolygonF>("line");
        QTest::newRow("circle") << circle(1800, 120);
        QTest::newRow("standing") << QPolygonF(500, QPointF(3, 4));
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0, 0.15), wild(0, 3);
        QPolygonF noisy = circle(1800, 120), wander({QPointF(0, 0)});
        for (QPointF &point : noisy)
            point += QPointF(noise(random), noise(random));
        for (int i = 0; i < 2000; ++i)
            wander << wander.back() + QPointF(wild(random), wild(random));
        QTest::newRow("noisy circle") << noisy;
        QTest::newRow("wandering") << wander;
    }
    void nothingIsFartherThanTheTolerance()
    {
        QFETCH(QPolygonF, line);
        for (const double tolerance : {0.1, 0.2, 1.0}) {
            const QPolygonF kept = simplified(line, tolerance);
            QCOMPARE(kept.front(), line.front());
            QCOMPARE(kept.back(), line.back());
            // Beyond the end of a piece a point may lie by the tolerance along and across: √2.
            QVERIFY2(farthest(line, kept) <= 1.4143 * tolerance,
                     qPrintable(QString::number(farthest(line, kept))));
        }
    }
    void aTrailOfAMinuteBecomesATenth() { QVERIFY(simplified(circle(1800, 120), 0.2).size() < 180); }
};

ODOGRAPH_TEST(TestSimplifiedLine, QCoreApplication)
#include "tst_simplified_line.moc"
