// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/badge.h"

#include <QLabel>

namespace odo {

/// A badge by itself: a short word on a coloured ground. Hidden while it has no text. Follows the palette.
class BadgeLabel : public QLabel
{
    Q_OBJECT
public:
    explicit BadgeLabel(const Badge &badge, QWidget *parent = nullptr);
    void setBadge(const Badge &badge);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    BadgeState m_state = BadgeState::Neutral;
};

} // namespace odo
