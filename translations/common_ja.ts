<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>ductus::ActionSearch</name>
    <message>
        <source>Search actions</source>
        <translation>操作を検索</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>何をしますか?</translation>
    </message>
    <message>
        <source>Found actions</source>
        <translation>見つかった操作</translation>
    </message>
    <message>
        <source>Nothing is called like that.</source>
        <translation>その名前の操作はありません。</translation>
    </message>
</context>
<context>
    <name>ductus::AppearancePage</name>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Dark or light, as the rest of your desktop.</source>
        <translation>デスクトップに合わせて暗色か明色になります。</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>暗色</translation>
    </message>
    <message>
        <source>Lets pictures and strokes stand out.</source>
        <translation>絵やストロークが引き立ちます。</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>明色</translation>
    </message>
    <message>
        <source>Easier to read in bright rooms and on projectors.</source>
        <translation>明るい部屋やプロジェクターで読みやすくなります。</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Pictures you export do not depend on it.</source>
        <translation>書き出す画像には影響しません。</translation>
    </message>
    <message>
        <source>Takes effect when the app is started again.</source>
        <translation>次にアプリを起動したときに反映されます。</translation>
    </message>
</context>
<context>
    <name>ductus::Autosave</name>
    <message>
        <source>Autosaving</source>
        <translation>自動保存</translation>
    </message>
</context>
<context>
    <name>ductus::Document</name>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus</source>
        <translation>新しいバージョンの Ductus で作成されています</translation>
    </message>
</context>
<context>
    <name>ductus::DocumentFiles</name>
    <message>
        <source>the file may not be written</source>
        <translation>ファイルに書き込めません</translation>
    </message>
    <message>
        <source>%1 is open for reading only: %2. Save under another name to keep changes.</source>
        <translation>%1 は読み取り専用で開かれています: %2。変更を残すには別名で保存してください。</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開く</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>ファイルの読み込み</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 の保存</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>ファイルの書き込み</translation>
    </message>
</context>
<context>
    <name>ductus::EngineWords</name>
    <message>
        <source>Adding a group</source>
        <translation>グループの追加</translation>
    </message>
    <message>
        <source>Adding a layer</source>
        <translation>レイヤーの追加</translation>
    </message>
    <message>
        <source>Adding strokes</source>
        <translation>ストロークの追加</translation>
    </message>
    <message>
        <source>Applying a scribble</source>
        <translation>スクリブルの適用</translation>
    </message>
    <message>
        <source>Applying the look</source>
        <translation>ルックの適用</translation>
    </message>
    <message>
        <source>Associating strokes</source>
        <translation>ストロークの対応付け</translation>
    </message>
    <message>
        <source>Associating strokes with the proxy</source>
        <translation>ストロークとプロキシの対応付け</translation>
    </message>
    <message>
        <source>Attracting the proxy</source>
        <translation>プロキシの引き寄せ</translation>
    </message>
    <message>
        <source>Attracting the proxy to the strokes</source>
        <translation>プロキシのストロークへの引き寄せ</translation>
    </message>
    <message>
        <source>Baking the painting</source>
        <translation>絵の色の焼き込み</translation>
    </message>
    <message>
        <source>Changing how long the frame is shown</source>
        <translation>表示時間の変更</translation>
    </message>
    <message>
        <source>Changing the camera path</source>
        <translation>カメラ軌道の変更</translation>
    </message>
    <message>
        <source>Changing the canvas</source>
        <translation>キャンバスの変更</translation>
    </message>
    <message>
        <source>Changing the keyframe</source>
        <translation>キーフレームの変更</translation>
    </message>
    <message>
        <source>Changing the layer</source>
        <translation>レイヤーの変更</translation>
    </message>
    <message>
        <source>Changing the mark</source>
        <translation>描いたものの変更</translation>
    </message>
    <message>
        <source>Changing the motion</source>
        <translation>動きの変更</translation>
    </message>
    <message>
        <source>Changing the scene</source>
        <translation>シーンの変更</translation>
    </message>
    <message>
        <source>Changing the tolerance</source>
        <translation>許容範囲の変更</translation>
    </message>
    <message>
        <source>Checking the painting</source>
        <translation>絵の検査</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>印刷チェック</translation>
    </message>
    <message>
        <source>Checking the project</source>
        <translation>プロジェクトの検査</translation>
    </message>
    <message>
        <source>Contouring the smooth surface</source>
        <translation>滑らかな面の抽出</translation>
    </message>
    <message>
        <source>Cutting the stroke</source>
        <translation>ストロークの切断</translation>
    </message>
    <message>
        <source>Discarding the recovered copy</source>
        <translation>復元コピーの破棄</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>Drawing other readings</source>
        <translation>別の解釈の描画</translation>
    </message>
    <message>
        <source>Drawing the painting</source>
        <translation>絵の描画</translation>
    </message>
    <message>
        <source>Drawing the samples</source>
        <translation>サンプルの描画</translation>
    </message>
    <message>
        <source>Drawing the surface</source>
        <translation>サーフェスの描画</translation>
    </message>
    <message>
        <source>Duplicating strokes</source>
        <translation>ストロークの複製</translation>
    </message>
    <message>
        <source>Duplicating the layer</source>
        <translation>レイヤーの複製</translation>
    </message>
    <message>
        <source>Entering VR</source>
        <translation>VR の開始</translation>
    </message>
    <message>
        <source>Evening out the triangles</source>
        <translation>三角形の均一化</translation>
    </message>
    <message>
        <source>Exporting the film</source>
        <translation>動画の書き出し</translation>
    </message>
    <message>
        <source>Exporting the painting</source>
        <translation>絵の書き出し</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>サーフェスの書き出し</translation>
    </message>
    <message>
        <source>Finding how far away things are</source>
        <translation>距離の推定</translation>
    </message>
    <message>
        <source>Finding how the camera moved</source>
        <translation>カメラの動きの推定</translation>
    </message>
    <message>
        <source>Finding how the scene moves</source>
        <translation>シーンの動きの推定</translation>
    </message>
    <message>
        <source>Finding stroke normals</source>
        <translation>ストロークの法線の推定</translation>
    </message>
    <message>
        <source>Finding surface patches</source>
        <translation>面の区分の検出</translation>
    </message>
    <message>
        <source>Finding what moves by itself</source>
        <translation>独自に動くものの検出</translation>
    </message>
    <message>
        <source>Fitting a smooth surface</source>
        <translation>滑らかな面の当てはめ</translation>
    </message>
    <message>
        <source>Fitting a smooth surface piece by piece</source>
        <translation>滑らかな面の部分ごとの当てはめ</translation>
    </message>
    <message>
        <source>Fitting a smooth surface through the strokes</source>
        <translation>ストロークを通る滑らかな面の当てはめ</translation>
    </message>
    <message>
        <source>Fitting changed strokes</source>
        <translation>変更したストロークの当てはめ</translation>
    </message>
    <message>
        <source>Fitting the final mesh</source>
        <translation>最終メッシュの当てはめ</translation>
    </message>
    <message>
        <source>Fitting the surface</source>
        <translation>サーフェスの当てはめ</translation>
    </message>
    <message>
        <source>Following the canvas</source>
        <translation>キャンバスの追跡</translation>
    </message>
    <message>
        <source>Following the canvases</source>
        <translation>キャンバスの追跡</translation>
    </message>
    <message>
        <source>Importing the painting</source>
        <translation>絵の読み込み</translation>
    </message>
    <message>
        <source>Importing the surface</source>
        <translation>サーフェスの読み込み</translation>
    </message>
    <message>
        <source>Keeping what was found out about the clip</source>
        <translation>クリップの解析結果の保存</translation>
    </message>
    <message>
        <source>Locking the project</source>
        <translation>プロジェクトのロック</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>シーンの解析</translation>
    </message>
    <message>
        <source>Looking for cables</source>
        <translation>ケーブルの検出</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>別の解釈の検索</translation>
    </message>
    <message>
        <source>Looking which clip it is</source>
        <translation>クリップの確認</translation>
    </message>
    <message>
        <source>Making a proxy</source>
        <translation>プロキシの生成</translation>
    </message>
    <message>
        <source>Making a tube along a stroke</source>
        <translation>ストロークに沿ったチューブの生成</translation>
    </message>
    <message>
        <source>Making stacks of the layers</source>
        <translation>レイヤーからのスタック作成</translation>
    </message>
    <message>
        <source>Measuring how exact the points are</source>
        <translation>点の精度の計測</translation>
    </message>
    <message>
        <source>Measuring walls</source>
        <translation>壁の計測</translation>
    </message>
    <message>
        <source>Moving strokes to a layer</source>
        <translation>ストロークのレイヤーへの移動</translation>
    </message>
    <message>
        <source>Moving the canvas</source>
        <translation>キャンバスの移動</translation>
    </message>
    <message>
        <source>Moving the canvas in depth</source>
        <translation>キャンバスの奥行き移動</translation>
    </message>
    <message>
        <source>Moving the keyframe</source>
        <translation>キーフレームの移動</translation>
    </message>
    <message>
        <source>Moving the layer</source>
        <translation>レイヤーの移動</translation>
    </message>
    <message>
        <source>Moving the proxy to the changed strokes</source>
        <translation>変更したストロークへのプロキシの移動</translation>
    </message>
    <message>
        <source>Moving the stack</source>
        <translation>スタックの移動</translation>
    </message>
    <message>
        <source>Opening the clip</source>
        <translation>クリップを開く処理</translation>
    </message>
    <message>
        <source>Opening the painting</source>
        <translation>絵を開く処理</translation>
    </message>
    <message>
        <source>Opening the project</source>
        <translation>プロジェクトを開く処理</translation>
    </message>
    <message>
        <source>Opening the sample</source>
        <translation>サンプルを開く処理</translation>
    </message>
    <message>
        <source>Painting in VR</source>
        <translation>VR での描画</translation>
    </message>
    <message>
        <source>Pasting strokes</source>
        <translation>ストロークの貼り付け</translation>
    </message>
    <message>
        <source>Pinning the canvas</source>
        <translation>キャンバスの固定</translation>
    </message>
    <message>
        <source>Placing the canvas</source>
        <translation>キャンバスの配置</translation>
    </message>
    <message>
        <source>Placing a painting</source>
        <translation>絵の配置</translation>
    </message>
    <message>
        <source>Preparing the frame</source>
        <translation>フレームの準備</translation>
    </message>
    <message>
        <source>Preparing the graphics card</source>
        <translation>グラフィックカードの準備</translation>
    </message>
    <message>
        <source>Reading a texture</source>
        <translation>テクスチャの読み込み</translation>
    </message>
    <message>
        <source>Reading the cameras</source>
        <translation>カメラの読み込み</translation>
    </message>
    <message>
        <source>Reading the clip</source>
        <translation>クリップの読み込み</translation>
    </message>
    <message>
        <source>Reading the depth maps</source>
        <translation>深度マップの読み込み</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>メッシュの読み込み</translation>
    </message>
    <message>
        <source>Reading the painting</source>
        <translation>絵の読み込み</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>画像の読み込み</translation>
    </message>
    <message>
        <source>Reading the points</source>
        <translation>点の読み込み</translation>
    </message>
    <message>
        <source>Reading the project</source>
        <translation>プロジェクトの読み込み</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>プロキシの読み込み</translation>
    </message>
    <message>
        <source>Reading the sketch</source>
        <translation>スケッチの読み込み</translation>
    </message>
    <message>
        <source>Reading the sketch&apos;s size</source>
        <translation>スケッチの大きさの読み取り</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>音声の読み込み</translation>
    </message>
    <message>
        <source>Reading the sound of the clip</source>
        <translation>クリップの音声の読み込み</translation>
    </message>
    <message>
        <source>Reading what was found out about the clip</source>
        <translation>クリップの解析結果の読み込み</translation>
    </message>
    <message>
        <source>Recolouring strokes</source>
        <translation>ストロークの色の変更</translation>
    </message>
    <message>
        <source>Remeshing</source>
        <translation>リメッシュ</translation>
    </message>
    <message>
        <source>Removing strokes</source>
        <translation>ストロークの削除</translation>
    </message>
    <message>
        <source>Removing the canvas</source>
        <translation>キャンバスの削除</translation>
    </message>
    <message>
        <source>Removing the group</source>
        <translation>グループの削除</translation>
    </message>
    <message>
        <source>Removing the keyframe</source>
        <translation>キーフレームの削除</translation>
    </message>
    <message>
        <source>Removing the layer</source>
        <translation>レイヤーの削除</translation>
    </message>
    <message>
        <source>Removing the look</source>
        <translation>ルックの削除</translation>
    </message>
    <message>
        <source>Removing the stack</source>
        <translation>スタックの削除</translation>
    </message>
    <message>
        <source>Renaming the layer</source>
        <translation>レイヤー名の変更</translation>
    </message>
    <message>
        <source>Renaming the look</source>
        <translation>ルック名の変更</translation>
    </message>
    <message>
        <source>Renaming the stack</source>
        <translation>スタック名の変更</translation>
    </message>
    <message>
        <source>Repairing the mesh</source>
        <translation>メッシュの修復</translation>
    </message>
    <message>
        <source>Restoring the chosen reading</source>
        <translation>選んだ解釈の復元</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>プロジェクトの保存</translation>
    </message>
    <message>
        <source>Segmenting the surface</source>
        <translation>サーフェスの領域分割</translation>
    </message>
    <message>
        <source>Surfacing</source>
        <translation>サーフェス化</translation>
    </message>
    <message>
        <source>Surfacing the points</source>
        <translation>点群のサーフェス化</translation>
    </message>
    <message>
        <source>Surfacing the sketch</source>
        <translation>スケッチのサーフェス化</translation>
    </message>
    <message>
        <source>Trimming the open surface</source>
        <translation>開いた面の切り抜き</translation>
    </message>
    <message>
        <source>Turning the canvas</source>
        <translation>キャンバスの回転</translation>
    </message>
    <message>
        <source>Unpacking an entry of the project</source>
        <translation>プロジェクトの項目の展開</translation>
    </message>
    <message>
        <source>Uploading the painting</source>
        <translation>絵のグラフィックカードへの転送</translation>
    </message>
    <message>
        <source>Wrapping the strokes</source>
        <translation>ストロークのラッピング</translation>
    </message>
    <message>
        <source>Writing the action log</source>
        <translation>操作ログの書き込み</translation>
    </message>
    <message>
        <source>Writing the film</source>
        <translation>動画の書き込み</translation>
    </message>
    <message>
        <source>Writing the mesh</source>
        <translation>メッシュの書き込み</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>画像の書き込み</translation>
    </message>
    <message>
        <source>Writing the project</source>
        <translation>プロジェクトの書き込み</translation>
    </message>
    <message>
        <source>Writing the sound</source>
        <translation>音声の書き込み</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>ファイルが空です</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>ファイルを開けません</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>ファイルに書き込めません</translation>
    </message>
    <message>
        <source>the memory does not suffice for it</source>
        <translation>メモリが足りません</translation>
    </message>
    <message>
        <source>this is a PLY mesh</source>
        <translation>これは PLY メッシュです</translation>
    </message>
    <message>
        <source>this is an OFF mesh</source>
        <translation>これは OFF メッシュです</translation>
    </message>
    <message>
        <source>this is an STL mesh</source>
        <translation>これは STL メッシュです</translation>
    </message>
    <message>
        <source>this is a GLB scene</source>
        <translation>これは GLB シーンです</translation>
    </message>
    <message>
        <source>this is a zip archive</source>
        <translation>これは zip アーカイブです</translation>
    </message>
    <message>
        <source>this is a PNG picture</source>
        <translation>これは PNG 画像です</translation>
    </message>
    <message>
        <source>this is JSON</source>
        <translation>これは JSON です</translation>
    </message>
    <message>
        <source>there is no stroke in it</source>
        <translation>ストロークが入っていません</translation>
    </message>
    <message>
        <source>there is no sketch in it</source>
        <translation>スケッチが入っていません</translation>
    </message>
    <message>
        <source>the project holds no painting</source>
        <translation>プロジェクトに絵が入っていません</translation>
    </message>
    <message>
        <source>no stroke lies near the proxy mesh</source>
        <translation>プロキシメッシュの近くにストロークがありません</translation>
    </message>
    <message>
        <source>the sketch has too few strokes for a surface</source>
        <translation>サーフェスを作るにはストロークが足りません</translation>
    </message>
    <message>
        <source>all strokes lie in one plane</source>
        <translation>すべてのストロークが 1 つの平面にあります</translation>
    </message>
    <message>
        <source>the equations are singular</source>
        <translation>方程式が特異です</translation>
    </message>
    <message>
        <source>no piece could be fitted</source>
        <translation>当てはめられる部分がありません</translation>
    </message>
    <message>
        <source>the connection to the headset was lost</source>
        <translation>ヘッドセットとの接続が切れました</translation>
    </message>
    <message>
        <source>no headset is connected or it is switched off</source>
        <translation>ヘッドセットが接続されていないか、電源が切れています</translation>
    </message>
    <message>
        <source>there is no such stack</source>
        <translation>そのスタックはありません</translation>
    </message>
    <message>
        <source>there is no such layer</source>
        <translation>そのレイヤーはありません</translation>
    </message>
    <message>
        <source>there is no such look</source>
        <translation>そのルックはありません</translation>
    </message>
    <message>
        <source>it is not part of this installation</source>
        <translation>インストールに含まれていません</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>パスを確認してください</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>名前を確認してください</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>Choose another folder, or make room on the disk</source>
        <translation>別のフォルダーを選ぶか、ディスクの空きを増やしてください</translation>
    </message>
    <message>
        <source>Make room on the disk</source>
        <translation>ディスクの空きを増やしてください</translation>
    </message>
    <message>
        <source>Free some space and try again</source>
        <translation>空きを増やしてもう一度お試しください</translation>
    </message>
    <message>
        <source>Choose a PNG or JPEG file</source>
        <translation>PNG か JPEG のファイルを選んでください</translation>
    </message>
    <message>
        <source>Choose a file with 3D strokes</source>
        <translation>3D ストロークを含むファイルを選んでください</translation>
    </message>
    <message>
        <source>Choose a file with painted layers</source>
        <translation>描かれたレイヤーを含むファイルを選んでください</translation>
    </message>
    <message>
        <source>Choose it again</source>
        <translation>選び直してください</translation>
    </message>
    <message>
        <source>Correct this line or export the file again</source>
        <translation>この行を直すか、ファイルを書き出し直してください</translation>
    </message>
    <message>
        <source>Correct this line or export the mesh again</source>
        <translation>この行を直すか、メッシュを書き出し直してください</translation>
    </message>
    <message>
        <source>Export the mesh again</source>
        <translation>メッシュを書き出し直してください</translation>
    </message>
    <message>
        <source>Export the sketch again</source>
        <translation>スケッチを書き出し直してください</translation>
    </message>
    <message>
        <source>The file seems cut off: copy or export it again</source>
        <translation>ファイルが途中で切れているようです。コピーか書き出しをやり直してください</translation>
    </message>
    <message>
        <source>Check that this is a text file</source>
        <translation>テキストファイルか確認してください</translation>
    </message>
    <message>
        <source>Draw more strokes, or give a proxy mesh</source>
        <translation>ストロークを増やすか、プロキシメッシュを指定してください</translation>
    </message>
    <message>
        <source>Draw strokes in depth, or give a proxy mesh</source>
        <translation>奥行き方向にもストロークを描くか、プロキシメッシュを指定してください</translation>
    </message>
    <message>
        <source>Give a proxy mesh</source>
        <translation>プロキシメッシュを指定してください</translation>
    </message>
    <message>
        <source>Surface the whole sketch anew</source>
        <translation>スケッチ全体をサーフェス化し直してください</translation>
    </message>
    <message>
        <source>Check that proxy and sketch have the same position, axes and scale</source>
        <translation>プロキシとスケッチの位置、軸、縮尺が同じか確認してください</translation>
    </message>
    <message>
        <source>Repair the mesh or export it again</source>
        <translation>メッシュを修復するか、書き出し直してください</translation>
    </message>
    <message>
        <source>Simplify the mesh first</source>
        <translation>先にメッシュを簡略化してください</translation>
    </message>
    <message>
        <source>Save the project again in Quill</source>
        <translation>Quill でプロジェクトを保存し直してください</translation>
    </message>
    <message>
        <source>Open the previous version of the file, its name ends in ~</source>
        <translation>ファイルの前の版 (名前の末尾が ~) を開いてください</translation>
    </message>
    <message>
        <source>Open it in the app that made it</source>
        <translation>作成したアプリで開いてください</translation>
    </message>
    <message>
        <source>Open it with the app it was made with</source>
        <translation>作成したアプリで開いてください</translation>
    </message>
    <message>
        <source>Install a newer version of Ductus</source>
        <translation>新しいバージョンの Ductus をインストールしてください</translation>
    </message>
    <message>
        <source>Update the graphics driver</source>
        <translation>グラフィックドライバーを更新してください</translation>
    </message>
    <message>
        <source>Update the headset software</source>
        <translation>ヘッドセットのソフトウェアを更新してください</translation>
    </message>
    <message>
        <source>Switch the headset on and try again</source>
        <translation>ヘッドセットの電源を入れて、もう一度お試しください</translation>
    </message>
    <message>
        <source>The painting is still here; connect the headset and enter VR again</source>
        <translation>絵は残っています。ヘッドセットを接続して VR に入り直してください</translation>
    </message>
    <message>
        <source>Choose a stack of this painting</source>
        <translation>この絵のスタックを選んでください</translation>
    </message>
    <message>
        <source>Choose a look of this painting</source>
        <translation>この絵のルックを選んでください</translation>
    </message>
    <message>
        <source>Close other programs or work on a smaller part</source>
        <translation>ほかのソフトを閉じるか、小さい部分で作業してください</translation>
    </message>
    <message>
        <source>Save your work and report this with the file</source>
        <translation>作業を保存し、ファイルを添えて報告してください</translation>
    </message>
    <message>
        <source>Surface the sketch in SketchSurfacer and save it</source>
        <translation>SketchSurfacer でサーフェス化して保存してください</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>アクセス権を確認してください</translation>
    </message>
    <message>
        <source>Choose a layer of this painting</source>
        <translation>この絵のレイヤーを選んでください</translation>
    </message>
    <message>
        <source>Choose a project that was saved in LayerPainter</source>
        <translation>LayerPainter で保存したプロジェクトを選んでください</translation>
    </message>
    <message>
        <source>Choose a video that a player on this computer can show, or a folder of pictures</source>
        <translation>このコンピューターで再生できる動画か、画像のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>Choose a video, or a folder of JPEG or PNG pictures</source>
        <translation>動画か、JPEG または PNG 画像のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>Choose another file, or convert it to MP4 (H.264)</source>
        <translation>別のファイルを選ぶか、MP4 (H.264) に変換してください</translation>
    </message>
    <message>
        <source>Close it there, or open it read-only</source>
        <translation>そちらで閉じるか、読み取り専用で開いてください</translation>
    </message>
    <message>
        <source>Close the other program</source>
        <translation>別のプログラムを閉じてください</translation>
    </message>
    <message>
        <source>Copy fewer strokes</source>
        <translation>コピーするストロークを減らしてください</translation>
    </message>
    <message>
        <source>Copy strokes in an app of the suite first</source>
        <translation>先にスイートのアプリでストロークをコピーしてください</translation>
    </message>
    <message>
        <source>Copy the file to another disk and try again</source>
        <translation>ファイルを別のディスクにコピーして、もう一度お試しください</translation>
    </message>
    <message>
        <source>Draw it from border to border of a region, or closed up to a ring</source>
        <translation>領域の縁から縁まで、または輪になるように描いてください</translation>
    </message>
    <message>
        <source>Free some space or save to another place</source>
        <translation>空きを増やすか、別の場所に保存してください</translation>
    </message>
    <message>
        <source>Give a scale above zero</source>
        <translation>0 より大きい倍率を指定してください</translation>
    </message>
    <message>
        <source>Give a value inside its range</source>
        <translation>範囲内の値を指定してください</translation>
    </message>
    <message>
        <source>Go on with what was taken from it</source>
        <translation>取り込み済みの内容で続けてください</translation>
    </message>
    <message>
        <source>Install and start the software of your headset, such as SteamVR or Monado, and make it the active OpenXR runtime</source>
        <translation>SteamVR や Monado などのソフトウェアをインストールして起動し、OpenXR のアクティブなランタイムにしてください</translation>
    </message>
    <message>
        <source>Install it beside this one, or put its folder into PATH</source>
        <translation>このアプリと同じ場所にインストールするか、フォルダーを PATH に加えてください</translation>
    </message>
    <message>
        <source>Make it smaller</source>
        <translation>小さくしてください</translation>
    </message>
    <message>
        <source>Make room on the disk or check the folder&apos;s permissions</source>
        <translation>ディスクの空きかフォルダーの権限を確認してください</translation>
    </message>
    <message>
        <source>Mark the strokes along the border of the surface, and no others, as boundary</source>
        <translation>サーフェスの縁に沿うストロークだけを縁に指定してください</translation>
    </message>
    <message>
        <source>MP4 has no transparency</source>
        <translation>MP4 は透明にできません</translation>
    </message>
    <message>
        <source>No mirror plane was found; the whole sketch is surfaced.</source>
        <translation>対称面が見つからないため、スケッチ全体をサーフェス化します。</translation>
    </message>
    <message>
        <source>Open it read-only or save a copy elsewhere</source>
        <translation>読み取り専用で開くか、別の場所にコピーを保存してください</translation>
    </message>
    <message>
        <source>Put it back, or go on with what was taken from it</source>
        <translation>元に戻すか、取り込み済みの内容で続けてください</translation>
    </message>
    <message>
        <source>Remove it as a whole</source>
        <translation>全体を取り除いてください</translation>
    </message>
    <message>
        <source>Remove that mask first</source>
        <translation>先にそのマスクを取り除いてください</translation>
    </message>
    <message>
        <source>Remove the lock first</source>
        <translation>先にロックを解除してください</translation>
    </message>
    <message>
        <source>Remove the whole stack</source>
        <translation>スタックごと取り除いてください</translation>
    </message>
    <message>
        <source>Save it again</source>
        <translation>保存し直してください</translation>
    </message>
    <message>
        <source>Save to another disk</source>
        <translation>別のディスクに保存してください</translation>
    </message>
    <message>
        <source>Save to another place</source>
        <translation>別の場所に保存してください</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>別の名前で保存してください</translation>
    </message>
    <message>
        <source>Scale it less</source>
        <translation>拡大縮小の度合いを減らしてください</translation>
    </message>
    <message>
        <source>Show a stack that has strokes</source>
        <translation>ストロークのあるスタックを表示してください</translation>
    </message>
    <message>
        <source>Surface it in SketchSurfacer and save it</source>
        <translation>SketchSurfacer でサーフェス化して保存してください</translation>
    </message>
    <message>
        <source>Unlock it first</source>
        <translation>先にロックを解除してください</translation>
    </message>
    <message>
        <source>a chosen stroke is not in the painting</source>
        <translation>選択したストロークが絵の中にありません</translation>
    </message>
    <message>
        <source>a stack has one substrate</source>
        <translation>スタックの下地は 1 つです</translation>
    </message>
    <message>
        <source>a stroke would become too large or too small</source>
        <translation>ストロークが大きすぎるか小さすぎる状態になります</translation>
    </message>
    <message>
        <source>a substrate stays with its stack</source>
        <translation>下地はスタックから離せません</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>すべての点が 1 つの平面にあります</translation>
    </message>
    <message>
        <source>another program uses the headset</source>
        <translation>別のプログラムがヘッドセットを使用中です</translation>
    </message>
    <message>
        <source>every painting has a scene stack</source>
        <translation>どの絵にもシーンのスタックが必要です</translation>
    </message>
    <message>
        <source>it does not part a region</source>
        <translation>領域を分割していません</translation>
    </message>
    <message>
        <source>it has no finished surface now</source>
        <translation>今は完成したサーフェスがありません</translation>
    </message>
    <message>
        <source>it is a mesh</source>
        <translation>メッシュです</translation>
    </message>
    <message>
        <source>it is not in its project any more</source>
        <translation>プロジェクトの中にもうありません</translation>
    </message>
    <message>
        <source>it is not there any more</source>
        <translation>もう存在しません</translation>
    </message>
    <message>
        <source>it is the only one</source>
        <translation>これが唯一のものです</translation>
    </message>
    <message>
        <source>it lies far from the surface</source>
        <translation>サーフェスから離れています</translation>
    </message>
    <message>
        <source>it lies in a locked region</source>
        <translation>ロックされた領域にあります</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus and may only be read</source>
        <translation>新しいバージョンの Ductus で作成されており、読み取りのみ可能です</translation>
    </message>
    <message>
        <source>its project is not where it was</source>
        <translation>プロジェクトが元の場所にありません</translation>
    </message>
    <message>
        <source>its size is not positive</source>
        <translation>サイズが正の値ではありません</translation>
    </message>
    <message>
        <source>no frame in it can be decoded</source>
        <translation>デコードできるフレームがありません</translation>
    </message>
    <message>
        <source>no headset software (OpenXR runtime) was found</source>
        <translation>ヘッドセットのソフトウェア (OpenXR ランタイム) が見つかりません</translation>
    </message>
    <message>
        <source>no layer of it holds strokes</source>
        <translation>ストロークを含むレイヤーがありません</translation>
    </message>
    <message>
        <source>no stack of it is visible</source>
        <translation>表示されているスタックがありません</translation>
    </message>
    <message>
        <source>the boundary strokes enclose nothing on the proxy</source>
        <translation>縁のストロークがプロキシ上で何も囲んでいません</translation>
    </message>
    <message>
        <source>the clipboard holds no strokes</source>
        <translation>クリップボードにストロークがありません</translation>
    </message>
    <message>
        <source>the disk gives back other bytes than were written</source>
        <translation>書き込んだ内容と異なるデータがディスクから返されました</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>ファイルは読み取り専用です</translation>
    </message>
    <message>
        <source>the film has no frames</source>
        <translation>動画にフレームがありません</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>フォルダーを作成できません</translation>
    </message>
    <message>
        <source>the grid would be too fine</source>
        <translation>格子が細かくなりすぎます</translation>
    </message>
    <message>
        <source>the headset software stopped</source>
        <translation>ヘッドセットのソフトウェアが停止しました</translation>
    </message>
    <message>
        <source>the layer has no such drawing</source>
        <translation>レイヤーにその絵はありません</translation>
    </message>
    <message>
        <source>the layer is locked</source>
        <translation>レイヤーがロックされています</translation>
    </message>
    <message>
        <source>the layers above colour it</source>
        <translation>上のレイヤーが色を付けています</translation>
    </message>
    <message>
        <source>the memory ran out</source>
        <translation>メモリが足りなくなりました</translation>
    </message>
    <message>
        <source>the painting has no strokes</source>
        <translation>絵にストロークがありません</translation>
    </message>
    <message>
        <source>the painting would have too many vertices</source>
        <translation>頂点が多くなりすぎます</translation>
    </message>
    <message>
        <source>the pictures differ in size</source>
        <translation>画像のサイズが揃っていません</translation>
    </message>
    <message>
        <source>the program does not start</source>
        <translation>プログラムが起動しません</translation>
    </message>
    <message>
        <source>the program is not installed</source>
        <translation>プログラムがインストールされていません</translation>
    </message>
    <message>
        <source>the project holds no filmed scene</source>
        <translation>プロジェクトに撮影シーンが入っていません</translation>
    </message>
    <message>
        <source>the project holds no finished surface</source>
        <translation>プロジェクトに完成したサーフェスがありません</translation>
    </message>
    <message>
        <source>the project is not where it was saved</source>
        <translation>プロジェクトが保存した場所にありません</translation>
    </message>
    <message>
        <source>the scene stack stays above all others</source>
        <translation>シーンのスタックは常に一番上です</translation>
    </message>
    <message>
        <source>the size or the checksum does not match, the file is damaged</source>
        <translation>サイズかチェックサムが合わず、ファイルが壊れています</translation>
    </message>
    <message>
        <source>the smooth surface does not end near the strokes</source>
        <translation>滑らかな面がストロークの近くで終わりません</translation>
    </message>
    <message>
        <source>the stroke is not in the painting</source>
        <translation>ストロークが絵の中にありません</translation>
    </message>
    <message>
        <source>there are no pictures in this folder</source>
        <translation>このフォルダーに画像がありません</translation>
    </message>
    <message>
        <source>there are too many of them</source>
        <translation>多すぎます</translation>
    </message>
    <message>
        <source>there is already one in that frame</source>
        <translation>そのフレームにはすでにあります</translation>
    </message>
    <message>
        <source>there is no video in it that can be decoded</source>
        <translation>再生できる映像が入っていません</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>このファイルにはメモリが足りません</translation>
    </message>
    <message>
        <source>there is not enough memory to write the project</source>
        <translation>プロジェクトを書き込むにはメモリが足りません</translation>
    </message>
    <message>
        <source>this field is missing</source>
        <translation>この項目がありません</translation>
    </message>
    <message>
        <source>this is a container of another kind, not a Ductus project</source>
        <translation>別の種類のコンテナーで、Ductus のプロジェクトではありません</translation>
    </message>
    <message>
        <source>this is not a Ductus project</source>
        <translation>Ductus のプロジェクトではありません</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>ファイルではありません</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>正しい JSON ではありません</translation>
    </message>
    <message>
        <source>this picture cannot be decoded</source>
        <translation>この画像をデコードできません</translation>
    </message>
</context>
<context>
    <name>ductus::FoldingSection</name>
    <message>
        <source>%1, folded</source>
        <translation>%1、折りたたみ</translation>
    </message>
    <message>
        <source>%1, unfolded</source>
        <translation>%1、展開</translation>
    </message>
</context>
<context>
    <name>ductus::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>The manual is missing in this installation: %1.</source>
        <translation>マニュアルがインストールされていません: %1。</translation>
    </message>
</context>
<context>
    <name>ductus::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>インスペクター</translation>
    </message>
</context>
<context>
    <name>ductus::JobChip</name>
    <message>
        <source>Running jobs</source>
        <translation>実行中のジョブ</translation>
    </message>
    <message>
        <source>What is being worked on. Click for the list.</source>
        <translation>現在の処理です。クリックで一覧を表示します。</translation>
    </message>
    <message>
        <source>Cancel job</source>
        <translation>ジョブを中止</translation>
    </message>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>このジョブを止めます。以前の結果はそのまま残ります。</translation>
    </message>
</context>
<context>
    <name>ductus::JobPopup</name>
    <message>
        <source>Nothing is running.</source>
        <translation>実行中のジョブはありません。</translation>
    </message>
    <message>
        <source>Running jobs</source>
        <translation>実行中のジョブ</translation>
    </message>
</context>
<context>
    <name>ductus::JobRow</name>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>このジョブを止めます。以前の結果はそのまま残ります。</translation>
    </message>
    <message>
        <source>Cancel %1</source>
        <translation>中止: %1</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>待機中</translation>
    </message>
</context>
<context>
    <name>ductus::JobWords</name>
    <message>
        <source>a few seconds</source>
        <translation>数秒</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>約 %1 秒</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>約 %1 分</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>約 %1 時間</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>停止中: %1</translation>
    </message>
    <message>
        <source>Waiting: %1</source>
        <translation>待機中: %1</translation>
    </message>
</context>
<context>
    <name>ductus::MainWindowShell</name>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>&amp;Inspector</source>
        <translation>インスペクター(&amp;I)</translation>
    </message>
    <message>
        <source>Shows or hides the column at the right.</source>
        <translation>右側の列の表示を切り替えます。</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>履歴(&amp;H)</translation>
    </message>
    <message>
        <source>Lists all edits; a click goes back to one.</source>
        <translation>編集の一覧です。クリックするとその時点に戻ります。</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全画面表示(&amp;F)</translation>
    </message>
    <message>
        <source>Leaves everything but this window away.</source>
        <translation>このウィンドウだけを表示します。</translation>
    </message>
    <message>
        <source>Theme as the &amp;system</source>
        <translation>システムのテーマ(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>暗色テーマ(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>明色テーマ(&amp;L)</translation>
    </message>
    <message>
        <source>Changes the colours of this app, not of your work.</source>
        <translation>アプリの配色だけが変わり、作品の色は変わりません。</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>設定(&amp;T)...</translation>
    </message>
    <message>
        <source>Theme, keys, tablet.</source>
        <translation>テーマ、ショートカット、ペンタブレット。</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>&amp;Search actions...</source>
        <translation>操作を検索(&amp;S)...</translation>
    </message>
    <message>
        <source>Type what you want to do; Enter does it.</source>
        <translation>したいことを入力し、Enter キーで実行します。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>Opens the manual at what you are working with.</source>
        <translation>作業中の内容に合わせてマニュアルを開きます。</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Closes this window; asks before anything is lost.</source>
        <translation>ウィンドウを閉じます。失われるものがあれば確認します。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation>直前の編集を取り消します。</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>取り消した編集をもう一度行います。</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>元に戻す: %1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>やり直す: %1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Tablet</source>
        <translation>ペンタブレット</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>「%1」への変更を保存しますか?</translation>
    </message>
    <message>
        <source>Without saving, what you did since the last save is lost.</source>
        <translation>保存しないと、最後の保存以降の作業が失われます。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard changes</source>
        <translation>変更を破棄(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (読み取り専用)</translation>
    </message>
</context>
<context>
    <name>ductus::MessageBar</name>
    <message>
        <source>%1 failed: %2%3.</source>
        <translation>%1に失敗しました: %2%3。</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>メッセージを閉じる</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>このメッセージを閉じる (Esc)</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>ほか %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>.</source>
        <comment>ends a sentence</comment>
        <translation>。</translation>
    </message>
</context>
<context>
    <name>ductus::PressureCurveEditor</name>
    <message>
        <source>Pressure curve</source>
        <translation>筆圧カーブ</translation>
    </message>
    <message>
        <source>Left and right choose a point, Ctrl with the arrow keys moves it.</source>
        <translation>左右キーで点を選び、Ctrl+矢印キーで動かします。</translation>
    </message>
    <message>
        <source>Drag the points. Left: a light touch, right: pressed hard; up: counts more.</source>
        <translation>点をドラッグします。左は弱い筆圧、右は強い筆圧、上ほど効きが強くなります。</translation>
    </message>
</context>
<context>
    <name>ductus::PressureTestField</name>
    <message>
        <source>Test field for the pen</source>
        <translation>ペンの試し書き欄</translation>
    </message>
    <message>
        <source>Draw here with your pen to try the curve.</source>
        <translation>ここにペンで描いてカーブを試せます。</translation>
    </message>
</context>
<context>
    <name>ductus::RecentRow</name>
    <message>
        <source>%1, missing</source>
        <translation>%1、見つかりません</translation>
    </message>
    <message>
        <source>not there any more</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>開く(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Take off this list</source>
        <translation>一覧から外す(&amp;T)</translation>
    </message>
</context>
<context>
    <name>ductus::RecoveryNotice</name>
    <message>
        <source>Today %1</source>
        <translation>今日 %1</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存の作業</translation>
    </message>
    <message>
        <source>Unsaved work from last time</source>
        <translation>前回の未保存の作業</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Open the unsaved %1</source>
        <translation>未保存の %1 を開く</translation>
    </message>
    <message>
        <source>Discard the unsaved %1</source>
        <translation>未保存の %1 を破棄</translation>
    </message>
</context>
<context>
    <name>ductus::SampleWords</name>
    <message>
        <source>Saloon car</source>
        <translation>セダン</translation>
    </message>
    <message>
        <source>Symmetric sketch with sharp shoulder, pillars and detail strokes: half is solved and mirrored.</source>
        <translation>鋭い肩線と柱のある対称形。半分を計算して鏡映します。</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>ボトル</translation>
    </message>
    <message>
        <source>Round shapes with sharp rings: a crease at the shoulder, none along the meridians.</source>
        <translation>鋭いリングのある丸い形。クリースは肩にだけ入ります。</translation>
    </message>
    <message>
        <source>Box with a bevel</source>
        <translation>面取りした箱</translation>
    </message>
    <message>
        <source>Flat faces meet in straight edges although every stroke is a little off.</source>
        <translation>線が少しずれていても、平らな面がまっすぐな辺で交わります。</translation>
    </message>
    <message>
        <source>Folded leaf</source>
        <translation>折れた葉</translation>
    </message>
    <message>
        <source>An open shell: boundary strokes say where the surface ends, the midrib is a fold.</source>
        <translation>開いたシェル。縁の線が面の終わりを示し、葉脈が折れ目です。</translation>
    </message>
    <message>
        <source>Computer mouse</source>
        <translation>コンピューターのマウス</translation>
    </message>
    <message>
        <source>A smooth dome with a sharp belt: detail strokes lie on the surface and bend nothing.</source>
        <translation>鋭い帯のある滑らかなドーム。細部の線は形を曲げません。</translation>
    </message>
    <message>
        <source>Table lamp</source>
        <translation>卓上ランプ</translation>
    </message>
    <message>
        <source>Thick and thin parts in one sketch: the stem needs a tight proxy.</source>
        <translation>太い部分と細い部分。支柱には密着したプロキシが必要です。</translation>
    </message>
    <message>
        <source>Iron with a handle</source>
        <translation>取っ手付きアイロン</translation>
    </message>
    <message>
        <source>A closed surface with a hole: the proxy must find the way through the handle.</source>
        <translation>穴のある閉じた面。プロキシが取っ手の穴を見つけます。</translation>
    </message>
    <message>
        <source>Forest path</source>
        <translation>森の小道</translation>
    </message>
    <message>
        <source>Two looks, day and dawn: light is a layer of strokes, mist a gradient.</source>
        <translation>昼と夜明けのルック。光はレイヤー、霧はグラデーション。</translation>
    </message>
    <message>
        <source>Over the clouds</source>
        <translation>雲の上</translation>
    </message>
    <message>
        <source>Shadows are copies of strokes with tolerance; plane and shadow move as one.</source>
        <translation>影はストロークのコピー。飛行機と影が一緒に動きます。</translation>
    </message>
    <message>
        <source>Desk by day and night</source>
        <translation>昼と夜の机</translation>
    </message>
    <message>
        <source>A sunbeam through the window, a lamp for the night: one scene, two looks.</source>
        <translation>窓からの日差しと夜のランプ。1 つのシーンに 2 つのルックです。</translation>
    </message>
    <message>
        <source>Passing box</source>
        <translation>通り過ぎる箱</translation>
    </message>
    <message>
        <source>A face follows the box behind the post; words and arrow stay in the room.</source>
        <translation>顔が箱を追って柱の後ろへ。文字と矢印は部屋にとどまります。</translation>
    </message>
    <message>
        <source>Walk through the room</source>
        <translation>部屋を歩く</translation>
    </message>
    <message>
        <source>Labels and stickers keep their place in the room while the camera walks in.</source>
        <translation>カメラが進んでも、ラベルとスタンプは同じ場所に。</translation>
    </message>
    <message>
        <source>One vase, three glazes</source>
        <translation>1 つの花瓶、3 つの釉薬</translation>
    </message>
    <message>
        <source>Ornament is painted once; looks give every layer another colour.</source>
        <translation>模様は 1 度だけ。ルックごとに各レイヤーの色が変わります。</translation>
    </message>
    <message>
        <source>Campfire</source>
        <translation>たき火</translation>
    </message>
    <message>
        <source>Flames are five drawings shown in turn; night and firelight are gradients.</source>
        <translation>炎は 5 枚の絵。夜と火の明かりはグラデーションです。</translation>
    </message>
    <message>
        <source>Lighthouse</source>
        <translation>灯台</translation>
    </message>
    <message>
        <source>Noise makes foam and crests, the beam is clear paint that turns.</source>
        <translation>ノイズが泡と波頭に。光の筋は回転する明るい色です。</translation>
    </message>
    <message>
        <source>Koi pond</source>
        <translation>鯉の池</translation>
    </message>
    <message>
        <source>Spots reach no further than the fish they touch; shadows swim along.</source>
        <translation>模様は触れている魚からはみ出さず、影も一緒に泳ぎます。</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation>振り子</translation>
    </message>
    <message>
        <source>A still camera; the arrow rides on the bob and is drawn anew twelve times a swing.</source>
        <translation>静止したカメラ。矢印は 1 往復に 12 回描き直されます。</translation>
    </message>
    <message>
        <source>Chalk in the yard</source>
        <translation>中庭のチョーク</translation>
    </message>
    <message>
        <source>Canvases lie on the ground and on the wall and keep their perspective as the camera goes by.</source>
        <translation>地面と壁のキャンバスが、カメラが通り過ぎても遠近を保ちます。</translation>
    </message>
    <message>
        <source>A ghost in the store</source>
        <translation>倉庫の幽霊</translation>
    </message>
    <message>
        <source>Six drawings in a loop; keyframes carry them around the post and behind the boxes.</source>
        <translation>6 枚の絵のループ。キーフレームで柱を回り、箱の後ろへ動きます。</translation>
    </message>
    <message>
        <source>Over the hills</source>
        <translation>丘を越えて</translation>
    </message>
    <message>
        <source>The camera only turns: birds fly by keyframes, one of them behind the house.</source>
        <translation>カメラは回るだけ。鳥の 1 羽は家の後ろを通ります。</translation>
    </message>
</context>
<context>
    <name>ductus::SegmentedSwitch</name>
    <message>
        <source>Hold the key to peek.</source>
        <translation>キーを押している間だけ表示します。</translation>
    </message>
</context>
<context>
    <name>ductus::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>ductus::ShortcutsPage</name>
    <message>
        <source>&amp;Use it here instead</source>
        <translation>こちらで使う(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>既定に戻す(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>なし(&amp;N)</translation>
    </message>
    <message>
        <source>Filter by name or keys</source>
        <translation>名前かキーで絞り込み</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>操作とショートカット</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>新しいキー</translation>
    </message>
    <message>
        <source>Click here and press the new keys.</source>
        <translation>ここをクリックして新しいキーを押します。</translation>
    </message>
    <message>
        <source>Conflict</source>
        <translation>競合</translation>
    </message>
    <message>
        <source>Default keys</source>
        <translation>既定のキー</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>キーなし</translation>
    </message>
    <message>
        <source>Use it here instead</source>
        <translation>こちらで使う</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>キー(&amp;K)</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>%1 is taken by: %2.</source>
        <translation>%1 はすでに使われています: %2。</translation>
    </message>
</context>
<context>
    <name>ductus::StartPage</name>
    <message>
        <source>&amp;New</source>
        <translation>新規(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近のファイル</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>スタート</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>Or drop a file anywhere in this window.</source>
        <translation>ファイルをこのウィンドウにドロップしても開けます。</translation>
    </message>
    <message>
        <source>Files you open will be listed here.</source>
        <translation>開いたファイルがここに表示されます。</translation>
    </message>
</context>
<context>
    <name>ductus::TabletPage</name>
    <message>
        <source>&amp;Straight line</source>
        <translation>直線(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Clean field</source>
        <translation>欄を消去(&amp;C)</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>試し書き</translation>
    </message>
    <message>
        <source>Raise the left part if you press lightly, lower it if you press hard. The other end of the pen erases.</source>
        <translation>筆圧が弱い方は左側を上げ、強い方は下げてください。ペンの反対側は消しゴムになります。</translation>
    </message>
    <message>
        <source>Straight line</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>Clean field</source>
        <translation>欄を消去</translation>
    </message>
</context>
<context>
    <name>ductus::ToolRail</name>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
</context>
<context>
    <name>ductus::TopRow</name>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>All menus</source>
        <translation>すべてのメニュー</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>操作を検索</translation>
    </message>
</context>
<context>
    <name>ductus::UndoPanel</name>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Close history</source>
        <translation>履歴を閉じる</translation>
    </message>
    <message>
        <source>Close the history</source>
        <translation>履歴を閉じます</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>編集の履歴</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>開いた時の状態</translation>
    </message>
</context>
<context>
    <name>ductus::UnsavedWork</name>
    <message>
        <source>Looking for unsaved work</source>
        <translation>未保存の作業を検索</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開く</translation>
    </message>
</context>
</TS>
