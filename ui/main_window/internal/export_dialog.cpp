// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/export_dialog.h"

#include "ui/main_window/preferences/command_keys.h"
#include "ui/models/number_text.h"
#include "ui/views/widgets/command_keys.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

namespace odo {

namespace {

const QString presetsKey = QStringLiteral("export/presets"), lastExportKey = QStringLiteral("export/last");
const QString formatKey = QStringLiteral("format"), columnsKeyWord = QStringLiteral("columns"),
              unitKey = QStringLiteral("unit"), axesKey = QStringLiteral("axes");
const QString pageWord = QStringLiteral("html");
enum Part { Counted, Whole, Selection };

struct FormatKind
{
    const char *word;
    ExportedFormat format;
    CsvStyle style;
};

constexpr std::array formatKinds{
    FormatKind{"csv", ExportedFormat::Csv, CsvStyle::Analysis},
    FormatKind{"csv-international", ExportedFormat::Csv, CsvStyle::International},
    FormatKind{"csv-continental", ExportedFormat::Csv, CsvStyle::Continental},
    FormatKind{"tracker", ExportedFormat::Tracker, CsvStyle::Analysis},
    FormatKind{"tum", ExportedFormat::Tum, CsvStyle::Analysis}};

/// nullptr: a page.
const FormatKind *formatKindOf(const QString &word)
{
    const auto *const found = std::ranges::find_if(
        formatKinds, [&word](const FormatKind &kind) { return word == QLatin1String(kind.word); });
    return found == formatKinds.end() ? nullptr : found;
}

void chooseData(QComboBox &choice, const QVariant &data)
{
    if (const int index = choice.findData(data); index >= 0)
        choice.setCurrentIndex(index);
}

} // namespace

ExportDialog::ExportDialog(const ExportOffer &offer, QWidget *parent)
    : QDialog(parent), m_selection(offer.selection), m_preset(new QComboBox),
      m_savePreset(plainButton(tr("&Keep as…"))), m_removePreset(plainButton(tr("Remo&ve"))),
      m_columns(new QListWidget), m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(offer.title);
    auto *form = new QFormLayout;
    auto *presetLabel = new QLabel(tr("&Preset"));
    presetLabel->setBuddy(m_preset);
    form->addRow(presetLabel, makePresets());
    m_robot = addChoice(*form, tr("&Robot"));
    m_robot->addItems(offer.robots);
    form->setRowVisible(m_robot, offer.robots.size() > 1);
    m_format = addChoice(*form, tr("&Format"));
    m_format->addItem(tr("CSV for programs (*.csv)"), QStringLiteral("csv"));
    m_format->addItem(tr("CSV for spreadsheets, 1.5 (*.csv)"), QStringLiteral("csv-international"));
    m_format->addItem(tr("CSV for spreadsheets, 1,5 (*.csv)"), QStringLiteral("csv-continental"));
    m_format->addItem(tr("Tracker text (*.txt)"), QStringLiteral("tracker"));
    m_format->addItem(tr("TUM trajectory (*.tum)"), QStringLiteral("tum"));
    if (offer.isOfOne)
        m_format->addItem(tr("Page to take along (*.html)"), pageWord);
    m_columns->setAccessibleName(tr("Columns"));
    for (const std::string &column : csvColumns()) {
        auto *item = new QListWidgetItem(QString::fromStdString(column), m_columns);
        item->setData(Qt::UserRole, item->text());
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(Qt::Checked);
    }
    constexpr int shownColumns = 6;
    m_columns->setMinimumHeight(shownColumns * m_columns->sizeHintForRow(0));
    auto *columnsLabel = new QLabel(tr("&Columns"));
    columnsLabel->setBuddy(m_columns);
    form->addRow(columnsLabel, m_columns);
    m_unit = addChoice(*form, tr("&Lengths in"));
    for (const char *unit : {"mm", "cm", "m", "in"})
        m_unit->addItem(QString::fromLatin1(unit), QString::fromLatin1(unit));
    m_axes = addChoice(*form, tr("&Axes"));
    m_axes->addItem(tr("Of the floor's markers"), QStringLiteral("floor"));
    m_axes->addItem(tr("From the start, X in its direction"), QStringLiteral("start"));
    m_part = addChoice(*form, tr("Par&t of the run"));
    offerPart(offer);
    m_buttons->addButton(offer.isOfOne ? tr("Choose a file…") : tr("Choose a folder…"),
                         QDialogButtonBox::AcceptRole);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::showFitting);
    connect(m_columns, &QListWidget::itemChanged, this, &ExportDialog::showFitting);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &ExportDialog::showColumnNames);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form, 1);
    layout->addWidget(m_buttons);
    setWords(QSettings().value(lastExportKey).toMap());
    offerPresets({});
    showFitting();
}

QComboBox *ExportDialog::addChoice(QFormLayout &form, const QString &label)
{
    auto *choice = new QComboBox;
    choice->setAccessibleName(plainWords(label));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(24);
    form.addRow(label, choice);
    return choice;
}

QLayout *ExportDialog::makePresets()
{
    m_preset->setAccessibleName(tr("Preset"));
    m_preset->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_preset->setMinimumContentsLength(20);
    auto *row = new QHBoxLayout;
    row->addWidget(m_preset, 1);
    row->addWidget(m_savePreset);
    row->addWidget(m_removePreset);
    connect(m_preset, &QComboBox::activated, this, [this] {
        const QString name = m_preset->currentData().toString();
        setWords(name.isEmpty() ? QSettings().value(lastExportKey).toMap()
                                : QSettings().value(presetsKey).toMap().value(name).toMap());
        m_removePreset->setEnabled(m_preset->currentIndex() > 0);
    });
    connect(m_savePreset, &QPushButton::clicked, this, &ExportDialog::savePreset);
    connect(m_removePreset, &QPushButton::clicked, this, &ExportDialog::removePreset);
    return row;
}

void ExportDialog::offerPart(const ExportOffer &offer)
{
    m_part->addItem(offer.hasRange  ? tr("Its range, which counts")
                    : offer.isOfOne ? tr("The whole run")
                                    : tr("What counts of each"),
                    Counted);
    if (offer.hasRange || !offer.isOfOne)
        m_part->addItem(tr("The whole run"), Whole);
    if (offer.selection)
        m_part->addItem(tr("The selection, %1 to %2")
                            .arg(secondsText(offer.selection->begin), secondsText(offer.selection->end)),
                        Selection);
}

QString ExportDialog::formatWord() const
{
    return m_format->currentData().toString();
}

bool ExportDialog::isPage() const
{
    return formatWord() == pageWord;
}

int ExportDialog::robot() const
{
    return std::max(0, m_robot->currentIndex());
}

TrackExport ExportDialog::settings() const
{
    TrackExport how;
    if (const FormatKind *kind = formatKindOf(formatWord())) {
        how.format = kind->format;
        how.style = kind->style;
    }
    for (int row = 0; row < m_columns->count(); ++row)
        if (m_columns->item(row)->checkState() == Qt::Checked)
            how.columns.push_back(static_cast<std::size_t>(row));
    how.unit = csvLengthFromWord(m_unit->currentData().toString().toStdString()).value_or(CsvLength());
    how.frame = trackFrameFromWord(m_axes->currentData().toString().toStdString()).value_or(TrackFrame());
    const int part = m_part->currentData().toInt();
    how.isWhole = part != Counted;
    if (part == Selection)
        how.span = m_selection;
    return how;
}

OutputFormat ExportDialog::output() const
{
    const QString filter = m_format->currentText();
    if (isPage())
        return {filter, pageWord, FileKind::Html, true};
    const FormatKind *kind = formatKindOf(formatWord());
    const QString ending = QString::fromLatin1(endingOf(kind->format)).mid(1);
    return {filter, ending,
            kind->format == ExportedFormat::Csv   ? FileKind::Csv
            : kind->format == ExportedFormat::Tum ? FileKind::Tum
                                                  : FileKind::Tracker,
            true};
}

/// What the format does not have cannot be chosen.
void ExportDialog::showFitting()
{
    const FormatKind *kind = formatKindOf(formatWord());
    const bool isTable = kind && kind->format == ExportedFormat::Csv;
    m_columns->setEnabled(isTable);
    m_unit->setEnabled(isTable);
    m_axes->setEnabled(kind != nullptr);
    m_part->setEnabled(kind != nullptr && m_part->count() > 1);
    const bool isEmpty = isTable && settings().columns.empty();
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(!isEmpty);
}

void ExportDialog::showColumnNames()
{
    const QSignalBlocker quiet(m_columns);
    const auto names = csvColumns(settings().unit);
    for (int row = 0; row < m_columns->count(); ++row)
        m_columns->item(row)->setText(QString::fromStdString(names[static_cast<std::size_t>(row)]));
}

QVariantMap ExportDialog::words() const
{
    QStringList columns;
    for (int row = 0; row < m_columns->count(); ++row)
        if (m_columns->item(row)->checkState() == Qt::Checked)
            columns << m_columns->item(row)->data(Qt::UserRole).toString();
    return {{formatKey, formatWord()},
            {columnsKeyWord, columns},
            {unitKey, m_unit->currentData()},
            {axesKey, m_axes->currentData()}};
}

/// What is missing, or of another version, stays as it is.
void ExportDialog::setWords(const QVariantMap &words)
{
    chooseData(*m_format, words.value(formatKey));
    chooseData(*m_unit, words.value(unitKey));
    chooseData(*m_axes, words.value(axesKey));
    if (const QStringList columns = words.value(columnsKeyWord).toStringList(); !columns.isEmpty()) {
        for (int row = 0; row < m_columns->count(); ++row) {
            QListWidgetItem *item = m_columns->item(row);
            item->setCheckState(columns.contains(item->data(Qt::UserRole).toString()) ? Qt::Checked
                                                                                      : Qt::Unchecked);
        }
    }
    showFitting();
}

void ExportDialog::offerPresets(const QString &current)
{
    m_preset->clear();
    m_preset->addItem(tr("As last time"), QString());
    for (const QString &name : QSettings().value(presetsKey).toMap().keys())
        m_preset->addItem(name, name);
    chooseData(*m_preset, current);
    m_removePreset->setEnabled(m_preset->currentIndex() > 0);
}

void ExportDialog::savePreset()
{
    QInputDialog question(this);
    question.setWindowTitle(tr("Keep these choices"));
    question.setLabelText(tr("Name of the preset:"));
    question.setTextValue(m_preset->currentData().toString());
    if (question.exec() != QDialog::Accepted)
        return;
    constexpr qsizetype longest = 60;
    const QString name = question.textValue().simplified().left(longest);
    if (name.isEmpty())
        return;
    QVariantMap presets = QSettings().value(presetsKey).toMap();
    presets.insert(name, words());
    QSettings().setValue(presetsKey, presets);
    offerPresets(name);
}

void ExportDialog::removePreset()
{
    QVariantMap presets = QSettings().value(presetsKey).toMap();
    presets.remove(m_preset->currentData().toString());
    QSettings().setValue(presetsKey, presets);
    offerPresets({});
}

void ExportDialog::accept()
{
    QSettings().setValue(lastExportKey, words());
    QDialog::accept();
}

} // namespace odo
