<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="webhooks.title" var="title"/>
<t:page title="${title}" here="notice" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="webhooks.intro"/></p>
    </div>
    <a href="${root}/notices"><fmt:message key="notices.title"/></a>
  </div>
  <c:if test="${param.done == 'added' or param.done == 'changed' or param.done == 'tested' or param.done == 'deleted'}"><p class="notice good" role="status"><fmt:message key="webhooks.done.${param.done}"/></p></c:if>
  <t:errors/>
  <c:if test="${not empty secret}"><div class="notice good" role="status"><p><fmt:message key="webhooks.secret.once"/></p><code class="secret" dir="ltr"><c:out value="${secret}"/></code></div></c:if>
  <c:if test="${empty lines}"><p class="notice"><fmt:message key="webhooks.empty"/></p></c:if>
  <c:forEach items="${lines}" var="line">
    <c:set var="webhook" value="${line.webhook}"/>
    <c:set var="again" value="${sent == webhook.id and not empty param.url}"/>
    <c:set var="id" value="webhook-${webhook.id}"/>
    <article class="card" id="${id}">
      <h2 class="address"><bdi dir="ltr"><c:out value="${webhook.url}"/></bdi></h2>
      <p class="faint">
        <c:if test="${not webhook.enabled}"><strong><fmt:message key="webhooks.disabled"/></strong> · </c:if><fmt:message key="webhooks.by"/>${" "}<bdi><c:out value="${webhook.createdBy}"/></bdi><fmt:message key="common.comma"/><t:time at="${webhook.createdAt}"/>
        <c:if test="${not empty line.last}"> · <fmt:message key="webhooks.last"/>: <fmt:message key="notices.told.${line.last.state}"/><c:if test="${not empty line.last.doneAt}">${" "}<t:time at="${line.last.doneAt}"/></c:if><c:if test="${not empty line.last.failure}"> – <bdi lang="en" dir="ltr"><c:out value="${line.last.failure}"/></bdi></c:if></c:if>
      </p>
      <div class="choices">
        <c:forTokens items="test,secret" delims="," var="action">
          <form method="post" action="${root}/notices/webhooks/${webhook.id}/${action}"><t:csrf/><button class="outline"><fmt:message key="webhooks.${action}"/></button></form>
        </c:forTokens>
      </div>
      <details class="or"${again ? ' open' : ''}>
        <summary role="button" class="outline secondary"><fmt:message key="webhooks.change"/></summary>
        <form method="post" action="${root}/notices/webhooks/${webhook.id}/change" novalidate>
          <t:csrf/>
          <t:field name="url" id="url-${webhook.id}" label="webhooks.url" latin="true" idle="${not again}" value="${webhook.url}"/>
          <t:notice-kinds id="kinds-${webhook.id}" chosen="${webhook.kinds}" again="${again}"/>
          <label><input type="checkbox" name="enabled" value="yes"${(again ? not empty param.enabled : webhook.enabled) ? ' checked' : ''}> <fmt:message key="webhooks.enabled"/></label>
          <button><fmt:message key="notices.save"/></button>
        </form>
      </details>
      <details class="or">
        <summary role="button" class="outline secondary"><fmt:message key="webhooks.delete"/></summary>
        <form method="post" action="${root}/notices/webhooks/${webhook.id}/delete">
          <t:csrf/>
          <p><fmt:message key="webhooks.delete.sure"/></p>
          <button class="danger"><fmt:message key="webhooks.delete"/></button>
        </form>
      </details>
    </article>
  </c:forEach>
  <c:if test="${not caller.isVisitor() and fn:length(lines) < most}">
    <article class="card">
      <h2><fmt:message key="webhooks.add"/></h2>
      <form method="post" action="${root}/notices/webhooks" novalidate>
        <t:csrf/>
        <t:field name="url" label="webhooks.url" hint="webhooks.url.hint" latin="true" idle="${not empty sent}"/>
        <t:notice-kinds id="kinds" again="${empty sent and not empty errors}"/>
        <button><fmt:message key="webhooks.add"/></button>
      </form>
    </article>
  </c:if>
</t:page>
