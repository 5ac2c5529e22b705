// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/school_repository.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <filesystem>
#include <string>
#include <vector>

namespace odo {

class Project;

/// A row of a project with all that belongs to it, as the school's hub keeps it. The same row gives the same
/// bytes in every project.
struct SchoolDocument
{
    SchoolKind kind = SchoolKind::Trial;
    std::string name;
    QByteArray body; ///< CBOR, docs/project_file.md
    /// CBOR, of a trial that has recordings here: how they are synchronised, what they are, their frame
    /// times.
    QByteArray recordings;
    /// Of a trial: what each robot is listed by, {robot, name, team, shown_team, class, task, held_ms,
    /// duration_s, metrics[{name, unit, value, sigma, at_least}]}. Empty for one in the bin.
    QJsonArray results;
    std::string sha256; ///< of body and recordings
};

/// On the project's thread. Errors: those of the repositories; NotFound.
Result<SchoolDocument> makeSchoolDocument(Project &project, SchoolKind kind, RecordId row);

/// Writes a document from the hub through the repositories, in one transaction: into the row of that id, or,
/// for 0, into one of that name or a new one; a trial's name that is taken gets the owner's name behind it.
/// Gives the row. recordings: where they are at hand, of a trial that is new. Errors: InvalidInput, in one
/// line, for a document of wrong types, beyond the limits or with series that are broken; nothing is written
/// then.
Result<RecordId> storeSchoolDocument(Project &project, const SchoolDocument &document, RecordId row,
                                     const std::string &owner);

/// The views that a trial was recorded in, wherever its recordings are.
std::vector<std::string> viewsOf(const SchoolDocument &document);

/// A recording of a trial from elsewhere, as its bench described it.
struct RecordingElsewhere
{
    std::string camera, sha256;
    std::filesystem::path file; ///< at its bench
    std::int64_t bytes = 0;
};
/// Of SchoolDocument::recordings. InvalidInput, in one line, for what is damaged.
Result<std::vector<RecordingElsewhere>> recordingsElsewhere(const QByteArray &recordings);
/// Gives a trial without recordings those of its bench, whose files are here now, one for each, in one
/// transaction. Errors: InvalidInput as above, those of the repositories.
Result<void> attachRecordings(Project &project, RecordId trial, const QByteArray &recordings,
                              const std::vector<std::filesystem::path> &files);

/// What a person compares: the document without its series.
QJsonObject readableDocument(const SchoolDocument &document);

/// "trial 'Run 1'", of the kind and name of a document.
Message schoolDocumentSubject(SchoolKind kind, const std::string &name);

} // namespace odo
