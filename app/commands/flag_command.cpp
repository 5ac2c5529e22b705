// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "core/workflow/overrule_job.h"

namespace odo {

namespace {

Result<OverruleRequest> requestOf(const CommandCall &call)
{
    if (int(call.isSet(option::spike)) + int(call.isSet(option::valid)) + int(call.isSet(option::clear)) != 1)
        return call.wrongCall(QStringLiteral("one of --spike, --valid and --clear is needed"));
    if (call.isSet(option::time) == call.isSet(option::frame))
        return call.wrongCall(QStringLiteral("one of --time and --frame is needed"));
    OverruleRequest request;
    request.trial = call.text(1);
    request.robot = call.value(option::robot);
    request.word = call.isSet(option::spike)   ? OverruleRequest::Word::Spike
                   : call.isSet(option::valid) ? OverruleRequest::Word::Valid
                                               : OverruleRequest::Word::Clear;
    const auto number = call.number(call.isSet(option::time) ? option::time : option::frame);
    if (!number)
        return tl::unexpected(number.error());
    if (call.isSet(option::time) && std::abs(*number) > 1e9)
        return call.wrongCall(QStringLiteral("--time takes seconds from -1,000,000,000 to 1,000,000,000"));
    if (call.isSet(option::time))
        request.timeS = *number;
    else if (*number != std::floor(*number) || std::abs(*number) > 1e9)
        return call.wrongCall(QStringLiteral("--frame is a whole number"));
    else
        request.frame = static_cast<std::int64_t>(*number);
    return request;
}

QString wordsOf(OverruleRequest::Word word)
{
    switch (word) {
    case OverruleRequest::Word::Spike:
        return QStringLiteral("called a spike by hand");
    case OverruleRequest::Word::Valid:
        return QStringLiteral("called valid by hand");
    case OverruleRequest::Word::Clear:
        break;
    }
    return QStringLiteral("judged by the program again");
}

} // namespace

Result<void> runFlag(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("flag"),
                      QStringLiteral("P.odo TRIAL [--robot R] --time SECONDS|--frame N (--spike|--valid|--clear) [--json]"), 2, 2,
                      {{option::robot, QStringLiteral("The robot, where there are several."), QStringLiteral("R")},
                       {option::time, QStringLiteral("The sample nearest to this time."), QStringLiteral("SECONDS")},
                       {option::frame, QStringLiteral("The sample of this frame of the first view."), QStringLiteral("N")},
                       {option::spike, QStringLiteral("It is not to be used.")},
                       {option::valid, QStringLiteral("It is to be used.")},
                       {option::clear, QStringLiteral("Take back what was said by hand.")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto request = requestOf(call);
    if (!request)
        return tl::unexpected(request.error());
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    OverruleJob job(*request);
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    const OverruleOutcome &outcome = job.outcome();
    const Profile &profile = outcome.analysis.profile;
    call.answer({{QStringLiteral("trial"), call.positional(1)},
                 {QStringLiteral("robot"), QString::fromStdString(outcome.robot)},
                 {QStringLiteral("frame"), qint64(outcome.frame)},
                 {QStringLiteral("t_s"), toSeconds(outcome.time)},
                 {QStringLiteral("flags"), QString::fromStdString(flagNames(outcome.flags))},
                 {QStringLiteral("used"), !isRejected(outcome.flags)},
                 {QStringLiteral("spikes"), qint64(profile.spikes.size())},
                 {QStringLiteral("analysis"), qint64(outcome.analysis.id)},
                 {QStringLiteral("metrics"), metricsJson(profile.metrics)}},
                QStringLiteral("%1, frame %2 at %3 s: %4. A new analysis was made; it has %5.")
                    .arg(QString::fromStdString(outcome.robot))
                    .arg(outcome.frame)
                    .arg(toSeconds(outcome.time), 0, 'f', 3)
                    .arg(wordsOf(request->word))
                    .arg(counted(profile.spikes.size(), QStringLiteral("spike"))));
    return {};
}

} // namespace odo
