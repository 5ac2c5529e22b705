// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/project_archive.h"

#include "core/project/new_file.h"

#include <archive.h>
#include <archive_entry.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace odo {

namespace {

constexpr std::size_t blockBytes = 1 << 16;
constexpr std::size_t mostEntries = 1'000'000;
/// What may be unpacked for each byte of the archive, and in any case: videos do not shrink, projects to a twentieth.
constexpr std::uintmax_t mostGrowth = 100, alwaysAllowedBytes = 16 << 20;
constexpr const char *roomAdvice = "check the free space and the rights of its folder";

struct Free
{
    void operator()(archive_entry *entry) const { archive_entry_free(entry); }
};
using Entry = std::unique_ptr<archive_entry, Free>;

std::string problemOf(archive *handle)
{
    const char *words = archive_error_string(handle);
    return words ? words : "the archive library refused";
}

/// An archive in the making, gone again unless it was published.
class Writer
{
public:
    explicit Writer(std::filesystem::path target)
        : m_target(std::move(target)), m_part(m_target.string() + ".part"), m_archive(archive_write_new()),
          m_descriptor(::open(m_part.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644))
    {
    }
    ~Writer()
    {
        archive_write_free(m_archive);
        if (m_descriptor < 0)
            return;
        ::close(m_descriptor);
        ::unlink(m_part.c_str()); // not there any more once it was published
    }
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;

    Result<void> open()
    {
        if (m_descriptor < 0)
            return failure(std::strerror(errno));
        if (archive_write_set_format_zip(m_archive) != ARCHIVE_OK ||
            archive_write_open_fd(m_archive, m_descriptor) != ARCHIVE_OK)
            return failure(problemOf(m_archive));
        return {};
    }

    /// written: called with how much was written each time; false stops.
    template <class Written>
    Result<void> add(const ArchiveEntry &file, const Written &written)
    {
        std::error_code problem;
        const auto bytes = std::filesystem::file_size(file.file, problem);
        std::ifstream in(file.file, std::ios::binary);
        if (problem || !in)
            return fail(ErrorCode::Io, "pack '" + file.file.string() + "'",
                        problem ? problem.message() : "it cannot be read",
                        "check that it is there and may be read");
        const bool isProject = file.name.find('/') == std::string::npos;
        if (isProject)
            archive_write_zip_set_compression_deflate(m_archive);
        else
            archive_write_zip_set_compression_store(m_archive);
        const Entry entry(archive_entry_new());
        archive_entry_set_pathname_utf8(entry.get(), file.name.c_str());
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes));
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0644);
        if (archive_write_header(m_archive, entry.get()) != ARCHIVE_OK)
            return failure(problemOf(m_archive));
        std::vector<char> block(blockBytes);
        for (std::uintmax_t left = bytes; left > 0;) {
            in.read(block.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(left, blockBytes)));
            const auto count = static_cast<std::size_t>(in.gcount());
            if (count == 0)
                return fail(ErrorCode::Io, "pack '" + file.file.string() + "'",
                            "it has become shorter meanwhile",
                            "wait until nobody writes to it, and try again");
            if (archive_write_data(m_archive, block.data(), count) != static_cast<la_ssize_t>(count))
                return failure(problemOf(m_archive));
            left -= count;
            if (!written(count))
                return cancelled("pack '" + m_target.string() + "'");
        }
        return {};
    }

    Result<void> publish()
    {
        if (archive_write_close(m_archive) != ARCHIVE_OK)
            return failure(problemOf(m_archive));
        if (::fsync(m_descriptor) != 0 || ::rename(m_part.c_str(), m_target.c_str()) != 0)
            return failure(std::strerror(errno));
        syncToDisk(std::filesystem::absolute(m_target).parent_path());
        return {};
    }

private:
    tl::unexpected<Error> failure(const std::string &why) const
    {
        return fail(ErrorCode::Io, "cannot write '" + m_target.string() + "'", why, roomAdvice);
    }

    const std::filesystem::path m_target, m_part;
    archive *const m_archive;
    const int m_descriptor;
};

/// Unpacks into a folder of its own, which is gone again unless it was published.
class Reader
{
public:
    Reader(std::filesystem::path file, std::filesystem::path folder)
        : m_file(std::move(file)), m_folder(std::move(folder)), m_part(m_folder.string() + ".part-XXXXXX"),
          m_archive(archive_read_new())
    {
    }
    ~Reader()
    {
        archive_read_free(m_archive);
        if (!m_made)
            return;
        try {
            std::error_code ignored;
            std::filesystem::remove_all(m_part, ignored); // not there any more once it was published
        } catch (const std::bad_alloc &) { // it stays, under a name that says what it is
        }
    }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;

    Result<void> open()
    {
        std::error_code problem;
        if (std::filesystem::exists(m_folder, problem))
            return fail(ErrorCode::AlreadyExists, "unpack into '" + m_folder.string() + "'",
                        "it is there already", "choose a folder that is not there yet");
        archive_read_support_format_zip(m_archive);
        if (archive_read_open_filename(m_archive, m_file.c_str(), blockBytes) != ARCHIVE_OK)
            return refuse(problemOf(m_archive));
        m_archiveBytes = std::filesystem::file_size(m_file, problem);
        if (problem)
            m_archiveBytes = 0;
        std::filesystem::create_directories(std::filesystem::absolute(m_part).parent_path(), problem);
        // A name that nobody has, so that what a killed attempt left behind is in nobody's way.
        std::string name = m_part.string();
        m_made = ::mkdtemp(name.data()) != nullptr;
        if (!m_made)
            return failure(std::strerror(errno));
        m_part = name;
        ::chmod(m_part.c_str(), 0755); // as any folder
        return {};
    }

    Result<void> readAll(const JobControl &control)
    {
        archive_entry *entry = nullptr;
        for (std::size_t count = 0;; ++count) {
            const int code = archive_read_next_header(m_archive, &entry);
            if (code == ARCHIVE_EOF)
                break;
            if (code != ARCHIVE_OK || count > mostEntries)
                return refuse(code != ARCHIVE_OK ? problemOf(m_archive) : "it has too many files");
            if (archive_entry_filetype(entry) == AE_IFDIR)
                continue;
            if (auto read = readEntry(entry, control); !read)
                return read;
        }
        return m_project.empty() ? refuse("there is no project in it") : Result<void>();
    }

    Result<std::filesystem::path> publish()
    {
        std::error_code problem;
        std::filesystem::rename(m_part, m_folder, problem);
        if (problem)
            return failure(problem.message());
        return m_folder / m_project;
    }

private:
    /// The project comes first, and says what may follow.
    Result<void> readEntry(archive_entry *entry, const JobControl &control)
    {
        const char *utf8 = archive_entry_pathname_utf8(entry);
        const std::filesystem::path name = utf8 ? utf8 : "";
        if (archive_entry_filetype(entry) != AE_IFREG || !mayBe(name))
            return refuse('\'' + name.string() + "' does not belong into a packed project");
        if (m_project.empty())
            m_project = name;
        const std::filesystem::path target = m_part / name;
        std::error_code problem;
        std::filesystem::create_directories(target.parent_path(), problem);
        const int descriptor =
            ::open(target.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0644);
        if (descriptor < 0 && errno == EEXIST)
            return refuse('\'' + name.string() + "' is in it twice");
        if (descriptor < 0)
            return failure(std::strerror(errno));
        auto copied = copyData(descriptor, control);
        if (copied && ::fsync(descriptor) != 0)
            copied = failure(std::strerror(errno));
        ::close(descriptor);
        return copied;
    }

    bool mayBe(const std::filesystem::path &name) const
    {
        if (name.empty() || name.is_absolute() || name != name.lexically_normal())
            return false;
        const auto parts = std::distance(name.begin(), name.end());
        if (m_project.empty())
            return parts == 1 && name.extension() == ".odo" && !name.stem().empty();
        return parts > 1 && name.begin()->string() == m_project.stem().string() + ".media" &&
               std::ranges::none_of(name, [](const auto &part) { return part == ".." || part.empty(); });
    }

    Result<void> copyData(int descriptor, const JobControl &control)
    {
        std::vector<char> block(blockBytes);
        for (;;) {
            if (control.isCancelled())
                return cancelled("unpack '" + m_file.string() + "'");
            const la_ssize_t count = archive_read_data(m_archive, block.data(), block.size());
            if (count == 0)
                return {};
            if (count < 0)
                return refuse(problemOf(m_archive));
            m_unpackedBytes += static_cast<std::uintmax_t>(count);
            if (m_unpackedBytes > alwaysAllowedBytes + mostGrowth * m_archiveBytes)
                return refuse("it unpacks to more than a hundred times its size");
            for (la_ssize_t at = 0; at < count;) {
                const ssize_t written =
                    ::write(descriptor, block.data() + at, static_cast<std::size_t>(count - at));
                if (written < 0)
                    return failure(std::strerror(errno));
                at += written;
            }
            const auto read = static_cast<double>(archive_filter_bytes(m_archive, -1));
            control.report(std::min(1.0, read / static_cast<double>(m_archiveBytes)), "unpacking");
        }
    }

    tl::unexpected<Error> failure(const std::string &why) const
    {
        return fail(ErrorCode::Io, "unpack into '" + m_folder.string() + "'", why, roomAdvice);
    }
    tl::unexpected<Error> refuse(const std::string &why) const
    {
        return fail(ErrorCode::InvalidInput, "unpack '" + m_file.string() + "'", why,
                    "choose a file that Odograph has packed, and copy it anew if it is damaged");
    }

    const std::filesystem::path m_file, m_folder;
    std::filesystem::path m_part;
    archive *const m_archive;
    bool m_made = false;
    std::filesystem::path m_project;
    std::uintmax_t m_archiveBytes = 0, m_unpackedBytes = 0;
};

} // namespace

Result<void> writeArchive(const std::filesystem::path &archive, const std::vector<ArchiveEntry> &entries,
                          const JobControl &control)
{
    std::uintmax_t all = 1, done = 0;
    for (const ArchiveEntry &entry : entries) {
        std::error_code problem;
        const auto bytes = std::filesystem::file_size(entry.file, problem);
        all += problem ? 0 : bytes;
    }
    Writer writer(archive);
    if (auto opened = writer.open(); !opened)
        return opened;
    for (const ArchiveEntry &entry : entries) {
        const auto written = [&](std::size_t count) {
            done += count;
            control.report(static_cast<double>(done) / static_cast<double>(all), "packing " + entry.name);
            return !control.isCancelled();
        };
        if (auto added = writer.add(entry, written); !added)
            return added;
    }
    return writer.publish();
}

Result<std::filesystem::path> unpackArchive(const std::filesystem::path &archive,
                                            const std::filesystem::path &folder, const JobControl &control)
{
    Reader reader(archive, folder);
    if (auto opened = reader.open(); !opened)
        return tl::unexpected(opened.error());
    if (auto read = reader.readAll(control); !read)
        return tl::unexpected(read.error());
    return reader.publish();
}

} // namespace odo
