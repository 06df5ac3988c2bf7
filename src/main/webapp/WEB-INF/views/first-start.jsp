<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="firstStart.title" var="title"/>
<t:page title="${title}" layout="narrow">
  <article class="card">
    <h1>${title}</h1>
    <p><fmt:message key="firstStart.intro"/></p>
    <t:errors/>
    <form method="post" action="${root}/first-start" novalidate>
      <t:csrf/>
      <t:field name="code" label="firstStart.code" hint="firstStart.code.hint" latin="true" focus="true"/>
      <t:field name="name" label="firstStart.name" autocomplete="username"/>
      <t:field name="password" label="firstStart.password" type="password" hint="firstStart.password.hint" autocomplete="new-password"/>
      <t:field name="repeat" label="firstStart.repeat" type="password" hint="firstStart.repeat.hint" autocomplete="new-password"/>
      <button><fmt:message key="firstStart.submit"/></button>
    </form>
  </article>
</t:page>
