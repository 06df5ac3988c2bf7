<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="loads.title" var="title"/>
<t:page title="${title}" here="task" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="loads.intro"/>${" "}<t:help topic="tasks" section="loads"/></p>
    </div>
    <c:if test="${caller.mayOrder()}"><div class="choices"><a role="button" href="${root}/tasks/new"><fmt:message key="tasks.new"/></a></div></c:if>
  </div>
  <c:if test="${fn:length(floors) > 1 or not empty param.floor}">
    <form method="get" action="${root}/loads" class="filter"><t:floor-choice/><button><fmt:message key="history.filter"/></button></form>
  </c:if>
  <div id="live" data-live="loads">
    <c:if test="${empty loads}"><p class="notice"><fmt:message key="loads.empty"/></p></c:if>
    <c:if test="${not empty loads}">
      <table class="stacks">
        <thead>
          <tr>
            <c:forTokens items="id,name,weight,size,where,since,task,actions" delims="," var="column"><th scope="col"><fmt:message key="loads.column.${column}"/></th></c:forTokens>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${loads}" var="load">
            <fmt:formatNumber value="${load.weight}" maxFractionDigits="2" var="weight"/>
            <tr>
              <td class="number">${load.id()}</td>
              <th scope="row"><bdi><c:out value="${load.name}"/></bdi></th>
              <td class="number" data-label="<fmt:message key="loads.column.weight"/>"><fmt:message key="common.kilograms"><fmt:param value="${weight}"/></fmt:message></td>
              <td data-label="<fmt:message key="loads.column.size"/>"><c:choose><c:when test="${empty load.size}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><fmt:formatNumber value="${load.size.length}" maxFractionDigits="2" var="length"/><fmt:formatNumber value="${load.size.width}" maxFractionDigits="2" var="width"/><fmt:message key="loads.size"><fmt:param value="${length}"/><fmt:param value="${width}"/></fmt:message></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="loads.column.where"/>"><span><c:choose>
                <c:when test="${empty load.place}"><fmt:message key="loads.on"/>${" "}<t:robots names="${load.robots}"/></c:when>
                <c:when test="${load.isLeft}"><fmt:message key="loads.onFloor"/>${" "}<t:place place="${load.place}"/></c:when>
                <c:otherwise><t:place place="${load.place}"/></c:otherwise>
              </c:choose><c:if test="${fn:length(floors) > 1}"><br><small class="faint"><bdi><c:out value="${load.floor}"/></bdi></small></c:if></span></td>
              <td data-label="<fmt:message key="loads.column.since"/>"><t:time at="${load.load.since}"/></td>
              <td data-label="<fmt:message key="loads.column.task"/>"><a href="${root}/tasks/${load.task}">${load.task}</a></td>
              <td class="whole">
                <div class="choices">
                  <a href="${root}/map?task=${load.task}"><fmt:message key="task.onMap"/></a>
                  <c:if test="${load.isLeft}">
                    <c:choose>
                      <c:when test="${not empty load.fetchedBy}"><a href="${root}/tasks/${load.fetchedBy}"><fmt:message key="loads.fetchedBy"><fmt:param value="${load.fetchedBy}"/></fmt:message></a></c:when>
                      <c:otherwise>
                        <c:url value="/tasks/new" var="fetch">
                          <c:param name="name" value="${load.name}"/>
                          <c:param name="load" value="${load.weight}"/>
                          <c:param name="floor" value="${load.floor}"/>
                          <c:param name="length" value="${load.size.length}"/>
                          <c:param name="width" value="${load.size.width}"/>
                          <c:param name="startX" value="${load.place.position.x}"/>
                          <c:param name="startY" value="${load.place.position.y}"/>
                        </c:url>
                        <a href="<c:out value="${fetch}"/>"><fmt:message key="loads.fetch"/></a>
                      </c:otherwise>
                    </c:choose>
                    <a href="${root}/tasks/${load.task}#actions"><fmt:message key="loads.change"/></a>
                  </c:if>
                </div>
              </td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </c:if>
  </div>
</t:page>
