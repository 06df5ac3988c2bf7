<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="which floor a list is of, where there are several" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<c:if test="${fn:length(floors) > 1 or not empty param.floor}">
  <c:set var="wrong" value="${not empty errors.floor and pageContext.request.method == 'GET'}"/>
  <label><fmt:message key="map.floor"/>
    <select name="floor" ${wrong ? 'aria-invalid="true"' : ''}>
      <option value=""><fmt:message key="floor.all"/></option>
      <c:forEach items="${floors}" var="choice"><option dir="auto" value="<c:out value="${choice.name()}"/>" ${param.floor == choice.name() ? 'selected' : ''}><c:out value="${choice.name()}"/></option></c:forEach>
    </select>
    <c:if test="${wrong}"><small><bdi><c:out value="${errors.floor}"/></bdi></small></c:if>
  </label>
</c:if>
