// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fault/injected_fault.h"

namespace odo::test {

/// Something that writes: what is in its folder before, and what it does there, step by step.
struct UseCase
{
    QString name;
    std::function<void(const std::filesystem::path &folder)> prepare;
    Work work;
};

/// Saving changes one by one, making, copying, packing, unpacking, exporting, importing, measuring, removing
/// for good.
std::vector<UseCase> writingUseCases();

/// Opening a project of an older format.
UseCase migration(int format);

} // namespace odo::test
