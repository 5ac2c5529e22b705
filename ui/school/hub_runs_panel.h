// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/hub_results.h"
#include "ui/models/background_task.h"

#include <QWidget>
#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;
class QTimer;

namespace odo {

class Card;
class HubRunsModel;

/// The runs of all benches at the school's hub, the newest first, searched by text and chosen by bench. Asks
/// on a thread of its own whenever it is shown, a page at a time, and never waits. GUI thread.
class HubRunsPanel : public QWidget
{
    Q_OBJECT
public:
    explicit HubRunsPanel(QWidget *parent = nullptr);
    ~HubRunsPanel() override;

    /// Whose runs it shows while it is visible, with the password if one was entered; nullopt: none.
    void setHub(const std::optional<HubAddress> &hub);
    /// Nothing is being asked.
    bool isSettled() const { return !m_task->isRunning(); }

Q_SIGNALS:
    void settled();

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Answer;
    void askFirst();
    void askMore();
    void ask(bool isFirst);
    void offerBenches(const std::vector<std::string> &benches);
    void fit();
    void take(const std::optional<Error> &error);

    std::optional<HubAddress> m_hub;
    HubRunsModel *m_model;
    Card *m_card;
    QLineEdit *m_search;
    QComboBox *m_bench;
    QLabel *m_problem;
    QTableView *m_table;
    QTimer *m_typing;
    bool m_isNextFirst = false;            ///< asked again while an answer was awaited
    std::shared_ptr<HubResults> m_results; ///< null: to be connected
    std::shared_ptr<Answer> m_answer;
    std::unique_ptr<BackgroundTask> m_task; ///< last, so that it ends first
};

} // namespace odo
