<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="chosen" required="false" %>
<%@ attribute name="kind" required="false" description="of tasks that have them alone" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<c:if test="${not empty floor.charging()}">
  <fmt:message key="newTask.chargers" var="chargers"/>
  <optgroup label="${chargers}" <c:if test="${not empty kind}">data-for="${kind}"</c:if>>
    <option value="charge" ${chosen == 'charge' ? 'selected' : ''}><fmt:message key="newTask.chargers.any"/></option>
    <c:forEach items="${floor.charging()}" var="point"><c:set var="value" value="charge@${point.name}"/><option value="${fn:escapeXml(value)}" dir="auto" ${value == chosen ? 'selected' : ''}><c:out value="${point.name}"/></option></c:forEach>
  </optgroup>
</c:if>
