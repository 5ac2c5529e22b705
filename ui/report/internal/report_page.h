// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <functional>
#include <vector>

class QPainter;

namespace odo {

enum class Paper { A4, Letter };
/// "a4", "letter": the word kept in the settings and given on the command line; another one is A4.
Paper paperFromWord(const QString &word);
QString paperWord(Paper paper);

/// The sheet of a page. Lengths of pages are logical pixels, 96 to the inch, as on the screen, so that the
/// same classes paint both.
struct PageFormat
{
    static constexpr double unitsPerInch = 96;
    static constexpr double margin = 45; ///< 12 mm, which every printer can print

    Paper paper = Paper::A4;
    bool isLandscape = false;

    QSizeF size() const;
    QRectF content() const; ///< within the margins
};

/// What a school has on all of its reports.
struct Letterhead
{
    QString school; ///< may be empty
    QString remark; ///< a line at the foot; may be empty
    QImage logo;    ///< null: none
};

/// One page, ready to be painted any number of times, on any thread: onto paper, or onto the screen for a
/// preview. Paints in light colours, whatever the theme.
struct ReportPage
{
    PageFormat format;
    std::function<void(QPainter &)> paint; ///< in the lengths of format, from the sheet's upper left corner
};
using ReportPages = std::vector<ReportPage>;

/// A page as a picture, so many pixels wide.
QImage pagePicture(const ReportPage &page, int widthPx);

} // namespace odo
