// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/hub_dialog.h"

#include "ui/models/shown_message.h"
#include "ui/school/hub_exchange.h"
#include "ui/school/internal/conflict_dialog.h"
#include "ui/school/internal/hub_forms.h"
#include "ui/school/internal/hub_words.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace odo {

namespace {
constexpr int steps = 1000;
constexpr int lines = 4; ///< of words, so that the dialog keeps its size
} // namespace

HubDialog::HubDialog(HubExchange &exchange, QWidget *parent)
    : QDialog(parent), m_exchange(exchange), m_form(new ConnectForm), m_panel(new HubPanel),
      m_pages(new QStackedWidget), m_words(new QLabel), m_progress(new QProgressBar),
      m_cancel(plainButton(tr("Cancel")))
{
    setWindowTitle(tr("School hub"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_pages->addWidget(m_form);
    m_pages->addWidget(m_panel);
    showAsWords(*m_words);
    m_words->setMinimumHeight(lines * m_words->fontMetrics().lineSpacing());
    m_words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_words->setAccessibleName(tr("What was done"));
    m_progress->setRange(0, steps);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_cancel->setAccessibleName(tr("Cancel the exchange with the hub"));
    for (QWidget *one : std::initializer_list<QWidget *>{m_progress, m_cancel}) {
        QSizePolicy kept = one->sizePolicy();
        kept.setRetainSizeWhenHidden(true);
        one->setSizePolicy(kept);
    }
    auto *progress = new QHBoxLayout;
    progress->addWidget(m_progress, 1);
    progress->addWidget(m_cancel);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(m_pages, 1);
    layout->addLayout(progress);
    layout->addWidget(m_words);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_cancel->setEnabled(false);
        m_exchange.cancel();
    });
    connect(m_form, &ConnectForm::connectRequested, this, &HubDialog::connectProject);
    connect(m_panel, &HubPanel::publishRequested, &m_exchange, &HubExchange::publish);
    connect(m_panel, &HubPanel::pullRequested, &m_exchange, &HubExchange::pull);
    connect(m_panel, &HubPanel::disconnectRequested, this, &HubDialog::disconnectProject);
    connect(m_panel, &HubPanel::conflictsRequested, this, [this] { showConflicts(m_exchange, this); });
    connect(m_panel, &HubPanel::passwordEntered, this, [this](const QString &password) {
        if (const auto address = HubAddress::parse(m_exchange.state().link->url)) {
            m_exchange.setPassword(*address, password);
            m_exchange.publish(WithRecordings::No);
        }
    });
    connect(&m_exchange, &HubExchange::changed, this, &HubDialog::showState);
    m_form->connectButton()->setDefault(true);
    showState();
}

void HubDialog::connectProject()
{
    const auto address = m_form->address();
    m_notice = address ? QString() : errorInWords(address.error());
    if (address) {
        if (!m_form->password().isEmpty())
            m_exchange.setPassword(*address, m_form->password());
        m_form->clearPassword();
        m_exchange.connectTo(*address, m_form->folder());
    }
    showState();
}

void HubDialog::disconnectProject()
{
    const auto pending = static_cast<int>(m_exchange.state().pending);
    if (pending > 0) {
        QMessageBox question(QMessageBox::Question, tr("Disconnect"),
                             tr("%n change(s) are not sent yet. They stay in the project.", nullptr, pending),
                             QMessageBox::Cancel, this);
        question.setTextFormat(Qt::PlainText);
        QPushButton *disconnect = question.addButton(tr("&Disconnect"), QMessageBox::AcceptRole);
        question.setDefaultButton(QMessageBox::Cancel);
        question.exec();
        if (question.clickedButton() != disconnect)
            return;
    }
    if (const auto done = m_exchange.disconnectFromHub(); !done) {
        m_notice = errorInWords(done.error());
        showState();
    }
}

void HubDialog::showConflicts(HubExchange &exchange, QWidget *parent)
{
    if (ConflictDialog(exchange.conflicts(), parent).exec() == QDialog::Accepted)
        exchange.forgetConflicts();
}

void HubDialog::showState()
{
    const HubState &state = m_exchange.state();
    const bool isRunning = m_exchange.isRunning();
    if (isRunning)
        m_notice.clear();
    m_pages->setCurrentWidget(state.link ? static_cast<QWidget *>(m_panel) : m_form);
    m_form->setOpen(!isRunning && !m_exchange.isReadOnly());
    m_panel->showState(m_exchange);
    if (isRunning && m_progress->isHidden())
        m_cancel->setEnabled(true);
    m_progress->setVisible(isRunning);
    m_cancel->setVisible(isRunning);
    m_progress->setRange(0, state.done > 0 ? steps : 0); // not known yet: it runs to and fro
    m_progress->setValue(static_cast<int>(state.done * steps));
    QString words = m_notice.isEmpty() ? state.words : m_notice;
    if (isRunning && words.isEmpty())
        words = state.work == HubState::Work::Connecting ? tr("Connecting…") : tr("Asking the hub…");
    if (m_exchange.isReadOnly())
        words = tr("The project is read-only here, so nothing can be sent or received.");
    m_words->setText(words);
}

} // namespace odo
