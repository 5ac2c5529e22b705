// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/report_maker.h"

#include "core/project/project.h"
#include "ui/models/comparison_scene.h"
#include "ui/report/internal/class_report.h"
#include "ui/report/internal/comparison_report.h"

namespace odo {

Message reportSubject()
{
    return ODO_TEXT("ui.report", "report");
}

namespace {

Result<void> give(const ReportPages &pages, const PageSink &sink, const JobControl &control)
{
    for (const ReportPage &page : pages) {
        if (control.isCancelled())
            return cancelled(reportSubject());
        ODO_TRY(sink(page));
    }
    return {};
}

} // namespace

ReportMaker trialReports(std::vector<std::string> trials, const ReportOptions &options)
{
    return [trials = std::move(trials), options](Project &project, const JobControl &control,
                                                 const PageSink &sink) -> Result<void> {
        constexpr std::size_t few = 12;
        TrialContentReader reader(project,
                                  trials.size() > few ? StillMoment::KeyFrame : StillMoment::TopSpeed);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            if (control.isCancelled())
                return cancelled(reportSubject());
            control.report(double(i) / double(trials.size()), nameAlone(Named::trial(trials[i])));
            const auto content = ODO_TRY(reader.read(trials[i], control.cancel));
            ODO_TRY(give(trialPages(content, options), sink, control));
        }
        return {};
    };
}

ReportMaker comparisonReport(CompareSettings settings, const ReportOptions &options)
{
    return [settings = std::move(settings), options](Project &project, const JobControl &control,
                                                     const PageSink &sink) -> Result<void> {
        control.report(0, {});
        const auto scene = ODO_TRY(loadComparisonScene(project, settings));
        return give(comparisonPages(scene, options), sink, control);
    };
}

ReportMaker classReport(ClassReportSettings settings, const ReportOptions &options)
{
    return [settings = std::move(settings), options](Project &project, const JobControl &control,
                                                     const PageSink &sink) -> Result<void> {
        control.report(0, nameAlone(Named::schoolClass(settings.className)));
        const auto content = ODO_TRY(readClassContent(project, settings));
        if (control.isCancelled())
            return cancelled(reportSubject());
        return give(classPages(content, options), sink, control);
    };
}

ReportMaker inTurn(std::vector<ReportMaker> makers)
{
    return [makers = std::move(makers)](Project &project, const JobControl &control,
                                        const PageSink &sink) -> Result<void> {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            const JobControl part{control.cancel, [&](double fraction, const Message &text) {
                                      control.report((double(i) + fraction) / double(makers.size()), text);
                                  }};
            ODO_TRY(makers[i](project, part, sink));
        }
        return {};
    };
}

} // namespace odo
