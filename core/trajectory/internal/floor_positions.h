// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"
#include "core/tracking/observation.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/body_outline.h"

#include <vector>

namespace odo {

/// One view's floor position of the robot at one time of the first view's clock.
struct Sighting
{
    Nanoseconds time{0}; ///< since the first view's first frame
    bool seen = false;   ///< false: not found, a repeated frame, or beyond the horizon; the position is then
                         ///< meaningless
    bool duplicate = false; ///< found, but the frame repeats the one before: its time is not known
    bool cut = false;       ///< cut by the frame's edge: the centre is biased
    bool ofOutline = false; ///< by background subtraction, not by a colour
    double score = 0;
    FloorPosition position{};
    /// m², of what shadows leave ambiguous of the outlines: common to the run. It does not say which view is
    /// better, so it is no part of the position's.
    Eigen::Matrix2d lastingCovariance = Eigen::Matrix2d::Zero();
};

/// One view's observations projected onto the plane z = planeM (the silhouette's centre of a box or cylinder
/// of height h is, to first order, the image of its centre: planeM = h/2). The view must be registered.
/// Observations without a usable covariance are given half a pixel. What may last in all outlines of a run
/// goes into the calibration's part of the covariance.
std::vector<Sighting> positionObservations(const ViewTrack &view, double planeM);

/// What is known of a solid's outlines, and what is not known of it.
struct SolidUncertainty
{
    OutlineDifference outlines = {}; ///< that are measured by their support
    double unexplainedPx = 0;        ///< what it leaves of the outlines' centroids over parts of a run
    double forwardM = 0, leftM = 0;  ///< the position in it
};

/// Each view's observations as floor positions of the footprint's centre: of the solid, turned as `axes` says
/// at the time, for which its silhouette has the observed support (positionBySupport) or else the observed
/// centroid. The axis's σ goes into the pixels' part. An outline whose area is not that of the solid (but for
/// the few per cent by which a view may see it larger or smaller throughout) shows a part of the robot, or
/// more than the robot: its score becomes 0. Views that are not registered give nothing. The solid's
/// uncertainty goes into the calibration's part of the covariance, because it lasts.
std::vector<std::vector<Sighting>> positionBody(const std::vector<ViewTrack> &views, const SolidShape &shape,
                                                const std::vector<std::vector<BodyAxis>> &axes,
                                                const SolidUncertainty &uncertainty = {});

/// The median distance between successive sightings' times, seen or not; 0 for fewer than two.
Nanoseconds typicalInterval(const std::vector<Sighting> &sightings);

/// Which observations are of a frame that repeats the one before it but was coded again, so its bytes differ:
/// the robot stands still to a few hundredths of a pixel for one to four frames, and then is where its motion
/// before and after puts it, having caught up what it missed. No robot stops and leaps like that; one that
/// really rests does not catch up. Only a robot that moves by most of a pixel a frame shows it. As long as
/// the observations; pure.
std::vector<bool> repeatedFrames(const std::vector<Observation> &observations);

} // namespace odo
