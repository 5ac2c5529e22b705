// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/geometry/homography.h"

#include <optional>
#include <span>

namespace odo {

/// Markers that do not register, and all that is known of them.
struct TriedMarkers
{
    std::span<const PointPair> pairs; ///< floor position, metres, and pixel
    const CameraModel &camera;
    FocalLength focal;
    const RegistrationContext &context;
};

/// What people leave in an image, pixels, and by a tape on a floor of this extent, metres.
inline constexpr double carefulMarkPx = 1;
double carefulTapeM(double layoutM);

/// The RMS distance of the markers from where another camera sees them, pixels, where that is so small that
/// they were marked there; nullopt where not, and where the camera is not registered.
std::optional<double> markersApartPx(const OtherCamera &other, std::span<const PointPair> pairs);

/// A pixel that no image of this size has, beyond its edge by more than 2 % of its longer side; nullptr:
/// none.
const PointPair *pixelOutside(std::span<const PointPair> pairs, const CameraModel &camera);

/// How far the squares of the markers' distances may add up if each is seen and measured with usual care:
/// their degrees of freedom and three σ of χ². At least one degree.
double mostCarefulSum(std::size_t markers, FocalLength focal);

/// Tests the usual mistakes, each by fitting the markers without it, and names those that explain the misfit,
/// the likeliest first and three at most: clauses with how well they fit, such as "v = 720 - v fits to 0.1
/// px: is v counted from below?", with semicolons between them. Empty: none does. Of mistakes that explain
/// it, one with which the camera is upright excludes those that put it upside down, a mistake that leaves
/// nothing to choose those that do, and one that fits three times better the others. fitPx: only mistakes
/// without a free number, that fit so well. Pure; any thread.
Message likelyCauses(const TriedMarkers &tried, std::optional<double> fitPx = {});

/// The camera would be upside down, and upright if v was counted from below and the labels go round the other
/// way: then the floor is mirrored.
bool mayBeMirrored(const TriedMarkers &tried, const PlanePose &pose);

} // namespace odo
