// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Who answers to GigE Vision's discovery.
struct GvcpCamera
{
    std::string address; ///< IPv4, dotted
    std::string vendor, model, serial;
};

// A few questions of GigE Vision's control protocol (GVCP; GigE Vision 2.0, 14 to 18) asked directly. Aravis
// would take seconds to find out that a camera is gone, and hold its locks meanwhile; these take only the
// time given, and need no control of the camera. Any thread.

/// True for four numbers with points.
bool isIpAddress(const std::string &text);

/// Who is at an address; nullopt when nobody answers in time.
std::optional<GvcpCamera> askGvcpCamera(const std::string &address, std::chrono::milliseconds patience);

/// Whether a program controls the camera at an address; nullopt when it does not answer.
std::optional<bool> isGvcpControlled(const std::string &address, std::chrono::milliseconds patience);

/// All that answer to a broadcast on any network of this machine, each address once. Takes a second, which
/// the protocol lets cameras take to answer. Empty without a network.
std::vector<GvcpCamera> discoverGvcpCameras();

} // namespace odo
