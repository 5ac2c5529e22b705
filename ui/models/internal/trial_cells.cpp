// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of the list of trials: what they show, and what is changed in them.
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_model.h"
#include "ui/models/verdict_mark.h"

#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <chrono>

namespace odo {

namespace {

QDateTime localDateOf(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count());
}

QString joinedNames(const std::vector<std::string> &names)
{
    QStringList list;
    for (const std::string &name : names)
        list += QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
}

} // namespace

std::vector<std::string> tagsOf(const QString &written)
{
    std::vector<std::string> tags;
    for (const QString &tag : written.split(u','))
        if (!tag.trimmed().isEmpty())
            tags.push_back(tag.trimmed().toStdString());
    return tags;
}

QString TrialModel::display(const TrialRow &row, int column) const
{
    switch (column) {
    case NameColumn:
        return QString::fromStdString(row.trial.name);
    case TeamColumn:
        return shownTeam(row.trial);
    case ClassColumn:
        return QString::fromStdString(row.trial.className);
    case TaskColumn:
        return QString::fromStdString(row.trial.task);
    case DateColumn:
        return QLocale().toString(localDateOf(row.trial.date), QLocale::ShortFormat);
    case RobotsColumn:
        return joinedNames(row.trial.robotNames);
    case DurationColumn:
        return secondsText(fromSeconds(row.trial.durationS));
    case TopSpeedColumn:
        return row.topSpeed ? metricNumber(*row.topSpeed).text() : tr("not tracked");
    case ScoreColumn:
        return row.score ? scoreText(*row.score) : row.isScored ? tr("reanalyse") : QString();
    case TagsColumn:
        return joinedNames(row.trial.tags);
    case VerdictColumn:
        return row.verdict ? verdictBadge(*row.verdict).text : QString();
    case NotesColumn:
        return QString::fromStdString(row.trial.notes).simplified();
    default:
        break;
    }
    if (column < ColumnCount)
        return {};
    const auto value = row.trial.variables.find(m_variables.at(column - ColumnCount).toStdString());
    return value == row.trial.variables.end() ? QString() : QString::fromStdString(value->second);
}

QVariant TrialModel::editedValue(const TrialRow &row, int column) const
{
    return column == DateColumn ? QVariant(localDateOf(row.trial.date)) : QVariant(display(row, column));
}

bool TrialModel::isEditable(const TrialRow &row, int column) const
{
    switch (column) {
    case NameColumn:
    case TeamColumn:
    case ClassColumn:
    case TaskColumn:
    case DateColumn:
    case TagsColumn:
        return m_editable;
    case NotesColumn: // a cell is one line
        return m_editable && row.trial.notes.find('\n') == std::string::npos;
    default:
        return m_editable && column >= ColumnCount;
    }
}

QString TrialModel::toolTip(const TrialRow &row, int column) const
{
    if (column == TagsColumn && m_editable)
        return tr("Tags, separated by commas: double-click or F2 changes them");
    if (column == VerdictColumn && row.verdict) // a tool tip guesses at rich text
        return verdictText(*row.verdict).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
    if (column == ScoreColumn && row.score)
        return scoreLines(*row.score).join(u'\n').toHtmlEscaped();
    if (column == StarColumn)
        return tr("Star (Ctrl+D)");
    if (column == NotesColumn)
        return QString::fromStdString(row.trial.notes).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
    return display(row, column).toHtmlEscaped();
}

QVariant TrialModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const TrialRow &row = this->row(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::EditRole:
        return isEditable(row, column) ? editedValue(row, column) : QVariant();
    case Qt::CheckStateRole:
        return column == StarColumn
                   ? QVariant(static_cast<int>(row.trial.starred ? Qt::Checked : Qt::Unchecked))
                   : QVariant();
    case Qt::AccessibleTextRole:
        return column == StarColumn ? QVariant(row.trial.starred ? tr("starred") : tr("not starred"))
                                    : QVariant();
    case Qt::ToolTipRole:
        return toolTip(row, column);
    case Qt::TextAlignmentRole: {
        const bool number = column == DurationColumn || column == TopSpeedColumn || column == ScoreColumn;
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft)));
    }
    case BadgeTextRole:
        return column == VerdictColumn && row.verdict && row.verdict->level() != CheckLevel::Pass
                   ? QVariant(display(row, column))
                   : QVariant();
    case BadgeStateRole:
        return row.verdict ? QVariant(static_cast<int>(verdictBadge(*row.verdict).state)) : QVariant();
    case NameRole:
        return display(row, NameColumn);
    case IdRole:
        return QVariant::fromValue(qint64(row.trial.id));
    default:
        return {};
    }
}

bool TrialModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!m_editable || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const RecordId id = row(index.row()).trial.id;
    if (index.column() == StarColumn && role == Qt::CheckStateRole) {
        Q_EMIT starWanted(id, value.toInt() == Qt::Checked);
        return true;
    }
    const TrialRow &edited = row(index.row());
    if (role != Qt::EditRole || !isEditable(edited, index.column()) ||
        value == editedValue(edited, index.column()))
        return false;
    Q_EMIT editWanted(id, editOf(index.column(), value));
    return true;
}

TrialEdit TrialModel::editOf(int column, const QVariant &value) const
{
    const std::string text = value.toString().trimmed().toStdString();
    TrialEdit edit;
    switch (column) {
    case NameColumn:
        edit.name = text;
        break;
    case TeamColumn:
        edit.team = teamShownBy(value.toString());
        break;
    case ClassColumn:
        edit.className = text;
        break;
    case TaskColumn:
        edit.task = text;
        break;
    case DateColumn:
        edit.date = Instant(std::chrono::milliseconds(value.toDateTime().toMSecsSinceEpoch()));
        break;
    case NotesColumn:
        edit.notes = text;
        break;
    case TagsColumn:
        edit.tags = tagsOf(value.toString());
        break;
    default:
        edit.variables[m_variables.at(column - ColumnCount).toStdString()] =
            storedValue(value.toString()).toStdString();
    }
    return edit;
}

Qt::ItemFlags TrialModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (m_editable && index.column() == StarColumn)
        flags |= Qt::ItemIsUserCheckable;
    if (index.isValid() && isEditable(row(index.row()), index.column()))
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant TrialModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && section == StarColumn &&
        (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole))
        return tr("Star");
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case NameColumn:
        return tr("Trial");
    case TeamColumn:
        return tr("Team");
    case ClassColumn:
        return tr("Class");
    case TaskColumn:
        return tr("Task");
    case DateColumn:
        return tr("Date");
    case RobotsColumn:
        return tr("Robots");
    case DurationColumn:
        return tr("Time");
    case TopSpeedColumn:
        return tr("Top speed");
    case StarColumn:
        return QStringLiteral("★"); // the word is wider than the stars
    case ScoreColumn:
        return tr("Score");
    case VerdictColumn:
        return tr("Verdict");
    case TagsColumn:
        return tr("Tags");
    case NotesColumn:
        return tr("Notes");
    default:
        return m_variables.value(section - ColumnCount);
    }
}

} // namespace odo
