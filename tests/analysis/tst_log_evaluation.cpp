// SPDX-License-Identifier: GPL-3.0-or-later
// Logs made of a known truth, with a known clock, axes and errors, against the run as it was measured.
#include "core/analysis/evaluation/log_evaluation.h"

#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/trajectory/synthetic_run.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double pi = std::numbers::pi;
/// Of the cubic between two frames where the acceleration jumps.
constexpr double betweenFramesM = 1e-4;

/// Rests, then drives the sides of a square of 0.8 m from rest to rest, and turns on the spot between them.
/// The third side is longer, so that no part of it is like another one.
Course square()
{
    return [](double t) {
        constexpr double accelMps2 = 0.8, speedMps = 0.4, turnS = 1, rampS = speedMps / accelMps2;
        Truth truth;
        truth.headingRad = 0;
        double beginS = 1.5;
        for (int side = 0; side < 4 && t > beginS; ++side) {
            const double lengthM = side == 2 ? 1.1 : 0.8, driveS = lengthM / speedMps + rampS;
            const double u = std::min(t - beginS, driveS), restS = driveS - u;
            const Eigen::Vector2d along(std::cos(side * pi / 2), std::sin(side * pi / 2));
            const bool starts = u < rampS, stops = restS < rampS;
            const double drivenM = starts  ? accelMps2 * u * u / 2
                                   : stops ? lengthM - accelMps2 * restS * restS / 2
                                           : speedMps * (u - rampS / 2);
            truth.position += drivenM * along;
            truth.velocity = (starts ? accelMps2 * u : stops ? accelMps2 * restS : speedMps) * along;
            truth.acceleration = (starts ? accelMps2 : stops && restS > 0 ? -accelMps2 : 0) * along;
            beginS += driveS;
            const double part = std::clamp((t - beginS) / turnS, 0.0, 1.0);
            truth.headingRad = (side + part - std::sin(2 * pi * part) / (2 * pi)) * pi / 2;
            beginS += turnS;
        }
        return truth;
    };
}

constexpr double squareS = 18;

Course straight(double speedMps)
{
    return [=](double t) {
        Truth truth;
        truth.position.x() = speedMps * t;
        truth.velocity.x() = speedMps;
        truth.headingRad = 0;
        return truth;
    };
}

Course circle(double radiusM, double speedMps)
{
    return [=](double t) {
        const double angle = t * speedMps / radiusM;
        const Eigen::Vector2d away(std::cos(angle), std::sin(angle)), along(-away.y(), away.x());
        Truth truth{radiusM * away, speedMps * along, -speedMps * speedMps / radiusM * away};
        truth.headingRad = angle + pi / 2;
        return truth;
    };
}

/// A run with the heading of its body where a σ of it is given.
Profile profileOf(Run run, const Course &course, double sigmaHeadingRad = 0)
{
    Profile profile;
    profile.samples = std::move(run.samples);
    profile.points = std::move(run.points);
    if (sigmaHeadingRad == 0)
        return profile;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        BodyHeading body;
        const double timeS = toSeconds(profile.samples[i].time), stepS = 1e-4;
        body.radians = *course(timeS).headingRad;
        body.turnRateRadps =
            (*course(timeS + stepS).headingRad - *course(timeS - stepS).headingRad) / (2 * stepS);
        body.sigmaRad = sigmaHeadingRad;
        profile.points[i].body = body;
    }
    return profile;
}

Profile exact(const Course &course, double durationS, double sigmaHeadingRad = 0)
{
    return profileOf(exactly(course, durationS, 1e-6), course, sigmaHeadingRad);
}

/// What a robot writes: its displacements since the one before, turned and scaled as it errs.
struct LogErrors
{
    double rate = 50, offsetS = 3.7; ///< the trial's time less the log's
    double clockRate = 0;            ///< by how much its clock runs faster
    double noiseM = 0, scale = 1, bendRadPerM = 0;
    double turnedRad = 0.6;
    bool withHeadings = true;
};

std::vector<LogPose> logOf(const Course &course, double fromS, double toS, const LogErrors &errors,
                           std::mt19937 *random = nullptr)
{
    std::normal_distribution<double> normal;
    std::vector<LogPose> log;
    Eigen::Vector2d position(1.5, -0.7), last = course(fromS).position;
    double turned = errors.turnedRad;
    for (int i = 0; i <= std::lround((toS - fromS) * errors.rate); ++i) {
        const double timeS = fromS + i / errors.rate;
        const Truth truth = course(timeS);
        const Eigen::Vector2d step = truth.position - last;
        last = truth.position;
        turned += errors.bendRadPerM * step.norm();
        position += errors.scale * (Eigen::Rotation2Dd(turned) * step);
        LogPose &pose = log.emplace_back();
        pose.timeS = (timeS - errors.offsetS) * (1 + errors.clockRate);
        pose.position = position;
        if (random)
            pose.position += errors.noiseM * Eigen::Vector2d(normal(*random), normal(*random));
        if (errors.withHeadings && truth.headingRad)
            pose.headingRad = *truth.headingRad + turned;
    }
    return log;
}

Result<LogEvaluation> evaluated(const Profile &profile, const std::vector<LogPose> &log,
                                const EvaluationOptions &options = {})
{
    return evaluateLog(profile, log, options, foreignWords("log"));
}

EvaluationOptions by(LogAlignment alignment, std::optional<double> offsetS = std::nullopt)
{
    EvaluationOptions options;
    options.alignment = alignment;
    options.offsetS = offsetS;
    return options;
}

QString message(const Result<LogEvaluation> &result)
{
    return result ? QString() : QString::fromStdString(result.error().message());
}

} // namespace

class TestLogEvaluation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recoversClockAndAxes_data()
    {
        QTest::addColumn<int>("alignment");
        for (const LogAlignment alignment : {LogAlignment::Origin, LogAlignment::Se2, LogAlignment::Sim2})
            QTest::newRow(wordOf(alignment).data()) << int(alignment);
    }
    void recoversClockAndAxes()
    {
        QFETCH(int, alignment);
        LogErrors errors;
        errors.scale = LogAlignment(alignment) == LogAlignment::Sim2 ? 1.02 : 1;
        const auto result = evaluated(exact(square(), squareS, 1e-3), logOf(square(), 0, squareS, errors),
                                      by(LogAlignment(alignment)));
        QVERIFY2(result, qPrintable(message(result)));
        QVERIFY(std::abs(result->clock.offsetS - 3.7) < 1e-6);
        QVERIFY(result->clock.sigmaOffsetS < 1e-3);
        QCOMPARE(result->clock.rate, 0.0);
        QVERIFY(result->ape.count > 890);
        QVERIFY(result->ape.most < betweenFramesM);
        QVERIFY(std::abs(result->transform.headingRad + 0.6) < 1e-6);
        QVERIFY(std::abs(result->transform.scale - 1 / errors.scale) < 1e-6);
        QVERIFY((result->transform({1.5, -0.7})).norm() < 1e-6); // where the log begins, the run does
        QVERIFY(result->isRpeOfPoses && result->rpe && result->rpe->most < 2 * betweenFramesM);
        QVERIFY(result->heading && result->heading->most < 1e-4);
        QVERIFY(result->remarks.empty());
        QVERIFY(std::abs(result->pathM - 3.5) < 0.01);
        if (errors.scale == 1)
            QVERIFY(result->driftPercent < 1e-3);
    }

    /// Positions that are all a millimetre ahead are those of a moment later: by a millimetre over the speed.
    void offsetHoldsWhatIsCommonToAllPositions()
    {
        const Course course = square();
        const Eigen::Matrix2d common = Eigen::Matrix2d::Identity() * 1e-6;
        const auto result = evaluated(profileOf(exactly(course, squareS, 1e-6, common), course),
                                      logOf(course, 0, squareS, {}));
        QVERIFY2(result, qPrintable(message(result)));
        double speeds = 0, squares = 0;
        for (double timeS = 0; timeS < squareS; timeS += 0.02) {
            speeds += course(timeS).velocity.norm();
            squares += course(timeS).velocity.squaredNorm();
        }
        QVERIFY(std::abs(result->clock.sigmaOffsetS - 0.001 * speeds / squares) < 1e-4);
        QVERIFY(std::abs(result->ape.measurementSigma - std::sqrt(2.0) * 0.001) < 1e-5);
    }

    void takesTheLogAsItIs()
    {
        LogErrors errors;
        errors.turnedRad = 0;
        const auto result =
            evaluated(exact(square(), squareS), logOf(square(), 0, squareS, errors), by(LogAlignment::None));
        QVERIFY2(result, qPrintable(message(result)));
        const double apartM = std::hypot(1.5, 0.7);
        QVERIFY(std::abs(result->ape.rmse - apartM) < 1e-6);
        QVERIFY(result->ape.std < 1e-6);
        QCOMPARE(result->transform.scale, 1.0);
        QVERIFY(!result->isRpeOfPoses); // no measured heading, and its axes are not turned
        QVERIFY(result->rpe->most < 2 * betweenFramesM);
        QVERIFY(!result->heading);
    }

    void findsAClockThatRunsFast()
    {
        LogErrors errors;
        errors.clockRate = 2e-3;
        errors.offsetS = -1000; // anywhere
        errors.noiseM = 0.001;
        std::mt19937 random(4);
        const Profile profile = profileOf(smoothed(square(), squareS, 0.001, random), square());
        const auto result = evaluated(profile, logOf(square(), 0, squareS, errors, &random));
        QVERIFY2(result, qPrintable(message(result)));
        QVERIFY(result->clock.sigmaRate > 0 && result->clock.sigmaRate < 2e-4);
        QVERIFY(std::abs(result->clock.rate + 2e-3 / 1.002) < 3 * result->clock.sigmaRate);
        const double middleS = result->clock.middleS;
        QVERIFY(std::abs(result->clock.trialTimeS(middleS) - (middleS / 1.002 - 1000)) <
                3 * result->clock.sigmaOffsetS);
        QVERIFY(result->ape.rmse < 0.002);
    }

    /// Round a circle, an odometry that bends looks like a clock that runs fast, but for the start.
    void mistakesNoBendForAClock()
    {
        const Course course = [](double t) {
            constexpr double startS = 0.3, rampS = 0.8, speedMps = 1, radiusM = 0.6;
            const double u = std::max(0.0, t - startS);
            const bool starts = u < rampS;
            const double angle = (starts ? u * u / (2 * rampS) : u - rampS / 2) * speedMps / radiusM;
            const double speed = starts ? speedMps * u / rampS : speedMps;
            const Eigen::Vector2d away(std::cos(angle), std::sin(angle)), along(-away.y(), away.x());
            return Truth{radiusM * away, speed * along,
                         (starts && u > 0 ? speedMps / rampS : 0) * along - speed * speed / radiusM * away};
        };
        LogErrors errors;
        errors.scale = 1.02;
        errors.bendRadPerM = 0.08;
        errors.noiseM = 0.0005;
        for (unsigned seed = 1000; seed < 1010; ++seed) {
            std::mt19937 random(seed);
            const Profile profile = profileOf(smoothed(course, 8, 0.0003, random), course);
            const auto result = evaluated(profile, logOf(course, 0, 8, errors, &random));
            QVERIFY2(result, qPrintable(message(result)));
            QCOMPARE(result->clock.rate, 0.0);
            QVERIFY(std::abs(result->clock.offsetS - errors.offsetS) < 4 * result->clock.sigmaOffsetS);
        }
    }

    /// A circle of 0.5 m once round, and a log whose wheels are 1 % too small: it is everywhere 5 mm outside.
    void circleOfWrongScale()
    {
        const double roundS = 2 * pi * 0.5 / 0.4;
        LogErrors errors;
        errors.offsetS = 0;
        errors.scale = 1.01;
        errors.rate = 400 / roundS;
        auto log = logOf(circle(0.5, 0.4), 0, roundS, errors);
        log.pop_back(); // the last one is the first one
        const Profile profile = exact(circle(0.5, 0.4), roundS + 1, 1e-3);
        const auto rigid = evaluated(profile, log, by(LogAlignment::Se2, 0.0));
        QVERIFY2(rigid, qPrintable(message(rigid)));
        QVERIFY(rigid->clock.isGiven);
        QVERIFY(std::abs(rigid->ape.rmse - 0.005) < 1e-5);
        QVERIFY(rigid->ape.std < 1e-5);
        const auto scaled = evaluated(profile, log, by(LogAlignment::Sim2, 0.0));
        QVERIFY(std::abs(scaled->transform.scale - 1 / 1.01) < 1e-5);
        QVERIFY(scaled->ape.rmse < 1e-5);
    }

    /// Of a straight run the end is off by the scale's error; a log that bends leaves it to the side.
    void driftIsThatOfTheEnd()
    {
        const Course course = straight(0.4);
        // the direction of a path known to a millimetre is less sure than the heading
        const Profile profile = profileOf(exactly(course, 10, 1e-3), course, 1e-4);
        LogErrors errors;
        errors.scale = 1.02;
        const auto result =
            evaluated(profile, logOf(straight(0.4), 0, 9.98, errors), by(LogAlignment::Se2, 3.7));
        QVERIFY2(result, qPrintable(message(result)));
        QVERIFY(std::abs(result->driftPercent - 2) < 0.02);
        // both ends to √2 mm, and the heading to 0.1 mrad over all 4 m
        QVERIFY(std::abs(result->sigmaDriftPercent - 100 * std::sqrt(4.0 + 0.16) / 4000) < 1e-3);
        errors.scale = 1;
        errors.bendRadPerM = 0.05;
        const auto bent =
            evaluated(profile, logOf(straight(0.4), 0, 9.98, errors), by(LogAlignment::Se2, 3.7));
        // an arc of 4 m that turns by 0.2 rad ends 0.4 m to the side: half the angle times the length
        QVERIFY(std::abs(bent->driftPercent - 10) < 0.1);
    }

    /// Two hundred noisy runs with noisy logs of an odometry that errs: the stated σ of the offset is the
    /// scatter about the truth.
    void offsetIsAsSureAsItSays()
    {
        LogErrors errors;
        errors.noiseM = 0.002;
        errors.bendRadPerM = 0.03;
        errors.scale = 1.01;
        double sum = 0, squares = 0, sigmas = 0;
        int beyond = 0;
        constexpr int seeds = 200;
        for (int seed = 0; seed < seeds; ++seed) {
            std::mt19937 random(unsigned(seed) + 1);
            const Profile profile = profileOf(smoothed(square(), squareS, 0.001, random), square());
            const auto result =
                evaluated(profile, logOf(square(), 0, squareS, errors, &random), by(LogAlignment::Se2));
            QVERIFY2(result, qPrintable(message(result)));
            const double pull =
                (result->clock.trialTimeS(result->clock.middleS) - result->clock.middleS - errors.offsetS) /
                result->clock.sigmaOffsetS;
            sum += pull;
            squares += pull * pull;
            beyond += std::abs(pull) > 1.96 ? 1 : 0;
            sigmas += result->clock.sigmaOffsetS / seeds;
        }
        qInfo("σ %.2f ms, mean pull %.2f, rms pull %.2f, %d of %d beyond 1.96 σ", 1000 * sigmas, sum / seeds,
              std::sqrt(squares / seeds), beyond, seeds);
        QVERIFY(std::abs(sum / seeds) < 0.25);
        QVERIFY(std::sqrt(squares / seeds) < 1.15 && std::sqrt(squares / seeds) > 0.7);
        QVERIFY(beyond <= 18); // 5 % are 10, and 18 come once in two hundred such tests
        QVERIFY(sigmas < 0.001);
    }

    void sizesUpTheMeasurement()
    {
        LogErrors errors;
        errors.noiseM = 0.0003;
        std::mt19937 random(3);
        const Profile profile = profileOf(smoothed(square(), squareS, 0.002, random), square(), 0.01);
        const auto fine =
            evaluated(profile, logOf(square(), 0, squareS, errors, &random), by(LogAlignment::Se2));
        QVERIFY2(fine, qPrintable(message(fine)));
        QVERIFY(fine->ape.isWithinUncertainty() && fine->ape.rmse < 0.002);
        QVERIFY(fine->rpe->isWithinUncertainty());
        QVERIFY(fine->heading->isWithinUncertainty());
        errors.scale = 1.05;
        const auto coarse =
            evaluated(profile, logOf(square(), 0, squareS, errors, &random), by(LogAlignment::Se2));
        QVERIFY(!coarse->ape.isWithinUncertainty());
        QVERIFY(!coarse->rpe->isWithinUncertainty());
    }

    /// Nothing is compared where nothing was measured, and it is counted.
    void leavesGapsOut()
    {
        Run run = exactly(square(), squareS, 1e-6);
        for (std::size_t i = 150; i < 210; ++i) { // 5 s to 7 s
            run.samples[i].position.reset();
            run.samples[i].flags = flagBit(SampleFlag::Lost);
            run.points[i].valid = false;
        }
        const auto result =
            evaluated(profileOf(std::move(run), square()), logOf(square(), -1, squareS + 1, {}));
        QVERIFY2(result, qPrintable(message(result)));
        // from the last position before to the first one after it are 61 steps of 1/30 s
        QVERIFY(std::abs(double(result->inGaps) - 61 * 50 / 30.0) < 2);
        QVERIFY(std::abs(double(result->outside) - 100) < 2);
        QCOMPARE(result->ape.count + result->inGaps + result->outside, std::size_t(20 * 50 + 1));
        QVERIFY(result->ape.most < betweenFramesM);
    }

    void refusesWhatTellsNoTime_data()
    {
        QTest::addColumn<int>("course");
        QTest::newRow("straight") << 0;
        QTest::newRow("circle") << 1;
        QTest::newRow("standing") << 2;
    }
    void refusesWhatTellsNoTime()
    {
        QFETCH(int, course);
        const Course drives[] = {straight(0.4), circle(0.5, 0.4), straight(0)};
        std::mt19937 random(5);
        const Profile profile = profileOf(smoothed(drives[course], 10, 0.001, random), drives[course]);
        const auto log = logOf(drives[course], 0, 10, {});
        QCOMPARE(message(evaluated(profile, log)),
                 QStringLiteral("log: the robot never changes its speed or its curvature by more than noise, "
                                "so any time offset fits; give the time offset of the log"));
        if (course < 2)
            QVERIFY(evaluated(profile, log, by(LogAlignment::Se2, 3.7)));
        else
            QCOMPARE(message(evaluated(profile, log, by(LogAlignment::Se2, 3.7))),
                     QStringLiteral("log: the robot does not move in the common time; choose the log of this "
                                    "run"));
    }

    void refusesAnotherRun()
    {
        const Profile profile = exact(square(), squareS);
        QVERIFY(message(evaluated(profile, logOf(figureEight(0.8, 0.4, 9), 0, 20, {})))
                    .startsWith(QLatin1String("log: it moves differently: at no time offset do more than ")));
        auto mirrored = logOf(square(), 0, squareS, {});
        for (LogPose &pose : mirrored) {
            pose.position.y() = -pose.position.y();
            pose.headingRad.reset();
        }
        QCOMPARE(message(evaluated(profile, mirrored)),
                 QStringLiteral("log: it is the mirror image of the run; change the sign of one of its "
                                "coordinates"));
        QVERIFY(message(evaluated(profile, logOf(square(), 0, squareS, {}), by(LogAlignment::Se2, 100.0)))
                    .startsWith(QLatin1String("log: fewer than 3 of its positions have times at which the "
                                              "robot was measured; choose the log of this run")));
        QVERIFY(message(evaluated(profile, {LogPose{}}))
                    .startsWith(QLatin1String("log: fewer than 3 of its positions")));
        QVERIFY(message(evaluated(Profile(), logOf(square(), 0, squareS, {})))
                    .startsWith(QLatin1String("log: fewer than 3 of its positions")));
    }

    /// The same laps again and again, and a log of as many: which of them is which is not known.
    void refusesLapsThatAreAlike()
    {
        const Course laps = [](double t) {
            const double w = 0.8, angle = w * t + 0.5 * std::sin(w * t), rate = w + 0.5 * w * std::cos(w * t),
                         change = -0.5 * w * w * std::sin(w * t);
            const Eigen::Vector2d away(std::cos(angle), std::sin(angle)), along(-away.y(), away.x());
            return Truth{0.5 * away, 0.5 * rate * along, 0.5 * (change * along - rate * rate * away)};
        };
        std::mt19937 random(5);
        LogErrors errors;
        errors.noiseM = 0.001;
        const Profile profile = profileOf(smoothed(laps, 40, 0.001, random), laps);
        QVERIFY(message(evaluated(profile, logOf(laps, 0, 40, errors, &random)))
                    .startsWith(QLatin1String("log: its motion repeats itself: time offsets ")));
    }

    void remarksOnUnitsFrontAndStretches()
    {
        const Profile profile = exact(square(), squareS, 1e-3);
        auto log = logOf(square(), 0, squareS, {});
        for (LogPose &pose : log) {
            pose.position *= 1000;
            *pose.headingRad += pi;
        }
        EvaluationOptions options;
        options.deltaM = 5;
        const auto result = evaluated(profile, log, options);
        QVERIFY2(result, qPrintable(message(result)));
        QCOMPARE(english(result->remarks),
                 (std::vector<std::string>{
                     "the log's lengths are 1000.0 times the measured ones: its unit may be wrong",
                     "the log's heading is 180° from the measured one throughout: its front or its axes may "
                     "differ",
                     "no stretch of 5.000 m was measured without a gap, so there is no relative error"}));
        QVERIFY(!result->rpe);
    }

    void alignmentsHaveNames()
    {
        for (const LogAlignment alignment :
             {LogAlignment::None, LogAlignment::Origin, LogAlignment::Se2, LogAlignment::Sim2})
            QCOMPARE(logAlignmentOf(wordOf(alignment)), std::optional(alignment));
        QVERIFY(!logAlignmentOf("SE2"));
    }
};

ODOGRAPH_TEST(TestLogEvaluation, QCoreApplication)
#include "tst_log_evaluation.moc"
