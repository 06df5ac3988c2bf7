<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="text" required="true" description="a sentence that comes in English only" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<bdi lang="en" dir="ltr"><c:out value="${text}"/></bdi>
