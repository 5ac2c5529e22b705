// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/network_page.h"

#include "ui/record/sent_positions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

namespace odo {
namespace {

QLabel *wrapped(const QString &words)
{
    auto *label = new QLabel(words);
    label->setObjectName(QStringLiteral("quiet"));
    label->setWordWrap(true);
    return label;
}

} // namespace

NetworkPage::NetworkPage(QWidget *parent)
    : QWidget(parent), m_on(new QCheckBox(tr("&Send live positions on the network"))), m_address(new QLineEdit), m_port(new QSpinBox),
      m_interface(new QComboBox), m_words(wrapped({}))
{
    const SentPositions chosen = SentPositions::chosen();
    m_on->setChecked(chosen.isOn);
    m_address->setText(QString::fromStdString(chosen.target.address));
    m_port->setRange(1, 65535);
    m_port->setValue(chosen.target.port);
    m_port->setGroupSeparatorShown(false);
    for (const QString &name : networkInterfaces())
        m_interface->addItem(name == QString::fromStdString(BroadcastTarget().interface) ? tr("%1: this machine only").arg(name) : name, name);
    const QString own = QString::fromStdString(chosen.target.interface);
    if (m_interface->findData(own) < 0)
        m_interface->addItem(tr("%1: not there now").arg(own), own);
    m_interface->setCurrentIndex(m_interface->findData(own));
    m_words->setTextFormat(Qt::PlainText);
    auto *form = new QFormLayout(this);
    form->addRow(m_on);
    form->addRow(wrapped(tr("The places of the robots that Record follows, as packets of SSL-Vision, for controllers and programs of your own. No name of "
                            "a team or a robot is in them.")));
    form->addRow(tr("&Address"), m_address);
    form->addRow(tr("&Port"), m_port);
    form->addRow(tr("&Interface"), m_interface);
    form->addRow(QString(), m_words);
    connect(m_on, &QCheckBox::toggled, this, &NetworkPage::choose);
    connect(m_address, &QLineEdit::textChanged, this, &NetworkPage::choose);
    connect(m_port, &QSpinBox::valueChanged, this, &NetworkPage::choose);
    connect(m_interface, &QComboBox::activated, this, &NetworkPage::choose);
    tell();
}

/// An address that is being typed is none for a while: until it is one, the one before stays.
void NetworkPage::choose()
{
    tell();
    SentPositions wanted{m_on->isChecked(), {m_address->text().trimmed().toStdString(), static_cast<std::uint16_t>(m_port->value()),
                                             m_interface->currentData().toString().toStdString()}};
    if (!parseBroadcastTarget(wanted.target.address))
        wanted.target.address = SentPositions::chosen().target.address;
    wanted.choose();
}

void NetworkPage::tell()
{
    const std::string address = m_address->text().trimmed().toStdString();
    const bool isAddress = parseBroadcastTarget(address).has_value(), isGroup = isAddress && isMulticastGroup(address);
    m_address->setEnabled(m_on->isChecked());
    m_port->setEnabled(m_on->isChecked());
    m_interface->setEnabled(m_on->isChecked() && (isGroup || !isAddress)); // the way to one machine is the system's affair
    const bool staysHere = m_interface->currentData().toString() == QString::fromStdString(BroadcastTarget().interface);
    m_words->setText(!m_on->isChecked() ? tr("Nothing is sent.")
                     : !isAddress       ? tr("This is no IPv4 address; write it like 224.5.23.2.")
                     : !isGroup         ? tr("They go to the one machine that has this address.")
                     : staysHere        ? tr("They do not leave this machine.")
                                        : tr("Whoever is on that network can read where the robots are."));
}

} // namespace odo
