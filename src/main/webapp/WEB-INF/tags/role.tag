<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="chosen" required="true" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<label for="role"><fmt:message key="users.add.role"/></label>
<select id="role" name="role" ${empty errors.role ? '' : 'aria-invalid="true" aria-describedby="role-help"'}>
  <c:forTokens items="VIEWER,CLERK,OPERATOR,MANAGER" delims="," var="role"><option value="${role}" ${(empty chosen ? 'CLERK' : chosen) == role ? 'selected' : ''}><fmt:message key="users.role.${role}"/>: <fmt:message key="users.powers.${role}"/></option></c:forTokens>
  <c:if test="${caller.mayMakeAdministrators()}"><option value="ADMINISTRATOR" ${chosen == 'ADMINISTRATOR' ? 'selected' : ''}><fmt:message key="users.role.ADMINISTRATOR"/></option></c:if>
</select>
<c:if test="${not empty errors.role}"><small id="role-help" class="wrong"><bdi><c:out value="${errors.role}"/></bdi></small></c:if>
