// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/task_file.h"
#include "tests/fuzz/fuzz_file.h"

/// A task: gates, reference path, limits and zones in JSON or YAML.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".json");
    if (const auto task = readTaskFile(file.holding(bytes, count)))
        static_cast<void>(checkTask(*task));
    return 0;
}
