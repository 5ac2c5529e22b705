// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/lens_rounds.h"

#include "core/calibration/intrinsic_calibration.h"
#include "core/simulation/renderer.h"
#include "tests/benchmark/cpu_clock.h"
#include "tests/calibration/true_lens.h"

#include <numeric>
#include <opencv2/calib3d.hpp>
#include <random>

namespace odo::test {

namespace {

constexpr int widthPx = 1280, heightPx = 720, images = 60;
constexpr double noisePx = 0.1;

std::vector<BoardView> seenBoards()
{
    const CameraModel camera = trueCamera();
    const SimulatedBoard board;
    std::mt19937 random(17);
    std::normal_distribution<double> noise(0, noisePx);
    std::vector<BoardView> views;
    for (const RigidTransform &pose : heldBoardPoses(camera, board, images, 3)) {
        views.push_back({"picture" + std::to_string(views.size()), board.columns, board.rows, {}, {}});
        for (int i = 0; i < board.columns * board.rows; ++i) {
            const int row = i / board.columns;
            const Eigen::Vector2d point(board.squareM * (i % board.columns), board.squareM * row);
            const auto pixel = camera.project(pose * Eigen::Vector3d(point.x(), point.y(), 0));
            views.back().pixels.emplace_back(*pixel + Eigen::Vector2d(noise(random), noise(random)));
            views.back().pointsOnBoard.push_back(point);
        }
    }
    return views;
}

double rmsByOpenCv(const std::vector<BoardView> &views)
{
    std::vector<std::vector<cv::Point3f>> points;
    std::vector<std::vector<cv::Point2f>> pixels;
    for (const BoardView &view : views) {
        points.emplace_back();
        pixels.emplace_back();
        for (std::size_t i = 0; i < view.pixels.size(); ++i) {
            points.back().emplace_back(float(view.pointsOnBoard[i].x()), float(view.pointsOnBoard[i].y()),
                                       0.0F);
            pixels.back().emplace_back(float(view.pixels[i].x()), float(view.pixels[i].y()));
        }
    }
    cv::Mat matrix, distortion;
    std::vector<cv::Mat> rotations, translations;
    return cv::calibrateCamera(points, pixels, {widthPx, heightPx}, matrix, distortion, rotations,
                               translations);
}

template <class Work>
double timed(Work work)
{
    const double begin = threadCpuS();
    work();
    return 1e3 * workS(begin, threadCpuS());
}

QString milliseconds(double value)
{
    return QString::number(value, 'f', 0) + QStringLiteral(" ms");
}

} // namespace

std::vector<Measurement> measureCalibration(int rounds)
{
    cv::setNumThreads(1); // so that all of its work is on the thread that is clocked
    const std::vector<BoardView> views = seenBoards();
    std::vector<std::size_t> most(images - 5);
    std::iota(most.begin(), most.end(), std::size_t(0));
    std::vector<double> opencv, told, chosen, again;
    double theirs = 0;
    Result<IntrinsicCalibration> ours = tl::unexpected(Error{});
    for (int round = 0; round < rounds; ++round) {
        opencv.push_back(timed([&] { theirs = rmsByOpenCv(views); }));
        chosen.push_back(
            timed([&] { ours = calibrateIntrinsics(views, widthPx, heightPx, std::nullopt, {}); }));
        told.push_back(
            timed([&] { ours = calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, {}); }));
        if (!ours)
            return {};
        again.push_back(timed([&] { static_cast<void>(recalibrate(*ours, most, {})); }));
    }
    const double reference = median(opencv);
    const QString cvText = QStringLiteral("cv::calibrateCamera ") + milliseconds(reference);
    const auto faster = [&](const char *name, const std::vector<double> &times,
                            std::optional<double> demanded) {
        const double own = median(times);
        return Measurement{QString::fromLatin1(name),
                           reference / own,
                           demanded,
                           {},
                           {},
                           cvText + QStringLiteral(", here ") + milliseconds(own)};
    };
    return {faster("cv::calibrateCamera / calibration, 60 images, lens model given", told, 10),
            faster("cv::calibrateCamera / calibration, 60 images, lens model chosen", chosen, 5),
            faster("cv::calibrateCamera / calibrated again from 55 of them", again, {}),
            {QStringLiteral("RMS of the calibration less cv::calibrateCamera's"), ours->rmsPx - theirs, -1e-4,
             1e-4, QStringLiteral("px"), QStringLiteral("%1 px").arg(theirs, 0, 'f', 5)}};
}

} // namespace odo::test
