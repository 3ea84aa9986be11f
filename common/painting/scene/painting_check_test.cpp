#include "painting/scene/painting_check.h"

#include <QtTest>
#include <functional>

using namespace ductus;

namespace {

Painting sound()
{
    Painting painting;
    const auto shape =
        std::make_shared<const ElementShape>(StrokeShape{StrokeSection::Round, {PaintedPoint{}}});
    Stack stack;
    stack.id = StackId{1};
    stack.substrate.emplace();
    stack.substrate->id = LayerId{2};
    stack.substrate->drawings[0].elements = {{ElementId{3}, {}, shape}, {ElementId{4}, {}, shape}};
    stack.appearance.resize(1);
    stack.appearance[0].id = LayerId{5};
    stack.appearance[0].properties.masks = {{true, false, GradientMask{}},
                                            {true, true, NoiseMask{}},
                                            {true, false, StrokeMask{LayerId{2}, false}}};
    painting.stacks.push_back(stack);
    painting.nextId = 6;
    return painting;
}

using Change = std::function<void(Painting &)>;

struct Fault
{
    const char *name;
    Change change;
};

Element &element(Painting &painting)
{
    return painting.stacks[0].substrate->drawings[0].elements[0];
}

Layer &appearance(Painting &painting)
{
    return painting.stacks[0].appearance[0];
}

template <typename T>
T &mask(Painting &painting, std::size_t index)
{
    return std::get<T>(appearance(painting).properties.masks[index].shape);
}

void replacePoint(Painting &painting, const std::function<void(PaintedPoint &)> &change)
{
    StrokeShape shape = std::get<StrokeShape>(*element(painting).shape);
    change(shape.points[0]);
    element(painting).shape = std::make_shared<const ElementShape>(shape);
}

const std::vector<Fault> faults{
    {"id not below next", [](Painting &p) { p.nextId = 5; }},
    {"id twice", [](Painting &p) { element(p).id = ElementId{4}; }},
    {"id across kinds", [](Painting &p) { appearance(p).id = LayerId{3}; }},
    {"invalid id", [](Painting &p) { element(p).id = ElementId{}; }},
    {"no substrate", [](Painting &p) { p.stacks[0].substrate.reset(); }},
    {"scene substrate", [](Painting &p) { p.sceneStack.substrate.emplace(); }},
    {"stack as scene", [](Painting &p) { p.stacks[0].id = sceneStackId; }},
    {"opacity", [](Painting &p) { appearance(p).properties.opacity = std::nan(""); }},
    {"colour", [](Painting &p) { appearance(p).properties.colour = Eigen::Vector3f(0, 2, 0); }},
    {"tolerance", [](Painting &p) { appearance(p).tolerance = -0.1; }},
    {"substrate blend", [](Painting &p) { p.stacks[0].substrate->properties.blendMode = BlendMode::Add; }},
    {"substrate mask", [](Painting &p) { p.stacks[0].substrate->properties.masks.push_back({}); }},
    {"no drawing", [](Painting &p) { appearance(p).drawings.clear(); }},
    {"frame", [](Painting &p) { appearance(p).frames.drawingOfFrame = {1}; }},
    {"no frame", [](Painting &p) { appearance(p).frames.drawingOfFrame = {}; }},
    {"frame rate", [](Painting &p) { appearance(p).frames.framesPerSecond = 0; }},
    {"key order",
     [](Painting &p) {
         appearance(p).motion = {{2, {}, {}}, {1, {}, {}}};
     }},
    {"gradient", [](Painting &p) { mask<GradientMask>(p, 0).end = mask<GradientMask>(p, 0).start; }},
    {"noise", [](Painting &p) { mask<NoiseMask>(p, 1).cellSize = 0; }},
    {"stroke mask", [](Painting &p) { mask<StrokeMask>(p, 2).layer = LayerId{99}; }},
    {"self mask", [](Painting &p) { mask<StrokeMask>(p, 2).layer = LayerId{5}; }},
    {"texture",
     [](Painting &p) {
         appearance(p).properties.masks[0].shape = TextureMask{{}, 2, 2, 2, nullptr};
     }},
    {"placement", [](Painting &p) { element(p).placement.scale = 0; }},
    {"rotation", [](Painting &p) { element(p).placement.rotation.coeffs() *= 2; }},
    {"no shape", [](Painting &p) { element(p).shape.reset(); }},
    {"width", [](Painting &p) { replacePoint(p, [](PaintedPoint &q) { q.halfWidth = -1; }); }},
    {"point", [](Painting &p) { replacePoint(p, [](PaintedPoint &q) { q.position[1] = INFINITY; }); }},
    {"point colour", [](Painting &p) { replacePoint(p, [](PaintedPoint &q) { q.colour[0] = 1.5f; }); }},
    {"look",
     [](Painting &p) {
         p.looks.push_back({LookId{p.nextId++}, "", {{LayerId{99}, {}}}});
     }},
    {"look twice",
     [](Painting &p) {
         p.looks.push_back({LookId{p.nextId++}, "", {{LayerId{5}, {}}, {LayerId{5}, {}}}});
     }},
    {"group",
     [](Painting &p) {
         p.motionGroups.push_back({MotionGroupId{p.nextId++}, "", {ElementId{99}}, {}});
     }},
    {"picture",
     [](Painting &p) {
         p.pictures.push_back({PictureId{p.nextId++}, "", true, 1, {}, nullptr});
     }},
    {"unit", [](Painting &p) { p.metresPerUnit = 0; }},
    {"loop", [](Painting &p) { p.loopSeconds = -1; }},
    {"background", [](Painting &p) { p.background[2] = -0.5f; }},
    {"camera",
     [](Painting &p) {
         p.camera.keys.push_back({0, Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity(), 180, {}});
     }},
};

} // namespace

class PaintingCheckTest : public QObject
{
    Q_OBJECT
private slots:
    void acceptsWhatIsSound();
    void findsEveryFault_data();
    void findsEveryFault();
};

void PaintingCheckTest::acceptsWhatIsSound()
{
    QVERIFY(checkPainting({}).ok());
    const auto check = checkPainting(sound());
    QVERIFY2(check.ok(), check.ok() ? "" : check.error().message().c_str());
}

void PaintingCheckTest::findsEveryFault_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < faults.size(); ++i)
        QTest::newRow(faults[i].name) << int(i);
}

void PaintingCheckTest::findsEveryFault()
{
    QFETCH(int, index);
    Painting painting = sound();
    faults[std::size_t(index)].change(painting);
    const auto check = checkPainting(painting);
    QVERIFY(!check.ok());
    QVERIFY(!check.error().problem.empty());
}

QTEST_APPLESS_MAIN(PaintingCheckTest)
#include "painting_check_test.moc"
