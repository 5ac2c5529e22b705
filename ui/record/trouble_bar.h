// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace odo {

/// A sentence across the page as long as something is the matter, with a button that leads to its cure.
/// Hidden without words.
class TroubleBar : public QFrame
{
    Q_OBJECT
public:
    explicit TroubleBar(QWidget *parent = nullptr);
    /// button: its words; empty: none.
    void setWords(const QString &words, const QString &button = {});
    QString words() const;

Q_SIGNALS:
    void clicked();

private:
    QLabel *m_words;
    QPushButton *m_button;
};

} // namespace odo
