<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="of" required="true" description="task or robot" %>
<%@ attribute name="state" required="true" %>
<%@ attribute name="drive" type="java.lang.Boolean" description="a task without a load" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<span class="state" data-state="${state}"><fmt:message key="${of}.state.${drive and state == 'TO_OBJECT' ? 'drive' : state}"/></span>
