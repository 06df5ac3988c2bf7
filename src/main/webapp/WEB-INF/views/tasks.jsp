<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="tasks.title" var="title"/>
<c:set var="filters" value="state,text,user,robot,from,until,followed,floor"/>
<t:page title="${title}" here="task" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <c:if test="${empty errors and (count > 0 or not isFiltered)}"><p class="faint"><fmt:message key="tasks.count"><fmt:param value="${count}"/></fmt:message></p></c:if>
    </div>
    <div class="choices">
      <a role="button" class="outline secondary" href="${root}/tasks?followed=true"><fmt:message key="tasks.followed"/></a>
      <c:if test="${caller.mayOrder()}">
        <a role="button" class="outline secondary" href="${root}/tasks/import"><fmt:message key="tasks.import"/></a>
        <a role="button" href="${root}/tasks/new"><fmt:message key="tasks.new"/></a>
      </c:if>
    </div>
  </div>
  <c:if test="${not empty imported}"><p class="notice good" role="status"><fmt:message key="tasks.imported"><fmt:param value="${imported}"/></fmt:message></p></c:if>
  <c:if test="${not empty deleted}"><p class="notice good" role="status"><fmt:message key="tasks.deleted"><fmt:param value="${deleted}"/></fmt:message></p></c:if>
  <details ${isFiltered or not empty errors ? 'open' : ''}>
    <summary><fmt:message key="tasks.filter"/></summary>
    <form method="get" action="${root}/tasks" class="filter">
      <label><fmt:message key="tasks.column.state"/>
        <select name="state">
          <option value=""><fmt:message key="history.all"/></option>
          <c:forTokens items="open,ended" delims="," var="state"><option value="${state}" ${param.state == state ? 'selected' : ''}><fmt:message key="tasks.filter.${state}"/></option></c:forTokens>
          <c:forEach items="${states}" var="state"><option value="${state}" ${param.state == state.name() ? 'selected' : ''}><fmt:message key="task.state.${state}"/></option></c:forEach>
        </select>
      </label>
      <label><fmt:message key="tasks.column.robots"/>
        <select name="robot">
          <option value=""><fmt:message key="history.all"/></option>
          <c:forEach items="${robots}" var="robot"><option dir="auto" ${param.robot == robot.name ? 'selected' : ''}><c:out value="${robot.name}"/></option></c:forEach>
        </select>
      </label>
      <t:floor-choice/>
      <c:forTokens items="text,user,from,until" delims="," var="name">
        <label><fmt:message key="tasks.filter.${name}"/>
          <input name="${name}" type="${name == 'from' or name == 'until' ? 'date' : 'text'}" value="${fn:escapeXml(param[name])}" dir="auto" autocomplete="off" ${empty errors[name] ? '' : 'aria-invalid="true"'}>
          <c:if test="${not empty errors[name]}"><small><bdi><c:out value="${errors[name]}"/></bdi></small></c:if>
        </label>
      </c:forTokens>
      <label><fmt:message key="tasks.filter.sort"/>
        <select name="sort">
          <option value=""><fmt:message key="tasks.filter.newest"/></option>
          <c:forEach items="${columns}" var="column">
            <c:forTokens items="${column},-${column}" delims="," var="sort"><option value="${sort}" ${param.sort == sort ? 'selected' : ''}><fmt:message key="tasks.column.${column}"/> ${sort == column ? '▲' : '▼'}</option></c:forTokens>
          </c:forEach>
        </select>
      </label>
      <label class="check"><input type="checkbox" name="followed" value="true" ${param.followed == 'true' ? 'checked' : ''}> <fmt:message key="tasks.filter.followed"/></label>
      <button><fmt:message key="history.filter"/></button>
    </form>
  </details>
  <c:forTokens items="state,sort,followed" delims="," var="name"><c:if test="${not empty errors[name]}"><p class="notice bad"><bdi><c:out value="${errors[name]}"/></bdi></p></c:if></c:forTokens>
  <div id="live" data-live="tasks">
    <c:if test="${empty errors and empty tasks}"><p class="notice"><fmt:message key="${isFiltered ? 'tasks.filter.none' : 'tasks.empty'}"/></p></c:if>
    <c:if test="${not empty tasks}">
      <table class="stacks">
        <thead>
          <tr>
            <c:forTokens items="id,name,state,load,fromTo,robots,expected,user,created" delims="," var="column">
              <fmt:message key="tasks.column.${column}" var="head"/>
              <c:choose>
                <c:when test="${columns.contains(column)}">
                  <c:set var="up" value="${param.sort == column}"/>
                  <c:set var="down" value="${param.sort == '-' += column or empty param.sort and column == 'id'}"/>
                  <c:url value="/tasks" var="target">
                    <c:forTokens items="${filters}" delims="," var="name"><c:if test="${not empty param[name]}"><c:param name="${name}" value="${param[name]}"/></c:if></c:forTokens>
                    <c:param name="sort" value="${up ? '-' : ''}${column}"/>
                  </c:url>
                  <th scope="col" <c:if test="${up or down}">aria-sort="${up ? 'ascending' : 'descending'}"</c:if>><a class="sort" href="<c:out value="${target}"/>"><c:out value="${head}"/></a></th>
                </c:when>
                <c:otherwise><th scope="col"><c:out value="${head}"/></th></c:otherwise>
              </c:choose>
            </c:forTokens>
          </tr>
        </thead>
        <tbody>
          <c:forEach items="${tasks}" var="view">
            <fmt:formatNumber value="${view.task.load}" maxFractionDigits="2" var="load"/>
            <tr>
              <td class="number">${view.task.id}</td>
              <th scope="row"><a href="${root}/tasks/${view.task.id}"><bdi><c:out value="${view.task.name}"/></bdi></a><c:if test="${not empty view.task.part}"><small class="part"><t:part part="${view.task.part}" order="${orders[view.task.part.order]}"/></small></c:if></th>
              <td><t:state of="task" state="${view.state}" drive="${view.task.isDrive()}"/></td>
              <td class="number" data-label="<fmt:message key="tasks.column.load"/>"><c:choose><c:when test="${view.task.isDrive()}"><span class="faint">–</span></c:when><c:otherwise><fmt:message key="common.kilograms"><fmt:param value="${load}"/></fmt:message></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="tasks.column.fromTo"/>"><span><c:if test="${not view.task.isDrive() or fn:length(view.task.stops) > 1}"><t:stop-place stop="${view.task.route()[0]}"/> – </c:if><t:stop-place stop="${view.task.route()[fn:length(view.task.route()) - 1]}"/><c:if test="${fn:length(floors) > 1}"><br><small class="faint"><bdi><c:out value="${view.task.floor}"/></bdi></small></c:if></span></td>
              <td data-label="<fmt:message key="tasks.column.robots"/>"><t:robots names="${view.robots}"/></td>
              <td data-label="<fmt:message key="tasks.column.expected"/>"><c:if test="${not empty view.expected}"><c:choose><c:when test="${not empty view.expected.delivery}"><t:time at="${view.expected.delivery}"/></c:when><c:otherwise><small class="faint"><t:said sentence="${view.expected.unknown}"/></small></c:otherwise></c:choose></c:if></td>
              <td data-label="<fmt:message key="tasks.column.user"/>"><bdi><c:out value="${view.task.user}"/></bdi></td>
              <td data-label="<fmt:message key="tasks.column.created"/>"><t:time at="${view.task.createdAt}"/></td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </c:if>
  </div>
  <c:if test="${pages > 1}">
    <fmt:message key="tasks.pages" var="label"/>
    <nav class="pages" aria-label="${label}">
      <c:forTokens items="newer,older" delims="," var="turn">
        <c:set var="other" value="${turn == 'newer' ? page - 1 : page + 1}"/>
        <c:if test="${turn == 'older'}"><span><fmt:message key="tasks.page"><fmt:param value="${page}"/><fmt:param value="${pages}"/></fmt:message></span></c:if>
        <c:if test="${other >= 1 and other <= pages}">
          <c:url value="/tasks" var="target">
            <c:param name="page" value="${other}"/>
            <c:forTokens items="${filters},sort" delims="," var="name"><c:if test="${not empty param[name]}"><c:param name="${name}" value="${param[name]}"/></c:if></c:forTokens>
          </c:url>
          <a rel="${turn == 'newer' ? 'prev' : 'next'}" href="<c:out value="${target}"/>"><fmt:message key="tasks.${empty param.sort ? turn : turn == 'newer' ? 'previous' : 'next'}"/></a>
        </c:if>
      </c:forTokens>
    </nav>
  </c:if>
</t:page>
