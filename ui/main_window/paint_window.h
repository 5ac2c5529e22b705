// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"

#include <QImage>
#include <QSize>

namespace odo {

class MainWindow;

/// Paints the window as a user would see it at a size in logical pixels, once its images are loaded (or after
/// ten seconds; cancelled, at once). Works on the offscreen platform. The image has the size times the device
/// pixel ratio.
QImage paintWindow(MainWindow &window, QSize size, const CancelToken &cancel = {});

} // namespace odo
