// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/track_reading_form.h"

#include "core/base/units.h"
#include "ui/views/widgets/form_fields.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

namespace odo {

namespace {

/// The first one is "from the file".
template <class Value>
std::optional<Value> chosenIn(const QComboBox *box)
{
    return box->currentIndex() > 0 ? std::optional(static_cast<Value>(box->currentIndex() - 1))
                                   : std::nullopt;
}

/// 0 is "from the file".
std::optional<double> numberIn(const QDoubleSpinBox *box)
{
    return box->value() > 0 ? std::optional(box->value()) : std::nullopt;
}

} // namespace

TrackReadingForm::TrackReadingForm(QWidget *parent) : QWidget(parent), m_grid(new QGridLayout(this))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setColumnStretch(1, 1);
    m_grid->setColumnStretch(3, 1);
    m_unit = addChoice(tr("&Unit of positions"),
                       {tr("m"), tr("cm"), tr("mm"), tr("pixels"), tr("inches"), tr("feet")});
    m_timeUnit = addChoice(tr("Unit of t&imes"), {tr("s"), tr("ms"), tr("µs"), tr("ns"), tr("frame numbers"),
                                                  tr("min"), tr("h"), tr("days")});
    m_axes = addChoice(tr("F&loor axes"), {tr("x and y"), tr("x and z"), tr("y and z")});
    m_decimal = addChoice(tr("&Decimal sign"), {tr("point"), tr("comma")});
    m_rate =
        addNumber(tr("&Frame rate"), 100000, 3, tr(" frames/s"), tr("Of a file that numbers its frames"));
    m_pixel =
        addNumber(tr("Length of a &pixel"), 1000, 4, tr(" mm"), tr("On the floor, for positions in pixels"));
    m_confidence = addNumber(tr("Least &confidence"), 1, 2, {},
                             tr("Positions with a lower likelihood count as not measured"));
    m_sigma =
        addNumber(tr("Accurac&y"), 1000, 2, tr(" mm"),
                  tr("Standard deviation of the positions, slow errors included; scatter alone does not "
                     "show those"));
}

QComboBox *TrackReadingForm::addChoice(const QString &label, const QStringList &shown)
{
    auto *box = new QComboBox;
    box->addItem(tr("from the file"));
    box->addItems(shown);
    connect(box, &QComboBox::currentIndexChanged, this, &TrackReadingForm::changed);
    place(label, box);
    return box;
}

QDoubleSpinBox *TrackReadingForm::addNumber(const QString &label, double most, int decimals,
                                            const QString &suffix, const QString &toolTip)
{
    auto *box = new NumberBox;
    box->setRange(0, most);
    box->setDecimals(decimals);
    box->setSuffix(suffix);
    box->setSpecialValueText(tr("from the file"));
    box->setToolTip(toolTip);
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TrackReadingForm::changed);
    place(label, box);
    return box;
}

void TrackReadingForm::place(const QString &label, QWidget *field)
{
    const int number = static_cast<int>(m_fields.size());
    auto *words = new QLabel(label);
    words->setBuddy(field);
    m_grid->addWidget(words, number / 2, 2 * (number % 2));
    m_grid->addWidget(field, number / 2, 2 * (number % 2) + 1);
    m_fields << field;
}

TrackReading TrackReadingForm::reading() const
{
    TrackReading reading;
    reading.unit = chosenIn<LengthUnit>(m_unit);
    reading.timeUnit = chosenIn<TimeUnit>(m_timeUnit);
    reading.axes = chosenIn<FloorAxes>(m_axes);
    reading.decimal = chosenIn<DecimalSign>(m_decimal);
    reading.rate = numberIn(m_rate);
    if (const auto pixel = numberIn(m_pixel))
        reading.pixelM = fromMillimetres(*pixel);
    reading.minConfidence = numberIn(m_confidence);
    return reading;
}

std::optional<double> TrackReadingForm::sigmaM() const
{
    const auto sigma = numberIn(m_sigma);
    return sigma ? std::optional(fromMillimetres(*sigma)) : std::nullopt;
}

QList<QWidget *> TrackReadingForm::fields() const
{
    return m_fields;
}

} // namespace odo
