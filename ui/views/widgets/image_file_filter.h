// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo {

/// The filter of a file dialog that asks for still images and videos of a camera.
QString imageFileFilter();

} // namespace odo
