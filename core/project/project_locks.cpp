// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_locks.h"

#include "core/base/file_system.h"
#include "core/files/file_words.h"
#include "core/files/temporary.h"
#include "core/project/names.h"
#include "core/project/project_words.h"

#include <QString>
#include <QSysInfo>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <map>
#include <optional>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

/// The line behind what a lock says, by which it is known.
constexpr std::string_view mark = "\nlock of Odograph\n";
constexpr std::size_t mostBytes = 400;

/// The words of a lock's file; nothing where it is no lock's.
std::optional<std::string> wordsIn(int descriptor)
{
    struct stat status
    {
    };
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode) || status.st_nlink > 1)
        return std::nullopt;
    std::string text(mostBytes, '\0');
    const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
    if (length <= 0 || status.st_size != length)
        return length == 0 ? std::optional(std::string()) : std::nullopt;
    text.resize(static_cast<std::size_t>(length));
    if (!text.ends_with(mark))
        return std::nullopt;
    return text.substr(0, text.find('\n'));
}

tl::unexpected<Error> cannotHold(const std::filesystem::path &file)
{
    return fail(ErrorCode::Io, ODO_TEXT("project.cannot_hold", "cannot hold %1")(Named::file(file)),
                foreignWords(std::strerror(errno)), checkItsFolder());
}

} // namespace

HeldFile::HeldFile(std::filesystem::path file, Afterwards afterwards, int descriptor)
    : m_file(std::move(file)), m_afterwards(afterwards), m_descriptor(descriptor)
{
}

Result<std::unique_ptr<HeldFile>> HeldFile::take(const std::filesystem::path &file, Afterwards afterwards,
                                                 const std::string &words)
{
    for (;;) {
        // Never through a link: a project may come from anyone, and what the link leads to would be emptied.
        const int descriptor =
            ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644);
        if (descriptor < 0)
            return cannotHold(file);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            ::close(descriptor);
            return nullptr;
        }
        if (!isAt(file, descriptor)) { // whoever gave it up may have removed it meanwhile
            ::close(descriptor);
            continue;
        }
        std::unique_ptr<HeldFile> held(new HeldFile(file, afterwards, descriptor));
        if (!wordsIn(descriptor)) {
            held->m_afterwards = Afterwards::Stays;
            return held;
        }
        const std::string text =
            words.empty() ? words : words.substr(0, mostBytes - mark.size()) + std::string(mark);
        if (::ftruncate(descriptor, 0) != 0 ||
            ::write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
            return cannotHold(file);
        return held;
    }
}

bool HeldFile::isHeld(const std::filesystem::path &file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return false;
    const bool held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}

std::string HeldFile::wordsOf(const std::filesystem::path &file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return {};
    const std::string words = wordsIn(descriptor).value_or(std::string());
    ::close(descriptor);
    return words;
}

HeldFile::~HeldFile()
{
    if (m_afterwards == Afterwards::Goes)
        ::unlink(m_file.c_str()); // while it is held, so that nobody else's goes
    ::close(m_descriptor);
}

std::filesystem::path RecordingLock::fileIn(const std::filesystem::path &mediaFolder)
{
    return mediaFolder / "recording.lock";
}

Result<std::unique_ptr<RecordingLock>> RecordingLock::take(const std::filesystem::path &mediaFolder)
{
    const Message what =
        ODO_TEXT("project.cannot_record_into", "cannot record into %1")(Named::file(mediaFolder));
    std::error_code problem;
    files::makeFolders(mediaFolder, problem);
    if (problem)
        return fail(ErrorCode::Io, what, foreignWords(problem.message()), checkProjectFolder());
    auto file = HeldFile::take(fileIn(mediaFolder), HeldFile::Afterwards::Stays);
    if (!file)
        return fail(file.error().code, what, file.error().why, file.error().advice);
    if (!*file)
        return fail(ErrorCode::AlreadyExists, what,
                    ODO_TEXT("project.recorded_into_now", "a trial is being recorded into it now"),
                    waitUntilThatHasEnded());
    return std::unique_ptr<RecordingLock>(new RecordingLock(std::move(*file)));
}

bool RecordingLock::isHeld(const std::filesystem::path &mediaFolder)
{
    return HeldFile::isHeld(fileIn(mediaFolder));
}

namespace {

std::filesystem::path lockFile(const std::filesystem::path &project)
{
    std::error_code problem;
    std::filesystem::path file = files::realPath(project, problem); // two ways to one file
    if (problem)
        file = project;
    file += ".lock";
    return file;
}

/// "anna on room12-pc3".
std::string holder()
{
    const QString user = qEnvironmentVariable("USER", QStringLiteral("somebody"));
    return QStringLiteral("%1 on %2").arg(user, QSysInfo::machineHostName()).toStdString();
}

} // namespace

Result<std::unique_ptr<WindowLock>> WindowLock::take(const std::filesystem::path &project)
{
    const Message what = projectSubject(project.filename());
    auto file = HeldFile::take(lockFile(project), HeldFile::Afterwards::Goes, holder());
    if (!file)
        return fail(file.error().code, what, file.error().why, file.error().advice);
    if (!*file) {
        const std::string who = HeldFile::wordsOf(lockFile(project));
        return fail(ErrorCode::AlreadyExists, what,
                    who.empty()
                        ? Message(ODO_TEXT("project.open_elsewhere", "it is open in another window"))
                        : ODO_TEXT("project.open_elsewhere_by", "it is open in another window (%1)")(who),
                    ODO_TEXT("project.close_it_there", "close it there first"));
    }
    return std::unique_ptr<WindowLock>(new WindowLock(std::move(*file)));
}

std::shared_ptr<WriteTurn> WriteTurn::of(const std::filesystem::path &file)
{
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::weak_ptr<WriteTurn>> turns;
    const std::filesystem::path whole = files::realPath(file);
    const std::lock_guard lock(mutex);
    std::erase_if(turns, [](const auto &turn) { return turn.second.expired(); });
    std::weak_ptr<WriteTurn> &known = turns[whole];
    auto turn = known.lock();
    if (!turn)
        known = turn = std::make_shared<WriteTurn>(whole);
    return turn;
}

WriteTurn::WriteTurn(const std::filesystem::path &file)
{
    if (file.has_parent_path()) // a database in memory has no folder
        m_folder = ::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

WriteTurn::~WriteTurn()
{
    if (m_folder >= 0)
        ::close(m_folder);
}

bool WriteTurn::take(std::chrono::milliseconds patience)
{
    m_mutex.lock();
    return takeFromOthers(patience);
}

/// With the mutex held, which it gives back where it fails.
bool WriteTurn::takeFromOthers(std::chrono::milliseconds patience)
{
    if (m_depth++ > 0 || m_folder < 0)
        return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    for (std::chrono::milliseconds pause{1}; ::flock(m_folder, LOCK_EX | LOCK_NB) != 0;
         pause = std::min(pause * 2, std::chrono::milliseconds(20))) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return true; // no such locks here
        if (std::chrono::steady_clock::now() >= end) {
            --m_depth;
            m_mutex.unlock();
            return false;
        }
        std::this_thread::sleep_for(pause);
    }
    return true;
}

void WriteTurn::give()
{
    if (--m_depth == 0 && m_folder >= 0)
        ::flock(m_folder, LOCK_UN);
    m_mutex.unlock();
}

HeldTurn::HeldTurn(WriteTurn &turn, std::chrono::milliseconds patience)
    : m_turn(turn.take(patience) ? &turn : nullptr)
{
}

HeldTurn HeldTurn::ifFree(WriteTurn &turn)
{
    HeldTurn held;
    if (turn.m_mutex.try_lock() && turn.takeFromOthers(std::chrono::milliseconds(0)))
        held.m_turn = &turn;
    return held;
}

HeldTurn::HeldTurn(HeldTurn &&other) noexcept : m_turn(std::exchange(other.m_turn, nullptr)) {}

HeldTurn &HeldTurn::operator=(HeldTurn &&other) noexcept
{
    if (this != &other) {
        giveUp();
        m_turn = std::exchange(other.m_turn, nullptr);
    }
    return *this;
}

void HeldTurn::giveUp()
{
    if (WriteTurn *turn = std::exchange(m_turn, nullptr))
        turn->give();
}

} // namespace odo
