<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="history.title" var="title"/>
<c:set var="filters" value="task,user,from,until,robot,floor,kind"/>
<c:forTokens items="${filters}" delims="," var="name"><c:if test="${not empty param[name]}"><c:set var="isFiltered" value="true"/></c:if></c:forTokens>
<t:page title="${title}" here="history">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="history.intro"/>${" "}<t:help topic="history" section="history"/></p>
    </div>
  </div>
  <details ${isFiltered or not empty errors ? 'open' : ''}>
    <summary><fmt:message key="tasks.filter"/></summary>
    <form method="get" action="${root}/history" class="filter">
      <c:forTokens items="task,user,from,until" delims="," var="name">
        <label><fmt:message key="history.${name}"/>
          <input name="${name}" type="${name == 'from' or name == 'until' ? 'date' : 'text'}" value="${fn:escapeXml(param[name])}" dir="auto" autocomplete="off" ${empty errors[name] ? '' : 'aria-invalid="true"'}>
          <c:if test="${not empty errors[name]}"><small><bdi><c:out value="${errors[name]}"/></bdi></small></c:if>
        </label>
      </c:forTokens>
      <label><fmt:message key="history.robot"/>
        <select name="robot">
          <option value=""><fmt:message key="history.all"/></option>
          <c:forEach items="${robots}" var="robot"><option dir="auto" ${param.robot == robot ? 'selected' : ''}><c:out value="${robot}"/></option></c:forEach>
        </select>
      </label>
      <t:floor-choice/>
      <label><fmt:message key="history.kind"/>
        <select name="kind">
          <option value=""><fmt:message key="history.all"/></option>
          <c:forEach items="${families}" var="family"><option value="${family}" ${param.kind == family ? 'selected' : ''}><fmt:message key="history.kind.${family}"/></option></c:forEach>
        </select>
      </label>
      <button><fmt:message key="history.filter"/></button>
    </form>
  </details>
  <c:forTokens items="kind,before" delims="," var="name"><c:if test="${not empty errors[name]}"><p class="notice bad"><bdi><c:out value="${errors[name]}"/></bdi></p></c:if></c:forTokens>
  <c:if test="${empty errors and empty entries}"><p class="notice"><fmt:message key="history.empty"/></p></c:if>
  <c:if test="${not empty entries}">
    <table class="stacks">
      <thead>
        <tr>
          <th scope="col"><fmt:message key="history.column.at"/></th>
          <th scope="col"><fmt:message key="history.column.text"/></th>
          <th scope="col"><fmt:message key="history.column.user"/></th>
          <th scope="col"><fmt:message key="history.column.robot"/></th>
          <th scope="col"><fmt:message key="history.column.task"/></th>
        </tr>
      </thead>
      <tbody>
        <c:forEach items="${entries}" var="entry">
          <tr>
            <td><t:time at="${entry.event.at}"/></td>
            <th scope="row"><t:said sentence="${entry.event.sentence}"/></th>
            <td data-label="<fmt:message key="history.column.user"/>"><bdi><c:out value="${entry.event.who}"/></bdi></td>
            <td data-label="<fmt:message key="history.column.robot"/>"><c:if test="${not empty entry.event.robot}"><c:url value="/robots/${entry.event.robot}" var="robot"/><a href="<c:out value="${robot}"/>"><bdi><c:out value="${entry.event.robot}"/></bdi></a></c:if></td>
            <td data-label="<fmt:message key="history.column.task"/>"><c:if test="${not empty entry.event.task}"><a href="${root}/tasks/${entry.event.task}">${entry.event.task}</a></c:if></td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
  </c:if>
  <nav class="pages" aria-label="${title}">
    <c:forTokens items="${empty param.before ? '' : 'newest'} ${empty next ? '' : 'older'}" delims=" " var="page">
      <c:url value="/history" var="target">
        <c:forTokens items="${filters}" delims="," var="name"><c:if test="${not empty param[name]}"><c:param name="${name}" value="${param[name]}"/></c:if></c:forTokens>
        <c:if test="${page == 'older'}"><c:param name="before" value="${next}"/></c:if>
      </c:url>
      <a href="<c:out value="${target}"/>"><fmt:message key="history.${page}"/></a>
    </c:forTokens>
  </nav>
</t:page>
