// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/project_archive.h"
#include "tests/fuzz/fuzz_file.h"

namespace {

/// All that may be there after unpacking: ordinary files and folders.
void checkUnpacked(const std::filesystem::path &folder)
{
    for (const auto &each : std::filesystem::recursive_directory_iterator(folder)) {
        if (each.is_symlink() || !(each.is_regular_file() || each.is_directory())) {
            std::fprintf(stderr, "unpacked: %s\n", each.path().c_str());
            std::abort();
        }
    }
}

} // namespace

/// A packed project. Unpacked into a scratch folder; around it nothing may appear.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".zip");
    static const std::filesystem::path around =
        std::filesystem::temp_directory_path() / ("around_" + std::to_string(::getpid()));
    static const bool isMade = std::filesystem::create_directories(around / "in");
    static_cast<void>(isMade);
    if (unpackArchive(file.holding(bytes, count), around / "in" / "unpacked", {})) {
        checkUnpacked(around / "in" / "unpacked");
        std::filesystem::remove_all(around / "in" / "unpacked");
    }
    const auto countIn = [](const std::filesystem::path &folder) {
        return std::distance(std::filesystem::directory_iterator(folder),
                             std::filesystem::directory_iterator());
    };
    if (countIn(around) != 1 || countIn(around / "in") != 0) {
        std::fprintf(stderr, "something is left in %s\n", around.c_str());
        std::abort();
    }
    return 0;
}
