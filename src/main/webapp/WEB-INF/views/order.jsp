<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="parts" value="${order.current()}"/>
<c:set var="first" value="${parts[0].task}"/>
<fmt:message key="order.title" var="title"><fmt:param value="${order.id}"/></fmt:message>
<fmt:message key="order.progress" var="progress"><fmt:param value="${order.delivered()}"/><fmt:param value="${order.parts}"/></fmt:message>
<fmt:message key="order.progress.label" var="progressLabel"/>
<fmt:formatNumber value="${first.load}" maxFractionDigits="2" var="load"/>
<t:page title="${title}" here="task" script="shared/live.js">
  <t:errors/>
  <div id="live" data-live="order" data-name="${order.id}">
    <div class="heading">
      <div>
        <p class="faint">${title}</p>
        <h1><bdi><c:out value="${order.name}"/></bdi></h1>
      </div>
      <span class="state" data-state="${order.state()}"><fmt:message key="order.state.${order.state()}"/></span>
    </div>
    <p class="progress"><progress aria-label="${progressLabel}" value="${order.delivered()}" max="${order.parts}"></progress> <strong id="progress">${progress}</strong></p>
    <c:if test="${order.held() > 0}"><p class="notice" id="held"><fmt:message key="order.held"><fmt:param value="${order.held()}"/><fmt:param value="${order.open().size()}"/></fmt:message></p></c:if>
    <c:forEach items="${stuck}" var="part">
      <p class="notice bad"><strong><a href="${root}/tasks/${part.task.id}"><fmt:message key="order.part.${order.kind}"><fmt:param value="${part.task.task.part.position}"/><fmt:param value="${order.parts}"/></fmt:message></a></strong>${" "}<t:said sentence="${part.why}"/></p>
    </c:forEach>
    <article>
      <dl>
        <dt><fmt:message key="order.kind"/></dt><dd><fmt:message key="order.kind.${order.kind}"><fmt:param value="${order.parts}"/><fmt:param value="${load}"/></fmt:message></dd>
        <c:choose>
          <c:when test="${order.kind == 'PIECES'}">
            <dt><fmt:message key="task.start"/></dt><dd><t:place place="${first.start}"/></dd>
            <dt><fmt:message key="task.goal"/></dt><dd><t:place place="${first.goal}"/></dd>
          </c:when>
          <c:otherwise><dt><fmt:message key="order.stops"/></dt><dd><t:place place="${first.start}"/><c:forEach items="${parts}" var="leg"> – <t:place place="${leg.task.goal}"/></c:forEach></dd></c:otherwise>
        </c:choose>
        <dt><fmt:message key="task.floor"/></dt><dd><bdi><c:out value="${first.floor}"/></bdi></dd>
        <dt><fmt:message key="task.user"/></dt><dd><bdi><c:out value="${first.user}"/></bdi></dd>
        <dt><fmt:message key="task.created"/></dt><dd><t:time at="${order.createdAt}"/></dd>
      </dl>
    </article>
    <h2><fmt:message key="order.parts.${order.kind}"/></h2>
    <table class="stacks">
      <thead>
        <tr>
          <th scope="col"><fmt:message key="order.parts.number"/></th>
          <th scope="col"><fmt:message key="order.parts.task"/></th>
          <th scope="col"><fmt:message key="tasks.column.state"/></th>
          <c:if test="${order.kind == 'STOPS'}"><th scope="col"><fmt:message key="tasks.column.fromTo"/></th></c:if>
          <th scope="col"><fmt:message key="tasks.column.robots"/></th>
          <th scope="col"><fmt:message key="order.parts.waiting"/></th>
        </tr>
      </thead>
      <tbody>
        <c:forEach items="${parts}" var="view">
          <tr>
            <td class="number">${view.task.part.position}</td>
            <th scope="row"><a href="${root}/tasks/${view.task.id}"><fmt:message key="task.title"><fmt:param value="${view.task.id}"/></fmt:message></a></th>
            <td><t:state of="task" state="${view.state}"/></td>
            <c:if test="${order.kind == 'STOPS'}"><td data-label="<fmt:message key="tasks.column.fromTo"/>"><t:place place="${view.task.start}"/> – <t:place place="${view.task.goal}"/></td></c:if>
            <td data-label="<fmt:message key="tasks.column.robots"/>"><t:robots names="${view.robots}"/></td>
            <td data-label="<fmt:message key="order.parts.waiting"/>"><c:choose><c:when test="${not empty view.waitingFor}"><t:said sentence="${view.waitingFor}"/></c:when><c:otherwise>–</c:otherwise></c:choose></td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
  </div>
  <article class="card" id="actions" data-live="order-actions" data-name="${order.id}" ${mayChange ? '' : 'hidden'}>
    <h2><fmt:message key="task.actions"/></h2>
    <c:if test="${mayChange and not empty order.open()}">
      <c:if test="${order.held() < order.open().size()}">
        <form class="choices" method="post" action="${root}/orders/${order.id}/hold">
          <t:csrf/>
          <button class="outline" aria-describedby="hold-help"><fmt:message key="order.hold"/></button>
          <small id="hold-help" class="faint"><fmt:message key="order.hold.help"/></small>
        </form>
      </c:if>
      <c:if test="${order.held() > 0}">
        <form class="choices" method="post" action="${root}/orders/${order.id}/resume">
          <t:csrf/>
          <button class="outline"><fmt:message key="order.resume"/></button>
        </form>
      </c:if>
      <form class="inline" method="post" action="${root}/orders/${order.id}/priority">
        <t:csrf/>
        <label for="priority"><fmt:message key="newTask.priority"/></label>
        <select id="priority" name="priority">
          <c:if test="${not empty priority and priority != 10 and priority != 0 and priority != -10}"><option value="${priority}" selected>${priority}</option></c:if>
          <c:forTokens items="10,0,-10" delims="," var="level"><option value="${level}" ${level == (empty priority ? 0 : priority) ? 'selected' : ''}><fmt:message key="newTask.priority.${level}"/></option></c:forTokens>
        </select>
        <button class="outline"><fmt:message key="task.priority.submit"/></button>
      </form>
    </c:if>
    <c:if test="${mayChange and mayRetry}">
      <form class="choices" method="post" action="${root}/orders/${order.id}/retry">
        <t:csrf/>
        <button class="outline" aria-describedby="retry-help"><fmt:message key="order.retry"/></button>
        <small id="retry-help" class="faint"><fmt:message key="order.retry.help"/></small>
      </form>
    </c:if>
    <c:if test="${mayChange and not empty order.open()}">
      <details>
        <summary role="button" class="outline secondary"><fmt:message key="order.cancel"/></summary>
        <form method="post" action="${root}/orders/${order.id}/cancel">
          <t:csrf/>
          <p><fmt:message key="order.cancel.sure.${carrying ? 'carrying' : 'before'}"/></p>
          <div class="choices">
            <c:choose>
              <c:when test="${carrying}">
                <button class="danger" name="load" value="here"><fmt:message key="order.cancel.here"/></button>
                <button class="danger" name="load" value="back"><fmt:message key="order.cancel.back"/></button>
              </c:when>
              <c:otherwise><button class="danger"><fmt:message key="task.cancel.submit"/></button></c:otherwise>
            </c:choose>
          </div>
        </form>
      </details>
    </c:if>
    <c:if test="${empty order.open() and not mayRetry}"><p class="faint"><fmt:message key="order.ended"/></p></c:if>
  </article>
</t:page>
