<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="robots.title" var="title"/>
<t:page title="${title}" here="robot" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="robots.count"><fmt:param value="${count}"/></fmt:message></p>
    </div>
  </div>
  <c:if test="${param.done == 'removed'}"><p class="notice good" role="status"><fmt:message key="robots.done.removed"/></p></c:if>
  <c:set var="isSent" value="${pageContext.request.method == 'POST'}"/>
  <details ${isFiltered or not isSent and not empty errors ? 'open' : ''}>
    <summary><fmt:message key="tasks.filter"/></summary>
    <form method="get" action="${root}/robots" class="filter" role="search">
      <label><fmt:message key="robots.filter.text"/>
        <input name="text" type="search" value="${isSent ? '' : fn:escapeXml(param.text)}" dir="auto" autocomplete="off">
      </label>
      <label><fmt:message key="robots.column.state"/>
        <select name="state" ${isSent or empty errors.state ? '' : 'aria-invalid="true"'}>
          <option value=""><fmt:message key="history.all"/></option>
          <c:forEach items="${states}" var="state"><option value="${state}" ${param.state == state.name() ? 'selected' : ''}><fmt:message key="robot.state.${state}"/></option></c:forEach>
        </select>
        <c:if test="${not isSent and not empty errors.state}"><small><bdi><c:out value="${errors.state}"/></bdi></small></c:if>
      </label>
      <t:floor-choice/>
      <button><fmt:message key="history.filter"/></button>
    </form>
  </details>
  <div id="live" data-live="robots">
    <c:if test="${empty robots}"><p class="notice"><fmt:message key="${isFiltered ? 'robots.filter.none' : 'robots.empty'}"/></p></c:if>
    <c:if test="${not empty robots}">
      <table class="stacks">
        <thead>
          <tr>
            <th scope="col"><fmt:message key="robots.column.name"/></th>
            <th scope="col"><fmt:message key="robots.column.state"/></th>
            <th scope="col"><fmt:message key="robots.column.activity"/></th>
            <th scope="col"><fmt:message key="robots.column.task"/></th>
            <th scope="col"><fmt:message key="robot.position"/></th>
            <th scope="col"><fmt:message key="robot.actualSpeed"/></th>
            <th scope="col"><fmt:message key="robots.column.battery"/></th>
            <th scope="col"><fmt:message key="robots.column.maxLoad"/></th>
            <th scope="col"><fmt:message key="robot.address"/></th>
            <th scope="col"><fmt:message key="robot.lastSeen"/></th>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${robots}" var="robot">
            <fmt:formatNumber value="${robot.maxLoad}" maxFractionDigits="2" var="maxLoad"/>
            <c:url value="/robots/${robot.name}" var="link"/>
            <tr>
              <th scope="row"><a href="<c:out value="${link}"/>"><bdi><c:out value="${robot.name}"/></bdi></a><c:if test="${fn:length(floors) > 1}"><br><small class="faint"><bdi><c:out value="${robot.floor()}"/></bdi></small></c:if></th>
              <td><t:state of="robot" state="${robot.state}"/></td>
              <td class="whole"><t:said sentence="${robot.work.doing}"/></td>
              <td data-label="<fmt:message key="robots.column.task"/>"><c:choose><c:when test="${empty robot.work.task}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><span><a href="${root}/tasks/${robot.work.task}"><fmt:message key="task.title"><fmt:param value="${robot.work.task}"/></fmt:message></a><br><small><fmt:message key="robot.phase.${robot.work.phase.number()}"/></small></span></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="robot.position"/>"><t:pose pose="${robot.telemetry.pose}"/></td>
              <td data-label="<fmt:message key="robot.actualSpeed"/>"><span><t:actual-speed readings="${robot.telemetry.readings()}"/></span></td>
              <td class="number" data-label="<fmt:message key="robots.column.battery"/>"><c:choose><c:when test="${empty robot.telemetry.battery}"><span class="faint"><fmt:message key="robot.battery.unknown"/></span></c:when><c:otherwise><fmt:formatNumber value="${robot.telemetry.battery}" type="percent"/></c:otherwise></c:choose></td>
              <td class="number" data-label="<fmt:message key="robots.column.maxLoad"/>"><fmt:message key="common.kilograms"><fmt:param value="${maxLoad}"/></fmt:message></td>
              <td data-label="<fmt:message key="robot.address"/>"><bdi dir="ltr"><c:out value="${robot.record.host}"/>:${robot.record.port}</bdi><c:if test="${not empty robot.telemetry.readings().networkRoute()}"><br><small><t:network-route route="${robot.telemetry.readings().networkRoute()}" relays="${relays[robot.name]}"/></small></c:if></td>
              <td data-label="<fmt:message key="robot.lastSeen"/>"><t:last-seen robot="${robot}"/></td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </c:if>
    <c:if test="${not empty gateways}">
      <h2><fmt:message key="robots.gateways"/></h2>
      <ul>
        <c:forEach items="${gateways}" var="gateway">
          <li><bdi><c:out value="${gateway.name}"/></bdi>: <c:choose><c:when test="${gateway.isConnected}"><fmt:message key="robots.gateway.connected"><fmt:param value="${gateway.address}"/></fmt:message></c:when><c:otherwise><strong><fmt:message key="robots.gateway.notConnected"/></strong></c:otherwise></c:choose>${" "}<t:time at="${gateway.since}"/></li>
        </c:forEach>
      </ul>
    </c:if>
  </div>
  <t:pages path="/robots" kept="text,state,floor"/>
  <c:if test="${caller.mayManage()}">
    <article class="card" id="add">
      <h2><fmt:message key="robots.add"/>${" "}<t:help topic="robot"/></h2>
      <c:if test="${isSent}"><t:errors/></c:if>
      <form method="post" action="${root}/robots" novalidate>
        <t:csrf/>
        <div class="grid">
          <div><t:field name="name" label="robots.add.name" hint="robots.add.name.hint" latin="true"/></div>
          <div><t:field name="host" label="robots.add.host" hint="robots.add.host.hint" latin="true"/></div>
          <div><t:field name="port" label="robots.add.port" inputmode="numeric" value="7275"/></div>
        </div>
        <div class="grid">
          <c:if test="${fn:length(floors) > 1}">
            <div>
              <label for="floor"><fmt:message key="map.floor"/></label>
              <select id="floor" name="floor" ${isSent and not empty errors.floor ? 'aria-invalid="true" aria-describedby="floor-help"' : ''}>
                <c:forEach items="${floors}" var="choice"><option dir="auto" ${param.floor == choice.name() ? 'selected' : ''}><c:out value="${choice.name()}"/></option></c:forEach>
              </select>
              <c:if test="${isSent and not empty errors.floor}"><small id="floor-help" class="wrong"><bdi><c:out value="${errors.floor}"/></bdi></small></c:if>
            </div>
          </c:if>
          <div><t:field name="maxLoad" label="robots.add.maxLoad" inputmode="decimal"/></div>
          <div>
            <t:parking chosen="${param.parking}" none="robots.add.parking.any"/>
          </div>
        </div>
        <t:gateway chosen="${param.gateway}"/>
        <label for="link"><fmt:message key="robots.add.link"/></label>
        <select id="link" name="link" ${isSent and not empty errors.link ? 'aria-invalid="true" aria-describedby="link-help"' : ''}>
          <option value="toqa"><fmt:message key="robots.add.link.toqa"/></option>
          <option value="http" ${param.link == 'http' ? 'selected' : ''}><fmt:message key="robots.add.link.http"/></option>
        </select>
        <c:if test="${isSent and not empty errors.link}"><small id="link-help" class="wrong"><bdi><c:out value="${errors.link}"/></bdi></small></c:if>
        <div class="grid if-http">
          <div><t:field name="token" type="password" label="robots.add.token" hint="robots.add.token.hint" optional="true"/></div>
          <div><t:field name="fingerprint" label="robots.add.fingerprint" hint="robots.add.fingerprint.hint" latin="true" optional="true"/></div>
        </div>
        <div class="if-paired"><t:field name="code" label="robots.add.code" hint="robots.add.code.hint" latin="true" optional="true"/></div>
        <button><fmt:message key="robots.add.submit"/></button>
      </form>
    </article>
  </c:if>
</t:page>
