<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="tasks.title" var="title"/>
<t:page title="${title}" here="task" script="live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="tasks.count"><fmt:param value="${count}"/></fmt:message></p>
    </div>
    <div class="choices">
      <a role="button" class="outline secondary" href="${root}/history"><fmt:message key="tasks.history"/></a>
      <a role="button" class="outline secondary" href="${root}/tasks/import"><fmt:message key="tasks.import"/></a>
      <a role="button" href="${root}/tasks/new"><fmt:message key="tasks.new"/></a>
    </div>
  </div>
  <c:if test="${not empty imported}"><p class="notice good" role="status"><fmt:message key="tasks.imported"><fmt:param value="${imported}"/></fmt:message></p></c:if>
  <div id="live" data-live="tasks">
    <c:if test="${empty tasks}"><p class="notice"><fmt:message key="tasks.empty"/></p></c:if>
    <c:if test="${not empty tasks}">
      <table class="stacks">
        <thead>
          <tr>
            <th scope="col"><fmt:message key="tasks.column.id"/></th>
            <th scope="col"><fmt:message key="tasks.column.name"/></th>
            <th scope="col"><fmt:message key="tasks.column.state"/></th>
            <th scope="col"><fmt:message key="tasks.column.load"/></th>
            <th scope="col"><fmt:message key="tasks.column.way"/></th>
            <th scope="col"><fmt:message key="tasks.column.robots"/></th>
            <th scope="col"><fmt:message key="tasks.column.user"/></th>
            <th scope="col"><fmt:message key="tasks.column.created"/></th>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${tasks}" var="view">
            <fmt:formatNumber value="${view.task.load}" maxFractionDigits="2" var="load"/>
            <tr>
              <td class="number">${view.task.id}</td>
              <th scope="row"><a href="${root}/tasks/${view.task.id}"><bdi><c:out value="${view.task.name}"/></bdi></a></th>
              <td><t:state of="task" state="${view.state}"/></td>
              <td class="number" data-label="<fmt:message key="tasks.column.load"/>"><fmt:message key="common.kilograms"><fmt:param value="${load}"/></fmt:message></td>
              <td data-label="<fmt:message key="tasks.column.way"/>"><t:place place="${view.task.start}"/> – <t:place place="${view.task.goal}"/></td>
              <td data-label="<fmt:message key="tasks.column.robots"/>"><t:robots names="${view.robots}"/></td>
              <td data-label="<fmt:message key="tasks.column.user"/>"><bdi><c:out value="${view.task.user}"/></bdi></td>
              <td data-label="<fmt:message key="tasks.column.created"/>"><t:time at="${view.task.createdAt}"/></td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </c:if>
  </div>
  <c:if test="${pages > 1}">
    <fmt:message key="tasks.pages" var="label"/>
    <nav class="pages" aria-label="${label}">
      <c:if test="${page > 1}"><a rel="prev" href="${root}/tasks?page=${page - 1}"><fmt:message key="tasks.newer"/></a></c:if>
      <span><fmt:message key="tasks.page"><fmt:param value="${page}"/><fmt:param value="${pages}"/></fmt:message></span>
      <c:if test="${page < pages}"><a rel="next" href="${root}/tasks?page=${page + 1}"><fmt:message key="tasks.older"/></a></c:if>
    </nav>
  </c:if>
</t:page>
