// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"
#include "tests/capture/played_camera.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTest>
#include <atomic>
#include <future>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

const Error taken = test::saidError(ErrorCode::NotFound, "camera play:", "it is not connected", "plug it in");

} // namespace

class TestAwaitedSource : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isThatCameraAsSoonAsItIsThere();
    void saysWhyItIsNotThere();
    void anAddressThatIsNotUnderstoodIsNotTriedAgain();
    void isStoppedWhileItWaits();
    void showsTheRobotsThatItWasGivenBefore();
};

void TestAwaitedSource::isThatCameraAsSoonAsItIsThere()
{
    const auto script = std::make_shared<Script>();
    script->frames(2);
    std::atomic<int> attempts = 0;
    const auto source = awaitCamera(
        "play:1", taken,
        [&]() -> Result<std::unique_ptr<CameraSource>> {
            if (++attempts < 3)
                return tl::unexpected(taken);
            return std::make_unique<PlayedCamera>(script,
                                                  PlayedCamera::Kind{.notHeld = {foreignWords("Focus")}});
        },
        1ms);
    QVERIFY(source->holdAutomatics().empty() || attempts == 3);
    Result<CapturedFrame> image = source->next();
    while (!image && image.error().code == ErrorCode::Unavailable)
        image = source->next();
    QVERIFY(image);
    QCOMPARE(attempts.load(), 3);
    QCOMPARE(source->next()->sequence, 1u);
    QCOMPARE(source->description().name.english(), std::string("Played"));
    QCOMPARE(test::english(source->holdAutomatics()), std::vector<std::string>{"Focus"});
}

void TestAwaitedSource::saysWhyItIsNotThere()
{
    const auto source = awaitCamera(
        "v4l2:/dev/video7", taken,
        []() -> Result<std::unique_ptr<CameraSource>> { return tl::unexpected(taken); }, 1ms);
    const auto image = source->next();
    QVERIFY(!image);
    QCOMPARE(image.error().code, ErrorCode::Unavailable); // it may come
    QCOMPARE(image.error().message(), taken.message());
    QCOMPARE(source->controls().error().code, ErrorCode::Unavailable);
    QCOMPARE(source->set("gain", 1).error().message(), taken.message());
    QCOMPARE(source->description().kind, std::string("v4l2"));
    QCOMPARE(source->description().widthPx, 0);
}

void TestAwaitedSource::anAddressThatIsNotUnderstoodIsNotTriedAgain()
{
    const Error wrong =
        test::saidError(ErrorCode::InvalidInput, "camera v4l2:x?y", "'y' is not valid", "leave it out");
    std::atomic<int> attempts = 0;
    const auto source = awaitCamera(
        "v4l2:x?y", wrong,
        [&]() -> Result<std::unique_ptr<CameraSource>> {
            ++attempts;
            return tl::unexpected(wrong);
        },
        1ms);
    QCOMPARE(source->next().error().code, ErrorCode::InvalidInput);
    QCOMPARE(source->next().error().message(), wrong.message());
    QCOMPARE(attempts.load(), 0);
}

void TestAwaitedSource::showsTheRobotsThatItWasGivenBefore()
{
    const auto script = std::make_shared<Script>();
    script->frames(1);
    std::promise<void> mayOpen;
    const auto source = awaitCamera(
        "play:1", taken,
        [script, may = mayOpen.get_future().share()]() -> Result<std::unique_ptr<CameraSource>> {
            may.wait();
            return std::make_unique<PlayedCamera>(script, PlayedCamera::Kind{});
        },
        1ms);
    source->showRobots(std::vector<RobotAppearance>(2));
    mayOpen.set_value();
    while (!source->next()) {
    }
    QCOMPARE(script->robotsToShow.load(), 2);
    source->showRobots(std::vector<RobotAppearance>(3));
    QCOMPARE(script->robotsToShow.load(), 3);
}

void TestAwaitedSource::isStoppedWhileItWaits()
{
    const auto source = awaitCamera(
        "play:1", taken, []() -> Result<std::unique_ptr<CameraSource>> { return tl::unexpected(taken); }, 1h);
    source->stop();
    QCOMPARE(source->next().error().code, ErrorCode::Cancelled);
}

ODOGRAPH_TEST(TestAwaitedSource, QCoreApplication)
#include "tst_awaited_source.moc"
