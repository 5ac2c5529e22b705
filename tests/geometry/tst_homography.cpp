// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/homography.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <array>
#include <random>

using namespace odo;
using Eigen::Vector2d;

namespace {

/// An oblique view of a floor of 2 m × 1.5 m: pixels by metres.
Homography oblique()
{
    Eigen::Matrix3d matrix;
    matrix << 400, 120, 200, -30, 150, 600, 0.05, 0.35, 1;
    return Homography(matrix);
}

std::vector<PointPair> seen(const std::vector<Vector2d> &sources)
{
    static const char *const labels[] = {"O", "U", "V", "D", "E", "F", "G", "H"};
    std::vector<PointPair> pairs;
    for (const Vector2d &source : sources)
        pairs.push_back({source, *oblique().map(source), pairs.size() < 8 ? labels[pairs.size()] : ""});
    return pairs;
}

std::vector<PointPair> square()
{
    return seen({{0, 0}, {2, 0}, {0, 1.5}, {2, 1.5}});
}

bool refusedWith(const std::vector<PointPair> &pairs, const char *words)
{
    const auto homography = Homography::estimate(pairs);
    if (homography)
        return false;
    const bool told = homography.error().message().find(words) != std::string::npos;
    if (!told)
        qWarning("told instead: %s", homography.error().message().c_str());
    return told;
}

} // namespace

class TestHomography : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void fourPointsGiveItExactly()
    {
        const auto homography = Homography::estimate(square());
        QVERIFY(homography.has_value());
        QVERIFY((homography->matrix() - oblique().matrix()).norm() < 1e-12);
        for (const PointPair &pair : square()) {
            QVERIFY((*homography->map(pair.source) - pair.target).norm() < 1e-9);
            QVERIFY((*homography->inverse().map(pair.target) - pair.source).norm() < 1e-9);
        }
    }
    void manyPointsAverageTheNoise()
    {
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0, 0.5);
        std::vector<Vector2d> sources;
        for (int i = 0; i < 400; ++i)
            sources.emplace_back(0.1 * (i % 20), 0.075 * (i / 20));
        std::vector<PointPair> pairs = seen(sources);
        for (PointPair &pair : pairs)
            pair.target += Vector2d(noise(random), noise(random));
        const auto homography = Homography::estimate(pairs);
        QVERIFY(homography.has_value());
        // 0.5 px over 800 equations and 8 unknowns leaves 0.05 px; corners some three times that.
        double worst = 0, squares = 0;
        for (std::size_t i = 0; i < sources.size(); ++i) {
            worst = std::max(worst, (*homography->map(sources[i]) - *oblique().map(sources[i])).norm());
            squares += (*homography->map(sources[i]) - pairs[i].target).squaredNorm();
        }
        QVERIFY(worst < 0.25);
        QVERIFY(std::abs(std::sqrt(squares / 792) - 0.5) < 0.05);
    }
    void refinementMinimisesTheDistanceInTheTargetPlane()
    {
        std::vector<PointPair> pairs = seen({{0, 0}, {2, 0}, {0, 1.5}, {2, 1.5}, {1, 0.7}, {0.4, 1.1}});
        std::mt19937 random(11);
        std::normal_distribution<double> noise(0, 2.0);
        for (PointPair &pair : pairs)
            pair.target += Vector2d(noise(random), noise(random));
        const auto homography = Homography::estimate(pairs);
        const auto cost = [&](const Eigen::Matrix3d &matrix) {
            double sum = 0;
            for (const PointPair &pair : pairs)
                sum += (*Homography(matrix).map(pair.source) - pair.target).squaredNorm();
            return sum;
        };
        const double least = cost(homography->matrix());
        for (int i = 0; i < 9; ++i) {
            for (double step : {-1e-5, 1e-5}) {
                Eigen::Matrix3d matrix = homography->matrix();
                matrix(i / 3, i % 3) *= 1 + step;
                QVERIFY(cost(matrix) >= least);
            }
        }
    }
    void mirroredPointsAreAllowed()
    {
        // Whether a mirrored view is possible is not the homography's to say.
        std::vector<PointPair> pairs = square();
        for (PointPair &pair : pairs)
            pair.target.x() = 1280 - pair.target.x();
        QVERIFY(Homography::estimate(pairs).has_value());
    }
    void fiveOfWhichThreeAreInLineAreEnough()
    {
        QVERIFY(Homography::estimate(seen({{0, 0}, {1, 0}, {2, 0}, {0.5, 1.5}, {1.6, 1.2}})).has_value());
        // D and E in line with the first of those three
        QVERIFY(Homography::estimate(seen({{0, 0}, {1, 0}, {2, 0}, {0, 0.7}, {0, 1.5}})).has_value());
    }
    void refusesWhatDoesNotDetermineIt()
    {
        QVERIFY(refusedWith(seen({{0, 0}, {2, 0}, {0, 1.5}}), "four points are needed, 3 given"));
        QVERIFY(refusedWith({}, "0 given"));
        QVERIFY(refusedWith(seen({{0, 0}, {2, 0}, {0, 0}, {2, 1.5}}), "O and V have the same position"));
        QVERIFY(refusedWith(seen({{0, 0}, {1, 0}, {2, 0}, {2, 1.5}}), "O, U and V lie on one line"));
        QVERIFY(
            refusedWith(seen({{0, 0}, {1, 0.003}, {2, -0.004}, {1.5, 0.002}, {0.4, 0}}), "lie on one line"));
        // all but one in line
        QVERIFY(refusedWith(seen({{0, 0}, {1, 0}, {2, 0}, {1.5, 0}, {1, 1}}), "lie on one line"));
        std::vector<PointPair> pairs = square();
        pairs[1].target = pairs[2].target;
        QVERIFY(refusedWith(pairs, "U and V have the same position in the image"));
        pairs[1].target = 0.5 * (pairs[0].target + pairs[2].target);
        QVERIFY(refusedWith(pairs, "lie on one line in the image"));
        pairs = square();
        pairs[3].source.x() = std::nan("");
        QVERIFY(refusedWith(pairs, "a coordinate of D is not a finite number"));
    }
    void refusesABowTie()
    {
        std::vector<PointPair> pairs = square();
        std::swap(pairs[2].target, pairs[3].target);
        QVERIFY(refusedWith(pairs, "crosses over like a bow tie"));
    }
    void allOrdersOfFourPoints()
    {
        // Of the 24 orders of a convex quadrilateral 8 keep it convex (four turned, four mirrored); 16 cross
        // over.
        const std::vector<PointPair> right = square();
        std::array<std::size_t, 4> order{0, 1, 2, 3};
        int accepted = 0;
        do {
            std::vector<PointPair> pairs = right;
            for (std::size_t i = 0; i < 4; ++i)
                pairs[i].target = right[order[i]].target;
            accepted += Homography::estimate(pairs).has_value();
        } while (std::ranges::next_permutation(order).found);
        QCOMPARE(accepted, 8);
    }
    void nothingIsMappedAtOrBeyondTheHorizon()
    {
        const Homography homography = oblique(); // w = 0.05 x + 0.35 y + 1
        QVERIFY(homography.map({0, -2.8}).has_value());
        QVERIFY(!homography.map({0, -1 / 0.35}).has_value());
        QVERIFY(!homography.map({0, -2.9}).has_value());
    }
    void chainsKeepTheSideOfTheHorizon()
    {
        const auto estimated = Homography::estimate(square());
        const Homography loop = estimated->inverse() * *estimated;
        QVERIFY((*loop.map({0.3, 0.4}) - Vector2d(0.3, 0.4)).norm() < 1e-12);
        const Homography chain =
            *estimated * Homography(Eigen::Matrix3d(Eigen::Vector3d(2, 2, 1).asDiagonal()));
        QVERIFY((*chain.map({0.5, 0.25}) - *estimated->map({1, 0.5})).norm() < 1e-9);
    }
    void manyLinksGiveTheClosedForm()
    {
        // Shears and projective parts whose product is written down by hand: T(n) = T(1)^n for translations,
        // and a loop through three oblique views comes back to where it began.
        const Homography step(Eigen::Matrix3d{{1, 0, 0.25}, {0, 1, -0.5}, {0, 0, 1}});
        const auto far = Homography::chain(std::vector<Homography>(8, step));
        QVERIFY(far.has_value());
        QVERIFY((*far->map({1, 1}) - Vector2d(3, -3)).norm() < 1e-12);
        const Homography other(Eigen::Matrix3d{{300, -80, 640}, {10, 210, 300}, {-0.02, 0.3, 1.1}});
        const std::array links{oblique(), oblique().inverse(), other};
        const auto chained = Homography::chain(links);
        QVERIFY(chained.has_value());
        QVERIFY((*chained->map({0.7, 0.9}) - *other.map({0.7, 0.9})).norm() < 1e-9);
        QVERIFY(std::abs(chained->matrix().norm() - 1) < 1e-12);
    }
    void aSingularLinkIsNamed()
    {
        const Homography line(Eigen::Matrix3d{{1, 2, 0}, {2, 4, 0}, {0, 0, 1}});
        const auto chained = Homography::chain(std::array{oblique(), line, oblique()});
        QVERIFY(!chained.has_value());
        QVERIFY(chained.error().message().find("link 2 of 3 of the chain is singular") != std::string::npos);
        QVERIFY(!Homography::chain({}).has_value());
    }
};

ODOGRAPH_TEST(TestHomography, QCoreApplication)
#include "tst_homography.moc"
