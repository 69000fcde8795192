<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>app::ActionTable</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Annotate</source>
        <translation>标注(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>转到(&amp;G)</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>拟合(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Open a dataset...</source>
        <translation>打开数据集(&amp;O)...</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>打开演示(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Import annotations...</source>
        <translation>导入标注(&amp;I)...</translation>
    </message>
    <message>
        <source>&amp;Export annotations...</source>
        <translation>导出标注(&amp;E)...</translation>
    </message>
    <message>
        <source>&amp;Report on the annotations...</source>
        <translation>标注报告(&amp;R)...</translation>
    </message>
    <message>
        <source>A page with progress, raters, worst joints and figures</source>
        <translation>包含进度、标注者、最差关节和图表的页面</translation>
    </message>
    <message>
        <source>&amp;Save the views as a picture...</source>
        <translation>将视图另存为图片(&amp;S)...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Note on this frame...</source>
        <translation>本帧备注(&amp;N)...</translation>
    </message>
    <message>
        <source>Your n&amp;ame...</source>
        <translation>您的名字(&amp;A)...</translation>
    </message>
    <message>
        <source>The name that your marks are kept under</source>
        <translation>您的标记以此名字保存</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>检视(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Benchmark</source>
        <translation>基准测试(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Hide all overlays</source>
        <translation>隐藏所有叠加层(&amp;H)</translation>
    </message>
    <message>
        <source>While the key is held</source>
        <translation>按住按键期间有效</translation>
    </message>
    <message>
        <source>Error lines three times as &amp;long</source>
        <translation>误差线放大到三倍(&amp;L)</translation>
    </message>
    <message>
        <source>Lou&amp;pe</source>
        <translation>放大镜(&amp;P)</translation>
    </message>
    <message>
        <source>Magnifies the pixels around the pointer</source>
        <translation>放大指针周围的像素</translation>
    </message>
    <message>
        <source>S&amp;keleton</source>
        <translation>骨架(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Epipolar guides</source>
        <translation>极线(&amp;E)</translation>
    </message>
    <message>
        <source>Lines on which the selected joint must lie, as the other views say</source>
        <translation>根据其他视图，所选关节必定位于这些线上</translation>
    </message>
    <message>
        <source>P&amp;re-placed marks</source>
        <translation>预置标记(&amp;R)</translation>
    </message>
    <message>
        <source>Marks that wait to be accepted</source>
        <translation>等待接受的标记</translation>
    </message>
    <message>
        <source>Joint &amp;names</source>
        <translation>关节名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Follow the selected joint</source>
        <translation>跟随所选关节(&amp;F)</translation>
    </message>
    <message>
        <source>Keeps the selected joint in the middle of every zoomed view</source>
        <translation>在每个放大的视图中使所选关节保持居中</translation>
    </message>
    <message>
        <source>Mesh: sha&amp;ded</source>
        <translation>网格：着色(&amp;D)</translation>
    </message>
    <message>
        <source>Mesh: &amp;wireframe</source>
        <translation>网格：线框(&amp;W)</translation>
    </message>
    <message>
        <source>Mesh: o&amp;ff</source>
        <translation>网格：关闭(&amp;X)</translation>
    </message>
    <message>
        <source>Next mesh st&amp;yle</source>
        <translation>下一种网格样式(&amp;Y)</translation>
    </message>
    <message>
        <source>Mesh more &amp;opaque</source>
        <translation>提高网格不透明度(&amp;O)</translation>
    </message>
    <message>
        <source>Mesh more &amp;transparent</source>
        <translation>提高网格透明度(&amp;T)</translation>
    </message>
    <message>
        <source>Mesh of the left hand</source>
        <translation>左手网格</translation>
    </message>
    <message>
        <source>Mesh of the right hand</source>
        <translation>右手网格</translation>
    </message>
    <message>
        <source>Mesh of the recorded pose</source>
        <translation>记录姿态的网格</translation>
    </message>
    <message>
        <source>Mesh of the fit&apos;s start pose</source>
        <translation>拟合起始姿态的网格</translation>
    </message>
    <message>
        <source>Hand &amp;model of the marks</source>
        <translation>标记对应的手部模型(&amp;M)</translation>
    </message>
    <message>
        <source>The hand model, fitted to the 3D joints of this frame</source>
        <translation>弯曲贴合到本帧 3D 关节的手部模型</translation>
    </message>
    <message>
        <source>&amp;Brightness, contrast, gamma...</source>
        <translation>亮度、对比度、伽马(&amp;S)...</translation>
    </message>
    <message>
        <source>Of the current view or of all</source>
        <translation>针对当前视图或所有视图</translation>
    </message>
    <message>
        <source>&amp;Cameras: hide, reorder...</source>
        <translation>相机：隐藏、排序(&amp;C)...</translation>
    </message>
    <message>
        <source>Sho&amp;w whole images</source>
        <translation>显示完整图像(&amp;Q)</translation>
    </message>
    <message>
        <source>Ends zoom and pan in all views</source>
        <translation>取消所有视图的缩放和平移</translation>
    </message>
    <message>
        <source>&amp;Zoom all views to the joint</source>
        <translation>将所有视图缩放到关节(&amp;Z)</translation>
    </message>
    <message>
        <source>Maximise view 1</source>
        <translation>最大化视图 1</translation>
    </message>
    <message>
        <source>Maximise view 2</source>
        <translation>最大化视图 2</translation>
    </message>
    <message>
        <source>Maximise view 3</source>
        <translation>最大化视图 3</translation>
    </message>
    <message>
        <source>Maximise view 4</source>
        <translation>最大化视图 4</translation>
    </message>
    <message>
        <source>Maximise view 5</source>
        <translation>最大化视图 5</translation>
    </message>
    <message>
        <source>Maximise view 6</source>
        <translation>最大化视图 6</translation>
    </message>
    <message>
        <source>Maximise view 7</source>
        <translation>最大化视图 7</translation>
    </message>
    <message>
        <source>Maximise view 8</source>
        <translation>最大化视图 8</translation>
    </message>
    <message>
        <source>All views again</source>
        <translation>恢复显示所有视图</translation>
    </message>
    <message>
        <source>Reset the 3D sc&amp;ene</source>
        <translation>重置 3D 场景(&amp;J)</translation>
    </message>
    <message>
        <source>Look thro&amp;ugh the current camera</source>
        <translation>从当前相机观察(&amp;U)</translation>
    </message>
    <message>
        <source>The 3D scene from the current camera</source>
        <translation>从当前相机视角显示 3D 场景</translation>
    </message>
    <message>
        <source>Li&amp;ght colours</source>
        <translation>浅色主题(&amp;G)</translation>
    </message>
    <message>
        <source>Full scree&amp;n</source>
        <translation>全屏(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Accept the pre-placed mark</source>
        <translation>接受预置标记(&amp;A)</translation>
    </message>
    <message>
        <source>In the current view or, if that has a mark, in the next one without</source>
        <translation>在当前视图中；若其已有标记，则在下一个没有标记的视图中</translation>
    </message>
    <message>
        <source>Accept in all &amp;views</source>
        <translation>在所有视图中接受(&amp;V)</translation>
    </message>
    <message>
        <source>Accept all joints of the &amp;frame</source>
        <translation>接受本帧的所有关节(&amp;F)</translation>
    </message>
    <message>
        <source>Propose the &amp;rest from the hand model</source>
        <translation>用手部模型建议其余关节(&amp;R)</translation>
    </message>
    <message>
        <source>Fits the hand model to the 3D joints of this frame and places the others, to be checked</source>
        <translation>将手部模型拟合到本帧的 3D 关节并放置其余关节，待检查</translation>
    </message>
    <message>
        <source>&amp;Delete the mark</source>
        <translation>删除标记(&amp;D)</translation>
    </message>
    <message>
        <source>Of the selected joint in the current view</source>
        <translation>当前视图中所选关节的标记</translation>
    </message>
    <message>
        <source>Delete in all vie&amp;ws</source>
        <translation>在所有视图中删除(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Occluded, estimated</source>
        <translation>遮挡，位置为估计(&amp;O)</translation>
    </message>
    <message>
        <source>The joint is hidden here; its place is a guess</source>
        <translation>关节在此处不可见，其位置为推测</translation>
    </message>
    <message>
        <source>&amp;Cannot be placed here</source>
        <translation>此处无法放置(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Previous joint</source>
        <translation>上一个关节(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next joint</source>
        <translation>下一个关节(&amp;N)</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>上一个视图</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>下一个视图</translation>
    </message>
    <message>
        <source>Nudge left</source>
        <translation>向左微移</translation>
    </message>
    <message>
        <source>By a quarter of an image pixel</source>
        <translation>移动四分之一个图像像素</translation>
    </message>
    <message>
        <source>Nudge right</source>
        <translation>向右微移</translation>
    </message>
    <message>
        <source>Nudge up</source>
        <translation>向上微移</translation>
    </message>
    <message>
        <source>Nudge down</source>
        <translation>向下微移</translation>
    </message>
    <message>
        <source>Nudge left by a pixel</source>
        <translation>向左微移一个像素</translation>
    </message>
    <message>
        <source>Nudge right by a pixel</source>
        <translation>向右微移一个像素</translation>
    </message>
    <message>
        <source>Nudge up by a pixel</source>
        <translation>向上微移一个像素</translation>
    </message>
    <message>
        <source>Nudge down by a pixel</source>
        <translation>向下微移一个像素</translation>
    </message>
    <message>
        <source>Copy the pose of the previous annotated frame</source>
        <translation>复制上一个已标注帧的姿态</translation>
    </message>
    <message>
        <source>As marks that wait to be checked</source>
        <translation>作为待检查的标记</translation>
    </message>
    <message>
        <source>&amp;Interpolate between annotated frames</source>
        <translation>在已标注帧之间插值(&amp;I)</translation>
    </message>
    <message>
        <source>In 3D, along straight lines, over the gap around this frame</source>
        <translation>在 3D 中沿直线插值，填补本帧前后的空缺</translation>
    </message>
    <message>
        <source>Interpolate along a curve</source>
        <translation>沿曲线插值</translation>
    </message>
    <message>
        <source>In 3D, cubic, over the gap around this frame</source>
        <translation>在 3D 中进行三次插值，填补本帧前后的空缺</translation>
    </message>
    <message>
        <source>&amp;Swap left and right from here on</source>
        <translation>从此处起交换左右手(&amp;S)</translation>
    </message>
    <message>
        <source>Delete all marks of this frame</source>
        <translation>删除本帧的所有标记</translation>
    </message>
    <message>
        <source>Delete a range of frames...</source>
        <translation>删除一段帧的标记...</translation>
    </message>
    <message>
        <source>Next joint when all views are done</source>
        <translation>所有视图完成后转到下一个关节</translation>
    </message>
    <message>
        <source>14 joints per hand</source>
        <translation>每只手 14 个关节</translation>
    </message>
    <message>
        <source>21 joints per hand</source>
        <translation>每只手 21 个关节</translation>
    </message>
    <message>
        <source>With wrist and finger tips</source>
        <translation>包括手腕和指尖</translation>
    </message>
    <message>
        <source>All joints of the model</source>
        <translation>模型的所有关节</translation>
    </message>
    <message>
        <source>Joints from a &amp;file...</source>
        <translation>从文件读取关节(&amp;J)...</translation>
    </message>
    <message>
        <source>Move the joint up in the list</source>
        <translation>在列表中上移关节</translation>
    </message>
    <message>
        <source>Move the joint down in the list</source>
        <translation>在列表中下移关节</translation>
    </message>
    <message>
        <source>&amp;Start a repeat round</source>
        <translation>开始重复标注(&amp;M)</translation>
    </message>
    <message>
        <source>Next joint of the repeat round</source>
        <translation>重复标注的下一个关节</translation>
    </message>
    <message>
        <source>Compare ra&amp;ters</source>
        <translation>比较标注者(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Previous frame</source>
        <translation>上一帧(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>下一帧(&amp;N)</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>后退十帧</translation>
    </message>
    <message>
        <source>Ten frames forward</source>
        <translation>前进十帧</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>第一帧(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>最后一帧(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Go to frame...</source>
        <translation>转到帧(&amp;G)...</translation>
    </message>
    <message>
        <source>Pla&amp;y</source>
        <translation>播放(&amp;Y)</translation>
    </message>
    <message>
        <source>Next &amp;bad joint</source>
        <translation>下一个问题关节(&amp;B)</translation>
    </message>
    <message>
        <source>Error above the threshold, an outlier, or no 3D point</source>
        <translation>误差超过阈值、存在离群点或没有 3D 点</translation>
    </message>
    <message>
        <source>Previous b&amp;ad joint</source>
        <translation>上一个问题关节(&amp;A)</translation>
    </message>
    <message>
        <source>Next &amp;unlabelled frame</source>
        <translation>下一个未标注帧(&amp;U)</translation>
    </message>
    <message>
        <source>The next frame in which a joint is not done</source>
        <translation>下一个有关节尚未完成的帧</translation>
    </message>
    <message>
        <source>Previous unlab&amp;elled frame</source>
        <translation>上一个未标注帧(&amp;E)</translation>
    </message>
    <message>
        <source>Next annotated frame</source>
        <translation>下一个已标注帧</translation>
    </message>
    <message>
        <source>Previous annotated frame</source>
        <translation>上一个已标注帧</translation>
    </message>
    <message>
        <source>Next &amp;test frame</source>
        <translation>下一个测试帧(&amp;T)</translation>
    </message>
    <message>
        <source>The frames that the benchmark draws from this sequence</source>
        <translation>基准测试从此序列中抽取的帧</translation>
    </message>
    <message>
        <source>Previous test frame</source>
        <translation>上一个测试帧</translation>
    </message>
    <message>
        <source>Last e&amp;dited frame</source>
        <translation>上次编辑的帧(&amp;D)</translation>
    </message>
    <message>
        <source>Error &amp;threshold...</source>
        <translation>误差阈值(&amp;H)...</translation>
    </message>
    <message>
        <source>Joints with a larger error count as bad</source>
        <translation>误差大于此值的关节视为问题关节</translation>
    </message>
    <message>
        <source>&amp;Fit the current frame</source>
        <translation>拟合当前帧(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Show the fit &amp;panel</source>
        <translation>显示拟合面板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Previous iteration</source>
        <translation>上一次迭代(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the poses as they were before</source>
        <translation>显示此前的姿态</translation>
    </message>
    <message>
        <source>&amp;Next iteration</source>
        <translation>下一次迭代(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Result of the fit</source>
        <translation>拟合结果(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>快捷键(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Four hints</source>
        <translation>四条提示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;About Handlens</source>
        <translation>关于 Handlens(&amp;A)</translation>
    </message>
    <message>
        <source>A random tenth of your finished joints, your first marks hidden; once more to end the round</source>
        <translation>随机抽取您已完成关节的十分之一，隐藏第一次的标记；再按一次结束本轮</translation>
    </message>
    <message>
        <source>With the chosen methods, from the pose of some frames before</source>
        <translation>使用所选方法，从前若干帧的姿态开始</translation>
    </message>
    <message>
        <source>&amp;Raters</source>
        <translation>标注者(&amp;R)</translation>
    </message>
    <message>
        <source>One &amp;view</source>
        <translation>单个视图(&amp;V)</translation>
    </message>
    <message>
        <source>Mar&amp;ks</source>
        <translation>标记(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>网格(&amp;M)</translation>
    </message>
    <message>
        <source>3D s&amp;cene</source>
        <translation>三维场景(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Joint and view</source>
        <translation>关节与视图(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Nudge</source>
        <translation>微移(&amp;N)</translation>
    </message>
    <message>
        <source>Li&amp;st of joints</source>
        <translation>关节列表(&amp;S)</translation>
    </message>
    <message>
        <source>Make a &amp;new dataset...</source>
        <translation>新建数据集(&amp;N)...</translation>
    </message>
    <message>
        <source>Of a calibration and videos or folders of images</source>
        <translation>由标定文件和视频或图像文件夹生成</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>首选项(&amp;P)...</translation>
    </message>
    <message>
        <source>Language, your name, keys, colours, memory</source>
        <translation>语言、姓名、按键、颜色、内存</translation>
    </message>
    <message>
        <source>Change the &amp;shortcuts...</source>
        <translation>更改快捷键(&amp;S)...</translation>
    </message>
    <message>
        <source>Fra&amp;me the hands</source>
        <translation>对准双手(&amp;M)</translation>
    </message>
    <message>
        <source>Zooms every view to the hands, where they are known</source>
        <translation>在已知双手位置时，将每个视图缩放到双手</translation>
    </message>
    <message>
        <source>Other people&apos;s marks</source>
        <translation>其他人的标记</translation>
    </message>
    <message>
        <source>What others have marked in this sequence, muted; it cannot be changed here</source>
        <translation>其他人在此序列中的标记，淡色显示，此处不可修改</translation>
    </message>
    <message>
        <source>Which hand is &amp;left and which right</source>
        <translation>显示左右手(&amp;L)</translation>
    </message>
    <message>
        <source>L and R beside the hands, where they are known</source>
        <translation>在已知位置时，于手旁显示 L 和 R</translation>
    </message>
    <message>
        <source>L&amp;eft hand</source>
        <translation>左手(&amp;E)</translation>
    </message>
    <message>
        <source>Marks and mesh of the left hand</source>
        <translation>左手的标记和网格</translation>
    </message>
    <message>
        <source>Ri&amp;ght hand</source>
        <translation>右手(&amp;G)</translation>
    </message>
    <message>
        <source>Marks and mesh of the right hand</source>
        <translation>右手的标记和网格</translation>
    </message>
    <message>
        <source>&amp;Toolbar</source>
        <translation>工具栏(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Attach masks...</source>
        <translation>附加掩膜(&amp;A)...</translation>
    </message>
    <message>
        <source>Gives this sequence the silhouettes of a folder</source>
        <translation>将文件夹中的轮廓掩膜用于此序列</translation>
    </message>
    <message>
        <source>Next &amp;method in the 3D scene</source>
        <translation>三维场景中的下一方法(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Save the benchmark&apos;s results...</source>
        <translation>保存基准测试结果(&amp;S)...</translation>
    </message>
    <message>
        <source>Tables, pairs and a report, in a folder</source>
        <translation>表格、配对和报告，存入一个文件夹</translation>
    </message>
    <message>
        <source>&amp;Open a benchmark&apos;s results...</source>
        <translation>打开基准测试结果(&amp;O)...</translation>
    </message>
    <message>
        <source>A folder that was saved here or written by handlens-batch benchmark</source>
        <translation>此处保存的或由 handlens-batch benchmark 写出的文件夹</translation>
    </message>
    <message>
        <source>&amp;Layers of the methods</source>
        <translation>各方法的图层(&amp;L)</translation>
    </message>
    <message>
        <source>Writes the annotations of this sequence: of all raters where the format names them, else yours</source>
        <translation>写出此序列的标注：格式能记录标注者时写出所有标注者的标注，否则写出您的标注</translation>
    </message>
    <message>
        <source>Residual a&amp;rrows</source>
        <translation>残差箭头(&amp;A)</translation>
    </message>
    <message>
        <source>How far all clicks of each camera are off, place by place, ten times as long; green: refined</source>
        <translation>每台相机所有点击在各位置的偏离，放大十倍；绿色：优化后</translation>
    </message>
    <message>
        <source>How the &amp;cameras fit the clicks</source>
        <translation>相机与点击的吻合程度(&amp;C)</translation>
    </message>
    <message>
        <source>What all clicks of the dataset say of its calibration</source>
        <translation>数据集的所有点击所反映的标定质量</translation>
    </message>
    <message>
        <source>Re&amp;fine the calibration...</source>
        <translation>优化标定(&amp;T)...</translation>
    </message>
    <message>
        <source>Adjusts the cameras to all clicks and shows what changes; also to return to an earlier calibration</source>
        <translation>按所有点击调整相机并显示变化；也可恢复先前的标定</translation>
    </message>
    <message>
        <source>&amp;Use the refined calibration</source>
        <translation>使用优化后的标定(&amp;U)</translation>
    </message>
    <message>
        <source>As a new calibration file; the old one is kept</source>
        <translation>存为新的标定文件；旧文件保留</translation>
    </message>
    <message>
        <source>Measure this person&apos;s &amp;hands...</source>
        <translation>测量此人的双手(&amp;H)...</translation>
    </message>
    <message>
        <source>Bone lengths, scale and girth from annotated frames and masks, as a new dataset</source>
        <translation>由已标注帧和掩膜得出骨骼长度、比例和粗细，存为新数据集</translation>
    </message>
    <message>
        <source>Measure the hands now</source>
        <translation>立即测量双手</translation>
    </message>
    <message>
        <source>With what is chosen in the window for measuring hands</source>
        <translation>使用双手测量窗口中的选择</translation>
    </message>
    <message>
        <source>&amp;Contour</source>
        <translation>轮廓线(&amp;C)</translation>
    </message>
    <message>
        <source>The observed outline over the inspected views; its colour is its direction</source>
        <translation>检视视图上观测到的轮廓线；颜色表示其方向</translation>
    </message>
    <message>
        <source>&amp;Rim</source>
        <translation>边缘(&amp;R)</translation>
    </message>
    <message>
        <source>Rim points of the posed hands with their normals</source>
        <translation>手部姿态的边缘点及其法线</translation>
    </message>
    <message>
        <source>&amp;Matches</source>
        <translation>匹配(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Field</source>
        <translation>场(&amp;F)</translation>
    </message>
    <message>
        <source>What a rim point of one direction costs at every pixel</source>
        <translation>某一方向的边缘点在每个像素处的代价</translation>
    </message>
    <message>
        <source>&amp;Error</source>
        <translation>误差(&amp;E)</translation>
    </message>
    <message>
        <source>The mesh by its distance to the recorded pose</source>
        <translation>网格，按与记录姿态的距离着色</translation>
    </message>
    <message>
        <source>Save this &amp;comparison...</source>
        <translation>保存此比较(&amp;V)...</translation>
    </message>
    <message>
        <source>Pair, methods, cameras, layers and iteration, as a small file that opens again</source>
        <translation>配对、方法、相机、图层和迭代，存为可再次打开的小文件</translation>
    </message>
    <message>
        <source>Open a com&amp;parison...</source>
        <translation>打开比较(&amp;D)...</translation>
    </message>
    <message>
        <source>R&amp;eview of proposals</source>
        <translation>审核建议(&amp;E)</translation>
    </message>
    <message>
        <source>First &amp;pass...</source>
        <translation>自动初标(&amp;P)...</translation>
    </message>
    <message>
        <source>Finds the joints of both hands in many frames without a click, as proposals to be checked</source>
        <translation>无需点击即可在许多帧中找出双手关节，作为待检查的建议</translation>
    </message>
    <message>
        <source>Start the first pass now</source>
        <translation>立即开始自动初标</translation>
    </message>
    <message>
        <source>With what is chosen for the first pass</source>
        <translation>使用为自动初标所选的内容</translation>
    </message>
    <message>
        <source>&amp;Accept the frame, go on to the next</source>
        <translation>接受本帧，转到下一帧(&amp;A)</translation>
    </message>
    <message>
        <source>Accepts all proposed joints of the frame as they stand</source>
        <translation>按现状接受本帧所有建议的关节</translation>
    </message>
    <message>
        <source>&amp;Correct the most doubtful joint</source>
        <translation>修正最存疑的关节(&amp;C)</translation>
    </message>
    <message>
        <source>Selects it: click it in two views, then accept the frame</source>
        <translation>选中该关节：请在两个视图中点击它，然后接受本帧</translation>
    </message>
    <message>
        <source>&amp;Next frame to review</source>
        <translation>下一个待审核帧(&amp;N)</translation>
    </message>
    <message>
        <source>Frames whose look teaches most come first</source>
        <translation>最值得查看的帧排在前面</translation>
    </message>
    <message>
        <source>&amp;Show the review queue</source>
        <translation>显示审核队列(&amp;S)</translation>
    </message>
    <message>
        <source>Silhouettes...</source>
        <translation>轮廓...</translation>
    </message>
    <message>
        <source>Finds the hands&apos; silhouettes in the pictures, to be looked at, touched up and kept</source>
        <translation>在图像中找出手的轮廓，供查看、修整和保存</translation>
    </message>
    <message>
        <source>Make the silhouettes now</source>
        <translation>立即生成轮廓</translation>
    </message>
    <message>
        <source>Of the frames that are chosen in the window for silhouettes</source>
        <translation>针对轮廓窗口中所选的帧</translation>
    </message>
    <message>
        <source>Brush for silhouettes</source>
        <translation>轮廓画笔</translation>
    </message>
    <message>
        <source>Left button adds, right button takes away, Ctrl and the wheel change its size</source>
        <translation>左键添加，右键去除，Ctrl 加滚轮更改大小</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>增大画笔</translation>
    </message>
    <message>
        <source>Of the brush for silhouettes</source>
        <translation>轮廓画笔的大小</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>减小画笔</translation>
    </message>
    <message>
        <source>C&amp;omparison</source>
        <translation>比较(&amp;O)</translation>
    </message>
    <message>
        <source>Col&amp;umns of the comparison</source>
        <translation>比较的列(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>差异(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>不确定度(&amp;U)</translation>
    </message>
    <message>
        <source>Where the joints of a result lie with 95 % probability, as the fit judged it</source>
        <translation>拟合所估计的结果关节 95 % 概率所在范围</translation>
    </message>
    <message>
        <source>Add the &amp;start</source>
        <translation>添加起始姿态(&amp;S)</translation>
    </message>
    <message>
        <source>The pose that every method began with, as a column</source>
        <translation>所有方法的起始姿态，作为一列</translation>
    </message>
    <message>
        <source>Add the &amp;truth</source>
        <translation>添加真值(&amp;T)</translation>
    </message>
    <message>
        <source>The recorded pose, as a column</source>
        <translation>记录的姿态，作为一列</translation>
    </message>
    <message>
        <source>Add a tracker&apos;s &amp;estimates...</source>
        <translation>添加跟踪器的估计(&amp;E)...</translation>
    </message>
    <message>
        <source>A file of joints per frame pair, as handlens-batch benchmark takes it</source>
        <translation>每个帧对的关节文件，与 handlens-batch benchmark 所用的相同</translation>
    </message>
    <message>
        <source>&amp;Remove the column</source>
        <translation>移除此列(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Previous column</source>
        <translation>上一列(&amp;P)</translation>
    </message>
    <message>
        <source>What the settings and the wipe are about</source>
        <translation>设置和滑动对比所针对的列</translation>
    </message>
    <message>
        <source>&amp;Next column</source>
        <translation>下一列(&amp;N)</translation>
    </message>
    <message>
        <source>Move the column to the &amp;left</source>
        <translation>将列左移(&amp;L)</translation>
    </message>
    <message>
        <source>Move the column to the ri&amp;ght</source>
        <translation>将列右移(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Hide or show the hands in this view</source>
        <translation>在此视图中隐藏或显示手(&amp;H)</translation>
    </message>
    <message>
        <source>The column in the current view</source>
        <translation>当前视图中的列</translation>
    </message>
    <message>
        <source>&amp;Wipe to the next column</source>
        <translation>与下一列滑动对比(&amp;W)</translation>
    </message>
    <message>
        <source>The next column lies over this one, behind a line that can be dragged</source>
        <translation>下一列叠在此列之上，以一条可拖动的线分界</translation>
    </message>
    <message>
        <source>Line of the wipe to the left</source>
        <translation>滑动对比线左移</translation>
    </message>
    <message>
        <source>Line of the wipe to the right</source>
        <translation>滑动对比线右移</translation>
    </message>
    <message>
        <source>&amp;Blink with the next column</source>
        <translation>与下一列闪烁对比(&amp;B)</translation>
    </message>
    <message>
        <source>Shows this column and the next one by turns</source>
        <translation>交替显示此列和下一列</translation>
    </message>
    <message>
        <source>What &amp;if...</source>
        <translation>假设分析(&amp;I)...</translation>
    </message>
    <message>
        <source>Settings of the column&apos;s method, cameras and noise: drag one, and the methods run again</source>
        <translation>此列方法的设置、相机和噪声：拖动其中一项，各方法即重新运行</translation>
    </message>
    <message>
        <source>&amp;Use these settings</source>
        <translation>使用这些设置(&amp;U)</translation>
    </message>
    <message>
        <source>Gives the column what was tried under What if</source>
        <translation>将“假设分析”中试用的设置用于此列</translation>
    </message>
    <message>
        <source>&amp;Add these settings as a column</source>
        <translation>将这些设置添加为一列(&amp;A)</translation>
    </message>
    <message>
        <source>What was tried under What if, beside the column</source>
        <translation>“假设分析”中试用的设置，显示在此列旁边</translation>
    </message>
    <message>
        <source>Bac&amp;k to what was fitted</source>
        <translation>恢复为已拟合的结果(&amp;K)</translation>
    </message>
    <message>
        <source>Ends what was tried under What if</source>
        <translation>结束“假设分析”中的试用</translation>
    </message>
    <message>
        <source>What does each &amp;camera add?</source>
        <translation>每台相机有何贡献？(&amp;C)</translation>
    </message>
    <message>
        <source>Fits without each camera in turn</source>
        <translation>依次去掉每台相机进行拟合</translation>
    </message>
    <message>
        <source>Save as a &amp;picture...</source>
        <translation>另存为图片(&amp;P)...</translation>
    </message>
    <message>
        <source>Views, titles and curves on white paper: PNG, or SVG or PDF with lines and marks as vectors</source>
        <translation>白底的视图、标题和曲线：PNG，或线条和标记为矢量的 SVG 或 PDF</translation>
    </message>
    <message>
        <source>Save the iterations as a &amp;film...</source>
        <translation>将迭代过程存为影片(&amp;F)...</translation>
    </message>
    <message>
        <source>The comparison from the start pose to the last iteration</source>
        <translation>从起始姿态到最后一次迭代的比较</translation>
    </message>
    <message>
        <source>&amp;Report of this comparison...</source>
        <translation>此比较的报告(&amp;R)...</translation>
    </message>
    <message>
        <source>One page with pictures, tables, settings and the command that makes it again</source>
        <translation>一个页面，含图片、表格、设置及重新生成该页面的命令</translation>
    </message>
    <message>
        <source>&amp;Run or stop the benchmark</source>
        <translation>运行或停止基准测试(&amp;R)</translation>
    </message>
    <message>
        <source>Fil&amp;ter the benchmark&apos;s pairs</source>
        <translation>筛选基准测试的配对(&amp;T)</translation>
    </message>
    <message>
        <source>By errors, differences of methods, sequences and frames, such as A-B&gt;1</source>
        <translation>按误差、方法间差异、序列和帧筛选，例如 A-B&gt;1</translation>
    </message>
    <message>
        <source>Run the selected &amp;pairs</source>
        <translation>运行所选配对(&amp;P)</translation>
    </message>
    <message>
        <source>Adds what the ticked methods make of them to the results that are shown</source>
        <translation>将已勾选方法对这些配对的结果添加到所显示的结果中</translation>
    </message>
    <message>
        <source>From rim points to their contour points, by distance or finger; a dash pattern for every reason to refuse one</source>
        <translation>从边缘点到其轮廓点，按距离或手指着色；每种拒绝原因有各自的虚线样式</translation>
    </message>
    <message>
        <source>Silhouettes: red is seen but not covered, blue is covered but not seen, a hatched forearm does not count</source>
        <translation>轮廓：红色为可见但未覆盖，蓝色为覆盖但不可见，画斜线的前臂不计入</translation>
    </message>
    <message>
        <source>Matches of the next finger</source>
        <translation>下一根手指的匹配</translation>
    </message>
    <message>
        <source>All matches by distance, all by finger, then those of one finger or the palm after the other</source>
        <translation>先按距离显示全部匹配，再按手指显示全部，然后依次显示单根手指或手掌的匹配</translation>
    </message>
    <message>
        <source>Sweep the setting</source>
        <translation>扫描该设置</translation>
    </message>
    <message>
        <source>Fits at a row of values of the setting that was changed last, and draws the error over it; once more stops</source>
        <translation>用最后更改的设置的一系列取值进行拟合并绘制误差；再按一次停止</translation>
    </message>
</context>
<context>
    <name>app::CalibrationPage</name>
    <message>
        <source>as usual for its kind</source>
        <translation>该类文件的惯用单位</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>The calibration</source>
        <translation>标定文件</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>长度单位</translation>
    </message>
    <message>
        <source>Anipose, OpenCV, EasyMocap, JARVIS, MATLAB and others: the kind is recognised.</source>
        <translation>Anipose、OpenCV、EasyMocap、JARVIS、MATLAB 等：自动识别类型。</translation>
    </message>
    <message>
        <source>Sizes, rotations and lenses make sense, and every camera sees where the others look.</source>
        <translation>尺寸、旋转和镜头均合理，且每台相机都能看到其他相机所对准之处。</translation>
    </message>
    <message numerus="yes">
        <source>Recognised as %1: %n camera(s).</source>
        <translation>
            <numerusform>识别为 %1：%n 台相机。</numerusform>
        </translation>
    </message>
    <message>
        <source>They stand about %1 mm from where they look.</source>
        <translation>相机距其所对准之处约 %1 mm。</translation>
    </message>
    <message>
        <source>Choose the calibration of the cameras.</source>
        <translation>请选择相机的标定文件。</translation>
    </message>
    <message>
        <source>There is no such calibration file.</source>
        <translation>没有此标定文件。</translation>
    </message>
    <message>
        <source>The calibration cannot be read.</source>
        <translation>无法读取标定文件。</translation>
    </message>
    <message>
        <source>The calibration is being read...</source>
        <translation>正在读取标定文件...</translation>
    </message>
</context>
<context>
    <name>app::ComparisonReport</name>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Start, mm</source>
        <translation>起始，mm</translation>
    </message>
    <message>
        <source>Shown, mm</source>
        <translation>所示，mm</translation>
    </message>
    <message>
        <source>Result, mm</source>
        <translation>结果，mm</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代次数</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Error by iteration</source>
        <translation>各次迭代的误差</translation>
    </message>
    <message>
        <source>Cost by iteration</source>
        <translation>各次迭代的代价</translation>
    </message>
    <message>
        <source>Joint, error in mm</source>
        <translation>关节，误差 (mm)</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>To make this page again</source>
        <translation>重新生成此页面</translation>
    </message>
    <message>
        <source>The file %1 holds:</source>
        <translation>文件 %1 的内容：</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Error joint by joint</source>
        <translation>各关节的误差</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
</context>
<context>
    <name>app::ExportWindow</name>
    <message>
        <source>Export annotations</source>
        <translation>导出标注</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds&lt;/b&gt;</source>
        <translation>&lt;b&gt;内容&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Read by&lt;/b&gt;</source>
        <translation>&lt;b&gt;可读取的软件&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not in it&lt;/b&gt;</source>
        <translation>&lt;b&gt;不包含&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Written are&lt;/b&gt;</source>
        <translation>&lt;b&gt;写出的是&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Choose where...</source>
        <translation>选择位置...</translation>
    </message>
    <message>
        <source>Your own annotations of this sequence</source>
        <translation>您自己在此序列中的标注</translation>
    </message>
    <message>
        <source>The annotations of all raters of this sequence, with their names</source>
        <translation>此序列中所有标注者的标注，附姓名</translation>
    </message>
</context>
<context>
    <name>app::FileActions</name>
    <message>
        <source>Handlens ground truth</source>
        <translation>Handlens 真值</translation>
    </message>
    <message>
        <source>Files of the method&apos;s authors</source>
        <translation>方法原作者的文件</translation>
    </message>
    <message>
        <source>COCO keypoints</source>
        <translation>COCO 关键点</translation>
    </message>
    <message>
        <source>Anipose, 2D</source>
        <translation>Anipose 2D</translation>
    </message>
    <message>
        <source>Anipose, 3D</source>
        <translation>Anipose 3D</translation>
    </message>
    <message>
        <source>DeepLabCut, Lightning Pose</source>
        <translation>DeepLabCut、Lightning Pose</translation>
    </message>
    <message>
        <source>TRC, marker motion</source>
        <translation>TRC 标记点运动</translation>
    </message>
    <message>
        <source>InterHand2.6M</source>
        <translation>InterHand2.6M</translation>
    </message>
    <message>
        <source>FreiHAND, HanCo</source>
        <translation>FreiHAND、HanCo</translation>
    </message>
    <message>
        <source>Table of 3D joints</source>
        <translation>3D 关节表</translation>
    </message>
    <message>
        <source>Table of marks</source>
        <translation>标记表</translation>
    </message>
    <message>
        <source>%1 – a new folder (*)</source>
        <translation>%1 – 新文件夹 (*)</translation>
    </message>
    <message>
        <source>Handlens and scripts of your own (JSON)</source>
        <translation>Handlens 和您自己的脚本 (JSON)</translation>
    </message>
    <message>
        <source>Marks in whole pixels, a folder per camera and a text file per frame.</source>
        <translation>整像素标记，每台相机一个文件夹，每帧一个文本文件。</translation>
    </message>
    <message>
        <source>The programs of the method&apos;s authors</source>
        <translation>方法作者的程序</translation>
    </message>
    <message>
        <source>Fractions of pixels, 3D joints, joints beyond the 14 of a hand; occluded and missing are both 0 0</source>
        <translation>亚像素、三维关节、每只手 14 个以外的关节；遮挡与缺失均为 0 0</translation>
    </message>
    <message>
        <source>Marks per picture and hand, each visible, occluded or missing.</source>
        <translation>每幅图像、每只手的标记，分为可见、遮挡或缺失。</translation>
    </message>
    <message>
        <source>MMPose, Detectron2, CVAT, FiftyOne and most trainers of networks (JSON)</source>
        <translation>MMPose、Detectron2、CVAT、FiftyOne 及大多数网络训练工具 (JSON)</translation>
    </message>
    <message>
        <source>3D joints, cameras, who clicked and who accepted</source>
        <translation>三维关节、相机、谁点击和谁接受</translation>
    </message>
    <message>
        <source>Marks as a table per camera with a row per frame.</source>
        <translation>标记表格，每台相机一个，每帧一行。</translation>
    </message>
    <message>
        <source>Anipose and aniposelib (CSV)</source>
        <translation>Anipose 和 aniposelib (CSV)</translation>
    </message>
    <message>
        <source>3D joints and states: occluded marks look like visible ones</source>
        <translation>三维关节和状态：遮挡的标记与可见的相同</translation>
    </message>
    <message>
        <source>3D joints with error and number of cameras, a row per frame.</source>
        <translation>三维关节及误差和相机数量，每帧一行。</translation>
    </message>
    <message>
        <source>Anipose and what reads its results (CSV)</source>
        <translation>Anipose 及读取其结果的软件 (CSV)</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and cameras</source>
        <translation>标记本身、不确定度和相机</translation>
    </message>
    <message>
        <source>Marks as one CollectedData table per camera, a row per annotated frame.</source>
        <translation>每台相机一个 CollectedData 表，每个已标注帧一行。</translation>
    </message>
    <message>
        <source>DeepLabCut, Lightning Pose, napari-deeplabcut (CSV)</source>
        <translation>DeepLabCut、Lightning Pose、napari-deeplabcut (CSV)</translation>
    </message>
    <message>
        <source>3D joints as moving markers, a row per frame of the sequence.</source>
        <translation>作为运动标记点的三维关节，序列每帧一行。</translation>
    </message>
    <message>
        <source>OpenSim, Mokka, Visual3D and other programs for motion</source>
        <translation>OpenSim、Mokka、Visual3D 及其他运动分析软件</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and cameras; it cannot be imported again</source>
        <translation>标记本身、不确定度和相机；无法再导入</translation>
    </message>
    <message>
        <source>3D joints of both hands in that dataset&apos;s order, and the cameras.</source>
        <translation>按该数据集顺序的双手三维关节，以及相机。</translation>
    </message>
    <message>
        <source>Loaders written for InterHand2.6M (JSON)</source>
        <translation>为 InterHand2.6M 编写的加载程序 (JSON)</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and lens distortion; it cannot be imported again</source>
        <translation>标记本身、不确定度和镜头畸变；无法再导入</translation>
    </message>
    <message>
        <source>21 joints of a hand in metres and the cameras, a file per frame and hand.</source>
        <translation>每只手 21 个关节（米）及相机，每帧每只手一个文件。</translation>
    </message>
    <message>
        <source>Loaders written for FreiHAND or HanCo (JSON)</source>
        <translation>为 FreiHAND 或 HanCo 编写的加载程序 (JSON)</translation>
    </message>
    <message>
        <source>Spreadsheets, R, pandas (CSV)</source>
        <translation>电子表格、R、pandas (CSV)</translation>
    </message>
    <message>
        <source>The marks themselves and the cameras; it cannot be imported again</source>
        <translation>标记本身和相机；无法再导入</translation>
    </message>
    <message>
        <source>Spreadsheets, R, pandas, and Handlens (CSV)</source>
        <translation>电子表格、R、pandas 和 Handlens (CSV)</translation>
    </message>
    <message>
        <source>3D joints and the cameras</source>
        <translation>三维关节和相机</translation>
    </message>
    <message>
        <source>Only proposals and the list of undo steps</source>
        <translation>只有建议和撤销步骤列表</translation>
    </message>
    <message>
        <source>SLEAP</source>
        <translation>SLEAP</translation>
    </message>
    <message>
        <source>Labels and guesses of a project (.slp) or of an analysis export (.h5).</source>
        <translation>项目 (.slp) 或分析导出 (.h5) 中的标注和预测。</translation>
    </message>
    <message>
        <source>SLEAP and sleap-io (HDF5)</source>
        <translation>SLEAP 和 sleap-io (HDF5)</translation>
    </message>
    <message>
        <source>Everything: it can be imported, not exported</source>
        <translation>全部：只能导入，不能导出</translation>
    </message>
    <message>
        <source>Label3D, DANNCE</source>
        <translation>Label3D、DANNCE</translation>
    </message>
    <message>
        <source>Clicks and 3D points of a session, or the labels exported for DANNCE.</source>
        <translation>一次会话的点击和三维点，或为 DANNCE 导出的标注。</translation>
    </message>
    <message>
        <source>Label3D and DANNCE (MATLAB)</source>
        <translation>Label3D 和 DANNCE (MATLAB)</translation>
    </message>
    <message>
        <source>3D joints with their uncertainty, every mark of every rater with its state and error, and the cameras.</source>
        <translation>三维关节及其不确定度，每位标注者的每个标记及其状态和误差，以及相机。</translation>
    </message>
    <message>
        <source>A row per 3D joint of every rater: millimetres, uncertainty, error, state.</source>
        <translation>每位标注者的每个三维关节一行：毫米、不确定度、误差、状态。</translation>
    </message>
    <message>
        <source>A row per mark of every rater: pixel, state, how it was placed; proposals, too.</source>
        <translation>每位标注者的每个标记一行：像素、状态、放置方式；也含建议。</translation>
    </message>
</context>
<context>
    <name>app::FootagePage</name>
    <message>
        <source>The videos of the cameras, or folders of numbered images. Drop them here, or a folder with all of them. Nothing is copied: the footage stays where it is.</source>
        <translation>各相机的视频，或带编号图像的文件夹。将其或包含全部素材的文件夹拖放到此处。不会复制任何内容：素材留在原处。</translation>
    </message>
    <message>
        <source>Video or image folder</source>
        <translation>视频或图像文件夹</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Starts at frame</source>
        <translation>起始帧</translation>
    </message>
    <message>
        <source>The frame of this footage that was recorded when the sequence begins.</source>
        <translation>序列开始时此素材所录制的帧。</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>序列名称</translation>
    </message>
    <message>
        <source>Add videos...</source>
        <translation>添加视频...</translation>
    </message>
    <message>
        <source>Add a folder...</source>
        <translation>添加文件夹...</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>A folder of numbered images, or of videos</source>
        <translation>带编号图像或视频的文件夹</translation>
    </message>
    <message>
        <source>Videos of the cameras</source>
        <translation>各相机的视频</translation>
    </message>
    <message>
        <source>its first</source>
        <translation>第一帧</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>Add the videos or image folders of the cameras.</source>
        <translation>请添加各相机的视频或图像文件夹。</translation>
    </message>
    <message>
        <source>Two pieces of footage are given to %1.</source>
        <translation>%1 被分配了两份素材。</translation>
    </message>
    <message>
        <source>Choose the camera of each piece of footage.</source>
        <translation>请为每份素材选择相机。</translation>
    </message>
    <message>
        <source>Give the sequence a name.</source>
        <translation>请为序列命名。</translation>
    </message>
</context>
<context>
    <name>app::HandsPage</name>
    <message>
        <source>The demo&apos;s hands</source>
        <translation>演示中的手</translation>
    </message>
    <message>
        <source>A left and a right hand of usual size. They can be measured to a person&apos;s own later, from clicked joints.</source>
        <translation>普通大小的左手和右手。之后可由点击的关节测量出此人自己的双手。</translation>
    </message>
    <message>
        <source>The hands of another dataset</source>
        <translation>另一数据集的手</translation>
    </message>
    <message>
        <source>Such as this person&apos;s, measured before, or imported ones.</source>
        <translation>例如先前测量的此人双手，或导入的手。</translation>
    </message>
    <message>
        <source>The folder of a dataset</source>
        <translation>数据集的文件夹</translation>
    </message>
    <message>
        <source>No hand model</source>
        <translation>无手部模型</translation>
    </message>
    <message>
        <source>Joints can be clicked, of hands or of anything else. Nothing is fitted to silhouettes.</source>
        <translation>可点击手或任何其他对象的关节。不会拟合到轮廓。</translation>
    </message>
    <message>
        <source>Choose the dataset whose hands are taken.</source>
        <translation>请选择要采用其双手的数据集。</translation>
    </message>
    <message>
        <source>That folder is not a dataset: it has no dataset.json.</source>
        <translation>该文件夹不是数据集：其中没有 dataset.json。</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>No annotated frame before this one.</source>
        <translation>此帧之前没有已标注的帧。</translation>
    </message>
    <message>
        <source>Frame %1 has no 3D joint that is missing here.</source>
        <translation>第 %1 帧中没有本帧所缺的 3D 关节。</translation>
    </message>
    <message>
        <source>Annotate a frame before and a frame after this one first.</source>
        <translation>请先在此帧之前和之后各标注一帧。</translation>
    </message>
    <message>
        <source>No joint has a 3D point in both frame %1 and frame %2.</source>
        <translation>没有任何关节在第 %1 帧和第 %2 帧中都有 3D 点。</translation>
    </message>
    <message>
        <source>There are no marks of yours there.</source>
        <translation>那里没有您的标记。</translation>
    </message>
    <message>
        <source>Delete a range of frames</source>
        <translation>删除一段帧的标记</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>The hand model has nothing to add: every joint of the list that it knows has a mark.</source>
        <translation>手部模型没有可补充的内容：列表中模型包含的每个关节都已有标记。</translation>
    </message>
    <message>
        <source>Finish some joints first: there is nothing to mark again.</source>
        <translation>请先完成一些关节：目前没有可重新标记的内容。</translation>
    </message>
    <message>
        <source>Every joint of the round is marked: end it to see how you did.</source>
        <translation>本轮的每个关节都已标记：结束本轮即可查看结果。</translation>
    </message>
    <message>
        <source>No repeat round is under way.</source>
        <translation>当前没有进行中的重复标注。</translation>
    </message>
    <message>
        <source>Export annotations</source>
        <translation>导出标注</translation>
    </message>
    <message>
        <source>Import annotations</source>
        <translation>导入标注</translation>
    </message>
    <message>
        <source>Report on the annotations</source>
        <translation>标注报告</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Save the views as a picture</source>
        <translation>将视图另存为图片</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>无法写入 %1。</translation>
    </message>
    <message>
        <source>Joints from a file</source>
        <translation>从文件读取关节</translation>
    </message>
    <message>
        <source>Lists of joints (*.json)</source>
        <translation>关节列表 (*.json)</translation>
    </message>
    <message>
        <source>Open a dataset to begin.</source>
        <translation>打开一个数据集以开始。</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>This could not be opened. %1</source>
        <translation>无法打开。%1</translation>
    </message>
    <message>
        <source>Not saved yet, but nothing is lost: it is tried again every few seconds. %1</source>
        <translation>尚未保存，但数据不会丢失：每隔几秒会自动重试。%1</translation>
    </message>
    <message>
        <source>Read-only: %1. You can look and export; edits are not possible.</source>
        <translation>只读：%1。可以查看和导出，但无法编辑。</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>已导出到 %1</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>报告已写入 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) imported from %1</source>
        <translation>
            <numerusform>已从 %1 导入 %n 个标记</numerusform>
        </translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>正在拟合</translation>
    </message>
    <message>
        <source>Fitting: %1</source>
        <translation>正在拟合：%1</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>基准测试</translation>
    </message>
    <message>
        <source>Benchmark: %1</source>
        <translation>基准测试：%1</translation>
    </message>
    <message>
        <source>Open a dataset</source>
        <translation>打开数据集</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的数据集(&amp;T)</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>您的名字</translation>
    </message>
    <message>
        <source>Your marks are kept under this name:</source>
        <translation>您的标记以此名字保存：</translation>
    </message>
    <message>
        <source>About Handlens</source>
        <translation>关于 Handlens</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Handlens %1&lt;/h3&gt;&lt;p&gt;3D hand ground truth in calibrated multi-camera footage.&lt;/p&gt;&lt;p&gt;MIT licence. Built with Qt, VTK, Eigen, OpenCV, SQLite and others.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Handlens %1&lt;/h3&gt;&lt;p&gt;在经过标定的多相机影像中获取手部 3D 真值。&lt;/p&gt;&lt;p&gt;MIT 许可证。基于 Qt、VTK、Eigen、OpenCV、SQLite 等构建。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销：%1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做：%1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>No bad joint in that direction.</source>
        <translation>该方向上没有问题关节。</translation>
    </message>
    <message>
        <source>Every frame in that direction is done.</source>
        <translation>该方向上的每一帧都已完成。</translation>
    </message>
    <message>
        <source>No frame with marks in that direction.</source>
        <translation>该方向上没有带标记的帧。</translation>
    </message>
    <message>
        <source>No test frame in that direction, as the benchmark is set.</source>
        <translation>按当前基准测试设置，该方向上没有测试帧。</translation>
    </message>
    <message>
        <source>Nothing was edited yet.</source>
        <translation>尚未编辑任何内容。</translation>
    </message>
    <message>
        <source>Your last edits are not saved yet. Make room or give permission where they are kept, or export them elsewhere; closing once more gives them up.</source>
        <translation>您最近的编辑尚未保存。请在其存储位置腾出空间或授予权限，或将其导出到别处；再次关闭将放弃这些编辑。</translation>
    </message>
    <message>
        <source>The hand model misses the marked joints by %1 mm: are units, joints and hands right? Nothing is proposed.</source>
        <translation>手部模型与已标记关节相差 %1 毫米：单位、关节和左右手是否正确？未提出任何建议。</translation>
    </message>
    <message numerus="yes">
        <source>The hand model meets %n marked joint(s) within %1 mm.</source>
        <translation>
            <numerusform>手部模型与 %n 个已标记关节的偏差在 %1 毫米以内。</numerusform>
        </translation>
    </message>
    <message>
        <source>report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Where are the videos and images now? Folders below are looked through, too.</source>
        <translation>视频和图像现在在哪里？也会查找子文件夹。</translation>
    </message>
    <message>
        <source>Nothing of the missing footage lies in that folder.</source>
        <translation>该文件夹中没有缺失的素材。</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage found; the dataset keeps the new places.</source>
        <translation>
            <numerusform>找到 %n 份素材；数据集已记住新位置。</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for footage</source>
        <translation>正在查找素材</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more: see handlens-batch check</source>
        <translation>
            <numerusform>另有 %n 条：参见 handlens-batch check</numerusform>
        </translation>
    </message>
    <message>
        <source>About the footage: %1</source>
        <translation>关于素材：%1</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>Attach a folder of masks</source>
        <translation>附加掩膜文件夹</translation>
    </message>
    <message>
        <source>The name that your marks are kept under (%1)</source>
        <translation>保存您的标记所用的姓名 (%1)</translation>
    </message>
    <message>
        <source>Your name: %1</source>
        <translation>您的姓名：%1</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of %1</source>
        <translation>
            <numerusform>%1 的 %n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n 条备注</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1，位于 %2</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 和 </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 would replace %2.</source>
        <translation>%1 将替换 %2。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Keep what is there</source>
        <translation>保留已有的</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>%1 has labels of %2, but none of this sequence. Import them all the same?</source>
        <translation>%1 中有 %2 的标记，但没有此序列的。仍要导入吗？</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>未导入任何内容。</translation>
    </message>
    <message>
        <source>Continue the repeat round? Your first marks are hidden until you end it.</source>
        <translation>继续重复标注吗？在结束之前，您最初的标记将隐藏。</translation>
    </message>
    <message>
        <source>Start a repeat round? A random tenth of your finished joints is asked for once more, to see how well you repeat yourself. Your first marks are kept, and hidden until you end the round.</source>
        <translation>开始重复标注吗？将随机再次询问您已完成关节的十分之一，以衡量您的重复精度。您最初的标记会保留，并在结束之前隐藏。</translation>
    </message>
    <message>
        <source>Start the repeat round</source>
        <translation>开始重复标注</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>以后再说</translation>
    </message>
    <message>
        <source>Repeat round: your first marks are hidden. %1 of %2 joints.</source>
        <translation>重复标注：您最初的标记已隐藏。已完成 %1 / %2 个关节。</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>There is no frame %1: sequence &quot;%2&quot; has frames 0-%3. The last one is shown.</source>
        <translation>没有第 %1 帧：序列“%2”的帧为 0-%3。显示最后一帧。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>No program opened %1.</source>
        <translation>没有程序能打开 %1。</translation>
    </message>
    <message>
        <source>Nothing was changed: %1 holds nothing that is not there already.</source>
        <translation>没有更改：%1 中没有新的内容。</translation>
    </message>
    <message>
        <source>Results saved in %1</source>
        <translation>结果已保存到 %1</translation>
    </message>
    <message>
        <source>Comparisons (*.json)</source>
        <translation>比较 (*.json)</translation>
    </message>
    <message>
        <source>Fit a pair first.</source>
        <translation>请先拟合一个配对。</translation>
    </message>
    <message>
        <source>Save this comparison</source>
        <translation>保存此比较</translation>
    </message>
    <message>
        <source>Open a comparison</source>
        <translation>打开比较</translation>
    </message>
    <message>
        <source>No other person has marks in this sequence.</source>
        <translation>此序列中没有其他人的标记。</translation>
    </message>
    <message>
        <source>Refine the calibration</source>
        <translation>优化标定</translation>
    </message>
    <message>
        <source>Measure this person&apos;s hands</source>
        <translation>测量此人的双手</translation>
    </message>
    <message>
        <source>Refine the calibration first.</source>
        <translation>请先优化标定。</translation>
    </message>
    <message>
        <source>No joint is clicked in two cameras yet.</source>
        <translation>还没有关节在两台相机中被点击。</translation>
    </message>
    <message>
        <source>The dataset uses %1 now; all joints were reconstructed anew.</source>
        <translation>数据集现在使用 %1；所有关节已重新重建。</translation>
    </message>
    <message>
        <source>Refining the calibration</source>
        <translation>正在优化标定</translation>
    </message>
    <message>
        <source>Measuring hands</source>
        <translation>正在测量双手</translation>
    </message>
    <message>
        <source>Measuring hands: %1</source>
        <translation>正在测量双手：%1</translation>
    </message>
    <message>
        <source>It is not known yet where the hands are: mark some joints, then frame them.</source>
        <translation>尚不知道双手的位置：请先标记几个关节，再对准双手。</translation>
    </message>
    <message>
        <source>No frame waits for a look.</source>
        <translation>没有等待审核的帧。</translation>
    </message>
    <message>
        <source>This is the only frame that waits for a look.</source>
        <translation>这是唯一等待审核的帧。</translation>
    </message>
    <message>
        <source>Every frame of the first pass is reviewed.</source>
        <translation>自动初标的每一帧都已审核。</translation>
    </message>
    <message>
        <source>Click or drag %1 in two views, then accept the frame.</source>
        <translation>请在两个视图中点击或拖动 %1，然后接受本帧。</translation>
    </message>
    <message numerus="yes">
        <source>Stopped: %n mark(s) in %1 frames are proposed; the next start goes on from there.</source>
        <translation>
            <numerusform>已停止：在 %1 帧中建议了 %n 个标记；下次开始时从此处继续。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>First pass: hands in %1 of %2 frames, %n mark(s) proposed.</source>
        <translation>
            <numerusform>自动初标：%2 帧中有 %1 帧找到手，建议了 %n 个标记。</numerusform>
        </translation>
    </message>
    <message>
        <source>Installing the hand detector</source>
        <translation>正在安装手部检测器</translation>
    </message>
    <message>
        <source>First pass</source>
        <translation>自动初标</translation>
    </message>
    <message>
        <source>Following the hands from the corrected frame</source>
        <translation>正在从修正后的帧开始跟踪双手</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) around frame %1 are proposed anew.</source>
        <translation>
            <numerusform>已重新建议第 %1 帧前后的 %n 个标记。</numerusform>
        </translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Making silhouettes</source>
        <translation>正在生成轮廓</translation>
    </message>
    <message>
        <source>A tracker&apos;s estimates</source>
        <translation>跟踪器的估计</translation>
    </message>
    <message>
        <source>Estimates (*.csv *.json)</source>
        <translation>估计 (*.csv *.json)</translation>
    </message>
    <message>
        <source>This sequence has no recorded motion.</source>
        <translation>此序列没有记录的运动。</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>Pages (*.pdf)</source>
        <translation>页面 (*.pdf)</translation>
    </message>
    <message>
        <source>Save the comparison as a picture</source>
        <translation>将比较另存为图片</translation>
    </message>
    <message>
        <source>Report of this comparison</source>
        <translation>此比较的报告</translation>
    </message>
    <message>
        <source>Saving the film</source>
        <translation>正在保存影片</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>影片 (*.mp4)</translation>
    </message>
    <message>
        <source>Films (*.avi)</source>
        <translation>影片 (*.avi)</translation>
    </message>
    <message>
        <source>Save the iterations as a film</source>
        <translation>将迭代过程存为影片</translation>
    </message>
    <message>
        <source>Bringing the hands to the corrected joint</source>
        <translation>正在使双手符合已更正的关节</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of frame %1 follow the corrected joint.</source>
        <translation>
            <numerusform>第 %1 帧的 %n 个标记已随更正的关节更新。</numerusform>
        </translation>
    </message>
    <message>
        <source>Silhouettes lie %1 px beside the hands: refine the calibration.</source>
        <translation>轮廓偏离手部 %1 像素：请优化标定。</translation>
    </message>
</context>
<context>
    <name>app::MasksPage</name>
    <message>
        <source>None yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>They can be made from the pictures once the dataset is open, or attached later.</source>
        <translation>打开数据集后可由图像生成，或稍后附加。</translation>
    </message>
    <message>
        <source>They are there</source>
        <translation>已有轮廓</translation>
    </message>
    <message>
        <source>A folder with a folder of numbered masks per camera, or a pattern with {camera} and {frame}. White is hand, black is not.</source>
        <translation>每台相机有一个带编号掩膜子文件夹的文件夹，或含 {camera} 和 {frame} 的模式。白色为手，黑色不是。</translation>
    </message>
    <message>
        <source>The folder of the silhouettes</source>
        <translation>轮廓的文件夹</translation>
    </message>
    <message>
        <source>Choose the folder of the silhouettes.</source>
        <translation>请选择轮廓的文件夹。</translation>
    </message>
    <message>
        <source>This must be a folder, or a pattern with {frame}.</source>
        <translation>此处必须是文件夹，或含 {frame} 的模式。</translation>
    </message>
</context>
<context>
    <name>app::NewDatasetWindow</name>
    <message>
        <source>Make a dataset</source>
        <translation>新建数据集</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Folder of the dataset</source>
        <translation>数据集文件夹</translation>
    </message>
    <message>
        <source>An empty folder for the dataset</source>
        <translation>用于数据集的空文件夹</translation>
    </message>
    <message>
        <source>Make the dataset</source>
        <translation>建立数据集</translation>
    </message>
    <message>
        <source>Footage</source>
        <translation>素材</translation>
    </message>
    <message>
        <source>Choose a folder for the dataset.</source>
        <translation>请选择数据集的文件夹。</translation>
    </message>
    <message>
        <source>The footage is looked at...</source>
        <translation>正在检查素材...</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>There is neither a video, nor a folder of images, nor a calibration in what was dropped.</source>
        <translation>拖放的内容中没有视频、图像文件夹或标定文件。</translation>
    </message>
    <message>
        <source>The folder of the dataset is not empty: choose another.</source>
        <translation>数据集的文件夹不为空：请另选。</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage</source>
        <translation>
            <numerusform>%n 份素材</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s)</source>
        <translation>
            <numerusform>%n 台相机</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::PathField</name>
    <message>
        <source>Choose...</source>
        <translation>选择...</translation>
    </message>
</context>
<context>
    <name>app::PreferencesWindow</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>您的姓名</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Another language is used from the next start on.</source>
        <translation>新语言将在下次启动时生效。</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Memory for pictures</source>
        <translation>图像内存</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Your marks are kept under this name.</source>
        <translation>您的标记以此姓名保存。</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Pictures of recent frames are kept in so much memory: stepping back then needs no reading.</source>
        <translation>近期帧的图像保存在此大小的内存中：后退时无需再读取。</translation>
    </message>
    <message>
        <source>Show the four hints at the next start</source>
        <translation>下次启动时显示四条提示</translation>
    </message>
</context>
<context>
    <name>app::RangeWindow</name>
    <message>
        <source>From frame</source>
        <translation>起始帧</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>结束帧</translation>
    </message>
</context>
<context>
    <name>app::ShortcutModel</name>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” already: change that one first.</source>
        <translation>%1 已分配给“%2”：请先更改那一项。</translation>
    </message>
</context>
<context>
    <name>app::ShortcutPage</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Double-click a shortcut to change it.</source>
        <translation>双击快捷键可更改。</translation>
    </message>
</context>
<context>
    <name>app::ShortcutWindow</name>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
</context>
<context>
    <name>widgets::Advice</name>
    <message>
        <source>fewer than two views</source>
        <translation>视图少于两个</translation>
    </message>
    <message>
        <source>a click lies where the lens model cannot be inverted</source>
        <translation>有点击位于镜头模型无法求逆之处</translation>
    </message>
    <message>
        <source>rays are nearly parallel</source>
        <translation>射线几乎平行</translation>
    </message>
    <message>
        <source>the rays meet behind a camera</source>
        <translation>射线相交于相机后方</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>视图之间不一致</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Choose a joint on the left.</source>
        <translation>请在左侧选择一个关节。</translation>
    </message>
    <message>
        <source>Click %1 in any view.</source>
        <translation>请在任意视图中点击 %1。</translation>
    </message>
    <message>
        <source>The click in %1 disagrees with the others: check it.</source>
        <translation>%1 中的点击与其他点击不一致：请检查。</translation>
    </message>
    <message>
        <source>No 3D point: %1.</source>
        <translation>没有 3D 点：%1。</translation>
    </message>
    <message>
        <source>Click %1 in a second view.</source>
        <translation>请在第二个视图中点击 %1。</translation>
    </message>
    <message>
        <source>Click %1 in a second view, best in %2.</source>
        <translation>请在第二个视图中点击 %1，最好在 %2 中。</translation>
    </message>
    <message>
        <source>Done in every view: go on with the next joint.</source>
        <translation>所有视图均已完成：请继续下一个关节。</translation>
    </message>
    <message>
        <source>Accept the remaining views with Space, or mark them as not placeable.</source>
        <translation>按空格键接受其余视图，或将其标为无法放置。</translation>
    </message>
    <message>
        <source>Click in %1 next (→ %2 mm), or accept with Space.</source>
        <translation>接下来在 %1 中点击（→ %2 mm），或按空格键接受。</translation>
    </message>
    <message>
        <source>No 3D point: the click in %1 is %2.</source>
        <translation>无三维点：%1 中的点击%2。</translation>
    </message>
    <message>
        <source>No 3D point: the click in %1 is %2, the one in %3 %4.</source>
        <translation>无三维点：%1 中的点击%2，%3 中的%4。</translation>
    </message>
    <message numerus="yes">
        <source>%1 clicked, %2 accepted, %3 proposed; %n view(s) have a picture</source>
        <translation>
            <numerusform>点击 %1，接受 %2，建议 %3；%n 个视图有图像</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 px off %2&apos;s curve</source>
        <translation>偏离 %2 的曲线 %1 px</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n view(s)</source>
        <translation>
            <numerusform>%1 / %n 个视图</numerusform>
        </translation>
    </message>
    <message>
        <source>A joint needs at least two cameras with a picture.</source>
        <translation>一个关节至少需要两台有图像的相机。</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>按建议</translation>
    </message>
    <message>
        <source>Accepted as proposed; click %1 in two views to correct it.</source>
        <translation>已按建议接受；如需修正，请在两个视图中点击 %1。</translation>
    </message>
    <message>
        <source>Proposed by a program: click %1 in two views if it is wrong.</source>
        <translation>由程序建议：如有错误，请在两个视图中点击 %1。</translation>
    </message>
</context>
<context>
    <name>widgets::AgreementModel</name>
    <message>
        <source>All joints</source>
        <translation>所有关节</translation>
    </message>
    <message>
        <source>Bias %1 mm, 95 % of the differences between %2 and %3 mm</source>
        <translation>偏差 %1 mm，95 % 的差值介于 %2 与 %3 mm 之间</translation>
    </message>
    <message>
        <source>Mean difference along this axis of the world, mm (Bland and Altman)</source>
        <translation>沿世界坐标系该轴的平均差值，mm（Bland-Altman）</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
</context>
<context>
    <name>widgets::AnnotationDocument</name>
    <message>
        <source>Nothing was changed: the annotations are open for reading only (%1).</source>
        <translation>未作任何更改：标注以只读方式打开（%1）。</translation>
    </message>
</context>
<context>
    <name>widgets::AnnotationFiles</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>请先打开一个数据集。</translation>
    </message>
    <message>
        <source>The import was stopped, because another sequence was opened.</source>
        <translation>由于打开了另一个序列，导入已停止。</translation>
    </message>
    <message>
        <source>One moment: the last import, export or report is not finished.</source>
        <translation>请稍候：上一次导入、导出或报告尚未完成。</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>正在导出</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>正在导入</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>正在写报告</translation>
    </message>
    <message>
        <source>Reading the joints</source>
        <translation>正在读取关节</translation>
    </message>
</context>
<context>
    <name>widgets::Annotator</name>
    <message>
        <source>Nothing to accept: click %1 in two views first.</source>
        <translation>没有可接受的标记：请先在两个视图中点击 %1。</translation>
    </message>
    <message>
        <source>There is no mark of %1 in this view.</source>
        <translation>此视图中没有 %1 的标记。</translation>
    </message>
    <message>
        <source>Click the place where the joint is hidden, then mark it as occluded.</source>
        <translation>请点击关节被遮挡的位置，然后将其标为遮挡。</translation>
    </message>
    <message>
        <source>Every view that sees %1 has a mark of it.</source>
        <translation>每个能看到 %1 的视图都已有其标记。</translation>
    </message>
    <message>
        <source>Nothing was placed: %1 has no picture of this frame.</source>
        <translation>未放置：%1 没有此帧的图像。</translation>
    </message>
    <message>
        <source>Nothing was placed: this is outside the picture of %1.</source>
        <translation>未放置：此处在 %1 的图像之外。</translation>
    </message>
    <message>
        <source>Nothing to accept in this frame: no joint with a 3D point has a view left that sees it.</source>
        <translation>此帧没有可接受的标记：有三维点的关节都没有剩余的可见视图。</translation>
    </message>
    <message>
        <source>There is no mark of %1 in this frame.</source>
        <translation>此帧没有 %1 的标记。</translation>
    </message>
    <message>
        <source>The mark is at the edge of the picture.</source>
        <translation>标记位于图像边缘。</translation>
    </message>
    <message>
        <source>Nothing to accept: the clicks of %1 give no 3D point.</source>
        <translation>没有可接受的内容：%1 的点击没有得出三维点。</translation>
    </message>
    <message>
        <source>Nothing waits to be accepted in this frame.</source>
        <translation>此帧没有等待接受的标记。</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPage</name>
    <message>
        <source>Methods</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>序列</translation>
    </message>
    <message>
        <source> % of frames</source>
        <translation> % 的帧</translation>
    </message>
    <message>
        <source>Synthetic</source>
        <translation>合成</translation>
    </message>
    <message>
        <source>Realistic</source>
        <translation>真实</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Frames apart</source>
        <translation>相隔帧数</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>“%1” is not a number of frames.</source>
        <translation>“%1”不是有效的帧数。</translation>
    </message>
    <message>
        <source>Choose at least one method and one sequence.</source>
        <translation>请至少选择一种方法和一个序列。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Save results...</source>
        <translation>保存结果...</translation>
    </message>
    <message>
        <source>Open results...</source>
        <translation>打开结果...</translation>
    </message>
    <message>
        <source>Tables, pairs and a report, as handlens-batch benchmark writes them</source>
        <translation>表格、配对和报告，与 handlens-batch benchmark 写出的相同</translation>
    </message>
    <message>
        <source>A folder that was saved here or written by handlens-batch benchmark</source>
        <translation>此处保存的或由 handlens-batch benchmark 写出的文件夹</translation>
    </message>
    <message>
        <source>Save the results in a folder</source>
        <translation>将结果保存到文件夹</translation>
    </message>
    <message>
        <source>Open the results of a folder</source>
        <translation>打开文件夹中的结果</translation>
    </message>
    <message>
        <source>Which setup the tables and curves below are of</source>
        <translation>下方表格和曲线所属的设置</translation>
    </message>
    <message>
        <source>Kendall&apos;s tau of the methods&apos; mean errors: 1 is the same order, 0 says nothing, -1 is the reverse; in brackets what 95 % of drawings of these pairs give</source>
        <translation>各方法平均误差的 Kendall tau：1 为顺序相同，0 为无关，-1 为顺序相反；括号内为这些配对重抽样的 95 % 范围</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Synthetic: silhouettes of the recorded poses, errors over all joints. Realistic: mask files, errors over the marked joints. Both: one after the other, side by side in one report.</source>
        <translation>合成：记录姿态的轮廓，误差按所有关节计算。真实：掩膜文件，误差按已标记的关节计算。两者：依次进行，并排列于同一报告。</translation>
    </message>
    <message>
        <source>Order of the methods in both setups: tau %1 (%2 to %3)</source>
        <translation>两种设置下各方法的顺序：tau %1（%2 至 %3）</translation>
    </message>
    <message>
        <source>The results are saved in %1.</source>
        <translation>结果已保存到 %1。</translation>
    </message>
    <message>
        <source>Show the report</source>
        <translation>显示报告</translation>
    </message>
    <message>
        <source>Stop the benchmark first.</source>
        <translation>请先停止基准测试。</translation>
    </message>
    <message>
        <source>Choose at least one method.</source>
        <translation>请至少选择一种方法。</translation>
    </message>
    <message>
        <source>Select pairs in the table first.</source>
        <translation>请先在表格中选择配对。</translation>
    </message>
    <message>
        <source>Results of %1; the settings on the left are those of the next run.</source>
        <translation>%1 的结果；左侧的设置用于下一次运行。</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPairPlots</name>
    <message>
        <source>No pair that is shown has results of both methods.</source>
        <translation>所显示的配对中没有同时具有两种方法结果的。</translation>
    </message>
    <message>
        <source>Every pair: click one to inspect it</source>
        <translation>所有配对：点击一个即可检视</translation>
    </message>
    <message>
        <source>A: %1, mm</source>
        <translation>A：%1，mm</translation>
    </message>
    <message>
        <source>B: %1, mm</source>
        <translation>B：%1，mm</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1，%2 至 %3</translation>
    </message>
    <message>
        <source>Where A and B differ</source>
        <translation>A 与 B 的差异所在</translation>
    </message>
    <message>
        <source>A − B, mm</source>
        <translation>A − B，mm</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>配对</translation>
    </message>
    <message>
        <source>A is better: %1</source>
        <translation>A 较优：%1</translation>
    </message>
    <message>
        <source>B is better: %1</source>
        <translation>B 较优：%1</translation>
    </message>
    <message>
        <source>No pair is shown.</source>
        <translation>未显示任何配对。</translation>
    </message>
    <message>
        <source>By frames apart: quartiles, and 5 to 95 %</source>
        <translation>按相隔帧数：四分位数及 5 至 95 %</translation>
    </message>
    <message>
        <source>Frames apart</source>
        <translation>相隔帧数</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>误差，mm</translation>
    </message>
    <message>
        <source>frames apart: %1</source>
        <translation>相隔帧数：%1</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPairsView</name>
    <message>
        <source>Double-click a pair to inspect it with every method; select several to run them</source>
        <translation>双击配对可用所有方法检视；选择多个可运行它们</translation>
    </message>
    <message>
        <source>The column A − B and the plots compare these two methods</source>
        <translation>A − B 列和图表比较这两种方法</translation>
    </message>
    <message>
        <source>Method %1</source>
        <translation>方法 %1</translation>
    </message>
    <message>
        <source>Filter, such as A-B&gt;1 difference&gt;=10</source>
        <translation>筛选，例如 A-B&gt;1 difference&gt;=10</translation>
    </message>
    <message>
        <source>Filter of the pairs</source>
        <translation>配对的筛选条件</translation>
    </message>
    <message>
        <source>Runs the methods that are ticked on the left on the selected pairs, and adds what they find</source>
        <translation>对所选配对运行左侧勾选的方法，并添加所得结果</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 / %2 个配对</translation>
    </message>
    <message>
        <source>Run selected</source>
        <translation>运行所选</translation>
    </message>
    <message>
        <source>Inspect this pair</source>
        <translation>检视此配对</translation>
    </message>
    <message>
        <source>Select all that are shown</source>
        <translation>选择所有显示的配对</translation>
    </message>
    <message>
        <source>Copy the selected rows</source>
        <translation>复制所选行</translation>
    </message>
    <message>
        <source>Run selected (%1)</source>
        <translation>运行所选（%1）</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkResultsView</name>
    <message>
        <source>Share of pairs below each error</source>
        <translation>低于各误差的配对比例</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>误差，mm</translation>
    </message>
    <message>
        <source>Pairs, %</source>
        <translation>配对，%</translation>
    </message>
    <message>
        <source>Run the benchmark to compare the methods.</source>
        <translation>运行基准测试以比较各方法。</translation>
    </message>
    <message>
        <source>Error per joint</source>
        <translation>各关节误差</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>All methods</source>
        <translation>所有方法</translation>
    </message>
    <message>
        <source>A against B</source>
        <translation>A 对比 B</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkRunner</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>请先打开一个数据集。</translation>
    </message>
    <message>
        <source>%1 of %2 fits</source>
        <translation>已完成 %1/%2 次拟合</translation>
    </message>
    <message>
        <source>This folder holds the results of another benchmark. Choose another one.</source>
        <translation>此文件夹中是另一基准测试的结果。请另选。</translation>
    </message>
    <message>
        <source>This folder already holds a file %1. Choose another one.</source>
        <translation>此文件夹中已有文件 %1。请另选。</translation>
    </message>
    <message>
        <source>There are no results to save yet.</source>
        <translation>还没有可保存的结果。</translation>
    </message>
    <message>
        <source>Stop the benchmark first.</source>
        <translation>请先停止基准测试。</translation>
    </message>
    <message>
        <source>These results are not of the open dataset, or it has changed since: %1.</source>
        <translation>这些结果不属于打开的数据集，或数据集已更改：%1。</translation>
    </message>
    <message numerus="yes">
        <source>This benchmark is not finished: %n fit(s) are in.</source>
        <translation>
            <numerusform>此基准测试尚未完成：已有 %n 次拟合。</numerusform>
        </translation>
    </message>
    <message>
        <source>These results are not of the open dataset, or it has changed since: pairs cannot be added to them.</source>
        <translation>这些结果不属于打开的数据集，或数据集已更改：无法向其中添加配对。</translation>
    </message>
</context>
<context>
    <name>widgets::BoxPlot</name>
    <message>
        <source>%1: median %2</source>
        <translation>%1：中位数 %2</translation>
    </message>
</context>
<context>
    <name>widgets::CalibrationChoice</name>
    <message>
        <source>Wait until the sequence is open.</source>
        <translation>请等待序列打开。</translation>
    </message>
</context>
<context>
    <name>widgets::CameraChoice</name>
    <message>
        <source>Which cameras are the rows</source>
        <translation>显示哪些相机的行</translation>
    </message>
    <message>
        <source>From the current one on</source>
        <translation>从当前相机开始</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>选择</translation>
    </message>
    <message numerus="yes">
        <source>%n chosen</source>
        <translation>
            <numerusform>已选 %n 台</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::CameraFaultText</name>
    <message>
        <source>its rotation is a mirror: an axis points the wrong way</source>
        <translation>其旋转为镜像：有一个轴方向错误</translation>
    </message>
    <message>
        <source>its rotation matrix is not a rotation</source>
        <translation>其旋转矩阵不是旋转</translation>
    </message>
    <message>
        <source>its focal length is not positive</source>
        <translation>其焦距不是正值</translation>
    </message>
    <message>
        <source>its principal point lies outside the image: is the matrix transposed, or the image size wrong?</source>
        <translation>其主点位于图像之外：矩阵被转置，或图像尺寸有误？</translation>
    </message>
    <message>
        <source>its footage has %1 pixels, the calibration is for %2: another camera&apos;s footage?</source>
        <translation>其素材为 %1 像素，而标定针对 %2：是否为另一台相机的素材？</translation>
    </message>
    <message>
        <source>its footage is scaled by %1 (%2 pixels, the calibration is for %3)</source>
        <translation>其素材缩放了 %1 倍（%2 像素，而标定针对 %3）</translation>
    </message>
    <message>
        <source>it stands where %1 stands</source>
        <translation>它与 %1 位置相同</translation>
    </message>
    <message>
        <source>where the cameras look lies behind it: is its rotation inverted?</source>
        <translation>各相机所对准之处位于其后方：其旋转是否取反？</translation>
    </message>
    <message>
        <source>it does not see where the other cameras look</source>
        <translation>它看不到其他相机所对准之处</translation>
    </message>
    <message>
        <source>its lens model holds in %1 % of the image only</source>
        <translation>其镜头模型仅在图像的 %1 % 内有效</translation>
    </message>
    <message>
        <source>The cameras are %1 mm from where they look: choose another unit.</source>
        <translation>相机距其所对准之处 %1 mm：请选择其他单位。</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnBar</name>
    <message>
        <source>Add a column: a method, the start, the truth, a tracker</source>
        <translation>添加一列：方法、起始姿态、真值、跟踪器</translation>
    </message>
    <message>
        <source>Add a column</source>
        <translation>添加列</translation>
    </message>
    <message>
        <source>A tracker&apos;s estimates...</source>
        <translation>跟踪器的估计...</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnHead</name>
    <message>
        <source>Settings of this method, and what if</source>
        <translation>此方法的设置和假设分析</translation>
    </message>
    <message>
        <source>Remove this column</source>
        <translation>移除此列</translation>
    </message>
    <message>
        <source>Drag it to another place</source>
        <translation>拖动到其他位置</translation>
    </message>
</context>
<context>
    <name>widgets::CurvePlot</name>
    <message>
        <source>Logarithmic axis</source>
        <translation>对数坐标轴</translation>
    </message>
</context>
<context>
    <name>widgets::DatasetSession</name>
    <message>
        <source>Your last edits are not saved yet, so they would be lost. Make room or give permission where they are kept, or export them first.</source>
        <translation>您最近的编辑尚未保存，继续将会丢失。请在其存储位置腾出空间或授予权限，或先将其导出。</translation>
    </message>
</context>
<context>
    <name>widgets::EditText</name>
    <message>
        <source>delete %1 in %2</source>
        <translation>在 %2 中删除 %1</translation>
    </message>
    <message>
        <source>mark %1 as not placeable in %2</source>
        <translation>在 %2 中将 %1 标为无法放置</translation>
    </message>
    <message>
        <source>accept %1 in %2</source>
        <translation>在 %2 中接受 %1</translation>
    </message>
    <message>
        <source>place %1 in %2</source>
        <translation>在 %2 中放置 %1</translation>
    </message>
    <message>
        <source>move %1 in %2</source>
        <translation>在 %2 中移动 %1</translation>
    </message>
    <message>
        <source>mark %1 as occluded in %2</source>
        <translation>在 %2 中将 %1 标为遮挡</translation>
    </message>
    <message>
        <source>mark %1 as visible in %2</source>
        <translation>在 %2 中将 %1 标为可见</translation>
    </message>
    <message numerus="yes">
        <source>accept %n mark(s)</source>
        <translation>
            <numerusform>接受 %n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>copy a pose (%n mark(s))</source>
        <translation>
            <numerusform>复制姿态（%n 个标记）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>interpolate (%n mark(s))</source>
        <translation>
            <numerusform>插值（%n 个标记）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>swap left and right (%n mark(s))</source>
        <translation>
            <numerusform>交换左右手（%n 个标记）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n mark(s)</source>
        <translation>
            <numerusform>删除 %n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>import %n mark(s)</source>
        <translation>
            <numerusform>导入 %n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>propose %n mark(s)</source>
        <translation>
            <numerusform>建议 %n 个标记</numerusform>
        </translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>左 %1</translation>
    </message>
    <message>
        <source>R %1</source>
        <translation>右 %1</translation>
    </message>
    <message>
        <source>note on frame %1</source>
        <translation>第 %1 帧的备注</translation>
    </message>
    <message numerus="yes">
        <source>change %n mark(s)</source>
        <translation>
            <numerusform>更改 %n 个标记</numerusform>
        </translation>
    </message>
    <message>
        <source>propose %1 in %2</source>
        <translation>在 %2 中建议 %1</translation>
    </message>
    <message numerus="yes">
        <source>first pass (%n proposed mark(s))</source>
        <translation>
            <numerusform>自动初标（%n 个建议的标记）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::EmptyState</name>
    <message>
        <source>Recent datasets</source>
        <translation>最近的数据集</translation>
    </message>
    <message>
        <source>Open a dataset...</source>
        <translation>打开数据集...</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>试用演示</translation>
    </message>
    <message>
        <source>Open a dataset or make one of your videos: drop either here. Or try the demo.</source>
        <translation>打开数据集，或由您的视频新建：拖放到此处即可。或试用演示。</translation>
    </message>
    <message>
        <source>Make a dataset...</source>
        <translation>新建数据集...</translation>
    </message>
</context>
<context>
    <name>widgets::ErrorText</name>
    <message>
        <source>this is not possible with the data that is open</source>
        <translation>当前打开的数据不支持此操作</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>the content is not valid</source>
        <translation>内容无效</translation>
    </message>
    <message>
        <source>written by a newer version of Handlens</source>
        <translation>由更新版本的 Handlens 写入</translation>
    </message>
    <message>
        <source>cannot be read or written: check permissions and space</source>
        <translation>无法读取或写入：请检查权限和空间</translation>
    </message>
    <message>
        <source>this kind of content is not supported</source>
        <translation>不支持此类内容</translation>
    </message>
    <message>
        <source>unexpected error</source>
        <translation>意外错误</translation>
    </message>
</context>
<context>
    <name>widgets::Finding</name>
    <message>
        <source>click in %1 is %2 px off</source>
        <translation>%1 中的点击偏离 %2 px</translation>
    </message>
    <message>
        <source>no 3D point from its clicks</source>
        <translation>其点击无法得出 3D 点</translation>
    </message>
    <message>
        <source>bone %1 % longer than usual</source>
        <translation>骨骼比通常长 %1 %</translation>
    </message>
    <message>
        <source>bone %1 % shorter than usual</source>
        <translation>骨骼比通常短 %1 %</translation>
    </message>
    <message>
        <source>bent %1° beyond its limit</source>
        <translation>弯曲超出极限 %1°</translation>
    </message>
    <message>
        <source>fingers exchanged? %1 mm out of order</source>
        <translation>手指互换？顺序错位 %1 mm</translation>
    </message>
    <message>
        <source>left and right exchanged?</source>
        <translation>左右手互换？</translation>
    </message>
    <message>
        <source>on the same pixel as another joint in %1</source>
        <translation>在 %1 中与另一关节位于同一像素</translation>
    </message>
    <message>
        <source>no 3D point: %1</source>
        <translation>没有 3D 点：%1</translation>
    </message>
    <message>
        <source>error of %1 px</source>
        <translation>误差 %1 px</translation>
    </message>
    <message>
        <source>no 3D point: click in %1 is %2</source>
        <translation>无三维点：%1 中的点击%2</translation>
    </message>
    <message>
        <source>mark is %1 px outside the picture of %2</source>
        <translation>标记位于 %2 图像之外 %1 px</translation>
    </message>
</context>
<context>
    <name>widgets::FindingModel</name>
    <message>
        <source>Finding</source>
        <translation>发现的问题</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
</context>
<context>
    <name>widgets::FirstPass</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>请先打开一个数据集。</translation>
    </message>
    <message>
        <source>These annotations are read-only: nothing can be proposed.</source>
        <translation>这些标注为只读：无法提出建议。</translation>
    </message>
    <message>
        <source>The first pass needs two cameras with pictures.</source>
        <translation>自动初标需要两台有图像的相机。</translation>
    </message>
</context>
<context>
    <name>widgets::FirstPassForm</name>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>all 21 of a hand</source>
        <translation>每只手全部 21 个</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>The hand detector of %1 is installed.</source>
        <translation>已安装 %1 的手部检测器。</translation>
    </message>
    <message>
        <source>The list of joints follows; otherwise only joints of the list are proposed</source>
        <translation>关节列表随之更改；否则仅建议列表中的关节</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>第一帧</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>最后一帧</translation>
    </message>
    <message>
        <source>Every so many frames</source>
        <translation>每隔多少帧</translation>
    </message>
    <message>
        <source>Finds the joints in these frames, in the background; they wait for your look as proposals</source>
        <translation>在后台找出这些帧中的关节；它们作为建议等待您审核</translation>
    </message>
    <message>
        <source>Keeps the frames that are done; the next start goes on from there</source>
        <translation>保留已完成的帧；下次开始时从此处继续</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>every</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>Open a dataset first.</source>
        <translation>请先打开一个数据集。</translation>
    </message>
    <message>
        <source>Choose a hand.</source>
        <translation>请选择一只手。</translation>
    </message>
    <message>
        <source>The last frame comes before the first one.</source>
        <translation>最后一帧在第一帧之前。</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s). Marks that are there already stay.</source>
        <translation>
            <numerusform>%n 帧。已有的标记保留。</numerusform>
        </translation>
    </message>
    <message>
        <source>The hand detector is not installed: get it with &quot;npm pack @mediapipe/hands&quot; (11 MB, Apache-2.0) and choose the file, or run &quot;handlens-batch detector install FILE&quot;.</source>
        <translation>未安装手部检测器：请用“npm pack @mediapipe/hands”获取（11 MB，Apache-2.0）并选择该文件，或运行“handlens-batch detector install FILE”。</translation>
    </message>
    <message>
        <source>Choose the file...</source>
        <translation>选择文件...</translation>
    </message>
    <message>
        <source>The package @mediapipe/hands</source>
        <translation>软件包 @mediapipe/hands</translation>
    </message>
    <message>
        <source>Packages (*.tgz)</source>
        <translation>软件包 (*.tgz)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>widgets::FitPair</name>
    <message>
        <source>This sequence has no recorded motion: mark some joints of every hand in the start frame, and the fit starts from the hand model fitted to them.</source>
        <translation>此序列没有记录的运动：请在起始帧中标记每只手的若干关节，拟合将从贴合这些关节的手部模型开始。</translation>
    </message>
    <message>
        <source>There is no mask file of the test frame.</source>
        <translation>测试帧没有掩膜文件。</translation>
    </message>
</context>
<context>
    <name>widgets::FitRunner</name>
    <message>
        <source>This dataset has no hand models to fit.</source>
        <translation>此数据集没有可拟合的手部模型。</translation>
    </message>
    <message>
        <source>This sequence has no mask files.</source>
        <translation>此序列没有掩膜文件。</translation>
    </message>
    <message>
        <source>This sequence has no recorded motion to draw silhouettes from.</source>
        <translation>此序列没有可用于绘制轮廓的记录运动。</translation>
    </message>
    <message>
        <source>The start and the test frame must be between 0 and %1.</source>
        <translation>起始帧和测试帧必须介于 0 与 %1 之间。</translation>
    </message>
    <message>
        <source>Choose at least one method.</source>
        <translation>请至少选择一种方法。</translation>
    </message>
    <message>
        <source>This sequence needs silhouettes: attach a folder of masks, or make them.</source>
        <translation>此序列需要轮廓：请附加掩膜文件夹，或生成掩膜。</translation>
    </message>
</context>
<context>
    <name>widgets::FittingPanel</name>
    <message>
        <source>Silhouettes of the recorded pose</source>
        <translation>记录姿态的轮廓</translation>
    </message>
    <message>
        <source>Silhouettes of the mask files</source>
        <translation>掩膜文件的轮廓</translation>
    </message>
    <message>
        <source>What the fit is to meet. Against mask files, errors are measured over the joints marked in the test frame.</source>
        <translation>拟合的目标。以掩膜文件为目标时，误差按测试帧中已标记的关节计算。</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>迭代</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>误差 (mm)</translation>
    </message>
    <message>
        <source>The error of every iteration appears here.</source>
        <translation>每次迭代的误差将显示在此处。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Frame whose silhouettes are to be met</source>
        <translation>拟合以该帧的轮廓为目标</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>Test the current frame</source>
        <translation>以当前帧为测试帧</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Frame whose pose the fit starts from: the recorded one or, without, the hand model of its marks</source>
        <translation>拟合起始姿态所在的帧：已记录的姿态；若没有，则为由其标记得到的手部模型</translation>
    </message>
    <message>
        <source>Attach masks...</source>
        <translation>附加掩膜...</translation>
    </message>
    <message>
        <source>A folder of masks, white where the hands are: CAMERA/000012.png, CAMERA_000012.png or the like</source>
        <translation>掩膜文件夹，手为白色：CAMERA/000012.png、CAMERA_000012.png 等</translation>
    </message>
</context>
<context>
    <name>widgets::FootageFinder</name>
    <message>
        <source>not found: %1</source>
        <translation>未找到：%1</translation>
    </message>
</context>
<context>
    <name>widgets::FootageText</name>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1，另有 %n 处</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing after frame %2.</source>
        <translation>
            <numerusform>%1：第 %2 帧之后缺失 %n 帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 after frame %2</source>
        <translation>第 %2 帧之后 %1 帧</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing: %2.</source>
        <translation>
            <numerusform>%1：缺失 %n 帧：%2。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n picture(s) missing: %2.</source>
        <translation>
            <numerusform>%1：缺失 %n 幅图像：%2。</numerusform>
        </translation>
    </message>
    <message>
        <source>The pictures start at different numbers (%1); the first ones are taken as the same instant.</source>
        <translation>图像的起始编号不同 (%1)；将各自的第一幅视为同一时刻。</translation>
    </message>
    <message>
        <source>%1: its time stamps are uneven or missing, so lost frames cannot be told; its frames are taken by number.</source>
        <translation>%1：其时间戳不均匀或缺失，因此无法判断丢帧；按编号取帧。</translation>
    </message>
    <message>
        <source>%1: frame 0 is picture %2.</source>
        <translation>%1：第 0 帧为图像 %2。</translation>
    </message>
    <message numerus="yes">
        <source>%1 goes on for %n frame(s) after the last instant.</source>
        <translation>
            <numerusform>%1 在最后时刻之后还有 %n 帧。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n frame(s) more than the shortest footage: are they all of the same instants?</source>
        <translation>
            <numerusform>%1 比最短的素材多 %n 帧：它们是否都属于相同的时刻？</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was recorded at another frame rate than the sequence&apos;s %2.</source>
        <translation>%1 的录制帧率与序列的 %2 不同。</translation>
    </message>
    <message>
        <source>%1: its pictures have more than 8 bits; level %2 is shown black, %3 white.</source>
        <translation>%1：其图像超过 8 位；灰度 %2 显示为黑色，%3 显示为白色。</translation>
    </message>
    <message>
        <source>%1: the orientation tag of its pictures says that they are mirrored; they are not mirrored here, but turned by %2°.</source>
        <translation>%1：其图像的方向标签表示为镜像；此处不作镜像，而是旋转 %2°。</translation>
    </message>
    <message>
        <source>%1: turned clockwise by %2°, as its orientation tag says.</source>
        <translation>%1：按其方向标签顺时针旋转 %2°。</translation>
    </message>
    <message>
        <source>%1: its orientation tag says that it is to be turned clockwise by %2°, but it is turned by %3°.</source>
        <translation>%1：其方向标签要求顺时针旋转 %2°，但实际旋转了 %3°。</translation>
    </message>
    <message>
        <source>Simulated. Masks are the difference of each picture to the empty room; only the annotated frames have pictures. The recorded motion is that of the person in the pictures, played by the model&apos;s hand. What it was drawn from is in the folder truth.</source>
        <translation>模拟数据。掩膜为每幅图像与空房间的差异；仅已标注帧有图像。记录的运动是图像中人物的运动，由模型的手呈现。绘制所依据的数据在文件夹 truth 中。</translation>
    </message>
    <message>
        <source>Its frames are taken by number, so the later ones are not of the other cameras&apos; instants.</source>
        <translation>其帧按编号选取，因此后面的帧与其他相机的时刻不一致。</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frames have a mask.</source>
        <translation>%1：%3 帧中有 %2 帧有掩膜。</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n mask(s) of no frame of the sequence: its frames need the numbers %2 to %3, the masks have %4 to %5.</source>
        <translation>
            <numerusform>%1：%n 个掩膜不对应序列的任何帧：其帧需要编号 %2 至 %3，而掩膜为 %4 至 %5。</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 frames, but the sequence needs %2</source>
        <translation>它有 %1 帧，但序列需要 %2 帧</translation>
    </message>
    <message>
        <source>it has %1 pictures, but the sequence needs %2</source>
        <translation>它有 %1 幅图像，但序列需要 %2 幅</translation>
    </message>
    <message>
        <source>it is %1, but its camera is calibrated for %2</source>
        <translation>它是 %1，但其相机按 %2 标定</translation>
    </message>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>无法读取 (%1)</translation>
    </message>
    <message>
        <source>several fit: %1</source>
        <translation>有多个符合：%1</translation>
    </message>
    <message>
        <source>%1 has that name, but is other footage of this dataset</source>
        <translation>%1 具有该名称，但属于此数据集的其他素材</translation>
    </message>
</context>
<context>
    <name>widgets::FramePictures</name>
    <message>
        <source>No picture at this instant.</source>
        <translation>此时刻没有图像。</translation>
    </message>
    <message>
        <source>Find...</source>
        <translation>查找...</translation>
    </message>
</context>
<context>
    <name>widgets::FramesBar</name>
    <message>
        <source>Sequence</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Frame: type a number and press Enter</source>
        <translation>帧：输入编号并按回车键</translation>
    </message>
    <message>
        <source>Frame </source>
        <translation>帧 </translation>
    </message>
    <message>
        <source>What the colours of the timeline mean</source>
        <translation>时间线颜色的含义</translation>
    </message>
</context>
<context>
    <name>widgets::HandDiagram</name>
    <message>
        <source>Joints of both hands</source>
        <translation>双手关节</translation>
    </message>
</context>
<context>
    <name>widgets::HandFraming</name>
    <message>
        <source>L</source>
        <comment>left hand, one letter beside it</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right hand, one letter beside it</comment>
        <translation>R</translation>
    </message>
</context>
<context>
    <name>widgets::HandModelFit</name>
    <message>
        <source>This dataset has no hand models.</source>
        <translation>此数据集没有手部模型。</translation>
    </message>
    <message>
        <source>The hand model needs three joints of a hand that have a 3D point and are not on a line.</source>
        <translation>手部模型需要同一只手上三个具有 3D 点且不共线的关节。</translation>
    </message>
</context>
<context>
    <name>widgets::Hints</name>
    <message>
        <source>Choose a joint on the left, then click it in two views: its 3D place appears at once.</source>
        <translation>在左侧选择一个关节，然后在两个视图中点击它：其 3D 位置会立即显示。</translation>
    </message>
    <message>
        <source>Space accepts a pre-placed mark, X deletes one, Ctrl+Z takes back anything.</source>
        <translation>空格键接受预置标记，X 删除标记，Ctrl+Z 可撤销任何操作。</translation>
    </message>
    <message>
        <source>A and D step through the frames, W and S through the joints; F1 shows every key.</source>
        <translation>A 和 D 逐帧切换，W 和 S 切换关节；F1 显示所有按键。</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves, a double click fills the window with one view; 9 frames the hands, 0 shows whole pictures.</source>
        <translation>滚轮缩放，中键移动，双击使一个视图充满窗口；9 对准双手，0 显示整幅图像。</translation>
    </message>
    <message>
        <source>Got it (Esc)</source>
        <translation>知道了 (Esc)</translation>
    </message>
</context>
<context>
    <name>widgets::HistogramPlot</name>
    <message>
        <source>%1 to %2, pairs: %3</source>
        <translation>%1 至 %2，对数：%3</translation>
    </message>
</context>
<context>
    <name>widgets::ImportText</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1，另有 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: its footage is shifted against the sequence; the numbers of its pictures are taken as frames of the sequence, not of the video.</source>
        <translation>%1：其素材相对于序列有偏移；其图像编号视为序列的帧号，而非视频的帧号。</translation>
    </message>
    <message>
        <source>The file names none of the dataset&apos;s cameras; they are taken in the dataset&apos;s order: %1.</source>
        <translation>文件未提及数据集的任何相机；按数据集的顺序对应：%1。</translation>
    </message>
    <message>
        <source>The file holds reprojections of 3D points, not clicks (data_2d); they come as proposals.</source>
        <translation>文件包含三维点的重投影，而非点击 (data_2d)；它们作为建议导入。</translation>
    </message>
    <message>
        <source>The file holds 3D points without clicks; they come as proposals.</source>
        <translation>文件包含没有点击的三维点；它们作为建议导入。</translation>
    </message>
    <message>
        <source>The file is of sequence %1, not of %2.</source>
        <translation>文件属于序列 %1，而非 %2。</translation>
    </message>
    <message>
        <source>Some marks are a program&apos;s guesses; they come as proposals, to be checked.</source>
        <translation>部分标记为程序的预测；它们作为建议导入，待检查。</translation>
    </message>
    <message>
        <source>The marks are a program&apos;s guesses; they come as proposals, to be checked.</source>
        <translation>这些标记为程序的预测；它们作为建议导入，待检查。</translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n item(s) of frames that sequence %1 does not have (it has 0 to %2).</source>
        <translation>
            <numerusform>已略过：%n 项，其帧在序列 %1 中不存在（该序列为 0 至 %2）。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) in camera %1, which the dataset does not have.</source>
        <translation>
            <numerusform>已略过：相机 %1 中的 %n 个标记，数据集没有该相机。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of the view of camera %1.</source>
        <translation>
            <numerusform>已略过：相机 %1 的视图的 %n 行。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of other videos: %1.</source>
        <translation>
            <numerusform>已略过：其他视频的 %n 行：%1。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) outside the picture of %1: kept, but not used for 3D points.</source>
        <translation>
            <numerusform>%n 个标记在 %1 的图像之外：保留，但不用于三维点。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) with a likelihood below %1.</source>
        <translation>
            <numerusform>已略过：%n 个可能性低于 %1 的标记。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n guess(es) of joints that are labelled or guessed in the same picture already.</source>
        <translation>
            <numerusform>已略过：%n 个预测，其关节在同一图像中已有标注或预测。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n label(s) marked as not visible.</source>
        <translation>
            <numerusform>已略过：%n 个标为不可见的标注。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of %1, which is not in the joint map.</source>
        <translation>
            <numerusform>已略过：%1 的 %n 个标记，其不在关节映射中。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n annotation(s) of category %1, which says neither left nor right.</source>
        <translation>
            <numerusform>已略过：类别 %1 的 %n 个标注，该类别未说明左右手。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of body parts that are not joints: %1. A name that fits is %2; the command line takes a map of names (annotations --map).</source>
        <translation>
            <numerusform>已略过：%n 个非关节部位的标记：%1。符合要求的名称如 %2；命令行可使用名称映射 (annotations --map)。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::InspectColumns</name>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>真值</translation>
    </message>
    <message>
        <source>%1?</source>
        <comment>a method with settings that are tried</comment>
        <translation>%1？</translation>
    </message>
</context>
<context>
    <name>widgets::InspectCurves</name>
    <message>
        <source>rigid</source>
        <translation>刚性</translation>
    </message>
    <message>
        <source>coarse mesh</source>
        <translation>粗网格</translation>
    </message>
    <message>
        <source>medium mesh</source>
        <translation>中等网格</translation>
    </message>
    <message>
        <source>full mesh</source>
        <translation>完整网格</translation>
    </message>
    <message>
        <source>Hands move as a whole, their fingers do not</source>
        <translation>手整体移动，手指不动</translation>
    </message>
    <message>
        <source>All joints move, by a coarse mesh</source>
        <translation>所有关节移动，使用粗网格</translation>
    </message>
    <message>
        <source>All joints move, by a finer mesh</source>
        <translation>所有关节移动，使用较细网格</translation>
    </message>
    <message>
        <source>All joints move, by the whole mesh</source>
        <translation>所有关节移动，使用完整网格</translation>
    </message>
</context>
<context>
    <name>widgets::InspectGrid</name>
    <message>
        <source>No picture at this instant.</source>
        <translation>此时刻没有图像。</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>IoU: intersection over union of both silhouettes in this view, without the forearm, which the fit leaves out</source>
        <translation>IoU：此视图中两个轮廓的交并比，不含拟合所忽略的前臂</translation>
    </message>
    <message>
        <source>IoU: intersection over union of both silhouettes in this view</source>
        <translation>IoU：此视图中两个轮廓的交并比</translation>
    </message>
    <message>
        <source>IoU %1</source>
        <translation>IoU %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1，未使用</translation>
    </message>
</context>
<context>
    <name>widgets::InspectJointErrors</name>
    <message>
        <source>The column whose error is drawn, joint by joint, at the iteration that is shown</source>
        <translation>按所示迭代逐关节绘制误差的列</translation>
    </message>
</context>
<context>
    <name>widgets::InspectLayerBar</name>
    <message>
        <source>Direction of the rim point whose field is shown</source>
        <translation>所显示的场对应的边缘点方向</translation>
    </message>
    <message>
        <source>(%1, %2), direction %3°</source>
        <translation>(%1, %2)，方向 %3°</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1, refused</source>
        <translation>%1，被拒绝</translation>
    </message>
    <message>
        <source>95 % regions</source>
        <translation>95 % 区域</translation>
    </message>
    <message>
        <source>Point at a view to see what each method would match there; click to pin it.</source>
        <translation>指向某个视图，查看各方法在该处会匹配什么；单击可固定。</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>拒绝：%1</translation>
    </message>
    <message>
        <source>Rim points and matches that are drawn</source>
        <translation>绘制的边缘点和匹配</translation>
    </message>
    <message>
        <source>missed: seen, not covered</source>
        <translation>漏：可见但未覆盖</translation>
    </message>
    <message>
        <source>extra: covered, not seen</source>
        <translation>多：覆盖但不可见</translation>
    </message>
    <message>
        <source>forearm: left out, as the fit does</source>
        <translation>前臂：与拟合一样忽略</translation>
    </message>
    <message>
        <source>outline, by direction</source>
        <translation>轮廓，按方向</translation>
    </message>
    <message>
        <source>direction %1°</source>
        <translation>方向 %1°</translation>
    </message>
    <message>
        <source>rim, with normals</source>
        <translation>边缘及法线</translation>
    </message>
    <message>
        <source>observed silhouette</source>
        <translation>观测轮廓</translation>
    </message>
    <message>
        <source>error: there is no recorded pose</source>
        <translation>误差：没有记录的姿态</translation>
    </message>
    <message>
        <source>observed silhouette, with noise</source>
        <translation>观测轮廓（含噪声）</translation>
    </message>
    <message>
        <source>matches 0–%1+ px</source>
        <translation>匹配 0–%1+ px</translation>
    </message>
    <message>
        <source>field 0–%1+ px; clear: no match</source>
        <translation>距离场 0–%1+ px；透明：无匹配</translation>
    </message>
    <message>
        <source>error 0–%1+ mm</source>
        <translation>误差 0–%1+ mm</translation>
    </message>
</context>
<context>
    <name>widgets::InspectPage</name>
    <message>
        <source>Cameras: </source>
        <translation>相机： </translation>
    </message>
    <message>
        <source>Rows of cameras, from the current one on</source>
        <translation>从当前相机开始显示的相机行数</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>迭代</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>误差 (mm)</translation>
    </message>
    <message>
        <source>Cost, mm²</source>
        <translation>代价 (mm²)</translation>
    </message>
    <message>
        <source>Frame %1 from frame %2</source>
        <translation>第 %1 帧，起始于第 %2 帧</translation>
    </message>
    <message>
        <source>Iteration %1 of %2</source>
        <translation>第 %1 次迭代，共 %2 次</translation>
    </message>
    <message>
        <source>Fit this frame</source>
        <translation>拟合此帧</translation>
    </message>
    <message>
        <source>With the methods chosen under Fit, from the pose of some frames before</source>
        <translation>使用“拟合”中选择的方法，从若干帧之前的姿态开始</translation>
    </message>
    <message>
        <source>Fitting...</source>
        <translation>正在拟合...</translation>
    </message>
    <message>
        <source>Fit the current frame to see the methods side by side.</source>
        <translation>拟合当前帧即可并排查看各方法。</translation>
    </message>
    <message>
        <source>There is no reference to measure the error against.</source>
        <translation>没有可用于衡量误差的参照。</translation>
    </message>
    <message>
        <source>%1 (frame %2 from frame %3 is being fitted)</source>
        <translation>%1（正在从第 %3 帧拟合第 %2 帧）</translation>
    </message>
    <message>
        <source>All as it was fitted</source>
        <translation>全部恢复为拟合时的状态</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>假设分析：%1</translation>
    </message>
    <message>
        <source>other settings</source>
        <translation>其他设置</translation>
    </message>
    <message>
        <source>Iteration; %1</source>
        <translation>迭代；%1</translation>
    </message>
</context>
<context>
    <name>widgets::InspectProbe</name>
    <message>
        <source>the directions differ</source>
        <translation>方向不同</translation>
    </message>
    <message>
        <source>beyond the gate</source>
        <translation>超出门限</translation>
    </message>
    <message>
        <source>too far to count</source>
        <translation>太远，不计入</translation>
    </message>
    <message>
        <source>no outline in this bin</source>
        <translation>此方向区间内没有轮廓</translation>
    </message>
    <message>
        <source>beyond the end of the hand</source>
        <translation>超出手部末端</translation>
    </message>
</context>
<context>
    <name>widgets::InspectProbeCard</name>
    <message>
        <source>Take the pin away (or click the point once more)</source>
        <translation>取消固定（或再次单击该点）</translation>
    </message>
    <message>
        <source>Take the pin away</source>
        <translation>取消固定</translation>
    </message>
    <message>
        <source>%1 %2, direction %3</source>
        <translation>%1 %2，方向 %3</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Nearest, px</source>
        <translation>最近点，px</translation>
    </message>
    <message>
        <source>Distance, px</source>
        <translation>距离，px</translation>
    </message>
    <message>
        <source>Cost, px</source>
        <translation>代价，px</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>匹配</translation>
    </message>
    <message>
        <source>(%1, %2)</source>
        <comment>x and y; told apart where the decimal point is a comma, too</comment>
        <translation>(%1, %2)</translation>
    </message>
    <message>
        <source>What each method would take for the rim point of the pinned view, which looks in the direction above. The arrows of other columns start at rim points of their own, which may look elsewhere.</source>
        <translation>对于固定视图中朝向上述方向的轮廓点，每种方法会取哪个点。其他列的箭头从各自的轮廓点出发，其朝向可能不同。</translation>
    </message>
</context>
<context>
    <name>widgets::JointErrorDiagram</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mean error per joint</source>
        <translation>各关节平均误差</translation>
    </message>
</context>
<context>
    <name>widgets::JointTableModel</name>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>partial</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>none</source>
        <comment>state of a joint without marks</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Joint, in the order in which you work</source>
        <translation>关节，按您的标注顺序排列</translation>
    </message>
    <message>
        <source>Root mean square distance from click to reprojection, over the views used</source>
        <translation>所用视图中点击与重投影之间的均方根距离</translation>
    </message>
    <message>
        <source>Uncertainty of the 3D joint (standard deviation)</source>
        <translation>3D 关节的不确定度（标准差）</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>不良</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Proposed marks with a likelihood of %1 to %2</source>
        <translation>建议的标记，可能性 %1 至 %2</translation>
    </message>
    <message>
        <source>Views that you clicked + views that you accepted</source>
        <translation>您点击的视图 + 您接受的视图</translation>
    </message>
    <message>
        <source>Done: every view with a picture is placed or cannot be placed; bad: error above the threshold, an outlier, or no 3D point</source>
        <translation>完成：每个有图像的视图均已放置或无法放置；不良：误差超过阈值、离群或无三维点</translation>
    </message>
</context>
<context>
    <name>widgets::MarkLegend</name>
    <message>
        <source>clicked: the 3D joint follows from these</source>
        <translation>点击：三维关节由此得出</translation>
    </message>
    <message>
        <source>accepted as it was placed for you</source>
        <translation>接受预先放置的位置</translation>
    </message>
    <message>
        <source>occluded, estimated</source>
        <translation>遮挡，估计位置</translation>
    </message>
    <message>
        <source>contradicts the other views</source>
        <translation>与其他视图矛盾</translation>
    </message>
    <message>
        <source>square: right hand; round: left hand</source>
        <translation>方形：右手；圆形：左手</translation>
    </message>
    <message>
        <source>What the marks mean</source>
        <translation>标记的含义</translation>
    </message>
    <message>
        <source>proposed: not a label until it is accepted</source>
        <translation>建议：接受后才算标注</translation>
    </message>
</context>
<context>
    <name>widgets::MarkPresenter</name>
    <message>
        <source>%1%2 frames</source>
        <translation>%1%2 帧</translation>
    </message>
    <message>
        <source>cannot be placed</source>
        <translation>无法放置</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>无图像</translation>
    </message>
    <message>
        <source>off %1&apos;s curve</source>
        <translation>偏离 %1 的曲线</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>click here next</source>
        <translation>下一步点击此处</translation>
    </message>
</context>
<context>
    <name>widgets::MaskAttacher</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>请先打开数据集。</translation>
    </message>
</context>
<context>
    <name>widgets::MatchLook</name>
    <message>
        <source>thumb</source>
        <translation>拇指</translation>
    </message>
    <message>
        <source>index</source>
        <translation>食指</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中指</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>无名指</translation>
    </message>
    <message>
        <source>little</source>
        <translation>小指</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>手掌</translation>
    </message>
    <message>
        <source>All, by distance</source>
        <translation>全部，按距离</translation>
    </message>
    <message>
        <source>All, by finger</source>
        <translation>全部，按手指</translation>
    </message>
    <message>
        <source>Only: %1</source>
        <translation>仅：%1</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>widgets::MethodForm</name>
    <message>
        <source>More options</source>
        <translation>更多选项</translation>
    </message>
    <message>
        <source>The options that are seldom changed</source>
        <translation>很少更改的选项</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>常用值</translation>
    </message>
</context>
<context>
    <name>widgets::MethodText</name>
    <message>
        <source>A match is kept if the directions differ by less, degrees</source>
        <translation>方向之差小于此值时保留匹配，度</translation>
    </message>
    <message>
        <source>Directions over 360 degrees; off: lines over 180 degrees</source>
        <translation>方向按 360 度计；关闭：直线按 180 度计</translation>
    </message>
    <message>
        <source>Weight of the direction, pixels per radian</source>
        <translation>方向的权重，每弧度像素数</translation>
    </message>
    <message>
        <source>Bins of direction</source>
        <translation>方向区间数</translation>
    </message>
    <message>
        <source>Where the bins are centred: 0 on the x axis, or that share of a bin beside it</source>
        <translation>区间的中心：0 为在 x 轴上，否则偏移区间宽度的此比例</translation>
    </message>
    <message>
        <source>The two matches weigh by how near their bins are</source>
        <translation>两个匹配按其区间的远近加权</translation>
    </message>
    <message>
        <source>How matches are searched: both find the same ones</source>
        <translation>匹配的搜索方式：两种方式所得匹配相同</translation>
    </message>
    <message>
        <source>The real-time variant</source>
        <translation>实时变体</translation>
    </message>
    <message>
        <source>The palm is placed before the fingers move</source>
        <translation>先放置手掌，再移动手指</translation>
    </message>
    <message>
        <source>Coarse levels of the mesh first</source>
        <translation>先使用网格的粗略层级</translation>
    </message>
    <message>
        <source>Tau narrows from 45 degrees to 22.5</source>
        <translation>tau 由 45 度收窄至 22.5 度</translation>
    </message>
    <message>
        <source>The distance along the outline counts a tenth</source>
        <translation>沿轮廓线的距离按十分之一计</translation>
    </message>
    <message>
        <source>A weak pull of the angles to those of the start</source>
        <translation>将角度轻微拉向起始角度</translation>
    </message>
    <message>
        <source>The pull knows how fingers move together</source>
        <translation>该拉力考虑手指的联动方式</translation>
    </message>
    <message>
        <source>Other starts where silhouettes are left unexplained</source>
        <translation>轮廓仍有未解释之处时，尝试其他起始姿态</translation>
    </message>
    <message>
        <source>The last iterations on the full mesh</source>
        <translation>最后几次迭代使用完整网格</translation>
    </message>
    <message>
        <source>What counts as a difference follows the noise of the outlines</source>
        <translation>差异的判定随轮廓线的噪声而定</translation>
    </message>
    <message>
        <source>Contour points pull the model, too</source>
        <translation>轮廓点也拉动模型</translation>
    </message>
    <message>
        <source>Only contour points within tau are searched</source>
        <translation>仅搜索 tau 范围内的轮廓点</translation>
    </message>
    <message>
        <source>Cauchy weights with that scale, mm; 0 for none</source>
        <translation>以此为尺度的 Cauchy 权重，mm；0 为不使用</translation>
    </message>
    <message>
        <source>Longest distance of a match, pixels; 0 for the usual one</source>
        <translation>匹配的最大距离，像素；0 为常用值</translation>
    </message>
    <message>
        <source>K of the truncated penalty, square pixels; 0 for none</source>
        <translation>截断罚函数的 K，平方像素；0 为不使用</translation>
    </message>
    <message>
        <source>How far the outline&apos;s polygon may be off, pixels</source>
        <translation>轮廓线多边形允许的偏差，像素</translation>
    </message>
    <message>
        <source>The outline&apos;s direction from its polygon or from a chord</source>
        <translation>轮廓线的方向取自其多边形或弦</translation>
    </message>
    <message>
        <source>Contour beyond the end of a hand model: left out, or as any other</source>
        <translation>手部模型末端以外的轮廓线：略去，或与其他部分同样处理</translation>
    </message>
    <message>
        <source>Most iterations of a fit</source>
        <translation>一次拟合的最多迭代次数</translation>
    </message>
    <message>
        <source>Damping relative to the diagonal of the normal matrix</source>
        <translation>相对于法方程矩阵对角线的阻尼</translation>
    </message>
    <message>
        <source>rigid: a first phase moves each hand as a whole; paper: all at once</source>
        <translation>rigid：第一阶段整体移动每只手；paper：一次全部进行</translation>
    </message>
    <message>
        <source>%1 must be %2 or %3, not &quot;%4&quot;.</source>
        <translation>%1 必须是 %2 或 %3，而不是“%4”。</translation>
    </message>
    <message>
        <source>%1 must be a whole number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1 必须是 %2 至 %3 的整数，而不是“%4”。</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1 必须是 %2 至 %3 的数字，而不是“%4”。</translation>
    </message>
    <message>
        <source>Write &quot;%1&quot; as name=value.</source>
        <translation>请将“%1”写成 name=value 的形式。</translation>
    </message>
    <message>
        <source>%1 has no option &quot;%2&quot;; it has %3.</source>
        <translation>%1 没有选项“%2”；它有 %3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a method; the methods are %2.</source>
        <translation>“%1”不是方法；可用的方法为 %2。</translation>
    </message>
    <message>
        <source>Fingers and hands do not penetrate each other on the way from other starts</source>
        <translation>从其他起始姿态出发时，手指和双手不会互相穿透</translation>
    </message>
</context>
<context>
    <name>widgets::NameBar</name>
    <message>
        <source>Use this name</source>
        <translation>使用此姓名</translation>
    </message>
    <message>
        <source>Your marks are kept under your &amp;name:</source>
        <translation>保存标记所用的姓名(&amp;N)：</translation>
    </message>
</context>
<context>
    <name>widgets::NoteEdit</name>
    <message>
        <source>Note on this frame</source>
        <translation>本帧备注</translation>
    </message>
</context>
<context>
    <name>widgets::OtherMarks</name>
    <message>
        <source>%1 has %2 in %3 of this sequence.</source>
        <translation>%1 在此序列的 %3 中有 %2。</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s)</source>
        <translation>
            <numerusform>%n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n 帧</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::PairFilterText</name>
    <message>
        <source>“%1” is neither a method of these results nor sequence, start, test, difference or initial.</source>
        <translation>“%1”既不是这些结果中的方法，也不是 sequence、start、test、difference 或 initial。</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数字。</translation>
    </message>
    <message>
        <source>“%1” is neither a comparison such as A-B&gt;1 nor a sequence.</source>
        <translation>“%1”既不是 A-B&gt;1 这样的比较，也不是序列。</translation>
    </message>
    <message>
        <source>Conditions with blanks between them, all of which must hold: A-B&gt;1 difference&gt;=10 sequence=01. A and B are the methods chosen on the left; a method&apos;s name is its error in mm, .seconds or .iterations behind it what it took; start, test and difference are frames, initial is the error of the start pose.</source>
        <translation>以空格分隔的条件，须全部满足：A-B&gt;1 difference&gt;=10 sequence=01。A 和 B 为左侧所选的方法；方法名称表示其误差 (mm)，后加 .seconds 或 .iterations 表示其耗时或迭代次数；start、test 和 difference 为帧数，initial 为起始姿态的误差。</translation>
    </message>
</context>
<context>
    <name>widgets::PairTableModel</name>
    <message>
        <source>Sequence</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Start mm</source>
        <translation>起始 mm</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>相隔</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>A − B mm</source>
        <translation>A − B mm</translation>
    </message>
    <message>
        <source>%1 iterations</source>
        <translation>%1 迭代次数</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Frames between start and test</source>
        <translation>起始帧与测试帧之间的帧数</translation>
    </message>
    <message>
        <source>Mean joint error of the start pose</source>
        <translation>起始姿态的平均关节误差</translation>
    </message>
    <message>
        <source>Mean joint error of %1; the smallest of a row is bold</source>
        <translation>%1 的平均关节误差；每行最小者为粗体</translation>
    </message>
    <message>
        <source>Error of %1 minus error of %2: above 0 where %1 is worse</source>
        <translation>%1 的误差减去 %2 的误差：大于 0 表示 %1 较差</translation>
    </message>
</context>
<context>
    <name>widgets::PictureExport</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG 矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose a folder that you may write to.</source>
        <translation>无法写入 %1。请选择您有写入权限的文件夹。</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>保存图片...</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>图像已复制到剪贴板。</translation>
    </message>
    <message>
        <source>PDF page (*.pdf)</source>
        <translation>PDF 页面 (*.pdf)</translation>
    </message>
</context>
<context>
    <name>widgets::PlotCanvas</name>
    <message>
        <source>curves</source>
        <translation>曲线</translation>
    </message>
</context>
<context>
    <name>widgets::QualityPanel</name>
    <message>
        <source>Bad above</source>
        <translation>问题阈值</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>This frame</source>
        <translation>本帧</translation>
    </message>
    <message>
        <source>Whole sequence</source>
        <translation>整个序列</translation>
    </message>
    <message>
        <source>Nothing stands out in this sequence.</source>
        <translation>此序列中没有异常。</translation>
    </message>
    <message>
        <source>Nothing stands out in this frame.</source>
        <translation>此帧中没有异常。</translation>
    </message>
    <message>
        <source>No frame of this sequence has marks yet.</source>
        <translation>此序列中还没有带标记的帧。</translation>
    </message>
    <message>
        <source>Joints: %1 done, %2 partial, %3 bad.</source>
        <translation>关节：%1 个完成，%2 个部分完成，%3 个有问题。</translation>
    </message>
    <message>
        <source>Your clicks scatter by %1 px per axis.</source>
        <translation>您的点击在每个轴上的离散度为 %1 px。</translation>
    </message>
    <message>
        <source>Where to look for findings</source>
        <translation>在何处查找问题</translation>
    </message>
    <message>
        <source>No frame has marks of yours (%1) yet.</source>
        <translation>还没有帧有您 (%1) 的标记。</translation>
    </message>
    <message numerus="yes">
        <source>%n proposed mark(s) wait to be checked.</source>
        <translation>
            <numerusform>%n 个建议的标记等待检查。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with marks of %1.</source>
        <translation>
            <numerusform>%n 帧有 %1 的标记。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Too few clicks to know how far yours scatter: 1 px is assumed.</source>
        <translation>您的点击太少，离散度未知：假定为 1 px。</translation>
    </message>
</context>
<context>
    <name>widgets::RatersPanel</name>
    <message>
        <source>No two raters have marked the same joint. Start a repeat round to see how far you agree with yourself.</source>
        <translation>没有两位标注者标记过同一关节。请开始重复标注，以查看您与自身的一致程度。</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Compares all raters as they stand now</source>
        <translation>按当前状态比较所有标注者</translation>
    </message>
    <message numerus="yes">
        <source>%n shared click(s), %1 px apart (RMS)</source>
        <translation>
            <numerusform>%n 次共同点击，相距 %1 px（RMS）</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 scatters by %2 px per axis</source>
        <translation>%1 在每个轴上的离散度为 %2 px</translation>
    </message>
    <message>
        <source>End the round</source>
        <translation>结束本轮</translation>
    </message>
    <message>
        <source>Start a repeat round</source>
        <translation>开始重复标注</translation>
    </message>
    <message>
        <source>Back to your own marks; both rounds are compared</source>
        <translation>返回您自己的标记，并比较两轮结果</translation>
    </message>
    <message>
        <source>Repeat round: %1 of %2 joints are left.</source>
        <translation>重复标注：%2 个关节中还剩 %1 个。</translation>
    </message>
    <message numerus="yes">
        <source>All raters together: %1 ± %2 mm, from %n click(s).</source>
        <translation>
            <numerusform>所有标注者合计：%1 ± %2 mm，来自 %n 次点击。</numerusform>
        </translation>
    </message>
    <message>
        <source>Your 3D joint lies %1 mm from it.</source>
        <translation>您的三维关节与之相距 %1 mm。</translation>
    </message>
    <message>
        <source>A random tenth of your finished joints, your first marks hidden: how well do you repeat yourself?</source>
        <translation>随机抽取您已完成关节的十分之一，隐藏第一次的标记：看看您的重复性如何</translation>
    </message>
    <message>
        <source>To the next joint of the round that is not marked yet</source>
        <translation>转到本轮中下一个尚未标记的关节</translation>
    </message>
    <message>
        <source>Your first marks are hidden until the round has ended.</source>
        <translation>在本轮结束之前，您第一次的标记处于隐藏状态。</translation>
    </message>
    <message>
        <source>%1 has too few clicks to know how far they scatter</source>
        <translation>%1 的点击太少，离散度未知</translation>
    </message>
</context>
<context>
    <name>widgets::RefinementModel</name>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>点击</translation>
    </message>
    <message>
        <source>px before</source>
        <translation>优化前 px</translation>
    </message>
    <message>
        <source>px after</source>
        <translation>优化后 px</translation>
    </message>
    <message>
        <source>turned, °</source>
        <translation>旋转，°</translation>
    </message>
    <message>
        <source>moved, mm</source>
        <translation>移动，mm</translation>
    </message>
    <message>
        <source>focal, %</source>
        <translation>焦距，%</translation>
    </message>
    <message>
        <source>RMS of its clicks with the calibration in use</source>
        <translation>使用当前标定时其点击的 RMS</translation>
    </message>
    <message>
        <source>RMS of its clicks with the refined calibration</source>
        <translation>使用优化后的标定时其点击的 RMS</translation>
    </message>
    <message>
        <source>By how much the camera turns</source>
        <translation>相机的旋转量</translation>
    </message>
    <message>
        <source>By how much the camera&apos;s centre moves</source>
        <translation>相机中心的移动量</translation>
    </message>
    <message>
        <source>By how much its focal length grows</source>
        <translation>其焦距的增大量</translation>
    </message>
</context>
<context>
    <name>widgets::RefinementPage</name>
    <message>
        <source>Refine</source>
        <translation>优化</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Use the refined calibration</source>
        <translation>使用优化后的标定</translation>
    </message>
    <message>
        <source>Use the chosen one</source>
        <translation>使用所选标定</translation>
    </message>
    <message>
        <source>Adjusts every camera&apos;s place, direction, focal length and first lens coefficients to all clicks of the dataset</source>
        <translation>按数据集的所有点击调整每台相机的位置、方向、焦距和前几个镜头系数</translation>
    </message>
    <message>
        <source>Writes a new calibration file beside the one in use, which is kept; all joints are reconstructed anew</source>
        <translation>在当前标定文件旁写入新文件，原文件保留；所有关节重新重建</translation>
    </message>
    <message>
        <source>The dataset uses that calibration from now on; marks stay as they are</source>
        <translation>数据集从现在起使用该标定；标记保持不变</translation>
    </message>
    <message>
        <source>Calibrations of this dataset</source>
        <translation>此数据集的标定</translation>
    </message>
    <message>
        <source>Refine the calibration first.</source>
        <translation>请先优化标定。</translation>
    </message>
    <message>
        <source>The clicks of all sequences are being looked at.</source>
        <translation>正在检查所有序列的点击。</translation>
    </message>
    <message>
        <source>Refined from %1 joints in %2 frames. A click scatters by %3 px per axis about the refined cameras.</source>
        <translation>由 %2 帧中的 %1 个关节优化得出。点击相对优化后的相机在每个轴上的离散度为 %3 px。</translation>
    </message>
    <message numerus="yes">
        <source>%n wrong click(s) took no part.</source>
        <translation>
            <numerusform>%n 次错误点击未参与计算。</numerusform>
        </translation>
    </message>
    <message>
        <source>The adjustment stopped before it had settled.</source>
        <translation>调整在收敛之前已停止。</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1（使用中）</translation>
    </message>
    <message>
        <source>Distances and shapes will be as good as the clicks; the world as a whole stays where it was, known to %1 mm.</source>
        <translation>距离和形状的精度将与点击相当；世界坐标系整体保持原位，精度为 %1 mm。</translation>
    </message>
</context>
<context>
    <name>widgets::ResultTableModel</name>
    <message>
        <source>Converged</source>
        <translation>已收敛</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>达到最大迭代次数</translation>
    </message>
    <message>
        <source>No matches were left</source>
        <translation>已无剩余匹配</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Start mm</source>
        <translation>起始 mm</translation>
    </message>
    <message>
        <source>Error mm</source>
        <translation>误差 mm</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代次数</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewModel</name>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Doubt, %</source>
        <translation>存疑度，%</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>邻近</translation>
    </message>
    <message>
        <source>Why the frame deserves a look</source>
        <translation>此帧值得审核的原因</translation>
    </message>
    <message>
        <source>0: sure, 100: lost; of the more doubtful hand</source>
        <translation>0：确定，100：丢失；取较存疑的手</translation>
    </message>
    <message>
        <source>Doubtful frames around that a corrected one helps</source>
        <translation>修正此帧可改善的邻近存疑帧</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewPanel</name>
    <message>
        <source>Accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>First pass...</source>
        <translation>自动初标...</translation>
    </message>
    <message>
        <source>No frame waits for a look.</source>
        <translation>没有等待审核的帧。</translation>
    </message>
    <message>
        <source>Frames that the first pass has labelled wait here for a look, doubtful ones first.</source>
        <translation>自动初标已标注的帧在此等待审核，存疑的在前。</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewText</name>
    <message>
        <source>quite sure; left hand first</source>
        <translation>相当确定；先看左手</translation>
    </message>
    <message>
        <source>quite sure; right hand first</source>
        <translation>相当确定；先看右手</translation>
    </message>
    <message>
        <source>views do not agree on the left hand</source>
        <translation>各视图的左手不一致</translation>
    </message>
    <message>
        <source>views do not agree on the right hand</source>
        <translation>各视图的右手不一致</translation>
    </message>
    <message>
        <source>%1: its bone is %2 % longer than usual</source>
        <translation>%1：其骨骼比通常长 %2 %</translation>
    </message>
    <message>
        <source>%1: its bone is %2 % shorter than usual</source>
        <translation>%1：其骨骼比通常短 %2 %</translation>
    </message>
    <message>
        <source>the left hand was not found</source>
        <translation>未找到左手</translation>
    </message>
    <message>
        <source>the right hand was not found</source>
        <translation>未找到右手</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the left hand missing</source>
        <translation>
            <numerusform>左手缺少 %n 个关节</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the right hand missing</source>
        <translation>
            <numerusform>右手缺少 %n 个关节</numerusform>
        </translation>
    </message>
    <message>
        <source>the left hand jumps by %1 mm</source>
        <translation>左手跳动 %1 mm</translation>
    </message>
    <message>
        <source>the right hand jumps by %1 mm</source>
        <translation>右手跳动 %1 mm</translation>
    </message>
    <message>
        <source>First pass, detecting: %1 of %2</source>
        <translation>自动初标，检测：%1 / %2</translation>
    </message>
    <message>
        <source>First pass, measuring hands: %1 of %2</source>
        <translation>自动初标，测量双手：%1 / %2</translation>
    </message>
    <message>
        <source>First pass, fitting: %1 of %2</source>
        <translation>自动初标，拟合：%1 / %2</translation>
    </message>
    <message>
        <source>First pass, tracking: %1 of %2</source>
        <translation>自动初标，跟踪：%1 / %2</translation>
    </message>
    <message numerus="yes">
        <source>All %n frame(s) are reviewed.</source>
        <translation>
            <numerusform>全部 %n 帧均已审核。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) left, </source>
        <translation>
            <numerusform>剩余 %n 帧， </numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of them doubtful; %2 reviewed.</source>
        <translation>其中 %1 帧存疑；已审核 %2 帧。</translation>
    </message>
    <message>
        <source>Error to be expected of those left: %1 mm a joint, as far as reviewed ones tell.</source>
        <translation>据已审核的帧推断，剩余帧的预期误差为每个关节 %1 mm。</translation>
    </message>
    <message>
        <source>The error of those left is known once three frames are reviewed.</source>
        <translation>审核三帧后即可得知剩余帧的误差。</translation>
    </message>
    <message>
        <source>The error of those left is not known until a joint was corrected.</source>
        <translation>在更正某个关节之前，其余帧的误差未知。</translation>
    </message>
</context>
<context>
    <name>widgets::RigDrawing</name>
    <message>
        <source>The cameras of the calibration, and where they look. Drag to turn, wheel to zoom.</source>
        <translation>标定中的相机及其朝向。拖动旋转，滚轮缩放。</translation>
    </message>
    <message>
        <source>The cameras appear here once the calibration is read.</source>
        <translation>读取标定文件后，相机将显示在此处。</translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthModel</name>
    <message numerus="yes">
        <source>%1: %n click(s) that other cameras confirm are too few to judge it</source>
        <translation>
            <numerusform>%1：经其他相机证实的点击仅 %n 次，不足以判断</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: mean %2, %3 ± %4 px; clicks scatter by %5 px about it; %n wrong click(s)</source>
        <translation>
            <numerusform>%1：均值 %2, %3 ± %4 px；点击围绕其离散度 %5 px；%n 次错误点击</numerusform>
        </translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>Clicks that other cameras confirm</source>
        <translation>经其他相机证实的点击</translation>
    </message>
    <message>
        <source>RMS residual, px</source>
        <translation>RMS 残差，px</translation>
    </message>
    <message>
        <source>Mean residual to the right, px; the joint is made from the other cameras</source>
        <translation>向右的平均残差，px；关节由其他相机得出</translation>
    </message>
    <message>
        <source>Mean residual downwards, px; the joint is made from the other cameras</source>
        <translation>向下的平均残差，px；关节由其他相机得出</translation>
    </message>
    <message>
        <source>Clicks and calibration error together, per axis, px: what a click is worth</source>
        <translation>点击误差与标定误差合计，每个轴，px：即一次点击的精度</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Two cameras cannot tell which of them is off.</source>
        <translation>两台相机无法判断是哪一台有偏差。</translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthView</name>
    <message>
        <source>Refine calibration...</source>
        <translation>优化标定...</translation>
    </message>
    <message>
        <source>Adjusts the cameras to the clicks; nothing changes before you use the result</source>
        <translation>按点击调整相机；在您使用结果之前不会有任何更改</translation>
    </message>
    <message>
        <source>The clicks of all sequences are being looked at.</source>
        <translation>正在检查所有序列的点击。</translation>
    </message>
    <message>
        <source>No joint is clicked in two cameras yet: the calibration cannot be judged.</source>
        <translation>还没有关节在两台相机中被点击：无法判断标定质量。</translation>
    </message>
    <message>
        <source>There are too few clicks to judge the calibration.</source>
        <translation>点击太少，无法判断标定质量。</translation>
    </message>
</context>
<context>
    <name>widgets::RigText</name>
    <message>
        <source>%1 of %2 cameras are %3 to %4 px off in every frame: the calibration as a whole does not fit the clicks.</source>
        <translation>%2 台相机中有 %1 台在每一帧都偏离 %3 至 %4 px：整体标定与点击不符。</translation>
    </message>
    <message numerus="yes">
        <source>%1 is %2 px off in the %n sequence(s) %3 only: it stood otherwise there.</source>
        <translation>
            <numerusform>%1 仅在 %n 个序列 (%3) 中偏离 %2 px：当时它的摆放不同。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is %2 frames behind the others: its residuals go with the joints&apos; motion.</source>
        <translation>%1 比其他相机滞后 %2 帧：其残差随关节运动而变。</translation>
    </message>
    <message>
        <source>%1 is %2 frames ahead of the others: its residuals go with the joints&apos; motion.</source>
        <translation>%1 比其他相机超前 %2 帧：其残差随关节运动而变。</translation>
    </message>
    <message>
        <source>%1 is %2 px off in every frame: its calibration moved.</source>
        <translation>%1 在每一帧都偏离 %2 px：其标定已发生偏移。</translation>
    </message>
    <message>
        <source>%1 moved before frame %2 of sequence %3: its picture lies %4 px elsewhere from there on.</source>
        <translation>%1 在序列 %3 的第 %2 帧之前移动过：此后其图像偏移 %4 px。</translation>
    </message>
    <message>
        <source>%1 drifts by %2 px in 100 frames of sequence %3.</source>
        <translation>%1 在序列 %3 中每 100 帧漂移 %2 px。</translation>
    </message>
    <message>
        <source>Clicks of %1: too few to know how far they scatter; 1 px is assumed.</source>
        <translation>%1 的点击太少，离散度未知；假定为 1 px。</translation>
    </message>
    <message>
        <source>Clicks of %1 scatter by %2 px per axis (%3 to %4 by camera).</source>
        <translation>%1 的点击在每个轴上的离散度为 %2 px（各相机 %3 至 %4）。</translation>
    </message>
    <message>
        <source>Too few clicks that other cameras confirm: %1.</source>
        <translation>经其他相机证实的点击太少：%1。</translation>
    </message>
    <message>
        <source>The calibration&apos;s own error adds %1 to %2 px.</source>
        <translation>标定本身的误差另加 %1 至 %2 px。</translation>
    </message>
    <message>
        <source>too few clicks</source>
        <translation>点击太少</translation>
    </message>
    <message>
        <source>off</source>
        <translation>偏离</translation>
    </message>
    <message>
        <source>partly off</source>
        <translation>部分偏离</translation>
    </message>
    <message>
        <source>late</source>
        <translation>滞后</translation>
    </message>
    <message>
        <source>early</source>
        <translation>超前</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>移动过</translation>
    </message>
    <message>
        <source>drifts</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>吻合</translation>
    </message>
    <message>
        <source>Cameras can be refined from %1 joints on that three cameras or more have clicked (%2 so far).</source>
        <translation>至少有 %1 个关节在三台或更多相机中被点击时，才能优化相机（目前 %2 个）。</translation>
    </message>
    <message>
        <source>The calibration fits the clicks.</source>
        <translation>标定与点击吻合。</translation>
    </message>
    <message>
        <source>Refining is worth it from %1 frames and %2 joints on (%3 and %4 so far).</source>
        <translation>达到 %1 帧和 %2 个关节后才值得优化（目前 %3 和 %4）。</translation>
    </message>
    <message>
        <source>There are enough clicks to refine the calibration.</source>
        <translation>点击已足够，可优化标定。</translation>
    </message>
    <message>
        <source>Two cameras cannot tell which of them is off: a refinement needs three.</source>
        <translation>两台相机无法判断哪一台偏离：优化需要三台。</translation>
    </message>
</context>
<context>
    <name>widgets::ScatterPlot</name>
    <message>
        <source>Logarithmic axes</source>
        <translation>对数坐标轴</translation>
    </message>
</context>
<context>
    <name>widgets::ScenePanel</name>
    <message>
        <source>Whose pose stands in the scene</source>
        <translation>场景中显示谁的姿态</translation>
    </message>
    <message>
        <source>Recorded pose</source>
        <translation>记录的姿态</translation>
    </message>
</context>
<context>
    <name>widgets::SceneView</name>
    <message>
        <source>The 3D scene needs OpenGL, which this display does not have.</source>
        <translation>3D 场景需要 OpenGL，但此显示环境不支持。</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>重置视图</translation>
    </message>
    <message>
        <source>Look through</source>
        <translation>从相机观察</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>场景</translation>
    </message>
</context>
<context>
    <name>widgets::SilhouettePage</name>
    <message>
        <source>Around the joints</source>
        <translation>关节周围</translation>
    </message>
    <message>
        <source>Around the posed hand model</source>
        <translation>手部模型姿态周围</translation>
    </message>
    <message>
        <source>What differs from the empty room</source>
        <translation>与空房间不同之处</translation>
    </message>
    <message>
        <source>What has not the backdrop&apos;s colour</source>
        <translation>与背景幕布颜色不同之处</translation>
    </message>
    <message>
        <source>What has the colour of skin</source>
        <translation>具有肤色之处</translation>
    </message>
    <message>
        <source>Give them to this sequence</source>
        <translation>用于此序列</translation>
    </message>
    <message>
        <source>Make silhouettes</source>
        <translation>生成轮廓</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>By how much the pose may be wrong: that far from the model the picture decides</source>
        <translation>姿态允许的误差：在模型周围此距离内由图像决定</translation>
    </message>
    <message>
        <source>How much of the forearm is kept, in lengths of the palm from the wrist</source>
        <translation>保留多少前臂，从手腕起以手掌长度计</translation>
    </message>
    <message>
        <source>Poses are fitted to them then</source>
        <translation>姿态随后将拟合到这些轮廓</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>查找方式</translation>
    </message>
    <message>
        <source>Pose may be off by</source>
        <translation>姿态允许偏差</translation>
    </message>
    <message>
        <source>Forearm, in palms</source>
        <translation>前臂（掌长）</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>In the views: the left button adds to the silhouette, the right one (or Shift) takes away; Ctrl and the wheel change the size</source>
        <translation>在视图中：左键添加到轮廓，右键（或 Shift）去除；Ctrl 加滚轮更改大小</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Radius of the brush, pixels of the picture</source>
        <translation>画笔半径，以图像像素计</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>every</source>
        <translation>间隔</translation>
    </message>
    <message numerus="yes">
        <source>%n silhouette(s) made, %1 were there already.</source>
        <translation>
            <numerusform>已生成 %n 个轮廓，%1 个原已存在。</numerusform>
        </translation>
    </message>
    <message>
        <source>The sequence uses them now.</source>
        <translation>序列现在使用这些轮廓。</translation>
    </message>
    <message numerus="yes">
        <source>This frame: a silhouette in %n view(s)</source>
        <translation>
            <numerusform>本帧：%n 个视图中有轮廓</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them kept on disk</source>
        <translation>
            <numerusform>，其中 %n 个已保存到磁盘</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for silhouettes. Nothing appears where no joints of the frame are known: annotate some, or choose another way.</source>
        <translation>正在查找轮廓。若本帧没有已知关节，则不会显示：请标注若干关节，或选择其他方式。</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>重做：%1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>This sequence has masks already (%1). They stay on disk.</source>
        <translation>此序列已有掩膜 (%1)。它们会留在磁盘上。</translation>
    </message>
    <message>
        <source>Use the new ones instead</source>
        <translation>改用新的</translation>
    </message>
    <message>
        <source>Make them only</source>
        <translation>仅生成</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The last frame lies before the first one.</source>
        <translation>最后一帧在第一帧之前。</translation>
    </message>
</context>
<context>
    <name>widgets::SilhouetteStudy</name>
    <message>
        <source>touch up %1</source>
        <translation>修整 %1</translation>
    </message>
</context>
<context>
    <name>widgets::StatusLine</name>
    <message numerus="yes">
        <source>saved %n s ago</source>
        <translation>
            <numerusform>%n 秒前已保存</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n min ago</source>
        <translation>
            <numerusform>%n 分钟前已保存</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n h ago</source>
        <translation>
            <numerusform>%n 小时前已保存</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>NOT SAVED</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message numerus="yes">
        <source>, %n s left</source>
        <translation>
            <numerusform>，剩余 %n 秒</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n min left</source>
        <translation>
            <numerusform>，剩余 %n 分钟</numerusform>
        </translation>
    </message>
    <message>
        <source>saving, %1 %</source>
        <translation>正在保存，%1 %</translation>
    </message>
</context>
<context>
    <name>widgets::StoreText</name>
    <message>
        <source>opened for reading only</source>
        <translation>以只读方式打开</translation>
    </message>
    <message>
        <source>opened by another window</source>
        <translation>已在另一窗口中打开</translation>
    </message>
    <message>
        <source>opened by another window (%1)</source>
        <translation>已在另一窗口中打开 (%1)</translation>
    </message>
    <message>
        <source>the folder is read-only</source>
        <translation>文件夹为只读</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>文件为只读</translation>
    </message>
    <message>
        <source>This file system has no locks: make sure that no other window has %1 open.</source>
        <translation>此文件系统不支持文件锁：请确保没有其他窗口打开 %1。</translation>
    </message>
    <message>
        <source>No backup could be made: %1</source>
        <translation>无法创建备份：%1</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectModel</name>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>骨骼</translation>
    </message>
    <message>
        <source>Model, mm</source>
        <translation>模型，mm</translation>
    </message>
    <message>
        <source>Measured, mm</source>
        <translation>测量值，mm</translation>
    </message>
    <message>
        <source>Change, %</source>
        <translation>变化，%</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Standard deviation of the measured length</source>
        <translation>测得长度的标准差</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectPage</name>
    <message>
        <source>Use masks</source>
        <translation>使用掩膜</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Save as a new dataset...</source>
        <translation>另存为新数据集...</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>已保存到 %1。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Evenly drawn from the annotated ones; more than 15 bring little and take long</source>
        <translation>从已标注帧中均匀抽取；超过 15 帧收益甚微且耗时</translation>
    </message>
    <message>
        <source>Outlines tell the girth; joints alone leave it as the model has it</source>
        <translation>轮廓可确定粗细；仅有关节时沿用模型的粗细</translation>
    </message>
    <message>
        <source>A dataset with these hands; footage and masks stay where they are, annotations and motion are copied</source>
        <translation>使用这双手的数据集；素材和掩膜留在原处，标注和运动会被复制</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Frames at most</source>
        <translation>最多帧数</translation>
    </message>
    <message>
        <source>Choose a sequence with annotated frames.</source>
        <translation>请选择有已标注帧的序列。</translation>
    </message>
    <message>
        <source>Bone lengths, scale and girth of this person&apos;s hands are found from annotated frames: at least %1, from 5 on every bone by itself.</source>
        <translation>由已标注帧得出此人双手的骨骼长度、比例和粗细：至少需 %1 帧，达到 5 帧时每根骨骼单独测量。</translation>
    </message>
    <message>
        <source>A new folder for the dataset</source>
        <translation>用于数据集的新文件夹</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectStudy</name>
    <message>
        <source>reading annotations</source>
        <translation>正在读取标注</translation>
    </message>
    <message>
        <source>reading masks</source>
        <translation>正在读取掩膜</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>正在测量</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectText</name>
    <message>
        <source>The calibration is not in mm: its unit is %1 mm. The cameras of the new dataset are in mm.</source>
        <translation>标定的单位不是 mm，而是 %1 mm。新数据集的相机以 mm 为单位。</translation>
    </message>
    <message>
        <source>The calibration is not in mm: its unit is %1 mm if this hand is as large as the model, so that scale says nothing. The cameras of the new dataset are in mm.</source>
        <translation>标定的单位不是 mm：若此手与模型一样大，则其单位为 %1 mm，因此比例没有意义。新数据集的相机以 mm 为单位。</translation>
    </message>
    <message>
        <source>%1 of %2 annotated frames were used, evenly drawn.</source>
        <translation>使用了 %2 个已标注帧中均匀抽取的 %1 个。</translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s) were used.</source>
        <translation>
            <numerusform>使用了 %n 个已标注帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than 3 frames: only the scale is measured.</source>
        <translation>少于 3 帧：仅测量比例。</translation>
    </message>
    <message numerus="yes">
        <source>Outlines of %n frame(s) fit to %1 mm.</source>
        <translation>
            <numerusform>%n 帧的轮廓吻合到 %1 mm。</numerusform>
        </translation>
    </message>
    <message>
        <source>No masks of frames in which all hands are annotated: the girth stays the model&apos;s.</source>
        <translation>所有手均已标注的帧没有掩膜：粗细沿用模型。</translation>
    </message>
    <message>
        <source>Left hand: scale %1 ± %2, girth %3 ± %4 mm; joints fit to %5 mm.</source>
        <translation>左手：比例 %1 ± %2，粗细 %3 ± %4 mm；关节吻合到 %5 mm。</translation>
    </message>
    <message>
        <source>Right hand: scale %1 ± %2, girth %3 ± %4 mm; joints fit to %5 mm.</source>
        <translation>右手：比例 %1 ± %2，粗细 %3 ± %4 mm；关节吻合到 %5 mm。</translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s)</source>
        <translation>
            <numerusform>%n 个已标注帧</numerusform>
        </translation>
    </message>
    <message>
        <source>masks</source>
        <translation>有掩膜</translation>
    </message>
    <message>
        <source>no masks</source>
        <translation>无掩膜</translation>
    </message>
    <message>
        <source>Fewer than 5 frames: bones keep the model&apos;s proportions.</source>
        <translation>少于 5 帧：骨骼保持模型的比例。</translation>
    </message>
    <message>
        <source>The calibration does not fit the clicks everywhere (Quality, Cameras): measure again after it is refined.</source>
        <translation>标定并非处处与点击吻合（质量、相机）：请在优化后重新测量。</translation>
    </message>
</context>
<context>
    <name>widgets::SummaryModel</name>
    <message>
        <source>start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Seconds per pair</source>
        <translation>每个帧对的秒数</translation>
    </message>
    <message>
        <source>Mean and standard deviation of the error, mm, by frames apart</source>
        <translation>按相隔帧数统计的误差均值和标准差，mm</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>All, mm</source>
        <translation>全部 (mm)</translation>
    </message>
    <message>
        <source>Pairs that are finished</source>
        <translation>已完成的配对</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>配对</translation>
    </message>
</context>
<context>
    <name>widgets::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>%1: %2 done, %3 partial, %4 bad, %5 occluded</source>
        <translation>%1手：%2 个完成，%3 个部分完成，%4 个有问题，%5 个遮挡</translation>
    </message>
    <message>
        <source>Marks of %1</source>
        <translation>%1 的标记</translation>
    </message>
    <message>
        <source>%1: proposed, doubt %2 %</source>
        <translation>%1手：建议，存疑度 %2 %</translation>
    </message>
</context>
<context>
    <name>widgets::TimelineLegend</name>
    <message>
        <source>Upper lane: left hand. Lower lane: right hand. The fuller a bar, the more joints have marks.</source>
        <translation>上栏：左手。下栏：右手。条越满，有标记的关节越多。</translation>
    </message>
    <message>
        <source>every joint is done</source>
        <translation>所有关节已完成</translation>
    </message>
    <message>
        <source>some joints have marks</source>
        <translation>部分关节有标记</translation>
    </message>
    <message>
        <source>a joint is bad: large error, outlier, or no 3D point</source>
        <translation>有关节不良：误差大、离群或无三维点</translation>
    </message>
    <message>
        <source>at its foot: a joint is occluded, its place estimated</source>
        <translation>底部：有关节被遮挡，位置为估计</translation>
    </message>
    <message>
        <source>between the lanes: marks of other people</source>
        <translation>两栏之间：其他人的标记</translation>
    </message>
    <message>
        <source>tick above: a note</source>
        <translation>上方刻线：备注</translation>
    </message>
    <message>
        <source>tick below: a test frame of the benchmark; the line: the current frame</source>
        <translation>下方刻线：基准测试的测试帧；竖线：当前帧</translation>
    </message>
    <message>
        <source>stripes: proposed by a program, waits for a look</source>
        <translation>条纹：由程序建议，等待审核</translation>
    </message>
    <message>
        <source>stripes: the same, and doubtful</source>
        <translation>条纹：同上，且存疑</translation>
    </message>
</context>
<context>
    <name>widgets::TrackerColumn</name>
    <message>
        <source>%1 has no estimate of frame %2 from frame %3</source>
        <translation>%1 没有由第 %3 帧得出的第 %2 帧的估计</translation>
    </message>
    <message>
        <source>%1 has fewer than three joints of a hand, or they lie on a line: that hand cannot be drawn.</source>
        <translation>%1 中有一只手的关节不足三个，或位于一条直线上：无法绘制该手。</translation>
    </message>
</context>
<context>
    <name>widgets::ViewPanel</name>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>着色</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>线框</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>对比度</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>伽马</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>所有视图</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Untick to hide a view; drag to change the order</source>
        <translation>取消勾选可隐藏视图，拖动可更改顺序</translation>
    </message>
</context>
<context>
    <name>widgets::WhatIfCase</name>
    <message>
        <source>only %1</source>
        <translation>仅用 %1</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>不用 %1</translation>
    </message>
    <message>
        <source>outlines with %1 px of noise (draw %2)</source>
        <translation>轮廓线噪声 %1 px（第 %2 次抽样）</translation>
    </message>
    <message>
        <source>%1 in the place of %2</source>
        <translation>%1 代替 %2</translation>
    </message>
    <message>
        <source>being fitted</source>
        <translation>正在拟合</translation>
    </message>
    <message>
        <source>%1 (being fitted)</source>
        <translation>%1（正在拟合）</translation>
    </message>
</context>
<context>
    <name>widgets::WhatIfPanel</name>
    <message>
        <source>Fit a pair: the settings of its methods can be changed here then.</source>
        <translation>请拟合一个配对：之后可在此处更改其方法的设置。</translation>
    </message>
    <message>
        <source>What does each camera add?</source>
        <translation>每台相机有何贡献？</translation>
    </message>
    <message>
        <source>Fits without each camera in turn: how much the error grows stands beside it</source>
        <translation>依次去掉每台相机进行拟合：旁边显示误差的增加量</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Gives the column these settings</source>
        <translation>将这些设置用于此列</translation>
    </message>
    <message>
        <source>Add as another column</source>
        <translation>添加为另一列</translation>
    </message>
    <message>
        <source>Keeps the column, and shows these settings beside it</source>
        <translation>保留此列，并在旁边显示这些设置</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>All as it was fitted</source>
        <translation>全部恢复为拟合时的状态</translation>
    </message>
    <message>
        <source>The error grows most without %1.</source>
        <translation>去掉 %1 时误差增加最多。</translation>
    </message>
    <message>
        <source>The column whose settings are changed</source>
        <translation>要更改设置的列</translation>
    </message>
    <message>
        <source>The method as on the command line; Enter takes it over</source>
        <translation>与命令行写法相同的方法；按 Enter 键采用</translation>
    </message>
    <message>
        <source>Method with its settings</source>
        <translation>方法及其设置</translation>
    </message>
    <message>
        <source>Noise of the outlines</source>
        <translation>轮廓线的噪声</translation>
    </message>
    <message>
        <source>What if the silhouettes were noisier? By how much their outlines move, pixels</source>
        <translation>若轮廓噪声更大会怎样？轮廓线的移动量，像素</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Cameras that take part</source>
        <translation>参与的相机</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Whether this camera&apos;s silhouette takes part</source>
        <translation>此相机的轮廓是否参与</translation>
    </message>
    <message>
        <source>Leave at least one camera on.</source>
        <translation>请至少保留一台相机。</translation>
    </message>
    <message>
        <source>Fitting...</source>
        <translation>正在拟合...</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Noise of the outlines, px</source>
        <translation>轮廓线的噪声，px</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>误差 (mm)</translation>
    </message>
    <message>
        <source>Drag a setting: the error over it appears here.</source>
        <translation>拖动一项设置：误差随其变化的曲线将显示在此处。</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1，原为 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Fitting without each camera...</source>
        <translation>正在依次去掉每台相机进行拟合...</translation>
    </message>
    <message>
        <source>Fits at a row of values of this parameter, for every column that has it, and fills the curve; once more stops</source>
        <translation>对具有该参数的每一列用一系列取值进行拟合并填充曲线；再按一次停止</translation>
    </message>
    <message>
        <source>%1: least error %2 mm at %3</source>
        <translation>%1：在 %3 处误差最小，为 %2 mm</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Sweep the noise</source>
        <translation>扫描噪声</translation>
    </message>
    <message>
        <source>Sweep the cameras</source>
        <translation>扫描相机</translation>
    </message>
    <message>
        <source>Sweep %1</source>
        <translation>扫描 %1</translation>
    </message>
    <message>
        <source>%1 of %2 fits</source>
        <translation>%1 / %2 次拟合</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>第 %1 次抽样</translation>
    </message>
    <message>
        <source>Of all points: %1</source>
        <translation>所有点：%1</translation>
    </message>
    <message>
        <source>Draw of the noise</source>
        <translation>噪声的抽样</translation>
    </message>
    <message>
        <source>Which draw of the noise: other wiggles of the same size. One draw alone may be luck.</source>
        <translation>噪声的第几次抽样：大小相同、形状不同的起伏。单次抽样可能只是巧合。</translation>
    </message>
    <message>
        <source>As it was fitted: %1</source>
        <translation>与拟合时相同：%1</translation>
    </message>
</context>
<context>
    <name>widgets::WorkWords</name>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>Fit the current frame: F</source>
        <translation>拟合当前帧：F</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 失败</translation>
    </message>
    <message>
        <source>Frame %1 from frame %2</source>
        <translation>第 %1 帧，起始于第 %2 帧</translation>
    </message>
    <message>
        <source>There is nothing to measure the error against.</source>
        <translation>没有可用于衡量误差的参照。</translation>
    </message>
    <message>
        <source>Choose methods and sequences, then Run</source>
        <translation>选择方法和序列，然后运行</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 对</translation>
    </message>
</context>
<context>
    <name>widgets::Workspaces</name>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>标注者</translation>
    </message>
    <message>
        <source>All views are hidden: tick one under View, Cameras.</source>
        <translation>所有视图均已隐藏：请在“视图”的“相机”中勾选一个。</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>审核</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>假设分析</translation>
    </message>
</context>
</TS>
