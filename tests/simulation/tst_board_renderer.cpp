// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

using namespace odo;

namespace {

CameraModel lens()
{
    Intrinsics intrinsics;
    intrinsics.widthPx = 1280;
    intrinsics.heightPx = 720;
    intrinsics.fxPx = 950;
    intrinsics.fyPx = 952;
    intrinsics.cxPx = 643;
    intrinsics.cyPx = 355;
    intrinsics.distortion = {-0.2, 0.06, 0.001, -0.0005, 0.0};
    return CameraModel::create(intrinsics).value();
}

RigidTransform pose(double tiltX, double tiltY, double spin, const Eigen::Vector3d &position)
{
    return {Eigen::AngleAxisd(spin, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(tiltX, Eigen::Vector3d::UnitX()) *
                Eigen::AngleAxisd(tiltY, Eigen::Vector3d::UnitY()),
            position};
}

cv::Mat lumaOf(const Frame &frame)
{
    cv::Mat luma(frame.y.height, frame.y.width, CV_8U);
    for (int y = 0; y < frame.y.height; ++y)
        std::copy_n(frame.y.row(y), frame.y.width, luma.ptr(y));
    return luma;
}

std::vector<RigidTransform> poses()
{
    return {pose(0, 0, 0, {-0.12, -0.08, 0.45}), pose(0.5, 0.1, 0.2, {-0.15, -0.05, 0.55}),
            pose(-0.3, -0.5, -0.1, {0.0, -0.1, 0.6}), pose(0.1, 0.4, 0.0, {-0.3, -0.12, 0.5})};
}

} // namespace

class TestBoardRenderer : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCheckerboardIsFoundWhereItIs()
    {
        const CameraModel camera = lens();
        for (const RigidTransform &cameraFromBoard : poses()) {
            SimulatedBoard board;
            board.cameraFromBoard = cameraFromBoard;
            const cv::Mat luma = lumaOf(renderBoard(camera, board, 1.0, 4));
            std::vector<cv::Point2f> corners;
            QVERIFY(cv::findChessboardCorners(luma, {board.columns, board.rows}, corners));
            cv::cornerSubPix(luma, corners, {8, 8}, {-1, -1},
                             {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 50, 1e-3});
            // OpenCV may begin at either end.
            const Eigen::Vector3d last((board.columns - 1) * board.squareM, (board.rows - 1) * board.squareM,
                                       0);
            const Eigen::Vector2d origin = *camera.project(cameraFromBoard * Eigen::Vector3d::Zero());
            const Eigen::Vector2d end = *camera.project(cameraFromBoard * last);
            const Eigen::Vector2d found(corners.front().x, corners.front().y);
            if ((found - end).norm() < (found - origin).norm())
                std::reverse(corners.begin(), corners.end());
            double squares = 0;
            Eigen::Vector2d sum = Eigen::Vector2d::Zero();
            for (int row = 0; row < board.rows; ++row) {
                for (int column = 0; column < board.columns; ++column) {
                    const Eigen::Vector3d corner(column * board.squareM, row * board.squareM, 0);
                    const Eigen::Vector2d truth = *camera.project(cameraFromBoard * corner);
                    const cv::Point2f &at = corners[static_cast<std::size_t>(row * board.columns + column)];
                    const Eigen::Vector2d error = Eigen::Vector2d(at.x, at.y) - truth;
                    squares += error.squaredNorm();
                    sum += error;
                    // cornerSubPix itself is off by so much on edges as sharp as these.
                    QVERIFY2(error.norm() < 0.15,
                             qPrintable(QStringLiteral("off by %1 px").arg(error.norm())));
                }
            }
            const double count = board.rows * board.columns;
            QVERIFY(std::sqrt(squares / count) < 0.1);
            QVERIFY(sum.norm() / count < 0.015); // no shift of the whole, such as half a pixel's confusion
        }
    }

    void aCharucoBoardIsFoundWhereItIs()
    {
        const CameraModel camera = lens();
        for (const RigidTransform &cameraFromBoard : poses()) {
            SimulatedBoard board;
            board.charuco = true;
            board.columns = 8;
            board.rows = 6;
            board.cameraFromBoard = cameraFromBoard;
            const cv::Mat luma = lumaOf(renderBoard(camera, board, 1.0, 5));
            const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_6X6_250);
            const auto layout = cv::aruco::CharucoBoard::create(9, 7, 0.025f, 0.025f * 0.5f, dictionary);
            std::vector<int> ids;
            std::vector<std::vector<cv::Point2f>> markers;
            cv::aruco::detectMarkers(luma, dictionary, markers, ids);
            QVERIFY(ids.size() >= 30); // of 31; its detector may miss one on a tilted board
            std::vector<cv::Point2f> corners;
            std::vector<int> cornerIds;
            cv::aruco::interpolateCornersCharuco(markers, ids, luma, layout, corners, cornerIds);
            QVERIFY(cornerIds.size() >= 44); // of 48
            double squares = 0;
            Eigen::Vector2d sum = Eigen::Vector2d::Zero();
            for (std::size_t i = 0; i < cornerIds.size(); ++i) {
                // OpenCV 4.6 counts its corners along the rows from the top left.
                const int column = cornerIds[i] % 8, row = cornerIds[i] / 8;
                const Eigen::Vector3d corner(column * board.squareM, row * board.squareM, 0);
                const Eigen::Vector2d truth = *camera.project(cameraFromBoard * corner);
                // Its interpolated corners count from the picture's corner, not from the first pixel's
                // centre.
                const Eigen::Vector2d seen(corners[i].x - 0.5, corners[i].y - 0.5);
                const double error = (seen - truth).norm();
                QVERIFY2(error < 0.6,
                         qPrintable(QStringLiteral("corner %1: %2 px").arg(cornerIds[i]).arg(error)));
                squares += error * error;
                sum += seen - truth;
            }
            // Its refinement within windows of a few pixels is coarse; the board as a whole must be in its
            // place.
            const double count = static_cast<double>(cornerIds.size());
            QVERIFY(std::sqrt(squares / count) < 0.2);
            QVERIFY(sum.norm() / count < 0.05);
        }
    }

    void aBoardOutOfSightIsNotPainted()
    {
        SimulatedBoard board;
        board.cameraFromBoard = pose(0, 0, 0, {0, 0, -1});
        const Frame frame = renderBoard(lens(), board, 0, 1);
        QCOMPARE(frame.y.at(0, 0), frame.y.at(640, 360));
    }
};

ODOGRAPH_TEST(TestBoardRenderer, QCoreApplication)
#include "tst_board_renderer.moc"
