// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/exchange/track_styles.h"

#include <cmath>
#include <numbers>
#include <random>

namespace odo::test {

DrivenRun DrivenRun::made(unsigned seed)
{
    DrivenRun run;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.0015);
    for (int i = 0; i < 360; ++i) {
        const double t = i / rate, angle = speedMps / radiusM * t;
        run.rows.push_back({t, 1.5 + (radiusM * (std::cos(angle) - 1)) + noise(random),
                            1 + (radiusM * std::sin(angle)) + noise(random)});
    }
    return run;
}

namespace {

QByteArray number(double value, int decimals, char sign = '.')
{
    if (std::isnan(value))
        return "nan";
    QByteArray text = QByteArray::number(value, 'f', decimals);
    return sign == '.' ? text : text.replace('.', sign);
}

/// A header and a line for each row: `cells` of t, x, y.
using Line = std::function<QByteArray(std::size_t, const DrivenRun::Row &)>;
QByteArray table(const QByteArray &header, const DrivenRun &run, const Line &line)
{
    QByteArray text = header;
    for (std::size_t i = 0; i < run.rows.size(); ++i)
        text += line(i, run.rows[i]) + '\n';
    return text;
}

/// Columns t, x, y in units of so many a second and a metre.
Line columns(double perSecond, int timeDigits, double perMetre, int digits, char delimiter = ',',
             char sign = '.')
{
    return [=](std::size_t, const DrivenRun::Row &row) {
        return number(row.t * perSecond, timeDigits, sign) + delimiter +
               number(row.x * perMetre, digits, sign) + delimiter + number(row.y * perMetre, digits, sign);
    };
}

QByteArray grouped(double value)
{
    if (std::isnan(value))
        return {};
    const int whole = int(std::lround(value));
    QByteArray text = QByteArray::number(whole);
    if (whole >= 1000)
        text.insert(text.size() - 3, '.');
    return text;
}

QByteArray stamp(double t)
{
    return QByteArray::number(1403636579763555584LL + std::llround(t * 1e9));
}

Line tum(bool inNanoseconds)
{
    return [=](std::size_t, const DrivenRun::Row &row) {
        return (inNanoseconds ? stamp(row.t) : number(1305031102.1753 + row.t, 6)) + ' ' + number(row.x, 6) +
               ' ' + number(row.y, 6) + " 0 0 0 0 1";
    };
}

QByteArray clock(double t)
{
    const long ms = std::lround(t * 1000);
    return "0:00:" + QByteArray::number(100 + ms / 1000).right(2) + ',' +
           QByteArray::number(1000 + ms % 1000).right(3);
}

QByteArray isoTime(double t)
{
    const long ms = std::lround(t * 1000);
    return "2024-05-06T10:11:" + QByteArray::number(100 + 3 + ms / 1000).right(2) + '.' +
           QByteArray::number(1000 + ms % 1000).right(3) + 'Z';
}

TrackStyle plain(const char *name, const QByteArray &header, const QByteArray &bare, const Line &line)
{
    return {name, [=](const DrivenRun &run) { return table(header, run, line); },
            bare.isEmpty() ? std::function<QByteArray(const DrivenRun &)>()
                           : [=](const DrivenRun &run) { return table(bare, run, line); }};
}

Line rosLine()
{
    return [](std::size_t i, const DrivenRun::Row &row) {
        return stamp(row.t + 0.002) + ',' + QByteArray::number(quint64(i)) + ',' + stamp(row.t) + ",odom," +
               number(row.x, 6) + ',' + number(row.y, 6) + ",0.0";
    };
}

/// `ros2 topic echo --csv`: no header, all fields in order, and no quotes. zeros: numbers behind the pose.
Line echoLine(const QByteArray &frames, int zeros)
{
    return [=](std::size_t, const DrivenRun::Row &row) {
        const qint64 ns = 1403636579763555584LL + std::llround(row.t * 1e9);
        return QByteArray::number(ns / 1'000'000'000) + ',' + QByteArray::number(ns % 1'000'000'000) + ',' +
               frames + ',' + number(row.x, 6) + ',' + number(row.y, 6) + ",0.0,0.0,0.0,0.0,1.0" +
               QByteArray(",0.0").repeated(zeros);
    };
}

QByteArray frame(const DrivenRun::Row &row)
{
    return QByteArray::number(std::lround(row.t * DrivenRun::rate));
}

Line frameLine(double perMetre, bool withConfidence)
{
    return [=](std::size_t, const DrivenRun::Row &row) {
        const QByteArray line =
            frame(row) + ',' + number(row.x * perMetre, 2) + ',' + number(row.y * perMetre, 2);
        return withConfidence ? line + ',' + number(row.confidence, 3) : line;
    };
}

std::vector<TrackStyle> made()
{
    std::vector<TrackStyle> all;
    all.push_back(plain("own CSV", "t_s,x_mm,y_mm\n", "t,x,y\n", columns(1, 4, 1000, 2)));
    all.push_back(
        plain("CSV in ms and cm", "time [ms],x [cm],y [cm]\n", "time,x,y\n", columns(1000, 1, 100, 4)));
    all.push_back(plain("German CSV", "t_s;x_mm;y_mm\n", "t;x;y\n", columns(1, 4, 1000, 2, ';', ',')));
    all.push_back(plain("German thousands", "t_s;x_mm;y_mm\n", "t;x;y\n", [](std::size_t, const auto &row) {
        return number(row.t, 3, ',') + ';' + grouped(row.x * 1000) + ';' + grouped(row.y * 1000);
    }));
    all.push_back(plain("TUM", "", "", tum(false)));
    all.push_back(plain("TUM in ns", "", "", tum(true)));
    all.push_back(plain("Tracker", "\tmass A\t\t\nt\tx\ty\t\n", "", columns(1, 4, 1, 6, '\t')));
    all.push_back(
        plain("EuRoC", "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x []\n", "",
              [](std::size_t, const auto &row) {
                  return stamp(row.t) + ',' + number(row.x, 6) + ',' + number(row.y, 6) + ",0.0,1,0";
              }));
    all.push_back(plain("rostopic echo",
                        "%time,field.header.seq,field.header.stamp,field.header.frame_id,"
                        "field.pose.pose.position.x,field.pose.pose.position.y,field.pose.pose."
                        "position.z\n",
                        "", rosLine()));
    all.push_back(plain("ROS 2", "header.stamp.sec,header.stamp.nanosec,pose.position.x,pose.position.y\n",
                        "", [](std::size_t, const auto &row) {
                            const qint64 ns = 1403636579763555584LL + std::llround(row.t * 1e9);
                            return QByteArray::number(ns / 1'000'000'000) + ',' +
                                   QByteArray::number(ns % 1'000'000'000) + ',' + number(row.x, 6) + ',' +
                                   number(row.y, 6);
                        }));
    all.push_back(plain("ROS 2 echo of poses", "", "", echoLine("map", 0)));
    all.push_back(plain("ROS 2 echo of odometry", "", "", echoLine("odom,base_link", 36 + 6 + 36)));
    all.push_back(plain("no header", "", "", columns(1, 3, 1, 4)));
    all.push_back(plain("no header, German", "", "", columns(1, 3, 1, 4, ';', ',')));
    all.push_back(plain("Kinovea", "Time (ms);Trajectory 1/X (cm);Trajectory 1/Y (cm)\n", "",
                        columns(1000, 0, 100, 2, ';', ',')));
    all.push_back(plain("TRex",
                        "frame,missing,time,X#wcentroid (cm),Y#wcentroid (cm),SPEED#wcentroid (cm/s)\n", "",
                        [](std::size_t i, const auto &row) {
                            return QByteArray::number(quint64(i)) + ",0," + number(row.t, 6) + ',' +
                                   number(row.x * 100, 4) + ',' + number(row.y * 100, 4) + ",52.36";
                        }));
    all.push_back(
        plain("TRC",
              "PathFileType\t4\t(X/Y/Z)\tm.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n30"
              "\t30\t360\t1\tmm\nFrame#\tTime\tR\t\t\n\t\tX1\tY1\tZ1\n\n",
              "", [](std::size_t i, const auto &row) {
                  return QByteArray::number(quint64(i + 1)) + '\t' + number(row.t, 4) + '\t' +
                         number(row.x * 1000, 2) + "\t60.0\t" + number(row.y * 1000, 2);
              }));
    all.push_back(
        plain("ISO times", "timestamp,x [m],y [m]\n", "timestamp,x,y\n", [](std::size_t, const auto &row) {
            return isoTime(row.t) + ',' + number(row.x, 5) + ',' + number(row.y, 5);
        }));
    all.push_back(plain("clock", "Time;X (cm);Y (cm)\n", "Time;X;Y\n", [](std::size_t, const auto &row) {
        return clock(row.t) + ';' + number(row.x * 100, 2, ',') + ';' + number(row.y * 100, 2, ',');
    }));
    all.push_back(plain("a row of units", "t,x,y\ns,mm,mm\n", "", columns(1, 4, 1000, 2)));
    all.push_back(plain("pos_x", "timestamp,pos_x,pos_y\n", "", columns(1, 4, 1, 5)));
    TrackStyle frames = plain("frame numbers", "frame,x_mm,y_mm\n", "frame,x,y\n", frameLine(1000, false));
    frames.hasFrames = true;
    all.push_back(frames);
    TrackStyle dlc = plain("DeepLabCut", "scorer,net,net,net\nbodyparts,c,c,c\ncoords,x,y,likelihood\n", "",
                           frameLine(500, true));
    dlc.hasFrames = true;
    dlc.pixelM = 0.002;
    all.push_back(dlc);
    TrackStyle sleap = plain("SLEAP", "track,frame_idx,instance.score,A.x,A.y,A.score\n", "",
                             [](std::size_t, const auto &row) {
                                 return "t0," + frame(row) + ",0.9," + number(row.x * 500, 3) + ',' +
                                        number(row.y * 500, 3) + ',' + number(row.confidence, 3);
                             });
    sleap.hasFrames = true;
    sleap.pixelM = 0.002;
    all.push_back(sleap);
    return all;
}

} // namespace

const std::vector<TrackStyle> &trackStyles()
{
    static const std::vector<TrackStyle> all = made();
    return all;
}

} // namespace odo::test
