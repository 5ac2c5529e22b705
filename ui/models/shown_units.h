// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo {

/// What a person wants results to be shown in. Targets and markers are set up in millimetres in each of them,
/// as they are printed; files and the command line do not know of it.
enum class UnitSystem { Millimetres, Centimetres, Inches };

/// "mm", "cm", "in": the word kept in the settings; another one is Millimetres.
UnitSystem unitSystemFromWord(const QString &word);
QString unitSystemWord(UnitSystem system);

/// A unit of a quantity.
struct ShownUnit
{
    QString name;     ///< "m/s"
    double perSi = 1; ///< so many make one of the SI's
};

/// The units of one system.
struct ShownUnits
{
    ShownUnit length;         ///< of errors and heights
    ShownUnit distance;       ///< of ways driven
    ShownUnit speed, acceleration;
};
const ShownUnits &unitsOf(UnitSystem system);

/// Those of the whole program, as QLocale() is its locale. Any thread. What is on the screen already stays as it
/// is until it is made anew.
UnitSystem shownUnitSystem();
void setShownUnitSystem(UnitSystem system);
const ShownUnits &shownUnits();

} // namespace odo
