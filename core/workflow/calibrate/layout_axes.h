// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/world_axes.h"
#include "core/project/records.h"

#include <string>
#include <vector>

namespace odo {

class Project;

struct LayoutAxesOutcome
{
    LayoutRecord layout; ///< in the new axes
    AxesTransform newFromOld;
    std::vector<std::string> cameras; ///< whose registrations were carried along
    /// with gates or a path, which stay where they are in the axes that were
    std::vector<std::string> tasks;
};

/// Changes the world axes of a layout in one transaction: the layout's places, and a new revision of the
/// registration of each camera that stands on it, also of those registered through such a camera ("C through
/// B") with their own layouts. Older revisions, and the analyses made with them, stay in the old axes.
/// Project's thread; quick.
Result<LayoutAxesOutcome> changeLayoutAxes(Project &project, const std::string &layout,
                                           const AxesChange &change);

} // namespace odo
