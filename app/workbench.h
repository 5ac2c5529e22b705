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
/// is wrong with the project is shown there.
void runWorkbench(const std::optional<std::filesystem::path> &project);

/// The window as a user would see it with a trial in one of its modes, painted without a display into an
/// image file. Errors: WrongCall for an unknown format, Cancelled, and those of opening the project and
/// writing the image.
Result<void> paintWorkbench(const std::filesystem::path &project, const std::string &trial, WindowMode mode,
                            QSize size, const OutputTarget &image, const CancelToken &cancel);

} // namespace odo
