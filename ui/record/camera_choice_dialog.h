// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/camera_choice.h"

#include <QDialog>
#include <map>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace odo {

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
    void askWishes(std::size_t camera);
    std::string uriOf(std::size_t camera) const;

    LiveCameras &m_connected;
    std::vector<ChosenCamera> m_cameras;
    std::vector<QComboBox *> m_boxes; ///< addresses without what is wanted
    std::vector<QPushButton *> m_settings;
    std::map<std::string, std::string> m_wanted; ///< by such an address: the whole one
    QLabel *m_words;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
