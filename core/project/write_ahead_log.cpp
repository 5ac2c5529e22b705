// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/write_ahead_log.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_status.h"
#include "core/base/platform/process.h"
#include "core/base/platform/user_folders.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <sqlite3.h>
#include <string>
#include <vector>

namespace odo {

namespace {

constexpr unsigned randomBits = 15; // the others, below SQLite's sign, encode the mark before
constexpr LogMark randomMask = (1U << randomBits) - 1, signlessMask = 0x7fffffff;

std::uint32_t randomNumber()
{
    std::uint32_t number = 0;
    if (fillWithRandom(std::as_writable_bytes(std::span(&number, 1))))
        number = static_cast<std::uint32_t>(std::chrono::steady_clock::now().time_since_epoch().count());
    return number;
}

/// The upper bits of the mark that follows one.
LogMark traceOf(LogMark before)
{
    constexpr std::uint32_t spread = 2'654'435'769; // 2^32 by the golden ratio: neighbours get far apart
    return (before * spread + spread) >> 1U & ~randomMask;
}

// Headers of a database, of a log and of a page in it (https://www.sqlite.org/fileformat.html, section 4.1).
using Header = DatabaseHeader;
constexpr std::size_t headerBytes = std::tuple_size_v<Header>, markOffset = 48, logHeaderBytes = 32,
                      frameHeaderBytes = 24, saltsBytes = 8;
using LogHeader = std::array<std::byte, logHeaderBytes>;

LogMark markIn(std::span<const std::byte> header)
{
    // SQLite takes it for a number with a sign, of no meaning
    const std::uint32_t stored = bigEndian(header, markOffset);
    return stored > signlessMask ? 0U - stored : stored;
}

/// SQLite's sums over a log, section 4.2.
struct LogSums
{
    std::uint32_t first = 0, second = 0;
    bool areBigEndian = false;

    void add(std::span<const std::byte> bytes)
    {
        for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
            first += number(bytes, at) + second;
            second += number(bytes, at + 4) + first;
        }
    }
    bool areAt(std::span<const std::byte> bytes, std::size_t offset) const
    {
        return first == bigEndian(bytes, offset) && second == bigEndian(bytes, offset + 4);
    }

private:
    std::uint32_t number(std::span<const std::byte> bytes, std::size_t at) const
    {
        const std::uint32_t number = bigEndian(bytes, at);
        return areBigEndian ? number : __builtin_bswap32(number);
    }
};

/// A write-ahead log as it is found after a crash.
class Log
{
public:
    /// nullopt where SQLite would find nothing in it.
    static std::optional<Log> in(const DatabaseBytes &bytes, const LogHeader &header)
    {
        constexpr std::uint32_t magic = 0x377f0682, knownFormat = 3'007'000;
        constexpr std::size_t formatAt = 4, pageBytesAt = 8, saltsAt = 16, sumsAt = 24;
        Log log(bytes);
        if ((bigEndian(header, 0) & ~1U) != magic || bigEndian(header, formatAt) != knownFormat)
            return std::nullopt;
        log.m_pageBytes = bigEndian(header, pageBytesAt);
        log.m_sums.areBigEndian = (bigEndian(header, 0) & 1U) != 0;
        log.m_sums.add(std::span(header).first(sumsAt));
        if (!std::has_single_bit(log.m_pageBytes) || log.m_pageBytes < 512 || log.m_pageBytes > 65'536 ||
            !log.m_sums.areAt(header, sumsAt))
            return std::nullopt;
        std::copy_n(header.begin() + saltsAt, saltsBytes, log.m_salts.begin());
        log.m_frames =
            (std::max<std::uintmax_t>(bytes.size(), logHeaderBytes) - logHeaderBytes) / log.frameBytes();
        return log;
    }

    /// How many pages it holds, committed or not: those of a former log follow, with other salts.
    std::uintmax_t writtenFrames() const
    {
        std::uintmax_t written = 0, beyond = m_frames + 1;
        while (beyond - written > 1) {
            const std::uintmax_t middle = written + (beyond - written) / 2;
            (readStart(middle - 1) ? written : beyond) = middle;
        }
        return written;
    }

    /// Whether its first so many pages lead to or from a database with that header. Reads headers alone, and
    /// few of them in most cases: the file holds what the log begins with, or what it ends with.
    bool belongsTo(const Header &header, std::uintmax_t frames) const
    {
        std::uintmax_t first = 0;
        auto start = firstPageAt(first);
        while (!start && ++first < frames)
            start = firstPageAt(first);
        if (first >= frames || isBefore(markIn(header), markIn(*start)))
            return true;
        for (std::uintmax_t frame = frames; frame > first; --frame) {
            start = firstPageAt(frame - 1);
            if (start && *start == header) // written back from it
                return true;
        }
        return false;
    }

    /// How many pages SQLite would take from it: up to the last commit before the first wrong sum. Reads all
    /// of them.
    std::uintmax_t committedFrames() const
    {
        constexpr std::size_t sizeAt = 4, sumsAt = 16;
        LogSums sums = m_sums;
        std::uintmax_t committed = 0;
        std::vector<std::byte> block(static_cast<std::size_t>(frameBytes()));
        for (std::uintmax_t frame = 0; frame < m_frames; ++frame) {
            if (!m_bytes->read(block, positionOf(frame)) || !isOfThisLog(block))
                break;
            sums.add(std::span(block).first(2 * sizeAt));
            sums.add(std::span(block).subspan(frameHeaderBytes));
            if (!sums.areAt(block, sumsAt))
                break;
            if (bigEndian(block, sizeAt) != 0)
                committed = frame + 1;
        }
        return committed;
    }

private:
    explicit Log(const DatabaseBytes &bytes) : m_bytes(&bytes) {}

    std::uintmax_t frameBytes() const { return frameHeaderBytes + m_pageBytes; }
    std::uintmax_t positionOf(std::uintmax_t frame) const { return logHeaderBytes + frame * frameBytes(); }
    /// A page with its header and its own first bytes; nullopt where it is not of this log.
    std::optional<std::array<std::byte, frameHeaderBytes + headerBytes>> readStart(std::uintmax_t frame) const
    {
        std::array<std::byte, frameHeaderBytes + headerBytes> start{};
        return m_bytes->read(start, positionOf(frame)) && isOfThisLog(start) ? std::optional(start)
                                                                             : std::nullopt;
    }
    /// The header of the database that a page of the log holds; nullopt where it holds another page.
    std::optional<Header> firstPageAt(std::uintmax_t frame) const
    {
        const auto start = readStart(frame);
        if (!start || bigEndian(*start, 0) != 1)
            return std::nullopt;
        Header header{};
        std::copy_n(start->begin() + frameHeaderBytes, headerBytes, header.begin());
        return header;
    }
    bool isOfThisLog(std::span<const std::byte> frame) const
    {
        return std::ranges::equal(frame.subspan(2 * sizeof(std::uint32_t), saltsBytes), m_salts);
    }
    /// Whether a log whose first mark is that one may begin with a database of the other. They are alike
    /// where its first transaction wrote no mark.
    static bool isBefore(LogMark database, LogMark first)
    {
        return database == first || traceOf(database) == (first & ~randomMask);
    }

    const DatabaseBytes *m_bytes;
    std::uint32_t m_pageBytes = 0;
    std::uintmax_t m_frames = 0;
    std::array<std::byte, saltsBytes> m_salts{};
    LogSums m_sums; ///< of its header
};

/// The headers of a database and of the log beside it. A log keeps its header until all of it is in the
/// database, and what is committed in it stays as it is that long; so what was found between two equal looks
/// is true, whoever writes meanwhile.
struct Headers
{
    Header database{};
    LogHeader log{};
    bool areRead = false;

    Headers(const DatabaseBytes &file, const DatabaseBytes &logged)
        : areRead(file.read(database, 0) && logged.read(log, 0))
    {
    }
    bool operator==(const Headers &) const = default;
};

enum class Belongs { Yes, No, Changed };

Belongs look(const std::filesystem::path &file, const std::filesystem::path &log)
{
    if (!files::isFile(log))
        return Belongs::Yes;
    const DatabaseBytes logged(log);
    const Headers headers(DatabaseBytes(file), logged);
    const auto found = Log::in(logged, headers.log);
    if (!headers.areRead || !found || found->belongsTo(headers.database, found->writtenFrames()))
        return Belongs::Yes;
    // What is half written, or was never committed, proves nothing. Checked only now, because it takes
    // long.
    if (found->belongsTo(headers.database, found->committedFrames()))
        return Belongs::Yes;
    return headers == Headers(DatabaseBytes(file), DatabaseBytes(log)) ? Belongs::No : Belongs::Changed;
}

} // namespace

LogMark newLogMark()
{
    return std::max<LogMark>(randomNumber() & signlessMask, 1);
}

LogMark nextLogMark(LogMark before)
{
    return traceOf(before) | std::max<LogMark>(randomNumber() & randomMask, 1);
}

Result<void> checkLog(const std::filesystem::path &file)
{
    std::error_code problem;
    std::filesystem::path real = files::realPath(file, problem);
    if (problem)
        real = file;
    const std::filesystem::path log = besideFile(real, logSuffix);
    constexpr int attempts = 20;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const Belongs belongs = look(real, log);
        if (belongs == Belongs::Yes)
            return {};
        if (belongs == Belongs::No)
            return fail(ErrorCode::Unavailable, projectSubject(file.filename()),
                        ODO_TEXT("project.foreign_log",
                                 "the log beside it ('%1') belongs to another file or to another "
                                 "state of this one")(Named::file(log.filename())),
                        ODO_TEXT("project.move_log_away",
                                 "move the log to another folder to open the file without "
                                 "it, or restore the file that the log belongs to"));
    }
    return {}; // whoever writes to it all the time has looked before
}

namespace {

tl::unexpected<Error> notCopied(const std::filesystem::path &file, int reason)
{
    return fail(ErrorCode::Io, projectSubject(file.filename()),
                ODO_TEXT("project.not_copied",
                         "it could not be copied to be read (%1)")(foreignWords(std::strerror(reason))),
                ODO_TEXT("project.copy_with_side_files",
                         "copy it with the files beside it to a folder that you "
                         "may write to, and open the copy"));
}

/// What changes when a file is written to.
using Stamp = std::array<std::int64_t, 3>;

Stamp stampOf(const std::filesystem::path &file)
{
    const FileStatus there = statusOf(file).value_or(FileStatus());
    return {there.bytes, there.modifiedNs, static_cast<std::int64_t>(there.identity.inode)};
}

bool copyDatabaseBytes(const std::filesystem::path &from, std::ofstream &into)
{
    const DatabaseBytes bytes(from);
    std::vector<std::byte> block(1 << 20);
    const std::uintmax_t size = bytes.size();
    for (std::uintmax_t at = 0; at < size; at += block.size()) {
        block.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(block.size(), size - at)));
        if (!bytes.read(block, at) || !into.write(reinterpret_cast<const char *>(block.data()),
                                                  static_cast<std::streamsize>(block.size())))
            return false;
    }
    return bytes.isOpen() && into.flush();
}

} // namespace

bool hasLog(const std::filesystem::path &file)
{
    std::error_code problem;
    return files::sizeOf(besideFile(files::realPath(file), logSuffix), problem) > 0;
}

Result<std::unique_ptr<LogCopy>> LogCopy::make(const std::filesystem::path &file)
{
    auto folder = ODO_TRY(TemporaryFolder::make(
        temporaryFolder(),
        ODO_TEXT("project.copy_of_project", "copy of project '%1'")(Named::file(file.filename()))));
    std::unique_ptr<LogCopy> copy(new LogCopy(std::move(folder)));
    ODO_TRY(copy->fill(file));
    return copy;
}

Result<void> LogCopy::fill(const std::filesystem::path &file) const
{
    const std::filesystem::path log = besideFile(file, logSuffix);
    constexpr int attempts = 5;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const std::array before{stampOf(file), stampOf(log)};
        std::ofstream database(this->file(), std::ios::binary),
            logCopy(besideFile(this->file(), logSuffix), std::ios::binary);
        std::ifstream logged(log, std::ios::binary);
        if (!copyDatabaseBytes(file, database) || !(logCopy << logged.rdbuf()).flush())
            return notCopied(file, errno);
        if (before == std::array{stampOf(file), stampOf(log)})
            return {};
    }
    return fail(ErrorCode::Unavailable, projectSubject(file.filename()), anotherProgramWrites(),
                closeOtherProgram());
}

bool FileStamp::isOverwrittenSince(const FileStamp &before) const
{
    return account == before.account && (size != before.size || modifiedNs != before.modifiedNs);
}

std::optional<FileStamp> fileStamp(sqlite3 *database, const std::filesystem::path &file)
{
    constexpr int regionSize = 32'768;
    constexpr std::size_t headerWords = 12, writtenBackAt = 24, attemptedAt = 32; // in words of four bytes
    const auto status = statusOf(file);
    sqlite3_file *opened = nullptr;
    volatile void *region = nullptr;
    if (!status || sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &opened) != SQLITE_OK ||
        !opened->pMethods || opened->pMethods->iVersion < 2 ||
        opened->pMethods->xShmMap(opened, 0, regionSize, 0, &region) != SQLITE_OK || !region)
        return std::nullopt;
    const auto *words = static_cast<volatile std::uint32_t *>(region);
    FileStamp stamp{status->bytes, status->modifiedNs, {}};
    std::copy(words, words + headerWords, stamp.account.begin());
    stamp.account[headerWords] = words[writtenBackAt];
    stamp.account[headerWords + 1] = words[attemptedAt];
    return stamp;
}

namespace {

std::size_t unitsFor(std::size_t bytes)
{
    return (bytes + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t);
}

/// Without links, through which SQLite opens nothing; empty where it is too long.
std::string wholeName(sqlite3_vfs &system, const std::filesystem::path &file)
{
    std::string name(static_cast<std::size_t>(system.mxPathname) + 1, '\0');
    const int code = system.xFullPathname(&system, file.c_str(), static_cast<int>(name.size()), name.data());
    return (code & 0xff) == SQLITE_OK ? name.c_str() : std::string();
}

} // namespace

DatabaseBytes::DatabaseBytes(const std::filesystem::path &file)
{
    sqlite3_vfs *system = sqlite3_vfs_find(nullptr);
    m_name = sqlite3_create_filename(wholeName(*system, file).c_str(), "", "", 0, nullptr);
    m_memory.resize(unitsFor(static_cast<std::size_t>(system->szOsFile)));
    m_file = reinterpret_cast<sqlite3_file *>(m_memory.data());
    const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_MAIN_DB;
    if (m_name == nullptr || system->xOpen(system, m_name, m_file, flags, nullptr) != SQLITE_OK)
        m_file->pMethods = nullptr;
}

DatabaseBytes::~DatabaseBytes()
{
    if (isOpen())
        m_file->pMethods->xClose(m_file);
    sqlite3_free_filename(
        const_cast<char *>(m_name)); // NOLINT(cppcoreguidelines-pro-type-const-cast): SQLite's type
}

bool DatabaseBytes::isOpen() const
{
    return m_file->pMethods != nullptr;
}

std::uintmax_t DatabaseBytes::size() const
{
    sqlite3_int64 size = 0;
    return isOpen() && m_file->pMethods->xFileSize(m_file, &size) == SQLITE_OK
               ? static_cast<std::uintmax_t>(size)
               : 0;
}

bool DatabaseBytes::read(std::span<std::byte> into, std::uintmax_t offset) const
{
    if (!isOpen())
        return false;
    const int code = m_file->pMethods->xRead(m_file, into.data(), static_cast<int>(into.size()),
                                             static_cast<sqlite3_int64>(offset));
    return code == SQLITE_OK || code == SQLITE_IOERR_SHORT_READ;
}

std::uint32_t bigEndian(std::span<const std::byte> bytes, std::size_t offset)
{
    std::uint32_t number = 0;
    for (const std::byte byte : bytes.subspan(offset, 4))
        number = number << 8U | std::to_integer<std::uint32_t>(byte);
    return number;
}

} // namespace odo
