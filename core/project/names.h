// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QString>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// What a project may hold: refused where it is entered, and where a file holds more, the rest is not read.
/// docs/limits.md lists them with those defined elsewhere (isOnFloor, checkTask, maxBlobRows).

/// In characters of Unicode.
constexpr int maxNameLength = 200, maxTextLength = 20'000;
/// No quantity of ours is larger.
constexpr double largestNumber = 1e12;
/// A stored number as it is read; 0 for what is no number, which only another program can have written.
constexpr double bounded(double value)
{
    return value >= -largestNumber ? std::min(value, largestNumber) : value < 0 ? -largestNumber : 0;
}
constexpr std::size_t mostViews = 16, mostRobots = 32, mostTags = 50, mostVariables = 50; ///< of a trial
constexpr std::size_t mostMarkers = 1000;                                                 ///< of a layout
constexpr int largestRobotM = 10;
/// Frames a second that a camera may be said to have taken.
constexpr double lowestFrameRate = 0.1, highestFrameRate = 100'000;
/// The largest time offset that may be given between two views or runs.
constexpr double largestOffsetS = 3600;

struct ProjectConnection;

/// "project 'run.odo'". file: as it is to be named, with its folders or without.
Message projectSubject(const std::filesystem::path &file);

/// What is called by a name or known by a number. The first seven have tables with a column "name".
enum class RecordKind {
    Camera,
    Robot,
    Team,
    Class,
    Task,
    Trial,
    Layout,
    Marker,
    Member,
    Pseudonym,
    Track,
    Gate,
    Zone,
    Metric,
    Tag,
    Variable,
    Calibration,
    Registration,
    Intrinsics,
};

/// A name as it is stored and compared: composed (NFC), without blanks around it.
std::string normalName(const std::string &name);

/// A name as people may give it to a camera, robot, team, trial…: UTF-8, something to be seen, at most 200
/// characters, no control, invisible or directional characters or line breaks.
Result<void> checkName(RecordKind kind, const std::string &name);

/// A project's title as people may give it: as a name.
Result<void> checkTitle(const std::string &title);

/// The title of a project that nobody gave one: what its file is called, as a name.
std::string titleFromName(const std::filesystem::path &file);

/// With … in place of the rest of a longer text.
QString firstCharacters(const QString &text, int most);

/// A stored name as it is shown: of one line, with what is hidden in it made visible, and … in place of what
/// is too long.
std::string shownName(const QString &stored);

/// A text that may be empty and of several lines: UTF-8 and at most 20,000 characters.
Result<void> checkText(const Message &what, const std::string &text);

/// The row of that name, in one of the ways in which it can be written or is shown; 0 without one.
Result<RecordId> idNamed(const ProjectConnection &connection, RecordKind kind, const std::string &name);

/// AlreadyExists when there is one of that name.
Result<void> checkNameIsFree(const ProjectConnection &connection, RecordKind kind, const std::string &name);

/// The NotFound of a name: "robot 'x': there is no such robot in the project; it has 'red', 'blue'".
tl::unexpected<Error> noSuchName(const ProjectConnection &connection, RecordKind kind,
                                 const std::string &name);

/// The NotFound of an id that refers to nothing.
tl::unexpected<Error> noSuchId(const ProjectConnection &connection, RecordKind kind, std::int64_t id);

/// The id of the row of that name in a table that has only names (class, task), made when it is new.
/// 0 for an empty name.
Result<RecordId> idOfName(ProjectConnection &connection, RecordKind kind, const std::string &name);

/// The first column of every row that a statement gives, as texts.
Result<std::vector<std::string>> textsOf(const ProjectConnection &connection, const QString &sql);

/// Runs a statement whose only parameter is an id.
Result<void> runFor(const ProjectConnection &connection, const char *sql, RecordId id);

} // namespace odo
