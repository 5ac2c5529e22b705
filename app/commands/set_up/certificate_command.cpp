// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "core/base/platform/sleep_inhibitor.h"
#include "ui/report/certificate_report.h"
#include "ui/report/report_output.h"

#include <QJsonArray>

namespace odo {

namespace {

constexpr double perMetre = 1000;

/// Where no file is asked for.
class NoPages : public PageOutput
{
public:
    Result<void> add(const ReportPage &) override { return {}; }
    Result<void> finish() override { return {}; }
};

QJsonObject errorsJson(const CertificateErrors &figure)
{
    return {{QStringLiteral("rms"), perMetre * figure.rms},
            {QStringLiteral("p95"), perMetre * figure.p95},
            {QStringLiteral("sigma"), figure.sigma ? QJsonValue(perMetre * *figure.sigma) : QJsonValue()},
            {QStringLiteral("coverage"), optionalJson(figure.covered)}};
}

QJsonArray camerasJson(const std::vector<CertificateCamera> &cameras)
{
    QJsonArray all;
    for (const CertificateCamera &camera : cameras)
        all.append(
            QJsonObject{{QStringLiteral("camera"), QString::fromStdString(camera.name)},
                        {QStringLiteral("width"), camera.widthPx},
                        {QStringLiteral("height"), camera.heightPx},
                        {QStringLiteral("fps"), camera.framesPerSecond},
                        {QStringLiteral("calibrated"), camera.calibration.has_value()},
                        {QStringLiteral("registration_rms_px"), camera.registration.registration.rmsPx}});
    return all;
}

QJsonObject certificateJson(const CertificateContent &content)
{
    const CertificateOutcome &outcome = content.outcome;
    QJsonObject robot{{QStringLiteral("name"), QString::fromStdString(content.setUp.robot.name)},
                      {QStringLiteral("in_project"), content.setUp.isRobotInProject}};
    QJsonObject run{{QStringLiteral("duration_s"), outcome.durationS},
                    {QStringLiteral("path_length_m"), outcome.lengthM},
                    {QStringLiteral("max_speed_m_s"), outcome.topSpeedMps}};
    return {{QStringLiteral("mm"), perMetre * outcome.position.rms},
            {QStringLiteral("mm_s"), perMetre * outcome.velocity.rms},
            {QStringLiteral("mm_s2"), perMetre * outcome.acceleration.rms},
            {QStringLiteral("coverage"), outcome.position.covered.value_or(0)},
            {QStringLiteral("position_mm"), errorsJson(outcome.position)},
            {QStringLiteral("velocity_mm_s"), errorsJson(outcome.velocity)},
            {QStringLiteral("speed_mm_s"), errorsJson(outcome.speed)},
            {QStringLiteral("acceleration_mm_s2"), errorsJson(outcome.acceleration)},
            {QStringLiteral("acceleration_amount_mm_s2"), errorsJson(outcome.accelerationAmount)},
            {QStringLiteral("cameras"), camerasJson(content.setUp.cameras)},
            {QStringLiteral("robot"), robot},
            {QStringLiteral("task"), content.setUp.task
                                         ? QJsonValue(QString::fromStdString(content.setUp.task->name))
                                         : QJsonValue()},
            {QStringLiteral("runs"), qint64(outcome.runs.size())},
            {QStringLiteral("run"), run},
            {QStringLiteral("frames"), qint64(outcome.frames)},
            {QStringLiteral("compared"), qint64(outcome.compared)},
            {QStringLiteral("sync_error_ms"),
             content.setUp.cameras.size() > 1 ? QJsonValue(1000 * outcome.largestSyncErrorS) : QJsonValue()},
            {QStringLiteral("warnings"), sentencesJson(outcome.remarks)}};
}

QString errorsText(const QString &name, const CertificateErrors &figure, const QString &unit, int decimals)
{
    const auto number = [&](double value) { return QString::number(perMetre * value, 'f', decimals); };
    QString text = QStringLiteral("%1: rms %2 %4, 95 % below %3 %4")
                       .arg(name, number(figure.rms), number(figure.p95), unit);
    if (figure.sigma)
        text += QStringLiteral("; stated σ %1 %2").arg(number(*figure.sigma), unit);
    if (figure.covered)
        text += QStringLiteral(", truth inside the stated 95 %: %1 %").arg(100 * *figure.covered, 0, 'f', 0);
    return text;
}

QString certificateText(const CertificateContent &content)
{
    const CertificateOutcome &outcome = content.outcome;
    QStringList cameras;
    for (const CertificateCamera &camera : content.setUp.cameras)
        cameras << QStringLiteral("%1 (%2x%3, %4 frames/s)")
                       .arg(QString::fromStdString(camera.name))
                       .arg(camera.widthPx)
                       .arg(camera.heightPx)
                       .arg(camera.framesPerSecond, 0, 'f', 2);
    const QString unit = QStringLiteral("mm");
    QStringList lines{
        QStringLiteral("Simulated %1, robot %2: %3 of %4 s, %5 m each, at up to %6 m/s")
            .arg(cameras.join(QStringLiteral(", ")), QString::fromStdString(content.setUp.robot.name),
                 counted(outcome.runs.size(), QStringLiteral("run")))
            .arg(outcome.durationS, 0, 'f', 1)
            .arg(outcome.lengthM, 0, 'f', 2)
            .arg(outcome.topSpeedMps, 0, 'f', 2),
        errorsText(QStringLiteral("Position"), outcome.position, unit, 2),
        errorsText(QStringLiteral("Velocity"), outcome.velocity, unit + QStringLiteral("/s"), 1),
        errorsText(QStringLiteral("Speed"), outcome.speed, unit + QStringLiteral("/s"), 1),
        errorsText(QStringLiteral("Acceleration"), outcome.acceleration, unit + QStringLiteral("/s²"), 0),
        errorsText(QStringLiteral("Amount of acceleration"), outcome.accelerationAmount,
                   unit + QStringLiteral("/s²"), 0),
        QStringLiteral("%1 of %2 frames have a result").arg(outcome.compared).arg(outcome.frames)};
    if (content.setUp.cameras.size() > 1)
        lines << QStringLiteral("Views synchronised by the motion, to %1 ms at worst")
                     .arg(1000 * outcome.largestSyncErrorS, 0, 'f', 2);
    return lines.join(u'\n');
}

QList<QCommandLineOption> certificateOptions()
{
    QList<QCommandLineOption> options =
        outputOptions(QStringLiteral("The PDF file to write.")) +
        QList<QCommandLineOption>{{option::task,
                                   QStringLiteral("The known run follows the course of this task; "
                                                  "default: a run over the floor that the cameras "
                                                  "see."),
                                   QStringLiteral("TASK")},
                                  {option::robot,
                                   QStringLiteral("The robot to simulate; default: that of the "
                                                  "newest trial."),
                                   QStringLiteral("R")}};
    for (const QCommandLineOption &each : reportOptionSyntax())
        if (!each.names().contains(option::method))
            options << each;
    return options;
}

} // namespace

Result<void> runCertificate(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("certificate"),
                      QStringLiteral("P.odo [--task TASK] [--robot R] -o certificate.pdf [--force]"), 1, 1,
                      certificateOptions()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output) && !call.json())
        return call.missing(option::output);
    const auto options = ODO_TRY(readReportOptions(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const QString file = QString::fromStdString(call.value(option::output));
    std::optional<CommandOutput> output;
    if (call.isSet(option::output)) {
        output = ODO_TRY(CommandOutput::of(call, file, FileKind::Pdf, project.get()));
    }
    std::unique_ptr<PageOutput> pages = std::make_unique<NoPages>();
    if (output)
        pages = std::make_unique<PdfFile>(output->target(), QStringLiteral("Odograph certificate"));
    CertificateContentPtr content;
    ReportJob job(certificateReport({call.value(option::task), call.value(option::robot)}, options,
                                    [&](const CertificateContentPtr &made) { content = made; }),
                  std::move(pages));
    const auto awake = SleepInhibitor::take("simulating a set-up");
    ODO_TRY(runToEnd(job, *project, call.control()));
    QJsonObject json = certificateJson(*content);
    QString text = certificateText(*content);
    for (const Message &remark : content->outcome.remarks)
        CommandCall::warn(remark);
    if (!output) {
        call.answer(json, text);
        return {};
    }
    json.insert(QStringLiteral("file"), file);
    return output->finish(call, json, text + QStringLiteral("\nWrote %1.").arg(file));
}

} // namespace odo
