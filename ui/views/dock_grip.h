// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace odo {

/// A thin strip in place of a dock's title bar, which its card has already: it is dragged to move the dock,
/// double clicked to let it float.
class DockGrip : public QWidget
{
    Q_OBJECT
public:
    explicit DockGrip(QWidget *parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace odo
