<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="robot" required="true" type="org.toqa.fleet.RobotView" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<c:choose>
  <c:when test="${empty robot.telemetry.lastSeen}"><span class="faint"><fmt:message key="robot.lastSeen.never"/></span></c:when>
  <c:otherwise><time datetime="${robot.telemetry.lastSeen}" data-last-seen="${fn:escapeXml(robot.name)}">${robot.telemetry.lastSeen}</time></c:otherwise>
</c:choose>
