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
    void showPage(const QString &name);

Q_SIGNALS:
    void closed(); ///< by a person

private:
    QTextBrowser *m_text;
};

} // namespace odo
