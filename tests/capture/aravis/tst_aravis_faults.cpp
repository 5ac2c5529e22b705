// SPDX-License-Identifier: GPL-3.0-or-later
// GigE cameras that are unplugged, freeze, are exchanged, come back, or belong to another program.
#include "core/capture/capture_session.h"
#include "tests/capture/aravis/frame_taker.h"
#include "tests/support/registered_test.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

// Half a second, and this machine stalls for some tenths of one now and then.
constexpr Nanoseconds told = 1s * slowness, toldOfRate = 1500ms * slowness;

/// A program that has crashed: it took a camera and does nothing more.
class CrashedProgram
{
public:
    explicit CrashedProgram(const char *address) : m_socket(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in name{};
        name.sin_family = AF_INET;
        name.sin_port = htons(3956);
        inet_pton(AF_INET, address, &name.sin_addr);
        // Write 2 (control) to the privilege's register.
        constexpr std::array<std::uint8_t, 16> take{0x42, 1, 0, 0x82, 0, 8, 0, 1, 0, 0, 0x0a, 0, 0, 0, 0, 2};
        sendto(m_socket, take.data(), take.size(), 0, reinterpret_cast<const sockaddr *>(&name), sizeof name);
    }
    ~CrashedProgram() { close(m_socket); }

private:
    int m_socket;
};

std::ptrdiff_t openFiles()
{
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"),
                         std::filesystem::directory_iterator());
}

} // namespace

class TestAravisFaults : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anUnpluggedCameraIsToldAndComesBackAsItWas();
    void aFrozenCameraIsToldAndGoesOn();
    void aCameraThatOnlyDoesNotAnswerIsLeftToStream();
    void whatComesWhileItIsNotTakenIsLostByUs();
    void anExchangedCameraIsRefused();
    void aSlowCameraIsNotGivenUp();
    void fewerPicturesThanAskedForAreTold();
    void aCameraBelongsToOneProgram();
    void aCrashedProgramsCameraIsFreeAfterAWhile();
    void aClockThatBeginsAnewIsNotSeen();
    void closingACameraThatIsGoneTakesNoTime();
    void openedAgainAndAgainNothingIsLeftBehind();
};

void TestAravisFaults::anUnpluggedCameraIsToldAndComesBackAsItWas()
{
    SimulatedGigeCamera::Settings settings{.address = "127.31.2.2", .serial = "LOST", .clockPpm = 50};
    auto camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
    SimulatedGigeCamera other({.address = "127.31.2.3", .serial = "OTHER"}, codedPainter());
    const auto source = opened("aravis:127.31.2.2?exposure_ms=4&rate=25"),
               otherSource = opened("aravis:127.31.2.3");
    QVERIFY(source && otherSource);
    FrameTaker taker(*source), otherTaker(*otherSource);
    QVERIFY(source->set("Gain", 7));
    QTRY_VERIFY(taker.count() > 30 && otherTaker.count() > 30);

    const Nanoseconds pulled = steadyNow();
    camera.reset();
    QTRY_VERIFY(taker.said("it does not answer; check its power and cable"));
    const Nanoseconds silent = *taker.said("it does not answer") - pulled;
    qInfo("unplugged: told after %.2f s", toSeconds(silent));
    QVERIFY2(silent < told, qPrintable(QString::number(toSeconds(silent))));
    QTRY_VERIFY(steadyNow() - pulled > 1500ms);

    const Nanoseconds plugged = steadyNow();
    settings.clockOffsetS = 3; // it has lost its power
    camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
    QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(plugged) > 30, 15000 * slowness);
    QVERIFY(source->counts().reconnections == 1);
    QCOMPARE(camera->readFloat(reg::Gain), 7.f);
    QCOMPARE(camera->readFloat(reg::ExposureTime), 4000.f);
    QCOMPARE(camera->readFloat(reg::FrameRate), 25.f);

    // The scale of time goes on: against the truth, over the gap, with a clock of 50 ppm.
    const auto frames = taker.frames();
    const auto &first = frames.front(), &last = frames.back();
    const double errorMs = 1e3 * toSeconds((last.time - first.time) - (last.code.begin - first.code.begin));
    QVERIFY2(std::abs(errorMs) < 2 * slowness, qPrintable(QString::number(errorMs)));
    for (std::size_t i = 1; i < frames.size(); ++i)
        QVERIFY(frames[i].time > frames[i - 1].time && frames[i].sequence > frames[i - 1].sequence);
    // What it would have taken meanwhile is a gap. A played camera that falls behind by a second leaves
    // pictures out.
    const double expected = toSeconds(last.code.begin - first.code.begin) * 25;
    QVERIFY2(slowness > 1 || std::abs(static_cast<double>(last.sequence - first.sequence) - expected) < 6,
             qPrintable(QString::number(expected)));

    // The other one has noticed nothing.
    const auto others = otherTaker.frames();
    const auto span = static_cast<double>(others.back().sequence - others.front().sequence + 1);
    QVERIFY2(static_cast<double>(others.size()) > 0.95 / slowness * span, qPrintable(QString::number(span)));
    QVERIFY(span > 0.9 / slowness * 30 * toSeconds(others.back().code.begin - others.front().code.begin));
    QCOMPARE(otherSource->counts().reconnections, 0u);
}

void TestAravisFaults::aFrozenCameraIsToldAndGoesOn()
{
    SimulatedGigeCamera camera({.address = "127.31.2.4"}, codedPainter());
    const auto source = opened("aravis:127.31.2.4");
    QVERIFY(source);
    FrameTaker taker(*source);
    QTRY_VERIFY(taker.count() > 10);
    const Nanoseconds frozen = steadyNow();
    camera.muteStream = true;
    QTRY_VERIFY(taker.said("it answers but sends no frames; check its trigger"));
    const Nanoseconds silent = *taker.said("it answers but sends no frames") - frozen;
    qInfo("frozen: told after %.2f s", toSeconds(silent));
    QVERIFY(silent < told);
    const Nanoseconds thawed = steadyNow();
    camera.muteStream = false;
    QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(thawed) > 10, 10000 * slowness);
}

/// Its control channel is silent: as long as pictures come, they are taken.
void TestAravisFaults::aCameraThatOnlyDoesNotAnswerIsLeftToStream()
{
    SimulatedGigeCamera camera({.address = "127.31.2.5"}, codedPainter());
    const auto source = opened("aravis:127.31.2.5");
    QVERIFY(source);
    FrameTaker taker(*source);
    QTRY_VERIFY(taker.count() > 10);
    camera.muteControl = true;
    const Nanoseconds silent = steadyNow();
    QTRY_VERIFY(taker.countSince(silent) > 45 / slowness);
    QVERIFY(slowness > 1 || taker.failures().empty());
    camera.muteControl = false;
    QCOMPARE(source->counts().reconnections, 0u);
}

/// Asked for something, it lets us wait for seconds and streams meanwhile: more than there are buffers for.
void TestAravisFaults::whatComesWhileItIsNotTakenIsLostByUs()
{
    SimulatedGigeCamera camera({.address = "127.31.2.13"}, codedPainter());
    const auto source = opened("aravis:127.31.2.13");
    QVERIFY(source);
    FrameTaker taker(*source);
    QTRY_VERIFY(taker.count() > 10);
    camera.muteControl = true;
    QCOMPARE(source->set("Gain", 3).error().code, ErrorCode::Unavailable);
    camera.muteControl = false;
    const Nanoseconds thawed = steadyNow();
    QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(thawed) > 10, 10000 * slowness);
    std::uint64_t gaps = 0, lostHere = 0;
    const auto frames = taker.frames();
    for (std::size_t i = 1; i < frames.size(); ++i) {
        gaps += frames[i].sequence - frames[i - 1].sequence - 1;
        lostHere += frames[i].lostHere;
    }
    // Two seconds of which 0.6 are buffered.
    QVERIFY2(lostHere > 20 && lostHere <= gaps,
             qPrintable(QStringLiteral("%1 of %2").arg(lostHere).arg(gaps)));
    QCOMPARE(source->counts().reconnections, 0u);
}

void TestAravisFaults::anExchangedCameraIsRefused()
{
    const SimulatedGigeCamera::Settings settings{.address = "127.31.2.6", .serial = "RIGHT"};
    SimulatedGigeCamera::Settings others = settings;
    others.serial = "WRONG";
    auto camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
    const auto source = opened("aravis:127.31.2.6");
    QVERIFY(source);
    FrameTaker taker(*source);
    QTRY_VERIFY(taker.count() > 10);
    camera.reset();
    const Nanoseconds exchanged = steadyNow();
    camera = std::make_unique<SimulatedGigeCamera>(others, codedPainter());
    QTRY_VERIFY_WITH_TIMEOUT(taker.said("another camera (WRONG) has replaced camera RIGHT; "),
                             15000 * slowness);
    QCOMPARE(taker.countSince(exchanged), std::size_t(0)); // none of the wrong one
    QVERIFY(!camera->isControlled());
    camera.reset();
    camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
    const Nanoseconds back = steadyNow();
    QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(back) > 5, 15000 * slowness);
}

void TestAravisFaults::aSlowCameraIsNotGivenUp()
{
    SimulatedGigeCamera camera({.address = "127.31.2.7", .framesPerSecond = 1}, codedPainter());
    const auto source = opened("aravis:127.31.2.7");
    QVERIFY(source);
    FrameTaker taker(*source);
    QTRY_VERIFY_WITH_TIMEOUT(taker.count() >= 3, 10000 * slowness);
    QVERIFY(taker.said("no frame arrived for half a second"));
    QVERIFY(!taker.said("does not answer") && !taker.said("sends no frames"));
    QCOMPARE(source->counts().reconnections, 0u);
    const auto frames = taker.frames();
    QCOMPARE(frames[2].sequence - frames[0].sequence, 2u);
}

/// It still says that it takes 30: what its exposure makes of that it does not tell.
void TestAravisFaults::fewerPicturesThanAskedForAreTold()
{
    SimulatedGigeCamera dim({.address = "127.31.2.14", .serial = "DIM"}, codedPainter()),
        bright({.address = "127.31.2.15", .serial = "BRIGHT"}, codedPainter());
    std::vector<std::unique_ptr<CameraSource>> sources;
    sources.push_back(opened("aravis:127.31.2.14"));
    sources.push_back(opened("aravis:127.31.2.15"));
    QVERIFY(sources[0] && sources[1]);
    CameraSource &camera = *sources[0];
    CaptureSession session(std::move(sources), {.preRoll = 0s});
    const auto views = [&] { return session.health().views; };
    QTRY_VERIFY(views()[0].delivered > 70 && views()[1].delivered > 70);
    QVERIFY(!views()[0].slow);
    QVERIFY(camera.set("ExposureTime", 83333)); // 12 a second
    const Nanoseconds slowed = steadyNow();
    QTRY_VERIFY(views()[0].slow);
    const Nanoseconds after = steadyNow() - slowed;
    qInfo("fewer pictures: told after %.2f s", toSeconds(after));
    QVERIFY2(after < toldOfRate, qPrintable(QString::number(toSeconds(after))));
    const auto slowWords = [&] {
        const auto slow = views()[0].slow;
        return slow ? slow->error.message() : std::string();
    };
    QTRY_VERIFY(slowWords().ends_with("it delivers only 12 frames per second instead of the requested 30; "
                                      "give it more light or a shorter exposure, or ask for a lower rate"));
    QTRY_VERIFY(!views()[0].warning && !views()[1].warning);
    QVERIFY(slowness > 1 || !views()[1].slow);
    QTRY_VERIFY(views()[0].state == ViewHealth::State::Delivering);
    QVERIFY(camera.set("ExposureTime", 5000));
    QTRY_VERIFY(!views()[0].slow);
}

void TestAravisFaults::aCameraBelongsToOneProgram()
{
    SimulatedGigeCamera camera({.address = "127.31.2.8"}, codedPainter());
    auto source = opened("aravis:127.31.2.8");
    QVERIFY(source);
    {
        FrameTaker taker(*source);
        QTRY_VERIFY(taker.count() > 10);
        const auto second = openCamera("aravis:127.31.2.8");
        QVERIFY(!second);
        QCOMPARE(second.error().code, ErrorCode::Unavailable);
        QVERIFY2(second.error().message().find("another program uses it; ") != std::string::npos,
                 second.error().message().c_str());
        const std::size_t before = taker.count();
        QTRY_VERIFY(taker.count() > before + 10);
        QVERIFY(slowness > 1 || taker.failures().empty());
    }
    source.reset();
    QTRY_VERIFY(!camera.isControlled());
    QVERIFY(openCamera("aravis:127.31.2.8"));
}

void TestAravisFaults::aCrashedProgramsCameraIsFreeAfterAWhile()
{
    SimulatedGigeCamera camera({.address = "127.31.2.9", .heartbeat = 700ms}, codedPainter());
    const CrashedProgram crashed("127.31.2.9");
    QTRY_VERIFY(camera.isControlled());
    const auto inUse = openCamera("aravis:127.31.2.9");
    QVERIFY(!inUse);
    QVERIFY2(inUse.error().message().find("another program uses it; ") != std::string::npos,
             inUse.error().message().c_str());
    QTRY_VERIFY(openCamera("aravis:127.31.2.9"));
}

void TestAravisFaults::aClockThatBeginsAnewIsNotSeen()
{
    SimulatedGigeCamera camera({.address = "127.31.2.10"}, codedPainter());
    const auto source = opened("aravis:127.31.2.10");
    QVERIFY(source);
    FrameTaker taker(*source);
    QTRY_VERIFY(taker.count() > 15);
    camera.resetClock();
    const Nanoseconds reset = steadyNow();
    QTRY_VERIFY(taker.countSince(reset) > 30);
    const auto frames = taker.frames();
    const auto &first = frames.front();
    for (std::size_t i = 1; i < frames.size(); ++i)
        QVERIFY(frames[i].time > frames[i - 1].time);
    std::vector<double> errorsMs;
    for (const auto &frame : frames)
        errorsMs.push_back(
            1e3 * std::abs(toSeconds((frame.time - first.time) - (frame.code.begin - first.code.begin))));
    std::ranges::sort(errorsMs);
    // It is read as soon as a stamp does not follow the one before.
    QVERIFY2(errorsMs[errorsMs.size() / 2] < 1, qPrintable(QString::number(errorsMs[errorsMs.size() / 2])));
}

void TestAravisFaults::closingACameraThatIsGoneTakesNoTime()
{
    auto camera = std::make_unique<SimulatedGigeCamera>(
        SimulatedGigeCamera::Settings{.address = "127.31.2.11"}, codedPainter());
    auto source = opened("aravis:127.31.2.11");
    QVERIFY(source);
    QVERIFY(source->next());
    camera.reset();
    while (source->next()) // what had come
        continue;
    Nanoseconds begin = steadyNow();
    QCOMPARE(source->set("Gain", 1).error().code, ErrorCode::Unavailable);
    QVERIFY(!source->controls());
    QVERIFY(toSeconds(steadyNow() - begin) < 6 * slowness);
    begin = steadyNow();
    source.reset();
    QVERIFY(toSeconds(steadyNow() - begin) < 1.5 * slowness);
}

void TestAravisFaults::openedAgainAndAgainNothingIsLeftBehind()
{
    SimulatedGigeCamera camera({.address = "127.31.2.12", .framesPerSecond = 100}, codedPainter());
    const auto once = [&] {
        auto source = opened("aravis:127.31.2.12");
        return source && QTest::qWaitFor([&] { return source->next().has_value(); }, 5000 * slowness);
    };
    QVERIFY(once());
    const auto files = openFiles();
    for (int i = 0; i < 10; ++i) {
        QTRY_VERIFY(!camera.isControlled());
        QVERIFY(once());
    }
    QTRY_VERIFY(openFiles() <= files);
}

ODOGRAPH_TEST(TestAravisFaults, QCoreApplication)
#include "tst_aravis_faults.moc"
