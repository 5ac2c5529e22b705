// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_mat.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct MatSettings
{
    std::vector<std::filesystem::path> files; ///< images and videos that show it, of any camera
    /// Length of the line at its lower edge as measured, in metres; nullopt: it was not measured, and the
    /// print is taken as true to scale.
    std::optional<double> checkLineM;
};

/// Finds the printed floor mat in images and videos, in several frames of each (somebody may stand on it),
/// and stores its markers as a layout, unless the project has that one. Errors: none of the files shows a
/// mat, or they show two; a length that no print has.
class FindMatJob : public Job
{
public:
    explicit FindMatJob(MatSettings settings) : m_settings(std::move(settings)) {}
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const FloorMat &mat() const { return *m_mat; }             ///< after run
    std::string layoutName() const { return matName(*m_mat); } ///< after run
    /// After run: whether it was seen in each of the files.
    const std::vector<bool> &isSeen() const { return m_isSeen; }

private:
    Result<void> findIn(const std::filesystem::path &file, const JobControl &control);

    MatSettings m_settings;
    std::optional<FloorMat> m_mat;
    std::vector<bool> m_isSeen;
};

} // namespace odo
