// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_detection.h"
#include "tests/calibration/images.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

using namespace odo;
using Eigen::Vector2d;

namespace {

constexpr int tagPx = 80; // 8 modules of the flat floor that is then warped

cv::Mat flatFloor(const std::vector<std::pair<int, cv::Point>> &tags)
{
    cv::Mat floor(700, 900, CV_8UC1, cv::Scalar(200));
    const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
    for (const auto &[id, corner] : tags) {
        cv::Mat tag;
        cv::aruco::drawMarker(dictionary, id, tagPx, tag, 1);
        floor(cv::Rect(corner.x - 12, corner.y - 12, tagPx + 24, tagPx + 24)) = 245;
        tag.copyTo(floor(cv::Rect(corner.x, corner.y, tagPx, tagPx)));
    }
    return floor;
}

const cv::Matx33d warp(1.1, -0.25, 180, 0.05, 0.75, 60, 1e-4, 9e-4, 1);

cv::Mat seen(const cv::Mat &floor)
{
    constexpr int fine = 4;
    const cv::Matx33d toFine(fine, 0, 0.5 * (fine - 1), 0, fine, 0.5 * (fine - 1), 0, 0, 1);
    cv::Mat large, image;
    cv::warpPerspective(floor, large, cv::Mat(toFine * warp), cv::Size(1280, 720) * fine, cv::INTER_LINEAR,
                        cv::BORDER_CONSTANT, cv::Scalar(120));
    cv::resize(large, image, {1280, 720}, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(image, image, {0, 0}, 0.7);
    return image;
}

MarkerLayout layout()
{
    return {"floor", {{"O", {0, 0}}, {"U", {2, 0}}, {"V", {0, 1}}, {"D", {2, 1}}, {"E", {1, 2}}}};
}

const std::vector<std::pair<int, cv::Point>> fiveTags = {
    {0, {60, 40}}, {1, {700, 60}}, {2, {80, 420}}, {3, {680, 500}}, {4, {400, 300}}};

} // namespace

class TestMarkerDetection : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void findsTheMiddleOfEachTag()
    {
        const auto markers = findMarkers(frameOf(seen(flatFloor(fiveTags))), layout());
        QVERIFY2(markers.has_value(), markers ? "" : markers.error().message().c_str());
        QCOMPARE(markers->size(), std::size_t(5));
        for (std::size_t i = 0; i < 5; ++i) {
            QCOMPARE((*markers)[i].label, layout().markers[i].label);
            const cv::Point corner = fiveTags[i].second;
            const cv::Vec3d point =
                warp * cv::Vec3d(corner.x + 0.5 * tagPx - 0.5, corner.y + 0.5 * tagPx - 0.5, 1);
            const Vector2d truth(point[0] / point[2], point[1] / point[2]);
            // Half a pixel from the wrong convention or the mean of the corners would show.
            QVERIFY2(((*markers)[i].pixel - truth).norm() < 0.12,
                     qPrintable(QString::number(((*markers)[i].pixel - truth).norm())));
        }
    }
    void fourAreEnoughAndOthersAreIgnored()
    {
        auto tags = fiveTags;
        tags[4].first = 77; // no marker of the layout
        const auto markers = findMarkers(frameOf(seen(flatFloor(tags))), layout());
        QVERIFY(markers.has_value());
        QCOMPARE(markers->size(), std::size_t(4));
    }
    void namesWhatIsMissing()
    {
        const auto markers = findMarkers(frameOf(seen(flatFloor({fiveTags[0], fiveTags[3]}))), layout());
        QVERIFY(!markers.has_value());
        QCOMPARE(markers.error().code, ErrorCode::Undetermined);
        QVERIFY2(markers.error().message().find("2 of 5 were found, four are needed; missing: U, V and E") !=
                     std::string::npos,
                 markers.error().message().c_str());
    }
    void refusesATagThatIsSeenTwice()
    {
        auto tags = fiveTags;
        tags[4].first = 2;
        const auto markers = findMarkers(frameOf(seen(flatFloor(tags))), layout());
        QVERIFY(!markers.has_value());
        QVERIFY2(markers.error().message().find("tag 2 (marker V) appears 2 times") != std::string::npos,
                 markers.error().message().c_str());
    }
    void findsNothingInAnEmptyPicture()
    {
        const auto markers = findMarkers(frameOf(cv::Mat(480, 640, CV_8UC1, cv::Scalar(100))), layout());
        QVERIFY(!markers.has_value());
        QVERIFY(markers.error().message().find("0 of 5") != std::string::npos);
    }
};

ODOGRAPH_TEST(TestMarkerDetection, QCoreApplication)
#include "tst_marker_detection.moc"
