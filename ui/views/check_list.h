// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>
#include <string>
#include <vector>

namespace odo {

/// A short list of names, each with a box to tick.
class CheckList : public QListWidget
{
    Q_OBJECT
public:
    explicit CheckList(const QString &accessibleName, QWidget *parent = nullptr);
    void setNames(const QStringList &names, bool checked);
    std::vector<std::string> checkedNames() const;
    /// Ticks these and no others.
    void setChecked(const QStringList &names);
    QSize sizeHint() const override;

protected:
    bool event(QEvent *event) override;
};

} // namespace odo
