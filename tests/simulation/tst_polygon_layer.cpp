// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/polygon_layer.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;

namespace {

const Rgb white(1, 1, 1, 0);

RgbImage painted(const PixelRect &rect, const std::vector<std::vector<Eigen::Vector2d>> &polygons)
{
    RgbImage image(rect);
    for (int y = rect.y0; y < rect.y1; ++y)
        std::fill_n(image.row(y), rect.width(), Rgb::Zero());
    PolygonLayer layer(rect);
    for (const auto &polygon : polygons)
        layer.add(polygon, white);
    layer.paintOver(image);
    return image;
}

double coverageAt(const RgbImage &image, int x, int y)
{
    return static_cast<double>(image.row(y)[x - image.rect().x0][0]);
}

bool isInside(const std::vector<Eigen::Vector2d> &triangle, const Eigen::Vector2d &p)
{
    int sides = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d edge = triangle[(i + 1) % 3] - triangle[i], to = p - triangle[i];
        sides += edge.x() * to.y() - edge.y() * to.x() > 0 ? 1 : -1;
    }
    return std::abs(sides) == 3;
}

} // namespace

class TestPolygonLayer : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aPixelIsTheSquareAboutItsCentre()
    {
        const RgbImage image = painted({2, 3, 8, 9}, {{{3.75, 4.5}, {5.5, 4.5}, {5.5, 6.75}, {3.75, 6.75}}});
        QVERIFY(std::abs(coverageAt(image, 4, 5) - 0.75) < 1e-6);
        QVERIFY(std::abs(coverageAt(image, 5, 6) - 1.0) < 1e-6);
        QVERIFY(std::abs(coverageAt(image, 4, 7) - 0.75 * 0.25) < 1e-6);
        QVERIFY(std::abs(coverageAt(image, 3, 5)) < 1e-6);
        QVERIFY(std::abs(coverageAt(image, 6, 5)) < 1e-6);
    }

    void coversWhatManySamplesSay()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> position(-6, 26);
        for (int round = 0; round < 40; ++round) {
            std::vector<Eigen::Vector2d> triangle;
            for (int i = 0; i < 3; ++i)
                triangle.emplace_back(position(random), position(random)); // often partly outside
            const RgbImage image = painted({0, 0, 20, 20}, {triangle});
            for (int y = 0; y < 20; ++y) {
                for (int x = 0; x < 20; ++x) {
                    constexpr int n = 24;
                    int hits = 0;
                    for (int j = 0; j < n; ++j)
                        for (int i = 0; i < n; ++i)
                            hits += isInside(triangle, {x - 0.5 + (i + 0.5) / n, y - 0.5 + (j + 0.5) / n});
                    // n² samples miss a straight edge's area by less than about 1/n.
                    QVERIFY(std::abs(coverageAt(image, x, y) - static_cast<double>(hits) / (n * n)) <
                            1.0 / n);
                }
            }
        }
    }

    void areaAndCentroidAreExact()
    {
        const std::vector<Eigen::Vector2d> triangle = {{3.13, 2.71}, {17.4, 5.55}, {8.08, 16.9}};
        const RgbImage image = painted({0, 0, 20, 20}, {triangle});
        double area = 0;
        Eigen::Vector2d moment = Eigen::Vector2d::Zero();
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 20; ++x) {
                area += coverageAt(image, x, y);
                moment += coverageAt(image, x, y) * Eigen::Vector2d(x, y);
            }
        }
        const Eigen::Vector2d a = triangle[1] - triangle[0], b = triangle[2] - triangle[0];
        QVERIFY(std::abs(area - 0.5 * (a.x() * b.y() - a.y() * b.x())) < 1e-3);
        // A pixel's share is not at its centre: less than 0.005 px for this size.
        QVERIFY((moment / area - (triangle[0] + triangle[1] + triangle[2]) / 3).norm() < 0.005);
    }

    void neighboursLeaveNoSeam()
    {
        const Eigen::Vector2d middle(9.3, 8.7);
        const Eigen::Vector2d corners[] = {{-0.5, -0.5}, {19.5, -0.5}, {19.5, 19.5}, {-0.5, 19.5}};
        std::vector<std::vector<Eigen::Vector2d>> fans;
        for (int i = 0; i < 4; ++i)
            fans.push_back({middle, corners[i], corners[(i + 1) % 4]});
        std::reverse(fans[1].begin(), fans[1].end()); // the orientation does not matter
        const RgbImage image = painted({0, 0, 20, 20}, fans);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                QVERIFY(std::abs(coverageAt(image, x, y) - 1.0) < 1e-5);
    }
};

ODOGRAPH_TEST(TestPolygonLayer, QCoreApplication)
#include "tst_polygon_layer.moc"
