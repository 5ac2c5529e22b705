// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/opencv_tracking.h"

#include "core/video/video_reader.h"
#include "tests/benchmark/cpu_clock.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace odo::test {

namespace {

constexpr int channels[] = {0, 1};
constexpr int bins[] = {30, 32};
constexpr float hueRange[] = {0, 180}, saturationRange[] = {0, 256};
const float *ranges[] = {hueRange, saturationRange};

struct OpencvRobot
{
    cv::Mat histogram;
    cv::Rect window;
};

OpencvRobot learn(const cv::Mat &hsv, const Eigen::Vector2d &centre, const Eigen::Vector2d &halfSize)
{
    const cv::Point middle(cvRound(centre.x()), cvRound(centre.y()));
    const cv::Size half(cvRound(halfSize.x()), cvRound(halfSize.y()));
    cv::Mat mask = cv::Mat::zeros(hsv.size(), CV_8UC1);
    cv::ellipse(mask, middle, cv::Size(9 * half.width / 10, 9 * half.height / 10), 0, 0, 360, cv::Scalar(255),
                cv::FILLED);
    OpencvRobot robot;
    cv::calcHist(&hsv, 1, channels, mask, robot.histogram, 2, bins, ranges);
    cv::normalize(robot.histogram, robot.histogram, 0, 255, cv::NORM_MINMAX);
    robot.window = cv::Rect(middle.x - half.width, middle.y - half.height, 2 * half.width, 2 * half.height);
    return robot;
}

} // namespace

cv::Mat stackedPlanes(const Frame &frame)
{
    cv::Mat planes(frame.y.height * 3 / 2, frame.y.width, CV_8UC1);
    std::uint8_t *to = planes.data;
    for (const PlaneView &plane : {frame.y, frame.u, frame.v})
        for (int y = 0; y < plane.height; ++y, to += plane.width)
            std::copy_n(plane.row(y), plane.width, to);
    return planes;
}

OpencvTrackedClip trackByOpencv(const BenchmarkClip &clip, std::size_t robots)
{
    OpencvTrackedClip result;
    const auto reader = VideoReader::open(clip.file);
    if (!reader)
        return result;
    cv::setNumThreads(1);
    const cv::TermCriteria enough(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 10, 1);
    std::vector<OpencvRobot> followed;
    cv::Mat bgr, hsv, projection;
    for (;;) {
        const double begin = threadCpuS();
        const auto frame = (*reader)->next();
        if (!frame || !*frame)
            break;
        const double decoded = threadCpuS();
        const cv::Mat planes = stackedPlanes(**frame);
        const double planesReady = threadCpuS();
        cv::cvtColor(planes, bgr, cv::COLOR_YUV2BGR_I420);
        const double bgrReady = threadCpuS();
        cv::cvtColor(bgr, hsv, cv::COLOR_BGR2HSV);
        double after = workS(bgrReady, threadCpuS());
        if (followed.empty()) {
            for (std::size_t robot = 0; robot < robots; ++robot)
                followed.push_back(learn(hsv, clip.trueCentre(robot, 0), clip.trueHalfSize(robot, 0)));
        }
        auto &centres = result.tracked.centres.emplace_back();
        for (OpencvRobot &robot : followed) {
            const double robotBegin = threadCpuS();
            cv::calcBackProject(&hsv, 1, channels, robot.histogram, projection, ranges);
            const double projected = threadCpuS();
            const cv::RotatedRect found = cv::CamShift(projection, robot.window, enough);
            after += workS(robotBegin, projected) + workS(projected, threadCpuS());
            result.backProjectionS += workS(robotBegin, projected);
            centres.emplace_back(Eigen::Vector2d(found.center.x, found.center.y));
        }
        result.tracked.decodeS += workS(begin, decoded);
        result.tracked.afterS += after;
        result.toBgrS += workS(planesReady, bgrReady);
        ++result.tracked.frames;
    }
    return result;
}

} // namespace odo::test
