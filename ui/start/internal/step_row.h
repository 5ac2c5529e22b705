// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QIcon>
#include <QList>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace odo {

/// One step of a list: its icon with a tick once it is done, title, how far it is, and the buttons that do
/// it. Follows the palette.
class StepRow : public QFrame
{
    Q_OBJECT
public:
    StepRow(const QString &icon, const QString &title, QWidget *parent = nullptr);

    QPushButton *addButton(const QString &text);
    void setState(bool isDone, const QString &words);
    bool isDone() const { return m_isDone; }
    QString words() const;
    /// The step to take now: its first enabled button is the one that a person most likely wants.
    void setNext(bool isNext);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QIcon m_icon;
    QString m_name;
    QLabel *m_title, *m_words;
    QHBoxLayout *m_buttonRow;
    QList<QPushButton *> m_buttons;
    bool m_isDone = false, m_isNext = false;
};

} // namespace odo
