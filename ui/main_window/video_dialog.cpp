// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/video_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace odo {

VideoDialog::VideoDialog(const QString &title, bool isDark, QWidget *parent)
    : QDialog(parent), m_speed(new QComboBox), m_size(new QComboBox), m_theme(new QComboBox)
{
    setWindowTitle(title);
    m_speed->addItem(tr("As it was driven"), 1.0);
    m_speed->addItem(tr("Slow motion, 1/2"), 0.5);
    m_speed->addItem(tr("Slow motion, 1/4"), 0.25);
    m_speed->addItem(tr("Slow motion, 1/10"), 0.1);
    for (const QSize size : {QSize(1920, 1080), QSize(1280, 720), QSize(3840, 2160)})
        m_size->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    m_theme->addItem(tr("Light"), false);
    m_theme->addItem(tr("Dark"), true);
    m_theme->setCurrentIndex(isDark ? 1 : 0);
    auto *words = new QLabel(tr("One video with the pictures of all cameras, the map and the speed, to be shown or sent: whoever "
                                "gets it needs no Odograph."));
    words->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Speed"), m_speed);
    form->addRow(tr("Si&ze"), m_size);
    form->addRow(tr("&Theme"), m_theme);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *accept = buttons->addButton(tr("Choose a place…"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    constexpr int width = 420;
    resize(width, layout->totalHeightForWidth(width));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

AnnotatedVideoSettings VideoDialog::settings() const
{
    AnnotatedVideoSettings settings;
    settings.speed = m_speed->currentData().toDouble();
    settings.sizePx = m_size->currentData().toSize();
    settings.isDark = m_theme->currentData().toBool();
    return settings;
}

} // namespace odo
