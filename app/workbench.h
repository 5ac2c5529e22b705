// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/files/output_file.h"
#include "ui/main_window/project_pages.h"

#include <QSize>
#include <filesystem>
#include <optional>
#include <string>

namespace odo {

/// Opens the window, with a project or with the welcome page, and returns when the user has closed it. What
/// is wrong with the project is told there.
void runWorkbench(const std::optional<std::filesystem::path> &project);

/// The window as a user would see it with a trial in one of its modes, painted without a display into a
/// picture file. WrongCall where its name is of no format, Cancelled, and those of opening the project and
/// writing the picture.
Result<void> paintWorkbench(const std::filesystem::path &project, const std::string &trial, WindowMode mode,
                            QSize size, const OutputTarget &picture, const CancelToken &cancel);

} // namespace odo
