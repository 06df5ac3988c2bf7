<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="floors.title" var="title"/>
<t:page title="${title}" here="floor" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="floors.intro"/>${" "}<t:help topic="maps"/></p>
    </div>
    <c:if test="${caller.isAdministrator()}"><a href="${root}/sites"><fmt:message key="sites.title"/></a></c:if>
  </div>
  <c:if test="${param.done == 'added'}"><p class="notice good" role="status"><fmt:message key="floors.done.added"/></p></c:if>
  <c:if test="${param.done == 'dismissed'}"><p class="notice good" role="status"><fmt:message key="floors.done.dismissed"/></p></c:if>
  <c:if test="${param.done == 'removed'}"><p class="notice good" role="status"><fmt:message key="floors.done.removed"/></p></c:if>
  <c:forEach items="${refusals}" var="refusal"><p class="notice bad" role="alert"><c:out value="${refusal}"/></p></c:forEach>
  <table class="stacks">
    <thead>
      <tr>
        <c:forTokens items="name,size,robots,tasks,state,actions" delims="," var="column"><th scope="col"><fmt:message key="floors.column.${column}"/></th></c:forTokens>
      </tr>
    </thead>
    <tbody>
      <c:forEach items="${entries}" var="entry">
        <c:set var="floor" value="${entry.summary}"/>
        <fmt:formatNumber value="${entry.width}" maxFractionDigits="2" var="width"/>
        <fmt:formatNumber value="${entry.height}" maxFractionDigits="2" var="height"/>
        <c:url value="/map" var="mapUrl"><c:param name="floor" value="${floor.name}"/></c:url>
        <tr>
          <th scope="row"><bdi><c:out value="${floor.name}"/></bdi></th>
          <td class="number" data-label="<fmt:message key="floors.column.size"/>"><fmt:message key="loads.size"><fmt:param value="${width}"/><fmt:param value="${height}"/></fmt:message></td>
          <td class="number" data-label="<fmt:message key="floors.column.robots"/>">${floor.robots}</td>
          <td class="number" data-label="<fmt:message key="floors.column.tasks"/>">${floor.openTasks}</td>
          <td data-label="<fmt:message key="floors.column.state"/>"><span class="state" data-state="${floor.state}"><fmt:message key="floor.state.${floor.state}"/></span></td>
          <td class="whole">
            <div class="choices">
              <a href="<c:out value="${mapUrl}"/>"><fmt:message key="floors.map"/></a>
              <a href="<c:out value="${root}/floors/${entry.segment()}/supervision"/>"><fmt:message key="supervision.link"/></a>
              <c:if test="${caller.mayManage()}"><a href="<c:out value="${root}/floors/${entry.segment()}/edit"/>"><fmt:message key="floors.edit"/></a><a href="<c:out value="${root}/floors/${entry.segment()}/exploration"/>"><fmt:message key="floors.explore"/></a></c:if>
              <details class="or">
                <summary><fmt:message key="floors.export"/></summary>
                <a href="<c:out value="${root}/api/v1/floors/${entry.segment()}/export?format=ros"/>" download><fmt:message key="floors.export.ros"/></a><br>
                <a href="<c:out value="${root}/api/v1/floors/${entry.segment()}/export?format=movingai"/>" download><fmt:message key="floors.export.movingai"/></a>
              </details>
              <c:if test="${caller.mayManage() and fn:length(entries) > 1}">
                <details class="or">
                  <summary role="button" class="outline secondary"><fmt:message key="floors.delete"/></summary>
                  <form method="post" action="<c:out value="${root}/floors/${entry.segment()}/delete"/>">
                    <t:csrf/>
                    <p><fmt:message key="floors.delete.sure"><fmt:param><c:out value="${floor.name}"/></fmt:param></fmt:message></p>
                    <button class="danger"><fmt:message key="floors.delete.submit"/></button>
                  </form>
                </details>
              </c:if>
            </div>
          </td>
        </tr>
      </c:forEach>
    </tbody>
  </table>
  <c:set var="isAnySeen" value="false"/>
  <c:forEach items="${entries}" var="entry"><c:if test="${not empty entry.seen}"><c:set var="isAnySeen" value="true"/></c:if></c:forEach>
  <c:if test="${caller.mayManage() and isAnySeen}">
    <article class="card">
      <h2><fmt:message key="floors.seen"/></h2>
      <p class="faint"><fmt:message key="floors.seen.intro"/></p>
      <ul class="seen">
        <c:forEach items="${entries}" var="entry">
          <c:forEach items="${entry.seen}" var="seen">
            <fmt:formatNumber value="${seen.x}" minFractionDigits="2" maxFractionDigits="2" var="x"/>
            <fmt:formatNumber value="${seen.y}" minFractionDigits="2" maxFractionDigits="2" var="y"/>
            <c:set var="target" value="${root}/floors/${entry.segment()}/seen/${seen.id}"/>
            <li>
              <span><c:set var="floorName"><c:out value="${entry.summary.name}"/></c:set><c:set var="seenBy"><c:out value="${seen.robots}"/></c:set><fmt:message key="floors.seen.at"><fmt:param value="${floorName}"/><fmt:param value="${x}, ${y}"/><fmt:param value="${seenBy}"/></fmt:message>; <fmt:message key="floors.seen.since"/> <t:time at="${seen.since}"/>, <fmt:message key="floors.seen.last"/> <t:time at="${seen.last}"/></span>
              <form method="post" action="<c:out value="${target}"/>/draw"><t:csrf/><button><fmt:message key="floors.seen.draw"/></button></form>
              <form method="post" action="<c:out value="${target}"/>/dismiss"><t:csrf/><button class="outline secondary"><fmt:message key="floors.seen.dismiss"/></button></form>
            </li>
          </c:forEach>
        </c:forEach>
      </ul>
    </article>
  </c:if>
  <c:if test="${caller.mayManage()}">
    <article class="card">
      <h2><fmt:message key="floors.add"/></h2>
      <t:errors/>
      <form method="post" action="${root}/floors" enctype="multipart/form-data" novalidate>
        <t:csrf/>
        <t:field name="name" label="floors.add.name"/>
        <div class="grid">
          <div><t:field name="width" label="floors.add.width" inputmode="decimal" value="20"/></div>
          <div><t:field name="height" label="floors.add.height" inputmode="decimal" value="15"/></div>
          <div><t:field name="resolution" label="floors.add.resolution" hint="floors.add.resolution.hint" inputmode="decimal" value="0.3"/></div>
        </div>
        <label for="file"><fmt:message key="floors.add.file"/></label>
        <input id="file" name="file" type="file" multiple accept=".zip,.yaml,.yml,.pgm,.png,.map" aria-describedby="file-help" ${empty errors.file ? '' : 'aria-invalid="true"'}>
        <small id="file-help"><c:choose><c:when test="${not empty errors.file}"><bdi><c:out value="${errors.file}"/></bdi></c:when><c:otherwise><fmt:message key="floors.add.file.hint"/></c:otherwise></c:choose></small>
        <button><fmt:message key="floors.add.submit"/></button>
      </form>
    </article>
  </c:if>
</t:page>
