// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/internal/table_columns.h"

#include <optional>
#include <string_view>
#include <vector>

namespace odo {

/// The columns of a file that begins with this row, without a header: the poses of TUM and KITTI (blanks part
/// their cells), a message of `ros2 topic echo --csv` (PointStamped, PoseStamped, PoseWithCovarianceStamped,
/// TransformStamped, Odometry), or else three columns that may be time, x and y (areAssumed). nullopt: it is
/// not known what they are.
std::optional<TableColumns> headerlessColumns(const std::vector<std::string_view> &cells, char delimiter);

/// Whether a column of numbers may be times: they rise, and count from 1970 or come in steps of one length
/// but for rounding and gaps, as no robot's coordinate does.
bool mayBeTimes(const std::vector<long double> &stamps);

} // namespace odo
