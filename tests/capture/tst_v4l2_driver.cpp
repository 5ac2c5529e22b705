// SPDX-License-Identifier: GPL-3.0-or-later
// What a webcam's driver does that cannot be brought about in the emulated machine: a USB bus without room, a
// camera that takes fewer pictures in dim light.
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "tests/capture/played_driver.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds told = 1s * slowness;
const char *const noSpace = "its USB bus has no bandwidth left for its frames (the bus is full, not the "
                            "disk); plug it into a port whose bus no other camera uses";

std::unique_ptr<CaptureSession> sessionOf(const PlayedDriver &driver)
{
    auto source = openCamera(driver.uri());
    if (!source) {
        QTest::qFail(source.error().message().c_str(), __FILE__, __LINE__);
        return nullptr;
    }
    std::vector<std::unique_ptr<CameraSource>> sources;
    sources.push_back(std::move(*source));
    return std::make_unique<CaptureSession>(std::move(sources));
}

std::string wordsOf(const std::optional<RecordingWarning> &warning)
{
    return warning ? warning->error.message() : std::string();
}

} // namespace

class TestV4l2Driver : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aFullBusIsSaidWhenItIsOpened()
    {
        PlayedDriver driver;
        driver.streamOnFailure = ENOSPC;
        const auto refused = openCamera(driver.uri());
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Unavailable);
        QVERIFY2(refused.error().message().find(noSpace) != std::string::npos,
                 refused.error().message().c_str());
        driver.streamOnFailure = 0;
        QVERIFY(openCamera(driver.uri()));
    }

    /// Another camera has taken the room meanwhile; in the end it is given free.
    void aFullBusIsSaidWhenItComesBack()
    {
        PlayedDriver driver;
        const auto session = sessionOf(driver);
        QVERIFY(session);
        const auto health = [&] { return session->health().views[0]; };
        QTRY_VERIFY(health().delivered > 5);
        QTemporaryDir folder;
        session->startRecording({std::filesystem::path(folder.path().toStdString()) / "a.mkv"});
        const auto recorded = [&] { return session->health().disk.recordedS; };
        QTRY_VERIFY(recorded() > 0.1);
        driver.streamOnFailure = ENOSPC;
        driver.isUnplugged = true;
        QTRY_VERIFY(health().warning);
        driver.isUnplugged = false;
        const Nanoseconds back = steadyNow();
        QTRY_VERIFY(wordsOf(health().warning).find(noSpace) != std::string::npos);
        QVERIFY2(steadyNow() - back < told, qPrintable(QString::number(toSeconds(steadyNow() - back))));
        const std::uint64_t before = health().delivered;
        driver.streamOnFailure = 0;
        QTRY_VERIFY(health().delivered > before + 5);
        QTRY_VERIFY(!health().warning);
        const RecordingOutcome outcome = session->stopRecording();
        QCOMPARE(outcome.views[0].gaps.size(), std::size_t(1));
        QVERIFY(outcome.views[0].gaps[0].why.message().find(noSpace) != std::string::npos);
        QVERIFY(!outcome.views[0].problem);
    }

    /// As far as the kernel tells it. The other program has the node open, as one that streams has.
    void theProgramThatHasItIsNamed()
    {
        PlayedDriver driver;
        driver.streamOnFailure = EBUSY;
        const auto words = [&driver] {
            const auto refused = openCamera(driver.uri());
            return refused ? std::string() : refused.error().message();
        };
        const std::string unnamed = words();
        QVERIFY2(unnamed.ends_with("another program uses it; close that program"), unnamed.c_str());
        QProcess other;
        other.setStandardInputFile(QString::fromStdString(driver.node()));
        other.start(QStringLiteral("sleep"), {QStringLiteral("600")});
        QVERIFY(other.waitForStarted());
        const std::string named = words();
        other.kill();
        QVERIFY(other.waitForFinished());
        QVERIFY2(named.ends_with("another program uses it (open in sleep); close that program"),
                 named.c_str());
        QCOMPARE(words(), unnamed);
    }

    void aSlowCameraIsTold()
    {
        PlayedDriver driver;
        const auto session = sessionOf(driver);
        QVERIFY(session);
        const auto health = [&] { return session->health().views[0]; };
        QTRY_VERIFY(health().delivered > 60);
        QVERIFY(!health().slow);
        driver.framesPerSecond = 12; // its automatic exposure needs more light
        const Nanoseconds slowed = steadyNow();
        QTRY_VERIFY(health().slow);
        const Nanoseconds after = steadyNow() - slowed;
        // In 0.84 s of 12 the share of the two seconds' pictures falls below three quarters.
        QVERIFY2(after < 1200ms * slowness, qPrintable(QString::number(toSeconds(after))));
        QTRY_VERIFY(wordsOf(health().slow)
                        .find("it delivers only 12 frames per second instead of the requested 30; give it "
                              "more light") != std::string::npos);
        QTRY_VERIFY(health().state == ViewHealth::State::Delivering);
        QCOMPARE(health().lostOnWire, 0u);
        driver.framesPerSecond = 30;
        QTRY_VERIFY(!health().slow);
    }
};

ODOGRAPH_TEST(TestV4l2Driver, QCoreApplication)
#include "tst_v4l2_driver.moc"
