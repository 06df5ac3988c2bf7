<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="help.title" var="title"/>
<t:page title="${empty documentTitle ? title : documentTitle}" here="help">
  <c:choose>
    <c:when test="${empty document}">
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="help.intro"/></p>
      <ul lang="en" dir="ltr">
        <c:forEach items="${topics}" var="topic"><li><a href="${root}/help/${topic.name()}"><c:out value="${topic.title()}"/></a></li></c:forEach>
      </ul>
    </c:when>
    <c:otherwise>
      <p><a href="${root}/help"><fmt:message key="help.all"/></a></p>
      <article class="document" lang="en" dir="ltr">${document}</article>
    </c:otherwise>
  </c:choose>
</t:page>
