// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/files/temporary.h"

#include <algorithm>
#include <string_view>

namespace odo {

namespace {

constexpr std::string_view projectEnding = ".odo", mediaEnding = ".media";
constexpr int deepestFolder = 8; // of a media folder

/// As file systems that take no notice of capitals compare it.
std::string folded(std::string text)
{
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

/// What follows a project's name in those of its log, lock and backups.
bool isSideSuffix(std::string_view suffix)
{
    return suffix == "-wal" || suffix == "-shm" || suffix == "-journal" || suffix == ".lock" ||
           suffix.starts_with(".bak-") || suffix.starts_with(".damaged");
}

/// Whether a file name is that of a project's log, lock or backup; `project`: its name, or how all projects
/// end.
bool isSideName(const std::filesystem::path &name, const std::string &project)
{
    const std::string text = folded(name.string()), before = folded(project);
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1))
        if (isSideSuffix(std::string_view(text).substr(at + before.size())))
            return true;
    return false;
}

std::filesystem::path mediaFolderOf(const std::filesystem::path &project)
{
    return project.parent_path() / (project.stem().string() + std::string(mediaEnding));
}

bool isMediaName(const std::filesystem::path &folder)
{
    const std::string name = folder.filename().string();
    return name.size() > mediaEnding.size() && folded(name).ends_with(mediaEnding);
}

/// By content: a project may have any name.
bool holdsProject(const std::filesystem::path &file, const ProtectedFiles &open)
{
    const auto identity = identityOf(file);
    if (!identity || open.isOpenProject(*identity))
        return identity.has_value();
    if (open.isPartOfOpenProject(*identity) || !files::isFile(file))
        return false;
    const auto handle = FileHandle::openToRead(file, FileHandle::Links::Followed);
    return handle && kindOfFile(*handle) == FileKind::Project;
}

/// A project in the folder whose name `isMeant` likes; empty where there is none. One that is damaged is
/// known by its ending.
template <class IsMeant>
std::filesystem::path projectIn(const std::filesystem::path &folder, const ProtectedFiles &open,
                                const IsMeant &isMeant)
{
    std::error_code ignored;
    for (const std::filesystem::path name : files::namesIn(folder, ignored)) {
        const std::filesystem::path file = folder / name;
        if (isMeant(name) && ((folded(name.extension().string()) == projectEnding && files::isFile(file)) ||
                              holdsProject(file, open)))
            return file;
    }
    return {};
}

/// The project whose media folder that is by its name; empty where there is none.
std::filesystem::path projectBeside(const std::filesystem::path &folder, const ProtectedFiles &open)
{
    if (!isMediaName(folder))
        return {};
    const std::string stem = folded(folder.stem().string());
    return projectIn(folder.parent_path(), open,
                     [&](const std::filesystem::path &name) { return folded(name.stem().string()) == stem; });
}

/// The folders above a file, the nearest first.
template <class Look>
bool anyFolderAbove(const std::filesystem::path &file, const Look &look)
{
    for (std::filesystem::path folder = file.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (look(folder))
            return true;
    return false;
}

/// Whether a file of a folder, or of one in it, has that identity.
bool holds(const std::filesystem::path &folder, const FileIdentity &file, int depth = 0)
{
    std::error_code ignored;
    for (const std::string &name : files::namesIn(folder, ignored)) {
        const std::filesystem::path each = folder / name;
        const auto status = statusOfItself(each);
        if (!status)
            continue;
        if (status->identity == file)
            return true;
        if (status->kind == files::Kind::Folder && depth < deepestFolder && holds(each, file, depth + 1))
            return true;
    }
    return false;
}

/// Whether a log, lock or backup of the project has that identity.
bool isSideFile(const std::filesystem::path &project, const FileIdentity &file)
{
    std::error_code ignored;
    const std::filesystem::path folder = project.parent_path();
    return std::ranges::any_of(files::namesIn(folder, ignored), [&](const std::string &name) {
        return isSideName(name, project.filename().string()) && identityOf(folder / name) == file;
    });
}

Message namesAProject()
{
    return ODO_TEXT("files.names_a_project", "only projects have a name ending in .odo");
}

Message isTheProject()
{
    return ODO_TEXT("files.is_the_project", "it is the project itself");
}

Message isBesideProject()
{
    return ODO_TEXT("files.is_beside_project", "it is the log, the lock or a backup of a project");
}

Message isInMediaFolderOf(const std::filesystem::path &project)
{
    return ODO_TEXT("files.is_in_media_folder",
                    "it is in the media folder of project '%1'")(Named::file(project.filename()));
}

tl::unexpected<Error> refusedAs(const OutputTarget &target, Message why)
{
    return fail(ErrorCode::WrongCall, quotedFileSubject(target.file), std::move(why), chooseAnotherName());
}

/// The look at one target.
class OutputCheck
{
public:
    OutputCheck(const OutputTarget &target, ResolvedPath path) : m_target(target), m_path(std::move(path)) {}

    Result<OutputLocation> run(std::optional<FileKind> kind)
    {
        if (!m_exists && m_found.error() != std::errc::no_such_file_or_directory)
            return m_found.error() == std::errc::filename_too_long ? nameIsTooLong(what())
                                                                   : notWritable(m_found.error());
        if (Message reason = reasonOfName(); !reason.isEmpty())
            return refused(std::move(reason));
        if (const auto project = m_target.isOwnMedia ? std::filesystem::path() : projectOfMedia();
            !project.empty())
            return refused(isInMediaFolderOf(project));
        if (m_exists && !m_target.isOwnMedia && isInSomeMedia())
            return refused(
                ODO_TEXT("files.is_in_some_media_folder", "it is in a media folder beside a project"));
        OutputLocation location{m_path.real, m_exists, FileKind::Empty, m_status.permissions};
        if (!m_exists)
            return isNamedAsProject(kind) ? refused(namesAProject()) : Result<OutputLocation>(location);
        if (m_target.existing == Existing::Refuse || m_target.isOwnMedia)
            return fail(ErrorCode::AlreadyExists, what(), isThereAlready(), chooseAnotherNameOrFolder());
        if (const auto problem = checkAccess(m_path.real, FileAccess::Write))
            return notWritable(problem); // its owner has protected it, or the disk is read-only
        const auto found = ODO_TRY(existingKind());
        if (isNamedAsProject(kind))
            return refused(namesAProject());
        location.kind = found;
        if (kind && m_target.existing == Existing::ReplaceSameKind && location.kind != FileKind::Empty &&
            !isSameKind(location.kind, *kind))
            return fail(
                ErrorCode::WrongCall, what(),
                ODO_TEXT("files.is_of_another_kind", "a file of another kind has that name"),
                ODO_TEXT("files.replace_by_force", "choose another name, or replace it with --force"));
        return location;
    }

    Result<void> runForProject() const
    {
        if (Message reason = reasonBesideProjects(); !reason.isEmpty())
            return refused(std::move(reason));
        if (const auto project = projectOfMedia(); !project.empty())
            return refused(isInMediaFolderOf(project));
        const std::string left = m_exists ? std::string() : leftBeside();
        if (!left.empty())
            return fail(
                ErrorCode::AlreadyExists, what(),
                ODO_TEXT("files.log_left_beside",
                         "its folder has '%1', the log or journal of another file of this name")(
                    Named::file(left)),
                ODO_TEXT("files.move_log_away",
                         "choose another name, or move '%1' to another folder first")(Named::file(left)));
        return {};
    }

private:
    Message what() const { return quotedFileSubject(m_target.file); }
    tl::unexpected<Error> refused(Message why) const { return refusedAs(m_target, std::move(why)); }
    tl::unexpected<Error> notWritable(const std::error_code &reason) const
    {
        return fail(ErrorCode::ReadOnly, what(), cannotBeWritten(reason.message()), chooseAnotherName());
    }
    tl::unexpected<Error> notReadable(const std::error_code &reason) const
    {
        return fail(ErrorCode::Io, what(), cannotBeRead(reason.message()), chooseAnotherName());
    }
    /// Whether the file, or a link that leads to it, would pass for a project by its name and be none.
    bool isNamedAsProject(std::optional<FileKind> kind) const
    {
        const auto ends = [](const std::filesystem::path &file) {
            return folded(file.filename().string()).ends_with(projectEnding);
        };
        return kind != FileKind::Project && (ends(m_path.real) || std::ranges::any_of(m_path.named, ends));
    }
    /// The name of a log or journal that SQLite would apply to a new database there; empty: none.
    std::string leftBeside() const
    {
        for (const char *suffix : {"-wal", "-journal"}) {
            const std::string side = m_path.real.string() + suffix;
            const auto status = statusOfItself(side);
            const bool isHarmless = !status || (status->kind == files::Kind::File && status->bytes == 0);
            if (!isHarmless)
                return std::filesystem::path(side).filename().string();
        }
        return {};
    }
    FileIdentity identity() const { return m_status.identity; }
    /// Whether the file may be known by other names too.
    bool hasMoreNames() const { return m_exists && m_status.names > 1; }

    /// Why nothing may be written under that name or in place of that file; empty: nothing speaks against it
    /// so far.
    Message reasonOfName() const
    {
        if (m_exists && m_protected.isOpenProject(identity()))
            return isTheProject();
        for (const ProtectedFile &project : m_protected.projects())
            if (!m_exists && (m_path.real == project.real || m_path.real == project.named))
                return isTheProject();
        if (Message reason = reasonBesideProjects(); !reason.isEmpty())
            return reason;
        for (const ProtectedFile &input : m_protected.inputs())
            if (m_exists && (input.identity == identity() || input.real == m_path.real))
                return input.reason;
        return {};
    }

    /// Likewise, of a name that belongs to what a project has beside it.
    Message reasonBesideProjects() const
    {
        if (isTemporaryName(m_path.real.filename())) // it would be swept
            return ODO_TEXT("files.is_temporary_name", "Odograph uses such names for temporary files");
        if (isSideName(m_path.real.filename(), std::string(projectEnding)))
            return isBesideProject();
        for (const ProtectedFile &project : m_protected.projects()) {
            if (isSideName(m_path.real.filename(), project.real.filename().string()) &&
                identityOf(m_path.real.parent_path()) == identityOf(project.real.parent_path()))
                return isBesideProject();
            if (hasMoreNames() && isSideFile(project.real, identity()))
                return isBesideProject();
        }
        const std::string name = folded(m_path.real.filename().string());
        const auto isBesideIt = [&](const std::filesystem::path &project) {
            const std::string start = folded(project.string());
            return name.starts_with(start) && isSideSuffix(std::string_view(name).substr(start.size()));
        };
        return projectIn(m_path.real.parent_path(), m_protected, isBesideIt).empty() ? Message()
                                                                                     : isBesideProject();
    }

    /// The project to whose media the file belongs, or would; empty: none.
    std::filesystem::path projectOfMedia() const
    {
        for (const ProtectedFile &project : m_protected.projects())
            for (const std::filesystem::path &name : {project.real, project.named}) {
                const std::filesystem::path media = mediaFolderOf(name);
                const auto folder = identityOf(media);
                if (folder && anyFolderAbove(m_path.real,
                                             [&](const auto &above) { return identityOf(above) == folder; }))
                    return name;
                if (folder && hasMoreNames() && holds(media, identity()))
                    return name;
            }
        std::filesystem::path project;
        const auto look = [&](const std::filesystem::path &folder) {
            project = projectBeside(folder, m_protected);
            return !project.empty();
        };
        if (!anyFolderAbove(m_path.real, look))
            for (auto name = m_path.named.begin();
                 name != m_path.named.end() && !anyFolderAbove(*name, look);)
                ++name;
        return project;
    }

    /// A project that was renamed alone still has its videos in the folder of its old name.
    bool isInSomeMedia() const
    {
        return anyFolderAbove(m_path.real, [&](const std::filesystem::path &folder) {
            return isMediaName(folder) &&
                   !projectIn(folder.parent_path(), m_protected, [](const auto &) { return true; }).empty();
        });
    }

    /// It isn't an open project: reasonOfName() has looked.
    Result<FileKind> existingKind() const
    {
        const auto handle = FileHandle::openToRead(m_path.real, FileHandle::Links::Refused);
        const auto kind = handle ? kindOfFile(*handle) : tl::unexpected(handle.error());
        if (!kind)
            return notReadable(kind.error());
        if (kind == FileKind::Project)
            return refused(ODO_TEXT("files.is_another_project", "it is another project"));
        if (kind == FileKind::Database)
            return refused(ODO_TEXT("files.is_a_database", "it is a database"));
        return *kind;
    }

    const ProtectedFiles m_protected;
    const OutputTarget &m_target;
    const ResolvedPath m_path;
    const SystemResult<FileStatus> m_found = statusOfItself(m_path.real);
    const bool m_exists = m_found.has_value();
    const FileStatus m_status = m_found.value_or(FileStatus());
};

} // namespace

Result<OutputLocation> checkOutput(const OutputTarget &target, std::optional<FileKind> kind)
{
    // Before links are followed one by one: those in /proc lead to what has no name.
    std::error_code unknown;
    if (Message reason = files::insteadOfFile(files::kindOf(target.file, unknown)); !reason.isEmpty())
        return refusedAs(target, std::move(reason));
    auto path = ODO_TRY(resolved(target.file));
    return OutputCheck(target, std::move(path)).run(kind);
}

Result<void> checkNewProject(const std::filesystem::path &file, const Message &what)
{
    std::filesystem::path folder = files::absolute(file).parent_path();
    while (!files::isFolder(folder) && folder.has_relative_path()) // a demo makes its folder
        folder = folder.parent_path();
    const OutputTarget target(folder / file.filename(), Existing::Refuse);
    auto path = resolved(target.file);
    if (!path)
        return {}; // making it says why
    auto checked = OutputCheck(target, std::move(*path)).runForProject();
    if (!checked)
        checked.error().what = what;
    return checked;
}

OutputFile::OutputFile(OutputTarget target, FileKind kind, std::unique_ptr<TemporaryFile> temporary)
    : m_target(std::move(target)), m_kind(kind), m_temporary(std::move(temporary))
{
}

Result<std::unique_ptr<OutputFile>> OutputFile::open(const OutputTarget &target, FileKind kind)
{
    const auto location = ODO_TRY(checkOutput(target, kind));
    auto temporary =
        ODO_TRY(TemporaryFile::make(location.real.parent_path(), quotedFileSubject(target.file)));
    if (location.exists) // its readers stay the same; not every file system can
        static_cast<void>(temporary->handle().setPermissions(location.permissions));
    return std::unique_ptr<OutputFile>(new OutputFile(target, kind, std::move(temporary)));
}

tl::unexpected<Error> OutputFile::failure(std::string because) const
{
    return fail(ErrorCode::Io, quotedFileSubject(m_target.file), cannotBeWritten(std::move(because)),
                chooseFolderWithSpace());
}

Result<void> OutputFile::write(std::string_view bytes)
{
    const std::error_code problem = m_temporary->handle().write(bytes);
    return problem ? failure(problem.message()) : Result<void>();
}

Result<void> OutputFile::commit()
{
    for (;;) {
        const auto location = ODO_TRY(checkOutput(m_target, m_kind));
        if (location.exists)
            return m_temporary->replace(location.real);
        auto published = m_temporary->publish(location.real);
        if (published || published.error().code != ErrorCode::AlreadyExists)
            return published; // else somebody was quicker: is that file one that may be replaced?
    }
}

Result<void> writeOutput(const OutputTarget &target,
                         const std::function<Result<void>(const OutputSink &)> &write)
{
    std::unique_ptr<OutputFile> output;
    const OutputSink sink = [&](std::string_view piece) -> Result<void> {
        if (!output) {
            output = ODO_TRY(OutputFile::open(target, kindOf(piece)));
        }
        return output->write(piece);
    };
    ODO_TRY(write(sink));
    if (auto ended = sink({}); !ended) // so that there is a file where there was no piece
        return ended;
    return output->commit();
}

Result<void> writeOutput(const OutputTarget &target, std::string_view bytes)
{
    return writeOutput(target, [bytes](const OutputSink &sink) { return sink(bytes); });
}

} // namespace odo
