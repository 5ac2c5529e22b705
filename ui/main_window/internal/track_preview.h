// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/track_file.h"

#include <QPolygonF>
#include <QWidget>
#include <filesystem>
#include <vector>

class QLabel;

namespace odo {

/// The paths of tracks seen from above, to scale, without a place to measure in.
class PathSketch : public QWidget
{
    Q_OBJECT
public:
    explicit PathSketch(QWidget *parent = nullptr);
    /// In metres; each piece of a path without a gap.
    void setPieces(std::vector<QPolygonF> pieces);
    const std::vector<QPolygonF> &pieces() const { return m_pieces; }
    QSize sizeHint() const override { return {240, 180}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::vector<QPolygonF> m_pieces;
};

/// How files of finished tracks are read: format, units, axes, what is left out and why, and the path; or
/// what is still to be chosen.
class TrackPreview : public QWidget
{
    Q_OBJECT
public:
    explicit TrackPreview(QWidget *parent = nullptr);
    void show(const std::vector<std::filesystem::path> &files, const TrackReading &reading);
    QString words() const;

private:
    QLabel *m_words;
    PathSketch *m_sketch;
};

} // namespace odo
