<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="sentence" required="true" type="org.toqa.wording.Sentence" description="what the fleet says" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:choose>
  <c:when test="${sentence.isVerbatim()}"><t:english text="${sentence.english()}"/></c:when>
  <c:otherwise><c:out value="${sentence.text(locale)}"/></c:otherwise>
</c:choose>
