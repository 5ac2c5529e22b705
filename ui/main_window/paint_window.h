// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"

#include <QImage>
#include <QSize>

namespace odo {

class MainWindow;

/// The window as a user would see it at a size in logical pixels, once its pictures are there (or ten seconds
/// have passed). Cancelled, it is what is there then. Works on the offscreen platform. The picture has the
/// size times the device pixel ratio.
QImage paintWindow(MainWindow &window, QSize size, const CancelToken &cancel = {});

} // namespace odo
