// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/accuracy_map.h"

#include <span>
#include <string>
#include <vector>

namespace odo {

/// A registered camera of a set-up.
struct AdvisedCamera
{
    std::string name;
    FloorView view;
    double markerSigmaPx = 0.3; ///< of one coordinate of a marker's pixel, as registrations of it have it
};

/// What is measured there, and how far a camera may be moved.
struct PlacementQuestion
{
    double robotHeightM = 0;
    double sigmaPx = 0.1; ///< of one coordinate of what is followed, as accuracyMap takes it
    double speedMps = 0;  ///< of the robot; what the views' time offset costs grows with it
    double timeSigmaS = 0;
    double reachM = 1; ///< of the farthest position that is tried, along the floor; half of it up and down
};

/// One camera elsewhere, aimed at the middle of the floor, registered again.
struct PlacementMove
{
    std::size_t camera = 0;
    /// To its left, away from the floor's middle, and up, as one sees it who looks along with the camera. In
    /// steps of 10 cm.
    double leftM = 0, backM = 0, upM = 0;
    FloorView view;
    double worstM = 0;  ///< σ where it is largest on the floor between the markers, then
    double middleM = 0; ///< and in its middle
    Message words;      ///< a sentence
};

struct PlacementAdvice
{
    AccuracySummary now;              ///< of all cameras together, as registered again where they are
    std::vector<PlacementMove> moves; ///< at most one a camera, the best first; those that gain a tenth
    std::vector<Message> remarks;     ///< sentences: cameras that cannot be judged
};

/// What moving one of the cameras would bring, by the same account of errors as accuracyMap: pixels, marker
/// pixels, lenses, and half of what a robot goes in the time that the views' offset is uncertain by, in any
/// direction. Of the positions within reach from which the camera shows as much of the floor, and which
/// together with the other cameras have the smallest σ where it is largest, the nearest that brings nine
/// tenths of the gain. Less than a second a camera; any thread. Errors: InvalidInput where no camera sees
/// four markers; Cancelled.
Result<PlacementAdvice> placementAdvice(std::span<const AdvisedCamera> cameras, const MarkerLayout &layout,
                                        const PlacementQuestion &question, const JobControl &control);

} // namespace odo
