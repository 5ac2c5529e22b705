// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QRadioButton;

namespace odo {

class LiveCameraBox;
class LiveCameras;

/// First page of the lens wizard: which camera, which board, and where its pictures come from.
class LensSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    LensSourcePage(const QStringList &cameras, const QString &current, const LiveCameras &live,
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

    QComboBox *m_camera;
    LiveCameraBox *m_live;
    QDoubleSpinBox *m_square;
    QRadioButton *m_fromLive, *m_fromFiles;
    QListWidget *m_files;
    QWidget *m_fileBox;
};

} // namespace odo
