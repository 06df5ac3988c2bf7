<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="turns the pages of a list; finds page and pages in the request" %>
<%@ attribute name="path" required="true" description="of the list" %>
<%@ attribute name="kept" required="true" description="the fields of its query, with commas between" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:if test="${pages > 1}">
  <fmt:message key="tasks.pages" var="label"/>
  <nav class="pages" aria-label="${label}">
    <c:forTokens items="previous,next" delims="," var="turn">
      <c:set var="other" value="${turn == 'previous' ? page - 1 : page + 1}"/>
      <c:if test="${turn == 'next'}"><span><fmt:message key="tasks.page"><fmt:param value="${page}"/><fmt:param value="${pages}"/></fmt:message></span></c:if>
      <c:if test="${other >= 1 and other <= pages}">
        <c:url value="${path}" var="target">
          <c:param name="page" value="${other}"/>
          <c:forTokens items="${kept}" delims="," var="name"><c:if test="${not empty param[name]}"><c:param name="${name}" value="${param[name]}"/></c:if></c:forTokens>
        </c:url>
        <a rel="${turn == 'previous' ? 'prev' : 'next'}" href="<c:out value="${target}"/>"><fmt:message key="tasks.${turn}"/></a>
      </c:if>
    </c:forTokens>
  </nav>
</c:if>
