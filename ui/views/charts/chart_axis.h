// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QObject>
#include <QString>
#include <vector>

namespace odo {

/// What of an axis charts show: from where to where, within a whole. One for all charts below one another.
/// GUI thread.
class AxisSpan : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    double low() const { return m_low; }
    double high() const { return m_high; }
    double wholeLow() const { return m_wholeLow; }
    double wholeHigh() const { return m_wholeHigh; }
    /// A new whole (at least 1 wide where high is not above low), all of it shown, without a signal.
    void setWhole(double low, double high);
    /// Shows from low to high: kept inside the whole, and not narrower than a ten-thousandth of it.
    void show(double low, double high);
    /// About a position; a factor above 1 shows less.
    void zoom(double factor, double about);
    /// By so much of what is visible.
    void pan(double share);
    void showAll() { show(m_wholeLow, m_wholeHigh); }
    bool showsAll() const { return m_low <= m_wholeLow && m_high >= m_wholeHigh; }

Q_SIGNALS:
    void spanChanged(); ///< low or high

private:
    double m_wholeLow = 0, m_wholeHigh = 1, m_low = 0, m_high = 1;
};

/// Where an axis puts its marks: round numbers (1, 2 or 5 times a power of ten) that cover a range.
struct AxisTicks
{
    double first = 0, step = 1; ///< step > 0
    int count = 0;              ///< marks; the last is first + (count − 1) · step
    int decimals = 0;           ///< that the labels need

    std::vector<double> values() const;
    double last() const { return first + (count - 1) * step; }
    QString label(double value, const QLocale &locale = QLocale()) const;
};

/// Marks inside [low, high], at most about `most` of them.
AxisTicks niceTicks(double low, double high, int most);
/// Marks that reach to or beyond both ends of [low, high].
AxisTicks coveringTicks(double low, double high, int most);

} // namespace odo
