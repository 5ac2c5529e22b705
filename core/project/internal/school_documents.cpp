// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/school_documents.h"

#include "core/analysis/scoring.h"
#include "core/base/sha256.h"
#include "core/base/units.h"
#include "core/project/class_repository.h"
#include "core/project/internal/trial_document.h"
#include "core/project/internal/words.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <QCborValue>
#include <QJsonDocument>

namespace odo {

namespace {

constexpr std::size_t mostMembers = 1000, mostParts = 1000, mostPathPoints = 1'000'000;

Result<QCborMap> classDocument(Project &project, RecordId row)
{
    const auto record = ODO_TRY(project.classes().get(row));
    return QCborMap{{QStringLiteral("name"), documentText(record.name)},
                    {QStringLiteral("archived"), record.archived.has_value()}};
}

Result<QCborMap> teamDocument(Project &project, RecordId row)
{
    const auto teams = ODO_TRY(project.teams().all());
    const auto found = std::ranges::find(teams, row, &TeamRecord::id);
    if (found == teams.end())
        return fail(ErrorCode::NotFound, teamSubject(std::to_string(row)),
                    ODO_TEXT("project.school_row_gone", "it is no longer in the project"), publishAgain());
    QCborArray robots;
    for (const RecordId id : found->robots)
        robots.append(robotDocument(ODO_TRY(project.robots().get(id))));
    return QCborMap{{QStringLiteral("name"), documentText(found->name)},
                    {QStringLiteral("class"), documentText(found->className)},
                    {QStringLiteral("pseudonym"), documentText(found->pseudonym)},
                    {QStringLiteral("members"), documentTexts(found->members)},
                    {QStringLiteral("robots"), robots}};
}

Result<QCborMap> documentMap(Project &project, SchoolKind kind, RecordId row)
{
    switch (kind) {
    case SchoolKind::Class:
        return classDocument(project, row);
    case SchoolKind::Team:
        return teamDocument(project, row);
    case SchoolKind::Task: {
        const auto task = ODO_TRY(project.tasks().get(row));
        const auto scoring = ODO_TRY(project.tasks().scoring(row));
        return taskDocument(task, scoring);
    }
    case SchoolKind::Trial:
        break;
    }
    const auto trial = ODO_TRY(project.trials().get(row));
    return trialDocument(project, trial);
}

Result<RecordId> storeClass(Project &project, const DocumentFields &fields, RecordId row)
{
    const std::string name = fields.text("name");
    const bool isArchived = fields.flag("archived");
    if (row == 0)
        row = ODO_TRY(project.classes().add(name)).id;
    else
        ODO_TRY(project.classes().rename(row, name));
    const auto known = ODO_TRY(project.classes().get(row));
    if (known.archived.has_value() != isArchived)
        ODO_TRY(project.classes().setArchived(row, isArchived));
    return row;
}

Result<RecordId> storeTeam(Project &project, const DocumentFields &fields, RecordId row)
{
    TeamRecord team;
    team.id = row;
    team.name = fields.text("name");
    team.className = fields.text("class");
    team.pseudonym = fields.text("pseudonym");
    team.members = fields.texts("members", mostMembers);
    for (const DocumentFields &robot : fields.parts("robots", mostParts))
        team.robots.push_back(ODO_TRY(robotFor(project, robot)));
    if (row == 0)
        return ODO_TRY(project.teams().add(team)).id;
    ODO_TRY(project.teams().set(team));
    return row;
}

Result<RecordId> storeTask(Project &project, const DocumentFields &fields, RecordId row)
{
    TaskRecord task = taskIn(fields);
    const std::vector<Criterion> scoring = scoringIn(fields);
    if (!fields.isSound())
        return 0;
    if (row == 0) {
        row = ODO_TRY(project.tasks().add(task)).id;
    } else {
        ODO_TRY(project.tasks().rename(row, task.name));
        task.id = row;
        row = ODO_TRY(project.tasks().change(task)).id; // an earlier course stays for what was measured by it
    }
    ODO_TRY(project.tasks().setScoring(row, scoring));
    ODO_TRY(project.tasks().setArchived(row, task.archived.has_value()));
    return row;
}

Result<RecordId> storeMap(Project &project, SchoolKind kind, const DocumentFields &fields, RecordId row,
                          const std::string &owner)
{
    switch (kind) {
    case SchoolKind::Class:
        return storeClass(project, fields, row);
    case SchoolKind::Team:
        return storeTeam(project, fields, row);
    case SchoolKind::Task:
        return storeTask(project, fields, row);
    case SchoolKind::Trial:
        break;
    }
    return storeTrial(project, fields, row, owner);
}

/// Of this computer, not of the document.
bool isOwnFailure(ErrorCode code)
{
    return code == ErrorCode::Io || code == ErrorCode::ReadOnly || code == ErrorCode::Unavailable ||
           code == ErrorCode::Internal || code == ErrorCode::Cancelled;
}

/// What no person compares, and what is too long for a line.
QCborValue withoutSeries(const QCborValue &value)
{
    if (value.isMap()) {
        QCborMap map;
        for (const auto &[key, part] : value.toMap()) {
            const QString name = key.toString();
            if (name != QLatin1String("samples") && name != QLatin1String("points") &&
                name != QLatin1String("frame_times") && name != QLatin1String("spikes"))
                map.insert(key, withoutSeries(part));
        }
        return map;
    }
    if (value.isArray()) {
        QCborArray list;
        for (const QCborValue part : value.toArray())
            list.append(withoutSeries(part));
        return list;
    }
    return value;
}

} // namespace

Message publishAgain()
{
    return ODO_TEXT("project.school_publish_again", "publish again");
}

QCborMap robotDocument(const RobotRecord &robot)
{
    return {
        {QStringLiteral("name"), documentText(robot.name)},
        {QStringLiteral("colour"), documentText(robot.colour ? robot.colour->toString() : std::string())},
        {QStringLiteral("height_mode"), documentText(storedWord(heightModeWords, robot.heightMode))},
        {QStringLiteral("height_m"), documentOptional(robot.heightM)},
        {QStringLiteral("length_m"), documentOptional(robot.lengthM)},
        {QStringLiteral("width_m"), documentOptional(robot.widthM)},
        {QStringLiteral("drawing_colour"), documentText(storedWord(drawingColourWords, robot.drawingColour))},
        {QStringLiteral("forward_m"), robot.referenceM.x()},
        {QStringLiteral("left_m"), robot.referenceM.y()}};
}

Result<RecordId> robotFor(Project &project, const DocumentFields &fields)
{
    RobotRecord robot;
    robot.name = fields.text("name");
    if (const auto known = project.robots().find(robot.name))
        return known->id;
    if (const std::string colour = fields.text("colour"); !colour.empty()) {
        const auto parsed = parseColour(colour);
        if (!parsed)
            fields.refuse("colour");
        else
            robot.colour = *parsed;
    }
    robot.heightMode = wordIn<RobotRecord::Height>(fields, "height_mode", heightModeWords);
    robot.heightM = fields.optionalReal("height_m");
    robot.lengthM = fields.optionalReal("length_m");
    robot.widthM = fields.optionalReal("width_m");
    robot.drawingColour = wordIn<DrawingColour>(fields, "drawing_colour", drawingColourWords);
    robot.referenceM = {fields.real("forward_m"), fields.real("left_m")};
    return ODO_TRY(project.robots().add(robot)).id;
}

QCborMap taskDocument(const TaskRecord &record, const std::vector<Criterion> &scoring)
{
    const Task &task = record.task;
    QCborArray gates, zones, criteria;
    for (const Gate &gate : task.gates)
        gates.append(QCborMap{{QStringLiteral("name"), documentText(gate.name)},
                              {QStringLiteral("role"), documentText(storedWord(gateRoleWords, gate.role))},
                              {QStringLiteral("ends_m"), documentPoints({gate.from, gate.to})}});
    for (const Zone &zone : task.zones)
        zones.append(QCborMap{{QStringLiteral("name"), documentText(zone.name)},
                              {QStringLiteral("rule"), documentText(storedWord(zoneRuleWords, zone.rule))},
                              {QStringLiteral("corners_m"), documentPoints(zone.corners)}});
    for (const Criterion &criterion : scoring)
        criteria.append(QCborMap{{QStringLiteral("metric"), documentText(criterion.metric)},
                                 {QStringLiteral("full_at"), criterion.fullAt},
                                 {QStringLiteral("none_at"), criterion.noneAt},
                                 {QStringLiteral("points"), criterion.points}});
    return {{QStringLiteral("name"), documentText(record.name)},
            {QStringLiteral("template"), documentText(storedWord(taskTemplateWords, task.kind))},
            {QStringLiteral("gates"), gates},
            {QStringLiteral("zones"), zones},
            {QStringLiteral("path_m"), documentPoints(task.path.points)},
            {QStringLiteral("path_closed"), task.path.closed},
            {QStringLiteral("max_speed_m_s"), documentOptional(task.limits.maxSpeedMps)},
            {QStringLiteral("max_accel_m_s2"), documentOptional(task.limits.maxAccelMps2)},
            {QStringLiteral("archived"), record.archived.has_value()},
            {QStringLiteral("scoring"), criteria}};
}

TaskRecord taskIn(const DocumentFields &fields)
{
    TaskRecord record;
    record.name = fields.text("name");
    record.task.kind = wordIn<TaskTemplate>(fields, "template", taskTemplateWords);
    for (const DocumentFields &gate : fields.parts("gates", mostParts)) {
        const auto ends = pointsIn(gate, "ends_m", 2);
        if (ends.size() != 2) {
            gate.refuse("ends_m");
            continue;
        }
        record.task.gates.push_back(
            {gate.text("name"), wordIn<GateRole>(gate, "role", gateRoleWords), ends[0], ends[1]});
    }
    for (const DocumentFields &zone : fields.parts("zones", mostParts))
        record.task.zones.push_back({zone.text("name"), wordIn<ZoneRule>(zone, "rule", zoneRuleWords),
                                     pointsIn(zone, "corners_m", mostParts)});
    record.task.path = {pointsIn(fields, "path_m", mostPathPoints), fields.flag("path_closed")};
    record.task.limits = {fields.optionalReal("max_speed_m_s"), fields.optionalReal("max_accel_m_s2")};
    if (fields.flag("archived"))
        record.archived = Instant();
    return record;
}

std::vector<Criterion> scoringIn(const DocumentFields &fields)
{
    std::vector<Criterion> criteria;
    for (const DocumentFields &one : fields.parts("scoring", mostParts))
        criteria.push_back(
            {one.text("metric"), one.real("full_at"), one.real("none_at"), one.real("points")});
    return criteria;
}

Message schoolDocumentSubject(SchoolKind kind, const std::string &name)
{
    switch (kind) {
    case SchoolKind::Class:
        return classSubject(name);
    case SchoolKind::Team:
        return teamSubject(name);
    case SchoolKind::Task:
        return taskSubject(name);
    case SchoolKind::Trial:
        break;
    }
    return trialSubject(name);
}

Result<SchoolDocument> makeSchoolDocument(Project &project, SchoolKind kind, RecordId row)
{
    const auto map = ODO_TRY(documentMap(project, kind, row));
    SchoolDocument document;
    document.kind = kind;
    document.name = map.value(QStringLiteral("name")).toString().toStdString();
    document.body = map.toCborValue().toCbor();
    if (kind == SchoolKind::Trial) {
        const auto trial = ODO_TRY(project.trials().get(row));
        const auto recordings = ODO_TRY(recordingsDocument(project, trial));
        if (!recordings.isEmpty())
            document.recordings = recordings.toCborValue().toCbor();
        document.results = ODO_TRY(trialResults(project, trial));
    }
    Sha256 hash;
    hash.add(document.body.constData(), std::size_t(document.body.size()));
    hash.add(document.recordings.constData(), std::size_t(document.recordings.size()));
    document.sha256 = hash.hex();
    return document;
}

Result<RecordId> storeSchoolDocument(Project &project, const SchoolDocument &document, RecordId row,
                                     const std::string &owner)
{
    const Message what = schoolDocumentSubject(document.kind, document.name);
    const auto refuse = [&what](Message why) {
        return fail(ErrorCode::InvalidInput, what, std::move(why),
                    ODO_TEXT("project.school_ask_owner",
                             "nothing of it was taken over; ask for it to be published again"));
    };
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(document.body, &problem);
    if (problem.error != QCborError::NoError || !value.isMap())
        return refuse(ODO_TEXT("project.school_not_readable", "what the hub has of it cannot be read"));
    RecordId stored = row;
    std::string fault;
    const DocumentFields fields(value.toMap(), &fault);
    const auto faulty = [&] {
        return refuse(
            ODO_TEXT("project.school_field_wrong", "what the hub has of it is damaged: field '%1'")(fault));
    };
    const auto written = project.inTransaction([&]() -> Result<void> {
        const auto id = storeMap(project, document.kind, fields, row, owner);
        if (!fault.empty())
            return faulty();
        if (!id && isOwnFailure(id.error().code))
            return tl::unexpected(id.error());
        if (!id)
            return refuse(wholeMessage(id.error().what, id.error().why));
        stored = *id;
        return {};
    });
    if (!written)
        return tl::unexpected(written.error());
    return stored;
}

std::vector<std::string> viewsOf(const SchoolDocument &document)
{
    std::string fault;
    return DocumentFields(QCborValue::fromCbor(document.body).toMap(), &fault).texts("views", mostViews);
}

QJsonObject readableDocument(const SchoolDocument &document)
{
    return withoutSeries(QCborValue::fromCbor(document.body)).toJsonValue().toObject();
}

} // namespace odo
