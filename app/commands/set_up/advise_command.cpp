// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/base/units.h"
#include "core/workflow/certificate/set_up_advice.h"

#include <QJsonArray>

namespace odo {

namespace {

QJsonObject sigmaJson(double middleM, double worstM)
{
    return {{QStringLiteral("middle"), QJsonValue(toMillimetres(middleM))},
            {QStringLiteral("worst"), QJsonValue(toMillimetres(worstM))}};
}

QJsonObject adviceJson(const SetUpQuestion &asked, const PlacementAdvice &advice)
{
    QJsonArray moves;
    for (const PlacementMove &move : advice.moves)
        moves.append(
            QJsonObject{{QStringLiteral("camera"), QString::fromStdString(asked.cameras[move.camera].name)},
                        {QStringLiteral("left_mm"), std::round(toMillimetres(move.leftM))},
                        {QStringLiteral("back_mm"), std::round(toMillimetres(move.backM))},
                        {QStringLiteral("up_mm"), std::round(toMillimetres(move.upM))},
                        {QStringLiteral("sigma_mm"), sigmaJson(move.middleM, move.worstM)},
                        {QStringLiteral("text"), QString::fromStdString(move.words.english())}});
    return {{QStringLiteral("sigma_mm"), sigmaJson(advice.now.middleM, advice.now.worstM)},
            {QStringLiteral("speed_m_s"), asked.question.speedMps},
            {QStringLiteral("time_sigma_ms"), 1000 * asked.question.timeSigmaS},
            {QStringLiteral("height_mm"), toMillimetres(asked.question.robotHeightM)},
            {QStringLiteral("moves"), moves},
            {QStringLiteral("warnings"), sentencesJson(advice.remarks)}};
}

QString adviceText(const PlacementAdvice &advice)
{
    QStringList lines{QStringLiteral("Now: ") + QString::fromStdString(advice.now.words.english())};
    for (const PlacementMove &move : advice.moves)
        lines << QString::fromStdString(move.words.english());
    if (advice.moves.empty())
        lines << QStringLiteral("Moving one camera lowers the largest error by less than a tenth.");
    return lines.join(u'\n');
}

} // namespace

Result<void> runAdvise(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("advise"),
         QStringLiteral("P.odo [--robot R] [--speed M/S] [--reach 1m] [--json]"),
         1,
         1,
         {{option::robot, QStringLiteral("The robot whose height counts; default: that of the newest trial."),
           QStringLiteral("R")},
          {option::speed,
           QStringLiteral("How fast it drives, in m/s; default: the top speed of the newest trial."),
           QStringLiteral("M/S")},
          {option::reach, QStringLiteral("How far a camera may be moved."), QStringLiteral("LENGTH"),
           QStringLiteral("1m")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    SetUpQuestionSettings settings{call.value(option::robot), std::nullopt,
                                   ODO_TRY(call.lengthM(option::reach))};
    if (call.isSet(option::speed)) {
        settings.speedMps = ODO_TRY(call.number(option::speed));
        if (!(*settings.speedMps >= 0 && *settings.speedMps <= 100))
            return call.wrongCall(ODO_TEXT("app.not_a_speed", "--%1 '%2' is not a speed from 0 to 100 m/s")(
                option::speed.toStdString(), call.value(option::speed)));
    }
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto asked = ODO_TRY(readSetUpQuestion(*project, settings));
    const auto advice = ODO_TRY(placementAdvice(asked.cameras, asked.layout, asked.question, call.control()));
    for (const Message &remark : advice.remarks)
        CommandCall::warn(remark);
    call.answer(adviceJson(asked, advice), adviceText(advice));
    return {};
}

} // namespace odo
