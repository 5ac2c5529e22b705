// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/hash_job.h"

#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

namespace odo {

Result<void> HashJob::prepare(Project &project)
{
    const auto recordings = project.trials().unhashed();
    if (!recordings)
        return tl::unexpected(recordings.error());
    for (const RecordingRecord &recording : *recordings) {
        File file{recording.id, project.resolve(recording), recording.bytes, {}};
        std::error_code problem;
        const std::uintmax_t bytes = files::sizeOf(file.path, problem);
        if (!problem && bytes == static_cast<std::uintmax_t>(file.bytes))
            m_files.push_back(std::move(file));
    }
    return {};
}

Result<void> HashJob::run(const JobControl &control)
{
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        control.report(static_cast<double>(i) / static_cast<double>(m_files.size()),
                       "making the hash of " + m_files[i].path.filename().string());
        auto hash = fileSha256(m_files[i].path, control);
        if (hash)
            m_files[i].sha256 = std::move(*hash);
        else if (hash.error().code == ErrorCode::Cancelled)
            return tl::unexpected(hash.error());
    }
    return {};
}

Result<void> HashJob::commit(Project &project)
{
    return project.inTransaction([&]() -> Result<void> {
        for (const File &file : m_files) {
            if (file.sha256.empty())
                continue;
            if (auto kept = project.trials().setHash(file.recording, file.sha256); !kept)
                return kept;
        }
        return {};
    });
}

} // namespace odo
