<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="manager" value="${caller.isManager() and (user.role != 'ADMINISTRATOR' or caller.isAdministrator())}"/>
<c:set var="own" value="${user.id == caller.account.id}"/>
<t:page title="${user.name}" here="user">
  <div class="heading">
    <div>
      <h1><bdi><c:out value="${user.name}"/></bdi></h1>
      <p class="faint"><c:if test="${own}"><fmt:message key="users.own"/> · </c:if><fmt:message key="users.role.${user.role}"/><c:if test="${user.disabled()}">, <strong><fmt:message key="users.disabled"/></strong></c:if> · <fmt:message key="users.created"/>${" "}<t:time at="${user.createdAt}"/></p>
    </div>
    <c:if test="${caller.isManager()}"><a href="${root}/users"><fmt:message key="users.all"/></a></c:if>
  </div>
  <c:if test="${param.done == 'changed' or param.done == 'password' or param.done == 'email' or param.done == 'ended'}"><p class="notice good" role="status"><fmt:message key="users.done.${param.done}"/></p></c:if>
  <t:errors/>
  <c:if test="${not empty token}"><div class="notice good" role="status"><p><fmt:message key="users.token.once"/></p><code class="secret" dir="ltr"><c:out value="${token}"/></code></div></c:if>
  <c:if test="${not empty link}"><div class="notice good" role="status"><p><fmt:message key="users.link.once"><fmt:param value="${linkHours}"/></fmt:message></p><code class="secret" dir="ltr"><c:out value="${link}"/></code></div></c:if>
  <c:if test="${own}"><p><a href="${root}/notices/settings"><fmt:message key="notices.settings.link"/></a></p></c:if>
  <article class="card">
    <h2><fmt:message key="users.sessions"/></h2>
    <c:if test="${sessionCount > 8 or isFiltered}">
      <details ${isFiltered ? 'open' : ''}>
        <summary><fmt:message key="tasks.filter"/></summary>
        <form method="get" action="${root}/users/${user.id}" class="filter" role="search">
          <label><fmt:message key="users.sessions.filter.text"/>
            <input name="text" type="search" value="<c:out value="${param.text}"/>" dir="auto" autocomplete="off">
          </label>
          <label><fmt:message key="users.sessions.filter.kind"/>
            <select name="kind">
              <option value=""><fmt:message key="history.all"/></option>
              <c:forEach items="${kinds}" var="kind"><option value="${fn:toLowerCase(kind)}" ${param.kind == fn:toLowerCase(kind) ? 'selected' : ''}><fmt:message key="users.session.${kind}"/></option></c:forEach>
            </select>
          </label>
          <button><fmt:message key="history.filter"/></button>
        </form>
      </details>
    </c:if>
    <c:if test="${empty sessions}"><p class="faint"><fmt:message key="${isFiltered ? 'users.sessions.filter.none' : 'users.sessions.none'}"/></p></c:if>
    <c:if test="${not empty sessions}">
      <table class="stacks">
        <thead>
          <tr>
            <th scope="col"><fmt:message key="users.session.what"/></th>
            <th scope="col"><fmt:message key="users.session.address"/></th>
            <th scope="col"><fmt:message key="users.session.begun"/></th>
            <th scope="col"><fmt:message key="users.session.seen"/></th>
            <th scope="col"><fmt:message key="users.session.expires"/></th>
            <th scope="col"><span class="unseen"><fmt:message key="users.session.end"/></span></th>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${sessions}" var="line">
            <c:set var="session" value="${line.session}"/>
            <tr>
              <th scope="row" class="whole">
                <c:choose><c:when test="${not empty session.name}"><fmt:message key="users.session.token"/>${" "}<q><bdi><c:out value="${session.name}"/></bdi></q> (<c:forEach items="${scopes}" var="scope"><c:if test="${session.scopes.contains(scope)}"> <bdi>${scope.word()}</bdi></c:if></c:forEach>)</c:when><c:otherwise><fmt:message key="users.session.${session.kind}"/></c:otherwise></c:choose>
                <c:if test="${session.id == caller.session.id}">${" "}(<fmt:message key="users.session.this"/>)</c:if>
                <p class="faint agent">
                  <c:choose>
                    <c:when test="${not empty line.agent.program and not empty line.agent.system}"><fmt:message key="users.session.agent"><fmt:param><bdi><c:out value="${line.agent.program}"/></bdi></fmt:param><fmt:param><bdi>${line.agent.system}</bdi></fmt:param></fmt:message></c:when>
                    <c:when test="${not empty line.agent.program or not empty line.agent.system}"><bdi><c:out value="${line.agent.program}${line.agent.system}"/></bdi></c:when>
                    <c:otherwise><fmt:message key="users.session.agent.unknown"/></c:otherwise>
                  </c:choose>
                </p>
              </th>
              <td data-label="<fmt:message key="users.session.address"/>"><bdi dir="ltr"><c:out value="${session.origin.address}"/></bdi></td>
              <td data-label="<fmt:message key="users.session.begun"/>"><t:time at="${session.createdAt}"/></td>
              <td data-label="<fmt:message key="users.session.seen"/>"><t:time at="${session.seenAt}"/></td>
              <td data-label="<fmt:message key="users.session.expires"/>"><t:time at="${session.expiresAt}"/></td>
              <td>
                <details>
                  <summary role="button" class="outline secondary"><fmt:message key="users.session.end"/></summary>
                  <form method="post" action="${root}/users/${user.id}/sessions/${session.id}/end">
                    <t:csrf/>
                    <p><fmt:message key="users.session.end.sure"/></p>
                    <button class="danger"><fmt:message key="users.session.end.submit"/></button>
                  </form>
                </details>
              </td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
      <t:pages path="/users/${user.id}" kept="text,kind"/>
    </c:if>
    <c:if test="${own}">
      <h3><fmt:message key="users.token.add"/>${" "}<t:help topic="users"/></h3>
      <p class="faint"><fmt:message key="users.token.hint"/>${" "}<a href="${root}/api"><fmt:message key="api.title"/></a></p>
      <form method="post" action="${root}/users/${user.id}/tokens" novalidate>
        <t:csrf/>
        <div class="grid">
          <div><t:field name="tokenName" label="users.token.name" hint="users.token.name.hint"/></div>
          <div><t:field name="days" label="users.token.days" inputmode="numeric" value="90"/></div>
        </div>
        <fieldset${empty errors.scopes ? '' : ' aria-describedby="scopes-help"'}>
          <legend><fmt:message key="users.token.scopes"/></legend>
          <c:forEach items="${scopes}" var="scope">
            <c:set var="chosen" value="${false}"/>
            <c:forEach items="${paramValues.scopes}" var="given"><c:if test="${given == scope.word()}"><c:set var="chosen" value="${true}"/></c:if></c:forEach>
            <label><input type="checkbox" name="scopes" value="${scope.word()}"${chosen ? ' checked' : ''}> <fmt:message key="users.scope.${scope.word()}"/></label>
          </c:forEach>
          <c:if test="${not empty errors.scopes}"><small id="scopes-help" class="wrong"><bdi><c:out value="${errors.scopes}"/></bdi></small></c:if>
        </fieldset>
        <t:field name="password" id="token-password" errorAt="tokenPassword" label="users.password.old" type="password" autocomplete="current-password"/>
        <button><fmt:message key="users.token.submit"/></button>
      </form>
    </c:if>
  </article>
  <article class="card">
    <h2><fmt:message key="users.password"/></h2>
    <form method="post" action="${root}/users/${user.id}/password" novalidate>
      <t:csrf/>
      <div class="grid">
        <c:if test="${own}"><div><t:field name="old" label="users.password.old" type="password" autocomplete="current-password"/></div></c:if>
        <div><t:field name="password" label="users.password.new" type="password" hint="firstStart.password.hint" autocomplete="new-password"/></div>
      </div>
      <button><fmt:message key="users.password.submit"/></button>
    </form>
    <c:if test="${manager and not own}">
      <form class="or" method="post" action="${root}/users/${user.id}/reset-link">
        <t:csrf/>
        <p class="faint"><fmt:message key="users.link.hint"/></p>
        <button class="outline"><fmt:message key="users.link.submit"/></button>
      </form>
    </c:if>
  </article>
  <article class="card">
    <h2><fmt:message key="users.email"/></h2>
    <form method="post" action="${root}/users/${user.id}/email" novalidate>
      <t:csrf/>
      <t:version/>
      <div class="grid">
        <div><t:field name="email" label="users.email" type="email" hint="users.email.hint" optional="true" value="${user.email}" autocomplete="${own ? 'email' : 'off'}"/></div>
        <c:if test="${own}"><div><t:field name="password" id="email-password" errorAt="emailPassword" label="users.password.old" type="password" autocomplete="current-password"/></div></c:if>
      </div>
      <button><fmt:message key="users.change.submit"/></button>
    </form>
  </article>
  <c:if test="${manager}">
    <article class="card">
      <h2><fmt:message key="users.change"/>${" "}<t:help topic="users"/></h2>
      <form method="post" action="${root}/users/${user.id}/change">
        <t:csrf/>
        <t:version/>
        <t:role chosen="${param.role == null ? user.role : param.role}"/>
        <label><input type="checkbox" name="disabled" ${(param.role == null ? user.disabled() : param.disabled != null) ? 'checked' : ''} ${empty errors.disabled ? '' : 'aria-describedby="disabled-help"'}> <fmt:message key="users.change.disabled"/></label>
        <c:if test="${not empty errors.disabled}"><small id="disabled-help" class="wrong"><bdi><c:out value="${errors.disabled}"/></bdi></small></c:if>
        <p class="faint"><fmt:message key="users.change.disabled.hint"/></p>
        <button><fmt:message key="users.change.submit"/></button>
      </form>
      <details class="or"${not empty errors.tasks or not empty errors.schedules or not empty errors.tokens or not empty errors.to ? ' open' : ''}>
        <summary role="button" class="outline secondary"><fmt:message key="users.delete"/></summary>
        <form method="post" action="${root}/users/${user.id}/delete">
          <t:csrf/>
          <p><fmt:message key="users.delete.sure"/></p>
          <c:if test="${belongings.tasks > 0}">
            <t:choice name="tasks" label="users.delete.tasks" count="${belongings.tasks}" words="handOver,cancel"/>
            <t:choice name="load" label="users.delete.load" words="back,here"/>
          </c:if>
          <c:if test="${belongings.schedules > 0}"><t:choice name="schedules" label="users.delete.schedules" count="${belongings.schedules}" words="handOver,remove"/></c:if>
          <c:if test="${belongings.tokens > 0}"><t:choice name="tokens" label="users.delete.tokens" count="${belongings.tokens}" words="remove,handOver"/></c:if>
          <c:if test="${belongings.tasks + belongings.schedules + belongings.tokens > 0}">
            <label for="delete-to"><fmt:message key="users.delete.to"/></label>
            <select id="delete-to" name="to"${empty errors.to ? '' : ' aria-invalid="true" aria-describedby="delete-to-help"'}>
              <c:forEach items="${heirs}" var="heir"><option value="${heir.id}" dir="auto"${param.to == heir.id or (empty param.to and heir.id == caller.account.id) ? ' selected' : ''}><c:out value="${heir.name}"/></option></c:forEach>
            </select>
            <c:if test="${not empty errors.to}"><small id="delete-to-help" class="wrong"><bdi><c:out value="${errors.to}"/></bdi></small></c:if>
          </c:if>
          <button class="danger"><fmt:message key="users.delete.submit"/></button>
        </form>
      </details>
    </article>
  </c:if>
</t:page>
