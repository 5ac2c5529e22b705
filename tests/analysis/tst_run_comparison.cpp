// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of known motion against one another: the time difference at each place in closed form, and its stated
// σ against the scatter over noisy runs.
#include "core/analysis/internal/path_following.h"
#include "core/analysis/internal/run_comparison.h"
#include "core/analysis/metrics.h"
#include "core/analysis/run_differences.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_run.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// Rests until startS, then drives along a line at an even speed, and waits once at a place.
Course evenRun(double startS, double speedMps, double stationM = 1e9, double waitS = 0, double lengthM = 2)
{
    return [=](double t) {
        double u = std::max(0.0, t - startS);
        const double reachedS = stationM / speedMps;
        const bool waits = u > reachedS && u < reachedS + waitS;
        if (u >= reachedS)
            u = std::max(reachedS, u - waitS);
        const bool moves = t > startS && !waits && u * speedMps < lengthM;
        return Truth{{std::min(lengthM, u * speedMps), 0}, {moves ? speedMps : 0.0, 0}, {0, 0}};
    };
}

Course onCircle(double radiusM, double speedMps, double startRad = 0)
{
    return [=](double t) {
        const double angle = startRad + t * speedMps / radiusM;
        const Eigen::Vector2d away(std::cos(angle), std::sin(angle)), along(-away.y(), away.x());
        return Truth{radiusM * away, speedMps * along, -speedMps * speedMps / radiusM * away};
    };
}

Profile profileOf(Run run)
{
    Profile profile;
    profile.samples = std::move(run.samples);
    profile.points = std::move(run.points);
    profile.metrics = measureRun(profile.samples, profile.points);
    return profile;
}

Profile exact(const Course &course, double durationS, double sigmaM = 0, double commonM = 0)
{
    return profileOf(exactly(course, durationS, sigmaM, Eigen::Matrix2d::Identity() * commonM * commonM));
}

Result<RunComparison> compared(const Profile &a, const Profile &b, ComparisonOptions options = {})
{
    return compareRuns({{foreignWords("One"), &a}, {foreignWords("Two"), &b}}, options);
}

Task lineTask()
{
    Task task;
    task.path = {{{0, 0}, {2, 0}}, false};
    task.gates = {gateAcross("Start", GateRole::Start, {0.2, 0}, {1, 0}, 0.4),
                  gateAcross("Middle", GateRole::Split, {1, 0}, {1, 0}, 0.4),
                  gateAcross("End", GateRole::Finish, {1.8, 0}, {1, 0}, 0.4)};
    return task;
}

ComparisonOptions byTask(std::optional<AlignBy> by = std::nullopt)
{
    ComparisonOptions options;
    options.task = lineTask();
    options.alignBy = by;
    return options;
}

QString message(const Result<RunComparison> &result)
{
    return result ? QString() : QString::fromStdString(result.error().message());
}

/// Compares every time difference with a closed form of the distance.
void checkDifferences(const RunComparison &comparison, const std::function<double(double)> &expected,
                      double toleranceS, int atLeast)
{
    int seen = 0;
    for (std::size_t i = 0; i < comparison.distancesM.size(); ++i) {
        const auto difference = comparison.timeDifference(1, i);
        if (!difference)
            continue;
        ++seen;
        const double wanted = expected(comparison.distanceM(i));
        if (std::isnan(wanted))
            continue;
        QVERIFY2(std::abs(difference->value - wanted) < toleranceS,
                 qPrintable(QStringLiteral("%1 m: %2 s instead of %3 s")
                                .arg(comparison.distanceM(i))
                                .arg(difference->value)
                                .arg(wanted)));
    }
    QVERIFY2(seen >= atLeast, qPrintable(QString::number(seen)));
}

} // namespace

class TestRunComparison : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void evenRunsDifferByDistanceOverSpeed()
    {
        // From the gate at 0.2 m on: s/0.4 − s/0.5. The moments of arrival are exact between frames of an
        // even run.
        const Profile fast = exact(evenRun(0.5, 0.5), 6), slow = exact(evenRun(1.3, 0.4), 8);
        const auto comparison = compared(fast, slow, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        QVERIFY(comparison->alignedBy == AlignBy::StartGate && comparison->isTasksPath);
        QVERIFY(std::abs(comparison->originM - 0.2) < 1e-6);
        checkDifferences(
            *comparison, [](double s) { return s < 1.78 ? s / 0.4 - s / 0.5 : NAN; }, 1e-6, 179);
        QCOMPARE(comparison->distanceM(0), 0.0);
    }

    void waitingIsAStep()
    {
        // Two waits 1 s at 1 m: before it no difference, after it one second. The wait's own stations are
        // uncertain.
        const Profile through = exact(evenRun(0.5, 0.5), 6), waits = exact(evenRun(0.5, 0.5, 1.0, 1.0), 7);
        const auto comparison = compared(through, waits, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        // At 30 frames/s the cubic rounds the corners of the stop over one frame: 17 mm.
        checkDifferences(
            *comparison, [](double s) { return s < 0.78               ? 0.0
                                               : s > 0.82 && s < 1.78 ? 1.0
                                                                      : NAN; }, 1e-6,
            170);
    }

    void arrivingWhereItWaitsIsAsUncertainAsTheWait()
    {
        const Profile through = exact(evenRun(0.5, 0.5), 6, 0.002),
                      waits = exact(evenRun(0.5, 0.5, 1.0, 1.0), 7, 0.002);
        const auto comparison = compared(through, waits, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        const auto atStop = comparison->timeDifferenceAt(1, 1.0),
                   elsewhere = comparison->timeDifferenceAt(1, 0.6);
        QVERIFY(atStop && elsewhere);
        // 2 mm at 0.5 m/s are 4 ms, of four moments (two arrivals, two gates): 8 ms. Half a second of the
        // wait at least.
        QVERIFY2(std::abs(elsewhere->sigma - 0.008) < 2e-4, qPrintable(QString::number(elsewhere->sigma)));
        QVERIFY2(atStop->sigma > 0.45 && atStop->sigma < 0.6, qPrintable(QString::number(atStop->sigma)));
    }

    void oneThatNeverReachesTheEndIsComparedAsFarAsItGets()
    {
        const Profile whole = exact(evenRun(0.5, 0.5), 6), half = exact(evenRun(0.5, 0.5, 1e9, 0, 1.1), 6);
        const auto comparison = compared(whole, half, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        QVERIFY(comparison->distancesM.back() > 1.9); // the first run is shown to its end
        double last = 0;
        for (std::size_t i = 0; i < comparison->distancesM.size(); ++i)
            if (comparison->timeDifference(1, i))
                last = comparison->distancesM[i];
        QVERIFY2(std::abs(last - 1.1) < 0.011, qPrintable(QString::number(last)));
    }

    void alignments()
    {
        // One starts at 0.5 s, Two at 1.3 s, at equal speeds: every alignment but by hand gives no
        // difference.
        const Profile one = exact(evenRun(0.5, 0.5), 6), two = exact(evenRun(1.3, 0.5), 8);
        for (const AlignBy by : {AlignBy::StartGate, AlignBy::MotionOnset, AlignBy::Distance}) {
            const auto comparison = compared(one, two, byTask(by));
            QVERIFY2(comparison, qPrintable(message(comparison)));
            QVERIFY(comparison->alignedBy == by);
            // The onset is known to a frame where a speed jumps: 0.8 s are 24 frames, so that both err alike.
            checkDifferences(
                *comparison, [](double s) { return s < 1.75 ? 0.0 : NAN; }, 1e-6, 150);
        }
        ComparisonOptions hand = byTask(AlignBy::ByHand);
        hand.handTimesS = {1, 1};
        const auto comparison = compared(one, two, hand);
        QVERIFY2(comparison, qPrintable(message(comparison)));
        checkDifferences(
            *comparison, [](double s) { return s > 0.05 && s < 1.9 ? 0.8 : NAN; }, 1e-6, 150);
        // Each of the two moments is known to 1/30 s / √12.
        QVERIFY(std::abs(comparison->timeDifferenceAt(1, 1)->sigma - std::sqrt(2 / 12.0) / 30) < 1e-6);
    }

    void theDistanceToAlignByCanBeTold()
    {
        ComparisonOptions options = byTask(AlignBy::Distance);
        options.stationM = 1;
        const Profile fast = exact(evenRun(0.5, 0.5), 6), slow = exact(evenRun(1.3, 0.4), 8);
        const auto comparison = compared(fast, slow, options);
        QVERIFY2(comparison, qPrintable(message(comparison)));
        QVERIFY(std::abs(comparison->timeDifferenceAt(1, 1)->value) < 1e-9);
        QVERIFY(std::abs(comparison->timeDifferenceAt(1, 1.5)->value - (0.5 / 0.4 - 0.5 / 0.5)) < 1e-6);
        options.stationM = 5;
        QVERIFY(message(compared(fast, slow, options))
                    .contains(QLatin1String("was not seen at the position used for alignment; choose")));
    }

    void withoutATaskTheFirstRunsWayIsThePath()
    {
        const Profile fast = exact(evenRun(0.5, 0.5), 6), slow = exact(evenRun(1.3, 0.4), 8);
        const auto comparison = compared(fast, slow);
        QVERIFY2(comparison, qPrintable(message(comparison)));
        QVERIFY(comparison->alignedBy == AlignBy::MotionOnset && !comparison->isTasksPath &&
                !comparison->path.closed);
        // The onset of a jump of the speed is known to a frame.
        checkDifferences(
            *comparison, [](double s) { return s < 1.9 ? s / 0.4 - s / 0.5 : NAN; }, 1.1 / 30, 190);
        QVERIFY2(std::abs(lengthOf(comparison->path) - 2) < 0.04,
                 qPrintable(QString::number(lengthOf(comparison->path))));
    }

    void aClosedPathCountsItsLaps()
    {
        // Two and a half laps of a radius of 0.5 m; the second starts a quarter further on and is slower.
        const Profile one = exact(onCircle(0.5, 0.6), 13.2), two = exact(onCircle(0.5, 0.5, M_PI / 2), 15.8);
        ComparisonOptions options;
        options.task = Task{TaskTemplate::Circle, {}, circlePath({0, 0}, 0.5), {}};
        const double quarterM = M_PI / 4;
        for (const bool isTold : {true, false}) {
            const auto comparison = compared(one, two, isTold ? options : ComparisonOptions());
            QVERIFY2(comparison, qPrintable(message(comparison)));
            QVERIFY(comparison->alignedBy == AlignBy::Distance && comparison->path.closed);
            QVERIFY2(std::abs(comparison->originM - quarterM) < 0.005,
                     qPrintable(QString::number(comparison->originM)));
            // From the place to align by, 50 mm past the begin of both: the way at both speeds. The chords of
            // the first run's way are 0.2 ‰ short of its arc, and its closing piece is off by less than one
            // of them.
            checkDifferences(
                *comparison, [](double s) { return (s - 0.05) * (1 / 0.5 - 1 / 0.6); }, isTold ? 1e-3 : 0.005,
                690);
            QVERIFY2(std::abs(lengthOf(comparison->path) - M_PI) < 0.002,
                     qPrintable(QString::number(lengthOf(comparison->path))));
        }
    }

    void bothBackwardsIsForwards()
    {
        const auto back = [](const Course &course) {
            return Course([course](double t) {
                const Truth truth = course(t);
                return Truth{{2 - truth.position.x(), 0}, -truth.velocity, {0, 0}};
            });
        };
        const Profile fast = exact(back(evenRun(0.5, 0.5)), 6), slow = exact(back(evenRun(1.3, 0.4)), 8);
        const auto comparison = compared(fast, slow, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        QVERIFY(comparison->alignedBy == AlignBy::MotionOnset); // the start gate is not passed the wrong way
        QCOMPARE(comparison->path.points.front().x(), 2.0);
        checkDifferences(
            *comparison, [](double s) { return s < 1.9 ? s / 0.4 - s / 0.5 : NAN; }, 1.1 / 30, 190);
        const Profile forwards = exact(evenRun(0.5, 0.5), 6);
        QCOMPARE(message(compared(forwards, slow, byTask())),
                 QStringLiteral("comparison of 'One' and 'Two': 'Two' runs in the opposite direction "
                                "to 'One'; choose runs in the same direction"));
    }

    void toAndFroArrivesOnce()
    {
        // Forth to 1 m, back to 0.5 m, forth again: the stations before 1 m count the first time, those after
        // it late.
        const Course swing = [](double t) {
            const double u = 0.5 * std::max(0.0, t - 0.5);
            const double x = u < 1 ? u : u < 1.5 ? 2 - u : std::min(2.0, u - 1);
            const double v = t < 0.5 || x >= 2 ? 0 : u >= 1 && u < 1.5 ? -0.5 : 0.5;
            return Truth{{x, 0}, {v, 0}, {0, 0}};
        };
        const Profile straight = exact(evenRun(0.5, 0.5), 6), returning = exact(swing, 9);
        const auto comparison = compared(straight, returning, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        checkDifferences(
            *comparison, [](double s) { return s < 0.78               ? 0.0
                                               : s > 0.82 && s < 1.78 ? 2.0
                                                                      : NAN; }, 1e-6,
            170);
    }

    void aGapAndAShortCutHaveNoArrivals()
    {
        const Profile whole = exact(evenRun(0.5, 0.5), 6);
        Profile gap = exact(evenRun(0.5, 0.5), 6);
        for (ProfilePoint &point : gap.points)
            point.valid = std::abs(point.position.x() - 1.2) > 0.1;
        const auto comparison = compared(whole, gap, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        QVERIFY(!comparison->timeDifferenceAt(1, 1.2) && comparison->timeDifferenceAt(1, 1.0) &&
                comparison->timeDifferenceAt(1, 1.4));

        const Course cut = [](double t) { // leaves the square's side at 1 m and comes back on the side across
            const double u = 0.5 * t;
            return u < 1 ? Truth{{u, 0}, {0.5, 0}, {0, 0}} : Truth{{1, u - 1}, {0, 0.5}, {0, 0}};
        };
        ComparisonOptions square;
        square.task = Task{TaskTemplate::Free, {}, {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, false}, {}};
        const Course round = [](double t) {
            const double u = std::min(6.0, 0.5 * t);
            return u < 2   ? Truth{{u, 0}, {0.5, 0}, {0, 0}}
                   : u < 4 ? Truth{{2, u - 2}, {0, 0.5}, {0, 0}}
                           : Truth{{6 - u, 2}, {-0.5, 0}, {0, 0}};
        };
        const Profile driven = exact(round, 12), shorter = exact(cut, 6);
        const auto across = compared(driven, shorter, square);
        QVERIFY2(across, qPrintable(message(across)));
        QVERIFY(across->timeDifferenceAt(1, 0.8) && !across->timeDifferenceAt(1, 3.0));
    }

    void sectorsAddUpToTheDifference()
    {
        const Profile fast = exact(evenRun(0.5, 0.5), 6), waits = exact(evenRun(0.5, 0.5, 1.3, 1.0), 8);
        const auto comparison = compared(fast, waits, byTask());
        QVERIFY2(comparison, qPrintable(message(comparison)));
        const auto gates = gatesOnPath(comparison->path, lineTask().gates);
        QCOMPARE(gates.size(), std::size_t(3));
        const auto sectors = sectorTimes(*comparison, gates);
        QCOMPARE(sectors.size(), std::size_t(3));
        QCOMPARE(sectors[0].from + "-" + sectors[0].to, std::string("Start-Middle"));
        QCOMPARE(sectors[2].from + "-" + sectors[2].to, std::string("End-"));
        double sum = 0;
        for (const SectorTimes &sector : sectors)
            sum += sector.differences[1].value_or(Difference{NAN, 0}).value;
        QVERIFY(std::abs(sectors[0].differences[1]->value) < 1e-6 &&
                std::abs(sectors[0].times[0]->value - 1.6) < 1e-6);
        QVERIFY(std::abs(sectors[1].differences[1]->value - 1) < 1e-6);
        QVERIFY(std::abs(sum - comparison->timeDifferenceAt(1, sectors[2].toM)->value) < 1e-6);
        QCOMPARE(thirdsOf(*comparison).size(), std::size_t(2));
        QVERIFY(sectorTimes(*comparison, {}).size() == 1);
    }

    void aGateComesAgainInEachLap()
    {
        const Profile one = exact(onCircle(0.5, 0.6), 13.2), two = exact(onCircle(0.5, 0.5), 15.8);
        ComparisonOptions options;
        options.task = Task{TaskTemplate::Circle, {}, circlePath({0, 0}, 0.5), {}};
        const auto comparison = compared(one, two, options);
        QVERIFY2(comparison, qPrintable(message(comparison)));
        const auto sectors = sectorTimes(*comparison, {{"Half", M_PI / 2}});
        QCOMPARE(sectors.size(), std::size_t(4)); // to the first, two whole laps, and what is left
        QVERIFY(std::abs(sectors[1].toM - sectors[1].fromM - M_PI) < 1e-3);
        QVERIFY(std::abs(sectors[1].differences[1]->value - M_PI * (1 / 0.5 - 1 / 0.6)) < 2e-3);
        QVERIFY((pointAt(comparison->path, M_PI / 2).position - Eigen::Vector2d(-0.5, 0)).norm() < 1e-3);
    }

    void calibrationCancelsOnlyWhereItIsShared()
    {
        // No noise; all places may be displaced by 4 mm. At equal speeds it cancels when it is shared, at 0.5
        // and 0.4 m/s 4 mm · (1/0.4 − 1/0.5) = 2 ms at the gate and at the station; not shared hypot(8, 10)
        // ms at both.
        const Profile one = exact(evenRun(0.5, 0.5), 6, 0, 0.004),
                      same = exact(evenRun(1.3, 0.5), 8, 0, 0.004),
                      slow = exact(evenRun(1.3, 0.4), 8, 0, 0.004);
        ComparisonOptions shared = byTask();
        shared.shareCalibration = true;
        const auto sigma = [&](const Profile &other, const ComparisonOptions &options) {
            return compared(one, other, options)->timeDifferenceAt(1, 1.1)->sigma;
        };
        QVERIFY2(sigma(same, shared) < 1e-6, qPrintable(QString::number(sigma(same, shared))));
        QVERIFY2(std::abs(sigma(slow, shared) - 0.002 * M_SQRT2) < 1e-5,
                 qPrintable(QString::number(sigma(slow, shared))));
        QVERIFY2(std::abs(sigma(slow, byTask()) - std::hypot(0.008, 0.010) * M_SQRT2) < 1e-4,
                 qPrintable(QString::number(sigma(slow, byTask()))));
    }

    void theStatedSigmaIsTheScatter()
    {
        // 200 pairs of noisy runs that speed up evenly: Δt at 1 m against the truth.
        const auto speedingUp = [](double startS, double accel) {
            return Course([=](double t) {
                const double u = std::max(0.0, t - startS), x = accel * u * u / 2;
                return Truth{{x, 0}, {accel * u, 0}, {accel, 0}};
            });
        };
        std::mt19937 random(7);
        const auto arrival = [](double accel) {
            return std::sqrt(2 * 1.0 / accel) - std::sqrt(2 * 0.2 / accel);
        };
        const double truth = arrival(0.3) - arrival(0.4);
        double squares = 0, sigma = 0, pull = 0;
        constexpr int pairs = 200;
        for (int i = 0; i < pairs; ++i) {
            const Profile one = profileOf(smoothed(speedingUp(0.5, 0.4), 3.5, 0.003, random)),
                          two = profileOf(smoothed(speedingUp(0.7, 0.3), 4.3, 0.003, random));
            const auto comparison = compared(one, two, byTask());
            QVERIFY2(comparison, qPrintable(message(comparison)));
            const auto difference = comparison->timeDifferenceAt(1, 1.0);
            QVERIFY(difference);
            squares += std::pow(difference->value - truth, 2) / pairs;
            sigma += difference->sigma / pairs;
            pull += std::pow((difference->value - truth) / difference->sigma, 2) / pairs;
        }
        // Of 200 pairs the scatter itself is known to 5 %; smoothing counts two neighbours' errors once.
        QVERIFY2(pull > 0.7 && pull < 1.3, qPrintable(QStringLiteral("scatter %1 ms, stated %2 ms")
                                                          .arg(1e3 * std::sqrt(squares))
                                                          .arg(1e3 * sigma)));
    }

    void whatCannotBeCompared()
    {
        const Profile run = exact(evenRun(0.5, 0.5), 6);
        const Profile rests = exact(evenRun(100, 0.5), 3), empty;
        const Profile elsewhere = exact([](double t) { return Truth{{0.5 * t, 3}, {0.5, 0}, {0, 0}}; }, 4);
        QCOMPARE(
            message(compared(run, rests)),
            QStringLiteral(
                "comparison of 'One' and 'Two': the robot does not move in 'Two'; choose a run with motion"));
        QVERIFY(message(compared(empty, run)).contains(QLatin1String("the robot does not move in 'One'")));
        QCOMPARE(message(compared(run, elsewhere)),
                 QStringLiteral("comparison of 'One' and 'Two': 'Two' shares no part of its path with 'One'; "
                                "choose runs of the same task"));
        QVERIFY(message(compared(run, elsewhere, byTask()))
                    .contains(QLatin1String("no part of its path with the task's path")));
        QCOMPARE(message(compareRuns({{foreignWords("One"), &run}}, {})),
                 QStringLiteral("comparison: it needs two runs; choose another run as well"));
        QVERIFY(
            message(compared(run, run, {std::nullopt, AlignBy::StartGate, {}, {}, false}))
                .contains(QLatin1String("does not pass a start gate; align by motion onset or distance")));
        const Profile moving = exact(evenRun(-1, 0.5), 3);
        QVERIFY(message(compared(run, moving, byTask(AlignBy::MotionOnset)))
                    .contains(QLatin1String("is already moving when it is first seen; align by distance")));
        ComparisonOptions hand = byTask(AlignBy::ByHand);
        QVERIFY(message(compared(run, run, hand))
                    .contains(QLatin1String("aligning runs by hand needs a moment in each run")));
        hand.handTimesS = {1, 100};
        QVERIFY(message(compared(run, run, hand))
                    .contains(QLatin1String("the moment entered for 'Two' is outside that run")));
    }
};

ODOGRAPH_TEST(TestRunComparison, QCoreApplication)
#include "tst_run_comparison.moc"
