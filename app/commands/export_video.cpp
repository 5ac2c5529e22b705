// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/export_video.h"

#include "app/language_option.h"
#include "app/option_names.h"
#include "app/output_option.h"
#include "ui/report/annotated_video.h"

namespace odo {
namespace {

Result<AnnotatedVideoSettings> settingsOf(const CommandCall &call)
{
    AnnotatedVideoSettings settings;
    const auto wantedSize = call.sizePair(option::size);
    if (!wantedSize)
        return tl::unexpected(wantedSize.error());
    settings.sizePx = QSize(static_cast<int>(wantedSize->first), static_cast<int>(wantedSize->second));
    if (!AnnotatedVideoSettings::isSize(settings.sizePx))
        return call.wrongCall(QStringLiteral("--size has even numbers, from 320x180 to 3840x2160"));
    const auto wantedSpeed = call.number(option::speed);
    if (!wantedSpeed)
        return tl::unexpected(wantedSpeed.error());
    if (!AnnotatedVideoSettings::isSpeed(*wantedSpeed))
        return call.wrongCall(QStringLiteral("--speed is from 0.1 to 1"));
    settings.speed = *wantedSpeed;
    const std::string themeName = call.value(option::theme);
    if (themeName != "light" && themeName != "dark")
        return call.wrongCall(QStringLiteral("--theme is light or dark"));
    settings.isDark = themeName == "dark";
    return settings;
}

} // namespace

QList<QCommandLineOption> videoOptions()
{
    return {{option::speed, QStringLiteral("Of a video, times that of the run: 0.1 to 1."), QStringLiteral("S"), QStringLiteral("1")},
            {option::size, QStringLiteral("Of a video, in pixels."), QStringLiteral("WxH"), QStringLiteral("1920x1080")},
            {option::theme, QStringLiteral("Of a video: light or dark."), QStringLiteral("THEME"), QStringLiteral("light")},
            languageOption()};
}

Result<void> exportVideo(const CommandCall &call, const std::string &file)
{
    auto settings = settingsOf(call);
    if (!settings)
        return tl::unexpected(settings.error());
    if (auto applied = applyLanguage(call); !applied)
        return applied;
    const auto project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    auto target = outputOf(call, file, std::nullopt, project->get()); // the job knows its kind
    if (!target)
        return tl::unexpected(target.error());
    settings->target = std::move(*target);
    AnnotatedVideoJob job(call.text(1), *settings);
    if (auto made = runToEnd(job, **project, call.control()); !made)
        return made;
    const QString name = QString::fromStdString(file);
    call.answer({{QStringLiteral("file"), name},
                 {QStringLiteral("format"), QStringLiteral("video")},
                 {QStringLiteral("pictures"), job.pictureCount()},
                 {QStringLiteral("duration_s"), job.durationS()}},
                QStringLiteral("Wrote %1: %2 s.").arg(name, QString::number(job.durationS(), 'f', 1)));
    return {};
}

} // namespace odo
