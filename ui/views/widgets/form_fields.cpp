// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/form_fields.h"

#include "ui/models/camera_lists.h"
#include "ui/models/figure_text.h"
#include "ui/models/shown_message.h"

#include <QEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <algorithm>

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

LiveCameraBox::LiveCameraBox(const LiveCameras &cameras, QWidget *parent)
    : QComboBox(parent), m_cameras(cameras)
{
    setAccessibleName(tr("Camera that is connected"));
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(&cameras, &LiveCameras::changed, this, &LiveCameraBox::fill);
    fill();
}

void LiveCameraBox::fill()
{
    const QString chosen = uri();
    {
        const QSignalBlocker blocked(this);
        clear();
        for (const CameraDescription &camera : m_cameras.cameras()) {
            const QString name = shownWords(camera.name);
            addItem(camera.widthPx > 0 ? tr("%1, %2×%3").arg(name).arg(camera.widthPx).arg(camera.heightPx)
                                       : name,
                    QString::fromStdString(camera.uri));
        }
        if (count() == 0)
            addItem(m_cameras.isLooking() ? tr("Looking for cameras…") : tr("No camera is connected"),
                    QString());
        setCurrentIndex(std::max(0, findData(chosen)));
    }
    Q_EMIT currentIndexChanged(currentIndex());
}

/// While it is typed, a sign that parts thousands may still become anything.
QValidator::State NumberBox::validate(QString &text, int &position) const
{
    const bool isOpen = isReadTwoWays(text, locale()) || withDecimalSign(text, locale()) != text;
    return isOpen ? QValidator::Intermediate : QDoubleSpinBox::validate(text, position);
}

/// Qt's would take the signs away that part thousands.
void NumberBox::fixup(QString &text) const
{
    text = isReadTwoWays(text, locale()) ? prefix() + textFromValue(m_before) + suffix()
                                         : withDecimalSign(text, locale());
}

/// The number counts while it is typed: of "1.234" a one is taken first.
void NumberBox::rememberBefore()
{
    if (!lineEdit()->isModified())
        m_before = value();
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    rememberBefore();
    QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    rememberBefore();
    QDoubleSpinBox::focusInEvent(event);
}

} // namespace odo
