// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QTextBrowser;

namespace odo {

/// Stands beside a page and tells what is on it and what to do there.
class HelpPanel : public QFrame
{
    Q_OBJECT
public:
    explicit HelpPanel(QWidget *parent = nullptr);

    /// The name of a text in the resources: "welcome", or that of a mode.
    /// It is read and laid out once it is seen.
    void showPage(const QString &name);

Q_SIGNALS:
    void closed(); ///< by a person

protected:
    void showEvent(QShowEvent *event) override;

private:
    void layOut();

    QString m_wanted; ///< is not laid out yet; empty: nothing
    QTextBrowser *m_text;
};

} // namespace odo
