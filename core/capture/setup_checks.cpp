// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/setup_checks.h"

#include "core/base/file_system.h"
#include "core/base/plain_text.h"
#include "core/base/platform/file_status.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace odo {

namespace {

using Verdict = SetupFinding::Verdict;

constexpr std::int64_t enoughReceiveBuffer =
    4 << 20; // some frames of a megapixel camera (packets come in bursts)
constexpr int largePackets = 8000;
constexpr double usb2Mbps = 480;
constexpr double rateApart =
    0.05; // of the rate; measured over two seconds it is known to half a frame per second
constexpr double badStepS = 0.017;   // half an interval of 30 frames/s
constexpr double flickerPart = 0.05; // of a lamp's period that an exposure may be off

bool isOnNetwork(const CheckedCamera &camera)
{
    return camera.description.kind == "aravis" && camera.usbBus.empty();
}

std::vector<std::string> networkCameras(const std::vector<CheckedCamera> &cameras)
{
    std::vector<std::string> names;
    for (const CheckedCamera &camera : cameras) {
        if (isOnNetwork(camera))
            names.push_back(camera.name);
    }
    return names;
}

/// A control whose name holds all of these words.
const CameraControl *controlNamed(const CheckedCamera &camera, std::initializer_list<const char *> words)
{
    const auto found = std::ranges::find_if(camera.controls, [&](const CameraControl &control) {
        const std::string name = lowerCaseAscii(control.name + " " + control.id);
        return std::ranges::all_of(words,
                                   [&](const char *word) { return name.find(word) != std::string::npos; });
    });
    return found == camera.controls.end() ? nullptr : &*found;
}

/// Seconds; nullopt: in no unit that is known.
std::optional<double> exposureS(const CameraControl &control)
{
    static const std::map<std::string, double> units{
        {"s", 1}, {"ms", 1e-3}, {"µs", 1e-6}, {"us", 1e-6}, {"100 µs", 1e-4}};
    const auto unit = units.find(control.unit);
    return unit == units.end() ? std::nullopt : std::optional(control.value * unit->second);
}

bool fitsLamps(double exposure, double mainsHz)
{
    const double periods = exposure * 2 * mainsHz;
    return periods > 0.5 && std::abs(periods - std::round(periods)) < flickerPart;
}

MessageArgument camerasNamed(const std::vector<std::string> &names)
{
    return listed(names, MessageArgument::Kind::Camera);
}

Message mayPulse()
{
    return ODO_TEXT("capture.pictures_may_pulse", "brightness may pulse under lamps");
}

} // namespace

SetupFinding checkUsbBuses(const std::vector<CheckedCamera> &cameras)
{
    const Message what = ODO_TEXT("capture.usb_buses", "USB buses");
    std::map<std::string, std::vector<std::string>> onBus;
    double slowest = 0;
    for (const CheckedCamera &camera : cameras) {
        if (camera.usbBus.empty())
            continue;
        onBus[camera.usbBus].push_back(camera.name);
        slowest = slowest == 0 ? camera.usbMbps : std::min(slowest, camera.usbMbps);
    }
    if (onBus.empty())
        return {Verdict::Good, what, ODO_TEXT("capture.no_usb_camera", "no USB camera is used"), {}};
    SetupFinding finding{
        Verdict::Good, what, ODO_TEXT("capture.own_usb_buses", "each USB camera has its own bus"), {}};
    for (const auto &[bus, names] : onBus) {
        if (names.size() < 2)
            continue;
        finding.words =
            slowest > 0
                ? ODO_TEXT("capture.bus_of_speed_shared", "cameras %1 share the bus %2, of %3")(
                      camerasNamed(names), bus, quantity(slowest, 0, "Mbit/s"))
                : ODO_TEXT("capture.bus_shared", "cameras %1 share the bus %2")(camerasNamed(names), bus);
        finding.verdict = slowest > usb2Mbps ? Verdict::Good : Verdict::Warning;
        if (finding.verdict == Verdict::Warning)
            finding.advice = joined(
                {ODO_TEXT("capture.use_other_port",
                          "plug one into a port on the other side of the computer, or into its own USB card"),
                 ODO_TEXT("capture.send_less", "or set both to MJPEG or to a smaller frame size")},
                Join::Semicolon);
    }
    return finding;
}

SetupFinding checkPermissions(const std::vector<VideoNode> &nodes)
{
    const Message what = ODO_TEXT("capture.access_to_cameras", "Access to cameras");
    std::vector<std::string> closed;
    for (const VideoNode &node : nodes) {
        if (!node.usable)
            closed.push_back(node.path);
    }
    if (!closed.empty())
        return {Verdict::Bad, what,
                ODO_TEXT("capture.nodes_forbidden",
                         "you may not use %1")(listed(closed, MessageArgument::Kind::File)),
                ODO_TEXT("capture.join_video_group", "add yourself to the group video (sudo usermod -aG "
                                                     "video $USER), then log out and in again")};
    if (nodes.empty())
        return {Verdict::NotKnown, what,
                ODO_TEXT("capture.no_node", "this computer has no USB or built-in camera (/dev/video*)"),
                ODO_TEXT("capture.no_node_advice",
                         "if one is connected, try another cable and port, without a hub")};
    return {Verdict::Good,
            what,
            ODO_TEXT("capture.nodes_usable", "you may use all %1 video devices")(nodes.size()),
            {}};
}

SetupFinding checkReceiveBuffer(const std::vector<CheckedCamera> &cameras, std::optional<std::int64_t> bytes)
{
    const Message what = ODO_TEXT("capture.receive_buffer", "Receive buffer");
    if (!bytes)
        return {Verdict::NotKnown,
                what,
                ODO_TEXT("capture.buffer_not_known",
                         "the system does not report its maximum size (net.core.rmem_max)"),
                {}};
    const MessageArgument size = quantity(static_cast<double>(*bytes) / (1 << 20), 1, "MiB");
    if (*bytes >= enoughReceiveBuffer)
        return {Verdict::Good,
                what,
                ODO_TEXT("capture.buffer_enough", "up to %1, enough for network cameras")(size),
                {}};
    const std::vector<std::string> names = networkCameras(cameras);
    if (names.empty())
        return {Verdict::Good,
                what,
                ODO_TEXT("capture.buffer_without_use", "%1, too small only for network cameras")(size),
                {}};
    return {
        Verdict::Bad, what,
        joined({ODO_TEXT("capture.buffer_small", "only %1")(size),
                ODO_TEXT("capture.cameras_will_lose", "%1 will lose frames")(camerasNamed(names))},
               Join::Colon),
        ODO_TEXT("capture.enlarge_buffer",
                 "sudo sysctl -w net.core.rmem_max=%1, and add the same line to /etc/sysctl.d/ to keep it")(
            std::to_string(enoughReceiveBuffer))};
}

SetupFinding checkPacketSize(const std::vector<CheckedCamera> &cameras, const std::vector<NetworkPort> &ports)
{
    const Message what = ODO_TEXT("capture.packet_size", "Packet size");
    if (networkCameras(cameras).empty())
        return {Verdict::Good, what, ODO_TEXT("capture.no_network_camera", "no network camera is used"), {}};
    std::vector<std::string> small;
    for (const NetworkPort &port : ports) {
        if (port.mtu < largePackets)
            small.push_back(port.name + " (" + std::to_string(port.mtu) + ")");
    }
    if (small.empty())
        return {Verdict::Good, what, ODO_TEXT("capture.large_packets", "large packets are allowed"), {}};
    return {
        Verdict::Warning, what,
        ODO_TEXT("capture.small_packets", "small packets on %1")(listed(small, MessageArgument::Kind::Label)),
        ODO_TEXT("capture.small_packets_advice",
                 "set the MTU of the camera's network port to 9000 (sudo ip link set dev NAME mtu 9000), if "
                 "camera and switch support it")};
}

SetupFinding checkFlicker(const CheckedCamera &camera)
{
    const Message what =
        ODO_TEXT("capture.flicker_of_camera", "Lamp flicker, camera %1")(Named::camera(camera.name));
    const CameraControl *filter = controlNamed(camera, {"power", "line"});
    if (filter && filter->kind == CameraControl::Kind::Choice) {
        const auto chosen = static_cast<std::size_t>(std::max(0.0, filter->value));
        const std::string word = chosen < filter->choices.size() ? filter->choices[chosen] : "";
        if (lowerCaseAscii(word).find("disabled") == std::string::npos)
            return {Verdict::Good,
                    what,
                    ODO_TEXT("capture.flicker_filtered", "filtered by the camera (%1)")(word),
                    {}};
        return {
            Verdict::Warning, what,
            joined({ODO_TEXT("capture.flicker_filter_off", "its filter is off"), mayPulse()}, Join::Colon),
            joined({ODO_TEXT("capture.set_to_mains", "set '%1' to your mains frequency")(filter->name),
                    ODO_TEXT("capture.usual_mains", "50 Hz in most countries, 60 Hz in the Americas")},
                   Join::Colon)};
    }
    const CameraControl *exposure = controlNamed(camera, {"exposure", "time"});
    const auto seconds = exposure ? exposureS(*exposure) : std::nullopt;
    if (!seconds)
        return {Verdict::NotKnown,
                what,
                ODO_TEXT("capture.exposure_not_told", "it does not report its exposure"),
                {}};
    const MessageArgument exposed = quantity(1e3 * *seconds, 1, "ms");
    if (fitsLamps(*seconds, 50) || fitsLamps(*seconds, 60))
        return {Verdict::Good,
                what,
                ODO_TEXT("capture.exposure_suits_lamps", "exposed for %1, which suits lamps")(exposed),
                {}};
    return {Verdict::Warning, what,
            joined({ODO_TEXT("capture.exposed_for", "exposed for %1")(exposed), mayPulse()}, Join::Colon),
            joined({ODO_TEXT("capture.expose_for_mains",
                             "expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz"),
                    ODO_TEXT("capture.use_daylight", "or use daylight")},
                   Join::Semicolon)};
}

SetupFinding checkAutomatics(const CheckedCamera &camera)
{
    const Message what =
        ODO_TEXT("capture.automatics_of_camera", "Automatic settings, camera %1")(Named::camera(camera.name));
    const std::vector<Message> &notHeld = camera.health.notHeld;
    if (!notHeld.empty())
        return {
            Verdict::Warning, what,
            notHeld.size() > 1
                ? ODO_TEXT("capture.several_not_held", "%1 still adjust automatically")(listed(notHeld))
                : ODO_TEXT("capture.one_not_held", "%1 still adjusts automatically")(notHeld.front()),
            ODO_TEXT("capture.turn_off_at_camera",
                     "turn it off in the camera's own program, or keep the light steady while robots run")};
    if (camera.health.automaticsHeld.value_or(false))
        return {Verdict::Good,
                what,
                ODO_TEXT("capture.automatics_held", "exposure, gain, white balance and focus are held"),
                {}};
    if (camera.controls.empty())
        return {Verdict::Good, what, ODO_TEXT("capture.no_automatics", "it has none"), {}};
    return {
        Verdict::Good, what, ODO_TEXT("capture.held_while_recording", "they are held while recording"), {}};
}

SetupFinding checkStep(const std::vector<CheckedCamera> &cameras, const PairHealth &pairs)
{
    const Message what = ODO_TEXT("capture.step", "Synchronisation");
    if (cameras.size() < 2)
        return {Verdict::Good,
                what,
                ODO_TEXT("capture.one_camera_in_step", "a single camera needs no synchronisation"),
                {}};
    double least = HUGE_VAL, most = 0;
    for (const CheckedCamera &camera : cameras) {
        least = std::min(least, camera.health.framesPerSecond);
        most = std::max(most, camera.health.framesPerSecond);
    }
    if (least <= 0)
        return {Verdict::NotKnown, what,
                ODO_TEXT("capture.camera_does_not_deliver", "a camera sends no frames"),
                ODO_TEXT("capture.see_own_line", "see the line of that camera")};
    if (most - least > rateApart * most)
        return {
            Verdict::Warning, what,
            ODO_TEXT("capture.rates_differ", "the cameras run at %1 and %2")(quantity(least, 1),
                                                                             quantity(most, 1, "frames/s")),
            joined({ODO_TEXT("capture.set_to_one_rate", "set both to the same rate"),
                    ODO_TEXT("capture.dim_light_halves_rate",
                             "in dim light a camera halves its rate unless its automatic exposure is off")},
                   Join::Semicolon)};
    if (pairs.pairs == 0)
        return {Verdict::NotKnown, what,
                ODO_TEXT("capture.no_pair_yet", "no frames of the cameras have been paired yet"),
                ODO_TEXT("capture.look_again", "wait a few seconds, then check again")};
    if (pairs.p95S > badStepS)
        return {
            Verdict::Warning, what, synchronisationWords(pairs.p95S),
            ODO_TEXT("capture.set_rate_or_trigger", "set both to the same rate, or trigger them together")};
    return {Verdict::Good, what, synchronisationWords(pairs.p95S), {}};
}

SetupFinding checkFrameSize(const CheckedCamera &camera)
{
    const Message what =
        ODO_TEXT("capture.picture_size_of_camera", "Frame size, camera %1")(Named::camera(camera.name));
    const std::string is = sizeText(camera.description.widthPx, camera.description.heightPx);
    if (camera.registeredWidthPx == 0)
        return {Verdict::Warning, what, notRegisteredToFloor(),
                ODO_TEXT("capture.register_in_testbed",
                         "register it in Testbed; Odograph needs this to measure where a robot is")};
    if (camera.registeredWidthPx == camera.description.widthPx &&
        camera.registeredHeightPx == camera.description.heightPx)
        return {
            Verdict::Good, what, ODO_TEXT("capture.size_as_registered", "%1, as it was registered")(is), {}};
    return {Verdict::Bad, what,
            ODO_TEXT("capture.size_not_as_registered", "%1, but registered at %2")(
                is, sizeText(camera.registeredWidthPx, camera.registeredHeightPx)),
            ODO_TEXT("capture.send_registered_size",
                     "set it to the size it was registered at, or calibrate and register it again")};
}

std::vector<SetupFinding> checkSetup(std::vector<CheckedCamera> cameras, const PairHealth &pairs,
                                     const MachineFacts &machine)
{
    for (CheckedCamera &camera : cameras) {
        const auto node = std::ranges::find_if(machine.nodes, [&](const VideoNode &each) {
            const std::string address = camera.description.uri.substr(0, camera.description.uri.find('?'));
            return camera.description.kind == "v4l2" && address.ends_with(":" + each.path);
        });
        if (node == machine.nodes.end())
            continue;
        camera.usbBus = node->usbBus;
        camera.usbMbps = node->usbMbps;
    }
    std::vector<SetupFinding> findings;
    for (const CheckedCamera &camera : cameras) {
        findings.push_back(checkFrameSize(camera));
        findings.push_back(checkAutomatics(camera));
        findings.push_back(checkFlicker(camera));
    }
    findings.push_back(checkStep(cameras, pairs));
    findings.push_back(checkUsbBuses(cameras));
    findings.push_back(checkPermissions(machine.nodes));
    findings.push_back(checkReceiveBuffer(cameras, machine.receiveBufferBytes));
    findings.push_back(checkPacketSize(cameras, machine.ports));
    const auto rank = [](const SetupFinding &finding) {
        switch (finding.verdict) {
        case Verdict::Bad:
            return 0;
        case Verdict::Warning:
            return 1;
        case Verdict::Good:
            return 2;
        case Verdict::NotKnown:
            break;
        }
        return 3;
    };
    std::ranges::stable_sort(findings, {}, rank);
    return findings;
}

namespace {

template <class Value>
std::optional<Value> valueIn(const std::filesystem::path &file)
{
    std::ifstream stream(file);
    Value value{};
    return stream >> value ? std::optional(value) : std::nullopt;
}

std::vector<std::string> sortedNamesIn(const std::filesystem::path &folder)
{
    std::error_code unread; // what cannot be accessed counts as missing
    std::vector<std::string> names = files::namesIn(folder, unread);
    std::ranges::sort(names);
    return names;
}

/// From a device's place in /sys ("…/usb1/1-2/1-2:1.0"): the bus, and how fast the nearest device above it is
/// connected.
void findUsb(VideoNode &node, const std::filesystem::path &device)
{
    std::error_code problem;
    std::filesystem::path location = files::realPath(device, problem);
    if (problem)
        return;
    for (const std::filesystem::path &part : location) {
        if (part.string().starts_with("usb") && part.string().size() > 3)
            node.usbBus = part.string();
    }
    for (; node.usbBus.size() > 0 && location != location.parent_path(); location = location.parent_path()) {
        if (const auto speed = valueIn<double>(location / "speed")) {
            node.usbMbps = *speed;
            return;
        }
    }
}

} // namespace

MachineFacts readMachine(const std::filesystem::path &root)
{
    MachineFacts facts;
    for (const std::string &name : sortedNamesIn(root / "dev")) {
        if (!name.starts_with("video"))
            continue;
        VideoNode node;
        node.path = "/dev/" + name;
        node.usable = !checkAccess(root / "dev" / name, FileAccess::Both);
        findUsb(node, root / "sys/class/video4linux" / name / "device");
        facts.nodes.push_back(std::move(node));
    }
    for (const std::string &name : sortedNamesIn(root / "sys/class/net")) {
        const std::filesystem::path port = root / "sys/class/net" / name;
        const auto mtu = valueIn<int>(port / "mtu");
        if (name != "lo" && mtu && valueIn<std::string>(port / "operstate") == "up")
            facts.ports.push_back({name, *mtu});
    }
    facts.receiveBufferBytes = valueIn<std::int64_t>(root / "proc/sys/net/core/rmem_max");
    return facts;
}

} // namespace odo
