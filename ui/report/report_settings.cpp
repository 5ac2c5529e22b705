// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_settings.h"

#include "core/files/protected_files.h"

#include <QImageReader>
#include <QLocale>
#include <QSettings>
#include <QString>

namespace odo {

Result<QImage> readLogo(const std::filesystem::path &file)
{
    constexpr qint64 mostPixels = 100'000'000;
    constexpr QSize shown(1400, 400); // ten times what a page shows: sharp in print
    const Message what = ODO_TEXT("ui.logo", "logo '%1'")(Named::file(file));
    ODO_TRY(checkMayBeRead(file, what));
    QImageReader reader(QString::fromStdString(file.string()));
    reader.setAutoTransform(true);
    const QSize size = reader.size();
    if (size.isValid() && qint64(size.width()) * size.height() > mostPixels)
        return fail(ErrorCode::Io, what,
                    ODO_TEXT("ui.logo_too_large", "it is larger than a hundred megapixels"),
                    ODO_TEXT("ui.make_smaller", "make it smaller"));
    if (size.isValid() && (size.width() > shown.width() || size.height() > shown.height()))
        reader.setScaledSize(size.scaled(shown, Qt::KeepAspectRatio));
    QImage picture = reader.read();
    if (picture.isNull())
        return fail(ErrorCode::Io, what, foreignWords(reader.errorString().toStdString()),
                    ODO_TEXT("ui.choose_logo", "choose a PNG, JPEG or SVG picture"));
    return picture;
}

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
