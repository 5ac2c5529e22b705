// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/motion_noise.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <functional>
#include <random>

using namespace odo;

namespace {

std::vector<TrackNode> track(int count, double stepS, double sigmaM,
                             const std::function<Eigen::Vector2d(double)> &course, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, sigmaM);
    std::vector<TrackNode> nodes;
    for (int i = 0; i < count; ++i) {
        const double t = i * stepS;
        nodes.push_back({t, true, course(t) + Eigen::Vector2d(noise(random), noise(random)),
                         Eigen::Matrix2d::Identity() * sigmaM * sigmaM});
    }
    return nodes;
}

/// A run of the model itself: white jerk of a density, white measurement noise.
struct Simulated
{
    std::vector<Eigen::Matrix<double, 6, 1>> states;
    std::vector<TrackNode> nodes;
};

Simulated simulate(int count, double dt, double density, double sigmaM, std::mt19937 &random)
{
    std::normal_distribution<double> noise(0, 1);
    Eigen::Matrix3d q, f;
    q << std::pow(dt, 5) / 20, std::pow(dt, 4) / 8, std::pow(dt, 3) / 6, std::pow(dt, 4) / 8,
        std::pow(dt, 3) / 3, dt * dt / 2, std::pow(dt, 3) / 6, dt * dt / 2, dt;
    f << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
    const Eigen::Matrix3d root = (density * q).llt().matrixL();
    Eigen::Matrix<double, 3, 2> state = Eigen::Matrix<double, 3, 2>::Zero();
    Simulated simulated;
    for (int i = 0; i < count; ++i) {
        Eigen::Matrix<double, 3, 2> kick;
        for (double &k : kick.reshaped())
            k = noise(random);
        state = f * state + root * kick;
        Eigen::Matrix<double, 6, 1> packed;
        packed << state.row(0).transpose(), state.row(1).transpose(), state.row(2).transpose();
        simulated.states.push_back(packed);
        simulated.nodes.push_back({i * dt, true,
                                   packed.head<2>() + sigmaM * Eigen::Vector2d(noise(random), noise(random)),
                                   Eigen::Matrix2d::Identity() * sigmaM * sigmaM});
    }
    return simulated;
}

std::vector<MotionEstimate> smoothed(std::span<const TrackNode> nodes, MotionNoise noise)
{
    std::vector<MotionEstimate> estimates(nodes.size());
    smoothMotion(nodes, noise,
                 [&](std::size_t i, const MotionEstimate &estimate) { estimates[i] = estimate; });
    return estimates;
}

} // namespace

class TestKalmanSmoother : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// A covariance of nearly nothing between the axes takes the way in which they are not apart.
    void axesApartGiveTheSame()
    {
        auto apart = track(
            400, 0.02, 0.004, [](double t) { return Eigen::Vector2d(std::sin(t), 0.3 * t * t); }, 5);
        for (std::size_t i = 0; i < apart.size(); ++i) {
            apart[i].covariance(1, 1) *= 1.5;
            apart[i].measured = i % 7 != 3;
            apart[i].struck = i == 200;
        }
        auto joined = apart;
        for (TrackNode &node : joined)
            node.covariance(0, 1) = node.covariance(1, 0) = 1e-20;
        const MotionNoise noise{20, 1.3};
        const auto one = smoothed(apart, noise), other = smoothed(joined, noise);
        for (std::size_t i = 0; i < one.size(); ++i) {
            QVERIFY((one[i].mean - other[i].mean).norm() < 1e-9 * (1 + other[i].mean.norm()));
            QVERIFY((one[i].covariance - other[i].covariance).norm() < 1e-8 * other[i].covariance.norm());
        }
        MotionFilter first(noise), second(noise);
        for (std::size_t i = 0; i < apart.size(); ++i) {
            first.predict(apart[i]);
            second.predict(joined[i]);
            if (first.started()) {
                double a = 0, b = 0;
                const double distance = first.distanceSquared(apart[i], &a);
                QVERIFY(std::abs(distance - second.distanceSquared(joined[i], &b)) < 1e-8 * (1 + distance));
                QVERIFY(std::abs(a - b) < 1e-9);
                QVERIFY(std::abs(first.logVolume() - second.logVolume()) < 1e-7);
            }
            first.update(apart[i]);
            second.update(joined[i]);
        }
    }
    void constantVelocityIsExact()
    {
        // Irregular times, no noise: position and velocity must come out to rounding.
        std::vector<TrackNode> nodes;
        for (const double t : {0.0, 0.03, 0.071, 0.1, 0.2, 0.21, 0.5, 0.53})
            nodes.push_back(
                {t, true, Eigen::Vector2d(1 + 2 * t, 3 - 0.5 * t), Eigen::Matrix2d::Identity() * 1e-10});
        for (const MotionEstimate &estimate : smoothed(nodes, {1.0, 1.0})) {
            QVERIFY((estimate.velocity() - Eigen::Vector2d(2, -0.5)).norm() < 1e-4);
            QVERIFY(estimate.acceleration().norm() < 1e-2);
        }
    }

    void theSteadyStateSolvesRiccatisEquation()
    {
        // After many equal steps the filter's covariance is the fixed point of P = F·(P − K·S·Kᵀ)·Fᵀ + Q of
        // one axis, found here by iterating the three by three equation written out on its own.
        const double dt = 1.0 / 30, q = 8, r = 0.002 * 0.002;
        Eigen::Matrix3d f, noise, p = Eigen::Matrix3d::Identity();
        f << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
        noise << std::pow(dt, 5) / 20, std::pow(dt, 4) / 8, std::pow(dt, 3) / 6, std::pow(dt, 4) / 8,
            std::pow(dt, 3) / 3, dt * dt / 2, std::pow(dt, 3) / 6, dt * dt / 2, dt;
        noise *= q;
        for (int i = 0; i < 3000; ++i) {
            const Eigen::Vector3d gain = p.col(0) / (p(0, 0) + r);
            p = f * (p - gain * p.row(0)) * f.transpose() + noise;
        }
        MotionFilter filter({q, 1});
        for (int i = 0; i < 600; ++i) {
            filter.predict({i * dt});
            filter.update({i * dt, true, {0.3 * i, 0}, Eigen::Matrix2d::Identity() * r});
        }
        filter.predict({600 * dt});
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                const double expected = p(row, column);
                QVERIFY(std::abs(filter.estimate().covariance(2 * row, 2 * column) - expected) <
                        1e-6 * std::abs(expected));
                QVERIFY(filter.estimate().covariance(2 * row, 2 * column + 1) == 0);
            }
        }
    }

    void anAbruptChangeIsAllowedForAtAnyMoment()
    {
        // The moments of a change of velocity Δv at an even u in [0, T]: E[x²] = σ²T²/3, E[xv] = σ²T/2.
        MotionFilter filter({1e-12, 1});
        filter.restart({0, true, {0, 0}, Eigen::Matrix2d::Identity() * 1e-12}, 0, 0);
        filter.predict({0.2});
        filter.disturb(1.5, 0, 0.2);
        const auto &covariance = filter.estimate().covariance;
        QVERIFY(std::abs(covariance(0, 0) - 2.25 * 0.04 / 3) < 1e-9);
        QVERIFY(std::abs(covariance(0, 2) - 2.25 * 0.1) < 1e-9);
        QVERIFY(std::abs(covariance(3, 3) - 2.25) < 1e-9);
        QVERIFY(covariance(4, 4) < 1e-9);
    }

    void aBlowPartsTheMotionBeforeFromThatAfter()
    {
        // A bounce between two frames, exactly measured: a straight line on either side. Without the word the
        // smoother must bend the way.
        const double impactS = 2.01;
        const auto course = [&](double t) {
            return Eigen::Vector2d(t < impactS ? t : impactS - 0.3 * (t - impactS), 0.1 * t);
        };
        auto nodes = track(120, 1 / 30.0, 0.0005, course, 3);
        for (TrackNode &node : nodes)
            node.position = course(node.timeS);
        const auto worstSpeedError = [&] {
            double worst = 0;
            for (const MotionEstimate &estimate : smoothed(nodes, {5, 1})) {
                worst = std::max(worst, std::min((estimate.velocity() - Eigen::Vector2d(1, 0.1)).norm(),
                                                 (estimate.velocity() - Eigen::Vector2d(-0.3, 0.1)).norm()));
            }
            return worst;
        };
        QVERIFY(worstSpeedError() > 0.3);
        nodes[61].struck = true;
        QVERIFY2(worstSpeedError() < 0.005, qPrintable(QString::number(worstSpeedError())));
    }
    void aBlowIsAsUncertainAsStated()
    {
        // Runs of the model with a blow as it is allowed for, at an even moment of the step before node 30.
        std::mt19937 random(12);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> even(0, 1);
        constexpr int runs = 400, struck = 30;
        constexpr double dt = 1 / 30.0, density = 5, sigmaM = 0.0005;
        double squares[2] = {0, 0};
        for (int run = 0; run < runs; ++run) {
            Simulated simulated = simulate(60, dt, density, sigmaM, random);
            const double since = dt * even(random);
            const Eigen::Vector2d speed = blowSpeedSigmaMps * Eigen::Vector2d(normal(random), normal(random));
            const Eigen::Vector2d accel =
                blowAccelSigmaMps2 * Eigen::Vector2d(normal(random), normal(random));
            for (int i = struck; i < 60; ++i) {
                const double t = since + (i - struck) * dt;
                auto &state = simulated.states[static_cast<std::size_t>(i)];
                const Eigen::Vector2d shift = speed * t + accel * t * t / 2;
                state.head<2>() += shift;
                state.segment<2>(2) += speed + accel * t;
                state.tail<2>() += accel;
                simulated.nodes[static_cast<std::size_t>(i)].position += shift;
            }
            simulated.nodes[struck].struck = true;
            const auto estimates = smoothed(simulated.nodes, {density, 1});
            for (const int i : {struck - 1, struck}) {
                const auto node = static_cast<std::size_t>(i);
                const Eigen::Matrix<double, 6, 1> error = estimates[node].mean - simulated.states[node];
                squares[i - struck + 1] += error.dot(estimates[node].covariance.ldlt().solve(error)) / runs;
            }
        }
        // χ² of six degrees of freedom: the mean of 400 is known to ±0.17; the moment is uniform, not normal.
        for (const double squared : squares)
            QVERIFY2(std::abs(squared - 6) < 0.7, qPrintable(QString::number(squared)));
    }
    void withoutProcessNoiseItIsAParabolaFit()
    {
        // q → 0: least squares of a parabola with equal weights (the start's ignorance is negligible: 1e4 σ).
        const double sigma = 0.002;
        const auto nodes = track(
            40, 1.0 / 30, sigma, [](double t) { return Eigen::Vector2d(t + t * t, -t); }, 3);
        Eigen::MatrixXd powers(40, 3);
        Eigen::VectorXd x(40);
        const double t0 = nodes[7].timeS;
        for (int i = 0; i < 40; ++i) {
            const double u = nodes[static_cast<std::size_t>(i)].timeS - t0;
            powers.row(i) << 1, u, u * u / 2;
            x[i] = nodes[static_cast<std::size_t>(i)].position.x();
        }
        const Eigen::Matrix3d covariance = (powers.transpose() * powers).inverse() * sigma * sigma;
        const Eigen::Vector3d fit = (powers.transpose() * powers).ldlt().solve(powers.transpose() * x);
        const MotionEstimate estimate = smoothed(nodes, {1e-12, 1.0})[7];
        for (int k = 0; k < 3; ++k) {
            const double s = std::sqrt(covariance(k, k));
            QVERIFY2(std::abs(estimate.mean[2 * k] - fit[k]) < 0.01 * s, qPrintable(QString::number(k)));
            QVERIFY(std::abs(std::sqrt(estimate.covariance(2 * k, 2 * k)) / s - 1) < 0.01);
        }
    }

    void theAxesShareACovariance()
    {
        // Fully determined by the rotated problem: smoothing must commute with turning the world.
        auto nodes = track(
            30, 0.04, 0.003, [](double t) { return Eigen::Vector2d(t, t * t); }, 5);
        Eigen::Matrix2d shape;
        shape << 9e-6, 4e-6, 4e-6, 3e-6;
        for (TrackNode &node : nodes)
            node.covariance = shape;
        const auto plain = smoothed(nodes, {20, 1});
        const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
        for (TrackNode &node : nodes) {
            node.position = turn * node.position;
            node.covariance = turn * node.covariance * turn.transpose();
        }
        const auto turned = smoothed(nodes, {20, 1});
        for (std::size_t i = 0; i < nodes.size(); ++i)
            QVERIFY((turned[i].velocity() - turn * plain[i].velocity()).norm() < 1e-8);
    }

    void aGapWidensTheSigmaAndClosesAgain()
    {
        auto nodes = track(
            60, 1.0 / 30, 0.002, [](double t) { return Eigen::Vector2d(t, 0); }, 7);
        for (std::size_t i = 25; i < 40; ++i)
            nodes[i].measured = false;
        const auto estimates = smoothed(nodes, {10, 1});
        const auto sigma = [&](std::size_t i) { return std::sqrt(estimates[i].covariance(0, 0)); };
        QVERIFY(sigma(32) > 3 * sigma(15));
        QVERIFY(sigma(32) > sigma(27));
        QVERIFY(sigma(32) > sigma(38));
        QVERIFY(std::abs(estimates[32].mean[0] - nodes[32].timeS) < 3 * sigma(32));
    }

    void aLongTrackIsSmoothedAsOne()
    {
        // Equal steps: far from the ends all covariances are the same, and nodes that far apart tell nothing
        // of one another. So a long track must show no seam, and its middle must be that of a piece around
        // it, to rounding.
        std::mt19937 random(21);
        const Simulated simulated = simulate(4000, 1.0 / 30, 5, 0.002, random);
        const auto all = smoothed(simulated.nodes, {5, 1});
        for (std::size_t i = 300; i < 3700; ++i)
            QVERIFY2((all[i].covariance - all[2000].covariance).norm() < 1e-9 * all[2000].covariance.norm(),
                     qPrintable(QString::number(i)));
        for (const std::size_t first : {700, 1500, 2700}) { // each with a whole number of 1024 in it
            const auto piece = smoothed(std::span(simulated.nodes).subspan(first, 700), {5, 1});
            for (std::size_t i = 300; i < 400; ++i) {
                const Eigen::Vector2d apart = piece[i].position() - all[first + i].position();
                QVERIFY2(apart.norm() < 1e-9, qPrintable(QString::number(apart.norm())));
            }
        }
    }

    void findsTheNoiseThatMadeTheTrack()
    {
        std::mt19937 random(11);
        const Simulated simulated = simulate(3000, 0.02, 8, 0.004, random);
        auto nodes = simulated.nodes;
        for (TrackNode &node : nodes)
            node.covariance /= 4; // measurements twice as noisy as stated
        const MotionNoise found = estimateMotionNoise({std::span<const TrackNode>(nodes)}, false);
        QVERIFY2(std::abs(found.measurementScale - 4) < 0.3,
                 qPrintable(QString::number(found.measurementScale)));
        QVERIFY2(found.jerkDensity > 5 && found.jerkDensity < 12,
                 qPrintable(QString::number(found.jerkDensity)));
    }

    void truthLiesInsideTheIntervals()
    {
        // 95 % intervals of position, velocity and acceleration over runs drawn from the model, noise
        // estimated.
        std::mt19937 random(17);
        std::array<int, 3> inside{};
        int total = 0;
        for (int run = 0; run < 15; ++run) {
            const Simulated simulated = simulate(200, 1.0 / 30, 20, 0.002, random);
            const auto noise = estimateMotionNoise({std::span<const TrackNode>(simulated.nodes)}, false);
            const auto estimates = smoothed(simulated.nodes, noise);
            for (std::size_t i = 0; i < estimates.size(); ++i) {
                for (int k = 0; k < 6; ++k)
                    inside[static_cast<std::size_t>(k / 2)] +=
                        std::abs(estimates[i].mean[k] - simulated.states[i][k]) <
                        1.96 * std::sqrt(estimates[i].covariance(k, k));
                total += 2;
            }
        }
        for (const int count : inside)
            QVERIFY2(count > 0.92 * total && count < 0.98 * total,
                     qPrintable(QString::number(double(count) / total)));
    }

    void aRobotAtRestNeedsNoJerk()
    {
        const auto nodes = track(
            300, 1.0 / 30, 0.002, [](double) { return Eigen::Vector2d(1, 1); }, 13);
        const MotionNoise found = estimateMotionNoise({std::span<const TrackNode>(nodes)}, false);
        QVERIFY(found.jerkDensity < 1e-3);
        const auto estimates = smoothed(nodes, found);
        QVERIFY(estimates[150].velocity().norm() < 0.002);
        QVERIFY(estimates[150].covariance.allFinite());
    }
};

ODOGRAPH_TEST(TestKalmanSmoother, QCoreApplication)
#include "tst_kalman_smoother.moc"
