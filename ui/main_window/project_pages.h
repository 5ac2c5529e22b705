// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>
#include <QStringList>
#include <array>
#include <set>
#include <string>

class QStackedWidget;
class QWidget;

namespace odo {

class ComparePage;
class HistoryPage;
class Project;
class RecordPage;
class ReviewPage;
class TestbedPage;
class Workspace;

/// The pages of the open project, one a mode: tells each what another one changed, and lets it read the
/// project only while it is seen. A page that is hidden is stale after a change, and reads when it is shown.
/// Lives as long as the project is open. GUI thread.
class ProjectPages : public QObject
{
    Q_OBJECT
public:
    enum class Mode { Testbed, Record, Review, Compare, History };

    /// Adds the pages to the stack; they leave it with this object. None is shown or read yet.
    ProjectPages(Workspace &workspace, QStackedWidget &stack, QObject *parent = nullptr);
    ~ProjectPages() override;

    TestbedPage &testbed() const { return *m_testbed; }
    RecordPage &record() const { return *m_record; }
    ReviewPage &review() const { return *m_review; }
    ComparePage &compare() const { return *m_compare; }
    HistoryPage &history() const { return *m_history; }

    void show(Mode mode);
    Mode mode() const { return m_mode; } ///< that was shown last
    /// As MainWindow's.
    Result<void> showTrial(const std::string &name);
    Result<void> compareTrials(const QStringList &names);
    /// After a change of the project.
    void refresh() { refreshAllBut(nullptr); }
    /// Everything that belongs to the page on screen is there, or cannot be had.
    bool isSettled() const;
    void saveLayouts() const;

Q_SIGNALS:
    void shown(odo::ProjectPages::Mode mode);
    void changed(); ///< by one of the pages
    void told(const QString &words);
    void failed(const odo::Error &error);
    void settled();

private:
    void connectTestbed();
    void connectRecord();
    void connectReview();
    void connectCompare();
    void connectHistory();
    void tell(const QString &words);
    void openTrial(const QString &trial);
    void refreshAllBut(const QWidget *page);
    void read(QWidget *page);
    void passOnSettled();

    Workspace &m_workspace;
    QStackedWidget &m_stack;
    TestbedPage *m_testbed;
    RecordPage *m_record;
    ReviewPage *m_review;
    ComparePage *m_compare;
    HistoryPage *m_history;
    std::array<QWidget *, 5> m_pages; ///< in the order of the modes
    Mode m_mode = Mode::Review;
    std::set<QWidget *> m_stale;
};

} // namespace odo
