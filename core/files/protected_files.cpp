// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/protected_files.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <array>

namespace odo {

namespace {

struct ProtectedLists
{
    std::mutex mutex;
    std::list<ProtectedFile> projects, inputs;
};

ProtectedLists &protectedLists()
{
    static ProtectedLists lists;
    return lists;
}

ProtectedFile protectedFile(const std::filesystem::path &file, Message reason)
{
    const std::filesystem::path named = files::absolute(file);
    std::error_code problem;
    const std::filesystem::path real = files::existingPath(named, problem);
    return {named, problem ? named : real, identityOf(named), std::move(reason)};
}

} // namespace

OpenProjectFile::OpenProjectFile(const std::filesystem::path &file)
{
    std::list<ProtectedFile> entry{protectedFile(file, {})};
    ProtectedLists &lists = protectedLists();
    const std::lock_guard lock(lists.mutex);
    m_entry = entry.begin();
    lists.projects.splice(lists.projects.end(), entry);
}

OpenProjectFile::~OpenProjectFile()
{
    const std::lock_guard lock(protectedLists().mutex);
    protectedLists().projects.erase(m_entry);
}

Result<void> checkMayBeRead(const std::filesystem::path &file, const Message &what)
{
    std::error_code problem;
    const files::Kind kind = files::kindOf(file, problem);
    if (problem)
        return cannotBeInspected(what, problem, checkFileMayBeRead());
    if (kind == files::Kind::Missing)
        return fail(ErrorCode::NotFound, what, noSuchFile(),
                    ODO_TEXT("files.check_name", "check the name and the folder"));
    if (Message reason = files::insteadOfFile(kind); !reason.isEmpty())
        return fail(ErrorCode::InvalidInput, what, std::move(reason), nameAFile());
    if (const std::error_code refused = checkAccess(file, FileAccess::Read))
        return fail(ErrorCode::Io, what, cannotBeRead(refused.message()), checkFileMayBeRead());
    const auto identity = identityOf(file);
    if (identity && ProtectedFiles().isPartOfOpenProject(*identity))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("files.is_open_project", "it is a project that is open here"),
                    ODO_TEXT("files.choose_another_file", "choose another file"));
    return {};
}

InputFiles::InputFiles() : InputFiles(ODO_TEXT("files.is_input", "it is an input of the same command")) {}

InputFiles::~InputFiles()
{
    const std::lock_guard lock(protectedLists().mutex);
    for (const auto &entry : m_entries)
        protectedLists().inputs.erase(entry);
}

void InputFiles::add(const std::filesystem::path &file)
{
    std::list<ProtectedFile> entry{protectedFile(file, m_reason)};
    m_entries.push_back(entry.begin());
    const std::lock_guard lock(protectedLists().mutex);
    protectedLists().inputs.splice(protectedLists().inputs.end(), entry);
}

ProtectedFiles::ProtectedFiles() : m_lock(protectedLists().mutex) {}

const std::list<ProtectedFile> &ProtectedFiles::projects() const
{
    return protectedLists().projects;
}
const std::list<ProtectedFile> &ProtectedFiles::inputs() const
{
    return protectedLists().inputs;
}

bool ProtectedFiles::isOpenProject(const FileIdentity &file) const
{
    return std::ranges::any_of(projects(), [&](const ProtectedFile &project) {
        return project.identity == file || identityOf(project.real) == file;
    });
}

bool ProtectedFiles::isPartOfOpenProject(const FileIdentity &file) const
{
    return std::ranges::any_of(projects(), [&](const ProtectedFile &project) {
        return std::ranges::any_of(std::array{"", "-shm", "-wal", "-journal"}, [&](const char *part) {
            return identityOf(project.real.string() + part) == file;
        });
    });
}

namespace {

constexpr int mostLinks = 40; // as the kernel

} // namespace

Result<ResolvedPath> resolved(const std::filesystem::path &file)
{
    const Message what = quotedFileSubject(file);
    if (file.empty())
        return fail(ErrorCode::WrongCall, what, ODO_TEXT("files.has_no_name", "it has no name"), nameAFile());
    std::filesystem::path named = files::absolute(file);
    ResolvedPath resolved;
    for (int links = 0; links < mostLinks; ++links) {
        resolved.named.push_back(named.lexically_normal());
        const std::filesystem::path name = named.filename(), folder = named.parent_path();
        if (name.empty() || name == "." || name == "..")
            return fail(ErrorCode::WrongCall, what, files::insteadOfFile(files::Kind::Folder), nameAFile());
        std::error_code problem;
        const std::filesystem::path realFolder = files::existingPath(folder, problem);
        if (problem == std::errc::no_such_file_or_directory)
            return fail(ErrorCode::NotFound, what, noSuchFolder(folder), makeFolderFirst());
        if (problem)
            return fail(ErrorCode::Io, what,
                        ODO_TEXT("files.folder_cannot_be_used",
                                 "its folder cannot be used (%1)")(foreignWords(problem.message())),
                        ODO_TEXT("files.choose_another_folder", "choose another folder"));
        resolved.real = realFolder / name;
        std::error_code isNoLink;
        const std::filesystem::path link = files::linkTarget(resolved.real, isNoLink);
        if (isNoLink)
            return resolved;
        named = realFolder / link; // an absolute one replaces the folder
    }
    return fail(ErrorCode::Io, what,
                cannotBeWritten(std::make_error_code(std::errc::too_many_symbolic_link_levels).message()),
                chooseAnotherName());
}

} // namespace odo
