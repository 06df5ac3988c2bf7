<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" import="org.toqa.mission.RobotAbility" %>
<%@ attribute name="names" required="true" type="java.util.List" description="of robots, and what others can do" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:forEach items="${names}" var="name" varStatus="at"><c:if test="${not at.first}"><fmt:message key="common.comma"/></c:if><c:choose><c:when test="${RobotAbility.of(name).isPresent()}"><t:said sentence="${RobotAbility.sentence(name)}"/></c:when><c:otherwise><c:url value="/robots/${name}" var="link"/><a href="<c:out value="${link}"/>"><bdi><c:out value="${name}"/></bdi></a></c:otherwise></c:choose></c:forEach>
<c:if test="${empty names}"><span class="faint"><fmt:message key="common.none"/></span></c:if>
