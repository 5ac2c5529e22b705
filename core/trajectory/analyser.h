// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/task.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/geometry/floor_view.h"
#include "core/tracking/observation.h"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// How the curves are made from the samples.
enum class Smoother {
    Rts,     ///< Kalman filter and Rauch–Tung–Striebel smoother, process noise estimated from the data
    SavGol,  ///< Savitzky–Golay, cubic, 11 points
    Tracker, ///< the differences that Tracker uses
    None,    ///< the paper's raw differences
};
/// "rts", "savgol", "tracker", "none"; NotFound for another word.
Result<Smoother> parseSmoother(std::string_view name);
std::string_view smootherName(Smoother smoother);

/// One view's part of a trial for one robot.
struct ViewTrack
{
    std::string view; ///< camera's name
    std::optional<FloorView>
        floorView;              ///< empty: the camera is not registered; its observations are left out
    Nanoseconds startOffset{0}; ///< how much later this view's first frame was taken than the first view's
    std::vector<Observation> observations; ///< in order of time
    /// by how much its clock runs faster than the first view's (core/trajectory/analyser.h)
    double clockRate = 0;
    double startOffsetSigmaS = 0; ///< 0: not measured
    /// own times of the frames before which an unknown time passed: no motion is measured across
    std::vector<Nanoseconds> breaks = {};
};

struct RobotShape
{
    /// Height of the robot's top; empty: estimated from the views' disagreement (one view alone: taken as 0).
    std::optional<double> heightM;
    std::optional<double> lengthM, widthM;
    bool heightVaries = false; ///< on a ramp: triangulated in every frame; heightM is ignored
    /// forward and left from the footprint's centre: the point whose path is measured
    Eigen::Vector2d referenceM = Eigen::Vector2d::Zero();
};

/// A manual override of one sample. The raw measurement is kept in either case.
struct ManualOverride
{
    std::int64_t frame = 0; ///< of the first view
    bool isSpike = false;   ///< true: it is not used; false: it is, whatever speaks against it
    bool operator==(const ManualOverride &) const = default;
};

struct AnalysisOptions
{
    Smoother smoother = Smoother::Rts;
    double maxSpeedMps = 10; ///< physical limit, for flags
    double maxAccelMps2 = 50;
    Nanoseconds longestBridgedGap = std::chrono::milliseconds(1500);
    /// at most one a frame; for frames that are not there without effect
    std::vector<ManualOverride> overrides = {};
    std::optional<Task> task = {}; ///< its gates and path are measured (withTask)
};

/// The options for a task: its limits, if it sets any, replace the previous ones.
AnalysisOptions withTask(AnalysisOptions options, const Task &task);

/// Observations of all views → samples → spikes → profile → metrics. Times of the samples are the first
/// view's frame times; other views are interpolated to them. Pure and thread-safe. Errors: no view
/// registered, robot never found, a reference point other than the footprint's centre, with outlines
/// that show no heading.
Result<Profile> analyse(const std::vector<ViewTrack> &views, const RobotShape &shape,
                        const AnalysisOptions &options);

/// What analyse() finds of views that contradict each other for a reason (Profile::contradiction), from the
/// same observations; nullopt also where it would fail. Pure and thread-safe.
std::optional<ViewsContradiction> contradictionOf(const std::vector<ViewTrack> &views,
                                                  const RobotShape &shape);

/// Sets ByHand on the samples that a person has judged: with Jump where it is called a spike, without any
/// flag that rejects where it is called valid. Samples without a position have nothing to judge and stay as
/// they are. Whoever flags samples afterwards leaves those alone.
void applyOverrides(std::vector<Sample> &samples, std::span<const ManualOverride> overrides);

/// The list with one more word, in place of an older one on the same frame, in order of the frames.
std::vector<ManualOverride> withOverride(std::vector<ManualOverride> overrides, ManualOverride added);

/// The list without any word on a frame.
std::vector<ManualOverride> withoutOverride(std::vector<ManualOverride> overrides, std::int64_t frame);

/// Offset and rate of a view's own clock (zero at its first frame) against the first view's, in which all
/// times are given.
struct ViewClock
{
    Nanoseconds startOffset{0}; ///< how much later this view's first frame was taken than the first view's
    double rate = 0;            ///< by how much its clock runs faster: 2e-4 gains 0.2 ms a second

    /// Time of the first view's clock at a time of the own one; exact where the rates are equal.
    Nanoseconds commonTime(Nanoseconds own) const
    {
        const double gained = static_cast<double>(own.count()) * rate / (1 + rate);
        return startOffset + own - Nanoseconds(std::llround(gained));
    }
    /// The other way.
    Nanoseconds ownTime(Nanoseconds common) const
    {
        const Nanoseconds since = common - startOffset;
        return since + Nanoseconds(std::llround(static_cast<double>(since.count()) * rate));
    }
};

/// The clock of anything that has a start offset and a clock rate: ViewTrack, NamedView.
template <class View>
ViewClock clockOf(const View &view)
{
    return {view.startOffset, view.clockRate};
}

/// When, on the first view's clock, something stamped by the view's own clock was seen (an Observation).
template <class View, class Stamped>
Nanoseconds timeOf(const View &view, const Stamped &stamped)
{
    return clockOf(view).commonTime(stamped.time);
}

} // namespace odo
