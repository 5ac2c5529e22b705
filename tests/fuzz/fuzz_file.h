// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace odo::fuzz {

/// The bytes of a run as a file, for readers that open one by its name. It lies in TMPDIR, which
/// tests/fuzz/fuzz puts into memory, and is written anew for each run.
class File
{
public:
    /// ending: of its name, with the point.
    explicit File(const char *ending)
        : m_path(std::filesystem::temp_directory_path() / ("input_" + std::to_string(::getpid()) + ending)),
          m_descriptor(::open(m_path.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0600))
    {
    }
    ~File()
    {
        ::close(m_descriptor);
        ::unlink(m_path.c_str());
    }
    File(const File &) = delete;
    File &operator=(const File &) = delete;

    const std::filesystem::path &holding(const std::uint8_t *bytes, std::size_t count)
    {
        if (::pwrite(m_descriptor, bytes, count, 0) != static_cast<ssize_t>(count) ||
            ::ftruncate(m_descriptor, static_cast<off_t>(count)) != 0) {
            std::perror("the fuzz target cannot write its file");
            std::abort();
        }
        return m_path;
    }

private:
    const std::filesystem::path m_path;
    const int m_descriptor;
};

} // namespace odo::fuzz
