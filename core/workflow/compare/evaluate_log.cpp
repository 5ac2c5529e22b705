// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/evaluate_log.h"

#include "core/exchange/table/track_file.h"
#include "core/files/protected_files.h"
#include "core/trajectory/imported_track.h"
#include "core/workflow/import/track_of_robot.h"

#include <algorithm>

namespace odo {

Message evaluationSubject(const std::string &trial)
{
    return ODO_TEXT("workflow.evaluation_of_trial", "evaluation of trial '%1'")(Named::trial(trial));
}

Result<EvaluatedLog> evaluateLogFile(const ComparedTrial &run, const EvaluateSettings &settings,
                                     const JobControl &control)
{
    ODO_TRY(checkMayBeRead(settings.log, quotedName(Named::file(settings.log))));
    auto file = ODO_TRY(readTrackFile(settings.log, settings.reading, control));
    EvaluatedLog result;
    result.format = file.format;
    FileTrack track = ODO_TRY(trackOfRobot(std::move(file), settings.robot, settings.log));
    const Nanoseconds zero = track.positions.front().time;
    const ImportedSeries series(track.positions, leastImportedNoiseM);
    std::vector<LogPose> log;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const Sample sample = series.sample(i);
        if (!sample.position)
            continue;
        LogPose &pose = log.emplace_back();
        pose.timeS = toSeconds(sample.time - zero);
        pose.position = *sample.position;
        if (sample.heading)
            pose.headingRad = sample.heading->radians;
    }
    result.positions = log.size();
    EvaluationOptions options;
    options.alignment = settings.alignment;
    options.deltaM = settings.deltaM;
    if (settings.offsetS)
        options.offsetS = *settings.offsetS + toSeconds(zero);
    result.evaluation =
        ODO_TRY(evaluateLog(run.analysis.profile, log, options, quotedFileSubject(settings.log)));
    if (control.isCancelled())
        return cancelled(evaluationSubject(settings.trial));
    result.offsetS = result.evaluation.clock.offsetS - toSeconds(zero);
    result.facts = std::move(track.facts);
    for (Message &notice : track.notices)
        result.warnings.push_back(
            joined({quotedName(Named::file(settings.log.filename())), std::move(notice)}, Join::Colon));
    for (const Message &remark : result.evaluation.remarks)
        result.warnings.push_back(
            joined({quotedName(Named::file(settings.log.filename())), remark}, Join::Colon));
    return result;
}

} // namespace odo
