// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/track_dialog.h"

#include "ui/views/widgets/form_fields.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace odo {

TrackDialog::TrackDialog(const QString &trial, const QStringList &robots, const QStringList &expected,
                         const QStringList &caveats, QWidget *parent)
    : QDialog(parent), m_robots(new CheckList(tr("Robots to track"))), m_smoother(new QComboBox),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Track %1").arg(trial));
    m_robots->setNames(robots, expected.isEmpty());
    for (int i = 0; i < m_robots->count(); ++i)
        if (expected.contains(m_robots->item(i)->text()))
            m_robots->item(i)->setCheckState(Qt::Checked);
    m_smoother->addItem(tr("Kalman/RTS, noise from the data (best)"), static_cast<int>(Smoother::Rts));
    m_smoother->addItem(tr("Savitzky–Golay"), static_cast<int>(Smoother::SavGol));
    m_smoother->addItem(tr("Differences as in Tracker"), static_cast<int>(Smoother::Tracker));
    m_smoother->addItem(tr("None: raw differences"), static_cast<int>(Smoother::None));
    auto *form = new QFormLayout;
    form->addRow(tr("&Robots"), m_robots);
    form->addRow(tr("&Smoothing"), m_smoother);
    QPushButton *accept = m_buttons->addButton(tr("Track"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    for (const QString &sentence : caveats) {
        auto *doubt = new QLabel(sentence);
        doubt->setTextFormat(Qt::PlainText);
        doubt->setWordWrap(true);
        layout->addWidget(doubt);
    }
    layout->addWidget(m_buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    constexpr int width = 440;
    resize(width, layout->totalHeightForWidth(width));
    const auto update = [this, accept] { accept->setEnabled(!m_robots->checkedNames().empty()); };
    connect(m_robots, &QListWidget::itemChanged, this, update);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    update();
}

TrackSettings TrackDialog::settings() const
{
    TrackSettings settings;
    settings.robots = m_robots->checkedNames();
    settings.smoother = static_cast<Smoother>(m_smoother->currentData().toInt());
    return settings;
}

} // namespace odo
