// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/school_sync.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/school/internal/hub_session.h"
#include "core/school/internal/school_media.h"
#include "core/school/internal/standing_marks.h"

#include <algorithm>
#include <map>
#include <utility>

namespace odo {

namespace {

constexpr int documentsAtOnce = 20;

Result<void> checkMedia(const SchoolLink &link, WithRecordings recordings)
{
    if (recordings == WithRecordings::No || !link.media.empty())
        return {};
    return fail(ErrorCode::NotFound, ODO_TEXT("school.media", "media folder of the school"),
                ODO_TEXT("school.no_media", "the project is connected without one"),
                ODO_TEXT("school.connect_with_media", "connect it again with --media FOLDER"));
}

/// Of the trials from elsewhere that have none here.
Result<void> pullAllRecordings(Project &project, HubSession &hub, const std::filesystem::path &folder,
                               const JobControl &control, SchoolReport &report)
{
    const SchoolRepository &school = project.school();
    const auto trials = ODO_TRY(project.trials().all());
    for (const TrialRecord &trial : trials) {
        const auto identity = ODO_TRY(school.known(SchoolKind::Trial, trial.id));
        if (trial.viewCount > 0 || !identity || identity->views.empty())
            continue;
        const auto recordings = ODO_TRY(
            hub.patiently([uuid = identity->uuid](SchoolHub &server) { return server.recordingsOf(uuid); }));
        if (!recordings.isEmpty())
            ODO_TRY(pullRecordings(project, trial.id, recordings, identity->owner, folder, control, report));
    }
    return {};
}

SchoolConflict conflictOf(const SchoolDocument &ours, const SchoolDocument &theirs, const std::string &uuid,
                          bool isOursInForce)
{
    return {ours.kind, uuid, ours.name, readableDocument(ours), readableDocument(theirs), isOursInForce};
}

/// Sends what is pending.
class Publisher
{
public:
    /// standings: of the project, as standingMarks().
    Publisher(Project &project, const SchoolLink &link, HubSession &hub,
              std::map<RecordId, QJsonObject> standings, SchoolReport &report)
        : m_project(project), m_school(project.school()), m_link(link), m_hub(hub),
          m_standings(std::move(standings)), m_report(report)
    {
    }

    Result<void> send(const OutboxEntry &entry)
    {
        if (!entry.removed.empty())
            return sendRemoval(entry);
        auto identity = ODO_TRY(m_school.identity(entry.kind, entry.row));
        const auto document = ODO_TRY(makeSchoolDocument(m_project, entry.kind, entry.row));
        if (identity.sha256 == document.sha256)
            return m_school.settle(entry);
        const auto standing = entry.kind == SchoolKind::Trial ? m_standings[entry.row] : QJsonObject();
        const auto outcome =
            ODO_TRY(m_hub.patiently([document, identity, standing, bench = m_link.bench](SchoolHub &hub) {
                return hub.publish(document, identity.uuid, bench, identity.revision, false, standing);
            }));
        using Kind = PublishOutcome::Kind;
        if (outcome.kind == Kind::Conflict || outcome.kind == Kind::Refused) {
            SchoolDocument theirs = document;
            theirs.body = outcome.other;
            m_report.conflicts.push_back(
                conflictOf(document, theirs, outcome.uuid, outcome.kind == Kind::Conflict));
        }
        m_report.sent += outcome.kind == Kind::Refused ? 0 : 1;
        identity.uuid = outcome.uuid;
        identity.owner = outcome.owner;
        identity.revision = outcome.kind == Kind::Refused ? 0 : outcome.revision;
        identity.sha256 = outcome.kind == Kind::Refused ? std::string() : document.sha256;
        return m_project.inTransaction([&]() -> Result<void> {
            ODO_TRY(m_school.setIdentity(identity));
            if (outcome.kind == Kind::Refused) // what the hub has instead comes with the next pull
                ODO_TRY(m_school.setPulled(std::min(m_link.pulled, outcome.revision - 1)));
            return m_school.settle(entry);
        });
    }

    /// What changed in standings without a change of the trials: acceptances, scorings, courses.
    Result<void> sendStandings()
    {
        QJsonArray standings;
        for (auto &[trial, standing] : m_standings) {
            const auto identity = ODO_TRY(m_school.known(SchoolKind::Trial, trial));
            if (!identity || identity->revision == 0)
                continue;
            standing[QStringLiteral("trial")] = QString::fromStdString(identity->uuid);
            standings.append(standing);
        }
        if (standings.isEmpty())
            return {};
        return m_hub.patiently(
            [standings, bench = m_link.bench](SchoolHub &hub) { return hub.setStandings(bench, standings); });
    }

private:
    Result<void> sendRemoval(const OutboxEntry &entry)
    {
        SchoolDocument document;
        document.kind = entry.kind;
        document.name = "-";
        document.sha256 = std::string(64, '0');
        ODO_TRY(m_hub.patiently([document, uuid = entry.removed, bench = m_link.bench](SchoolHub &hub) {
            return hub.publish(document, uuid, bench, 0, true);
        }));
        ++m_report.sent;
        return m_school.settle(entry);
    }

    Project &m_project;
    SchoolRepository &m_school;
    const SchoolLink &m_link;
    HubSession &m_hub;
    std::map<RecordId, QJsonObject> m_standings;
    SchoolReport &m_report;
};

/// Writes what the hub has into the project.
class Puller
{
public:
    Puller(Project &project, SchoolReport &report)
        : m_project(project), m_school(project.school()), m_report(report)
    {
    }

    Result<void> take(const HubDocument &hub)
    {
        const auto known = ODO_TRY(m_school.find(hub.uuid));
        if (known && known->revision >= hub.revision)
            return {};
        const SchoolKind kind = hub.document.kind;
        RecordId row = known ? known->row : 0;
        if (row == 0 && kind != SchoolKind::Trial)
            row = ODO_TRY(m_school.rowNamed(kind, hub.document.name));
        if (hub.isRemoved)
            return remove(hub, row);
        if (row != 0 && ODO_TRY(m_school.isPending(kind, row)))
            return keepOurs(hub, row);
        return store(hub, row);
    }

private:
    Result<void> store(const HubDocument &hub, RecordId row)
    {
        const auto stored = m_project.inTransaction([&]() -> Result<void> {
            const auto id = ODO_TRY(storeSchoolDocument(m_project, hub.document, row, hub.owner));
            ODO_TRY(m_school.setIdentity({hub.document.kind, id, hub.uuid, hub.revision, hub.document.sha256,
                                          hub.owner, viewsOf(hub.document)}));
            return m_school.settle(hub.document.kind, id);
        });
        if (!stored && stored.error().code != ErrorCode::InvalidInput)
            return stored;
        if (!stored)
            m_report.warnings.push_back(wholeMessage(stored.error()));
        else
            ++m_report.received;
        return {};
    }

    /// A trial goes into the bin; class lists and tasks stay with those who use them.
    Result<void> remove(const HubDocument &hub, RecordId row)
    {
        if (hub.document.kind != SchoolKind::Trial || row == 0)
            return {};
        ++m_report.received;
        return m_project.inTransaction([&]() -> Result<void> {
            ODO_TRY(m_project.trials().setBinned(row, true));
            return m_school.settle(hub.document.kind, row);
        });
    }

    /// What was changed here and is not published yet stays: publishing it makes it the later one.
    Result<void> keepOurs(const HubDocument &hub, RecordId row)
    {
        const auto ours = ODO_TRY(makeSchoolDocument(m_project, hub.document.kind, row));
        auto identity = ODO_TRY(m_school.identity(hub.document.kind, row));
        if (ours.body == hub.document.body) {
            identity = {hub.document.kind, row,       hub.uuid,      hub.revision,
                        ours.sha256,       hub.owner, identity.views};
            return m_project.inTransaction([&]() -> Result<void> {
                ODO_TRY(m_school.setIdentity(identity));
                return m_school.settle(hub.document.kind, row);
            });
        }
        m_report.conflicts.push_back(conflictOf(ours, hub.document, hub.uuid, true));
        return {};
    }

    Project &m_project;
    SchoolRepository &m_school;
    SchoolReport &m_report;
};

} // namespace

Result<SchoolLink> schoolLink(const SchoolRepository &school)
{
    auto link = ODO_TRY(school.link());
    if (!link)
        return fail(
            ErrorCode::NotFound, ODO_TEXT("school.subject", "school hub"),
            ODO_TEXT("school.not_connected", "the project is not connected to one"),
            ODO_TEXT("school.connect_first",
                     "connect it with odograph school connect P.odo postgresql://user@host/database"));
    return std::move(*link);
}

Result<int> initialiseHub(const HubAddress &address)
{
    ODO_TRY(SchoolHub::makeDatabase(address));
    const auto hub = ODO_TRY(SchoolHub::connect(address));
    return hub->upgrade();
}

Result<SchoolLink> connectToSchool(Project &project, const HubAddress &address, const std::string &media,
                                   const JobControl &control)
{
    HubSession hub(address, control);
    ODO_TRY(hub.open());
    SchoolRepository &school = project.school();
    ODO_TRY(school.connect({address.url(), {}, hub.role(), hub.version(), media}));
    return schoolLink(school);
}

namespace {

/// What publishing and pulling have in common. work(link, hub, report): the rest.
template <class Work>
Result<SchoolReport> withHub(Project &project, WithRecordings recordings, const JobControl &control,
                             const SchoolContact &contact, const Work &work)
{
    SchoolRepository &school = project.school();
    const SchoolLink link = ODO_TRY(schoolLink(school));
    ODO_TRY(checkMedia(link, recordings));
    HubAddress address = ODO_TRY(HubAddress::parse(link.url));
    address.password = contact.password;
    HubSession hub(std::move(address), control);
    ODO_TRY(hub.open());
    SchoolReport own;
    SchoolReport &report = contact.report ? *contact.report : own;
    report = {};
    ODO_TRY(work(link, hub, report));
    ODO_TRY(school.setContact(hub.role(), hub.version(), instantNow()));
    report.pending = ODO_TRY(school.pending());
    return report;
}

} // namespace

Result<SchoolReport> publishToSchool(Project &project, WithRecordings recordings, const JobControl &control,
                                     const SchoolContact &contact)
{
    return withHub(
        project, recordings, control, contact,
        [&](const SchoolLink &link, HubSession &hub, SchoolReport &report) -> Result<void> {
            Publisher publisher(project, link, hub, ODO_TRY(standingMarks(project)), report);
            const auto entries = ODO_TRY(project.school().outbox());
            double done = 0;
            for (const OutboxEntry &entry : entries) {
                if (control.isCancelled())
                    return cancelled(hub.subject());
                hub.report(done++ / double(entries.size()), ODO_TEXT("school.publishing", "publishing"));
                ODO_TRY(publisher.send(entry));
            }
            ODO_TRY(publisher.sendStandings());
            return recordings == WithRecordings::Yes ? publishRecordings(project, link.media, control, report)
                                                     : Result<void>();
        });
}

Result<SchoolReport> pullFromSchool(Project &project, WithRecordings recordings, const JobControl &control,
                                    const SchoolContact &contact)
{
    return withHub(
        project, recordings, control, contact,
        [&](const SchoolLink &link, HubSession &hub, SchoolReport &report) -> Result<void> {
            Puller puller(project, report);
            std::int64_t revision = link.pulled;
            for (;;) {
                const auto documents =
                    ODO_TRY(hub.patiently([revision, bench = link.bench](SchoolHub &server) {
                        return server.since(revision, bench, documentsAtOnce);
                    }));
                for (const HubDocument &document : documents) {
                    if (control.isCancelled())
                        return cancelled(hub.subject());
                    hub.report(0, ODO_TEXT("school.receiving", "receiving %1")(
                                      schoolDocumentSubject(document.document.kind, document.document.name)));
                    ODO_TRY(puller.take(document));
                    revision = document.revision;
                }
                ODO_TRY(project.school().setPulled(revision));
                if (documents.empty())
                    break;
            }
            return recordings == WithRecordings::Yes
                       ? pullAllRecordings(project, hub, link.media, control, report)
                       : Result<void>();
        });
}

} // namespace odo
