// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/vm/uvc_camera.h"
#include "tests/vm/vivid_cameras.h"

#include <memory>

namespace odo::test {

/// The picture of all played cameras' MJPEG: 320×240, 4:2:2, with its Huffman tables.
const UsbBytes &playedFrame();

/// A webcam that sends it without the tables, plugged in; nullptr (and the test fails) when the kernel does
/// not take it.
std::unique_ptr<UvcCamera> playedCamera(unsigned port, const std::string &name, const std::string &serial);

/// The USB cameras that are listed now.
std::vector<CameraDescription> usbCameras();
/// The address of the one with this serial number, with a mode of 320×240; empty when there is none.
std::string playedUri(const std::string &serial, const std::string &format = "MJPG");

} // namespace odo::test
