// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

namespace odo {

/// A QR code (ISO/IEC 18004) with medium error correction: so many modules a side, dark or not, without the
/// quiet zone around it. Pure.
struct QrCode
{
    int side = 0;             ///< 0: the text is too long
    std::vector<bool> isDark; ///< row by row

    static QrCode of(const QString &text);
};

/// Shows an address as a QR code, black on white in any theme, as phones read it. Its accessible name is the
/// address.
class QrWidget : public QWidget
{
    Q_OBJECT
public:
    explicit QrWidget(QWidget *parent = nullptr);
    void setText(const QString &text); ///< empty: nothing is shown

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QrCode m_code;
};

} // namespace odo
