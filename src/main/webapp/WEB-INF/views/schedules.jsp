<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="schedules.title" var="title"/>
<t:page title="${title}" here="task" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="schedules.intro"/>${" "}<t:help topic="tasks" section="later-and-again-and-again"/></p>
    </div>
    <c:if test="${caller.mayOrder()}"><div class="choices"><a role="button" href="${root}/tasks/new"><fmt:message key="tasks.new"/></a></div></c:if>
  </div>
  <t:errors/>
  <c:if test="${not empty param.added}"><p class="notice good" role="status"><fmt:message key="schedules.added"/></p></c:if>
  <c:if test="${count > 0 or isFiltered or not empty errors}">
    <details ${isFiltered or not empty errors ? 'open' : ''}>
      <summary><fmt:message key="tasks.filter"/></summary>
      <form method="get" action="${root}/schedules" class="filter" role="search">
        <label><fmt:message key="schedules.filter.text"/>
          <input name="text" type="search" value="<c:out value="${param.text}"/>" dir="auto" autocomplete="off">
        </label>
        <label><fmt:message key="robots.column.state"/>
          <select name="state" ${empty errors.state ? '' : 'aria-invalid="true"'}>
            <option value=""><fmt:message key="history.all"/></option>
            <c:forEach items="${states}" var="state"><option value="${state.word()}" ${param.state == state.word() ? 'selected' : ''}><fmt:message key="schedules.filter.${state.word()}"/></option></c:forEach>
          </select>
          <c:if test="${not empty errors.state}"><small><bdi><c:out value="${errors.state}"/></bdi></small></c:if>
        </label>
        <t:floor-choice/>
        <button><fmt:message key="history.filter"/></button>
      </form>
    </details>
  </c:if>
  <c:if test="${empty entries}"><p class="notice"><fmt:message key="${isFiltered ? 'schedules.filter.none' : 'schedules.empty'}"/></p></c:if>
  <c:if test="${not empty entries}">
    <table class="stacks">
      <thead>
        <tr>
          <c:forTokens items="id,name,when,due,last,user,actions" delims="," var="column"><th scope="col"><fmt:message key="schedules.column.${column}"/></th></c:forTokens>
        </tr>
      </thead>
      <tbody>
        <c:forEach items="${entries}" var="entry">
          <c:set var="schedule" value="${entry.schedule}"/>
          <tr>
            <td class="number">${schedule.id}</td>
            <th scope="row"><bdi><c:out value="${schedule.order.name}"/></bdi><c:if test="${not empty schedule.template}"><br><small class="faint"><fmt:message key="schedules.template"><fmt:param><bdi><c:out value="${schedule.template.name()}"/></bdi></fmt:param></fmt:message></small></c:if><c:if test="${fn:length(floors) > 1}"><br><small class="faint"><bdi><c:out value="${empty schedule.order.floor ? floors[0].name() : schedule.order.floor}"/></bdi></small></c:if></th>
            <td data-label="<fmt:message key="schedules.column.when"/>">
              <c:choose>
                <c:when test="${entry.kind == 'once'}"><fmt:message key="schedules.once"/>${" "}<t:time at="${schedule.recurrence.at}"/></c:when>
                <c:when test="${entry.kind == 'every'}"><fmt:message key="schedules.every"><fmt:param value="${schedule.recurrence.interval.toMinutes()}"/></fmt:message>${" "}<t:time at="${schedule.recurrence.first}"/></c:when>
                <c:otherwise>
                  <c:forEach items="${entry.days}" var="day" varStatus="at"><fmt:message key="schedule.day.${day}"/><c:if test="${not at.last}"><fmt:message key="common.comma"/></c:if></c:forEach>
                  ${" "}<bdi dir="ltr">${schedule.recurrence.time}</bdi>${" "}<bdi class="faint"><c:out value="${schedule.recurrence.zone}"/></bdi>
                </c:otherwise>
              </c:choose>
              <c:if test="${not empty schedule.until}"><br><fmt:message key="schedules.until"/>${" "}<t:time at="${schedule.until}"/></c:if>
            </td>
            <td data-label="<fmt:message key="schedules.column.due"/>">
              <c:choose>
                <c:when test="${empty schedule.due}"><fmt:message key="schedules.ended"/></c:when>
                <c:when test="${schedule.paused}"><fmt:message key="schedules.paused"/></c:when>
                <c:when test="${schedule.resting}"><fmt:message key="schedules.resting.${empty schedule.owner ? 'gone' : 'disabled'}"/></c:when>
                <c:otherwise><t:time at="${schedule.due}"/></c:otherwise>
              </c:choose>
            </td>
            <td data-label="<fmt:message key="schedules.column.last"/>"><c:choose><c:when test="${empty schedule.lastTask}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><a href="${root}/tasks/${schedule.lastTask}">${schedule.lastTask}</a></c:otherwise></c:choose></td>
            <td data-label="<fmt:message key="schedules.column.user"/>"><bdi><c:out value="${schedule.user}"/></bdi></td>
            <td class="whole">
              <c:if test="${entry.mayChange}">
                <div class="choices">
                  <c:if test="${not empty schedule.due}">
                    <c:set var="action" value="${schedule.paused ? 'resume' : 'pause'}"/>
                    <form method="post" action="${root}/schedules/${schedule.id}/${action}">
                      <t:csrf/>
                      <button class="outline"><fmt:message key="schedules.${action}"/></button>
                    </form>
                  </c:if>
                  <details>
                    <summary role="button" class="outline secondary"><fmt:message key="schedules.delete"/></summary>
                    <form method="post" action="${root}/schedules/${schedule.id}/delete">
                      <t:csrf/>
                      <input type="hidden" name="version" value="${entry.version.text}">
                      <p><fmt:message key="schedules.delete.sure"><fmt:param>${schedule.id}</fmt:param></fmt:message></p>
                      <button class="danger"><fmt:message key="schedules.delete.submit"/></button>
                    </form>
                  </details>
                </div>
              </c:if>
            </td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
    <t:pages path="/schedules" kept="text,state,floor"/>
  </c:if>
</t:page>
