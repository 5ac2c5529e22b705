// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/geometry/sensor_format.h"

#include <functional>
#include <optional>

namespace odo {

/// A lens calibration as it serves images of another size of the same camera.
struct FittedIntrinsics
{
    Intrinsics intrinsics;
    Message how; ///< a whole sentence: what was done, and how sure it is
};

/// The sentence on a lens that is converted to a size without a choice (determinedFormat).
Message intrinsicsConverted(const Intrinsics &calibrated, int widthPx, int heightPx);

/// The sum of the squares of the floor markers' residuals in pixels, with the camera where it fits them best
/// under a lens; nullopt where no position does.
using MarkerMisfit = std::function<std::optional<double>(const Intrinsics &intrinsics)>;

/// Fits a lens to images of another size, both positive, by the formats that are usual (sensorFormats) and by
/// this many floor markers seen in such an image, which show whether the camera enlarged it besides (digital
/// zoom, stabilisation). Each hypothesis is judged by χ², with the residuals' σ as the best of them leaves
/// it; under six markers it is a pixel or more, because the errors of their layout do not show. A cropped
/// format is taken as it is where the markers exclude enlargements of 4 % at three σ; where they show another
/// one to 1.7 % or better, that is taken with its σ; where they show neither, it is 10 % uncertain, and so is
/// what follows from it. What is determined without them is taken as it is unless they exclude it at five σ.
/// Of two ways to turn, one is taken at three σ, else their mean with its uncertainty. Any thread.
FittedIntrinsics fittedIntrinsics(const Intrinsics &calibrated, int widthPx, int heightPx,
                                  std::size_t markers, const MarkerMisfit &misfit);

} // namespace odo
