// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/body_outline.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>
#include <numeric>
#include <random>

using namespace odo;

namespace {

constexpr double step = ReachCorrection::stepRad;
constexpr double lowestRad = -7 * step, highestRad = 7 * step;

Eigen::Vector3d directionAt(double azimuthRad, double upRad)
{
    return {std::cos(upRad) * std::cos(azimuthRad), std::cos(upRad) * std::sin(azimuthRad), std::sin(upRad)};
}

/// Some value for each node, in metres.
Eigen::VectorXd someValues()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-0.01, 0.01);
    Eigen::VectorXd values(ReachCorrection::nodes);
    for (double &one : values)
        one = value(random);
    return values;
}

int nodeAt(int azimuth, int row)
{
    return row * ReachCorrection::azimuths + azimuth;
}

} // namespace

class TestReachCorrection : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void withoutValuesNothingIsCorrected()
    {
        const ReachCorrection none;
        for (const Eigen::Vector3d &direction : {directionAt(0, 0), directionAt(2, 1), directionAt(-3, -1.5)})
            QCOMPARE(none.at(direction), 0.0);
    }

    void weightsOfAnyDirectionSumToOne()
    {
        std::mt19937 random(1);
        std::normal_distribution<double> part(0, 1);
        for (int i = 0; i < 1000; ++i) {
            const auto weights = ReachCorrection::weightsAt({part(random), part(random), part(random)});
            QVERIFY(std::abs(std::accumulate(weights.weight.begin(), weights.weight.end(), 0.0) - 1) < 1e-12);
            for (std::size_t k = 0; k < weights.node.size(); ++k)
                QVERIFY(weights.node[k] >= 0 && weights.node[k] < ReachCorrection::nodes &&
                        weights.weight[k] >= 0 && weights.weight[k] <= 1);
        }
    }

    void valuesComeBackAtTheNodes()
    {
        const Eigen::VectorXd values = someValues();
        const ReachCorrection correction(values);
        for (int node = 0; node < ReachCorrection::nodes; ++node) {
            const Eigen::Vector3d direction = ReachCorrection::directionOf(node);
            QVERIFY(std::abs(direction.norm() - 1) < 1e-12);
            QVERIFY2(std::abs(correction.at(direction) - values[node]) < 1e-12,
                     qPrintable(QString::number(node)));
            QVERIFY(std::abs(correction.at(0.3 * direction) - values[node]) < 1e-12); // of any length
        }
    }

    void directionsBeginAheadAndGoToTheLeft()
    {
        QVERIFY((ReachCorrection::directionOf(nodeAt(0, 7)) - Eigen::Vector3d::UnitX()).norm() < 1e-12);
        QVERIFY((ReachCorrection::directionOf(nodeAt(9, 7)) - Eigen::Vector3d::UnitY()).norm() < 1e-12);
        QVERIFY((ReachCorrection::directionOf(nodeAt(18, 7)) + Eigen::Vector3d::UnitX()).norm() < 1e-12);
        QVERIFY(ReachCorrection::directionOf(nodeAt(0, 14)).z() > 0.9 &&
                ReachCorrection::directionOf(nodeAt(0, 0)).z() < -0.9);
    }

    void betweenNodesItIsLinear()
    {
        const Eigen::VectorXd values = someValues();
        const ReachCorrection correction(values);
        for (const double share : {0.1, 0.5, 0.8}) {
            const double alongRow = correction.at(directionAt((4 + share) * step, 2 * step));
            QVERIFY(std::abs(alongRow - ((1 - share) * values[nodeAt(4, 9)] + share * values[nodeAt(5, 9)])) <
                    1e-12);
            const double upwards = correction.at(directionAt(4 * step, (2 + share) * step));
            QVERIFY(std::abs(upwards - ((1 - share) * values[nodeAt(4, 9)] + share * values[nodeAt(4, 10)])) <
                    1e-12);
        }
        const double middle = correction.at(directionAt(4.5 * step, 2.5 * step));
        QVERIFY(std::abs(middle - (values[nodeAt(4, 9)] + values[nodeAt(5, 9)] + values[nodeAt(4, 10)] +
                                   values[nodeAt(5, 10)]) /
                                      4) < 1e-12);
    }

    void beyondTheEndsItIsAsAtThem()
    {
        const ReachCorrection correction(someValues());
        for (const double azimuth : {0.0, 1.23, -2.5}) {
            for (const double beyond : {0.05, 0.3}) {
                QVERIFY(std::abs(correction.at(directionAt(azimuth, highestRad + beyond)) -
                                 correction.at(directionAt(azimuth, highestRad))) < 1e-12);
                QVERIFY(std::abs(correction.at(directionAt(azimuth, lowestRad - beyond)) -
                                 correction.at(directionAt(azimuth, lowestRad))) < 1e-12);
            }
        }
        QVERIFY(std::isfinite(correction.at(Eigen::Vector3d::UnitZ())) &&
                std::isfinite(correction.at(-Eigen::Vector3d::UnitZ())));
    }

    void theAzimuthWrapsRound()
    {
        const Eigen::VectorXd values = someValues();
        const ReachCorrection correction(values);
        // Halfway between the last node and the first, said in two ways.
        const double halfway = (values[nodeAt(35, 7)] + values[nodeAt(0, 7)]) / 2;
        QVERIFY(std::abs(correction.at(directionAt(-0.5 * step, 0)) - halfway) < 1e-12);
        QVERIFY(std::abs(correction.at(directionAt(35.5 * step, 0)) - halfway) < 1e-12);
        // And no step where the angle of a direction jumps, behind the robot, or a hair below zero.
        constexpr double hair = 1e-9;
        QVERIFY(std::abs(correction.at({-1, hair, 0}) - correction.at({-1, -hair, 0})) < 1e-9);
        QVERIFY(std::abs(correction.at({1, hair, 0}) - correction.at({1, -hair, 0})) < 1e-9);
        QVERIFY(std::abs(correction.at({1, -1e-300, 0}) - values[nodeAt(0, 7)]) < 1e-12);
    }
};

ODOGRAPH_TEST(TestReachCorrection, QCoreApplication)
#include "tst_reach_correction.moc"
