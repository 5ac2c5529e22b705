// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_disagreement.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <random>

using namespace odo;

namespace {

constexpr double sigmaM = 0.001;
constexpr std::size_t times = 300;

/// A view's sightings at 30 a second of a robot that drives straight on, with its noise, and beside the truth
/// by as much.
std::vector<Sighting> viewBeside(const Eigen::Vector2d &besideM, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, sigmaM / std::sqrt(2.0));
    std::vector<Sighting> sightings(times);
    for (std::size_t i = 0; i < times; ++i) {
        sightings[i].time = Nanoseconds(std::int64_t(i) * 33'333'333);
        sightings[i].seen = true;
        sightings[i].position.pointInWorld =
            Eigen::Vector2d(0.01 * double(i), 0) + besideM + Eigen::Vector2d(noise(random), noise(random));
        sightings[i].position.pixelCovariance = sightings[i].position.calibrationCovariance =
            Eigen::Matrix2d::Identity() * sigmaM * sigmaM / 2;
    }
    return sightings;
}

double sigmaOf(const Sighting &sighting)
{
    return std::sqrt((sighting.position.pixelCovariance + sighting.position.calibrationCovariance).trace() /
                     2);
}

bool isContradicted(double apartM)
{
    return apartM > 0;
}

bool any(const std::vector<double> &apartM)
{
    return std::ranges::any_of(apartM, isContradicted);
}

} // namespace

class TestContradiction : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void viewsThatAgreeStayAsTheyAre()
    {
        for (unsigned seed = 1; seed <= 50; ++seed) {
            std::vector<std::vector<Sighting>> views{viewBeside({0, 0}, 2 * seed),
                                                     viewBeside({0, 0}, 2 * seed + 1)};
            QVERIFY(!any(settleContradictions(views)));
            QCOMPARE(sigmaOf(views[0][7]), sigmaM);
        }
    }

    /// 20 mm apart at a stated 1 mm each, known of one draw: 95 % must hold 1.5 times as much on either axis.
    void aMovedCameraWidensBoth()
    {
        std::vector<std::vector<Sighting>> views{viewBeside({0.02, 0}, 1), viewBeside({0, 0}, 2)};
        const std::vector<double> apartM = settleContradictions(views);
        QVERIFY(std::ranges::all_of(apartM, [](double one) { return std::abs(one - 0.02) < 0.006; }));
        const FusedPosition fused =
            fuse(std::vector<ViewPosition>{{0, views[0][100].position}, {1, views[1][100].position}});
        const double sigma = std::sqrt((fused.covariance + fused.commonCovariance).trace() / 2);
        // 20 mm / 2 / √2 · 4.30 / 1.96
        QVERIFY2(std::abs(sigma - 0.0155) < 0.001, qPrintable(QString::number(sigma)));
        QVERIFY(std::abs(fused.position.x() - 1 - 0.01) < 0.002);
        // from frame to frame it is as well known as before
        QVERIFY(fused.covariance.trace() < sigmaM * sigmaM);
    }

    void fromTheMomentOnOnWhichItIsMoved()
    {
        std::vector<std::vector<Sighting>> views{viewBeside({0, 0}, 1), viewBeside({0, 0}, 2)};
        for (std::size_t i = 150; i < times; ++i)
            views[0][i].position.pointInWorld.y() += 0.03;
        const std::vector<double> apartM = settleContradictions(views);
        for (std::size_t i = 0; i < times; ++i)
            QVERIFY(i < 148 ? !isContradicted(apartM[i]) : i < 153 || isContradicted(apartM[i]));
    }

    void ofThreeViewsTheOddOneIsLeftOut()
    {
        std::vector<std::vector<Sighting>> views{viewBeside({0, 0}, 1), viewBeside({0, 0.02}, 2),
                                                 viewBeside({0, 0}, 3)};
        QVERIFY(any(settleContradictions(views)));
        for (const std::size_t v : {std::size_t(0), std::size_t(2)}) {
            QCOMPARE(sigmaOf(views[v][100]), sigmaM);
            QVERIFY(views[v][100].seen);
        }
        QVERIFY(!views[1][100].seen);
    }

    void ofThreeThatAllContradictAllAreWidened()
    {
        std::vector<std::vector<Sighting>> views{viewBeside({0, 0}, 1), viewBeside({0, 0.02}, 2),
                                                 viewBeside({0.02, 0}, 3)};
        QVERIFY(any(settleContradictions(views)));
        for (const auto &view : views)
            QVERIFY(view[100].seen && sigmaOf(view[100]) > 0.008);
    }

    /// Half a second is a false sighting, and half a metre something else: neither is a camera that was
    /// moved.
    void falseSightingsAreNone()
    {
        std::vector<std::vector<Sighting>> glance{viewBeside({0, 0}, 1), viewBeside({0, 0}, 2)},
            apart{viewBeside({0.5, 0}, 1), viewBeside({0, 0}, 2)};
        for (std::size_t i = 100; i < 115; ++i)
            glance[0][i].position.pointInWorld.y() += 0.1;
        QVERIFY(!any(settleContradictions(glance)));
        QVERIFY(!any(settleContradictions(apart)));
        std::vector<std::vector<Sighting>> none, alone{viewBeside({0, 0}, 1)};
        QVERIFY(settleContradictions(none).empty());
        QVERIFY(!any(settleContradictions(alone)));
    }

    void whereNothingIsLeftItIsWhy()
    {
        std::vector<Sample> samples(100);
        QVERIFY(checkAgreement(samples));
        for (Sample &sample : samples) {
            sample.position = Eigen::Vector2d(0, 0);
            sample.viewDisagreementM = 0.208;
            sample.flags = flagBit(SampleFlag::ViewsDisagree) | flagBit(SampleFlag::Jump);
        }
        const auto refused = checkAgreement(samples);
        QVERIFY(!refused);
        QCOMPARE(
            QString::fromStdString(refused.error().why.english()),
            QStringLiteral(
                "the views' floor positions differ by 208 mm: a camera has moved since it was registered, "
                "the videos belong to other cameras, or one view follows something else"));
        for (std::size_t i = 0; i < 20; ++i)
            samples[i].flags = 0;
        QVERIFY(checkAgreement(samples));
    }
};

ODOGRAPH_TEST(TestContradiction, QCoreApplication)
#include "tst_contradiction.moc"
