// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/sample_model.h"

#include "core/analysis/motion_stretches.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

enum class Measure { Time, Count, Length, Speed, Acceleration, Angle, AngularSpeed, Words };

struct ColumnKind
{
    const char *word;
    Measure measure;
};

constexpr std::array<ColumnKind, std::size_t(SampleColumn::Count)> columnKinds{
    {{"time", Measure::Time},
     {"frame", Measure::Count},
     {"x", Measure::Length},
     {"sigma_x", Measure::Length},
     {"y", Measure::Length},
     {"sigma_y", Measure::Length},
     {"vx", Measure::Speed},
     {"vy", Measure::Speed},
     {"speed", Measure::Speed},
     {"sigma_speed", Measure::Speed},
     {"ax", Measure::Acceleration},
     {"ay", Measure::Acceleration},
     {"acceleration", Measure::Acceleration},
     {"sigma_acceleration", Measure::Acceleration},
     {"heading", Measure::Angle},
     {"sigma_heading", Measure::Angle},
     {"turn_rate", Measure::AngularSpeed},
     {"sigma_turn_rate", Measure::AngularSpeed},
     {"distance", Measure::Length},
     {"measured_x", Measure::Length},
     {"measured_y", Measure::Length},
     {"views", Measure::Words},
     {"flags", Measure::Words}}};

const ColumnKind &kindOf(SampleColumn column)
{
    return columnKinds.at(static_cast<std::size_t>(column));
}

ShownUnit unitOf(Measure measure)
{
    switch (measure) {
    case Measure::Time:
        return {QStringLiteral("s"), 1};
    case Measure::Length:
        return shownUnits().length;
    case Measure::Speed:
        return shownUnits().speed;
    case Measure::Acceleration:
        return shownUnits().acceleration;
    case Measure::Angle:
        return {QStringLiteral("°"), 180 / std::numbers::pi};
    case Measure::AngularSpeed:
        return {QStringLiteral("°/s"), 180 / std::numbers::pi};
    case Measure::Count:
    case Measure::Words:
        break;
    }
    return {};
}

QVariant sideOf(SampleColumn column)
{
    const bool isNumber = kindOf(column).measure != Measure::Words;
    return QVariant::fromValue((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

/// On screen: a tenth of a millimetre, a millimetre a second, a centimetre a second squared, or finer.
int decimalsOf(Measure measure)
{
    const auto finer = [measure](int ofSi) {
        return std::max(0, ofSi - static_cast<int>(std::floor(std::log10(unitOf(measure).perSi))));
    };
    switch (measure) {
    case Measure::Time:
    case Measure::Speed:
        return finer(3);
    case Measure::Length:
        return finer(4);
    case Measure::Acceleration:
        return finer(2);
    case Measure::Angle:
    case Measure::AngularSpeed:
        return 1;
    case Measure::Count:
    case Measure::Words:
        break;
    }
    return 0;
}

} // namespace

QString sampleColumnWord(SampleColumn column)
{
    return QString::fromLatin1(kindOf(column).word);
}

void SampleModel::setRun(TrialScenePtr scene, std::size_t robot)
{
    beginResetModel();
    m_scene = std::move(scene);
    m_robot = robot;
    m_headings.clear();
    m_distances.clear();
    endResetModel();
}

const std::optional<Heading> &SampleModel::headingAt(std::size_t row) const
{
    if (m_headings.empty())
        m_headings = headingsOf(*profile());
    return m_headings[row];
}

double SampleModel::distanceAt(std::size_t row) const
{
    if (m_distances.empty())
        m_distances = distanceTravelled(profile()->samples, profile()->points);
    return m_distances[row];
}

const Profile *SampleModel::profile() const
{
    if (!m_scene || m_robot >= m_scene->robots.size() || !m_scene->robots[m_robot].analysis)
        return nullptr;
    return &m_scene->robots[m_robot].analysis->profile;
}

int SampleModel::rows() const
{
    const Profile *run = profile();
    return run ? static_cast<int>(std::min(run->samples.size(), run->points.size())) : 0;
}

int SampleModel::rowAt(Nanoseconds time) const
{
    const Profile *run = profile();
    if (!run)
        return -1;
    const auto behind = std::ranges::upper_bound(run->samples, time, {}, &Sample::time);
    return std::min(rows(), static_cast<int>(behind - run->samples.begin())) - 1;
}

std::optional<Nanoseconds> SampleModel::timeAt(int row) const
{
    if (row < 0 || row >= rows())
        return std::nullopt;
    return profile()->samples[static_cast<std::size_t>(row)].time;
}

/// In SI; nullopt: not known.
std::optional<double> SampleModel::number(int row, SampleColumn column) const
{
    const auto i = static_cast<std::size_t>(row);
    const Sample &sample = profile()->samples[i];
    const ProfilePoint &point = profile()->points[i];
    const auto valid = [&point](double value) {
        return point.valid && std::isfinite(value) ? std::optional(value) : std::nullopt;
    };
    switch (column) {
    case SampleColumn::Time:
        return toSeconds(sample.time);
    case SampleColumn::Frame:
        return static_cast<double>(sample.frame);
    case SampleColumn::PositionX:
        return valid(point.position.x());
    case SampleColumn::SigmaX:
        return valid(point.sigmaXM);
    case SampleColumn::PositionY:
        return valid(point.position.y());
    case SampleColumn::SigmaY:
        return valid(point.sigmaYM);
    case SampleColumn::VelocityX:
        return valid(point.velocity.x());
    case SampleColumn::VelocityY:
        return valid(point.velocity.y());
    case SampleColumn::Speed:
        return valid(point.speedMps);
    case SampleColumn::SigmaSpeed:
        return valid(point.sigmaSpeedMps);
    case SampleColumn::AccelerationX:
        return valid(point.acceleration.x());
    case SampleColumn::AccelerationY:
        return valid(point.acceleration.y());
    case SampleColumn::Acceleration:
        return valid(point.accelMps2);
    case SampleColumn::SigmaAcceleration:
        return valid(point.sigmaAccelMps2);
    case SampleColumn::Heading:
        return headingAt(i) ? std::optional(headingAt(i)->radians) : std::nullopt;
    case SampleColumn::SigmaHeading:
        return headingAt(i) ? headingAt(i)->sigmaRad : std::nullopt;
    case SampleColumn::TurnRate:
    case SampleColumn::SigmaTurnRate:
        if (const auto rate = point.valid ? turnRateOf(point) : std::nullopt)
            return column == SampleColumn::TurnRate ? rate->value : rate->sigma;
        return std::nullopt;
    case SampleColumn::Distance:
        return valid(distanceAt(i));
    case SampleColumn::MeasuredX:
        return sample.position ? std::optional(sample.position->x()) : std::nullopt;
    case SampleColumn::MeasuredY:
        return sample.position ? std::optional(sample.position->y()) : std::nullopt;
    default:
        return std::nullopt;
    }
}

/// Of a spike its reason.
QString SampleModel::words(int row, SampleColumn column) const
{
    const Sample &sample = profile()->samples[static_cast<std::size_t>(row)];
    if (column == SampleColumn::Views) {
        QStringList names;
        const std::vector<std::string> &views = m_scene->robots[m_robot].analysis->views;
        for (std::size_t view = 0; view < views.size() && view < 32; ++view)
            if ((sample.views & (1U << view)) != 0)
                names << QString::fromStdString(views[view]);
        return names.join(u'+');
    }
    const auto &spikes = profile()->spikes;
    const auto spike = std::ranges::find(spikes, std::int64_t(row), &Spike::sampleIndex);
    return spike != spikes.end() ? shownWords(spike->reason)
                                 : QString::fromStdString(flagNames(sample.flags));
}

int SampleModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : rows();
}

int SampleModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(SampleColumn::Count);
}

QVariant SampleModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const auto column = static_cast<SampleColumn>(index.column());
    const Measure measure = kindOf(column).measure;
    if (role == Qt::TextAlignmentRole)
        return sideOf(column);
    if (measure == Measure::Words)
        return role == Qt::DisplayRole   ? QVariant(words(index.row(), column))
               : role == Qt::ToolTipRole ? QVariant(words(index.row(), column).toHtmlEscaped())
                                         : QVariant();
    if (role != Qt::DisplayRole)
        return {};
    const auto value = number(index.row(), column);
    if (!value)
        return {};
    if (measure == Measure::Count)
        return QLocale().toString(*value, 'f', 0);
    return QLocale().toString(*value * unitOf(measure).perSi, 'f', decimalsOf(measure));
}

QString SampleModel::headingOf(SampleColumn column)
{
    const auto name = [column]() -> QString {
        switch (column) {
        case SampleColumn::Time:
            return tr("Time");
        case SampleColumn::Frame:
            return tr("Frame");
        case SampleColumn::PositionX:
            return QStringLiteral("x");
        case SampleColumn::SigmaX:
            return QStringLiteral("± x");
        case SampleColumn::PositionY:
            return QStringLiteral("y");
        case SampleColumn::SigmaY:
            return QStringLiteral("± y");
        case SampleColumn::VelocityX:
            return QStringLiteral("vx");
        case SampleColumn::VelocityY:
            return QStringLiteral("vy");
        case SampleColumn::Speed:
            return tr("Speed");
        case SampleColumn::SigmaSpeed:
            return tr("± Speed");
        case SampleColumn::AccelerationX:
            return QStringLiteral("ax");
        case SampleColumn::AccelerationY:
            return QStringLiteral("ay");
        case SampleColumn::Acceleration:
            return tr("Acceleration");
        case SampleColumn::SigmaAcceleration:
            return tr("± Acceleration");
        case SampleColumn::Heading:
            return tr("Heading");
        case SampleColumn::SigmaHeading:
            return tr("± Heading");
        case SampleColumn::TurnRate:
            return tr("Turn rate");
        case SampleColumn::SigmaTurnRate:
            return tr("± Turn rate");
        case SampleColumn::Distance:
            return tr("Distance travelled");
        case SampleColumn::MeasuredX:
            return tr("Measured x");
        case SampleColumn::MeasuredY:
            return tr("Measured y");
        case SampleColumn::Views:
            return tr("Views");
        case SampleColumn::Flags:
        case SampleColumn::Count:
            break;
        }
        return tr("Flags");
    }();
    const QString unit = unitOf(kindOf(column).measure).name;
    return unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit);
}

QVariant SampleModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    const auto column = static_cast<SampleColumn>(section);
    return role == Qt::TextAlignmentRole ? sideOf(column)
           : role == Qt::DisplayRole     ? QVariant(headingOf(column))
                                         : QVariant();
}

QString SampleModel::tabbed(const std::vector<int> &rows, const std::vector<int> &columns) const
{
    QString text;
    const auto addLine = [&](const auto &cellOf) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (i > 0)
                text += u'\t';
            text += cellOf(static_cast<SampleColumn>(columns[i]));
        }
        text += u'\n';
    };
    addLine([](SampleColumn column) { return headingOf(column); });
    for (const int row : rows)
        addLine([&](SampleColumn column) {
            if (kindOf(column).measure == Measure::Words)
                return words(row, column);
            const auto value = number(row, column);
            const Measure measure = kindOf(column).measure;
            const double perSi = measure == Measure::Count ? 1 : unitOf(measure).perSi;
            return plainNumber(value ? std::optional(*value * perSi) : std::nullopt);
        });
    return text;
}

} // namespace odo
