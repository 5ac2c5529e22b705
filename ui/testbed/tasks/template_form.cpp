// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/template_form.h"

#include "core/base/units.h"
#include "ui/views/number_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <numbers>

namespace odo {
namespace {

constexpr double mostMm = 100'000, degree = std::numbers::pi / 180;
constexpr TaskTemplate kinds[] = {TaskTemplate::StraightLine, TaskTemplate::Circle, TaskTemplate::FigureEight,
                                  TaskTemplate::Slalom, TaskTemplate::Free};

} // namespace

QString templateName(TaskTemplate kind)
{
    switch (kind) {
    case TaskTemplate::StraightLine:
        return TemplateForm::tr("Straight line");
    case TaskTemplate::Circle:
        return TemplateForm::tr("Circle");
    case TaskTemplate::FigureEight:
        return TemplateForm::tr("Figure eight");
    case TaskTemplate::Slalom:
        return TemplateForm::tr("Slalom");
    case TaskTemplate::Free:
        break;
    }
    return TemplateForm::tr("Free");
}

TemplateForm::TemplateForm(QWidget *parent)
    : QWidget(parent), m_form(new QFormLayout(this)), m_kind(new QComboBox), m_direction(new NumberBox), m_poles(new QSpinBox)
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(5);
    for (const TaskTemplate kind : kinds)
        m_kind->addItem(templateName(kind), static_cast<int>(kind));
    m_form->addRow(tr("Te&mplate"), m_kind);
    m_x = addLength(tr("Centre &x"));
    m_y = addLength(tr("Centre &y"));
    for (QDoubleSpinBox *place : {m_x, m_y})
        place->setMinimum(-mostMm);
    m_length = addLength(tr("&Length"));
    m_width = addLength(tr("&Width"));
    m_direction->setRange(-360, 360);
    m_direction->setDecimals(0);
    m_direction->setSuffix(QStringLiteral("°"));
    m_direction->setToolTip(tr("The way it is driven: 0° along X, 90° along Y"));
    m_form->addRow(tr("&Direction"), m_direction);
    m_poles->setRange(1, 100);
    m_form->addRow(tr("&Poles"), m_poles);
    m_gate = addLength(tr("&Gates' width"));
    showSizes();
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        showSizes();
        Q_EMIT changed();
    });
    connect(m_direction, &QDoubleSpinBox::valueChanged, this, &TemplateForm::changed);
    connect(m_poles, &QSpinBox::valueChanged, this, &TemplateForm::changed);
}

QDoubleSpinBox *TemplateForm::addLength(const QString &words)
{
    auto *length = new NumberBox;
    length->setRange(1, mostMm);
    length->setDecimals(0);
    length->setSingleStep(50);
    length->setSuffix(tr(" mm"));
    m_form->addRow(words, length);
    connect(length, &QDoubleSpinBox::valueChanged, this, &TemplateForm::changed);
    return length;
}

void TemplateForm::showSizes()
{
    const TaskTemplate kind = this->kind();
    const bool isRound = kind == TaskTemplate::Circle || kind == TaskTemplate::FigureEight;
    m_form->setRowVisible(m_width, kind == TaskTemplate::FigureEight || kind == TaskTemplate::Slalom);
    m_form->setRowVisible(m_direction, !isRound);
    m_form->setRowVisible(m_poles, kind == TaskTemplate::Slalom);
    const auto call = [this](QWidget *field, const QString &words) {
        qobject_cast<QLabel *>(m_form->labelForField(field))->setText(words);
    };
    call(m_length, kind == TaskTemplate::Circle        ? tr("Diam&eter")
                   : kind == TaskTemplate::FigureEight ? tr("&Width")
                   : kind == TaskTemplate::Free        ? tr("Start to finis&h")
                                                       : tr("&Length"));
    call(m_width, kind == TaskTemplate::FigureEight ? tr("&Height") : tr("S&wing, side to side"));
}

void TemplateForm::setTemplate(TaskTemplate kind, const TemplateSizes &sizes)
{
    const QSignalBlocker quiet(this);
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(kind)));
    m_x->setValue(toMillimetres(sizes.centre.x()));
    m_y->setValue(toMillimetres(sizes.centre.y()));
    m_length->setValue(toMillimetres(sizes.lengthM));
    m_width->setValue(toMillimetres(sizes.widthM));
    m_direction->setValue(sizes.directionRad / degree);
    m_poles->setValue(sizes.poles);
    m_gate->setValue(toMillimetres(sizes.gateM));
    showSizes();
}

TaskTemplate TemplateForm::kind() const
{
    return static_cast<TaskTemplate>(m_kind->currentData().toInt());
}

TemplateSizes TemplateForm::sizes() const
{
    TemplateSizes sizes;
    sizes.centre = {fromMillimetres(m_x->value()), fromMillimetres(m_y->value())};
    sizes.lengthM = fromMillimetres(m_length->value());
    sizes.widthM = fromMillimetres(m_width->value());
    sizes.directionRad = m_direction->value() * degree;
    sizes.poles = m_poles->value();
    sizes.gateM = fromMillimetres(m_gate->value());
    return sizes;
}

} // namespace odo
