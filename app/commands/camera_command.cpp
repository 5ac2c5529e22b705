// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/option_names.h"
#include "core/project/changing.h"
#include "core/project/repositories.h"

namespace odo {

Result<void> runCamera(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("camera"), QStringLiteral("add P.odo CAMERA [--device URI]"), 3, 3,
                      {{option::device, QStringLiteral("Where its pictures come from."), QStringLiteral("URI")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.positional(0) != QStringLiteral("add"))
        return call.wrongCall(QStringLiteral("'%1' is not known").arg(call.positional(0)));
    const auto project = call.openProject(1, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    const auto added = changing(**project, "add camera " + call.text(2),
                                [&] { return (*project)->cameras().add({0, call.text(2), call.value(option::device)}); });
    if (!added)
        return tl::unexpected(added.error());
    const QString name = QString::fromStdString(added->name);
    call.answer({{QStringLiteral("camera"), name}}, QStringLiteral("Camera %1 added.").arg(name));
    return {};
}

} // namespace odo
