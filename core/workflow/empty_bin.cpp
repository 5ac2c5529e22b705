// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/empty_bin.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <set>

namespace odo {

namespace {

bool isInside(const std::filesystem::path &file, const std::filesystem::path &folder)
{
    const auto normal = file.lexically_normal(), base = folder.lexically_normal();
    return std::mismatch(base.begin(), base.end(), normal.begin(), normal.end()).first == base.end();
}

} // namespace

Result<BinContent> binContent(Project &project)
{
    const auto names = project.trials().names();
    if (!names)
        return tl::unexpected(names.error());
    BinContent content;
    for (const TrialName &name : *names) {
        if (!name.binned)
            continue;
        content.trials.push_back(name.id);
        const auto recordings = project.trials().recordings(name.id);
        if (!recordings)
            return tl::unexpected(recordings.error());
        for (const RecordingRecord &recording : *recordings)
            content.bytes += recording.bytes;
    }
    return content;
}

Result<std::vector<std::string>> emptyBin(Project &project, const BinContent &content)
{
    std::set<std::string> paths;
    auto removed = project.inTransaction([&]() -> Result<void> {
        for (const RecordId trial : content.trials) {
            const auto files = project.trials().removeForGood(trial);
            if (!files)
                return tl::unexpected(files.error());
            paths.insert(files->begin(), files->end());
        }
        return {};
    });
    if (!removed)
        return tl::unexpected(removed.error());
    std::vector<std::string> left;
    for (const std::string &path : paths) {
        RecordingRecord recording;
        recording.path = path;
        const std::filesystem::path file = project.resolve(recording);
        const auto used = project.trials().isFileUsed(path);
        if (!used || *used || !isInside(file, project.mediaFolder()))
            continue;
        std::error_code problem;
        std::filesystem::remove(file, problem);
        if (problem)
            left.push_back(file.string());
    }
    return left;
}

} // namespace odo
