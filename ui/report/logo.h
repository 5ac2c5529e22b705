// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QImage>
#include <filesystem>

namespace odo {

/// A school's logo out of a picture file of any kind that Qt reads, made no larger than reports show it. Io, with
/// what to do, where it is not there, no picture, or larger than a hundred megapixels.
Result<QImage> readLogo(const std::filesystem::path &file);

} // namespace odo
