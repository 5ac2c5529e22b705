// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/read_project.h"
#include "tests/fuzz/sqlite_memory.h"

#include <functional>
#include <string_view>

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

/// In one of the ways in which the program reads it: all of them would take as long as the rest together.
void readInOneWay(odo::Project &project, std::size_t which)
{
    const auto &readers = odo::fuzz::readers<odo::Project>;
    readers[which % readers.size()](project, odo::fuzz::idsOf(project));
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    odo::fuzz::givePlainMemoryToSqlite();
    return 0;
}

/// A whole project file, as anyone may send one: opened to read, and every eighth length to write, looked
/// through, and read in a way that depends on all of its bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".odo");
    const bool writes = count % 8 == 1;
    const std::filesystem::path &path = file.holding(bytes, count);
    bool isOpen = false;
    if (const auto project =
            Project::open(path, writes ? Project::Access::ReadWrite : Project::Access::ReadOnly)) {
        isOpen = true;
        static_cast<void>((*project)->title());
        static_cast<void>((*project)->changes());
        static_cast<void>((*project)->check(false));
        readInOneWay(**project,
                     std::hash<std::string_view>()({reinterpret_cast<const char *>(bytes), count}));
    }
    if (writes || isOpen)
        removeOthers(path);
    return 0;
}
