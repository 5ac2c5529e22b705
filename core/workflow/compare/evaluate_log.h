// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/evaluation/log_evaluation.h"
#include "core/base/job_control.h"
#include "core/exchange/table/track_reading.h"
#include "core/workflow/compare/compare_trials.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A robot's own log of a trial, and how it is held against what was measured.
struct EvaluateSettings
{
    std::string trial, robot;
    std::filesystem::path log;
    TrackReading reading = {}; ///< what a person says of the file
    LogAlignment alignment = LogAlignment::Se2;
    double deltaM = 1;
    std::optional<double> offsetS; ///< is added to the log's times to give the trial's; empty: estimated
};

struct EvaluatedLog
{
    LogEvaluation evaluation; ///< of times since the log's first pose
    double offsetS = 0;       ///< is added to the log's own times, half-way through what was compared
    TrackFormat format = TrackFormat::Csv;
    std::size_t positions = 0;     ///< of the log
    std::vector<Message> facts;    ///< how it was read
    std::vector<Message> warnings; ///< whole sentences
};

/// "evaluation of trial 'run 1'"
Message evaluationSubject(const std::string &trial);

/// Reads the log as a finished track is read (readTrackFile; of several tracks the robot's) and holds it
/// against a run of the robot. Stores nothing. Any thread; asks for cancellation. Errors: those of
/// readTrackFile and of evaluateLog.
Result<EvaluatedLog> evaluateLogFile(const ComparedTrial &run, const EvaluateSettings &settings,
                                     const JobControl &control);

} // namespace odo
