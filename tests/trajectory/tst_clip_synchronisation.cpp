// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/clip_synchronisation.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;

namespace {

using Path = Eigen::Vector2d (*)(double);

Eigen::Vector2d slowingCurve(double t) { return {0.6 * t - 0.02 * t * t, 0.5 * std::sin(0.9 * t) + 0.1 * std::sin(2.3 * t)}; }
Eigen::Vector2d straight(double t) { return {0.5 * t, 0.2 * t}; }
Eigen::Vector2d circle(double t) { return {std::cos(2 * t), std::sin(2 * t)}; }
Eigen::Vector2d standing(double) { return {1, 1}; }

/// A view whose first frame is taken at startS: local times from 0, positions with white noise and a constant shift.
std::vector<TimedPosition> view(Path path, double startS, double rate, double noiseM, Eigen::Vector2d shift, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, noiseM);
    std::vector<TimedPosition> track;
    for (int i = 0; i < int(8 * rate); ++i) {
        const Eigen::Vector2d place = path(startS + i / rate);
        track.push_back({i / rate, place + shift + Eigen::Vector2d(noise(random), noise(random))});
    }
    return track;
}

} // namespace

class TestClipSynchronisation : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void findsTheOffset_data()
    {
        QTest::addColumn<double>("offset");
        QTest::addColumn<double>("secondRate");
        for (const double offset : {0.0, 0.0137, -0.41, 1.2345, -2.5}) {
            QTest::addRow("%g s", offset) << offset << 30.0;
            QTest::addRow("%g s, 25/s", offset) << offset << 25.0;
        }
    }
    void findsTheOffset()
    {
        QFETCH(double, offset);
        QFETCH(double, secondRate);
        // 3 mm of noise and 40 mm of parallax: at about 0.6 m/s and 240 frames the offset is known to about 0.4 ms.
        const auto first = view(slowingCurve, 3, 30, 0.003, {0, 0}, 1);
        const auto second = view(slowingCurve, 3 + offset, secondRate, 0.003, {0.03, -0.026}, 2);
        const auto found = estimateClipOffset(first, second, 4);
        QVERIFY2(found.has_value(), found ? "" : found.error().message().c_str());
        QVERIFY2(std::abs(found->offsetS - offset) < 0.003, qPrintable(QString::number(found->offsetS - offset)));
        QVERIFY(std::abs(found->offsetS - offset) < 4 * found->sigmaS);
        QVERIFY(found->score > 0.99);
    }
    void isNotFooledByGaps()
    {
        auto first = view(slowingCurve, 3, 30, 0.003, {0, 0}, 3);
        auto second = view(slowingCurve, 3.2, 30, 0.003, {0, 0}, 4);
        second.erase(second.begin() + 60, second.begin() + 110);
        const auto found = estimateClipOffset(first, second, 4);
        QVERIFY(found.has_value());
        QVERIFY(std::abs(found->offsetS - 0.2) < 0.003);
    }
    void saysWhenTheMotionDoesNotTell_data()
    {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("words");
        QTest::newRow("straight at constant speed") << 0 << QStringLiteral("straight");
        QTest::newRow("standing") << 1 << QStringLiteral("stood still");
        QTest::newRow("round and round") << 2 << QStringLiteral("repeats");
        QTest::newRow("too short") << 3 << QStringLiteral("fewer than");
    }
    void saysWhenTheMotionDoesNotTell()
    {
        QFETCH(int, which);
        QFETCH(QString, words);
        constexpr Path paths[] = {straight, standing, circle, slowingCurve};
        auto first = view(paths[which], 3, 30, 0.003, {0, 0}, 5);
        const auto second = view(paths[which], 3.3, 30, 0.003, {0, 0}, 6);
        if (which == 3)
            first.resize(10);
        const auto found = estimateClipOffset(first, second, 4);
        QVERIFY(!found.has_value());
        QCOMPARE(found.error().code, ErrorCode::Undetermined);
        QVERIFY2(found.error().message().find(words.toStdString()) != std::string::npos, found.error().message().c_str());
        QVERIFY(found.error().message().find("--sync SECONDS") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(TestClipSynchronisation)
#include "tst_clip_synchronisation.moc"
