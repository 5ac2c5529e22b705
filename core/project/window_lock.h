// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/held_file.h"

namespace odo {

/// Held by the window that changes a project, so that a second one shows it for reading only:
/// `<name>.odo.lock` beside the file, gone when the window is. Subcommands do not ask for it: each of their
/// changes is a transaction of its own.
class WindowLock
{
public:
    /// AlreadyExists, with who holds it, while another window does; Io where the folder cannot be written to.
    static Result<std::unique_ptr<WindowLock>> take(const std::filesystem::path &project);

private:
    explicit WindowLock(std::unique_ptr<HeldFile> file) : m_file(std::move(file)) {}
    const std::unique_ptr<HeldFile> m_file;
};

} // namespace odo
