// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/view_steps.h"

#include "ui/views/elided_label.h"
#include "ui/views/number_box.h"

#include <QComboBox>
#include <QGridLayout>

namespace odo {
namespace {

constexpr double highestOffsetS = 600;
using Sync = ImportSettings::Sync;

} // namespace

ViewSteps::ViewSteps(QWidget *parent) : QWidget(parent), m_grid(new QGridLayout(this))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setColumnStretch(1, 1);
}

void ViewSteps::addView()
{
    if (++m_views == 1)
        return;
    const int number = static_cast<int>(m_views);
    Row row{new ElidedLabel, new QComboBox, new NumberBox};
    row.how->addItem(tr("From the motion or a flash"), static_cast<int>(Sync::Automatic));
    row.how->addItem(tr("Begun together"), static_cast<int>(Sync::None));
    row.how->addItem(tr("By hand: begun later by"), static_cast<int>(Sync::Told));
    row.how->setAccessibleName(tr("How view %1 gets in step with the first").arg(number));
    row.how->setToolTip(tr("A flash: switch the room lights on and off once while all cameras record"));
    row.later->setRange(-highestOffsetS, highestOffsetS);
    row.later->setDecimals(4);
    row.later->setSingleStep(0.01);
    row.later->setSuffix(tr(" s"));
    row.later->setAccessibleName(tr("How much later view %1 began").arg(number));
    row.later->setToolTip(tr("Below zero: it began earlier than the first view"));
    row.later->setEnabled(false);
    connect(row.how, &QComboBox::currentIndexChanged, row.later,
            [row] { row.later->setEnabled(row.how->currentData().toInt() == static_cast<int>(Sync::Told)); });
    const int place = static_cast<int>(m_rows.size());
    m_grid->addWidget(row.camera, place, 0);
    m_grid->addWidget(row.how, place, 1);
    m_grid->addWidget(row.later, place, 2);
    m_rows.push_back(row);
}

void ViewSteps::setCameras(const QStringList &cameras)
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const int view = static_cast<int>(i) + 1;
        const QString name = cameras.value(view).trimmed();
        m_rows[i].camera->setFullText(name.isEmpty() ? tr("View %1").arg(view + 1) : name);
    }
}

ImportSettings::ViewStep ViewSteps::step(std::size_t view) const
{
    if (view == 0 || view > m_rows.size())
        return {};
    const Row &row = m_rows[view - 1];
    return {static_cast<Sync>(row.how->currentData().toInt()), row.later->value()};
}

QList<QWidget *> ViewSteps::fields() const
{
    QList<QWidget *> all;
    for (const Row &row : m_rows)
        all << row.how << row.later;
    return all;
}

} // namespace odo
