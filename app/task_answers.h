// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QJsonObject>
#include <QStringList>

namespace odo {

/// A task with the fields that a task file has (core/exchange/task_file.h), and its name.
QJsonObject taskJson(const TaskRecord &record);

/// What a task adds to a robot's answer: gates, laps, and path where there is one.
void insertTaskAnswers(QJsonObject &robot, const Profile &profile);

/// Lines for people: the passages, and the laps with their sectors.
QStringList taskLines(const Profile &profile);
/// ", gate time 2.405 s ±0.002 s" and the like; empty without a task.
QString taskRemark(const Profile &profile);

} // namespace odo
