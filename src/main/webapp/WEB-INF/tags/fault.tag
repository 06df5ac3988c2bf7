<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="fault" required="true" type="org.toqa.link.message.AgentMessage.Fault" description="told in the reader's language where its code is known, else as the robot says it" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<fmt:message key="fault.${fault.code}" var="known"/>
<c:choose><c:when test="${fn:startsWith(known, '???')}"><t:english text="${fault.text}"/></c:when><c:otherwise><c:out value="${known}"/></c:otherwise></c:choose>
