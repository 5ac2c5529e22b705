// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/general_page.h"

#include "ui/main_window/language.h"
#include "ui/models/shown_units.h"
#include "ui/views/theme.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLinearGradient>
#include <QPainter>
#include <QSettings>
#include <algorithm>

namespace odo {
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
    m_languageWords = quietWords(tr("Odograph shows it when it is started again."));
    m_languageWords->hide();
    form->addRow(tr("&Language"), makeLanguages());
    form->addRow(QString(), m_languageWords);
    form->addRow(tr("&Units of results"), makeUnits());
    form->addRow(QString(), quietWords(tr("Floors and targets are set up in millimetres, as they are printed. Exported "
                                          "files have the units that their format asks for.")));
    form->addRow(tr("&Theme"), makeThemes(theme));
    form->addRow(tr("&Colours of maps"), makeScales());
    form->addRow(QString(), quietWords(tr("Both can be told apart by people who do not see red or green, and in a "
                                          "print without colours.")));
}

void GeneralPage::applySettings()
{
    const QSettings settings;
    setShownUnitSystem(unitSystemFromWord(settings.value(unitsKey).toString()));
    setShownColourScale(colourScaleFromWord(settings.value(scaleKey).toString()));
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
        Q_EMIT lookChanged();
    });
    return box;
}

QComboBox *GeneralPage::makeLanguages()
{
    auto *box = new QComboBox;
    box->setAccessibleName(tr("Language"));
    box->addItem(tr("As the computer has it"), QString());
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
    for (const QString &words : {tr("As the desktop has it"), tr("Light"), tr("Dark")})
        box->addItem(words);
    box->setCurrentIndex(static_cast<int>(theme));
    connect(box, &QComboBox::activated, this, [this](int chosen) { Q_EMIT themeChosen(static_cast<Theme>(chosen)); });
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
        Q_EMIT lookChanged();
    });
    return box;
}

} // namespace odo
