// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/number_box.h"

#include "ui/models/typed_number.h"

#include <QLineEdit>

namespace odo {

/// While it is typed, a sign that parts thousands may still become anything.
QValidator::State NumberBox::validate(QString &text, int &position) const
{
    const bool isOpen = isReadTwoWays(text, locale()) || withDecimalSign(text, locale()) != text;
    return isOpen ? QValidator::Intermediate : QDoubleSpinBox::validate(text, position);
}

/// Qt's would take the signs away that part thousands.
void NumberBox::fixup(QString &text) const
{
    text = isReadTwoWays(text, locale()) ? prefix() + textFromValue(m_before) + suffix() : withDecimalSign(text, locale());
}

/// The number counts while it is typed: of "1.234" a one is taken first.
void NumberBox::rememberBefore()
{
    if (!lineEdit()->isModified())
        m_before = value();
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    rememberBefore();
    QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    rememberBefore();
    QDoubleSpinBox::focusInEvent(event);
}

} // namespace odo
