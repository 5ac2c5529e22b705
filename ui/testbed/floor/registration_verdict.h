// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "ui/views/card.h"

class QLabel;

namespace odo {

/// Says where a camera stands by the registration in the making, or why that is not known and what to do. GUI
/// thread.
class RegistrationVerdict : public Card
{
    Q_OBJECT
public:
    explicit RegistrationVerdict(QWidget *parent = nullptr);
    void tell(const FloorRegistration &registration);
    void tell(const QString &verdict, const QString &advice);
    /// It could not be stored; the verdict stays.
    void tellNotSaved(const Error &error);

private:
    QLabel *m_verdict, *m_advice;
};

} // namespace odo
