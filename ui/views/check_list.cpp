// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/check_list.h"

#include <QEvent>

namespace odo {
namespace {
constexpr int fewestRows = 2, mostRows = 6;
}

CheckList::CheckList(const QString &accessibleName, QWidget *parent) : QListWidget(parent)
{
    setAccessibleName(accessibleName);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFrameShape(QFrame::StyledPanel);
}

void CheckList::setNames(const QStringList &names, bool checked)
{
    clear();
    for (const QString &name : names) {
        auto *item = new QListWidgetItem(name, this);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(checked ? Qt::Checked : Qt::Unchecked);
    }
    if (count() > 0)
        setCurrentRow(0);
    updateGeometry();
}

std::vector<std::string> CheckList::checkedNames() const
{
    std::vector<std::string> names;
    for (int i = 0; i < count(); ++i)
        if (item(i)->checkState() == Qt::Checked)
            names.push_back(item(i)->text().toStdString());
    return names;
}

void CheckList::setChecked(const QStringList &names)
{
    for (int i = 0; i < count(); ++i)
        item(i)->setCheckState(names.contains(item(i)->text()) ? Qt::Checked : Qt::Unchecked);
}

bool CheckList::event(QEvent *event)
{
    const bool isHandled = QListWidget::event(event);
    if (event->type() == QEvent::Polish)
        doItemsLayout(); // rows that were laid out before the style sheet was known are too low
    return isHandled;
}

QSize CheckList::sizeHint() const
{
    ensurePolished();
    const int row = std::max(sizeHintForRow(0), fontMetrics().height() + 6);
    return {QListWidget::sizeHint().width(),
            std::clamp(count(), fewestRows, mostRows) * row + 2 * frameWidth()};
}

} // namespace odo
