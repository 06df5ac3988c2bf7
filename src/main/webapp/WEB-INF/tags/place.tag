<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="place" required="true" type="org.toqa.mission.TaskPlace" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:choose>
  <c:when test="${not empty place.station}"><bdi><c:out value="${place.station}"/></bdi></c:when>
  <c:otherwise>
    <fmt:formatNumber value="${place.position.x}" maxFractionDigits="2" var="x"/>
    <fmt:formatNumber value="${place.position.y}" maxFractionDigits="2" var="y"/>
    <fmt:message key="common.position"><fmt:param value="${x}"/><fmt:param value="${y}"/></fmt:message>
  </c:otherwise>
</c:choose>
