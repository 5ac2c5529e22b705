// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/trial_chooser.h"

#include "ui/models/name_list_model.h"
#include "ui/views/command_names.h"
#include "ui/views/theme_icon.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

namespace odo {
namespace {

QToolButton *buttonFor(QAction *action, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setProperty("flat", true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action->text().remove(QLatin1Char('&')));
    return button;
}

} // namespace

TrialChooser::TrialChooser(QWidget *parent)
    : QWidget(parent), m_trials(new QComboBox(this)),
      m_previous(new QAction(themeIcon(QStringLiteral("previous")), tr("&Previous trial"), this)),
      m_next(new QAction(themeIcon(QStringLiteral("next")), tr("&Next trial"), this))
{
    m_trials->setAccessibleName(tr("Trial"));
    m_trials->setFocusPolicy(Qt::TabFocus); // chosen from by the mouse it takes no focus, and Space goes on playing
    m_trials->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_trials->setMinimumContentsLength(8);
    nameCommands({{m_previous, "previousTrial"}, {m_next, "nextTrial"}});
    m_previous->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageUp));
    m_next->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageDown));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttonFor(m_previous, this));
    layout->addWidget(m_trials, 1);
    layout->addWidget(buttonFor(m_next, this));
    connect(m_trials, &QComboBox::activated, this,
            [this](int index) { Q_EMIT chosen(m_trials->itemData(index).toString()); });
    connect(m_previous, &QAction::triggered, this, [this] { step(-1); });
    connect(m_next, &QAction::triggered, this, [this] { step(1); });
    updateActions();
}

void TrialChooser::setTrials(const QStringList &names, const QStringList &words)
{
    const QString current = m_trials->currentData().toString();
    m_trials->setModel(new NameListModel(names, words, m_trials)); // the one before goes with it
    setCurrent(current);
}

void TrialChooser::setCurrent(const QString &name)
{
    const auto *model = qobject_cast<NameListModel *>(m_trials->model());
    m_trials->setCurrentIndex(model ? model->indexOf(name) : -1);
    m_trials->setToolTip(m_trials->currentText().toHtmlEscaped());
    updateActions();
}

void TrialChooser::step(int by)
{
    const int index = m_trials->currentIndex() + by;
    if (index >= 0 && index < m_trials->count())
        Q_EMIT chosen(m_trials->itemData(index).toString());
}

void TrialChooser::updateActions()
{
    m_previous->setEnabled(m_trials->currentIndex() > 0);
    m_next->setEnabled(m_trials->currentIndex() >= 0 && m_trials->currentIndex() + 1 < m_trials->count());
    m_trials->setEnabled(m_trials->count() > 0);
}

} // namespace odo
