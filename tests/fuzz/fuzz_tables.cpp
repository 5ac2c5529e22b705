// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/layout_csv.h"
#include "core/exchange/pixels_csv.h"
#include "core/exchange/roster_csv.h"
#include "core/exchange/shared_points_csv.h"
#include "tests/fuzz/fuzz_file.h"

/// Small tables: a marker layout, its pixels, points that two cameras share, a class roster. Each reader gets each text: they differ
/// by the header that they ask for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".csv");
    const std::filesystem::path &path = file.holding(bytes, count);
    static_cast<void>(readLayoutCsv(path));
    static_cast<void>(readPixelsCsv(path));
    static_cast<void>(readSharedPointsCsv(path));
    static_cast<void>(readRosterCsv(path));
    return 0;
}
