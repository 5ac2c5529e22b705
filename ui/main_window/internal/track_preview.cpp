// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/track_preview.h"

#include "core/base/file_system.h"
#include "core/base/job_control.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/form_fields.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace odo {

namespace {

/// Longer files are read when they are imported: no window waits for them.
constexpr std::uintmax_t mostBytes = 8 << 20;

void addPieces(const FileTrack &track, std::vector<QPolygonF> &pieces)
{
    bool isOpen = false;
    for (const ImportedPosition &one : track.positions) {
        if (!one.position) {
            isOpen = false;
            continue;
        }
        if (!isOpen)
            pieces.emplace_back();
        isOpen = true;
        pieces.back() << QPointF(one.position->x(), one.position->y());
    }
}

} // namespace

PathSketch::PathSketch(QWidget *parent) : QWidget(parent)
{
    setMinimumSize(160, 120);
    setAccessibleName(tr("The path from above"));
}

void PathSketch::setPieces(std::vector<QPolygonF> pieces)
{
    m_pieces = std::move(pieces);
    update();
}

void PathSketch::paintEvent(QPaintEvent *)
{
    QRectF all;
    for (const QPolygonF &piece : m_pieces) // united() would leave out what has no width
        for (const QPointF &point : piece) {
            if (all.isNull() && all.topLeft().isNull())
                all = QRectF(point, QSizeF(1e-6, 1e-6));
            all.setCoords(std::min(all.left(), point.x()), std::min(all.top(), point.y()),
                          std::max(all.right(), point.x()), std::max(all.bottom(), point.y()));
        }
    if (m_pieces.empty())
        return;
    constexpr double margin = 8;
    const double scale = std::min((width() - 2 * margin) / std::max(all.width(), 1e-6),
                                  (height() - 2 * margin) / std::max(all.height(), 1e-6));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(width() / 2.0, height() / 2.0);
    painter.scale(scale, -scale); // y counts upwards
    painter.translate(-all.center());
    QPen pen(palette().color(QPalette::Highlight), 1.5);
    pen.setCosmetic(true);
    painter.setPen(pen);
    for (const QPolygonF &piece : m_pieces)
        painter.drawPolyline(piece);
}

TrackPreview::TrackPreview(QWidget *parent) : QWidget(parent), m_words(new QLabel), m_sketch(new PathSketch)
{
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_words, 1);
    layout->addWidget(m_sketch, 1);
}

QString TrackPreview::words() const
{
    return m_words->text();
}

void TrackPreview::show(const std::vector<std::filesystem::path> &files, const TrackReading &reading)
{
    QStringList lines;
    std::vector<QPolygonF> pieces;
    for (const std::filesystem::path &file : files) {
        const QString name = breakable(QFileInfo(textOf(file)).fileName());
        std::error_code problem;
        if (files::sizeOf(file, problem) > mostBytes && !problem) {
            lines << tr("%1: too long to be shown before the import").arg(name);
            continue;
        }
        const auto read = readTrackFile(file, reading, JobControl());
        if (!read) {
            lines << breakable(errorInWords(read.error()));
            continue;
        }
        for (const FileTrack &track : read->tracks) {
            const double seconds = toSeconds(track.positions.back().time - track.positions.front().time);
            const QString format = QString::fromUtf8(trackFormatName(read->format).data(),
                                                     qsizetype(trackFormatName(read->format).size()));
            const QString what =
                track.name.empty() ? name : tr("%1, track %2").arg(name, QString::fromStdString(track.name));
            lines << tr("%1: %2, %n lines in %3 s", nullptr, int(track.positions.size()))
                         .arg(what, format, QLocale().toString(seconds, 'f', 2));
            for (const Message &fact : track.facts)
                lines << QStringLiteral("• ") + shownWords(fact);
            for (const Message &notice : track.notices)
                lines << QStringLiteral("⚠ ") + shownWords(notice);
            addPieces(track, pieces);
        }
    }
    m_words->setText(lines.join(u'\n'));
    m_sketch->setPieces(std::move(pieces));
}

} // namespace odo
