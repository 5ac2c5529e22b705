// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/option_names.h"
#include "app/workbench.h"
#include "core/workflow/demo.h"

namespace odo {

Result<void> runDemo(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("demo"), QStringLiteral("DIR [--open]"), 1, 1,
                      {{option::open, QStringLiteral("Open the workbench with it.")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto file = makeDemo(call.text(0), call.control());
    if (!file)
        return tl::unexpected(file.error());
    const QString path = QString::fromStdString(file->string());
    call.answer({{QStringLiteral("project"), path}}, QStringLiteral("The demo lesson is in %1.").arg(path));
    if (call.isSet(option::open))
        runWorkbench(*file);
    return {};
}

} // namespace odo
