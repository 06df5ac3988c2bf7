<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="chosen" required="true" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<label for="role"><fmt:message key="users.add.role"/></label>
<select id="role" name="role">
  <option value="CLERK"><fmt:message key="users.role.CLERK"/></option>
  <option value="MANAGER" ${chosen == 'MANAGER' ? 'selected' : ''}><fmt:message key="users.role.MANAGER"/></option>
</select>
