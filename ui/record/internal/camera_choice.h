// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/project/records.h"

#include <QDialog>
#include <map>
#include <string>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace odo {

/// A camera of the project and the address of the device that it is; empty: it is not used.
using ChosenCamera = std::pair<std::string, std::string>;

/// Which device each camera of a project is: the one set in the project, or chosen before on this machine, if
/// it is connected and free, with its settings; else the real ones that are left, in their order. A simulated
/// one is proposed only where the project names it. A project without cameras gets "A", "B", ... for the real
/// ones that are connected, two at most.
std::vector<ChosenCamera> proposeCameras(const std::vector<CameraRecord> &cameras,
                                         const std::vector<CameraDescription> &connected,
                                         const std::map<std::string, std::string> &before);

/// Remembered on this machine, by the cameras' names.
std::map<std::string, std::string> rememberedCameras();
void rememberCameras(const std::vector<ChosenCamera> &cameras);

class LiveCameras;

/// Which connected device is which camera of the project.
class CameraChoiceDialog : public QDialog
{
    Q_OBJECT
public:
    /// connected must outlive it.
    CameraChoiceDialog(std::vector<ChosenCamera> cameras, LiveCameras &connected, QWidget *parent = nullptr);
    /// As chosen; those that are not used with an empty address.
    std::vector<ChosenCamera> cameras() const;

private:
    void fill();
    void check();
    void askSettings(std::size_t camera);
    std::string uriOf(std::size_t camera) const;

    LiveCameras &m_connected;
    std::vector<ChosenCamera> m_cameras;
    std::vector<QComboBox *> m_boxes; ///< addresses without settings
    std::vector<QPushButton *> m_settings;
    std::map<std::string, std::string> m_wanted; ///< by such an address: the whole one
    QLabel *m_words;
    QDialogButtonBox *m_buttons;
};

/// The settings of a USB or network camera: what follows the '?' in its address, see docs/cameras.md.
/// Settings of the address that the dialog does not show stay.
class CameraSettingsDialog : public QDialog
{
    Q_OBJECT
public:
    /// uri: the camera's address with its present settings. Only for addresses that accept settings.
    CameraSettingsDialog(const CameraDescription &device, const std::string &uri, QWidget *parent = nullptr);
    /// With the current settings.
    std::string uri() const;

private:
    void addFrameFormat(const CameraDescription &device);
    void showSettings(std::vector<CameraSetting> cameraSettings);

    const std::string m_uri;
    const bool m_onNetwork;
    std::vector<CameraSetting> m_others; ///< that are not asked for here
    QComboBox *m_frameFormat;
    QDoubleSpinBox *m_rate, *m_exposure;
    QCheckBox *m_trigger;
};

} // namespace odo
