// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/models/trial_scene.h"
#include "ui/views/widgets/card.h"

#include <functional>
#include <memory>
#include <vector>

namespace odo {

/// What a panel shows of one view or one robot. Both are made on the GUI thread.
struct Figure
{
    std::function<QString()> words;
    std::function<QWidget *()> plot = {}; ///< empty: there is none
};

/// Words and a plot for each view or robot of a trial, one below the other. Computed while it is visible, on
/// a thread of its own.
class FigurePanel : public Card
{
    Q_OBJECT
public:
    void setScene(TrialScenePtr scene);
    bool isSettled() const { return !m_task.isRunning() && !(m_isStale && isVisible()); }

Q_SIGNALS:
    void settled();

protected:
    /// On the panel's thread.
    using Compute = std::function<std::vector<Figure>(const TrialScene &)>;
    /// name: for screen readers. none: what is said where there is no figure.
    FigurePanel(const QString &title, const QString &name, const QString &none, Compute compute,
                QWidget *parent);
    void showEvent(QShowEvent *event) override;

private:
    void begin();
    void finish();
    void showFigures();

    const QString m_none;
    const Compute m_compute;
    TrialScenePtr m_scene;
    bool m_isStale = false; ///< what is shown is not of the scene
    std::shared_ptr<std::vector<Figure>> m_made;
    QWidget *m_body;
    BackgroundTask m_task;
};

} // namespace odo
