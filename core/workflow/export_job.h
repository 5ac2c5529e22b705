// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/file_name.h"
#include "core/exchange/track_export.h"
#include "core/exchange/track_frame.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

enum class ExportedFormat { Csv, Tracker, Tum };

/// How a track is written to a file.
struct TrackExport
{
    ExportedFormat format = ExportedFormat::Csv;
    CsvStyle style = CsvStyle::Analysis;
    std::vector<std::size_t> columns = {};   ///< of CSV; empty: all
    CsvLength unit = CsvLength::Millimetres; ///< of CSV
    TrackFrame frame = TrackFrame::Floor;
    bool isWhole = false;              ///< also what the trial's range leaves out
    std::optional<TimeSpan> span = {}; ///< only that part of it; both ends included
};

/// An analysis with the samples and points that such a file has, in its axes. Pure.
AnalysisRecord exportedPart(AnalysisRecord analysis, const TrackExport &how);
/// Of exportedPart. Errors: those of the sink.
Result<void> writeTrack(const AnalysisRecord &part, const TrackExport &how, const TextSink &sink);
const char *endingOf(ExportedFormat format); ///< ".csv"

/// What the file of a robot's track is called, without its ending: after the trial, and the robot where the
/// trial has several.
std::string exportName(const std::string &trial, const std::string &robot, bool isOneOfSeveral);

/// Writes the newest analysis of each robot of a trial as a file into a folder, named after the trial
/// (and the robot, where there are several). A file of that name is not overwritten: AlreadyExists. NotFound
/// where the trial was never tracked. What was written before a cancel stays.
class ExportJob : public Job
{
public:
    ExportJob(std::string trial, std::filesystem::path folder, TrackExport how);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    const std::vector<std::filesystem::path> &files() const { return m_files; } ///< after run

private:
    Result<void> writeAll(const JobControl &control);

    std::string m_trial;
    std::filesystem::path m_folder;
    TrackExport m_how;
    std::vector<AnalysisRecord> m_analyses;
    std::vector<std::filesystem::path> m_files;
};

} // namespace odo
