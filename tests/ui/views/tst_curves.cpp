// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <cmath>

using namespace odo;

class TestCurves : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ticksAreRound_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<int>("most");
        QTest::addColumn<QString>("labels");
        QTest::newRow("speed") << 0.0 << 2.2 << 4 << QStringLiteral("0 1 2 3");
        QTest::newRow("halves") << 0.0 << 1.9 << 4 << QStringLiteral("0.0 0.5 1.0 1.5 2.0");
        QTest::newRow("signed") << -4.9 << 5.1 << 5 << QStringLiteral("-6 -4 -2 0 2 4 6");
        QTest::newRow("exact ends") << 0.0 << 2.0 << 2 << QStringLiteral("0 1 2");
        QTest::newRow("nothing") << 3.0 << 3.0 << 2 << QStringLiteral("2.5 3.0 3.5");
        QTest::newRow("not a number") << std::nan("") << 1.0 << 2 << QStringLiteral("-0.5 0.0 0.5");
    }
    void ticksAreRound()
    {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(int, most);
        QFETCH(QString, labels);
        const AxisTicks ticks = coveringTicks(low, high, most);
        QStringList words;
        for (const double value : ticks.values())
            words += ticks.label(value, QLocale::c());
        QCOMPARE(words.join(u' '), labels);
    }
    void ticksInsideARange()
    {
        const AxisTicks ticks = niceTicks(0.0, 9.97, 12);
        QCOMPARE(ticks.count, 10);
        QCOMPARE(ticks.last(), 9.0);
        QCOMPARE(niceTicks(1, 1, 5).count, 0);
    }
    void accelerationIsAlongThePath()
    {
        ProfilePoint point{};
        point.velocity = {2, 0};
        point.acceleration = {-1, 5};
        point.accelMps2 = point.acceleration.norm();
        point.valid = true;
        const auto acceleration = [&point] {
            Profile profile;
            profile.samples.resize(1);
            profile.points = {point};
            return curveValues(profile, Quantity::Acceleration)[0]->value;
        };
        QCOMPARE(acceleration(), -1.0); // it brakes
        point.velocity.setZero();
        QCOMPARE(acceleration(), point.accelMps2);
    }
    void headingAndTurnRateAreInDegrees()
    {
        // Towards +Y at 1 m/s, turning left at 2 rad/s; then it stands.
        ProfilePoint moving{};
        moving.position.setZero();
        moving.velocity = {0, 1};
        moving.acceleration = {-2, 0};
        moving.speedMps = 1;
        moving.sigmaSpeedMps = 0.01;
        moving.valid = true;
        ProfilePoint standing = moving;
        standing.velocity.setZero();
        standing.acceleration.setZero();
        Profile profile;
        profile.points = {moving, standing};
        profile.samples.resize(2);
        const auto headings = curveValues(profile, Quantity::Heading);
        QCOMPARE(headings[0]->value, 90.0);
        QVERIFY(std::abs(headings[0]->sigma - 0.01 * 180 / M_PI) < 1e-9);
        QCOMPARE(headings[1]->value, 90.0); // kept
        const auto rates = curveValues(profile, Quantity::TurnRate);
        QVERIFY(std::abs(rates[0]->value - 2 * 180 / M_PI) < 1e-9);
        QVERIFY(!rates[1].has_value());
    }
    void gapsSplitACurve()
    {
        Profile profile = exampleScene({.frames = 60})->robots[0].analysis->profile;
        profile.points[20].valid = profile.points[21].valid = false;
        const std::vector<double> positions = sampleTimes(profile);
        const auto runs = curveRuns(curveValues(profile, Quantity::Speed), positions, piecesOf(profile));
        QCOMPARE(runs.size(), std::size_t(2));
        QCOMPARE(runs[0].points.size(), std::size_t(20));
        QCOMPARE(runs[1].points.size(), std::size_t(38));
        QCOMPARE(runs[1].firstSample, std::size_t(22));
        ChartCurve line;
        line.runs = runs;
        QCOMPARE(valueRange({line}, Quantity::Speed).low, 0.0); // whatever the band
    }
    void measuredPointsLeaveSpikesOut()
    {
        const Profile profile = exampleScene({.frames = 300})->robots[0].analysis->profile;
        const std::vector<double> positions = sampleTimes(profile);
        const auto spike = static_cast<std::size_t>(profile.spikes[1].sampleIndex); // a jump
        QVERIFY(measuredSpeed(profile, spike).has_value());
        for (const BandPoint &point : measuredPoints(profile, Quantity::Speed, positions).points) {
            // Neighbours too would be wrong: central differences use the spike.
            for (const std::size_t index : {spike - 1, spike, spike + 1})
                QVERIFY(std::abs(point.x - toSeconds(profile.samples[index].time)) > 1e-6);
        }
        QVERIFY(measuredPoints(profile, Quantity::TurnRate, positions).points.empty());
        const CurveRun measured = measuredPoints(profile, Quantity::PositionX, positions);
        // mm, in single precision
        QVERIFY(std::abs(double(measured.points[0].value) - profile.samples[0].position->x() * 1e3) < 1e-3);
        QVERIFY(!measuredSpeed(profile, 0));
    }
    void textStandsOutFromItsGround()
    {
        const auto luminance = [](const QColor &colour) {
            const auto linear = [](double c) {
                return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            };
            return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
                   0.0722 * linear(colour.blueF());
        };
        const auto contrast = [&](const QColor &a, const QColor &b) {
            const double la = luminance(a), lb = luminance(b);
            return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
        };
        for (const QPalette &palette : {lightPalette(), darkPalette()}) {
            const ThemeColours colours = ThemeColours::of(palette);
            QVERIFY(contrast(colours.text, colours.card) >= 7);
            QVERIFY(contrast(colours.muted, colours.card) >= 4.5);
            QVERIFY(contrast(colours.muted, colours.mapGround) >= 4.5);
            for (const auto role : {QPalette::Window, QPalette::Base, QPalette::Button})
                QVERIFY(contrast(colours.field, palette.color(role)) >= 3); // WCAG 2.1, 1.4.11
            QVERIFY(contrast(colours.bubbleText, colours.bubble) >= 7);
            for (const auto state :
                 {BadgeState::Neutral, BadgeState::Good, BadgeState::Warning, BadgeState::Bad})
                QVERIFY(contrast(badgeColours(state, palette).text, badgeColours(state, palette).ground) >=
                        4.5);
            for (int robot = 0; robot < 2; ++robot)
                QVERIFY(contrast(seriesColour(robot, palette), colours.card) >= 3); // WCAG for graphics
        }
        QVERIFY(luminance(scaleColour(0)) < luminance(scaleColour(0.5)) &&
                luminance(scaleColour(0.5)) < luminance(scaleColour(1)));
        QCOMPARE(scaleColour(std::nan("")), scaleColour(0));
    }
};

ODOGRAPH_TEST(TestCurves, QApplication)
#include "tst_curves.moc"
