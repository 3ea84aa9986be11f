#include "widgets/pages/appearance_page.h"

#include "document/settings/settings.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/theme/theme.h"

#include <QLabel>
#include <QVBoxLayout>

namespace ductus {

AppearancePage::AppearancePage(Settings &settings, QWidget *parent) : QWidget(parent)
{
    auto *heading = new QLabel(tr("Theme"));
    heading->setProperty("heading", true);
    auto *choice =
        new SegmentedSwitch(tr("Theme"),
                            {{tr("As the system"), tr("Dark or light, as the rest of your desktop.")},
                             {tr("Dark"), tr("Lets pictures and strokes stand out.")},
                             {tr("Light"), tr("Easier to read in bright rooms and on projectors.")}},
                            false);
    choice->setCurrent(int(themeChoice(settings)));
    connect(choice, &SegmentedSwitch::currentChanged, this,
            [&settings](int index) { setThemeChoice(settings, ThemeChoice(index)); });
    auto *note = new QLabel(tr("Pictures you export do not depend on it."));
    note->setProperty("dim", true);
    note->setWordWrap(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(heading);
    layout->addWidget(choice, 0, Qt::AlignLeft);
    layout->addWidget(note);
    layout->addStretch(1);
}

} // namespace ductus
