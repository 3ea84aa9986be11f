<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>DirectDrawTool</name>
    <message>
        <source>Canvas %1</source>
        <translation>キャンバス %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>キャンバスの追加</translation>
    </message>
</context>
<context>
    <name>OcclusionTool</name>
    <message>
        <source>Bring in front</source>
        <translation>手前に出す</translation>
    </message>
    <message>
        <source>Put behind</source>
        <translation>奥に隠す</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasFollower</name>
    <message>
        <source>Following the canvas</source>
        <translation>キャンバスの追跡</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasList</name>
    <message>
        <source>Canvases</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>Duplicate canvas</source>
        <translation>キャンバスを複製</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>同じ絵を持つキャンバスを隣に作ります。</translation>
    </message>
    <message>
        <source>Take canvas away</source>
        <translation>キャンバスを取り除く</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>キャンバスとその絵を取り除きます。</translation>
    </message>
    <message>
        <source>Show canvas</source>
        <translation>キャンバスを表示</translation>
    </message>
    <message>
        <source>Hide canvas</source>
        <translation>キャンバスを隠す</translation>
    </message>
    <message>
        <source>Rename canvas</source>
        <translation>キャンバス名の変更</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 のコピー</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasPanel</name>
    <message>
        <source>Motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>The canvas stands still in the scene; only the camera moves past it.</source>
        <translation>キャンバスはシーンの中で動かず、カメラだけが動きます。</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>追従</translation>
    </message>
    <message>
        <source>The canvas follows what is under its middle.</source>
        <translation>キャンバスが中心の下にあるものを追いかけます。</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>ここに留める</translation>
    </message>
    <message>
        <source>Holds the canvas where it is in this frame. In between it follows.</source>
        <translation>このフレームの位置にキャンバスを留めます。その間は追従します。</translation>
    </message>
    <message>
        <source>Straight to the next pin</source>
        <translation>次のピンまで直線</translation>
    </message>
    <message>
        <source>From the pin before this frame to the one after it the canvas goes straight and evenly instead of following what is seen: for where it is hidden too long.</source>
        <translation>前のピンから次のピンまで、見えるものを追わずに直線で一定の速さで動きます。長く隠れる所に使います。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>How far the canvas is from the camera. Nearer things hide it.</source>
        <translation>カメラからキャンバスまでの距離です。手前のものに隠れます。</translation>
    </message>
    <message>
        <source>Distance from the scene</source>
        <translation>シーンから距離を取る</translation>
    </message>
    <message>
        <source>As far as what is under the middle of the canvas.</source>
        <translation>キャンバスの中心の下にあるものと同じ距離にします。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>The size of the canvas; its corner on the picture does the same.</source>
        <translation>キャンバスの大きさです。画面上の角でも変えられます。</translation>
    </message>
    <message>
        <source>Face the camera</source>
        <translation>カメラに向ける</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>このフレームでキャンバスをカメラに正対させます。</translation>
    </message>
    <message>
        <source>How it turns while it follows</source>
        <translation>追従中の回転</translation>
    </message>
    <message>
        <source>What the canvas does between the frames in which you turned it.</source>
        <translation>回転を指定したフレームの間での、キャンバスの動きです。</translation>
    </message>
    <message>
        <source>Turns with the way it goes</source>
        <translation>進む向きに合わせて回る</translation>
    </message>
    <message>
        <source>Keeps its direction</source>
        <translation>向きを保つ</translation>
    </message>
    <message>
        <source>Turns with the thing it is on</source>
        <translation>対象と一緒に回る</translation>
    </message>
    <message>
        <source>Keeps its direction relative to its path, as a sign on a tram does in a bend.</source>
        <translation>カーブを曲がる電車の行き先表示のように、進む向きに対する角度を保ちます。</translation>
    </message>
    <message>
        <source>Looks where you turned it to, whatever happens.</source>
        <translation>何があっても、指定した向きのままです。</translation>
    </message>
    <message>
        <source>Turns as the picture turns around its middle, as a hat does on a dancer.</source>
        <translation>踊る人の帽子のように、中心まわりの映像の回転に合わせて回ります。</translation>
    </message>
    <message>
        <source>Change turning</source>
        <translation>回転の変更</translation>
    </message>
    <message>
        <source>Hidden by what is in front</source>
        <translation>手前のものに隠れる</translation>
    </message>
    <message>
        <source>Nearer things cover the canvas. Off: it is always seen.</source>
        <translation>手前のものがキャンバスを隠します。オフなら常に見えます。</translation>
    </message>
    <message>
        <source>Let the scene hide the canvas</source>
        <translation>シーンでキャンバスを隠す</translation>
    </message>
    <message>
        <source>Show the canvas always</source>
        <translation>キャンバスを常に表示</translation>
    </message>
    <message>
        <source>Depth play</source>
        <translation>奥行きのゆとり</translation>
    </message>
    <message>
        <source>More: the canvas shows through what is only a little nearer.</source>
        <translation>大きいほど、わずかに手前にあるものを透かして見えます。</translation>
    </message>
    <message>
        <source>Change depth play</source>
        <translation>奥行きのゆとりの変更</translation>
    </message>
    <message>
        <source>In front here</source>
        <translation>ここは手前</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be seen.</source>
        <translation>キャンバスが見えるべき所を塗ります。</translation>
    </message>
    <message>
        <source>Behind here</source>
        <translation>ここは奥</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be hidden.</source>
        <translation>キャンバスが隠れるべき所を塗ります。</translation>
    </message>
    <message>
        <source>Forget what was brushed</source>
        <translation>塗った指定を消す</translation>
    </message>
    <message>
        <source>Only the distance decides again what hides the canvas.</source>
        <translation>再び距離だけで隠れ方が決まります。</translation>
    </message>
    <message>
        <source>Forget the brush</source>
        <translation>塗った指定の消去</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How much of the film shows through the drawing.</source>
        <translation>絵を透かして映像がどれだけ見えるかです。</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>不透明度の変更</translation>
    </message>
    <message>
        <source>Let canvas follow</source>
        <translation>キャンバスの追従</translation>
    </message>
    <message>
        <source>Let canvas stay</source>
        <translation>キャンバスの静止</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>キャンバスを留める</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>直線移動</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>シーンに追従</translation>
    </message>
    <message>
        <source>Change distance</source>
        <translation>距離の変更</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>キャンバスのサイズ変更</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas to draw on will stand there.</source>
        <translation>映像の上で枠をドラッグすると、そこに描くためのキャンバスができます。</translation>
    </message>
    <message>
        <source>Choose a canvas above or on the picture, or drag out a box for another one.</source>
        <translation>上の一覧か映像でキャンバスを選ぶか、枠をドラッグして追加してください。</translation>
    </message>
    <message>
        <source>Pin it here and follow</source>
        <translation>ここに留めて追従</translation>
    </message>
    <message>
        <source>Stands still in the scene.</source>
        <translation>シーンの中で静止しています。</translation>
    </message>
    <message numerus="yes">
        <source>Pinned in %n frame(s); drag it where it drifts.</source>
        <translation>
            <numerusform>%n フレームで固定。ずれた所でドラッグして直せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Following...</source>
        <translation>追跡中...</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingHand</name>
    <message>
        <source>Erase</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Move drawing</source>
        <translation>絵の移動</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗りつぶし</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>矢印を描く</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>文字を書く</translation>
    </message>
    <message>
        <source>Add sticker</source>
        <translation>スタンプの追加</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingPanel</name>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Draws lines; a pen&apos;s pressure makes them wider. (P)</source>
        <translation>線を描きます。筆圧で太くなります。(P)</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>塗りつぶし図形</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled. (G)</source>
        <translation>輪郭を描くと中が塗りつぶされます。(G)</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>矢印</translation>
    </message>
    <message>
        <source>Points at something; draw it as you like. (A)</source>
        <translation>何かを指し示します。自由に描けます。(A)</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand. (T)</source>
        <translation>文字を入力し、置きたい所をクリックします。(T)</translation>
    </message>
    <message>
        <source>Sticker</source>
        <translation>スタンプ</translation>
    </message>
    <message>
        <source>Ready-made drawings; drag to say how large. (S)</source>
        <translation>用意された絵です。ドラッグで大きさを決めます。(S)</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>消しゴム</translation>
    </message>
    <message>
        <source>Takes parts of lines away. (E)</source>
        <translation>線の一部を消します。(E)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Moves something that was drawn. (V)</source>
        <translation>描いたものを動かします。(V)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Picture. Puts a picture from a file on the canvas; move it with V.</source>
        <translation>画像。ファイルの画像をキャンバスに置きます。V で動かせます。</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand</source>
        <translation>文字を入力し、置きたい所をクリック</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黒</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>オレンジ</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>シアン</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>ピンク</translation>
    </message>
    <message>
        <source>Another colour</source>
        <translation>ほかの色</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>ほかの色...</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>太さ</translation>
    </message>
    <message>
        <source>Of the line, as a share of the canvas. Keys [ and ].</source>
        <translation>線の太さ (キャンバスに対する割合)。キーは [ と ]。</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>映像</translation>
    </message>
    <message>
        <source>How much of the film is seen below the drawing.</source>
        <translation>絵の下に映像をどれだけ見せるかです。</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書く</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</source>
        <translation>画像 (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</translation>
    </message>
    <message>
        <source>Insert picture</source>
        <translation>画像の挿入</translation>
    </message>
    <message>
        <source>seen from behind</source>
        <translation>裏から見ています</translation>
    </message>
    <message>
        <source>seen from the side: another frame is better</source>
        <translation>横から見ています: 別のフレームが適しています</translation>
    </message>
    <message>
        <source>star</source>
        <translation>星</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>ハート</translation>
    </message>
    <message>
        <source>check</source>
        <translation>チェック</translation>
    </message>
    <message>
        <source>cross</source>
        <translation>バツ</translation>
    </message>
    <message>
        <source>smile</source>
        <translation>笑顔</translation>
    </message>
    <message>
        <source>frown</source>
        <translation>しかめ面</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>輪</translation>
    </message>
    <message>
        <source>bubble</source>
        <translation>吹き出し</translation>
    </message>
    <message>
        <source>bang</source>
        <translation>びっくりマーク</translation>
    </message>
    <message>
        <source>question</source>
        <translation>はてな</translation>
    </message>
    <message>
        <source>bulb</source>
        <translation>電球</translation>
    </message>
    <message>
        <source>bolt</source>
        <translation>稲妻</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>Draw straight on the picture: a canvas is made where you begin.
Or choose a canvas to see it from the front.</source>
        <translation>映像に直接描けます: 描き始めた所にキャンバスができます。
または、キャンバスを選ぶと正面から表示します。</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>選択...</translation>
    </message>
    <message>
        <source>With the sound of the clip</source>
        <translation>クリップの音声を含める</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>フォルダーで表示</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message numerus="yes">
        <source>%1, about %n s left</source>
        <translation>
            <numerusform>%1、残り約 %n 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Share</source>
        <translation>共有(&amp;S)</translation>
    </message>
    <message>
        <source>A film with your drawings (MP4). Plays everywhere: phone, web, projector.</source>
        <translation>絵の入った動画 (MP4)。スマートフォン、Web、プロジェクターなどどこでも再生できます。</translation>
    </message>
    <message>
        <source>S&amp;lides</source>
        <translation>スライド(&amp;L)</translation>
    </message>
    <message>
        <source>A moving picture (GIF) for slides and worksheets. No sound.</source>
        <translation>スライドや教材用の動く画像 (GIF)。音声はありません。</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>オーバーレイ(&amp;O)</translation>
    </message>
    <message>
        <source>Your drawings alone, see-through (WebM), to lay over the clip in another program.</source>
        <translation>絵だけの透明な動画 (WebM)。ほかのソフトでクリップに重ねられます。</translation>
    </message>
    <message>
        <source>%1 with drawings</source>
        <translation>%1 (絵入り)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it, or choose another name.</source>
        <translation>%1 はすでにあります。置き換えるか、別の名前を選んでください。</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 の書き出し</translation>
    </message>
    <message numerus="yes">
        <source>Done: %1 (%2 x %3, %n frame(s))</source>
        <translation>
            <numerusform>完了: %1 (%2 x %3、%n フレーム)</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>キャンセルしました。何も書き込まれていません。</translation>
    </message>
    <message>
        <source>It could not be exported: %1</source>
        <translation>書き出せませんでした: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>ductus::FrameStrip</name>
    <message>
        <source>Onion skin</source>
        <translation>オニオンスキン</translation>
    </message>
    <message>
        <source>Onion skin (O). The drawings before shine through in red, those after in blue.</source>
        <translation>オニオンスキン (O)。前の絵が赤、後の絵が青で透けて見えます。</translation>
    </message>
    <message>
        <source>Drawings that shine through</source>
        <translation>透かす絵の数</translation>
    </message>
    <message>
        <source>How many drawings before and after shine through.</source>
        <translation>前後の絵を何枚透かして見せるかです。</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Video frames this drawing is held</source>
        <translation>この絵を保つフレーム数</translation>
    </message>
    <message>
        <source>For how many frames of the film this drawing is seen.</source>
        <translation>映像の何フレームの間、この絵を見せるかです。</translation>
    </message>
    <message>
        <source>After the last drawing</source>
        <translation>最後の絵の後</translation>
    </message>
    <message>
        <source>What comes after the last drawing.</source>
        <translation>最後の絵の後にどうなるかです。</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>往復</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>1 回</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>最後を保持</translation>
    </message>
    <message>
        <source>Hold drawing</source>
        <translation>絵の保持</translation>
    </message>
    <message>
        <source>Change repeat</source>
        <translation>繰り返しの変更</translation>
    </message>
    <message>
        <source>Add drawing</source>
        <translation>絵の追加</translation>
    </message>
    <message>
        <source>Duplicate drawing</source>
        <translation>絵の複製</translation>
    </message>
    <message>
        <source>Take drawing away</source>
        <translation>絵の削除</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>絵 %1</translation>
    </message>
    <message>
        <source>Add drawing. An empty one after this: draw the next moment on it.</source>
        <translation>絵を追加。この後に空の絵ができます。次の瞬間を描いてください。</translation>
    </message>
    <message numerus="yes">
        <source>Drawing %1, held for %n frame(s)</source>
        <translation>
            <numerusform>絵 %1、%n フレーム保持</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::HandlesTool</name>
    <message>
        <source>Drag the canvas where it must be in this frame: it is pinned there.</source>
        <translation>このフレームであるべき位置へドラッグすると、そこに留まります。</translation>
    </message>
    <message>
        <source>Drag the canvas where it should stand.</source>
        <translation>キャンバスを置きたい所へドラッグします。</translation>
    </message>
    <message>
        <source>Drag to make the canvas larger or smaller.</source>
        <translation>ドラッグでキャンバスを拡大・縮小します。</translation>
    </message>
    <message>
        <source>Drag to turn the canvas in its plane.</source>
        <translation>ドラッグでキャンバスを面内で回します。</translation>
    </message>
    <message>
        <source>Drag the pin of the gauge: the canvas looks where the pin points.</source>
        <translation>ゲージの針をドラッグすると、針の指す方へキャンバスが向きます。</translation>
    </message>
    <message>
        <source>Click to go to this moment, drag to pin the canvas elsewhere then.</source>
        <translation>クリックでその時点へ移動、ドラッグでその時点の留め位置を変えます。</translation>
    </message>
    <message>
        <source>Click to choose this canvas.</source>
        <translation>クリックでこのキャンバスを選びます。</translation>
    </message>
    <message>
        <source>Drag out a box: a canvas will stand there in the scene.</source>
        <translation>枠をドラッグすると、シーンのそこにキャンバスが立ちます。</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>キャンバスを留める</translation>
    </message>
    <message>
        <source>Move canvas</source>
        <translation>キャンバスの移動</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>キャンバスのサイズ変更</translation>
    </message>
    <message>
        <source>Turn canvas</source>
        <translation>キャンバスの回転</translation>
    </message>
    <message>
        <source>Tilt canvas</source>
        <translation>キャンバスの傾き</translation>
    </message>
    <message>
        <source>Canvas %1</source>
        <translation>キャンバス %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>キャンバスの追加</translation>
    </message>
</context>
<context>
    <name>ductus::PlayerView</name>
    <message>
        <source>Player</source>
        <translation>プレイヤー</translation>
    </message>
</context>
<context>
    <name>ductus::StudioWindow</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Opens a clip, a folder of pictures or a project.</source>
        <translation>クリップ、画像のフォルダー、プロジェクトを開きます。</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>スタートページ(&amp;T)</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the clip stays open.</source>
        <translation>サンプルと最近のファイルを表示します。クリップは開いたままです。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Saves what was drawn and where; the clip itself stays where it is.</source>
        <translation>描いたものとその位置を保存します。クリップ自体は元の場所のままです。</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>別名で保存(&amp;A)...</translation>
    </message>
    <message>
        <source>Saves under another name and goes on there.</source>
        <translation>別の名前で保存し、そちらで作業を続けます。</translation>
    </message>
    <message>
        <source>&amp;Pack the analysis</source>
        <translation>解析結果を含める(&amp;P)</translation>
    </message>
    <message>
        <source>Saves how the scene moves in the project as well, so that it opens at once on another computer. Makes the file larger.</source>
        <translation>シーンの動きもプロジェクトに保存し、別のコンピューターでもすぐ開けるようにします。ファイルは大きくなります。</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>書き出し(&amp;E)...</translation>
    </message>
    <message>
        <source>Makes a film, a moving picture for slides, or an overlay.</source>
        <translation>動画、スライド用の動く画像、オーバーレイを作ります。</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Runs the clip in a loop, or stops it.</source>
        <translation>クリップをループ再生、または停止します。</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>1 フレーム戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Goes to the frame before.</source>
        <translation>前のフレームに移動します。</translation>
    </message>
    <message>
        <source>One frame &amp;on</source>
        <translation>1 フレーム進む(&amp;O)</translation>
    </message>
    <message>
        <source>Goes to the next frame.</source>
        <translation>次のフレームに移動します。</translation>
    </message>
    <message>
        <source>Goes to the first frame.</source>
        <translation>最初のフレームに移動します。</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>末尾へ(&amp;E)</translation>
    </message>
    <message>
        <source>Goes to the last frame.</source>
        <translation>最後のフレームに移動します。</translation>
    </message>
    <message>
        <source>Play back&amp;wards</source>
        <translation>逆再生(&amp;W)</translation>
    </message>
    <message>
        <source>Runs the clip backwards; again: faster.</source>
        <translation>クリップを逆再生します。もう一度で速くなります。</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Stops the clip.</source>
        <translation>クリップを停止します。</translation>
    </message>
    <message>
        <source>Play &amp;forwards</source>
        <translation>順再生(&amp;F)</translation>
    </message>
    <message>
        <source>Runs the clip; again: faster.</source>
        <translation>クリップを再生します。もう一度で速くなります。</translation>
    </message>
    <message>
        <source>So&amp;und</source>
        <translation>音声(&amp;U)</translation>
    </message>
    <message>
        <source>Lets the clip be heard while it runs.</source>
        <translation>再生中にクリップの音声を鳴らします。</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>&amp;Follow what is here</source>
        <translation>ここにあるものを追う(&amp;F)</translation>
    </message>
    <message>
        <source>Pins the canvas to what is under its middle; it follows from then on.</source>
        <translation>中心の下にあるものにキャンバスを留め、以後それを追いかけます。</translation>
    </message>
    <message>
        <source>S&amp;tay here</source>
        <translation>ここに静止(&amp;T)</translation>
    </message>
    <message>
        <source>Lets the canvas stand still in the scene where it is now.</source>
        <translation>キャンバスをシーンの今の位置に静止させます。</translation>
    </message>
    <message>
        <source>Face the &amp;camera</source>
        <translation>カメラに向ける(&amp;C)</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>このフレームでキャンバスをカメラに正対させます。</translation>
    </message>
    <message>
        <source>&amp;Next keyframe</source>
        <translation>次のキーフレーム(&amp;N)</translation>
    </message>
    <message>
        <source>Goes to the next frame in which the canvas is pinned, turned or sized.</source>
        <translation>キャンバスが固定、回転、サイズ変更された次のフレームに移動します。</translation>
    </message>
    <message>
        <source>&amp;Previous keyframe</source>
        <translation>前のキーフレーム(&amp;P)</translation>
    </message>
    <message>
        <source>Goes to the keyframe before.</source>
        <translation>前のキーフレームに移動します。</translation>
    </message>
    <message>
        <source>&amp;Duplicate canvas</source>
        <translation>キャンバスを複製(&amp;D)</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>同じ絵を持つキャンバスを隣に作ります。</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>キャンバスとその絵を取り除きます。</translation>
    </message>
    <message>
        <source>&amp;Look at the scene again</source>
        <translation>シーンを再解析(&amp;L)</translation>
    </message>
    <message>
        <source>Finds anew how the camera and all else moves; drawings stay.</source>
        <translation>カメラや被写体の動きを求め直します。絵はそのままです。</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Gives up what was begun; then the choice.</source>
        <translation>途中の操作、次に選択を取り消します。</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>&amp;Pen</source>
        <translation>ペン(&amp;P)</translation>
    </message>
    <message>
        <source>Draws lines.</source>
        <translation>線を描きます。</translation>
    </message>
    <message>
        <source>&amp;Filled shape</source>
        <translation>塗りつぶし図形(&amp;F)</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled.</source>
        <translation>輪郭を描くと中が塗りつぶされます。</translation>
    </message>
    <message>
        <source>&amp;Arrow</source>
        <translation>矢印(&amp;A)</translation>
    </message>
    <message>
        <source>Points at something.</source>
        <translation>何かを指し示します。</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>文字(&amp;W)</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand.</source>
        <translation>文字を入力し、置きたい所をクリックします。</translation>
    </message>
    <message>
        <source>&amp;Sticker</source>
        <translation>スタンプ(&amp;S)</translation>
    </message>
    <message>
        <source>Ready-made drawings.</source>
        <translation>用意された絵です。</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>消しゴム(&amp;E)</translation>
    </message>
    <message>
        <source>Takes parts of lines away.</source>
        <translation>線の一部を消します。</translation>
    </message>
    <message>
        <source>&amp;Move a drawing</source>
        <translation>絵を移動(&amp;M)</translation>
    </message>
    <message>
        <source>Moves something that was drawn.</source>
        <translation>描いたものを動かします。</translation>
    </message>
    <message>
        <source>W&amp;ider brush</source>
        <translation>ブラシを太く(&amp;I)</translation>
    </message>
    <message>
        <source>Makes the brush wider.</source>
        <translation>ブラシを太くします。</translation>
    </message>
    <message>
        <source>&amp;Narrower brush</source>
        <translation>ブラシを細く(&amp;N)</translation>
    </message>
    <message>
        <source>Makes the brush narrower.</source>
        <translation>ブラシを細くします。</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>オニオンスキン(&amp;O)</translation>
    </message>
    <message>
        <source>The drawings before shine through in red, those after in blue.</source>
        <translation>前の絵が赤、後の絵が青で透けて見えます。</translation>
    </message>
    <message>
        <source>A&amp;dd drawing</source>
        <translation>絵を追加(&amp;D)</translation>
    </message>
    <message>
        <source>An empty drawing after this one: the next moment of an animation.</source>
        <translation>この後に空の絵を加えます。アニメーションの次の瞬間になります。</translation>
    </message>
    <message>
        <source>D&amp;uplicate drawing</source>
        <translation>絵を複製(&amp;U)</translation>
    </message>
    <message>
        <source>A copy of this drawing after it, to be changed a little.</source>
        <translation>この絵のコピーを後ろに作ります。少し変えて使います。</translation>
    </message>
    <message>
        <source>Take drawing awa&amp;y</source>
        <translation>絵を取り除く(&amp;Y)</translation>
    </message>
    <message>
        <source>Takes the present drawing out of the animation.</source>
        <translation>今の絵をアニメーションから取り除きます。</translation>
    </message>
    <message>
        <source>Ne&amp;xt drawing</source>
        <translation>次の絵(&amp;X)</translation>
    </message>
    <message>
        <source>Goes to the next drawing of the canvas.</source>
        <translation>キャンバスの次の絵に移動します。</translation>
    </message>
    <message>
        <source>P&amp;revious drawing</source>
        <translation>前の絵(&amp;R)</translation>
    </message>
    <message>
        <source>Goes to the drawing before.</source>
        <translation>前の絵に移動します。</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>キャンバス(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>描画(&amp;D)</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>シーンの解析</translation>
    </message>
    <message>
        <source>How the scene moves was not in the cache any more and was found again.</source>
        <translation>シーンの動きがキャッシュになかったため、求め直しました。</translation>
    </message>
    <message>
        <source>What was found out is kept in the project, as the cache cannot be used: %1</source>
        <translation>キャッシュが使えないため、結果をプロジェクトに保存します: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>The scene was not looked at to the end.</source>
        <translation>シーンの解析が最後まで終わっていません。</translation>
    </message>
    <message>
        <source>Canvases cannot follow what moves until it is; it goes on where it was.</source>
        <translation>終わるまでキャンバスは動くものを追えません。続きから再開できます。</translation>
    </message>
    <message>
        <source>Look at the scene</source>
        <translation>シーンを解析</translation>
    </message>
    <message>
        <source>The clip is too long for that: its analysis has %1 megabytes.</source>
        <translation>クリップが長すぎます: 解析結果が %1 メガバイトあります。</translation>
    </message>
    <message>
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>Draw into a filmed scene, so that it stays where you put it.</source>
        <translation>映像のシーンに描いた絵が、置いた場所にとどまります。</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>開く...</translation>
    </message>
    <message>
        <source>Drop a clip, a folder of pictures or a project anywhere.</source>
        <translation>クリップ、画像のフォルダー、プロジェクトをどこにでもドロップできます。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Clips and projects (*.ductus %1);;All files (*)</source>
        <translation>クリップとプロジェクト (*.ductus %1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開く</translation>
    </message>
    <message>
        <source>Find the clip...</source>
        <translation>クリップを探す...</translation>
    </message>
    <message>
        <source>Looking where %1 is now</source>
        <translation>%1 の現在の場所を探しています</translation>
    </message>
    <message>
        <source>The clip was moved and is found again: %1</source>
        <translation>移動されたクリップが見つかりました: %1</translation>
    </message>
    <message>
        <source>The clip has the frames and the size of the one this was drawn on, but it is another file.</source>
        <translation>フレーム数とサイズは絵を描いたクリップと同じですが、別のファイルです。</translation>
    </message>
    <message>
        <source>If it does not show the same scene, find the right one.</source>
        <translation>同じ場面でない場合は、正しいクリップを探してください。</translation>
    </message>
    <message>
        <source>The clip is another one than this was drawn on.</source>
        <translation>絵を描いたときとは別のクリップです。</translation>
    </message>
    <message>
        <source>Its number of frames or its size differ.</source>
        <translation>フレーム数かサイズが異なります。</translation>
    </message>
    <message>
        <source>The clip %1 is not where it was.</source>
        <translation>クリップ %1 が元の場所にありません。</translation>
    </message>
    <message>
        <source>Show where it is now: everything drawn is kept.</source>
        <translation>今の場所を指定してください。描いたものはすべて残っています。</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>%1 はどこですか?</translation>
    </message>
    <message>
        <source>Clips (%1);;All files (*)</source>
        <translation>クリップ (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>音声の読み込み</translation>
    </message>
    <message>
        <source>Open a clip first; its film can be exported then.</source>
        <translation>先にクリップを開いてください。その後、動画を書き出せます。</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>%1 に書き出しました。</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>別名で保存</translation>
    </message>
    <message>
        <source>Ductus projects (*.ductus)</source>
        <translation>Ductus プロジェクト (*.ductus)</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>別名で保存...</translation>
    </message>
    <message>
        <source>&amp;Write down what I do</source>
        <translation>操作を記録(&amp;W)</translation>
    </message>
    <message>
        <source>Every step and command with its time, from now on; nothing leaves this computer.</source>
        <translation>今からの手順とコマンドを時刻とともに記録します。外部には送信されません。</translation>
    </message>
    <message>
        <source>Nothing was written down.</source>
        <translation>何も記録されていません。</translation>
    </message>
    <message>
        <source>What you do is written down from now on. Edit &gt; Save what I did keeps it.</source>
        <translation>今から操作を記録します。[編集] &gt; [操作の記録を保存] で保存できます。</translation>
    </message>
    <message>
        <source>Save what I &amp;did...</source>
        <translation>操作の記録を保存(&amp;D)...</translation>
    </message>
    <message>
        <source>A line of JSON for every step: when, what, on which canvas, in which frame.</source>
        <translation>1 手順を JSON の 1 行で記録: 時刻、内容、キャンバス、フレーム。</translation>
    </message>
    <message>
        <source>Save what I did</source>
        <translation>操作の記録を保存</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>操作ログ (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>%n act(s) written to %1.</source>
        <translation>
            <numerusform>%n 件の操作を %1 に保存しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Step</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>1  Place</source>
        <translation>1  置く</translation>
    </message>
    <message>
        <source>Put a canvas where the drawing should be.</source>
        <translation>絵を置きたい所にキャンバスを置きます。</translation>
    </message>
    <message>
        <source>2  Pin</source>
        <translation>2  留める</translation>
    </message>
    <message>
        <source>Say where the canvas must be; it follows in between.</source>
        <translation>キャンバスのあるべき位置を決めます。その間は追従します。</translation>
    </message>
    <message>
        <source>3  Draw</source>
        <translation>3  描く</translation>
    </message>
    <message>
        <source>Draw on the canvas, seen from the front.</source>
        <translation>正面から見たキャンバスに描きます。</translation>
    </message>
    <message>
        <source>Canvases</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>This canvas</source>
        <translation>このキャンバス</translation>
    </message>
    <message>
        <source>Brush where the canvas must be seen; it counts in the frames around, too.</source>
        <translation>キャンバスが見えるべき所を塗ります。前後のフレームにも効きます。</translation>
    </message>
    <message>
        <source>Brush where the canvas must be hidden; it counts in the frames around, too.</source>
        <translation>キャンバスが隠れるべき所を塗ります。前後のフレームにも効きます。</translation>
    </message>
    <message>
        <source>Move keyframe</source>
        <translation>キーフレームの移動</translation>
    </message>
    <message>
        <source>Take keyframe away</source>
        <translation>キーフレームの削除</translation>
    </message>
    <message>
        <source>Go &amp;straight to the next keyframe</source>
        <translation>次のキーフレームまで直線(&amp;S)</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>直線移動</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>シーンに追従</translation>
    </message>
    <message>
        <source>&amp;Take keyframe away</source>
        <translation>キーフレームを取り除く(&amp;T)</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas will stand there in the scene.</source>
        <translation>映像の上で枠をドラッグすると、シーンのそこにキャンバスが立ちます。</translation>
    </message>
    <message>
        <source>Go to a frame where the canvas is wrong and drag it back: it is pinned there.</source>
        <translation>キャンバスがずれたフレームで正しい位置へドラッグすると、そこに留まります。</translation>
    </message>
    <message>
        <source>Draw on the canvas from the front, or straight on the picture.</source>
        <translation>正面のキャンバスか、映像に直接描きます。</translation>
    </message>
    <message>
        <source>The scene is being looked at; you can place and draw already.</source>
        <translation>シーンを解析しています。配置と描画はもうできます。</translation>
    </message>
    <message>
        <source>The camera&apos;s way was found: canvases stand firmly in the scene.</source>
        <translation>カメラの動きがわかりました。キャンバスはシーンにしっかり固定されます。</translation>
    </message>
    <message>
        <source>Positions and distances were measured from how the picture shifts.</source>
        <translation>位置と距離は映像のずれから測りました。</translation>
    </message>
    <message>
        <source>The camera turns on the spot: distances are guessed.</source>
        <translation>カメラはその場で回っています。距離は推定値です。</translation>
    </message>
    <message>
        <source>Set the distance of a canvas by hand where it hides or shows wrongly.</source>
        <translation>隠れ方がおかしい所では、キャンバスの距離を手で設定してください。</translation>
    </message>
    <message>
        <source>The camera stands still: distances are guessed.</source>
        <translation>カメラは静止しています。距離は推定値です。</translation>
    </message>
    <message>
        <source>Place a pa&amp;inting...</source>
        <translation>絵を置く(&amp;I)...</translation>
    </message>
    <message>
        <source>Stands a painting of LayerPainter in the scene: seen by the shot&apos;s camera, hidden by what is before it.</source>
        <translation>LayerPainter の絵をシーンに置きます。映像のカメラから見え、手前のものに隠れます。</translation>
    </message>
    <message>
        <source>&amp;Update paintings</source>
        <translation>絵を更新(&amp;U)</translation>
    </message>
    <message>
        <source>Takes what has changed in the paintings that stand in the scene; they stay where they are.</source>
        <translation>シーンに置いた絵の変更を取り込みます。位置はそのままです。</translation>
    </message>
    <message>
        <source>&amp;Copy lines</source>
        <translation>線をコピー(&amp;C)</translation>
    </message>
    <message>
        <source>Puts the lines of this drawing on the clipboard, for the other apps of the suite as well.</source>
        <translation>この絵の線をクリップボードに入れます。スイートのほかのアプリでも使えます。</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard on the chosen canvas, whichever app they come from.</source>
        <translation>クリップボードのストロークを、どのアプリのものでも選択中のキャンバスに描きます。</translation>
    </message>
    <message>
        <source>Choose a canvas with drawn lines: they are copied then.</source>
        <translation>線の描かれたキャンバスを選んでください。それをコピーします。</translation>
    </message>
    <message numerus="yes">
        <source>%n lines copied.</source>
        <translation>
            <numerusform>線を %n 本コピーしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a canvas, or place one: the strokes are drawn on it.</source>
        <translation>キャンバスを選ぶか置いてください。ストロークがそこに描かれます。</translation>
    </message>
    <message>
        <source>Paste lines</source>
        <translation>線の貼り付け</translation>
    </message>
    <message numerus="yes">
        <source>%n lines pasted.</source>
        <translation>
            <numerusform>線を %n 本貼り付けました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>Open a clip first; a painting can stand in it then.</source>
        <translation>先にクリップを開いてください。その後、絵を置けます。</translation>
    </message>
    <message>
        <source>Place a painting</source>
        <translation>絵を置く</translation>
    </message>
    <message>
        <source>Paintings of LayerPainter (*.ductus)</source>
        <translation>LayerPainter の絵 (*.ductus)</translation>
    </message>
    <message>
        <source>Open a clip: %1 will stand in it.</source>
        <translation>クリップを開くと、%1 がそこに置かれます。</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 の読み込み</translation>
    </message>
    <message>
        <source>Place painting</source>
        <translation>絵の配置</translation>
    </message>
    <message>
        <source>%1 stands in the scene. Move it by its handles.</source>
        <translation>%1 をシーンに置きました。ハンドルで動かせます。</translation>
    </message>
    <message>
        <source>Looking for changes of the paintings</source>
        <translation>絵の変更を確認</translation>
    </message>
    <message>
        <source>No painting stands in this scene.</source>
        <translation>このシーンには絵が置かれていません。</translation>
    </message>
    <message>
        <source>All paintings are as they are in LayerPainter.</source>
        <translation>すべての絵が LayerPainter と一致しています。</translation>
    </message>
    <message>
        <source>The painting &quot;%1&quot; changed in LayerPainter.</source>
        <translation>絵「%1」が LayerPainter で変更されました。</translation>
    </message>
    <message numerus="yes">
        <source>%n paintings changed in LayerPainter.</source>
        <translation>
            <numerusform>%n 枚の絵が LayerPainter で変更されました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Where they stand and what you drew stays.</source>
        <translation>更新しますか? 位置と描いたものはそのままです。</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>今はしない</translation>
    </message>
    <message>
        <source>Update painting</source>
        <translation>絵の更新</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>先頭へ(&amp;G)</translation>
    </message>
    <message>
        <source>Ta&amp;ke canvas away</source>
        <translation>キャンバスを取り除く(&amp;K)</translation>
    </message>
    <message>
        <source>Paste &amp;lines</source>
        <translation>線を貼り付け(&amp;L)</translation>
    </message>
</context>
<context>
    <name>ductus::TimelineView</name>
    <message>
        <source>Canvases will stand here, one a row.</source>
        <translation>ここにキャンバスが 1 行ずつ並びます。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>being followed...</source>
        <translation>追跡中...</translation>
    </message>
    <message>
        <source>stands still in the scene</source>
        <translation>シーンの中で静止</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音声</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message>
        <source>, then straight to the next</source>
        <translation>、次まで直線</translation>
    </message>
    <message>
        <source>Pinned here, %1%2. Drag to another frame; Delete takes it away.</source>
        <translation>ここで固定、%1%2。別のフレームへドラッグ、Delete で削除。</translation>
    </message>
    <message>
        <source>Distance set here, %1.</source>
        <translation>ここで距離を設定、%1。</translation>
    </message>
    <message>
        <source>Turned here, %1%2.</source>
        <translation>ここで回転、%1%2。</translation>
    </message>
    <message>
        <source>Size set here, %1.</source>
        <translation>ここでサイズを設定、%1。</translation>
    </message>
    <message>
        <source>Drag to go through the clip. Ctrl and the wheel zoom.</source>
        <translation>ドラッグでクリップ内を移動、Ctrl+ホイールで拡大縮小。</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>絵 %1</translation>
    </message>
</context>
<context>
    <name>ductus::TransportBar</name>
    <message>
        <source>%1   frame %2 of %3</source>
        <translation>%1   フレーム %2 / %3</translation>
    </message>
</context>
</TS>
