// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/flash_synchronisation.h"
#include "tests/support/registered_test.h"
#include "tests/synchronisation/synthetic_light.h"

#include <QTest>
#include <algorithm>

using namespace odo;
using namespace odo::test;

namespace {

/// The lamp goes up for a while.
std::vector<LightStep> flash(double startS, double lengthS, double light = 1.6)
{
    return {{startS, light}, {startS + lengthS, 1}};
}

std::vector<LightStep> together(std::initializer_list<std::vector<LightStep>> parts)
{
    std::vector<LightStep> all;
    for (const auto &part : parts)
        all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end(),
              [](const LightStep &a, const LightStep &b) { return a.timeS < b.timeS; });
    return all;
}

/// Root mean square of the errors, and of the errors in stated σ, over many draws of the moments.
struct Scatter
{
    double errorS = 0, inSigmas = 0, sigmaS = 0;
    int known = 0;
};

} // namespace

class TestFlashSynchronisation : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void statesItsError_data();
    void statesItsError();
    void findsTheEdges();
    void slowChangesAreNoEdges_data();
    void slowChangesAreNoEdges();
    void matchesSeveralFlashesByTheirIntervals();
    void saysWhenFlashesFitAlike();
    void saysWhenThereIsNoFlash();
    void findsTheRateFromFlashesFarApart();
};

void TestFlashSynchronisation::statesItsError_data()
{
    QTest::addColumn<double>("lengthS"); // of the flash; 0: the lamp stays on
    QTest::addColumn<double>("exposureA");
    QTest::addColumn<double>("exposureB");
    QTest::addColumn<double>("rateB");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("mostErrorS");
    const double frame = 1 / 30.0;
    QTest::newRow("lamp on, short exposure") << 0.0 << 0.004 << 0.004 << 30.0 << 1.0 << 0.45 * frame;
    QTest::newRow("lamp on, long exposure") << 0.0 << 0.030 << 0.030 << 30.0 << 2.2 << 0.2 * frame;
    QTest::newRow("lamp on, rolling shutter") << 0.0 << 0.045 << 0.050 << 30.0 << 2.2 << 0.25 * frame;
    QTest::newRow("flash of 0.4 s") << 0.4 << 0.008 << 0.020 << 30.0 << 2.2 << 0.35 * frame;
    QTest::newRow("flash of 0.4 s, 25 frames/s") << 0.4 << 0.008 << 0.020 << 25.0 << 2.2 << 0.4 * frame;
    QTest::newRow("flash of 60 ms") << 0.06 << 0.008 << 0.008 << 30.0 << 1.0 << 0.45 * frame;
    QTest::newRow("flash of 3 ms, full exposure") << 0.003 << 0.033 << 0.033 << 30.0 << 1.0 << 0.45 * frame;
    QTest::newRow("against a fast camera") << 0.4 << 0.01 << 0.004 << 120.0 << 1.0 << 0.35 * frame;
}

void TestFlashSynchronisation::statesItsError()
{
    QFETCH(double, lengthS);
    QFETCH(double, exposureA);
    QFETCH(double, exposureB);
    QFETCH(double, rateB);
    QFETCH(double, gamma);
    QFETCH(double, mostErrorS);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(0, 1);
    Scatter scatter;
    constexpr int draws = 300;
    for (int i = 0; i < draws; ++i) {
        const double startS = 3 + any(random), offsetS = -1 + 2 * any(random);
        // 3 ms need a stronger lamp to be seen in 33 ms.
        std::vector<LightStep> steps = flash(startS, lengthS, lengthS > 0 && lengthS < 0.01 ? 6 : 1.6);
        if (lengthS == 0)
            steps.pop_back();
        LightFilm a, b;
        a.exposureS = exposureA;
        b.exposureS = exposureB;
        b.startS = offsetS;
        b.framesPerSecond = rateB;
        a.gamma = b.gamma = gamma;
        const auto found = estimateFlashOffset(lightCourseOf(filmLight(steps, a, random)),
                                               lightCourseOf(filmLight(steps, b, random)));
        if (!found)
            continue;
        ++scatter.known;
        const double error = found->offsetS - offsetS;
        scatter.errorS += error * error;
        scatter.inSigmas += error * error / (found->sigmaS * found->sigmaS);
        scatter.sigmaS += found->sigmaS;
    }
    scatter.errorS = std::sqrt(scatter.errorS / scatter.known);
    scatter.inSigmas = std::sqrt(scatter.inSigmas / scatter.known);
    qInfo("%d of %d: RMS %.2f ms, mean stated sigma %.2f ms, RMS in sigmas %.2f", scatter.known, draws,
          1e3 * scatter.errorS, 1e3 * scatter.sigmaS / scatter.known, scatter.inSigmas);
    QVERIFY(scatter.known >= 0.95 * draws);
    QVERIFY(scatter.errorS < mostErrorS);
    // Stated with a tenth of a frame that only a robot seen through a rolling shutter needs.
    QVERIFY(scatter.inSigmas > 0.3 && scatter.inSigmas < 1.25);
}

void TestFlashSynchronisation::findsTheEdges()
{
    std::mt19937 random(1);
    const auto edges = findLightEdges(filmLight(together({flash(2, 0.5), {{6.0, 0.4}}}), {}, random));
    QCOMPARE(edges.size(), std::size_t(3));
    const double times[] = {2.0, 2.5, 6.0};
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(std::abs(edges[i].timeS - times[i]) < 0.017);
        QVERIFY(edges[i].sigmaS > 0.001 && edges[i].sigmaS < 0.015);
        QCOMPARE(edges[i].brighter, i == 0);
    }
}

void TestFlashSynchronisation::slowChangesAreNoEdges_data()
{
    QTest::addColumn<int>("which");
    QTest::newRow("nothing") << 0;
    QTest::newRow("35 % up in a second") << 1;
    QTest::newRow("35 % down in a third of a second") << 2;
    QTest::newRow("beat of lamps, 10 %") << 3;
    QTest::newRow("a robot passes: 3 % at once") << 4;
}

void TestFlashSynchronisation::slowChangesAreNoEdges()
{
    QFETCH(int, which);
    LightFilm film;
    const auto ramp = [](double change, double lengthS) {
        return [=](double t) { return 1 + change * std::clamp((t - 4) / lengthS, 0.0, 1.0); };
    };
    if (which == 1)
        film.gain = ramp(0.35, 1);
    if (which == 2)
        film.gain = ramp(-0.35, 0.33);
    if (which == 3)
        film.gain = [](double t) { return 1 + 0.1 * std::sin(2 * M_PI * 100 * t); };
    std::mt19937 random(2);
    auto levels = filmLight({}, film, random);
    if (which == 4)
        for (std::size_t i = 100; i < levels.size(); ++i)
            levels[i].level *= 1.03;
    QCOMPARE(findLightEdges(levels).size(), std::size_t(0));
    // Most of the picture has to change, not a part of it much.
    if (which == 0) {
        for (std::size_t i = 100; i < levels.size(); ++i)
            levels[i].level *= 1.3;
        QCOMPARE(findLightEdges(levels).size(), std::size_t(0));
        levels[100].changedShare = 0.9;
        QCOMPARE(findLightEdges(levels).size(), std::size_t(1));
    }
}

void TestFlashSynchronisation::matchesSeveralFlashesByTheirIntervals()
{
    std::mt19937 random(3);
    const auto seen = together({flash(2, 0.3), flash(3.1, 0.3), flash(5, 0.3), flash(7.7, 0.3)});
    const auto missed = together({flash(2, 0.3), flash(5, 0.3), flash(7.7, 0.3)});
    LightFilm a, b;
    b.startS = 1.4; // the flash at 3.1 s went unseen there
    // Its automatic exposure takes the light back within a second.
    a.gain = [](double t) { return t > 5 && t < 5.3 ? std::exp(-0.3 * (t - 5)) : 1.0; };
    const auto found = estimateFlashOffset(lightCourseOf(filmLight(seen, a, random)),
                                           lightCourseOf(filmLight(missed, b, random)));
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(std::abs(found->offsetS - 1.4) < 3 * found->sigmaS);
    QVERIFY(found->sigmaS < 0.010);
    QCOMPARE(found->score, 0.75);
}

void TestFlashSynchronisation::saysWhenFlashesFitAlike()
{
    std::mt19937 random(3);
    // The second camera saw two of three flashes a second apart, and was off before or after the other.
    const auto steps = together({flash(4, 0.3), flash(5, 0.3), flash(6, 0.3)});
    LightFilm a, b;
    b.startS = 4.5;
    b.durationS = 2.4;
    a.startS = 3.5;
    a.durationS = 3.3;
    const auto found = estimateFlashOffset(lightCourseOf(filmLight(steps, a, random)),
                                           lightCourseOf(filmLight(steps, b, random)));
    QVERIFY(!found);
    QCOMPARE(found.error().code, ErrorCode::Undetermined);
    QVERIFY2(found.error().why.english().find("fit equally well at time offsets of") != std::string::npos,
             found.error().why.english().c_str());
}

void TestFlashSynchronisation::saysWhenThereIsNoFlash()
{
    std::mt19937 random(3);
    const auto lit = lightCourseOf(filmLight(flash(3, 0.5), {}, random)),
               dull = lightCourseOf(filmLight({}, {}, random)),
               darker = lightCourseOf(filmLight({{3, 0.5}}, {}, random)),
               brighter = lightCourseOf(filmLight({{3, 1.5}}, {}, random));
    const auto why = [](const LightCourse &a, const LightCourse &b) {
        const auto found = estimateFlashOffset(a, b);
        return found ? std::string() : found.error().message();
    };
    QVERIFY(why(dull, dull).find("neither view shows a flash") != std::string::npos);
    QVERIFY(why(lit, dull).find("only one of the views shows a flash") != std::string::npos);
    QVERIFY(why(dull, lit).find("only one of the views shows a flash") != std::string::npos);
    QVERIFY(why(darker, brighter).find("do not match") != std::string::npos);
    QVERIFY(
        why(dull, lit).find("flash the room lights once while both cameras record, or give --sync SECONDS") !=
        std::string::npos);
    QVERIFY(why({}, {}).find("neither view") != std::string::npos);
}

void TestFlashSynchronisation::findsTheRateFromFlashesFarApart()
{
    // At the start and at the end of ten minutes: 200 ppm make 115 ms between them, each known to some 8 ms.
    std::mt19937 random(5);
    const auto steps = together({flash(5, 0.3), flash(12, 0.3), flash(580, 0.3), flash(590, 0.3)});
    LightFilm a, b;
    a.durationS = b.durationS = 600;
    b.startS = 0.7;
    b.driftPpm = 200;
    const auto found = estimateFlashOffset(lightCourseOf(filmLight(steps, a, random)),
                                           lightCourseOf(filmLight(steps, b, random)));
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY2(std::abs(found->rate - 200e-6) < 3 * found->rateSigma, qPrintable(QString::number(found->rate)));
    QVERIFY(found->rateSigma > 1e-6 && found->rateSigma < 30e-6);
    QVERIFY(std::abs(found->offsetS - 0.7) < 3 * found->sigmaS);
}

ODOGRAPH_TEST(TestFlashSynchronisation, QCoreApplication)
#include "tst_flash_synchronisation.moc"
