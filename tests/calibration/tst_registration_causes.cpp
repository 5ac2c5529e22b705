// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <functional>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int width = 1280, height = 720;

CameraModel lensOf(double focalPx, double k1, const Vector2d &centre)
{
    Intrinsics lens;
    lens.widthPx = width;
    lens.heightPx = height;
    lens.fxPx = focalPx;
    lens.fyPx = 1.002 * focalPx;
    lens.cxPx = centre.x();
    lens.cyPx = centre.y();
    lens.distortion = {k1, -0.3 * k1, 0.0006, -0.0004};
    return CameraModel::create(lens).value();
}

RigidTransform lookAt(const Vector3d &position, const Vector3d &target)
{
    const Vector3d forward = (target - position).normalized();
    const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    return {Eigen::Quaterniond(axes), position};
}

/// A layout, the pixels of its markers, and what is known besides.
struct SetUp
{
    MarkerLayout layout;
    std::vector<MarkerPixel> pixels;
    CameraModel camera;
    RigidTransform pose;
    RegistrationContext context;

    Result<FloorRegistration> registered() const
    {
        return registerFloor(layout, pixels, camera, true, context);
    }
    Vector2d &pixel(std::size_t i) { return pixels[i].pixel; }
    Vector2d &point(std::size_t i) { return layout.markers[i].pointInWorld; }
    template <class Move>
    void move(Move to)
    {
        for (MarkerPixel &marker : pixels)
            marker.pixel = to(marker.pixel);
    }
    void scale(double factor)
    {
        for (Marker &marker : layout.markers)
            marker.pointInWorld *= factor;
    }
    /// Marker i gets the pixel of marker order[i].
    void relabel(const std::vector<std::size_t> &order)
    {
        const auto before = pixels;
        for (std::size_t i = 0; i < order.size(); ++i)
            pixels[i].pixel = before[order[i]].pixel;
    }
    bool isLike(const SetUp &other) const
    {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if ((pixels[i].pixel - other.pixels[i].pixel).norm() > 3 ||
                (layout.markers[i].pointInWorld - other.layout.markers[i].pointInWorld).norm() > 0.01)
                return false;
        }
        return true;
    }
};

enum class Floor { Rectangle, Irregular, Six };

/// A right set-up that people could have: markers over some metres, half a pixel and a millimetre off.
class Draws
{
public:
    explicit Draws(unsigned seed) : m_random(seed) {}

    double between(double least, double most)
    {
        return std::uniform_real_distribution<double>(least, most)(m_random);
    }
    Vector2d noise(double sigma)
    {
        std::normal_distribution<double> normal(0, sigma);
        return {normal(m_random), normal(m_random)};
    }

    SetUp setUp(Floor floor, double noisePx = 0.4)
    {
        static const std::vector<Vector2d> shapes[] = {
            {{0, 0}, {2.4, 0}, {0, 1.8}, {2.4, 1.8}},
            {{0, 0}, {2.4, 0.1}, {-0.3, 1.5}, {2.1, 2.2}},
            {{0, 0}, {2.4, 0.1}, {-0.3, 1.5}, {2.1, 2.2}, {1.3, 0.5}, {0.5, 1.2}}};
        const double size = between(0.8, 1.6);
        for (;;) {
            SetUp drawn{{"floor", {}},
                        {},
                        lensOf(between(700, 1100), between(-0.2, 0.05),
                               Vector2d(width / 2.0, height / 2.0) + noise(8)),
                        {},
                        {}};
            const Vector3d middle = size * Vector3d(1.1, 0.95, 0);
            const double direction = between(0, 2 * EIGEN_PI), away = size * between(1.6, 2.8);
            const Vector3d position =
                middle + Vector3d(away * std::cos(direction), away * std::sin(direction), between(1.4, 2.6));
            drawn.pose = lookAt(position, middle);
            const FloorView view(drawn.camera, drawn.pose, Eigen::Matrix<double, 6, 6>::Zero());
            for (const Vector2d &shape : shapes[static_cast<int>(floor)]) {
                const Vector2d point = size * shape;
                const std::string label(1, static_cast<char>('A' + drawn.pixels.size()));
                const auto pixel = view.pixelFromWorld({point.x(), point.y(), 0});
                if (!pixel || pixel->x() < 5 || pixel->y() < 5 || pixel->x() > width - 6 ||
                    pixel->y() > height - 6)
                    break;
                drawn.layout.markers.push_back({label, point + noise(0.001)});
                drawn.pixels.push_back({label, *pixel + noise(noisePx)});
            }
            if (drawn.pixels.size() == shapes[static_cast<int>(floor)].size() && drawn.registered())
                return drawn;
        }
    }

private:
    std::mt19937 m_random;
};

/// One way to be wrong, what must be said of it, and what somebody does who follows that.
struct Mistake
{
    const char *name;
    std::vector<Floor> floors;
    std::function<void(SetUp &)> make;
    std::string words;
    std::function<void(SetUp &)> follow;
};

void fromBelow(SetUp &s)
{
    s.move([](const Vector2d &p) { return Vector2d(p.x(), height - p.y()); });
}
void swapColumns(SetUp &s)
{
    s.move([](const Vector2d &p) { return Vector2d(p.y(), p.x()); });
}
void mirrorImage(SetUp &s)
{
    s.move([](const Vector2d &p) { return Vector2d(width - 1 - p.x(), p.y()); });
}
void reverseY(SetUp &s)
{
    for (Marker &marker : s.layout.markers)
        marker.pointInWorld.y() *= -1;
}
void resize(SetUp &s, double factor)
{
    s.move([&](const Vector2d &p) -> Vector2d {
        return factor * (p + Vector2d(0.5, 0.5)) - Vector2d(0.5, 0.5);
    });
}
void exchange(SetUp &s, std::size_t i, std::size_t j)
{
    std::swap(s.pixel(i), s.pixel(j));
}
void swapViews(SetUp &s)
{
    // The other camera is registered, and its pixels are given for this one, which is elsewhere.
    const FloorView other(s.camera, s.pose, Eigen::Matrix<double, 6, 6>::Zero());
    s.context.others.push_back({"B", s.camera, other});
    s.camera = lensOf(1.25 * s.camera.intrinsics().fxPx, -0.1, {width / 2.0, height / 2.0});
}

const std::vector<Floor> all{Floor::Rectangle, Floor::Irregular, Floor::Six};
const std::vector<Floor> unlike{Floor::Irregular, Floor::Six};

std::vector<Mistake> mistakes()
{
    const auto times = [](double factor) { return [factor](SetUp &s) { resize(s, factor); }; };
    const auto scaled = [](double factor) { return [factor](SetUp &s) { s.scale(factor); }; };
    return {
        {"v from below", all, fromBelow, "v = 720 - v fits to", fromBelow},
        {"columns", all, swapColumns, "with u and v swapped", swapColumns},
        {"at 1920", all, times(1.5), "at 1920×1080 they fit to", times(1 / 1.5)},
        {"at 640", unlike, times(0.5), "at 640×360 they fit to", times(2)},
        {"mirrored", all, mirrorImage, "is the image mirrored?", mirrorImage},
        {"reversed Y", all, reverseY, "with a reversed Y of the layout", reverseY},
        {"two labels", all, [](SetUp &s) { exchange(s, 1, 2); }, "with B and C swapped they fit to",
         [](SetUp &s) { exchange(s, 1, 2); }},
        {"reversed order", unlike,
         [](SetUp &s) {
             std::vector<std::size_t> order(s.pixels.size());
             for (std::size_t i = 0; i < order.size(); ++i)
                 order[i] = order.size() - 1 - i;
             s.relabel(order);
         },
         "renamed",
         [](SetUp &s) {
             std::vector<std::size_t> order(s.pixels.size());
             for (std::size_t i = 0; i < order.size(); ++i)
                 order[i] = order.size() - 1 - i;
             s.relabel(order);
         }},
        {"begun elsewhere",
         {Floor::Irregular},
         [](SetUp &s) {
             s.relabel({1, 3, 0, 2});
         },
         "renamed",
         [](SetUp &s) {
             s.relabel({2, 0, 3, 1});
         }},
        {"views", all, swapViews, "camera 'B' sees the markers there", {}},
        {"metres", all, scaled(1e-3), "look like metres", scaled(1e3)},
        {"inches", all, scaled(1 / 25.4), "look like inches", scaled(25.4)},
        {"centimetres", all, scaled(0.1), "look like centimetres", scaled(10)},
        {"zoom",
         {Floor::Six},
         [](SetUp &s) {
             s.camera = lensOf(1.5 * s.camera.intrinsics().fxPx, -0.1, {640, 360});
         },
         "has the zoom or the lens changed?",
         {}},
        {"quarter turn", unlike,
         [](SetUp &s) { s.move([](const Vector2d &p) { return Vector2d(height - 1 - p.y(), p.x()); }); },
         "turned by a quarter",
         [](SetUp &s) { s.move([](const Vector2d &p) { return Vector2d(p.y(), height - 1 - p.x()); }); }},
        {"one marker",
         {Floor::Six},
         [](SetUp &s) { s.pixel(4) += Vector2d(60, -45); },
         "without E the others fit to",
         {}},
        {"labels go round the other way",
         {Floor::Rectangle},
         [](SetUp &s) {
             s.relabel({1, 0, 3, 2});
         },
         "with B, A, D, C renamed A, B, C, D they fit to",
         {}},
    };
}

std::string saidOf(const Result<FloorRegistration> &registration)
{
    return registration ? registration->verdict.english() : registration.error().message();
}

bool says(const std::string &words, const std::string &part)
{
    return words.find(part) != std::string::npos;
}

bool isGood(const Result<FloorRegistration> &registration)
{
    return registration && registration->verdict.english().starts_with("Good");
}

/// Whether no more than one cause is named.
bool isSure(const Result<FloorRegistration> &registration)
{
    return registration || registration.error().advice.code() != textOf(Join::Semicolon).code;
}

} // namespace

class TestRegistrationCauses : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theCauseIsNamedAndFollowingItIsSafe()
    {
        int tried = 0, named = 0, several = 0, ledAstray = 0;
        for (unsigned seed = 1; seed <= 4; ++seed) {
            Draws draws(seed);
            for (const Mistake &mistake : mistakes()) {
                const SetUp right = draws.setUp(mistake.floors[seed % mistake.floors.size()]);
                SetUp wrong = right;
                mistake.make(wrong);
                const auto registration = wrong.registered();
                ++tried;
                const bool isNamed = says(saidOf(registration), mistake.words);
                named += isNamed;
                several += !isSure(registration);
                if (!isNamed)
                    qInfo("%s (%u): %s", mistake.name, seed, saidOf(registration).c_str());
                if (isNamed && mistake.follow)
                    mistake.follow(wrong);
                else if (isSure(registration)) {
                    for (const Mistake &other : mistakes()) { // whatever else it said is done
                        if (other.follow && says(saidOf(registration), other.words))
                            other.follow(wrong);
                    }
                }
                const bool isAstray = isGood(wrong.registered()) && mistake.follow && !wrong.isLike(right);
                ledAstray += isAstray;
                if (isAstray)
                    qInfo("%s (%u) led astray: %s", mistake.name, seed, saidOf(registration).c_str());
            }
        }
        qInfo("%d of %d causes named, %d with others that fit as well; %d led astray", named, tried, several,
              ledAstray);
        QVERIFY(tried >= 60);
        QVERIFY(named >= 0.95 * tried);
        QCOMPARE(ledAstray, 0);
    }
    void rightSetUpsAreAccepted()
    {
        Draws draws(77);
        for (int i = 0; i < 60; ++i) {
            const auto registration = draws.setUp(all[static_cast<std::size_t>(i % 3)], 0.5).registered();
            QVERIFY2(!says(saidOf(registration), "Uncertain"), saidOf(registration).c_str());
        }
    }
    void aMirroredFloorIsNeverGood()
    {
        // v from below and the labels the other way round fit together, upside down.
        int doubted = 0;
        for (unsigned seed = 1; seed <= 12; ++seed) {
            SetUp wrong = Draws(seed).setUp(Floor::Rectangle, 0.2);
            fromBelow(wrong);
            wrong.relabel({1, 0, 3, 2});
            const auto registration = wrong.registered();
            if (!registration) // the centre of the lens is too far from the image's
                continue;
            ++doubted;
            QVERIFY2(says(saidOf(registration), "Uncertain: 4 markers fit"), saidOf(registration).c_str());
            QVERIFY2(says(saidOf(registration), "The camera would be upside down; if it is not, v is counted "
                                                "from below, and the labels are mirrored."),
                     saidOf(registration).c_str());
            wrong.context.isSeenInImage = true; // then v is what it is
            QVERIFY(!says(saidOf(wrong.registered()), "Uncertain"));
        }
        QVERIFY(doubted >= 6);
    }
    void anImageHasNoOtherConventions()
    {
        SetUp wrong = Draws(5).setUp(Floor::Irregular, 0.2);
        fromBelow(wrong);
        wrong.context.isSeenInImage = true;
        QVERIFY(!says(saidOf(wrong.registered()), "v = 720"));
    }
    void whatIsOutsideTheImageIsNamed()
    {
        SetUp wrong = Draws(3).setUp(Floor::Irregular, 0.2);
        wrong.pixel(1) = {1514, 300};
        QVERIFY2(says(saidOf(wrong.registered()), "u = 1514 of marker B is outside the image of 1280×720"),
                 saidOf(wrong.registered()).c_str());
        wrong.pixel(1) = {640, -300};
        QVERIFY(says(saidOf(wrong.registered()), "v = -300 of marker B is outside the image of 1280×720"));
    }
    void pixelsOfAnotherCameraAreNoticed()
    {
        SetUp wrong = Draws(4).setUp(Floor::Irregular, 0.2);
        wrong.context.others.push_back(
            {"B", wrong.camera, FloorView(wrong.camera, wrong.pose, Eigen::Matrix<double, 6, 6>::Zero())});
        QVERIFY2(says(saidOf(wrong.registered()), "Camera 'B' sees the markers at the same pixels (to 0."),
                 saidOf(wrong.registered()).c_str());
        QVERIFY(says(saidOf(wrong.registered()), "check that the views are not swapped."));
    }
};

ODOGRAPH_TEST(TestRegistrationCauses, QCoreApplication)
#include "tst_registration_causes.moc"
