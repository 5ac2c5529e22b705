// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/project/school_documents.h"
#include "core/school/hub_address.h"

#include <QJsonObject>
#include <cstdint>
#include <string>
#include <vector>

namespace odo {

class Project;

/// That this project and another changed the same row since they last agreed. Both values; the one that is
/// not in force is kept at the hub as an older revision, or here until it is published.
struct SchoolConflict
{
    SchoolKind kind = SchoolKind::Trial;
    std::string uuid, name;
    QJsonObject ours, theirs;
    bool isOursInForce = false;
};

/// What publishing or pulling did.
struct SchoolReport
{
    int sent = 0, received = 0;
    std::vector<SchoolConflict> conflicts;
    std::int64_t mediaBytes = 0;   ///< of recordings that were copied
    std::int64_t pending = 0;      ///< changes that are still to be sent
    std::vector<Message> warnings; ///< of documents that were left out: the rest was done
};

/// Whether recordings go to the media folder, or come from it, too.
enum class WithRecordings { No, Yes };

/// What an exchange may need besides.
struct SchoolContact
{
    std::string password = {};      ///< as HubAddress::password
    SchoolReport *report = nullptr; ///< gets what was done, also where the rest fails; null: nowhere
};

/// Makes or upgrades the hub: its database where there is none, schema and roles. Gives the schema's version.
/// Any thread.
Result<int> initialiseHub(const HubAddress &address);

/// Ties a project to the hub, after asking who the login is. Everything in it becomes pending. media: the
/// folder for recordings; empty: none. Errors: isPasswordNeeded(), those of SchoolHub, Cancelled.
Result<SchoolLink> connectToSchool(Project &project, const HubAddress &address, const std::string &media,
                                   const JobControl &control = {});

/// The hub that a project is connected to. NotFound: none.
Result<SchoolLink> schoolLink(const SchoolRepository &school);

/// Sends what is pending, a document at a time, each acknowledged in the project; whatever ends it, the next
/// call goes on. A server that goes away meanwhile is waited for, half a minute, and one that does not answer
/// two; a cancellation waits for neither. On the project's thread. Errors: NotFound for a project that is not
/// connected, isPasswordNeeded(), those of SchoolHub and of the repositories, Cancelled.
Result<SchoolReport> publishToSchool(Project &project, WithRecordings recordings, const JobControl &control,
                                     const SchoolContact &contact = {});

/// Brings class lists, tasks and the trials of others, a transaction each. Rows that were changed here and
/// not yet published stay as they are and are reported. A document that cannot be read is left out with a
/// warning. Errors as above.
Result<SchoolReport> pullFromSchool(Project &project, WithRecordings recordings, const JobControl &control,
                                    const SchoolContact &contact = {});

} // namespace odo
