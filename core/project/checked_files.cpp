// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/checked_files.h"

#include "core/files/protected_files.h"
#include "core/project/recording_rows.h"

#include <map>
#include <optional>
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

std::optional<FileOnDisk> onDisk(const std::filesystem::path &file)
{
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
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
            const auto known = m_onDisk.try_emplace(kept.file);
            if (known.second)
                known.first->second = onDisk(kept.file);
            const std::optional<FileOnDisk> &found = known.first->second;
            if (!found)
                report(kept, kept.name + " is missing", kept.adviceWhenMissing);
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
            const FileOnDisk &file = *m_onDisk[kept->file];
            all += counted.insert(file.id).second ? file.bytes : 0;
        }
        std::map<FileIdentity, std::string> hashes; ///< empty: it cannot be read
        for (const KeptFile *kept : m_whole) {
            const FileOnDisk &file = *m_onDisk[kept->file];
            const auto [known, isNew] = hashes.try_emplace(file.id);
            if (isNew) {
                m_control.report(double(done) / double(std::max<std::int64_t>(all, 1)), "reading " + kept->file.filename().string());
                auto hash = fileSha256(kept->file, m_control);
                if (!hash && hash.error().code == ErrorCode::Cancelled)
                    return cancelled("check of the project");
                known->second = hash.value_or(std::string());
                done += file.bytes;
            }
            if (known->second.empty())
                report(*kept, kept->name + " cannot be read", "check the disk");
            else if (known->second != kept->sha256)
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
    std::map<std::filesystem::path, std::optional<FileOnDisk>> m_onDisk;
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
