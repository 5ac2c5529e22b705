// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/capture/camera_source.h"

#include <QJsonArray>

namespace odo {

namespace {

constexpr qsizetype mostFormatsNamed = 3;

/// The first formats, and how many more there are.
QString formatWords(const QStringList &formats)
{
    const QString words = formats.mid(0, mostFormatsNamed).join(QStringLiteral("; "));
    const qsizetype more = formats.size() - mostFormatsNamed;
    return more > 0 ? words + QStringLiteral("; and %1 more (see --json)").arg(more) : words;
}

} // namespace

Result<void> runCameras(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("cameras"), QStringLiteral("[--json]"), 0, 0, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    QJsonArray cameras;
    QStringList lines;
    for (const CameraDescription &camera : listCameras()) {
        const QString uri = QString::fromStdString(camera.uri), name = QString::fromStdString(camera.name);
        QStringList formats;
        for (const std::string &format : camera.formats)
            formats << QString::fromStdString(format);
        cameras.append(QJsonObject{{QStringLiteral("uri"), uri},
                                   {QStringLiteral("kind"), QString::fromStdString(camera.kind)},
                                   {QStringLiteral("name"), name},
                                   {QStringLiteral("serial"), QString::fromStdString(camera.serial)},
                                   {QStringLiteral("formats"), QJsonArray::fromStringList(formats)},
                                   {QStringLiteral("busy"), camera.busy}});
        QStringList about{name};
        if (camera.busy)
            about << QStringLiteral("used by another program");
        else if (!formats.isEmpty())
            about << formatWords(formats);
        lines << QStringLiteral("%1  %2").arg(uri, -20).arg(about.join(QStringLiteral(", ")));
    }
    call.answer({{QStringLiteral("cameras"), cameras}}, lines.join(u'\n'));
    return {};
}

} // namespace odo
