// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/job.h"

#include <memory>
#include <optional>
#include <string>

namespace odo {

class TrackJob;

/// A person's word on one sample of a trial.
struct OverruleRequest
{
    enum class Word {
        Spike, ///< it is not to be used
        Valid, ///< it is to be used, whatever speaks against it
        Clear, ///< what was said by hand is taken back
    };
    std::string trial;
    std::string robot;                 ///< empty: the only one that was tracked in the trial
    std::optional<double> timeS;       ///< the nearest frame is meant; or else
    std::optional<std::int64_t> frame; ///< of the first view
    Word word = Word::Spike;
};

struct OverruleOutcome
{
    std::string robot;
    std::int64_t frame = 0;
    Nanoseconds time{0};
    SampleFlags flags = 0; ///< of the sample in the new analysis
    AnalysisRecord analysis;
};

/// Stores a person's word on a sample and makes a new analysis with it, out of the stored observations; older analyses
/// stay. Errors: the robot was not tracked, no frame at that time, nothing measured there, nothing to take back, another sample was judged
/// between prepare and commit.
class OverruleJob : public Job
{
public:
    explicit OverruleJob(OverruleRequest request);
    ~OverruleJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const OverruleOutcome &outcome() const { return m_outcome; } ///< after commit

private:
    OverruleRequest m_request;
    RecordId m_trial = 0, m_robot = 0;
    std::vector<Overrule> m_before, m_overrules;
    std::unique_ptr<TrackJob> m_analysis;
    OverruleOutcome m_outcome;
};

} // namespace odo
