// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace odo {

/// A spin box that takes point and comma alike as the decimal sign, once the number is finished, and shows what it read.
/// "1.234" that can be read in two ways is not taken (ui/models/typed_number.h): the number before comes back. Qt's own
/// makes 125 of "12.5" where a point parts thousands.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT
public:
    using QDoubleSpinBox::QDoubleSpinBox;

protected:
    QValidator::State validate(QString &text, int &position) const override;
    void fixup(QString &text) const override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    void rememberBefore();

    double m_before = 0; ///< what is typed now
};

} // namespace odo
