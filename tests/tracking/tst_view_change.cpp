// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/view_change.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

using namespace odo;

namespace {

const cv::Size imageSize(640, 480);

/// Boxes of many sizes and shades, farther than the image reaches; as blurred as a camera would.
cv::Mat1b scene(int boxes, int seed = 5)
{
    cv::RNG random(seed);
    cv::Mat1b image(imageSize.height + 400, imageSize.width + 400, uchar(120));
    for (int i = 0; i < boxes; ++i) {
        const cv::Point at(random.uniform(0, image.cols), random.uniform(0, image.rows));
        const cv::Size size(random.uniform(8, 70), random.uniform(8, 70));
        cv::rectangle(image, cv::Rect(at, size), cv::Scalar(random.uniform(40, 210)), cv::FILLED);
    }
    cv::GaussianBlur(image, image, {}, 1);
    return image;
}

/// What a camera sees of it: shifted, zoomed and turned about the image's centre, with noise of its own.
cv::Mat1b seen(const cv::Mat1b &whole, cv::Point2d shiftPx = {}, double zoom = 1, double turnDeg = 0)
{
    const cv::Point2f centre(float(whole.cols) / 2, float(whole.rows) / 2);
    cv::Mat transform = cv::getRotationMatrix2D(centre, -turnDeg, zoom);
    transform.at<double>(0, 2) += shiftPx.x - (whole.cols - imageSize.width) / 2.0;
    transform.at<double>(1, 2) += shiftPx.y - (whole.rows - imageSize.height) / 2.0;
    cv::Mat1b image;
    cv::warpAffine(whole, image, transform, imageSize, cv::INTER_CUBIC);
    static cv::RNG random(9);
    cv::Mat1s noise(imageSize), sum;
    random.fill(noise, cv::RNG::NORMAL, 0, 2);
    cv::add(image, noise, sum, {}, CV_16S);
    sum.convertTo(image, CV_8U);
    return image;
}

PlaneView viewOf(const cv::Mat1b &image)
{
    return {image.data, image.cols, image.rows, std::ptrdiff_t(image.step)};
}

std::optional<ViewChange> change(const cv::Mat1b &before, const cv::Mat1b &now)
{
    return changeOfView(viewOf(before), viewOf(now));
}

} // namespace

class TestViewChange : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aPushIsMeasured_data()
    {
        QTest::addColumn<double>("shiftPx");
        QTest::addColumn<bool>("isShifted");
        QTest::newRow("none") << 0.0 << false;
        QTest::newRow("0.3 px") << 0.3 << false;
        QTest::newRow("1 px") << 1.0 << true;
        QTest::newRow("2.5 px") << 2.5 << true;
        QTest::newRow("25 px") << 25.0 << true;
    }
    void aPushIsMeasured()
    {
        QFETCH(double, shiftPx);
        QFETCH(bool, isShifted);
        const cv::Mat1b whole = scene(600);
        const auto found = change(seen(whole), seen(whole, {0.6 * shiftPx, 0.8 * shiftPx}));
        QVERIFY(found);
        QCOMPARE(int(found->kind), int(isShifted ? ViewChange::Kind::Shifted : ViewChange::Kind::Same));
        QVERIFY2(std::abs(found->shiftPx - shiftPx) < 0.15, qPrintable(QString::number(found->shiftPx)));
    }

    void anotherScaleOrDirectionIsAnotherView()
    {
        const cv::Mat1b whole = scene(600), before = seen(whole);
        const auto zoomed = change(before, seen(whole, {}, 1.2)),
                   turned = change(before, seen(whole, {}, 1, 90)),
                   panned = change(before, seen(whole, {120, 0}));
        cv::Mat1b image;
        cv::flip(before, image, 1);
        const auto mirrored = change(before, image);
        QVERIFY(zoomed && turned && panned && mirrored);
        QCOMPARE(int(zoomed->kind), int(ViewChange::Kind::Zoomed));
        QCOMPARE(int(turned->kind), int(ViewChange::Kind::Turned));
        QCOMPARE(int(panned->kind), int(ViewChange::Kind::Panned));
        QCOMPARE(int(mirrored->kind), int(ViewChange::Kind::Mirrored));
        QVERIFY(std::abs(zoomed->zoom - 1.2) < 0.002);
        QVERIFY(std::abs(turned->turnRad - std::numbers::pi / 2) < 0.002);
        QVERIFY(std::abs(panned->shiftPx - 120) < 0.2);
    }

    /// Half of what is there is new, and what is left is seen in other light.
    void whatStayedIsWhatCounts()
    {
        const cv::Mat1b whole = scene(600);
        cv::Mat1b other = whole.clone();
        scene(600, 8)(cv::Rect(0, 0, whole.cols / 2, whole.rows))
            .copyTo(other(cv::Rect(0, 0, whole.cols / 2, whole.rows)));
        cv::Mat1b dim;
        seen(other).convertTo(dim, -1, 0.6, 20);
        const auto still = change(seen(whole), dim);
        QVERIFY(still && still->kind == ViewChange::Kind::Same);
        const auto pushed = change(seen(whole), seen(other, {3, 0}));
        QVERIFY(pushed && pushed->kind == ViewChange::Kind::Shifted);
        QVERIFY(std::abs(pushed->shiftPx - 3) < 0.15);
    }

    /// A board that was pushed over a plain floor is no camera that was.
    void whatMovedByItselfIsNoMoveOfTheCamera()
    {
        cv::Mat1b floor(imageSize, uchar(120)), board = scene(600)(cv::Rect(0, 0, 250, 200));
        cv::Mat1b before = floor.clone(), now = floor.clone();
        board.copyTo(before(cv::Rect(150, 120, 250, 200)));
        for (const cv::Point &by : {cv::Point(4, 0), cv::Point(90, 40)}) {
            now = floor.clone();
            board.copyTo(now(cv::Rect(150 + by.x, 120 + by.y, 250, 200)));
            const auto found = change(before, now);
            QVERIFY(!found || found->kind == ViewChange::Kind::Same);
        }
    }

    /// Tiles look alike wherever the camera looks: nothing proves that it moved.
    void aPatternThatRepeatsIsNoMove()
    {
        cv::Mat1b tiles(imageSize.height + 400, imageSize.width + 400, uchar(90));
        for (int y = 0; y < tiles.rows; y += 40)
            for (int x = (y / 40 % 2) * 40; x < tiles.cols; x += 80)
                cv::rectangle(tiles, cv::Rect(x, y, 40, 40), cv::Scalar(170), cv::FILLED);
        cv::GaussianBlur(tiles, tiles, {}, 1);
        const auto found = change(seen(tiles), seen(tiles));
        QVERIFY(!found || found->kind == ViewChange::Kind::Same);
    }

    void tooLittleSaysNothing()
    {
        const cv::Mat1b whole = scene(600);
        QVERIFY(!change(seen(whole), seen(scene(600, 77))));
        QVERIFY(!change(seen(scene(0)), seen(scene(0), {5, 0})));
        QVERIFY(!change(seen(whole), cv::Mat1b(seen(whole), cv::Rect(0, 0, 600, 480))));
        QVERIFY(!changeOfView({}, {}));
        const cv::Mat1b line(1, 4000, uchar(9));
        QVERIFY(!change(line, line));
    }
};

ODOGRAPH_TEST(TestViewChange, QCoreApplication)
#include "tst_view_change.moc"
