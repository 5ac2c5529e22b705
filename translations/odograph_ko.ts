<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>AccuracyLayer</name>
    <message>
        <source>expected ±, hatched: not visible</source>
        <translation>예상 ±, 빗금: 보이지 않음</translation>
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
        <translation>%1 먼저 시작</translation>
    </message>
    <message>
        <source>started %1 later</source>
        <translation>%1 늦게 시작</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data</source>
        <translation>칼만/RTS, 잡음은 데이터에서 추정</translation>
    </message>
    <message>
        <source>Savitzky–Golay, cubic, 11 points</source>
        <translation>Savitzky–Golay, 3차, 11점</translation>
    </message>
    <message>
        <source>differences as in Tracker</source>
        <translation>Tracker와 같은 차분</translation>
    </message>
    <message>
        <source>none: raw differences</source>
        <translation>없음: 원시 차분</translation>
    </message>
    <message>
        <source>%1, set by hand</source>
        <translation>%1, 직접 지정</translation>
    </message>
    <message>
        <source>synchronised to %1 by the motion; %2</source>
        <translation>동기 오차 %1, 움직임으로 구함; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by a flash of light; %2</source>
        <translation>동기 오차 %1, 빛의 번쩍임으로 구함; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by the cameras&apos; time stamps; %2</source>
        <translation>동기 오차 %1, 카메라 타임스탬프로 구함; %2</translation>
    </message>
    <message>
        <source>assumed to start at the same time</source>
        <translation>동시에 시작한 것으로 봄</translation>
    </message>
    <message>
        <source>, clock %1 ppm fast</source>
        <translation>, 시계가 %1 ppm 빠름</translation>
    </message>
    <message>
        <source>, clock %1 ppm slow</source>
        <translation>, 시계가 %1 ppm 느림</translation>
    </message>
    <message>
        <source>%1 to %2 ms apart</source>
        <translation>간격 %1–%2 ms</translation>
    </message>
    <message>
        <source>synchronised to %1 by sound; %2</source>
        <translation>동기 오차 %1, 소리로 구함; %2</translation>
    </message>
</context>
<context>
    <name>AnnotatedFrame</name>
    <message>
        <source>slow motion %1×</source>
        <translation>슬로 모션 %1×</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>이 카메라는 이때 녹화하고 있지 않았습니다</translation>
    </message>
    <message>
        <source>This frame cannot be decoded</source>
        <translation>이 영상을 디코딩할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>Certificate</name>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>속도 벡터</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>가속도 벡터</translation>
    </message>
    <message>
        <source>Amount of acceleration</source>
        <translation>가속도 크기</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>카메라: %1</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>로봇: %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>과제: %1</translation>
    </message>
    <message>
        <source>along the course of the task</source>
        <translation>과제의 코스를 따라</translation>
    </message>
    <message>
        <source>over the floor that the cameras see: straight, a curve, stop and go</source>
        <translation>카메라가 보는 바닥 위에서: 직선, 곡선, 정지와 출발</translation>
    </message>
    <message>
        <source>The views of each camera were rendered with its lens, position, image size and frame rate, written as videos, and imported, synchronised, tracked and analysed as any others.</source>
        <translation>각 카메라의 렌즈, 위치, 영상 크기, 프레임 속도로 화면을 렌더링해 동영상으로 저장한 뒤, 다른 동영상과 똑같이 가져오고 동기화하고 추적하고 분석했습니다.</translation>
    </message>
    <message>
        <source>A simulation shows what this geometry and this program can do, not what a certain recording did. It has even light, a still camera, a clean floor with the markers, sensor noise of 2 of 255 and an exposure of 8 ms at most, and a robot of simple solids in its colour and size.</source>
        <translation>시뮬레이션은 이 배치와 이 프로그램이 할 수 있는 것을 보여 줄 뿐, 특정 녹화의 결과를 보여 주지는 않습니다. 고른 조명, 움직이지 않는 카메라, 마커가 있는 깨끗한 바닥, 255 중 2의 센서 잡음, 최대 8 ms의 노출, 그리고 제 색과 크기를 지닌 단순한 입체로 된 로봇을 가정합니다.</translation>
    </message>
    <message>
        <source>It does not cover flicker, reflections, deep shadows and people in the view; the look of the real robot, cables and hands; a camera that was moved; markers that were measured wrongly; rolling shutters; and errors of lens calibration and registration beyond the stated ones.</source>
        <translation>깜박임, 반사, 짙은 그림자, 화면 속 사람, 실제 로봇의 모습과 케이블과 손, 움직인 카메라, 잘못 잰 마커, 롤링 셔터, 그리고 명시된 것을 넘는 렌즈 보정과 정합의 오차는 다루지 않습니다.</translation>
    </message>
    <message>
        <source>The verdict on a trial says which of these were noticed in its recording.</source>
        <translation>시행의 판정은 이 중 어떤 것이 녹화에서 발견되었는지 알려 줍니다.</translation>
    </message>
    <message>
        <source>The known run from above</source>
        <translation>위에서 본 알려진 주행</translation>
    </message>
    <message>
        <source>dashed: truth; strokes: errors of all runs, enlarged %1 times</source>
        <translation>파선: 참값; 짧은 선: 모든 주행의 오차, %1배 확대</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>제곱평균제곱근</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95 %가 이하</translation>
    </message>
    <message>
        <source>stated ± (σ)</source>
        <translation>명시된 ± (σ)</translation>
    </message>
    <message>
        <source>truth inside the stated 95 %</source>
        <translation>명시된 95 % 안의 참값</translation>
    </message>
    <message>
        <source>Errors against the truth</source>
        <translation>참값에 대한 오차</translation>
    </message>
    <message>
        <source>%1 of %2 frames have a result</source>
        <translation>프레임 %2개 중 %1개에 결과가 있음</translation>
    </message>
    <message>
        <source>Certificate of this set-up</source>
        <translation>이 설정의 인증서</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>위치 오차</translation>
    </message>
    <message>
        <source>Velocity error</source>
        <translation>속도 오차</translation>
    </message>
    <message>
        <source>Acceleration error</source>
        <translation>가속도 오차</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>포함률</translation>
    </message>
    <message>
        <source>true positions inside the stated 95 %</source>
        <translation>명시된 95 % 안의 참 위치</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>시뮬레이션한 것</translation>
    </message>
    <message>
        <source>What a simulation does not cover</source>
        <translation>시뮬레이션이 다루지 않는 것</translation>
    </message>
    <message>
        <source>%1, error in %2</source>
        <translation>%1, 오차(%2)</translation>
    </message>
    <message>
        <source>a line for each run; dashed: what the first states for 95 %</source>
        <translation>주행마다 선 하나; 파선: 첫 주행이 명시한 95 %</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>정합</translation>
    </message>
    <message>
        <source>σ on the floor</source>
        <translation>바닥에서의 σ</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>보정됨</translation>
    </message>
    <message>
        <source>estimated from the floor</source>
        <translation>바닥에서 추정</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>가정</translation>
    </message>
    <message>
        <source>The views were synchronised by the motion, to %1 ms at worst.</source>
        <translation>뷰는 움직임으로 동기화했으며 최악의 경우 %1 ms입니다.</translation>
    </message>
    <message>
        <source>Certificate of this set-up: errors over time</source>
        <translation>이 설정의 인증서: 시간에 따른 오차</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>참고 사항</translation>
    </message>
    <message>
        <source>The cameras</source>
        <translation>카메라</translation>
    </message>
    <message numerus="yes">
        <source>%n simulated run(s) of %1 s and %2 at up to %3, %4.</source>
        <translation>
            <numerusform>%1 s, %2, 최고 %3인 시뮬레이션 주행 %n회, %4.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>렌즈 정보</translation>
    </message>
    <message>
        <source>Simulated %1, Odograph %2. All errors are against the known truth of the simulation.</source>
        <translation>%1 시뮬레이션, Odograph %2. 모든 오차는 시뮬레이션의 알려진 참값에 대한 것입니다.</translation>
    </message>
    <message>
        <source>In each run the cameras are a little off from where the project has them, drawn from the stated uncertainty of their registration and lens calibration; so the errors include it.</source>
        <translation>각 주행에서 카메라는 정합과 렌즈 보정의 명시된 불확도에서 뽑은 만큼 프로젝트의 위치에서 조금 벗어나 있습니다. 따라서 오차에는 그 불확도가 포함됩니다.</translation>
    </message>
</context>
<context>
    <name>ClassReport</name>
    <message>
        <source>Rank: one more than the number of significantly better teams (medians differ by more than 1.96 σ). Teams of the same rank do not differ significantly.</source>
        <translation>순위: 확실히 더 나은 팀(중앙값 차이가 1.96 σ 초과)의 수에 1을 더한 값입니다. 순위가 같은 팀끼리는 우열을 가릴 수 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them.</source>
        <translation>
            <numerusform>시행 %n개 제외: 다른 코스로 측정됨. 다시 측정하십시오.</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2 · Odograph %3</source>
        <translation>%1/%2쪽 · Odograph %3</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>과제: %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>지표: %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 ~ %2</translation>
    </message>
    <message>
        <source>Teams</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>전체 %1개 중</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>최고</translation>
    </message>
    <message>
        <source>Median of all runs</source>
        <translation>모든 주행의 중앙값</translation>
    </message>
    <message>
        <source>Middle half of the runs</source>
        <translation>주행의 가운데 절반</translation>
    </message>
    <message>
        <source>The teams</source>
        <translation>팀별 결과</translation>
    </message>
    <message>
        <source>each run is a dot; the line is the median of the team</source>
        <translation>점 하나가 주행 하나, 선은 팀의 중앙값</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>중앙값</translation>
    </message>
    <message>
        <source>Over the term</source>
        <translation>학기 중 변화</translation>
    </message>
    <message>
        <source>Its trials</source>
        <translation>팀의 시행</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>학급: %1</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>순위</translation>
    </message>
    <message numerus="yes">
        <source>of %n team(s)</source>
        <translation>
            <numerusform>전체 %n팀 중</numerusform>
        </translation>
    </message>
    <message>
        <source>class median %1</source>
        <translation>학급 중앙값 %1</translation>
    </message>
    <message>
        <source>Spread of one run</source>
        <translation>주행 하나의 산포</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>시행 %n개 제외: 나쁜 결과.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! 결과가 의심스러운 시행 %n개 포함.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonExplanation</name>
    <message>
        <source>No difference.</source>
        <translation>차이가 없습니다.</translation>
    </message>
    <message>
        <source>Both values are exact: any difference is real.</source>
        <translation>둘 다 정확한 값이므로 어떤 차이도 실제 차이입니다.</translation>
    </message>
    <message>
        <source>%1 σ, above 1.96: without a real difference, chance would give this much in fewer than 5 of 100 cases.</source>
        <translation>%1 σ로 1.96보다 큽니다. 실제로 차이가 없다면 우연히 이만큼 벌어지는 경우는 100번 중 5번 미만입니다.</translation>
    </message>
    <message>
        <source>%1 σ, not above 1.96: the difference is not significant.</source>
        <translation>%1 σ로 1.96을 넘지 않습니다. 오차 이내이므로 차이가 있다고 할 수 없습니다.</translation>
    </message>
    <message>
        <source>along the task&apos;s reference path</source>
        <translation>과제의 기준 경로를 따라</translation>
    </message>
    <message>
        <source>along the path of %1</source>
        <translation>%1의 경로를 따라</translation>
    </message>
    <message>
        <source>time 0: each passes the start gate</source>
        <translation>시각 0: 각 주행이 출발 게이트를 지나는 때</translation>
    </message>
    <message>
        <source>time 0: each begins to move</source>
        <translation>시각 0: 각 주행이 움직이기 시작하는 때</translation>
    </message>
    <message>
        <source>time 0: each first reaches the same point of the path</source>
        <translation>시각 0: 각 주행이 경로의 같은 위치에 처음 이르는 때</translation>
    </message>
    <message>
        <source>time 0: set by hand, to one frame</source>
        <translation>시각 0: 프레임 단위로 직접 지정</translation>
    </message>
    <message>
        <source>both with the same registrations and robot shape: the calibration uncertainty is common, so only its difference counts</source>
        <translation>둘 다 같은 정합과 같은 입체로 측정됨: 보정에서 오는 오차는 공통이므로 그 차이만 셈에 넣음</translation>
    </message>
    <message>
        <source>different registrations or robot shapes: the calibration uncertainty counts in full for both</source>
        <translation>정합이나 입체가 서로 다름: 보정에서 오는 오차를 양쪽 모두 온전히 셈에 넣음</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>%1: %2 minus %3</source>
        <translation>%1: %2 − %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>only one of the two runs has it</source>
        <translation>둘 중 하나에만 있음</translation>
    </message>
    <message>
        <source>the value of %1 minus that of %2</source>
        <translation>%1의 지표에서 %2의 지표를 뺀 값</translation>
    </message>
    <message>
        <source>Each: %1</source>
        <translation>각각: %1</translation>
    </message>
    <message>
        <source>√(σ₁² + σ₂²), treated as independent; where the runs share their calibration, its scale uncertainty counts only for the difference</source>
        <translation>√(σ₁² + σ₂²), 둘을 서로 독립으로 봄; 두 주행이 보정을 공유하면 그 축척 오차는 차이에 해당하는 몫만 남음</translation>
    </message>
    <message>
        <source>not visible at one end</source>
        <translation>한쪽 끝이 보이지 않음</translation>
    </message>
    <message>
        <source>Sector %1 to %2: %3 minus %4</source>
        <translation>구간 %1 ~ %2: %3 − %4</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>end</source>
        <translation>끝</translation>
    </message>
    <message>
        <source>For each run, the time from its first arrival at one gate to its first arrival at the next, by its position along the common path; waiting counts.</source>
        <translation>각 주행이 한 게이트에 처음 이른 때부터 다음 게이트에 처음 이른 때까지의 시간으로, 공통 경로상의 위치로 구합니다. 기다린 시간도 들어갑니다.</translation>
    </message>
    <message>
        <source>of each arrival: σ of the position along the path divided by the speed; displacements at two gates count as independent</source>
        <translation>각 도달 시각의 오차: 경로 방향 위치의 σ를 속력으로 나눈 값; 두 게이트에서의 위치 오차는 서로 독립으로 봄</translation>
    </message>
    <message>
        <source>from %1 to %2 along the path</source>
        <translation>경로의 %1에서 %2까지</translation>
    </message>
    <message>
        <source>Δt of %1 against %2 at %3</source>
        <translation>%3에서 %2에 대한 %1의 Δt</translation>
    </message>
    <message>
        <source>The time of the first arrival at this point of the common path, each from its own time 0: that of %1 minus that of %2. Positive means later.</source>
        <translation>공통 경로의 이 위치에 처음 이른 시각을 각자의 시각 0부터 재어, %1의 값에서 %2의 값을 뺀 것입니다. 0보다 크면 더 늦은 것입니다.</translation>
    </message>
    <message>
        <source>of both arrivals: σ of the position along the path divided by the speed, and of both times 0</source>
        <translation>두 도달 시각의 오차(경로 방향 위치의 σ를 속력으로 나눈 값)와 두 시각 0의 오차</translation>
    </message>
    <message>
        <source>Speed of %1 at %2</source>
        <translation>%2에서 %1의 속력</translation>
    </message>
    <message>
        <source>|v| of the smoothed curve where the run first reaches this point of the common path, interpolated between frames</source>
        <translation>주행이 공통 경로의 이 위치에 처음 이른 때 평활화된 곡선의 |v|, 프레임 사이는 보간</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>그 지점에서 평활화된 속도의 σ, 보정의 축척 오차 포함</translation>
    </message>
    <message>
        <source>none: a run was not measured all the time, and is at least so large</source>
        <translation>없음: 한 주행이 계속 측정되지 않았으며 적어도 이만큼입니다</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>± one σ; grey, ≈: not significant</source>
        <translation>± 1 σ; 회색, ≈: 오차 이내</translation>
    </message>
    <message>
        <source>left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>right</source>
        <translation>오른쪽</translation>
    </message>
    <message>
        <source>right − left</source>
        <translation>오른쪽 − 왼쪽</translation>
    </message>
    <message>
        <source>along the task’s path</source>
        <translation>과제의 경로를 따라</translation>
    </message>
    <message>
        <source>along the path of the left run</source>
        <translation>왼쪽 주행의 경로를 따라</translation>
    </message>
    <message>
        <source>aligned by the start gate, %1</source>
        <translation>출발 게이트로 정렬, %1</translation>
    </message>
    <message>
        <source>aligned by the onset of motion, %1</source>
        <translation>움직임 시작으로 정렬, %1</translation>
    </message>
    <message>
        <source>aligned by a point that both pass, %1</source>
        <translation>둘 다 지나는 위치로 정렬, %1</translation>
    </message>
    <message>
        <source>aligned by hand, %1</source>
        <translation>직접 정렬, %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>과제: %1</translation>
    </message>
    <message>
        <source>%1: analysed %2, Odograph %3</source>
        <translation>%1: %2 분석, Odograph %3</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels.</source>
        <translation>두 주행이 보정을 공유합니다. 공유하는 만큼 보정 오차가 상쇄됩니다.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count.</source>
        <translation>두 주행이 보정을 공유하지 않습니다. 양쪽의 오차를 모두 셈에 넣습니다.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>경로상의 속력, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>±95 % 띠와 함께</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>시간차, s</translation>
    </message>
    <message>
        <source>above 0: the right run is later; grey: not significant</source>
        <translation>0보다 크면 오른쪽 주행이 늦음; 회색: 오차 이내</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>구간, s</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Verdict on %1: %2</source>
        <translation>%1 판정: %2</translation>
    </message>
</context>
<context>
    <name>Conflict</name>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>태그</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>별표</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>보관됨</translation>
    </message>
    <message>
        <source>In the bin</source>
        <translation>휴지통에 있음</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>팀원</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>가명</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>게이트</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>구역</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>채점</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(숨김)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>no</source>
        <translation>아니요</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>측정값</translation>
    </message>
    <message>
        <source>this version</source>
        <translation>이 버전</translation>
    </message>
    <message>
        <source>another version</source>
        <translation>다른 버전</translation>
    </message>
</context>
<context>
    <name>Explanation</name>
    <message>
        <source>smoothed by Kalman filter and RTS smoother, noise by maximum likelihood (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</source>
        <translation>칼만 필터와 RTS 평활기로 평활화, 잡음은 최대 가능도로 추정(Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</translation>
    </message>
    <message>
        <source>smoothed by a cubic through eleven points (Savitzky and Golay 1964)</source>
        <translation>11점에 맞춘 3차식으로 평활화(Savitzky and Golay 1964)</translation>
    </message>
    <message>
        <source>differences as in Tracker, positions not smoothed</source>
        <translation>Tracker와 같은 차분, 위치는 평활화하지 않음</translation>
    </message>
    <message>
        <source>raw differences (Park 2018, eq. 6 to 8), nothing smoothed</source>
        <translation>원시 차분(Park 2018, 식 6~8), 평활화 없음</translation>
    </message>
    <message>
        <source>robot %1 high (estimated)</source>
        <translation>로봇 높이 %1(추정)</translation>
    </message>
    <message>
        <source>robot %1 high</source>
        <translation>로봇 높이 %1</translation>
    </message>
    <message>
        <source>analysis %1 by Odograph %2</source>
        <translation>분석 %1, Odograph %2</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>그 지점에서 평활화된 속도의 σ, 보정의 축척 오차 포함</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>|v| = √(vx² + vy²) of the smoothed curve at this frame</source>
        <translation>이 프레임에서 평활화된 곡선의 |v| = √(vx² + vy²)</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>가속도</translation>
    </message>
    <message>
        <source>a·v/|v| of the smoothed curve at this frame: along the path, negative when braking; |a| while the robot stands still</source>
        <translation>이 프레임에서 평활화된 곡선의 a·v/|v|: 경로 방향이므로 감속하면 음수; 멈춰 있을 때는 |a|</translation>
    </message>
    <message>
        <source>σ of the smoothed acceleration there, including the calibration&apos;s scale uncertainty</source>
        <translation>그 지점에서 평활화된 가속도의 σ, 보정의 축척 오차 포함</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>진행 방향</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>선회율</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>위치 X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>위치 Y</translation>
    </message>
    <message>
        <source>the smoothed curve at this frame</source>
        <translation>이 프레임에서 평활화된 곡선</translation>
    </message>
    <message>
        <source>σ of the smoothed position, including the calibration&apos;s part</source>
        <translation>평활화된 위치의 σ, 보정에서 오는 몫 포함</translation>
    </message>
    <message>
        <source>no view found the robot in this frame: the curve bridges the gap</source>
        <translation>이 프레임에서는 어느 뷰에서도 로봇을 찾지 못하여 곡선이 건너질러 이어짐</translation>
    </message>
    <message>
        <source>measured there: %1, %2 ±%3</source>
        <translation>그 지점의 측정값: %1, %2 ±%3</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>뷰: %1</translation>
    </message>
    <message>
        <source>it is flagged and not used: the curve follows its neighbours</source>
        <translation>표시된 샘플이므로 쓰지 않음: 곡선은 이웃 샘플에서 구함</translation>
    </message>
    <message>
        <source>Jump: the position does not fit the motion before and after (χ² with two degrees of freedom, 99.9 %).</source>
        <translation>건너뜀: 앞뒤의 움직임으로 가능한 범위를 벗어난 위치입니다(자유도 2의 χ², 99.9 %).</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the speed limit of the task or of the analysis.</source>
        <translation>한계: 그 위치에 가려면 과제나 분석의 한계보다 빨라야 했습니다.</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the acceleration limit of the task or of the analysis.</source>
        <translation>한계: 그 위치에 가려면 과제나 분석의 한계보다 크게 가속해야 했습니다.</translation>
    </message>
    <message>
        <source>Views disagree: their floor positions differ by more than their uncertainty and their usual disagreement explain (χ², 99.9 %).</source>
        <translation>뷰 간 불일치: 뷰마다 구한 위치의 차이가 오차와 평소의 불일치로 설명되는 것보다 큽니다(χ², 99.9 %).</translation>
    </message>
    <message>
        <source>Low score: the tracker was not sure of what it saw.</source>
        <translation>낮은 신뢰도: 추적기가 본 것을 확신하지 못했습니다.</translation>
    </message>
    <message>
        <source>Lost: no view found the robot.</source>
        <translation>놓침: 어느 뷰에서도 로봇을 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>Repeated frame: the camera delivered the same frame twice, so its time is unknown.</source>
        <translation>반복된 영상: 카메라가 같은 영상을 두 번 보내 그 시각을 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Bridged: the curve crosses a gap without measurements.</source>
        <translation>이어 붙임: 측정값 없이 곡선이 건너질러 이어집니다.</translation>
    </message>
    <message>
        <source>By hand: a manual override replaces the result of the analysis.</source>
        <translation>직접 판정: 사람이 분석 결과를 바꾸어 판정했습니다.</translation>
    </message>
    <message>
        <source>How it is computed</source>
        <translation>계산 방법</translation>
    </message>
    <message>
        <source>What ± contains (one standard deviation)</source>
        <translation>±에 포함된 것(1 표준 편차)</translation>
    </message>
    <message>
        <source>What went into it</source>
        <translation>계산에 쓴 것</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>trial %1, robot %2</source>
        <translation>시행 %1, 로봇 %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples used</source>
        <translation>샘플 %2개 중 %1개 사용</translation>
    </message>
    <message>
        <source>views: %1</source>
        <translation>뷰: %1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, at most %4 beyond the edge</source>
        <translation>%1: %2부터 %3까지, 경계를 최대 %4 넘음</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1(%2)</translation>
    </message>
    <message>
        <source>Spike at %1</source>
        <translation>%1의 이상점</translation>
    </message>
    <message>
        <source>The sample is kept, but not used for the curve.</source>
        <translation>샘플을 보존하지만 곡선에는 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>The curve uses the sample nevertheless: its faulty part was left out, or a manual override restored it.</source>
        <translation>그래도 샘플을 곡선에 씁니다. 잘못된 부분을 빼고 쓰거나, 사람이 복원한 것입니다.</translation>
    </message>
    <message>
        <source>the views&apos; floor positions differ by %1 there</source>
        <translation>그 지점에서 뷰 사이의 차이가 %1</translation>
    </message>
    <message>
        <source>Of the body where its outline or an imported track shows it: the smoothed heading. Elsewhere the direction of motion: atan2(vy, vx) of the smoothed curve, kept where the robot stands still and continued where it reverses. Anticlockwise from X, without jumps of a whole turn.</source>
        <translation>윤곽이나 가져온 궤적이 보여 주는 곳에서는 몸체의 방향(평활화된 방향)입니다. 그 밖에는 움직임의 방향, 즉 평활화된 곡선의 atan2(vy, vx)이며, 로봇이 멈춘 동안에는 유지되고 후진할 때는 이어집니다. X축에서 반시계 방향, 한 바퀴만큼의 건너뜀 없이 이음.</translation>
    </message>
    <message>
        <source>of the body: σ of its smoothed heading; of the direction of motion: σ of the velocity across the motion divided by the speed</source>
        <translation>몸체: 평활화된 방향의 σ; 움직임 방향: 움직임에 수직인 방향 속도의 σ를 속력으로 나눈 값</translation>
    </message>
    <message>
        <source>Of the body where its heading was measured: the rate of the smoothed heading. Elsewhere (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>몸체의 방향을 측정한 곳에서는 평활화된 방향의 변화율입니다. 그 밖에는 평활화된 곡선의 (vx·ay − vy·ax)/|v|²입니다.</translation>
    </message>
    <message>
        <source>of the body: σ of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>몸체: 평활화된 방향 변화율의 σ; 움직임 방향: σ² = σa²/|v|² + |a|²σv²/|v|⁴, 1차 근사</translation>
    </message>
    <message>
        <source>of the robot&apos;s body, which was measured</source>
        <translation>측정된 로봇 몸체의 값</translation>
    </message>
    <message>
        <source>of the direction of motion</source>
        <translation>움직임 방향의 값</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>속도 X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>속도 Y</translation>
    </message>
    <message>
        <source>the velocity of the smoothed curve at this frame along that axis</source>
        <translation>이 프레임에서 평활화된 곡선의 그 축 방향 속도</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>횡가속도</translation>
    </message>
    <message>
        <source>(vx·ay − vy·ax)/|v| of the smoothed curve at this frame: across the path, positive to the left</source>
        <translation>이 프레임에서 평활화된 곡선의 (vx·ay − vy·ax)/|v|: 경로에 수직, 왼쪽이 양</translation>
    </message>
    <message>
        <source>σ² = σa² + (a·v/|v|)²σv²/|v|², first order: of the acceleration, and of the direction of motion</source>
        <translation>σ² = σa² + (a·v/|v|)²σv²/|v|², 1차: 가속도와 운동 방향에서</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>저크</translation>
    </message>
    <message>
        <source>(a(t₂) − a(t₁))/(t₂ − t₁) along the path, from the smoothed accelerations half of %1 before and after this frame; its length while the robot stands still</source>
        <translation>경로 방향 (a(t₂) − a(t₁))/(t₂ − t₁): 이 프레임 앞뒤로 %1의 절반 떨어진 평활화된 가속도에서; 로봇이 서 있는 동안은 그 크기</translation>
    </message>
    <message>
        <source>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ the correlation of both errors</source>
        <translation>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ는 두 오차의 상관</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>이동 거리</translation>
    </message>
    <message>
        <source>the integral of the smoothed speed over the time in which the robot moves, up to this frame</source>
        <translation>이 프레임까지 로봇이 움직이는 시간 동안 평활화된 속력의 적분</translation>
    </message>
    <message>
        <source>of the positions at the ends of each motion, of errors across the path where it turns, and of the calibration&apos;s scale; without what the robot may have done while it was not measured</source>
        <translation>각 운동의 양 끝 위치, 경로가 굽은 곳의 수직 오차, 보정의 축척에서; 측정되지 않은 동안 로봇이 한 일은 제외</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>시작점까지의 거리</translation>
    </message>
    <message>
        <source>the straight line from the first smoothed position to this frame&apos;s</source>
        <translation>첫 평활화된 위치에서 이 프레임의 위치까지의 직선</translation>
    </message>
    <message>
        <source>of both positions along that line, and of the calibration&apos;s scale</source>
        <translation>그 직선을 따른 두 위치와 보정의 축척에서</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>가장 가까운 로봇까지의 거리</translation>
    </message>
    <message>
        <source>between the reference points of both robots at this frame&apos;s time, on the smoothed curves</source>
        <translation>이 프레임 시각에 두 로봇의 기준점 사이, 평활화된 곡선에서</translation>
    </message>
</context>
<context>
    <name>ExplanationDialog</name>
    <message>
        <source>How was this computed?</source>
        <translation>어떻게 계산했습니까?</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>복사(&amp;C)</translation>
    </message>
</context>
<context>
    <name>FactExplanations</name>
    <message>
        <source>The time offset at which the robot&apos;s floor tracks from the two views coincide: least squares of r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant shift and a small scale between them, searched in steps of half a frame and refined by Gauss–Newton. The clock rate is used if it exceeds three σ.</source>
        <translation>두 뷰에서 본 로봇의 바닥 궤적이 일치하는 오프셋입니다. r(t) = p₁(t) − p₂((t − 오프셋)(1 + 시계 비율))의 최소 제곱으로 구하며, 둘 사이에 일정한 이동과 작은 축척을 허용하고, 반 프레임 간격으로 찾은 뒤 가우스–뉴턴법으로 정밀화합니다. 시계 비율은 3 σ를 넘을 때만 반영합니다.</translation>
    </message>
    <message>
        <source>from the curvature of the sum of squares and from the residual, assumed to be correlated over half a second</source>
        <translation>제곱합의 곡률과 잔차에서 구하며, 잔차는 0.5초 동안 상관이 있다고 봄</translation>
    </message>
    <message>
        <source>The time offset at which the jumps in brightness in both views coincide: the weighted mean of the pairs. It is used if every other offset is at least 150 times less likely.</source>
        <translation>두 뷰가 모두 본 밝기의 급변이 서로 겹치는 오프셋입니다. 다른 어떤 오프셋의 가능도도 이것의 150분의 1을 넘지 못할 때만 채택하며, 쌍들의 가중 평균입니다.</translation>
    </message>
    <message>
        <source>from the pairs and their scatter, plus a tenth of a frame interval per view for its shutter</source>
        <translation>쌍들의 오차와 흩어짐, 그리고 셔터를 고려하여 뷰마다 프레임 간격의 10분의 1</translation>
    </message>
    <message>
        <source>Each camera&apos;s time stamps, converted to this computer&apos;s clock by reading the camera&apos;s clock during the recording.</source>
        <translation>각 카메라의 타임스탬프이며, 녹화하는 동안 카메라 시계를 읽어 이 컴퓨터의 시계와 맞춘 것입니다.</translation>
    </message>
    <message>
        <source>from both clock conversions</source>
        <translation>두 시계 관계의 오차</translation>
    </message>
    <message>
        <source>Times at the gates</source>
        <translation>게이트 통과 시각</translation>
    </message>
    <message>
        <source>When the robot&apos;s reference point crosses the gate&apos;s line between its ends, in the direction of the gate. Between two frames, the smoothed position is the cubic through both positions and velocities. A passage counts if the point was before the line by three σ of the track&apos;s own noise and then is past it by as much.</source>
        <translation>로봇의 중심이 게이트 양 끝 사이의 선을 통과 방향으로 지나는 때입니다. 두 프레임 사이에서 평활화된 위치는 양쪽의 위치와 속도를 잇는 3차식입니다. 궤적 자체 잡음의 3 σ만큼 선 앞에 있다가 그만큼 선을 넘으면 통과한 것으로 봅니다.</translation>
    </message>
    <message>
        <source>σ of the position across the gate divided by the speed across it, including the calibration&apos;s part</source>
        <translation>게이트에 수직인 방향 위치의 σ를 그 방향의 속력으로 나눈 값, 보정에서 오는 몫 포함</translation>
    </message>
    <message>
        <source>From a passage of the start to one of the finish, or from one passage of a start-finish gate to the next. Of each split, the first passage counts.</source>
        <translation>출발 통과에서 도착 통과까지, 게이트가 하나이면 그 게이트의 다음 통과까지입니다. 중간 게이트는 각각 처음 통과한 것만 셉니다.</translation>
    </message>
    <message>
        <source>from both passages; the calibration&apos;s uncertainty cancels for a gate passed twice at the same speed</source>
        <translation>두 통과 시각의 오차; 같은 게이트를 같은 속력으로 두 번 지나면 보정 오차는 상쇄됨</translation>
    </message>
    <message>
        <source>to %1: %2</source>
        <translation>%1까지: %2</translation>
    </message>
    <message>
        <source>Synchronisation of view %1 with the first</source>
        <translation>뷰 %1과 첫째 뷰의 동기</translation>
    </message>
    <message>
        <source>video %1, %2 frames</source>
        <translation>동영상 %1, %2프레임</translation>
    </message>
    <message>
        <source>Height of robot %1</source>
        <translation>로봇 %1의 높이</translation>
    </message>
    <message>
        <source>The solid (box or cylinder, on the floor or a plate at the robot&apos;s top) whose silhouettes best match the outlines in all views, by weighted least squares at about forty times of the run. If no such solid explains them: the height at which all views give the same floor position.</source>
        <translation>모든 뷰의 윤곽을 실루엣으로 갖는 입체(바닥 위, 또는 로봇 윗면의 판인 상자나 원기둥)이며, 주행 중 약 40개 시각에서 가중 최소 제곱으로 구합니다. 그런 입체로 설명되지 않으면 모든 뷰가 로봇을 같은 위치에 놓는 높이입니다.</translation>
    </message>
    <message>
        <source>The time offset at which claps, knocks or whistles in the sound of both views coincide: the weighted mean of the pairs, less the time that sound takes to reach each camera. It is used if every other offset is at least 150 times less likely.</source>
        <translation>두 뷰의 소리에 있는 박수, 두드림, 휘파람이 서로 겹치는 오프셋입니다. 쌍들의 가중 평균에서 소리가 각 카메라에 닿는 시간을 뺀 값입니다. 다른 모든 오프셋의 가능도가 150분의 1 이하일 때만 채택합니다.</translation>
    </message>
    <message>
        <source>from the pairs, from where on the floor the sound may have come, 50 ppm of the time from the start of the recording to the sound, and 2 ms by which each camera may record its sound early or late</source>
        <translation>쌍들의 오차, 소리가 났을 바닥 위치, 녹화 시작부터 소리까지 시간의 50 ppm, 그리고 카메라마다 소리가 이르거나 늦을 수 있는 2 ms</translation>
    </message>
</context>
<context>
    <name>FirstLesson</name>
    <message>
        <source>Play a run</source>
        <translation>주행 재생하기</translation>
    </message>
    <message>
        <source>Two cameras filmed a robot. Press Space: both videos, the map and the curves play together. Press Space again to stop.</source>
        <translation>카메라 두 대로 로봇의 주행을 촬영했습니다. Space를 누르십시오. 두 동영상과 지도와 곡선이 함께 재생됩니다. Space를 다시 누르면 멈춥니다.</translation>
    </message>
    <message>
        <source>Read a result</source>
        <translation>지표 읽기</translation>
    </message>
    <message>
        <source>Click the speed curve. The bubble shows the speed at that moment and its uncertainty (±). The band around the curve contains the true speed in 95 of 100 cases.</source>
        <translation>속력 곡선을 클릭하십시오. 말풍선에 그 순간의 속력과 ±, 곧 얼마나 틀릴 수 있는지가 나옵니다. 곡선 둘레의 띠는 100번 중 95번 참값이 들어 있는 곳입니다.</translation>
    </message>
    <message>
        <source>Check the flagged samples</source>
        <translation>표시된 것 살펴보기</translation>
    </message>
    <message>
        <source>Press Ctrl+Page Up or Ctrl+Page Down until the list of spikes on the right is not empty. A spike is a measurement that cannot be true; the list gives the reason.</source>
        <translation>Ctrl+Page Up과 Ctrl+Page Down으로 시행을 넘기며 오른쪽 이상점 목록이 비어 있지 않은 것을 찾으십시오. 이상점은 측정값이 참일 수 없는 순간이며, 목록에 그 까닭이 나옵니다.</translation>
    </message>
    <message>
        <source>Override it</source>
        <translation>판정 바꾸기</translation>
    </message>
    <message>
        <source>Click a spike in the list and watch the videos: was the robot really there? Press U to use the sample nevertheless. Odograph never deletes a measurement.</source>
        <translation>목록에서 이상점을 클릭하고 동영상을 보십시오. 로봇이 정말 그곳에 있었습니까? U를 누르면 그 샘플을 그래도 사용합니다. 측정한 것은 하나도 사라지지 않습니다.</translation>
    </message>
    <message>
        <source>Undo it</source>
        <translation>되돌리기</translation>
    </message>
    <message>
        <source>Press Ctrl+Z. Odograph saves every change at once, and you can undo it.</source>
        <translation>Ctrl+Z를 누르십시오. 바꾼 것은 모두 바로 저장되며 되돌릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Compare two runs</source>
        <translation>두 주행 비교하기</translation>
    </message>
    <message>
        <source>Press Ctrl+4. Choose two runs on the right: where was one faster? Grey differences are not significant.</source>
        <translation>Ctrl+4를 누르십시오. 오른쪽에서 두 주행을 선택하십시오. 어디에서 한쪽이 더 빨랐고, 그 차이가 오차보다 큽니까? 회색은 그렇지 않다는 뜻입니다.</translation>
    </message>
    <message>
        <source>Find it again</source>
        <translation>다시 찾기</translation>
    </message>
    <message>
        <source>Press Ctrl+5. History lists the whole year: type a team&apos;s name to search, press Enter to open a run, and see under Teams who made progress.</source>
        <translation>Ctrl+5를 누르십시오. 이력에는 한 해 전체가 들어 있습니다. 팀 이름을 입력하여 찾고, Enter로 주행을 열고, ‘팀’에서 누가 향상했는지 보십시오.</translation>
    </message>
    <message>
        <source>That&apos;s it</source>
        <translation>첫 수업을 마쳤습니다</translation>
    </message>
    <message>
        <source>For your own robots: create a project (Ctrl+N). Its Start page leads you from the clips of two phones, or from connected cameras, to a first result. F1 explains each page.</source>
        <translation>자신의 로봇으로: 프로젝트를 만드십시오(Ctrl+N). 시작 페이지가 휴대전화 두 대의 동영상 또는 연결된 카메라에서 첫 결과까지 안내합니다. F1이 각 페이지를 설명합니다.</translation>
    </message>
</context>
<context>
    <name>GuidanceWords</name>
    <message>
        <source>searched</source>
        <translation>탐색 영역</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>무시됨</translation>
    </message>
    <message>
        <source>%1 marked here</source>
        <translation>%1 여기에 표시됨</translation>
    </message>
    <message>
        <source>%1 set by hand</source>
        <translation>%1 수동 지정</translation>
    </message>
    <message>
        <source>no robot visible, by hand</source>
        <translation>보이는 로봇 없음 (수동)</translation>
    </message>
    <message>
        <source>%1 not visible, by hand</source>
        <translation>%1 보이지 않음 (수동)</translation>
    </message>
</context>
<context>
    <name>HealthWatch</name>
    <message>
        <source>The project is read-only</source>
        <translation>프로젝트를 읽기만 할 수 있음</translation>
    </message>
    <message>
        <source>Opening the cameras…</source>
        <translation>카메라를 여는 중…</translation>
    </message>
    <message>
        <source>No camera is running</source>
        <translation>작동 중인 카메라 없음</translation>
    </message>
    <message>
        <source>No camera sends frames</source>
        <translation>영상을 보내는 카메라 없음</translation>
    </message>
    <message>
        <source>This project is read-only: you cannot record into it.</source>
        <translation>이 프로젝트는 읽기만 할 수 있어 녹화할 수 없습니다.</translation>
    </message>
    <message>
        <source>Register &amp;it in Testbed</source>
        <translation>테스트베드에서 정합(&amp;I)</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>List of keys</source>
        <translation>단축키 목록</translation>
    </message>
    <message>
        <source>About Odograph</source>
        <translation>Odograph 정보</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.

Free software under the GNU General Public License, version 3 or later, without any warranty.

The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018.</source>
        <translation>일반 카메라의 동영상으로 이동 로봇이 어떻게 움직였는지 측정합니다.

GNU 일반 공중 사용 허가서(GPL) 버전 3 이상을 따르는 자유 소프트웨어이며, 어떠한 보증도 하지 않습니다.

방법은 S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018을 따릅니다.</translation>
    </message>
</context>
<context>
    <name>HtmlChart</name>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>평활화, ±95 % 띠 포함; 점: 측정값</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>평활화, ±95 % 띠 포함; 점: 측정값; 음영: 측정되지 않음</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>속력, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>경로 방향 가속도, %1</translation>
    </message>
</context>
<context>
    <name>HtmlMap</name>
    <message>
        <source>a square: %1</source>
        <translation>한 칸: %1</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>위에서 본 주행</translation>
    </message>
    <message>
        <source>coloured by speed, from 0 (dark) to %1 (light); ring: start, dot: end</source>
        <translation>속력에 따라 색칠, 0(어두움)부터 %1(밝음)까지; 고리: 시작, 점: 끝</translation>
    </message>
    <message>
        <source>Both runs from above</source>
        <translation>위에서 본 두 주행</translation>
    </message>
    <message>
        <source>in the colours of the runs</source>
        <translation>각 주행의 색으로</translation>
    </message>
</context>
<context>
    <name>HtmlPage</name>
    <message>
        <source>Made by Odograph %1; ± is one standard deviation.</source>
        <translation>Odograph %1(으)로 만듦; ±는 1 표준편차입니다.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>판정: %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>중간 기록</translation>
    </message>
    <message>
        <source>from the start to</source>
        <translation>출발부터</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>주행 %1</translation>
    </message>
    <message>
        <source>sector to %1</source>
        <translation>%1까지의 구간</translation>
    </message>
    <message>
        <source>No spikes.</source>
        <translation>이상점 없음.</translation>
    </message>
    <message numerus="yes">
        <source>Spikes: %n</source>
        <translation>
            <numerusform>이상점: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>reason</source>
        <translation>이유</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>외 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>참고 사항</translation>
    </message>
    <message>
        <source>Where this comes from</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>차이</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels. ≈: not significant.</source>
        <translation>두 주행은 같은 보정을 써서 그 불확도가 대부분 상쇄됩니다. ≈: 유의하지 않음.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count. ≈: not significant.</source>
        <translation>두 주행의 보정이 달라 양쪽의 불확도가 모두 반영됩니다. ≈: 유의하지 않음.</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>경로상의 속력, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>±95 % 띠와 함께</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>시간차, s</translation>
    </message>
    <message>
        <source>above 0: the second run is later; grey: not significant</source>
        <translation>0보다 위: 두 번째 주행이 늦음; 회색: 유의하지 않음</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>구간, s</translation>
    </message>
</context>
<context>
    <name>Hub</name>
    <message>
        <source>Connected.</source>
        <translation>연결되었습니다.</translation>
    </message>
    <message>
        <source>Everything had been sent.</source>
        <translation>이미 모두 보냈습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) sent.</source>
        <translation>
            <numerusform>%n개 항목을 보냈습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing new at the hub.</source>
        <translation>허브에 새로운 것이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) received.</source>
        <translation>
            <numerusform>%n개 항목을 받았습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recordings: %1 copied.</source>
        <translation>녹화: %1 복사했습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n more warning(s).</source>
        <translation>
            <numerusform>경고 %n개가 더 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%2의 %1</translation>
    </message>
    <message>
        <source>Teacher: may change everything</source>
        <translation>교사: 모두 바꿀 수 있음</translation>
    </message>
    <message>
        <source>Bench: publishes its own trials, reads those of others</source>
        <translation>측정대: 자기 시행을 게시하고 다른 시행을 읽음</translation>
    </message>
    <message>
        <source>Viewer: reads results only</source>
        <translation>열람자: 결과만 읽음</translation>
    </message>
    <message>
        <source>Nothing: all is sent</source>
        <translation>없음: 모두 보냄</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s)</source>
        <translation>
            <numerusform>변경 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>password needed</source>
        <translation>비밀번호 필요</translation>
    </message>
    <message>
        <source>server away</source>
        <translation>서버에 연결할 수 없음</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>받아들여지지 않음</translation>
    </message>
    <message>
        <source>Hub: %1</source>
        <translation>허브: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending, %1</source>
        <translation>
            <numerusform>허브: 대기 %n개, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Hub: publishing…</source>
        <translation>허브: 게시하는 중…</translation>
    </message>
    <message>
        <source>Hub: pulling…</source>
        <translation>허브: 받는 중…</translation>
    </message>
    <message>
        <source>Hub: all sent</source>
        <translation>허브: 모두 보냄</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending</source>
        <translation>
            <numerusform>허브: 대기 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>아직 응답 없음</translation>
    </message>
    <message numerus="yes">
        <source>Hub: publishing, %n pending</source>
        <translation>
            <numerusform>허브: 게시하는 중, 대기 %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapPainting</name>
    <message>
        <source>grid %1 %2</source>
        <translation>격자 %1 %2</translation>
    </message>
</context>
<context>
    <name>MatWords</name>
    <message>
        <source>Row %1, sheet %2</source>
        <translation>%1행 %2장</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>This line is %1 long on the whole mat. Measure it.</source>
        <translation>이 선은 매트 전체에서 %1입니다. 재어 보십시오.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets. Print at 100 % (actual size). Cut along the dashed lines.</source>
        <translation>%1 × %2장 바닥 매트. 100 %(실제 크기)로 인쇄하십시오. 점선을 따라 자르십시오.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>%1 × %2장 바닥 매트</translation>
    </message>
    <message>
        <source>1. Print all pages at 100 % (actual size), not fitted to the page.</source>
        <translation>1. 모든 쪽을 100 %(실제 크기)로, 페이지에 맞추지 않고 인쇄하십시오.</translation>
    </message>
    <message>
        <source>2. Cut each sheet along its dashed lines. Lay it on its neighbours, up to their thin lines, as drawn below, and tape the sheets together.</source>
        <translation>2. 각 종이를 점선을 따라 자르십시오. 아래 그림처럼 이웃 종이의 가는 선까지 겹쳐 놓고 테이프로 붙이십시오.</translation>
    </message>
    <message>
        <source>3. Measure the line at the lower edge. It should be %1 long; Odograph asks for what you measure.</source>
        <translation>3. 아래쪽 가장자리의 선을 재십시오. 길이는 %1이어야 하며, Odograph가 잰 값을 묻습니다.</translation>
    </message>
    <message>
        <source>4. Lay the mat flat where every camera sees all of it. The lower left corner is the origin, the lower edge the x axis.</source>
        <translation>4. 모든 카메라에 전체가 보이는 곳에 매트를 평평하게 놓으십시오. 왼쪽 아래 모서리가 원점, 아래쪽 가장자리가 x축입니다.</translation>
    </message>
</context>
<context>
    <name>Modes</name>
    <message>
        <source>Testbed</source>
        <translation>테스트베드</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>검토</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>History</source>
        <translation>이력</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>시작</translation>
    </message>
</context>
<context>
    <name>OutputQuestion</name>
    <message>
        <source>%1 is a file of another kind. Replace it?</source>
        <translation>%1은(는) 다른 종류의 파일입니다. 바꾸시겠습니까?</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1이(가) 이미 있습니다. 바꾸시겠습니까?</translation>
    </message>
</context>
<context>
    <name>OwnChanges</name>
    <message>
        <source>Done: %1. Press Ctrl+Z to undo it.</source>
        <translation>완료: %1. Ctrl+Z로 되돌릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>실행 취소함: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>다시 실행함: %1.</translation>
    </message>
</context>
<context>
    <name>PageMenus</name>
    <message>
        <source>&amp;View</source>
        <translation>보기(&amp;V)</translation>
    </message>
    <message>
        <source>T&amp;rial</source>
        <translation>시행(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Spikes</source>
        <translation>이상점(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>이력(&amp;H)</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>녹화(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>재생(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>도구(&amp;T)</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>구간(&amp;G)</translation>
    </message>
</context>
<context>
    <name>RangeFacts</name>
    <message>
        <source>from %1 to %2</source>
        <translation>%1부터 %2까지</translation>
    </message>
    <message>
        <source>The calibration&apos;s contribution to an angle is unknown and not included.</source>
        <translation>보정이 각도에 더하는 오차는 알 수 없어 포함하지 않았습니다.</translation>
    </message>
    <message>
        <source>Includes the position uncertainty of the calibration.</source>
        <translation>보정의 위치 오차를 포함합니다.</translation>
    </message>
    <message>
        <source>Includes the scale uncertainty of the calibration.</source>
        <translation>보정의 축척 오차를 포함합니다.</translation>
    </message>
    <message>
        <source>Neighbouring points of a smoothed curve have correlated errors. They average out over time, not over frames: with a spectrum of r/(1 + (ω/ω₀)⁶) for the position, ω₀ = √2 σv/σx.</source>
        <translation>평활화된 곡선에서 이웃한 값은 오차를 공유하므로 오차는 프레임 수가 아니라 시간으로 평균됩니다. 위치의 스펙트럼을 r/(1 + (ω/ω₀)⁶), ω₀ = √2 σv/σx로 봅니다.</translation>
    </message>
    <message>
        <source>From the smoothed curve, each value weighted by half the time to both neighbours: mean; median (the curve is below it half of the time); least and most, chosen by value + 2σ and value − 2σ; spread √(mean of the squared distance from the mean).</source>
        <translation>평활화된 곡선의 각 값이 양쪽 이웃까지 시간의 절반씩을 대표합니다. 평균, 중앙값(시간의 절반 동안 이보다 작음), 확실한 최솟값과 최댓값(값에 2σ를 더하거나 뺀 것으로 판단), 산포 √(평균과의 차이의 제곱 평균)를 구합니다.</translation>
    </message>
    <message>
        <source>no value here</source>
        <translation>여기에는 값이 없음</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1(%2)</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>평균</translation>
    </message>
    <message>
        <source>median</source>
        <translation>중앙값</translation>
    </message>
    <message>
        <source>least</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>most</source>
        <translation>최대</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>산포</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>점 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>does not fit: χ² is %1 times what the uncertainties explain</source>
        <translation>이 모양이 아님: χ²가 오차로 설명되는 값의 %1배</translation>
    </message>
    <message>
        <source>fits; the stated uncertainties are too large: χ² is %1 of its expected value</source>
        <translation>맞음; 표시된 오차가 너무 큼: χ²가 기대되는 값의 %1배</translation>
    </message>
    <message>
        <source>fits: χ² is %1 of its expected value</source>
        <translation>맞음: χ²가 오차로 기대되는 값의 %1배</translation>
    </message>
    <message>
        <source>Fit of %1</source>
        <translation>%1 피팅</translation>
    </message>
    <message>
        <source>The polynomial in t − t₀ that minimises Σ(residual/σ)² over %1, t₀ = %2. χ² is that sum divided by its expected value: the number of points minus the degrees of freedom of the coefficients.</source>
        <translation>%1에 대하여 Σ(잔차/σ)²가 가장 작은, t − t₀의 다항식이며 t₀ = %2입니다. χ²는 이 합을 오차로 기대되는 값, 곧 점의 수에서 계수가 차지하는 수를 뺀 값으로 나눈 것입니다.</translation>
    </message>
    <message>
        <source>the measured positions used</source>
        <translation>사용한 측정 위치</translation>
    </message>
    <message>
        <source>the smoothed curve</source>
        <translation>평활화된 곡선</translation>
    </message>
    <message>
        <source>The larger of two uncertainties: that of the measurements, widened by 1 + 2Σρ for correlated residuals (here ×%1), and that of the smoothed curve, including the errors that persist.</source>
        <translation>둘 중 큰 값: 측정값의 오차를 잔차가 서로 상관된 만큼 1 + 2Σρ로 넓힌 것(여기서는 ×%1)과, 측정 오차 가운데 오래 남는 부분까지 반영한 평활화된 곡선의 오차.</translation>
    </message>
    <message>
        <source>Assumes that the shape is correct; χ² far above 1 shows that it is not. χ² below 1 means that the smoother allows for more motion than the robot made.</source>
        <translation>이 모양이 참이라고 전제합니다. χ²가 1보다 훨씬 크면 그렇지 않다는 뜻입니다. 1보다 작은 것은 평활기가 실제보다 많은 움직임을 허용하기 때문입니다.</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>점 %1개</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 ~ %2: %3</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>이동 거리</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>피팅</translation>
    </message>
    <message>
        <source>value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>%1에서</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>기울기</translation>
    </message>
    <message>
        <source>slope there</source>
        <translation>그 점의 기울기</translation>
    </message>
    <message>
        <source>times t²</source>
        <translation>t²의 계수</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>잔차</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1(RMS)</translation>
    </message>
</context>
<context>
    <name>RecordHealth</name>
    <message>
        <source>problem</source>
        <translation>장애</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>느림</translation>
    </message>
    <message>
        <source>lost frames</source>
        <translation>누락</translation>
    </message>
    <message>
        <source>good</source>
        <translation>양호</translation>
    </message>
    <message>
        <source>, %1 ms</source>
        <translation>, %1 ms</translation>
    </message>
    <message>
        <source>; not registered</source>
        <translation>; 정합 안 됨</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>카메라 %1</translation>
    </message>
    <message>
        <source>no camera sees it</source>
        <translation>보이지 않음</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>안 보임</translation>
    </message>
    <message>
        <source>x %1, y %2, %3</source>
        <translation>x %1, y %2, %3</translation>
    </message>
    <message>
        <source>; one camera sees it</source>
        <translation>; 카메라 한 대에서만 보임</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>보임</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>보통</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>어긋남</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>동기</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>실시간</translation>
    </message>
    <message>
        <source>%1 MB written</source>
        <translation>%1 MB 기록됨</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>디스크</translation>
    </message>
    <message>
        <source>Camera %1 is not registered to the floor: it records, but cannot locate robots.</source>
        <translation>카메라 %1이(가) 바닥에 정합되지 않았습니다. 녹화는 되지만 로봇의 위치를 구할 수 없습니다.</translation>
    </message>
    <message>
        <source>Camera %1 was registered with frames of %2×%3, but now sends another size: it records, but cannot locate robots.</source>
        <translation>카메라 %1은(는) %2×%3 영상으로 정합했으나 지금 보내는 영상은 그렇지 않습니다. 녹화는 되지만 로봇의 위치를 구할 수 없습니다.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>녹화: %1</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>카메라 %1: %2</translation>
    </message>
    <message>
        <source>The disk is barely fast enough: record to a faster one, or with fewer cameras.</source>
        <translation>디스크 속도가 빠듯합니다. 더 빠른 디스크에 녹화하거나 카메라 수를 줄이십시오.</translation>
    </message>
    <message>
        <source>The disk is nearly full: %1</source>
        <translation>디스크가 거의 찼습니다: %1</translation>
    </message>
    <message>
        <source>The cameras are not synchronised: set both to the same frame rate.</source>
        <translation>카메라들의 동기가 맞지 않습니다. 둘 다 같은 프레임 속도로 설정하십시오.</translation>
    </message>
</context>
<context>
    <name>Remedy</name>
    <message>
        <source>Synchronise…</source>
        <translation>동기화…</translation>
    </message>
    <message>
        <source>Robots…</source>
        <translation>로봇…</translation>
    </message>
    <message>
        <source>Open Testbed</source>
        <translation>테스트베드 열기</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>추적…</translation>
    </message>
    <message>
        <source>Find lost videos…</source>
        <translation>잃은 동영상 찾기…</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>외 %n개</numerusform>
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
        <translation>속력, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>경로 방향 가속도, %1</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>평활화, ±95 % 띠 포함; 점: 측정값</translation>
    </message>
    <message>
        <source>No curve: the robot was not detected</source>
        <translation>곡선 없음: 로봇이 보이지 않음</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>평활화, ±95 % 띠 포함; 점: 측정값; 음영: 측정되지 않음</translation>
    </message>
</context>
<context>
    <name>ReportMethod</name>
    <message>
        <source>%1: %2 frames at %3/s</source>
        <translation>%1: %2프레임, 초당 %3프레임</translation>
    </message>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>%n프레임 누락</numerusform>
        </translation>
    </message>
    <message>
        <source>lens calibrated to %1 px</source>
        <translation>렌즈 보정 오차 %1 px</translation>
    </message>
    <message>
        <source>registered to the floor to %1 px, %2</source>
        <translation>바닥 정합 오차 %1 px, %2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>정합 안 됨</translation>
    </message>
    <message>
        <source>%1 samples: %2 measured, %3 used, %4 flagged, %5 bridged; the views disagree by %6 on average</source>
        <translation>샘플 %1개: 측정 %2, 사용 %3, 표시 %4, 이어 붙임 %5; 뷰 간 불일치 평균 %6</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t, s</translation>
    </message>
    <message>
        <source>x, %1</source>
        <translation>x, %1</translation>
    </message>
    <message>
        <source>y, %1</source>
        <translation>y, %1</translation>
    </message>
    <message>
        <source>speed, %1</source>
        <translation>속력, %1</translation>
    </message>
    <message>
        <source>± (σ)</source>
        <translation>± (σ)</translation>
    </message>
    <message>
        <source>acceleration, %1</source>
        <translation>가속도, %1</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>표시</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>측정한 것</translation>
    </message>
    <message>
        <source>every sample, smoothed</source>
        <translation>모든 샘플, 평활화됨</translation>
    </message>
    <message>
        <source>one sample of %1, smoothed; all of them are in the exported file</source>
        <translation>샘플 %1개마다 하나, 평활화됨; 전체는 내보낸 파일에 있음</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>smoother: %1</source>
        <translation>평활기: %1</translation>
    </message>
    <message>
        <source>analysed %1, Odograph %2</source>
        <translation>%1 분석, Odograph %2</translation>
    </message>
    <message>
        <source>%1: method</source>
        <translation>%1: 방법</translation>
    </message>
    <message>
        <source>How the metrics were computed</source>
        <translation>지표를 계산한 방법</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>±: %1.</source>
        <translation>±: %1.</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>도약</translation>
    </message>
    <message>
        <source>speed limit</source>
        <translation>속력 한계</translation>
    </message>
    <message>
        <source>acceleration limit</source>
        <translation>가속도 한계</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>뷰 불일치</translation>
    </message>
    <message>
        <source>low score</source>
        <translation>낮은 점수</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>놓침</translation>
    </message>
    <message>
        <source>duplicate frame</source>
        <translation>중복 프레임</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>보간됨</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>수동</translation>
    </message>
</context>
<context>
    <name>ReportStills</name>
    <message>
        <source>no image: the video cannot be read</source>
        <translation>사진 없음: 동영상을 읽을 수 없음</translation>
    </message>
    <message>
        <source>no image: the video is missing</source>
        <translation>사진 없음: 동영상을 찾을 수 없음</translation>
    </message>
</context>
<context>
    <name>RobotColours</name>
    <message>
        <source>blue</source>
        <translation>파랑</translation>
    </message>
    <message>
        <source>vermilion</source>
        <translation>주홍</translation>
    </message>
    <message>
        <source>green</source>
        <translation>초록</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>보라</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>주황</translation>
    </message>
    <message>
        <source>sky blue</source>
        <translation>하늘색</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>자동</translation>
    </message>
</context>
<context>
    <name>RunEvents</name>
    <message>
        <source>First seen, moving already</source>
        <translation>이미 움직이는 채로 처음 보임</translation>
    </message>
    <message>
        <source>Starts to move</source>
        <translation>움직이기 시작</translation>
    </message>
    <message>
        <source>Last seen, still moving</source>
        <translation>움직이는 채로 마지막으로 보임</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>정지</translation>
    </message>
    <message>
        <source>Top speed, %1</source>
        <translation>최고 속력, %1</translation>
    </message>
    <message>
        <source>Passes %1</source>
        <translation>%1 통과</translation>
    </message>
    <message>
        <source>Spike: %1</source>
        <translation>이상점: %1</translation>
    </message>
    <message numerus="yes">
        <source>(%n samples)</source>
        <translation>
            <numerusform>(샘플 %n개)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not measured for %1</source>
        <translation>%1 동안 측정되지 않음</translation>
    </message>
</context>
<context>
    <name>SceneDisagreement</name>
    <message>
        <source>Only one view at a time: nothing to compare</source>
        <translation>한 번에 한 뷰뿐: 비교할 것이 없음</translation>
    </message>
    <message>
        <source>RMS %1, median %2</source>
        <translation>RMS %1, 중앙값 %2</translation>
    </message>
    <message>
        <source>expected from the uncertainty: %1</source>
        <translation>오차로 기대되는 값: %1</translation>
    </message>
    <message>
        <source>%1 – more than it explains</source>
        <translation>%1 – 오차로 설명되는 것보다 큼</translation>
    </message>
    <message>
        <source>Disagreement of the views</source>
        <translation>뷰 간 불일치</translation>
    </message>
    <message>
        <source>Each view alone gives a floor position of the robot. The chart shows the distance between these positions in each frame with two views or more (of more than two, the largest distance); RMS is √(mean of the squares). Unused samples are left out.
Expected is √(tr A + tr B + (v·σs)²) from the covariances A and B of two views (pixels and calibration), the speed v and the synchronisation uncertainty σs of the views.
Much more than expected means that a setting is wrong: the views are not synchronised (the distance grows with the speed), a camera has moved or is badly registered (it depends on the position), or the robot&apos;s height is wrong (it points to and from the cameras).</source>
        <translation>각 뷰는 저마다 로봇을 바닥의 한 위치에 놓습니다. 두 뷰 이상이 로봇을 본 프레임마다 이 위치들이 얼마나 떨어져 있는지 나타냅니다(뷰가 셋 이상이면 가장 먼 거리). RMS는 √(제곱의 평균)입니다. 사용하지 않는 샘플은 뺍니다.
기대되는 값은 √(tr A + tr B + (v·σs)²)이며, A와 B는 두 뷰의 공분산(픽셀과 보정), v는 속력, σs는 뷰의 동기 오차입니다.
기대보다 훨씬 크면 무언가가 설정과 다르다는 뜻입니다. 뷰의 동기가 맞지 않거나(이때는 속력에 따라 커짐), 카메라가 이동했거나 정합이 나쁘거나(이때는 위치에 따라 다름), 로봇의 높이가 틀린 것입니다(이때는 카메라를 향하거나 등지는 방향으로 나타남).</translation>
    </message>
    <message>
        <source>%1 frames with two views or more; largest %2; views synchronised to %3 ms</source>
        <translation>두 뷰 이상에서 보인 프레임 %1개; 최대 %2; 뷰의 동기 오차 %3 ms</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>%1: not measured, no points (%2)</source>
        <translation>%1: 측정 안 됨, 점수 없음(%2)</translation>
    </message>
    <message>
        <source>%1 %2: %3 points (%4)</source>
        <translation>%1 %2: %3점(%4)</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4 points (%5)</source>
        <translation>%1 %2: %4점 중 %3점(%5)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2점</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1점</translation>
    </message>
    <message>
        <source>the sum of the points of each line; a line gives points × (metric − none at) / (all at − none at), from 0 to all</source>
        <translation>각 줄의 점수를 더한 것; 한 줄의 점수는 배점 × (지표 − 0점 기준) / (만점 기준 − 0점 기준)이며 0부터 만점까지</translation>
    </message>
    <message>
        <source>for each line, half the difference in points between its metric plus and minus one σ; root of the sum of the squares</source>
        <translation>줄마다 지표가 1 σ만큼 크거나 작을 때 점수 차이의 절반을 구하여 제곱합의 제곱근을 취한 값</translation>
    </message>
    <message>
        <source>%1 points off at %2 or less, none off at %3 or more</source>
        <translation>%2 이하이면 %1점 감점, %3 이상이면 감점 없음</translation>
    </message>
    <message>
        <source>%1 points off at %2 or more, none off at %3 or less</source>
        <translation>%2 이상이면 %1점 감점, %3 이하이면 감점 없음</translation>
    </message>
    <message>
        <source>%1 points at %2 or less, none at %3 or more</source>
        <translation>%2 이하이면 %1점, %3 이상이면 0점</translation>
    </message>
    <message>
        <source>%1 points at %2 or more, none at %3 or less</source>
        <translation>%2 이상이면 %1점, %3 이하이면 0점</translation>
    </message>
</context>
<context>
    <name>Scoreboard</name>
    <message>
        <source>Standings</source>
        <translation>순위</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>중앙값</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>차이</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>최고</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>최근</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>주행</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>순위</translation>
    </message>
    <message>
        <source>Best run</source>
        <translation>최고 주행</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>연결 중…</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting…</source>
        <translation>연결이 끊어졌습니다. 다시 연결 중…</translation>
    </message>
    <message>
        <source>This page needs JavaScript.</source>
        <translation>이 페이지에는 JavaScript가 필요합니다.</translation>
    </message>
    <message>
        <source>Teams rank by the median of their runs. Teams that do not differ significantly (95 %) share a rank. ±: one standard deviation. ≈: not significantly behind the first.</source>
        <translation>순위는 주행의 중앙값으로 정합니다. 유의한 차이(95 %)가 없는 팀은 같은 순위입니다. ±: 표준 편차. ≈: 1위와 유의한 차이 없음.</translation>
    </message>
    <message>
        <source>No ranks: no trial has a task, and runs of different tasks cannot be compared.</source>
        <translation>순위 없음: 과제가 있는 시행이 없으며, 과제가 다른 주행은 비교할 수 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course.</source>
        <translation>
            <numerusform>시행 %n개 제외: 다른 코스로 측정됨.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>시행 %n개 제외: 나쁜 결과.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! 결과가 의심스러운 시행 %n개 포함.</numerusform>
        </translation>
    </message>
    <message>
        <source>No team has a result yet.</source>
        <translation>아직 결과가 있는 팀이 없습니다.</translation>
    </message>
    <message>
        <source>Running now</source>
        <translation>주행 중</translation>
    </message>
    <message>
        <source>The best run from above</source>
        <translation>위에서 본 최고 주행</translation>
    </message>
    <message>
        <source>a square: %1</source>
        <translation>한 칸: %1</translation>
    </message>
</context>
<context>
    <name>SetupWords</name>
    <message>
        <source>Two phones on tripods are enough. Film the robot with both, import the clips or drop them on this window; or connect cameras.</source>
        <translation>삼각대에 올린 휴대전화 두 대면 충분합니다. 두 대로 로봇을 촬영하고 동영상을 가져오거나 이 창에 놓으십시오. 또는 카메라를 연결하십시오.</translation>
    </message>
    <message>
        <source>Cameras: %1.</source>
        <translation>카메라: %1.</translation>
    </message>
    <message>
        <source>Print the mat, tape it together and lay it where every camera sees it while it films: from it Odograph knows where the floor is.</source>
        <translation>매트를 인쇄해 붙이고 촬영 중에 모든 카메라에 보이는 곳에 놓으십시오. Odograph는 이것으로 바닥의 위치를 압니다.</translation>
    </message>
    <message>
        <source>Positions on the floor: %1.</source>
        <translation>바닥 위의 위치: %1.</translation>
    </message>
    <message>
        <source>Not registered yet: %1.</source>
        <translation>아직 정합되지 않음: %1.</translation>
    </message>
    <message>
        <source>A printed board measures the distortion of the lens; without it positions far from the mat are less exact, and their ± says so.</source>
        <translation>인쇄한 보드는 렌즈가 영상을 얼마나 휘게 하는지 보여 줍니다. 없으면 매트에서 먼 위치는 덜 정확하며, ±가 이를 나타냅니다.</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>보정됨: %1.</translation>
    </message>
    <message>
        <source>A name is enough: Odograph finds a robot of any look by its motion.</source>
        <translation>이름만 있으면 됩니다. Odograph는 어떤 모양의 로봇이든 움직임으로 찾습니다.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 외 %2개</translation>
    </message>
    <message>
        <source>Robots: %1.</source>
        <translation>로봇: %1.</translation>
    </message>
    <message>
        <source>Imported clips are tracked here, or record with connected cameras.</source>
        <translation>가져온 동영상을 여기서 추적하거나 연결된 카메라로 녹화합니다.</translation>
    </message>
    <message>
        <source>%1 is not measured yet.</source>
        <translation>%1이(가) 아직 측정되지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 is measured.</source>
        <translation>%1이(가) 측정되었습니다.</translation>
    </message>
    <message>
        <source>Path, speed, acceleration and their ±, spikes with reasons: one PDF for each trial, or for the class.</source>
        <translation>경로, 속도, 가속도와 ±, 이유가 붙은 스파이크: 시행마다 또는 학급 전체를 PDF 하나로.</translation>
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
        <translation>태그</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>고리</translation>
    </message>
    <message>
        <source>dot</source>
        <translation>점</translation>
    </message>
    <message>
        <source>tape crossing</source>
        <translation>테이프 교차점</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>모서리</translation>
    </message>
    <message>
        <source>crossing fields</source>
        <translation>바둑무늬 교차점</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>직접 지정</translation>
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
        <translation>체커보드, 안쪽 꼭짓점 %1 × %2, 정사각형 %3</translation>
    </message>
    <message>
        <source>ChArUco board, %1 × %2 inner corners, squares of %3</source>
        <translation>ChArUco 보드, 안쪽 꼭짓점 %1 × %2, 정사각형 %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (tag 36h11 number %2), %3</source>
        <translation>바닥 마커 %1(태그 36h11 번호 %2), %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (ring), %2</source>
        <translation>바닥 마커 %1(고리), %2</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Glue it flat onto something stiff, measure a square, and enter its side in Odograph.</source>
        <translation>100 %(실제 크기)로 인쇄하십시오. 단단한 판에 평평하게 붙이고 정사각형을 재어 그 값을 Odograph에 입력하십시오.</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Lay it flat; the marker&apos;s position is its middle, where the four lines at the edges point.</source>
        <translation>100 %(실제 크기)로 인쇄하십시오. 평평하게 놓으십시오. 마커의 위치는 가장자리의 네 선이 가리키는 가운데입니다.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>%1 × %2장 바닥 매트</translation>
    </message>
</context>
<context>
    <name>TestbedState</name>
    <message>
        <source>standard</source>
        <translation>표준</translation>
    </message>
    <message>
        <source>rational</source>
        <translation>유리 함수</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>어안</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>영상 크기</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>렌즈</translation>
    </message>
    <message>
        <source>%1, f = %2 px</source>
        <translation>%1, f = %2 px</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>보드 오차</translation>
    </message>
    <message>
        <source>%1 px in %2 images</source>
        <translation>사진 %2장에서 %1 px</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>교차 검증 오차</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>바닥 정합</translation>
    </message>
    <message>
        <source>registered %1</source>
        <translation>%1 정합됨</translation>
    </message>
    <message>
        <source>Last check</source>
        <translation>마지막 점검</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m, y %2 m, 높이 %3 m</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>마커</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>주의</translation>
    </message>
    <message>
        <source>not registered: cannot measure positions yet</source>
        <translation>정합 안 됨: 아직 위치를 측정할 수 없음</translation>
    </message>
    <message>
        <source>not calibrated: estimated from the markers</source>
        <translation>보정 안 됨: 마커에서 추정</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>보정 안 됨</translation>
    </message>
</context>
<context>
    <name>TrailPainting</name>
    <message>
        <source>0 to %1 %2</source>
        <translation>0 ~ %1 %2</translation>
    </message>
</context>
<context>
    <name>TrendPainting</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1(%2)</translation>
    </message>
    <message>
        <source>points</source>
        <translation>점</translation>
    </message>
</context>
<context>
    <name>TrialCurves</name>
    <message>
        <source>No curve yet: track the trial</source>
        <translation>아직 곡선 없음: 시행을 추적하십시오</translation>
    </message>
</context>
<context>
    <name>TrialExport</name>
    <message>
        <source>Export %1</source>
        <translation>%1 내보내기</translation>
    </message>
    <message>
        <source>%1 was exported to %2.</source>
        <translation>%1을(를) %2에 내보냈습니다.</translation>
    </message>
</context>
<context>
    <name>TrialFacts</name>
    <message>
        <source>%1, %2 high (estimated)</source>
        <translation>%1, 높이 %2(추정)</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, 높이 %2</translation>
    </message>
    <message>
        <source>%1: %2×%3, %4 frames</source>
        <translation>%1: %2×%3, %4프레임</translation>
    </message>
    <message>
        <source>View</source>
        <translation>뷰</translation>
    </message>
    <message>
        <source>video missing</source>
        <translation>동영상 없음</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>정합 안 됨</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>동기</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>동기화 안 됨</translation>
    </message>
    <message>
        <source>SHA-256 %1…</source>
        <translation>SHA-256 %1…</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>게이트</translation>
    </message>
    <message>
        <source>to %1 %2</source>
        <translation>%1까지 %2</translation>
    </message>
    <message>
        <source>Lap %1</source>
        <translation>랩 %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>주행 %1</translation>
    </message>
    <message>
        <source>off by %1 on average</source>
        <translation>평균 %1 벗어남</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1(RMS)</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>최대 %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>왼쪽으로 %1</translation>
    </message>
    <message>
        <source>%1 of it completed</source>
        <translation>%1 완주</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>지킴</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>analysed with a different course</source>
        <translation>다른 코스로 측정함</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>점수</translation>
    </message>
    <message>
        <source>none until you reanalyse the trial: the task has a different course now</source>
        <translation>다시 측정할 때까지 없음: 과제의 코스가 바뀌었음</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Testbed</source>
        <translation>테스트베드</translation>
    </message>
    <message>
        <source>markers “%1”</source>
        <translation>마커 “%1”</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>가져옴</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>경로</translation>
    </message>
    <message>
        <source>Distance from the path</source>
        <translation>경로에서 떨어진 거리</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>구역</translation>
    </message>
    <message>
        <source>Smoother</source>
        <translation>평활기</translation>
    </message>
    <message>
        <source>Analysed</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>%1, Odograph %2</source>
        <translation>%1, Odograph %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>참고</translation>
    </message>
    <message>
        <source>rate varies</source>
        <translation>속도 불규칙</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>승인…</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>철회</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>구간</translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation>전체 %3 중 %1~%2</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>In millimetres</source>
        <translation>밀리미터로</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>What the synchronisation is worth</source>
        <translation>동기화의 영향</translation>
    </message>
    <message>
        <source>σ of the time anywhere in the recording, of the offset and of the clock rate over its length, times the run&apos;s top speed. The remaining time error τ is that of d² = d₀² + τ²v² between the views&apos; distance d and the speed v: least squares over means of half a second.</source>
        <translation>녹화 전체에서 시간의 σ(시간차와 클록 속도에 의한 것)에 시행의 최고 속력을 곱한 값. 남은 시간 오차 τ는 뷰 사이 거리 d와 속력 v의 관계 d² = d₀² + τ²v²에서 얻음: 0.5초 평균에 대한 최소제곱.</translation>
    </message>
    <message>
        <source>of τ: by the scatter of those means. Blur grows with the speed, too, so τ is at most as stated.</source>
        <translation>τ의 σ: 이 평균들의 흩어짐에서. 흐림도 속력에 따라 커지므로 τ는 많아야 표시된 값임.</translation>
    </message>
    <message>
        <source>view %1: %2 frames</source>
        <translation>뷰 %1: 프레임 %2개</translation>
    </message>
    <message>
        <source>±%1 at the top speed</source>
        <translation>최고 속력에서 ±%1</translation>
    </message>
    <message>
        <source>%1: never inside</source>
        <translation>%1: 들어간 적 없음</translation>
    </message>
    <message>
        <source>%1: inside for at least %2</source>
        <translation>%1: 안에 적어도 %2</translation>
    </message>
    <message>
        <source>%1: inside for %2</source>
        <translation>%1: 안에 %2</translation>
    </message>
    <message>
        <source>, from the start</source>
        <translation>, 처음부터</translation>
    </message>
    <message numerus="yes">
        <source>, entered %n time(s)</source>
        <translation>
            <numerusform>, %n번 들어감</numerusform>
        </translation>
    </message>
    <message>
        <source>, first after %1</source>
        <translation>, 처음은 %1 후</translation>
    </message>
</context>
<context>
    <name>TrialReport</name>
    <message>
        <source>class median %1</source>
        <translation>학급 중앙값 %1</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>점수</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>위에서 본 주행</translation>
    </message>
    <message>
        <source>coloured by speed</source>
        <translation>색: 속력</translation>
    </message>
    <message>
        <source>The cameras’ views</source>
        <translation>카메라 뷰</translation>
    </message>
    <message>
        <source>at %1, the top speed</source>
        <translation>%1, 최고 속력일 때</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>%1일 때</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>주행 중 일어난 일</translation>
    </message>
    <message>
        <source>It did not move</source>
        <translation>움직이지 않음</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>중간 기록</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>주행 %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>%1까지</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>± one σ</source>
        <translation>± 1 σ</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>참고 사항</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet: it has no metrics.</source>
        <translation>이 시행은 아직 추적하지 않았으므로 지표가 없습니다.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>%1 times in all</source>
        <translation>모두 %1회</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… 외 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Bad results: do not use them.</source>
        <translation>나쁜 결과: 사용하지 마십시오.</translation>
    </message>
    <message>
        <source>Doubtful results, which were accepted.</source>
        <translation>의심스럽지만 승인된 결과.</translation>
    </message>
    <message>
        <source>Doubtful results: read the reasons before you use them.</source>
        <translation>의심스러운 결과: 사용하기 전에 이유를 읽으십시오.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>구간</translation>
    </message>
</context>
<context>
    <name>UncertainIntervals</name>
    <message>
        <source>Which robot? Until %1</source>
        <translation>어느 로봇? %1까지</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1(%2~%3)</translation>
    </message>
    <message>
        <source>Not measured until %1</source>
        <translation>%1까지 측정되지 않음</translation>
    </message>
    <message>
        <source>not measured (%1 to %2)</source>
        <translation>측정되지 않음(%1~%2)</translation>
    </message>
</context>
<context>
    <name>VerdictMark</name>
    <message>
        <source>accepted</source>
        <translation>승인됨</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>의심스러움</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>나쁨</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>통과</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>승인됨: %1</translation>
    </message>
    <message>
        <source>all checks passed</source>
        <translation>모든 검사 통과</translation>
    </message>
</context>
<context>
    <name>WindowTitle</name>
    <message>
        <source>Team %1</source>
        <translation>팀 %1</translation>
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
        <translation>상수</translation>
    </message>
</context>
<context>
    <name>analysis.a_parabola</name>
    <message>
        <source>a parabola</source>
        <translation>포물선</translation>
    </message>
</context>
<context>
    <name>analysis.a_straight_line</name>
    <message>
        <source>a straight line</source>
        <translation>직선</translation>
    </message>
</context>
<context>
    <name>analysis.align_by_distance</name>
    <message>
        <source>align by distance</source>
        <translation>거리로 정렬하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.align_otherwise</name>
    <message>
        <source>align by motion onset or distance</source>
        <translation>움직임의 시작이나 거리로 정렬하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.check_numbers</name>
    <message>
        <source>check the numbers</source>
        <translation>숫자를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_another_run</name>
    <message>
        <source>choose another run as well</source>
        <translation>다른 주행도 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_common_place</name>
    <message>
        <source>choose a position that both runs pass</source>
        <translation>두 주행이 모두 지나는 곳을 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_figure</name>
    <message>
        <source>choose a metric to score</source>
        <translation>무엇을 채점할지 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_log_of_run</name>
    <message>
        <source>choose the log of this run</source>
        <translation>이 주행의 로그를 선택하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_longer_range</name>
    <message>
        <source>choose a longer range</source>
        <translation>더 긴 범위를 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_motion</name>
    <message>
        <source>choose a run with motion</source>
        <translation>움직임이 있는 주행을 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_direction</name>
    <message>
        <source>choose runs in the same direction</source>
        <translation>같은 방향의 주행을 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_task</name>
    <message>
        <source>choose runs of the same task</source>
        <translation>같은 과제의 주행을 고르십시오</translation>
    </message>
</context>
<context>
    <name>analysis.comparison</name>
    <message>
        <source>comparison</source>
        <translation>비교</translation>
    </message>
</context>
<context>
    <name>analysis.comparison_of</name>
    <message>
        <source>comparison of %1</source>
        <translation>%1의 비교</translation>
    </message>
</context>
<context>
    <name>analysis.corners_in_order</name>
    <message>
        <source>enter the corners in order, all the way round</source>
        <translation>꼭짓점을 한 바퀴 차례대로 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.corners_off_floor</name>
    <message>
        <source>its corners are not all on a floor of 1 km</source>
        <translation>꼭짓점이 1 km 바닥 안에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.corners_once</name>
    <message>
        <source>enter each corner once</source>
        <translation>각 꼭짓점을 한 번씩만 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.corners_too_near</name>
    <message>
        <source>two corners are less than 1 mm apart</source>
        <translation>두 꼭짓점의 간격이 1 mm 미만입니다</translation>
    </message>
</context>
<context>
    <name>analysis.draw_coarsely</name>
    <message>
        <source>draw it with fewer corners</source>
        <translation>더 성기게 그리십시오</translation>
    </message>
</context>
<context>
    <name>analysis.ends_off_floor</name>
    <message>
        <source>its ends are not both on a floor of 1 km</source>
        <translation>두 끝이 1 km 바닥 안에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.ends_too_near</name>
    <message>
        <source>its ends are less than 1 mm apart</source>
        <translation>두 끝의 간격이 1 mm 미만입니다</translation>
    </message>
</context>
<context>
    <name>analysis.few_corners</name>
    <message>
        <source>it has fewer than three corners</source>
        <translation>꼭짓점이 세 개보다 적습니다</translation>
    </message>
</context>
<context>
    <name>analysis.few_points</name>
    <message>
        <source>it has too few points</source>
        <translation>점이 너무 적습니다</translation>
    </message>
</context>
<context>
    <name>analysis.finish_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the finish</source>
        <translation>게이트 &apos;%1&apos;이(가) 이미 도착입니다</translation>
    </message>
</context>
<context>
    <name>analysis.fit_of</name>
    <message>
        <source>fit of %1</source>
        <translation>피팅 (%1)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_best_lap</name>
    <message>
        <source>The shortest lap.</source>
        <translation>가장 짧은 랩입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_circle_radius</name>
    <message>
        <source>The least-squares circle through the positions of the motion.</source>
        <translation>움직인 위치들까지 거리의 제곱합이 가장 작은 원입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_bias</name>
    <message>
        <source>The mean of the distance from the reference path, to the left positive.</source>
        <translation>기준 경로에서 떨어진 거리를 왼쪽을 양으로 하여 평균한 값입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_max</name>
    <message>
        <source>The largest distance from the reference path.</source>
        <translation>기준 경로에서 가장 멀리 떨어진 거리입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_mean</name>
    <message>
        <source>The distance from the reference path, averaged along the path.</source>
        <translation>기준 경로에서 떨어진 거리를 경로에 걸쳐 평균한 값입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_rms</name>
    <message>
        <source>√(mean of the squared distance from the reference path), averaged along the path</source>
        <translation>√(기준 경로에서 떨어진 거리의 제곱 평균), 경로 전체</translation>
    </message>
</context>
<context>
    <name>analysis.formula_duration</name>
    <message>
        <source>From the onset of motion to the last stop. Moving means faster than three σ of the speed, for at least three frames, and further than noise explains; the moment between two frames is interpolated.</source>
        <translation>움직이기 시작한 때부터 마지막으로 멈춘 때까지입니다. 속력이 속력의 3 σ보다 큰 상태가 3프레임 이상 이어지고 잡음으로 설명되는 것보다 멀리 가면 움직이는 것으로 봅니다. 두 프레임 사이의 시각은 보간합니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_gate_time</name>
    <message>
        <source>From passing the start gate to passing the finish, each interpolated between frames.</source>
        <translation>출발 게이트를 지난 때부터 도착 게이트를 지난 때까지이며, 각 시각은 프레임 사이를 보간합니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_laps</name>
    <message>
        <source>Complete laps or runs, counted by the passages of the gates.</source>
        <translation>게이트 통과로 센 완주한 랩 또는 주행의 수입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_accel</name>
    <message>
        <source>The acceleration |a| of the smoothed curve where |a| − 3σ is largest.</source>
        <translation>평활화된 곡선에서 |a| − 3σ가 가장 큰 곳의 가속도 |a|입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_speed</name>
    <message>
        <source>The speed |v| of the smoothed curve where |v| − 3σ is largest. A point does not win only because its uncertainty is large.</source>
        <translation>평활화된 곡선에서 |v| − 3σ가 가장 큰 곳의 속력 |v|입니다. 부정확한 점이 오차 때문에 최댓값이 되는 일을 막습니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_turn_rate</name>
    <message>
        <source>How fast the robot turns, to the left or right, where the amount minus 3σ is largest. Of the body where its heading was measured, also on the spot: the rate of the smoothed heading. Elsewhere of the direction of motion: (vx·ay − vy·ax)/|v|² of the smoothed curve. &quot;At least&quot; where it may have turned faster because the rate is hardly known.</source>
        <translation>로봇이 도는 빠르기로, 방향에 관계없이 크기에서 3σ를 뺀 값이 가장 큰 곳의 값입니다. 몸체의 방향을 측정한 곳에서는 제자리 회전을 포함해 몸체의 값(평활화된 방향의 변화율)이고, 그 밖에는 움직임 방향의 값, 즉 평활화된 곡선의 (vx·ay − vy·ax)/|v|²입니다. 변화율을 거의 알 수 없어 더 빨리 돌았을 수 있으면 &quot;최소&quot;로 표시합니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_lap</name>
    <message>
        <source>The mean of the laps&apos; times.</source>
        <translation>랩 시간의 평균입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_speed</name>
    <message>
        <source>path length / time, both without gaps</source>
        <translation>이동 거리 / 시간(둘 다 측정되지 않은 구간 제외)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_median_speed</name>
    <message>
        <source>The speed that half of the time in motion stays below.</source>
        <translation>움직인 시간의 절반 동안 속력이 이 값보다 작습니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_moving_time</name>
    <message>
        <source>The time in which it moves: faster than three σ of the speed, and further than noise explains.</source>
        <translation>움직인 시간, 곧 속력이 속력의 3 σ보다 크고 잡음으로 설명되는 것보다 멀리 간 시간입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_accel</name>
    <message>
        <source>The acceleration that 95 % of the time in motion stays below.</source>
        <translation>움직인 시간의 95 % 동안 가속도가 이 값보다 작습니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_speed</name>
    <message>
        <source>The speed that 95 % of the time in motion stays below.</source>
        <translation>움직인 시간의 95 % 동안 속력이 이 값보다 작습니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_completed</name>
    <message>
        <source>The share of the reference path that the robot followed.</source>
        <translation>기준 경로 가운데 따라간 비율입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_length</name>
    <message>
        <source>∫|v|dt while it moves, by the trapezoidal rule over the smoothed speed. A gap that is not bridged adds nothing.</source>
        <translation>움직이는 동안의 ∫|v|dt를 평활화된 속력에 사다리꼴 공식을 적용하여 구합니다. 이어지지 않은 빈 곳은 더하지 않습니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_accel</name>
    <message>
        <source>√(mean of |a|²) while it moves</source>
        <translation>움직이는 동안 √(|a|²의 평균)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_speed</name>
    <message>
        <source>√(mean of |v|²) while it moves</source>
        <translation>움직이는 동안 √(|v|²의 평균)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_standing_time</name>
    <message>
        <source>time − time in motion</source>
        <translation>시간 − 움직인 시간</translation>
    </message>
</context>
<context>
    <name>analysis.formula_stops</name>
    <message>
        <source>The pauses between the onset of motion and the last stop, counted where the robot was measured at rest.</source>
        <translation>움직이기 시작한 때부터 마지막으로 멈춘 때까지, 멈춰 있는 것이 측정된 횟수입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_straightness</name>
    <message>
        <source>distance from the first to the last position of the motion / path length</source>
        <translation>움직임의 처음 위치와 마지막 위치 사이의 거리 / 이동 거리</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_breaches</name>
    <message>
        <source>How often the robot&apos;s reference point left a zone to stay in or entered a zone to keep out of. It counts if the point is beyond the edge by more than six σ of the track&apos;s noise.</source>
        <translation>로봇의 중심이 벗어나면 안 되는 구역을 나가거나 들어가면 안 되는 구역에 들어간 횟수입니다. 궤적 자체 잡음의 6 σ보다 더 경계를 넘었을 때 셉니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_depth</name>
    <message>
        <source>The largest distance of the robot&apos;s reference point beyond the edge of a zone.</source>
        <translation>로봇의 중심이 구역의 경계를 가장 멀리 넘은 거리입니다.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_time</name>
    <message>
        <source>The time for which the robot&apos;s reference point was beyond the edge of a zone, interpolated between frames; in two zones at once it counts twice.</source>
        <translation>로봇의 중심이 구역의 경계를 넘어 있던 시간이며 프레임 사이를 보간합니다. 두 구역을 동시에 어기면 두 번 셉니다.</translation>
    </message>
</context>
<context>
    <name>analysis.gate</name>
    <message>
        <source>gate &apos;%1&apos;</source>
        <translation>게이트 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.give_another_number</name>
    <message>
        <source>choose another number</source>
        <translation>다른 숫자를 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_corners</name>
    <message>
        <source>enter the corners of its outline, all the way round</source>
        <translation>윤곽의 꼭짓점을 한 바퀴 빠짐없이 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_ends</name>
    <message>
        <source>enter the two ends of the line that the robot passes</source>
        <translation>지나야 할 선의 두 끝을 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_limits</name>
    <message>
        <source>enter the largest speed and acceleration that a robot can reach in the task</source>
        <translation>과제에서 로봇이 낼 수 있는 최대 속력과 가속도를 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_log_offset</name>
    <message>
        <source>give the time offset of the log</source>
        <translation>로그의 시간 차이를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_place</name>
    <message>
        <source>enter its position in millimetres</source>
        <translation>위치를 밀리미터로 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_points</name>
    <message>
        <source>enter points from 1 to 1000; use a negative number for a penalty</source>
        <translation>1에서 1000까지, 벌점은 음수로 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_sizes</name>
    <message>
        <source>enter the sizes in millimetres</source>
        <translation>크기를 밀리미터로 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_three_numbers</name>
    <message>
        <source>enter three numbers</source>
        <translation>숫자 세 개를 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_points</name>
    <message>
        <source>enter at least two points, or three for a closed path</source>
        <translation>점을 두 개 이상, 닫힌 경로면 세 개 이상 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_values</name>
    <message>
        <source>enter two different values; the points rise between them</source>
        <translation>점수가 그 사이에서 오르는 두 값을 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.join_zones</name>
    <message>
        <source>merge neighbouring zones</source>
        <translation>나란한 구역을 합치십시오</translation>
    </message>
</context>
<context>
    <name>analysis.keep_what_matters</name>
    <message>
        <source>keep those that matter</source>
        <translation>중요한 것만 남기십시오</translation>
    </message>
</context>
<context>
    <name>analysis.limit_not_positive</name>
    <message>
        <source>a limit is zero or negative</source>
        <translation>한계가 0보다 크지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.limits</name>
    <message>
        <source>limits of a task</source>
        <translation>과제의 한계</translation>
    </message>
</context>
<context>
    <name>analysis.line_of_scoring</name>
    <message>
        <source>line %1 of the scoring</source>
        <translation>채점의 %1행</translation>
    </message>
</context>
<context>
    <name>analysis.little_motion</name>
    <message>
        <source>the robot hardly moves in %1</source>
        <translation>%1에서 로봇이 거의 움직이지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_no_common_time</name>
    <message>
        <source>fewer than %1 of its positions have times at which the robot was measured</source>
        <translation>로봇이 측정된 시각에 해당하는 위치가 %1개 미만입니다</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_front</name>
    <message>
        <source>the log&apos;s heading is %1 from the measured one throughout: its front or its axes may differ</source>
        <translation>로그의 방향이 측정된 방향과 계속 %1 차이가 납니다. 앞쪽이나 축이 다를 수 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_lengths</name>
    <message>
        <source>the log&apos;s lengths are %1 times the measured ones: its unit may be wrong</source>
        <translation>로그의 길이가 측정된 길이의 %1배입니다. 단위가 잘못되었을 수 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.log_is_mirrored</name>
    <message>
        <source>it is the mirror image of the run</source>
        <translation>주행의 거울상입니다</translation>
    </message>
</context>
<context>
    <name>analysis.log_moves_otherwise</name>
    <message>
        <source>it moves differently: at no time offset do more than %1 of the changes of speed and direction agree</source>
        <translation>다르게 움직입니다. 어떤 시간 차이에서도 속도와 방향 변화의 일치가 %1를 넘지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.many_corners</name>
    <message>
        <source>it has more than %1 corners</source>
        <translation>꼭짓점이 %1개를 넘습니다</translation>
    </message>
</context>
<context>
    <name>analysis.many_lines</name>
    <message>
        <source>it has more than %1 lines</source>
        <translation>%1행을 넘습니다</translation>
    </message>
</context>
<context>
    <name>analysis.many_points</name>
    <message>
        <source>it has more than %1 points</source>
        <translation>점이 %1개를 넘습니다</translation>
    </message>
</context>
<context>
    <name>analysis.many_zones</name>
    <message>
        <source>the task already has %1 zones</source>
        <translation>과제에 구역이 이미 %1개 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.metric_best_lap</name>
    <message>
        <source>Best lap</source>
        <translation>최고 랩</translation>
    </message>
</context>
<context>
    <name>analysis.metric_circle_radius</name>
    <message>
        <source>Circle&apos;s radius</source>
        <translation>원의 반지름</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_bias</name>
    <message>
        <source>Left of the path</source>
        <translation>경로 왼쪽 치우침</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_max</name>
    <message>
        <source>Off the path (most)</source>
        <translation>경로 이탈(최대)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_mean</name>
    <message>
        <source>Off the path (mean)</source>
        <translation>경로 이탈(평균)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_rms</name>
    <message>
        <source>Off the path (RMS)</source>
        <translation>경로 이탈(RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_displacement</name>
    <message>
        <source>Displacement</source>
        <translation>변위</translation>
    </message>
</context>
<context>
    <name>analysis.metric_duration</name>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gate_time</name>
    <message>
        <source>Start to finish</source>
        <translation>출발~도착 시간</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gates_passed</name>
    <message>
        <source>Gates passed</source>
        <translation>게이트 통과</translation>
    </message>
</context>
<context>
    <name>analysis.metric_height</name>
    <message>
        <source>Robot&apos;s height</source>
        <translation>로봇 높이</translation>
    </message>
</context>
<context>
    <name>analysis.metric_laps</name>
    <message>
        <source>Laps</source>
        <translation>랩 수</translation>
    </message>
</context>
<context>
    <name>analysis.metric_limit_breaches</name>
    <message>
        <source>Limits broken</source>
        <translation>한계 초과</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_accel</name>
    <message>
        <source>Top acceleration</source>
        <translation>최대 가속도</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_speed</name>
    <message>
        <source>Top speed</source>
        <translation>최고 속력</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_turn_rate</name>
    <message>
        <source>Fastest turn</source>
        <translation>최대 선회율</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_lap</name>
    <message>
        <source>Mean lap</source>
        <translation>평균 랩</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_speed</name>
    <message>
        <source>Mean speed</source>
        <translation>평균 속력</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_view_disagreement</name>
    <message>
        <source>Views disagree by</source>
        <translation>뷰 간 불일치</translation>
    </message>
</context>
<context>
    <name>analysis.metric_median_speed</name>
    <message>
        <source>Median speed</source>
        <translation>속력 중앙값</translation>
    </message>
</context>
<context>
    <name>analysis.metric_moving_time</name>
    <message>
        <source>Time in motion</source>
        <translation>움직인 시간</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_accel</name>
    <message>
        <source>P95 acceleration</source>
        <translation>가속도(P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_speed</name>
    <message>
        <source>P95 speed</source>
        <translation>속력(P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_completed</name>
    <message>
        <source>Path completed</source>
        <translation>경로 완주율</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_length</name>
    <message>
        <source>Path</source>
        <translation>이동 거리</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_accel</name>
    <message>
        <source>Acceleration (RMS)</source>
        <translation>가속도(RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_speed</name>
    <message>
        <source>Speed (RMS)</source>
        <translation>속력(RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_score</name>
    <message>
        <source>Score</source>
        <translation>점수</translation>
    </message>
</context>
<context>
    <name>analysis.metric_spikes</name>
    <message>
        <source>Spikes</source>
        <translation>이상점</translation>
    </message>
</context>
<context>
    <name>analysis.metric_standing_time</name>
    <message>
        <source>Standing time</source>
        <translation>정지 시간</translation>
    </message>
</context>
<context>
    <name>analysis.metric_stops</name>
    <message>
        <source>Stops</source>
        <translation>정지 횟수</translation>
    </message>
</context>
<context>
    <name>analysis.metric_straightness</name>
    <message>
        <source>Straightness</source>
        <translation>직진성</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_breaches</name>
    <message>
        <source>Zones broken</source>
        <translation>구역 위반 횟수</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_depth</name>
    <message>
        <source>Beyond zones (most)</source>
        <translation>구역 위반(최대)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_time</name>
    <message>
        <source>Time beyond zones</source>
        <translation>구역 위반 시간</translation>
    </message>
</context>
<context>
    <name>analysis.moment_outside</name>
    <message>
        <source>the moment entered for %1 is outside that run</source>
        <translation>%1에 지정한 시점이 그 주행 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.moments_missing</name>
    <message>
        <source>aligning runs by hand needs a moment in each run</source>
        <translation>직접 정렬하려면 각 주행의 시점이 필요합니다</translation>
    </message>
</context>
<context>
    <name>analysis.motion_gives_no_offset</name>
    <message>
        <source>the robot never changes its speed or its curvature by more than noise, so any time offset fits</source>
        <translation>로봇의 속도나 곡률이 잡음 이상으로 변하지 않아 어떤 시간 차이도 맞습니다</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_gate</name>
    <message>
        <source>give each gate a name of its own</source>
        <translation>게이트마다 다른 이름을 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_zone</name>
    <message>
        <source>give each zone a name of its own</source>
        <translation>구역마다 다른 이름을 주십시오</translation>
    </message>
</context>
<context>
    <name>analysis.name_twice</name>
    <message>
        <source>the name is used twice</source>
        <translation>이름이 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_figure</name>
    <message>
        <source>it names no metric</source>
        <translation>지표가 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_motion</name>
    <message>
        <source>the robot does not move in %1</source>
        <translation>%1에서 로봇이 움직이지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_onset</name>
    <message>
        <source>the robot of %1 is already moving when it is first seen</source>
        <translation>%1의 로봇이 처음 보일 때 이미 달리고 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_start_gate</name>
    <message>
        <source>%1 does not pass a start gate</source>
        <translation>%1은(는) 출발 게이트를 지나지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_step_of_delta</name>
    <message>
        <source>no stretch of %1 was measured without a gap, so there is no relative error</source>
        <translation>%1 구간이 끊김 없이 측정되지 않아 상대 오차가 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_role</name>
    <message>
        <source>gates have no such role</source>
        <translation>그런 역할이 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_rule</name>
    <message>
        <source>zones have no such rule</source>
        <translation>그런 구역 규칙이 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_template</name>
    <message>
        <source>no template has this name</source>
        <translation>그런 템플릿이 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.not_on_tasks_path</name>
    <message>
        <source>%1 shares no part of its path with the task&apos;s path</source>
        <translation>%1은(는) 과제의 경로와 겹치는 구간이 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.not_seen_there</name>
    <message>
        <source>%1 was not seen at the position used for alignment</source>
        <translation>정렬할 곳에서 %1이(가) 보이지 않았습니다</translation>
    </message>
</context>
<context>
    <name>analysis.nothing_in_common</name>
    <message>
        <source>%1 shares no part of its path with %2</source>
        <translation>%1은(는) %2과(와) 겹치는 구간이 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.number_is_none</name>
    <message>
        <source>one of its values is not a number</source>
        <translation>그 안의 숫자가 올바르지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_ambiguous</name>
    <message>
        <source>its motion repeats itself: time offsets %1 apart agree equally well</source>
        <translation>움직임이 반복됩니다. %1 떨어진 시간 차이들이 똑같이 잘 맞습니다</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_uncertain</name>
    <message>
        <source>its time offset is known only to ±%1</source>
        <translation>시간 차이를 ±%1까지만 알 수 있습니다</translation>
    </message>
</context>
<context>
    <name>analysis.offset_not_found</name>
    <message>
        <source>too little of its motion is also in the run to find the time offset</source>
        <translation>주행과 겹치는 움직임이 너무 적어 시간 차이를 구할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>analysis.one_point_too_few</name>
    <message>
        <source>%1 point is too few for it</source>
        <translation>점 %1개로는 너무 적습니다</translation>
    </message>
</context>
<context>
    <name>analysis.one_start_and_finish</name>
    <message>
        <source>keep one start and one finish, or one gate with the role start_finish</source>
        <translation>출발과 도착을 하나씩만 두거나 둘을 겸하는 게이트 하나를 두십시오</translation>
    </message>
</context>
<context>
    <name>analysis.other_direction</name>
    <message>
        <source>%1 runs in the opposite direction to %2</source>
        <translation>%1은(는) %2과(와) 반대 방향으로 달립니다</translation>
    </message>
</context>
<context>
    <name>analysis.outline_crosses</name>
    <message>
        <source>its outline crosses itself</source>
        <translation>윤곽이 스스로 교차합니다</translation>
    </message>
</context>
<context>
    <name>analysis.path_too_short</name>
    <message>
        <source>it is shorter than 1 mm</source>
        <translation>1 mm보다 짧습니다</translation>
    </message>
</context>
<context>
    <name>analysis.place_no_number</name>
    <message>
        <source>its position is not a number</source>
        <translation>위치가 숫자가 아닙니다</translation>
    </message>
</context>
<context>
    <name>analysis.points_off_floor</name>
    <message>
        <source>its points are not all on a floor of 1 km</source>
        <translation>점들이 1 km 바닥 안에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.points_out_of_range</name>
    <message>
        <source>its points are 0 or beyond ±1000</source>
        <translation>점수가 0이거나 1000을 넘습니다</translation>
    </message>
</context>
<context>
    <name>analysis.points_too_few</name>
    <message>
        <source>%1 points are too few for it</source>
        <translation>점 %1개로는 부족합니다</translation>
    </message>
</context>
<context>
    <name>analysis.reference_path</name>
    <message>
        <source>reference path</source>
        <translation>기준 경로</translation>
    </message>
</context>
<context>
    <name>analysis.role</name>
    <message>
        <source>role &apos;%1&apos;</source>
        <translation>역할 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.rule</name>
    <message>
        <source>rule &apos;%1&apos;</source>
        <translation>규칙 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.same_values</name>
    <message>
        <source>full points and no points have the same value</source>
        <translation>만점과 0점의 값이 같습니다</translation>
    </message>
</context>
<context>
    <name>analysis.sample_coarsely</name>
    <message>
        <source>sample it with fewer points</source>
        <translation>더 성기게 찍으십시오</translation>
    </message>
</context>
<context>
    <name>analysis.scoring</name>
    <message>
        <source>scoring</source>
        <translation>채점</translation>
    </message>
</context>
<context>
    <name>analysis.size_too_small</name>
    <message>
        <source>a size is less than 1 mm</source>
        <translation>크기가 1 mm 미만입니다</translation>
    </message>
</context>
<context>
    <name>analysis.start_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the start</source>
        <translation>게이트 &apos;%1&apos;이(가) 이미 출발입니다</translation>
    </message>
</context>
<context>
    <name>analysis.still_in_common_time</name>
    <message>
        <source>the robot does not move in the common time</source>
        <translation>공통 시간 동안 로봇이 움직이지 않습니다</translation>
    </message>
</context>
<context>
    <name>analysis.takes_two_runs</name>
    <message>
        <source>it needs two runs</source>
        <translation>주행 두 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moment_inside</name>
    <message>
        <source>enter one between its first and last frame</source>
        <translation>첫 프레임과 마지막 프레임 사이로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moments</name>
    <message>
        <source>enter one for each run</source>
        <translation>각각 하나씩 지정하십시오</translation>
    </message>
</context>
<context>
    <name>analysis.template</name>
    <message>
        <source>template &apos;%1&apos;</source>
        <translation>템플릿 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.template_of_task</name>
    <message>
        <source>template of a task</source>
        <translation>과제의 템플릿</translation>
    </message>
</context>
<context>
    <name>analysis.turn_sign</name>
    <message>
        <source>change the sign of one of its coordinates</source>
        <translation>좌표 하나의 부호를 바꾸십시오</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_best_lap</name>
    <message>
        <source>of its two passages; the calibration uncertainty of a gate passed twice cancels</source>
        <translation>두 통과 시각의 오차; 같은 게이트를 두 번 지나면 보정 오차는 상쇄됨</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_circle_radius</name>
    <message>
        <source>of the scatter of the distances, with their number divided by 1 + 2Σρ for correlated neighbours, and the calibration&apos;s scale uncertainty</source>
        <translation>거리의 흩어짐(이웃한 점의 상관을 고려하여 점의 수를 1 + 2Σρ로 나눔)과 보정의 축척 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_correlated</name>
    <message>
        <source>the bound for fully correlated errors, and the calibration&apos;s scale uncertainty</source>
        <translation>모든 오차가 같은 방향으로 겹칠 때의 상한과 보정의 축척 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_bias</name>
    <message>
        <source>of the position across the path, mostly the calibration&apos;s</source>
        <translation>경로에 수직인 방향 위치의 오차, 대부분 보정에서 옴</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_max</name>
    <message>
        <source>of the position across the path, there</source>
        <translation>그 지점에서 경로에 수직인 방향 위치의 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_mean</name>
    <message>
        <source>of the position across the path, and of its noise: the distance has no sign, so noise does not cancel</source>
        <translation>경로에 수직인 방향 위치의 오차와, 거리에는 부호가 없어 평균에 남는 잡음의 영향</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_rms</name>
    <message>
        <source>of the position across the path</source>
        <translation>경로에 수직인 방향 위치의 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_duration</name>
    <message>
        <source>of both moments: σ of the speed divided by its slope there, and how far smoothing blurs them</source>
        <translation>두 시각의 오차: 속력의 σ를 그 지점에서 속력 곡선의 기울기로 나눈 값과, 평활화로 흐려진 정도</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_gate_time</name>
    <message>
        <source>of both passages: σ of the position across the gate divided by the speed</source>
        <translation>두 통과 시각의 오차: 게이트에 수직인 방향 위치의 σ를 속력으로 나눈 값</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_max_turn_rate</name>
    <message>
        <source>of the body: that of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order; of n peaks within 2σ also σ√(2 ln n)</source>
        <translation>몸체: 평활화된 방향의 변화율의 불확도; 움직임 방향: σ² = σa²/|v|² + |a|²σv²/|v|⁴, 1차 근사; 2σ 이내의 봉우리가 n개이면 σ√(2 ln n)도 더합니다</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_lap</name>
    <message>
        <source>of the first and the last passage, over the number of laps</source>
        <translation>처음과 마지막 통과 시각의 오차를 랩 수로 나눈 값</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_speed</name>
    <message>
        <source>of both, treated as independent, and of gaps: from straight through them to the top speed in them</source>
        <translation>둘의 오차(서로 독립으로 봄)와 측정되지 않은 구간의 불확실성: 직선으로 지나간 경우부터 최고 속력으로 움직인 경우까지</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_moving_time</name>
    <message>
        <source>of each start and stop: σ of the speed divided by its slope</source>
        <translation>각 출발과 정지의 오차: 속력의 σ를 속력 곡선의 기울기로 나눈 값</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_curve</name>
    <message>
        <source>that of the smoothed curve there; how far the largest of n equal values exceeds them, σ√(2 ln n) at most, of the n peaks within 2σ; and the calibration&apos;s scale uncertainty</source>
        <translation>그 지점에서 평활화된 곡선의 오차; 같은 값 n개 중 가장 큰 값이 이를 넘는 정도(2σ 이내의 봉우리 n개, 최대 σ√(2 ln n)); 보정의 축척 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_intervals</name>
    <message>
        <source>of the intervals within 1.5 σ of it, each by its mean</source>
        <translation>이 값에서 1.5 σ 이내인 부분들의 오차, 각 부분은 평균으로 계산</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_path_length</name>
    <message>
        <source>of the end positions, of lateral errors where the path turns, of what the robot could have done where it was bridged, and the calibration&apos;s scale uncertainty</source>
        <translation>양 끝 위치의 오차, 경로가 꺾이는 곳에서 경로에 수직인 방향의 오차, 보간된 구간에서 로봇이 했을 수 있는 움직임, 보정의 축척 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_standing_time</name>
    <message>
        <source>of each start and stop</source>
        <translation>각 출발과 정지의 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_straightness</name>
    <message>
        <source>of the end positions</source>
        <translation>양 끝 위치의 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_depth</name>
    <message>
        <source>of the position across the edge, there</source>
        <translation>그 지점에서 경계에 수직인 방향 위치의 오차</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_time</name>
    <message>
        <source>of each crossing of an edge: σ of the position across it divided by the speed; and the change of the time when the calibration uncertainty shifts the track</source>
        <translation>경계를 지난 각 시각의 오차: 경계에 수직인 방향 위치의 σ를 속력으로 나눈 값; 그리고 보정에 따라 궤적이 더 가깝거나 멀게 놓일 때 생기는 시간의 차이</translation>
    </message>
</context>
<context>
    <name>analysis.use_a_rule</name>
    <message>
        <source>use stay_inside or stay_outside</source>
        <translation>stay_inside나 stay_outside를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>analysis.use_one_of</name>
    <message>
        <source>use %1</source>
        <translation>%1을(를) 쓰십시오</translation>
    </message>
</context>
<context>
    <name>analysis.wrong_poles</name>
    <message>
        <source>a slalom has 1 to 100 poles, not %1</source>
        <translation>슬라럼의 기둥은 %1개가 아니라 1~100개입니다</translation>
    </message>
</context>
<context>
    <name>analysis.zone</name>
    <message>
        <source>zone &apos;%1&apos;</source>
        <translation>구역 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>backup.disk_nearly_full</name>
    <message>
        <source>the disk has only %1 left</source>
        <translation>디스크에 %1만 남았습니다</translation>
    </message>
</context>
<context>
    <name>backup.of_project</name>
    <message>
        <source>backup of &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 백업</translation>
    </message>
</context>
<context>
    <name>base.and</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>base.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>카메라 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.cancelled</name>
    <message>
        <source>cancelled</source>
        <translation>취소됨</translation>
    </message>
</context>
<context>
    <name>base.cannot_do_this</name>
    <message>
        <source>cannot do this</source>
        <translation>이 작업을 할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>base.class</name>
    <message>
        <source>class &apos;%1&apos;</source>
        <translation>학급 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.close_other_programs</name>
    <message>
        <source>close other programs and try again</source>
        <translation>다른 프로그램을 닫고 다시 시도하십시오</translation>
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
        <translation>색 &apos;%1&apos;</translation>
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
        <translation>파일 &apos;%1&apos;</translation>
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
        <translation>장치입니다</translation>
    </message>
</context>
<context>
    <name>base.is_folder</name>
    <message>
        <source>it is a folder</source>
        <translation>폴더입니다</translation>
    </message>
</context>
<context>
    <name>base.is_pipe</name>
    <message>
        <source>it is a named pipe</source>
        <translation>이름 있는 파이프입니다</translation>
    </message>
</context>
<context>
    <name>base.is_socket</name>
    <message>
        <source>it is a socket</source>
        <translation>소켓입니다</translation>
    </message>
</context>
<context>
    <name>base.layout</name>
    <message>
        <source>layout &apos;%1&apos;</source>
        <translation>배치 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.length</name>
    <message>
        <source>length &apos;%1&apos;</source>
        <translation>길이 &apos;%1&apos;</translation>
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
        <translation>#rrggbb 형식이 아닙니다</translation>
    </message>
</context>
<context>
    <name>base.no_files</name>
    <message>
        <source>too many files are open</source>
        <translation>열려 있는 파일이 너무 많습니다</translation>
    </message>
</context>
<context>
    <name>base.no_length</name>
    <message>
        <source>not a number with the unit mm, cm or m</source>
        <translation>단위 mm, cm 또는 m이 붙은 숫자가 아닙니다</translation>
    </message>
</context>
<context>
    <name>base.no_memory</name>
    <message>
        <source>this computer does not have enough free memory for it</source>
        <translation>이 컴퓨터에 남은 메모리가 부족합니다</translation>
    </message>
</context>
<context>
    <name>base.no_number</name>
    <message>
        <source>not a finite decimal number</source>
        <translation>유한한 십진수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>base.no_thread</name>
    <message>
        <source>this computer cannot start another thread</source>
        <translation>이 컴퓨터에서 스레드를 더 만들 수 없습니다</translation>
    </message>
</context>
<context>
    <name>base.none</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>base.nothing_changed</name>
    <message>
        <source>nothing was changed</source>
        <translation>바뀐 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>base.number</name>
    <message>
        <source>number &apos;%1&apos;</source>
        <translation>수 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.or</name>
    <message>
        <source>%1 or %2</source>
        <translation>%1 또는 %2</translation>
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
        <translation>로봇 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.robot_in_trial</name>
    <message>
        <source>robot &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>시행 &apos;%2&apos;의 로봇 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.saved_is_safe</name>
    <message>
        <source>what was saved is safe</source>
        <translation>저장된 것은 안전합니다</translation>
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
        <translation>과제 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.team</name>
    <message>
        <source>team &apos;%1&apos;</source>
        <translation>팀 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.trial</name>
    <message>
        <source>trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.try_again_and_report</name>
    <message>
        <source>try again, and report it if it happens again</source>
        <translation>다시 시도하고, 또 일어나면 알려 주십시오</translation>
    </message>
</context>
<context>
    <name>base.unexpected</name>
    <message>
        <source>something unexpected happened (%1)</source>
        <translation>예기치 않은 일이 일어났습니다(%1)</translation>
    </message>
</context>
<context>
    <name>base.view_in_trial</name>
    <message>
        <source>view &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>시행 &apos;%2&apos;의 뷰 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.wordless_exception</name>
    <message>
        <source>an unknown exception</source>
        <translation>설명이 없는 예외</translation>
    </message>
</context>
<context>
    <name>base.write_colour</name>
    <message>
        <source>write it like #d72328</source>
        <translation>#d72328처럼 쓰십시오</translation>
    </message>
</context>
<context>
    <name>base.write_length</name>
    <message>
        <source>write it like 25mm, 2.5cm or 0.3m</source>
        <translation>25mm, 2.5cm 또는 0.3m처럼 쓰십시오</translation>
    </message>
</context>
<context>
    <name>base.write_number</name>
    <message>
        <source>write it with digits and a point, like 12.5</source>
        <translation>12.5처럼 숫자와 점으로 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.add_floor_points</name>
    <message>
        <source>add floor points, such as corners of tiles</source>
        <translation>타일 모서리 같은 바닥의 점을 추가하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.all_agree</name>
    <message>
        <source>The markers and the cameras agree with each other.</source>
        <translation>마커와 카메라가 서로 일치합니다.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed</name>
    <message>
        <source>The world axes were changed afterwards.</source>
        <translation>이후 월드 축이 바뀌었습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed_and_scaled</name>
    <message>
        <source>The world axes were changed afterwards, and all lengths multiplied by %1.</source>
        <translation>이후 월드 축이 바뀌었고 모든 길이에 %1을(를) 곱했습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_no_number</name>
    <message>
        <source>the origin or the angle is not a finite number</source>
        <translation>원점이나 각도가 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.axes_not_changed</name>
    <message>
        <source>the axes of layout &apos;%1&apos; cannot be changed</source>
        <translation>배치 &apos;%1&apos;의 좌표축을 바꿀 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.best_place</name>
    <message>
        <source>the best camera position</source>
        <translation>카메라의 가장 좋은 위치</translation>
    </message>
</context>
<context>
    <name>calibration.board_blurred</name>
    <message>
        <source>the board is blurred</source>
        <translation>보드가 흐립니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_cut_off</name>
    <message>
        <source>the board is cut off</source>
        <translation>보드가 잘렸습니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_fills</name>
    <message>
        <source>it fills %1 of the image</source>
        <translation>사진의 %1를 차지합니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_in_one_place</name>
    <message>
        <source>all %1 images show the board in one position, the %2 %3 of the image</source>
        <translation>사진 %1장 모두 보드가 한곳에 있습니다 (%2, 영상의 %3)</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_flat</name>
    <message>
        <source>the corners do not match a flat board</source>
        <translation>모서리가 평평한 보드처럼 놓여 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_sharp</name>
    <message>
        <source>the board is not sharp</source>
        <translation>보드가 선명하지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_of_other_size</name>
    <message>
        <source>this board has %1 inner corners, not %2</source>
        <translation>이 보드의 내부 모서리는 %1, 요청은 %2입니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_part_seen</name>
    <message>
        <source>only %1 of its %2 inner corners are visible</source>
        <translation>내부 모서리 %2 중 %1만 보입니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_before</name>
    <message>
        <source>the board is in the same position as in an earlier image</source>
        <translation>보드가 이미 찍은 사진에서처럼 놓여 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_in</name>
    <message>
        <source>the board is in the same position as in %1</source>
        <translation>보드가 이미 %1에서처럼 놓여 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_oblique</name>
    <message>
        <source>the board is tilted too far, by %1 degrees</source>
        <translation>보드가 %1도로 너무 비스듬히 보입니다</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_small</name>
    <message>
        <source>the board is too small</source>
        <translation>보드가 너무 작습니다</translation>
    </message>
</context>
<context>
    <name>calibration.calibrate_to_rely</name>
    <message>
        <source>Calibrate it for reliable positions.</source>
        <translation>믿을 만한 위치를 얻으려면 보정하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.camera_alone_says</name>
    <message>
        <source>Camera &apos;%1&apos; alone measures %2</source>
        <translation>카메라 &apos;%1&apos;만으로는 %2입니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_below_floor</name>
    <message>
        <source>in this order the camera would be below the floor</source>
        <translation>이 순서라면 카메라가 바닥 아래에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_moved</name>
    <message>
        <source>%1 has moved %2 = %3</source>
        <translation>%1이(가) %2 = %3 움직였습니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_not_moved</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>카메라 ‘%1’</translation>
    </message>
</context>
<context>
    <name>calibration.camera_positions</name>
    <message>
        <source>the camera positions</source>
        <translation>카메라 위치</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_elsewhere</name>
    <message>
        <source>%1 sees %2 %3 from where the others see it</source>
        <translation>%1이(가) %2을(를) 다른 카메라보다 %3 떨어진 곳에서 봄</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_too_few</name>
    <message>
        <source>camera &apos;%1&apos; sees only %2 of the markers</source>
        <translation>카메라 &apos;%1&apos;이(가) 마커를 %2개만 봅니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_stands_low</name>
    <message>
        <source>The camera would be only %1 above the floor</source>
        <translation>카메라가 바닥 위 %1에만 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_still</name>
    <message>
        <source>%1 has not moved</source>
        <translation>%1은(는) 정합한 자리에 그대로 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_high</name>
    <message>
        <source>the camera would be %1 above the floor</source>
        <translation>카메라가 바닥 위 %1에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_low</name>
    <message>
        <source>the camera would be only %1 above the floor</source>
        <translation>카메라가 바닥 위 %1에만 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_twice</name>
    <message>
        <source>camera &apos;%1&apos; appears twice</source>
        <translation>카메라 &apos;%1&apos;이(가) 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.camera_upside_down</name>
    <message>
        <source>The camera would be upside down</source>
        <translation>카메라가 거꾸로 놓인 것이 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_of_one_image</name>
    <message>
        <source>%1 and %2 have the same pixels and count as one camera.</source>
        <translation>%1와(과) %2은(는) 픽셀이 같아 하나의 카메라로 계산됩니다.</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_undetermined</name>
    <message>
        <source>the markers do not determine the camera positions</source>
        <translation>마커로 카메라의 위치를 정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.cannot_be_calibrated</name>
    <message>
        <source>the camera cannot be calibrated</source>
        <translation>카메라를 보정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.centimetres</name>
    <message>
        <source>centimetres</source>
        <translation>센티미터</translation>
    </message>
</context>
<context>
    <name>calibration.centre_is_off</name>
    <message>
        <source>The optical centre is %1 off the image&apos;s middle</source>
        <translation>광학 중심이 이미지 중심에서 %1 벗어나 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.check_all</name>
    <message>
        <source>check the layout, the labels and the intrinsics</source>
        <translation>배치, 이름표, 내부 파라미터를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_lenses</name>
    <message>
        <source>check its pixels and the intrinsics of both cameras</source>
        <translation>픽셀과 두 카메라의 내부 파라미터를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_pixels</name>
    <message>
        <source>check its pixels in both images</source>
        <translation>두 영상에서 그 픽셀을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_columns</name>
    <message>
        <source>check which columns belong to which camera</source>
        <translation>어느 열이 어느 카메라의 것인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_first_registration</name>
    <message>
        <source>check the registration of %1 and the pair</source>
        <translation>%1의 정합과 카메라 쌍을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_labels</name>
    <message>
        <source>check these labels</source>
        <translation>이 이름표들을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_layout_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, cover other round objects, or mark the markers by hand</source>
        <translation>배치의 위치와 단위를 확인하고, 다른 둥근 것을 가리거나 마커를 손으로 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_length</name>
    <message>
        <source>Check the length itself, that it is on the floor, and the marker positions.</source>
        <translation>길이 자체, 바닥에 놓였는지, 마커의 자리를 확인하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.check_one_camera</name>
    <message>
        <source>check that all are of one camera, at one zoom and focus</source>
        <translation>모두 한 카메라로 같은 줌과 초점에서 찍었는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_pictures</name>
    <message>
        <source>check that all images are sharp, of one flat board and of one camera at one zoom and focus</source>
        <translation>모든 사진이 선명하고, 평평한 한 보드를 한 카메라로 같은 줌과 초점에서 찍었는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_pixel_and_lens</name>
    <message>
        <source>check its pixel and the camera&apos;s intrinsics</source>
        <translation>그 픽셀과 카메라의 내부 파라미터를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_place_and_pixel</name>
    <message>
        <source>check its position and its pixel</source>
        <translation>그 자리와 픽셀을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_point_labels</name>
    <message>
        <source>check which label belongs to which point in %1 and in this camera</source>
        <translation>%1과(와) 이 카메라에서 이름표와 점이 맞는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_signs</name>
    <message>
        <source>check the signs of the layout</source>
        <translation>배치의 부호를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_tag_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, or mark the markers by hand</source>
        <translation>배치의 위치와 단위를 확인하거나 마커를 손으로 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.check_unit</name>
    <message>
        <source>check the unit of the layout</source>
        <translation>배치의 단위를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.checking_halves</name>
    <message>
        <source>checking the halves against each other</source>
        <translation>절반끼리 서로 검증하는 중</translation>
    </message>
</context>
<context>
    <name>calibration.choose_floor_points</name>
    <message>
        <source>choose points on the floor</source>
        <translation>바닥의 점을 고르십시오</translation>
    </message>
</context>
<context>
    <name>calibration.choose_others</name>
    <message>
        <source>choose others</source>
        <translation>다른 것을 고르십시오</translation>
    </message>
</context>
<context>
    <name>calibration.clear_view</name>
    <message>
        <source>clear the view of the markers</source>
        <translation>마커가 보이게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.common_and_unknown_markers</name>
    <message>
        <source>they have %1 (%2), and the layout does not contain %3</source>
        <translation>%1개뿐이며(%2) 배치에 %3이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.common_markers</name>
    <message>
        <source>they have %1 (%2)</source>
        <translation>%1개뿐입니다 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.convert_unit</name>
    <message>
        <source>convert its unit.</source>
        <translation>단위를 변환하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_left_out</name>
    <message>
        <source>1 outlier corner was left out, in %1.</source>
        <translation>튀는 모서리 1개를 제외함, %1.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_no_number</name>
    <message>
        <source>a corner of it is not a number</source>
        <translation>모서리 하나가 숫자가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.corner_of_many_tags</name>
    <message>
        <source>a corner is that of one tag</source>
        <translation>모서리는 태그 하나의 것입니다</translation>
    </message>
</context>
<context>
    <name>calibration.corner_unclear</name>
    <message>
        <source>one corner of the board is unclear</source>
        <translation>보드의 모서리 하나를 알아볼 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.corners_disagree</name>
    <message>
        <source>%1 of the corners do not agree with the others</source>
        <translation>모서리의 %1가 나머지와 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, in %2</source>
        <translation>나란히 튀는 모서리 %1개를 그대로 둠, %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_most_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, most in %2</source>
        <translation>나란히 튀는 모서리 %1개를 그대로 둠, 주로 %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_in</name>
    <message>
        <source>%1 outlier corners were left out, in %2.</source>
        <translation>튀는 모서리 %1개를 제외함, %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_most_in</name>
    <message>
        <source>%1 outlier corners were left out, most in %2.</source>
        <translation>튀는 모서리 %1개를 제외함, 주로 %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_not_flat</name>
    <message>
        <source>its corners do not match a flat board</source>
        <translation>모서리가 평평한 보드처럼 놓여 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.corners_nowhere_near</name>
    <message>
        <source>its corners are %1 from where the other images predict them, theirs %2</source>
        <translation>코너가 다른 이미지의 예측에서 %1 벗어나 있으며, 다른 이미지는 %2입니다</translation>
    </message>
</context>
<context>
    <name>calibration.correct_layout</name>
    <message>
        <source>correct the layout</source>
        <translation>배치를 고치십시오</translation>
    </message>
</context>
<context>
    <name>calibration.correct_pixels</name>
    <message>
        <source>correct the pixels</source>
        <translation>픽셀을 고치십시오</translation>
    </message>
</context>
<context>
    <name>calibration.count_corners</name>
    <message>
        <source>count the inner corners, or leave the size out</source>
        <translation>내부 모서리를 세거나 크기를 비워 두십시오</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_in</name>
    <message>
        <source>%1 of the corners disagree, in %2</source>
        <translation>모서리의 %1가 맞지 않음, %2</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_most_in</name>
    <message>
        <source>%1 of the corners disagree, most in %2</source>
        <translation>모서리의 %1가 맞지 않음, 주로 %2</translation>
    </message>
</context>
<context>
    <name>calibration.done</name>
    <message>
        <source>done</source>
        <translation>완료</translation>
    </message>
</context>
<context>
    <name>calibration.edges_wide</name>
    <message>
        <source>its edges are %1 pixels wide</source>
        <translation>가장자리의 폭이 %1픽셀입니다</translation>
    </message>
</context>
<context>
    <name>calibration.ends_on_one_pixel</name>
    <message>
        <source>both ends are on the same pixel of camera &apos;%1&apos;</source>
        <translation>두 끝이 카메라 &apos;%1&apos;의 같은 픽셀에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.far_edge</name>
    <message>
        <source>at the far edge</source>
        <translation>먼 쪽 가장자리</translation>
    </message>
</context>
<context>
    <name>calibration.far_left_corner</name>
    <message>
        <source>in the far left corner</source>
        <translation>먼 쪽 왼쪽 모서리</translation>
    </message>
</context>
<context>
    <name>calibration.far_right_corner</name>
    <message>
        <source>in the far right corner</source>
        <translation>먼 쪽 오른쪽 모서리</translation>
    </message>
</context>
<context>
    <name>calibration.few_corners_seen</name>
    <message>
        <source>only %1 corners of the board are visible</source>
        <translation>보드의 모서리가 %1개만 보입니다</translation>
    </message>
</context>
<context>
    <name>calibration.fifth_would</name>
    <message>
        <source>add a fifth.</source>
        <translation>다섯 번째가 있으면 됩니다.</translation>
    </message>
</context>
<context>
    <name>calibration.find_board_again</name>
    <message>
        <source>detect the board in it again</source>
        <translation>그 사진에서 보드를 다시 찾게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.first_end_beyond</name>
    <message>
        <source>the first end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>첫 번째 끝이 카메라 &apos;%1&apos;의 지평선이나 그 너머에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye</name>
    <message>
        <source>fisheye</source>
        <translation>어안</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye_lens</name>
    <message>
        <source>Fisheye lens</source>
        <translation>어안 렌즈</translation>
    </message>
</context>
<context>
    <name>calibration.fit_only_to</name>
    <message>
        <source>the markers fit only to %1</source>
        <translation>마커가 %1까지만 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.fits_without</name>
    <message>
        <source>without %1 the others fit to %2: check its position and its pixel</source>
        <translation>%1 없이는 나머지가 %2까지 맞습니다. 그 위치와 픽셀을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.fitting_lens</name>
    <message>
        <source>fitting the lens model to %1 images</source>
        <translation>사진 %1장에 렌즈를 맞추는 중</translation>
    </message>
</context>
<context>
    <name>calibration.flip_image</name>
    <message>
        <source>switch off mirroring in the camera or its program, or flip the file</source>
        <translation>카메라나 그 프로그램의 좌우 반전을 끄거나 파일을 뒤집으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.floor_may_be_mirrored</name>
    <message>
        <source>if it is not, v is counted from below, and the labels are mirrored.</source>
        <translation>아니라면 v를 아래에서부터 세었고 레이블이 좌우로 뒤집혀 있습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_not_registered</name>
    <message>
        <source>the floor cannot be registered</source>
        <translation>바닥에 정합할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.floor_part_unseen</name>
    <message>
        <source>%1 of the floor between the markers is out of view.</source>
        <translation>마커 사이 바닥의 %1가 보이지 않습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unseen</name>
    <message>
        <source>None of the floor between the markers is in view.</source>
        <translation>마커 사이 바닥이 전혀 보이지 않습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unsure</name>
    <message>
        <source>the floor uncertainty between the points is too large, ±%1</source>
        <translation>점 사이의 바닥이 ±%1로만 알려집니다</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_groups</name>
    <message>
        <source>%1 give about %2, %3 (such as %4) give about %5</source>
        <translation>%1장은 약 %2, %3장(예: %4)은 약 %5</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_unsure</name>
    <message>
        <source>the images determine the focal length only to %1</source>
        <translation>사진들로는 초점 거리가 %1까지만 정해집니다</translation>
    </message>
</context>
<context>
    <name>calibration.focal_lengths_differ</name>
    <message>
        <source>The focal lengths across and down differ by %1</source>
        <translation>가로와 세로 초점 거리가 %1 다릅니다</translation>
    </message>
</context>
<context>
    <name>calibration.focus_or_light</name>
    <message>
        <source>focus the camera, or give more light</source>
        <translation>카메라의 초점을 맞추거나 더 밝게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_as_well</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model no better (%3)</source>
        <translation>빼 둔 사진을 %1로 예측, %2 모델도 더 낫지 않음 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_better</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model only to %3</source>
        <translation>빼 둔 사진을 %1로 예측, %2 모델은 %3에 그침</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_by_chance</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model to %3; the difference may be chance</source>
        <translation>빼 둔 사진을 %1로 예측, %2 모델은 %3로 예측하나 우연일 수 있음</translation>
    </message>
</context>
<context>
    <name>calibration.four_common_markers</name>
    <message>
        <source>the layout and the image must have four markers in common</source>
        <translation>배치와 영상에 공통인 마커 네 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.four_markers_unchecked</name>
    <message>
        <source>Four markers are too few to check each other</source>
        <translation>마커 네 개로는 서로를 거의 검증하지 못합니다</translation>
    </message>
</context>
<context>
    <name>calibration.four_points_unchecked</name>
    <message>
        <source>Four points are too few to check each other</source>
        <translation>점 네 개로는 서로를 거의 검증하지 못합니다</translation>
    </message>
</context>
<context>
    <name>calibration.four_shared_points</name>
    <message>
        <source>both cameras must see the same four points or more</source>
        <translation>두 카메라가 모두 보는 점 네 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.give_board_size</name>
    <message>
        <source>give at least 3x3, such as 9x6, or leave the size out</source>
        <translation>9x6처럼 3x3 이상으로 하거나 크기를 비워 두십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_distance</name>
    <message>
        <source>give a distance of 0 m to 1000 m</source>
        <translation>거리를 0 m에서 1000 m 사이로 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_field_of_view</name>
    <message>
        <source>give 2° to 150°, and the image size</source>
        <translation>2°에서 150° 사이로 주고, 영상의 크기도 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_height</name>
    <message>
        <source>give a height of 0.05 m to 100 m</source>
        <translation>높이를 0.05 m에서 100 m 사이로 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_one_of_them</name>
    <message>
        <source>give one of them</source>
        <translation>그중 하나를 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_plain_numbers</name>
    <message>
        <source>give plain numbers</source>
        <translation>보통의 수를 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_positive_number</name>
    <message>
        <source>give a number above 0</source>
        <translation>0보다 큰 수를 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_square_size</name>
    <message>
        <source>give a size such as 25mm</source>
        <translation>25mm처럼 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_tape_sigma</name>
    <message>
        <source>give about 2 mm</source>
        <translation>약 2 mm로 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.give_taped_length</name>
    <message>
        <source>enter the length measured with a tape</source>
        <translation>줄자로 잰 길이를 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board</name>
    <message>
        <source>glue the board onto something stiff</source>
        <translation>보드를 단단한 것에 붙이십시오</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board_flat</name>
    <message>
        <source>glue the board onto something stiff and flat</source>
        <translation>보드를 단단하고 평평한 것에 붙이십시오</translation>
    </message>
</context>
<context>
    <name>calibration.good</name>
    <message>
        <source>Good: %1.</source>
        <translation>양호: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.grows_beyond</name>
    <message>
        <source>Beyond the markers it grows, to ±%1 within %2 of them.</source>
        <translation>마커 바깥에서는 커져서 %2 이내에서 ±%1에 이릅니다.</translation>
    </message>
</context>
<context>
    <name>calibration.halves_contradict</name>
    <message>
        <source>two halves of the images give focal lengths that differ by %1</source>
        <translation>사진을 둘로 나누면 초점 거리가 %1 다릅니다</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell</name>
    <message>
        <source>each half of the images predicts the other to %1</source>
        <translation>절반이 다른 절반을 %1로 예측</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell_apart</name>
    <message>
        <source>each half of the images predicts the other to %1, at most %2 apart on that floor</source>
        <translation>절반이 다른 절반을 %1로 예측, 그 바닥에서 최대 %2 차이</translation>
    </message>
</context>
<context>
    <name>calibration.held_out_markers</name>
    <message>
        <source>Markers that are left out one by one are predicted to %1 RMS.</source>
        <translation>하나씩 뺀 마커는 %1 RMS로 예측됩니다.</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_closer</name>
    <message>
        <source>hold it closer to the camera</source>
        <translation>카메라에 더 가까이 대십시오</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_still</name>
    <message>
        <source>hold it still, and focus the camera</source>
        <translation>움직이지 않게 들고 카메라의 초점을 맞추십시오</translation>
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
        <translation>이 이미지들을 잘라냈다면 동영상도 똑같이 잘라야 합니다</translation>
    </message>
</context>
<context>
    <name>calibration.image_mirrored</name>
    <message>
        <source>mirrored left to right they fit to %1: is the image mirrored?</source>
        <translation>좌우로 뒤집으면 %1까지 맞습니다. 이미지가 좌우로 뒤집혔습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.image_repeats</name>
    <message>
        <source>1 of %1 images shows the board in the same position as another one, and each position counts once</source>
        <translation>사진 %1장 중 1장은 보드가 다른 사진과 같은 위치에 있으며, 각 위치는 한 번만 계산됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out</name>
    <message>
        <source>Left out: %1.</source>
        <translation>제외됨: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out_among</name>
    <message>
        <source>%1 images were left out, among them %2.</source>
        <translation>이미지 %1개가 제외되었습니다. 그중 일부: %2.</translation>
    </message>
</context>
<context>
    <name>calibration.images_repeat</name>
    <message>
        <source>%1 of %2 images show the board in the same position as another one, and each position counts once</source>
        <translation>사진 %2장 중 %1장은 보드가 다른 사진과 같은 위치에 있으며, 각 위치는 한 번만 계산됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.inches</name>
    <message>
        <source>inches</source>
        <translation>인치</translation>
    </message>
</context>
<context>
    <name>calibration.inside</name>
    <message>
        <source>inside</source>
        <translation>안쪽</translation>
    </message>
</context>
<context>
    <name>calibration.inside_expected_error</name>
    <message>
        <source>within the limit of %1 (2.5 σ).</source>
        <translation>예상 오차 %1 이내.</translation>
    </message>
</context>
<context>
    <name>calibration.keep_board_clear</name>
    <message>
        <source>keep the board clear and well lit</source>
        <translation>보드를 가리지 말고 밝게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.keep_whole_board</name>
    <message>
        <source>keep the whole board in view</source>
        <translation>보드 전체가 영상에 들어오게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_marker</name>
    <message>
        <source>give each marker a label of its own</source>
        <translation>마커마다 다른 이름표를 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_point</name>
    <message>
        <source>give each point a label of its own</source>
        <translation>점마다 다른 이름표를 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.label_of_layout</name>
    <message>
        <source>label &apos;%1&apos; of the layout</source>
        <translation>배치의 이름표 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.labels_called</name>
    <message>
        <source>with %1 renamed %2 they fit to %3</source>
        <translation>%1을(를) %2(으)로 부르면 %3로 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.labels_exchanged</name>
    <message>
        <source>with %1 and %2 swapped they fit to %3</source>
        <translation>%1과(와) %2을(를) 바꾸면 %3로 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.lay_stick_nearer</name>
    <message>
        <source>put the stick on the floor, nearer to the camera</source>
        <translation>막대를 카메라에 더 가까운 바닥에 놓으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.layout_in_mm</name>
    <message>
        <source>it must be in mm</source>
        <translation>mm로 주어집니다</translation>
    </message>
</context>
<context>
    <name>calibration.layout_mirrored</name>
    <message>
        <source>with a reversed Y of the layout they fit to %1: check the signs of the layout, seen from above Y must point to the left of X</source>
        <translation>배치의 Y를 뒤집으면 %1까지 맞습니다. 배치의 부호를 확인하십시오. 위에서 볼 때 Y는 X의 왼쪽을 향해야 합니다</translation>
    </message>
</context>
<context>
    <name>calibration.layout_not_in_mm</name>
    <message>
        <source>if that is wrong, the layout is not in mm</source>
        <translation>틀렸다면 배치의 숫자가 mm가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.layout_too_small</name>
    <message>
        <source>the layout has %1 markers, four are needed</source>
        <translation>배치에 마커가 %1개 있고, 네 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.layout_written_mirrored</name>
    <message>
        <source>if the layout was written down mirrored, correct its signs and add it again</source>
        <translation>배치를 거울상으로 적었다면 부호를 고쳐 새로 추가하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.leave_one_tag</name>
    <message>
        <source>leave one of them on the floor</source>
        <translation>하나만 바닥에 남기십시오</translation>
    </message>
</context>
<context>
    <name>calibration.leave_out_pictures</name>
    <message>
        <source>leave out these images if the board is bent, cut or covered there.</source>
        <translation>그 사진에서 보드가 휘었거나 잘렸거나 가려졌다면 빼십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.left_edge</name>
    <message>
        <source>at the left edge</source>
        <translation>왼쪽 가장자리</translation>
    </message>
</context>
<context>
    <name>calibration.length_factor</name>
    <message>
        <source>a length factor of %1 is not possible</source>
        <translation>길이 배율 %1로는 바닥을 만들 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.length_is</name>
    <message>
        <source>The length is %1 ± %2.</source>
        <translation>길이는 %1 ± %2입니다.</translation>
    </message>
</context>
<context>
    <name>calibration.length_longer</name>
    <message>
        <source>It is %1 longer than the %2 entered</source>
        <translation>알려 준 %2보다 %1 깁니다</translation>
    </message>
</context>
<context>
    <name>calibration.length_shorter</name>
    <message>
        <source>It is %1 shorter than the %2 entered</source>
        <translation>알려 준 %2보다 %1 짧습니다</translation>
    </message>
</context>
<context>
    <name>calibration.length_unmeasured</name>
    <message>
        <source>the length cannot be measured</source>
        <translation>길이를 잴 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.length_unseen</name>
    <message>
        <source>no camera shows it</source>
        <translation>그것을 보는 카메라가 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>calibration.lens_assumed</name>
    <message>
        <source>The lens is not calibrated, and the markers hardly determine it (focal length %1 ± %2): what is not known of it is in the uncertainty.</source>
        <translation>렌즈가 보정되지 않았고 마커로는 거의 결정되지 않습니다(초점 거리 %1 ± %2): 알 수 없는 부분은 불확도에 들어 있습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_from_floor</name>
    <message>
        <source>The lens is not calibrated: focal length (%1 ± %2) and distortion (k1 %3 ± %4) were estimated from the markers.</source>
        <translation>렌즈가 보정되지 않았습니다: 초점 거리(%1 ± %2)와 왜곡(k1 %3 ± %4)을 마커에서 추정했습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_of_other_camera</name>
    <message>
        <source>with the lens calibration of camera &apos;%1&apos; they fit to %2: are the views swapped?</source>
        <translation>카메라 &apos;%1&apos;의 렌즈 보정으로는 %2까지 맞습니다. 시점이 바뀌었습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.lens_on_floor</name>
    <message>
        <source>±%1 in the middle and at most ±%2 (%3) on %4, from the lens calibration alone</source>
        <translation>렌즈만 고려할 때 %4에서 가운데 ±%1, 최악 ±%2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.lens_told</name>
    <message>
        <source>as specified</source>
        <translation>지정됨</translation>
    </message>
</context>
<context>
    <name>calibration.lens_unknown_elsewhere</name>
    <message>
        <source>the distortion elsewhere stays unknown</source>
        <translation>다른 곳의 렌즈 왜곡은 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.likely_unit</name>
    <message>
        <source>its numbers look like %1, with the camera %2 above the floor</source>
        <translation>수가 %1처럼 보이며, 그러면 바닥 위 %2에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.longer</name>
    <message>
        <source>longer</source>
        <translation>더 깁니다</translation>
    </message>
</context>
<context>
    <name>calibration.look_at</name>
    <message>
        <source>Check %1</source>
        <translation>%1을(를) 보십시오</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_ends</name>
    <message>
        <source>check that the same ends are marked in each image; if they are, register it again.</source>
        <translation>각 영상에 같은 끝이 표시되었는지 보고, 그렇다면 다시 정합하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_pictures</name>
    <message>
        <source>check these images and leave out those that are blurred, bent or of another board.</source>
        <translation>이 사진들을 보고 흐리거나 휘었거나 다른 보드의 것은 빼십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.looking_about</name>
    <message>
        <source>searching around the best position</source>
        <translation>가장 좋은 위치의 둘레를 찾는 중</translation>
    </message>
</context>
<context>
    <name>calibration.make_larger_layout</name>
    <message>
        <source>make a layout of four markers or more</source>
        <translation>마커가 네 개 이상인 배치를 만드십시오</translation>
    </message>
</context>
<context>
    <name>calibration.mark_ends_in_one</name>
    <message>
        <source>mark its ends in at least one image</source>
        <translation>적어도 한 영상에 두 끝을 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.mark_more</name>
    <message>
        <source>mark more of the layout&apos;s markers, by their names in the layout</source>
        <translation>배치의 마커를 배치의 이름으로 더 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.mark_there_again</name>
    <message>
        <source>mark it again in that view.</source>
        <translation>거기서 다시 표시하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.mark_two_ends</name>
    <message>
        <source>mark each end at its own position in the image</source>
        <translation>두 끝을 보이는 곳에 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.mark_where_seen</name>
    <message>
        <source>mark each of them at its own position in the image</source>
        <translation>각각 보이는 곳에 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.marker_against_lens</name>
    <message>
        <source>this camera&apos;s lens model cannot project %1</source>
        <translation>%1이(가) 이 카메라의 렌즈로는 나올 수 없는 곳에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.marker_beyond_horizon</name>
    <message>
        <source>marker %1 would be at or beyond the horizon</source>
        <translation>마커 %1이(가) 지평선이나 그 너머에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.marker_moved</name>
    <message>
        <source>Marker %1 has moved %2 = %3, %4 has not</source>
        <translation>마커 %1이(가) %2 = %3 움직였고 %4은(는) 그대로입니다</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_all</name>
    <message>
        <source>%1 is %2 off in all cameras</source>
        <translation>모든 카메라에서 %1이(가) %2 어긋남</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_one</name>
    <message>
        <source>%1 is %2 off in the one camera that sees it</source>
        <translation>%1을(를) 보는 카메라 한 대에서 %2 어긋남</translation>
    </message>
</context>
<context>
    <name>calibration.marker_pixel_no_number</name>
    <message>
        <source>the pixel of marker %1 is not a finite number</source>
        <translation>마커 %1의 픽셀이 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.marker_place_no_number</name>
    <message>
        <source>the position of marker %1 is not a finite number</source>
        <translation>마커 %1의 위치가 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_layout</name>
    <message>
        <source>marker %1 appears twice in the layout</source>
        <translation>마커 %1이(가) 배치에 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_picture</name>
    <message>
        <source>marker %1 appears twice in the image</source>
        <translation>마커 %1이(가) 영상에 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_at_one_place</name>
    <message>
        <source>markers %1 and %2 have the same floor position</source>
        <translation>마커 %1과(와) %2이(가) 바닥의 같은 곳에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit</name>
    <message>
        <source>%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5</source>
        <translation>마커 %1개가 %2 RMS로 맞으며(최악 %3, %4), 그 사이 바닥은 ±%5로 알려짐</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_many_ways</name>
    <message>
        <source>they fit the layout equally well in %1 ways, because it looks the same from several sides</source>
        <translation>여러 방향에서 같아 보이는 배치라 %1가지로 똑같이 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_together</name>
    <message>
        <source>registered jointly with %1: %2 markers fit to %3 RMS; floor uncertainty ±%4</source>
        <translation>%1과(와) 함께 마커 %2개가 %3 RMS로 맞으며, 그 사이 바닥은 ±%4로 알려짐</translation>
    </message>
</context>
<context>
    <name>calibration.markers_found</name>
    <message>
        <source>%1 of %2 were found, four are needed</source>
        <translation>%2개 중 %1개를 찾았고 네 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_in_place</name>
    <message>
        <source>%1 markers are within %2 = %3 of their positions.</source>
        <translation>마커 %1개가 제자리에서 %2 = %3 이내.</translation>
    </message>
</context>
<context>
    <name>calibration.markers_mirrored</name>
    <message>
        <source>the markers are mirrored</source>
        <translation>마커가 거울상입니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_missing</name>
    <message>
        <source>missing: %1</source>
        <translation>없는 것: %1</translation>
    </message>
</context>
<context>
    <name>calibration.markers_moved</name>
    <message>
        <source>Markers %1 have moved %2 = %3, %4 has not</source>
        <translation>마커 %1이(가) %2 = %3 움직였고 %4은(는) 그대로입니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_nearly_on_line</name>
    <message>
        <source>the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2</source>
        <translation>마커가 거의 한 줄에 있어(특히 %1) 바닥이 ±%2로만 알려집니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_found</name>
    <message>
        <source>the floor markers cannot be found</source>
        <translation>바닥의 마커를 찾을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_told_apart</name>
    <message>
        <source>the markers cannot be distinguished</source>
        <translation>마커를 구별할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_on_one_pixel</name>
    <message>
        <source>markers %1 and %2 are on the same pixel</source>
        <translation>마커 %1과(와) %2이(가) 같은 픽셀에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_read</name>
    <message>
        <source>%1 of its markers could be read</source>
        <translation>마커 %1개를 읽었습니다</translation>
    </message>
</context>
<context>
    <name>calibration.markers_too_close</name>
    <message>
        <source>markers %1 and %2 are only %3 apart, too close for two of four</source>
        <translation>마커 %1과(와) %2의 간격이 %3뿐이라 넷 중 둘로는 너무 가깝습니다</translation>
    </message>
</context>
<context>
    <name>calibration.measure_again</name>
    <message>
        <source>mark and remeasure them, or add another</source>
        <translation>다시 표시하고 재거나 하나를 더 추가하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.measure_it_again</name>
    <message>
        <source>remeasure it.</source>
        <translation>다시 재십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.measure_or_mark_again</name>
    <message>
        <source>measure it, or mark it in the image, again.</source>
        <translation>다시 재거나 영상에서 다시 표시하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.metres</name>
    <message>
        <source>metres</source>
        <translation>미터</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_corner</name>
    <message>
        <source>±%1 in the middle, ±%2 in the corner near %3.</source>
        <translation>가운데 ±%1, %3 근처 모서리 ±%2.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_edge</name>
    <message>
        <source>±%1 in the middle, ±%2 at the edge near %3.</source>
        <translation>가운데 ±%1, %3 근처 가장자리 ±%2.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_near</name>
    <message>
        <source>±%1 in the middle, ±%2 near %3.</source>
        <translation>가운데 ±%1, %3 근처 ±%2.</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_most_at</name>
    <message>
        <source>%1 RMS, most at %2 (%3)</source>
        <translation>%1 RMS, %2에서 가장 큼 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_unexplained</name>
    <message>
        <source>the %1 markers misfit by %2 (%3), and are too few to identify the wrong one</source>
        <translation>마커 %1개가 %2 (%3) 어긋나며 서로 검증이 부족해 어느 것인지 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.more_pairs</name>
    <message>
        <source>take more pairs, or register %1 better first</source>
        <translation>더 많은 쌍을 찍거나 먼저 %1을(를) 더 잘 정합하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.more_pictures</name>
    <message>
        <source>More images (%1 or more) would make it more certain.</source>
        <translation>사진이 더 있으면(%1장 이상) 더 확실해집니다.</translation>
    </message>
</context>
<context>
    <name>calibration.move_back</name>
    <message>
        <source>%1 away from the floor</source>
        <translation>바닥에서 멀어지는 쪽으로 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_board</name>
    <message>
        <source>move it elsewhere, turn it or tilt it</source>
        <translation>다른 곳으로 옮기거나 돌리거나 기울이십시오</translation>
    </message>
</context>
<context>
    <name>calibration.move_closer</name>
    <message>
        <source>%1 closer to the floor&apos;s middle</source>
        <translation>바닥 중앙 쪽으로 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_down</name>
    <message>
        <source>%1 down</source>
        <translation>아래로 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_helps</name>
    <message>
        <source>Moving %1 by %2, aimed at the middle of the floor, lowers the error from ±%3 to ±%4 where it is largest.</source>
        <translation>%1을(를) %2 옮기고 바닥 중앙을 향하게 하면 오차가 가장 큰 곳에서 ±%3에서 ±%4(으)로 줄어듭니다.</translation>
    </message>
</context>
<context>
    <name>calibration.move_left</name>
    <message>
        <source>%1 to the left</source>
        <translation>왼쪽으로 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_planned_back</name>
    <message>
        <source>move it back or up, or choose a wider lens</source>
        <translation>뒤로 또는 위로 옮기거나 더 넓은 렌즈를 고르십시오</translation>
    </message>
</context>
<context>
    <name>calibration.move_right</name>
    <message>
        <source>%1 to the right</source>
        <translation>오른쪽으로 %1</translation>
    </message>
</context>
<context>
    <name>calibration.move_up</name>
    <message>
        <source>%1 up</source>
        <translation>위로 %1</translation>
    </message>
</context>
<context>
    <name>calibration.name_dictionary</name>
    <message>
        <source>name one like DICT_6X6_250, or leave it out</source>
        <translation>DICT_6X6_250처럼 지정하거나 비워 두십시오</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_camera</name>
    <message>
        <source>name each camera once</source>
        <translation>각 카메라를 한 번씩만 지정하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_marker</name>
    <message>
        <source>give each marker a name of its own</source>
        <translation>마커마다 다른 이름을 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.name_one_marker</name>
    <message>
        <source>name one of %1</source>
        <translation>%1 중 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.name_tag_family</name>
    <message>
        <source>write the family into the labels, such as 36h11:7, or mark a marker by hand</source>
        <translation>이름표에 종류를 적거나(예: 36h11:7) 마커 하나를 손으로 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.name_two_apart</name>
    <message>
        <source>name two at different positions</source>
        <translation>떨어져 있는 둘을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.near_edge</name>
    <message>
        <source>at the near edge</source>
        <translation>가까운 쪽 가장자리</translation>
    </message>
</context>
<context>
    <name>calibration.near_left_corner</name>
    <message>
        <source>in the near left corner</source>
        <translation>가까운 쪽 왼쪽 모서리</translation>
    </message>
</context>
<context>
    <name>calibration.near_right_corner</name>
    <message>
        <source>in the near right corner</source>
        <translation>가까운 쪽 오른쪽 모서리</translation>
    </message>
</context>
<context>
    <name>calibration.no_board_found</name>
    <message>
        <source>no board found</source>
        <translation>보드를 찾지 못했습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco</name>
    <message>
        <source>the detected markers do not match a ChArUco board</source>
        <translation>읽은 마커가 ChArUco 보드처럼 놓여 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco_of_size</name>
    <message>
        <source>the detected markers do not match a ChArUco board of %1 inner corners</source>
        <translation>읽은 마커가 내부 모서리 %1의 ChArUco 보드처럼 놓여 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_common_marker</name>
    <message>
        <source>no two of the cameras see the same marker</source>
        <translation>같은 마커를 보는 카메라가 두 대도 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_dictionary</name>
    <message>
        <source>marker dictionary %1 does not exist</source>
        <translation>마커 사전 %1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_flat_floor</name>
    <message>
        <source>the markers do not fit a flat floor</source>
        <translation>마커가 평평한 바닥에 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_lens_fits</name>
    <message>
        <source>no lens model fits these images</source>
        <translation>이 사진들에 맞는 렌즈가 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_millimetres</name>
    <message>
        <source>no value in millimetres: this calibration holds for only part of the image</source>
        <translation>이 렌즈 모델은 영상의 일부에만 유효하므로 밀리미터 값 없음</translation>
    </message>
</context>
<context>
    <name>calibration.no_other_lens</name>
    <message>
        <source>no other model fits</source>
        <translation>맞는 다른 모델 없음</translation>
    </message>
</context>
<context>
    <name>calibration.no_pair_has_board</name>
    <message>
        <source>none of %1 pairs can be used</source>
        <translation>쌍 %1개 중 쓸 수 있는 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_pose</name>
    <message>
        <source>no pose</source>
        <translation>자세를 구할 수 없음</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_corner</name>
    <message>
        <source>the corners of a tag are tl, tr, br and bl</source>
        <translation>태그의 모서리는 tl, tr, br, bl입니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_marker</name>
    <message>
        <source>it has no marker %1</source>
        <translation>마커 %1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_tag</name>
    <message>
        <source>%1 has no tag %2</source>
        <translation>%1에는 태그 %2이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.no_tag_number</name>
    <message>
        <source>&apos;%1&apos; is not the number of a tag</source>
        <translation>&apos;%1&apos;은(는) 태그 번호가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.none_sees_four_markers</name>
    <message>
        <source>no camera sees four markers of the layout</source>
        <translation>배치의 마커 네 개를 보는 카메라가 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.not_all_foretold</name>
    <message>
        <source>not all</source>
        <translation>일부 불가</translation>
    </message>
</context>
<context>
    <name>calibration.not_found_again</name>
    <message>
        <source>Not found again: %1.</source>
        <translation>다시 찾지 못함: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_by_pair</name>
    <message>
        <source>the camera cannot be registered by the pair</source>
        <translation>쌍으로 카메라를 정합할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_through</name>
    <message>
        <source>the camera cannot be registered via another camera</source>
        <translation>다른 카메라를 통해 정합할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_together</name>
    <message>
        <source>the cameras cannot be registered jointly</source>
        <translation>카메라를 함께 정합할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.of_other_camera</name>
    <message>
        <source>it is of another camera, zoom or focus</source>
        <translation>다른 카메라, 줌 또는 초점의 이미지입니다</translation>
    </message>
</context>
<context>
    <name>calibration.other_focal_length</name>
    <message>
        <source>it gives a focal length of %1, the other images %2</source>
        <translation>초점 거리가 %1이며, 다른 이미지는 %2입니다</translation>
    </message>
</context>
<context>
    <name>calibration.other_picking_size</name>
    <message>
        <source>at %1 they fit to %2: were they picked at that size?</source>
        <translation>%1에서는 %2까지 맞습니다. 그 크기에서 표시했습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.other_picture_size</name>
    <message>
        <source>it is %1×%2, the other images are %3×%4</source>
        <translation>%1×%2인데 다른 사진은 %3×%4입니다</translation>
    </message>
</context>
<context>
    <name>calibration.other_zoom</name>
    <message>
        <source>with a focal length of %1 instead of %2 they fit to %3: has the zoom or the lens changed?</source>
        <translation>초점 거리가 %2이(가) 아니라 %1이면 %3까지 맞습니다. 줌이나 렌즈가 바뀌었습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.others_undetermined</name>
    <message>
        <source>the images do not determine any other model</source>
        <translation>이미지로는 다른 모델을 결정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.outside_expected_error</name>
    <message>
        <source>beyond the limit of %1 (2.5 σ).</source>
        <translation>예상 오차 %1 초과.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_contradicts</name>
    <message>
        <source>it contradicts the other pairs by %1 RMS</source>
        <translation>다른 쌍들과 %1 RMS만큼 모순됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_fits</name>
    <message>
        <source>the cameras are %1 apart (±%2) by %3 pairs, whose corners fit to %4 RMS</source>
        <translation>카메라 사이 거리는 %1(±%2)이며, 쌍 %3개의 꼭짓점이 %4 RMS로 맞음</translation>
    </message>
</context>
<context>
    <name>calibration.pair_floor_unsure</name>
    <message>
        <source>the floor uncertainty would be ±%1</source>
        <translation>바닥의 불확도가 ±%1이 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_is_one_image</name>
    <message>
        <source>both are the same image</source>
        <translation>둘이 같은 영상입니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lacks_board</name>
    <message>
        <source>the board was not found in &apos;%1&apos;</source>
        <translation>&apos;%1&apos;에서 보드를 찾지 못했습니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lens_usual</name>
    <message>
        <source>A lens calibration has no stated uncertainty: a usual one was assumed.</source>
        <translation>한 렌즈 보정에 불확도가 없어 보통 값을 가정했습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_of_cameras</name>
    <message>
        <source>the relative position of the cameras</source>
        <translation>카메라들의 상대 위치</translation>
    </message>
</context>
<context>
    <name>calibration.pair_sees_no_floor</name>
    <message>
        <source>it would see hardly any floor</source>
        <translation>바닥이 거의 보이지 않게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_squares</name>
    <message>
        <source>Triangulated, the squares of the board are %1 (standard deviation %2).</source>
        <translation>삼각 측량한 보드의 정사각형은 %1입니다(표준 편차 %2).</translation>
    </message>
</context>
<context>
    <name>calibration.pair_swapped</name>
    <message>
        <source>the images of each camera fit the lens calibration of the other one (%1 instead of %2 RMS)</source>
        <translation>각 카메라의 영상이 다른 카메라의 렌즈 보정에 맞습니다(RMS %2 대신 %1)</translation>
    </message>
</context>
<context>
    <name>calibration.pair_turned</name>
    <message>
        <source>the board looks the same when turned by half, and %1 pairs fit both ways</source>
        <translation>보드는 180° 돌려도 같아 보이며, 쌍 %1개가 두 방식 모두에 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_undetermined</name>
    <message>
        <source>the board positions do not determine it</source>
        <translation>보드의 위치들로는 정해지지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.pair_without_pose</name>
    <message>
        <source>the corners in &apos;%1&apos; determine no pose</source>
        <translation>&apos;%1&apos;의 꼭짓점으로 자세를 정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_contradict</name>
    <message>
        <source>the pairs contradict each other (%1 RMS together, %2 in each image alone)</source>
        <translation>쌍들이 서로 모순됩니다(함께 %1 RMS, 영상마다 따로 %2)</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_left_out</name>
    <message>
        <source>%1 pairs were not used.</source>
        <translation>쌍 %1개는 사용하지 않았습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_scatter</name>
    <message>
        <source>The pairs agree less well than the corners would allow, which is in the uncertainty: the board moved between the two frames of a pair, or a lens calibration is less accurate than stated.</source>
        <translation>쌍들이 꼭짓점으로 기대되는 것보다 덜 일치하며, 이는 불확도에 포함되어 있습니다. 한 쌍의 두 영상 사이에 보드가 움직였거나 렌즈 보정이 표시된 것보다 부정확합니다.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_alike</name>
    <message>
        <source>Neighbouring markers err alike, by %1 RMS: check that the floor is flat, and calibrate the lens at the zoom and focus that it records with.</source>
        <translation>이웃한 마커들이 %1 RMS만큼 같은 쪽으로 어긋납니다: 바닥이 평평한지 확인하고, 녹화할 때의 줌과 초점으로 렌즈를 보정하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_layout</name>
    <message>
        <source>The residuals follow the layout: they disappear with X longer than Y by %1 % and the axes %2° off the right angle; measure both sides and both diagonals of the layout again.</source>
        <translation>잔차가 배치를 따릅니다: X가 Y보다 %1 % 길고 축이 직각에서 %2° 벗어나면 사라집니다. 배치의 두 변과 두 대각선을 다시 재십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_lens</name>
    <message>
        <source>The residuals follow the lens: %1 of them disappear with another focal length and distortion; calibrate the lens again, at the zoom and focus that it records with.</source>
        <translation>잔차가 렌즈를 따릅니다: 다른 초점 거리와 왜곡이면 %1이 사라집니다. 녹화할 때의 줌과 초점으로 렌즈를 다시 보정하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_marker</name>
    <message>
        <source>Marker %1 is %2 from where the others expect it: measure and mark it again.</source>
        <translation>마커 %1이(가) 다른 마커들이 예측하는 위치에서 %2 벗어나 있습니다: 다시 재고 표시하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_covered</name>
    <message>
        <source>The board covered only %1 of the image</source>
        <translation>영상의 %1만 덮였습니다</translation>
    </message>
</context>
<context>
    <name>calibration.picture_stands_out</name>
    <message>
        <source>its %1 is an outlier.</source>
        <translation>%1가 튑니다.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_too_small</name>
    <message>
        <source>the image is too small</source>
        <translation>영상이 너무 작습니다</translation>
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
        <translation>영상의 크기가 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4</source>
        <translation>사진 %1장이 %2로 피팅됨, 초점 거리 %3 ± %4</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit_halves_apart</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4, halves at most %5 apart on that floor</source>
        <translation>사진 %1장이 %2로 피팅됨, 초점 거리 %3 ± %4, 그 바닥에서 최대 %5 차이</translation>
    </message>
</context>
<context>
    <name>calibration.pixels_not_square</name>
    <message>
        <source>the camera&apos;s pixels are not square, or its images were rescaled</source>
        <translation>카메라의 픽셀이 정사각형이 아니거나 이미지 크기가 변경되었습니다</translation>
    </message>
</context>
<context>
    <name>calibration.place_left</name>
    <message>
        <source>left</source>
        <translation>왼쪽</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower</name>
    <message>
        <source>lower</source>
        <translation>아래쪽</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_left</name>
    <message>
        <source>lower left</source>
        <translation>왼쪽 아래</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_right</name>
    <message>
        <source>lower right</source>
        <translation>오른쪽 아래</translation>
    </message>
</context>
<context>
    <name>calibration.place_middle</name>
    <message>
        <source>middle</source>
        <translation>가운데</translation>
    </message>
</context>
<context>
    <name>calibration.place_right</name>
    <message>
        <source>right</source>
        <translation>오른쪽</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper</name>
    <message>
        <source>upper</source>
        <translation>위쪽</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_left</name>
    <message>
        <source>upper left</source>
        <translation>왼쪽 위</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_right</name>
    <message>
        <source>upper right</source>
        <translation>오른쪽 위</translation>
    </message>
</context>
<context>
    <name>calibration.planned_camera</name>
    <message>
        <source>the planned camera</source>
        <translation>계획한 카메라</translation>
    </message>
</context>
<context>
    <name>calibration.planned_distance</name>
    <message>
        <source>its distance cannot be %1</source>
        <translation>%1 떨어진 곳에는 둘 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.planned_field_of_view</name>
    <message>
        <source>its field of view is %1</source>
        <translation>화각이 %1입니다</translation>
    </message>
</context>
<context>
    <name>calibration.planned_height</name>
    <message>
        <source>its height above the floor cannot be %1</source>
        <translation>바닥 위 %1에는 둘 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.planned_not_held</name>
    <message>
        <source>the markers it would see do not determine its pose</source>
        <translation>보이게 될 마커들로는 카메라의 위치가 정해지지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.planned_sees_too_few</name>
    <message>
        <source>it would see only %1 of the layout&apos;s markers (%2), four are needed</source>
        <translation>그곳에서는 배치의 마커 중 %1개(%2)만 보이며, 네 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_against_lens</name>
    <message>
        <source>the lens model cannot project point %1</source>
        <translation>점 %1이(가) 렌즈로는 나올 수 없는 곳에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_horizon</name>
    <message>
        <source>point %1 would be at or beyond the horizon</source>
        <translation>점 %1이(가) 지평선이나 그 너머에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_through</name>
    <message>
        <source>point %1 is at or beyond the horizon of %2</source>
        <translation>점 %1이(가) %2의 지평선이나 그 너머에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_own</name>
    <message>
        <source>point %1 is outside the image of the camera to register (%2)</source>
        <translation>점 %1이(가) 정합할 카메라의 화면(%2) 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_through</name>
    <message>
        <source>point %1 is outside the image of %2 (%3)</source>
        <translation>점 %1이(가) %2의 화면(%3) 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_pixel_no_number</name>
    <message>
        <source>the pixel of point %1 is not a finite number</source>
        <translation>점 %1의 픽셀이 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>calibration.point_twice</name>
    <message>
        <source>point %1 appears twice</source>
        <translation>점 %1이(가) 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.points_fit</name>
    <message>
        <source>via %1, %2 floor points fit to %3 RMS (worst %4, %5); floor uncertainty ±%6, of which %8 contributes ±%7</source>
        <translation>%1을(를) 통해 바닥의 점 %2개가 %3 RMS로 맞으며(최악 %4, %5), 그 사이 바닥은 ±%6로 알려짐, 그중 ±%7는 %8에서 옴</translation>
    </message>
</context>
<context>
    <name>calibration.points_mirrored</name>
    <message>
        <source>the points are mirrored between the images of the two cameras</source>
        <translation>두 카메라의 영상 사이에서 점들이 거울상입니다</translation>
    </message>
</context>
<context>
    <name>calibration.points_on_one_pixel</name>
    <message>
        <source>points %1 and %2 are on the same pixel</source>
        <translation>점 %1과(와) %2이(가) 같은 픽셀에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.points_undetermined</name>
    <message>
        <source>the points do not determine the camera position</source>
        <translation>점들로 카메라의 위치를 정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.poor</name>
    <message>
        <source>Poor: %1.</source>
        <translation>불량: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.poor_measure_again</name>
    <message>
        <source>Poor, measure the markers again: %1.</source>
        <translation>불량, 마커를 다시 재십시오: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_bent</name>
    <message>
        <source>The board is not flat, it bulges by %1: glue it onto something stiff.</source>
        <translation>보드가 평평하지 않고 %1 휘어 있습니다: 단단한 판에 붙이세요.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_stretched</name>
    <message>
        <source>The print&apos;s squares are %1 %2 from row to row than from column to column: measure the squares in both directions.</source>
        <translation>인쇄된 칸은 열 방향보다 행 방향이 %1 %2: 두 방향으로 칸을 재세요.</translation>
    </message>
</context>
<context>
    <name>calibration.print_may_be_stretched</name>
    <message>
        <source>measure the squares of the print in both directions, for it may be stretched, and take images with the board turned by 90 degrees</source>
        <translation>인쇄물이 늘어났을 수 있으므로 두 방향으로 칸을 재고, 보드를 90도 돌린 이미지도 찍으세요</translation>
    </message>
</context>
<context>
    <name>calibration.print_was_heeded</name>
    <message>
        <source>The calibration allows for this.</source>
        <translation>보정에 이를 반영했습니다.</translation>
    </message>
</context>
<context>
    <name>calibration.put_marker_back</name>
    <message>
        <source>move it back, or measure the markers again and register all cameras.</source>
        <translation>제자리에 놓거나, 다시 재어 모든 카메라를 정합하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.put_markers_back</name>
    <message>
        <source>move them back, or measure the markers again and register all cameras.</source>
        <translation>모두 제자리에 놓거나, 다시 재어 모든 카메라를 정합하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.quarter_turn</name>
    <message>
        <source>turned by a quarter they fit to %1: was the image shown turned?</source>
        <translation>90도 돌리면 %1까지 맞습니다. 이미지가 회전되어 표시되었습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.rational</name>
    <message>
        <source>rational</source>
        <translation>유리식</translation>
    </message>
</context>
<context>
    <name>calibration.rational_lens</name>
    <message>
        <source>Rational lens</source>
        <translation>유리식 렌즈</translation>
    </message>
</context>
<context>
    <name>calibration.register_before_recording</name>
    <message>
        <source>register it again before you record.</source>
        <translation>녹화 전에 다시 정합하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_four</name>
    <message>
        <source>register the cameras by four markers or more</source>
        <translation>마커 네 개 이상으로 카메라를 정합하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_more</name>
    <message>
        <source>register it with more of them first</source>
        <translation>먼저 더 많은 마커로 정합하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.register_if_gone</name>
    <message>
        <source>if they are gone or the camera points elsewhere, register it again</source>
        <translation>마커가 없거나 카메라가 다른 곳을 보면 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.register_one_by_one</name>
    <message>
        <source>first register the cameras one by one with this layout</source>
        <translation>먼저 이 배치로 카메라를 하나씩 정합하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.related_to</name>
    <message>
        <source>via %1 and a board that both see; floor uncertainty ±%2</source>
        <translation>%1과(와) 둘 다 보는 보드를 통해, 바닥의 불확도 ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.reverse_both</name>
    <message>
        <source>reverse both (a half turn), or turn the axes</source>
        <translation>둘 다 뒤집거나(반 바퀴) 축을 돌리십시오</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_x_alone</name>
    <message>
        <source>reversing X alone would mirror the floor; no camera above it sees it that way</source>
        <translation>X만 뒤집으면 바닥이 거울상이 되며 위의 카메라는 그렇게 보지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_y_alone</name>
    <message>
        <source>reversing Y alone would mirror the floor; no camera above it sees it that way</source>
        <translation>Y만 뒤집으면 바닥이 거울상이 되며 위의 카메라는 그렇게 보지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.right_edge</name>
    <message>
        <source>at the right edge</source>
        <translation>오른쪽 가장자리</translation>
    </message>
</context>
<context>
    <name>calibration.rings_mirrored</name>
    <message>
        <source>%1 rings and dots fit the layout, mirrored</source>
        <translation>고리와 점 %1개가 좌우로 뒤집히면 배치에 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.same_as_other_camera</name>
    <message>
        <source>Camera &apos;%1&apos; sees the markers at the same pixels (to %2): check that the views are not swapped.</source>
        <translation>카메라 &apos;%1&apos;이(가) 같은 픽셀(%2까지)에서 마커를 봅니다. 시점이 바뀌지 않았는지 확인하십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.same_attitude</name>
    <message>
        <source>all %1 images show the board at nearly the same tilt, too little to determine the focal length</source>
        <translation>사진 %1장 모두 보드의 자세가 거의 같아 초점 거리를 정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.same_tag_as</name>
    <message>
        <source>it names the same tag as &apos;%1&apos;</source>
        <translation>&apos;%1&apos;과(와) 같은 태그를 가리킵니다</translation>
    </message>
</context>
<context>
    <name>calibration.second_end_beyond</name>
    <message>
        <source>the second end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>두 번째 끝이 카메라 &apos;%1&apos;의 지평선이나 그 너머에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.see_same_floor</name>
    <message>
        <source>aim them at a common part of the floor</source>
        <translation>같은 바닥을 일부 함께 보게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.seen_by_other_camera</name>
    <message>
        <source>camera &apos;%1&apos; sees the markers there, to %2: are the views swapped?</source>
        <translation>카메라 &apos;%1&apos;이(가) %2까지 그 위치에서 마커를 봅니다. 시점이 바뀌었습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.sees_too_few_anywhere</name>
    <message>
        <source>at this height and field of view, no position within %1 of the markers shows four of them</source>
        <translation>주어진 높이와 렌즈로는 마커에서 %1 이내의 어디서도 마커 네 개가 보이지 않습니다</translation>
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
        <translation>고리와 점 %1개의 어떤 배정도 배치에 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.shared_points</name>
    <message>
        <source>%1 given</source>
        <translation>%1개뿐입니다</translation>
    </message>
</context>
<context>
    <name>calibration.shorter</name>
    <message>
        <source>shorter</source>
        <translation>더 짧습니다</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_larger</name>
    <message>
        <source>show the board larger, sharp and well lit</source>
        <translation>보드를 더 크고 선명하고 밝게 보여 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_to_both</name>
    <message>
        <source>show the whole board to both cameras at once, in ten positions or more</source>
        <translation>두 카메라에 동시에 보드 전체를 열 가지 이상의 위치에서 보여 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_everywhere</name>
    <message>
        <source>show the board in the middle and near each corner of the image, and closer</source>
        <translation>보드를 가운데와 각 모서리 가까이, 더 가깝게 보여 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_missing_tags</name>
    <message>
        <source>show the missing tags (AprilTag 36h11, numbered from 0 in the layout&apos;s order) or rings, or mark the markers by hand</source>
        <translation>없는 태그(AprilTag 36h11, 배치 순서로 0부터)나 고리를 보여 주거나 마커를 손으로 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_board</name>
    <message>
        <source>show more of the board</source>
        <translation>보드를 더 많이 보여 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_it</name>
    <message>
        <source>show more of it</source>
        <translation>더 많이 보이게 하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_shapes</name>
    <message>
        <source>show more of them, larger or in better light, or mark the markers by hand</source>
        <translation>더 많이, 더 크게 또는 더 밝게 보여 주거나 마커를 손으로 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_near_edges</name>
    <message>
        <source>show the board near its edges too.</source>
        <translation>가장자리 가까이에도 보드를 보여 주십시오.</translation>
    </message>
</context>
<context>
    <name>calibration.show_numbered_tags</name>
    <message>
        <source>show the missing tags (of one family, with the numbers of the labels) or rings, or mark the markers by hand</source>
        <translation>없는 태그(한 종류, 이름표의 번호)나 고리를 보여 주거나 마커를 손으로 표시하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_one_charuco</name>
    <message>
        <source>show one ChArUco board</source>
        <translation>ChArUco 보드 하나를 보여 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and well lit</source>
        <translation>보드 전체를 평평하고 선명하고 밝게 보여 주십시오</translation>
    </message>
</context>
<context>
    <name>calibration.spread_markers</name>
    <message>
        <source>spread the markers over the floor</source>
        <translation>마커를 바닥에 넓게 놓으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.spread_or_register_better</name>
    <message>
        <source>spread the points over the floor, or register %1 better first</source>
        <translation>점을 바닥에 넓게 잡거나 먼저 %1을(를) 더 잘 정합하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.spread_points</name>
    <message>
        <source>spread the points over the floor, not along a line</source>
        <translation>점을 한 줄이 아니라 바닥에 넓게 잡으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.spread_them</name>
    <message>
        <source>spread them over the floor</source>
        <translation>바닥에 넓게 놓으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.squares_without_size</name>
    <message>
        <source>the squares have no size</source>
        <translation>칸의 크기가 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.stand_higher</name>
    <message>
        <source>mount it higher or farther away, or choose a wider lens</source>
        <translation>더 높이 또는 더 멀리 두거나 더 넓은 렌즈를 고르십시오</translation>
    </message>
</context>
<context>
    <name>calibration.standard</name>
    <message>
        <source>standard</source>
        <translation>표준</translation>
    </message>
</context>
<context>
    <name>calibration.standard_lens</name>
    <message>
        <source>Standard lens</source>
        <translation>표준 렌즈</translation>
    </message>
</context>
<context>
    <name>calibration.swap_pair</name>
    <message>
        <source>swap the images of the two cameras</source>
        <translation>두 카메라의 영상을 서로 바꾸십시오</translation>
    </message>
</context>
<context>
    <name>calibration.tag_seen_often</name>
    <message>
        <source>tag %1 (marker %2) appears %3 times</source>
        <translation>태그 %1(마커 %2)이(가) %3번 보입니다</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_by_place_too</name>
    <message>
        <source>the tags fit the layout by the numbers in its labels and, numbered from 0, by its order</source>
        <translation>태그가 이름표의 번호로도, 0부터 매긴 배치 순서로도 배치에 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_nowhere</name>
    <message>
        <source>tags with the layout&apos;s numbers are there (%1), but not at its positions</source>
        <translation>배치의 번호를 가진 태그(%1)가 있지만 그 위치에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.tags_mirrored</name>
    <message>
        <source>%1 tags were found, mirrored</source>
        <translation>태그 %1개가 좌우로 뒤집힌 채 검출되었습니다</translation>
    </message>
</context>
<context>
    <name>calibration.tags_of_two_families</name>
    <message>
        <source>tags of two families, %1 and %2, fit the layout</source>
        <translation>두 종류의 태그 %1, %2이(가) 배치에 맞습니다</translation>
    </message>
</context>
<context>
    <name>calibration.take_at_same_moment</name>
    <message>
        <source>check that the files belong together in this order and were taken at the same moments, and that both lens calibrations belong to these cameras</source>
        <translation>파일들이 이 순서로 짝이 맞고 같은 순간에 찍혔는지, 두 렌즈 보정이 이 카메라들의 것인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.take_ten</name>
    <message>
        <source>take ten or more, the board tilted differently in each</source>
        <translation>보드를 매번 다르게 기울여 열 장 이상 찍으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.tape_sigma_not_positive</name>
    <message>
        <source>the σ of the tape measure is not above 0</source>
        <translation>줄자의 σ가 0보다 크지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.tell_by_hand</name>
    <message>
        <source>mark by hand which of them is %1</source>
        <translation>어느 것이 %1인지 손으로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>calibration.tenths_of_mm</name>
    <message>
        <source>tenths of a mm</source>
        <translation>1/10 mm</translation>
    </message>
</context>
<context>
    <name>calibration.thousandths_of_mm</name>
    <message>
        <source>thousandths of a mm</source>
        <translation>1/1000 mm</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_board</name>
    <message>
        <source>take images with the board tilted by 30 to 45 degrees, to each side</source>
        <translation>보드를 각 방향으로 30~45도 기울여 찍으십시오</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_less</name>
    <message>
        <source>tilt it by 30 to 45 degrees</source>
        <translation>30도에서 45도로 기울이십시오</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_or_charuco</name>
    <message>
        <source>show it in more positions with different tilts, or use a ChArUco board</source>
        <translation>더 많은 위치에서 다르게 기울여 보여 주거나 ChArUco 보드를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.told_board_too_small</name>
    <message>
        <source>a board of %1 inner corners is too small</source>
        <translation>내부 모서리 %1의 보드는 너무 작습니다</translation>
    </message>
</context>
<context>
    <name>calibration.told_length_not_positive</name>
    <message>
        <source>the entered length is not above 0</source>
        <translation>알려 준 길이가 0보다 크지 않습니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_corners</name>
    <message>
        <source>it has %1 corners of the board, six are needed</source>
        <translation>보드의 모서리가 %1개 있고, 여섯 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_found_again</name>
    <message>
        <source>%1 of its %2 markers were found again, two are needed</source>
        <translation>마커 %2개 중 %1개를 다시 찾았고 두 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_pictures</name>
    <message>
        <source>calibration needs three images of the board, %1 can be used</source>
        <translation>보드 사진 세 장이 필요한데 %1장만 쓸 수 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_shapes</name>
    <message>
        <source>%1 rings or dots were found, four are needed</source>
        <translation>고리나 점 %1개를 찾았고 네 개가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_to_compare</name>
    <message>
        <source>too few images to compare it with other models</source>
        <translation>다른 모델과 비교하기에는 사진이 너무 적습니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_frontal</name>
    <message>
        <source>the board faces the camera too directly</source>
        <translation>보드가 너무 정면으로 보입니다</translation>
    </message>
</context>
<context>
    <name>calibration.too_small_for_board</name>
    <message>
        <source>the image is too small for a board</source>
        <translation>영상이 너무 작아 보드가 들어갈 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.trying_positions</name>
    <message>
        <source>trying other positions of the cameras</source>
        <translation>다른 카메라 위치를 시험하는 중</translation>
    </message>
</context>
<context>
    <name>calibration.two_cameras_needed</name>
    <message>
        <source>layout &apos;%2&apos; has %1 registered camera, two are needed</source>
        <translation>배치 &apos;%2&apos;에 카메라가 %1대 있고 두 대가 필요합니다</translation>
    </message>
</context>
<context>
    <name>calibration.two_directions</name>
    <message>
        <source>both an angle and a pair of markers were given for X</source>
        <translation>X축에 각도와 마커 한 쌍이 함께 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>calibration.two_focal_lengths</name>
    <message>
        <source>the images do not agree on one focal length</source>
        <translation>사진들의 초점 거리가 두 가지입니다</translation>
    </message>
</context>
<context>
    <name>calibration.two_origins</name>
    <message>
        <source>both a marker and a point were given for the origin</source>
        <translation>원점에 마커와 점이 함께 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>calibration.typical_testbed</name>
    <message>
        <source>a %1 × %2 floor seen from %3 above</source>
        <translation>%3 높이에서 본 %1 × %2 바닥</translation>
    </message>
</context>
<context>
    <name>calibration.u_outside</name>
    <message>
        <source>u = %1 of marker %2 is outside the image of %3</source>
        <translation>마커 %2의 u = %1은(는) %3 이미지 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.u_v_swapped</name>
    <message>
        <source>with u and v swapped they fit to %1: are these columns swapped?</source>
        <translation>u와 v를 바꾸면 %1까지 맞습니다. 이 열들이 바뀌었습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.uncertain</name>
    <message>
        <source>Uncertain: %1.</source>
        <translation>의심스러움: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.unit</name>
    <message>
        <source>unit &apos;%1&apos;</source>
        <translation>단위 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.unit_unknown</name>
    <message>
        <source>it is not known</source>
        <translation>알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_corner</name>
    <message>
        <source>The middle is out of view, ±%1 in the corner near %2.</source>
        <translation>가운데가 보이지 않음, %2 근처 모서리 ±%1.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_edge</name>
    <message>
        <source>The middle is out of view, ±%1 at the edge near %2.</source>
        <translation>가운데가 보이지 않음, %2 근처 가장자리 ±%1.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_near</name>
    <message>
        <source>The middle is out of view, ±%1 near %2.</source>
        <translation>가운데가 보이지 않음, %2 근처 ±%1.</translation>
    </message>
</context>
<context>
    <name>calibration.usable</name>
    <message>
        <source>Usable: %1.</source>
        <translation>사용 가능: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_picture</name>
    <message>
        <source>use an image from the camera</source>
        <translation>카메라의 영상을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_pictures</name>
    <message>
        <source>use images from the camera</source>
        <translation>카메라의 영상을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.use_known_unit</name>
    <message>
        <source>use mm, cm, m or inch</source>
        <translation>mm, cm, m 또는 inch를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_camera</name>
    <message>
        <source>use images of one camera at one zoom and focus</source>
        <translation>한 카메라로 같은 줌과 초점에서 찍은 사진을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_resolution</name>
    <message>
        <source>use images of one camera at one resolution</source>
        <translation>한 카메라의 같은 해상도 사진을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.usual_lens</name>
    <message>
        <source>the images leave it open, so square pixels, an optical centre near the middle and a usual distortion were assumed</source>
        <translation>이미지만으로는 결정할 수 없어 정사각형 픽셀, 이미지 중심 근처의 광학 중심, 일반적인 왜곡을 가정했습니다</translation>
    </message>
</context>
<context>
    <name>calibration.v_from_below</name>
    <message>
        <source>v = %1 - v fits to %2: is v counted from below?</source>
        <translation>v = %1 - v이면 %2까지 맞습니다. v를 아래에서부터 셌습니까?</translation>
    </message>
</context>
<context>
    <name>calibration.v_outside</name>
    <message>
        <source>v = %1 of marker %2 is outside the image of %3</source>
        <translation>마커 %2의 v = %1은(는) %3 이미지 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.were_kept</name>
    <message>
        <source>they were kept</source>
        <translation>그대로 두었음</translation>
    </message>
</context>
<context>
    <name>calibration.whether_moved</name>
    <message>
        <source>cannot determine whether %1 has moved</source>
        <translation>%1이(가) 움직였는지 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_centre</name>
    <message>
        <source>Check %1: without it the optical centre moves by %2.</source>
        <translation>%1을(를) 확인하세요: 이 이미지를 빼면 광학 중심이 %2 이동합니다.</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_focal</name>
    <message>
        <source>Check %1: without it the focal length changes by %2.</source>
        <translation>%1을(를) 확인하세요: 이 이미지를 빼면 초점 거리가 %2 바뀝니다.</translation>
    </message>
</context>
<context>
    <name>calibration.write_tags_as</name>
    <message>
        <source>write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13</source>
        <translation>태그는 100 또는 36h11:100, 그 모서리는 100.tl, 두 태그의 중간은 12+13처럼 쓰십시오</translation>
    </message>
</context>
<context>
    <name>calibration.wrong_by_more</name>
    <message>
        <source>it may be wrong by much more</source>
        <translation>오차가 훨씬 클 수 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.x_without_length</name>
    <message>
        <source>the two markers for the X axis have the same position</source>
        <translation>X축이 지날 마커들이 같은 곳에 있습니다</translation>
    </message>
</context>
<context>
    <name>calibration.y_left_of_x</name>
    <message>
        <source>seen from above, Y must point to the left of X</source>
        <translation>위에서 볼 때 Y는 X의 왼쪽을 향해야 합니다</translation>
    </message>
</context>
<context>
    <name>capture.access_to_cameras</name>
    <message>
        <source>Access to cameras</source>
        <translation>카메라 접근</translation>
    </message>
</context>
<context>
    <name>capture.all_pictures_damaged</name>
    <message>
        <source>all its frames arrive damaged</source>
        <translation>모든 영상이 손상되어 들어옵니다</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent</name>
    <message>
        <source>it answers but sends no frames</source>
        <translation>응답하지만 영상을 보내지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent_advice</name>
    <message>
        <source>check its trigger and this computer&apos;s firewall</source>
        <translation>트리거와 이 컴퓨터의 방화벽을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.aravis_place_missing</name>
    <message>
        <source>it contains neither an address nor a serial number</source>
        <translation>주소도 일련번호도 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.aravis_wishes</name>
    <message>
        <source>use rate, exposure_ms, gain, format, size, trigger=software, packet_size or packet_delay_us, as in ?rate=30&amp;size=640x480</source>
        <translation>?rate=30&amp;size=640x480처럼 rate, exposure_ms, gain, format, size, trigger=software, packet_size, packet_delay_us를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_less</name>
    <message>
        <source>choose a smaller size or a lower rate</source>
        <translation>더 작은 크기나 낮은 속도를 요청하십시오</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_other_mode</name>
    <message>
        <source>choose another size or format</source>
        <translation>다른 크기나 형식을 요청하십시오</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_something_else</name>
    <message>
        <source>use another value, or leave the choice to the camera</source>
        <translation>다른 것을 요청하거나 카메라에 맡기십시오</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_usable_format</name>
    <message>
        <source>choose one of %1</source>
        <translation>%1 중 하나를 요청하십시오</translation>
    </message>
</context>
<context>
    <name>capture.ask_within_sensor</name>
    <message>
        <source>choose a size within that</source>
        <translation>그 안의 크기를 요청하십시오</translation>
    </message>
</context>
<context>
    <name>capture.automatics_held</name>
    <message>
        <source>exposure, gain, white balance and focus are held</source>
        <translation>노출, 게인, 화이트 밸런스, 초점이 고정됨</translation>
    </message>
</context>
<context>
    <name>capture.automatics_of_camera</name>
    <message>
        <source>Automatic settings, camera %1</source>
        <translation>자동 조절, 카메라 %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_enough</name>
    <message>
        <source>up to %1, enough for network cameras</source>
        <translation>최대 %1, 네트워크 카메라에 충분</translation>
    </message>
</context>
<context>
    <name>capture.buffer_not_known</name>
    <message>
        <source>the system does not report its maximum size (net.core.rmem_max)</source>
        <translation>시스템이 허용 크기를 알려 주지 않습니다 (net.core.rmem_max)</translation>
    </message>
</context>
<context>
    <name>capture.buffer_small</name>
    <message>
        <source>only %1</source>
        <translation>%1뿐</translation>
    </message>
</context>
<context>
    <name>capture.buffer_without_use</name>
    <message>
        <source>%1, too small only for network cameras</source>
        <translation>%1, 네트워크 카메라에만 부족</translation>
    </message>
</context>
<context>
    <name>capture.bus_of_speed_shared</name>
    <message>
        <source>cameras %1 share the bus %2, of %3</source>
        <translation>카메라 %1이(가) %3인 버스 %2을(를) 함께 씁니다</translation>
    </message>
</context>
<context>
    <name>capture.bus_shared</name>
    <message>
        <source>cameras %1 share the bus %2</source>
        <translation>카메라 %1이(가) 버스 %2을(를) 함께 씁니다</translation>
    </message>
</context>
<context>
    <name>capture.came_back_changed</name>
    <message>
        <source>it came back with another frame size or format</source>
        <translation>다른 크기나 형식의 영상으로 돌아왔습니다</translation>
    </message>
</context>
<context>
    <name>capture.camera_at_address</name>
    <message>
        <source>camera %1</source>
        <translation>카메라 %1</translation>
    </message>
</context>
<context>
    <name>capture.camera_does_not_deliver</name>
    <message>
        <source>a camera sends no frames</source>
        <translation>영상을 보내지 않는 카메라가 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.cameras_are_listed</name>
    <message>
        <source>odograph cameras lists them</source>
        <translation>녹화의 카메라…가 그것들을 보여 줍니다</translation>
    </message>
</context>
<context>
    <name>capture.cameras_will_lose</name>
    <message>
        <source>%1 will lose frames</source>
        <translation>%1에서 영상이 누락됩니다</translation>
    </message>
</context>
<context>
    <name>capture.cannot_be_opened</name>
    <message>
        <source>it cannot be opened (%1)</source>
        <translation>열 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.check_cable</name>
    <message>
        <source>check its cable</source>
        <translation>케이블을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_address</name>
    <message>
        <source>check its cable and address</source>
        <translation>케이블과 주소를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_network</name>
    <message>
        <source>check its cable and the network</source>
        <translation>케이블과 네트워크를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_cable</name>
    <message>
        <source>check its power and cable</source>
        <translation>전원과 케이블을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_network</name>
    <message>
        <source>check its power and cable, and that this computer has an address in the camera&apos;s network</source>
        <translation>전원과 케이블, 이 컴퓨터가 카메라 네트워크의 주소를 갖는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.check_usb_rights</name>
    <message>
        <source>check that you may use it (a udev rule), and that no other program does</source>
        <translation>사용 권한(udev 규칙)과 다른 프로그램이 쓰지 않는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.choose_another_value</name>
    <message>
        <source>choose another one</source>
        <translation>다른 것을 고르십시오</translation>
    </message>
</context>
<context>
    <name>capture.choose_listed</name>
    <message>
        <source>choose a camera that odograph cameras lists</source>
        <translation>녹화의 카메라…가 보여 주는 카메라를 고르십시오</translation>
    </message>
</context>
<context>
    <name>capture.choose_of_offer</name>
    <message>
        <source>choose one that it offers</source>
        <translation>제공하는 것 중에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>capture.choose_value_between</name>
    <message>
        <source>choose a value between</source>
        <translation>그 사이의 값을 고르십시오</translation>
    </message>
</context>
<context>
    <name>capture.close_that_program</name>
    <message>
        <source>close that program</source>
        <translation>그 프로그램을 닫으십시오</translation>
    </message>
</context>
<context>
    <name>capture.connect_right_camera</name>
    <message>
        <source>reconnect the original camera, or start over with this one</source>
        <translation>맞는 카메라를 연결하거나 이 카메라로 새로 시작하십시오</translation>
    </message>
</context>
<context>
    <name>capture.control_automatic</name>
    <message>
        <source>%1 cannot be set while it is automatic</source>
        <translation>%1은(는) 자동일 때 설정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.control_goes</name>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1의 범위는 %2에서 %3까지입니다</translation>
    </message>
</context>
<context>
    <name>capture.control_inactive</name>
    <message>
        <source>%1 cannot be set in the camera&apos;s current mode</source>
        <translation>카메라의 현재 상태에서는 %1을(를) 설정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.control_not_taken</name>
    <message>
        <source>it rejects this value for %1 (%2)</source>
        <translation>%1에 이 값을 받아들이지 않습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>capture.control_value_refused</name>
    <message>
        <source>it rejects this value of %1</source>
        <translation>%1의 이 값을 받아들이지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.damaged_advice</name>
    <message>
        <source>try another cable or port, or choose a lower rate or a smaller frame size</source>
        <translation>다른 케이블이나 포트를 쓰거나, 영상의 수나 크기를 줄이십시오</translation>
    </message>
</context>
<context>
    <name>capture.dim_light_halves_rate</name>
    <message>
        <source>in dim light a camera halves its rate unless its automatic exposure is off</source>
        <translation>어두우면 자동 노출을 끄지 않는 한 카메라가 스스로 속도를 절반으로 낮춥니다</translation>
    </message>
</context>
<context>
    <name>capture.disk_full</name>
    <message>
        <source>its disk has only %1 left, of which %2 are kept free</source>
        <translation>디스크에 %1만 남았고, 그중 %2 MB는 비워 둡니다</translation>
    </message>
</context>
<context>
    <name>capture.disk_of</name>
    <message>
        <source>the disk of %1</source>
        <translation>%1의 디스크</translation>
    </message>
</context>
<context>
    <name>capture.disk_too_slow</name>
    <message>
        <source>it is too slow</source>
        <translation>너무 느립니다</translation>
    </message>
</context>
<context>
    <name>capture.does_not_answer</name>
    <message>
        <source>it does not answer</source>
        <translation>응답하지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start</name>
    <message>
        <source>it does not start (%1)</source>
        <translation>시작되지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start_advice</name>
    <message>
        <source>check its cable, and that no other program uses it</source>
        <translation>케이블과 다른 프로그램이 쓰지 않는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.end_other_writers</name>
    <message>
        <source>stop other programs that write to it</source>
        <translation>그 디스크에 쓰는 다른 것을 끝내십시오</translation>
    </message>
</context>
<context>
    <name>capture.enlarge_buffer</name>
    <message>
        <source>sudo sysctl -w net.core.rmem_max=%1, and add the same line to /etc/sysctl.d/ to keep it</source>
        <translation>sudo sysctl -w net.core.rmem_max=%1, 유지하려면 /etc/sysctl.d/에도 넣으십시오</translation>
    </message>
</context>
<context>
    <name>capture.expose_for_mains</name>
    <message>
        <source>expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz</source>
        <translation>50 Hz에서는 10 또는 20 ms, 60 Hz에서는 8.3 또는 16.7 ms로 노출하십시오</translation>
    </message>
</context>
<context>
    <name>capture.exposed_for</name>
    <message>
        <source>exposed for %1</source>
        <translation>%1 노출</translation>
    </message>
</context>
<context>
    <name>capture.exposure_and_gain</name>
    <message>
        <source>Exposure and gain</source>
        <translation>노출과 게인</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_taken</name>
    <message>
        <source>it rejects this exposure (%1)</source>
        <translation>이 노출을 받아들이지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_told</name>
    <message>
        <source>it does not report its exposure</source>
        <translation>노출을 알려 주지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.exposure_suits_lamps</name>
    <message>
        <source>exposed for %1, which suits lamps</source>
        <translation>%1 노출, 조명에 맞음</translation>
    </message>
</context>
<context>
    <name>capture.failed</name>
    <message>
        <source>it failed (%1)</source>
        <translation>오류가 났습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.failed_advice</name>
    <message>
        <source>if this continues, unplug it and plug it in again</source>
        <translation>계속되면 뽑았다가 다시 꽂으십시오</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filter_off</name>
    <message>
        <source>its filter is off</source>
        <translation>필터가 꺼져 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filtered</name>
    <message>
        <source>filtered by the camera (%1)</source>
        <translation>카메라가 걸러 냄 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.flicker_of_camera</name>
    <message>
        <source>Lamp flicker, camera %1</source>
        <translation>조명 깜박임, 카메라 %1</translation>
    </message>
</context>
<context>
    <name>capture.forbidden</name>
    <message>
        <source>you may not use it</source>
        <translation>쓸 권한이 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.forbidden_advice</name>
    <message>
        <source>join the group video (sudo usermod -aG video YOUR-NAME) and log in again</source>
        <translation>video 그룹에 들어간 뒤(sudo usermod -aG video YOUR-NAME) 다시 로그인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.format</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1(%2)</translation>
    </message>
</context>
<context>
    <name>capture.format_not_told</name>
    <message>
        <source>it does not report its pixel format (%1)</source>
        <translation>픽셀 형식을 알려 주지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.format_not_understood</name>
    <message>
        <source>its pixel format is not supported</source>
        <translation>픽셀 형식이 지원되지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.free_after_crash</name>
    <message>
        <source>a camera whose program has crashed is free again after some seconds</source>
        <translation>프로그램이 죽은 카메라는 몇 초 뒤 다시 쓸 수 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.gain_not_taken</name>
    <message>
        <source>it rejects this gain (%1)</source>
        <translation>이 게인을 받아들이지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.give_address</name>
    <message>
        <source>give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH</source>
        <translation>v4l2:/dev/video0, aravis:192.168.1.20, sim:A 또는 file:PATH처럼 지정하십시오</translation>
    </message>
</context>
<context>
    <name>capture.give_aravis_place</name>
    <message>
        <source>give one as aravis:192.168.1.20 or aravis:SERIAL</source>
        <translation>aravis:192.168.1.20이나 aravis:SERIAL처럼 주십시오</translation>
    </message>
</context>
<context>
    <name>capture.gives_no_pictures</name>
    <message>
        <source>%1 sends no frames</source>
        <translation>%1은(는) 영상을 주지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.has_been_away</name>
    <message>
        <source>the connection was lost</source>
        <translation>잠시 끊겼습니다</translation>
    </message>
</context>
<context>
    <name>capture.held_while_recording</name>
    <message>
        <source>they are held while recording</source>
        <translation>녹화 중에 고정됩니다</translation>
    </message>
</context>
<context>
    <name>capture.in_step</name>
    <message>
        <source>synchronised to %1</source>
        <translation>동기 오차 %1</translation>
    </message>
</context>
<context>
    <name>capture.in_step_as_way</name>
    <message>
        <source>at %1 that is %2</source>
        <translation>%1에서 %2</translation>
    </message>
</context>
<context>
    <name>capture.join_video_group</name>
    <message>
        <source>add yourself to the group video (sudo usermod -aG video $USER), then log out and in again</source>
        <translation>video 그룹에 추가한 뒤(sudo usermod -aG video $USER) 로그아웃했다가 다시 로그인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.keep_awake</name>
    <message>
        <source>keep it awake while it records</source>
        <translation>녹화하는 동안 절전에 들지 않게 하십시오</translation>
    </message>
</context>
<context>
    <name>capture.kept_before_sleep</name>
    <message>
        <source>the recording up to then is kept</source>
        <translation>그 이전 것은 보존됩니다</translation>
    </message>
</context>
<context>
    <name>capture.large_packets</name>
    <message>
        <source>large packets are allowed</source>
        <translation>큰 패킷이 허용됩니다</translation>
    </message>
</context>
<context>
    <name>capture.largest_picture</name>
    <message>
        <source>its frames have at most %1 pixels</source>
        <translation>영상은 최대 %1픽셀입니다</translation>
    </message>
</context>
<context>
    <name>capture.leave_control_out</name>
    <message>
        <source>leave it out</source>
        <translation>빼십시오</translation>
    </message>
</context>
<context>
    <name>capture.look_again</name>
    <message>
        <source>wait a few seconds, then check again</source>
        <translation>몇 초 기다렸다가 다시 보십시오</translation>
    </message>
</context>
<context>
    <name>capture.look_at_cable</name>
    <message>
        <source>check its cable</source>
        <translation>케이블을 살펴보십시오</translation>
    </message>
</context>
<context>
    <name>capture.lost_by_slow_machine</name>
    <message>
        <source>%1, %2 lost because this machine is too slow</source>
        <translation>%1, 이 컴퓨터가 너무 느려 %2개 누락</translation>
    </message>
</context>
<context>
    <name>capture.lost_here</name>
    <message>
        <source>%1, %2 lost here</source>
        <translation>%1, 이 컴퓨터에서 %2개 누락</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire</name>
    <message>
        <source>%1, %2 lost on the wire</source>
        <translation>%1, 전송 중 %2개 누락</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire_and_here</name>
    <message>
        <source>%1, %2 lost (%3 on the wire, %4 here)</source>
        <translation>%1, %2개 누락(전송 중 %3개, 이 컴퓨터에서 %4개)</translation>
    </message>
</context>
<context>
    <name>capture.machine_slept</name>
    <message>
        <source>it slept for %1 and recorded nothing meanwhile</source>
        <translation>%1 동안 절전 상태여서 그동안 녹화되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>capture.make_room</name>
    <message>
        <source>free some disk space, or move the project to another disk</source>
        <translation>공간을 확보하거나 프로젝트를 다른 디스크로 옮기십시오</translation>
    </message>
</context>
<context>
    <name>capture.mode_not_taken</name>
    <message>
        <source>it rejects %1</source>
        <translation>%1을(를) 받아들이지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_automatics</name>
    <message>
        <source>it has none</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>capture.no_network_camera</name>
    <message>
        <source>no network camera is used</source>
        <translation>네트워크 카메라를 쓰지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_node</name>
    <message>
        <source>this computer has no USB or built-in camera (/dev/video*)</source>
        <translation>이 컴퓨터에 USB 카메라나 내장 카메라가 보이지 않습니다 (/dev/video*)</translation>
    </message>
</context>
<context>
    <name>capture.no_node_advice</name>
    <message>
        <source>if one is connected, try another cable and port, without a hub</source>
        <translation>연결되어 있다면 허브 없이 다른 케이블과 포트를 써 보십시오</translation>
    </message>
</context>
<context>
    <name>capture.no_pair_yet</name>
    <message>
        <source>no frames of the cameras have been paired yet</source>
        <translation>아직 함께 찍힌 두 영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_came</name>
    <message>
        <source>no frame arrived for half a second</source>
        <translation>0.5초 동안 영상이 오지 않았습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_for</name>
    <message>
        <source>no frame has arrived for %1</source>
        <translation>%1 동안 영상이 오지 않았습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_readable_format</name>
    <message>
        <source>it offers no supported format</source>
        <translation>읽을 수 있는 형식이 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_simulated_camera</name>
    <message>
        <source>simulated camera %1 does not exist</source>
        <translation>시뮬레이션 카메라 %1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_software_trigger</name>
    <message>
        <source>it has no software trigger (%1)</source>
        <translation>소프트웨어 트리거가 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.no_such_address</name>
    <message>
        <source>no kind of camera has an address like this</source>
        <translation>그런 주소의 카메라가 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_such_control</name>
    <message>
        <source>it has no setting &apos;%1&apos;</source>
        <translation>설정할 수 있는 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_such_format</name>
    <message>
        <source>it has no format %1 (%2)</source>
        <translation>%1 형식이 없습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>capture.no_usable_format</name>
    <message>
        <source>it offers no supported pixel format</source>
        <translation>지원되는 픽셀 형식이 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.no_usb_camera</name>
    <message>
        <source>no USB camera is used</source>
        <translation>USB 카메라를 쓰지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.nodes_forbidden</name>
    <message>
        <source>you may not use %1</source>
        <translation>%1을(를) 쓸 권한이 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.nodes_usable</name>
    <message>
        <source>you may use all %1 video devices</source>
        <translation>비디오 장치 %1개를 모두 쓸 수 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.none_lost</name>
    <message>
        <source>%1, none lost</source>
        <translation>%1, 누락 없음</translation>
    </message>
</context>
<context>
    <name>capture.not_offered</name>
    <message>
        <source>it does not offer the requested mode</source>
        <translation>요청한 것을 제공하지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.not_registered</name>
    <message>
        <source>it is not registered to the floor</source>
        <translation>바닥에 정합되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>capture.not_there</name>
    <message>
        <source>it is not connected</source>
        <translation>없습니다</translation>
    </message>
</context>
<context>
    <name>capture.nothing_lost_yet</name>
    <message>
        <source>nothing is lost yet</source>
        <translation>아직 잃은 것은 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.one_camera_in_step</name>
    <message>
        <source>a single camera needs no synchronisation</source>
        <translation>카메라 한 대는 항상 동기 상태입니다</translation>
    </message>
</context>
<context>
    <name>capture.one_not_held</name>
    <message>
        <source>%1 still adjusts automatically</source>
        <translation>%1이(가) 계속 저절로 바뀝니다</translation>
    </message>
</context>
<context>
    <name>capture.open_video_again</name>
    <message>
        <source>open it again to see it from the start</source>
        <translation>처음부터 보려면 다시 여십시오</translation>
    </message>
</context>
<context>
    <name>capture.other_camera_in_place</name>
    <message>
        <source>another camera (%1) has replaced it</source>
        <translation>그 자리에 다른 카메라(%1)가 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.other_serial_in_place</name>
    <message>
        <source>another camera (%1) has replaced camera %2</source>
        <translation>카메라 %2 자리에 다른 카메라(%1)가 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.own_usb_buses</name>
    <message>
        <source>each USB camera has its own bus</source>
        <translation>각 USB 카메라가 자기 버스를 씁니다</translation>
    </message>
</context>
<context>
    <name>capture.packet_delay_not_taken</name>
    <message>
        <source>it rejects this packet delay (%1)</source>
        <translation>이 패킷 지연을 받아들이지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.packet_size</name>
    <message>
        <source>Packet size</source>
        <translation>패킷 크기</translation>
    </message>
</context>
<context>
    <name>capture.packet_size_not_taken</name>
    <message>
        <source>it rejects this packet size (%1)</source>
        <translation>이 패킷 크기를 받아들이지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.part_not_understood</name>
    <message>
        <source>&apos;%1&apos; is not valid</source>
        <translation>&apos;%1&apos;을(를) 이해할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.payload_not_told</name>
    <message>
        <source>it does not report how many bytes a frame has (%1)</source>
        <translation>영상의 크기를 알려 주지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.picture_of_camera</name>
    <message>
        <source>a frame of camera %1</source>
        <translation>카메라 %1의 그림</translation>
    </message>
</context>
<context>
    <name>capture.picture_size_of_camera</name>
    <message>
        <source>Frame size, camera %1</source>
        <translation>영상 크기, 카메라 %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_waits_for_disk</name>
    <message>
        <source>a frame has waited %1; the write buffer is %2 full</source>
        <translation>영상이 %1 기다렸고 대기 공간의 %2가 찼습니다</translation>
    </message>
</context>
<context>
    <name>capture.pictures_being_lost</name>
    <message>
        <source>frames are being lost</source>
        <translation>영상이 누락되고 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.pictures_incomplete</name>
    <message>
        <source>its frames arrive incomplete</source>
        <translation>영상이 불완전하게 들어옵니다</translation>
    </message>
</context>
<context>
    <name>capture.pictures_may_pulse</name>
    <message>
        <source>brightness may pulse under lamps</source>
        <translation>조명 아래에서 영상이 깜박일 수 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.pictures_without_size</name>
    <message>
        <source>its frames have no size</source>
        <translation>영상의 크기가 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.plug_camera_in_again</name>
    <message>
        <source>plug %1 in again</source>
        <translation>%1을(를) 다시 연결하십시오</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_again</name>
    <message>
        <source>plug it in again</source>
        <translation>다시 연결하십시오</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_or_choose</name>
    <message>
        <source>plug it in, or choose a camera that odograph cameras lists</source>
        <translation>연결하거나 녹화의 카메라…가 보여 주는 것 중에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>capture.put_disk_back</name>
    <message>
        <source>reconnect its disk, or move its folder back</source>
        <translation>디스크나 폴더를 있던 곳에 되돌려 놓으십시오</translation>
    </message>
</context>
<context>
    <name>capture.rate_not_taken</name>
    <message>
        <source>it rejects this rate (%1)</source>
        <translation>이 속도를 받아들이지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.rate_too_slow</name>
    <message>
        <source>%1 (too slow)</source>
        <translation>%1(너무 느림)</translation>
    </message>
</context>
<context>
    <name>capture.rates_differ</name>
    <message>
        <source>the cameras run at %1 and %2</source>
        <translation>카메라의 속도가 %1와 %2로 서로 다릅니다</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer</name>
    <message>
        <source>Receive buffer</source>
        <translation>수신 버퍼</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer_granted</name>
    <message>
        <source>the system keeps only %1 of the network&apos;s packets</source>
        <translation>시스템이 네트워크 패킷을 %1까지만 담아 둡니다</translation>
    </message>
</context>
<context>
    <name>capture.record_elsewhere</name>
    <message>
        <source>record to another disk, or use fewer cameras</source>
        <translation>다른 디스크에 녹화하거나 카메라 수를 줄이십시오</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_kept</name>
    <message>
        <source>what was recorded so far is kept</source>
        <translation>지금까지 녹화된 것은 보존됩니다</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_there</name>
    <message>
        <source>it holds what was recorded so far</source>
        <translation>지금까지 녹화된 것은 거기에 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.recording_file_gone</name>
    <message>
        <source>its file is no longer there</source>
        <translation>그 파일이 더 이상 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.register_in_testbed</name>
    <message>
        <source>register it in Testbed; Odograph needs this to measure where a robot is</source>
        <translation>테스트베드에서 정합하십시오. 그렇지 않으면 영상에서 로봇의 위치를 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>capture.room_for</name>
    <message>
        <source>remaining recording time %1</source>
        <translation>남은 녹화 시간 %1</translation>
    </message>
</context>
<context>
    <name>capture.see_own_line</name>
    <message>
        <source>see the line of that camera</source>
        <translation>해당 줄을 보십시오</translation>
    </message>
</context>
<context>
    <name>capture.send_less</name>
    <message>
        <source>or set both to MJPEG or to a smaller frame size</source>
        <translation>또는 둘 다 MJPEG이나 더 작은 영상을 보내게 하십시오</translation>
    </message>
</context>
<context>
    <name>capture.send_registered_size</name>
    <message>
        <source>set it to the size it was registered at, or calibrate and register it again</source>
        <translation>정합한 크기로 보내게 하거나 새로 보정하고 정합하십시오</translation>
    </message>
</context>
<context>
    <name>capture.sends_no_pictures</name>
    <message>
        <source>it sends no frames</source>
        <translation>영상을 보내지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.serial_advice</name>
    <message>
        <source>check its power and cable; odograph cameras lists those that answer</source>
        <translation>전원과 케이블을 확인하십시오. 녹화의 카메라…가 응답하는 것을 보여 줍니다</translation>
    </message>
</context>
<context>
    <name>capture.serial_does_not_answer</name>
    <message>
        <source>no camera of this serial number answers</source>
        <translation>이 일련번호의 카메라가 응답하지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.set_as_before</name>
    <message>
        <source>restore its settings, or start over with size and format in its address</source>
        <translation>이전처럼 설정하거나 주소에 크기와 형식을 넣어 새로 시작하십시오</translation>
    </message>
</context>
<context>
    <name>capture.set_between</name>
    <message>
        <source>set it to something between</source>
        <translation>그 사이의 값으로 설정하십시오</translation>
    </message>
</context>
<context>
    <name>capture.set_rate_or_trigger</name>
    <message>
        <source>set both to the same rate, or trigger them together</source>
        <translation>둘을 같은 속도로 하거나 함께 트리거하십시오</translation>
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
        <translation>&apos;%1&apos;을(를) 전원 주파수에 맞추십시오</translation>
    </message>
</context>
<context>
    <name>capture.set_to_one_rate</name>
    <message>
        <source>set both to the same rate</source>
        <translation>둘을 같은 속도로 설정하십시오</translation>
    </message>
</context>
<context>
    <name>capture.set_to_something_else</name>
    <message>
        <source>set another value</source>
        <translation>다른 값으로 설정하십시오</translation>
    </message>
</context>
<context>
    <name>capture.set_width_and_height</name>
    <message>
        <source>set its width and height</source>
        <translation>너비와 높이를 설정하십시오</translation>
    </message>
</context>
<context>
    <name>capture.several_not_held</name>
    <message>
        <source>%1 still adjust automatically</source>
        <translation>%1이(가) 계속 저절로 바뀝니다</translation>
    </message>
</context>
<context>
    <name>capture.simulated_camera</name>
    <message>
        <source>Simulated camera %1</source>
        <translation>시뮬레이션 카메라 %1</translation>
    </message>
</context>
<context>
    <name>capture.size_as_registered</name>
    <message>
        <source>%1, as it was registered</source>
        <translation>%1, 정합할 때와 같음</translation>
    </message>
</context>
<context>
    <name>capture.size_not_as_registered</name>
    <message>
        <source>%1, but registered at %2</source>
        <translation>%1, 그러나 %2에서 정합됨</translation>
    </message>
</context>
<context>
    <name>capture.size_not_taken</name>
    <message>
        <source>it rejects this size (%1)</source>
        <translation>이 크기를 받아들이지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.size_not_told</name>
    <message>
        <source>it does not report its width and height (%1)</source>
        <translation>크기를 알려 주지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera</name>
    <message>
        <source>it delivers only %1 frames per second instead of the requested %2</source>
        <translation>요청한 초당 %2개 중 %1개만 찍습니다</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera_advice</name>
    <message>
        <source>give it more light or a shorter exposure, or ask for a lower rate</source>
        <translation>조명을 늘리거나 노출을 줄이거나 더 낮은 속도를 요청하십시오</translation>
    </message>
</context>
<context>
    <name>capture.small_packets</name>
    <message>
        <source>small packets on %1</source>
        <translation>%1에서 작은 패킷</translation>
    </message>
</context>
<context>
    <name>capture.small_packets_advice</name>
    <message>
        <source>set the MTU of the camera&apos;s network port to 9000 (sudo ip link set dev NAME mtu 9000), if camera and switch support it</source>
        <translation>카메라와 스위치가 지원하면 카메라 포트의 MTU를 9000으로 하십시오 (sudo ip link set dev NAME mtu 9000)</translation>
    </message>
</context>
<context>
    <name>capture.step</name>
    <message>
        <source>Synchronisation</source>
        <translation>동기</translation>
    </message>
</context>
<context>
    <name>capture.take_another_camera</name>
    <message>
        <source>use another camera</source>
        <translation>다른 카메라를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>capture.take_camera_with_format</name>
    <message>
        <source>use a camera that offers one of %1</source>
        <translation>%1 중 하나가 있는 카메라를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>capture.take_off_and_on</name>
    <message>
        <source>unplug it and plug it in again if this continues</source>
        <translation>계속 그러면 뽑았다가 다시 꽂으십시오</translation>
    </message>
</context>
<context>
    <name>capture.take_simulated_camera</name>
    <message>
        <source>use sim:A or sim:B</source>
        <translation>sim:A나 sim:B를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>capture.taken_up_by_itself</name>
    <message>
        <source>Odograph reconnects automatically</source>
        <translation>저절로 다시 이어집니다</translation>
    </message>
</context>
<context>
    <name>capture.the_picture</name>
    <message>
        <source>the frame</source>
        <translation>사진</translation>
    </message>
</context>
<context>
    <name>capture.the_recording</name>
    <message>
        <source>the recording %1</source>
        <translation>녹화 %1</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent</name>
    <message>
        <source>it is connected but sends no frames</source>
        <translation>연결되어 있지만 영상을 보내지 않습니다</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent_advice</name>
    <message>
        <source>check its cable; if this continues, plug it in again</source>
        <translation>케이블을 살펴보고, 계속되면 다시 꽂으십시오</translation>
    </message>
</context>
<context>
    <name>capture.these_and_others</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 등</translation>
    </message>
</context>
<context>
    <name>capture.this_computer</name>
    <message>
        <source>this computer</source>
        <translation>이 컴퓨터</translation>
    </message>
</context>
<context>
    <name>capture.turn_automatic_off</name>
    <message>
        <source>turn automatic mode off</source>
        <translation>자동을 끄십시오</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_at_camera</name>
    <message>
        <source>turn it off in the camera&apos;s own program, or keep the light steady while robots run</source>
        <translation>카메라 자체 프로그램에서 끄거나, 로봇이 달리는 동안 조명을 일정하게 유지하십시오</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_automatic_first</name>
    <message>
        <source>first turn off the automatic mode that controls it</source>
        <translation>먼저 그것을 움직이는 자동 기능을 끄십시오</translation>
    </message>
</context>
<context>
    <name>capture.unplugged</name>
    <message>
        <source>it was unplugged</source>
        <translation>분리되었습니다</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full</name>
    <message>
        <source>its USB bus has no bandwidth left for its frames (the bus is full, not the disk)</source>
        <translation>USB 버스에 영상을 보낼 여유가 없습니다(디스크가 아니라 버스가 가득 찼습니다)</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full_advice</name>
    <message>
        <source>plug it into a port whose bus no other camera uses, or choose MJPEG, a smaller frame size or a lower rate (?format=MJPG&amp;size=640x480&amp;rate=30)</source>
        <translation>다른 카메라와 버스를 나누지 않는 곳에 연결하거나 MJPEG, 더 작은 영상, 더 낮은 속도를 고르십시오 (?format=MJPG&amp;size=640x480&amp;rate=30)</translation>
    </message>
</context>
<context>
    <name>capture.usb_buses</name>
    <message>
        <source>USB buses</source>
        <translation>USB 버스</translation>
    </message>
</context>
<context>
    <name>capture.use_daylight</name>
    <message>
        <source>or use daylight</source>
        <translation>또는 자연광을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>capture.use_other_port</name>
    <message>
        <source>plug one into a port on the other side of the computer, or into its own USB card</source>
        <translation>하나를 컴퓨터 반대쪽 포트나 별도 카드에 꽂으십시오</translation>
    </message>
</context>
<context>
    <name>capture.used_by_another_program</name>
    <message>
        <source>another program uses it</source>
        <translation>다른 프로그램이 쓰고 있습니다</translation>
    </message>
</context>
<context>
    <name>capture.used_by_program</name>
    <message>
        <source>another program uses it (open in %1)</source>
        <translation>다른 프로그램이 쓰고 있습니다(%1에서 열려 있음)</translation>
    </message>
</context>
<context>
    <name>capture.usual_mains</name>
    <message>
        <source>50 Hz in most countries, 60 Hz in the Americas</source>
        <translation>대부분의 나라 50 Hz, 미주와 한국 60 Hz</translation>
    </message>
</context>
<context>
    <name>capture.v4l2_address_example</name>
    <message>
        <source>write it like v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</source>
        <translation>v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG처럼 쓰십시오</translation>
    </message>
</context>
<context>
    <name>capture.video_has_ended</name>
    <message>
        <source>the video has ended</source>
        <translation>동영상이 끝났습니다</translation>
    </message>
</context>
<context>
    <name>capture.wait_for_it</name>
    <message>
        <source>wait: Odograph is reconnecting</source>
        <translation>기다리십시오: 다시 이어집니다</translation>
    </message>
</context>
<context>
    <name>capture.wait_or_check_cable</name>
    <message>
        <source>wait, or check its cable</source>
        <translation>기다리거나 케이블을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>capture.waiting_for_first_picture</name>
    <message>
        <source>waiting for the first frame</source>
        <translation>첫 영상을 기다리는 중</translation>
    </message>
</context>
<context>
    <name>exchange.accepted</name>
    <message>
        <source>Accepted: %1</source>
        <translation>수락됨: %1</translation>
    </message>
</context>
<context>
    <name>exchange.and_lines_more</name>
    <message>
        <source>and %1 more lines</source>
        <translation>외 %1행</translation>
    </message>
</context>
<context>
    <name>exchange.archive_library_refused</name>
    <message>
        <source>the archive library failed</source>
        <translation>압축 라이브러리가 거부했습니다</translation>
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
        <translation>바닥 축: 파일의 %1</translation>
    </message>
</context>
<context>
    <name>exchange.axes_seen</name>
    <message>
        <source>floor axes: %1 of the file, as its %2 stays near %3</source>
        <translation>바닥 축: 파일의 %1. %2가 %3 부근에 머무르기 때문입니다</translation>
    </message>
</context>
<context>
    <name>exchange.axes_unclear</name>
    <message>
        <source>its z varies by %1 while its %2 stays near %3</source>
        <translation>z는 %1만큼 변하는데 %2는 %3 부근에 머무릅니다</translation>
    </message>
</context>
<context>
    <name>exchange.begin_roster</name>
    <message>
        <source>begin the file with the line class,team or class,team,pseudonym</source>
        <translation>파일을 class,team 또는 class,team,pseudonym 줄로 시작하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_header_or_tum</name>
    <message>
        <source>begin the file with the line %1, or write lines of %2</source>
        <translation>파일을 %1 행으로 시작하거나 %2(으)로 된 행을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_line</name>
    <message>
        <source>begin the file with the line %1</source>
        <translation>파일을 %1 줄로 시작하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.break_opened</name>
    <message>
        <source>its positions jump by %1 in line %2 and go on from there: %3 positions around count as not measured, and the path ends at the jump</source>
        <translation>%2행에서 위치가 %1 튀어 그곳에서 이어집니다. 주변 위치 %3개를 측정되지 않은 것으로 처리하며, 경로는 그 지점에서 끊어집니다</translation>
    </message>
</context>
<context>
    <name>exchange.breaks_too_often</name>
    <message>
        <source>its positions jump %1 times and go on from elsewhere</source>
        <translation>위치가 %1번 튀어 다른 곳에서 이어집니다</translation>
    </message>
</context>
<context>
    <name>exchange.cell_not_a_number</name>
    <message>
        <source>%1 &apos;%2&apos; is not a finite number</source>
        <translation>%1 &apos;%2&apos;은(는) 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.cell_of_columns</name>
    <message>
        <source>it has %1 cell where the header has %2</source>
        <translation>셀이 %1개인데 머리글에는 %2개입니다</translation>
    </message>
</context>
<context>
    <name>exchange.cells_of_columns</name>
    <message>
        <source>it has %1 cells where the header has %2</source>
        <translation>셀이 %1개인데 머리글에는 %2개입니다</translation>
    </message>
</context>
<context>
    <name>exchange.centre_impossible</name>
    <message>
        <source>the image centre (%1, %2) is far outside the image of %3 × %4 pixels</source>
        <translation>이미지 중심(%1, %2)이 %3 × %4 픽셀 이미지에서 멀리 벗어나 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.check_both_units</name>
    <message>
        <source>choose the units of its times and positions</source>
        <translation>시각과 위치의 단위를 선택하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.check_it_is_there</name>
    <message>
        <source>check that it exists and that you may read it</source>
        <translation>있고 읽을 수 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.check_one_run</name>
    <message>
        <source>check that all lines are of one run</source>
        <translation>모든 행이 한 주행의 것인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.check_right_file</name>
    <message>
        <source>check that it is the right file</source>
        <translation>맞는 파일인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.check_track_column</name>
    <message>
        <source>check which column says the track of a line</source>
        <translation>어느 열이 행의 궤적을 나타내는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_places</name>
    <message>
        <source>check the unit of the positions: m, cm or mm</source>
        <translation>위치의 단위를 확인하십시오: m, cm 또는 mm</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_times</name>
    <message>
        <source>check the unit of the times, and that all lines are of one run</source>
        <translation>시간의 단위와 모든 행이 한 주행의 것인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes</name>
    <message>
        <source>choose the axes of the floor: %1, or xy if that is right</source>
        <translation>바닥 축을 선택하십시오: %1, 또는 맞다면 xy</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes_xy</name>
    <message>
        <source>choose the axes x and y</source>
        <translation>x축과 y축을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_column</name>
    <message>
        <source>choose from %1</source>
        <translation>%1 중에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_decimal_sign</name>
    <message>
        <source>choose its decimal sign: point or comma</source>
        <translation>소수점 기호를 선택하십시오: 점 또는 쉼표</translation>
    </message>
</context>
<context>
    <name>exchange.choose_entry</name>
    <message>
        <source>choose one of them</source>
        <translation>그중 하나를 선택하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_likely_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px; %1 is likely</source>
        <translation>단위를 선택하십시오: m, cm, mm, in, ft 또는 px. %1일 가능성이 큽니다</translation>
    </message>
</context>
<context>
    <name>exchange.choose_longer_track</name>
    <message>
        <source>choose a file with three positions or more</source>
        <translation>위치가 세 개 이상인 파일을 고르십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_new_folder</name>
    <message>
        <source>choose a folder that does not exist yet</source>
        <translation>아직 없는 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_packed_file</name>
    <message>
        <source>choose a file that Odograph has packed; if it is damaged, copy it again</source>
        <translation>Odograph가 묶은 파일을 고르고, 손상되었다면 새로 복사하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_style</name>
    <message>
        <source>choose analysis, international or continental</source>
        <translation>analysis, international, continental 중에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>exchange.choose_time_unit</name>
    <message>
        <source>choose their unit: s, ms, us, ns, min, h, d or frame; %1 is likely</source>
        <translation>단위를 선택하십시오: s, ms, us, ns, min, h, d 또는 frame. %1일 가능성이 큽니다</translation>
    </message>
</context>
<context>
    <name>exchange.choose_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px</source>
        <translation>단위를 선택하십시오: m, cm, mm, in, ft 또는 px</translation>
    </message>
</context>
<context>
    <name>exchange.close_quotes</name>
    <message>
        <source>close the quotes</source>
        <translation>따옴표를 닫으십시오</translation>
    </message>
</context>
<context>
    <name>exchange.closed_neither</name>
    <message>
        <source>&apos;closed&apos; is neither true nor false</source>
        <translation>&apos;closed&apos;가 true도 false도 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.coefficients_no_row</name>
    <message>
        <source>&apos;distortion_coefficients&apos; is neither a row nor a column</source>
        <translation>&apos;distortion_coefficients&apos;가 행도 열도 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.column_twice</name>
    <message>
        <source>it is named twice</source>
        <translation>두 번 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>exchange.columns_assumed</name>
    <message>
        <source>it has no header: its columns count as time, x and y</source>
        <translation>머리글이 없어 열을 시간, x, y로 봅니다</translation>
    </message>
</context>
<context>
    <name>exchange.commas_group_thousands</name>
    <message>
        <source>commas separate thousands</source>
        <translation>쉼표가 천 단위를 구분합니다</translation>
    </message>
</context>
<context>
    <name>exchange.confidence_not_used</name>
    <message>
        <source>its confidences are neither from 0 to 1 nor from 0 to 100, and were not used</source>
        <translation>신뢰도가 0~1도 0~100도 아니어서 사용하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>exchange.csv_column</name>
    <message>
        <source>column &apos;%1&apos; of CSV</source>
        <translation>CSV 열 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.csv_style</name>
    <message>
        <source>style &apos;%1&apos; of CSV</source>
        <translation>CSV 형식 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.cut_line_left_out</name>
    <message>
        <source>the last line, line %1, was left out, because it ends too early</source>
        <translation>마지막 행인 %1행은 중간에 끊겨 제외했습니다</translation>
    </message>
</context>
<context>
    <name>exchange.does_not_belong</name>
    <message>
        <source>&apos;%1&apos; does not belong in a packed project</source>
        <translation>&apos;%1&apos;은(는) 묶은 프로젝트에 속하지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.entry_is_missing</name>
    <message>
        <source>the entry &apos;%1&apos; is missing</source>
        <translation>항목 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.file_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>%1보다 큽니다</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_all_cells</name>
    <message>
        <source>give each line as many cells as the header</source>
        <translation>각 행의 셀 수를 머리글과 같게 하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_both</name>
    <message>
        <source>fill in both or none</source>
        <translation>둘 다 채우거나 둘 다 비우십시오</translation>
    </message>
</context>
<context>
    <name>exchange.focal_impossible</name>
    <message>
        <source>no lens has a focal length of %1 at %2 × %3 pixels</source>
        <translation>%2 × %3 픽셀에서 초점 거리가 %1인 렌즈는 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.format_has_pixels</name>
    <message>
        <source>%1 writes positions in pixels, which are no lengths</source>
        <translation>%1은(는) 위치를 픽셀로 기록하며, 픽셀은 길이가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula</name>
    <message>
        <source>formula &apos;%1&apos;</source>
        <translation>수식 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.formula_advice</name>
    <message>
        <source>write one like 0.5 * mass * max_speed^2, with names of metrics and variables</source>
        <translation>지표와 변수의 이름으로 0.5 * mass * max_speed^2처럼 쓰세요</translation>
    </message>
</context>
<context>
    <name>exchange.formula_brace</name>
    <message>
        <source>a closing brace is missing</source>
        <translation>닫는 중괄호가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_bracket</name>
    <message>
        <source>a closing bracket is missing</source>
        <translation>닫는 괄호가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_ends</name>
    <message>
        <source>a number or a name is missing at its end</source>
        <translation>끝에 숫자나 이름이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_function</name>
    <message>
        <source>there is no function &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 함수가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_number</name>
    <message>
        <source>there is no number at character %1</source>
        <translation>%1번째 글자에 숫자가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_sign</name>
    <message>
        <source>&apos;%1&apos; is not expected at character %2</source>
        <translation>%2번째 글자에 &apos;%1&apos;이(가) 올 수 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_too_deep</name>
    <message>
        <source>it has too many brackets in each other</source>
        <translation>괄호가 너무 많이 겹쳐 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_too_long</name>
    <message>
        <source>it is too long</source>
        <translation>너무 깁니다</translation>
    </message>
</context>
<context>
    <name>exchange.formula_two</name>
    <message>
        <source>&apos;%1&apos; takes two values, parted by a comma</source>
        <translation>&apos;%1&apos;은(는) 쉼표로 나눈 두 값을 받습니다</translation>
    </message>
</context>
<context>
    <name>exchange.frame_without_time</name>
    <message>
        <source>it has no time that can be read</source>
        <translation>읽을 수 있는 시간이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.frames_without_rate</name>
    <message>
        <source>it has frame numbers in place of times</source>
        <translation>시각 대신 프레임 번호가 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.give_known_units</name>
    <message>
        <source>give times in s or ms and positions in m, cm or mm</source>
        <translation>시간은 s나 ms, 위치는 m, cm, mm로 주십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_lower_confidence</name>
    <message>
        <source>give a lower least confidence</source>
        <translation>더 낮은 최소 신뢰도를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_marker_label</name>
    <message>
        <source>give each marker a label</source>
        <translation>마커마다 이름표를 주십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_path</name>
    <message>
        <source>give one of points_mm, circle, figure_eight or slalom</source>
        <translation>points_mm, circle, figure_eight, slalom 중 하나를 주십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_zone</name>
    <message>
        <source>give all corners in order as corners_mm, or two opposite corners as rectangle_mm</source>
        <translation>둘레를 따라 corners_mm를 주거나 마주 보는 두 모서리를 rectangle_mm로 주십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_pixel_length</name>
    <message>
        <source>give how long a pixel is on the floor, or choose another unit of the positions</source>
        <translation>바닥에서 픽셀 하나의 길이를 지정하거나 위치의 다른 단위를 선택하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_point_label</name>
    <message>
        <source>give each point a label</source>
        <translation>점마다 이름표를 주십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_rate</name>
    <message>
        <source>give the frame rate of the camera</source>
        <translation>카메라의 프레임 속도를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.give_two_corners</name>
    <message>
        <source>give two opposite corners: [[x, y], [x, y]]</source>
        <translation>마주 보는 두 모서리를 주십시오: [[x, y], [x, y]]</translation>
    </message>
</context>
<context>
    <name>exchange.has_become_shorter</name>
    <message>
        <source>it has become shorter during packing</source>
        <translation>그사이 짧아졌습니다</translation>
    </message>
</context>
<context>
    <name>exchange.held_left_out</name>
    <message>
        <source>%1 positions that only repeat the last one count as not measured; the first is in line %2</source>
        <translation>마지막 위치를 반복하기만 하는 위치 %1개를 측정되지 않은 것으로 처리합니다. 첫 번째는 %2행입니다</translation>
    </message>
</context>
<context>
    <name>exchange.is_in_it_twice</name>
    <message>
        <source>it contains &apos;%1&apos; twice</source>
        <translation>&apos;%1&apos;이(가) 두 번 들어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.is_no_utf8</name>
    <message>
        <source>it is not a UTF-8 text file</source>
        <translation>UTF-8 텍스트 파일이 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.is_utf16</name>
    <message>
        <source>it is written in UTF-16</source>
        <translation>UTF-16으로 쓰였습니다</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_no_text</name>
    <message>
        <source>a key is not text, or a bracket is not closed</source>
        <translation>키가 텍스트가 아니거나 괄호가 닫히지 않았습니다</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_there_twice</name>
    <message>
        <source>the key &apos;%1&apos; appears twice</source>
        <translation>키 &apos;%1&apos;이(가) 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.key_not_known</name>
    <message>
        <source>the key &apos;%1&apos; is not known</source>
        <translation>키 &apos;%1&apos;을(를) 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_empty</name>
    <message>
        <source>the label is empty</source>
        <translation>이름표가 비어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_there</name>
    <message>
        <source>line %2 already has the label &apos;%1&apos;</source>
        <translation>이름표 &apos;%1&apos;은(는) 이미 %2행에 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_column</name>
    <message>
        <source>it lacks the column %1</source>
        <translation>%1 열이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_header</name>
    <message>
        <source>it lacks the expected header line</source>
        <translation>기대한 머리글 줄이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_confidence</name>
    <message>
        <source>leave out the least confidence</source>
        <translation>최소 신뢰도를 지정하지 마십시오</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_rate</name>
    <message>
        <source>leave out the frame rate</source>
        <translation>프레임 속도를 지정하지 마십시오</translation>
    </message>
</context>
<context>
    <name>exchange.lens_model_not_known</name>
    <message>
        <source>the lens model &apos;%1&apos; is unknown (known models: plumb_bob, rational_polynomial, equidistant)</source>
        <translation>렌즈 모델 &apos;%1&apos;을(를) 알 수 없습니다 (plumb_bob, rational_polynomial, equidistant는 압니다)</translation>
    </message>
</context>
<context>
    <name>exchange.line_too_long</name>
    <message>
        <source>it is longer than 8 MiB</source>
        <translation>8 MiB보다 깁니다</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_class</name>
    <message>
        <source>line %1 has no class for team &apos;%2&apos;</source>
        <translation>%1행에 팀 &apos;%2&apos;의 학급이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_team</name>
    <message>
        <source>line %1 has no team</source>
        <translation>%1행에 팀이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.longer_than_a_week</name>
    <message>
        <source>it is more than a week after the first line</source>
        <translation>첫 행보다 일주일 넘게 뒤입니다</translation>
    </message>
</context>
<context>
    <name>exchange.marks_left_out</name>
    <message>
        <source>%1 positions that only mark a lost robot (such as 0, 0) count as not measured; the first is in line %2</source>
        <translation>로봇을 놓쳤음을 나타내는 위치(0, 0 등) %1개를 측정되지 않은 것으로 처리합니다. 첫 번째는 %2행입니다</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_not_3_by_3</name>
    <message>
        <source>&apos;camera_matrix&apos; is not a 3 × 3 matrix</source>
        <translation>&apos;camera_matrix&apos;가 3 × 3 행렬이 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_of_other_form</name>
    <message>
        <source>&apos;camera_matrix&apos; is not of the form fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>&apos;camera_matrix&apos;가 fx 0 cx, 0 fy cy, 0 0 1 꼴이 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.measured_otherwise</name>
    <message>
        <source>It was analysed with a different course than its task has now.</source>
        <translation>현재 과제의 코스와 다른 코스로 분석되었습니다.</translation>
    </message>
</context>
<context>
    <name>exchange.mend_lines</name>
    <message>
        <source>correct these lines</source>
        <translation>이 줄들을 고치십시오</translation>
    </message>
</context>
<context>
    <name>exchange.name_column_once</name>
    <message>
        <source>name each column once</source>
        <translation>각 열을 한 번만 지정하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_position</name>
    <message>
        <source>track &apos;%1&apos; has %2 position</source>
        <translation>궤적 &apos;%1&apos;에 위치가 %2개 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_positions</name>
    <message>
        <source>track &apos;%1&apos; has %2 positions</source>
        <translation>궤적 &apos;%1&apos;에 위치가 %2개 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.neither_header_nor_tum</name>
    <message>
        <source>it has no header with a time, x and y, and it is not a TUM file</source>
        <translation>시간, x, y가 있는 머리글이 없고 TUM도 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.nested_too_deep</name>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation>%1단계 넘게 중첩되어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_anchors</name>
    <message>
        <source>anchors and aliases are not supported</source>
        <translation>앵커와 별칭은 인식하지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_confidence</name>
    <message>
        <source>it has no column of confidences</source>
        <translation>신뢰도 열이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_header_and_no_times</name>
    <message>
        <source>it has no header, and its columns do not look like time, x and y</source>
        <translation>머리글이 없고 열이 시간, x, y로 보이지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_list_of_numbers</name>
    <message>
        <source>&apos;%1&apos; is not a list of numbers</source>
        <translation>&apos;%1&apos;은(는) 숫자 목록이 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_markers</name>
    <message>
        <source>no markers follow the header</source>
        <translation>머리글 아래에 마커가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_project_inside</name>
    <message>
        <source>it contains no project</source>
        <translation>프로젝트가 들어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_column</name>
    <message>
        <source>this column does not exist</source>
        <translation>그런 열이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_entry</name>
    <message>
        <source>it holds no camera &apos;%1&apos;, but %2</source>
        <translation>카메라 &apos;%1&apos;은(는) 없고 %2이(가) 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_style</name>
    <message>
        <source>this style does not exist</source>
        <translation>그런 형식이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_task</name>
    <message>
        <source>the file holds no task</source>
        <translation>파일에 과제가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_third_axis</name>
    <message>
        <source>it has no third coordinate</source>
        <translation>세 번째 좌표가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_time_column</name>
    <message>
        <source>no column of it is called a time</source>
        <translation>시간으로 이름 붙은 열이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_track_has_position</name>
    <message>
        <source>none of its tracks has a position</source>
        <translation>위치가 있는 궤적이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_toml</name>
    <message>
        <source>it is not valid TOML (%1)</source>
        <translation>올바른 TOML이 아닙니다(%1)</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_xml</name>
    <message>
        <source>it is not valid XML (%1)</source>
        <translation>올바른 XML이 아닙니다(%1)</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_yaml</name>
    <message>
        <source>it is not valid YAML (%1)</source>
        <translation>올바른 YAML이 아닙니다(%1)</translation>
    </message>
</context>
<context>
    <name>exchange.none_sure_enough</name>
    <message>
        <source>none of its positions has a confidence of %1</source>
        <translation>신뢰도가 %1 이상인 위치가 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_finite_number</name>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>&apos;%1&apos;은(는) 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_list</name>
    <message>
        <source>&apos;%1&apos; is not a list in brackets</source>
        <translation>&apos;%1&apos;이(가) 대괄호로 묶은 목록이 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_point</name>
    <message>
        <source>&apos;%1&apos; is not a point [x, y] in mm</source>
        <translation>&apos;%1&apos;은(는) mm 단위의 점 [x, y]가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_time</name>
    <message>
        <source>&apos;%1&apos; is not a time</source>
        <translation>&apos;%1&apos;은(는) 시간이 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_whole_number</name>
    <message>
        <source>&apos;%1&apos; is not a whole number from %2 to %3</source>
        <translation>&apos;%1&apos;은(는) %2에서 %3 사이의 정수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_above_zero</name>
    <message>
        <source>&apos;%1&apos; is not above zero</source>
        <translation>&apos;%1&apos;이(가) 0보다 크지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.not_two_corners</name>
    <message>
        <source>&apos;rectangle_mm&apos; is not two corners</source>
        <translation>&apos;rectangle_mm&apos;가 두 모서리가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.nothing_imported</name>
    <message>
        <source>nothing was imported</source>
        <translation>가져온 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.number_in_two_ways</name>
    <message>
        <source>its numbers can be read in two ways: &apos;%1&apos; with three decimals, or as %2</source>
        <translation>숫자를 두 가지로 읽을 수 있습니다: 소수점 이하 세 자리의 &apos;%1&apos; 또는 %2</translation>
    </message>
</context>
<context>
    <name>exchange.object_expected</name>
    <message>
        <source>it must be an object in braces</source>
        <translation>여기에는 중괄호로 묶은 객체가 있어야 합니다</translation>
    </message>
</context>
<context>
    <name>exchange.one_error_blank</name>
    <message>
        <source>one of its two uncertainties is blank</source>
        <translation>두 오차 중 하나가 비어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.one_place_blank</name>
    <message>
        <source>one of its two coordinates is blank</source>
        <translation>두 위치 중 하나가 비어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.one_time_a_frame</name>
    <message>
        <source>give one time for each frame, in the order of the frames, under a name such as t_s</source>
        <translation>프레임 순서대로 프레임마다 시간 하나를 t_s 같은 이름으로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.order_lines</name>
    <message>
        <source>sort the lines by time, with each time only once</source>
        <translation>행을 시간 순으로, 각 시간이 한 번씩만 나오게 하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric</name>
    <message>
        <source>own metric &apos;%1&apos;</source>
        <translation>사용자 지표 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_choose</name>
    <message>
        <source>choose from %1</source>
        <translation>%1 중에서 고르세요</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_input</name>
    <message>
        <source>no trial has a metric or variable &apos;%1&apos;</source>
        <translation>&apos;%1&apos;(이)라는 지표나 변수가 있는 시행이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_known</name>
    <message>
        <source>Odograph has a metric of that name</source>
        <translation>Odograph에 그 이름의 지표가 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_long</name>
    <message>
        <source>its name or unit has more than 60 characters</source>
        <translation>이름이나 단위가 60자를 넘습니다</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_name</name>
    <message>
        <source>give it a name of letters, digits and _</source>
        <translation>글자, 숫자, _로 된 이름을 붙이세요</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_no_word</name>
    <message>
        <source>its name is not a single word</source>
        <translation>이름이 한 단어가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_other</name>
    <message>
        <source>give it another name</source>
        <translation>다른 이름을 붙이세요</translation>
    </message>
</context>
<context>
    <name>exchange.own_metric_twice</name>
    <message>
        <source>a metric or variable has that name</source>
        <translation>그 이름의 지표나 변수가 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.pack</name>
    <message>
        <source>pack &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 묶기</translation>
    </message>
</context>
<context>
    <name>exchange.packing</name>
    <message>
        <source>packing %1</source>
        <translation>%1 묶는 중</translation>
    </message>
</context>
<context>
    <name>exchange.path_given_twice</name>
    <message>
        <source>the reference path has more than one shape</source>
        <translation>기준 경로가 두 번 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>exchange.path_not_given</name>
    <message>
        <source>the reference path has no shape</source>
        <translation>기준 경로가 주어지지 않았습니다</translation>
    </message>
</context>
<context>
    <name>exchange.pixel_is</name>
    <message>
        <source>a pixel is %1</source>
        <translation>픽셀 하나는 %1입니다</translation>
    </message>
</context>
<context>
    <name>exchange.place_too_far</name>
    <message>
        <source>its position is more than 100 km away</source>
        <translation>위치가 100 km 넘게 떨어져 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.points_group_thousands</name>
    <message>
        <source>points separate thousands</source>
        <translation>점이 천 단위를 구분합니다</translation>
    </message>
</context>
<context>
    <name>exchange.positions_are_pixels</name>
    <message>
        <source>its positions are in pixels, which are no lengths</source>
        <translation>위치가 픽셀 단위이며, 픽셀은 길이가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.positions_as_metres</name>
    <message>
        <source>its positions have no unit and were read as metres</source>
        <translation>위치에 단위가 없어 미터로 읽었습니다</translation>
    </message>
</context>
<context>
    <name>exchange.quoted_cell_does_not_end</name>
    <message>
        <source>a quoted cell does not end</source>
        <translation>따옴표로 시작한 셀이 끝나지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.rate_beside_times</name>
    <message>
        <source>it has times, and no frame numbers</source>
        <translation>프레임 번호가 아니라 시각이 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.reading_line</name>
    <message>
        <source>reading line %1</source>
        <translation>%1행 읽는 중</translation>
    </message>
</context>
<context>
    <name>exchange.roster</name>
    <message>
        <source>roster &apos;%1&apos;</source>
        <translation>명단 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.roster_is_empty</name>
    <message>
        <source>it has no team</source>
        <translation>팀이 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.row_without_time</name>
    <message>
        <source>line %1 was left out, because it has no time</source>
        <translation>%1행은 시각이 없어 제외했습니다</translation>
    </message>
</context>
<context>
    <name>exchange.rows_without_time</name>
    <message>
        <source>%1 lines were left out, because they have no time; the first is line %2</source>
        <translation>시각이 없는 %1개 행을 제외했습니다. 첫 번째는 %2행입니다</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_csv_utf8</name>
    <message>
        <source>save it again as &quot;CSV UTF-8&quot; or as a UTF-8 text</source>
        <translation>&quot;CSV UTF-8&quot;이나 UTF-8 텍스트로 다시 저장하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_utf8</name>
    <message>
        <source>save it again as UTF-8 text</source>
        <translation>UTF-8 텍스트로 다시 저장하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas</name>
    <message>
        <source>save it with commas</source>
        <translation>쉼표로 구분해 저장하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas_and_points</name>
    <message>
        <source>save it with commas, and with a point in its numbers</source>
        <translation>쉼표로 구분하고 숫자에는 점을 써서 저장하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.separated_by_semicolons</name>
    <message>
        <source>its columns are separated by semicolons</source>
        <translation>열이 세미콜론으로 구분되어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.several_cameras</name>
    <message>
        <source>it holds several cameras: %1</source>
        <translation>카메라가 여러 대 들어 있습니다: %1</translation>
    </message>
</context>
<context>
    <name>exchange.several_documents</name>
    <message>
        <source>it holds more than one document</source>
        <translation>문서가 둘 이상 들어 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.sides_exchanged</name>
    <message>
        <source>its width and height are exchanged: the image centre (%1, %2) is that of %4 × %3 pixels, not %3 × %4</source>
        <translation>너비와 높이가 바뀌었습니다: 이미지 중심(%1, %2)은 %3 × %4가 아니라 %4 × %3 픽셀의 중심입니다</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_not_above_zero</name>
    <message>
        <source>its uncertainty &apos;%1&apos; is not above zero</source>
        <translation>불확도 &apos;%1&apos;이(가) 0보다 크지 않습니다</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_or_blank</name>
    <message>
        <source>give the standard deviation of each position, or leave these cells blank</source>
        <translation>각 위치의 표준 편차를 적거나 이 셀들을 비워 두십시오</translation>
    </message>
</context>
<context>
    <name>exchange.slalom_without_length</name>
    <message>
        <source>the slalom ends where it starts</source>
        <translation>슬랄롬의 끝이 시작과 같은 곳입니다</translation>
    </message>
</context>
<context>
    <name>exchange.stamp_left_out</name>
    <message>
        <source>line %1 was left out, because its time repeats or is out of order</source>
        <translation>%1행은 시각이 반복되거나 순서에 맞지 않아 제외했습니다</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_left_out</name>
    <message>
        <source>%1 lines were left out, because their times repeat or are out of order; the first is line %2</source>
        <translation>시각이 반복되거나 순서에 맞지 않는 %1개 행을 제외했습니다. 첫 번째는 %2행입니다</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_shared</name>
    <message>
        <source>its times are so coarse that %1 lines share theirs with the line before</source>
        <translation>시각이 너무 거칠어 %1개 행이 앞 행과 같은 시각을 가집니다</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, %2 frames/s</source>
        <translation>시각이 %1로 반올림되어 있어 행을 고르게 배치했습니다. 초당 %2프레임</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread_with_gaps</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, with gaps</source>
        <translation>시각이 %1로 반올림되어 있어 빈 구간을 두고 행을 고르게 배치했습니다</translation>
    </message>
</context>
<context>
    <name>exchange.team_named_again</name>
    <message>
        <source>line %1 names team &apos;%2&apos; again, as line %3</source>
        <translation>%1행에 팀 &apos;%2&apos;이(가) %3행에 이어 다시 나옵니다</translation>
    </message>
</context>
<context>
    <name>exchange.time_goes_back</name>
    <message>
        <source>its time is earlier than in the line before</source>
        <translation>시간이 앞 행보다 이릅니다</translation>
    </message>
</context>
<context>
    <name>exchange.time_of_no_age</name>
    <message>
        <source>its time is more than a century from 1970</source>
        <translation>시각이 1970년에서 100년 넘게 떨어져 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.time_repeated</name>
    <message>
        <source>its time is the same as in the line before</source>
        <translation>시간이 앞 행과 같습니다</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_long</name>
    <message>
        <source>if its times are seconds, the rows are %1 apart and the run is %2 long</source>
        <translation>시각이 초라면 행 간격이 %1이고 주행 시간이 %2입니다</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_short</name>
    <message>
        <source>its times have no unit, and as seconds the rows would be %1 apart</source>
        <translation>시각에 단위가 없으며, 초라면 행 간격이 %1이 됩니다</translation>
    </message>
</context>
<context>
    <name>exchange.timecode_without_rate</name>
    <message>
        <source>the last part of its times counts frames, up to %1 a second</source>
        <translation>시각의 마지막 부분은 초당 최대 %1개의 프레임을 셉니다</translation>
    </message>
</context>
<context>
    <name>exchange.times_by_rate</name>
    <message>
        <source>all its times are the same; the lines were spread at %1 frames/s</source>
        <translation>모든 시각이 같아 초당 %1프레임으로 행을 배치했습니다</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_days</name>
    <message>
        <source>times in days, as spreadsheets write them</source>
        <translation>스프레드시트처럼 일 단위로 쓴 시각</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_two_ways</name>
    <message>
        <source>its times can be read in two ways: &apos;%1&apos; with three decimals, or without</source>
        <translation>시간을 두 가지로 읽을 수 있습니다: 소수점 이하 세 자리의 &apos;%1&apos; 또는 소수 없이</translation>
    </message>
</context>
<context>
    <name>exchange.times_since_1970</name>
    <message>
        <source>times in %1 since 1970</source>
        <translation>1970년부터 센 시각, 단위 %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_as_said</name>
    <message>
        <source>in the units that it gives, the robot would drive at %1</source>
        <translation>적힌 단위대로라면 로봇이 %1로 달린 것이 됩니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the robot would drive at %1</source>
        <translation>위치에 단위가 없으며, 미터라면 로봇이 %1로 달린 것이 됩니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_files</name>
    <message>
        <source>it has too many files</source>
        <translation>파일이 너무 많습니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_places</name>
    <message>
        <source>the file has more than 1.5 million positions</source>
        <translation>파일에 위치가 150만 개보다 많습니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_tracks</name>
    <message>
        <source>the file has more than 1000 tracks</source>
        <translation>파일에 궤적이 1000개 넘게 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_values</name>
    <message>
        <source>it holds more than %1 values</source>
        <translation>값이 %1개를 넘습니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_small_as_said</name>
    <message>
        <source>in the unit that its header gives, its positions stay within %1</source>
        <translation>머리글에 적힌 단위대로라면 위치가 %1 안에 머뭅니다</translation>
    </message>
</context>
<context>
    <name>exchange.too_wide_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the floor would be %1 wide</source>
        <translation>위치에 단위가 없으며, 미터라면 바닥의 폭이 %1이 됩니다</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_position</name>
    <message>
        <source>the track has %1 position</source>
        <translation>궤적에 위치가 %1개 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_positions</name>
    <message>
        <source>the track has %1 positions</source>
        <translation>궤적에 위치가 %1개 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entries</name>
    <message>
        <source>it has %1 entries instead of the 8 of TUM</source>
        <translation>항목이 TUM의 8개가 아니라 %1개입니다</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entry</name>
    <message>
        <source>it has %1 entry instead of the 8 of TUM</source>
        <translation>항목이 TUM의 8개가 아니라 %1개입니다</translation>
    </message>
</context>
<context>
    <name>exchange.twins_left_out</name>
    <message>
        <source>%1 lines were left out, because they repeat the line before</source>
        <translation>앞 행을 반복하는 %1개 행을 제외했습니다</translation>
    </message>
</context>
<context>
    <name>exchange.unit_not_known</name>
    <message>
        <source>its column &apos;%1&apos; is in a unit that is not known</source>
        <translation>&apos;%1&apos; 열의 단위를 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>exchange.unpack</name>
    <message>
        <source>unpack &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 풀기</translation>
    </message>
</context>
<context>
    <name>exchange.unpack_into</name>
    <message>
        <source>unpack into &apos;%1&apos;</source>
        <translation>&apos;%1&apos;에 풀기</translation>
    </message>
</context>
<context>
    <name>exchange.unpacking</name>
    <message>
        <source>unpacking</source>
        <translation>푸는 중</translation>
    </message>
</context>
<context>
    <name>exchange.unpacks_too_large</name>
    <message>
        <source>it unpacks to more than a hundred times its size</source>
        <translation>풀면 크기가 백 배 넘게 커집니다</translation>
    </message>
</context>
<context>
    <name>exchange.unset_stamps</name>
    <message>
        <source>lines left out because their time is 0: %1</source>
        <translation>시각이 0이어서 제외한 행: %1</translation>
    </message>
</context>
<context>
    <name>exchange.unsure_left_out</name>
    <message>
        <source>%1 positions with a confidence below %2 count as not measured; the first is in line %3</source>
        <translation>신뢰도가 %2 미만인 위치 %1개를 측정되지 않은 것으로 처리합니다. 첫 번째는 %3행입니다</translation>
    </message>
</context>
<context>
    <name>exchange.use_calibration_file</name>
    <message>
        <source>use a calibration file as ROS, OpenCV, Kalibr, COLMAP, Metashape, anipose or PhotonVision writes it</source>
        <translation>ROS, OpenCV, Kalibr, COLMAP, Metashape, anipose 또는 PhotonVision이 저장한 보정 파일을 사용하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.use_keys</name>
    <message>
        <source>use %1</source>
        <translation>%1을(를) 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.wait_for_writers</name>
    <message>
        <source>wait until no program writes to it, and try again</source>
        <translation>아무도 쓰지 않을 때까지 기다린 뒤 다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_class_and_team</name>
    <message>
        <source>write a line with class and team below the header</source>
        <translation>머리글 아래에 학급과 팀을 한 줄 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_decimal_point</name>
    <message>
        <source>write them with a decimal point</source>
        <translation>소수점(.)으로 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits</name>
    <message>
        <source>write it with digits, like 12.5</source>
        <translation>12.5처럼 숫자로 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits_or_blank</name>
    <message>
        <source>write it with digits, like 12.5, or leave the cell blank</source>
        <translation>12.5처럼 숫자로 쓰거나 비워 두십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_finer_times</name>
    <message>
        <source>write the times with more digits, or give the frame rate of an even series</source>
        <translation>시각을 더 많은 자릿수로 기록하거나 일정한 간격의 프레임 속도를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_line_for_marker</name>
    <message>
        <source>write one line for each marker</source>
        <translation>마커마다 한 줄씩 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_object_with</name>
    <message>
        <source>write one with %1</source>
        <translation>%1(으)로 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_task_as_shown</name>
    <message>
        <source>write the task as odograph task list --json shows one</source>
        <translation>테스트베드에서 과제를 만들거나 설명서에 나온 대로 파일을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_tum_or_header</name>
    <message>
        <source>write %1, or begin the file with the line %2</source>
        <translation>%1을(를) 쓰거나 파일을 %2 행으로 시작하십시오</translation>
    </message>
</context>
<context>
    <name>exchange.write_value_for_each</name>
    <message>
        <source>write one value for each of %1</source>
        <translation>%1마다 값을 하나씩 쓰십시오</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_cells</name>
    <message>
        <source>it has %1 cells instead of %2</source>
        <translation>셀이 %2개가 아니라 %1개입니다</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_numbers</name>
    <message>
        <source>&apos;%1&apos; has %2 numbers instead of %3 × %4</source>
        <translation>&apos;%1&apos;에 수가 %3 × %4개가 아니라 %2개 있습니다</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_poles</name>
    <message>
        <source>&apos;poles&apos; is not a whole number from 1 to 100</source>
        <translation>&apos;poles&apos;가 1에서 100 사이의 정수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>exchange.zone_given_twice</name>
    <message>
        <source>the zone has more than one shape</source>
        <translation>구역이 두 번 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>exchange.zone_not_given</name>
    <message>
        <source>the zone has no shape</source>
        <translation>구역이 주어지지 않았습니다</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_looked_at</name>
    <message>
        <source>it cannot be accessed (%1)</source>
        <translation>살펴볼 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_read</name>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>읽을 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_written</name>
    <message>
        <source>it cannot be written (%1)</source>
        <translation>쓸 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_write</name>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>&apos;%1&apos;을(를) 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>files.check_file_is_there</name>
    <message>
        <source>check that the file exists and that you may read it</source>
        <translation>파일이 있고 읽을 수 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>files.check_its_folder</name>
    <message>
        <source>check the free space and the permissions of its folder</source>
        <translation>그 폴더의 여유 공간과 권한을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>files.check_may_be_read</name>
    <message>
        <source>check that you may read the file</source>
        <translation>파일을 읽을 권한을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>files.check_name</name>
    <message>
        <source>check the name and the folder</source>
        <translation>이름과 폴더를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_another_file</name>
    <message>
        <source>choose another file</source>
        <translation>다른 파일을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_another_folder</name>
    <message>
        <source>choose another folder</source>
        <translation>다른 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_another_name</name>
    <message>
        <source>choose another name</source>
        <translation>다른 이름을 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_folder_with_room</name>
    <message>
        <source>choose a folder that you may write to and that has free space</source>
        <translation>쓸 수 있고 여유가 있는 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_name_or_folder</name>
    <message>
        <source>choose another name or folder</source>
        <translation>다른 이름이나 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_shorter_name</name>
    <message>
        <source>choose a shorter name</source>
        <translation>더 짧은 이름을 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.choose_writable_folder</name>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>쓸 수 있는 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.disk_is_full</name>
    <message>
        <source>the disk is full</source>
        <translation>디스크가 가득 찼습니다</translation>
    </message>
</context>
<context>
    <name>files.file_is_empty</name>
    <message>
        <source>the file is empty</source>
        <translation>파일이 비어 있습니다</translation>
    </message>
</context>
<context>
    <name>files.folder_cannot_be_used</name>
    <message>
        <source>its folder cannot be used (%1)</source>
        <translation>그 폴더를 쓸 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>files.folder_not_writable</name>
    <message>
        <source>the folder &apos;%1&apos; cannot be written to (%2)</source>
        <translation>폴더 &apos;%1&apos;에 쓸 수 없습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>files.has_no_name</name>
    <message>
        <source>it has no name</source>
        <translation>이름이 없습니다</translation>
    </message>
</context>
<context>
    <name>files.is_a_database</name>
    <message>
        <source>it is a database</source>
        <translation>데이터베이스입니다</translation>
    </message>
</context>
<context>
    <name>files.is_another_project</name>
    <message>
        <source>it is another project</source>
        <translation>다른 프로젝트입니다</translation>
    </message>
</context>
<context>
    <name>files.is_beside_project</name>
    <message>
        <source>it is the log, the lock or a backup of a project</source>
        <translation>프로젝트의 로그, 잠금 또는 백업 파일입니다</translation>
    </message>
</context>
<context>
    <name>files.is_in_media_folder</name>
    <message>
        <source>it is in the media folder of project &apos;%1&apos;</source>
        <translation>프로젝트 &apos;%1&apos;의 미디어 폴더에 있습니다</translation>
    </message>
</context>
<context>
    <name>files.is_in_some_media_folder</name>
    <message>
        <source>it is in a media folder beside a project</source>
        <translation>프로젝트 옆의 미디어 폴더 안에 있습니다</translation>
    </message>
</context>
<context>
    <name>files.is_input</name>
    <message>
        <source>it is an input of the same command</source>
        <translation>같은 호출의 입력 파일입니다</translation>
    </message>
</context>
<context>
    <name>files.is_of_another_kind</name>
    <message>
        <source>a file of another kind has that name</source>
        <translation>다른 종류의 파일이 그 이름을 쓰고 있습니다</translation>
    </message>
</context>
<context>
    <name>files.is_open_project</name>
    <message>
        <source>it is a project that is open here</source>
        <translation>여기에서 열려 있는 프로젝트입니다</translation>
    </message>
</context>
<context>
    <name>files.is_temporary_name</name>
    <message>
        <source>Odograph uses such names for temporary files</source>
        <translation>Odograph가 임시 파일에 쓰는 이름입니다</translation>
    </message>
</context>
<context>
    <name>files.is_the_project</name>
    <message>
        <source>it is the project itself</source>
        <translation>프로젝트 파일 자체입니다</translation>
    </message>
</context>
<context>
    <name>files.is_there_already</name>
    <message>
        <source>it already exists</source>
        <translation>이미 있습니다</translation>
    </message>
</context>
<context>
    <name>files.log_left_beside</name>
    <message>
        <source>its folder has &apos;%1&apos;, the log or journal of another file of this name</source>
        <translation>폴더에 &apos;%1&apos;이(가) 있습니다. 이름이 같은 다른 파일의 로그 또는 저널입니다</translation>
    </message>
</context>
<context>
    <name>files.make_folder_first</name>
    <message>
        <source>create the folder first, or choose another one</source>
        <translation>먼저 폴더를 만들거나 다른 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>files.make_room</name>
    <message>
        <source>free some disk space and try again</source>
        <translation>디스크 공간을 확보하고 다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>files.move_log_away</name>
    <message>
        <source>choose another name, or move &apos;%1&apos; to another folder first</source>
        <translation>다른 이름을 선택하거나 먼저 &apos;%1&apos;을(를) 다른 폴더로 옮기십시오</translation>
    </message>
</context>
<context>
    <name>files.name_a_file</name>
    <message>
        <source>give a file name</source>
        <translation>파일을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>files.name_too_long</name>
    <message>
        <source>its name is too long</source>
        <translation>이름이 너무 깁니다</translation>
    </message>
</context>
<context>
    <name>files.names_a_project</name>
    <message>
        <source>only projects have a name ending in .odo</source>
        <translation>.odo로 끝나는 이름은 프로젝트용입니다</translation>
    </message>
</context>
<context>
    <name>files.no_such_file</name>
    <message>
        <source>the file does not exist</source>
        <translation>그런 파일이 없습니다</translation>
    </message>
</context>
<context>
    <name>files.no_such_folder</name>
    <message>
        <source>folder &apos;%1&apos; does not exist</source>
        <translation>폴더 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>files.replace_by_force</name>
    <message>
        <source>choose another name, or replace it with --force</source>
        <translation>다른 이름을 고르거나 먼저 파일을 지우십시오</translation>
    </message>
</context>
<context>
    <name>files.unreadable</name>
    <message>
        <source>it cannot be read</source>
        <translation>읽을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>geometry.add_points</name>
    <message>
        <source>add points</source>
        <translation>점을 추가하십시오</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place</name>
    <message>
        <source>%1 have the same position</source>
        <translation>%1이(가) 한곳에 있습니다</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place_in_picture</name>
    <message>
        <source>%1 have the same position in the image</source>
        <translation>%1이(가) 화면에서 한곳에 있습니다</translation>
    </message>
</context>
<context>
    <name>geometry.beyond_horizon</name>
    <message>
        <source>%1 would be beyond the horizon</source>
        <translation>%1이(가) 지평선 너머에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>geometry.bow_tie</name>
    <message>
        <source>the order of the points crosses over like a bow tie</source>
        <translation>점의 순서가 나비넥타이처럼 엇갈립니다</translation>
    </message>
</context>
<context>
    <name>geometry.calibrate_again</name>
    <message>
        <source>calibrate the camera again, or import another file</source>
        <translation>카메라를 다시 보정하거나 다른 파일을 가져오십시오</translation>
    </message>
</context>
<context>
    <name>geometry.check_points</name>
    <message>
        <source>check which point is which</source>
        <translation>어느 점이 어느 점인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>geometry.coordinate_not_finite</name>
    <message>
        <source>a coordinate of %1 is not a finite number</source>
        <translation>%1의 좌표가 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>geometry.correct_it</name>
    <message>
        <source>correct it</source>
        <translation>고치십시오</translation>
    </message>
</context>
<context>
    <name>geometry.correct_one</name>
    <message>
        <source>correct one of them</source>
        <translation>그중 하나를 고치십시오</translation>
    </message>
</context>
<context>
    <name>geometry.empty_chain</name>
    <message>
        <source>the chain has no links</source>
        <translation>연결 단계가 없습니다</translation>
    </message>
</context>
<context>
    <name>geometry.focal_not_positive</name>
    <message>
        <source>the focal length %1 is not positive</source>
        <translation>초점 거리 %1가 양수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>geometry.four_points_needed</name>
    <message>
        <source>four points are needed, %1 given</source>
        <translation>점이 네 개 필요한데 %1개가 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>geometry.give_one_link</name>
    <message>
        <source>give at least one</source>
        <translation>하나 이상 주십시오</translation>
    </message>
</context>
<context>
    <name>geometry.intrinsics_unusable</name>
    <message>
        <source>these intrinsics cannot be used</source>
        <translation>이 내부 파라미터는 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>geometry.no_homography</name>
    <message>
        <source>no homography</source>
        <translation>호모그래피를 구할 수 없음</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line</name>
    <message>
        <source>%1 lie on one line</source>
        <translation>%1이(가) 한 줄에 있습니다</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line_in_picture</name>
    <message>
        <source>%1 lie on one line in the image</source>
        <translation>%1이(가) 화면에서 한 줄에 있습니다</translation>
    </message>
</context>
<context>
    <name>geometry.point</name>
    <message>
        <source>point %1</source>
        <translation>점 %1</translation>
    </message>
</context>
<context>
    <name>geometry.points_do_not_tell</name>
    <message>
        <source>the points do not determine it</source>
        <translation>점들로 정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>geometry.singular_link</name>
    <message>
        <source>link %1 of %2 of the chain is singular</source>
        <translation>연결 %2단계 중 %1번째가 특이합니다</translation>
    </message>
</context>
<context>
    <name>geometry.size_not_positive</name>
    <message>
        <source>the image size %1 is not positive</source>
        <translation>사진 크기 %1이(가) 양수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>geometry.spread_points</name>
    <message>
        <source>spread the points</source>
        <translation>점을 넓게 잡으십시오</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points</name>
    <message>
        <source>use four points of which no three are in line</source>
        <translation>어느 셋도 한 줄에 있지 않은 점 네 개를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points_in_it</name>
    <message>
        <source>use four points in it of which no three are in line</source>
        <translation>어느 셋도 한 줄에 있지 않은 점 네 개를 그 단계에 쓰십시오</translation>
    </message>
</context>
<context>
    <name>geometry.value_not_finite</name>
    <message>
        <source>one of the values is not a finite number</source>
        <translation>값 하나가 유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_coefficients</name>
    <message>
        <source>this lens model does not take %1 distortion coefficients</source>
        <translation>왜곡 계수 %1개는 이 렌즈 모델에 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_covariance_size</name>
    <message>
        <source>the covariance has the wrong size</source>
        <translation>공분산의 크기가 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>odo::AccuracyDialog</name>
    <message>
        <source>may hang &amp;over the floor</source>
        <translation>바닥 위에 매달 수 있음(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Plan a camera</source>
        <translation>카메라 계획(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>제거(&amp;R)</translation>
    </message>
    <message>
        <source>Find &amp;best position</source>
        <translation>최적 위치(&amp;B)</translation>
    </message>
    <message>
        <source>Expected accuracy</source>
        <translation>예상 정확도</translation>
    </message>
    <message>
        <source>Expected accuracy in words</source>
        <translation>예상 정확도(글)</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>문제점</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Cameras included</source>
        <translation>계산에 넣는 카메라</translation>
    </message>
    <message>
        <source>All ticked cameras (joint)</source>
        <translation>선택한 모든 카메라 함께</translation>
    </message>
    <message>
        <source>The chosen camera alone</source>
        <translation>선택한 카메라만</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>표시(&amp;W)</translation>
    </message>
    <message>
        <source>Height of the robo&amp;t</source>
        <translation>로봇 높이(&amp;T)</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>On a ceiling, for example; a tripod would be in the robots&apos; way</source>
        <translation>천장에 다는 경우처럼; 삼각대는 로봇의 길을 막습니다</translation>
    </message>
    <message>
        <source>Moves the camera to where it, together with the other ticked cameras, minimises the largest uncertainty on the floor</source>
        <translation>선택한 다른 카메라와 함께 볼 때 바닥에서 가장 부정확한 곳이 가장 정확해지는 위치에 카메라를 놓습니다</translation>
    </message>
    <message>
        <source>Margin beyond the &amp;markers</source>
        <translation>마커 바깥 여유(&amp;M)</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>계획한 카메라</translation>
    </message>
    <message>
        <source>%1, registered %2</source>
        <translation>%1, 정합 %2</translation>
    </message>
    <message>
        <source>Planned %1</source>
        <translation>계획 %1</translation>
    </message>
    <message>
        <source>%1: %2; %3.</source>
        <translation>%1: %2; %3.</translation>
    </message>
    <message>
        <source>Searching for the best position…</source>
        <translation>최적 위치를 찾는 중…</translation>
    </message>
    <message>
        <source>&amp;Advice</source>
        <translation>조언(&amp;A)</translation>
    </message>
    <message>
        <source>Which registered camera to move: tries other positions within a metre of each</source>
        <translation>어느 정합된 카메라를 옮길지: 각 카메라에서 1 m 이내의 다른 위치를 시험합니다</translation>
    </message>
    <message>
        <source>Advice in words</source>
        <translation>글로 된 조언</translation>
    </message>
    <message>
        <source>Trying other positions of the cameras…</source>
        <translation>다른 카메라 위치를 시험하는 중…</translation>
    </message>
    <message>
        <source>%1, moved</source>
        <translation>%1, 옮김</translation>
    </message>
    <message>
        <source>Moving one camera lowers the largest error by less than a tenth.</source>
        <translation>카메라 하나를 옮겨도 가장 큰 오차는 10분의 1도 줄지 않습니다.</translation>
    </message>
</context>
<context>
    <name>odo::BackupsDialog</name>
    <message>
        <source>What restoring would change</source>
        <translation>복원하면 바뀌는 것</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>메시지</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>지금 백업(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Restore this backup</source>
        <translation>이 백업 복원(&amp;R)</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>백업</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>백업 폴더</translation>
    </message>
    <message>
        <source>Backups are in %1. They contain everything except the videos.</source>
        <translation>백업은 %1에 있습니다. 비디오를 제외한 모든 것이 들어 있습니다.</translation>
    </message>
    <message numerus="yes">
        <source>One is made each day on which you open the project, and kept for %n day(s).</source>
        <translation>
            <numerusform>프로젝트를 여는 날마다 하나씩 만들고 %n일 동안 보관합니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Daily backups are switched off in the preferences.</source>
        <translation>매일 백업이 환경설정에서 꺼져 있습니다.</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>폴더 열기(&amp;O)</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Changes since this backup</source>
        <translation>이 백업 이후의 변경</translation>
    </message>
    <message>
        <source>%1, before an update</source>
        <translation>%1, 업데이트 전</translation>
    </message>
    <message>
        <source>No backup yet.</source>
        <translation>아직 백업이 없습니다.</translation>
    </message>
    <message>
        <source>Reading the backup…</source>
        <translation>백업을 읽는 중…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) in this backup.</source>
        <translation>
            <numerusform>이 백업에는 시행이 %n개 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without: %1</source>
        <translation>없는 것: %1</translation>
    </message>
    <message>
        <source>With, though deleted since: %1</source>
        <translation>이후 삭제되었으나 들어 있는 것: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n of its video(s) no longer exist.</source>
        <translation>
            <numerusform>비디오 %n개가 더 이상 없습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring it discards no changes.</source>
        <translation>복원해도 버려지는 변경이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>Restoring it discards %n change(s) made since:</source>
        <translation>
            <numerusform>복원하면 이후의 변경 %n건이 버려집니다:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It brings back %n change(s).</source>
        <translation>
            <numerusform>변경 %n건이 되돌아옵니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::Badge</name>
    <message>
        <source>not registered</source>
        <translation>정합 안 됨</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>%1 이동함</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>마커 %1 이동함</translation>
    </message>
    <message>
        <source>markers not found</source>
        <translation>마커를 찾지 못함</translation>
    </message>
</context>
<context>
    <name>odo::BoardCanvas</name>
    <message>
        <source>Image of the board</source>
        <translation>보드 사진</translation>
    </message>
    <message>
        <source>residuals, longest %1 px</source>
        <translation>잔차, 최대 %1 px</translation>
    </message>
</context>
<context>
    <name>odo::BoardImagesPage</name>
    <message>
        <source>Move it to the left of the image</source>
        <translation>화면 왼쪽으로 옮기십시오</translation>
    </message>
    <message>
        <source>Move it to the right of the image</source>
        <translation>화면 오른쪽으로 옮기십시오</translation>
    </message>
    <message>
        <source>Move it up</source>
        <translation>위로 옮기십시오</translation>
    </message>
    <message>
        <source>Move it down</source>
        <translation>아래로 옮기십시오</translation>
    </message>
    <message>
        <source>Closer to the camera</source>
        <translation>카메라에 더 가까이</translation>
    </message>
    <message>
        <source>Farther from the camera</source>
        <translation>카메라에서 더 멀리</translation>
    </message>
    <message>
        <source>Tilt it: the left side away from the camera</source>
        <translation>기울이십시오: 왼쪽을 카메라에서 멀리</translation>
    </message>
    <message>
        <source>Tilt it: the right side away from the camera</source>
        <translation>기울이십시오: 오른쪽을 카메라에서 멀리</translation>
    </message>
    <message>
        <source>Tilt it: the upper side away from the camera</source>
        <translation>기울이십시오: 위쪽을 카메라에서 멀리</translation>
    </message>
    <message>
        <source>Tilt it: the lower side away from the camera</source>
        <translation>기울이십시오: 아래쪽을 카메라에서 멀리</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>움직이지 말고 들고 계십시오</translation>
    </message>
    <message>
        <source>&amp;Take an image now</source>
        <translation>지금 사진 찍기(&amp;T)</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>할 일</translation>
    </message>
    <message>
        <source>No image from the camera</source>
        <translation>카메라 영상이 없습니다</translation>
    </message>
    <message>
        <source>Rejected images</source>
        <translation>계산에 넣지 않는 사진</translation>
    </message>
    <message>
        <source>Coverage of the images</source>
        <translation>사진이 덮은 범위</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>제외됨</translation>
    </message>
    <message>
        <source>Waiting for the camera…</source>
        <translation>카메라를 기다리는 중…</translation>
    </message>
    <message>
        <source>Detecting the board…</source>
        <translation>보드를 찾는 중…</translation>
    </message>
    <message>
        <source>Hold the board before the camera</source>
        <translation>보드를 카메라 앞에 드십시오</translation>
    </message>
    <message>
        <source>Detecting the board</source>
        <translation>보드를 찾는 중</translation>
    </message>
    <message>
        <source>Odograph takes an image whenever the board is still, sharp and in a new position.</source>
        <translation>보드가 정지해 있고 선명하며 새로운 위치에 있을 때마다 저절로 사진을 찍습니다.</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>찍음</translation>
    </message>
    <message>
        <source>Now the dashed outline shows where the board would help most.</source>
        <translation>이제 점선 윤곽이 보드를 두면 가장 도움이 되는 곳을 나타냅니다.</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>%1장 남음</translation>
    </message>
    <message>
        <source>No image accepted</source>
        <translation>쓸 수 있는 사진이 없습니다</translation>
    </message>
    <message>
        <source>See the reasons on the right. Drop other images here to add them.</source>
        <translation>이유는 오른쪽에 있습니다. 다른 사진을 여기에 끌어다 놓으십시오.</translation>
    </message>
    <message>
        <source>All images checked</source>
        <translation>모두 살펴봄</translation>
    </message>
    <message>
        <source>They are enough.</source>
        <translation>충분합니다.</translation>
    </message>
    <message>
        <source>Drop more images here; the bars show what is missing.</source>
        <translation>사진을 여기에 더 끌어다 놓을 수 있습니다. 막대는 무엇이 모자라는지 나타냅니다.</translation>
    </message>
</context>
<context>
    <name>odo::BoardSearchWorker</name>
    <message>
        <source>image %1</source>
        <translation>사진 %1</translation>
    </message>
    <message>
        <source>none of its images shows a board that is still, sharp and in a new position</source>
        <translation>정지해 있고 선명하며 새로운 자세의 보드가 담긴 사진이 없음</translation>
    </message>
    <message>
        <source>it cannot be read any more</source>
        <translation>더 이상 읽을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>odo::BoxCanvas</name>
    <message>
        <source>Video frame; arrow keys move the box round the robot, Shift + arrow keys resize it</source>
        <translation>영상; 화살표 키로 로봇을 둘러싼 상자를 옮기고 Shift와 함께 누르면 크기를 바꿉니다</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationResultPage</name>
    <message>
        <source>ordinary</source>
        <translation>일반</translation>
    </message>
    <message>
        <source>wide (rational)</source>
        <translation>광각(유리 함수)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>어안</translation>
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
        <translation>판정</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>계산 중</translation>
    </message>
    <message>
        <source>Automatic choice of the lens model</source>
        <translation>렌즈 모델 자동 선택</translation>
    </message>
    <message>
        <source>Ordinary lens</source>
        <translation>일반 렌즈</translation>
    </message>
    <message>
        <source>Wide lens (rational model)</source>
        <translation>광각 렌즈(유리 함수 모델)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>어안 렌즈</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>렌즈 모델</translation>
    </message>
    <message>
        <source>Select a bar to see its image.</source>
        <translation>막대를 선택하면 그 사진이 나옵니다.</translation>
    </message>
    <message>
        <source>Appears here after the calibration.</source>
        <translation>렌즈를 알게 되면 여기에 나옵니다.</translation>
    </message>
    <message>
        <source>Image and &amp;residuals</source>
        <translation>사진과 잔차(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Straightened</source>
        <translation>왜곡 제거(&amp;S)</translation>
    </message>
    <message>
        <source>Error by image</source>
        <translation>사진별 오차</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>렌즈</translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>렌즈 정보</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>계산 중…</translation>
    </message>
    <message>
        <source>straight edges must be straight</source>
        <translation>곧은 모서리는 곧게 보여야 합니다</translation>
    </message>
    <message>
        <source>Storing the lens calibration and its images…</source>
        <translation>렌즈와 사진을 저장하는 중…</translation>
    </message>
    <message>
        <source>The lens calibration was not stored. %1</source>
        <translation>렌즈를 저장하지 못했습니다. %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>모델</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>사진</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2장 중 %1장</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>보드 오차</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>교차 검증 오차</translation>
    </message>
    <message>
        <source>needs six images</source>
        <translation>사진이 여섯 장 필요함</translation>
    </message>
    <message>
        <source>Corners left out</source>
        <translation>제외한 꼭짓점</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>초점 거리</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>중심 x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>중심 y</translation>
    </message>
    <message>
        <source>above the threshold</source>
        <translation>기준값 초과</translation>
    </message>
    <message>
        <source>Images left out</source>
        <translation>제외한 사진</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationSourcePage</name>
    <message>
        <source>&amp;From the camera: hold up the board, Odograph takes the images</source>
        <translation>카메라 앞에서: 보드를 들고 있으면 저절로 사진을 찍음(&amp;F)</translation>
    </message>
    <message>
        <source>From existing images or a &amp;video</source>
        <translation>찍어 둔 사진이나 동영상에서(&amp;P)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Prin&amp;t a board…</source>
        <translation>보드 인쇄(&amp;T)…</translation>
    </message>
    <message>
        <source>Show a flat calibration board from many sides to calibrate the lens. Odograph recognises checkerboard and ChArUco boards of any size. Measure one square on the paper: every later length depends on it. Do not refocus or zoom afterwards.</source>
        <translation>정사각형이 그려진 평평한 보드를 여러 방향에서 보면 렌즈가 상을 맺는 방식을 알 수 있습니다. 체커보드든 ChArUco든 크기에 관계없이 종류는 자동으로 알아냅니다. 종이 위의 정사각형 하나를 재십시오. 이후의 모든 길이가 이 값으로 정해집니다. 그 뒤에는 렌즈의 초점이나 줌을 바꾸면 안 됩니다.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>카메라(&amp;C)</translation>
    </message>
    <message>
        <source>Side of a &amp;square, measured</source>
        <translation>잰 정사각형 한 변(&amp;S)</translation>
    </message>
    <message>
        <source>Source of the board images</source>
        <translation>보드 사진을 얻을 곳</translation>
    </message>
    <message>
        <source>Images and videos of the board</source>
        <translation>보드의 사진과 동영상</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>추가(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>제거(&amp;R)</translation>
    </message>
    <message>
        <source>You can also drop files here.</source>
        <translation>파일을 여기에 끌어다 놓을 수도 있습니다.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>카메라에 A와 같은 이름을 붙이십시오.</translation>
    </message>
    <message>
        <source>Connect a camera, or choose existing images.</source>
        <translation>카메라를 연결하거나 기존 이미지를 선택하십시오.</translation>
    </message>
    <message>
        <source>Add images or a video of the board.</source>
        <translation>보드의 이미지나 동영상을 추가하십시오.</translation>
    </message>
</context>
<context>
    <name>odo::CameraChoiceDialog</name>
    <message>
        <source>Cameras to record with</source>
        <translation>녹화에 쓸 카메라</translation>
    </message>
    <message>
        <source>Device for camera %1</source>
        <translation>카메라 %1에 해당하는 장치</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>설정…</translation>
    </message>
    <message>
        <source>Settings of camera %1</source>
        <translation>카메라 %1 설정</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>카메라 %1</translation>
    </message>
    <message>
        <source>&amp;Search again</source>
        <translation>다시 찾기(&amp;L)</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>이대로 사용</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>사용 안 함</translation>
    </message>
    <message>
        <source>in use by another program</source>
        <translation>다른 프로그램에서 사용 중</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1(연결 안 됨)</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>카메라를 찾는 중…</translation>
    </message>
    <message>
        <source>Choose at least one camera. Two cameras locate a robot more accurately, and if one cannot see it, the other often can.</source>
        <translation>카메라를 하나 이상 선택하십시오. 두 대를 쓰면 로봇의 위치를 더 정확히 알 수 있고, 한 대가 로봇을 보지 못하는 동안에도 알 수 있습니다.</translation>
    </message>
    <message>
        <source>You cannot use one device as two cameras.</source>
        <translation>장치 하나를 카메라 두 대로 쓸 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>odo::CameraListModel</name>
    <message>
        <source>not calibrated</source>
        <translation>보정 안 됨</translation>
    </message>
    <message>
        <source>calibrated, ±%1 px</source>
        <translation>보정됨, ±%1 px</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>정합 안 됨</translation>
    </message>
    <message>
        <source>registered, %1</source>
        <translation>정합됨, %1</translation>
    </message>
    <message>
        <source>Calibrate the lens, then register the camera to the floor.</source>
        <translation>렌즈를 보정한 다음 카메라를 바닥에 정합하십시오.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>렌즈</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>바닥</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
</context>
<context>
    <name>odo::CameraPositionDialog</name>
    <message>
        <source>moved %1</source>
        <translation>%1 이동함</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>마커 %1 이동함</translation>
    </message>
    <message>
        <source>has not moved</source>
        <translation>이동하지 않음</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>점검(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>다시 정합(&amp;R)…</translation>
    </message>
    <message>
        <source>Check camera positions</source>
        <translation>카메라 점검</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>New image</source>
        <translation>새 사진</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Registered cameras</source>
        <translation>정합된 카메라</translation>
    </message>
    <message>
        <source>A camera that someone has pushed measures wrong positions without any sign of it. Before the robots run, check each camera&apos;s markers in a new image.</source>
        <translation>부딪혀 밀린 카메라는 틀리게 측정하지만 겉으로는 드러나지 않습니다. 로봇이 주행하기 전에 새 사진에서 각 카메라의 마커를 다시 찾습니다.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Results of the check</source>
        <translation>점검 결과</translation>
    </message>
    <message>
        <source>New image of camera %1</source>
        <translation>카메라 %1의 새 사진</translation>
    </message>
    <message>
        <source>Its newest recording</source>
        <translation>최근 녹화</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>점검 안 함</translation>
    </message>
    <message>
        <source>An image or video…</source>
        <translation>사진 또는 동영상…</translation>
    </message>
    <message>
        <source>detecting…</source>
        <translation>찾는 중…</translation>
    </message>
    <message>
        <source>undetermined</source>
        <translation>판정 불가</translation>
    </message>
    <message>
        <source>At least two markers must be visible. The check changes nothing.</source>
        <translation>마커가 두 개 이상 보여야 합니다. 점검으로 옮겨지거나 바뀌는 것은 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Register %1 again…</source>
        <translation>%1 다시 정합(&amp;R)…</translation>
    </message>
</context>
<context>
    <name>odo::CameraSettingsDialog</name>
    <message>
        <source>set by the camera</source>
        <translation>카메라 기본값</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>fps</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Trigger each frame by software, at the same time for all cameras with this setting</source>
        <translation>프레임마다 촬영을 요청하여 해당 카메라들이 모두 동시에 찍게 합니다</translation>
    </message>
    <message>
        <source>Settings of %1</source>
        <translation>%1 설정</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>형식</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>프레임 속도</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>노출</translation>
    </message>
    <message>
        <source>Software trigger</source>
        <translation>소프트웨어 트리거</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>형식(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>프레임 속도(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Exposure</source>
        <translation>노출(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Trigger</source>
        <translation>트리거(&amp;T)</translation>
    </message>
    <message>
        <source>If the camera does not support a setting, a message says so when it opens.</source>
        <translation>카메라가 할 수 없는 것은 카메라를 열 때 알려 드립니다.</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>이대로 사용</translation>
    </message>
    <message>
        <source>best for tracking</source>
        <translation>추적에 가장 적합</translation>
    </message>
</context>
<context>
    <name>odo::CameraView</name>
    <message>
        <source>synchronised to %1 ms</source>
        <translation>동기 오차 %1 ms</translation>
    </message>
    <message>
        <source>manual offset</source>
        <translation>오프셋 직접 지정</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>동기화 안 됨</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>카메라 %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Camera image</source>
        <translation>카메라 영상</translation>
    </message>
    <message>
        <source>Image of %1</source>
        <translation>%1의 영상</translation>
    </message>
</context>
<context>
    <name>odo::ChangeModel</name>
    <message>
        <source>made</source>
        <translation>실행</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>실행 취소</translation>
    </message>
    <message>
        <source>redone</source>
        <translation>다시 실행</translation>
    </message>
    <message>
        <source>When</source>
        <translation>시각</translation>
    </message>
    <message>
        <source>How</source>
        <translation>구분</translation>
    </message>
    <message>
        <source>What</source>
        <translation>내용</translation>
    </message>
</context>
<context>
    <name>odo::ChangesDialog</name>
    <message>
        <source>Project changes</source>
        <translation>프로젝트 변경 내역</translation>
    </message>
    <message>
        <source>No changes yet.</source>
        <translation>아직 변경된 것이 없습니다.</translation>
    </message>
    <message>
        <source>All changes made in this window and on the command line, newest first. The list includes recordings, imports and tracking, but you cannot undo them.</source>
        <translation>이 창과 명령줄에서 변경한 내용이며, 최근 것이 먼저 나옵니다. 녹화, 가져오기, 추적도 나오지만 실행을 취소할 수는 없습니다.</translation>
    </message>
    <message>
        <source>Search the changes…</source>
        <translation>변경 내역 검색…</translation>
    </message>
    <message>
        <source>Search the changes</source>
        <translation>변경 내역 검색</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>변경 내역</translation>
    </message>
</context>
<context>
    <name>odo::ChartImage</name>
    <message>
        <source>&amp;Copy as image</source>
        <translation>그림으로 복사(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save as image…</source>
        <translation>그림으로 저장(&amp;S)…</translation>
    </message>
    <message>
        <source>SVG images (*.svg)</source>
        <translation>SVG 그림 (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 그림 (*.png)</translation>
    </message>
    <message>
        <source>Save as image</source>
        <translation>그림으로 저장</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF 문서 (*.pdf)</translation>
    </message>
</context>
<context>
    <name>odo::ChartSpan</name>
    <message>
        <source>Charts: show &amp;less</source>
        <translation>차트: 좁게 보기(&amp;L)</translation>
    </message>
    <message>
        <source>Charts: show &amp;more</source>
        <translation>차트: 넓게 보기(&amp;M)</translation>
    </message>
    <message>
        <source>Charts: show &amp;all</source>
        <translation>차트: 전체 보기(&amp;A)</translation>
    </message>
    <message>
        <source>Charts over &amp;distance</source>
        <translation>차트 가로축을 거리로(&amp;D)</translation>
    </message>
</context>
<context>
    <name>odo::CheckTools</name>
    <message>
        <source>&amp;Check camera positions…</source>
        <translation>카메라 점검(&amp;C)…</translation>
    </message>
    <message>
        <source>Check camera positions…</source>
        <translation>카메라 점검…</translation>
    </message>
    <message>
        <source>Check before the robots run that no camera has moved since its registration</source>
        <translation>로봇이 주행하기 전에 각 카메라가 정합한 자리에 그대로 있는지 확인합니다</translation>
    </message>
    <message>
        <source>Check a known &amp;length…</source>
        <translation>길이 검증(&amp;L)…</translation>
    </message>
    <message>
        <source>Check a known length…</source>
        <translation>길이 검증…</translation>
    </message>
    <message>
        <source>Measure an object of known length in a camera&apos;s image to check the camera&apos;s stated uncertainty</source>
        <translation>길이를 아는 물체를 카메라 영상에서 재어 카메라가 표시된 만큼 정확한지 확인합니다</translation>
    </message>
    <message>
        <source>&amp;Expected accuracy…</source>
        <translation>예상 정확도(&amp;E)…</translation>
    </message>
    <message>
        <source>Accuracy…</source>
        <translation>정확도…</translation>
    </message>
    <message>
        <source>Show the expected uncertainty everywhere on the floor, also with planned cameras</source>
        <translation>바닥의 각 위치를 얼마나 정확히 알 수 있는지, 계획만 한 카메라까지 포함하여 봅니다</translation>
    </message>
    <message>
        <source>&amp;Older calibrations…</source>
        <translation>이전 보정(&amp;O)…</translation>
    </message>
    <message>
        <source>Revisions…</source>
        <translation>버전…</translation>
    </message>
    <message>
        <source>Show all calibrations and registrations of a camera, switch to an older one, reanalyse trials</source>
        <translation>카메라의 모든 보정과 정합을 보고, 이전 것을 적용하고, 시행을 다시 측정합니다</translation>
    </message>
    <message>
        <source>Cameras checked: see their badges.</source>
        <translation>카메라 점검을 마쳤습니다. 배지를 확인하십시오.</translation>
    </message>
    <message>
        <source>The chosen calibrations and analyses are now current.</source>
        <translation>보정과 시행이 선택한 대로 되었습니다.</translation>
    </message>
</context>
<context>
    <name>odo::ClassActions</name>
    <message>
        <source>&amp;Tasks…</source>
        <translation>과제(&amp;T)…</translation>
    </message>
    <message>
        <source>C&amp;lasses and teams…</source>
        <translation>학급과 팀(&amp;L)…</translation>
    </message>
    <message>
        <source>R&amp;obots…</source>
        <translation>로봇(&amp;O)…</translation>
    </message>
    <message>
        <source>Show &amp;standings…</source>
        <translation>순위 보기(&amp;S)…</translation>
    </message>
</context>
<context>
    <name>odo::ClassesDialog</name>
    <message>
        <source>&amp;New class…</source>
        <translation>새 학급(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>이름 변경(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>보관(&amp;A)</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>삭제(&amp;T)</translation>
    </message>
    <message>
        <source>New t&amp;eam…</source>
        <translation>새 팀(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Move to</source>
        <translation>옮기기(&amp;M)</translation>
    </message>
    <message>
        <source>Members and r&amp;obots…</source>
        <translation>팀원과 로봇(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>삭제(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Import roster…</source>
        <translation>명단 가져오기(&amp;I)…</translation>
    </message>
    <message>
        <source>Classes and teams</source>
        <translation>학급과 팀</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>작업 결과</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Archiving hides a class: History, Record and the standings show its teams and trials only if you choose the class by name</source>
        <translation>보관된 학급은 평소에 보이지 않습니다. 그 학급의 팀과 시행은 이력, 녹화, 순위표에서 그 학급을 직접 선택할 때만 나타납니다</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>가명</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>팀원</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Teams of the class</source>
        <translation>학급의 팀</translation>
    </message>
    <message>
        <source>Double-click or press F2 to change a name or a pseudonym</source>
        <translation>두 번 클릭하거나 F2를 누르면 이름이나 가명을 바꿀 수 있습니다</translation>
    </message>
    <message numerus="yes">
        <source>%1 (archived, %n team(s))</source>
        <translation>
            <numerusform>%1(보관됨, %n팀)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n team(s))</source>
        <translation>
            <numerusform>%1(%n팀)</numerusform>
        </translation>
    </message>
    <message>
        <source>Teams without a class</source>
        <translation>학급이 없는 팀</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>보관 해제(&amp;A)</translation>
    </message>
    <message>
        <source>No class</source>
        <translation>학급 없음</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>이름:</translation>
    </message>
    <message>
        <source>New class</source>
        <translation>새 학급</translation>
    </message>
    <message>
        <source>Rename class</source>
        <translation>학급 이름 변경</translation>
    </message>
    <message>
        <source>New team</source>
        <translation>새 팀</translation>
    </message>
</context>
<context>
    <name>odo::CompareColumn</name>
    <message>
        <source>Time difference</source>
        <translation>시간차</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>구간</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Run compared with the first one</source>
        <translation>첫째 주행과 견주어 표시할 주행</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>주행</translation>
    </message>
    <message>
        <source>Times from gate to gate</source>
        <translation>게이트 사이의 시간</translation>
    </message>
    <message>
        <source>Metrics of both runs</source>
        <translation>두 주행의 지표</translation>
    </message>
    <message>
        <source>s · drag the gates on the map</source>
        <translation>s · 지도의 게이트를 끌어 옮기기</translation>
    </message>
    <message>
        <source>grey: not significant</source>
        <translation>회색: 오차 이내</translation>
    </message>
    <message>
        <source>of</source>
        <translation>대상</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>대상: %1</translation>
    </message>
    <message>
        <source>Behind at finish</source>
        <translation>끝에서 늦음</translation>
    </message>
    <message>
        <source>Ahead at finish</source>
        <translation>끝에서 빠름</translation>
    </message>
    <message>
        <source>Gap at finish</source>
        <translation>끝에서</translation>
    </message>
    <message>
        <source>Behind at cursor</source>
        <translation>여기서 늦음</translation>
    </message>
    <message>
        <source>Ahead at cursor</source>
        <translation>여기서 빠름</translation>
    </message>
    <message>
        <source>Gap at cursor</source>
        <translation>여기서</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
</context>
<context>
    <name>odo::CompareDesk</name>
    <message>
        <source>Top-down map</source>
        <translation>평면 지도</translation>
    </message>
    <message>
        <source>Floor map with the paths of the runs and the gates of the sectors</source>
        <translation>주행 경로와 구간 게이트가 표시된 바닥 지도</translation>
    </message>
    <message>
        <source>Drag a gate along the path. Keys: Up and Down select a gate, Left and Right move it</source>
        <translation>게이트를 경로를 따라 끄십시오. 키보드: 위/아래로 게이트를 고르고 왼쪽/오른쪽으로 옮깁니다</translation>
    </message>
    <message>
        <source>both runs</source>
        <translation>두 주행</translation>
    </message>
    <message>
        <source>Camera of the first run</source>
        <translation>첫째 주행의 카메라</translation>
    </message>
    <message>
        <source>Camera of the second run</source>
        <translation>둘째 주행의 카메라</translation>
    </message>
    <message>
        <source>dashed: the task&apos;s path</source>
        <translation>점선: 과제의 경로</translation>
    </message>
    <message>
        <source>along the first run&apos;s path</source>
        <translation>첫째 주행의 경로 기준</translation>
    </message>
    <message>
        <source>First</source>
        <translation>첫째</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>둘째</translation>
    </message>
</context>
<context>
    <name>odo::ComparePage</name>
    <message>
        <source>These runs cannot be compared</source>
        <translation>이 주행들은 비교할 수 없습니다</translation>
    </message>
    <message>
        <source>%1. What to do: %2.</source>
        <translation>%1. 해결 방법: %2.</translation>
    </message>
    <message>
        <source>Select two runs</source>
        <translation>주행이 두 개 필요합니다</translation>
    </message>
    <message>
        <source>A comparison shows where one run is faster than the other, and whether the difference is significant. Select two tracked trials, or import another one.</source>
        <translation>비교는 한 주행이 다른 주행보다 어디에서 더 빠른지, 그리고 그 차이가 오차보다 큰지를 보여 줍니다. 추적을 마친 시행 두 개를 선택하거나 다른 시행을 가져오십시오.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>동영상에서 시행 가져오기…</translation>
    </message>
</context>
<context>
    <name>odo::ConflictDialog</name>
    <message>
        <source>Changed here and elsewhere</source>
        <translation>여기와 다른 곳에서 바뀜</translation>
    </message>
    <message>
        <source>You and another bench changed these. Nothing is lost: the hub keeps the version that is not in force. To bring a value back, enter it here again.</source>
        <translation>이 항목을 이곳과 다른 측정대에서 모두 바꾸었습니다. 잃는 것은 없습니다. 허브는 적용되지 않은 버전도 보관합니다. 값을 되돌리려면 여기에 다시 입력하세요.</translation>
    </message>
    <message>
        <source>What was changed twice</source>
        <translation>두 번 바뀐 것</translation>
    </message>
    <message>
        <source>Values that differ</source>
        <translation>서로 다른 값</translation>
    </message>
    <message>
        <source>&amp;Remove all from this list</source>
        <translation>목록에서 모두 제거(&amp;R)</translation>
    </message>
    <message>
        <source>The version of this project is in force.</source>
        <translation>이 프로젝트의 버전이 적용됩니다.</translation>
    </message>
    <message>
        <source>The version of the hub is in force. It comes with the next “Pull”.</source>
        <translation>허브의 버전이 적용됩니다. 다음에 받을 때 옵니다.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>항목</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>이 프로젝트</translation>
    </message>
    <message>
        <source>At the hub</source>
        <translation>허브</translation>
    </message>
</context>
<context>
    <name>odo::ConnectForm</name>
    <message>
        <source>Odograph keeps it until you close the program, and writes it nowhere</source>
        <translation>Odograph은 프로그램을 닫을 때까지만 기억하고 어디에도 쓰지 않습니다</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>비밀번호</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>찾아보기(&amp;B)…</translation>
    </message>
    <message>
        <source>C&amp;onnect</source>
        <translation>연결(&amp;O)</translation>
    </message>
    <message>
        <source>Connect this project to the school&apos;s hub. Odograph sends its trials, tasks and class lists there, and you receive those of the other benches. You can measure without the network; Odograph sends later what it could not send.</source>
        <translation>이 프로젝트를 학교 허브에 연결하세요. Odograph이 시행, 과제, 학급 명단을 그곳으로 보내고, 다른 측정대의 것을 받습니다. 네트워크 없이도 측정할 수 있으며, 보내지 못한 것은 나중에 보냅니다.</translation>
    </message>
    <message>
        <source>Address of the hub</source>
        <translation>허브 주소</translation>
    </message>
    <message>
        <source>empty: as in ~/.pgpass or PGPASSWORD</source>
        <translation>비움: ~/.pgpass 또는 PGPASSWORD의 것</translation>
    </message>
    <message>
        <source>optional: a folder that all benches can reach</source>
        <translation>선택: 모든 측정대가 쓸 수 있는 폴더</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>녹화 폴더</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>찾아보기: %1</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>주소(&amp;A):</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>비밀번호(&amp;P):</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>녹화(&amp;R):</translation>
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
        <translation>좌우</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>위아래</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>원근</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>기울기</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>덮은 면적</translation>
    </message>
    <message>
        <source>%1 images: enough. More do no harm.</source>
        <translation>사진 %1장: 충분합니다. 더 있어도 괜찮습니다.</translation>
    </message>
    <message>
        <source>1 image; take ten or more.</source>
        <translation>사진 1장: 10장 이상 필요합니다.</translation>
    </message>
    <message>
        <source>%1 images; take ten or more.</source>
        <translation>사진 %1장: 10장 이상 필요합니다.</translation>
    </message>
</context>
<context>
    <name>odo::CrashNotice</name>
    <message>
        <source>Odograph ended unexpectedly</source>
        <translation>Odograph가 예기치 않게 종료되었습니다</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe. If a recording was cut off, open its project to recover it up to the last second.</source>
        <translation>지난번에 Odograph가 자체 결함으로 종료되었습니다. 저장된 것은 안전합니다. 중간에 끊긴 녹화는 해당 프로젝트를 다시 열면 마지막 1초까지 보존됩니다.</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe.</source>
        <translation>지난번에 Odograph가 자체 결함으로 종료되었습니다. 저장된 것은 안전합니다.</translation>
    </message>
    <message>
        <source>Project:</source>
        <translation>프로젝트:</translation>
    </message>
    <message>
        <source>Report:</source>
        <translation>보고서:</translation>
    </message>
    <message>
        <source>&amp;Open the project</source>
        <translation>프로젝트 열기(&amp;O)</translation>
    </message>
</context>
<context>
    <name>odo::DifferenceModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>end</source>
        <translation>끝</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 ~ %2</translation>
    </message>
    <message>
        <source>Only one of the two runs has it</source>
        <translation>둘 중 하나에만 있음</translation>
    </message>
    <message>
        <source>%1: significant (95 %)</source>
        <translation>%1: 오차 초과(95 %)</translation>
    </message>
    <message>
        <source>%1: not significant (95 %)</source>
        <translation>%1: 오차 이내(95 %), 차이가 있다고 할 수 없음</translation>
    </message>
    <message>
        <source>significant</source>
        <translation>오차 초과</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>오차 이내</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>차이</translation>
    </message>
</context>
<context>
    <name>odo::DistanceChart</name>
    <message>
        <source>Speed over distance</source>
        <translation>경로상의 속력</translation>
    </message>
    <message>
        <source>Time difference over distance</source>
        <translation>경로상의 시간차</translation>
    </message>
    <message>
        <source>%1 · smoothed ±95 %</source>
        <translation>%1 · 평활화 ±95 %</translation>
    </message>
    <message>
        <source>s · above 0: %2 is later than %1 · ±95 % · grey: not significant</source>
        <translation>s · 0보다 크면 %2이(가) %1보다 늦음 · ±95 % · 회색: 오차 이내</translation>
    </message>
    <message>
        <source>s · above 0: later than %1 · ±95 % · grey: not significant</source>
        <translation>s · 0보다 크면 %1보다 늦음 · ±95 % · 회색: 오차 이내</translation>
    </message>
</context>
<context>
    <name>odo::DockGrip</name>
    <message>
        <source>Drag to move, double-click to float</source>
        <translation>끌어서 옮기고, 두 번 클릭하면 떼어 냅니다</translation>
    </message>
</context>
<context>
    <name>odo::DoctorDialog</name>
    <message>
        <source>good</source>
        <translation>양호</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>주의</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>나쁨</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>Set-up doctor</source>
        <translation>장비 진단</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>진단 결과</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>다시 진단(&amp;L)</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>진단 중…</translation>
    </message>
    <message>
        <source>. What to do: %1.</source>
        <translation>. 조치: %1.</translation>
    </message>
    <message>
        <source>Found nothing that would disturb a recording.</source>
        <translation>녹화에 지장을 줄 만한 것은 없습니다.</translation>
    </message>
    <message>
        <source>Found one problem.</source>
        <translation>살펴볼 것이 하나 있습니다.</translation>
    </message>
    <message>
        <source>Found %1 problems, the worst first.</source>
        <translation>살펴볼 것이 %1가지 있습니다. 가장 심각한 것이 먼저 나옵니다.</translation>
    </message>
</context>
<context>
    <name>odo::EditTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>시행의 로봇</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 편집</translation>
    </message>
    <message numerus="yes">
        <source>Edit %n trial(s)</source>
        <translation>
            <numerusform>시행 %n개 편집</numerusform>
        </translation>
    </message>
    <message>
        <source>Why it was not changed</source>
        <translation>바꾸지 못한 이유</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>변경(&amp;C)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>이름(&amp;N)</translation>
    </message>
    <message>
        <source>T&amp;eam</source>
        <translation>팀(&amp;E)</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>학급(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Date and time</source>
        <translation>날짜와 시각(&amp;D)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>과제(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>로봇(&amp;O)</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>쉼표로 구분</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>태그(&amp;G)</translation>
    </message>
    <message>
        <source>Note&amp;s</source>
        <translation>메모(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Variables</source>
        <translation>변수(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Remove variable</source>
        <translation>변수 제거(&amp;R)</translation>
    </message>
    <message>
        <source>The variable %1 is in the table twice. Remove one of the rows.</source>
        <translation>변수 %1이(가) 표에 두 번 있습니다. 한 행을 제거하십시오.</translation>
    </message>
</context>
<context>
    <name>odo::ExportDialog</name>
    <message>
        <source>&amp;Keep as…</source>
        <translation>이름 붙여 보관(&amp;K)…</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>제거(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>프리셋(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>로봇(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>형식(&amp;F)</translation>
    </message>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>프로그램용 CSV (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>스프레드시트용 CSV, 1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>스프레드시트용 CSV, 1,5 (*.csv)</translation>
    </message>
    <message>
        <source>Tracker text (*.txt)</source>
        <translation>Tracker 텍스트 (*.txt)</translation>
    </message>
    <message>
        <source>TUM trajectory (*.tum)</source>
        <translation>TUM 궤적 (*.tum)</translation>
    </message>
    <message>
        <source>Page to take along (*.html)</source>
        <translation>가져갈 페이지 (*.html)</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>열</translation>
    </message>
    <message>
        <source>&amp;Columns</source>
        <translation>열(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Lengths in</source>
        <translation>길이 단위(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>좌표축(&amp;A)</translation>
    </message>
    <message>
        <source>Of the floor&apos;s markers</source>
        <translation>바닥 마커 기준</translation>
    </message>
    <message>
        <source>From the start, X in its direction</source>
        <translation>출발점에서, 출발 방향이 X</translation>
    </message>
    <message>
        <source>Par&amp;t of the run</source>
        <translation>주행의 부분(&amp;T)</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>파일 선택…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>폴더 선택…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>프리셋</translation>
    </message>
    <message>
        <source>Its range, which counts</source>
        <translation>유효한 구간</translation>
    </message>
    <message>
        <source>The whole run</source>
        <translation>주행 전체</translation>
    </message>
    <message>
        <source>What counts of each</source>
        <translation>각 주행에서 유효한 부분</translation>
    </message>
    <message>
        <source>The selection, %1 to %2</source>
        <translation>선택 구간, %1 ~ %2</translation>
    </message>
    <message>
        <source>As last time</source>
        <translation>지난번과 같이</translation>
    </message>
    <message>
        <source>Keep these choices</source>
        <translation>이 선택 보관</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>프리셋 이름:</translation>
    </message>
</context>
<context>
    <name>odo::FileActions</name>
    <message>
        <source>&amp;New project…</source>
        <translation>새 프로젝트(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>프로젝트 열기(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;demo lesson…</source>
        <translation>데모 수업 열기(&amp;D)…</translation>
    </message>
    <message>
        <source>Save a &amp;copy as…</source>
        <translation>사본 저장(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>끝내기(&amp;Q)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>최근 프로젝트(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>목록 지우기(&amp;C)</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>새 프로젝트</translation>
    </message>
    <message>
        <source>Project.odo</source>
        <translation>프로젝트.odo</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo)</source>
        <translation>Odograph 프로젝트 (*.odo)</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>프로젝트 열기</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo);;All files (*)</source>
        <translation>Odograph 프로젝트 (*.odo);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the demo lesson</source>
        <translation>데모 수업을 어디에 만들까요?</translation>
    </message>
    <message>
        <source>Odograph demo</source>
        <translation>Odograph 데모</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>%1의 사본</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>사본 저장</translation>
    </message>
    <message>
        <source>Copy saved as %1. Its videos stay where they are.</source>
        <translation>사본을 %1에 저장했습니다. 동영상은 있던 자리에 그대로 있습니다.</translation>
    </message>
    <message>
        <source>New project from t&amp;his one…</source>
        <translation>이 프로젝트로 새 프로젝트(&amp;H)…</translation>
    </message>
    <message>
        <source>With its cameras, marker layouts, robots and tasks, without people and trials</source>
        <translation>카메라, 마커 배치, 로봇, 과제는 그대로, 사람과 시행은 없이</translation>
    </message>
    <message>
        <source>Open demo lesson</source>
        <translation>데모 수업 열기</translation>
    </message>
    <message>
        <source>A demo lesson is in %1.</source>
        <translation>%1에 데모 수업이 있습니다.</translation>
    </message>
    <message>
        <source>&amp;Open it</source>
        <translation>열기(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Create another…</source>
        <translation>새로 만들기(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Backups…</source>
        <translation>백업(&amp;B)…</translation>
    </message>
</context>
<context>
    <name>odo::FilmStrip</name>
    <message>
        <source>&amp;Remove</source>
        <translation>빼기(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>Accepted images</source>
        <translation>계산에 넣는 사진</translation>
    </message>
</context>
<context>
    <name>odo::FloorCopy</name>
    <message>
        <source>&amp;Copy floor position</source>
        <translation>바닥 위치 복사(&amp;C)</translation>
    </message>
</context>
<context>
    <name>odo::FloorMap</name>
    <message>
        <source>Top-down map</source>
        <translation>평면 지도</translation>
    </message>
    <message>
        <source>Map: &amp;views&apos; disagreement</source>
        <translation>지도: 뷰 간 불일치(&amp;V)</translation>
    </message>
    <message>
        <source>Floor map with the robots&apos; trails</source>
        <translation>로봇의 자취가 표시된 바닥 지도</translation>
    </message>
    <message>
        <source>Colour of the trails on the map</source>
        <translation>지도 자취의 색 기준</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation>불일치</translation>
    </message>
    <message>
        <source>Disagreement of the views: %1</source>
        <translation>뷰 간 불일치: %1</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>색</translation>
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
        <translation>바닥이 아님</translation>
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
        <translation>위에서 본 테스트베드 약도</translation>
    </message>
    <message>
        <source>%1 markers, %2 cameras</source>
        <translation>마커 %1개, 카메라 %2대</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1, 높이 %2 m</translation>
    </message>
    <message>
        <source>This sketch shows markers and cameras once the testbed has a layout or a registered camera.</source>
        <translation>마커 배치나 정합된 카메라가 생기면 여기에 마커와 카메라를 그립니다.</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>격자 %1 m</translation>
    </message>
</context>
<context>
    <name>odo::FloorSourcePage</name>
    <message>
        <source>Image or video of the markers</source>
        <translation>마커의 사진 또는 동영상</translation>
    </message>
    <message>
        <source>Markers with known floor positions determine the camera position. Four are enough; a fifth checks them. Do not move the camera afterwards.</source>
        <translation>바닥에서의 위치를 아는 마커로 카메라가 있는 곳을 구합니다. 네 개면 충분하고, 다섯째는 검증에 쓰입니다. 이후에는 카메라를 움직이면 안 됩니다.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>카메라(&amp;A)</translation>
    </message>
    <message>
        <source>Marker &amp;layout</source>
        <translation>마커 배치(&amp;L)</translation>
    </message>
    <message>
        <source>Image of the markers</source>
        <translation>마커가 보이는 곳</translation>
    </message>
    <message>
        <source>Its lens is calibrated.</source>
        <translation>렌즈를 측정했습니다.</translation>
    </message>
    <message>
        <source>Its lens is not calibrated. Odograph estimates it from the markers, as far as they determine it.</source>
        <translation>렌즈가 보정되지 않았습니다. 마커로 결정되는 만큼 Odograph가 마커에서 추정합니다.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>카메라에 A와 같은 이름을 붙이십시오.</translation>
    </message>
    <message>
        <source>Add a marker layout first.</source>
        <translation>먼저 마커 배치를 추가하십시오.</translation>
    </message>
    <message>
        <source>Choose an image or a video of the markers.</source>
        <translation>마커의 이미지나 동영상을 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>odo::FloorWizard</name>
    <message>
        <source>Register camera to the floor</source>
        <translation>카메라를 바닥에 정합</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>The camera and its markers</source>
        <translation>카메라와 마커</translation>
    </message>
    <message>
        <source>The markers in the image</source>
        <translation>사진 속의 마커</translation>
    </message>
    <message>
        <source>Detecting the markers…</source>
        <translation>마커를 찾는 중…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>아직 저장할 정합이 없습니다.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>정합</translation>
    </message>
</context>
<context>
    <name>odo::FrameAligner</name>
    <message>
        <source>&amp;Move both frames together</source>
        <translation>두 프레임을 함께 이동(&amp;M)</translation>
    </message>
    <message>
        <source>Together they show what is now taken for the same moment. Remove the tick, and move one frame until both show the same moment, such as a wheel that begins to turn.</source>
        <translation>함께 움직이면 지금 같은 순간으로 여기는 장면을 보여 줍니다. 체크를 풀고, 바퀴가 돌기 시작하는 순간처럼 같은 순간이 보일 때까지 한 프레임을 옮기세요.</translation>
    </message>
</context>
<context>
    <name>odo::FramePanel</name>
    <message>
        <source>Frame of camera %1</source>
        <translation>카메라 %1의 프레임</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>카메라 %1</translation>
    </message>
    <message>
        <source>%1: frame %2, %3</source>
        <translation>%1: 프레임 %2, %3</translation>
    </message>
</context>
<context>
    <name>odo::GateTable</name>
    <message>
        <source>start</source>
        <translation>출발</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>도착</translation>
    </message>
    <message>
        <source>start and finish</source>
        <translation>출발·도착</translation>
    </message>
    <message>
        <source>split</source>
        <translation>중간</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>제거(&amp;V)</translation>
    </message>
    <message>
        <source>Reverse directi&amp;on</source>
        <translation>반대 방향(&amp;O)</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>게이트</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>역할</translation>
    </message>
    <message>
        <source>x₁, mm</source>
        <translation>x₁, mm</translation>
    </message>
    <message>
        <source>y₁, mm</source>
        <translation>y₁, mm</translation>
    </message>
    <message>
        <source>x₂, mm</source>
        <translation>x₂, mm</translation>
    </message>
    <message>
        <source>y₂, mm</source>
        <translation>y₂, mm</translation>
    </message>
    <message>
        <source>Gates in passing order</source>
        <translation>통과하는 순서대로 나열한 게이트</translation>
    </message>
    <message>
        <source>&amp;Add gate</source>
        <translation>게이트 추가(&amp;A)</translation>
    </message>
    <message>
        <source>Robots pass the selected gate the other way</source>
        <translation>선택한 게이트의 통과 방향을 뒤집습니다</translation>
    </message>
    <message>
        <source>Role of the gate</source>
        <translation>게이트의 역할</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>중간 %1</translation>
    </message>
</context>
<context>
    <name>odo::GeneralPage</name>
    <message>
        <source>Restart Odograph to see the change.</source>
        <translation>Odograph를 다시 시작하면 적용됩니다.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>언어(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Units of results</source>
        <translation>결과 단위(&amp;U)</translation>
    </message>
    <message>
        <source>Floors and targets always use millimetres, as printed. Exported files use the units of their format.</source>
        <translation>바닥과 타깃은 인쇄 치수대로 밀리미터로 설정합니다. 내보낸 파일은 그 형식에서 정한 단위를 씁니다.</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>테마(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Colours of maps</source>
        <translation>지도 색(&amp;C)</translation>
    </message>
    <message>
        <source>Both remain readable for people with red-green colour blindness and in black-and-white prints.</source>
        <translation>둘 다 적색이나 녹색을 구별하지 못하는 사람도, 흑백 인쇄에서도 구별할 수 있습니다.</translation>
    </message>
    <message>
        <source>Units of results</source>
        <translation>결과 단위</translation>
    </message>
    <message>
        <source>Millimetres and metres: mm, m, m/s</source>
        <translation>밀리미터와 미터: mm, m, m/s</translation>
    </message>
    <message>
        <source>Centimetres: cm, cm/s</source>
        <translation>센티미터: cm, cm/s</translation>
    </message>
    <message>
        <source>Inches and feet: in, ft, ft/s</source>
        <translation>인치와 피트: in, ft, ft/s</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>As set on the computer</source>
        <translation>컴퓨터 설정대로</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>테마</translation>
    </message>
    <message>
        <source>As set on the desktop</source>
        <translation>데스크톱 설정대로</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>Colours of maps</source>
        <translation>지도 색</translation>
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
        <translation>프로젝트를 여는 날마다 백업(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Days to keep backups</source>
        <translation>백업 보관 일수(&amp;D)</translation>
    </message>
    <message>
        <source>Backups are beside the project and contain everything except the videos: File ▸ Backups… shows and restores them.</source>
        <translation>백업은 프로젝트 옆에 있으며 비디오를 제외한 모든 것이 들어 있습니다: 파일 ▸ 백업…에서 보고 복원합니다.</translation>
    </message>
</context>
<context>
    <name>odo::GuidanceTool</name>
    <message>
        <source>&amp;Ignore an area</source>
        <translation>영역 무시(&amp;I)</translation>
    </message>
    <message>
        <source>Draw an area of a view to ignore, such as a mirror or a screen: click its corners, then press Enter</source>
        <translation>거울이나 화면처럼 무시할 뷰의 영역을 그립니다: 모서리를 클릭한 다음 Enter를 누르세요</translation>
    </message>
    <message>
        <source>Search only an &amp;area</source>
        <translation>한 영역만 탐색(&amp;A)</translation>
    </message>
    <message>
        <source>Draw the area of a view in which robots are searched: click its corners, then press Enter</source>
        <translation>로봇을 찾을 뷰의 영역을 그립니다: 모서리를 클릭한 다음 Enter를 누르세요</translation>
    </message>
    <message>
        <source>&amp;Remove all areas</source>
        <translation>모든 영역 제거(&amp;R)</translation>
    </message>
    <message>
        <source>Remove all areas of this trial</source>
        <translation>이 시행의 모든 영역을 제거합니다</translation>
    </message>
    <message>
        <source>Remove this ignored area</source>
        <translation>이 무시 영역 제거</translation>
    </message>
    <message>
        <source>Remove this search area</source>
        <translation>이 탐색 영역 제거</translation>
    </message>
    <message>
        <source>Set %1 here by hand…</source>
        <translation>%1의 위치를 여기로 수동 지정…</translation>
    </message>
    <message>
        <source>%1 is not visible here in the selected time</source>
        <translation>선택한 시간 동안 %1이(가) 여기서 보이지 않음</translation>
    </message>
    <message>
        <source>%1 is not visible in any view in the selected time</source>
        <translation>선택한 시간 동안 %1이(가) 어느 뷰에서도 보이지 않음</translation>
    </message>
    <message>
        <source>Remove the point set by hand</source>
        <translation>수동으로 지정한 점 제거</translation>
    </message>
    <message>
        <source>It is visible after all</source>
        <translation>실제로는 보임</translation>
    </message>
    <message>
        <source>Set a point by hand</source>
        <translation>점 수동 지정</translation>
    </message>
    <message>
        <source>Uncertainty σ of this point, pixels:</source>
        <translation>이 점의 불확도 σ, 픽셀:</translation>
    </message>
</context>
<context>
    <name>odo::HelpActions</name>
    <message>
        <source>&amp;Help on this page</source>
        <translation>이 페이지 도움말(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First lesson</source>
        <translation>첫 수업(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>단축키(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Odograph</source>
        <translation>Odograph 정보(&amp;A)</translation>
    </message>
</context>
<context>
    <name>odo::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>도움말 닫기(F1)</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>도움말 닫기</translation>
    </message>
    <message>
        <source>Help on this page</source>
        <translation>이 페이지 도움말</translation>
    </message>
</context>
<context>
    <name>odo::HistoryActions</name>
    <message>
        <source>Import &amp;roster…</source>
        <translation>명단 가져오기(&amp;R)…</translation>
    </message>
    <message>
        <source>Show project &amp;changes…</source>
        <translation>프로젝트 변경 내역(&amp;C)…</translation>
    </message>
    <message>
        <source>Import a roster: a table with the columns class, team and optionally pseudonym</source>
        <translation>명단을 가져옵니다. 학급(class)과 팀(team) 열이 있는 표이며, 가명(pseudonym) 열은 없어도 됩니다</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV 표 (*.csv)</translation>
    </message>
    <message>
        <source>Roster imported. New teams: %1, changed: %2, unchanged: %3.</source>
        <translation>명단을 가져왔습니다. 새 팀: %1, 변경된 팀: %2, 그대로인 팀: %3.</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation>
            <numerusform>시행 %n개 내보내기: 폴더 선택</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Videos of %n trial(s)</source>
        <translation>
            <numerusform>시행 %n개의 동영상</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>시행 %n개를 완전히 삭제했습니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Removed %1 of %n trial(s) for good; the rest is still in the bin.</source>
        <translation>
            <numerusform>시행 %n개 중 %1개를 완전히 삭제했습니다. 나머지는 그대로 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be deleted; delete it by hand.</source>
        <translation>%1을(를) 삭제할 수 없습니다. 직접 삭제하십시오.</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s)</source>
        <translation>
            <numerusform>시행 %n개 내보내기</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message>
        <source>&amp;Compare</source>
        <translation>비교(&amp;C)</translation>
    </message>
    <message>
        <source>Teams by &amp;pseudonym</source>
        <translation>팀을 가명으로(&amp;P)</translation>
    </message>
    <message>
        <source>Tr&amp;ials</source>
        <translation>시행(&amp;I)</translation>
    </message>
    <message>
        <source>Tea&amp;ms</source>
        <translation>팀(&amp;M)</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Rea&amp;nalyse</source>
        <translation>다시 측정(&amp;M)</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>내보내기(&amp;X)…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>보고서(&amp;R)…</translation>
    </message>
    <message>
        <source>Export &amp;videos…</source>
        <translation>동영상 내보내기(&amp;V)…</translation>
    </message>
    <message>
        <source>Search trials, teams, tasks, tags, notes…</source>
        <translation>시행, 팀, 과제, 태그, 메모 검색…</translation>
    </message>
    <message>
        <source>Search the trials</source>
        <translation>시행 검색</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>검색(&amp;H)</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1(보관됨)</translation>
    </message>
    <message>
        <source>Compare the selected trials</source>
        <translation>선택한 시행을 비교합니다</translation>
    </message>
    <message>
        <source>Select two or more trials (Ctrl+click or Shift+click)</source>
        <translation>시행을 두 개 이상 선택하십시오(Ctrl 또는 Shift를 누른 채 클릭)</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>시행 %n개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation>
            <numerusform>시행 %n개 중 %1개</numerusform>
        </translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>학교 허브</translation>
    </message>
    <message>
        <source>Res&amp;ults</source>
        <translation>결과(&amp;U)</translation>
    </message>
    <message>
        <source>Trials, results or teams</source>
        <translation>시행, 결과 또는 팀</translation>
    </message>
</context>
<context>
    <name>odo::HubActions</name>
    <message>
        <source>School &amp;hub…</source>
        <translation>학교 허브(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>odo::HubDialog</name>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>학교 허브</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>작업 결과</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행 상황</translation>
    </message>
    <message>
        <source>Cancel the exchange with the hub</source>
        <translation>허브와의 교환 취소</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>연결 해제</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not sent yet. They stay in the project.</source>
        <translation>
            <numerusform>변경 %n개를 아직 보내지 않았습니다. 프로젝트에 남아 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>연결 해제(&amp;D)</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>연결하는 중…</translation>
    </message>
    <message>
        <source>Asking the hub…</source>
        <translation>허브에 요청하는 중…</translation>
    </message>
    <message>
        <source>The project is read-only here, so nothing can be sent or received.</source>
        <translation>이 프로젝트는 여기에서 읽기 전용이므로 보내거나 받을 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>odo::HubExchange</name>
    <message>
        <source>Disconnected. All trials stay in the project.</source>
        <translation>연결을 해제했습니다. 모든 시행은 프로젝트에 남아 있습니다.</translation>
    </message>
</context>
<context>
    <name>odo::HubPanel</name>
    <message>
        <source>Password of the hub</source>
        <translation>허브 비밀번호</translation>
    </message>
    <message>
        <source>Copy &amp;recordings, too</source>
        <translation>녹화도 복사(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Publish now</source>
        <translation>지금 게시(&amp;P)</translation>
    </message>
    <message>
        <source>Pu&amp;ll now</source>
        <translation>지금 받기(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>연결 해제(&amp;D)</translation>
    </message>
    <message>
        <source>Send to the hub what is pending. Odograph also does this by itself.</source>
        <translation>대기 중인 것을 허브로 보냅니다. Odograph이 스스로 보내기도 합니다.</translation>
    </message>
    <message>
        <source>Receive class lists, tasks and the trials of other benches</source>
        <translation>학급 명단, 과제, 다른 측정대의 시행 받기</translation>
    </message>
    <message>
        <source>To and from the school&apos;s folder for recordings; this can take long</source>
        <translation>학교의 녹화 폴더로 보내고 받습니다. 오래 걸릴 수 있습니다</translation>
    </message>
    <message>
        <source>Log &amp;in</source>
        <translation>로그인(&amp;I)</translation>
    </message>
    <message>
        <source>Pass&amp;word:</source>
        <translation>비밀번호(&amp;W):</translation>
    </message>
    <message>
        <source>How the project is connected</source>
        <translation>프로젝트의 연결 상태</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>연결</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>아직 없음</translation>
    </message>
    <message>
        <source>Hub</source>
        <translation>허브</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>역할</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>스키마</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>버전 %1</translation>
    </message>
    <message>
        <source>Last exchange</source>
        <translation>마지막 교환</translation>
    </message>
    <message>
        <source>Still to be sent</source>
        <translation>보낼 것</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>No folder: they stay at this bench</source>
        <translation>폴더 없음: 이 측정대에 남음</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Changed twice: %n…</source>
        <translation>
            <numerusform>두 번 바뀜(&amp;C): %n…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HubRunsModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1초</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>반영됨</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>의심스러움</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>반영되지 않음</translation>
    </message>
    <message>
        <source>another course</source>
        <translation>다른 코스</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>순위</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>측정대</translation>
    </message>
</context>
<context>
    <name>odo::HubRunsPanel</name>
    <message>
        <source>Trials of all benches</source>
        <translation>모든 측정대의 시행</translation>
    </message>
    <message>
        <source>Search trials and teams…</source>
        <translation>시행과 팀 검색…</translation>
    </message>
    <message>
        <source>Search the hub</source>
        <translation>허브 검색</translation>
    </message>
    <message>
        <source>Three letters or more</source>
        <translation>세 글자 이상</translation>
    </message>
    <message>
        <source>Runs at the hub</source>
        <translation>허브의 주행</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>검색하는 중…</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>주행 %n개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the newest %n run(s)</source>
        <translation>
            <numerusform>최근 주행 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>측정대</translation>
    </message>
    <message>
        <source>All benches</source>
        <translation>모든 측정대</translation>
    </message>
</context>
<context>
    <name>odo::ImageArea</name>
    <message>
        <source>No view</source>
        <translation>뷰 없음</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>이 카메라는 이때 녹화하고 있지 않았습니다</translation>
    </message>
</context>
<context>
    <name>odo::ImageBars</name>
    <message>
        <source>Error of each image, with a threshold</source>
        <translation>사진별 오차와 기준값</translation>
    </message>
    <message>
        <source>%1: %2 px</source>
        <translation>%1: %2 px</translation>
    </message>
    <message>
        <source>images; rejected above %1 px</source>
        <translation>사진; %1 px를 넘으면 계산에서 뺍니다</translation>
    </message>
</context>
<context>
    <name>odo::ImageChoice</name>
    <message>
        <source>The camera&apos;s ne&amp;west recording</source>
        <translation>카메라의 최근 녹화에서(&amp;W)</translation>
    </message>
    <message>
        <source>The current image of a &amp;connected camera</source>
        <translation>연결된 카메라의 현재 영상에서(&amp;C)</translation>
    </message>
    <message>
        <source>An image or a &amp;video</source>
        <translation>사진 또는 동영상에서(&amp;P)</translation>
    </message>
</context>
<context>
    <name>odo::ImportLessonDialog</name>
    <message>
        <source>Robots in the trials</source>
        <translation>시행의 로봇</translation>
    </message>
    <message>
        <source>Import a lesson</source>
        <translation>수업 가져오기</translation>
    </message>
    <message>
        <source>Clips that were recorded at the same time belong to one trial. Untick what is no run; names and teams can be changed.</source>
        <translation>같은 시각에 녹화된 동영상은 하나의 시행에 속합니다. 주행이 아닌 것은 선택을 해제하십시오. 이름과 팀은 바꿀 수 있습니다.</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>과제(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>로봇(&amp;O)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>뷰 %1의 카메라</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Team of row %1</source>
        <translation>%1행의 팀</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1초</translation>
    </message>
    <message>
        <source>no clip</source>
        <translation>동영상 없음</translation>
    </message>
    <message>
        <source>Each trial needs a name of its own.</source>
        <translation>시행마다 고유한 이름이 필요합니다.</translation>
    </message>
    <message>
        <source>Tick the trials to import.</source>
        <translation>가져올 시행을 선택하십시오.</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>녹화 시각</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>Clip of %1</source>
        <translation>%1의 동영상</translation>
    </message>
    <message>
        <source>Each column of clips needs a camera.</source>
        <translation>동영상 열마다 카메라가 필요합니다.</translation>
    </message>
    <message>
        <source>Two clips of %1 are of the same camera.</source>
        <translation>%1의 동영상 두 개가 같은 카메라의 것입니다.</translation>
    </message>
</context>
<context>
    <name>odo::ImportTracksDialog</name>
    <message>
        <source>Add &amp;robot</source>
        <translation>로봇 추가(&amp;R)</translation>
    </message>
    <message>
        <source>Import finished tracks</source>
        <translation>완성된 궤적 가져오기</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>이름(&amp;N)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>과제(&amp;K)</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>궤적</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Robot of track %1</source>
        <translation>궤적 %1의 로봇</translation>
    </message>
    <message>
        <source>A new name creates a new robot</source>
        <translation>새로운 이름을 쓰면 새 로봇이 생깁니다</translation>
    </message>
    <message>
        <source>File of track %1</source>
        <translation>궤적 %1의 파일</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>팀(&amp;A)</translation>
    </message>
    <message>
        <source>Positions measured by another program or exported by Odograph: TUM, CSV, Tracker text and others. Odograph analyses them as a run without video.</source>
        <translation>다른 프로그램이 측정했거나 Odograph가 내보낸 위치: TUM, CSV, Tracker 텍스트 등. Odograph는 이를 영상 없는 주행으로 분석합니다.</translation>
    </message>
    <message>
        <source>Tracks (*.csv *.txt *.tum *.tsv *.trc);;All files (*)</source>
        <translation>궤적 (*.csv *.txt *.tum *.tsv *.trc);;모든 파일 (*)</translation>
    </message>
</context>
<context>
    <name>odo::ImportTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>시행의 로봇</translation>
    </message>
    <message>
        <source>Add &amp;view</source>
        <translation>뷰 추가(&amp;V)</translation>
    </message>
    <message>
        <source>Camera&apos;s real &amp;rate</source>
        <translation>실제 프레임 속도(&amp;R)</translation>
    </message>
    <message>
        <source>Import trial from videos</source>
        <translation>동영상에서 시행 가져오기</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>이름(&amp;N)</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>팀(&amp;A)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>과제(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>로봇(&amp;O)</translation>
    </message>
    <message>
        <source>Videos</source>
        <translation>동영상</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>동기(&amp;S)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>동영상 파일</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fps</translation>
    </message>
    <message>
        <source>Camera&apos;s real rate</source>
        <translation>카메라의 실제 프레임 속도</translation>
    </message>
    <message>
        <source>For slow motion: the file plays slower than the camera recorded it</source>
        <translation>슬로 모션용: 파일이 촬영할 때보다 느리게 재생됩니다</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>뷰 %1의 카메라</translation>
    </message>
    <message>
        <source>Video of view %1</source>
        <translation>뷰 %1의 동영상</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)</source>
        <translation>동영상 (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Registration of the camera of view %1</source>
        <translation>뷰 %1 카메라의 정합</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>입력 안 됨</translation>
    </message>
    <message>
        <source>%1 has no time stamps and states no frame rate. Enter the rate of its camera.</source>
        <translation>%1에는 타임스탬프가 없고 프레임 속도도 적혀 있지 않습니다. 카메라의 속도를 입력하십시오.</translation>
    </message>
    <message>
        <source>Chapters of one recording are joined by +; images are given as their folder, or FOLDER/%06d.png, with the rate</source>
        <translation>한 녹화의 챕터는 +로 이어집니다. 그림은 폴더 또는 FOLDER/%06d.png와 속도로 지정합니다</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>시행 %1</translation>
    </message>
</context>
<context>
    <name>odo::IntervalHistogram</name>
    <message>
        <source>Histogram of the frame intervals</source>
        <translation>프레임 간격 히스토그램</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2: %n interval(s)</source>
        <translation>
            <numerusform>%1~%2: 간격 %n개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>longer than %1: %n interval(s)</source>
        <translation>
            <numerusform>%1보다 긴 간격: %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalPanel</name>
    <message>
        <source>%1: fewer than two frames</source>
        <translation>%1: 프레임이 둘 미만</translation>
    </message>
    <message>
        <source>%1: frames are %2 apart (%3 frames/s), from %4 to %5</source>
        <translation>%1: 프레임 간격 %2(%3 프레임/s), %4~%5</translation>
    </message>
    <message>
        <source>jitter %1</source>
        <translation>지터 %1</translation>
    </message>
    <message>
        <source>no frame missing</source>
        <translation>빠진 프레임 없음</translation>
    </message>
    <message>
        <source>%1 of %2 frames repeat the one before</source>
        <translation>프레임 %2개 중 %1개가 앞 프레임의 반복</translation>
    </message>
    <message>
        <source>no frame repeated</source>
        <translation>반복된 프레임 없음</translation>
    </message>
    <message>
        <source>Frame intervals</source>
        <translation>프레임 간격</translation>
    </message>
    <message>
        <source>bars by the logarithm of their number</source>
        <translation>막대는 개수의 로그</translation>
    </message>
    <message>
        <source>Frame intervals of the views</source>
        <translation>뷰별 프레임 간격</translation>
    </message>
    <message>
        <source>This trial has no videos.</source>
        <translation>이 시행에는 비디오가 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%1 missing in %n gap(s)</source>
        <translation>
            <numerusform>%n곳에서 %1개 빠짐</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::JobIndicator</name>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행 상황</translation>
    </message>
    <message>
        <source>Cancel the running job</source>
        <translation>실행 중인 작업 취소</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>멈추는 중…</translation>
    </message>
</context>
<context>
    <name>odo::JointDialog</name>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Uncertainty before</source>
        <translation>오차(이전)</translation>
    </message>
    <message>
        <source>Uncertainty, joint</source>
        <translation>오차(함께)</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>이동량</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>마커</translation>
    </message>
    <message>
        <source>Off by, mm</source>
        <translation>어긋남, mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>마커</translation>
    </message>
    <message>
        <source>Register all cameras (joint)</source>
        <translation>모든 카메라 함께 정합</translation>
    </message>
    <message>
        <source>This fits all cameras of layout %1 jointly to the markers they were registered with. Cameras that see the same markers then agree better, and wrongly measured markers show up.</source>
        <translation>배치 %1의 카메라들을 정합에 쓴 마커로 한꺼번에 다시 맞춥니다. 같은 마커를 보는 카메라끼리 더 잘 일치하게 되고, 잘못 잰 마커도 찾아냅니다.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Uncertainty of the tape measure</source>
        <translation>줄자의 오차</translation>
    </message>
    <message>
        <source>Marker positions &amp;measured to</source>
        <translation>마커 위치 측정 오차(&amp;M)</translation>
    </message>
    <message>
        <source>Fitting the cameras jointly…</source>
        <translation>카메라들을 함께 맞추는 중…</translation>
    </message>
    <message>
        <source>The joint uncertainty assumes marker positions measured to %1 mm; registering a single camera assumes them exact. Nothing changes until you save; trials keep the registration they were analysed with.</source>
        <translation>함께 구한 오차는 마커 위치를 %1 mm 오차로 쟀다고 보고 계산한 것이며, 카메라를 따로 정합할 때는 마커 위치가 정확하다고 봅니다. 저장하기 전에는 아무것도 바뀌지 않으며, 시행은 분석에 쓴 정합을 그대로 유지합니다.</translation>
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
        <translation>다시 재십시오</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>맞음</translation>
    </message>
</context>
<context>
    <name>odo::KeysPage</name>
    <message>
        <source>&amp;Use this key</source>
        <translation>이 키 사용(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>키 없음(&amp;N)</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>모두 기본값으로(&amp;A)</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>명령 또는 키 검색</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>명령과 단축키</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>키</translation>
    </message>
    <message>
        <source>New key for the selected command</source>
        <translation>선택한 명령의 새 키</translation>
    </message>
    <message>
        <source>Select a command to change its key.</source>
        <translation>명령을 선택하여 다른 키를 지정하십시오.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. That command would lose it.</source>
        <translation>%1은(는) “%2”의 키입니다. 사용하면 그 명령에는 키가 없어집니다.</translation>
    </message>
    <message>
        <source>Press the new key in the field.</source>
        <translation>입력란에서 새 키를 누르십시오.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDialog</name>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>표 (*.csv *.txt);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Marker layout</source>
        <translation>마커 배치</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>바닥</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>문제점</translation>
    </message>
    <message>
        <source>Enter the floor positions of the markers, measured with a tape in millimetres from the origin. Seen from above, X points right and Y away from you.</source>
        <translation>줄자로 잰 바닥의 마커 위치: 원점에서 잰 밀리미터 값입니다. 위에서 볼 때 X는 오른쪽, Y는 몸에서 멀어지는 쪽입니다.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>이름(&amp;N)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>이름표</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, mm</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, mm</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>마커</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>추가(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>제거(&amp;R)</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>축(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>CSV(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Origin at the chosen marker</source>
        <translation>선택한 마커를 원점으로(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Quarter turn</source>
        <translation>90° 회전(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Half turn</source>
        <translation>180° 회전(&amp;H)</translation>
    </message>
    <message>
        <source>Convert from &amp;centimetres</source>
        <translation>센티미터였음(&amp;C)</translation>
    </message>
    <message>
        <source>Convert from &amp;metres</source>
        <translation>미터였음(&amp;M)</translation>
    </message>
    <message>
        <source>Convert from &amp;inches</source>
        <translation>인치였음(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>가져오기(&amp;I)…</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>마커 위치 (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>내보내기(&amp;E)…</translation>
    </message>
    <message>
        <source>Positions of the markers</source>
        <translation>마커 위치</translation>
    </message>
    <message>
        <source>The layout has no name.</source>
        <translation>배치의 이름이 없습니다.</translation>
    </message>
    <message>
        <source>A layout with this name exists, and cameras may use it. Enter another name.</source>
        <translation>같은 이름의 배치가 있습니다. 그 배치를 쓰는 카메라가 있을 수 있어 덮어쓰지 않습니다. 다른 이름을 지정하십시오.</translation>
    </message>
    <message>
        <source>A marker has no label.</source>
        <translation>이름표가 없는 마커가 있습니다.</translation>
    </message>
    <message>
        <source>Two markers are called %1.</source>
        <translation>이름이 %1인 마커가 두 개입니다.</translation>
    </message>
    <message>
        <source>The position of %1 is not a number.</source>
        <translation>%1의 위치가 숫자가 아닙니다.</translation>
    </message>
    <message>
        <source>The layout needs four markers; it has %1.</source>
        <translation>마커가 네 개 필요한데 %1개뿐입니다.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same position.</source>
        <translation>%1과(와) %2이(가) 같은 위치에 있습니다.</translation>
    </message>
    <message>
        <source>The markers are nearly on a line and cannot determine the camera position. Move one to the side.</source>
        <translation>마커들이 거의 한 직선 위에 있어 카메라의 위치를 구할 수 없습니다. 하나를 옆으로 옮기십시오.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDrawing</name>
    <message>
        <source>Markers from above</source>
        <translation>위에서 본 마커</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>격자 %1 m</translation>
    </message>
</context>
<context>
    <name>odo::LengthPage</name>
    <message>
        <source>S&amp;nap to what is near a click</source>
        <translation>클릭한 곳 근처의 표식에 맞춤(&amp;N)</translation>
    </message>
    <message>
        <source>Image with both ends; arrow keys move the selected one, Space snaps it</source>
        <translation>양 끝이 보이는 사진; 화살표 키로 선택한 끝을 옮기고 Space로 표식에 맞춥니다</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Measured length</source>
        <translation>측정한 길이</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>실제 길이</translation>
    </message>
    <message>
        <source>Unit of the true length</source>
        <translation>실제 길이의 단위</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>on the floor</source>
        <translation>바닥에 놓임</translation>
    </message>
    <message>
        <source>&amp;True length</source>
        <translation>실제 길이(&amp;T)</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>높이(&amp;E)</translation>
    </message>
    <message>
        <source>End</source>
        <translation>끝점</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>인식한 것</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>바닥 위치, mm</translation>
    </message>
    <message>
        <source>Ends of the length</source>
        <translation>길이의 양 끝점</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>양 끝점</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>잰 물체</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>측정 결과</translation>
    </message>
    <message>
        <source>Put an object of known length anywhere on the floor, such as a metre stick or two markers at a known distance, and click both ends. Keys: arrows move an end (Ctrl: fast, Shift: one pixel), Space snaps it.</source>
        <translation>1 m 자나 간격을 아는 두 마커처럼 길이를 아는 것을 바닥 아무 데나 놓고 양 끝을 클릭하십시오. 키보드: 화살표로 끝점을 옮기고(Ctrl: 빠르게, Shift: 1픽셀), Space로 표식에 맞춥니다.</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>within uncertainty</source>
        <translation>예상 오차 이내</translation>
    </message>
    <message>
        <source>outside uncertainty</source>
        <translation>예상 오차 초과</translation>
    </message>
    <message>
        <source> Enter its true length to check the result.</source>
        <translation> 실제 길이를 입력하면 맞는지 확인할 수 있습니다.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>지평선 너머</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>아직 지정 안 됨</translation>
    </message>
</context>
<context>
    <name>odo::LengthWizard</name>
    <message>
        <source>Check a known length</source>
        <translation>길이 검증</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>완료(&amp;D)</translation>
    </message>
    <message>
        <source>Image or video of the length</source>
        <translation>길이를 잴 사진 또는 동영상</translation>
    </message>
    <message>
        <source>The camera and its image</source>
        <translation>카메라와 사진</translation>
    </message>
    <message>
        <source>Both ends of the length</source>
        <translation>길이의 양 끝점</translation>
    </message>
    <message>
        <source>Put an object of known length on the floor, away from the markers, to check the camera&apos;s stated uncertainty. This changes nothing.</source>
        <translation>길이를 아는 것을 마커에서 떨어진 바닥에 놓고 카메라가 표시된 만큼 정확히 재는지 확인합니다. 이 검증으로 바뀌는 것은 없습니다.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>카메라(&amp;A)</translation>
    </message>
    <message>
        <source>Image of the length</source>
        <translation>길이가 보이는 곳</translation>
    </message>
    <message>
        <source>Loading the image…</source>
        <translation>사진을 가져오는 중…</translation>
    </message>
    <message>
        <source>Choose an image or a video.</source>
        <translation>이미지나 동영상을 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>odo::LensWizard</name>
    <message>
        <source>Calibrate camera</source>
        <translation>카메라 보정</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>The camera and the board</source>
        <translation>카메라와 보드</translation>
    </message>
    <message>
        <source>Images of the board</source>
        <translation>보드 사진</translation>
    </message>
    <message>
        <source>The lens</source>
        <translation>렌즈</translation>
    </message>
    <message>
        <source>At least %1 images that show the board are needed; so far there are %2.</source>
        <translation>보드가 보이는 이미지가 %1개 이상 필요합니다. 지금은 %2개입니다.</translation>
    </message>
    <message>
        <source>There is no lens calibration to save yet.</source>
        <translation>아직 저장할 렌즈 보정이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s) of the board</source>
        <translation>
            <numerusform>보드 이미지 %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::LessonBar</name>
    <message>
        <source>Ne&amp;xt</source>
        <translation>다음(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>수업 나가기(&amp;L)</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>수업</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>%1/%2단계</translation>
    </message>
    <message>
        <source>done</source>
        <translation>완료</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>마침(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>다음(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>건너뛰기(&amp;S)</translation>
    </message>
</context>
<context>
    <name>odo::LiveBoard</name>
    <message>
        <source>Top-down map</source>
        <translation>평면 지도</translation>
    </message>
    <message>
        <source>Health of cameras, map and disk</source>
        <translation>카메라, 지도, 디스크의 상태</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>카메라 %1</translation>
    </message>
    <message>
        <source>Live view of %1</source>
        <translation>%1의 실시간 영상</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>정합 안 됨</translation>
    </message>
    <message>
        <source>Opening the camera…</source>
        <translation>카메라를 여는 중…</translation>
    </message>
    <message>
        <source>live, sent to %1</source>
        <translation>실시간, %1(으)로 전송</translation>
    </message>
    <message>
        <source>live</source>
        <translation>실시간</translation>
    </message>
    <message>
        <source>Waiting for the first frame…</source>
        <translation>첫 영상을 기다리는 중…</translation>
    </message>
    <message>
        <source>No frames now</source>
        <translation>지금은 영상 없음</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 fps</translation>
    </message>
</context>
<context>
    <name>odo::LiveCameraBox</name>
    <message>
        <source>Connected camera</source>
        <translation>연결된 카메라</translation>
    </message>
    <message>
        <source>%1, %2×%3</source>
        <translation>%1, %2×%3</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>카메라를 찾는 중…</translation>
    </message>
    <message>
        <source>No camera is connected</source>
        <translation>연결된 카메라가 없습니다</translation>
    </message>
</context>
<context>
    <name>odo::LiveMap</name>
    <message>
        <source>Live floor map with the robots</source>
        <translation>주행 중인 로봇이 표시된 바닥 지도</translation>
    </message>
    <message>
        <source>No camera is registered to the floor: robots cannot be located</source>
        <translation>바닥에 정합된 카메라가 없어 바닥의 위치를 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>odo::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>파일(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>편집(&amp;E)</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>환경 설정(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>도움말(&amp;H)</translation>
    </message>
    <message>
        <source>A recording is running. The change takes effect when you reopen the project.</source>
        <translation>녹화가 진행 중이므로 프로젝트를 다시 열 때 페이지에 반영됩니다.</translation>
    </message>
    <message>
        <source>Restore the backup</source>
        <translation>백업 복원</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph will rescue its contents when the running job has ended.</source>
        <translation>다른 프로그램이 “%1”을(를) 삭제하거나 이름을 바꾸거나 교체했습니다. 진행 중인 작업이 끝나는 대로 내용을 구조합니다.</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph rescued its contents in “%2” and opened that project.</source>
        <translation>다른 프로그램이 “%1”을(를) 삭제하거나 이름을 바꾸거나 교체했습니다. 내용은 “%2”에 구조되었고 지금 열려 있습니다.</translation>
    </message>
    <message>
        <source>Another program overwrote “%1”. Odograph will open the new contents when the running job has ended.</source>
        <translation>다른 프로그램이 “%1”을(를) 덮어썼습니다. 진행 중인 작업이 끝나면 지금 들어 있는 내용을 엽니다.</translation>
    </message>
    <message>
        <source>Another program renamed “%1” and its videos. It is now open as “%2”.</source>
        <translation>다른 프로그램이 “%1”의 이름을 동영상과 함께 바꿨습니다. 이제 “%2”(으)로 열려 있습니다.</translation>
    </message>
    <message>
        <source>Another program overwrote “%1” while it was open. Its earlier contents are gone; the window shows the new ones.</source>
        <translation>열려 있는 동안 다른 프로그램이 “%1”을(를) 덮어써서 이전 내용이 사라졌습니다. 지금 들어 있는 내용을 보여 줍니다.</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>학급(&amp;L)</translation>
    </message>
    <message>
        <source>You and another bench changed the same things. Both versions are kept.</source>
        <translation>이곳과 다른 측정대에서 같은 것을 바꾸었습니다. 두 버전을 모두 보관합니다.</translation>
    </message>
    <message>
        <source>Show both</source>
        <translation>둘 다 보기</translation>
    </message>
    <message>
        <source>Table saved as %1.</source>
        <translation>표를 %1(으)로 저장했습니다.</translation>
    </message>
</context>
<context>
    <name>odo::MapArea</name>
    <message>
        <source>0 to %1 apart</source>
        <translation>차이 0 ~ %1</translation>
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
        <translation>별표(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>보관(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>삭제(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Empty the bin…</source>
        <translation>휴지통 비우기(&amp;E)…</translation>
    </message>
    <message>
        <source>Remove &amp;star</source>
        <translation>별표 떼기(&amp;S)</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>보관 해제(&amp;A)</translation>
    </message>
    <message>
        <source>Rest&amp;ore</source>
        <translation>복원(&amp;P)</translation>
    </message>
    <message>
        <source>Restore the selected trials from the bin (Del)</source>
        <translation>선택한 시행을 휴지통에서 꺼냅니다(Del)</translation>
    </message>
    <message>
        <source>Move the selected trials to the bin (Del); you can restore them</source>
        <translation>선택한 시행을 휴지통에 넣습니다(Del). 복원할 수 있습니다</translation>
    </message>
    <message>
        <source>Empty the bin</source>
        <translation>휴지통 비우기</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation>
            <numerusform>시행 %n개를 완전히 삭제할까요?</numerusform>
        </translation>
    </message>
    <message>
        <source>This removes their videos (%1), measurements and results from the disk. You cannot undo it.</source>
        <translation>해당 동영상(%1)과 측정값과 결과가 디스크에서 삭제됩니다. 되돌릴 수 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Remove for good</source>
        <translation>완전히 삭제(&amp;R)</translation>
    </message>
</context>
<context>
    <name>odo::MarkerCanvas</name>
    <message>
        <source>Image with the markers; arrow keys move the selected one</source>
        <translation>마커가 보이는 사진; 화살표 키로 선택한 마커를 옮깁니다</translation>
    </message>
</context>
<context>
    <name>odo::MarkerPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>빼기(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>마커</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>위치, mm</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>인식한 것</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>오차</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>마커</translation>
    </message>
    <message>
        <source>found</source>
        <translation>찾음</translation>
    </message>
    <message>
        <source>Select a marker in the table and click its position. The click snaps to what is near it, to a tenth of a pixel.</source>
        <translation>표에서 마커를 선택하고 그 위치를 클릭하십시오. 클릭한 곳 근처의 표식에 10분의 1픽셀까지 맞춥니다.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>보이지 않음</translation>
    </message>
</context>
<context>
    <name>odo::MatDialog</name>
    <message>
        <source>Find the floor mat</source>
        <translation>바닥 매트 찾기</translation>
    </message>
    <message>
        <source>The mat is searched for in the newest recording of each camera: %1.</source>
        <translation>각 카메라의 최신 녹화에서 매트를 찾습니다: %1.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure the line at the mat&apos;s lower edge from end mark to end mark. Printers often shrink by 2 to 4 %; what you enter makes up for it.</source>
        <translation>매트 아래쪽 가장자리의 선을 끝 표시에서 끝 표시까지 재십시오. 프린터는 흔히 2~4 % 줄여 인쇄하며, 입력한 값이 이를 보정합니다.</translation>
    </message>
    <message>
        <source>&amp;Check line</source>
        <translation>확인선(&amp;C)</translation>
    </message>
    <message>
        <source>Find the mat</source>
        <translation>매트 찾기</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>재지 않음</translation>
    </message>
</context>
<context>
    <name>odo::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>메시지 닫기</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
</context>
<context>
    <name>odo::MessagePanel</name>
    <message>
        <source>No messages.</source>
        <translation>메시지가 없습니다.</translation>
    </message>
    <message>
        <source>Dismiss &amp;all</source>
        <translation>모두 지우기(&amp;A)</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>메시지</translation>
    </message>
    <message>
        <source>Close the list of messages</source>
        <translation>메시지 목록 닫기</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>닫기 (Esc)</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n times</source>
        <translation>
            <numerusform>%1, %n번</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>지우기: %1</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>지우기</translation>
    </message>
</context>
<context>
    <name>odo::MetricGrid</name>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>No result yet: track the trial</source>
        <translation>아직 결과 없음: 시행을 추적하십시오</translation>
    </message>
</context>
<context>
    <name>odo::MetricModel</name>
    <message>
        <source>Metric</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
</context>
<context>
    <name>odo::ModeBar</name>
    <message>
        <source>Modes</source>
        <translation>모드</translation>
    </message>
</context>
<context>
    <name>odo::NetworkPage</name>
    <message>
        <source>&amp;Send live positions on the network</source>
        <translation>실시간 위치를 네트워크로 보내기(&amp;S)</translation>
    </message>
    <message>
        <source>%1: this computer only</source>
        <translation>%1: 이 컴퓨터만</translation>
    </message>
    <message>
        <source>%1: not available now</source>
        <translation>%1: 지금은 없음</translation>
    </message>
    <message>
        <source>Positions of the robots that Record tracks, as SSL-Vision packets for your own controllers and programs. The packets contain no names of teams or robots.</source>
        <translation>녹화 화면에서 따라가는 로봇의 위치를 제어기나 자작 프로그램에서 쓰도록 SSL-Vision 패킷으로 보냅니다. 팀이나 로봇의 이름은 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>주소(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>포트(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Interface</source>
        <translation>인터페이스(&amp;I)</translation>
    </message>
    <message>
        <source>Odograph sends nothing.</source>
        <translation>아무것도 보내지 않습니다.</translation>
    </message>
    <message>
        <source>This is not an IPv4 address; enter one such as 224.5.23.2.</source>
        <translation>IPv4 주소가 아닙니다. 224.5.23.2와 같이 쓰십시오.</translation>
    </message>
    <message>
        <source>They go only to the computer with this address.</source>
        <translation>이 주소를 가진 컴퓨터 한 대로만 보냅니다.</translation>
    </message>
    <message>
        <source>They do not leave this computer.</source>
        <translation>이 컴퓨터 밖으로 나가지 않습니다.</translation>
    </message>
    <message>
        <source>Anyone on that network can read the robots&apos; positions.</source>
        <translation>해당 네트워크에 있는 사람은 누구나 로봇의 위치를 읽을 수 있습니다.</translation>
    </message>
</context>
<context>
    <name>odo::NumberText</name>
    <message>
        <source>points</source>
        <translation>점</translation>
    </message>
</context>
<context>
    <name>odo::OwnMetricsDialog</name>
    <message>
        <source>&amp;Remove</source>
        <translation>제거(&amp;R)</translation>
    </message>
    <message>
        <source>Own metrics</source>
        <translation>사용자 지표</translation>
    </message>
    <message>
        <source>A formula uses metrics in the units below, variables of the trials that are numbers, + - * / ^, brackets, sqrt, abs, exp, ln, sin, cos, min, max and pi. Names with blanks are in braces: 0.5 * {robot mass} * max_speed^2.</source>
        <translation>수식에는 아래 단위의 지표, 숫자인 시행 변수, + - * / ^, 괄호, sqrt, abs, exp, ln, sin, cos, min, max, pi를 쓸 수 있습니다. 공백이 있는 이름은 중괄호로 묶습니다: 0.5 * {robot mass} * max_speed^2.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>수식</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>추가(&amp;A)</translation>
    </message>
    <message>
        <source>Names for formulas</source>
        <translation>수식에 쓸 이름</translation>
    </message>
</context>
<context>
    <name>odo::PathField</name>
    <message>
        <source>Browse…</source>
        <translation>찾아보기…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>찾아보기: %1</translation>
    </message>
    <message>
        <source>Images and videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;All files (*)</source>
        <translation>사진과 동영상 (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;모든 파일 (*)</translation>
    </message>
</context>
<context>
    <name>odo::PathSketch</name>
    <message>
        <source>The path from above</source>
        <translation>위에서 본 경로</translation>
    </message>
</context>
<context>
    <name>odo::PickColourDialog</name>
    <message>
        <source>Pick the robot&apos;s colour</source>
        <translation>사진에서 로봇 색 고르기</translation>
    </message>
    <message>
        <source>Another &amp;video…</source>
        <translation>다른 동영상(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>녹화(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>프레임(&amp;F)</translation>
    </message>
    <message>
        <source>Choose a video that shows the robot.</source>
        <translation>로봇이 보이는 동영상을 선택하십시오.</translation>
    </message>
    <message>
        <source>Use this colour</source>
        <translation>이 색 사용</translation>
    </message>
    <message>
        <source>Video that shows the robot</source>
        <translation>로봇이 보이는 동영상</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)</source>
        <translation>동영상 (*.mp4 *.mov *.mkv *.avi *.m4v);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>The robot&apos;s colour here: %1. It fills %2 % of the box.</source>
        <translation>여기서 로봇의 색: %1. 상자의 %2 %를 차지합니다.</translation>
    </message>
    <message>
        <source>Draw a tight box round the robot with the mouse, or use the keyboard: arrow keys move the box, Shift + arrow keys resize it.</source>
        <translation>마우스로 로봇을 바짝 둘러싸는 상자를 그리십시오. 화살표 키로는 상자를 옮기고, Shift와 함께 누르면 크기를 바꿉니다.</translation>
    </message>
    <message>
        <source>%1, camera %2</source>
        <translation>%1, 카메라 %2</translation>
    </message>
</context>
<context>
    <name>odo::PlannedCameraForm</name>
    <message>
        <source>Position x</source>
        <translation>카메라 위치 x</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>카메라 위치 y</translation>
    </message>
    <message>
        <source>Height of the camera</source>
        <translation>카메라 높이</translation>
    </message>
    <message>
        <source>Looks at x</source>
        <translation>바라보는 곳 x</translation>
    </message>
    <message>
        <source>Looks at y</source>
        <translation>바라보는 곳 y</translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation>바라보는 방향</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>화각</translation>
    </message>
    <message>
        <source>0° is along X, 90° along Y; the point that the camera looks at turns with it</source>
        <translation>0°는 X축 방향, 90°는 Y축 방향입니다. 돌리면 바라보는 점이 카메라를 중심으로 돕니다</translation>
    </message>
    <message>
        <source>Across the image width: a webcam has about 60° to 80°, a phone 65°</source>
        <translation>영상의 가로 방향 화각: 웹캠은 약 60°~80°, 휴대전화는 65°</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>영상 크기</translation>
    </message>
    <message>
        <source>Po&amp;sition x, y</source>
        <translation>카메라 위치 x, y(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>높이(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Looks at x, y</source>
        <translation>바라보는 곳 x, y(&amp;L)</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>방향(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>화각(&amp;F)</translation>
    </message>
</context>
<context>
    <name>odo::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>환경 설정</translation>
    </message>
    <message>
        <source>Categories of preferences</source>
        <translation>환경 설정 종류</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>일반(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Reports</source>
        <translation>보고서(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>단축키(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Network</source>
        <translation>네트워크(&amp;N)</translation>
    </message>
</context>
<context>
    <name>odo::PresentWindow</name>
    <message>
        <source>Presentation</source>
        <translation>발표</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>No trial</source>
        <translation>시행 없음</translation>
    </message>
    <message>
        <source>Speed now</source>
        <translation>현재 속력</translation>
    </message>
</context>
<context>
    <name>odo::ProfileChart</name>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>가속도</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>진행 방향</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>선회율</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>위치 X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>위치 Y</translation>
    </message>
    <message>
        <source>Quantity of the chart</source>
        <translation>차트에 표시할 양</translation>
    </message>
    <message>
        <source>smoothed ±95 %</source>
        <translation>평활화 ±95 %</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>측정점</translation>
    </message>
    <message>
        <source>1 spike</source>
        <translation>이상점 1개</translation>
    </message>
    <message>
        <source>%1 spikes</source>
        <translation>이상점 %1개</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>경로 방향</translation>
    </message>
    <message>
        <source>of the motion, anticlockwise from X</source>
        <translation>움직임의 방향, X축에서 반시계 방향</translation>
    </message>
    <message>
        <source>anticlockwise positive</source>
        <translation>반시계 방향이 양</translation>
    </message>
    <message>
        <source>Chart: %1 over time</source>
        <translation>차트: 시간에 따른 %1</translation>
    </message>
    <message>
        <source>Chart: %1 over distance</source>
        <translation>차트: 거리에 따른 %1</translation>
    </message>
    <message>
        <source>of the body, anticlockwise from X</source>
        <translation>몸체의 방향, X축에서 반시계 방향</translation>
    </message>
    <message>
        <source>shaded: hidden, ambiguous or not measured</source>
        <translation>음영: 가려짐, 불확실 또는 측정되지 않음</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>속도 X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>속도 Y</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>횡가속도</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>저크</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>이동 거리</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>시작점까지의 거리</translation>
    </message>
    <message>
        <source>to the left positive</source>
        <translation>왼쪽이 양</translation>
    </message>
    <message>
        <source>along the path, mean over %1</source>
        <translation>경로 방향, %1 평균</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>가장 가까운 로봇까지의 거리</translation>
    </message>
</context>
<context>
    <name>odo::RangeActions</name>
    <message>
        <source>Set &amp;start here</source>
        <translation>여기를 시작으로 설정(&amp;S)</translation>
    </message>
    <message>
        <source>The results are of the run from this time on; before it nothing counts.</source>
        <translation>결과는 이 시각부터의 주행에 대한 것이며, 그 이전은 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>Set &amp;end here</source>
        <translation>여기를 끝으로 설정(&amp;E)</translation>
    </message>
    <message>
        <source>The results are of the run up to this time; after it nothing counts.</source>
        <translation>결과는 이 시각까지의 주행에 대한 것이며, 그 이후는 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>From first to last &amp;motion</source>
        <translation>처음 움직임부터 마지막 움직임까지(&amp;M)</translation>
    </message>
    <message>
        <source>The results are of the run from when a robot first moves to when it last does.</source>
        <translation>결과는 로봇이 처음 움직인 때부터 마지막으로 움직인 때까지의 주행에 대한 것입니다.</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>전체 주행(&amp;W)</translation>
    </message>
    <message>
        <source>The results are of all of the trial again.</source>
        <translation>결과가 다시 시행 전체에 대한 것이 됩니다.</translation>
    </message>
</context>
<context>
    <name>odo::RangeCard</name>
    <message>
        <source>&amp;Fit</source>
        <translation>피팅(&amp;F)</translation>
    </message>
    <message>
        <source>Robot of the statistics</source>
        <translation>범위를 표시할 로봇</translation>
    </message>
    <message>
        <source>Function to fit to the curve</source>
        <translation>곡선에 피팅할 함수</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>상수</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>직선</translation>
    </message>
    <message>
        <source>parabola</source>
        <translation>포물선</translation>
    </message>
    <message>
        <source>Fitted quantity</source>
        <translation>피팅할 양</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>Statistics of the selection</source>
        <translation>선택의 지표</translation>
    </message>
</context>
<context>
    <name>odo::RecordPage</name>
    <message>
        <source>No camera is connected</source>
        <translation>연결된 카메라가 없습니다</translation>
    </message>
    <message>
        <source>Connect one or two cameras, then search again. If a connected camera is not found, run the set-up doctor.</source>
        <translation>카메라를 한 대나 두 대 연결하고 다시 찾으십시오. 연결했는데도 찾지 못하면 장비 진단을 실행하십시오.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>다시 찾기</translation>
    </message>
    <message>
        <source>Set-up doctor…</source>
        <translation>장비 진단…</translation>
    </message>
    <message>
        <source>Choose &amp;cameras…</source>
        <translation>카메라 선택(&amp;C)…</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>카메라…</translation>
    </message>
    <message>
        <source>Assign the connected devices to the cameras of the project</source>
        <translation>연결된 장치가 각각 프로젝트의 어느 카메라인지 지정합니다</translation>
    </message>
    <message>
        <source>Set-up &amp;doctor…</source>
        <translation>장비 진단(&amp;D)…</translation>
    </message>
    <message>
        <source>Doctor…</source>
        <translation>진단…</translation>
    </message>
    <message>
        <source>Check for what makes cameras lose frames or measure wrongly, and get advice</source>
        <translation>카메라의 영상 누락이나 잘못된 측정의 원인을 찾아 조치를 안내합니다</translation>
    </message>
    <message>
        <source>Give the trial a name</source>
        <translation>시행의 이름을 지정하십시오</translation>
    </message>
    <message>
        <source>Register a camera to the floor, or begin at once</source>
        <translation>카메라를 바닥에 정합하거나 즉시 시작하십시오</translation>
    </message>
</context>
<context>
    <name>odo::ReferenceCameraPage</name>
    <message>
        <source>Image or video of the camera to register</source>
        <translation>정합할 카메라의 사진 또는 동영상</translation>
    </message>
    <message>
        <source>Image or video of the registered camera</source>
        <translation>정합된 카메라의 사진 또는 동영상</translation>
    </message>
    <message>
        <source>A camera cannot be registered via itself: choose two different ones.</source>
        <translation>카메라를 자신을 통해 정합할 수는 없습니다. 서로 다른 두 카메라를 선택하십시오.</translation>
    </message>
    <message>
        <source>Camera to register</source>
        <translation>정합할 카메라</translation>
    </message>
    <message>
        <source>Registered camera</source>
        <translation>정합된 카메라</translation>
    </message>
    <message>
        <source>Register a camera that sees no markers by floor points that a registered camera also sees: corners of tiles, ends of tape, screws. Four are enough; six or more, spread over the common area, are better. Do not move either camera afterwards.</source>
        <translation>마커가 보이지 않는 카메라는 정합된 카메라에도 보이는 바닥의 점, 곧 타일 모서리, 테이프 끝, 나사 등으로 정합할 수 있습니다. 네 개면 충분하고, 함께 보이는 영역에 고루 퍼진 여섯 개 이상이면 더 좋습니다. 이후에는 두 카메라 모두 움직이면 안 됩니다.</translation>
    </message>
    <message>
        <source>C&amp;amera to register</source>
        <translation>정합할 카메라(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Via camera</source>
        <translation>통할 카메라(&amp;T)</translation>
    </message>
    <message>
        <source>Its image</source>
        <translation>그 카메라의 사진</translation>
    </message>
    <message>
        <source>The registered camera&apos;s image</source>
        <translation>정합된 카메라의 사진</translation>
    </message>
    <message>
        <source>Choose an image for each camera.</source>
        <translation>카메라마다 이미지를 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>odo::RegisterViaCameraWizard</name>
    <message>
        <source>Register via another camera</source>
        <translation>다른 카메라를 통해 정합</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Two cameras and their images</source>
        <translation>두 카메라와 사진</translation>
    </message>
    <message>
        <source>The same points in both images</source>
        <translation>두 사진의 같은 점</translation>
    </message>
    <message>
        <source>Loading the images…</source>
        <translation>사진을 가져오는 중…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>아직 저장할 정합이 없습니다.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>정합</translation>
    </message>
</context>
<context>
    <name>odo::RegistrationVerdict</name>
    <message>
        <source>Camera position</source>
        <translation>카메라가 있는 곳</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Camera position: x %1 m, y %2 m, %3 m above the floor.</source>
        <translation>카메라는 x %1 m, y %2 m, 바닥에서 높이 %3 m에 있습니다.</translation>
    </message>
    <message>
        <source>The registration was not stored. %1</source>
        <translation>정합을 저장하지 못했습니다. %1</translation>
    </message>
</context>
<context>
    <name>odo::ReportActions</name>
    <message>
        <source>The trial %1</source>
        <translation>시행 %1</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>보고서(&amp;R)…</translation>
    </message>
    <message>
        <source>The comparison of %1 and %2</source>
        <translation>%1과(와) %2의 비교</translation>
    </message>
    <message>
        <source>A class</source>
        <translation>학급</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), a page each</source>
        <translation>
            <numerusform>시행 %n개, 한 쪽씩</numerusform>
        </translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>보고서 저장</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF 파일 (*.pdf)</translation>
    </message>
    <message>
        <source>Report saved as %1.</source>
        <translation>보고서를 %1에 저장했습니다.</translation>
    </message>
    <message>
        <source>Report sent to printer %1.</source>
        <translation>보고서를 프린터 %1(으)로 보냈습니다.</translation>
    </message>
    <message>
        <source>Over the floor that the cameras see</source>
        <translation>카메라가 보는 바닥 위</translation>
    </message>
    <message>
        <source>The simulated run:</source>
        <translation>시뮬레이션할 주행:</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>인증서 저장</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>인증서</translation>
    </message>
    <message>
        <source>Certificate saved as %1.</source>
        <translation>인증서를 %1에 저장했습니다.</translation>
    </message>
    <message>
        <source>C&amp;ertificate of this set-up…</source>
        <translation>이 설정의 인증서(&amp;E)…</translation>
    </message>
</context>
<context>
    <name>odo::ReportDialog</name>
    <message>
        <source>A page for each &amp;team</source>
        <translation>팀마다 한 쪽씩(&amp;T)</translation>
    </message>
    <message>
        <source>A second page with the &amp;method</source>
        <translation>둘째 쪽에 방법 싣기(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>PDF로 저장(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>인쇄(&amp;P)…</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>학급(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>과제(&amp;T)</translation>
    </message>
    <message>
        <source>Most common</source>
        <translation>주된 과제</translation>
    </message>
    <message>
        <source>M&amp;etric</source>
        <translation>지표(&amp;F)</translation>
    </message>
    <message>
        <source>Most informative</source>
        <translation>가장 뜻있는 지표</translation>
    </message>
    <message>
        <source>Report &amp;of</source>
        <translation>보고 대상(&amp;O)</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>용지(&amp;A)</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>레터</translation>
    </message>
    <message>
        <source>School, &amp;logo and wording…</source>
        <translation>학교, 로고, 문구(&amp;L)…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Nothing to print yet.</source>
        <translation>아직 인쇄할 것이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n쪽</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n page(s); the file has all of them.</source>
        <translation>
            <numerusform>처음 %n쪽입니다. 파일에는 모두 들어 있습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportPreview</name>
    <message>
        <source>Preview of the pages</source>
        <translation>쪽 미리 보기</translation>
    </message>
    <message>
        <source>Drawing the pages…</source>
        <translation>쪽을 그리는 중…</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n쪽</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportsPage</name>
    <message>
        <source>&amp;School</source>
        <translation>학교(&amp;S)</translation>
    </message>
    <message>
        <source>shown at the top of each page</source>
        <translation>각 쪽의 머리에 나옵니다</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>로고</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.svg)</source>
        <translation>그림 (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
        <source>&amp;Logo</source>
        <translation>로고(&amp;L)</translation>
    </message>
    <message>
        <source>Preview of the logo</source>
        <translation>로고 모양</translation>
    </message>
    <message>
        <source>&amp;At the bottom</source>
        <translation>쪽 아래(&amp;A)</translation>
    </message>
    <message>
        <source>for example: whom to ask</source>
        <translation>예: 문의할 곳</translation>
    </message>
</context>
<context>
    <name>odo::ReprocessDialog</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>&amp;Reanalyse</source>
        <translation>다시 측정(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>유지(&amp;K)</translation>
    </message>
    <message>
        <source>Reanalyse trials</source>
        <translation>시행 다시 측정</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>After</source>
        <translation>이후</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>변화</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>바뀌는 것</translation>
    </message>
    <message>
        <source>What changes, in words</source>
        <translation>바뀌는 것(글)</translation>
    </message>
    <message>
        <source>What was detected in the videos stays as it is; its floor positions are recomputed with the current registrations. Check what changes, then keep it or not: the older analysis stays in the project too.</source>
        <translation>동영상에서 본 것은 그대로 두고, 바닥의 어디인지를 지금 적용 중인 정합으로 계산합니다. 무엇이 바뀌는지 보고 유지할지 정하십시오. 이전 분석도 프로젝트에 남습니다.</translation>
    </message>
    <message>
        <source>&amp;Trial</source>
        <translation>시행(&amp;T)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>%1 (measured with an older registration)</source>
        <translation>%1(이전 정합으로 측정됨)</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>측정 중…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Kept: the new analysis of %1 is the current one.</source>
        <translation>유지했습니다. %1의 새 분석이 현재 분석입니다.</translation>
    </message>
</context>
<context>
    <name>odo::ResidualPlot</name>
    <message>
        <source>Residual against the cut-off</source>
        <translation>차단 주파수에 따른 잔차</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>residual analysis</source>
        <translation>잔차 분석</translation>
    </message>
    <message>
        <source>a filter of %1 takes away %2</source>
        <translation>%1 필터는 %2을(를) 제거</translation>
    </message>
</context>
<context>
    <name>odo::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Robot whose result is shown</source>
        <translation>결과를 표시할 로봇</translation>
    </message>
    <message>
        <source>robot “%1”</source>
        <translation>로봇 “%1”</translation>
    </message>
</context>
<context>
    <name>odo::ResultStatisticsModel</name>
    <message>
        <source>Metric</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>Number of values: runs without bad results, lower bounds or another course</source>
        <translation>값의 수: 나쁜 결과, 하한, 다른 코스를 뺀 주행</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>주행</translation>
    </message>
    <message>
        <source>Mean ± its standard error (SD / √runs)</source>
        <translation>평균 ± 표준 오차(SD / √주행 수)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>평균</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>중앙값</translation>
    </message>
    <message>
        <source>Standard deviation of one run</source>
        <translation>주행 하나의 표준 편차</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>Coefficient of variation: SD as a part of the mean</source>
        <translation>변동 계수: 평균에 대한 SD의 비율</translation>
    </message>
    <message>
        <source>CV %</source>
        <translation>CV %</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>Most</source>
        <translation>최대</translation>
    </message>
</context>
<context>
    <name>odo::ResultsModel</name>
    <message>
        <source>not tracked</source>
        <translation>추적 안 함</translation>
    </message>
    <message>
        <source>Not used in means: a lower bound, a bad result, or another course</source>
        <translation>평균에 쓰지 않음: 하한, 나쁜 결과 또는 다른 코스</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
</context>
<context>
    <name>odo::ResultsPanel</name>
    <message>
        <source>Results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Group by</source>
        <translation>그룹 기준</translation>
    </message>
    <message>
        <source>Results of the trials</source>
        <translation>시행 결과</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>통계</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>모든 학급</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>모든 과제</translation>
    </message>
    <message>
        <source>No groups</source>
        <translation>그룹 없음</translation>
    </message>
    <message>
        <source>Search…</source>
        <translation>검색…</translation>
    </message>
    <message>
        <source>Search the results</source>
        <translation>결과 검색</translation>
    </message>
    <message>
        <source>Trials, teams, robots, tags and variables with all of these words</source>
        <translation>이 단어가 모두 들어 있는 시행, 팀, 로봇, 태그, 변수</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Which metrics are shown</source>
        <translation>표시할 지표</translation>
    </message>
    <message>
        <source>&amp;Save table…</source>
        <translation>표 저장(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Copy with headings</source>
        <translation>머리글과 함께 복사(&amp;C)</translation>
    </message>
    <message>
        <source>By team</source>
        <translation>팀별</translation>
    </message>
    <message>
        <source>By class</source>
        <translation>학급별</translation>
    </message>
    <message>
        <source>By task</source>
        <translation>과제별</translation>
    </message>
    <message>
        <source>By robot</source>
        <translation>로봇별</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>%1별</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>주행 %n개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n run(s)</source>
        <translation>
            <numerusform>주행 %n개 중 %1개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n run(s) shown</source>
        <translation>
            <numerusform>표시된 주행 %n개의 통계</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n selected run(s)</source>
        <translation>
            <numerusform>선택한 주행 %n개의 통계</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>표 저장</translation>
    </message>
    <message>
        <source>Workbook with statistics (*.xlsx)</source>
        <translation>통계가 있는 통합 문서 (*.xlsx)</translation>
    </message>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>프로그램용 CSV (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>스프레드시트용 CSV, 1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>스프레드시트용 CSV, 1,5 (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Own metrics…</source>
        <translation>사용자 지표(&amp;O)…</translation>
    </message>
</context>
<context>
    <name>odo::ReviewColumn</name>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>시행 정보</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet. Tracking follows the robot through the videos and computes its position and speed.</source>
        <translation>이 시행은 아직 추적하지 않았습니다. 추적은 동영상에서 로봇을 따라가며 어디에 있었고 얼마나 빨랐는지 구합니다.</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>추적…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>The areas have changed since this trial was tracked. Track it again to use them.</source>
        <translation>이 시행을 추적한 뒤 영역이 바뀌었습니다. 적용하려면 다시 추적하세요.</translation>
    </message>
</context>
<context>
    <name>odo::ReviewDesk</name>
    <message>
        <source>&amp;Silhouettes of the robots</source>
        <translation>로봇의 실루엣(&amp;S)</translation>
    </message>
    <message>
        <source>Outline the detected robots in each view</source>
        <translation>각 화면에서 로봇으로 여긴 부분의 윤곽선을 그립니다</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>확대(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>축소(&amp;O)</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>맞춤(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Enlarge, or back</source>
        <translation>크게 보기 또는 되돌리기(&amp;E)</translation>
    </message>
    <message>
        <source>Of the view or map under the mouse</source>
        <translation>마우스 아래의 뷰나 지도</translation>
    </message>
    <message>
        <source>Lo&amp;upe on the robot</source>
        <translation>로봇 돋보기(&amp;U)</translation>
    </message>
    <message>
        <source>Show the surroundings of the robot eight times as large as recorded</source>
        <translation>로봇 주변을 녹화 화면의 여덟 배로 보여 줍니다</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>발표(&amp;P)</translation>
    </message>
    <message>
        <source>Team, map, speed and result in large type, on a second screen if there is one</source>
        <translation>팀, 지도, 속력, 결과를 큰 글씨로 보여 줍니다. 두 번째 화면이 있으면 그곳에 나옵니다</translation>
    </message>
</context>
<context>
    <name>odo::ReviewPage</name>
    <message>
        <source>No trials yet</source>
        <translation>아직 시행이 없습니다</translation>
    </message>
    <message>
        <source>A trial is one run of a robot. Import the videos that your cameras took of it to see it here.</source>
        <translation>시행은 로봇의 주행 한 번입니다. 카메라로 찍은 동영상을 가져오면 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>동영상에서 시행 가져오기…</translation>
    </message>
    <message>
        <source>Accept doubtful results</source>
        <translation>의심스러운 결과 승인</translation>
    </message>
    <message>
        <source>Why can these results be used? The reason is shown wherever they are.</source>
        <translation>이 결과를 왜 쓸 수 있습니까? 이유는 결과가 표시되는 모든 곳에 표시됩니다.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionImage</name>
    <message>
        <source>Source image</source>
        <translation>이것을 만든 사진</translation>
    </message>
    <message>
        <source>Reading the image…</source>
        <translation>사진을 읽는 중…</translation>
    </message>
    <message>
        <source>Cannot read the image.</source>
        <translation>사진을 읽을 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionsDialog</name>
    <message>
        <source>&amp;Use this one</source>
        <translation>이 버전 사용(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Register with this calibration</source>
        <translation>이 렌즈로 정합(&amp;R)</translation>
    </message>
    <message>
        <source>Reanalyse &amp;trials…</source>
        <translation>시행 다시 측정(&amp;M)…</translation>
    </message>
    <message>
        <source>Calibrations and registrations</source>
        <translation>보정과 정합</translation>
    </message>
    <message>
        <source>What</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>만든 때</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>From</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>적용</translation>
    </message>
    <message>
        <source>Revisions</source>
        <translation>버전</translation>
    </message>
    <message>
        <source>Makes the selected revision the current one for new measurements; trials keep theirs</source>
        <translation>선택한 버전을 앞으로의 측정에 적용합니다. 시행은 쓰던 버전을 유지합니다</translation>
    </message>
    <message>
        <source>Recomputes the current registration from the same markers, with the current lens calibration</source>
        <translation>적용 중인 정합을 같은 마커와 적용 중인 렌즈로 새로 계산합니다</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>카메라(&amp;A)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>The camera is neither calibrated nor registered yet.</source>
        <translation>이 카메라는 아직 보정도 정합도 하지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Calibration %1</source>
        <translation>보정 %1</translation>
    </message>
    <message>
        <source>Registration %1</source>
        <translation>정합 %1</translation>
    </message>
    <message>
        <source>current</source>
        <translation>적용 중</translation>
    </message>
    <message>
        <source>No trial uses it.</source>
        <translation>이것으로 측정한 시행이 없습니다.</translation>
    </message>
    <message>
        <source>Trials that use it: %1.</source>
        <translation>이것으로 측정한 시행: %1.</translation>
    </message>
    <message>
        <source>%1 is now current. The registrations keep the lens calibration that they were made with: register the camera with this one.</source>
        <translation>%1을(를) 적용했습니다. 기존 정합은 만들 때의 렌즈를 유지합니다. 이 렌즈로 카메라를 정합하십시오.</translation>
    </message>
    <message>
        <source>%1 is now current. Trials keep theirs until you reanalyse them.</source>
        <translation>%1을(를) 적용했습니다. 시행은 다시 측정할 때까지 쓰던 것을 유지합니다.</translation>
    </message>
    <message>
        <source>Registration %1 is now current: the same markers, with this lens calibration. %2</source>
        <translation>정합 %1을(를) 적용했습니다. 같은 마커를 이 렌즈로 계산했습니다. %2</translation>
    </message>
</context>
<context>
    <name>odo::RmsSoFar</name>
    <message>
        <source>RMS so far</source>
        <translation>현재까지의 RMS</translation>
    </message>
    <message>
        <source>RMS: from %1 images on</source>
        <translation>RMS: 이미지 %1장부터</translation>
    </message>
    <message>
        <source>RMS: not yet, %1</source>
        <translation>RMS: 아직 없음, %1</translation>
    </message>
    <message>
        <source>RMS so far: %1 px; highest: %2 px in %3</source>
        <translation>현재까지의 RMS: %1 px, 최댓값: %3의 %2 px</translation>
    </message>
</context>
<context>
    <name>odo::RobotDialog</name>
    <message>
        <source>Add robot</source>
        <translation>로봇 추가</translation>
    </message>
    <message>
        <source>Estimated from the views</source>
        <translation>뷰에서 구함</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>직접 잼</translation>
    </message>
    <message>
        <source>Changes while it runs (ramp)</source>
        <translation>주행 중 바뀜(경사로)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Height of the robot&apos;s top</source>
        <translation>로봇 윗면의 높이</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>이름(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Pick from a video…</source>
        <translation>사진에서(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Colour of its top</source>
        <translation>윗면 색(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Drawn in</source>
        <translation>표시 색(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Height of its top</source>
        <translation>윗면 높이(&amp;H)</translation>
    </message>
    <message>
        <source>Colour of the robot&apos;s top</source>
        <translation>로봇 윗면의 색</translation>
    </message>
    <message>
        <source>Change robot</source>
        <translation>로봇 변경</translation>
    </message>
    <message>
        <source>Its silhouette</source>
        <translation>바닥과 다른 점</translation>
    </message>
    <message>
        <source>A colour of its own</source>
        <translation>고유한 색</translation>
    </message>
    <message>
        <source>The silhouette works for any robot. A colour of its own helps if several things move.</source>
        <translation>어떤 모습의 로봇이든 바닥과 다른 점으로 찾습니다. 여러 물체가 움직이는 곳에서는 고유한 색이 도움이 됩니다.</translation>
    </message>
    <message>
        <source>D&amp;etected by</source>
        <translation>찾는 방법(&amp;F)</translation>
    </message>
    <message>
        <source>Colour in charts and maps; the robot itself may have another</source>
        <translation>로봇의 모습과 상관없이 차트와 지도에 쓰이는 색</translation>
    </message>
    <message>
        <source>Offset from the middle of the robot&apos;s footprint; 0 and 0 is the middle itself.</source>
        <translation>로봇이 바닥에서 차지하는 영역의 중심에서 잰 값입니다. 0과 0은 중심 자체입니다.</translation>
    </message>
    <message>
        <source> mm forward</source>
        <translation> mm 앞</translation>
    </message>
    <message>
        <source>Reference point, forward of the robot&apos;s middle</source>
        <translation>측정점, 로봇 중심의 앞쪽</translation>
    </message>
    <message>
        <source> mm left</source>
        <translation> mm 왼쪽</translation>
    </message>
    <message>
        <source>Reference point, left of the robot&apos;s middle</source>
        <translation>측정점, 로봇 중심의 왼쪽</translation>
    </message>
    <message>
        <source>&amp;Reference point</source>
        <translation>측정점(&amp;M)</translation>
    </message>
</context>
<context>
    <name>odo::RobotFootprint</name>
    <message>
        <source>The robot from above, heading to the right</source>
        <translation>위에서 본 로봇, 오른쪽을 향함</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>No size given. Drawn as %1 × %2 mm</source>
        <translation>크기가 지정되지 않음. %1 × %2 mm로 그림</translation>
    </message>
</context>
<context>
    <name>odo::RobotPointing</name>
    <message>
        <source>&amp;Point out a robot</source>
        <translation>로봇 가리키기(&amp;P)</translation>
    </message>
    <message>
        <source>Wrong object outlined? Click the robot in a view to track the trial again (%1)</source>
        <translation>엉뚱한 것에 윤곽이 그려져 있습니다: 영상에서 로봇을 클릭하면 시행을 다시 추적합니다 (%1)</translation>
    </message>
    <message>
        <source>This is %1: track it again</source>
        <translation>이것이 %1입니다: 다시 추적</translation>
    </message>
    <message>
        <source>Find %1 automatically</source>
        <translation>도움 없이 %1 찾기</translation>
    </message>
</context>
<context>
    <name>odo::RobotsDialog</name>
    <message>
        <source>estimated from the views</source>
        <translation>뷰에서 구함</translation>
    </message>
    <message>
        <source>changes while it runs</source>
        <translation>주행 중 바뀜</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>추가(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>편집(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>삭제(&amp;D)</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Drawn in</source>
        <translation>표시 색</translation>
    </message>
    <message>
        <source>Height of its top</source>
        <translation>윗면 높이</translation>
    </message>
    <message>
        <source>Length × width</source>
        <translation>길이 × 너비</translation>
    </message>
    <message>
        <source>A new colour or height applies from the next tracking on; earlier results stay as they are.</source>
        <translation>색이나 높이를 바꾸면 다음 추적부터 반영되며, 이미 측정한 것은 그대로 남습니다.</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>작업 결과</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>its silhouette</source>
        <translation>실루엣</translation>
    </message>
    <message>
        <source>Detected by</source>
        <translation>찾는 방법</translation>
    </message>
</context>
<context>
    <name>odo::RunCard</name>
    <message>
        <source>Up now</source>
        <translation>현재 차례</translation>
    </message>
    <message>
        <source>Robots of this run</source>
        <translation>주행하는 로봇</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>학급(&amp;C)</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>팀(&amp;A)</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>과제(&amp;K)</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>로봇(&amp;O)</translation>
    </message>
    <message>
        <source>Trial &amp;name</source>
        <translation>시행 이름(&amp;N)</translation>
    </message>
    <message>
        <source>Be&amp;gins</source>
        <translation>시작(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Laps</source>
        <translation>랩 수(&amp;L)</translation>
    </message>
    <message>
        <source>Number of laps</source>
        <translation>끝날 때까지의 랩 수</translation>
    </message>
    <message>
        <source>Team of this run</source>
        <translation>차례인 팀</translation>
    </message>
    <message>
        <source>When the recording begins</source>
        <translation>녹화 시작 방법</translation>
    </message>
    <message>
        <source>no class</source>
        <translation>학급 없음</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>no team</source>
        <translation>팀 없음</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>off</source>
        <translation>꺼짐</translation>
    </message>
    <message>
        <source>Seconds recorded before the start</source>
        <translation>시작 전에 녹화되는 초</translation>
    </message>
    <message>
        <source>Frames of this time are kept in memory, so a late press loses nothing</source>
        <translation>이 시간의 프레임을 메모리에 보관하므로 늦게 눌러도 잃는 것이 없습니다</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>시작 전</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>종료</translation>
    </message>
    <message>
        <source>At rest for</source>
        <translation>정지 시간</translation>
    </message>
    <message>
        <source>After start</source>
        <translation>시작 후</translation>
    </message>
    <message>
        <source>When the recording ends</source>
        <translation>녹화가 끝나는 때</translation>
    </message>
    <message>
        <source>Seconds without motion that end the recording</source>
        <translation>녹화를 끝내는 움직임 없는 초</translation>
    </message>
    <message>
        <source>Seconds after the start that end the recording</source>
        <translation>녹화를 끝내는 시작 후 초</translation>
    </message>
</context>
<context>
    <name>odo::RunChooser</name>
    <message>
        <source>start gate</source>
        <translation>출발 게이트</translation>
    </message>
    <message>
        <source>onset of motion</source>
        <translation>움직임 시작</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>직접</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>첫째 주행</translation>
    </message>
    <message>
        <source>Second run</source>
        <translation>둘째 주행</translation>
    </message>
    <message>
        <source>How to align the runs</source>
        <translation>같은 때로 보는 순간</translation>
    </message>
    <message>
        <source>Swap the two runs</source>
        <translation>두 주행 맞바꾸기</translation>
    </message>
    <message>
        <source>Add more runs</source>
        <translation>다른 주행</translation>
    </message>
    <message>
        <source>&amp;Shift</source>
        <translation>시간 이동(&amp;S)</translation>
    </message>
    <message>
        <source>Distan&amp;ce</source>
        <translation>위치(&amp;C)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time shift of the second run; positive: later</source>
        <translation>둘째 주행의 그 순간이 얼마나 늦은지</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>first common point</source>
        <translation>모두 출발한 곳</translation>
    </message>
    <message>
        <source>Distance along the path at which the runs are aligned</source>
        <translation>경로의 어디에서 주행들이 같은 시각에 있다고 볼지</translation>
    </message>
    <message>
        <source>F&amp;irst</source>
        <translation>첫째(&amp;I)</translation>
    </message>
    <message>
        <source>Seco&amp;nd</source>
        <translation>둘째(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Align by</source>
        <translation>정렬 기준(&amp;A)</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>자동: %1</translation>
    </message>
    <message>
        <source>No more runs</source>
        <translation>다른 주행이 없습니다</translation>
    </message>
</context>
<context>
    <name>odo::RunResultCard</name>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>&amp;Open in Review</source>
        <translation>검토에서 열기(&amp;O)</translation>
    </message>
    <message>
        <source>The results appear here shortly after the run ends.</source>
        <translation>주행이 끝나고 잠시 뒤에 그 지표가 여기에 나옵니다.</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>측정 중…</translation>
    </message>
    <message>
        <source>Spikes flagged</source>
        <translation>표시된 이상점</translation>
    </message>
    <message>
        <source>From live tracking. The final results follow shortly, from the recording.</source>
        <translation>실시간 추적의 결과입니다. 최종 지표는 잠시 뒤 녹화에서 구합니다.</translation>
    </message>
    <message>
        <source>Final, from every frame of the recording.</source>
        <translation>최종 결과, 녹화의 모든 프레임에서 구함.</translation>
    </message>
</context>
<context>
    <name>odo::RunResults</name>
    <message>
        <source>%1 is analysed.</source>
        <translation>%1 측정을 마쳤습니다.</translation>
    </message>
    <message>
        <source>Recorded, but not analysed: %1</source>
        <translation>녹화했으나 측정하지 못했습니다: %1</translation>
    </message>
    <message>
        <source>%1 is recorded.</source>
        <translation>%1 녹화를 마쳤습니다.</translation>
    </message>
    <message>
        <source>Recording failed: %1</source>
        <translation>녹화하지 못했습니다: %1</translation>
    </message>
</context>
<context>
    <name>odo::SampleModel</name>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>± Speed</source>
        <translation>± 속력</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>가속도</translation>
    </message>
    <message>
        <source>± Acceleration</source>
        <translation>± 가속도</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>진행 방향</translation>
    </message>
    <message>
        <source>± Heading</source>
        <translation>± 진행 방향</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>선회율</translation>
    </message>
    <message>
        <source>± Turn rate</source>
        <translation>± 선회율</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>이동 거리</translation>
    </message>
    <message>
        <source>Measured x</source>
        <translation>측정한 x</translation>
    </message>
    <message>
        <source>Measured y</source>
        <translation>측정한 y</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>뷰</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>표시</translation>
    </message>
</context>
<context>
    <name>odo::SampleTable</name>
    <message>
        <source>Data</source>
        <translation>데이터</translation>
    </message>
    <message>
        <source>Samples of the run</source>
        <translation>주행의 샘플</translation>
    </message>
    <message>
        <source>&amp;Copy with headings</source>
        <translation>머리글과 함께 복사(&amp;C)</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>열</translation>
    </message>
    <message>
        <source>Which columns are shown</source>
        <translation>표시할 열</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>샘플 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>아직 추적 안 함</translation>
    </message>
</context>
<context>
    <name>odo::ScoreboardDialog</name>
    <message>
        <source>&amp;Copy address</source>
        <translation>주소 복사(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Open in browser</source>
        <translation>브라우저에서 열기(&amp;O)</translation>
    </message>
    <message>
        <source>Standings as a web page</source>
        <translation>웹 페이지로 보는 순위</translation>
    </message>
    <message>
        <source>Show the standings on a projector or on phones. The page follows the project as long as this window is open.</source>
        <translation>프로젝터나 휴대전화에 순위를 표시합니다. 이 창이 열려 있는 동안 페이지는 프로젝트를 따라갑니다.</translation>
    </message>
    <message>
        <source>C&amp;lass:</source>
        <translation>학급(&amp;L):</translation>
    </message>
    <message>
        <source>&amp;Task:</source>
        <translation>과제(&amp;T):</translation>
    </message>
    <message>
        <source>&amp;Visible to:</source>
        <translation>볼 수 있는 기기(&amp;V):</translation>
    </message>
    <message>
        <source>Address of the page</source>
        <translation>페이지 주소</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>모든 학급</translation>
    </message>
    <message>
        <source>Task of the newest trial</source>
        <translation>최근 시행의 과제</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>이 컴퓨터만</translation>
    </message>
    <message>
        <source>All devices in the network</source>
        <translation>네트워크의 모든 기기</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>시작 중…</translation>
    </message>
    <message>
        <source>Everyone in the network can open this page. It shows the names of teams, classes and tasks, and no others.</source>
        <translation>네트워크의 누구나 이 페이지를 열 수 있습니다. 팀, 학급, 과제의 이름만 표시됩니다.</translation>
    </message>
    <message>
        <source>Only this computer can open this page.</source>
        <translation>이 컴퓨터에서만 이 페이지를 열 수 있습니다.</translation>
    </message>
</context>
<context>
    <name>odo::ScoringTable</name>
    <message>
        <source>Remo&amp;ve line</source>
        <translation>줄 제거(&amp;V)</translation>
    </message>
    <message>
        <source>Each line gives all its points if the metric reaches the first bound, none at the second bound or worse, and a proportional share between them. Negative points are a penalty.</source>
        <translation>각 줄은 지표가 만점 기준과 같거나 그보다 좋으면 배점을 모두 주고, 0점 기준과 같거나 그보다 나쁘면 주지 않으며, 그 사이에서는 고르게 나누어 줍니다. 배점이 0보다 작으면 감점입니다.</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>All points at</source>
        <translation>만점 기준</translation>
    </message>
    <message>
        <source>None at</source>
        <translation>0점 기준</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>배점</translation>
    </message>
    <message>
        <source>Lines of the scoring</source>
        <translation>채점 줄</translation>
    </message>
    <message>
        <source>What the lines mean</source>
        <translation>각 줄의 뜻</translation>
    </message>
    <message>
        <source>&amp;Add line</source>
        <translation>줄 추가(&amp;A)</translation>
    </message>
    <message>
        <source>Scored metric</source>
        <translation>채점할 지표</translation>
    </message>
    <message>
        <source>Without a line, runs of the task are not scored.</source>
        <translation>줄이 없으면 이 과제의 주행을 채점하지 않습니다.</translation>
    </message>
    <message>
        <source>Total: %1 points.</source>
        <translation>모두 %1점입니다.</translation>
    </message>
</context>
<context>
    <name>odo::SeriesKey</name>
    <message>
        <source>Legend</source>
        <translation>선 범례</translation>
    </message>
    <message>
        <source>%1: click to hide or show</source>
        <translation>%1: 클릭하면 숨기거나 표시합니다</translation>
    </message>
</context>
<context>
    <name>odo::SharedField</name>
    <message>
        <source>several</source>
        <translation>여러 값</translation>
    </message>
    <message>
        <source>%1: several</source>
        <translation>%1: 여러 값</translation>
    </message>
    <message>
        <source>The trials differ here. Press to enter one value for all of them.</source>
        <translation>시행마다 값이 다릅니다. 누르면 모두에 같은 값을 입력합니다.</translation>
    </message>
</context>
<context>
    <name>odo::SharedPointsPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>빼기(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>Image of the camera to register; arrow keys move the selected point</source>
        <translation>정합할 카메라의 사진; 화살표 키로 선택한 점을 옮깁니다</translation>
    </message>
    <message>
        <source>Image of the registered camera; arrow keys move the selected point</source>
        <translation>정합된 카메라의 사진; 화살표 키로 선택한 점을 옮깁니다</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>점</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>보이는 곳</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>바닥 위치, mm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>오차</translation>
    </message>
    <message>
        <source>Floor points</source>
        <translation>바닥의 점</translation>
    </message>
    <message>
        <source>Camera %1, to be registered</source>
        <translation>카메라 %1, 정합할 카메라</translation>
    </message>
    <message>
        <source>Camera %1, registered</source>
        <translation>카메라 %1, 정합됨</translation>
    </message>
    <message>
        <source>P%1</source>
        <comment>a point</comment>
        <translation>P%1</translation>
    </message>
    <message>
        <source>Click a floor point in the left image, then the same point in the right image. A click snaps to what is near it, to a tenth of a pixel; arrow keys move the selected point, Space snaps it.</source>
        <translation>왼쪽 사진에서 바닥의 한 점을 클릭하고, 오른쪽 사진에서 같은 점을 클릭하십시오. 클릭한 곳 근처의 표식에 10분의 1픽셀까지 맞춥니다. 화살표 키로 선택한 점을 옮기고 Space로 표식에 맞춥니다.</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>지평선 너머</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>both images</source>
        <translation>두 사진</translation>
    </message>
    <message>
        <source>left only</source>
        <translation>왼쪽만</translation>
    </message>
    <message>
        <source>right only</source>
        <translation>오른쪽만</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>아직 지정 안 됨</translation>
    </message>
</context>
<context>
    <name>odo::SmoothingPanel</name>
    <message>
        <source>%1: measured for less than a second</source>
        <translation>%1: 1초 미만 측정됨</translation>
    </message>
    <message>
        <source>%1: smoothed automatically like a filter with a cut-off of %2; what it takes away is %3 of each coordinate</source>
        <translation>%1: 차단 주파수 %2의 필터처럼 자동 평활화; 각 좌표에서 %3을(를) 제거</translation>
    </message>
    <message>
        <source>%1: the smoother states no cut-off</source>
        <translation>%1: 평활화에 차단 주파수가 없음</translation>
    </message>
    <message>
        <source>Noise of the measurements by their residuals: %1; stated: %2</source>
        <translation>잔차에 따른 측정 잡음: %1; 표시값: %2</translation>
    </message>
    <message>
        <source>Cut-off by residual analysis: %1</source>
        <translation>잔차 분석에 따른 차단 주파수: %1</translation>
    </message>
    <message>
        <source>Residual analysis gives no cut-off: the residuals are not those of noise.</source>
        <translation>잔차 분석으로 차단 주파수를 얻지 못함: 잔차가 잡음의 것이 아닙니다.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>평활화</translation>
    </message>
    <message>
        <source>residual of a Butterworth filter, by its cut-off</source>
        <translation>버터워스 필터의 차단 주파수별 잔차</translation>
    </message>
    <message>
        <source>Smoothing of the robots</source>
        <translation>로봇별 평활화</translation>
    </message>
    <message>
        <source>No curve yet: track the trial.</source>
        <translation>아직 곡선이 없음: 시행을 추적하세요.</translation>
    </message>
</context>
<context>
    <name>odo::SoundChart</name>
    <message>
        <source>Loudness</source>
        <translation>음량</translation>
    </message>
    <message>
        <source>Loudness of both views</source>
        <translation>두 뷰의 음량</translation>
    </message>
</context>
<context>
    <name>odo::SpikeActions</name>
    <message>
        <source>&amp;Use sample</source>
        <translation>샘플 사용(&amp;U)</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as valid and use it, even if it was flagged</source>
        <translation>이 순간의 측정값은 옳으며, 반하는 근거가 있더라도 사용합니다</translation>
    </message>
    <message>
        <source>Mark as &amp;spike</source>
        <translation>이상점으로 표시(&amp;S)</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as a spike and do not use it</source>
        <translation>이 순간의 측정값은 틀렸으며 사용하지 않습니다</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>자동(&amp;A)</translation>
    </message>
    <message>
        <source>Remove the manual override at this moment</source>
        <translation>이 순간에 직접 판정한 것을 되돌립니다</translation>
    </message>
</context>
<context>
    <name>odo::SpikeList</name>
    <message>
        <source>Spikes</source>
        <translation>이상점</translation>
    </message>
    <message>
        <source>Spikes with time and reason</source>
        <translation>시간과 이유가 있는 이상점 목록</translation>
    </message>
    <message>
        <source>Select all with this &amp;reason</source>
        <translation>이 이유의 항목 모두 선택(&amp;R)</translation>
    </message>
    <message>
        <source>Select all in the selected ra&amp;nge</source>
        <translation>선택한 구간의 항목 모두 선택(&amp;N)</translation>
    </message>
    <message>
        <source>Select all spikes of this robot that have the reason of the selected one</source>
        <translation>선택한 이상점과 같은 이유를 가진 이 로봇의 이상점을 모두 선택합니다</translation>
    </message>
    <message>
        <source>Select all spikes of this robot within the selection on the time line</source>
        <translation>타임라인의 선택 범위 안에 있는 이 로봇의 이상점을 모두 선택합니다</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n개 선택됨</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SpikeModel</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>%1 flagged</source>
        <translation>%1개 표시됨</translation>
    </message>
    <message>
        <source>%1 restored</source>
        <translation>%1개 복원됨</translation>
    </message>
    <message>
        <source>used, by hand</source>
        <translation>사용, 직접 판정</translation>
    </message>
    <message>
        <source>%1 (restored by hand)</source>
        <translation>%1(직접 복원함)</translation>
    </message>
    <message>
        <source>Restored by hand</source>
        <translation>직접 복원함</translation>
    </message>
    <message>
        <source>Flagged, not used for the curve</source>
        <translation>표시됨, 곡선에 쓰지 않음</translation>
    </message>
    <message>
        <source>Flagged, still used for the curve</source>
        <translation>표시됨, 그래도 곡선에 씀</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>%1 ambiguous</source>
        <translation>%1개 불확실</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1개 가려짐</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1개 측정되지 않음</translation>
    </message>
</context>
<context>
    <name>odo::StandingsModel</name>
    <message>
        <source>choose a task</source>
        <translation>과제를 선택하십시오</translation>
    </message>
    <message>
        <source>needs three trials at different times</source>
        <translation>서로 다른 때의 시행 세 개로 알 수 있음</translation>
    </message>
    <message>
        <source>within the spread (%1)</source>
        <translation>산포 이내(%1)</translation>
    </message>
    <message>
        <source>better: %1</source>
        <translation>나아짐: %1</translation>
    </message>
    <message>
        <source>worse: %1</source>
        <translation>나빠짐: %1</translation>
    </message>
    <message>
        <source>one trial</source>
        <translation>시행 하나</translation>
    </message>
    <message>
        <source>One more than the number of significantly better teams (medians differ by more than 1.96 σ). Runs of different tasks are not ranked</source>
        <translation>확실히 더 나은 팀의 수에 1을 더한 값입니다. 중앙값 차이가 1.96 σ를 넘어야 확실한 것으로 봅니다. 서로 다른 과제의 주행은 순위를 매기지 않습니다</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>순위</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>최고</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>중앙값</translation>
    </message>
    <message>
        <source>Repeatability: standard deviation of one trial about the line of progress</source>
        <translation>반복성: 향상 추세선을 중심으로 한 시행 하나의 표준 편차</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>산포</translation>
    </message>
    <message>
        <source>Change over the term by a straight-line fit; Student&apos;s t-test (95 %) decides if it exceeds the spread</source>
        <translation>직선으로 본 학기 중 변화; 산포를 넘는지는 스튜던트 t 검정(95 %)으로 판단</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>향상</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n doubtful</source>
        <translation>
            <numerusform>%1, 의심 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Those with bad results do not count</source>
        <translation>결과가 나쁜 시행는 세지 않습니다</translation>
    </message>
    <message>
        <source>± from the spread of all teams&apos; trials, at least that of the measurement</source>
        <translation>± 모든 팀의 시행의 산포에서 구하며, 최소한 측정의 ±입니다</translation>
    </message>
</context>
<context>
    <name>odo::StartActions</name>
    <message>
        <source>Registered to the floor mat: %1.</source>
        <translation>바닥 매트에 정합됨: %1.</translation>
    </message>
    <message>
        <source>Their newest recordings do not show it: %1.</source>
        <translation>최신 녹화에 매트가 보이지 않음: %1.</translation>
    </message>
</context>
<context>
    <name>odo::StartCard</name>
    <message>
        <source>Recording</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>&amp;Record or stop</source>
        <translation>녹화 또는 정지(&amp;R)</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>녹화한 시간</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>Writing the last frames…</source>
        <translation>마지막 영상을 기록하는 중…</translation>
    </message>
    <message>
        <source>F9 records, F9 stops</source>
        <translation>F9로 녹화, F9로 정지</translation>
    </message>
    <message>
        <source>F9 records, F9 stops; %1</source>
        <translation>F9로 녹화, F9로 정지; %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>%1초 뒤</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>준비하십시오</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>정지</translation>
    </message>
    <message>
        <source>F9 records, with the %1 s before; F9 stops</source>
        <translation>F9로 녹화(이전 %1 s 포함), F9로 정지</translation>
    </message>
    <message>
        <source>F9 records, with the %1 s before; F9 stops; %2</source>
        <translation>F9로 녹화(이전 %1 s 포함), F9로 정지; %2</translation>
    </message>
</context>
<context>
    <name>odo::StartPage</name>
    <message>
        <source>Cameras or clips</source>
        <translation>카메라 또는 동영상</translation>
    </message>
    <message>
        <source>Import clips…</source>
        <translation>동영상 가져오기…</translation>
    </message>
    <message>
        <source>Connect cameras</source>
        <translation>카메라 연결</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>바닥</translation>
    </message>
    <message>
        <source>Find the mat in the clips…</source>
        <translation>동영상에서 매트 찾기…</translation>
    </message>
    <message>
        <source>Print a mat…</source>
        <translation>매트 인쇄…</translation>
    </message>
    <message>
        <source>Use other markers…</source>
        <translation>다른 마커 사용…</translation>
    </message>
    <message>
        <source>Lens (optional)</source>
        <translation>렌즈(선택)</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>보정…</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Add a robot…</source>
        <translation>로봇 추가…</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>첫 주행</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>추적…</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>보고서…</translation>
    </message>
    <message>
        <source>From clips to a first result</source>
        <translation>동영상에서 첫 결과까지</translation>
    </message>
    <message>
        <source>Steps to a first result</source>
        <translation>첫 결과까지의 단계</translation>
    </message>
</context>
<context>
    <name>odo::StatusLine</name>
    <message>
        <source>No trial</source>
        <translation>시행 없음</translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>아직 추적 안 함</translation>
    </message>
    <message>
        <source>Analysis %1, Odograph %2</source>
        <translation>분석 %1, Odograph %2</translation>
    </message>
    <message>
        <source>Units of lengths, speeds and times; change them in the preferences</source>
        <translation>길이, 속력, 시간의 단위; 환경 설정에서 선택합니다</translation>
    </message>
    <message>
        <source>No project is open</source>
        <translation>열린 프로젝트가 없습니다</translation>
    </message>
    <message>
        <source>Read only: nothing can be changed</source>
        <translation>읽기 전용: 아무것도 바꿀 수 없습니다</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>모든 변경이 저장됨</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>저장 중…</translation>
    </message>
    <message>
        <source>The school&apos;s hub</source>
        <translation>학교 허브</translation>
    </message>
    <message>
        <source>%1. Click for more about the school&apos;s hub</source>
        <translation>%1. 학교 허브에 대해 더 보려면 클릭</translation>
    </message>
</context>
<context>
    <name>odo::StepDialog</name>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; 뒤로(&amp;B)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>%1/%2단계</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>다음(&amp;N) &gt;</translation>
    </message>
    <message>
        <source>Discard %1?</source>
        <translation>%1을(를) 버리시겠습니까?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>버리기(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Keep working</source>
        <translation>계속 작업(&amp;K)</translation>
    </message>
</context>
<context>
    <name>odo::StepRow</name>
    <message>
        <source>Done. %1</source>
        <translation>완료. %1</translation>
    </message>
</context>
<context>
    <name>odo::SynchroniseDialog</name>
    <message>
        <source>Synchronise %1</source>
        <translation>%1 동기화</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 현재</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>동기화(&amp;S)</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>동기화</translation>
    </message>
    <message>
        <source>What was tracked in the trial is reanalysed. Choose Undo to return to the synchronisation that it has now.</source>
        <translation>시행에서 추적된 것은 다시 분석됩니다. 실행 취소를 선택하면 현재 동기화로 돌아갑니다.</translation>
    </message>
    <message>
        <source>The sound of the videos is being read…</source>
        <translation>동영상의 소리를 읽는 중…</translation>
    </message>
    <message>
        <source>Sound of the first view above, of the other one below. Drag it until both show the same clap at one time; the wheel zooms.</source>
        <translation>위는 첫 번째 뷰, 아래는 다른 뷰의 소리입니다. 같은 박수 소리가 같은 시각에 보이도록 끌어 옮기십시오. 휠로 확대합니다.</translation>
    </message>
    <message>
        <source>There is no sound in both views to compare.</source>
        <translation>두 뷰 모두에 비교할 소리가 있지는 않습니다.</translation>
    </message>
    <message>
        <source>Frames or sound</source>
        <translation>프레임 또는 소리</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>프레임(&amp;F)</translation>
    </message>
    <message>
        <source>S&amp;ound</source>
        <translation>소리(&amp;O)</translation>
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
        <translation>보드 가로 방향의 안쪽 꼭짓점 수</translation>
    </message>
    <message>
        <source>Inner corners across the board</source>
        <translation>보드 세로 방향의 안쪽 꼭짓점 수</translation>
    </message>
    <message>
        <source>Print targets</source>
        <translation>타깃 인쇄</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>PDF로 저장(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>인쇄(&amp;P)…</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>체커보드</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco 보드</translation>
    </message>
    <message>
        <source>Floor markers: tags</source>
        <translation>바닥 마커: 태그</translation>
    </message>
    <message>
        <source>Floor markers: rings</source>
        <translation>바닥 마커: 고리</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>레터</translation>
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
        <translation>타깃(&amp;T)</translation>
    </message>
    <message>
        <source>Pape&amp;r</source>
        <translation>용지(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Inner corners</source>
        <translation>안쪽 꼭짓점(&amp;I)</translation>
    </message>
    <message>
        <source>S&amp;quare</source>
        <translation>정사각형(&amp;Q)</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>크기(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>이름표(&amp;L)</translation>
    </message>
    <message>
        <source>What is printed</source>
        <translation>인쇄되는 것</translation>
    </message>
    <message>
        <source>One sheet. Afterwards measure a square on the paper: printers often shrink by 2 to 4 %.</source>
        <translation>한 장입니다. 인쇄한 뒤 종이에서 정사각형을 재십시오. 프린터는 흔히 2~4 % 작게 인쇄합니다.</translation>
    </message>
    <message>
        <source>One sheet for each marker. A tag&apos;s number is the position of its label in the layout.</source>
        <translation>마커마다 한 장입니다. 태그의 번호는 배치에서 그 이름표의 순서입니다.</translation>
    </message>
    <message>
        <source>Save targets</source>
        <translation>타깃 저장</translation>
    </message>
    <message>
        <source>targets.pdf</source>
        <translation>타깃.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1에 저장했습니다.</translation>
    </message>
    <message>
        <source>Sent to the printer.</source>
        <translation>프린터로 보냈습니다.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Sheets in a row of the mat</source>
        <translation>매트 한 행의 종이 수</translation>
    </message>
    <message>
        <source>Rows of the mat</source>
        <translation>매트의 행 수</translation>
    </message>
    <message>
        <source>Floor mat</source>
        <translation>바닥 매트</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>종이(&amp;H)</translation>
    </message>
    <message>
        <source>A plan and %1 sheets, to be taped together to a mat of %2 × %3 m. Its markers are known: nothing on the floor needs to be measured. The larger the mat, the more exact the floor.</source>
        <translation>배치도 한 장과 종이 %1장을 붙여 %2 × %3 m 매트를 만듭니다. 마커 위치가 알려져 있어 바닥에서 아무것도 잴 필요가 없습니다. 매트가 클수록 바닥이 더 정확합니다.</translation>
    </message>
</context>
<context>
    <name>odo::TargetPreview</name>
    <message>
        <source>Preview of the sheets</source>
        <translation>인쇄물 미리 보기</translation>
    </message>
</context>
<context>
    <name>odo::TaskCanvas</name>
    <message>
        <source>The task from above</source>
        <translation>위에서 본 과제</translation>
    </message>
    <message>
        <source>Drag a gate or one of its ends, a zone&apos;s edge or corner. Keys: Page Up and Down choose a gate or a zone, arrows move it (Shift: 100 mm, Ctrl: 1 mm), &lt; and &gt; turn it, + and − change its width</source>
        <translation>게이트나 그 끝, 구역의 변이나 꼭짓점을 끄십시오. 키보드: Page Up과 Page Down으로 게이트나 구역을 고르고, 화살표로 옮기고(Shift: 100 mm, Ctrl: 1 mm), &lt;와 &gt;로 돌리고, +와 −로 폭을 바꿉니다</translation>
    </message>
    <message>
        <source>Zone %1, %2: %3 mm</source>
        <translation>구역 %1, %2: %3 mm</translation>
    </message>
    <message>
        <source>No gate or zone is chosen</source>
        <translation>게이트나 구역을 선택하지 않았습니다</translation>
    </message>
    <message>
        <source>Gate %1 from %2, %3 to %4, %5</source>
        <translation>게이트 %1: %2, %3에서 %4, %5까지</translation>
    </message>
</context>
<context>
    <name>odo::TaskEditor</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
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
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>&amp;Course</source>
        <translation>코스(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>구역(&amp;Z)</translation>
    </message>
    <message>
        <source>Sco&amp;ring</source>
        <translation>채점(&amp;R)</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>문제점</translation>
    </message>
    <message>
        <source>Import &amp;file…</source>
        <translation>파일 가져오기(&amp;F)…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Import gates, path, limits and zones from a task file (JSON)</source>
        <translation>과제 파일(JSON)에서 게이트, 경로, 한계, 구역을 가져옵니다</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>이름(&amp;N)</translation>
    </message>
    <message>
        <source>Speed limi&amp;t</source>
        <translation>속력 한계(&amp;T)</translation>
    </message>
    <message>
        <source>Acceleration l&amp;imit</source>
        <translation>가속도 한계(&amp;I)</translation>
    </message>
    <message>
        <source>No robot in the task can exceed it: a measurement beyond it is a spike</source>
        <translation>이 과제의 어떤 로봇도 넘을 수 없는 값: 이를 넘는 측정값은 이상점입니다</translation>
    </message>
    <message>
        <source>Task file</source>
        <translation>과제 파일</translation>
    </message>
    <message>
        <source>Tasks (*.json *.yaml *.yml);;All files (*)</source>
        <translation>과제 (*.json *.yaml *.yml);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>The task has no name.</source>
        <translation>과제의 이름이 없습니다.</translation>
    </message>
    <message>
        <source>A task with this name exists. Enter another name.</source>
        <translation>같은 이름의 과제가 있습니다. 다른 이름을 지정하십시오.</translation>
    </message>
    <message>
        <source>A gate has no name.</source>
        <translation>이름이 없는 게이트가 있습니다.</translation>
    </message>
    <message>
        <source>A zone has no name.</source>
        <translation>이름이 없는 구역이 있습니다.</translation>
    </message>
</context>
<context>
    <name>odo::TasksDialog</name>
    <message>
        <source>&amp;New</source>
        <translation>새로 만들기(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>편집(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Copy…</source>
        <translation>복사(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>이름 변경(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>보관(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>삭제(&amp;D)</translation>
    </message>
    <message>
        <source>Reanalyse &amp;them</source>
        <translation>다시 측정(&amp;M)</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>What depends on the task</source>
        <translation>과제에 딸린 것</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>작업 결과</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>템플릿</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>쓰는 곳</translation>
    </message>
    <message>
        <source>Archived tasks no longer appear in lists; their trials, results and scores stay as they are</source>
        <translation>보관된 과제는 더 이상 고를 수 없습니다. 그 시행, 결과, 점수는 그대로 남습니다</translation>
    </message>
    <message numerus="yes">
        <source>Show %n archived task(s)</source>
        <translation>
            <numerusform>보관된 과제 %n개 표시</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>시행 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>earlier results</source>
        <translation>이전 결과</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>%1, archived</source>
        <translation>%1, 보관됨</translation>
    </message>
    <message>
        <source>No task yet. New creates one from a template. Its gates, path and scoring define the course and rate the runs.</source>
        <translation>아직 과제가 없습니다. 새로 만들기는 템플릿으로 과제를 만듭니다. 과제의 게이트, 경로, 채점은 무엇을 주행해야 하고 얼마나 잘했는지를 정합니다.</translation>
    </message>
    <message numerus="yes">
        <source>Earlier version of the course: %n result(s) still use it.</source>
        <translation>
            <numerusform>변경하기 전의 코스입니다. 이 코스로 측정한 결과 %n개가 이것을 유지합니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have this task.</source>
        <translation>
            <numerusform>이 과제의 시행이 %n개 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>No trial has this task.</source>
        <translation>이 과제의 시행이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</source>
        <translation>
            <numerusform>그중 %n개는 다른 코스로 측정했습니다. 게이트 통과 시각과 경로에서 떨어진 거리는 그 코스의 것이며, 다시 측정할 때까지 점수가 없습니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n metric(s).</source>
        <translation>
            <numerusform>지표 %n개로 채점합니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not scored.</source>
        <translation>채점하지 않습니다.</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>보관 해제(&amp;A)</translation>
    </message>
    <message>
        <source>Trials have this task or were measured with it: it stays to document their metrics</source>
        <translation>이 과제의 시행이 있거나 이 과제로 측정한 시행이 있습니다. 지표를 무엇으로 측정했는지 알 수 있도록 과제를 남겨 둡니다</translation>
    </message>
    <message>
        <source>Deletes the task (Del); Ctrl+Z undoes this</source>
        <translation>과제를 삭제합니다(Del). Ctrl+Z로 되돌릴 수 있습니다</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</source>
        <translation>
            <numerusform>이 코스로 측정한 결과 %n개는 계속 유효합니다. 코스를 변경하면 그 결과를 위해 이전 버전을 남겨 둡니다. 시행은 새 코스로 넘어가며, 시간과 점수는 다시 측정하면 반영됩니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename task</source>
        <translation>과제 이름 변경</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>이름:</translation>
    </message>
</context>
<context>
    <name>odo::TeamDialog</name>
    <message>
        <source>Robots of the team</source>
        <translation>팀의 로봇</translation>
    </message>
    <message>
        <source>Team %1</source>
        <translation>팀 %1</translation>
    </message>
    <message>
        <source>One name per line</source>
        <translation>한 줄에 이름 하나씩</translation>
    </message>
    <message>
        <source>Members of the team, one per line</source>
        <translation>팀원, 한 줄에 한 명씩</translation>
    </message>
    <message>
        <source>Record and Import propose these robots for the team&apos;s runs</source>
        <translation>녹화와 가져오기에서 이 팀의 주행에 이 로봇들을 제안합니다</translation>
    </message>
    <message>
        <source>&amp;Members</source>
        <translation>팀원(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>로봇(&amp;R)</translation>
    </message>
    <message numerus="yes">
        <source>%n member(s)</source>
        <translation>
            <numerusform>팀원 %n명</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message>
        <source>Teams</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>모든 학급</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>모든 과제</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>지표</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>팀 순위표</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1(보관됨)</translation>
    </message>
    <message>
        <source>No team has a result for this metric</source>
        <translation>여기에 지표가 있는 팀이 없습니다</translation>
    </message>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation>
            <numerusform>%n팀</numerusform>
        </translation>
    </message>
    <message>
        <source>choose a task to rank them: runs of different tasks cannot be compared</source>
        <translation>과제를 선택하면 순위를 매깁니다. 서로 다른 과제의 주행은 비교할 수 없습니다</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them</source>
        <translation>
            <numerusform>시행 %n개 제외: 다른 코스로 측정됨. 다시 측정하십시오</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results</source>
        <translation>
            <numerusform>시행 %n개 제외: 나쁜 결과</numerusform>
        </translation>
    </message>
    <message>
        <source>teams that do not differ significantly share a rank</source>
        <translation>유의한 차이가 없는 팀은 같은 순위입니다</translation>
    </message>
</context>
<context>
    <name>odo::TemplateForm</name>
    <message>
        <source>Straight line</source>
        <translation>직선</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>원</translation>
    </message>
    <message>
        <source>Figure eight</source>
        <translation>8자</translation>
    </message>
    <message>
        <source>Slalom</source>
        <translation>슬랄롬</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>자유</translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation>템플릿(&amp;M)</translation>
    </message>
    <message>
        <source>Centre &amp;x</source>
        <translation>중심 x(&amp;X)</translation>
    </message>
    <message>
        <source>Centre &amp;y</source>
        <translation>중심 y(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>길이(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>폭(&amp;W)</translation>
    </message>
    <message>
        <source>Driving direction: 0° along X, 90° along Y</source>
        <translation>주행 방향: 0°는 X축 방향, 90°는 Y축 방향</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>방향(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Poles</source>
        <translation>기둥(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Gates&apos; width</source>
        <translation>게이트 폭(&amp;G)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diam&amp;eter</source>
        <translation>지름(&amp;E)</translation>
    </message>
    <message>
        <source>Start to finis&amp;h</source>
        <translation>출발~도착 거리(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>높이(&amp;H)</translation>
    </message>
    <message>
        <source>S&amp;wing, side to side</source>
        <translation>좌우 흔들림 폭(&amp;W)</translation>
    </message>
</context>
<context>
    <name>odo::TestbedPage</name>
    <message>
        <source>From above</source>
        <translation>위에서 본 모습</translation>
    </message>
    <message>
        <source>expected &amp;accuracy</source>
        <translation>예상 정확도(&amp;A)</translation>
    </message>
    <message>
        <source>No cameras yet</source>
        <translation>아직 카메라가 없습니다</translation>
    </message>
    <message>
        <source>A testbed is a floor with markers and the cameras that watch it. Start with the lens calibration of the first camera, or with the marker positions.</source>
        <translation>테스트베드는 마커가 있는 바닥과 그 바닥을 보는 카메라들입니다. 첫 카메라의 렌즈나 마커의 위치부터 시작하십시오.</translation>
    </message>
    <message>
        <source>Tas&amp;ks…</source>
        <translation>과제(&amp;K)…</translation>
    </message>
    <message>
        <source>Courses on this floor: gates, paths, limits, scoring</source>
        <translation>이 바닥에서 주행할 것: 게이트, 경로, 한계, 채점</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Details of the camera</source>
        <translation>카메라 정보</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Marker layouts</source>
        <translation>마커 배치</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>카메라 %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>영상</translation>
    </message>
</context>
<context>
    <name>odo::TestbedTools</name>
    <message>
        <source>&amp;Calibrate camera…</source>
        <translation>카메라 보정(&amp;C)…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>보정…</translation>
    </message>
    <message>
        <source>Calibrate a camera with images of a board</source>
        <translation>보드 사진으로 카메라의 렌즈를 측정합니다</translation>
    </message>
    <message>
        <source>&amp;Register camera…</source>
        <translation>카메라 정합(&amp;R)…</translation>
    </message>
    <message>
        <source>Register…</source>
        <translation>정합…</translation>
    </message>
    <message>
        <source>Determine a camera&apos;s position from the floor markers</source>
        <translation>바닥 마커로 카메라가 있는 곳을 구합니다</translation>
    </message>
    <message>
        <source>Register via anot&amp;her camera…</source>
        <translation>다른 카메라를 통해 정합(&amp;H)…</translation>
    </message>
    <message>
        <source>Via another…</source>
        <translation>통해 정합…</translation>
    </message>
    <message>
        <source>Determine the position of a camera that sees no markers, from floor points that another camera also sees</source>
        <translation>마커가 보이지 않는 카메라가 있는 곳을, 다른 카메라에도 보이는 바닥의 점들로 구합니다</translation>
    </message>
    <message>
        <source>Re&amp;gister all cameras (joint)…</source>
        <translation>모든 카메라 함께 정합(&amp;G)…</translation>
    </message>
    <message>
        <source>All cameras (joint)…</source>
        <translation>함께 정합…</translation>
    </message>
    <message>
        <source>Fit all cameras of the selected layout jointly to make them agree, and find wrongly measured markers</source>
        <translation>선택한 배치의 카메라들을 한꺼번에 맞추어 서로 일치하게 하고, 잘못 잰 마커를 찾습니다</translation>
    </message>
    <message>
        <source>&amp;Import lens calibration…</source>
        <translation>내부 파라미터 가져오기(&amp;I)…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>렌즈 가져오기…</translation>
    </message>
    <message>
        <source>Import a camera&apos;s lens calibration from a ROS or OpenCV YAML file</source>
        <translation>ROS나 OpenCV의 YAML 파일에서 카메라의 렌즈를 가져옵니다</translation>
    </message>
    <message>
        <source>New marker &amp;layout…</source>
        <translation>새 마커 배치(&amp;L)…</translation>
    </message>
    <message>
        <source>New layout…</source>
        <translation>새 배치…</translation>
    </message>
    <message>
        <source>Enter the marker positions, from scratch or based on the selected layout</source>
        <translation>마커의 위치를 처음부터, 또는 선택한 배치를 바탕으로 입력합니다</translation>
    </message>
    <message>
        <source>Import &amp;marker layout…</source>
        <translation>마커 배치 가져오기(&amp;M)…</translation>
    </message>
    <message>
        <source>Import layout…</source>
        <translation>배치 가져오기…</translation>
    </message>
    <message>
        <source>Import the marker positions from a table</source>
        <translation>표에서 마커의 위치를 가져옵니다</translation>
    </message>
    <message>
        <source>Print &amp;targets…</source>
        <translation>타깃 인쇄(&amp;T)…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>인쇄…</translation>
    </message>
    <message>
        <source>Calibration boards and floor markers, to scale</source>
        <translation>렌즈용 보드와 바닥용 마커를 실제 크기로 인쇄합니다</translation>
    </message>
    <message>
        <source>Camera %1 is calibrated. %2</source>
        <translation>카메라 %1을(를) 보정했습니다. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered. %2</source>
        <translation>카메라 %1을(를) 정합했습니다. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered via camera %2. %3</source>
        <translation>카메라 %2을(를) 통해 카메라 %1을(를) 정합했습니다. %3</translation>
    </message>
    <message>
        <source>The cameras of layout %1 are registered jointly. %2</source>
        <translation>배치 %1의 카메라들을 함께 정합했습니다. %2</translation>
    </message>
    <message>
        <source>Lens calibration of a camera</source>
        <translation>카메라의 내부 파라미터</translation>
    </message>
    <message>
        <source>Import lens calibration</source>
        <translation>내부 파라미터 가져오기</translation>
    </message>
    <message>
        <source>Camera:</source>
        <translation>카메라:</translation>
    </message>
    <message>
        <source>Lens calibration of camera %1 imported from %2.</source>
        <translation>카메라 %1의 렌즈를 %2에서 가져왔습니다.</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>마커 위치 (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>표 (*.csv *.txt);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Layout %1 has %2 markers.</source>
        <translation>배치 %1에 마커가 %2개 있습니다.</translation>
    </message>
    <message>
        <source>The file holds several cameras. Which one is %1?</source>
        <translation>파일에 카메라가 여러 대 들어 있습니다. %1은(는) 어느 것입니까?</translation>
    </message>
    <message>
        <source>Calibrations (*.yaml *.yml *.json *.toml *.ini *.xml *.txt);;All files (*)</source>
        <translation>보정 파일 (*.yaml *.yml *.json *.toml *.ini *.xml *.txt);;모든 파일 (*)</translation>
    </message>
</context>
<context>
    <name>odo::TimeSlider</name>
    <message>
        <source>Time of the trial</source>
        <translation>시행의 시간</translation>
    </message>
</context>
<context>
    <name>odo::Timeline</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>재생 또는 일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>한 프레임 뒤로(&amp;B)</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>한 프레임 앞으로(&amp;F)</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>1초 뒤로</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>1초 앞으로</translation>
    </message>
    <message>
        <source>Play backwards, again: faster</source>
        <translation>거꾸로 재생, 다시 누르면 더 빠르게</translation>
    </message>
    <message>
        <source>&amp;Stop; while held, the keys beside it step one frame</source>
        <translation>정지(&amp;S); 누른 채 양옆 키를 누르면 한 프레임씩</translation>
    </message>
    <message>
        <source>Play forwards, again: faster</source>
        <translation>앞으로 재생, 다시 누르면 더 빠르게</translation>
    </message>
    <message>
        <source>To the first frame</source>
        <translation>첫 프레임으로</translation>
    </message>
    <message>
        <source>To the last frame</source>
        <translation>마지막 프레임으로</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>반복(&amp;L)</translation>
    </message>
    <message>
        <source>Selection beg&amp;ins here</source>
        <translation>여기서 선택 시작(&amp;I)</translation>
    </message>
    <message>
        <source>Selection &amp;ends here</source>
        <translation>여기서 선택 끝(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Clear the selection</source>
        <translation>선택 지우기(&amp;C)</translation>
    </message>
</context>
<context>
    <name>odo::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>타임라인</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>재생 속도</translation>
    </message>
    <message>
        <source>To the first frame (Home)</source>
        <translation>첫 프레임으로(Home)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>재생(Space)</translation>
    </message>
    <message>
        <source>To the last frame (End)</source>
        <translation>마지막 프레임으로(End)</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>프레임 없음</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>프레임 %1/%2</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>일시 정지(Space)</translation>
    </message>
</context>
<context>
    <name>odo::TrackDialog</name>
    <message>
        <source>Robots to track</source>
        <translation>따라갈 로봇</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>%1 추적</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data (best)</source>
        <translation>칼만/RTS, 잡음은 데이터에서 추정(최선)</translation>
    </message>
    <message>
        <source>Savitzky–Golay</source>
        <translation>Savitzky–Golay</translation>
    </message>
    <message>
        <source>Differences as in Tracker</source>
        <translation>Tracker와 같은 차분</translation>
    </message>
    <message>
        <source>None: raw differences</source>
        <translation>없음: 원시 차분</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>로봇(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>평활화(&amp;S)</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>추적</translation>
    </message>
</context>
<context>
    <name>odo::TrackPreview</name>
    <message>
        <source>%1: too long to be shown before the import</source>
        <translation>%1: 너무 길어 가져오기 전에 표시할 수 없습니다</translation>
    </message>
    <message>
        <source>%1, track %2</source>
        <translation>%1, 궤적 %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2, %n lines in %3 s</source>
        <translation>
            <numerusform>%1: %2, %3초에 %n행</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrackReadingForm</name>
    <message>
        <source>&amp;Unit of positions</source>
        <translation>위치의 단위(&amp;U)</translation>
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
        <translation>픽셀</translation>
    </message>
    <message>
        <source>Unit of t&amp;imes</source>
        <translation>시각의 단위(&amp;I)</translation>
    </message>
    <message>
        <source>s</source>
        <translation>초</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>ns</translation>
    </message>
    <message>
        <source>frame numbers</source>
        <translation>프레임 번호</translation>
    </message>
    <message>
        <source>F&amp;loor axes</source>
        <translation>바닥 축(&amp;L)</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x와 y</translation>
    </message>
    <message>
        <source>x and z</source>
        <translation>x와 z</translation>
    </message>
    <message>
        <source>y and z</source>
        <translation>y와 z</translation>
    </message>
    <message>
        <source>&amp;Decimal sign</source>
        <translation>소수점 기호(&amp;D)</translation>
    </message>
    <message>
        <source>point</source>
        <translation>점</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>쉼표</translation>
    </message>
    <message>
        <source>&amp;Frame rate</source>
        <translation>프레임 속도(&amp;F)</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> 프레임/초</translation>
    </message>
    <message>
        <source>Of a file that numbers its frames</source>
        <translation>프레임에 번호를 매기는 파일의 경우</translation>
    </message>
    <message>
        <source>Length of a &amp;pixel</source>
        <translation>픽셀의 길이(&amp;P)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>On the floor, for positions in pixels</source>
        <translation>픽셀 단위 위치의 바닥에서의 길이</translation>
    </message>
    <message>
        <source>Least &amp;confidence</source>
        <translation>최소 신뢰도(&amp;C)</translation>
    </message>
    <message>
        <source>Positions with a lower likelihood count as not measured</source>
        <translation>가능도가 더 낮은 위치는 측정되지 않은 것으로 처리합니다</translation>
    </message>
    <message>
        <source>Accurac&amp;y</source>
        <translation>정확도(&amp;Y)</translation>
    </message>
    <message>
        <source>Standard deviation of the positions, slow errors included; scatter alone does not show those</source>
        <translation>느린 오차를 포함한 위치의 표준 편차. 산포만으로는 드러나지 않습니다</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>파일에서</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>인치</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>피트</translation>
    </message>
    <message>
        <source>min</source>
        <translation>분</translation>
    </message>
    <message>
        <source>h</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>days</source>
        <translation>일</translation>
    </message>
</context>
<context>
    <name>odo::TransferActions</name>
    <message>
        <source>&amp;Pack into one file…</source>
        <translation>한 파일로 묶기(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Unpack a packed project…</source>
        <translation>묶은 프로젝트 풀기(&amp;U)…</translation>
    </message>
    <message>
        <source>Find &amp;lost videos…</source>
        <translation>잃은 동영상 찾기(&amp;L)…</translation>
    </message>
    <message>
        <source>Pack the project with its videos</source>
        <translation>프로젝트를 동영상과 함께 묶기</translation>
    </message>
    <message>
        <source>Packed projects (*%1)</source>
        <translation>묶은 프로젝트 (*%1)</translation>
    </message>
    <message>
        <source>Project packed into %1. To use it on another computer, choose &quot;Unpack a packed project&quot; there.</source>
        <translation>프로젝트를 %1에 묶었습니다. 다른 곳에서는 &quot;묶은 프로젝트 풀기&quot;로 풉니다.</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>참고: %1.</translation>
    </message>
    <message>
        <source>Unpack a packed project</source>
        <translation>묶은 프로젝트 풀기</translation>
    </message>
    <message>
        <source>Packed projects (*%1);;All files (*)</source>
        <translation>묶은 프로젝트 (*%1);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the unpacked project</source>
        <translation>프로젝트를 어디에 풀까요?</translation>
    </message>
    <message>
        <source>Choose the folder to search for the lost videos (with subfolders)</source>
        <translation>잃은 동영상이 어느 폴더나 그 아래에 있습니까?</translation>
    </message>
    <message>
        <source>Found %1 of %2 lost videos by their content.</source>
        <translation>잃은 동영상 %2개 중 %1개를 내용으로 찾았습니다.</translation>
    </message>
    <message>
        <source>Find &amp;stray files…</source>
        <translation>소속 없는 파일 찾기(&amp;S)…</translation>
    </message>
    <message>
        <source>Every file in the media folder belongs to a trial, a lens calibration or a floor registration.</source>
        <translation>미디어 폴더의 모든 파일은 시행, 렌즈 보정 또는 바닥 정합에 속합니다.</translation>
    </message>
    <message>
        <source>Stray files</source>
        <translation>소속 없는 파일</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) in the media folder belong to no trial, lens calibration or floor registration.</source>
        <translation>
            <numerusform>미디어 폴더의 파일 %n개가 어떤 시행, 렌즈 보정, 바닥 정합에도 속하지 않습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>You can add videos as trials. Removed files are gone for good.</source>
        <translation>동영상은 별도의 시행이 될 수 있습니다. 제거한 파일은 되돌릴 수 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Add videos as trials</source>
        <translation>동영상을 시행으로 추가(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove files</source>
        <translation>파일 제거(&amp;R)</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) added. Their names begin with &quot;recovered&quot;.</source>
        <translation>
            <numerusform>시행 %n개를 추가했습니다. 이름은 &quot;recovered&quot;로 시작합니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stray file(s) removed.</source>
        <translation>
            <numerusform>소속 없는 파일 %n개를 제거했습니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other file(s), listed last, stay: missing recordings, projects, and files that are neither videos nor images.</source>
        <translation>
            <numerusform>목록 끝에 있는 다른 파일 %n개는 그대로 둡니다: 없어진 녹화, 프로젝트, 그리고 동영상도 그림도 아닌 것.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrendChart</name>
    <message>
        <source>Progress of the team</source>
        <translation>팀의 향상</translation>
    </message>
    <message>
        <source>%1: %2 trials, progress: %3</source>
        <translation>%1: 시행 %2개, 향상: %3</translation>
    </message>
    <message>
        <source>No team is selected</source>
        <translation>선택한 팀이 없습니다</translation>
    </message>
    <message>
        <source>Select a team to see its results over the term.</source>
        <translation>팀을 선택하면 학기 중 시행이 나옵니다.</translation>
    </message>
</context>
<context>
    <name>odo::TrialActions</name>
    <message>
        <source>%1 in %2 of %3 frames, spikes flagged: %4</source>
        <translation>%1: %3프레임 중 %2프레임, 표시된 이상점: %4</translation>
    </message>
    <message>
        <source>%1 is tracked: %2.</source>
        <translation>%1 추적을 마쳤습니다: %2.</translation>
    </message>
    <message>
        <source>%1 is imported.</source>
        <translation>%1을(를) 가져왔습니다.</translation>
    </message>
    <message>
        <source>&amp;Import trial from videos…</source>
        <translation>동영상에서 시행 가져오기(&amp;I)…</translation>
    </message>
    <message>
        <source>Import finished tra&amp;cks…</source>
        <translation>완성된 궤적 가져오기(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Track…</source>
        <translation>추적(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>내보내기(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;video…</source>
        <translation>동영상 내보내기(&amp;V)…</translation>
    </message>
    <message>
        <source>Add &amp;robot…</source>
        <translation>로봇 추가(&amp;R)…</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is not used. Choose Undo to use it.</source>
        <translation>%2의 %1 샘플을 사용하지 않습니다. 실행 취소로 되돌릴 수 있습니다.</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is used. Choose Undo to reverse this.</source>
        <translation>%2의 %1 샘플을 사용합니다. 실행 취소로 되돌릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Video of %1</source>
        <translation>%1의 동영상</translation>
    </message>
    <message>
        <source>MP4 videos (*.mp4)</source>
        <translation>MP4 동영상 (*.mp4)</translation>
    </message>
    <message>
        <source>Video of %1 saved as %2</source>
        <translation>%1의 동영상을 만들었습니다: %2</translation>
    </message>
    <message>
        <source>Robot %1 added.</source>
        <translation>로봇 %1을(를) 추가했습니다.</translation>
    </message>
    <message>
        <source>%1 is synchronised.</source>
        <translation>%1이(가) 동기화되었습니다.</translation>
    </message>
    <message>
        <source>S&amp;ynchronise…</source>
        <translation>동기화(&amp;Y)…</translation>
    </message>
    <message>
        <source>The results of %1 are of its range, %2 to %3. Choose Undo to reverse this.</source>
        <translation>%1의 결과는 구간 %2~%3에 대한 것입니다. 되돌리려면 실행 취소를 선택하십시오.</translation>
    </message>
    <message>
        <source>The results of %1 are of the whole run.</source>
        <translation>%1의 결과는 전체 주행에 대한 것입니다.</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>편집(&amp;D)…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) changed. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>시행 %n개를 바꾸었습니다. 실행 취소를 선택하면 되돌립니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are not used. Choose Undo to use them.</source>
        <translation>
            <numerusform>%1의 샘플 %n개를 사용하지 않습니다. 다시 사용하려면 실행 취소를 선택하세요.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are used. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%1의 샘플 %n개를 사용합니다. 되돌리려면 실행 취소를 선택하세요.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrialChooser</name>
    <message>
        <source>&amp;Previous trial</source>
        <translation>이전 시행(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next trial</source>
        <translation>다음 시행(&amp;N)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
</context>
<context>
    <name>odo::TrialColumns</name>
    <message>
        <source>&amp;Columns</source>
        <translation>열(&amp;C)</translation>
    </message>
</context>
<context>
    <name>odo::TrialDetail</name>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>뷰</translation>
    </message>
    <message>
        <source>none: the track was imported</source>
        <translation>없음: 궤적을 가져옴</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>점수</translation>
    </message>
    <message>
        <source>none: analysed with a different course than its task has now. Reanalyse the trial</source>
        <translation>없음: 과제의 현재 코스와 다른 코스로 측정함. 다시 측정하십시오</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>none yet: open it and choose Track</source>
        <translation>아직 없음: 시행을 열고 추적을 선택하십시오</translation>
    </message>
    <message>
        <source>Open in Review</source>
        <translation>검토에서 열기</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>시행 정보</translation>
    </message>
    <message>
        <source>Notes of the trial</source>
        <translation>시행 메모</translation>
    </message>
    <message>
        <source>What did you change on the robot? What do you want to remember?</source>
        <translation>로봇에서 무엇을 바꾸었습니까? 기억해 둘 것은 무엇입니까?</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>메모(&amp;N)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>아직 시행이 없습니다</translation>
    </message>
    <message>
        <source>No trial selected</source>
        <translation>선택한 시행이 없습니다</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
</context>
<context>
    <name>odo::TrialFilterBar</name>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>모든 학급</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Any team</source>
        <translation>모든 팀</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>모든 과제</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Any robot</source>
        <translation>모든 로봇</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Any date</source>
        <translation>모든 날짜</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>오늘</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>최근 7일</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>최근 30일</translation>
    </message>
    <message>
        <source>Last 12 months</source>
        <translation>최근 12개월</translation>
    </message>
    <message>
        <source>Between…</source>
        <translation>기간 지정…</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>보관함</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>휴지통</translation>
    </message>
    <message>
        <source>From</source>
        <translation>시작일</translation>
    </message>
    <message>
        <source>To</source>
        <translation>종료일</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>별표</translation>
    </message>
    <message>
        <source>Only starred trials</source>
        <translation>별표 시행만</translation>
    </message>
    <message>
        <source>Show only starred trials</source>
        <translation>별표를 붙인 시행만 표시합니다</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>의심스러움</translation>
    </message>
    <message>
        <source>Only trials with doubtful or bad results</source>
        <translation>결과가 의심스럽거나 나쁜 시행만</translation>
    </message>
    <message>
        <source>Show only trials with doubtful or bad results</source>
        <translation>결과가 의심스럽거나 나쁜 시행만 표시</translation>
    </message>
</context>
<context>
    <name>odo::TrialModel</name>
    <message>
        <source>not tracked</source>
        <translation>추적 안 함</translation>
    </message>
    <message>
        <source>reanalyse</source>
        <translation>다시 측정</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>별표 있음</translation>
    </message>
    <message>
        <source>not starred</source>
        <translation>별표 없음</translation>
    </message>
    <message>
        <source>Tags, separated by commas: double-click or F2 changes them</source>
        <translation>쉼표로 구분한 태그: 두 번 클릭하거나 F2를 누르면 바꿀 수 있습니다</translation>
    </message>
    <message>
        <source>Star (Ctrl+D)</source>
        <translation>별표(Ctrl+D)</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>별표</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>팀</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학급</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>과제</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>최고 속력</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>점수</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>태그</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>메모</translation>
    </message>
</context>
<context>
    <name>odo::TrialPresentation</name>
    <message>
        <source>Not tracked yet</source>
        <translation>아직 추적 안 함</translation>
    </message>
</context>
<context>
    <name>odo::TrialTable</name>
    <message>
        <source>Trials</source>
        <translation>시행</translation>
    </message>
</context>
<context>
    <name>odo::TriggerBox</name>
    <message>
        <source>at once</source>
        <translation>바로</translation>
    </message>
    <message>
        <source>after a countdown of %1 s</source>
        <translation>카운트다운 %1초 뒤</translation>
    </message>
    <message>
        <source>when the robot passes the start</source>
        <translation>로봇이 출발을 지날 때</translation>
    </message>
    <message>
        <source>when something moves</source>
        <translation>무언가 움직이면</translation>
    </message>
    <message>
        <source>with the button</source>
        <translation>버튼으로</translation>
    </message>
    <message>
        <source>at the finish</source>
        <translation>결승점에서</translation>
    </message>
    <message>
        <source>when nothing moves any more</source>
        <translation>아무것도 움직이지 않으면</translation>
    </message>
    <message>
        <source>after a time</source>
        <translation>일정 시간 후</translation>
    </message>
    <message>
        <source>when a robot enters “%1”</source>
        <translation>로봇이 “%1”에 들어가면</translation>
    </message>
    <message>
        <source>when a robot leaves “%1”</source>
        <translation>로봇이 “%1”에서 나가면</translation>
    </message>
    <message>
        <source>Waiting for the robot at “%1”. The recording will include the %2 s before it</source>
        <translation>“%1”에서 로봇을 기다리는 중입니다. 그 %2 s 전부터 녹화합니다</translation>
    </message>
    <message>
        <source>Waiting until a robot enters “%1”. The recording will include the %2 s before</source>
        <translation>로봇이 “%1”에 들어가기를 기다리는 중입니다. 그 %2 s 전부터 녹화합니다</translation>
    </message>
    <message>
        <source>Waiting until a robot leaves “%1”. The recording will include the %2 s before</source>
        <translation>로봇이 “%1”에서 나가기를 기다리는 중입니다. 그 %2 s 전부터 녹화합니다</translation>
    </message>
    <message>
        <source>Waiting until something moves on the floor. The recording will include the %1 s before</source>
        <translation>바닥에서 무언가 움직이기를 기다리는 중입니다. 그 %1 s 전부터 녹화합니다</translation>
    </message>
    <message>
        <source>Ends at the finish, or with F9</source>
        <translation>결승점에서 또는 F9로 끝납니다</translation>
    </message>
    <message>
        <source>Ends when a robot enters “%1”, or with F9</source>
        <translation>로봇이 “%1”에 들어가거나 F9를 누르면 끝납니다</translation>
    </message>
    <message>
        <source>Ends when a robot leaves “%1”, or with F9</source>
        <translation>로봇이 “%1”에서 나가거나 F9를 누르면 끝납니다</translation>
    </message>
    <message>
        <source>Ends when nothing has moved for %1 s, or with F9</source>
        <translation>%1 s 동안 움직임이 없거나 F9를 누르면 끝납니다</translation>
    </message>
    <message>
        <source>Ends %1 s after the start, or with F9</source>
        <translation>시작 %1 s 후 또는 F9로 끝납니다</translation>
    </message>
</context>
<context>
    <name>odo::UndoActions</name>
    <message>
        <source>Undone: %1.</source>
        <translation>실행 취소함: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>다시 실행함: %1.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>다시 실행(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>실행 취소(&amp;U): %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>다시 실행(&amp;R): %1</translation>
    </message>
</context>
<context>
    <name>odo::VariableTable</name>
    <message>
        <source>several</source>
        <translation>여러 값</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Variables of your own</source>
        <translation>직접 정한 변수</translation>
    </message>
    <message>
        <source>What you want to compare runs by: surface, battery, attempt. Text or a number.</source>
        <translation>주행을 비교할 기준: 바닥, 배터리, 시도. 글자나 숫자.</translation>
    </message>
</context>
<context>
    <name>odo::VideoDialog</name>
    <message>
        <source>Real time</source>
        <translation>주행한 그대로</translation>
    </message>
    <message>
        <source>Slow motion, 1/2</source>
        <translation>슬로 모션, 1/2</translation>
    </message>
    <message>
        <source>Slow motion, 1/4</source>
        <translation>슬로 모션, 1/4</translation>
    </message>
    <message>
        <source>Slow motion, 1/10</source>
        <translation>슬로 모션, 1/10</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>One video with all camera views, the map and the speed, to show or send. It plays without Odograph.</source>
        <translation>모든 카메라의 영상과 지도, 속력을 담은 동영상 하나를 만들어 보여 주거나 보낼 수 있습니다. 받는 사람에게는 Odograph가 필요 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>재생 속도(&amp;S)</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>크기(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>테마(&amp;T)</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>위치 선택…</translation>
    </message>
</context>
<context>
    <name>odo::ViewActions</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>창 배열 초기화(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>전체 화면(&amp;F)</translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation>데스크톱의 색(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>밝게(&amp;L)</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>어둡게(&amp;R)</translation>
    </message>
</context>
<context>
    <name>odo::ViewSteps</name>
    <message>
        <source>Same start time</source>
        <translation>동시에 시작</translation>
    </message>
    <message>
        <source>By hand: time offset</source>
        <translation>직접: 늦게 시작한 만큼</translation>
    </message>
    <message>
        <source>How to synchronise view %1 with the first</source>
        <translation>뷰 %1을(를) 첫째 뷰와 동기화하는 방법</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time offset of view %1</source>
        <translation>뷰 %1이(가) 늦게 시작한 시간</translation>
    </message>
    <message>
        <source>Negative: it started before the first view</source>
        <translation>0보다 작으면 첫째 뷰보다 먼저 시작한 것입니다</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>뷰 %1</translation>
    </message>
    <message>
        <source>Automatic: motion, flash or sound</source>
        <translation>자동: 움직임, 빛의 번쩍임 또는 소리</translation>
    </message>
    <message>
        <source>By the motion</source>
        <translation>움직임으로</translation>
    </message>
    <message>
        <source>By a flash of light</source>
        <translation>빛의 번쩍임으로</translation>
    </message>
    <message>
        <source>By sound</source>
        <translation>소리로</translation>
    </message>
    <message>
        <source>A flash: switch the room lights on and off once while all cameras record. Sound: clap twice near the middle of the floor</source>
        <translation>번쩍임: 모든 카메라가 녹화하는 동안 실내 조명을 한 번 켰다 끄십시오. 소리: 바닥 가운데 근처에서 박수를 두 번 치십시오</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>그대로</translation>
    </message>
</context>
<context>
    <name>odo::WarningBar</name>
    <message>
        <source>Problem</source>
        <translation>문제 내용</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>문제 해결</translation>
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
        <translation>일반 카메라의 동영상으로 이동 로봇이 어떻게 움직였는지 측정합니다.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>최근 프로젝트</translation>
    </message>
    <message>
        <source>no longer found</source>
        <translation>더 이상 찾을 수 없음</translation>
    </message>
</context>
<context>
    <name>odo::WindowMessages</name>
    <message>
        <source>&amp;Messages</source>
        <translation>메시지(&amp;M)</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>메시지 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>No messages.</source>
        <translation>메시지가 없습니다.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>취소했습니다. 아무것도 바뀌지 않았습니다.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>폴더에서 보기</translation>
    </message>
</context>
<context>
    <name>odo::Workspace</name>
    <message>
        <source>%1: %2. It is read-only here; to change it, close it there and reopen it here.</source>
        <translation>%1: %2. 여기서는 보기만 할 수 있습니다. 변경하려면 그쪽에서 닫고 여기서 다시 여십시오.</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as “%1”.</source>
        <translation>백업이 복원되었습니다. 손상된 파일은 “%1”(으)로 보관됩니다.</translation>
    </message>
    <message>
        <source>“%1” was written before you cancelled. It was not opened.</source>
        <translation>취소하기 전에 “%1”이(가) 이미 기록되었습니다. 열지는 않았습니다.</translation>
    </message>
    <message>
        <source>The backup was restored. What the project was before is kept as “%1”.</source>
        <translation>백업이 복원되었습니다. 이전 상태는 “%1”(으)로 보관됩니다.</translation>
    </message>
</context>
<context>
    <name>odo::ZoneTable</name>
    <message>
        <source>stay inside</source>
        <translation>이탈 금지</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>진입 금지</translation>
    </message>
    <message>
        <source>Remo&amp;ve zone</source>
        <translation>구역 제거(&amp;V)</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>구역</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>Corners: x y; x y; … in mm</source>
        <translation>꼭짓점: x y; x y; …(mm)</translation>
    </message>
    <message>
        <source>Zones of the floor</source>
        <translation>바닥의 구역</translation>
    </message>
    <message>
        <source>Add zone to sta&amp;y in</source>
        <translation>이탈 금지 구역 추가(&amp;S)</translation>
    </message>
    <message>
        <source>Add zone to &amp;keep out of</source>
        <translation>진입 금지 구역 추가(&amp;K)</translation>
    </message>
    <message>
        <source>The robot&apos;s reference point must stay in a zone or keep out of it. Each zone counts separately; you can score how often, how long and how far a robot broke it. Drag corners and edges on the map.</source>
        <translation>로봇의 중심은 구역을 벗어나지 않거나 구역에 들어가지 않아야 합니다. 구역마다 따로 판정하며, 몇 번, 얼마 동안, 얼마나 멀리 어겼는지를 채점에 쓸 수 있습니다. 지도에서 꼭짓점과 변을 끌어 옮기십시오.</translation>
    </message>
    <message>
        <source>Rule of the zone</source>
        <translation>구역의 규칙</translation>
    </message>
    <message>
        <source>Zone %1</source>
        <translation>구역 %1</translation>
    </message>
</context>
<context>
    <name>project.acceptance_reason</name>
    <message>
        <source>reason for accepting the results</source>
        <translation>결과를 승인하는 이유</translation>
    </message>
</context>
<context>
    <name>project.add_another_layout</name>
    <message>
        <source>add another layout for other markers</source>
        <translation>다른 마커는 다른 배치로 추가하십시오</translation>
    </message>
</context>
<context>
    <name>project.add_one_first</name>
    <message>
        <source>add one first</source>
        <translation>먼저 추가하십시오</translation>
    </message>
</context>
<context>
    <name>project.add_what_it_refers_to</name>
    <message>
        <source>add what it refers to first</source>
        <translation>먼저 가리키는 것을 추가하십시오</translation>
    </message>
</context>
<context>
    <name>project.adopt_or_remove</name>
    <message>
        <source>make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers both under &apos;Find stray files…&apos;</source>
        <translation>소속 없는 파일 찾기…에서 시행으로 추가하거나 제거하십시오</translation>
    </message>
</context>
<context>
    <name>project.an_analysis</name>
    <message>
        <source>analysis of a trial</source>
        <translation>시행의 분석</translation>
    </message>
</context>
<context>
    <name>project.analyse_again</name>
    <message>
        <source>reanalyse the trial</source>
        <translation>시행을 다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>project.analysis_number</name>
    <message>
        <source>analysis %1</source>
        <translation>분석 %1</translation>
    </message>
</context>
<context>
    <name>project.analysis_of_project</name>
    <message>
        <source>analysis %1 of the project</source>
        <translation>프로젝트의 분석 %1</translation>
    </message>
</context>
<context>
    <name>project.another_program_writes</name>
    <message>
        <source>another program is writing to it</source>
        <translation>다른 프로그램이 쓰고 있습니다</translation>
    </message>
</context>
<context>
    <name>project.area_few_corners</name>
    <message>
        <source>an area needs at least %1 corners</source>
        <translation>영역에는 모서리가 %1개 이상 필요합니다</translation>
    </message>
</context>
<context>
    <name>project.area_many_corners</name>
    <message>
        <source>an area has at most %1 corners</source>
        <translation>영역의 모서리는 최대 %1개입니다</translation>
    </message>
</context>
<context>
    <name>project.area_off_frame</name>
    <message>
        <source>a position is not in the frame</source>
        <translation>위치가 프레임 안에 없습니다</translation>
    </message>
</context>
<context>
    <name>project.being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>녹화 중입니다</translation>
    </message>
</context>
<context>
    <name>project.calibration_of_project</name>
    <message>
        <source>calibration %1 of the project</source>
        <translation>프로젝트의 보정 %1</translation>
    </message>
</context>
<context>
    <name>project.calibration_origin</name>
    <message>
        <source>origin of a calibration</source>
        <translation>보정의 출처</translation>
    </message>
</context>
<context>
    <name>project.calibration_picture_of</name>
    <message>
        <source>the calibration image &apos;%1&apos; of camera &apos;%2&apos;</source>
        <translation>카메라 &apos;%2&apos;의 보정 사진 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.camera_address</name>
    <message>
        <source>address of a camera</source>
        <translation>카메라의 주소</translation>
    </message>
</context>
<context>
    <name>project.cannot_be_written_to</name>
    <message>
        <source>it cannot be written to</source>
        <translation>쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.cannot_hold</name>
    <message>
        <source>cannot hold %1</source>
        <translation>%1을(를) 잠글 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.cannot_record_into</name>
    <message>
        <source>cannot record into %1</source>
        <translation>%1에 녹화할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.cannot_remove</name>
    <message>
        <source>cannot remove &apos;%1&apos;</source>
        <translation>&apos;%1&apos;을(를) 제거할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.change_list</name>
    <message>
        <source>the list of changes</source>
        <translation>변경 내역</translation>
    </message>
</context>
<context>
    <name>project.change_not_noted</name>
    <message>
        <source>the change could not be logged (%1)</source>
        <translation>변경을 기록하지 못했습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>project.change_something_first</name>
    <message>
        <source>change something first</source>
        <translation>먼저 무언가를 바꾸십시오</translation>
    </message>
</context>
<context>
    <name>project.change_words</name>
    <message>
        <source>description of a change</source>
        <translation>변경의 설명</translation>
    </message>
</context>
<context>
    <name>project.changed_since</name>
    <message>
        <source>something it concerns has been changed or used since</source>
        <translation>그 뒤 대상이 바뀌었거나 쓰였습니다</translation>
    </message>
</context>
<context>
    <name>project.check</name>
    <message>
        <source>check of the project</source>
        <translation>프로젝트 검사</translation>
    </message>
</context>
<context>
    <name>project.check_disk</name>
    <message>
        <source>check the disk</source>
        <translation>디스크를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>project.check_disk_and_retry</name>
    <message>
        <source>check the disk and try again</source>
        <translation>디스크를 확인하고 다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>project.check_folder_is_there</name>
    <message>
        <source>check that the folder exists and that you may read it</source>
        <translation>폴더가 있고 읽을 수 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>project.check_its_input</name>
    <message>
        <source>check the input that it was computed from</source>
        <translation>계산에 쓰인 입력을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>project.check_name_or_make</name>
    <message>
        <source>check the name, or create a new project</source>
        <translation>이름을 확인하거나 새 프로젝트를 만드십시오</translation>
    </message>
</context>
<context>
    <name>project.check_project_folder</name>
    <message>
        <source>check the free space and the permissions of the project&apos;s folder</source>
        <translation>프로젝트 폴더의 여유 공간과 권한을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>project.check_rights</name>
    <message>
        <source>check the permissions of the project&apos;s folder</source>
        <translation>프로젝트 폴더의 권한을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>project.checking</name>
    <message>
        <source>checking %1</source>
        <translation>%1 검사 중</translation>
    </message>
</context>
<context>
    <name>project.checking_database</name>
    <message>
        <source>checking the database</source>
        <translation>데이터베이스 검사 중</translation>
    </message>
</context>
<context>
    <name>project.choose_from_list</name>
    <message>
        <source>choose one from the list</source>
        <translation>목록에서 하나를 선택하세요</translation>
    </message>
</context>
<context>
    <name>project.choose_its_own</name>
    <message>
        <source>choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy</source>
        <translation>이 카메라의 것을 고르거나(이전 보정…) 백업 사본에서 프로젝트를 복원하십시오</translation>
    </message>
</context>
<context>
    <name>project.choose_our_file</name>
    <message>
        <source>choose a file that Odograph has written</source>
        <translation>Odograph가 쓴 파일을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>project.choose_writable_folder</name>
    <message>
        <source>choose a folder that can be written to and has free space</source>
        <translation>쓸 수 있고 여유가 있는 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>project.class_has_team</name>
    <message>
        <source>a team belongs to it</source>
        <translation>팀 하나가 속해 있습니다</translation>
    </message>
</context>
<context>
    <name>project.class_has_teams</name>
    <message>
        <source>%1 teams belong to it</source>
        <translation>팀 %1개가 속해 있습니다</translation>
    </message>
</context>
<context>
    <name>project.close_it_there</name>
    <message>
        <source>close it there first</source>
        <translation>먼저 거기서 닫으십시오</translation>
    </message>
</context>
<context>
    <name>project.close_other_program</name>
    <message>
        <source>close the other program and try again</source>
        <translation>다른 프로그램을 닫고 다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>project.complete_recording</name>
    <message>
        <source>to complete it, open the project for writing: odograph record P.odo --recover</source>
        <translation>프로젝트를 쓰기용으로 열면 녹화가 마무리됩니다</translation>
    </message>
</context>
<context>
    <name>project.copy</name>
    <message>
        <source>copy &apos;%1&apos;</source>
        <translation>사본 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_again</name>
    <message>
        <source>copy it again from its source, or restore a backup copy</source>
        <translation>원본에서 다시 복사하거나 백업을 복원하십시오</translation>
    </message>
</context>
<context>
    <name>project.copy_differs</name>
    <message>
        <source>the copy differs from what was written</source>
        <translation>사본이 쓴 것과 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.copy_file_beside</name>
    <message>
        <source>copy the file to the project&apos;s folder</source>
        <translation>파일을 프로젝트 옆에 복사하십시오</translation>
    </message>
</context>
<context>
    <name>project.copy_of_project</name>
    <message>
        <source>copy of project &apos;%1&apos;</source>
        <translation>프로젝트 &apos;%1&apos;의 사본</translation>
    </message>
</context>
<context>
    <name>project.copy_sound_backup</name>
    <message>
        <source>copy &apos;%1&apos;, which is intact, to a new name, open that copy and keep the damaged file</source>
        <translation>온전한 &apos;%1&apos;을(를) 새 이름으로 복사하여 그 사본을 여시고, 손상된 파일은 보관하십시오</translation>
    </message>
</context>
<context>
    <name>project.copy_to_another_disk</name>
    <message>
        <source>check the disk, and copy the project to another one</source>
        <translation>디스크를 확인하고 프로젝트를 다른 곳에 복사하십시오</translation>
    </message>
</context>
<context>
    <name>project.copy_to_writable_folder</name>
    <message>
        <source>copy it to a folder that you may write to, and open the copy</source>
        <translation>쓸 수 있는 폴더로 복사한 뒤 사본을 여십시오</translation>
    </message>
</context>
<context>
    <name>project.copy_with_side_files</name>
    <message>
        <source>copy it with the files beside it to a folder that you may write to, and open the copy</source>
        <translation>옆에 있는 파일과 함께 쓸 수 있는 폴더로 복사한 뒤 그 사본을 여십시오</translation>
    </message>
</context>
<context>
    <name>project.copy_with_videos</name>
    <message>
        <source>copy it with its videos to a folder that you may write to, and open the copy</source>
        <translation>동영상과 함께 쓸 수 있는 폴더로 복사한 뒤 사본을 여십시오</translation>
    </message>
</context>
<context>
    <name>project.corners_of</name>
    <message>
        <source>corners of &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 모서리</translation>
    </message>
</context>
<context>
    <name>project.covariance_not_6_by_6</name>
    <message>
        <source>its stored covariance is not a 6 by 6 matrix</source>
        <translation>저장된 공분산이 6×6 행렬이 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.database_refused</name>
    <message>
        <source>the database reported an error</source>
        <translation>데이터베이스가 거부했습니다</translation>
    </message>
</context>
<context>
    <name>project.database_refused_because</name>
    <message>
        <source>the database reported an error (%1)</source>
        <translation>데이터베이스가 거부했습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>project.delete_its_trials</name>
    <message>
        <source>delete its trials permanently first, or archive its class</source>
        <translation>먼저 영구 삭제하거나 학급을 보관하십시오</translation>
    </message>
</context>
<context>
    <name>project.disk_error</name>
    <message>
        <source>the disk reported an error, the change was not saved</source>
        <translation>디스크 오류로 변경이 저장되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>project.disk_full</name>
    <message>
        <source>the disk is full, the change was not saved</source>
        <translation>디스크가 가득 차 변경이 저장되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>project.disk_read_only</name>
    <message>
        <source>the disk has become read-only, the change was not saved</source>
        <translation>디스크가 읽기 전용이 되어 변경이 저장되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>project.disk_unreadable</name>
    <message>
        <source>the disk could not be read; nothing was changed</source>
        <translation>디스크를 읽을 수 없었으며 변경된 것은 없습니다</translation>
    </message>
</context>
<context>
    <name>project.duration_of_recordings_differs</name>
    <message>
        <source>its duration is stored as %1, its recordings last %2</source>
        <translation>저장된 길이는 %1인데 녹화의 길이는 %2입니다</translation>
    </message>
</context>
<context>
    <name>project.duration_of_tracks_differs</name>
    <message>
        <source>its duration is stored as %1, its imported tracks last %2</source>
        <translation>저장된 길이는 %1인데 가져온 궤적의 길이는 %2입니다</translation>
    </message>
</context>
<context>
    <name>project.earlier_step_failed</name>
    <message>
        <source>an earlier step of this change failed</source>
        <translation>이 변경의 앞 단계가 실패했습니다</translation>
    </message>
</context>
<context>
    <name>project.end_recording_first</name>
    <message>
        <source>end its recording first</source>
        <translation>먼저 녹화를 끝내십시오</translation>
    </message>
</context>
<context>
    <name>project.figures_without_task</name>
    <message>
        <source>without it, their metrics would not show which rules applied</source>
        <translation>지표가 무엇으로 측정되었는지 알 수 없게 됩니다</translation>
    </message>
</context>
<context>
    <name>project.file_changed</name>
    <message>
        <source>%1 has changed since it was created</source>
        <translation>%1이(가) 만들어진 뒤 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.file_cut_off</name>
    <message>
        <source>the file is incomplete</source>
        <translation>파일이 잘렸습니다</translation>
    </message>
</context>
<context>
    <name>project.file_damaged</name>
    <message>
        <source>the file is damaged</source>
        <translation>파일이 손상되었습니다</translation>
    </message>
</context>
<context>
    <name>project.file_lost</name>
    <message>
        <source>its file was deleted, renamed or replaced while it was open; nothing was stored</source>
        <translation>열려 있는 동안 파일이 삭제되거나 이름이 바뀌거나 교체되었습니다. 저장된 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.file_there_already</name>
    <message>
        <source>a file of that name already exists</source>
        <translation>같은 이름의 파일이 이미 있습니다</translation>
    </message>
</context>
<context>
    <name>project.file_unused</name>
    <message>
        <source>no trial, lens calibration or floor registration uses this file</source>
        <translation>이 파일을 쓰는 시행, 렌즈 보정, 바닥 정합이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.find_or_put_back</name>
    <message>
        <source>take it from there with odograph check P.odo --find FOLDER or Find lost videos… in the window, or move it back to its folder</source>
        <translation>잃은 동영상 찾기…로 거기서 가져오거나 제자리에 되돌려 놓으십시오</translation>
    </message>
</context>
<context>
    <name>project.folder_read_only</name>
    <message>
        <source>its folder cannot be written to</source>
        <translation>폴더에 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.foreign_log</name>
    <message>
        <source>the log beside it (&apos;%1&apos;) belongs to another file or to another state of this one</source>
        <translation>옆에 있는 로그(&apos;%1&apos;)는 다른 파일 또는 이 파일의 다른 상태에 속합니다</translation>
    </message>
</context>
<context>
    <name>project.format_1</name>
    <message>
        <source>the first schema</source>
        <translation>첫 스키마</translation>
    </message>
</context>
<context>
    <name>project.format_10</name>
    <message>
        <source>for a school year: stars, tags, archive, bin, pseudonyms, scoring and the list of changes</source>
        <translation>한 학년도에 필요한 것: 별표, 태그, 보관함, 휴지통, 가명, 채점, 변경 내역</translation>
    </message>
</context>
<context>
    <name>project.format_11</name>
    <message>
        <source>members and robots of teams, zones and the archive of tasks, and imported tracks</source>
        <translation>팀의 팀원과 로봇, 구역과 과제 보관함, 가져온 궤적</translation>
    </message>
</context>
<context>
    <name>project.format_12</name>
    <message>
        <source>digests of analyses, and long series in chunks</source>
        <translation>분석의 다이제스트, 나누어 저장한 긴 데이터 열</translation>
    </message>
</context>
<context>
    <name>project.format_13</name>
    <message>
        <source>reference points of robots</source>
        <translation>로봇의 측정점</translation>
    </message>
</context>
<context>
    <name>project.format_14</name>
    <message>
        <source>periods with ambiguous robot names</source>
        <translation>겉모습이 같은 로봇을 구별할 수 없었던 때</translation>
    </message>
</context>
<context>
    <name>project.format_15</name>
    <message>
        <source>robots marked by hand in a frame</source>
        <translation>사람이 영상에서 가리킨 로봇</translation>
    </message>
</context>
<context>
    <name>project.format_16</name>
    <message>
        <source>messages as codes with their arguments</source>
        <translation>코드와 인수로 된 문장</translation>
    </message>
</context>
<context>
    <name>project.format_17</name>
    <message>
        <source>verdicts, and their acceptance</source>
        <translation>판정과 그 승인</translation>
    </message>
</context>
<context>
    <name>project.format_18</name>
    <message>
        <source>how the frames of recordings are turned</source>
        <translation>녹화 프레임의 회전 방식</translation>
    </message>
</context>
<context>
    <name>project.format_19</name>
    <message>
        <source>ranges and variables of trials</source>
        <translation>시행의 구간과 변수</translation>
    </message>
</context>
<context>
    <name>project.format_2</name>
    <message>
        <source>manual overrides of samples</source>
        <translation>직접 판정을 바꾼 샘플</translation>
    </message>
</context>
<context>
    <name>project.format_20</name>
    <message>
        <source>which observations are in force</source>
        <translation>적용 중인 관측</translation>
    </message>
</context>
<context>
    <name>project.format_21</name>
    <message>
        <source>guidance of the tracker, and the school&apos;s hub</source>
        <translation>추적을 위한 지정과 학교 허브</translation>
    </message>
</context>
<context>
    <name>project.format_3</name>
    <message>
        <source>clock rates of the cameras</source>
        <translation>카메라 시계의 속도</translation>
    </message>
</context>
<context>
    <name>project.format_4</name>
    <message>
        <source>tasks with gates, a reference path and limits</source>
        <translation>게이트, 기준 경로, 한계가 있는 과제</translation>
    </message>
</context>
<context>
    <name>project.format_5</name>
    <message>
        <source>synchronisation of each view</source>
        <translation>각 뷰를 동기화한 방법</translation>
    </message>
</context>
<context>
    <name>project.format_6</name>
    <message>
        <source>calibrations with their boards, corners and images</source>
        <translation>보드, 모서리, 사진이 있는 보정</translation>
    </message>
</context>
<context>
    <name>project.format_7</name>
    <message>
        <source>chosen revisions and registration checks</source>
        <translation>선택한 버전과 정합 점검</translation>
    </message>
</context>
<context>
    <name>project.format_8</name>
    <message>
        <source>trials during recording, and the raw times of their frames</source>
        <translation>녹화 중인 시행과 그 영상의 원시 시간</translation>
    </message>
</context>
<context>
    <name>project.format_9</name>
    <message>
        <source>images of registrations</source>
        <translation>정합 사진</translation>
    </message>
</context>
<context>
    <name>project.frame_times_of</name>
    <message>
        <source>frame times of &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 프레임 시간</translation>
    </message>
</context>
<context>
    <name>project.frames_in_wrong_order</name>
    <message>
        <source>it ends before it starts</source>
        <translation>시작보다 먼저 끝납니다</translation>
    </message>
</context>
<context>
    <name>project.give_a_height</name>
    <message>
        <source>enter a height, or have it estimated</source>
        <translation>높이를 주거나 추정하게 하십시오</translation>
    </message>
</context>
<context>
    <name>project.give_a_name</name>
    <message>
        <source>give the %1 a name</source>
        <translation>%1에 이름을 붙이십시오</translation>
    </message>
</context>
<context>
    <name>project.give_a_title</name>
    <message>
        <source>give the project a title</source>
        <translation>프로젝트에 제목을 붙이십시오</translation>
    </message>
</context>
<context>
    <name>project.give_another_task</name>
    <message>
        <source>give them another task first</source>
        <translation>먼저 다른 과제를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>project.give_fewer_corners</name>
    <message>
        <source>give fewer corners, or two areas</source>
        <translation>모서리를 줄이거나 영역을 둘로 나누세요</translation>
    </message>
</context>
<context>
    <name>project.give_file_a_name</name>
    <message>
        <source>give the file a name</source>
        <translation>파일 이름을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>project.give_frame_pixels</name>
    <message>
        <source>give positions in pixels of the frame</source>
        <translation>프레임의 픽셀로 위치를 지정하세요</translation>
    </message>
</context>
<context>
    <name>project.give_frames_in_order</name>
    <message>
        <source>give the start before the end</source>
        <translation>시작을 끝보다 앞에 지정하세요</translation>
    </message>
</context>
<context>
    <name>project.give_members</name>
    <message>
        <source>give the names of the people in the team</source>
        <translation>팀원의 이름을 적으십시오</translation>
    </message>
</context>
<context>
    <name>project.give_more_corners</name>
    <message>
        <source>give more corners</source>
        <translation>모서리를 더 지정하세요</translation>
    </message>
</context>
<context>
    <name>project.give_robot_size</name>
    <message>
        <source>give length and width in millimetres, like 260x190</source>
        <translation>길이와 너비를 밀리미터로 주십시오 (예: 260x190)</translation>
    </message>
</context>
<context>
    <name>project.give_sigma_px</name>
    <message>
        <source>give σ in pixels</source>
        <translation>σ를 픽셀로 지정하세요</translation>
    </message>
</context>
<context>
    <name>project.give_whole_truth</name>
    <message>
        <source>give position, velocity and acceleration for each time</source>
        <translation>각 시간의 위치, 속도, 가속도를 주십시오</translation>
    </message>
</context>
<context>
    <name>project.guidance</name>
    <message>
        <source>guidance of the tracker</source>
        <translation>추적 지침</translation>
    </message>
</context>
<context>
    <name>project.guidance_is_gone</name>
    <message>
        <source>it was removed meanwhile</source>
        <translation>그 사이에 제거되었습니다</translation>
    </message>
</context>
<context>
    <name>project.guidance_too_many</name>
    <message>
        <source>the view already has %1 of them</source>
        <translation>뷰에 이미 %1개가 있습니다</translation>
    </message>
</context>
<context>
    <name>project.has_bytes_of</name>
    <message>
        <source>it has %1 of %2 bytes</source>
        <translation>%2바이트 중 %1바이트만 있습니다</translation>
    </message>
</context>
<context>
    <name>project.has_characters</name>
    <message>
        <source>it has %1 characters</source>
        <translation>%1자입니다</translation>
    </message>
</context>
<context>
    <name>project.has_names</name>
    <message>
        <source>it has %1</source>
        <translation>있는 것: %1</translation>
    </message>
</context>
<context>
    <name>project.has_none_yet</name>
    <message>
        <source>it has no %1 yet</source>
        <translation>아직 %1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>project.has_other_size</name>
    <message>
        <source>%1 has %2 bytes instead of %3</source>
        <translation>%1이(가) %3바이트가 아니라 %2바이트입니다</translation>
    </message>
</context>
<context>
    <name>project.has_robots</name>
    <message>
        <source>it has %1 robots</source>
        <translation>로봇이 %1대입니다</translation>
    </message>
</context>
<context>
    <name>project.has_views</name>
    <message>
        <source>it has %1 views</source>
        <translation>뷰가 %1개입니다</translation>
    </message>
</context>
<context>
    <name>project.height_below_floor</name>
    <message>
        <source>its height is below the floor</source>
        <translation>높이가 바닥보다 낮습니다</translation>
    </message>
</context>
<context>
    <name>project.height_from_0</name>
    <message>
        <source>give a height of 0 or more</source>
        <translation>0 이상의 높이를 주십시오</translation>
    </message>
</context>
<context>
    <name>project.height_not_given</name>
    <message>
        <source>it needs a fixed height, but none is given</source>
        <translation>높이를 지정해야 하는데 없습니다</translation>
    </message>
</context>
<context>
    <name>project.holds_invisible</name>
    <message>
        <source>it holds an invisible character, %1</source>
        <translation>보이지 않는 문자 %1이(가) 들어 있습니다</translation>
    </message>
</context>
<context>
    <name>project.holds_line_break</name>
    <message>
        <source>it holds a line break or another control character</source>
        <translation>줄바꿈이나 다른 제어 문자가 들어 있습니다</translation>
    </message>
</context>
<context>
    <name>project.ignored_area</name>
    <message>
        <source>ignored area</source>
        <translation>무시 영역</translation>
    </message>
</context>
<context>
    <name>project.import_another_file</name>
    <message>
        <source>import another file</source>
        <translation>다른 파일을 가져오십시오</translation>
    </message>
</context>
<context>
    <name>project.impossible_format</name>
    <message>
        <source>it claims to have format %1</source>
        <translation>스스로 형식 %1이라고 합니다</translation>
    </message>
</context>
<context>
    <name>project.in_synced_folder</name>
    <message>
        <source>it is in a folder that %1 copies while it changes: a copy may contain half a change</source>
        <translation>변경 중에 %1이(가) 복사하는 폴더에 있어 사본에 변경의 절반만 담길 수 있습니다</translation>
    </message>
</context>
<context>
    <name>project.is_missing</name>
    <message>
        <source>%1 is missing</source>
        <translation>%1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>project.is_missing_recording</name>
    <message>
        <source>this is a missing recording</source>
        <translation>없어진 녹화입니다</translation>
    </message>
</context>
<context>
    <name>project.journal_of_another</name>
    <message>
        <source>the journal beside it names another file</source>
        <translation>옆에 있는 저널이 다른 파일을 가리킵니다</translation>
    </message>
</context>
<context>
    <name>project.keep_it</name>
    <message>
        <source>keep it</source>
        <translation>그대로 두십시오</translation>
    </message>
</context>
<context>
    <name>project.keep_on_own_disk</name>
    <message>
        <source>keep it on a disk of this computer, and pack it to share it</source>
        <translation>이 컴퓨터의 디스크에 보관하고, 공유하려면 묶으십시오</translation>
    </message>
</context>
<context>
    <name>project.kind_calibration</name>
    <message>
        <source>calibration</source>
        <translation>보정</translation>
    </message>
</context>
<context>
    <name>project.kind_camera</name>
    <message>
        <source>camera</source>
        <translation>카메라</translation>
    </message>
</context>
<context>
    <name>project.kind_class</name>
    <message>
        <source>class</source>
        <translation>학급</translation>
    </message>
</context>
<context>
    <name>project.kind_figure</name>
    <message>
        <source>metric</source>
        <translation>지표</translation>
    </message>
</context>
<context>
    <name>project.kind_gate</name>
    <message>
        <source>gate</source>
        <translation>게이트</translation>
    </message>
</context>
<context>
    <name>project.kind_layout</name>
    <message>
        <source>layout</source>
        <translation>배치</translation>
    </message>
</context>
<context>
    <name>project.kind_lens</name>
    <message>
        <source>lens calibration</source>
        <translation>렌즈</translation>
    </message>
</context>
<context>
    <name>project.kind_marker</name>
    <message>
        <source>marker</source>
        <translation>마커</translation>
    </message>
</context>
<context>
    <name>project.kind_member</name>
    <message>
        <source>member</source>
        <translation>팀원</translation>
    </message>
</context>
<context>
    <name>project.kind_pseudonym</name>
    <message>
        <source>pseudonym</source>
        <translation>가명</translation>
    </message>
</context>
<context>
    <name>project.kind_registration</name>
    <message>
        <source>registration</source>
        <translation>정합</translation>
    </message>
</context>
<context>
    <name>project.kind_robot</name>
    <message>
        <source>robot</source>
        <translation>로봇</translation>
    </message>
</context>
<context>
    <name>project.kind_tag</name>
    <message>
        <source>tag</source>
        <translation>태그</translation>
    </message>
</context>
<context>
    <name>project.kind_task</name>
    <message>
        <source>task</source>
        <translation>과제</translation>
    </message>
</context>
<context>
    <name>project.kind_team</name>
    <message>
        <source>team</source>
        <translation>팀</translation>
    </message>
</context>
<context>
    <name>project.kind_track</name>
    <message>
        <source>track</source>
        <translation>궤적</translation>
    </message>
</context>
<context>
    <name>project.kind_trial</name>
    <message>
        <source>trial</source>
        <translation>시행</translation>
    </message>
</context>
<context>
    <name>project.kind_variable</name>
    <message>
        <source>variable</source>
        <translation>변수</translation>
    </message>
</context>
<context>
    <name>project.kind_zone</name>
    <message>
        <source>zone</source>
        <translation>구역</translation>
    </message>
</context>
<context>
    <name>project.label_twice</name>
    <message>
        <source>the label &apos;%1&apos; appears twice</source>
        <translation>이름표 &apos;%1&apos;이(가) 두 번 있습니다</translation>
    </message>
</context>
<context>
    <name>project.leave_it</name>
    <message>
        <source>leave it</source>
        <translation>그대로 두십시오</translation>
    </message>
</context>
<context>
    <name>project.leave_one_out</name>
    <message>
        <source>use only one of the two</source>
        <translation>둘 중 하나를 빼십시오</translation>
    </message>
</context>
<context>
    <name>project.leave_out_unseen_markers</name>
    <message>
        <source>remove those that no camera sees</source>
        <translation>어떤 카메라에도 보이지 않는 것은 빼십시오</translation>
    </message>
</context>
<context>
    <name>project.lengths_differ</name>
    <message>
        <source>samples and profile differ in length</source>
        <translation>샘플과 프로파일의 길이가 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.lens_kept</name>
    <message>
        <source>the lens calibration remains valid without it</source>
        <translation>이것이 없어도 렌즈는 유지됩니다</translation>
    </message>
</context>
<context>
    <name>project.lens_of_project</name>
    <message>
        <source>lens calibration %1 of the project</source>
        <translation>프로젝트의 렌즈 %1</translation>
    </message>
</context>
<context>
    <name>project.lies_in_media</name>
    <message>
        <source>a project is in the media folder of another one</source>
        <translation>다른 프로젝트의 미디어 폴더에 프로젝트가 있습니다</translation>
    </message>
</context>
<context>
    <name>project.lists_too_long</name>
    <message>
        <source>%1: more than %2 of one %3: %4</source>
        <translation>%1: 한 %3에 %2개를 넘음: %4</translation>
    </message>
</context>
<context>
    <name>project.look_for_strays</name>
    <message>
        <source>find stray files</source>
        <translation>소속 없는 파일 찾기</translation>
    </message>
</context>
<context>
    <name>project.look_in</name>
    <message>
        <source>search &apos;%1&apos;</source>
        <translation>&apos;%1&apos;에서 찾기</translation>
    </message>
</context>
<context>
    <name>project.marker_errors_differ</name>
    <message>
        <source>the stored marker errors of registration %1 differ from those of its markers</source>
        <translation>정합 %1의 마커 오차가 그 마커에서 나온 값과 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.marker_off_floor</name>
    <message>
        <source>marker &apos;%1&apos; is not within a floor of 1 km</source>
        <translation>마커 &apos;%1&apos;이(가) 1 km 바닥 안에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>project.matrix_not_square</name>
    <message>
        <source>its stored matrix of %1 numbers is not square</source>
        <translation>저장된 수 %1개의 행렬이 정사각이 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.may_be_used_beside</name>
    <message>
        <source>project &apos;%1&apos; beside it may use them, and cannot be read (%2)</source>
        <translation>옆에 있는 프로젝트 &apos;%1&apos;이(가) 이 파일을 쓸 수 있는데 읽을 수 없습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>project.measured_by_task</name>
    <message>
        <source>its rules were used to measure trials</source>
        <translation>이것으로 측정한 시행이 있습니다</translation>
    </message>
</context>
<context>
    <name>project.measurements_changed</name>
    <message>
        <source>the measurements have changed since robot &apos;%1&apos; was analysed</source>
        <translation>로봇 &apos;%1&apos;을(를) 분석한 뒤 측정값이 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.metric</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>지표 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.metric_differs</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>로봇 &apos;%2&apos;의 지표 &apos;%1&apos;이(가) %3(으)로 저장되어 있는데 위치에서는 %4입니다</translation>
    </message>
</context>
<context>
    <name>project.metric_missing</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is missing, its positions give %3</source>
        <translation>로봇 &apos;%2&apos;의 지표 &apos;%1&apos;이(가) 없는데 위치에서는 %3입니다</translation>
    </message>
</context>
<context>
    <name>project.metric_sigma_differs</name>
    <message>
        <source>the standard deviation of metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>로봇 &apos;%2&apos;의 지표 &apos;%1&apos;의 표준 편차가 %3(으)로 저장되어 있는데 위치에서는 %4입니다</translation>
    </message>
</context>
<context>
    <name>project.metric_without_source</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored, but its positions give none</source>
        <translation>로봇 &apos;%2&apos;의 지표 &apos;%1&apos;이(가) 저장되어 있는데 위치에서는 나오지 않습니다</translation>
    </message>
</context>
<context>
    <name>project.more_names</name>
    <message>
        <source>%1 more</source>
        <translation>외 %1개</translation>
    </message>
</context>
<context>
    <name>project.move_file_away</name>
    <message>
        <source>move it to another folder</source>
        <translation>다른 폴더로 옮기십시오</translation>
    </message>
</context>
<context>
    <name>project.move_log_away</name>
    <message>
        <source>move the log to another folder to open the file without it, or restore the file that the log belongs to</source>
        <translation>로그를 다른 폴더로 옮겨 로그 없이 파일을 여시거나, 로그가 속한 파일을 제자리에 되돌려 놓으십시오</translation>
    </message>
</context>
<context>
    <name>project.move_project_away</name>
    <message>
        <source>move it with its videos to a folder of its own</source>
        <translation>동영상과 함께 별도 폴더로 옮기십시오</translation>
    </message>
</context>
<context>
    <name>project.move_teams_first</name>
    <message>
        <source>move its teams to another class first, or archive it</source>
        <translation>먼저 팀을 다른 학급으로 옮기거나 보관하십시오</translation>
    </message>
</context>
<context>
    <name>project.name_empty</name>
    <message>
        <source>it is empty</source>
        <translation>비어 있습니다</translation>
    </message>
</context>
<context>
    <name>project.name_of</name>
    <message>
        <source>name of a %1</source>
        <translation>%1의 이름</translation>
    </message>
</context>
<context>
    <name>project.name_robots_once</name>
    <message>
        <source>list each of its robots once</source>
        <translation>각 로봇을 한 번씩만 적으십시오</translation>
    </message>
</context>
<context>
    <name>project.name_taken</name>
    <message>
        <source>the project already has a %1 of that name</source>
        <translation>프로젝트에 같은 이름의 %1이(가) 이미 있습니다</translation>
    </message>
</context>
<context>
    <name>project.name_video_file</name>
    <message>
        <source>name the video&apos;s file</source>
        <translation>동영상 파일을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>project.newer_format</name>
    <message>
        <source>it was written by a newer Odograph (format %1, this one knows formats up to %2)</source>
        <translation>더 새로운 Odograph가 썼습니다 (형식 %1, 이 프로그램은 %2까지)</translation>
    </message>
</context>
<context>
    <name>project.no_file_but_other</name>
    <message>
        <source>it is a folder or a device, not a file</source>
        <translation>파일이 아니라 폴더 또는 장치입니다</translation>
    </message>
</context>
<context>
    <name>project.no_file_name</name>
    <message>
        <source>it has no file name</source>
        <translation>파일 이름이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.no_ordinary_number</name>
    <message>
        <source>a value to store is too large or not a number</source>
        <translation>저장할 값이 보통 크기의 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.no_place_to_rescue_to</name>
    <message>
        <source>its folder is gone, and no home folder exists to rescue it to</source>
        <translation>폴더가 사라졌고 구조할 홈 폴더도 없습니다</translation>
    </message>
</context>
<context>
    <name>project.no_samples</name>
    <message>
        <source>it has no samples</source>
        <translation>샘플이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.no_sound_backup</name>
    <message>
        <source>no intact backup was found beside it</source>
        <translation>곁에 온전한 백업 사본이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.no_such_name</name>
    <message>
        <source>the project has no such %1</source>
        <translation>프로젝트에 그런 %1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>project.no_such_number</name>
    <message>
        <source>it has no %1 with the number %2</source>
        <translation>번호가 %2인 %1이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>project.not_a_project</name>
    <message>
        <source>it is not a project file</source>
        <translation>프로젝트 파일이 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.not_brought_to_format</name>
    <message>
        <source>it could not be converted to format %1 (%2)</source>
        <translation>형식 %1(으)로 갱신하지 못했습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>project.not_complete_yet</name>
    <message>
        <source>it is not complete yet</source>
        <translation>아직 완전하지 않습니다</translation>
    </message>
</context>
<context>
    <name>project.not_copied</name>
    <message>
        <source>it could not be copied to be read (%1)</source>
        <translation>읽기 위해 복사할 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>project.not_finite</name>
    <message>
        <source>it is not a finite number</source>
        <translation>유한한 수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.not_in_bin</name>
    <message>
        <source>it is not in the bin</source>
        <translation>휴지통에 없습니다</translation>
    </message>
</context>
<context>
    <name>project.not_utf8</name>
    <message>
        <source>it is not valid UTF-8 text</source>
        <translation>올바른 UTF-8 텍스트가 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.not_visible_span</name>
    <message>
        <source>time in which a robot is not visible</source>
        <translation>로봇이 보이지 않는 시간</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_redo</name>
    <message>
        <source>nothing has been undone</source>
        <translation>되돌린 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_undo</name>
    <message>
        <source>nothing has been changed since the project was opened</source>
        <translation>프로젝트를 연 뒤 바뀐 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.numbers_too_large</name>
    <message>
        <source>%1: numbers beyond %2: %3</source>
        <translation>%1: %2을(를) 넘는 수: %3</translation>
    </message>
</context>
<context>
    <name>project.observations_do_not_fit</name>
    <message>
        <source>view &apos;%1&apos; has %2 frames, but the observations of &apos;%3&apos; (%4) do not fit them</source>
        <translation>뷰 &apos;%1&apos;의 프레임은 %2개인데 &apos;%3&apos;의 관측(%4개)이 이에 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>project.observations_of_project</name>
    <message>
        <source>observations %1 of the project</source>
        <translation>프로젝트의 관측 %1</translation>
    </message>
</context>
<context>
    <name>project.older_format</name>
    <message>
        <source>it has the older format %1 and must be updated before Odograph can read it, but %2</source>
        <translation>옛 형식 %1이라 읽기 전에 갱신해야 하는데, %2</translation>
    </message>
</context>
<context>
    <name>project.on_network_disk</name>
    <message>
        <source>it is on a network disk (%1): a recording can stall there, and two computers can damage it</source>
        <translation>네트워크 디스크(%1)에 있어 녹화가 멈추거나 두 컴퓨터가 손상시킬 수 있습니다</translation>
    </message>
</context>
<context>
    <name>project.open_again</name>
    <message>
        <source>open it again; if you were recording, find stray files (odograph check --adopt)</source>
        <translation>다시 여십시오. 녹화 중이었다면 소속 없는 파일 찾기…를 보십시오</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere</name>
    <message>
        <source>it is open in another window</source>
        <translation>다른 창에서 열려 있습니다</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere_by</name>
    <message>
        <source>it is open in another window (%1)</source>
        <translation>다른 창에서 열려 있습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>project.open_or_move_that</name>
    <message>
        <source>open that project, or move it to a folder of its own with its videos</source>
        <translation>그 프로젝트를 열거나 동영상과 함께 별도 폴더로 옮기십시오</translation>
    </message>
</context>
<context>
    <name>project.open_with_newer_odograph</name>
    <message>
        <source>open the project with a newer Odograph</source>
        <translation>더 새로운 Odograph로 프로젝트를 여십시오</translation>
    </message>
</context>
<context>
    <name>project.open_with_that_odograph</name>
    <message>
        <source>open it with that version, or update this one</source>
        <translation>그 Odograph로 열거나 이 프로그램을 업데이트하십시오</translation>
    </message>
</context>
<context>
    <name>project.other_database</name>
    <message>
        <source>it is a database of another program</source>
        <translation>다른 프로그램의 데이터베이스입니다</translation>
    </message>
</context>
<context>
    <name>project.other_labels</name>
    <message>
        <source>the labels differ from those of the layout</source>
        <translation>이름표가 원래의 것과 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.other_tables</name>
    <message>
        <source>its tables are not those of a project</source>
        <translation>테이블이 프로젝트의 것이 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.others_calibration_chosen</name>
    <message>
        <source>calibration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>선택된 보정 %1은(는) 카메라 &apos;%2&apos;의 것입니다. 이 카메라의 최신 보정을 씁니다</translation>
    </message>
</context>
<context>
    <name>project.others_registration_chosen</name>
    <message>
        <source>registration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>선택된 정합 %1은(는) 카메라 &apos;%2&apos;의 것입니다. 이 카메라의 최신 정합을 씁니다</translation>
    </message>
</context>
<context>
    <name>project.overrides_changed</name>
    <message>
        <source>the manual overrides have changed since robot &apos;%1&apos; was analysed</source>
        <translation>로봇 &apos;%1&apos;을(를) 분석한 뒤 직접 한 판정이 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.path_cut_off</name>
    <message>
        <source>its reference path ends within a point</source>
        <translation>기준 경로가 점의 중간에서 끝납니다</translation>
    </message>
</context>
<context>
    <name>project.path_leaves_folder</name>
    <message>
        <source>its relative path points outside the project&apos;s folder</source>
        <translation>상대 경로가 프로젝트 폴더를 벗어납니다</translation>
    </message>
</context>
<context>
    <name>project.picture_name</name>
    <message>
        <source>name of a calibration image</source>
        <translation>보정 사진의 이름</translation>
    </message>
</context>
<context>
    <name>project.picture_path</name>
    <message>
        <source>path of a calibration image</source>
        <translation>보정 사진의 경로</translation>
    </message>
</context>
<context>
    <name>project.point_by_hand</name>
    <message>
        <source>point set by hand</source>
        <translation>수동으로 지정한 점</translation>
    </message>
</context>
<context>
    <name>project.point_without_sigma</name>
    <message>
        <source>it needs one position and a σ above 0 px</source>
        <translation>위치 하나와 0 px보다 큰 σ가 필요합니다</translation>
    </message>
</context>
<context>
    <name>project.position_no_number</name>
    <message>
        <source>a position or its covariance is not a number</source>
        <translation>위치나 그 공분산이 숫자가 아닙니다</translation>
    </message>
</context>
<context>
    <name>project.positions_changed</name>
    <message>
        <source>the stored positions of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>로봇 &apos;%1&apos;의 위치가 분석에서 나온 값과 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.project</name>
    <message>
        <source>project &apos;%1&apos;</source>
        <translation>프로젝트 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.project_file_damaged</name>
    <message>
        <source>the project file is damaged</source>
        <translation>프로젝트 파일이 손상되었습니다</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_open</name>
    <message>
        <source>move the file back to its folder, and open the project again</source>
        <translation>파일을 제자리에 돌려놓고 프로젝트를 다시 여십시오</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_retry</name>
    <message>
        <source>move it back to its folder and try again</source>
        <translation>파일을 제자리에 되돌려 놓고 다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>project.put_back_or_find</name>
    <message>
        <source>move the file back to its folder, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in the window</source>
        <translation>파일을 제자리에 돌려놓거나 잃은 동영상 찾기…를 써서 내용으로 찾으십시오</translation>
    </message>
</context>
<context>
    <name>project.put_file_back</name>
    <message>
        <source>move the file back to its folder</source>
        <translation>파일을 제자리에 돌려놓으십시오</translation>
    </message>
</context>
<context>
    <name>project.put_into_bin_first</name>
    <message>
        <source>move it to the bin first</source>
        <translation>먼저 휴지통에 넣으십시오</translation>
    </message>
</context>
<context>
    <name>project.put_original_back</name>
    <message>
        <source>move the original file back to its folder</source>
        <translation>원래 파일을 제자리에 되돌려 놓으십시오</translation>
    </message>
</context>
<context>
    <name>project.range_changed</name>
    <message>
        <source>the trial&apos;s range has changed since robot &apos;%1&apos; was analysed</source>
        <translation>로봇 &apos;%1&apos;을(를) 분석한 뒤 시행의 구간이 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.range_sentence</name>
    <message>
        <source>Range: %1 to %2 of %3; all results are of this part.</source>
        <translation>구간: 전체 %3 중 %1~%2. 모든 결과는 이 부분에 대한 것입니다.</translation>
    </message>
</context>
<context>
    <name>project.range_without_sample</name>
    <message>
        <source>no sample is within its range</source>
        <translation>구간 안에 샘플이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.raw_times_of</name>
    <message>
        <source>raw times of recording %1</source>
        <translation>녹화 %1의 원시 시간</translation>
    </message>
</context>
<context>
    <name>project.reading</name>
    <message>
        <source>reading %1</source>
        <translation>%1 읽는 중</translation>
    </message>
</context>
<context>
    <name>project.reading_failed</name>
    <message>
        <source>reading it failed (%1)</source>
        <translation>읽지 못했습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>project.reason_is_blank</name>
    <message>
        <source>it is blank</source>
        <translation>비어 있습니다</translation>
    </message>
</context>
<context>
    <name>project.record_another</name>
    <message>
        <source>record another trial</source>
        <translation>다른 시행을 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>project.recorded_into_now</name>
    <message>
        <source>a trial is being recorded into it now</source>
        <translation>지금 시행을 녹화하는 중입니다</translation>
    </message>
</context>
<context>
    <name>project.recording</name>
    <message>
        <source>recording</source>
        <translation>녹화 중</translation>
    </message>
</context>
<context>
    <name>project.recording_at</name>
    <message>
        <source>recording &apos;%1&apos;</source>
        <translation>녹화 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_cut_off</name>
    <message>
        <source>its recording was cut off</source>
        <translation>녹화가 중간에 끊겼습니다</translation>
    </message>
</context>
<context>
    <name>project.recording_ended</name>
    <message>
        <source>its recording has ended already</source>
        <translation>녹화가 이미 끝났습니다</translation>
    </message>
</context>
<context>
    <name>project.recording_kept</name>
    <message>
        <source>its recording has ended, and is kept</source>
        <translation>녹화가 끝났고 보존되어 있습니다</translation>
    </message>
</context>
<context>
    <name>project.recording_of_view</name>
    <message>
        <source>the recording of view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;의 녹화</translation>
    </message>
</context>
<context>
    <name>project.recording_path</name>
    <message>
        <source>path of a recording</source>
        <translation>녹화의 경로</translation>
    </message>
</context>
<context>
    <name>project.recording_without_file</name>
    <message>
        <source>it has no file</source>
        <translation>파일이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.recordings_changed</name>
    <message>
        <source>the recordings or their synchronisation have changed since robot &apos;%1&apos; was analysed</source>
        <translation>로봇 &apos;%1&apos;을(를) 분석한 뒤 녹화나 그 동기화가 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.redo</name>
    <message>
        <source>redo</source>
        <translation>다시 실행</translation>
    </message>
</context>
<context>
    <name>project.redo_of</name>
    <message>
        <source>redo &apos;%1&apos;</source>
        <translation>다시 실행: &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.reference_too_far</name>
    <message>
        <source>its reference point is more than %1 from its centre</source>
        <translation>기준점이 중심에서 %1보다 멀리 있습니다</translation>
    </message>
</context>
<context>
    <name>project.reference_without_heading</name>
    <message>
        <source>a reference point off its centre needs a heading, but a robot of changing height has none</source>
        <translation>중심을 벗어난 기준점에는 방향이 필요한데, 높이가 변하는 곳에서는 방향을 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.refers_to_nothing</name>
    <message>
        <source>it refers to something missing from the project, or a value is missing</source>
        <translation>프로젝트에 없는 것을 가리키거나 값이 빠졌습니다</translation>
    </message>
</context>
<context>
    <name>project.registration_kept</name>
    <message>
        <source>the registration remains valid without it</source>
        <translation>이것이 없어도 정합은 유지됩니다</translation>
    </message>
</context>
<context>
    <name>project.registration_of_project</name>
    <message>
        <source>registration %1 of the project</source>
        <translation>프로젝트의 정합 %1</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_of</name>
    <message>
        <source>the image of registration %1 of camera &apos;%2&apos;</source>
        <translation>카메라 &apos;%2&apos;의 정합 %1의 사진</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_path</name>
    <message>
        <source>path of a registration&apos;s image</source>
        <translation>정합 사진의 경로</translation>
    </message>
</context>
<context>
    <name>project.registrations_changed</name>
    <message>
        <source>the registrations have changed since robot &apos;%1&apos; was analysed</source>
        <translation>로봇 &apos;%1&apos;을(를) 분석한 뒤 정합이 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.remove_file_first</name>
    <message>
        <source>choose another name, or remove that file first</source>
        <translation>다른 이름을 고르거나 그 파일을 먼저 지우십시오</translation>
    </message>
</context>
<context>
    <name>project.remove_guidance</name>
    <message>
        <source>remove some first</source>
        <translation>먼저 일부를 제거하세요</translation>
    </message>
</context>
<context>
    <name>project.remove_variables</name>
    <message>
        <source>remove some of its variables</source>
        <translation>변수 몇 개를 제거하십시오</translation>
    </message>
</context>
<context>
    <name>project.rest_not_read</name>
    <message>
        <source>Odograph does not read the rest; shorten it here, or in the program that wrote the file</source>
        <translation>나머지는 읽지 않습니다. 여기서 바꾸거나 파일을 만든 곳에서 바꾸십시오</translation>
    </message>
</context>
<context>
    <name>project.restore_file</name>
    <message>
        <source>restore it from a backup copy</source>
        <translation>백업 사본에서 복원하십시오</translation>
    </message>
</context>
<context>
    <name>project.restore_or_register_again</name>
    <message>
        <source>restore the project from a backup copy, or register the camera again</source>
        <translation>백업 사본에서 프로젝트를 복원하거나 카메라를 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>project.restore_or_track_again</name>
    <message>
        <source>restore the project from a backup copy, or track the trial again</source>
        <translation>백업 사본에서 프로젝트를 복원하거나 시행을 다시 추적하십시오</translation>
    </message>
</context>
<context>
    <name>project.restore_project</name>
    <message>
        <source>restore the project from a backup copy</source>
        <translation>백업 사본에서 프로젝트를 복원하십시오</translation>
    </message>
</context>
<context>
    <name>project.results_changed</name>
    <message>
        <source>the stored metrics, spikes or settings of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>로봇 &apos;%1&apos;의 지표, 이상점 또는 설정이 분석에서 나온 것과 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.robot_can_be_renamed</name>
    <message>
        <source>you can rename it</source>
        <translation>다른 이름을 줄 수 있습니다</translation>
    </message>
</context>
<context>
    <name>project.robot_drove</name>
    <message>
        <source>a trial uses it</source>
        <translation>시행에서 달린 적이 있습니다</translation>
    </message>
</context>
<context>
    <name>project.robot_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>%1보다 큽니다</translation>
    </message>
</context>
<context>
    <name>project.robot_twice</name>
    <message>
        <source>it has a robot twice</source>
        <translation>같은 로봇이 두 번 속해 있습니다</translation>
    </message>
</context>
<context>
    <name>project.row_refers_to_nothing</name>
    <message>
        <source>row %1 of &apos;%2&apos; refers to a missing row of &apos;%3&apos;</source>
        <translation>&apos;%2&apos;의 행 %1이(가) &apos;%3&apos;에 없는 행을 가리킵니다</translation>
    </message>
</context>
<context>
    <name>project.run_check</name>
    <message>
        <source>run a check of the project</source>
        <translation>프로젝트 검사를 실행하십시오</translation>
    </message>
</context>
<context>
    <name>project.say_why</name>
    <message>
        <source>write why the results can be used</source>
        <translation>결과를 왜 쓸 수 있는지 적으십시오</translation>
    </message>
</context>
<context>
    <name>project.school_ask_owner</name>
    <message>
        <source>nothing of it was taken over; ask for it to be published again</source>
        <translation>아무것도 가져오지 않았습니다. 다시 게시해 달라고 하세요</translation>
    </message>
</context>
<context>
    <name>project.school_document</name>
    <message>
        <source>document of the hub</source>
        <translation>허브의 문서</translation>
    </message>
</context>
<context>
    <name>project.school_field_wrong</name>
    <message>
        <source>what the hub has of it is damaged: field &apos;%1&apos;</source>
        <translation>허브에 있는 내용이 손상되었습니다: 필드 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.school_names_taken</name>
    <message>
        <source>every name for it is taken here</source>
        <translation>쓸 수 있는 이름이 모두 사용 중입니다</translation>
    </message>
</context>
<context>
    <name>project.school_not_readable</name>
    <message>
        <source>what the hub has of it cannot be read</source>
        <translation>허브에 있는 내용을 읽을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.school_publish_again</name>
    <message>
        <source>publish again</source>
        <translation>다시 게시하세요</translation>
    </message>
</context>
<context>
    <name>project.school_recordings</name>
    <message>
        <source>recordings of a trial from the hub</source>
        <translation>허브에서 온 시행의 녹화</translation>
    </message>
</context>
<context>
    <name>project.school_recordings_wrong</name>
    <message>
        <source>their description is damaged: field &apos;%1&apos;</source>
        <translation>설명이 손상되었습니다: 필드 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.school_rename_yours</name>
    <message>
        <source>rename the trials of that name in this project</source>
        <translation>이 프로젝트에서 그 이름의 시행 이름을 바꾸세요</translation>
    </message>
</context>
<context>
    <name>project.school_row_gone</name>
    <message>
        <source>it is no longer in the project</source>
        <translation>프로젝트에 더 이상 없습니다</translation>
    </message>
</context>
<context>
    <name>project.search_area</name>
    <message>
        <source>search area</source>
        <translation>탐색 영역</translation>
    </message>
</context>
<context>
    <name>project.series_differ</name>
    <message>
        <source>its series differ in length</source>
        <translation>데이터 열의 길이가 서로 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.series_missing</name>
    <message>
        <source>its series are missing</source>
        <translation>데이터 열이 없습니다</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_kind</name>
    <message>
        <source>its stored series is not of the expected kind</source>
        <translation>저장된 데이터 열의 종류가 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_length</name>
    <message>
        <source>its stored series announces %1 rows but holds %2 bytes</source>
        <translation>저장된 데이터 열이 %1행이라고 하지만 %2바이트입니다</translation>
    </message>
</context>
<context>
    <name>project.size_not_above_0</name>
    <message>
        <source>its size is not above 0</source>
        <translation>크기가 0보다 크지 않습니다</translation>
    </message>
</context>
<context>
    <name>project.spike_without_sample</name>
    <message>
        <source>a spike refers to a missing sample</source>
        <translation>이상점이 없는 샘플을 가리킵니다</translation>
    </message>
</context>
<context>
    <name>project.split_recording</name>
    <message>
        <source>split the recording into shorter ones</source>
        <translation>녹화를 더 짧게 나누십시오</translation>
    </message>
</context>
<context>
    <name>project.strays_unknown</name>
    <message>
        <source>cannot determine which files belong to no trial</source>
        <translation>어느 파일이 시행에 속하지 않는지 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_differs</name>
    <message>
        <source>its stored synchronisation differs from that of its second view</source>
        <translation>저장된 동기화가 둘째 뷰의 동기화와 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_of_one_view</name>
    <message>
        <source>a synchronisation is stored, but it has no second view</source>
        <translation>동기화가 저장되어 있는데 둘째 뷰가 없습니다</translation>
    </message>
</context>
<context>
    <name>project.take_later_back</name>
    <message>
        <source>undo the later change first, or leave this one</source>
        <translation>먼저 나중 변경을 되돌리거나 그대로 두십시오</translation>
    </message>
</context>
<context>
    <name>project.task_changed</name>
    <message>
        <source>the task has changed since robot &apos;%1&apos; was analysed</source>
        <translation>로봇 &apos;%1&apos;을(를) 분석한 뒤 과제가 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>project.task_has_trial</name>
    <message>
        <source>a trial uses it</source>
        <translation>시행 하나가 씁니다</translation>
    </message>
</context>
<context>
    <name>project.task_has_trials</name>
    <message>
        <source>%1 trials use it</source>
        <translation>시행 %1개가 씁니다</translation>
    </message>
</context>
<context>
    <name>project.team_has_trial</name>
    <message>
        <source>it has a trial</source>
        <translation>시행 하나가 이 팀의 것입니다</translation>
    </message>
</context>
<context>
    <name>project.team_has_trials</name>
    <message>
        <source>it has %1 trials</source>
        <translation>시행 %1개가 이 팀의 것입니다</translation>
    </message>
</context>
<context>
    <name>project.texts_too_long</name>
    <message>
        <source>%1: texts of more than %2 characters: %3</source>
        <translation>%1: %2자를 넘는 글: %3</translation>
    </message>
</context>
<context>
    <name>project.times_do_not_rise</name>
    <message>
        <source>its times do not increase</source>
        <translation>시간이 증가하지 않습니다</translation>
    </message>
</context>
<context>
    <name>project.title</name>
    <message>
        <source>title of the project</source>
        <translation>프로젝트의 제목</translation>
    </message>
</context>
<context>
    <name>project.too_many_markers</name>
    <message>
        <source>it has more than %1 markers</source>
        <translation>마커가 %1개를 넘습니다</translation>
    </message>
</context>
<context>
    <name>project.too_many_members</name>
    <message>
        <source>it has more than %1 members</source>
        <translation>팀원이 %1명을 넘습니다</translation>
    </message>
</context>
<context>
    <name>project.too_many_samples</name>
    <message>
        <source>it has more than %1 samples</source>
        <translation>샘플이 %1개를 넘습니다</translation>
    </message>
</context>
<context>
    <name>project.too_many_variables</name>
    <message>
        <source>a trial has %1 variables at most</source>
        <translation>시행 하나의 변수는 최대 %1개입니다</translation>
    </message>
</context>
<context>
    <name>project.track</name>
    <message>
        <source>track &apos;%1&apos;</source>
        <translation>궤적 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.track_again</name>
    <message>
        <source>track the trial again</source>
        <translation>시행을 다시 추적하십시오</translation>
    </message>
</context>
<context>
    <name>project.track_kept</name>
    <message>
        <source>the measured track remains valid without it</source>
        <translation>이것이 없어도 측정한 궤적은 유지됩니다</translation>
    </message>
</context>
<context>
    <name>project.track_reading</name>
    <message>
        <source>reading of a track</source>
        <translation>궤적의 해석</translation>
    </message>
</context>
<context>
    <name>project.trial_notes</name>
    <message>
        <source>notes of a trial</source>
        <translation>시행의 메모</translation>
    </message>
</context>
<context>
    <name>project.trial_of_project</name>
    <message>
        <source>trial %1 of the project</source>
        <translation>프로젝트의 시행 %1</translation>
    </message>
</context>
<context>
    <name>project.truth</name>
    <message>
        <source>truth of a trial</source>
        <translation>시행의 참값</translation>
    </message>
</context>
<context>
    <name>project.truth_of_trial</name>
    <message>
        <source>truth of trial %1</source>
        <translation>시행 %1의 참값</translation>
    </message>
</context>
<context>
    <name>project.try_again</name>
    <message>
        <source>try again</source>
        <translation>다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>project.try_change_again</name>
    <message>
        <source>try the whole change again</source>
        <translation>변경 전체를 다시 시도하십시오</translation>
    </message>
</context>
<context>
    <name>project.type_name_anew</name>
    <message>
        <source>type the name again</source>
        <translation>이름을 다시 입력하십시오</translation>
    </message>
</context>
<context>
    <name>project.type_text_anew</name>
    <message>
        <source>type the text again</source>
        <translation>텍스트를 다시 입력하십시오</translation>
    </message>
</context>
<context>
    <name>project.undo</name>
    <message>
        <source>undo</source>
        <translation>실행 취소</translation>
    </message>
</context>
<context>
    <name>project.undo_of</name>
    <message>
        <source>undo &apos;%1&apos;</source>
        <translation>실행 취소: &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.undo_something_first</name>
    <message>
        <source>undo something first</source>
        <translation>먼저 무언가를 되돌리십시오</translation>
    </message>
</context>
<context>
    <name>project.unknown_series_layout</name>
    <message>
        <source>its stored series has the unknown layout %1</source>
        <translation>저장된 데이터 열의 구조 %1을(를) 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.unknown_setting</name>
    <message>
        <source>its stored setting &apos;%1&apos; is unknown</source>
        <translation>저장된 설정 &apos;%1&apos;을(를) 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.use_at_most</name>
    <message>
        <source>use at most %1</source>
        <translation>최대 %1자까지 쓰십시오</translation>
    </message>
</context>
<context>
    <name>project.use_one_line</name>
    <message>
        <source>use a name of one line</source>
        <translation>한 줄 이름을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>project.value_too_large</name>
    <message>
        <source>a value is too large to store</source>
        <translation>값이 너무 커서 저장할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>project.verdict</name>
    <message>
        <source>verdict on a trial</source>
        <translation>시행에 대한 판정</translation>
    </message>
</context>
<context>
    <name>project.views_differ</name>
    <message>
        <source>views and registrations differ in number</source>
        <translation>뷰와 정합의 수가 다릅니다</translation>
    </message>
</context>
<context>
    <name>project.wait_until_ended</name>
    <message>
        <source>wait until that has ended</source>
        <translation>끝날 때까지 기다리십시오</translation>
    </message>
</context>
<context>
    <name>project.writing_failed</name>
    <message>
        <source>writing it failed (%1)</source>
        <translation>쓰지 못했습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>project.written_over</name>
    <message>
        <source>another program wrote over its file while it was open; nothing more was stored</source>
        <translation>열려 있는 동안 다른 프로그램이 파일을 덮어썼습니다. 그 뒤로는 저장되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>project.zone_cut_off</name>
    <message>
        <source>its zone &apos;%1&apos; ends within a point</source>
        <translation>구역 &apos;%1&apos;이(가) 점의 중간에서 끝납니다</translation>
    </message>
</context>
<context>
    <name>school.address</name>
    <message>
        <source>address of the school hub</source>
        <translation>학교 허브의 주소</translation>
    </message>
</context>
<context>
    <name>school.address_characters</name>
    <message>
        <source>it holds a quotation mark, a backslash, a semicolon or a control character</source>
        <translation>따옴표, 역슬래시, 세미콜론 또는 제어 문자가 들어 있습니다</translation>
    </message>
</context>
<context>
    <name>school.address_form</name>
    <message>
        <source>give it as postgresql://user@host/database</source>
        <translation>postgresql://user@host/database 형식으로 입력하세요</translation>
    </message>
</context>
<context>
    <name>school.ask_administrator</name>
    <message>
        <source>ask the hub&apos;s administrator for the role that may</source>
        <translation>허브 관리자에게 필요한 역할을 요청하세요</translation>
    </message>
</context>
<context>
    <name>school.check_connection</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network; what is recorded meanwhile is sent later</source>
        <translation>주소, ~/.pgpass의 로그인, 네트워크를 확인하세요. 그동안 기록한 내용은 나중에 보냅니다</translation>
    </message>
</context>
<context>
    <name>school.check_server</name>
    <message>
        <source>have the hub&apos;s administrator look at the server</source>
        <translation>허브 관리자에게 서버를 확인해 달라고 하세요</translation>
    </message>
</context>
<context>
    <name>school.connect_first</name>
    <message>
        <source>connect it with odograph school connect P.odo postgresql://user@host/database</source>
        <translation>먼저 연결하세요</translation>
    </message>
</context>
<context>
    <name>school.connect_with_media</name>
    <message>
        <source>connect it again with --media FOLDER</source>
        <translation>미디어 폴더를 지정해 다시 연결하세요</translation>
    </message>
</context>
<context>
    <name>school.grant_role</name>
    <message>
        <source>have the hub&apos;s administrator grant it one: GRANT bench TO login</source>
        <translation>허브 관리자에게 역할을 달라고 하세요: GRANT bench TO login</translation>
    </message>
</context>
<context>
    <name>school.hub_subject</name>
    <message>
        <source>school hub &apos;%1&apos;</source>
        <translation>학교 허브 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>school.install_driver</name>
    <message>
        <source>install the package libqt6sql6-psql</source>
        <translation>libqt6sql6-psql 패키지를 설치하세요</translation>
    </message>
</context>
<context>
    <name>school.media</name>
    <message>
        <source>media folder of the school</source>
        <translation>학교의 미디어 폴더</translation>
    </message>
</context>
<context>
    <name>school.never_answers</name>
    <message>
        <source>the server takes connections and answers none</source>
        <translation>서버가 연결은 받지만 응답하지 않습니다</translation>
    </message>
</context>
<context>
    <name>school.newer_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph knows up to %2</source>
        <translation>스키마 버전이 %1이고 이 Odograph는 %2까지 압니다</translation>
    </message>
</context>
<context>
    <name>school.no_database</name>
    <message>
        <source>it names no database</source>
        <translation>데이터베이스 이름이 없습니다</translation>
    </message>
</context>
<context>
    <name>school.no_driver</name>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>이 컴퓨터에 PostgreSQL 드라이버가 없습니다</translation>
    </message>
</context>
<context>
    <name>school.no_hub</name>
    <message>
        <source>the database has no hub</source>
        <translation>데이터베이스에 허브가 없습니다</translation>
    </message>
</context>
<context>
    <name>school.no_media</name>
    <message>
        <source>the project is connected without one</source>
        <translation>프로젝트가 폴더 없이 연결되어 있습니다</translation>
    </message>
</context>
<context>
    <name>school.no_role</name>
    <message>
        <source>the login has none of the roles teacher, bench and viewer</source>
        <translation>이 로그인에 teacher, bench, viewer 역할이 없습니다</translation>
    </message>
</context>
<context>
    <name>school.no_url</name>
    <message>
        <source>it is no address of a PostgreSQL database</source>
        <translation>PostgreSQL 데이터베이스의 주소가 아닙니다</translation>
    </message>
</context>
<context>
    <name>school.not_allowed</name>
    <message>
        <source>the login may not do that (%1)</source>
        <translation>이 로그인에는 그 권한이 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>school.not_connected</name>
    <message>
        <source>the project is not connected to one</source>
        <translation>프로젝트가 연결되어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>school.older_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph needs %2</source>
        <translation>스키마 버전이 %1이고 이 Odograph에는 %2가 필요합니다</translation>
    </message>
</context>
<context>
    <name>school.option_unknown</name>
    <message>
        <source>its option &apos;%1&apos; is not known</source>
        <translation>옵션 &apos;%1&apos;을(를) 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>school.options_known</name>
    <message>
        <source>use sslmode, sslrootcert, host or port</source>
        <translation>sslmode, sslrootcert, host, port를 쓰세요</translation>
    </message>
</context>
<context>
    <name>school.password_elsewhere</name>
    <message>
        <source>leave it out, and put the password into ~/.pgpass or PGPASSWORD</source>
        <translation>빼고, 비밀번호는 ~/.pgpass 또는 PGPASSWORD에 넣으세요</translation>
    </message>
</context>
<context>
    <name>school.password_in_url</name>
    <message>
        <source>it holds a password, which others could read</source>
        <translation>다른 사람이 읽을 수 있는 비밀번호가 들어 있습니다</translation>
    </message>
</context>
<context>
    <name>school.password_place</name>
    <message>
        <source>put the correct one into ~/.pgpass or PGPASSWORD</source>
        <translation>여기에 입력하거나 ~/.pgpass에 넣으세요</translation>
    </message>
</context>
<context>
    <name>school.password_refused</name>
    <message>
        <source>the server does not accept this login with this password</source>
        <translation>서버가 이 비밀번호로는 이 로그인을 받아들이지 않습니다</translation>
    </message>
</context>
<context>
    <name>school.password_wanted</name>
    <message>
        <source>the server asks for the password of the login</source>
        <translation>서버가 로그인 비밀번호를 요구합니다</translation>
    </message>
</context>
<context>
    <name>school.publish_later</name>
    <message>
        <source>try again later; what was not sent yet is kept</source>
        <translation>나중에 다시 시도하세요. 아직 보내지 않은 내용은 보관됩니다</translation>
    </message>
</context>
<context>
    <name>school.publishing</name>
    <message>
        <source>publishing</source>
        <translation>게시하는 중</translation>
    </message>
</context>
<context>
    <name>school.receiving</name>
    <message>
        <source>receiving %1</source>
        <translation>%1 받는 중</translation>
    </message>
</context>
<context>
    <name>school.recording_changed</name>
    <message>
        <source>the recording &apos;%1&apos; is missing or has changed, and was left out</source>
        <translation>녹화 &apos;%1&apos;이(가) 없거나 바뀌어서 제외했습니다</translation>
    </message>
</context>
<context>
    <name>school.recording_elsewhere</name>
    <message>
        <source>trial &apos;%1&apos;, view &apos;%2&apos;: its recording is not in the media folder; bench &apos;%3&apos; has it as &apos;%4&apos;</source>
        <translation>시행 &apos;%1&apos;, 뷰 &apos;%2&apos;: 녹화가 미디어 폴더에 없습니다. 측정대 &apos;%3&apos;에 &apos;%4&apos;(으)로 있습니다</translation>
    </message>
</context>
<context>
    <name>school.report_to_administrator</name>
    <message>
        <source>show this to the hub&apos;s administrator</source>
        <translation>허브 관리자에게 보여 주세요</translation>
    </message>
</context>
<context>
    <name>school.run_init</name>
    <message>
        <source>have its administrator run odograph school init</source>
        <translation>관리자에게 허브를 만들어 달라고 하세요</translation>
    </message>
</context>
<context>
    <name>school.server_away</name>
    <message>
        <source>the server is away; trying again</source>
        <translation>서버에 연결할 수 없어 다시 시도하는 중</translation>
    </message>
</context>
<context>
    <name>school.silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>서버가 응답하지 않습니다</translation>
    </message>
</context>
<context>
    <name>school.sslmode_choices</name>
    <message>
        <source>use disable, allow, prefer, require, verify-ca or verify-full</source>
        <translation>disable, allow, prefer, require, verify-ca, verify-full 중에서 쓰세요</translation>
    </message>
</context>
<context>
    <name>school.sslmode_unknown</name>
    <message>
        <source>sslmode &apos;%1&apos; is not known</source>
        <translation>sslmode &apos;%1&apos;을(를) 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>school.subject</name>
    <message>
        <source>school hub</source>
        <translation>학교 허브</translation>
    </message>
</context>
<context>
    <name>school.update_program</name>
    <message>
        <source>update Odograph</source>
        <translation>Odograph를 업데이트하세요</translation>
    </message>
</context>
<context>
    <name>school.waiting</name>
    <message>
        <source>waiting for the server</source>
        <translation>서버를 기다리는 중</translation>
    </message>
</context>
<context>
    <name>school.went_away</name>
    <message>
        <source>the connection was lost (%1)</source>
        <translation>연결이 끊어졌습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>simulation.cannot_render</name>
    <message>
        <source>cannot render %1</source>
        <translation>%1을(를) 렌더링할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>simulation.lengthen_scene</name>
    <message>
        <source>give the scene a longer duration or start the camera earlier</source>
        <translation>장면을 길게 하거나 카메라를 더 일찍 시작하십시오</translation>
    </message>
</context>
<context>
    <name>simulation.no_frame</name>
    <message>
        <source>camera %1 takes no frame during the scene</source>
        <translation>장면이 이어지는 동안 카메라 %1이(가) 프레임을 찍지 않습니다</translation>
    </message>
</context>
<context>
    <name>simulation.rendering</name>
    <message>
        <source>rendering %1</source>
        <translation>%1 렌더링</translation>
    </message>
</context>
<context>
    <name>sync.cost</name>
    <message>
        <source>View %1: its times are known to ±%2, which is ±%3 at the top speed of %4</source>
        <translation>뷰 %1: 시간이 ±%2까지 알려져 있으며, 최고 속력 %4에서 ±%3에 해당합니다</translation>
    </message>
</context>
<context>
    <name>sync.cost_of_error</name>
    <message>
        <source>View %1: nothing has measured its time offset; an error of %2 would shift the robot by %3 at the top speed of %4</source>
        <translation>뷰 %1: 시간차가 측정되지 않았습니다; 오차 %2는 최고 속력 %4에서 로봇을 %3 옮깁니다</translation>
    </message>
</context>
<context>
    <name>sync.drift</name>
    <message>
        <source>Its clock runs %1 ±%2 faster than the first view&apos;s</source>
        <translation>이 뷰의 클록은 첫 뷰보다 %1 ±%2 빠릅니다</translation>
    </message>
</context>
<context>
    <name>sync.known_to</name>
    <message>
        <source>View %1: its times are known to ±%2</source>
        <translation>뷰 %1: 시간이 ±%2까지 알려져 있습니다</translation>
    </message>
</context>
<context>
    <name>sync.no_residual</name>
    <message>
        <source>The views&apos; disagreement does not grow with the speed: a remaining time error is at most %1, or %2 at the top speed</source>
        <translation>뷰 사이의 불일치가 속력에 따라 커지지 않습니다: 남은 시간 오차는 많아야 %1, 최고 속력에서 %2입니다</translation>
    </message>
</context>
<context>
    <name>sync.not_measured</name>
    <message>
        <source>View %1: nothing has measured its time offset</source>
        <translation>뷰 %1: 시간차가 측정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>sync.pairing</name>
    <message>
        <source>Its frames are %1 on average and at most %2 from the first view&apos;s; positions are interpolated to the same times</source>
        <translation>이 뷰의 프레임은 첫 뷰의 프레임과 평균 %1, 최대 %2 떨어져 있습니다; 위치는 같은 시각으로 보간됩니다</translation>
    </message>
</context>
<context>
    <name>sync.residual</name>
    <message>
        <source>The views disagree the more the faster the robot is, as a time error of %1 ±%2 would make them: %3 at the top speed</source>
        <translation>로봇이 빠를수록 뷰 사이의 불일치가 커지며, 이는 시간 오차 %1 ±%2에 해당합니다: 최고 속력에서 %3</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_flash</name>
    <message>
        <source>%1 by the flash of light</source>
        <translation>빛의 번쩍임으로 %1</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_motion</name>
    <message>
        <source>%1 by the motion</source>
        <translation>움직임으로 %1</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_sound</name>
    <message>
        <source>%1 by the sound</source>
        <translation>소리로 %1</translation>
    </message>
</context>
<context>
    <name>synchronisation.clap_twice</name>
    <message>
        <source>clap twice near the middle of the floor while both cameras record, or give --sync SECONDS</source>
        <translation>두 카메라가 녹화하는 동안 바닥 가운데 근처에서 박수를 두 번 치거나 오프셋을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>synchronisation.clocks_ambiguous</name>
    <message>
        <source>several time offsets, pauses or missing frames explain the views&apos; tracks about equally well</source>
        <translation>여러 시간 오프셋, 일시 정지 또는 누락된 프레임이 뷰의 궤적을 거의 똑같이 잘 설명합니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.different_runs</name>
    <message>
        <source>the views&apos; tracks match at no time offset, frame rate or pause tried, so the videos may be of different runs</source>
        <translation>시도한 어떤 시간 차이, 프레임 속도, 일시 정지에서도 뷰들의 경로가 맞지 않습니다. 비디오가 서로 다른 주행일 수 있습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_disagrees</name>
    <message>
        <source>the motion gives a time offset of %1, the flash of light gives %2; the motion was used</source>
        <translation>움직임의 오프셋 %1을(를) 택했고, 빛의 번쩍임은 %2입니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_lights</name>
    <message>
        <source>flash the room lights once while both cameras record, or give --sync SECONDS</source>
        <translation>두 카메라가 녹화하는 동안 실내 조명을 한 번 깜박이거나 오프셋을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_or_clap</name>
    <message>
        <source>flash the room lights or clap twice while both cameras record, or give --sync SECONDS</source>
        <translation>두 카메라가 녹화하는 동안 실내 조명을 깜박이거나 박수를 두 번 치거나, 오프셋을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>synchronisation.flashes_fit_alike</name>
    <message>
        <source>the flashes of light fit equally well at time offsets of %1 and %2</source>
        <translation>빛의 깜박임이 오프셋 %1와 %2에서 똑같이 맞습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_flash</name>
    <message>
        <source>measured by a flash of light to only ±%1, because %2</source>
        <translation>빛의 깜박임에서 구해 %1까지만 맞습니다. 이유는 %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_sound</name>
    <message>
        <source>measured by the sound to only ±%1, because %2</source>
        <translation>소리에서 구해 ±%1까지만 맞습니다. 이유는 %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.light_flickers</name>
    <message>
        <source>the light flickers</source>
        <translation>빛이 떨립니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_repeats</name>
    <message>
        <source>the motion repeats itself</source>
        <translation>움직임이 반복됩니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_too_even</name>
    <message>
        <source>the robot turned and changed its speed too little to give the time offset</source>
        <translation>로봇이 방향과 속도를 너무 적게 바꾸어 시간 차이를 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.neither_tells</name>
    <message>
        <source>%1, and %2</source>
        <translation>%1. 또한 %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_flash</name>
    <message>
        <source>neither view shows a flash of light</source>
        <translation>어느 뷰에도 빛의 깜박임이 보이지 않습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_loud_sound</name>
    <message>
        <source>no clap, knock or whistle is heard clearly in both clips</source>
        <translation>두 클립의 소리에서 두드러지는 박수, 두드림, 휘파람이 없습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.none_tells</name>
    <message>
        <source>%1, %2, and %3</source>
        <translation>%1. %2. 또한 %3</translation>
    </message>
</context>
<context>
    <name>synchronisation.of_clips</name>
    <message>
        <source>synchronisation of the clips</source>
        <translation>동영상의 동기화</translation>
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
        <translation>오프셋 %1와 %2가 똑같이 맞습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.one_flash</name>
    <message>
        <source>only one of the views shows a flash of light</source>
        <translation>한 뷰에만 빛의 깜박임이 보입니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_flashes</name>
    <message>
        <source>the flashes of light in the views do not match</source>
        <translation>뷰들의 빛 깜박임이 서로 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_sounds</name>
    <message>
        <source>the loud sounds of the clips do not match</source>
        <translation>클립들의 큰 소리가 서로 맞지 않습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_ran_straight</name>
    <message>
        <source>the robot ran straight at constant speed, so every time offset fits</source>
        <translation>로봇이 일정한 속도로 똑바로 달려서 모든 시간 차이가 맞습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_rested</name>
    <message>
        <source>the robot stood still, so every time offset fits</source>
        <translation>로봇이 멈춰 있어서 모든 시간 차이가 맞습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.robots_disagree</name>
    <message>
        <source>robot %1 gives a time offset of %2, robot %3 gives %4; the second was used</source>
        <translation>로봇 %1의 오프셋은 %2, 로봇 %3은(는) %4이며 후자를 택했습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_seen</name>
    <message>
        <source>one view saw the robot in fewer than %1 frames</source>
        <translation>한 뷰에서 로봇이 보인 영상이 %1장보다 적습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_together</name>
    <message>
        <source>the views rarely saw the robot at the same time</source>
        <translation>뷰들이 동시에 로봇을 본 적이 거의 없습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.short_overlap</name>
    <message>
        <source>the views seem to have only %1 in common, which is too short to be sure</source>
        <translation>뷰들의 공통 시간이 %1뿐인 듯하여 확신하기에는 너무 짧습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.sound_beats</name>
    <message>
        <source>the sound is full of beats that are alike, as in music</source>
        <translation>소리에 음악처럼 비슷한 박자가 가득합니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.sounds_fit_alike</name>
    <message>
        <source>the sounds of the clips fit equally well at time offsets of %1 and %2</source>
        <translation>클립들의 소리가 오프셋 %1와 %2에서 똑같이 맞습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.views_distorted</name>
    <message>
        <source>the views show the same run, but with another size or direction: a camera has moved since its registration, or the videos are exchanged</source>
        <translation>뷰들이 같은 주행을 보여 주지만 크기나 방향이 다릅니다. 등록 후 카메라가 움직였거나 비디오가 서로 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>synchronisation.ways_disagree</name>
    <message>
        <source>the time offsets found disagree: %1; the first was used</source>
        <translation>찾은 오프셋이 서로 다릅니다: %1. 첫째 값을 택했습니다</translation>
    </message>
</context>
<context>
    <name>tracking.add_robot</name>
    <message>
        <source>add a robot with its colour first</source>
        <translation>먼저 로봇과 그 색을 추가하십시오</translation>
    </message>
</context>
<context>
    <name>tracking.add_without_colour</name>
    <message>
        <source>add the robot without a colour; background subtraction then finds it</source>
        <translation>색 없이 로봇을 추가하십시오. 그러면 바닥과 다른 점으로 찾습니다</translation>
    </message>
</context>
<context>
    <name>tracking.box_is_grey</name>
    <message>
        <source>the robot in it is grey, black or white</source>
        <translation>주변 바닥과 다른 부분이 회색, 검정 또는 흰색입니다</translation>
    </message>
</context>
<context>
    <name>tracking.box_leaves_nothing</name>
    <message>
        <source>the box leaves no floor around it to compare with</source>
        <translation>비교할 바닥이 상자 밖에 남지 않습니다</translation>
    </message>
</context>
<context>
    <name>tracking.box_too_small</name>
    <message>
        <source>the box is too small or outside the image</source>
        <translation>상자가 너무 작거나 영상 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>tracking.box_without_colour</name>
    <message>
        <source>it contains no colour that differs from the floor around it</source>
        <translation>주변 바닥과 다른 색이 없습니다</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track</name>
    <message>
        <source>Cannot track</source>
        <translation>추적할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track_robot</name>
    <message>
        <source>Cannot track robot %1</source>
        <translation>로봇 %1을(를) 추적할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>tracking.colour_in_box</name>
    <message>
        <source>colour in the box</source>
        <translation>상자 안의 색</translation>
    </message>
</context>
<context>
    <name>tracking.colour_is_grey</name>
    <message>
        <source>its colour %1 is grey, and tracking by colour needs a hue that differs from the floor</source>
        <translation>색 %1이(가) 회색인데, 로봇은 색상으로만 바닥과 구별됩니다</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_closely</name>
    <message>
        <source>draw it closely round the robot</source>
        <translation>로봇에 바짝 붙여 그리십시오</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_larger</name>
    <message>
        <source>draw it round the robot, at least 8 pixels wide and high</source>
        <translation>로봇 둘레에 가로세로 8픽셀 이상으로 그리십시오</translation>
    </message>
</context>
<context>
    <name>tracking.no_robot_given</name>
    <message>
        <source>no robot is given</source>
        <translation>로봇이 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>tracking.put_plate_on_it</name>
    <message>
        <source>draw it closely round the robot, or put a plate of another colour on it</source>
        <translation>로봇에 바짝 붙여 그리거나 다른 색 판을 얹으십시오</translation>
    </message>
</context>
<context>
    <name>tracking.tell_no_colour</name>
    <message>
        <source>set no colour; background subtraction then finds it</source>
        <translation>색을 지정하지 마십시오. 그러면 바닥과 다른 점으로 찾습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.add_view</name>
    <message>
        <source>add a second view, or set one height for the robot</source>
        <translation>두 번째 뷰를 추가하거나 로봇의 높이를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.analysing_position</name>
    <message>
        <source>analysing position %1</source>
        <translation>위치 %1 분석 중</translation>
    </message>
</context>
<context>
    <name>trajectory.camera_not_registered</name>
    <message>
        <source>camera %1 is not registered to the floor</source>
        <translation>카메라 %1이(가) 바닥에 정합되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.cameras_not_registered</name>
    <message>
        <source>cameras %1 are not registered to the floor</source>
        <translation>카메라 %1이(가) 바닥에 정합되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.centre_reference</name>
    <message>
        <source>set its reference point to 0,0 and track again</source>
        <translation>기준점을 0,0으로 하고 다시 추적하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.check_robot_and_light</name>
    <message>
        <source>check that the robot moves in the video, that its colour, if set, matches the video, and that the light is sufficient</source>
        <translation>로봇이 영상에서 움직이는지, 지정한 색이 영상에서의 색과 같은지, 조명이 충분한지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_track</name>
    <message>
        <source>choose a track with more positions</source>
        <translation>위치가 더 많은 궤적을 고르십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_video</name>
    <message>
        <source>choose a longer video, or check the robot&apos;s colour and the light</source>
        <translation>더 긴 동영상을 고르거나 로봇의 색과 조명을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_edge</name>
    <message>
        <source>cut by the frame&apos;s edge</source>
        <translation>영상 가장자리에서 잘림</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_frames_edge</name>
    <message>
        <source>cut by the frame&apos;s edge in view %1</source>
        <translation>뷰 %1에서 영상 가장자리에서 잘림</translation>
    </message>
</context>
<context>
    <name>trajectory.faster_than_limit</name>
    <message>
        <source>speed above the limit</source>
        <translation>한계보다 빠름</translation>
    </message>
</context>
<context>
    <name>trajectory.figures_of_seen</name>
    <message>
        <source>the metrics cover only the measured part</source>
        <translation>지표는 보인 부분에 대한 것입니다</translation>
    </message>
</context>
<context>
    <name>trajectory.frames_that_tell</name>
    <message>
        <source>only %2 of %1 frames give a usable position</source>
        <translation>프레임 %1개 중 %2개만 쓸 수 있는 위치를 줍니다</translation>
    </message>
</context>
<context>
    <name>trajectory.harder_than_limit</name>
    <message>
        <source>acceleration above the limit</source>
        <translation>가속도 한계 초과</translation>
    </message>
</context>
<context>
    <name>trajectory.heading_unknown</name>
    <message>
        <source>its reference point is not the centre of its footprint, but its outlines do not show its heading</source>
        <translation>기준점이 중심을 벗어나 있지만 윤곽으로는 방향을 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.hidden_behind</name>
    <message>
        <source>hidden behind %1 in view %2</source>
        <translation>뷰 %2에서 %1에 가려짐</translation>
    </message>
</context>
<context>
    <name>trajectory.import_exchanged</name>
    <message>
        <source>import them again, each for its own camera</source>
        <translation>각각 자기 카메라로 다시 가져오십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.import_video</name>
    <message>
        <source>import at least one video for it</source>
        <translation>동영상을 적어도 하나 가져오십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.jump</name>
    <message>
        <source>jump</source>
        <translation>도약</translation>
    </message>
</context>
<context>
    <name>trajectory.jump_of</name>
    <message>
        <source>jump of %1</source>
        <translation>%1 도약</translation>
    </message>
</context>
<context>
    <name>trajectory.look_and_register</name>
    <message>
        <source>check the outlines, and register the cameras again</source>
        <translation>윤곽선을 확인하고 카메라를 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.move_camera</name>
    <message>
        <source>move or add a camera to cover the whole task</source>
        <translation>과제 전체가 보이도록 카메라를 옮기거나 추가하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.no_such_smoother</name>
    <message>
        <source>no smoother has this name</source>
        <translation>그런 이름이 없습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view</name>
    <message>
        <source>the trial has no view</source>
        <translation>시행에 뷰가 없습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view_trusted</name>
    <message>
        <source>none could be trusted</source>
        <translation>신뢰할 수 있는 뷰 없음</translation>
    </message>
</context>
<context>
    <name>trajectory.not_enough_data</name>
    <message>
        <source>not enough data</source>
        <translation>데이터 부족</translation>
    </message>
</context>
<context>
    <name>trajectory.not_visible</name>
    <message>
        <source>not visible in view %1</source>
        <translation>뷰 %1에서 보이지 않음</translation>
    </message>
</context>
<context>
    <name>trajectory.occlusion_span</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1(%2~%3)</translation>
    </message>
</context>
<context>
    <name>trajectory.one_outline</name>
    <message>
        <source>outline merged with %1 in view %2</source>
        <translation>뷰 %2에서 %1과(와) 윤곽이 하나로 합쳐짐</translation>
    </message>
</context>
<context>
    <name>trajectory.only_unregistered</name>
    <message>
        <source>only cameras that are not registered to the floor saw the robot</source>
        <translation>바닥에 정합되지 않은 카메라만 로봇을 보았습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_larger</name>
    <message>
        <source>outline larger than usual in view %1</source>
        <translation>뷰 %1에서 윤곽이 평소보다 큼</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_smaller</name>
    <message>
        <source>outline smaller than usual in view %1</source>
        <translation>뷰 %1에서 윤곽이 평소보다 작음</translation>
    </message>
</context>
<context>
    <name>trajectory.partly_hidden_behind</name>
    <message>
        <source>partly hidden behind %1 in view %2</source>
        <translation>뷰 %2에서 %1에 일부 가려짐</translation>
    </message>
</context>
<context>
    <name>trajectory.path_not_measured</name>
    <message>
        <source>the robot&apos;s path cannot be measured</source>
        <translation>로봇의 경로를 측정할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.register_one</name>
    <message>
        <source>run odograph register for at least one of them</source>
        <translation>그중 적어도 하나를 정합하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.register_them</name>
    <message>
        <source>run odograph register for them</source>
        <translation>그것들을 정합하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.robot_not_found</name>
    <message>
        <source>the robot was not found in any frame of %1</source>
        <translation>%1의 어느 영상에서도 로봇을 찾지 못했습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.seldom_together</name>
    <message>
        <source>its height is set to be triangulated, but two registered views rarely saw it at the same time</source>
        <translation>높이를 삼각 측량해야 하는데 정합된 두 뷰가 함께 본 적이 거의 없습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.smoother</name>
    <message>
        <source>smoother %1</source>
        <translation>평활기 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.spike_by_hand</name>
    <message>
        <source>marked as a spike by hand</source>
        <translation>수동으로 이상점 지정됨</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_both</name>
    <message>
        <source>spike in position and speed</source>
        <translation>위치와 속력이 튐</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_position</name>
    <message>
        <source>spike in position</source>
        <translation>위치가 튐</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_speed</name>
    <message>
        <source>spike in speed</source>
        <translation>속력이 튐</translation>
    </message>
</context>
<context>
    <name>trajectory.track_first</name>
    <message>
        <source>track the trial&apos;s videos first</source>
        <translation>먼저 시행의 동영상을 추적하십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.tracker_unsure</name>
    <message>
        <source>the tracker was not sure (score %1)</source>
        <translation>추적기가 확신하지 못함 (점수 %1)</translation>
    </message>
</context>
<context>
    <name>trajectory.unmeasured_between</name>
    <message>
        <source>nothing was measured from %1 to %2</source>
        <translation>%1부터 %2까지 아무것도 측정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_after</name>
    <message>
        <source>no view sees it after %1 (it was at X %2, Y %3)</source>
        <translation>%1 이후 어느 뷰에도 보이지 않음 (X %2, Y %3에 있었음)</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_between</name>
    <message>
        <source>no view sees it from %1 to %2 (it was at X %3, Y %4)</source>
        <translation>%1부터 %2까지 어느 뷰에도 보이지 않음 (X %3, Y %4에 있었음)</translation>
    </message>
</context>
<context>
    <name>trajectory.use_smoother</name>
    <message>
        <source>use rts, savgol, tracker or none</source>
        <translation>rts, savgol, tracker, none 중에서 쓰십시오</translation>
    </message>
</context>
<context>
    <name>trajectory.view_left_out</name>
    <message>
        <source>one left out</source>
        <translation>한 뷰 제외됨</translation>
    </message>
</context>
<context>
    <name>trajectory.view_without_frame</name>
    <message>
        <source>view %1 has no frame</source>
        <translation>뷰 %1에 프레임이 없습니다</translation>
    </message>
</context>
<context>
    <name>trajectory.views_apart</name>
    <message>
        <source>the views&apos; floor positions differ by %1</source>
        <translation>뷰들이 주는 위치가 %1 차이 납니다</translation>
    </message>
</context>
<context>
    <name>trajectory.views_disagree</name>
    <message>
        <source>views disagree by %1</source>
        <translation>뷰 간 불일치 %1</translation>
    </message>
</context>
<context>
    <name>trajectory.views_exchanged</name>
    <message>
        <source>the videos of %1 and %2 seem to be exchanged: exchanged, they agree</source>
        <translation>%1와(과) %2의 영상이 서로 바뀐 것 같습니다. 바꾸면 일치합니다</translation>
    </message>
</context>
<context>
    <name>trajectory.why_views_apart</name>
    <message>
        <source>a camera has moved since it was registered, the videos belong to other cameras, or one view follows something else</source>
        <translation>정합 후 카메라가 움직였거나, 동영상이 다른 카메라의 것이거나, 한 뷰가 다른 것을 따라갑니다</translation>
    </message>
</context>
<context>
    <name>ui.add_camera</name>
    <message>
        <source>add camera %1</source>
        <translation>카메라 %1 추가</translation>
    </message>
</context>
<context>
    <name>ui.add_class</name>
    <message>
        <source>add class %1</source>
        <translation>학급 %1 추가</translation>
    </message>
</context>
<context>
    <name>ui.add_layout</name>
    <message>
        <source>add layout %1</source>
        <translation>배치 %1 추가</translation>
    </message>
</context>
<context>
    <name>ui.add_robot</name>
    <message>
        <source>add robot %1</source>
        <translation>로봇 %1 추가</translation>
    </message>
</context>
<context>
    <name>ui.add_task</name>
    <message>
        <source>add task %1</source>
        <translation>과제 %1 추가</translation>
    </message>
</context>
<context>
    <name>ui.add_team</name>
    <message>
        <source>add team %1</source>
        <translation>팀 %1 추가</translation>
    </message>
</context>
<context>
    <name>ui.adding_strays</name>
    <message>
        <source>Adding stray videos as trials</source>
        <translation>소속 없는 동영상을 시행으로 추가하는 중</translation>
    </message>
</context>
<context>
    <name>ui.address_not_here</name>
    <message>
        <source>it is no address of this computer</source>
        <translation>이 컴퓨터의 주소가 아닙니다</translation>
    </message>
</context>
<context>
    <name>ui.and_more</name>
    <message>
        <source>and %1 more</source>
        <translation>외 %1개</translation>
    </message>
</context>
<context>
    <name>ui.annotated_video</name>
    <message>
        <source>annotated video of &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 주석 동영상</translation>
    </message>
</context>
<context>
    <name>ui.another_job_runs</name>
    <message>
        <source>another job is running</source>
        <translation>다른 작업이 실행 중입니다</translation>
    </message>
</context>
<context>
    <name>ui.archive_class</name>
    <message>
        <source>archive class %1</source>
        <translation>학급 %1 보관</translation>
    </message>
</context>
<context>
    <name>ui.archive_task</name>
    <message>
        <source>archive task %1</source>
        <translation>과제 %1 보관</translation>
    </message>
</context>
<context>
    <name>ui.archive_trial</name>
    <message>
        <source>archive %1</source>
        <translation>%1 보관</translation>
    </message>
</context>
<context>
    <name>ui.archive_trials</name>
    <message>
        <source>archive %1 trials</source>
        <translation>시행 %1개 보관</translation>
    </message>
</context>
<context>
    <name>ui.backup_is_sound</name>
    <message>
        <source>its backup of %1 is intact; it does not contain later changes</source>
        <translation>%1의 백업 사본은 온전합니다. 그 뒤에 한 일은 들어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>ui.board_has_corners</name>
    <message>
        <source>a board has 3 to 30 inner corners each way</source>
        <translation>보드의 내부 모서리는 가로세로 각각 3개에서 30개입니다</translation>
    </message>
</context>
<context>
    <name>ui.bring_file_back</name>
    <message>
        <source>move the file back there</source>
        <translation>파일을 제자리에 돌려놓으십시오</translation>
    </message>
</context>
<context>
    <name>ui.calibrate_other_first</name>
    <message>
        <source>calibrate the other one, or import a trial with it, first</source>
        <translation>먼저 다른 카메라를 보정하거나 그 카메라의 시행을 가져오십시오</translation>
    </message>
</context>
<context>
    <name>ui.camera_named</name>
    <message>
        <source>camera %1</source>
        <translation>카메라 %1</translation>
    </message>
</context>
<context>
    <name>ui.cameras</name>
    <message>
        <source>the cameras</source>
        <translation>카메라</translation>
    </message>
</context>
<context>
    <name>ui.cannot_make_another</name>
    <message>
        <source>cannot create another project</source>
        <translation>다른 프로젝트를 만들 수 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.cannot_open_another</name>
    <message>
        <source>cannot open another project</source>
        <translation>다른 프로젝트를 열 수 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.change_pseudonym</name>
    <message>
        <source>change the pseudonym of team %1</source>
        <translation>팀 %1의 가명 변경</translation>
    </message>
</context>
<context>
    <name>ui.change_robot</name>
    <message>
        <source>change robot %1</source>
        <translation>로봇 %1 변경</translation>
    </message>
</context>
<context>
    <name>ui.change_tags</name>
    <message>
        <source>change the tags of %1</source>
        <translation>%1의 태그 변경</translation>
    </message>
</context>
<context>
    <name>ui.change_task</name>
    <message>
        <source>change task %1</source>
        <translation>과제 %1 변경</translation>
    </message>
</context>
<context>
    <name>ui.change_team</name>
    <message>
        <source>change members and robots of team %1</source>
        <translation>팀 %1의 팀원과 로봇 변경</translation>
    </message>
</context>
<context>
    <name>ui.charuco_numbered_in_two_ways</name>
    <message>
        <source>programs number a ChArUco board with %1 rows of squares in two different ways</source>
        <translation>정사각형이 %1행인 ChArUco 보드는 프로그램에 따라 번호가 두 가지로 매겨집니다</translation>
    </message>
</context>
<context>
    <name>ui.check_hub</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network</source>
        <translation>주소, ~/.pgpass의 로그인, 네트워크를 확인하세요</translation>
    </message>
</context>
<context>
    <name>ui.choose_another_port</name>
    <message>
        <source>choose another port, or 0 for any that is free</source>
        <translation>다른 포트를 고르거나, 빈 포트를 쓰려면 0을 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_high_port</name>
    <message>
        <source>choose a port of 1024 or more</source>
        <translation>1024 이상의 포트를 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_logo</name>
    <message>
        <source>choose a PNG, JPEG or SVG image</source>
        <translation>PNG, JPEG 또는 SVG 그림을 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_or_make_class</name>
    <message>
        <source>choose one of them, or create it in the workbench</source>
        <translation>그중 하나를 고르거나 창에서 학급을 만드십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_own_address</name>
    <message>
        <source>choose 127.0.0.1, an address of this computer, or 0.0.0.0 for all of them</source>
        <translation>127.0.0.1, 이 컴퓨터의 주소, 또는 모두를 뜻하는 0.0.0.0을 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_recorded</name>
    <message>
        <source>choose one that was recorded</source>
        <translation>녹화된 시행을 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_trial_or_class</name>
    <message>
        <source>choose a trial or a class</source>
        <translation>시행이나 학급을 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_size</name>
    <message>
        <source>choose another, such as 1920x1080</source>
        <translation>1920x1080처럼 다른 크기를 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_speed</name>
    <message>
        <source>choose another, such as 0.25</source>
        <translation>0.25처럼 다른 속도를 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.clips_being_read</name>
    <message>
        <source>those dropped before are still being read</source>
        <translation>앞서 놓은 것을 아직 읽고 있습니다</translation>
    </message>
</context>
<context>
    <name>ui.completing_recording</name>
    <message>
        <source>Completing an interrupted recording</source>
        <translation>중간에 끊긴 녹화를 마무리하는 중</translation>
    </message>
</context>
<context>
    <name>ui.connect_camera</name>
    <message>
        <source>connect camera %1</source>
        <translation>카메라 %1 연결</translation>
    </message>
</context>
<context>
    <name>ui.delete_class</name>
    <message>
        <source>delete class %1</source>
        <translation>학급 %1 삭제</translation>
    </message>
</context>
<context>
    <name>ui.delete_robot</name>
    <message>
        <source>delete robot %1</source>
        <translation>로봇 %1 삭제</translation>
    </message>
</context>
<context>
    <name>ui.delete_task</name>
    <message>
        <source>delete task %1</source>
        <translation>과제 %1 삭제</translation>
    </message>
</context>
<context>
    <name>ui.delete_team</name>
    <message>
        <source>delete team %1</source>
        <translation>팀 %1 삭제</translation>
    </message>
</context>
<context>
    <name>ui.delete_trial</name>
    <message>
        <source>delete %1</source>
        <translation>%1 삭제</translation>
    </message>
</context>
<context>
    <name>ui.delete_trials</name>
    <message>
        <source>delete %1 trials</source>
        <translation>시행 %1개 삭제</translation>
    </message>
</context>
<context>
    <name>ui.does_not_fit_on</name>
    <message>
        <source>%1 by %2 do not fit on %3</source>
        <translation>%1 × %2은(는) %3에 들어가지 않습니다</translation>
    </message>
</context>
<context>
    <name>ui.drop_again</name>
    <message>
        <source>drop them again in a moment</source>
        <translation>잠시 후 다시 놓으십시오</translation>
    </message>
</context>
<context>
    <name>ui.dropped_clips</name>
    <message>
        <source>the dropped clips</source>
        <translation>놓은 동영상</translation>
    </message>
</context>
<context>
    <name>ui.emptying_bin</name>
    <message>
        <source>Emptying the bin</source>
        <translation>휴지통 비우는 중</translation>
    </message>
</context>
<context>
    <name>ui.export_of</name>
    <message>
        <source>export of %1</source>
        <translation>%1 내보내기</translation>
    </message>
</context>
<context>
    <name>ui.exported_trials</name>
    <message>
        <source>Exported trials: %1 of %2</source>
        <translation>내보낸 시행: %2개 중 %1개</translation>
    </message>
</context>
<context>
    <name>ui.exporting</name>
    <message>
        <source>Exporting %1 (%2 of %3)</source>
        <translation>%1 내보내는 중(%2/%3)</translation>
    </message>
</context>
<context>
    <name>ui.finding_mat</name>
    <message>
        <source>Finding the floor mat</source>
        <translation>바닥 매트를 찾는 중</translation>
    </message>
</context>
<context>
    <name>ui.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>바닥 매트</translation>
    </message>
</context>
<context>
    <name>ui.give_board_size</name>
    <message>
        <source>give a size such as 9x6</source>
        <translation>9x6처럼 크기를 주십시오</translation>
    </message>
</context>
<context>
    <name>ui.give_marker_size</name>
    <message>
        <source>give its size, such as 150mm</source>
        <translation>150mm처럼 크기를 주십시오</translation>
    </message>
</context>
<context>
    <name>ui.give_mat_size</name>
    <message>
        <source>give a size such as 4x3</source>
        <translation>4x3과 같은 크기를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>ui.give_square_side</name>
    <message>
        <source>give the side of a square, such as 25mm</source>
        <translation>25mm처럼 정사각형 한 변의 길이를 주십시오</translation>
    </message>
</context>
<context>
    <name>ui.html_page</name>
    <message>
        <source>page</source>
        <translation>페이지</translation>
    </message>
</context>
<context>
    <name>ui.hub_away</name>
    <message>
        <source>it cannot be reached</source>
        <translation>연결할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.hub_goes_on</name>
    <message>
        <source>the page shows the last standings until it is back</source>
        <translation>다시 연결될 때까지 마지막 순위를 표시합니다</translation>
    </message>
</context>
<context>
    <name>ui.hub_silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>서버가 응답하지 않습니다</translation>
    </message>
</context>
<context>
    <name>ui.import_or_record_first</name>
    <message>
        <source>import or record one first</source>
        <translation>먼저 시행을 가져오거나 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>ui.importing</name>
    <message>
        <source>Importing %1</source>
        <translation>%1 가져오는 중</translation>
    </message>
</context>
<context>
    <name>ui.importing_trials</name>
    <message>
        <source>Importing %1 (%2 of %3)</source>
        <translation>%1 가져오는 중(%2/%3)</translation>
    </message>
</context>
<context>
    <name>ui.is_printer_ready</name>
    <message>
        <source>check that the printer is ready</source>
        <translation>프린터가 준비되었는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>ui.job_runs_on_project</name>
    <message>
        <source>a job is running on the project</source>
        <translation>프로젝트에서 작업이 실행 중입니다</translation>
    </message>
</context>
<context>
    <name>ui.lens_of_other_size</name>
    <message>
        <source>its size is %1×%2, but the lens was calibrated at %3×%4</source>
        <translation>%1×%2인데 렌즈는 %3×%4에서 측정되었습니다</translation>
    </message>
</context>
<context>
    <name>ui.logo</name>
    <message>
        <source>logo &apos;%1&apos;</source>
        <translation>로고 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.logo_too_large</name>
    <message>
        <source>it is larger than a hundred megapixels</source>
        <translation>1억 화소보다 큽니다</translation>
    </message>
</context>
<context>
    <name>ui.look_at_printer</name>
    <message>
        <source>check the printer and its queue, or save the report as PDF</source>
        <translation>프린터와 대기열을 확인하거나 보고서를 PDF로 저장하십시오</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_lost</name>
    <message>
        <source>Searching for lost videos</source>
        <translation>잃은 동영상 찾는 중</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_strays</name>
    <message>
        <source>Searching for stray files</source>
        <translation>소속 없는 파일 찾는 중</translation>
    </message>
</context>
<context>
    <name>ui.make_marker_smaller</name>
    <message>
        <source>make it at most %1, or use larger paper</source>
        <translation>최대 %1로 하거나 더 큰 용지를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>ui.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>더 작게 하십시오</translation>
    </message>
</context>
<context>
    <name>ui.make_squares_smaller</name>
    <message>
        <source>make the squares at most %1, or use larger paper</source>
        <translation>정사각형을 최대 %1로 하거나 더 큰 용지를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>ui.making_certificate</name>
    <message>
        <source>Simulating the set-up</source>
        <translation>설정을 시뮬레이션하는 중</translation>
    </message>
</context>
<context>
    <name>ui.making_demo</name>
    <message>
        <source>Creating the demo lesson</source>
        <translation>데모 수업 만드는 중</translation>
    </message>
</context>
<context>
    <name>ui.making_hashes</name>
    <message>
        <source>Computing the hashes of new recordings</source>
        <translation>새 녹화의 해시를 만드는 중</translation>
    </message>
</context>
<context>
    <name>ui.making_report</name>
    <message>
        <source>Creating the report</source>
        <translation>보고서 만드는 중</translation>
    </message>
</context>
<context>
    <name>ui.making_video</name>
    <message>
        <source>Creating the video of %1</source>
        <translation>%1의 동영상 만드는 중</translation>
    </message>
</context>
<context>
    <name>ui.making_videos</name>
    <message>
        <source>Creating the video of %1 (%2 of %3)</source>
        <translation>%1의 동영상 만드는 중(%2/%3)</translation>
    </message>
</context>
<context>
    <name>ui.many_trials</name>
    <message>
        <source>many trials</source>
        <translation>여러 시행</translation>
    </message>
</context>
<context>
    <name>ui.mat_has_sheets</name>
    <message>
        <source>a mat has 1 to %1 sheets in a row and 1 to %2 rows</source>
        <translation>매트는 한 행에 1~%1장, 1~%2행입니다</translation>
    </message>
</context>
<context>
    <name>ui.measuring_again</name>
    <message>
        <source>Reanalysing %1</source>
        <translation>%1 다시 측정하는 중</translation>
    </message>
</context>
<context>
    <name>ui.measuring_trials_again</name>
    <message>
        <source>Reanalysing %1 (%2 of %3)</source>
        <translation>%1 다시 측정하는 중(%2/%3)</translation>
    </message>
</context>
<context>
    <name>ui.mend_and_choose_again</name>
    <message>
        <source>correct the listed errors, then select these trials again</source>
        <translation>위의 문제를 해결한 뒤 이 시행들을 다시 선택하십시오</translation>
    </message>
</context>
<context>
    <name>ui.move_team</name>
    <message>
        <source>move team %1 to class %2</source>
        <translation>팀 %1을(를) 학급 %2(으)로 옮기기</translation>
    </message>
</context>
<context>
    <name>ui.name_one_marker</name>
    <message>
        <source>name at least one, for example O</source>
        <translation>O처럼 하나 이상 적으십시오</translation>
    </message>
</context>
<context>
    <name>ui.no_camera_registered</name>
    <message>
        <source>no camera is registered yet</source>
        <translation>아직 정합된 카메라가 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_further_page</name>
    <message>
        <source>it accepts no more pages</source>
        <translation>더 이상 쪽을 받지 않습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_marker_to_print</name>
    <message>
        <source>no marker to print</source>
        <translation>인쇄할 마커가 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_page</name>
    <message>
        <source>it has no page</source>
        <translation>쪽이 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_project_open</name>
    <message>
        <source>no project is open</source>
        <translation>열린 프로젝트가 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos;</source>
        <translation>지표 &apos;%1&apos;이(가) 있는 주행을 한 팀이 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure_in_task</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos; in the task &apos;%2&apos;</source>
        <translation>과제 &apos;%2&apos;에서 지표 &apos;%1&apos;이(가) 있는 주행을 한 팀이 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.no_trial_yet</name>
    <message>
        <source>the project has no trial yet</source>
        <translation>아직 시행이 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.not_printed</name>
    <message>
        <source>it could not be printed</source>
        <translation>인쇄하지 못했습니다</translation>
    </message>
</context>
<context>
    <name>ui.nothing_changed_here</name>
    <message>
        <source>no change was made here</source>
        <translation>여기서 변경한 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.only_be_read</name>
    <message>
        <source>this project is read-only</source>
        <translation>이 프로젝트는 읽기만 할 수 있습니다</translation>
    </message>
</context>
<context>
    <name>ui.only_one_camera</name>
    <message>
        <source>the project has only one camera</source>
        <translation>카메라가 한 대뿐입니다</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_charuco_markers</name>
    <message>
        <source>only 250 markers exist for a ChArUco board</source>
        <translation>ChArUco 보드에 쓸 수 있는 마커는 250개뿐입니다</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_tags</name>
    <message>
        <source>only %1 tags exist</source>
        <translation>태그는 %1개뿐입니다</translation>
    </message>
</context>
<context>
    <name>ui.open_its_project</name>
    <message>
        <source>open the project that it belongs to</source>
        <translation>해당 프로젝트를 여십시오</translation>
    </message>
</context>
<context>
    <name>ui.open_project_first</name>
    <message>
        <source>open or create a project first</source>
        <translation>먼저 프로젝트를 열거나 만드십시오</translation>
    </message>
</context>
<context>
    <name>ui.opening</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 여는 중</translation>
    </message>
</context>
<context>
    <name>ui.packing</name>
    <message>
        <source>Packing the project</source>
        <translation>프로젝트 묶는 중</translation>
    </message>
</context>
<context>
    <name>ui.page_of_trial</name>
    <message>
        <source>page of trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;의 페이지</translation>
    </message>
</context>
<context>
    <name>ui.pages_not_taken</name>
    <message>
        <source>it did not accept the pages</source>
        <translation>쪽을 받지 않았습니다</translation>
    </message>
</context>
<context>
    <name>ui.painting_floor</name>
    <message>
        <source>drawing the floor</source>
        <translation>바닥 그리는 중</translation>
    </message>
</context>
<context>
    <name>ui.picture</name>
    <message>
        <source>the image</source>
        <translation>사진</translation>
    </message>
</context>
<context>
    <name>ui.picture_of</name>
    <message>
        <source>frame %1 of %2</source>
        <translation>영상 %2장 중 %1</translation>
    </message>
</context>
<context>
    <name>ui.port_in_use</name>
    <message>
        <source>another program uses this port</source>
        <translation>다른 프로그램이 이 포트를 사용합니다</translation>
    </message>
</context>
<context>
    <name>ui.port_not_allowed</name>
    <message>
        <source>the system does not allow this port</source>
        <translation>시스템이 이 포트를 허용하지 않습니다</translation>
    </message>
</context>
<context>
    <name>ui.preview</name>
    <message>
        <source>preview</source>
        <translation>미리 보기</translation>
    </message>
</context>
<context>
    <name>ui.print_fewer_markers</name>
    <message>
        <source>print fewer markers</source>
        <translation>마커를 더 적게 인쇄하십시오</translation>
    </message>
</context>
<context>
    <name>ui.printer_not_reached</name>
    <message>
        <source>it cannot be reached</source>
        <translation>연결할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.printing_on</name>
    <message>
        <source>printing on &apos;%1&apos;</source>
        <translation>‘%1’에 인쇄</translation>
    </message>
</context>
<context>
    <name>ui.project_has_classes</name>
    <message>
        <source>the project has %1</source>
        <translation>프로젝트에 있는 것: %1</translation>
    </message>
</context>
<context>
    <name>ui.project_has_no_class</name>
    <message>
        <source>the project has none</source>
        <translation>프로젝트에 학급이 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.recording_not_there</name>
    <message>
        <source>the recording of camera %1 is not at &apos;%2&apos;</source>
        <translation>카메라 %1의 녹화가 &apos;%2&apos;에 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.register_one_first</name>
    <message>
        <source>register one that sees the markers first</source>
        <translation>먼저 마커가 보이는 카메라를 정합하십시오</translation>
    </message>
</context>
<context>
    <name>ui.registering</name>
    <message>
        <source>Registering camera %1</source>
        <translation>카메라 %1 정합 중</translation>
    </message>
</context>
<context>
    <name>ui.registration_through_another</name>
    <message>
        <source>registration via another camera</source>
        <translation>다른 카메라를 통한 정합</translation>
    </message>
</context>
<context>
    <name>ui.removing_strays</name>
    <message>
        <source>Removing stray files</source>
        <translation>소속 없는 파일 제거 중</translation>
    </message>
</context>
<context>
    <name>ui.rename_class</name>
    <message>
        <source>rename class %1 to %2</source>
        <translation>학급 이름 변경: %1 → %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_task</name>
    <message>
        <source>rename task %1 to %2</source>
        <translation>과제 이름 변경: %1 → %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_team</name>
    <message>
        <source>rename team %1 to %2</source>
        <translation>팀 이름 변경: %1 → %2</translation>
    </message>
</context>
<context>
    <name>ui.report</name>
    <message>
        <source>report</source>
        <translation>보고서</translation>
    </message>
</context>
<context>
    <name>ui.report_file</name>
    <message>
        <source>report &apos;%1&apos;</source>
        <translation>보고서 ‘%1’</translation>
    </message>
</context>
<context>
    <name>ui.report_of_class</name>
    <message>
        <source>report of class &apos;%1&apos;</source>
        <translation>학급 &apos;%1&apos;의 보고서</translation>
    </message>
</context>
<context>
    <name>ui.restoring_backup</name>
    <message>
        <source>Restoring the backup</source>
        <translation>백업 복원 중</translation>
    </message>
</context>
<context>
    <name>ui.save_again</name>
    <message>
        <source>save it again in a moment</source>
        <translation>잠시 뒤 다시 저장하세요</translation>
    </message>
</context>
<context>
    <name>ui.save_copy</name>
    <message>
        <source>save a copy and work on the copy</source>
        <translation>사본을 저장하여 그것으로 작업하십시오</translation>
    </message>
</context>
<context>
    <name>ui.saving_copy</name>
    <message>
        <source>Saving a copy</source>
        <translation>사본 저장 중</translation>
    </message>
</context>
<context>
    <name>ui.saving_table</name>
    <message>
        <source>saving the table</source>
        <translation>표 저장</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_address</name>
    <message>
        <source>standings at %1 port %2</source>
        <translation>순위, %1 포트 %2</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_project_gone</name>
    <message>
        <source>it was moved or deleted, so the standings ended</source>
        <translation>이동되거나 삭제되어 순위 표시가 끝났습니다</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_start_again</name>
    <message>
        <source>start them with the file&apos;s present name</source>
        <translation>파일의 현재 이름으로 다시 시작하십시오</translation>
    </message>
</context>
<context>
    <name>ui.size_is_no_length</name>
    <message>
        <source>its size is not a length</source>
        <translation>크기가 길이가 아닙니다</translation>
    </message>
</context>
<context>
    <name>ui.star_trial</name>
    <message>
        <source>star %1</source>
        <translation>%1 별표 붙이기</translation>
    </message>
</context>
<context>
    <name>ui.star_trials</name>
    <message>
        <source>star %1 trials</source>
        <translation>시행 %1개 별표 붙이기</translation>
    </message>
</context>
<context>
    <name>ui.synchronising</name>
    <message>
        <source>Synchronising %1</source>
        <translation>%1 동기화 중</translation>
    </message>
</context>
<context>
    <name>ui.table_being_saved</name>
    <message>
        <source>another table is still being saved</source>
        <translation>다른 표를 아직 저장하는 중입니다</translation>
    </message>
</context>
<context>
    <name>ui.take_at_that_resolution</name>
    <message>
        <source>use that resolution, or calibrate the lens again</source>
        <translation>그 해상도로 찍거나 렌즈를 다시 측정하십시오</translation>
    </message>
</context>
<context>
    <name>ui.take_even_rows</name>
    <message>
        <source>use an even number of rows of inner corners, such as 9x6</source>
        <translation>9x6처럼 내부 모서리의 행을 짝수로 하십시오</translation>
    </message>
</context>
<context>
    <name>ui.take_fewer_squares</name>
    <message>
        <source>use fewer squares</source>
        <translation>정사각형을 줄이십시오</translation>
    </message>
</context>
<context>
    <name>ui.take_team_out</name>
    <message>
        <source>remove team %1 from its class</source>
        <translation>팀 %1을(를) 학급에서 빼기</translation>
    </message>
</context>
<context>
    <name>ui.taking_over_setup</name>
    <message>
        <source>Copying the set-up</source>
        <translation>설정을 가져오는 중</translation>
    </message>
</context>
<context>
    <name>ui.target</name>
    <message>
        <source>target</source>
        <translation>타깃</translation>
    </message>
</context>
<context>
    <name>ui.the_range</name>
    <message>
        <source>the range</source>
        <translation>구간</translation>
    </message>
</context>
<context>
    <name>ui.the_sample</name>
    <message>
        <source>the sample</source>
        <translation>샘플</translation>
    </message>
</context>
<context>
    <name>ui.the_trial</name>
    <message>
        <source>the trial</source>
        <translation>시행</translation>
    </message>
</context>
<context>
    <name>ui.track_or_choose_figure</name>
    <message>
        <source>track its trials, or choose another task or metric</source>
        <translation>시행을 추적하거나 다른 과제나 지표를 고르십시오</translation>
    </message>
</context>
<context>
    <name>ui.tracking</name>
    <message>
        <source>Tracking %1</source>
        <translation>%1 추적 중</translation>
    </message>
</context>
<context>
    <name>ui.trial_without_recording</name>
    <message>
        <source>the trial has no recording</source>
        <translation>시행에 녹화가 없습니다</translation>
    </message>
</context>
<context>
    <name>ui.trials_imported</name>
    <message>
        <source>Trials imported: %1 of %2</source>
        <translation>가져온 시행: %1/%2</translation>
    </message>
</context>
<context>
    <name>ui.trials_measured_again</name>
    <message>
        <source>Trials reanalysed: %1 of %2</source>
        <translation>다시 측정한 시행: %2개 중 %1개</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_class</name>
    <message>
        <source>restore class %1 from the archive</source>
        <translation>학급 %1 보관 해제</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_task</name>
    <message>
        <source>restore task %1 from the archive</source>
        <translation>과제 %1 보관 해제</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trial</name>
    <message>
        <source>restore %1 from the archive</source>
        <translation>%1 보관 해제</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trials</name>
    <message>
        <source>restore %1 trials from the archive</source>
        <translation>시행 %1개 보관 해제</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trial</name>
    <message>
        <source>restore %1 from the bin</source>
        <translation>%1 휴지통에서 복원</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trials</name>
    <message>
        <source>restore %1 trials from the bin</source>
        <translation>시행 %1개 휴지통에서 복원</translation>
    </message>
</context>
<context>
    <name>ui.undo_in_menu</name>
    <message>
        <source>use the window&apos;s Edit menu to undo earlier changes</source>
        <translation>이전에 변경한 것은 창의 편집 메뉴에서 되돌리십시오</translation>
    </message>
</context>
<context>
    <name>ui.unpacking</name>
    <message>
        <source>Unpacking the project</source>
        <translation>프로젝트 푸는 중</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trial</name>
    <message>
        <source>remove the star from %1</source>
        <translation>%1 별표 떼기</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trials</name>
    <message>
        <source>remove the star from %1 trials</source>
        <translation>시행 %1개 별표 떼기</translation>
    </message>
</context>
<context>
    <name>ui.video_size_wrong</name>
    <message>
        <source>its size of %1x%2 has an odd number of pixels, or is not between 320x180 and 3840x2160</source>
        <translation>크기 %1x%2이(가) 홀수이거나 320x180에서 3840x2160 사이가 아닙니다</translation>
    </message>
</context>
<context>
    <name>ui.video_speed_wrong</name>
    <message>
        <source>its speed is not between 0.1 and 1</source>
        <translation>속도가 0.1에서 1 사이가 아닙니다</translation>
    </message>
</context>
<context>
    <name>ui.videos_made</name>
    <message>
        <source>Videos created: %1 of %2</source>
        <translation>만든 동영상: %2개 중 %1개</translation>
    </message>
</context>
<context>
    <name>ui.wait_or_cancel</name>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>끝날 때까지 기다리거나 취소하십시오</translation>
    </message>
</context>
<context>
    <name>ui.write_notes</name>
    <message>
        <source>write notes of %1</source>
        <translation>%1의 메모 쓰기</translation>
    </message>
</context>
<context>
    <name>ui.writing_back</name>
    <message>
        <source>writing back</source>
        <translation>되쓰기</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode</name>
    <message>
        <source>cannot decode the video</source>
        <translation>동영상을 해독할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_all</name>
    <message>
        <source>cannot decode all of a frame</source>
        <translation>프레임 전체를 복호화할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_frame</name>
    <message>
        <source>cannot decode frame %1 of %2</source>
        <translation>%2의 프레임 %1을(를) 해독할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_encode</name>
    <message>
        <source>cannot encode the video</source>
        <translation>동영상을 인코딩할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_finish</name>
    <message>
        <source>cannot finish the video %1</source>
        <translation>동영상 %1을(를) 마칠 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_join</name>
    <message>
        <source>cannot join &apos;%1&apos; to a recording</source>
        <translation>&apos;%1&apos;을(를) 녹화에 이어 붙일 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_open</name>
    <message>
        <source>cannot open the video %1</source>
        <translation>동영상 %1을(를) 열 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_picture</name>
    <message>
        <source>cannot read the image %1</source>
        <translation>그림 %1을(를) 읽을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_sound</name>
    <message>
        <source>cannot read the sound of %1</source>
        <translation>%1의 소리를 읽을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_show_frame</name>
    <message>
        <source>cannot show frame %1 of %2</source>
        <translation>%2의 프레임 %1을(를) 표시할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_take_image</name>
    <message>
        <source>cannot take &apos;%1&apos; as a frame of a video</source>
        <translation>&apos;%1&apos;을(를) 동영상의 프레임으로 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_write</name>
    <message>
        <source>cannot write the video %1</source>
        <translation>동영상 %1을(를) 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_frame</name>
    <message>
        <source>cannot write a frame to the video %1</source>
        <translation>동영상 %1에 프레임을 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_joined</name>
    <message>
        <source>cannot write the joined recording %1</source>
        <translation>이어 붙인 녹화 %1을(를) 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_recording</name>
    <message>
        <source>cannot write the recording %1</source>
        <translation>녹화 %1을(를) 쓸 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_after_gap</name>
    <message>
        <source>by its recording time %1 are missing between &apos;%2&apos; and it; if so, all times behind that are wrong</source>
        <translation>녹화 시각에 따르면 &apos;%2&apos;와(과) 이 파일 사이에 %1이(가) 빠져 있습니다. 그렇다면 그 뒤의 모든 시간이 틀립니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_codec</name>
    <message>
        <source>its codec is %1, that of &apos;%2&apos; is %3</source>
        <translation>코덱이 %1인데 &apos;%2&apos;의 코덱은 %3입니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_hides_frames</name>
    <message>
        <source>some of its frames are hidden, as an editor does that cuts a video</source>
        <translation>편집기가 동영상을 자를 때처럼 일부 프레임이 숨겨져 있습니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_mirrored</name>
    <message>
        <source>its frames and those of &apos;%1&apos; are not mirrored alike</source>
        <translation>이 파일의 프레임과 &apos;%1&apos;의 프레임은 좌우 반전이 서로 다릅니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_pixels</name>
    <message>
        <source>its pixel format is %1, that of &apos;%2&apos; is %3</source>
        <translation>픽셀 형식이 %1인데 &apos;%2&apos;의 형식은 %3입니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_recorded_before</name>
    <message>
        <source>by its recording time it was started before &apos;%1&apos;, behind which it was joined; check the order of the files</source>
        <translation>녹화 시각에 따르면 앞에 이어 붙인 &apos;%1&apos;보다 먼저 시작되었습니다. 파일 순서를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>video.chapter_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1</source>
        <translation>타임스탬프가 %1 후에 다시 시작되거나 멈춥니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_set_up</name>
    <message>
        <source>its encoder was set up in another way than that of &apos;%1&apos;</source>
        <translation>인코더 설정이 &apos;%1&apos;과(와) 다릅니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_size</name>
    <message>
        <source>its frames are %1, those of &apos;%2&apos; are %3</source>
        <translation>프레임이 %1인데 &apos;%2&apos;의 프레임은 %3입니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_turn</name>
    <message>
        <source>its frames are to be turned by %1°, those of &apos;%2&apos; by %3°</source>
        <translation>프레임을 %1° 돌려야 하는데 &apos;%2&apos;의 프레임은 %3° 돌려야 합니다</translation>
    </message>
</context>
<context>
    <name>video.chapter_without_stamps</name>
    <message>
        <source>its frames have no time stamps of their own</source>
        <translation>프레임에 자체 타임스탬프가 없습니다</translation>
    </message>
</context>
<context>
    <name>video.chapters_of_one_frame</name>
    <message>
        <source>each of the files has a single frame</source>
        <translation>파일마다 프레임이 하나뿐입니다</translation>
    </message>
</context>
<context>
    <name>video.check_its_folder</name>
    <message>
        <source>check that its folder may be written to and has free space</source>
        <translation>폴더에 쓸 수 있고 여유가 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>video.check_picture_place</name>
    <message>
        <source>check the folder, the free space, and that the name ends in .png or .jpg</source>
        <translation>폴더와 여유 공간, 이름이 .png나 .jpg로 끝나는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>video.check_room</name>
    <message>
        <source>check the free disk space</source>
        <translation>디스크에 여유가 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>video.check_the_folder</name>
    <message>
        <source>check that the folder exists, may be written to and has free space</source>
        <translation>폴더가 있고 쓸 수 있으며 여유가 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>video.check_what_was_asked</name>
    <message>
        <source>check the requested size, frame rate and quality</source>
        <translation>요청한 크기, 프레임 속도, 품질을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>video.choose_one_of_these</name>
    <message>
        <source>choose one of these</source>
        <translation>그중에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>video.convert_sound_to_aac</name>
    <message>
        <source>convert its sound to AAC</source>
        <translation>소리를 AAC로 변환하십시오</translation>
    </message>
</context>
<context>
    <name>video.convert_to_h264</name>
    <message>
        <source>convert it to H.264</source>
        <translation>H.264로 변환하십시오</translation>
    </message>
</context>
<context>
    <name>video.convert_to_png</name>
    <message>
        <source>convert it to PNG or JPEG</source>
        <translation>PNG나 JPEG로 변환하십시오</translation>
    </message>
</context>
<context>
    <name>video.convert_to_smaller</name>
    <message>
        <source>convert it to a smaller size</source>
        <translation>더 작은 크기로 변환하십시오</translation>
    </message>
</context>
<context>
    <name>video.convert_to_yuv</name>
    <message>
        <source>convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</source>
        <translation>8비트 YUV로 변환하십시오. 예: ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.copy_again</name>
    <message>
        <source>copy it again</source>
        <translation>다시 복사하십시오</translation>
    </message>
</context>
<context>
    <name>video.copy_chapter_again</name>
    <message>
        <source>copy it from the camera again: what follows it would get wrong times</source>
        <translation>카메라에서 다시 복사하십시오. 그 뒤의 시간이 틀리게 됩니다</translation>
    </message>
</context>
<context>
    <name>video.copy_from_camera</name>
    <message>
        <source>copy it from the camera again</source>
        <translation>카메라에서 다시 복사하십시오</translation>
    </message>
</context>
<context>
    <name>video.copy_if_cut_short</name>
    <message>
        <source>copy it from the camera again if it was cut short</source>
        <translation>잘렸다면 카메라에서 다시 복사하십시오</translation>
    </message>
</context>
<context>
    <name>video.cut_chapter_there</name>
    <message>
        <source>cut it there, and give both parts</source>
        <translation>그 위치에서 잘라 두 부분을 모두 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.data_damaged</name>
    <message>
        <source>its data are damaged</source>
        <translation>데이터가 손상되었습니다</translation>
    </message>
</context>
<context>
    <name>video.decoder_not_started</name>
    <message>
        <source>its decoder did not start (%1)</source>
        <translation>디코더가 시작되지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>video.each_at_its_time</name>
    <message>
        <source>each frame keeps its own time</source>
        <translation>각 그림은 그 자신의 시각으로 계산됩니다</translation>
    </message>
</context>
<context>
    <name>video.encoder_not_started</name>
    <message>
        <source>the encoder did not start (%1)</source>
        <translation>인코더가 시작되지 않습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>video.ends_early</name>
    <message>
        <source>ends early at %1</source>
        <translation>%1에서 일찍 끝납니다</translation>
    </message>
</context>
<context>
    <name>video.failed_before</name>
    <message>
        <source>writing failed earlier</source>
        <translation>앞서 쓰기에 실패했습니다</translation>
    </message>
</context>
<context>
    <name>video.file_not_read</name>
    <message>
        <source>the file could not be read</source>
        <translation>파일을 읽지 못했습니다</translation>
    </message>
</context>
<context>
    <name>video.format_differs</name>
    <message>
        <source>its format differs from the video&apos;s</source>
        <translation>형식이 동영상과 다릅니다</translation>
    </message>
</context>
<context>
    <name>video.frame_left_out</name>
    <message>
        <source>it is left out</source>
        <translation>제외됩니다</translation>
    </message>
</context>
<context>
    <name>video.frames_it_has</name>
    <message>
        <source>it has frames 0 to %1</source>
        <translation>프레임 0부터 %1까지 있습니다</translation>
    </message>
</context>
<context>
    <name>video.frames_left_out</name>
    <message>
        <source>%1 frames left out</source>
        <translation>프레임 %1개 제외</translation>
    </message>
</context>
<context>
    <name>video.frames_not_encodable</name>
    <message>
        <source>frames of this size or chroma format cannot be encoded</source>
        <translation>이 크기나 색차 형식의 프레임은 부호화할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.give_another_format</name>
    <message>
        <source>set the camera to another format</source>
        <translation>카메라가 다른 형식을 내보내게 하십시오</translation>
    </message>
</context>
<context>
    <name>video.give_as_images</name>
    <message>
        <source>give images as a folder, with their rate</source>
        <translation>그림은 폴더와 속도로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.give_camera_file</name>
    <message>
        <source>give the file that the camera recorded</source>
        <translation>카메라가 녹화한 파일을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.give_chapter_of_camera</name>
    <message>
        <source>give the file as the camera wrote it</source>
        <translation>카메라가 쓴 그대로의 파일을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.give_container</name>
    <message>
        <source>give an MP4, MOV, MKV or AVI file</source>
        <translation>MP4, MOV, MKV 또는 AVI 파일을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.give_known_ending</name>
    <message>
        <source>give it one of these endings</source>
        <translation>이 중 하나로 끝나게 하십시오</translation>
    </message>
</context>
<context>
    <name>video.give_rate</name>
    <message>
        <source>give the frames per second, e.g. 30</source>
        <translation>초당 프레임 수를 주십시오. 예: 30</translation>
    </message>
</context>
<context>
    <name>video.give_shorter_clip</name>
    <message>
        <source>give a shorter clip</source>
        <translation>더 짧은 클립을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.h264_needs_even</name>
    <message>
        <source>H.264 needs an even width and height, not %1</source>
        <translation>H.264는 %1이(가) 아니라 짝수의 너비와 높이가 필요합니다</translation>
    </message>
</context>
<context>
    <name>video.header_not_rewritten</name>
    <message>
        <source>its header could not be rewritten</source>
        <translation>헤더를 다시 쓰지 못했습니다</translation>
    </message>
</context>
<context>
    <name>video.header_promises</name>
    <message>
        <source>its header promises %1</source>
        <translation>헤더에는 %1(으)로 되어 있습니다</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_kind</name>
    <message>
        <source>it is not an upright JPEG in colour as the first, &apos;%1&apos;, is</source>
        <translation>첫 그림 &apos;%1&apos;과(와) 같은 똑바른 컬러 JPEG이 아닙니다</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_layout</name>
    <message>
        <source>its colours are stored in another way than those of the first, &apos;%1&apos;</source>
        <translation>색상이 첫 그림 &apos;%1&apos;과(와) 다르게 저장되어 있습니다</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_size</name>
    <message>
        <source>its size is %1, that of the first, &apos;%2&apos;, is %3</source>
        <translation>크기가 %1인데 첫 그림 &apos;%2&apos;의 크기는 %3입니다</translation>
    </message>
</context>
<context>
    <name>video.install_libavcodec</name>
    <message>
        <source>install Debian&apos;s libavcodec</source>
        <translation>Debian의 libavcodec을 설치하십시오</translation>
    </message>
</context>
<context>
    <name>video.install_libx264</name>
    <message>
        <source>install Debian&apos;s libavcodec with libx264</source>
        <translation>libx264가 든 Debian의 libavcodec을 설치하십시오</translation>
    </message>
</context>
<context>
    <name>video.is_finished</name>
    <message>
        <source>it is finished</source>
        <translation>이미 마쳤습니다</translation>
    </message>
</context>
<context>
    <name>video.join_one_recording</name>
    <message>
        <source>join only the files into which a camera has split one recording</source>
        <translation>카메라가 하나의 녹화를 나눈 파일만 이어 붙이십시오</translation>
    </message>
</context>
<context>
    <name>video.joining_chapters</name>
    <message>
        <source>joining &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 이어 붙이는 중</translation>
    </message>
</context>
<context>
    <name>video.largest_picture</name>
    <message>
        <source>the limit is 50 megapixels and 32000 pixels a side</source>
        <translation>5천만 화소 또는 한 변 32000픽셀을 넘으면 읽지 않습니다</translation>
    </message>
</context>
<context>
    <name>video.leave_out_image</name>
    <message>
        <source>leave it out, or convert all of them in the same way</source>
        <translation>빼거나 모두 같은 방식으로 변환하십시오</translation>
    </message>
</context>
<context>
    <name>video.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>더 작게 하십시오</translation>
    </message>
</context>
<context>
    <name>video.name_a_picture</name>
    <message>
        <source>choose an image</source>
        <translation>그림을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>video.no_decoder</name>
    <message>
        <source>there is no decoder for %1</source>
        <translation>%1의 디코더가 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_encoder</name>
    <message>
        <source>the installed libavcodec has no encoder for it</source>
        <translation>설치된 libavcodec에 그 인코더가 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_ffv1_in_mp4</name>
    <message>
        <source>MP4 cannot contain FFV1</source>
        <translation>FFV1은 MP4에 넣을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_frame_written</name>
    <message>
        <source>no frame was written to it</source>
        <translation>프레임이 하나도 쓰이지 않았습니다</translation>
    </message>
</context>
<context>
    <name>video.no_jpeg_layout</name>
    <message>
        <source>JPEG does not support its colour layout</source>
        <translation>JPEG에는 그 색 배열이 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_known_ending</name>
    <message>
        <source>its name ends with neither .mkv nor .mp4</source>
        <translation>이름이 .mkv나 .mp4로 끝나지 않습니다</translation>
    </message>
</context>
<context>
    <name>video.no_picture_format</name>
    <message>
        <source>it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image</source>
        <translation>PNG, JPEG, TIFF, HEIC, WebP, BMP, PNM 그림이 아닙니다</translation>
    </message>
</context>
<context>
    <name>video.no_sound</name>
    <message>
        <source>it has no sound</source>
        <translation>소리가 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_stream</name>
    <message>
        <source>it contains no readable video stream</source>
        <translation>읽을 수 있는 동영상이 들어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>video.no_time_scale</name>
    <message>
        <source>its time scale was not found where the muxer should have put it</source>
        <translation>먹서가 넣어야 할 곳에 시간 단위가 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_time_stamps</name>
    <message>
        <source>the file has no time stamps</source>
        <translation>파일에 시간 기록이 없습니다</translation>
    </message>
</context>
<context>
    <name>video.no_video_kind</name>
    <message>
        <source>it is not a supported kind of video, or its header is damaged or missing (%1)</source>
        <translation>읽을 수 있는 동영상이 아니거나 헤더가 손상되었거나 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>video.no_whole_frame</name>
    <message>
        <source>it contains no complete frame</source>
        <translation>온전한 프레임이 하나도 없습니다</translation>
    </message>
</context>
<context>
    <name>video.of_chapter</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>동영상 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.packet_damaged</name>
    <message>
        <source>a packet is damaged</source>
        <translation>그곳의 패킷이 손상되었습니다</translation>
    </message>
</context>
<context>
    <name>video.picture</name>
    <message>
        <source>image</source>
        <translation>사진</translation>
    </message>
</context>
<context>
    <name>video.picture_claims_size</name>
    <message>
        <source>its header says that it has %1 pixels</source>
        <translation>%1픽셀이라고 되어 있습니다</translation>
    </message>
</context>
<context>
    <name>video.picture_damaged</name>
    <message>
        <source>its content is damaged or cut short</source>
        <translation>내용이 손상되었거나 잘렸습니다</translation>
    </message>
</context>
<context>
    <name>video.picture_file_too_large</name>
    <message>
        <source>the file is larger than 200 MB</source>
        <translation>파일이 200 MB보다 큽니다</translation>
    </message>
</context>
<context>
    <name>video.picture_format_unknown</name>
    <message>
        <source>its format is unknown</source>
        <translation>형식을 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.picture_named</name>
    <message>
        <source>image &apos;%1&apos;</source>
        <translation>사진 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.picture_not_coded</name>
    <message>
        <source>a frame cannot be encoded</source>
        <translation>영상을 부호화할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>video.picture_not_packed</name>
    <message>
        <source>it could not be compressed</source>
        <translation>압축하지 못했습니다</translation>
    </message>
</context>
<context>
    <name>video.pictures_too_large</name>
    <message>
        <source>its frames have more than 100 megapixels or 32000 pixels a side</source>
        <translation>영상이 1억 화소 또는 한 변 32000픽셀을 넘습니다</translation>
    </message>
</context>
<context>
    <name>video.pixel_format_not_read</name>
    <message>
        <source>its pixel format %1 is not supported</source>
        <translation>픽셀 형식 %1은(는) 읽지 않습니다</translation>
    </message>
</context>
<context>
    <name>video.put_into_mp4</name>
    <message>
        <source>put each file into MP4 first, e.g. ffmpeg -i FILE -c copy NEW.mp4</source>
        <translation>먼저 각 파일을 MP4에 넣으십시오. 예: ffmpeg -i FILE -c copy NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.rate_not_positive</name>
    <message>
        <source>its frame rate is not positive</source>
        <translation>프레임 속도가 양수가 아닙니다</translation>
    </message>
</context>
<context>
    <name>video.rate_varies</name>
    <message>
        <source>its frame rate varies: frames are %1 to %2 apart</source>
        <translation>프레임 속도가 일정하지 않아 그림 간격이 %1~%2입니다</translation>
    </message>
</context>
<context>
    <name>video.reading_chapter</name>
    <message>
        <source>reading &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 읽는 중</translation>
    </message>
</context>
<context>
    <name>video.record_with_sound</name>
    <message>
        <source>switch the camera&apos;s sound on</source>
        <translation>카메라의 소리를 켜십시오</translation>
    </message>
</context>
<context>
    <name>video.report_bug</name>
    <message>
        <source>report this as a bug</source>
        <translation>이 문제를 버그로 알려 주십시오</translation>
    </message>
</context>
<context>
    <name>video.siting_not_set</name>
    <message>
        <source>the chroma siting could not be set (%1)</source>
        <translation>색차 위치를 정하지 못했습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>video.size_not_found</name>
    <message>
        <source>its frame size could not be determined</source>
        <translation>영상의 크기를 알아내지 못했습니다</translation>
    </message>
</context>
<context>
    <name>video.sound_left_out</name>
    <message>
        <source>the sound was left out, because the files it is joined with have none or another kind of it</source>
        <translation>이어 붙인 파일에 소리가 없거나 종류가 달라 소리를 뺐습니다</translation>
    </message>
</context>
<context>
    <name>video.sound_part_used</name>
    <message>
        <source>its undamaged part is used</source>
        <translation>온전한 부분만 씁니다</translation>
    </message>
</context>
<context>
    <name>video.sound_too_long</name>
    <message>
        <source>its sound is longer than %1</source>
        <translation>소리가 %1보다 깁니다</translation>
    </message>
</context>
<context>
    <name>video.stamps_repeat</name>
    <message>
        <source>their time stamps repeat that of the frame before</source>
        <translation>시간 기록이 앞 프레임과 같습니다</translation>
    </message>
</context>
<context>
    <name>video.stamps_span</name>
    <message>
        <source>its time stamps span %1</source>
        <translation>시간 기록의 폭이 %1입니다</translation>
    </message>
</context>
<context>
    <name>video.start_it_again</name>
    <message>
        <source>start it again</source>
        <translation>다시 시작하십시오</translation>
    </message>
</context>
<context>
    <name>video.start_video_again</name>
    <message>
        <source>start the video again</source>
        <translation>동영상을 다시 시작하십시오</translation>
    </message>
</context>
<context>
    <name>video.taking_image</name>
    <message>
        <source>taking image %1 of %2</source>
        <translation>그림 %2개 중 %1번째 처리 중</translation>
    </message>
</context>
<context>
    <name>video.time_not_after</name>
    <message>
        <source>its time is not later than that of the frame before</source>
        <translation>시간이 앞 프레임보다 뒤가 아닙니다</translation>
    </message>
</context>
<context>
    <name>video.unknown_format_not_read</name>
    <message>
        <source>its pixel format (unknown) is not supported</source>
        <translation>(알 수 없는) 픽셀 형식은 읽지 않습니다</translation>
    </message>
</context>
<context>
    <name>video.use_another_picture</name>
    <message>
        <source>use another image</source>
        <translation>다른 사진을 쓰십시오</translation>
    </message>
</context>
<context>
    <name>video.use_mjpeg</name>
    <message>
        <source>use MJPEG or FFV1, or another size</source>
        <translation>MJPEG나 FFV1, 또는 다른 크기를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>video.use_mkv</name>
    <message>
        <source>use the ending .mkv</source>
        <translation>확장자 .mkv를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>video.use_other_chroma</name>
    <message>
        <source>use 4:2:0, 4:2:2 or 4:4:4</source>
        <translation>4:2:0, 4:2:2 또는 4:4:4를 쓰십시오</translation>
    </message>
</context>
<context>
    <name>video.write_at_least_one</name>
    <message>
        <source>write at least one</source>
        <translation>하나 이상 쓰십시오</translation>
    </message>
</context>
<context>
    <name>video.write_in_order</name>
    <message>
        <source>write the frames in order, at least a microsecond apart</source>
        <translation>프레임을 순서대로, 1마이크로초 이상 간격으로 쓰십시오</translation>
    </message>
</context>
<context>
    <name>video.write_one_format</name>
    <message>
        <source>write one format to a file</source>
        <translation>한 파일에는 한 형식만 쓰십시오</translation>
    </message>
</context>
<context>
    <name>workflow.accept_results</name>
    <message>
        <source>accept the results of %1</source>
        <translation>%1의 결과 승인</translation>
    </message>
</context>
<context>
    <name>workflow.accuracy_given</name>
    <message>
        <source>accurate to %1, as given</source>
        <translation>지정한 대로 %1까지 정확</translation>
    </message>
</context>
<context>
    <name>workflow.add_layout_of_mat</name>
    <message>
        <source>add layout %1</source>
        <translation>배치 %1 추가</translation>
    </message>
</context>
<context>
    <name>workflow.add_robot</name>
    <message>
        <source>add one with: odograph robot add PROJECT NAME --colour #rrggbb</source>
        <translation>테스트베드에서 추가하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.added_with_colour</name>
    <message>
        <source>it was added with the colour %1</source>
        <translation>색 %1(으)로 추가했습니다</translation>
    </message>
</context>
<context>
    <name>workflow.address_of_live_positions</name>
    <message>
        <source>address &apos;%1&apos; of live positions</source>
        <translation>실시간 위치의 주소 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.analyse_it_again</name>
    <message>
        <source>reanalyse it</source>
        <translation>다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.analysing</name>
    <message>
        <source>analysing</source>
        <translation>분석 중</translation>
    </message>
</context>
<context>
    <name>workflow.analysing_robot</name>
    <message>
        <source>analysing %1</source>
        <translation>%1 분석 중</translation>
    </message>
</context>
<context>
    <name>workflow.another_picture_size</name>
    <message>
        <source>its frames are %1, but the camera was registered at %2</source>
        <translation>프레임은 %1인데 카메라는 %2에서 정합되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.assumed_lens</name>
    <message>
        <source>its lens was neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>렌즈가 보정되지도, 바닥 마커로 결정되지도 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.bad_is_not_accepted</name>
    <message>
        <source>bad results cannot be accepted (%1)</source>
        <translation>나쁜 결과는 승인할 수 없습니다 (%1)</translation>
    </message>
</context>
<context>
    <name>workflow.beyond_limits</name>
    <message>
        <source>%1 of the samples exceed the limits of task &apos;%2&apos;, so the limits were ignored</source>
        <translation>측정값의 %1가 과제 &apos;%2&apos;의 한계를 넘어 한계를 적용하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.board_in_no_picture</name>
    <message>
        <source>the board was found in none of %1 images (%2)</source>
        <translation>사진 %1장 어디에서도 보드를 찾지 못했습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.box_stands_in</name>
    <message>
        <source>the project has none, so a blue box of 260 mm × 190 mm × 60 mm is simulated</source>
        <translation>프로젝트에 로봇이 없어 260 mm × 190 mm × 60 mm의 파란 상자를 시뮬레이션합니다</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_and_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens calibration %2</source>
        <translation>배치 &apos;%1&apos;, 보정 %2의 렌즈</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_without_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens not calibrated</source>
        <translation>배치 &apos;%1&apos;, 렌즈 보정 안 됨</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_and_reanalyse</name>
    <message>
        <source>calibrate the lens, register the camera again and reanalyse</source>
        <translation>렌즈를 보정하고 카메라를 다시 정합한 뒤 다시 분석하세요</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_at_its_size</name>
    <message>
        <source>calibrate it at the size it records.</source>
        <translation>녹화하는 크기로 보정하십시오.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_camera</name>
    <message>
        <source>calibrate camera %1</source>
        <translation>카메라 %1 보정</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_if_touched</name>
    <message>
        <source>if zoom, focus or the camera&apos;s settings have changed since, calibrate it again.</source>
        <translation>그 뒤 줌, 초점 또는 카메라 설정을 건드렸다면 다시 보정하십시오.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_it</name>
    <message>
        <source>calibrate it.</source>
        <translation>보정하십시오.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_lens_first</name>
    <message>
        <source>calibrate the lens first, or choose another calibration</source>
        <translation>먼저 렌즈를 보정하거나 다른 보정을 적용하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_give_picture</name>
    <message>
        <source>calibrate it, import its intrinsics, or give an image or a video as well</source>
        <translation>보정하거나 내부 파라미터를 가져오거나 이미지 또는 동영상도 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_import_trial</name>
    <message>
        <source>calibrate it, import its intrinsics, or import a trial with it first</source>
        <translation>먼저 보정하거나, 내부 파라미터나 이 카메라의 시행을 가져오십시오</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_pair</name>
    <message>
        <source>calibrate cameras %1 and %2 as a pair</source>
        <translation>카메라 %1과(와) %2을(를) 쌍으로 보정</translation>
    </message>
</context>
<context>
    <name>workflow.calibrated_from_pictures</name>
    <message>
        <source>calibrated from %1 images</source>
        <translation>사진 %1장으로 보정</translation>
    </message>
</context>
<context>
    <name>workflow.calibrating_camera</name>
    <message>
        <source>calibrating camera %1</source>
        <translation>카메라 %1 보정 중</translation>
    </message>
</context>
<context>
    <name>workflow.calibration</name>
    <message>
        <source>calibration %1</source>
        <translation>보정 %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_of_camera</name>
    <message>
        <source>calibration of camera &apos;%1&apos;</source>
        <translation>카메라 &apos;%1&apos;의 보정</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_picture</name>
    <message>
        <source>calibration image &apos;%1&apos;</source>
        <translation>보정 사진 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>카메라 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera_ended_before_start</name>
    <message>
        <source>a camera ended before the start</source>
        <translation>시작 전에 카메라가 끝났습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_gave_no_picture</name>
    <message>
        <source>camera &apos;%1&apos; delivered no frame</source>
        <translation>카메라 &apos;%1&apos;에서 영상이 오지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; or its address &apos;%2&apos; was given twice</source>
        <translation>카메라 &apos;%1&apos; 또는 주소 &apos;%2&apos;이(가) 두 번 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_two_videos</name>
    <message>
        <source>camera &apos;%1&apos; was given two videos</source>
        <translation>카메라 &apos;%1&apos;에 동영상이 두 개 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_moved_during</name>
    <message>
        <source>the camera moved by %1 after %2; what it saw from then on was not measured</source>
        <translation>카메라가 %2 이후 %1 움직였습니다. 그 이후에 본 것은 측정하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_on_floor</name>
    <message>
        <source>camera &apos;%1&apos; is not registered to the floor</source>
        <translation>카메라 &apos;%1&apos;이(가) 바닥에 정합되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_registered</name>
    <message>
        <source>camera &apos;%1&apos; is not registered</source>
        <translation>카메라 &apos;%1&apos;이(가) 정합되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.camera_sees_too_little</name>
    <message>
        <source>the camera sees too little of the floor between the markers for a run</source>
        <translation>카메라가 보는 마커 사이의 바닥이 주행하기에 너무 작습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_given_one_file</name>
    <message>
        <source>cameras &apos;%1&apos; and &apos;%2&apos; were given the same file, &apos;%3&apos;</source>
        <translation>카메라 ‘%1’과(와) ‘%2’에 같은 파일 ‘%3’이(가) 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_share_too_little</name>
    <message>
        <source>no two cameras share enough of the floor between the markers for a run</source>
        <translation>두 카메라가 함께 보는 마커 사이의 바닥이 주행하기에 충분하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved</name>
    <message>
        <source>camera %1 seems to have moved by %2 since its registration</source>
        <translation>카메라 %1이(가) 정합 이후 %2 움직인 것 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved_at</name>
    <message>
        <source>camera %1 seems to have moved by %2 at %3</source>
        <translation>카메라 %1이(가) %3에 %2 움직인 것 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_cameras_moved</name>
    <message>
        <source>cameras %1 and %2 seem to have moved since their registration</source>
        <translation>카메라 %1와(과) %2이(가) 정합 이후 움직인 것 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_clock_rate</name>
    <message>
        <source>the time offset of view %1 seems to change by %2 in each second</source>
        <translation>뷰 %1의 시간 차이가 매초 %2씩 변하는 것 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_height</name>
    <message>
        <source>the height given for the robot seems wrong by about %1</source>
        <translation>로봇에 지정된 높이가 약 %1 틀린 것 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_offset</name>
    <message>
        <source>the time offset of view %1 seems wrong by %2</source>
        <translation>뷰 %1의 시간 차이가 %2 틀린 것 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cause_or_cause</name>
    <message>
        <source>%1, or %2</source>
        <translation>%1, 또는 %2</translation>
    </message>
</context>
<context>
    <name>workflow.certificate</name>
    <message>
        <source>certificate</source>
        <translation>인증서</translation>
    </message>
</context>
<context>
    <name>workflow.change_guidance</name>
    <message>
        <source>change the guidance of %1</source>
        <translation>%1의 추적 지침 변경</translation>
    </message>
</context>
<context>
    <name>workflow.changed_in_file</name>
    <message>
        <source>they were changed in the file</source>
        <translation>파일에서 변경되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_missing</name>
    <message>
        <source>by their names a file is missing between &apos;%1&apos; and &apos;%2&apos;; if so, all times behind it are wrong</source>
        <translation>이름에 따르면 &apos;%1&apos;과(와) &apos;%2&apos; 사이에 파일이 빠져 있습니다. 그렇다면 그 뒤의 모든 시간이 틀립니다</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>&apos;%1&apos;이(가) 두 번 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.chapters_out_of_order</name>
    <message>
        <source>by their names &apos;%1&apos; comes before &apos;%2&apos;, and was joined behind it; check the order of the files</source>
        <translation>이름에 따르면 &apos;%1&apos;이(가) &apos;%2&apos;보다 앞인데 뒤에 이어 붙였습니다. 파일 순서를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_cable_and_bandwidth</name>
    <message>
        <source>check the cable, the bandwidth and what else this computer is doing</source>
        <translation>케이블, 대역폭, 이 컴퓨터의 다른 작업을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_files_and_offset</name>
    <message>
        <source>check the files and the --sync offset</source>
        <translation>파일과 오프셋을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_it_is_connected</name>
    <message>
        <source>check that it is connected and not used by another program</source>
        <translation>연결되어 있고 다른 프로그램이 쓰지 않는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_its_cable</name>
    <message>
        <source>check its cable, and whether another program uses it</source>
        <translation>케이블과 다른 프로그램이 쓰고 있는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_line_is</name>
    <message>
        <source>its check line is 1000 or 200 mm long; no print is off by so much</source>
        <translation>확인선의 길이는 1000 또는 200 mm이며, 인쇄가 그만큼 어긋나는 일은 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_analyse_again</name>
    <message>
        <source>run odograph check, or reanalyse the trial</source>
        <translation>프로젝트를 점검하거나 시행을 다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_register_again</name>
    <message>
        <source>check that the camera has not moved, or register it again.</source>
        <translation>카메라가 움직이지 않았는지 확인하거나 다시 정합하십시오.</translation>
    </message>
</context>
<context>
    <name>workflow.check_rate</name>
    <message>
        <source>views are matched by time: check --rate if one is in slow motion</source>
        <translation>뷰는 시간으로 결합됩니다. 슬로 모션이면 실제 프레임 속도를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_robot_and_registration</name>
    <message>
        <source>check the robot&apos;s colour and size, and the registrations</source>
        <translation>로봇의 색과 크기, 정합을 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_they_are_connected</name>
    <message>
        <source>check that they are connected and not used by another program</source>
        <translation>연결되어 있고 다른 프로그램이 쓰지 않는지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_views_of_one_run</name>
    <message>
        <source>only one view measures the rest, so check that both belong to one run</source>
        <translation>그 밖에서는 한 뷰만 측정하므로 둘이 같은 주행인지 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.check_whether_moved</name>
    <message>
        <source>check whether camera %1 has moved</source>
        <translation>카메라 %1이(가) 움직였는지 확인</translation>
    </message>
</context>
<context>
    <name>workflow.checking_trials</name>
    <message>
        <source>checks of the trials</source>
        <translation>시행 검사</translation>
    </message>
</context>
<context>
    <name>workflow.choose_another_one</name>
    <message>
        <source>choose another one</source>
        <translation>다른 것을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_calibration</name>
    <message>
        <source>choose calibration %1 of camera %2</source>
        <translation>카메라 %2의 보정 %1 선택</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_for_demo</name>
    <message>
        <source>choose a folder you can write to, with 300 MB free</source>
        <translation>쓸 수 있고 300 MB의 여유가 있는 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_of_copies</name>
    <message>
        <source>choose the folder where they were copied to</source>
        <translation>복사해 둔 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_frame</name>
    <message>
        <source>choose one from %1 to %2</source>
        <translation>%1에서 %2 사이에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_interface</name>
    <message>
        <source>choose one that `ip link` lists, or lo to stay on this computer</source>
        <translation>`ip link`에 나오는 것을 고르거나, 이 컴퓨터에서만 쓰려면 lo를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_measured_frame</name>
    <message>
        <source>choose a frame with a measurement</source>
        <translation>측정값이 있는 프레임을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_metric</name>
    <message>
        <source>choose from %1</source>
        <translation>%1 중에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_one_of_them</name>
    <message>
        <source>choose one of them</source>
        <translation>그중 하나를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_group</name>
    <message>
        <source>choose other times or another reason</source>
        <translation>다른 시간이나 다른 이유를 선택하세요</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_range</name>
    <message>
        <source>choose another range</source>
        <translation>다른 구간을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_range_within</name>
    <message>
        <source>choose a range from 0 to %1</source>
        <translation>0부터 %1까지의 구간을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_registration</name>
    <message>
        <source>choose registration %1 of camera %2</source>
        <translation>카메라 %2의 정합 %1 선택</translation>
    </message>
</context>
<context>
    <name>workflow.choose_robot_of_trial</name>
    <message>
        <source>choose a robot of the trial</source>
        <translation>시행의 로봇을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_run_on_layout</name>
    <message>
        <source>choose a run on the same layout</source>
        <translation>같은 배치에서의 주행을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_seen_task</name>
    <message>
        <source>choose a task on the floor that they see, or leave the task out</source>
        <translation>카메라가 보는 바닥에 있는 과제를 선택하거나 과제를 지정하지 마십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_task_with_course</name>
    <message>
        <source>choose a task that has, or leave the task out</source>
        <translation>그런 것이 있는 과제를 선택하거나 과제를 지정하지 마십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_time</name>
    <message>
        <source>choose a time from %1 to %2</source>
        <translation>%1에서 %2 사이의 시간을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_trial_of_views</name>
    <message>
        <source>choose a trial of two views or more</source>
        <translation>뷰가 둘 이상인 시행을 선택하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.choose_with_robot</name>
    <message>
        <source>choose one with --robot</source>
        <translation>그중 하나를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.class_without_team</name>
    <message>
        <source>without a team it belongs to no class</source>
        <translation>팀이 없으면 어느 학급에도 속하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.clear_range</name>
    <message>
        <source>remove the range of %1</source>
        <translation>%1의 구간 해제</translation>
    </message>
</context>
<context>
    <name>workflow.clock_jumped</name>
    <message>
        <source>at %1 the clock jumped ahead by %2; later times were corrected</source>
        <translation>%1에 시계가 %2만큼 앞으로 뛰었습니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.clock_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1: two files were joined, or the camera&apos;s clock was reset</source>
        <translation>타임스탬프가 %1 후에 다시 시작되거나 멈춥니다. 두 파일을 이어 붙였거나 카메라 시계가 초기화되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.clocks_differ</name>
    <message>
        <source>the clocks of views &apos;%1&apos; and &apos;%2&apos; differ by %3; speeds and times are by the clock of view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;와(과) &apos;%2&apos;의 시계가 %3 차이 납니다. 속도와 시간은 뷰 &apos;%1&apos;의 시계를 따릅니다</translation>
    </message>
</context>
<context>
    <name>workflow.compared_with_itself</name>
    <message>
        <source>a run cannot be compared with itself</source>
        <translation>주행을 자기 자신과 비교할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.comparison_of_trial</name>
    <message>
        <source>comparison of trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;의 비교</translation>
    </message>
</context>
<context>
    <name>workflow.complete_trial</name>
    <message>
        <source>complete %1, whose recording was cut off</source>
        <translation>녹화가 끊긴 %1 완성</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recording</name>
    <message>
        <source>completing a recording that was cut off</source>
        <translation>중단된 녹화를 완성하는 중</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recordings</name>
    <message>
        <source>completing the recordings</source>
        <translation>녹화 완성</translation>
    </message>
</context>
<context>
    <name>workflow.computing_intrinsics</name>
    <message>
        <source>computing the intrinsics</source>
        <translation>내부 파라미터 계산 중</translation>
    </message>
</context>
<context>
    <name>workflow.computing_pair</name>
    <message>
        <source>computing the relative position</source>
        <translation>상대 위치 계산 중</translation>
    </message>
</context>
<context>
    <name>workflow.copied_while_recorded</name>
    <message>
        <source>its recording has not ended</source>
        <translation>녹화가 아직 끝나지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.copy_file_again</name>
    <message>
        <source>copy the file from the camera again</source>
        <translation>카메라에서 파일을 다시 복사하세요</translation>
    </message>
</context>
<context>
    <name>workflow.copy_of</name>
    <message>
        <source>copy of &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 사본</translation>
    </message>
</context>
<context>
    <name>workflow.copy_trial</name>
    <message>
        <source>copy trial %1 to %2</source>
        <translation>시행 복사: %1 → %2</translation>
    </message>
</context>
<context>
    <name>workflow.copying_project</name>
    <message>
        <source>copying the project</source>
        <translation>프로젝트 복사 중</translation>
    </message>
</context>
<context>
    <name>workflow.corner_off_frame</name>
    <message>
        <source>a corner is outside the frame</source>
        <translation>모서리가 프레임 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.correct_by_hand</name>
    <message>
        <source>correct %1 by hand</source>
        <translation>%1 수동 보정</translation>
    </message>
</context>
<context>
    <name>workflow.course_not_seen</name>
    <message>
        <source>the cameras see only %1 of the course of task &apos;%2&apos;</source>
        <translation>카메라가 과제 &apos;%2&apos;의 코스 중 %1만 봅니다</translation>
    </message>
</context>
<context>
    <name>workflow.course_of_task</name>
    <message>
        <source>course of task &apos;%1&apos;</source>
        <translation>과제 &apos;%1&apos;의 코스</translation>
    </message>
</context>
<context>
    <name>workflow.course_seen_in_part</name>
    <message>
        <source>no camera sees %1 of the run whole</source>
        <translation>주행의 %1는 어떤 카메라에도 온전히 보이지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.cut_at_restart</name>
    <message>
        <source>cut it there, and import each part as its own trial</source>
        <translation>그 위치에서 잘라 각 부분을 별도의 시행으로 가져오십시오</translation>
    </message>
</context>
<context>
    <name>workflow.damaged_frames</name>
    <message>
        <source>%1 of its %2 frames, from %3 to %4, are damaged and were not measured</source>
        <translation>프레임 %2개 중 %1개(%3~%4)가 손상되어 측정하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.date_to_come</name>
    <message>
        <source>its new date is in the future</source>
        <translation>새 날짜가 미래입니다</translation>
    </message>
</context>
<context>
    <name>workflow.demo</name>
    <message>
        <source>demo</source>
        <translation>데모</translation>
    </message>
</context>
<context>
    <name>workflow.demo_in</name>
    <message>
        <source>demo in &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 데모</translation>
    </message>
</context>
<context>
    <name>workflow.demo_is_there</name>
    <message>
        <source>%1 already exists</source>
        <translation>%1이(가) 이미 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name</name>
    <message>
        <source>from %1 to %2 this may be %3 or %4</source>
        <translation>%1부터 %2까지 이것이 %3인지 %4인지 확실하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name_unknown</name>
    <message>
        <source>from %1 to %2 this may be %3 or another robot that looks the same</source>
        <translation>%1부터 %2까지 이것이 %3인지 겉모습이 같은 다른 로봇인지 확실하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or %5</source>
        <translation>%1부터 %2까지(%3번 중 첫 번째) 이것이 %4인지 %5인지 확실하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names_unknown</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or another robot that looks the same</source>
        <translation>%1부터 %2까지(%3번 중 첫 번째) 이것이 %4인지 겉모습이 같은 다른 로봇인지 확실하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_step</name>
    <message>
        <source>it is synchronised only to %1, which is %2 at 1 m/s</source>
        <translation>동기 오차가 %1로, 1 m/s에서 %2입니다</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trial</name>
    <message>
        <source>edit trial %1</source>
        <translation>시행 %1 편집</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trials</name>
    <message>
        <source>edit %1 trials</source>
        <translation>시행 %1개 편집</translation>
    </message>
</context>
<context>
    <name>workflow.error_estimated</name>
    <message>
        <source>positions to %1, estimated from the track</source>
        <translation>위치의 오차 %1, 위치에서 추정</translation>
    </message>
</context>
<context>
    <name>workflow.error_stated</name>
    <message>
        <source>positions to %1, as stated in the file</source>
        <translation>위치의 오차 %1, 파일에 적힌 대로</translation>
    </message>
</context>
<context>
    <name>workflow.evaluation_of_trial</name>
    <message>
        <source>evaluation of trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;의 평가</translation>
    </message>
</context>
<context>
    <name>workflow.export</name>
    <message>
        <source>export of &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 내보내기</translation>
    </message>
</context>
<context>
    <name>workflow.faster_disk_or_fewer_cameras</name>
    <message>
        <source>record to a faster disk, or fewer cameras at once</source>
        <translation>더 빠른 디스크에, 또는 더 적은 카메라로 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.file_given_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>&apos;%1&apos;이(가) 두 번 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_another_size</name>
    <message>
        <source>its file has %1 bytes, but had %2 when it was added</source>
        <translation>파일이 %1바이트인데 추가할 때는 %2바이트였습니다</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_other_content</name>
    <message>
        <source>its file has changed since it was added</source>
        <translation>파일이 추가된 뒤에 변경되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.file_without_picture</name>
    <message>
        <source>it contains no image</source>
        <translation>영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.film_progressive</name>
    <message>
        <source>choose a progressive mode of the camera (p, not i)</source>
        <translation>카메라의 순차 주사 모드(i가 아닌 p)를 선택하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_doubtful_rate</name>
    <message>
        <source>its file says that it was filmed at %1, but its time stamps mean %2</source>
        <translation>파일에는 %1(으)로 촬영되었다고 되어 있지만, 타임스탬프는 %2을(를) 뜻합니다</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_rate</name>
    <message>
        <source>it was filmed at %1, as its file says, and plays at %2; its times are those of filming</source>
        <translation>파일에 따르면 %1(으)로 촬영되었고 %2(으)로 재생됩니다. 시간은 촬영 때의 것입니다</translation>
    </message>
</context>
<context>
    <name>workflow.first_label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3, so speeds and times are wrong by %4</source>
        <translation>뷰 &apos;%1&apos;은(는) %2로 녹화되었지만 파일에는 %3로 되어 있어 속도와 시간이 %4만큼 틀립니다</translation>
    </message>
</context>
<context>
    <name>workflow.fitting_cameras_together</name>
    <message>
        <source>fitting %1 cameras jointly</source>
        <translation>카메라 %1대를 함께 피팅하는 중</translation>
    </message>
</context>
<context>
    <name>workflow.fix_camera</name>
    <message>
        <source>fix the camera, register it again and repeat the run</source>
        <translation>카메라를 고정하고 다시 정합한 뒤 주행을 반복하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.floor_has_its_colour</name>
    <message>
        <source>its colour %1 is also the floor&apos;s (%2 of the frame in view %3)</source>
        <translation>색 %1이(가) 바닥 색이기도 합니다 (뷰 %3 영상의 %2)</translation>
    </message>
</context>
<context>
    <name>workflow.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>바닥 매트</translation>
    </message>
</context>
<context>
    <name>workflow.folder</name>
    <message>
        <source>folder &apos;%1&apos;</source>
        <translation>폴더 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_file</name>
    <message>
        <source>frame %1 of &apos;%2&apos;</source>
        <translation>&apos;%2&apos;의 프레임 %1</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_trial</name>
    <message>
        <source>frame %1 of trial &apos;%2&apos;</source>
        <translation>시행 &apos;%2&apos;의 프레임 %1</translation>
    </message>
</context>
<context>
    <name>workflow.frame_rate_of</name>
    <message>
        <source>frame rate of %1</source>
        <translation>%1의 프레임 속도</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled</name>
    <message>
        <source>up to %1 frames repeat for %2; later times were corrected</source>
        <translation>%1까지 %2 동안 프레임이 반복됩니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled_unseen</name>
    <message>
        <source>after %1 %2 frames repeat the one before, and its time stamps count them as time; later times were corrected</source>
        <translation>%1 이후 프레임 %2개가 앞 프레임을 반복하며, 타임스탬프는 이를 시간으로 셉니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_frozen</name>
    <message>
        <source>after %1 %2 frames show the same image while the robot went on; they were not measured</source>
        <translation>%1 이후 로봇이 계속 이동하는 동안 프레임 %2개가 같은 이미지를 보입니다. 측정하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_lost</name>
    <message>
        <source>after %1 the frames of %2 are missing, because the camera paused or lost them; later times were corrected</source>
        <translation>%1 이후 %2 동안의 프레임이 없습니다. 카메라가 멈췄거나 프레임을 잃었습니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing</name>
    <message>
        <source>%1 without a frame, where %2 is usual; frames are missing, or its time stamps jump</source>
        <translation>평소 %2인 간격이 %1입니다. 프레임이 빠졌거나 타임스탬프가 건너뜁니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing_unseen</name>
    <message>
        <source>after %1 %2 frames are missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>%1 이후 타임스탬프에 나타나지 않는 프레임 %2개가 빠졌습니다. 로봇이 너무 멀리 이동합니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_not_decoded</name>
    <message>
        <source>%1 of its %2 frames are damaged and were not measured</source>
        <translation>프레임 %2개 중 %1개가 손상되어 측정하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_stood</name>
    <message>
        <source>after %1 the robot rests for %2 frames and then goes on at the same speed: either the frames repeat the one before and later times are too late, or the robot stopped; times were not corrected</source>
        <translation>%1 이후 로봇이 프레임 %2개 동안 서 있다가 같은 속도로 계속 갑니다. 프레임이 앞 프레임을 반복하여 이후의 시간이 그만큼 늦거나, 로봇이 멈춘 것입니다. 시간은 보정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.frames_without_board</name>
    <message>
        <source>%1 frames: %2</source>
        <translation>프레임 %1개: %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_file</name>
    <message>
        <source>give another file</source>
        <translation>다른 파일을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_team</name>
    <message>
        <source>give another team, or change the class of this one</source>
        <translation>다른 팀을 지정하거나 이 팀의 학급을 바꾸십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_camera_rate</name>
    <message>
        <source>give the rate at which the camera took the frames</source>
        <translation>카메라가 프레임을 찍은 속도를 입력하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_cameras</name>
    <message>
        <source>give one or more, like --camera A=sim:A</source>
        <translation>카메라…에서 하나 이상을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_chapter_once</name>
    <message>
        <source>give each file once, in their order</source>
        <translation>각 파일을 순서대로 한 번씩 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_class_too</name>
    <message>
        <source>give its class too, or another team</source>
        <translation>학급도 함께 지정하거나 다른 팀을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_date_of_run</name>
    <message>
        <source>give the date of the run</source>
        <translation>주행한 날짜를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_file_once</name>
    <message>
        <source>give each file once, to its camera</source>
        <translation>파일마다 해당 카메라에 한 번만 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_frame_time</name>
    <message>
        <source>give one time for each frame</source>
        <translation>프레임마다 시간 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_its_file</name>
    <message>
        <source>give each camera its own video</source>
        <translation>카메라마다 자기 동영상을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_robot_one</name>
    <message>
        <source>give each robot one</source>
        <translation>로봇마다 하나씩 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_view_its_camera</name>
    <message>
        <source>give each view its own camera</source>
        <translation>뷰마다 다른 카메라를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_height_below_camera</name>
    <message>
        <source>give a height below the camera</source>
        <translation>카메라보다 낮은 높이를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_limits_of_fastest</name>
    <message>
        <source>give the task the limits of its fastest robot</source>
        <translation>과제에 가장 빠른 로봇의 한계를 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_offset_for_each</name>
    <message>
        <source>give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto</source>
        <translation>첫 뷰를 뺀 각 뷰의 오프셋을 주거나 ‘움직임이나 번쩍임에서’를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_one_table</name>
    <message>
        <source>give one table for each view</source>
        <translation>뷰마다 표 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_own_colours</name>
    <message>
        <source>give each its own colour</source>
        <translation>각 로봇에 고유한 색을 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_picture_of_that_size</name>
    <message>
        <source>give an image of that size</source>
        <translation>그 크기의 영상을 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_pixels_or_picture</name>
    <message>
        <source>give the markers&apos; pixels, or an image or a video of the floor</source>
        <translation>마커의 픽셀이나 바닥의 이미지 또는 동영상을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_pre_roll</name>
    <message>
        <source>give a pre-roll of 0 to 30 seconds</source>
        <translation>사전 녹화를 0초에서 30초 사이로 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_range_in_seconds</name>
    <message>
        <source>give its start and end in seconds</source>
        <translation>시작과 끝을 초 단위로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_table</name>
    <message>
        <source>give one of them</source>
        <translation>둘 중 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_times</name>
    <message>
        <source>give their rate or a table of their times, like --rate 30 or --times A=stamps.csv</source>
        <translation>카메라의 실제 속도를 입력하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_seconds</name>
    <message>
        <source>give the seconds, such as 10</source>
        <translation>10처럼 초를 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_start_first</name>
    <message>
        <source>give the start first, then a later end</source>
        <translation>먼저 시작을, 그다음 더 늦은 끝을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_table_of_times</name>
    <message>
        <source>give a table of their times, like --times A=stamps.csv</source>
        <translation>1씩 늘어나는 번호를 붙이십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_task</name>
    <message>
        <source>give %1 the task %2</source>
        <translation>%1에 과제 %2 지정</translation>
    </message>
</context>
<context>
    <name>workflow.give_team</name>
    <message>
        <source>assign %1 to team %2</source>
        <translation>%1을(를) 팀 %2에 배정</translation>
    </message>
</context>
<context>
    <name>workflow.give_team_too</name>
    <message>
        <source>give it a team too</source>
        <translation>팀도 함께 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_their_task</name>
    <message>
        <source>give the task that has them</source>
        <translation>이를 포함하는 과제를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_times_to_view</name>
    <message>
        <source>name the camera of one of the videos</source>
        <translation>동영상 중 하나의 카메라를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_tracks</name>
    <message>
        <source>give one or more, like --track R=run.csv</source>
        <translation>하나 이상을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_views</name>
    <message>
        <source>give one view or more, like --video A=a.mp4</source>
        <translation>뷰를 하나 이상 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.give_zone_of_task</name>
    <message>
        <source>give the name of one of its zones</source>
        <translation>그 구역 중 하나의 이름을 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.guidance_of_view</name>
    <message>
        <source>guidance in view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;의 추적 지침</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_found</name>
    <message>
        <source>it found robot &apos;%1&apos; in only %2 of the frames in which it should be visible, and the other positions are not checked by a second view</source>
        <translation>로봇 &apos;%1&apos;이(가) 보여야 할 프레임의 %2에서만 찾았으며, 나머지 위치는 두 번째 뷰로 확인되지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_possible</name>
    <message>
        <source>a robot hardly moves at %1 with %2; check units and scale</source>
        <translation>로봇이 %1, %2로 움직이기는 어렵습니다. 단위와 축척을 확인하세요</translation>
    </message>
</context>
<context>
    <name>workflow.has_no_two_views</name>
    <message>
        <source>it does not have two views</source>
        <translation>뷰가 두 개가 아닙니다</translation>
    </message>
</context>
<context>
    <name>workflow.height_above_camera</name>
    <message>
        <source>it is only %1 above the floor, but the points would be at %2</source>
        <translation>카메라는 바닥에서 %1 높이인데 점들은 %2에 있게 됩니다</translation>
    </message>
</context>
<context>
    <name>workflow.image_with_video</name>
    <message>
        <source>one is an image and the other a video</source>
        <translation>하나는 영상 파일이고 다른 하나는 동영상입니다</translation>
    </message>
</context>
<context>
    <name>workflow.images</name>
    <message>
        <source>images &apos;%1&apos;</source>
        <translation>그림 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.images_missing</name>
    <message>
        <source>missing numbers: %1, the first behind %2; their frames count as lost, and the others keep their times</source>
        <translation>빠진 번호: %1개, 첫 번째는 %2 다음입니다. 그 프레임은 손실된 것으로 보고 나머지는 시간을 유지합니다</translation>
    </message>
</context>
<context>
    <name>workflow.images_share_number</name>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; have the same number</source>
        <translation>&apos;%1&apos;과(와) &apos;%2&apos;의 번호가 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.images_without_times</name>
    <message>
        <source>images have no times</source>
        <translation>그림에는 시간이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.import_lens</name>
    <message>
        <source>import the lens calibration of camera %1 from %2</source>
        <translation>%2에서 카메라 %1의 렌즈 가져오기</translation>
    </message>
</context>
<context>
    <name>workflow.import_of_trial</name>
    <message>
        <source>import of trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos; 가져오기</translation>
    </message>
</context>
<context>
    <name>workflow.import_parts</name>
    <message>
        <source>import each of these files as its own trial</source>
        <translation>각 파일을 별도의 시행으로 가져오십시오</translation>
    </message>
</context>
<context>
    <name>workflow.import_roster</name>
    <message>
        <source>import the roster %1</source>
        <translation>명단 %1 가져오기</translation>
    </message>
</context>
<context>
    <name>workflow.import_to_turn</name>
    <message>
        <source>import the video again to measure it as it is shown</source>
        <translation>표시되는 대로 측정하려면 동영상을 다시 가져오십시오</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial</name>
    <message>
        <source>import trial %1</source>
        <translation>시행 %1 가져오기</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial_from</name>
    <message>
        <source>import trial %1 from %2</source>
        <translation>시행 %1을(를) %2에서 가져오기</translation>
    </message>
</context>
<context>
    <name>workflow.interface_of_live_positions</name>
    <message>
        <source>interface &apos;%1&apos; of live positions</source>
        <translation>실시간 위치의 인터페이스 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced</name>
    <message>
        <source>it is interlaced: each frame holds two fields taken one after the other, and each is measured at its own time, with half the lines</source>
        <translation>비월 주사 영상입니다. 각 프레임에는 차례로 찍힌 두 필드가 있으며, 각 필드를 절반의 줄 수로 고유한 시각에 측정합니다</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced_whole</name>
    <message>
        <source>it is interlaced, but was measured by whole frames, of which each shows two moments; import it as a new trial to have each field measured at its own time</source>
        <translation>비월 주사 영상이지만 두 순간이 함께 보이는 전체 프레임 단위로 측정되었습니다. 각 필드를 고유한 시각에 측정하려면 새 시행으로 가져오십시오</translation>
    </message>
</context>
<context>
    <name>workflow.intrinsics_of_camera</name>
    <message>
        <source>intrinsics of camera &apos;%1&apos;</source>
        <translation>카메라 &apos;%1&apos;의 내부 파라미터</translation>
    </message>
</context>
<context>
    <name>workflow.is_being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>녹화 중입니다</translation>
    </message>
</context>
<context>
    <name>workflow.join_or_name_camera</name>
    <message>
        <source>give each view a camera of its own, or join the files of one recording with +, like --video A=1.mp4+2.mp4</source>
        <translation>뷰마다 다른 카메라를 지정하거나 한 녹화의 파일을 +로 이으십시오</translation>
    </message>
</context>
<context>
    <name>workflow.joined_videos</name>
    <message>
        <source>videos &apos;%1&apos;</source>
        <translation>동영상 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.keep_less_before</name>
    <message>
        <source>record fewer seconds before the start, or smaller frames</source>
        <translation>시작 전의 초를 줄이거나 더 작은 프레임으로 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.keeping_pictures</name>
    <message>
        <source>saving the images</source>
        <translation>사진 보관 중</translation>
    </message>
</context>
<context>
    <name>workflow.kept_before_start</name>
    <message>
        <source>only the %1 before the start were kept: %2 of this camera need more than %3</source>
        <translation>시작 전 %1만 보관되었습니다: 이 카메라의 %2에는 %3보다 많은 메모리가 필요합니다</translation>
    </message>
</context>
<context>
    <name>workflow.label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3</source>
        <translation>뷰 &apos;%1&apos;은(는) %2로 녹화되었지만 파일에는 %3로 되어 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.labels_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2 (its file says %3), or view &apos;%4&apos; at %5 (its file says %6); speeds and times are by the file of view &apos;%4&apos;</source>
        <translation>뷰 &apos;%1&apos;은(는) %2로 녹화되었거나(파일에는 %3) 뷰 &apos;%4&apos;이(가) %5로 녹화되었습니다(파일에는 %6). 속도와 시간은 뷰 &apos;%4&apos;의 파일을 따릅니다</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frame</name>
    <message>
        <source>remove the override of frame %1 of %2</source>
        <translation>%2의 프레임 %1을(를) 프로그램에 맡김</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frames</name>
    <message>
        <source>remove the overrides of %1 samples of %2</source>
        <translation>%2의 샘플 %1개의 수동 지정 제거</translation>
    </message>
</context>
<context>
    <name>workflow.leave_one_mat</name>
    <message>
        <source>leave one mat on the floor, and use newer files</source>
        <translation>바닥에 매트를 하나만 남기고 더 새로운 파일을 사용하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.leave_out_trial</name>
    <message>
        <source>remove %1, which recorded nothing</source>
        <translation>녹화된 것이 없는 %1 제외</translation>
    </message>
</context>
<context>
    <name>workflow.lens_at_other_size</name>
    <message>
        <source>its frames are %1, but the lens was calibrated at %2</source>
        <translation>프레임은 %1인데 렌즈는 %2에서 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_columns</name>
    <message>
        <source>The lens calibration at %1 was cropped on both sides to %2, as the markers confirm.</source>
        <translation>%1에서의 렌즈 보정을 양옆을 잘라 %2에 맞췄으며, 마커가 이를 확인합니다.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_rows</name>
    <message>
        <source>The lens calibration at %1 was cropped above and below to %2, as the markers confirm.</source>
        <translation>%1에서의 렌즈 보정을 위아래를 잘라 %2에 맞췄으며, 마커가 이를 확인합니다.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_enlarged</name>
    <message>
        <source>The lens calibration at %1 was fitted to %2 by the markers, which show that the image is enlarged by a factor of %3 (± %4).</source>
        <translation>%1에서의 렌즈 보정을 마커로 %2에 맞췄습니다. 마커에 따르면 이미지가 %3배(± %4) 확대되어 있습니다.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_imported_from</name>
    <message>
        <source>imported from %1</source>
        <translation>%1에서 가져옴</translation>
    </message>
</context>
<context>
    <name>workflow.lens_never_calibrated</name>
    <message>
        <source>The lens of camera &apos;%1&apos; is neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>카메라 &apos;%1&apos;의 렌즈가 보정되지도, 바닥 마커로 결정되지도 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.lens_part_unknown</name>
    <message>
        <source>The lens calibration at %1 was cropped to %2, but the markers do not show whether the image is enlarged as well, so its focal length is known only to %3: calibrate the lens at %2, or use more markers.</source>
        <translation>%1에서의 렌즈 보정을 %2에 맞게 잘랐지만, 이미지가 더 확대되었는지는 마커로 알 수 없어 초점 거리는 %3까지만 알려져 있습니다. %2에서 렌즈를 보정하거나 마커를 더 사용하십시오.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_scaled</name>
    <message>
        <source>The lens calibration at %1 was converted to %2.</source>
        <translation>%1에서의 렌즈 보정을 %2로 변환했습니다.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_turned_either_way</name>
    <message>
        <source>Which way the camera was turned since is not known, so the centre of its images is less certain.</source>
        <translation>그 후 카메라를 어느 쪽으로 돌렸는지 알 수 없어 이미지의 중심이 덜 확실합니다.</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_video</name>
    <message>
        <source>link a lost video</source>
        <translation>잃어버린 동영상 연결</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_videos</name>
    <message>
        <source>link %1 lost videos</source>
        <translation>잃어버린 동영상 %1개 연결</translation>
    </message>
</context>
<context>
    <name>workflow.little_common_time</name>
    <message>
        <source>%1 and %2 long, %3 in common</source>
        <translation>길이 %1와 %2, 공통 %3</translation>
    </message>
</context>
<context>
    <name>workflow.live_positions_to</name>
    <message>
        <source>live positions to %1</source>
        <translation>%1(으)로 보내는 실시간 위치</translation>
    </message>
</context>
<context>
    <name>workflow.live_tracking</name>
    <message>
        <source>live tracking</source>
        <translation>실시간 추적</translation>
    </message>
</context>
<context>
    <name>workflow.look_at_outlines</name>
    <message>
        <source>check the outlines, and set the robot&apos;s colour or keep other objects out of view</source>
        <translation>윤곽을 살펴보고, 로봇의 색을 지정하거나 다른 것이 영상에 들어오지 않게 하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.look_for_lost_videos</name>
    <message>
        <source>search for lost videos</source>
        <translation>잃어버린 동영상 찾기</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in</name>
    <message>
        <source>detecting the board in %1</source>
        <translation>%1에서 보드를 찾는 중</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in_both</name>
    <message>
        <source>detecting the board in %1 and %2</source>
        <translation>%1과(와) %2에서 보드를 찾는 중</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_files</name>
    <message>
        <source>searching for files</source>
        <translation>파일 찾는 중</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_again</name>
    <message>
        <source>detecting the markers again</source>
        <translation>마커를 다시 찾는 중</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_in</name>
    <message>
        <source>detecting the markers in %1</source>
        <translation>%1에서 마커 찾는 중</translation>
    </message>
</context>
<context>
    <name>workflow.looking_through_media</name>
    <message>
        <source>searching the media folder</source>
        <translation>미디어 폴더를 살펴보는 중</translation>
    </message>
</context>
<context>
    <name>workflow.lost_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is lost and is not in the packed project</source>
        <translation>시행 &apos;%2&apos;의 카메라 %1 동영상이 없어 묶은 프로젝트에 들어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.lost_video_not_there</name>
    <message>
        <source>the lost video is not in this folder</source>
        <translation>잃어버린 동영상이 거기 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos</name>
    <message>
        <source>lost videos</source>
        <translation>잃어버린 동영상</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos_not_there</name>
    <message>
        <source>none of the %1 lost videos is in this folder</source>
        <translation>잃어버린 동영상 %1개가 거기 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.made_through_registration</name>
    <message>
        <source>It was made via registration %1 of the project.</source>
        <translation>프로젝트의 정합 %1을(를) 통해 이루어졌습니다.</translation>
    </message>
</context>
<context>
    <name>workflow.made_with_it_already</name>
    <message>
        <source>it already uses that calibration</source>
        <translation>이미 그것으로 만들어졌습니다</translation>
    </message>
</context>
<context>
    <name>workflow.making_hash</name>
    <message>
        <source>computing the hash of %1</source>
        <translation>%1의 해시를 만드는 중</translation>
    </message>
</context>
<context>
    <name>workflow.many_spikes</name>
    <message>
        <source>%1 spikes in %2 positions</source>
        <translation>위치 %2개 중 이상점 %1개</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind</name>
    <message>
        <source>the map is %1 behind, no frame skipped</source>
        <translation>지도 지연 %1, 건너뜀 없음</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind_and_skipping</name>
    <message>
        <source>the map is %1 behind, %2 frames skipped</source>
        <translation>지도 지연 %1, %2개 건너뜀</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spike</name>
    <message>
        <source>mark frame %1 of %2 as a spike</source>
        <translation>%2의 프레임 %1을(를) 이상점으로 지정</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spikes</name>
    <message>
        <source>mark %1 samples of %2 as spikes</source>
        <translation>%2의 샘플 %1개를 이상점으로 지정</translation>
    </message>
</context>
<context>
    <name>workflow.markers_for_camera</name>
    <message>
        <source>markers for camera &apos;%1&apos;</source>
        <translation>카메라 &apos;%1&apos;의 마커</translation>
    </message>
</context>
<context>
    <name>workflow.measure_again</name>
    <message>
        <source>reanalyse %1</source>
        <translation>%1 다시 측정</translation>
    </message>
</context>
<context>
    <name>workflow.measure_check_line</name>
    <message>
        <source>measure the line from end mark to end mark</source>
        <translation>선을 끝 표시에서 끝 표시까지 재십시오</translation>
    </message>
</context>
<context>
    <name>workflow.measure_height</name>
    <message>
        <source>measure its height, enter it and reanalyse</source>
        <translation>높이를 재서 입력하고 다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.measure_it_again</name>
    <message>
        <source>repeat the analysis</source>
        <translation>다시 재십시오</translation>
    </message>
</context>
<context>
    <name>workflow.measured_as_stored</name>
    <message>
        <source>an earlier version measured its frames as stored, but its file says to turn, mirror or stretch them</source>
        <translation>이전 버전은 프레임을 저장된 그대로 측정했지만, 파일은 회전하거나 뒤집거나 늘이도록 지정합니다</translation>
    </message>
</context>
<context>
    <name>workflow.measured_frames</name>
    <message>
        <source>only %1 of the frames give a position</source>
        <translation>프레임의 %1만 위치를 줍니다</translation>
    </message>
</context>
<context>
    <name>workflow.measured_in_part</name>
    <message>
        <source>%1 of %2 were measured; lengths, times and maxima are at least as large as stated</source>
        <translation>%2 중 %1가 측정되었습니다. 길이, 시간, 최댓값은 표시된 값 이상입니다</translation>
    </message>
</context>
<context>
    <name>workflow.metric_named</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>지표 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.more_frame_steps</name>
    <message>
        <source>up to %1 its frames are wrong at %2 more moments in the same way</source>
        <translation>%1까지 %2개의 다른 시점에서도 프레임이 같은 방식으로 잘못되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.moved_since</name>
    <message>
        <source>it was found moved by %1 since the registration that was used</source>
        <translation>사용된 정합 이후 %1 움직인 것이 확인되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.name_another_camera</name>
    <message>
        <source>name another camera that is registered</source>
        <translation>정합된 다른 카메라를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_image_series</name>
    <message>
        <source>give a folder with images such as 000001.png, or a pattern such as FOLDER/%1</source>
        <translation>000001.png 같은 그림이 있는 폴더나 FOLDER/%1 같은 패턴을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_camera</name>
    <message>
        <source>name one of its cameras</source>
        <translation>시행의 카메라 가운데 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_robot</name>
    <message>
        <source>name one of its robots</source>
        <translation>시행의 로봇 가운데 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_one_series</name>
    <message>
        <source>name one of them, like FOLDER/%1</source>
        <translation>FOLDER/%1처럼 그중 하나를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_place_in_pixels</name>
    <message>
        <source>give it in pixels from the frame&apos;s top left corner</source>
        <translation>영상 왼쪽 위 모서리부터 픽셀로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_robot_after_track</name>
    <message>
        <source>give the robot the name of one of them</source>
        <translation>로봇에 그중 하나의 이름을 주십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_time_within_trial</name>
    <message>
        <source>name a time within the trial, in seconds</source>
        <translation>시행 안의 시각을 초로 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.name_two_cameras</name>
    <message>
        <source>name two cameras</source>
        <translation>카메라 두 대를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.nearly_all_beyond_limits</name>
    <message>
        <source>nearly all samples exceed the limits of task &apos;%1&apos;, so the limits were ignored</source>
        <translation>측정값이 거의 모두 과제 &apos;%1&apos;의 한계를 넘어 한계를 적용하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.neither_lens_nor_recording</name>
    <message>
        <source>it has no intrinsics and no recording</source>
        <translation>내부 파라미터도 녹화도 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.never_calibrated</name>
    <message>
        <source>it was never calibrated</source>
        <translation>보정된 적이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.new_project</name>
    <message>
        <source>new project</source>
        <translation>새 프로젝트</translation>
    </message>
</context>
<context>
    <name>workflow.no_address_with_port</name>
    <message>
        <source>it is not an IPv4 address with a port</source>
        <translation>포트가 붙은 IPv4 주소가 아닙니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_gave_picture</name>
    <message>
        <source>no camera delivered a frame</source>
        <translation>어느 카메라도 영상을 보내지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_given</name>
    <message>
        <source>no camera was given</source>
        <translation>카메라가 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_registered</name>
    <message>
        <source>no camera is registered to the floor</source>
        <translation>바닥에 정합된 카메라가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_place</name>
    <message>
        <source>The two analyses have no position in common.</source>
        <translation>두 분석이 함께 측정한 곳이 없습니다.</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_time</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos; do not overlap with a time offset of %3</source>
        <translation>뷰 &apos;%1&apos;과(와) &apos;%2&apos;은(는) 오프셋 %3에서 겹치는 시간이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_counterpart</name>
    <message>
        <source>the other camera has no file of its number</source>
        <translation>다른 카메라에 같은 번호의 파일이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_floor_to_watch</name>
    <message>
        <source>none of its cameras is registered to the floor, so nothing there starts or ends it</source>
        <translation>카메라가 하나도 바닥에 정합되지 않아 바닥의 움직임으로 시작하거나 끝낼 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_image_series</name>
    <message>
        <source>there are no numbered images (PNG, JPEG, TIFF, BMP, WebP) of that name</source>
        <translation>그 이름의 번호 붙은 그림(PNG, JPEG, TIFF, BMP, WebP)이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_live_positions</name>
    <message>
        <source>none of its cameras is registered to the floor, so there are no live positions to send</source>
        <translation>바닥에 정합된 카메라가 없어 보낼 실시간 위치가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_mat_seen</name>
    <message>
        <source>no file shows four or more of its tags</source>
        <translation>어떤 파일에도 태그가 네 개 이상 보이지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_motion</name>
    <message>
        <source>no robot moves in it</source>
        <translation>움직이는 로봇이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_multicast</name>
    <message>
        <source>interface &apos;%1&apos; does not support multicast</source>
        <translation>인터페이스 &apos;%1&apos;은(는) 멀티캐스트를 지원하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_read</name>
    <message>
        <source>no image could be read</source>
        <translation>어떤 사진도 읽지 못했습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_then</name>
    <message>
        <source>the view has no frame at that time</source>
        <translation>그 시각에 뷰의 영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_pixels_no_picture</name>
    <message>
        <source>it needs pixels, or an image to detect the markers in</source>
        <translation>픽셀도 찾아볼 영상도 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_robot</name>
    <message>
        <source>the project has no robot to track</source>
        <translation>프로젝트에 찾을 로봇이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample</name>
    <message>
        <source>the analysis has no sample</source>
        <translation>분석에 샘플이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample_in_group</name>
    <message>
        <source>no sample from %1 to %2 is to be changed</source>
        <translation>%1에서 %2까지 바꿀 샘플이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_socket</name>
    <message>
        <source>the system could not open a socket</source>
        <translation>이 컴퓨터가 소켓을 내주지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_frame</name>
    <message>
        <source>this frame does not exist</source>
        <translation>그런 프레임이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_interface</name>
    <message>
        <source>this computer has no interface of that name</source>
        <translation>이 컴퓨터에 그런 이름의 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_metric</name>
    <message>
        <source>no trial of the project has it</source>
        <translation>이 프로젝트의 어느 시행에도 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_view</name>
    <message>
        <source>the trial has no such view</source>
        <translation>시행에 그런 뷰가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_task_for_gate</name>
    <message>
        <source>gates and zones are a task&apos;s, and none was given</source>
        <translation>게이트와 구역은 과제에 속하는데 과제가 주어지지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_times_in_file</name>
    <message>
        <source>it has no time stamps and states no frame rate</source>
        <translation>타임스탬프가 없고 프레임 속도도 적혀 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_given</name>
    <message>
        <source>no track was given</source>
        <translation>궤적이 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_imported</name>
    <message>
        <source>no track of it was imported</source>
        <translation>그 궤적을 가져오지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_of_that_name</name>
    <message>
        <source>none of its tracks is called &apos;%1&apos;; it has %2</source>
        <translation>&apos;%1&apos;(이)라는 궤적이 없습니다; 있는 것: %2</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_given</name>
    <message>
        <source>no video was given</source>
        <translation>동영상이 지정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_lost</name>
    <message>
        <source>no video of this project is lost</source>
        <translation>이 프로젝트에 잃어버린 동영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.none_of_that_number</name>
    <message>
        <source>camera &apos;%1&apos; has no such number</source>
        <translation>카메라 &apos;%1&apos;에 그 번호가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_in_range</name>
    <message>
        <source>it contains no sample of robot &apos;%1&apos; (%2 to %3)</source>
        <translation>로봇 &apos;%1&apos;의 샘플이 들어 있지 않습니다(%2~%3)</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_there</name>
    <message>
        <source>the robot has no measurement at that time</source>
        <translation>그곳에서 로봇이 측정되지 않아 판단할 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.not_synchronised</name>
    <message>
        <source>it is not synchronised: the same start time as the first view was assumed, and positions of a moving robot are wrong</source>
        <translation>동기화되지 않고 첫 뷰와 함께 시작된 것으로 보았으므로, 움직이는 로봇은 두 뷰가 가리키는 곳에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_in_trial</name>
    <message>
        <source>it is not tracked in trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;에서 추적하지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_yet</name>
    <message>
        <source>it has not been tracked yet</source>
        <translation>아직 추적되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_came</name>
    <message>
        <source>no frame arrived for %1 because %2</source>
        <translation>%1 동안 아무것도 오지 않았습니다. 이유: %2</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_recorded</name>
    <message>
        <source>nothing was recorded</source>
        <translation>아무것도 녹화되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_said_there</name>
    <message>
        <source>that frame has no manual override</source>
        <translation>그곳에는 직접 지정한 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_stands_out</name>
    <message>
        <source>no foreground object was found at pixel %1,%2 at %3</source>
        <translation>%3 무렵 몇 프레임 동안 %1,%2에서 바닥과 구별되는 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_accept</name>
    <message>
        <source>all checks were passed</source>
        <translation>모든 검사를 통과했습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_analyse_again</name>
    <message>
        <source>it has not been tracked yet, so it cannot be reanalysed</source>
        <translation>아직 추적되지 않아 다시 분석할 것이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_do</name>
    <message>
        <source>no action is needed</source>
        <translation>할 일이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_withdraw</name>
    <message>
        <source>leave it as it is</source>
        <translation>그대로 두십시오</translation>
    </message>
</context>
<context>
    <name>workflow.number_files_alike</name>
    <message>
        <source>give as many of each, in the same order, or number their names alike</source>
        <translation>각각 같은 수를 같은 순서로 지정하거나 이름의 번호를 맞추십시오</translation>
    </message>
</context>
<context>
    <name>workflow.number_images_once</name>
    <message>
        <source>give each image a number of its own</source>
        <translation>그림마다 다른 번호를 붙이십시오</translation>
    </message>
</context>
<context>
    <name>workflow.numbers_count_no_frames</name>
    <message>
        <source>their numbers go from %1 to %2, and there are %3 images: they do not count frames</source>
        <translation>번호는 %1부터 %2까지인데 그림은 %3개입니다. 번호가 프레임을 세지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.offsets_of_other_count</name>
    <message>
        <source>the number of views is %1, the number of offsets %2</source>
        <translation>뷰는 %1개, 오프셋은 %2개가 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>workflow.old_calibration</name>
    <message>
        <source>The lens calibration of camera &apos;%1&apos; is %2 days old</source>
        <translation>카메라 &apos;%1&apos;의 렌즈 보정이 %2일 지났습니다</translation>
    </message>
</context>
<context>
    <name>workflow.old_registration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; is %2 days old</source>
        <translation>카메라 &apos;%1&apos;의 바닥 정합이 %2일 지났습니다</translation>
    </message>
</context>
<context>
    <name>workflow.one_follows_something_else</name>
    <message>
        <source>one of them tracks another object, or has moved since its registration</source>
        <translation>그중 하나가 다른 것을 따라가거나 등록된 자리에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_doubled</name>
    <message>
        <source>after %1 a frame repeats the one before, and its time stamps count it as time; later times were corrected</source>
        <translation>%1 이후 프레임 1개가 앞 프레임을 반복하며, 타임스탬프는 이를 시간으로 셉니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_missing</name>
    <message>
        <source>after %1 a frame is missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>%1 이후 타임스탬프에 나타나지 않는 프레임 1개가 빠졌습니다. 로봇이 너무 멀리 이동합니다. 이후의 시간은 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_stood</name>
    <message>
        <source>after %1 the robot rests for a frame and then goes on at the same speed: either the frame repeats the one before and later times are too late, or the robot stopped; times were not corrected</source>
        <translation>%1 이후 로봇이 프레임 1개 동안 서 있다가 같은 속도로 계속 갑니다. 프레임이 앞 프레임을 반복하여 이후의 시간이 그만큼 늦거나, 로봇이 멈춘 것입니다. 시간은 보정되지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.only_frame</name>
    <message>
        <source>its only frame is 0</source>
        <translation>프레임 0뿐입니다</translation>
    </message>
</context>
<context>
    <name>workflow.open_it_or_elsewhere</name>
    <message>
        <source>open it, or choose another folder</source>
        <translation>열거나 다른 폴더를 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.other_sample_judged</name>
    <message>
        <source>another sample was overridden while this one was analysed</source>
        <translation>이 표본을 분석하는 동안 다른 표본이 수동으로 판정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.outside_picture</name>
    <message>
        <source>the position is outside the frame</source>
        <translation>그 위치는 영상 밖에 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.pair_like_files</name>
    <message>
        <source>pair images with images and videos with videos</source>
        <translation>영상은 영상끼리, 동영상은 동영상끼리 짝지으십시오</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_cameras</name>
    <message>
        <source>the relative position of cameras &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>카메라 &apos;%1&apos;과(와) &apos;%2&apos;의 상대 위치</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_one_camera</name>
    <message>
        <source>both are the same camera</source>
        <translation>둘이 같은 카메라입니다</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_other_size</name>
    <message>
        <source>&apos;%1&apos; is %2, but the camera was calibrated at %3</source>
        <translation>&apos;%1&apos;은(는) %2인데 카메라는 %3에서 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.paired_files</name>
    <message>
        <source>the files of the two cameras</source>
        <translation>두 카메라의 파일</translation>
    </message>
</context>
<context>
    <name>workflow.passed_cameras</name>
    <message>
        <source>no camera was found moved</source>
        <translation>움직인 것으로 확인된 카메라가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_decoding</name>
    <message>
        <source>all frames could be decoded</source>
        <translation>모든 프레임을 디코딩할 수 있었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_frames</name>
    <message>
        <source>the frames came at regular intervals</source>
        <translation>프레임이 일정한 간격으로 들어왔습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_lens</name>
    <message>
        <source>the lenses are calibrated, or estimated from the floor&apos;s markers</source>
        <translation>렌즈가 보정되었거나 바닥 마커에서 추정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_motion</name>
    <message>
        <source>speeds and accelerations are possible</source>
        <translation>속도와 가속도가 가능한 값입니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_names</name>
    <message>
        <source>no robot could be another one</source>
        <translation>다른 로봇일 수 있는 로봇이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_precision</name>
    <message>
        <source>positions are precise for the run&apos;s extent</source>
        <translation>주행 범위에 비해 위치가 정밀합니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_results</name>
    <message>
        <source>the stored results are as computed</source>
        <translation>저장된 결과가 계산된 것과 같습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_scatter</name>
    <message>
        <source>positions scatter little for the run&apos;s extent; errors that change slowly do not show, and are covered only where the accuracy of the source is given</source>
        <translation>주행 범위에 비해 위치의 흩어짐이 작습니다. 천천히 변하는 오차는 드러나지 않으며, 원본의 정확도를 입력한 경우에만 포함됩니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_spikes</name>
    <message>
        <source>few positions are spikes</source>
        <translation>이상점인 위치가 적습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_synchronisation</name>
    <message>
        <source>the views are synchronised</source>
        <translation>뷰가 동기화되어 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_time</name>
    <message>
        <source>the robots were measured all the time</source>
        <translation>로봇이 내내 측정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.passed_views</name>
    <message>
        <source>the views agree</source>
        <translation>뷰가 서로 일치합니다</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_here</name>
    <message>
        <source>1 frame was lost because this computer or its disk was too slow</source>
        <translation>이 컴퓨터나 디스크가 너무 느려 영상 1개 누락</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_on_wire</name>
    <message>
        <source>1 frame was lost between the camera and this program</source>
        <translation>카메라와 이 프로그램 사이에서 영상 1개 누락</translation>
    </message>
</context>
<context>
    <name>workflow.picture_made_too_late</name>
    <message>
        <source>1 frame was lost: this computer was too slow to generate it in time</source>
        <translation>이 컴퓨터가 너무 느려 제때 만들지 못해 영상 1개 누락</translation>
    </message>
</context>
<context>
    <name>workflow.picture_size_not_known</name>
    <message>
        <source>the size of its images is not known</source>
        <translation>영상의 크기를 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_here</name>
    <message>
        <source>%1 frames were lost because this computer or its disk was too slow</source>
        <translation>이 컴퓨터나 디스크가 너무 느려 영상 %1개 누락</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_on_wire</name>
    <message>
        <source>%1 frames were lost between the camera and this program</source>
        <translation>카메라와 이 프로그램 사이에서 영상 %1개 누락</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_made_too_late</name>
    <message>
        <source>%1 frames were lost: this computer was too slow to generate them in time</source>
        <translation>이 컴퓨터가 너무 느려 제때 만들지 못해 영상 %1개 누락</translation>
    </message>
</context>
<context>
    <name>workflow.point_out_whole_robot</name>
    <message>
        <source>point it out where the whole robot is visible and moving</source>
        <translation>로봇 전체가 보이고 움직이는 곳에서 가리키십시오</translation>
    </message>
</context>
<context>
    <name>workflow.positions_change</name>
    <message>
        <source>Positions change by %1 RMS, at most by %2 (at %3).</source>
        <translation>위치가 %1 RMS, 최대 %2 바뀝니다 (%3).</translation>
    </message>
</context>
<context>
    <name>workflow.positions_rounded</name>
    <message>
        <source>rounded to %1</source>
        <translation>%1로 반올림됨</translation>
    </message>
</context>
<context>
    <name>workflow.positions_uncertain</name>
    <message>
        <source>its positions are known to ±%1 only, in a run over %2</source>
        <translation>위치가 ±%1까지만 알려져 있으며 주행 범위는 %2입니다</translation>
    </message>
</context>
<context>
    <name>workflow.project_file_gone</name>
    <message>
        <source>the project file no longer exists</source>
        <translation>프로젝트 파일이 더 이상 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.project_lost</name>
    <message>
        <source>the project file was deleted, renamed or replaced; recording continues, and its contents will be saved at the end</source>
        <translation>프로젝트 파일이 삭제되거나 이름이 바뀌거나 교체되었습니다. 녹화는 계속되며 끝날 때 그 내용을 구해 냅니다</translation>
    </message>
</context>
<context>
    <name>workflow.project_rescued</name>
    <message>
        <source>the project file was deleted, renamed or replaced; its contents were saved in &apos;%1&apos;, the project from now on</source>
        <translation>그사이 프로젝트 파일이 삭제되거나 이름이 바뀌거나 교체되었습니다. 그 내용은 &apos;%1&apos;에 구해 두었으며 이제부터 이것이 프로젝트입니다</translation>
    </message>
</context>
<context>
    <name>workflow.put_axes_elsewhere</name>
    <message>
        <source>change the world axes of layout %1</source>
        <translation>배치 %1의 축 옮기기</translation>
    </message>
</context>
<context>
    <name>workflow.put_original_or_import</name>
    <message>
        <source>restore the original file, or import this one as another trial</source>
        <translation>원래 파일을 되돌려 놓거나 이 파일을 다른 시행으로 가져오세요</translation>
    </message>
</context>
<context>
    <name>workflow.put_plate_on_it</name>
    <message>
        <source>put a plate of another colour on it, or set its true colour</source>
        <translation>다른 색 판을 얹거나 실제 색을 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.range_is_reversed</name>
    <message>
        <source>its start %1 is not before its end %2</source>
        <translation>시작 %1이(가) 끝 %2보다 앞서지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.range_of_trial</name>
    <message>
        <source>range of trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;의 구간</translation>
    </message>
</context>
<context>
    <name>workflow.range_outside_trial</name>
    <message>
        <source>%1 to %2 is not within the trial&apos;s time</source>
        <translation>%1~%2은(는) 시행의 시간 안에 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.range_without_sample</name>
    <message>
        <source>it contains no sample</source>
        <translation>샘플이 들어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.rate_and_times</name>
    <message>
        <source>camera &apos;%1&apos; was given both a frame rate and frame times</source>
        <translation>카메라 &apos;%1&apos;에 프레임 속도와 프레임 시간이 모두 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.rate_is_assumed</name>
    <message>
        <source>no recording shows it, so 30 frames/s are simulated</source>
        <translation>보여 주는 녹화가 없어 30 프레임/s로 시뮬레이션합니다</translation>
    </message>
</context>
<context>
    <name>workflow.rate_of_header</name>
    <message>
        <source>its header states an even %1</source>
        <translation>헤더에 일정한 %1이라고 적혀 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.reanalyse_tracks</name>
    <message>
        <source>reanalyse them with: odograph track PROJECT TRIAL --again</source>
        <translation>다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.record</name>
    <message>
        <source>record %1</source>
        <translation>%1 녹화</translation>
    </message>
</context>
<context>
    <name>workflow.record_for_longer</name>
    <message>
        <source>record again, for longer</source>
        <translation>더 길게 다시 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.record_it_again</name>
    <message>
        <source>record it again</source>
        <translation>다시 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.record_to_faster_disk</name>
    <message>
        <source>record to a faster disk</source>
        <translation>더 빠른 디스크에 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.recorded_at_another_size</name>
    <message>
        <source>The newest recording of camera &apos;%1&apos; is %2, its lens was calibrated at %3</source>
        <translation>카메라 &apos;%1&apos;의 최신 녹화는 %2이고 렌즈는 %3에서 보정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.recording</name>
    <message>
        <source>recording</source>
        <translation>녹화 중</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_trial</name>
    <message>
        <source>recording of trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos; 녹화</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_view</name>
    <message>
        <source>recording of view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;의 녹화</translation>
    </message>
</context>
<context>
    <name>workflow.reference_not_calibrated</name>
    <message>
        <source>camera &apos;%1&apos; was registered without a lens calibration: register it again with it</source>
        <translation>카메라 &apos;%1&apos;은(는) 렌즈 보정 없이 정합되었습니다. 렌즈 보정으로 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_a_camera</name>
    <message>
        <source>register the cameras first</source>
        <translation>먼저 카메라를 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_both_again</name>
    <message>
        <source>register both again and reanalyse</source>
        <translation>둘 다 다시 정합하고 다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera</name>
    <message>
        <source>register camera %1</source>
        <translation>카메라 %1 정합</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_again</name>
    <message>
        <source>register camera %1 again</source>
        <translation>카메라 %1 다시 정합</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_anew</name>
    <message>
        <source>register the camera again</source>
        <translation>카메라를 다시 등록하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_through</name>
    <message>
        <source>register camera %1 via camera %2</source>
        <translation>카메라 %2을(를) 통해 카메라 %1 정합</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_again</name>
    <message>
        <source>register the cameras again</source>
        <translation>카메라를 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_together</name>
    <message>
        <source>register the cameras of layout %1 jointly</source>
        <translation>배치 %1의 카메라 함께 정합</translation>
    </message>
</context>
<context>
    <name>workflow.register_if_other_part</name>
    <message>
        <source>if the camera shows another part of the scene at that size, register it again in a frame of this video</source>
        <translation>그 크기에서 카메라가 장면의 다른 부분을 보여 준다면 이 동영상의 프레임에서 카메라를 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_its_video</name>
    <message>
        <source>register the camera in a frame of this video, to which its lens calibration is then fitted</source>
        <translation>이 동영상의 프레임에서 카메라를 정합하십시오. 그러면 렌즈 보정이 거기에 맞춰집니다</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_this_video</name>
    <message>
        <source>register the camera again in a frame of this video and reanalyse</source>
        <translation>이 동영상의 프레임에서 카메라를 다시 정합하고 다시 분석하세요</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_again</name>
    <message>
        <source>register it again.</source>
        <translation>다시 정합하십시오.</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_first</name>
    <message>
        <source>register it first, with markers or via another camera</source>
        <translation>먼저 마커나 다른 카메라를 통해 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_moved_again</name>
    <message>
        <source>register it again and reanalyse</source>
        <translation>다시 정합하고 다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_do_not_send</name>
    <message>
        <source>run odograph register for one of them, or leave --ssl-vision out</source>
        <translation>그중 하나를 정합하거나 위치를 보내지 마십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_give_seconds</name>
    <message>
        <source>register one of them, or give the seconds to record instead</source>
        <translation>그중 하나를 정합하거나, 대신 녹화할 초 수를 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_through_it_again</name>
    <message>
        <source>register it via that camera again</source>
        <translation>그 카메라를 통해 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.register_upright</name>
    <message>
        <source>register the camera again</source>
        <translation>카메라를 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.registered_as_stored</name>
    <message>
        <source>its frames are turned or mirrored as its file says, but an earlier version registered camera &apos;%1&apos;, perhaps by frames as stored</source>
        <translation>프레임은 파일에 따라 회전되거나 뒤집히지만, 카메라 &apos;%1&apos;은(는) 이전 버전에서, 아마도 저장된 그대로의 프레임으로 정합되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registered_at_another_size</name>
    <message>
        <source>the image is %1, the camera was registered at %2</source>
        <translation>영상은 %1, 카메라는 %2에서 정합되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registered_before_calibration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; was made before its lens was calibrated</source>
        <translation>카메라 &apos;%1&apos;의 바닥 정합은 렌즈 보정 전에 이루어졌습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registered_on_other_floor</name>
    <message>
        <source>it is registered on another floor, &apos;%1&apos;, and left out</source>
        <translation>다른 바닥 &apos;%1&apos;에 정합되어 있어 제외합니다</translation>
    </message>
</context>
<context>
    <name>workflow.registered_through_another</name>
    <message>
        <source>it was registered via another camera</source>
        <translation>다른 카메라를 통해 정합되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registered_with_other_lens</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; uses another lens calibration than the current one</source>
        <translation>카메라 &apos;%1&apos;의 바닥 정합은 적용 중인 것과 다른 렌즈 보정으로 이루어졌습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registration</name>
    <message>
        <source>registration %1</source>
        <translation>정합 %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_converted</name>
    <message>
        <source>its frames are %1, so the camera&apos;s registration at %2 was converted</source>
        <translation>프레임이 %1이므로 %2에서의 카메라 정합을 변환했습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registration_counts_as_exact</name>
    <message>
        <source>its uncertainty is not known, so it counts as exact</source>
        <translation>불확도를 알 수 없어 정확한 것으로 봅니다</translation>
    </message>
</context>
<context>
    <name>workflow.registration_in_older_axes</name>
    <message>
        <source>it has other axes: those of its layout were changed since</source>
        <translation>축이 다릅니다. 그 뒤로 배치의 축이 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of</name>
    <message>
        <source>registration of %1</source>
        <translation>%1의 정합</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of_camera</name>
    <message>
        <source>registration of camera &apos;%1&apos;</source>
        <translation>카메라 &apos;%1&apos;의 정합</translation>
    </message>
</context>
<context>
    <name>workflow.registration_through</name>
    <message>
        <source>registration of camera &apos;%1&apos; via &apos;%2&apos;</source>
        <translation>&apos;%2&apos;을(를) 통한 카메라 &apos;%1&apos;의 정합</translation>
    </message>
</context>
<context>
    <name>workflow.registration_with_lens_in_force</name>
    <message>
        <source>registration of camera &apos;%1&apos; with the current lens calibration</source>
        <translation>적용 중인 렌즈를 쓴 카메라 &apos;%1&apos;의 정합</translation>
    </message>
</context>
<context>
    <name>workflow.remove_cause</name>
    <message>
        <source>remove the cause and reanalyse, or record it again</source>
        <translation>원인을 없애고 다시 분석하거나 다시 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.remove_for_good</name>
    <message>
        <source>remove %1 for good</source>
        <translation>%1 영구 삭제</translation>
    </message>
</context>
<context>
    <name>workflow.remove_strays</name>
    <message>
        <source>remove stray files</source>
        <translation>소속 없는 파일 제거</translation>
    </message>
</context>
<context>
    <name>workflow.removing</name>
    <message>
        <source>removing %1</source>
        <translation>%1 삭제 중</translation>
    </message>
</context>
<context>
    <name>workflow.rename_trial</name>
    <message>
        <source>rename trial %1 to %2</source>
        <translation>시행 이름 변경: %1 → %2</translation>
    </message>
</context>
<context>
    <name>workflow.replaced_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is outside the media folder and has changed since; it is not in the packed project</source>
        <translation>시행 &apos;%2&apos;의 카메라 %1 동영상은 다른 곳에 있고 예전과 다른 파일이어서 묶은 프로젝트에 들어 있지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.results_changed</name>
    <message>
        <source>its results differ from those of its analysis</source>
        <translation>결과가 분석에서 나온 값과 다릅니다</translation>
    </message>
</context>
<context>
    <name>workflow.robot</name>
    <message>
        <source>robot</source>
        <translation>로봇</translation>
    </message>
</context>
<context>
    <name>workflow.robot_given_two_tracks</name>
    <message>
        <source>robot &apos;%1&apos; was given two tracks</source>
        <translation>로봇 &apos;%1&apos;에 궤적이 두 개 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.robot_in_view</name>
    <message>
        <source>robot &apos;%1&apos; in view &apos;%2&apos;</source>
        <translation>뷰 &apos;%2&apos;의 로봇 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.robot_is_new</name>
    <message>
        <source>robot &apos;%1&apos; is new</source>
        <translation>로봇 &apos;%1&apos;은(는) 새 로봇입니다</translation>
    </message>
</context>
<context>
    <name>workflow.robot_leaps</name>
    <message>
        <source>after %1 the robot is suddenly %2 away: frames are missing for an unknown time, or another object was tracked; nothing was measured across it</source>
        <translation>%1 이후 로봇이 갑자기 %2 떨어진 곳에 있습니다. 알 수 없는 시간 동안 프레임이 빠졌거나 다른 물체가 추적되었습니다. 그 사이는 측정하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.robot_not_tracked</name>
    <message>
        <source>robot &apos;%1&apos; was not tracked in it, only %2</source>
        <translation>로봇 &apos;%1&apos;은(는) 추적되지 않았고, 추적된 것은 %2입니다</translation>
    </message>
</context>
<context>
    <name>workflow.robot_pointed_out</name>
    <message>
        <source>robot &apos;%1&apos; pointed out in view &apos;%2&apos;</source>
        <translation>뷰 &apos;%2&apos;에서 가리킨 로봇 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.roster_line</name>
    <message>
        <source>line %1</source>
        <translation>%1행</translation>
    </message>
</context>
<context>
    <name>workflow.run_calibrate</name>
    <message>
        <source>calibrate its lens, or import its intrinsics</source>
        <translation>렌즈를 보정하거나 내부 파라미터를 가져오십시오</translation>
    </message>
</context>
<context>
    <name>workflow.run_in_older_axes</name>
    <message>
        <source>it has other axes: those of layout &apos;%1&apos; were changed after it was analysed</source>
        <translation>축이 다릅니다. 분석한 뒤에 배치 &apos;%1&apos;의 축이 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_first</name>
    <message>
        <source>run odograph track first</source>
        <translation>먼저 추적하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_without_again</name>
    <message>
        <source>run odograph track without --again first</source>
        <translation>먼저 시행의 동영상을 추적하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.runs_in_other_axes</name>
    <message>
        <source>it has other axes (layout &apos;%1&apos;) than trial &apos;%2&apos; (layout &apos;%3&apos;)</source>
        <translation>시도 &apos;%2&apos;(배치 &apos;%3&apos;)와 축이 다릅니다(배치 &apos;%1&apos;)</translation>
    </message>
</context>
<context>
    <name>workflow.say_it_again</name>
    <message>
        <source>repeat it for frame %1</source>
        <translation>프레임 %1에 대해 다시 지정하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.scene_far_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered</source>
        <translation>카메라를 정합한 이미지에 비해 장면이 %1 어긋나 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.scene_mirrored</name>
    <message>
        <source>it is mirrored against the image by which its camera was registered</source>
        <translation>카메라를 정합한 이미지에 비해 좌우가 반전되어 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.scene_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered, so the camera was moved, and the stated errors were increased by that</source>
        <translation>카메라를 정합한 이미지에 비해 장면이 %1 어긋나 있어 카메라가 움직인 것이며, 표시된 오차를 그만큼 늘렸습니다</translation>
    </message>
</context>
<context>
    <name>workflow.scene_turned</name>
    <message>
        <source>it is turned by %1 against the image by which its camera was registered</source>
        <translation>카메라를 정합한 이미지에 비해 %1 회전되어 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.scene_zoomed</name>
    <message>
        <source>it shows the scene %1 times as large as the image by which its camera was registered</source>
        <translation>카메라를 정합한 이미지보다 장면이 %1배로 보입니다</translation>
    </message>
</context>
<context>
    <name>workflow.see_flags_by_hand</name>
    <message>
        <source>see the flags by_hand in odograph export</source>
        <translation>검토에는 수동으로 정한 표본이 표시되어 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.see_revisions</name>
    <message>
        <source>see the list of its revisions</source>
        <translation>있는 것은 버전 목록에서 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.set_range</name>
    <message>
        <source>set the range of %1</source>
        <translation>%1의 구간 설정</translation>
    </message>
</context>
<context>
    <name>workflow.settling_names</name>
    <message>
        <source>assigning names to the robots</source>
        <translation>로봇 구별 중</translation>
    </message>
</context>
<context>
    <name>workflow.several_files_in_one</name>
    <message>
        <source>it consists of several video files joined byte by byte, so the time between them is unknown</source>
        <translation>여러 영상 파일이 바이트 단위로 이어진 것이어서 그 사이의 시간을 알 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.several_image_series</name>
    <message>
        <source>the folder holds several series: %1 and %2</source>
        <translation>폴더에 여러 시리즈가 있습니다: %1, %2</translation>
    </message>
</context>
<context>
    <name>workflow.several_robots</name>
    <message>
        <source>it has several robots</source>
        <translation>로봇이 여럿입니다</translation>
    </message>
</context>
<context>
    <name>workflow.show_mat</name>
    <message>
        <source>print the mat, lay it where the cameras see all of it, and record again</source>
        <translation>매트를 인쇄해 카메라에 전체가 보이는 곳에 놓고 다시 녹화하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and evenly lit, and check --pattern and --board</source>
        <translation>보드 전체를 평평하고 선명하고 고르게 밝게 보여 주고 무늬와 크기를 확인하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.simulated_robot_not_found</name>
    <message>
        <source>the simulated robot was not found in the simulated views</source>
        <translation>시뮬레이션한 뷰에서 로봇을 찾지 못했습니다</translation>
    </message>
</context>
<context>
    <name>workflow.simulating_run</name>
    <message>
        <source>simulating run %1 of %2</source>
        <translation>주행 %2개 중 %1번째 시뮬레이션 중</translation>
    </message>
</context>
<context>
    <name>workflow.slow_errors_not_seen</name>
    <message>
        <source>errors that change slowly are not included</source>
        <translation>천천히 변하는 오차는 포함되지 않습니다</translation>
    </message>
</context>
<context>
    <name>workflow.sought_when_tracked</name>
    <message>
        <source>%1; tracking tries again</source>
        <translation>%1; 추적할 때 다시 시도합니다</translation>
    </message>
</context>
<context>
    <name>workflow.sound_of_slow_motion</name>
    <message>
        <source>sound cannot be compared in clips that play in slow motion</source>
        <translation>슬로 모션으로 재생되는 클립에서는 소리를 비교할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.sound_unreadable</name>
    <message>
        <source>the sound of view &apos;%1&apos; cannot be read (%2)</source>
        <translation>뷰 &apos;%1&apos;의 소리를 읽을 수 없습니다 (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.spikes_change</name>
    <message>
        <source>Spikes: %1 instead of %2.</source>
        <translation>이상점: %2개 대신 %1개.</translation>
    </message>
</context>
<context>
    <name>workflow.stamps_too_dense</name>
    <message>
        <source>its time stamps mean %1, which no camera takes</source>
        <translation>타임스탬프대로라면 %1인데, 그런 카메라는 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.start_otherwise</name>
    <message>
        <source>start it in another manner, such as by motion</source>
        <translation>움직임 등 다른 방법으로 시작하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.stopped_before_first_frame</name>
    <message>
        <source>it was stopped before the first frame came</source>
        <translation>첫 프레임이 오기 전에 중지되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.synchronisation_of_view</name>
    <message>
        <source>synchronisation of view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;의 동기화</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_again</name>
    <message>
        <source>synchronise the views again and reanalyse</source>
        <translation>뷰를 다시 동기화하고 다시 분석하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_for_offset</name>
    <message>
        <source>synchronise it again with odograph trial set --sync auto, or enter the time offset</source>
        <translation>다시 동기화하거나(시행 ▸ 동기화…) 거기에서 시간차를 입력하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_trial</name>
    <message>
        <source>synchronise %1: %2 (before: %3)</source>
        <translation>%1 동기화: %2 (이전: %3)</translation>
    </message>
</context>
<context>
    <name>workflow.take_fewer_cameras</name>
    <message>
        <source>close other programs, or use fewer such cameras at once</source>
        <translation>다른 프로그램을 닫거나 그런 카메라를 더 적게 쓰십시오</translation>
    </message>
</context>
<context>
    <name>workflow.take_over_set_up</name>
    <message>
        <source>copy the set-up of %1</source>
        <translation>%1의 설정 이어받기</translation>
    </message>
</context>
<context>
    <name>workflow.taking_over_set_up</name>
    <message>
        <source>copying the set-up</source>
        <translation>설정 이어받는 중</translation>
    </message>
</context>
<context>
    <name>workflow.task_was_changed</name>
    <message>
        <source>its task changed during the analysis</source>
        <translation>측정하는 동안 과제가 바뀌었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_course</name>
    <message>
        <source>task &apos;%1&apos; has neither a path nor gates to drive along</source>
        <translation>과제 &apos;%1&apos;에는 따라갈 경로도 게이트도 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_start</name>
    <message>
        <source>task &apos;%1&apos; has no start gate</source>
        <translation>과제 &apos;%1&apos;에 출발 게이트가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_zone</name>
    <message>
        <source>task &apos;%1&apos; has no zone &apos;%2&apos;</source>
        <translation>과제 &apos;%1&apos;에 구역 &apos;%2&apos;이(가) 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.team_of_another_class</name>
    <message>
        <source>it belongs to class %1, not to class %2</source>
        <translation>학급 %2이(가) 아니라 학급 %1에 속합니다</translation>
    </message>
</context>
<context>
    <name>workflow.through_itself</name>
    <message>
        <source>a camera cannot be registered via itself</source>
        <translation>카메라를 자기 자신을 통해 정합할 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.time_of_trial</name>
    <message>
        <source>%1 of trial &apos;%2&apos;</source>
        <translation>시행 &apos;%2&apos;의 %1</translation>
    </message>
</context>
<context>
    <name>workflow.times_count_from</name>
    <message>
        <source>its times start at %1</source>
        <translation>시간은 %1부터 셈</translation>
    </message>
</context>
<context>
    <name>workflow.times_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; was given two tables of frame times</source>
        <translation>카메라 &apos;%1&apos;에 프레임 시간 표가 두 개 지정되었습니다</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_no_view</name>
    <message>
        <source>there are frame times for camera &apos;%1&apos;, but no video of it</source>
        <translation>카메라 &apos;%1&apos;의 프레임 시간은 있지만 동영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_other_count</name>
    <message>
        <source>it has %1 times, but the video of view &apos;%2&apos; has %3 frames</source>
        <translation>시간은 %1개인데 뷰 &apos;%2&apos;의 동영상은 %3프레임입니다</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_view</name>
    <message>
        <source>time stamps of view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;의 타임스탬프</translation>
    </message>
</context>
<context>
    <name>workflow.track</name>
    <message>
        <source>track %1</source>
        <translation>%1 추적</translation>
    </message>
</context>
<context>
    <name>workflow.track_it_first</name>
    <message>
        <source>track it first</source>
        <translation>먼저 추적하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.track_of_file</name>
    <message>
        <source>the file&apos;s track &apos;%1&apos;</source>
        <translation>파일의 궤적 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_another</name>
    <message>
        <source>track it, or choose another</source>
        <translation>추적하거나 다른 것을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_with_robot</name>
    <message>
        <source>track it, or choose another with --robot</source>
        <translation>추적하거나 다른 것을 고르십시오</translation>
    </message>
</context>
<context>
    <name>workflow.track_those_seen</name>
    <message>
        <source>track only the robots that are in view (--robot)</source>
        <translation>영상에 있는 로봇만 추적하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.tracking</name>
    <message>
        <source>tracking</source>
        <translation>추적</translation>
    </message>
</context>
<context>
    <name>workflow.tracking_picture</name>
    <message>
        <source>tracking, frame %1 of %2</source>
        <translation>추적 중, 영상 %2장 중 %1</translation>
    </message>
</context>
<context>
    <name>workflow.tracks_were_imported</name>
    <message>
        <source>its tracks were imported, so it has no video to track</source>
        <translation>궤적을 가져온 것이라 추적할 동영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.trial_being_recorded</name>
    <message>
        <source>trial &apos;%1&apos; is being recorded</source>
        <translation>시행 &apos;%1&apos;을(를) 녹화하는 중입니다</translation>
    </message>
</context>
<context>
    <name>workflow.trial_is_there</name>
    <message>
        <source>the project already has a trial of that name</source>
        <translation>프로젝트에 같은 이름의 시행이 있습니다</translation>
    </message>
</context>
<context>
    <name>workflow.trial_left_out</name>
    <message>
        <source>nothing of it had reached the disk, and it was removed</source>
        <translation>디스크에 남은 것이 없어 제외됩니다</translation>
    </message>
</context>
<context>
    <name>workflow.turn_cameras_to_floor</name>
    <message>
        <source>turn the cameras to the same floor, and register them again</source>
        <translation>카메라를 같은 바닥으로 돌리고 다시 정합하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.turn_or_flash</name>
    <message>
        <source>turn the robot, or flash the room light, in view of both cameras</source>
        <translation>두 카메라가 보는 곳에서 로봇을 돌리거나 실내 조명을 깜박이십시오</translation>
    </message>
</context>
<context>
    <name>workflow.two_mats</name>
    <message>
        <source>the files show mats of different paper</source>
        <translation>파일에 종이가 다른 매트가 보입니다</translation>
    </message>
</context>
<context>
    <name>workflow.two_views</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>뷰 &apos;%1&apos;과(와) &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_files</name>
    <message>
        <source>%1 files of the first camera cannot be paired with %2 of the second one</source>
        <translation>첫 카메라의 파일 %1개를 둘째 카메라의 %2개와 짝지을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_rates</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 및 %2</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_frame_rate</name>
    <message>
        <source>its frame rate is not between 0.1 and 100,000 frames a second</source>
        <translation>프레임 속도가 초당 0.1~100,000 프레임이 아닙니다</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_length</name>
    <message>
        <source>the duration must be above zero and at most a day</source>
        <translation>길이가 0이거나 하루를 넘습니다</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_pre_roll</name>
    <message>
        <source>the pre-roll must be from 0 s to 30 s</source>
        <translation>사전 녹화는 0 s에서 30 s 사이여야 합니다</translation>
    </message>
</context>
<context>
    <name>workflow.use_as_it_is</name>
    <message>
        <source>use the results as they are</source>
        <translation>결과를 그대로 사용하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.use_earlier_registration</name>
    <message>
        <source>if it moved before this trial, register it again and reanalyse</source>
        <translation>이 시행 전에 움직였다면 다시 정합하고 다시 분석하세요</translation>
    </message>
</context>
<context>
    <name>workflow.use_frame</name>
    <message>
        <source>use frame %1 of %2</source>
        <translation>%2의 프레임 %1 사용</translation>
    </message>
</context>
<context>
    <name>workflow.use_frames</name>
    <message>
        <source>use %1 samples of %2</source>
        <translation>%2의 샘플 %1개 사용</translation>
    </message>
</context>
<context>
    <name>workflow.use_original_or_register</name>
    <message>
        <source>use the file as the camera wrote it, or register the camera again in a frame of this video</source>
        <translation>카메라가 기록한 그대로의 파일을 사용하거나, 이 동영상의 프레임에서 카메라를 다시 정합하세요</translation>
    </message>
</context>
<context>
    <name>workflow.use_time_before</name>
    <message>
        <source>use the time before that only</source>
        <translation>그 이전 시간만 사용하십시오</translation>
    </message>
</context>
<context>
    <name>workflow.verdict_on</name>
    <message>
        <source>verdict on trial &apos;%1&apos;</source>
        <translation>시행 &apos;%1&apos;에 대한 판정</translation>
    </message>
</context>
<context>
    <name>workflow.video</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>동영상 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.video_converted</name>
    <message>
        <source>one frame in %1 repeats the one before, because the video was converted to a higher frame rate; its frames were given the times at which they were taken</source>
        <translation>비디오가 더 높은 프레임률로 변환되어 프레임 %1개 중 1개가 앞 프레임을 반복합니다. 프레임에는 촬영된 시간이 주어졌습니다</translation>
    </message>
</context>
<context>
    <name>workflow.video_without_picture</name>
    <message>
        <source>the video has no frame</source>
        <translation>동영상에 영상이 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.view</name>
    <message>
        <source>view &apos;%1&apos;</source>
        <translation>뷰 &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.view_begun_later</name>
    <message>
        <source>%1 %2 later</source>
        <translation>%1 %2 늦음</translation>
    </message>
</context>
<context>
    <name>workflow.view_ended_early</name>
    <message>
        <source>it ended early because %1</source>
        <translation>일찍 끝났습니다. 이유: %1</translation>
    </message>
</context>
<context>
    <name>workflow.view_is_kept</name>
    <message>
        <source>%1 of %2 view were saved, at most the last second is missing</source>
        <translation>뷰 %2개의 %1가 보존됨, 최대 마지막 1초만 빠짐</translation>
    </message>
</context>
<context>
    <name>workflow.view_left_out</name>
    <message>
        <source>it recorded nothing and was left out</source>
        <translation>녹화된 것이 없어 제외됩니다</translation>
    </message>
</context>
<context>
    <name>workflow.view_not_synchronised</name>
    <message>
        <source>%1 not synchronised</source>
        <translation>%1 동기화되지 않음</translation>
    </message>
</context>
<context>
    <name>workflow.view_without_sound</name>
    <message>
        <source>view &apos;%1&apos; has no sound</source>
        <translation>뷰 &apos;%1&apos;에 소리가 없습니다</translation>
    </message>
</context>
<context>
    <name>workflow.views_are_kept</name>
    <message>
        <source>%1 of %2 views were saved, at most the last second is missing</source>
        <translation>뷰 %2개의 %1가 보존됨, 최대 마지막 1초만 빠짐</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict</name>
    <message>
        <source>in %1 of %2 frames the views contradict each other</source>
        <translation>영상 %2개 중 %1개에서 뷰들이 서로 모순됩니다</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict_by</name>
    <message>
        <source>the views contradict each other by %1</source>
        <translation>뷰들이 서로 %1 어긋납니다</translation>
    </message>
</context>
<context>
    <name>workflow.views_far_apart</name>
    <message>
        <source>in %1 of %2 frames the views show it at positions far apart</source>
        <translation>영상 %2개 중 %1개에서 뷰들이 서로 멀리 떨어진 곳을 가리킵니다</translation>
    </message>
</context>
<context>
    <name>workflow.views_put_it_apart</name>
    <message>
        <source>their floor positions differ by %1</source>
        <translation>위치가 %1 차이 납니다</translation>
    </message>
</context>
<context>
    <name>workflow.waited_for_disk</name>
    <message>
        <source>frames waited up to %1 for the disk, and none was lost</source>
        <translation>영상이 디스크를 최대 %1 기다렸으나 누락은 없음</translation>
    </message>
</context>
<context>
    <name>workflow.waiting_for_start</name>
    <message>
        <source>waiting for the start</source>
        <translation>시작을 기다리는 중</translation>
    </message>
</context>
<context>
    <name>workflow.was_not_accepted</name>
    <message>
        <source>nobody accepted it</source>
        <translation>아무도 승인하지 않았습니다</translation>
    </message>
</context>
<context>
    <name>workflow.why_views_contradict</name>
    <message>
        <source>a camera has moved since its registration, the views are not synchronised, or the robot&apos;s height is wrong</source>
        <translation>정합 후 카메라가 움직였거나, 뷰가 동기화되지 않았거나, 로봇의 높이가 입력한 값과 다릅니다</translation>
    </message>
</context>
<context>
    <name>workflow.withdraw_acceptance</name>
    <message>
        <source>withdraw the acceptance of %1</source>
        <translation>%1의 승인 철회</translation>
    </message>
</context>
<context>
    <name>workflow.write_address</name>
    <message>
        <source>write it like 224.5.23.2:10006</source>
        <translation>224.5.23.2:10006처럼 쓰십시오</translation>
    </message>
</context>
<context>
    <name>workflow.writing_last_pictures</name>
    <message>
        <source>writing the last frames</source>
        <translation>마지막 프레임 쓰는 중</translation>
    </message>
</context>
<context>
    <name>workflow.written_just_now</name>
    <message>
        <source>another program is writing or removing it</source>
        <translation>지금 다른 프로그램이 쓰거나 제거하는 중입니다</translation>
    </message>
</context>
</TS>
