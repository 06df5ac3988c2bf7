<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="which floor a list is of, where there are several" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<c:if test="${fn:length(floors) > 1 or not empty param.floor}">
  <label><fmt:message key="map.floor"/>
    <select name="floor">
      <option value=""><fmt:message key="floor.all"/></option>
      <c:forEach items="${floors}" var="choice"><option dir="auto" value="<c:out value="${choice.name()}"/>" ${param.floor == choice.name() ? 'selected' : ''}><c:out value="${choice.name()}"/></option></c:forEach>
    </select>
  </label>
</c:if>
