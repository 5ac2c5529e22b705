// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/recorded_views.h"

#include "core/base/file_system.h"

#include <cmath>

namespace odo {

namespace {

void putInStep(RecordingRecord &record, const EndedView &view, const EndedView &first)
{
    if (!view.clockKnown || !first.clockKnown) {
        record.syncMethod = "none";
        return;
    }
    record.syncMethod = "clock";
    record.startOffsetS = toSeconds(view.taken.front() - first.taken.front());
    record.startOffsetSigmaS = std::hypot(view.clockSigmaS, first.clockSigmaS);
}

} // namespace

Result<std::vector<RecordingRecord>> describeRecordings(const std::vector<EndedView> &views)
{
    std::vector<RecordingRecord> records;
    const EndedView *first = nullptr;
    for (const EndedView &view : views) {
        if (view.taken.empty())
            continue;
        RecordingRecord record = view.record;
        record.position = static_cast<int>(records.size());
        record.frameTimes.clear();
        for (const Nanoseconds taken : view.taken)
            record.frameTimes.push_back(taken - view.taken.front());
        const double lengthS = toSeconds(record.frameTimes.back());
        record.framesPerSecond = lengthS > 0 ? static_cast<double>(view.taken.size() - 1) / lengthS : 0;
        if (!first)
            first = &view;
        else
            putInStep(record, view, *first);
        std::error_code problem;
        record.bytes = static_cast<std::int64_t>(files::sizeOf(view.file, problem));
        if (problem)
            return fail(ErrorCode::Io, "file '" + view.file.string() + "'",
                        "it cannot be looked at (" + problem.message() + ")",
                        "check that the file is there and may be read");
        records.push_back(std::move(record));
    }
    return records;
}

void describeTrial(TrialRecord &trial, const std::vector<RecordingRecord> &recordings)
{
    trial.durationS = toSeconds(recordings.front().frameTimes.back());
    trial.syncMethod = "none";
    if (recordings.size() < 2)
        return;
    trial.syncMethod = recordings[1].syncMethod;
    trial.syncOffsetS = recordings[1].startOffsetS;
    trial.syncOffsetSigmaS = recordings[1].startOffsetSigmaS;
    trial.syncScore = trial.syncMethod == "clock" ? 1 : 0;
}

} // namespace odo
