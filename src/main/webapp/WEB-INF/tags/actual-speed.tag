<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="readings" required="true" type="org.toqa.fleet.RobotView.Readings" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:choose>
  <c:when test="${empty readings.speed()}"><span class="faint"><fmt:message key="robot.speed.unknown"/></span></c:when>
  <c:otherwise>
    <fmt:formatNumber value="${readings.actualSpeed()}" minFractionDigits="2" maxFractionDigits="2" var="speed"/>
    <fmt:message key="common.metresPerSecond"><fmt:param value="${speed}"/></fmt:message>
  </c:otherwise>
</c:choose>
