// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace odo {

class Project;
class TrackJob;

/// A range as a person gives it, in seconds of the trial's time.
struct RangeSeconds
{
    double from = 0, to = 0;
};
/// From the first motion of all robots to the last (motionSpan).
struct RangeOfMotion
{
};
/// No range: the whole run counts.
struct WholeRun
{
};
using RangeChoice = std::variant<RangeSeconds, RangeOfMotion, WholeRun>;

/// The range that is meant; nullopt: all of the trial. On the project's thread. Errors: WrongCall for one
/// that ends before it begins; InvalidInput for a trial that is being recorded, a range outside of the
/// trial's time or without a position of each robot that was measured; NotFound for motion in a trial that
/// was never tracked; Undetermined where no robot moves.
Result<std::optional<TimeSpan>> resolveRange(Project &project, const TrialRecord &trial,
                                             const RangeChoice &choice);

/// Sets the range of a trial, and reanalyses what is within it by itself: with the registrations that its
/// newest analyses have, so without a range the results are those of before. A trial that was never tracked
/// only gets the range. Does nothing where trial and analyses have it already. Errors: those of
/// resolveRange() and of a reanalysis.
class RangeJob : public Job
{
public:
    RangeJob(std::string trial, RangeChoice choice);
    ~RangeJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< one change, or part of one

    const std::optional<TimeSpan> &range() const { return m_range; } ///< after prepare

private:
    std::string m_trial;
    RangeChoice m_choice;
    RecordId m_id = 0;
    std::optional<TimeSpan> m_range;
    bool m_isSet = false; ///< already
    std::unique_ptr<TrackJob> m_analysis;
};

/// Words of the change.
Message rangeChange(const std::string &trial, const RangeChoice &choice);

/// The Undetermined of a robot without a position in the range of its trial.
tl::unexpected<Error> nothingMeasuredInRange(const std::string &robot, const std::string &trial,
                                             const TimeSpan &range);

} // namespace odo
