// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/text_file.h"
#include "core/project/records.h"
#include "core/project/verdict_repository.h"

#include <QJsonValue>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// A whole trial as one JSON document named "odograph.trial" with a version: trial,
/// synchronisation, views, and for each robot its provenance, metrics, times at gates, spikes, and the
/// columns of the CSV export; and the verdict on it. What is missing is null.
std::string trialJson(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings,
                      const std::vector<AnalysisRecord> &analyses,
                      const std::vector<ImportedTrack> &imported = {}, const TrialVerdict &verdict = {});
/// The same to a sink, with as little in memory as one column's headings.
Result<void> writeTrialJson(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings,
                            std::span<const AnalysisRecord> analyses,
                            const std::vector<ImportedTrack> &imported, const TrialVerdict &verdict,
                            const TextSink &sink);

/// {"level", "accepted", "accepted_reason", "checks": [{"code", "level", "text", "arguments"}]}; null of a
/// trial that is not analysed.
QJsonValue verdictJson(const TrialVerdict &verdict);

} // namespace odo
