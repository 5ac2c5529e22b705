// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_system.h"

namespace odo::files {

namespace {

namespace fs = std::filesystem;

Kind kindOfStatus(const fs::file_status &status)
{
    switch (status.type()) {
    case fs::file_type::none:
    case fs::file_type::not_found:
        return Kind::Missing;
    case fs::file_type::regular:
        return Kind::File;
    case fs::file_type::directory:
        return Kind::Folder;
    case fs::file_type::symlink:
        return Kind::Link;
    case fs::file_type::fifo:
        return Kind::Pipe;
    case fs::file_type::socket:
        return Kind::Socket;
    default:
        return Kind::Device;
    }
}

/// Some forms of std::filesystem throw in spite of an error_code.
template <class Call>
auto answer(std::error_code &problem, const Call &call) -> decltype(call(problem))
{
    problem.clear();
    try {
        return call(problem);
    } catch (const fs::filesystem_error &error) {
        problem = error.code();
    }
    return {};
}

} // namespace

Kind kindOf(const fs::path &path, std::error_code &problem)
{
    const fs::file_status status =
        answer(problem, [&](std::error_code &code) { return fs::status(path, code); });
    if (status.type() == fs::file_type::not_found)
        problem.clear();
    return kindOfStatus(status);
}

Kind kindOfItself(const fs::path &path)
{
    std::error_code unknown;
    return kindOfStatus(
        answer(unknown, [&](std::error_code &code) { return fs::symlink_status(path, code); }));
}

Message insteadOfFile(Kind kind)
{
    switch (kind) {
    case Kind::Missing:
    case Kind::File:
    case Kind::Link:
        return {};
    case Kind::Folder:
        return ODO_TEXT("base.is_folder", "it is a folder");
    case Kind::Pipe:
        return ODO_TEXT("base.is_pipe", "it is a named pipe");
    case Kind::Socket:
        return ODO_TEXT("base.is_socket", "it is a socket");
    case Kind::Device:
        break;
    }
    return ODO_TEXT("base.is_device", "it is a device");
}

bool exists(const fs::path &path)
{
    std::error_code unknown;
    return kindOf(path, unknown) != Kind::Missing;
}

bool isFile(const fs::path &path)
{
    std::error_code unknown;
    return kindOf(path, unknown) == Kind::File;
}

bool isFolder(const fs::path &path)
{
    std::error_code unknown;
    return kindOf(path, unknown) == Kind::Folder;
}

bool isSame(const fs::path &a, const fs::path &b)
{
    std::error_code unknown;
    return answer(unknown, [&](std::error_code &code) { return fs::equivalent(a, b, code); });
}

std::uintmax_t sizeOf(const fs::path &file, std::error_code &problem)
{
    const std::uintmax_t bytes =
        answer(problem, [&](std::error_code &code) { return fs::file_size(file, code); });
    return problem ? 0 : bytes;
}

DiskSpace diskSpace(const fs::path &folder, std::error_code &problem)
{
    const fs::space_info space =
        answer(problem, [&](std::error_code &code) { return fs::space(folder, code); });
    return problem ? DiskSpace() : DiskSpace{space.available, space.capacity};
}

fs::file_time_type lastWritten(const fs::path &file, std::error_code &problem)
{
    return answer(problem, [&](std::error_code &code) { return fs::last_write_time(file, code); });
}

fs::path absolute(const fs::path &path)
{
    std::error_code unknown;
    fs::path whole = answer(unknown, [&](std::error_code &code) { return fs::absolute(path, code); });
    return unknown ? path : whole;
}

fs::path realPath(const fs::path &path)
{
    std::error_code unknown;
    return realPath(path, unknown);
}

fs::path realPath(const fs::path &path, std::error_code &problem)
{
    fs::path real = answer(problem, [&](std::error_code &code) { return fs::weakly_canonical(path, code); });
    return problem || real.empty() ? files::absolute(path) : real;
}

fs::path existingPath(const fs::path &path, std::error_code &problem)
{
    return answer(problem, [&](std::error_code &code) { return fs::canonical(path, code); });
}

fs::path linkTarget(const fs::path &link, std::error_code &problem)
{
    return answer(problem, [&](std::error_code &code) { return fs::read_symlink(link, code); });
}

void eachFileBelow(const fs::path &folder, const std::function<bool(const fs::path &)> &visit,
                   std::error_code &problem)
{
    std::vector<fs::path> folders{folder};
    std::error_code *heard = &problem, left;
    while (!folders.empty()) {
        const fs::path here = std::move(folders.back());
        folders.pop_back();
        for (const std::string &name : namesIn(here, *heard)) {
            fs::path path = here / name;
            if (kindOfItself(path) == Kind::Folder)
                folders.push_back(std::move(path));
            else if (isFile(path) && !visit(path))
                return;
        }
        heard = &left;
    }
}

bool makeFolders(const fs::path &folder, std::error_code &problem)
{
    return answer(problem, [&](std::error_code &code) { return fs::create_directories(folder, code); });
}

void remove(const fs::path &path, std::error_code &problem)
{
    answer(problem, [&](std::error_code &code) { return fs::remove(path, code); });
}

void remove(const fs::path &path)
{
    std::error_code stays;
    files::remove(path, stays);
}

void removeAll(const fs::path &path)
{
    if (kindOfItself(path) == Kind::Folder) {
        std::error_code unread;
        for (const std::string &name : namesIn(path, unread))
            removeAll(path / name);
    }
    files::remove(path);
}

void link(const fs::path &file, const fs::path &name, std::error_code &problem)
{
    answer(problem, [&](std::error_code &code) { return fs::create_hard_link(file, name, code), true; });
}

void letAllRead(const fs::path &folder, std::error_code &problem)
{
    constexpr auto usual = fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                           fs::perms::others_read | fs::perms::others_exec;
    answer(problem, [&](std::error_code &code) { return fs::permissions(folder, usual, code), true; });
}

void rename(const fs::path &from, const fs::path &to, std::error_code &problem)
{
    answer(problem, [&](std::error_code &code) { return fs::rename(from, to, code), true; });
}

} // namespace odo::files
