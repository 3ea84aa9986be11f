#include "widgets/controls/track_slider.h"
#include "widgets/shell/control_keys.h"
#include "widgets/testing/widget_test_main.h"

#include <QCheckBox>
#include <QComboBox>
#include <QShortcut>
#include <QSignalSpy>
#include <QVBoxLayout>

using namespace ductus;

class ControlKeysTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void aChoiceIsMadeByArrows();
    void aSliderStepsAndResets();
    void spaceBelongsToTheButtonOneTabbedTo();
    void elsewhereTheWindowHasItsKeys();
    void cleanup() { mWindow.reset(); }

private:
    int heard(int key) const { return mHeard.value(key); }
    std::unique_ptr<QWidget> mWindow;
    QComboBox *mChoice = nullptr;
    QCheckBox *mCheck = nullptr;
    TrackSlider *mSlider = nullptr;
    QHash<int, int> mHeard;
};

void ControlKeysTest::init()
{
    mHeard.clear();
    mWindow = std::make_unique<QWidget>();
    auto *layout = new QVBoxLayout(mWindow.get());
    mChoice = new QComboBox;
    mChoice->addItems({"One", "Two", "Three"});
    mCheck = new QCheckBox("Check");
    mSlider = new TrackSlider;
    mSlider->setFocusPolicy(Qt::StrongFocus);
    for (QWidget *control : std::initializer_list<QWidget *>{mChoice, mCheck, mSlider})
        layout->addWidget(control);
    for (const int key : {int(Qt::Key_Down), int(Qt::Key_Right), int(Qt::Key_Space), int(Qt::Key_Delete)})
        connect(new QShortcut(QKeySequence(key), mWindow.get()), &QShortcut::activated, this,
                [this, key] { ++mHeard[key]; });
    new ControlKeys(mWindow.get());
    mWindow->show();
    mWindow->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(mWindow.get()));
}

void ControlKeysTest::aChoiceIsMadeByArrows()
{
    mChoice->setFocus();
    QTest::keyClick(mChoice, Qt::Key_Down);
    QTest::keyClick(mChoice, Qt::Key_Down);
    QCOMPARE(mChoice->currentIndex(), 2);
    QCOMPARE(heard(Qt::Key_Down), 0);
    QTest::keyClick(mChoice, Qt::Key_Right); // of no use to a list of choices
    QCOMPARE(heard(Qt::Key_Right), 1);
}

void ControlKeysTest::aSliderStepsAndResets()
{
    QSignalSpy steps(mSlider, &TrackSlider::stepped), resets(mSlider, &TrackSlider::resetRequested);
    mSlider->setFocus();
    QTest::keyClick(mSlider, Qt::Key_Right);
    QTest::keyClick(mSlider, Qt::Key_Delete);
    QCOMPARE(steps.size(), 1);
    QCOMPARE(resets.size(), 1);
    QCOMPARE(heard(Qt::Key_Right) + heard(Qt::Key_Delete), 0);
}

void ControlKeysTest::spaceBelongsToTheButtonOneTabbedTo()
{
    mCheck->setFocus(Qt::TabFocusReason);
    QTest::keyClick(mCheck, Qt::Key_Space);
    QVERIFY(mCheck->isChecked());
    QCOMPARE(heard(Qt::Key_Space), 0);

    mChoice->setFocus(Qt::TabFocusReason);
    QTest::mouseClick(mCheck, Qt::LeftButton, {}, QPoint(8, mCheck->height() / 2));
    QVERIFY(!mCheck->isChecked() && mCheck->hasFocus());
    QTest::keyClick(mCheck, Qt::Key_Space);
    QVERIFY(!mCheck->isChecked());
    QCOMPARE(heard(Qt::Key_Space), 1);
}

void ControlKeysTest::elsewhereTheWindowHasItsKeys()
{
    mCheck->setFocus(Qt::TabFocusReason);
    QTest::keyClick(mCheck, Qt::Key_Down);
    QCOMPARE(heard(Qt::Key_Down), 1);
    mChoice->setFocus();
    QTest::keyClick(mChoice, Qt::Key_Down, Qt::ControlModifier); // not the key alone
    QCOMPARE(mChoice->currentIndex(), 0);
}

DUCTUS_WIDGET_TEST_MAIN(ControlKeysTest)
#include "control_keys_test.moc"
