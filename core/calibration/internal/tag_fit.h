// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/tag_detection.h"
#include "core/calibration/internal/tag_labels.h"
#include "core/geometry/camera_model.h"

#include <optional>
#include <vector>

namespace odo {

/// A marker as the tags of an image show it.
struct TagSighting
{
    std::size_t marker = 0; ///< index in the layout
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    std::vector<SeenTag> tags; ///< that make it up
};

/// The markers that a reading of the layout has among the tags; one seen twice twice. A point of several tags
/// needs all of them, and is the mean of their pixels.
std::vector<TagSighting> sightingsOf(const TagRule &rule, const std::vector<SeenTag> &tags);

/// How a reading fits the layout's positions.
struct TagFit
{
    std::vector<TagSighting>
        inliers; ///< that agree on one map of the floor, in the layout's order, each once
    /// Tags that lie on the floor like those, as squares of their size, but where the layout has others.
    std::vector<TagSighting> contradicting;
    std::size_t seen = 0; ///< markers

    bool isAccepted() const;
};

/// camera: to be relied on; without one straight lines are taken for straight. Thread-safe.
TagFit fitTags(const MarkerLayout &layout, const TagRule &rule, const std::vector<TagSighting> &sightings,
               const std::optional<CameraModel> &camera);

/// Puts each point of several tags to the image of the mean of their floor positions, by the map of all
/// markers. Four or more are needed; fewer stay as they are.
void refineGroups(const MarkerLayout &layout, std::vector<TagSighting> &sightings,
                  const std::optional<CameraModel> &camera);

} // namespace odo
