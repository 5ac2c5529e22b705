// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/internal/path_following.h"
#include "core/base/error.h"

#include <optional>
#include <vector>

namespace odo {

/// One run that is to be compared. The profile must outlive the comparison's making.
struct ComparedRun
{
    Message name; ///< in errors
    const Profile *profile = nullptr;
};

struct ComparisonOptions
{
    std::optional<Task> task; ///< that all of them drive; its path and start are used where it has them
    std::optional<AlignBy>
        alignBy; ///< empty: by the first of start gate, motion onset and distance that all runs give
    std::vector<double> handTimesS; ///< by hand: one of each run, as Sample::time
    std::optional<double>
        stationM; ///< by distance: the position along the path; empty: 50 mm past where both have started
    /// The registrations and the robot's solid were the same for all runs, so that calibration displaces them
    /// alike.
    bool shareCalibration = false;
};

/// A run at one station, timed from its aligned moment.
struct StationTime
{
    double timeS = 0;
    double ownSigmaS = 0, commonSigmaS = 0; ///< of the arrival, without the aligned moment's
    double speedMps = 0, sigmaSpeedMps = 0;
    double offsetM = 0; ///< from the common path, to the left of it positive
};

/// A run on the common path.
struct RunOnPath
{
    AlignedMoment aligned;
    double lapShiftM =
        0; ///< what is added to the progress on a closed path, so that the runs are in the same lap
    std::vector<PathProgress> progress; ///< lapShiftM added
    FirstArrivals arrivals;
    std::vector<std::optional<StationTime>> stations; ///< one for each of RunComparison::distancesM

    /// The distance along the path at a time of the run's own, linear between positions; the first or last
    /// one outside them.
    double distanceAtTime(double timeS) const;
};

/// A difference with its σ.
struct Difference
{
    double value = 0, sigma = 0;
    /// Beyond what chance gives in 95 of 100 cases where there is no difference: |value| > 1.96 σ (two-sided,
    /// normal distribution: JCGM 100:2008, table G.1).
    bool isSignificant() const;
};

/// Runs on one common path. Lengths in metres along it, times in seconds.
struct RunComparison
{
    AlignBy alignedBy = AlignBy::StartGate;
    ReferencePath path;       ///< in the direction that was driven
    bool isTasksPath = false; ///< else the path of the first run
    bool shareCalibration = false;
    double originM = 0; ///< of distance 0: the start gate, the given position, else where all have started
    std::vector<double> distancesM; ///< of the stations, at equal steps of 10 mm or more
    std::vector<RunOnPath> runs;    ///< as they were given

    double distanceM(std::size_t station) const { return distancesM[station] - originM; }
    /// How much later a run is at a station than the first one, both timed from their aligned moments;
    /// nullopt where one of them never arrived. σ: that of the positions along the path over the speed (see
    /// Arrival) and the aligned moments'.
    std::optional<Difference> timeDifference(std::size_t run, std::size_t station) const;
    /// The same at any position along the path.
    std::optional<Difference> timeDifferenceAt(std::size_t run, double pathM) const;
};

/// Compares runs at the same positions of one path: the task's, or else the path of the first run. Each run's
/// position is followed along it (followPath), and its first arrival at each station is timed from the moment
/// that counts as the same. σ of a difference: the tracks' own errors are independent; the calibration's
/// displaces positions. If the runs share it, the displacement at one position is the same for both, and what
/// remains is its time at one run's speed minus that at the other's; otherwise both count in full.
/// Displacements at two positions (the gate and the station) count as independent. Pure; any thread. Errors,
/// in one line: InvalidInput for fewer than two runs or a given moment outside a run; Undetermined for a run
/// without motion, without the moment asked for, in the other direction, or without a common stretch.
Result<RunComparison> compareRuns(const std::vector<ComparedRun> &runs, const ComparisonOptions &options);

/// What errors are about before the runs are known, and the InvalidInput of fewer than two.
Message comparisonSubject();
tl::unexpected<Error> takesTwoRuns();

} // namespace odo
