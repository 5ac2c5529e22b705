// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/exchange/layout_csv.h"
#include "core/project/repositories.h"

namespace odo {

Result<void> runLayout(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("layout"), QStringLiteral("add P.odo NAME layout.csv"), 4, 4, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.positional(0) != QStringLiteral("add"))
        return call.wrongCall(QStringLiteral("'%1' is not known").arg(call.positional(0)));
    auto layout = readLayoutCsv(call.text(3));
    if (!layout)
        return tl::unexpected(layout.error());
    layout->name = call.text(2);
    const auto project = call.openProject(1, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    const auto added = (*project)->layouts().add(*layout);
    if (!added)
        return tl::unexpected(added.error());
    const int markers = int(layout->markers.size());
    call.answer({{QStringLiteral("layout"), call.positional(2)}, {QStringLiteral("markers"), markers}},
                QStringLiteral("Layout %1 has %2 markers.").arg(call.positional(2)).arg(markers));
    return {};
}

} // namespace odo
