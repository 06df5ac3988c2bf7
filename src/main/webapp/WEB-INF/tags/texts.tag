<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="keys" required="true" description="of the texts that the page's scripts show" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<template id="texts">
  <c:forTokens items="${keys}" delims=" " var="key"><data value="${key}"><fmt:message key="${key}"/></data></c:forTokens>
</template>
