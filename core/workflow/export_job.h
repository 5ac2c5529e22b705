// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/file_name.h"
#include "core/exchange/track_export.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

class Project;

/// What the file of a robot's track is called, without its ending: after the trial, and the robot where the
/// trial has several.
std::string exportName(const std::string &trial, const std::string &robot, bool isOneOfSeveral);

/// Writes the newest analysis of each robot of a trial as a CSV file into a folder, named after the trial
/// (and the robot, where there are several). A file of that name is not overwritten: AlreadyExists. NotFound
/// where the trial was never tracked. What was written before a cancel stays.
class ExportJob : public Job
{
public:
    ExportJob(std::string trial, std::filesystem::path folder, CsvStyle style);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    const std::vector<std::filesystem::path> &files() const { return m_files; } ///< after run

private:
    Result<void> writeAll(const JobControl &control);

    std::string m_trial;
    std::filesystem::path m_folder;
    CsvStyle m_style;
    std::vector<AnalysisRecord> m_analyses;
    std::vector<std::filesystem::path> m_files;
};

} // namespace odo
