// "The tree tops shall sway": a layer's row in the timeline is armed, the gizmo drags it at another moment,
// and it moves; keys are set and taken away; all of it by the mouse, undone and redone. And a texture is put
// on as a mask.
#include "layerpainter/ui/panels/key_track.h"
#include "layerpainter/ui/panels/mask_list.h"
#include "layerpainter/ui/panels/motion_tracks.h"
#include "layerpainter/ui/testing/painter_under_test.h"

#include <QToolButton>
#include <utility>

using namespace ductus;

class PainterKeysTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void aDragKeysTheArmedLayer();
    void undoneAndDoneAgain();
    void keysAreSetAndTakenAwayByTheRow();
    void anotherPaintingDisarms();
    void aTextureMasksALayer();

private:
    const Layer &trunks() const { return *mApp->painting().findLayer(mTrunks); }
    QImage picture() { return mApp->window->view().picture(); }
    void click(const QString &name);
    /// The canvas gives way to rows that come: not before it has is there a picture to return to.
    void settle()
    {
        QSize size;
        int same = 0; // rounds of the event loop
        QVERIFY(QTest::qWaitFor(
            [&] {
                const QSize last = std::exchange(size, mApp->window->view().size());
                same = last == size ? same + 1 : 0;
                return same >= 10;
            },
            20'000));
    }
    KeyTrack *track() const;

    std::unique_ptr<PainterUnderTest> mApp;
    LayerId mTrunks;
};

void PainterKeysTest::initTestCase()
{
    mApp = std::make_unique<PainterUnderTest>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    QVERIFY(mApp->open("forest-path"));
    mTrunks = std::ranges::find(mApp->painting().stacks, std::string("Trunks"), &Stack::name)->substrate->id;
}

void PainterKeysTest::click(const QString &name)
{
    for (auto *button : mApp->window->findChildren<QToolButton *>())
        if (button->accessibleName() == name && button->isVisible()) {
            QVERIFY2(button->isEnabled(), qPrintable(name));
            QTest::mouseClick(button, Qt::LeftButton);
            QCoreApplication::processEvents(); // rows made anew go
            return;
        }
    QFAIL(qPrintable("no button " + name));
}

KeyTrack *PainterKeysTest::track() const
{
    for (auto *each : mApp->window->findChildren<KeyTrack *>())
        if (each->accessibleName() == "Keys of Trunks" && each->isVisible())
            return each;
    return nullptr;
}

void PainterKeysTest::aDragKeysTheArmedLayer()
{
    if (!mApp->window->motion().isVisible())
        mApp->press(Qt::Key_T);
    mApp->chooseStack("Trunks");
    QTRY_VERIFY(track() && track()->width() > 100);
    settle();
    const QImage start = picture();
    click("Arm Trunks");
    QTest::mouseClick(track(), Qt::LeftButton, {}, QPoint(track()->width() / 2, track()->height() / 2));
    const double at = mApp->window->view().seconds();
    QVERIFY2(std::abs(at - track()->length() / 2) < 0.1, qPrintable(QString::number(at)));
    mApp->press(Qt::Key_G);
    const QPoint middle = mApp->window->view().rect().center();
    mApp->drag({middle, middle + QPoint(30, 0), middle + QPoint(60, -20)});
    QCOMPARE(trunks().motion.size(), 2u);
    QCOMPARE(trunks().motion[0].timeSeconds, 0.0);
    QCOMPARE(trunks().motion[1].timeSeconds, at);
    QVERIFY(trunks().motion[1].placement.translation.norm() > 0.01);
    const QImage moved = picture();
    QVERIFY(moved != start);
    mApp->shot("20-keyed");
    mApp->window->motion().setSeconds(0);
    QCOMPARE(picture(), start);
    mApp->window->motion().setSeconds(at);
    QCOMPARE(picture(), moved);
}

void PainterKeysTest::undoneAndDoneAgain()
{
    const std::string after = mApp->print();
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(trunks().motion.empty());
    mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(mApp->print(), after);
}

void PainterKeysTest::keysAreSetAndTakenAwayByTheRow()
{
    const double at = trunks().motion[1].timeSeconds;
    mApp->window->motion().setSeconds(at / 2);
    const Placement between = placementAt(trunks().motion, at / 2);
    click("Set key of Trunks");
    QCOMPARE(trunks().motion.size(), 3u);
    QVERIFY(trunks().motion[1].placement.matrix().isApprox(between.matrix()));
    click("Remove key of Trunks");
    QCOMPARE(trunks().motion.size(), 2u);
    mApp->window->motion().setSeconds(at);
    click("Remove key of Trunks");
    QCOMPARE(trunks().motion.size(), 1u);
    for (int i = 0; i < 3; ++i)
        mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(trunks().motion.size(), 2u);
}

void PainterKeysTest::anotherPaintingDisarms()
{
    QVERIFY(mApp->window->view().keyedThing().has_value());
    mApp->window->painting().reset();
    QVERIFY(!mApp->window->view().keyedThing().has_value());
}

void PainterKeysTest::aTextureMasksALayer()
{
    QVERIFY(mApp->open("forest-path"));
    QImage half(8, 8, QImage::Format_Grayscale8);
    half.fill(0);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 4; ++x)
            half.setPixel(x, y, qRgb(255, 255, 255));
    const QString path = mApp->folder.filePath("half.png");
    QVERIFY(half.save(path));
    LayerId layer;
    for (const Stack &stack : mApp->painting().stacks)
        for (const Layer &each : stack.appearance)
            if (each.properties.visible && each.elementCount() > 0)
                layer = each.id;
    QVERIFY(layer.isValid());
    mApp->window->layers().tree().choose(layer);
    settle();
    const QImage before = picture();
    auto *list = mApp->window->findChild<MaskList *>();
    list->addTexture({path});
    const auto &masks = mApp->painting().findLayer(layer)->properties.masks;
    QVERIFY(!masks.empty() && std::holds_alternative<TextureMask>(masks.back().shape));
    QVERIFY(picture() != before);
    mApp->shot("21-texture");
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(picture(), before);
    const std::size_t count = mApp->painting().findLayer(layer)->properties.masks.size();
    list->addTexture({mApp->folder.filePath("none.png")}); // told by a message; nothing changes
    QCOMPARE(mApp->painting().findLayer(layer)->properties.masks.size(), count);
}

QTEST_MAIN(PainterKeysTest)
#include "painter_keys_test.moc"
