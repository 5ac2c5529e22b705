// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/project_archive.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_handle.h"
#include "core/files/file_words.h"
#include "core/files/output_file.h"
#include "core/files/protected_files.h"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>

#include <array>
#include <fstream>
#include <memory>
#include <span>

namespace odo {

namespace {

constexpr std::size_t blockBytes = 1 << 16;
constexpr std::size_t mostEntries = 1'000'000;
/// What may be unpacked for each byte of the archive, and in any case: videos do not shrink, projects to a
/// twentieth.
constexpr std::uintmax_t mostGrowth = 100, alwaysAllowedBytes = 16 << 20;

struct Free
{
    void operator()(archive_entry *entry) const { archive_entry_free(entry); }
};
using Entry = std::unique_ptr<archive_entry, Free>;

Message problemOf(archive *handle)
{
    const char *words = archive_error_string(handle);
    return words ? foreignWords(words)
                 : ODO_TEXT("exchange.archive_library_refused", "the archive library failed");
}

Message unpackSubject(const std::filesystem::path &archive)
{
    return ODO_TEXT("exchange.unpack", "unpack '%1'")(Named::file(archive));
}

Message unpackIntoSubject(const std::filesystem::path &folder)
{
    return ODO_TEXT("exchange.unpack_into", "unpack into '%1'")(Named::file(folder));
}

/// An archive in the making.
class Writer
{
public:
    explicit Writer(const OutputTarget &target) : m_target(target), m_archive(archive_write_new()) {}
    ~Writer() { archive_write_free(m_archive); }
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;

    Result<void> open()
    {
        m_output = ODO_TRY(OutputFile::open(m_target, FileKind::Zip));
        if (archive_write_set_format_zip(m_archive) != ARCHIVE_OK ||
            archive_write_open_fd(m_archive, m_output->descriptor()) != ARCHIVE_OK)
            return failure(problemOf(m_archive));
        return {};
    }

    /// written: called with how much was written each time; false stops.
    template <class Written>
    Result<void> add(const ArchiveEntry &file, const Written &written)
    {
        ODO_TRY(checkMayBeRead(file.file, packSubject(file.file)));
        std::error_code problem;
        const auto bytes = files::sizeOf(file.file, problem);
        std::ifstream in(file.file, std::ios::binary);
        if (problem || !in)
            return cannotPack(file.file, problem ? foreignWords(problem.message()) : cannotBeRead());
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
                return fail(ErrorCode::Io, packSubject(file.file),
                            ODO_TEXT("exchange.has_become_shorter", "it has become shorter during packing"),
                            ODO_TEXT("exchange.wait_for_writers",
                                     "wait until no program writes to it, and try again"));
            if (archive_write_data(m_archive, block.data(), count) != static_cast<la_ssize_t>(count))
                return failure(problemOf(m_archive));
            left -= count;
            if (!written(count))
                return cancelled(packSubject(m_target.file));
        }
        return {};
    }

    Result<void> publish()
    {
        if (archive_write_close(m_archive) != ARCHIVE_OK)
            return failure(problemOf(m_archive));
        return m_output->commit();
    }

private:
    tl::unexpected<Error> failure(Message why) const
    {
        return fail(ErrorCode::Io, cannotWriteFile(m_target.file), std::move(why), checkItsFolder());
    }

    const OutputTarget m_target;
    std::unique_ptr<OutputFile> m_output;
    archive *const m_archive;
};

/// Unpacks into a folder of its own.
class Reader
{
public:
    Reader(std::filesystem::path file, std::filesystem::path folder)
        : m_file(std::move(file)), m_folder(std::move(folder)), m_archive(archive_read_new())
    {
    }
    ~Reader() { archive_read_free(m_archive); }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;

    Result<void> open()
    {
        std::error_code problem;
        if (files::exists(m_folder))
            return fail(ErrorCode::AlreadyExists, unpackIntoSubject(m_folder), isThereAlready(),
                        ODO_TEXT("exchange.choose_new_folder", "choose a folder that does not exist yet"));
        ODO_TRY(checkMayBeRead(m_file, unpackSubject(m_file)));
        archive_read_support_format_zip(m_archive);
        if (archive_read_open_filename(m_archive, m_file.c_str(), blockBytes) != ARCHIVE_OK)
            return refuse(problemOf(m_archive));
        m_archiveBytes = files::sizeOf(m_file, problem);
        if (problem)
            m_archiveBytes = 0;
        const std::filesystem::path around = files::absolute(m_folder).parent_path();
        files::makeFolders(around, problem);
        ODO_TRY(checkOutput({m_folder, Existing::Refuse}, std::nullopt));
        m_part = ODO_TRY(TemporaryFolder::make(around, unpackIntoSubject(m_folder)));
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
                return refuse(code != ARCHIVE_OK
                                  ? problemOf(m_archive)
                                  : ODO_TEXT("exchange.too_many_files", "it has too many files"));
            if (archive_entry_filetype(entry) == AE_IFDIR)
                continue;
            ODO_TRY(readEntry(entry, control));
        }
        return m_project.empty() ? refuse(ODO_TEXT("exchange.no_project_inside", "it contains no project"))
                                 : Result<void>();
    }

    Result<std::filesystem::path> publish()
    {
        std::error_code stays;
        files::letAllRead(m_part->path(), stays);
        if (const std::error_code problem = giveFreeName(m_part->path(), m_folder))
            return failure(problem);
        return m_folder / m_project;
    }

private:
    /// The project comes first, and says what may follow.
    Result<void> readEntry(archive_entry *entry, const JobControl &control)
    {
        const char *utf8 = archive_entry_pathname_utf8(entry);
        const std::filesystem::path name = utf8 ? utf8 : "";
        if (archive_entry_filetype(entry) != AE_IFREG || !mayBe(name))
            return refuse(ODO_TEXT("exchange.does_not_belong",
                                   "'%1' does not belong in a packed project")(Named::file(name)));
        if (m_project.empty())
            m_project = name;
        const std::filesystem::path target = m_part->path() / name;
        std::error_code problem;
        files::makeFolders(target.parent_path(), problem);
        const auto file = FileHandle::create(target, FileHandle::Permissions::OwnerWrites);
        if (!file && file.error() == std::errc::file_exists)
            return refuse(ODO_TEXT("exchange.is_in_it_twice", "it contains '%1' twice")(Named::file(name)));
        if (!file)
            return failure(file.error());
        ODO_TRY(copyData(*file, control));
        const std::error_code unsafe = file->sync();
        return unsafe ? failure(unsafe) : Result<void>();
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

    Result<void> copyData(const FileHandle &file, const JobControl &control)
    {
        std::vector<char> block(blockBytes);
        for (;;) {
            if (control.isCancelled())
                return cancelled(unpackSubject(m_file));
            const la_ssize_t count = archive_read_data(m_archive, block.data(), block.size());
            if (count == 0)
                return {};
            if (count < 0)
                return refuse(problemOf(m_archive));
            m_unpackedBytes += static_cast<std::uintmax_t>(count);
            if (m_unpackedBytes > alwaysAllowedBytes + mostGrowth * m_archiveBytes)
                return refuse(ODO_TEXT("exchange.unpacks_too_large",
                                       "it unpacks to more than a hundred times its size"));
            if (const auto problem = file.write(std::span(block).first(static_cast<std::size_t>(count))))
                return failure(problem);
            const auto read = static_cast<double>(archive_filter_bytes(m_archive, -1));
            control.report(std::min(1.0, read / static_cast<double>(m_archiveBytes)),
                           ODO_TEXT("exchange.unpacking", "unpacking"));
        }
    }

    tl::unexpected<Error> failure(const std::error_code &reason) const
    {
        return fail(ErrorCode::Io, unpackIntoSubject(m_folder), foreignWords(reason.message()),
                    checkItsFolder());
    }
    tl::unexpected<Error> refuse(Message why) const
    {
        return fail(ErrorCode::InvalidInput, unpackSubject(m_file), std::move(why),
                    ODO_TEXT("exchange.choose_packed_file",
                             "choose a file that Odograph has packed; if it is damaged, copy it again"));
    }

    const std::filesystem::path m_file, m_folder;
    std::unique_ptr<TemporaryFolder> m_part; ///< gone again unless it was published
    archive *const m_archive;
    std::filesystem::path m_project;
    std::uintmax_t m_archiveBytes = 0, m_unpackedBytes = 0;
};

} // namespace

Message packSubject(const std::filesystem::path &file)
{
    return ODO_TEXT("exchange.pack", "pack '%1'")(Named::file(file));
}

tl::unexpected<Error> cannotPack(const std::filesystem::path &file, Message why)
{
    return fail(ErrorCode::Io, packSubject(file), std::move(why),
                ODO_TEXT("exchange.check_it_is_there", "check that it exists and that you may read it"));
}

Result<void> writeArchive(const OutputTarget &archive, const std::vector<ArchiveEntry> &entries,
                          const JobControl &control)
{
    std::uintmax_t all = 1, done = 0;
    for (const ArchiveEntry &entry : entries) {
        std::error_code problem;
        const auto bytes = files::sizeOf(entry.file, problem);
        all += problem ? 0 : bytes;
    }
    Writer writer(archive);
    ODO_TRY(writer.open());
    for (const ArchiveEntry &entry : entries) {
        const auto written = [&](std::size_t count) {
            done += count;
            control.report(static_cast<double>(done) / static_cast<double>(all),
                           ODO_TEXT("exchange.packing", "packing %1")(Named::file(entry.name)));
            return !control.isCancelled();
        };
        ODO_TRY(writer.add(entry, written));
    }
    return writer.publish();
}

Result<std::filesystem::path> unpackArchive(const std::filesystem::path &archive,
                                            const std::filesystem::path &folder, const JobControl &control)
{
    Reader reader(archive, folder);
    ODO_TRY(reader.open());
    ODO_TRY(reader.readAll(control));
    return reader.publish();
}

} // namespace odo
