<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<t:page title="${heading}" layout="narrow">
  <article class="card">
    <p class="status">${status}</p>
    <h1>${heading}</h1>
    <p><c:out value="${sentence}"/></p>
    <a role="button" href="${root}/${empty caller ? '' : 'map'}"><fmt:message key="${empty caller ? 'error.login' : 'error.back'}"/></a>
  </article>
</t:page>
