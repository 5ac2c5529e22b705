// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_settings.h"

#include "ui/report/logo.h"

#include <QLocale>
#include <QSettings>

namespace odo {

namespace {

const QString schoolKey = QStringLiteral("report/school"), remarkKey = QStringLiteral("report/remark"),
              logoKey = QStringLiteral("report/logo"), paperKey = QStringLiteral("report/paper"),
              methodKey = QStringLiteral("report/method");

} // namespace

ReportSettings storedReportSettings()
{
    const QSettings stored;
    const bool isImperial = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
    const QString usual = paperWord(isImperial ? Paper::Letter : Paper::A4);
    return {stored.value(schoolKey).toString(), stored.value(remarkKey).toString(),
            stored.value(logoKey).toString(), paperFromWord(stored.value(paperKey, usual).toString()),
            stored.value(methodKey).toBool()};
}

void storeReportSettings(const ReportSettings &settings)
{
    QSettings stored;
    stored.setValue(schoolKey, settings.school);
    stored.setValue(remarkKey, settings.remark);
    stored.setValue(logoKey, settings.logoFile);
    stored.setValue(paperKey, paperWord(settings.paper));
    stored.setValue(methodKey, settings.withMethod);
}

ReportMaker reportBy(const ReportSettings &settings, std::function<ReportMaker(const ReportOptions &)> of)
{
    return [settings, of = std::move(of)](Project &project, const JobControl &control, const PageSink &sink) {
        ReportOptions options{settings.paper, {settings.school, settings.remark, {}}, settings.withMethod};
        if (!settings.logoFile.isEmpty())
            options.letterhead.logo = readLogo(settings.logoFile.toStdString()).value_or(QImage());
        return of(options)(project, control, sink);
    };
}

} // namespace odo
