<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="notices.settings" var="title"/>
<t:page title="${title}" here="notice" script="notices/settings.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="notices.settings.intro"/></p>
    </div>
    <a href="${root}/notices"><fmt:message key="notices.title"/></a>
  </div>
  <c:if test="${param.done == 'saved'}"><p class="notice good" role="status"><fmt:message key="notices.saved"/></p></c:if>
  <t:errors/>
  <t:texts keys="notices.browser.default notices.browser.granted notices.browser.denied notices.browser.impossible"/>
  <form method="post" action="${root}/notices/settings" novalidate>
    <t:csrf/>
    <input type="hidden" id="zone" name="zone" value="UTC">
    <article class="card">
      <h2><fmt:message key="notices.channels"/></h2>
      <table class="stacks channels">
        <thead>
          <tr>
            <th scope="col"><fmt:message key="notices.column.what"/></th>
            <c:forEach items="${channels}" var="channel"><th scope="col"><fmt:message key="notices.channel.${channel.word()}"/></th></c:forEach>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${kinds}" var="kind">
            <fmt:message key="notices.kind.${kind.word()}" var="what"/>
            <tr>
              <th scope="row">${what}</th>
              <c:forEach items="${channels}" var="channel">
                <fmt:message key="notices.channel.${channel.word()}" var="how"/>
                <td data-label="${how}"><input type="checkbox" name="${kind.word()}" value="${channel.word()}" aria-label="${what}: ${how}"${preferences.has(kind, channel) ? ' checked' : ''}></td>
              </c:forEach>
            </tr>
          </c:forEach>
        </tbody>
      </table>
      <label><input type="checkbox" name="ownTasksOnly" value="yes"${preferences.ownTasksOnly ? ' checked' : ''}> <fmt:message key="notices.ownTasksOnly"/></label>
      <label><input type="checkbox" name="ends" value="yes"${preferences.ends ? ' checked' : ''}> <fmt:message key="notices.ends"/></label>
      <p class="faint">
        <c:choose>
          <c:when test="${not canMail}"><fmt:message key="notices.email.noServer"/></c:when>
          <c:when test="${empty caller.account.email}"><fmt:message key="notices.email.none"/>${" "}<a href="${root}/users/${caller.account.id}"><fmt:message key="notices.email.enter"/></a></c:when>
          <c:otherwise><fmt:message key="notices.email.to"/>${" "}<bdi dir="ltr"><c:out value="${caller.account.email}"/></bdi></c:otherwise>
        </c:choose>
      </p>
      <p class="faint"><span id="browser-state"></span>${" "}<fmt:message key="notices.sound.hint"/></p>
      <div class="choices">
        <button type="button" id="allow" class="outline" hidden><fmt:message key="notices.browser.allow"/></button>
        <button type="button" id="try-sound" class="outline" hidden><fmt:message key="notices.sound.try"/></button>
      </div>
    </article>
    <article class="card">
      <h2><fmt:message key="notices.quiet"/></h2>
      <p class="faint"><fmt:message key="notices.quiet.hint"/>${" "}<bdi id="zone-name" dir="ltr"><c:out value="${preferences.zone}"/></bdi></p>
      <div class="grid">
        <div><t:field name="quietFrom" label="notices.quiet.from" type="time" optional="true" value="${preferences.quiet.from}"/></div>
        <div><t:field name="quietUntil" label="notices.quiet.until" type="time" optional="true" value="${preferences.quiet.until}"/></div>
      </div>
    </article>
    <button><fmt:message key="notices.save"/></button>
  </form>
</t:page>
