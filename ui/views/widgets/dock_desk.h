// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QMainWindow>
#include <QPointer>
#include <vector>

class QAction;
class QDockWidget;
class QSplitter;

namespace odo {

/// The part of a mode that the user can arrange: images and the map side by side, the charts in docks around
/// them, which can be moved, floated and hidden. The arrangement is read from the settings when first shown,
/// and written there by saveLayout.
class DockDesk : public QMainWindow
{
    Q_OBJECT
public:
    /// mode: by which the settings know it ("review").
    explicit DockDesk(const QString &mode, QWidget *parent = nullptr);

    /// One a dock: shows and hides it.
    QList<QAction *> dockActions() const;
    void resetLayout();
    void saveLayout() const;
    /// One of those in the middle takes the whole desk; called again, all is as before. Later calls for
    /// another one only give that back.
    void toggleEnlarged(QWidget *pane);
    /// It takes what is left: what is beside it comes first.
    QSize sizeHint() const override { return minimumSizeHint(); }

protected:
    /// What is side by side in the middle.
    QSplitter &middle() const { return *m_images; }
    /// All is as before one was enlarged.
    void endEnlarging();
    /// Of each of so many images: together they leave the map its place in a window of 1024 pixels.
    static int leastViewWidth(std::size_t views);
    /// Widths as they are at first: all images alike, the map, which is the last, a little narrower.
    void equaliseViews();
    /// Below those before it. name: for the arrangement that is kept; percent: of the desk's height, at
    /// first.
    void addDock(QWidget *content, const QString &name, const QString &title, int percent);
    /// In one place with the last of those added before, a tab of it; hidden until a person wants it.
    void addHiddenDock(QWidget *content, const QString &name, const QString &title);

    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Dock
    {
        QDockWidget *widget;
        int percent;
        bool isHidden = false; ///< at first
    };
    void restoreLayout();

    const QString m_mode;
    QSplitter *m_images;
    std::vector<Dock> m_docks;
    bool m_restored = false;
    bool m_isEnlarged = false;                 ///< one pane is alone in the middle
    QList<QPointer<QWidget>> m_hidden;         ///< for that
    QByteArray m_layoutBefore, m_imagesBefore; ///< what comes back after it
};

} // namespace odo
