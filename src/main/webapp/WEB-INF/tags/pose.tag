<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="pose" type="org.toqa.geometry.Pose" description="null: nobody knows where the robot is" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:choose>
  <c:when test="${empty pose}"><span class="faint"><fmt:message key="robot.position.unknown"/></span></c:when>
  <c:otherwise>
    <fmt:formatNumber value="${pose.x}" minFractionDigits="2" maxFractionDigits="2" var="x"/>
    <fmt:formatNumber value="${pose.y}" minFractionDigits="2" maxFractionDigits="2" var="y"/>
    <fmt:formatNumber value="${(Math.round(pose.theta * 57.29577951308232) + 360) % 360}" maxFractionDigits="0" var="heading"/>
    <span data-live-pose><fmt:message key="common.position"><fmt:param value="${x}"/><fmt:param value="${y}"/></fmt:message><fmt:message key="common.comma"/><fmt:message key="robot.heading.degrees"><fmt:param value="${heading}"/></fmt:message></span>
  </c:otherwise>
</c:choose>
