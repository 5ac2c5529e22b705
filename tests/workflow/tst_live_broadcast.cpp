// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/steady_now.h"
#include "core/workflow/record/live_tracking.h"
#include "tests/support/datagram_receiver.h"
#include "tests/support/protobuf_decoder.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <chrono>

using namespace odo;
using namespace odo::test;

namespace {

LiveMoment momentOf(std::size_t robot, Nanoseconds time, double xM, double speedMps)
{
    LiveMoment moment;
    moment.robot = robot;
    moment.position.sample.time = time;
    moment.position.sample.position = Eigen::Vector2d(xM, -0.5);
    moment.position.point = {{xM, -0.5}, {0, speedMps}, {0, 0}, 0.001, 0.001, speedMps, 0.01, 0, 0.1, true};
    return moment;
}

std::vector<RobotRecord> twoRobots()
{
    RobotRecord red, blue;
    red.colour = {0xd7, 0x23, 0x28};
    red.heightM = 0.06;
    blue.colour = {0x00, 0x72, 0xb2};
    return {red, blue};
}

} // namespace

/// Live positions on the network, heard by a socket of the test's own.
class TestLiveBroadcast : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isHeard_data()
    {
        QTest::addColumn<bool>("isMulticast");
        QTest::newRow("by a multicast group on the loopback") << true;
        QTest::newRow("by one machine") << false;
    }
    void isHeard()
    {
        QFETCH(bool, isMulticast);
        const DatagramReceiver receiver(isMulticast);
        BroadcastTarget target;
        target.port = receiver.port;
        if (!isMulticast)
            target.address = "127.0.0.1";
        auto broadcast = LiveBroadcast::create(target, twoRobots());
        QVERIFY2(broadcast, broadcast ? "" : broadcast.error().message().c_str());
        const Nanoseconds taken = steadyNow() - std::chrono::milliseconds(40);
        (*broadcast)->take(momentOf(0, taken, 0.25, 1));
        (*broadcast)->take(momentOf(1, taken, 0.75, 0));
        const auto packet = decodeMessage(receiver.next());
        QVERIFY(packet && packet->first(1));
        const auto frame = decodeMessage(packet->first(1)->bytes);
        QVERIFY(frame);
        QCOMPARE(frame->first(1)->bits, quint64(0));
        QCOMPARE(frame->fields.count(6), std::size_t(1));
        QCOMPARE(frame->fields.count(7), std::size_t(1));
        const auto yellow = decodeMessage(frame->first(6)->bytes),
                   blue = decodeMessage(frame->first(7)->bytes);
        QCOMPARE(yellow->first(3)->shortReal(), 250.0f);
        QCOMPARE(yellow->first(4)->shortReal(), -500.0f);
        QCOMPARE(yellow->first(5)->shortReal(), 1.57079633f); // towards Y
        QCOMPARE(yellow->first(8)->shortReal(), 60.0f);
        QCOMPARE(blue->first(3)->shortReal(), 750.0f);
        QVERIFY(!blue->first(5)); // standing, it shows no heading
        const double nowS =
            std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
        const double sentS = frame->first(3)->real(), capturedS = frame->first(2)->real();
        QVERIFY(sentS <= nowS && sentS > nowS - 20);
        QVERIFY(sentS - capturedS >= 0.04 && sentS - capturedS < 20);
        // The next moment; what is not measured is foretold, what is not known is left out.
        LiveMoment predicted = momentOf(0, taken + std::chrono::milliseconds(33), 0.3, 0);
        predicted.position.sample.position.reset();
        LiveMoment unknown = momentOf(1, predicted.position.sample.time, 9, 1);
        unknown.position.point.valid = false;
        (*broadcast)->take(predicted);
        (*broadcast)->take(unknown);
        const auto second = decodeMessage(decodeMessage(receiver.next())->first(1)->bytes);
        QCOMPARE(second->first(1)->bits, quint64(1));
        QCOMPARE(second->fields.count(7), std::size_t(0));
        const auto again = decodeMessage(second->first(6)->bytes);
        QCOMPARE(again->first(1)->shortReal(), 0.5f);
        QCOMPARE(again->first(5)->shortReal(), 1.57079633f); // kept while it stands
    }
    /// A moment of which the last robot is missing is sent all the same.
    void nothingIsHeldBack()
    {
        const DatagramReceiver receiver(true);
        BroadcastTarget target;
        target.port = receiver.port;
        auto broadcast = LiveBroadcast::create(target, twoRobots());
        QVERIFY(broadcast);
        (*broadcast)->take(momentOf(0, std::chrono::milliseconds(1), 0.25, 1));
        (*broadcast)->take(momentOf(0, std::chrono::milliseconds(2), 0.5, 1));
        broadcast->reset();
        QVERIFY(!receiver.next().empty());
        QVERIFY(!receiver.next().empty());
    }
    /// However much there is to send: whoever tracks is never kept waiting, and nothing grows.
    void neverWaits()
    {
        BroadcastTarget target;
        target.address = "127.0.0.1"; // where nobody listens
        auto broadcast = LiveBroadcast::create(target, twoRobots());
        QVERIFY(broadcast);
        constexpr std::uint64_t count = 20000;
        for (std::uint64_t i = 0; i < count; ++i)
            (*broadcast)->take(momentOf(i % 2, Nanoseconds(i / 2 + 1), 0, 1));
        const auto statistics = (*broadcast)->statistics();
        // of one robot, where the other one's moment was dropped, or of two
        const std::uint64_t packets = statistics.sent + statistics.failed;
        // at most: in the queue, and in the packet that is being filled
        constexpr std::uint64_t waiting = 64 + 2;
        QVERIFY(statistics.dropped + packets <= count);
        QVERIFY(statistics.dropped + 2 * packets + waiting >= count);
    }
    void coloursAndNumbers()
    {
        std::vector<RobotRecord> robots(7);
        const std::vector<RgbColour> colours = {{255, 0, 0},   {0, 0, 255},   {128, 128, 128}, {0, 200, 0},
                                                {0, 255, 255}, {255, 0, 255}, {255, 255, 0}};
        for (std::size_t i = 0; i < robots.size(); ++i)
            robots[i].colour = colours[i];
        const auto numbers = sslNumbers(robots);
        std::string words;
        for (const SslNumber &number : numbers)
            words += (number.isYellow ? 'y' : 'b') + std::to_string(number.id) + ' ';
        QCOMPARE(words, std::string("y0 b0 y1 y2 b1 b2 y3 "));
    }
    void addresses()
    {
        QCOMPARE(*parseBroadcastTarget(""), BroadcastTarget());
        QCOMPARE(parseBroadcastTarget("10.0.0.7")->address, std::string("10.0.0.7"));
        QCOMPARE(parseBroadcastTarget("10.0.0.7")->port, std::uint16_t(10006));
        QCOMPARE(parseBroadcastTarget("224.5.23.2:10020")->port, std::uint16_t(10020));
        for (const char *wrong : {"robots.example", "10.0.0", "10.0.0.7:", "10.0.0.7:0", "10.0.0.7:70000",
                                  "10.0.0.7:1x", ":", "::1"}) {
            const auto target = parseBroadcastTarget(wrong);
            QVERIFY2(!target, wrong);
            QCOMPARE(target.error().message(), "address '" + std::string(wrong) +
                                                   "' of live positions: it is not an IPv4 address with a "
                                                   "port; write it like 224.5.23.2:10006");
        }
    }
    void groups()
    {
        for (const char *group : {"224.0.0.0", "224.5.23.2", "239.255.255.255"})
            QVERIFY(isMulticastGroup(group));
        for (const char *other : {"223.255.255.255", "240.0.0.1", "10.0.0.7", "group", ""})
            QVERIFY(!isMulticastGroup(other));
    }
    void noSuchInterface()
    {
        BroadcastTarget target;
        target.interface = "none7";
        const auto broadcast = LiveBroadcast::create(target, {});
        QVERIFY(!broadcast);
        QCOMPARE(broadcast.error().message(),
                 std::string("interface 'none7' of live positions: this computer has no interface of that "
                             "name; choose one that `ip link` lists, or lo to stay on this computer"));
    }
};

ODOGRAPH_TEST(TestLiveBroadcast, QCoreApplication)
#include "tst_live_broadcast.moc"
