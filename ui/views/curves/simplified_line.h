// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <functional>
#include <optional>

namespace odo {

/// Makes a line through fewer of its points, from its first to its last: none of those left out is farther
/// from it than the tolerance across, and as much along it. For painting: strokes cost by the point, and
/// thousands of them lie within a fraction of a pixel of one another. In one pass, by a cone that every point
/// narrows (K. Reumann, A. Witkam 1974, with the tolerance kept as a bound).
class LineSimplifier
{
public:
    explicit LineSimplifier(double tolerance) : m_tolerance(tolerance) {}
    void add(const QPointF &point);
    bool isEmpty() const { return m_kept.isEmpty(); }
    QPointF last() const { return m_last; }
    /// The line through what was added since the last call.
    QPolygonF take();

private:
    /// The directions in which a straight line may go from an anchor so that it passes all points seen since.
    class Cone
    {
    public:
        explicit Cone(const QPointF &anchor = {}) : m_anchor(anchor) {}
        /// False, and unchanged, where no line to this point keeps all points before it.
        bool takes(const QPointF &point, double tolerance);

    private:
        QPointF m_anchor;
        double m_farthest = 0;
        bool m_isOpen = false;                      ///< a first direction is known
        double m_middle = 0, m_low = 0, m_high = 0; ///< radians; the bounds from the middle
    };
    double m_tolerance;
    Cone m_cone;
    QPolygonF m_kept; ///< without the last point, unless it is the only one
    QPointF m_last;
    bool m_isLine = false; ///< more than one point was added
};

/// As LineSimplifier, in pieces: what is beyond the edges of what is seen is left out, so that a close look
/// at a long line costs no more than all of it.
class SeenLine
{
public:
    using Take = std::function<void(const QPolygonF &piece)>;
    /// seen: with room for the line's width; an empty one is all. take: gets each piece of two points or
    /// more.
    SeenLine(double tolerance, const QRectF &seen, Take take);
    void add(const QPointF &point);
    /// Ends a piece; the next one goes on from its last point.
    void cut();
    /// Ends the line; the next point begins another one.
    void end();

private:
    bool isSeen(const QPointF &from, const QPointF &to) const;

    LineSimplifier m_piece;
    const QRectF m_seen;
    const Take m_take;
    std::optional<QPointF> m_last;
};

/// A whole line through fewer of its points.
QPolygonF simplified(const QPolygonF &line, double tolerance);

} // namespace odo
