// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/location_warning.h"

#include "core/base/file_system.h"
#include "core/project/names.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

namespace odo {

namespace {

constexpr std::array<std::string_view, 14> networkFileSystems = {
    "nfs",         "nfs4",       "cifs",
    "smb3",        "smbfs",      "afs",
    "ceph",        "fuse.sshfs", "fuse.gvfsd-fuse",
    "fuse.rclone", "fuse.davfs", "fuse.glusterfs",
    "fuse.s3fs",   "davfs"};

struct SyncProgram
{
    /// folder: how its name begins; mark: a file or folder in it, may be empty
    std::string_view name, folder, mark;
};
constexpr std::array<SyncProgram, 8> syncPrograms = {{
    {"Dropbox", "Dropbox", ".dropbox.cache"},
    {"OneDrive", "OneDrive", ""},
    {"Nextcloud", "Nextcloud", ".nextcloudsync.log"},
    {"ownCloud", "ownCloud", ".owncloudsync.log"},
    {"Google Drive", "Google Drive", ""},
    {"Google Drive", "GoogleDrive", ""},
    {"iCloud", "iCloudDrive", ""},
    {"Syncthing", "", ".stfolder"},
}};

/// Spaces in the list of mounts are written as \040.
std::string withSpaces(const std::string &text)
{
    constexpr std::string_view escaped = "\\040";
    std::string plain;
    std::size_t begin = 0;
    for (auto at = text.find(escaped); at != std::string::npos; at = text.find(escaped, begin)) {
        plain += text.substr(begin, at - begin) + ' ';
        begin = at + escaped.size();
    }
    return plain + text.substr(begin);
}

std::optional<std::string_view> syncProgramOf(const std::filesystem::path &folder)
{
    for (std::filesystem::path each = folder; each.has_relative_path(); each = each.parent_path()) {
        for (const SyncProgram &program : syncPrograms) {
            const bool isNamedSo =
                !program.folder.empty() && each.filename().string().starts_with(program.folder);
            if (isNamedSo || (!program.mark.empty() && files::exists(each / program.mark)))
                return program.name;
        }
    }
    return std::nullopt;
}

} // namespace

std::string fileSystemOf(const std::filesystem::path &file, const std::string &mounts)
{
    std::istringstream lines(mounts);
    std::string line, kind;
    std::size_t longest = 0;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string device, location, name;
        words >> device >> location >> name;
        const std::filesystem::path mounted = withSpaces(location);
        const auto [rest, ignored] = std::mismatch(mounted.begin(), mounted.end(), file.begin(), file.end());
        // the last one of a mount point counts
        if (rest == mounted.end() && mounted.native().size() >= longest && !name.empty()) {
            longest = mounted.native().size();
            kind = name;
        }
    }
    return kind;
}

std::optional<Message> locationWarning(const std::filesystem::path &project)
{
    std::ifstream stream("/proc/self/mounts");
    return locationWarning(project, {std::istreambuf_iterator<char>(stream), {}});
}

std::optional<Message> locationWarning(const std::filesystem::path &project, const std::string &mounts)
{
    const std::filesystem::path file = files::realPath(project);
    const auto warning = [&](Message why) {
        return wholeMessage(projectSubject(project.filename()), std::move(why),
                            ODO_TEXT("project.keep_on_own_disk",
                                     "keep it on a disk of this computer, and pack it to share it"));
    };
    const std::string kind = fileSystemOf(file, mounts);
    if (std::ranges::find(networkFileSystems, kind) != networkFileSystems.end())
        return warning(ODO_TEXT(
            "project.on_network_disk",
            "it is on a network disk (%1): a recording can stall there, and two computers can damage it")(
            kind));
    if (const auto program = syncProgramOf(file.parent_path()))
        return warning(
            ODO_TEXT("project.in_synced_folder",
                     "it is in a folder that %1 copies while it changes: a copy may contain half a change")(
                std::string(*program)));
    return std::nullopt;
}

} // namespace odo
