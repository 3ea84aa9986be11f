// Rows of the layer tree under the mouse: dragged to other places, hovered. The document follows, and undo.
#include "layerpainter/ui/panels/layer_tree.h"

#include <QDropEvent>
#include <QMimeData>
#include <QScrollBar>
#include <QSignalSpy>
#include <QtTest>

using namespace ductus;

namespace {

/// Qt delivers drops only to where its own drags come from.
class DroppableTree : public LayerTree
{
public:
    using LayerTree::dropEvent;
    using LayerTree::LayerTree;
};

} // namespace

class LayerTreeTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void aLayerGoesToAnotherStack();
    void aLayerGoesUnderAnother();
    void aStackGoesBehindAnother();
    void theSceneStaysWhereItIs();
    void hoveringTellsTheLayer();
    void findsRowsByAPartOfTheirNames();
    void hidingALayerLeavesTheListWhereItIs();

private:
    QTreeWidgetItem *row(const QString &name) const
    {
        const auto found = mTree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    /// What a drag of the mouse ends in.
    void drop(const QString &dragged, const QString &target)
    {
        mTree->setCurrentItem(row(dragged));
        const QPointF at = mTree->visualItemRect(row(target)).center();
        QMimeData data;
        QDropEvent event(at, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
        mTree->dropEvent(&event);
    }
    QStringList layers(int stack) const
    {
        QStringList names;
        for (const Layer &layer : mDocument->painting().stacks[std::size_t(stack)].appearance)
            names << QString::fromStdString(layer.name);
        return names;
    }
    QStringList stacks() const
    {
        QStringList names;
        for (const Stack &stack : mDocument->painting().stacks)
            names << QString::fromStdString(stack.name);
        return names;
    }

    std::unique_ptr<PaintingDocument> mDocument;
    std::unique_ptr<DroppableTree> mTree;
};

void LayerTreeTest::init()
{
    mTree.reset();
    mDocument = std::make_unique<PaintingDocument>();
    mDocument->start({}, "test");
    for (const char *stack : {"Tree", "Ground"}) {
        const auto made = mDocument->perform(act::AddStack{stack});
        QVERIFY(made.ok());
        for (const char *layer : {" light", " shade"})
            QVERIFY(mDocument->perform(act::AddLayer{StackId{made->at(0)}, std::string(stack) + layer}).ok());
    }
    mTree = std::make_unique<DroppableTree>(*mDocument);
    mTree->resize(280, 400);
    mTree->show();
    QVERIFY(QTest::qWaitForWindowExposed(mTree.get()));
}

void LayerTreeTest::aLayerGoesToAnotherStack()
{
    drop("Tree shade", "Ground");
    QCOMPARE(layers(0), QStringList({"Tree light"}));
    QCOMPARE(layers(1), QStringList({"Ground light", "Ground shade", "Tree shade"}));
    QCOMPARE(row("Tree shade")->parent(), row("Ground")); // the rows have followed
    mDocument->undoStack()->undo();
    QCOMPARE(layers(0), QStringList({"Tree light", "Tree shade"}));
    QCOMPARE(row("Tree shade")->parent(), row("Tree"));
}

void LayerTreeTest::aLayerGoesUnderAnother()
{
    drop("Tree shade", "Ground light");
    QCOMPARE(layers(1), QStringList({"Tree shade", "Ground light", "Ground shade"}));
    drop("Ground shade", "Tree shade");
    QCOMPARE(layers(1), QStringList({"Ground shade", "Tree shade", "Ground light"}));
}

void LayerTreeTest::aStackGoesBehindAnother()
{
    QCOMPARE(stacks(), QStringList({"Tree", "Ground"}));
    drop("Ground", "Tree");
    QCOMPARE(stacks(), QStringList({"Ground", "Tree"}));
    QCOMPARE(layers(0), QStringList({"Ground light", "Ground shade"}));
    mDocument->undoStack()->undo();
    QCOMPARE(stacks(), QStringList({"Tree", "Ground"}));
}

void LayerTreeTest::theSceneStaysWhereItIs()
{
    const int steps = mDocument->undoStack()->count();
    drop("Tree", "Scene");
    drop("Tree", "Tree");
    QCOMPARE(mDocument->undoStack()->count(), steps);
    // Layers may act on the whole scene, though.
    drop("Tree light", "Scene");
    QCOMPARE(mDocument->painting().sceneStack.appearance.size(), std::size_t(1));
}

void LayerTreeTest::hoveringTellsTheLayer()
{
    qRegisterMetaType<LayerId>("ductus::LayerId");
    QSignalSpy hovered(mTree.get(), &LayerTree::layerHovered);
    const auto at = [&](const QString &name) { return mTree->visualItemRect(row(name)).center(); };
    for (const char *name : {"Tree shade", "Ground"}) {
        QMouseEvent move(QEvent::MouseMove, at(name), mTree->viewport()->mapToGlobal(at(name)), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(mTree->viewport(), &move);
        QVERIFY(!hovered.isEmpty());
        const LayerId layer = hovered.takeLast().front().value<LayerId>();
        QCOMPARE(QString::fromStdString(mDocument->painting().findLayer(layer)->name), QString(name));
    }
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(mTree.get(), &leave);
    QVERIFY(!hovered.takeLast().front().value<LayerId>().isValid());
}

void LayerTreeTest::findsRowsByAPartOfTheirNames()
{
    mTree->setFilter("SHADE");
    QVERIFY(!row("Tree")->isHidden() && !row("Ground")->isHidden()); // around what is found
    QVERIFY(!row("Tree shade")->isHidden());
    QVERIFY(row("Tree light")->isHidden());
    QVERIFY(mTree->topLevelItem(0)->isHidden()); // the scene
    mTree->setFilter("ground");
    QVERIFY(row("Tree")->isHidden());
    QVERIFY(!row("Ground light")->isHidden());
    // Rows are made anew with every edit.
    const Stack &tree = mDocument->painting().stacks[0];
    QVERIFY(mDocument->perform(act::LockLayer{tree.substrate->id, true}).ok());
    QVERIFY(row("Tree")->isHidden());
    mTree->setFilter({});
    QVERIFY(!row("Tree")->isHidden() && !mTree->topLevelItem(0)->isHidden());
}

void LayerTreeTest::hidingALayerLeavesTheListWhereItIs()
{
    for (int i = 0; i < 100; ++i)
        QVERIFY(mDocument->perform(act::AddStack{"Stack " + std::to_string(i)}).ok());
    mTree->show();
    QVERIFY(QTest::qWaitForWindowExposed(mTree.get()));
    mTree->setCurrentItem(row("Stack 40"));
    row("Ground")->setExpanded(false);
    QScrollBar *bar = mTree->verticalScrollBar();
    bar->setValue(bar->maximum() / 3);
    const int scrolled = bar->value();
    QVERIFY(scrolled > 0);
    act::SetProperties edit;
    edit.layer = mDocument->painting().stacks[60].substrate->id;
    edit.visible = false;
    QVERIFY(mDocument->perform(edit).ok());
    QCoreApplication::processEvents();
    QCOMPARE(bar->value(), scrolled);
    QVERIFY(!row("Ground")->isExpanded());
    QVERIFY(row("Tree")->isExpanded());
}

QTEST_MAIN(LayerTreeTest)
#include "layer_tree_test.moc"
