// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/read_project.h"
#include "tests/fuzz/sqlite_memory.h"

namespace {

/// What opening may have left beside the file: a log, and the backups of older versions.
void removeOthers(const std::filesystem::path &file)
{
    const std::string name = file.filename().string();
    std::vector<std::filesystem::path> others;
    for (const auto &each : std::filesystem::directory_iterator(file.parent_path())) {
        const std::string other = each.path().filename().string();
        if (other != name && other.starts_with(name))
            others.push_back(each.path());
    }
    for (const std::filesystem::path &other : others)
        std::filesystem::remove(other);
}

void readEverything(odo::Project &project)
{
    const odo::fuzz::Ids ids = odo::fuzz::idsOf(project);
    for (const auto read : odo::fuzz::readers<odo::Project>)
        read(project, ids);
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    odo::fuzz::givePlainMemoryToSqlite();
    return 0;
}

/// A whole project file, as anyone may send one: opened to read, and every eighth length to write, then read through.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".odo");
    const bool writes = count % 8 == 1;
    const std::filesystem::path &path = file.holding(bytes, count);
    bool isOpen = false;
    if (const auto project = Project::open(path, writes ? Project::Access::ReadWrite : Project::Access::ReadOnly)) {
        isOpen = true;
        static_cast<void>((*project)->title());
        static_cast<void>((*project)->changes());
        static_cast<void>((*project)->check(false));
        readEverything(**project);
    }
    if (writes || isOpen)
        removeOthers(path);
    return 0;
}
