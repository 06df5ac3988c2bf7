<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="${empty template ? 'template.new.title' : 'template.edit.title'}" var="title"/>
<t:page title="${title}" here="task">
  <h1>${title}</h1>
  <p class="faint"><fmt:message key="template.new.intro"/>${" "}<t:help topic="tasks" section="templates"/></p>
  <t:errors/>
  <form class="template" method="post" action="${root}/templates${empty template ? '' : '/' += template.id() += '/edit'}" novalidate>
    <t:csrf/>
    <c:if test="${not empty template}"><t:version/></c:if>
    <input type="hidden" name="order" value="${fn:escapeXml(order)}">
    <t:field name="name" label="template.name" hint="template.name.hint" focus="true" value="${empty template ? '' : template.name()}"/>
    <c:if test="${mayShare}">
      <c:set var="shared" value="${pageContext.request.method == 'POST' ? param.shared == 'true' : not empty template and template.shared()}"/>
      <label><input type="checkbox" name="shared" value="true" ${shared ? 'checked' : ''}> <fmt:message key="template.shared"/></label>
    </c:if>
    <c:if test="${not empty errors.shared}"><small class="wrong"><bdi><c:out value="${errors.shared}"/></bdi></small></c:if>
    <table class="stacks">
      <thead><tr><c:forTokens items="field,value,ask,as" delims="," var="column"><th scope="col"><fmt:message key="template.column.${column}"/></th></c:forTokens></tr></thead>
      <tbody>
        <c:forEach items="${rows}" var="row" varStatus="at">
          <c:set var="error" value="${errors['as.' += row.field()]}"/>
          <tr>
            <th scope="row" id="row${at.index}"><c:out value="${row.label()}"/></th>
            <td data-label="<fmt:message key="template.column.value"/>"><c:choose><c:when test="${empty row.value()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><bdi><c:out value="${row.value()}"/></bdi></c:otherwise></c:choose></td>
            <td data-label="<fmt:message key="template.column.ask"/>">
              <select name="ask.${row.field()}" aria-labelledby="row${at.index}">
                <option value="never" ${row.ask() == 'never' ? 'selected' : ''}><fmt:message key="template.ask.${empty row.value() ? 'not' : 'never'}"/></option>
                <c:if test="${not empty row.value()}"><option value="suggest" ${row.ask() == 'suggest' ? 'selected' : ''}><fmt:message key="template.ask.suggest"/></option></c:if>
                <option value="always" ${row.ask() == 'always' ? 'selected' : ''}><fmt:message key="template.ask.always"/></option>
              </select>
            </td>
            <td data-label="<fmt:message key="template.column.as"/>">
              <input name="as.${row.field()}" dir="auto" autocomplete="off" maxlength="40" value="${fn:escapeXml(row.as())}" aria-labelledby="row${at.index}" ${empty error ? '' : 'aria-invalid="true"'} aria-describedby="row${at.index}-help">
              <small id="row${at.index}-help" ${empty error ? 'hidden' : 'class="wrong"'}><bdi><c:out value="${error}"/></bdi></small>
            </td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
    <div class="choices">
      <button><fmt:message key="template.submit"/></button>
      <a role="button" class="outline secondary" href="${root}/templates"><fmt:message key="common.cancel"/></a>
    </div>
  </form>
</t:page>
