// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/camera_uri.h"

#include <QDialog>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace odo {

/// How a USB or network camera is to be set: what else stands behind the '?' of its address, see
/// docs/cameras.md. What is not asked for here, and was in the address, stays there.
class CameraWishesDialog : public QDialog
{
    Q_OBJECT
public:
    /// uri: the camera's address with what is wanted of it by now. Only for addresses that take wishes.
    CameraWishesDialog(const CameraDescription &device, const std::string &uri, QWidget *parent = nullptr);
    /// With what is wanted now.
    std::string uri() const;

private:
    void addPicture(const CameraDescription &device);
    void showWishes(std::vector<CameraWish> wishes);

    const std::string m_uri;
    const bool m_onNetwork;
    std::vector<CameraWish> m_others; ///< that are not asked for here
    QComboBox *m_picture;
    QDoubleSpinBox *m_rate, *m_exposure;
    QCheckBox *m_trigger;
};

} // namespace odo
