// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trials/trial_changes.h"

#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/trial_commands.h"
#include "app/completion/shell_line.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/stored_verdicts.h"
#include "core/workflow/track/synchronise_job.h"
#include "core/workflow/trials/trial_copy.h"

#include <QDateTime>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

struct Verb
{
    QString word;
    QStringList options; ///< that go with it
    Result<void> (*run)(const CommandCall &call, Project &project, const TrialRecord &trial);
};

QJsonObject trialJson(const TrialRecord &trial)
{
    return {{QStringLiteral("trial"), QString::fromStdString(trial.name)},
            {QStringLiteral("team"), QString::fromStdString(trial.teamName)},
            {QStringLiteral("class"), QString::fromStdString(trial.className)},
            {QStringLiteral("task"), QString::fromStdString(trial.task)},
            {QStringLiteral("date"), dateText(trial.date)},
            {QStringLiteral("robots"), namesJson(trial.robotNames)},
            {QStringLiteral("notes"), QString::fromStdString(trial.notes)},
            {QStringLiteral("tags"), namesJson(trial.tags)},
            {QStringLiteral("variables"), variablesJson(trial)},
            {QStringLiteral("duration_s"), trial.durationS},
            {QStringLiteral("sync"), syncJson(trial)},
            {QStringLiteral("range"), rangeJson(trial)},
            {QStringLiteral("views"), trial.viewCount},
            {QStringLiteral("in_bin"), trial.binned.has_value()}};
}

QString orNone(const std::string &name)
{
    return name.empty() ? QStringLiteral("none") : QString::fromStdString(name);
}

QString trialText(const TrialRecord &trial)
{
    QStringList robots;
    for (const std::string &robot : trial.robotNames)
        robots << QString::fromStdString(robot);
    QStringList lines{QStringLiteral("Trial %1").arg(QString::fromStdString(trial.name)),
                      QStringLiteral("  team    %1").arg(orNone(trial.teamName)),
                      QStringLiteral("  class   %1").arg(orNone(trial.className)),
                      QStringLiteral("  task    %1").arg(orNone(trial.task)),
                      QStringLiteral("  date    %1").arg(dateText(trial.date)),
                      QStringLiteral("  robots  %1")
                          .arg(robots.isEmpty() ? orNone({}) : robots.join(QStringLiteral(", ")))};
    for (const auto &[name, value] : trial.variables)
        lines << QStringLiteral("  %1 = %2").arg(QString::fromStdString(name), QString::fromStdString(value));
    if (trial.range)
        lines << QStringLiteral("  range   %1 s to %2 s")
                     .arg(toSeconds(trial.range->begin), 0, 'f', 3)
                     .arg(toSeconds(trial.range->end), 0, 'f', 3);
    if (!trial.notes.empty())
        lines << QStringLiteral("  notes   %1").arg(QString::fromStdString(trial.notes).simplified());
    return lines.join(u'\n');
}

/// ISO 8601: a day, or a moment; in the time of this computer unless it has a zone.
Result<Instant> dateOf(const CommandCall &call)
{
    static const QRegularExpression form(QRegularExpression::anchoredPattern(QStringLiteral(
        "[0-9]{4}-[0-9]{2}-[0-9]{2}"
        "([T ][0-9]{2}:[0-9]{2}(:[0-9]{2}([.,][0-9]{1,9})?)?(Z|[+-][0-9]{2}(:?[0-9]{2})?)?)?")));
    const QString text = QString::fromStdString(call.value(option::date));
    const QDateTime date = QDateTime::fromString(text, Qt::ISODateWithMs);
    if (!form.match(text).hasMatch() || !date.isValid() || date.toMSecsSinceEpoch() < 0)
        return call.wrongCall(ODO_TEXT(
            "app.date_is",
            "--date '%1' is not an ISO 8601 date since 1970, such as 2026-11-29 or 2026-11-29T10:30")(
            call.value(option::date)));
    return Instant(std::chrono::milliseconds(date.toMSecsSinceEpoch()));
}

/// KEY=VALUE; KEY= removes it.
Result<std::map<std::string, std::string>> variablesOf(const CommandCall &call)
{
    std::map<std::string, std::string> variables;
    for (const std::string &text : call.texts(option::variable)) {
        const auto equals = text.find('=');
        if (equals == 0 || equals == std::string::npos)
            return call.wrongCall(
                ODO_TEXT("app.variable_is",
                         "--var '%1' is not KEY=VALUE, such as surface=carpet, or KEY= to remove it")(text));
        variables.insert_or_assign(text.substr(0, equals), text.substr(equals + 1));
    }
    return variables;
}

/// FROM,TO in seconds, motion or none.
Result<RangeChoice> rangeChoiceOf(const CommandCall &call)
{
    const QString text = QString::fromStdString(call.value(option::range)).trimmed();
    if (text == QLatin1String("motion"))
        return RangeChoice(RangeOfMotion());
    if (text == QLatin1String("none"))
        return RangeChoice(WholeRun());
    const QStringList parts = text.split(u',');
    std::vector<double> seconds;
    for (const QString &part : parts) {
        bool isNumber = false;
        const double number = part.trimmed().toDouble(&isNumber);
        if (isNumber && std::isfinite(number))
            seconds.push_back(number);
    }
    if (parts.size() != 2 || seconds.size() != 2)
        return call.wrongCall(ODO_TEXT(
            "app.range_is", "--range '%1' is not FROM,TO in seconds, such as 1.5,8, nor motion or none")(
            call.value(option::range)));
    return RangeChoice(RangeSeconds{seconds[0], seconds[1]});
}

std::optional<std::string> given(const CommandCall &call, const QString &option)
{
    return call.isSet(option) ? std::optional(call.value(option)) : std::nullopt;
}

Result<void> set(const CommandCall &call, Project &project, const TrialRecord &trial)
{
    TrialEdit edit{.name = given(call, option::name),
                   .team = given(call, option::team),
                   .className = given(call, option::ofClass),
                   .task = given(call, option::task),
                   .notes = given(call, option::note)};
    if (call.isSet(option::date)) {
        edit.date = ODO_TRY(dateOf(call));
    }
    if (call.isSet(option::robot))
        edit.robots = call.texts(option::robot);
    edit.variables = ODO_TRY(variablesOf(call));
    if (call.isSet(option::range)) {
        edit.range = ODO_TRY(rangeChoiceOf(call));
    }
    const bool isNewTeam = edit.team && !edit.team->empty() && !project.teams().find(*edit.team);
    std::optional<SynchroniseJob> sync;
    if (call.isSet(option::sync)) {
        sync.emplace(trial.name, ODO_TRY(stepsOf(call)));
        ODO_TRY(sync->prepare(project));
        ODO_TRY(sync->run(call.control()));
    }
    const auto store = [&]() -> Result<TrialRecord> {
        if (sync)
            ODO_TRY(sync->commit(project));
        return editTrial(project, trial.id, edit);
    };
    const bool areBoth = sync && !isEmpty(edit);
    const auto changed = ODO_TRY(areBoth ? changing(project, editTrialWords(trial.name), store) : store());
    QStringList lines{trialText(changed)};
    if (isNewTeam)
        lines << QStringLiteral("Team %1 is new.").arg(QString::fromStdString(changed.teamName));
    if (sync)
        lines << stepSentences(sync->recordings());
    call.answer(trialJson(changed), lines.join(u'\n'));
    for (const Message &warning : sync ? sync->warnings() : std::vector<Message>())
        CommandCall::warn(warning);
    return {};
}

Result<void> moveTo(const CommandCall &call, Project &project, const TrialRecord &trial, bool isInBin)
{
    ODO_TRY(setInBin(project, {trial}, isInBin));
    const auto changed = ODO_TRY(project.trials().get(trial.id));
    const QString name = QString::fromStdString(trial.name);
    call.answer(trialJson(changed),
                isInBin
                    ? QStringLiteral("Trial %1 is in the bin; restore it with: odograph trial restore %2 %3")
                          .arg(name, quotedForShell(call.positional(1), ShellLine::Quote::None),
                               quotedForShell(name, ShellLine::Quote::None))
                    : QStringLiteral("Trial %1 is restored from the bin.").arg(name));
    return {};
}

Result<void> removeTrial(const CommandCall &call, Project &project, const TrialRecord &trial)
{
    if (trial.binned)
        return fail(ErrorCode::InvalidInput, trialSubject(trial.name),
                    ODO_TEXT("app.is_in_bin", "it is in the bin already"),
                    ODO_TEXT("app.empty_bin", "empty the bin in the window's History to remove it for good"));
    return moveTo(call, project, trial, true);
}

Result<void> restoreTrial(const CommandCall &call, Project &project, const TrialRecord &trial)
{
    if (!trial.binned)
        return fail(ErrorCode::InvalidInput, trialSubject(trial.name),
                    ODO_TEXT("app.is_not_in_bin", "it is not in the bin"),
                    ODO_TEXT("app.nothing_to_restore", "use it as it is"));
    return moveTo(call, project, trial, false);
}

Result<void> copy(const CommandCall &call, Project &project, const TrialRecord &trial)
{
    const auto copied = ODO_TRY(copyTrial(project, trial.name, call.value(option::name)));
    call.answer(
        trialJson(copied),
        QStringLiteral("Trial %1 copied to %2. It has no results yet: analyse it with odograph track.")
            .arg(QString::fromStdString(trial.name), QString::fromStdString(copied.name)));
    return {};
}

Result<void> answerAcceptance(const CommandCall &call, const TrialRecord &trial, bool isAccepted)
{
    const QString name = QString::fromStdString(trial.name);
    call.answer({{QStringLiteral("trial"), name}, {QStringLiteral("accepted"), isAccepted}},
                isAccepted ? QStringLiteral("The doubtful results of trial %1 are accepted.").arg(name)
                           : QStringLiteral("The results of trial %1 are no longer accepted.").arg(name));
    return {};
}

Result<void> accept(const CommandCall &call, Project &project, const TrialRecord &trial)
{
    ODO_TRY(acceptVerdict(project, trial.name, call.value(option::reason)));
    return answerAcceptance(call, trial, true);
}

Result<void> withdraw(const CommandCall &call, Project &project, const TrialRecord &trial)
{
    ODO_TRY(withdrawAcceptance(project, trial.name));
    return answerAcceptance(call, trial, false);
}

const QList<Verb> &verbs()
{
    static const QList<Verb> all{
        {QStringLiteral("set"),
         {option::name, option::team, option::ofClass, option::date, option::task, option::robot,
          option::variable, option::range, option::sync, option::note},
         &set},
        {QStringLiteral("remove"), {}, &removeTrial},
        {QStringLiteral("restore"), {}, &restoreTrial},
        {QStringLiteral("copy"), {option::name}, &copy},
        {QStringLiteral("accept"), {option::reason}, &accept},
        {QStringLiteral("withdraw"), {}, &withdraw}};
    return all;
}

CommandSyntax trialSyntax()
{
    return {
        QStringLiteral("trial"),
        QStringLiteral("set P.odo TRIAL [--name N] [--team T] [--class C] [--date ISO] [--task TASK] "
                       "[--robot R]... [--var KEY=VALUE]... [--range FROM,TO|motion|none] [--sync "
                       "auto|motion|flash|audio|none|SECONDS[,...]] [--note TEXT] "
                       "| remove P.odo TRIAL | restore P.odo TRIAL_IN_BIN | copy P.odo TRIAL [--name N] "
                       "| accept P.odo TRIAL --reason TEXT | withdraw P.odo TRIAL [--json]"),
        3,
        3,
        {{option::name, QStringLiteral("Its new name; of a copy, the copy's name."), QStringLiteral("N")},
         {option::team, QStringLiteral("Its team, which is added if it is new; '' removes it."),
          QStringLiteral("T")},
         {option::ofClass, QStringLiteral("The class of its team."), QStringLiteral("C")},
         {option::date,
          QStringLiteral("When it was recorded, in local time unless a zone is given: 2026-11-29, "
                         "2026-11-29T10:30, 2026-11-29T09:30Z."),
          QStringLiteral("ISO")},
         {option::task, QStringLiteral("Its task; '' removes it."), QStringLiteral("TASK")},
         {option::robot, QStringLiteral("A robot that is in it; replaces those it had."),
          QStringLiteral("R")},
         {option::variable,
          QStringLiteral("A variable of your own, text or a number: surface=carpet; KEY= removes it."),
          QStringLiteral("KEY=VALUE")},
         {option::sync,
          QStringLiteral(
              "How much later each other view's first frame was taken than the first view's; auto: "
              "found by the motion, a flash of light or a clap. What was tracked is reanalysed."),
          QStringLiteral("auto|motion|flash|audio|none|SECONDS[,...]")},
         {option::range,
          QStringLiteral(
              "The part of its time that its results are of, in seconds: FROM,TO; motion: from the "
              "first motion of its robots to the last; none: all of it."),
          QStringLiteral("FROM,TO|motion|none")},
         {option::note, QStringLiteral("Its notes; replaces those it had."), QStringLiteral("TEXT")},
         {option::reason, QStringLiteral("Why its doubtful results can be used."), QStringLiteral("TEXT")}}};
}

/// Each option of one verb is a wrong call with another.
Result<void> checkOptions(const CommandCall &call, const Verb &verb)
{
    bool isAnySet = false;
    for (const Verb &other : verbs())
        for (const QString &name : other.options) {
            if (call.isSet(name) && !verb.options.contains(name))
                return call.wrongCall(ODO_TEXT("app.option_of_verb", "--%1 goes with %2, not with %3")(
                    name.toStdString(), other.word.toStdString(), verb.word.toStdString()));
            isAnySet = isAnySet || call.isSet(name);
        }
    if (verb.run == &accept && !isAnySet)
        return call.missing(option::reason);
    if (verb.run == &set && !isAnySet)
        return call.wrongCall(ODO_TEXT("app.nothing_to_set", "nothing to change was given"));
    return {};
}

} // namespace

Result<void> runTrial(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(trialSyntax(), cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto verb = std::ranges::find(verbs(), call.positional(0), &Verb::word);
    if (verb == verbs().end())
        return call.wrongCall(ODO_TEXT("app.trial_verbs",
                                       "give set, remove, restore, copy, accept or withdraw, "
                                       "then P.odo TRIAL"));
    ODO_TRY(checkOptions(call, *verb));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto trial = ODO_TRY(project->trials().find(call.text(2)));
    return verb->run(call, *project, trial);
}

} // namespace odo
