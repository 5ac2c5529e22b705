// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/number_text.h"

#include <QFrame>

class QHBoxLayout;
class QVBoxLayout;

namespace odo {

class BadgeLabel;
class ElidedLabel;

/// A panel as all of Odograph uses it: rounded frame, bold title at the left with an optional badge, a remark
/// at the right, the content below a thin line. Follows the palette.
class Card : public QFrame
{
    Q_OBJECT
public:
    explicit Card(const QString &title, QWidget *parent = nullptr);

    QString title() const;
    void setTitle(const QString &title);
    void setRemark(const QString &remark);
    QString remark() const;
    /// An empty text hides the badge.
    void setBadge(const Badge &badge);
    /// The one widget below the title; replaces (and deletes) an earlier one.
    void setContent(QWidget *content);
    QWidget *content() const { return m_content; }
    /// Puts a small widget (a button, a choice) at the right end of the title row.
    void addToHeader(QWidget *widget);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QWidget *m_header;
    ElidedLabel *m_title;
    BadgeLabel *m_badge;
    ElidedLabel *m_remark;
    QHBoxLayout *m_headerLayout;
    QVBoxLayout *m_layout;
    QWidget *m_content = nullptr;
};

} // namespace odo
