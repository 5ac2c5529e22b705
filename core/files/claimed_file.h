// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <tl/expected.hpp>

namespace odo {

/// A file that nobody else works on: a new one under a name that no file had, or one that is there and is not
/// to go away meanwhile. A name is claimed by giving it to a file, which fails where another one has it,
/// never by asking whether it is free: two programs never get the same. A claim is a lock (flock(2)) that
/// ends with this object or its program, however that ends (HeldFile::isHeld tells). A new file is removed by
/// the destructor unless it is kept: that file, and never another one under its name. Not through links. One
/// thread.
class ClaimedFile
{
public:
    template <class T>
    using Outcome = tl::expected<T, std::error_code>;

    /// A new empty file: STEM + ENDING, STEM_2 + ENDING ..., the first that nobody has, however the file
    /// system compares names.
    static Outcome<ClaimedFile> create(const std::filesystem::path &folder, const std::string &stem,
                                       const std::string &ending);
    /// A new empty file under a name that nobody can foresee and that says that it is in the making
    /// (".new-XXXXXX.part"); publish() gives it its own.
    static Outcome<ClaimedFile> begin(const std::filesystem::path &folder);
    /// One that is there. Several may hold it, and none may remove it.
    /// std::errc::resource_unavailable_try_again where somebody writes or removes it.
    static Outcome<ClaimedFile> hold(const std::filesystem::path &file);

    ClaimedFile() = default; ///< of nothing
    ~ClaimedFile();
    ClaimedFile(ClaimedFile &&other) noexcept;
    ClaimedFile &operator=(ClaimedFile &&other) noexcept;

    const std::filesystem::path &path() const { return m_path; }
    /// How many it has, whatever it is called by now.
    Outcome<std::int64_t> bytes() const;
    /// All of it, behind what was written before.
    std::error_code write(std::span<const char> bytes) const;
    /// All that was written is on the disk.
    std::error_code sync() const;
    /// Of one that was begun: from now on it has a name as those of create().
    std::error_code publish(const std::string &stem, const std::string &ending);
    /// The destructor leaves it. It stays claimed.
    void keep() { m_goes = false; }
    /// Now, though it was kept. Of one that was held: only the claim ends.
    void remove();

private:
    enum class Made { Here, Before };
    ClaimedFile(std::filesystem::path path, int descriptor, Made made);
    void close();

    std::filesystem::path m_path;
    int m_descriptor = -1;
    bool m_isOurs = false, m_goes = false;
};

} // namespace odo
