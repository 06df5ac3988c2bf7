<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="verdict" required="true" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<span class="verdict" data-verdict="${verdict}"><fmt:message key="laboratory.verdict.${verdict}"/></span>
