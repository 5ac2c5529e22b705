// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

namespace odo {

/// A GigE Vision or USB3 Vision camera, by an address of aravis_address.h. Waits until the camera has
/// answered: some tenths of a second for an IPv4 address, two seconds for a serial number. All that Aravis
/// does is on a thread of its own. Errors: InvalidInput for an address that is not understood or asks for
/// what the camera cannot do; Unavailable when it does not answer or another program uses it.
Result<std::unique_ptr<CameraSource>> openAravisSource(const std::string &uri);

/// The cameras that answer; takes a second. Empty without a network.
std::vector<CameraDescription> listAravisCameras();

} // namespace odo
