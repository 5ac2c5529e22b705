// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_detection.h"

#include <cstddef>
#include <string>
#include <vector>

namespace odo {

/// The markers of a layout that are tags in an image.
struct LayoutTags
{
    std::vector<MarkerPixel> markers; ///< in the layout's order
    std::vector<std::string> missing; ///< labels
    bool byPlace = true;              ///< the tags' numbers are the markers' indices in the layout
};

/// Finds them: tags read, then smaller ones, then those that the others predict. A layout whose labels are
/// numbers (tagLabel) can be read in several ways: by its numbers in each family, or by place. Of these the
/// one counts whose tags fit the layout's positions: each tag is square on the floor and at its position to 3
/// % of the extent (or 6 px), of four markers or more and most of those seen. Where it is no such layout, the
/// tags are those by place, whether they fit or not. InvalidInput: checkTagLabels. Undetermined: a tag is
/// seen twice, two readings fit equally well, or none of those seen fits. Thread-safe.
Result<LayoutTags> findLayoutTags(const Frame &frame, const MarkerLayout &layout, const MarkerSearch &search);

/// How many of the layout's markers are tags in an image, in the reading that has most of them. Families that
/// are read by chance do not count. Thread-safe.
std::size_t countLayoutTags(const Frame &frame, const MarkerLayout &layout);

} // namespace odo
