// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"

#include <span>
#include <string>
#include <vector>

namespace odo {

/// Floor positions in rows along X, from lowerM on, the first row at the smallest Y.
struct FloorGrid
{
    Eigen::Vector2d lowerM = Eigen::Vector2d::Zero();
    double stepM = 0.1;
    int columns = 0, rows = 0;

    Eigen::Vector2d at(int column, int row) const { return lowerM + stepM * Eigen::Vector2d(column, row); }
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// A grid over the layout's markers and a margin about them, of at most so many positions along its longer
/// side.
FloorGrid gridOver(const MarkerLayout &layout, double marginM, int mostAcross = 60);

/// σ to expect of a position at each position of a grid: along the direction in which it is the least sure.
/// Metres, in the order of FloorGrid::index; NaN where no camera sees the position.
struct AccuracyMap
{
    FloorGrid grid;
    std::vector<std::vector<double>> cameraSigmaM; ///< one map a view, in the order of the views
    /// of all views that see the position, joined by their information
    std::vector<double> fusedSigmaM;
};

/// sigmaPx: of one coordinate of the tracked point in the image (the tracker: about 0.1; a click: 0.5).
/// heightM: of the plane. Each view's σ holds the pixel's part and that of its calibration; the calibrations
/// of the views count as independent of one another. Some 2 µs a position and view. Pure; any thread.
AccuracyMap accuracyMap(std::span<const FloorView> views, const FloorGrid &grid, double sigmaPx,
                        double heightM = 0);

/// A camera that is not there yet.
struct PlannedCamera
{
    double heightM = 2;   ///< above the floor
    double distanceM = 2; ///< over the floor, from the point it aims at
    /// from that point to the camera; 0: +X, -90: -Y
    double directionDegrees = -90;
    /// point of the floor in the middle of the image
    Eigen::Vector2d aimM = Eigen::Vector2d::Zero();
    double fieldOfViewDegrees = 60; ///< across the image's width
    int widthPx = 1280, heightPx = 720;

    /// The point of the floor below it.
    Eigen::Vector2d footM() const;
    /// Puts it above that point, aimed at what it is aimed at.
    void moveCameraTo(const Eigen::Vector2d &footM);
};

/// The view such a camera would have if it were registered by these markers with this σ of one coordinate of
/// a marker's pixel: for accuracyMap, before anything is recorded. Its lens counts as known. Refuses a
/// height, distance or field of view that no camera has, and a pose from which it sees fewer than four
/// markers, naming them.
Result<FloorView> plannedView(const PlannedCamera &camera, const MarkerLayout &layout, double sigmaPx = 0.3);

/// What a map of σ says of the floor among the markers (the rectangle about them). Metres.
struct AccuracySummary
{
    double middleM = 0; ///< in its middle; NaN where that is not seen
    double worstM = 0;  ///< where it is largest; NaN where nothing is seen
    double seenPart = 0;
    Message words; ///< "±1.8 mm in the middle, ±6.0 mm in the corner near D." and what is not seen
};

/// sigmaM: one value a position of the grid, NaN where it is not seen. Pure; any thread.
AccuracySummary summariseAccuracy(const FloorGrid &grid, const std::vector<double> &sigmaM,
                                  const MarkerLayout &layout);

/// Allowed camera positions.
struct CameraPositionSearch
{
    double reachM = 2;          ///< so far beyond the rectangle about the markers
    bool aboveTheFloor = false; ///< also within that rectangle, as under a ceiling
    double robotHeightM = 0;    ///< of the plane that counts
    double sigmaPx = 0.1;       ///< of what is followed, as accuracyMap takes it
};

/// The position and aim of one more camera of the given height and lens that shows, with the others, the most
/// of the floor between the markers; among equals the one with the smallest σ at the worst position. Searches
/// a grid of positions with three aims each, then ever finer around the best. Some hundred milliseconds; any
/// thread. Errors: no position sees four markers; Cancelled; those of plannedView for the height and the
/// lens.
Result<PlannedCamera> bestCameraPosition(const PlannedCamera &like, const MarkerLayout &layout,
                                         std::span<const FloorView> others,
                                         const CameraPositionSearch &search, const JobControl &control);

} // namespace odo
