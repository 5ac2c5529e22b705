// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <tl/expected.hpp>

namespace odo {

/// A new folder of this process for what is in the making, under a name that nobody can foresee. The destructor removes it with all that is
/// in it, unless publish() gave it its name. It is locked as long as it lives: what a killed program left is removed by the next that makes one
/// of that kind there. One thread.
class ClaimedFolder
{
public:
    /// PARENT/PREFIX-XXXXXX. Removes those of that prefix that belong to nobody any more.
    static tl::expected<ClaimedFolder, std::error_code> make(const std::filesystem::path &parent, const std::string &prefix);
    ~ClaimedFolder();
    ClaimedFolder(ClaimedFolder &&other) noexcept;
    ClaimedFolder &operator=(ClaimedFolder &&) = delete;

    const std::filesystem::path &path() const { return m_path; }
    /// Fails where a file or folder of that name is.
    std::error_code publish(const std::filesystem::path &name);

private:
    ClaimedFolder(std::filesystem::path path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}

    std::filesystem::path m_path; ///< empty: it has its name
    int m_descriptor;
};

} // namespace odo
