// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>

/// The folder of real videos and pictures: the environment's ODOGRAPH_REAL_DATA, else ../shared/data beside
/// the sources.
inline std::filesystem::path realMaterial()
{
    if (qEnvironmentVariableIsSet("ODOGRAPH_REAL_DATA"))
        return qEnvironmentVariable("ODOGRAPH_REAL_DATA").toStdString();
    return std::filesystem::path(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR").toStdString()) /
           "../shared/data";
}

/// Skips the running test function, in words that the test runner knows, where a folder of the real material
/// is missing.
#define ODOGRAPH_NEED_REAL(folder)                                                                           \
    do {                                                                                                     \
        if (!std::filesystem::is_directory(realMaterial() / (folder)))                                       \
            QSKIP(qPrintable(                                                                                \
                QStringLiteral("ODOGRAPH-SKIPPED: no real material at %1; set ODOGRAPH_REAL_DATA")           \
                    .arg(QString::fromStdString((realMaterial() / (folder)).string()))));                    \
    } while (false)
