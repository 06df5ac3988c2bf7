<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="reset.title" var="title"/>
<t:page title="${title}" layout="narrow">
  <article class="card">
    <h1>${title}</h1>
    <t:errors/>
    <c:choose>
      <c:when test="${empty user}"><p class="notice bad" role="alert"><fmt:message key="reset.expired"/></p><a href="${root}/forgotten"><fmt:message key="reset.requestLink"/></a></c:when>
      <c:otherwise>
        <p class="faint"><fmt:message key="reset.intro"><fmt:param><bdi><c:out value="${user.name}"/></bdi></fmt:param></fmt:message></p>
        <form method="post" action="${root}/reset" novalidate>
          <t:csrf/>
          <input type="text" name="username" value="<c:out value="${user.name}"/>" autocomplete="username" hidden>
          <t:field name="password" label="users.password.new" type="password" hint="firstStart.password.hint" autocomplete="new-password" focus="true"/>
          <button><fmt:message key="reset.submit"/></button>
        </form>
      </c:otherwise>
    </c:choose>
  </article>
</t:page>
