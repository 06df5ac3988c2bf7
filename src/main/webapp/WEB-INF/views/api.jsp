<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="api.title" var="title"/>
<t:page title="${title}" here="api" script="api/api.js">
  <h1>${title}</h1>
  <p><fmt:message key="api.intro"/>${" "}<a href="${root}/users/${caller.account().id()}"><fmt:message key="api.tokens"/></a> · <a href="${root}/api/v1/openapi.json"><fmt:message key="api.document"/></a></p>
  <link rel="stylesheet" href="${root}/assets/swagger/swagger-ui.css">
  <script defer src="${root}/assets/swagger/swagger-ui-bundle.js"></script>
  <div id="api" lang="en" dir="ltr" data-csrf="${csrf}"></div>
</t:page>
