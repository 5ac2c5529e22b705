// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of simulated GigE cameras as they come through Aravis: what is in them, what is missing, how the
// camera is set.
#include "core/capture/aravis/internal/gvcp.h"
#include "tests/capture/aravis/frame_taker.h"
#include "tests/support/offered_formats.h"
#include "tests/support/registered_test.h"

#include <algorithm>

using namespace odo;
using namespace odo::test;

namespace {

constexpr RgbColour orange{220, 120, 40};

/// So many pictures; fewer when none comes for seconds. This machine stalls for longer than a camera may be
/// silent.
std::vector<CapturedFrame> take(CameraSource &source, std::size_t count)
{
    std::vector<CapturedFrame> frames;
    for (int silences = 0; frames.size() < count && silences < 10 * slowness;) {
        auto frame = source.next();
        if (frame)
            frames.push_back(std::move(*frame));
        else
            ++silences;
    }
    return frames;
}

std::uint64_t gapsIn(const std::vector<CapturedFrame> &frames)
{
    return frames.back().sequence - frames.front().sequence + 1 - frames.size();
}

} // namespace

class TestAravisStreaming : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void picturesAreWhatTheCameraSaw_data();
    void picturesAreWhatTheCameraSaw();
    void numbersWrap();
    void picturesThatWereNeverSentAreGaps();
    void lostPacketsAreAskedForAgain();
    void withoutResendingPicturesAreLostAndCounted();
    void shortPicturesAreRefusedAndSaidSo();
    void whatIsWantedIsSetAndReadBack();
    void whatTheCameraCannotDoIsSaid_data();
    void whatTheCameraCannotDoIsSaid();
    void triggeredCamerasSeeTheSameMoments();
    void camerasAreFound();
    void nobodyAtAnAddressIsSaidAtOnce();
};

void TestAravisStreaming::picturesAreWhatTheCameraSaw_data()
{
    QTest::addColumn<std::uint32_t>("format");
    QTest::newRow("Mono8") << pixel::mono8;
    QTest::newRow("BayerRG8") << pixel::bayerRg8;
    QTest::newRow("BayerGB8") << pixel::bayerGb8;
    QTest::newRow("RGB8") << pixel::rgb8;
    QTest::newRow("BGR8") << pixel::bgr8;
}

void TestAravisStreaming::picturesAreWhatTheCameraSaw()
{
    QFETCH(std::uint32_t, format);
    const QByteArray name = QTest::currentDataTag();
    SimulatedGigeCamera camera({.address = "127.31.1.2", .ticksPerSecond = 125'000'000},
                               codedPainter(orange));
    const auto source = opened("aravis:127.31.1.2?format=" + name.toStdString());
    QVERIFY(source);
    QCOMPARE(camera.read(reg::PixelFormat), format);
    const std::vector<CapturedFrame> frames = take(*source, 30);
    QCOMPARE(frames.size(), std::size_t(30));
    // On a machine that stalls a picture may be lost, which is told; what comes is right.
    QVERIFY(gapsIn(frames) <= 6 * slowness);
    QCOMPARE(source->counts().reconnections, 0u);
    const FrameCode first = readCode(frames.front().frame);
    for (const CapturedFrame &captured : frames) {
        const Frame &frame = captured.frame;
        QCOMPARE(frame.format.width, 640);
        QCOMPARE(frame.format.height, 480);
        const FrameCode code = readCode(frame);
        QCOMPARE(std::uint64_t(code.id - first.id), captured.sequence - frames.front().sequence);
        QCOMPARE(frame.index, std::int64_t(captured.sequence));
        // Ticks of 8 ns, of both pictures.
        QVERIFY(std::chrono::abs(frame.time - (code.begin - first.begin)) <= Nanoseconds(20));
        QVERIFY(captured.hostTime >= code.begin);
        // Full-range BT.601; a level of rounding.
        const double luma = 0.299 * orange.red + 0.587 * orange.green + 0.114 * orange.blue;
        const bool colours = format != pixel::mono8;
        QVERIFY(std::abs(frame.y.at(320, 240) - luma) <= 1);
        QVERIFY(std::abs(frame.u.at(160, 120) - (colours ? 128 + (orange.blue - luma) / 1.772 : 128)) <= 1);
        QVERIFY(std::abs(frame.v.at(160, 120) - (colours ? 128 + (orange.red - luma) / 1.402 : 128)) <= 1);
    }
}

void TestAravisStreaming::numbersWrap()
{
    SimulatedGigeCamera camera({.address = "127.31.1.3", .framesPerSecond = 60, .firstId = 65520},
                               codedPainter());
    const auto source = opened("aravis:127.31.1.3");
    QVERIFY(source);
    const auto frames = take(*source, 40);
    QCOMPARE(frames.size(), std::size_t(40));
    QVERIFY(readCode(frames.back().frame).id < 100);
    QVERIFY(gapsIn(frames) <= 8 * slowness); // that of the wrap would be 65535
}

void TestAravisStreaming::picturesThatWereNeverSentAreGaps()
{
    SimulatedGigeCamera camera({.address = "127.31.1.4", .framesPerSecond = 60}, codedPainter());
    const auto source = opened("aravis:127.31.1.4");
    QVERIFY(source);
    const auto before = take(*source, 10);
    camera.skipIds = 3;
    std::uint64_t taken = before.size(), gaps = 0;
    while (gaps < 3 && taken < 300) { // those that were sent before are still on their way
        const auto after = take(*source, 10);
        QCOMPARE(after.size(), std::size_t(10));
        taken += after.size();
        gaps = after.back().sequence - before.front().sequence + 1 - taken;
    }
    QVERIFY2(gaps >= 3 && gaps <= 11 * slowness, qPrintable(QString::number(gaps)));
}

void TestAravisStreaming::lostPacketsAreAskedForAgain()
{
    SimulatedGigeCamera camera({.address = "127.31.1.5"}, codedPainter());
    const auto source = opened("aravis:127.31.1.5?packet_size=1400");
    QVERIFY(source);
    QCOMPARE(camera.read(reg::PacketSize), 1400u);
    take(*source, 2);
    camera.loss = 0.01; // of 230 packets a picture: two of three pictures lack some
    const auto frames = take(*source, 45);
    QCOMPARE(frames.size(), std::size_t(45));
    QVERIFY(gapsIn(frames) <= 8 * slowness); // without it, two of three
    QVERIFY(source->counts().resent > 20);
    QVERIFY(camera.resent > 20);
}

void TestAravisStreaming::withoutResendingPicturesAreLostAndCounted()
{
    SimulatedGigeCamera camera({.address = "127.31.1.6", .answersResends = false}, codedPainter());
    const auto source = opened("aravis:127.31.1.6?packet_size=1400");
    QVERIFY(source);
    take(*source, 2);
    camera.loss = 0.003; // half of the pictures
    const auto frames = take(*source, 20);
    QCOMPARE(frames.size(), std::size_t(20));
    QVERIFY(gapsIn(frames) >= 3);
    QVERIFY(source->counts().damaged >= 3);
    for (const CapturedFrame &frame : frames)
        QVERIFY(readCode(frame.frame).begin.count() > 0); // those that come are whole
}

void TestAravisStreaming::shortPicturesAreRefusedAndSaidSo()
{
    SimulatedGigeCamera camera({.address = "127.31.1.7"}, codedPainter());
    const auto source = opened("aravis:127.31.1.7");
    QVERIFY(source);
    QVERIFY(source->next());
    camera.cutRows = 40;
    Result<CapturedFrame> frame = source->next();
    for (int i = 0; i < 100 && (frame || frame.error().why.english().find("incomplete") == std::string::npos);
         ++i) {
        QVERIFY(!frame || frame->frame.format.height == 480);
        frame = source->next();
    }
    QVERIFY(!frame);
    QCOMPARE(frame.error().code, ErrorCode::Unavailable);
    QVERIFY2(frame.error().message().find("its frames arrive incomplete; ") != std::string::npos,
             frame.error().message().c_str());
    QVERIFY(source->counts().damaged >= 5);
    camera.cutRows = 0;
    QTRY_VERIFY(source->next());
}

void TestAravisStreaming::whatIsWantedIsSetAndReadBack()
{
    SimulatedGigeCamera camera({.address = "127.31.1.8", .sensorWidth = 1280, .sensorHeight = 960},
                               codedPainter());
    const auto source = opened(
        "aravis:127.31.1.8?size=640x480&rate=50&exposure_ms=3&gain=6&packet_size=8000&packet_delay_us=2");
    QVERIFY(source);
    QCOMPARE(camera.read(reg::Width), 640u);
    QCOMPARE(camera.read(reg::OffsetX), 320u); // the middle of the sensor
    QCOMPARE(camera.read(reg::OffsetY), 240u);
    QCOMPARE(camera.readFloat(reg::ExposureTime), 3000.f);
    QCOMPARE(camera.readFloat(reg::FrameRate), 50.f);
    QCOMPARE(camera.readFloat(reg::Gain), 6.f);
    QCOMPARE(camera.read(reg::PacketSize), 8000u);
    QCOMPARE(camera.read(reg::PacketDelay), 2000u);
    QCOMPARE(camera.read(reg::PixelFormat), pixel::bayerRg8); // best for tracking
    const CameraDescription &description = source->description();
    QCOMPARE(description.widthPx, 640);
    QCOMPARE(description.heightPx, 480);
    QCOMPARE(description.framesPerSecond, 50.0);
    QCOMPARE(description.kind, std::string("aravis"));
    QCOMPARE(description.name.english(), std::string("Odograph Simulated"));
    QCOMPARE(description.serial, std::string("SIM1"));
    QCOMPARE(test::offeredFormats(description), std::vector<std::string>{"BayerRG8 640×480 at 50 frames/s"});
    const auto frames = take(*source, 5);
    QCOMPARE(frames.size(), std::size_t(5));
    QCOMPARE(frames.front().frame.format.width, 640);
}

void TestAravisStreaming::whatTheCameraCannotDoIsSaid_data()
{
    QTest::addColumn<QByteArray>("query");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("size") << QByteArray("size=9999x9999")
                          << QByteArray("its frames have at most 640x480 pixels; ");
    QTest::newRow("odd size") << QByteArray("size=8x8") << QByteArray("it rejects this size (");
    QTest::newRow("format") << QByteArray("format=Bayer17") << QByteArray("it has no format Bayer17 (");
    QTest::newRow("exposure") << QByteArray("exposure_ms=0.0005") << QByteArray("it rejects this exposure (");
    QTest::newRow("gain") << QByteArray("gain=90") << QByteArray("it rejects this gain (");
}

void TestAravisStreaming::whatTheCameraCannotDoIsSaid()
{
    QFETCH(QByteArray, query);
    QFETCH(QByteArray, words);
    SimulatedGigeCamera camera({.address = "127.31.1.9"}, codedPainter());
    const auto source = openCamera("aravis:127.31.1.9?" + query.toStdString());
    QVERIFY(!source);
    QCOMPARE(source.error().code, ErrorCode::InvalidInput);
    QVERIFY2(source.error().message().find(words.toStdString()) != std::string::npos,
             source.error().message().c_str());
    QCOMPARE(camera.readFloat(reg::ExposureTime), 5000.f);
    QTRY_VERIFY(!camera.isControlled()); // others may have it
}

/// Each is fired by itself, on one grid of time.
void TestAravisStreaming::triggeredCamerasSeeTheSameMoments()
{
    SimulatedGigeCamera a({.address = "127.31.1.10", .serial = "A"}, codedPainter()),
        b({.address = "127.31.1.11", .serial = "B"}, codedPainter());
    const auto first = opened("aravis:127.31.1.10?trigger=software&rate=25"),
               second = opened("aravis:127.31.1.11?trigger=software&rate=25");
    QVERIFY(first && second);
    QCOMPARE(first->description().framesPerSecond, 25.0);
    std::vector<double> apartMs;
    std::vector<CapturedFrame> framesOfA, framesOfB;
    for (int i = 0; i < 30; ++i) {
        std::ranges::move(take(*first, 1), std::back_inserter(framesOfA));
        std::ranges::move(take(*second, 1), std::back_inserter(framesOfB));
    }
    for (const CapturedFrame &frame : framesOfA) {
        double nearest = 1e9;
        for (const CapturedFrame &other : framesOfB)
            nearest = std::min(nearest, 1e3 * std::abs(toSeconds(readCode(frame.frame).begin -
                                                                 readCode(other.frame).begin)));
        apartMs.push_back(nearest);
    }
    std::ranges::sort(apartMs);
    QVERIFY(apartMs.size() >= 20);
    // 0.1 ms on a machine at rest; free-running cameras would be up to 20 ms apart.
    QVERIFY2(apartMs[apartMs.size() / 2] < 3 * slowness,
             qPrintable(QString::number(apartMs[apartMs.size() / 2])));
    QVERIFY(a.triggered >= 25);
}

void TestAravisStreaming::camerasAreFound()
{
    SimulatedGigeCamera a({.address = "127.31.1.12", .serial = "FOUND-A"}, codedPainter());
    SimulatedGigeCamera b({.address = "127.31.1.13", .serial = "FOUND-B", .model = "Other"}, codedPainter());
    const auto source = opened("aravis:FOUND-B?rate=20");
    QVERIFY(source);
    QCOMPARE(source->description().name.english(), std::string("Odograph Other"));
    QCOMPARE(take(*source, 1).size(), std::size_t(1));
    const std::vector<CameraDescription> all = listCameras();
    const auto listed = [&](const std::string &uri) {
        return std::ranges::find(all, uri, &CameraDescription::uri);
    };
    QVERIFY(listed("aravis:FOUND-A") != all.end());
    QCOMPARE(listed("aravis:FOUND-A")->kind, std::string("aravis"));
    QCOMPARE(listed("aravis:FOUND-A")->name.english(), std::string("Odograph Simulated"));
    QVERIFY(!listed("aravis:FOUND-A")->busy);
    QVERIFY(listed("aravis:FOUND-B") != all.end());
    QVERIFY(listed("aravis:FOUND-B")->busy);
    QCOMPARE(askGvcpCamera("127.31.1.12", std::chrono::seconds(1))->serial, std::string("FOUND-A"));
}

void TestAravisStreaming::nobodyAtAnAddressIsSaidAtOnce()
{
    const Nanoseconds begin = steadyNow();
    const auto nobody = openCamera("aravis:127.31.1.99");
    QVERIFY(!nobody);
    QCOMPARE(nobody.error().code, ErrorCode::Unavailable);
    QVERIFY2(nobody.error().message().starts_with("camera aravis:127.31.1.99: it does not answer; "),
             nobody.error().message().c_str());
    QVERIFY(toSeconds(steadyNow() - begin) < 2 * slowness);
    const auto unknown = openCamera("aravis:NO-SUCH-SERIAL");
    QVERIFY(!unknown);
    QVERIFY2(unknown.error().message().find("no camera of this serial number answers; ") != std::string::npos,
             unknown.error().message().c_str());
}

ODOGRAPH_TEST(TestAravisStreaming, QCoreApplication)
#include "tst_aravis_streaming.moc"
