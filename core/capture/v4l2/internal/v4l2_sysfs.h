// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What the kernel reports about a V4L2 node without opening it; by its number, as in /dev/video0.
namespace odo::v4l2Sysfs {

/// Of all nodes there are, in their order.
std::vector<int> nodeNumbers();
std::filesystem::path nodeOf(int number);

/// The camera's name, readable even without permission to open the node; empty where not reported.
std::string nameOf(const std::filesystem::path &node);
/// The node's place among those of its camera: the first is "0".
std::string indexOf(const std::filesystem::path &node);
/// Of the USB device that the node belongs to; empty where it has none.
std::string serialOf(const std::filesystem::path &node);

} // namespace odo::v4l2Sysfs
