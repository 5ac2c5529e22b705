// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/variable_table.h"

#include "core/project/names.h"
#include "ui/models/number_text.h"
#include "ui/views/widgets/table_list.h"

#include <QCompleter>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>
#include <set>

namespace odo {

namespace {

/// Of a value: the trials have several.
constexpr int severalRole = Qt::UserRole;

QString severalWord()
{
    return VariableTable::tr("several");
}

/// Completes names, and writes over "several" only what was typed.
class VariableDelegate : public QStyledItemDelegate
{
public:
    VariableDelegate(const QStringList &known, QObject *parent) : QStyledItemDelegate(parent), m_known(known)
    {
    }

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &,
                          const QModelIndex &index) const override
    {
        auto *line = new QLineEdit(parent);
        line->setFrame(false);
        line->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
        if (index.column() == VariableTable::NameColumn) {
            auto *completer = new QCompleter(m_known, line);
            completer->setCaseSensitivity(Qt::CaseInsensitive);
            line->setCompleter(completer);
        }
        return line;
    }
    void setEditorData(QWidget *editor, const QModelIndex &index) const override
    {
        auto *line = static_cast<QLineEdit *>(editor);
        const bool areSeveral = index.data(severalRole).toBool();
        line->setPlaceholderText(areSeveral ? severalWord() : QString());
        line->setText(areSeveral ? QString() : index.data(Qt::EditRole).toString());
    }
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override
    {
        const auto *line = static_cast<QLineEdit *>(editor);
        if (!line->isModified() && line->text() == index.data(Qt::EditRole).toString())
            return;
        if (index.data(severalRole).toBool() && !line->isModified())
            return;
        const QString text = line->text().trimmed(); // the line follows what is set
        model->setData(index, false, severalRole);
        model->setData(index, text, Qt::EditRole);
    }

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (!index.data(severalRole).toBool())
            return;
        option->text = severalWord();
        option->features |= QStyleOptionViewItem::HasDisplay;
        option->font.setItalic(true);
    }

private:
    const QStringList m_known;
};

/// Names of all, with the value that they share; null: they differ.
std::map<std::string, QString> sharedVariables(const std::vector<TrialRecord> &trials)
{
    std::map<std::string, QString> shared;
    for (const TrialRecord &trial : trials)
        for (const auto &[name, value] : trial.variables) {
            const bool isSame = std::ranges::all_of(trials, [&](const TrialRecord &other) {
                const auto found = other.variables.find(name);
                return found != other.variables.end() && found->second == value;
            });
            shared[name] = isSame ? QString::fromStdString(value) : QString();
        }
    return shared;
}

} // namespace

VariableTable::VariableTable(const std::vector<TrialRecord> &trials, const QStringList &known,
                             QWidget *parent)
    : QTableWidget(0, ColumnCount, parent), m_before(sharedVariables(trials))
{
    setHorizontalHeaderLabels({tr("Variable"), tr("Value")});
    setAccessibleName(tr("Variables of your own"));
    setToolTip(tr("What you want to compare runs by: surface, battery, attempt. Text or a number."));
    showAsList(*this);
    setSelectionBehavior(QAbstractItemView::SelectItems);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::SelectedClicked |
                    QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
    setItemDelegate(new VariableDelegate(known, this));
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setWordWrap(false);
    for (const auto &[name, value] : m_before)
        addRow(QString::fromStdString(name), value, value.isNull());
    keepEmptyRow();
    setCurrentCell(0, NameColumn);
    connect(this, &QTableWidget::itemChanged, this, &VariableTable::keepEmptyRow);
}

void VariableTable::addRow(const QString &name, const QString &value, bool areSeveral)
{
    const QSignalBlocker quiet(this);
    const int row = rowCount();
    insertRow(row);
    auto *nameItem = new QTableWidgetItem(name), *valueItem = new QTableWidgetItem(value);
    valueItem->setData(severalRole, areSeveral);
    if (areSeveral) // one name for values that are not known here
        nameItem->setFlags(nameItem->flags() & ~Qt::ItemIsEditable);
    for (QTableWidgetItem *item : {nameItem, valueItem})
        item->setToolTip(item->text().toHtmlEscaped());
    setItem(row, NameColumn, nameItem);
    setItem(row, ValueColumn, valueItem);
}

void VariableTable::keepEmptyRow()
{
    const int last = rowCount() - 1;
    if (last < 0 || !textAt(last, NameColumn).isEmpty() || !textAt(last, ValueColumn).isEmpty())
        addRow({}, {}, false);
}

QString VariableTable::textAt(int row, int column) const
{
    return item(row, column)->text().trimmed();
}

void VariableTable::storeEdited()
{
    if (QWidget *editor = indexWidget(currentIndex())) {
        commitData(editor);
        closeEditor(editor, QAbstractItemDelegate::NoHint);
    }
}

std::map<std::string, std::string> VariableTable::changes() const
{
    std::map<std::string, std::string> changes;
    std::set<std::string> kept;
    for (int row = 0; row < rowCount(); ++row) {
        const std::string name = normalName(textAt(row, NameColumn).toStdString());
        const QString value = storedValue(textAt(row, ValueColumn));
        if (name.empty() && value.isEmpty())
            continue;
        kept.insert(name);
        if (item(row, ValueColumn)->data(severalRole).toBool())
            continue;
        const auto before = m_before.find(name);
        if (before == m_before.end() ? !value.isEmpty() : before->second.isNull() || value != before->second)
            changes[name] = value.toStdString();
    }
    for (const auto &before : m_before)
        if (!kept.contains(before.first))
            changes[before.first] = {};
    return changes;
}

QString VariableTable::repeatedName() const
{
    std::set<std::string> names;
    for (int row = 0; row < rowCount(); ++row)
        if (const QString name = textAt(row, NameColumn);
            !name.isEmpty() && !names.insert(normalName(name.toStdString())).second)
            return name;
    return {};
}

void VariableTable::removeCurrent()
{
    if (currentRow() >= 0 && currentRow() < rowCount() - 1)
        removeRow(currentRow());
}

QSize VariableTable::sizeHint() const
{
    constexpr int fewest = 3, most = 6;
    const int rows = std::clamp(rowCount(), fewest, most);
    return {QTableWidget::sizeHint().width(), horizontalHeader()->sizeHint().height() +
                                                  rows * verticalHeader()->defaultSectionSize() +
                                                  2 * frameWidth()};
}

void VariableTable::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Delete && state() != EditingState)
        return removeCurrent();
    QTableWidget::keyPressEvent(event);
}

} // namespace odo
