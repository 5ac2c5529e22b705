// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/track_profile.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

constexpr double sigma = 0.002;

std::vector<TrackNode> nodes(int count, double stepS, const std::function<double(double)> &x)
{
    std::vector<TrackNode> all;
    for (int i = 0; i < count; ++i)
        all.push_back({i * stepS, true, Eigen::Vector2d(x(i * stepS), -x(i * stepS)),
                       Eigen::Matrix2d::Identity() * sigma * sigma});
    return all;
}

bool near(double value, double expected, double relative = 1e-9)
{
    return std::abs(value - expected) <= relative * std::max(1.0, std::abs(expected));
}

} // namespace

class TestLocalDerivatives : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void savitzkyGolayHasTheTabledWeights()
    {
        // Cubic over 11 points: the middle weight of the value is 89/429, and so is its variance.
        const auto track = nodes(21, 0.1, [](double t) { return 2 + 3 * t - t * t + 4 * t * t * t; });
        const auto middle = savitzkyGolay(track, 10, 1);
        QVERIFY(middle.has_value());
        QVERIFY(near(middle->mean[0], 2 + 3 - 1 + 4));
        QVERIFY(near(middle->mean[2], 3 - 2 + 12));
        QVERIFY(near(middle->mean[4], -2 + 24));
        QVERIFY(near(middle->covariance(0, 0) / (sigma * sigma), 89.0 / 429, 1e-6));
        // The second derivative's weights are those of a parabola: Σ(i² − 10)² = 858, variance
        // (2/858)²·858/h⁴.
        QVERIFY(near(middle->covariance(4, 4), sigma * sigma * 4 / 858 / 1e-4, 1e-6));
        // A cubic is exact at the ends and beside a gap, too.
        QVERIFY(near(savitzkyGolay(track, 0, 1)->mean[2], 3));
        auto gapped = track;
        gapped[9].measured = gapped[10].measured = false;
        QVERIFY(near(savitzkyGolay(gapped, 10, 1)->mean[4], 22, 1e-7));
        QVERIFY(!savitzkyGolay(nodes(3, 0.1, [](double t) { return t; }), 1, 1));
    }

    void trackerAgreesWithItsFormulas()
    {
        const auto x = [](double t) { return std::sin(3 * t); };
        const double h = 1.0 / 30;
        const auto track = nodes(9, h, x);
        const auto got = trackerDifferences(track, 4, 1);
        QVERIFY(got.has_value());
        const double t = 4 * h;
        QVERIFY(near(got->mean[2], (x(t + h) - x(t - h)) / (2 * h)));
        QVERIFY(near(got->mean[4],
                     (2 * x(t + 2 * h) - x(t + h) - 2 * x(t) - x(t - h) + 2 * x(t - 2 * h)) / (7 * h * h)));
        QVERIFY(near(got->covariance(2, 2), sigma * sigma / (2 * h * h)));
        QVERIFY(near(got->covariance(4, 4), sigma * sigma * 14 / std::pow(7 * h * h, 2)));
        QVERIFY(!trackerDifferences(track, 1, 1));
        QVERIFY(!trackerDifferences(track, 8, 1));
        auto gapped = track;
        gapped[5].measured = false;
        QVERIFY(!trackerDifferences(gapped, 4, 1));
    }

    void rawDifferencesAreThePapers()
    {
        const double h = 0.04;
        const auto track = nodes(5, h, [](double t) { return t * t; });
        const auto got = rawDifferences(track, 3, 1);
        QVERIFY(got.has_value());
        QVERIFY(near(got->mean[2], (9 - 4) * h));
        QVERIFY(near(got->mean[4], 2));
        QVERIFY(near(got->covariance(4, 4), 6 * sigma * sigma / std::pow(h, 4)));
        QVERIFY(!rawDifferences(track, 1, 1));
    }
};

ODOGRAPH_TEST(TestLocalDerivatives, QCoreApplication)
#include "tst_local_derivatives.moc"
