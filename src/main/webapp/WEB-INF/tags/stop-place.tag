<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="stop" required="true" type="org.toqa.mission.Stop" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:choose>
  <c:when test="${empty stop.charge()}"><t:place place="${stop.place()}"/></c:when>
  <c:when test="${empty stop.charge().charger()}"><fmt:message key="task.stop.charger.any"/></c:when>
  <c:otherwise><fmt:message key="task.stop.charger" var="charger"><fmt:param value="${stop.charge().charger()}"/></fmt:message><c:out value="${charger}"/></c:otherwise>
</c:choose>
