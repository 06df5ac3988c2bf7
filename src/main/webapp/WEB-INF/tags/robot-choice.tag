<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" import="org.toqa.mission.RobotAbility" %>
<%@ attribute name="name" required="true" description="of the field" %>
<%@ attribute name="chosen" required="true" type="java.util.List" description="names and abilities" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:forEach items="${RobotAbility.values()}" var="ability"><label><input type="checkbox" name="${fn:escapeXml(name)}" value="${ability.word()}" ${chosen.contains(ability.word()) ? 'checked' : ''}> <t:said sentence="${ability.robots()}"/></label></c:forEach>
<c:forEach items="${robots}" var="robot"><label><input type="checkbox" name="${fn:escapeXml(name)}" value="${fn:escapeXml(robot)}" ${chosen.contains(robot) ? 'checked' : ''}> <bdi><c:out value="${robot}"/></bdi></label></c:forEach>
<c:forEach items="${chosen}" var="given"><c:if test="${not robots.contains(given) and RobotAbility.of(given).isEmpty()}"><label><input type="checkbox" name="${fn:escapeXml(name)}" value="${fn:escapeXml(given)}" checked> <bdi><c:out value="${given}"/></bdi></label></c:if></c:forEach>
