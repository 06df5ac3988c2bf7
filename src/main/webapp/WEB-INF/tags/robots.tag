<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="names" required="true" type="java.util.List" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:forEach items="${names}" var="name" varStatus="at"><c:if test="${not at.first}"><fmt:message key="common.comma"/></c:if><c:url value="/robots/${name}" var="link"/><a href="<c:out value="${link}"/>"><bdi><c:out value="${name}"/></bdi></a></c:forEach>
<c:if test="${empty names}"><span class="faint"><fmt:message key="common.none"/></span></c:if>
