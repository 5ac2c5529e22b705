// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/figure_text.h"

#include <QWidget>
#include <vector>

namespace odo {

struct NamedFigure
{
    QString name;
    FigureText figure;
};

/// Large figures in two columns, divided by thin lines: name above, value large, unit and ± small beside it.
class FigureGrid : public QWidget
{
    Q_OBJECT
public:
    explicit FigureGrid(QWidget *parent = nullptr);
    void setFigures(std::vector<NamedFigure> figures);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    int rowCount() const;
    int rowHeight() const;
    QFont valueFont() const;
    QFont fittingFont(const QString &text, int width) const;
    void paintFigure(QPainter &painter, const NamedFigure &figure, const QRect &cell) const;

    std::vector<NamedFigure> m_figures;
};

} // namespace odo
