// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_units.h"

#include <array>
#include <atomic>

namespace odo {
namespace {

constexpr double inch = 0.0254, foot = 12 * inch; // exactly so since 1959

std::atomic<UnitSystem> shown = UnitSystem::Millimetres;

const std::array<QString, 3> &words()
{
    static const std::array<QString, 3> all{QStringLiteral("mm"), QStringLiteral("cm"), QStringLiteral("in")};
    return all;
}

} // namespace

UnitSystem unitSystemFromWord(const QString &word)
{
    for (std::size_t i = 0; i < words().size(); ++i) {
        if (words()[i] == word)
            return static_cast<UnitSystem>(i);
    }
    return UnitSystem::Millimetres;
}

QString unitSystemWord(UnitSystem system)
{
    return words()[static_cast<std::size_t>(system)];
}

const ShownUnits &unitsOf(UnitSystem system)
{
    static const std::array<ShownUnits, 3> all{{
        {{QStringLiteral("mm"), 1000},
         {QStringLiteral("m"), 1},
         {QStringLiteral("m/s"), 1},
         {QStringLiteral("m/s²"), 1}},
        {{QStringLiteral("cm"), 100},
         {QStringLiteral("cm"), 100},
         {QStringLiteral("cm/s"), 100},
         {QStringLiteral("cm/s²"), 100}},
        {{QStringLiteral("in"), 1 / inch},
         {QStringLiteral("ft"), 1 / foot},
         {QStringLiteral("ft/s"), 1 / foot},
         {QStringLiteral("ft/s²"), 1 / foot}},
    }};
    return all[static_cast<std::size_t>(system)];
}

UnitSystem shownUnitSystem()
{
    return shown;
}

void setShownUnitSystem(UnitSystem system)
{
    shown = system;
}

const ShownUnits &shownUnits()
{
    return unitsOf(shown);
}

} // namespace odo
