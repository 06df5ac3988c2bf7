<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="entry" required="true" type="org.toqa.web.page.TemplateView" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:if test="${entry.isDrive()}"><span class="faint"><fmt:message key="newTask.kind.drive"/>:</span>${" "}</c:if>
<c:forEach items="${entry.places()}" var="place" varStatus="at"><c:choose><c:when test="${place.parameter()}"><em><bdi><c:out value="${place.text()}"/></bdi></em></c:when><c:otherwise><bdi><c:out value="${place.text()}"/></bdi></c:otherwise></c:choose><c:if test="${not at.last}">${" "}<span aria-hidden="true" class="arrow">→</span>${" "}</c:if></c:forEach>
