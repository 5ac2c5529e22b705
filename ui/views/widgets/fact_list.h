// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/explanation.h"
#include "ui/models/number_text.h"
#include "ui/models/trial_scene.h"
#include "ui/views/widgets/card.h"

#include <QList>
#include <QString>
#include <QWidget>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QScrollArea;
class QWidget;

namespace odo {

/// Shows how a number was computed, to be read beside it and copied. Not modal; deletes itself.
void showExplanation(QWidget *parent, const Explanation &explanation);

/// The words of what opens it.
QString howComputedWords();

/// What is known of a thing: a name, a value in words, perhaps a badge behind it.
struct Fact
{
    QString name;
    QString value;
    Badge badge;
    std::optional<Explanation> how = {}; ///< a button shows it
    QString action = {}; ///< words of a button below the badge, where badges are beneath; empty: none
};

/// Facts beneath one another, names on the left, values wrapping on the right, optionally a button that
/// explains how it was computed. Plain text.
class FactList : public QWidget
{
    Q_OBJECT
public:
    /// Beside the words, badges form a column to read at a glance; in a narrow list they would leave the
    /// words too little space.
    enum class Badges { Beside, Beneath };
    explicit FactList(Badges badges = Badges::Beside);
    void setFacts(const QList<Fact> &facts);

Q_SIGNALS:
    /// The button of a fact was pressed.
    void actionRequested();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fitNames();
    QWidget *withBadgeBeneath(QLabel *value, const Fact &fact);
    void addRow(int row, const Fact &fact);
    const Badges m_badges;
    int m_widestName = 0;
    QGridLayout *m_layout;
};

/// A frameless scroll area for a card, with the facts at its top.
QScrollArea *scrolled(FactList *facts, const QString &accessibleName);

struct NamedMetric
{
    QString name;
    NumberText number;
};

/// Large metrics in two columns, divided by thin lines: name above, value large, unit and ± small beside it.
/// If they can be chosen (setChoosable), a click on one does, or the arrow keys and Enter.
class MetricGrid : public QWidget
{
    Q_OBJECT
public:
    explicit MetricGrid(QWidget *parent = nullptr);
    void setMetrics(std::vector<NamedMetric> metrics);
    /// toolTip: what choosing a metric does.
    void setChoosable(const QString &toolTip);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void chosen(std::size_t index);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    int rowCount() const;
    int rowHeight() const;
    QFont valueFont() const;
    QFont fittingFont(const QString &text, int width) const;
    void paintMetric(QPainter &painter, const NamedMetric &metric, const QRect &cell) const;

    QRect cellOf(std::size_t index) const;
    bool wants(const QKeyEvent &event) const;

    std::vector<NamedMetric> m_metrics;
    std::size_t m_current = 0; ///< that Enter chooses
    bool m_isChoosable = false;
};

class MetricGrid;

/// The metrics of one robot's run, two in a row, each with its unit and ±. Choosing one explains how it was
/// computed.
class ResultPanel : public Card
{
    Q_OBJECT
public:
    explicit ResultPanel(QWidget *parent = nullptr);
    void setScene(TrialScenePtr scene);

private:
    void showRobot(int robot);

    TrialScenePtr m_scene;
    std::size_t m_robot = 0;
    std::optional<Score> m_score; ///< before the others
    std::vector<Metric> m_shown;
    MetricGrid *m_grid;
    QComboBox *m_robots; ///< shown for more than one robot
};

} // namespace odo
