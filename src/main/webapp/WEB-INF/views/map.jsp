<%@ page contentType="text/html;charset=UTF-8" session="false" import="org.toqa.web.RequestPath" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="map.title" var="title"/>
<fmt:message key="map.canvas" var="canvasLabel"/>
<fmt:message key="map.counts" var="countsLabel"/>
<fmt:message key="map.zoomIn" var="zoomIn"/>
<fmt:message key="map.zoomOut" var="zoomOut"/>
<fmt:message key="map.fit" var="fit"/>
<fmt:message key="map.measure" var="measure"/>
<fmt:message key="map.zones" var="zonesLabel"/>
<fmt:message key="map.margins" var="marginsLabel"/>
<fmt:message key="replay.label" var="replayLabel"/>
<fmt:message key="replay.time" var="timeLabel"/>
<fmt:message key="replay.back" var="back"/>
<fmt:message key="replay.forward" var="forward"/>
<t:page title="${title}" here="map" script="map/map.js" layout="live-map">
<jsp:attribute name="urgent">
    <p id="banner" class="notice bad" role="alert" hidden></p>
    <p id="replay-failed" class="notice bad" role="alert" hidden><fmt:message key="replay.failed"/></p>
</jsp:attribute>
<jsp:attribute name="remark"><p id="replay-banner" class="notice warn" role="status" hidden><strong><fmt:message key="replay.banner"/></strong></p></jsp:attribute>
<jsp:body>
  <h1 class="unseen">${title}</h1>
  <section class="map-panel">
    <div class="summary">
      <ul id="counts" class="counts" aria-label="${countsLabel}"></ul>
      <c:if test="${fn:length(floors) > 1}">
        <label class="floor"><span class="unseen"><fmt:message key="map.floor"/></span>
          <select id="floor"><c:forEach items="${floors}" var="floor"><option dir="auto"><c:out value="${floor.name()}"/></option></c:forEach></select>
        </label>
      </c:if>
      <div class="moment">
        <div class="zoom">
          <button type="button" id="measure" aria-pressed="false" aria-label="${measure}" title="${measure}"><t:icon name="measure"/></button>
          <button type="button" id="zones" aria-pressed="false" aria-label="${zonesLabel}" title="${zonesLabel}"><t:icon name="zones"/></button>
          <button type="button" id="margins" aria-pressed="false" aria-label="${marginsLabel}" title="${marginsLabel}"><t:icon name="margins"/></button>
          <button type="button" id="zoom-in" aria-label="${zoomIn}" title="${zoomIn}">+</button>
          <button type="button" id="zoom-out" aria-label="${zoomOut}" title="${zoomOut}">−</button>
          <button type="button" id="zoom-fit" aria-label="${fit}" title="${fit}"><t:icon name="fit"/></button>
        </div>
        <button type="button" id="replay-open" class="outline" disabled><t:icon name="replay"/> <fmt:message key="replay.open"/></button>
        <p id="age" class="age" data-state="connecting"><fmt:message key="map.connecting"/></p>
      </div>
    </div>
    <noscript><p class="notice bad"><fmt:message key="map.noscript"/></p></noscript>
    <div class="canvas">
      <canvas id="map" tabindex="0" role="img" aria-label="${canvasLabel}"></canvas>
      <p id="following" class="following" role="status" hidden><fmt:message key="map.following"/>${" "}<a><bdi></bdi></a>${" "}<button type="button" id="stop-following"><fmt:message key="map.stopFollowing"/></button></p>
      <p id="measuring" class="following" role="status" hidden><bdi></bdi>${" "}<button type="button"><fmt:message key="map.measure.close"/></button></p>
    </div>
    <section id="replay" class="replay" aria-label="${replayLabel}" hidden>
      <input type="range" id="replay-time" aria-label="${timeLabel}">
      <button type="button" id="replay-play"><fmt:message key="replay.play"/></button>
      <button type="button" id="replay-back" class="outline">${back}</button>
      <button type="button" id="replay-forward" class="outline">${forward}</button>
      <bdi id="replay-moment" class="number"></bdi>
      <label><span class="unseen"><fmt:message key="replay.speed"/></span>
        <select id="replay-speed"><c:forTokens items="1,10,60" delims="," var="speed"><option value="${speed}" dir="ltr">${speed}×</option></c:forTokens></select>
      </label>
      <label><span class="unseen"><fmt:message key="replay.hours"/></span>
        <select id="replay-hours"><c:forTokens items="1,4,12,24" delims="," var="hours"><option value="${hours}" ${hours == 4 ? 'selected' : ''}><fmt:message key="replay.hours.last"><fmt:param value="${hours}"/></fmt:message></option></c:forTokens></select>
      </label>
      <button type="button" id="replay-live"><fmt:message key="replay.live"/></button>
    </section>
  </section>
  <aside class="side-lists">
    <section id="attention" hidden>
      <h2><fmt:message key="map.needsAttention"/> <span id="attention-now" hidden><fmt:message key="replay.now"/></span></h2>
      <ul class="entries"></ul>
    </section>
    <div id="replay-lists" hidden>
      <section>
        <h2><fmt:message key="replay.robots"/></h2>
        <ul id="replay-robots" class="entries"></ul>
        <p id="replay-no-robots" class="faint"></p>
      </section>
      <section>
        <h2><fmt:message key="replay.loads"/></h2>
        <ul id="replay-loads" class="entries"></ul>
        <p id="replay-no-loads" class="faint" hidden><fmt:message key="replay.noLoads"/></p>
      </section>
      <section>
        <h2><fmt:message key="replay.events"/></h2>
        <ul id="replay-events" class="history"></ul>
        <p id="replay-no-events" class="faint" hidden><fmt:message key="replay.noEvents"/></p>
      </section>
    </div>
    <div id="live-lists">
      <section>
        <h2><fmt:message key="map.tasks"/></h2>
        <ul id="tasks" class="entries"></ul>
        <p id="more-tasks" class="faint" hidden></p>
        <p id="no-tasks" class="faint" hidden><fmt:message key="map.tasks.none"/></p>
        <div class="choices">
          <c:if test="${caller.mayOrder()}"><a role="button" class="wide" href="${root}/tasks/new"><fmt:message key="tasks.new"/></a></c:if>
          <a role="button" class="outline wide" href="${root}/loads"><fmt:message key="map.allLoads"/></a>
        </div>
      </section>
      <section>
        <h2><fmt:message key="map.robots"/></h2>
        <ul id="robots" class="entries"></ul>
        <p id="no-robots" class="faint" hidden><fmt:message key="map.robots.none"/></p>
      </section>
      <section id="cameras" hidden>
        <h2><fmt:message key="cameras.title"/></h2>
        <c:forEach items="${cameras}" var="camera"><t:camera camera="${camera}"/></c:forEach>
      </section>
      <section id="floors" data-live="floors">
        <c:forEach items="${supervised}" var="name">
          <c:url value="/floors/${RequestPath.segment(name)}/supervision" var="supervisionUrl"/>
          <p data-floor="<c:out value="${name}"/>"><a role="button" class="outline wide" href="<c:out value="${supervisionUrl}"/>"><fmt:message key="supervision.link"/></a></p>
        </c:forEach>
        <c:forEach items="${floorViews}" var="view">
          <c:if test="${not empty view.hold or caller.mayOperate()}">
            <div data-floor="<c:out value="${view.name}"/>">
            <h2><fmt:message key="map.floorNamed"><fmt:param><bdi><c:out value="${view.name}"/></bdi></fmt:param></fmt:message></h2>
            <c:if test="${not empty view.hold}">
              <p class="notice warn"><fmt:message key="floor.held"><fmt:param><bdi><c:out value="${view.hold.user}"/></bdi></fmt:param></fmt:message>${" "}<t:time at="${view.hold.since}"/></p>
            </c:if>
            <c:if test="${caller.mayOperate()}">
              <c:url value="/floors/${RequestPath.segment(view.name)}/${empty view.hold ? 'hold' : 'resume'}" var="holdOrResume"/>
              <form method="post" action="<c:out value="${holdOrResume}"/>">
                <t:csrf/>
                <button class="outline wide"><fmt:message key="floor.${empty view.hold ? 'hold' : 'resume'}"/></button>
              </form>
            </c:if>
            <c:if test="${caller.mayManage()}">
              <c:url value="/floors/${RequestPath.segment(view.name)}/allocator" var="allocatorUrl"/>
              <details>
                <summary><fmt:message key="floor.allocator"/>: <fmt:message key="floor.allocator.${empty allocators[view.name] ? 'configured' : allocators[view.name]}"/></summary>
                <form method="post" action="<c:out value="${allocatorUrl}"/>">
                  <t:csrf/>
                  <fieldset>
                    <c:forTokens items="configured,zones,contract-net,optimal" delims="," var="word">
                      <label><input type="radio" name="allocator" value="${word == 'configured' ? '' : word}" ${word == (empty allocators[view.name] ? 'configured' : allocators[view.name]) ? 'checked' : ''}> <fmt:message key="floor.allocator.${word}"/><c:if test="${word != 'configured'}"><br><small class="faint"><fmt:message key="floor.allocatorFigures.${word}"/></small></c:if></label>
                    </c:forTokens>
                  </fieldset>
                  <p class="faint"><fmt:message key="floor.allocator.measured"/></p>
                  <button class="outline wide"><fmt:message key="floor.allocator.submit"/></button>
                </form>
              </details>
            </c:if>
            </div>
          </c:if>
        </c:forEach>
      </section>
    </div>
    <details>
      <summary><fmt:message key="map.legend"/></summary>
      <ul class="legend">
        <c:forEach items="${robotStates}" var="state"><li><span class="letter" data-state="${state}"><fmt:message key="robot.letter.${state}"/></span> <fmt:message key="robot.state.${state}"/></li></c:forEach>
        <c:forTokens items="station,parking,charging,load,box,goal,released,planned,obstacle,reserved,standstill,hold,zone,margins" delims="," var="sign"><li><t:icon name="legend-${sign}"/> <fmt:message key="map.legend.${sign}"/></li></c:forTokens>
      </ul>
    </details>
  </aside>
  <c:set var="stateKeys" value=""/>
  <c:forEach items="${robotStates}" var="state"><c:set var="stateKeys" value="${stateKeys} robot.state.${state} robot.letter.${state}"/></c:forEach>
  <t:texts keys="map.live camera.failed map.speedLimit map.age map.measure.start map.measure.goal map.measure.asking map.measure.metres map.measure.cells map.measure.failed map.seenAgo replay.label replay.play replay.pause replay.driving replay.stopped replay.task replay.loadAt replay.loadOn replay.loading replay.none map.disconnected map.loggedOut map.loggedOut.link map.failed map.standstill map.charger map.chargers map.leftLoad map.expected map.tasks.more common.comma task.state.QUEUED task.state.ASSIGNED task.state.TO_OBJECT task.state.drive task.state.CARRYING task.state.RETURNING${stateKeys}"/>
</jsp:body>
</t:page>
