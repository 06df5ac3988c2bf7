<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="which gateway reaches a robot, where there are any" %>
<%@ attribute name="chosen" required="true" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:if test="${not empty gateways or not empty chosen or not empty errors.gateway}">
  <label for="gateway"><fmt:message key="robots.add.gateway"/></label>
  <select id="gateway" name="gateway" ${not empty errors.gateway ? 'aria-invalid="true" aria-describedby="gateway-help"' : ''}>
    <option value=""><fmt:message key="robot.gateway.none"/></option>
    <c:forEach items="${gateways}" var="gateway"><option dir="auto" value="<c:out value="${gateway.name}"/>" ${gateway.name == chosen ? 'selected' : ''}><fmt:message key="robot.gateway.name"><fmt:param value="${gateway.name}"/></fmt:message></option></c:forEach>
  </select>
  <c:if test="${not empty errors.gateway}"><small id="gateway-help" class="wrong"><bdi><c:out value="${errors.gateway}"/></bdi></small></c:if>
</c:if>
