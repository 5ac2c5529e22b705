// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/explanation.h"
#include "ui/models/figure_text.h"

#include <QList>
#include <QString>
#include <QWidget>

class QGridLayout;
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
};

/// Facts beneath one another, names on the left, values wrapping on the right, perhaps a button that tells
/// how it was computed. Plain text.
class FactList : public QWidget
{
    Q_OBJECT
public:
    /// Beside the words badges make a column that is seen at a glance; in a narrow list they would leave the
    /// words too little room.
    enum class Badges { Beside, Beneath };
    explicit FactList(Badges badges = Badges::Beside);
    void setFacts(const QList<Fact> &facts);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void addRow(int row, const Fact &fact);
    const Badges m_badges;
    QGridLayout *m_layout;
};

/// A frameless scroll area for a card, with the facts at its top.
QScrollArea *scrolled(FactList *facts, const QString &accessibleName);

} // namespace odo
