// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/setup_checks.h"

#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <unistd.h>

using namespace odo;
namespace fs = std::filesystem;
using Verdict = SetupFinding::Verdict;

namespace {

CheckedCamera camera(const std::string &name, const std::string &kind = "v4l2")
{
    CheckedCamera checked;
    checked.name = name;
    checked.description.kind = kind;
    checked.description.uri = kind + ":/dev/video" + (name == "A" ? "0" : "2");
    checked.description.widthPx = checked.registeredWidthPx = 1280;
    checked.description.heightPx = checked.registeredHeightPx = 720;
    checked.health.state = ViewHealth::State::Delivering;
    checked.health.framesPerSecond = 30;
    return checked;
}

CheckedCamera onBus(const std::string &name, const std::string &bus, double mbps)
{
    CheckedCamera checked = camera(name);
    checked.usbBus = bus;
    checked.usbMbps = mbps;
    return checked;
}

CameraControl choice(const std::string &name, std::vector<std::string> choices, double value)
{
    CameraControl control;
    control.id = control.name = name;
    control.kind = CameraControl::Kind::Choice;
    control.choices = std::move(choices);
    control.value = value;
    return control;
}

bool has(const std::string &text, const char *part)
{
    return text.find(part) != std::string::npos;
}

void write(const fs::path &file, const std::string &content)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file) << content << '\n';
}

} // namespace

class TestSetupChecks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void usbBuses();
    void permissions();
    void receiveBuffer();
    void packetSize();
    void flicker();
    void automatics();
    void step();
    void pictureSize();
    void theWorstComesFirst();
    void readsTheMachine();
};

void TestSetupChecks::usbBuses()
{
    QCOMPARE(checkUsbBuses({}).verdict, Verdict::Good);
    QCOMPARE(checkUsbBuses({onBus("A", "usb1", 480), onBus("B", "usb3", 480)}).verdict, Verdict::Good);
    const SetupFinding shared = checkUsbBuses({onBus("A", "usb1", 480), onBus("B", "usb1", 480)});
    QCOMPARE(shared.verdict, Verdict::Warning);
    QCOMPARE(shared.words.english(), std::string("cameras A and B share the bus usb1, of 480 Mbit/s"));
    QVERIFY(has(shared.advice.english(), "plug one into a port on the other side"));
    const SetupFinding fast = checkUsbBuses({onBus("A", "usb2", 5000), onBus("B", "usb2", 5000)});
    QCOMPARE(fast.verdict, Verdict::Good);
    QVERIFY(fast.advice.english().empty());
}

void TestSetupChecks::permissions()
{
    QCOMPARE(checkPermissions({}).verdict, Verdict::NotKnown);
    QCOMPARE(checkPermissions({{"/dev/video0"}}).verdict, Verdict::Good);
    const SetupFinding closed = checkPermissions({{"/dev/video0", false, "", 0}, {"/dev/video1"}});
    QCOMPARE(closed.verdict, Verdict::Bad);
    QCOMPARE(closed.words.english(), std::string("you may not use /dev/video0"));
    QVERIFY(has(closed.advice.english(), "usermod -aG video"));
}

void TestSetupChecks::receiveBuffer()
{
    QCOMPARE(checkReceiveBuffer({}, std::nullopt).verdict, Verdict::NotKnown);
    QCOMPARE(checkReceiveBuffer({camera("A")}, 212992).verdict,
             Verdict::Good); // a USB camera has no use for it
    QCOMPARE(checkReceiveBuffer({camera("A", "aravis")}, 8 << 20).verdict, Verdict::Good);
    const SetupFinding small = checkReceiveBuffer({camera("A", "aravis")}, 212992); // Debian's
    QCOMPARE(small.verdict, Verdict::Bad);
    QCOMPARE(small.words.english(), std::string("only 0.2 MiB: A will lose frames"));
    QVERIFY(has(small.advice.english(), "net.core.rmem_max=4194304"));
}

void TestSetupChecks::packetSize()
{
    const std::vector<NetworkPort> ports{{"eth0", 1500}, {"eth1", 9000}};
    QCOMPARE(checkPacketSize({camera("A")}, ports).verdict, Verdict::Good);
    const SetupFinding small = checkPacketSize({camera("A", "aravis")}, ports);
    QCOMPARE(small.verdict, Verdict::Warning);
    QCOMPARE(small.words.english(), std::string("small packets on eth0 (1500)"));
    QCOMPARE(checkPacketSize({camera("A", "aravis")}, {{"eth1", 9000}}).verdict, Verdict::Good);
}

void TestSetupChecks::flicker()
{
    CheckedCamera a = camera("A");
    QCOMPARE(checkFlicker(a).verdict, Verdict::NotKnown);
    CameraControl exposure;
    exposure.id = exposure.name = "Exposure Time, Absolute";
    exposure.unit = "100 µs";
    for (const auto &[value, verdict] :
         {std::pair(100.0, Verdict::Good), std::pair(200.0, Verdict::Good), std::pair(83.0, Verdict::Good),
          std::pair(30.0, Verdict::Warning), std::pair(156.0, Verdict::Warning)}) {
        exposure.value = value;
        a.controls = {exposure};
        QCOMPARE(checkFlicker(a).verdict, verdict);
    }
    QCOMPARE(checkFlicker(a).words.english(),
             std::string("exposed for 15.6 ms: brightness may pulse under lamps"));
    a.controls.push_back(choice("Power Line Frequency", {"Disabled", "50 Hz", "60 Hz"}, 0));
    QCOMPARE(checkFlicker(a).verdict, Verdict::Warning);
    QVERIFY(has(checkFlicker(a).advice.english(), "50 Hz in most countries"));
    a.controls.back().value = 1;
    QCOMPARE(checkFlicker(a).words.english(), std::string("filtered by the camera (50 Hz)"));
}

void TestSetupChecks::automatics()
{
    CheckedCamera a = camera("A");
    QCOMPARE(checkAutomatics(a).words.english(), std::string("it has none"));
    a.health.automaticsHeld = true;
    QCOMPARE(checkAutomatics(a).verdict, Verdict::Good);
    a.health.notHeld = {foreignWords("Exposure, Auto"), foreignWords("Gain, Auto")};
    QCOMPARE(checkAutomatics(a).verdict, Verdict::Warning);
    QCOMPARE(checkAutomatics(a).words.english(),
             std::string("Exposure, Auto and Gain, Auto still adjust automatically"));
}

void TestSetupChecks::step()
{
    PairHealth pairs;
    QCOMPARE(checkStep({camera("A")}, pairs).verdict, Verdict::Good);
    QCOMPARE(checkStep({camera("A"), camera("B")}, pairs).verdict, Verdict::NotKnown);
    pairs.pairs = 100;
    pairs.p95S = 0.0012;
    QCOMPARE(checkStep({camera("A"), camera("B")}, pairs).verdict, Verdict::Good);
    pairs.p95S = 0.03;
    QCOMPARE(checkStep({camera("A"), camera("B")}, pairs).verdict, Verdict::Warning);
    CheckedCamera slow = camera("B");
    slow.health.framesPerSecond = 15;
    const SetupFinding apart = checkStep({camera("A"), slow}, pairs);
    QCOMPARE(apart.words.english(), std::string("the cameras run at 15.0 and 30.0 frames/s"));
    slow.health.framesPerSecond = 0;
    QCOMPARE(checkStep({camera("A"), slow}, pairs).verdict, Verdict::NotKnown);
}

void TestSetupChecks::pictureSize()
{
    CheckedCamera a = camera("A");
    QCOMPARE(checkFrameSize(a).words.english(), std::string("1280×720, as it was registered"));
    a.description.widthPx = 640;
    a.description.heightPx = 480;
    QCOMPARE(checkFrameSize(a).verdict, Verdict::Bad);
    QCOMPARE(checkFrameSize(a).words.english(), std::string("640×480, but registered at 1280×720"));
    a.registeredWidthPx = 0;
    QCOMPARE(checkFrameSize(a).verdict, Verdict::Warning);
}

void TestSetupChecks::theWorstComesFirst()
{
    MachineFacts machine;
    machine.nodes = {{"/dev/video0", true, "usb1", 480}, {"/dev/video2", true, "usb1", 480}};
    machine.receiveBufferBytes = 212992;
    CheckedCamera b = camera("B");
    b.description.widthPx = 640;
    const auto findings = checkSetup({camera("A"), b}, {}, machine);
    QCOMPARE(findings.size(), std::size_t(11)); // three a camera, five of the whole
    QCOMPARE(findings.front().what.english(), std::string("Frame size, camera B"));
    QVERIFY(std::ranges::any_of(findings, [](const SetupFinding &each) {
        return each.what.english() == "USB buses" && each.verdict == Verdict::Warning;
    }));
    for (const SetupFinding &finding : findings) {
        const bool bad = finding.verdict == Verdict::Bad || finding.verdict == Verdict::Warning;
        QVERIFY2(!finding.words.isEmpty() && (!bad || !finding.advice.english().empty()),
                 finding.what.english().c_str());
    }
    QVERIFY(!checkSetup({}, {}, {}).empty());
}

void TestSetupChecks::readsTheMachine()
{
    QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const MachineFacts none = readMachine(root);
    QVERIFY(none.nodes.empty() && none.ports.empty() && !none.receiveBufferBytes);
    write(root / "dev/video0", "");
    write(root / "dev/video1", "");
    write(root / "dev/null", "");
    fs::permissions(root / "dev/video1", fs::perms::none);
    const fs::path usb = root / "sys/devices/pci0000:00/0000:00:14.0/usb1/1-2";
    write(usb / "speed", "480");
    fs::create_directories(usb / "1-2:1.0");
    fs::create_directories(root / "sys/class/video4linux/video0");
    fs::create_directory_symlink(usb / "1-2:1.0", root / "sys/class/video4linux/video0/device");
    for (const char *port : {"eth0", "eth1", "lo"}) {
        write(root / "sys/class/net" / port / "mtu", "1500");
        write(root / "sys/class/net" / port / "operstate", std::string(port) == "eth1" ? "down" : "up");
    }
    write(root / "proc/sys/net/core/rmem_max", "212992");
    const MachineFacts facts = readMachine(root);
    QCOMPARE(facts.nodes.size(), std::size_t(2));
    QCOMPARE(facts.nodes[0].path, std::string("/dev/video0"));
    QVERIFY(facts.nodes[0].usable);
    QCOMPARE(facts.nodes[0].usbBus, std::string("usb1"));
    QCOMPARE(facts.nodes[0].usbMbps, 480.0);
    QCOMPARE(facts.nodes[1].usable, geteuid() == 0); // root may do all
    QVERIFY(facts.nodes[1].usbBus.empty());
    QCOMPARE(facts.ports.size(), std::size_t(1));
    QCOMPARE(facts.ports[0].mtu, 1500);
    QCOMPARE(facts.receiveBufferBytes.value_or(0), std::int64_t(212992));
}

ODOGRAPH_TEST(TestSetupChecks, QCoreApplication)
#include "tst_setup_checks.moc"
