// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"
#include "core/video/frame.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// A marker found again, against where it was at the registration.
struct MarkerShift
{
    std::string label;
    Eigen::Vector2d storedPixel, foundPixel;
    double shiftPx = 0;
    double shiftM = 0;  ///< on the floor, as the registration maps it
    double limitPx = 0; ///< beyond it the shift is no noise
    bool isMoved() const { return shiftPx > limitPx; }
};

struct CameraPositionCheck
{
    /// Three unmoved markers prove that the camera has not moved: then the others were moved.
    enum class Verdict { Still, CameraMoved, MarkersMoved } verdict = Verdict::Still;
    std::vector<MarkerShift> markers;
    std::vector<std::string> missing; ///< markers of the registration that were not found again
    double shiftPx = 0, shiftM = 0;   ///< median of the moved markers; of all where none is
    Message words;                    ///< one sentence, and what to do
};

/// Finds a registration's markers in a newer image: tags anywhere by their number, everything else by what
/// snapToMarker() finds within 20 px of where it was; where fewer than two are left so, rings and dots
/// anywhere, named by geometry. camera: of the registration. Those not found are left out. Thread-safe.
std::vector<MarkerPixel> findAgain(const Frame &frame, const MarkerLayout &layout,
                                   const std::vector<MarkerPixel> &stored, const CameraModel &camera);

/// The subject of an error when that cannot be determined. camera: its name, or a message that names it.
Message cameraMovement(MessageArgument camera);

/// Compares markers of the registration with the same ones found in a newer image. A shift is one beyond 4 σ
/// of the difference of two pixels, with σ the larger of 0.3 px and what the registration's markers fit to
/// (fitPx, its RMS). Undetermined when fewer than two markers were found again. Pure; any thread.
Result<CameraPositionCheck> checkCameraPosition(const std::string &camera, const FloorView &view,
                                                const std::vector<MarkerPixel> &stored,
                                                const std::vector<MarkerPixel> &found, double fitPx);

/// A stick (or any known length) as one registered camera sees its two ends.
struct SeenLength
{
    const FloorView *view = nullptr; ///< lives as long as the call
    std::string camera;              ///< for words
    Eigen::Vector2d fromPixel, toPixel;
    /// of one coordinate; a click is good to half a pixel, a snapped end to less
    double fromSigmaPx = 0.5, toSigmaPx = 0.5;
};

/// A length measured on the floor, against the entered length.
struct LengthCheck
{
    double lengthM = 0;
    double sigmaM = 0; ///< from the pixels and the calibration, whose errors both ends have in common
    std::optional<double> differenceM; ///< measured minus entered
    bool agrees = true; ///< with the entered length, within 2.5 σ, and the cameras with each other
    Message words;      ///< one or two sentences, with what to do where it does not agree
};

/// Measures the length in each camera and joins the cameras by their information. heightM: of the plane in
/// which the stick lies. The entered length counts as exact. Errors: no camera, an end at or beyond the
/// horizon, ends on one pixel, an entered length that is not positive. Pure; any thread.
Result<LengthCheck> checkLength(std::span<const SeenLength> seen, std::optional<double> givenM,
                                double heightM = 0);

} // namespace odo
