#include "doodlestudio/ui/drawing/drawing_panel.h"

#include "doodlestudio/ui/canvases/mark_painter.h"
#include "doodling/canvas/edit_doodle.h"
#include "doodling/compositing/stickers.h"
#include "widgets/controls/number_slider.h"
#include "widgets/theme/icons.h"

#include <QButtonGroup>
#include <QColorDialog>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

namespace ductus {

namespace {

constexpr double narrowest = 0.002, widest = 0.2; // shares of the canvas
constexpr double wordsPerWidth = 7.0;             // height of a line in widths of the pen
constexpr int mostPicturePixels = 1024;           // of an inserted picture's longer side
constexpr double pictureShare = 0.8;              // of the canvas it fills at first

const std::array<QColor, 10> paletteColours{
    QColor(0xff, 0xff, 0xff), QColor(0x1d, 0x21, 0x26), QColor(0xe5, 0x3e, 0x3e), QColor(0xff, 0x8c, 0x2b),
    QColor(0xff, 0xd5, 0x3d), QColor(0x3f, 0xb6, 0x5f), QColor(0x2f, 0xb8, 0xd0), QColor(0x3c, 0x7c, 0xf0),
    QColor(0x9a, 0x5c, 0xe6), QColor(0xf4, 0x7f, 0xb4)};

QIcon swatch(const QColor &colour)
{
    QPixmap pixmap(40, 40);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(128, 128, 128), 1.0));
    painter.setBrush(colour);
    painter.drawEllipse(QRectF(1.5, 1.5, 17, 17));
    return pixmap;
}

// For the translators: stickerNames() as people call them.
[[maybe_unused]] const char *const stickerWords[] = {
    QT_TRANSLATE_NOOP("ductus::DrawingPanel", "star"),  QT_TRANSLATE_NOOP("ductus::DrawingPanel", "heart"),
    QT_TRANSLATE_NOOP("ductus::DrawingPanel", "check"), QT_TRANSLATE_NOOP("ductus::DrawingPanel", "cross"),
    QT_TRANSLATE_NOOP("ductus::DrawingPanel", "smile"), QT_TRANSLATE_NOOP("ductus::DrawingPanel", "frown"),
    QT_TRANSLATE_NOOP("ductus::DrawingPanel", "ring"),  QT_TRANSLATE_NOOP("ductus::DrawingPanel", "bubble"),
    QT_TRANSLATE_NOOP("ductus::DrawingPanel", "bang"),  QT_TRANSLATE_NOOP("ductus::DrawingPanel", "question"),
    QT_TRANSLATE_NOOP("ductus::DrawingPanel", "bulb"),  QT_TRANSLATE_NOOP("ductus::DrawingPanel", "bolt")};

QIcon stickerIcon(std::string_view name)
{
    QPixmap pixmap(48, 48);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(24, 24);
    painter.scale(44.0 / canvasGrain, 44.0 / canvasGrain);
    StickerMark mark;
    mark.name = std::string(name);
    mark.size = 1.0;
    paintMark(painter, mark);
    return pixmap;
}

} // namespace

DrawingPanel::DrawingPanel(StudioState &state, DrawingHand &hand, QWidget *parent)
    : QWidget(parent), mState(state), mHand(hand)
{
    setAttribute(Qt::WA_StyledBackground);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto *head = new QWidget;
    auto *headRows = new QVBoxLayout(head);
    headRows->setContentsMargins(8, 6, 8, 6);
    headRows->setSpacing(4);
    buildTools(headRows);
    buildColours(headRows);
    layout->addWidget(head);
    mView = new DrawingView(state, hand);
    layout->addWidget(mView, 1);
    mStrip = new FrameStrip(state);
    layout->addWidget(mStrip);
    connect(&state, &StudioState::brushChanged, this, &DrawingPanel::refresh);
    connect(&state, &StudioState::chosenChanged, this, &DrawingPanel::refresh);
    connect(&state, &StudioState::frameChanged, this, &DrawingPanel::refresh);
    connect(&hand, &DrawingHand::textWanted, this, &DrawingPanel::placeWords);
    refresh();
}

void DrawingPanel::buildTools(QVBoxLayout *layout)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(2);
    mTools = new QButtonGroup(this);
    const struct
    {
        DrawingTool tool;
        const char *icon;
        QString name, teaches;
    } tools[] = {
        {DrawingTool::Pen, "draw-freehand", tr("Pen"),
         tr("Draws lines; a pen's pressure makes them wider. (P)")},
        {DrawingTool::Fill, "shape-fill", tr("Filled shape"),
         tr("Draw an outline; what is inside is filled. (G)")},
        {DrawingTool::Arrow, "arrow-mark", tr("Arrow"), tr("Points at something; draw it as you like. (A)")},
        {DrawingTool::Text, "draw-text", tr("Words"),
         tr("Type words, then click where they should stand. (T)")},
        {DrawingTool::Sticker, "sticker", tr("Sticker"),
         tr("Ready-made drawings; drag to say how large. (S)")},
        {DrawingTool::Eraser, "draw-eraser", tr("Eraser"), tr("Takes parts of lines away. (E)")},
        {DrawingTool::Move, "transform-move", tr("Move"), tr("Moves something that was drawn. (V)")}};
    for (const auto &tool : tools) {
        auto *button = new QToolButton;
        button->setIcon(icon(tool.icon));
        button->setIconSize({22, 22});
        button->setFixedSize(34, 34);
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setAccessibleName(tool.name);
        button->setToolTip(QStringLiteral("%1. %2").arg(tool.name, tool.teaches));
        mTools->addButton(button, int(tool.tool));
        row->addWidget(button);
    }
    auto *picture = new QToolButton;
    picture->setObjectName(QStringLiteral("insertPicture"));
    picture->setIcon(icon(QStringLiteral("insert-picture")));
    picture->setIconSize({22, 22});
    picture->setFixedSize(34, 34);
    picture->setAutoRaise(true);
    picture->setAccessibleName(tr("Picture"));
    picture->setToolTip(tr("Picture. Puts a picture from a file on the canvas; move it with V."));
    row->addWidget(picture);
    connect(picture, &QToolButton::clicked, this, &DrawingPanel::choosePicture);
    row->addStretch(1);
    mTitle = new QLabel;
    mTitle->setProperty("dim", true);
    row->addWidget(mTitle);
    layout->addLayout(row);
    connect(mTools, &QButtonGroup::idClicked, this, [this](int id) { setTool(DrawingTool(id)); });

    mWords = new QLineEdit;
    mWords->setObjectName(QStringLiteral("words"));
    mWords->setPlaceholderText(tr("Type words, then click where they should stand"));
    mWords->setAccessibleName(tr("Words"));
    layout->addWidget(mWords);
    connect(mWords, &QLineEdit::textChanged, this, [this](const QString &text) {
        Brush brush = mState.brush();
        brush.text = text;
        mState.setBrush(brush);
    });
    mStickers = new QComboBox;
    mStickers->setAccessibleName(tr("Sticker"));
    mStickers->setIconSize({24, 24});
    for (const std::string_view name : stickerNames()) {
        const QByteArray id(name.data(), qsizetype(name.size()));
        mStickers->addItem(stickerIcon(name), tr(id.constData()), QString::fromLatin1(id));
    }
    layout->addWidget(mStickers);
    const auto takeSticker = [this] {
        Brush brush = mState.brush();
        brush.sticker = mStickers->currentData().toString();
        mState.setBrush(brush);
    };
    connect(mStickers, &QComboBox::currentIndexChanged, this, takeSticker);
    takeSticker();
}

void DrawingPanel::buildColours(QVBoxLayout *layout)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(0);
    mColours = new QButtonGroup(this);
    const QString names[] = {tr("White"), tr("Black"), tr("Red"),  tr("Orange"), tr("Yellow"),
                             tr("Green"), tr("Cyan"),  tr("Blue"), tr("Violet"), tr("Pink")};
    for (std::size_t i = 0; i < paletteColours.size(); ++i) {
        auto *button = new QToolButton;
        button->setIcon(swatch(paletteColours[i]));
        button->setIconSize({20, 20});
        button->setFixedSize(28, 28);
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setAccessibleName(names[i]);
        button->setToolTip(names[i]);
        mColours->addButton(button, int(i));
        row->addWidget(button);
    }
    auto *other = new QToolButton;
    other->setIcon(icon("color-management"));
    other->setFixedSize(28, 28);
    other->setAutoRaise(true);
    other->setAccessibleName(tr("Another colour"));
    other->setToolTip(tr("Another colour..."));
    row->addWidget(other);
    row->addStretch(1);
    layout->addLayout(row);
    connect(mColours, &QButtonGroup::idClicked, this,
            [this](int id) { setColour(paletteColours[std::size_t(id)]); });
    connect(other, &QToolButton::clicked, this, [this] {
        const QColor chosen = QColorDialog::getColor(mState.brush().colour, this, tr("Colour"));
        if (chosen.isValid())
            setColour(chosen);
    });
    mWidth =
        new NumberSlider(tr("Width"), {100 * narrowest, 100 * widest, 0.1, 2.2, 1, QStringLiteral("%"), true},
                         tr("Of the line, as a share of the canvas. Keys [ and ]."));
    auto *numbers = new QHBoxLayout; // side by side: the sheet needs the height
    numbers->setSpacing(12);
    layout->addLayout(numbers);
    numbers->addWidget(mWidth);
    connect(mWidth, &NumberSlider::valueChanged, this, [this](double percent) {
        Brush brush = mState.brush();
        brush.width = percent / 100.0;
        mState.setBrush(brush);
    });
    mFilm = new NumberSlider(tr("Film"), {0.0, 100.0, 1.0, 75.0, 0, QStringLiteral("%")},
                             tr("How much of the film is seen below the drawing."));
    mFilm->setValue(75.0);
    numbers->addWidget(mFilm);
    connect(mFilm, &NumberSlider::valueChanged, this,
            [this](double percent) { mView->setUnderlay(percent / 100.0); });
}

void DrawingPanel::setTool(DrawingTool tool)
{
    Brush brush = mState.brush();
    brush.tool = tool;
    mState.setBrush(brush);
    if (tool == DrawingTool::Text)
        mWords->setFocus();
}

void DrawingPanel::setColour(const QColor &colour)
{
    Brush brush = mState.brush();
    brush.colour = colour;
    // Who chooses a colour wants to see it.
    if (brush.tool == DrawingTool::Eraser || brush.tool == DrawingTool::Move)
        brush.tool = DrawingTool::Pen;
    mState.setBrush(brush);
}

void DrawingPanel::changeWidth(int steps)
{
    Brush brush = mState.brush();
    brush.width = std::clamp(brush.width * std::pow(1.25, steps), narrowest, widest);
    mState.setBrush(brush);
}

void DrawingPanel::placeWords(const Vec2 &at)
{
    const Canvas *canvas = mState.chosenCanvas();
    const Brush &brush = mState.brush();
    if (!canvas)
        return;
    if (brush.text.trimmed().isEmpty()) {
        mWords->setFocus();
        return;
    }
    TextMark words;
    words.text = brush.text.trimmed().toStdString();
    words.place = at;
    words.height = wordsPerWidth * brush.width * std::max(canvas->size.x(), canvas->size.y());
    words.colour = toRgba(brush.colour);
    // A rim that the words stand out from, whatever is behind.
    words.edge = brush.colour.lightnessF() > 0.5 ? Rgba{29, 33, 38, 255} : Rgba{255, 255, 255, 255};
    mState.document().editDoodle(tr("Write"), canvas->id,
                                 withMark(canvas->doodle, mState.drawingOf(*canvas), std::move(words)));
}

void DrawingPanel::choosePicture()
{
    if (!mState.chosenCanvas())
        return;
    const QString path = QFileDialog::getOpenFileName(this, tr("Picture"), {},
                                                      tr("Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)"));
    if (!path.isEmpty())
        insertPicture(path);
}

bool DrawingPanel::insertPicture(const QString &path)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return false;
    QImageReader reader(path);
    reader.setAutoTransform(true);
    // Read at the size it is kept in: memory stays bounded whatever the file says of itself.
    if (const QSize size = reader.size();
        size.width() > mostPicturePixels || size.height() > mostPicturePixels)
        reader.setScaledSize(size.scaled(mostPicturePixels, mostPicturePixels, Qt::KeepAspectRatio));
    QImage read = reader.read();
    if (read.isNull()) {
        const Error error{ErrorCode::Malformed, "Reading the picture", reader.errorString().toStdString(),
                          "Choose a PNG or JPEG file", path.toStdString()};
        return mState.document().editDoodle(tr("Insert picture"), canvas->id, error);
    }
    if (read.width() > mostPicturePixels || read.height() > mostPicturePixels)
        read =
            read.scaled(mostPicturePixels, mostPicturePixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    read = read.convertToFormat(QImage::Format_RGBA8888);
    auto image = std::make_shared<Image>(read.width(), read.height());
    for (int y = 0; y < read.height(); ++y)
        std::copy_n(read.constScanLine(y), std::size_t(read.width()) * 4,
                    image->pixels.begin() + std::ptrdiff_t(y) * read.width() * 4);
    PictureMark mark;
    mark.size = toVec(QRectF({}, QSizeF(read.size())
                                     .scaled(pictureShare * canvas->size.x(), pictureShare * canvas->size.y(),
                                             Qt::KeepAspectRatio))
                          .bottomRight());
    mark.image = std::move(image);
    const bool isIn =
        mState.document().editDoodle(tr("Insert picture"), canvas->id,
                                     withMark(canvas->doodle, mState.drawingOf(*canvas), std::move(mark)));
    if (isIn)
        setTool(DrawingTool::Move);
    return isIn;
}

void DrawingPanel::refresh()
{
    const Brush &brush = mState.brush();
    if (QAbstractButton *button = mTools->button(int(brush.tool)))
        button->setChecked(true);
    mColours->setExclusive(false);
    for (QAbstractButton *button : mColours->buttons())
        button->setChecked(paletteColours[std::size_t(mColours->id(button))] == brush.colour);
    mColours->setExclusive(true);
    mWidth->setValue(100.0 * brush.width);
    mWords->setVisible(brush.tool == DrawingTool::Text);
    mStickers->setVisible(brush.tool == DrawingTool::Sticker);
    const Canvas *canvas = mState.chosenCanvas();
    const std::optional<CanvasView> seen = canvas ? mState.view(*canvas) : std::nullopt;
    if (!seen)
        mTitle->setText({});
    else if (seen->isFromBehind())
        mTitle->setText(tr("seen from behind"));
    else if (seen->facing() < 0.5)
        mTitle->setText(tr("seen from the side: another frame is better"));
    else
        mTitle->setText({});
}

} // namespace ductus
