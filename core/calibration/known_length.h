// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/floor_view.h"

#include <optional>
#include <span>
#include <string>

namespace odo {

/// A stick (or any known length) as one registered camera sees its two ends.
struct SeenLength
{
    const FloorView *view = nullptr; ///< lives as long as the call
    std::string camera;              ///< for words
    Eigen::Vector2d fromPixel, toPixel;
    double fromSigmaPx = 0.5, toSigmaPx = 0.5; ///< of one coordinate; a click is good to half a pixel, a snapped end to less
};

/// A length measured on the floor, against what it was told to be.
struct LengthCheck
{
    double lengthM = 0;
    double sigmaM = 0; ///< from the pixels and the calibration, whose errors both ends have in common
    std::optional<double> differenceM; ///< measured minus told
    bool agrees = true; ///< with what was told, within 2.5 σ, and the cameras with one another
    std::string words;  ///< one or two sentences for a person, with what to do where it does not agree
};

/// Measures the length in each camera and joins the cameras by their information. heightM: of the plane in which the
/// stick lies. The told length counts as exact. Errors: no camera, an end at or beyond the horizon, ends on one pixel, a told
/// length that is not positive. Pure; any thread.
Result<LengthCheck> checkLength(std::span<const SeenLength> seen, std::optional<double> toldM, double heightM = 0);

} // namespace odo
