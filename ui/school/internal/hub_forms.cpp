// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/internal/hub_forms.h"

#include "ui/models/shown_message.h"
#include "ui/school/internal/hub_words.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/labels.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace odo {

namespace {

constexpr int fieldLetters = 54, factLines = 15;

QLineEdit *passwordField(const QString &name)
{
    auto *field = new QLineEdit;
    field->setEchoMode(QLineEdit::Password);
    field->setInputMethodHints(Qt::ImhHiddenText | Qt::ImhNoPredictiveText | Qt::ImhNoAutoUppercase);
    field->setAccessibleName(name);
    field->setToolTip(
        ConnectForm::tr("Odograph keeps it until you close the program, and writes it nowhere"));
    return field;
}

} // namespace

ConnectForm::ConnectForm(QWidget *parent)
    : QWidget(parent), m_address(new QLineEdit), m_password(passwordField(tr("Password"))),
      m_folder(new QLineEdit), m_browse(plainButton(tr("&Browse…"))),
      m_connect(new QPushButton(tr("C&onnect")))
{
    auto *intro = new QLabel(tr(
        "Connect this project to the school's hub. Odograph sends its trials, tasks and class lists there, "
        "and you receive those of the other benches. You can measure without the network; Odograph sends "
        "later what it could not send."));
    intro->setWordWrap(true);
    m_address->setPlaceholderText(tr("postgresql://bench1@hub.school.example/school"));
    m_address->setAccessibleName(tr("Address of the hub"));
    m_address->setMinimumWidth(fieldLetters * m_address->fontMetrics().averageCharWidth());
    m_password->setPlaceholderText(tr("empty: as in ~/.pgpass or PGPASSWORD"));
    m_folder->setPlaceholderText(tr("optional: a folder that all benches can reach"));
    m_folder->setAccessibleName(tr("Folder for recordings"));
    m_browse->setAccessibleName(tr("Browse: %1").arg(m_folder->accessibleName()));
    auto *folder = new QHBoxLayout;
    folder->addWidget(m_folder, 1);
    folder->addWidget(m_browse);
    auto *form = new QFormLayout;
    form->addRow(tr("&Address:"), m_address);
    form->addRow(tr("&Password:"), m_password);
    auto *folderLabel = new QLabel(tr("&Recordings:"));
    folderLabel->setBuddy(m_folder);
    form->addRow(folderLabel, folder);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(intro);
    layout->addLayout(form);
    layout->addWidget(m_connect, 0, Qt::AlignRight);
    layout->addStretch(1);
    const auto offer = [this] { m_connect->setEnabled(!m_address->text().trimmed().isEmpty()); };
    connect(m_address, &QLineEdit::textChanged, this, offer);
    connect(m_browse, &QPushButton::clicked, this, &ConnectForm::browse);
    connect(m_connect, &QPushButton::clicked, this, &ConnectForm::connectRequested);
    offer();
}

Result<HubAddress> ConnectForm::address() const
{
    return HubAddress::parse(m_address->text().trimmed().toStdString());
}

QString ConnectForm::password() const
{
    return m_password->text();
}

QString ConnectForm::folder() const
{
    const QString folder = m_folder->text().trimmed();
    return folder.isEmpty() ? folder : QDir(folder).absolutePath();
}

void ConnectForm::clearPassword()
{
    m_password->clear();
}

void ConnectForm::setOpen(bool isOpen)
{
    for (QWidget *widget : std::initializer_list<QWidget *>{m_address, m_password, m_folder, m_browse})
        widget->setEnabled(isOpen);
    m_connect->setEnabled(isOpen && !m_address->text().trimmed().isEmpty());
}

void ConnectForm::browse()
{
    const QString chosen =
        QFileDialog::getExistingDirectory(this, m_folder->accessibleName(), m_folder->text());
    if (!chosen.isEmpty())
        m_folder->setText(QDir::toNativeSeparators(chosen));
}

HubPanel::HubPanel(QWidget *parent)
    : QWidget(parent), m_facts(new FactList(FactList::Badges::Beneath)), m_login(new QWidget),
      m_password(passwordField(tr("Password of the hub"))),
      m_recordings(new QCheckBox(tr("Copy &recordings, too"))), m_publish(plainButton(tr("&Publish now"))),
      m_pull(plainButton(tr("Pu&ll now"))), m_conflicts(plainButton({})),
      m_disconnect(plainButton(tr("&Disconnect")))
{
    m_publish->setToolTip(tr("Send to the hub what is pending. Odograph also does this by itself."));
    m_pull->setToolTip(tr("Receive class lists, tasks and the trials of other benches"));
    m_recordings->setToolTip(tr("To and from the school's folder for recordings; this can take long"));
    auto *enter = plainButton(tr("Log &in"));
    auto *login = new QHBoxLayout(m_login);
    login->setContentsMargins(0, 0, 0, 0);
    auto *label = new QLabel(tr("Pass&word:"));
    label->setBuddy(m_password);
    login->addWidget(label);
    login->addWidget(m_password, 1);
    login->addWidget(enter);
    auto *work = new QHBoxLayout;
    work->addWidget(m_publish);
    work->addWidget(m_pull);
    work->addWidget(m_recordings);
    work->addStretch(1);
    auto *more = new QHBoxLayout;
    more->addWidget(m_conflicts);
    more->addStretch(1);
    more->addWidget(m_disconnect);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    QScrollArea *facts = scrolled(m_facts, tr("How the project is connected"));
    facts->setMinimumHeight(factLines * fontMetrics().lineSpacing());
    auto *card = new Card(tr("Connection"));
    card->setContent(facts);
    layout->addWidget(card, 1);
    layout->addWidget(m_login);
    layout->addLayout(work);
    layout->addLayout(more);
    connect(enter, &QPushButton::clicked, this, &HubPanel::enterPassword);
    connect(m_password, &QLineEdit::returnPressed, this, &HubPanel::enterPassword);
    connect(m_publish, &QPushButton::clicked, this, [this] { Q_EMIT publishRequested(recordings()); });
    connect(m_pull, &QPushButton::clicked, this, [this] { Q_EMIT pullRequested(recordings()); });
    connect(m_conflicts, &QPushButton::clicked, this, &HubPanel::conflictsRequested);
    connect(m_disconnect, &QPushButton::clicked, this, &HubPanel::disconnectRequested);
}

WithRecordings HubPanel::recordings() const
{
    return m_recordings->isChecked() ? WithRecordings::Yes : WithRecordings::No;
}

void HubPanel::enterPassword()
{
    const QString password = m_password->text();
    m_password->clear();
    if (!password.isEmpty())
        Q_EMIT passwordEntered(password);
}

void HubPanel::showState(const HubExchange &exchange)
{
    const HubState &state = exchange.state();
    if (!state.link)
        return;
    const SchoolLink &link = *state.link;
    const QString last = link.lastSync ? shortDate(*link.lastSync) : tr("not yet");
    const QList<Fact> facts{{tr("Hub"), hubName(link), hubBadge(state)},
                            {tr("Role"), roleWords(link.role), {}},
                            {tr("Schema"), tr("Version %1").arg(link.schemaVersion), {}},
                            {tr("Last exchange"), last, {}},
                            {tr("Still to be sent"), pendingWords(state), {}},
                            {tr("Recordings"),
                             link.media.empty()
                                 ? tr("No folder: they stay at this bench")
                                 : QDir::toNativeSeparators(QString::fromStdString(link.media)),
                             {}}};
    QStringList shown;
    for (const Fact &fact : facts)
        shown << fact.value << fact.badge.text;
    if (std::exchange(m_shown, shown.join(u'\n')) != m_shown) // progress alone leaves them as they are
        m_facts->setFacts(facts);
    const bool isFree = !exchange.isRunning() && !exchange.isReadOnly();
    m_login->setVisible(state.isPasswordWanted);
    m_recordings->setVisible(!link.media.empty());
    m_recordings->setEnabled(isFree);
    m_publish->setEnabled(isFree && link.role != "viewer");
    m_pull->setEnabled(isFree && link.role != "viewer");
    m_disconnect->setEnabled(isFree);
    m_conflicts->setVisible(!exchange.conflicts().empty());
    m_conflicts->setText(tr("&Changed twice: %n…", nullptr, static_cast<int>(exchange.conflicts().size())));
}

} // namespace odo
