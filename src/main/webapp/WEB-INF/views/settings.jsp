<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="settings.title" var="title"/>
<t:page title="${title}" here="settings">
  <h1>${title}</h1>
  <c:if test="${param.done == 'changed'}"><p class="notice good" role="status"><fmt:message key="settings.done.changed"/></p></c:if>
  <t:errors/>
  <article class="card">
    <h2><fmt:message key="settings.running"/></h2>
    <dl>
      <c:forEach items="${floorViews}" var="view">
        <dt><fmt:message key="floor.allocator"/>: <bdi><c:out value="${view.name}"/></bdi></dt>
        <dd><fmt:message key="floor.allocator.${empty allocators[view.name] ? 'configured' : allocators[view.name]}"/> · <c:url value="/map" var="map"><c:param name="floor" value="${view.name}"/></c:url><a href="<c:out value="${map}"/>"><fmt:message key="settings.onMap"/></a></dd>
      </c:forEach>
    </dl>
    <c:if test="${not empty logLevel}">
      <form class="inline" method="post" action="${root}/settings/log-level">
        <t:csrf/>
        <label for="logLevel"><fmt:message key="settings.logLevel"/></label>
        <select id="logLevel" name="logLevel" dir="ltr" ${caller.isAdministrator() ? '' : 'disabled'} ${empty errors.logLevel ? '' : 'aria-invalid="true" aria-describedby="logLevel-help"'}>
          <c:forEach items="${logLevels}" var="level"><option ${level == logLevel ? 'selected' : ''}>${level}</option></c:forEach>
        </select>
        <c:if test="${caller.isAdministrator()}"><button class="outline"><fmt:message key="users.change.submit"/></button></c:if>
        <small id="logLevel-help" class="${empty errors.logLevel ? 'faint' : 'wrong'}"><c:choose><c:when test="${empty errors.logLevel}"><fmt:message key="settings.logLevel.hint"/></c:when><c:otherwise><c:out value="${errors.logLevel}"/></c:otherwise></c:choose></small>
      </form>
    </c:if>
    <p class="faint"><fmt:message key="settings.elsewhere"/></p>
  </article>
  <c:if test="${not empty settings}">
    <article class="card">
      <h2><fmt:message key="settings.configuration"/>${" "}<t:help topic="configuration"/></h2>
      <p class="faint"><fmt:message key="settings.configuration.intro"/></p>
      <table class="stacks">
        <thead>
          <tr>
            <th scope="col"><fmt:message key="settings.column.key"/></th>
            <th scope="col"><fmt:message key="settings.column.value"/></th>
            <th scope="col"><fmt:message key="settings.column.origin"/></th>
            <th scope="col"><fmt:message key="settings.column.allowed"/></th>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${settings}" var="one">
            <tr>
              <th scope="row"><code dir="ltr"><c:out value="${one.key()}"/></code></th>
              <td data-label="<fmt:message key="settings.column.value"/>"><c:choose><c:when test="${one.value() == null}"><em><fmt:message key="settings.secret"/></em></c:when><c:when test="${one.value().isEmpty()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><bdi dir="ltr"><c:out value="${one.value()}"/></bdi></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="settings.column.origin"/>"><c:choose><c:when test="${empty one.origin()}"><span class="faint"><fmt:message key="settings.default"/></span></c:when><c:otherwise><bdi dir="ltr"><c:out value="${one.origin()}"/></bdi></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="settings.column.allowed"/>"><small lang="en" dir="ltr"><c:out value="${one.allowed()}"/></small></td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </article>
  </c:if>
</t:page>
