<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="import.title" var="title"/>
<t:page title="${title}" here="task" script="tasks/import.js">
  <h1>${title}</h1>
  <p class="faint"><fmt:message key="import.intro"/>${" "}<t:help topic="tasks" section="many-at-once"/></p>
  <c:if test="${not empty errors}"><p class="notice bad" role="alert"><c:out value="${errors.file}"/></p></c:if>
  <c:if test="${not empty faults}">
    <table class="stacks" id="faults">
      <thead>
        <tr>
          <th scope="col"><fmt:message key="import.column.line"/></th>
          <th scope="col"><fmt:message key="import.column.column"/></th>
          <th scope="col"><fmt:message key="import.column.fault"/></th>
        </tr>
      </thead>
      <tbody>
        <c:forEach items="${faults.first()}" var="fault">
          <tr>
            <td class="number" data-label="<fmt:message key="import.column.line"/>">${fault.line}</td>
            <td data-label="<fmt:message key="import.column.column"/>"><c:if test="${not empty fault.column}"><code dir="auto"><c:out value="${fault.column}"/></code></c:if></td>
            <th scope="row" class="whole"><c:out value="${fault.sentence}"/></th>
          </tr>
        </c:forEach>
      </tbody>
    </table>
    <c:if test="${faults.more() > 0}"><p class="faint"><fmt:message key="import.more"><fmt:param value="${faults.more()}"/></fmt:message></p></c:if>
  </c:if>
  <div class="columns">
    <form method="post" action="${root}/tasks/import" enctype="multipart/form-data">
      <t:csrf/>
      <input type="hidden" name="idempotencyKey" value="<c:out value="${idempotencyKey}"/>">
      <input type="hidden" id="zone" name="zone" value="UTC">
      <label for="file"><fmt:message key="import.file"/></label>
      <input id="file" name="file" type="file" accept=".csv,.txt,text/csv" required aria-describedby="file-help" ${empty errors.file or not empty faults ? '' : 'aria-invalid="true"'}>
      <small id="file-help"><fmt:message key="import.file.hint"/></small>
      <button><fmt:message key="import.submit"/></button>
      <a href="${root}/api/v1/tasks/import/example.csv" download><fmt:message key="import.example"/></a>
    </form>
    <article>
      <h2><fmt:message key="import.columns"/></h2>
      <p class="faint"><fmt:message key="import.columns.intro"/></p>
      <dl>
        <c:forTokens items="name,kind,load,pieces,start,startX_startY,goal,goalX_goalY,stops,startWait_goalWait,carriedBy,floor,priority,deadline,onlyRobots,length_width" delims="," var="column">
          <dt><c:forTokens items="${column}" delims="_" var="name"><code dir="ltr">${name}</code>${" "}</c:forTokens></dt>
          <dd><fmt:message key="import.columns.${column}"/><c:if test="${column == 'deadline'}">${" "}<bdi id="zone-name"><fmt:message key="newTask.deadline.utc"/></bdi></c:if></dd>
        </c:forTokens>
      </dl>
    </article>
  </div>
</t:page>
