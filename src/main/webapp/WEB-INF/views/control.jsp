<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="name" value="${fn:escapeXml(robot.name)}"/>
<fmt:message key="control.title" var="title"><fmt:param value="${robot.name}"/></fmt:message>
<t:page title="${title}" here="robot" script="control/control.js">
  <div id="live" data-live="control" data-name="${name}">
    <div class="heading">
      <h1><c:out value="${title}"/></h1>
      <t:state of="robot" state="${robot.state}"/>
    </div>
    <c:forEach items="${robot.telemetry.errors}" var="fault"><p class="notice bad"><t:fault fault="${fault}"/></p></c:forEach>
    <c:if test="${not empty robot.alert}"><p class="notice bad" role="alert"><t:said sentence="${robot.alert}"/></p></c:if>
    <p><t:said sentence="${robot.work.doing}"/></p>
  </div>
  <p id="connection" class="notice bad" role="alert" hidden></p>
  <noscript><p class="notice bad"><fmt:message key="control.noscript"/></p></noscript>
  <div class="choices">
    <c:if test="${caller.mayOperate()}">
      <c:url value="/robots/${robot.name}/hold" var="hold"/>
      <form id="stop" method="post" action="<c:out value="${hold}"/>"><t:csrf/><button class="danger"><fmt:message key="control.stop"/></button></form>
      <c:url value="/robots/${robot.name}/resume" var="resume"/>
      <form id="start" method="post" action="<c:out value="${resume}"/>"><t:csrf/><button class="outline" ${robot.work.held ? '' : 'disabled'}><fmt:message key="control.start"/></button></form>
    </c:if>
    <c:url value="/robots/${robot.name}" var="page"/>
    <a role="button" class="outline secondary" href="<c:out value="${page}"/>"><fmt:message key="control.page"/></a>
  </div>
  <p id="refused" class="notice bad" role="alert" hidden></p>
  <div class="control" id="control" data-robot="${name}" data-floor="${fn:escapeXml(robot.floor)}" data-readings="${hasReadings}" data-speed="${manualSpeed}" data-turn-rate="${manualTurnRate}">
    <article class="map-card">
      <h2><fmt:message key="control.map"/></h2>
      <fmt:message key="control.map.label" var="mapLabel"/>
      <canvas id="floor" class="track" role="img" aria-label="${mapLabel}"></canvas>
      <ul class="lines">
        <li><span class="line desired"></span><fmt:message key="control.desired"/></li>
        <li><span class="line actual"></span><fmt:message key="control.actual"/></li>
      </ul>
      <p class="faint"><fmt:message key="robot.position"/>: <bdi id="pose" dir="ltr">–</bdi></p>
    </article>
    <div class="side">
      <c:if test="${caller.mayOperate()}">
        <article class="hand-card" id="hand">
          <h2><fmt:message key="control.hand"/></h2>
          <p class="faint"><fmt:message key="control.hand.intro"/></p>
          <p id="driver" class="notice" role="status" hidden></p>
          <button type="button" id="take" class="wide"><fmt:message key="control.hand.take"/></button>
          <fieldset id="pad" hidden>
            <legend class="unseen"><fmt:message key="control.hand"/></legend>
            <c:forTokens items="forward,left,stop,right,back" delims="," var="way">
              <fmt:message key="control.hand.${way}" var="wayLabel"/>
              <button type="button" data-way="${way}" aria-label="${wayLabel}" title="${wayLabel}" class="${way == 'stop' ? 'danger' : 'outline'}"><t:icon name="drive-${way}"/></button>
            </c:forTokens>
          </fieldset>
          <button type="button" id="leave" class="wide outline" hidden><fmt:message key="control.hand.leave"/></button>
          <p id="hand-says" class="notice warn" role="status" hidden></p>
        </article>
      </c:if>
      <c:if test="${not empty cameras}">
        <article>
          <h2><fmt:message key="cameras.title"/></h2>
          <c:forEach items="${cameras}" var="camera"><t:camera camera="${camera}"/></c:forEach>
        </article>
      </c:if>
      <article>
        <h2><fmt:message key="control.speeds"/></h2>
        <div class="gauges">
          <c:forTokens items="left,right" delims="," var="side">
            <figure class="gauge" id="gauge-${side}">
              <svg viewBox="-110 -108 220 128" aria-hidden="true"><path class="scale" d="M-90,0 A90,90 0 0 1 90,0"/><path class="zero" d="M0,-100 V-80"/><path class="value"/><path class="needle" d="M0,0 V-76"/><circle r="6"/></svg>
              <figcaption><span class="caption"></span> <output class="number"><bdi>–</bdi></output></figcaption>
            </figure>
          </c:forTokens>
        </div>
        <p id="speeds-note" class="faint"></p>
      </article>
      <article>
        <h2><fmt:message key="control.ranges"/></h2>
        <p id="no-ranges" class="faint"><fmt:message key="control.ranges.none"/></p>
        <ul id="ranges" class="bars"></ul>
        <p id="ranges-age" class="faint" hidden></p>
      </article>
      <article id="arm" hidden>
        <h2><fmt:message key="control.arm"/></h2>
        <fmt:message key="control.arm.label" var="armLabel"/>
        <svg class="arm" viewBox="-100 -100 200 200" role="img" aria-label="${armLabel}"><circle class="body"/><path class="nose"/><circle class="reach"/><circle class="near"/><polyline class="links"/><circle class="shoulder"/><circle class="elbow"/><circle class="hand"/></svg>
        <dl>
          <c:forTokens items="shoulder,elbow,hand,load,step" delims="," var="fact">
            <dt><fmt:message key="control.arm.${fact}"/></dt><dd><bdi data-arm="${fact}">–</bdi></dd>
          </c:forTokens>
        </dl>
      </article>
    </div>
    <div class="charts">
      <c:forTokens items="crossTrack,heading" delims="," var="error">
        <fmt:message key="control.error.${error}" var="errorLabel"/>
        <article>
          <h2>${errorLabel}</h2>
          <p class="faint"><output id="value-${error}" class="number"><bdi>–</bdi></output></p>
          <svg id="chart-${error}" class="levels live-chart" viewBox="0 0 400 100" preserveAspectRatio="none" role="img" aria-label="${errorLabel}"><path class="axis" d="M0,50 H400"/><polyline/></svg>
          <p class="faint axes"><fmt:message key="control.axes"/>${" "}<bdi id="range-${error}"></bdi></p>
        </article>
      </c:forTokens>
    </div>
  </div>
  <t:texts keys="control.disconnected map.loggedOut map.failed control.wheel.left control.wheel.right control.speed.v control.speed.w control.unit.speed control.unit.turn control.unit.mm control.unit.degrees control.unit.metres control.unit.kilograms control.arm.at control.arm.empty control.arm.step.NONE control.arm.step.REACH control.arm.step.GRASP control.arm.step.WEIGH control.arm.step.RELEASE control.arm.step.FOLD control.speeds.wheels control.speeds.body control.sensor control.ranges.age control.hand.busy control.hand.mine control.hand.noAnswer control.hand.ended control.failed camera.failed"/>
</t:page>
