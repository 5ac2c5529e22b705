// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "core/workflow/revisions.h"

namespace odo {

namespace {

const std::pair<Revision::Kind, const char *> kinds[] = {{Revision::Kind::Calibration, "calibration"},
                                                         {Revision::Kind::Registration, "registration"}};

QString kindName(Revision::Kind kind) { return QString::fromLatin1(kinds[kind == Revision::Kind::Calibration ? 0 : 1].second); }

QJsonObject revisionJson(const Revision &revision)
{
    return {{QStringLiteral("kind"), kindName(revision.kind)},
            {QStringLiteral("id"), qint64(revision.id)},
            {QStringLiteral("made"), dateText(revision.made)},
            {QStringLiteral("software_version"), QString::fromStdString(revision.softwareVersion)},
            {QStringLiteral("origin"), QString::fromStdString(revision.origin)},
            {QStringLiteral("evidence"), revision.evidence},
            {QStringLiteral("rms_px"), revision.rmsPx},
            {QStringLiteral("verdict"), QString::fromStdString(revision.verdict)},
            {QStringLiteral("in_force"), revision.isCurrent},
            {QStringLiteral("trials"), sentencesJson(revision.trials)}};
}

QString revisionText(const Revision &revision)
{
    QString text = QStringLiteral("%1:%2  %3  %4, %5 px")
                       .arg(kindName(revision.kind))
                       .arg(revision.id)
                       .arg(dateText(revision.made), QString::fromStdString(revision.origin))
                       .arg(revision.rmsPx, 0, 'f', 2);
    if (!revision.trials.empty())
        text += QStringLiteral(", ") + counted(revision.trials.size(), QStringLiteral("trial"));
    return revision.isCurrent ? text + QStringLiteral(", in force") : text;
}

/// "registration:7" into its kind and number.
Result<std::pair<Revision::Kind, RecordId>> chosenOf(const CommandCall &call)
{
    const QString text = QString::fromStdString(call.value(option::use));
    bool isNumber = false;
    const RecordId id = text.section(u':', 1).toLongLong(&isNumber);
    for (const auto &[kind, name] : kinds)
        if (isNumber && text.section(u':', 0, 0) == QLatin1String(name))
            return std::pair(kind, id);
    return call.wrongCall(QStringLiteral("--use takes calibration:NUMBER or registration:NUMBER"));
}

} // namespace

Result<void> runRevisions(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("revisions"), QStringLiteral("P.odo CAMERA [--use calibration:N|registration:N] [--json]"), 2, 2,
                      {{option::use, QStringLiteral("Put this revision in force until the next one is made."), QStringLiteral("KIND:N")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto chosen = call.isSet(option::use) ? chosenOf(call) : std::pair<Revision::Kind, RecordId>();
    if (!chosen)
        return tl::unexpected(chosen.error());
    const auto project = call.openProject(0, call.isSet(option::use) ? Project::Access::ReadWrite : Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    if (call.isSet(option::use))
        if (auto done = chooseRevision(**project, call.text(1), chosen->first, chosen->second); !done)
            return done;
    const auto revisions = revisionsOf(**project, call.text(1));
    if (!revisions)
        return tl::unexpected(revisions.error());
    QJsonArray json;
    QStringList lines;
    for (const Revision &revision : *revisions) {
        json.append(revisionJson(revision));
        lines << revisionText(revision);
    }
    if (lines.isEmpty())
        lines << QStringLiteral("Camera %1 is neither calibrated nor registered.").arg(call.positional(1));
    call.answer({{QStringLiteral("camera"), call.positional(1)}, {QStringLiteral("revisions"), json}}, lines.join(u'\n'));
    return {};
}

} // namespace odo
