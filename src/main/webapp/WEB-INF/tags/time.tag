<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="at" required="true" type="java.time.Instant" %>
<time datetime="${at}">${at}</time>
