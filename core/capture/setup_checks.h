// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A camera as the checks take it.
struct CheckedCamera
{
    std::string name; ///< in the project
    CameraDescription description;
    std::vector<CameraControl> controls = {};          ///< with their current values; none: not known
    int registeredWidthPx = 0, registeredHeightPx = 0; ///< 0: not registered
    ViewHealth health = {};
    std::string usbBus = {}; ///< "usb1"; empty: no USB camera, or not known
    double usbMbps = 0;      ///< at which it is connected
};

/// A device file of a camera.
struct VideoNode
{
    std::string path;
    bool usable = true; ///< may be read and written by who runs this program
    std::string usbBus = {};
    double usbMbps = 0;
};

struct NetworkPort
{
    std::string name;
    int mtu = 0;
};

/// What the checks need to know of this machine.
struct MachineFacts
{
    std::vector<VideoNode> nodes;
    std::vector<NetworkPort> ports;                 ///< that are up, without the loop-back
    std::optional<std::int64_t> receiveBufferBytes; ///< the largest a program may ask for
};

/// Reads them from /dev, /proc and /sys below a folder. May take some milliseconds. Any thread.
MachineFacts readMachine(const std::filesystem::path &root = "/");

/// What one check found, as a person reads it.
struct SetupFinding
{
    enum class Verdict { Good, Warning, Bad, NotKnown };
    Verdict verdict = Verdict::NotKnown;
    Message what;   ///< that was checked: "USB buses"
    Message words;  ///< what is
    Message advice; ///< what to do; empty where nothing need be
};

/// Two cameras on one USB bus share its bandwidth.
SetupFinding checkUsbBuses(const std::vector<CheckedCamera> &cameras);
/// Who may open /dev/video*.
SetupFinding checkPermissions(const std::vector<VideoNode> &nodes);
/// Network cameras lose packets where the system's receive buffer is smaller than a frame.
SetupFinding checkReceiveBuffer(const std::vector<CheckedCamera> &cameras, std::optional<std::int64_t> bytes);
/// Large packets save network cameras most of their work.
SetupFinding checkPacketSize(const std::vector<CheckedCamera> &cameras,
                             const std::vector<NetworkPort> &ports);
/// Lamps flicker at twice the mains' frequency: exposure, or the camera's filter, must fit.
SetupFinding checkFlicker(const CheckedCamera &camera);
/// Exposure, gain, white balance and focus that change by themselves change colours and the rate.
SetupFinding checkAutomatics(const CheckedCamera &camera);
/// Cameras of different rates, or whose frames are taken far apart.
SetupFinding checkStep(const std::vector<CheckedCamera> &cameras, const PairHealth &pairs);
/// A registration is valid for one frame size.
SetupFinding checkFrameSize(const CheckedCamera &camera);

/// All of them, the worst first.
std::vector<SetupFinding> checkSetup(std::vector<CheckedCamera> cameras, const PairHealth &pairs,
                                     const MachineFacts &machine);

} // namespace odo
