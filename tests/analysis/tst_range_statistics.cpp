// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics and fits over a range: closed forms, and every stated σ against the scatter over noisy runs of
// known truth.
#include "core/analysis/range_statistics.h"
#include "core/trajectory/internal/track_profile.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace odo;

namespace {

using Way = std::function<double(double timeS)>; ///< x of a robot that drives along the x axis

struct NoiseOf
{
    double sigmaM = 0.002;
    double slowShare = 0; ///< of the variance
};

/// A run of 30 frames a second, smoothed; its truth is x(t), y = 0.
Profile runOf(const Way &way, double durationS, NoiseOf noise, std::mt19937 &random,
              Smoother smoother = Smoother::Rts, double jerkDensity = 5)
{
    std::normal_distribution<double> one(0, 1);
    const double fast = noise.sigmaM * std::sqrt(1 - noise.slowShare),
                 slow = noise.sigmaM * std::sqrt(noise.slowShare);
    Eigen::Vector2d lasting(one(random), one(random));
    Profile profile;
    for (int i = 0; i < int(durationS * 30) + 1; ++i) {
        const double t = i / 30.0;
        if (i > 0) { // exactly the process that MeasurementNoise names
            const double stays = std::exp(-std::abs(way(t) - way(t - 1 / 30.0)) / 0.1);
            lasting =
                stays * lasting + std::sqrt(1 - stays * stays) * Eigen::Vector2d(one(random), one(random));
        }
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(t);
        sample.position =
            Eigen::Vector2d(way(t), 0) + fast * Eigen::Vector2d(one(random), one(random)) + slow * lasting;
        sample.covariance = Eigen::Matrix2d::Identity() * noise.sigmaM * noise.sigmaM;
        profile.samples.push_back(sample);
    }
    AnalysisOptions options;
    options.smoother = smoother;
    profile.points = makePoints(profile.samples, {}, options, {jerkDensity, 1, noise.slowShare, 0.1});
    return profile;
}

TimeSpan spanOf(double from, double to)
{
    return {fromSeconds(from), fromSeconds(to)};
}

/// Root mean square of (measured − truth)/σ: 1 where σ is right.
class Scatter
{
public:
    void add(double measured, double truth, double sigma)
    {
        m_squares += std::pow((measured - truth) / sigma, 2);
        ++m_count;
    }
    double value() const { return std::sqrt(m_squares / m_count); }

private:
    double m_squares = 0;
    int m_count = 0;
};

/// Speeds up evenly: v = 0.4 + 0.3·t.
double evenly(double t)
{
    return 0.4 * t + 0.15 * t * t;
}

/// A curve without noise, σ = 0.1 at each of 101 points of 10 s.
std::vector<CurvePoint> exactCurve(const std::function<double(double)> &value)
{
    std::vector<CurvePoint> points;
    for (int i = 0; i <= 100; ++i)
        points.push_back({i * 0.1, value(i * 0.1), 0.1, 0});
    return points;
}

} // namespace

class TestRangeStatistics : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void correlationIsThatOfTheSpectrum_data()
    {
        QTest::addColumn<int>("course");
        QTest::addColumn<int>("power"); // of u in the numerator of the spectrum u^p/(1 + u⁶)
        QTest::newRow("position") << int(ErrorCourse::Position) << 0;
        QTest::newRow("velocity") << int(ErrorCourse::Velocity) << 2;
        QTest::newRow("acceleration") << int(ErrorCourse::Acceleration) << 4;
    }
    void correlationIsThatOfTheSpectrum()
    {
        QFETCH(int, course);
        QFETCH(int, power);
        for (const double s : {0.0, 0.3, 1.0, 2.5, 6.0}) {
            double numerator = 0, denominator = 0; // the integral by the midpoint rule
            for (double u = 0.0005; u < 400; u += 0.001) {
                const double spectrum = std::pow(u, power) / (1 + std::pow(u, 6));
                numerator += spectrum * std::cos(u * s);
                denominator += spectrum;
            }
            // What lies beyond u = 400 of u⁻² is 1/400 of 1.05.
            QVERIFY(std::abs(errorCorrelation(static_cast<ErrorCourse>(course), s) -
                             numerator / denominator) < 4e-3);
        }
    }
    void fastSumIsTheDoubleSum()
    {
        std::vector<CurvePoint> points;
        Eigen::MatrixXd weights(40, 2);
        for (int i = 0; i < 40; ++i) { // uneven in everything
            points.push_back({i * 0.03 + 0.01 * std::sin(i), 0, 0.1 + 0.01 * (i % 7), 10 + (i % 5) * 1.0});
            weights.row(i) << std::cos(i), i - 20.0;
        }
        for (const ErrorCourse course : {ErrorCourse::Position, ErrorCourse::Velocity}) {
            Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
            for (int i = 0; i < 40; ++i)
                for (int j = 0; j < 40; ++j) {
                    double s = 0;
                    for (int k = std::min(i, j); k < std::max(i, j); ++k) {
                        const auto &a = points[std::size_t(k)], &b = points[std::size_t(k) + 1];
                        s += (b.timeS - a.timeS) * (a.errorRate + b.errorRate) / 2;
                    }
                    sum += weights.row(i).transpose() * weights.row(j) * points[std::size_t(i)].sigma *
                           points[std::size_t(j)].sigma * errorCorrelation(course, s);
                }
            QVERIFY((errorCovariance(points, course, weights) - sum).norm() < 1e-9 * sum.norm());
        }
    }
    void fitsAreExact()
    {
        const auto curve = exactCurve([](double t) { return 3 - 2 * t + 0.5 * t * t; });
        const auto parabola = fitCurve(curve, ErrorCourse::Independent, FitShape::Parabola);
        QVERIFY(parabola);
        QVERIFY((parabola->coefficients - Eigen::Vector3d(3, -2, 0.5)).norm() < 1e-9);
        QVERIFY(parabola->rms < 1e-9 && parabola->chiSquared < 1e-9);
        QCOMPARE(parabola->points, std::size_t(101));
        QVERIFY(std::abs(parabola->expectedChiSquared - 98) < 1e-9); // n − p
        QVERIFY(std::abs(parabola->at(4) - 3) < 1e-9);
        const auto line = fitCurve(exactCurve([](double t) { return 1 + 0.25 * t; }),
                                   ErrorCourse::Independent, FitShape::Line);
        QVERIFY((line->coefficients - Eigen::Vector3d(1, 0.25, 0)).norm() < 1e-12);
        // σ of a slope: σ/√Σ(t − t̄)², of n equal steps h: σ/(h√(n(n² − 1)/12)).
        QVERIFY(std::abs(line->sigma(1) - 0.1 / (0.1 * std::sqrt(101.0 * (101.0 * 101 - 1) / 12))) < 1e-12);
        const auto constant =
            fitCurve(exactCurve([](double) { return 7; }), ErrorCourse::Independent, FitShape::Constant);
        QCOMPARE(constant->coefficients[0], 7.0);
        QVERIFY(std::abs(constant->sigma(0) - 0.1 / std::sqrt(101.0)) < 1e-12);
    }
    void badShapeIsTold()
    {
        // Beside the parabola a tenth of the stated σ, now above, now below.
        const auto curve =
            exactCurve([](double t) { return 0.1 * t * t + (std::lround(t * 10) % 2 == 0 ? 0.01 : -0.01); });
        const auto line = fitCurve(curve, ErrorCourse::Independent, FitShape::Line);
        QCOMPARE(verdictOf(*line), FitVerdict::Departs);
        QVERIFY(line->neighbourFactor > 5); // its residuals are a curve, not noise
        QCOMPARE(verdictOf(*fitCurve(curve, ErrorCourse::Independent, FitShape::Parabola)),
                 FitVerdict::Closer);
    }
    void tooFewPointsAreRefused_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("shape");
        QTest::addColumn<QString>("words");
        QTest::newRow("none") << 0 << 0
                              << "fit of a constant: 0 points are too few for it; choose a longer range";
        QTest::newRow("one") << 1 << 1
                             << "fit of a straight line: 1 point is too few for it; choose a longer range";
        QTest::newRow("three") << 3 << 2
                               << "fit of a parabola: 3 points are too few for it; choose a longer range";
    }
    void tooFewPointsAreRefused()
    {
        QFETCH(int, points);
        QFETCH(int, shape);
        QFETCH(QString, words);
        auto curve = exactCurve([](double t) { return t; });
        curve.resize(std::size_t(points));
        curve.push_back({50, 1, 0, 0}); // no σ: it does not count
        const auto fit = fitCurve(curve, ErrorCourse::Independent, static_cast<FitShape>(shape));
        QVERIFY(!fit);
        QCOMPARE(fit.error().code, ErrorCode::Undetermined);
        QCOMPARE(QString::fromStdString(fit.error().message()), words);
    }
    void onePointInTimeIsRefused()
    {
        const std::vector<CurvePoint> same(5, CurvePoint{2, 1, 0.1, 0});
        QVERIFY(!fitCurve(same, ErrorCourse::Independent, FitShape::Constant));
    }

    void statisticsAreThoseOfTheCurve()
    {
        std::mt19937 random(1);
        // x = 1 − cos t: the speed is sin t, over half a turn.
        const Profile profile =
            runOf([](double t) { return 1 - std::cos(t); }, 3.2, {1e-6, 0}, random, Smoother::Rts, 1);
        const double pi = std::numbers::pi;
        const auto speed = statisticsOf(profile, Quantity::Speed, spanOf(0, pi));
        QVERIFY(speed);
        // Frames 33 ms apart end up to a frame before π: 1e-3 of the mean at most.
        QVERIFY(std::abs(speed->mean.value - 2 / pi) < 5e-3);
        QVERIFY(std::abs(speed->median.value - std::sin(pi / 4)) < 5e-3);
        QVERIFY(std::abs(speed->most.value.value - 1) < 1e-3);
        QVERIFY(std::abs(speed->most.timeS - pi / 2) < 0.04);
        QVERIFY(std::abs(speed->spread.value - std::sqrt(0.5 - 4 / (pi * pi))) < 5e-3);
        QVERIFY(speed->least.value.value < 0.05);
        const auto x = statisticsOf(profile, Quantity::PositionX, spanOf(0, pi));
        QVERIFY(std::abs(x->mean.value - 1) < 0.02);
        const auto path = pathWithin(profile, spanOf(0.5, 2.5));
        QVERIFY(path && std::abs(path->value - (std::cos(0.5) - std::cos(2.5))) < 2e-3);
    }
    void nothingInTheSpanGivesNothing()
    {
        std::mt19937 random(1);
        const Profile profile = runOf(evenly, 1, {}, random);
        QVERIFY(!statisticsOf(profile, Quantity::Speed, spanOf(5, 6)));
        QVERIFY(!pathWithin(profile, spanOf(5, 6)));
        QVERIFY(!fitQuantity(profile, Quantity::Speed, spanOf(5, 6), FitShape::Constant));
        QVERIFY(!statisticsOf(Profile(), Quantity::Heading, spanOf(0, 1)));
        const auto one = statisticsOf(profile, Quantity::Speed, spanOf(0.5, 0.51)); // a single frame
        QVERIFY(one && one->points == 1 && one->spread.value == 0);
        QVERIFY(one->mean.sigma > 0);
    }
    void calibrationIsContained()
    {
        std::mt19937 random(1);
        Profile profile = runOf(evenly, 3, {}, random);
        const auto before = fitQuantity(profile, Quantity::PositionX, spanOf(0.5, 2.5), FitShape::Line);
        for (Sample &sample : profile.samples)
            sample.commonCovariance = Eigen::Matrix2d::Identity() * 9e-6; // 3 mm
        for (ProfilePoint &point : profile.points)
            point.sigmaXM = std::hypot(point.sigmaXM, 0.003);
        const auto after = fitQuantity(profile, Quantity::PositionX, spanOf(0.5, 2.5), FitShape::Line);
        QVERIFY(std::abs(std::hypot(before->sigma(0), 0.003) - after->sigma(0)) < 1e-9);
        QVERIFY(after->sigma(1) > before->sigma(1)); // its error of scale
        const auto mean = statisticsOf(profile, Quantity::PositionX, spanOf(0.5, 2.5));
        QVERIFY(mean->mean.sigma > 0.003 && mean->mean.sigma < 0.0032);
    }

    /// 400 runs: a right σ gives 1 ± 0.035. Too small a σ would be a promise that is not kept, so hardly more
    /// than 1.15 is let through (an outline's slow error is the one that the model has but approximately).
    /// Too large ones come from what σ allows for and this even motion does not have: a smoother reckons with
    /// jerk at every moment (of the velocity's variance half, see the spectrum), and differences of raw
    /// positions hang together otherwise.
    void statedSigmasHold_data()
    {
        QTest::addColumn<double>("slowShare");
        QTest::addColumn<int>("smoother");
        QTest::addColumn<double>("lowest");
        QTest::newRow("white") << 0.0 << int(Smoother::Rts) << 0.6;
        QTest::newRow("slow part") << 0.4 << int(Smoother::Rts) << 0.65;
        QTest::newRow("Savitzky-Golay") << 0.0 << int(Smoother::SavGol) << 0.38;
        QTest::newRow("Tracker") << 0.0 << int(Smoother::Tracker) << 0.45;
        QTest::newRow("raw") << 0.0 << int(Smoother::None) << 0.42;
    }
    void statedSigmasHold()
    {
        QFETCH(double, slowShare);
        QFETCH(int, smoother);
        QFETCH(double, lowest);
        constexpr double highest = 1.2;
        // Raw differences of differences are noise of many times the motion's acceleration, and its part
        // along the noisy path has a bias that no σ tells.
        const bool hasAcceleration = static_cast<Smoother>(smoother) != Smoother::None;
        std::mt19937 random(7);
        const TimeSpan span = spanOf(0.5, 2.5);
        const double begin = 0.5, end = 2.5;
        Scatter mean, slope, start, path, speedByPosition, accelByPosition, meanAccel;
        for (int run = 0; run < 400; ++run) {
            const Profile profile =
                runOf(evenly, 3, {0.002, slowShare}, random, static_cast<Smoother>(smoother));
            const auto speed = statisticsOf(profile, Quantity::Speed, span);
            mean.add(speed->mean.value, 0.4 + 0.3 * (begin + end) / 2, speed->mean.sigma);
            const auto accel = statisticsOf(profile, Quantity::Acceleration, span);
            meanAccel.add(accel->mean.value, 0.3, accel->mean.sigma);
            const auto line = fitQuantity(profile, Quantity::Speed, span, FitShape::Line);
            slope.add(line->coefficients[1], 0.3, line->sigma(1));
            start.add(line->coefficients[0], 0.4 + 0.3 * begin, line->sigma(0));
            const auto driven = pathWithin(profile, span);
            path.add(driven->value, evenly(end) - evenly(begin), driven->sigma);
            const auto position = fitQuantity(profile, Quantity::PositionX, span, FitShape::Parabola);
            speedByPosition.add(position->coefficients[1], 0.4 + 0.3 * begin, position->sigma(1));
            accelByPosition.add(position->coefficients[2], 0.15, position->sigma(2));
        }
        std::vector<std::pair<const char *, Scatter>> all{{"mean speed", mean},
                                                          {"slope", slope},
                                                          {"start", start},
                                                          {"path", path},
                                                          {"speed by place", speedByPosition},
                                                          {"acceleration by place", accelByPosition}};
        if (hasAcceleration)
            all.push_back({"mean acceleration", meanAccel});
        for (const auto &[name, scatter] : all)
            QVERIFY2(
                scatter.value() > lowest && scatter.value() < highest,
                qPrintable(
                    QStringLiteral("%1: %2 of the stated σ").arg(QLatin1String(name)).arg(scatter.value())));
    }
    void chiSquaredOfMeasurementsIsOne()
    {
        std::mt19937 random(3);
        double sum = 0;
        int describes = 0;
        for (int run = 0; run < 200; ++run) {
            const Profile profile = runOf(evenly, 3, {}, random);
            const auto fit = fitQuantity(profile, Quantity::PositionX, spanOf(0.5, 2.5), FitShape::Parabola);
            sum += fit->reducedChiSquared();
            describes += verdictOf(*fit) == FitVerdict::Describes;
        }
        QVERIFY(std::abs(sum / 200 - 1) < 0.04); // 61 points: √(2/58/200) = 0.013
        QVERIFY(describes >= 180);               // two standard deviations: 95 %
    }
};

ODOGRAPH_TEST(TestRangeStatistics, QCoreApplication)
#include "tst_range_statistics.moc"
