// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/registration_verdict.h"

#include "ui/models/core_words.h"
#include "ui/models/error_words.h"
#include "ui/views/words_label.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace odo {

RegistrationVerdict::RegistrationVerdict(QWidget *parent)
    : Card(tr("Where the camera stands"), parent), m_verdict(new QLabel), m_advice(new QLabel)
{
    showAsVerdict(*m_verdict, *m_advice);
    m_verdict->setAccessibleName(tr("Verdict"));
    auto *said = new QWidget;
    auto *layout = new QVBoxLayout(said);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->addWidget(m_verdict);
    layout->addWidget(m_advice);
    layout->addStretch(1);
    setContent(said);
}

void RegistrationVerdict::tell(const FloorRegistration &registration)
{
    const Eigen::Vector3d &at = registration.worldFromCamera.translation;
    const QLocale locale;
    tell(shownWords(registration.verdict),
         tr("It stands at x %1 m, y %2 m, %3 m above the floor.")
             .arg(locale.toString(at.x(), 'f', 2), locale.toString(at.y(), 'f', 2),
                  locale.toString(at.z(), 'f', 2)));
}

void RegistrationVerdict::tell(const QString &verdict, const QString &advice)
{
    m_verdict->setText(verdict);
    m_advice->setText(advice);
}

void RegistrationVerdict::tellNotSaved(const Error &error)
{
    m_advice->setText(tr("The registration was not stored. %1").arg(errorLine(error)));
}

} // namespace odo
