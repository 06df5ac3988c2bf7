<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="manager" value="${caller.isManager()}"/>
<fmt:message key="${manager ? 'users.title' : 'users.own'}" var="title"/>
<t:page title="${title}" here="user">
  <div class="heading"><h1>${title}</h1></div>
  <c:if test="${param.done == 'added' or param.done == 'changed' or param.done == 'deleted' or param.done == 'password'}"><p class="notice good" role="status"><fmt:message key="users.done.${param.done}"/></p></c:if>
  <c:if test="${not empty errors}"><t:errors/></c:if>
  <div class="users">
    <c:forEach items="${users}" var="user">
      <c:set var="field" value="user${user.id}"/>
      <c:set var="own" value="${user.id == caller.account.id}"/>
      <article class="user">
        <div>
          <strong><c:out value="${user.name}"/></strong>
          <c:if test="${own}"><span class="faint">(<fmt:message key="users.you"/>)</span></c:if>
          <p class="faint"><fmt:message key="users.role.${user.role}"/><c:if test="${user.disabled()}">, <strong><fmt:message key="users.disabled"/></strong></c:if> · <fmt:message key="users.since"/>${" "}<t:time at="${user.createdAt}"/></p>
          <c:if test="${not empty errors[field]}"><p class="wrong" id="${field}-help"><c:out value="${errors[field]}"/></p></c:if>
        </div>
        <div class="actions">
          <details ${not empty errors[field] and fn:endsWith(path, '/password') ? 'open' : ''}>
            <summary role="button" class="outline"><fmt:message key="users.password"/></summary>
            <form method="post" action="${root}/users/${user.id}/password" novalidate>
              <t:csrf/>
              <c:if test="${own}"><t:field name="old" id="old${user.id}" label="users.password.old" type="password" autocomplete="current-password"/></c:if>
              <t:field name="password" id="${field}" errorAt="none" label="users.password.new" type="password" hint="firstStart.password.hint" autocomplete="new-password"/>
              <button><fmt:message key="users.password.submit"/></button>
            </form>
          </details>
          <c:if test="${manager}">
            <details>
              <summary role="button" class="outline"><fmt:message key="users.change"/></summary>
              <form method="post" action="${root}/users/${user.id}/change">
                <t:csrf/>
                <label for="role${user.id}"><fmt:message key="users.add.role"/></label>
                <select id="role${user.id}" name="role">
                  <option value="CLERK"><fmt:message key="users.role.CLERK"/></option>
                  <option value="MANAGER" ${user.isManager() ? 'selected' : ''}><fmt:message key="users.role.MANAGER"/></option>
                </select>
                <label><input type="checkbox" name="disabled" ${user.disabled() ? 'checked' : ''}> <fmt:message key="users.change.disabled"/></label>
                <p class="faint"><fmt:message key="users.change.disabled.hint"/></p>
                <button><fmt:message key="users.change.submit"/></button>
              </form>
            </details>
            <details>
              <summary role="button" class="outline secondary"><fmt:message key="users.delete"/></summary>
              <form method="post" action="${root}/users/${user.id}/delete">
                <t:csrf/>
                <p><fmt:message key="users.delete.sure"/></p>
                <button class="danger"><fmt:message key="users.delete.submit"/></button>
              </form>
            </details>
          </c:if>
        </div>
      </article>
    </c:forEach>
  </div>
  <c:if test="${manager}">
    <article class="card">
      <h2><fmt:message key="users.add"/></h2>
      <form method="post" action="${root}/users" novalidate>
        <t:csrf/>
        <div class="grid">
          <div><t:field name="name" label="users.add.name" hint="users.add.name.hint"/></div>
          <div><t:field name="password" label="users.add.password" type="password" hint="firstStart.password.hint" autocomplete="new-password"/></div>
          <div>
            <label for="role"><fmt:message key="users.add.role"/></label>
            <select id="role" name="role">
              <option value="CLERK"><fmt:message key="users.role.CLERK"/></option>
              <option value="MANAGER" ${path == '/users' and param.role == 'MANAGER' ? 'selected' : ''}><fmt:message key="users.role.MANAGER"/></option>
            </select>
          </div>
        </div>
        <button><fmt:message key="users.add.submit"/></button>
      </form>
    </article>
  </c:if>
</t:page>
