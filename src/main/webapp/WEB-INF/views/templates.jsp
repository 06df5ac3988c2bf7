<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="templates.title" var="title"/>
<t:page title="${title}" here="task" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="templates.intro"/>${" "}<t:help topic="tasks" section="templates"/></p>
    </div>
    <c:if test="${caller.mayOrder()}"><div class="choices"><a role="button" href="${root}/tasks/new"><fmt:message key="tasks.new"/></a></div></c:if>
  </div>
  <t:errors/>
  <c:if test="${param.done == 'added' or param.done == 'changed' or param.done == 'deleted'}"><p class="notice good" role="status"><fmt:message key="templates.${param.done}"/></p></c:if>
  <c:if test="${empty entries}"><p class="notice"><fmt:message key="templates.empty"/></p></c:if>
  <c:if test="${not empty entries}">
    <table class="stacks">
      <thead>
        <tr><c:forTokens items="name,way,parameters,user,actions" delims="," var="column"><th scope="col"><fmt:message key="templates.column.${column}"/></th></c:forTokens></tr>
      </thead>
      <tbody>
        <c:forEach items="${entries}" var="entry">
          <c:set var="template" value="${entry.template()}"/>
          <tr>
            <th scope="row"><c:choose><c:when test="${caller.mayOrder()}"><a href="${root}/templates/${template.id()}"><bdi><c:out value="${template.name()}"/></bdi></a></c:when><c:otherwise><bdi><c:out value="${template.name()}"/></bdi></c:otherwise></c:choose><c:if test="${fn:length(floors) > 1}"><br><small class="faint"><bdi><c:out value="${template.floor()}"/></bdi></small></c:if></th>
            <td data-label="<fmt:message key="templates.column.way"/>">
              <t:template-way entry="${entry}"/>
              <c:forEach items="${entry.gone()}" var="station"><br><strong class="wrong"><fmt:message key="templates.gone"><fmt:param><bdi><c:out value="${station}"/></bdi></fmt:param></fmt:message></strong></c:forEach>
            </td>
            <td data-label="<fmt:message key="templates.column.parameters"/>"><c:if test="${empty template.parameters()}"><span class="faint"><fmt:message key="common.none"/></span></c:if><c:forEach items="${template.parameters()}" var="parameter" varStatus="at"><bdi><c:out value="${parameter.name()}"/></bdi><c:if test="${not at.last}"><fmt:message key="common.comma"/></c:if></c:forEach></td>
            <td data-label="<fmt:message key="templates.column.user"/>"><bdi><c:out value="${template.user()}"/></bdi><br><small class="faint"><fmt:message key="templates.${template.shared() ? 'shared' : 'own'}"/></small></td>
            <td class="whole">
              <div class="choices">
                <c:if test="${caller.mayOrder()}"><a role="button" class="outline" href="${root}/templates/${template.id()}"><fmt:message key="templates.use"/></a></c:if>
                <c:if test="${entry.mayChange()}">
                  <a role="button" class="outline secondary" href="${root}/templates/${template.id()}/edit"><fmt:message key="templates.change"/></a>
                  <details>
                    <summary role="button" class="outline secondary"><fmt:message key="templates.delete"/></summary>
                    <form method="post" action="${root}/templates/${template.id()}/delete">
                      <t:csrf/>
                      <input type="hidden" name="version" value="${entry.version().text}">
                      <p><fmt:message key="templates.delete.sure"/></p>
                      <button class="danger"><fmt:message key="templates.delete.submit"/></button>
                    </form>
                  </details>
                </c:if>
              </div>
            </td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
    <t:pages path="/templates" kept=""/>
  </c:if>
</t:page>
