<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="topic" required="true" description="a document under docs, without .md" %>
<%@ attribute name="section" description="the anchor of a heading in it" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<a class="help" href="${pageContext.request.contextPath}/help/${topic}${empty section ? '' : '#'}${section}"><fmt:message key="help.link"/></a>
