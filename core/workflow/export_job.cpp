// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/export_job.h"

#include "core/analysis/range/run_range.h"
#include "core/base/file_system.h"
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

namespace odo {

namespace {

Message exportOf(const std::string &trial)
{
    return ODO_TEXT("workflow.export", "export of '%1'")(Named::trial(trial));
}

} // namespace

AnalysisRecord exportedPart(AnalysisRecord analysis, const TrackExport &how)
{
    Profile &profile = analysis.profile;
    if (how.isWhole && analysis.range)
        profile = wholeRun(std::move(profile), analysis.outside);
    if (how.span)
        cutToRange(profile, *how.span);
    profile = inFrame(std::move(profile), how.frame);
    return analysis;
}

const char *endingOf(ExportedFormat format)
{
    return format == ExportedFormat::Csv ? ".csv" : format == ExportedFormat::Tum ? ".tum" : ".txt";
}

Result<void> writeTrack(const AnalysisRecord &part, const TrackExport &how, const TextSink &sink)
{
    switch (how.format) {
    case ExportedFormat::Csv:
        return writeTrackCsv(part, how.style, sink, how.columns, how.unit);
    case ExportedFormat::Tum:
        return writeTrackTum(part, sink);
    case ExportedFormat::Tracker:
        break;
    }
    return writeTrackTracker(part, sink);
}

std::string exportName(const std::string &trial, const std::string &robot, bool isOneOfSeveral)
{
    return fileNameOf(isOneOfSeveral ? trial + " " + robot : trial);
}

ExportJob::ExportJob(std::string trial, std::filesystem::path folder, TrackExport how)
    : m_trial(std::move(trial)), m_folder(std::move(folder)), m_how(std::move(how))
{
}

Result<void> ExportJob::prepare(Project &project)
{
    const auto trial = ODO_TRY(project.trials().find(m_trial));
    auto analyses = ODO_TRY(project.analyses().current(trial.id));
    if (analyses.empty())
        return fail(ErrorCode::NotFound, exportOf(m_trial), notTrackedYet(), trackItFirst());
    m_analyses = std::move(analyses);
    return {};
}

Result<void> ExportJob::run(const JobControl &control)
{
    auto written = writeAll(control);
    if (!written) {
        for (const std::filesystem::path &file : m_files)
            files::remove(file);
        m_files.clear();
    }
    return written;
}

Result<void> ExportJob::writeAll(const JobControl &control)
{
    for (const AnalysisRecord &analysis : m_analyses) {
        if (control.isCancelled())
            return cancelled(exportOf(m_trial));
        const std::filesystem::path file =
            m_folder /
            (exportName(m_trial, analysis.robotName, m_analyses.size() > 1) + endingOf(m_how.format));
        if (auto written = writeOutput(
                {file, Existing::Refuse},
                [&](const TextSink &sink) { return writeTrack(exportedPart(analysis, m_how), m_how, sink); });
            !written)
            return written;
        m_files.push_back(file);
    }
    return {};
}

Result<void> ExportJob::commit(Project &)
{
    return {};
}

} // namespace odo
