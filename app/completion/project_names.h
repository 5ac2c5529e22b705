// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>

namespace odo {

/// Takes a name that a word may be completed to, and what is said beside it (may be empty).
using NameSink = std::function<void(const QString &name, const QString &remark)>;

/// Gives the names that a project has for what a word of the help stands for: TRIAL, CAMERA, R (robot), TASK,
/// TEAM, CLASS, LAYOUT, METRIC; none for others, and none of a project that cannot be read. Writes nothing,
/// so a project of an older format may give none either. Quick. One thread.
void namesInProject(const std::filesystem::path &file, const QString &kind, const NameSink &take);

} // namespace odo
