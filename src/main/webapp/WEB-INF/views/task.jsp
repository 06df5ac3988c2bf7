<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="task.title" var="title"><fmt:param value="${task.task.id}"/></fmt:message>
<fmt:formatNumber value="${task.task.load}" maxFractionDigits="2" var="load"/>
<t:page title="${title}" here="task" script="live.js">
  <div id="live" data-live="task" data-name="${task.task.id}">
    <div class="heading">
      <div>
        <p class="faint">${title}</p>
        <h1><c:out value="${task.task.name}"/></h1>
      </div>
      <t:state of="task" state="${task.state}"/>
    </div>
    <c:if test="${not empty task.waitingFor}"><p class="notice"><strong><fmt:message key="task.waitingFor"/></strong>${" "}<c:out value="${task.waitingFor}"/></p></c:if>
    <c:if test="${task.held}"><p class="notice"><fmt:message key="task.held"/></p></c:if>
    <c:if test="${not empty task.needs}"><p class="notice bad"><strong><fmt:message key="task.needs"/></strong>${" "}<c:out value="${task.needs.question}"/></p></c:if>
    <c:if test="${reached >= 0}">
      <fmt:message key="task.road" var="label"/>
      <ol class="road" aria-label="${label}">
        <c:forEach items="${road}" var="state" varStatus="at">
          <li class="${at.index < reached or state == 'DONE' and reached == at.index ? 'passed' : at.index == reached ? 'here' : 'ahead'}" ${at.index == reached ? 'aria-current="step"' : ''}><fmt:message key="task.state.${state}"/></li>
        </c:forEach>
      </ol>
    </c:if>
    <div class="columns">
      <article>
        <dl>
          <dt><fmt:message key="task.load"/></dt><dd><fmt:message key="common.kilograms"><fmt:param value="${load}"/></fmt:message></dd>
          <dt><fmt:message key="task.start"/></dt><dd><t:place place="${task.task.start}"/></dd>
          <dt><fmt:message key="task.goal"/></dt><dd><t:place place="${task.task.goal}"/></dd>
          <dt><fmt:message key="task.floor"/></dt><dd><c:out value="${task.task.floor}"/></dd>
          <dt><fmt:message key="task.robots"/></dt><dd><t:robots names="${task.robots}"/></dd>
          <dt><fmt:message key="task.user"/></dt><dd><c:out value="${task.task.user}"/></dd>
          <dt><fmt:message key="task.created"/></dt><dd><t:time at="${task.task.createdAt}"/></dd>
          <dt><fmt:message key="task.changed"/></dt><dd><t:time at="${task.changedAt}"/></dd>
        </dl>
        <a href="${root}/map"><fmt:message key="task.onMap"/></a>
      </article>
      <article>
        <h2><fmt:message key="task.history"/></h2>
        <c:if test="${empty history}"><p class="faint"><fmt:message key="task.history.empty"/></p></c:if>
        <ol class="history">
          <c:forEach items="${history}" var="event">
            <li><p><c:out value="${event.text}"/></p><p class="faint"><t:time at="${event.at}"/> · <c:out value="${event.who}"/></p></li>
          </c:forEach>
        </ol>
      </article>
    </div>
  </div>
</t:page>
