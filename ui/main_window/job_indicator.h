// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QProgressBar;
class QPushButton;

namespace odo {

class ElidedLabel;

/// The job that runs, in the status bar: what it does, how far it is, and a button that stops it. Hidden when
/// none runs.
class JobIndicator : public QWidget
{
    Q_OBJECT
public:
    explicit JobIndicator(QWidget *parent = nullptr);
    void begin(const QString &text);
    void setProgress(double fraction, const QString &text);
    void end();
    QString text() const;

Q_SIGNALS:
    void cancelRequested();

private:
    ElidedLabel *m_text;
    QProgressBar *m_bar;
    QPushButton *m_cancel;
};

} // namespace odo
