<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Erase</source>
        <translation>消す</translation>
    </message>
</context>
<context>
    <name>ductus::BrushPanel</name>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Half the width of a stroke in the painting&apos;s unit. Keys [ and ].</source>
        <translation>ストロークの幅の半分 (絵の単位)。キーは [ と ]。</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Section of strokes</source>
        <translation>ストロークの断面</translation>
    </message>
    <message>
        <source>The shape of a stroke cut across.</source>
        <translation>ストロークを横に切ったときの形です。</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>四角</translation>
    </message>
    <message>
        <source>Ribbon</source>
        <translation>リボン</translation>
    </message>
    <message>
        <source>Where strokes go</source>
        <translation>ストロークを置く場所</translation>
    </message>
    <message>
        <source>On surface</source>
        <translation>面の上</translation>
    </message>
    <message>
        <source>Strokes lie on what is under the pointer.</source>
        <translation>ポインターの下にあるものに沿って描きます。</translation>
    </message>
    <message>
        <source>On plane</source>
        <translation>平面上</translation>
    </message>
    <message>
        <source>Strokes lie on a plane through the point the view turns around.</source>
        <translation>視点の回転中心を通る平面に描きます。</translation>
    </message>
</context>
<context>
    <name>ductus::ColourField</name>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Left and right: how colourful; up and down: how bright. The bar at the right: the hue.</source>
        <translation>左右で鮮やかさ、上下で明るさ。右のバーは色相です。</translation>
    </message>
</context>
<context>
    <name>ductus::ColourList</name>
    <message>
        <source>Layers that colour this point</source>
        <translation>この点に色を付けているレイヤー</translation>
    </message>
    <message>
        <source>The point&apos;s colour with this layer and all below. Click: work in this layer.</source>
        <translation>このレイヤーと下のすべてを合わせた点の色です。クリックするとこのレイヤーで作業します。</translation>
    </message>
    <message>
        <source>Paint with %1</source>
        <translation>%1 で描く</translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation> %1 %</translation>
    </message>
    <message>
        <source>, whole scene</source>
        <translation>、シーン全体</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>形</translation>
    </message>
</context>
<context>
    <name>ductus::ColourPanel</name>
    <message>
        <source>Colour %1</source>
        <translation>色 %1</translation>
    </message>
</context>
<context>
    <name>ductus::FilmDialog</name>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>フル HD、1920 × 1080</translation>
    </message>
    <message>
        <source>HD, 1280 × 720</source>
        <translation>HD、1280 × 720</translation>
    </message>
    <message>
        <source>Small, 640 × 360</source>
        <translation>小、640 × 360</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>正方形、1080 × 1080</translation>
    </message>
    <message>
        <source>Upright, 1080 × 1920</source>
        <translation>縦長、1080 × 1920</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K、3840 × 2160</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>動画の書き出し</translation>
    </message>
    <message>
        <source>&amp;Seen</source>
        <translation>視点(&amp;S)</translation>
    </message>
    <message>
        <source>From where the film looks at the painting.</source>
        <translation>動画が絵をどこから見るかです。</translation>
    </message>
    <message>
        <source>Once around, from the present view</source>
        <translation>今の視点から 1 周</translation>
    </message>
    <message>
        <source>Along the camera path</source>
        <translation>カメラの軌道に沿って</translation>
    </message>
    <message>
        <source>From the present view</source>
        <translation>今の視点から</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>ルック(&amp;L)</translation>
    </message>
    <message>
        <source>Which look the film shows.</source>
        <translation>動画で見せるルックです。</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>今の表示のまま</translation>
    </message>
    <message>
        <source>All looks, a film each</source>
        <translation>全ルック (1 つずつ動画に)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>種類(&amp;K)</translation>
    </message>
    <message>
        <source>MP4 plays everywhere; WebM and pictures keep transparency.</source>
        <translation>MP4 はどこでも再生でき、WebM と画像は透明を保てます。</translation>
    </message>
    <message>
        <source>MP4 - plays everywhere</source>
        <translation>MP4 - どこでも再生可能</translation>
    </message>
    <message>
        <source>WebM - for the web, can be transparent</source>
        <translation>WebM - Web 用、透明も可能</translation>
    </message>
    <message>
        <source>GIF - a small loop</source>
        <translation>GIF - 短いループ</translation>
    </message>
    <message>
        <source>Folder of PNG pictures</source>
        <translation>PNG 画像のフォルダー</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>サイズ(&amp;I)</translation>
    </message>
    <message>
        <source>Pixels of a frame.</source>
        <translation>1 フレームのピクセル数です。</translation>
    </message>
    <message>
        <source>&amp;Frames a second</source>
        <translation>フレームレート(&amp;F)</translation>
    </message>
    <message>
        <source>25 suits films, 12 a hand-drawn loop.</source>
        <translation>動画なら 25、手描きのループなら 12 が目安です。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>How long the film is; double click: as long as the painting moves.</source>
        <translation>動画の長さです。ダブルクリックで絵の動きの長さになります。</translation>
    </message>
    <message>
        <source>&amp;Without background</source>
        <translation>背景なし(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>書き出し(&amp;E)...</translation>
    </message>
    <message>
        <source>MP4 has no transparency; choose WebM, GIF or PNG.</source>
        <translation>MP4 は透明にできません。WebM、GIF、PNG を選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n フレーム</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n films</source>
        <translation>
            <numerusform> (動画 %n 本)</numerusform>
        </translation>
    </message>
    <message>
        <source>, drawn in the background; you can go on painting.</source>
        <translation>、バックグラウンドで描画します。そのまま描き続けられます。</translation>
    </message>
</context>
<context>
    <name>ductus::HeadsetWindow</name>
    <message>
        <source>Paint in &amp;VR</source>
        <translation>VR で描く(&amp;V)</translation>
    </message>
    <message>
        <source>The painting in a headset, with the same layers and tools; again leaves it.</source>
        <translation>同じレイヤーとツールのまま、ヘッドセットの中で描きます。もう一度で終わります。</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Paint in VR</source>
        <translation>VR で描く</translation>
    </message>
    <message>
        <source>The painting is in the headset. This window shows what the left eye sees.</source>
        <translation>絵はヘッドセットの中にあります。このウィンドウには左目の映像が表示されます。</translation>
    </message>
</context>
<context>
    <name>ductus::KeyTrack</name>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>&lt;b&gt;Time&lt;/b&gt;&lt;br&gt;Drag to see the painting at another moment; diamonds are keys of the camera (above) and of layers (below).</source>
        <translation>&lt;b&gt;時間&lt;/b&gt;&lt;br&gt;ドラッグすると別の時点の絵が見られます。ひし形はカメラ (上) とレイヤー (下) のキーです。</translation>
    </message>
</context>
<context>
    <name>ductus::LayerPanel</name>
    <message>
        <source>Find layers</source>
        <translation>レイヤーを検索</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>通常</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>乗算</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>スクリーン</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>オーバーレイ</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>加算</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>比較 (暗)</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>比較 (明)</translation>
    </message>
    <message>
        <source>Colour dodge</source>
        <translation>覆い焼きカラー</translation>
    </message>
    <message>
        <source>Colour burn</source>
        <translation>焼き込みカラー</translation>
    </message>
    <message>
        <source>Hard light</source>
        <translation>ハードライト</translation>
    </message>
    <message>
        <source>Soft light</source>
        <translation>ソフトライト</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差の絶対値</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>カラー</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>輝度</translation>
    </message>
    <message>
        <source>Add stack</source>
        <translation>スタックを追加</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>独自のレイヤーを持つ、新しい形を加えます。</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>レイヤーを追加</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>レイヤーのストロークが下の形に色を付けます。</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>レイヤーを複製</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>全ストロークを含むコピーをすぐ上に作ります。</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>レイヤーを削除</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>元に戻せます。</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly the layer shows.</source>
        <translation>レイヤーの見え方の強さです。</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>合成</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>合成モード</translation>
    </message>
    <message>
        <source>How its colour is mixed with what is below: Multiply darkens, Screen lightens, Overlay does both.</source>
        <translation>下の色との混ざり方です。乗算は暗く、スクリーンは明るく、オーバーレイは両方の効果になります。</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>届く範囲</translation>
    </message>
    <message>
        <source>Tolerance: how far from its strokes the layer still colours. 0: only inside them.</source>
        <translation>許容範囲: ストロークからどこまで色が付くか。0 ならストロークの中だけです。</translation>
    </message>
    <message>
        <source>Stack %1</source>
        <translation>スタック %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>レイヤー %1</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 のコピー</translation>
    </message>
</context>
<context>
    <name>ductus::LayerTree</name>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示する</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>ロックを解除</translation>
    </message>
    <message>
        <source>Lock: nothing changes it</source>
        <translation>ロック: 変更されなくなります</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>ストローク %n 本</numerusform>
        </translation>
    </message>
    <message>
        <source>Its layers colour everything, after all others.</source>
        <translation>ほかのすべての後に、全体へ色を付けるレイヤーです。</translation>
    </message>
</context>
<context>
    <name>ductus::LooksBar</name>
    <message>
        <source>Looks</source>
        <translation>ルック</translation>
    </message>
    <message>
        <source>Keep this look</source>
        <translation>このルックを残す</translation>
    </message>
    <message>
        <source>&lt;b&gt;Keep this look&lt;/b&gt;&lt;br&gt;Remembers what all layers are now: visible, how strong, how mixed.</source>
        <translation>&lt;b&gt;このルックを残す&lt;/b&gt;&lt;br&gt;全レイヤーの今の状態 (表示、強さ、合成) を覚えます。</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>ルック %1</translation>
    </message>
    <message>
        <source>Shows this look; right click to update, rename or delete it.</source>
        <translation>このルックを表示します。右クリックで更新、名前の変更、削除ができます。</translation>
    </message>
    <message>
        <source>Update from the present</source>
        <translation>今の状態で更新</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>名前の変更...</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>ルックの名前を変更</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
</context>
<context>
    <name>ductus::MaskList</name>
    <message>
        <source>Gradient</source>
        <translation>グラデーション</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>円形グラデーション</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>ノイズ</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>テクスチャ</translation>
    </message>
    <message>
        <source>Inside %1</source>
        <translation>%1 の内側</translation>
    </message>
    <message>
        <source>Outside %1</source>
        <translation>%1 の外側</translation>
    </message>
    <message>
        <source>Add mask</source>
        <translation>マスクを追加</translation>
    </message>
    <message>
        <source>&lt;b&gt;Add mask&lt;/b&gt;&lt;br&gt;Masks weaken the layer in places; gradients are drawn with the gradient tool (D).</source>
        <translation>&lt;b&gt;マスクを追加&lt;/b&gt;&lt;br&gt;マスクはレイヤーを部分的に弱めます。グラデーションはグラデーションツール (D) で描きます。</translation>
    </message>
    <message>
        <source>, inside out</source>
        <translation>、反転</translation>
    </message>
    <message>
        <source>Mask of the layer. Click: on and off. With Shift: inside out. With Ctrl: remove.</source>
        <translation>レイヤーのマスク。クリックでオン/オフ、Shift で反転、Ctrl で削除します。</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>粒の大きさ</translation>
    </message>
    <message>
        <source>How large the spots of the noise are, in the painting&apos;s unit.</source>
        <translation>ノイズの斑点の大きさ (絵の単位) です。</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Where the noise begins to show: 0 everywhere, 1 nowhere.</source>
        <translation>ノイズが現れ始める値です。0 で全面、1 でなしになります。</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔らかさ</translation>
    </message>
    <message>
        <source>How soft the borders of the spots are.</source>
        <translation>斑点の縁の柔らかさです。</translation>
    </message>
    <message>
        <source>Texture from pictures...</source>
        <translation>画像からテクスチャ...</translation>
    </message>
    <message>
        <source>Inside strokes of</source>
        <translation>次のストロークの内側</translation>
    </message>
    <message>
        <source>Outside strokes of</source>
        <translation>次のストロークの外側</translation>
    </message>
    <message>
        <source>Slices of a texture, or one picture</source>
        <translation>テクスチャの断面画像、または 1 枚の画像</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>画像 (*.png *.jpg *.jpeg)</translation>
    </message>
</context>
<context>
    <name>ductus::MotionBar</name>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops. Key Space.</source>
        <translation>動き、絵、カメラの軌道を再生します。もう一度で停止。スペースキー。</translation>
    </message>
    <message>
        <source>Keep view</source>
        <translation>視点を記録</translation>
    </message>
    <message>
        <source>Where you look from now becomes a key of the camera path, here in time.</source>
        <translation>今の視点が、この時点でのカメラ軌道のキーになります。</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Takes away the camera&apos;s key under the playhead.</source>
        <translation>再生ヘッドの位置にあるカメラのキーを取り除きます。</translation>
    </message>
    <message>
        <source>Through the camera</source>
        <translation>カメラ視点</translation>
    </message>
    <message>
        <source>The view follows the camera path while time goes on.</source>
        <translation>時間の経過とともに、視点がカメラの軌道をたどります。</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>After this time all begins again; 0: no loop.</source>
        <translation>この時間が過ぎると最初に戻ります。0 ならループしません。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2 秒</translation>
    </message>
</context>
<context>
    <name>ductus::MotionTracks</name>
    <message>
        <source>What moves</source>
        <translation>動かすもの</translation>
    </message>
    <message>
        <source>Arm %1</source>
        <translation>%1 を記録待機</translation>
    </message>
    <message>
        <source>While armed, what the transform tool drags becomes keys of all of it.</source>
        <translation>記録待機中は、変形ツールで動かした結果が全体のキーになります。</translation>
    </message>
    <message>
        <source>Keys of %1</source>
        <translation>%1 のキー</translation>
    </message>
    <message>
        <source>Set key of %1</source>
        <translation>%1 のキーを打つ</translation>
    </message>
    <message>
        <source>Keeps where it is now as a key, here in time.</source>
        <translation>今の位置を、この時点のキーとして残します。</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>%1 のキーを削除</translation>
    </message>
    <message>
        <source>Takes away its key under the playhead.</source>
        <translation>再生ヘッドの位置にあるキーを取り除きます。</translation>
    </message>
</context>
<context>
    <name>ductus::PainterWindow</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>&amp;New painting</source>
        <translation>新規ペイント(&amp;N)</translation>
    </message>
    <message>
        <source>Begins with an empty canvas and one stack.</source>
        <translation>空のキャンバスとスタック 1 つで始めます。</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Opens a project, a Quill or .tilt painting, or a mesh.</source>
        <translation>プロジェクト、Quill や .tilt の絵、メッシュを開きます。</translation>
    </message>
    <message>
        <source>&amp;Import into painting...</source>
        <translation>ペイントに読み込み(&amp;I)...</translation>
    </message>
    <message>
        <source>The strokes of another painting or a mesh join this one; dropping a file does the same.</source>
        <translation>別の絵のストロークやメッシュをこの絵に加えます。ファイルのドロップでも同じです。</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>スタートページ(&amp;T)</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the painting stays open.</source>
        <translation>サンプルと最近のファイルを表示します。絵は開いたままです。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Saves the painting with layers and looks.</source>
        <translation>絵をレイヤーとルックごと保存します。</translation>
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
        <source>&amp;Export picture...</source>
        <translation>画像を書き出し(&amp;E)...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>キャンバスの表示を PNG ファイルに書き出します。</translation>
    </message>
    <message>
        <source>Export &amp;film...</source>
        <translation>動画を書き出し(&amp;F)...</translation>
    </message>
    <message>
        <source>A turntable, the camera path or the motion as MP4, WebM, GIF or pictures.</source>
        <translation>ターンテーブル、カメラの軌道、動きを MP4、WebM、GIF、連番画像にします。</translation>
    </message>
    <message>
        <source>Export &amp;mesh...</source>
        <translation>メッシュを書き出し(&amp;M)...</translation>
    </message>
    <message>
        <source>A GLB file whose vertices have the colours of all layers, for the web.</source>
        <translation>全レイヤーの色を頂点に持つ GLB ファイルです。Web で使えます。</translation>
    </message>
    <message>
        <source>Save action &amp;log...</source>
        <translation>操作ログを保存(&amp;L)...</translation>
    </message>
    <message>
        <source>Everything done so far, a line each; layerpainter replay plays it again.</source>
        <translation>これまでの操作を 1 行ずつ記録します。layerpainter replay で再現できます。</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>ストロークを削除(&amp;D)</translation>
    </message>
    <message>
        <source>Takes the chosen strokes away.</source>
        <translation>選択したストロークを取り除きます。</translation>
    </message>
    <message>
        <source>Copies of the chosen strokes in the active layer: how highlights and shadows are made.</source>
        <translation>選択したストロークを作業レイヤーにコピーします。ハイライトや影はこうして作ります。</translation>
    </message>
    <message>
        <source>&amp;Move to layer</source>
        <translation>レイヤーに移動(&amp;M)</translation>
    </message>
    <message>
        <source>The chosen strokes go into the active layer.</source>
        <translation>選択したストロークを作業レイヤーに移します。</translation>
    </message>
    <message>
        <source>Gives the chosen strokes the present colour.</source>
        <translation>選択したストロークを今の色にします。</translation>
    </message>
    <message>
        <source>Choose &amp;all of layer</source>
        <translation>レイヤー内をすべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>All strokes of the active layer.</source>
        <translation>作業レイヤーの全ストロークを選びます。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Forgets what was begun, then the choice, then the tool.</source>
        <translation>途中の操作、選択、ツールの順に取り消します。</translation>
    </message>
    <message>
        <source>Add &amp;stack</source>
        <translation>スタックを追加(&amp;S)</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>独自のレイヤーを持つ、新しい形を加えます。</translation>
    </message>
    <message>
        <source>Add &amp;layer</source>
        <translation>レイヤーを追加(&amp;L)</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>レイヤーのストロークが下の形に色を付けます。</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>レイヤーを複製(&amp;D)</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>全ストロークを含むコピーをすぐ上に作ります。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>名前を変更(&amp;R)</translation>
    </message>
    <message>
        <source>Another name for stack or layer.</source>
        <translation>スタックやレイヤーの名前を変えます。</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>元に戻せます。</translation>
    </message>
    <message>
        <source>Back to the painting&apos;s own view.</source>
        <translation>絵に設定された視点に戻ります。</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>モーション(&amp;M)</translation>
    </message>
    <message>
        <source>Shows the timeline of motion and camera.</source>
        <translation>動きとカメラのタイムラインを表示します。</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops.</source>
        <translation>動き、絵、カメラの軌道を再生します。もう一度で停止。</translation>
    </message>
    <message>
        <source>&amp;Keep view as key</source>
        <translation>視点をキーとして記録(&amp;K)</translation>
    </message>
    <message>
        <source>Where you look from becomes a key of the camera path at the present time.</source>
        <translation>今の視点が、現在の時点でのカメラ軌道のキーになります。</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>ブラシを大きく(&amp;L)</translation>
    </message>
    <message>
        <source>Wider strokes.</source>
        <translation>ストロークが太くなります。</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>ブラシを小さく(&amp;S)</translation>
    </message>
    <message>
        <source>Finer strokes.</source>
        <translation>ストロークが細くなります。</translation>
    </message>
    <message>
        <source>&amp;Turn view</source>
        <translation>視点を回す(&amp;T)</translation>
    </message>
    <message>
        <source>Drag turns the view. With other tools: the right button.</source>
        <translation>ドラッグで視点を回します。ほかのツールでは右ボタンを使います。</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom, middle button or Shift to pan.</source>
        <translation>ドラッグで回転、ホイールで拡大縮小、中ボタンか Shift で平行移動。</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選択(&amp;S)</translation>
    </message>
    <message>
        <source>A click chooses a stroke, Shift adds, a drag chooses a box, with Ctrl a lasso.</source>
        <translation>クリックでストロークを選択、Shift で追加、ドラッグで矩形、Ctrl で投げ縄になります。</translation>
    </message>
    <message>
        <source>Click a stroke, or drag a box over strokes of the active layer. Ctrl+D copies them into the active layer.</source>
        <translation>作業レイヤーのストロークをクリックか矩形で選びます。Ctrl+D で作業レイヤーにコピーします。</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>移動(&amp;M)</translation>
    </message>
    <message>
        <source>Moves, turns and scales the chosen strokes.</source>
        <translation>選択したストロークを移動、回転、拡大縮小します。</translation>
    </message>
    <message>
        <source>Drag the chosen strokes; the ring turns them (with Shift upright), the square scales them.</source>
        <translation>選択したストロークをドラッグ。リングで回転 (Shift で垂直軸)、四角で拡大縮小します。</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>描く(&amp;P)</translation>
    </message>
    <message>
        <source>Paints into the active layer: a shape in stacks, colour in layers.</source>
        <translation>作業レイヤーに描きます。スタックでは形、レイヤーでは色になります。</translation>
    </message>
    <message>
        <source>Paint on the surface or in the air. Shift draws straight, [ and ] change the size.</source>
        <translation>面の上や空間に描きます。Shift で直線、[ と ] でサイズを変えます。</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>消す(&amp;E)</translation>
    </message>
    <message>
        <source>Takes strokes of the active layer away; with Shift only the touched parts.</source>
        <translation>作業レイヤーのストロークを消します。Shift で触れた部分だけになります。</translation>
    </message>
    <message>
        <source>Drag over strokes of the active layer. With Shift only the touched parts go.</source>
        <translation>作業レイヤーのストロークをドラッグで消します。Shift で触れた部分だけになります。</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>グラデーション(&amp;G)</translation>
    </message>
    <message>
        <source>Fades the active layer along a drag.</source>
        <translation>ドラッグに沿って作業レイヤーを薄れさせます。</translation>
    </message>
    <message>
        <source>Drag from where the layer is full to where it fades out. With Shift around a point.</source>
        <translation>濃い所から消える所へドラッグします。Shift で点のまわりの円形になります。</translation>
    </message>
    <message>
        <source>&amp;What colours this</source>
        <translation>色の出どころ(&amp;W)</translation>
    </message>
    <message>
        <source>A click lists the layers that colour a point.</source>
        <translation>クリックした点に色を付けているレイヤーを一覧します。</translation>
    </message>
    <message>
        <source>Click on the painting: the list shows which layers colour this point, the topmost first.</source>
        <translation>絵をクリックすると、その点に色を付けているレイヤーを上から順に示します。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>レイヤー(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>ブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>There is nothing to export yet; paint or open something first.</source>
        <translation>書き出すものがありません。先に描くか、何かを開いてください。</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>画像の書き出し</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 の書き出し</translation>
    </message>
    <message>
        <source>Exported to %1, %2 x %3 pixels.</source>
        <translation>%1 に書き出しました (%2 x %3 ピクセル)。</translation>
    </message>
    <message>
        <source>There is nothing to film yet; paint or open something first.</source>
        <translation>動画にするものがありません。先に描くか、何かを開いてください。</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>動画の書き出し</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>フォルダー (*)</translation>
    </message>
    <message>
        <source>The film %1 is ready.</source>
        <translation>動画 %1 ができました。</translation>
    </message>
    <message numerus="yes">
        <source>%n films are ready.</source>
        <translation>
            <numerusform>%n 本の動画ができました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>フォルダーで表示</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>メッシュの書き出し</translation>
    </message>
    <message>
        <source>Meshes with colours (*.glb)</source>
        <translation>色付きメッシュ (*.glb)</translation>
    </message>
    <message>
        <source>Exported %L1 triangles with their colours to %2.</source>
        <translation>%L1 個の三角形を色付きで %2 に書き出しました。</translation>
    </message>
    <message>
        <source>LayerPainter</source>
        <translation>LayerPainter</translation>
    </message>
    <message>
        <source>Light, shadow and mood for 3D paintings, layer by layer.</source>
        <translation>3D ペイントに光と影と雰囲気を、レイヤーごとに。</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>新規ペイント</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>開く...</translation>
    </message>
    <message>
        <source>Drop a Quill or .tilt painting, a mesh or a project anywhere.</source>
        <translation>Quill や .tilt の絵、メッシュ、プロジェクトをどこにでもドロップできます。</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Paintings and meshes (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;All files (*)</source>
        <translation>ペイントとメッシュ (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 の読み込み</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>読み込み</translation>
    </message>
    <message>
        <source>Paintings and meshes (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Surfaces of SketchSurfacer (*.ductus)</source>
        <translation>ペイントとメッシュ (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;SketchSurfacer のサーフェス (*.ductus)</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes joined the painting</source>
        <translation>
            <numerusform>%n 本のストロークを加えました</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n stacks.</source>
        <translation>
            <numerusform> (スタック %n 個)。</numerusform>
        </translation>
    </message>
    <message>
        <source> Of drawings frame by frame the first came along.</source>
        <translation> コマ送りの絵は最初の 1 枚だけを取り込みました。</translation>
    </message>
    <message>
        <source>Some of it was skipped: %1</source>
        <translation>一部を読み飛ばしました: %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>ほか %n 件。</numerusform>
        </translation>
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
        <source>Save action log</source>
        <translation>操作ログの保存</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>操作ログ (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>The log of %n actions is saved.</source>
        <translation>
            <numerusform>%n 件の操作ログを保存しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Choose strokes first; the copies go into the active layer.</source>
        <translation>先にストロークを選んでください。コピーは作業レイヤーに入ります。</translation>
    </message>
    <message>
        <source>&amp;Update surfaces</source>
        <translation>サーフェスを更新(&amp;U)</translation>
    </message>
    <message>
        <source>Takes what has changed in the sketches the surfaces were made from; your layers stay.</source>
        <translation>サーフェスの元になったスケッチの変更を取り込みます。レイヤーはそのままです。</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>ストロークをコピー(&amp;C)</translation>
    </message>
    <message>
        <source>Puts the chosen strokes on the clipboard, for this app and the others of the suite.</source>
        <translation>選択したストロークをクリップボードに入れます。スイートのほかのアプリでも使えます。</translation>
    </message>
    <message>
        <source>&amp;Paste strokes</source>
        <translation>ストロークを貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard into the active layer, whichever app they come from.</source>
        <translation>クリップボードのストロークを、どのアプリのものでも作業レイヤーに描きます。</translation>
    </message>
    <message>
        <source>Send strokes to S&amp;ketchSurfacer</source>
        <translation>ストロークを SketchSurfacer に送る(&amp;K)</translation>
    </message>
    <message>
        <source>Makes a sketch of the chosen strokes, or of the active layer, and opens it in SketchSurfacer.</source>
        <translation>選択したストロークか作業レイヤーからスケッチを作り、SketchSurfacer で開きます。</translation>
    </message>
    <message>
        <source>Send to &amp;DoodleStudio</source>
        <translation>DoodleStudio に送る(&amp;D)</translation>
    </message>
    <message>
        <source>Opens DoodleStudio, where this painting can stand in a filmed scene.</source>
        <translation>DoodleStudio を開きます。この絵を映像のシーンに置けます。</translation>
    </message>
    <message>
        <source>Choose strokes first: they are copied then.</source>
        <translation>先にストロークを選んでください。それをコピーします。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>ストロークを %n 本コピーしました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>ストロークを %n 本貼り付けました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose strokes, or a layer with strokes: they become the sketch.</source>
        <translation>ストロークか、ストロークのあるレイヤーを選んでください。それがスケッチになります。</translation>
    </message>
    <message>
        <source>Save the sketch as</source>
        <translation>スケッチを別名で保存</translation>
    </message>
    <message>
        <source> sketch</source>
        <translation> スケッチ</translation>
    </message>
    <message>
        <source>sketch</source>
        <translation>スケッチ</translation>
    </message>
    <message>
        <source>Writing the sketch</source>
        <translation>スケッチの書き込み</translation>
    </message>
    <message>
        <source>There is nothing painted yet.</source>
        <translation>まだ何も描かれていません。</translation>
    </message>
    <message>
        <source>DoodleStudio reads the saved painting, and this one has changes.</source>
        <translation>DoodleStudio は保存済みの絵を読みますが、未保存の変更があります。</translation>
    </message>
    <message>
        <source>Save and send</source>
        <translation>保存して送る</translation>
    </message>
    <message>
        <source>Save as and send...</source>
        <translation>別名で保存して送る...</translation>
    </message>
    <message>
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>%1 opens %2.</source>
        <translation>%1 で %2 を開きます。</translation>
    </message>
    <message>
        <source>The surface</source>
        <translation>サーフェス</translation>
    </message>
    <message>
        <source>Looking for changes of the sketches</source>
        <translation>スケッチの変更を確認</translation>
    </message>
    <message>
        <source>No surface of this painting comes from a sketch.</source>
        <translation>この絵にはスケッチから作ったサーフェスがありません。</translation>
    </message>
    <message>
        <source>All surfaces are as their sketches are.</source>
        <translation>すべてのサーフェスがスケッチと一致しています。</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; changed in SketchSurfacer.</source>
        <translation>「%1」のサーフェスが SketchSurfacer で変更されました。</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces changed in SketchSurfacer.</source>
        <translation>
            <numerusform>%n 個のサーフェスが SketchSurfacer で変更されました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Your layers, strokes and masks stay.</source>
        <translation>更新しますか? レイヤー、ストローク、マスクはそのままです。</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>今はしない</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces are as in their sketches now.</source>
        <translation>
            <numerusform>%n 個のサーフェスをスケッチに合わせました。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is open in another program: this painting is saved in a file of its own and stays linked to the surface.</source>
        <translation>%1 は別のプログラムで開かれています。この絵は独立したファイルに保存され、サーフェスとのリンクは保たれます。</translation>
    </message>
    <message>
        <source>Duplicate &amp;into layer</source>
        <translation>レイヤーに複製(&amp;I)</translation>
    </message>
    <message>
        <source>Rec&amp;olour</source>
        <translation>色を変更(&amp;O)</translation>
    </message>
    <message>
        <source>D&amp;elete layer</source>
        <translation>レイヤーを削除(&amp;E)</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>全体を表示(&amp;A)</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingDocument</name>
    <message>
        <source>Add stack</source>
        <translation>スタックの追加</translation>
    </message>
    <message>
        <source>Delete stack</source>
        <translation>スタックの削除</translation>
    </message>
    <message>
        <source>Move stack</source>
        <translation>スタックの移動</translation>
    </message>
    <message>
        <source>Rename stack</source>
        <translation>スタック名の変更</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>レイヤーの追加</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>レイヤーの削除</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>レイヤーの移動</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>レイヤーの複製</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>レイヤー名の変更</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>レイヤーのロック</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>レイヤーのロック解除</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>レイヤーの表示</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>レイヤーの非表示</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>不透明度の変更</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>合成モードの変更</translation>
    </message>
    <message>
        <source>Change masks</source>
        <translation>マスクの変更</translation>
    </message>
    <message>
        <source>Change layer colour</source>
        <translation>レイヤーの色の変更</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>許容範囲の変更</translation>
    </message>
    <message>
        <source>Move layer in time</source>
        <translation>レイヤーの時間移動</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>ストロークの削除</translation>
    </message>
    <message>
        <source>Delete %1 strokes</source>
        <translation>%1 本のストロークの削除</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Move stroke to layer</source>
        <translation>ストロークをレイヤーに移動</translation>
    </message>
    <message>
        <source>Move %1 strokes to layer</source>
        <translation>%1 本のストロークをレイヤーに移動</translation>
    </message>
    <message>
        <source>Duplicate stroke</source>
        <translation>ストロークの複製</translation>
    </message>
    <message>
        <source>Duplicate %1 strokes</source>
        <translation>%1 本のストロークの複製</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>ストロークの移動</translation>
    </message>
    <message>
        <source>Move %1 strokes</source>
        <translation>%1 本のストロークの移動</translation>
    </message>
    <message>
        <source>Recolour stroke</source>
        <translation>ストロークの色の変更</translation>
    </message>
    <message>
        <source>Recolour %1 strokes</source>
        <translation>%1 本のストロークの色の変更</translation>
    </message>
    <message>
        <source>Add look</source>
        <translation>ルックの追加</translation>
    </message>
    <message>
        <source>Update look</source>
        <translation>ルックの更新</translation>
    </message>
    <message>
        <source>Switch look</source>
        <translation>ルックの切り替え</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>ルック名の変更</translation>
    </message>
    <message>
        <source>Delete look</source>
        <translation>ルックの削除</translation>
    </message>
    <message>
        <source>Change scene</source>
        <translation>シーンの変更</translation>
    </message>
    <message>
        <source>Change camera path</source>
        <translation>カメラ軌道の変更</translation>
    </message>
    <message>
        <source>Add motion group</source>
        <translation>モーショングループの追加</translation>
    </message>
    <message>
        <source>Change motion</source>
        <translation>動きの変更</translation>
    </message>
    <message>
        <source>Delete motion group</source>
        <translation>モーショングループの削除</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 の追加</translation>
    </message>
    <message>
        <source>Update surface</source>
        <translation>サーフェスの更新</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingView</name>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
</context>
<context>
    <name>ductus::PictureDialog</name>
    <message>
        <source>Export picture</source>
        <translation>画像の書き出し</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> ピクセル</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 ピクセル</translation>
    </message>
    <message>
        <source>Without background</source>
        <translation>背景なし</translation>
    </message>
    <message>
        <source>&lt;b&gt;Without background&lt;/b&gt;&lt;br&gt;Where nothing is painted the picture is transparent, to be put on something else.</source>
        <translation>&lt;b&gt;背景なし&lt;/b&gt;&lt;br&gt;何も描かれていない所が透明になり、ほかのものに重ねられます。</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>幅(&amp;W)</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>書き出し...</translation>
    </message>
</context>
<context>
    <name>ductus::PointColours</name>
    <message>
        <source>Looking which layers colour this</source>
        <translation>色を付けているレイヤーの検索</translation>
    </message>
</context>
<context>
    <name>ductus::RoomPanels</name>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Brush and colour</source>
        <translation>ブラシと色</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>左利き</translation>
    </message>
    <message>
        <source>The left hand paints, the right one holds the panels.</source>
        <translation>左手で描き、右手でパネルを持ちます。</translation>
    </message>
    <message>
        <source>Leave VR</source>
        <translation>VR を終了</translation>
    </message>
</context>
</TS>
