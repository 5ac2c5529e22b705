// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/labelled_points.h"
#include "core/exchange/roster_csv.h"
#include "tests/fuzz/fuzz_file.h"

/// Small tables: a marker layout, its pixels, points that two cameras share, a class roster. A text goes to
/// the reader whose header it has most of, because the others would look no further than that.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".csv");
    const std::filesystem::path &path = file.holding(bytes, count);
    const std::string_view text(reinterpret_cast<const char *>(bytes), count),
        header = text.substr(0, text.find('\n'));
    if (header.find("through") != std::string_view::npos)
        static_cast<void>(readSharedPointsCsv(path));
    else if (header.find("x_mm") != std::string_view::npos)
        static_cast<void>(readLayoutCsv(path));
    else if (header.find("label") != std::string_view::npos)
        static_cast<void>(readPixelsCsv(path));
    else
        static_cast<void>(readRosterCsv(path));
    return 0;
}
