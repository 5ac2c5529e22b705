// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/preferences_dialog.h"

#include "ui/main_window/language.h"
#include "ui/main_window/preferences/backup_plan.h"
#include "ui/main_window/preferences/command_keys.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/record/record_page.h"
#include "ui/report/report_maker.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QLinearGradient>
#include <QPainter>
#include <QPixmap>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

PreferencesDialog::PreferencesDialog(CommandKeys &keys, Theme theme, QWidget *parent)
    : QDialog(parent), m_tabs(new QTabWidget)
{
    setWindowTitle(tr("Preferences"));
    auto *general = new GeneralPage(theme);
    m_tabs->setAccessibleName(tr("Categories of preferences"));
    m_tabs->addTab(general, tr("&General"));
    m_tabs->addTab(new ReportsPage, tr("&Reports"));
    m_tabs->addTab(new KeysPage(keys), tr("&Keys"));
    m_tabs->addTab(new NetworkPage, tr("&Network"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_tabs, 1);
    layout->addWidget(buttons);
    resize(560, 520);
    connect(general, &GeneralPage::themeChosen, this, &PreferencesDialog::themeChosen);
    connect(general, &GeneralPage::styleChanged, this, &PreferencesDialog::styleChanged);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PreferencesDialog::turnTo(Page page)
{
    m_tabs->setCurrentIndex(page);
}

namespace {

const QString unitsKey = QStringLiteral("units"), scaleKey = QStringLiteral("colourScale");

QIcon swatch(ColourScale scale)
{
    QPixmap strip(48, 14);
    QPainter painter(&strip);
    for (int x = 0; x < strip.width(); ++x)
        painter.fillRect(x, 0, 1, strip.height(), scaleColour(double(x) / (strip.width() - 1), scale));
    return strip;
}

QLabel *quietWords(const QString &words)
{
    auto *label = new QLabel(words);
    label->setObjectName(QStringLiteral("quiet"));
    label->setWordWrap(true);
    return label;
}

} // namespace

GeneralPage::GeneralPage(Theme theme, QWidget *parent) : QWidget(parent)
{
    auto *form = new QFormLayout(this);
    m_languageWords = quietWords(tr("Restart Odograph to see the change."));
    m_languageWords->hide();
    form->addRow(tr("&Language"), makeLanguages());
    form->addRow(QString(), m_languageWords);
    form->addRow(tr("&Units of results"), makeUnits());
    form->addRow(QString(), quietWords(tr("Floors and targets always use millimetres, as printed. Exported "
                                          "files use the units of their format.")));
    form->addRow(tr("&Theme"), makeThemes(theme));
    form->addRow(tr("&Colours of maps"), makeScales());
    form->addRow(QString(), quietWords(tr("Both remain readable for people with red-green colour blindness "
                                          "and in black-and-white prints.")));
    addBackups(*form);
}

void GeneralPage::applySettings()
{
    const QSettings settings;
    setShownUnitSystem(unitSystemFromWord(settings.value(unitsKey).toString()));
    setShownColourScale(colourScaleFromWord(settings.value(scaleKey).toString()));
}

void GeneralPage::addBackups(QFormLayout &form)
{
    const BackupPlan plan = chosenBackupPlan();
    auto *daily = new QCheckBox(tr("&Back up a project on each day you open it"));
    daily->setChecked(plan.isDaily);
    daily->setObjectName(QStringLiteral("dailyBackups"));
    auto *days = new QSpinBox;
    days->setObjectName(QStringLiteral("backupDays"));
    days->setRange(BackupPlan::fewestDays, BackupPlan::mostDays);
    days->setValue(plan.daysKept);
    days->setEnabled(plan.isDaily);
    form.addRow(QString(), daily);
    form.addRow(tr("&Days to keep backups"), days);
    form.addRow(QString(), quietWords(tr("Backups are beside the project and contain everything except the "
                                         "videos: File ▸ Backups… shows and restores them.")));
    const auto store = [daily, days] {
        days->setEnabled(daily->isChecked());
        chooseBackupPlan({daily->isChecked(), days->value()});
    };
    connect(daily, &QCheckBox::toggled, this, store);
    connect(days, &QSpinBox::valueChanged, this, store);
}

QComboBox *GeneralPage::makeUnits()
{
    auto *box = new QComboBox;
    box->setAccessibleName(tr("Units of results"));
    box->addItem(tr("Millimetres and metres: mm, m, m/s"));
    box->addItem(tr("Centimetres: cm, cm/s"));
    box->addItem(tr("Inches and feet: in, ft, ft/s"));
    box->setCurrentIndex(static_cast<int>(shownUnitSystem()));
    connect(box, &QComboBox::activated, this, [this](int system) {
        setShownUnitSystem(static_cast<UnitSystem>(system));
        QSettings().setValue(unitsKey, unitSystemWord(shownUnitSystem()));
        Q_EMIT styleChanged();
    });
    return box;
}

QComboBox *GeneralPage::makeLanguages()
{
    auto *box = new QComboBox;
    box->setAccessibleName(tr("Language"));
    box->addItem(tr("As set on the computer"), QString());
    for (const Language &each : languages())
        box->addItem(each.name, each.code);
    box->setCurrentIndex(std::max(0, box->findData(chosenLanguage())));
    connect(box, &QComboBox::activated, this, [this, box] {
        chooseLanguage(box->currentData().toString());
        m_languageWords->show();
    });
    return box;
}

QComboBox *GeneralPage::makeThemes(Theme theme)
{
    auto *box = new QComboBox;
    box->setAccessibleName(tr("Theme"));
    for (const QString &words : {tr("As set on the desktop"), tr("Light"), tr("Dark")})
        box->addItem(words);
    box->setCurrentIndex(static_cast<int>(theme));
    connect(box, &QComboBox::activated, this,
            [this](int chosen) { Q_EMIT themeChosen(static_cast<Theme>(chosen)); });
    return box;
}

QComboBox *GeneralPage::makeScales()
{
    auto *box = new QComboBox;
    box->setAccessibleName(tr("Colours of maps"));
    box->setIconSize({48, 14});
    box->addItem(swatch(ColourScale::Cividis), tr("Cividis"));
    box->addItem(swatch(ColourScale::Viridis), tr("Viridis"));
    box->setCurrentIndex(static_cast<int>(shownColourScale()));
    connect(box, &QComboBox::activated, this, [this](int scale) {
        setShownColourScale(static_cast<ColourScale>(scale));
        QSettings().setValue(scaleKey, colourScaleWord(shownColourScale()));
        Q_EMIT styleChanged();
    });
    return box;
}

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
    : QWidget(parent), m_on(new QCheckBox(tr("&Send live positions on the network"))),
      m_address(new QLineEdit), m_port(new QSpinBox), m_interface(new QComboBox), m_words(wrapped({}))
{
    const SentPositions chosen = SentPositions::chosen();
    m_on->setChecked(chosen.isOn);
    m_address->setText(QString::fromStdString(chosen.target.address));
    m_port->setRange(1, 65535);
    m_port->setValue(chosen.target.port);
    m_port->setGroupSeparatorShown(false);
    for (const QString &name : networkInterfaces())
        m_interface->addItem(name == QString::fromStdString(BroadcastTarget().interface)
                                 ? tr("%1: this computer only").arg(name)
                                 : name,
                             name);
    const QString own = QString::fromStdString(chosen.target.interface);
    if (m_interface->findData(own) < 0)
        m_interface->addItem(tr("%1: not available now").arg(own), own);
    m_interface->setCurrentIndex(m_interface->findData(own));
    m_words->setTextFormat(Qt::PlainText);
    auto *form = new QFormLayout(this);
    form->addRow(m_on);
    form->addRow(wrapped(tr("Positions of the robots that Record tracks, as SSL-Vision packets for your own "
                            "controllers and programs. The packets contain no names of teams or robots.")));
    form->addRow(tr("&Address"), m_address);
    form->addRow(tr("&Port"), m_port);
    form->addRow(tr("&Interface"), m_interface);
    form->addRow(QString(), m_words);
    connect(m_on, &QCheckBox::toggled, this, &NetworkPage::choose);
    connect(m_address, &QLineEdit::textChanged, this, &NetworkPage::choose);
    connect(m_port, &QSpinBox::valueChanged, this, &NetworkPage::choose);
    connect(m_interface, &QComboBox::activated, this, &NetworkPage::choose);
    showState();
}

/// An address that is being typed is none for a while: until it is one, the one before stays.
void NetworkPage::choose()
{
    showState();
    SentPositions wanted{m_on->isChecked(),
                         {m_address->text().trimmed().toStdString(),
                          static_cast<std::uint16_t>(m_port->value()),
                          m_interface->currentData().toString().toStdString()}};
    if (!parseBroadcastTarget(wanted.target.address))
        wanted.target.address = SentPositions::chosen().target.address;
    wanted.choose();
}

void NetworkPage::showState()
{
    const std::string address = m_address->text().trimmed().toStdString();
    const bool isAddress = parseBroadcastTarget(address).has_value(),
               isGroup = isAddress && isMulticastGroup(address);
    m_address->setEnabled(m_on->isChecked());
    m_port->setEnabled(m_on->isChecked());
    // the way to one machine is the system's affair
    m_interface->setEnabled(m_on->isChecked() && (isGroup || !isAddress));
    const bool staysHere =
        m_interface->currentData().toString() == QString::fromStdString(BroadcastTarget().interface);
    m_words->setText(!m_on->isChecked() ? tr("Odograph sends nothing.")
                     : !isAddress       ? tr("This is not an IPv4 address; enter one such as 224.5.23.2.")
                     : !isGroup         ? tr("They go only to the computer with this address.")
                     : staysHere        ? tr("They do not leave this computer.")
                                        : tr("Anyone on that network can read the robots' positions."));
}

ReportsPage::ReportsPage(QWidget *parent)
    : QWidget(parent), m_settings(storedReportSettings()), m_image(new QLabel)
{
    auto *form = new QFormLayout(this);
    m_school = addLine(*form, tr("&School"), m_settings.school);
    m_school->setPlaceholderText(tr("shown at the top of each page"));
    m_logo = new PathField(tr("Logo"), tr("Images (*.png *.jpg *.jpeg *.svg)"));
    m_logo->setPath(m_settings.logoFile);
    connect(m_logo, &PathField::changed, this, &ReportsPage::store);
    auto *label = new QLabel(tr("&Logo"));
    label->setBuddy(m_logo);
    form->addRow(label, m_logo);
    m_image->setWordWrap(true);
    m_image->setTextFormat(Qt::PlainText);
    m_image->setAccessibleName(tr("Preview of the logo"));
    form->addRow(QString(), m_image);
    m_remark = addLine(*form, tr("&At the bottom"), m_settings.remark);
    m_remark->setPlaceholderText(tr("for example: whom to ask"));
    connect(&m_reading, &BackgroundTask::finished, this, &ReportsPage::takeLogo);
    showLogo();
}

QLineEdit *ReportsPage::addLine(QFormLayout &form, const QString &label, const QString &text)
{
    constexpr int longest = 200;
    auto *line = new QLineEdit(text);
    line->setMaxLength(longest);
    form.addRow(label, line);
    connect(line, &QLineEdit::editingFinished, this, &ReportsPage::store);
    return line;
}

void ReportsPage::store()
{
    m_settings.school = m_school->text();
    m_settings.remark = m_remark->text();
    m_settings.logoFile = textOf(m_logo->path());
    storeReportSettings(m_settings);
    showLogo();
}

/// Or why it cannot be used.
void ReportsPage::showLogo()
{
    static constexpr QSize most(220, 60);
    m_isOther = m_reading.isRunning();
    if (m_isOther)
        return;
    const auto image = std::make_shared<QImage>();
    m_read = image;
    m_reading.start([file = m_settings.logoFile, image](const JobControl &) -> Result<void> {
        if (file.isEmpty())
            return {};
        const auto logo = ODO_TRY(readLogo(file.toStdString()));
        *image = logo.scaled(most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        return {};
    });
}

void ReportsPage::takeLogo(const std::optional<Error> &error)
{
    if (m_isOther)
        return showLogo();
    m_image->setPixmap(QPixmap::fromImage(*m_read));
    if (error)
        m_image->setText(errorLine(*error));
}

} // namespace odo
