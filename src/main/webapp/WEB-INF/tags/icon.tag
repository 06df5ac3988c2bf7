<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="name" required="true" description="a symbol of assets/icons.svg" %>
<svg class="icon icon-${name}" aria-hidden="true"><use href="${pageContext.request.contextPath}/assets/icons.svg#${name}"/></svg>
