// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/checked_files.h"

#include "core/base/last_resort.h"
#include "core/base/shortage.h"
#include "core/files/protected_files.h"
#include "core/project/recording_rows.h"

#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <sys/stat.h>
#include <utility>

namespace odo {

namespace {

struct FileOnDisk
{
    FileIdentity id;
    std::int64_t bytes = 0;
};

/// NotFound where there is nothing, Io where the system does not say, InvalidInput where something else is in its place.
Result<FileOnDisk> onDisk(const std::filesystem::path &file)
{
    const std::string what = "file '" + file.string() + "'";
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) {
        const bool isMissing = errno == ENOENT || errno == ENOTDIR;
        return fail(isMissing ? ErrorCode::NotFound : ErrorCode::Io, what, std::string("it cannot be read (") + std::strerror(errno) + ")",
                    "check that the file is there and may be read");
    }
    if (!S_ISREG(status.st_mode))
        return fail(ErrorCode::InvalidInput, what, "it is a folder or a device, not a file", "put the original file back in its place");
    return FileOnDisk{{status.st_dev, status.st_ino}, status.st_size};
}

class FileCheck
{
public:
    FileCheck(const JobControl &control, std::vector<ProjectProblem> &problems) : m_control(control), m_problems(problems) {}

    /// Looks whether the files are there, and remembers those whose content is to be looked at.
    Result<void> compareSizes(const std::vector<KeptFile> &files)
    {
        for (const KeptFile &kept : files) {
            if (m_control.isCancelled())
                return cancelled("check of the project");
            auto known = m_onDisk.find(kept.file);
            if (known == m_onDisk.end())
                known = m_onDisk.emplace(kept.file, onDisk(kept.file)).first;
            const Result<FileOnDisk> &found = known->second;
            if (!found && found.error().code == ErrorCode::NotFound)
                report(kept, kept.name + " is missing", kept.adviceWhenMissing);
            else if (!found)
                report(kept, kept.name + ": " + found.error().why, found.error().advice);
            else if (found->bytes != kept.bytes)
                report(kept, kept.name + " has " + std::to_string(found->bytes) + " bytes instead of " + std::to_string(kept.bytes),
                       "put the original file back in its place");
            else if (!kept.sha256.empty())
                m_whole.push_back(&kept);
        }
        return {};
    }

    Result<void> compareHashes()
    {
        std::int64_t all = 0, done = 0;
        std::set<FileIdentity> counted;
        for (const KeptFile *kept : m_whole) {
            const FileOnDisk &file = *m_onDisk.at(kept->file);
            all += counted.insert(file.id).second ? file.bytes : 0;
        }
        std::map<FileIdentity, Result<std::string>> hashes;
        for (const KeptFile *kept : m_whole) {
            const FileOnDisk &file = *m_onDisk.at(kept->file);
            auto known = hashes.find(file.id);
            if (known == hashes.end()) {
                m_control.report(double(done) / double(std::max<std::int64_t>(all, 1)), "reading " + kept->file.filename().string());
                known = hashes.emplace(file.id, fileSha256(kept->file, m_control)).first;
                done += file.bytes;
            }
            const Result<std::string> &hash = known->second;
            if (!hash && hash.error().code == ErrorCode::Cancelled)
                return cancelled("check of the project");
            if (const char *shortage = hash ? nullptr : shortageNowOfSystem()) // which says nothing of the file
                return fail(ErrorCode::Unavailable, "check of the project", shortage, shortageAdvice);
            if (!hash)
                report(*kept, kept->name + ": " + hash.error().why, hash.error().advice);
            else if (*hash != kept->sha256)
                report(*kept, kept->name + " was changed since it was made", "put the original file back in its place");
        }
        return {};
    }

private:
    void report(const KeptFile &kept, const std::string &what, const std::string &advice)
    {
        if (m_reported.emplace(kept.file, what).second)
            m_problems.push_back({what, kept.file.string(), advice});
    }

    const JobControl &m_control;
    std::vector<ProjectProblem> &m_problems;
    std::map<std::filesystem::path, Result<FileOnDisk>> m_onDisk;
    std::vector<const KeptFile *> m_whole; ///< there, of the right size, and with a hash
    std::set<std::pair<std::filesystem::path, std::string>> m_reported;
};

} // namespace

Result<void> checkFiles(const std::vector<KeptFile> &files, bool withHashes, const JobControl &control, std::vector<ProjectProblem> &problems)
{
    FileCheck check(control, problems);
    if (auto compared = check.compareSizes(files); !compared || !withHashes)
        return compared;
    return check.compareHashes();
}

} // namespace odo
