// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/step_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace odo {

StepDialog::StepDialog(const QString &windowTitle, const QString &lastButton, QWidget *parent)
    : QDialog(parent), m_lastButton(lastButton), m_title(new QLabel), m_steps(new QLabel),
      m_missing(new QLabel), m_pages(new QStackedWidget), m_back(new QPushButton(tr("< &Back"))),
      m_next(new QPushButton)
{
    setWindowTitle(windowTitle);
    m_title->setStyleSheet(QStringLiteral("font-size: 16pt; font-weight: 600"));
    m_steps->setObjectName(QStringLiteral("quiet"));
    auto *head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addStretch(1);
    head->addWidget(m_steps);
    auto *cancel = new QPushButton(tr("Cancel"));
    m_missing->setObjectName(QStringLiteral("quiet"));
    m_missing->setWordWrap(true);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_missing, 1);
    for (QPushButton *button : {m_back, m_next, cancel}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    m_next->setProperty("primary", true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addLayout(head);
    layout->addSpacing(6);
    layout->addWidget(m_pages, 1);
    layout->addLayout(buttons);
    m_next->setDefault(true);
    connect(m_next, &QPushButton::clicked, this, [this] { next(); });
    connect(m_back, &QPushButton::clicked, this, [this] { back(); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_saving, &BackgroundTask::finished, this, [this](const std::optional<Error> &error) {
        if (!isVisible()) // left meanwhile
            return;
        if (!error)
            return accept();
        showNotSaved(*error);
        updateButtons();
    });
}

void StepDialog::saveAndAccept(BackgroundTask::Work work)
{
    m_saving.start(std::move(work));
    updateButtons();
}

void StepDialog::done(int result)
{
    m_saving.cancel();
    QDialog::done(result);
}

void StepDialog::reject()
{
    if (const QString lost = unsaved(); !lost.isEmpty()) {
        QMessageBox question(QMessageBox::Question, windowTitle(), tr("Discard %1?").arg(lost),
                             QMessageBox::NoButton, this);
        QPushButton *discard = question.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
        QPushButton *stay = question.addButton(tr("&Keep working"), QMessageBox::RejectRole);
        question.setDefaultButton(stay);
        question.setEscapeButton(stay);
        question.exec();
        if (question.clickedButton() != discard)
            return;
    }
    QDialog::reject();
}

void StepDialog::addStep(const QString &title, QWidget *page)
{
    m_titles << title;
    m_pages->addWidget(page);
}

void StepDialog::turnTo(int step)
{
    m_title->setText(m_titles.at(step));
    m_steps->setText(tr("step %1 of %2").arg(step + 1).arg(m_titles.size()));
    m_pages->setCurrentIndex(step);
    m_next->setText(step + 1 == m_titles.size() ? m_lastButton : tr("&Next >"));
    updateButtons();
    m_pages->currentWidget()->setFocus();
}

int StepDialog::step() const
{
    return m_pages->currentIndex();
}

void StepDialog::updateButtons()
{
    m_back->setEnabled(step() > 0);
    const QString lacks = missing(step());
    const bool isWaiting = isBusy(step());
    m_missing->setText(isWaiting ? QString() : lacks);
    m_next->setEnabled(!isWaiting && lacks.isEmpty());
}

} // namespace odo
