// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/internal/report_painting.h"

#include <QList>
#include <QRectF>
#include <QString>
#include <QStringList>

class QTemporaryDir;

namespace odo::test {

/// Writes pages to a new PDF file in a folder and gives its name; where that fails, so does the test.
QString printed(const ReportPages &pages, const QTemporaryDir &folder);

/// What poppler's programs read in a PDF file: its text in the order of the page, the names of fonts that are
/// not embedded, and each word with its box (points, from the upper left corner; page sizes in pageSizes).
QString printedText(const QString &file, int page = 0);
QStringList fontsNotEmbedded(const QString &file);
struct PrintedWord
{
    int page = 0; ///< from 1
    QRectF box;
    QString text;
};
struct PrintedWords
{
    QList<QSizeF> pageSizes;
    QList<PrintedWord> words;
};
PrintedWords printedWords(const QString &file);

} // namespace odo::test
