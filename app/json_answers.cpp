// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/json_answers.h"

#include <QDateTime>

namespace odo {

namespace {

QString lensModelName(LensModel model)
{
    switch (model) {
    case LensModel::Standard:
        return QStringLiteral("standard");
    case LensModel::Rational:
        return QStringLiteral("rational");
    case LensModel::Fisheye:
        return QStringLiteral("fisheye");
    }
    return {};
}

const char *codeWord(ErrorCode code)
{
    switch (code) {
    case ErrorCode::InvalidInput:
        return "invalid_input";
    case ErrorCode::NotFound:
        return "not_found";
    case ErrorCode::AlreadyExists:
        return "already_exists";
    case ErrorCode::Io:
        return "io";
    case ErrorCode::NewerFormat:
        return "newer_format";
    case ErrorCode::ReadOnly:
        return "read_only";
    case ErrorCode::Undetermined:
        return "undetermined";
    case ErrorCode::WrongCall:
        return "wrong_call";
    case ErrorCode::Unavailable:
        return "unavailable";
    case ErrorCode::Cancelled:
        return "cancelled";
    case ErrorCode::Internal:
        break;
    }
    return "internal";
}

} // namespace

QJsonObject errorJson(const Error &error)
{
    return {{QStringLiteral("error"), QJsonObject{{QStringLiteral("code"), QLatin1String(codeWord(error.code))},
                                                  {QStringLiteral("text"), QString::fromStdString(error.message())},
                                                  {QStringLiteral("arguments"), QJsonObject()}}}};
}

QJsonObject intrinsicsJson(const Intrinsics &intrinsics)
{
    QJsonArray distortion;
    for (const double coefficient : intrinsics.distortion)
        distortion.append(coefficient);
    return {{QStringLiteral("width"), intrinsics.widthPx},
            {QStringLiteral("height"), intrinsics.heightPx},
            {QStringLiteral("fx"), intrinsics.fxPx},
            {QStringLiteral("fy"), intrinsics.fyPx},
            {QStringLiteral("cx"), intrinsics.cxPx},
            {QStringLiteral("cy"), intrinsics.cyPx},
            {QStringLiteral("model"), lensModelName(intrinsics.model)},
            {QStringLiteral("distortion"), distortion}};
}

QJsonObject syncJson(const TrialRecord &trial)
{
    return {{QStringLiteral("method"), QString::fromStdString(trial.syncMethod)},
            {QStringLiteral("offset_s"), trial.syncOffsetS},
            {QStringLiteral("offset_sigma_s"), trial.syncOffsetSigmaS},
            {QStringLiteral("score"), trial.syncScore},
            {QStringLiteral("rate_ppm"), trial.syncRate * 1e6},
            {QStringLiteral("rate_sigma_ppm"), trial.syncRateSigma * 1e6}};
}

QJsonObject recordingJson(const RecordingRecord &recording)
{
    const double duration = recording.frameTimes.empty() ? 0 : toSeconds(recording.frameTimes.back());
    const double interval = recording.framesPerSecond > 0 ? 1 / recording.framesPerSecond : 0;
    return {{QStringLiteral("frames"), qint64(recording.frameTimes.size())},
            {QStringLiteral("fps"), recording.framesPerSecond},
            {QStringLiteral("duration_s"), duration + interval},
            {QStringLiteral("start_offset_s"), recording.startOffsetS},
            {QStringLiteral("start_offset_sigma_s"), recording.startOffsetSigmaS},
            {QStringLiteral("sync_method"), QString::fromStdString(recording.syncMethod)},
            {QStringLiteral("clock_rate_ppm"), recording.clockRate * 1e6}};
}

QJsonArray vectorJson(const Eigen::VectorXd &vector)
{
    QJsonArray array;
    for (const double value : vector)
        array.append(value);
    return array;
}

QJsonValue optionalJson(const std::optional<double> &value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonArray metricsJson(const std::vector<Metric> &metrics)
{
    QJsonArray array;
    for (const Metric &metric : metrics)
        array.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(metric.name)},
                                 {QStringLiteral("unit"), QString::fromStdString(metric.unit)},
                                 {QStringLiteral("value"), metric.value},
                                 {QStringLiteral("sigma"), optionalJson(metric.sigma)}});
    return array;
}

QJsonArray spikesJson(const std::vector<Spike> &spikes, const std::vector<Occlusion> &occlusions)
{
    QJsonArray array;
    for (const Spike &spike : spikes)
        array.append(QJsonObject{{QStringLiteral("t_s"), toSeconds(spike.time)},
                                 {QStringLiteral("sample"), qint64(spike.sampleIndex)},
                                 {QStringLiteral("flags"), QString::fromStdString(flagNames(spike.flags))},
                                 {QStringLiteral("reason"), QString::fromStdString(reasonAmong(occlusions, spike))}});
    return array;
}

QJsonArray doubtsJson(const std::vector<DoubtfulName> &doubts)
{
    QJsonArray array;
    for (const DoubtfulName &doubt : doubts) {
        QJsonArray others;
        for (const std::string &name : doubt.otherNames)
            others.append(QString::fromStdString(name));
        array.append(QJsonObject{{QStringLiteral("from_s"), toSeconds(doubt.from)}, {QStringLiteral("to_s"), toSeconds(doubt.to)}, {QStringLiteral("others"), others}});
    }
    return array;
}

QJsonArray occlusionsJson(const std::vector<Occlusion> &occlusions)
{
    QJsonArray array;
    for (const Occlusion &one : occlusions) {
        const std::string_view cause = occlusionCauseName(one.cause);
        array.append(QJsonObject{{QStringLiteral("from_s"), toSeconds(one.span.begin)},
                                 {QStringLiteral("to_s"), toSeconds(one.span.end)},
                                 {QStringLiteral("view"), QString::fromStdString(one.view)},
                                 {QStringLiteral("cause"), QString::fromUtf8(cause.data(), qsizetype(cause.size()))},
                                 {QStringLiteral("other"), one.other.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(one.other))},
                                 {QStringLiteral("reason"), QString::fromStdString(occlusionWords(one))}});
    }
    return array;
}

QJsonArray sentencesJson(const std::vector<std::string> &sentences)
{
    QJsonArray array;
    for (const std::string &sentence : sentences)
        array.append(QString::fromStdString(sentence));
    return array;
}

QString dateText(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()).toString(Qt::ISODate);
}

double metricValue(const Profile &profile, std::string_view name)
{
    for (const Metric &metric : profile.metrics) {
        if (metric.name == name)
            return metric.value;
    }
    return 0;
}

} // namespace odo
