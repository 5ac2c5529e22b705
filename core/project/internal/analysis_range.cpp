// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/analysis_range.h"

#include <algorithm>

namespace odo {

void keepWithin(const TimeSpan &range, std::vector<AmbiguousName> &names)
{
    std::erase_if(names,
                  [&](const AmbiguousName &one) { return one.to < range.begin || one.from > range.end; });
    for (AmbiguousName &one : names) {
        one.from = std::max(one.from, range.begin);
        one.to = std::min(one.to, range.end);
    }
}

void changeRange(AnalysisRecord &analysis, const std::optional<TimeSpan> &range, const Task *task)
{
    std::vector<AmbiguousName> all =
        std::move(analysis.range ? analysis.allAmbiguousNames : analysis.ambiguousNames);
    changeRange(analysis.profile, analysis.outside, range, task);
    analysis.range = range;
    analysis.ambiguousNames = all;
    analysis.allAmbiguousNames.clear();
    if (!range)
        return;
    keepWithin(*range, analysis.ambiguousNames);
    analysis.allAmbiguousNames = std::move(all);
}

TimeSpan rangeOf(const TrialRecord &trial)
{
    return trial.range.value_or(TimeSpan{Nanoseconds(0), fromSeconds(trial.durationS)});
}

Message rangeSentence(const TrialRecord &trial)
{
    if (!trial.range)
        return {};
    return ODO_TEXT("project.range_sentence", "Range: %1 to %2 of %3; all results are of this part.")(
        quantity(toSeconds(trial.range->begin), 3, "s"), quantity(toSeconds(trial.range->end), 3, "s"),
        quantity(trial.durationS, 3, "s"));
}

} // namespace odo
