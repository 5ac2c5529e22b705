// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <QStringList>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QRadioButton;

namespace odo {

/// First page of the lens wizard: which camera, which board, and where its pictures come from.
class LensSourcePage : public QWidget
{
    Q_OBJECT
public:
    LensSourcePage(const QStringList &cameras, const QString &current, const std::vector<CameraDescription> &live,
                   QWidget *parent = nullptr);

    QString camera() const;
    double squareM() const;
    bool isLive() const;
    QString liveUri() const; ///< of the camera that is to be watched
    QStringList files() const;
    void addFiles(const QStringList &files);
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    QWidget *makeFiles();
    void updateChoices();

    QComboBox *m_camera, *m_live;
    QDoubleSpinBox *m_square;
    QRadioButton *m_fromLive, *m_fromFiles;
    QListWidget *m_files;
    QWidget *m_fileBox;
};

} // namespace odo
