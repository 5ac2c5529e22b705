// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/picture.h"

#include <QImage>

namespace odo {

/// Hands the pixels over to a QImage without copying them.
QImage toImage(ScreenPicture &&picture);

} // namespace odo
