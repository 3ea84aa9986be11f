// Edits of layers, elements and looks: what they do, what they refuse, and that any sequence keeps the
// invariants.
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/edit/look_edits.h"
#include "painting/scene/painting_check.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

std::shared_ptr<const ElementShape> stroke(float x, const Eigen::Vector3f &colour = {1, 0, 0})
{
    StrokeShape shape;
    for (int i = 0; i < 3; ++i)
        shape.points.push_back({{x, float(i), 0}, {0, 0, 1}, 0.1f, colour, 1.f});
    return std::make_shared<const ElementShape>(std::move(shape));
}

struct Scene
{
    Painting painting;
    StackId tree, house;
    LayerId treeShape, houseShape, bark, light; // light is in the scene stack
    std::vector<ElementId> strokes;             // two in treeShape, one in bark
};

Scene scene()
{
    Scene s;
    const AddedStack tree = *addStack(s.painting, "tree");
    const AddedStack house = *addStack(tree.painting, "house");
    const AddedLayer bark = *addAppearanceLayer(house.painting, tree.stack, "bark");
    const AddedLayer light = *addAppearanceLayer(bark.painting, sceneStackId, "light");
    const AddedElements shape = *addElements(light.painting, tree.substrate, {stroke(0), stroke(1)});
    const AddedElements mark = *addElements(shape.painting, bark.layer, {stroke(2)});
    s = {mark.painting,   tree.stack, house.stack, tree.substrate,
         house.substrate, bark.layer, light.layer, shape.elements};
    s.strokes.push_back(mark.elements[0]);
    return s;
}

const Element *elementOf(const Painting &painting, ElementId id)
{
    for (const Layer *layer : painting.layers())
        for (const Drawing &drawing : layer->drawings)
            for (const Element &element : drawing.elements)
                if (element.id == id)
                    return &element;
    return nullptr;
}

LayerProperties maskedBy(LayerId layer)
{
    LayerProperties properties;
    properties.masks.push_back({true, false, StrokeMask{layer, true}});
    return properties;
}

QString problemOf(const Result<Painting> &result)
{
    return result.ok() ? QString() : QString::fromStdString(result.error().message());
}

} // namespace

class EditsTest : public QObject
{
    Q_OBJECT
private slots:
    void buildsAScene();
    void leavesTheOldPaintingAlone();
    void reordersAndReparents();
    void movesStrokesBetweenKindsOfLayers();
    void duplicatesShareShapes();
    void transformsComposeAfter();
    void recoloursOnlyTheChosen();
    void refusesLockedLayers();
    void refusesWhatWouldBreakMasks();
    void refusesValuesOutOfRange();
    void forgetsWhatIsGone();
    void looksComeBack();
    void anySequenceKeepsTheInvariants();
};

void EditsTest::buildsAScene()
{
    const Scene s = scene();
    QVERIFY(checkPainting(s.painting).ok());
    QCOMPARE(s.painting.stacks.size(), std::size_t(2));
    QVERIFY(isSubstrate(s.painting, s.treeShape));
    QVERIFY(!isSubstrate(s.painting, s.bark));
    QCOMPARE(s.painting.stackOf(s.light)->id, sceneStackId);
    QCOMPARE(s.painting.layers().size(), std::size_t(4));
    QCOMPARE(s.painting.findLayer(s.treeShape)->elementCount(), 2);
}

void EditsTest::leavesTheOldPaintingAlone()
{
    const Scene s = scene();
    const auto changed = removeElements(s.painting, {s.strokes[0]});
    QVERIFY(changed.ok());
    QVERIFY(elementOf(s.painting, s.strokes[0]));
    QVERIFY(!elementOf(*changed, s.strokes[0]));
    // The copies share what did not change.
    QCOMPARE(elementOf(*changed, s.strokes[1])->shape, elementOf(s.painting, s.strokes[1])->shape);
}

void EditsTest::reordersAndReparents()
{
    const Scene s = scene();
    const auto swapped = moveStack(s.painting, s.house, 0);
    QVERIFY(swapped.ok());
    QCOMPARE(swapped->stacks[0].id, s.house);
    const auto moved = moveLayer(s.painting, s.light, s.tree, 0);
    QVERIFY(moved.ok());
    QCOMPARE(moved->findStack(s.tree)->appearance[0].id, s.light);
    QVERIFY(moved->sceneStack.appearance.empty());
    const auto back = moveLayer(*moved, s.light, s.tree, 1); // after bark
    QCOMPARE(back->findStack(s.tree)->appearance[1].id, s.light);
    QVERIFY(!moveLayer(s.painting, s.treeShape, s.house, 0).ok());
    QVERIFY(!moveStack(s.painting, sceneStackId, 0).ok());
}

void EditsTest::movesStrokesBetweenKindsOfLayers()
{
    const Scene s = scene();
    const auto down = moveElements(s.painting, {s.strokes[2]}, s.treeShape);
    QVERIFY(down.ok());
    QCOMPARE(down->findLayer(s.treeShape)->drawings[0].elements.back().id, s.strokes[2]);
    // Chosen in the wrong order, they keep the painting's.
    const auto up = moveElements(*down, {s.strokes[1], s.strokes[0]}, s.light);
    QVERIFY(up.ok());
    QCOMPARE(up->findLayer(s.light)->drawings[0].elements[0].id, s.strokes[0]);
    QCOMPARE(up->findLayer(s.light)->drawings[0].elements[1].id, s.strokes[1]);
    QVERIFY(checkPainting(*up).ok());
}

void EditsTest::duplicatesShareShapes()
{
    const Scene s = scene();
    const auto copy = duplicateElements(s.painting, {s.strokes[0], s.strokes[2]}, s.light);
    QVERIFY(copy.ok());
    QCOMPARE(copy->elements.size(), std::size_t(2));
    QVERIFY(elementOf(copy->painting, s.strokes[0]));
    QCOMPARE(elementOf(copy->painting, copy->elements[0])->shape, elementOf(s.painting, s.strokes[0])->shape);
    QVERIFY(checkPainting(copy->painting).ok());
}

void EditsTest::transformsComposeAfter()
{
    const Scene s = scene();
    Placement lift;
    lift.translation = {0, 5, 0};
    Placement turn;
    turn.rotation = Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ());
    turn.scale = 2;
    const auto once = transformElements(s.painting, {s.strokes[0]}, lift);
    const auto twice = transformElements(*once, {s.strokes[0]}, turn);
    QVERIFY(twice.ok());
    const Eigen::Vector3d p = elementOf(*twice, s.strokes[0])->placement.matrix() * Eigen::Vector3d(1, 0, 0);
    QVERIFY((p - Eigen::Vector3d(-10, 2, 0)).norm() < 1e-12);
}

void EditsTest::recoloursOnlyTheChosen()
{
    const Scene s = scene();
    const auto copy = duplicateElements(s.painting, {s.strokes[0]}, s.light);
    const auto changed = recolourElements(copy->painting, {s.strokes[0]}, {0, 0.5f, 1});
    QVERIFY(changed.ok());
    const auto colourOf = [&](ElementId id) {
        return std::get<StrokeShape>(*elementOf(*changed, id)->shape).points[1].colour;
    };
    QCOMPARE(colourOf(s.strokes[0]), Eigen::Vector3f(0, 0.5f, 1));
    QCOMPARE(colourOf(copy->elements[0]), Eigen::Vector3f(1, 0, 0)); // shared the shape before
    QVERIFY(!recolourElements(s.painting, {s.strokes[0]}, {0, 2, 0}).ok());
}

void EditsTest::refusesLockedLayers()
{
    const Scene s = scene();
    const Painting locked = *setLayerLocked(s.painting, s.bark, true);
    const Result<Painting> tries[] = {
        removeElements(locked, {s.strokes[2]}),
        moveElements(locked, {s.strokes[2]}, s.light),
        moveElements(locked, {s.strokes[0]}, s.bark),
        transformElements(locked, {s.strokes[2]}, {}),
        recolourElements(locked, {s.strokes[2]}, {0, 0, 0}),
        setLayerProperties(locked, s.bark, {}),
        removeLayer(locked, s.bark),
        removeStack(locked, s.tree),
    };
    for (const Result<Painting> &result : tries) {
        QVERIFY(!result.ok());
        QCOMPARE(result.error().code, ErrorCode::Locked);
        QCOMPARE(result.error().place, std::string("bark"));
    }
    QVERIFY(duplicateElements(locked, {s.strokes[2]}, s.light).ok()); // looking is free
    QVERIFY(renameLayer(locked, s.bark, "rind").ok());
    QVERIFY(removeLayer(*setLayerLocked(locked, s.bark, false), s.bark).ok());
}

void EditsTest::refusesWhatWouldBreakMasks()
{
    const Scene s = scene();
    const auto masked = setLayerProperties(s.painting, s.light, maskedBy(s.bark));
    QVERIFY(masked.ok());
    const auto removed = removeLayer(*masked, s.bark);
    QVERIFY2(problemOf(removed).contains("light"), qPrintable(problemOf(removed)));
    QVERIFY(!removeStack(*masked, s.tree).ok());
    // A mask that a look would bring back counts too.
    const AddedLook look = addLook(*masked, "night");
    const auto cleared = setLayerProperties(look.painting, s.light, {});
    QVERIFY(cleared.ok());
    QVERIFY(!removeLayer(*cleared, s.bark).ok());
    QVERIFY(removeLayer(*removeLook(*cleared, look.look), s.bark).ok());
    QVERIFY(!setLayerProperties(s.painting, s.light, maskedBy(s.light)).ok());
    QVERIFY(!setLayerProperties(s.painting, s.light, maskedBy(LayerId{999})).ok());
}

void EditsTest::refusesValuesOutOfRange()
{
    const Scene s = scene();
    LayerProperties properties;
    properties.opacity = 1.5;
    QVERIFY(!setLayerProperties(s.painting, s.bark, properties).ok());
    properties = {};
    properties.blendMode = BlendMode::Overlay;
    QVERIFY(setLayerProperties(s.painting, s.bark, properties).ok());
    QVERIFY(!setLayerProperties(s.painting, s.treeShape, properties).ok());
    QVERIFY(!setTolerance(s.painting, s.bark, -1, ToleranceMode::Surface).ok());
    QVERIFY(!setTolerance(s.painting, s.bark, std::nan(""), ToleranceMode::Surface).ok());
    QVERIFY(!setLayerMotion(s.painting, s.bark, {{1, {}, {}}, {1, {}, {}}}).ok());
    QVERIFY(setLayerMotion(s.painting, s.bark, {{1, {}, {}}, {2, {}, {}}}).ok());
    Placement none;
    none.scale = 0;
    QVERIFY(!transformElements(s.painting, {s.strokes[0]}, none).ok());
    none.scale = 1e300;
    const auto large = transformElements(s.painting, {s.strokes[0]}, none);
    QVERIFY(large.ok());
    QVERIFY(!transformElements(*large, {s.strokes[0]}, none).ok());
    QVERIFY(!addElements(s.painting, s.bark, {nullptr}).ok());
    QVERIFY(!addElements(s.painting, s.bark, {std::make_shared<const ElementShape>(StrokeShape{})}).ok());
    QVERIFY(!addElements(s.painting, s.bark, {stroke(0)}, 1).ok());
    QVERIFY(!addElements(s.painting, LayerId{999}, {stroke(0)}).ok());
    QVERIFY(!removeElements(s.painting, {ElementId{999}}).ok());
}

void EditsTest::forgetsWhatIsGone()
{
    Scene s = scene();
    s.painting.motionGroups.push_back(
        {MotionGroupId{s.painting.nextId++}, "plane", {s.strokes[0], s.strokes[2]}, {}});
    const AddedLook look = addLook(s.painting, "day");
    const auto without = removeElements(look.painting, {s.strokes[0]});
    QCOMPARE(without->motionGroups[0].elements, std::vector<ElementId>{s.strokes[2]});
    const auto removed = removeStack(*without, s.tree);
    QVERIFY(removed.ok());
    QVERIFY(removed->motionGroups[0].elements.empty());
    QCOMPARE(removed->looks[0].layers.size(), std::size_t(2));
    QVERIFY2(checkPainting(*removed).ok(), "references to what is gone");
}

void EditsTest::looksComeBack()
{
    const Scene s = scene();
    const AddedLook day = addLook(s.painting, "day");
    LayerProperties dark;
    dark.blendMode = BlendMode::Multiply;
    dark.opacity = 0.5;
    dark.colour = Eigen::Vector3f(0, 0, 0.5f);
    const auto evening = setLayerProperties(day.painting, s.light, dark);
    const AddedLook night = addLook(*evening, "night");
    const AddedLayer later = *addAppearanceLayer(night.painting, s.house, "later");
    const auto back = applyLook(later.painting, day.look);
    QVERIFY(back.ok());
    QCOMPARE(back->findLayer(s.light)->properties.blendMode, BlendMode::Normal);
    QVERIFY(!back->findLayer(s.light)->properties.colour);
    const auto again = applyLook(*back, night.look);
    QCOMPARE(again->findLayer(s.light)->properties.opacity, 0.5);
    QCOMPARE(*again->findLayer(s.light)->properties.colour, Eigen::Vector3f(0, 0, 0.5f));
    const auto updated = updateLook(*again, day.look);
    QCOMPARE(updated->findLook(day.look)->layers.size(), std::size_t(5));
    QVERIFY(!applyLook(*updated, LookId{999}).ok());
}

void EditsTest::anySequenceKeepsTheInvariants()
{
    int accepted = 0, refused = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        Painting painting = scene().painting;
        for (int step = 0; step < 200; ++step) {
            const auto layers = painting.layers();
            const LayerId layer = layers[std::size_t(random.index(int(layers.size())))]->id;
            const StackId stack{
                random.index(3) == 0 || painting.stacks.empty()
                    ? 0
                    : painting.stacks[std::size_t(random.index(int(painting.stacks.size())))].id.value};
            std::vector<ElementId> some;
            for (const Layer *l : layers)
                for (const Element &element : l->drawings[0].elements)
                    if (random.index(6) == 0)
                        some.push_back(element.id);
            Result<Painting> next = painting;
            switch (random.index(13)) {
            case 0:
                next = addStack(painting, "s", random.index(4))->painting;
                break;
            case 1:
                next = addAppearanceLayer(painting, stack, "l", random.index(4))->painting;
                break;
            case 2:
                next = removeLayer(painting, layer);
                break;
            case 3:
                next = moveLayer(painting, layer, stack, random.index(4));
                break;
            case 4:
                next = moveStack(painting, stack, random.index(4));
                break;
            case 5:
                next = random.index(4) == 0 ? removeStack(painting, stack) : next;
                break;
            case 6:
                next = setLayerProperties(
                    painting, layer, maskedBy(layers[std::size_t(random.index(int(layers.size())))]->id));
                break;
            case 7:
                next = moveElements(painting, some, layer);
                break;
            case 8:
                if (auto copy = duplicateElements(painting, some, layer); copy.ok())
                    next = copy->painting;
                break;
            case 9:
                next = random.index(3) == 0 ? removeElements(painting, some) : next;
                break;
            case 10:
                next = addLook(painting, "look").painting;
                break;
            case 11:
                next = painting.looks.empty() ? next : applyLook(painting, painting.looks[0].id);
                break;
            default:
                next = setLayerLocked(painting, layer, random.index(3) == 0);
                break;
            }
            if (!next.ok()) {
                ++refused;
                QVERIFY(!next.error().problem.empty() && !next.error().remedy.empty());
                continue;
            }
            ++accepted;
            painting = *next;
            const auto check = checkPainting(painting);
            QVERIFY2(check.ok(), check.ok() ? "" : check.error().message().c_str());
            if (painting.layers().empty())
                break;
        }
    }
    QVERIFY(accepted > 1000);
    QVERIFY(refused > 100);
}

QTEST_APPLESS_MAIN(EditsTest)
#include "edits_test.moc"
