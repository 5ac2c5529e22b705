// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>

namespace odo {

/// What errors of a camera are about: "camera v4l2:/dev/video0".
Message cameraAtAddress(const std::string &uri);

/// InvalidInput: a part of an address.
tl::unexpected<Error> notUnderstood(const std::string &uri, const std::string &part, Message advice);
/// NotFound, for CameraSource::set.
tl::unexpected<Error> noSuchControl(const std::string &uri, const std::string &id);

/// Within what bounds a control can be set.
Message controlGoes(const std::string &name, MessageArgument from, MessageArgument to);

Message usedByAnotherProgram();
Message closeThatProgram();
Message notRegisteredToFloor();

} // namespace odo
