// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/project/names.h"

namespace odo {

Result<void> runNew(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("new"), QStringLiteral("P.odo [--title TEXT]"), 1, 1,
                      {{QStringLiteral("title"), QStringLiteral("What the project is called."), QStringLiteral("TEXT")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const std::filesystem::path file = call.text(0);
    const std::string title = call.isSet(QStringLiteral("title")) ? call.value(QStringLiteral("title")) : titleFromName(file);
    const auto project = Project::create(file, title);
    if (!project)
        return tl::unexpected(project.error());
    const auto stored = (*project)->title();
    if (!stored)
        return tl::unexpected(stored.error());
    call.answer({{QStringLiteral("project"), call.positional(0)}, {QStringLiteral("title"), QString::fromStdString(*stored)}},
                QStringLiteral("Made %1.").arg(call.positional(0)));
    return {};
}

} // namespace odo
