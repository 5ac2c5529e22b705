// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_locks.h"

#include "core/base/file_system.h"
#include "core/files/file_words.h"
#include "core/files/temporary.h"
#include "core/project/names.h"
#include "core/project/project_words.h"

#include <QString>
#include <QSysInfo>
#include <map>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

namespace odo {

namespace {

/// The line behind what a lock says, by which it is known.
constexpr std::string_view mark = "\nlock of Odograph\n";
constexpr std::size_t mostBytes = 400;

/// The words of a lock's file; nothing where it is no lock's.
std::optional<std::string> wordsIn(const FileHandle &file)
{
    const auto status = file.status();
    if (!status || status->kind != files::Kind::File || status->names > 1)
        return std::nullopt;
    std::string text(mostBytes, '\0');
    const auto length = file.readStart(text);
    if (!length || *length == 0 || status->bytes != static_cast<std::int64_t>(*length))
        return length == std::size_t(0) ? std::optional(std::string()) : std::nullopt;
    text.resize(*length);
    if (!text.ends_with(mark))
        return std::nullopt;
    return text.substr(0, text.find('\n'));
}

tl::unexpected<Error> cannotHold(const std::filesystem::path &file, const std::error_code &reason)
{
    return fail(ErrorCode::Io, ODO_TEXT("project.cannot_hold", "cannot hold %1")(Named::file(file)),
                foreignWords(reason.message()), checkItsFolder());
}

} // namespace

HeldFile::HeldFile(std::filesystem::path file, Afterwards afterwards, FileHandle handle)
    : m_file(std::move(file)), m_afterwards(afterwards), m_handle(std::move(handle))
{
}

Result<std::unique_ptr<HeldFile>> HeldFile::take(const std::filesystem::path &file, Afterwards afterwards,
                                                 const std::string &words)
{
    for (;;) {
        // Never through a link: a project may come from anyone, and what the link leads to would be emptied.
        auto handle = FileHandle::openOrCreate(file, FileHandle::Use::ReadAndWrite,
                                               FileHandle::Permissions::OwnerWrites);
        if (!handle)
            return cannotHold(file, handle.error());
        if (handle->tryLock(FileHandle::Lock::Exclusive))
            return nullptr;
        if (!handle->isAt(file)) // whoever gave it up may have removed it meanwhile
            continue;
        std::unique_ptr<HeldFile> held(new HeldFile(file, afterwards, std::move(*handle)));
        if (!wordsIn(held->m_handle)) {
            held->m_afterwards = Afterwards::Stays;
            return held;
        }
        const std::string text =
            words.empty() ? words : words.substr(0, mostBytes - mark.size()) + std::string(mark);
        std::error_code problem = held->m_handle.clear();
        if (!problem)
            problem = held->m_handle.write(text);
        if (problem)
            return cannotHold(file, problem);
        return held;
    }
}

bool HeldFile::isHeld(const std::filesystem::path &file)
{
    const auto handle = FileHandle::openToRead(file, FileHandle::Links::Followed);
    return handle && handle->tryLock(FileHandle::Lock::Shared);
}

std::string HeldFile::wordsOf(const std::filesystem::path &file)
{
    const auto handle = FileHandle::openToRead(file, FileHandle::Links::Refused);
    return handle ? wordsIn(*handle).value_or(std::string()) : std::string();
}

HeldFile::~HeldFile()
{
    if (m_afterwards == Afterwards::Goes)
        static_cast<void>(removeFile(m_file)); // while it is held, so that nobody else's goes
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
        m_folder =
            FileHandle::openFolder(file.parent_path(), FileHandle::Links::Followed).value_or(FileHandle());
}

bool WriteTurn::take(std::chrono::milliseconds patience)
{
    m_mutex.lock();
    return takeFromOthers(patience);
}

/// With the mutex held, which it gives back where it fails.
bool WriteTurn::takeFromOthers(std::chrono::milliseconds patience)
{
    if (m_depth++ > 0 || !m_folder.isOpen())
        return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    for (std::chrono::milliseconds pause{1};; pause = std::min(pause * 2, std::chrono::milliseconds(20))) {
        if (m_folder.tryLock(FileHandle::Lock::Exclusive) != std::errc::operation_would_block)
            return true; // it is ours, or there are no such locks here
        if (std::chrono::steady_clock::now() >= end) {
            --m_depth;
            m_mutex.unlock();
            return false;
        }
        std::this_thread::sleep_for(pause);
    }
}

void WriteTurn::give()
{
    if (--m_depth == 0 && m_folder.isOpen())
        m_folder.unlock();
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
