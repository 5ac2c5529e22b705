// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/internal/planned_camera_form.h"

#include "core/base/units.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>

namespace odo {

namespace {

constexpr double farMm = 100'000;
const QSize sizes[] = {{640, 480}, {1280, 720}, {1920, 1080}, {3840, 2160}};

QHBoxLayout *beside(QWidget *one, QWidget *other)
{
    auto *row = new QHBoxLayout;
    row->addWidget(one, 1);
    row->addWidget(other, 1);
    return row;
}

} // namespace

PlannedCameraForm::PlannedCameraForm(QWidget *parent)
    : QWidget(parent), m_x(makeNumber(tr("Position x"), -farMm, farMm, 50, tr(" mm"))),
      m_y(makeNumber(tr("Position y"), -farMm, farMm, 50, tr(" mm"))),
      m_height(makeNumber(tr("Height of the camera"), 50, 20'000, 50, tr(" mm"))),
      m_aimX(makeNumber(tr("Looks at x"), -farMm, farMm, 50, tr(" mm"))),
      m_aimY(makeNumber(tr("Looks at y"), -farMm, farMm, 50, tr(" mm"))),
      m_direction(makeNumber(tr("Viewing direction"), -180, 180, 5, tr("°"))),
      m_angle(makeNumber(tr("Field of view"), 10, 150, 1, tr("°"))), m_size(new QComboBox)
{
    m_direction->setWrapping(true);
    m_direction->setToolTip(
        tr("0° is along X, 90° along Y; the point that the camera looks at turns with it"));
    m_angle->setToolTip(tr("Across the image width: a webcam has about 60° to 80°, a phone 65°"));
    for (const QSize &size : sizes)
        m_size->addItem(QStringLiteral("%1×%2").arg(size.width()).arg(size.height()), size);
    m_size->setAccessibleName(tr("Image size"));
    auto *form = new QFormLayout(this);
    form->setContentsMargins(12, 6, 12, 8);
    const auto row = [form](const QString &text, QWidget *first, auto *field) {
        auto *label = new QLabel(text);
        label->setBuddy(first);
        form->addRow(label, field);
    };
    row(tr("Po&sition x, y"), m_x, beside(m_x, m_y));
    row(tr("&Height"), m_height, m_height);
    row(tr("&Looks at x, y"), m_aimX, beside(m_aimX, m_aimY));
    row(tr("D&irection"), m_direction, m_direction);
    row(tr("&Field of view"), m_angle, beside(m_angle, m_size));
    connect(m_size, &QComboBox::currentIndexChanged, this, &PlannedCameraForm::read);
    setCamera({});
}

QDoubleSpinBox *PlannedCameraForm::makeNumber(const QString &name, double least, double most, double step,
                                              const QString &unit)
{
    auto *number = new NumberBox;
    number->setRange(least, most);
    number->setDecimals(0);
    number->setSingleStep(step);
    number->setSuffix(unit);
    number->setAccessibleName(name);
    number->setKeyboardTracking(false);
    connect(number, &QDoubleSpinBox::valueChanged, this, &PlannedCameraForm::read);
    return number;
}

void PlannedCameraForm::setCamera(const PlannedCamera &camera)
{
    m_camera = camera;
    const Eigen::Vector2d foot = camera.footM();
    double direction = camera.directionDegrees + 180; // from the camera, not to it
    direction -= 360 * std::round(direction / 360);
    const std::pair<QDoubleSpinBox *, double> values[] = {{m_x, toMillimetres(foot.x())},
                                                          {m_y, toMillimetres(foot.y())},
                                                          {m_height, toMillimetres(camera.heightM)},
                                                          {m_aimX, toMillimetres(camera.aimM.x())},
                                                          {m_aimY, toMillimetres(camera.aimM.y())},
                                                          {m_direction, direction},
                                                          {m_angle, camera.fieldOfViewDegrees}};
    for (const auto &[number, value] : values) {
        const QSignalBlocker quiet(number);
        number->setValue(value);
    }
    const QSignalBlocker quiet(m_size);
    m_size->setCurrentIndex(std::max(0, m_size->findData(QSize(camera.widthPx, camera.heightPx))));
}

void PlannedCameraForm::read()
{
    const Eigen::Vector2d foot = fromMillimetres(1) * Eigen::Vector2d(m_x->value(), m_y->value());
    m_camera.aimM = fromMillimetres(1) * Eigen::Vector2d(m_aimX->value(), m_aimY->value());
    if (sender() == m_direction) {
        const double angle = m_direction->value() * EIGEN_PI / 180;
        m_camera.aimM = foot + m_camera.distanceM * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    m_camera.moveCameraTo(foot);
    m_camera.heightM = fromMillimetres(m_height->value());
    m_camera.fieldOfViewDegrees = m_angle->value();
    const QSize size = m_size->currentData().toSize();
    m_camera.widthPx = size.width();
    m_camera.heightPx = size.height();
    setCamera(PlannedCamera(m_camera));
    Q_EMIT edited();
}

} // namespace odo
