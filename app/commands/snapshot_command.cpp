// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/language_option.h"
#include "app/option_names.h"
#include "app/output_option.h"
#include "app/workbench.h"

namespace odo {

namespace {

constexpr double smallestPx = 200, largestPx = 4000;

Result<OutputTarget> targetOf(const CommandCall &call)
{
    const auto project = call.openProject(0, Project::Access::ReadOnly); // closed again: the window opens it
    if (!project)
        return tl::unexpected(project.error());
    return outputOf(call, call.value(option::output), std::nullopt, project->get());
}

} // namespace

Result<void> runSnapshot(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("snapshot"),
                      QStringLiteral("P.odo TRIAL -o picture.png [--force] [--mode review|compare|history|testbed] [--size 1600x1000] [--language en]"), 2, 2,
                      outputOptions(QStringLiteral("The picture to write.")) + QList<QCommandLineOption>{
                       {option::mode, QStringLiteral("What the window shows."), QStringLiteral("MODE"), QStringLiteral("review")},
                       {option::size, QStringLiteral("Of the window, in pixels."), QStringLiteral("WxH"), QStringLiteral("1600x1000")},
                       languageOption()}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.wrongCall(QStringLiteral("-o is missing"));
    const auto wanted = call.sizePair(option::size);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto inRange = [](double px) { return px >= smallestPx && px <= largestPx; };
    if (!inRange(wanted->first) || !inRange(wanted->second))
        return call.wrongCall(QStringLiteral("--size is from 200x200 to 4000x4000"));
    const auto shown = modeFromWord(QString::fromStdString(call.value(option::mode)));
    if (!shown || *shown == WindowMode::Record) // which shows no trial
        return call.wrongCall(QStringLiteral("--mode is review, compare, history or testbed"));
    if (auto applied = applyLanguage(call); !applied)
        return applied;
    const auto target = targetOf(call);
    if (!target)
        return tl::unexpected(target.error());
    auto painted = paintWorkbench(call.text(0), call.text(1), *shown, QSize(int(wanted->first), int(wanted->second)), *target, cancel);
    if (!painted)
        return painted;
    const QString file = QString::fromStdString(call.value(option::output));
    call.answer({{QStringLiteral("picture"), file}}, QStringLiteral("Wrote %1.").arg(file));
    return {};
}

} // namespace odo
