// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/user_folders.h"

#include <cstdlib>

namespace odo {

std::filesystem::path stateFolder()
{
    if (const char *folder = std::getenv("XDG_STATE_HOME"); folder && folder[0] == '/')
        return std::filesystem::path(folder) / "odograph";
    if (const char *home = std::getenv("HOME"); home && home[0] == '/')
        return std::filesystem::path(home) / ".local/state/odograph";
    return {};
}

std::filesystem::path homeFolder()
{
    const char *home = std::getenv("HOME");
    return home ? home : "";
}

std::filesystem::path temporaryFolder()
{
    const char *told = std::getenv("TMPDIR");
    return told ? told : "/tmp";
}

} // namespace odo
