// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/similar_robots.h"

#include "tests/support/registered_test.h"

#include <QtTest>

using namespace odo;
using Eigen::Vector2d;

namespace {

/// A mask of some boxes.
RegionMask boxes(const ChromaRect &area, const std::vector<ChromaRect> &filled)
{
    RegionMask mask;
    mask.reset(area);
    for (const ChromaRect &box : filled) {
        for (int y = box.top; y < box.bottom; ++y)
            std::fill_n(mask.row(y) + (box.left - area.left), box.width(), std::uint8_t{1});
    }
    return mask;
}

} // namespace

class TestRegionSharing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachItsOwn();
    void theSumDecidesNotTheNearest();
    void oneRegionOfTwo();
    void hiddenWholly();
    void goneIsNotHidden();
    void noRegions();
    void silhouettesSideBySide();
    void silhouettesOneBehindTheOther();
};

void TestRegionSharing::eachItsOwn()
{
    const SharingProblem problem{{{0.2, 9}, {9, 0.1}}, {{0, 5}, {5, 0}}, {1000, 900}, {980, 910}};
    QCOMPARE(shareRegions(problem), (std::vector<int>{0, 1}));
}

void TestRegionSharing::theSumDecidesNotTheNearest()
{
    // The second region is the nearest to both; the first robot can do with the other one, the second cannot.
    const SharingProblem problem{{{1.0, 0.1}, {5.0, 0.5}}, {{5, 5}, {5, 5}}, {1000, 1000}, {1000, 1000}};
    QCOMPARE(shareRegions(problem), (std::vector<int>{0, 1}));
}

void TestRegionSharing::oneRegionOfTwo()
{
    // As large as both, centre between them.
    const SharingProblem problem{{{7}, {7}}, {{0}, {0}}, {1000, 900}, {1850}};
    QCOMPARE(shareRegions(problem), (std::vector<int>{0, 0}));
}

void TestRegionSharing::hiddenWholly()
{
    // As large as the front one alone; the other one should be within.
    const SharingProblem problem{{{0}, {3}}, {{0}, {0.5}}, {1000, 900}, {1020}};
    QCOMPARE(shareRegions(problem), (std::vector<int>{0, 0}));
}

void TestRegionSharing::goneIsNotHidden()
{
    // The only region is far from where the second robot should be.
    const SharingProblem problem{{{0}, {30}}, {{0}, {20}}, {1000, 900}, {1020}};
    QCOMPARE(shareRegions(problem), (std::vector<int>{0, -1}));
}

void TestRegionSharing::noRegions()
{
    const SharingProblem problem{{{}, {}}, {{}, {}}, {1000, 900}, {}};
    QCOMPARE(shareRegions(problem), (std::vector<int>{-1, -1}));
}

void TestRegionSharing::silhouettesSideBySide()
{
    // Two boxes of 30 × 20 that touch; predicted a few samples off.
    const RegionMask region = boxes({0, 0, 120, 60}, {{20, 20, 50, 40}, {50, 24, 80, 44}});
    const RegionMask one = boxes({0, 0, 38, 28}, {{4, 4, 34, 24}}), two = one;
    const auto centres =
        laySilhouettes(region, {{&one, {18.5, 13.5}, {38.5, 27.5}}, {&two, {18.5, 13.5}, {61.5, 36.5}}});
    // The truth is (34.5, 29.5) and (64.5, 33.5); the pull to the prediction holds back by a part of a
    // sample.
    QVERIFY((centres[0] - Vector2d(34.5, 29.5)).norm() < 1.5);
    QVERIFY((centres[1] - Vector2d(64.5, 33.5)).norm() < 1.5);
}

void TestRegionSharing::silhouettesOneBehindTheOther()
{
    // Nothing tells where the hind one is but that it is within: it stays where it was predicted.
    const RegionMask region = boxes({0, 0, 120, 60}, {{20, 20, 60, 50}});
    const RegionMask front = boxes({0, 0, 48, 38}, {{4, 4, 44, 34}}),
                     hind = boxes({0, 0, 28, 18}, {{4, 4, 24, 14}});
    const auto centres =
        laySilhouettes(region, {{&front, {23.5, 18.5}, {40.5, 35.5}}, {&hind, {13.5, 8.5}, {40.5, 30.5}}});
    QVERIFY((centres[0] - Vector2d(39.5, 34.5)).norm() < 1.5);
    QVERIFY((centres[1] - Vector2d(40.5, 30.5)).norm() < 1.5);
}

ODOGRAPH_TEST(TestRegionSharing, QCoreApplication)
#include "tst_region_sharing.moc"
