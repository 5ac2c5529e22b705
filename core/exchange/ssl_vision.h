// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Positions as the RoboCup Small Size League's vision sends them (SSL-Vision): SSL_WrapperPacket with one
/// SSL_DetectionFrame, proto2, by the field numbers of messages_robocup_ssl_detection.proto. Pure; any
/// thread.

struct SslRobot
{
    bool isYellow = true; ///< else blue
    std::uint32_t id = 0; ///< among those of its colour
    double confidence = 1;
    double xM = 0, yM = 0;         ///< world frame; sent in millimetres
    std::optional<double> yawRad;  ///< about Z, from X to Y
    std::optional<double> heightM; ///< of the robot's top; sent in millimetres
};

struct SslFrame
{
    std::uint32_t number = 0;
    double capturedS = 0, sentS = 0; ///< since 1970 UTC
    std::uint32_t camera = 0;
    std::vector<SslRobot> robots;
};

/// The bytes of one packet. The pixels that the format demands of every robot are 0: a position may come from
/// several views.
std::string sslVisionPacket(const SslFrame &frame);

} // namespace odo
