// Journeys through the window with real mouse and key events. With DUCTUS_SHOTS naming a folder each step
// leaves a picture there.
#include "layerpainter/ui/panels/mask_list.h"
#include "layerpainter/ui/testing/painter_under_test.h"
#include "widgets/shell/message_bar.h"

#include <QToolButton>
#include <QtTest>
#include <ctime>
#include <numbers>

using namespace ductus;

class PainterWindowTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theStartPageLeadsIntoASample();
    void becomesSmoothWhenItRests();
    void staysFluidWhileTheViewTurns();
    void paintsIntoALayerAndUndoRestoresExactly();
    void hidesALayerByItsEye();
    void switchesLooksByAClick();
    void selectsDuplicatesMovesAndErases();
    void turnsAndScalesByTheGizmo();
    void choosesByALasso();
    void fadesALayerByADrag();
    void masksALayerByNoiseAndStrokes();
    void saysWhichLayersColourAPoint();
    void startsAnEmptyPainting();

private:
    std::unique_ptr<PainterUnderTest> mApp;
};

void PainterWindowTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<PainterUnderTest>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
}

void PainterWindowTest::theStartPageLeadsIntoASample()
{
    QVERIFY(mApp->window->isStartPageShown());
    mApp->shot("01-start");
    QVERIFY(mApp->open("desk-diorama"));
    QVERIFY(!mApp->window->isStartPageShown());
    QVERIFY(mApp->window->painting().painting().stacks.size() > 5);
    QVERIFY2(mApp->window->messages()->messages().isEmpty(), "graphics failed");
    qInfo("a frame takes %.0f ms", mApp->window->view().lastFrameMilliseconds());
    mApp->shot("02-desk");
}

void PainterWindowTest::becomesSmoothWhenItRests()
{
    PaintingView &view = mApp->window->view();
    const QImage rough = view.picture(); // begins anew
    QVERIFY(!view.isSmooth());
    view.setMostSmoothenedMilliseconds(0);
    view.update();
    QTest::qWait(300);
    QVERIFY(!view.isSmooth()); // a frame that took too long stays as it is
    view.setMostSmoothenedMilliseconds(1e6);
    view.update();
    QVERIFY(QTest::qWaitFor([&] { return view.isSmooth(); }, 60'000));
    const QImage smooth = view.grabFramebuffer();
    QVERIFY(view.isSmooth());
    QCOMPARE(smooth.size(), rough.size());
    int roughSteps = 0, smoothSteps = 0, even = 0, changed = 0;
    const auto step = [](QRgb a, QRgb b) { return std::abs(qGray(a) - qGray(b)); };
    for (int y = 1; y + 1 < rough.height(); ++y)
        for (int x = 1; x + 1 < rough.width(); ++x) {
            roughSteps += step(rough.pixel(x, y), rough.pixel(x + 1, y)) > 40;
            smoothSteps += step(smooth.pixel(x, y), smooth.pixel(x + 1, y)) > 40;
            int most = 0;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    most = std::max(most, step(rough.pixel(x, y), rough.pixel(x + i, y + j)));
            even += most == 0;
            changed += most == 0 && step(rough.pixel(x, y), smooth.pixel(x, y)) > 2;
        }
    QVERIFY2(4 * smoothSteps < 3 * roughSteps,
             qPrintable(QString("%1 of %2").arg(smoothSteps).arg(roughSteps)));
    // What has no edge stays as it is.
    QVERIFY2(200 * changed < even, qPrintable(QString("%1 of %2").arg(changed).arg(even)));
    view.camera().orbit({3, 0});
    QVERIFY(!view.isSmooth());
    view.camera().orbit({-3, 0});
}

void PainterWindowTest::staysFluidWhileTheViewTurns()
{
    PaintingView &view = mApp->window->view();
    const QPoint middle = view.rect().center();
    QVERIFY(QTest::qWaitFor([&] { return view.lastFrameDivisor() == 1; }, 5000));
    (void)view.picture(); // once more, nothing to send: what a sharp frame costs
    const double sharp = view.lastFrameMilliseconds();
    std::vector<QPoint> way;
    for (int i = 0; i <= 40; ++i)
        way.push_back(middle + QPoint(4 * i, i));
    const int before = view.frameCount();
    const std::clock_t processor = std::clock();
    QElapsedTimer clock;
    clock.start();
    QTest::mousePress(&view, Qt::RightButton, {}, way.front());
    for (const QPoint &p : way) {
        const int frame = view.frameCount();
        QMouseEvent move(QEvent::MouseMove, p, view.mapToGlobal(p), Qt::NoButton, Qt::RightButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
        QVERIFY(QTest::qWaitFor([&] { return view.frameCount() > frame; }, 5000));
    }
    const int frames = view.frameCount() - before;
    const double last = view.lastFrameMilliseconds();
    const double second = 1e-3 * double(clock.elapsed());
    const double used = double(std::clock() - processor) / CLOCKS_PER_SEC;
    const int divisor = view.lastFrameDivisor();
    qInfo("%d x %d: a sharp frame %.0f ms; turning %.1f frames a second, 1/%d as fine, %.0f ms each, %.0f ms "
          "of processor time",
          view.width(), view.height(), sharp, frames / second, divisor, last, 1000 * used / frames);
    mApp->shot("02-turning");
    // What is met is the same, however coarse: on edges too.
    const std::vector<QPoint> places{middle, middle + QPoint(-331, -61), middle + QPoint(57, 43),
                                     middle + QPoint(140, 120), middle + QPoint(-90, 75)};
    const auto nudge = way.back() + QPoint(1, 0);
    QMouseEvent move(QEvent::MouseMove, nudge, view.mapToGlobal(nudge), Qt::NoButton, Qt::RightButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    QVERIFY(QTest::qWaitFor([&] { return view.lastFrameDivisor() > 1 || divisor == 1; }, 5000));
    std::vector<std::optional<PickedPoint>> coarse;
    for (const QPoint &at : places)
        coarse.push_back(view.pick(at));
    QTest::mouseRelease(&view, Qt::RightButton, {}, nudge);
    QVERIFY(QTest::qWaitFor([&] { return view.lastFrameDivisor() == 1; }, 5000));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto exact = view.pick(places[i]);
        QCOMPARE(exact.has_value(), coarse[i].has_value());
        if (!exact)
            continue;
        QCOMPARE(exact->element.value, coarse[i]->element.value);
        QVERIFY((exact->position - coarse[i]->position).norm() < 1e-3);
    }
    if (sharp > 1.5 * FramePace::targetMilliseconds)
        QVERIFY2(divisor > 1, "slow frames must be drawn coarser while the view turns");
    mApp->press(Qt::Key_F);
}

void PainterWindowTest::paintsIntoALayerAndUndoRestoresExactly()
{
    PainterWindow &window = *mApp->window;
    const Painting &painting = window.painting().painting();
    const auto walls = std::ranges::find(painting.stacks, std::string("Walls"), &Stack::name);
    window.layers().tree().choose(walls->substrate->id);
    const std::string before = mApp->print();
    mApp->press(Qt::Key_L, Qt::ControlModifier);
    const LayerId layer = window.layers().tree().currentLayer();
    QVERIFY(!isSubstrate(window.painting().painting(), layer));
    mApp->press(Qt::Key_B);
    QCOMPARE(window.tool(), PainterTool::Paint);
    const QPoint middle = window.view().rect().center();
    const QImage unpainted = window.view().picture();
    std::vector<QPoint> line;
    for (int x = -330; x <= -180; x += 10)
        line.push_back(middle + QPoint(x, -60 + x / 8));
    mApp->drag(line);
    QCOMPARE(mApp->strokes(layer), 1);
    QVERIFY(QTest::qWaitFor([&] { return window.view().picture() != unpainted; }, 20'000));
    mApp->shot("03-painted");
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(mApp->strokes(layer), 0);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(mApp->print(), before);
    mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(mApp->strokes(layer), 1);
    window.layers().tree().choose(layer);
}

void PainterWindowTest::hidesALayerByItsEye()
{
    LayerTree &tree = mApp->window->layers().tree();
    const LayerId layer = tree.currentLayer();
    const QRect row = tree.visualItemRect(tree.currentItem());
    const QPoint eye(tree.columnViewportPosition(1) + 10, row.center().y());
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, eye);
    QVERIFY(!mApp->window->painting().painting().findLayer(layer)->properties.visible);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, eye);
    QVERIFY(mApp->window->painting().painting().findLayer(layer)->properties.visible);
}

void PainterWindowTest::switchesLooksByAClick()
{
    const QImage day = mApp->window->view().picture();
    for (auto *chip : mApp->window->findChildren<QToolButton *>())
        if (chip->text() == "Night") {
            QTest::mouseClick(chip, Qt::LeftButton);
            break;
        }
    const auto isNightChosen = [&] {
        for (auto *chip : mApp->window->findChildren<QToolButton *>())
            if (chip->text() == "Night" && chip->isVisible() && chip->isChecked())
                return true;
        return false;
    };
    QVERIFY(QTest::qWaitFor(isNightChosen, 5000));
    QVERIFY(QTest::qWaitFor([&] { return mApp->window->view().picture() != day; }, 20'000));
    mApp->shot("04-night");
    QCOMPARE(mApp->window->painting().undoStack()->undoText(), QString("Switch look"));
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return !isNightChosen(); }, 5000));
}

void PainterWindowTest::selectsDuplicatesMovesAndErases()
{
    PainterWindow &window = *mApp->window;
    mApp->press(Qt::Key_V);
    const QPoint middle = window.view().rect().center();
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, middle);
    QCOMPARE(window.view().selection().size(), std::size_t(1));
    mApp->shot("05-selected");
    const LayerId layer = window.layers().tree().currentLayer();
    const int before = mApp->strokes(layer);
    mApp->press(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(mApp->strokes(layer), before + 1);
    QCOMPARE(window.tool(), PainterTool::Move);
    const std::string unmoved = mApp->print();
    mApp->drag({middle, middle + QPoint(20, -10), middle + QPoint(60, -30)});
    QVERIFY(mApp->print() != unmoved);
    mApp->press(Qt::Key_Delete);
    QCOMPARE(mApp->strokes(layer), before);
    QVERIFY(window.view().selection().empty());
}

void PainterWindowTest::turnsAndScalesByTheGizmo()
{
    PainterWindow &window = *mApp->window;
    PaintingView &view = window.view();
    mApp->press(Qt::Key_V);
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    QCOMPARE(view.selection().size(), std::size_t(1));
    mApp->press(Qt::Key_G);
    TransformTool probe(window.painting());
    const std::string before = mApp->print();
    const auto placement = [&] {
        for (const Layer *layer : window.painting().painting().layers())
            for (const Element &element : layer->drawingAt(0).elements)
                if (element.id == view.selection().front())
                    return element.placement;
        return Placement();
    };
    const Placement untouched = placement();
    const Vec3 middle = *probe.centre(view);
    const QPointF at = *view.camera().project(middle);
    // A quarter turn: from the top of the ring to its right.
    const QPoint top = TransformTool::ringHandle(at).toPoint();
    const QPoint right = (at + QPointF(at.y() - top.y(), 0)).toPoint();
    mApp->drag({top, (at + QPointF(45, -45)).toPoint(), right});
    const Eigen::AngleAxisd turned(placement().rotation * untouched.rotation.inverse());
    QVERIFY2(std::abs(turned.angle() - std::numbers::pi / 2) < 0.06,
             qPrintable(QString::number(turned.angle())));
    QVERIFY(std::abs(std::abs(turned.axis().dot(view.camera().forward())) - 1) < 1e-3);
    mApp->shot("05-gizmo");
    // Twice as far out: twice as large, the middle stays.
    const QPointF now = *view.camera().project(*probe.centre(view));
    const QPointF square = TransformTool::scaleHandle(now);
    const Vec3 kept = *probe.centre(view);
    mApp->drag(
        {square.toPoint(), (now + 1.5 * (square - now)).toPoint(), (now + 2 * (square - now)).toPoint()});
    QVERIFY(std::abs(placement().scale / untouched.scale - 2) < 0.05);
    QVERIFY((*probe.centre(view) - kept).norm() < 0.02);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(mApp->print(), before);
    mApp->press(Qt::Key_Escape);
}

void PainterWindowTest::choosesByALasso()
{
    PainterWindow &window = *mApp->window;
    PaintingView &view = window.view();
    const Painting &painting = window.painting().painting();
    const auto plant = std::ranges::find(painting.stacks, std::string("Plant"), &Stack::name);
    window.layers().tree().choose(plant->substrate->id);
    view.setSelection({});
    mApp->press(Qt::Key_V);
    const QRect all = view.rect().adjusted(2, 2, -3, -3);
    // From the upper left corner, where nothing is painted, around everything.
    const QPoint corners[] = {all.topLeft(), all.topRight(), all.bottomRight(), all.bottomLeft()};
    QTest::mousePress(&view, Qt::LeftButton, Qt::ControlModifier, corners[0]);
    for (const QPoint &p : corners) {
        QMouseEvent move(QEvent::MouseMove, p, view.mapToGlobal(p), Qt::NoButton, Qt::LeftButton,
                         Qt::ControlModifier);
        QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::ControlModifier, corners[3]);
    QCOMPARE(int(view.selection().size()), plant->substrate->elementCount());
    mApp->press(Qt::Key_Escape);
    QVERIFY(view.selection().empty());
    const auto outside = std::ranges::find(painting.stacks, std::string("Walls"), &Stack::name);
    window.layers().tree().choose(outside->substrate->id);
    mApp->press(Qt::Key_L, Qt::ControlModifier);
}

void PainterWindowTest::masksALayerByNoiseAndStrokes()
{
    PainterWindow &window = *mApp->window;
    const LayerId layer = window.layers().tree().currentLayer();
    auto *list = window.findChild<MaskList *>();
    QVERIFY(list && list->isVisible());
    const auto masks = [&] { return window.painting().painting().findLayer(layer)->properties.masks; };
    const std::size_t before = masks().size();
    list->addNoise();
    QCOMPARE(masks().size(), before + 1);
    QVERIFY(std::holds_alternative<NoiseMask>(masks().back().shape));
    list->addStrokes(window.painting().painting().stacks[0].substrate->id, false);
    QVERIFY(!std::get<StrokeMask>(masks().back().shape).inside);
    QTest::qWait(50);
    mApp->shot("05-masks");
    // No chip lies on another.
    QList<QRect> places;
    for (QWidget *row : list->findChildren<QWidget *>(Qt::FindDirectChildrenOnly))
        if (row->isVisible() && !row->geometry().isEmpty())
            places << row->geometry();
    for (int i = 0; i < places.size(); ++i)
        for (int j = 0; j < i; ++j)
            QVERIFY(!places[i].intersects(places[j]));
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(masks().size(), before);
}

void PainterWindowTest::fadesALayerByADrag()
{
    PainterWindow &window = *mApp->window;
    const LayerId layer = window.layers().tree().currentLayer();
    mApp->press(Qt::Key_D);
    const QPoint middle = window.view().rect().center();
    mApp->drag({middle + QPoint(-300, 0), middle + QPoint(-200, 0), middle + QPoint(-100, -40)});
    const auto &masks = window.painting().painting().findLayer(layer)->properties.masks;
    QCOMPARE(masks.size(), std::size_t(1));
    QVERIFY(std::holds_alternative<GradientMask>(masks[0].shape));
}

void PainterWindowTest::saysWhichLayersColourAPoint()
{
    PainterWindow &window = *mApp->window;
    mApp->press(Qt::Key_I);
    QCOMPARE(window.tool(), PainterTool::Inspect);
    // Some of these lie in light or shade.
    const QPoint middle = window.view().rect().center();
    int most = 0;
    for (const QPoint &by : {QPoint(-60, 150), QPoint(-90, 190), QPoint(20, 170), QPoint(0, 0)}) {
        window.colourList().hide();
        const auto picked = window.view().pick(middle + by);
        QVERIFY(picked.has_value());
        QTest::mouseClick(&window.view(), Qt::LeftButton, {}, middle + by);
        QVERIFY(QTest::qWaitFor([&] { return window.colourList().isVisible(); }, 20'000));
        // The last row is the shape that was hit.
        const auto rows = window.colourList().findChildren<QToolButton *>();
        QVERIFY(!rows.isEmpty());
        const Stack *stack = window.painting().painting().findStack(picked->stack);
        QVERIFY(rows.last()->text().startsWith(QString::fromStdString(stack->name)));
        most = std::max(most, window.colourList().rowCount());
        if (window.colourList().rowCount() == most)
            mApp->shot("05-colours");
    }
    QVERIFY(most >= 2);
    for (auto *row : window.colourList().findChildren<QToolButton *>())
        if (row->isVisible()) {
            const LayerId layer{row->property("layer").toInt()};
            QTest::mouseClick(row, Qt::LeftButton);
            QCOMPARE(window.brush().layer.value, layer.value);
            break;
        }
    mApp->press(Qt::Key_Escape);
    QVERIFY(!window.colourList().isVisible());
}

void PainterWindowTest::startsAnEmptyPainting()
{
    PainterWindow &window = *mApp->window;
    window.painting().reset(); // nothing to be asked about
    window.newPainting();
    QCOMPARE(window.painting().painting().stacks.size(), std::size_t(1));
    QCOMPARE(window.tool(), PainterTool::Paint);
    const QPoint middle = window.view().rect().center();
    for (int i = 0; i < 3; ++i)
        mApp->drag({middle + QPoint(-200, 60 * i - 60), middle + QPoint(0, 60 * i - 90),
                    middle + QPoint(200, 60 * i - 60)});
    QCOMPARE(mApp->strokes(window.layers().tree().currentLayer()), 3);
    mApp->shot("06-new");
    // The log of it gives the same painting.
    const auto log = parsedLog(window.painting().actionLog(), "log");
    QVERIFY(log.ok());
    const auto again =
        replayed(*log, "log", [](const std::string &) { return Result<Painting>(Painting()); }, {});
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().message().c_str());
    QCOMPARE(paintingFingerprint(*again), mApp->print());
}

QTEST_MAIN(PainterWindowTest)
#include "painter_window_test.moc"
