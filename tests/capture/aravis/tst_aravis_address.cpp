// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/aravis_address.h"
#include "core/capture/aravis/internal/aravis_session.h"
#include "core/capture/aravis/internal/camera_time_scale.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

/// What needs no camera: addresses, the time scale, the numbers of pictures.
class TestAravisAddress : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void addressesSayWhatIsWanted()
    {
        const auto plain = parseAravisAddress("aravis:192.168.1.20");
        QVERIFY(plain);
        QCOMPARE(plain->location, std::string("192.168.1.20"));
        QVERIFY(!plain->framesPerSecond && !plain->sizePx && !plain->format &&
                plain->trigger == AravisAddress::Trigger::None);
        const auto full = parseAravisAddress(
            "aravis:SN-17?rate=29.5&exposure_ms=5&gain=-2&format=BayerRG8&size=640x480&trigger=software"
            "&packet_size=9000&packet_delay_us=12.5");
        QVERIFY2(full, full ? "" : full.error().message().c_str());
        QCOMPARE(full->location, std::string("SN-17"));
        QCOMPARE(full->framesPerSecond, 29.5);
        QCOMPARE(*full->exposure, Nanoseconds(5ms));
        QCOMPARE(full->gain, -2.0);
        QCOMPARE(full->format, std::string("BayerRG8"));
        QCOMPARE(*full->sizePx, std::pair(640, 480));
        QCOMPARE(full->trigger, AravisAddress::Trigger::Software);
        QCOMPARE(full->packetSize, 9000);
        QCOMPARE(*full->packetDelay, Nanoseconds(12500ns));
    }

    void whatIsNotUnderstoodIsNamed_data()
    {
        QTest::addColumn<QByteArray>("uri");
        QTest::addColumn<QByteArray>("part");
        for (const auto &[uri, part] :
             {std::pair("aravis:", "neither an address nor a serial number"),
              std::pair("aravis:?rate=30", "neither"), std::pair("aravis:A?rate=0", "'rate=0'"),
              std::pair("aravis:A?rate=30&size=640", "'size=640'"),
              std::pair("aravis:A?size=640.5x2", "'size=640.5x2'"),
              std::pair("aravis:A?format=", "'format='"),
              std::pair("aravis:A?trigger=line", "'trigger=line'"),
              std::pair("aravis:A?nonsense", "'nonsense'"),
              std::pair("aravis:A?exposure_ms=-1", "'exposure_ms=-1'")})
            QTest::newRow(uri) << QByteArray(uri) << QByteArray(part);
    }
    void whatIsNotUnderstoodIsNamed()
    {
        QFETCH(QByteArray, uri);
        QFETCH(QByteArray, part);
        const auto address = parseAravisAddress(uri.toStdString());
        QVERIFY(!address);
        QCOMPARE(address.error().code, ErrorCode::InvalidInput);
        QVERIFY2(address.error().message().find(part.toStdString()) != std::string::npos,
                 address.error().message().c_str());
    }

    void timeBeginsAtTheFirstPictureAndGoesOn()
    {
        CameraTimeScale scale;
        QCOMPARE(scale.location(1000s, 50s, {}), Nanoseconds(0));
        QCOMPARE(scale.location(1000s + 33ms, 50s + 40ms, {}), Nanoseconds(33ms));
        QCOMPARE(scale.location(1000s + 66ms, 50s + 700ms, {}), Nanoseconds(66ms)); // however late it arrives
        QCOMPARE(scale.onScale(999s), Nanoseconds(-1s));
    }

    /// After an interruption the clock may have begun anew: what passed is known from ours, exactly where the
    /// clock was read.
    void aClockThatBeginsAnewIsJoined()
    {
        CameraTimeScale byArrival;
        byArrival.location(1000s, 50s, {});
        byArrival.interrupt();
        QCOMPARE(byArrival.location(3s, 57s, {}), Nanoseconds(7s));
        QCOMPARE(byArrival.location(3s + 33ms, 57s + 33ms, {}), Nanoseconds(7s + 33ms));

        const auto reading = [](Nanoseconds device, Nanoseconds host) {
            return ClockReading{device, host - 50us, host + 50us};
        };
        CameraTimeScale byReading;
        byReading.location(1000s, 50s + 8ms, reading(999s, 49s)); // taken at 50 s
        byReading.interrupt();
        QCOMPARE(byReading.location(3s, 57s + 30ms, reading(2900ms, 56900ms)),
                 Nanoseconds(7s)); // taken at 57 s
    }

    void aClockThatGoesOnIsLeftAlone()
    {
        CameraTimeScale scale;
        scale.location(1000s, 50s, {});
        scale.interrupt();
        QCOMPARE(scale.location(1007s + 1ms, 57s + 9ms, {}), Nanoseconds(7s + 1ms));
        scale.interrupt(); // and the first picture comes late
        QCOMPARE(scale.location(1009s, 59s + 800ms, {}), Nanoseconds(9s));
        QCOMPARE(scale.location(1009s + 33ms, 59s + 801ms, {}), Nanoseconds(9s + 33ms));
    }

    /// A clock that is set while pictures come; the last reading is then of the clock before.
    void timeNeverGoesBack()
    {
        CameraTimeScale scale;
        const ClockReading old{1000s, 50s, 50s};
        scale.location(1000s, 50s, old);
        QVERIFY(scale.goesOn(1000s + 33ms, 50s + 40ms));
        QVERIFY(!scale.goesOn(5ms, 50s + 33ms));
        QCOMPARE(scale.location(5ms, 50s + 33ms, old), Nanoseconds(33ms));
        QCOMPARE(scale.location(38ms, 50s + 66ms, old), Nanoseconds(66ms));
        QCOMPARE(scale.location(500s, 50s + 99ms, {}), Nanoseconds(99ms)); // and forward
    }

    /// Of a program, or a machine, that was held up: the clock has gone on all the time.
    void latePicturesDoNotMoveTheScale()
    {
        const auto readAt = [](Nanoseconds host) {
            return ClockReading{950s + host, host - 50us, host + 50us}; // it shows 950 s more than ours
        };
        for (const bool isRead : {false, true}) {
            CameraTimeScale scale;
            Nanoseconds late = 8ms;
            for (int i = 0; i < 200; ++i) {
                if (i == 50)
                    late = 1800ms; // and 54 pictures come at once
                const Nanoseconds taken = 50s + i * 33ms;
                const Nanoseconds arrival = taken + late;
                const auto reading = isRead ? std::optional(readAt(arrival - 300ms)) : std::nullopt;
                QVERIFY(scale.goesOn(950s + taken, arrival));
                QCOMPARE(scale.location(950s + taken, arrival, reading), Nanoseconds(i * 33ms));
                if (i >= 50)
                    late = std::max<Nanoseconds>(8ms, late - 32ms);
            }
        }
    }

    /// That it was late is known, because the clock is read at once.
    void aLatePictureOfAClockThatBeginsAnewIsPlaced()
    {
        CameraTimeScale scale;
        scale.location(1000s, 50s, ClockReading{1000s, 50s, 50s});
        const ClockReading anew{1933ms, 51s + 933ms, 51s + 933ms}; // since 50 s
        QVERIFY(!scale.goesOn(33ms, 51s + 900ms));
        QCOMPARE(scale.location(33ms, 51s + 900ms, anew), Nanoseconds(33ms));
        QCOMPARE(scale.location(66ms, 51s + 901ms, anew), Nanoseconds(66ms));
    }

    void numbersWrapAndGapsStay()
    {
        FrameNumbering numbering;
        QCOMPARE(numbering.number(65534), 0u);
        QCOMPARE(numbering.number(65535), 1u);
        QCOMPARE(numbering.number(1), 2u); // 0 is left out
        QCOMPARE(numbering.number(5), 6u);
        numbering.interrupt(10);
        QCOMPARE(numbering.number(1), 17u);
        QCOMPARE(numbering.number(2), 18u);
        QCOMPARE(numbering.number(1), 19u); // begins anew without a word
        FrameNumbering wide;
        QCOMPARE(wide.number(0x1'0000'0000), 0u);
        QCOMPARE(wide.number(0x1'0000'0003), 3u);
    }

    /// It is not the cable that is to blame.
    void whatNobodyTakesIsCountedAsOurs()
    {
        AravisSession session("aravis:A");
        for (std::uint64_t i = 0; i < 40; ++i) {
            CapturedFrame captured;
            captured.sequence = 2 * i; // each second one was lost on its way
            session.deliver(std::move(captured));
        }
        std::uint64_t taken = 0, lostHere = 0, last = 0;
        for (; taken < 32; ++taken) {
            const auto captured = session.next(0ns);
            QVERIFY(captured);
            lostHere += captured->lostHere;
            last = captured->sequence;
        }
        QCOMPARE(taken + lostHere, 40u);
        QCOMPARE(last, 78u);
        QCOMPARE(session.next(0ns).error().code, ErrorCode::Unavailable);
    }
};

ODOGRAPH_TEST(TestAravisAddress, QCoreApplication)
#include "tst_aravis_address.moc"
