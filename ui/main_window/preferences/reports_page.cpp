// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/reports_page.h"

#include "ui/models/error_words.h"
#include "ui/report/logo.h"
#include "ui/views/path_field.h"

#include <QFormLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>

namespace odo {

ReportsPage::ReportsPage(QWidget *parent) : QWidget(parent), m_settings(storedReportSettings()), m_picture(new QLabel)
{
    auto *form = new QFormLayout(this);
    m_school = addLine(*form, tr("&School"), m_settings.school);
    m_school->setPlaceholderText(tr("stands at the head of each page"));
    m_logo = new PathField(tr("Logo"), tr("Pictures (*.png *.jpg *.jpeg *.svg)"));
    m_logo->setPath(m_settings.logoFile);
    connect(m_logo, &PathField::changed, this, &ReportsPage::store);
    auto *label = new QLabel(tr("&Logo"));
    label->setBuddy(m_logo);
    form->addRow(label, m_logo);
    m_picture->setWordWrap(true);
    m_picture->setTextFormat(Qt::PlainText);
    m_picture->setAccessibleName(tr("How the logo looks"));
    form->addRow(QString(), m_picture);
    m_remark = addLine(*form, tr("&At the foot"), m_settings.remark);
    m_remark->setPlaceholderText(tr("for example: who answers questions"));
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
    const auto picture = std::make_shared<QImage>();
    m_read = picture;
    m_reading.start([file = m_settings.logoFile, picture](const JobControl &) -> Result<void> {
        if (file.isEmpty())
            return {};
        const auto logo = readLogo(file.toStdString());
        if (!logo)
            return tl::unexpected(logo.error());
        *picture = logo->scaled(most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        return {};
    });
}

void ReportsPage::takeLogo(const std::optional<Error> &error)
{
    if (m_isOther)
        return showLogo();
    m_picture->setPixmap(QPixmap::fromImage(*m_read));
    if (error)
        m_picture->setText(errorLine(*error));
}

} // namespace odo
