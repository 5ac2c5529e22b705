// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/models/trial_scene.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QStackedWidget;
class QWidget;

namespace odo {

/// The modes of the window, in the order in which the mode bar shows them.
enum class WindowMode { Start, Testbed, Record, Review, Compare, History };

inline constexpr std::array allModes{WindowMode::Start,  WindowMode::Testbed, WindowMode::Record,
                                     WindowMode::Review, WindowMode::Compare, WindowMode::History};

/// "testbed": of its icon, its help, its command and the command line.
QString modeWord(WindowMode mode);
/// nullopt: no mode has that word.
std::optional<WindowMode> modeFromWord(const QString &word);
/// "Testbed", as a person reads it.
QString modeName(WindowMode mode);

class ComparePage;
class HistoryPage;
class Project;
class RecordPage;
class ReviewPage;
class StartPage;
class TestbedPage;
class Workspace;

/// The pages of the open project, one a mode: creates them one by one, notifies each of changes by the
/// others, and lets it read the project only while it is visible. A hidden page is stale after a change, and
/// reads when it is shown. Lives as long as the project is open. GUI thread.
class ProjectPages : public QObject
{
    Q_OBJECT
public:
    using Mode = WindowMode;

    /// The pages come to the stack, and leave it with this object.
    ProjectPages(Workspace &workspace, QStackedWidget &stack, QObject *parent = nullptr);
    ~ProjectPages() override;

    /// Makes the pages in the next turns of the event loop, one in each, for all at once would keep the
    /// window waiting: Review first, then the one that is shown unless another one is: Review, or Start as
    /// long as nothing is measured. A page that is asked for is made at once.
    void makeSoon() { m_maker.start(); }
    /// As makeSoon, at once.
    void makeAll();
    StartPage &start();
    TestbedPage &testbed();
    RecordPage &record();
    ReviewPage &review();
    bool isMade(Mode mode) const { return m_pages.at(static_cast<std::size_t>(mode)) != nullptr; }
    const ReviewPage &review() const { return *m_review; } ///< that was made
    ComparePage &compare();
    HistoryPage &history();

    void show(Mode mode);
    Mode mode() const { return m_mode; } ///< that was shown last
    /// As MainWindow's.
    Result<void> showTrial(const std::string &name);
    Result<void> compareTrials(const QStringList &names);
    /// After a change of the project.
    void refresh() { refreshAllBut(nullptr); }
    /// Everything that belongs to the page on screen is there, or cannot be had.
    bool isSettled() const;
    bool isRecording() const;
    /// What is being written (notes) is stored now.
    void saveNotes();
    void saveLayouts() const;
    /// What is being recorded is complete in the project when this returns.
    void finishRecording();
    /// What commands on trials mean: those selected in History while it is shown, else the one in Review.
    QStringList chosenTrials() const;
    /// The trial on screen in Review; null: none.
    TrialScenePtr scene() const;

Q_SIGNALS:
    void made(odo::WindowMode mode);
    void shown(odo::WindowMode mode);
    void changed(); ///< by one of the pages
    /// Something was done; the words contain the warnings.
    void messageReady(const QString &words, const std::vector<odo::Message> &warnings);
    void warned(const QString &words); ///< on the page itself, where it will go again
    void failed(const odo::Error &error);
    void settled();

private:
    void makeNext();
    QWidget *page(Mode mode);
    QWidget *make(Mode mode);
    QWidget *makeStart();
    QWidget *makeTestbed();
    QWidget *makeRecord();
    QWidget *makeReview();
    QWidget *makeCompare();
    QWidget *makeHistory();
    void showOutcome(const QString &words, const std::vector<Message> &warnings = {});
    void openTrial(const QString &trial);
    void refreshAllBut(const QWidget *page);
    void read(QWidget *page);
    void passOnSettled();

    Workspace &m_workspace;
    QStackedWidget &m_stack;
    StartPage *m_start = nullptr;
    TestbedPage *m_testbed = nullptr;
    RecordPage *m_record = nullptr;
    ReviewPage *m_review = nullptr;
    ComparePage *m_compare = nullptr;
    HistoryPage *m_history = nullptr;
    std::array<QWidget *, allModes.size()> m_pages{}; ///< in the order of the modes; null: not made yet
    std::set<QWidget *> m_stale;
    Mode m_mode = Mode::Review;
    bool m_isOneShown = false;
    QTimer m_maker;
};

} // namespace odo
