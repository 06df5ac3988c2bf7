<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:if test="${not empty errors}">
  <p class="notice bad" role="alert"><c:choose><c:when test="${not empty errors.form}"><c:out value="${errors.form}"/></c:when><c:otherwise><fmt:message key="error.form"/></c:otherwise></c:choose></p>
</c:if>
