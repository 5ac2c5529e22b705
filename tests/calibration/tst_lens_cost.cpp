// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/lens_cost.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <array>

using namespace odo;
using Eigen::Vector2d;

namespace {

/// Four corners, one of them far off its place, of a board before a camera.
BoardView view()
{
    return {"picture",
            2,
            2,
            {{700, 300}, {420, 250}, {900, 610}, {610, 330}},
            {{0, 0}, {0.3, 0.02}, {0.01, 0.25}, {0.31, 0.24}}};
}

template <LensModel model>
std::array<double, intrinsicsSize(model)> lens()
{
    std::array<double, intrinsicsSize(model)> values{850, 870, 630, 350};
    const std::array<double, 8> bent{-0.21, 0.08, 0.002, -0.003, 0.02, 0.05, -0.02, 0.01};
    std::copy_n(bent.begin(), values.size() - 4, values.begin() + 4);
    return values;
}

/// A print that is stretched, skew and bent.
BoardShape print()
{
    return {{0.15, 0.12}, 0.3, {0.02, -0.01, 0.03, -0.05, 0.04}};
}

constexpr std::array<double, BoardShape::size> plainPrint{};

template <LensModel model>
std::array<double, 8> residualsAt(const std::array<double, intrinsicsSize(model)> &lens,
                                  const std::array<double, 6> &pose, double cauchyPx,
                                  const std::array<double, BoardShape::size> &shape = plainPrint)
{
    const BoardView seen = view();
    const BoardShape board = print();
    std::array<double, 8> residuals{};
    const double *parameters[] = {lens.data(), pose.data(), shape.data()};
    ViewCost<model>(seen, board, cauchyPx).Evaluate(parameters, residuals.data(), nullptr);
    return residuals;
}

/// The largest difference between the stated derivatives and those by central differences, over the largest
/// derivative of a column.
template <LensModel model>
double worstDerivative(const std::array<double, 6> &pose, double cauchyPx)
{
    constexpr int size = intrinsicsSize(model), all = size + 6 + BoardShape::size;
    const auto values = lens<model>();
    const BoardView seen = view();
    const BoardShape board = print();
    Eigen::Matrix<double, 8, size, Eigen::RowMajor> byIntrinsics;
    Eigen::Matrix<double, 8, 6, Eigen::RowMajor> byPose;
    Eigen::Matrix<double, 8, BoardShape::size, Eigen::RowMajor> byShape;
    std::array<double, 8> residuals{};
    const double *parameters[] = {values.data(), pose.data(), board.values.data()};
    double *derivatives[] = {byIntrinsics.data(), byPose.data(), byShape.data()};
    ViewCost<model>(seen, board, cauchyPx).Evaluate(parameters, residuals.data(), derivatives);
    Eigen::Matrix<double, 8, all> stated;
    stated << byIntrinsics, byPose, byShape;
    double worst = 0;
    for (int column = 0; column < all; ++column) {
        const auto moved = [&](double by) {
            auto lens = values;
            auto turned = pose;
            auto shape = board.values;
            double &value = column < size       ? lens[std::size_t(column)]
                            : column < size + 6 ? turned[std::size_t(column - size)]
                                                : shape[std::size_t(column - size - 6)];
            value += by * std::max(1.0, std::abs(value));
            return residualsAt<model>(lens, turned, cauchyPx, shape);
        };
        const double at = column < size ? values[std::size_t(column)] : 0;
        const double step = 1e-6;
        const auto above = moved(step), below = moved(-step);
        Eigen::Matrix<double, 8, 1> measured;
        for (int row = 0; row < 8; ++row)
            measured(row) = (above[std::size_t(row)] - below[std::size_t(row)]) /
                            (2 * step * std::max(1.0, std::abs(at)));
        // Rounding makes 1e-7 px of nothing.
        worst = std::max(worst, (stated.col(column) - measured).cwiseAbs().maxCoeff() /
                                    std::max(0.1, measured.cwiseAbs().maxCoeff()));
    }
    return worst;
}

} // namespace

class TestLensCost : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void derivativesAreThoseOfTheResiduals_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<double>("cauchyPx");
        QTest::addColumn<bool>("turned");
        for (const bool turned : {true, false}) {
            for (const double cauchyPx : {0.0, 5.0}) {
                for (const LensModel model : {LensModel::Standard, LensModel::Rational, LensModel::Fisheye})
                    QTest::addRow("model %d, Cauchy %g, %s", int(model), cauchyPx,
                                  turned ? "turned" : "frontal")
                        << int(model) << cauchyPx << turned;
            }
        }
    }
    void derivativesAreThoseOfTheResiduals()
    {
        QFETCH(int, model);
        QFETCH(double, cauchyPx);
        QFETCH(bool, turned);
        const std::array<double, 6> pose = turned ? std::array{0.4, -0.5, 0.8, -0.1, -0.15, 0.9}
                                                  : std::array{0.0, 0.0, 0.0, -0.1, -0.15, 0.9};
        const double worst =
            model == int(LensModel::Standard)   ? worstDerivative<LensModel::Standard>(pose, cauchyPx)
            : model == int(LensModel::Rational) ? worstDerivative<LensModel::Rational>(pose, cauchyPx)
                                                : worstDerivative<LensModel::Fisheye>(pose, cauchyPx);
        // Central differences of double precision keep about half of the digits.
        QVERIFY2(worst < 1e-5, qPrintable(QString::number(worst)));
    }
    void foretellsAsTheCameraModelDoes()
    {
        const auto values = lens<LensModel::Standard>();
        const auto camera = CameraModel::create(
            {1280, 720, 850, 870, 630, 350, LensModel::Standard, {values.begin() + 4, values.end()}, {}});
        const auto residuals = residualsAt<LensModel::Standard>(values, {0, 0, 0, -0.1, -0.15, 0.9}, 0);
        for (std::size_t i = 0; i < 4; ++i) {
            const Vector2d point = view().pointsOnBoard[i];
            const Vector2d pixel = *camera->project({point.x() - 0.1, point.y() - 0.15, 0.9});
            QVERIFY((pixel - view().pixels[i] - Vector2d(residuals[2 * i], residuals[2 * i + 1])).norm() <
                    1e-9);
        }
    }
    void cauchysLossIsTheResidualsSquare()
    {
        const auto plain =
            residualsAt<LensModel::Standard>(lens<LensModel::Standard>(), {0, 0, 0, -0.1, -0.15, 0.9}, 0);
        const auto heeded =
            residualsAt<LensModel::Standard>(lens<LensModel::Standard>(), {0, 0, 0, -0.1, -0.15, 0.9}, 5);
        for (std::size_t i = 0; i < 8; i += 2) {
            const double squared = plain[i] * plain[i] + plain[i + 1] * plain[i + 1];
            QVERIFY(std::abs(heeded[i] * heeded[i] + heeded[i + 1] * heeded[i + 1] -
                             25 * std::log1p(squared / 25)) < 1e-9);
        }
    }
    void refusesABoardBehindTheCamera()
    {
        const BoardView seen = view();
        const auto values = lens<LensModel::Standard>();
        const std::array<double, 6> pose{0, 0, 0, 0, 0, -1};
        std::array<double, 8> residuals{};
        const BoardShape board = print();
        const double *parameters[] = {values.data(), pose.data(), plainPrint.data()};
        QVERIFY(
            !ViewCost<LensModel::Standard>(seen, board, 0).Evaluate(parameters, residuals.data(), nullptr));
    }
};

ODOGRAPH_TEST(TestLensCost, QCoreApplication)
#include "tst_lens_cost.moc"
