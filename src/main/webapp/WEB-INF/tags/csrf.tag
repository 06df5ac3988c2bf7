<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<input type="hidden" name="_csrf" value="${csrf}">
