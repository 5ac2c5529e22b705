// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/internal/run_chooser.h"

#include "core/project/limits.h"
#include "ui/models/shown_names.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

namespace odo {

namespace {

constexpr int automatic = -1;
constexpr int mostOffered = 60; ///< of further runs, the newest: a longer menu serves nobody

QToolButton *flatButton(const QString &icon, const QString &name)
{
    auto *button = new QToolButton;
    button->setIcon(themeIcon(icon));
    button->setToolTip(name);
    button->setAccessibleName(name);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setProperty("flat", true);
    return button;
}

QComboBox *runList(const QString &name)
{
    auto *list = new QComboBox;
    list->setAccessibleName(name);
    list->setToolTip(name);
    list->setFocusPolicy(Qt::TabFocus); // as Review's list of trials
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(12);
    return list;
}

} // namespace

QString alignmentWords(AlignBy by)
{
    switch (by) {
    case AlignBy::StartGate:
        return RunChooser::tr("start gate");
    case AlignBy::MotionOnset:
        return RunChooser::tr("onset of motion");
    case AlignBy::Distance:
        return RunChooser::tr("distance");
    case AlignBy::ByHand:
        break;
    }
    return RunChooser::tr("by hand");
}

RunChooser::RunChooser(QWidget *parent)
    : QWidget(parent), m_first(runList(tr("First run"))), m_second(runList(tr("Second run"))),
      m_align(runList(tr("The moment that counts as the same"))),
      m_swap(flatButton(QStringLiteral("swap"), tr("Swap the two runs"))),
      m_more(flatButton(QStringLiteral("add"), tr("Further runs"))), m_menu(new QMenu(this)),
      m_shiftName(new QLabel(tr("&Shift"))), m_placeName(new QLabel(tr("Pla&ce"))), m_shift(new NumberBox),
      m_place(new NumberBox)
{
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setMenu(m_menu);
    m_align->addItem(tr("Automatic"), automatic);
    for (const AlignBy by : {AlignBy::StartGate, AlignBy::MotionOnset, AlignBy::Distance, AlignBy::ByHand}) {
        QString words = alignmentWords(by);
        words[0] = words[0].toUpper();
        m_align->addItem(words, static_cast<int>(by));
    }
    m_shift->setRange(-largestOffsetS, largestOffsetS);
    m_shift->setDecimals(3);
    m_shift->setSingleStep(0.01);
    m_shift->setSuffix(tr(" s"));
    m_shift->setKeyboardTracking(false);
    m_shift->setAccessibleName(tr("How much later the second run's moment lies"));
    m_shift->setToolTip(m_shift->accessibleName());
    m_shiftName->setBuddy(m_shift);
    m_place->setRange(0, 10000);
    m_place->setDecimals(2);
    m_place->setSingleStep(0.1);
    m_place->setSuffix(tr(" m"));
    m_place->setSpecialValueText(tr("where all have begun"));
    m_place->setKeyboardTracking(false);
    m_place->setAccessibleName(tr("How far along the way the runs are taken to be at the same time"));
    m_place->setToolTip(m_place->accessibleName());
    m_placeName->setBuddy(m_place);
    const auto named = [](const QString &text, QWidget *buddy) {
        auto *label = new QLabel(text);
        label->setBuddy(buddy);
        return label;
    };
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(10, 8, 10, 10);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    grid->addWidget(named(tr("F&irst"), m_first), 0, 0);
    grid->addWidget(m_first, 0, 1);
    grid->addWidget(m_swap, 0, 2);
    grid->addWidget(named(tr("Seco&nd"), m_second), 1, 0);
    grid->addWidget(m_second, 1, 1);
    grid->addWidget(m_more, 1, 2);
    grid->addWidget(named(tr("&Align by"), m_align), 2, 0);
    grid->addWidget(m_align, 2, 1, 1, 2);
    grid->addWidget(m_shiftName, 3, 0);
    grid->addWidget(m_shift, 3, 1, 1, 2);
    grid->addWidget(m_placeName, 4, 0);
    grid->addWidget(m_place, 4, 1, 1, 2);
    showShift();

    for (QComboBox *list : {m_first, m_second})
        connect(list, &QComboBox::activated, this, &RunChooser::runsChanged);
    connect(m_swap, &QToolButton::clicked, this, &RunChooser::swap);
    connect(m_menu, &QMenu::aboutToShow, this, &RunChooser::fillMenu);
    connect(m_align, &QComboBox::activated, this, [this] {
        showShift();
        Q_EMIT alignmentChanged();
    });
    for (QDoubleSpinBox *number : {m_shift, m_place})
        connect(number, &QDoubleSpinBox::valueChanged, this, &RunChooser::alignmentChanged);
}

void RunChooser::setChoices(QList<RunChoice> choices)
{
    const std::vector<CompareSettings::Run> before = runs();
    m_choices = std::move(choices);
    QStringList words;
    words.reserve(m_choices.size());
    for (const RunChoice &choice : std::as_const(m_choices))
        words << choice.words;
    for (QComboBox *list : {m_first, m_second}) {
        const QSignalBlocker quiet(list);
        list->setModel(new NameListModel(words, words, list)); // the one before goes with it
    }
    setRuns(before);
}

void RunChooser::setRuns(const std::vector<CompareSettings::Run> &wanted)
{
    QList<int> indices = placesOf(m_choices, wanted);
    m_first->setCurrentIndex(indices.isEmpty() ? -1 : indices.takeFirst());
    m_second->setCurrentIndex(indices.isEmpty() ? -1 : indices.takeFirst());
    m_further = indices;
}

std::vector<CompareSettings::Run> RunChooser::runs() const
{
    std::vector<CompareSettings::Run> chosen;
    for (const QComboBox *list : {m_first, m_second})
        if (list->currentIndex() >= 0 && list->currentIndex() < m_choices.size())
            chosen.push_back(m_choices[list->currentIndex()].run);
    for (const int choice : m_further)
        if (choice != m_first->currentIndex() && choice != m_second->currentIndex())
            chosen.push_back(m_choices[choice].run);
    return chosen;
}

std::optional<AlignBy> RunChooser::alignBy() const
{
    const int by = m_align->currentData().toInt();
    return by == automatic ? std::nullopt : std::optional(static_cast<AlignBy>(by));
}

double RunChooser::shiftS() const
{
    return m_shift->value();
}

std::optional<double> RunChooser::placeM() const
{
    return m_place->value() > 0 ? std::optional(m_place->value()) : std::nullopt;
}

void RunChooser::alignAutomatically()
{
    const QSignalBlocker quiet(m_shift), alsoQuiet(m_place);
    m_align->setCurrentIndex(0);
    m_shift->setValue(0);
    m_place->setValue(0);
    showShift();
}

void RunChooser::setAlignedBy(AlignBy by)
{
    m_align->setItemText(0, tr("Automatic: %1").arg(alignmentWords(by)));
}

void RunChooser::swap()
{
    const int first = m_first->currentIndex();
    m_first->setCurrentIndex(m_second->currentIndex());
    m_second->setCurrentIndex(first);
    Q_EMIT runsChanged();
}

void RunChooser::toggleFurther(int choice, bool isWanted)
{
    m_further.removeAll(choice);
    if (isWanted)
        m_further << choice;
    Q_EMIT runsChanged();
}

void RunChooser::fillMenu()
{
    m_menu->clear();
    const int oldest = std::max(0, static_cast<int>(m_choices.size()) - mostOffered);
    for (int i = 0; i < m_choices.size(); ++i) {
        if (i == m_first->currentIndex() || i == m_second->currentIndex())
            continue;
        if (i < oldest && !m_further.contains(i))
            continue;
        QAction *action = m_menu->addAction(m_choices[i].words);
        action->setCheckable(true);
        action->setChecked(m_further.contains(i));
        connect(action, &QAction::toggled, this, [this, i](bool on) { toggleFurther(i, on); });
    }
    if (m_menu->isEmpty())
        m_menu->addAction(tr("There are no further runs"))->setEnabled(false);
}

void RunChooser::showShift()
{
    const bool byHand = alignBy() == AlignBy::ByHand;
    m_shift->setVisible(byHand);
    m_shiftName->setVisible(byHand);
    const bool byPlace = alignBy() == AlignBy::Distance;
    m_place->setVisible(byPlace);
    m_placeName->setVisible(byPlace);
}

} // namespace odo
