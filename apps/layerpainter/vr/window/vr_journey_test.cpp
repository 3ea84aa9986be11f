// A painter in a headset that is not there: everything a session needs, by hands alone.
#include "document/document_files.h"
#include "layerpainter/vr/testing/headset_under_test.h"
#include "painting/action/action_log.h"
#include "widgets/controls/number_slider.h"
#include "widgets/controls/track_slider.h"

#include <QAbstractButton>

using namespace ductus;

namespace {

const Layer &substrate(const HeadsetUnderTest &test)
{
    return *test.painting().stacks.back().substrate;
}

const StrokeShape &strokeOf(const Layer &layer)
{
    return std::get<StrokeShape>(*layer.drawings[0].elements.back().shape);
}

} // namespace

class VrJourneyTest : public QObject
{
    Q_OBJECT
private slots:
    void aPaintingIsMadeByHandsAlone_data();
    void aPaintingIsMadeByHandsAlone();

private:
    void paint(HeadsetUnderTest &test);
    void grab(HeadsetUnderTest &test);
    void layers(HeadsetUnderTest &test);
    void colours(HeadsetUnderTest &test);
    void saveAndOpen(HeadsetUnderTest &test);
};

void VrJourneyTest::aPaintingIsMadeByHandsAlone_data()
{
    QTest::addColumn<bool>("leftHanded");
    QTest::newRow("right-handed") << false;
    QTest::newRow("left-handed") << true;
}

void VrJourneyTest::aPaintingIsMadeByHandsAlone()
{
    QFETCH(bool, leftHanded);
    HeadsetUnderTest test({"size 160 160"});
    test.isLeftHanded = leftHanded;
    test.vr().setLeftHanded(leftHanded);
    test.window->newPainting();
    QVERIFY(test.enter());
    test.vr().tools().setRoomFromScene({});
    test.window->brush().halfWidth = 0.03;
    test.put(test.holder(), test.mirrored({-0.15, 0.95, -0.45}));
    QVERIFY(test.frames());
    for (auto part : {&VrJourneyTest::paint, &VrJourneyTest::grab, &VrJourneyTest::layers,
                      &VrJourneyTest::colours, &VrJourneyTest::saveAndOpen}) {
        (this->*part)(test);
        if (QTest::currentTestFailed())
            return;
    }
    QCOMPARE(test.record("error"), QStringList());
    QCOMPARE(test.record("mistake"), QStringList());
    QCOMPARE(test.complaints(), QString());
}

// A stroke that grows wider as the trigger is pulled; undone and done again by the stick.
void VrJourneyTest::paint(HeadsetUnderTest &test)
{
    test.put(test.painter(), test.mirrored({0.55, 1.1, -0.6}));
    test.frames();
    test.input(test.trigger(), 0.2);
    test.frames();
    for (int i = 1; i <= 8; ++i) {
        test.put(test.painter(), test.mirrored({0.55, 1.1 + 0.04 * i, -0.6}));
        test.input(test.trigger(), 0.2 + 0.1 * i);
        QVERIFY(test.frames(2));
    }
    QVERIFY(test.vr().tools().isPainting());
    QCOMPARE(substrate(test).elementCount(), 0); // not done yet
    test.input(test.trigger(), 0);
    QVERIFY(test.frames());
    QCOMPARE(substrate(test).elementCount(), 1);
    const StrokeShape &stroke = strokeOf(substrate(test));
    QVERIFY2(stroke.points.size() >= 8, qPrintable(QString::number(stroke.points.size())));
    QVERIFY(std::abs(stroke.points.front().halfWidth - 0.2f * 0.03f) < 1e-4f);
    QVERIFY(std::abs(stroke.points.back().halfWidth - 0.03f) < 1e-4f);
    QVERIFY((stroke.points.back().position.cast<double>() - test.mirrored({0.55, 1.42, -0.6})).norm() < 1e-4);
    test.shot(test.isLeftHanded ? "vr-painted-left" : "vr-painted");

    const QString stick = test.painter() + "/input/thumbstick/x";
    test.input(stick, -1);
    test.frames();
    test.input(stick, 0);
    test.frames();
    QCOMPARE(substrate(test).elementCount(), 0);
    test.click(stick); // to the right
    QCOMPARE(substrate(test).elementCount(), 1);
}

// One hand carries the canvas, two make it larger; the brush stays as it is in the hand.
void VrJourneyTest::grab(HeadsetUnderTest &test)
{
    const Placement before = test.vr().tools().roomFromScene();
    test.input(test.painter() + "/input/squeeze/value", 1);
    test.frames();
    test.put(test.painter(), test.mirrored({0.65, 1.42, -0.7}));
    test.frames();
    const Placement carried = test.vr().tools().roomFromScene();
    QVERIFY((carried.translation - before.translation - test.mirrored({0.1, 0, -0.1})).norm() < 1e-5);
    QCOMPARE(carried.scale, 1.0);

    test.put(test.holder(), test.mirrored({0.25, 1.42, -0.7}));
    test.frames();
    test.input(test.holder() + "/input/squeeze/value", 1);
    test.frames();
    test.put(test.holder(), test.mirrored({-0.15, 1.42, -0.7}));
    test.frames();
    const Placement doubled = test.vr().tools().roomFromScene();
    QVERIFY2(std::abs(doubled.scale - 2) < 1e-4, qPrintable(QString::number(doubled.scale)));
    QVERIFY(std::abs(test.window->brush().halfWidth - 0.015) < 1e-4);
    for (const QString &hand : {test.painter(), test.holder()})
        test.input(hand + "/input/squeeze/value", 0);
    test.frames();
    QVERIFY(test.vr().tools().roomFromScene() == doubled);
    test.vr().tools().setRoomFromScene({});
    test.window->brush().halfWidth = 0.03;
    test.put(test.holder(), test.mirrored({-0.15, 0.95, -0.45}));
    test.frames();
}

// A new layer, and the stroke dragged onto its row.
void VrJourneyTest::layers(HeadsetUnderTest &test)
{
    RoomPanels &panels = test.vr().panels();
    test.bringToFront(RoomPanels::toolPlace);
    QCOMPARE(panels.rig().front(), int(RoomPanels::toolPlace));
    auto *add = panels.rig().panel(RoomPanels::toolPlace).frame().findChild<QAbstractButton *>("layer.add");
    QVERIFY(add);
    test.clickOn(RoomPanels::toolPlace, add);
    QCOMPARE(test.painting().stacks.back().appearance.size(), std::size_t(1));
    QVERIFY(!test.record("haptic " + test.painter()).isEmpty());

    test.click(test.button(test.holder(), true));
    QCOMPARE(test.vr().tools().mode(), HandMode::Select);
    const Vec3 onStroke = test.mirrored({0.55, 1.3, -0.6});
    test.put(test.painter(), onStroke);
    test.frames();
    test.click(test.trigger());
    QCOMPARE(test.window->view().selection().size(), std::size_t(1));

    test.bringToFront(RoomPanels::layerPlace);
    test.put(test.painter(), onStroke);
    test.frames();
    test.input(test.trigger(), 1);
    test.frames();
    LayerTree &tree = panels.layers().tree();
    QTreeWidgetItem *row = nullptr;
    for (QTreeWidgetItemIterator it(&tree); *it; ++it)
        if ((*it)->parent())
            row = *it;
    QVERIFY(row);
    const QPoint in = tree.visualItemRect(row).center() - QPoint(30, 0);
    test.pointAt(RoomPanels::layerPlace, test.placeOf(RoomPanels::layerPlace, tree.viewport(), in));
    QVERIFY(panels.hoveredLayer().has_value());
    test.shot(test.isLeftHanded ? "vr-carried-left" : "vr-carried");
    test.input(test.trigger(), 0);
    test.frames();
    QCOMPARE(substrate(test).elementCount(), 0);
    QCOMPARE(test.painting().stacks.back().appearance[0].elementCount(), 1);
}

// A colour, a slider, a stroke in the new colour, one deleted and brought back.
void VrJourneyTest::colours(HeadsetUnderTest &test)
{
    RoomPanels &panels = test.vr().panels();
    const auto layer = [&]() -> const Layer & { return test.painting().stacks.back().appearance[0]; };
    NumberSlider *opacity = nullptr;
    for (auto *slider : panels.layers().findChildren<NumberSlider *>())
        if (slider->label() == "Opacity")
            opacity = slider;
    QVERIFY(opacity);
    panels.layers().tree().choose(layer().id);
    test.frames();
    auto *bar = opacity->findChild<TrackSlider *>();
    QVERIFY(bar);
    test.clickOn(RoomPanels::layerPlace, bar, {bar->width() * 3 / 10, bar->height() / 2});
    QVERIFY2(layer().properties.opacity < 0.7, qPrintable(QString::number(layer().properties.opacity)));

    test.bringToFront(RoomPanels::colourPlace);
    auto *field = panels.colours().findChild<ColourField *>();
    QVERIFY(field);
    test.clickOn(RoomPanels::colourPlace, field, {field->width() - 8, field->height() / 3}); // green
    test.clickOn(RoomPanels::colourPlace, field, {field->width() - 45, 6});
    const Eigen::Vector3f colour = test.window->brush().colour;
    QVERIFY(colour.y() > 2 * colour.x() && colour.y() > 2 * colour.z());
    QCOMPARE(test.window->colourPanel().colour(), panels.colours().colour());

    test.bringToFront(RoomPanels::toolPlace);
    auto *recolour =
        panels.rig().panel(RoomPanels::toolPlace).frame().findChild<QAbstractButton *>("edit.recolour");
    test.clickOn(RoomPanels::toolPlace, recolour);
    QVERIFY((strokeOf(layer()).points[2].colour - colour).norm() < 1e-6f);

    // B takes a colour from what is touched.
    test.window->colourPanel().setColour(QColor(10, 20, 200));
    test.put(test.painter(), test.mirrored({0.55, 1.3, -0.6}));
    test.frames();
    test.click(test.button(test.painter(), false));
    QVERIFY((test.window->brush().colour - colour).norm() < 0.02f);

    test.click(test.button(test.painter(), true));
    QCOMPARE(layer().elementCount(), 0);
    const QString stick = test.painter() + "/input/thumbstick/x";
    test.input(stick, -1);
    test.frames();
    test.input(stick, 0);
    test.frames();
    QCOMPARE(layer().elementCount(), 1);
}

// Saved by the panel's button while frames go on; the desktop finds the same painting.
void VrJourneyTest::saveAndOpen(HeadsetUnderTest &test)
{
    const QString path = test.folder.filePath(QString::fromUtf8("Gemälde.ductus"));
    bool isSaved = false;
    saveDocument(test.window->painting(), test.jobs, path,
                 [&](Result<SaveReport> saved) { isSaved = saved.ok(); });
    QVERIFY(test.wait([&] { return isSaved; }));
    test.click(test.button(test.holder(), true)); // paints again
    QCOMPARE(test.vr().tools().mode(), HandMode::Paint);
    test.put(test.painter(), test.mirrored({0.7, 1.0, -0.6}));
    test.frames();
    test.input(test.trigger(), 0.8);
    test.frames();
    test.put(test.painter(), test.mirrored({0.7, 1.0, -0.8}));
    test.frames();
    test.input(test.trigger(), 0);
    test.frames();
    QVERIFY(test.window->painting().isModified());
    auto *save = test.vr()
                     .panels()
                     .rig()
                     .panel(RoomPanels::toolPlace)
                     .frame()
                     .findChild<QAbstractButton *>("file.save");
    test.clickOn(RoomPanels::toolPlace, save);
    QVERIFY(test.wait([&] { return !test.window->painting().isModified(); }));
    Result<OpenedProject> opened = openProjectFile(path, "desktop", true);
    QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().message().c_str());
    PaintingDocument desktop;
    QVERIFY(adoptProject(desktop, std::move(*opened)).ok());
    QCOMPARE(paintingFingerprint(desktop.painting()), paintingFingerprint(test.painting()));

    test.vr().stop();
    QVERIFY(test.wait([&] { return test.endings == 1; }));
    QCOMPARE(test.ended, QString());
    QVERIFY(!test.vr().isActive());
}

QTEST_MAIN(VrJourneyTest)
#include "vr_journey_test.moc"
