<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="route" required="true" type="org.toqa.link.message.AgentMessage.NetworkRoute" %>
<%@ attribute name="relays" required="true" type="java.util.List" description="names of the robots that forward, the nearest first" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<fmt:formatNumber value="${route.quality()}" type="percent" var="quality"/>
<c:choose>
  <c:when test="${empty relays}"><fmt:message key="robot.networkRoute.direct"/></c:when>
  <c:otherwise><fmt:message key="robot.networkRoute.through"/>${" "}<c:forEach items="${relays}" var="relay" varStatus="at">${at.first ? '' : ' → '}<bdi><c:out value="${relay}"/></bdi></c:forEach></c:otherwise>
</c:choose>
${" · "}<fmt:message key="robot.networkRoute.quality"><fmt:param value="${quality}"/></fmt:message>
