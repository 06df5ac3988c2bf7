<%@ tag pageEncoding="UTF-8" %>
<%@ attribute name="stop" required="true" type="org.toqa.mission.Stop" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:if test="${stop.awaitsPerson()}"><span class="faint"><fmt:message key="task.stop.person"/></span></c:if>
<c:if test="${not empty stop.waitTime()}"><fmt:message key="task.stop.time" var="waits"><fmt:param value="${stop.waitTime().toSeconds()}"/></fmt:message><span class="faint"><c:out value="${waits}"/></span></c:if>
<c:if test="${not empty stop.charge()}"><c:choose><c:when test="${not empty stop.charge().until()}"><fmt:message key="task.stop.until" var="until"><fmt:param value="${100 * stop.charge().until()}"/></fmt:message><span class="faint"><c:out value="${until}"/></span></c:when><c:otherwise><span class="faint"><fmt:message key="task.stop.charges"/></span></c:otherwise></c:choose></c:if>
