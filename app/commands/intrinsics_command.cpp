// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/json_answers.h"
#include "app/output_option.h"
#include "core/workflow/cameras.h"

namespace odo {

Result<void> runIntrinsics(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("intrinsics"), QStringLiteral("import P.odo CAMERA FILE | export P.odo CAMERA FILE [--force]"), 4, 4, {forceOption()}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const bool importing = call.positional(0) == QStringLiteral("import");
    if (!importing && call.positional(0) != QStringLiteral("export"))
        return call.wrongCall(QStringLiteral("'%1' is neither import nor export").arg(call.positional(0)));
    const auto project = call.openProject(1, importing ? Project::Access::ReadWrite : Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    QJsonObject json{{QStringLiteral("camera"), call.positional(2)}, {QStringLiteral("file"), call.positional(3)}};
    if (importing) {
        const auto record = importIntrinsics(**project, call.text(2), call.text(3));
        if (!record)
            return tl::unexpected(record.error());
        json.insert(QStringLiteral("intrinsics"), intrinsicsJson(record->calibration.intrinsics));
    } else {
        const auto target = outputOf(call, call.text(3), FileKind::Yaml, project->get());
        if (!target)
            return tl::unexpected(target.error());
        if (auto written = exportIntrinsics(**project, call.text(2), *target); !written)
            return written;
    }
    call.answer(json, importing ? QStringLiteral("Camera %1 has new intrinsics.").arg(call.positional(2))
                                : QStringLiteral("Wrote %1.").arg(call.positional(3)));
    return {};
}

} // namespace odo
