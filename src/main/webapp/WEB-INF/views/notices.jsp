<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="notices.title" var="title"/>
<t:page title="${title}" here="notice" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="notices.intro"/></p>
    </div>
    <div class="choices">
      <c:if test="${not caller.isVisitor()}"><a role="button" class="outline" href="${root}/notices/settings"><fmt:message key="notices.settings"/></a></c:if>
      <c:if test="${caller.isManager()}"><a role="button" class="outline" href="${root}/notices/webhooks"><fmt:message key="webhooks.title"/></a></c:if>
    </div>
  </div>
  <c:forTokens items="show,before" delims="," var="name"><c:if test="${not empty errors[name]}"><p class="notice bad"><bdi><c:out value="${errors[name]}"/></bdi></p></c:if></c:forTokens>
  <nav class="pages" aria-label="<fmt:message key="notices.show"/>">
    <c:forTokens items="all,unseen,open" delims="," var="which"><a href="${root}/notices?show=${which}" ${shown == which ? 'aria-current="page"' : ''}><fmt:message key="notices.show.${which}"/></a></c:forTokens>
  </nav>
  <c:if test="${empty lines}"><p class="notice"><fmt:message key="notices.empty.${shown}"/></p></c:if>
  <c:if test="${not empty lines}">
    <c:if test="${not caller.isVisitor()}">
      <form method="post" action="${root}/notices/seen">
        <t:csrf/>
        <input type="hidden" name="upTo" value="${newest}">
        <input type="hidden" name="show" value="${shown}">
        <button class="outline"><fmt:message key="notices.seen.all"/></button>
      </form>
    </c:if>
    <table class="stacks notice-list">
      <thead>
        <tr>
          <c:forTokens items="what,begun,ended,seen,told" delims="," var="column"><th scope="col"><fmt:message key="notices.column.${column}"/></th></c:forTokens>
          <th scope="col"><span class="unseen"><fmt:message key="notices.seen.one"/></span></th>
        </tr>
      </thead>
      <tbody>
        <c:forEach items="${lines}" var="line">
          <c:set var="notice" value="${line.entry.notice}"/>
          <tr class="${line.seen ? '' : 'unseen-notice'}">
            <th scope="row" class="whole">
              <p><fmt:message key="notices.kind.${notice.condition.kind.word()}"/></p>
              <p class="small"><t:said sentence="${notice.condition.text}"/></p>
              <c:if test="${not empty notice.condition.task}"><p class="small"><a href="${root}/tasks/${notice.condition.task}"><fmt:message key="notices.task"><fmt:param value="${notice.condition.task}"/></fmt:message></a></p></c:if>
              <c:if test="${not empty notice.condition.robot}"><c:url value="/robots/${notice.condition.robot}" var="robot"/><p class="small"><a href="<c:out value="${robot}"/>"><bdi><c:out value="${notice.condition.robot}"/></bdi></a></p></c:if>
            </th>
            <td data-label="<fmt:message key="notices.column.begun"/>"><t:time at="${notice.begunAt}"/></td>
            <td data-label="<fmt:message key="notices.column.ended"/>"><c:choose><c:when test="${notice.isOpen()}"><span class="ongoing"><fmt:message key="notices.ongoing"/></span></c:when><c:otherwise><t:time at="${notice.endedAt}"/></c:otherwise></c:choose></td>
            <td data-label="<fmt:message key="notices.column.seen"/>">
              <c:if test="${empty line.entry.seen}"><span class="faint"><fmt:message key="notices.seen.nobody"/></span></c:if>
              <c:forEach items="${line.entry.seen}" var="one"><p class="small"><bdi><c:out value="${one.name()}"/></bdi><fmt:message key="common.comma"/><t:time at="${one.at()}"/></p></c:forEach>
            </td>
            <td data-label="<fmt:message key="notices.column.told"/>">
              <c:if test="${empty line.deliveries}"><span class="faint"><fmt:message key="common.none"/></span></c:if>
              <c:forEach items="${line.deliveries}" var="told"><p class="small"><bdi dir="auto"><c:out value="${told.to}"/></bdi><c:if test="${told.ending}"> (<fmt:message key="notices.told.end"/>)</c:if>: <fmt:message key="notices.told.${told.state}"/><c:if test="${told.state == 'SENT'}">${" "}<t:time at="${told.doneAt}"/></c:if><c:if test="${not empty told.failure}"> – <bdi lang="en" dir="ltr"><c:out value="${told.failure}"/></bdi></c:if><c:if test="${told.state == 'WAITING'}"> – <fmt:message key="notices.told.next"/>${" "}<t:time at="${told.nextAt}"/></c:if></p></c:forEach>
            </td>
            <td class="whole">
              <c:if test="${not line.seen and not caller.isVisitor()}">
                <form method="post" action="${root}/notices/seen">
                  <t:csrf/>
                  <input type="hidden" name="id" value="${notice.id}">
                  <input type="hidden" name="show" value="${shown}">
                  <button class="outline"><fmt:message key="notices.seen.one"/></button>
                </form>
              </c:if>
            </td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
  </c:if>
  <nav class="pages" aria-label="${title}">
    <c:if test="${not empty param.before}"><a href="${root}/notices?show=${shown}"><fmt:message key="history.newest"/></a></c:if>
    <c:if test="${not empty next}"><a href="${root}/notices?show=${shown}&amp;before=${next}"><fmt:message key="history.older"/></a></c:if>
  </nav>
</t:page>
