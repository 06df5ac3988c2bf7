<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="forgotten.title" var="title"/>
<t:page title="${title}" layout="narrow">
  <article class="card">
    <h1>${title}</h1>
    <t:errors/>
    <c:choose>
      <c:when test="${not byMail}"><p><fmt:message key="forgotten.manager"/></p></c:when>
      <c:when test="${param.done == 'sent'}"><p class="notice good" role="status"><fmt:message key="forgotten.sent"/></p></c:when>
      <c:otherwise>
        <p class="faint"><fmt:message key="forgotten.intro"/></p>
        <form method="post" action="${root}/forgotten" novalidate>
          <t:csrf/>
          <t:field name="user" label="forgotten.user" autocomplete="username" focus="true"/>
          <button><fmt:message key="forgotten.submit"/></button>
        </form>
      </c:otherwise>
    </c:choose>
    <a href="${root}/"><fmt:message key="forgotten.back"/></a>
  </article>
</t:page>
