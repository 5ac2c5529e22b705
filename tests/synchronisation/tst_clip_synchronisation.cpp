// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/clip_synchronisation.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;

namespace {

using Path = Eigen::Vector2d (*)(double);

Eigen::Vector2d slowingCurve(double t)
{
    return {0.6 * t - 0.02 * t * t, 0.5 * std::sin(0.9 * t) + 0.1 * std::sin(2.3 * t)};
}
Eigen::Vector2d straight(double t)
{
    return {0.5 * t, 0.2 * t};
}
Eigen::Vector2d circle(double t)
{
    return {std::cos(2 * t), std::sin(2 * t)};
}
Eigen::Vector2d wandering(double t)
{
    return {0.8 * std::sin(0.31 * t) + 0.2 * std::sin(1.7 * t + 1),
            0.6 * std::cos(0.23 * t) + 0.15 * std::sin(1.3 * t)};
}
Eigen::Vector2d standing(double)
{
    return {1, 1};
}

/// A view whose first frame is taken at startS: local times from 0, positions with white noise and a constant
/// shift.
std::vector<TimedPosition> view(Path path, double startS, double rate, double noiseM, Eigen::Vector2d shift,
                                unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, noiseM);
    std::vector<TimedPosition> track;
    for (int i = 0; i < int(8 * rate); ++i) {
        const Eigen::Vector2d position = path(startS + i / rate);
        track.push_back({i / rate, position + shift + Eigen::Vector2d(noise(random), noise(random))});
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
        QTest::addColumn<double>("firstRate");
        QTest::addColumn<double>("secondRate");
        // took minutes when the search went by half frames
        QTest::newRow("1000/s") << 1.2345 << 1000.0 << 1000.0;
        QTest::newRow("240/s") << -2.5 << 30.0 << 240.0;
        for (const double offset : {0.0, 0.0137, -0.41, 1.2345, -2.5}) {
            QTest::addRow("%g s", offset) << offset << 30.0 << 30.0;
            QTest::addRow("%g s, 25/s", offset) << offset << 30.0 << 25.0;
        }
    }
    void findsTheOffset()
    {
        QFETCH(double, offset);
        QFETCH(double, firstRate);
        QFETCH(double, secondRate);
        // 3 mm of noise and 40 mm of parallax: at about 0.6 m/s and 240 frames the offset is known to about
        // 0.4 ms.
        const auto first = view(slowingCurve, 3, firstRate, 0.003, {0, 0}, 1);
        const auto second = view(slowingCurve, 3 + offset, secondRate, 0.003, {0.03, -0.026}, 2);
        const auto found = estimateClipOffset(first, second, {0, 4});
        QVERIFY2(found.has_value(), found ? "" : found.error().message().c_str());
        QVERIFY2(std::abs(found->offsetS - offset) < 0.003,
                 qPrintable(QString::number(found->offsetS - offset)));
        QVERIFY(std::abs(found->offsetS - offset) < 4 * found->sigmaS);
        QVERIFY(found->score > 0.99);
    }
    void findsTheRateOfTheClocks_data()
    {
        QTest::addColumn<double>("ppm");
        for (const double ppm : {200.0, -150.0, 0.0})
            QTest::addRow("%g ppm", ppm) << ppm;
    }
    void findsTheRateOfTheClocks()
    {
        QFETCH(double, ppm);
        // In 60 s 200 ppm make 12 ms. 3 mm of noise in both views at 0.55 m/s, 1800 pictures: the offset is
        // known to 0.2 ms, the rate to that by 17 s (the spread of the times), 9 ppm; told is four times
        // that, for neighbouring residuals are never taken to be independent.
        constexpr double offset = 0.1234, rate = 30;
        const auto track = [&](double startS, double drift, Eigen::Vector2d shift, unsigned seed) {
            std::mt19937 random(seed);
            std::normal_distribution<double> noise(0, 0.003);
            std::vector<TimedPosition> positions;
            for (int i = 0; i < int(60 * rate); ++i) {
                const double t = startS + i / rate / (1 + drift);
                positions.push_back({i / rate, wandering(1.5 * t) * (1 + shift.x()) + shift +
                                                   Eigen::Vector2d(noise(random), noise(random))});
            }
            return positions;
        };
        const auto found = estimateClipOffset(track(3, 0, {0, 0}, 7),
                                              track(3 + offset, ppm * 1e-6, {0.02, -0.01}, 8), {0, 2});
        QVERIFY2(found.has_value(), found ? "" : found.error().message().c_str());
        QVERIFY(found->rateSigma > 1e-6 && found->rateSigma < 40e-6);
        QVERIFY2(std::abs(found->rate - ppm * 1e-6) < 27e-6, qPrintable(QString::number(found->rate)));
        QVERIFY(ppm != 0 || found->rate == 0); // what is not significant is not taken
        QVERIFY2(std::abs(found->offsetS - offset) < 0.001,
                 qPrintable(QString::number(found->offsetS - offset)));
        QVERIFY(std::abs(found->offsetS - offset) < 4 * found->sigmaS);
    }
    void aLongStraightRunStaysUndetermined()
    {
        // Noise makes the estimated velocity vary, and in a long run that is much, but no motion.
        const auto run = [](double startS, unsigned seed) {
            std::mt19937 random(seed);
            std::normal_distribution<double> noise(0, 0.003);
            std::vector<TimedPosition> positions;
            for (int i = 0; i < 3000; ++i)
                positions.push_back(
                    {i / 30.0, Eigen::Vector2d(0.05 * (startS + i / 30.0) + noise(random), noise(random))});
            return positions;
        };
        const auto found = estimateClipOffset(run(0, 9), run(0.2, 10), {0, 1});
        QVERIFY(!found.has_value());
        QVERIFY2(found.error().why.english().find("straight") != std::string::npos,
                 found.error().message().c_str());
    }
    void isNotFooledByGaps()
    {
        auto first = view(slowingCurve, 3, 30, 0.003, {0, 0}, 3);
        auto second = view(slowingCurve, 3.2, 30, 0.003, {0, 0}, 4);
        second.erase(second.begin() + 60, second.begin() + 110);
        const auto found = estimateClipOffset(first, second, {0, 4});
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
        const auto found = estimateClipOffset(first, second, {0, 4});
        QVERIFY(!found.has_value());
        QCOMPARE(found.error().code, ErrorCode::Undetermined);
        QVERIFY2(found.error().message().find(words.toStdString()) != std::string::npos,
                 found.error().message().c_str());
        QVERIFY(found.error().message().find("--sync SECONDS") != std::string::npos);
    }
};

ODOGRAPH_TEST(TestClipSynchronisation, QCoreApplication)
#include "tst_clip_synchronisation.moc"
