// "Ana paints a forest", thesis V.4, in the window by mouse and keys: each step is undone and redone, its
// picture goes to DUCTUS_SHOTS.
#include "layerpainter/ui/testing/painter_under_test.h"

#include <QToolButton>

using namespace ductus;

class PainterStoryTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void sunBeamsOnTheWholeScene();
    void barkOnTheTrunksOnly();
    void treeTopsAsTheirOwnHighlights();
    void purpleOverlayThatFadesTowardsTheViewer();
    void aSecondLook();

private:
    /// What \a acts does can be undone to the bit and done again.
    template <typename Acts>
    void step(const char *name, Acts acts);
    QImage picture() { return mApp->window->view().picture(); }
    QPoint at(double x, double y) const; // shares of the canvas' height from its middle
    const Layer &active() const { return *mApp->painting().findLayer(mApp->window->brush().layer); }
    QToolButton *look(const QString &name) const;

    std::unique_ptr<PainterUnderTest> mApp;
};

template <typename Acts>
void PainterStoryTest::step(const char *name, Acts acts)
{
    QUndoStack &history = *mApp->window->painting().undoStack();
    const int begin = history.index();
    const std::string before = mApp->print();
    const QImage seen = picture();
    acts();
    if (QTest::currentTestFailed())
        return;
    const int steps = history.index() - begin;
    const std::string after = mApp->print();
    QVERIFY(steps > 0);
    QVERIFY(after != before);
    QVERIFY2(picture() != seen, "the step cannot be seen");
    mApp->shot(name);
    for (int i = 0; i < steps; ++i)
        mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(mApp->print(), before);
    QCOMPARE(picture(), seen);
    for (int i = 0; i < steps; ++i)
        mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(mApp->print(), after);
}

QPoint PainterStoryTest::at(double x, double y) const
{
    const QRect canvas = mApp->window->view().rect();
    return canvas.center() + QPoint(qRound(x * canvas.height()), qRound(y * canvas.height()));
}

QToolButton *PainterStoryTest::look(const QString &name) const
{
    for (auto *chip : mApp->window->findChildren<QToolButton *>())
        if (chip->isVisible() && (chip->text() == name || chip->accessibleName() == name))
            return chip;
    return nullptr;
}

void PainterStoryTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<PainterUnderTest>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    QVERIFY(mApp->open("forest-path"));
    mApp->shot("story-0-forest");
}

void PainterStoryTest::sunBeamsOnTheWholeScene()
{
    step("story-1-beams", [&] {
        mApp->chooseStack("Scene");
        mApp->press(Qt::Key_L, Qt::ControlModifier);
        QCOMPARE(mApp->painting().stackOf(active().id)->id.value, sceneStackId.value);
        mApp->chooseColour(QColor(255, 244, 170));
        mApp->type("Opacity", "55");
        mApp->press(Qt::Key_B);
        mApp->type("Size", "0.4");
        for (const double x : {-0.12, 0.12, 0.34})
            mApp->drag({at(x - 0.14, -0.2), at(x - 0.07, 0.0), at(x, 0.16), at(x + 0.06, 0.3)});
        QCOMPARE(active().elementCount(), 3);
    });
}

void PainterStoryTest::barkOnTheTrunksOnly()
{
    const QImage before = picture();
    step("story-2-bark", [&] {
        mApp->chooseStack("Trunks");
        mApp->press(Qt::Key_L, Qt::ControlModifier);
        mApp->type("Reach", "0.08");
        QVERIFY(std::abs(active().tolerance - 0.08) < 1e-6);
        mApp->chooseColour(QColor(214, 170, 120));
        mApp->press(Qt::Key_B);
        mApp->type("Size", "0.02");
        // Loose: some begin and end beside the trunk.
        for (const double x : {-0.585, -0.555, -0.61, 0.425, 0.455, 0.485})
            mApp->drag({at(x, -0.05), at(x + 0.01, 0.05), at(x - 0.01, 0.14), at(x - 0.005, 0.33)});
        QCOMPARE(active().elementCount(), 6);
    });
    // Nothing but trunks has another colour.
    const QImage after = picture();
    const auto trunks = std::ranges::find(mApp->painting().stacks, std::string("Trunks"), &Stack::name);
    int changed = 0;
    for (int y = 0; y < after.height(); y += 3)
        for (int x = 0; x < after.width(); x += 3)
            if (after.pixel(x, y) != before.pixel(x, y)) {
                const auto met = mApp->window->view().pick(QPointF(x, y));
                QVERIFY(met && met->stack == trunks->id);
                ++changed;
            }
    QVERIFY(changed > 20);
}

void PainterStoryTest::treeTopsAsTheirOwnHighlights()
{
    step("story-3-tree-tops", [&] {
        mApp->chooseStack("Leaves");
        const int strokes = active().elementCount();
        mApp->press(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(int(mApp->window->view().selection().size()), strokes);
        mApp->press(Qt::Key_L, Qt::ControlModifier);
        mApp->press(Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(active().elementCount(), strokes);
        QVERIFY(!isSubstrate(mApp->painting(), active().id));
        QCOMPARE(mApp->window->tool(), PainterTool::Move);
        mApp->chooseColour(QColor(236, 226, 120));
        mApp->press(Qt::Key_R, Qt::ControlModifier);
        mApp->drag({at(-0.5, -0.3), at(-0.49, -0.34), at(-0.47, -0.39)});
        mApp->press(Qt::Key_Escape); // nothing chosen any more
        QVERIFY(mApp->window->view().selection().empty());
    });
}

void PainterStoryTest::purpleOverlayThatFadesTowardsTheViewer()
{
    step("story-4-purple", [&] {
        mApp->chooseStack("Scene");
        mApp->press(Qt::Key_L, Qt::ControlModifier);
        mApp->chooseColour(QColor(120, 40, 200));
        mApp->press(Qt::Key_B);
        mApp->type("Size", "9");
        mApp->drag({at(0.0, 0.1), at(0.05, 0.1)});
        QCOMPARE(active().elementCount(), 1);
        mApp->chooseBlend("Overlay");
        QCOMPARE(active().properties.blendMode, BlendMode::Overlay);
        mApp->press(Qt::Key_D);
        mApp->drag({at(0.0, 0.11), at(0.02, 0.2), at(0.05, 0.45)}, Qt::ShiftModifier);
        QCOMPARE(active().properties.masks.size(), std::size_t(1));
        QCOMPARE(std::get<GradientMask>(active().properties.masks[0].shape).shape,
                 GradientMask::Shape::Spherical);
    });
}

void PainterStoryTest::aSecondLook()
{
    QTest::mouseClick(look("Keep this look"), Qt::LeftButton);
    const std::size_t looks = mApp->painting().looks.size();
    const QString dusk = QString::fromStdString(mApp->painting().looks.back().name);
    const QImage purple = picture();
    step("story-5-day", [&] {
        mApp->chooseStack("Scene");
        LayerTree &tree = mApp->window->layers().tree();
        const QRect top = tree.visualItemRect(tree.topLevelItem(0)->child(0)); // the purple layer
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                          {tree.columnViewportPosition(1) + 10, top.center().y()});
        QTest::mouseClick(look("Keep this look"), Qt::LeftButton);
        QCOMPARE(mApp->painting().looks.size(), looks + 1);
    });
    const QImage day = picture();
    QVERIFY(day != purple);
    QVERIFY(look(dusk));
    QTest::mouseClick(look(dusk), Qt::LeftButton);
    QCOMPARE(picture(), purple);
    mApp->shot("story-6-dusk");
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(picture(), day);
}

QTEST_MAIN(PainterStoryTest)
#include "painter_story_test.moc"
