<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AccuracyLayer</name>
    <message>
        <source>expected ±, hatched: not visible</source>
        <translation>预期 ±，斜线：看不到</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>AnalysisWords</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>started %1 earlier</source>
        <translation>早开始 %1</translation>
    </message>
    <message>
        <source>started %1 later</source>
        <translation>晚开始 %1</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data</source>
        <translation>Kalman/RTS，噪声由数据估计</translation>
    </message>
    <message>
        <source>Savitzky–Golay, cubic, 11 points</source>
        <translation>Savitzky–Golay，三次，11 点</translation>
    </message>
    <message>
        <source>differences as in Tracker</source>
        <translation>与 Tracker 相同的差分</translation>
    </message>
    <message>
        <source>none: raw differences</source>
        <translation>无：原始差分</translation>
    </message>
    <message>
        <source>%1, set by hand</source>
        <translation>%1，手动指定</translation>
    </message>
    <message>
        <source>synchronised to %1 by the motion; %2</source>
        <translation>同步至 %1，由运动得出；%2</translation>
    </message>
    <message>
        <source>synchronised to %1 by a flash of light; %2</source>
        <translation>同步至 %1，由闪光得出；%2</translation>
    </message>
    <message>
        <source>synchronised to %1 by the cameras&apos; time stamps; %2</source>
        <translation>同步至 %1，由相机时间戳得出；%2</translation>
    </message>
    <message>
        <source>assumed to start at the same time</source>
        <translation>视为同时开始</translation>
    </message>
    <message>
        <source>, clock %1 ppm fast</source>
        <translation>，其时钟快 %1 ppm</translation>
    </message>
    <message>
        <source>, clock %1 ppm slow</source>
        <translation>，其时钟慢 %1 ppm</translation>
    </message>
    <message>
        <source>%1 to %2 ms apart</source>
        <translation>间隔 %1 至 %2 ms</translation>
    </message>
    <message>
        <source>synchronised to %1 by sound; %2</source>
        <translation>同步至 %1，由声音得出；%2</translation>
    </message>
</context>
<context>
    <name>AnnotatedFrame</name>
    <message>
        <source>slow motion %1×</source>
        <translation>慢动作 %1×</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>此时该相机没有在录制</translation>
    </message>
    <message>
        <source>This frame cannot be decoded</source>
        <translation>此画面无法解码</translation>
    </message>
</context>
<context>
    <name>Certificate</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度矢量</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度矢量</translation>
    </message>
    <message>
        <source>Amount of acceleration</source>
        <translation>加速度大小</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>相机：%1</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>机器人：%1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>任务：%1</translation>
    </message>
    <message>
        <source>along the course of the task</source>
        <translation>沿任务的路线</translation>
    </message>
    <message>
        <source>over the floor that the cameras see: straight, a curve, stop and go</source>
        <translation>在相机可见的地面上：直线、曲线、走走停停</translation>
    </message>
    <message>
        <source>The views of each camera were rendered with its lens, position, image size and frame rate, written as videos, and imported, synchronised, tracked and analysed as any others.</source>
        <translation>按每台相机的镜头、位置、图像尺寸和帧率渲染其画面，写成视频，再像其他视频一样导入、同步、跟踪和分析。</translation>
    </message>
    <message>
        <source>A simulation shows what this geometry and this program can do, not what a certain recording did. It has even light, a still camera, a clean floor with the markers, sensor noise of 2 of 255 and an exposure of 8 ms at most, and a robot of simple solids in its colour and size.</source>
        <translation>模拟显示的是这种几何布置和本程序能达到的水平，而不是某次录像的实际结果。它假设光照均匀、相机静止、地面干净并带有标记、传感器噪声为 2（满幅 255）、曝光不超过 8 ms，机器人由具有其颜色和尺寸的简单几何体组成。</translation>
    </message>
    <message>
        <source>It does not cover flicker, reflections, deep shadows and people in the view; the look of the real robot, cables and hands; a camera that was moved; markers that were measured wrongly; rolling shutters; and errors of lens calibration and registration beyond the stated ones.</source>
        <translation>它不包括闪烁、反光、深阴影和画面中的人；真实机器人的外观、线缆和手；被移动的相机；测量错误的标记；卷帘快门；以及超出所声明范围的镜头标定和配准误差。</translation>
    </message>
    <message>
        <source>The verdict on a trial says which of these were noticed in its recording.</source>
        <translation>试验的评定会说明其录像中发现了其中哪些问题。</translation>
    </message>
    <message>
        <source>The known run from above</source>
        <translation>已知运行的俯视图</translation>
    </message>
    <message>
        <source>dashed: truth; strokes: errors of all runs, enlarged %1 times</source>
        <translation>虚线：真值；短线：各次运行的误差，放大 %1 倍</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>均方根</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95 % 低于</translation>
    </message>
    <message>
        <source>stated ± (σ)</source>
        <translation>声明的 ± (σ)</translation>
    </message>
    <message>
        <source>truth inside the stated 95 %</source>
        <translation>真值在声明的 95 % 内</translation>
    </message>
    <message>
        <source>Errors against the truth</source>
        <translation>相对真值的误差</translation>
    </message>
    <message>
        <source>%1 of %2 frames have a result</source>
        <translation>%2 帧中有 %1 帧得到结果</translation>
    </message>
    <message>
        <source>Certificate of this set-up</source>
        <translation>此设置的证书</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>位置误差</translation>
    </message>
    <message>
        <source>Velocity error</source>
        <translation>速度误差</translation>
    </message>
    <message>
        <source>Acceleration error</source>
        <translation>加速度误差</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>覆盖率</translation>
    </message>
    <message>
        <source>true positions inside the stated 95 %</source>
        <translation>真实位置在声明的 95 % 内</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>模拟了什么</translation>
    </message>
    <message>
        <source>What a simulation does not cover</source>
        <translation>模拟不包括什么</translation>
    </message>
    <message>
        <source>%1, error in %2</source>
        <translation>%1，误差（%2）</translation>
    </message>
    <message>
        <source>a line for each run; dashed: what the first states for 95 %</source>
        <translation>每次运行一条线；虚线：第一次运行声明的 95 %</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>σ on the floor</source>
        <translation>地面上的 σ</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>已标定</translation>
    </message>
    <message>
        <source>estimated from the floor</source>
        <translation>由地面估计</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>The views were synchronised by the motion, to %1 ms at worst.</source>
        <translation>各视图由运动同步，最差为 %1 ms。</translation>
    </message>
    <message>
        <source>Certificate of this set-up: errors over time</source>
        <translation>此设置的证书：误差随时间变化</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>The cameras</source>
        <translation>相机</translation>
    </message>
    <message numerus="yes">
        <source>%n simulated run(s) of %1 s and %2 at up to %3, %4.</source>
        <translation>
            <numerusform>%n 次模拟运行，每次 %1 s、%2，最高 %3，%4。</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>镜头的已知参数</translation>
    </message>
    <message>
        <source>Simulated %1, Odograph %2. All errors are against the known truth of the simulation.</source>
        <translation>模拟于 %1，Odograph %2。所有误差均相对于模拟的已知真值。</translation>
    </message>
    <message>
        <source>In each run the cameras are a little off from where the project has them, drawn from the stated uncertainty of their registration and lens calibration; so the errors include it.</source>
        <translation>每次运行中，相机按其配准和镜头标定所声明的不确定度略微偏离项目中的位置，因此误差已包含这一不确定度。</translation>
    </message>
</context>
<context>
    <name>ClassReport</name>
    <message>
        <source>Rank: one more than the number of significantly better teams (medians differ by more than 1.96 σ). Teams of the same rank do not differ significantly.</source>
        <translation>名次：确定更好（中位数相差超过 1.96 σ）的小组数加一；同名次的小组无法区分优劣。</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them.</source>
        <translation>
            <numerusform>有 %n 次试验未计入：是按另一赛道测量的，请重新测量。</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2 · Odograph %3</source>
        <translation>第 %1 页，共 %2 页 · Odograph %3</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>任务：%1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>按“%1”</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Teams</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>共 %1 次</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>Median of all runs</source>
        <translation>全部运行的中位数</translation>
    </message>
    <message>
        <source>Middle half of the runs</source>
        <translation>居中的半数运行</translation>
    </message>
    <message>
        <source>The teams</source>
        <translation>各小组</translation>
    </message>
    <message>
        <source>each run is a dot; the line is the median of the team</source>
        <translation>每个点是一次运行；竖线是小组的中位数</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>Over the term</source>
        <translation>本学期的变化</translation>
    </message>
    <message>
        <source>Its trials</source>
        <translation>该组的试验</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>班级：%1</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>名次</translation>
    </message>
    <message numerus="yes">
        <source>of %n team(s)</source>
        <translation>
            <numerusform>共 %n 个小组</numerusform>
        </translation>
    </message>
    <message>
        <source>class median %1</source>
        <translation>班级中位数 %1</translation>
    </message>
    <message>
        <source>Spread of one run</source>
        <translation>单次运行的离散度</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n 次试验未计入：结果不可用。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! 计入 %n 次结果存疑的试验。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonExplanation</name>
    <message>
        <source>No difference.</source>
        <translation>没有差别。</translation>
    </message>
    <message>
        <source>Both values are exact: any difference is real.</source>
        <translation>两者都是精确值，因此任何差别都是真实的。</translation>
    </message>
    <message>
        <source>%1 σ, above 1.96: without a real difference, chance would give this much in fewer than 5 of 100 cases.</source>
        <translation>差值为 %1 σ，大于 1.96：假如并无差别，偶然出现这么大差值的可能性不到 5 %。</translation>
    </message>
    <message>
        <source>%1 σ, not above 1.96: the difference is not significant.</source>
        <translation>差值为 %1 σ，不大于 1.96：在误差范围内，不能断定有差别。</translation>
    </message>
    <message>
        <source>along the task&apos;s reference path</source>
        <translation>沿任务的参考路径</translation>
    </message>
    <message>
        <source>along the path of %1</source>
        <translation>沿 %1 的路线</translation>
    </message>
    <message>
        <source>time 0: each passes the start gate</source>
        <translation>零时刻：各自通过起点门</translation>
    </message>
    <message>
        <source>time 0: each begins to move</source>
        <translation>零时刻：各自开始运动</translation>
    </message>
    <message>
        <source>time 0: each first reaches the same point of the path</source>
        <translation>零时刻：各自首次到达路线上的同一位置</translation>
    </message>
    <message>
        <source>time 0: set by hand, to one frame</source>
        <translation>零时刻：手动指定，精确到一帧</translation>
    </message>
    <message>
        <source>both with the same registrations and robot shape: the calibration uncertainty is common, so only its difference counts</source>
        <translation>两者采用相同的配准和相同的几何体：标定带来的误差是共有的，只计其差值</translation>
    </message>
    <message>
        <source>different registrations or robot shapes: the calibration uncertainty counts in full for both</source>
        <translation>两者的配准或几何体不同：标定带来的误差对两者都全部计入</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1: %2 minus %3</source>
        <translation>%1：%2 减 %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>only one of the two runs has it</source>
        <translation>两者中只有一个有此项</translation>
    </message>
    <message>
        <source>the value of %1 minus that of %2</source>
        <translation>%1 的指标减去 %2 的指标</translation>
    </message>
    <message>
        <source>Each: %1</source>
        <translation>各自：%1</translation>
    </message>
    <message>
        <source>√(σ₁² + σ₂²), treated as independent; where the runs share their calibration, its scale uncertainty counts only for the difference</source>
        <translation>√(σ₁² + σ₂²)，视两者为相互独立；若两次运行共用标定，其尺度误差只按差值部分计入</translation>
    </message>
    <message>
        <source>not visible at one end</source>
        <translation>在一端未被看到</translation>
    </message>
    <message>
        <source>Sector %1 to %2: %3 minus %4</source>
        <translation>区段 %1 至 %2：%3 减 %4</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>end</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>For each run, the time from its first arrival at one gate to its first arrival at the next, by its position along the common path; waiting counts.</source>
        <translation>每次运行从首次到达前一计时门到首次到达后一计时门的时间，按其在公共路径上的位置计算；停留等待的时间也计入。</translation>
    </message>
    <message>
        <source>of each arrival: σ of the position along the path divided by the speed; displacements at two gates count as independent</source>
        <translation>每次到达的误差：沿路径方向位置的 σ 除以速度；两个计时门处的位置误差视为相互独立</translation>
    </message>
    <message>
        <source>from %1 to %2 along the path</source>
        <translation>路线上从 %1 到 %2</translation>
    </message>
    <message>
        <source>Δt of %1 against %2 at %3</source>
        <translation>%1 相对于 %2 在 %3 处的 Δt</translation>
    </message>
    <message>
        <source>The time of the first arrival at this point of the common path, each from its own time 0: that of %1 minus that of %2. Positive means later.</source>
        <translation>首次到达公共路径上该处的时间，各自从自己的零时刻算起：%1 的减去 %2 的。大于 0 表示较晚。</translation>
    </message>
    <message>
        <source>of both arrivals: σ of the position along the path divided by the speed, and of both times 0</source>
        <translation>两次到达的误差：沿路径方向位置的 σ 除以速度；以及两个零时刻的误差</translation>
    </message>
    <message>
        <source>Speed of %1 at %2</source>
        <translation>%1 在 %2 处的速度</translation>
    </message>
    <message>
        <source>|v| of the smoothed curve where the run first reaches this point of the common path, interpolated between frames</source>
        <translation>该次运行首次到达公共路径上该处时平滑曲线的 |v|，帧与帧之间插值</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>该处平滑速度的 σ，含标定的尺度误差</translation>
    </message>
    <message>
        <source>none: a run was not measured all the time, and is at least so large</source>
        <translation>无：有一次运行未全程测量，数值至少这么大</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>± one σ; grey, ≈: not significant</source>
        <translation>± 一个 σ；灰色、≈：在误差范围内</translation>
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
        <source>right − left</source>
        <translation>右 − 左</translation>
    </message>
    <message>
        <source>along the task’s path</source>
        <translation>沿任务的路径</translation>
    </message>
    <message>
        <source>along the path of the left run</source>
        <translation>沿左栏运行的路线</translation>
    </message>
    <message>
        <source>aligned by the start gate, %1</source>
        <translation>按起点门对齐，%1</translation>
    </message>
    <message>
        <source>aligned by the onset of motion, %1</source>
        <translation>按开始运动对齐，%1</translation>
    </message>
    <message>
        <source>aligned by a point that both pass, %1</source>
        <translation>按两者都经过的一处对齐，%1</translation>
    </message>
    <message>
        <source>aligned by hand, %1</source>
        <translation>手动对齐，%1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>任务：%1</translation>
    </message>
    <message>
        <source>%1: analysed %2, Odograph %3</source>
        <translation>%1：分析于 %2，Odograph %3</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels.</source>
        <translation>两次运行共用标定：共用的部分误差相互抵消。</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count.</source>
        <translation>两次运行不共用标定：两者的误差都计入。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>沿程速度，%1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>及其 ±95 % 置信带</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>时间差，s</translation>
    </message>
    <message>
        <source>above 0: the right run is later; grey: not significant</source>
        <translation>大于 0：右栏的运行较晚；灰色：在误差范围内</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>区段，s</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Verdict on %1: %2</source>
        <translation>%1 的判定：%2</translation>
    </message>
</context>
<context>
    <name>Conflict</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>星标</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>已归档</translation>
    </message>
    <message>
        <source>In the bin</source>
        <translation>在回收站中</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>成员</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>化名</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>计时门</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>（已隐藏）</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>this version</source>
        <translation>此版本</translation>
    </message>
    <message>
        <source>another version</source>
        <translation>另一版本</translation>
    </message>
</context>
<context>
    <name>Explanation</name>
    <message>
        <source>smoothed by Kalman filter and RTS smoother, noise by maximum likelihood (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</source>
        <translation>用 Kalman 滤波器和 RTS 平滑器平滑，噪声由最大似然估计（Rauch, Tung, Striebel 1965；Bar-Shalom et al. 2001）</translation>
    </message>
    <message>
        <source>smoothed by a cubic through eleven points (Savitzky and Golay 1964)</source>
        <translation>用过十一点的三次多项式平滑（Savitzky and Golay 1964）</translation>
    </message>
    <message>
        <source>differences as in Tracker, positions not smoothed</source>
        <translation>与 Tracker 相同的差分，位置未平滑</translation>
    </message>
    <message>
        <source>raw differences (Park 2018, eq. 6 to 8), nothing smoothed</source>
        <translation>原始差分（Park 2018，式 6 至 8），未作平滑</translation>
    </message>
    <message>
        <source>robot %1 high (estimated)</source>
        <translation>机器人高 %1（估计值）</translation>
    </message>
    <message>
        <source>robot %1 high</source>
        <translation>机器人高 %1</translation>
    </message>
    <message>
        <source>analysis %1 by Odograph %2</source>
        <translation>分析 %1，由 Odograph %2 完成</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>该处平滑速度的 σ，含标定的尺度误差</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>|v| = √(vx² + vy²) of the smoothed curve at this frame</source>
        <translation>该帧处平滑曲线的 |v| = √(vx² + vy²)</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>a·v/|v| of the smoothed curve at this frame: along the path, negative when braking; |a| while the robot stands still</source>
        <translation>该帧处平滑曲线的 a·v/|v|：沿路径方向，因此制动为负；静止时为 |a|</translation>
    </message>
    <message>
        <source>σ of the smoothed acceleration there, including the calibration&apos;s scale uncertainty</source>
        <translation>该处平滑加速度的 σ，含标定的尺度误差</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>航向</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>转向角速度</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>位置 X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>位置 Y</translation>
    </message>
    <message>
        <source>the smoothed curve at this frame</source>
        <translation>该帧处的平滑曲线</translation>
    </message>
    <message>
        <source>σ of the smoothed position, including the calibration&apos;s part</source>
        <translation>平滑位置的 σ，含标定部分</translation>
    </message>
    <message>
        <source>no view found the robot in this frame: the curve bridges the gap</source>
        <translation>该帧没有视角找到机器人：曲线由此跨过</translation>
    </message>
    <message>
        <source>measured there: %1, %2 ±%3</source>
        <translation>该处测得：%1，%2 ±%3</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>由 %1 测得</translation>
    </message>
    <message>
        <source>it is flagged and not used: the curve follows its neighbours</source>
        <translation>已标为异常，未被采用：曲线由相邻点得出</translation>
    </message>
    <message>
        <source>Jump: the position does not fit the motion before and after (χ² with two degrees of freedom, 99.9 %).</source>
        <translation>跳变：该位置超出前后运动所允许的范围（两个自由度的 χ²，99.9 %）。</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the speed limit of the task or of the analysis.</source>
        <translation>限值：要到达该处，速度须超过任务或分析的限值。</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the acceleration limit of the task or of the analysis.</source>
        <translation>限值：要到达该处，加速度须超过任务或分析的限值。</translation>
    </message>
    <message>
        <source>Views disagree: their floor positions differ by more than their uncertainty and their usual disagreement explain (χ², 99.9 %).</source>
        <translation>视角不一致：各视角的位置相差过大，其误差和通常的差异都不足以解释（χ²，99.9 %）。</translation>
    </message>
    <message>
        <source>Low score: the tracker was not sure of what it saw.</source>
        <translation>置信度低：跟踪器对所见没有把握。</translation>
    </message>
    <message>
        <source>Lost: no view found the robot.</source>
        <translation>丢失：没有视角找到机器人。</translation>
    </message>
    <message>
        <source>Repeated frame: the camera delivered the same frame twice, so its time is unknown.</source>
        <translation>重复画面：相机把同一画面给出了两次，因此其时间未知。</translation>
    </message>
    <message>
        <source>Bridged: the curve crosses a gap without measurements.</source>
        <translation>补接：曲线在没有测量的情况下跨过此处。</translation>
    </message>
    <message>
        <source>By hand: a manual override replaces the result of the analysis.</source>
        <translation>手动：由人作出判断，优先于分析。</translation>
    </message>
    <message>
        <source>How it is computed</source>
        <translation>计算方法</translation>
    </message>
    <message>
        <source>What ± contains (one standard deviation)</source>
        <translation>± 的构成（一个标准差）</translation>
    </message>
    <message>
        <source>What went into it</source>
        <translation>所用数据</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>出处</translation>
    </message>
    <message>
        <source>trial %1, robot %2</source>
        <translation>试验 %1，机器人 %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples used</source>
        <translation>采用 %1 个采样点，共 %2 个</translation>
    </message>
    <message>
        <source>views: %1</source>
        <translation>视角：%1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, at most %4 beyond the edge</source>
        <translation>%1：从 %2 到 %3，最多超出边界 %4</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%2 时的%1</translation>
    </message>
    <message>
        <source>Spike at %1</source>
        <translation>%1 处的异常点</translation>
    </message>
    <message>
        <source>The sample is kept, but not used for the curve.</source>
        <translation>该采样点予以保留，但不用于曲线。</translation>
    </message>
    <message>
        <source>The curve uses the sample nevertheless: its faulty part was left out, or a manual override restored it.</source>
        <translation>该采样点仍用于曲线：其中有问题的部分已剔除，或已由人恢复。</translation>
    </message>
    <message>
        <source>the views&apos; floor positions differ by %1 there</source>
        <translation>该处各视角相距 %1</translation>
    </message>
    <message>
        <source>Of the body where its outline or an imported track shows it: the smoothed heading. Elsewhere the direction of motion: atan2(vy, vx) of the smoothed curve, kept where the robot stands still and continued where it reverses. Anticlockwise from X, without jumps of a whole turn.</source>
        <translation>轮廓或导入的轨迹能显示之处取机身的朝向：平滑后的朝向。其余取运动方向：平滑曲线的 atan2(vy, vx)，机器人静止时保持，倒车时延续。自 X 轴起逆时针，不作整圈跳变。</translation>
    </message>
    <message>
        <source>of the body: σ of its smoothed heading; of the direction of motion: σ of the velocity across the motion divided by the speed</source>
        <translation>机身：其平滑朝向的 σ；运动方向：垂直于运动方向速度的 σ 除以速度</translation>
    </message>
    <message>
        <source>Of the body where its heading was measured: the rate of the smoothed heading. Elsewhere (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>测得机身朝向之处：平滑朝向的变化率。其余：平滑曲线的 (vx·ay − vy·ax)/|v|²。</translation>
    </message>
    <message>
        <source>of the body: σ of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>机身：平滑朝向变化率的 σ；运动方向：σ² = σa²/|v|² + |a|²σv²/|v|⁴，一阶近似</translation>
    </message>
    <message>
        <source>of the robot&apos;s body, which was measured</source>
        <translation>机身的值，由测量得到</translation>
    </message>
    <message>
        <source>of the direction of motion</source>
        <translation>运动方向的值</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>速度 X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>速度 Y</translation>
    </message>
    <message>
        <source>the velocity of the smoothed curve at this frame along that axis</source>
        <translation>该帧处平滑曲线沿该轴的速度</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>横向加速度</translation>
    </message>
    <message>
        <source>(vx·ay − vy·ax)/|v| of the smoothed curve at this frame: across the path, positive to the left</source>
        <translation>该帧处平滑曲线的 (vx·ay − vy·ax)/|v|：垂直于路径，向左为正</translation>
    </message>
    <message>
        <source>σ² = σa² + (a·v/|v|)²σv²/|v|², first order: of the acceleration, and of the direction of motion</source>
        <translation>σ² = σa² + (a·v/|v|)²σv²/|v|²，一阶：来自加速度和运动方向</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>加加速度</translation>
    </message>
    <message>
        <source>(a(t₂) − a(t₁))/(t₂ − t₁) along the path, from the smoothed accelerations half of %1 before and after this frame; its length while the robot stands still</source>
        <translation>沿路径方向 (a(t₂) − a(t₁))/(t₂ − t₁)：取该帧前后各 %1 一半处的平滑加速度；机器人静止时为其大小</translation>
    </message>
    <message>
        <source>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ the correlation of both errors</source>
        <translation>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)²，ρ 为两个误差的相关系数</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>行驶距离</translation>
    </message>
    <message>
        <source>the integral of the smoothed speed over the time in which the robot moves, up to this frame</source>
        <translation>到该帧为止机器人运动期间平滑速度的积分</translation>
    </message>
    <message>
        <source>of the positions at the ends of each motion, of errors across the path where it turns, and of the calibration&apos;s scale; without what the robot may have done while it was not measured</source>
        <translation>来自每段运动两端的位置、路径转弯处的横向误差和标定的尺度；不含未测量期间机器人可能的运动</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>到起点的距离</translation>
    </message>
    <message>
        <source>the straight line from the first smoothed position to this frame&apos;s</source>
        <translation>从第一个平滑位置到该帧位置的直线</translation>
    </message>
    <message>
        <source>of both positions along that line, and of the calibration&apos;s scale</source>
        <translation>来自两个位置沿该直线的误差和标定的尺度</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>到最近机器人的距离</translation>
    </message>
    <message>
        <source>between the reference points of both robots at this frame&apos;s time, on the smoothed curves</source>
        <translation>该帧时刻两个机器人参考点之间，取自平滑曲线</translation>
    </message>
</context>
<context>
    <name>ExplanationDialog</name>
    <message>
        <source>How was this computed?</source>
        <translation>这是如何计算的？</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
</context>
<context>
    <name>FactExplanations</name>
    <message>
        <source>The time offset at which the robot&apos;s floor tracks from the two views coincide: least squares of r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant shift and a small scale between them, searched in steps of half a frame and refined by Gauss–Newton. The clock rate is used if it exceeds three σ.</source>
        <translation>使机器人在地面上由两个视角所见的轨迹重合的时间偏移：对 r(t) = p₁(t) − p₂((t − 偏移)(1 + 速率)) 作最小二乘，两者之间允许有恒定位移和微小的尺度差，先以半帧为步长搜索，再用 Gauss–Newton 法细化。时钟速率只有超过三个 σ 时才采用。</translation>
    </message>
    <message>
        <source>from the curvature of the sum of squares and from the residual, assumed to be correlated over half a second</source>
        <translation>由平方和的曲率与残差得出，并认为残差在半秒内相关</translation>
    </message>
    <message>
        <source>The time offset at which the jumps in brightness in both views coincide: the weighted mean of the pairs. It is used if every other offset is at least 150 times less likely.</source>
        <translation>使两个视角都看到的亮度突变相重合的时间偏移；只有当其他偏移的似然都不到它的 1/150 时才采用：取各对的加权平均值。</translation>
    </message>
    <message>
        <source>from the pairs and their scatter, plus a tenth of a frame interval per view for its shutter</source>
        <translation>各对的误差、各对的离散，以及每个视角因快门而计入的十分之一帧间隔</translation>
    </message>
    <message>
        <source>Each camera&apos;s time stamps, converted to this computer&apos;s clock by reading the camera&apos;s clock during the recording.</source>
        <translation>各相机的时间戳；录制时读取相机时钟，由此与本计算机的时钟建立关系。</translation>
    </message>
    <message>
        <source>from both clock conversions</source>
        <translation>两个时钟关系的误差</translation>
    </message>
    <message>
        <source>Times at the gates</source>
        <translation>通过计时门的时间</translation>
    </message>
    <message>
        <source>When the robot&apos;s reference point crosses the gate&apos;s line between its ends, in the direction of the gate. Between two frames, the smoothed position is the cubic through both positions and velocities. A passage counts if the point was before the line by three σ of the track&apos;s own noise and then is past it by as much.</source>
        <translation>机器人中心按通过方向在计时门两端之间越过门线的时刻：两帧之间的平滑位置取经过两处位置和速度的三次曲线。先在门线之前、再到门线之后，均超过轨迹自身噪声的三个 σ，才算通过。</translation>
    </message>
    <message>
        <source>σ of the position across the gate divided by the speed across it, including the calibration&apos;s part</source>
        <translation>垂直于计时门方向位置的 σ 除以同方向的速度，含标定部分</translation>
    </message>
    <message>
        <source>From a passage of the start to one of the finish, or from one passage of a start-finish gate to the next. Of each split, the first passage counts.</source>
        <translation>从一次通过起点到通过终点，或从同一计时门的一次通过到下一次；每个分段门只计首次通过。</translation>
    </message>
    <message>
        <source>from both passages; the calibration&apos;s uncertainty cancels for a gate passed twice at the same speed</source>
        <translation>两次通过的误差；以同一速度两次通过同一计时门，标定误差相互抵消</translation>
    </message>
    <message>
        <source>to %1: %2</source>
        <translation>到 %1：%2</translation>
    </message>
    <message>
        <source>Synchronisation of view %1 with the first</source>
        <translation>视角 %1 与视角 1 同步</translation>
    </message>
    <message>
        <source>video %1, %2 frames</source>
        <translation>视频 %1，%2 帧</translation>
    </message>
    <message>
        <source>Height of robot %1</source>
        <translation>机器人 %1 的高度</translation>
    </message>
    <message>
        <source>The solid (box or cylinder, on the floor or a plate at the robot&apos;s top) whose silhouettes best match the outlines in all views, by weighted least squares at about forty times of the run. If no such solid explains them: the height at which all views give the same floor position.</source>
        <translation>以某种几何体（立于地面的长方体或圆柱体，或位于机器人顶部的平板）的剪影来解释所有视角中的轮廓，在运行中约四十个时刻作加权最小二乘；若没有这样的几何体能解释，则取使所有视角把机器人定在同一位置的高度。</translation>
    </message>
    <message>
        <source>The time offset at which claps, knocks or whistles in the sound of both views coincide: the weighted mean of the pairs, less the time that sound takes to reach each camera. It is used if every other offset is at least 150 times less likely.</source>
        <translation>使两个视角声音中的拍手、敲击或哨声相重合的时间偏移：各对的加权平均值，减去声音到达每台相机所需的时间。只有当其他偏移的可能性都至少小 150 倍时才采用。</translation>
    </message>
    <message>
        <source>from the pairs, from where on the floor the sound may have come, 50 ppm of the time from the start of the recording to the sound, and 2 ms by which each camera may record its sound early or late</source>
        <translation>各对的误差、声音在地面上可能的位置、从录制开始到该声音的时间的 50 ppm，以及每台相机声音可能提前或滞后的 2 ms</translation>
    </message>
</context>
<context>
    <name>FirstLesson</name>
    <message>
        <source>Play a run</source>
        <translation>播放一次运行</translation>
    </message>
    <message>
        <source>Two cameras filmed a robot. Press Space: both videos, the map and the curves play together. Press Space again to stop.</source>
        <translation>两台相机记录了一台机器人的行驶。按空格键：两段视频、地图和曲线同步播放。再按空格键则停止。</translation>
    </message>
    <message>
        <source>Read a result</source>
        <translation>读取指标</translation>
    </message>
    <message>
        <source>Click the speed curve. The bubble shows the speed at that moment and its uncertainty (±). The band around the curve contains the true speed in 95 of 100 cases.</source>
        <translation>在速度曲线上点击。气泡会显示那一时刻的速度及其 ±：可能的偏差有多大。曲线周围的带表示：100 次中有 95 次真值落在其中。</translation>
    </message>
    <message>
        <source>Check the flagged samples</source>
        <translation>查看被标出的点</translation>
    </message>
    <message>
        <source>Press Ctrl+Page Up or Ctrl+Page Down until the list of spikes on the right is not empty. A spike is a measurement that cannot be true; the list gives the reason.</source>
        <translation>用 Ctrl+Page Up 和 Ctrl+Page Down 逐个浏览试验，找到右侧异常点列表不为空的一个。异常点是测得的结果不可能为真的时刻；列表会说明原因。</translation>
    </message>
    <message>
        <source>Override it</source>
        <translation>推翻判定</translation>
    </message>
    <message>
        <source>Click a spike in the list and watch the videos: was the robot really there? Press U to use the sample nevertheless. Odograph never deletes a measurement.</source>
        <translation>点击列表中的一个异常点并查看视频：机器人真的在那里吗？按 U 即可仍然采用该采样点。测得的数据绝不会丢失。</translation>
    </message>
    <message>
        <source>Undo it</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>Press Ctrl+Z. Odograph saves every change at once, and you can undo it.</source>
        <translation>按 Ctrl+Z。您的每项更改都会立即保存，也都可以撤回。</translation>
    </message>
    <message>
        <source>Compare two runs</source>
        <translation>比较两次运行</translation>
    </message>
    <message>
        <source>Press Ctrl+4. Choose two runs on the right: where was one faster? Grey differences are not significant.</source>
        <translation>按 Ctrl+4。在右侧选择两次运行：哪一次在哪里更快，差别是否超过误差？灰色的就没有超过。</translation>
    </message>
    <message>
        <source>Find it again</source>
        <translation>再次找到它</translation>
    </message>
    <message>
        <source>Press Ctrl+5. History lists the whole year: type a team&apos;s name to search, press Enter to open a run, and see under Teams who made progress.</source>
        <translation>按 Ctrl+5。“历史”保存着全年的记录：输入小组名称即可搜索，按 Enter 打开一次运行，在“小组”下可看到谁有进步。</translation>
    </message>
    <message>
        <source>That&apos;s it</source>
        <translation>就是这些</translation>
    </message>
    <message>
        <source>For your own robots: create a project (Ctrl+N). Its Start page leads you from the clips of two phones, or from connected cameras, to a first result. F1 explains each page.</source>
        <translation>使用您自己的机器人：新建项目 (Ctrl+N)。其“开始”页面会引导您从两部手机的视频或已连接的相机得到第一个结果。F1 解释每个页面。</translation>
    </message>
</context>
<context>
    <name>GuidanceWords</name>
    <message>
        <source>searched</source>
        <translation>搜索区域</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>已忽略</translation>
    </message>
    <message>
        <source>%1 marked here</source>
        <translation>%1 标记于此</translation>
    </message>
    <message>
        <source>%1 set by hand</source>
        <translation>%1 手动设置</translation>
    </message>
    <message>
        <source>no robot visible, by hand</source>
        <translation>无可见机器人（手动）</translation>
    </message>
    <message>
        <source>%1 not visible, by hand</source>
        <translation>%1 不可见（手动）</translation>
    </message>
</context>
<context>
    <name>HealthWatch</name>
    <message>
        <source>The project is read-only</source>
        <translation>项目只能读取</translation>
    </message>
    <message>
        <source>Opening the cameras…</source>
        <translation>正在打开相机…</translation>
    </message>
    <message>
        <source>No camera is running</source>
        <translation>没有相机在运行</translation>
    </message>
    <message>
        <source>No camera sends frames</source>
        <translation>没有相机发送画面</translation>
    </message>
    <message>
        <source>This project is read-only: you cannot record into it.</source>
        <translation>此项目只能读取：不能向其中录制。</translation>
    </message>
    <message>
        <source>Register &amp;it in Testbed</source>
        <translation>到“试验场”中配准(&amp;I)</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>List of keys</source>
        <translation>按键列表</translation>
    </message>
    <message>
        <source>About Odograph</source>
        <translation>关于 Odograph</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.

Free software under the GNU General Public License, version 3 or later, without any warranty.

The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018.</source>
        <translation>由普通相机的视频测量移动机器人的运动。

自由软件，遵循 GNU 通用公共许可证第 3 版或更高版本，不提供任何担保。

方法依据 S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018。</translation>
    </message>
</context>
<context>
    <name>HtmlChart</name>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>平滑后，含 ±95 % 置信带；点：测量值</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>平滑后，含 ±95 % 置信带；点：测量值；阴影：未测量</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>速度，%1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>沿路径方向的加速度，%1</translation>
    </message>
</context>
<context>
    <name>HtmlMap</name>
    <message>
        <source>a square: %1</source>
        <translation>一格：%1</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>运行俯视图</translation>
    </message>
    <message>
        <source>coloured by speed, from 0 (dark) to %1 (light); ring: start, dot: end</source>
        <translation>按速度着色，从 0（深）到 %1（浅）；圆环：起点，圆点：终点</translation>
    </message>
    <message>
        <source>Both runs from above</source>
        <translation>两次运行俯视图</translation>
    </message>
    <message>
        <source>in the colours of the runs</source>
        <translation>以各次运行的颜色</translation>
    </message>
</context>
<context>
    <name>HtmlPage</name>
    <message>
        <source>Made by Odograph %1; ± is one standard deviation.</source>
        <translation>由 Odograph %1 生成；± 为一个标准差。</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>评定：%1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>from the start to</source>
        <translation>从起点到</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>第 %1 次</translation>
    </message>
    <message>
        <source>sector to %1</source>
        <translation>到 %1 的区段</translation>
    </message>
    <message>
        <source>No spikes.</source>
        <translation>无异常点。</translation>
    </message>
    <message numerus="yes">
        <source>Spikes: %n</source>
        <translation>
            <numerusform>异常点：%n</numerusform>
        </translation>
    </message>
    <message>
        <source>reason</source>
        <translation>原因</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>以及另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Where this comes from</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels. ≈: not significant.</source>
        <translation>两次运行共用标定：其不确定度大部分抵消。≈：不显著。</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count. ≈: not significant.</source>
        <translation>两次运行的标定不同：两者的不确定度都计入。≈：不显著。</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>沿程速度，%1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>及其 ±95 % 置信带</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>时间差，s</translation>
    </message>
    <message>
        <source>above 0: the second run is later; grey: not significant</source>
        <translation>高于 0：第二次运行较晚；灰色：不显著</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>区段，s</translation>
    </message>
</context>
<context>
    <name>Hub</name>
    <message>
        <source>Connected.</source>
        <translation>已连接。</translation>
    </message>
    <message>
        <source>Everything had been sent.</source>
        <translation>已全部发送过。</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) sent.</source>
        <translation>
            <numerusform>已发送 %n 项。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing new at the hub.</source>
        <translation>中心库中没有新内容。</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) received.</source>
        <translation>
            <numerusform>已接收 %n 项。</numerusform>
        </translation>
    </message>
    <message>
        <source>Recordings: %1 copied.</source>
        <translation>录像：已复制 %1。</translation>
    </message>
    <message numerus="yes">
        <source>%n more warning(s).</source>
        <translation>
            <numerusform>另有 %n 条警告。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%2 上的 %1</translation>
    </message>
    <message>
        <source>Teacher: may change everything</source>
        <translation>教师：可更改一切</translation>
    </message>
    <message>
        <source>Bench: publishes its own trials, reads those of others</source>
        <translation>工作台：发布自己的试验，读取其他的试验</translation>
    </message>
    <message>
        <source>Viewer: reads results only</source>
        <translation>查看者：只读取结果</translation>
    </message>
    <message>
        <source>Nothing: all is sent</source>
        <translation>无：已全部发送</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s)</source>
        <translation>
            <numerusform>%n 处更改</numerusform>
        </translation>
    </message>
    <message>
        <source>password needed</source>
        <translation>需要密码</translation>
    </message>
    <message>
        <source>server away</source>
        <translation>服务器无法连接</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>未被接受</translation>
    </message>
    <message>
        <source>Hub: %1</source>
        <translation>中心库：%1</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending, %1</source>
        <translation>
            <numerusform>中心库：%n 项待发送，%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Hub: publishing…</source>
        <translation>中心库：正在发布…</translation>
    </message>
    <message>
        <source>Hub: pulling…</source>
        <translation>中心库：正在接收…</translation>
    </message>
    <message>
        <source>Hub: all sent</source>
        <translation>中心库：已全部发送</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending</source>
        <translation>
            <numerusform>中心库：%n 项待发送</numerusform>
        </translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>尚无回应</translation>
    </message>
    <message numerus="yes">
        <source>Hub: publishing, %n pending</source>
        <translation>
            <numerusform>中心库：正在发布，%n 项待发送</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapPainting</name>
    <message>
        <source>grid %1 %2</source>
        <translation>网格 %1 %2</translation>
    </message>
</context>
<context>
    <name>MatWords</name>
    <message>
        <source>Row %1, sheet %2</source>
        <translation>第 %1 行，第 %2 张</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>This line is %1 long on the whole mat. Measure it.</source>
        <translation>此线在整张地垫上长 %1。请测量。</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets. Print at 100 % (actual size). Cut along the dashed lines.</source>
        <translation>%1 × %2 张纸的地垫。以 100 %（实际大小）打印。沿虚线裁剪。</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>%1 × %2 张纸的地垫</translation>
    </message>
    <message>
        <source>1. Print all pages at 100 % (actual size), not fitted to the page.</source>
        <translation>1. 以 100 %（实际大小）打印所有页，不要缩放以适合页面。</translation>
    </message>
    <message>
        <source>2. Cut each sheet along its dashed lines. Lay it on its neighbours, up to their thin lines, as drawn below, and tape the sheets together.</source>
        <translation>2. 沿虚线裁剪每张纸。如下图所示，把它放到相邻纸张上，对齐其细线，然后用胶带粘在一起。</translation>
    </message>
    <message>
        <source>3. Measure the line at the lower edge. It should be %1 long; Odograph asks for what you measure.</source>
        <translation>3. 测量下边缘的线。它应长 %1；Odograph 会询问您测得的值。</translation>
    </message>
    <message>
        <source>4. Lay the mat flat where every camera sees all of it. The lower left corner is the origin, the lower edge the x axis.</source>
        <translation>4. 把地垫平放在每台相机都能看到整张的地方。左下角为原点，下边缘为 x 轴。</translation>
    </message>
</context>
<context>
    <name>Modes</name>
    <message>
        <source>Testbed</source>
        <translation>试验场</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
</context>
<context>
    <name>OutputQuestion</name>
    <message>
        <source>%1 is a file of another kind. Replace it?</source>
        <translation>%1 是另一种类型的文件。要替换吗？</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 已存在。要替换吗？</translation>
    </message>
</context>
<context>
    <name>OwnChanges</name>
    <message>
        <source>Done: %1. Press Ctrl+Z to undo it.</source>
        <translation>已完成：%1。可用 Ctrl+Z 撤回。</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>已撤销：%1。</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>已重做：%1。</translation>
    </message>
</context>
<context>
    <name>PageMenus</name>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>T&amp;rial</source>
        <translation>试验(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Spikes</source>
        <translation>异常点(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史(&amp;H)</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>录制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>工具(&amp;T)</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>区间(&amp;G)</translation>
    </message>
</context>
<context>
    <name>RangeFacts</name>
    <message>
        <source>from %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
    <message>
        <source>The calibration&apos;s contribution to an angle is unknown and not included.</source>
        <translation>标定给角度带来的误差未知，未计入。</translation>
    </message>
    <message>
        <source>Includes the position uncertainty of the calibration.</source>
        <translation>已计入标定的位置误差。</translation>
    </message>
    <message>
        <source>Includes the scale uncertainty of the calibration.</source>
        <translation>已计入标定的尺度误差。</translation>
    </message>
    <message>
        <source>Neighbouring points of a smoothed curve have correlated errors. They average out over time, not over frames: with a spectrum of r/(1 + (ω/ω₀)⁶) for the position, ω₀ = √2 σv/σx.</source>
        <translation>平滑曲线上相邻点的误差是共有的，因此误差随时间而不是随帧数平均而减小：位置的误差谱取 r/(1 + (ω/ω₀)⁶)，ω₀ = √2 σv/σx。</translation>
    </message>
    <message>
        <source>From the smoothed curve, each value weighted by half the time to both neighbours: mean; median (the curve is below it half of the time); least and most, chosen by value + 2σ and value − 2σ; spread √(mean of the squared distance from the mean).</source>
        <translation>取自平滑曲线，每个值代表到前后相邻点各一半的时间：平均值、中位数（一半时间低于它）、确定的最小值和最大值（按该值加或减 2σ 判断），以及离散度 √(与平均值之差的平方的平均值)。</translation>
    </message>
    <message>
        <source>no value here</source>
        <translation>此处无数值</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1（在 %2）</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>least</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>most</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>离散度</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>does not fit: χ² is %1 times what the uncertainties explain</source>
        <translation>形状不符：χ² 是误差所能解释的 %1 倍</translation>
    </message>
    <message>
        <source>fits; the stated uncertainties are too large: χ² is %1 of its expected value</source>
        <translation>相符；所给误差偏大：χ² 是其预期值的 %1 倍</translation>
    </message>
    <message>
        <source>fits: χ² is %1 of its expected value</source>
        <translation>相符：χ² 是误差预期值的 %1 倍</translation>
    </message>
    <message>
        <source>Fit of %1</source>
        <translation>%1的拟合</translation>
    </message>
    <message>
        <source>The polynomial in t − t₀ that minimises Σ(residual/σ)² over %1, t₀ = %2. χ² is that sum divided by its expected value: the number of points minus the degrees of freedom of the coefficients.</source>
        <translation>对%1拟合 t − t₀ 的多项式，使 Σ(残差/σ)² 最小，t₀ = %2。χ² 是该总和除以误差的预期值：点数减去系数所占的个数。</translation>
    </message>
    <message>
        <source>the measured positions used</source>
        <translation>所采用的测得位置</translation>
    </message>
    <message>
        <source>the smoothed curve</source>
        <translation>平滑曲线</translation>
    </message>
    <message>
        <source>The larger of two uncertainties: that of the measurements, widened by 1 + 2Σρ for correlated residuals (here ×%1), and that of the smoothed curve, including the errors that persist.</source>
        <translation>取两者中较大的：一是测量的误差，残差相关时按 1 + 2Σρ 放大（此处为 ×%1）；二是平滑曲线的误差，其中包含了测量误差中持续存在的部分。</translation>
    </message>
    <message>
        <source>Assumes that the shape is correct; χ² far above 1 shows that it is not. χ² below 1 means that the smoother allows for more motion than the robot made.</source>
        <translation>前提是所选形状为真实形状；χ² 远大于 1 说明并非如此。小于 1 则是因为平滑器允许的运动变化多于实际。</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 至 %2：%3</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路程</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>slope there</source>
        <translation>该处斜率</translation>
    </message>
    <message>
        <source>times t²</source>
        <translation>t² 的系数</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1 (RMS)</translation>
    </message>
</context>
<context>
    <name>RecordHealth</name>
    <message>
        <source>problem</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>缓慢</translation>
    </message>
    <message>
        <source>lost frames</source>
        <translation>有丢帧</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>, %1 ms</source>
        <translation>，%1 ms</translation>
    </message>
    <message>
        <source>; not registered</source>
        <translation>；未配准</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>no camera sees it</source>
        <translation>未看到</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>未见</translation>
    </message>
    <message>
        <source>x %1, y %2, %3</source>
        <translation>x %1，y %2，%3</translation>
    </message>
    <message>
        <source>; one camera sees it</source>
        <translation>；仅一台相机看到</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>尚可</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>不同步</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>同步</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>%1 MB written</source>
        <translation>已写入 %1 MB</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>磁盘</translation>
    </message>
    <message>
        <source>Camera %1 is not registered to the floor: it records, but cannot locate robots.</source>
        <translation>相机 %1 未配准到地面：会录制，但无法由它得知机器人的位置。</translation>
    </message>
    <message>
        <source>Camera %1 was registered with frames of %2×%3, but now sends another size: it records, but cannot locate robots.</source>
        <translation>相机 %1 是按 %2×%3 的画面配准的，而现在发送的画面不是这个尺寸：会录制，但无法由它得知机器人的位置。</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>录制：%1</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>相机 %1：%2</translation>
    </message>
    <message>
        <source>The disk is barely fast enough: record to a faster one, or with fewer cameras.</source>
        <translation>磁盘速度勉强够用：请录制到更快的磁盘，或减少相机。</translation>
    </message>
    <message>
        <source>The disk is nearly full: %1</source>
        <translation>磁盘将满：%1</translation>
    </message>
    <message>
        <source>The cameras are not synchronised: set both to the same frame rate.</source>
        <translation>两台相机不同步：请将它们设为相同的帧率。</translation>
    </message>
</context>
<context>
    <name>Remedy</name>
    <message>
        <source>Synchronise…</source>
        <translation>同步…</translation>
    </message>
    <message>
        <source>Robots…</source>
        <translation>机器人…</translation>
    </message>
    <message>
        <source>Open Testbed</source>
        <translation>打开试验场</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>跟踪…</translation>
    </message>
    <message>
        <source>Find lost videos…</source>
        <translation>查找丢失的视频…</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>以及另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
</context>
<context>
    <name>ReportChart</name>
    <message>
        <source>Speed, %1</source>
        <translation>速度，%1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>沿路径方向的加速度，%1</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>平滑后，含 ±95 % 置信带；点：测量值</translation>
    </message>
    <message>
        <source>No curve: the robot was not detected</source>
        <translation>无曲线：未看到机器人</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>平滑后，含 ±95 % 置信带；点：测量值；阴影：未测量</translation>
    </message>
</context>
<context>
    <name>ReportMethod</name>
    <message>
        <source>%1: %2 frames at %3/s</source>
        <translation>%1：%2 帧，%3/s</translation>
    </message>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>缺 %n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>lens calibrated to %1 px</source>
        <translation>镜头已标定至 %1 px</translation>
    </message>
    <message>
        <source>registered to the floor to %1 px, %2</source>
        <translation>已配准到地面，至 %1 px，%2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>%1 samples: %2 measured, %3 used, %4 flagged, %5 bridged; the views disagree by %6 on average</source>
        <translation>%1 个采样点：测得 %2，采用 %3，标为异常 %4，补接 %5；视角平均相差 %6</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t，s</translation>
    </message>
    <message>
        <source>x, %1</source>
        <translation>x，%1</translation>
    </message>
    <message>
        <source>y, %1</source>
        <translation>y，%1</translation>
    </message>
    <message>
        <source>speed, %1</source>
        <translation>速度，%1</translation>
    </message>
    <message>
        <source>± (σ)</source>
        <translation>± (σ)</translation>
    </message>
    <message>
        <source>acceleration, %1</source>
        <translation>加速度，%1</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>异常标注</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>测量数据</translation>
    </message>
    <message>
        <source>every sample, smoothed</source>
        <translation>每个采样点，平滑后</translation>
    </message>
    <message>
        <source>one sample of %1, smoothed; all of them are in the exported file</source>
        <translation>每 %1 个采样点取一个，平滑后；导出的文件中有全部采样点</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>smoother: %1</source>
        <translation>平滑器：%1</translation>
    </message>
    <message>
        <source>analysed %1, Odograph %2</source>
        <translation>分析于 %1，Odograph %2</translation>
    </message>
    <message>
        <source>%1: method</source>
        <translation>%1：方法</translation>
    </message>
    <message>
        <source>How the metrics were computed</source>
        <translation>各指标的计算方法</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>±: %1.</source>
        <translation>±：%1。</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>跳跃</translation>
    </message>
    <message>
        <source>speed limit</source>
        <translation>速度限值</translation>
    </message>
    <message>
        <source>acceleration limit</source>
        <translation>加速度限值</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>视角不一致</translation>
    </message>
    <message>
        <source>low score</source>
        <translation>得分低</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>duplicate frame</source>
        <translation>重复帧</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>插值</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>人工</translation>
    </message>
</context>
<context>
    <name>ReportStills</name>
    <message>
        <source>no image: the video cannot be read</source>
        <translation>无画面：视频无法读取</translation>
    </message>
    <message>
        <source>no image: the video is missing</source>
        <translation>无画面：视频缺失</translation>
    </message>
</context>
<context>
    <name>RobotColours</name>
    <message>
        <source>blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>vermilion</source>
        <translation>朱红色</translation>
    </message>
    <message>
        <source>green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>紫色</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>sky blue</source>
        <translation>天蓝色</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>RunEvents</name>
    <message>
        <source>First seen, moving already</source>
        <translation>首次看到，已在运动</translation>
    </message>
    <message>
        <source>Starts to move</source>
        <translation>开始运动</translation>
    </message>
    <message>
        <source>Last seen, still moving</source>
        <translation>最后看到，仍在运动</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停下</translation>
    </message>
    <message>
        <source>Top speed, %1</source>
        <translation>最大速度，%1</translation>
    </message>
    <message>
        <source>Passes %1</source>
        <translation>通过 %1</translation>
    </message>
    <message>
        <source>Spike: %1</source>
        <translation>异常点：%1</translation>
    </message>
    <message numerus="yes">
        <source>(%n samples)</source>
        <translation>
            <numerusform>（%n 个采样点）</numerusform>
        </translation>
    </message>
    <message>
        <source>Not measured for %1</source>
        <translation>%1 未测量</translation>
    </message>
</context>
<context>
    <name>SceneDisagreement</name>
    <message>
        <source>Only one view at a time: nothing to compare</source>
        <translation>每一时刻只有一个视角：无从比较</translation>
    </message>
    <message>
        <source>RMS %1, median %2</source>
        <translation>RMS %1，中位数 %2</translation>
    </message>
    <message>
        <source>expected from the uncertainty: %1</source>
        <translation>按误差预期：%1</translation>
    </message>
    <message>
        <source>%1 – more than it explains</source>
        <translation>%1 – 超出误差所能解释的程度</translation>
    </message>
    <message>
        <source>Disagreement of the views</source>
        <translation>视角差异</translation>
    </message>
    <message>
        <source>Each view alone gives a floor position of the robot. The chart shows the distance between these positions in each frame with two views or more (of more than two, the largest distance); RMS is √(mean of the squares). Unused samples are left out.
Expected is √(tr A + tr B + (v·σs)²) from the covariances A and B of two views (pixels and calibration), the speed v and the synchronisation uncertainty σs of the views.
Much more than expected means that a setting is wrong: the views are not synchronised (the distance grows with the speed), a camera has moved or is badly registered (it depends on the position), or the robot&apos;s height is wrong (it points to and from the cameras).</source>
        <translation>每个视角单独就能给出机器人在地面上的位置。这里显示在有两个或更多视角看到机器人的每一帧中，这些位置相距多远（多于两个视角时取最大距离）；RMS 为 √(平方的平均值)。未采用的采样点不计入。
预期值为 √(tr A + tr B + (v·σs)²)，由两个视角的协方差 A 和 B（像素与标定）、速度 v 以及视角同步的 σs 得出。
若远大于预期，说明有某项与设定不符：视角不同步（差异随速度增大），相机移动过或配准不佳（差异取决于位置），或机器人高度有误（差异沿朝向或背离相机的方向）。</translation>
    </message>
    <message>
        <source>%1 frames with two views or more; largest %2; views synchronised to %3 ms</source>
        <translation>有两个或更多视角看到的帧：%1；最大 %2；视角同步至 %3 ms</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>%1: not measured, no points (%2)</source>
        <translation>%1：未测量，不得分（%2）</translation>
    </message>
    <message>
        <source>%1 %2: %3 points (%4)</source>
        <translation>%1 %2：%3 分（%4）</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4 points (%5)</source>
        <translation>%1 %2：%3 分，满分 %4 分（%5）</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1，满分 %2</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>满分 %1</translation>
    </message>
    <message>
        <source>the sum of the points of each line; a line gives points × (metric − none at) / (all at − none at), from 0 to all</source>
        <translation>各评分项得分之和；每项得分为 分值 × (指标 − 零分界限) / (满分界限 − 零分界限)，从 0 分到满分</translation>
    </message>
    <message>
        <source>for each line, half the difference in points between its metric plus and minus one σ; root of the sum of the squares</source>
        <translation>对每个评分项，取其指标增减一个 σ 时得分之差的一半；再取平方和的平方根</translation>
    </message>
    <message>
        <source>%1 points off at %2 or less, none off at %3 or more</source>
        <translation>%2 或更低时扣 %1 分，%3 或更高时不扣分</translation>
    </message>
    <message>
        <source>%1 points off at %2 or more, none off at %3 or less</source>
        <translation>%2 或更高时扣 %1 分，%3 或更低时不扣分</translation>
    </message>
    <message>
        <source>%1 points at %2 or less, none at %3 or more</source>
        <translation>%2 或更低时得 %1 分，%3 或更高时不得分</translation>
    </message>
    <message>
        <source>%1 points at %2 or more, none at %3 or less</source>
        <translation>%2 或更高时得 %1 分，%3 或更低时不得分</translation>
    </message>
</context>
<context>
    <name>Scoreboard</name>
    <message>
        <source>Standings</source>
        <translation>排名</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>差距</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>行驶次数</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>名次</translation>
    </message>
    <message>
        <source>Best run</source>
        <translation>最佳行驶</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting…</source>
        <translation>连接已断开，正在重新连接…</translation>
    </message>
    <message>
        <source>This page needs JavaScript.</source>
        <translation>此页面需要 JavaScript。</translation>
    </message>
    <message>
        <source>Teams rank by the median of their runs. Teams that do not differ significantly (95 %) share a rank. ±: one standard deviation. ≈: not significantly behind the first.</source>
        <translation>名次按各次行驶的中位数排列。差异不显著（95 %）的小组名次相同。±：一个标准差。≈：与第一名差异不显著。</translation>
    </message>
    <message>
        <source>No ranks: no trial has a task, and runs of different tasks cannot be compared.</source>
        <translation>无名次：没有试验属于任务，不同任务的行驶无法比较。</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course.</source>
        <translation>
            <numerusform>有 %n 次试验未计入：是按另一赛道测量的。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n 次试验未计入：结果不可用。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! 计入 %n 次结果存疑的试验。</numerusform>
        </translation>
    </message>
    <message>
        <source>No team has a result yet.</source>
        <translation>还没有小组有结果。</translation>
    </message>
    <message>
        <source>Running now</source>
        <translation>正在行驶</translation>
    </message>
    <message>
        <source>The best run from above</source>
        <translation>最佳行驶的俯视图</translation>
    </message>
    <message>
        <source>a square: %1</source>
        <translation>一格：%1</translation>
    </message>
</context>
<context>
    <name>SetupWords</name>
    <message>
        <source>Two phones on tripods are enough. Film the robot with both, import the clips or drop them on this window; or connect cameras.</source>
        <translation>两部架在三脚架上的手机就足够了。用两部手机拍摄机器人，导入视频或拖到此窗口；或者连接相机。</translation>
    </message>
    <message>
        <source>Cameras: %1.</source>
        <translation>相机：%1。</translation>
    </message>
    <message>
        <source>Print the mat, tape it together and lay it where every camera sees it while it films: from it Odograph knows where the floor is.</source>
        <translation>打印地垫，粘好后放在拍摄时每台相机都能看到的地方：Odograph 由此得知地面的位置。</translation>
    </message>
    <message>
        <source>Positions on the floor: %1.</source>
        <translation>地面上的位置：%1。</translation>
    </message>
    <message>
        <source>Not registered yet: %1.</source>
        <translation>尚未配准：%1。</translation>
    </message>
    <message>
        <source>A printed board measures the distortion of the lens; without it positions far from the mat are less exact, and their ± says so.</source>
        <translation>打印的标定板显示镜头如何使图像弯曲；没有它，远离地垫的位置精度较低，其 ± 会反映出来。</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>已标定：%1。</translation>
    </message>
    <message>
        <source>A name is enough: Odograph finds a robot of any look by its motion.</source>
        <translation>有名称即可：无论机器人是什么外观，Odograph 都会根据其运动找到它。</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 以及另外 %2 个</translation>
    </message>
    <message>
        <source>Robots: %1.</source>
        <translation>机器人：%1。</translation>
    </message>
    <message>
        <source>Imported clips are tracked here, or record with connected cameras.</source>
        <translation>在此跟踪导入的视频，或用已连接的相机录制。</translation>
    </message>
    <message>
        <source>%1 is not measured yet.</source>
        <translation>%1 尚未测量。</translation>
    </message>
    <message>
        <source>%1 is measured.</source>
        <translation>%1 已测量。</translation>
    </message>
    <message>
        <source>Path, speed, acceleration and their ±, spikes with reasons: one PDF for each trial, or for the class.</source>
        <translation>路径、速度、加速度及其 ±，带原因的尖峰：每次试验或整个班级一个 PDF。</translation>
    </message>
</context>
<context>
    <name>ShownMessageWords</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>SnappedMarker</name>
    <message>
        <source>tag</source>
        <translation>标签码</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>dot</source>
        <translation>圆点</translation>
    </message>
    <message>
        <source>tape crossing</source>
        <translation>胶带交叉</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>拐角</translation>
    </message>
    <message>
        <source>crossing fields</source>
        <translation>方格交点</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
</context>
<context>
    <name>TargetPainter</name>
    <message>
        <source>100 mm</source>
        <translation>100 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Checkerboard, %1 × %2 inner corners, squares of %3</source>
        <translation>棋盘格，%1 × %2 个内角点，方格 %3</translation>
    </message>
    <message>
        <source>ChArUco board, %1 × %2 inner corners, squares of %3</source>
        <translation>ChArUco 板，%1 × %2 个内角点，方格 %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (tag 36h11 number %2), %3</source>
        <translation>地面标记 %1（标签码 36h11，编号 %2），%3</translation>
    </message>
    <message>
        <source>Floor marker %1 (ring), %2</source>
        <translation>地面标记 %1（圆环），%2</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Glue it flat onto something stiff, measure a square, and enter its side in Odograph.</source>
        <translation>请按 100 %（实际大小）打印。将其平整地粘在硬板上，测量一个方格，并把测得的数值告诉 Odograph。</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Lay it flat; the marker&apos;s position is its middle, where the four lines at the edges point.</source>
        <translation>请按 100 %（实际大小）打印。平放在地面上；标记的位置是其中心，即四边的四条线所指之处。</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>%1 × %2 张纸的地垫</translation>
    </message>
</context>
<context>
    <name>TestbedState</name>
    <message>
        <source>standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>rational</source>
        <translation>有理</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>鱼眼</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>画面尺寸</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>%1, f = %2 px</source>
        <translation>%1，f = %2 px</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>标定板误差</translation>
    </message>
    <message>
        <source>%1 px in %2 images</source>
        <translation>%1 px，共 %2 张图片</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>留出验证误差</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>registered %1</source>
        <translation>已配准，%1</translation>
    </message>
    <message>
        <source>Last check</source>
        <translation>上次检查</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m，y %2 m，高 %3 m</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>not registered: cannot measure positions yet</source>
        <translation>未配准：尚不能测量位置</translation>
    </message>
    <message>
        <source>not calibrated: estimated from the markers</source>
        <translation>未标定：由标记估计</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>未标定</translation>
    </message>
</context>
<context>
    <name>TrailPainting</name>
    <message>
        <source>0 to %1 %2</source>
        <translation>0 至 %1 %2</translation>
    </message>
</context>
<context>
    <name>TrendPainting</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>points</source>
        <translation>分</translation>
    </message>
</context>
<context>
    <name>TrialCurves</name>
    <message>
        <source>No curve yet: track the trial</source>
        <translation>尚无曲线：请跟踪该试验</translation>
    </message>
</context>
<context>
    <name>TrialExport</name>
    <message>
        <source>Export %1</source>
        <translation>导出 %1</translation>
    </message>
    <message>
        <source>%1 was exported to %2.</source>
        <translation>%1 已导出到 %2。</translation>
    </message>
</context>
<context>
    <name>TrialFacts</name>
    <message>
        <source>%1, %2 high (estimated)</source>
        <translation>%1，高 %2（估计值）</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1，高 %2</translation>
    </message>
    <message>
        <source>%1: %2×%3, %4 frames</source>
        <translation>%1：%2×%3，%4 帧</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视角</translation>
    </message>
    <message>
        <source>video missing</source>
        <translation>视频缺失</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>同步</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>未同步</translation>
    </message>
    <message>
        <source>SHA-256 %1…</source>
        <translation>SHA-256 %1…</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>计时门</translation>
    </message>
    <message>
        <source>to %1 %2</source>
        <translation>到 %1 %2</translation>
    </message>
    <message>
        <source>Lap %1</source>
        <translation>第 %1 圈</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>第 %1 次</translation>
    </message>
    <message>
        <source>off by %1 on average</source>
        <translation>平均偏离 %1</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1 (RMS)</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>偏左 %1</translation>
    </message>
    <message>
        <source>%1 of it completed</source>
        <translation>完成 %1</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>未越界</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>analysed with a different course</source>
        <translation>按另一赛道测量</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>none until you reanalyse the trial: the task has a different course now</source>
        <translation>重新测量之前无得分：任务现在用的是另一赛道</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Testbed</source>
        <translation>试验场</translation>
    </message>
    <message>
        <source>markers “%1”</source>
        <translation>标记“%1”</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>导入来源</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Distance from the path</source>
        <translation>到路径的距离</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Smoother</source>
        <translation>平滑器</translation>
    </message>
    <message>
        <source>Analysed</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>%1, Odograph %2</source>
        <translation>%1，Odograph %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>rate varies</source>
        <translation>帧率不恒定</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>接受…</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation>%1 到 %2，共 %3</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>In millimetres</source>
        <translation>以毫米计</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>What the synchronisation is worth</source>
        <translation>同步的影响</translation>
    </message>
    <message>
        <source>σ of the time anywhere in the recording, of the offset and of the clock rate over its length, times the run&apos;s top speed. The remaining time error τ is that of d² = d₀² + τ²v² between the views&apos; distance d and the speed v: least squares over means of half a second.</source>
        <translation>录像中任一时刻的时间 σ（来自时间差和时钟速率）乘以该次试验的最大速度。剩余时间误差 τ 由视图间距离 d 与速度 v 的关系 d² = d₀² + τ²v² 得出：对半秒均值作最小二乘。</translation>
    </message>
    <message>
        <source>of τ: by the scatter of those means. Blur grows with the speed, too, so τ is at most as stated.</source>
        <translation>τ 的 σ：由这些均值的离散得出。模糊也随速度增大，因此 τ 至多为所示值。</translation>
    </message>
    <message>
        <source>view %1: %2 frames</source>
        <translation>视图 %1：%2 帧</translation>
    </message>
    <message>
        <source>±%1 at the top speed</source>
        <translation>最大速度下 ±%1</translation>
    </message>
    <message>
        <source>%1: never inside</source>
        <translation>%1：从未进入</translation>
    </message>
    <message>
        <source>%1: inside for at least %2</source>
        <translation>%1：在内至少 %2</translation>
    </message>
    <message>
        <source>%1: inside for %2</source>
        <translation>%1：在内 %2</translation>
    </message>
    <message>
        <source>, from the start</source>
        <translation>，从一开始</translation>
    </message>
    <message numerus="yes">
        <source>, entered %n time(s)</source>
        <translation>
            <numerusform>，进入 %n 次</numerusform>
        </translation>
    </message>
    <message>
        <source>, first after %1</source>
        <translation>，首次在 %1 后</translation>
    </message>
</context>
<context>
    <name>TrialReport</name>
    <message>
        <source>class median %1</source>
        <translation>班级中位数 %1</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>运行俯视图</translation>
    </message>
    <message>
        <source>coloured by speed</source>
        <translation>按速度着色</translation>
    </message>
    <message>
        <source>The cameras’ views</source>
        <translation>相机视角</translation>
    </message>
    <message>
        <source>at %1, the top speed</source>
        <translation>在 %1，最大速度时</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>运行经过</translation>
    </message>
    <message>
        <source>It did not move</source>
        <translation>机器人未移动</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>第 %1 次</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>到 %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>± one σ</source>
        <translation>± 一个 σ</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet: it has no metrics.</source>
        <translation>此试验尚未跟踪：没有指标。</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>%1 times in all</source>
        <translation>共 %1 次</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>……另有 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>Bad results: do not use them.</source>
        <translation>结果不可用：请勿使用。</translation>
    </message>
    <message>
        <source>Doubtful results, which were accepted.</source>
        <translation>存疑但已接受的结果。</translation>
    </message>
    <message>
        <source>Doubtful results: read the reasons before you use them.</source>
        <translation>结果存疑：使用前请阅读原因。</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>区间</translation>
    </message>
</context>
<context>
    <name>UncertainIntervals</name>
    <message>
        <source>Which robot? Until %1</source>
        <translation>哪台机器人？至 %1</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1（%2 至 %3）</translation>
    </message>
    <message>
        <source>Not measured until %1</source>
        <translation>至 %1 未测量</translation>
    </message>
    <message>
        <source>not measured (%1 to %2)</source>
        <translation>未测量（%1 至 %2）</translation>
    </message>
</context>
<context>
    <name>VerdictMark</name>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>已接受：%1</translation>
    </message>
    <message>
        <source>all checks passed</source>
        <translation>所有检查均通过</translation>
    </message>
</context>
<context>
    <name>WindowTitle</name>
    <message>
        <source>Team %1</source>
        <translation>小组 %1</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
</context>
<context>
    <name>analysis.a_constant</name>
    <message>
        <source>a constant</source>
        <translation>常数</translation>
    </message>
</context>
<context>
    <name>analysis.a_parabola</name>
    <message>
        <source>a parabola</source>
        <translation>抛物线</translation>
    </message>
</context>
<context>
    <name>analysis.a_straight_line</name>
    <message>
        <source>a straight line</source>
        <translation>直线</translation>
    </message>
</context>
<context>
    <name>analysis.align_by_distance</name>
    <message>
        <source>align by distance</source>
        <translation>请按距离对齐</translation>
    </message>
</context>
<context>
    <name>analysis.align_otherwise</name>
    <message>
        <source>align by motion onset or distance</source>
        <translation>请按运动起点或距离对齐</translation>
    </message>
</context>
<context>
    <name>analysis.check_numbers</name>
    <message>
        <source>check the numbers</source>
        <translation>请检查数字</translation>
    </message>
</context>
<context>
    <name>analysis.choose_another_run</name>
    <message>
        <source>choose another run as well</source>
        <translation>请再选一次运行</translation>
    </message>
</context>
<context>
    <name>analysis.choose_common_place</name>
    <message>
        <source>choose a position that both runs pass</source>
        <translation>请选择两次运行都经过的位置</translation>
    </message>
</context>
<context>
    <name>analysis.choose_figure</name>
    <message>
        <source>choose a metric to score</source>
        <translation>请选择评分对象</translation>
    </message>
</context>
<context>
    <name>analysis.choose_log_of_run</name>
    <message>
        <source>choose the log of this run</source>
        <translation>请选择本次运行的日志</translation>
    </message>
</context>
<context>
    <name>analysis.choose_longer_range</name>
    <message>
        <source>choose a longer range</source>
        <translation>请选择更长的区间</translation>
    </message>
</context>
<context>
    <name>analysis.choose_motion</name>
    <message>
        <source>choose a run with motion</source>
        <translation>请选择有运动的运行</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_direction</name>
    <message>
        <source>choose runs in the same direction</source>
        <translation>请选择方向相同的运行</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_task</name>
    <message>
        <source>choose runs of the same task</source>
        <translation>请选择同一任务的运行</translation>
    </message>
</context>
<context>
    <name>analysis.comparison</name>
    <message>
        <source>comparison</source>
        <translation>比较</translation>
    </message>
</context>
<context>
    <name>analysis.comparison_of</name>
    <message>
        <source>comparison of %1</source>
        <translation>%1 的比较</translation>
    </message>
</context>
<context>
    <name>analysis.corners_in_order</name>
    <message>
        <source>enter the corners in order, all the way round</source>
        <translation>请按顺序绕一圈给出顶点</translation>
    </message>
</context>
<context>
    <name>analysis.corners_off_floor</name>
    <message>
        <source>its corners are not all on a floor of 1 km</source>
        <translation>其顶点不在 1 km 的地面内</translation>
    </message>
</context>
<context>
    <name>analysis.corners_once</name>
    <message>
        <source>enter each corner once</source>
        <translation>每个顶点只给一次</translation>
    </message>
</context>
<context>
    <name>analysis.corners_too_near</name>
    <message>
        <source>two corners are less than 1 mm apart</source>
        <translation>两个顶点相距不足 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.draw_coarsely</name>
    <message>
        <source>draw it with fewer corners</source>
        <translation>请画得粗略些</translation>
    </message>
</context>
<context>
    <name>analysis.ends_off_floor</name>
    <message>
        <source>its ends are not both on a floor of 1 km</source>
        <translation>其端点不在 1 km 的地面内</translation>
    </message>
</context>
<context>
    <name>analysis.ends_too_near</name>
    <message>
        <source>its ends are less than 1 mm apart</source>
        <translation>其端点相距不足 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.few_corners</name>
    <message>
        <source>it has fewer than three corners</source>
        <translation>顶点少于三个</translation>
    </message>
</context>
<context>
    <name>analysis.few_points</name>
    <message>
        <source>it has too few points</source>
        <translation>点太少</translation>
    </message>
</context>
<context>
    <name>analysis.finish_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the finish</source>
        <translation>门“%1”已是终点</translation>
    </message>
</context>
<context>
    <name>analysis.fit_of</name>
    <message>
        <source>fit of %1</source>
        <translation>拟合（%1）</translation>
    </message>
</context>
<context>
    <name>analysis.formula_best_lap</name>
    <message>
        <source>The shortest lap.</source>
        <translation>用时最短的一圈。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_circle_radius</name>
    <message>
        <source>The least-squares circle through the positions of the motion.</source>
        <translation>到运动中各位置的距离平方和最小的圆。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_bias</name>
    <message>
        <source>The mean of the distance from the reference path, to the left positive.</source>
        <translation>到参考路径距离的平均值，偏左为正。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_max</name>
    <message>
        <source>The largest distance from the reference path.</source>
        <translation>到参考路径的最大距离。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_mean</name>
    <message>
        <source>The distance from the reference path, averaged along the path.</source>
        <translation>到参考路径的平均距离，按路程平均。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_rms</name>
    <message>
        <source>√(mean of the squared distance from the reference path), averaged along the path</source>
        <translation>√(到参考路径距离平方的平均值)，按路程平均</translation>
    </message>
</context>
<context>
    <name>analysis.formula_duration</name>
    <message>
        <source>From the onset of motion to the last stop. Moving means faster than three σ of the speed, for at least three frames, and further than noise explains; the moment between two frames is interpolated.</source>
        <translation>从开始运动到最后一次停下。运动是指速度大于速度的三个 σ，持续至少三帧，且移动距离超出噪声所能解释的范围；两帧之间的时刻由插值得出。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_gate_time</name>
    <message>
        <source>From passing the start gate to passing the finish, each interpolated between frames.</source>
        <translation>从通过起点门到通过终点门，各自在帧与帧之间插值。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_laps</name>
    <message>
        <source>Complete laps or runs, counted by the passages of the gates.</source>
        <translation>完整的圈数或运行次数，按通过计时门计数。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_accel</name>
    <message>
        <source>The acceleration |a| of the smoothed curve where |a| − 3σ is largest.</source>
        <translation>平滑曲线上 |a| − 3σ 最大处的加速度 |a|。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_speed</name>
    <message>
        <source>The speed |v| of the smoothed curve where |v| − 3σ is largest. A point does not win only because its uncertainty is large.</source>
        <translation>平滑曲线上 |v| − 3σ 最大处的速度 |v|，这样误差大的点不会因误差而成为最大值。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_turn_rate</name>
    <message>
        <source>How fast the robot turns, to the left or right, where the amount minus 3σ is largest. Of the body where its heading was measured, also on the spot: the rate of the smoothed heading. Elsewhere of the direction of motion: (vx·ay − vy·ax)/|v|² of the smoothed curve. &quot;At least&quot; where it may have turned faster because the rate is hardly known.</source>
        <translation>机器人转动的快慢，左转或右转均可，取其减去 3σ 后最大处。测得机身朝向之处（包括原地转动）取机身的值：平滑朝向的变化率；其余取运动方向的值：平滑曲线的 (vx·ay − vy·ax)/|v|²。若变化率几乎未知、可能转得更快，则标为“至少”。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_lap</name>
    <message>
        <source>The mean of the laps&apos; times.</source>
        <translation>各圈用时的平均值。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_speed</name>
    <message>
        <source>path length / time, both without gaps</source>
        <translation>路程 / 用时，均不含未测量的时段</translation>
    </message>
</context>
<context>
    <name>analysis.formula_median_speed</name>
    <message>
        <source>The speed that half of the time in motion stays below.</source>
        <translation>运动时间的一半低于此速度。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_moving_time</name>
    <message>
        <source>The time in which it moves: faster than three σ of the speed, and further than noise explains.</source>
        <translation>处于运动中的时间：速度大于速度的三个 σ，且移动距离超出噪声所能解释的范围。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_accel</name>
    <message>
        <source>The acceleration that 95 % of the time in motion stays below.</source>
        <translation>运动时间的 95 % 低于此加速度。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_speed</name>
    <message>
        <source>The speed that 95 % of the time in motion stays below.</source>
        <translation>运动时间的 95 % 低于此速度。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_completed</name>
    <message>
        <source>The share of the reference path that the robot followed.</source>
        <translation>参考路径中已走过的比例。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_length</name>
    <message>
        <source>∫|v|dt while it moves, by the trapezoidal rule over the smoothed speed. A gap that is not bridged adds nothing.</source>
        <translation>运动期间的 ∫|v|dt，对平滑后的速度用梯形法计算。未补接的间断不计入。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_accel</name>
    <message>
        <source>√(mean of |a|²) while it moves</source>
        <translation>运动期间的 √(|a|² 的平均值)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_speed</name>
    <message>
        <source>√(mean of |v|²) while it moves</source>
        <translation>运动期间的 √(|v|² 的平均值)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_standing_time</name>
    <message>
        <source>time − time in motion</source>
        <translation>用时 − 运动时间</translation>
    </message>
</context>
<context>
    <name>analysis.formula_stops</name>
    <message>
        <source>The pauses between the onset of motion and the last stop, counted where the robot was measured at rest.</source>
        <translation>从开始运动到最后一次停下之间，测得机器人静止的停顿次数。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_straightness</name>
    <message>
        <source>distance from the first to the last position of the motion / path length</source>
        <translation>运动的起点到终点的距离 / 路程</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_breaches</name>
    <message>
        <source>How often the robot&apos;s reference point left a zone to stay in or entered a zone to keep out of. It counts if the point is beyond the edge by more than six σ of the track&apos;s noise.</source>
        <translation>机器人中心离开应留区域或进入禁入区域的次数。超出边界多于轨迹自身噪声的六个 σ 时才计入。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_depth</name>
    <message>
        <source>The largest distance of the robot&apos;s reference point beyond the edge of a zone.</source>
        <translation>机器人中心超出区域边界的最大距离。</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_time</name>
    <message>
        <source>The time for which the robot&apos;s reference point was beyond the edge of a zone, interpolated between frames; in two zones at once it counts twice.</source>
        <translation>机器人中心超出区域边界的时间，帧与帧之间插值；同时涉及两个区域时计两次。</translation>
    </message>
</context>
<context>
    <name>analysis.gate</name>
    <message>
        <source>gate &apos;%1&apos;</source>
        <translation>计时门“%1”</translation>
    </message>
</context>
<context>
    <name>analysis.give_another_number</name>
    <message>
        <source>choose another number</source>
        <translation>请给出另一个数字</translation>
    </message>
</context>
<context>
    <name>analysis.give_corners</name>
    <message>
        <source>enter the corners of its outline, all the way round</source>
        <translation>请绕一圈给出其轮廓的顶点</translation>
    </message>
</context>
<context>
    <name>analysis.give_ends</name>
    <message>
        <source>enter the two ends of the line that the robot passes</source>
        <translation>请给出需通过的线的两个端点</translation>
    </message>
</context>
<context>
    <name>analysis.give_limits</name>
    <message>
        <source>enter the largest speed and acceleration that a robot can reach in the task</source>
        <translation>请给出任务中机器人可能的最大速度和加速度</translation>
    </message>
</context>
<context>
    <name>analysis.give_log_offset</name>
    <message>
        <source>give the time offset of the log</source>
        <translation>请给出日志的时间偏移</translation>
    </message>
</context>
<context>
    <name>analysis.give_place</name>
    <message>
        <source>enter its position in millimetres</source>
        <translation>请以毫米给出其位置</translation>
    </message>
</context>
<context>
    <name>analysis.give_points</name>
    <message>
        <source>enter points from 1 to 1000; use a negative number for a penalty</source>
        <translation>请给出 1 到 1000 的分数，扣分用负数</translation>
    </message>
</context>
<context>
    <name>analysis.give_sizes</name>
    <message>
        <source>enter the sizes in millimetres</source>
        <translation>请以毫米给出尺寸</translation>
    </message>
</context>
<context>
    <name>analysis.give_three_numbers</name>
    <message>
        <source>enter three numbers</source>
        <translation>请给出三个数字</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_points</name>
    <message>
        <source>enter at least two points, or three for a closed path</source>
        <translation>请给出两个或以上的点，闭合路径需三个</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_values</name>
    <message>
        <source>enter two different values; the points rise between them</source>
        <translation>请给出两个数值，分数在其间上升</translation>
    </message>
</context>
<context>
    <name>analysis.join_zones</name>
    <message>
        <source>merge neighbouring zones</source>
        <translation>请合并相邻的区域</translation>
    </message>
</context>
<context>
    <name>analysis.keep_what_matters</name>
    <message>
        <source>keep those that matter</source>
        <translation>请保留重要的</translation>
    </message>
</context>
<context>
    <name>analysis.limit_not_positive</name>
    <message>
        <source>a limit is zero or negative</source>
        <translation>限值不大于零</translation>
    </message>
</context>
<context>
    <name>analysis.limits</name>
    <message>
        <source>limits of a task</source>
        <translation>任务的限值</translation>
    </message>
</context>
<context>
    <name>analysis.line_of_scoring</name>
    <message>
        <source>line %1 of the scoring</source>
        <translation>评分的第 %1 行</translation>
    </message>
</context>
<context>
    <name>analysis.little_motion</name>
    <message>
        <source>the robot hardly moves in %1</source>
        <translation>机器人在 %1 中几乎没有移动</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_no_common_time</name>
    <message>
        <source>fewer than %1 of its positions have times at which the robot was measured</source>
        <translation>其位置中少于 %1 个处于机器人被测量的时刻</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_front</name>
    <message>
        <source>the log&apos;s heading is %1 from the measured one throughout: its front or its axes may differ</source>
        <translation>日志的朝向始终与测得的相差 %1：其前方或坐标轴可能不同</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_lengths</name>
    <message>
        <source>the log&apos;s lengths are %1 times the measured ones: its unit may be wrong</source>
        <translation>日志中的长度是测得长度的 %1 倍：其单位可能有误</translation>
    </message>
</context>
<context>
    <name>analysis.log_is_mirrored</name>
    <message>
        <source>it is the mirror image of the run</source>
        <translation>它是本次运行的镜像</translation>
    </message>
</context>
<context>
    <name>analysis.log_moves_otherwise</name>
    <message>
        <source>it moves differently: at no time offset do more than %1 of the changes of speed and direction agree</source>
        <translation>其运动不同：在任何时间偏移下，速度和方向的变化一致的部分都不超过 %1</translation>
    </message>
</context>
<context>
    <name>analysis.many_corners</name>
    <message>
        <source>it has more than %1 corners</source>
        <translation>顶点超过 %1 个</translation>
    </message>
</context>
<context>
    <name>analysis.many_lines</name>
    <message>
        <source>it has more than %1 lines</source>
        <translation>超过 %1 行</translation>
    </message>
</context>
<context>
    <name>analysis.many_points</name>
    <message>
        <source>it has more than %1 points</source>
        <translation>点数超过 %1</translation>
    </message>
</context>
<context>
    <name>analysis.many_zones</name>
    <message>
        <source>the task already has %1 zones</source>
        <translation>任务已有 %1 个区域</translation>
    </message>
</context>
<context>
    <name>analysis.metric_best_lap</name>
    <message>
        <source>Best lap</source>
        <translation>最快圈</translation>
    </message>
</context>
<context>
    <name>analysis.metric_circle_radius</name>
    <message>
        <source>Circle&apos;s radius</source>
        <translation>圆的半径</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_bias</name>
    <message>
        <source>Left of the path</source>
        <translation>路径偏左</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_max</name>
    <message>
        <source>Off the path (most)</source>
        <translation>路径偏离（最大）</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_mean</name>
    <message>
        <source>Off the path (mean)</source>
        <translation>路径偏离（平均）</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_rms</name>
    <message>
        <source>Off the path (RMS)</source>
        <translation>路径偏离 (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_displacement</name>
    <message>
        <source>Displacement</source>
        <translation>位移</translation>
    </message>
</context>
<context>
    <name>analysis.metric_duration</name>
    <message>
        <source>Time</source>
        <translation>用时</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gate_time</name>
    <message>
        <source>Start to finish</source>
        <translation>起点到终点</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gates_passed</name>
    <message>
        <source>Gates passed</source>
        <translation>通过的计时门</translation>
    </message>
</context>
<context>
    <name>analysis.metric_height</name>
    <message>
        <source>Robot&apos;s height</source>
        <translation>机器人高度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_laps</name>
    <message>
        <source>Laps</source>
        <translation>圈数</translation>
    </message>
</context>
<context>
    <name>analysis.metric_limit_breaches</name>
    <message>
        <source>Limits broken</source>
        <translation>超限次数</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_accel</name>
    <message>
        <source>Top acceleration</source>
        <translation>最大加速度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_speed</name>
    <message>
        <source>Top speed</source>
        <translation>最大速度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_turn_rate</name>
    <message>
        <source>Fastest turn</source>
        <translation>最大转向角速度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_lap</name>
    <message>
        <source>Mean lap</source>
        <translation>平均圈时</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_speed</name>
    <message>
        <source>Mean speed</source>
        <translation>平均速度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_view_disagreement</name>
    <message>
        <source>Views disagree by</source>
        <translation>视角差异</translation>
    </message>
</context>
<context>
    <name>analysis.metric_median_speed</name>
    <message>
        <source>Median speed</source>
        <translation>速度中位数</translation>
    </message>
</context>
<context>
    <name>analysis.metric_moving_time</name>
    <message>
        <source>Time in motion</source>
        <translation>运动时间</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_accel</name>
    <message>
        <source>P95 acceleration</source>
        <translation>加速度 (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_speed</name>
    <message>
        <source>P95 speed</source>
        <translation>速度 (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_completed</name>
    <message>
        <source>Path completed</source>
        <translation>路径完成度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_length</name>
    <message>
        <source>Path</source>
        <translation>路程</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_accel</name>
    <message>
        <source>Acceleration (RMS)</source>
        <translation>加速度 (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_speed</name>
    <message>
        <source>Speed (RMS)</source>
        <translation>速度 (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_score</name>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
</context>
<context>
    <name>analysis.metric_spikes</name>
    <message>
        <source>Spikes</source>
        <translation>异常点</translation>
    </message>
</context>
<context>
    <name>analysis.metric_standing_time</name>
    <message>
        <source>Standing time</source>
        <translation>静止时间</translation>
    </message>
</context>
<context>
    <name>analysis.metric_stops</name>
    <message>
        <source>Stops</source>
        <translation>停车次数</translation>
    </message>
</context>
<context>
    <name>analysis.metric_straightness</name>
    <message>
        <source>Straightness</source>
        <translation>直线度</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_breaches</name>
    <message>
        <source>Zones broken</source>
        <translation>越界次数</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_depth</name>
    <message>
        <source>Beyond zones (most)</source>
        <translation>最大越界距离</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_time</name>
    <message>
        <source>Time beyond zones</source>
        <translation>越界时间</translation>
    </message>
</context>
<context>
    <name>analysis.moment_outside</name>
    <message>
        <source>the moment entered for %1 is outside that run</source>
        <translation>为 %1 指定的时刻在其范围之外</translation>
    </message>
</context>
<context>
    <name>analysis.moments_missing</name>
    <message>
        <source>aligning runs by hand needs a moment in each run</source>
        <translation>手动对齐需要每次运行的一个时刻</translation>
    </message>
</context>
<context>
    <name>analysis.motion_gives_no_offset</name>
    <message>
        <source>the robot never changes its speed or its curvature by more than noise, so any time offset fits</source>
        <translation>机器人的速度和曲率变化从未超过噪声，因此任何时间偏移都符合</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_gate</name>
    <message>
        <source>give each gate a name of its own</source>
        <translation>请给每个门各自的名称</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_zone</name>
    <message>
        <source>give each zone a name of its own</source>
        <translation>请给每个区域各自的名称</translation>
    </message>
</context>
<context>
    <name>analysis.name_twice</name>
    <message>
        <source>the name is used twice</source>
        <translation>名称出现两次</translation>
    </message>
</context>
<context>
    <name>analysis.no_figure</name>
    <message>
        <source>it names no metric</source>
        <translation>没有指定指标</translation>
    </message>
</context>
<context>
    <name>analysis.no_motion</name>
    <message>
        <source>the robot does not move in %1</source>
        <translation>机器人在 %1 中没有移动</translation>
    </message>
</context>
<context>
    <name>analysis.no_onset</name>
    <message>
        <source>the robot of %1 is already moving when it is first seen</source>
        <translation>%1 的机器人首次出现时已在行驶</translation>
    </message>
</context>
<context>
    <name>analysis.no_start_gate</name>
    <message>
        <source>%1 does not pass a start gate</source>
        <translation>%1 没有通过起点门</translation>
    </message>
</context>
<context>
    <name>analysis.no_step_of_delta</name>
    <message>
        <source>no stretch of %1 was measured without a gap, so there is no relative error</source>
        <translation>没有一段 %1 的路程是无间断测得的，因此没有相对误差</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_role</name>
    <message>
        <source>gates have no such role</source>
        <translation>没有这样的角色</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_rule</name>
    <message>
        <source>zones have no such rule</source>
        <translation>没有这样的区域规则</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_template</name>
    <message>
        <source>no template has this name</source>
        <translation>没有这样的模板</translation>
    </message>
</context>
<context>
    <name>analysis.not_on_tasks_path</name>
    <message>
        <source>%1 shares no part of its path with the task&apos;s path</source>
        <translation>%1 与任务路径没有共同路段</translation>
    </message>
</context>
<context>
    <name>analysis.not_seen_there</name>
    <message>
        <source>%1 was not seen at the position used for alignment</source>
        <translation>%1 在对齐位置没有被看到</translation>
    </message>
</context>
<context>
    <name>analysis.nothing_in_common</name>
    <message>
        <source>%1 shares no part of its path with %2</source>
        <translation>%1 与 %2 没有共同路段</translation>
    </message>
</context>
<context>
    <name>analysis.number_is_none</name>
    <message>
        <source>one of its values is not a number</source>
        <translation>其中有一个不是数字</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_ambiguous</name>
    <message>
        <source>its motion repeats itself: time offsets %1 apart agree equally well</source>
        <translation>其运动有重复：相差 %1 的时间偏移同样吻合</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_uncertain</name>
    <message>
        <source>its time offset is known only to ±%1</source>
        <translation>其时间偏移只能确定到 ±%1</translation>
    </message>
</context>
<context>
    <name>analysis.offset_not_found</name>
    <message>
        <source>too little of its motion is also in the run to find the time offset</source>
        <translation>与本次运行重合的运动太少，无法求出时间偏移</translation>
    </message>
</context>
<context>
    <name>analysis.one_point_too_few</name>
    <message>
        <source>%1 point is too few for it</source>
        <translation>%1 个点太少</translation>
    </message>
</context>
<context>
    <name>analysis.one_start_and_finish</name>
    <message>
        <source>keep one start and one finish, or one gate with the role start_finish</source>
        <translation>请保留一个起点和一个终点，或一个兼作两者的门</translation>
    </message>
</context>
<context>
    <name>analysis.other_direction</name>
    <message>
        <source>%1 runs in the opposite direction to %2</source>
        <translation>%1 的行驶方向与 %2 相反</translation>
    </message>
</context>
<context>
    <name>analysis.outline_crosses</name>
    <message>
        <source>its outline crosses itself</source>
        <translation>其轮廓自相交叉</translation>
    </message>
</context>
<context>
    <name>analysis.path_too_short</name>
    <message>
        <source>it is shorter than 1 mm</source>
        <translation>短于 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.place_no_number</name>
    <message>
        <source>its position is not a number</source>
        <translation>其位置不是数字</translation>
    </message>
</context>
<context>
    <name>analysis.points_off_floor</name>
    <message>
        <source>its points are not all on a floor of 1 km</source>
        <translation>其点不在 1 km 的地面内</translation>
    </message>
</context>
<context>
    <name>analysis.points_out_of_range</name>
    <message>
        <source>its points are 0 or beyond ±1000</source>
        <translation>分数为 0 或超过 1000</translation>
    </message>
</context>
<context>
    <name>analysis.points_too_few</name>
    <message>
        <source>%1 points are too few for it</source>
        <translation>%1 个点不够</translation>
    </message>
</context>
<context>
    <name>analysis.reference_path</name>
    <message>
        <source>reference path</source>
        <translation>参考路径</translation>
    </message>
</context>
<context>
    <name>analysis.role</name>
    <message>
        <source>role &apos;%1&apos;</source>
        <translation>角色“%1”</translation>
    </message>
</context>
<context>
    <name>analysis.rule</name>
    <message>
        <source>rule &apos;%1&apos;</source>
        <translation>规则“%1”</translation>
    </message>
</context>
<context>
    <name>analysis.same_values</name>
    <message>
        <source>full points and no points have the same value</source>
        <translation>满分与零分对应同一数值</translation>
    </message>
</context>
<context>
    <name>analysis.sample_coarsely</name>
    <message>
        <source>sample it with fewer points</source>
        <translation>请取更稀疏的点</translation>
    </message>
</context>
<context>
    <name>analysis.scoring</name>
    <message>
        <source>scoring</source>
        <translation>评分</translation>
    </message>
</context>
<context>
    <name>analysis.size_too_small</name>
    <message>
        <source>a size is less than 1 mm</source>
        <translation>某个尺寸小于 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.start_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the start</source>
        <translation>门“%1”已是起点</translation>
    </message>
</context>
<context>
    <name>analysis.still_in_common_time</name>
    <message>
        <source>the robot does not move in the common time</source>
        <translation>在共同的时间内机器人没有移动</translation>
    </message>
</context>
<context>
    <name>analysis.takes_two_runs</name>
    <message>
        <source>it needs two runs</source>
        <translation>需要两次运行</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moment_inside</name>
    <message>
        <source>enter one between its first and last frame</source>
        <translation>请指定首帧与末帧之间的时刻</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moments</name>
    <message>
        <source>enter one for each run</source>
        <translation>请为每次运行指定一个</translation>
    </message>
</context>
<context>
    <name>analysis.template</name>
    <message>
        <source>template &apos;%1&apos;</source>
        <translation>模板“%1”</translation>
    </message>
</context>
<context>
    <name>analysis.template_of_task</name>
    <message>
        <source>template of a task</source>
        <translation>任务的模板</translation>
    </message>
</context>
<context>
    <name>analysis.turn_sign</name>
    <message>
        <source>change the sign of one of its coordinates</source>
        <translation>请改变其中一个坐标的符号</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_best_lap</name>
    <message>
        <source>of its two passages; the calibration uncertainty of a gate passed twice cancels</source>
        <translation>两次通过的误差；同一计时门通过两次，标定误差相互抵消</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_circle_radius</name>
    <message>
        <source>of the scatter of the distances, with their number divided by 1 + 2Σρ for correlated neighbours, and the calibration&apos;s scale uncertainty</source>
        <translation>距离离散的误差，相邻点因相关而按 1 + 2Σρ 折减个数；以及标定的尺度误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_correlated</name>
    <message>
        <source>the bound for fully correlated errors, and the calibration&apos;s scale uncertainty</source>
        <translation>所有误差同向时的上限，以及标定的尺度误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_bias</name>
    <message>
        <source>of the position across the path, mostly the calibration&apos;s</source>
        <translation>垂直于路径方向位置的误差，主要来自标定</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_max</name>
    <message>
        <source>of the position across the path, there</source>
        <translation>该处垂直于路径方向位置的误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_mean</name>
    <message>
        <source>of the position across the path, and of its noise: the distance has no sign, so noise does not cancel</source>
        <translation>垂直于路径方向位置的误差，以及其噪声（在此不分正负）的误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_rms</name>
    <message>
        <source>of the position across the path</source>
        <translation>垂直于路径方向位置的误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_duration</name>
    <message>
        <source>of both moments: σ of the speed divided by its slope there, and how far smoothing blurs them</source>
        <translation>两个时刻的误差：速度的 σ 除以速度曲线在该处的斜率，以及平滑造成的模糊</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_gate_time</name>
    <message>
        <source>of both passages: σ of the position across the gate divided by the speed</source>
        <translation>两次通过的误差：垂直于计时门方向位置的 σ 除以速度</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_max_turn_rate</name>
    <message>
        <source>of the body: that of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order; of n peaks within 2σ also σ√(2 ln n)</source>
        <translation>机身：平滑朝向变化率的不确定度；运动方向：σ² = σa²/|v|² + |a|²σv²/|v|⁴，一阶近似；2σ 以内有 n 个峰时，另加 σ√(2 ln n)</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_lap</name>
    <message>
        <source>of the first and the last passage, over the number of laps</source>
        <translation>首次和末次通过的误差除以圈数</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_speed</name>
    <message>
        <source>of both, treated as independent, and of gaps: from straight through them to the top speed in them</source>
        <translation>两者的误差（视为相互独立），以及未测量时段的不确定度：从直线通过到一直以最高速度行驶</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_moving_time</name>
    <message>
        <source>of each start and stop: σ of the speed divided by its slope</source>
        <translation>每次起动和停下的误差：速度的 σ 除以速度曲线的斜率</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_curve</name>
    <message>
        <source>that of the smoothed curve there; how far the largest of n equal values exceeds them, σ√(2 ln n) at most, of the n peaks within 2σ; and the calibration&apos;s scale uncertainty</source>
        <translation>平滑曲线在该处的误差；n 个相等值中最大者超出它们的量（2σ 以内有 n 个峰，至多 σ√(2 ln n)）；以及标定的尺度误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_intervals</name>
    <message>
        <source>of the intervals within 1.5 σ of it, each by its mean</source>
        <translation>与其相差不到 1.5 σ 的各段的误差，每段取平均值</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_path_length</name>
    <message>
        <source>of the end positions, of lateral errors where the path turns, of what the robot could have done where it was bridged, and the calibration&apos;s scale uncertainty</source>
        <translation>两端位置的误差、转弯处垂直于路径方向的误差、机器人在插补时段内可能的运动，以及标定的尺度误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_standing_time</name>
    <message>
        <source>of each start and stop</source>
        <translation>每次起动和停下的误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_straightness</name>
    <message>
        <source>of the end positions</source>
        <translation>两端位置的误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_depth</name>
    <message>
        <source>of the position across the edge, there</source>
        <translation>该处垂直于边界方向位置的误差</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_time</name>
    <message>
        <source>of each crossing of an edge: σ of the position across it divided by the speed; and the change of the time when the calibration uncertainty shifts the track</source>
        <translation>每个越界时刻的误差：垂直于边界方向位置的 σ 除以速度；以及标定使轨迹移近或移远时该时间的变化</translation>
    </message>
</context>
<context>
    <name>analysis.use_a_rule</name>
    <message>
        <source>use stay_inside or stay_outside</source>
        <translation>请使用 stay_inside 或 stay_outside</translation>
    </message>
</context>
<context>
    <name>analysis.use_one_of</name>
    <message>
        <source>use %1</source>
        <translation>请使用 %1</translation>
    </message>
</context>
<context>
    <name>analysis.wrong_poles</name>
    <message>
        <source>a slalom has 1 to 100 poles, not %1</source>
        <translation>回转赛道有 1 到 100 根杆，而非 %1</translation>
    </message>
</context>
<context>
    <name>analysis.zone</name>
    <message>
        <source>zone &apos;%1&apos;</source>
        <translation>区域“%1”</translation>
    </message>
</context>
<context>
    <name>backup.disk_nearly_full</name>
    <message>
        <source>the disk has only %1 left</source>
        <translation>磁盘只剩 %1</translation>
    </message>
</context>
<context>
    <name>backup.of_project</name>
    <message>
        <source>backup of &apos;%1&apos;</source>
        <translation>“%1”的备份</translation>
    </message>
</context>
<context>
    <name>base.and</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
</context>
<context>
    <name>base.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>相机“%1”</translation>
    </message>
</context>
<context>
    <name>base.cancelled</name>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
</context>
<context>
    <name>base.cannot_do_this</name>
    <message>
        <source>cannot do this</source>
        <translation>无法执行此操作</translation>
    </message>
</context>
<context>
    <name>base.class</name>
    <message>
        <source>class &apos;%1&apos;</source>
        <translation>班级“%1”</translation>
    </message>
</context>
<context>
    <name>base.close_other_programs</name>
    <message>
        <source>close other programs and try again</source>
        <translation>请关闭其他程序后重试</translation>
    </message>
</context>
<context>
    <name>base.colon</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>base.colour</name>
    <message>
        <source>colour &apos;%1&apos;</source>
        <translation>颜色“%1”</translation>
    </message>
</context>
<context>
    <name>base.comma</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>base.file</name>
    <message>
        <source>file &apos;%1&apos;</source>
        <translation>文件“%1”</translation>
    </message>
</context>
<context>
    <name>base.foreign</name>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
</context>
<context>
    <name>base.is_device</name>
    <message>
        <source>it is a device</source>
        <translation>是设备</translation>
    </message>
</context>
<context>
    <name>base.is_folder</name>
    <message>
        <source>it is a folder</source>
        <translation>是文件夹</translation>
    </message>
</context>
<context>
    <name>base.is_pipe</name>
    <message>
        <source>it is a named pipe</source>
        <translation>是命名管道</translation>
    </message>
</context>
<context>
    <name>base.is_socket</name>
    <message>
        <source>it is a socket</source>
        <translation>是套接字</translation>
    </message>
</context>
<context>
    <name>base.layout</name>
    <message>
        <source>layout &apos;%1&apos;</source>
        <translation>布局“%1”</translation>
    </message>
</context>
<context>
    <name>base.length</name>
    <message>
        <source>length &apos;%1&apos;</source>
        <translation>长度“%1”</translation>
    </message>
</context>
<context>
    <name>base.name</name>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
</context>
<context>
    <name>base.no_colour</name>
    <message>
        <source>not of the form #rrggbb</source>
        <translation>不是 #rrggbb 形式</translation>
    </message>
</context>
<context>
    <name>base.no_files</name>
    <message>
        <source>too many files are open</source>
        <translation>打开的文件太多</translation>
    </message>
</context>
<context>
    <name>base.no_length</name>
    <message>
        <source>not a number with the unit mm, cm or m</source>
        <translation>不是带单位 mm、cm 或 m 的数字</translation>
    </message>
</context>
<context>
    <name>base.no_memory</name>
    <message>
        <source>this computer does not have enough free memory for it</source>
        <translation>这台计算机没有足够的可用内存</translation>
    </message>
</context>
<context>
    <name>base.no_number</name>
    <message>
        <source>not a finite decimal number</source>
        <translation>不是有限的十进制数</translation>
    </message>
</context>
<context>
    <name>base.no_thread</name>
    <message>
        <source>this computer cannot start another thread</source>
        <translation>这台计算机无法再创建线程</translation>
    </message>
</context>
<context>
    <name>base.none</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>base.nothing_changed</name>
    <message>
        <source>nothing was changed</source>
        <translation>没有任何更改</translation>
    </message>
</context>
<context>
    <name>base.number</name>
    <message>
        <source>number &apos;%1&apos;</source>
        <translation>数字“%1”</translation>
    </message>
</context>
<context>
    <name>base.or</name>
    <message>
        <source>%1 or %2</source>
        <translation>%1 或 %2</translation>
    </message>
</context>
<context>
    <name>base.quoted_name</name>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>&apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.robot</name>
    <message>
        <source>robot &apos;%1&apos;</source>
        <translation>机器人“%1”</translation>
    </message>
</context>
<context>
    <name>base.robot_in_trial</name>
    <message>
        <source>robot &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>试验“%2”中的机器人“%1”</translation>
    </message>
</context>
<context>
    <name>base.saved_is_safe</name>
    <message>
        <source>what was saved is safe</source>
        <translation>已保存的内容是安全的</translation>
    </message>
</context>
<context>
    <name>base.semicolon</name>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>base.space</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>base.task</name>
    <message>
        <source>task &apos;%1&apos;</source>
        <translation>任务“%1”</translation>
    </message>
</context>
<context>
    <name>base.team</name>
    <message>
        <source>team &apos;%1&apos;</source>
        <translation>小组“%1”</translation>
    </message>
</context>
<context>
    <name>base.trial</name>
    <message>
        <source>trial &apos;%1&apos;</source>
        <translation>试验“%1”</translation>
    </message>
</context>
<context>
    <name>base.try_again_and_report</name>
    <message>
        <source>try again, and report it if it happens again</source>
        <translation>请重试；如再次发生请报告</translation>
    </message>
</context>
<context>
    <name>base.unexpected</name>
    <message>
        <source>something unexpected happened (%1)</source>
        <translation>发生了意外情况（%1）</translation>
    </message>
</context>
<context>
    <name>base.view_in_trial</name>
    <message>
        <source>view &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>试验“%2”中的视角“%1”</translation>
    </message>
</context>
<context>
    <name>base.wordless_exception</name>
    <message>
        <source>an unknown exception</source>
        <translation>没有文字说明的程序异常</translation>
    </message>
</context>
<context>
    <name>base.write_colour</name>
    <message>
        <source>write it like #d72328</source>
        <translation>请写成 #d72328 的形式</translation>
    </message>
</context>
<context>
    <name>base.write_length</name>
    <message>
        <source>write it like 25mm, 2.5cm or 0.3m</source>
        <translation>请写成 25mm、2.5cm 或 0.3m 的形式</translation>
    </message>
</context>
<context>
    <name>base.write_number</name>
    <message>
        <source>write it with digits and a point, like 12.5</source>
        <translation>请用数字和小数点书写，如 12.5</translation>
    </message>
</context>
<context>
    <name>calibration.add_floor_points</name>
    <message>
        <source>add floor points, such as corners of tiles</source>
        <translation>请增加地面上的点，如地砖的角</translation>
    </message>
</context>
<context>
    <name>calibration.all_agree</name>
    <message>
        <source>The markers and the cameras agree with each other.</source>
        <translation>标记与相机彼此一致。</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed</name>
    <message>
        <source>The world axes were changed afterwards.</source>
        <translation>之后更改过世界坐标轴。</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed_and_scaled</name>
    <message>
        <source>The world axes were changed afterwards, and all lengths multiplied by %1.</source>
        <translation>之后更改过世界坐标轴，并把所有长度乘以 %1。</translation>
    </message>
</context>
<context>
    <name>calibration.axes_no_number</name>
    <message>
        <source>the origin or the angle is not a finite number</source>
        <translation>原点或角度不是有限数</translation>
    </message>
</context>
<context>
    <name>calibration.axes_not_changed</name>
    <message>
        <source>the axes of layout &apos;%1&apos; cannot be changed</source>
        <translation>无法更改布局“%1”的坐标轴</translation>
    </message>
</context>
<context>
    <name>calibration.best_place</name>
    <message>
        <source>the best camera position</source>
        <translation>相机的最佳位置</translation>
    </message>
</context>
<context>
    <name>calibration.board_blurred</name>
    <message>
        <source>the board is blurred</source>
        <translation>标定板模糊</translation>
    </message>
</context>
<context>
    <name>calibration.board_cut_off</name>
    <message>
        <source>the board is cut off</source>
        <translation>标定板被截断</translation>
    </message>
</context>
<context>
    <name>calibration.board_fills</name>
    <message>
        <source>it fills %1 of the image</source>
        <translation>仅占画面的 %1</translation>
    </message>
</context>
<context>
    <name>calibration.board_in_one_place</name>
    <message>
        <source>all %1 images show the board in one position, the %2 %3 of the image</source>
        <translation>全部 %1 张图片中标定板都在同一处（%2，占画面 %3）</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_flat</name>
    <message>
        <source>the corners do not match a flat board</source>
        <translation>角点的位置不像在平整的标定板上</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_sharp</name>
    <message>
        <source>the board is not sharp</source>
        <translation>标定板不清晰</translation>
    </message>
</context>
<context>
    <name>calibration.board_of_other_size</name>
    <message>
        <source>this board has %1 inner corners, not %2</source>
        <translation>此标定板有 %1 个内角点，要求的是 %2</translation>
    </message>
</context>
<context>
    <name>calibration.board_part_seen</name>
    <message>
        <source>only %1 of its %2 inner corners are visible</source>
        <translation>%2 个内角点中只看到 %1 个</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_before</name>
    <message>
        <source>the board is in the same position as in an earlier image</source>
        <translation>标定板的姿态与已拍的图片相同</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_in</name>
    <message>
        <source>the board is in the same position as in %1</source>
        <translation>标定板的姿态与 %1 中相同</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_oblique</name>
    <message>
        <source>the board is tilted too far, by %1 degrees</source>
        <translation>标定板过于倾斜，为 %1 度</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_small</name>
    <message>
        <source>the board is too small</source>
        <translation>标定板太小</translation>
    </message>
</context>
<context>
    <name>calibration.calibrate_to_rely</name>
    <message>
        <source>Calibrate it for reliable positions.</source>
        <translation>请标定它以得到可靠的位置。</translation>
    </message>
</context>
<context>
    <name>calibration.camera_alone_says</name>
    <message>
        <source>Camera &apos;%1&apos; alone measures %2</source>
        <translation>相机“%1”单独给出 %2</translation>
    </message>
</context>
<context>
    <name>calibration.camera_below_floor</name>
    <message>
        <source>in this order the camera would be below the floor</source>
        <translation>按此顺序相机将位于地面以下</translation>
    </message>
</context>
<context>
    <name>calibration.camera_moved</name>
    <message>
        <source>%1 has moved %2 = %3</source>
        <translation>%1 移动了 %2 = %3</translation>
    </message>
</context>
<context>
    <name>calibration.camera_not_moved</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>相机“%1”</translation>
    </message>
</context>
<context>
    <name>calibration.camera_positions</name>
    <message>
        <source>the camera positions</source>
        <translation>相机位置</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_elsewhere</name>
    <message>
        <source>%1 sees %2 %3 from where the others see it</source>
        <translation>%1 看到的 %2 与其他相机相差 %3</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_too_few</name>
    <message>
        <source>camera &apos;%1&apos; sees only %2 of the markers</source>
        <translation>相机“%1”只看到 %2 个标记</translation>
    </message>
</context>
<context>
    <name>calibration.camera_stands_low</name>
    <message>
        <source>The camera would be only %1 above the floor</source>
        <translation>相机距地面只有 %1</translation>
    </message>
</context>
<context>
    <name>calibration.camera_still</name>
    <message>
        <source>%1 has not moved</source>
        <translation>%1 仍在配准时的位置</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_high</name>
    <message>
        <source>the camera would be %1 above the floor</source>
        <translation>相机距地面将有 %1</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_low</name>
    <message>
        <source>the camera would be only %1 above the floor</source>
        <translation>相机距地面只有 %1</translation>
    </message>
</context>
<context>
    <name>calibration.camera_twice</name>
    <message>
        <source>camera &apos;%1&apos; appears twice</source>
        <translation>相机“%1”出现两次</translation>
    </message>
</context>
<context>
    <name>calibration.camera_upside_down</name>
    <message>
        <source>The camera would be upside down</source>
        <translation>摄像机将是倒置的</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_of_one_image</name>
    <message>
        <source>%1 and %2 have the same pixels and count as one camera.</source>
        <translation>%1 和 %2 的像素相同，按一台相机计算。</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_undetermined</name>
    <message>
        <source>the markers do not determine the camera positions</source>
        <translation>这些标记无法确定相机位置</translation>
    </message>
</context>
<context>
    <name>calibration.cannot_be_calibrated</name>
    <message>
        <source>the camera cannot be calibrated</source>
        <translation>无法标定相机</translation>
    </message>
</context>
<context>
    <name>calibration.centimetres</name>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
</context>
<context>
    <name>calibration.centre_is_off</name>
    <message>
        <source>The optical centre is %1 off the image&apos;s middle</source>
        <translation>光学中心偏离图像中心 %1</translation>
    </message>
</context>
<context>
    <name>calibration.check_all</name>
    <message>
        <source>check the layout, the labels and the intrinsics</source>
        <translation>请检查布局、标号和内参</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_lenses</name>
    <message>
        <source>check its pixels and the intrinsics of both cameras</source>
        <translation>请检查其像素和两台相机的内参</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_pixels</name>
    <message>
        <source>check its pixels in both images</source>
        <translation>请检查它在两个画面中的像素</translation>
    </message>
</context>
<context>
    <name>calibration.check_columns</name>
    <message>
        <source>check which columns belong to which camera</source>
        <translation>请检查哪些列属于哪台相机</translation>
    </message>
</context>
<context>
    <name>calibration.check_first_registration</name>
    <message>
        <source>check the registration of %1 and the pair</source>
        <translation>请检查 %1 的配准和这对相机</translation>
    </message>
</context>
<context>
    <name>calibration.check_labels</name>
    <message>
        <source>check these labels</source>
        <translation>请检查这些标号</translation>
    </message>
</context>
<context>
    <name>calibration.check_layout_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, cover other round objects, or mark the markers by hand</source>
        <translation>请检查布局的位置和单位，遮住其他圆形物，或手动标出标记</translation>
    </message>
</context>
<context>
    <name>calibration.check_length</name>
    <message>
        <source>Check the length itself, that it is on the floor, and the marker positions.</source>
        <translation>请检查长度本身、它是否在地面上以及标记的位置。</translation>
    </message>
</context>
<context>
    <name>calibration.check_one_camera</name>
    <message>
        <source>check that all are of one camera, at one zoom and focus</source>
        <translation>请检查都来自同一相机、同一变焦与对焦</translation>
    </message>
</context>
<context>
    <name>calibration.check_pictures</name>
    <message>
        <source>check that all images are sharp, of one flat board and of one camera at one zoom and focus</source>
        <translation>请检查所有图片清晰，且为同一块平整标定板、同一相机、同一变焦与对焦</translation>
    </message>
</context>
<context>
    <name>calibration.check_pixel_and_lens</name>
    <message>
        <source>check its pixel and the camera&apos;s intrinsics</source>
        <translation>请检查其像素和相机内参</translation>
    </message>
</context>
<context>
    <name>calibration.check_place_and_pixel</name>
    <message>
        <source>check its position and its pixel</source>
        <translation>请检查其位置和像素</translation>
    </message>
</context>
<context>
    <name>calibration.check_point_labels</name>
    <message>
        <source>check which label belongs to which point in %1 and in this camera</source>
        <translation>请检查 %1 与本相机中标号和点的对应</translation>
    </message>
</context>
<context>
    <name>calibration.check_signs</name>
    <message>
        <source>check the signs of the layout</source>
        <translation>请检查布局的正负号</translation>
    </message>
</context>
<context>
    <name>calibration.check_tag_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, or mark the markers by hand</source>
        <translation>请检查布局的位置及其单位，或手动标出标记</translation>
    </message>
</context>
<context>
    <name>calibration.check_unit</name>
    <message>
        <source>check the unit of the layout</source>
        <translation>请检查布局的单位</translation>
    </message>
</context>
<context>
    <name>calibration.checking_halves</name>
    <message>
        <source>checking the halves against each other</source>
        <translation>正在用两半相互校验</translation>
    </message>
</context>
<context>
    <name>calibration.choose_floor_points</name>
    <message>
        <source>choose points on the floor</source>
        <translation>请选择地面上的点</translation>
    </message>
</context>
<context>
    <name>calibration.choose_others</name>
    <message>
        <source>choose others</source>
        <translation>请另选</translation>
    </message>
</context>
<context>
    <name>calibration.clear_view</name>
    <message>
        <source>clear the view of the markers</source>
        <translation>请让标记露出来</translation>
    </message>
</context>
<context>
    <name>calibration.common_and_unknown_markers</name>
    <message>
        <source>they have %1 (%2), and the layout does not contain %3</source>
        <translation>现有 %1 个（%2），布局中没有 %3</translation>
    </message>
</context>
<context>
    <name>calibration.common_markers</name>
    <message>
        <source>they have %1 (%2)</source>
        <translation>现有 %1 个（%2）</translation>
    </message>
</context>
<context>
    <name>calibration.convert_unit</name>
    <message>
        <source>convert its unit.</source>
        <translation>请换算其单位。</translation>
    </message>
</context>
<context>
    <name>calibration.corner_left_out</name>
    <message>
        <source>1 outlier corner was left out, in %1.</source>
        <translation>舍去了 1 个突出的角点，位于 %1。</translation>
    </message>
</context>
<context>
    <name>calibration.corner_no_number</name>
    <message>
        <source>a corner of it is not a number</source>
        <translation>其中一个角点不是数字</translation>
    </message>
</context>
<context>
    <name>calibration.corner_of_many_tags</name>
    <message>
        <source>a corner is that of one tag</source>
        <translation>一个角只属于一个标签码</translation>
    </message>
</context>
<context>
    <name>calibration.corner_unclear</name>
    <message>
        <source>one corner of the board is unclear</source>
        <translation>标定板有一个角点无法辨认</translation>
    </message>
</context>
<context>
    <name>calibration.corners_disagree</name>
    <message>
        <source>%1 of the corners do not agree with the others</source>
        <translation>%1 的角点与其余不一致</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, in %2</source>
        <translation>保留了 %1 个相邻的突出角点，位于 %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_most_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, most in %2</source>
        <translation>保留了 %1 个相邻的突出角点，大多位于 %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_in</name>
    <message>
        <source>%1 outlier corners were left out, in %2.</source>
        <translation>舍去了 %1 个突出的角点，位于 %2。</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_most_in</name>
    <message>
        <source>%1 outlier corners were left out, most in %2.</source>
        <translation>舍去了 %1 个突出的角点，大多位于 %2。</translation>
    </message>
</context>
<context>
    <name>calibration.corners_not_flat</name>
    <message>
        <source>its corners do not match a flat board</source>
        <translation>其角点的位置不像在平整的标定板上</translation>
    </message>
</context>
<context>
    <name>calibration.corners_nowhere_near</name>
    <message>
        <source>its corners are %1 from where the other images predict them, theirs %2</source>
        <translation>其角点偏离其他图像的预测 %1，其他图像为 %2</translation>
    </message>
</context>
<context>
    <name>calibration.correct_layout</name>
    <message>
        <source>correct the layout</source>
        <translation>请更正布局</translation>
    </message>
</context>
<context>
    <name>calibration.correct_pixels</name>
    <message>
        <source>correct the pixels</source>
        <translation>请更正像素</translation>
    </message>
</context>
<context>
    <name>calibration.count_corners</name>
    <message>
        <source>count the inner corners, or leave the size out</source>
        <translation>请数一数内角点，或不填尺寸</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_in</name>
    <message>
        <source>%1 of the corners disagree, in %2</source>
        <translation>%1 的角点不一致，位于 %2</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_most_in</name>
    <message>
        <source>%1 of the corners disagree, most in %2</source>
        <translation>%1 的角点不一致，大多位于 %2</translation>
    </message>
</context>
<context>
    <name>calibration.done</name>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
</context>
<context>
    <name>calibration.edges_wide</name>
    <message>
        <source>its edges are %1 pixels wide</source>
        <translation>其边缘宽 %1 像素</translation>
    </message>
</context>
<context>
    <name>calibration.ends_on_one_pixel</name>
    <message>
        <source>both ends are on the same pixel of camera &apos;%1&apos;</source>
        <translation>两个端点位于相机“%1”的同一像素</translation>
    </message>
</context>
<context>
    <name>calibration.far_edge</name>
    <message>
        <source>at the far edge</source>
        <translation>远边</translation>
    </message>
</context>
<context>
    <name>calibration.far_left_corner</name>
    <message>
        <source>in the far left corner</source>
        <translation>远处左角</translation>
    </message>
</context>
<context>
    <name>calibration.far_right_corner</name>
    <message>
        <source>in the far right corner</source>
        <translation>远处右角</translation>
    </message>
</context>
<context>
    <name>calibration.few_corners_seen</name>
    <message>
        <source>only %1 corners of the board are visible</source>
        <translation>只看到标定板的 %1 个角点</translation>
    </message>
</context>
<context>
    <name>calibration.fifth_would</name>
    <message>
        <source>add a fifth.</source>
        <translation>第五个就可以。</translation>
    </message>
</context>
<context>
    <name>calibration.find_board_again</name>
    <message>
        <source>detect the board in it again</source>
        <translation>请在其中重新寻找标定板</translation>
    </message>
</context>
<context>
    <name>calibration.first_end_beyond</name>
    <message>
        <source>the first end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>第一个端点位于相机“%1”的地平线或其外</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye</name>
    <message>
        <source>fisheye</source>
        <translation>鱼眼</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye_lens</name>
    <message>
        <source>Fisheye lens</source>
        <translation>鱼眼镜头</translation>
    </message>
</context>
<context>
    <name>calibration.fit_only_to</name>
    <message>
        <source>the markers fit only to %1</source>
        <translation>标记仅吻合到 %1</translation>
    </message>
</context>
<context>
    <name>calibration.fits_without</name>
    <message>
        <source>without %1 the others fit to %2: check its position and its pixel</source>
        <translation>去掉 %1 后其余吻合到 %2：检查其位置和像素</translation>
    </message>
</context>
<context>
    <name>calibration.fitting_lens</name>
    <message>
        <source>fitting the lens model to %1 images</source>
        <translation>正在用 %1 张图片拟合镜头</translation>
    </message>
</context>
<context>
    <name>calibration.flip_image</name>
    <message>
        <source>switch off mirroring in the camera or its program, or flip the file</source>
        <translation>关闭摄像机或其程序中的镜像，或翻转文件</translation>
    </message>
</context>
<context>
    <name>calibration.floor_may_be_mirrored</name>
    <message>
        <source>if it is not, v is counted from below, and the labels are mirrored.</source>
        <translation>若并非如此，则 v 从下往上计，且标签被镜像。</translation>
    </message>
</context>
<context>
    <name>calibration.floor_not_registered</name>
    <message>
        <source>the floor cannot be registered</source>
        <translation>无法配准地面</translation>
    </message>
</context>
<context>
    <name>calibration.floor_part_unseen</name>
    <message>
        <source>%1 of the floor between the markers is out of view.</source>
        <translation>标记之间有 %1 的地面看不到。</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unseen</name>
    <message>
        <source>None of the floor between the markers is in view.</source>
        <translation>标记之间的地面完全看不到。</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unsure</name>
    <message>
        <source>the floor uncertainty between the points is too large, ±%1</source>
        <translation>点之间的地面只能确定到 ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_groups</name>
    <message>
        <source>%1 give about %2, %3 (such as %4) give about %5</source>
        <translation>%1 张约 %2，%3 张（如 %4）约 %5</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_unsure</name>
    <message>
        <source>the images determine the focal length only to %1</source>
        <translation>这些图片只能把焦距确定到 %1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_lengths_differ</name>
    <message>
        <source>The focal lengths across and down differ by %1</source>
        <translation>水平与垂直焦距相差 %1</translation>
    </message>
</context>
<context>
    <name>calibration.focus_or_light</name>
    <message>
        <source>focus the camera, or give more light</source>
        <translation>请对好焦，或增加光线</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_as_well</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model no better (%3)</source>
        <translation>它对留出图片的预测为 %1，%2模型并不更好（%3）</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_better</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model only to %3</source>
        <translation>它对留出图片的预测为 %1，%2模型仅为 %3</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_by_chance</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model to %3; the difference may be chance</source>
        <translation>它对留出图片的预测为 %1，%2模型为 %3，可能是偶然</translation>
    </message>
</context>
<context>
    <name>calibration.four_common_markers</name>
    <message>
        <source>the layout and the image must have four markers in common</source>
        <translation>需要布局与画面共有的四个标记</translation>
    </message>
</context>
<context>
    <name>calibration.four_markers_unchecked</name>
    <message>
        <source>Four markers are too few to check each other</source>
        <translation>四个标记几乎无法互相校验</translation>
    </message>
</context>
<context>
    <name>calibration.four_points_unchecked</name>
    <message>
        <source>Four points are too few to check each other</source>
        <translation>四个点几乎无法互相校验</translation>
    </message>
</context>
<context>
    <name>calibration.four_shared_points</name>
    <message>
        <source>both cameras must see the same four points or more</source>
        <translation>需要两台相机都能看到的四个点</translation>
    </message>
</context>
<context>
    <name>calibration.give_board_size</name>
    <message>
        <source>give at least 3x3, such as 9x6, or leave the size out</source>
        <translation>请至少给出 3x3，如 9x6，或不填尺寸</translation>
    </message>
</context>
<context>
    <name>calibration.give_distance</name>
    <message>
        <source>give a distance of 0 m to 1000 m</source>
        <translation>请给出 0 m 到 1000 m 的距离</translation>
    </message>
</context>
<context>
    <name>calibration.give_field_of_view</name>
    <message>
        <source>give 2° to 150°, and the image size</source>
        <translation>请给出 2° 到 150°，以及画面尺寸</translation>
    </message>
</context>
<context>
    <name>calibration.give_height</name>
    <message>
        <source>give a height of 0.05 m to 100 m</source>
        <translation>请给出 0.05 m 到 100 m 的高度</translation>
    </message>
</context>
<context>
    <name>calibration.give_one_of_them</name>
    <message>
        <source>give one of them</source>
        <translation>请给出其中之一</translation>
    </message>
</context>
<context>
    <name>calibration.give_plain_numbers</name>
    <message>
        <source>give plain numbers</source>
        <translation>请给出普通数字</translation>
    </message>
</context>
<context>
    <name>calibration.give_positive_number</name>
    <message>
        <source>give a number above 0</source>
        <translation>请给出大于 0 的数</translation>
    </message>
</context>
<context>
    <name>calibration.give_square_size</name>
    <message>
        <source>give a size such as 25mm</source>
        <translation>请写成 25mm 的形式</translation>
    </message>
</context>
<context>
    <name>calibration.give_tape_sigma</name>
    <message>
        <source>give about 2 mm</source>
        <translation>可给出约 2 mm</translation>
    </message>
</context>
<context>
    <name>calibration.give_taped_length</name>
    <message>
        <source>enter the length measured with a tape</source>
        <translation>请给出用卷尺量得的长度</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board</name>
    <message>
        <source>glue the board onto something stiff</source>
        <translation>请把标定板贴在坚硬的物体上</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board_flat</name>
    <message>
        <source>glue the board onto something stiff and flat</source>
        <translation>请把标定板贴在坚硬平整的物体上</translation>
    </message>
</context>
<context>
    <name>calibration.good</name>
    <message>
        <source>Good: %1.</source>
        <translation>良好：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.grows_beyond</name>
    <message>
        <source>Beyond the markers it grows, to ±%1 within %2 of them.</source>
        <translation>在标记之外会增大，%2 以内可达 ±%1。</translation>
    </message>
</context>
<context>
    <name>calibration.halves_contradict</name>
    <message>
        <source>two halves of the images give focal lengths that differ by %1</source>
        <translation>两半图片得出的焦距相差 %1</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell</name>
    <message>
        <source>each half of the images predicts the other to %1</source>
        <translation>各半互相预测到 %1</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell_apart</name>
    <message>
        <source>each half of the images predicts the other to %1, at most %2 apart on that floor</source>
        <translation>各半互相预测到 %1，在该地面上最多相差 %2</translation>
    </message>
</context>
<context>
    <name>calibration.held_out_markers</name>
    <message>
        <source>Markers that are left out one by one are predicted to %1 RMS.</source>
        <translation>逐个去掉的标记可预测到 %1 RMS。</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_closer</name>
    <message>
        <source>hold it closer to the camera</source>
        <translation>请让它靠近相机</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_still</name>
    <message>
        <source>hold it still, and focus the camera</source>
        <translation>请保持不动，并对好焦</translation>
    </message>
</context>
<context>
    <name>calibration.image_and_reason</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.image_may_be_cropped</name>
    <message>
        <source>if these images were cropped, the videos must be cropped alike</source>
        <translation>如果这些图像经过裁剪，视频也必须以同样方式裁剪</translation>
    </message>
</context>
<context>
    <name>calibration.image_mirrored</name>
    <message>
        <source>mirrored left to right they fit to %1: is the image mirrored?</source>
        <translation>左右镜像后吻合到 %1：图像是否被镜像？</translation>
    </message>
</context>
<context>
    <name>calibration.image_repeats</name>
    <message>
        <source>1 of %1 images shows the board in the same position as another one, and each position counts once</source>
        <translation>%1 张图片中有 1 张的标定板姿态与另一张相同，每个姿态只计一次</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out</name>
    <message>
        <source>Left out: %1.</source>
        <translation>已排除：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out_among</name>
    <message>
        <source>%1 images were left out, among them %2.</source>
        <translation>已排除 %1 张图像，其中包括 %2。</translation>
    </message>
</context>
<context>
    <name>calibration.images_repeat</name>
    <message>
        <source>%1 of %2 images show the board in the same position as another one, and each position counts once</source>
        <translation>%2 张图片中有 %1 张的标定板姿态与另一张相同，每个姿态只计一次</translation>
    </message>
</context>
<context>
    <name>calibration.inches</name>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
</context>
<context>
    <name>calibration.inside</name>
    <message>
        <source>inside</source>
        <translation>内部</translation>
    </message>
</context>
<context>
    <name>calibration.inside_expected_error</name>
    <message>
        <source>within the limit of %1 (2.5 σ).</source>
        <translation>在预期误差 %1 以内。</translation>
    </message>
</context>
<context>
    <name>calibration.keep_board_clear</name>
    <message>
        <source>keep the board clear and well lit</source>
        <translation>请保持标定板无遮挡且光线良好</translation>
    </message>
</context>
<context>
    <name>calibration.keep_whole_board</name>
    <message>
        <source>keep the whole board in view</source>
        <translation>请让整块标定板都在画面内</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_marker</name>
    <message>
        <source>give each marker a label of its own</source>
        <translation>请给每个标记各自的标号</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_point</name>
    <message>
        <source>give each point a label of its own</source>
        <translation>请给每个点各自的标号</translation>
    </message>
</context>
<context>
    <name>calibration.label_of_layout</name>
    <message>
        <source>label &apos;%1&apos; of the layout</source>
        <translation>布局中的标签“%1”</translation>
    </message>
</context>
<context>
    <name>calibration.labels_called</name>
    <message>
        <source>with %1 renamed %2 they fit to %3</source>
        <translation>若将 %1 称为 %2，则吻合到 %3</translation>
    </message>
</context>
<context>
    <name>calibration.labels_exchanged</name>
    <message>
        <source>with %1 and %2 swapped they fit to %3</source>
        <translation>若交换 %1 和 %2，则吻合到 %3</translation>
    </message>
</context>
<context>
    <name>calibration.lay_stick_nearer</name>
    <message>
        <source>put the stick on the floor, nearer to the camera</source>
        <translation>请把标尺放在地面上离相机更近处</translation>
    </message>
</context>
<context>
    <name>calibration.layout_in_mm</name>
    <message>
        <source>it must be in mm</source>
        <translation>应以 mm 给出</translation>
    </message>
</context>
<context>
    <name>calibration.layout_mirrored</name>
    <message>
        <source>with a reversed Y of the layout they fit to %1: check the signs of the layout, seen from above Y must point to the left of X</source>
        <translation>将布局的 Y 反向后吻合到 %1：检查布局的正负号，从上方看 Y 必须指向 X 的左侧</translation>
    </message>
</context>
<context>
    <name>calibration.layout_not_in_mm</name>
    <message>
        <source>if that is wrong, the layout is not in mm</source>
        <translation>如果不对，则布局中的数字不是 mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_too_small</name>
    <message>
        <source>the layout has %1 markers, four are needed</source>
        <translation>布局有 %1 个标记，需要四个</translation>
    </message>
</context>
<context>
    <name>calibration.layout_written_mirrored</name>
    <message>
        <source>if the layout was written down mirrored, correct its signs and add it again</source>
        <translation>若布局记成了镜像，请更正正负号后重新添加</translation>
    </message>
</context>
<context>
    <name>calibration.leave_one_tag</name>
    <message>
        <source>leave one of them on the floor</source>
        <translation>请只在地面留一个</translation>
    </message>
</context>
<context>
    <name>calibration.leave_out_pictures</name>
    <message>
        <source>leave out these images if the board is bent, cut or covered there.</source>
        <translation>如果标定板在那里弯曲、被截断或遮挡，请去掉这些图片。</translation>
    </message>
</context>
<context>
    <name>calibration.left_edge</name>
    <message>
        <source>at the left edge</source>
        <translation>左边</translation>
    </message>
</context>
<context>
    <name>calibration.length_factor</name>
    <message>
        <source>a length factor of %1 is not possible</source>
        <translation>长度倍数 %1 无法构成地面</translation>
    </message>
</context>
<context>
    <name>calibration.length_is</name>
    <message>
        <source>The length is %1 ± %2.</source>
        <translation>长度为 %1 ± %2。</translation>
    </message>
</context>
<context>
    <name>calibration.length_longer</name>
    <message>
        <source>It is %1 longer than the %2 entered</source>
        <translation>比给出的 %2 长 %1</translation>
    </message>
</context>
<context>
    <name>calibration.length_shorter</name>
    <message>
        <source>It is %1 shorter than the %2 entered</source>
        <translation>比给出的 %2 短 %1</translation>
    </message>
</context>
<context>
    <name>calibration.length_unmeasured</name>
    <message>
        <source>the length cannot be measured</source>
        <translation>无法测量长度</translation>
    </message>
</context>
<context>
    <name>calibration.length_unseen</name>
    <message>
        <source>no camera shows it</source>
        <translation>没有给出能看到它的相机</translation>
    </message>
</context>
<context>
    <name>calibration.lens_assumed</name>
    <message>
        <source>The lens is not calibrated, and the markers hardly determine it (focal length %1 ± %2): what is not known of it is in the uncertainty.</source>
        <translation>镜头未标定，且标记几乎无法确定它（焦距 %1 ± %2）：未知部分已计入不确定度。</translation>
    </message>
</context>
<context>
    <name>calibration.lens_from_floor</name>
    <message>
        <source>The lens is not calibrated: focal length (%1 ± %2) and distortion (k1 %3 ± %4) were estimated from the markers.</source>
        <translation>镜头未标定：焦距（%1 ± %2）和畸变（k1 %3 ± %4）由标记估计。</translation>
    </message>
</context>
<context>
    <name>calibration.lens_of_other_camera</name>
    <message>
        <source>with the lens calibration of camera &apos;%1&apos; they fit to %2: are the views swapped?</source>
        <translation>使用摄像机“%1”的镜头标定时吻合到 %2：视图是否颠倒？</translation>
    </message>
</context>
<context>
    <name>calibration.lens_on_floor</name>
    <message>
        <source>±%1 in the middle and at most ±%2 (%3) on %4, from the lens calibration alone</source>
        <translation>就镜头而言，在%4上中间 ±%1，最差 ±%2（%3）</translation>
    </message>
</context>
<context>
    <name>calibration.lens_told</name>
    <message>
        <source>as specified</source>
        <translation>由人指定</translation>
    </message>
</context>
<context>
    <name>calibration.lens_unknown_elsewhere</name>
    <message>
        <source>the distortion elsewhere stays unknown</source>
        <translation>其他位置的畸变仍未知</translation>
    </message>
</context>
<context>
    <name>calibration.likely_unit</name>
    <message>
        <source>its numbers look like %1, with the camera %2 above the floor</source>
        <translation>其数值像是%1，那样它将位于地面以上 %2</translation>
    </message>
</context>
<context>
    <name>calibration.longer</name>
    <message>
        <source>longer</source>
        <translation>长</translation>
    </message>
</context>
<context>
    <name>calibration.look_at</name>
    <message>
        <source>Check %1</source>
        <translation>请查看 %1</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_ends</name>
    <message>
        <source>check that the same ends are marked in each image; if they are, register it again.</source>
        <translation>查看每个画面是否标出了相同的端点；若是，请重新配准。</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_pictures</name>
    <message>
        <source>check these images and leave out those that are blurred, bent or of another board.</source>
        <translation>查看这些图片，去掉模糊、弯曲或属于另一块标定板的。</translation>
    </message>
</context>
<context>
    <name>calibration.looking_about</name>
    <message>
        <source>searching around the best position</source>
        <translation>正在最佳位置周围搜索</translation>
    </message>
</context>
<context>
    <name>calibration.make_larger_layout</name>
    <message>
        <source>make a layout of four markers or more</source>
        <translation>请建立有四个或更多标记的布局</translation>
    </message>
</context>
<context>
    <name>calibration.mark_ends_in_one</name>
    <message>
        <source>mark its ends in at least one image</source>
        <translation>请至少在一个画面中标出其端点</translation>
    </message>
</context>
<context>
    <name>calibration.mark_more</name>
    <message>
        <source>mark more of the layout&apos;s markers, by their names in the layout</source>
        <translation>请按布局的名称标出更多布局中的标记</translation>
    </message>
</context>
<context>
    <name>calibration.mark_there_again</name>
    <message>
        <source>mark it again in that view.</source>
        <translation>请在那里重新标出。</translation>
    </message>
</context>
<context>
    <name>calibration.mark_two_ends</name>
    <message>
        <source>mark each end at its own position in the image</source>
        <translation>请在看到处标出两个端点</translation>
    </message>
</context>
<context>
    <name>calibration.mark_where_seen</name>
    <message>
        <source>mark each of them at its own position in the image</source>
        <translation>请分别标在看到的位置</translation>
    </message>
</context>
<context>
    <name>calibration.marker_against_lens</name>
    <message>
        <source>this camera&apos;s lens model cannot project %1</source>
        <translation>%1 位于此相机镜头不可能成像的位置</translation>
    </message>
</context>
<context>
    <name>calibration.marker_beyond_horizon</name>
    <message>
        <source>marker %1 would be at or beyond the horizon</source>
        <translation>标记 %1 将位于地平线或其外</translation>
    </message>
</context>
<context>
    <name>calibration.marker_moved</name>
    <message>
        <source>Marker %1 has moved %2 = %3, %4 has not</source>
        <translation>标记 %1 移动了 %2 = %3，%4 没有移动</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_all</name>
    <message>
        <source>%1 is %2 off in all cameras</source>
        <translation>按所有相机，%1 偏离 %2</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_one</name>
    <message>
        <source>%1 is %2 off in the one camera that sees it</source>
        <translation>按唯一看见 %1 的相机，它偏离 %2</translation>
    </message>
</context>
<context>
    <name>calibration.marker_pixel_no_number</name>
    <message>
        <source>the pixel of marker %1 is not a finite number</source>
        <translation>标记 %1 的像素不是有限数</translation>
    </message>
</context>
<context>
    <name>calibration.marker_place_no_number</name>
    <message>
        <source>the position of marker %1 is not a finite number</source>
        <translation>标记 %1 的位置不是有限数</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_layout</name>
    <message>
        <source>marker %1 appears twice in the layout</source>
        <translation>标记 %1 在布局中出现两次</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_picture</name>
    <message>
        <source>marker %1 appears twice in the image</source>
        <translation>标记 %1 在画面中出现两次</translation>
    </message>
</context>
<context>
    <name>calibration.markers_at_one_place</name>
    <message>
        <source>markers %1 and %2 have the same floor position</source>
        <translation>标记 %1 和 %2 位于地面同一处</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit</name>
    <message>
        <source>%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5</source>
        <translation>%1 个标记拟合到 %2 RMS（最差 %3，%4），其间地面已知到 ±%5</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_many_ways</name>
    <message>
        <source>they fit the layout equally well in %1 ways, because it looks the same from several sides</source>
        <translation>布局从多个方向看相同，有 %1 种方式同样吻合</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_together</name>
    <message>
        <source>registered jointly with %1: %2 markers fit to %3 RMS; floor uncertainty ±%4</source>
        <translation>与 %1 一起，%2 个标记拟合到 %3 RMS，其间地面已知到 ±%4</translation>
    </message>
</context>
<context>
    <name>calibration.markers_found</name>
    <message>
        <source>%1 of %2 were found, four are needed</source>
        <translation>%2 个中找到 %1 个，需要四个</translation>
    </message>
</context>
<context>
    <name>calibration.markers_in_place</name>
    <message>
        <source>%1 markers are within %2 = %3 of their positions.</source>
        <translation>%1 个标记与原位相差在 %2 = %3 以内。</translation>
    </message>
</context>
<context>
    <name>calibration.markers_mirrored</name>
    <message>
        <source>the markers are mirrored</source>
        <translation>标记呈镜像</translation>
    </message>
</context>
<context>
    <name>calibration.markers_missing</name>
    <message>
        <source>missing: %1</source>
        <translation>缺少：%1</translation>
    </message>
</context>
<context>
    <name>calibration.markers_moved</name>
    <message>
        <source>Markers %1 have moved %2 = %3, %4 has not</source>
        <translation>标记 %1 移动了 %2 = %3，%4 没有移动</translation>
    </message>
</context>
<context>
    <name>calibration.markers_nearly_on_line</name>
    <message>
        <source>the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2</source>
        <translation>标记几乎共线（%1 最甚），地面只能确定到 ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_found</name>
    <message>
        <source>the floor markers cannot be found</source>
        <translation>找不到地面标记</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_told_apart</name>
    <message>
        <source>the markers cannot be distinguished</source>
        <translation>无法区分各标记</translation>
    </message>
</context>
<context>
    <name>calibration.markers_on_one_pixel</name>
    <message>
        <source>markers %1 and %2 are on the same pixel</source>
        <translation>标记 %1 和 %2 位于同一像素</translation>
    </message>
</context>
<context>
    <name>calibration.markers_read</name>
    <message>
        <source>%1 of its markers could be read</source>
        <translation>只读出 %1 个标记</translation>
    </message>
</context>
<context>
    <name>calibration.markers_too_close</name>
    <message>
        <source>markers %1 and %2 are only %3 apart, too close for two of four</source>
        <translation>标记 %1 和 %2 仅相距 %3，对四个中的两个来说太近</translation>
    </message>
</context>
<context>
    <name>calibration.measure_again</name>
    <message>
        <source>mark and remeasure them, or add another</source>
        <translation>请重新标出并测量，或再加一个</translation>
    </message>
</context>
<context>
    <name>calibration.measure_it_again</name>
    <message>
        <source>remeasure it.</source>
        <translation>请重新测量。</translation>
    </message>
</context>
<context>
    <name>calibration.measure_or_mark_again</name>
    <message>
        <source>measure it, or mark it in the image, again.</source>
        <translation>请重新测量，或在画面中重新标出。</translation>
    </message>
</context>
<context>
    <name>calibration.metres</name>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_corner</name>
    <message>
        <source>±%1 in the middle, ±%2 in the corner near %3.</source>
        <translation>中间 ±%1，%3 附近的角 ±%2。</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_edge</name>
    <message>
        <source>±%1 in the middle, ±%2 at the edge near %3.</source>
        <translation>中间 ±%1，%3 附近的边缘 ±%2。</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_near</name>
    <message>
        <source>±%1 in the middle, ±%2 near %3.</source>
        <translation>中间 ±%1，%3 附近 ±%2。</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_most_at</name>
    <message>
        <source>%1 RMS, most at %2 (%3)</source>
        <translation>%1 RMS，%2 处最大（%3）</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_unexplained</name>
    <message>
        <source>the %1 markers misfit by %2 (%3), and are too few to identify the wrong one</source>
        <translation>%1 个标记偏差 %2（%3），彼此校验不足，无法判断是哪一个</translation>
    </message>
</context>
<context>
    <name>calibration.more_pairs</name>
    <message>
        <source>take more pairs, or register %1 better first</source>
        <translation>请拍更多图像对，或先更好地配准 %1</translation>
    </message>
</context>
<context>
    <name>calibration.more_pictures</name>
    <message>
        <source>More images (%1 or more) would make it more certain.</source>
        <translation>更多图片（%1 张或以上）会更可靠。</translation>
    </message>
</context>
<context>
    <name>calibration.move_back</name>
    <message>
        <source>%1 away from the floor</source>
        <translation>远离地面 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_board</name>
    <message>
        <source>move it elsewhere, turn it or tilt it</source>
        <translation>请移动、旋转或倾斜它</translation>
    </message>
</context>
<context>
    <name>calibration.move_closer</name>
    <message>
        <source>%1 closer to the floor&apos;s middle</source>
        <translation>靠近地面中心 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_down</name>
    <message>
        <source>%1 down</source>
        <translation>向下 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_helps</name>
    <message>
        <source>Moving %1 by %2, aimed at the middle of the floor, lowers the error from ±%3 to ±%4 where it is largest.</source>
        <translation>将 %1 移动（%2）并对准地面中心，误差最大处的误差从 ±%3 降到 ±%4。</translation>
    </message>
</context>
<context>
    <name>calibration.move_left</name>
    <message>
        <source>%1 to the left</source>
        <translation>向左 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_planned_back</name>
    <message>
        <source>move it back or up, or choose a wider lens</source>
        <translation>请把它后移或升高，或选用更广角的镜头</translation>
    </message>
</context>
<context>
    <name>calibration.move_right</name>
    <message>
        <source>%1 to the right</source>
        <translation>向右 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_up</name>
    <message>
        <source>%1 up</source>
        <translation>向上 %1</translation>
    </message>
</context>
<context>
    <name>calibration.name_dictionary</name>
    <message>
        <source>name one like DICT_6X6_250, or leave it out</source>
        <translation>请指定一个，如 DICT_6X6_250，或不填</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_camera</name>
    <message>
        <source>name each camera once</source>
        <translation>每台相机请只指定一次</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_marker</name>
    <message>
        <source>give each marker a name of its own</source>
        <translation>请给每个标记各自的名称</translation>
    </message>
</context>
<context>
    <name>calibration.name_one_marker</name>
    <message>
        <source>name one of %1</source>
        <translation>请从 %1 中指定一个</translation>
    </message>
</context>
<context>
    <name>calibration.name_tag_family</name>
    <message>
        <source>write the family into the labels, such as 36h11:7, or mark a marker by hand</source>
        <translation>请在标签中写明标签码族，例如 36h11:7，或手动标出一个标记</translation>
    </message>
</context>
<context>
    <name>calibration.name_two_apart</name>
    <message>
        <source>name two at different positions</source>
        <translation>请指定相距的两个</translation>
    </message>
</context>
<context>
    <name>calibration.near_edge</name>
    <message>
        <source>at the near edge</source>
        <translation>近边</translation>
    </message>
</context>
<context>
    <name>calibration.near_left_corner</name>
    <message>
        <source>in the near left corner</source>
        <translation>近处左角</translation>
    </message>
</context>
<context>
    <name>calibration.near_right_corner</name>
    <message>
        <source>in the near right corner</source>
        <translation>近处右角</translation>
    </message>
</context>
<context>
    <name>calibration.no_board_found</name>
    <message>
        <source>no board found</source>
        <translation>没有找到标定板</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco</name>
    <message>
        <source>the detected markers do not match a ChArUco board</source>
        <translation>读到的标记不像在 ChArUco 板上那样排列</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco_of_size</name>
    <message>
        <source>the detected markers do not match a ChArUco board of %1 inner corners</source>
        <translation>读到的标记不像在 %1 内角点的 ChArUco 板上那样排列</translation>
    </message>
</context>
<context>
    <name>calibration.no_common_marker</name>
    <message>
        <source>no two of the cameras see the same marker</source>
        <translation>没有两台相机看到同一标记</translation>
    </message>
</context>
<context>
    <name>calibration.no_dictionary</name>
    <message>
        <source>marker dictionary %1 does not exist</source>
        <translation>没有标记字典 %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_flat_floor</name>
    <message>
        <source>the markers do not fit a flat floor</source>
        <translation>标记与平坦地面不符</translation>
    </message>
</context>
<context>
    <name>calibration.no_lens_fits</name>
    <message>
        <source>no lens model fits these images</source>
        <translation>没有镜头模型适合这些图片</translation>
    </message>
</context>
<context>
    <name>calibration.no_millimetres</name>
    <message>
        <source>no value in millimetres: this calibration holds for only part of the image</source>
        <translation>无毫米数值，因为此镜头模型只适用于画面的一部分</translation>
    </message>
</context>
<context>
    <name>calibration.no_other_lens</name>
    <message>
        <source>no other model fits</source>
        <translation>没有其他模型适合</translation>
    </message>
</context>
<context>
    <name>calibration.no_pair_has_board</name>
    <message>
        <source>none of %1 pairs can be used</source>
        <translation>%1 对图像中没有一对可用</translation>
    </message>
</context>
<context>
    <name>calibration.no_pose</name>
    <message>
        <source>no pose</source>
        <translation>无法求得位姿</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_corner</name>
    <message>
        <source>the corners of a tag are tl, tr, br and bl</source>
        <translation>标签码的角为 tl、tr、br 和 bl</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_marker</name>
    <message>
        <source>it has no marker %1</source>
        <translation>没有标记 %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_tag</name>
    <message>
        <source>%1 has no tag %2</source>
        <translation>%1 中没有标签码 %2</translation>
    </message>
</context>
<context>
    <name>calibration.no_tag_number</name>
    <message>
        <source>&apos;%1&apos; is not the number of a tag</source>
        <translation>“%1”不是标签码编号</translation>
    </message>
</context>
<context>
    <name>calibration.none_sees_four_markers</name>
    <message>
        <source>no camera sees four markers of the layout</source>
        <translation>没有相机能看到布局的四个标记</translation>
    </message>
</context>
<context>
    <name>calibration.not_all_foretold</name>
    <message>
        <source>not all</source>
        <translation>并非全部</translation>
    </message>
</context>
<context>
    <name>calibration.not_found_again</name>
    <message>
        <source>Not found again: %1.</source>
        <translation>未能再次找到：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_by_pair</name>
    <message>
        <source>the camera cannot be registered by the pair</source>
        <translation>无法通过这对相机配准该相机</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_through</name>
    <message>
        <source>the camera cannot be registered via another camera</source>
        <translation>无法通过另一相机配准</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_together</name>
    <message>
        <source>the cameras cannot be registered jointly</source>
        <translation>无法联合配准这些相机</translation>
    </message>
</context>
<context>
    <name>calibration.of_other_camera</name>
    <message>
        <source>it is of another camera, zoom or focus</source>
        <translation>它来自另一台相机、另一变焦或对焦</translation>
    </message>
</context>
<context>
    <name>calibration.other_focal_length</name>
    <message>
        <source>it gives a focal length of %1, the other images %2</source>
        <translation>它给出的焦距为 %1，其他图像为 %2</translation>
    </message>
</context>
<context>
    <name>calibration.other_picking_size</name>
    <message>
        <source>at %1 they fit to %2: were they picked at that size?</source>
        <translation>在 %1 下吻合到 %2：是否在该尺寸下选取？</translation>
    </message>
</context>
<context>
    <name>calibration.other_picture_size</name>
    <message>
        <source>it is %1×%2, the other images are %3×%4</source>
        <translation>它为 %1×%2，其他图片为 %3×%4</translation>
    </message>
</context>
<context>
    <name>calibration.other_zoom</name>
    <message>
        <source>with a focal length of %1 instead of %2 they fit to %3: has the zoom or the lens changed?</source>
        <translation>焦距为 %1 而非 %2 时吻合到 %3：变焦或镜头是否改变？</translation>
    </message>
</context>
<context>
    <name>calibration.others_undetermined</name>
    <message>
        <source>the images do not determine any other model</source>
        <translation>这些图像无法确定其他模型</translation>
    </message>
</context>
<context>
    <name>calibration.outside_expected_error</name>
    <message>
        <source>beyond the limit of %1 (2.5 σ).</source>
        <translation>超出预期误差 %1。</translation>
    </message>
</context>
<context>
    <name>calibration.pair_contradicts</name>
    <message>
        <source>it contradicts the other pairs by %1 RMS</source>
        <translation>它与其他图像对矛盾，相差 %1 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_fits</name>
    <message>
        <source>the cameras are %1 apart (±%2) by %3 pairs, whose corners fit to %4 RMS</source>
        <translation>两台相机相距 %1（±%2），依据 %3 对图像，其角点拟合到 %4 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_floor_unsure</name>
    <message>
        <source>the floor uncertainty would be ±%1</source>
        <translation>地面不确定度将为 ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.pair_is_one_image</name>
    <message>
        <source>both are the same image</source>
        <translation>两者是同一张图片</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lacks_board</name>
    <message>
        <source>the board was not found in &apos;%1&apos;</source>
        <translation>在“%1”中没有找到标定板</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lens_usual</name>
    <message>
        <source>A lens calibration has no stated uncertainty: a usual one was assumed.</source>
        <translation>有一个镜头标定没有给出不确定度：按通常的值处理。</translation>
    </message>
</context>
<context>
    <name>calibration.pair_of_cameras</name>
    <message>
        <source>the relative position of the cameras</source>
        <translation>两台相机的相对位置</translation>
    </message>
</context>
<context>
    <name>calibration.pair_sees_no_floor</name>
    <message>
        <source>it would see hardly any floor</source>
        <translation>它几乎看不到地面</translation>
    </message>
</context>
<context>
    <name>calibration.pair_squares</name>
    <message>
        <source>Triangulated, the squares of the board are %1 (standard deviation %2).</source>
        <translation>三角测量得到标定板方格为 %1（标准差 %2）。</translation>
    </message>
</context>
<context>
    <name>calibration.pair_swapped</name>
    <message>
        <source>the images of each camera fit the lens calibration of the other one (%1 instead of %2 RMS)</source>
        <translation>每台相机的图片都符合另一台的镜头标定（RMS %1，而非 %2）</translation>
    </message>
</context>
<context>
    <name>calibration.pair_turned</name>
    <message>
        <source>the board looks the same when turned by half, and %1 pairs fit both ways</source>
        <translation>标定板旋转 180° 后看起来一样，%1 对图像两种方式都符合</translation>
    </message>
</context>
<context>
    <name>calibration.pair_undetermined</name>
    <message>
        <source>the board positions do not determine it</source>
        <translation>标定板的位置无法确定它</translation>
    </message>
</context>
<context>
    <name>calibration.pair_without_pose</name>
    <message>
        <source>the corners in &apos;%1&apos; determine no pose</source>
        <translation>“%1”中的角点无法确定位姿</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_contradict</name>
    <message>
        <source>the pairs contradict each other (%1 RMS together, %2 in each image alone)</source>
        <translation>图像对互相矛盾（合起来 %1 RMS，每张图片单独 %2）</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_left_out</name>
    <message>
        <source>%1 pairs were not used.</source>
        <translation>有 %1 对图像未使用。</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_scatter</name>
    <message>
        <source>The pairs agree less well than the corners would allow, which is in the uncertainty: the board moved between the two frames of a pair, or a lens calibration is less accurate than stated.</source>
        <translation>图像对的一致性不如角点所能达到的，这已计入不确定度：标定板在一对图像之间移动过，或镜头标定不如所述准确。</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_alike</name>
    <message>
        <source>Neighbouring markers err alike, by %1 RMS: check that the floor is flat, and calibrate the lens at the zoom and focus that it records with.</source>
        <translation>相邻标记的偏差相同，为 %1 RMS：请检查地面是否平整，并在录制所用的变焦和对焦下标定镜头。</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_layout</name>
    <message>
        <source>The residuals follow the layout: they disappear with X longer than Y by %1 % and the axes %2° off the right angle; measure both sides and both diagonals of the layout again.</source>
        <translation>残差与布局有关：若 X 比 Y 长 %1 % 且坐标轴偏离直角 %2°，残差就会消失；请重新测量布局的两边和两条对角线。</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_lens</name>
    <message>
        <source>The residuals follow the lens: %1 of them disappear with another focal length and distortion; calibrate the lens again, at the zoom and focus that it records with.</source>
        <translation>残差与镜头有关：换用其他焦距和畸变后其中 %1 会消失；请在录制所用的变焦和对焦下重新标定镜头。</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_marker</name>
    <message>
        <source>Marker %1 is %2 from where the others expect it: measure and mark it again.</source>
        <translation>标记 %1 与其他标记所预期的位置相差 %2：请重新测量并标记。</translation>
    </message>
</context>
<context>
    <name>calibration.picture_covered</name>
    <message>
        <source>The board covered only %1 of the image</source>
        <translation>只覆盖了画面的 %1</translation>
    </message>
</context>
<context>
    <name>calibration.picture_stands_out</name>
    <message>
        <source>its %1 is an outlier.</source>
        <translation>其 %1 显得突出。</translation>
    </message>
</context>
<context>
    <name>calibration.picture_too_small</name>
    <message>
        <source>the image is too small</source>
        <translation>图像太小</translation>
    </message>
</context>
<context>
    <name>calibration.picture_with_corners</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.picture_without_size</name>
    <message>
        <source>the image has no size</source>
        <translation>图像没有尺寸</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4</source>
        <translation>%1 张图片拟合到 %2，焦距 %3 ± %4</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit_halves_apart</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4, halves at most %5 apart on that floor</source>
        <translation>%1 张图片拟合到 %2，焦距 %3 ± %4，在该地面上最多相差 %5</translation>
    </message>
</context>
<context>
    <name>calibration.pixels_not_square</name>
    <message>
        <source>the camera&apos;s pixels are not square, or its images were rescaled</source>
        <translation>相机的像素不是正方形，或其图像经过缩放</translation>
    </message>
</context>
<context>
    <name>calibration.place_left</name>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower</name>
    <message>
        <source>lower</source>
        <translation>下</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_left</name>
    <message>
        <source>lower left</source>
        <translation>左下</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_right</name>
    <message>
        <source>lower right</source>
        <translation>右下</translation>
    </message>
</context>
<context>
    <name>calibration.place_middle</name>
    <message>
        <source>middle</source>
        <translation>中间</translation>
    </message>
</context>
<context>
    <name>calibration.place_right</name>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper</name>
    <message>
        <source>upper</source>
        <translation>上</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_left</name>
    <message>
        <source>upper left</source>
        <translation>左上</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_right</name>
    <message>
        <source>upper right</source>
        <translation>右上</translation>
    </message>
</context>
<context>
    <name>calibration.planned_camera</name>
    <message>
        <source>the planned camera</source>
        <translation>计划中的相机</translation>
    </message>
</context>
<context>
    <name>calibration.planned_distance</name>
    <message>
        <source>its distance cannot be %1</source>
        <translation>它不能位于 %1 之外</translation>
    </message>
</context>
<context>
    <name>calibration.planned_field_of_view</name>
    <message>
        <source>its field of view is %1</source>
        <translation>其视场角为 %1</translation>
    </message>
</context>
<context>
    <name>calibration.planned_height</name>
    <message>
        <source>its height above the floor cannot be %1</source>
        <translation>它不能位于地面以上 %1</translation>
    </message>
</context>
<context>
    <name>calibration.planned_not_held</name>
    <message>
        <source>the markers it would see do not determine its pose</source>
        <translation>所能看到的标记不足以确定它的位置</translation>
    </message>
</context>
<context>
    <name>calibration.planned_sees_too_few</name>
    <message>
        <source>it would see only %1 of the layout&apos;s markers (%2), four are needed</source>
        <translation>从那里只能看到布局中的 %1 个标记（%2），需要四个</translation>
    </message>
</context>
<context>
    <name>calibration.point_against_lens</name>
    <message>
        <source>the lens model cannot project point %1</source>
        <translation>点 %1 位于镜头不可能成像的位置</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_horizon</name>
    <message>
        <source>point %1 would be at or beyond the horizon</source>
        <translation>点 %1 将位于地平线或其外</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_through</name>
    <message>
        <source>point %1 is at or beyond the horizon of %2</source>
        <translation>点 %1 位于 %2 的地平线或其外</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_own</name>
    <message>
        <source>point %1 is outside the image of the camera to register (%2)</source>
        <translation>点 %1 位于待配准相机的画面（%2）之外</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_through</name>
    <message>
        <source>point %1 is outside the image of %2 (%3)</source>
        <translation>点 %1 位于 %2 的画面（%3）之外</translation>
    </message>
</context>
<context>
    <name>calibration.point_pixel_no_number</name>
    <message>
        <source>the pixel of point %1 is not a finite number</source>
        <translation>点 %1 的像素不是有限数</translation>
    </message>
</context>
<context>
    <name>calibration.point_twice</name>
    <message>
        <source>point %1 appears twice</source>
        <translation>点 %1 出现两次</translation>
    </message>
</context>
<context>
    <name>calibration.points_fit</name>
    <message>
        <source>via %1, %2 floor points fit to %3 RMS (worst %4, %5); floor uncertainty ±%6, of which %8 contributes ±%7</source>
        <translation>通过%1，%2 个地面点拟合到 %3 RMS（最差 %4，%5），其间地面已知到 ±%6，其中 ±%7 来自 %8</translation>
    </message>
</context>
<context>
    <name>calibration.points_mirrored</name>
    <message>
        <source>the points are mirrored between the images of the two cameras</source>
        <translation>两台相机画面中的点互为镜像</translation>
    </message>
</context>
<context>
    <name>calibration.points_on_one_pixel</name>
    <message>
        <source>points %1 and %2 are on the same pixel</source>
        <translation>点 %1 和 %2 位于同一像素</translation>
    </message>
</context>
<context>
    <name>calibration.points_undetermined</name>
    <message>
        <source>the points do not determine the camera position</source>
        <translation>这些点无法确定相机位置</translation>
    </message>
</context>
<context>
    <name>calibration.poor</name>
    <message>
        <source>Poor: %1.</source>
        <translation>较差：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.poor_measure_again</name>
    <message>
        <source>Poor, measure the markers again: %1.</source>
        <translation>较差，请重新测量标记：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_bent</name>
    <message>
        <source>The board is not flat, it bulges by %1: glue it onto something stiff.</source>
        <translation>标定板不平整，鼓起 %1：请将其粘贴在坚硬的平板上。</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_stretched</name>
    <message>
        <source>The print&apos;s squares are %1 %2 from row to row than from column to column: measure the squares in both directions.</source>
        <translation>打印的方格行间比列间%2 %1：请在两个方向上测量方格。</translation>
    </message>
</context>
<context>
    <name>calibration.print_may_be_stretched</name>
    <message>
        <source>measure the squares of the print in both directions, for it may be stretched, and take images with the board turned by 90 degrees</source>
        <translation>打印件可能被拉伸，请在两个方向上测量方格，并拍摄标定板旋转 90 度的图像</translation>
    </message>
</context>
<context>
    <name>calibration.print_was_heeded</name>
    <message>
        <source>The calibration allows for this.</source>
        <translation>标定已考虑这一点。</translation>
    </message>
</context>
<context>
    <name>calibration.put_marker_back</name>
    <message>
        <source>move it back, or measure the markers again and register all cameras.</source>
        <translation>请放回原位，或重新测量并配准所有相机。</translation>
    </message>
</context>
<context>
    <name>calibration.put_markers_back</name>
    <message>
        <source>move them back, or measure the markers again and register all cameras.</source>
        <translation>请把它们放回原位，或重新测量并配准所有相机。</translation>
    </message>
</context>
<context>
    <name>calibration.quarter_turn</name>
    <message>
        <source>turned by a quarter they fit to %1: was the image shown turned?</source>
        <translation>旋转 90 度后吻合到 %1：图像是否被旋转显示？</translation>
    </message>
</context>
<context>
    <name>calibration.rational</name>
    <message>
        <source>rational</source>
        <translation>有理式</translation>
    </message>
</context>
<context>
    <name>calibration.rational_lens</name>
    <message>
        <source>Rational lens</source>
        <translation>有理式镜头</translation>
    </message>
</context>
<context>
    <name>calibration.register_before_recording</name>
    <message>
        <source>register it again before you record.</source>
        <translation>录制前请重新配准。</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_four</name>
    <message>
        <source>register the cameras by four markers or more</source>
        <translation>请用四个或更多标记配准相机</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_more</name>
    <message>
        <source>register it with more of them first</source>
        <translation>请先用更多标记配准它</translation>
    </message>
</context>
<context>
    <name>calibration.register_if_gone</name>
    <message>
        <source>if they are gone or the camera points elsewhere, register it again</source>
        <translation>若标记已不在或相机朝向别处，请重新配准</translation>
    </message>
</context>
<context>
    <name>calibration.register_one_by_one</name>
    <message>
        <source>first register the cameras one by one with this layout</source>
        <translation>请先按此布局逐台配准相机</translation>
    </message>
</context>
<context>
    <name>calibration.related_to</name>
    <message>
        <source>via %1 and a board that both see; floor uncertainty ±%2</source>
        <translation>通过%1和双方都看到的标定板；地面不确定度 ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.reverse_both</name>
    <message>
        <source>reverse both (a half turn), or turn the axes</source>
        <translation>请同时反转两者（转半圈），或旋转坐标轴</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_x_alone</name>
    <message>
        <source>reversing X alone would mirror the floor; no camera above it sees it that way</source>
        <translation>只反转 X 会使地面镜像，其上的相机看不到这样的地面</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_y_alone</name>
    <message>
        <source>reversing Y alone would mirror the floor; no camera above it sees it that way</source>
        <translation>只反转 Y 会使地面镜像，其上的相机看不到这样的地面</translation>
    </message>
</context>
<context>
    <name>calibration.right_edge</name>
    <message>
        <source>at the right edge</source>
        <translation>右边</translation>
    </message>
</context>
<context>
    <name>calibration.rings_mirrored</name>
    <message>
        <source>%1 rings and dots fit the layout, mirrored</source>
        <translation>%1 个圆环和圆点镜像后符合布局</translation>
    </message>
</context>
<context>
    <name>calibration.same_as_other_camera</name>
    <message>
        <source>Camera &apos;%1&apos; sees the markers at the same pixels (to %2): check that the views are not swapped.</source>
        <translation>摄像机“%1”在相同像素处（相差 %2）看到标记：请检查视图是否颠倒。</translation>
    </message>
</context>
<context>
    <name>calibration.same_attitude</name>
    <message>
        <source>all %1 images show the board at nearly the same tilt, too little to determine the focal length</source>
        <translation>全部 %1 张图片中标定板姿态几乎相同，无法确定焦距</translation>
    </message>
</context>
<context>
    <name>calibration.same_tag_as</name>
    <message>
        <source>it names the same tag as &apos;%1&apos;</source>
        <translation>与“%1”指同一个标签码</translation>
    </message>
</context>
<context>
    <name>calibration.second_end_beyond</name>
    <message>
        <source>the second end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>第二个端点位于相机“%1”的地平线或其外</translation>
    </message>
</context>
<context>
    <name>calibration.see_same_floor</name>
    <message>
        <source>aim them at a common part of the floor</source>
        <translation>请让它们看到部分相同的地面</translation>
    </message>
</context>
<context>
    <name>calibration.seen_by_other_camera</name>
    <message>
        <source>camera &apos;%1&apos; sees the markers there, to %2: are the views swapped?</source>
        <translation>摄像机“%1”在该处看到标记，相差 %2：视图是否颠倒？</translation>
    </message>
</context>
<context>
    <name>calibration.sees_too_few_anywhere</name>
    <message>
        <source>at this height and field of view, no position within %1 of the markers shows four of them</source>
        <translation>以所给高度和镜头，在标记外 %1 范围内任何位置都看不到四个标记</translation>
    </message>
</context>
<context>
    <name>calibration.sentence</name>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>calibration.shapes_fit_nowhere</name>
    <message>
        <source>no assignment of the %1 rings and dots fits the layout</source>
        <translation>%1 个圆环和圆点的任何命名方式都与布局不符</translation>
    </message>
</context>
<context>
    <name>calibration.shared_points</name>
    <message>
        <source>%1 given</source>
        <translation>现有 %1 个</translation>
    </message>
</context>
<context>
    <name>calibration.shorter</name>
    <message>
        <source>shorter</source>
        <translation>短</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_larger</name>
    <message>
        <source>show the board larger, sharp and well lit</source>
        <translation>请把标定板拍得更大、清晰、光线良好</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_to_both</name>
    <message>
        <source>show the whole board to both cameras at once, in ten positions or more</source>
        <translation>请同时向两台相机展示整块标定板，至少十个位置</translation>
    </message>
</context>
<context>
    <name>calibration.show_everywhere</name>
    <message>
        <source>show the board in the middle and near each corner of the image, and closer</source>
        <translation>请在画面中间和各角附近更近地展示标定板</translation>
    </message>
</context>
<context>
    <name>calibration.show_missing_tags</name>
    <message>
        <source>show the missing tags (AprilTag 36h11, numbered from 0 in the layout&apos;s order) or rings, or mark the markers by hand</source>
        <translation>请展示缺少的标签码（AprilTag 36h11，按布局顺序从 0 编号）或圆环，或手动标出标记</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_board</name>
    <message>
        <source>show more of the board</source>
        <translation>请多展示一些标定板</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_it</name>
    <message>
        <source>show more of it</source>
        <translation>请让更多部分可见</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_shapes</name>
    <message>
        <source>show more of them, larger or in better light, or mark the markers by hand</source>
        <translation>请展示更多、更大或更亮的，或手动标出标记</translation>
    </message>
</context>
<context>
    <name>calibration.show_near_edges</name>
    <message>
        <source>show the board near its edges too.</source>
        <translation>也请在画面边缘附近展示标定板。</translation>
    </message>
</context>
<context>
    <name>calibration.show_numbered_tags</name>
    <message>
        <source>show the missing tags (of one family, with the numbers of the labels) or rings, or mark the markers by hand</source>
        <translation>请展示缺少的标签码（同一族，编号与标签一致）或圆环，或手动标出标记</translation>
    </message>
</context>
<context>
    <name>calibration.show_one_charuco</name>
    <message>
        <source>show one ChArUco board</source>
        <translation>请展示一块 ChArUco 标定板</translation>
    </message>
</context>
<context>
    <name>calibration.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and well lit</source>
        <translation>请展示整块标定板，平整、清晰、光线良好</translation>
    </message>
</context>
<context>
    <name>calibration.spread_markers</name>
    <message>
        <source>spread the markers over the floor</source>
        <translation>请把标记分散到地面各处</translation>
    </message>
</context>
<context>
    <name>calibration.spread_or_register_better</name>
    <message>
        <source>spread the points over the floor, or register %1 better first</source>
        <translation>请把点分散到地面各处，或先更好地配准 %1</translation>
    </message>
</context>
<context>
    <name>calibration.spread_points</name>
    <message>
        <source>spread the points over the floor, not along a line</source>
        <translation>请把点分散到地面各处，不要排成一条线</translation>
    </message>
</context>
<context>
    <name>calibration.spread_them</name>
    <message>
        <source>spread them over the floor</source>
        <translation>请把它们分散到地面各处</translation>
    </message>
</context>
<context>
    <name>calibration.squares_without_size</name>
    <message>
        <source>the squares have no size</source>
        <translation>方格没有尺寸</translation>
    </message>
</context>
<context>
    <name>calibration.stand_higher</name>
    <message>
        <source>mount it higher or farther away, or choose a wider lens</source>
        <translation>请放得更高或更远，或选用更广角的镜头</translation>
    </message>
</context>
<context>
    <name>calibration.standard</name>
    <message>
        <source>standard</source>
        <translation>标准</translation>
    </message>
</context>
<context>
    <name>calibration.standard_lens</name>
    <message>
        <source>Standard lens</source>
        <translation>标准镜头</translation>
    </message>
</context>
<context>
    <name>calibration.swap_pair</name>
    <message>
        <source>swap the images of the two cameras</source>
        <translation>请交换两台相机的图片</translation>
    </message>
</context>
<context>
    <name>calibration.tag_seen_often</name>
    <message>
        <source>tag %1 (marker %2) appears %3 times</source>
        <translation>标签码 %1（标记 %2）出现 %3 次</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_by_place_too</name>
    <message>
        <source>the tags fit the layout by the numbers in its labels and, numbered from 0, by its order</source>
        <translation>标签码按布局标签中的编号吻合，按布局顺序从 0 编号也吻合</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_nowhere</name>
    <message>
        <source>tags with the layout&apos;s numbers are there (%1), but not at its positions</source>
        <translation>存在带有布局编号的标签码（%1），但不在布局的位置上</translation>
    </message>
</context>
<context>
    <name>calibration.tags_mirrored</name>
    <message>
        <source>%1 tags were found, mirrored</source>
        <translation>找到 %1 个镜像的标签</translation>
    </message>
</context>
<context>
    <name>calibration.tags_of_two_families</name>
    <message>
        <source>tags of two families, %1 and %2, fit the layout</source>
        <translation>%1 和 %2 两族标签码都与布局吻合</translation>
    </message>
</context>
<context>
    <name>calibration.take_at_same_moment</name>
    <message>
        <source>check that the files belong together in this order and were taken at the same moments, and that both lens calibrations belong to these cameras</source>
        <translation>请检查文件是否按此顺序对应并在同一时刻拍摄，以及两个镜头标定是否属于这两台相机</translation>
    </message>
</context>
<context>
    <name>calibration.take_ten</name>
    <message>
        <source>take ten or more, the board tilted differently in each</source>
        <translation>请拍十张或以上，每张标定板倾斜不同</translation>
    </message>
</context>
<context>
    <name>calibration.tape_sigma_not_positive</name>
    <message>
        <source>the σ of the tape measure is not above 0</source>
        <translation>卷尺的 σ 不大于 0</translation>
    </message>
</context>
<context>
    <name>calibration.tell_by_hand</name>
    <message>
        <source>mark by hand which of them is %1</source>
        <translation>请手动指出哪一个是 %1</translation>
    </message>
</context>
<context>
    <name>calibration.tenths_of_mm</name>
    <message>
        <source>tenths of a mm</source>
        <translation>十分之一毫米</translation>
    </message>
</context>
<context>
    <name>calibration.thousandths_of_mm</name>
    <message>
        <source>thousandths of a mm</source>
        <translation>千分之一毫米</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_board</name>
    <message>
        <source>take images with the board tilted by 30 to 45 degrees, to each side</source>
        <translation>请把标定板向各侧倾斜 30 到 45 度拍摄</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_less</name>
    <message>
        <source>tilt it by 30 to 45 degrees</source>
        <translation>请倾斜 30 到 45 度</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_or_charuco</name>
    <message>
        <source>show it in more positions with different tilts, or use a ChArUco board</source>
        <translation>请以不同倾斜在更多位置展示，或使用 ChArUco 标定板</translation>
    </message>
</context>
<context>
    <name>calibration.told_board_too_small</name>
    <message>
        <source>a board of %1 inner corners is too small</source>
        <translation>%1 内角点的标定板太小</translation>
    </message>
</context>
<context>
    <name>calibration.told_length_not_positive</name>
    <message>
        <source>the entered length is not above 0</source>
        <translation>给出的长度不大于 0</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_corners</name>
    <message>
        <source>it has %1 corners of the board, six are needed</source>
        <translation>其中有标定板的 %1 个角点，需要六个</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_found_again</name>
    <message>
        <source>%1 of its %2 markers were found again, two are needed</source>
        <translation>其 %2 个标记中重新找到 %1 个，需要两个</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_pictures</name>
    <message>
        <source>calibration needs three images of the board, %1 can be used</source>
        <translation>需要三张标定板图片，可用 %1 张</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_shapes</name>
    <message>
        <source>%1 rings or dots were found, four are needed</source>
        <translation>找到 %1 个圆环或圆点，需要四个</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_to_compare</name>
    <message>
        <source>too few images to compare it with other models</source>
        <translation>图片太少，无法与其他模型比较</translation>
    </message>
</context>
<context>
    <name>calibration.too_frontal</name>
    <message>
        <source>the board faces the camera too directly</source>
        <translation>标定板过于正对相机</translation>
    </message>
</context>
<context>
    <name>calibration.too_small_for_board</name>
    <message>
        <source>the image is too small for a board</source>
        <translation>图像太小，容不下标定板</translation>
    </message>
</context>
<context>
    <name>calibration.trying_positions</name>
    <message>
        <source>trying other positions of the cameras</source>
        <translation>正在尝试其他相机位置</translation>
    </message>
</context>
<context>
    <name>calibration.two_cameras_needed</name>
    <message>
        <source>layout &apos;%2&apos; has %1 registered camera, two are needed</source>
        <translation>布局“%2”上有 %1 台相机，需要两台</translation>
    </message>
</context>
<context>
    <name>calibration.two_directions</name>
    <message>
        <source>both an angle and a pair of markers were given for X</source>
        <translation>对 X 轴同时给出了角度和一对标记</translation>
    </message>
</context>
<context>
    <name>calibration.two_focal_lengths</name>
    <message>
        <source>the images do not agree on one focal length</source>
        <translation>这些图片对应两个焦距</translation>
    </message>
</context>
<context>
    <name>calibration.two_origins</name>
    <message>
        <source>both a marker and a point were given for the origin</source>
        <translation>对原点同时给出了标记和点</translation>
    </message>
</context>
<context>
    <name>calibration.typical_testbed</name>
    <message>
        <source>a %1 × %2 floor seen from %3 above</source>
        <translation>从 %3 高处看的 %1 × %2 地面</translation>
    </message>
</context>
<context>
    <name>calibration.u_outside</name>
    <message>
        <source>u = %1 of marker %2 is outside the image of %3</source>
        <translation>标记 %2 的 u = %1 在 %3 图像之外</translation>
    </message>
</context>
<context>
    <name>calibration.u_v_swapped</name>
    <message>
        <source>with u and v swapped they fit to %1: are these columns swapped?</source>
        <translation>交换 u 和 v 后吻合到 %1：这两列是否颠倒了？</translation>
    </message>
</context>
<context>
    <name>calibration.uncertain</name>
    <message>
        <source>Uncertain: %1.</source>
        <translation>存疑：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.unit</name>
    <message>
        <source>unit &apos;%1&apos;</source>
        <translation>单位“%1”</translation>
    </message>
</context>
<context>
    <name>calibration.unit_unknown</name>
    <message>
        <source>it is not known</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_corner</name>
    <message>
        <source>The middle is out of view, ±%1 in the corner near %2.</source>
        <translation>中间看不到，%2 附近的角 ±%1。</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_edge</name>
    <message>
        <source>The middle is out of view, ±%1 at the edge near %2.</source>
        <translation>中间看不到，%2 附近的边缘 ±%1。</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_near</name>
    <message>
        <source>The middle is out of view, ±%1 near %2.</source>
        <translation>中间看不到，%2 附近 ±%1。</translation>
    </message>
</context>
<context>
    <name>calibration.usable</name>
    <message>
        <source>Usable: %1.</source>
        <translation>可用：%1。</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_picture</name>
    <message>
        <source>use an image from the camera</source>
        <translation>请使用该相机的图像</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_pictures</name>
    <message>
        <source>use images from the camera</source>
        <translation>请使用该相机的图像</translation>
    </message>
</context>
<context>
    <name>calibration.use_known_unit</name>
    <message>
        <source>use mm, cm, m or inch</source>
        <translation>请使用 mm、cm、m 或 inch</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_camera</name>
    <message>
        <source>use images of one camera at one zoom and focus</source>
        <translation>请使用同一相机、同一变焦与对焦的图片</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_resolution</name>
    <message>
        <source>use images of one camera at one resolution</source>
        <translation>请使用同一相机、同一分辨率的图片</translation>
    </message>
</context>
<context>
    <name>calibration.usual_lens</name>
    <message>
        <source>the images leave it open, so square pixels, an optical centre near the middle and a usual distortion were assumed</source>
        <translation>这些图像无法将其确定，因此假定像素为正方形、光学中心靠近图像中心且畸变为常见程度</translation>
    </message>
</context>
<context>
    <name>calibration.v_from_below</name>
    <message>
        <source>v = %1 - v fits to %2: is v counted from below?</source>
        <translation>v = %1 - v 时吻合到 %2：v 是从下往上计的吗？</translation>
    </message>
</context>
<context>
    <name>calibration.v_outside</name>
    <message>
        <source>v = %1 of marker %2 is outside the image of %3</source>
        <translation>标记 %2 的 v = %1 在 %3 图像之外</translation>
    </message>
</context>
<context>
    <name>calibration.were_kept</name>
    <message>
        <source>they were kept</source>
        <translation>它们已保留</translation>
    </message>
</context>
<context>
    <name>calibration.whether_moved</name>
    <message>
        <source>cannot determine whether %1 has moved</source>
        <translation>无法判断 %1 是否移动</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_centre</name>
    <message>
        <source>Check %1: without it the optical centre moves by %2.</source>
        <translation>请检查 %1：去掉它后光学中心移动 %2。</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_focal</name>
    <message>
        <source>Check %1: without it the focal length changes by %2.</source>
        <translation>请检查 %1：去掉它后焦距变化 %2。</translation>
    </message>
</context>
<context>
    <name>calibration.write_tags_as</name>
    <message>
        <source>write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13</source>
        <translation>标签码写作 100 或 36h11:100，其角写作 100.tl，两个标签码的中点写作 12+13</translation>
    </message>
</context>
<context>
    <name>calibration.wrong_by_more</name>
    <message>
        <source>it may be wrong by much more</source>
        <translation>误差可能大得多</translation>
    </message>
</context>
<context>
    <name>calibration.x_without_length</name>
    <message>
        <source>the two markers for the X axis have the same position</source>
        <translation>X 轴所经的标记位于同一处</translation>
    </message>
</context>
<context>
    <name>calibration.y_left_of_x</name>
    <message>
        <source>seen from above, Y must point to the left of X</source>
        <translation>从上方看，Y 必须指向 X 的左侧</translation>
    </message>
</context>
<context>
    <name>capture.access_to_cameras</name>
    <message>
        <source>Access to cameras</source>
        <translation>相机访问权限</translation>
    </message>
</context>
<context>
    <name>capture.all_pictures_damaged</name>
    <message>
        <source>all its frames arrive damaged</source>
        <translation>其画面全部损坏</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent</name>
    <message>
        <source>it answers but sends no frames</source>
        <translation>它有响应，但没有发送画面</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent_advice</name>
    <message>
        <source>check its trigger and this computer&apos;s firewall</source>
        <translation>请检查其触发设置和本机防火墙</translation>
    </message>
</context>
<context>
    <name>capture.aravis_place_missing</name>
    <message>
        <source>it contains neither an address nor a serial number</source>
        <translation>其中既没有地址也没有序列号</translation>
    </message>
</context>
<context>
    <name>capture.aravis_wishes</name>
    <message>
        <source>use rate, exposure_ms, gain, format, size, trigger=software, packet_size or packet_delay_us, as in ?rate=30&amp;size=640x480</source>
        <translation>请使用 rate、exposure_ms、gain、format、size、trigger=software、packet_size 或 packet_delay_us，如 ?rate=30&amp;size=640x480</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_less</name>
    <message>
        <source>choose a smaller size or a lower rate</source>
        <translation>请要求更小的尺寸或帧率</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_other_mode</name>
    <message>
        <source>choose another size or format</source>
        <translation>请要求其他尺寸或格式</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_something_else</name>
    <message>
        <source>use another value, or leave the choice to the camera</source>
        <translation>请要求其他值，或交由相机决定</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_usable_format</name>
    <message>
        <source>choose one of %1</source>
        <translation>请要求 %1 之一</translation>
    </message>
</context>
<context>
    <name>capture.ask_within_sensor</name>
    <message>
        <source>choose a size within that</source>
        <translation>请要求不超过它的尺寸</translation>
    </message>
</context>
<context>
    <name>capture.automatics_held</name>
    <message>
        <source>exposure, gain, white balance and focus are held</source>
        <translation>曝光、增益、白平衡和对焦已固定</translation>
    </message>
</context>
<context>
    <name>capture.automatics_of_camera</name>
    <message>
        <source>Automatic settings, camera %1</source>
        <translation>自动功能，相机 %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_enough</name>
    <message>
        <source>up to %1, enough for network cameras</source>
        <translation>最大 %1，足够网络相机使用</translation>
    </message>
</context>
<context>
    <name>capture.buffer_not_known</name>
    <message>
        <source>the system does not report its maximum size (net.core.rmem_max)</source>
        <translation>系统没有给出其最大值（net.core.rmem_max）</translation>
    </message>
</context>
<context>
    <name>capture.buffer_small</name>
    <message>
        <source>only %1</source>
        <translation>仅 %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_without_use</name>
    <message>
        <source>%1, too small only for network cameras</source>
        <translation>%1，仅对网络相机太小</translation>
    </message>
</context>
<context>
    <name>capture.bus_of_speed_shared</name>
    <message>
        <source>cameras %1 share the bus %2, of %3</source>
        <translation>相机 %1 共用总线 %2（%3）</translation>
    </message>
</context>
<context>
    <name>capture.bus_shared</name>
    <message>
        <source>cameras %1 share the bus %2</source>
        <translation>相机 %1 共用总线 %2</translation>
    </message>
</context>
<context>
    <name>capture.came_back_changed</name>
    <message>
        <source>it came back with another frame size or format</source>
        <translation>恢复后图像的尺寸或格式变了</translation>
    </message>
</context>
<context>
    <name>capture.camera_at_address</name>
    <message>
        <source>camera %1</source>
        <translation>相机 %1</translation>
    </message>
</context>
<context>
    <name>capture.camera_does_not_deliver</name>
    <message>
        <source>a camera sends no frames</source>
        <translation>有一台相机没有输出</translation>
    </message>
</context>
<context>
    <name>capture.cameras_are_listed</name>
    <message>
        <source>odograph cameras lists them</source>
        <translation>“录制”中的“相机…”会列出它们</translation>
    </message>
</context>
<context>
    <name>capture.cameras_will_lose</name>
    <message>
        <source>%1 will lose frames</source>
        <translation>%1 会丢帧</translation>
    </message>
</context>
<context>
    <name>capture.cannot_be_opened</name>
    <message>
        <source>it cannot be opened (%1)</source>
        <translation>无法打开（%1）</translation>
    </message>
</context>
<context>
    <name>capture.check_cable</name>
    <message>
        <source>check its cable</source>
        <translation>请检查其线缆</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_address</name>
    <message>
        <source>check its cable and address</source>
        <translation>请检查其电缆和地址</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_network</name>
    <message>
        <source>check its cable and the network</source>
        <translation>请检查其线缆和网络</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_cable</name>
    <message>
        <source>check its power and cable</source>
        <translation>请检查其电源和电缆</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_network</name>
    <message>
        <source>check its power and cable, and that this computer has an address in the camera&apos;s network</source>
        <translation>请检查其电源和电缆，以及本机在相机网络中有地址</translation>
    </message>
</context>
<context>
    <name>capture.check_usb_rights</name>
    <message>
        <source>check that you may use it (a udev rule), and that no other program does</source>
        <translation>请检查是否有权使用（udev 规则），且没有其他程序占用</translation>
    </message>
</context>
<context>
    <name>capture.choose_another_value</name>
    <message>
        <source>choose another one</source>
        <translation>请另选一个</translation>
    </message>
</context>
<context>
    <name>capture.choose_listed</name>
    <message>
        <source>choose a camera that odograph cameras lists</source>
        <translation>请选择“录制”中“相机…”列出的相机</translation>
    </message>
</context>
<context>
    <name>capture.choose_of_offer</name>
    <message>
        <source>choose one that it offers</source>
        <translation>请从其提供的模式中选择</translation>
    </message>
</context>
<context>
    <name>capture.choose_value_between</name>
    <message>
        <source>choose a value between</source>
        <translation>请选择其间的值</translation>
    </message>
</context>
<context>
    <name>capture.close_that_program</name>
    <message>
        <source>close that program</source>
        <translation>请关闭该程序</translation>
    </message>
</context>
<context>
    <name>capture.connect_right_camera</name>
    <message>
        <source>reconnect the original camera, or start over with this one</source>
        <translation>请接上原来的相机，或用这一台重新开始</translation>
    </message>
</context>
<context>
    <name>capture.control_automatic</name>
    <message>
        <source>%1 cannot be set while it is automatic</source>
        <translation>%1 处于自动时无法设置</translation>
    </message>
</context>
<context>
    <name>capture.control_goes</name>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1 的范围为 %2 到 %3</translation>
    </message>
</context>
<context>
    <name>capture.control_inactive</name>
    <message>
        <source>%1 cannot be set in the camera&apos;s current mode</source>
        <translation>相机当前状态下无法设置 %1</translation>
    </message>
</context>
<context>
    <name>capture.control_not_taken</name>
    <message>
        <source>it rejects this value for %1 (%2)</source>
        <translation>它不接受 %1 的这个值（%2）</translation>
    </message>
</context>
<context>
    <name>capture.control_value_refused</name>
    <message>
        <source>it rejects this value of %1</source>
        <translation>它拒绝 %1 的这个值</translation>
    </message>
</context>
<context>
    <name>capture.damaged_advice</name>
    <message>
        <source>try another cable or port, or choose a lower rate or a smaller frame size</source>
        <translation>请换一根线缆或一个接口，或要求更少或更小的画面</translation>
    </message>
</context>
<context>
    <name>capture.dim_light_halves_rate</name>
    <message>
        <source>in dim light a camera halves its rate unless its automatic exposure is off</source>
        <translation>光线暗时，除非关闭自动曝光，相机会自行把帧率减半</translation>
    </message>
</context>
<context>
    <name>capture.disk_full</name>
    <message>
        <source>its disk has only %1 left, of which %2 are kept free</source>
        <translation>其磁盘仅剩 %1，其中 %2 MB 要保持空闲</translation>
    </message>
</context>
<context>
    <name>capture.disk_of</name>
    <message>
        <source>the disk of %1</source>
        <translation>%1 的磁盘</translation>
    </message>
</context>
<context>
    <name>capture.disk_too_slow</name>
    <message>
        <source>it is too slow</source>
        <translation>它太慢了</translation>
    </message>
</context>
<context>
    <name>capture.does_not_answer</name>
    <message>
        <source>it does not answer</source>
        <translation>没有响应</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start</name>
    <message>
        <source>it does not start (%1)</source>
        <translation>无法启动（%1）</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start_advice</name>
    <message>
        <source>check its cable, and that no other program uses it</source>
        <translation>请检查其电缆，以及没有其他程序占用</translation>
    </message>
</context>
<context>
    <name>capture.end_other_writers</name>
    <message>
        <source>stop other programs that write to it</source>
        <translation>请停止其他写入它的程序</translation>
    </message>
</context>
<context>
    <name>capture.enlarge_buffer</name>
    <message>
        <source>sudo sysctl -w net.core.rmem_max=%1, and add the same line to /etc/sysctl.d/ to keep it</source>
        <translation>sudo sysctl -w net.core.rmem_max=%1，并写入 /etc/sysctl.d/ 以保留</translation>
    </message>
</context>
<context>
    <name>capture.expose_for_mains</name>
    <message>
        <source>expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz</source>
        <translation>50 Hz 电网请曝光 10 或 20 ms，60 Hz 请曝光 8.3 或 16.7 ms</translation>
    </message>
</context>
<context>
    <name>capture.exposed_for</name>
    <message>
        <source>exposed for %1</source>
        <translation>曝光 %1</translation>
    </message>
</context>
<context>
    <name>capture.exposure_and_gain</name>
    <message>
        <source>Exposure and gain</source>
        <translation>曝光和增益</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_taken</name>
    <message>
        <source>it rejects this exposure (%1)</source>
        <translation>它不接受此曝光（%1）</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_told</name>
    <message>
        <source>it does not report its exposure</source>
        <translation>它不报告曝光时间</translation>
    </message>
</context>
<context>
    <name>capture.exposure_suits_lamps</name>
    <message>
        <source>exposed for %1, which suits lamps</source>
        <translation>曝光 %1，适合灯光</translation>
    </message>
</context>
<context>
    <name>capture.failed</name>
    <message>
        <source>it failed (%1)</source>
        <translation>它出错了（%1）</translation>
    </message>
</context>
<context>
    <name>capture.failed_advice</name>
    <message>
        <source>if this continues, unplug it and plug it in again</source>
        <translation>若持续如此，请拔下后重新插上</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filter_off</name>
    <message>
        <source>its filter is off</source>
        <translation>其滤波已关闭</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filtered</name>
    <message>
        <source>filtered by the camera (%1)</source>
        <translation>由相机滤除（%1）</translation>
    </message>
</context>
<context>
    <name>capture.flicker_of_camera</name>
    <message>
        <source>Lamp flicker, camera %1</source>
        <translation>灯光闪烁，相机 %1</translation>
    </message>
</context>
<context>
    <name>capture.forbidden</name>
    <message>
        <source>you may not use it</source>
        <translation>您无权使用它</translation>
    </message>
</context>
<context>
    <name>capture.forbidden_advice</name>
    <message>
        <source>join the group video (sudo usermod -aG video YOUR-NAME) and log in again</source>
        <translation>请加入 video 组（sudo usermod -aG video YOUR-NAME）并重新登录</translation>
    </message>
</context>
<context>
    <name>capture.format</name>
    <message>
        <source>%1 at %2</source>
        <translation>%2 时的%1</translation>
    </message>
</context>
<context>
    <name>capture.format_not_told</name>
    <message>
        <source>it does not report its pixel format (%1)</source>
        <translation>它没有告知像素格式（%1）</translation>
    </message>
</context>
<context>
    <name>capture.format_not_understood</name>
    <message>
        <source>its pixel format is not supported</source>
        <translation>其像素格式不受支持</translation>
    </message>
</context>
<context>
    <name>capture.free_after_crash</name>
    <message>
        <source>a camera whose program has crashed is free again after some seconds</source>
        <translation>若占用相机的程序崩溃，几秒后相机会恢复可用</translation>
    </message>
</context>
<context>
    <name>capture.gain_not_taken</name>
    <message>
        <source>it rejects this gain (%1)</source>
        <translation>它不接受此增益（%1）</translation>
    </message>
</context>
<context>
    <name>capture.give_address</name>
    <message>
        <source>give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH</source>
        <translation>请写成 v4l2:/dev/video0、aravis:192.168.1.20、sim:A 或 file:PATH</translation>
    </message>
</context>
<context>
    <name>capture.give_aravis_place</name>
    <message>
        <source>give one as aravis:192.168.1.20 or aravis:SERIAL</source>
        <translation>请给出如 aravis:192.168.1.20 或 aravis:SERIAL</translation>
    </message>
</context>
<context>
    <name>capture.gives_no_pictures</name>
    <message>
        <source>%1 sends no frames</source>
        <translation>%1 不输出图像</translation>
    </message>
</context>
<context>
    <name>capture.has_been_away</name>
    <message>
        <source>the connection was lost</source>
        <translation>它曾断开</translation>
    </message>
</context>
<context>
    <name>capture.held_while_recording</name>
    <message>
        <source>they are held while recording</source>
        <translation>录制时会固定</translation>
    </message>
</context>
<context>
    <name>capture.in_step</name>
    <message>
        <source>synchronised to %1</source>
        <translation>同步到 %1</translation>
    </message>
</context>
<context>
    <name>capture.in_step_as_way</name>
    <message>
        <source>at %1 that is %2</source>
        <translation>速度 %1 时为 %2</translation>
    </message>
</context>
<context>
    <name>capture.join_video_group</name>
    <message>
        <source>add yourself to the group video (sudo usermod -aG video $USER), then log out and in again</source>
        <translation>把自己加入 video 组（sudo usermod -aG video $USER），然后注销并重新登录</translation>
    </message>
</context>
<context>
    <name>capture.keep_awake</name>
    <message>
        <source>keep it awake while it records</source>
        <translation>录制时请保持唤醒</translation>
    </message>
</context>
<context>
    <name>capture.kept_before_sleep</name>
    <message>
        <source>the recording up to then is kept</source>
        <translation>此前的内容已保留</translation>
    </message>
</context>
<context>
    <name>capture.large_packets</name>
    <message>
        <source>large packets are allowed</source>
        <translation>允许大数据包</translation>
    </message>
</context>
<context>
    <name>capture.largest_picture</name>
    <message>
        <source>its frames have at most %1 pixels</source>
        <translation>其画面最大为 %1 像素</translation>
    </message>
</context>
<context>
    <name>capture.leave_control_out</name>
    <message>
        <source>leave it out</source>
        <translation>请去掉</translation>
    </message>
</context>
<context>
    <name>capture.look_again</name>
    <message>
        <source>wait a few seconds, then check again</source>
        <translation>请等几秒再看</translation>
    </message>
</context>
<context>
    <name>capture.look_at_cable</name>
    <message>
        <source>check its cable</source>
        <translation>请查看其线缆</translation>
    </message>
</context>
<context>
    <name>capture.lost_by_slow_machine</name>
    <message>
        <source>%1, %2 lost because this machine is too slow</source>
        <translation>%1，因本机太慢丢失 %2 帧</translation>
    </message>
</context>
<context>
    <name>capture.lost_here</name>
    <message>
        <source>%1, %2 lost here</source>
        <translation>%1，在本机丢失 %2 帧</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire</name>
    <message>
        <source>%1, %2 lost on the wire</source>
        <translation>%1，传输中丢失 %2 帧</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire_and_here</name>
    <message>
        <source>%1, %2 lost (%3 on the wire, %4 here)</source>
        <translation>%1，丢失 %2 帧（传输中 %3，本机 %4）</translation>
    </message>
</context>
<context>
    <name>capture.machine_slept</name>
    <message>
        <source>it slept for %1 and recorded nothing meanwhile</source>
        <translation>休眠了 %1，其间没有录制</translation>
    </message>
</context>
<context>
    <name>capture.make_room</name>
    <message>
        <source>free some disk space, or move the project to another disk</source>
        <translation>请腾出空间，或把项目移到另一磁盘</translation>
    </message>
</context>
<context>
    <name>capture.mode_not_taken</name>
    <message>
        <source>it rejects %1</source>
        <translation>它不接受 %1</translation>
    </message>
</context>
<context>
    <name>capture.no_automatics</name>
    <message>
        <source>it has none</source>
        <translation>没有</translation>
    </message>
</context>
<context>
    <name>capture.no_network_camera</name>
    <message>
        <source>no network camera is used</source>
        <translation>未使用网络相机</translation>
    </message>
</context>
<context>
    <name>capture.no_node</name>
    <message>
        <source>this computer has no USB or built-in camera (/dev/video*)</source>
        <translation>本机没有 USB 或内置相机（/dev/video*）</translation>
    </message>
</context>
<context>
    <name>capture.no_node_advice</name>
    <message>
        <source>if one is connected, try another cable and port, without a hub</source>
        <translation>如果已连接，请换一根电缆和端口，不经集线器</translation>
    </message>
</context>
<context>
    <name>capture.no_pair_yet</name>
    <message>
        <source>no frames of the cameras have been paired yet</source>
        <translation>还没有同时拍到的两帧</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_came</name>
    <message>
        <source>no frame arrived for half a second</source>
        <translation>半秒内没有收到图像</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_for</name>
    <message>
        <source>no frame has arrived for %1</source>
        <translation>已有 %1 没有画面</translation>
    </message>
</context>
<context>
    <name>capture.no_readable_format</name>
    <message>
        <source>it offers no supported format</source>
        <translation>没有可读的格式</translation>
    </message>
</context>
<context>
    <name>capture.no_simulated_camera</name>
    <message>
        <source>simulated camera %1 does not exist</source>
        <translation>没有模拟相机 %1</translation>
    </message>
</context>
<context>
    <name>capture.no_software_trigger</name>
    <message>
        <source>it has no software trigger (%1)</source>
        <translation>它没有软件触发（%1）</translation>
    </message>
</context>
<context>
    <name>capture.no_such_address</name>
    <message>
        <source>no kind of camera has an address like this</source>
        <translation>没有这样地址的相机</translation>
    </message>
</context>
<context>
    <name>capture.no_such_control</name>
    <message>
        <source>it has no setting &apos;%1&apos;</source>
        <translation>没有名为“%1”的可设项</translation>
    </message>
</context>
<context>
    <name>capture.no_such_format</name>
    <message>
        <source>it has no format %1 (%2)</source>
        <translation>它没有格式 %1（%2）</translation>
    </message>
</context>
<context>
    <name>capture.no_usable_format</name>
    <message>
        <source>it offers no supported pixel format</source>
        <translation>它没有受支持的像素格式</translation>
    </message>
</context>
<context>
    <name>capture.no_usb_camera</name>
    <message>
        <source>no USB camera is used</source>
        <translation>未使用 USB 相机</translation>
    </message>
</context>
<context>
    <name>capture.nodes_forbidden</name>
    <message>
        <source>you may not use %1</source>
        <translation>您无权使用 %1</translation>
    </message>
</context>
<context>
    <name>capture.nodes_usable</name>
    <message>
        <source>you may use all %1 video devices</source>
        <translation>您可以使用全部 %1 个视频设备</translation>
    </message>
</context>
<context>
    <name>capture.none_lost</name>
    <message>
        <source>%1, none lost</source>
        <translation>%1，无丢失</translation>
    </message>
</context>
<context>
    <name>capture.not_offered</name>
    <message>
        <source>it does not offer the requested mode</source>
        <translation>它不提供所要求的模式</translation>
    </message>
</context>
<context>
    <name>capture.not_registered</name>
    <message>
        <source>it is not registered to the floor</source>
        <translation>它未配准到地面</translation>
    </message>
</context>
<context>
    <name>capture.not_there</name>
    <message>
        <source>it is not connected</source>
        <translation>不存在</translation>
    </message>
</context>
<context>
    <name>capture.nothing_lost_yet</name>
    <message>
        <source>nothing is lost yet</source>
        <translation>尚未丢失任何内容</translation>
    </message>
</context>
<context>
    <name>capture.one_camera_in_step</name>
    <message>
        <source>a single camera needs no synchronisation</source>
        <translation>单台相机始终同步</translation>
    </message>
</context>
<context>
    <name>capture.one_not_held</name>
    <message>
        <source>%1 still adjusts automatically</source>
        <translation>%1 仍在自行变化</translation>
    </message>
</context>
<context>
    <name>capture.open_video_again</name>
    <message>
        <source>open it again to see it from the start</source>
        <translation>请重新打开以从头观看</translation>
    </message>
</context>
<context>
    <name>capture.other_camera_in_place</name>
    <message>
        <source>another camera (%1) has replaced it</source>
        <translation>其位置上是另一台相机（%1）</translation>
    </message>
</context>
<context>
    <name>capture.other_serial_in_place</name>
    <message>
        <source>another camera (%1) has replaced camera %2</source>
        <translation>相机 %2 的位置上是另一台相机（%1）</translation>
    </message>
</context>
<context>
    <name>capture.own_usb_buses</name>
    <message>
        <source>each USB camera has its own bus</source>
        <translation>每台 USB 相机都有自己的总线</translation>
    </message>
</context>
<context>
    <name>capture.packet_delay_not_taken</name>
    <message>
        <source>it rejects this packet delay (%1)</source>
        <translation>它不接受此数据包延迟（%1）</translation>
    </message>
</context>
<context>
    <name>capture.packet_size</name>
    <message>
        <source>Packet size</source>
        <translation>数据包大小</translation>
    </message>
</context>
<context>
    <name>capture.packet_size_not_taken</name>
    <message>
        <source>it rejects this packet size (%1)</source>
        <translation>它不接受此数据包大小（%1）</translation>
    </message>
</context>
<context>
    <name>capture.part_not_understood</name>
    <message>
        <source>&apos;%1&apos; is not valid</source>
        <translation>无法理解“%1”</translation>
    </message>
</context>
<context>
    <name>capture.payload_not_told</name>
    <message>
        <source>it does not report how many bytes a frame has (%1)</source>
        <translation>它没有告知画面大小（%1）</translation>
    </message>
</context>
<context>
    <name>capture.picture_of_camera</name>
    <message>
        <source>a frame of camera %1</source>
        <translation>相机 %1 的一张图片</translation>
    </message>
</context>
<context>
    <name>capture.picture_size_of_camera</name>
    <message>
        <source>Frame size, camera %1</source>
        <translation>画面尺寸，相机 %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_waits_for_disk</name>
    <message>
        <source>a frame has waited %1; the write buffer is %2 full</source>
        <translation>有画面等待了 %1，等待空间已占用 %2</translation>
    </message>
</context>
<context>
    <name>capture.pictures_being_lost</name>
    <message>
        <source>frames are being lost</source>
        <translation>正在丢失画面</translation>
    </message>
</context>
<context>
    <name>capture.pictures_incomplete</name>
    <message>
        <source>its frames arrive incomplete</source>
        <translation>其画面不完整</translation>
    </message>
</context>
<context>
    <name>capture.pictures_may_pulse</name>
    <message>
        <source>brightness may pulse under lamps</source>
        <translation>灯光下画面可能闪动</translation>
    </message>
</context>
<context>
    <name>capture.pictures_without_size</name>
    <message>
        <source>its frames have no size</source>
        <translation>其画面没有尺寸</translation>
    </message>
</context>
<context>
    <name>capture.plug_camera_in_again</name>
    <message>
        <source>plug %1 in again</source>
        <translation>请重新接上 %1</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_again</name>
    <message>
        <source>plug it in again</source>
        <translation>请重新接上</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_or_choose</name>
    <message>
        <source>plug it in, or choose a camera that odograph cameras lists</source>
        <translation>请接上它，或选择“录制”中“相机…”列出的相机</translation>
    </message>
</context>
<context>
    <name>capture.put_disk_back</name>
    <message>
        <source>reconnect its disk, or move its folder back</source>
        <translation>请把其磁盘或文件夹放回原处</translation>
    </message>
</context>
<context>
    <name>capture.rate_not_taken</name>
    <message>
        <source>it rejects this rate (%1)</source>
        <translation>它不接受此帧率（%1）</translation>
    </message>
</context>
<context>
    <name>capture.rate_too_slow</name>
    <message>
        <source>%1 (too slow)</source>
        <translation>%1（太慢）</translation>
    </message>
</context>
<context>
    <name>capture.rates_differ</name>
    <message>
        <source>the cameras run at %1 and %2</source>
        <translation>两台相机分别以 %1 和 %2 运行</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer</name>
    <message>
        <source>Receive buffer</source>
        <translation>接收缓冲区</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer_granted</name>
    <message>
        <source>the system keeps only %1 of the network&apos;s packets</source>
        <translation>系统只保留 %1 的网络数据包</translation>
    </message>
</context>
<context>
    <name>capture.record_elsewhere</name>
    <message>
        <source>record to another disk, or use fewer cameras</source>
        <translation>请录制到另一磁盘，或减少相机</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_kept</name>
    <message>
        <source>what was recorded so far is kept</source>
        <translation>已录制的内容已保留</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_there</name>
    <message>
        <source>it holds what was recorded so far</source>
        <translation>到目前为止录制的内容在那里</translation>
    </message>
</context>
<context>
    <name>capture.recording_file_gone</name>
    <message>
        <source>its file is no longer there</source>
        <translation>其文件已不在</translation>
    </message>
</context>
<context>
    <name>capture.register_in_testbed</name>
    <message>
        <source>register it in Testbed; Odograph needs this to measure where a robot is</source>
        <translation>请在试验场中配准，否则其画面无法给出机器人的位置</translation>
    </message>
</context>
<context>
    <name>capture.room_for</name>
    <message>
        <source>remaining recording time %1</source>
        <translation>剩余录制时间 %1</translation>
    </message>
</context>
<context>
    <name>capture.see_own_line</name>
    <message>
        <source>see the line of that camera</source>
        <translation>请看它自己的那一行</translation>
    </message>
</context>
<context>
    <name>capture.send_less</name>
    <message>
        <source>or set both to MJPEG or to a smaller frame size</source>
        <translation>或让两台都发送 MJPEG 或更小的图像</translation>
    </message>
</context>
<context>
    <name>capture.send_registered_size</name>
    <message>
        <source>set it to the size it was registered at, or calibrate and register it again</source>
        <translation>让它发送配准时的尺寸，或重新标定和配准</translation>
    </message>
</context>
<context>
    <name>capture.sends_no_pictures</name>
    <message>
        <source>it sends no frames</source>
        <translation>它没有发送画面</translation>
    </message>
</context>
<context>
    <name>capture.serial_advice</name>
    <message>
        <source>check its power and cable; odograph cameras lists those that answer</source>
        <translation>请检查其电源和电缆；“录制”中的“相机…”会列出有响应的相机</translation>
    </message>
</context>
<context>
    <name>capture.serial_does_not_answer</name>
    <message>
        <source>no camera of this serial number answers</source>
        <translation>没有此序列号的相机响应</translation>
    </message>
</context>
<context>
    <name>capture.set_as_before</name>
    <message>
        <source>restore its settings, or start over with size and format in its address</source>
        <translation>请照原样设置，或在地址中写明尺寸和格式后重新开始</translation>
    </message>
</context>
<context>
    <name>capture.set_between</name>
    <message>
        <source>set it to something between</source>
        <translation>请设为两者之间的值</translation>
    </message>
</context>
<context>
    <name>capture.set_rate_or_trigger</name>
    <message>
        <source>set both to the same rate, or trigger them together</source>
        <translation>请设为同一帧率，或共同触发</translation>
    </message>
</context>
<context>
    <name>capture.set_receive_buffer</name>
    <message>
        <source>sysctl -w net.core.rmem_max=%1</source>
        <translation>sysctl -w net.core.rmem_max=%1</translation>
    </message>
</context>
<context>
    <name>capture.set_to_mains</name>
    <message>
        <source>set &apos;%1&apos; to your mains frequency</source>
        <translation>请将“%1”设为当地电网</translation>
    </message>
</context>
<context>
    <name>capture.set_to_one_rate</name>
    <message>
        <source>set both to the same rate</source>
        <translation>请把两台设为同一帧率</translation>
    </message>
</context>
<context>
    <name>capture.set_to_something_else</name>
    <message>
        <source>set another value</source>
        <translation>请设为别的值</translation>
    </message>
</context>
<context>
    <name>capture.set_width_and_height</name>
    <message>
        <source>set its width and height</source>
        <translation>请设置其宽和高</translation>
    </message>
</context>
<context>
    <name>capture.several_not_held</name>
    <message>
        <source>%1 still adjust automatically</source>
        <translation>%1 仍在自行变化</translation>
    </message>
</context>
<context>
    <name>capture.simulated_camera</name>
    <message>
        <source>Simulated camera %1</source>
        <translation>模拟相机 %1</translation>
    </message>
</context>
<context>
    <name>capture.size_as_registered</name>
    <message>
        <source>%1, as it was registered</source>
        <translation>%1，与配准时相同</translation>
    </message>
</context>
<context>
    <name>capture.size_not_as_registered</name>
    <message>
        <source>%1, but registered at %2</source>
        <translation>%1，但配准时为 %2</translation>
    </message>
</context>
<context>
    <name>capture.size_not_taken</name>
    <message>
        <source>it rejects this size (%1)</source>
        <translation>它不接受此尺寸（%1）</translation>
    </message>
</context>
<context>
    <name>capture.size_not_told</name>
    <message>
        <source>it does not report its width and height (%1)</source>
        <translation>它没有告知尺寸（%1）</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera</name>
    <message>
        <source>it delivers only %1 frames per second instead of the requested %2</source>
        <translation>要求每秒 %2 帧，实际只有 %1 帧</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera_advice</name>
    <message>
        <source>give it more light or a shorter exposure, or ask for a lower rate</source>
        <translation>请增加光照或缩短曝光，或要求更低的帧率</translation>
    </message>
</context>
<context>
    <name>capture.small_packets</name>
    <message>
        <source>small packets on %1</source>
        <translation>%1 上数据包较小</translation>
    </message>
</context>
<context>
    <name>capture.small_packets_advice</name>
    <message>
        <source>set the MTU of the camera&apos;s network port to 9000 (sudo ip link set dev NAME mtu 9000), if camera and switch support it</source>
        <translation>若相机和交换机支持，请将相机所在端口的 MTU 设为 9000（sudo ip link set dev NAME mtu 9000）</translation>
    </message>
</context>
<context>
    <name>capture.step</name>
    <message>
        <source>Synchronisation</source>
        <translation>同步</translation>
    </message>
</context>
<context>
    <name>capture.take_another_camera</name>
    <message>
        <source>use another camera</source>
        <translation>请换一台相机</translation>
    </message>
</context>
<context>
    <name>capture.take_camera_with_format</name>
    <message>
        <source>use a camera that offers one of %1</source>
        <translation>请使用具有 %1 之一的相机</translation>
    </message>
</context>
<context>
    <name>capture.take_off_and_on</name>
    <message>
        <source>unplug it and plug it in again if this continues</source>
        <translation>若仍如此，请拔下后重新接上</translation>
    </message>
</context>
<context>
    <name>capture.take_simulated_camera</name>
    <message>
        <source>use sim:A or sim:B</source>
        <translation>请使用 sim:A 或 sim:B</translation>
    </message>
</context>
<context>
    <name>capture.taken_up_by_itself</name>
    <message>
        <source>Odograph reconnects automatically</source>
        <translation>它会自动恢复</translation>
    </message>
</context>
<context>
    <name>capture.the_picture</name>
    <message>
        <source>the frame</source>
        <translation>图片</translation>
    </message>
</context>
<context>
    <name>capture.the_recording</name>
    <message>
        <source>the recording %1</source>
        <translation>录像 %1</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent</name>
    <message>
        <source>it is connected but sends no frames</source>
        <translation>它在，但没有发送画面</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent_advice</name>
    <message>
        <source>check its cable; if this continues, plug it in again</source>
        <translation>请检查线缆，若持续如此请重新插拔</translation>
    </message>
</context>
<context>
    <name>capture.these_and_others</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 等</translation>
    </message>
</context>
<context>
    <name>capture.this_computer</name>
    <message>
        <source>this computer</source>
        <translation>本机</translation>
    </message>
</context>
<context>
    <name>capture.turn_automatic_off</name>
    <message>
        <source>turn automatic mode off</source>
        <translation>请关闭自动</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_at_camera</name>
    <message>
        <source>turn it off in the camera&apos;s own program, or keep the light steady while robots run</source>
        <translation>请在相机自带的程序中关闭，或在机器人运行时保持光线稳定</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_automatic_first</name>
    <message>
        <source>first turn off the automatic mode that controls it</source>
        <translation>请先关闭调节它的自动功能</translation>
    </message>
</context>
<context>
    <name>capture.unplugged</name>
    <message>
        <source>it was unplugged</source>
        <translation>它被拔出了</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full</name>
    <message>
        <source>its USB bus has no bandwidth left for its frames (the bus is full, not the disk)</source>
        <translation>其 USB 总线已没有带宽传输图像（满的是总线，不是磁盘）</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full_advice</name>
    <message>
        <source>plug it into a port whose bus no other camera uses, or choose MJPEG, a smaller frame size or a lower rate (?format=MJPG&amp;size=640x480&amp;rate=30)</source>
        <translation>请接到不与其他相机共用总线的端口，或选择 MJPEG、更小的画面或更低的帧率（?format=MJPG&amp;size=640x480&amp;rate=30）</translation>
    </message>
</context>
<context>
    <name>capture.usb_buses</name>
    <message>
        <source>USB buses</source>
        <translation>USB 总线</translation>
    </message>
</context>
<context>
    <name>capture.use_daylight</name>
    <message>
        <source>or use daylight</source>
        <translation>或使用日光</translation>
    </message>
</context>
<context>
    <name>capture.use_other_port</name>
    <message>
        <source>plug one into a port on the other side of the computer, or into its own USB card</source>
        <translation>把其中一台接到电脑另一侧的端口或独立的扩展卡</translation>
    </message>
</context>
<context>
    <name>capture.used_by_another_program</name>
    <message>
        <source>another program uses it</source>
        <translation>另一程序正在使用它</translation>
    </message>
</context>
<context>
    <name>capture.used_by_program</name>
    <message>
        <source>another program uses it (open in %1)</source>
        <translation>另一程序正在使用它（已在 %1 中打开）</translation>
    </message>
</context>
<context>
    <name>capture.usual_mains</name>
    <message>
        <source>50 Hz in most countries, 60 Hz in the Americas</source>
        <translation>多数国家 50 Hz，美洲 60 Hz</translation>
    </message>
</context>
<context>
    <name>capture.v4l2_address_example</name>
    <message>
        <source>write it like v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</source>
        <translation>请写成例如 v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</translation>
    </message>
</context>
<context>
    <name>capture.video_has_ended</name>
    <message>
        <source>the video has ended</source>
        <translation>视频已结束</translation>
    </message>
</context>
<context>
    <name>capture.wait_for_it</name>
    <message>
        <source>wait: Odograph is reconnecting</source>
        <translation>请稍候：它会恢复</translation>
    </message>
</context>
<context>
    <name>capture.wait_or_check_cable</name>
    <message>
        <source>wait, or check its cable</source>
        <translation>请等待，或检查其电缆</translation>
    </message>
</context>
<context>
    <name>capture.waiting_for_first_picture</name>
    <message>
        <source>waiting for the first frame</source>
        <translation>正在等待第一帧</translation>
    </message>
</context>
<context>
    <name>exchange.accepted</name>
    <message>
        <source>Accepted: %1</source>
        <translation>已接受：%1</translation>
    </message>
</context>
<context>
    <name>exchange.and_lines_more</name>
    <message>
        <source>and %1 more lines</source>
        <translation>另有 %1 行</translation>
    </message>
</context>
<context>
    <name>exchange.archive_library_refused</name>
    <message>
        <source>the archive library failed</source>
        <translation>归档库拒绝了</translation>
    </message>
</context>
<context>
    <name>exchange.at_line</name>
    <message>
        <source>%1:%2</source>
        <translation>%1:%2</translation>
    </message>
</context>
<context>
    <name>exchange.axes_given</name>
    <message>
        <source>floor axes: %1 of the file</source>
        <translation>地面坐标轴：文件中的 %1</translation>
    </message>
</context>
<context>
    <name>exchange.axes_seen</name>
    <message>
        <source>floor axes: %1 of the file, as its %2 stays near %3</source>
        <translation>地面坐标轴：文件中的 %1，因为其 %2 保持在 %3 附近</translation>
    </message>
</context>
<context>
    <name>exchange.axes_unclear</name>
    <message>
        <source>its z varies by %1 while its %2 stays near %3</source>
        <translation>其 z 变化 %1，而其 %2 保持在 %3 附近</translation>
    </message>
</context>
<context>
    <name>exchange.begin_roster</name>
    <message>
        <source>begin the file with the line class,team or class,team,pseudonym</source>
        <translation>请以 class,team 或 class,team,pseudonym 行作为文件开头</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_header_or_tum</name>
    <message>
        <source>begin the file with the line %1, or write lines of %2</source>
        <translation>请以 %1 行作为文件开头，或写成 %2 的各行</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_line</name>
    <message>
        <source>begin the file with the line %1</source>
        <translation>请以 %1 行作为文件开头</translation>
    </message>
</context>
<context>
    <name>exchange.break_opened</name>
    <message>
        <source>its positions jump by %1 in line %2 and go on from there: %3 positions around count as not measured, and the path ends at the jump</source>
        <translation>其位置在第 %2 行跳变 %1 并从那里继续：周围 %3 个位置视为未测量，路径在跳变处中断</translation>
    </message>
</context>
<context>
    <name>exchange.breaks_too_often</name>
    <message>
        <source>its positions jump %1 times and go on from elsewhere</source>
        <translation>其位置跳变 %1 次并从别处继续</translation>
    </message>
</context>
<context>
    <name>exchange.cell_not_a_number</name>
    <message>
        <source>%1 &apos;%2&apos; is not a finite number</source>
        <translation>%1“%2”不是有限数</translation>
    </message>
</context>
<context>
    <name>exchange.cell_of_columns</name>
    <message>
        <source>it has %1 cell where the header has %2</source>
        <translation>有 %1 个单元格，标题行有 %2 个</translation>
    </message>
</context>
<context>
    <name>exchange.cells_of_columns</name>
    <message>
        <source>it has %1 cells where the header has %2</source>
        <translation>有 %1 个单元格，标题行有 %2 个</translation>
    </message>
</context>
<context>
    <name>exchange.centre_impossible</name>
    <message>
        <source>the image centre (%1, %2) is far outside the image of %3 × %4 pixels</source>
        <translation>图像中心（%1, %2）远在 %3 × %4 像素的图像之外</translation>
    </message>
</context>
<context>
    <name>exchange.check_both_units</name>
    <message>
        <source>choose the units of its times and positions</source>
        <translation>请选择其时间和位置的单位</translation>
    </message>
</context>
<context>
    <name>exchange.check_it_is_there</name>
    <message>
        <source>check that it exists and that you may read it</source>
        <translation>请检查其是否存在且可读</translation>
    </message>
</context>
<context>
    <name>exchange.check_one_run</name>
    <message>
        <source>check that all lines are of one run</source>
        <translation>请检查所有行都属于同一次运行</translation>
    </message>
</context>
<context>
    <name>exchange.check_right_file</name>
    <message>
        <source>check that it is the right file</source>
        <translation>请检查是否为正确的文件</translation>
    </message>
</context>
<context>
    <name>exchange.check_track_column</name>
    <message>
        <source>check which column says the track of a line</source>
        <translation>请检查哪一列表示该行所属的轨迹</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_places</name>
    <message>
        <source>check the unit of the positions: m, cm or mm</source>
        <translation>请检查位置的单位：m、cm 或 mm</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_times</name>
    <message>
        <source>check the unit of the times, and that all lines are of one run</source>
        <translation>请检查时间单位，以及所有行都属于同一次运行</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes</name>
    <message>
        <source>choose the axes of the floor: %1, or xy if that is right</source>
        <translation>请选择地面坐标轴：%1；如果 xy 正确则选 xy</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes_xy</name>
    <message>
        <source>choose the axes x and y</source>
        <translation>请选择 x 轴和 y 轴</translation>
    </message>
</context>
<context>
    <name>exchange.choose_column</name>
    <message>
        <source>choose from %1</source>
        <translation>请从 %1 中选择</translation>
    </message>
</context>
<context>
    <name>exchange.choose_decimal_sign</name>
    <message>
        <source>choose its decimal sign: point or comma</source>
        <translation>请选择小数点符号：点或逗号</translation>
    </message>
</context>
<context>
    <name>exchange.choose_entry</name>
    <message>
        <source>choose one of them</source>
        <translation>请选择其中一台</translation>
    </message>
</context>
<context>
    <name>exchange.choose_likely_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px; %1 is likely</source>
        <translation>请选择其单位：m、cm、mm、in、ft 或 px；很可能是 %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_longer_track</name>
    <message>
        <source>choose a file with three positions or more</source>
        <translation>请选择有三个或更多位置的文件</translation>
    </message>
</context>
<context>
    <name>exchange.choose_new_folder</name>
    <message>
        <source>choose a folder that does not exist yet</source>
        <translation>请选择尚不存在的文件夹</translation>
    </message>
</context>
<context>
    <name>exchange.choose_packed_file</name>
    <message>
        <source>choose a file that Odograph has packed; if it is damaged, copy it again</source>
        <translation>请选择 Odograph 打包的文件，若损坏请重新复制</translation>
    </message>
</context>
<context>
    <name>exchange.choose_style</name>
    <message>
        <source>choose analysis, international or continental</source>
        <translation>请选择 analysis、international 或 continental</translation>
    </message>
</context>
<context>
    <name>exchange.choose_time_unit</name>
    <message>
        <source>choose their unit: s, ms, us, ns, min, h, d or frame; %1 is likely</source>
        <translation>请选择其单位：s、ms、us、ns、min、h、d 或 frame；很可能是 %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px</source>
        <translation>请选择其单位：m、cm、mm、in、ft 或 px</translation>
    </message>
</context>
<context>
    <name>exchange.close_quotes</name>
    <message>
        <source>close the quotes</source>
        <translation>请补上引号</translation>
    </message>
</context>
<context>
    <name>exchange.closed_neither</name>
    <message>
        <source>&apos;closed&apos; is neither true nor false</source>
        <translation>“closed”既不是 true 也不是 false</translation>
    </message>
</context>
<context>
    <name>exchange.coefficients_no_row</name>
    <message>
        <source>&apos;distortion_coefficients&apos; is neither a row nor a column</source>
        <translation>“distortion_coefficients”既不是一行也不是一列</translation>
    </message>
</context>
<context>
    <name>exchange.column_twice</name>
    <message>
        <source>it is named twice</source>
        <translation>重复给出</translation>
    </message>
</context>
<context>
    <name>exchange.columns_assumed</name>
    <message>
        <source>it has no header: its columns count as time, x and y</source>
        <translation>没有标题行：各列视为时间、x 和 y</translation>
    </message>
</context>
<context>
    <name>exchange.commas_group_thousands</name>
    <message>
        <source>commas separate thousands</source>
        <translation>逗号用作千位分隔符</translation>
    </message>
</context>
<context>
    <name>exchange.confidence_not_used</name>
    <message>
        <source>its confidences are neither from 0 to 1 nor from 0 to 100, and were not used</source>
        <translation>其置信度既不在 0 到 1 之间，也不在 0 到 100 之间，未被使用</translation>
    </message>
</context>
<context>
    <name>exchange.csv_column</name>
    <message>
        <source>column &apos;%1&apos; of CSV</source>
        <translation>CSV 列“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.csv_style</name>
    <message>
        <source>style &apos;%1&apos; of CSV</source>
        <translation>CSV 样式“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.cut_line_left_out</name>
    <message>
        <source>the last line, line %1, was left out, because it ends too early</source>
        <translation>最后一行（第 %1 行）已略去，因为它过早结束</translation>
    </message>
</context>
<context>
    <name>exchange.does_not_belong</name>
    <message>
        <source>&apos;%1&apos; does not belong in a packed project</source>
        <translation>“%1”不属于打包的项目</translation>
    </message>
</context>
<context>
    <name>exchange.entry_is_missing</name>
    <message>
        <source>the entry &apos;%1&apos; is missing</source>
        <translation>缺少条目“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.file_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>大于 %1</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_all_cells</name>
    <message>
        <source>give each line as many cells as the header</source>
        <translation>请让每行的单元格数与标题行相同</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_both</name>
    <message>
        <source>fill in both or none</source>
        <translation>请两个都填或都不填</translation>
    </message>
</context>
<context>
    <name>exchange.focal_impossible</name>
    <message>
        <source>no lens has a focal length of %1 at %2 × %3 pixels</source>
        <translation>在 %2 × %3 像素下，没有镜头的焦距为 %1</translation>
    </message>
</context>
<context>
    <name>exchange.format_has_pixels</name>
    <message>
        <source>%1 writes positions in pixels, which are no lengths</source>
        <translation>%1 以像素写出位置，而像素不是长度</translation>
    </message>
</context>
<context>
    <name>exchange.formula</name>
    <message>
        <source>formula &apos;%1&apos;</source>
        <translation>公式“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.formula_advice</name>
    <message>
        <source>write one like 0.5 * mass * max_speed^2, with names of metrics and variables</source>
        <translation>请用指标和变量的名称书写，如 0.5 * mass * max_speed^2</translation>
    </message>
</context>
<context>
    <name>exchange.formula_brace</name>
    <message>
        <source>a closing brace is missing</source>
        <translation>缺少右花括号</translation>
    </message>
</context>
<context>
    <name>exchange.formula_bracket</name>
    <message>
        <source>a closing bracket is missing</source>
        <translation>缺少右括号</translation>
    </message>
</context>
<context>
    <name>exchange.formula_ends</name>
    <message>
        <source>a number or a name is missing at its end</source>
        <translation>末尾缺少数字或名称</translation>
    </message>
</context>
<context>
    <name>exchange.formula_function</name>
    <message>
        <source>there is no function &apos;%1&apos;</source>
        <translation>没有函数“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.formula_number</name>
    <message>
        <source>there is no number at character %1</source>
        <translation>第 %1 个字符处没有数字</translation>
    </message>
</context>
<context>
    <name>exchange.formula_sign</name>
    <message>
        <source>&apos;%1&apos; is not expected at character %2</source>
        <translation>第 %2 个字符处不应出现“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.formula_too_deep</name>
    <message>
        <source>it has too many brackets in each other</source>
        <translation>括号嵌套过多</translation>
    </message>
</context>
<context>
    <name>exchange.formula_too_long</name>
    <message>
        <source>it is too long</source>
        <translation>过长</translation>
    </message>
</context>
<context>
    <name>exchange.formula_two</name>
    <message>
        <source>&apos;%1&apos; takes two values, parted by a comma</source>
        <translation>“%1”需要两个以逗号分隔的值</translation>
    </message>
</context>
<context>
    <name>exchange.frame_without_time</name>
    <message>
        <source>it has no time that can be read</source>
        <translation>其中没有可读的时间</translation>
    </message>
</context>
<context>
    <name>exchange.frames_without_rate</name>
    <message>
        <source>it has frame numbers in place of times</source>
        <translation>只有帧号而没有时间</translation>
    </message>
</context>
<context>
    <name>exchange.give_known_units</name>
    <message>
        <source>give times in s or ms and positions in m, cm or mm</source>
        <translation>时间请用 s 或 ms，位置请用 m、cm 或 mm</translation>
    </message>
</context>
<context>
    <name>exchange.give_lower_confidence</name>
    <message>
        <source>give a lower least confidence</source>
        <translation>请指定更低的最低置信度</translation>
    </message>
</context>
<context>
    <name>exchange.give_marker_label</name>
    <message>
        <source>give each marker a label</source>
        <translation>请给每个标记一个标号</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_path</name>
    <message>
        <source>give one of points_mm, circle, figure_eight or slalom</source>
        <translation>请给出 points_mm、circle、figure_eight、slalom 之一</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_zone</name>
    <message>
        <source>give all corners in order as corners_mm, or two opposite corners as rectangle_mm</source>
        <translation>请沿边界给出 corners_mm，或用 rectangle_mm 给出两个对角</translation>
    </message>
</context>
<context>
    <name>exchange.give_pixel_length</name>
    <message>
        <source>give how long a pixel is on the floor, or choose another unit of the positions</source>
        <translation>请给出一个像素在地面上的长度，或选择位置的其他单位</translation>
    </message>
</context>
<context>
    <name>exchange.give_point_label</name>
    <message>
        <source>give each point a label</source>
        <translation>请给每个点一个标号</translation>
    </message>
</context>
<context>
    <name>exchange.give_rate</name>
    <message>
        <source>give the frame rate of the camera</source>
        <translation>请给出相机的帧率</translation>
    </message>
</context>
<context>
    <name>exchange.give_two_corners</name>
    <message>
        <source>give two opposite corners: [[x, y], [x, y]]</source>
        <translation>请给出两个对角：[[x, y], [x, y]]</translation>
    </message>
</context>
<context>
    <name>exchange.has_become_shorter</name>
    <message>
        <source>it has become shorter during packing</source>
        <translation>其间变短了</translation>
    </message>
</context>
<context>
    <name>exchange.held_left_out</name>
    <message>
        <source>%1 positions that only repeat the last one count as not measured; the first is in line %2</source>
        <translation>%1 个只是重复上一个的位置视为未测量；第一个在第 %2 行</translation>
    </message>
</context>
<context>
    <name>exchange.is_in_it_twice</name>
    <message>
        <source>it contains &apos;%1&apos; twice</source>
        <translation>其中“%1”出现了两次</translation>
    </message>
</context>
<context>
    <name>exchange.is_no_utf8</name>
    <message>
        <source>it is not a UTF-8 text file</source>
        <translation>不是 UTF-8 文本文件</translation>
    </message>
</context>
<context>
    <name>exchange.is_utf16</name>
    <message>
        <source>it is written in UTF-16</source>
        <translation>其编码为 UTF-16</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_no_text</name>
    <message>
        <source>a key is not text, or a bracket is not closed</source>
        <translation>某个键不是文本，或者括号没有闭合</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_there_twice</name>
    <message>
        <source>the key &apos;%1&apos; appears twice</source>
        <translation>键“%1”出现两次</translation>
    </message>
</context>
<context>
    <name>exchange.key_not_known</name>
    <message>
        <source>the key &apos;%1&apos; is not known</source>
        <translation>键“%1”未知</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_empty</name>
    <message>
        <source>the label is empty</source>
        <translation>标号为空</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_there</name>
    <message>
        <source>line %2 already has the label &apos;%1&apos;</source>
        <translation>标号“%1”已在第 %2 行</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_column</name>
    <message>
        <source>it lacks the column %1</source>
        <translation>缺少列 %1</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_header</name>
    <message>
        <source>it lacks the expected header line</source>
        <translation>缺少所需的标题行</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_confidence</name>
    <message>
        <source>leave out the least confidence</source>
        <translation>不要指定最低置信度</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_rate</name>
    <message>
        <source>leave out the frame rate</source>
        <translation>不要指定帧率</translation>
    </message>
</context>
<context>
    <name>exchange.lens_model_not_known</name>
    <message>
        <source>the lens model &apos;%1&apos; is unknown (known models: plumb_bob, rational_polynomial, equidistant)</source>
        <translation>镜头模型“%1”未知（已知 plumb_bob、rational_polynomial、equidistant）</translation>
    </message>
</context>
<context>
    <name>exchange.line_too_long</name>
    <message>
        <source>it is longer than 8 MiB</source>
        <translation>超过 8 MiB</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_class</name>
    <message>
        <source>line %1 has no class for team &apos;%2&apos;</source>
        <translation>第 %1 行没有小组“%2”的班级</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_team</name>
    <message>
        <source>line %1 has no team</source>
        <translation>第 %1 行没有小组</translation>
    </message>
</context>
<context>
    <name>exchange.longer_than_a_week</name>
    <message>
        <source>it is more than a week after the first line</source>
        <translation>比第一行晚一周以上</translation>
    </message>
</context>
<context>
    <name>exchange.marks_left_out</name>
    <message>
        <source>%1 positions that only mark a lost robot (such as 0, 0) count as not measured; the first is in line %2</source>
        <translation>%1 个仅表示机器人丢失的位置（如 0, 0）视为未测量；第一个在第 %2 行</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_not_3_by_3</name>
    <message>
        <source>&apos;camera_matrix&apos; is not a 3 × 3 matrix</source>
        <translation>“camera_matrix”不是 3 × 3 矩阵</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_of_other_form</name>
    <message>
        <source>&apos;camera_matrix&apos; is not of the form fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>“camera_matrix”不是 fx 0 cx, 0 fy cy, 0 0 1 的形式</translation>
    </message>
</context>
<context>
    <name>exchange.measured_otherwise</name>
    <message>
        <source>It was analysed with a different course than its task has now.</source>
        <translation>它是按与任务当前赛道不同的赛道分析的。</translation>
    </message>
</context>
<context>
    <name>exchange.mend_lines</name>
    <message>
        <source>correct these lines</source>
        <translation>请修正这些行</translation>
    </message>
</context>
<context>
    <name>exchange.name_column_once</name>
    <message>
        <source>name each column once</source>
        <translation>每列只给出一次</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_position</name>
    <message>
        <source>track &apos;%1&apos; has %2 position</source>
        <translation>轨迹“%1”有 %2 个位置</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_positions</name>
    <message>
        <source>track &apos;%1&apos; has %2 positions</source>
        <translation>轨迹“%1”有 %2 个位置</translation>
    </message>
</context>
<context>
    <name>exchange.neither_header_nor_tum</name>
    <message>
        <source>it has no header with a time, x and y, and it is not a TUM file</source>
        <translation>没有含时间、x 和 y 的标题行，也不是 TUM</translation>
    </message>
</context>
<context>
    <name>exchange.nested_too_deep</name>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation>嵌套超过 %1 层</translation>
    </message>
</context>
<context>
    <name>exchange.no_anchors</name>
    <message>
        <source>anchors and aliases are not supported</source>
        <translation>不支持锚点和别名</translation>
    </message>
</context>
<context>
    <name>exchange.no_confidence</name>
    <message>
        <source>it has no column of confidences</source>
        <translation>没有置信度列</translation>
    </message>
</context>
<context>
    <name>exchange.no_header_and_no_times</name>
    <message>
        <source>it has no header, and its columns do not look like time, x and y</source>
        <translation>没有标题行，且各列不像是时间、x 和 y</translation>
    </message>
</context>
<context>
    <name>exchange.no_list_of_numbers</name>
    <message>
        <source>&apos;%1&apos; is not a list of numbers</source>
        <translation>“%1”不是数字列表</translation>
    </message>
</context>
<context>
    <name>exchange.no_markers</name>
    <message>
        <source>no markers follow the header</source>
        <translation>标题行下没有标记</translation>
    </message>
</context>
<context>
    <name>exchange.no_project_inside</name>
    <message>
        <source>it contains no project</source>
        <translation>其中没有项目</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_column</name>
    <message>
        <source>this column does not exist</source>
        <translation>没有这一列</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_entry</name>
    <message>
        <source>it holds no camera &apos;%1&apos;, but %2</source>
        <translation>其中没有相机“%1”，只有 %2</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_style</name>
    <message>
        <source>this style does not exist</source>
        <translation>没有这种样式</translation>
    </message>
</context>
<context>
    <name>exchange.no_task</name>
    <message>
        <source>the file holds no task</source>
        <translation>文件中没有任务</translation>
    </message>
</context>
<context>
    <name>exchange.no_third_axis</name>
    <message>
        <source>it has no third coordinate</source>
        <translation>没有第三个坐标</translation>
    </message>
</context>
<context>
    <name>exchange.no_time_column</name>
    <message>
        <source>no column of it is called a time</source>
        <translation>没有以时间命名的列</translation>
    </message>
</context>
<context>
    <name>exchange.no_track_has_position</name>
    <message>
        <source>none of its tracks has a position</source>
        <translation>其中没有一条轨迹有位置</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_toml</name>
    <message>
        <source>it is not valid TOML (%1)</source>
        <translation>不是有效的 TOML（%1）</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_xml</name>
    <message>
        <source>it is not valid XML (%1)</source>
        <translation>不是有效的 XML（%1）</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_yaml</name>
    <message>
        <source>it is not valid YAML (%1)</source>
        <translation>不是有效的 YAML（%1）</translation>
    </message>
</context>
<context>
    <name>exchange.none_sure_enough</name>
    <message>
        <source>none of its positions has a confidence of %1</source>
        <translation>没有任何位置的置信度达到 %1</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_finite_number</name>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>“%1”不是有限数</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_list</name>
    <message>
        <source>&apos;%1&apos; is not a list in brackets</source>
        <translation>“%1”不是方括号中的列表</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_point</name>
    <message>
        <source>&apos;%1&apos; is not a point [x, y] in mm</source>
        <translation>“%1”不是以 mm 为单位的点 [x, y]</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_time</name>
    <message>
        <source>&apos;%1&apos; is not a time</source>
        <translation>“%1”不是时间</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_whole_number</name>
    <message>
        <source>&apos;%1&apos; is not a whole number from %2 to %3</source>
        <translation>“%1”不是 %2 到 %3 的整数</translation>
    </message>
</context>
<context>
    <name>exchange.not_above_zero</name>
    <message>
        <source>&apos;%1&apos; is not above zero</source>
        <translation>“%1”不大于零</translation>
    </message>
</context>
<context>
    <name>exchange.not_two_corners</name>
    <message>
        <source>&apos;rectangle_mm&apos; is not two corners</source>
        <translation>“rectangle_mm”不是两个角</translation>
    </message>
</context>
<context>
    <name>exchange.nothing_imported</name>
    <message>
        <source>nothing was imported</source>
        <translation>没有导入任何内容</translation>
    </message>
</context>
<context>
    <name>exchange.number_in_two_ways</name>
    <message>
        <source>its numbers can be read in two ways: &apos;%1&apos; with three decimals, or as %2</source>
        <translation>其数字有两种读法：带三位小数的“%1”，或者 %2</translation>
    </message>
</context>
<context>
    <name>exchange.object_expected</name>
    <message>
        <source>it must be an object in braces</source>
        <translation>此处应为花括号中的对象</translation>
    </message>
</context>
<context>
    <name>exchange.one_error_blank</name>
    <message>
        <source>one of its two uncertainties is blank</source>
        <translation>两个误差值中有一个为空</translation>
    </message>
</context>
<context>
    <name>exchange.one_place_blank</name>
    <message>
        <source>one of its two coordinates is blank</source>
        <translation>两个位置值中有一个为空</translation>
    </message>
</context>
<context>
    <name>exchange.one_time_a_frame</name>
    <message>
        <source>give one time for each frame, in the order of the frames, under a name such as t_s</source>
        <translation>请按帧的顺序为每一帧给出一个时间，列名如 t_s</translation>
    </message>
</context>
<context>
    <name>exchange.order_lines</name>
    <message>
        <source>sort the lines by time, with each time only once</source>
        <translation>请按时间排列各行，每个时间只出现一次</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric</name>
    <message>
        <source>own metric &apos;%1&apos;</source>
        <translation>自定义指标“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_choose</name>
    <message>
        <source>choose from %1</source>
        <translation>请从 %1 中选择</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_input</name>
    <message>
        <source>no trial has a metric or variable &apos;%1&apos;</source>
        <translation>没有试验具有指标或变量“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_known</name>
    <message>
        <source>Odograph has a metric of that name</source>
        <translation>Odograph 已有该名称的指标</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_long</name>
    <message>
        <source>its name or unit has more than 60 characters</source>
        <translation>其名称或单位超过 60 个字符</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_name</name>
    <message>
        <source>give it a name of letters, digits and _</source>
        <translation>请使用由字母、数字和 _ 组成的名称</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_no_word</name>
    <message>
        <source>its name is not a single word</source>
        <translation>其名称不是单个词</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_other</name>
    <message>
        <source>give it another name</source>
        <translation>请使用其他名称</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_twice</name>
    <message>
        <source>a metric or variable has that name</source>
        <translation>已有指标或变量使用该名称</translation>
    </message>
</context>
<context>
    <name>exchange.pack</name>
    <message>
        <source>pack &apos;%1&apos;</source>
        <translation>打包“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.packing</name>
    <message>
        <source>packing %1</source>
        <translation>正在打包 %1</translation>
    </message>
</context>
<context>
    <name>exchange.path_given_twice</name>
    <message>
        <source>the reference path has more than one shape</source>
        <translation>参考路径给出了两次</translation>
    </message>
</context>
<context>
    <name>exchange.path_not_given</name>
    <message>
        <source>the reference path has no shape</source>
        <translation>没有给出参考路径</translation>
    </message>
</context>
<context>
    <name>exchange.pixel_is</name>
    <message>
        <source>a pixel is %1</source>
        <translation>一个像素为 %1</translation>
    </message>
</context>
<context>
    <name>exchange.place_too_far</name>
    <message>
        <source>its position is more than 100 km away</source>
        <translation>其位置在 100 km 之外</translation>
    </message>
</context>
<context>
    <name>exchange.points_group_thousands</name>
    <message>
        <source>points separate thousands</source>
        <translation>点用作千位分隔符</translation>
    </message>
</context>
<context>
    <name>exchange.positions_are_pixels</name>
    <message>
        <source>its positions are in pixels, which are no lengths</source>
        <translation>其位置以像素为单位，而像素不是长度</translation>
    </message>
</context>
<context>
    <name>exchange.positions_as_metres</name>
    <message>
        <source>its positions have no unit and were read as metres</source>
        <translation>其位置没有单位，已按米读取</translation>
    </message>
</context>
<context>
    <name>exchange.quoted_cell_does_not_end</name>
    <message>
        <source>a quoted cell does not end</source>
        <translation>带引号的单元格没有结束</translation>
    </message>
</context>
<context>
    <name>exchange.rate_beside_times</name>
    <message>
        <source>it has times, and no frame numbers</source>
        <translation>它有时间，而不是帧号</translation>
    </message>
</context>
<context>
    <name>exchange.reading_line</name>
    <message>
        <source>reading line %1</source>
        <translation>正在读取第 %1 行</translation>
    </message>
</context>
<context>
    <name>exchange.roster</name>
    <message>
        <source>roster &apos;%1&apos;</source>
        <translation>名单“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.roster_is_empty</name>
    <message>
        <source>it has no team</source>
        <translation>没有小组</translation>
    </message>
</context>
<context>
    <name>exchange.row_without_time</name>
    <message>
        <source>line %1 was left out, because it has no time</source>
        <translation>第 %1 行已略去，因为没有时间</translation>
    </message>
</context>
<context>
    <name>exchange.rows_without_time</name>
    <message>
        <source>%1 lines were left out, because they have no time; the first is line %2</source>
        <translation>%1 行已略去，因为没有时间；第一行是第 %2 行</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_csv_utf8</name>
    <message>
        <source>save it again as &quot;CSV UTF-8&quot; or as a UTF-8 text</source>
        <translation>请另存为 &quot;CSV UTF-8&quot; 或 UTF-8 文本</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_utf8</name>
    <message>
        <source>save it again as UTF-8 text</source>
        <translation>请另存为 UTF-8 文本</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas</name>
    <message>
        <source>save it with commas</source>
        <translation>请用逗号分隔保存</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas_and_points</name>
    <message>
        <source>save it with commas, and with a point in its numbers</source>
        <translation>请用逗号分隔、数字用小数点保存</translation>
    </message>
</context>
<context>
    <name>exchange.separated_by_semicolons</name>
    <message>
        <source>its columns are separated by semicolons</source>
        <translation>其列以分号分隔</translation>
    </message>
</context>
<context>
    <name>exchange.several_cameras</name>
    <message>
        <source>it holds several cameras: %1</source>
        <translation>其中有多台相机：%1</translation>
    </message>
</context>
<context>
    <name>exchange.several_documents</name>
    <message>
        <source>it holds more than one document</source>
        <translation>其中有不止一个文档</translation>
    </message>
</context>
<context>
    <name>exchange.sides_exchanged</name>
    <message>
        <source>its width and height are exchanged: the image centre (%1, %2) is that of %4 × %3 pixels, not %3 × %4</source>
        <translation>宽和高互换了：图像中心（%1, %2）属于 %4 × %3 像素，而不是 %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_not_above_zero</name>
    <message>
        <source>its uncertainty &apos;%1&apos; is not above zero</source>
        <translation>其不确定度“%1”不大于零</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_or_blank</name>
    <message>
        <source>give the standard deviation of each position, or leave these cells blank</source>
        <translation>请给出每个位置的标准差，或将这些单元格留空</translation>
    </message>
</context>
<context>
    <name>exchange.slalom_without_length</name>
    <message>
        <source>the slalom ends where it starts</source>
        <translation>绕桩的终点与起点相同</translation>
    </message>
</context>
<context>
    <name>exchange.stamp_left_out</name>
    <message>
        <source>line %1 was left out, because its time repeats or is out of order</source>
        <translation>第 %1 行已略去，因为其时间重复或乱序</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_left_out</name>
    <message>
        <source>%1 lines were left out, because their times repeat or are out of order; the first is line %2</source>
        <translation>%1 行已略去，因为其时间重复或乱序；第一行是第 %2 行</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_shared</name>
    <message>
        <source>its times are so coarse that %1 lines share theirs with the line before</source>
        <translation>其时间太粗略，有 %1 行与前一行时间相同</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, %2 frames/s</source>
        <translation>其时间取整到 %1；各行已均匀分布，%2 帧/秒</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread_with_gaps</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, with gaps</source>
        <translation>其时间取整到 %1；各行已均匀分布，并保留空缺</translation>
    </message>
</context>
<context>
    <name>exchange.team_named_again</name>
    <message>
        <source>line %1 names team &apos;%2&apos; again, as line %3</source>
        <translation>第 %1 行再次出现小组“%2”，与第 %3 行相同</translation>
    </message>
</context>
<context>
    <name>exchange.time_goes_back</name>
    <message>
        <source>its time is earlier than in the line before</source>
        <translation>其时间早于上一行</translation>
    </message>
</context>
<context>
    <name>exchange.time_of_no_age</name>
    <message>
        <source>its time is more than a century from 1970</source>
        <translation>其时间距 1970 年超过一个世纪</translation>
    </message>
</context>
<context>
    <name>exchange.time_repeated</name>
    <message>
        <source>its time is the same as in the line before</source>
        <translation>其时间与上一行相同</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_long</name>
    <message>
        <source>if its times are seconds, the rows are %1 apart and the run is %2 long</source>
        <translation>若其时间以秒计，行间隔为 %1，运行时长为 %2</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_short</name>
    <message>
        <source>its times have no unit, and as seconds the rows would be %1 apart</source>
        <translation>其时间没有单位；若以秒计，行间隔将为 %1</translation>
    </message>
</context>
<context>
    <name>exchange.timecode_without_rate</name>
    <message>
        <source>the last part of its times counts frames, up to %1 a second</source>
        <translation>其时间的最后一部分是帧号，每秒至多 %1</translation>
    </message>
</context>
<context>
    <name>exchange.times_by_rate</name>
    <message>
        <source>all its times are the same; the lines were spread at %1 frames/s</source>
        <translation>其所有时间都相同；各行按 %1 帧/秒分布</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_days</name>
    <message>
        <source>times in days, as spreadsheets write them</source>
        <translation>以天为单位的时间，与电子表格的写法相同</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_two_ways</name>
    <message>
        <source>its times can be read in two ways: &apos;%1&apos; with three decimals, or without</source>
        <translation>其时间有两种读法：带三位小数的“%1”，或者不带小数</translation>
    </message>
</context>
<context>
    <name>exchange.times_since_1970</name>
    <message>
        <source>times in %1 since 1970</source>
        <translation>自 1970 年起的时间，单位 %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_as_said</name>
    <message>
        <source>in the units that it gives, the robot would drive at %1</source>
        <translation>按其给出的单位，机器人的速度将为 %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the robot would drive at %1</source>
        <translation>其位置没有单位；若以米计，机器人的速度将为 %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_files</name>
    <message>
        <source>it has too many files</source>
        <translation>文件过多</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_places</name>
    <message>
        <source>the file has more than 1.5 million positions</source>
        <translation>文件中的位置超过 150 万个</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_tracks</name>
    <message>
        <source>the file has more than 1000 tracks</source>
        <translation>文件包含超过 1000 条轨迹</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_values</name>
    <message>
        <source>it holds more than %1 values</source>
        <translation>其中的值超过 %1 个</translation>
    </message>
</context>
<context>
    <name>exchange.too_small_as_said</name>
    <message>
        <source>in the unit that its header gives, its positions stay within %1</source>
        <translation>按标题行给出的单位，其位置都在 %1 之内</translation>
    </message>
</context>
<context>
    <name>exchange.too_wide_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the floor would be %1 wide</source>
        <translation>其位置没有单位；若以米计，地面宽度将为 %1</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_position</name>
    <message>
        <source>the track has %1 position</source>
        <translation>轨迹有 %1 个位置</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_positions</name>
    <message>
        <source>the track has %1 positions</source>
        <translation>轨迹有 %1 个位置</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entries</name>
    <message>
        <source>it has %1 entries instead of the 8 of TUM</source>
        <translation>有 %1 个条目，TUM 应为 8 个</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entry</name>
    <message>
        <source>it has %1 entry instead of the 8 of TUM</source>
        <translation>有 %1 个条目，TUM 应为 8 个</translation>
    </message>
</context>
<context>
    <name>exchange.twins_left_out</name>
    <message>
        <source>%1 lines were left out, because they repeat the line before</source>
        <translation>%1 行已略去，因为与前一行重复</translation>
    </message>
</context>
<context>
    <name>exchange.unit_not_known</name>
    <message>
        <source>its column &apos;%1&apos; is in a unit that is not known</source>
        <translation>其列“%1”的单位未知</translation>
    </message>
</context>
<context>
    <name>exchange.unpack</name>
    <message>
        <source>unpack &apos;%1&apos;</source>
        <translation>解包“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.unpack_into</name>
    <message>
        <source>unpack into &apos;%1&apos;</source>
        <translation>解包到“%1”</translation>
    </message>
</context>
<context>
    <name>exchange.unpacking</name>
    <message>
        <source>unpacking</source>
        <translation>正在解包</translation>
    </message>
</context>
<context>
    <name>exchange.unpacks_too_large</name>
    <message>
        <source>it unpacks to more than a hundred times its size</source>
        <translation>解包后超过其大小的一百倍</translation>
    </message>
</context>
<context>
    <name>exchange.unset_stamps</name>
    <message>
        <source>lines left out because their time is 0: %1</source>
        <translation>因时间为 0 而略去的行数：%1</translation>
    </message>
</context>
<context>
    <name>exchange.unsure_left_out</name>
    <message>
        <source>%1 positions with a confidence below %2 count as not measured; the first is in line %3</source>
        <translation>%1 个置信度低于 %2 的位置视为未测量；第一个在第 %3 行</translation>
    </message>
</context>
<context>
    <name>exchange.use_calibration_file</name>
    <message>
        <source>use a calibration file as ROS, OpenCV, Kalibr, COLMAP, Metashape, anipose or PhotonVision writes it</source>
        <translation>请使用 ROS、OpenCV、Kalibr、COLMAP、Metashape、anipose 或 PhotonVision 写出的标定文件</translation>
    </message>
</context>
<context>
    <name>exchange.use_keys</name>
    <message>
        <source>use %1</source>
        <translation>请使用 %1</translation>
    </message>
</context>
<context>
    <name>exchange.wait_for_writers</name>
    <message>
        <source>wait until no program writes to it, and try again</source>
        <translation>请等到无人写入后重试</translation>
    </message>
</context>
<context>
    <name>exchange.write_class_and_team</name>
    <message>
        <source>write a line with class and team below the header</source>
        <translation>请在标题行下写一行班级和小组</translation>
    </message>
</context>
<context>
    <name>exchange.write_decimal_point</name>
    <message>
        <source>write them with a decimal point</source>
        <translation>请用小数点书写</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits</name>
    <message>
        <source>write it with digits, like 12.5</source>
        <translation>请用数字书写，如 12.5</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits_or_blank</name>
    <message>
        <source>write it with digits, like 12.5, or leave the cell blank</source>
        <translation>请用数字书写，如 12.5，或留空</translation>
    </message>
</context>
<context>
    <name>exchange.write_finer_times</name>
    <message>
        <source>write the times with more digits, or give the frame rate of an even series</source>
        <translation>请用更多位数写出时间，或给出均匀序列的帧率</translation>
    </message>
</context>
<context>
    <name>exchange.write_line_for_marker</name>
    <message>
        <source>write one line for each marker</source>
        <translation>每个标记写一行</translation>
    </message>
</context>
<context>
    <name>exchange.write_object_with</name>
    <message>
        <source>write one with %1</source>
        <translation>请写一个含 %1 的对象</translation>
    </message>
</context>
<context>
    <name>exchange.write_task_as_shown</name>
    <message>
        <source>write the task as odograph task list --json shows one</source>
        <translation>请在“试验场”中创建任务，或按手册所示编写文件</translation>
    </message>
</context>
<context>
    <name>exchange.write_tum_or_header</name>
    <message>
        <source>write %1, or begin the file with the line %2</source>
        <translation>请写 %1，或以 %2 行作为文件开头</translation>
    </message>
</context>
<context>
    <name>exchange.write_value_for_each</name>
    <message>
        <source>write one value for each of %1</source>
        <translation>请为 %1 各写一个值</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_cells</name>
    <message>
        <source>it has %1 cells instead of %2</source>
        <translation>有 %1 个单元格，应为 %2 个</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_numbers</name>
    <message>
        <source>&apos;%1&apos; has %2 numbers instead of %3 × %4</source>
        <translation>“%1”有 %2 个数，应为 %3 × %4 个</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_poles</name>
    <message>
        <source>&apos;poles&apos; is not a whole number from 1 to 100</source>
        <translation>“poles”不是 1 到 100 的整数</translation>
    </message>
</context>
<context>
    <name>exchange.zone_given_twice</name>
    <message>
        <source>the zone has more than one shape</source>
        <translation>区域给出了两次</translation>
    </message>
</context>
<context>
    <name>exchange.zone_not_given</name>
    <message>
        <source>the zone has no shape</source>
        <translation>没有给出区域</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_looked_at</name>
    <message>
        <source>it cannot be accessed (%1)</source>
        <translation>无法查看（%1）</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_read</name>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>无法读取（%1）</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_written</name>
    <message>
        <source>it cannot be written (%1)</source>
        <translation>无法写出（%1）</translation>
    </message>
</context>
<context>
    <name>files.cannot_write</name>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>无法写出“%1”</translation>
    </message>
</context>
<context>
    <name>files.check_file_is_there</name>
    <message>
        <source>check that the file exists and that you may read it</source>
        <translation>请检查文件是否存在且可读</translation>
    </message>
</context>
<context>
    <name>files.check_its_folder</name>
    <message>
        <source>check the free space and the permissions of its folder</source>
        <translation>请检查其文件夹的可用空间和权限</translation>
    </message>
</context>
<context>
    <name>files.check_may_be_read</name>
    <message>
        <source>check that you may read the file</source>
        <translation>请检查是否有权读取该文件</translation>
    </message>
</context>
<context>
    <name>files.check_name</name>
    <message>
        <source>check the name and the folder</source>
        <translation>请检查名称和文件夹</translation>
    </message>
</context>
<context>
    <name>files.choose_another_file</name>
    <message>
        <source>choose another file</source>
        <translation>请选择其他文件</translation>
    </message>
</context>
<context>
    <name>files.choose_another_folder</name>
    <message>
        <source>choose another folder</source>
        <translation>请换个文件夹</translation>
    </message>
</context>
<context>
    <name>files.choose_another_name</name>
    <message>
        <source>choose another name</source>
        <translation>请换个名称</translation>
    </message>
</context>
<context>
    <name>files.choose_folder_with_room</name>
    <message>
        <source>choose a folder that you may write to and that has free space</source>
        <translation>请选择可写且有空间的文件夹</translation>
    </message>
</context>
<context>
    <name>files.choose_name_or_folder</name>
    <message>
        <source>choose another name or folder</source>
        <translation>请换个名称或文件夹</translation>
    </message>
</context>
<context>
    <name>files.choose_shorter_name</name>
    <message>
        <source>choose a shorter name</source>
        <translation>请换个更短的名称</translation>
    </message>
</context>
<context>
    <name>files.choose_writable_folder</name>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>请选择可写的文件夹</translation>
    </message>
</context>
<context>
    <name>files.disk_is_full</name>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
</context>
<context>
    <name>files.file_is_empty</name>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
</context>
<context>
    <name>files.folder_cannot_be_used</name>
    <message>
        <source>its folder cannot be used (%1)</source>
        <translation>无法使用其文件夹（%1）</translation>
    </message>
</context>
<context>
    <name>files.folder_not_writable</name>
    <message>
        <source>the folder &apos;%1&apos; cannot be written to (%2)</source>
        <translation>文件夹“%1”无法写入（%2）</translation>
    </message>
</context>
<context>
    <name>files.has_no_name</name>
    <message>
        <source>it has no name</source>
        <translation>没有名称</translation>
    </message>
</context>
<context>
    <name>files.is_a_database</name>
    <message>
        <source>it is a database</source>
        <translation>是数据库</translation>
    </message>
</context>
<context>
    <name>files.is_another_project</name>
    <message>
        <source>it is another project</source>
        <translation>是另一个项目</translation>
    </message>
</context>
<context>
    <name>files.is_beside_project</name>
    <message>
        <source>it is the log, the lock or a backup of a project</source>
        <translation>是项目的日志、锁或备份文件</translation>
    </message>
</context>
<context>
    <name>files.is_in_media_folder</name>
    <message>
        <source>it is in the media folder of project &apos;%1&apos;</source>
        <translation>位于项目“%1”的媒体文件夹中</translation>
    </message>
</context>
<context>
    <name>files.is_in_some_media_folder</name>
    <message>
        <source>it is in a media folder beside a project</source>
        <translation>它位于某个项目旁的媒体文件夹中</translation>
    </message>
</context>
<context>
    <name>files.is_input</name>
    <message>
        <source>it is an input of the same command</source>
        <translation>是同一次调用的输入文件</translation>
    </message>
</context>
<context>
    <name>files.is_of_another_kind</name>
    <message>
        <source>a file of another kind has that name</source>
        <translation>另一种类型的文件已使用该名称</translation>
    </message>
</context>
<context>
    <name>files.is_open_project</name>
    <message>
        <source>it is a project that is open here</source>
        <translation>它是此处已打开的项目</translation>
    </message>
</context>
<context>
    <name>files.is_temporary_name</name>
    <message>
        <source>Odograph uses such names for temporary files</source>
        <translation>Odograph 将此类名称用于临时文件</translation>
    </message>
</context>
<context>
    <name>files.is_the_project</name>
    <message>
        <source>it is the project itself</source>
        <translation>是项目文件本身</translation>
    </message>
</context>
<context>
    <name>files.is_there_already</name>
    <message>
        <source>it already exists</source>
        <translation>已存在</translation>
    </message>
</context>
<context>
    <name>files.log_left_beside</name>
    <message>
        <source>its folder has &apos;%1&apos;, the log or journal of another file of this name</source>
        <translation>其文件夹中有“%1”，它是另一个同名文件的日志</translation>
    </message>
</context>
<context>
    <name>files.make_folder_first</name>
    <message>
        <source>create the folder first, or choose another one</source>
        <translation>请先建立该文件夹，或选择另一个</translation>
    </message>
</context>
<context>
    <name>files.make_room</name>
    <message>
        <source>free some disk space and try again</source>
        <translation>请腾出磁盘空间后重试</translation>
    </message>
</context>
<context>
    <name>files.move_log_away</name>
    <message>
        <source>choose another name, or move &apos;%1&apos; to another folder first</source>
        <translation>请选择其他名称，或先把“%1”移到其他文件夹</translation>
    </message>
</context>
<context>
    <name>files.name_a_file</name>
    <message>
        <source>give a file name</source>
        <translation>请指定文件</translation>
    </message>
</context>
<context>
    <name>files.name_too_long</name>
    <message>
        <source>its name is too long</source>
        <translation>名称太长</translation>
    </message>
</context>
<context>
    <name>files.names_a_project</name>
    <message>
        <source>only projects have a name ending in .odo</source>
        <translation>以 .odo 结尾的名称只用于项目</translation>
    </message>
</context>
<context>
    <name>files.no_such_file</name>
    <message>
        <source>the file does not exist</source>
        <translation>没有这个文件</translation>
    </message>
</context>
<context>
    <name>files.no_such_folder</name>
    <message>
        <source>folder &apos;%1&apos; does not exist</source>
        <translation>没有文件夹“%1”</translation>
    </message>
</context>
<context>
    <name>files.replace_by_force</name>
    <message>
        <source>choose another name, or replace it with --force</source>
        <translation>请换个名称，或先删除该文件</translation>
    </message>
</context>
<context>
    <name>files.unreadable</name>
    <message>
        <source>it cannot be read</source>
        <translation>无法读取</translation>
    </message>
</context>
<context>
    <name>geometry.add_points</name>
    <message>
        <source>add points</source>
        <translation>请添加点</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place</name>
    <message>
        <source>%1 have the same position</source>
        <translation>%1 位于同一处</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place_in_picture</name>
    <message>
        <source>%1 have the same position in the image</source>
        <translation>%1 在画面中位于同一处</translation>
    </message>
</context>
<context>
    <name>geometry.beyond_horizon</name>
    <message>
        <source>%1 would be beyond the horizon</source>
        <translation>%1 将位于地平线之外</translation>
    </message>
</context>
<context>
    <name>geometry.bow_tie</name>
    <message>
        <source>the order of the points crosses over like a bow tie</source>
        <translation>点的顺序像蝴蝶结一样交叉</translation>
    </message>
</context>
<context>
    <name>geometry.calibrate_again</name>
    <message>
        <source>calibrate the camera again, or import another file</source>
        <translation>请重新标定相机，或导入另一文件</translation>
    </message>
</context>
<context>
    <name>geometry.check_points</name>
    <message>
        <source>check which point is which</source>
        <translation>请检查各点的对应</translation>
    </message>
</context>
<context>
    <name>geometry.coordinate_not_finite</name>
    <message>
        <source>a coordinate of %1 is not a finite number</source>
        <translation>%1 的一个坐标不是有限数</translation>
    </message>
</context>
<context>
    <name>geometry.correct_it</name>
    <message>
        <source>correct it</source>
        <translation>请更正</translation>
    </message>
</context>
<context>
    <name>geometry.correct_one</name>
    <message>
        <source>correct one of them</source>
        <translation>请更正其中之一</translation>
    </message>
</context>
<context>
    <name>geometry.empty_chain</name>
    <message>
        <source>the chain has no links</source>
        <translation>链中没有环节</translation>
    </message>
</context>
<context>
    <name>geometry.focal_not_positive</name>
    <message>
        <source>the focal length %1 is not positive</source>
        <translation>焦距 %1 不为正</translation>
    </message>
</context>
<context>
    <name>geometry.four_points_needed</name>
    <message>
        <source>four points are needed, %1 given</source>
        <translation>需要四个点，给出了 %1 个</translation>
    </message>
</context>
<context>
    <name>geometry.give_one_link</name>
    <message>
        <source>give at least one</source>
        <translation>请至少给出一个</translation>
    </message>
</context>
<context>
    <name>geometry.intrinsics_unusable</name>
    <message>
        <source>these intrinsics cannot be used</source>
        <translation>这些内参无法使用</translation>
    </message>
</context>
<context>
    <name>geometry.no_homography</name>
    <message>
        <source>no homography</source>
        <translation>无法求得单应</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line</name>
    <message>
        <source>%1 lie on one line</source>
        <translation>%1 共线</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line_in_picture</name>
    <message>
        <source>%1 lie on one line in the image</source>
        <translation>%1 在画面中共线</translation>
    </message>
</context>
<context>
    <name>geometry.point</name>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
</context>
<context>
    <name>geometry.points_do_not_tell</name>
    <message>
        <source>the points do not determine it</source>
        <translation>这些点无法确定它</translation>
    </message>
</context>
<context>
    <name>geometry.singular_link</name>
    <message>
        <source>link %1 of %2 of the chain is singular</source>
        <translation>链的第 %1 环（共 %2 环）是奇异的</translation>
    </message>
</context>
<context>
    <name>geometry.size_not_positive</name>
    <message>
        <source>the image size %1 is not positive</source>
        <translation>画面尺寸 %1 不为正</translation>
    </message>
</context>
<context>
    <name>geometry.spread_points</name>
    <message>
        <source>spread the points</source>
        <translation>请把点分散开</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points</name>
    <message>
        <source>use four points of which no three are in line</source>
        <translation>请使用其中任意三点不共线的四个点</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points_in_it</name>
    <message>
        <source>use four points in it of which no three are in line</source>
        <translation>请在该环中使用其中任意三点不共线的四个点</translation>
    </message>
</context>
<context>
    <name>geometry.value_not_finite</name>
    <message>
        <source>one of the values is not a finite number</source>
        <translation>其中一个值不是有限数</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_coefficients</name>
    <message>
        <source>this lens model does not take %1 distortion coefficients</source>
        <translation>%1 个畸变系数不适用于此镜头模型</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_covariance_size</name>
    <message>
        <source>the covariance has the wrong size</source>
        <translation>协方差的尺寸不对</translation>
    </message>
</context>
<context>
    <name>odo::AccuracyDialog</name>
    <message>
        <source>may hang &amp;over the floor</source>
        <translation>可悬挂在地面上方(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Plan a camera</source>
        <translation>规划相机(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Find &amp;best position</source>
        <translation>最佳位置(&amp;B)</translation>
    </message>
    <message>
        <source>Expected accuracy</source>
        <translation>预期精度</translation>
    </message>
    <message>
        <source>Expected accuracy in words</source>
        <translation>预期精度说明</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题所在</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cameras included</source>
        <translation>参与计算的相机</translation>
    </message>
    <message>
        <source>All ticked cameras (joint)</source>
        <translation>所有勾选的相机合用</translation>
    </message>
    <message>
        <source>The chosen camera alone</source>
        <translation>仅所选相机</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>显示(&amp;W)</translation>
    </message>
    <message>
        <source>Height of the robo&amp;t</source>
        <translation>机器人高度(&amp;T)</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>On a ceiling, for example; a tripod would be in the robots&apos; way</source>
        <translation>例如装在天花板下；三脚架则会挡住机器人的路</translation>
    </message>
    <message>
        <source>Moves the camera to where it, together with the other ticked cameras, minimises the largest uncertainty on the floor</source>
        <translation>把相机放到这样的位置：与其他勾选的相机合用时，地面上精度最差的地方也能测得最准</translation>
    </message>
    <message>
        <source>Margin beyond the &amp;markers</source>
        <translation>标记外的范围(&amp;M)</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>规划的相机</translation>
    </message>
    <message>
        <source>%1, registered %2</source>
        <translation>%1，%2 配准</translation>
    </message>
    <message>
        <source>Planned %1</source>
        <translation>规划 %1</translation>
    </message>
    <message>
        <source>%1: %2; %3.</source>
        <translation>%1：%2；%3。</translation>
    </message>
    <message>
        <source>Searching for the best position…</source>
        <translation>正在寻找最佳位置…</translation>
    </message>
    <message>
        <source>&amp;Advice</source>
        <translation>建议(&amp;A)</translation>
    </message>
    <message>
        <source>Which registered camera to move: tries other positions within a metre of each</source>
        <translation>应移动哪台已配准的相机：尝试每台相机一米以内的其他位置</translation>
    </message>
    <message>
        <source>Advice in words</source>
        <translation>文字建议</translation>
    </message>
    <message>
        <source>Trying other positions of the cameras…</source>
        <translation>正在尝试其他相机位置…</translation>
    </message>
    <message>
        <source>%1, moved</source>
        <translation>%1（已移动）</translation>
    </message>
    <message>
        <source>Moving one camera lowers the largest error by less than a tenth.</source>
        <translation>移动一台相机只能使最大误差减小不到十分之一。</translation>
    </message>
</context>
<context>
    <name>odo::BackupsDialog</name>
    <message>
        <source>What restoring would change</source>
        <translation>恢复会改变的内容</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>立即备份(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Restore this backup</source>
        <translation>恢复此备份(&amp;R)</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>备份文件夹</translation>
    </message>
    <message>
        <source>Backups are in %1. They contain everything except the videos.</source>
        <translation>备份位于 %1，包含除视频之外的全部内容。</translation>
    </message>
    <message numerus="yes">
        <source>One is made each day on which you open the project, and kept for %n day(s).</source>
        <translation>
            <numerusform>每天首次打开项目时创建一份，保留 %n 天。</numerusform>
        </translation>
    </message>
    <message>
        <source>Daily backups are switched off in the preferences.</source>
        <translation>每日备份已在首选项中关闭。</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>打开文件夹(&amp;O)</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Changes since this backup</source>
        <translation>此备份之后的更改</translation>
    </message>
    <message>
        <source>%1, before an update</source>
        <translation>%1，更新之前</translation>
    </message>
    <message>
        <source>No backup yet.</source>
        <translation>尚无备份。</translation>
    </message>
    <message>
        <source>Reading the backup…</source>
        <translation>正在读取备份…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) in this backup.</source>
        <translation>
            <numerusform>此备份中有 %n 次试验。</numerusform>
        </translation>
    </message>
    <message>
        <source>Without: %1</source>
        <translation>不含：%1</translation>
    </message>
    <message>
        <source>With, though deleted since: %1</source>
        <translation>含此后已删除的：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n of its video(s) no longer exist.</source>
        <translation>
            <numerusform>其中 %n 个视频已不存在。</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring it discards no changes.</source>
        <translation>恢复它不会丢弃任何更改。</translation>
    </message>
    <message numerus="yes">
        <source>Restoring it discards %n change(s) made since:</source>
        <translation>
            <numerusform>恢复它会丢弃此后的 %n 项更改：</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It brings back %n change(s).</source>
        <translation>
            <numerusform>它会恢复 %n 项更改。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::Badge</name>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>移动了 %1</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>标记移动了 %1</translation>
    </message>
    <message>
        <source>markers not found</source>
        <translation>未找到标记</translation>
    </message>
</context>
<context>
    <name>odo::BoardCanvas</name>
    <message>
        <source>Image of the board</source>
        <translation>标定板图片</translation>
    </message>
    <message>
        <source>residuals, longest %1 px</source>
        <translation>残差，最长 %1 px</translation>
    </message>
</context>
<context>
    <name>odo::BoardImagesPage</name>
    <message>
        <source>Move it to the left of the image</source>
        <translation>移向画面左侧</translation>
    </message>
    <message>
        <source>Move it to the right of the image</source>
        <translation>移向画面右侧</translation>
    </message>
    <message>
        <source>Move it up</source>
        <translation>向上移</translation>
    </message>
    <message>
        <source>Move it down</source>
        <translation>向下移</translation>
    </message>
    <message>
        <source>Closer to the camera</source>
        <translation>靠近相机</translation>
    </message>
    <message>
        <source>Farther from the camera</source>
        <translation>远离相机</translation>
    </message>
    <message>
        <source>Tilt it: the left side away from the camera</source>
        <translation>倾斜：左侧远离相机</translation>
    </message>
    <message>
        <source>Tilt it: the right side away from the camera</source>
        <translation>倾斜：右侧远离相机</translation>
    </message>
    <message>
        <source>Tilt it: the upper side away from the camera</source>
        <translation>倾斜：上侧远离相机</translation>
    </message>
    <message>
        <source>Tilt it: the lower side away from the camera</source>
        <translation>倾斜：下侧远离相机</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>保持不动</translation>
    </message>
    <message>
        <source>&amp;Take an image now</source>
        <translation>立即拍一张(&amp;T)</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>操作提示</translation>
    </message>
    <message>
        <source>No image from the camera</source>
        <translation>没有来自相机的画面</translation>
    </message>
    <message>
        <source>Rejected images</source>
        <translation>不参与计算的图片</translation>
    </message>
    <message>
        <source>Coverage of the images</source>
        <translation>图片的覆盖情况</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>不计入</translation>
    </message>
    <message>
        <source>Waiting for the camera…</source>
        <translation>正在等待相机…</translation>
    </message>
    <message>
        <source>Detecting the board…</source>
        <translation>正在查找标定板…</translation>
    </message>
    <message>
        <source>Hold the board before the camera</source>
        <translation>请将标定板举在相机前</translation>
    </message>
    <message>
        <source>Detecting the board</source>
        <translation>正在查找标定板</translation>
    </message>
    <message>
        <source>Odograph takes an image whenever the board is still, sharp and in a new position.</source>
        <translation>只要标定板静止、清晰且处于新位置，就会自动拍摄一张图片。</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>已拍摄</translation>
    </message>
    <message>
        <source>Now the dashed outline shows where the board would help most.</source>
        <translation>现在，虚线框表示标定板放在何处最有帮助。</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>还需 %1 张</translation>
    </message>
    <message>
        <source>No image accepted</source>
        <translation>没有可用的图片</translation>
    </message>
    <message>
        <source>See the reasons on the right. Drop other images here to add them.</source>
        <translation>原因见右侧。可把其他图片拖放到此处来添加。</translation>
    </message>
    <message>
        <source>All images checked</source>
        <translation>已全部检查</translation>
    </message>
    <message>
        <source>They are enough.</source>
        <translation>已足够。</translation>
    </message>
    <message>
        <source>Drop more images here; the bars show what is missing.</source>
        <translation>可把更多图片拖放到此处；条形图显示还缺什么。</translation>
    </message>
</context>
<context>
    <name>odo::BoardSearchWorker</name>
    <message>
        <source>image %1</source>
        <translation>图片 %1</translation>
    </message>
    <message>
        <source>none of its images shows a board that is still, sharp and in a new position</source>
        <translation>其图片中没有静止、清晰且处于新位置的标定板</translation>
    </message>
    <message>
        <source>it cannot be read any more</source>
        <translation>无法再读取</translation>
    </message>
</context>
<context>
    <name>odo::BoxCanvas</name>
    <message>
        <source>Video frame; arrow keys move the box round the robot, Shift + arrow keys resize it</source>
        <translation>画面；方向键移动机器人周围的框，按住 Shift 则改变框的大小</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationResultPage</name>
    <message>
        <source>ordinary</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>wide (rational)</source>
        <translation>广角（有理）</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>鱼眼</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 ± %2 px</source>
        <translation>%1 ± %2 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>正在求解</translation>
    </message>
    <message>
        <source>Automatic choice of the lens model</source>
        <translation>自动选择镜头模型</translation>
    </message>
    <message>
        <source>Ordinary lens</source>
        <translation>普通镜头</translation>
    </message>
    <message>
        <source>Wide lens (rational model)</source>
        <translation>广角镜头（有理模型）</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>鱼眼</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>镜头模型</translation>
    </message>
    <message>
        <source>Select a bar to see its image.</source>
        <translation>选择一个条形以查看其图片。</translation>
    </message>
    <message>
        <source>Appears here after the calibration.</source>
        <translation>镜头求解后显示在此处。</translation>
    </message>
    <message>
        <source>Image and &amp;residuals</source>
        <translation>图片与残差(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Straightened</source>
        <translation>校正后(&amp;S)</translation>
    </message>
    <message>
        <source>Error by image</source>
        <translation>各图片的误差</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>镜头的已知参数</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>正在求解…</translation>
    </message>
    <message>
        <source>straight edges must be straight</source>
        <translation>直边应当是直的</translation>
    </message>
    <message>
        <source>Storing the lens calibration and its images…</source>
        <translation>正在存储镜头及其图片…</translation>
    </message>
    <message>
        <source>The lens calibration was not stored. %1</source>
        <translation>镜头未能存储。%1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1，共 %2</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>标定板误差</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>留出验证误差</translation>
    </message>
    <message>
        <source>needs six images</source>
        <translation>需要六张图片</translation>
    </message>
    <message>
        <source>Corners left out</source>
        <translation>剔除的角点</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>焦距</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>中心 x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>中心 y</translation>
    </message>
    <message>
        <source>above the threshold</source>
        <translation>高于阈值</translation>
    </message>
    <message>
        <source>Images left out</source>
        <translation>剔除的图片</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationSourcePage</name>
    <message>
        <source>&amp;From the camera: hold up the board, Odograph takes the images</source>
        <translation>相机实拍：手持标定板，自动拍摄图片(&amp;F)</translation>
    </message>
    <message>
        <source>From existing images or a &amp;video</source>
        <translation>使用已拍好的图片或视频(&amp;P)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Prin&amp;t a board…</source>
        <translation>打印标定板(&amp;T)…</translation>
    </message>
    <message>
        <source>Show a flat calibration board from many sides to calibrate the lens. Odograph recognises checkerboard and ChArUco boards of any size. Measure one square on the paper: every later length depends on it. Do not refocus or zoom afterwards.</source>
        <translation>从多个方向拍摄一块带方格的平板，即可得知镜头的成像规律。棋盘格或 ChArUco 均可，大小不限：种类会自动识别。请测量纸上一个方格的边长，此后的一切长度都以它为准。之后不得再对镜头重新对焦或变焦。</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>相机(&amp;C)</translation>
    </message>
    <message>
        <source>Side of a &amp;square, measured</source>
        <translation>实测方格边长(&amp;S)</translation>
    </message>
    <message>
        <source>Source of the board images</source>
        <translation>标定板图片的来源</translation>
    </message>
    <message>
        <source>Images and videos of the board</source>
        <translation>标定板的图片和视频</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>添加(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>You can also drop files here.</source>
        <translation>也可将文件拖放到此处。</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>为相机命名，例如 A。</translation>
    </message>
    <message>
        <source>Connect a camera, or choose existing images.</source>
        <translation>连接相机，或选择现有的图像。</translation>
    </message>
    <message>
        <source>Add images or a video of the board.</source>
        <translation>添加标定板的图像或视频。</translation>
    </message>
</context>
<context>
    <name>odo::CameraChoiceDialog</name>
    <message>
        <source>Cameras to record with</source>
        <translation>用于录制的相机</translation>
    </message>
    <message>
        <source>Device for camera %1</source>
        <translation>用作相机 %1 的设备</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>设置…</translation>
    </message>
    <message>
        <source>Settings of camera %1</source>
        <translation>相机 %1 的设置</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>&amp;Search again</source>
        <translation>重新查找(&amp;L)</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>使用这些</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>不使用</translation>
    </message>
    <message>
        <source>in use by another program</source>
        <translation>正被其他程序使用</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1（未连接）</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>正在查找相机…</translation>
    </message>
    <message>
        <source>Choose at least one camera. Two cameras locate a robot more accurately, and if one cannot see it, the other often can.</source>
        <translation>请至少选择一台相机。用两台时，机器人的位置测得更准，其中一台看不到时也能测量。</translation>
    </message>
    <message>
        <source>You cannot use one device as two cameras.</source>
        <translation>一个设备不能同时用作两台相机。</translation>
    </message>
</context>
<context>
    <name>odo::CameraListModel</name>
    <message>
        <source>not calibrated</source>
        <translation>未标定</translation>
    </message>
    <message>
        <source>calibrated, ±%1 px</source>
        <translation>已标定，±%1 px</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>registered, %1</source>
        <translation>已配准，%1</translation>
    </message>
    <message>
        <source>Calibrate the lens, then register the camera to the floor.</source>
        <translation>请先标定镜头，再将相机配准到地面。</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
</context>
<context>
    <name>odo::CameraPositionDialog</name>
    <message>
        <source>moved %1</source>
        <translation>移动了 %1</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>标记移动了 %1</translation>
    </message>
    <message>
        <source>has not moved</source>
        <translation>未移动</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>检查(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>重新配准(&amp;R)…</translation>
    </message>
    <message>
        <source>Check camera positions</source>
        <translation>检查相机</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>New image</source>
        <translation>新图片</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Registered cameras</source>
        <translation>已配准的相机</translation>
    </message>
    <message>
        <source>A camera that someone has pushed measures wrong positions without any sign of it. Before the robots run, check each camera&apos;s markers in a new image.</source>
        <translation>相机被碰动后会测错，而且看不出来。在机器人运行之前，会在新图片中重新查找每台相机的标记。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Results of the check</source>
        <translation>检查结果</translation>
    </message>
    <message>
        <source>New image of camera %1</source>
        <translation>相机 %1 的新图片</translation>
    </message>
    <message>
        <source>Its newest recording</source>
        <translation>其最新录像</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>不检查</translation>
    </message>
    <message>
        <source>An image or video…</source>
        <translation>图片或视频…</translation>
    </message>
    <message>
        <source>detecting…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>undetermined</source>
        <translation>未能确定</translation>
    </message>
    <message>
        <source>At least two markers must be visible. The check changes nothing.</source>
        <translation>至少要能看到两个标记。检查不会移动或更改任何内容。</translation>
    </message>
    <message>
        <source>&amp;Register %1 again…</source>
        <translation>重新配准 %1(&amp;R)…</translation>
    </message>
</context>
<context>
    <name>odo::CameraSettingsDialog</name>
    <message>
        <source>set by the camera</source>
        <translation>按相机现有设置</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>帧/s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Trigger each frame by software, at the same time for all cameras with this setting</source>
        <translation>逐帧请求画面，使所有此类相机同时拍摄</translation>
    </message>
    <message>
        <source>Settings of %1</source>
        <translation>%1 的设置</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>Software trigger</source>
        <translation>软件触发</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>帧率(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Exposure</source>
        <translation>曝光(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Trigger</source>
        <translation>触发(&amp;T)</translation>
    </message>
    <message>
        <source>If the camera does not support a setting, a message says so when it opens.</source>
        <translation>相机不支持的项目会在打开相机时说明。</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>使用这些</translation>
    </message>
    <message>
        <source>best for tracking</source>
        <translation>最适合跟踪的设置</translation>
    </message>
</context>
<context>
    <name>odo::CameraView</name>
    <message>
        <source>synchronised to %1 ms</source>
        <translation>同步至 %1 ms</translation>
    </message>
    <message>
        <source>manual offset</source>
        <translation>手动偏移</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>未同步</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Camera image</source>
        <translation>相机画面</translation>
    </message>
    <message>
        <source>Image of %1</source>
        <translation>%1 的画面</translation>
    </message>
</context>
<context>
    <name>odo::ChangeModel</name>
    <message>
        <source>made</source>
        <translation>已执行</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message>
        <source>redone</source>
        <translation>已重做</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
</context>
<context>
    <name>odo::ChangesDialog</name>
    <message>
        <source>Project changes</source>
        <translation>项目的更改记录</translation>
    </message>
    <message>
        <source>No changes yet.</source>
        <translation>尚无任何更改。</translation>
    </message>
    <message>
        <source>All changes made in this window and on the command line, newest first. The list includes recordings, imports and tracking, but you cannot undo them.</source>
        <translation>在此窗口中和通过命令行所作的更改，最新的在前。录制、导入和跟踪也会列出，但不能撤销。</translation>
    </message>
    <message>
        <source>Search the changes…</source>
        <translation>搜索更改…</translation>
    </message>
    <message>
        <source>Search the changes</source>
        <translation>搜索更改</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>更改</translation>
    </message>
</context>
<context>
    <name>odo::ChartImage</name>
    <message>
        <source>&amp;Copy as image</source>
        <translation>复制为图片(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save as image…</source>
        <translation>保存为图片(&amp;S)…</translation>
    </message>
    <message>
        <source>SVG images (*.svg)</source>
        <translation>SVG 图片 (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Save as image</source>
        <translation>保存为图片</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
</context>
<context>
    <name>odo::ChartSpan</name>
    <message>
        <source>Charts: show &amp;less</source>
        <translation>图表：缩小范围(&amp;L)</translation>
    </message>
    <message>
        <source>Charts: show &amp;more</source>
        <translation>图表：扩大范围(&amp;M)</translation>
    </message>
    <message>
        <source>Charts: show &amp;all</source>
        <translation>图表：显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>Charts over &amp;distance</source>
        <translation>图表以路程为横轴(&amp;D)</translation>
    </message>
</context>
<context>
    <name>odo::CheckTools</name>
    <message>
        <source>&amp;Check camera positions…</source>
        <translation>检查相机(&amp;C)…</translation>
    </message>
    <message>
        <source>Check camera positions…</source>
        <translation>检查相机…</translation>
    </message>
    <message>
        <source>Check before the robots run that no camera has moved since its registration</source>
        <translation>在机器人运行之前，查看各相机是否仍在配准时的位置</translation>
    </message>
    <message>
        <source>Check a known &amp;length…</source>
        <translation>检查已知长度(&amp;L)…</translation>
    </message>
    <message>
        <source>Check a known length…</source>
        <translation>检查已知长度…</translation>
    </message>
    <message>
        <source>Measure an object of known length in a camera&apos;s image to check the camera&apos;s stated uncertainty</source>
        <translation>在相机画面中测量一段已知长度，看相机是否达到其应有的精度</translation>
    </message>
    <message>
        <source>&amp;Expected accuracy…</source>
        <translation>预期精度(&amp;E)…</translation>
    </message>
    <message>
        <source>Accuracy…</source>
        <translation>精度…</translation>
    </message>
    <message>
        <source>Show the expected uncertainty everywhere on the floor, also with planned cameras</source>
        <translation>查看地面各处的位置能测得多准，也可包括仅在规划中的相机</translation>
    </message>
    <message>
        <source>&amp;Older calibrations…</source>
        <translation>以前的标定(&amp;O)…</translation>
    </message>
    <message>
        <source>Revisions…</source>
        <translation>版本…</translation>
    </message>
    <message>
        <source>Show all calibrations and registrations of a camera, switch to an older one, reanalyse trials</source>
        <translation>查看相机的全部标定和配准，使以前的版本生效，重新测量试验</translation>
    </message>
    <message>
        <source>Cameras checked: see their badges.</source>
        <translation>相机已检查：请看各自的状态标志。</translation>
    </message>
    <message>
        <source>The chosen calibrations and analyses are now current.</source>
        <translation>标定和试验已按所选设定。</translation>
    </message>
</context>
<context>
    <name>odo::ClassActions</name>
    <message>
        <source>&amp;Tasks…</source>
        <translation>任务(&amp;T)…</translation>
    </message>
    <message>
        <source>C&amp;lasses and teams…</source>
        <translation>班级与小组(&amp;L)…</translation>
    </message>
    <message>
        <source>R&amp;obots…</source>
        <translation>机器人(&amp;O)…</translation>
    </message>
    <message>
        <source>Show &amp;standings…</source>
        <translation>显示排名(&amp;S)…</translation>
    </message>
</context>
<context>
    <name>odo::ClassesDialog</name>
    <message>
        <source>&amp;New class…</source>
        <translation>新建班级(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>重命名(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>归档(&amp;A)</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>删除(&amp;T)</translation>
    </message>
    <message>
        <source>New t&amp;eam…</source>
        <translation>新建小组(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Move to</source>
        <translation>移至(&amp;M)</translation>
    </message>
    <message>
        <source>Members and r&amp;obots…</source>
        <translation>成员和机器人(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Import roster…</source>
        <translation>导入名单(&amp;I)…</translation>
    </message>
    <message>
        <source>Classes and teams</source>
        <translation>班级与小组</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>已完成的操作</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Archiving hides a class: History, Record and the standings show its teams and trials only if you choose the class by name</source>
        <translation>归档的班级不再显示：只有在“历史”“录制”和排名中按名称选择它时，才会列出其小组和试验</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>化名</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>成员</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Teams of the class</source>
        <translation>班级中的小组</translation>
    </message>
    <message>
        <source>Double-click or press F2 to change a name or a pseudonym</source>
        <translation>双击或按 F2 可修改名称或化名</translation>
    </message>
    <message numerus="yes">
        <source>%1 (archived, %n team(s))</source>
        <translation>
            <numerusform>%1（已归档，%n 个小组）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n team(s))</source>
        <translation>
            <numerusform>%1（%n 个小组）</numerusform>
        </translation>
    </message>
    <message>
        <source>Teams without a class</source>
        <translation>不属于班级的小组</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>取消归档(&amp;A)</translation>
    </message>
    <message>
        <source>No class</source>
        <translation>无班级</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名称：</translation>
    </message>
    <message>
        <source>New class</source>
        <translation>新建班级</translation>
    </message>
    <message>
        <source>Rename class</source>
        <translation>重命名班级</translation>
    </message>
    <message>
        <source>New team</source>
        <translation>新建小组</translation>
    </message>
</context>
<context>
    <name>odo::CompareColumn</name>
    <message>
        <source>Time difference</source>
        <translation>时间差</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>区段</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Run compared with the first one</source>
        <translation>与运行 1 对照的运行</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Times from gate to gate</source>
        <translation>各计时门之间的时间</translation>
    </message>
    <message>
        <source>Metrics of both runs</source>
        <translation>两次运行的指标</translation>
    </message>
    <message>
        <source>s · drag the gates on the map</source>
        <translation>s · 可在地图上拖动计时门</translation>
    </message>
    <message>
        <source>grey: not significant</source>
        <translation>灰色：在误差范围内</translation>
    </message>
    <message>
        <source>of</source>
        <translation>对象：</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>对象：%1</translation>
    </message>
    <message>
        <source>Behind at finish</source>
        <translation>末端较晚</translation>
    </message>
    <message>
        <source>Ahead at finish</source>
        <translation>末端较早</translation>
    </message>
    <message>
        <source>Gap at finish</source>
        <translation>末端</translation>
    </message>
    <message>
        <source>Behind at cursor</source>
        <translation>此处较晚</translation>
    </message>
    <message>
        <source>Ahead at cursor</source>
        <translation>此处较早</translation>
    </message>
    <message>
        <source>Gap at cursor</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
</context>
<context>
    <name>odo::CompareDesk</name>
    <message>
        <source>Top-down map</source>
        <translation>俯视地图</translation>
    </message>
    <message>
        <source>Floor map with the paths of the runs and the gates of the sectors</source>
        <translation>地面地图，含各次运行的路线和区段的计时门</translation>
    </message>
    <message>
        <source>Drag a gate along the path. Keys: Up and Down select a gate, Left and Right move it</source>
        <translation>可沿路线拖动计时门；按键：上、下选择，左、右移动</translation>
    </message>
    <message>
        <source>both runs</source>
        <translation>两次运行</translation>
    </message>
    <message>
        <source>Camera of the first run</source>
        <translation>运行 1 的相机</translation>
    </message>
    <message>
        <source>Camera of the second run</source>
        <translation>运行 2 的相机</translation>
    </message>
    <message>
        <source>dashed: the task&apos;s path</source>
        <translation>虚线：任务的路径</translation>
    </message>
    <message>
        <source>along the first run&apos;s path</source>
        <translation>沿运行 1 的路线</translation>
    </message>
    <message>
        <source>First</source>
        <translation>运行 1</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>运行 2</translation>
    </message>
</context>
<context>
    <name>odo::ComparePage</name>
    <message>
        <source>These runs cannot be compared</source>
        <translation>这些运行无法比较</translation>
    </message>
    <message>
        <source>%1. What to do: %2.</source>
        <translation>%1。解决办法：%2。</translation>
    </message>
    <message>
        <source>Select two runs</source>
        <translation>需要两次运行</translation>
    </message>
    <message>
        <source>A comparison shows where one run is faster than the other, and whether the difference is significant. Select two tracked trials, or import another one.</source>
        <translation>比较可以看出一次运行在哪里比另一次快，以及差别是否超过误差。请选择两次已跟踪的试验，或再导入一次试验。</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>从视频导入试验…</translation>
    </message>
</context>
<context>
    <name>odo::ConflictDialog</name>
    <message>
        <source>Changed here and elsewhere</source>
        <translation>此处和别处都更改过</translation>
    </message>
    <message>
        <source>You and another bench changed these. Nothing is lost: the hub keeps the version that is not in force. To bring a value back, enter it here again.</source>
        <translation>您和另一个工作台都更改了这些内容。不会丢失任何内容：中心库会保留未生效的版本。要恢复某个值，请在此重新输入。</translation>
    </message>
    <message>
        <source>What was changed twice</source>
        <translation>更改过两次的内容</translation>
    </message>
    <message>
        <source>Values that differ</source>
        <translation>不同的值</translation>
    </message>
    <message>
        <source>&amp;Remove all from this list</source>
        <translation>从列表中全部移除(&amp;R)</translation>
    </message>
    <message>
        <source>The version of this project is in force.</source>
        <translation>本项目的版本生效。</translation>
    </message>
    <message>
        <source>The version of the hub is in force. It comes with the next “Pull”.</source>
        <translation>中心库的版本生效。下次接收时会得到它。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>在本项目中</translation>
    </message>
    <message>
        <source>At the hub</source>
        <translation>在中心库中</translation>
    </message>
</context>
<context>
    <name>odo::ConnectForm</name>
    <message>
        <source>Odograph keeps it until you close the program, and writes it nowhere</source>
        <translation>Odograph 会记住它直到您关闭程序，不会写入任何地方</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>C&amp;onnect</source>
        <translation>连接(&amp;O)</translation>
    </message>
    <message>
        <source>Connect this project to the school&apos;s hub. Odograph sends its trials, tasks and class lists there, and you receive those of the other benches. You can measure without the network; Odograph sends later what it could not send.</source>
        <translation>将本项目连接到学校中心库。Odograph 会把其中的试验、任务和班级名单发送到那里，您也会收到其他工作台的内容。没有网络也可以测量；未能发送的内容 Odograph 会稍后发送。</translation>
    </message>
    <message>
        <source>Address of the hub</source>
        <translation>中心库地址</translation>
    </message>
    <message>
        <source>empty: as in ~/.pgpass or PGPASSWORD</source>
        <translation>留空：使用 ~/.pgpass 或 PGPASSWORD 中的密码</translation>
    </message>
    <message>
        <source>optional: a folder that all benches can reach</source>
        <translation>可选：所有工作台都能访问的文件夹</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>录像文件夹</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>浏览：%1</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>地址(&amp;A)：</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>密码(&amp;P)：</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>录像(&amp;R)：</translation>
    </message>
    <message>
        <source>postgresql://bench1@hub.school.example/school</source>
        <translation>postgresql://bench1@hub.school.example/school</translation>
    </message>
</context>
<context>
    <name>odo::CoveragePanel</name>
    <message>
        <source>Across</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>远近</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>%1 images: enough. More do no harm.</source>
        <translation>%1 张图片：已足够。更多也无妨。</translation>
    </message>
    <message>
        <source>1 image; take ten or more.</source>
        <translation>1 张图片；需要十张或更多。</translation>
    </message>
    <message>
        <source>%1 images; take ten or more.</source>
        <translation>%1 张图片；需要十张或更多。</translation>
    </message>
</context>
<context>
    <name>odo::CrashNotice</name>
    <message>
        <source>Odograph ended unexpectedly</source>
        <translation>Odograph 意外退出</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe. If a recording was cut off, open its project to recover it up to the last second.</source>
        <translation>上一次，Odograph 因自身故障而退出。已保存的内容是安全的。被中断的录像会在其项目再次打开时补全，直到中断前的最后一秒。</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe.</source>
        <translation>上一次，Odograph 因自身故障而退出。已保存的内容是安全的。</translation>
    </message>
    <message>
        <source>Project:</source>
        <translation>项目：</translation>
    </message>
    <message>
        <source>Report:</source>
        <translation>报告：</translation>
    </message>
    <message>
        <source>&amp;Open the project</source>
        <translation>打开该项目(&amp;O)</translation>
    </message>
</context>
<context>
    <name>odo::DifferenceModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>end</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Only one of the two runs has it</source>
        <translation>两者中只有一个有此项</translation>
    </message>
    <message>
        <source>%1: significant (95 %)</source>
        <translation>%1：超出误差（95 %）</translation>
    </message>
    <message>
        <source>%1: not significant (95 %)</source>
        <translation>%1：在误差范围内（95 %），不能断定有差别</translation>
    </message>
    <message>
        <source>significant</source>
        <translation>超出误差</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>在误差范围内</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
</context>
<context>
    <name>odo::DistanceChart</name>
    <message>
        <source>Speed over distance</source>
        <translation>沿程速度</translation>
    </message>
    <message>
        <source>Time difference over distance</source>
        <translation>沿程时间差</translation>
    </message>
    <message>
        <source>%1 · smoothed ±95 %</source>
        <translation>%1 · 平滑后 ±95 %</translation>
    </message>
    <message>
        <source>s · above 0: %2 is later than %1 · ±95 % · grey: not significant</source>
        <translation>s · 大于 0：%2 比 %1 晚 · ±95 % · 灰色：在误差范围内</translation>
    </message>
    <message>
        <source>s · above 0: later than %1 · ±95 % · grey: not significant</source>
        <translation>s · 大于 0：比 %1 晚 · ±95 % · 灰色：在误差范围内</translation>
    </message>
</context>
<context>
    <name>odo::DockGrip</name>
    <message>
        <source>Drag to move, double-click to float</source>
        <translation>拖动可移动，双击可浮动</translation>
    </message>
</context>
<context>
    <name>odo::DoctorDialog</name>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>不良</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Set-up doctor</source>
        <translation>装置诊断</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>诊断结果</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>重新检查(&amp;L)</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>. What to do: %1.</source>
        <translation>。处理办法：%1。</translation>
    </message>
    <message>
        <source>Found nothing that would disturb a recording.</source>
        <translation>未发现会干扰录制的问题。</translation>
    </message>
    <message>
        <source>Found one problem.</source>
        <translation>有一项需要注意。</translation>
    </message>
    <message>
        <source>Found %1 problems, the worst first.</source>
        <translation>有 %1 项需要注意，最严重的在前。</translation>
    </message>
</context>
<context>
    <name>odo::EditTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>试验中的机器人</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message numerus="yes">
        <source>Edit %n trial(s)</source>
        <translation>
            <numerusform>编辑 %n 次试验</numerusform>
        </translation>
    </message>
    <message>
        <source>Why it was not changed</source>
        <translation>未能更改的原因</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>更改(&amp;C)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>T&amp;eam</source>
        <translation>小组(&amp;E)</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>班级(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Date and time</source>
        <translation>日期和时间(&amp;D)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>任务(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>机器人(&amp;O)</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>以逗号分隔</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>标签(&amp;G)</translation>
    </message>
    <message>
        <source>Note&amp;s</source>
        <translation>备注(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Variables</source>
        <translation>变量(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Remove variable</source>
        <translation>移除变量(&amp;R)</translation>
    </message>
    <message>
        <source>The variable %1 is in the table twice. Remove one of the rows.</source>
        <translation>变量 %1 在表中出现了两次。请移除其中一行。</translation>
    </message>
</context>
<context>
    <name>odo::ExportDialog</name>
    <message>
        <source>&amp;Keep as…</source>
        <translation>另存为预设(&amp;K)…</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>移除(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>预设(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
    </message>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>供程序使用的 CSV (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>供电子表格使用的 CSV，1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>供电子表格使用的 CSV，1,5 (*.csv)</translation>
    </message>
    <message>
        <source>Tracker text (*.txt)</source>
        <translation>Tracker 文本 (*.txt)</translation>
    </message>
    <message>
        <source>TUM trajectory (*.tum)</source>
        <translation>TUM 轨迹 (*.tum)</translation>
    </message>
    <message>
        <source>Page to take along (*.html)</source>
        <translation>随身页面 (*.html)</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>&amp;Columns</source>
        <translation>列(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Lengths in</source>
        <translation>长度单位(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>坐标轴(&amp;A)</translation>
    </message>
    <message>
        <source>Of the floor&apos;s markers</source>
        <translation>地面标记的坐标轴</translation>
    </message>
    <message>
        <source>From the start, X in its direction</source>
        <translation>以起点为原点，X 沿起步方向</translation>
    </message>
    <message>
        <source>Par&amp;t of the run</source>
        <translation>运行的部分(&amp;T)</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>选择文件夹…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Its range, which counts</source>
        <translation>其有效区间</translation>
    </message>
    <message>
        <source>The whole run</source>
        <translation>整个运行</translation>
    </message>
    <message>
        <source>What counts of each</source>
        <translation>各次运行的有效部分</translation>
    </message>
    <message>
        <source>The selection, %1 to %2</source>
        <translation>所选部分，%1 至 %2</translation>
    </message>
    <message>
        <source>As last time</source>
        <translation>与上次相同</translation>
    </message>
    <message>
        <source>Keep these choices</source>
        <translation>保存这些选择</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>预设名称：</translation>
    </message>
</context>
<context>
    <name>odo::FileActions</name>
    <message>
        <source>&amp;New project…</source>
        <translation>新建项目(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>打开项目(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;demo lesson…</source>
        <translation>打开演示课(&amp;D)…</translation>
    </message>
    <message>
        <source>Save a &amp;copy as…</source>
        <translation>另存副本(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>清空此列表(&amp;C)</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>新建项目</translation>
    </message>
    <message>
        <source>Project.odo</source>
        <translation>项目.odo</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo)</source>
        <translation>Odograph 项目 (*.odo)</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo);;All files (*)</source>
        <translation>Odograph 项目 (*.odo);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the demo lesson</source>
        <translation>演示课放在哪里？</translation>
    </message>
    <message>
        <source>Odograph demo</source>
        <translation>Odograph 演示</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>%1 的副本</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>保存副本</translation>
    </message>
    <message>
        <source>Copy saved as %1. Its videos stay where they are.</source>
        <translation>副本已保存为 %1。其视频仍在原处。</translation>
    </message>
    <message>
        <source>New project from t&amp;his one…</source>
        <translation>以此项目新建项目(&amp;H)…</translation>
    </message>
    <message>
        <source>With its cameras, marker layouts, robots and tasks, without people and trials</source>
        <translation>保留相机、标记布局、机器人和任务，不含人员和试验</translation>
    </message>
    <message>
        <source>Open demo lesson</source>
        <translation>打开演示课</translation>
    </message>
    <message>
        <source>A demo lesson is in %1.</source>
        <translation>%1 中已有一份演示课。</translation>
    </message>
    <message>
        <source>&amp;Open it</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Create another…</source>
        <translation>另建一份(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Backups…</source>
        <translation>备份(&amp;B)…</translation>
    </message>
</context>
<context>
    <name>odo::FilmStrip</name>
    <message>
        <source>&amp;Remove</source>
        <translation>取出(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Accepted images</source>
        <translation>参与计算的图片</translation>
    </message>
</context>
<context>
    <name>odo::FloorCopy</name>
    <message>
        <source>&amp;Copy floor position</source>
        <translation>复制地面位置(&amp;C)</translation>
    </message>
</context>
<context>
    <name>odo::FloorMap</name>
    <message>
        <source>Top-down map</source>
        <translation>俯视地图</translation>
    </message>
    <message>
        <source>Map: &amp;views&apos; disagreement</source>
        <translation>地图：视角差异(&amp;V)</translation>
    </message>
    <message>
        <source>Floor map with the robots&apos; trails</source>
        <translation>地面地图，含机器人的轨迹</translation>
    </message>
    <message>
        <source>Colour of the trails on the map</source>
        <translation>地图上轨迹的着色依据</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Disagreement of the views: %1</source>
        <translation>视角差异：%1</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>颜色</translation>
    </message>
</context>
<context>
    <name>odo::FloorReadOut</name>
    <message>
        <source>x %1 · y %2</source>
        <translation>x %1 · y %2</translation>
    </message>
    <message>
        <source>Not on the floor</source>
        <translation>不在地面上</translation>
    </message>
    <message>
        <source>u %1 · v %2 px</source>
        <translation>u %1 · v %2 px</translation>
    </message>
</context>
<context>
    <name>odo::FloorSketch</name>
    <message>
        <source>Sketch of the testbed from above</source>
        <translation>试验场俯视草图</translation>
    </message>
    <message>
        <source>%1 markers, %2 cameras</source>
        <translation>%1 个标记，%2 台相机</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1，高 %2 m</translation>
    </message>
    <message>
        <source>This sketch shows markers and cameras once the testbed has a layout or a registered camera.</source>
        <translation>有了标记布局或已配准的相机后，标记和相机会画在这里。</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>网格 %1 m</translation>
    </message>
</context>
<context>
    <name>odo::FloorSourcePage</name>
    <message>
        <source>Image or video of the markers</source>
        <translation>标记的图片或视频</translation>
    </message>
    <message>
        <source>Markers with known floor positions determine the camera position. Four are enough; a fifth checks them. Do not move the camera afterwards.</source>
        <translation>由地面上位置已知的标记可以得出相机的位置。四个就够，第五个用于检验。此后不得移动相机。</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>相机(&amp;A)</translation>
    </message>
    <message>
        <source>Marker &amp;layout</source>
        <translation>标记布局(&amp;L)</translation>
    </message>
    <message>
        <source>Image of the markers</source>
        <translation>标记见于何处</translation>
    </message>
    <message>
        <source>Its lens is calibrated.</source>
        <translation>镜头已测量。</translation>
    </message>
    <message>
        <source>Its lens is not calibrated. Odograph estimates it from the markers, as far as they determine it.</source>
        <translation>其镜头未标定。Odograph 会在标记能够确定的范围内由标记估计镜头。</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>为相机命名，例如 A。</translation>
    </message>
    <message>
        <source>Add a marker layout first.</source>
        <translation>请先添加标记布局。</translation>
    </message>
    <message>
        <source>Choose an image or a video of the markers.</source>
        <translation>选择标记的图像或视频。</translation>
    </message>
</context>
<context>
    <name>odo::FloorWizard</name>
    <message>
        <source>Register camera to the floor</source>
        <translation>将相机配准到地面</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>The camera and its markers</source>
        <translation>相机及其标记</translation>
    </message>
    <message>
        <source>The markers in the image</source>
        <translation>画面中的标记</translation>
    </message>
    <message>
        <source>Detecting the markers…</source>
        <translation>正在查找标记…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>还没有可保存的配准。</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>配准</translation>
    </message>
</context>
<context>
    <name>odo::FrameAligner</name>
    <message>
        <source>&amp;Move both frames together</source>
        <translation>同时移动两个帧(&amp;M)</translation>
    </message>
    <message>
        <source>Together they show what is now taken for the same moment. Remove the tick, and move one frame until both show the same moment, such as a wheel that begins to turn.</source>
        <translation>一起移动时，显示目前被视为同一时刻的画面。取消勾选后移动其中一帧，直到两者显示同一时刻，例如车轮开始转动时。</translation>
    </message>
</context>
<context>
    <name>odo::FramePanel</name>
    <message>
        <source>Frame of camera %1</source>
        <translation>相机 %1 的帧</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>%1: frame %2, %3</source>
        <translation>%1：第 %2 帧，%3</translation>
    </message>
</context>
<context>
    <name>odo::GateTable</name>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>start and finish</source>
        <translation>起点兼终点</translation>
    </message>
    <message>
        <source>split</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>移除(&amp;V)</translation>
    </message>
    <message>
        <source>Reverse directi&amp;on</source>
        <translation>反向(&amp;O)</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>计时门</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>x₁, mm</source>
        <translation>x₁，mm</translation>
    </message>
    <message>
        <source>y₁, mm</source>
        <translation>y₁，mm</translation>
    </message>
    <message>
        <source>x₂, mm</source>
        <translation>x₂，mm</translation>
    </message>
    <message>
        <source>y₂, mm</source>
        <translation>y₂，mm</translation>
    </message>
    <message>
        <source>Gates in passing order</source>
        <translation>计时门，按通过的顺序</translation>
    </message>
    <message>
        <source>&amp;Add gate</source>
        <translation>添加计时门(&amp;A)</translation>
    </message>
    <message>
        <source>Robots pass the selected gate the other way</source>
        <translation>将所选计时门改为反向通过</translation>
    </message>
    <message>
        <source>Role of the gate</source>
        <translation>计时门的作用</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>分段 %1</translation>
    </message>
</context>
<context>
    <name>odo::GeneralPage</name>
    <message>
        <source>Restart Odograph to see the change.</source>
        <translation>重新启动 Odograph 后生效。</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Units of results</source>
        <translation>结果的单位(&amp;U)</translation>
    </message>
    <message>
        <source>Floors and targets always use millimetres, as printed. Exported files use the units of their format.</source>
        <translation>地面和靶标按印制尺寸以毫米设置。导出的文件采用其格式所要求的单位。</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Colours of maps</source>
        <translation>地图配色(&amp;C)</translation>
    </message>
    <message>
        <source>Both remain readable for people with red-green colour blindness and in black-and-white prints.</source>
        <translation>两种配色对红绿色盲者和在黑白打印件上都能区分。</translation>
    </message>
    <message>
        <source>Units of results</source>
        <translation>结果的单位</translation>
    </message>
    <message>
        <source>Millimetres and metres: mm, m, m/s</source>
        <translation>毫米和米：mm、m、m/s</translation>
    </message>
    <message>
        <source>Centimetres: cm, cm/s</source>
        <translation>厘米：cm、cm/s</translation>
    </message>
    <message>
        <source>Inches and feet: in, ft, ft/s</source>
        <translation>英寸和英尺：in、ft、ft/s</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>As set on the computer</source>
        <translation>与计算机相同</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>As set on the desktop</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Colours of maps</source>
        <translation>地图配色</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>&amp;Back up a project on each day you open it</source>
        <translation>每天首次打开项目时备份(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Days to keep backups</source>
        <translation>备份保留天数(&amp;D)</translation>
    </message>
    <message>
        <source>Backups are beside the project and contain everything except the videos: File ▸ Backups… shows and restores them.</source>
        <translation>备份位于项目旁边，包含除视频之外的全部内容：可在“文件 ▸ 备份…”中查看和恢复。</translation>
    </message>
</context>
<context>
    <name>odo::GuidanceTool</name>
    <message>
        <source>&amp;Ignore an area</source>
        <translation>忽略区域(&amp;I)</translation>
    </message>
    <message>
        <source>Draw an area of a view to ignore, such as a mirror or a screen: click its corners, then press Enter</source>
        <translation>绘制视图中要忽略的区域，例如镜子或屏幕：单击各个角点，然后按回车</translation>
    </message>
    <message>
        <source>Search only an &amp;area</source>
        <translation>仅搜索一个区域(&amp;A)</translation>
    </message>
    <message>
        <source>Draw the area of a view in which robots are searched: click its corners, then press Enter</source>
        <translation>绘制视图中搜索机器人的区域：单击各个角点，然后按回车</translation>
    </message>
    <message>
        <source>&amp;Remove all areas</source>
        <translation>移除所有区域(&amp;R)</translation>
    </message>
    <message>
        <source>Remove all areas of this trial</source>
        <translation>移除此试验的所有区域</translation>
    </message>
    <message>
        <source>Remove this ignored area</source>
        <translation>移除此忽略区域</translation>
    </message>
    <message>
        <source>Remove this search area</source>
        <translation>移除此搜索区域</translation>
    </message>
    <message>
        <source>Set %1 here by hand…</source>
        <translation>在此处手动设置 %1…</translation>
    </message>
    <message>
        <source>%1 is not visible here in the selected time</source>
        <translation>%1 在所选时间内于此视图不可见</translation>
    </message>
    <message>
        <source>%1 is not visible in any view in the selected time</source>
        <translation>%1 在所选时间内于所有视图均不可见</translation>
    </message>
    <message>
        <source>Remove the point set by hand</source>
        <translation>移除手动设置的点</translation>
    </message>
    <message>
        <source>It is visible after all</source>
        <translation>其实可见</translation>
    </message>
    <message>
        <source>Set a point by hand</source>
        <translation>手动设置点</translation>
    </message>
    <message>
        <source>Uncertainty σ of this point, pixels:</source>
        <translation>此点的不确定度 σ，像素：</translation>
    </message>
</context>
<context>
    <name>odo::HelpActions</name>
    <message>
        <source>&amp;Help on this page</source>
        <translation>本页帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First lesson</source>
        <translation>入门课(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>按键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Odograph</source>
        <translation>关于 Odograph(&amp;A)</translation>
    </message>
</context>
<context>
    <name>odo::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>关闭帮助 (F1)</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>关闭帮助</translation>
    </message>
    <message>
        <source>Help on this page</source>
        <translation>本页帮助</translation>
    </message>
</context>
<context>
    <name>odo::HistoryActions</name>
    <message>
        <source>Import &amp;roster…</source>
        <translation>导入名单(&amp;R)…</translation>
    </message>
    <message>
        <source>Show project &amp;changes…</source>
        <translation>项目的更改记录(&amp;C)…</translation>
    </message>
    <message>
        <source>Import a roster: a table with the columns class, team and optionally pseudonym</source>
        <translation>导入名单：含“class”（班级）和“team”（小组）两列的表格，可另有“pseudonym”（化名）列</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV 表格 (*.csv)</translation>
    </message>
    <message>
        <source>Roster imported. New teams: %1, changed: %2, unchanged: %3.</source>
        <translation>名单已导入。新增小组：%1，有更改：%2，不变：%3。</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation>
            <numerusform>导出 %n 次试验：选择文件夹</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Videos of %n trial(s)</source>
        <translation>
            <numerusform>%n 次试验的视频</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>已永久移除 %n 次试验。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Removed %1 of %n trial(s) for good; the rest is still in the bin.</source>
        <translation>
            <numerusform>已永久移除 %n 次试验中的 %1 次；其余的仍在。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be deleted; delete it by hand.</source>
        <translation>无法删除 %1，请手动删除。</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s)</source>
        <translation>
            <numerusform>导出 %n 个试验</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message>
        <source>&amp;Compare</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>Teams by &amp;pseudonym</source>
        <translation>小组显示化名(&amp;P)</translation>
    </message>
    <message>
        <source>Tr&amp;ials</source>
        <translation>试验(&amp;I)</translation>
    </message>
    <message>
        <source>Tea&amp;ms</source>
        <translation>小组(&amp;M)</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Rea&amp;nalyse</source>
        <translation>重新测量(&amp;M)</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>报告(&amp;R)…</translation>
    </message>
    <message>
        <source>Export &amp;videos…</source>
        <translation>导出视频(&amp;V)…</translation>
    </message>
    <message>
        <source>Search trials, teams, tasks, tags, notes…</source>
        <translation>搜索试验、小组、任务、标签、备注…</translation>
    </message>
    <message>
        <source>Search the trials</source>
        <translation>搜索试验</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>搜索(&amp;H)</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1（已归档）</translation>
    </message>
    <message>
        <source>Compare the selected trials</source>
        <translation>比较所选试验</translation>
    </message>
    <message>
        <source>Select two or more trials (Ctrl+click or Shift+click)</source>
        <translation>请选择两次或更多试验（按住 Ctrl 或 Shift 点击）</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n 次试验</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation>
            <numerusform>%n 次试验中的 %1 次</numerusform>
        </translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>学校中心库</translation>
    </message>
    <message>
        <source>Res&amp;ults</source>
        <translation>结果(&amp;U)</translation>
    </message>
    <message>
        <source>Trials, results or teams</source>
        <translation>试验、结果或小组</translation>
    </message>
</context>
<context>
    <name>odo::HubActions</name>
    <message>
        <source>School &amp;hub…</source>
        <translation>学校中心库(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>odo::HubDialog</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>学校中心库</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>已完成的操作</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel the exchange with the hub</source>
        <translation>取消与中心库的交换</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开连接</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not sent yet. They stay in the project.</source>
        <translation>
            <numerusform>尚有 %n 处更改未发送，它们仍保留在项目中。</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开连接(&amp;D)</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>Asking the hub…</source>
        <translation>正在询问中心库…</translation>
    </message>
    <message>
        <source>The project is read-only here, so nothing can be sent or received.</source>
        <translation>项目在此处为只读，因此无法发送或接收任何内容。</translation>
    </message>
</context>
<context>
    <name>odo::HubExchange</name>
    <message>
        <source>Disconnected. All trials stay in the project.</source>
        <translation>已断开连接。所有试验仍保留在项目中。</translation>
    </message>
</context>
<context>
    <name>odo::HubPanel</name>
    <message>
        <source>Password of the hub</source>
        <translation>中心库密码</translation>
    </message>
    <message>
        <source>Copy &amp;recordings, too</source>
        <translation>同时复制录像(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Publish now</source>
        <translation>立即发布(&amp;P)</translation>
    </message>
    <message>
        <source>Pu&amp;ll now</source>
        <translation>立即接收(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开连接(&amp;D)</translation>
    </message>
    <message>
        <source>Send to the hub what is pending. Odograph also does this by itself.</source>
        <translation>将待发送的内容发送到中心库。Odograph 也会自动发送。</translation>
    </message>
    <message>
        <source>Receive class lists, tasks and the trials of other benches</source>
        <translation>接收班级名单、任务和其他工作台的试验</translation>
    </message>
    <message>
        <source>To and from the school&apos;s folder for recordings; this can take long</source>
        <translation>与学校的录像文件夹互相复制；可能需要较长时间</translation>
    </message>
    <message>
        <source>Log &amp;in</source>
        <translation>登录(&amp;I)</translation>
    </message>
    <message>
        <source>Pass&amp;word:</source>
        <translation>密码(&amp;W)：</translation>
    </message>
    <message>
        <source>How the project is connected</source>
        <translation>项目的连接情况</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>Hub</source>
        <translation>中心库</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>架构</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>版本 %1</translation>
    </message>
    <message>
        <source>Last exchange</source>
        <translation>上次交换</translation>
    </message>
    <message>
        <source>Still to be sent</source>
        <translation>待发送</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>录像</translation>
    </message>
    <message>
        <source>No folder: they stay at this bench</source>
        <translation>无文件夹：保留在此工作台</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Changed twice: %n…</source>
        <translation>
            <numerusform>更改过两次(&amp;C)：%n…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HubRunsModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>计入</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>不计入</translation>
    </message>
    <message>
        <source>another course</source>
        <translation>其他路线</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>排名</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>工作台</translation>
    </message>
</context>
<context>
    <name>odo::HubRunsPanel</name>
    <message>
        <source>Trials of all benches</source>
        <translation>所有工作台的试验</translation>
    </message>
    <message>
        <source>Search trials and teams…</source>
        <translation>搜索试验和小组…</translation>
    </message>
    <message>
        <source>Search the hub</source>
        <translation>搜索中心库</translation>
    </message>
    <message>
        <source>Three letters or more</source>
        <translation>至少三个字母</translation>
    </message>
    <message>
        <source>Runs at the hub</source>
        <translation>中心库中的行驶</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>正在搜索…</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n 次行驶</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the newest %n run(s)</source>
        <translation>
            <numerusform>最近 %n 次行驶</numerusform>
        </translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>工作台</translation>
    </message>
    <message>
        <source>All benches</source>
        <translation>所有工作台</translation>
    </message>
</context>
<context>
    <name>odo::ImageArea</name>
    <message>
        <source>No view</source>
        <translation>无视角</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>此时该相机没有在录制</translation>
    </message>
</context>
<context>
    <name>odo::ImageBars</name>
    <message>
        <source>Error of each image, with a threshold</source>
        <translation>各图片的误差，含阈值</translation>
    </message>
    <message>
        <source>%1: %2 px</source>
        <translation>%1：%2 px</translation>
    </message>
    <message>
        <source>images; rejected above %1 px</source>
        <translation>图片；超过 %1 px 的不计入</translation>
    </message>
</context>
<context>
    <name>odo::ImageChoice</name>
    <message>
        <source>The camera&apos;s ne&amp;west recording</source>
        <translation>相机的最新录像(&amp;W)</translation>
    </message>
    <message>
        <source>The current image of a &amp;connected camera</source>
        <translation>已连接相机的当前画面(&amp;C)</translation>
    </message>
    <message>
        <source>An image or a &amp;video</source>
        <translation>图片或视频(&amp;P)</translation>
    </message>
</context>
<context>
    <name>odo::ImportLessonDialog</name>
    <message>
        <source>Robots in the trials</source>
        <translation>试验中的机器人</translation>
    </message>
    <message>
        <source>Import a lesson</source>
        <translation>导入一节课</translation>
    </message>
    <message>
        <source>Clips that were recorded at the same time belong to one trial. Untick what is no run; names and teams can be changed.</source>
        <translation>同时录制的视频属于同一次试验。取消勾选不是运行的内容；名称和小组可以更改。</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>任务(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>机器人(&amp;O)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>视角 %1 的相机</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Team of row %1</source>
        <translation>第 %1 行的小组</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>no clip</source>
        <translation>无视频</translation>
    </message>
    <message>
        <source>Each trial needs a name of its own.</source>
        <translation>每次试验都需要自己的名称。</translation>
    </message>
    <message>
        <source>Tick the trials to import.</source>
        <translation>请勾选要导入的试验。</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>录制时间</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Clip of %1</source>
        <translation>%1 的视频</translation>
    </message>
    <message>
        <source>Each column of clips needs a camera.</source>
        <translation>每一列视频都需要一台相机。</translation>
    </message>
    <message>
        <source>Two clips of %1 are of the same camera.</source>
        <translation>%1 的两段视频属于同一台相机。</translation>
    </message>
</context>
<context>
    <name>odo::ImportTracksDialog</name>
    <message>
        <source>Add &amp;robot</source>
        <translation>添加机器人(&amp;R)</translation>
    </message>
    <message>
        <source>Import finished tracks</source>
        <translation>导入现成轨迹</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>任务(&amp;K)</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Robot of track %1</source>
        <translation>轨迹 %1 的机器人</translation>
    </message>
    <message>
        <source>A new name creates a new robot</source>
        <translation>输入新名称会新建机器人</translation>
    </message>
    <message>
        <source>File of track %1</source>
        <translation>轨迹 %1 的文件</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>小组(&amp;A)</translation>
    </message>
    <message>
        <source>Positions measured by another program or exported by Odograph: TUM, CSV, Tracker text and others. Odograph analyses them as a run without video.</source>
        <translation>由其他程序测量或由 Odograph 导出的位置：TUM、CSV、Tracker 文本等。Odograph 将其作为无视频的运行进行分析。</translation>
    </message>
    <message>
        <source>Tracks (*.csv *.txt *.tum *.tsv *.trc);;All files (*)</source>
        <translation>轨迹 (*.csv *.txt *.tum *.tsv *.trc);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>odo::ImportTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>试验中的机器人</translation>
    </message>
    <message>
        <source>Add &amp;view</source>
        <translation>添加视角(&amp;V)</translation>
    </message>
    <message>
        <source>Camera&apos;s real &amp;rate</source>
        <translation>相机实际帧率(&amp;R)</translation>
    </message>
    <message>
        <source>Import trial from videos</source>
        <translation>从视频导入试验</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>小组(&amp;A)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>任务(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>机器人(&amp;O)</translation>
    </message>
    <message>
        <source>Videos</source>
        <translation>视频</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>同步(&amp;S)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>视频文件</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> 帧/s</translation>
    </message>
    <message>
        <source>Camera&apos;s real rate</source>
        <translation>相机实际帧率</translation>
    </message>
    <message>
        <source>For slow motion: the file plays slower than the camera recorded it</source>
        <translation>用于慢动作：文件的播放比相机拍摄时慢</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>视角 %1 的相机</translation>
    </message>
    <message>
        <source>Video of view %1</source>
        <translation>视角 %1 的视频</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)</source>
        <translation>视频 (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Registration of the camera of view %1</source>
        <translation>视角 %1 的相机的配准</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>未输入</translation>
    </message>
    <message>
        <source>%1 has no time stamps and states no frame rate. Enter the rate of its camera.</source>
        <translation>%1 没有时间戳，也未给出帧率。请输入其相机的帧率。</translation>
    </message>
    <message>
        <source>Chapters of one recording are joined by +; images are given as their folder, or FOLDER/%06d.png, with the rate</source>
        <translation>同一录像的各段用 + 连接；图片以其文件夹或 FOLDER/%06d.png 给出，并给出帧率</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>试验 %1</translation>
    </message>
</context>
<context>
    <name>odo::IntervalHistogram</name>
    <message>
        <source>Histogram of the frame intervals</source>
        <translation>帧间隔直方图</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2: %n interval(s)</source>
        <translation>
            <numerusform>%1 至 %2：%n 个间隔</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>longer than %1: %n interval(s)</source>
        <translation>
            <numerusform>长于 %1：%n 个间隔</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalPanel</name>
    <message>
        <source>%1: fewer than two frames</source>
        <translation>%1：不足两帧</translation>
    </message>
    <message>
        <source>%1: frames are %2 apart (%3 frames/s), from %4 to %5</source>
        <translation>%1：帧间隔 %2（%3 帧/s），从 %4 到 %5</translation>
    </message>
    <message>
        <source>jitter %1</source>
        <translation>抖动 %1</translation>
    </message>
    <message>
        <source>no frame missing</source>
        <translation>无缺帧</translation>
    </message>
    <message>
        <source>%1 of %2 frames repeat the one before</source>
        <translation>%2 帧中有 %1 帧重复前一帧</translation>
    </message>
    <message>
        <source>no frame repeated</source>
        <translation>无重复帧</translation>
    </message>
    <message>
        <source>Frame intervals</source>
        <translation>帧间隔</translation>
    </message>
    <message>
        <source>bars by the logarithm of their number</source>
        <translation>条形高度按数量的对数</translation>
    </message>
    <message>
        <source>Frame intervals of the views</source>
        <translation>各视图的帧间隔</translation>
    </message>
    <message>
        <source>This trial has no videos.</source>
        <translation>此试验没有视频。</translation>
    </message>
    <message numerus="yes">
        <source>%1 missing in %n gap(s)</source>
        <translation>
            <numerusform>%n 处缺 %1 帧</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::JobIndicator</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel the running job</source>
        <translation>取消正在进行的操作</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
</context>
<context>
    <name>odo::JointDialog</name>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Uncertainty before</source>
        <translation>原精度</translation>
    </message>
    <message>
        <source>Uncertainty, joint</source>
        <translation>联合精度</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>移动量</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Off by, mm</source>
        <translation>偏差，mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Register all cameras (joint)</source>
        <translation>联合配准所有相机</translation>
    </message>
    <message>
        <source>This fits all cameras of layout %1 jointly to the markers they were registered with. Cameras that see the same markers then agree better, and wrongly measured markers show up.</source>
        <translation>布局 %1 的各相机将根据其配准时所用的标记一并重新拟合：看到相同标记的相机此后更加一致，量错的标记也会被发现。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Uncertainty of the tape measure</source>
        <translation>卷尺误差</translation>
    </message>
    <message>
        <source>Marker positions &amp;measured to</source>
        <translation>标记位置的测量误差(&amp;M)</translation>
    </message>
    <message>
        <source>Fitting the cameras jointly…</source>
        <translation>正在联合拟合各相机…</translation>
    </message>
    <message>
        <source>The joint uncertainty assumes marker positions measured to %1 mm; registering a single camera assumes them exact. Nothing changes until you save; trials keep the registration they were analysed with.</source>
        <translation>联合精度计入了标记位置 %1 mm 的测量误差，而相机单独配准时视标记位置为精确。保存之前不会有任何更改；试验保留其分析时所用的配准。</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>check its position</source>
        <translation>请重新测量</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>相符</translation>
    </message>
</context>
<context>
    <name>odo::KeysPage</name>
    <message>
        <source>&amp;Use this key</source>
        <translation>使用此键(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>不设按键(&amp;N)</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>全部恢复默认(&amp;A)</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>搜索命令或按键</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>命令及其按键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>New key for the selected command</source>
        <translation>所选命令的新按键</translation>
    </message>
    <message>
        <source>Select a command to change its key.</source>
        <translation>选择一个命令，为其设置其他按键。</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. That command would lose it.</source>
        <translation>%1 是“%2”的按键，改用后该命令将没有按键。</translation>
    </message>
    <message>
        <source>Press the new key in the field.</source>
        <translation>请在输入框中按下新按键。</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDialog</name>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>表格 (*.csv *.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Marker layout</source>
        <translation>标记布局</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题所在</translation>
    </message>
    <message>
        <source>Enter the floor positions of the markers, measured with a tape in millimetres from the origin. Seen from above, X points right and Y away from you.</source>
        <translation>标记在地面上的位置，用卷尺测量：以毫米为单位，从原点算起。俯视时 X 向右，Y 朝远离您的方向。</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标号</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x，mm</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y，mm</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>坐标轴(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>CSV(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Origin at the chosen marker</source>
        <translation>以所选标记为原点(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Quarter turn</source>
        <translation>旋转 90°(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Half turn</source>
        <translation>旋转 180°(&amp;H)</translation>
    </message>
    <message>
        <source>Convert from &amp;centimetres</source>
        <translation>原为厘米(&amp;C)</translation>
    </message>
    <message>
        <source>Convert from &amp;metres</source>
        <translation>原为米(&amp;M)</translation>
    </message>
    <message>
        <source>Convert from &amp;inches</source>
        <translation>原为英寸(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>标记的位置 (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Positions of the markers</source>
        <translation>标记的位置</translation>
    </message>
    <message>
        <source>The layout has no name.</source>
        <translation>布局没有名称。</translation>
    </message>
    <message>
        <source>A layout with this name exists, and cameras may use it. Enter another name.</source>
        <translation>已有同名的布局：可能有相机以它为依据，因此不会覆盖。请另取名称。</translation>
    </message>
    <message>
        <source>A marker has no label.</source>
        <translation>有一个标记没有标号。</translation>
    </message>
    <message>
        <source>Two markers are called %1.</source>
        <translation>有两个标记的标号都是 %1。</translation>
    </message>
    <message>
        <source>The position of %1 is not a number.</source>
        <translation>%1 的位置不是数字。</translation>
    </message>
    <message>
        <source>The layout needs four markers; it has %1.</source>
        <translation>需要四个标记，现有 %1 个。</translation>
    </message>
    <message>
        <source>%1 and %2 have the same position.</source>
        <translation>%1 和 %2 位于同一处。</translation>
    </message>
    <message>
        <source>The markers are nearly on a line and cannot determine the camera position. Move one to the side.</source>
        <translation>各标记几乎在一条直线上：无法由此确定相机的位置。请把其中一个移到旁边。</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDrawing</name>
    <message>
        <source>Markers from above</source>
        <translation>标记俯视图</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>网格 %1 m</translation>
    </message>
</context>
<context>
    <name>odo::LengthPage</name>
    <message>
        <source>S&amp;nap to what is near a click</source>
        <translation>吸附到点击处附近(&amp;N)</translation>
    </message>
    <message>
        <source>Image with both ends; arrow keys move the selected one, Space snaps it</source>
        <translation>含两个端点的画面；方向键移动所选端点，空格键使其吸附</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Measured length</source>
        <translation>测得长度</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>真实长度</translation>
    </message>
    <message>
        <source>Unit of the true length</source>
        <translation>真实长度的单位</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>on the floor</source>
        <translation>位于地面</translation>
    </message>
    <message>
        <source>&amp;True length</source>
        <translation>真实长度(&amp;T)</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>高度(&amp;E)</translation>
    </message>
    <message>
        <source>End</source>
        <translation>端点</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>识别为</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>地面位置，mm</translation>
    </message>
    <message>
        <source>Ends of the length</source>
        <translation>长度的端点</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>两个端点</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>被测物</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量结果</translation>
    </message>
    <message>
        <source>Put an object of known length anywhere on the floor, such as a metre stick or two markers at a known distance, and click both ends. Keys: arrows move an end (Ctrl: fast, Shift: one pixel), Space snaps it.</source>
        <translation>在地面上任意处放一件已知长度的物体，如米尺，或两个距离已知的标记，然后点击其两端。用按键：方向键移动端点（Ctrl：快速，Shift：一个像素），空格键使其吸附。</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>within uncertainty</source>
        <translation>在预期误差之内</translation>
    </message>
    <message>
        <source>outside uncertainty</source>
        <translation>超出预期误差</translation>
    </message>
    <message>
        <source> Enter its true length to check the result.</source>
        <translation> 请输入真实长度，以检验是否正确。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>在地平线以外</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>尚未放置</translation>
    </message>
</context>
<context>
    <name>odo::LengthWizard</name>
    <message>
        <source>Check a known length</source>
        <translation>检查已知长度</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>完成(&amp;D)</translation>
    </message>
    <message>
        <source>Image or video of the length</source>
        <translation>长度的图片或视频</translation>
    </message>
    <message>
        <source>The camera and its image</source>
        <translation>相机及其画面</translation>
    </message>
    <message>
        <source>Both ends of the length</source>
        <translation>长度的两个端点</translation>
    </message>
    <message>
        <source>Put an object of known length on the floor, away from the markers, to check the camera&apos;s stated uncertainty. This changes nothing.</source>
        <translation>在地面上远离标记处放一件已知长度的物体，看相机的测量是否达到其应有的精度。检查不会更改任何内容。</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>相机(&amp;A)</translation>
    </message>
    <message>
        <source>Image of the length</source>
        <translation>长度见于何处</translation>
    </message>
    <message>
        <source>Loading the image…</source>
        <translation>正在获取画面…</translation>
    </message>
    <message>
        <source>Choose an image or a video.</source>
        <translation>选择图像或视频。</translation>
    </message>
</context>
<context>
    <name>odo::LensWizard</name>
    <message>
        <source>Calibrate camera</source>
        <translation>标定相机</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>The camera and the board</source>
        <translation>相机和标定板</translation>
    </message>
    <message>
        <source>Images of the board</source>
        <translation>标定板的图片</translation>
    </message>
    <message>
        <source>The lens</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>At least %1 images that show the board are needed; so far there are %2.</source>
        <translation>至少需要 %1 张能看到标定板的图像；目前有 %2 张。</translation>
    </message>
    <message>
        <source>There is no lens calibration to save yet.</source>
        <translation>还没有可保存的镜头标定。</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s) of the board</source>
        <translation>
            <numerusform>%n 张标定板图像</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::LessonBar</name>
    <message>
        <source>Ne&amp;xt</source>
        <translation>下一步(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>离开课程(&amp;L)</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>结束(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>下一步(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>跳过(&amp;S)</translation>
    </message>
</context>
<context>
    <name>odo::LiveBoard</name>
    <message>
        <source>Top-down map</source>
        <translation>俯视地图</translation>
    </message>
    <message>
        <source>Health of cameras, map and disk</source>
        <translation>相机、地图和磁盘的状况</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>Live view of %1</source>
        <translation>%1 的实时画面</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>Opening the camera…</source>
        <translation>正在打开相机…</translation>
    </message>
    <message>
        <source>live, sent to %1</source>
        <translation>实时，发送至 %1</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Waiting for the first frame…</source>
        <translation>正在等待第一帧画面…</translation>
    </message>
    <message>
        <source>No frames now</source>
        <translation>当前没有画面</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 帧/s</translation>
    </message>
</context>
<context>
    <name>odo::LiveCameraBox</name>
    <message>
        <source>Connected camera</source>
        <translation>已连接的相机</translation>
    </message>
    <message>
        <source>%1, %2×%3</source>
        <translation>%1，%2×%3</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>正在查找相机…</translation>
    </message>
    <message>
        <source>No camera is connected</source>
        <translation>未连接相机</translation>
    </message>
</context>
<context>
    <name>odo::LiveMap</name>
    <message>
        <source>Live floor map with the robots</source>
        <translation>地面地图，显示正在行驶的机器人</translation>
    </message>
    <message>
        <source>No camera is registered to the floor: robots cannot be located</source>
        <translation>没有相机配准到地面，因此无法给出地面上的位置</translation>
    </message>
</context>
<context>
    <name>odo::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>首选项(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>A recording is running. The change takes effect when you reopen the project.</source>
        <translation>正在录制，因此各页面要到项目再次打开时才更新。</translation>
    </message>
    <message>
        <source>Restore the backup</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph will rescue its contents when the running job has ended.</source>
        <translation>“%1”被其他程序删除、重命名或替换。当前工作结束后，将立即抢救其中的内容。</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph rescued its contents in “%2” and opened that project.</source>
        <translation>“%1”被其他程序删除、重命名或替换。其中的内容已抢救到“%2”，现已打开。</translation>
    </message>
    <message>
        <source>Another program overwrote “%1”. Odograph will open the new contents when the running job has ended.</source>
        <translation>另一个程序覆盖了“%1”。正在进行的工作结束后，将打开其当前内容。</translation>
    </message>
    <message>
        <source>Another program renamed “%1” and its videos. It is now open as “%2”.</source>
        <translation>另一个程序已将“%1”及其视频重命名。现在以“%2”打开。</translation>
    </message>
    <message>
        <source>Another program overwrote “%1” while it was open. Its earlier contents are gone; the window shows the new ones.</source>
        <translation>“%1”打开期间被另一个程序覆盖：之前的内容已丢失。现在显示的是其当前内容。</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>班级(&amp;L)</translation>
    </message>
    <message>
        <source>You and another bench changed the same things. Both versions are kept.</source>
        <translation>您和另一个工作台更改了相同的内容。两个版本都已保留。</translation>
    </message>
    <message>
        <source>Show both</source>
        <translation>显示两者</translation>
    </message>
    <message>
        <source>Table saved as %1.</source>
        <translation>表格已保存为 %1。</translation>
    </message>
</context>
<context>
    <name>odo::MapArea</name>
    <message>
        <source>0 to %1 apart</source>
        <translation>相距 0 至 %1</translation>
    </message>
    <message>
        <source>x %1 · y %2</source>
        <translation>x %1 · y %2</translation>
    </message>
</context>
<context>
    <name>odo::MarkActions</name>
    <message>
        <source>&amp;Star</source>
        <translation>加星标(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>归档(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Empty the bin…</source>
        <translation>清空回收站(&amp;E)…</translation>
    </message>
    <message>
        <source>Remove &amp;star</source>
        <translation>取消星标(&amp;S)</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>取消归档(&amp;A)</translation>
    </message>
    <message>
        <source>Rest&amp;ore</source>
        <translation>放回(&amp;P)</translation>
    </message>
    <message>
        <source>Restore the selected trials from the bin (Del)</source>
        <translation>将所选试验从回收站放回 (Del)</translation>
    </message>
    <message>
        <source>Move the selected trials to the bin (Del); you can restore them</source>
        <translation>将所选试验移入回收站 (Del)；可以放回</translation>
    </message>
    <message>
        <source>Empty the bin</source>
        <translation>清空回收站</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation>
            <numerusform>永久移除 %n 次试验？</numerusform>
        </translation>
    </message>
    <message>
        <source>This removes their videos (%1), measurements and results from the disk. You cannot undo it.</source>
        <translation>其视频（%1）、测量数据和结果将从磁盘上移除。此操作不能撤销。</translation>
    </message>
    <message>
        <source>&amp;Remove for good</source>
        <translation>永久移除(&amp;R)</translation>
    </message>
</context>
<context>
    <name>odo::MarkerCanvas</name>
    <message>
        <source>Image with the markers; arrow keys move the selected one</source>
        <translation>含标记的画面；方向键移动所选标记</translation>
    </message>
</context>
<context>
    <name>odo::MarkerPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>取出(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>位置，mm</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>识别为</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>found</source>
        <translation>已找到</translation>
    </message>
    <message>
        <source>Select a marker in the table and click its position. The click snaps to what is near it, to a tenth of a pixel.</source>
        <translation>在表中选择一个标记，然后在画面上点击它所在之处；点击处附近的图形会以十分之一像素的精度定位。</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>未看到</translation>
    </message>
</context>
<context>
    <name>odo::MatDialog</name>
    <message>
        <source>Find the floor mat</source>
        <translation>查找地垫</translation>
    </message>
    <message>
        <source>The mat is searched for in the newest recording of each camera: %1.</source>
        <translation>在每台相机的最新录像中查找地垫：%1。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure the line at the mat&apos;s lower edge from end mark to end mark. Printers often shrink by 2 to 4 %; what you enter makes up for it.</source>
        <translation>从一端标记到另一端标记测量地垫下边缘的线。打印机常会缩小 2 到 4 %；您输入的值会对此进行补偿。</translation>
    </message>
    <message>
        <source>&amp;Check line</source>
        <translation>检查线(&amp;C)</translation>
    </message>
    <message>
        <source>Find the mat</source>
        <translation>查找地垫</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
</context>
<context>
    <name>odo::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>关闭消息</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>odo::MessagePanel</name>
    <message>
        <source>No messages.</source>
        <translation>没有消息。</translation>
    </message>
    <message>
        <source>Dismiss &amp;all</source>
        <translation>全部清除(&amp;A)</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Close the list of messages</source>
        <translation>关闭消息列表</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭 (Esc)</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n times</source>
        <translation>
            <numerusform>%1，%n 次</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>清除：%1</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>清除</translation>
    </message>
</context>
<context>
    <name>odo::MetricGrid</name>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>No result yet: track the trial</source>
        <translation>尚无结果：请跟踪该试验</translation>
    </message>
</context>
<context>
    <name>odo::MetricModel</name>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
</context>
<context>
    <name>odo::ModeBar</name>
    <message>
        <source>Modes</source>
        <translation>模式</translation>
    </message>
</context>
<context>
    <name>odo::NetworkPage</name>
    <message>
        <source>&amp;Send live positions on the network</source>
        <translation>在网络上发送实时位置(&amp;S)</translation>
    </message>
    <message>
        <source>%1: this computer only</source>
        <translation>%1：仅限本机</translation>
    </message>
    <message>
        <source>%1: not available now</source>
        <translation>%1：当前不可用</translation>
    </message>
    <message>
        <source>Positions of the robots that Record tracks, as SSL-Vision packets for your own controllers and programs. The packets contain no names of teams or robots.</source>
        <translation>“录制”所跟踪的机器人位置，以 SSL-Vision 数据包的形式发送，供控制器和您自己的程序使用。其中不含小组或机器人的名称。</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>地址(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Interface</source>
        <translation>接口(&amp;I)</translation>
    </message>
    <message>
        <source>Odograph sends nothing.</source>
        <translation>不发送任何内容。</translation>
    </message>
    <message>
        <source>This is not an IPv4 address; enter one such as 224.5.23.2.</source>
        <translation>这不是 IPv4 地址；请写成 224.5.23.2 这样的形式。</translation>
    </message>
    <message>
        <source>They go only to the computer with this address.</source>
        <translation>发送到拥有该地址的那一台计算机。</translation>
    </message>
    <message>
        <source>They do not leave this computer.</source>
        <translation>不会离开本机。</translation>
    </message>
    <message>
        <source>Anyone on that network can read the robots&apos; positions.</source>
        <translation>该网络上的任何人都能读到机器人的位置。</translation>
    </message>
</context>
<context>
    <name>odo::NumberText</name>
    <message>
        <source>points</source>
        <translation>分</translation>
    </message>
</context>
<context>
    <name>odo::OwnMetricsDialog</name>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Own metrics</source>
        <translation>自定义指标</translation>
    </message>
    <message>
        <source>A formula uses metrics in the units below, variables of the trials that are numbers, + - * / ^, brackets, sqrt, abs, exp, ln, sin, cos, min, max and pi. Names with blanks are in braces: 0.5 * {robot mass} * max_speed^2.</source>
        <translation>公式可使用下列单位的指标、值为数字的试验变量、+ - * / ^、括号、sqrt、abs、exp、ln、sin、cos、min、max 和 pi。带空格的名称放在花括号中：0.5 * {robot mass} * max_speed^2。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>Names for formulas</source>
        <translation>可用于公式的名称</translation>
    </message>
</context>
<context>
    <name>odo::PathField</name>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>浏览：%1</translation>
    </message>
    <message>
        <source>Images and videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;All files (*)</source>
        <translation>图片和视频 (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>odo::PathSketch</name>
    <message>
        <source>The path from above</source>
        <translation>俯视路径</translation>
    </message>
</context>
<context>
    <name>odo::PickColourDialog</name>
    <message>
        <source>Pick the robot&apos;s colour</source>
        <translation>从图片取机器人颜色</translation>
    </message>
    <message>
        <source>Another &amp;video…</source>
        <translation>其他视频(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>录像(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>帧(&amp;F)</translation>
    </message>
    <message>
        <source>Choose a video that shows the robot.</source>
        <translation>请选择一段能看到机器人的视频。</translation>
    </message>
    <message>
        <source>Use this colour</source>
        <translation>采用此颜色</translation>
    </message>
    <message>
        <source>Video that shows the robot</source>
        <translation>能看到机器人的视频</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)</source>
        <translation>视频 (*.mp4 *.mov *.mkv *.avi *.m4v);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1，共 %2</translation>
    </message>
    <message>
        <source>The robot&apos;s colour here: %1. It fills %2 % of the box.</source>
        <translation>机器人此处的颜色：%1。占框内的 %2 %。</translation>
    </message>
    <message>
        <source>Draw a tight box round the robot with the mouse, or use the keyboard: arrow keys move the box, Shift + arrow keys resize it.</source>
        <translation>请用鼠标紧贴机器人画一个框；或用方向键移动框，按住 Shift 则放大或缩小。</translation>
    </message>
    <message>
        <source>%1, camera %2</source>
        <translation>%1，相机 %2</translation>
    </message>
</context>
<context>
    <name>odo::PlannedCameraForm</name>
    <message>
        <source>Position x</source>
        <translation>所在 x</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>所在 y</translation>
    </message>
    <message>
        <source>Height of the camera</source>
        <translation>相机高度</translation>
    </message>
    <message>
        <source>Looks at x</source>
        <translation>注视点 x</translation>
    </message>
    <message>
        <source>Looks at y</source>
        <translation>注视点 y</translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation>拍摄方向</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>视场角</translation>
    </message>
    <message>
        <source>0° is along X, 90° along Y; the point that the camera looks at turns with it</source>
        <translation>0° 沿 X，90° 沿 Y；改变方向会使注视点绕相机转动</translation>
    </message>
    <message>
        <source>Across the image width: a webcam has about 60° to 80°, a phone 65°</source>
        <translation>按画面宽度：网络摄像头约 60° 至 80°，手机约 65°</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>画面尺寸</translation>
    </message>
    <message>
        <source>Po&amp;sition x, y</source>
        <translation>所在 x、y(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Looks at x, y</source>
        <translation>注视点 x、y(&amp;L)</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>方向(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>视场角(&amp;F)</translation>
    </message>
</context>
<context>
    <name>odo::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Categories of preferences</source>
        <translation>首选项类别</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>常规(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Reports</source>
        <translation>报告(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>按键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Network</source>
        <translation>网络(&amp;N)</translation>
    </message>
</context>
<context>
    <name>odo::PresentWindow</name>
    <message>
        <source>Presentation</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>No trial</source>
        <translation>没有试验</translation>
    </message>
    <message>
        <source>Speed now</source>
        <translation>当前速度</translation>
    </message>
</context>
<context>
    <name>odo::ProfileChart</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>航向</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>转向角速度</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>位置 X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>位置 Y</translation>
    </message>
    <message>
        <source>Quantity of the chart</source>
        <translation>图表所示的物理量</translation>
    </message>
    <message>
        <source>smoothed ±95 %</source>
        <translation>平滑后 ±95 %</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>测得的点</translation>
    </message>
    <message>
        <source>1 spike</source>
        <translation>1 个异常点</translation>
    </message>
    <message>
        <source>%1 spikes</source>
        <translation>%1 个异常点</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>沿路径方向</translation>
    </message>
    <message>
        <source>of the motion, anticlockwise from X</source>
        <translation>运动方向，自 X 轴起逆时针</translation>
    </message>
    <message>
        <source>anticlockwise positive</source>
        <translation>逆时针为正</translation>
    </message>
    <message>
        <source>Chart: %1 over time</source>
        <translation>图表：%1 随时间的变化</translation>
    </message>
    <message>
        <source>Chart: %1 over distance</source>
        <translation>图表：%1 随路程的变化</translation>
    </message>
    <message>
        <source>of the body, anticlockwise from X</source>
        <translation>机身朝向，自 X 轴起逆时针</translation>
    </message>
    <message>
        <source>shaded: hidden, ambiguous or not measured</source>
        <translation>阴影：被遮挡、存疑或未测量</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>速度 X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>速度 Y</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>横向加速度</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>加加速度</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>行驶距离</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>到起点的距离</translation>
    </message>
    <message>
        <source>to the left positive</source>
        <translation>向左为正</translation>
    </message>
    <message>
        <source>along the path, mean over %1</source>
        <translation>沿路径方向，%1 内平均</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>到最近机器人的距离</translation>
    </message>
</context>
<context>
    <name>odo::RangeActions</name>
    <message>
        <source>Set &amp;start here</source>
        <translation>将起点设在此处(&amp;S)</translation>
    </message>
    <message>
        <source>The results are of the run from this time on; before it nothing counts.</source>
        <translation>结果只针对此时刻之后的行驶；之前的部分不计入。</translation>
    </message>
    <message>
        <source>Set &amp;end here</source>
        <translation>将终点设在此处(&amp;E)</translation>
    </message>
    <message>
        <source>The results are of the run up to this time; after it nothing counts.</source>
        <translation>结果只针对此时刻之前的行驶；之后的部分不计入。</translation>
    </message>
    <message>
        <source>From first to last &amp;motion</source>
        <translation>从首次运动到末次运动(&amp;M)</translation>
    </message>
    <message>
        <source>The results are of the run from when a robot first moves to when it last does.</source>
        <translation>结果只针对从机器人首次运动到末次运动的行驶。</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>整个行程(&amp;W)</translation>
    </message>
    <message>
        <source>The results are of all of the trial again.</source>
        <translation>结果重新针对整个试验。</translation>
    </message>
</context>
<context>
    <name>odo::RangeCard</name>
    <message>
        <source>&amp;Fit</source>
        <translation>拟合(&amp;F)</translation>
    </message>
    <message>
        <source>Robot of the statistics</source>
        <translation>显示哪个机器人的区间</translation>
    </message>
    <message>
        <source>Function to fit to the curve</source>
        <translation>对曲线作何种拟合</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>常数</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>parabola</source>
        <translation>抛物线</translation>
    </message>
    <message>
        <source>Fitted quantity</source>
        <translation>拟合的物理量</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>所选部分</translation>
    </message>
    <message>
        <source>Statistics of the selection</source>
        <translation>所选部分的指标</translation>
    </message>
</context>
<context>
    <name>odo::RecordPage</name>
    <message>
        <source>No camera is connected</source>
        <translation>未连接相机</translation>
    </message>
    <message>
        <source>Connect one or two cameras, then search again. If a connected camera is not found, run the set-up doctor.</source>
        <translation>请连接一台或两台相机，然后重新查找。若已连接却找不到，请使用装置诊断。</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>重新查找</translation>
    </message>
    <message>
        <source>Set-up doctor…</source>
        <translation>装置诊断…</translation>
    </message>
    <message>
        <source>Choose &amp;cameras…</source>
        <translation>选择相机(&amp;C)…</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>相机…</translation>
    </message>
    <message>
        <source>Assign the connected devices to the cameras of the project</source>
        <translation>选择哪个已连接的设备是项目中的哪台相机</translation>
    </message>
    <message>
        <source>Set-up &amp;doctor…</source>
        <translation>装置诊断(&amp;D)…</translation>
    </message>
    <message>
        <source>Doctor…</source>
        <translation>诊断…</translation>
    </message>
    <message>
        <source>Check for what makes cameras lose frames or measure wrongly, and get advice</source>
        <translation>查找导致相机丢失画面或测量错误的原因，并给出建议</translation>
    </message>
    <message>
        <source>Give the trial a name</source>
        <translation>请给试验取一个名称</translation>
    </message>
    <message>
        <source>Register a camera to the floor, or begin at once</source>
        <translation>请将相机与地面配准，或立即开始</translation>
    </message>
</context>
<context>
    <name>odo::ReferenceCameraPage</name>
    <message>
        <source>Image or video of the camera to register</source>
        <translation>待配准相机的图片或视频</translation>
    </message>
    <message>
        <source>Image or video of the registered camera</source>
        <translation>已配准相机的图片或视频</translation>
    </message>
    <message>
        <source>A camera cannot be registered via itself: choose two different ones.</source>
        <translation>相机不能通过自身配准：请选择两台不同的相机。</translation>
    </message>
    <message>
        <source>Camera to register</source>
        <translation>待配准相机</translation>
    </message>
    <message>
        <source>Registered camera</source>
        <translation>已配准相机</translation>
    </message>
    <message>
        <source>Register a camera that sees no markers by floor points that a registered camera also sees: corners of tiles, ends of tape, screws. Four are enough; six or more, spread over the common area, are better. Do not move either camera afterwards.</source>
        <translation>看不到标记的相机，可以用已配准相机也能看到的地面上的点来配准：地砖的角、胶带的端头、螺钉。四个就够，六个或更多且分散在公共部分更好。此后两台相机都不得移动。</translation>
    </message>
    <message>
        <source>C&amp;amera to register</source>
        <translation>待配准相机(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Via camera</source>
        <translation>通过相机(&amp;T)</translation>
    </message>
    <message>
        <source>Its image</source>
        <translation>其画面</translation>
    </message>
    <message>
        <source>The registered camera&apos;s image</source>
        <translation>已配准相机的画面</translation>
    </message>
    <message>
        <source>Choose an image for each camera.</source>
        <translation>为每台相机选择一张图像。</translation>
    </message>
</context>
<context>
    <name>odo::RegisterViaCameraWizard</name>
    <message>
        <source>Register via another camera</source>
        <translation>通过另一相机配准</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Two cameras and their images</source>
        <translation>两台相机及其画面</translation>
    </message>
    <message>
        <source>The same points in both images</source>
        <translation>两个画面中的相同点</translation>
    </message>
    <message>
        <source>Loading the images…</source>
        <translation>正在获取画面…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>还没有可保存的配准。</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>配准</translation>
    </message>
</context>
<context>
    <name>odo::RegistrationVerdict</name>
    <message>
        <source>Camera position</source>
        <translation>相机所在位置</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Camera position: x %1 m, y %2 m, %3 m above the floor.</source>
        <translation>位于 x %1 m，y %2 m，距地面 %3 m。</translation>
    </message>
    <message>
        <source>The registration was not stored. %1</source>
        <translation>配准未能存储。%1</translation>
    </message>
</context>
<context>
    <name>odo::ReportActions</name>
    <message>
        <source>The trial %1</source>
        <translation>试验 %1</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>报告(&amp;R)…</translation>
    </message>
    <message>
        <source>The comparison of %1 and %2</source>
        <translation>%1 与 %2 的比较</translation>
    </message>
    <message>
        <source>A class</source>
        <translation>一个班级</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), a page each</source>
        <translation>
            <numerusform>%n 次试验，每次一页</numerusform>
        </translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF 文件 (*.pdf)</translation>
    </message>
    <message>
        <source>Report saved as %1.</source>
        <translation>报告已保存为 %1。</translation>
    </message>
    <message>
        <source>Report sent to printer %1.</source>
        <translation>报告已送至打印机 %1。</translation>
    </message>
    <message>
        <source>Over the floor that the cameras see</source>
        <translation>在相机可见的地面上</translation>
    </message>
    <message>
        <source>The simulated run:</source>
        <translation>模拟的运行：</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>保存证书</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Certificate saved as %1.</source>
        <translation>证书已保存为 %1。</translation>
    </message>
    <message>
        <source>C&amp;ertificate of this set-up…</source>
        <translation>此设置的证书(&amp;E)…</translation>
    </message>
</context>
<context>
    <name>odo::ReportDialog</name>
    <message>
        <source>A page for each &amp;team</source>
        <translation>每个小组一页(&amp;T)</translation>
    </message>
    <message>
        <source>A second page with the &amp;method</source>
        <translation>附一页方法说明(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>保存为 PDF(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>打印(&amp;P)…</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>班级(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>任务(&amp;T)</translation>
    </message>
    <message>
        <source>Most common</source>
        <translation>常用任务</translation>
    </message>
    <message>
        <source>M&amp;etric</source>
        <translation>指标(&amp;F)</translation>
    </message>
    <message>
        <source>Most informative</source>
        <translation>最能说明问题的指标</translation>
    </message>
    <message>
        <source>Report &amp;of</source>
        <translation>报告内容(&amp;O)</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>纸张(&amp;A)</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>School, &amp;logo and wording…</source>
        <translation>学校、校徽和文字(&amp;L)…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Nothing to print yet.</source>
        <translation>尚无可打印的内容。</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n 页</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n page(s); the file has all of them.</source>
        <translation>
            <numerusform>前 %n 页；文件中有全部页面。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportPreview</name>
    <message>
        <source>Preview of the pages</source>
        <translation>页面预览</translation>
    </message>
    <message>
        <source>Drawing the pages…</source>
        <translation>正在绘制页面…</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n 页</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportsPage</name>
    <message>
        <source>&amp;School</source>
        <translation>学校(&amp;S)</translation>
    </message>
    <message>
        <source>shown at the top of each page</source>
        <translation>位于每页的页眉</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>校徽</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.svg)</source>
        <translation>图片 (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
        <source>&amp;Logo</source>
        <translation>校徽(&amp;L)</translation>
    </message>
    <message>
        <source>Preview of the logo</source>
        <translation>校徽的样子</translation>
    </message>
    <message>
        <source>&amp;At the bottom</source>
        <translation>页脚(&amp;A)</translation>
    </message>
    <message>
        <source>for example: whom to ask</source>
        <translation>例如：由谁解答问题</translation>
    </message>
</context>
<context>
    <name>odo::ReprocessDialog</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>&amp;Reanalyse</source>
        <translation>重新测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>保留(&amp;K)</translation>
    </message>
    <message>
        <source>Reanalyse trials</source>
        <translation>重新测量试验</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>变化情况</translation>
    </message>
    <message>
        <source>What changes, in words</source>
        <translation>变化情况说明</translation>
    </message>
    <message>
        <source>What was detected in the videos stays as it is; its floor positions are recomputed with the current registrations. Check what changes, then keep it or not: the older analysis stays in the project too.</source>
        <translation>视频中所见的内容保持不变；其在地面上的位置按当前生效的配准重新计算。请查看变化，再决定是否保留：以前的分析也仍留在项目中。</translation>
    </message>
    <message>
        <source>&amp;Trial</source>
        <translation>试验(&amp;T)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1 (measured with an older registration)</source>
        <translation>%1（用以前的配准测量）</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>正在测量…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Kept: the new analysis of %1 is the current one.</source>
        <translation>已保留：%1 的新分析成为当前分析。</translation>
    </message>
</context>
<context>
    <name>odo::ResidualPlot</name>
    <message>
        <source>Residual against the cut-off</source>
        <translation>残差随截止频率的变化</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>residual analysis</source>
        <translation>残差分析</translation>
    </message>
    <message>
        <source>a filter of %1 takes away %2</source>
        <translation>%1 的滤波器去除 %2</translation>
    </message>
</context>
<context>
    <name>odo::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Robot whose result is shown</source>
        <translation>显示哪个机器人的结果</translation>
    </message>
    <message>
        <source>robot “%1”</source>
        <translation>机器人“%1”</translation>
    </message>
</context>
<context>
    <name>odo::ResultStatisticsModel</name>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Number of values: runs without bad results, lower bounds or another course</source>
        <translation>值的个数：不含不良结果、下限值或其他路线的运行</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Mean ± its standard error (SD / √runs)</source>
        <translation>平均值 ± 其标准误（SD / √运行次数）</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>Standard deviation of one run</source>
        <translation>单次运行的标准差</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>Coefficient of variation: SD as a part of the mean</source>
        <translation>变异系数：SD 与平均值之比</translation>
    </message>
    <message>
        <source>CV %</source>
        <translation>CV %</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Most</source>
        <translation>最大</translation>
    </message>
</context>
<context>
    <name>odo::ResultsModel</name>
    <message>
        <source>not tracked</source>
        <translation>未跟踪</translation>
    </message>
    <message>
        <source>Not used in means: a lower bound, a bad result, or another course</source>
        <translation>不计入平均值：下限值、不良结果或其他路线</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
</context>
<context>
    <name>odo::ResultsPanel</name>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Group by</source>
        <translation>分组依据</translation>
    </message>
    <message>
        <source>Results of the trials</source>
        <translation>试验结果</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>任意班级</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>任意任务</translation>
    </message>
    <message>
        <source>No groups</source>
        <translation>不分组</translation>
    </message>
    <message>
        <source>Search…</source>
        <translation>搜索…</translation>
    </message>
    <message>
        <source>Search the results</source>
        <translation>搜索结果</translation>
    </message>
    <message>
        <source>Trials, teams, robots, tags and variables with all of these words</source>
        <translation>包含所有这些词的试验、小组、机器人、标签和变量</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Which metrics are shown</source>
        <translation>显示哪些指标</translation>
    </message>
    <message>
        <source>&amp;Save table…</source>
        <translation>保存表格(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Copy with headings</source>
        <translation>连同标题复制(&amp;C)</translation>
    </message>
    <message>
        <source>By team</source>
        <translation>按小组</translation>
    </message>
    <message>
        <source>By class</source>
        <translation>按班级</translation>
    </message>
    <message>
        <source>By task</source>
        <translation>按任务</translation>
    </message>
    <message>
        <source>By robot</source>
        <translation>按机器人</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>按 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n 次运行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n run(s)</source>
        <translation>
            <numerusform>%n 次运行中的 %1 次</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n run(s) shown</source>
        <translation>
            <numerusform>所显示的 %n 次运行的统计</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n selected run(s)</source>
        <translation>
            <numerusform>所选 %n 次运行的统计</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Workbook with statistics (*.xlsx)</source>
        <translation>带统计的工作簿 (*.xlsx)</translation>
    </message>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>供程序使用的 CSV (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>供电子表格使用的 CSV，1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>供电子表格使用的 CSV，1,5 (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Own metrics…</source>
        <translation>自定义指标(&amp;O)…</translation>
    </message>
</context>
<context>
    <name>odo::ReviewColumn</name>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>试验概况</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet. Tracking follows the robot through the videos and computes its position and speed.</source>
        <translation>此试验尚未跟踪。跟踪会在视频中追随机器人，并得出它在何处、速度多大。</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>跟踪…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>The areas have changed since this trial was tracked. Track it again to use them.</source>
        <translation>自跟踪此试验以来，区域已更改。请重新跟踪以使用它们。</translation>
    </message>
</context>
<context>
    <name>odo::ReviewDesk</name>
    <message>
        <source>&amp;Silhouettes of the robots</source>
        <translation>机器人的轮廓(&amp;S)</translation>
    </message>
    <message>
        <source>Outline the detected robots in each view</source>
        <translation>在每个视角中描出被当作机器人的部分的轮廓</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Enlarge, or back</source>
        <translation>最大化视角或还原(&amp;E)</translation>
    </message>
    <message>
        <source>Of the view or map under the mouse</source>
        <translation>鼠标所在的视角或地图</translation>
    </message>
    <message>
        <source>Lo&amp;upe on the robot</source>
        <translation>机器人放大镜(&amp;U)</translation>
    </message>
    <message>
        <source>Show the surroundings of the robot eight times as large as recorded</source>
        <translation>以录制画面八倍的大小显示机器人周围</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>演示(&amp;P)</translation>
    </message>
    <message>
        <source>Team, map, speed and result in large type, on a second screen if there is one</source>
        <translation>以大号字显示小组、地图、速度和结果；有第二个屏幕时显示在那里</translation>
    </message>
</context>
<context>
    <name>odo::ReviewPage</name>
    <message>
        <source>No trials yet</source>
        <translation>尚无试验</translation>
    </message>
    <message>
        <source>A trial is one run of a robot. Import the videos that your cameras took of it to see it here.</source>
        <translation>一次试验就是机器人的一次运行。请导入相机拍下的视频，试验就会显示在这里。</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>从视频导入试验…</translation>
    </message>
    <message>
        <source>Accept doubtful results</source>
        <translation>接受存疑的结果</translation>
    </message>
    <message>
        <source>Why can these results be used? The reason is shown wherever they are.</source>
        <translation>为什么可以使用这些结果？理由会在显示结果的所有地方显示。</translation>
    </message>
</context>
<context>
    <name>odo::RevisionImage</name>
    <message>
        <source>Source image</source>
        <translation>制作时所用的图片</translation>
    </message>
    <message>
        <source>Reading the image…</source>
        <translation>正在读取图片…</translation>
    </message>
    <message>
        <source>Cannot read the image.</source>
        <translation>无法读取图片。</translation>
    </message>
</context>
<context>
    <name>odo::RevisionsDialog</name>
    <message>
        <source>&amp;Use this one</source>
        <translation>使用此版本(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Register with this calibration</source>
        <translation>用此镜头配准(&amp;R)</translation>
    </message>
    <message>
        <source>Reanalyse &amp;trials…</source>
        <translation>重新测量试验(&amp;M)…</translation>
    </message>
    <message>
        <source>Calibrations and registrations</source>
        <translation>标定与配准</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>From</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>生效</translation>
    </message>
    <message>
        <source>Revisions</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Makes the selected revision the current one for new measurements; trials keep theirs</source>
        <translation>使所选版本对今后的测量生效；已有试验保留各自的版本</translation>
    </message>
    <message>
        <source>Recomputes the current registration from the same markers, with the current lens calibration</source>
        <translation>用相同的标记和当前生效的镜头重新计算生效的配准</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>相机(&amp;A)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The camera is neither calibrated nor registered yet.</source>
        <translation>该相机尚未标定，也未配准。</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Calibration %1</source>
        <translation>标定 %1</translation>
    </message>
    <message>
        <source>Registration %1</source>
        <translation>配准 %1</translation>
    </message>
    <message>
        <source>current</source>
        <translation>生效</translation>
    </message>
    <message>
        <source>No trial uses it.</source>
        <translation>没有试验用它测量。</translation>
    </message>
    <message>
        <source>Trials that use it: %1.</source>
        <translation>用它测量的试验：%1。</translation>
    </message>
    <message>
        <source>%1 is now current. The registrations keep the lens calibration that they were made with: register the camera with this one.</source>
        <translation>%1 已生效。各配准仍保留制作时所用的镜头：请用此镜头配准相机。</translation>
    </message>
    <message>
        <source>%1 is now current. Trials keep theirs until you reanalyse them.</source>
        <translation>%1 已生效。试验在重新测量之前保留各自的版本。</translation>
    </message>
    <message>
        <source>Registration %1 is now current: the same markers, with this lens calibration. %2</source>
        <translation>配准 %1 已生效：标记相同，采用此镜头。%2</translation>
    </message>
</context>
<context>
    <name>odo::RmsSoFar</name>
    <message>
        <source>RMS so far</source>
        <translation>目前的 RMS</translation>
    </message>
    <message>
        <source>RMS: from %1 images on</source>
        <translation>RMS：从 %1 张图像起</translation>
    </message>
    <message>
        <source>RMS: not yet, %1</source>
        <translation>RMS：尚无，%1</translation>
    </message>
    <message>
        <source>RMS so far: %1 px; highest: %2 px in %3</source>
        <translation>目前的 RMS：%1 px；最高：%3 中的 %2 px</translation>
    </message>
</context>
<context>
    <name>odo::RobotDialog</name>
    <message>
        <source>Add robot</source>
        <translation>添加机器人</translation>
    </message>
    <message>
        <source>Estimated from the views</source>
        <translation>由视角得出</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Changes while it runs (ramp)</source>
        <translation>运行中变化（斜坡）</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Height of the robot&apos;s top</source>
        <translation>机器人顶面高度</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Pick from a video…</source>
        <translation>从图片选取(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Colour of its top</source>
        <translation>顶面颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Drawn in</source>
        <translation>绘图颜色(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Height of its top</source>
        <translation>顶面高度(&amp;H)</translation>
    </message>
    <message>
        <source>Colour of the robot&apos;s top</source>
        <translation>机器人顶面颜色</translation>
    </message>
    <message>
        <source>Change robot</source>
        <translation>更改机器人</translation>
    </message>
    <message>
        <source>Its silhouette</source>
        <translation>与地面的差别</translation>
    </message>
    <message>
        <source>A colour of its own</source>
        <translation>自己的颜色</translation>
    </message>
    <message>
        <source>The silhouette works for any robot. A colour of its own helps if several things move.</source>
        <translation>任何外观的机器人都按它与地面的差别来寻找。有多个物体移动时，自己的颜色会有帮助。</translation>
    </message>
    <message>
        <source>D&amp;etected by</source>
        <translation>寻找依据(&amp;F)</translation>
    </message>
    <message>
        <source>Colour in charts and maps; the robot itself may have another</source>
        <translation>用于图表和地图，与机器人的外观无关</translation>
    </message>
    <message>
        <source>Offset from the middle of the robot&apos;s footprint; 0 and 0 is the middle itself.</source>
        <translation>从机器人在地面上所占区域的中心算起；0 和 0 即中心本身。</translation>
    </message>
    <message>
        <source> mm forward</source>
        <translation> 毫米向前</translation>
    </message>
    <message>
        <source>Reference point, forward of the robot&apos;s middle</source>
        <translation>测量点，在机器人中心前方</translation>
    </message>
    <message>
        <source> mm left</source>
        <translation> 毫米向左</translation>
    </message>
    <message>
        <source>Reference point, left of the robot&apos;s middle</source>
        <translation>测量点，在机器人中心左侧</translation>
    </message>
    <message>
        <source>&amp;Reference point</source>
        <translation>测量点(&amp;M)</translation>
    </message>
</context>
<context>
    <name>odo::RobotFootprint</name>
    <message>
        <source>The robot from above, heading to the right</source>
        <translation>从上方看的机器人，朝向右侧</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>No size given. Drawn as %1 × %2 mm</source>
        <translation>未给出尺寸，按 %1 × %2 mm 绘制</translation>
    </message>
</context>
<context>
    <name>odo::RobotPointing</name>
    <message>
        <source>&amp;Point out a robot</source>
        <translation>指出机器人(&amp;P)</translation>
    </message>
    <message>
        <source>Wrong object outlined? Click the robot in a view to track the trial again (%1)</source>
        <translation>轮廓画错了对象：请在画面中点击机器人，试验将重新跟踪（%1）</translation>
    </message>
    <message>
        <source>This is %1: track it again</source>
        <translation>这是 %1：重新跟踪</translation>
    </message>
    <message>
        <source>Find %1 automatically</source>
        <translation>不借助提示查找 %1</translation>
    </message>
</context>
<context>
    <name>odo::RobotsDialog</name>
    <message>
        <source>estimated from the views</source>
        <translation>由视角得出</translation>
    </message>
    <message>
        <source>changes while it runs</source>
        <translation>运行中变化</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>添加(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>编辑(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Drawn in</source>
        <translation>绘图颜色</translation>
    </message>
    <message>
        <source>Height of its top</source>
        <translation>顶面高度</translation>
    </message>
    <message>
        <source>Length × width</source>
        <translation>长 × 宽</translation>
    </message>
    <message>
        <source>A new colour or height applies from the next tracking on; earlier results stay as they are.</source>
        <translation>更改颜色或高度后，从下一次跟踪起生效；之前的测量结果保持不变。</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>已完成的操作</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>its silhouette</source>
        <translation>其轮廓</translation>
    </message>
    <message>
        <source>Detected by</source>
        <translation>寻找依据</translation>
    </message>
</context>
<context>
    <name>odo::RunCard</name>
    <message>
        <source>Up now</source>
        <translation>当前上场</translation>
    </message>
    <message>
        <source>Robots of this run</source>
        <translation>行驶的机器人</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>班级(&amp;C)</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>小组(&amp;A)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>任务(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>机器人(&amp;O)</translation>
    </message>
    <message>
        <source>Trial &amp;name</source>
        <translation>试验名称(&amp;N)</translation>
    </message>
    <message>
        <source>Be&amp;gins</source>
        <translation>开始方式(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Laps</source>
        <translation>圈数(&amp;L)</translation>
    </message>
    <message>
        <source>Number of laps</source>
        <translation>跑满多少圈后结束</translation>
    </message>
    <message>
        <source>Team of this run</source>
        <translation>上场小组</translation>
    </message>
    <message>
        <source>When the recording begins</source>
        <translation>录制的开始方式</translation>
    </message>
    <message>
        <source>no class</source>
        <translation>无班级</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>no team</source>
        <translation>无小组</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Seconds recorded before the start</source>
        <translation>开始前录制的秒数</translation>
    </message>
    <message>
        <source>Frames of this time are kept in memory, so a late press loses nothing</source>
        <translation>这段时间的帧保留在内存中，因此按晚了也不会丢失</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>开始前</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>At rest for</source>
        <translation>静止时长</translation>
    </message>
    <message>
        <source>After start</source>
        <translation>开始后</translation>
    </message>
    <message>
        <source>When the recording ends</source>
        <translation>录像何时结束</translation>
    </message>
    <message>
        <source>Seconds without motion that end the recording</source>
        <translation>结束录像所需的静止秒数</translation>
    </message>
    <message>
        <source>Seconds after the start that end the recording</source>
        <translation>开始后多少秒结束录像</translation>
    </message>
</context>
<context>
    <name>odo::RunChooser</name>
    <message>
        <source>start gate</source>
        <translation>起点门</translation>
    </message>
    <message>
        <source>onset of motion</source>
        <translation>开始运动</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>路程</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>运行 1</translation>
    </message>
    <message>
        <source>Second run</source>
        <translation>运行 2</translation>
    </message>
    <message>
        <source>How to align the runs</source>
        <translation>视为相同的时刻</translation>
    </message>
    <message>
        <source>Swap the two runs</source>
        <translation>交换两次运行</translation>
    </message>
    <message>
        <source>Add more runs</source>
        <translation>更多运行</translation>
    </message>
    <message>
        <source>&amp;Shift</source>
        <translation>偏移(&amp;S)</translation>
    </message>
    <message>
        <source>Distan&amp;ce</source>
        <translation>位置(&amp;C)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time shift of the second run; positive: later</source>
        <translation>运行 2 的该时刻晚多少</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>first common point</source>
        <translation>全部已开始处</translation>
    </message>
    <message>
        <source>Distance along the path at which the runs are aligned</source>
        <translation>沿路线多远处视为各次运行的同一时刻</translation>
    </message>
    <message>
        <source>F&amp;irst</source>
        <translation>运行 1(&amp;I)</translation>
    </message>
    <message>
        <source>Seco&amp;nd</source>
        <translation>运行 2(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Align by</source>
        <translation>对齐方式(&amp;A)</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>自动：%1</translation>
    </message>
    <message>
        <source>No more runs</source>
        <translation>没有更多运行</translation>
    </message>
</context>
<context>
    <name>odo::RunResultCard</name>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>&amp;Open in Review</source>
        <translation>在“回放”中打开(&amp;O)</translation>
    </message>
    <message>
        <source>The results appear here shortly after the run ends.</source>
        <translation>运行结束片刻后，其指标会显示在此处。</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>正在测量…</translation>
    </message>
    <message>
        <source>Spikes flagged</source>
        <translation>标出的异常点</translation>
    </message>
    <message>
        <source>From live tracking. The final results follow shortly, from the recording.</source>
        <translation>来自实时跟踪。最终指标稍后由录像得出。</translation>
    </message>
    <message>
        <source>Final, from every frame of the recording.</source>
        <translation>最终结果，由录像的每一帧得出。</translation>
    </message>
</context>
<context>
    <name>odo::RunResults</name>
    <message>
        <source>%1 is analysed.</source>
        <translation>%1 已测量。</translation>
    </message>
    <message>
        <source>Recorded, but not analysed: %1</source>
        <translation>已录制，但无法测量：%1</translation>
    </message>
    <message>
        <source>%1 is recorded.</source>
        <translation>%1 已录制。</translation>
    </message>
    <message>
        <source>Recording failed: %1</source>
        <translation>无法录制：%1</translation>
    </message>
</context>
<context>
    <name>odo::SampleModel</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>± Speed</source>
        <translation>± 速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>± Acceleration</source>
        <translation>± 加速度</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>航向</translation>
    </message>
    <message>
        <source>± Heading</source>
        <translation>± 航向</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>转向角速度</translation>
    </message>
    <message>
        <source>± Turn rate</source>
        <translation>± 转向角速度</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>行驶距离</translation>
    </message>
    <message>
        <source>Measured x</source>
        <translation>测得的 x</translation>
    </message>
    <message>
        <source>Measured y</source>
        <translation>测得的 y</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视角</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>标记</translation>
    </message>
</context>
<context>
    <name>odo::SampleTable</name>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Samples of the run</source>
        <translation>运行的样本</translation>
    </message>
    <message>
        <source>&amp;Copy with headings</source>
        <translation>连同标题复制(&amp;C)</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Which columns are shown</source>
        <translation>显示哪些列</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n 个样本</numerusform>
        </translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>尚未跟踪</translation>
    </message>
</context>
<context>
    <name>odo::ScoreboardDialog</name>
    <message>
        <source>&amp;Copy address</source>
        <translation>复制地址(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Open in browser</source>
        <translation>在浏览器中打开(&amp;O)</translation>
    </message>
    <message>
        <source>Standings as a web page</source>
        <translation>网页排名</translation>
    </message>
    <message>
        <source>Show the standings on a projector or on phones. The page follows the project as long as this window is open.</source>
        <translation>在投影仪或手机上显示排名。此窗口打开期间，页面随项目更新。</translation>
    </message>
    <message>
        <source>C&amp;lass:</source>
        <translation>班级(&amp;L)：</translation>
    </message>
    <message>
        <source>&amp;Task:</source>
        <translation>任务(&amp;T)：</translation>
    </message>
    <message>
        <source>&amp;Visible to:</source>
        <translation>可见范围(&amp;V)：</translation>
    </message>
    <message>
        <source>Address of the page</source>
        <translation>页面地址</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>所有班级</translation>
    </message>
    <message>
        <source>Task of the newest trial</source>
        <translation>最新试验的任务</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>仅此电脑</translation>
    </message>
    <message>
        <source>All devices in the network</source>
        <translation>网络中的所有设备</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>正在启动…</translation>
    </message>
    <message>
        <source>Everyone in the network can open this page. It shows the names of teams, classes and tasks, and no others.</source>
        <translation>网络中的任何人都可以打开此页面。它只显示小组、班级和任务的名称。</translation>
    </message>
    <message>
        <source>Only this computer can open this page.</source>
        <translation>只有此电脑可以打开此页面。</translation>
    </message>
</context>
<context>
    <name>odo::ScoringTable</name>
    <message>
        <source>Remo&amp;ve line</source>
        <translation>移除评分项(&amp;V)</translation>
    </message>
    <message>
        <source>Each line gives all its points if the metric reaches the first bound, none at the second bound or worse, and a proportional share between them. Negative points are a penalty.</source>
        <translation>每个评分项在指标达到满分界限或更好时得满分，在零分界限或更差时不得分，两者之间按比例给分。负的分值为扣分。</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>All points at</source>
        <translation>满分界限</translation>
    </message>
    <message>
        <source>None at</source>
        <translation>零分界限</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>分值</translation>
    </message>
    <message>
        <source>Lines of the scoring</source>
        <translation>评分项</translation>
    </message>
    <message>
        <source>What the lines mean</source>
        <translation>评分项的含义</translation>
    </message>
    <message>
        <source>&amp;Add line</source>
        <translation>添加评分项(&amp;A)</translation>
    </message>
    <message>
        <source>Scored metric</source>
        <translation>计分的指标</translation>
    </message>
    <message>
        <source>Without a line, runs of the task are not scored.</source>
        <translation>没有评分项时，该任务的运行不评分。</translation>
    </message>
    <message>
        <source>Total: %1 points.</source>
        <translation>合计 %1 分。</translation>
    </message>
</context>
<context>
    <name>odo::SeriesKey</name>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>%1: click to hide or show</source>
        <translation>%1：单击可隐藏或显示</translation>
    </message>
</context>
<context>
    <name>odo::SharedField</name>
    <message>
        <source>several</source>
        <translation>多个值</translation>
    </message>
    <message>
        <source>%1: several</source>
        <translation>%1：多个值</translation>
    </message>
    <message>
        <source>The trials differ here. Press to enter one value for all of them.</source>
        <translation>这些试验在此处不同。按下可为全部试验输入同一个值。</translation>
    </message>
</context>
<context>
    <name>odo::SharedPointsPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>取出(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Image of the camera to register; arrow keys move the selected point</source>
        <translation>待配准相机的画面；方向键移动所选的点</translation>
    </message>
    <message>
        <source>Image of the registered camera; arrow keys move the selected point</source>
        <translation>已配准相机的画面；方向键移动所选的点</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>见于</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>地面位置，mm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Floor points</source>
        <translation>地面上的点</translation>
    </message>
    <message>
        <source>Camera %1, to be registered</source>
        <translation>相机 %1，待配准</translation>
    </message>
    <message>
        <source>Camera %1, registered</source>
        <translation>相机 %1，已配准</translation>
    </message>
    <message>
        <source>P%1</source>
        <comment>a point</comment>
        <translation>P%1</translation>
    </message>
    <message>
        <source>Click a floor point in the left image, then the same point in the right image. A click snaps to what is near it, to a tenth of a pixel; arrow keys move the selected point, Space snaps it.</source>
        <translation>在左侧画面中点击地面上的一点，再在右侧画面中点击同一点。点击处附近的图形会以十分之一像素的精度定位；方向键移动所选的点，空格键使其吸附。</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>在地平线以外</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>both images</source>
        <translation>两个画面</translation>
    </message>
    <message>
        <source>left only</source>
        <translation>仅左侧</translation>
    </message>
    <message>
        <source>right only</source>
        <translation>仅右侧</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>尚未放置</translation>
    </message>
</context>
<context>
    <name>odo::SmoothingPanel</name>
    <message>
        <source>%1: measured for less than a second</source>
        <translation>%1：测量不足一秒</translation>
    </message>
    <message>
        <source>%1: smoothed automatically like a filter with a cut-off of %2; what it takes away is %3 of each coordinate</source>
        <translation>%1：自动平滑，相当于截止频率 %2 的滤波器；它从每个坐标去除 %3</translation>
    </message>
    <message>
        <source>%1: the smoother states no cut-off</source>
        <translation>%1：该平滑方法没有截止频率</translation>
    </message>
    <message>
        <source>Noise of the measurements by their residuals: %1; stated: %2</source>
        <translation>由残差得出的测量噪声：%1；标称：%2</translation>
    </message>
    <message>
        <source>Cut-off by residual analysis: %1</source>
        <translation>残差分析得出的截止频率：%1</translation>
    </message>
    <message>
        <source>Residual analysis gives no cut-off: the residuals are not those of noise.</source>
        <translation>残差分析得不出截止频率：残差不像噪声。</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>residual of a Butterworth filter, by its cut-off</source>
        <translation>巴特沃斯滤波器的残差（按截止频率）</translation>
    </message>
    <message>
        <source>Smoothing of the robots</source>
        <translation>各机器人的平滑</translation>
    </message>
    <message>
        <source>No curve yet: track the trial.</source>
        <translation>还没有曲线：请跟踪该试验。</translation>
    </message>
</context>
<context>
    <name>odo::SoundChart</name>
    <message>
        <source>Loudness</source>
        <translation>响度</translation>
    </message>
    <message>
        <source>Loudness of both views</source>
        <translation>两个视角的响度</translation>
    </message>
</context>
<context>
    <name>odo::SpikeActions</name>
    <message>
        <source>&amp;Use sample</source>
        <translation>采用采样点(&amp;U)</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as valid and use it, even if it was flagged</source>
        <translation>此刻的测量是正确的，无论有何反证都应采用</translation>
    </message>
    <message>
        <source>Mark as &amp;spike</source>
        <translation>标为异常点(&amp;S)</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as a spike and do not use it</source>
        <translation>此刻的测量是错误的，不应采用</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>自动判定(&amp;A)</translation>
    </message>
    <message>
        <source>Remove the manual override at this moment</source>
        <translation>撤回此刻的手动判定</translation>
    </message>
</context>
<context>
    <name>odo::SpikeList</name>
    <message>
        <source>Spikes</source>
        <translation>异常点</translation>
    </message>
    <message>
        <source>Spikes with time and reason</source>
        <translation>异常点及其时间和原因</translation>
    </message>
    <message>
        <source>Select all with this &amp;reason</source>
        <translation>选择具有此原因的所有项(&amp;R)</translation>
    </message>
    <message>
        <source>Select all in the selected ra&amp;nge</source>
        <translation>选择所选区间内的所有项(&amp;N)</translation>
    </message>
    <message>
        <source>Select all spikes of this robot that have the reason of the selected one</source>
        <translation>选择此机器人中与所选异常点原因相同的所有异常点</translation>
    </message>
    <message>
        <source>Select all spikes of this robot within the selection on the time line</source>
        <translation>选择此机器人在时间线所选范围内的所有异常点</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>已选择 %n 个</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SpikeModel</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 flagged</source>
        <translation>标出 %1 个</translation>
    </message>
    <message>
        <source>%1 restored</source>
        <translation>恢复 %1 个</translation>
    </message>
    <message>
        <source>used, by hand</source>
        <translation>手动采用</translation>
    </message>
    <message>
        <source>%1 (restored by hand)</source>
        <translation>%1（手动恢复）</translation>
    </message>
    <message>
        <source>Restored by hand</source>
        <translation>已手动恢复</translation>
    </message>
    <message>
        <source>Flagged, not used for the curve</source>
        <translation>已标出，未用于曲线</translation>
    </message>
    <message>
        <source>Flagged, still used for the curve</source>
        <translation>已标出，仍用于曲线</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>%1 ambiguous</source>
        <translation>%1 处存疑</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1 处被遮挡</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1 处未测量</translation>
    </message>
</context>
<context>
    <name>odo::StandingsModel</name>
    <message>
        <source>choose a task</source>
        <translation>请选择任务</translation>
    </message>
    <message>
        <source>needs three trials at different times</source>
        <translation>需要三次不同时间的试验</translation>
    </message>
    <message>
        <source>within the spread (%1)</source>
        <translation>在离散度以内（%1）</translation>
    </message>
    <message>
        <source>better: %1</source>
        <translation>变好：%1</translation>
    </message>
    <message>
        <source>worse: %1</source>
        <translation>变差：%1</translation>
    </message>
    <message>
        <source>one trial</source>
        <translation>仅一次试验</translation>
    </message>
    <message>
        <source>One more than the number of significantly better teams (medians differ by more than 1.96 σ). Runs of different tasks are not ranked</source>
        <translation>确定更好的小组数加一：其中位数相差超过 1.96 σ。不同任务的运行不排名次</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>名次</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>Repeatability: standard deviation of one trial about the line of progress</source>
        <translation>重复性：单次试验相对于进步直线的标准差</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>离散度</translation>
    </message>
    <message>
        <source>Change over the term by a straight-line fit; Student&apos;s t-test (95 %) decides if it exceeds the spread</source>
        <translation>一学期内的变化，按直线拟合；是否超出离散度按学生 t 检验判断，95 %</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进步</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n doubtful</source>
        <translation>
            <numerusform>%1，%n 个存疑</numerusform>
        </translation>
    </message>
    <message>
        <source>Those with bad results do not count</source>
        <translation>结果不可用的试验不计入</translation>
    </message>
    <message>
        <source>± from the spread of all teams&apos; trials, at least that of the measurement</source>
        <translation>± 来自所有小组试验的离散度，不小于测量本身的 ±</translation>
    </message>
</context>
<context>
    <name>odo::StartActions</name>
    <message>
        <source>Registered to the floor mat: %1.</source>
        <translation>已按地垫配准：%1。</translation>
    </message>
    <message>
        <source>Their newest recordings do not show it: %1.</source>
        <translation>其最新录像中没有地垫：%1。</translation>
    </message>
</context>
<context>
    <name>odo::StartCard</name>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>&amp;Record or stop</source>
        <translation>录制或停止(&amp;R)</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>已录制时间</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Writing the last frames…</source>
        <translation>正在写入最后的画面…</translation>
    </message>
    <message>
        <source>F9 records, F9 stops</source>
        <translation>F9 开始录制，F9 停止</translation>
    </message>
    <message>
        <source>F9 records, F9 stops; %1</source>
        <translation>F9 开始录制，F9 停止；%1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>%1 秒后</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>F9 records, with the %1 s before; F9 stops</source>
        <translation>F9 开始录制，包括之前的 %1 s；F9 停止</translation>
    </message>
    <message>
        <source>F9 records, with the %1 s before; F9 stops; %2</source>
        <translation>F9 开始录制，包括之前的 %1 s；F9 停止；%2</translation>
    </message>
</context>
<context>
    <name>odo::StartPage</name>
    <message>
        <source>Cameras or clips</source>
        <translation>相机或视频</translation>
    </message>
    <message>
        <source>Import clips…</source>
        <translation>导入视频…</translation>
    </message>
    <message>
        <source>Connect cameras</source>
        <translation>连接相机</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Find the mat in the clips…</source>
        <translation>在视频中查找地垫…</translation>
    </message>
    <message>
        <source>Print a mat…</source>
        <translation>打印地垫…</translation>
    </message>
    <message>
        <source>Use other markers…</source>
        <translation>使用其他标记…</translation>
    </message>
    <message>
        <source>Lens (optional)</source>
        <translation>镜头（可选）</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>标定…</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Add a robot…</source>
        <translation>添加机器人…</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>第一次运行</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>跟踪…</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>From clips to a first result</source>
        <translation>从视频到第一个结果</translation>
    </message>
    <message>
        <source>Steps to a first result</source>
        <translation>得到第一个结果的步骤</translation>
    </message>
</context>
<context>
    <name>odo::StatusLine</name>
    <message>
        <source>No trial</source>
        <translation>无试验</translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>尚未跟踪</translation>
    </message>
    <message>
        <source>Analysis %1, Odograph %2</source>
        <translation>分析 %1，Odograph %2</translation>
    </message>
    <message>
        <source>Units of lengths, speeds and times; change them in the preferences</source>
        <translation>长度、速度和时间的单位；可在首选项中选择</translation>
    </message>
    <message>
        <source>No project is open</source>
        <translation>没有打开的项目</translation>
    </message>
    <message>
        <source>Read only: nothing can be changed</source>
        <translation>只读：不能作任何更改</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>所有更改均已保存</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>The school&apos;s hub</source>
        <translation>学校中心库</translation>
    </message>
    <message>
        <source>%1. Click for more about the school&apos;s hub</source>
        <translation>%1。单击查看学校中心库的详情</translation>
    </message>
</context>
<context>
    <name>odo::StepDialog</name>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; 上一步(&amp;B)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>下一步(&amp;N) &gt;</translation>
    </message>
    <message>
        <source>Discard %1?</source>
        <translation>放弃%1？</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Keep working</source>
        <translation>继续(&amp;K)</translation>
    </message>
</context>
<context>
    <name>odo::StepRow</name>
    <message>
        <source>Done. %1</source>
        <translation>已完成。%1</translation>
    </message>
</context>
<context>
    <name>odo::SynchroniseDialog</name>
    <message>
        <source>Synchronise %1</source>
        <translation>同步 %1</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 当前</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>同步(&amp;S)</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>同步</translation>
    </message>
    <message>
        <source>What was tracked in the trial is reanalysed. Choose Undo to return to the synchronisation that it has now.</source>
        <translation>试验中已跟踪的内容将重新分析。选择“撤销”可恢复当前的同步。</translation>
    </message>
    <message>
        <source>The sound of the videos is being read…</source>
        <translation>正在读取视频的声音…</translation>
    </message>
    <message>
        <source>Sound of the first view above, of the other one below. Drag it until both show the same clap at one time; the wheel zooms.</source>
        <translation>上方为第一个视角的声音，下方为另一个视角的声音。拖动它，直到两者在同一时刻显示同一次拍手；滚轮可缩放。</translation>
    </message>
    <message>
        <source>There is no sound in both views to compare.</source>
        <translation>两个视角并非都有可比较的声音。</translation>
    </message>
    <message>
        <source>Frames or sound</source>
        <translation>帧或声音</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>帧(&amp;F)</translation>
    </message>
    <message>
        <source>S&amp;ound</source>
        <translation>声音(&amp;O)</translation>
    </message>
</context>
<context>
    <name>odo::TargetDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Inner corners along the board</source>
        <translation>标定板长边方向的内角点数</translation>
    </message>
    <message>
        <source>Inner corners across the board</source>
        <translation>标定板短边方向的内角点数</translation>
    </message>
    <message>
        <source>Print targets</source>
        <translation>打印靶标</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>保存为 PDF(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>打印(&amp;P)…</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco 板</translation>
    </message>
    <message>
        <source>Floor markers: tags</source>
        <translation>地面标记：标签码</translation>
    </message>
    <message>
        <source>Floor markers: rings</source>
        <translation>地面标记：圆环</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>靶标(&amp;T)</translation>
    </message>
    <message>
        <source>Pape&amp;r</source>
        <translation>纸张(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Inner corners</source>
        <translation>内角点(&amp;I)</translation>
    </message>
    <message>
        <source>S&amp;quare</source>
        <translation>方格(&amp;Q)</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>尺寸(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>标号(&amp;L)</translation>
    </message>
    <message>
        <source>What is printed</source>
        <translation>打印内容</translation>
    </message>
    <message>
        <source>One sheet. Afterwards measure a square on the paper: printers often shrink by 2 to 4 %.</source>
        <translation>一张纸。打印后请测量纸上的一个方格：打印机常会缩小 2 至 4 %。</translation>
    </message>
    <message>
        <source>One sheet for each marker. A tag&apos;s number is the position of its label in the layout.</source>
        <translation>每个标记一张纸。标签码的编号即其标号在布局中的序号。</translation>
    </message>
    <message>
        <source>Save targets</source>
        <translation>保存靶标</translation>
    </message>
    <message>
        <source>targets.pdf</source>
        <translation>靶标.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>已保存为 %1。</translation>
    </message>
    <message>
        <source>Sent to the printer.</source>
        <translation>已发送至打印机。</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>Sheets in a row of the mat</source>
        <translation>地垫一行的纸张数</translation>
    </message>
    <message>
        <source>Rows of the mat</source>
        <translation>地垫的行数</translation>
    </message>
    <message>
        <source>Floor mat</source>
        <translation>地垫</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>纸张(&amp;H)</translation>
    </message>
    <message>
        <source>A plan and %1 sheets, to be taped together to a mat of %2 × %3 m. Its markers are known: nothing on the floor needs to be measured. The larger the mat, the more exact the floor.</source>
        <translation>一张图和 %1 张纸，粘成 %2 × %3 m 的地垫。其标记位置已知：无需在地面上测量任何东西。地垫越大，地面越精确。</translation>
    </message>
</context>
<context>
    <name>odo::TargetPreview</name>
    <message>
        <source>Preview of the sheets</source>
        <translation>页面预览</translation>
    </message>
</context>
<context>
    <name>odo::TaskCanvas</name>
    <message>
        <source>The task from above</source>
        <translation>任务俯视图</translation>
    </message>
    <message>
        <source>Drag a gate or one of its ends, a zone&apos;s edge or corner. Keys: Page Up and Down choose a gate or a zone, arrows move it (Shift: 100 mm, Ctrl: 1 mm), &lt; and &gt; turn it, + and − change its width</source>
        <translation>可拖动计时门或其一端，以及区域的边或角。按键：Page Up 和 Page Down 选择计时门或区域，方向键移动（Shift：100 mm，Ctrl：1 mm），&lt; 和 &gt; 旋转，+ 和 − 改变宽度</translation>
    </message>
    <message>
        <source>Zone %1, %2: %3 mm</source>
        <translation>区域 %1，%2：%3 mm</translation>
    </message>
    <message>
        <source>No gate or zone is chosen</source>
        <translation>未选择计时门或区域</translation>
    </message>
    <message>
        <source>Gate %1 from %2, %3 to %4, %5</source>
        <translation>计时门 %1，从 %2、%3 到 %4、%5</translation>
    </message>
</context>
<context>
    <name>odo::TaskEditor</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>&amp;Course</source>
        <translation>赛道(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>区域(&amp;Z)</translation>
    </message>
    <message>
        <source>Sco&amp;ring</source>
        <translation>评分(&amp;R)</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题所在</translation>
    </message>
    <message>
        <source>Import &amp;file…</source>
        <translation>导入文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Import gates, path, limits and zones from a task file (JSON)</source>
        <translation>从任务文件 (JSON) 读取计时门、路径、限值和区域</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Speed limi&amp;t</source>
        <translation>速度限值(&amp;T)</translation>
    </message>
    <message>
        <source>Acceleration l&amp;imit</source>
        <translation>加速度限值(&amp;I)</translation>
    </message>
    <message>
        <source>No robot in the task can exceed it: a measurement beyond it is a spike</source>
        <translation>该任务中任何机器人都达不到的数值：超过它的测量即为异常点</translation>
    </message>
    <message>
        <source>Task file</source>
        <translation>任务文件</translation>
    </message>
    <message>
        <source>Tasks (*.json *.yaml *.yml);;All files (*)</source>
        <translation>任务 (*.json *.yaml *.yml);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The task has no name.</source>
        <translation>任务没有名称。</translation>
    </message>
    <message>
        <source>A task with this name exists. Enter another name.</source>
        <translation>已有同名的任务。请另取名称。</translation>
    </message>
    <message>
        <source>A gate has no name.</source>
        <translation>有一个计时门没有名称。</translation>
    </message>
    <message>
        <source>A zone has no name.</source>
        <translation>有一个区域没有名称。</translation>
    </message>
</context>
<context>
    <name>odo::TasksDialog</name>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>编辑(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Copy…</source>
        <translation>复制(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>重命名(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>归档(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Reanalyse &amp;them</source>
        <translation>重新测量(&amp;M)</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>What depends on the task</source>
        <translation>依赖该任务的内容</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>已完成的操作</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>使用情况</translation>
    </message>
    <message>
        <source>Archived tasks no longer appear in lists; their trials, results and scores stay as they are</source>
        <translation>归档的任务不再供选择；其试验、结果和得分保持不变</translation>
    </message>
    <message numerus="yes">
        <source>Show %n archived task(s)</source>
        <translation>
            <numerusform>显示 %n 个已归档的任务</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n 次试验</numerusform>
        </translation>
    </message>
    <message>
        <source>earlier results</source>
        <translation>以前的结果</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1, archived</source>
        <translation>%1，已归档</translation>
    </message>
    <message>
        <source>No task yet. New creates one from a template. Its gates, path and scoring define the course and rate the runs.</source>
        <translation>尚无任务。“新建”按模板生成任务：其计时门、路径和评分规定要跑什么，以及跑得如何。</translation>
    </message>
    <message numerus="yes">
        <source>Earlier version of the course: %n result(s) still use it.</source>
        <translation>
            <numerusform>更改之前的赛道：按它测量的 %n 个结果仍保留它。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have this task.</source>
        <translation>
            <numerusform>%n 次试验属于此任务。</numerusform>
        </translation>
    </message>
    <message>
        <source>No trial has this task.</source>
        <translation>没有试验属于此任务。</translation>
    </message>
    <message numerus="yes">
        <source>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</source>
        <translation>
            <numerusform>其中 %n 次是按另一赛道测量的：通过计时门的时间和到路径的距离都是按那条赛道得出的，重新测量之前没有得分。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n metric(s).</source>
        <translation>
            <numerusform>按 %n 个指标评分。</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not scored.</source>
        <translation>不评分。</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>取消归档(&amp;A)</translation>
    </message>
    <message>
        <source>Trials have this task or were measured with it: it stays to document their metrics</source>
        <translation>有试验属于此任务，或按它测量：因此予以保留，以便说明其指标是按什么测量的</translation>
    </message>
    <message>
        <source>Deletes the task (Del); Ctrl+Z undoes this</source>
        <translation>删除任务 (Del)；可用 Ctrl+Z 撤回</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</source>
        <translation>
            <numerusform>按此赛道测量的 %n 个结果仍然有效：赛道更改后，原赛道作为以前的版本为它们保留。试验改用新赛道；其时间和得分在重新测量后更新。</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename task</source>
        <translation>重命名任务</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名称：</translation>
    </message>
</context>
<context>
    <name>odo::TeamDialog</name>
    <message>
        <source>Robots of the team</source>
        <translation>小组的机器人</translation>
    </message>
    <message>
        <source>Team %1</source>
        <translation>小组 %1</translation>
    </message>
    <message>
        <source>One name per line</source>
        <translation>每行一个名字</translation>
    </message>
    <message>
        <source>Members of the team, one per line</source>
        <translation>小组成员，每行一人</translation>
    </message>
    <message>
        <source>Record and Import propose these robots for the team&apos;s runs</source>
        <translation>“录制”和导入会为该小组的运行默认选用这些机器人</translation>
    </message>
    <message>
        <source>&amp;Members</source>
        <translation>成员(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message numerus="yes">
        <source>%n member(s)</source>
        <translation>
            <numerusform>%n 名成员</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message>
        <source>Teams</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>所有班级</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>任意任务</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>小组排名</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1（已归档）</translation>
    </message>
    <message>
        <source>No team has a result for this metric</source>
        <translation>此处没有小组有指标</translation>
    </message>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation>
            <numerusform>%n 个小组</numerusform>
        </translation>
    </message>
    <message>
        <source>choose a task to rank them: runs of different tasks cannot be compared</source>
        <translation>选择任务即可排名：不同任务的运行不能比较</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them</source>
        <translation>
            <numerusform>有 %n 次试验未计入：是按另一赛道测量的，请重新测量</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results</source>
        <translation>
            <numerusform>%n 次试验未计入：结果不可用</numerusform>
        </translation>
    </message>
    <message>
        <source>teams that do not differ significantly share a rank</source>
        <translation>差异不显著的小组名次相同</translation>
    </message>
</context>
<context>
    <name>odo::TemplateForm</name>
    <message>
        <source>Straight line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Figure eight</source>
        <translation>8 字形</translation>
    </message>
    <message>
        <source>Slalom</source>
        <translation>绕桩</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation>模板(&amp;M)</translation>
    </message>
    <message>
        <source>Centre &amp;x</source>
        <translation>中心 x(&amp;X)</translation>
    </message>
    <message>
        <source>Centre &amp;y</source>
        <translation>中心 y(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>长度(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Driving direction: 0° along X, 90° along Y</source>
        <translation>行驶方向：0° 沿 X，90° 沿 Y</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>方向(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Poles</source>
        <translation>桩数(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Gates&apos; width</source>
        <translation>计时门宽度(&amp;G)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diam&amp;eter</source>
        <translation>直径(&amp;E)</translation>
    </message>
    <message>
        <source>Start to finis&amp;h</source>
        <translation>起点到终点(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source>S&amp;wing, side to side</source>
        <translation>横向摆幅(&amp;W)</translation>
    </message>
</context>
<context>
    <name>odo::TestbedPage</name>
    <message>
        <source>From above</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>expected &amp;accuracy</source>
        <translation>预期精度(&amp;A)</translation>
    </message>
    <message>
        <source>No cameras yet</source>
        <translation>尚无相机</translation>
    </message>
    <message>
        <source>A testbed is a floor with markers and the cameras that watch it. Start with the lens calibration of the first camera, or with the marker positions.</source>
        <translation>试验场由带有标记的地面和观察它的相机组成。请从第一台相机的镜头或标记的位置开始。</translation>
    </message>
    <message>
        <source>Tas&amp;ks…</source>
        <translation>任务(&amp;K)…</translation>
    </message>
    <message>
        <source>Courses on this floor: gates, paths, limits, scoring</source>
        <translation>在此地面上行驶的内容：计时门、路径、限值、评分</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Details of the camera</source>
        <translation>相机的已知信息</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Marker layouts</source>
        <translation>标记布局</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>画面</translation>
    </message>
</context>
<context>
    <name>odo::TestbedTools</name>
    <message>
        <source>&amp;Calibrate camera…</source>
        <translation>标定相机(&amp;C)…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>标定…</translation>
    </message>
    <message>
        <source>Calibrate a camera with images of a board</source>
        <translation>由标定板的图片测量相机镜头</translation>
    </message>
    <message>
        <source>&amp;Register camera…</source>
        <translation>配准相机(&amp;R)…</translation>
    </message>
    <message>
        <source>Register…</source>
        <translation>配准…</translation>
    </message>
    <message>
        <source>Determine a camera&apos;s position from the floor markers</source>
        <translation>由地面标记得出相机的位置</translation>
    </message>
    <message>
        <source>Register via anot&amp;her camera…</source>
        <translation>通过另一相机配准(&amp;H)…</translation>
    </message>
    <message>
        <source>Via another…</source>
        <translation>通过另一相机…</translation>
    </message>
    <message>
        <source>Determine the position of a camera that sees no markers, from floor points that another camera also sees</source>
        <translation>相机看不到标记时，由另一相机也能看到的地面上的点得出其位置</translation>
    </message>
    <message>
        <source>Re&amp;gister all cameras (joint)…</source>
        <translation>联合配准所有相机(&amp;G)…</translation>
    </message>
    <message>
        <source>All cameras (joint)…</source>
        <translation>联合配准…</translation>
    </message>
    <message>
        <source>Fit all cameras of the selected layout jointly to make them agree, and find wrongly measured markers</source>
        <translation>将所选布局的各相机一并拟合，使它们一致，并找出量错的标记</translation>
    </message>
    <message>
        <source>&amp;Import lens calibration…</source>
        <translation>导入内参(&amp;I)…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>导入镜头…</translation>
    </message>
    <message>
        <source>Import a camera&apos;s lens calibration from a ROS or OpenCV YAML file</source>
        <translation>从 ROS 或 OpenCV 的 YAML 文件读取相机镜头</translation>
    </message>
    <message>
        <source>New marker &amp;layout…</source>
        <translation>新建标记布局(&amp;L)…</translation>
    </message>
    <message>
        <source>New layout…</source>
        <translation>新建布局…</translation>
    </message>
    <message>
        <source>Enter the marker positions, from scratch or based on the selected layout</source>
        <translation>指定标记的位置，从头开始或基于所选布局</translation>
    </message>
    <message>
        <source>Import &amp;marker layout…</source>
        <translation>导入标记布局(&amp;M)…</translation>
    </message>
    <message>
        <source>Import layout…</source>
        <translation>导入布局…</translation>
    </message>
    <message>
        <source>Import the marker positions from a table</source>
        <translation>从表格读取标记的位置</translation>
    </message>
    <message>
        <source>Print &amp;targets…</source>
        <translation>打印靶标(&amp;T)…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>打印…</translation>
    </message>
    <message>
        <source>Calibration boards and floor markers, to scale</source>
        <translation>镜头用的标定板和地面用的标记，按实际尺寸</translation>
    </message>
    <message>
        <source>Camera %1 is calibrated. %2</source>
        <translation>相机 %1 已标定。%2</translation>
    </message>
    <message>
        <source>Camera %1 is registered. %2</source>
        <translation>相机 %1 已配准。%2</translation>
    </message>
    <message>
        <source>Camera %1 is registered via camera %2. %3</source>
        <translation>相机 %1 已通过相机 %2 配准。%3</translation>
    </message>
    <message>
        <source>The cameras of layout %1 are registered jointly. %2</source>
        <translation>布局 %1 的各相机已联合配准。%2</translation>
    </message>
    <message>
        <source>Lens calibration of a camera</source>
        <translation>相机内参</translation>
    </message>
    <message>
        <source>Import lens calibration</source>
        <translation>导入内参</translation>
    </message>
    <message>
        <source>Camera:</source>
        <translation>相机：</translation>
    </message>
    <message>
        <source>Lens calibration of camera %1 imported from %2.</source>
        <translation>相机 %1 的镜头取自 %2。</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>标记的位置 (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>表格 (*.csv *.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Layout %1 has %2 markers.</source>
        <translation>布局 %1 有 %2 个标记。</translation>
    </message>
    <message>
        <source>The file holds several cameras. Which one is %1?</source>
        <translation>文件中有多台相机。%1 是哪一台？</translation>
    </message>
    <message>
        <source>Calibrations (*.yaml *.yml *.json *.toml *.ini *.xml *.txt);;All files (*)</source>
        <translation>标定文件 (*.yaml *.yml *.json *.toml *.ini *.xml *.txt);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>odo::TimeSlider</name>
    <message>
        <source>Time of the trial</source>
        <translation>试验的时间</translation>
    </message>
</context>
<context>
    <name>odo::Timeline</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暂停(&amp;P)</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>后退一帧(&amp;B)</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>前进一帧(&amp;F)</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>后退一秒</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>前进一秒</translation>
    </message>
    <message>
        <source>Play backwards, again: faster</source>
        <translation>倒放，再按加快</translation>
    </message>
    <message>
        <source>&amp;Stop; while held, the keys beside it step one frame</source>
        <translation>停止；按住时，两侧的键逐帧移动(&amp;S)</translation>
    </message>
    <message>
        <source>Play forwards, again: faster</source>
        <translation>正放，再按加快</translation>
    </message>
    <message>
        <source>To the first frame</source>
        <translation>到第一帧</translation>
    </message>
    <message>
        <source>To the last frame</source>
        <translation>到最后一帧</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>循环(&amp;L)</translation>
    </message>
    <message>
        <source>Selection beg&amp;ins here</source>
        <translation>所选部分从此处开始(&amp;I)</translation>
    </message>
    <message>
        <source>Selection &amp;ends here</source>
        <translation>所选部分到此处结束(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Clear the selection</source>
        <translation>清除所选部分(&amp;C)</translation>
    </message>
</context>
<context>
    <name>odo::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>To the first frame (Home)</source>
        <translation>到第一帧 (Home)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>播放（空格键）</translation>
    </message>
    <message>
        <source>To the last frame (End)</source>
        <translation>到最后一帧 (End)</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>没有帧</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>暂停（空格键）</translation>
    </message>
</context>
<context>
    <name>odo::TrackDialog</name>
    <message>
        <source>Robots to track</source>
        <translation>要跟踪的机器人</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>跟踪 %1</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data (best)</source>
        <translation>Kalman/RTS，噪声由数据估计（最佳）</translation>
    </message>
    <message>
        <source>Savitzky–Golay</source>
        <translation>Savitzky–Golay</translation>
    </message>
    <message>
        <source>Differences as in Tracker</source>
        <translation>与 Tracker 相同的差分</translation>
    </message>
    <message>
        <source>None: raw differences</source>
        <translation>无：原始差分</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>平滑(&amp;S)</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>跟踪</translation>
    </message>
</context>
<context>
    <name>odo::TrackPreview</name>
    <message>
        <source>%1: too long to be shown before the import</source>
        <translation>%1：太长，导入前无法显示</translation>
    </message>
    <message>
        <source>%1, track %2</source>
        <translation>%1，轨迹 %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2, %n lines in %3 s</source>
        <translation>
            <numerusform>%1：%2，%3 秒内 %n 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrackReadingForm</name>
    <message>
        <source>&amp;Unit of positions</source>
        <translation>位置单位(&amp;U)</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Unit of t&amp;imes</source>
        <translation>时间单位(&amp;I)</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>毫秒</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>微秒</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>纳秒</translation>
    </message>
    <message>
        <source>frame numbers</source>
        <translation>帧号</translation>
    </message>
    <message>
        <source>F&amp;loor axes</source>
        <translation>地面坐标轴(&amp;L)</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x 和 y</translation>
    </message>
    <message>
        <source>x and z</source>
        <translation>x 和 z</translation>
    </message>
    <message>
        <source>y and z</source>
        <translation>y 和 z</translation>
    </message>
    <message>
        <source>&amp;Decimal sign</source>
        <translation>小数点符号(&amp;D)</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>&amp;Frame rate</source>
        <translation>帧率(&amp;F)</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> 帧/秒</translation>
    </message>
    <message>
        <source>Of a file that numbers its frames</source>
        <translation>用于对帧编号的文件</translation>
    </message>
    <message>
        <source>Length of a &amp;pixel</source>
        <translation>像素长度(&amp;P)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> 毫米</translation>
    </message>
    <message>
        <source>On the floor, for positions in pixels</source>
        <translation>在地面上，用于以像素为单位的位置</translation>
    </message>
    <message>
        <source>Least &amp;confidence</source>
        <translation>最低置信度(&amp;C)</translation>
    </message>
    <message>
        <source>Positions with a lower likelihood count as not measured</source>
        <translation>似然度更低的位置视为未测量</translation>
    </message>
    <message>
        <source>Accurac&amp;y</source>
        <translation>准确度(&amp;Y)</translation>
    </message>
    <message>
        <source>Standard deviation of the positions, slow errors included; scatter alone does not show those</source>
        <translation>位置的标准差，包括慢变误差；仅凭离散程度无法看出慢变误差</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>来自文件</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>英尺</translation>
    </message>
    <message>
        <source>min</source>
        <translation>分钟</translation>
    </message>
    <message>
        <source>h</source>
        <translation>小时</translation>
    </message>
    <message>
        <source>days</source>
        <translation>天</translation>
    </message>
</context>
<context>
    <name>odo::TransferActions</name>
    <message>
        <source>&amp;Pack into one file…</source>
        <translation>打包为一个文件(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Unpack a packed project…</source>
        <translation>解包项目(&amp;U)…</translation>
    </message>
    <message>
        <source>Find &amp;lost videos…</source>
        <translation>查找丢失的视频(&amp;L)…</translation>
    </message>
    <message>
        <source>Pack the project with its videos</source>
        <translation>将项目连同视频打包</translation>
    </message>
    <message>
        <source>Packed projects (*%1)</source>
        <translation>打包的项目 (*%1)</translation>
    </message>
    <message>
        <source>Project packed into %1. To use it on another computer, choose &quot;Unpack a packed project&quot; there.</source>
        <translation>项目已打包为 %1。在别处可用“解包项目”将其解包。</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>注意：%1。</translation>
    </message>
    <message>
        <source>Unpack a packed project</source>
        <translation>解包项目</translation>
    </message>
    <message>
        <source>Packed projects (*%1);;All files (*)</source>
        <translation>打包的项目 (*%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the unpacked project</source>
        <translation>项目解包到哪里？</translation>
    </message>
    <message>
        <source>Choose the folder to search for the lost videos (with subfolders)</source>
        <translation>丢失的视频可能在哪个文件夹或其子文件夹中？</translation>
    </message>
    <message>
        <source>Found %1 of %2 lost videos by their content.</source>
        <translation>已按内容找到丢失的视频：%1，共 %2。</translation>
    </message>
    <message>
        <source>Find &amp;stray files…</source>
        <translation>查找无归属的文件(&amp;S)…</translation>
    </message>
    <message>
        <source>Every file in the media folder belongs to a trial, a lens calibration or a floor registration.</source>
        <translation>媒体文件夹中的每个文件都属于某次试验、镜头标定或地面配准。</translation>
    </message>
    <message>
        <source>Stray files</source>
        <translation>无归属的文件</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) in the media folder belong to no trial, lens calibration or floor registration.</source>
        <translation>
            <numerusform>媒体文件夹中有 %n 个文件不属于任何试验、镜头标定或地面配准。</numerusform>
        </translation>
    </message>
    <message>
        <source>You can add videos as trials. Removed files are gone for good.</source>
        <translation>视频可以成为单独的试验。移除的文件无法恢复。</translation>
    </message>
    <message>
        <source>&amp;Add videos as trials</source>
        <translation>将视频添加为试验(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove files</source>
        <translation>移除文件(&amp;R)</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) added. Their names begin with &quot;recovered&quot;.</source>
        <translation>
            <numerusform>已添加 %n 次试验，名称以“recovered”开头。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stray file(s) removed.</source>
        <translation>
            <numerusform>已移除 %n 个无归属的文件。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other file(s), listed last, stay: missing recordings, projects, and files that are neither videos nor images.</source>
        <translation>
            <numerusform>列在最后的其他 %n 个文件保留不动：丢失的录制、项目，以及既非视频也非图片的文件。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrendChart</name>
    <message>
        <source>Progress of the team</source>
        <translation>小组的进步</translation>
    </message>
    <message>
        <source>%1: %2 trials, progress: %3</source>
        <translation>%1：%2 次试验，进步情况：%3</translation>
    </message>
    <message>
        <source>No team is selected</source>
        <translation>未选择小组</translation>
    </message>
    <message>
        <source>Select a team to see its results over the term.</source>
        <translation>选择一个小组，即可查看其本学期的各次试验。</translation>
    </message>
</context>
<context>
    <name>odo::TrialActions</name>
    <message>
        <source>%1 in %2 of %3 frames, spikes flagged: %4</source>
        <translation>%1：%3 帧中的 %2 帧，标出异常点：%4</translation>
    </message>
    <message>
        <source>%1 is tracked: %2.</source>
        <translation>%1 已跟踪：%2。</translation>
    </message>
    <message>
        <source>%1 is imported.</source>
        <translation>%1 已导入。</translation>
    </message>
    <message>
        <source>&amp;Import trial from videos…</source>
        <translation>从视频导入试验(&amp;I)…</translation>
    </message>
    <message>
        <source>Import finished tra&amp;cks…</source>
        <translation>导入现成轨迹(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Track…</source>
        <translation>跟踪(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;video…</source>
        <translation>导出视频(&amp;V)…</translation>
    </message>
    <message>
        <source>Add &amp;robot…</source>
        <translation>添加机器人(&amp;R)…</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is not used. Choose Undo to use it.</source>
        <translation>不采用 %2 在 %1 的采样点。可用“撤销”撤回。</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is used. Choose Undo to reverse this.</source>
        <translation>采用 %2 在 %1 的采样点。可用“撤销”撤回。</translation>
    </message>
    <message>
        <source>Video of %1</source>
        <translation>%1 的视频</translation>
    </message>
    <message>
        <source>MP4 videos (*.mp4)</source>
        <translation>MP4 视频 (*.mp4)</translation>
    </message>
    <message>
        <source>Video of %1 saved as %2</source>
        <translation>%1 的视频已生成：%2</translation>
    </message>
    <message>
        <source>Robot %1 added.</source>
        <translation>机器人 %1 已添加。</translation>
    </message>
    <message>
        <source>%1 is synchronised.</source>
        <translation>%1 已同步。</translation>
    </message>
    <message>
        <source>S&amp;ynchronise…</source>
        <translation>同步(&amp;Y)…</translation>
    </message>
    <message>
        <source>The results of %1 are of its range, %2 to %3. Choose Undo to reverse this.</source>
        <translation>%1 的结果针对其区间 %2 到 %3。选择“撤销”可恢复。</translation>
    </message>
    <message>
        <source>The results of %1 are of the whole run.</source>
        <translation>%1 的结果针对整个行程。</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>编辑(&amp;D)…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) changed. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>已更改 %n 次试验。选择“撤销”可还原。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are not used. Choose Undo to use them.</source>
        <translation>
            <numerusform>%1 的 %n 个采样点未被采用。选择“撤销”可使用它们。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are used. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%1 的 %n 个采样点已被采用。选择“撤销”可还原。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrialChooser</name>
    <message>
        <source>&amp;Previous trial</source>
        <translation>上一次试验(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next trial</source>
        <translation>下一次试验(&amp;N)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
</context>
<context>
    <name>odo::TrialColumns</name>
    <message>
        <source>&amp;Columns</source>
        <translation>列(&amp;C)</translation>
    </message>
</context>
<context>
    <name>odo::TrialDetail</name>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视角</translation>
    </message>
    <message>
        <source>none: the track was imported</source>
        <translation>无：轨迹为导入</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>none: analysed with a different course than its task has now. Reanalyse the trial</source>
        <translation>无：测量所按的赛道与任务现有的不同；请重新测量</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>none yet: open it and choose Track</source>
        <translation>尚无：请打开它并选择“跟踪”</translation>
    </message>
    <message>
        <source>Open in Review</source>
        <translation>在“回放”中打开</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>试验概况</translation>
    </message>
    <message>
        <source>Notes of the trial</source>
        <translation>试验备注</translation>
    </message>
    <message>
        <source>What did you change on the robot? What do you want to remember?</source>
        <translation>机器人作了哪些改动？有什么需要记住？</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>备注(&amp;N)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>尚无试验</translation>
    </message>
    <message>
        <source>No trial selected</source>
        <translation>未选择试验</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
</context>
<context>
    <name>odo::TrialFilterBar</name>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>任意班级</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Any team</source>
        <translation>任意小组</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>任意任务</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Any robot</source>
        <translation>任意机器人</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Any date</source>
        <translation>任意日期</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今天</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>最近 7 天</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>最近 30 天</translation>
    </message>
    <message>
        <source>Last 12 months</source>
        <translation>最近 12 个月</translation>
    </message>
    <message>
        <source>Between…</source>
        <translation>指定范围…</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>归档</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>回收站</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>星标</translation>
    </message>
    <message>
        <source>Only starred trials</source>
        <translation>仅加星标的试验</translation>
    </message>
    <message>
        <source>Show only starred trials</source>
        <translation>仅显示加星标的试验</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>Only trials with doubtful or bad results</source>
        <translation>仅显示结果存疑或不可用的试验</translation>
    </message>
    <message>
        <source>Show only trials with doubtful or bad results</source>
        <translation>仅显示结果存疑或不可用的试验</translation>
    </message>
</context>
<context>
    <name>odo::TrialModel</name>
    <message>
        <source>not tracked</source>
        <translation>未跟踪</translation>
    </message>
    <message>
        <source>reanalyse</source>
        <translation>需重新测量</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>已加星标</translation>
    </message>
    <message>
        <source>not starred</source>
        <translation>未加星标</translation>
    </message>
    <message>
        <source>Tags, separated by commas: double-click or F2 changes them</source>
        <translation>标签，以逗号分隔：双击或按 F2 修改</translation>
    </message>
    <message>
        <source>Star (Ctrl+D)</source>
        <translation>星标 (Ctrl+D)</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星标</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>小组</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>班级</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>用时</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
</context>
<context>
    <name>odo::TrialPresentation</name>
    <message>
        <source>Not tracked yet</source>
        <translation>尚未跟踪</translation>
    </message>
</context>
<context>
    <name>odo::TrialTable</name>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
</context>
<context>
    <name>odo::TriggerBox</name>
    <message>
        <source>at once</source>
        <translation>立即</translation>
    </message>
    <message>
        <source>after a countdown of %1 s</source>
        <translation>%1 s 倒计时后</translation>
    </message>
    <message>
        <source>when the robot passes the start</source>
        <translation>机器人通过起点时</translation>
    </message>
    <message>
        <source>when something moves</source>
        <translation>有物体移动时</translation>
    </message>
    <message>
        <source>with the button</source>
        <translation>按按钮时</translation>
    </message>
    <message>
        <source>at the finish</source>
        <translation>到达终点时</translation>
    </message>
    <message>
        <source>when nothing moves any more</source>
        <translation>不再有物体移动时</translation>
    </message>
    <message>
        <source>after a time</source>
        <translation>经过一段时间后</translation>
    </message>
    <message>
        <source>when a robot enters “%1”</source>
        <translation>机器人进入“%1”时</translation>
    </message>
    <message>
        <source>when a robot leaves “%1”</source>
        <translation>机器人离开“%1”时</translation>
    </message>
    <message>
        <source>Waiting for the robot at “%1”. The recording will include the %2 s before it</source>
        <translation>正在等待机器人到达“%1”。录像从此前 %2 s 开始</translation>
    </message>
    <message>
        <source>Waiting until a robot enters “%1”. The recording will include the %2 s before</source>
        <translation>正在等待机器人进入“%1”。录像从此前 %2 s 开始</translation>
    </message>
    <message>
        <source>Waiting until a robot leaves “%1”. The recording will include the %2 s before</source>
        <translation>正在等待机器人离开“%1”。录像从此前 %2 s 开始</translation>
    </message>
    <message>
        <source>Waiting until something moves on the floor. The recording will include the %1 s before</source>
        <translation>正在等待地面上有物体移动。录像从此前 %1 s 开始</translation>
    </message>
    <message>
        <source>Ends at the finish, or with F9</source>
        <translation>到达终点或按 F9 时结束</translation>
    </message>
    <message>
        <source>Ends when a robot enters “%1”, or with F9</source>
        <translation>机器人进入“%1”或按 F9 时结束</translation>
    </message>
    <message>
        <source>Ends when a robot leaves “%1”, or with F9</source>
        <translation>机器人离开“%1”或按 F9 时结束</translation>
    </message>
    <message>
        <source>Ends when nothing has moved for %1 s, or with F9</source>
        <translation>%1 s 内没有移动或按 F9 时结束</translation>
    </message>
    <message>
        <source>Ends %1 s after the start, or with F9</source>
        <translation>开始后 %1 s 或按 F9 时结束</translation>
    </message>
</context>
<context>
    <name>odo::UndoActions</name>
    <message>
        <source>Undone: %1.</source>
        <translation>已撤销：%1。</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>已重做：%1。</translation>
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
        <source>&amp;Undo: %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做(&amp;R)：%1</translation>
    </message>
</context>
<context>
    <name>odo::VariableTable</name>
    <message>
        <source>several</source>
        <translation>多个值</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Variables of your own</source>
        <translation>自定义变量</translation>
    </message>
    <message>
        <source>What you want to compare runs by: surface, battery, attempt. Text or a number.</source>
        <translation>用来比较各次行程的内容：地面、电池、第几次尝试。文字或数字。</translation>
    </message>
</context>
<context>
    <name>odo::VideoDialog</name>
    <message>
        <source>Real time</source>
        <translation>按实际速度</translation>
    </message>
    <message>
        <source>Slow motion, 1/2</source>
        <translation>慢动作，1/2</translation>
    </message>
    <message>
        <source>Slow motion, 1/4</source>
        <translation>慢动作，1/4</translation>
    </message>
    <message>
        <source>Slow motion, 1/10</source>
        <translation>慢动作，1/10</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>One video with all camera views, the map and the speed, to show or send. It plays without Odograph.</source>
        <translation>一段视频，包含所有相机的画面、地图和速度，可用于展示或发送：收到者无需 Odograph。</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>速度(&amp;S)</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>尺寸(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择位置…</translation>
    </message>
</context>
<context>
    <name>odo::ViewActions</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>重置窗口布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation>跟随系统配色(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>深色(&amp;R)</translation>
    </message>
</context>
<context>
    <name>odo::ViewSteps</name>
    <message>
        <source>Same start time</source>
        <translation>同时开始</translation>
    </message>
    <message>
        <source>By hand: time offset</source>
        <translation>手动：晚开始</translation>
    </message>
    <message>
        <source>How to synchronise view %1 with the first</source>
        <translation>视角 %1 如何与视角 1 同步</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time offset of view %1</source>
        <translation>视角 %1 晚开始多少</translation>
    </message>
    <message>
        <source>Negative: it started before the first view</source>
        <translation>小于零：比视角 1 早开始</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>视角 %1</translation>
    </message>
    <message>
        <source>Automatic: motion, flash or sound</source>
        <translation>自动：运动、闪光或声音</translation>
    </message>
    <message>
        <source>By the motion</source>
        <translation>由运动</translation>
    </message>
    <message>
        <source>By a flash of light</source>
        <translation>由闪光</translation>
    </message>
    <message>
        <source>By sound</source>
        <translation>由声音</translation>
    </message>
    <message>
        <source>A flash: switch the room lights on and off once while all cameras record. Sound: clap twice near the middle of the floor</source>
        <translation>闪光：在所有相机录制时开关一次室内灯。声音：在地面中央附近拍两次手</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>保持不变</translation>
    </message>
</context>
<context>
    <name>odo::WarningBar</name>
    <message>
        <source>Problem</source>
        <translation>问题所在</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>解决</translation>
    </message>
</context>
<context>
    <name>odo::WelcomePage</name>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.</source>
        <translation>由普通相机的视频测量移动机器人的运动。</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近的项目</translation>
    </message>
    <message>
        <source>no longer found</source>
        <translation>已找不到</translation>
    </message>
</context>
<context>
    <name>odo::WindowMessages</name>
    <message>
        <source>&amp;Messages</source>
        <translation>消息(&amp;M)</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n 条消息</numerusform>
        </translation>
    </message>
    <message>
        <source>No messages.</source>
        <translation>没有消息。</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>已取消，未作任何更改。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>在文件夹中显示</translation>
    </message>
</context>
<context>
    <name>odo::Workspace</name>
    <message>
        <source>%1: %2. It is read-only here; to change it, close it there and reopen it here.</source>
        <translation>%1：%2。在此只能查看；如需更改，请先在那边关闭，再在此重新打开。</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as “%1”.</source>
        <translation>备份已恢复。损坏的文件保留为“%1”。</translation>
    </message>
    <message>
        <source>“%1” was written before you cancelled. It was not opened.</source>
        <translation>取消之前“%1”已经写入。没有打开它。</translation>
    </message>
    <message>
        <source>The backup was restored. What the project was before is kept as “%1”.</source>
        <translation>备份已恢复。项目之前的状态保留为“%1”。</translation>
    </message>
</context>
<context>
    <name>odo::ZoneTable</name>
    <message>
        <source>stay inside</source>
        <translation>应留在内</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>禁止进入</translation>
    </message>
    <message>
        <source>Remo&amp;ve zone</source>
        <translation>移除区域(&amp;V)</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>Corners: x y; x y; … in mm</source>
        <translation>角：x y; x y; … 单位 mm</translation>
    </message>
    <message>
        <source>Zones of the floor</source>
        <translation>地面上的区域</translation>
    </message>
    <message>
        <source>Add zone to sta&amp;y in</source>
        <translation>添加应留区域(&amp;S)</translation>
    </message>
    <message>
        <source>Add zone to &amp;keep out of</source>
        <translation>添加禁入区域(&amp;K)</translation>
    </message>
    <message>
        <source>The robot&apos;s reference point must stay in a zone or keep out of it. Each zone counts separately; you can score how often, how long and how far a robot broke it. Drag corners and edges on the map.</source>
        <translation>机器人中心必须留在区域内，或不得进入区域。各区域单独判定；越界的次数、时间和距离都可计分。可在地图上拖动角和边。</translation>
    </message>
    <message>
        <source>Rule of the zone</source>
        <translation>区域的规则</translation>
    </message>
    <message>
        <source>Zone %1</source>
        <translation>区域 %1</translation>
    </message>
</context>
<context>
    <name>project.acceptance_reason</name>
    <message>
        <source>reason for accepting the results</source>
        <translation>接受结果的理由</translation>
    </message>
</context>
<context>
    <name>project.add_another_layout</name>
    <message>
        <source>add another layout for other markers</source>
        <translation>其他标记请另加布局</translation>
    </message>
</context>
<context>
    <name>project.add_one_first</name>
    <message>
        <source>add one first</source>
        <translation>请先添加</translation>
    </message>
</context>
<context>
    <name>project.add_what_it_refers_to</name>
    <message>
        <source>add what it refers to first</source>
        <translation>请先添加所引用的内容</translation>
    </message>
</context>
<context>
    <name>project.adopt_or_remove</name>
    <message>
        <source>make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers both under &apos;Find stray files…&apos;</source>
        <translation>请在“查找无归属的文件…”中将其收为一次试验或移除</translation>
    </message>
</context>
<context>
    <name>project.an_analysis</name>
    <message>
        <source>analysis of a trial</source>
        <translation>试验的分析</translation>
    </message>
</context>
<context>
    <name>project.analyse_again</name>
    <message>
        <source>reanalyse the trial</source>
        <translation>请重新分析该试验</translation>
    </message>
</context>
<context>
    <name>project.analysis_number</name>
    <message>
        <source>analysis %1</source>
        <translation>分析 %1</translation>
    </message>
</context>
<context>
    <name>project.analysis_of_project</name>
    <message>
        <source>analysis %1 of the project</source>
        <translation>项目的分析 %1</translation>
    </message>
</context>
<context>
    <name>project.another_program_writes</name>
    <message>
        <source>another program is writing to it</source>
        <translation>另一程序正在写入</translation>
    </message>
</context>
<context>
    <name>project.area_few_corners</name>
    <message>
        <source>an area needs at least %1 corners</source>
        <translation>区域至少需要 %1 个角点</translation>
    </message>
</context>
<context>
    <name>project.area_many_corners</name>
    <message>
        <source>an area has at most %1 corners</source>
        <translation>区域最多有 %1 个角点</translation>
    </message>
</context>
<context>
    <name>project.area_off_frame</name>
    <message>
        <source>a position is not in the frame</source>
        <translation>某个位置不在画面内</translation>
    </message>
</context>
<context>
    <name>project.being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>正在录制</translation>
    </message>
</context>
<context>
    <name>project.calibration_of_project</name>
    <message>
        <source>calibration %1 of the project</source>
        <translation>项目的标定 %1</translation>
    </message>
</context>
<context>
    <name>project.calibration_origin</name>
    <message>
        <source>origin of a calibration</source>
        <translation>标定的来源</translation>
    </message>
</context>
<context>
    <name>project.calibration_picture_of</name>
    <message>
        <source>the calibration image &apos;%1&apos; of camera &apos;%2&apos;</source>
        <translation>相机“%2”的标定图片“%1”</translation>
    </message>
</context>
<context>
    <name>project.camera_address</name>
    <message>
        <source>address of a camera</source>
        <translation>相机地址</translation>
    </message>
</context>
<context>
    <name>project.cannot_be_written_to</name>
    <message>
        <source>it cannot be written to</source>
        <translation>无法写入</translation>
    </message>
</context>
<context>
    <name>project.cannot_hold</name>
    <message>
        <source>cannot hold %1</source>
        <translation>无法锁定 %1</translation>
    </message>
</context>
<context>
    <name>project.cannot_record_into</name>
    <message>
        <source>cannot record into %1</source>
        <translation>无法录制到 %1</translation>
    </message>
</context>
<context>
    <name>project.cannot_remove</name>
    <message>
        <source>cannot remove &apos;%1&apos;</source>
        <translation>无法移除“%1”</translation>
    </message>
</context>
<context>
    <name>project.change_list</name>
    <message>
        <source>the list of changes</source>
        <translation>更改记录</translation>
    </message>
</context>
<context>
    <name>project.change_not_noted</name>
    <message>
        <source>the change could not be logged (%1)</source>
        <translation>无法记录更改（%1）</translation>
    </message>
</context>
<context>
    <name>project.change_something_first</name>
    <message>
        <source>change something first</source>
        <translation>请先做更改</translation>
    </message>
</context>
<context>
    <name>project.change_words</name>
    <message>
        <source>description of a change</source>
        <translation>更改的说明</translation>
    </message>
</context>
<context>
    <name>project.changed_since</name>
    <message>
        <source>something it concerns has been changed or used since</source>
        <translation>其对象此后已被更改或使用</translation>
    </message>
</context>
<context>
    <name>project.check</name>
    <message>
        <source>check of the project</source>
        <translation>项目检查</translation>
    </message>
</context>
<context>
    <name>project.check_disk</name>
    <message>
        <source>check the disk</source>
        <translation>请检查磁盘</translation>
    </message>
</context>
<context>
    <name>project.check_disk_and_retry</name>
    <message>
        <source>check the disk and try again</source>
        <translation>请检查磁盘后重试</translation>
    </message>
</context>
<context>
    <name>project.check_folder_is_there</name>
    <message>
        <source>check that the folder exists and that you may read it</source>
        <translation>请检查文件夹是否存在且可读</translation>
    </message>
</context>
<context>
    <name>project.check_its_input</name>
    <message>
        <source>check the input that it was computed from</source>
        <translation>请检查计算它所用的输入</translation>
    </message>
</context>
<context>
    <name>project.check_name_or_make</name>
    <message>
        <source>check the name, or create a new project</source>
        <translation>请检查名称，或新建项目</translation>
    </message>
</context>
<context>
    <name>project.check_project_folder</name>
    <message>
        <source>check the free space and the permissions of the project&apos;s folder</source>
        <translation>请检查项目文件夹的可用空间和权限</translation>
    </message>
</context>
<context>
    <name>project.check_rights</name>
    <message>
        <source>check the permissions of the project&apos;s folder</source>
        <translation>请检查项目文件夹的权限</translation>
    </message>
</context>
<context>
    <name>project.checking</name>
    <message>
        <source>checking %1</source>
        <translation>正在检查 %1</translation>
    </message>
</context>
<context>
    <name>project.checking_database</name>
    <message>
        <source>checking the database</source>
        <translation>正在检查数据库</translation>
    </message>
</context>
<context>
    <name>project.choose_from_list</name>
    <message>
        <source>choose one from the list</source>
        <translation>请从列表中选择一个</translation>
    </message>
</context>
<context>
    <name>project.choose_its_own</name>
    <message>
        <source>choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy</source>
        <translation>请选择它自己的一个版本（“以前的标定…”），或从备份恢复项目</translation>
    </message>
</context>
<context>
    <name>project.choose_our_file</name>
    <message>
        <source>choose a file that Odograph has written</source>
        <translation>请选择 Odograph 写出的文件</translation>
    </message>
</context>
<context>
    <name>project.choose_writable_folder</name>
    <message>
        <source>choose a folder that can be written to and has free space</source>
        <translation>请选择可写且有空间的文件夹</translation>
    </message>
</context>
<context>
    <name>project.class_has_team</name>
    <message>
        <source>a team belongs to it</source>
        <translation>有一个小组属于它</translation>
    </message>
</context>
<context>
    <name>project.class_has_teams</name>
    <message>
        <source>%1 teams belong to it</source>
        <translation>有 %1 个小组属于它</translation>
    </message>
</context>
<context>
    <name>project.close_it_there</name>
    <message>
        <source>close it there first</source>
        <translation>请先在那里关闭</translation>
    </message>
</context>
<context>
    <name>project.close_other_program</name>
    <message>
        <source>close the other program and try again</source>
        <translation>请关闭另一程序后重试</translation>
    </message>
</context>
<context>
    <name>project.complete_recording</name>
    <message>
        <source>to complete it, open the project for writing: odograph record P.odo --recover</source>
        <translation>请以可写方式打开项目，录像即会补全</translation>
    </message>
</context>
<context>
    <name>project.copy</name>
    <message>
        <source>copy &apos;%1&apos;</source>
        <translation>副本“%1”</translation>
    </message>
</context>
<context>
    <name>project.copy_again</name>
    <message>
        <source>copy it again from its source, or restore a backup copy</source>
        <translation>请从来源重新复制，或恢复备份</translation>
    </message>
</context>
<context>
    <name>project.copy_differs</name>
    <message>
        <source>the copy differs from what was written</source>
        <translation>副本与写入内容不同</translation>
    </message>
</context>
<context>
    <name>project.copy_file_beside</name>
    <message>
        <source>copy the file to the project&apos;s folder</source>
        <translation>请把文件复制到项目旁边</translation>
    </message>
</context>
<context>
    <name>project.copy_of_project</name>
    <message>
        <source>copy of project &apos;%1&apos;</source>
        <translation>项目“%1”的副本</translation>
    </message>
</context>
<context>
    <name>project.copy_sound_backup</name>
    <message>
        <source>copy &apos;%1&apos;, which is intact, to a new name, open that copy and keep the damaged file</source>
        <translation>请把完好的“%1”复制为新名称并打开该副本，同时保留损坏的文件</translation>
    </message>
</context>
<context>
    <name>project.copy_to_another_disk</name>
    <message>
        <source>check the disk, and copy the project to another one</source>
        <translation>请检查磁盘，并把项目复制到另一磁盘</translation>
    </message>
</context>
<context>
    <name>project.copy_to_writable_folder</name>
    <message>
        <source>copy it to a folder that you may write to, and open the copy</source>
        <translation>请复制到可写的文件夹并打开副本</translation>
    </message>
</context>
<context>
    <name>project.copy_with_side_files</name>
    <message>
        <source>copy it with the files beside it to a folder that you may write to, and open the copy</source>
        <translation>请将它与旁边的文件一起复制到您可写入的文件夹，然后打开副本</translation>
    </message>
</context>
<context>
    <name>project.copy_with_videos</name>
    <message>
        <source>copy it with its videos to a folder that you may write to, and open the copy</source>
        <translation>请连同视频复制到可写的文件夹并打开副本</translation>
    </message>
</context>
<context>
    <name>project.corners_of</name>
    <message>
        <source>corners of &apos;%1&apos;</source>
        <translation>“%1”的角点</translation>
    </message>
</context>
<context>
    <name>project.covariance_not_6_by_6</name>
    <message>
        <source>its stored covariance is not a 6 by 6 matrix</source>
        <translation>存储的协方差不是 6×6 矩阵</translation>
    </message>
</context>
<context>
    <name>project.database_refused</name>
    <message>
        <source>the database reported an error</source>
        <translation>数据库拒绝了</translation>
    </message>
</context>
<context>
    <name>project.database_refused_because</name>
    <message>
        <source>the database reported an error (%1)</source>
        <translation>数据库拒绝了（%1）</translation>
    </message>
</context>
<context>
    <name>project.delete_its_trials</name>
    <message>
        <source>delete its trials permanently first, or archive its class</source>
        <translation>请先永久删除它们，或归档其班级</translation>
    </message>
</context>
<context>
    <name>project.disk_error</name>
    <message>
        <source>the disk reported an error, the change was not saved</source>
        <translation>磁盘报告错误，更改未保存</translation>
    </message>
</context>
<context>
    <name>project.disk_full</name>
    <message>
        <source>the disk is full, the change was not saved</source>
        <translation>磁盘已满，更改未保存</translation>
    </message>
</context>
<context>
    <name>project.disk_read_only</name>
    <message>
        <source>the disk has become read-only, the change was not saved</source>
        <translation>磁盘已变为只读，更改未保存</translation>
    </message>
</context>
<context>
    <name>project.disk_unreadable</name>
    <message>
        <source>the disk could not be read; nothing was changed</source>
        <translation>无法读取磁盘，未作任何更改</translation>
    </message>
</context>
<context>
    <name>project.duration_of_recordings_differs</name>
    <message>
        <source>its duration is stored as %1, its recordings last %2</source>
        <translation>存储的时长为 %1，而其录像长 %2</translation>
    </message>
</context>
<context>
    <name>project.duration_of_tracks_differs</name>
    <message>
        <source>its duration is stored as %1, its imported tracks last %2</source>
        <translation>存储的时长为 %1，而其导入的轨迹长 %2</translation>
    </message>
</context>
<context>
    <name>project.earlier_step_failed</name>
    <message>
        <source>an earlier step of this change failed</source>
        <translation>此更改的前一步失败</translation>
    </message>
</context>
<context>
    <name>project.end_recording_first</name>
    <message>
        <source>end its recording first</source>
        <translation>请先结束录制</translation>
    </message>
</context>
<context>
    <name>project.figures_without_task</name>
    <message>
        <source>without it, their metrics would not show which rules applied</source>
        <translation>否则指标将不再说明其测量依据</translation>
    </message>
</context>
<context>
    <name>project.file_changed</name>
    <message>
        <source>%1 has changed since it was created</source>
        <translation>%1 生成后被更改过</translation>
    </message>
</context>
<context>
    <name>project.file_cut_off</name>
    <message>
        <source>the file is incomplete</source>
        <translation>文件不完整</translation>
    </message>
</context>
<context>
    <name>project.file_damaged</name>
    <message>
        <source>the file is damaged</source>
        <translation>文件已损坏</translation>
    </message>
</context>
<context>
    <name>project.file_lost</name>
    <message>
        <source>its file was deleted, renamed or replaced while it was open; nothing was stored</source>
        <translation>打开期间其文件被删除、重命名或替换；未保存任何内容</translation>
    </message>
</context>
<context>
    <name>project.file_there_already</name>
    <message>
        <source>a file of that name already exists</source>
        <translation>已有同名文件</translation>
    </message>
</context>
<context>
    <name>project.file_unused</name>
    <message>
        <source>no trial, lens calibration or floor registration uses this file</source>
        <translation>没有试验、镜头标定或地面配准使用此文件</translation>
    </message>
</context>
<context>
    <name>project.find_or_put_back</name>
    <message>
        <source>take it from there with odograph check P.odo --find FOLDER or Find lost videos… in the window, or move it back to its folder</source>
        <translation>请用“查找丢失的视频…”从那里取用，或将其放回原处</translation>
    </message>
</context>
<context>
    <name>project.folder_read_only</name>
    <message>
        <source>its folder cannot be written to</source>
        <translation>其文件夹无法写入</translation>
    </message>
</context>
<context>
    <name>project.foreign_log</name>
    <message>
        <source>the log beside it (&apos;%1&apos;) belongs to another file or to another state of this one</source>
        <translation>旁边的日志（“%1”）属于另一个文件，或属于此文件的另一个状态</translation>
    </message>
</context>
<context>
    <name>project.format_1</name>
    <message>
        <source>the first schema</source>
        <translation>最初的数据库结构</translation>
    </message>
</context>
<context>
    <name>project.format_10</name>
    <message>
        <source>for a school year: stars, tags, archive, bin, pseudonyms, scoring and the list of changes</source>
        <translation>一个学年所需的内容：星标、标签、归档、回收站、化名、评分和更改记录</translation>
    </message>
</context>
<context>
    <name>project.format_11</name>
    <message>
        <source>members and robots of teams, zones and the archive of tasks, and imported tracks</source>
        <translation>小组的成员和机器人、区域、任务的归档，以及导入的轨迹</translation>
    </message>
</context>
<context>
    <name>project.format_12</name>
    <message>
        <source>digests of analyses, and long series in chunks</source>
        <translation>分析的校验摘要，以及分块存储的长序列</translation>
    </message>
</context>
<context>
    <name>project.format_13</name>
    <message>
        <source>reference points of robots</source>
        <translation>机器人的测量点</translation>
    </message>
</context>
<context>
    <name>project.format_14</name>
    <message>
        <source>periods with ambiguous robot names</source>
        <translation>外观相同的机器人无法区分的时段</translation>
    </message>
</context>
<context>
    <name>project.format_15</name>
    <message>
        <source>robots marked by hand in a frame</source>
        <translation>由人在画面中指出的机器人</translation>
    </message>
</context>
<context>
    <name>project.format_16</name>
    <message>
        <source>messages as codes with their arguments</source>
        <translation>以代码及其参数存储的语句</translation>
    </message>
</context>
<context>
    <name>project.format_17</name>
    <message>
        <source>verdicts, and their acceptance</source>
        <translation>判定及其接受</translation>
    </message>
</context>
<context>
    <name>project.format_18</name>
    <message>
        <source>how the frames of recordings are turned</source>
        <translation>录像帧的旋转方式</translation>
    </message>
</context>
<context>
    <name>project.format_19</name>
    <message>
        <source>ranges and variables of trials</source>
        <translation>试验的区间和变量</translation>
    </message>
</context>
<context>
    <name>project.format_2</name>
    <message>
        <source>manual overrides of samples</source>
        <translation>由人改判的采样点</translation>
    </message>
</context>
<context>
    <name>project.format_20</name>
    <message>
        <source>which observations are in force</source>
        <translation>哪些观测有效</translation>
    </message>
</context>
<context>
    <name>project.format_21</name>
    <message>
        <source>guidance of the tracker, and the school&apos;s hub</source>
        <translation>对跟踪的指定，以及学校中心</translation>
    </message>
</context>
<context>
    <name>project.format_3</name>
    <message>
        <source>clock rates of the cameras</source>
        <translation>相机时钟的速率</translation>
    </message>
</context>
<context>
    <name>project.format_4</name>
    <message>
        <source>tasks with gates, a reference path and limits</source>
        <translation>含计时门、参考路径和限值的任务</translation>
    </message>
</context>
<context>
    <name>project.format_5</name>
    <message>
        <source>synchronisation of each view</source>
        <translation>各视角的同步方式</translation>
    </message>
</context>
<context>
    <name>project.format_6</name>
    <message>
        <source>calibrations with their boards, corners and images</source>
        <translation>标定及其标定板、角点和图片</translation>
    </message>
</context>
<context>
    <name>project.format_7</name>
    <message>
        <source>chosen revisions and registration checks</source>
        <translation>所选的版本，以及配准的检查</translation>
    </message>
</context>
<context>
    <name>project.format_8</name>
    <message>
        <source>trials during recording, and the raw times of their frames</source>
        <translation>录制中的试验，及其画面的原始时间</translation>
    </message>
</context>
<context>
    <name>project.format_9</name>
    <message>
        <source>images of registrations</source>
        <translation>配准的画面</translation>
    </message>
</context>
<context>
    <name>project.frame_times_of</name>
    <message>
        <source>frame times of &apos;%1&apos;</source>
        <translation>“%1”的帧时间</translation>
    </message>
</context>
<context>
    <name>project.frames_in_wrong_order</name>
    <message>
        <source>it ends before it starts</source>
        <translation>结束早于开始</translation>
    </message>
</context>
<context>
    <name>project.give_a_height</name>
    <message>
        <source>enter a height, or have it estimated</source>
        <translation>请给出高度，或让程序估计</translation>
    </message>
</context>
<context>
    <name>project.give_a_name</name>
    <message>
        <source>give the %1 a name</source>
        <translation>请给%1命名</translation>
    </message>
</context>
<context>
    <name>project.give_a_title</name>
    <message>
        <source>give the project a title</source>
        <translation>请给项目起个标题</translation>
    </message>
</context>
<context>
    <name>project.give_another_task</name>
    <message>
        <source>give them another task first</source>
        <translation>请先给它们另一任务</translation>
    </message>
</context>
<context>
    <name>project.give_fewer_corners</name>
    <message>
        <source>give fewer corners, or two areas</source>
        <translation>请减少角点，或分成两个区域</translation>
    </message>
</context>
<context>
    <name>project.give_file_a_name</name>
    <message>
        <source>give the file a name</source>
        <translation>请给文件命名</translation>
    </message>
</context>
<context>
    <name>project.give_frame_pixels</name>
    <message>
        <source>give positions in pixels of the frame</source>
        <translation>请以画面像素给出位置</translation>
    </message>
</context>
<context>
    <name>project.give_frames_in_order</name>
    <message>
        <source>give the start before the end</source>
        <translation>请让开始早于结束</translation>
    </message>
</context>
<context>
    <name>project.give_members</name>
    <message>
        <source>give the names of the people in the team</source>
        <translation>请给出组内人员的姓名</translation>
    </message>
</context>
<context>
    <name>project.give_more_corners</name>
    <message>
        <source>give more corners</source>
        <translation>请给出更多角点</translation>
    </message>
</context>
<context>
    <name>project.give_robot_size</name>
    <message>
        <source>give length and width in millimetres, like 260x190</source>
        <translation>请以毫米给出长和宽，如 260x190</translation>
    </message>
</context>
<context>
    <name>project.give_sigma_px</name>
    <message>
        <source>give σ in pixels</source>
        <translation>请以像素给出 σ</translation>
    </message>
</context>
<context>
    <name>project.give_whole_truth</name>
    <message>
        <source>give position, velocity and acceleration for each time</source>
        <translation>请为每个时间给出位置、速度和加速度</translation>
    </message>
</context>
<context>
    <name>project.guidance</name>
    <message>
        <source>guidance of the tracker</source>
        <translation>跟踪引导</translation>
    </message>
</context>
<context>
    <name>project.guidance_is_gone</name>
    <message>
        <source>it was removed meanwhile</source>
        <translation>它已被移除</translation>
    </message>
</context>
<context>
    <name>project.guidance_too_many</name>
    <message>
        <source>the view already has %1 of them</source>
        <translation>该视图已有 %1 个</translation>
    </message>
</context>
<context>
    <name>project.has_bytes_of</name>
    <message>
        <source>it has %1 of %2 bytes</source>
        <translation>共 %2 字节，只有 %1</translation>
    </message>
</context>
<context>
    <name>project.has_characters</name>
    <message>
        <source>it has %1 characters</source>
        <translation>有 %1 个字符</translation>
    </message>
</context>
<context>
    <name>project.has_names</name>
    <message>
        <source>it has %1</source>
        <translation>已有：%1</translation>
    </message>
</context>
<context>
    <name>project.has_none_yet</name>
    <message>
        <source>it has no %1 yet</source>
        <translation>还没有%1</translation>
    </message>
</context>
<context>
    <name>project.has_other_size</name>
    <message>
        <source>%1 has %2 bytes instead of %3</source>
        <translation>%1 有 %2 字节，应为 %3 字节</translation>
    </message>
</context>
<context>
    <name>project.has_robots</name>
    <message>
        <source>it has %1 robots</source>
        <translation>它有 %1 个机器人</translation>
    </message>
</context>
<context>
    <name>project.has_views</name>
    <message>
        <source>it has %1 views</source>
        <translation>它有 %1 个视角</translation>
    </message>
</context>
<context>
    <name>project.height_below_floor</name>
    <message>
        <source>its height is below the floor</source>
        <translation>高度低于地面</translation>
    </message>
</context>
<context>
    <name>project.height_from_0</name>
    <message>
        <source>give a height of 0 or more</source>
        <translation>请给出 0 或以上的高度</translation>
    </message>
</context>
<context>
    <name>project.height_not_given</name>
    <message>
        <source>it needs a fixed height, but none is given</source>
        <translation>需要给出高度，但没有</translation>
    </message>
</context>
<context>
    <name>project.holds_invisible</name>
    <message>
        <source>it holds an invisible character, %1</source>
        <translation>其中有不可见字符 %1</translation>
    </message>
</context>
<context>
    <name>project.holds_line_break</name>
    <message>
        <source>it holds a line break or another control character</source>
        <translation>含有换行或其他控制字符</translation>
    </message>
</context>
<context>
    <name>project.ignored_area</name>
    <message>
        <source>ignored area</source>
        <translation>忽略区域</translation>
    </message>
</context>
<context>
    <name>project.import_another_file</name>
    <message>
        <source>import another file</source>
        <translation>请导入另一文件</translation>
    </message>
</context>
<context>
    <name>project.impossible_format</name>
    <message>
        <source>it claims to have format %1</source>
        <translation>其自称格式为 %1</translation>
    </message>
</context>
<context>
    <name>project.in_synced_folder</name>
    <message>
        <source>it is in a folder that %1 copies while it changes: a copy may contain half a change</source>
        <translation>它位于 %1 会在其更改时复制的文件夹中，副本可能只含一半更改</translation>
    </message>
</context>
<context>
    <name>project.is_missing</name>
    <message>
        <source>%1 is missing</source>
        <translation>缺少 %1</translation>
    </message>
</context>
<context>
    <name>project.is_missing_recording</name>
    <message>
        <source>this is a missing recording</source>
        <translation>这是一份缺失的录像</translation>
    </message>
</context>
<context>
    <name>project.journal_of_another</name>
    <message>
        <source>the journal beside it names another file</source>
        <translation>旁边的日志指向另一个文件</translation>
    </message>
</context>
<context>
    <name>project.keep_it</name>
    <message>
        <source>keep it</source>
        <translation>请保留</translation>
    </message>
</context>
<context>
    <name>project.keep_on_own_disk</name>
    <message>
        <source>keep it on a disk of this computer, and pack it to share it</source>
        <translation>请把它保存在本机磁盘上，需要共享时请打包</translation>
    </message>
</context>
<context>
    <name>project.kind_calibration</name>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
</context>
<context>
    <name>project.kind_camera</name>
    <message>
        <source>camera</source>
        <translation>相机</translation>
    </message>
</context>
<context>
    <name>project.kind_class</name>
    <message>
        <source>class</source>
        <translation>班级</translation>
    </message>
</context>
<context>
    <name>project.kind_figure</name>
    <message>
        <source>metric</source>
        <translation>指标</translation>
    </message>
</context>
<context>
    <name>project.kind_gate</name>
    <message>
        <source>gate</source>
        <translation>计时门</translation>
    </message>
</context>
<context>
    <name>project.kind_layout</name>
    <message>
        <source>layout</source>
        <translation>布局</translation>
    </message>
</context>
<context>
    <name>project.kind_lens</name>
    <message>
        <source>lens calibration</source>
        <translation>镜头</translation>
    </message>
</context>
<context>
    <name>project.kind_marker</name>
    <message>
        <source>marker</source>
        <translation>标记</translation>
    </message>
</context>
<context>
    <name>project.kind_member</name>
    <message>
        <source>member</source>
        <translation>成员</translation>
    </message>
</context>
<context>
    <name>project.kind_pseudonym</name>
    <message>
        <source>pseudonym</source>
        <translation>化名</translation>
    </message>
</context>
<context>
    <name>project.kind_registration</name>
    <message>
        <source>registration</source>
        <translation>配准</translation>
    </message>
</context>
<context>
    <name>project.kind_robot</name>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
</context>
<context>
    <name>project.kind_tag</name>
    <message>
        <source>tag</source>
        <translation>标签</translation>
    </message>
</context>
<context>
    <name>project.kind_task</name>
    <message>
        <source>task</source>
        <translation>任务</translation>
    </message>
</context>
<context>
    <name>project.kind_team</name>
    <message>
        <source>team</source>
        <translation>小组</translation>
    </message>
</context>
<context>
    <name>project.kind_track</name>
    <message>
        <source>track</source>
        <translation>轨迹</translation>
    </message>
</context>
<context>
    <name>project.kind_trial</name>
    <message>
        <source>trial</source>
        <translation>试验</translation>
    </message>
</context>
<context>
    <name>project.kind_variable</name>
    <message>
        <source>variable</source>
        <translation>变量</translation>
    </message>
</context>
<context>
    <name>project.kind_zone</name>
    <message>
        <source>zone</source>
        <translation>区域</translation>
    </message>
</context>
<context>
    <name>project.label_twice</name>
    <message>
        <source>the label &apos;%1&apos; appears twice</source>
        <translation>标号“%1”出现两次</translation>
    </message>
</context>
<context>
    <name>project.leave_it</name>
    <message>
        <source>leave it</source>
        <translation>请保持不变</translation>
    </message>
</context>
<context>
    <name>project.leave_one_out</name>
    <message>
        <source>use only one of the two</source>
        <translation>请去掉其中之一</translation>
    </message>
</context>
<context>
    <name>project.leave_out_unseen_markers</name>
    <message>
        <source>remove those that no camera sees</source>
        <translation>去掉没有相机能看到的标记</translation>
    </message>
</context>
<context>
    <name>project.lengths_differ</name>
    <message>
        <source>samples and profile differ in length</source>
        <translation>采样点与运动曲线长度不一致</translation>
    </message>
</context>
<context>
    <name>project.lens_kept</name>
    <message>
        <source>the lens calibration remains valid without it</source>
        <translation>没有此文件，镜头仍保留</translation>
    </message>
</context>
<context>
    <name>project.lens_of_project</name>
    <message>
        <source>lens calibration %1 of the project</source>
        <translation>项目的镜头 %1</translation>
    </message>
</context>
<context>
    <name>project.lies_in_media</name>
    <message>
        <source>a project is in the media folder of another one</source>
        <translation>有项目位于另一个项目的媒体文件夹中</translation>
    </message>
</context>
<context>
    <name>project.lists_too_long</name>
    <message>
        <source>%1: more than %2 of one %3: %4</source>
        <translation>%1：同一 %3 超过 %2 个：%4</translation>
    </message>
</context>
<context>
    <name>project.look_for_strays</name>
    <message>
        <source>find stray files</source>
        <translation>查找无归属的文件</translation>
    </message>
</context>
<context>
    <name>project.look_in</name>
    <message>
        <source>search &apos;%1&apos;</source>
        <translation>在“%1”中查找</translation>
    </message>
</context>
<context>
    <name>project.marker_errors_differ</name>
    <message>
        <source>the stored marker errors of registration %1 differ from those of its markers</source>
        <translation>配准 %1 的标记误差与由其标记得出的不一致</translation>
    </message>
</context>
<context>
    <name>project.marker_off_floor</name>
    <message>
        <source>marker &apos;%1&apos; is not within a floor of 1 km</source>
        <translation>标记“%1”不在 1 公里的地面范围内</translation>
    </message>
</context>
<context>
    <name>project.matrix_not_square</name>
    <message>
        <source>its stored matrix of %1 numbers is not square</source>
        <translation>存储的含 %1 个数的矩阵不是方阵</translation>
    </message>
</context>
<context>
    <name>project.may_be_used_beside</name>
    <message>
        <source>project &apos;%1&apos; beside it may use them, and cannot be read (%2)</source>
        <translation>旁边的项目“%1”可能在使用它们，但无法读取（%2）</translation>
    </message>
</context>
<context>
    <name>project.measured_by_task</name>
    <message>
        <source>its rules were used to measure trials</source>
        <translation>有试验按它测量</translation>
    </message>
</context>
<context>
    <name>project.measurements_changed</name>
    <message>
        <source>the measurements have changed since robot &apos;%1&apos; was analysed</source>
        <translation>分析机器人“%1”之后，测量数据有更改</translation>
    </message>
</context>
<context>
    <name>project.metric</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>指标“%1”</translation>
    </message>
</context>
<context>
    <name>project.metric_differs</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>机器人“%2”的指标“%1”存储为 %3，而由其位置得出 %4</translation>
    </message>
</context>
<context>
    <name>project.metric_missing</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is missing, its positions give %3</source>
        <translation>缺少机器人“%2”的指标“%1”，由其位置得出 %3</translation>
    </message>
</context>
<context>
    <name>project.metric_sigma_differs</name>
    <message>
        <source>the standard deviation of metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>机器人“%2”的指标“%1”的标准差存储为 %3，而由其位置得出 %4</translation>
    </message>
</context>
<context>
    <name>project.metric_without_source</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored, but its positions give none</source>
        <translation>存储了机器人“%2”的指标“%1”，但由其位置得不出该指标</translation>
    </message>
</context>
<context>
    <name>project.more_names</name>
    <message>
        <source>%1 more</source>
        <translation>另外 %1 个</translation>
    </message>
</context>
<context>
    <name>project.move_file_away</name>
    <message>
        <source>move it to another folder</source>
        <translation>请将其移到其他文件夹</translation>
    </message>
</context>
<context>
    <name>project.move_log_away</name>
    <message>
        <source>move the log to another folder to open the file without it, or restore the file that the log belongs to</source>
        <translation>请把日志移到其他文件夹，以便不带日志打开此文件；或放回日志所属的文件</translation>
    </message>
</context>
<context>
    <name>project.move_project_away</name>
    <message>
        <source>move it with its videos to a folder of its own</source>
        <translation>请将其连同视频移到单独的文件夹</translation>
    </message>
</context>
<context>
    <name>project.move_teams_first</name>
    <message>
        <source>move its teams to another class first, or archive it</source>
        <translation>请先把其小组移到别的班级，或将其归档</translation>
    </message>
</context>
<context>
    <name>project.name_empty</name>
    <message>
        <source>it is empty</source>
        <translation>为空</translation>
    </message>
</context>
<context>
    <name>project.name_of</name>
    <message>
        <source>name of a %1</source>
        <translation>%1的名称</translation>
    </message>
</context>
<context>
    <name>project.name_robots_once</name>
    <message>
        <source>list each of its robots once</source>
        <translation>每个机器人只写一次</translation>
    </message>
</context>
<context>
    <name>project.name_taken</name>
    <message>
        <source>the project already has a %1 of that name</source>
        <translation>项目中已有同名的%1</translation>
    </message>
</context>
<context>
    <name>project.name_video_file</name>
    <message>
        <source>name the video&apos;s file</source>
        <translation>请指定视频文件</translation>
    </message>
</context>
<context>
    <name>project.newer_format</name>
    <message>
        <source>it was written by a newer Odograph (format %1, this one knows formats up to %2)</source>
        <translation>由更新的 Odograph 写出（格式 %1，本程序最高支持 %2）</translation>
    </message>
</context>
<context>
    <name>project.no_file_but_other</name>
    <message>
        <source>it is a folder or a device, not a file</source>
        <translation>它是文件夹或设备，不是文件</translation>
    </message>
</context>
<context>
    <name>project.no_file_name</name>
    <message>
        <source>it has no file name</source>
        <translation>没有文件名</translation>
    </message>
</context>
<context>
    <name>project.no_ordinary_number</name>
    <message>
        <source>a value to store is too large or not a number</source>
        <translation>要存储的值不是正常大小的数</translation>
    </message>
</context>
<context>
    <name>project.no_place_to_rescue_to</name>
    <message>
        <source>its folder is gone, and no home folder exists to rescue it to</source>
        <translation>它的文件夹已不存在，也没有可用于抢救的主文件夹</translation>
    </message>
</context>
<context>
    <name>project.no_samples</name>
    <message>
        <source>it has no samples</source>
        <translation>没有采样点</translation>
    </message>
</context>
<context>
    <name>project.no_sound_backup</name>
    <message>
        <source>no intact backup was found beside it</source>
        <translation>旁边没有完好的备份</translation>
    </message>
</context>
<context>
    <name>project.no_such_name</name>
    <message>
        <source>the project has no such %1</source>
        <translation>项目中没有这样的%1</translation>
    </message>
</context>
<context>
    <name>project.no_such_number</name>
    <message>
        <source>it has no %1 with the number %2</source>
        <translation>没有编号为 %2 的%1</translation>
    </message>
</context>
<context>
    <name>project.not_a_project</name>
    <message>
        <source>it is not a project file</source>
        <translation>不是项目文件</translation>
    </message>
</context>
<context>
    <name>project.not_brought_to_format</name>
    <message>
        <source>it could not be converted to format %1 (%2)</source>
        <translation>无法更新到格式 %1（%2）</translation>
    </message>
</context>
<context>
    <name>project.not_complete_yet</name>
    <message>
        <source>it is not complete yet</source>
        <translation>尚未补全</translation>
    </message>
</context>
<context>
    <name>project.not_copied</name>
    <message>
        <source>it could not be copied to be read (%1)</source>
        <translation>无法复制以供读取（%1）</translation>
    </message>
</context>
<context>
    <name>project.not_finite</name>
    <message>
        <source>it is not a finite number</source>
        <translation>不是有限数</translation>
    </message>
</context>
<context>
    <name>project.not_in_bin</name>
    <message>
        <source>it is not in the bin</source>
        <translation>不在回收站中</translation>
    </message>
</context>
<context>
    <name>project.not_utf8</name>
    <message>
        <source>it is not valid UTF-8 text</source>
        <translation>不是有效的 UTF-8 文本</translation>
    </message>
</context>
<context>
    <name>project.not_visible_span</name>
    <message>
        <source>time in which a robot is not visible</source>
        <translation>机器人不可见的时间</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_redo</name>
    <message>
        <source>nothing has been undone</source>
        <translation>没有已撤销的操作</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_undo</name>
    <message>
        <source>nothing has been changed since the project was opened</source>
        <translation>自打开项目以来没有更改</translation>
    </message>
</context>
<context>
    <name>project.numbers_too_large</name>
    <message>
        <source>%1: numbers beyond %2: %3</source>
        <translation>%1：超出 %2 的数：%3</translation>
    </message>
</context>
<context>
    <name>project.observations_do_not_fit</name>
    <message>
        <source>view &apos;%1&apos; has %2 frames, but the observations of &apos;%3&apos; (%4) do not fit them</source>
        <translation>视角“%1”有 %2 帧，但“%3”的观测（%4 个）与之不符</translation>
    </message>
</context>
<context>
    <name>project.observations_of_project</name>
    <message>
        <source>observations %1 of the project</source>
        <translation>项目的观测 %1</translation>
    </message>
</context>
<context>
    <name>project.older_format</name>
    <message>
        <source>it has the older format %1 and must be updated before Odograph can read it, but %2</source>
        <translation>其格式 %1 较旧，读取前须更新，但 %2</translation>
    </message>
</context>
<context>
    <name>project.on_network_disk</name>
    <message>
        <source>it is on a network disk (%1): a recording can stall there, and two computers can damage it</source>
        <translation>它位于网络磁盘（%1）上，录制可能停顿，两台计算机可能损坏它</translation>
    </message>
</context>
<context>
    <name>project.open_again</name>
    <message>
        <source>open it again; if you were recording, find stray files (odograph check --adopt)</source>
        <translation>请重新打开；如果当时正在录制，请看“查找无归属的文件…”</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere</name>
    <message>
        <source>it is open in another window</source>
        <translation>已在另一窗口打开</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere_by</name>
    <message>
        <source>it is open in another window (%1)</source>
        <translation>已在另一窗口打开（%1）</translation>
    </message>
</context>
<context>
    <name>project.open_or_move_that</name>
    <message>
        <source>open that project, or move it to a folder of its own with its videos</source>
        <translation>请打开该项目，或将其连同视频移到单独的文件夹</translation>
    </message>
</context>
<context>
    <name>project.open_with_newer_odograph</name>
    <message>
        <source>open the project with a newer Odograph</source>
        <translation>请用更新的 Odograph 打开项目</translation>
    </message>
</context>
<context>
    <name>project.open_with_that_odograph</name>
    <message>
        <source>open it with that version, or update this one</source>
        <translation>请用那个版本打开，或更新本程序</translation>
    </message>
</context>
<context>
    <name>project.other_database</name>
    <message>
        <source>it is a database of another program</source>
        <translation>是其他程序的数据库</translation>
    </message>
</context>
<context>
    <name>project.other_labels</name>
    <message>
        <source>the labels differ from those of the layout</source>
        <translation>标号与原有的不同</translation>
    </message>
</context>
<context>
    <name>project.other_tables</name>
    <message>
        <source>its tables are not those of a project</source>
        <translation>其数据表不是项目的</translation>
    </message>
</context>
<context>
    <name>project.others_calibration_chosen</name>
    <message>
        <source>calibration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>为它选择的标定 %1 属于相机“%2”；现使用它自己最新的标定</translation>
    </message>
</context>
<context>
    <name>project.others_registration_chosen</name>
    <message>
        <source>registration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>为它选择的配准 %1 属于相机“%2”；现使用它自己最新的配准</translation>
    </message>
</context>
<context>
    <name>project.overrides_changed</name>
    <message>
        <source>the manual overrides have changed since robot &apos;%1&apos; was analysed</source>
        <translation>分析机器人“%1”之后，手动判定有更改</translation>
    </message>
</context>
<context>
    <name>project.path_cut_off</name>
    <message>
        <source>its reference path ends within a point</source>
        <translation>其参考路径在一个点的中途结束</translation>
    </message>
</context>
<context>
    <name>project.path_leaves_folder</name>
    <message>
        <source>its relative path points outside the project&apos;s folder</source>
        <translation>其相对路径超出了项目文件夹</translation>
    </message>
</context>
<context>
    <name>project.picture_name</name>
    <message>
        <source>name of a calibration image</source>
        <translation>标定图片的名称</translation>
    </message>
</context>
<context>
    <name>project.picture_path</name>
    <message>
        <source>path of a calibration image</source>
        <translation>标定图片的路径</translation>
    </message>
</context>
<context>
    <name>project.point_by_hand</name>
    <message>
        <source>point set by hand</source>
        <translation>手动设置的点</translation>
    </message>
</context>
<context>
    <name>project.point_without_sigma</name>
    <message>
        <source>it needs one position and a σ above 0 px</source>
        <translation>需要一个位置和大于 0 px 的 σ</translation>
    </message>
</context>
<context>
    <name>project.position_no_number</name>
    <message>
        <source>a position or its covariance is not a number</source>
        <translation>某个位置或其协方差不是数字</translation>
    </message>
</context>
<context>
    <name>project.positions_changed</name>
    <message>
        <source>the stored positions of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>机器人“%1”的位置与分析得出的不一致</translation>
    </message>
</context>
<context>
    <name>project.project</name>
    <message>
        <source>project &apos;%1&apos;</source>
        <translation>项目“%1”</translation>
    </message>
</context>
<context>
    <name>project.project_file_damaged</name>
    <message>
        <source>the project file is damaged</source>
        <translation>项目文件已损坏</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_open</name>
    <message>
        <source>move the file back to its folder, and open the project again</source>
        <translation>请把文件放回原处，并重新打开项目</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_retry</name>
    <message>
        <source>move it back to its folder and try again</source>
        <translation>请将其放回原处，然后重试</translation>
    </message>
</context>
<context>
    <name>project.put_back_or_find</name>
    <message>
        <source>move the file back to its folder, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in the window</source>
        <translation>请将文件放回原处，或用“查找丢失的视频…”按内容查找</translation>
    </message>
</context>
<context>
    <name>project.put_file_back</name>
    <message>
        <source>move the file back to its folder</source>
        <translation>请将文件放回原处</translation>
    </message>
</context>
<context>
    <name>project.put_into_bin_first</name>
    <message>
        <source>move it to the bin first</source>
        <translation>请先放入回收站</translation>
    </message>
</context>
<context>
    <name>project.put_original_back</name>
    <message>
        <source>move the original file back to its folder</source>
        <translation>请把原来的文件放回原处</translation>
    </message>
</context>
<context>
    <name>project.range_changed</name>
    <message>
        <source>the trial&apos;s range has changed since robot &apos;%1&apos; was analysed</source>
        <translation>自分析机器人“%1”以来，试验的区间已更改</translation>
    </message>
</context>
<context>
    <name>project.range_sentence</name>
    <message>
        <source>Range: %1 to %2 of %3; all results are of this part.</source>
        <translation>区间：共 %3，从 %1 到 %2；所有结果都针对这一部分。</translation>
    </message>
</context>
<context>
    <name>project.range_without_sample</name>
    <message>
        <source>no sample is within its range</source>
        <translation>其区间内没有采样点</translation>
    </message>
</context>
<context>
    <name>project.raw_times_of</name>
    <message>
        <source>raw times of recording %1</source>
        <translation>录像 %1 的原始时间</translation>
    </message>
</context>
<context>
    <name>project.reading</name>
    <message>
        <source>reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
</context>
<context>
    <name>project.reading_failed</name>
    <message>
        <source>reading it failed (%1)</source>
        <translation>读取失败（%1）</translation>
    </message>
</context>
<context>
    <name>project.reason_is_blank</name>
    <message>
        <source>it is blank</source>
        <translation>为空</translation>
    </message>
</context>
<context>
    <name>project.record_another</name>
    <message>
        <source>record another trial</source>
        <translation>请录制另一个试验</translation>
    </message>
</context>
<context>
    <name>project.recorded_into_now</name>
    <message>
        <source>a trial is being recorded into it now</source>
        <translation>正在向其中录制试验</translation>
    </message>
</context>
<context>
    <name>project.recording</name>
    <message>
        <source>recording</source>
        <translation>正在录制</translation>
    </message>
</context>
<context>
    <name>project.recording_at</name>
    <message>
        <source>recording &apos;%1&apos;</source>
        <translation>录像“%1”</translation>
    </message>
</context>
<context>
    <name>project.recording_cut_off</name>
    <message>
        <source>its recording was cut off</source>
        <translation>其录像被中断</translation>
    </message>
</context>
<context>
    <name>project.recording_ended</name>
    <message>
        <source>its recording has ended already</source>
        <translation>其录制已结束</translation>
    </message>
</context>
<context>
    <name>project.recording_kept</name>
    <message>
        <source>its recording has ended, and is kept</source>
        <translation>其录制已结束，并已保留</translation>
    </message>
</context>
<context>
    <name>project.recording_of_view</name>
    <message>
        <source>the recording of view &apos;%1&apos;</source>
        <translation>视角“%1”的录像</translation>
    </message>
</context>
<context>
    <name>project.recording_path</name>
    <message>
        <source>path of a recording</source>
        <translation>录像的路径</translation>
    </message>
</context>
<context>
    <name>project.recording_without_file</name>
    <message>
        <source>it has no file</source>
        <translation>没有文件</translation>
    </message>
</context>
<context>
    <name>project.recordings_changed</name>
    <message>
        <source>the recordings or their synchronisation have changed since robot &apos;%1&apos; was analysed</source>
        <translation>分析机器人“%1”之后，录像或其同步有更改</translation>
    </message>
</context>
<context>
    <name>project.redo</name>
    <message>
        <source>redo</source>
        <translation>重做</translation>
    </message>
</context>
<context>
    <name>project.redo_of</name>
    <message>
        <source>redo &apos;%1&apos;</source>
        <translation>重做“%1”</translation>
    </message>
</context>
<context>
    <name>project.reference_too_far</name>
    <message>
        <source>its reference point is more than %1 from its centre</source>
        <translation>其参考点距中心超过 %1</translation>
    </message>
</context>
<context>
    <name>project.reference_without_heading</name>
    <message>
        <source>a reference point off its centre needs a heading, but a robot of changing height has none</source>
        <translation>偏离中心的参考点需要朝向，而高度变化时朝向未知</translation>
    </message>
</context>
<context>
    <name>project.refers_to_nothing</name>
    <message>
        <source>it refers to something missing from the project, or a value is missing</source>
        <translation>引用了项目中没有的内容，或缺少某个值</translation>
    </message>
</context>
<context>
    <name>project.registration_kept</name>
    <message>
        <source>the registration remains valid without it</source>
        <translation>没有此文件，配准仍保留</translation>
    </message>
</context>
<context>
    <name>project.registration_of_project</name>
    <message>
        <source>registration %1 of the project</source>
        <translation>项目的配准 %1</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_of</name>
    <message>
        <source>the image of registration %1 of camera &apos;%2&apos;</source>
        <translation>相机“%2”的配准 %1 的画面</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_path</name>
    <message>
        <source>path of a registration&apos;s image</source>
        <translation>配准图片的路径</translation>
    </message>
</context>
<context>
    <name>project.registrations_changed</name>
    <message>
        <source>the registrations have changed since robot &apos;%1&apos; was analysed</source>
        <translation>分析机器人“%1”之后，配准有更改</translation>
    </message>
</context>
<context>
    <name>project.remove_file_first</name>
    <message>
        <source>choose another name, or remove that file first</source>
        <translation>请换个名称，或先删除该文件</translation>
    </message>
</context>
<context>
    <name>project.remove_guidance</name>
    <message>
        <source>remove some first</source>
        <translation>请先移除一些</translation>
    </message>
</context>
<context>
    <name>project.remove_variables</name>
    <message>
        <source>remove some of its variables</source>
        <translation>请删除其中一些变量</translation>
    </message>
</context>
<context>
    <name>project.rest_not_read</name>
    <message>
        <source>Odograph does not read the rest; shorten it here, or in the program that wrote the file</source>
        <translation>其余部分不读取；请在此处或文件来源处更改</translation>
    </message>
</context>
<context>
    <name>project.restore_file</name>
    <message>
        <source>restore it from a backup copy</source>
        <translation>请从备份恢复</translation>
    </message>
</context>
<context>
    <name>project.restore_or_register_again</name>
    <message>
        <source>restore the project from a backup copy, or register the camera again</source>
        <translation>请从备份恢复项目，或重新配准相机</translation>
    </message>
</context>
<context>
    <name>project.restore_or_track_again</name>
    <message>
        <source>restore the project from a backup copy, or track the trial again</source>
        <translation>请从备份恢复项目，或重新跟踪该试验</translation>
    </message>
</context>
<context>
    <name>project.restore_project</name>
    <message>
        <source>restore the project from a backup copy</source>
        <translation>请从备份恢复项目</translation>
    </message>
</context>
<context>
    <name>project.results_changed</name>
    <message>
        <source>the stored metrics, spikes or settings of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>机器人“%1”的指标、异常点或设置与分析得出的不一致</translation>
    </message>
</context>
<context>
    <name>project.robot_can_be_renamed</name>
    <message>
        <source>you can rename it</source>
        <translation>可以给它另起名称</translation>
    </message>
</context>
<context>
    <name>project.robot_drove</name>
    <message>
        <source>a trial uses it</source>
        <translation>它在某个试验中运行过</translation>
    </message>
</context>
<context>
    <name>project.robot_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>大于 %1</translation>
    </message>
</context>
<context>
    <name>project.robot_twice</name>
    <message>
        <source>it has a robot twice</source>
        <translation>有机器人重复属于它</translation>
    </message>
</context>
<context>
    <name>project.row_refers_to_nothing</name>
    <message>
        <source>row %1 of &apos;%2&apos; refers to a missing row of &apos;%3&apos;</source>
        <translation>“%2”的第 %1 行引用了“%3”中不存在的行</translation>
    </message>
</context>
<context>
    <name>project.run_check</name>
    <message>
        <source>run a check of the project</source>
        <translation>请运行项目检查</translation>
    </message>
</context>
<context>
    <name>project.say_why</name>
    <message>
        <source>write why the results can be used</source>
        <translation>请写明为什么可以使用这些结果</translation>
    </message>
</context>
<context>
    <name>project.school_ask_owner</name>
    <message>
        <source>nothing of it was taken over; ask for it to be published again</source>
        <translation>未采用其中任何内容；请让对方重新发布</translation>
    </message>
</context>
<context>
    <name>project.school_document</name>
    <message>
        <source>document of the hub</source>
        <translation>中心库的文档</translation>
    </message>
</context>
<context>
    <name>project.school_field_wrong</name>
    <message>
        <source>what the hub has of it is damaged: field &apos;%1&apos;</source>
        <translation>中心库中的内容已损坏：字段“%1”</translation>
    </message>
</context>
<context>
    <name>project.school_names_taken</name>
    <message>
        <source>every name for it is taken here</source>
        <translation>可用的名称都已被占用</translation>
    </message>
</context>
<context>
    <name>project.school_not_readable</name>
    <message>
        <source>what the hub has of it cannot be read</source>
        <translation>中心库中的内容无法读取</translation>
    </message>
</context>
<context>
    <name>project.school_publish_again</name>
    <message>
        <source>publish again</source>
        <translation>请重新发布</translation>
    </message>
</context>
<context>
    <name>project.school_recordings</name>
    <message>
        <source>recordings of a trial from the hub</source>
        <translation>来自中心库的试验录像</translation>
    </message>
</context>
<context>
    <name>project.school_recordings_wrong</name>
    <message>
        <source>their description is damaged: field &apos;%1&apos;</source>
        <translation>其描述已损坏：字段“%1”</translation>
    </message>
</context>
<context>
    <name>project.school_rename_yours</name>
    <message>
        <source>rename the trials of that name in this project</source>
        <translation>请重命名本项目中同名的试验</translation>
    </message>
</context>
<context>
    <name>project.school_row_gone</name>
    <message>
        <source>it is no longer in the project</source>
        <translation>它已不在项目中</translation>
    </message>
</context>
<context>
    <name>project.search_area</name>
    <message>
        <source>search area</source>
        <translation>搜索区域</translation>
    </message>
</context>
<context>
    <name>project.series_differ</name>
    <message>
        <source>its series differ in length</source>
        <translation>其各序列长度不一致</translation>
    </message>
</context>
<context>
    <name>project.series_missing</name>
    <message>
        <source>its series are missing</source>
        <translation>缺少其数据序列</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_kind</name>
    <message>
        <source>its stored series is not of the expected kind</source>
        <translation>存储的序列类型不符</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_length</name>
    <message>
        <source>its stored series announces %1 rows but holds %2 bytes</source>
        <translation>存储的序列声明有 %1 行，却只有 %2 字节</translation>
    </message>
</context>
<context>
    <name>project.size_not_above_0</name>
    <message>
        <source>its size is not above 0</source>
        <translation>尺寸不大于 0</translation>
    </message>
</context>
<context>
    <name>project.spike_without_sample</name>
    <message>
        <source>a spike refers to a missing sample</source>
        <translation>有异常点指向不存在的采样点</translation>
    </message>
</context>
<context>
    <name>project.split_recording</name>
    <message>
        <source>split the recording into shorter ones</source>
        <translation>请把录像分成较短的几段</translation>
    </message>
</context>
<context>
    <name>project.strays_unknown</name>
    <message>
        <source>cannot determine which files belong to no trial</source>
        <translation>无法判断哪些文件不属于任何试验</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_differs</name>
    <message>
        <source>its stored synchronisation differs from that of its second view</source>
        <translation>其存储的同步与其视角 2 的同步不一致</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_of_one_view</name>
    <message>
        <source>a synchronisation is stored, but it has no second view</source>
        <translation>存储了同步，但它没有视角 2</translation>
    </message>
</context>
<context>
    <name>project.take_later_back</name>
    <message>
        <source>undo the later change first, or leave this one</source>
        <translation>请先撤销后来的更改，或保持不变</translation>
    </message>
</context>
<context>
    <name>project.task_changed</name>
    <message>
        <source>the task has changed since robot &apos;%1&apos; was analysed</source>
        <translation>分析机器人“%1”之后，任务有更改</translation>
    </message>
</context>
<context>
    <name>project.task_has_trial</name>
    <message>
        <source>a trial uses it</source>
        <translation>有一个试验使用它</translation>
    </message>
</context>
<context>
    <name>project.task_has_trials</name>
    <message>
        <source>%1 trials use it</source>
        <translation>有 %1 个试验使用它</translation>
    </message>
</context>
<context>
    <name>project.team_has_trial</name>
    <message>
        <source>it has a trial</source>
        <translation>有一个试验属于它</translation>
    </message>
</context>
<context>
    <name>project.team_has_trials</name>
    <message>
        <source>it has %1 trials</source>
        <translation>有 %1 个试验属于它</translation>
    </message>
</context>
<context>
    <name>project.texts_too_long</name>
    <message>
        <source>%1: texts of more than %2 characters: %3</source>
        <translation>%1：超过 %2 个字符的文本：%3</translation>
    </message>
</context>
<context>
    <name>project.times_do_not_rise</name>
    <message>
        <source>its times do not increase</source>
        <translation>时间不递增</translation>
    </message>
</context>
<context>
    <name>project.title</name>
    <message>
        <source>title of the project</source>
        <translation>项目标题</translation>
    </message>
</context>
<context>
    <name>project.too_many_markers</name>
    <message>
        <source>it has more than %1 markers</source>
        <translation>标记超过 %1 个</translation>
    </message>
</context>
<context>
    <name>project.too_many_members</name>
    <message>
        <source>it has more than %1 members</source>
        <translation>成员超过 %1 人</translation>
    </message>
</context>
<context>
    <name>project.too_many_samples</name>
    <message>
        <source>it has more than %1 samples</source>
        <translation>采样点超过 %1 个</translation>
    </message>
</context>
<context>
    <name>project.too_many_variables</name>
    <message>
        <source>a trial has %1 variables at most</source>
        <translation>一个试验最多有 %1 个变量</translation>
    </message>
</context>
<context>
    <name>project.track</name>
    <message>
        <source>track &apos;%1&apos;</source>
        <translation>轨迹“%1”</translation>
    </message>
</context>
<context>
    <name>project.track_again</name>
    <message>
        <source>track the trial again</source>
        <translation>请重新跟踪该试验</translation>
    </message>
</context>
<context>
    <name>project.track_kept</name>
    <message>
        <source>the measured track remains valid without it</source>
        <translation>没有此文件，测得的轨迹仍保留</translation>
    </message>
</context>
<context>
    <name>project.track_reading</name>
    <message>
        <source>reading of a track</source>
        <translation>轨迹的读法</translation>
    </message>
</context>
<context>
    <name>project.trial_notes</name>
    <message>
        <source>notes of a trial</source>
        <translation>试验的备注</translation>
    </message>
</context>
<context>
    <name>project.trial_of_project</name>
    <message>
        <source>trial %1 of the project</source>
        <translation>项目的试验 %1</translation>
    </message>
</context>
<context>
    <name>project.truth</name>
    <message>
        <source>truth of a trial</source>
        <translation>试验的真值</translation>
    </message>
</context>
<context>
    <name>project.truth_of_trial</name>
    <message>
        <source>truth of trial %1</source>
        <translation>试验 %1 的真值</translation>
    </message>
</context>
<context>
    <name>project.try_again</name>
    <message>
        <source>try again</source>
        <translation>请重试</translation>
    </message>
</context>
<context>
    <name>project.try_change_again</name>
    <message>
        <source>try the whole change again</source>
        <translation>请重试整个更改</translation>
    </message>
</context>
<context>
    <name>project.type_name_anew</name>
    <message>
        <source>type the name again</source>
        <translation>请重新输入名称</translation>
    </message>
</context>
<context>
    <name>project.type_text_anew</name>
    <message>
        <source>type the text again</source>
        <translation>请重新输入文本</translation>
    </message>
</context>
<context>
    <name>project.undo</name>
    <message>
        <source>undo</source>
        <translation>撤销</translation>
    </message>
</context>
<context>
    <name>project.undo_of</name>
    <message>
        <source>undo &apos;%1&apos;</source>
        <translation>撤销“%1”</translation>
    </message>
</context>
<context>
    <name>project.undo_something_first</name>
    <message>
        <source>undo something first</source>
        <translation>请先撤销</translation>
    </message>
</context>
<context>
    <name>project.unknown_series_layout</name>
    <message>
        <source>its stored series has the unknown layout %1</source>
        <translation>存储的序列采用未知的结构 %1</translation>
    </message>
</context>
<context>
    <name>project.unknown_setting</name>
    <message>
        <source>its stored setting &apos;%1&apos; is unknown</source>
        <translation>存储的设置“%1”未知</translation>
    </message>
</context>
<context>
    <name>project.use_at_most</name>
    <message>
        <source>use at most %1</source>
        <translation>最多使用 %1 个</translation>
    </message>
</context>
<context>
    <name>project.use_one_line</name>
    <message>
        <source>use a name of one line</source>
        <translation>请使用单行名称</translation>
    </message>
</context>
<context>
    <name>project.value_too_large</name>
    <message>
        <source>a value is too large to store</source>
        <translation>有一个值太大，无法保存</translation>
    </message>
</context>
<context>
    <name>project.verdict</name>
    <message>
        <source>verdict on a trial</source>
        <translation>试验的判定</translation>
    </message>
</context>
<context>
    <name>project.views_differ</name>
    <message>
        <source>views and registrations differ in number</source>
        <translation>视角与配准的数量不一致</translation>
    </message>
</context>
<context>
    <name>project.wait_until_ended</name>
    <message>
        <source>wait until that has ended</source>
        <translation>请等待其结束</translation>
    </message>
</context>
<context>
    <name>project.writing_failed</name>
    <message>
        <source>writing it failed (%1)</source>
        <translation>写入失败（%1）</translation>
    </message>
</context>
<context>
    <name>project.written_over</name>
    <message>
        <source>another program wrote over its file while it was open; nothing more was stored</source>
        <translation>打开期间另一个程序覆盖了其文件；此后未保存任何内容</translation>
    </message>
</context>
<context>
    <name>project.zone_cut_off</name>
    <message>
        <source>its zone &apos;%1&apos; ends within a point</source>
        <translation>其区域“%1”在一个点的中途结束</translation>
    </message>
</context>
<context>
    <name>school.address</name>
    <message>
        <source>address of the school hub</source>
        <translation>学校中心库的地址</translation>
    </message>
</context>
<context>
    <name>school.address_characters</name>
    <message>
        <source>it holds a quotation mark, a backslash, a semicolon or a control character</source>
        <translation>其中含有引号、反斜杠、分号或控制字符</translation>
    </message>
</context>
<context>
    <name>school.address_form</name>
    <message>
        <source>give it as postgresql://user@host/database</source>
        <translation>请写成 postgresql://user@host/database</translation>
    </message>
</context>
<context>
    <name>school.ask_administrator</name>
    <message>
        <source>ask the hub&apos;s administrator for the role that may</source>
        <translation>请向中心库管理员申请相应的角色</translation>
    </message>
</context>
<context>
    <name>school.check_connection</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network; what is recorded meanwhile is sent later</source>
        <translation>请检查地址、~/.pgpass 中的登录信息和网络；期间记录的内容会稍后发送</translation>
    </message>
</context>
<context>
    <name>school.check_server</name>
    <message>
        <source>have the hub&apos;s administrator look at the server</source>
        <translation>请让中心库管理员检查服务器</translation>
    </message>
</context>
<context>
    <name>school.connect_first</name>
    <message>
        <source>connect it with odograph school connect P.odo postgresql://user@host/database</source>
        <translation>请先连接</translation>
    </message>
</context>
<context>
    <name>school.connect_with_media</name>
    <message>
        <source>connect it again with --media FOLDER</source>
        <translation>请指定媒体文件夹后重新连接</translation>
    </message>
</context>
<context>
    <name>school.grant_role</name>
    <message>
        <source>have the hub&apos;s administrator grant it one: GRANT bench TO login</source>
        <translation>请让中心库管理员授予角色：GRANT bench TO login</translation>
    </message>
</context>
<context>
    <name>school.hub_subject</name>
    <message>
        <source>school hub &apos;%1&apos;</source>
        <translation>学校中心库“%1”</translation>
    </message>
</context>
<context>
    <name>school.install_driver</name>
    <message>
        <source>install the package libqt6sql6-psql</source>
        <translation>请安装软件包 libqt6sql6-psql</translation>
    </message>
</context>
<context>
    <name>school.media</name>
    <message>
        <source>media folder of the school</source>
        <translation>学校的媒体文件夹</translation>
    </message>
</context>
<context>
    <name>school.never_answers</name>
    <message>
        <source>the server takes connections and answers none</source>
        <translation>服务器接受连接但不作任何回应</translation>
    </message>
</context>
<context>
    <name>school.newer_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph knows up to %2</source>
        <translation>其架构版本为 %1，而此 Odograph 只支持到 %2</translation>
    </message>
</context>
<context>
    <name>school.no_database</name>
    <message>
        <source>it names no database</source>
        <translation>其中没有数据库名称</translation>
    </message>
</context>
<context>
    <name>school.no_driver</name>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>本机没有 PostgreSQL 驱动</translation>
    </message>
</context>
<context>
    <name>school.no_hub</name>
    <message>
        <source>the database has no hub</source>
        <translation>该数据库中没有中心库</translation>
    </message>
</context>
<context>
    <name>school.no_media</name>
    <message>
        <source>the project is connected without one</source>
        <translation>项目连接时没有指定它</translation>
    </message>
</context>
<context>
    <name>school.no_role</name>
    <message>
        <source>the login has none of the roles teacher, bench and viewer</source>
        <translation>该登录没有 teacher、bench、viewer 中的任何角色</translation>
    </message>
</context>
<context>
    <name>school.no_url</name>
    <message>
        <source>it is no address of a PostgreSQL database</source>
        <translation>这不是 PostgreSQL 数据库的地址</translation>
    </message>
</context>
<context>
    <name>school.not_allowed</name>
    <message>
        <source>the login may not do that (%1)</source>
        <translation>该登录无权这样做（%1）</translation>
    </message>
</context>
<context>
    <name>school.not_connected</name>
    <message>
        <source>the project is not connected to one</source>
        <translation>项目未连接到任何中心库</translation>
    </message>
</context>
<context>
    <name>school.older_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph needs %2</source>
        <translation>其架构版本为 %1，而此 Odograph 需要 %2</translation>
    </message>
</context>
<context>
    <name>school.option_unknown</name>
    <message>
        <source>its option &apos;%1&apos; is not known</source>
        <translation>其选项“%1”未知</translation>
    </message>
</context>
<context>
    <name>school.options_known</name>
    <message>
        <source>use sslmode, sslrootcert, host or port</source>
        <translation>请使用 sslmode、sslrootcert、host 或 port</translation>
    </message>
</context>
<context>
    <name>school.password_elsewhere</name>
    <message>
        <source>leave it out, and put the password into ~/.pgpass or PGPASSWORD</source>
        <translation>请去掉密码，并把它放入 ~/.pgpass 或 PGPASSWORD</translation>
    </message>
</context>
<context>
    <name>school.password_in_url</name>
    <message>
        <source>it holds a password, which others could read</source>
        <translation>其中含有他人可能读到的密码</translation>
    </message>
</context>
<context>
    <name>school.password_place</name>
    <message>
        <source>put the correct one into ~/.pgpass or PGPASSWORD</source>
        <translation>请在此输入，或将其放入 ~/.pgpass</translation>
    </message>
</context>
<context>
    <name>school.password_refused</name>
    <message>
        <source>the server does not accept this login with this password</source>
        <translation>服务器不接受此登录名与此密码</translation>
    </message>
</context>
<context>
    <name>school.password_wanted</name>
    <message>
        <source>the server asks for the password of the login</source>
        <translation>服务器要求此登录的密码</translation>
    </message>
</context>
<context>
    <name>school.publish_later</name>
    <message>
        <source>try again later; what was not sent yet is kept</source>
        <translation>请稍后再试；尚未发送的内容会保留</translation>
    </message>
</context>
<context>
    <name>school.publishing</name>
    <message>
        <source>publishing</source>
        <translation>正在发布</translation>
    </message>
</context>
<context>
    <name>school.receiving</name>
    <message>
        <source>receiving %1</source>
        <translation>正在接收%1</translation>
    </message>
</context>
<context>
    <name>school.recording_changed</name>
    <message>
        <source>the recording &apos;%1&apos; is missing or has changed, and was left out</source>
        <translation>录像“%1”缺失或已更改，已略过</translation>
    </message>
</context>
<context>
    <name>school.recording_elsewhere</name>
    <message>
        <source>trial &apos;%1&apos;, view &apos;%2&apos;: its recording is not in the media folder; bench &apos;%3&apos; has it as &apos;%4&apos;</source>
        <translation>试验“%1”，视图“%2”：录像不在媒体文件夹中；工作台“%3”将其存为“%4”</translation>
    </message>
</context>
<context>
    <name>school.report_to_administrator</name>
    <message>
        <source>show this to the hub&apos;s administrator</source>
        <translation>请把此信息告知中心库管理员</translation>
    </message>
</context>
<context>
    <name>school.run_init</name>
    <message>
        <source>have its administrator run odograph school init</source>
        <translation>请让管理员建立中心库</translation>
    </message>
</context>
<context>
    <name>school.server_away</name>
    <message>
        <source>the server is away; trying again</source>
        <translation>服务器无法连接；正在重试</translation>
    </message>
</context>
<context>
    <name>school.silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>服务器没有回应</translation>
    </message>
</context>
<context>
    <name>school.sslmode_choices</name>
    <message>
        <source>use disable, allow, prefer, require, verify-ca or verify-full</source>
        <translation>请使用 disable、allow、prefer、require、verify-ca 或 verify-full</translation>
    </message>
</context>
<context>
    <name>school.sslmode_unknown</name>
    <message>
        <source>sslmode &apos;%1&apos; is not known</source>
        <translation>sslmode“%1”未知</translation>
    </message>
</context>
<context>
    <name>school.subject</name>
    <message>
        <source>school hub</source>
        <translation>学校中心库</translation>
    </message>
</context>
<context>
    <name>school.update_program</name>
    <message>
        <source>update Odograph</source>
        <translation>请更新 Odograph</translation>
    </message>
</context>
<context>
    <name>school.waiting</name>
    <message>
        <source>waiting for the server</source>
        <translation>正在等待服务器</translation>
    </message>
</context>
<context>
    <name>school.went_away</name>
    <message>
        <source>the connection was lost (%1)</source>
        <translation>连接已断开（%1）</translation>
    </message>
</context>
<context>
    <name>simulation.cannot_render</name>
    <message>
        <source>cannot render %1</source>
        <translation>无法渲染 %1</translation>
    </message>
</context>
<context>
    <name>simulation.lengthen_scene</name>
    <message>
        <source>give the scene a longer duration or start the camera earlier</source>
        <translation>请延长场景时长，或更早启动相机</translation>
    </message>
</context>
<context>
    <name>simulation.no_frame</name>
    <message>
        <source>camera %1 takes no frame during the scene</source>
        <translation>场景持续期间相机 %1 没有拍到帧</translation>
    </message>
</context>
<context>
    <name>simulation.rendering</name>
    <message>
        <source>rendering %1</source>
        <translation>渲染 %1</translation>
    </message>
</context>
<context>
    <name>sync.cost</name>
    <message>
        <source>View %1: its times are known to ±%2, which is ±%3 at the top speed of %4</source>
        <translation>视图 %1：其时间已知到 ±%2，在最大速度 %4 下相当于 ±%3</translation>
    </message>
</context>
<context>
    <name>sync.cost_of_error</name>
    <message>
        <source>View %1: nothing has measured its time offset; an error of %2 would shift the robot by %3 at the top speed of %4</source>
        <translation>视图 %1：其时间差未经测量；%2 的误差在最大速度 %4 下会使机器人偏移 %3</translation>
    </message>
</context>
<context>
    <name>sync.drift</name>
    <message>
        <source>Its clock runs %1 ±%2 faster than the first view&apos;s</source>
        <translation>其时钟比第一个视图快 %1 ±%2</translation>
    </message>
</context>
<context>
    <name>sync.known_to</name>
    <message>
        <source>View %1: its times are known to ±%2</source>
        <translation>视图 %1：其时间已知到 ±%2</translation>
    </message>
</context>
<context>
    <name>sync.no_residual</name>
    <message>
        <source>The views&apos; disagreement does not grow with the speed: a remaining time error is at most %1, or %2 at the top speed</source>
        <translation>视图间的不一致不随速度增大：剩余时间误差至多 %1，在最大速度下为 %2</translation>
    </message>
</context>
<context>
    <name>sync.not_measured</name>
    <message>
        <source>View %1: nothing has measured its time offset</source>
        <translation>视图 %1：其时间差未经测量</translation>
    </message>
</context>
<context>
    <name>sync.pairing</name>
    <message>
        <source>Its frames are %1 on average and at most %2 from the first view&apos;s; positions are interpolated to the same times</source>
        <translation>其帧与第一个视图的帧平均相差 %1，至多 %2；位置会插值到相同时刻</translation>
    </message>
</context>
<context>
    <name>sync.residual</name>
    <message>
        <source>The views disagree the more the faster the robot is, as a time error of %1 ±%2 would make them: %3 at the top speed</source>
        <translation>机器人越快，视图间不一致越大，相当于 %1 ±%2 的时间误差：在最大速度下为 %3</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_flash</name>
    <message>
        <source>%1 by the flash of light</source>
        <translation>由闪光得 %1</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_motion</name>
    <message>
        <source>%1 by the motion</source>
        <translation>由运动得 %1</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_sound</name>
    <message>
        <source>%1 by the sound</source>
        <translation>由声音得 %1</translation>
    </message>
</context>
<context>
    <name>synchronisation.clap_twice</name>
    <message>
        <source>clap twice near the middle of the floor while both cameras record, or give --sync SECONDS</source>
        <translation>请在两台相机录制时在地面中央附近拍两次手，或给出偏移</translation>
    </message>
</context>
<context>
    <name>synchronisation.clocks_ambiguous</name>
    <message>
        <source>several time offsets, pauses or missing frames explain the views&apos; tracks about equally well</source>
        <translation>多种时间偏移、暂停或缺帧都能差不多同样好地解释各视角的轨迹</translation>
    </message>
</context>
<context>
    <name>synchronisation.different_runs</name>
    <message>
        <source>the views&apos; tracks match at no time offset, frame rate or pause tried, so the videos may be of different runs</source>
        <translation>在尝试的任何时间偏移、帧率或暂停下，各视图的轨迹都不吻合，视频可能来自不同的运行</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_disagrees</name>
    <message>
        <source>the motion gives a time offset of %1, the flash of light gives %2; the motion was used</source>
        <translation>由运动得偏移 %1（已采用），由闪光得 %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_lights</name>
    <message>
        <source>flash the room lights once while both cameras record, or give --sync SECONDS</source>
        <translation>请在两台相机录制时闪一次室内灯，或给出偏移</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_or_clap</name>
    <message>
        <source>flash the room lights or clap twice while both cameras record, or give --sync SECONDS</source>
        <translation>请在两台相机录制时闪一下室内灯或拍两次手，或给出偏移</translation>
    </message>
</context>
<context>
    <name>synchronisation.flashes_fit_alike</name>
    <message>
        <source>the flashes of light fit equally well at time offsets of %1 and %2</source>
        <translation>闪光在偏移 %1 和 %2 处同样吻合</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_flash</name>
    <message>
        <source>measured by a flash of light to only ±%1, because %2</source>
        <translation>由闪光得出，仅精确到 %1，因为%2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_sound</name>
    <message>
        <source>measured by the sound to only ±%1, because %2</source>
        <translation>由声音得出，仅精确到 ±%1，因为%2</translation>
    </message>
</context>
<context>
    <name>synchronisation.light_flickers</name>
    <message>
        <source>the light flickers</source>
        <translation>光线在闪烁</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_repeats</name>
    <message>
        <source>the motion repeats itself</source>
        <translation>运动是重复的</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_too_even</name>
    <message>
        <source>the robot turned and changed its speed too little to give the time offset</source>
        <translation>机器人的转向和速度变化太小，无法确定时间偏移</translation>
    </message>
</context>
<context>
    <name>synchronisation.neither_tells</name>
    <message>
        <source>%1, and %2</source>
        <translation>%1，并且%2</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_flash</name>
    <message>
        <source>neither view shows a flash of light</source>
        <translation>两个视角都没有闪光</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_loud_sound</name>
    <message>
        <source>no clap, knock or whistle is heard clearly in both clips</source>
        <translation>两段视频的声音中都没有突出的拍手、敲击或哨声</translation>
    </message>
</context>
<context>
    <name>synchronisation.none_tells</name>
    <message>
        <source>%1, %2, and %3</source>
        <translation>%1，%2，并且%3</translation>
    </message>
</context>
<context>
    <name>synchronisation.of_clips</name>
    <message>
        <source>synchronisation of the clips</source>
        <translation>视频的同步</translation>
    </message>
</context>
<context>
    <name>synchronisation.offset</name>
    <message>
        <source>%1 ±%2</source>
        <translation>%1 ±%2</translation>
    </message>
</context>
<context>
    <name>synchronisation.offsets_fit_alike</name>
    <message>
        <source>time offsets of %1 and %2 fit equally well</source>
        <translation>偏移 %1 和 %2 同样吻合</translation>
    </message>
</context>
<context>
    <name>synchronisation.one_flash</name>
    <message>
        <source>only one of the views shows a flash of light</source>
        <translation>只有一个视角有闪光</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_flashes</name>
    <message>
        <source>the flashes of light in the views do not match</source>
        <translation>各视角的闪光互不对应</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_sounds</name>
    <message>
        <source>the loud sounds of the clips do not match</source>
        <translation>各段视频中的响声互不对应</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_ran_straight</name>
    <message>
        <source>the robot ran straight at constant speed, so every time offset fits</source>
        <translation>机器人匀速直线行驶，因此任何时间偏移都符合</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_rested</name>
    <message>
        <source>the robot stood still, so every time offset fits</source>
        <translation>机器人静止不动，因此任何时间偏移都符合</translation>
    </message>
</context>
<context>
    <name>synchronisation.robots_disagree</name>
    <message>
        <source>robot %1 gives a time offset of %2, robot %3 gives %4; the second was used</source>
        <translation>机器人 %1 给出的偏移为 %2，机器人 %3 为 %4，采用后者</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_seen</name>
    <message>
        <source>one view saw the robot in fewer than %1 frames</source>
        <translation>有一个视角看到机器人的画面少于 %1 幅</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_together</name>
    <message>
        <source>the views rarely saw the robot at the same time</source>
        <translation>各视角几乎从未同时看到机器人</translation>
    </message>
</context>
<context>
    <name>synchronisation.short_overlap</name>
    <message>
        <source>the views seem to have only %1 in common, which is too short to be sure</source>
        <translation>各视图似乎只有 %1 是共同的，太短而无法确定</translation>
    </message>
</context>
<context>
    <name>synchronisation.sound_beats</name>
    <message>
        <source>the sound is full of beats that are alike, as in music</source>
        <translation>声音中充满相似的节拍，如同音乐</translation>
    </message>
</context>
<context>
    <name>synchronisation.sounds_fit_alike</name>
    <message>
        <source>the sounds of the clips fit equally well at time offsets of %1 and %2</source>
        <translation>各段视频的声音在偏移 %1 和 %2 处同样吻合</translation>
    </message>
</context>
<context>
    <name>synchronisation.views_distorted</name>
    <message>
        <source>the views show the same run, but with another size or direction: a camera has moved since its registration, or the videos are exchanged</source>
        <translation>各视图显示同一次运行，但大小或方向不同：相机在配准后移动过，或视频互换了</translation>
    </message>
</context>
<context>
    <name>synchronisation.ways_disagree</name>
    <message>
        <source>the time offsets found disagree: %1; the first was used</source>
        <translation>求得的偏移不一致：%1；已采用第一个</translation>
    </message>
</context>
<context>
    <name>tracking.add_robot</name>
    <message>
        <source>add a robot with its colour first</source>
        <translation>请先添加机器人及其颜色</translation>
    </message>
</context>
<context>
    <name>tracking.add_without_colour</name>
    <message>
        <source>add the robot without a colour; background subtraction then finds it</source>
        <translation>请添加没有颜色的机器人，这样会按它与地面的差别来寻找</translation>
    </message>
</context>
<context>
    <name>tracking.box_is_grey</name>
    <message>
        <source>the robot in it is grey, black or white</source>
        <translation>与周围地面不同的部分是灰、黑或白色</translation>
    </message>
</context>
<context>
    <name>tracking.box_leaves_nothing</name>
    <message>
        <source>the box leaves no floor around it to compare with</source>
        <translation>框外没有可供比较的地面</translation>
    </message>
</context>
<context>
    <name>tracking.box_too_small</name>
    <message>
        <source>the box is too small or outside the image</source>
        <translation>框太小，或在画面之外</translation>
    </message>
</context>
<context>
    <name>tracking.box_without_colour</name>
    <message>
        <source>it contains no colour that differs from the floor around it</source>
        <translation>其中没有与周围地面不同的颜色</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track</name>
    <message>
        <source>Cannot track</source>
        <translation>无法跟踪</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track_robot</name>
    <message>
        <source>Cannot track robot %1</source>
        <translation>无法跟踪机器人 %1</translation>
    </message>
</context>
<context>
    <name>tracking.colour_in_box</name>
    <message>
        <source>colour in the box</source>
        <translation>框内的颜色</translation>
    </message>
</context>
<context>
    <name>tracking.colour_is_grey</name>
    <message>
        <source>its colour %1 is grey, and tracking by colour needs a hue that differs from the floor</source>
        <translation>其颜色 %1 为灰色，而只有色相能把机器人与地面区分</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_closely</name>
    <message>
        <source>draw it closely round the robot</source>
        <translation>请紧贴机器人画框</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_larger</name>
    <message>
        <source>draw it round the robot, at least 8 pixels wide and high</source>
        <translation>请围着机器人画框，宽高至少 8 像素</translation>
    </message>
</context>
<context>
    <name>tracking.no_robot_given</name>
    <message>
        <source>no robot is given</source>
        <translation>没有给出机器人</translation>
    </message>
</context>
<context>
    <name>tracking.put_plate_on_it</name>
    <message>
        <source>draw it closely round the robot, or put a plate of another colour on it</source>
        <translation>请紧贴机器人画框，或在其上放另一种颜色的板</translation>
    </message>
</context>
<context>
    <name>tracking.tell_no_colour</name>
    <message>
        <source>set no colour; background subtraction then finds it</source>
        <translation>不要指定颜色，这样会按它与地面的差别来寻找</translation>
    </message>
</context>
<context>
    <name>trajectory.add_view</name>
    <message>
        <source>add a second view, or set one height for the robot</source>
        <translation>请增加第二个视角，或给出机器人的高度</translation>
    </message>
</context>
<context>
    <name>trajectory.analysing_position</name>
    <message>
        <source>analysing position %1</source>
        <translation>正在分析位置 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.camera_not_registered</name>
    <message>
        <source>camera %1 is not registered to the floor</source>
        <translation>相机 %1 未配准到地面</translation>
    </message>
</context>
<context>
    <name>trajectory.cameras_not_registered</name>
    <message>
        <source>cameras %1 are not registered to the floor</source>
        <translation>相机 %1 未配准到地面</translation>
    </message>
</context>
<context>
    <name>trajectory.centre_reference</name>
    <message>
        <source>set its reference point to 0,0 and track again</source>
        <translation>请把参考点设为 0,0 后重新跟踪</translation>
    </message>
</context>
<context>
    <name>trajectory.check_robot_and_light</name>
    <message>
        <source>check that the robot moves in the video, that its colour, if set, matches the video, and that the light is sufficient</source>
        <translation>请检查机器人在画面中是否移动、指定的颜色是否与画面中的一致、光线是否充足</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_track</name>
    <message>
        <source>choose a track with more positions</source>
        <translation>请选择位置更多的轨迹</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_video</name>
    <message>
        <source>choose a longer video, or check the robot&apos;s colour and the light</source>
        <translation>请选择更长的视频，或检查机器人的颜色和光线</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_edge</name>
    <message>
        <source>cut by the frame&apos;s edge</source>
        <translation>被画面边缘截断</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_frames_edge</name>
    <message>
        <source>cut by the frame&apos;s edge in view %1</source>
        <translation>在视角 %1 中被画面边缘截断</translation>
    </message>
</context>
<context>
    <name>trajectory.faster_than_limit</name>
    <message>
        <source>speed above the limit</source>
        <translation>超过速度限值</translation>
    </message>
</context>
<context>
    <name>trajectory.figures_of_seen</name>
    <message>
        <source>the metrics cover only the measured part</source>
        <translation>指标只针对被看到的部分</translation>
    </message>
</context>
<context>
    <name>trajectory.frames_that_tell</name>
    <message>
        <source>only %2 of %1 frames give a usable position</source>
        <translation>%1 帧中有 %2 帧给出可用的位置</translation>
    </message>
</context>
<context>
    <name>trajectory.harder_than_limit</name>
    <message>
        <source>acceleration above the limit</source>
        <translation>超过加速度限值</translation>
    </message>
</context>
<context>
    <name>trajectory.heading_unknown</name>
    <message>
        <source>its reference point is not the centre of its footprint, but its outlines do not show its heading</source>
        <translation>其参考点偏离中心，但其轮廓无法给出朝向</translation>
    </message>
</context>
<context>
    <name>trajectory.hidden_behind</name>
    <message>
        <source>hidden behind %1 in view %2</source>
        <translation>在视角 %2 中被 %1 遮挡</translation>
    </message>
</context>
<context>
    <name>trajectory.import_exchanged</name>
    <message>
        <source>import them again, each for its own camera</source>
        <translation>请重新导入,每个视频对应各自的相机</translation>
    </message>
</context>
<context>
    <name>trajectory.import_video</name>
    <message>
        <source>import at least one video for it</source>
        <translation>请至少为其导入一个视频</translation>
    </message>
</context>
<context>
    <name>trajectory.jump</name>
    <message>
        <source>jump</source>
        <translation>跳跃</translation>
    </message>
</context>
<context>
    <name>trajectory.jump_of</name>
    <message>
        <source>jump of %1</source>
        <translation>跳跃 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.look_and_register</name>
    <message>
        <source>check the outlines, and register the cameras again</source>
        <translation>请查看轮廓，并重新配准相机</translation>
    </message>
</context>
<context>
    <name>trajectory.move_camera</name>
    <message>
        <source>move or add a camera to cover the whole task</source>
        <translation>请移动或增加相机，使整个任务都能被看到</translation>
    </message>
</context>
<context>
    <name>trajectory.no_such_smoother</name>
    <message>
        <source>no smoother has this name</source>
        <translation>没有此名称</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view</name>
    <message>
        <source>the trial has no view</source>
        <translation>试验没有视角</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view_trusted</name>
    <message>
        <source>none could be trusted</source>
        <translation>没有一个可信</translation>
    </message>
</context>
<context>
    <name>trajectory.not_enough_data</name>
    <message>
        <source>not enough data</source>
        <translation>数据不足</translation>
    </message>
</context>
<context>
    <name>trajectory.not_visible</name>
    <message>
        <source>not visible in view %1</source>
        <translation>在视角 %1 中不可见</translation>
    </message>
</context>
<context>
    <name>trajectory.occlusion_span</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1（%2 至 %3）</translation>
    </message>
</context>
<context>
    <name>trajectory.one_outline</name>
    <message>
        <source>outline merged with %1 in view %2</source>
        <translation>在视角 %2 中与 %1 连成一个轮廓</translation>
    </message>
</context>
<context>
    <name>trajectory.only_unregistered</name>
    <message>
        <source>only cameras that are not registered to the floor saw the robot</source>
        <translation>只有未配准的相机看到了机器人</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_larger</name>
    <message>
        <source>outline larger than usual in view %1</source>
        <translation>在视角 %1 中轮廓比平时大</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_smaller</name>
    <message>
        <source>outline smaller than usual in view %1</source>
        <translation>在视角 %1 中轮廓比平时小</translation>
    </message>
</context>
<context>
    <name>trajectory.partly_hidden_behind</name>
    <message>
        <source>partly hidden behind %1 in view %2</source>
        <translation>在视角 %2 中被 %1 部分遮挡</translation>
    </message>
</context>
<context>
    <name>trajectory.path_not_measured</name>
    <message>
        <source>the robot&apos;s path cannot be measured</source>
        <translation>无法测量机器人的路径</translation>
    </message>
</context>
<context>
    <name>trajectory.register_one</name>
    <message>
        <source>run odograph register for at least one of them</source>
        <translation>请至少配准其中一台</translation>
    </message>
</context>
<context>
    <name>trajectory.register_them</name>
    <message>
        <source>run odograph register for them</source>
        <translation>请配准它们</translation>
    </message>
</context>
<context>
    <name>trajectory.robot_not_found</name>
    <message>
        <source>the robot was not found in any frame of %1</source>
        <translation>在 %1 的任何画面中都没有找到机器人</translation>
    </message>
</context>
<context>
    <name>trajectory.seldom_together</name>
    <message>
        <source>its height is set to be triangulated, but two registered views rarely saw it at the same time</source>
        <translation>需三角测量其高度，但两个已配准视角几乎没有同时看到它</translation>
    </message>
</context>
<context>
    <name>trajectory.smoother</name>
    <message>
        <source>smoother %1</source>
        <translation>平滑器 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.spike_by_hand</name>
    <message>
        <source>marked as a spike by hand</source>
        <translation>由人标为异常点</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_both</name>
    <message>
        <source>spike in position and speed</source>
        <translation>位置和速度突出</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_position</name>
    <message>
        <source>spike in position</source>
        <translation>位置突出</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_speed</name>
    <message>
        <source>spike in speed</source>
        <translation>速度突出</translation>
    </message>
</context>
<context>
    <name>trajectory.track_first</name>
    <message>
        <source>track the trial&apos;s videos first</source>
        <translation>请先跟踪该试验的视频</translation>
    </message>
</context>
<context>
    <name>trajectory.tracker_unsure</name>
    <message>
        <source>the tracker was not sure (score %1)</source>
        <translation>跟踪器不确定（得分 %1）</translation>
    </message>
</context>
<context>
    <name>trajectory.unmeasured_between</name>
    <message>
        <source>nothing was measured from %1 to %2</source>
        <translation>从 %1 到 %2 没有任何测量</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_after</name>
    <message>
        <source>no view sees it after %1 (it was at X %2, Y %3)</source>
        <translation>%1 之后没有视角看见它（当时在 X %2，Y %3）</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_between</name>
    <message>
        <source>no view sees it from %1 to %2 (it was at X %3, Y %4)</source>
        <translation>从 %1 到 %2 没有视角看见它（当时在 X %3，Y %4）</translation>
    </message>
</context>
<context>
    <name>trajectory.use_smoother</name>
    <message>
        <source>use rts, savgol, tracker or none</source>
        <translation>请使用 rts、savgol、tracker 或 none</translation>
    </message>
</context>
<context>
    <name>trajectory.view_left_out</name>
    <message>
        <source>one left out</source>
        <translation>舍去了一个</translation>
    </message>
</context>
<context>
    <name>trajectory.view_without_frame</name>
    <message>
        <source>view %1 has no frame</source>
        <translation>视角 %1 没有帧</translation>
    </message>
</context>
<context>
    <name>trajectory.views_apart</name>
    <message>
        <source>the views&apos; floor positions differ by %1</source>
        <translation>各视角给出的位置相差 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.views_disagree</name>
    <message>
        <source>views disagree by %1</source>
        <translation>视角之间相差 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.views_exchanged</name>
    <message>
        <source>the videos of %1 and %2 seem to be exchanged: exchanged, they agree</source>
        <translation>%1 和 %2 的视频似乎互换了:互换后二者一致</translation>
    </message>
</context>
<context>
    <name>trajectory.why_views_apart</name>
    <message>
        <source>a camera has moved since it was registered, the videos belong to other cameras, or one view follows something else</source>
        <translation>某台相机在配准后被移动、视频属于其他相机，或某个视角跟踪了别的东西</translation>
    </message>
</context>
<context>
    <name>ui.add_camera</name>
    <message>
        <source>add camera %1</source>
        <translation>添加相机 %1</translation>
    </message>
</context>
<context>
    <name>ui.add_class</name>
    <message>
        <source>add class %1</source>
        <translation>添加班级 %1</translation>
    </message>
</context>
<context>
    <name>ui.add_layout</name>
    <message>
        <source>add layout %1</source>
        <translation>添加布局 %1</translation>
    </message>
</context>
<context>
    <name>ui.add_robot</name>
    <message>
        <source>add robot %1</source>
        <translation>添加机器人 %1</translation>
    </message>
</context>
<context>
    <name>ui.add_task</name>
    <message>
        <source>add task %1</source>
        <translation>添加任务 %1</translation>
    </message>
</context>
<context>
    <name>ui.add_team</name>
    <message>
        <source>add team %1</source>
        <translation>添加小组 %1</translation>
    </message>
</context>
<context>
    <name>ui.adding_strays</name>
    <message>
        <source>Adding stray videos as trials</source>
        <translation>正在将无归属的视频添加为试验</translation>
    </message>
</context>
<context>
    <name>ui.address_not_here</name>
    <message>
        <source>it is no address of this computer</source>
        <translation>它不是此电脑的地址</translation>
    </message>
</context>
<context>
    <name>ui.and_more</name>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 个</translation>
    </message>
</context>
<context>
    <name>ui.annotated_video</name>
    <message>
        <source>annotated video of &apos;%1&apos;</source>
        <translation>“%1”的带标注视频</translation>
    </message>
</context>
<context>
    <name>ui.another_job_runs</name>
    <message>
        <source>another job is running</source>
        <translation>另一项操作正在进行</translation>
    </message>
</context>
<context>
    <name>ui.archive_class</name>
    <message>
        <source>archive class %1</source>
        <translation>归档班级 %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_task</name>
    <message>
        <source>archive task %1</source>
        <translation>归档任务 %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_trial</name>
    <message>
        <source>archive %1</source>
        <translation>归档 %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_trials</name>
    <message>
        <source>archive %1 trials</source>
        <translation>归档 %1 次试验</translation>
    </message>
</context>
<context>
    <name>ui.backup_is_sound</name>
    <message>
        <source>its backup of %1 is intact; it does not contain later changes</source>
        <translation>其 %1 的备份完好；此后所做的不在其中</translation>
    </message>
</context>
<context>
    <name>ui.board_has_corners</name>
    <message>
        <source>a board has 3 to 30 inner corners each way</source>
        <translation>标定板每个方向有 3 至 30 个内角点</translation>
    </message>
</context>
<context>
    <name>ui.bring_file_back</name>
    <message>
        <source>move the file back there</source>
        <translation>请将文件放回原处</translation>
    </message>
</context>
<context>
    <name>ui.calibrate_other_first</name>
    <message>
        <source>calibrate the other one, or import a trial with it, first</source>
        <translation>请先标定另一台相机，或导入用它录制的试验</translation>
    </message>
</context>
<context>
    <name>ui.camera_named</name>
    <message>
        <source>camera %1</source>
        <translation>相机 %1</translation>
    </message>
</context>
<context>
    <name>ui.cameras</name>
    <message>
        <source>the cameras</source>
        <translation>相机</translation>
    </message>
</context>
<context>
    <name>ui.cannot_make_another</name>
    <message>
        <source>cannot create another project</source>
        <translation>无法新建另一个项目</translation>
    </message>
</context>
<context>
    <name>ui.cannot_open_another</name>
    <message>
        <source>cannot open another project</source>
        <translation>无法打开另一个项目</translation>
    </message>
</context>
<context>
    <name>ui.change_pseudonym</name>
    <message>
        <source>change the pseudonym of team %1</source>
        <translation>更改小组 %1 的化名</translation>
    </message>
</context>
<context>
    <name>ui.change_robot</name>
    <message>
        <source>change robot %1</source>
        <translation>更改机器人 %1</translation>
    </message>
</context>
<context>
    <name>ui.change_tags</name>
    <message>
        <source>change the tags of %1</source>
        <translation>更改 %1 的标签</translation>
    </message>
</context>
<context>
    <name>ui.change_task</name>
    <message>
        <source>change task %1</source>
        <translation>更改任务 %1</translation>
    </message>
</context>
<context>
    <name>ui.change_team</name>
    <message>
        <source>change members and robots of team %1</source>
        <translation>更改小组 %1 的成员和机器人</translation>
    </message>
</context>
<context>
    <name>ui.charuco_numbered_in_two_ways</name>
    <message>
        <source>programs number a ChArUco board with %1 rows of squares in two different ways</source>
        <translation>有 %1 行方格的 ChArUco 板，不同程序有两种编号方式</translation>
    </message>
</context>
<context>
    <name>ui.check_hub</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network</source>
        <translation>请检查地址、~/.pgpass 中的登录信息和网络</translation>
    </message>
</context>
<context>
    <name>ui.choose_another_port</name>
    <message>
        <source>choose another port, or 0 for any that is free</source>
        <translation>选择其他端口，或用 0 表示任意空闲端口</translation>
    </message>
</context>
<context>
    <name>ui.choose_high_port</name>
    <message>
        <source>choose a port of 1024 or more</source>
        <translation>选择 1024 或更大的端口</translation>
    </message>
</context>
<context>
    <name>ui.choose_logo</name>
    <message>
        <source>choose a PNG, JPEG or SVG image</source>
        <translation>请选择 PNG、JPEG 或 SVG 图片</translation>
    </message>
</context>
<context>
    <name>ui.choose_or_make_class</name>
    <message>
        <source>choose one of them, or create it in the workbench</source>
        <translation>请选择其中之一，或在工作台中创建</translation>
    </message>
</context>
<context>
    <name>ui.choose_own_address</name>
    <message>
        <source>choose 127.0.0.1, an address of this computer, or 0.0.0.0 for all of them</source>
        <translation>选择 127.0.0.1、此电脑的一个地址，或用 0.0.0.0 表示全部</translation>
    </message>
</context>
<context>
    <name>ui.choose_recorded</name>
    <message>
        <source>choose one that was recorded</source>
        <translation>请选择有录像的试验</translation>
    </message>
</context>
<context>
    <name>ui.choose_trial_or_class</name>
    <message>
        <source>choose a trial or a class</source>
        <translation>请选择一次试验或一个班级</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_size</name>
    <message>
        <source>choose another, such as 1920x1080</source>
        <translation>请另选一个，如 1920x1080</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_speed</name>
    <message>
        <source>choose another, such as 0.25</source>
        <translation>请另选一个，如 0.25</translation>
    </message>
</context>
<context>
    <name>ui.clips_being_read</name>
    <message>
        <source>those dropped before are still being read</source>
        <translation>先前拖放的视频仍在读取中</translation>
    </message>
</context>
<context>
    <name>ui.completing_recording</name>
    <message>
        <source>Completing an interrupted recording</source>
        <translation>正在补全被中断的录像</translation>
    </message>
</context>
<context>
    <name>ui.connect_camera</name>
    <message>
        <source>connect camera %1</source>
        <translation>连接相机 %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_class</name>
    <message>
        <source>delete class %1</source>
        <translation>删除班级 %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_robot</name>
    <message>
        <source>delete robot %1</source>
        <translation>删除机器人 %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_task</name>
    <message>
        <source>delete task %1</source>
        <translation>删除任务 %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_team</name>
    <message>
        <source>delete team %1</source>
        <translation>删除小组 %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_trial</name>
    <message>
        <source>delete %1</source>
        <translation>删除 %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_trials</name>
    <message>
        <source>delete %1 trials</source>
        <translation>删除 %1 次试验</translation>
    </message>
</context>
<context>
    <name>ui.does_not_fit_on</name>
    <message>
        <source>%1 by %2 do not fit on %3</source>
        <translation>%1 × %2 在 %3 上放不下</translation>
    </message>
</context>
<context>
    <name>ui.drop_again</name>
    <message>
        <source>drop them again in a moment</source>
        <translation>请稍后再次拖放</translation>
    </message>
</context>
<context>
    <name>ui.dropped_clips</name>
    <message>
        <source>the dropped clips</source>
        <translation>拖放的视频</translation>
    </message>
</context>
<context>
    <name>ui.emptying_bin</name>
    <message>
        <source>Emptying the bin</source>
        <translation>正在清空回收站</translation>
    </message>
</context>
<context>
    <name>ui.export_of</name>
    <message>
        <source>export of %1</source>
        <translation>导出 %1</translation>
    </message>
</context>
<context>
    <name>ui.exported_trials</name>
    <message>
        <source>Exported trials: %1 of %2</source>
        <translation>已导出试验：%1，共 %2</translation>
    </message>
</context>
<context>
    <name>ui.exporting</name>
    <message>
        <source>Exporting %1 (%2 of %3)</source>
        <translation>正在导出 %1（第 %2 个，共 %3 个）</translation>
    </message>
</context>
<context>
    <name>ui.finding_mat</name>
    <message>
        <source>Finding the floor mat</source>
        <translation>正在查找地垫</translation>
    </message>
</context>
<context>
    <name>ui.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>地垫</translation>
    </message>
</context>
<context>
    <name>ui.give_board_size</name>
    <message>
        <source>give a size such as 9x6</source>
        <translation>请给出如 9x6 的尺寸</translation>
    </message>
</context>
<context>
    <name>ui.give_marker_size</name>
    <message>
        <source>give its size, such as 150mm</source>
        <translation>请给出其尺寸，如 150mm</translation>
    </message>
</context>
<context>
    <name>ui.give_mat_size</name>
    <message>
        <source>give a size such as 4x3</source>
        <translation>请给出如 4x3 的尺寸</translation>
    </message>
</context>
<context>
    <name>ui.give_square_side</name>
    <message>
        <source>give the side of a square, such as 25mm</source>
        <translation>请给出方格的边长，如 25mm</translation>
    </message>
</context>
<context>
    <name>ui.html_page</name>
    <message>
        <source>page</source>
        <translation>页面</translation>
    </message>
</context>
<context>
    <name>ui.hub_away</name>
    <message>
        <source>it cannot be reached</source>
        <translation>无法连接</translation>
    </message>
</context>
<context>
    <name>ui.hub_goes_on</name>
    <message>
        <source>the page shows the last standings until it is back</source>
        <translation>在恢复之前，页面显示最后的排名</translation>
    </message>
</context>
<context>
    <name>ui.hub_silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>服务器没有响应</translation>
    </message>
</context>
<context>
    <name>ui.import_or_record_first</name>
    <message>
        <source>import or record one first</source>
        <translation>请先导入或录制一次试验</translation>
    </message>
</context>
<context>
    <name>ui.importing</name>
    <message>
        <source>Importing %1</source>
        <translation>正在导入 %1</translation>
    </message>
</context>
<context>
    <name>ui.importing_trials</name>
    <message>
        <source>Importing %1 (%2 of %3)</source>
        <translation>正在导入 %1（第 %2 个，共 %3 个）</translation>
    </message>
</context>
<context>
    <name>ui.is_printer_ready</name>
    <message>
        <source>check that the printer is ready</source>
        <translation>请查看打印机是否就绪</translation>
    </message>
</context>
<context>
    <name>ui.job_runs_on_project</name>
    <message>
        <source>a job is running on the project</source>
        <translation>项目上有操作正在进行</translation>
    </message>
</context>
<context>
    <name>ui.lens_of_other_size</name>
    <message>
        <source>its size is %1×%2, but the lens was calibrated at %3×%4</source>
        <translation>其尺寸为 %1×%2，但镜头是在 %3×%4 下测量的</translation>
    </message>
</context>
<context>
    <name>ui.logo</name>
    <message>
        <source>logo &apos;%1&apos;</source>
        <translation>校徽“%1”</translation>
    </message>
</context>
<context>
    <name>ui.logo_too_large</name>
    <message>
        <source>it is larger than a hundred megapixels</source>
        <translation>超过 1 亿像素</translation>
    </message>
</context>
<context>
    <name>ui.look_at_printer</name>
    <message>
        <source>check the printer and its queue, or save the report as PDF</source>
        <translation>请检查打印机及其队列，或将报告保存为 PDF</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_lost</name>
    <message>
        <source>Searching for lost videos</source>
        <translation>正在查找丢失的视频</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_strays</name>
    <message>
        <source>Searching for stray files</source>
        <translation>正在查找无归属的文件</translation>
    </message>
</context>
<context>
    <name>ui.make_marker_smaller</name>
    <message>
        <source>make it at most %1, or use larger paper</source>
        <translation>请使其不超过 %1，或使用更大的纸</translation>
    </message>
</context>
<context>
    <name>ui.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>请缩小</translation>
    </message>
</context>
<context>
    <name>ui.make_squares_smaller</name>
    <message>
        <source>make the squares at most %1, or use larger paper</source>
        <translation>请使方格不超过 %1，或使用更大的纸</translation>
    </message>
</context>
<context>
    <name>ui.making_certificate</name>
    <message>
        <source>Simulating the set-up</source>
        <translation>正在模拟设置</translation>
    </message>
</context>
<context>
    <name>ui.making_demo</name>
    <message>
        <source>Creating the demo lesson</source>
        <translation>正在生成演示课</translation>
    </message>
</context>
<context>
    <name>ui.making_hashes</name>
    <message>
        <source>Computing the hashes of new recordings</source>
        <translation>正在计算新录像的哈希值</translation>
    </message>
</context>
<context>
    <name>ui.making_report</name>
    <message>
        <source>Creating the report</source>
        <translation>正在生成报告</translation>
    </message>
</context>
<context>
    <name>ui.making_video</name>
    <message>
        <source>Creating the video of %1</source>
        <translation>正在生成 %1 的视频</translation>
    </message>
</context>
<context>
    <name>ui.making_videos</name>
    <message>
        <source>Creating the video of %1 (%2 of %3)</source>
        <translation>正在生成 %1 的视频（第 %2 个，共 %3 个）</translation>
    </message>
</context>
<context>
    <name>ui.many_trials</name>
    <message>
        <source>many trials</source>
        <translation>多次试验</translation>
    </message>
</context>
<context>
    <name>ui.mat_has_sheets</name>
    <message>
        <source>a mat has 1 to %1 sheets in a row and 1 to %2 rows</source>
        <translation>地垫每行 1 到 %1 张纸，共 1 到 %2 行</translation>
    </message>
</context>
<context>
    <name>ui.measuring_again</name>
    <message>
        <source>Reanalysing %1</source>
        <translation>正在重新测量 %1</translation>
    </message>
</context>
<context>
    <name>ui.measuring_trials_again</name>
    <message>
        <source>Reanalysing %1 (%2 of %3)</source>
        <translation>正在重新测量 %1（第 %2 个，共 %3 个）</translation>
    </message>
</context>
<context>
    <name>ui.mend_and_choose_again</name>
    <message>
        <source>correct the listed errors, then select these trials again</source>
        <translation>请先解决上述问题，再重新选择这些试验</translation>
    </message>
</context>
<context>
    <name>ui.move_team</name>
    <message>
        <source>move team %1 to class %2</source>
        <translation>将小组 %1 移至班级 %2</translation>
    </message>
</context>
<context>
    <name>ui.name_one_marker</name>
    <message>
        <source>name at least one, for example O</source>
        <translation>请至少指定一个，如 O</translation>
    </message>
</context>
<context>
    <name>ui.no_camera_registered</name>
    <message>
        <source>no camera is registered yet</source>
        <translation>尚未配准任何相机</translation>
    </message>
</context>
<context>
    <name>ui.no_further_page</name>
    <message>
        <source>it accepts no more pages</source>
        <translation>它不再接收页面</translation>
    </message>
</context>
<context>
    <name>ui.no_marker_to_print</name>
    <message>
        <source>no marker to print</source>
        <translation>没有可打印的标记</translation>
    </message>
</context>
<context>
    <name>ui.no_page</name>
    <message>
        <source>it has no page</source>
        <translation>它没有页面</translation>
    </message>
</context>
<context>
    <name>ui.no_project_open</name>
    <message>
        <source>no project is open</source>
        <translation>没有打开的项目</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos;</source>
        <translation>其小组都没有具有指标“%1”的运行</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure_in_task</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos; in the task &apos;%2&apos;</source>
        <translation>其小组在任务“%2”中都没有具有指标“%1”的运行</translation>
    </message>
</context>
<context>
    <name>ui.no_trial_yet</name>
    <message>
        <source>the project has no trial yet</source>
        <translation>尚无试验</translation>
    </message>
</context>
<context>
    <name>ui.not_printed</name>
    <message>
        <source>it could not be printed</source>
        <translation>无法打印</translation>
    </message>
</context>
<context>
    <name>ui.nothing_changed_here</name>
    <message>
        <source>no change was made here</source>
        <translation>此处未作任何更改</translation>
    </message>
</context>
<context>
    <name>ui.only_be_read</name>
    <message>
        <source>this project is read-only</source>
        <translation>此项目只能读取</translation>
    </message>
</context>
<context>
    <name>ui.only_one_camera</name>
    <message>
        <source>the project has only one camera</source>
        <translation>只有一台相机</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_charuco_markers</name>
    <message>
        <source>only 250 markers exist for a ChArUco board</source>
        <translation>ChArUco 板只有 250 个标记可用</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_tags</name>
    <message>
        <source>only %1 tags exist</source>
        <translation>标签码只有 %1 个</translation>
    </message>
</context>
<context>
    <name>ui.open_its_project</name>
    <message>
        <source>open the project that it belongs to</source>
        <translation>请打开它所属的项目</translation>
    </message>
</context>
<context>
    <name>ui.open_project_first</name>
    <message>
        <source>open or create a project first</source>
        <translation>请先打开或新建项目</translation>
    </message>
</context>
<context>
    <name>ui.opening</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
</context>
<context>
    <name>ui.packing</name>
    <message>
        <source>Packing the project</source>
        <translation>正在打包项目</translation>
    </message>
</context>
<context>
    <name>ui.page_of_trial</name>
    <message>
        <source>page of trial &apos;%1&apos;</source>
        <translation>试验“%1”的页面</translation>
    </message>
</context>
<context>
    <name>ui.pages_not_taken</name>
    <message>
        <source>it did not accept the pages</source>
        <translation>它没有接收这些页面</translation>
    </message>
</context>
<context>
    <name>ui.painting_floor</name>
    <message>
        <source>drawing the floor</source>
        <translation>绘制地面</translation>
    </message>
</context>
<context>
    <name>ui.picture</name>
    <message>
        <source>the image</source>
        <translation>图片</translation>
    </message>
</context>
<context>
    <name>ui.picture_of</name>
    <message>
        <source>frame %1 of %2</source>
        <translation>第 %1 幅，共 %2 幅</translation>
    </message>
</context>
<context>
    <name>ui.port_in_use</name>
    <message>
        <source>another program uses this port</source>
        <translation>另一个程序正在使用此端口</translation>
    </message>
</context>
<context>
    <name>ui.port_not_allowed</name>
    <message>
        <source>the system does not allow this port</source>
        <translation>系统不允许使用此端口</translation>
    </message>
</context>
<context>
    <name>ui.preview</name>
    <message>
        <source>preview</source>
        <translation>预览</translation>
    </message>
</context>
<context>
    <name>ui.print_fewer_markers</name>
    <message>
        <source>print fewer markers</source>
        <translation>请少打印一些标记</translation>
    </message>
</context>
<context>
    <name>ui.printer_not_reached</name>
    <message>
        <source>it cannot be reached</source>
        <translation>无法连接</translation>
    </message>
</context>
<context>
    <name>ui.printing_on</name>
    <message>
        <source>printing on &apos;%1&apos;</source>
        <translation>在“%1”上打印</translation>
    </message>
</context>
<context>
    <name>ui.project_has_classes</name>
    <message>
        <source>the project has %1</source>
        <translation>项目中有 %1</translation>
    </message>
</context>
<context>
    <name>ui.project_has_no_class</name>
    <message>
        <source>the project has none</source>
        <translation>项目中没有班级</translation>
    </message>
</context>
<context>
    <name>ui.recording_not_there</name>
    <message>
        <source>the recording of camera %1 is not at &apos;%2&apos;</source>
        <translation>相机 %1 的录像不在“%2”</translation>
    </message>
</context>
<context>
    <name>ui.register_one_first</name>
    <message>
        <source>register one that sees the markers first</source>
        <translation>请先配准一台能看到标记的相机</translation>
    </message>
</context>
<context>
    <name>ui.registering</name>
    <message>
        <source>Registering camera %1</source>
        <translation>正在配准相机 %1</translation>
    </message>
</context>
<context>
    <name>ui.registration_through_another</name>
    <message>
        <source>registration via another camera</source>
        <translation>通过另一相机的配准</translation>
    </message>
</context>
<context>
    <name>ui.removing_strays</name>
    <message>
        <source>Removing stray files</source>
        <translation>正在移除无归属的文件</translation>
    </message>
</context>
<context>
    <name>ui.rename_class</name>
    <message>
        <source>rename class %1 to %2</source>
        <translation>将班级 %1 重命名为 %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_task</name>
    <message>
        <source>rename task %1 to %2</source>
        <translation>将任务 %1 重命名为 %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_team</name>
    <message>
        <source>rename team %1 to %2</source>
        <translation>将小组 %1 重命名为 %2</translation>
    </message>
</context>
<context>
    <name>ui.report</name>
    <message>
        <source>report</source>
        <translation>报告</translation>
    </message>
</context>
<context>
    <name>ui.report_file</name>
    <message>
        <source>report &apos;%1&apos;</source>
        <translation>报告“%1”</translation>
    </message>
</context>
<context>
    <name>ui.report_of_class</name>
    <message>
        <source>report of class &apos;%1&apos;</source>
        <translation>班级“%1”的报告</translation>
    </message>
</context>
<context>
    <name>ui.restoring_backup</name>
    <message>
        <source>Restoring the backup</source>
        <translation>正在恢复备份</translation>
    </message>
</context>
<context>
    <name>ui.save_again</name>
    <message>
        <source>save it again in a moment</source>
        <translation>请稍后再次保存</translation>
    </message>
</context>
<context>
    <name>ui.save_copy</name>
    <message>
        <source>save a copy and work on the copy</source>
        <translation>请保存副本，在副本上继续</translation>
    </message>
</context>
<context>
    <name>ui.saving_copy</name>
    <message>
        <source>Saving a copy</source>
        <translation>正在保存副本</translation>
    </message>
</context>
<context>
    <name>ui.saving_table</name>
    <message>
        <source>saving the table</source>
        <translation>保存表格</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_address</name>
    <message>
        <source>standings at %1 port %2</source>
        <translation>排名：%1 端口 %2</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_project_gone</name>
    <message>
        <source>it was moved or deleted, so the standings ended</source>
        <translation>它已被移动或删除，排名显示因此结束</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_start_again</name>
    <message>
        <source>start them with the file&apos;s present name</source>
        <translation>用文件现在的名称重新启动</translation>
    </message>
</context>
<context>
    <name>ui.size_is_no_length</name>
    <message>
        <source>its size is not a length</source>
        <translation>其尺寸不是长度</translation>
    </message>
</context>
<context>
    <name>ui.star_trial</name>
    <message>
        <source>star %1</source>
        <translation>为 %1 加星标</translation>
    </message>
</context>
<context>
    <name>ui.star_trials</name>
    <message>
        <source>star %1 trials</source>
        <translation>为 %1 次试验加星标</translation>
    </message>
</context>
<context>
    <name>ui.synchronising</name>
    <message>
        <source>Synchronising %1</source>
        <translation>正在同步 %1</translation>
    </message>
</context>
<context>
    <name>ui.table_being_saved</name>
    <message>
        <source>another table is still being saved</source>
        <translation>另一个表格仍在保存</translation>
    </message>
</context>
<context>
    <name>ui.take_at_that_resolution</name>
    <message>
        <source>use that resolution, or calibrate the lens again</source>
        <translation>请以该分辨率拍摄，或重新测量镜头</translation>
    </message>
</context>
<context>
    <name>ui.take_even_rows</name>
    <message>
        <source>use an even number of rows of inner corners, such as 9x6</source>
        <translation>请使用偶数行内角点，如 9x6</translation>
    </message>
</context>
<context>
    <name>ui.take_fewer_squares</name>
    <message>
        <source>use fewer squares</source>
        <translation>请减少方格数</translation>
    </message>
</context>
<context>
    <name>ui.take_team_out</name>
    <message>
        <source>remove team %1 from its class</source>
        <translation>将小组 %1 移出其班级</translation>
    </message>
</context>
<context>
    <name>ui.taking_over_setup</name>
    <message>
        <source>Copying the set-up</source>
        <translation>正在沿用设置</translation>
    </message>
</context>
<context>
    <name>ui.target</name>
    <message>
        <source>target</source>
        <translation>靶标</translation>
    </message>
</context>
<context>
    <name>ui.the_range</name>
    <message>
        <source>the range</source>
        <translation>区间</translation>
    </message>
</context>
<context>
    <name>ui.the_sample</name>
    <message>
        <source>the sample</source>
        <translation>采样点</translation>
    </message>
</context>
<context>
    <name>ui.the_trial</name>
    <message>
        <source>the trial</source>
        <translation>试验</translation>
    </message>
</context>
<context>
    <name>ui.track_or_choose_figure</name>
    <message>
        <source>track its trials, or choose another task or metric</source>
        <translation>请跟踪其试验，或选择其他任务或指标</translation>
    </message>
</context>
<context>
    <name>ui.tracking</name>
    <message>
        <source>Tracking %1</source>
        <translation>正在跟踪 %1</translation>
    </message>
</context>
<context>
    <name>ui.trial_without_recording</name>
    <message>
        <source>the trial has no recording</source>
        <translation>该试验没有录像</translation>
    </message>
</context>
<context>
    <name>ui.trials_imported</name>
    <message>
        <source>Trials imported: %1 of %2</source>
        <translation>已导入的试验：%1/%2</translation>
    </message>
</context>
<context>
    <name>ui.trials_measured_again</name>
    <message>
        <source>Trials reanalysed: %1 of %2</source>
        <translation>已重新测量试验：%1，共 %2</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_class</name>
    <message>
        <source>restore class %1 from the archive</source>
        <translation>取消归档班级 %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_task</name>
    <message>
        <source>restore task %1 from the archive</source>
        <translation>取消归档任务 %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trial</name>
    <message>
        <source>restore %1 from the archive</source>
        <translation>取消归档 %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trials</name>
    <message>
        <source>restore %1 trials from the archive</source>
        <translation>取消归档 %1 次试验</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trial</name>
    <message>
        <source>restore %1 from the bin</source>
        <translation>从回收站放回 %1</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trials</name>
    <message>
        <source>restore %1 trials from the bin</source>
        <translation>从回收站放回 %1 次试验</translation>
    </message>
</context>
<context>
    <name>ui.undo_in_menu</name>
    <message>
        <source>use the window&apos;s Edit menu to undo earlier changes</source>
        <translation>之前的更改请在窗口的“编辑”菜单中撤销</translation>
    </message>
</context>
<context>
    <name>ui.unpacking</name>
    <message>
        <source>Unpacking the project</source>
        <translation>正在解包项目</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trial</name>
    <message>
        <source>remove the star from %1</source>
        <translation>取消 %1 的星标</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trials</name>
    <message>
        <source>remove the star from %1 trials</source>
        <translation>取消 %1 次试验的星标</translation>
    </message>
</context>
<context>
    <name>ui.video_size_wrong</name>
    <message>
        <source>its size of %1x%2 has an odd number of pixels, or is not between 320x180 and 3840x2160</source>
        <translation>其尺寸 %1x%2 为奇数，或不在 320x180 至 3840x2160 之间</translation>
    </message>
</context>
<context>
    <name>ui.video_speed_wrong</name>
    <message>
        <source>its speed is not between 0.1 and 1</source>
        <translation>其速度不在 0.1 至 1 之间</translation>
    </message>
</context>
<context>
    <name>ui.videos_made</name>
    <message>
        <source>Videos created: %1 of %2</source>
        <translation>已生成视频：%1，共 %2</translation>
    </message>
</context>
<context>
    <name>ui.wait_or_cancel</name>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>请等它完成，或将其取消</translation>
    </message>
</context>
<context>
    <name>ui.write_notes</name>
    <message>
        <source>write notes of %1</source>
        <translation>编写 %1 的备注</translation>
    </message>
</context>
<context>
    <name>ui.writing_back</name>
    <message>
        <source>writing back</source>
        <translation>写回</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode</name>
    <message>
        <source>cannot decode the video</source>
        <translation>无法解码该视频</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_all</name>
    <message>
        <source>cannot decode all of a frame</source>
        <translation>无法完整解码一帧</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_frame</name>
    <message>
        <source>cannot decode frame %1 of %2</source>
        <translation>无法解码 %2 的第 %1 帧</translation>
    </message>
</context>
<context>
    <name>video.cannot_encode</name>
    <message>
        <source>cannot encode the video</source>
        <translation>无法编码视频</translation>
    </message>
</context>
<context>
    <name>video.cannot_finish</name>
    <message>
        <source>cannot finish the video %1</source>
        <translation>无法完成视频 %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_join</name>
    <message>
        <source>cannot join &apos;%1&apos; to a recording</source>
        <translation>无法将“%1”拼接到录像</translation>
    </message>
</context>
<context>
    <name>video.cannot_open</name>
    <message>
        <source>cannot open the video %1</source>
        <translation>无法打开视频 %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_picture</name>
    <message>
        <source>cannot read the image %1</source>
        <translation>无法读取图片 %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_sound</name>
    <message>
        <source>cannot read the sound of %1</source>
        <translation>无法读取 %1 的声音</translation>
    </message>
</context>
<context>
    <name>video.cannot_show_frame</name>
    <message>
        <source>cannot show frame %1 of %2</source>
        <translation>无法显示 %2 的第 %1 帧</translation>
    </message>
</context>
<context>
    <name>video.cannot_take_image</name>
    <message>
        <source>cannot take &apos;%1&apos; as a frame of a video</source>
        <translation>无法将“%1”用作视频的一帧</translation>
    </message>
</context>
<context>
    <name>video.cannot_write</name>
    <message>
        <source>cannot write the video %1</source>
        <translation>无法写出视频 %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_frame</name>
    <message>
        <source>cannot write a frame to the video %1</source>
        <translation>无法向视频 %1 写入帧</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_joined</name>
    <message>
        <source>cannot write the joined recording %1</source>
        <translation>无法写出拼接的录像 %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_recording</name>
    <message>
        <source>cannot write the recording %1</source>
        <translation>无法写出录像 %1</translation>
    </message>
</context>
<context>
    <name>video.chapter_after_gap</name>
    <message>
        <source>by its recording time %1 are missing between &apos;%2&apos; and it; if so, all times behind that are wrong</source>
        <translation>按录制时间，“%2”与它之间缺少 %1；若是如此，其后的所有时间都不正确</translation>
    </message>
</context>
<context>
    <name>video.chapter_codec</name>
    <message>
        <source>its codec is %1, that of &apos;%2&apos; is %3</source>
        <translation>其编码为 %1，而“%2”的编码为 %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_hides_frames</name>
    <message>
        <source>some of its frames are hidden, as an editor does that cuts a video</source>
        <translation>其部分帧被隐藏，如编辑软件剪切视频时所为</translation>
    </message>
</context>
<context>
    <name>video.chapter_mirrored</name>
    <message>
        <source>its frames and those of &apos;%1&apos; are not mirrored alike</source>
        <translation>其帧与“%1”的帧镜像方式不同</translation>
    </message>
</context>
<context>
    <name>video.chapter_pixels</name>
    <message>
        <source>its pixel format is %1, that of &apos;%2&apos; is %3</source>
        <translation>其像素格式为 %1，而“%2”的为 %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_recorded_before</name>
    <message>
        <source>by its recording time it was started before &apos;%1&apos;, behind which it was joined; check the order of the files</source>
        <translation>按录制时间，它在“%1”之前开始，却被拼接在其后；请检查文件的顺序</translation>
    </message>
</context>
<context>
    <name>video.chapter_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1</source>
        <translation>其时间戳在 %1 后重新开始或停滞</translation>
    </message>
</context>
<context>
    <name>video.chapter_set_up</name>
    <message>
        <source>its encoder was set up in another way than that of &apos;%1&apos;</source>
        <translation>其编码器设置与“%1”不同</translation>
    </message>
</context>
<context>
    <name>video.chapter_size</name>
    <message>
        <source>its frames are %1, those of &apos;%2&apos; are %3</source>
        <translation>其帧为 %1，而“%2”的帧为 %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_turn</name>
    <message>
        <source>its frames are to be turned by %1°, those of &apos;%2&apos; by %3°</source>
        <translation>其帧需旋转 %1°，而“%2”的帧需旋转 %3°</translation>
    </message>
</context>
<context>
    <name>video.chapter_without_stamps</name>
    <message>
        <source>its frames have no time stamps of their own</source>
        <translation>其帧没有自己的时间戳</translation>
    </message>
</context>
<context>
    <name>video.chapters_of_one_frame</name>
    <message>
        <source>each of the files has a single frame</source>
        <translation>每个文件只有一帧</translation>
    </message>
</context>
<context>
    <name>video.check_its_folder</name>
    <message>
        <source>check that its folder may be written to and has free space</source>
        <translation>请检查其文件夹可写且有空间</translation>
    </message>
</context>
<context>
    <name>video.check_picture_place</name>
    <message>
        <source>check the folder, the free space, and that the name ends in .png or .jpg</source>
        <translation>请检查文件夹、可用空间，以及名称以 .png 或 .jpg 结尾</translation>
    </message>
</context>
<context>
    <name>video.check_room</name>
    <message>
        <source>check the free disk space</source>
        <translation>请检查磁盘是否有空间</translation>
    </message>
</context>
<context>
    <name>video.check_the_folder</name>
    <message>
        <source>check that the folder exists, may be written to and has free space</source>
        <translation>请检查文件夹存在、可写且有空间</translation>
    </message>
</context>
<context>
    <name>video.check_what_was_asked</name>
    <message>
        <source>check the requested size, frame rate and quality</source>
        <translation>请检查所要求的尺寸、帧率和质量</translation>
    </message>
</context>
<context>
    <name>video.choose_one_of_these</name>
    <message>
        <source>choose one of these</source>
        <translation>请从中选择</translation>
    </message>
</context>
<context>
    <name>video.convert_sound_to_aac</name>
    <message>
        <source>convert its sound to AAC</source>
        <translation>请将其声音转换为 AAC</translation>
    </message>
</context>
<context>
    <name>video.convert_to_h264</name>
    <message>
        <source>convert it to H.264</source>
        <translation>请转换为 H.264</translation>
    </message>
</context>
<context>
    <name>video.convert_to_png</name>
    <message>
        <source>convert it to PNG or JPEG</source>
        <translation>请转换为 PNG 或 JPEG</translation>
    </message>
</context>
<context>
    <name>video.convert_to_smaller</name>
    <message>
        <source>convert it to a smaller size</source>
        <translation>请转换为更小的尺寸</translation>
    </message>
</context>
<context>
    <name>video.convert_to_yuv</name>
    <message>
        <source>convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</source>
        <translation>请转换为 8 位 YUV，例如 ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.copy_again</name>
    <message>
        <source>copy it again</source>
        <translation>请重新复制</translation>
    </message>
</context>
<context>
    <name>video.copy_chapter_again</name>
    <message>
        <source>copy it from the camera again: what follows it would get wrong times</source>
        <translation>请从相机重新复制：其后的内容会得到错误的时间</translation>
    </message>
</context>
<context>
    <name>video.copy_from_camera</name>
    <message>
        <source>copy it from the camera again</source>
        <translation>请从相机重新复制</translation>
    </message>
</context>
<context>
    <name>video.copy_if_cut_short</name>
    <message>
        <source>copy it from the camera again if it was cut short</source>
        <translation>若被截断，请从相机重新复制</translation>
    </message>
</context>
<context>
    <name>video.cut_chapter_there</name>
    <message>
        <source>cut it there, and give both parts</source>
        <translation>请在该处剪开，并给出两部分</translation>
    </message>
</context>
<context>
    <name>video.data_damaged</name>
    <message>
        <source>its data are damaged</source>
        <translation>数据已损坏</translation>
    </message>
</context>
<context>
    <name>video.decoder_not_started</name>
    <message>
        <source>its decoder did not start (%1)</source>
        <translation>其解码器无法启动（%1）</translation>
    </message>
</context>
<context>
    <name>video.each_at_its_time</name>
    <message>
        <source>each frame keeps its own time</source>
        <translation>每张图片按其自身的时间计算</translation>
    </message>
</context>
<context>
    <name>video.encoder_not_started</name>
    <message>
        <source>the encoder did not start (%1)</source>
        <translation>编码器无法启动（%1）</translation>
    </message>
</context>
<context>
    <name>video.ends_early</name>
    <message>
        <source>ends early at %1</source>
        <translation>在 %1 处提前结束</translation>
    </message>
</context>
<context>
    <name>video.failed_before</name>
    <message>
        <source>writing failed earlier</source>
        <translation>此前写入已失败</translation>
    </message>
</context>
<context>
    <name>video.file_not_read</name>
    <message>
        <source>the file could not be read</source>
        <translation>无法读取文件</translation>
    </message>
</context>
<context>
    <name>video.format_differs</name>
    <message>
        <source>its format differs from the video&apos;s</source>
        <translation>其格式与视频不同</translation>
    </message>
</context>
<context>
    <name>video.frame_left_out</name>
    <message>
        <source>it is left out</source>
        <translation>已舍去</translation>
    </message>
</context>
<context>
    <name>video.frames_it_has</name>
    <message>
        <source>it has frames 0 to %1</source>
        <translation>其帧为 0 到 %1</translation>
    </message>
</context>
<context>
    <name>video.frames_left_out</name>
    <message>
        <source>%1 frames left out</source>
        <translation>略去 %1 帧</translation>
    </message>
</context>
<context>
    <name>video.frames_not_encodable</name>
    <message>
        <source>frames of this size or chroma format cannot be encoded</source>
        <translation>无法对此尺寸或色度格式的帧编码</translation>
    </message>
</context>
<context>
    <name>video.give_another_format</name>
    <message>
        <source>set the camera to another format</source>
        <translation>请让相机输出其他格式</translation>
    </message>
</context>
<context>
    <name>video.give_as_images</name>
    <message>
        <source>give images as a folder, with their rate</source>
        <translation>请以文件夹给出图片，并给出其帧率</translation>
    </message>
</context>
<context>
    <name>video.give_camera_file</name>
    <message>
        <source>give the file that the camera recorded</source>
        <translation>请给出相机录制的文件</translation>
    </message>
</context>
<context>
    <name>video.give_chapter_of_camera</name>
    <message>
        <source>give the file as the camera wrote it</source>
        <translation>请给出相机所写的原文件</translation>
    </message>
</context>
<context>
    <name>video.give_container</name>
    <message>
        <source>give an MP4, MOV, MKV or AVI file</source>
        <translation>请给出 MP4、MOV、MKV 或 AVI 文件</translation>
    </message>
</context>
<context>
    <name>video.give_known_ending</name>
    <message>
        <source>give it one of these endings</source>
        <translation>请使用其中一种扩展名</translation>
    </message>
</context>
<context>
    <name>video.give_rate</name>
    <message>
        <source>give the frames per second, e.g. 30</source>
        <translation>请给出每秒帧数，例如 30</translation>
    </message>
</context>
<context>
    <name>video.give_shorter_clip</name>
    <message>
        <source>give a shorter clip</source>
        <translation>请给出更短的视频</translation>
    </message>
</context>
<context>
    <name>video.h264_needs_even</name>
    <message>
        <source>H.264 needs an even width and height, not %1</source>
        <translation>H.264 需要偶数宽高，而非 %1</translation>
    </message>
</context>
<context>
    <name>video.header_not_rewritten</name>
    <message>
        <source>its header could not be rewritten</source>
        <translation>无法重写其文件头</translation>
    </message>
</context>
<context>
    <name>video.header_promises</name>
    <message>
        <source>its header promises %1</source>
        <translation>其文件头声明为 %1</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_kind</name>
    <message>
        <source>it is not an upright JPEG in colour as the first, &apos;%1&apos;, is</source>
        <translation>它不像第一张“%1”那样是正向的彩色 JPEG</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_layout</name>
    <message>
        <source>its colours are stored in another way than those of the first, &apos;%1&apos;</source>
        <translation>其颜色的存储方式与第一张“%1”不同</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_size</name>
    <message>
        <source>its size is %1, that of the first, &apos;%2&apos;, is %3</source>
        <translation>其尺寸为 %1，而第一张“%2”的尺寸为 %3</translation>
    </message>
</context>
<context>
    <name>video.install_libavcodec</name>
    <message>
        <source>install Debian&apos;s libavcodec</source>
        <translation>请安装 Debian 的 libavcodec</translation>
    </message>
</context>
<context>
    <name>video.install_libx264</name>
    <message>
        <source>install Debian&apos;s libavcodec with libx264</source>
        <translation>请安装 Debian 带 libx264 的 libavcodec</translation>
    </message>
</context>
<context>
    <name>video.is_finished</name>
    <message>
        <source>it is finished</source>
        <translation>已完成</translation>
    </message>
</context>
<context>
    <name>video.join_one_recording</name>
    <message>
        <source>join only the files into which a camera has split one recording</source>
        <translation>请只拼接相机从同一录像分出的文件</translation>
    </message>
</context>
<context>
    <name>video.joining_chapters</name>
    <message>
        <source>joining &apos;%1&apos;</source>
        <translation>正在拼接“%1”</translation>
    </message>
</context>
<context>
    <name>video.largest_picture</name>
    <message>
        <source>the limit is 50 megapixels and 32000 pixels a side</source>
        <translation>超过 5000 万像素或单边 32000 像素则不读取</translation>
    </message>
</context>
<context>
    <name>video.leave_out_image</name>
    <message>
        <source>leave it out, or convert all of them in the same way</source>
        <translation>请略去它，或将所有图片以同样方式转换</translation>
    </message>
</context>
<context>
    <name>video.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>请缩小</translation>
    </message>
</context>
<context>
    <name>video.name_a_picture</name>
    <message>
        <source>choose an image</source>
        <translation>请指定图片</translation>
    </message>
</context>
<context>
    <name>video.no_decoder</name>
    <message>
        <source>there is no decoder for %1</source>
        <translation>没有 %1 的解码器</translation>
    </message>
</context>
<context>
    <name>video.no_encoder</name>
    <message>
        <source>the installed libavcodec has no encoder for it</source>
        <translation>已安装的 libavcodec 没有相应编码器</translation>
    </message>
</context>
<context>
    <name>video.no_ffv1_in_mp4</name>
    <message>
        <source>MP4 cannot contain FFV1</source>
        <translation>FFV1 不能放入 MP4</translation>
    </message>
</context>
<context>
    <name>video.no_frame_written</name>
    <message>
        <source>no frame was written to it</source>
        <translation>没有写入任何帧</translation>
    </message>
</context>
<context>
    <name>video.no_jpeg_layout</name>
    <message>
        <source>JPEG does not support its colour layout</source>
        <translation>JPEG 不支持其颜色排列</translation>
    </message>
</context>
<context>
    <name>video.no_known_ending</name>
    <message>
        <source>its name ends with neither .mkv nor .mp4</source>
        <translation>其名称不以 .mkv 或 .mp4 结尾</translation>
    </message>
</context>
<context>
    <name>video.no_picture_format</name>
    <message>
        <source>it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image</source>
        <translation>不是 PNG、JPEG、TIFF、HEIC、WebP、BMP 或 PNM 图片</translation>
    </message>
</context>
<context>
    <name>video.no_sound</name>
    <message>
        <source>it has no sound</source>
        <translation>它没有声音</translation>
    </message>
</context>
<context>
    <name>video.no_stream</name>
    <message>
        <source>it contains no readable video stream</source>
        <translation>其中没有可读的视频流</translation>
    </message>
</context>
<context>
    <name>video.no_time_scale</name>
    <message>
        <source>its time scale was not found where the muxer should have put it</source>
        <translation>在复用器应写入的位置没有找到时间刻度</translation>
    </message>
</context>
<context>
    <name>video.no_time_stamps</name>
    <message>
        <source>the file has no time stamps</source>
        <translation>文件没有时间戳</translation>
    </message>
</context>
<context>
    <name>video.no_video_kind</name>
    <message>
        <source>it is not a supported kind of video, or its header is damaged or missing (%1)</source>
        <translation>不是可读类型的视频，或其文件头损坏或缺失（%1）</translation>
    </message>
</context>
<context>
    <name>video.no_whole_frame</name>
    <message>
        <source>it contains no complete frame</source>
        <translation>其中没有一帧完整</translation>
    </message>
</context>
<context>
    <name>video.of_chapter</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>视频“%1”</translation>
    </message>
</context>
<context>
    <name>video.packet_damaged</name>
    <message>
        <source>a packet is damaged</source>
        <translation>那里的一个数据包已损坏</translation>
    </message>
</context>
<context>
    <name>video.picture</name>
    <message>
        <source>image</source>
        <translation>图片</translation>
    </message>
</context>
<context>
    <name>video.picture_claims_size</name>
    <message>
        <source>its header says that it has %1 pixels</source>
        <translation>其声明有 %1 像素</translation>
    </message>
</context>
<context>
    <name>video.picture_damaged</name>
    <message>
        <source>its content is damaged or cut short</source>
        <translation>其内容损坏或不完整</translation>
    </message>
</context>
<context>
    <name>video.picture_file_too_large</name>
    <message>
        <source>the file is larger than 200 MB</source>
        <translation>文件大于 200 MB</translation>
    </message>
</context>
<context>
    <name>video.picture_format_unknown</name>
    <message>
        <source>its format is unknown</source>
        <translation>其格式未知</translation>
    </message>
</context>
<context>
    <name>video.picture_named</name>
    <message>
        <source>image &apos;%1&apos;</source>
        <translation>图片“%1”</translation>
    </message>
</context>
<context>
    <name>video.picture_not_coded</name>
    <message>
        <source>a frame cannot be encoded</source>
        <translation>无法对画面编码</translation>
    </message>
</context>
<context>
    <name>video.picture_not_packed</name>
    <message>
        <source>it could not be compressed</source>
        <translation>无法打包</translation>
    </message>
</context>
<context>
    <name>video.pictures_too_large</name>
    <message>
        <source>its frames have more than 100 megapixels or 32000 pixels a side</source>
        <translation>其画面超过 1 亿像素或单边 32000 像素</translation>
    </message>
</context>
<context>
    <name>video.pixel_format_not_read</name>
    <message>
        <source>its pixel format %1 is not supported</source>
        <translation>不读取像素格式 %1</translation>
    </message>
</context>
<context>
    <name>video.put_into_mp4</name>
    <message>
        <source>put each file into MP4 first, e.g. ffmpeg -i FILE -c copy NEW.mp4</source>
        <translation>请先将每个文件放入 MP4，例如 ffmpeg -i FILE -c copy NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.rate_not_positive</name>
    <message>
        <source>its frame rate is not positive</source>
        <translation>其帧率不为正</translation>
    </message>
</context>
<context>
    <name>video.rate_varies</name>
    <message>
        <source>its frame rate varies: frames are %1 to %2 apart</source>
        <translation>其帧率不恒定，图片间隔为 %1 到 %2</translation>
    </message>
</context>
<context>
    <name>video.reading_chapter</name>
    <message>
        <source>reading &apos;%1&apos;</source>
        <translation>正在读取“%1”</translation>
    </message>
</context>
<context>
    <name>video.record_with_sound</name>
    <message>
        <source>switch the camera&apos;s sound on</source>
        <translation>请打开相机的声音</translation>
    </message>
</context>
<context>
    <name>video.report_bug</name>
    <message>
        <source>report this as a bug</source>
        <translation>请将此作为缺陷报告</translation>
    </message>
</context>
<context>
    <name>video.siting_not_set</name>
    <message>
        <source>the chroma siting could not be set (%1)</source>
        <translation>无法设置色度采样位置（%1）</translation>
    </message>
</context>
<context>
    <name>video.size_not_found</name>
    <message>
        <source>its frame size could not be determined</source>
        <translation>无法得知其画面尺寸</translation>
    </message>
</context>
<context>
    <name>video.sound_left_out</name>
    <message>
        <source>the sound was left out, because the files it is joined with have none or another kind of it</source>
        <translation>声音已略去，因为与之拼接的文件没有声音或声音类型不同</translation>
    </message>
</context>
<context>
    <name>video.sound_part_used</name>
    <message>
        <source>its undamaged part is used</source>
        <translation>使用其完好部分</translation>
    </message>
</context>
<context>
    <name>video.sound_too_long</name>
    <message>
        <source>its sound is longer than %1</source>
        <translation>其声音长于 %1</translation>
    </message>
</context>
<context>
    <name>video.stamps_repeat</name>
    <message>
        <source>their time stamps repeat that of the frame before</source>
        <translation>其时间戳与前一帧重复</translation>
    </message>
</context>
<context>
    <name>video.stamps_span</name>
    <message>
        <source>its time stamps span %1</source>
        <translation>其时间戳跨度为 %1</translation>
    </message>
</context>
<context>
    <name>video.start_it_again</name>
    <message>
        <source>start it again</source>
        <translation>请重新开始</translation>
    </message>
</context>
<context>
    <name>video.start_video_again</name>
    <message>
        <source>start the video again</source>
        <translation>请重新开始该视频</translation>
    </message>
</context>
<context>
    <name>video.taking_image</name>
    <message>
        <source>taking image %1 of %2</source>
        <translation>正在处理第 %1 张图片，共 %2 张</translation>
    </message>
</context>
<context>
    <name>video.time_not_after</name>
    <message>
        <source>its time is not later than that of the frame before</source>
        <translation>其时间不晚于前一帧</translation>
    </message>
</context>
<context>
    <name>video.unknown_format_not_read</name>
    <message>
        <source>its pixel format (unknown) is not supported</source>
        <translation>不读取其（未知的）像素格式</translation>
    </message>
</context>
<context>
    <name>video.use_another_picture</name>
    <message>
        <source>use another image</source>
        <translation>请换一张图片</translation>
    </message>
</context>
<context>
    <name>video.use_mjpeg</name>
    <message>
        <source>use MJPEG or FFV1, or another size</source>
        <translation>请使用 MJPEG 或 FFV1，或其他尺寸</translation>
    </message>
</context>
<context>
    <name>video.use_mkv</name>
    <message>
        <source>use the ending .mkv</source>
        <translation>请使用扩展名 .mkv</translation>
    </message>
</context>
<context>
    <name>video.use_other_chroma</name>
    <message>
        <source>use 4:2:0, 4:2:2 or 4:4:4</source>
        <translation>请使用 4:2:0、4:2:2 或 4:4:4</translation>
    </message>
</context>
<context>
    <name>video.write_at_least_one</name>
    <message>
        <source>write at least one</source>
        <translation>请至少写入一帧</translation>
    </message>
</context>
<context>
    <name>video.write_in_order</name>
    <message>
        <source>write the frames in order, at least a microsecond apart</source>
        <translation>请按顺序写入帧，间隔至少一微秒</translation>
    </message>
</context>
<context>
    <name>video.write_one_format</name>
    <message>
        <source>write one format to a file</source>
        <translation>一个文件只写一种格式</translation>
    </message>
</context>
<context>
    <name>workflow.accept_results</name>
    <message>
        <source>accept the results of %1</source>
        <translation>接受 %1 的结果</translation>
    </message>
</context>
<context>
    <name>workflow.accuracy_given</name>
    <message>
        <source>accurate to %1, as given</source>
        <translation>按给定值精确到 %1</translation>
    </message>
</context>
<context>
    <name>workflow.add_layout_of_mat</name>
    <message>
        <source>add layout %1</source>
        <translation>添加布局 %1</translation>
    </message>
</context>
<context>
    <name>workflow.add_robot</name>
    <message>
        <source>add one with: odograph robot add PROJECT NAME --colour #rrggbb</source>
        <translation>请在“试验场”中添加一个</translation>
    </message>
</context>
<context>
    <name>workflow.added_with_colour</name>
    <message>
        <source>it was added with the colour %1</source>
        <translation>已用颜色 %1 添加</translation>
    </message>
</context>
<context>
    <name>workflow.address_of_live_positions</name>
    <message>
        <source>address &apos;%1&apos; of live positions</source>
        <translation>实时位置的地址“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.analyse_it_again</name>
    <message>
        <source>reanalyse it</source>
        <translation>重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.analysing</name>
    <message>
        <source>analysing</source>
        <translation>正在分析</translation>
    </message>
</context>
<context>
    <name>workflow.analysing_robot</name>
    <message>
        <source>analysing %1</source>
        <translation>正在分析 %1</translation>
    </message>
</context>
<context>
    <name>workflow.another_picture_size</name>
    <message>
        <source>its frames are %1, but the camera was registered at %2</source>
        <translation>其帧为 %1，而相机在 %2 下配准</translation>
    </message>
</context>
<context>
    <name>workflow.assumed_lens</name>
    <message>
        <source>its lens was neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>其镜头既未标定，也未由地面标记确定</translation>
    </message>
</context>
<context>
    <name>workflow.bad_is_not_accepted</name>
    <message>
        <source>bad results cannot be accepted (%1)</source>
        <translation>不可用的结果不能接受（%1）</translation>
    </message>
</context>
<context>
    <name>workflow.beyond_limits</name>
    <message>
        <source>%1 of the samples exceed the limits of task &apos;%2&apos;, so the limits were ignored</source>
        <translation>所测数据的 %1 超出任务“%2”的限值，因此未采用这些限值</translation>
    </message>
</context>
<context>
    <name>workflow.board_in_no_picture</name>
    <message>
        <source>the board was found in none of %1 images (%2)</source>
        <translation>%1 张图片中都没有找到标定板（%2）</translation>
    </message>
</context>
<context>
    <name>workflow.box_stands_in</name>
    <message>
        <source>the project has none, so a blue box of 260 mm × 190 mm × 60 mm is simulated</source>
        <translation>项目中没有机器人，因此模拟一个 260 mm × 190 mm × 60 mm 的蓝色方块</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_and_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens calibration %2</source>
        <translation>布局“%1”，镜头标定 %2</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_without_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens not calibrated</source>
        <translation>布局“%1”，镜头未标定</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_and_reanalyse</name>
    <message>
        <source>calibrate the lens, register the camera again and reanalyse</source>
        <translation>请标定镜头，重新配准相机并重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_at_its_size</name>
    <message>
        <source>calibrate it at the size it records.</source>
        <translation>请按录制的尺寸标定。</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_camera</name>
    <message>
        <source>calibrate camera %1</source>
        <translation>标定相机 %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_if_touched</name>
    <message>
        <source>if zoom, focus or the camera&apos;s settings have changed since, calibrate it again.</source>
        <translation>如果此后动过变焦、对焦或相机设置，请重新标定。</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_it</name>
    <message>
        <source>calibrate it.</source>
        <translation>请标定它。</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_lens_first</name>
    <message>
        <source>calibrate the lens first, or choose another calibration</source>
        <translation>请先标定镜头，或启用另一标定</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_give_picture</name>
    <message>
        <source>calibrate it, import its intrinsics, or give an image or a video as well</source>
        <translation>对其标定、导入其内参，或同时提供图像或视频</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_import_trial</name>
    <message>
        <source>calibrate it, import its intrinsics, or import a trial with it first</source>
        <translation>请先标定它、导入其内参，或导入一个用它的试验</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_pair</name>
    <message>
        <source>calibrate cameras %1 and %2 as a pair</source>
        <translation>将相机 %1 和 %2 作为一对标定</translation>
    </message>
</context>
<context>
    <name>workflow.calibrated_from_pictures</name>
    <message>
        <source>calibrated from %1 images</source>
        <translation>由 %1 张图片标定</translation>
    </message>
</context>
<context>
    <name>workflow.calibrating_camera</name>
    <message>
        <source>calibrating camera %1</source>
        <translation>正在标定相机 %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration</name>
    <message>
        <source>calibration %1</source>
        <translation>标定 %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_of_camera</name>
    <message>
        <source>calibration of camera &apos;%1&apos;</source>
        <translation>相机“%1”的标定</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_picture</name>
    <message>
        <source>calibration image &apos;%1&apos;</source>
        <translation>标定图片“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>相机“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.camera_ended_before_start</name>
    <message>
        <source>a camera ended before the start</source>
        <translation>一台相机在开始前结束</translation>
    </message>
</context>
<context>
    <name>workflow.camera_gave_no_picture</name>
    <message>
        <source>camera &apos;%1&apos; delivered no frame</source>
        <translation>相机“%1”没有输出图像</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; or its address &apos;%2&apos; was given twice</source>
        <translation>相机“%1”或其地址“%2”给出了两次</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_two_videos</name>
    <message>
        <source>camera &apos;%1&apos; was given two videos</source>
        <translation>给相机“%1”指定了两个视频</translation>
    </message>
</context>
<context>
    <name>workflow.camera_moved_during</name>
    <message>
        <source>the camera moved by %1 after %2; what it saw from then on was not measured</source>
        <translation>相机在 %2 之后移动了 %1;此后所见未测量</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_on_floor</name>
    <message>
        <source>camera &apos;%1&apos; is not registered to the floor</source>
        <translation>相机“%1”未对地面配准</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_registered</name>
    <message>
        <source>camera &apos;%1&apos; is not registered</source>
        <translation>相机“%1”未配准</translation>
    </message>
</context>
<context>
    <name>workflow.camera_sees_too_little</name>
    <message>
        <source>the camera sees too little of the floor between the markers for a run</source>
        <translation>相机看到的标记之间的地面太少，无法运行</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_given_one_file</name>
    <message>
        <source>cameras &apos;%1&apos; and &apos;%2&apos; were given the same file, &apos;%3&apos;</source>
        <translation>相机“%1”和“%2”被指定了同一个文件“%3”</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_share_too_little</name>
    <message>
        <source>no two cameras share enough of the floor between the markers for a run</source>
        <translation>没有两台相机共同看到足够的标记之间的地面来运行</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved</name>
    <message>
        <source>camera %1 seems to have moved by %2 since its registration</source>
        <translation>相机 %1 自配准以来似乎移动了 %2</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved_at</name>
    <message>
        <source>camera %1 seems to have moved by %2 at %3</source>
        <translation>相机 %1 似乎在 %3 移动了 %2</translation>
    </message>
</context>
<context>
    <name>workflow.cause_cameras_moved</name>
    <message>
        <source>cameras %1 and %2 seem to have moved since their registration</source>
        <translation>相机 %1 和 %2 自配准以来似乎移动了</translation>
    </message>
</context>
<context>
    <name>workflow.cause_clock_rate</name>
    <message>
        <source>the time offset of view %1 seems to change by %2 in each second</source>
        <translation>视角 %1 的时间偏移似乎每秒变化 %2</translation>
    </message>
</context>
<context>
    <name>workflow.cause_height</name>
    <message>
        <source>the height given for the robot seems wrong by about %1</source>
        <translation>给定的机器人高度似乎错了约 %1</translation>
    </message>
</context>
<context>
    <name>workflow.cause_offset</name>
    <message>
        <source>the time offset of view %1 seems wrong by %2</source>
        <translation>视角 %1 的时间偏移似乎错了 %2</translation>
    </message>
</context>
<context>
    <name>workflow.cause_or_cause</name>
    <message>
        <source>%1, or %2</source>
        <translation>%1,或者 %2</translation>
    </message>
</context>
<context>
    <name>workflow.certificate</name>
    <message>
        <source>certificate</source>
        <translation>证书</translation>
    </message>
</context>
<context>
    <name>workflow.change_guidance</name>
    <message>
        <source>change the guidance of %1</source>
        <translation>更改 %1 的跟踪引导</translation>
    </message>
</context>
<context>
    <name>workflow.changed_in_file</name>
    <message>
        <source>they were changed in the file</source>
        <translation>它们在文件中被更改过</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_missing</name>
    <message>
        <source>by their names a file is missing between &apos;%1&apos; and &apos;%2&apos;; if so, all times behind it are wrong</source>
        <translation>按名称，“%1”与“%2”之间缺少一个文件；若是如此，其后的所有时间都不正确</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>“%1”被给出两次</translation>
    </message>
</context>
<context>
    <name>workflow.chapters_out_of_order</name>
    <message>
        <source>by their names &apos;%1&apos; comes before &apos;%2&apos;, and was joined behind it; check the order of the files</source>
        <translation>按名称，“%1”在“%2”之前，却被拼接在其后；请检查文件的顺序</translation>
    </message>
</context>
<context>
    <name>workflow.check_cable_and_bandwidth</name>
    <message>
        <source>check the cable, the bandwidth and what else this computer is doing</source>
        <translation>请检查电缆、带宽以及本机的其他工作</translation>
    </message>
</context>
<context>
    <name>workflow.check_files_and_offset</name>
    <message>
        <source>check the files and the --sync offset</source>
        <translation>请检查文件和偏移</translation>
    </message>
</context>
<context>
    <name>workflow.check_it_is_connected</name>
    <message>
        <source>check that it is connected and not used by another program</source>
        <translation>请检查它已连接且未被其他程序占用</translation>
    </message>
</context>
<context>
    <name>workflow.check_its_cable</name>
    <message>
        <source>check its cable, and whether another program uses it</source>
        <translation>请检查其电缆，以及是否有其他程序占用</translation>
    </message>
</context>
<context>
    <name>workflow.check_line_is</name>
    <message>
        <source>its check line is 1000 or 200 mm long; no print is off by so much</source>
        <translation>其检查线长 1000 或 200 毫米；打印误差不会这么大</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_analyse_again</name>
    <message>
        <source>run odograph check, or reanalyse the trial</source>
        <translation>请检查项目，或重新分析该试验</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_register_again</name>
    <message>
        <source>check that the camera has not moved, or register it again.</source>
        <translation>请检查相机是否移动，或重新配准。</translation>
    </message>
</context>
<context>
    <name>workflow.check_rate</name>
    <message>
        <source>views are matched by time: check --rate if one is in slow motion</source>
        <translation>视角按时间结合；若其一为慢动作，请检查相机实际帧率</translation>
    </message>
</context>
<context>
    <name>workflow.check_robot_and_registration</name>
    <message>
        <source>check the robot&apos;s colour and size, and the registrations</source>
        <translation>请检查机器人的颜色和尺寸以及配准</translation>
    </message>
</context>
<context>
    <name>workflow.check_they_are_connected</name>
    <message>
        <source>check that they are connected and not used by another program</source>
        <translation>请检查它们已连接且未被其他程序占用</translation>
    </message>
</context>
<context>
    <name>workflow.check_views_of_one_run</name>
    <message>
        <source>only one view measures the rest, so check that both belong to one run</source>
        <translation>其外只有一个视角测量，请检查两者是否属于同一次运行</translation>
    </message>
</context>
<context>
    <name>workflow.check_whether_moved</name>
    <message>
        <source>check whether camera %1 has moved</source>
        <translation>检查相机 %1 是否移动</translation>
    </message>
</context>
<context>
    <name>workflow.checking_trials</name>
    <message>
        <source>checks of the trials</source>
        <translation>试验检查</translation>
    </message>
</context>
<context>
    <name>workflow.choose_another_one</name>
    <message>
        <source>choose another one</source>
        <translation>请另选一个</translation>
    </message>
</context>
<context>
    <name>workflow.choose_calibration</name>
    <message>
        <source>choose calibration %1 of camera %2</source>
        <translation>选择相机 %2 的标定 %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_for_demo</name>
    <message>
        <source>choose a folder you can write to, with 300 MB free</source>
        <translation>请选择可写且有 300 MB 空间的文件夹</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_of_copies</name>
    <message>
        <source>choose the folder where they were copied to</source>
        <translation>请选择它们被复制到的文件夹</translation>
    </message>
</context>
<context>
    <name>workflow.choose_frame</name>
    <message>
        <source>choose one from %1 to %2</source>
        <translation>请从 %1 到 %2 中选择</translation>
    </message>
</context>
<context>
    <name>workflow.choose_interface</name>
    <message>
        <source>choose one that `ip link` lists, or lo to stay on this computer</source>
        <translation>请选择 `ip link` 列出的接口，或选 lo 仅在本机使用</translation>
    </message>
</context>
<context>
    <name>workflow.choose_measured_frame</name>
    <message>
        <source>choose a frame with a measurement</source>
        <translation>请选择有测量的帧</translation>
    </message>
</context>
<context>
    <name>workflow.choose_metric</name>
    <message>
        <source>choose from %1</source>
        <translation>请从 %1 中选择</translation>
    </message>
</context>
<context>
    <name>workflow.choose_one_of_them</name>
    <message>
        <source>choose one of them</source>
        <translation>请选择其中之一</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_group</name>
    <message>
        <source>choose other times or another reason</source>
        <translation>请选择其他时间或其他原因</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_range</name>
    <message>
        <source>choose another range</source>
        <translation>请选择其他区间</translation>
    </message>
</context>
<context>
    <name>workflow.choose_range_within</name>
    <message>
        <source>choose a range from 0 to %1</source>
        <translation>请选择 0 到 %1 之间的区间</translation>
    </message>
</context>
<context>
    <name>workflow.choose_registration</name>
    <message>
        <source>choose registration %1 of camera %2</source>
        <translation>选择相机 %2 的配准 %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_robot_of_trial</name>
    <message>
        <source>choose a robot of the trial</source>
        <translation>请选择该试验的机器人</translation>
    </message>
</context>
<context>
    <name>workflow.choose_run_on_layout</name>
    <message>
        <source>choose a run on the same layout</source>
        <translation>选择同一布局上的运行</translation>
    </message>
</context>
<context>
    <name>workflow.choose_seen_task</name>
    <message>
        <source>choose a task on the floor that they see, or leave the task out</source>
        <translation>请选择其可见地面上的任务，或不指定任务</translation>
    </message>
</context>
<context>
    <name>workflow.choose_task_with_course</name>
    <message>
        <source>choose a task that has, or leave the task out</source>
        <translation>请选择有路径或门的任务，或不指定任务</translation>
    </message>
</context>
<context>
    <name>workflow.choose_time</name>
    <message>
        <source>choose a time from %1 to %2</source>
        <translation>请选择 %1 到 %2 之间的时间</translation>
    </message>
</context>
<context>
    <name>workflow.choose_trial_of_views</name>
    <message>
        <source>choose a trial of two views or more</source>
        <translation>请选择有两个或更多视角的试验</translation>
    </message>
</context>
<context>
    <name>workflow.choose_with_robot</name>
    <message>
        <source>choose one with --robot</source>
        <translation>请选择其中一个</translation>
    </message>
</context>
<context>
    <name>workflow.class_without_team</name>
    <message>
        <source>without a team it belongs to no class</source>
        <translation>没有小组，因而不属于任何班级</translation>
    </message>
</context>
<context>
    <name>workflow.clear_range</name>
    <message>
        <source>remove the range of %1</source>
        <translation>移除 %1 的区间</translation>
    </message>
</context>
<context>
    <name>workflow.clock_jumped</name>
    <message>
        <source>at %1 the clock jumped ahead by %2; later times were corrected</source>
        <translation>在 %1 时钟向前跳了 %2；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.clock_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1: two files were joined, or the camera&apos;s clock was reset</source>
        <translation>其时间戳在 %1 后重新开始或停滞：两个文件被拼接，或相机时钟被重置</translation>
    </message>
</context>
<context>
    <name>workflow.clocks_differ</name>
    <message>
        <source>the clocks of views &apos;%1&apos; and &apos;%2&apos; differ by %3; speeds and times are by the clock of view &apos;%1&apos;</source>
        <translation>视图“%1”和“%2”的时钟相差 %3；速度和时间以视图“%1”的时钟为准</translation>
    </message>
</context>
<context>
    <name>workflow.compared_with_itself</name>
    <message>
        <source>a run cannot be compared with itself</source>
        <translation>运行不能与自身比较</translation>
    </message>
</context>
<context>
    <name>workflow.comparison_of_trial</name>
    <message>
        <source>comparison of trial &apos;%1&apos;</source>
        <translation>试验“%1”的比较</translation>
    </message>
</context>
<context>
    <name>workflow.complete_trial</name>
    <message>
        <source>complete %1, whose recording was cut off</source>
        <translation>补全录像被中断的 %1</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recording</name>
    <message>
        <source>completing a recording that was cut off</source>
        <translation>正在补全中断的录像</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recordings</name>
    <message>
        <source>completing the recordings</source>
        <translation>补全录像</translation>
    </message>
</context>
<context>
    <name>workflow.computing_intrinsics</name>
    <message>
        <source>computing the intrinsics</source>
        <translation>正在计算内参</translation>
    </message>
</context>
<context>
    <name>workflow.computing_pair</name>
    <message>
        <source>computing the relative position</source>
        <translation>正在计算相对位置</translation>
    </message>
</context>
<context>
    <name>workflow.copied_while_recorded</name>
    <message>
        <source>its recording has not ended</source>
        <translation>其录制尚未结束</translation>
    </message>
</context>
<context>
    <name>workflow.copy_file_again</name>
    <message>
        <source>copy the file from the camera again</source>
        <translation>请从相机重新复制该文件</translation>
    </message>
</context>
<context>
    <name>workflow.copy_of</name>
    <message>
        <source>copy of &apos;%1&apos;</source>
        <translation>“%1”的副本</translation>
    </message>
</context>
<context>
    <name>workflow.copy_trial</name>
    <message>
        <source>copy trial %1 to %2</source>
        <translation>将试验 %1 复制为 %2</translation>
    </message>
</context>
<context>
    <name>workflow.copying_project</name>
    <message>
        <source>copying the project</source>
        <translation>正在复制项目</translation>
    </message>
</context>
<context>
    <name>workflow.corner_off_frame</name>
    <message>
        <source>a corner is outside the frame</source>
        <translation>一个角点在画面之外</translation>
    </message>
</context>
<context>
    <name>workflow.correct_by_hand</name>
    <message>
        <source>correct %1 by hand</source>
        <translation>手动校正 %1</translation>
    </message>
</context>
<context>
    <name>workflow.course_not_seen</name>
    <message>
        <source>the cameras see only %1 of the course of task &apos;%2&apos;</source>
        <translation>相机只看到任务“%2”路线的 %1</translation>
    </message>
</context>
<context>
    <name>workflow.course_of_task</name>
    <message>
        <source>course of task &apos;%1&apos;</source>
        <translation>任务“%1”的路线</translation>
    </message>
</context>
<context>
    <name>workflow.course_seen_in_part</name>
    <message>
        <source>no camera sees %1 of the run whole</source>
        <translation>运行的 %1 没有任何相机能完整看到</translation>
    </message>
</context>
<context>
    <name>workflow.cut_at_restart</name>
    <message>
        <source>cut it there, and import each part as its own trial</source>
        <translation>在该处剪开，并将每部分作为单独的试验导入</translation>
    </message>
</context>
<context>
    <name>workflow.damaged_frames</name>
    <message>
        <source>%1 of its %2 frames, from %3 to %4, are damaged and were not measured</source>
        <translation>其 %2 帧中有 %1 帧（%3 至 %4）已损坏，未被测量</translation>
    </message>
</context>
<context>
    <name>workflow.date_to_come</name>
    <message>
        <source>its new date is in the future</source>
        <translation>其新日期在未来</translation>
    </message>
</context>
<context>
    <name>workflow.demo</name>
    <message>
        <source>demo</source>
        <translation>演示</translation>
    </message>
</context>
<context>
    <name>workflow.demo_in</name>
    <message>
        <source>demo in &apos;%1&apos;</source>
        <translation>“%1”中的演示</translation>
    </message>
</context>
<context>
    <name>workflow.demo_is_there</name>
    <message>
        <source>%1 already exists</source>
        <translation>%1 已存在</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name</name>
    <message>
        <source>from %1 to %2 this may be %3 or %4</source>
        <translation>从 %1 到 %2，这是 %3 还是 %4 存疑</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name_unknown</name>
    <message>
        <source>from %1 to %2 this may be %3 or another robot that looks the same</source>
        <translation>从 %1 到 %2，这是 %3 还是另一个外观相同的机器人存疑</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or %5</source>
        <translation>从 %1 到 %2（共 %3 次，此为第一次），这是 %4 还是 %5 存疑</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names_unknown</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or another robot that looks the same</source>
        <translation>从 %1 到 %2（共 %3 次，此为第一次），这是 %4 还是另一个外观相同的机器人存疑</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_step</name>
    <message>
        <source>it is synchronised only to %1, which is %2 at 1 m/s</source>
        <translation>它只同步到 %1，在 1 m/s 时为 %2</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trial</name>
    <message>
        <source>edit trial %1</source>
        <translation>编辑试验 %1</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trials</name>
    <message>
        <source>edit %1 trials</source>
        <translation>编辑 %1 次试验</translation>
    </message>
</context>
<context>
    <name>workflow.error_estimated</name>
    <message>
        <source>positions to %1, estimated from the track</source>
        <translation>位置精度 %1，由数据估计</translation>
    </message>
</context>
<context>
    <name>workflow.error_stated</name>
    <message>
        <source>positions to %1, as stated in the file</source>
        <translation>位置精度 %1，依文件所述</translation>
    </message>
</context>
<context>
    <name>workflow.evaluation_of_trial</name>
    <message>
        <source>evaluation of trial &apos;%1&apos;</source>
        <translation>试验“%1”的评估</translation>
    </message>
</context>
<context>
    <name>workflow.export</name>
    <message>
        <source>export of &apos;%1&apos;</source>
        <translation>导出“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.faster_disk_or_fewer_cameras</name>
    <message>
        <source>record to a faster disk, or fewer cameras at once</source>
        <translation>请录制到更快的磁盘，或同时使用更少的相机</translation>
    </message>
</context>
<context>
    <name>workflow.file_given_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>“%1”给出了两次</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_another_size</name>
    <message>
        <source>its file has %1 bytes, but had %2 when it was added</source>
        <translation>其文件有 %1 字节，但添加时有 %2 字节</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_other_content</name>
    <message>
        <source>its file has changed since it was added</source>
        <translation>其文件在添加后已被更改</translation>
    </message>
</context>
<context>
    <name>workflow.file_without_picture</name>
    <message>
        <source>it contains no image</source>
        <translation>没有图像</translation>
    </message>
</context>
<context>
    <name>workflow.film_progressive</name>
    <message>
        <source>choose a progressive mode of the camera (p, not i)</source>
        <translation>选择相机的逐行模式（p，而非 i）</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_doubtful_rate</name>
    <message>
        <source>its file says that it was filmed at %1, but its time stamps mean %2</source>
        <translation>其文件称以 %1 拍摄，但其时间戳表示 %2</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_rate</name>
    <message>
        <source>it was filmed at %1, as its file says, and plays at %2; its times are those of filming</source>
        <translation>据其文件，以 %1 拍摄、以 %2 播放；其时间为拍摄时的时间</translation>
    </message>
</context>
<context>
    <name>workflow.first_label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3, so speeds and times are wrong by %4</source>
        <translation>视图“%1”以 %2 录制，文件写的是 %3，因此速度和时间有 %4 的误差</translation>
    </message>
</context>
<context>
    <name>workflow.fitting_cameras_together</name>
    <message>
        <source>fitting %1 cameras jointly</source>
        <translation>正在联合拟合 %1 台相机</translation>
    </message>
</context>
<context>
    <name>workflow.fix_camera</name>
    <message>
        <source>fix the camera, register it again and repeat the run</source>
        <translation>请固定相机,重新配准并重做一次运行</translation>
    </message>
</context>
<context>
    <name>workflow.floor_has_its_colour</name>
    <message>
        <source>its colour %1 is also the floor&apos;s (%2 of the frame in view %3)</source>
        <translation>它的颜色 %1 也是地面的颜色（占视角 %3 画面的 %2）</translation>
    </message>
</context>
<context>
    <name>workflow.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>地垫</translation>
    </message>
</context>
<context>
    <name>workflow.folder</name>
    <message>
        <source>folder &apos;%1&apos;</source>
        <translation>文件夹“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_file</name>
    <message>
        <source>frame %1 of &apos;%2&apos;</source>
        <translation>“%2”的第 %1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_trial</name>
    <message>
        <source>frame %1 of trial &apos;%2&apos;</source>
        <translation>试验“%2”的第 %1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.frame_rate_of</name>
    <message>
        <source>frame rate of %1</source>
        <translation>%1 的帧率</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled</name>
    <message>
        <source>up to %1 frames repeat for %2; later times were corrected</source>
        <translation>到 %1 为止，帧重复了 %2；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled_unseen</name>
    <message>
        <source>after %1 %2 frames repeat the one before, and its time stamps count them as time; later times were corrected</source>
        <translation>%1 之后有 %2 帧重复前一帧，而其时间戳将它们计为时间；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.frames_frozen</name>
    <message>
        <source>after %1 %2 frames show the same image while the robot went on; they were not measured</source>
        <translation>%1 之后有 %2 帧显示同一图像，而机器人仍在移动；这些帧未被测量</translation>
    </message>
</context>
<context>
    <name>workflow.frames_lost</name>
    <message>
        <source>after %1 the frames of %2 are missing, because the camera paused or lost them; later times were corrected</source>
        <translation>%1 之后缺少 %2 的帧，因为相机暂停或丢失了这些帧；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing</name>
    <message>
        <source>%1 without a frame, where %2 is usual; frames are missing, or its time stamps jump</source>
        <translation>有 %1 没有帧，通常为 %2；帧缺失，或时间戳跳变</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing_unseen</name>
    <message>
        <source>after %1 %2 frames are missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>%1 之后缺少 %2 帧，而其时间戳没有显示：机器人移动得过远；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.frames_not_decoded</name>
    <message>
        <source>%1 of its %2 frames are damaged and were not measured</source>
        <translation>其 %2 帧中有 %1 帧已损坏，未被测量</translation>
    </message>
</context>
<context>
    <name>workflow.frames_stood</name>
    <message>
        <source>after %1 the robot rests for %2 frames and then goes on at the same speed: either the frames repeat the one before and later times are too late, or the robot stopped; times were not corrected</source>
        <translation>%1 之后机器人静止 %2 帧，然后以相同速度继续：要么这些帧重复了前一帧，之后的时间因此偏晚，要么机器人停了下来；时间未校正</translation>
    </message>
</context>
<context>
    <name>workflow.frames_without_board</name>
    <message>
        <source>%1 frames: %2</source>
        <translation>%1 帧：%2</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_file</name>
    <message>
        <source>give another file</source>
        <translation>请给出另一文件</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_team</name>
    <message>
        <source>give another team, or change the class of this one</source>
        <translation>请指定其他小组，或更改该小组的班级</translation>
    </message>
</context>
<context>
    <name>workflow.give_camera_rate</name>
    <message>
        <source>give the rate at which the camera took the frames</source>
        <translation>请给出相机拍摄的帧率</translation>
    </message>
</context>
<context>
    <name>workflow.give_cameras</name>
    <message>
        <source>give one or more, like --camera A=sim:A</source>
        <translation>请在“相机…”中选择一台或多台</translation>
    </message>
</context>
<context>
    <name>workflow.give_chapter_once</name>
    <message>
        <source>give each file once, in their order</source>
        <translation>请按顺序将每个文件给出一次</translation>
    </message>
</context>
<context>
    <name>workflow.give_class_too</name>
    <message>
        <source>give its class too, or another team</source>
        <translation>请同时指定其班级，或指定其他小组</translation>
    </message>
</context>
<context>
    <name>workflow.give_date_of_run</name>
    <message>
        <source>give the date of the run</source>
        <translation>请指定运行的日期</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_file_once</name>
    <message>
        <source>give each file once, to its camera</source>
        <translation>请把每个文件只给对应的相机一次</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_frame_time</name>
    <message>
        <source>give one time for each frame</source>
        <translation>请为每一帧给出一个时间</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_its_file</name>
    <message>
        <source>give each camera its own video</source>
        <translation>请为每台相机指定各自的视频</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_robot_one</name>
    <message>
        <source>give each robot one</source>
        <translation>请给每个机器人一条</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_view_its_camera</name>
    <message>
        <source>give each view its own camera</source>
        <translation>请给每个视角各自的相机</translation>
    </message>
</context>
<context>
    <name>workflow.give_height_below_camera</name>
    <message>
        <source>give a height below the camera</source>
        <translation>请给出低于相机的高度</translation>
    </message>
</context>
<context>
    <name>workflow.give_limits_of_fastest</name>
    <message>
        <source>give the task the limits of its fastest robot</source>
        <translation>请为任务设定其最快机器人的限值</translation>
    </message>
</context>
<context>
    <name>workflow.give_offset_for_each</name>
    <message>
        <source>give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto</source>
        <translation>请为除第一个外的每个视角给出一个偏移，或选择“由运动或闪光得出”</translation>
    </message>
</context>
<context>
    <name>workflow.give_one_table</name>
    <message>
        <source>give one table for each view</source>
        <translation>请为每个视图给出一个表格</translation>
    </message>
</context>
<context>
    <name>workflow.give_own_colours</name>
    <message>
        <source>give each its own colour</source>
        <translation>请给每个机器人一种自己的颜色</translation>
    </message>
</context>
<context>
    <name>workflow.give_picture_of_that_size</name>
    <message>
        <source>give an image of that size</source>
        <translation>请给出该尺寸的图像</translation>
    </message>
</context>
<context>
    <name>workflow.give_pixels_or_picture</name>
    <message>
        <source>give the markers&apos; pixels, or an image or a video of the floor</source>
        <translation>提供标记的像素，或地面的图像或视频</translation>
    </message>
</context>
<context>
    <name>workflow.give_pre_roll</name>
    <message>
        <source>give a pre-roll of 0 to 30 seconds</source>
        <translation>请给出 0 到 30 秒的预录时长</translation>
    </message>
</context>
<context>
    <name>workflow.give_range_in_seconds</name>
    <message>
        <source>give its start and end in seconds</source>
        <translation>请以秒为单位给出起点和终点</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_table</name>
    <message>
        <source>give one of them</source>
        <translation>请给出其中之一</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_times</name>
    <message>
        <source>give their rate or a table of their times, like --rate 30 or --times A=stamps.csv</source>
        <translation>请输入相机的实际帧率</translation>
    </message>
</context>
<context>
    <name>workflow.give_seconds</name>
    <message>
        <source>give the seconds, such as 10</source>
        <translation>请给出秒数，如 10</translation>
    </message>
</context>
<context>
    <name>workflow.give_start_first</name>
    <message>
        <source>give the start first, then a later end</source>
        <translation>请先给出起点，再给出更晚的终点</translation>
    </message>
</context>
<context>
    <name>workflow.give_table_of_times</name>
    <message>
        <source>give a table of their times, like --times A=stamps.csv</source>
        <translation>请以 1 为步长编号</translation>
    </message>
</context>
<context>
    <name>workflow.give_task</name>
    <message>
        <source>give %1 the task %2</source>
        <translation>将任务 %2 赋予 %1</translation>
    </message>
</context>
<context>
    <name>workflow.give_team</name>
    <message>
        <source>assign %1 to team %2</source>
        <translation>将 %1 分配给小组 %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_team_too</name>
    <message>
        <source>give it a team too</source>
        <translation>请同时指定小组</translation>
    </message>
</context>
<context>
    <name>workflow.give_their_task</name>
    <message>
        <source>give the task that has them</source>
        <translation>请指定包含它们的任务</translation>
    </message>
</context>
<context>
    <name>workflow.give_times_to_view</name>
    <message>
        <source>name the camera of one of the videos</source>
        <translation>请指明其中一个视频的相机</translation>
    </message>
</context>
<context>
    <name>workflow.give_tracks</name>
    <message>
        <source>give one or more, like --track R=run.csv</source>
        <translation>请选择一条或多条</translation>
    </message>
</context>
<context>
    <name>workflow.give_views</name>
    <message>
        <source>give one view or more, like --video A=a.mp4</source>
        <translation>请选择一个或多个视角</translation>
    </message>
</context>
<context>
    <name>workflow.give_zone_of_task</name>
    <message>
        <source>give the name of one of its zones</source>
        <translation>请给出其某个区域的名称</translation>
    </message>
</context>
<context>
    <name>workflow.guidance_of_view</name>
    <message>
        <source>guidance in view &apos;%1&apos;</source>
        <translation>视图“%1”中的跟踪引导</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_found</name>
    <message>
        <source>it found robot &apos;%1&apos; in only %2 of the frames in which it should be visible, and the other positions are not checked by a second view</source>
        <translation>在应当可见的帧中，只有 %2 找到了机器人“%1”，其余位置没有第二个视角来核对</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_possible</name>
    <message>
        <source>a robot hardly moves at %1 with %2; check units and scale</source>
        <translation>机器人几乎不可能以 %1、%2 运动；请检查单位和比例</translation>
    </message>
</context>
<context>
    <name>workflow.has_no_two_views</name>
    <message>
        <source>it does not have two views</source>
        <translation>它没有两个视角</translation>
    </message>
</context>
<context>
    <name>workflow.height_above_camera</name>
    <message>
        <source>it is only %1 above the floor, but the points would be at %2</source>
        <translation>它离地面只有 %1，而这些点会在 %2</translation>
    </message>
</context>
<context>
    <name>workflow.image_with_video</name>
    <message>
        <source>one is an image and the other a video</source>
        <translation>一个是图片，另一个是视频</translation>
    </message>
</context>
<context>
    <name>workflow.images</name>
    <message>
        <source>images &apos;%1&apos;</source>
        <translation>图片“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.images_missing</name>
    <message>
        <source>missing numbers: %1, the first behind %2; their frames count as lost, and the others keep their times</source>
        <translation>缺少的编号：%1 个，首个在 %2 之后；其帧视为丢失，其余保持各自的时间</translation>
    </message>
</context>
<context>
    <name>workflow.images_share_number</name>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; have the same number</source>
        <translation>“%1”和“%2”的编号相同</translation>
    </message>
</context>
<context>
    <name>workflow.images_without_times</name>
    <message>
        <source>images have no times</source>
        <translation>图片没有时间</translation>
    </message>
</context>
<context>
    <name>workflow.import_lens</name>
    <message>
        <source>import the lens calibration of camera %1 from %2</source>
        <translation>从 %2 导入相机 %1 的镜头</translation>
    </message>
</context>
<context>
    <name>workflow.import_of_trial</name>
    <message>
        <source>import of trial &apos;%1&apos;</source>
        <translation>导入试验“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.import_parts</name>
    <message>
        <source>import each of these files as its own trial</source>
        <translation>将每个文件作为单独的试验导入</translation>
    </message>
</context>
<context>
    <name>workflow.import_roster</name>
    <message>
        <source>import the roster %1</source>
        <translation>导入名单 %1</translation>
    </message>
</context>
<context>
    <name>workflow.import_to_turn</name>
    <message>
        <source>import the video again to measure it as it is shown</source>
        <translation>重新导入视频，以便按其显示的样子测量</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial</name>
    <message>
        <source>import trial %1</source>
        <translation>导入试验 %1</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial_from</name>
    <message>
        <source>import trial %1 from %2</source>
        <translation>从 %2 导入试验 %1</translation>
    </message>
</context>
<context>
    <name>workflow.interface_of_live_positions</name>
    <message>
        <source>interface &apos;%1&apos; of live positions</source>
        <translation>实时位置的网络接口“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced</name>
    <message>
        <source>it is interlaced: each frame holds two fields taken one after the other, and each is measured at its own time, with half the lines</source>
        <translation>它是隔行扫描的：每帧包含先后拍摄的两个场，每个场按其自身的时间测量，只有一半的行</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced_whole</name>
    <message>
        <source>it is interlaced, but was measured by whole frames, of which each shows two moments; import it as a new trial to have each field measured at its own time</source>
        <translation>它是隔行扫描的，但按整帧测量，而每帧显示两个时刻；请将其作为新试验导入，以便按各自的时间测量每个场</translation>
    </message>
</context>
<context>
    <name>workflow.intrinsics_of_camera</name>
    <message>
        <source>intrinsics of camera &apos;%1&apos;</source>
        <translation>相机“%1”的内参</translation>
    </message>
</context>
<context>
    <name>workflow.is_being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>正在录制</translation>
    </message>
</context>
<context>
    <name>workflow.join_or_name_camera</name>
    <message>
        <source>give each view a camera of its own, or join the files of one recording with +, like --video A=1.mp4+2.mp4</source>
        <translation>请为每个视图指定各自的相机，或用 + 连接同一录像的文件</translation>
    </message>
</context>
<context>
    <name>workflow.joined_videos</name>
    <message>
        <source>videos &apos;%1&apos;</source>
        <translation>视频“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.keep_less_before</name>
    <message>
        <source>record fewer seconds before the start, or smaller frames</source>
        <translation>请减少开始前录制的秒数，或使用较小的画面</translation>
    </message>
</context>
<context>
    <name>workflow.keeping_pictures</name>
    <message>
        <source>saving the images</source>
        <translation>正在保存图片</translation>
    </message>
</context>
<context>
    <name>workflow.kept_before_start</name>
    <message>
        <source>only the %1 before the start were kept: %2 of this camera need more than %3</source>
        <translation>只保留了开始前的 %1：此相机的 %2 需要超过 %3 的内存</translation>
    </message>
</context>
<context>
    <name>workflow.label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3</source>
        <translation>视图“%1”以 %2 录制，文件写的是 %3</translation>
    </message>
</context>
<context>
    <name>workflow.labels_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2 (its file says %3), or view &apos;%4&apos; at %5 (its file says %6); speeds and times are by the file of view &apos;%4&apos;</source>
        <translation>视图“%1”以 %2 录制（文件写的是 %3），或者视图“%4”以 %5 录制（文件写的是 %6）；速度和时间以视图“%4”的文件为准</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frame</name>
    <message>
        <source>remove the override of frame %1 of %2</source>
        <translation>将 %2 的第 %1 帧交给程序判断</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frames</name>
    <message>
        <source>remove the overrides of %1 samples of %2</source>
        <translation>移除 %2 的 %1 个采样点的手动设置</translation>
    </message>
</context>
<context>
    <name>workflow.leave_one_mat</name>
    <message>
        <source>leave one mat on the floor, and use newer files</source>
        <translation>地面上只留一张地垫，并使用更新的文件</translation>
    </message>
</context>
<context>
    <name>workflow.leave_out_trial</name>
    <message>
        <source>remove %1, which recorded nothing</source>
        <translation>舍去 %1（未录到任何内容）</translation>
    </message>
</context>
<context>
    <name>workflow.lens_at_other_size</name>
    <message>
        <source>its frames are %1, but the lens was calibrated at %2</source>
        <translation>其帧为 %1，而镜头在 %2 下标定</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_columns</name>
    <message>
        <source>The lens calibration at %1 was cropped on both sides to %2, as the markers confirm.</source>
        <translation>%1 下的镜头标定已在左右两侧裁剪为 %2，标记证实了这一点。</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_rows</name>
    <message>
        <source>The lens calibration at %1 was cropped above and below to %2, as the markers confirm.</source>
        <translation>%1 下的镜头标定已在上下裁剪为 %2，标记证实了这一点。</translation>
    </message>
</context>
<context>
    <name>workflow.lens_enlarged</name>
    <message>
        <source>The lens calibration at %1 was fitted to %2 by the markers, which show that the image is enlarged by a factor of %3 (± %4).</source>
        <translation>%1 下的镜头标定已根据标记适配到 %2，标记表明图像放大了 %3 倍（± %4）。</translation>
    </message>
</context>
<context>
    <name>workflow.lens_imported_from</name>
    <message>
        <source>imported from %1</source>
        <translation>从 %1 导入</translation>
    </message>
</context>
<context>
    <name>workflow.lens_never_calibrated</name>
    <message>
        <source>The lens of camera &apos;%1&apos; is neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>相机“%1”的镜头既未标定，也未由地面标记确定</translation>
    </message>
</context>
<context>
    <name>workflow.lens_part_unknown</name>
    <message>
        <source>The lens calibration at %1 was cropped to %2, but the markers do not show whether the image is enlarged as well, so its focal length is known only to %3: calibrate the lens at %2, or use more markers.</source>
        <translation>%1 下的镜头标定已裁剪为 %2，但标记无法表明图像是否另有放大，因此焦距只能确定到 %3：请在 %2 下标定镜头，或使用更多标记。</translation>
    </message>
</context>
<context>
    <name>workflow.lens_scaled</name>
    <message>
        <source>The lens calibration at %1 was converted to %2.</source>
        <translation>%1 下的镜头标定已换算为 %2。</translation>
    </message>
</context>
<context>
    <name>workflow.lens_turned_either_way</name>
    <message>
        <source>Which way the camera was turned since is not known, so the centre of its images is less certain.</source>
        <translation>此后相机朝哪个方向旋转不得而知，因此其图像中心不太确定。</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_video</name>
    <message>
        <source>link a lost video</source>
        <translation>关联一个丢失的视频</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_videos</name>
    <message>
        <source>link %1 lost videos</source>
        <translation>关联 %1 个丢失的视频</translation>
    </message>
</context>
<context>
    <name>workflow.little_common_time</name>
    <message>
        <source>%1 and %2 long, %3 in common</source>
        <translation>长 %1 和 %2，共同 %3</translation>
    </message>
</context>
<context>
    <name>workflow.live_positions_to</name>
    <message>
        <source>live positions to %1</source>
        <translation>发送到 %1 的实时位置</translation>
    </message>
</context>
<context>
    <name>workflow.live_tracking</name>
    <message>
        <source>live tracking</source>
        <translation>实时跟踪</translation>
    </message>
</context>
<context>
    <name>workflow.look_at_outlines</name>
    <message>
        <source>check the outlines, and set the robot&apos;s colour or keep other objects out of view</source>
        <translation>请查看轮廓，并指定机器人的颜色，或不要让其他东西进入画面</translation>
    </message>
</context>
<context>
    <name>workflow.look_for_lost_videos</name>
    <message>
        <source>search for lost videos</source>
        <translation>查找丢失的视频</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in</name>
    <message>
        <source>detecting the board in %1</source>
        <translation>正在 %1 中寻找标定板</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in_both</name>
    <message>
        <source>detecting the board in %1 and %2</source>
        <translation>正在 %1 和 %2 中寻找标定板</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_files</name>
    <message>
        <source>searching for files</source>
        <translation>正在查找文件</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_again</name>
    <message>
        <source>detecting the markers again</source>
        <translation>正在重新寻找标记</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_in</name>
    <message>
        <source>detecting the markers in %1</source>
        <translation>正在 %1 中寻找标记</translation>
    </message>
</context>
<context>
    <name>workflow.looking_through_media</name>
    <message>
        <source>searching the media folder</source>
        <translation>正在查看媒体文件夹</translation>
    </message>
</context>
<context>
    <name>workflow.lost_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is lost and is not in the packed project</source>
        <translation>试验“%2”中相机 %1 的视频丢失，未包含在打包项目中</translation>
    </message>
</context>
<context>
    <name>workflow.lost_video_not_there</name>
    <message>
        <source>the lost video is not in this folder</source>
        <translation>丢失的视频不在那里</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos</name>
    <message>
        <source>lost videos</source>
        <translation>丢失的视频</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos_not_there</name>
    <message>
        <source>none of the %1 lost videos is in this folder</source>
        <translation>%1 个丢失的视频都不在那里</translation>
    </message>
</context>
<context>
    <name>workflow.made_through_registration</name>
    <message>
        <source>It was made via registration %1 of the project.</source>
        <translation>它是通过项目的配准 %1 作出的。</translation>
    </message>
</context>
<context>
    <name>workflow.made_with_it_already</name>
    <message>
        <source>it already uses that calibration</source>
        <translation>已是用它完成的</translation>
    </message>
</context>
<context>
    <name>workflow.making_hash</name>
    <message>
        <source>computing the hash of %1</source>
        <translation>正在计算 %1 的校验值</translation>
    </message>
</context>
<context>
    <name>workflow.many_spikes</name>
    <message>
        <source>%1 spikes in %2 positions</source>
        <translation>%2 个位置中有 %1 个异常点</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind</name>
    <message>
        <source>the map is %1 behind, no frame skipped</source>
        <translation>地图滞后 %1，无跳帧</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind_and_skipping</name>
    <message>
        <source>the map is %1 behind, %2 frames skipped</source>
        <translation>地图滞后 %1，跳过 %2</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spike</name>
    <message>
        <source>mark frame %1 of %2 as a spike</source>
        <translation>将 %2 的第 %1 帧标为异常点</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spikes</name>
    <message>
        <source>mark %1 samples of %2 as spikes</source>
        <translation>将 %2 的 %1 个采样点标为异常点</translation>
    </message>
</context>
<context>
    <name>workflow.markers_for_camera</name>
    <message>
        <source>markers for camera &apos;%1&apos;</source>
        <translation>相机“%1”的标记</translation>
    </message>
</context>
<context>
    <name>workflow.measure_again</name>
    <message>
        <source>reanalyse %1</source>
        <translation>重新测量 %1</translation>
    </message>
</context>
<context>
    <name>workflow.measure_check_line</name>
    <message>
        <source>measure the line from end mark to end mark</source>
        <translation>请从一端标记到另一端标记测量该线</translation>
    </message>
</context>
<context>
    <name>workflow.measure_height</name>
    <message>
        <source>measure its height, enter it and reanalyse</source>
        <translation>请测量其高度,输入后重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.measure_it_again</name>
    <message>
        <source>repeat the analysis</source>
        <translation>请重新测量</translation>
    </message>
</context>
<context>
    <name>workflow.measured_as_stored</name>
    <message>
        <source>an earlier version measured its frames as stored, but its file says to turn, mirror or stretch them</source>
        <translation>较早的版本按存储的样子测量了其帧，但其文件要求旋转、镜像或拉伸它们</translation>
    </message>
</context>
<context>
    <name>workflow.measured_frames</name>
    <message>
        <source>only %1 of the frames give a position</source>
        <translation>只有 %1 的帧给出位置</translation>
    </message>
</context>
<context>
    <name>workflow.measured_in_part</name>
    <message>
        <source>%1 of %2 were measured; lengths, times and maxima are at least as large as stated</source>
        <translation>%2 中测量了 %1；长度、时间和最大值至少为所示的值</translation>
    </message>
</context>
<context>
    <name>workflow.metric_named</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>指标“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.more_frame_steps</name>
    <message>
        <source>up to %1 its frames are wrong at %2 more moments in the same way</source>
        <translation>到 %1 为止，其帧在另外 %2 处有同样的错误</translation>
    </message>
</context>
<context>
    <name>workflow.moved_since</name>
    <message>
        <source>it was found moved by %1 since the registration that was used</source>
        <translation>自所用配准以来发现移动了 %1</translation>
    </message>
</context>
<context>
    <name>workflow.name_another_camera</name>
    <message>
        <source>name another camera that is registered</source>
        <translation>请指定另一台已配准的相机</translation>
    </message>
</context>
<context>
    <name>workflow.name_image_series</name>
    <message>
        <source>give a folder with images such as 000001.png, or a pattern such as FOLDER/%1</source>
        <translation>请给出含 000001.png 之类图片的文件夹，或 FOLDER/%1 之类的模式</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_camera</name>
    <message>
        <source>name one of its cameras</source>
        <translation>请指定它的一台相机</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_robot</name>
    <message>
        <source>name one of its robots</source>
        <translation>请指定它的一个机器人</translation>
    </message>
</context>
<context>
    <name>workflow.name_one_series</name>
    <message>
        <source>name one of them, like FOLDER/%1</source>
        <translation>请指明其中之一，如 FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_place_in_pixels</name>
    <message>
        <source>give it in pixels from the frame&apos;s top left corner</source>
        <translation>请以像素为单位、从画面左上角算起指定</translation>
    </message>
</context>
<context>
    <name>workflow.name_robot_after_track</name>
    <message>
        <source>give the robot the name of one of them</source>
        <translation>请给机器人取其中之一的名称</translation>
    </message>
</context>
<context>
    <name>workflow.name_time_within_trial</name>
    <message>
        <source>name a time within the trial, in seconds</source>
        <translation>请指定试验之内的时刻，以秒为单位</translation>
    </message>
</context>
<context>
    <name>workflow.name_two_cameras</name>
    <message>
        <source>name two cameras</source>
        <translation>请指定两台相机</translation>
    </message>
</context>
<context>
    <name>workflow.nearly_all_beyond_limits</name>
    <message>
        <source>nearly all samples exceed the limits of task &apos;%1&apos;, so the limits were ignored</source>
        <translation>所测数据几乎都超出任务“%1”的限值，因此未采用这些限值</translation>
    </message>
</context>
<context>
    <name>workflow.neither_lens_nor_recording</name>
    <message>
        <source>it has no intrinsics and no recording</source>
        <translation>没有内参也没有录像</translation>
    </message>
</context>
<context>
    <name>workflow.never_calibrated</name>
    <message>
        <source>it was never calibrated</source>
        <translation>从未标定</translation>
    </message>
</context>
<context>
    <name>workflow.new_project</name>
    <message>
        <source>new project</source>
        <translation>新项目</translation>
    </message>
</context>
<context>
    <name>workflow.no_address_with_port</name>
    <message>
        <source>it is not an IPv4 address with a port</source>
        <translation>不是带端口的 IPv4 地址</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_gave_picture</name>
    <message>
        <source>no camera delivered a frame</source>
        <translation>没有相机给出画面</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_given</name>
    <message>
        <source>no camera was given</source>
        <translation>没有给出相机</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_registered</name>
    <message>
        <source>no camera is registered to the floor</source>
        <translation>没有相机配准到地面</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_place</name>
    <message>
        <source>The two analyses have no position in common.</source>
        <translation>没有任何位置被两次分析都测到。</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_time</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos; do not overlap with a time offset of %3</source>
        <translation>视角“%1”和“%2”在偏移 %3 时没有共同时间</translation>
    </message>
</context>
<context>
    <name>workflow.no_counterpart</name>
    <message>
        <source>the other camera has no file of its number</source>
        <translation>另一台相机没有该编号的文件</translation>
    </message>
</context>
<context>
    <name>workflow.no_floor_to_watch</name>
    <message>
        <source>none of its cameras is registered to the floor, so nothing there starts or ends it</source>
        <translation>没有相机与地面配准，因此地面上的动作无法使其开始或结束</translation>
    </message>
</context>
<context>
    <name>workflow.no_image_series</name>
    <message>
        <source>there are no numbered images (PNG, JPEG, TIFF, BMP, WebP) of that name</source>
        <translation>没有该名称的编号图片（PNG、JPEG、TIFF、BMP、WebP）</translation>
    </message>
</context>
<context>
    <name>workflow.no_live_positions</name>
    <message>
        <source>none of its cameras is registered to the floor, so there are no live positions to send</source>
        <translation>没有一台相机已对地面配准，因此没有实时位置可发送</translation>
    </message>
</context>
<context>
    <name>workflow.no_mat_seen</name>
    <message>
        <source>no file shows four or more of its tags</source>
        <translation>没有文件显示其四个或更多标签</translation>
    </message>
</context>
<context>
    <name>workflow.no_motion</name>
    <message>
        <source>no robot moves in it</source>
        <translation>其中没有机器人运动</translation>
    </message>
</context>
<context>
    <name>workflow.no_multicast</name>
    <message>
        <source>interface &apos;%1&apos; does not support multicast</source>
        <translation>接口“%1”不支持组播</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_read</name>
    <message>
        <source>no image could be read</source>
        <translation>没有一张图片可读</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_then</name>
    <message>
        <source>the view has no frame at that time</source>
        <translation>该视角在那个时刻没有画面</translation>
    </message>
</context>
<context>
    <name>workflow.no_pixels_no_picture</name>
    <message>
        <source>it needs pixels, or an image to detect the markers in</source>
        <translation>既没有给出像素，也没有给出可查找的图像</translation>
    </message>
</context>
<context>
    <name>workflow.no_robot</name>
    <message>
        <source>the project has no robot to track</source>
        <translation>项目中没有可寻找的机器人</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample</name>
    <message>
        <source>the analysis has no sample</source>
        <translation>该分析没有采样点</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample_in_group</name>
    <message>
        <source>no sample from %1 to %2 is to be changed</source>
        <translation>%1 至 %2 之间没有要更改的采样点</translation>
    </message>
</context>
<context>
    <name>workflow.no_socket</name>
    <message>
        <source>the system could not open a socket</source>
        <translation>本机无法提供套接字</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_frame</name>
    <message>
        <source>this frame does not exist</source>
        <translation>没有这一帧</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_interface</name>
    <message>
        <source>this computer has no interface of that name</source>
        <translation>本机没有该名称的接口</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_metric</name>
    <message>
        <source>no trial of the project has it</source>
        <translation>项目中没有任何试验有它</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_view</name>
    <message>
        <source>the trial has no such view</source>
        <translation>该试验没有这个视角</translation>
    </message>
</context>
<context>
    <name>workflow.no_task_for_gate</name>
    <message>
        <source>gates and zones are a task&apos;s, and none was given</source>
        <translation>门和区域属于任务，而未给出任务</translation>
    </message>
</context>
<context>
    <name>workflow.no_times_in_file</name>
    <message>
        <source>it has no time stamps and states no frame rate</source>
        <translation>它没有时间戳，也未给出帧率</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_given</name>
    <message>
        <source>no track was given</source>
        <translation>没有给出轨迹</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_imported</name>
    <message>
        <source>no track of it was imported</source>
        <translation>没有导入它的轨迹</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_of_that_name</name>
    <message>
        <source>none of its tracks is called &apos;%1&apos;; it has %2</source>
        <translation>其中没有名为“%1”的轨迹；已有：%2</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_given</name>
    <message>
        <source>no video was given</source>
        <translation>没有给出视频</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_lost</name>
    <message>
        <source>no video of this project is lost</source>
        <translation>此项目没有丢失的视频</translation>
    </message>
</context>
<context>
    <name>workflow.none_of_that_number</name>
    <message>
        <source>camera &apos;%1&apos; has no such number</source>
        <translation>相机“%1”没有此编号</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_in_range</name>
    <message>
        <source>it contains no sample of robot &apos;%1&apos; (%2 to %3)</source>
        <translation>其中没有机器人“%1”的采样点（%2 到 %3）</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_there</name>
    <message>
        <source>the robot has no measurement at that time</source>
        <translation>机器人在那里没有被测到，无从判断</translation>
    </message>
</context>
<context>
    <name>workflow.not_synchronised</name>
    <message>
        <source>it is not synchronised: the same start time as the first view was assumed, and positions of a moving robot are wrong</source>
        <translation>它未同步，按与第一个视角同时开始处理，因此运动的机器人并不在两个视角所示的位置</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_in_trial</name>
    <message>
        <source>it is not tracked in trial &apos;%1&apos;</source>
        <translation>试验“%1”中没有跟踪它</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_yet</name>
    <message>
        <source>it has not been tracked yet</source>
        <translation>尚未跟踪</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_came</name>
    <message>
        <source>no frame arrived for %1 because %2</source>
        <translation>有 %1 没有任何图像，原因：%2</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_recorded</name>
    <message>
        <source>nothing was recorded</source>
        <translation>什么也没有录制</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_said_there</name>
    <message>
        <source>that frame has no manual override</source>
        <translation>那里没有手动标注</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_stands_out</name>
    <message>
        <source>no foreground object was found at pixel %1,%2 at %3</source>
        <translation>在 %3 前后的若干帧中，%1,%2 处没有从地面中突出的物体</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_accept</name>
    <message>
        <source>all checks were passed</source>
        <translation>所有检查均已通过</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_analyse_again</name>
    <message>
        <source>it has not been tracked yet, so it cannot be reanalysed</source>
        <translation>尚未跟踪，没有可重新分析的内容</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_do</name>
    <message>
        <source>no action is needed</source>
        <translation>无需操作</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_withdraw</name>
    <message>
        <source>leave it as it is</source>
        <translation>保持原样即可</translation>
    </message>
</context>
<context>
    <name>workflow.number_files_alike</name>
    <message>
        <source>give as many of each, in the same order, or number their names alike</source>
        <translation>请按相同顺序各给出相同数量，或让文件名编号一致</translation>
    </message>
</context>
<context>
    <name>workflow.number_images_once</name>
    <message>
        <source>give each image a number of its own</source>
        <translation>请为每张图片指定各自的编号</translation>
    </message>
</context>
<context>
    <name>workflow.numbers_count_no_frames</name>
    <message>
        <source>their numbers go from %1 to %2, and there are %3 images: they do not count frames</source>
        <translation>其编号从 %1 到 %2，而图片有 %3 张：编号并非帧计数</translation>
    </message>
</context>
<context>
    <name>workflow.offsets_of_other_count</name>
    <message>
        <source>the number of views is %1, the number of offsets %2</source>
        <translation>给出了 %1 个视角和 %2 个偏移</translation>
    </message>
</context>
<context>
    <name>workflow.old_calibration</name>
    <message>
        <source>The lens calibration of camera &apos;%1&apos; is %2 days old</source>
        <translation>相机“%1”的镜头标定已有 %2 天</translation>
    </message>
</context>
<context>
    <name>workflow.old_registration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; is %2 days old</source>
        <translation>相机“%1”的地面配准已有 %2 天</translation>
    </message>
</context>
<context>
    <name>workflow.one_follows_something_else</name>
    <message>
        <source>one of them tracks another object, or has moved since its registration</source>
        <translation>其中一个视角跟踪了别的东西，或者相机不在配准时的位置</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_doubled</name>
    <message>
        <source>after %1 a frame repeats the one before, and its time stamps count it as time; later times were corrected</source>
        <translation>%1 之后有一帧重复前一帧，而其时间戳将其计为时间；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_missing</name>
    <message>
        <source>after %1 a frame is missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>%1 之后缺少一帧，而其时间戳没有显示：机器人移动得过远；之后的时间已校正</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_stood</name>
    <message>
        <source>after %1 the robot rests for a frame and then goes on at the same speed: either the frame repeats the one before and later times are too late, or the robot stopped; times were not corrected</source>
        <translation>%1 之后机器人静止一帧，然后以相同速度继续：要么该帧重复了前一帧，之后的时间因此偏晚，要么机器人停了下来；时间未校正</translation>
    </message>
</context>
<context>
    <name>workflow.only_frame</name>
    <message>
        <source>its only frame is 0</source>
        <translation>只有第 0 帧</translation>
    </message>
</context>
<context>
    <name>workflow.open_it_or_elsewhere</name>
    <message>
        <source>open it, or choose another folder</source>
        <translation>请打开它，或选择另一文件夹</translation>
    </message>
</context>
<context>
    <name>workflow.other_sample_judged</name>
    <message>
        <source>another sample was overridden while this one was analysed</source>
        <translation>分析此样本时，另一个样本被手动判定</translation>
    </message>
</context>
<context>
    <name>workflow.outside_picture</name>
    <message>
        <source>the position is outside the frame</source>
        <translation>该位置在画面之外</translation>
    </message>
</context>
<context>
    <name>workflow.pair_like_files</name>
    <message>
        <source>pair images with images and videos with videos</source>
        <translation>请把图片与图片、视频与视频配对</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_cameras</name>
    <message>
        <source>the relative position of cameras &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>相机“%1”和“%2”的相对位置</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_one_camera</name>
    <message>
        <source>both are the same camera</source>
        <translation>两者是同一台相机</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_other_size</name>
    <message>
        <source>&apos;%1&apos; is %2, but the camera was calibrated at %3</source>
        <translation>“%1”为 %2，而相机在 %3 下标定</translation>
    </message>
</context>
<context>
    <name>workflow.paired_files</name>
    <message>
        <source>the files of the two cameras</source>
        <translation>两台相机的文件</translation>
    </message>
</context>
<context>
    <name>workflow.passed_cameras</name>
    <message>
        <source>no camera was found moved</source>
        <translation>未发现相机移动</translation>
    </message>
</context>
<context>
    <name>workflow.passed_decoding</name>
    <message>
        <source>all frames could be decoded</source>
        <translation>所有帧均可解码</translation>
    </message>
</context>
<context>
    <name>workflow.passed_frames</name>
    <message>
        <source>the frames came at regular intervals</source>
        <translation>帧间隔均匀</translation>
    </message>
</context>
<context>
    <name>workflow.passed_lens</name>
    <message>
        <source>the lenses are calibrated, or estimated from the floor&apos;s markers</source>
        <translation>镜头已标定，或由地面标记估计</translation>
    </message>
</context>
<context>
    <name>workflow.passed_motion</name>
    <message>
        <source>speeds and accelerations are possible</source>
        <translation>速度和加速度是可能的</translation>
    </message>
</context>
<context>
    <name>workflow.passed_names</name>
    <message>
        <source>no robot could be another one</source>
        <translation>没有机器人可能被认错</translation>
    </message>
</context>
<context>
    <name>workflow.passed_precision</name>
    <message>
        <source>positions are precise for the run&apos;s extent</source>
        <translation>相对于行驶范围，位置足够精确</translation>
    </message>
</context>
<context>
    <name>workflow.passed_results</name>
    <message>
        <source>the stored results are as computed</source>
        <translation>存储的结果与计算的一致</translation>
    </message>
</context>
<context>
    <name>workflow.passed_scatter</name>
    <message>
        <source>positions scatter little for the run&apos;s extent; errors that change slowly do not show, and are covered only where the accuracy of the source is given</source>
        <translation>相对于行驶范围，位置的散布很小；缓慢变化的误差显现不出来，只有给出来源的准确度时才包括在内</translation>
    </message>
</context>
<context>
    <name>workflow.passed_spikes</name>
    <message>
        <source>few positions are spikes</source>
        <translation>异常点位置很少</translation>
    </message>
</context>
<context>
    <name>workflow.passed_synchronisation</name>
    <message>
        <source>the views are synchronised</source>
        <translation>各视角已同步</translation>
    </message>
</context>
<context>
    <name>workflow.passed_time</name>
    <message>
        <source>the robots were measured all the time</source>
        <translation>机器人全程被测量</translation>
    </message>
</context>
<context>
    <name>workflow.passed_views</name>
    <message>
        <source>the views agree</source>
        <translation>各视角一致</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_here</name>
    <message>
        <source>1 frame was lost because this computer or its disk was too slow</source>
        <translation>因本机或其磁盘太慢，丢失 1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_on_wire</name>
    <message>
        <source>1 frame was lost between the camera and this program</source>
        <translation>相机与本程序之间丢失 1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.picture_made_too_late</name>
    <message>
        <source>1 frame was lost: this computer was too slow to generate it in time</source>
        <translation>因本机太慢来不及生成，丢失 1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.picture_size_not_known</name>
    <message>
        <source>the size of its images is not known</source>
        <translation>其画面尺寸未知</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_here</name>
    <message>
        <source>%1 frames were lost because this computer or its disk was too slow</source>
        <translation>因本机或其磁盘太慢，丢失 %1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_on_wire</name>
    <message>
        <source>%1 frames were lost between the camera and this program</source>
        <translation>相机与本程序之间丢失 %1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_made_too_late</name>
    <message>
        <source>%1 frames were lost: this computer was too slow to generate them in time</source>
        <translation>因本机太慢来不及生成，丢失 %1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.point_out_whole_robot</name>
    <message>
        <source>point it out where the whole robot is visible and moving</source>
        <translation>请在能看到整个机器人且它在移动的地方指出</translation>
    </message>
</context>
<context>
    <name>workflow.positions_change</name>
    <message>
        <source>Positions change by %1 RMS, at most by %2 (at %3).</source>
        <translation>位置变化 %1 RMS，最大 %2（在 %3）。</translation>
    </message>
</context>
<context>
    <name>workflow.positions_rounded</name>
    <message>
        <source>rounded to %1</source>
        <translation>取整到 %1</translation>
    </message>
</context>
<context>
    <name>workflow.positions_uncertain</name>
    <message>
        <source>its positions are known to ±%1 only, in a run over %2</source>
        <translation>其位置仅精确到 ±%1，而行驶范围为 %2</translation>
    </message>
</context>
<context>
    <name>workflow.project_file_gone</name>
    <message>
        <source>the project file no longer exists</source>
        <translation>项目文件已不在</translation>
    </message>
</context>
<context>
    <name>workflow.project_lost</name>
    <message>
        <source>the project file was deleted, renamed or replaced; recording continues, and its contents will be saved at the end</source>
        <translation>项目文件被删除、重命名或替换；录制继续进行，结束时将挽救其内容</translation>
    </message>
</context>
<context>
    <name>workflow.project_rescued</name>
    <message>
        <source>the project file was deleted, renamed or replaced; its contents were saved in &apos;%1&apos;, the project from now on</source>
        <translation>项目文件在此期间被删除、重命名或替换；其内容已挽救到“%1”，今后它就是项目</translation>
    </message>
</context>
<context>
    <name>workflow.put_axes_elsewhere</name>
    <message>
        <source>change the world axes of layout %1</source>
        <translation>移动布局 %1 的坐标轴</translation>
    </message>
</context>
<context>
    <name>workflow.put_original_or_import</name>
    <message>
        <source>restore the original file, or import this one as another trial</source>
        <translation>请放回原文件，或将此文件作为另一次试验导入</translation>
    </message>
</context>
<context>
    <name>workflow.put_plate_on_it</name>
    <message>
        <source>put a plate of another colour on it, or set its true colour</source>
        <translation>请在其上放另一种颜色的板，或给出它真实的颜色</translation>
    </message>
</context>
<context>
    <name>workflow.range_is_reversed</name>
    <message>
        <source>its start %1 is not before its end %2</source>
        <translation>起点 %1 不早于终点 %2</translation>
    </message>
</context>
<context>
    <name>workflow.range_of_trial</name>
    <message>
        <source>range of trial &apos;%1&apos;</source>
        <translation>试验“%1”的区间</translation>
    </message>
</context>
<context>
    <name>workflow.range_outside_trial</name>
    <message>
        <source>%1 to %2 is not within the trial&apos;s time</source>
        <translation>%1 到 %2 不在试验的时间之内</translation>
    </message>
</context>
<context>
    <name>workflow.range_without_sample</name>
    <message>
        <source>it contains no sample</source>
        <translation>其中没有采样点</translation>
    </message>
</context>
<context>
    <name>workflow.rate_and_times</name>
    <message>
        <source>camera &apos;%1&apos; was given both a frame rate and frame times</source>
        <translation>给相机“%1”同时指定了帧率和帧时间</translation>
    </message>
</context>
<context>
    <name>workflow.rate_is_assumed</name>
    <message>
        <source>no recording shows it, so 30 frames/s are simulated</source>
        <translation>没有录像显示帧率，因此按 30 帧/s 模拟</translation>
    </message>
</context>
<context>
    <name>workflow.rate_of_header</name>
    <message>
        <source>its header states an even %1</source>
        <translation>其文件头给出恒定的 %1</translation>
    </message>
</context>
<context>
    <name>workflow.reanalyse_tracks</name>
    <message>
        <source>reanalyse them with: odograph track PROJECT TRIAL --again</source>
        <translation>请重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.record</name>
    <message>
        <source>record %1</source>
        <translation>录制 %1</translation>
    </message>
</context>
<context>
    <name>workflow.record_for_longer</name>
    <message>
        <source>record again, for longer</source>
        <translation>请重新录制，时间长一些</translation>
    </message>
</context>
<context>
    <name>workflow.record_it_again</name>
    <message>
        <source>record it again</source>
        <translation>请重新录制</translation>
    </message>
</context>
<context>
    <name>workflow.record_to_faster_disk</name>
    <message>
        <source>record to a faster disk</source>
        <translation>请录制到更快的磁盘</translation>
    </message>
</context>
<context>
    <name>workflow.recorded_at_another_size</name>
    <message>
        <source>The newest recording of camera &apos;%1&apos; is %2, its lens was calibrated at %3</source>
        <translation>相机“%1”的最新录像为 %2，其镜头在 %3 下标定</translation>
    </message>
</context>
<context>
    <name>workflow.recording</name>
    <message>
        <source>recording</source>
        <translation>正在录制</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_trial</name>
    <message>
        <source>recording of trial &apos;%1&apos;</source>
        <translation>录制试验“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_view</name>
    <message>
        <source>recording of view &apos;%1&apos;</source>
        <translation>视角“%1”的录像</translation>
    </message>
</context>
<context>
    <name>workflow.reference_not_calibrated</name>
    <message>
        <source>camera &apos;%1&apos; was registered without a lens calibration: register it again with it</source>
        <translation>相机“%1”是在没有镜头标定的情况下配准的：请用镜头标定重新配准</translation>
    </message>
</context>
<context>
    <name>workflow.register_a_camera</name>
    <message>
        <source>register the cameras first</source>
        <translation>请先配准相机</translation>
    </message>
</context>
<context>
    <name>workflow.register_both_again</name>
    <message>
        <source>register both again and reanalyse</source>
        <translation>请将两台都重新配准并重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera</name>
    <message>
        <source>register camera %1</source>
        <translation>配准相机 %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_again</name>
    <message>
        <source>register camera %1 again</source>
        <translation>重新配准相机 %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_anew</name>
    <message>
        <source>register the camera again</source>
        <translation>重新配准摄像机</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_through</name>
    <message>
        <source>register camera %1 via camera %2</source>
        <translation>通过相机 %2 配准相机 %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_again</name>
    <message>
        <source>register the cameras again</source>
        <translation>请重新配准相机</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_together</name>
    <message>
        <source>register the cameras of layout %1 jointly</source>
        <translation>联合配准布局 %1 的相机</translation>
    </message>
</context>
<context>
    <name>workflow.register_if_other_part</name>
    <message>
        <source>if the camera shows another part of the scene at that size, register it again in a frame of this video</source>
        <translation>如果相机在该尺寸下显示场景的另一部分，请在此视频的某一帧中重新配准</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_its_video</name>
    <message>
        <source>register the camera in a frame of this video, to which its lens calibration is then fitted</source>
        <translation>请在此视频的某一帧中配准相机，其镜头标定随后会适配到该帧</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_this_video</name>
    <message>
        <source>register the camera again in a frame of this video and reanalyse</source>
        <translation>请用此视频中的一帧重新配准相机，然后重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_again</name>
    <message>
        <source>register it again.</source>
        <translation>请重新配准。</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_first</name>
    <message>
        <source>register it first, with markers or via another camera</source>
        <translation>请先配准它，用标记或通过另一相机</translation>
    </message>
</context>
<context>
    <name>workflow.register_moved_again</name>
    <message>
        <source>register it again and reanalyse</source>
        <translation>请重新配准并重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_do_not_send</name>
    <message>
        <source>run odograph register for one of them, or leave --ssl-vision out</source>
        <translation>请配准其中一台，或不发送位置</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_give_seconds</name>
    <message>
        <source>register one of them, or give the seconds to record instead</source>
        <translation>请配准其中一台，或改为指定录制的秒数</translation>
    </message>
</context>
<context>
    <name>workflow.register_through_it_again</name>
    <message>
        <source>register it via that camera again</source>
        <translation>请再次通过那台相机配准</translation>
    </message>
</context>
<context>
    <name>workflow.register_upright</name>
    <message>
        <source>register the camera again</source>
        <translation>请重新配准相机</translation>
    </message>
</context>
<context>
    <name>workflow.registered_as_stored</name>
    <message>
        <source>its frames are turned or mirrored as its file says, but an earlier version registered camera &apos;%1&apos;, perhaps by frames as stored</source>
        <translation>其帧按文件要求旋转或镜像，但相机“%1”由早期版本配准，可能是按存储方向的帧</translation>
    </message>
</context>
<context>
    <name>workflow.registered_at_another_size</name>
    <message>
        <source>the image is %1, the camera was registered at %2</source>
        <translation>图像为 %1，相机在 %2 下配准</translation>
    </message>
</context>
<context>
    <name>workflow.registered_before_calibration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; was made before its lens was calibrated</source>
        <translation>相机“%1”的地面配准在镜头标定之前进行</translation>
    </message>
</context>
<context>
    <name>workflow.registered_on_other_floor</name>
    <message>
        <source>it is registered on another floor, &apos;%1&apos;, and left out</source>
        <translation>它配准在另一地面“%1”上，未计入</translation>
    </message>
</context>
<context>
    <name>workflow.registered_through_another</name>
    <message>
        <source>it was registered via another camera</source>
        <translation>它是通过另一相机配准的</translation>
    </message>
</context>
<context>
    <name>workflow.registered_with_other_lens</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; uses another lens calibration than the current one</source>
        <translation>相机“%1”的地面配准所用的镜头标定不是当前生效的</translation>
    </message>
</context>
<context>
    <name>workflow.registration</name>
    <message>
        <source>registration %1</source>
        <translation>配准 %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_converted</name>
    <message>
        <source>its frames are %1, so the camera&apos;s registration at %2 was converted</source>
        <translation>其帧为 %1，因此 %2 下的相机配准已换算</translation>
    </message>
</context>
<context>
    <name>workflow.registration_counts_as_exact</name>
    <message>
        <source>its uncertainty is not known, so it counts as exact</source>
        <translation>其不确定度未知，因此视为精确</translation>
    </message>
</context>
<context>
    <name>workflow.registration_in_older_axes</name>
    <message>
        <source>it has other axes: those of its layout were changed since</source>
        <translation>坐标轴不同：其布局的坐标轴此后已更改</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of</name>
    <message>
        <source>registration of %1</source>
        <translation>%1 的配准</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of_camera</name>
    <message>
        <source>registration of camera &apos;%1&apos;</source>
        <translation>相机“%1”的配准</translation>
    </message>
</context>
<context>
    <name>workflow.registration_through</name>
    <message>
        <source>registration of camera &apos;%1&apos; via &apos;%2&apos;</source>
        <translation>通过“%2”对相机“%1”的配准</translation>
    </message>
</context>
<context>
    <name>workflow.registration_with_lens_in_force</name>
    <message>
        <source>registration of camera &apos;%1&apos; with the current lens calibration</source>
        <translation>用生效的镜头对相机“%1”的配准</translation>
    </message>
</context>
<context>
    <name>workflow.remove_cause</name>
    <message>
        <source>remove the cause and reanalyse, or record it again</source>
        <translation>排除原因并重新分析，或重新录制</translation>
    </message>
</context>
<context>
    <name>workflow.remove_for_good</name>
    <message>
        <source>remove %1 for good</source>
        <translation>永久删除 %1</translation>
    </message>
</context>
<context>
    <name>workflow.remove_strays</name>
    <message>
        <source>remove stray files</source>
        <translation>移除无归属的文件</translation>
    </message>
</context>
<context>
    <name>workflow.removing</name>
    <message>
        <source>removing %1</source>
        <translation>正在删除 %1</translation>
    </message>
</context>
<context>
    <name>workflow.rename_trial</name>
    <message>
        <source>rename trial %1 to %2</source>
        <translation>将试验 %1 重命名为 %2</translation>
    </message>
</context>
<context>
    <name>workflow.replaced_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is outside the media folder and has changed since; it is not in the packed project</source>
        <translation>试验“%2”中相机 %1 的视频位于别处，且已不是原来的文件，未包含在打包项目中</translation>
    </message>
</context>
<context>
    <name>workflow.results_changed</name>
    <message>
        <source>its results differ from those of its analysis</source>
        <translation>其结果与分析得出的结果不一致</translation>
    </message>
</context>
<context>
    <name>workflow.robot</name>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
</context>
<context>
    <name>workflow.robot_given_two_tracks</name>
    <message>
        <source>robot &apos;%1&apos; was given two tracks</source>
        <translation>给机器人“%1”指定了两条轨迹</translation>
    </message>
</context>
<context>
    <name>workflow.robot_in_view</name>
    <message>
        <source>robot &apos;%1&apos; in view &apos;%2&apos;</source>
        <translation>视角“%2”中的机器人“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.robot_is_new</name>
    <message>
        <source>robot &apos;%1&apos; is new</source>
        <translation>机器人“%1”是新的</translation>
    </message>
</context>
<context>
    <name>workflow.robot_leaps</name>
    <message>
        <source>after %1 the robot is suddenly %2 away: frames are missing for an unknown time, or another object was tracked; nothing was measured across it</source>
        <translation>%1 之后机器人突然在 %2 之外：缺少未知时长的帧，或跟踪了另一个物体；其间没有测量</translation>
    </message>
</context>
<context>
    <name>workflow.robot_not_tracked</name>
    <message>
        <source>robot &apos;%1&apos; was not tracked in it, only %2</source>
        <translation>其中没有跟踪机器人“%1”，跟踪了 %2</translation>
    </message>
</context>
<context>
    <name>workflow.robot_pointed_out</name>
    <message>
        <source>robot &apos;%1&apos; pointed out in view &apos;%2&apos;</source>
        <translation>在视角“%2”中指出的机器人“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.roster_line</name>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
</context>
<context>
    <name>workflow.run_calibrate</name>
    <message>
        <source>calibrate its lens, or import its intrinsics</source>
        <translation>标定其镜头，或导入其内参</translation>
    </message>
</context>
<context>
    <name>workflow.run_in_older_axes</name>
    <message>
        <source>it has other axes: those of layout &apos;%1&apos; were changed after it was analysed</source>
        <translation>坐标轴不同：分析之后布局“%1”的坐标轴已更改</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_first</name>
    <message>
        <source>run odograph track first</source>
        <translation>请先跟踪</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_without_again</name>
    <message>
        <source>run odograph track without --again first</source>
        <translation>请先跟踪该试验的视频</translation>
    </message>
</context>
<context>
    <name>workflow.runs_in_other_axes</name>
    <message>
        <source>it has other axes (layout &apos;%1&apos;) than trial &apos;%2&apos; (layout &apos;%3&apos;)</source>
        <translation>其坐标轴（布局“%1”）与试验“%2”（布局“%3”）不同</translation>
    </message>
</context>
<context>
    <name>workflow.say_it_again</name>
    <message>
        <source>repeat it for frame %1</source>
        <translation>请对第 %1 帧再指定一次</translation>
    </message>
</context>
<context>
    <name>workflow.scene_far_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered</source>
        <translation>与配准其相机所用的图像相比，场景偏移了 %1</translation>
    </message>
</context>
<context>
    <name>workflow.scene_mirrored</name>
    <message>
        <source>it is mirrored against the image by which its camera was registered</source>
        <translation>与配准其相机所用的图像相比是镜像的</translation>
    </message>
</context>
<context>
    <name>workflow.scene_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered, so the camera was moved, and the stated errors were increased by that</source>
        <translation>与配准其相机所用的图像相比，场景偏移了 %1，说明相机被移动过，所给误差已相应增大</translation>
    </message>
</context>
<context>
    <name>workflow.scene_turned</name>
    <message>
        <source>it is turned by %1 against the image by which its camera was registered</source>
        <translation>与配准其相机所用的图像相比旋转了 %1</translation>
    </message>
</context>
<context>
    <name>workflow.scene_zoomed</name>
    <message>
        <source>it shows the scene %1 times as large as the image by which its camera was registered</source>
        <translation>所示场景的大小是配准其相机所用图像的 %1 倍</translation>
    </message>
</context>
<context>
    <name>workflow.see_flags_by_hand</name>
    <message>
        <source>see the flags by_hand in odograph export</source>
        <translation>“查看”中标出了手动指定的采样</translation>
    </message>
</context>
<context>
    <name>workflow.see_revisions</name>
    <message>
        <source>see the list of its revisions</source>
        <translation>请在其版本列表中查看现有的</translation>
    </message>
</context>
<context>
    <name>workflow.set_range</name>
    <message>
        <source>set the range of %1</source>
        <translation>设置 %1 的区间</translation>
    </message>
</context>
<context>
    <name>workflow.settling_names</name>
    <message>
        <source>assigning names to the robots</source>
        <translation>正在分辨各机器人</translation>
    </message>
</context>
<context>
    <name>workflow.several_files_in_one</name>
    <message>
        <source>it consists of several video files joined byte by byte, so the time between them is unknown</source>
        <translation>它由多个视频文件逐字节拼接而成，因此它们之间的时间未知</translation>
    </message>
</context>
<context>
    <name>workflow.several_image_series</name>
    <message>
        <source>the folder holds several series: %1 and %2</source>
        <translation>文件夹中有多个系列：%1 和 %2</translation>
    </message>
</context>
<context>
    <name>workflow.several_robots</name>
    <message>
        <source>it has several robots</source>
        <translation>有多个机器人</translation>
    </message>
</context>
<context>
    <name>workflow.show_mat</name>
    <message>
        <source>print the mat, lay it where the cameras see all of it, and record again</source>
        <translation>请打印地垫，放在相机能看到整张的地方，然后重新录制</translation>
    </message>
</context>
<context>
    <name>workflow.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and evenly lit, and check --pattern and --board</source>
        <translation>请展示整块标定板，平整、清晰、光线均匀，并检查图案和尺寸</translation>
    </message>
</context>
<context>
    <name>workflow.simulated_robot_not_found</name>
    <message>
        <source>the simulated robot was not found in the simulated views</source>
        <translation>在模拟的视图中未找到模拟的机器人</translation>
    </message>
</context>
<context>
    <name>workflow.simulating_run</name>
    <message>
        <source>simulating run %1 of %2</source>
        <translation>正在模拟第 %1 次运行，共 %2 次</translation>
    </message>
</context>
<context>
    <name>workflow.slow_errors_not_seen</name>
    <message>
        <source>errors that change slowly are not included</source>
        <translation>不包括缓慢变化的误差</translation>
    </message>
</context>
<context>
    <name>workflow.sought_when_tracked</name>
    <message>
        <source>%1; tracking tries again</source>
        <translation>%1；跟踪时会再次尝试</translation>
    </message>
</context>
<context>
    <name>workflow.sound_of_slow_motion</name>
    <message>
        <source>sound cannot be compared in clips that play in slow motion</source>
        <translation>慢动作播放的视频无法比较声音</translation>
    </message>
</context>
<context>
    <name>workflow.sound_unreadable</name>
    <message>
        <source>the sound of view &apos;%1&apos; cannot be read (%2)</source>
        <translation>无法读取视角“%1”的声音（%2）</translation>
    </message>
</context>
<context>
    <name>workflow.spikes_change</name>
    <message>
        <source>Spikes: %1 instead of %2.</source>
        <translation>异常点：%1 个，原为 %2 个。</translation>
    </message>
</context>
<context>
    <name>workflow.stamps_too_dense</name>
    <message>
        <source>its time stamps mean %1, which no camera takes</source>
        <translation>其时间戳意味着 %1，没有相机能做到</translation>
    </message>
</context>
<context>
    <name>workflow.start_otherwise</name>
    <message>
        <source>start it in another manner, such as by motion</source>
        <translation>请以其他方式开始，例如通过移动</translation>
    </message>
</context>
<context>
    <name>workflow.stopped_before_first_frame</name>
    <message>
        <source>it was stopped before the first frame came</source>
        <translation>在第一帧到达之前就已停止</translation>
    </message>
</context>
<context>
    <name>workflow.synchronisation_of_view</name>
    <message>
        <source>synchronisation of view &apos;%1&apos;</source>
        <translation>视角“%1”的同步</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_again</name>
    <message>
        <source>synchronise the views again and reanalyse</source>
        <translation>请重新同步各视角并重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_for_offset</name>
    <message>
        <source>synchronise it again with odograph trial set --sync auto, or enter the time offset</source>
        <translation>请重新同步（试验 ▸ 同步…），或在那里输入时间偏移</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_trial</name>
    <message>
        <source>synchronise %1: %2 (before: %3)</source>
        <translation>同步 %1：%2（之前：%3）</translation>
    </message>
</context>
<context>
    <name>workflow.take_fewer_cameras</name>
    <message>
        <source>close other programs, or use fewer such cameras at once</source>
        <translation>请关闭其他程序，或同时使用更少的这类相机</translation>
    </message>
</context>
<context>
    <name>workflow.take_over_set_up</name>
    <message>
        <source>copy the set-up of %1</source>
        <translation>沿用 %1 的设置</translation>
    </message>
</context>
<context>
    <name>workflow.taking_over_set_up</name>
    <message>
        <source>copying the set-up</source>
        <translation>正在沿用设置</translation>
    </message>
</context>
<context>
    <name>workflow.task_was_changed</name>
    <message>
        <source>its task changed during the analysis</source>
        <translation>测量期间其任务被更改</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_course</name>
    <message>
        <source>task &apos;%1&apos; has neither a path nor gates to drive along</source>
        <translation>任务“%1”既没有路径也没有可通过的门</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_start</name>
    <message>
        <source>task &apos;%1&apos; has no start gate</source>
        <translation>任务“%1”没有起点门</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_zone</name>
    <message>
        <source>task &apos;%1&apos; has no zone &apos;%2&apos;</source>
        <translation>任务“%1”没有区域“%2”</translation>
    </message>
</context>
<context>
    <name>workflow.team_of_another_class</name>
    <message>
        <source>it belongs to class %1, not to class %2</source>
        <translation>它属于班级 %1，而不是班级 %2</translation>
    </message>
</context>
<context>
    <name>workflow.through_itself</name>
    <message>
        <source>a camera cannot be registered via itself</source>
        <translation>相机不能通过自身配准</translation>
    </message>
</context>
<context>
    <name>workflow.time_of_trial</name>
    <message>
        <source>%1 of trial &apos;%2&apos;</source>
        <translation>试验“%2”的 %1</translation>
    </message>
</context>
<context>
    <name>workflow.times_count_from</name>
    <message>
        <source>its times start at %1</source>
        <translation>其时间从 %1 起算</translation>
    </message>
</context>
<context>
    <name>workflow.times_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; was given two tables of frame times</source>
        <translation>给相机“%1”指定了两个帧时间表</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_no_view</name>
    <message>
        <source>there are frame times for camera &apos;%1&apos;, but no video of it</source>
        <translation>有相机“%1”的帧时间，但没有它的视频</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_other_count</name>
    <message>
        <source>it has %1 times, but the video of view &apos;%2&apos; has %3 frames</source>
        <translation>它有 %1 个时间，而视图“%2”的视频有 %3 帧</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_view</name>
    <message>
        <source>time stamps of view &apos;%1&apos;</source>
        <translation>视图“%1”的时间戳</translation>
    </message>
</context>
<context>
    <name>workflow.track</name>
    <message>
        <source>track %1</source>
        <translation>跟踪 %1</translation>
    </message>
</context>
<context>
    <name>workflow.track_it_first</name>
    <message>
        <source>track it first</source>
        <translation>请先跟踪</translation>
    </message>
</context>
<context>
    <name>workflow.track_of_file</name>
    <message>
        <source>the file&apos;s track &apos;%1&apos;</source>
        <translation>文件中的轨迹“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_another</name>
    <message>
        <source>track it, or choose another</source>
        <translation>请跟踪它，或选择另一个</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_with_robot</name>
    <message>
        <source>track it, or choose another with --robot</source>
        <translation>请跟踪它，或选择另一个</translation>
    </message>
</context>
<context>
    <name>workflow.track_those_seen</name>
    <message>
        <source>track only the robots that are in view (--robot)</source>
        <translation>请只跟踪画面中的机器人</translation>
    </message>
</context>
<context>
    <name>workflow.tracking</name>
    <message>
        <source>tracking</source>
        <translation>跟踪</translation>
    </message>
</context>
<context>
    <name>workflow.tracking_picture</name>
    <message>
        <source>tracking, frame %1 of %2</source>
        <translation>正在跟踪，第 %1 幅，共 %2 幅</translation>
    </message>
</context>
<context>
    <name>workflow.tracks_were_imported</name>
    <message>
        <source>its tracks were imported, so it has no video to track</source>
        <translation>其轨迹是导入的，没有可跟踪的视频</translation>
    </message>
</context>
<context>
    <name>workflow.trial_being_recorded</name>
    <message>
        <source>trial &apos;%1&apos; is being recorded</source>
        <translation>正在录制试验“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.trial_is_there</name>
    <message>
        <source>the project already has a trial of that name</source>
        <translation>项目中已有同名试验</translation>
    </message>
</context>
<context>
    <name>workflow.trial_left_out</name>
    <message>
        <source>nothing of it had reached the disk, and it was removed</source>
        <translation>没有内容写入磁盘，已舍去</translation>
    </message>
</context>
<context>
    <name>workflow.turn_cameras_to_floor</name>
    <message>
        <source>turn the cameras to the same floor, and register them again</source>
        <translation>请将相机转向同一地面并重新配准</translation>
    </message>
</context>
<context>
    <name>workflow.turn_or_flash</name>
    <message>
        <source>turn the robot, or flash the room light, in view of both cameras</source>
        <translation>请在两台相机都能看到处让机器人转弯，或闪一下室内灯</translation>
    </message>
</context>
<context>
    <name>workflow.two_mats</name>
    <message>
        <source>the files show mats of different paper</source>
        <translation>文件显示了不同纸张的地垫</translation>
    </message>
</context>
<context>
    <name>workflow.two_views</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>视角“%1”和“%2”</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_files</name>
    <message>
        <source>%1 files of the first camera cannot be paired with %2 of the second one</source>
        <translation>第一台相机的 %1 个文件无法与第二台的 %2 个配对</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_rates</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_frame_rate</name>
    <message>
        <source>its frame rate is not between 0.1 and 100,000 frames a second</source>
        <translation>帧率不在每秒 0.1 到 100,000 帧之间</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_length</name>
    <message>
        <source>the duration must be above zero and at most a day</source>
        <translation>时长为零，或超过一天</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_pre_roll</name>
    <message>
        <source>the pre-roll must be from 0 s to 30 s</source>
        <translation>预录时长必须为 0 s 到 30 s</translation>
    </message>
</context>
<context>
    <name>workflow.use_as_it_is</name>
    <message>
        <source>use the results as they are</source>
        <translation>请直接使用结果</translation>
    </message>
</context>
<context>
    <name>workflow.use_earlier_registration</name>
    <message>
        <source>if it moved before this trial, register it again and reanalyse</source>
        <translation>如果它在本次试验前移动过，请重新配准并重新分析</translation>
    </message>
</context>
<context>
    <name>workflow.use_frame</name>
    <message>
        <source>use frame %1 of %2</source>
        <translation>使用 %2 的第 %1 帧</translation>
    </message>
</context>
<context>
    <name>workflow.use_frames</name>
    <message>
        <source>use %1 samples of %2</source>
        <translation>采用 %2 的 %1 个采样点</translation>
    </message>
</context>
<context>
    <name>workflow.use_original_or_register</name>
    <message>
        <source>use the file as the camera wrote it, or register the camera again in a frame of this video</source>
        <translation>请使用相机写出的原始文件，或用此视频中的一帧重新配准相机</translation>
    </message>
</context>
<context>
    <name>workflow.use_time_before</name>
    <message>
        <source>use the time before that only</source>
        <translation>只使用此前的时间</translation>
    </message>
</context>
<context>
    <name>workflow.verdict_on</name>
    <message>
        <source>verdict on trial &apos;%1&apos;</source>
        <translation>试验“%1”的判定</translation>
    </message>
</context>
<context>
    <name>workflow.video</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>视频“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.video_converted</name>
    <message>
        <source>one frame in %1 repeats the one before, because the video was converted to a higher frame rate; its frames were given the times at which they were taken</source>
        <translation>每 %1 帧中有一帧重复前一帧，因为视频被转换为更高的帧率；其各帧已改用拍摄时的时间</translation>
    </message>
</context>
<context>
    <name>workflow.video_without_picture</name>
    <message>
        <source>the video has no frame</source>
        <translation>视频中没有图像</translation>
    </message>
</context>
<context>
    <name>workflow.view</name>
    <message>
        <source>view &apos;%1&apos;</source>
        <translation>视角“%1”</translation>
    </message>
</context>
<context>
    <name>workflow.view_begun_later</name>
    <message>
        <source>%1 %2 later</source>
        <translation>%1 晚 %2</translation>
    </message>
</context>
<context>
    <name>workflow.view_ended_early</name>
    <message>
        <source>it ended early because %1</source>
        <translation>它提前结束，原因：%1</translation>
    </message>
</context>
<context>
    <name>workflow.view_is_kept</name>
    <message>
        <source>%1 of %2 view were saved, at most the last second is missing</source>
        <translation>保留了 %2 个视角的 %1，最多只缺最后一秒</translation>
    </message>
</context>
<context>
    <name>workflow.view_left_out</name>
    <message>
        <source>it recorded nothing and was left out</source>
        <translation>它被舍去，因为没有录到任何内容</translation>
    </message>
</context>
<context>
    <name>workflow.view_not_synchronised</name>
    <message>
        <source>%1 not synchronised</source>
        <translation>%1 未同步</translation>
    </message>
</context>
<context>
    <name>workflow.view_without_sound</name>
    <message>
        <source>view &apos;%1&apos; has no sound</source>
        <translation>视角“%1”没有声音</translation>
    </message>
</context>
<context>
    <name>workflow.views_are_kept</name>
    <message>
        <source>%1 of %2 views were saved, at most the last second is missing</source>
        <translation>保留了 %2 个视角的 %1，最多只缺最后一秒</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict</name>
    <message>
        <source>in %1 of %2 frames the views contradict each other</source>
        <translation>%2 幅画面中有 %1 幅，各视角相互矛盾</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict_by</name>
    <message>
        <source>the views contradict each other by %1</source>
        <translation>各视角相互矛盾,相差 %1</translation>
    </message>
</context>
<context>
    <name>workflow.views_far_apart</name>
    <message>
        <source>in %1 of %2 frames the views show it at positions far apart</source>
        <translation>%2 幅画面中有 %1 幅，各视角给出的位置相距很远</translation>
    </message>
</context>
<context>
    <name>workflow.views_put_it_apart</name>
    <message>
        <source>their floor positions differ by %1</source>
        <translation>它们给出的位置相差 %1</translation>
    </message>
</context>
<context>
    <name>workflow.waited_for_disk</name>
    <message>
        <source>frames waited up to %1 for the disk, and none was lost</source>
        <translation>图像等待磁盘最长 %1，没有丢失</translation>
    </message>
</context>
<context>
    <name>workflow.waiting_for_start</name>
    <message>
        <source>waiting for the start</source>
        <translation>正在等待开始</translation>
    </message>
</context>
<context>
    <name>workflow.was_not_accepted</name>
    <message>
        <source>nobody accepted it</source>
        <translation>尚无人接受</translation>
    </message>
</context>
<context>
    <name>workflow.why_views_contradict</name>
    <message>
        <source>a camera has moved since its registration, the views are not synchronised, or the robot&apos;s height is wrong</source>
        <translation>某台相机在配准后被移动、各视角不同步，或机器人的高度与所给的不符</translation>
    </message>
</context>
<context>
    <name>workflow.withdraw_acceptance</name>
    <message>
        <source>withdraw the acceptance of %1</source>
        <translation>撤回对 %1 的接受</translation>
    </message>
</context>
<context>
    <name>workflow.write_address</name>
    <message>
        <source>write it like 224.5.23.2:10006</source>
        <translation>请写成 224.5.23.2:10006 的形式</translation>
    </message>
</context>
<context>
    <name>workflow.writing_last_pictures</name>
    <message>
        <source>writing the last frames</source>
        <translation>正在写入最后的图像</translation>
    </message>
</context>
<context>
    <name>workflow.written_just_now</name>
    <message>
        <source>another program is writing or removing it</source>
        <translation>另一程序正在写入或移除它</translation>
    </message>
</context>
</TS>
