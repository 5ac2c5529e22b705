// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/video/frame.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A mat for the floor: sheets of paper in landscape that are taped to one another, with AprilTags 36h11 at
/// known positions. A tag's number says on which paper it is printed and at which sheet, so a mat of any size
/// is recognised by what is seen of it.
struct FloorMat
{
    enum class Paper { A4, Letter, A3 };
    static constexpr int mostColumns = 10, mostRows = 8;

    Paper paper = Paper::A4;
    int columns = 4, rows = 3; ///< of sheets, 1 to mostColumns and mostRows
    /// A length of the print as measured, over the length it should have.
    double scale = 1;

    bool operator==(const FloorMat &) const = default;
};

/// What one sheet adds to the mat, width and height in metres: its paper without a margin at each edge.
Eigen::Vector2d matSheetM(FloorMat::Paper paper);
/// What is covered by a sheet's neighbours or cut off, at each edge, in metres.
inline constexpr double matMarginM = 0.010;
/// Side of a tag's black square, in metres.
inline constexpr double matTagM = 0.140;

/// The lengths that the line at the lower edge, by which a print is checked, may have, in metres.
inline constexpr double matLinesM[] = {1, 0.2};
/// The longest of them that a mat has room for. It begins at matLineStartM.
double matLineM(const FloorMat &mat);
/// From the lower left corner of the mat, in metres.
inline const Eigen::Vector2d matLineStartM(0.015, 0.005);

struct MatTag
{
    int number = 0;
    /// From the lower left corner of its sheet, in metres, y away from its lower edge.
    Eigen::Vector2d middle;
};

/// The tags of one sheet, counted from the lower left one, as they should be printed.
std::vector<MatTag> matTags(FloorMat::Paper paper, int column, int row);

/// Its tags as a layout, labelled by their numbers. The world's origin is the mat's lower left corner, x goes
/// along the lower edge. Named by matName.
MarkerLayout matLayout(const FloorMat &mat);
/// "Mat A4 4x3"; with a print of another scale "Mat A4 4x3, 98.5 %".
std::string matName(const FloorMat &mat);

/// The smallest mat that has all tags seen in an image, four or more; those that are not where the others say
/// or of another size (tags of something else) do not count. nullopt: there is none. Its scale is 1.
/// Thread-safe.
std::optional<FloorMat> findMat(const Frame &frame);

/// One that has the sheets of both. nullopt: of different paper.
std::optional<FloorMat> joined(const FloorMat &one, const FloorMat &other);

} // namespace odo
