<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="login.title" var="title"/>
<t:page title="${title}" layout="narrow">
  <article class="card">
    <h1>${title}</h1>
    <p class="faint"><fmt:message key="product.claim"/></p>
    <c:if test="${param.done == 'reset'}"><p class="notice good" role="status"><fmt:message key="login.done.reset"/></p></c:if>
    <t:errors/>
    <form method="post" action="${root}/" novalidate>
      <t:csrf/>
      <input type="hidden" name="next" value="${fn:escapeXml(param.next)}">
      <t:field name="name" label="login.name" autocomplete="username" focus="true"/>
      <t:field name="password" label="login.password" type="password" autocomplete="current-password"/>
      <button><fmt:message key="login.submit"/></button>
    </form>
    <a href="${root}/forgotten"><fmt:message key="login.forgotten"/></a>
  </article>
</t:page>
