// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/class_figures.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/trajectory/hampel.h"
#include "core/workflow/counted_trials.h"
#include "core/workflow/trial_scores.h"

#include <set>

namespace odo {

Result<std::map<std::string, ClassFigure>> classFigures(Project &project, const std::string &className,
                                                        const std::string &task,
                                                        const std::vector<std::string> &metrics)
{
    const auto trials = project.trials().all();
    if (!trials)
        return tl::unexpected(trials.error());
    const auto otherwise = project.analyses().trialsMeasuredOtherwise();
    if (!otherwise)
        return tl::unexpected(otherwise.error());
    std::set<RecordId> counted;
    for (const TrialRecord *trial : countedTrials(*trials, className, task, *otherwise).trials)
        counted.insert(trial->id);
    std::map<std::string, ClassFigure> figures;
    for (const std::string &metric : metrics) {
        const auto all = figuresOf(project, metric);
        if (!all)
            return tl::unexpected(all.error());
        std::vector<double> values;
        for (const TrialFigure &figure : *all)
            if (counted.contains(figure.trial))
                values.push_back(figure.metric.value);
        if (!values.empty()) {
            const int runs = int(values.size());
            figures[metric] = {median(std::move(values)), runs};
        }
    }
    return figures;
}

} // namespace odo
