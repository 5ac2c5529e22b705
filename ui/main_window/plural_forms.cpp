// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/plural_forms.h"

#include <QCoreApplication>
#include <QTranslator>

namespace odo {

void installPluralForms(QCoreApplication &application)
{
    auto *forms = new QTranslator(&application);
    const bool isThere = forms->load(QStringLiteral(":/odograph/translations/odograph_en.qm"));
    Q_ASSERT(isThere); // compiled in
    if (isThere)
        QCoreApplication::installTranslator(forms);
}

} // namespace odo
