// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/overrule_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/trajectory/overrules.h"
#include "core/workflow/track_job.h"

#include <algorithm>

namespace odo {

namespace {

Result<AnalysisRecord> chosenAnalysis(const std::vector<AnalysisRecord> &analyses, const OverruleRequest &request)
{
    const std::string what = "trial '" + request.trial + "'";
    std::string names;
    for (const AnalysisRecord &analysis : analyses) {
        if (analysis.robotName == request.robot || (request.robot.empty() && analyses.size() == 1))
            return analysis;
        names += (names.empty() ? "'" : ", '") + analysis.robotName + "'";
    }
    if (analyses.empty())
        return fail(ErrorCode::NotFound, what, "it has not been tracked yet", "run odograph track first");
    if (request.robot.empty())
        return fail(ErrorCode::Undetermined, what, "it has several robots: " + names, "choose one with --robot");
    return fail(ErrorCode::NotFound, what, "robot '" + request.robot + "' was not tracked in it, but " + names,
                "track it, or choose another with --robot");
}

/// How the request named the sample, for messages.
std::string placeText(const OverruleRequest &request)
{
    return request.frame ? "frame " + std::to_string(*request.frame)
                         : formatNumber(request.timeS.value_or(0), 3) + " s";
}

Result<Sample> chosenSample(const std::vector<Sample> &samples, const OverruleRequest &request)
{
    const std::string what = placeText(request) + " of trial '" + request.trial + "'";
    if (samples.empty())
        return fail(ErrorCode::NotFound, what, "the analysis has no sample", "track the trial again");
    const auto distance = [&](const Sample &sample) {
        return request.frame ? std::abs(static_cast<double>(sample.frame - *request.frame))
                             : std::abs(toSeconds(sample.time) - *request.timeS);
    };
    const auto nearest = std::min_element(samples.begin(), samples.end(), [&](const Sample &a, const Sample &b) {
        return distance(a) < distance(b);
    });
    const double interval = toSeconds(samples.back().time - samples.front().time) /
                            static_cast<double>(std::max<std::size_t>(samples.size() - 1, 1));
    if (distance(*nearest) > (request.frame ? 0 : interval))
        return fail(ErrorCode::NotFound, what, "there is no such frame",
                    request.frame ? "choose one from " + std::to_string(samples.front().frame) + " to " +
                                        std::to_string(samples.back().frame)
                                  : "choose a time from " + formatNumber(toSeconds(samples.front().time), 3) + " s to " +
                                        formatNumber(toSeconds(samples.back().time), 3) + " s");
    if (!nearest->position && request.word != OverruleRequest::Word::Clear)
        return fail(ErrorCode::InvalidInput, what, "the robot was not measured there, so there is nothing to judge",
                    "choose a frame with a measurement");
    return *nearest;
}

} // namespace

OverruleJob::OverruleJob(OverruleRequest request) : m_request(std::move(request)) {}

OverruleJob::~OverruleJob() = default;

Result<void> OverruleJob::prepare(Project &project)
{
    const auto trial = project.trials().find(m_request.trial);
    if (!trial)
        return tl::unexpected(trial.error());
    const auto analyses = project.analyses().current(trial->id);
    if (!analyses)
        return tl::unexpected(analyses.error());
    const auto analysis = chosenAnalysis(*analyses, m_request);
    if (!analysis)
        return tl::unexpected(analysis.error());
    const auto sample = chosenSample(analysis->profile.samples, m_request);
    if (!sample)
        return tl::unexpected(sample.error());
    const auto before = project.trials().overrules(trial->id, analysis->robot);
    if (!before)
        return tl::unexpected(before.error());
    m_before = *before;
    m_trial = trial->id;
    m_robot = analysis->robot;
    m_outcome.robot = analysis->robotName;
    m_outcome.frame = sample->frame;
    m_outcome.time = sample->time;
    if (m_request.word == OverruleRequest::Word::Clear) {
        m_overrules = withoutOverrule(m_before, sample->frame);
        if (m_overrules.size() == m_before.size())
            return fail(ErrorCode::NotFound, placeText(m_request) + " of trial '" + m_request.trial + "'",
                        "nothing was said by hand there", "see the flags by_hand in odograph export");
    } else {
        m_overrules = withOverrule(m_before, {sample->frame, m_request.word == OverruleRequest::Word::Spike});
    }
    TrackSettings settings;
    settings.robots = {m_outcome.robot};
    settings.again = true;
    settings.overrules[m_outcome.robot] = m_overrules;
    m_analysis = std::make_unique<TrackJob>(m_request.trial, std::move(settings));
    return m_analysis->prepare(project);
}

Result<void> OverruleJob::run(const JobControl &control)
{
    return m_analysis->run(control);
}

Result<void> OverruleJob::commit(Project &project)
{
    const auto words = [this] {
        const std::string frame = "frame " + std::to_string(m_outcome.frame) + " of " + m_request.trial;
        switch (m_request.word) {
        case OverruleRequest::Word::Spike:
            return "mark " + frame + " as a spike";
        case OverruleRequest::Word::Valid:
            return "use " + frame;
        case OverruleRequest::Word::Clear:
            break;
        }
        return "leave " + frame + " to the program";
    };
    auto stored = project.change(words(), [&]() -> Result<void> {
        const auto now = project.trials().overrules(m_trial, m_robot);
        if (!now)
            return tl::unexpected(now.error());
        if (*now != m_before)
            return fail(ErrorCode::InvalidInput, placeText(m_request) + " of trial '" + m_request.trial + "'",
                        "another sample was judged by hand while this one was analysed", "say it again for frame " + std::to_string(m_outcome.frame));
        if (auto said = project.trials().setOverrules(m_trial, m_robot, m_overrules); !said)
            return said;
        return m_analysis->commit(project);
    });
    if (!stored)
        return stored;
    m_outcome.analysis = m_analysis->outcome().robots.front().analysis;
    for (const Sample &sample : m_outcome.analysis.profile.samples) {
        if (sample.frame == m_outcome.frame)
            m_outcome.flags = sample.flags;
    }
    return {};
}

} // namespace odo
