<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="users.title" var="title"/>
<t:page title="${title}" here="user">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="users.count"><fmt:param value="${count}"/></fmt:message></p>
    </div>
    <c:if test="${caller.isAdministrator()}"><a href="${root}/sites"><fmt:message key="sites.title"/></a></c:if>
  </div>
  <c:if test="${param.done == 'added' or param.done == 'deleted'}"><p class="notice good" role="status"><fmt:message key="users.done.${param.done}"/></p></c:if>
  <c:set var="isSent" value="${pageContext.request.method == 'POST'}"/>
  <c:if test="${isSent}"><t:errors/></c:if>
  <details ${isFiltered or not isSent and not empty errors ? 'open' : ''}>
    <summary><fmt:message key="tasks.filter"/></summary>
    <form method="get" action="${root}/users" class="filter" role="search">
      <label><fmt:message key="users.filter.text"/>
        <input name="text" type="search" value="${isSent ? '' : fn:escapeXml(param.text)}" dir="auto" autocomplete="off">
      </label>
      <label><fmt:message key="users.column.role"/>
        <select name="role" ${isSent or empty errors.role ? '' : 'aria-invalid="true"'}>
          <option value=""><fmt:message key="history.all"/></option>
          <c:forEach items="${roles}" var="one"><option value="${fn:toLowerCase(one)}" ${not isSent and param.role == fn:toLowerCase(one) ? 'selected' : ''}><fmt:message key="users.role.${one}"/></option></c:forEach>
        </select>
        <c:if test="${not isSent and not empty errors.role}"><small><bdi><c:out value="${errors.role}"/></bdi></small></c:if>
      </label>
      <button><fmt:message key="history.filter"/></button>
    </form>
  </details>
  <c:if test="${empty users}"><p class="notice"><fmt:message key="users.filter.none"/></p></c:if>
  <c:if test="${not empty users}">
  <table class="stacks">
    <thead>
      <tr>
        <th scope="col"><fmt:message key="users.column.name"/></th>
        <th scope="col"><fmt:message key="users.column.role"/></th>
        <th scope="col"><fmt:message key="users.column.email"/></th>
        <th scope="col"><fmt:message key="users.column.since"/></th>
      </tr>
    </thead>
    <tbody>
      <c:forEach items="${users}" var="user">
        <tr>
          <th scope="row"><a href="${root}/users/${user.id}"><bdi><c:out value="${user.name}"/></bdi></a><c:if test="${user.id == caller.account.id}">${" "}<span class="faint">(<fmt:message key="users.you"/>)</span></c:if></th>
          <td><fmt:message key="users.role.${user.role}"/><c:if test="${user.disabled()}">, <strong><fmt:message key="users.disabled"/></strong></c:if></td>
          <td data-label="<fmt:message key="users.column.email"/>"><c:choose><c:when test="${empty user.email}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><bdi dir="ltr"><c:out value="${user.email}"/></bdi></c:otherwise></c:choose></td>
          <td data-label="<fmt:message key="users.column.since"/>"><t:time at="${user.createdAt}"/></td>
        </tr>
      </c:forEach>
    </tbody>
  </table>
  <t:pages path="/users" kept="text,role"/>
  </c:if>
  <article class="card">
    <h2><fmt:message key="users.add"/>${" "}<t:help topic="users"/></h2>
    <form method="post" action="${root}/users" novalidate>
      <t:csrf/>
      <div class="grid">
        <div><t:field name="name" label="users.add.name" hint="users.add.name.hint"/></div>
        <div><t:field name="password" label="users.add.password" type="password" hint="firstStart.password.hint" autocomplete="new-password"/></div>
      </div>
      <div class="grid">
        <div><t:field name="email" label="users.email" type="email" hint="users.email.hint" optional="true"/></div>
        <div><t:role chosen="${param.role}"/></div>
      </div>
      <button><fmt:message key="users.add.submit"/></button>
    </form>
  </article>
</t:page>
