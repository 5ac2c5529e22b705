// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/logo.h"

#include "core/files/protected_files.h"

#include <QImageReader>
#include <QString>

namespace odo {

Result<QImage> readLogo(const std::filesystem::path &file)
{
    constexpr qint64 mostPixels = 100'000'000;
    constexpr QSize shown(1400, 400); // ten times what a page shows: sharp in print
    const std::string what = "logo '" + file.string() + "'";
    const char *advice = "choose a PNG, JPEG or SVG picture";
    if (auto may = checkMayBeRead(file, what); !may)
        return tl::unexpected(may.error());
    QImageReader reader(QString::fromStdString(file.string()));
    reader.setAutoTransform(true);
    const QSize size = reader.size();
    if (size.isValid() && qint64(size.width()) * size.height() > mostPixels)
        return fail(ErrorCode::Io, what, "it is larger than a hundred megapixels", "make it smaller");
    if (size.isValid() && (size.width() > shown.width() || size.height() > shown.height()))
        reader.setScaledSize(size.scaled(shown, Qt::KeepAspectRatio));
    QImage picture = reader.read();
    if (picture.isNull())
        return fail(ErrorCode::Io, what, reader.errorString().toStdString(), advice);
    return picture;
}

} // namespace odo
