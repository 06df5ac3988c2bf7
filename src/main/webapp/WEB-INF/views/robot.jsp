<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="robot.title" var="title"><fmt:param value="${robot.name}"/></fmt:message>
<fmt:formatNumber value="${robot.maxLoad}" maxFractionDigits="2" var="maxLoad"/>
<fmt:formatNumber value="${robot.capabilities.footprint}" maxFractionDigits="3" var="footprint"/>
<fmt:formatNumber value="${robot.speed()}" maxFractionDigits="2" var="speed"/>
<t:page title="${title}" here="robot" script="robot/track.js">
  <t:errors/>
  <c:if test="${not empty mqttPassword}"><div class="notice good" role="status"><p><fmt:message key="robot.mqtt"/>: <fmt:message key="robot.mqtt.once"/></p><code class="secret" dir="ltr"><c:out value="${mqttPassword}"/></code></div></c:if>
  <div id="live" data-live="robot" data-name="${fn:escapeXml(robot.name)}">
    <div class="heading">
      <h1><c:out value="${title}"/></h1>
      <t:state of="robot" state="${robot.state}"/>
    </div>
    <c:forEach items="${robot.telemetry.errors}" var="fault"><p class="notice bad"><t:fault fault="${fault}"/></p></c:forEach>
    <c:if test="${not empty robot.unreachable and robot.unreachable != robot.alert}"><p class="notice bad"><t:said sentence="${robot.unreachable}"/></p></c:if>
    <c:if test="${not empty robot.alert}"><p class="notice bad" role="alert"><t:said sentence="${robot.alert}"/></p></c:if>
    <article>
      <dl>
        <dt><fmt:message key="robot.activity"/></dt><dd><t:said sentence="${robot.work.doing}"/></dd>
        <dt><fmt:message key="robot.task"/></dt>
        <dd><c:choose><c:when test="${empty robot.work.task}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><a href="${root}/tasks/${robot.work.task}"><fmt:message key="task.title"><fmt:param value="${robot.work.task}"/></fmt:message></a></c:otherwise></c:choose></dd>
        <dt><fmt:message key="robot.phase"/></dt><dd><fmt:message key="robot.phase.${robot.work.phase.number()}"/></dd>
        <dt><fmt:message key="robot.position"/></dt>
        <dd><t:pose pose="${robot.telemetry.pose}"/></dd>
        <dt><fmt:message key="robot.actualSpeed"/></dt><dd><t:actual-speed readings="${robot.telemetry.readings()}"/></dd>
        <c:if test="${not empty robot.telemetry.readings().placeError()}">
          <fmt:formatNumber value="${robot.telemetry.readings().placeError()}" minFractionDigits="2" maxFractionDigits="2" var="placeError"/>
          <dt><fmt:message key="robot.placeError"/></dt><dd><fmt:message key="common.metres"><fmt:param value="${placeError}"/></fmt:message></dd>
        </c:if>
        <c:if test="${not empty robot.telemetry.readings().measuredLoad()}">
          <fmt:formatNumber value="${robot.telemetry.readings().measuredLoad()}" minFractionDigits="1" maxFractionDigits="1" var="measuredLoad"/>
          <dt><fmt:message key="robot.measuredLoad"/></dt><dd><fmt:message key="common.kilograms"><fmt:param value="${measuredLoad}"/></fmt:message></dd>
        </c:if>
        <dt><fmt:message key="robot.battery"/></dt>
        <dd><c:choose><c:when test="${empty robot.telemetry.battery}"><span class="faint"><fmt:message key="robot.battery.unknown"/></span></c:when><c:otherwise><fmt:formatNumber value="${robot.telemetry.battery}" type="percent"/></c:otherwise></c:choose></dd>
        <c:if test="${not empty robot.work.charger}"><dt><fmt:message key="robot.charger"/></dt><dd><bdi><c:out value="${robot.work.charger}"/></bdi></dd></c:if>
        <dt><fmt:message key="robot.maxLoad"/></dt><dd><fmt:message key="common.kilograms"><fmt:param value="${maxLoad}"/></fmt:message><c:if test="${not robot.isLoadKnown()}">${" "}<span class="faint"><fmt:message key="robot.maxLoad.unknown"/></span></c:if><c:if test="${robot.record.maxLoad > robot.maxLoad}"><fmt:formatNumber value="${robot.record.maxLoad}" maxFractionDigits="2" var="entered"/>${" "}<span class="faint"><fmt:message key="robot.maxLoad.entered"><fmt:param value="${entered}"/></fmt:message></span></c:if></dd>
        <dt><fmt:message key="robot.footprint"/></dt><dd><fmt:message key="common.metres"><fmt:param value="${footprint}"/></fmt:message></dd>
        <dt><fmt:message key="robot.speed"/></dt><dd><fmt:message key="common.metresPerSecond"><fmt:param value="${speed}"/></fmt:message></dd>
        <dt><fmt:message key="robot.floor"/></dt><dd><bdi><c:out value="${robot.floor}"/></bdi></dd>
        <dt><fmt:message key="robot.parking"/></dt><dd><bdi><c:out value="${robot.record.parking}"/></bdi></dd>
        <dt><fmt:message key="robot.address"/></dt><dd><bdi dir="ltr"><c:out value="${robot.record.host}"/>:${robot.record.port}</bdi><c:if test="${robot.record.simulated}"> (<fmt:message key="robot.simulated"/>)</c:if></dd>
        <c:if test="${not empty robot.record.gateway}"><dt><fmt:message key="robot.gateway"/></dt><dd><bdi><c:out value="${robot.record.gateway}"/></bdi><c:forEach items="${gateways}" var="gateway"><c:if test="${gateway.name == robot.record.gateway}"> · <c:choose><c:when test="${gateway.isConnected}"><fmt:message key="robots.gateway.connected"><fmt:param value="${gateway.address}"/></fmt:message></c:when><c:otherwise><fmt:message key="robots.gateway.notConnected"/></c:otherwise></c:choose>${" "}<t:time at="${gateway.since}"/></c:if></c:forEach></dd></c:if>
        <c:set var="networkRoute" value="${robot.telemetry.readings().networkRoute()}"/>
        <c:if test="${not empty networkRoute}"><dt><fmt:message key="robot.networkRoute"/></dt><dd><t:network-route route="${networkRoute}" relays="${relays}"/> · <fmt:message key="robot.networkRoute.next"/>${" "}<bdi dir="ltr"><c:out value="${networkRoute.nextHop()}"/></bdi> · <fmt:message key="robot.networkRoute.metric"/>${" "}<bdi dir="ltr">${networkRoute.metric()}</bdi></dd></c:if>
        <dt><fmt:message key="robot.link"/></dt>
        <dd><c:choose><c:when test="${robot.record.isHttp() and empty robot.record.fingerprint}"><fmt:message key="robot.link.http"/></c:when><c:when test="${robot.record.isHttp()}"><fmt:message key="robot.link.https"><fmt:param value="${fn:substring(robot.record.fingerprint, 0, 16)}"/></fmt:message></c:when><c:when test="${empty robot.record.fingerprint}"><fmt:message key="robot.link.plain"/></c:when><c:otherwise><fmt:message key="robot.link.paired"><fmt:param value="${fn:substring(robot.record.fingerprint, 0, 16)}"/></fmt:message></c:otherwise></c:choose></dd>
        <dt><fmt:message key="robot.lastSeen"/></dt>
        <dd><t:last-seen robot="${robot}"/></dd>
      </dl>
      <c:url value="/map" var="onMap"><c:param name="robot" value="${robot.name}"/></c:url>
      <a href="<c:out value="${onMap}"/>"><fmt:message key="task.onMap"/></a>
      <c:url value="/robots/${robot.name}/control" var="control"/>
      ${" · "}<a href="<c:out value="${control}"/>"><fmt:message key="robot.control"/></a>
    </article>
    <c:if test="${not empty ranges}">
      <article class="card">
        <h2><fmt:message key="robot.ranges"/></h2>
        <fmt:message key="robot.ranges.label" var="rangesLabel"/>
        <svg class="ranges" viewBox="-102 -102 204 126" role="img" aria-label="${rangesLabel}">
          <c:forEach items="${ranges}" var="sector"><path d="${sector.path()}" class="${sector.isBlocked() ? 'blocked' : 'free'}"/></c:forEach>
          <circle r="20"/>
          <path d="M0,-16 L8,4 L-8,4 Z" class="heading"/>
        </svg>
        <p class="faint"><fmt:message key="robot.ranges.intro"/><bdi dir="ltr"><c:forEach items="${robot.telemetry.readings().ranges()}" var="range" varStatus="at">${at.first ? '' : ', '}<fmt:formatNumber value="${range}" minFractionDigits="2" maxFractionDigits="2"/></c:forEach></bdi></p>
      </article>
    </c:if>
  </div>
  <c:if test="${caller.mayOperate()}">
    <c:set var="stops" value="${robot.stops()}"/>
    <article class="card service" id="stop" data-live="robot-stop" data-name="${fn:escapeXml(robot.name)}" ${empty stops ? 'hidden' : ''}>
      <h2><fmt:message key="robot.stop"/></h2>
      <c:if test="${not empty stops}">
        <p><fmt:message key="robot.stop.intro"/></p>
        <ul><c:forEach items="${stops}" var="stop"><li><t:fault fault="${stop}"/></li></c:forEach></ul>
        <c:url value="/robots/${robot.name}/clear" var="clear"/>
        <details>
          <summary role="button" class="outline secondary"><fmt:message key="robot.stop.clear"/></summary>
          <form method="post" action="<c:out value="${clear}"/>">
            <t:csrf/>
            <c:forEach items="${stops}" var="stop"><input type="hidden" name="reasons" value="${fn:escapeXml(stop.code)}"></c:forEach>
            <p><fmt:message key="robot.stop.sure"/></p>
            <button class="danger"><fmt:message key="robot.stop.submit"/></button>
          </form>
        </details>
      </c:if>
    </article>
  </c:if>
  <c:if test="${not empty broker}">
    <article class="card" id="readings" data-live="robot-readings" data-name="${fn:escapeXml(robot.name)}">
      <h2><fmt:message key="robot.readings"/></h2>
      <c:if test="${not empty published.presence()}"><p><fmt:message key="robot.readings.${published.presence().online() ? 'online' : 'offline'}"/>${" "}<t:time at="${published.presence().since()}"/></p></c:if>
      <c:choose>
        <c:when test="${empty published.readings()}"><p class="faint"><fmt:message key="robot.readings.none"/></p></c:when>
        <c:otherwise>
          <table>
            <thead><tr><th><fmt:message key="robot.readings.name"/></th><th><fmt:message key="robot.readings.value"/></th><th><fmt:message key="robot.readings.heard"/></th></tr></thead>
            <tbody>
              <c:forEach items="${published.readings()}" var="reading">
                <tr>
                  <td><bdi dir="ltr"><c:out value="${reading.name()}"/></bdi></td>
                  <td><bdi dir="ltr"><c:forEach items="${reading.values()}" var="value" varStatus="at">${at.first ? '' : ', '}<fmt:formatNumber value="${value}" maxFractionDigits="3"/></c:forEach>${" "}<c:out value="${reading.unit()}"/></bdi></td>
                  <td><t:time at="${reading.receivedAt()}"/></td>
                </tr>
              </c:forEach>
            </tbody>
          </table>
        </c:otherwise>
      </c:choose>
      <c:if test="${not empty limits}">
        <h3><fmt:message key="robot.limits"/></h3>
        <ul><c:forEach items="${limits}" var="limit"><li><bdi dir="ltr"><c:out value="${limit.reading()}"/></bdi>: <c:if test="${limit.low() != null}"><fmt:formatNumber value="${limit.low()}" maxFractionDigits="3" var="low"/><fmt:message key="robot.limits.low.is"><fmt:param value="${low}"/></fmt:message>${" "}</c:if><c:if test="${limit.high() != null}"><fmt:formatNumber value="${limit.high()}" maxFractionDigits="3" var="high"/><fmt:message key="robot.limits.high.is"><fmt:param value="${high}"/></fmt:message></c:if></li></c:forEach></ul>
      </c:if>
      <c:if test="${not empty published.refusals()}">
        <h3><fmt:message key="robot.refusals"/></h3>
        <ul><c:forEach items="${published.refusals()}" var="refusal"><li><fmt:message key="robot.refusal.${refusal.key}"><fmt:param value="${refusal.value}"/></fmt:message></li></c:forEach></ul>
      </c:if>
    </article>
  </c:if>
  <article class="card" id="battery" data-live="robot-battery" data-name="${fn:escapeXml(robot.name)}">
    <h2><fmt:message key="robot.batteryLevels"><fmt:param value="${trackHours}"/></fmt:message></h2>
    <c:choose>
      <c:when test="${batteryPicture.isEmpty()}"><p class="faint"><fmt:message key="robot.batteryLevels.none"/></p></c:when>
      <c:otherwise>
        <fmt:message key="robot.batteryLevels.label" var="batteryLabel"/>
        <svg class="levels" viewBox="-2 -6 404 112" preserveAspectRatio="none" role="img" aria-label="${batteryLabel}">
          <path d="M0,0 H400 M0,50 H400 M0,100 H400"/>
          <polyline points="${batteryPicture.points()}"/>
        </svg>
        <p class="faint"><fmt:message key="robot.batteryLevels.axes"><fmt:param value="${trackHours}"/></fmt:message></p>
      </c:otherwise>
    </c:choose>
  </article>
  <article class="card">
    <h2><fmt:message key="robot.track"><fmt:param value="${trackHours}"/></fmt:message></h2>
    <fmt:message key="robot.track.label" var="trackLabel"/>
    <canvas id="track" class="track" role="img" aria-label="${trackLabel}" data-robot="${fn:escapeXml(robot.name)}" data-floor="${fn:escapeXml(robot.floor)}" data-hours="${trackHours}"></canvas>
    <p id="track-none" class="faint" hidden><fmt:message key="robot.track.none"/></p>
    <c:url value="/history" var="history"><c:param name="robot" value="${robot.name}"/></c:url>
    <a href="<c:out value="${history}"/>"><fmt:message key="robot.history"/></a>
  </article>
  <c:if test="${caller.mayOperate()}">
    <article class="card" id="actions" data-live="robot-actions" data-name="${fn:escapeXml(robot.name)}" ${empty pause or empty robot.work.task ? '' : 'hidden'}>
      <h2><fmt:message key="robot.actions"/></h2>
      <div class="choices">
        <c:url value="/robots/${robot.name}/${robot.work.held ? 'resume' : 'hold'}" var="holdOrResume"/>
        <c:if test="${empty pause}">
          <form method="post" action="<c:out value="${holdOrResume}"/>">
            <t:csrf/>
            <button><fmt:message key="robot.${robot.work.held ? 'resume' : 'hold'}"/></button>
          </form>
        </c:if>
        <c:if test="${empty robot.work.task and empty robot.work.charger and not empty robot.record.parking}">
          <c:url value="/robots/${robot.name}/home" var="home"/>
          <form method="post" action="<c:out value="${home}"/>">
            <t:csrf/>
            <button class="outline"><fmt:message key="robot.home"/></button>
          </form>
        </c:if>
      </div>
    </article>
    <article class="card service" id="service" data-live="service" data-name="${fn:escapeXml(robot.name)}">
      <h2><fmt:message key="robot.service"/></h2>
      <c:set var="isOut" value="${robot.state == 'OUT_OF_SERVICE'}"/>
      <c:url value="/robots/${robot.name}/in-service" var="inService"/>
      <c:url value="/robots/${robot.name}/out-of-service" var="outOfService"/>
      <c:if test="${isOut}">
        <p><fmt:message key="robot.service.isOut"/></p>
        <form method="post" action="<c:out value="${inService}"/>">
          <t:csrf/>
          <button><fmt:message key="robot.service.in"/></button>
        </form>
      </c:if>
      <c:if test="${not isOut or keepsPlace}">
        <c:set var="action" value="${isOut ? 'release' : 'out'}"/>
        <details>
          <summary role="button" class="outline secondary"><fmt:message key="robot.service.${action}"/></summary>
          <form method="post" action="<c:out value="${outOfService}"/>">
            <t:csrf/>
            <p><fmt:message key="robot.service.sure.${action}"/></p>
            <button class="danger"><fmt:message key="robot.service.submit.${action}"/></button>
          </form>
        </details>
      </c:if>
    </article>
    <article class="card">
      <h2><fmt:message key="robot.locate"/></h2>
      <p class="faint"><fmt:message key="robot.locate.intro"/></p>
      <c:url value="/robots/${robot.name}/locate" var="target"/>
      <form method="post" action="<c:out value="${target}"/>" novalidate>
        <t:csrf/>
        <div class="grid">
          <div><t:field name="x" label="robot.locate.x" inputmode="decimal"/></div>
          <div><t:field name="y" label="robot.locate.y" inputmode="decimal"/></div>
          <div><t:field name="heading" label="robot.locate.heading" hint="robot.locate.heading.hint" inputmode="decimal"/></div>
        </div>
        <button><fmt:message key="robot.locate.submit"/></button>
      </form>
    </article>
  </c:if>
  <c:if test="${caller.mayManage()}">
    <c:if test="${fn:length(floors) > 1}">
      <article class="card" id="move">
        <h2><fmt:message key="robot.move"/>${" "}<t:help topic="maps"/></h2>
        <p class="faint"><fmt:message key="${robot.record.simulated ? 'robot.move.intro.simulated' : 'robot.move.intro'}"/></p>
        <c:url value="/robots/${robot.name}/move" var="move"/>
        <form method="post" action="<c:out value="${move}"/>" novalidate>
          <t:csrf/>
          <label for="move-floor"><fmt:message key="map.floor"/></label>
          <select id="move-floor" name="floor" ${not empty errors.floor ? 'aria-invalid="true" aria-describedby="move-floor-help"' : ''}>
            <c:forEach items="${floors}" var="choice"><c:if test="${choice.name() != robot.floor()}"><option dir="auto" ${param.floor == choice.name() ? 'selected' : ''}><c:out value="${choice.name()}"/></option></c:if></c:forEach>
          </select>
          <c:if test="${not empty errors.floor}"><small id="move-floor-help" class="wrong"><bdi><c:out value="${errors.floor}"/></bdi></small></c:if>
          <div class="grid">
            <div><t:field name="x" id="move-x" label="robot.locate.x" inputmode="decimal" idle="${sent != 'move'}"/></div>
            <div><t:field name="y" id="move-y" label="robot.locate.y" inputmode="decimal" idle="${sent != 'move'}"/></div>
            <div><t:field name="heading" id="move-heading" label="robot.locate.heading" hint="robot.locate.heading.hint" inputmode="decimal" idle="${sent != 'move'}"/></div>
          </div>
          <button><fmt:message key="robot.move.submit"/></button>
        </form>
      </article>
    </c:if>
    <article class="card" id="change">
      <h2><fmt:message key="robot.change"/>${" "}<t:help topic="robot"/></h2>
      <c:url value="/robots/${robot.name}/change" var="change"/>
      <form method="post" action="<c:out value="${change}"/>" novalidate>
        <t:csrf/>
        <t:version/>
        <div class="grid">
          <div><t:field name="host" id="change-host" label="robots.add.host" latin="true" idle="${sent == 'pair'}" value="${robot.record.host}"/></div>
          <div><t:field name="port" id="change-port" label="robots.add.port" inputmode="numeric" idle="${sent == 'pair'}" value="${robot.record.port}"/></div>
        </div>
        <div class="grid">
          <div><t:field name="maxLoad" label="robots.add.maxLoad" inputmode="decimal" value="${robot.maxLoad % 1 == 0 ? robot.maxLoad.intValue() : robot.maxLoad}"/></div>
          <div><t:parking chosen="${param.parking == null ? robot.record.parking : param.parking}" none="robot.parking.none" on="${robot.floor()}"/></div>
        </div>
        <c:if test="${robot.record.isHttp()}">
          <div class="grid">
            <div><t:field name="token" type="password" label="robot.token" hint="robot.token.hint" optional="true"/></div>
            <div><t:field name="fingerprint" label="robot.fingerprint" hint="robot.fingerprint.hint" latin="true" optional="true"/></div>
          </div>
        </c:if>
        <c:if test="${not robot.record.isHttp()}"><t:gateway chosen="${param.gateway == null ? robot.record.gateway : param.gateway}"/></c:if>
        <button><fmt:message key="robot.change.submit"/></button>
      </form>
      <c:if test="${not robot.record.simulated}">
        <c:url value="/robots/${robot.name}/remove" var="remove"/>
        <details class="or">
          <summary role="button" class="outline secondary"><fmt:message key="robot.remove"/></summary>
          <form method="post" action="<c:out value="${remove}"/>">
            <t:csrf/>
            <p><fmt:message key="robot.remove.sure"/></p>
            <button class="danger"><fmt:message key="robot.remove.submit"/></button>
          </form>
        </details>
      </c:if>
    </article>
    <c:if test="${not empty broker}">
      <article class="card" id="limits">
        <h2><fmt:message key="robot.limits.set"/>${" "}<t:help topic="telemetry"/></h2>
        <p class="faint"><fmt:message key="robot.limits.intro"/></p>
        <c:url value="/robots/${robot.name}/limits" var="setLimits"/>
        <form method="post" action="<c:out value="${setLimits}"/>" novalidate>
          <t:csrf/>
          <div class="grid">
            <div><t:field name="reading" label="robot.readings.name" hint="robot.readings.name.hint" latin="true" idle="${sent != 'limits'}"/></div>
            <div><t:field name="low" label="robot.limits.low" inputmode="decimal" optional="true" idle="${sent != 'limits'}"/></div>
            <div><t:field name="high" label="robot.limits.high" inputmode="decimal" optional="true" idle="${sent != 'limits'}"/></div>
          </div>
          <button><fmt:message key="robot.limits.submit"/></button>
        </form>
      </article>
      <article class="card" id="mqtt">
        <h2><fmt:message key="robot.mqtt"/></h2>
        <dl>
          <dt><fmt:message key="robot.mqtt.broker"/></dt><dd><bdi dir="ltr"><c:out value="${broker.address()}"/></bdi></dd>
          <dt><fmt:message key="robot.mqtt.user"/></dt><dd><bdi dir="ltr"><c:out value="${mqttUser}"/></bdi></dd>
        </dl>
        <c:choose>
          <c:when test="${broker.isEmbedded()}">
            <c:url value="/robots/${robot.name}/mqtt-password" var="makePassword"/>
            <form method="post" action="<c:out value="${makePassword}"/>">
              <t:csrf/>
              <c:if test="${hasMqttPassword}"><p class="faint"><fmt:message key="robot.mqtt.replaces"/></p></c:if>
              <button class="outline"><fmt:message key="robot.mqtt.${hasMqttPassword ? 'again' : 'make'}"/></button>
            </form>
          </c:when>
          <c:otherwise><p class="faint"><fmt:message key="robot.mqtt.elsewhere"/></p></c:otherwise>
        </c:choose>
      </article>
    </c:if>
    <c:if test="${not robot.record.simulated and not robot.record.isHttp()}">
      <article class="card" id="pair">
        <h2><fmt:message key="robot.pair.${empty robot.record.fingerprint ? 'first' : 'again'}"/>${" "}<t:help topic="robot-link"/></h2>
        <p class="faint"><fmt:message key="robot.pair.intro"/></p>
        <c:url value="/robots/${robot.name}/pair" var="pair"/>
        <form method="post" action="<c:out value="${pair}"/>" novalidate>
          <t:csrf/>
          <t:version/>
          <div class="grid">
            <div><t:field name="host" label="robots.add.host" latin="true" idle="${sent == 'change'}" value="${robot.record.host}"/></div>
            <div><t:field name="port" label="robots.add.port" inputmode="numeric" idle="${sent == 'change'}" value="${robot.record.port}"/></div>
          </div>
          <t:field name="code" label="robot.pair.code" latin="true"/>
          <button><fmt:message key="robot.pair.submit"/></button>
        </form>
      </article>
    </c:if>
  </c:if>
</t:page>
