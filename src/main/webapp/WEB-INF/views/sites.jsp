<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="sites.title" var="title"/>
<t:page title="${title}" here="sites">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="sites.intro"/>${" "}<t:help topic="users" section="sites"/></p>
    </div>
  </div>
  <c:if test="${param.done == 'added' or param.done == 'removed'}"><p class="notice good" role="status"><fmt:message key="sites.done.${param.done}"/></p></c:if>
  <c:forEach items="${refusals}" var="refusal"><p class="notice bad" role="alert"><c:out value="${refusal}"/></p></c:forEach>
  <table class="stacks">
    <thead>
      <tr>
        <c:forTokens items="name,floors,robots,tasks,users,state,actions" delims="," var="column"><th scope="col"><fmt:message key="sites.column.${column}"/></th></c:forTokens>
      </tr>
    </thead>
    <tbody>
      <c:forEach items="${sites}" var="site" varStatus="place">
        <c:url value="/sites/${site.name}" var="target"/>
        <tr>
          <th scope="row"><bdi><c:out value="${site.name}"/></bdi><c:if test="${site.name == visited}">${" "}<span class="faint">(<fmt:message key="sites.visited"/>)</span></c:if></th>
          <c:choose>
            <c:when test="${site.state == 'READY'}">
              <td class="number" data-label="<fmt:message key="sites.column.floors"/>">${site.floors}</td>
              <td class="number" data-label="<fmt:message key="sites.column.robots"/>">${site.robots}</td>
              <td class="number" data-label="<fmt:message key="sites.column.tasks"/>">${site.openTasks}</td>
              <td class="number" data-label="<fmt:message key="sites.column.users"/>">${site.users}</td>
              <td data-label="<fmt:message key="sites.column.state"/>"><span class="state" data-state="READY"><fmt:message key="floor.state.READY"/></span></td>
            </c:when>
            <c:otherwise>
              <td class="whole" colspan="4"><bdi><c:out value="${site.failure}"/></bdi></td>
              <td data-label="<fmt:message key="sites.column.state"/>"><span class="state" data-state="FAILED"><fmt:message key="floor.state.FAILED"/></span></td>
            </c:otherwise>
          </c:choose>
          <td class="whole">
            <div class="choices">
              <c:if test="${site.state == 'READY' and (place.first ? not empty visited : site.name != visited)}">
                <form method="post" action="<c:out value="${target}"/>/visit">
                  <t:csrf/>
                  <button class="outline"><fmt:message key="${place.first ? 'sites.back' : 'sites.visit'}"/></button>
                </form>
              </c:if>
              <c:if test="${not place.first}">
                <details class="or">
                  <summary role="button" class="outline secondary"><fmt:message key="sites.delete"/></summary>
                  <form method="post" action="<c:out value="${target}"/>/delete">
                    <t:csrf/>
                    <p><fmt:message key="sites.delete.sure"><fmt:param><bdi><c:out value="${site.name}"/></bdi></fmt:param></fmt:message></p>
                    <button class="danger"><fmt:message key="sites.delete.submit"/></button>
                  </form>
                </details>
              </c:if>
            </div>
          </td>
        </tr>
      </c:forEach>
    </tbody>
  </table>
  <article class="card">
    <h2><fmt:message key="sites.add"/></h2>
    <t:errors/>
    <form method="post" action="${root}/sites" novalidate>
      <t:csrf/>
      <t:field name="name" label="sites.add.name" hint="sites.add.name.hint"/>
      <div class="grid">
        <div><t:field name="manager" label="sites.add.manager" hint="users.add.name.hint" autocomplete="off"/></div>
        <div><t:field name="password" label="sites.add.password" type="password" hint="firstStart.password.hint" autocomplete="new-password"/></div>
      </div>
      <button><fmt:message key="sites.add.submit"/></button>
    </form>
  </article>
</t:page>
