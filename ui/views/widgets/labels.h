// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/number_text.h"

#include <QLabel>
#include <QString>

class QHelpEvent;
class QLabel;
class QWidget;

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

/// One line of plain text, elided when space is short; the tool tip has all of it.
class ElidedLabel : public QLabel
{
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget *parent = nullptr);
    void setFullText(const QString &text);
    QString fullText() const { return m_fullText; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void elide();
    QString m_fullText;
};

/// Shows words where the mouse rests on a widget, or removes those of another position if there are none.
void showToolTip(const QHelpEvent &help, const QString &words, QWidget *widget);

/// Lets a label show sentences that may hold names of people's choosing: plain text, wrapped, and to be
/// copied.
void showAsWords(QLabel &label);

/// Two such labels, of a judgement, bold, and of what to do about it, quiet.
void showAsVerdict(QLabel &verdict, QLabel &advice);

} // namespace odo
