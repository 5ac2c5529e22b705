// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"

#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;

namespace {

const QByteArray rosFile = R"(# a comment
image_width: 640
image_height: 480
camera_name: "head # left"
camera_matrix:
  rows: 3
  cols: 3
  data: [500.5, 0, 320.25,   # fx
         0.0, 501.0, 240., 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 2e-2, 0, 0, 0]}
)";

// The same camera as other programs write it: COLMAP and Metashape count from the corner of the first pixel.
const QByteArray openCvXml = R"(<?xml version="1.0"?>
<opencv_storage>
<image_width>640</image_width> <image_height>480</image_height>
<camera_matrix type_id="opencv-matrix">
  <rows>3</rows>
  <cols>3</cols>
  <dt>d</dt>
  <data>
    5.005e+02 0. 320.25 0. 501. 240. 0. 0. 1.</data></camera_matrix>
<distortion_coefficients type_id="opencv-matrix">
  <rows>5</rows>
  <cols>1</cols>
  <dt>d</dt>
  <data>
    -0.1 2.0000000000000000e-02 1e-3
    -0.002 0.</data></distortion_coefficients>
</opencv_storage>
)";
const QByteArray colmap = R"(# Camera list with one line of data per camera:
#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]
# Number of cameras: 1
1 OPENCV 640 480 500.5 501 320.75 240.5 -0.1 0.02 0.001 -0.002
)";
const QByteArray metashape = R"(<?xml version="1.0" encoding="UTF-8"?>
<calibration>
  <projection>frame</projection>
  <width>640</width>
  <height>480</height>
  <f>501</f>
  <cx>0.75</cx>
  <cy>0.5</cy>
  <b1>-0.5</b1>
  <k1>-0.1</k1>
  <k2>0.02</k2>
  <p1>-0.002</p1>
  <p2>0.001</p2>
  <date>2024-05-06T10:11:03Z</date>
</calibration>
)";
const QByteArray metashapeCameras = R"(<?xml version="1.0" encoding="UTF-8"?>
<document version="1.5.0">
  <chunk label="Chunk 1" enabled="true">
    <sensors next_id="1">
      <sensor id="0" label="head, 4 mm" type="frame">
        <resolution width="640" height="480"/>
        <property name="layer_index" value="0"/>
        <calibration type="frame" class="initial">
          <resolution width="640" height="480"/>
          <f>600</f>
        </calibration>
        <calibration type="frame" class="adjusted">
          <resolution width="640" height="480"/>
          <f>501</f> <cx>0.75</cx> <cy>0.5</cy> <b1>-0.5</b1> <k1>-0.1</k1> <k2>0.02</k2>
          <p1>-0.002</p1> <p2>0.001</p2>
        </calibration>
        <covariance><params>f cx cy</params><coeffs>1 0 0 0 1 0 0 0 1</coeffs></covariance>
      </sensor>
    </sensors>
    <cameras next_id="1"><camera id="0" sensor_id="0" label="a.jpg"/></cameras>
  </chunk>
</document>
)";

// The same camera as seven programs write it, and twice as a file of two cameras.
const QByteArray rosMessage = R"(header:
  frame_id: head
height: 480
width: 640
distortion_model: plumb_bob
d:
- -0.1
- 0.02
- 0.001
- -0.002
- 0.0
k: [500.5, 0.0, 320.25, 0.0, 501.0, 240.0, 0.0, 0.0, 1.0]
p: [400.0, 0.0, 300.0, 0.0, 0.0, 400.0, 200.0, 0.0, 0.0, 0.0, 1.0, 0.0]
---
height: 480
width: 640
)";
const QByteArray ini = R"(# a comment
[image]
width
640
height
480

[head]
camera matrix
500.5 0 320.25
0 501.0 240.0
0 0 1

distortion
-0.1 0.02 0.001 -0.002 0.0

projection
400 0 300 0
0 400 200 0
0 0 1 0
)";
const QByteArray kalibr = R"(cam0:
  camera_model: pinhole
  intrinsics: [500.5, 501.0, 320.25, 240.0]
  distortion_model: radtan
  distortion_coeffs: [-0.1, 0.02, 0.001, -0.002]
  resolution: [640, 480]
)";
const QByteArray photonVision = R"({"resolution":{"width":640.0,"height":480.0},
"cameraIntrinsics":{"rows":3,"cols":3,"type":6,"data":[500.5,0.0,320.25,0.0,501.0,240.0,0.0,0.0,1.0]},
"distCoeffs":{"rows":1,"cols":5,"type":6,"data":[-0.1,0.02,0.001,-0.002,0.0]},"observations":[]})";
const QByteArray upperCase = R"(%YAML:1.0
---
image_width: 640
image_height: 480
Camera_Matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500.5, 0., 320.25, 0., 501., 240., 0., 0., 1. ]
Distortion_Coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -0.1, 0.02, 0.001, -0.002, 0. ]
)";
/// TOML, as anipose and Pose2Sim write it.
const QByteArray toml = R"([cam_0]
name = "head"
size = [ 640, 480,]
matrix = [ [ 500.5, 0.0, 320.25,], [ 0.0, 501.0, 240.0,], [ 0.0, 0.0, 1.0,],]
distortions = [ -0.1, 0.02, 0.001, -0.002, 0.0,]
fisheye = false

[metadata]
error = 0.2
)";
/// The same in a table of cameras.
const QByteArray twoInToml = R"([cameras.0]
size = [640, 480]
matrix = [[500.5, 0.0, 320.25], [0.0, 501.0, 240.0], [0.0, 0.0, 1.0]]
distortions = [-0.1, 0.02, 0.001, -0.002, 0.0]

[cameras.1]
size = [640, 480]
matrix = [[700.0, 0.0, 300.0], [0.0, 700.0, 200.0], [0.0, 0.0, 1.0]]
distortions = [0.0, 0.0, 0.0, 0.0]
fisheye = true
)";

QString realFile(const char *name)
{
    const QString folder =
        qEnvironmentVariable("ODOGRAPH_REAL_DATA",
                             qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + QStringLiteral("/../shared/data"));
    return folder + u'/' + QString::fromLatin1(name);
}

} // namespace

class TestCalibrationFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void readsRos()
    {
        const auto read = readCalibrationFile(write(rosFile));
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        QCOMPARE(read->cameraName, std::string("head # left"));
        QCOMPARE(read->intrinsics.widthPx, 640);
        QCOMPARE(read->intrinsics.fxPx, 500.5);
        QCOMPARE(read->intrinsics.cyPx, 240.0);
        QVERIFY((read->intrinsics.distortion == std::vector<double>{-0.1, 0.02, 0, 0, 0}));
        QVERIFY(!read->reprojectionPx.has_value());
    }
    void readsBlockSequences()
    {
        QByteArray text = rosFile;
        text.replace("data: [500.5, 0, 320.25,   # fx\n         0.0, 501.0, 240., 0, 0, 1]",
                     "data:\n  - 500.5\n  - 0\n  - 320.25\n  - 0\n  - 501\n  - 240\n  - 0\n  - 0\n  - 1");
        const auto read = readIntrinsics(write(text));
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        QCOMPARE(read->cxPx, 320.25);
    }

    void readsOtherPrograms_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("entry");
        QTest::newRow("messages of ROS 2") << rosMessage << QString();
        QTest::newRow("messages of ROS 1")
            << QByteArray(rosMessage).replace("d:\n-", "D:\n-").replace("k:", "K:") << QString();
        QTest::newRow("INI of ROS") << ini << QString();
        QTest::newRow("Kalibr") << kalibr << QString();
        QTest::newRow("one of two of Kalibr")
            << kalibr + QByteArray(kalibr).replace("cam0", "cam1").replace("500.5", "700")
            << QStringLiteral("cam0");
        QTest::newRow("PhotonVision") << photonVision << QString();
        QTest::newRow("EuRoC") << QByteArray(kalibr)
                                      .replace("cam0:\n", "")
                                      .replace("\n  ", "\n")
                                      .replace("  camera_model", "camera_model")
                                      .replace("radtan", "radial-tangential")
                               << QString();
        QTest::newRow("Python's names")
            << QByteArray(R"({"mtx":[[500.5,0,320.25],[0,501,240],[0,0,1]],"width":640,"height":480,)"
                          R"("dist":[[-0.1,0.02,0.001,-0.002,0]]})")
            << QString();
        QTest::newRow("calibdb")
            << QByteArray(
                   R"({"camera_matrix":[[500.5,0,320.25],[0,501,240],[0,0,1]],"img_size":[640,480],)"
                   R"("distortion_model":"rectilinear","distortion_coefficients":[-0.1,0.02,0.001,-0.002,0]})")
            << QString();
        QTest::newRow("OpenCV with capitals") << upperCase << QString();
        QTest::newRow("OpenCV, XML") << openCvXml << QString();
        QTest::newRow("COLMAP") << colmap << QString();
        QTest::newRow("COLMAP, with commas")
            << QByteArray(colmap).replace("1 OPENCV", "7 OPENCV").replace(' ', ',').replace("#,", "# ")
            << QString();
        QTest::newRow("one of two of COLMAP")
            << colmap + QByteArray("2 SIMPLE_PINHOLE 3008 4096 1900 1504 2048\n") << QStringLiteral("1");
        QTest::newRow("Metashape, lens calibration") << metashape << QString();
        QTest::newRow("Metashape, cameras") << metashapeCameras << QString();
        QTest::newRow("Metashape, cameras, by the sensor's name")
            << metashapeCameras << QStringLiteral("head, 4 mm");
        QTest::newRow("anipose") << toml << QString();
        QTest::newRow("anipose, by its name") << toml << QStringLiteral("head");
        QTest::newRow("caliscope") << twoInToml << QStringLiteral("0");
    }
    void readsOtherPrograms()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, entry);
        const auto read = readIntrinsics(write(text), entry.toStdString());
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        QCOMPARE(read->widthPx, 640);
        QCOMPARE(read->heightPx, 480);
        QCOMPARE(read->fxPx, 500.5);
        QCOMPARE(read->fyPx, 501.0);
        QCOMPARE(read->cxPx, 320.25);
        QCOMPARE(read->cyPx, 240.0);
        QCOMPARE(read->model, LensModel::Standard);
        std::vector<double> distortion = read->distortion;
        distortion.resize(5);
        QVERIFY((distortion == std::vector<double>{-0.1, 0.02, 0.001, -0.002, 0}));
    }
    void fisheyesOfOtherPrograms()
    {
        for (const QByteArray &text :
             {QByteArray("1 OPENCV_FISHEYE 640 480 500.5 501 320.75 240.5 -0.1 0.02 0.001 -0.002\n"),
              QByteArray(metashape)
                  .replace("frame", "fisheye")
                  .replace("<p1>-0.002</p1>", "<k3>0.001</k3>")
                  .replace("<p2>0.001</p2>", "<k4>-0.002</k4>")}) {
            const auto read = readIntrinsics(write(text));
            QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
            QCOMPARE(read->model, LensModel::Fisheye);
            QCOMPARE(read->cxPx, 320.25);
            QVERIFY((read->distortion == std::vector<double>{-0.1, 0.02, 0.001, -0.002}));
        }
        const auto full = readIntrinsics(
            write("1 FULL_OPENCV 640 480 500.5 501 320.75 240.5 -0.1 0.02 0.001 -0.002 0.3 0.4 0.5 0.6\n"));
        QVERIFY2(full.has_value(), full ? "" : full.error().message().c_str());
        QVERIFY((full->distortion == std::vector<double>{-0.1, 0.02, 0.001, -0.002, 0.3, 0.4, 0.5, 0.6}));
        const auto radial = readIntrinsics(write("1 SIMPLE_RADIAL 640 480 500 320 240 -0.1\n"));
        QVERIFY2(radial.has_value(), radial ? "" : radial.error().message().c_str());
        QCOMPARE(radial->fyPx, 500.0);
        QCOMPARE(radial->cyPx, 239.5);
        QCOMPARE(radial->distortion.front(), -0.1);
    }
    /// Five columns, as some write of eight numbers.
    void coefficientsCountByThemselves()
    {
        QByteArray text = rosFile;
        text.replace("plumb_bob", "rational_polynomial").replace("0, 0, 0]}", "0, 0, 0, 0.1, 0.02, 0.003]}");
        const auto read = readIntrinsics(write(text));
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        QCOMPARE(read->model, LensModel::Rational);
        QCOMPARE(read->distortion.size(), std::size_t(8));
        QCOMPARE(read->distortion.back(), 0.003);
    }
    void ofSeveralCamerasOneIsChosen()
    {
        const auto names = camerasInCalibration(write(twoInToml));
        QVERIFY(names.has_value());
        QVERIFY((*names == std::vector<std::string>{"0", "1"}));
        const auto second = readIntrinsics(write(twoInToml), "1");
        QVERIFY(second.has_value());
        QCOMPARE(second->fxPx, 700.0);
        QCOMPARE(second->model, LensModel::Fisheye);
        QCOMPARE(camerasInCalibration(write(rosFile))->size(), std::size_t(1));
    }

    void roundTripsBitForBit_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<int>("count");
        QTest::newRow("standard") << int(LensModel::Standard) << 5;
        QTest::newRow("four coefficients") << int(LensModel::Standard) << 4;
        QTest::newRow("rational") << int(LensModel::Rational) << 8;
        QTest::newRow("fisheye") << int(LensModel::Fisheye) << 4;
    }
    void roundTripsBitForBit()
    {
        QFETCH(int, model);
        QFETCH(int, count);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> focal(300, 2000), small(-1e-3, 1e-3);
        for (int i = 0; i < 50; ++i) {
            Intrinsics k{1088,
                         1920,
                         focal(random),
                         focal(random),
                         focal(random),
                         focal(random),
                         static_cast<LensModel>(model),
                         {},
                         {}};
            for (int c = 0; c < count; ++c)
                k.distortion.push_back(small(random) * (c == 2 ? 1e-8 : 1));
            for (const auto format : {IntrinsicsFormat::Ros, IntrinsicsFormat::OpenCv}) {
                const auto read = parseCalibration("a.yaml", intrinsicsText("Kamera 'ß': #1", k, format));
                QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
                const Intrinsics &back = read->intrinsics;
                QVERIFY(back.widthPx == k.widthPx && back.heightPx == k.heightPx && back.model == k.model);
                QVERIFY(back.fxPx == k.fxPx && back.fyPx == k.fyPx && back.cxPx == k.cxPx &&
                        back.cyPx == k.cyPx);
                QVERIFY(back.distortion == k.distortion);
            }
        }
    }
    void theExtensionChoosesTheFormat()
    {
        const Intrinsics k{640, 480, 500, 501, 320, 240, LensModel::Standard, {}, {}};
        for (const auto &[name, begin] :
             {std::pair{"a.yaml", "image_width"}, std::pair{"a.yml", "%YAML:1.0"}}) {
            QFile file(m_folder.filePath(QString::fromLatin1(name)));
            QVERIFY(writeIntrinsics(file.fileName().toStdString(), "A", k).has_value());
            QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().startsWith(begin));
            QCOMPARE(readIntrinsics(file.fileName().toStdString())->fyPx, 501.0);
        }
    }
    void writesTheExpectedText()
    {
        const Intrinsics k{640, 480, 500.5, 501, 320, 240.25, LensModel::Standard, {-0.1, 0, 0, 0}, {}};
        QCOMPARE(intrinsicsText("A", k, IntrinsicsFormat::OpenCv),
                 std::string("%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_name: 'A'\n"
                             "camera_matrix: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
                             "  data: [500.5, 0.0, 320.0, 0.0, 501.0, 240.25, 0.0, 0.0, 1.0]\n"
                             "distortion_coefficients: !!opencv-matrix\n  rows: 1\n  cols: 4\n  dt: d\n"
                             "  data: [-0.1, 0.0, 0.0, 0.0]\n"));
        const std::string ros = intrinsicsText("A", k, IntrinsicsFormat::Ros);
        QVERIFY(ros.find("distortion_model: plumb_bob\n") != std::string::npos);
        QVERIFY(
            ros.find("projection_matrix:\n  rows: 3\n  cols: 4\n  data: [500.5, 0.0, 320.0, 0.0, 0.0, 501.0, "
                     "240.25, 0.0, 0.0, 0.0, 1.0, 0.0]\n") != std::string::npos);
    }

    void refusesHostileFiles_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << text << QString::fromUtf8(message);
        };
        const auto changed = [](const char *from, const char *to) {
            return QByteArray(rosFile).replace(from, to);
        };
        row("empty", "", ":1: the file is empty");
        row("a list", "- 1\n- 2\n", ":1: the entry 'image_width' is missing");
        row("no pictures", "a: b\n", ":1: the entry 'image_width' is missing");
        row("deep flow", QByteArray("a: ") + QByteArray(100000, '[') + QByteArray(100000, ']'),
            ":1: it is nested more than 16 deep");
        row("deep maps", QByteArray("a: ") + QByteArray("{a: ").repeated(50000),
            ":1: it is nested more than 16");
        row("deep dashes", QByteArray("- ").repeated(100000), "nested more than 16 deep");
        row("many values", QByteArray("a: [") + QByteArray("1,").repeated(200000) + "]",
            ":1: it holds more than 100000");
        row("too many rows", changed("rows: 3", "rows: 2000000000"),
            ":6: 'rows' is not a whole number from 0 to 100");
        row("negative rows", changed("rows: 3", "rows: -3"), ":6: 'rows' is not a whole number");
        row("wrong count", changed("0, 0, 1]", "0, 1]"),
            ":8: 'camera_matrix' has 8 numbers instead of 3 × 3");
        row("NaN", changed("500.5", ".nan"), ":8: 'camera_matrix' is not a finite number");
        row("infinite", changed("501.0", "1e999"), ":9: 'camera_matrix' is not a finite number");
        row("text for a number", changed("image_width: 640", "image_width: wide"),
            ":2: 'image_width' is not a finite");
        row("half a pixel", changed("640", "640.5"), ":2: 'image_width' is not a whole number");
        row("list for a number", changed("640", "[640]"), ":2: 'image_width' is not a finite number");
        row("skew", changed("500.5, 0", "500.5, 3"), ":6: 'camera_matrix' is not of the form");
        row("negative focal length", changed("500.5", "-500.5"), "not");
        row("unknown lens", changed("plumb_bob", "bubble"), ":10: the lens model 'bubble' is unknown");
        row("three coefficients", changed("cols: 5, data: [-0.1, 2e-2, 0, 0, 0]", "cols: 3, data: [1, 2, 3]"),
            "coefficients");
        row("doubled key", changed("image_height: 480", "image_width: 480"),
            ":3: the key 'image_width' appears twice");
        QByteArray manyKeys;
        for (int key = 0; key < 80'000; ++key) // each was compared with all before it
            manyKeys += 'k' + QByteArray::number(key) + ": 1\n";
        row("many keys", manyKeys, ":1: the entry 'image_width' is missing");
        row("anchor", changed("640", "&a 640"), ":2: anchors and aliases are not supported");
        row("alias", changed("640", "*a"), ":2: it is not valid YAML (the referenced anchor is not defined)");
        row("a list as a key", "? [a, b]\n: 2\n", ":1: a key is not text, or a bracket is not closed");
        row("open bracket", changed("0, 0, 1]", "0, 0, 1"), "");
        row("open quote", changed("\"head # left\"", "\"head"), ":2: the entry 'camera_matrix' is missing");
        row("tab", changed("  rows: 3", "\trows: 3"), ":6: it is not valid YAML (illegal map value)");
        row("two documents", rosFile + "---\na: b\n", "more than one document");
        row("bad indentation", changed("  cols: 3", "    cols: 3"),
            ":7: it is not valid YAML (illegal map value)");
        row("two cameras", twoInToml, ":1: it holds several cameras: 0 and 1; choose one of them");
        row("a lens of Kalibr", QByteArray(kalibr).replace("pinhole", "omni"),
            ":2: the lens model 'omni' is unknown");
        row("a lens of Kalibr with numbers of its own",
            QByteArray(kalibr).replace("pinhole", "omni").replace("[500.5", "[0.9, 500.5"),
            ":2: the lens model 'omni' is unknown");
        row("a list as Python prints it",
            changed("{rows: 1, cols: 5, data: [-0.1, 2e-2, 0, 0, 0]}",
                    "\"array('d', [-0.1, 0.02, 0, 0, 0])\""),
            ":11: 'distortion_coefficients' is not a list of numbers");
        row("a number for coefficients", changed("{rows: 1, cols: 5, data: [-0.1, 2e-2, 0, 0, 0]}", "0"),
            ":11: 'distortion_coefficients' is not a list of numbers");
        row("text for the matrix", QByteArray(kalibr).replace("[500.5, 501.0, 320.25, 240.0]", "none"),
            ":3: 'camera_matrix' is not a list of numbers");
        row("height before width", QByteArray(toml).replace("[ 640, 480,]", "[ 480, 640,]"),
            ":1: its width and height are exchanged: the image centre (320.2, 240.0) is that of 640 × 480 "
            "pixels, not 480 × 640");
        row("XML without a camera", "<?xml version=\"1.0\"?>\n<opencv_storage>\n</opencv_storage>\n",
            "the entry 'image_width' is missing");
        row("XML that ends too early", openCvXml.left(200), "it is not valid XML (");
        row("deep XML", QByteArray("<a>").repeated(200), "it is not valid XML (too large)");
        row("XML with an entity that grows",
            "<!DOCTYPE a [<!ENTITY b \"0 0 0 0\"><!ENTITY c \"&b;&b;&b;&b;\"><!ENTITY d "
            "\"&c;&c;&c;&c;\">]>\n<a>&d;</a>",
            "the entry 'image_width' is missing");
        row("a lens of COLMAP", QByteArray(colmap).replace("OPENCV", "FOV"),
            ":4: the lens model 'FOV' is unknown");
        row("COLMAP without a coefficient", QByteArray(colmap).replace(" -0.002", ""),
            ":4: the lens model 'OPENCV' is unknown");
        row("a skewed camera of Metashape", QByteArray(metashape).replace("<b1>", "<b2>-4.2</b2><b1>"),
            "'camera_matrix' is not of the form fx 0 cx, 0 fy cy, 0 0 1");
        row("a fourth coefficient of Metashape", QByteArray(metashape).replace("<p1>", "<k4>0.1</k4><p1>"),
            "the lens model 'frame + k4' is unknown");
        row("five numbers", QByteArray(kalibr).replace("320.25,", "320.25, 0,"),
            ":3: 'camera_matrix' has 5 numbers instead of 3 × 3");
        row("TOML that ends too early", toml.left(60), "it is not valid TOML");
        row("deep TOML", "[a]\nb = " + QByteArray(200, '[') + QByteArray(200, ']'), "values");
        row("INI without a size", QByteArray(ini).replace("width", "breadth"),
            ":1: the entry 'image_width' is missing");
        row("an impossible lens", changed("501.0", "1e300"), "no lens has a focal length of");
        row("an impossible centre", changed("240.", "-1e6"), "is far outside the image of 640 × 480 pixels");
        row("nul", QByteArray("a\0b", 3), "it is not a UTF-8 text file");
    }
    void refusesHostileFiles()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const auto read = readIntrinsics(write(text));
        QVERIFY(!read.has_value());
        QCOMPARE(read.error().code, ErrorCode::InvalidInput);
        QVERIFY2(read.error().message().find(message.toStdString()) != std::string::npos,
                 read.error().message().c_str());
    }
    void survivesMutations()
    {
        std::mt19937 random(11);
        const QByteArray alphabet("[]{}:,-#'\"! \n\t0.e%&*\xff");
        for (int i = 0; i < 3000; ++i) {
            QByteArray text = rosFile;
            for (int n = 0; n < 1 + i % 5; ++n)
                text[qsizetype(random() % std::size_t(text.size()))] =
                    alphabet[qsizetype(random() % std::size_t(alphabet.size()))];
            const qsizetype length = qsizetype(random() % std::size_t(text.size())) + 1;
            const auto read = parseCalibration("camera.yaml", text.left(length).toStdString());
            QVERIFY(read.has_value() || !read.error().message().empty());
        }
    }

    void readsRealFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("fx");
        QTest::addColumn<double>("error");
        QTest::newRow("ROS") << QStringLiteral("cap-two-views/A.yaml") << 1681.598388671875 << -1.0;
        QTest::newRow("OpenCV, stereo sample") << QStringLiteral("chessboard-stereo/left_intrinsics.yml")
                                               << 535.91573396163199 << 0.39259098975581364;
        QTest::newRow("OpenCV, ChArUco") << QStringLiteral("charuco-stills/tutorial_camera_charuco.yml")
                                         << 452.51072219637672 << 0.18234905535936044;
    }
    void readsRealFiles()
    {
        QFETCH(QString, name);
        QFETCH(double, fx);
        QFETCH(double, error);
        const QString file = realFile(name.toLatin1().constData());
        if (!QFile::exists(file))
            QSKIP("the real material is not here (ODOGRAPH_REAL_DATA)");
        const auto read = readCalibrationFile(file.toStdString());
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        QCOMPARE(read->intrinsics.fxPx, fx);
        QCOMPARE(read->intrinsics.distortion.size(), std::size_t(5));
        QCOMPARE(read->reprojectionPx.value_or(-1), error);
    }

private:
    std::filesystem::path write(const QByteArray &text)
    {
        QFile file(m_folder.filePath(QStringLiteral("camera.yaml")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the test's file");
        return file.fileName().toStdString();
    }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestCalibrationFile, QCoreApplication)
#include "tst_calibration_file.moc"
