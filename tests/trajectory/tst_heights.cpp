// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

/// Marks high above the floor, and robots whose height changes.
class TestHeights : public QObject
{
    Q_OBJECT

    static std::vector<ViewTrack> filmed(double heightM, unsigned seed)
    {
        std::mt19937 random(seed);
        FilmSettings settings;
        settings.planeM = heightM;
        const Course course = figureEight(0.8, 0.4, 8);
        return {film("A", cameraA(), course, settings, random),
                film("B", cameraB(), course, settings, random)};
    }

    /// On a ramp: as filmed, but the point's height follows a function of time.
    static std::vector<ViewTrack> filmedOnRamp(double (*heightM)(double), unsigned seed)
    {
        auto views = filmed(0.03, seed);
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0, 0.3);
        const Course course = figureEight(0.8, 0.4, 8);
        for (ViewTrack &view : views) {
            for (Observation &observation : view.observations) {
                const double t = toSeconds(observation.time);
                const Eigen::Vector2d position = course(t).position;
                observation.ellipse.centrePx =
                    *view.floorView->pixelFromWorld({position.x(), position.y(), heightM(t)}) +
                    Eigen::Vector2d(noise(random), noise(random));
            }
        }
        return views;
    }

private Q_SLOTS:
    void aSmallMarkOnAMastIsLaidAtItsOwnHeight()
    {
        // The outline is 80 px long, a body of 1 m height would span several hundred: what is seen is only
        // its top.
        const auto profile = analyse(filmed(1.0, 1), {1.0, {}, {}, false}, {});
        QVERIFY(profile.has_value());
        QVERIFY(errorsOf(*profile, figureEight(0.8, 0.4, 8)).positionM < 0.002);
    }

    void aBodyIsLaidAtHalfItsHeight()
    {
        const auto profile = analyse(filmed(0.03, 2), {0.06, {}, {}, false}, {});
        QVERIFY(profile.has_value());
        QVERIFY(errorsOf(*profile, figureEight(0.8, 0.4, 8)).positionM < 0.002);
        QCOMPARE(profile->heightM, 0.06);
    }

    void theHeightOfAMarkIsFoundWhenNotTold()
    {
        const auto profile = analyse(filmed(1.0, 3), {}, {});
        QVERIFY(profile.has_value());
        QVERIFY(profile->heightEstimated);
        QVERIFY2(std::abs(profile->heightM - 1.0) < 0.005, qPrintable(QString::number(profile->heightM)));
    }

    void aRampNeedsTheHeightOfEveryFrame()
    {
        const auto ramp = [](double t) { return 0.25 + 0.2 * std::sin(0.8 * t); };
        const auto views = filmedOnRamp(ramp, 4);
        const Course course = figureEight(0.8, 0.4, 8);
        const auto varying = analyse(views, {{}, {}, {}, true}, {});
        QVERIFY(varying.has_value());
        // 0.3 px is about 1 mm here; what is left of the height's noise is of the same size.
        QVERIFY2(errorsOf(*varying, course).positionM < 0.003,
                 qPrintable(QString::number(errorsOf(*varying, course).positionM)));
    }

    /// A cap on a walking person, lost by one view for a fifth of a second and for most of one, and taken for
    /// something else in between: the height is then known from before and after only.
    void whatOneViewSeesIsAsUncertainAsItsHeight()
    {
        const auto bobbing = [](double t) { return 1.3 + 0.1 * std::sin(5 * t); };
        auto views = filmedOnRamp(bobbing, 7);
        const auto isIn = [](const auto &at, double fromS, double toS) {
            return toSeconds(at.time) >= fromS && toSeconds(at.time) < toS;
        };
        const auto isLost = [&](const auto &at) { return isIn(at, 2, 2.2) || isIn(at, 4, 4.8); };
        const auto isFalse = [&](const auto &at) { return isIn(at, 6.5, 6.8); };
        for (Observation &one : views[0].observations) {
            one.found = !isLost(one);
            if (isFalse(one))
                one.ellipse.centrePx.x() += 300;
        }
        const Course course = figureEight(0.8, 0.4, 8);
        const auto profile = analyse(views, {{}, {}, {}, true}, {});
        QVERIFY(profile.has_value());
        int alone = 0, inside = 0, refused = 0, falsePositions = 0;
        double sigmaBothM = 0, sigmaAloneM = 0;
        for (std::size_t i = 0; i < profile->samples.size(); ++i) {
            const Sample &sample = profile->samples[i];
            const double sigmaM = std::sqrt(sample.covariance.trace() / 2);
            const double awayM = (*sample.position - course(toSeconds(sample.time)).position).norm();
            if (isFalse(sample)) {
                falsePositions += isUsed(sample) && awayM > 4 * sigmaM;
                continue;
            }
            refused += !isUsed(sample);
            if (isLost(sample)) {
                ++alone;
                inside += awayM < 2.45 * sigmaM; // 95 % of two coordinates
                sigmaAloneM = std::max(sigmaAloneM, sigmaM);
            } else {
                sigmaBothM = std::max(sigmaBothM, sigmaM);
            }
        }
        QCOMPARE(refused, 0);
        QCOMPARE(falsePositions, 0);
        QVERIFY2(10 * inside >= 9 * alone, qPrintable(QStringLiteral("%1 of %2").arg(inside).arg(alone)));
        QVERIFY(sigmaAloneM > 5 * sigmaBothM);
        QVERIFY(errorsOf(*profile, course).positionM < 0.1);
    }

    void aWrongHeightIsMendedByTheBearingsOfTwoViews()
    {
        // Told 0.5 m, but between 0.05 and 0.45 m: one view alone is off by up to half a metre, both together
        // see where their bearings cross.
        const auto ramp = [](double t) { return 0.25 + 0.2 * std::sin(0.8 * t); };
        auto views = filmedOnRamp(ramp, 6);
        const Course course = figureEight(0.8, 0.4, 8);
        const auto both = analyse(views, {0.5, {}, {}, false}, {});
        QVERIFY(both.has_value());
        QVERIFY2(errorsOf(*both, course).positionM < 0.03,
                 qPrintable(QString::number(errorsOf(*both, course).positionM)));
        views.resize(1);
        const auto one = analyse(views, {0.5, {}, {}, false}, {});
        QVERIFY(!one.has_value() || errorsOf(*one, course).positionM > 0.1);
    }

    void oneViewCannotTriangulate()
    {
        auto views = filmed(0.3, 5);
        views.resize(1);
        const auto profile = analyse(views, {{}, {}, {}, true}, {});
        QVERIFY(!profile.has_value());
        QCOMPARE(profile.error().code, ErrorCode::Undetermined);
        QVERIFY(profile.error().message().find("add a second view") != std::string::npos);
    }
};

ODOGRAPH_TEST(TestHeights, QCoreApplication)
#include "tst_heights.moc"
